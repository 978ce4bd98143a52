/* SPDX-License-Identifier: GPL-3.0-or-later */
/* CMY's resistance against the direct solution of the very islands it speaks of: what of a Gaussian surface lies above
 * a plane. Its islands are round and evenly spread, those of a surface are neither. */
#include "contact/cmy.h"
#include "contact/model.h"
#include "direct_support.h"

#include <gsl/gsl_sort.h>
#include <stdio.h>

enum { SIDE = 512 };

/** Waves r = low ... SIDE/16 in the cell, of variance r^-slope: at least 16 points a wave. */
struct band {
    double low, slope;
};

static double variance(double r, const void *context)
{
    const struct band *band = context;
    return r >= band->low && r <= SIDE / 16 ? pow(r, -band->slope) : 0;
}

/** Constriction length of what is above the plane, taking every `step`-th point; the cell is 1 m long. */
static double constriction_above(const double *height_m, double plane_m, size_t step)
{
    size_t side = SIDE / step, iterations;
    uint8_t *drawing = support_room(side * side);
    for (size_t k = 0; k < side * side; k++)
        drawing[k] = height_m[(k / side * SIDE + k % side) * step] > plane_m;
    return constriction_of_drawing(drawing, side, &iterations);
}

/** "resistance LOW to HIGH of direct solutions": on all of these with ten spots or more, and no narrower range of one
 * decimal would do. */
TEST_CASE(the_stated_range_holds)
{
    static const struct band bands[] = {{8, 3.6}, {4, 3.6}, {2, 3.6}, {4, 2}};
    static const double areas[] = {0.01, 0.03, 0.1};
    double low, high, least = INFINITY, most = 0;
    const char *valid = strstr(model_rows[model_named("cmy")]->valid, "resistance ");
    assert_non_null(valid);
    assert_int_equal(sscanf(valid, "resistance %lf to %lf of direct solutions", &low, &high), 2);
    double *height_m = support_room(SIDE * SIDE * sizeof *height_m),
           *sorted_m = support_room(SIDE * SIDE * sizeof *sorted_m);
    for (size_t b = 0; b < sizeof bands / sizeof *bands; b++)
        for (uint64_t seed = 1; seed <= 2; seed++) {
            double m0 = 0, m2 = 0;
            expect_ok(direct_surface_make, height_m, SIDE, &(struct direct_recipe){variance, &bands[b], NULL, 0}, seed);
            for (int i = -SIDE / 2; i < SIDE / 2; i++)
                for (int j = -SIDE / 2; j < SIDE / 2; j++) {
                    double power = variance(hypot(i, j), &bands[b]);
                    m0 += power;
                    m2 += power * 4 * M_PI * M_PI * i * i;
                }
            memcpy(sorted_m, height_m, SIDE * SIDE * sizeof *height_m);
            gsl_sort(sorted_m, 1, SIDE * SIDE);
            struct cmy law = {sqrt(m0), cmy_slope(m2)};
            for (size_t a = 0; a < sizeof areas / sizeof *areas; a++) {
                struct cmy_contact contact;
                assert_true(cmy_press(&contact, &law, areas[a]));
                if (contact.spot_density_per_m2 < 10)
                    continue;
                double plane_m = sorted_m[SIDE * SIDE - 1 - (size_t)(areas[a] * SIDE * SIDE)];
                double fine_m = constriction_above(height_m, plane_m, 1),
                       coarse_m = constriction_above(height_m, plane_m, 2);
                /* ECR A_n = 2 rho l, and the error falls as the spacing */
                double ratio = law.sigma_m / law.slope / contact.conductance / (2 * (2 * fine_m - coarse_m));
                assert_near(coarse_m, fine_m, 0.05);
                least = fmin(least, ratio);
                most = fmax(most, ratio);
            }
        }
    assert_near(floor(least * 10) / 10, low, 1e-12);
    assert_near(ceil(most * 10) / 10, high, 1e-12);
}
