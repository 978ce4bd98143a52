/* The collection of real scans against independently computed figures (tests/data/scan/profiles.csv). */
#include "scan_support.h"

static void test_profiles(void **state)
{
    (void)state;
    NEED_REAL_SCANS();
    struct table table = table_read("scan/profiles.csv");
    for (size_t row = 0; row < table.rows; row++) {
        const char *name = table_text(&table, row, "file");
        print_message("%s\n", name);
        char path[4096];
        snprintf(path, sizeof path, "%s/%s", REAL_SCANS, name);
        struct scan_options options = {table_text(&table, row, "x_unit"), table_text(&table, row, "z_unit")};
        struct scan scan;
        struct status status = {0};
        if (scan_read(&scan, path, &options, &status) != STATUS_OK)
            fail_msg("%s", status.message);
        assert_sound(&scan);
        assert_int_equal(scan.kind, SCAN_PROFILE);
        assert_int_equal(scan.nx, (size_t)table_number(&table, row, "n"));
        assert_int_equal(scan.missing, (size_t)table_number(&table, row, "missing"));
        double length = table_number(&table, row, "len_um") * 1e-6, low, high;
        range_of(&scan, &low, &high);
        assert_near(scan_x(&scan, scan.nx - 1) - scan_x(&scan, 0), length, 1e-12);
        assert_near(scan.dx_m, length / (double)(scan.nx - 1), 1e-12);
        if (scan.x_m)
            assert_within(scan.x_m[0], table_number(&table, row, "x0_um") * 1e-6, 1e-15);
        assert_near(low, table_number(&table, row, "zmin_um") * 1e-6, 1e-12);
        assert_near(high, table_number(&table, row, "zmax_um") * 1e-6, 1e-12);
        assert_near(rq_of_profile(&scan), table_number(&table, row, "rq_um") * 1e-6, 1e-9);
        scan_free(&scan);
    }
    table_free(&table);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_profiles)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
