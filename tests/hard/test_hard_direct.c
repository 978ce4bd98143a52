/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The direct solution at its limits: one point and all in contact, a load at the hardness, a spike, exponents at both
 * ends, a coarse grid; and where it has no answer, none. */
#include "direct/direct_constriction.h"
#include "direct/direct_ensemble.h"
#include "direct/direct_support.h"
#include "hard_support.h"

HARD_CASES("Direct solutions")

/** Heights of a square surface, cell length 1, of a law cut off at `waves` waves. */
static double *surface_of(double gamma, double waves, size_t n, uint64_t seed)
{
    struct direct_law law = {1e-3, gamma, 1 / waves, 1, 1};
    struct direct_spectrum spectrum;
    double *height = support_room(n * n * sizeof *height);
    expect_ok(direct_spectrum_of_law, &spectrum, &law);
    expect_ok(direct_surface_make, height, n, &(struct direct_recipe){direct_spectrum_variance, &spectrum, NULL, 0},
              seed);
    direct_spectrum_free(&spectrum);
    return height;
}

/** One load by the ladder, to 1e-9; every number of it is one. */
static struct direct_point solved_at(struct direct_contact *contact, double load, double hardness)
{
    struct direct_ladder_def ladder = {&load, 1, hardness, 1e-9, true, NULL, false};
    struct direct_point point;
    expect_ok(direct_ladder_run, &point, contact, &ladder);
    const struct direct_quantities *q = &point.quantities;
    assert_true(point.exists && q->contact_points > 0 && point.patches > 0);
    assert_true(q->area_ratio >= 0 && q->area_ratio <= 1);
    assert_true(isfinite(q->gap_m) && q->gap_m >= 0);
    assert_true(isfinite(point.constriction_m) && point.constriction_m >= 0);
    return point;
}

static double highest(const double *height, size_t n)
{
    double mean = 0, most = -INFINITY;
    for (size_t k = 0; k < n * n; k++) {
        mean += height[k] / (double)(n * n);
        most = fmax(most, height[k]);
    }
    return most - mean;
}

/** Sum of 1/|q| over the modes of an n x n grid: a point's own potential under a mean current of 1. */
static double own_potential(size_t n)
{
    double sum = 0;
    for (size_t j = 0; j < n; j++)
        for (size_t i = 0; i < n; i++)
            if (i + j > 0)
                sum += 1 / (2 * M_PI * hypot((double)(i <= n / 2 ? i : n - i), (double)(j <= n / 2 ? j : n - j)));
    return sum;
}

/** The highest point alone: l = sum 1/|q|, and the planes are its height less 2 p̄ l apart. */
TEST_CASE(one_contact_point)
{
    static const double loads[] = {1e-100, 1e-30, 1e-12, 1e-9};
    for (size_t n = 16; n <= 64; n *= 2) {
        double *height = surface_of(1.3, 5, n, 1), top = highest(height, n), own = own_potential(n);
        struct direct_contact contact = contact_of(height, n, n);
        for (size_t i = 0; i < sizeof loads / sizeof *loads; i++) {
            struct direct_point point = solved_at(&contact, loads[i], INFINITY);
            assert_int_equal(point.quantities.contact_points, 1);
            assert_int_equal(point.quantities.perimeter_faces, 4);
            assert_int_equal(point.patches, 1);
            hard_case("one point in contact, loads of 1e-100 to 1e-9", "a contact of no area, resistance infinite",
                      "the point's own potential: the sum of 1/q over all waves", "constriction, relative",
                      off_by(point.constriction_m, own), 1e-11);
            hard_case("one point in contact: the gap", "the load of 1e-100 is lost in it", "the highest point's height",
                      "gap, relative", off_by(point.quantities.gap_m, top - 2 * loads[i] * own), 1e-11);
        }
        direct_contact_free(&contact);
    }
}

/** p = p̄ + |q|h/2 everywhere from p̄ = -min |q|h/2 on: no gap and no resistance there, both just below. */
TEST_CASE(complete_contact_from_both_sides)
{
    enum { N = 64 };
    double *height = surface_of(1.3, 10, N, 1), least = 0;
    struct direct_contact contact = contact_of(height, N, N);
    struct direct_kernel *kernel = &contact.kernel;
    memcpy(kernel->field, contact.height_m, N * kernel->stride * sizeof(double));
    direct_kernel_convolve(kernel, DIRECT_STIFFNESS, NULL);
    for (size_t j = 0; j < N; j++)
        for (size_t i = 0; i < N; i++)
            least = fmin(least, kernel->field[j * kernel->stride + i] / 2);
    for (int side = 0; side < 2; side++) {
        struct direct_point point = solved_at(&contact, -least * (side ? 1 + 1e-6 : 1 - 1e-3), INFINITY);
        if (side == 0) {
            assert_true(point.quantities.contact_points < (size_t)N * N && point.quantities.area_ratio < 1);
            assert_true(point.quantities.gap_m > 0 && point.constriction_m > 0);
        } else {
            assert_int_equal(point.quantities.contact_points, N * N);
            hard_case("all points in contact, from 1e-6 above the load of it", "a gap and a resistance of rounding",
                      "area 1, gap 0, resistance 0", "difference",
                      fabs(point.quantities.area_ratio - 1) + point.quantities.gap_m + point.constriction_m, 0);
            for (size_t k = 0; k < (size_t)N * kernel->stride; k++)
                if (k % kernel->stride < N)
                    assert_true(contact.pressure[k] > 0);
        }
    }
    direct_contact_free(&contact);
}

/** Up to the hardness: at least p̄/H in contact; from it on no number, but a sentence. */
TEST_CASE(load_at_the_hardness)
{
    enum { N = 32 };
    static const double hardness = 0.01, shares[] = {0.5, 0.9, 0.999, 1, 1 + 1e-15, 2, 1e10};
    double *height = surface_of(1.3, 5, N, 1);
    struct direct_contact contact = contact_of(height, N, N);
    for (size_t i = 0; i < sizeof shares / sizeof *shares; i++) {
        double load = shares[i] * hardness;
        struct direct_ladder_def ladder = {&load, 1, hardness, 1e-9, true, NULL, false};
        struct direct_contact_load one = {load, hardness, 1e-9, true, NULL};
        struct direct_point point;
        if (shares[i] < 1) {
            hard_case("a mean pressure of 0.5 to 0.999 of the hardness", "iterations between capped points without end",
                      "at least p̄/H of the area in contact", "area that is missing",
                      fmax(0, shares[i] - solved_at(&contact, load, hardness).quantities.area_ratio), 0);
            continue;
        }
        expect_ok(direct_ladder_run, &point, &contact, &ladder);
        hard_case("a mean pressure of 1 to 1e10 of the hardness", "more load than the material can carry",
                  "no number, and the sentence that contact is complete", "numbers", point.exists, 0);
        assert_true(isnan(point.constriction_m));
        assert_int_equal(point.quantities.contact_points, 0);
        expect_fails(STATUS_MODEL, "complete contact", direct_contact_solve, &contact, &one);
    }
    direct_contact_free(&contact);
}

/** Nothing, a plane, rounding only, roughness whose squares vanish, a hole, an infinite height. */
TEST_CASE(no_surface)
{
    enum { N = 16 };
    static const struct {
        double offset, rough, one;
        const char *says;
    } cases[] = {{0, 0, 0, "flat"},           {1e-6, 0, 1e-6, "flat"},         {1, 1e-16, 1, "flat"},
                 {0, 1e-200, 0, "flat"},      {0, 1e-6, NAN, "not finite"},    {0, 1e-6, INFINITY, "not finite"},
                 {0, 0, -INFINITY, "finite"}, {1e-6, 1e-9, NAN, "not finite"}, {0, 5e-324, 0, "flat"}};
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        double height[N * N];
        struct direct_contact contact;
        struct status status = {0};
        for (size_t k = 0; k < (size_t)N * N; k++)
            height[k] = cases[c].offset + cases[c].rough * (double)(k % 7);
        height[200] = cases[c].one;
        enum status_code code =
            direct_contact_make(&contact, height, &(struct direct_grid){N, N, 1.0 / N, false, false}, &status);
        hard_case("no surface: constant, 1e-16 or 1e-200 of roughness, 5e-324, holes, infinite heights",
                  "0/0 in the first step", "refused: flat, or not finite", "not refused", code != STATUS_MODEL, 0);
        if (!strstr(status.message, cases[c].says))
            fail_msg("case %zu: %s", c, status.message);
        assert_null(contact.height_m);
    }
}

/** Exponents at both ends: the area is about 2 p̄ over the root mean square gradient, the gap's slope is -2 l. */
TEST_CASE(exponents_at_both_ends)
{
    enum { N = 128 };
    static const double gammas[] = {0.5, 1, 2};
    for (size_t e = 0; e < 3; e++) {
        double *height = surface_of(gammas[e], 20, N, 3), gradient = 0, last = 0;
        struct direct_contact contact = contact_of(height, N, N);
        struct direct_law law = {1e-3, gammas[e], 1 / 20.0, 1, 1};
        for (size_t m = 1; m <= direct_law_harmonics(&law); m++) /* 2 m2 of the rows */
            gradient += pow(2 * M_PI * (double)m * direct_law_amplitude(&law, m), 2);
        gradient = sqrt(gradient);
        for (double p = 0.01; p < 0.2; p *= 2.5) { /* over the gradient */
            struct direct_point point = solved_at(&contact, p * gradient, INFINITY);
            struct direct_point low = solved_at(&contact, p * gradient * (1 - 1e-3), INFINITY),
                                high = solved_at(&contact, p * gradient * (1 + 1e-3), INFINITY);
            double slope = (high.quantities.gap_m - low.quantities.gap_m) / (2e-3 * p * gradient);
            assert_true(point.quantities.contact_points >= 100);
            /* at the last the longest wave is nearly all: one Hertzian patch has more area at low load */
            assert_within(point.quantities.area_ratio / p, 2.1, gammas[e] < 2 ? 0.5 : 1.2);
            hard_case("exponents at both ends, γ = 0.5, 1 and 2", "patches of one point, or one Hertzian patch",
                      "resistance is the slope of the gap, whatever the surface", "constriction, relative",
                      off_by(point.constriction_m, -slope / 2), 5e-3);
            assert_true(point.quantities.area_ratio > last);
            last = point.quantities.area_ratio;
        }
        direct_contact_free(&contact);
    }
}

static struct direct_ensemble_def ensemble_of(const struct direct_spectrum *spectrum, size_t n, const double *loads,
                                              size_t count)
{
    return (struct direct_ensemble_def){.ladder = {loads, count, INFINITY, 1e-6, true, NULL},
                                        .length_m = 1,
                                        .n = n,
                                        .recipe = {direct_spectrum_variance, spectrum, NULL, 0},
                                        .seeds = 3,
                                        .threads = 1};
}

/** What does not converge is an error of the ladder and of the ensemble, as is a load that is no number. */
TEST_CASE(no_answer)
{
    enum { N = 32 };
    static const double load = 1e-3;
    struct direct_law law = {1e-3, 1.3, 1 / 5.0, 1, 1};
    struct direct_spectrum spectrum;
    struct direct_ensemble found;
    struct status status = {0};
    double *height = surface_of(1.3, 5, N, 1);
    struct direct_contact contact = contact_of(height, N, N);
    struct direct_ladder_def ladder = {&load, 1, INFINITY, 1e-300, false, NULL, false};
    struct direct_point point;
    int traps = fedisableexcept(FE_ALL_EXCEPT); /* 0/0 ends iterations on rounding alone */
    hard_case("a tolerance of 1e-300", "iterations without end", "an error: did not converge", "answers",
              direct_ladder_run(&point, &contact, &ladder, &status) != STATUS_MODEL, 0);
    assert_non_null(strstr(status.message, "not converge"));
    expect_ok(direct_spectrum_of_law, &spectrum, &law);
    struct direct_ensemble_def def = ensemble_of(&spectrum, N, &load, 1);
    def.ladder.tolerance = 1e-300;
    def.ladder.resistance = false;
    expect_fails(STATUS_MODEL, "not converge", direct_ensemble_run, &found, &def);
    assert_true(!found.point && !found.seed_point);

    (void)solved_at(&contact, load, INFINITY);
    double length;
    expect_fails(STATUS_MODEL, "not converge", direct_constriction_of_contact, &length, &contact, 1e-300, NULL);

    static const double wrong[] = {-1, 0, NAN, INFINITY, -INFINITY};
    for (size_t w = 0; w < sizeof wrong / sizeof *wrong; w++) {
        struct direct_contact_load one = {wrong[w], INFINITY, 1e-6, false, NULL};
        status = (struct status){0};
        hard_case("loads of -1, 0, NaN, ± infinity", "a solution of no question", "refused", "answers",
                  direct_contact_solve(&contact, &one, &status) != STATUS_MODEL, 0);
    }
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(traps);
    direct_contact_free(&contact);
    direct_spectrum_free(&spectrum);
}
