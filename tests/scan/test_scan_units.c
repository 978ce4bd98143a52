/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which unit a header gives to which axis, slopes and heights, the choice of columns, and sidecars. */
#include "directory.h"
#include "scan_support.h"

#define COMMA "0,1\n1,2\n2,3\n3,1\n"
#define TAB   "0\t1\n1\t2\n2\t3\n3\t1\n"
#define BLANK "0 1\n1 2\n2 3\n3 1\n"
#define INDEX "0 5 1\n1 5 2\n2 6 1\n3 5 1\n"
#define ONE   "1\n2\n3\n1\n"

TEST_CASE(test_headers)
{
    static const struct {
        const char *text, *x_unit, *z_unit; /* NULL: not said */
    } rows[] = {
        /* one axis named, the other not: in every form of a key */
        {"X unit: mm\n" COMMA, "mm", NULL},
        {"X unit,mm\n" COMMA, "mm", NULL},
        {"X unit\tmm\n" TAB, "mm", NULL},
        {"X unit: mm\n" INDEX, "mm", NULL},
        {"x-unit mm\n" BLANK, "mm", NULL},
        {"Lateral unit;mm\n0;1\n1;2\n2;1\n", "mm", NULL},
        {"spacing = 0.5\nX unit: mm\n" ONE, "mm", NULL},
        {"dx [mm] = 0.5\n" ONE, "mm", NULL},
        {"Scan length [mm]: 2\nspacing 0.5 um\n" ONE, "um", NULL},
        {"Filter [mm]: 0.8\nspacing = 0.5\n" ONE, NULL, NULL},
        {"z unit: nm\n" COMMA, NULL, "nm"},
        {"Y unit: um\n" COMMA, NULL, "um"},
        {"Z units\tum\n" TAB, NULL, "um"},
        /* titles of one column */
        {"x [mm],z\n" COMMA, "mm", NULL},
        {"x,z [um]\n" COMMA, NULL, "um"},
        /* a unit of its own cell that may be anybody's */
        {"X: mm\n" BLANK, NULL, NULL},
        {"x,um\n" COMMA, NULL, NULL},
        {"spacing = 0.5\nX [mm]\n" ONE, NULL, NULL},
        {"units: mm, um\n" COMMA, NULL, NULL},
        {"Y unit: um\n" INDEX, NULL, "um"}, /* its second column is z */
        /* both */
        {"X unit: mm, Z unit: um\n" COMMA, "mm", "um"},
        {"x_unit: mm\nz_unit: um\n" COMMA, "mm", "um"},
        {"X unit: mm; Y unit: nm\n" COMMA, "mm", "nm"},
        {"x (unit: mm),z (unit: um)\n" COMMA, "mm", "um"},
        {"x units [mm],value units [um]\n" COMMA, "mm", "um"},
        {"mm,um\n" COMMA, "mm", "um"},
        {"XYUnits: mm\nZUnits: um\n" COMMA, "mm", "um"},
        {"unit: um\n" COMMA, "um", "um"},
        {"unit: um\nX unit: mm\n" COMMA, "mm", "um"},
        {"x [mm],z slope corrected [um]\n" COMMA, "mm", "um"},
        {"x [mm],height after slope removal [um]\n" COMMA, "mm", "um"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        /* what is not said the scene says, in a unit of its own */
        struct scan scan = read_good(rows[i].text, "in", "pm");
        if (strcmp(scan.x_unit, rows[i].x_unit ? rows[i].x_unit : "in") != 0 ||
            strcmp(scan.z_unit, rows[i].z_unit ? rows[i].z_unit : "pm") != 0)
            fail_msg("'%s' read with x in %s, z in %s", rows[i].text, scan.x_unit, scan.z_unit);
        scan_free(&scan);
        if (!rows[i].x_unit || !rows[i].z_unit)
            assert_refused_bytes(rows[i].text, strlen(rows[i].text), &no_units,
                                 rows[i].x_unit   ? "no unit for z; add `z_unit: um`"
                                 : rows[i].z_unit ? "no unit for x; add `x_unit: mm`"
                                                  : "no unit for x nor for z");
    }
    struct scan scan = read_good("unit: um\n" COMMA, "", "");
    assert_string_equal(scan.warnings[0], "the file names one unit for x and z alike, um");
    scan_free(&scan);
    scan = read_good("x [mm] y [um] z [nm]\n0 0 1\n1 0 2\n2 0 3\n0 1 4\n1 1 5\n2 1 7\n", "", "");
    assert_near(scan.dx_m, 1e-3, 1e-12);
    assert_near(scan.dy_m, 1e-6, 1e-12);
    scan_free(&scan);
}

static struct scan read_with(const char *text, const struct scan_options *options)
{
    struct scan scan;
    struct status status = {0};
    if (read_bytes(&scan, text, strlen(text), options, &status) != STATUS_OK)
        fail_msg("'%s' refused: %s", text, status.message);
    assert_sound(&scan);
    return scan;
}

static void refuse_with(const char *text, const struct scan_options *options, const char *expected)
{
    assert_refused_bytes(text, strlen(text), options, expected);
}

/* The trapezoidal rule is exact for slopes that are straight lines: dz/dx = s x gives z = s x^2 / 2. */
TEST_CASE(test_slopes)
{
    static const struct {
        const char *text, *z_unit; /* of the scene */
        double slope;              /* s in 1/m, times the x of the file in m */
    } rows[] = {
        {"x [mm],slope [urad]\n0,0\n1,2\n3,6\n7,14\n", "", 2e-3},
        {"x [mm],z [\xC2\xB5rad]\n0,0\n1,2\n3,6\n7,14\n", "", 2e-3},
        {"x [um],t [mrad]\n0,0\n1,2\n3,6\n7,14\n", "", 2e3},
        {"x [m],angle (rad)\n0,0\n1,2\n3,6\n7,14\n", "", 2},
        {"x [mm],tilt (deg)\n0,0\n1,2\n3,6\n7,14\n", "", 2e3 * M_PI / 180},
        {"x [mm],tilt (\xC2\xB0)\n0,0\n1,2\n3,6\n7,14\n", "", 2e3 * M_PI / 180},
        {"x [mm],angle/arcsec\n0,0\n1,2\n3,6\n7,14\n", "", 2e3 * M_PI / 180 / 3600},
        {"x [mm],error (um/mm)\n0,0\n1,2\n3,6\n7,14\n", "", 2},
        {"X unit: mm\nZ unit: microradians\n0,0\n1,2\n3,6\n7,14\n", "", 2e-3},
        {"x [mm],slope\n0,0\n1,2\n3,6\n7,14\n", "nrad", 2e-6},
        {"x [mm],dz/dx\n0,0\n1,2\n3,6\n7,14\n", "1", 2e3},
        {"quantity: slope\nx unit: mm\n0,0\n1,2\n3,6\n7,14\n", "mrad", 2},
        {"x [mm],q\n0,0\n1,2\n3,6\n7,14\n", "urad", 2e-3},
        {"spacing 1 mm\nSlope [urad]\n0\n2\n4\n6\n8\n10\n12\n14\n", "", 2e-3},
        {"x [mm],slope [urad]\n7,14\n3,6\n1,2\n0,0\n", "", 2e-3},
        {"x [mm],slope [urad]\n0,0\n1,2\n2,-9999\n3,6\n7,14\n", "", 2e-3},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct scan_options options = {.z_unit = rows[i].z_unit, .quantity = SCAN_SLOPE};
        struct scan scan = read_with(rows[i].text, &options);
        assert_int_equal(scan.quantity, SCAN_SLOPE);
        for (size_t k = 0; k < scan.nx; k++) {
            double x_m = scan_x(&scan, k);
            if (!isnan(scan.z_m[k]))
                assert_within(scan.z_m[k], rows[i].slope * x_m * x_m / 2, 1e-12 * rows[i].slope * x_m * x_m);
        }
        assert_int_equal(scan.missing, strstr(rows[i].text, "-9999") ? 1 : 0);
        assert_non_null(strstr(scan.warnings[scan.warning_count - 1], "integrated to heights by the trapezoidal rule"));
        scan_free(&scan);
        options.quantity = SCAN_HEIGHT;
        refuse_with(rows[i].text, &options, "a slope");
        refuse_with(rows[i].text, &options, "to integrate it add `quantity: slope` to this surface in scene.yaml");
    }
}

/* What lengths a scan may have holds for the heights that slopes give, not for the slopes. */
TEST_CASE(test_absurd_slopes)
{
    struct scan_options slope = {.quantity = SCAN_SLOPE};
    refuse_with("x [m],z [rad]\n0,0\n1e25,1e25\n2e25,-3e25\n3e25,1e25\n", &slope,
                "heights of 1.5e+50 m; allowed is 1e-30 to 1e+30 m");
    refuse_with("x [m],z [rad]\n0,0\n1e-20,1e-20\n2e-20,-1e-20\n3e-20,0\n", &slope, "heights of 5e-41 m");
    refuse_with("x [m],z [rad]\n0,1e308\n1e10,1e308\n2e10,-1e308\n3e10,0\n", &slope,
                "the height of point 2 is infinite");
    struct scan scan = read_with("x [m],z [rad]\n0,0\n1e3,1e-32\n2e3,1e-32\n3e3,0\n", &slope);
    assert_near(scan.z_m[3], 2e-29, 1e-14);
    scan_free(&scan);
}

TEST_CASE(test_slopes_refused)
{
    struct scan_options slope = {.quantity = SCAN_SLOPE}, urad = {.z_unit = "urad", .quantity = SCAN_SLOPE},
                        um = {.z_unit = "um", .quantity = SCAN_SLOPE}, height = {.x_unit = "mm", .z_unit = "um"};
    refuse_with("x [mm],z [um]\n" COMMA, &urad, "column 2 has heights in um, not slopes; remove `quantity: slope`");
    refuse_with("x [mm],slope\n" COMMA, &slope, "no unit for z; add `z_unit: urad`");
    refuse_with("x [mm],slope\n" COMMA, &um, "'um' is no unit of slope; give z_unit as rad, mrad, urad");
    refuse_with("x [mm],slope [um]\n" COMMA, &height, "column 2 is a slope in um, not heights");
    refuse_with("x [um] y [um] z [urad]\n0 0 1\n1 0 2\n2 0 3\n0 1 4\n1 1 5\n2 1 7\n", &slope, "a map of slopes");
    refuse_with("aISO-1.0\nNumPoints = 4\nNumProfiles = 1\nXscale = 1E-6\nYscale = 1E-6\nZscale = 1E-6\n"
                "Compression = 0\nDataType = 7\nCheckType = 0\n*\n1\n2\n3\n1\n",
                &slope, "a file of format sdf has heights, not slopes");
}

#define FIVE                                                                                                           \
    "X (mm)\tA (nm)\tHeight (nm)\tB (nm)\tB (um)\n0\t1\t10\t7\t1\n1\t2\t30\t8\t1\n2\t3\tNaN\t9\t1\n3\t1\t40\t7\t2\n"
#define TWO "X (mm)\tA (nm)\tHeight (um)\n0\t1\t10\n1\t2\t30\n2\t3\t20\n3\t1\t40\n"

TEST_CASE(test_columns)
{
    static const struct {
        const char *text;
        size_t x, z;
        double dx_m, last_m;
    } rows[] = {
        {TWO, 0, 2, 1e-3, 1e-9},
        {TWO, 0, 3, 1e-3, 40e-6},
        {TWO, 1, 3, 1e-3, 40e-6},
        {FIVE, 0, 4, 1e-3, 7e-9}, /* a missing point of another column is nobody's */
        {"spacing 0.5 um\n1\n2\n3\n4\n", 0, 1, 0.5e-6, 4e-6},
        {"spacing 0.5 um\n1 7\n2 8\n1 9\n3 7\n", 0, 2, 0.5e-6, 7e-6}, /* no x: the spacing */
        {"spacing 0.5 um\n1 7\n2 8\n1 9\n3 7\n", 0, 1, 0.5e-6, 3e-6},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct scan_options options = {.x_unit = "mm", .z_unit = "um", .x_column = rows[i].x, .z_column = rows[i].z};
        struct scan scan = read_with(rows[i].text, &options);
        assert_int_equal(scan.kind, SCAN_PROFILE);
        assert_near(scan.dx_m, rows[i].dx_m, 1e-12);
        assert_near(scan.z_m[scan.nx - 1], rows[i].last_m, 1e-12);
        scan_free(&scan);
    }
    struct scan gapped = {.nx = 0};
    struct status status = {0};
    struct scan_options gap = {.z_column = 3};
    assert_int_equal(read_bytes(&gapped, FIVE, strlen(FIVE), &gap, &status), STATUS_OK);
    assert_int_equal(gapped.missing, 1);
    assert_true(isnan(gapped.z_m[2]));
    scan_free(&gapped);
    struct scan_options six = {.z_column = 6}, same = {.x_column = 2, .z_column = 2}, first = {.z_column = 1},
                        two = {.x_unit = "mm", .z_unit = "um", .z_column = 2};
    refuse_with(FIVE, &six, "file:2: there is no column 6: there are 5 columns");
    refuse_with(FIVE, &same, "column 2 cannot be x and z");
    refuse_with(FIVE, &first, "column 1 cannot be x and z; choose both, as in `column: [1, 2]`");
    refuse_with("spacing 0.5 um\n1\n2\n3\n4\n", &two, "there is no column 2: there is 1 column");
    refuse_with("aISO-1.0\nNumPoints = 4\nNumProfiles = 1\nXscale = 1E-6\nYscale = 1E-6\nZscale = 1E-6\n"
                "Compression = 0\nDataType = 7\nCheckType = 0\n*\n1\n2\n3\n1\n",
                &two, "a file of format sdf has no columns to choose from; remove `column`");
}

static const struct directory *folder;

#define IN_FOLDER(name) TEST_WITH(name, directory_setup, directory_teardown)

/* Reads s.dat of the folder; the message is in `status` where it is refused. */
static enum status_code take(struct scan *scan, const struct scan_options *options, struct status *status)
{
    *status = (struct status){0};
    return scan_read(scan, directory_path(folder, "s.dat"), options, status);
}

/* Expects x in mm and z in nm; `sidecar` is the file that gave them, NULL for none. */
static void expect_units(const struct scan_options *options, const char *z_unit, const char *sidecar)
{
    struct scan scan;
    struct status status;
    if (take(&scan, options, &status) != STATUS_OK)
        fail_msg("%s, with %s", status.message, sidecar ? sidecar : "no sidecar");
    assert_string_equal(scan.x_unit, "mm");
    assert_string_equal(scan.z_unit, z_unit);
    if (sidecar) {
        char note[128];
        assert_non_null(scan.sidecar);
        assert_string_equal(strrchr(scan.sidecar, '/') + 1, sidecar);
        snprintf(note, sizeof note, "the sidecar '%s' gave the unit", sidecar);
        assert_non_null(strstr(scan.warnings[0], note));
    } else {
        assert_null(scan.sidecar);
    }
    scan_free(&scan);
}

static void expect_refusal(const struct scan_options *options, const char *message)
{
    struct scan scan;
    struct status status;
    assert_int_equal(take(&scan, options, &status), STATUS_SCAN);
    if (!strstr(status.message, message))
        fail_msg("'%s' should hold '%s'", status.message, message);
    scan_free(&scan);
}

IN_FOLDER(test_sidecars)
{
    folder = *state;
    static const struct {
        const char *name, *content;
    } good[] = {
        {"s.txt", "Instrument: none\nx unit: mm\nz unit: nm\n"},
        {"s.hdr", "# x_unit = mm\n# z_unit = nm\n"},
        {"s.dat.txt", "X unit: mm\nY unit: nm\n"},
        {"s.json", "{\"x_unit\": \"mm\", \"z_unit\": \"nm\", \"operator\": 7}"},
        {"s.dat.json", "\n {\"X1_FACTOR\": 0.001, \"Y1_FACTOR\": 1e-09, \"FILE_FORMAT\": 2}"},
        {"s.txt", "{\"X1_FACTOR\": 0.001, \"Y1_FACTOR\": 1e-9, \"PLOT_TITLE_Y1\": \"Height (um)\"}"},
    };
    static const struct {
        const char *name, *content;
    } bad[] = {
        {"s.txt", "x unit: mm\nz unit: nm\n0 1\n1 2\n"}, /* a scan */
        {"s.txt", "measured by hand\n"},
        {"s.csv", "x unit: mm\nz unit: nm\n"},
        {"t.txt", "x unit: mm\nz unit: nm\n"},
        {"s.json", "{\"x_unit\": \"mm\", \"z_unit\": \"nm\""},
        {"s.json", "{\"X1_FACTOR\": 0.001, \"Y1_FACTOR\": 1e-9}"}, /* heights or slopes? */
        {"s.json", "{\"X1_FACTOR\": 0.001, \"Y1_FACTOR\": 3.3e-9, \"FILE_FORMAT\": 2}"},
    };
    directory_write(folder, "s.dat", BLANK);
    expect_refusal(&no_units, "no unit for x nor for z");
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        directory_write(folder, good[i].name, good[i].content);
        expect_units(&no_units, "nm", good[i].name);
        remove(directory_path(folder, good[i].name));
    }
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        directory_write(folder, bad[i].name, bad[i].content);
        expect_refusal(&no_units, "no unit for");
        remove(directory_path(folder, bad[i].name));
    }
    /* before the scene, behind the file */
    struct scan_options scene = {.x_unit = "mm", .z_unit = "um"};
    struct scan scan;
    struct status status;
    directory_write(folder, "s.txt", "z unit: nm\n");
    expect_units(&scene, "nm", "s.txt");
    assert_int_equal(take(&scan, &scene, &status), STATUS_OK);
    assert_string_equal(scan.warnings[1],
                        "the file or its sidecar names its z unit, nm: the scene's z_unit is not used");
    scan_free(&scan);
    directory_write(folder, "s.dat", "x [mm] z [pm]\n" BLANK);
    expect_units(&scene, "pm", NULL);
    directory_write(folder, "s.dat", "X unit: mm\n" BLANK);
    expect_units(&no_units, "nm", "s.txt");
}

static const char dabam[] = "{\"FILE_FORMAT\": 1, \"X1_FACTOR\": 0.001, \"Y1_FACTOR\": 1e-06, \"Y2_FACTOR\": 1e-09,\n"
                            "\"PLOT_TITLE_Y2\": \"Height (um)\", \"Y3_FACTOR\": 0.001,\n"
                            "\"PLOT_TITLE_Y3\": \"Residual slope (um)\"}\n";

IN_FOLDER(test_dabam)
{
    folder = *state;
    struct scan_options slope = {.quantity = SCAN_SLOPE}, second = {.z_column = 3},
                        third = {.z_column = 4, .quantity = SCAN_SLOPE}, um = {.z_unit = "um"},
                        second_slope = {.z_column = 3, .quantity = SCAN_SLOPE};
    directory_write(folder, "s.dat", "0 0 5 0\n1 2 6 4\n2 4 7 8\n3 6 9 12\n");
    directory_write(folder, "s.txt", dabam);
    expect_refusal(&no_units, "column 2 is a slope in urad, not heights; to integrate it add `quantity: slope`");
    expect_refusal(&um, "column 2 is a slope in urad, not heights");
    expect_refusal(&second_slope, "column 3 has heights in nm, not slopes");
    expect_units(&slope, "urad", "s.txt");
    expect_units(&second, "nm", "s.txt");
    expect_units(&third, "mrad", "s.txt");
    struct scan scan;
    struct status status;
    assert_int_equal(take(&scan, &slope, &status), STATUS_OK);
    for (size_t i = 0; i < 4; i++) /* 2 urad per mm */
        assert_within(scan.z_m[i], 1e-9 * (double)(i * i), 1e-22);
    scan_free(&scan);
    /* pairs of columns, each y with an x of its own */
    struct scan_options pair = {.x_column = 3, .z_column = 4};
    directory_write(folder, "s.dat", "0 0 0 1\n1 2 1 2\n2 4 2 3\n3 6 3 4\n");
    directory_write(
        folder, "s.txt",
        "{\"FILE_FORMAT\": 4, \"X1_FACTOR\": 1, \"Y1_FACTOR\": 1, \"X2_FACTOR\": 0.001, \"Y2_FACTOR\": 1e-10,\n"
        "\"PLOT_TITLE_Y2\": \"heights\"}");
    expect_units(&pair, "A", "s.txt");
    /* numbers as strings */
    directory_write(folder, "s.txt", "{\"FILE_FORMAT\": \"2\", \"X1_FACTOR\": \"1e-3\", \"Y1_FACTOR\": 1e-9}");
    directory_write(folder, "s.dat", BLANK);
    expect_units(&no_units, "nm", "s.txt");
}
