/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What lies beside scans, and scans in archives. */
#include "cli/process.h"

static void write_others(const char *place)
{
    workspace_write_bytes(place, "d/photo.jpg", "\xff\xd8\xff\xe0\0\0", 6);
    workspace_write_bytes(place, "d/b.png", "\x89PNG\r\n\x1a\n\0\0", 10);
    workspace_write_bytes(place, "d/a.png", "\x89PNG\r\n\x1a\n\0\0", 10);
    workspace_write(place, "d/paper.pdf", "%PDF-1.7\n1 0 obj\n");
    workspace_write(place, "d/README.md", "# Scans\n1 2\n3 4\n");
    workspace_write(place, "d/plot.py", "x = 1\n0.5, 1\n");
    workspace_write(place, "d/notes.txt", "made by hand\n");
}

static const char others[] = "passed over, no scan: 1 x JPEG picture (photo.jpg)\n"
                             "passed over, no scan: 1 x PDF document (paper.pdf)\n"
                             "passed over, no scans: 2 x PNG picture (a.png, b.png)\n"
                             "passed over, no scans: 2 x text (README.md, plot.py)\n"
                             "passed over, no scan: 1 x text without a row of numbers (notes.txt)\n";

/* Files that are no scans are passed over in a directory, with a message, and refused where a scene names them. */
TEST_IN_WORKSPACE(test_passed_over)
{
    workspace_scan(place, "d/1.csv", 200, 1);
    workspace_scan(place, "d/2.csv", 200, 2);
    write_others(place);
    expect_errors(expect_exit(place, 0, "plan", "d"), others);
    expect_errors(expect_exit(place, 0, "report", "--no-cost", "d"), others);
    expect_in_file(place, "out/d/report.md", "2 x PNG picture (a.png, b.png)");
    expect_not_in_file(place, "out/d/report.md", "**Refused**");
    expect_in_file(place, "out/d/results.json", "passed over, no scans: 2 x PNG picture (a.png, b.png)");
    struct process process = expect_exit(place, 0, "inspect", "d");
    expect_part(process.err, others);
    expect_parts(process.out, "d/1.csv\n  format ", "d/2.csv\n  format ");

    /* an instrument's file that is not read is no such thing */
    workspace_write_bytes(place, "d/w.opd", "\1\0Directory\0\0\0", 14);
    expect_errors(expect_exit(place, 1, "plan", "d"),
                  "surface 'w' refused: w.opd: the format is not read here: Wyko OPD file; export it as text");

    workspace_write(place, "d/scene.yaml", "surfaces: [{file: 1.csv}, {file: photo.jpg}]\n");
    process = expect_exit(place, 1, "report", "--no-cost", "d");
    expect_part(process.err, "surface 'photo' refused: photo.jpg: it is no scan: JPEG picture");
    expect_no_part(process.err, "passed over");
    workspace_write(place, "e/README.md", "nothing yet\n");
    expect_failure(place, 4, 2, "passed over, no scan: 1 x text (README.md)\nroughcontact: no scan in 'e'", "report",
                   "e");
}

TEST_IN_WORKSPACE(test_packed)
{
    workspace_scan(place, "1.csv", 200, 3); /* in the order of their contents, which files of a surface are read in */
    workspace_scan(place, "2.csv", 200, 2);
    workspace_scan(place, "3.csv", 200, 1);
    struct process process =
        run_program(place, CMAKE_PROGRAM, "-E", "tar", "cf", "three.zip", "--format=zip", "1.csv", "2.csv", "3.csv");
    assert_int_equal(process.status, 0);
    process = run_program(place, "gzip", "1.csv");
    assert_int_equal(process.status, 0);
    expect_output(expect_exit(place, 0, "inspect", "three.zip"), "three.zip(1.csv)\n", "three.zip(2.csv)\n",
                  "three.zip(3.csv)\n");
    expect_output(expect_exit(place, 0, "inspect", "1.csv.gz"), "points      200");

    struct text *bytes = support_text();
    expect_ok(text_read_file, bytes, directory_path(place, "three.zip"));
    /* one of three scans of a surface damaged: the others are read, as from files, and it is named */
    char *second = memmem(bytes->data, bytes->length, "2.csv", 5);
    assert_non_null(second);
    second[100] ^= 1;
    workspace_write_bytes(place, "damaged.zip", bytes->data, bytes->length);
    process = expect_exit(place, 1, "inspect", "damaged.zip");
    expect_parts(process.out, "damaged.zip(1.csv)\n", "damaged.zip(3.csv)\n");
    expect_part(process.err, "'2.csv' in the archive is damaged; copy the file again\n");
    workspace_write_bytes(place, "dz/s.zip", bytes->data, bytes->length);
    expect_errors(expect_exit(place, 1, "report", "--no-cost", "dz"),
                  "'2.csv' in the archive is damaged; copy the file again - refused; the others of the "
                  "archive are used\n");
    expect_in_file(place, "out/dz/report.md", "**Not used: 1 of 3 files**, of s.");
    workspace_scan(place, "again.csv", 200, 1); /* a copy is named within the archive */
    workspace_write(place, "dc/README.md", "passed over\n");
    process = run_program(place, CMAKE_PROGRAM, "-E", "tar", "cf", "dc/s.zip", "--format=zip", "3.csv", "again.csv");
    assert_int_equal(process.status, 0);
    run_to_exit(place, 0, "report", "--no-cost", "dc");
    expect_in_file(place, "out/dc/report.md", "**Copies:** s.zip(again.csv) repeats heights that were read before");
    workspace_scan(place, "df/1.csv", 200, 3);
    workspace_scan(place, "df/3.csv", 200, 1);
    workspace_write(place, "df/scene.yaml", "surfaces: [{name: s, file: [1.csv, 3.csv]}]\n");
    run_to_exit(place, 0, "report", "--no-cost", "df");
    directory_expect_same(place, "out/dz/data/contact.csv", "out/df/data/contact.csv");
    expect_in_file(place, "out/df/report.md", "- s: 1.csv, 3.csv; text, x um, z um,");
    workspace_shell(place, "sed -i 's/x .um./x [mm]/' df/3.csv");
    run_to_exit(place, 0, "report", "--no-cost", "df");
    expect_in_file(place, "out/df/report.md", "- s: 1.csv, 3.csv; text, several units,");
}
