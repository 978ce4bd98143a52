/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The collection of real scans against independently computed figures (tests/data/scan). */
#include "scan_support.h"

static struct scan read_real(const char *name, const char *x_unit, const char *z_unit)
{
    struct scan_options options = {.x_unit = x_unit, .z_unit = z_unit};
    struct scan scan;
    expect_ok(scan_read, &scan, filled("%s/%s", REAL_SCANS, name), &options);
    assert_sound(&scan);
    return scan;
}

/* tests/cli/test_inspection.c checks their other numbers. */
TEST_CASE(test_formats_and_ranges)
{
    NEED_REAL_SCANS();
    static const char *const tables[] = {"scan/profiles.csv", "scan/maps.csv"};
    for (size_t t = 0; t < 2; t++) {
        struct table table = table_read(tables[t]);
        for (size_t row = 0; row < table.rows; row++) {
            const char *name = table_text(&table, row, "file");
            print_message("%s\n", name);
            struct scan scan = read_real(name, table_text(&table, row, "x_unit"), table_text(&table, row, "z_unit"));
            assert_string_equal(scan.format, table_text(&table, row, "format"));
            double low = INFINITY, high = -INFINITY;
            for (size_t i = 0; i < scan.nx * scan.ny; i++) {
                low = fmin(low, scan.z_m[i]);
                high = fmax(high, scan.z_m[i]);
            }
            assert_near(low, table_number(&table, row, "zmin_um") * 1e-6, 1e-12);
            assert_near(high, table_number(&table, row, "zmax_um") * 1e-6, 1e-12);
            if (t == 0 && scan.x_m)
                assert_within(scan.x_m[0], table_number(&table, row, "x0_um") * 1e-6, 1e-15);
            scan_free(&scan);
        }
    }
}

/* The same points in the list of main.xml and in a binary file with a mask. */
TEST_CASE(test_x3p_forms)
{
    NEED_REAL_SCANS();
    static const char *const pairs[][2] = {
        {"openGPS_ISO5436-sample1.x3p", "openGPS_ISO5436-sample1_bin.x3p"},
        {"openGPS_ISO5436-sample4.x3p", "openGPS_ISO5436-sample4_bin.x3p"},
    };
    for (size_t k = 0; k < 2; k++) {
        struct scan list = read_real(pairs[k][0], "", ""), binary = read_real(pairs[k][1], "", "");
        for (size_t i = 0; i < 16; i++) {
            assert_int_equal(isnan(list.z_m[i]) != 0, isnan(binary.z_m[i]) != 0);
            assert_true(isnan(list.z_m[i]) || list.z_m[i] == binary.z_m[i]);
        }
        assert_int_equal(list.warning_count + binary.warning_count, 0);
        scan_free(&list);
        scan_free(&binary);
    }
}

/* Files that are no scans, and a scan without units. */
TEST_CASE(test_refused)
{
    NEED_REAL_SCANS();
    static const char *const files[][2] = {
        {"dabam-013.txt", "not a scan"},
        {"MANIFEST.md", "not a scan"},
        {"reference.json", "not a scan"},
        {"WAAM Profile.txt", "`x_unit: mm` and `z_unit: um`"},
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct scan scan;
        expect_fails(STATUS_SCAN, files[i][1], scan_read, &scan, filled("%s/%s", REAL_SCANS, files[i][0]), &no_units);
        scan_free(&scan);
    }
}
