/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/text.h"
#include "scan_support.h"

/* Every dialect below holds x = 0, 1, 2, 3 mm and these heights in um. */
static const double heights_um[] = {0.5, -1.25, 2.75, 0.125};

static void assert_four_points(const char *text, const char *x_unit, const char *z_unit)
{
    struct scan scan = read_good(text, x_unit, z_unit);
    assert_string_equal(scan.format, "text");
    assert_int_equal(scan.kind, SCAN_PROFILE);
    assert_int_equal(scan.nx, 4);
    assert_int_equal(scan.ny, 1);
    for (size_t i = 0; i < 4; i++) {
        assert_within(scan_x(&scan, i), 1e-3 * (double)i, 1e-18);
        assert_near(scan.z_m[i], heights_um[i] * 1e-6, 1e-15);
    }
    assert_near(scan.dx_m, 1e-3, 1e-15);
    assert_int_equal(scan.missing, 0);
    assert_sound(&scan);
    scan_free(&scan);
}

/* Reads `text`, and expects so many points a row, missing ones, and a warning with these words (NULL: none at all). */
static void expect_scan(const char *text, size_t nx, size_t missing, const char *warning)
{
    struct scan scan = read_good(text, "", "");
    assert_int_equal(scan.nx, nx);
    assert_int_equal(scan.missing, missing);
    if (warning && !(scan.warning_count > 0 && strstr(scan.warnings[scan.warning_count - 1], warning)))
        fail_msg("no warning of '%s' says '%s'", text, warning);
    if (!warning)
        assert_int_equal(scan.warning_count, 0);
    scan_free(&scan);
}

#define HEIGHTS "0.5\n-1.25\n2.75\n0.125\n"
#define POINTS  "0,0.5\n1,-1.25\n2,2.75\n3,0.125\n"
#define BLANKS  "0 0.5\n1 -1.25\n2 2.75\n3 0.125\n"

TEST_CASE(test_delimiters)
{
    static const char *const texts[] = {
        "x [mm],z [um]\n" POINTS,
        "x [mm];z [um]\r\n0;0.5\r\n1;-1.25\r\n2;2.75\r\n3;0.125\r\n",
        "x [mm]\tz [um]\r0\t0.5\r1\t-1.25\r2\t2.75\r3\t0.125\r",
        "x [mm] z [um]\n0 0.5\n1 -1.25\n2   2.75\n 3 0.125   ",
        "x [mm] z [um]\n0 0,5\n1 -1,25\n2   2,75\n 3 0,125",
        "x (mm);z (um)\n0;0,5\n1,0;-1,25\n2;2,75\n3;0,125\n",
        "x [mm],z [um]\n0, 0.5\n1, -1.25\n2, 2.75\n3, 0.125\n",
        "x [mm],z [um],\n0,0.5,,\n1,-1.25,,\n2,2.75,,\n3,0.125,,\n\r\r\n",
        "x [mm]\tz [um]\t\n0\t0,5\t\n1\t-1,25\t\n2\t2,75\t\n3\t1,25e-1\t\n\n\n",
        /* in quotes, where commas are decimal signs and separate columns too */
        "\"x [mm]\",\"z [um]\"\n\"0,0\",\"0,5\"\n\"1,0\",\"-1,25\"\n\"2,0\",\"2,75\"\n\"3,0\",\"0,125\"\n",
        "\"x [mm]\";\"z [um]\"\n\"0,0\";\"0,5\"\n\"1,0\";\"-1,25\"\n\"2,0\";\"2,75\"\n\"3,0\";\"0,125\"\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        assert_four_points(texts[i], "", "");
}

TEST_CASE(test_units_in_header)
{
    static const char *const texts[] = {
        "X (mm),Z (um)\n" POINTS,
        "\"X (mm)\",\"Z (um)\"\n" POINTS,
        "x_mm,z_um\n" POINTS,
        "x/mm,z/um\n" POINTS,
        "x in mm,z in um\n" POINTS,
        "X [millimetres],Z [microns]\n" POINTS,
        "Lateral mm,Raw Micrometer,\n" POINTS,
        "x [mm],z [\xC2\xB5m]\n" POINTS,
        "x [mm],z [\xCE\xBCm]\n" POINTS,
        "x [mm],z [\xB5m]\n" POINTS,
        "\xEF\xBB\xBFx [mm],z [um]\n" POINTS,
        "x,z\n[mm],[um]\n" POINTS,
        "x,z\nmm,um\n\n" POINTS,
        "# x [mm], z [um]\n" POINTS,
        "X 1 (mm),Profile 1 (um)\n" POINTS,
        "# x [mm] z [um]\n" POINTS,
        "// X (mm);Z (um)\n" POINTS,
        "Operator,Tom\nLength,1500.0 nm\nDate,1.2.2003\nx [mm],z [um]\n" POINTS,
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        assert_four_points(texts[i], "", "");
}

TEST_CASE(test_units_of_scene)
{
    assert_four_points(POINTS, "mm", "um");
    assert_four_points("x,z\n" POINTS, "mm", "um");
    assert_four_points("x [mm],z\n" POINTS, "", "um");
    assert_four_points("x,z [um]\n" POINTS, "mm", "");
    /* "A" and "in" are words unless brackets say otherwise, and a length among the remarks is no unit of a column */
    assert_four_points("channel in,channel A\n" POINTS, "mm", "um");
    assert_four_points("Length,1500.0 nm\n" POINTS, "mm", "um");
    assert_four_points("# a\n% b\n; c\n// d\n0 0.5\n# between\n1 -1.25\n2 2.75\n3 0.125\n# end\n", "mm", "um");
    /* the file's unit is used, with a warning */
    struct scan scan = read_good("x [mm],z [um]\n" POINTS, "nm", "um");
    assert_int_equal(scan.warning_count, 1);
    assert_non_null(strstr(scan.warnings[0], "x_unit"));
    assert_string_equal(scan.x_unit, "mm");
    assert_string_equal(scan.z_unit, "um");
    assert_near(scan.x_m[3], 3e-3, 1e-15);
    scan_free(&scan);
}

TEST_CASE(test_one_column)
{
    static const char *const texts[] = {
        "# spacing 1 mm\n# z [um]\n" HEIGHTS,    "dx=1mm\nz (um)\n" HEIGHTS,
        "dx = 1000 um\nz (um)\n" HEIGHTS,        "Resolution,1000 um/sample\nz_um\n" HEIGHTS,
        "Step (mm): 1\nz_um\n" HEIGHTS,          "sampling interval\t1 mm\nY step\t3 um\nz_um\n" HEIGHTS,
        "step 1 mm/pixel\nz unit: um\n" HEIGHTS,
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        assert_four_points(texts[i], "", "");
    assert_four_points("spacing: 1\nz_um\n" HEIGHTS, "mm", "");
}

TEST_CASE(test_words_of_spacing)
{
    static const char *const words[] = {"spacing",  "dx",          "deltax", "step",    "X resolution",
                                        "Interval", "x increment", "pitch",  "sampling"};
    static const char *const others[] = {"y", "z", "dy", "dz", "height", "vertical", "row", "line", "time", "mean"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        assert_four_points(filled("# %s = 1 mm\n# z [um]\n" HEIGHTS, words[i]), "", "");
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        assert_refused(filled("# %s step = 1 mm\n# z [um]\n" HEIGHTS, others[i]),
                       "one column is heights only: no spacing");
    /* a pixel's size, but nothing else of it, makes a matrix */
    assert_refused("pixel depth = 2 um\n1 3 2 4\n5 1 3 1\n1 1 1 1\n", "without its pixel size");
}

/* Other steps, lengths, counts and samplings in a header are no spacing, and do not disturb one. */
TEST_CASE(test_words_of_no_spacing)
{
    static const char *const lines[] = {
        "Sampling length: 0.8 mm",
        "Row step = 0.002 mm",
        "Sampling rate: 100 Hz",
        "Sampling = 400 Hz",
        "Sampling speed 2 mm/s",
        "X step velocity = 2 mm/s",
        "Step [mm/s]: 2",
        "step = 2 mm/s",
        "step 2 um per second",
        "Step, 7, Hz",
        "Step [rpm]: 20",
        "Sampling frequency = 2000",
        "Resolution = 1024 points",
        "Resolution [dpi]: 600",
        "Number of sampling points: 8000",
        "Sampling: 6400 points",
        "Number of step points: 400",
        "Profile spacing: 3 mm",
        "profile distance = 1 mm",
        "X distance = 1 mm",
        "Mean spacing RSm = 0.12 mm",
        "Spacing Sm: 0.2 mm",
        "Groove pitch: 0.1 mm",
        "Groove spacing = 0.1 mm",
        "Thread pitch: 1.5 mm",
        "Line pitch: 5 um",
        "pitch = 100 lines/mm",
        "Time interval: 0.5 ms",
        "Sampling interval: 5 ms",
        "Sampling: 5 seconds",
    };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        print_message("%s\n", lines[i]);
        assert_four_points(filled("%s\nx step = 1 mm\nz unit: um\n" HEIGHTS, lines[i]), "", "");
        assert_four_points(filled("# step = 1 mm\n# %s\n# z [um]\n" HEIGHTS, lines[i]), "", "");
        assert_refused(filled("%s\nz unit: um\n" HEIGHTS, lines[i]), "one column is heights only: no spacing");
    }
}

TEST_CASE(test_two_spacings)
{
    static const char *const same[] = {"dx = 1000 um\nspacing 1 mm",
                                       "X-step: 1 mm",
                                       "step 1 mm per sample",
                                       "dx = 1 mm, T = 300",
                                       "X step 1.004 mm\ndx [mm] = 1.000",
                                       "dx = 1,0 mm",
                                       "pitch of x: 1000,0 um",
                                       "dx=1mm\ndx = 1",
                                       "X step distance = 1000 um\nstep = 1 mm"};
    for (size_t i = 0; i < sizeof same / sizeof *same; i++)
        assert_four_points(filled("%s\nz unit: um\n" HEIGHTS, same[i]), "", "");
    assert_refused("x step 1 mm\n\nspacing 2 mm\nz unit: um\n" HEIGHTS,
                   "file:1: lines 1 and 3 name two spacings; remove the one that is not meant");
    assert_refused("dx = 1 mm\nspacing = 2\nz unit: um\n" HEIGHTS, "file:1: lines 1 and 2 name two spacings");
    assert_refused("dx = 1\nspacing 2 mm\nz unit: um\n" HEIGHTS, "file:1: lines 1 and 2 name two spacings");
    assert_refused("pixel size = 1 um\npixel size = 2 um\nz unit: um\n1 3 2 4\n5 1 3 1\n1 1 1 1\n",
                   "file:1: lines 1 and 2 name two pixel sizes");
    /* beside x two different ones are no error and not used; a single one is kept */
    struct scan scan = read_good("dx = 1 mm\nspacing 2 mm\nx [mm],z [um]\n0,1\n1,2\n2,1\n", "", "");
    assert_near(scan.dx_m, 1e-3, 1e-12);
    assert_within(scan.nominal_dx_m, 0, 0);
    scan_free(&scan);
    scan = read_good("Scan Parameters\nResolution,0.156 um/sample\n\nLateral um,Raw Micrometer,\n0.0,1,,\n"
                     "0.2,2,,\n0.3,1,,\n0.5,3,,\n",
                     "", "");
    assert_near(scan.nominal_dx_m, 0.156e-6, 1e-12);
    scan_free(&scan);
}

/* A comment header between the rows begins another block; remarks, rows taken out and a footer do not. */
TEST_CASE(test_blocks)
{
    static const char *const others[] = {"# Channel: Phase", "# Channel:2", "# spacing 2 um", "# z [nm]",
                                         "# x unit: mm"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        expect_scan(filled("# dx = 1 mm\n# z [um]\n" HEIGHTS "\n%s\n7\n8\n# b: 1\n9\n", others[i]), 4, 0,
                    filled("2 more blocks of rows, the first below line 8, '%s'", others[i] + 2));
        expect_scan(filled("# pixel size = 0.5 um\n# z unit: um\n1\t3\t2\t4\n5\t1\t3\t1\n%s\n1\t1\t1\t1\n", others[i]),
                    4, 0, filled("1 more block of rows, the first below line 5, '%s'", others[i] + 2));
    }
    expect_scan("# dx = 1 mm\n# z [um]\n" HEIGHTS "# a: 1\n# b: 2\n7\n8\n", 4, 0,
                "1 more block of rows, the first below line 7, 'a: 1'");
    static const char *const none[] = {"", "# stylus lifted at 10:31", "# 0.5 7", "#", "# checked"};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        expect_scan(filled("x [mm],z [um]\n0,0.5\n1,-1.25\n%s\n2,2.75\n3,0.125\n# end: 1\n\n# unit: mm\n", none[i]), 4,
                    0, NULL);
}

/* Headers of maps of other programs, and of Gwyddion in other languages. */
TEST_CASE(test_headers_of_maps)
{
#define MATRIX "1\t3\t2\t4\n5\t1\t3\t1\n1\t1\t1\t1\n"
    static const struct {
        const char *text;
        double dx_m, dy_m, z_m;
    } maps[] = {
        {"# File Format = ASCII\n# Created by SPIP 6\n# x-pixels = 4\n# x-length = 8000\n# y-length = 3000\n"
         "# z-unit = nm\n# Start of Data:\n" MATRIX,
         2e-6, 1e-6, 1e-9},
        {"File Format = ASCII\r\nCreated by Nova\r\nNX = 4\r\nScale X = 2\r\nScale Y = 1\r\nUnit X = um\r\n"
         "Unit Data = nm\r\nScale Data = 3\r\nDataScaleNeeded = no\r\nStart of Data :\r\n" MATRIX,
         2e-6, 1e-6, 1e-9},
        {"File Format = ASCII\nCreated by Nova\nScale X = 2\nScale Y = 1\nUnit X = um\nUnit Data = nm\n"
         "Scale Data = 3\nDataScaleNeeded = yes\nStart of Data :\n" MATRIX,
         2e-6, 1e-6, 3e-9},
        {"# Canal : Topo\n# Largeur : 8,000 \xC2\xB5m\n# Hauteur : 3,000 \xC2\xB5m\n# Unit\xC3\xA9s : m\n" MATRIX, 2e-6,
         1e-6, 1},
        {"# Kanal: a\n# Breite: 8.0 \xB5m\n# H\xF6he: 3.0 \xB5m\n# Einheit: nm\n" MATRIX, 2e-6, 1e-6, 1e-9},
        {"# a: 4 um\n# b: 3 um\n# z unit: nm\n" MATRIX, 1e-6, 1e-6, 1e-9},
        {"\"Modell\",\"x\"\n\"XY-Justierung\",\"500\",\"nm/pixel\"\n\"Einheit\",\"\xB5m\"\n\n"
         "\"1\",\"3\",\"2\",\"4\"\n\"5\",\"1\",\"3\",\"1\"\n\"1\",\"1\",\"1\",\"1\"\n",
         5e-7, 5e-7, 1e-6},
        {"resolution 0.5 um/pixel\npixel size = 0.5 um\nz unit: um\n" MATRIX, 5e-7, 5e-7, 1e-6},
    };
    for (size_t i = 0; i < sizeof maps / sizeof *maps; i++) {
        print_message("%s\n", maps[i].text);
        struct scan scan = read_good(maps[i].text, "", "");
        assert_int_equal(scan.nx, 4);
        assert_int_equal(scan.ny, 3);
        assert_near(scan.dx_m, maps[i].dx_m, 1e-12);
        assert_near(scan.dy_m, maps[i].dy_m, 1e-12);
        assert_near(scan.z_m[1], 3 * maps[i].z_m, 1e-12);
        scan_free(&scan);
    }
    /* lengths that need not be of the map: no square pixels, three of them, not in lines that follow each other */
    static const char *const others[] = {"# tip: 4 um\n# b: 5 um\n", "# a: 4 um\n# b: 3 um\n# c: 1 um\n",
                                         "# a: 4 um\n# x\n# b: 3 um\n", "# a: 4 um/s\n# b: 3 um\n",
                                         "\"Z calibration\",\"2\",\"um/pixel\"\n"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        assert_refused(filled("%s# p: 1\n1 3 2 4\n5 1 3 1\n1 1 1 1\n", others[i]), "without its pixel size");
    assert_refused("# Width: 2.0 um\n# Height: 1.0 um\n# Width: 3 um\n# z unit: m\n" MATRIX,
                   "file:1: lines 1 and 3 name two widths");
    assert_refused(
        "# x-length = 8000\n# y-length = 3000\n1 3 2 4 1 1 1 1 1 1\n5 1 3 1 1 1 1 1 1 1\n1 1 1 1 1 1 1 1 1 x\n",
        "'x' in a column");
}

TEST_CASE(test_descending)
{
    assert_four_points("x [mm],z [um]\n3,0.125\n2,2.75\n1,-1.25\n0,0.5\n", "", "");
    expect_scan("x [mm],z [um]\n3,30\n2,20\n0,0\n", 3, 0, "x descends: the scan was reversed");
}

TEST_CASE(test_refusals)
{
    assert_refused("", "file: the file is empty");
    assert_refused("\n\n\n", "file: no line of numbers");
    assert_refused("{\n \"LENGTH\": 0.11,\n \"NAME\": null\n}\n", "file: no line of numbers in it: not a scan");
    assert_refused("0,1\n1,2\n", "file:2: points: 2");
    assert_refused("x,z\n0,1\n1,nan\n2,3\n", "file: 1 of 3 heights are missing");
    assert_refused("x,z\n0,1\nnan,2\n2,3\n3,4\n", "file:3: no x here; fill it in or remove this line");
    assert_refused("x,z\n0,1\n1,2\n,2\n3,4\n", "file:4: no x here; fill it in or remove this line");
    assert_refused("0,1\n1,inf\n2,3\n", "file:2: 'inf'");
    assert_refused("0,1\n1,1e999\n2,3\n", "file:2: '1e999'");
    assert_refused("x;z\r\n0;1\r\n1;2\r\n2;bad\x7f one\r\n", "file:4: 'bad? one'");
    assert_refused("0 1\n\n1 2\n2 3 4\n", "file:4: 3 columns where line 1 has 2");
    assert_refused("0,1\n1\n2,3\n", "file:2: 1 columns where line 1 has 2");
    assert_refused("0,1\n1,\n2,3\n", "file: 1 of 3 heights are missing");
    assert_refused("0,1\n,2\n2,3\n", "file:2: no x here; fill it in or remove this line");
    assert_refused("0,1\n1,2\n2,3\nend\n", "file:4: 'end'");
    assert_refused("0;1\n1;2\n;x\n", "file:3: 'x'");
    assert_refused("# a\n0 1\n# b\n\n1 2\n1 3\n2 4\n", "file:6: x is that of the point before");
    assert_refused("0,1\n2,2\n1,3\n",
                   "file:3: x turns back; x has to go one way: sort or remove points, choose it by `column`");
    assert_refused("0,1,2,5\n0,2,2,1\n0,3,1,9\n", "keep two columns, x and z, or separate the columns by semicolons");
    assert_refused("0,4771\n0,4783\n0,4790\n", "separate the columns by semicolons if the commas are decimal signs");
    assert_refused("0;1.5\n1;2,5\n2;3.5\n", "file:2: both '.' and ','");
    assert_refused("spacing 1 um\n1\n2\n\n3\n", "file:4: a blank line among the heights");
    assert_refused("1\n2\n3\n", "file:1: one column is heights only: no spacing; add a line `spacing");
    assert_refused("x,z\n0,err\n1,2\n2,3\n4,5\n", "file:2: 'err'");
    assert_refused("x;z\r\n0;nan\r\n1;2\r\n2;3\r\n", "file: 1 of 3 heights are missing");
    assert_refused("0,1\n1,2\n2,3\n\x80\x80", "file:4: '\?\?'");
}

TEST_CASE(test_missing_units)
{
    const char *text = "0,1\n1,2\n2,3\n";
    refuse_with(text, &no_units, "add `x_unit: mm` and `z_unit: um`");
    refuse_with(text, &no_units, "--x-unit mm --z-unit um");
    struct scan_options x_only = {.x_unit = "mm", .z_unit = ""}, z_only = {.z_unit = "um"},
                        both_units = {.x_unit = "mm", .z_unit = "um"}, wrong = {.x_unit = "mm", .z_unit = "volt"};
    refuse_with(text, &x_only, "no unit for z; add `z_unit: um`");
    refuse_with(text, &z_only, "no unit for x; add `x_unit: mm`");
    refuse_with(text, &wrong, "is no unit of length; give z_unit");
    /* a unit in brackets that is no length is named where one is missing; longer words in brackets are no units */
    static const struct {
        const char *title, *refused;
    } titles[] = {
        {"Force (N),Resistance (mOhm)",
         "file: x in 'N' is no scan; a measurement goes into scene.yaml as `measured: {file: ...}`"},
        {"R (mOhm),F (N)", "file: x in 'mOhm' is no scan"},
        {"x [mm],z (V)", "file: z is in 'V' by the file, which is no unit of length; correct it there"},
        {"x [km],z [um]", "file: unknown unit 'km', no unit for x; add"},
        {"x,z [km]", "file: unknown unit 'km', no unit for x nor for z; add"},
        {"x [km],z [px]", "file: unknown unit 'km', no unit for x nor for z; add"},
        {"x (position),z [um]", "file: no unit for x; add"},
    };
    for (size_t i = 0; i < sizeof titles / sizeof *titles; i++)
        refuse_with(filled("%s\n%s", titles[i].title, text), &no_units, titles[i].refused);
    for (size_t i = 0; i < 3; i++) /* a force is no position and a voltage no height, whatever the scene says */
        refuse_with(filled("%s\n%s", titles[i].title, text), &both_units, titles[i].refused);
    struct scan scan = read_with("x [km],z [um]\n0,1\n1,2\n2,3\n", &x_only); /* the scene's counts */
    assert_string_equal(scan.x_unit, "mm");
    scan_free(&scan);
}

TEST_CASE(test_binary)
{
    static const char ended[] = "x [mm];z [um]\n0;1\n1;2\n2;1\n\x1a\0";
    struct scan scan = {0};
    expect_ok(read_bytes, &scan, ended, sizeof ended, &no_units); /* with the NUL that ends it in C, two */
    assert_int_equal(scan.nx, 3);
    scan_free(&scan);
    static const char png[] = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x20";
    assert_refused_bytes(png, sizeof png - 1, &no_units, "it is no scan: PNG picture");
    char noise[4096];
    for (size_t i = 0; i < sizeof noise; i++)
        noise[i] = (char)(i * i * 37 >> 4);
    assert_refused_bytes(noise, sizeof noise, &no_units,
                         "is a binary file of no known format; export it as text (x z columns), .sdf, .sur or .x3p");
}

TEST_CASE(test_no_file)
{
    static const char *const paths[][2] = {
        {"/", "is a directory"}, {TEST_DATA "/no such file", "no such file"}, {"/dev/null", "/dev/null"}};
    for (size_t i = 0; i < sizeof paths / sizeof *paths; i++) {
        struct scan scan;
        expect_fails(STATUS_IO, paths[i][1], scan_read, &scan, paths[i][0], &no_units);
        scan_free(&scan);
    }
}

TEST_CASE(test_hostile_name)
{
    struct scan scan;
    struct status status = {0};
    char name[3000];
    memset(name, 'n', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    name[3] = '\n', name[4] = '%';
    struct scan_bytes file = {"0,1\n1,x\n", 8, name};
    assert_int_equal(scan_read_bytes(&scan, &file, &no_units, &status), STATUS_SCAN);
    assert_null(strchr(status.message, '\n'));
    assert_non_null(strstr(status.message, ":2: 'x' in a column"));
    scan_free(&scan);
}

/* What instruments write where they measured nothing, and empty cells, are missing points. */
TEST_CASE(test_missing)
{
    static const char *const texts[] = {
        "x [mm],z [um]\n0,0.5\n1,nan\n2,2.75\n3,0.125\n4,7\n",
        "x [mm],z [um]\n0,0.5\n1,Bad\n2,2.75\n3,0.125\n4,7\n",
        "x [mm];z [um]\n0;0,5\n1;***\n2;2,75\n3;0,125\n4;7\n",
        "x [mm],z [um]\n0,0.5\n1,\n2,2.75\n3,0.125\n4,7\n",
        "x [mm],z [um],\n0,0.5,\n1,,\n2,2.75,\n3,0.125,\n4,7,\n,,\n",
        "x [mm]\tz [um]\n0\t0.5\n1\t\n2\t2.75\n3\t0.125\n4\t7\n\t\n",
        "x [mm] z [um]\n0 0.5\n1 *****\n2 2.75\n3 0.125\n4 7\n",
        "*****\n*** a b ***\nx [mm] z [um]\n0 0.5\n1 NaN\n2 2.75\n3 0.125\n4 7\n",
        "i,x [mm],z [um]\n0,0,0.5\n1,1,\n2,2,2.75\n3,3,0.125\n4,4,7\n",
        "x [mm],z [um],remark\n0,0.5,1\n1,,1\n2,2.75,1\n3,0.125,\n4,7,1\n",
    };
    static const double z_um[] = {0.5, NAN, 2.75, 0.125, 7};
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++) {
        struct scan scan = read_good(texts[k], "", "");
        assert_int_equal(scan.nx, 5);
        assert_int_equal(scan.missing, 1);
        assert_sound(&scan);
        for (size_t i = 0; i < 5; i++) {
            assert_within(scan_x(&scan, i), 1e-3 * (double)i, 1e-15);
            if (i == 1)
                assert_true(isnan(scan.z_m[i]));
            else
                assert_within(scan.z_m[i], z_um[i] * 1e-6, 1e-15);
        }
        scan_free(&scan);
    }
    expect_scan("spacing 0.5 um, heights in um\nz unit: um\n1\n2\n***\nBAD\n3\n", 5, 2, NULL);
    expect_scan("x_unit: mm\nz_unit: um\n0 5\n1 -25400\n2 6\n3 5\n", 4, 1,
                "a height of -25400 um stands for missing points: 1");
    expect_scan("x_unit: mm\nz_unit: nm\n0 5\n1 -25400\n2 -20000\n3 5\n", 4, 0, NULL); /* others are as large */
}

/* A first line may say how many points follow, and has to be right. */
TEST_CASE(test_counts)
{
    assert_four_points("4\n" BLANKS, "mm", "um");
    assert_four_points("title\n4\n\n" POINTS, "mm", "um");
    assert_four_points("4,\n0,0.5,\n1,-1.25,\n2,2.75,\n3,0.125,\n", "mm", "um");
    assert_refused("5\n" BLANKS, "file:1: 5 points are announced, 4 follow; copy the file");
    assert_refused("3\n" BLANKS, "file:1: 3 points are announced, 4 follow");
    assert_four_points("# spacing 1 mm\n4\n" HEIGHTS, "", "um");
    expect_scan("# spacing 1 mm\n# z [um]\n4\n" HEIGHTS, 4, 0, "the first number, 4, says how many heights follow");
    expect_scan("# spacing 1 mm\n# z [um]\n4\n0.0\n0.5\n-1\n2\n", 4, 0, "the first number, 4, says how many heights");
    expect_scan("# spacing 1 mm\n# z [um]\n4\n1\n3\n2\n1\n", 5, 0, NULL); /* whole numbers all: a height */
}

/* The file's text is freed once its columns are read, but not if a sidecar or the line of an error needs it. */
TEST_CASE(test_a_spent_text_is_freed)
{
    static const struct {
        const char *content, *unit, *error;
        bool goes;
    } cases[] = {{"x [um],z [um]\n0,1\n1,3\n2,2\n", NULL, NULL, true},
                 {"x [um],valid,z [um]\n0,1,1\n1,0,3\n2,1,2\n3,1,4\n", NULL, NULL, true},
                 {"0,1\n1,3\n2,2\n", "um", NULL, false},
                 {"x [um],z [um]\n0,1\n1,3\n\n1,2\n", NULL, "spent:5: ", false}};
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        struct text *text = support_text();
        struct status status = {0};
        struct scan scan;
        text_add(text, "%s", cases[c].content);
        const struct scan_bytes file = {text_string(text), text->length, "spent"};
        const struct scan_options options = {.x_unit = cases[c].unit, .z_unit = cases[c].unit, .spent = text};
        enum status_code code = scan_read_bytes(&scan, &file, &options, &status);
        assert_int_equal(code, cases[c].error ? STATUS_SCAN : STATUS_OK);
        if (cases[c].error)
            assert_non_null(strstr(status.message, cases[c].error));
        else
            assert_near(scan.z_m[2], 2e-6, 1e-15);
        assert_true((text->data == NULL) == cases[c].goes);
        scan_free(&scan);
    }
}

/* The header of another block is quoted although its text is freed by then. */
TEST_CASE(test_a_block_of_a_spent_text_is_named)
{
    struct text *text = support_text();
    struct status status = {0};
    struct scan scan;
    text_add(text, "x [um],z [um]\n");
    for (int i = 0; i < 1000; i++)
        text_add(text, "%s%d,%d\n", i == 900 ? "# trace: 2\n" : "", i, i % 7);
    const struct scan_bytes file = {text_string(text), text->length, "spent"};
    assert_int_equal(scan_read_bytes(&scan, &file, &(struct scan_options){.spent = text}, &status), STATUS_OK);
    assert_null(text->data);
    assert_non_null(strstr(scan.warnings[0], "'trace: 2'"));
    scan_free(&scan);
}

/* A height that is repeated far from all others was not measured; a single spike, a step and usual heights of 9999
 * were.
 */
TEST_CASE(test_gap_codes)
{
    static const struct {
        double code;
        int times;
        double scale;
        size_t missing;
    } cases[] = {{9999, 4, 1, 4}, {1e10, 2, 1, 2}, {9999, 1, 1, 0}, {-2147483648.0, 3, 1, 3}, {100, 4, 1, 4},
                 {-777, 4, 1, 4}, {777, 1, 1, 0},  {40, 4, 1, 0},   {9999, 4, 2000, 0},       {777, 60, 1, 0}};
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        struct text *text = support_text();
        text_add(text, "x [um],z [um]\n");
        for (int i = 0; i < 200; i++)
            text_add(text, "%d,%.6g\n", i,
                     i >= 100 && i < 100 + cases[c].times ? cases[c].code : cases[c].scale * (5 + sin(0.7 * i)));
        struct scan scan = read_good(text_string(text), "", "");
        if (scan.missing != cases[c].missing)
            fail_msg("%g, %d times: %zu missing", cases[c].code, cases[c].times, scan.missing);
        scan_free(&scan);
    }
}

/* The message on a column of text says what to choose, and the choice works. A counter is no position. */
TEST_CASE(test_columns_that_are_no_scan)
{
    static const char timed[] = "time,x_mm,z_um\n2024-03-01 10:11:00,0,0.5\n2024-03-01 10:11:01,1,-1.25\n"
                                "2024-03-01 10:11:02,2,2.75\n2024-03-01 10:11:03,3,0.125\n";
    assert_refused(
        timed,
        "file: no line of numbers in it: not a scan; where columns hold text choose others, as in `column: [2, 3]`");
    struct scan scan = read_with(timed, &(struct scan_options){.x_column = 2, .z_column = 3});
    assert_int_equal(scan.nx, 4);
    assert_near(scan.z_m[2], 2.75e-6, 1e-12);
    assert_near(scan.dx_m, 1e-3, 1e-12);
    scan_free(&scan);
    scan = read_good(
        "Counter\tAltitude (um)\tEncoder (mm)\tRow\n37\t0.5\t0\t1\n38\t-1.25\t1\t1\n39\t2.75\t2\t1\n40\t0.125\t3\t1\n",
        "", "");
    assert_int_equal(scan.x_column, 3);
    assert_int_equal(scan.z_column, 2);
    scan_free(&scan);
}
