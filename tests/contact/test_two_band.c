/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The two-band stack against tests/data/golden/two-band (40 digits), against direct solutions of random surfaces, and
 * in what it is made for: independence of the scan's length. */
#include "contact/two_band.h"
#include "random_surface.h"
#include "support.h"

enum { EVERYTHING = QUANTITY_BIT(QUANTITY_SEPARATION) | QUANTITY_RESISTANCES, LOADS_MOST = 64 };

static struct spectrum law_spectrum(double length, double alpha, double gamma, size_t count)
{
    struct spectrum spectrum = {malloc(count * sizeof(double)), count, length, false};
    assert_non_null(spectrum.amplitude_m);
    for (size_t i = 0; i < count; i++)
        spectrum.amplitude_m[i] = alpha * pow(length / (double)(i + 1), gamma);
    return spectrum;
}

/** The spectra of the reference sets; law_b's length, slope and number of harmonics were found from its bands. */
static struct spectrum reference_spectrum(const char *set)
{
    if (strcmp(set, "law_a") == 0)
        return law_spectrum(3e-4, 0.085, 1.5, 256);
    if (strcmp(set, "law_b") == 0)
        return law_spectrum(1.07e-3, 0.006, 1, 428);
    assert_string_equal(set, "random60");
    struct table table = table_read("golden/two-band/random_spectrum.csv");
    struct spectrum spectrum = law_spectrum(5e-4, 0, 1, table.rows);
    for (size_t i = 0; i < table.rows; i++)
        spectrum.amplitude_m[i] = table_number(&table, i, "amplitude_m");
    table_free(&table);
    return spectrum;
}

static struct material_pair tin(void)
{
    return material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
}

static struct multiscale stack_of(const struct spectrum *spectrum, const struct material_pair *pair, bool plastic,
                                  double hardness_Pa)
{
    struct two_band bands;
    struct multiscale stack;
    struct status status = {0};
    assert_true(two_band_split(&bands, spectrum));
    assert_int_equal(two_band_stack(&stack, &bands, pair, plastic, hardness_Pa, SINUSOID_FIT_THESIS, &status),
                     STATUS_OK);
    return stack;
}

TEST_CASE(bands_match_reference)
{
    struct table table = table_read("golden/two-band/bands.csv");
    struct material_pair pair = tin();
    for (size_t i = 0; i < table.rows; i++) {
        struct spectrum spectrum = reference_spectrum(table_text(&table, i, "set"));
        size_t band = (size_t)table_number(&table, i, "band") - 1;
        struct two_band bands;
        assert_true(two_band_split(&bands, &spectrum));
        struct multiscale stack = stack_of(&spectrum, &pair, false, INFINITY);
        assert_int_equal(bands.split_harmonic, (size_t)table_number(&table, i, "split_harmonic"));
        assert_near(bands.split_share, table_number(&table, i, "share_of_split_harmonic_in_band_1"), 1e-10);
        assert_near(bands.amplitude_m[band], table_number(&table, i, "amplitude_m"), 1e-13);
        assert_near(bands.frequency_per_m[band], table_number(&table, i, "frequency_per_m"), 1e-13);
        assert_near(stack.scales[band].full_pressure_Pa, table_number(&table, i, "complete_contact_pressure_Pa"),
                    1e-13);
        multiscale_free(&stack);
        spectrum_free(&spectrum);
    }
    table_free(&table);
}

TEST_CASE(points_match_reference)
{
    struct table table = table_read("golden/two-band/banded.csv");
    struct material_pair pair = tin();
    struct constriction spot = constriction_make(&pair);
    for (size_t i = 0; i < table.rows; i++) {
        struct spectrum spectrum = reference_spectrum(table_text(&table, i, "set"));
        const char *model = table_text(&table, i, "model");
        double hardness_Pa = INFINITY, load = table_number(&table, i, "load_over_AnEp");
        if (strcmp(model, "plastic_floor_2.84Sy") == 0)
            hardness_Pa = 2.84 * pair.yield_strength_Pa;
        if (strcmp(model, "plastic_floor_CSy") == 0)
            hardness_Pa = pair.yield_coefficient * pair.yield_strength_Pa;
        struct multiscale stack = stack_of(&spectrum, &pair, strcmp(model, "elastic") != 0, hardness_Pa);
        struct contact_point point;
        uint64_t evaluations = 0;
        multiscale_solve(&point, &stack, &spot, EVERYTHING, load, &evaluations);
        assert_near(point.value[QUANTITY_AREA], table_number(&table, i, "area_ratio"), 1e-12);
        assert_near(point.value[QUANTITY_SEPARATION], table_number(&table, i, "separation_m"), 1e-10);
        assert_near(point.value[QUANTITY_ECR], table_number(&table, i, "ecr_ohm_m2"), 1e-10);
        assert_near(point.value[QUANTITY_TCR], table_number(&table, i, "tcr_K_m2_per_W"), 1e-10);
        if (isfinite(hardness_Pa) &&
            point.value[QUANTITY_AREA] < 1) /* no pressure beyond hardness while the last scale yields */
            assert_true(load * pair.effective_modulus_Pa / point.value[QUANTITY_AREA] < hardness_Pa * (1 + 1e-12));
        if (strcmp(model, "elastic") == 0) {
            double separation;
            two_band_separation(&separation, &load, 1, &stack, 1e-12, &evaluations);
            assert_near(separation, table_number(&table, i, "separation_barber_m"), 1e-10);
        }
        multiscale_free(&stack);
        spectrum_free(&spectrum);
    }
    table_free(&table);
}

/** A ladder gives what each load alone gives, at the tolerance asked for and with work that follows it; the slope of
 * the separation is the resistance (Barber's identity); both closures; nothing left from full contact on. */
TEST_CASE(separation_is_the_integral)
{
    struct material_pair pair = tin();
    struct spectrum spectrum = reference_spectrum("law_b");
    double load[LOADS_MOST], exact[LOADS_MOST], loose[LOADS_MOST];
    for (int closure = 0; closure < SINUSOID_FIT_COUNT; closure++) {
        struct two_band bands;
        struct multiscale stack;
        struct status status = {0};
        uint64_t dear = 0, cheap = 0, uncounted = 0;
        assert_true(two_band_split(&bands, &spectrum));
        assert_int_equal(two_band_stack(&stack, &bands, &pair, false, INFINITY, (enum sinusoid_fit_id)closure, &status),
                         STATUS_OK);
        for (int i = 0; i < LOADS_MOST; i++)
            load[i] = stack.full_load * pow(10, -7 + 7.2 * i / (LOADS_MOST - 1));
        two_band_separation(exact, load, 1, &stack, 1e-12, &dear);
        two_band_separation(loose, load, 1, &stack, 1e-3, &cheap);
        assert_true(cheap < dear);
        two_band_separation(exact, load, LOADS_MOST, &stack, 1e-12, &uncounted);
        two_band_separation(loose, load, LOADS_MOST, &stack, 1e-4, &uncounted);
        static const struct constriction unit = {.resistivity_ohm_m = 1};
        for (int i = 0; i < LOADS_MOST; i++) {
            assert_near(loose[i], exact[i], 1e-4);
            if (load[i] >= stack.full_load) {
                assert_true(exact[i] == 0);
                continue;
            }
            double alone;
            two_band_separation(&alone, &load[i], 1, &stack, 1e-12, &uncounted);
            assert_near(exact[i], alone, 1e-10);
            double pair_load[2] = {load[i] * (1 - 1e-5), load[i] * (1 + 1e-5)}, around[2];
            two_band_separation(around, pair_load, 2, &stack, 1e-12, &uncounted);
            struct contact_point point;
            multiscale_solve(&point, &stack, &unit, QUANTITY_BIT(QUANTITY_ECR), load[i], &uncounted);
            assert_near((around[0] - around[1]) / (2e-5 * load[i]), point.value[QUANTITY_ECR], 1e-4);
            assert_true(i == 0 || exact[i] < exact[i - 1]);
        }
        multiscale_free(&stack);
    }
    spectrum_free(&spectrum);
}

/** One wave becomes two equal bands; silent harmonics change nothing; no amplitude, no bands; the Nyquist harmonic
 * counts with its whole square; variance and mean-square gradient of the bands are the surface's. */
TEST_CASE(bands_keep_the_surface)
{
    struct two_band bands, padded;
    double amplitude[6] = {0, 0, 2e-6, 0, 0, 0};
    struct spectrum one = {amplitude, 6, 3e-4, false};
    assert_true(two_band_split(&bands, &one));
    assert_int_equal(bands.split_harmonic, 3);
    assert_near(bands.split_share, 0.5, 1e-15);
    for (int band = 0; band < 2; band++) {
        assert_near(bands.amplitude_m[band], 2e-6, 1e-15); /* sqrt2 sqrt(1/2) Delta */
        assert_near(bands.frequency_per_m[band], 1e4, 1e-15);
    }
    amplitude[2] = 0;
    assert_false(two_band_split(&bands, &one));

    struct spectrum spectrum = reference_spectrum("random60");
    assert_true(two_band_split(&bands, &spectrum));
    double m0 = 0, m2 = 0;
    for (int band = 0; band < 2; band++) {
        double square = bands.amplitude_m[band] * bands.amplitude_m[band],
               omega = 2 * M_PI * bands.frequency_per_m[band];
        m0 += square / 4;                 /* variance of the cell */
        m2 += omega * omega * square / 4; /* half of its mean-square gradient */
    }
    assert_near(m0, spectrum_moment(&spectrum, 0), 1e-14);
    assert_near(m2, spectrum_moment(&spectrum, 1), 1e-14);
    spectrum.has_nyquist = true;
    assert_true(two_band_split(&padded, &spectrum));
    spectrum.has_nyquist = false;
    spectrum.amplitude_m[spectrum.count - 1] *= M_SQRT2;
    assert_true(two_band_split(&bands, &spectrum));
    assert_near(padded.amplitude_m[1], bands.amplitude_m[1], 1e-15);
    spectrum_free(&spectrum);
}

/** The same self-affine surface (gamma = 1, plateau above 300 um, 10 um shortest) as seen by scans of 4, 16 and 64
 * longest waves: area, gap and resistance stay within 3 %, where the stack of all harmonics drifts by factors. */
TEST_CASE(scan_length_does_not_matter)
{
    struct material_pair pair = tin();
    struct constriction spot = constriction_make(&pair);
    struct contact_point first = {0}, first_all = {0}, point;
    uint64_t evaluations = 0;
    for (int waves = 4; waves <= 64; waves *= 4) {
        double length = waves * 3e-4;
        struct spectrum spectrum = law_spectrum(length, 0, 1, (size_t)(waves * 30));
        for (size_t i = 0; i < spectrum.count; i++) { /* mean square per frequency, the scan's resolution 1/L wide */
            double wavelength = fmin(length / (double)(i + 1), 3e-4);
            spectrum.amplitude_m[i] = 5e-5 * wavelength / sqrt(length);
        }
        struct multiscale stack = stack_of(&spectrum, &pair, false, INFINITY), all;
        multiscale_solve(&point, &stack, &spot, EVERYTHING, 1e-5, &evaluations);
        multiscale_free(&stack);
        if (waves == 4)
            first = point;
        assert_near(point.value[QUANTITY_AREA], first.value[QUANTITY_AREA], 0.03);
        assert_near(point.value[QUANTITY_SEPARATION], first.value[QUANTITY_SEPARATION], 0.03);
        assert_near(point.value[QUANTITY_ECR], first.value[QUANTITY_ECR], 0.03);
        assert_int_equal(multiscale_make(&all, &spectrum, &pair, false, SINUSOID_FIT_THESIS, &(struct status){0}),
                         STATUS_OK);
        multiscale_solve(&point, &all, &spot, EVERYTHING, 1e-5, &evaluations);
        multiscale_free(&all);
        if (waves == 4)
            first_all = point;
        spectrum_free(&spectrum);
    }
    assert_true(point.value[QUANTITY_AREA] > 2 * first_all.value[QUANTITY_AREA]);
}

/** Ratios model/truth of area, Barber's separation and resistance on the 16 surfaces of direct solutions: their rms
 * factors are the published ones, and none is beyond its range. */
TEST_CASE(direct_solutions)
{
    struct table table = table_read("golden/two-band/truth_elastic.csv");
    struct material_pair pair = {.effective_modulus_Pa = 1, .resistivity_ohm_m = 1};
    static const struct constriction unit = {.resistivity_ohm_m = 1};
    double area_sum = 0, gap_sum = 0, ecr_sum = 0;
    int areas = 0, gaps = 0;
    struct spectrum spectrum = {0};
    for (size_t i = 0; i < table.rows; i++) {
        double hurst = table_number(&table, i, "hurst"), longest = table_number(&table, i, "long_index");
        double shortest = table_number(&table, i, "short_index");
        double areal = random_surface(&spectrum, hurst, longest, shortest, table_number(&table, i, "plateau") > 0);
        assert_near(sqrt(areal), table_number(&table, i, "areal_rms_over_L"), 1e-5);
        assert_near(sqrt(spectrum_moment(&spectrum, 0)), table_number(&table, i, "row_rms_over_L"), 1e-5);
        struct multiscale stack = stack_of(&spectrum, &pair, false, INFINITY);
        double load = table_number(&table, i, "load_over_Ep"), truth = table_number(&table, i, "area_ratio"),
               separation;
        struct contact_point point;
        uint64_t evaluations = 0;
        multiscale_solve(&point, &stack, &unit, QUANTITY_BIT(QUANTITY_ECR), load, &evaluations);
        two_band_separation(&separation, &load, 1, &stack, 1e-8, &evaluations);
        double area = log(point.value[QUANTITY_AREA] / truth);
        double gap = log(separation / table_number(&table, i, "mean_gap_over_L"));
        /* ECR A_n = 2 rho ell */
        double ecr = log(point.value[QUANTITY_ECR] / (2 * table_number(&table, i, "constriction_length_over_L")));
        if (truth >= 1e-3 && truth <= 0.97) {
            assert_true(area > log(0.54) && area < log(1.3));
            area_sum += area * area;
            areas++;
        }
        if (truth >= 1e-3 && truth < 0.6) {
            assert_true(gap > log(0.74) && gap < log(1.47));
            assert_true(ecr > log(0.42) && ecr < log(3.0));
            gap_sum += gap * gap;
            ecr_sum += ecr * ecr;
            gaps++;
        }
        multiscale_free(&stack);
        spectrum_free(&spectrum);
    }
    assert_int_equal(areas, 168);
    assert_int_equal(gaps, 122);
    assert_within(exp(sqrt(area_sum / areas)), 1.13, 0.006); /* as found when the model was chosen */
    assert_within(exp(sqrt(gap_sum / gaps)), 1.15, 0.006);
    assert_within(exp(sqrt(ecr_sum / gaps)), 1.36, 0.006);
    table_free(&table);
}

/** From no load to far beyond full contact: finite, the area never falls, but for the published 0.05 % at x = 0.8. */
TEST_CASE(extreme_loads)
{
    struct material_pair pair = tin();
    struct constriction spot = constriction_make(&pair);
    struct spectrum spectrum = reference_spectrum("random60");
    for (int law = 0; law < 3; law++) {
        struct multiscale stack = stack_of(&spectrum, &pair, law > 0, law == 2 ? 4e7 : INFINITY);
        double area = 0;
        for (double load = 1e-25; load < 1e3; load *= 1.1) {
            struct contact_point point;
            uint64_t evaluations = 0;
            multiscale_solve(&point, &stack, &spot, EVERYTHING, load, &evaluations);
            assert_true(point.value[QUANTITY_AREA] >= area * (1 - 6e-4) && point.value[QUANTITY_AREA] > 0 &&
                        point.value[QUANTITY_AREA] <= 1);
            assert_true(isfinite(point.value[QUANTITY_SEPARATION]) && isfinite(point.value[QUANTITY_ECR]) &&
                        point.value[QUANTITY_ECR] >= 0);
            area = point.value[QUANTITY_AREA];
            if (law == 0) {
                double separation;
                two_band_separation(&separation, &load, 1, &stack, 1e-6, &evaluations);
                assert_true(isfinite(separation) && separation >= 0);
            }
        }
        assert_true(area == 1);
        multiscale_free(&stack);
    }
    spectrum_free(&spectrum);
}

TEST_CASE(what_is_to_be_trusted)
{
    assert_true(two_band_trusted(0.75) && !two_band_trusted(0.7501));
    assert_true(two_band_plastic_gap_trusted(0.2, 10e6, 40e6) && !two_band_plastic_gap_trusted(0.2, 10.01e6, 40e6));
    assert_false(two_band_plastic_gap_trusted(0.76, 1e6, 40e6));
}

/** Many loads at once at the usual tolerance are as exact as each at the finest, and take fewer visits of scales than
 * rules of four points a load; the finest takes few too, as nothing is halved over where the law is pieced together. */
static void ladder_is_exact(struct multiscale *stack)
{
    enum { LADDER = 121 };
    double load[LADDER], usual[LADDER], alone;
    uint64_t visits = 0;
    for (int i = 0; i < LADDER; i++)
        load[i] = 1e-6 * pow(stack->full_load / 1e-6, i / 110.0);
    two_band_separation(usual, load, LADDER, stack, 1e-6, &visits);
    assert_true(visits < 8 * LADDER);
    for (int i = 0; i < LADDER && load[i] < stack->full_load * (1 - 1e-6); i++) {
        visits = 0;
        two_band_separation(&alone, &load[i], 1, stack, 1e-12, &visits);
        assert_true(visits < 1200);
        assert_near(usual[i], alone, 1e-11);
    }
}

/** Loads that come twice, where a scale completes too, have what they have alone. */
static void loads_may_come_twice(struct multiscale *stack)
{
    double complete = stack->scales[0].full_pressure_Pa / stack->effective_modulus_Pa, twice[6], alone;
    double load[6] = {complete / 2, complete / 2, complete / 2, complete, complete, complete};
    uint64_t uncounted = 0;
    two_band_separation(twice, load, 6, stack, 1e-12, &uncounted);
    for (int i = 0; i < 6; i++) {
        two_band_separation(&alone, &load[i], 1, stack, 1e-12, &uncounted);
        assert_within(twice[i], alone, 1e-11 * alone);
    }
}

TEST_CASE(ladders_are_exact)
{
    static const char *const sets[] = {"law_a", "law_b", "random60"};
    struct material_pair pair = tin();
    for (size_t set = 0; set < 3; set++) {
        struct spectrum spectrum = reference_spectrum(sets[set]);
        struct multiscale stack = stack_of(&spectrum, &pair, false, INFINITY);
        ladder_is_exact(&stack);
        loads_may_come_twice(&stack);
        multiscale_free(&stack);
        spectrum_free(&spectrum);
    }
    /* a second band that completes before the first, at any part of its law, and after it */
    for (double amplitude_m = 1e-9; amplitude_m < 1e-6; amplitude_m *= 1.5) {
        struct two_band bands = {.amplitude_m = {1e-6, amplitude_m}, .frequency_per_m = {1e4, 1e5}};
        struct multiscale stack;
        struct status status = {0};
        assert_int_equal(two_band_stack(&stack, &bands, &pair, false, INFINITY, SINUSOID_FIT_THESIS, &status),
                         STATUS_OK);
        ladder_is_exact(&stack);
        loads_may_come_twice(&stack);
        multiscale_free(&stack);
    }
}
