/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which unit a header gives to which axis, slopes refused, the choice of columns, and sidecars. */
#include "directory.h"
#include "hard_case.h"
#include "scan_support.h"

#define COMMA "0,1\n1,2\n2,3\n3,1\n"
#define TAB   "0\t1\n1\t2\n2\t3\n3\t1\n"
#define BLANK "0 1\n1 2\n2 3\n3 1\n"
#define INDEX "0 5 1\n1 5 2\n2 6 1\n3 5 1\n"
#define ONE   "1\n2\n3\n1\n"

HARD_CASES("Headers of scans")

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
        /* a unit in a cell of its own may be that of any column */
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
        /* the scene gives what the file does not, in other units */
        struct scan scan = read_good(rows[i].text, "in", "pm");
        if (strcmp(scan.x_unit, rows[i].x_unit ? rows[i].x_unit : "in") != 0 ||
            strcmp(scan.z_unit, rows[i].z_unit ? rows[i].z_unit : "pm") != 0)
            fail_msg("'%s' read with x in %s, z in %s", rows[i].text, scan.x_unit, scan.z_unit);
        hard_case("30 headers that name the unit of one axis, of both or of neither",
                  "µm are taken for mm, or the other axis's unit",
                  "what the header says; else what the scene says, else refused", "x wrong, as a factor less 1",
                  off_by(scan.dx_m, (strncmp(rows[i].text, "dx", 2) == 0 || strstr(rows[i].text, "spacing") ? 0.5 : 1) *
                                        (!rows[i].x_unit                     ? 0.0254
                                         : strcmp(rows[i].x_unit, "mm") == 0 ? 1e-3
                                                                             : 1e-6)),
                  1e-12);
        scan_free(&scan);
        if (!rows[i].x_unit || !rows[i].z_unit)
            refuse_with(rows[i].text, &no_units,
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

/* A column is known as slopes by its unit or its title, whatever unit the scene gives. */
TEST_CASE(test_slopes)
{
    struct scan slope;
    static const struct {
        const char *text, *z_unit; /* of the scene */
    } rows[] = {
        {"x [mm],z [\xC2\xB5rad]\n" COMMA, ""},
        {"x [um],t [mrad]\n" COMMA, "um"},
        {"x [m],angle (rad)\n" COMMA, ""},
        {"x [mm],tilt (deg)\n" COMMA, ""},
        {"x [mm],tilt (\xC2\xB0)\n" COMMA, ""},
        {"x [mm],angle/arcsec\n" COMMA, "um"},
        {"x [mm],error (um/mm)\n" COMMA, ""},
        {"X unit: mm\nZ unit: microradians\n" COMMA, ""},
        {"x [mm],slope\n" COMMA, "um"},
        {"x [mm],slope [um]\n" COMMA, "um"},
        {"x,slope\nmm,um\n" COMMA, ""},
        {"x [mm],dz/dx\n" COMMA, "um"},
        {"x [mm],q\n" COMMA, "urad"},
        {"spacing 1 mm\nSlope [urad]\n" ONE, ""},
        {"x [um] y [um] z [urad]\n0 0 1\n1 0 2\n2 0 3\n0 1 4\n1 1 5\n2 1 7\n", ""},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        hard_case("a column of slopes: µrad, °, dz/dx, um/mm, a title of slope", "slopes are taken for heights",
                  "refused, whatever unit the scene says", "read as heights",
                  read_bytes(&slope, rows[i].text, strlen(rows[i].text),
                             &(struct scan_options){.x_unit = "mm", .z_unit = rows[i].z_unit},
                             &(struct status){0}) == STATUS_OK,
                  0);
        refuse_with(rows[i].text, &(struct scan_options){.x_unit = "mm", .z_unit = rows[i].z_unit},
                    " is a slope, not heights; integrate it, or choose the heights by `column`");
    }
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
        {"9 0 5\n7 1 6\n5 2 7\n3 3 8\n", 2, 3, 1e-3, 8e-6},
        {FIVE, 0, 4, 1e-3, 7e-9}, /* points missing in another column do not count */
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
    struct scan_options gap = {.z_column = 3};
    expect_ok(read_bytes, &gapped, FIVE, strlen(FIVE), &gap);
    assert_int_equal(gapped.missing, 1);
    assert_true(isnan(gapped.z_m[2]));
    scan_free(&gapped);
    struct scan_options six = {.z_column = 6}, same = {.x_column = 2, .z_column = 2}, first = {.z_column = 1},
                        beyond = {.x_column = 1, .z_column = 6}, two = {.x_unit = "mm", .z_unit = "um", .z_column = 2};
    refuse_with(FIVE, &six, "file:2: there is no column 6: there are 5 columns");
    refuse_with(
        FIVE, &beyond,
        "file: no line of numbers in it: not a scan; where columns hold text choose others, as in `column: [2, 3]`");
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
        assert_non_null(scan.sidecar);
        assert_string_equal(strrchr(scan.sidecar, '/') + 1, sidecar);
        assert_non_null(strstr(scan.warnings[0], filled("the sidecar '%s' gave the unit", sidecar)));
    } else {
        assert_null(scan.sidecar);
    }
    scan_free(&scan);
}

static void expect_refusal(const struct scan_options *options, const char *message)
{
    struct scan scan;
    expect_fails(STATUS_SCAN, message, take, &scan, options);
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
        {"s.json", "{\"X1_FACTOR\": 0.001, \"Y1_FACTOR\": 1e-9, \"FILE_FORMAT\": 2"},
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
    /* a sidecar counts before the scene, and after the file */
    struct scan_options scene = {.x_unit = "mm", .z_unit = "um"};
    struct scan scan;
    directory_write(folder, "s.txt", "z unit: nm\n");
    expect_units(&scene, "nm", "s.txt");
    expect_ok(take, &scan, &scene);
    assert_string_equal(scan.warnings[1], "the file or its sidecar names its z unit, nm: the given z_unit is not used");
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
    struct scan_options second = {.z_column = 3}, third = {.z_column = 4}, um = {.z_unit = "um"};
    directory_write(folder, "s.dat", "0 0 5 0\n1 2 6 4\n2 4 7 8\n3 6 9 12\n");
    directory_write(folder, "s.txt", dabam);
    expect_refusal(&no_units, "z in column 2 is a slope, not heights");
    expect_refusal(&um, "z in column 2 is a slope, not heights");
    expect_units(&second, "nm", "s.txt");
    expect_refusal(&third, "z in column 4 is a slope, not heights");
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
