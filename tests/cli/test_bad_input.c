/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bad input gives one line with file, line and remedy, and nothing is half written. */
#include "cli/process.h"

#include "output/exchange.h"

#define HEADER "x [um],z [um]\n"
#define ROUGH  HEADER "0,1\n1,3\n2,2\n3,5\n4,1\n5,4\n6,2\n7,6\n8,3\n9,1\n"

/** A former report, which is to stay as it is. */
static void leave_report(const char *place)
{
    workspace_write(place, "out/d/report.md", "the report of before\n");
    workspace_write(place, "out/d/report.html", "<p>the report of before\n");
    workspace_write(place, "out/d/results.json", "{}\n");
    workspace_write(place, "out/d/data/surfaces.csv", "surface\n");
    workspace_write(place, "out/d/figures/6-05.svg", "<svg/>\n");
    workspace_write(place, "out/d/manifest.txt",
                    OUTPUT_MANIFEST_HEADER
                    "data/surfaces.csv\nfigures/6-05.svg\nmanifest.txt\nreport.html\nreport.md\nresults.json\n");
}

struct bad_input {
    const char *scene, *scan; /* content of d/scene.yaml and d/a.csv; NULL: no such file */
    int status;
    size_t lines; /* on stderr */
    const char *message;
};

static const struct bad_input bad_inputs[] = {
    {NULL, NULL, 4, 1, "roughcontact: no scan in 'd': put"},
    {NULL, "no numbers here\n", 4, 2, "surface 'a' refused: a.csv: no line of numbers in it"},
    {NULL, HEADER "0,1\n1,1\n2,oops\n3,2\n", 4, 2,
     "a.csv:4: 'oops' in a column of numbers; correct or remove this line"},
    {NULL, HEADER "0,1\n1,1\n2,1\n3,1\n4,1\n5,1\n", 4, 2, "a.csv: the scan is flat"},
    {NULL, "0,1\n1,2\n2,1\n3,3\n4,1\n", 4, 2, "a.csv: no unit for x nor for z; add `x_unit: mm` and `z_unit: um`"},
    {"materail: tin\n", ROUGH, 3, 1, "roughcontact: d/scene.yaml:1: unknown key 'materail'; did you mean 'material'?"},
    {"material: tin\ncounterface: {surface: \"*.csv\"}\n", ROUGH, 3, 1,
     "d/scene.yaml:2: no scan is left for the surfaces beside the files of 'counterface'"},
    {"measured: {file: a.csv, quantity: ecr}\n", ROUGH, 3, 1,
     "d/scene.yaml:1: no scan is left for the surfaces beside the files of 'measured'"},
};

TEST_IN_WORKSPACE(test_bad_inputs)
{
    for (size_t i = 0; i < sizeof bad_inputs / sizeof *bad_inputs; i++) {
        const struct bad_input *bad = &bad_inputs[i];
        const char *here = lasting("%s/case-%zu", place, i);
        workspace_folder(place, filled("case-%zu/d", i));
        if (bad->scene)
            workspace_write(here, "d/scene.yaml", bad->scene);
        if (bad->scan)
            workspace_write(here, "d/a.csv", bad->scan);
        char *alone = workspace_digest(here, ".");
        expect_failure(here, bad->status, bad->lines, bad->message, "report", "d");
        expect_digest(here, ".", alone); /* no out/, nothing hidden */
        leave_report(here);
        char *before = workspace_digest(here, ".");
        expect_failure(here, bad->status, bad->lines, bad->message, "report", "d");
        expect_digest(here, ".", before);
    }
}

TEST_IN_WORKSPACE(test_directories)
{
    workspace_write(place, "file", "x\n");
    expect_failure(place, 4, 1, "cannot open directory 'nowhere': No such file", "report", "nowhere");
    expect_failure(place, 4, 1, "'file' is no directory; name the one that holds the scans", "report", "file");
    expect_failure(place, 4, 1, "cannot open directory ''", "report", "");
    workspace_folder(place, "d/scene.yaml");
    expect_failure(place, 3, 1, "'d/scene.yaml' is no regular file", "report", "d");
    assert_false(workspace_has(place, "out"));
}

TEST_IN_WORKSPACE(test_where_it_cannot_write)
{
    workspace_scan(place, "d/a.csv", 200, 1);
    workspace_write(place, "file", "mine\n");
    char *before = workspace_digest(place, ".");
    expect_failure(place, 4, 1, "cannot write the report to 'file': Not a directory", "report", "d", "-o", "file");
    expect_failure(place, 4, 1, "cannot make a directory in 'file/': Not a directory", "report", "d", "-o",
                   "file/report");
    expect_failure(place, 4, 1, "cannot make a directory in '/proc/'", "report", "d", "-o", "/proc/report");
    expect_failure(place, 2, 1, "'' is no name for a report's directory", "report", "d", "-o", "");
    expect_failure(place, 2, 1, "'.' is no name", "report", "d", "-o", ".");
    expect_digest(place, ".", before);
    if (geteuid() == 0)
        return; /* whom no mode stops */
    workspace_folder(place, "closed");
    const char *closed = lasting("%s/closed", place);
    assert_int_equal(chmod(closed, 0555), 0);
    expect_failure(place, 4, 1, "cannot make a directory in 'closed/': Permission denied", "report", "d", "-o",
                   "closed/report");
    assert_int_equal(chmod(closed, 0755), 0);
}

TEST_IN_WORKSPACE(test_without_gnuplot)
{
    workspace_scan(place, "d/a.csv", 200, 1);
    char *before = workspace_digest(place, "."), *path = lasting("%s", getenv("PATH"));
    assert_int_equal(setenv("PATH", "/nowhere", 1), 0);
    expect_failure(place, 4, 1, "no gnuplot in PATH to draw the charts: install the package gnuplot-nox", "report",
                   "d");
    struct process inspect = expect_exit(place, 0, "inspect", "--chart", "d/a.csv");
    workspace_take_back(path);
    expect_part(inspect.out, "Rq ");
    expect_part(inspect.err, "no chart: no gnuplot in PATH");
    expect_digest(place, ".", before);
}

/* Where there is nothing to draw no gnuplot is started. */
TEST_IN_WORKSPACE(test_gnuplot_waits_for_data)
{
    workspace_shell(place, "mkdir d && seq 400000 > d/a.txt"); /* of no unit, which takes long enough to say */
    char *path = workspace_program(place, "gnuplot", "#!/bin/sh\ntouch \"$0.started\"\ncat > /dev/null\n");
    expect_part(expect_exit(place, 4, "report", "d").err, "no usable surface in 'd'");
    workspace_shell(place, "! find . -name '*.started' | grep .");
    workspace_take_back(path);
}

/* A gnuplot that draws nothing is named as the cause. */
TEST_IN_WORKSPACE(test_gnuplot_that_draws_nothing)
{
    workspace_scan(place, "d/a.csv", 200, 1);
    char *path = workspace_program(place, "gnuplot", "#!/bin/sh\ncat > /dev/null\n");
    expect_failure(place, 4, 1, "gnuplot did not draw 'answer.svg'", "report", "d", "--no-cost");
    workspace_take_back(path);
    assert_false(workspace_has(place, "out"));
    run_to_exit(place, 0, "report", "d", "--no-cost");
}

/* `-o -` is refused by report, and means standard output to synth. */
TEST_IN_WORKSPACE(test_output_to_a_dash)
{
    workspace_scan(place, "d/a.csv", 200, 1);
    expect_errors(expect_exit(place, 2, "report", "d", "-o", "-"), "-o takes the folder of the report, not '-'");
    run_to_exit(place, 0, "report", "d", "-o", "./-", "--no-cost"); /* a folder of that name */
    expect_output(expect_exit(place, 0, "synth", "-o", "-"), "x [um],z [um]\n");
}

/* Ten refusals are printed, more are only counted (test_messages.c: those of a report). */
TEST_IN_WORKSPACE(test_many_empty_files)
{
    for (int i = 0; i < 31; i++) {
        workspace_write(place, filled("many/%d.csv", i), "");
        if (i < 10)
            workspace_write(place, filled("ten/%d.csv", i), "");
    }
    struct process process = expect_exit(place, 4, "inspect", "many");
    assert_int_equal(times(process.err, "\n"), 11);
    expect_part(process.err, "and 21 more scans refused; --json names all");
    assert_int_equal(times(expect_exit(place, 4, "inspect", "ten").err, "\n"), 10);
}

/* Two copies of a scan that cannot be used are both refused. */
TEST_IN_WORKSPACE(test_copies_of_a_bad_scan)
{
    workspace_scan(place, "d/s/1.csv", 200, 1);
    workspace_scan(place, "d/s/2.csv", 200, 1);
    workspace_write(place, "d/scene.yaml", "lambda_c: 1 km\n");
    expect_errors(expect_exit(place, 4, "report", "d", "--no-cost"), "s/1.csv: lambda_c is 1000 m, ",
                  "s/2.csv: lambda_c is 1000 m, ");
    workspace_write(place, "d/scene.yaml", "material: tin\n");
    run_to_exit(place, 0, "report", "d", "--no-cost");
}

TEST_IN_WORKSPACE(test_one_bad_scan_stops_no_other)
{
    workspace_scan(place, "d/a.csv", 200, 1);
    workspace_write(place, "d/b.csv", HEADER "0,1\n1,2\n2,x\n");
    workspace_scan(place, "d/c.csv", 200, 2);
    struct process process = expect_exit(place, 1, "report", "d", "--material", "tin", "--effects", "plasticity");
    expect_part(process.err, "surface 'b' refused: b.csv:4: 'x' in a column of numbers; correct or remove this line\n");
    expect_part(process.out, "\nout/d/report.html\n");
    expect_in_file(place, "out/d/report.md", "**Not used: 1 of 3 files**, of b.", "'x' in a column of numbers");
    expect_in_file(place, "out/d/report.html", "b.csv:4: 'x' in a column of numbers");
    expect_in_file(place, "out/d/results.json", "\"surface\": \"b\"",
                   "\"error\": \"b.csv:4: 'x' in a column of numbers; correct or remove this line\"");
    expect_in_file(place, "out/d/data/surfaces.csv", "\na,a.csv,200,", "\nc,c.csv,200,");
    expect_not_in_file(place, "out/d/data/surfaces.csv", "b.csv");
}
