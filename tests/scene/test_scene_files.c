/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/scene_files.h"
#include "scene_directory.h"

static void check_names(const char *const *files, size_t count, const char *const (*expected)[2], size_t surfaces)
{
    struct scene_directory directory = scene_directory_make();
    for (size_t i = 0; i < count; i++)
        scene_directory_add(&directory, files[i]);
    struct scene scene = scene_directory_read(directory.path, NULL);
    assert_int_equal(scene.surface_count, surfaces);
    for (size_t i = 0; i < surfaces; i++) {
        assert_string_equal(scene.surfaces[i].name, expected[i][0]);
        assert_int_equal(scene.surfaces[i].file_count, 1);
        assert_string_equal(scene.surfaces[i].files[0], expected[i][1]);
        assert_string_equal(scene.surfaces[i].x_unit, "");
    }
    scene_free(&scene);
    scene_directory_remove(&directory);
}

#define COUNT(array)                 (sizeof(array) / sizeof *(array))
#define CHECK_NAMES(files, surfaces) check_names(files, COUNT(files), surfaces, COUNT(surfaces))

TEST_CASE(test_natural_order)
{
    static const char *const files[] = {"s10.csv",   "s2.csv",   "s1.csv", "s02.csv",
                                        "s2b10.csv", "s2b9.csv", "S3.csv", "s18446744073709551617.csv",
                                        "t.csv",     "10.csv",   "9.csv",  "s18446744073709551616.csv"};
    static const char *const expected[][2] = {{"9", "9.csv"},
                                              {"10", "10.csv"},
                                              {"S3", "S3.csv"},
                                              {"s1", "s1.csv"},
                                              {"s02", "s02.csv"},
                                              {"s2", "s2.csv"},
                                              {"s2b9", "s2b9.csv"},
                                              {"s2b10", "s2b10.csv"},
                                              {"s10", "s10.csv"},
                                              {"s18446744073709551616", "s18446744073709551616.csv"},
                                              {"s18446744073709551617", "s18446744073709551617.csv"},
                                              {"t", "t.csv"}};
    CHECK_NAMES(files, expected);
}

TEST_CASE(test_same_stems_keep_their_endings)
{
    static const char *const files[] = {"a.csv", "a.txt", "b.csv", "c", "c.x", "c.x.y", "d.", "e.tar.gz"};
    static const char *const expected[][2] = {{"a.csv", "a.csv"}, {"a.txt", "a.txt"},   {"b", "b.csv"},
                                              {"c", "c"},         {"c.x", "c.x"},       {"c.x.y", "c.x.y"},
                                              {"d", "d."},        {"e.tar", "e.tar.gz"}};
    CHECK_NAMES(files, expected);
}

TEST_CASE(test_hostile_names)
{
    static const char *const files[] = {"a b.csv", "\n.csv", "\xff\xfe.csv", "$(x).csv", "scene.yaml.bak", "-o.csv"};
    static const char *const expected[][2] = {{"\n", "\n.csv"},
                                              {"$(x)", "$(x).csv"},
                                              {"-o", "-o.csv"},
                                              {"a b", "a b.csv"},
                                              {"scene.yaml", "scene.yaml.bak"},
                                              {"\xff\xfe", "\xff\xfe.csv"}};
    CHECK_NAMES(files, expected);
}

TEST_CASE(test_what_is_no_scan)
{
    struct scene_directory directory = scene_directory_make();
    char path[512], target[512];
    scene_directory_add(&directory, "scan.csv");
    scene_directory_add(&directory, ".hidden.csv");
    scene_directory_write(&directory, "scene.yaml", "{}", 2);
    snprintf(path, sizeof path, "%s/folder.csv", directory.path);
    assert_int_equal(mkdir(path, 0700), 0);
    snprintf(path, sizeof path, "%s/pipe.csv", directory.path);
    assert_int_equal(mkfifo(path, 0600), 0);
    snprintf(path, sizeof path, "%s/dangling.csv", directory.path);
    assert_int_equal(symlink("nowhere", path), 0);
    snprintf(path, sizeof path, "%s/link.csv", directory.path);
    snprintf(target, sizeof target, "%s/.hidden.csv", directory.path);
    assert_int_equal(symlink(target, path), 0); /* a link to a file is as good as the file */

    struct scene scene = scene_directory_read(directory.path, NULL);
    assert_int_equal(scene.surface_count, 2);
    assert_string_equal(scene.surfaces[0].name, "link");
    assert_string_equal(scene.surfaces[1].name, "scan");
    scene_free(&scene);
    scene_directory_remove(&directory);
}

TEST_CASE(test_empty_directory)
{
    struct scene_directory directory = scene_directory_make();
    struct scene scene = scene_directory_read(directory.path, NULL);
    assert_int_equal(scene.surface_count, 0);
    scene_free(&scene);
    scene_directory_remove(&directory);
}

/* The counterface's scan and the measurements are no surfaces, however their paths are spelt; units given for all
 * surfaces are the counterface's too. */
TEST_CASE(test_files_spoken_for)
{
    static const char *const spellings[] = {"", "./", ".//./"};
    const struct scene_overrides units = {.x_unit = "mm", .z_unit = "um"};
    struct scene_directory directory = scene_directory_make();
    scene_directory_add(&directory, "a.csv");
    scene_directory_add(&directory, "b.csv");
    scene_directory_add(&directory, "m.csv");
    for (size_t i = 0; i < COUNT(spellings); i++) {
        char text[256];
        int length = snprintf(text, sizeof text, "counterface: {surface: %sb.csv}\nmeasured: {file: %sm.csv}\n",
                              spellings[i], spellings[i]);
        scene_directory_write(&directory, "scene.yaml", text, (size_t)length);
        struct scene scene = scene_directory_read(directory.path, &units);
        assert_int_equal(scene.surface_count, 1);
        assert_string_equal(scene.surfaces[0].name, "a");
        assert_string_equal(scene.counterface_surface.x_unit, "mm");
        assert_string_equal(scene.counterface_surface.z_unit, "um");
        scene_free(&scene);
    }
    scene_directory_remove(&directory);
}

/* Files that only say units of a scan beside them are no surfaces; alone they are passed over, with numbers in them
 * they are surfaces. */
/* In a folder, too: of names with an ending and without, among others that begin alike. */
TEST_CASE(test_sidecars_in_a_folder)
{
    static const char *const scans[] = {"s/a", "s/a-1.csv", "s/a.csv", "s/b.csv", "s/b.c.csv", "s/ab.csv"};
    static const char *const sidecars[] = {"s/a.txt", "s/b.csv.hdr", "s/b.txt"};
    static const char text[] = "x unit: mm\nz unit: um\n";
    for (size_t lone = 0; lone < COUNT(scans); lone++) { /* in turn one scan alone is there */
        struct scene_directory directory = scene_directory_make();
        static const bool beside[COUNT(scans)][COUNT(sidecars)] = {{true}, {false}, {true}, {false, true, true}};
        char folder[512];
        snprintf(folder, sizeof folder, "%s/s", directory.path);
        assert_int_equal(mkdir(folder, 0777), 0);
        scene_directory_add(&directory, scans[lone]);
        size_t expected = 1;
        for (size_t k = 0; k < COUNT(sidecars); k++) {
            scene_directory_write(&directory, sidecars[k], text, sizeof text - 1);
            expected += beside[lone][k] ? 0 : 1;
        }
        struct scene_surface surface = {.name = NULL};
        struct scene scene = {.directory = directory.path};
        struct status status = {0};
        assert_int_equal(scene_files_match(&surface, &scene, "s/*", S_IFREG, &status), STATUS_OK);
        if (surface.file_count != expected)
            fail_msg("%zu files with %s, not %zu", surface.file_count, scans[lone], expected);
        for (size_t i = 0; i < surface.file_count; i++)
            free(surface.files[i]);
        free(surface.files);
        scene_directory_remove(&directory);
    }
}

TEST_CASE(test_sidecars)
{
    static const char units[] = "x unit: mm\nz unit: nm\n", dabam[] = "{\"X1_FACTOR\": 0.001, \"Y1_FACTOR\": 1e-9}",
                      unfit[] = "x unit: mm\nz unit: nm\n0 1\n1 2\n2 1\n";
    static const char *const surfaces[] = {"a", "b", "c.csv", "c.txt"};
    struct scene_directory directory = scene_directory_make();
    static const char *const scans[] = {"a.dat", "b.csv", "c.csv", "d.1.csv", "g.csv"};
    for (size_t i = 0; i < COUNT(scans); i++)
        scene_directory_add(&directory, scans[i]);
    scene_directory_write(&directory, "a.txt", dabam, strlen(dabam));
    scene_directory_write(&directory, "a.hdr", units, strlen(units));
    scene_directory_write(&directory, "b.csv.json", dabam, strlen(dabam));
    scene_directory_write(&directory, "c.txt", unfit, strlen(unfit));
    scene_directory_write(&directory, "d.txt", units, strlen(units)); /* of d, not of d.1 */
    scene_directory_write(&directory, "e.txt", units, strlen(units));
    scene_directory_write(&directory, "f.json", dabam, strlen(dabam)); /* two sidecars make no scan */
    scene_directory_write(&directory, "f.txt", units, strlen(units));
    scene_directory_write(&directory, "g.txt", units, strlen(units));
    scene_directory_write(&directory, "scene.yaml", "counterface: {surface: g.csv}\n", 30);
    struct scene scene = scene_directory_read(directory.path, NULL);
    size_t found = 0;
    for (size_t i = 0; i < scene.surface_count; i++) {
        if (strcmp(scene.surfaces[i].name, "d.1") == 0)
            continue;
        assert_true(found < COUNT(surfaces));
        assert_string_equal(scene.surfaces[i].name, surfaces[found++]);
    }
    assert_int_equal(found, COUNT(surfaces));
    assert_int_equal(scene.surface_count, COUNT(surfaces) + 1);
    assert_string_equal(scene.passed_over,
                        "passed over, no scans: 4 x text without a row of numbers (d.txt, e.txt, f.json, f.txt)");
    scene_free(&scene);
    scene_directory_remove(&directory);
}

TEST_CASE(test_columns_and_quantity)
{
    static const char text[] = "counterface: {surface: b.csv, quantity: slope, column: [t, Slope (urad)]}\n"
                               "surfaces:\n  - {name: p, file: a.csv}\n"
                               "  - {name: q, file: a.csv, quantity: slope, column: 3}\n"
                               "  - {name: r, file: a.csv, quantity: height, column: [1, 4]}\n";
    struct scene scene = scene_of(text);
    const struct scene_surface *surface[] = {&scene.surfaces[0], &scene.surfaces[1], &scene.surfaces[2],
                                             &scene.counterface_surface};
    static const struct {
        enum scan_quantity quantity;
        const char *x, *z;
    } expected[] = {
        {SCAN_HEIGHT, NULL, NULL}, {SCAN_SLOPE, NULL, "3"}, {SCAN_HEIGHT, "1", "4"}, {SCAN_SLOPE, "t", "Slope (urad)"}};
    for (size_t i = 0; i < COUNT(expected); i++) {
        assert_int_equal(surface[i]->quantity, expected[i].quantity);
        assert_string_equal(surface[i]->x_column ? surface[i]->x_column : "-", expected[i].x ? expected[i].x : "-");
        assert_string_equal(surface[i]->z_column ? surface[i]->z_column : "-", expected[i].z ? expected[i].z : "-");
    }
    scene_free(&scene);
}

TEST_CASE(test_many_files)
{
    struct scene_directory directory = scene_directory_make();
    enum { MANY = 1000 };
    char name[32];
    for (int i = MANY; i > 0; i--) {
        snprintf(name, sizeof name, "%d.csv", i);
        scene_directory_add(&directory, name);
    }
    struct scene scene = scene_directory_read(directory.path, NULL);
    assert_int_equal(scene.surface_count, MANY);
    for (int i = 0; i < MANY; i++)
        assert_int_equal(atoi(scene.surfaces[i].name), i + 1);
    scene_free(&scene);
    scene_directory_remove(&directory);
}

static void make_folder(const struct scene_directory *directory, const char *name)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s", directory->path, name);
    assert_int_equal(mkdir(path, 0777), 0);
}

static void assert_files(const struct scene_surface *surface, const char *name, const char *const *files, size_t count)
{
    assert_string_equal(surface->name, name);
    assert_int_equal(surface->file_count, count);
    for (size_t i = 0; i < count; i++)
        assert_string_equal(surface->files[i], files[i]);
}

/* A sub-directory is a surface of its files; one without any, a report and a hidden one are none. */
TEST_CASE(test_sub_directories)
{
    struct scene_directory directory = scene_directory_make();
    static const char *const folders[] = {"b", "a", ".hidden", "empty", "report", "deep", "deep/er", "only"};
    static const char *const files[] = {"b/run-10.csv", "b/run-2.csv", "b/.x.csv", "a/x.csv",
                                        "b.csv",        ".hidden/x",   "report/x", "report/results.json",
                                        "deep/er/x",    "only/ref.csv"};
    static const char *const b[] = {"b/run-2.csv", "b/run-10.csv"}, *const a[] = {"a/x.csv"},
                             *const alone[] = {"b.csv"};
    for (size_t i = 0; i < COUNT(folders); i++)
        make_folder(&directory, folders[i]);
    for (size_t i = 0; i < COUNT(files); i++)
        scene_directory_add(&directory, files[i]);
    static const char text[] = "counterface: {surface: only/ref.csv}\n", sidecar[] = "x unit: mm\nz unit: um\n";
    scene_directory_says(&directory, text);
    scene_directory_write(&directory, "b/run-2.txt", sidecar, strlen(sidecar));
    struct scene scene = scene_directory_read(directory.path, NULL);
    assert_int_equal(scene.surface_count, 3);
    assert_files(&scene.surfaces[0], "a", a, 1);
    assert_files(&scene.surfaces[1], "b", b, 2);
    assert_files(&scene.surfaces[2], "b.csv", alone, 1);
    scene_free(&scene);
    scene_directory_remove(&directory);
}

TEST_CASE(test_patterns)
{
    struct scene_directory directory = scene_directory_make();
    static const char *const files[] = {"run-10.csv", "run-9.csv", "run-x.txt", "r/run-1.csv", "[1].csv", ".run-1.csv"};
    static const char *const runs[] = {"run-9.csv", "run-10.csv"}, *const both[] = {"[1].csv", "r/run-1.csv"};
    make_folder(&directory, "r");
    make_folder(&directory, "run-3.csv");
    for (size_t i = 0; i < COUNT(files); i++)
        scene_directory_add(&directory, files[i]);
    static const char good[] = "surfaces:\n  - {name: a, file: \"run-*.csv\"}\n  - {name: b, file: [\"[1].csv\", "
                               "\"r/*-?.c[st]v\"]}\n";
    scene_directory_says(&directory, good);
    struct scene scene = scene_directory_read(directory.path, NULL);
    assert_files(&scene.surfaces[0], "a", runs, 2);
    assert_files(&scene.surfaces[1], "b", both, 2);
    scene_free(&scene);
    static const char *const bad[][2] = {
        {"surfaces:\n  - {file: a}\n  - {file: \"x*.csv\"}\n", "scene.yaml:2: cannot find surface file 'a'"},
        {"surfaces:\n  - {file: \"run-*.csv\"}\n  - {name: b,\n     file: \"x*.csv\"}\n",
         "scene.yaml:4: 'x*.csv' matches no file; paths start at the scene's directory"},
        {"surfaces:\n  - {file: \"nowhere/*\"}\n", "scene.yaml:2: cannot list '"},
        {"surfaces:\n  - {file: \"r*/run-1.csv\"}\n", "scene.yaml:2: cannot list '"}};
    for (size_t i = 0; i < COUNT(bad); i++) {
        struct status status = {0};
        scene_directory_says(&directory, bad[i][0]);
        assert_int_equal(scene_read(&scene, directory.path, NULL, &status), STATUS_SCENE);
        assert_non_null(strstr(status.message, bad[i][1]));
        scene_free(&scene);
    }
    scene_directory_remove(&directory);
}

TEST_CASE(test_no_directory)
{
    static const char *const paths[][2] = {
        {"/nowhere/at/all", "cannot open directory '/nowhere/at/all': No such file or directory"},
        {"", "cannot open directory '': No such file or directory"},
        {TEST_DATA "/scene/bare/left.csv",
         "'" TEST_DATA "/scene/bare/left.csv' is no directory; name the one that holds the scans"}};
    for (size_t i = 0; i < COUNT(paths); i++) {
        struct scene scene;
        struct status status = {0};
        assert_int_equal(scene_read(&scene, paths[i][0], NULL, &status), STATUS_IO);
        assert_string_equal(status.message, paths[i][1]);
        scene_free(&scene);
    }
}
