/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surfaces out of the files of a directory. */
#include "scene_directory.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* Makes the files, which '|' separates: a folder ends in '/'; behind '=' stands what a file is: U it says units, D the
 * same in JSON, N units above numbers, T words. */
static void lay_out(const struct directory *directory, const char *files)
{
    static const char units[] = "x unit: mm\nz unit: nm\n", json[] = "{\"X1_FACTOR\": 0.001, \"Y1_FACTOR\": 1e-9}",
                      numbers[] = "x unit: mm\nz unit: nm\n0 1\n1 2\n2 1\n";
    OWNED(memory_free) char *all = strdup(files);
    char *rest = all;
    for (char *name; (name = strsep(&rest, "|"));) {
        char *kind = strchr(name, '=');
        if (kind)
            *kind++ = '\0';
        if (*name == '\0')
            continue;
        if (name[strlen(name) - 1] == '/')
            assert_int_equal(mkdir(directory_path(directory, name), 0777), 0);
        else
            directory_write(directory, name,
                            !kind          ? "0 1\n"
                            : *kind == 'U' ? units
                            : *kind == 'D' ? json
                            : *kind == 'T' ? "words\n"
                                           : numbers);
    }
}

/* Each surface's name and files, behind one another. */
static void assert_surfaces(const struct scene *scene, const char *expected)
{
    struct text *text = support_text();
    for (size_t i = 0; i < scene->surface_count; i++) {
        text_add(text, "%s%s:", i > 0 ? "|" : "", scene->surfaces[i].name);
        for (size_t k = 0; k < scene->surfaces[i].files.count; k++)
            text_add(text, " %s", scene->surfaces[i].files.path[k]);
    }
    assert_string_equal(text_string(text), expected);
}

#define TEXTS(count) "passed over, no scan" count " x text without a row of numbers "

static const struct {
    const char *files, *scene, *surfaces, *passed_over; /* NULL: none */
} listings[] = {
    {"", NULL, "", NULL},
    /* natural order */
    {"s10.csv|s2.csv|s1.csv|s02.csv|s2b10.csv|s2b9.csv|S3.csv|s18446744073709551617.csv|t.csv|10.csv|9.csv|"
     "s18446744073709551616.csv",
     NULL,
     "9: 9.csv|10: 10.csv|S3: S3.csv|s02: s02.csv|s1: s1.csv|s2: s2.csv|s2b9: s2b9.csv|s2b10: s2b10.csv|s10: s10.csv|"
     "s18446744073709551616: s18446744073709551616.csv|s18446744073709551617: s18446744073709551617.csv|t: t.csv",
     NULL},
    /* those of one stem keep their endings */
    {"a.csv|a.txt|b.csv|c|c.x|c.x.y|d.|e.tar.gz", NULL,
     "a.csv: a.csv|a.txt: a.txt|b: b.csv|c: c|c.x: c.x|c.x.y: c.x.y|d: d.|e.tar: e.tar.gz", NULL},
    /* hostile names */
    {"a b.csv|\n.csv|\xff\xfe.csv|$(x).csv|scene.yaml.bak|-o.csv", NULL,
     "\n: \n.csv|$(x): $(x).csv|-o: -o.csv|a b: a b.csv|scene.yaml: scene.yaml.bak|\xff\xfe: \xff\xfe.csv", NULL},
    /* a sub-directory is a surface of its files; one without any, a report and a hidden one are none */
    {"b/|a/|.hidden/|empty/|report/|deep/|deep/er/|only/|b/run-10.csv|b/run-2.csv|b/.x.csv|a/x.csv|b.csv|.hidden/x|"
     "report/x|report/results.json|deep/er/x|only/ref.csv|b/run-2.txt=U",
     "counterface: {surface: only/ref.csv}\n", "a: a/x.csv|b: b/run-2.csv b/run-10.csv|b.csv: b.csv", NULL},
    /* patterns */
    {"r/|run-3.csv/|run-10.csv|run-9.csv|run-x.txt|r/run-1.csv|[1].csv|.run-1.csv",
     "surfaces:\n  - {name: a, file: \"run-*.csv\"}\n  - {name: b, file: [\"[1].csv\", \"r/*-?.c[st]v\"]}\n",
     "a: run-9.csv run-10.csv|b: [1].csv r/run-1.csv", NULL},
    /* files that only say units are no surfaces; what else is no scan is passed over; with numbers they are surfaces */
    {"a.dat|b.csv|c.csv|g.csv|a.txt=D|a.hdr=U|b.csv.json=D|c.txt=N|d.txt=U|g.txt=U|h.txt=T|i.txt=T",
     "counterface: {surface: g.csv}\n", "a: a.dat|b: b.csv|c.csv: c.csv|c.txt: c.txt", TEXTS("s: 2") "(h.txt, i.txt)"},
    {"s/|s/b.csv|s/a.txt=T|s/b.csv.hdr=U|s/b.txt=U", NULL, "s: s/b.csv", TEXTS(": 1") "(s/a.txt)"},
};

TEST_CASE(test_listings)
{
    for (size_t i = 0; i < COUNT(listings); i++) {
        struct directory directory = directory_make();
        lay_out(&directory, listings[i].files);
        if (listings[i].scene)
            directory_write(&directory, "scene.yaml", listings[i].scene);
        struct scene *scene = scene_directory_read(directory.path, NULL);
        assert_surfaces(scene, listings[i].surfaces);
        assert_string_equal(scene->passed_over ? scene->passed_over : "",
                            listings[i].passed_over ? listings[i].passed_over : "");
        directory_remove(&directory);
    }
}

TEST_IN_DIRECTORY(test_patterns_of_nothing)
{
    static const char *const bad[][2] = {
        {"surfaces:\n  - {file: a}\n  - {file: \"x*.csv\"}\n", "scene.yaml:2: cannot find 'a'"},
        {"surfaces:\n  - {file: \"run-*.csv\"}\n  - {name: b,\n     file: \"x*.csv\"}\n",
         "scene.yaml:4: 'x*.csv' matches no file; paths start at the scene's directory"},
        {"surfaces:\n  - {file: \"nowhere/*\"}\n", "scene.yaml:2: cannot list '"},
        {"surfaces:\n  - {file: \"r*/run-1.csv\"}\n", "scene.yaml:2: cannot list '"}};
    lay_out(place, "run-1.csv|r/|r/run-1.csv");
    for (size_t i = 0; i < COUNT(bad); i++) {
        directory_write(place, "scene.yaml", bad[i][0]);
        scene_directory_refused(place->path, NULL, STATUS_SCENE, bad[i][1]);
    }
}

TEST_IN_DIRECTORY(test_what_is_no_scan)
{
    lay_out(place, "scan.csv|.hidden.csv|folder.csv/");
    directory_write(place, "scene.yaml", "{}");
    assert_int_equal(mkfifo(directory_path(place, "pipe.csv"), 0600), 0);
    assert_int_equal(symlink("nowhere", directory_path(place, "dangling.csv")), 0);
    assert_int_equal(symlink(directory_path(place, ".hidden.csv"), directory_path(place, "link.csv")), 0);
    struct scene *scene = scene_directory_read(place->path, NULL); /* a link to a file is as good as the file */
    assert_surfaces(scene, "link: link.csv|scan: scan.csv");
}

/* The counterface's scan and the measurements are no surfaces, however their paths are spelt; units given for all
 * surfaces are the counterface's too. */
TEST_IN_DIRECTORY(test_files_spoken_for)
{
    static const char *const spellings[] = {"", "./", ".//./"};
    const struct scene_overrides units = {.x_unit = "mm", .z_unit = "um"};
    lay_out(place, "a.csv|b.csv|m.csv");
    for (size_t i = 0; i < COUNT(spellings); i++) {
        directory_write(
            place, "scene.yaml",
            filled("counterface: {surface: %sb.csv}\nmeasured: {file: %sm.csv}\n", spellings[i], spellings[i]));
        struct scene *scene = scene_directory_read(place->path, &units);
        assert_surfaces(scene, "a: a.csv");
        assert_string_equal(scene->counterface_surface.x_unit, "mm");
        assert_string_equal(scene->counterface_surface.z_unit, "um");
    }
}

TEST_CASE(test_columns)
{
    static const char text[] = "counterface: {surface: b.csv, column: [2, 1]}\n"
                               "surfaces:\n  - {name: p, file: a.csv}\n"
                               "  - {name: q, file: a.csv, column: 3}\n"
                               "  - {name: r, file: a.csv, column: [1, 4]}\n";
    struct scene *scene = scene_of(text);
    const struct scene_surface *surface[] = {&scene->surfaces[0], &scene->surfaces[1], &scene->surfaces[2],
                                             &scene->counterface_surface};
    static const struct {
        size_t x, z;
    } expected[] = {{0, 0}, {0, 3}, {1, 4}, {2, 1}};
    for (size_t i = 0; i < COUNT(expected); i++) {
        assert_int_equal(surface[i]->x_column, expected[i].x);
        assert_int_equal(surface[i]->z_column, expected[i].z);
    }
}

TEST_IN_DIRECTORY(test_many_files)
{
    enum { MANY = 1000 };
    for (int i = MANY; i > 0; i--) {
        scene_directory_add(place, filled("%d.csv", i));
    }
    struct scene *scene = scene_directory_read(place->path, NULL);
    assert_int_equal(scene->surface_count, MANY);
    for (int i = 0; i < MANY; i++)
        assert_int_equal(atoi(scene->surfaces[i].name), i + 1);
}

TEST_CASE(test_no_directory)
{
    static const char *const paths[][2] = {
        {"/nowhere/at/all", "cannot open directory '/nowhere/at/all': No such file or directory"},
        {"", "cannot open directory '': No such file or directory"},
        {TEST_DATA "/scene/bare/left.csv",
         "'" TEST_DATA "/scene/bare/left.csv' is no directory; name the one that holds the scans"}};
    for (size_t i = 0; i < COUNT(paths); i++)
        scene_directory_refused(paths[i][0], NULL, STATUS_IO, paths[i][1]);
}
