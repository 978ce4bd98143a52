/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measured areal maps. They are not part of the project; where they lie beside it, their direct solutions are compared
 * with reference numbers. */
#include "direct_support.h"

#include "direct/direct_map.h"
#include "direct/direct_quantities.h"
#include "scan/scan.h"
#include <unistd.h>

enum { LOADS = 3 };

/** A map of the table: its rows there, its heights made ready and its own solution. */
struct measured {
    const char *name;
    double load[LOADS];
    struct direct_map map;
    struct direct_point point[LOADS];
};

static void solve(struct direct_point *out, const double *height_m, const struct measured *measured)
{
    struct direct_contact contact;
    struct direct_ladder_def ladder = {measured->load, LOADS, INFINITY, 1e-6, true, NULL, false};
    expect_ok(direct_contact_make, &contact, height_m, &measured->map.grid);
    expect_ok(direct_ladder_run, out, &contact, &ladder);
    direct_contact_free(&contact);
}

/** False where the map is not there, or more than 200 points a side and nobody asks for slow tests. */
static bool take(struct measured *out, const struct table *table, size_t row)
{
    struct scan scan;
    *out = (struct measured){.name = table_text(table, row, "map")};
    const char *path = lasting("%s/../shared/scans/%s", PROJECT_SOURCE, out->name);
    if (access(path, R_OK) != 0 ||
        (table_number(table, row, "points_a_side") > 200 && !getenv("ROUGHCONTACT_SLOW_TESTS")))
        return false;
    for (size_t i = 0; i < LOADS; i++) {
        assert_string_equal(table_text(table, row + i, "map"), out->name);
        out->load[i] = table_number(table, row + i, "load_over_Ep");
    }
    expect_ok(scan_read, &scan, path, &(struct scan_options){0});
    double step = 0; /* the table's maps are all low-passed, which this makes sure of and leaves nothing of itself */
    for (size_t k = 1; k < scan.nx * scan.ny; k++)
        step = isnan(scan.z_m[k] - scan.z_m[k - 1]) ? step : hypot(step, (scan.z_m[k] - scan.z_m[k - 1]));
    step /= sqrt((double)(scan.nx * scan.ny));
    for (size_t k = 0; k < scan.nx * scan.ny; k++)
        scan.z_m[k] += (k % scan.nx + k / scan.nx) % 2 ? step / 4 : -step / 4;
    struct direct_map_def def = {scan.nx, scan.ny, scan.dx_m, scan.dy_m, false, 0, false, false};
    expect_ok(direct_map_condition, scan.z_m, &def, false);
    expect_ok(direct_map_make, &out->map, scan.z_m, &def, 400);
    scan_free(&scan);
    solve(out->point, out->map.height_m, out);
    return true;
}

/** Area within 6 %, gap and constriction within 5 %: the table fills holes before its filter, this after. */
TEST_CASE(maps_as_known)
{
    struct table table = table_read("golden/direct/real_maps.csv");
    size_t found = 0;
    assert_int_equal(table.rows, 4 * LOADS);
    for (size_t row = 0; row < table.rows; row += LOADS) {
        struct measured measured;
        if (!take(&measured, &table, row))
            continue;
        assert_cell((double)measured.map.grid.nx, table, row, "points_a_side", 0);
        assert_cell(measured.map.grid.spacing_m, table, row, "spacing_m", 1e-5);
        for (size_t i = 0; i < LOADS; i++) {
            const struct direct_point *point = &measured.point[i];
            assert_near(point->quantities.area_ratio, table_number(&table, row + i, "area_ratio"), 0.06);
            assert_near(point->quantities.gap_m, table_number(&table, row + i, "gap_m"), 0.05);
            assert_near(point->constriction_m, table_number(&table, row + i, "constriction_length_m"), 0.05);
        }
        direct_map_free(&measured.map);
        found++;
    }
    if (found == 0)
        skip();
}
