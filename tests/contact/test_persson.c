/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Persson's area, separation and conductance against tests/data/golden/models/persson_lines.csv (a direct double
 * integral in 30 digits), against the sums over every wave, and in their limits. */
#include "base/integral.h"
#include "contact/persson.h"
#include "model_support.h"
#include "random_surface.h"

/** The golden area is the original one, erf(p/sqrt(m2)), in the rows of both g. */
TEST_CASE(matches_reference)
{
    struct table table = table_read("golden/models/persson_lines.csv");
    for (size_t i = 0; i < table.rows; i++) {
        struct spectrum spectrum =
            model_support_law(table_number(&table, i, "scan_length_m"), table_number(&table, i, "alpha_SI"),
                              table_number(&table, i, "gamma"), (size_t)table_number(&table, i, "scales"));
        struct persson persson = model_support_persson(&spectrum, table_number(&table, i, "gamma_energy"));
        double load = table_number(&table, i, "load_over_AnEp");
        assert_near(persson_area(load, persson.m2, 1), table_number(&table, i, "area_ratio"), 1e-10);
        struct persson_separation at = persson_separation(&persson, load);
        assert_near(at.separation_m, table_number(&table, i, "separation_m"), 1e-10);
        assert_near(at.separation_m / sqrt(persson.m0_m2), table_number(&table, i, "separation_over_sigma"), 1e-10);
        persson_free(&persson);
        spectrum_free(&spectrum);
    }
    table_free(&table);
}

struct integrand {
    double energy_factor, from;
    int power; /* 0: f (t-x)/t², 1: f/t² */
};

static double direct(double t, void *context)
{
    const struct integrand *of = context;
    double factor = of->energy_factor + 3 * (1 - of->energy_factor) * erf(t) * erf(t);
    return factor * exp(-t * t + of->from * of->from) / (t * t) * (of->power == 0 ? t - of->from : 1);
}

static double in_parts(struct integrand of)
{
    double sum = 0, from = of.from;
    while (from < of.from + 7) { /* geometric parts, for the pole at 0 */
        double to = fmin(2 * from, from + 1);
        sum += integral(direct, &of, from, to, 1e-14);
        from = to;
    }
    return sum;
}

/** s and I_2 in all three ranges and at their borders, against direct quadrature. */
TEST_CASE(kernel_is_the_integral)
{
    static const double factors[] = {0.2, 0.45, 1};
    for (size_t g = 0; g < 3; g++) {
        struct persson_kernel kernel = persson_kernel(factors[g]);
        for (double x = 1e-4; x < 25; x *= 1.037) {
            struct persson_integrals at = persson_integrals(&kernel, x, log(x));
            assert_near(at.separation * exp(x * x), in_parts((struct integrand){factors[g], x, 0}), 2e-12);
            assert_near(at.conductance * exp(x * x), in_parts((struct integrand){factors[g], x, 1}), 2e-12);
        }
        static const double borders[] = {0.5, 6.75};
        for (size_t b = 0; b < 2; b++) {
            struct persson_integrals below = persson_integrals(&kernel, borders[b] * (1 - 1e-15), log(borders[b]));
            struct persson_integrals above = persson_integrals(&kernel, borders[b], log(borders[b]));
            assert_near(below.separation, above.separation, 1e-12);
            assert_near(below.conductance, above.conductance, 1e-12);
        }
    }
}

/** Grouped waves against every wave, on spectra from steep to flat and one with holes. */
TEST_CASE(groups_stand_for_rings)
{
    static const double gammas[] = {0.3, 0.8, 1, 1.3, 1.7};
    double worst = 0;
    for (size_t g = 0; g < 6; g++) {
        struct spectrum spectrum = model_support_law(1e-3, 0.01, g < 5 ? gammas[g] : 1, 4000);
        if (g == 5)
            for (size_t i = 0; i < spectrum.count; i++)
                spectrum.amplitude_m[i] *= i % 7 == 0 || (i > 300 && i < 1200) ? 0 : 1 + (double)(i * i % 11);
        struct persson persson = model_support_persson(&spectrum, persson_energy_factor);
        assert_true(persson.groups.count < persson.rings.count / 10);
        struct persson every = persson;
        every.groups = every.rings;
        for (double p = 1e-8; p < 3; p *= 1.3) {
            double load = p * sqrt(persson.m2);
            struct persson_separation grouped = persson_separation(&persson, load);
            struct persson_separation whole = persson_separation(&every, load);
            worst = fmax(worst, fabs(grouped.separation_m / whole.separation_m - 1));
            worst = fmax(worst, fabs(grouped.constriction_m / whole.constriction_m - 1));
        }
        persson_free(&persson);
        spectrum_free(&spectrum);
    }
    assert_true(worst < 1e-11);
}

/** A = 2/sqrt(pi) p/sqrt(g m2) and u = u_0 ln(p_0/p) at light load; the slope of u is -constriction; nothing overflows.
 */
TEST_CASE(limits)
{
    struct spectrum spectrum = model_support_law(1e-3, 0.01, 1.1, 500);
    struct persson persson = model_support_persson(&spectrum, persson_energy_factor);
    double rms = sqrt(persson.m2), g = persson_energy_factor;
    assert_near(persson_area(1e-9 * rms, persson.m2, g), M_2_SQRTPI * 1e-9 / sqrt(g), 1e-8);
    assert_near(persson_area(1e-9 * rms, persson.m2, 1), M_2_SQRTPI * 1e-9, 1e-15);
    assert_true(persson_area(0, persson.m2, g) == 0 && persson_area(30 * rms, persson.m2, g) == 1);
    double u0 = 0, y = 0, y_before = 0, sum = 0;
    for (size_t i = 0; i < spectrum.count; i++) { /* u_0 = (2g/sqrt(pi)) sum (y_i - y_{i-1})/q_i as it is printed */
        double omega = 2 * M_PI * spectrum_frequency(&spectrum, i);
        sum += omega * omega * spectrum_power(&spectrum, i);
        y = sqrt(sum);
        u0 += M_2_SQRTPI * g * (y - y_before) / (M_SQRT2 * omega);
        y_before = y;
    }
    struct persson_separation light = persson_separation(&persson, 1e-12 * rms);
    struct persson_separation lighter = persson_separation(&persson, 1e-13 * rms);
    assert_near(lighter.separation_m - light.separation_m, u0 * log(10), 1e-9);
    assert_near(light.constriction_m * 1e-12 * rms, u0, 1e-9);
    for (double p = 1e-6; p < 5; p *= 1.7) { /* Barber's identity: the conductance is the slope of the separation */
        double step = 2e-5 * p * rms;
        double slope = (persson_separation(&persson, p * rms + step).separation_m -
                        persson_separation(&persson, p * rms - step).separation_m) /
                       (2 * step);
        assert_near(-slope, persson_separation(&persson, p * rms).constriction_m, 2e-6);
    }
    double area = 0, separation = INFINITY, constriction = INFINITY;
    for (double p = 1e-300; p < 1e3; p *= 1.5) {
        struct persson_separation at = persson_separation(&persson, p);
        double now = persson_area(p, persson.m2, g);
        assert_true(now >= area && now <= 1);
        assert_true(at.separation_m <= separation && at.separation_m >= 0);
        assert_true(at.constriction_m <= constriction && at.constriction_m >= 0);
        area = now;
        separation = at.separation_m;
        constriction = at.constriction_m;
    }
    assert_true(area == 1 && separation == 0 && constriction == 0);
    persson_free(&persson);
    spectrum_free(&spectrum);
}

/** p(A) is the inverse of A(p); erf^-1 is that of erf, also for tiny areas. */
TEST_CASE(area_and_load_are_inverse)
{
    for (double area = 1e-300; area < 1; area = area < 0.1 ? area * 3 : area + 0.01) {
        assert_near(erf(persson_erf_inverse(area)), area, 5e-16);
        for (double g = 0.2; g <= 1; g += 0.16)
            if (area > 1e-200)
                assert_near(persson_area(persson_load(area, 3e-4, g), 3e-4, g), area, 1e-13);
    }
    assert_true(persson_erf_inverse(0) == 0 && isinf(persson_erf_inverse(1)));
}

/** A flat surface touches as a whole; one wave alone works; waves without amplitude add nothing. */
TEST_CASE(hard_cases)
{
    struct spectrum flat = model_support_law(1e-3, 0, 1, 5), one = model_support_law(1e-3, 0.01, 1, 1);
    struct persson persson = model_support_persson(&flat, 0.45);
    struct persson_separation at = persson_separation(&persson, 1e-4);
    assert_true(at.separation_m == 0 && at.constriction_m == 0 && persson_area(1e-4, persson.m2, 0.45) == 1);
    persson_free(&persson);
    persson = model_support_persson(&one, 0.45);
    at = persson_separation(&persson, 1e-4);
    assert_true(isfinite(at.separation_m) && at.separation_m > 0);
    persson_free(&persson);
    double amplitude[5] = {0, 0, one.amplitude_m[0], 0, 0};
    struct spectrum padded = {amplitude, 5, 3e-3, false}; /* the same wave as the third harmonic */
    persson = model_support_persson(&padded, 0.45);
    assert_near(persson_separation(&persson, 1e-4).separation_m, at.separation_m, 1e-13);
    assert_near(persson_separation(&persson, 1e-4).constriction_m, at.constriction_m, 1e-13);
    persson_free(&persson);
    spectrum_free(&flat);
    spectrum_free(&one);
}

/** Model/truth on the 16 surfaces of direct solutions, as rms factors: the published ones. */
TEST_CASE(direct_solutions)
{
    struct table table = table_read("golden/direct/gaussian_elastic.csv");
    double area_sum = 0, gap_sum = 0, ecr_sum = 0;
    int areas = 0, gaps = 0;
    for (size_t i = 0; i < table.rows; i++) {
        struct spectrum spectrum;
        random_surface(&spectrum, table_number(&table, i, "hurst"), table_number(&table, i, "long_index"),
                       table_number(&table, i, "short_index"), table_number(&table, i, "plateau") > 0);
        struct persson persson = model_support_persson(&spectrum, persson_energy_factor);
        double load = table_number(&table, i, "load_over_Ep"), truth = table_number(&table, i, "area_ratio");
        double area = log(persson_area(load, persson.m2, persson_energy_factor) / truth);
        struct persson_separation at = persson_separation(&persson, load);
        double gap = log(at.separation_m / table_number(&table, i, "mean_gap_over_L"));
        double ecr = log(at.constriction_m / (2 * table_number(&table, i, "constriction_length_over_L")));
        if (truth >= 1e-3 && truth <= 0.97) {
            area_sum += area * area;
            areas++;
        }
        if (truth >= 1e-3 && truth < 0.6) {
            gap_sum += gap * gap;
            ecr_sum += ecr * ecr;
            gaps++;
        }
        persson_free(&persson);
        spectrum_free(&spectrum);
    }
    assert_within(exp(sqrt(area_sum / areas)), 1.12, 0.006);
    assert_within(exp(sqrt(gap_sum / gaps)), 1.15, 0.006);
    assert_within(exp(sqrt(ecr_sum / gaps)), 1.52, 0.006);
    table_free(&table);
}
