/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How long a report is said to take. */
#include "base/costs.h"
#include "results/results.h"
#include "support.h"

/* A surface's own work is one after the other, however many threads there are; a map's points are quicker, and its rows
 * are no scans. */
TEST_CASE(test_seconds)
{
    struct surface_record surfaces[2] = {{.summary = {.points = 10000000, .scans = 1, .usable = true}}};
    struct plan plan = {.running = 0};
    struct results results = {.plan = &plan, .surfaces = surfaces, .surface_count = 1, .load_count = 121};
    double one = 1e7 * costs.profile_point_s;
    assert_near(work_seconds(&results, 2), one + costs.report_s + costs.surface_s, 1e-9);
    assert_true(one > 10 && one < 20);
    results.surface_count = 2;
    surfaces[1] = surfaces[0];
    assert_near(work_seconds(&results, 2), one + costs.report_s + costs.surface_s, 1e-9);
    assert_near(work_seconds(&results, 1), 2 * (one + costs.surface_s) + costs.report_s, 1e-9);
    plan.models = 1;
    results.surface_count = 1;
    surfaces[0].summary = (struct surface_summary){.points = 4000, .scans = 4000, .usable = true, .map.nx = 4000};
    assert_true(work_seconds(&results, 1) < 1.6e7 * costs.map_point_s + 0.3);
}
