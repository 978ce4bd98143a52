/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `init`: its guesses from file names, and that the program reads the scene it writes. */
#include "cli/process.h"
#include "scene/scene.h"

/** Fails the test unless the scene of d has these surfaces: "name=file|file\n", a line each. */
static void expect_surfaces(const char *place, const char *expected)
{
    struct scene scene;
    struct text *found = support_text();
    expect_ok(scene_read, &scene, filled("%s/d", place), NULL);
    assert_non_null(scene.path);
    for (size_t i = 0; i < scene.surface_count; i++) {
        text_add(found, "%s=", scene.surfaces[i].name);
        for (size_t f = 0; f < scene.surfaces[i].files.count; f++)
            text_add(found, "%s%s", f > 0 ? "|" : "", scene.surfaces[i].files.path[f]);
        for (size_t f = 0; f < scene.surfaces[i].along.count; f++)
            text_add(found, "%s%s", f > 0 ? "|" : "/", scene.surfaces[i].along.path[f]);
        text_add(found, "\n");
    }
    assert_string_equal(text_string(found), expected);
    scene_free(&scene);
}

/** A directory d of these files, "a|b|c", and no other. */
static void make_files(const char *place, const char *files)
{
    char *rest = lasting("%s", files);
    workspace_shell(place, "rm -rf d");
    for (char *file; (file = strsep(&rest, "|"));)
        workspace_write(place, filled("d/%s", file), "x [um],z [um]\n0,1\n1,2\n2,1.5\n3,1\n");
}

TEST_IN_WORKSPACE(names_tell_surfaces)
{
    static const struct {
        const char *files, *surfaces, *written;
    } cases[] = {
        {"new-1.csv|new-2.csv|new-10.csv|worn_a.csv|worn_b.csv|worn_c.csv",
         "new=new-1.csv|new-2.csv|new-10.csv\nworn=worn_a.csv|worn_b.csv|worn_c.csv\n",
         "  # A guess: these 3 files differ in a number or letter alone, so they are repeated scans of one surface;\n"
         "  # else give each an item of its own.\n  - name: \"new\"\n    file:\n      - \"new-1.csv\"\n"},
        {"a.csv|b.csv|c-1.csv", "a=a.csv\nb=b.csv\nc-1=c-1.csv\n", "\n  - name: \"a\"\n    file: \"a.csv\"\n"},
        {"surface-1.csv|surface-2.csv|Sample 1.csv|Sample 2.csv",
         "Sample 1=Sample 1.csv\nSample 2=Sample 2.csv\nsurface-1=surface-1.csv\nsurface-2=surface-2.csv\n",
         "surfaces:"},
        {"1.csv|2.csv|p-x.csv|px.csv|py.csv|ra-0.5.csv|ra-0.7.csv",
         "1=1.csv\n2=2.csv\np-x=p-x.csv\npx=px.csv\npy=py.csv\nra-0.5=ra-0.5.csv\nra-0.7=ra-0.7.csv\n", "surfaces:"},
        {"s.csv|s (1).csv|s (2).csv|t1.csv|t2.csv", "s=s (1).csv|s (2).csv|s.csv\nt=t1.csv|t2.csv\n",
         "    file:\n      - \"s (1).csv\"\n      - \"s (2).csv\"\n      - \"s.csv\"\n"},
        {"a-1.csv|a-2.csv|a-1.txt|a-2.txt", "a-1.csv=a-1.csv|a-2.csv\na-1.txt=a-1.txt|a-2.txt\n", "\"a-2.txt\""},
        {"worn/k.csv|worn/l.csv|worn-1.csv|one/k.csv", "one=one/k.csv\nworn=worn/k.csv|worn/l.csv\nworn-1=worn-1.csv\n",
         "  # A guess: the 2 files of a directory are repeated scans of one surface.\n  - name: \"worn\"\n    file:\n"
         "      - \"worn/k.csv\"\n"},
        {"h/*|h/b.csv", "h=h/*|h/b.csv\n", "      - \"h/*\"\n"},
        {"w*-1.csv|w*-2.csv|wi-1.csv", "w*=w*-1.csv|w*-2.csv\nwi-1=wi-1.csv\n", "      - \"w*-2.csv\"\n"},
        {"it's \"a: #1\" {x}, [y].csv|- &b *c.csv",
         "- &b *c=- &b *c.csv\nit's \"a: #1\" {x}, [y]=it's \"a: #1\" {x}, [y].csv\n",
         "    file: \"it's \\\"a: #1\\\" {x}, [y].csv\"\n"},
        {"\u202e\u00e9.csv", "\\u202e\u00e9=\u202e\u00e9.csv\n", "    file: \"\\u202e\u00e9.csv\"\n"},
        {"p-x.csv|p-y.csv", "p=p-x.csv/p-y.csv\n",
         "  # A guess: the names tell two directions of one surface. Which of them runs across the lay, their slopes "
         "say.\n"
         "  - name: \"p\"\n    file: \"p-x.csv\"\n    along:\n      - \"p-y.csv\"\n"},
        {"a_Across-1.csv|a_Across-2.csv|a_along-1.csv|b 0.csv|b 90.csv|c-0.csv|c-45.csv|c-90.csv",
         "a=a_Across-1.csv|a_Across-2.csv/a_along-1.csv\nb=b 0.csv/b 90.csv\nc=c-0.csv|c-45.csv|c-90.csv\n", "along:"},
        {"f-l.csv|f-q.csv|g-perp/1.csv|g-perp/2.csv|g-par/"
         "1.csv|h-l.csv|h-m.csv|h-q.csv|r_90_1.csv|r_90_2.csv|r_0_1.csv",
         "f=f-q.csv/f-l.csv\ng=g-perp/1.csv|g-perp/2.csv/g-par/1.csv\nh=h-l.csv|h-m.csv|h-q.csv\n"
         "r=r_0_1.csv/r_90_1.csv|r_90_2.csv\n",
         "along:"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        make_files(place, cases[i].files);
        run_to_exit(place, 0, "init", "d");
        expect_surfaces(place, cases[i].surfaces);
        expect_in_file(place, "d/scene.yaml", cases[i].written);
    }
    make_files(place, "a\n: #.csv|\xff\x1b/b.csv|d.csv");
    run_to_exit(place, 0, "init", "d");
    expect_surfaces(place, "d=d.csv\n");
    expect_in_file(place, "d/scene.yaml", "\n# Left out, as a scene cannot name its files; rename them: a\\x0a: #\n",
                   "rename them: \\xff\\x1b\n");
}

TEST_IN_WORKSPACE(what_is_to_be_filled_in)
{
    workspace_scan(place, "d/a.csv", 200, 1);
    workspace_shell(place, "tail -n +2 d/a.csv > d/both.csv; (echo 'x [um],z'; cat d/both.csv) > d/z.csv");
    workspace_write(place, "d/short.csv", "x [um],z [um]\n0,1\n");
    workspace_write(place, "d/test.csv", "force [N],z [um]\n0,1\n1,2\n2,1\n");
    workspace_write(place, "d/picture.png", "\x89PNG\r\n\x1a\n");
    struct process before = expect_exit(place, 1, "report", "d", "--brief", "--no-cost");
    run_to_exit(place, 0, "init", "d");
    struct process after = expect_exit(place, 1, "report", "d", "--brief", "--no-cost");
    expect_part(before.err, after.err); /* but for the picture, which is passed over last or first */
    expect_in_file(place, "d/scene.yaml", "\n# passed over, no scan: 1 x PNG picture (picture.png)\n",
                   "file: \"both.csv\"\n    # x_unit: mm ", "\n    # z_unit: um ",
                   "file: \"short.csv\"\n    # A scan is refused as it stands: ",
                   "test.csv\"\n    # A scan is refused as it stands: d/test.csv: x in 'N' is no scan",
                   "file: \"z.csv\"\n    # z_unit: um ");
    /* with every line in force it is a scene, too */
    workspace_shell(place, "sed -i -E 's/^( *)# ([a-z_]+:)/\\1\\2/' d/scene.yaml");
    expect_in_file(place, "d/scene.yaml", "\nmaterial: ", "\ncounterface: ", "\nnominal_area: ", "\nshape: ",
                   "\nload: ", "\noperating_load: ", "\ntargets: ", "\n    x_unit: mm ", "\n    z_unit: um ");
    json_t *plan = process_json(expect_exit(place, 1, "plan", "d", "--json")), *surface;
    size_t i;
    json_array_foreach (json_object_get(plan, "surfaces"), i, surface)
        assert_int_equal(json_is_null(json_object_get(surface, "refused")), i != 2 && i != 3); /* short.csv, test.csv */
    assert_int_equal(json_integer_value(json_object_get(plan, "targets")), 3);
    assert_true(json_is_true(json_object_get(plan, "material_known")));
}

/* Scans that can be read but not used: flat ones, and those with too many gaps. */
TEST_IN_WORKSPACE(what_is_refused)
{
    workspace_scan(place, "d/a.csv", 200, 1);
    workspace_shell(place, "cd d && awk -F, 'NR > 1 { $2 = 1 } 1' OFS=, a.csv > flat.csv && "
                           "awk -F, 'NR > 50 && NR < 90 { $2 = \"NaN\" } 1' OFS=, a.csv > gaps.csv && "
                           "cp a.csv w-1.csv && cp flat.csv w-2.csv && cp a.csv u-1.csv && tail -n +2 a.csv > u-2.csv");
    run_to_exit(place, 0, "init", "d");
    static const char refused[] = "    # A scan is refused as it stands: d/";
    expect_in_file(place, "d/scene.yaml", filled("file: \"flat.csv\"\n%sflat.csv: the scan is flat", refused),
                   filled("file: \"gaps.csv\"\n%sgaps.csv: 39 of 200 heights are missing", refused),
                   filled("- \"w-2.csv\"\n%sw-2.csv: the scan is flat", refused), "- \"u-2.csv\"\n    # x_unit: ");
    expect_not_in_file(place, "d/scene.yaml", filled("%sa.csv", refused));
}

/* Two sub-directories are proposed as the sides of a joint only where their names say so. Every key that init proposes
 * makes a valid scene together with a material and an area. */
TEST_IN_WORKSPACE(each_proposal_is_a_scene)
{
    make_files(place, "left/1.csv|right/2.csv|pin-1.csv|socket-2.csv");
    run_to_exit(place, 0, "init", "d");
    expect_not_in_file(place, "d/scene.yaml", "two sides of one joint");
    expect_in_file(place, "d/scene.yaml", "\n# counterface: rigid ");
    workspace_shell(place, "rm -r d; mkdir -p d/pins d/Socket");
    for (unsigned i = 0; i < 4; i++)
        workspace_scan(place, filled("d/%s/%u.csv", i < 2 ? "pins" : "Socket", i), 200, i);
    run_to_exit(place, 0, "init", "d");
    expect_in_file(place, "d/scene.yaml", "\n# A guess: pins and Socket are the two sides of one joint.",
                   "\n# counterface: {surface: [\"Socket/2.csv\", \"Socket/3.csv\"], material: copper} ");
    char *scene = workspace_read(place, "d/scene.yaml");
    static const char *const proposed[] = {"counterface", "hardness", "shape",   "load",    "operating_load",
                                           "plating",     "film",     "current", "targets", "gap"};
    for (size_t k = 0; k < sizeof proposed / sizeof *proposed; k++) {
        workspace_write(place, "d/scene.yaml", scene);
        workspace_shell(place, filled("sed -i -E 's/^# (%s|material|nominal_area):/\\1:/' d/scene.yaml", proposed[k]));
        expect_in_file(place, "d/scene.yaml", filled("\n%s: ", proposed[k]));
        run_to_exit(place, 0, "plan", "d");
        if (strcmp(proposed[k], "plating") == 0) { /* as thick as the tables of materials say is usual */
            run_to_exit(place, 0, "report", "d", "--brief", "--no-cost", "-o", "o");
            expect_not_in_file(place, "o/results.json", "are usual");
        }
    }
}

TEST_IN_WORKSPACE(nothing_is_written_over)
{
    make_files(place, "a.csv|b.csv");
    workspace_write(place, "d/scene.yaml", "title: mine\n");
    char *digest = workspace_digest(place, ".");
    expect_failure(place, 4, 1, "'d/scene.yaml' is there already; move it away", "init", "d");
    expect_failure(place, 4, 1, "cannot open directory 'no'", "init", "no");
    expect_digest(place, ".", digest);
    workspace_shell(place, "rm d/scene.yaml; ln -s nowhere d/scene.yaml");
    expect_failure(place, 4, 1, "cannot write 'd/scene.yaml': File exists", "init", "d");
    assert_false(workspace_has(place, "d/nowhere"));
    /* a directory that may not be written to; root gives up the capability that passes over modes */
    assert_true(workspace_can_run(place, "rm d/scene.yaml; chmod 555 d"));
    expect_failed(
        run_program(place, "sh", "-c",
                    "if [ $(id -u) = 0 ]; then exec setpriv --bounding-set=-dac_override,-dac_read_search " PROGRAM
                    " init d; fi; exec " PROGRAM " init d"),
        4, 1, "cannot write 'd/scene.yaml': Permission denied");
    assert_true(workspace_can_run(place, "chmod 755 d; test ! -e d/scene.yaml"));
    workspace_folder(place, "empty");
    expect_failure(place, 4, 1, "no scan in 'empty'", "init", "empty");
    assert_int_equal(workspace_count(place, ".roughcontact"), 0);
}
