/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Instrument formats that are text. */
#include "sample_support.h"

#define MAHR_HEAD                                                                                                      \
    "[PROFILE_HEADER]\r\nNAME=c:\\x.prf\r\nINTERVAL_LIN=0.0005\r\nNO_POINTS=6\r\n[PROFILE_VALUES]\r\n// "              \
    "X,Y,Z,C,Lock\r\n"
#define MAHR_POINTS                                                                                                    \
    "0=0.0000 0 0.0005 0 0\r\n1=0.0005 0 -0.00125 0 0\r\n2=0.0010 0 0.00275 0 0\r\n3=0.0015 0 0.000125 0 0\r\n"        \
    "4=0.0020 0 0.008 0 0\r\n"
#define MAHR_LAST "5=0.0025 0 -0.0035 0 0\r\n"

/* of a MarSurf PS 10: some points are locked, which is no height */
#define MAHR_HEAD_BARE(keys) "[PROFILE_HEADER]\n" keys "NO_POINTS=6\n[PROFILE_VALUES]\n"
#define MAHR_BARE                                                                                                      \
    "0=0.0000 0.0005 0\n1=0.0005 -0.00125 1\n2=0.0010 0.00275 1\n3=0.0015 0.000125 0\n4=0.0020 0.008 0\n"              \
    "5=0.0025 -0.0035 0\n"
#define MAHR_TURNED                                                                                                    \
    "0=0.0005 0 0.0000\n1=-0.00125 1 0.0005\n2=0.00275 1 0.0010\n3=0.000125 0 0.0015\n4=0.008 0 0.0020\n"              \
    "5=-0.0035 0 0.0025\n"
#define MAHR_COMMAS                                                                                                    \
    "0=0,0000 0,0005 0\n1=0,0005 -0,00125 1\n2=0,0010 0,00275 0\n3=0,0015 0,000125 1\n4=0,0020 0,008 0\n"              \
    "5=0,0025 -0,0035 0\n"

#define NPL_HEAD                                                                                                       \
    "1 2\r\nSAMPLE 0 PRF\r\nCX M 6.0e+000 MM 1.0e+000 D\r\nCZ M 6.0e+000 UM 1.0e-003 L\r\nEOR\r\n"                     \
    "STYLUS_RADIUS 0 MM\r\nSPACING CX 5.0e-004\r\nEOR\r\n"
#define NPL_POINTS "500\r\n-1250\r\n2750\r\n125\r\n8000\r\n-3500\r\n"

#define SDF_HEAD(points, profiles)                                                                                     \
    "aISO-1.0\nManufacID = X\nNumPoints = " points "\nNumProfiles = " profiles                                         \
    "\nXscale = 0.5E-6\nYscale = 2.0E-6\nZscale = 1.0E-6\nCompression = 0\nDataType = 7\nCheckType = 0\n*\n"

#define NIST(block)                                                                                                    \
    "<?xml version='1.0'?>\n<DATA>\n<DATAFILE>\n<UNITS>um</UNITS>\n<NUMPOINTS>6</NUMPOINTS>\n<SPACING>0.5</SPACING>\n" \
    "<DATA_POINT_VALUES>" block "</DATA_POINT_VALUES>\n</DATAFILE><WAVINESS><UNITS/></WAVINESS></DATA>\n"
#define NIST_OTHER(kind) "</DATA_POINT_VALUES>\n<" kind "_DATA_POINT_VALUES>" POINTS "</" kind "_DATA_POINT_VALUES>\n"
#define POINTS           "0.5\n-1.25\n2.75\n0.125\n8.0\n-3.5\n"

/* SMD fields end in NUL, records in ETX; a string literal cannot be cut at a NUL, so they are set here as '@' and '$'.
 */
#define SMD_HEAD                                                                                                       \
    "ISO 5436-2:2012@x@\r\nPRF@ 1 ISO5436@\r\nCX@ I@ 6 mm@ 1.0e0 D@ 5.0e-4 \r\nCZ@ A@ 6 um@ 1.0e0 D@\r\n$\r\n"         \
    "DATE: today@\r\n$\r\n"

static struct text smd(const char *pattern)
{
    struct text text = {0};
    for (; *pattern; pattern++)
        text_add_bytes(&text, *pattern == '@' ? "\0" : *pattern == '$' ? "\3" : pattern, 1);
    return text;
}

TEST_CASE(test_profiles)
{
    static const struct {
        const char *format, *text;
        size_t missing;
    } samples[] = {
        {"mahr-text", MAHR_HEAD MAHR_POINTS MAHR_LAST, SAMPLE_POINTS},
        {"mahr-text", MAHR_HEAD MAHR_POINTS MAHR_LAST "[END]\r\nx\r\n", SAMPLE_POINTS},
        {"mahr-text", MAHR_HEAD_BARE("") MAHR_BARE, SAMPLE_POINTS}, /* x z lock, as no comment names them */
        {"mahr-text", MAHR_HEAD_BARE("PRETRAV_LIN=0.0\nPOSTTRAV_LIN=0,0\n") MAHR_COMMAS, SAMPLE_POINTS},
        {"mahr-text", MAHR_HEAD_BARE("") "// Z, Lock, X\n" MAHR_TURNED, SAMPLE_POINTS},
        {"npl-prf", NPL_HEAD NPL_POINTS "EOR\r\nEOF\r\n", SAMPLE_POINTS},
        {"sdf", SDF_HEAD("6", "1") "0.5 -1.25\n2.75 0.125 8.0 -3.5\n*\n< a > b\n*\n", SAMPLE_POINTS},
        {"sdf", SDF_HEAD("6", "1") POINTS, SAMPLE_POINTS},
        {"sdf", SDF_HEAD("6", "1") "0.5 BAD 2.75 0.125 8.0 -3.5\n*\n", 1},
        {"nist-xml (DATA_POINT_VALUES)", NIST(POINTS), SAMPLE_POINTS},
        {"nist-xml (ROUGHNESS_DATA_POINT_VALUES)", NIST(NIST_OTHER("ROUGHNESS")), SAMPLE_POINTS},
        {"nist-xml (WAVINESS_DATA_POINT_VALUES)", NIST(NIST_OTHER("WAVINESS")), SAMPLE_POINTS},
        {"dektak",
         "Scan Parameters\r\r\nScan Type,Standard\r\r\nStylus,Radius: 2.5 \xB5m\r\nResolution,0.5 um/sample\r\n\r\r\n"
         "Scan Data\r\r\nLateral um,Raw "
         "Micrometer,\r\n0.0,0.5,,\r\n0.5,-1.25,,\r\n1.0,2.75,,\r\n1.5,0.125,,\r\n2.0,8,,\r\n"
         "2.5,-3.5,,\r\n\r\r\n",
         SAMPLE_POINTS},
        {"hommel",
         "X;Y;valid\n[mm];[mm];[1/0]\n0;0.0005;1\n0.0005;-0.00125;1\n0.001;0.00275;1\n0.0015;77;0\n0.002;0.008;1\n"
         "0.0025;-0.0035;1\n",
         3},
        {"accretech", "0.0025\n6\n" POINTS, SAMPLE_POINTS},
    };
    for (size_t i = 0; i < sizeof samples / sizeof *samples; i++)
        assert_text_sample(samples[i].text, samples[i].format, SCAN_PROFILE, samples[i].missing, &no_units);
    expect_sample(smd(SMD_HEAD "0.5\r\n-1.25\r\nBAD\r\n0.125\r\n8.0\r\n-3.5\r\n$\r\n1234\r\n$\r\n\x1a"), "smd",
                  SCAN_PROFILE, 2, &no_units);
}

TEST_CASE(test_maps)
{
    struct scan_options um = {.x_unit = "um", .z_unit = "um"}, z_um = {.z_unit = "um"};
    assert_text_sample(SDF_HEAD("3", "2") "0.5 -1.25 2.75\n0.125 NaN -3.5\n*\n*\n", "sdf", SCAN_AREAL, 4, &no_units);
    assert_text_sample("DSAA\n3 2\n10 11\n5 7\n-4 8\n0.5 -1.25 1.70141e+038\n\n0.125 8.0 -3.5\n", "surfer", SCAN_AREAL,
                       2, &um);
    /* x y z point by point: along x, along y, and from the far corner */
    assert_text_sample("0,0,0.5\n0.5,0,-1.25\n1,0,2.75\n\n0,2,0.125\n0.5,2,8\n1,2,-3.5\n\n\n", "text", SCAN_AREAL,
                       SAMPLE_POINTS, &um);
    assert_text_sample("x [um] y [um] z [um]\n0 0 0.5\n0 2 0.125\n0.5 0 -1.25\n0.5 2 8\n1 0 NaN\n1 2 -3.5\n", "text",
                       SCAN_AREAL, 2, &no_units);
    assert_text_sample("1 2 -3.5\n0.5 2 8\n0 2 0.125\n1 0 2.75\n0.5 0 -1.25\n0 0 0.5\n", "text", SCAN_AREAL,
                       SAMPLE_POINTS, &um);
    /* one run of such points is a profile */
    assert_text_sample("0 7 0.5\n0.5 7 -1.25\n1 7 2.75\n1.5 7 0.125\n2 7 8\n2.5 7 -3.5\n", "text", SCAN_PROFILE,
                       SAMPLE_POINTS, &um);
    static const struct {
        const char *text;
        size_t nx, ny, missing, point; /* a point, and: */
        double dx_m, dy_m, z_m;
    } matrices[] = {
        {"# pixel size = 0.5 um\n# value units: um\n1 2 3 4\n5 BAD 7 -9999\n9 8 7 6\n", 4, 3, 2, 4, 0.5e-6, 0.5e-6,
         5e-6},
        {"# Channel: Main\n# Width: 10 \xC2\xB5m\n# Height: 6 \xC2\xB5m\n# Value units: m\n"
         "1e-6\t3e-6\t2e-6\t4e-6\n5e-6\t6e-6\t7e-6\t8e-6\n",
         4, 2, 0, 7, 2.5e-6, 3e-6, 8e-6},
        {"w=4 h=3\npixel size = 2 um\nheight conversion factor (-> m) = 1e-9\n1 3 2 4\n5 5 5 5\n1 1 1 1\n", 4, 3, 0, 1,
         2e-6, 2e-6, 3e-9},
    };
    for (size_t i = 0; i < sizeof matrices / sizeof *matrices; i++) {
        struct scan scan = read_good(matrices[i].text, "", "");
        assert_int_equal(scan.kind, SCAN_AREAL);
        assert_int_equal(scan.nx, matrices[i].nx);
        assert_int_equal(scan.ny, matrices[i].ny);
        assert_int_equal(scan.missing, matrices[i].missing);
        assert_near(scan.dx_m, matrices[i].dx_m, 1e-12);
        assert_near(scan.dy_m, matrices[i].dy_m, 1e-12);
        assert_near(scan.z_m[matrices[i].point], matrices[i].z_m, 1e-12);
        scan_free(&scan);
    }
    assert_refused_bytes("1 3 2 4\n5 1 3 1\n1 1 1 1\n", 24, &z_um, "without its pixel size; add a line `pixel size");
    assert_refused("0 0 1\n1 0 2\n2 0 3\n0 1 4\n1 1 5\n2.5 1 6\n", "file:6: this point is not on the grid");
    assert_refused("0 0 1\n1 0 2\n2 0 3\n0 1 4\n1 1 5\n0 2 1\n1 2 1\n2 2 1\n", "file:6: this point is not on the grid");
    assert_refused("0 0 1\n1 0 2\n2 0 3\n0 1 4\n1 1 5\n2 1 1\n0 2 1\n",
                   "file:7: the last row of points is not complete");
}

/* x y z as Gwyddion exports a map: metres, centres of pixels, five digits, so that places round by 2 % of a step. */
TEST_CASE(test_gwyddion_xyz)
{
    enum { NX = 512, NY = 4 };
    const double step_m = 1.3e-5 / NX;
    struct text *text = support_text();
    text_add(text, "# Channel: Topography\n# Lateral units: m\n# Value units: m\n");
    for (size_t i = 0; i < NX * NY; i++)
        text_add(text, "%.5g\t%.5g\t%.5g\n", ((double)(i % NX) + 0.5) * step_m, ((double)(i / NX) + 0.5) * step_m,
                 1e-9 * (double)(i * i % 101));
    struct scan scan = read_good(text_string(text), "", "");
    assert_int_equal(scan.nx, NX);
    assert_int_equal(scan.ny, NY);
    assert_near(scan.dx_m, step_m, 1e-4);
    assert_near(scan.dy_m, step_m, 1e-4);
    for (size_t i = 0; i < NX * NY; i++)
        assert_near(scan.z_m[i], 1e-9 * (double)(i * i % 101), 1e-4);
    scan_free(&scan);
    assert_refused("0 0 1\n1 0 2\n2.03 0 3\n3 0 4\n", "file:3: this point is not on the grid");
}

TEST_CASE(test_columns)
{
    struct scan_options um = {.x_unit = "um", .z_unit = "um"};
    /* an index before x, a time before x, columns behind z, heights that repeat */
    assert_text_sample("0\t0\t0.5\n1\t0.5\t-1.25\n2\t1\t2.75\n3\t1.5\t0.125\n4\t2\t8\n5\t2.5\t-3.5\n", "text",
                       SCAN_PROFILE, SAMPLE_POINTS, &um);
    assert_text_sample(
        "t [s];X (um);Z (um)\n0,1;0;0,5\n0,2;0,5;-1,25\n0,3;1;2,75\n0,4;1,5;0,125\n0,5;2;8\n0,6;2,5;-3,5\n", "text",
        SCAN_PROFILE, SAMPLE_POINTS, &no_units);
    assert_text_sample("x (um)\tz (um)\tslope\tq\n0\t0.5\t1\t1\n0.5\t-1.25\t1\t1\n1\t2.75\t1\t1\n1.5\t0.125\t1\t1\n"
                       "2\t8\t1\t1\n2.5\t-3.5\t1\t1\n",
                       "text", SCAN_PROFILE, SAMPLE_POINTS, &no_units);
    struct scan scan = read_good("0 5 1\n1 5 2\n2 6 1\n3 5 1\n", "um", "um");
    assert_int_equal(scan.kind, SCAN_PROFILE);
    assert_near(scan.z_m[2], 6e-6, 1e-12);
    assert_non_null(strstr(scan.warnings[0], "3 columns: column 1 read as x, column 2 as z"));
    scan_free(&scan);
}

/* The sample text in UTF-16, the lower byte first or last. */
static struct text utf16(const char *string, bool big)
{
    struct text text = {0};
    text_add_bytes(&text, big ? "\xFE\xFF" : "\xFF\xFE", 2);
    for (; *string; string++) {
        char pair[2] = {big ? '\0' : *string, big ? *string : '\0'};
        text_add_bytes(&text, pair, 2);
    }
    return text;
}

TEST_CASE(test_utf16)
{
    const char *string = "x (um);z (\xB5m)\r\n0;0,5\r\n0,5;-1,25\r\n1;2,75\r\n1,5;0,125\r\n2;8\r\n2,5;-3,5\r\n";
    for (int big = 0; big < 2; big++)
        expect_sample(utf16(string, big), "text", SCAN_PROFILE, SAMPLE_POINTS, &no_units);
    struct text half = utf16("0;1\n1;1", false);
    text_add_bytes(&half, "\x3D\xD8", 2);
    refuse_text(half, &no_units, "damaged UTF-16; save it as UTF-8");
}

#define WYKO_HEAD "Wyko ASCII Data File Format 0\t0\t1\nX Size\t3\nY Size\t2\nBlock Name\tType\tLength\tValue\n"
#define WYKO_ROWS "0.5 -1.25 2.75\n0.125 Bad -3.5\n"
#define ZYGO(kind)                                                                                                     \
    "Zygo " kind "\n1 9\n0 0 0 0 0 0\n0 0 3 2\n\"a\"\n\"\"\n\"\"\n0 0.5 4.096e-3 0.5 0.5 0 5e-7 17\n3 2\n0\n0 "        \
    "0\n0\n#\n"

/* Heights in waves, or in a unit of their own; a phase is a quarter of a micrometre here. */
TEST_CASE(test_interferometers)
{
    static const struct {
        const char *format, *text;
        double dy_m;
    } samples[] = {
        {"wyko",
         WYKO_HEAD "Pixel_size\t7\t4\t0.0005\nWavelength\t7\t4\t1000\nMult\t7\t4\t2\nRAW_DATA\t3\t48\t\n" WYKO_ROWS,
         5e-7},
        {"wyko", /* a line a column, and a block behind */
         WYKO_HEAD "Pixel_size\t7\t4\t0.0005\nWavelength\t7\t4\t1000\nRAW_DATA\t3\t48\t\n0.5 0.125\n-1.25 Bad\n2.75 "
                   "-3.5\nIntensity\t3\t48\n1 2 3\n",
         5e-7},
        {"wyko",
         WYKO_HEAD "Pixel_size\t7\t4\t0.0005\nAspect\t7\t4\t4\nWavelength\t7\t4\t77\nRAW DATA\t3\t48\tum\n" WYKO_ROWS,
         2e-6},
        {"zygo", ZYGO("ASCII Data File - Format 2") "1 2 3\n#\n2 -5 11\n0.5 2147483640 -14\n#\n", 5e-7},
        {"zygo", ZYGO("XYZ Data File - Format 1") "0 0 0.5\n1 0 -1.25\n2 0 2.75\n0 1 0.125\n1 1 No Data\n2 1 -3.5\n#\n",
         5e-7},
    };
    for (size_t k = 0; k < sizeof samples / sizeof *samples; k++) {
        struct scan scan = read_good(samples[k].text, "", "");
        assert_string_equal(scan.format, samples[k].format);
        assert_int_equal(scan.nx * scan.ny, SAMPLE_POINTS);
        assert_near(scan.dx_m, 5e-7, 1e-12);
        assert_near(scan.dy_m, samples[k].dy_m, 1e-12);
        assert_int_equal(scan.missing, 1);
        for (size_t i = 0; i < SAMPLE_POINTS; i++)
            if (i != 4)
                assert_near(scan.z_m[i], sample_um[i] * 1e-6, 1e-9);
        scan_free(&scan);
    }
    assert_refused(WYKO_HEAD "Wavelength\t7\t4\t500\nRAW_DATA\t3\t48\t\n" WYKO_ROWS, "no Pixel_size");
    assert_refused(WYKO_HEAD "Pixel_size\t7\t4\t0.1\nWavelength\t7\t4\t500\n", "no block RAW_DATA");
    assert_refused("Wyko ASCII Data File Format 0\nX Size\t100000\nY "
                   "Size\t100000\nPixel_size\t1\nWavelength\t500\nRAW_DATA\n1 2\n",
                   "the file ends after");
    assert_refused(ZYGO("ASCII Data File - Format 2") "#\n1 2 3\n", "the file ends after 3");
    assert_refused(ZYGO("XYZ Data File - Format 1") "3 0 1.00\n0 1 2.00\n1 1 2.00\n0 0 1.00\n1 0 1.00\n2 0 1.00\n#\n",
                   "is no line `column row height`");
    assert_refused("Zygo XYZ Data File - Format 1\n1\n", "the header is cut off");
    assert_refused("Zygo XYZ Data File - Format 1\n1\n2\n0 0 x 2\n", "file:4: no numbers of columns and rows");
}

/* Run-up and overtravel that the header names; where x descends they are exchanged with the ends. */
TEST_CASE(test_margins_of_mahr_text)
{
    struct scan scan = read_good(MAHR_HEAD_BARE("PRETRAV_LIN=0.0005\r\nPOSTTRAV_LIN=0,001\r\n") MAHR_BARE, "", "");
    assert_int_equal(scan.nx, 6);
    assert_within(scan.margin_m[0], 0.5e-6, 1e-18);
    assert_within(scan.margin_m[1], 1e-6, 1e-18);
    assert_int_equal(scan.warning_count, 0);
    scan_free(&scan);
    scan = read_good("[PROFILE_HEADER]\nPRETRAV_LIN=1\nPOSTTRAV_LIN=2\nNO_POINTS=3\n[PROFILE_VALUES]\n"
                     "0=3 0 0\n1=2 1 0\n2=0 0 0\n",
                     "", "");
    assert_near(scan.margin_m[0], 2e-3, 1e-12);
    assert_near(scan.margin_m[1], 1e-3, 1e-12);
    scan_free(&scan);
}

TEST_CASE(test_refusals)
{
    assert_refused(MAHR_HEAD MAHR_POINTS, "file:11: the points end after 5 of 6");
    assert_refused(MAHR_HEAD MAHR_POINTS MAHR_LAST MAHR_LAST, "file:13: more points than NO_POINTS says, 6");
    assert_refused(MAHR_HEAD "0=0.0000 0 nan 0 0\r\n" MAHR_POINTS, "file:7: '0=0.0000 0 nan 0 0' is no line");
    assert_refused(MAHR_HEAD_BARE("") "0=0 1 0\n1=1 2\n" MAHR_BARE,
                   "file:5: '1=1 2' is no line `index=x z ...` with as many fields");
    assert_refused(MAHR_HEAD "0=0 1 0\n" MAHR_POINTS,
                   "file:7: '0=0 1 0' is no line `index=x y z ...` with as many fields");
    assert_refused(MAHR_HEAD_BARE("PRETRAV_LIN=-1\n") MAHR_BARE, "file:2: PRETRAV_LIN is no length");
    assert_refused("[PROFILE_HEADER]\nNO_POINTS=1000000000000\n[PROFILE_VALUES]\n0=0 0 0 0 0\n",
                   "the file ends after 2;");
    assert_refused("[PROFILE_HEADER]\nNO_POINTS=x\n", "file:2: NO_POINTS is no number");
    assert_refused("[PROFILE_HEADER]\nNO_POINTS=3\n", "no section [PROFILE_VALUES]");
    assert_refused(NPL_HEAD "500\r\nx\r\n2750\r\n125\r\n8000\r\n-3500\r\n", "file:10: 'x' among the heights");
    assert_refused(NPL_HEAD NPL_POINTS "7\r\nEOR\r\n", "file:15: more heights than the header says");
    assert_refused(NPL_HEAD "500\r\n", "the header says 6 x 1 points");
    assert_refused("1 2\nx\nCX M 6 MM 1 D\nCZ M 6 UM 1 L\nEOR\nEOR\n1\n", "no CX, CZ or `SPACING CX`");
    assert_refused("1 2\nx\nCX M 6 V 1 D\n", "file:3: 'CX M 6 V 1 D' is not as PRF has it");
    assert_refused(SDF_HEAD("6", "1") "1 2 3 4 5 6 7\n", "file:12: more heights than the header says, 6 x 1");
    assert_refused(SDF_HEAD("6", "1") "1.00 2.00 3.00 4.00 5.00\n", "the heights end after 5 of 6");
    assert_refused(SDF_HEAD("99999", "99999") "1 2\n", "the header says 99999 x 99999 points, the file ends after 2");
    assert_refused(SDF_HEAD("6", "x") "1 2\n", "file:4: NumProfiles = 'x'");
    assert_refused("aISO-1.0\nNumPoints = 6\n", "no line `*`");
    assert_refused("aISO-1.0\nCompression = 1\nZscale=1\n*\n", "compressed SDF");
    assert_refused(NIST("0.5\n-1.25\nx\n0.125\n8.0\n-3.5\n"), "file:9: 'x' among the heights");
    assert_refused(NIST(POINTS "1\n"), "more heights than the header says, 6 x 1");
    assert_refused(NIST(" \n "), "no heights in <DATA_POINT_VALUES>");
    assert_refused("DSAA\n3 2\n10 11\n5 x\n", "file:4: 'x' in the header of the grid");
    assert_refused("DSAA\n3 2\n10 11\n5 7\n0 1\n1 2 3 4 5 6 7\n", "more heights than the header says");
    refuse_text(smd("ISO 5436-2:2012@x@\r\nPRF@ 1 ISO5436@\r\nCX@ A@ 6 mm@ 1.0e0 D@\r\nCZ@ A@ 6 um@ 1.0e0 D@\r\n$\r\n"
                    "$\r\n1 2 3 4 5 6$\r\n"),
                &no_units, "positions stored point by point");
}
