/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which scans count as copies of an earlier one. */
#include "members/copies.h"

#include "support.h"

enum { POINTS = 500 };

static double height_m[POINTS];

static struct scan scan_of(double scale, double offset_m, double step_m, unsigned seed, size_t shift)
{
    for (size_t i = 0; i < POINTS; i++) {
        const double k = (double)(i + shift), own = sin(0.11 * k + seed) + 0.3 * sin(1.7 * k * (1 + 0.1 * seed)) +
                                                    0.05 * sin(k * k * 0.37 + seed);
        height_m[i] = scale * 1e-6 * own + offset_m;
        height_m[i] = step_m > 0 ? step_m * round(height_m[i] / step_m) : height_m[i];
    }
    return (struct scan){.nx = POINTS, .ny = 1, .dx_m = 1e-6, .z_m = height_m};
}

static const char *find(struct copies *copies, struct scan scan, const char *file)
{
    const char *of;
    expect_ok(copies_find, &of, copies, &scan, file);
    return of;
}

/* With an offset or fine rounding a scan is still a copy; with other heights, another place, scale, spacing or length,
 * or coarse rounding, it is not. */
TEST_CASE(what_a_copy_is)
{
    struct copies copies = {0};
    assert_null(find(&copies, scan_of(1, 0, 0, 1, 0), "first"));
    assert_string_equal(find(&copies, scan_of(1, 0, 0, 1, 0), "again"), "first");
    assert_string_equal(find(&copies, scan_of(1, 3e-3, 0, 1, 0), "offset"), "first");
    assert_string_equal(find(&copies, scan_of(1, 0, 2e-8, 1, 0), "rounded"), "first");
    assert_null(find(&copies, scan_of(1, 0, 5e-7, 1, 0), "coarse"));
    assert_null(find(&copies, scan_of(1, 0, 0, 2, 0), "other"));
    assert_null(find(&copies, scan_of(1, 0, 0, 1, 7), "shifted"));
    assert_null(find(&copies, scan_of(1.01, 0, 0, 1, 0), "larger"));
    struct scan finer = scan_of(1, 0, 0, 1, 0), shorter = finer;
    finer.dx_m *= 1.01;
    shorter.nx--;
    assert_null(find(&copies, finer, "finer"));
    assert_null(find(&copies, shorter, "shorter"));
    struct scan gapped = scan_of(1, 0, 0, 1, 0);
    gapped.z_m[0] = NAN;
    assert_null(find(&copies, gapped, "gapped"));
    assert_string_equal(find(&copies, gapped, "gapped again"), "gapped");
    copies_free(&copies);
}
