/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Persson's load and constriction against tests/data/golden/models/persson_lines.csv (a direct double integral in 30
 * digits), against the sums over every wave, and in their limits. */
#include "base/integral.h"
#include "model_support.h"

static double constriction(double load, void *persson)
{
    return persson_constriction(persson, load);
}

/** The golden separation u falls by 2 l dp (Barber's identity) from each load to the next, up to A = 0.97. */
TEST_CASE(matches_reference)
{
    struct table table = table_read("golden/models/persson_lines.csv");
    size_t compared = 0;
    for (size_t i = 0; i + 1 < table.rows; i++) {
        double load = table_number(&table, i, "load_over_AnEp"), next = table_number(&table, i + 1, "load_over_AnEp");
        if (table_number(&table, i, "gamma_energy") != persson_energy_factor || !(next > load))
            continue;
        struct spectrum spectrum =
            model_support_law(table_number(&table, i, "scan_length_m"), table_number(&table, i, "alpha_SI"),
                              table_number(&table, i, "gamma"), (size_t)table_number(&table, i, "scales"));
        struct persson persson = model_support_persson(&spectrum);
        if (next < persson_load(0.97, persson.m2)) {
            double fall = table_number(&table, i, "separation_m") - table_number(&table, i + 1, "separation_m");
            assert_near(2 * integral(constriction, &persson, load, next, 1e-12), fall, 1e-8);
            compared++;
        }
    }
    assert_true(compared > 10);
}

/** f/t² exp(x²) */
static double direct(double t, void *from)
{
    double x = *(double *)from, factor = 0.45 + 3 * 0.55 * erf(t) * erf(t);
    return factor * exp(x * x - t * t) / (t * t);
}

/** I_2 on all panels, against direct quadrature in geometric parts, for the pole at 0. */
TEST_CASE(kernel_is_the_integral)
{
    struct spectrum spectrum = model_support_law(1e-3, 0.01, 1.1, 5);
    (void)model_support_persson(&spectrum); /* makes the panels */
    for (double x = 1e-4; x < 9; x *= 1.037) {
        double sum = 0;
        for (double from = x, to; from < x + 7; from = to) {
            to = fmin(2 * from, from + 1);
            sum += integral(direct, &x, from, to, 1e-14);
        }
        assert_near(persson_integral(x) * exp(x * x), sum, 2e-12);
    }
}

/** (1/sqrt(pi)) sum_n [I_2(p/Y_n) - I_2(p/Y_{n-1})]/q_n as it is printed. */
static double over_rings(const struct spectrum *spectrum, double load)
{
    double square = 0, before = 0, sum = 0;
    for (size_t i = 0; i < spectrum->count; i++) {
        double omega = 2 * M_PI * spectrum_frequency(spectrum, i);
        square += omega * omega * spectrum_power(spectrum, i);
        double x = load / sqrt(square), now = x < 9 ? persson_integral(x) : 0;
        sum += (now - before) / (M_SQRT2 * omega);
        before = now;
    }
    return sum / sqrt(M_PI);
}

/** Nodes against every wave, on spectra from steep to flat, one with holes, one of few waves, and one of so many that
 * neighbours are shared out together. */
TEST_CASE(nodes_stand_for_rings)
{
    static const double gammas[] = {0.3, 0.8, 1, 1.3, 1.7, 1, 1, 1.3};
    for (size_t g = 0; g < 8; g++) {
        struct spectrum spectrum = model_support_law(1e-3, 0.01, gammas[g], g == 6 ? 300 : g == 7 ? 400000 : 4000);
        for (size_t i = 0; i < spectrum.count && (g == 5 || g == 6); i++)
            spectrum.amplitude_m[i] *= i % 7 == g - 5 || (i > 30 && i < 200) ? 0 : 1 + (double)(i * i % 11);
        struct persson persson = model_support_persson(&spectrum);
        for (double area = 1e-9; area <= 0.97; area = area < 0.1 ? 3 * area : area + 0.05) {
            double load = persson_load(area, persson.m2);
            assert_near(persson_constriction(&persson, load), over_rings(&spectrum, load), 1e-7);
        }
    }
}

/** A wave that levelling has taken is one of a record twice as long, of the mean power of the three longest. */
TEST_CASE(lost_wave)
{
    struct spectrum spectrum = model_support_law(1e-3, 0.01, 1.2, 200), longer = model_support_law(2e-3, 0, 1, 400);
    double lost_m2 = persson_lost_wave(&spectrum), powers = 0;
    struct persson persson;
    for (size_t i = 0; i < 3; i++)
        powers += spectrum_power(&spectrum, i);
    assert_near(lost_m2, powers / 3, 1e-14);
    longer.amplitude_m[0] = sqrt(2 * lost_m2);
    for (size_t i = 0; i < 200; i++)
        longer.amplitude_m[2 * i + 1] = spectrum.amplitude_m[i];
    expect_ok(persson_make, &persson, &spectrum, lost_m2);
    assert_near(persson.m0_m2, spectrum_moment(&longer, 0), 1e-12);
    assert_near(persson.m2, spectrum_moment(&longer, 1), 1e-12);
    for (double load = 1e-6; load < sqrt(persson.m2); load *= 3)
        assert_near(persson_constriction(&persson, load), over_rings(&longer, load), 1e-7);
    persson_free(&persson);
}

/** It is given back to what is corrected Persson's alone, and where one was lost. */
TEST_CASE(levelled_scans)
{
    struct contact_point points[2], other[2];
    struct spectrum spectrum = model_support_law(1e-3, 0.02, 1.2, 200);
    struct material_pair pair = model_support_tin();
    double load = 2e-3;
    struct model_task task = model_support_task(&spectrum, &pair, &load, 1);
    task.hardness_Pa = 1e9;
    for (int m = 0; m < 4; m++) {
        static const char *const names[] = {"corrected-persson", "corrected-persson-plastic", "multiscale-elastic",
                                            "cmy"};
        task.levelled = false;
        (void)model_support_run(points, names[m], &task);
        task.levelled = true;
        (void)model_support_run(other, names[m], &task);
        double gap = other[0].value[QUANTITY_SEPARATION] / points[0].value[QUANTITY_SEPARATION];
        assert_true(m < 2 ? gap > 1.02 && gap < 1.5 : gap == 1);
    }
}

/** A = 2/sqrt(pi) p/sqrt(g m2) at light load; erf^-1 is that of erf, also for tiny areas. */
TEST_CASE(load)
{
    assert_near(persson_load(1e-9, 4), 1e-9 / M_2_SQRTPI * sqrt(persson_energy_factor * 4), 1e-8);
    assert_near(persson_load(0.6, 4), persson_erf_inverse(0.6) * sqrt(4 * (0.45 + 0.55 * 0.6)), 1e-15);
    for (double area = 1e-300; area < 1; area = area < 0.1 ? area * 3 : area + 0.01)
        assert_near(erf(persson_erf_inverse(area)), area, 5e-16);
    assert_true(persson_erf_inverse(0) == 0 && isinf(persson_erf_inverse(1)));
}

/** A flat surface has no constriction; one wave alone works; waves without amplitude add nothing. */
TEST_CASE(hard_cases)
{
    struct spectrum flat = model_support_law(1e-3, 0, 1, 5), one = model_support_law(1e-3, 0.01, 1, 1);
    struct persson persson = model_support_persson(&flat);
    assert_true(persson.m2 == 0 && persson_constriction(&persson, 1e-4) == 0);
    persson = model_support_persson(&one);
    double alone_m = persson_constriction(&persson, 1e-4);
    assert_near(alone_m, over_rings(&one, 1e-4), 1e-12);
    double amplitude[5] = {0, 0, one.amplitude_m[0], 0, 0};
    struct spectrum padded = {amplitude, 5, 3e-3, false}; /* the same wave as the third harmonic */
    persson = model_support_persson(&padded);
    assert_near(persson_constriction(&persson, 1e-4), alone_m, 1e-12);
}
