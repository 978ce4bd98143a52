/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What ranks solve for the first of them is what it would solve alone. Run by mpirun; how many ranks it should find is
 * the argument. */
#include "direct/direct_ensemble.h"
#include "direct_points.h"
#include "ranks/ranks.h"
#include "support.h"

static const double loads[] = {5e-3, 0.1};
enum { LOADS = sizeof loads / sizeof loads[0], SEEDS = 4 };

static const struct direct_crew *crew;

static struct direct_spectrum spectrum_of_law(void)
{
    struct direct_law law = {1, 1.2, 1.0 / 20, 1};
    struct direct_spectrum spectrum;
    struct status status = {0};
    double slope = 0;
    for (size_t m = 1; m <= direct_law_harmonics(&law); m++)
        slope += pow(2 * M_PI * (double)m * direct_law_amplitude(&law, m), 2);
    law.alpha = 0.1 / sqrt(slope);
    assert_int_equal(direct_spectrum_of_law(&spectrum, &law, &status), STATUS_OK);
    return spectrum;
}

static void expect_number(double found, double expected)
{
    if (isnan(expected)) /* no number at this load, or no error from one surface */
        assert_true(isnan(found));
    else
        assert_near(found, expected, 1e-9);
}

static void expect_mean(struct direct_mean found, struct direct_mean expected)
{
    expect_number(found.value, expected.value);
    expect_number(found.standard_error, expected.standard_error);
    expect_number(found.fine_ratio, expected.fine_ratio);
}

/** An ensemble by the crew and alone. */
static void compare(struct direct_ensemble_def def)
{
    struct direct_ensemble found, expected;
    struct status status = {0};
    assert_int_equal(direct_ensemble_run(&expected, &def, &status), STATUS_OK);
    def.crew = crew;
    assert_int_equal(direct_ensemble_run(&found, &def, &status), STATUS_OK);
    assert_int_equal(found.seeds, expected.seeds);
    assert_near(found.rms_m, expected.rms_m, 1e-12);
    expect_same(found.seed_point, expected.seed_point, found.seeds * LOADS);
    for (size_t i = 0; i < LOADS; i++) {
        assert_int_equal(found.point[i].state, expected.point[i].state);
        expect_mean(found.point[i].area_ratio, expected.point[i].area_ratio);
        expect_mean(found.point[i].gap_m, expected.point[i].gap_m);
        expect_mean(found.point[i].constriction_m, expected.point[i].constriction_m);
        expect_mean(found.point[i].patches_per_m2, expected.point[i].patches_per_m2);
    }
    direct_ensemble_free(&found);
    direct_ensemble_free(&expected);
}

static void ensembles(void **state)
{
    (void)state;
    struct direct_spectrum spectrum = spectrum_of_law();
    double given[200];
    for (size_t k = 0; k < 200; k++)
        given[k] = pow((double)k, 2);
    struct direct_ensemble_def def = {.ladder = {loads, LOADS, INFINITY, 1e-6, true, NULL},
                                      .length_m = 1,
                                      .n = 128,
                                      .fine_times = 2,
                                      .variance = direct_spectrum_variance,
                                      .context = &spectrum,
                                      .first_seed = 3,
                                      .seeds = SEEDS,
                                      .threads = 1};
    compare(def); /* a surface a rank, the fine grid on all */
    def.seeds = 1;
    def.given_m = given;
    def.given_count = 200;
    compare(def); /* the surface on all ranks as well */
    def.fine_times = 0;
    def.ladder.hardness = 0.05; /* below the last load */
    def.given_m = NULL;
    def.threads = 2;
    def.enough = 1e-6; /* in batches of 4 */
    def.seeds = SEEDS + 1;
    compare(def);
    direct_spectrum_free(&spectrum);
}

static void heights(void **state)
{
    (void)state;
    enum { N = 128 };
    struct direct_spectrum spectrum = spectrum_of_law();
    struct direct_ladder_def ladder = {loads, LOADS, INFINITY, 1e-6, true, NULL};
    struct direct_point expected[LOADS], found[LOADS];
    uint8_t *touching = malloc(2 * N * N), *there = touching + N * N;
    double *height = malloc(N * N * sizeof *height);
    struct status status = {0};
    assert_true(touching && height);
    assert_int_equal(direct_surface_realise(height, N, direct_spectrum_variance, &spectrum, 1, &status), STATUS_OK);
    assert_int_equal(direct_ladder_of_heights(expected, touching, height, N, 1.0 / N, &ladder, NULL, &status),
                     STATUS_OK);
    memset(there, 2, N * N);
    assert_int_equal(direct_ladder_of_heights(found, there, height, N, 1.0 / N, &ladder, crew, &status), STATUS_OK);
    expect_same(found, expected, LOADS);
    assert_memory_equal(touching, there, N * N);
    assert_int_equal(direct_ladder_of_heights(found, NULL, height, N, 1.0 / N, &ladder, crew, &status), STATUS_OK);
    height[N * N - 1] = INFINITY; /* on the last rank */
    assert_int_equal(direct_ladder_of_heights(found, NULL, height, N, 1.0 / N, &ladder, crew, &status), STATUS_MODEL);
    assert_non_null(strstr(status.message, "height 16383 of the surface"));
    free(height);
    free(touching);
    direct_spectrum_free(&spectrum);
}

/** The first rank's stop ends all; so do errors; and the ranks are there for the next surfaces. */
static void errors_and_stop(void **state)
{
    (void)state;
    static const atomic_bool stop = true;
    struct direct_spectrum spectrum = spectrum_of_law();
    double equal[2] = {1, 1};
    struct direct_ensemble_def def = {.ladder = {loads, LOADS, INFINITY, 1e-6, true, &stop},
                                      .length_m = 1,
                                      .n = 128,
                                      .variance = direct_spectrum_variance,
                                      .context = &spectrum,
                                      .first_seed = 1,
                                      .seeds = 1,
                                      .threads = 1,
                                      .crew = crew};
    for (size_t seeds = 1; seeds <= 4; seeds += 3) { /* one on all ranks, and one a rank */
        struct direct_ensemble found;
        struct status status = {0};
        def.seeds = seeds;
        def.ladder.stop = &stop;
        def.given_m = NULL;
        assert_int_equal(direct_ensemble_run(&found, &def, &status), STATUS_INTERRUPTED);
        def.ladder.stop = NULL;
        def.given_m = equal;
        def.given_count = 2;
        status = (struct status){0};
        assert_int_equal(direct_ensemble_run(&found, &def, &status), STATUS_MODEL);
        assert_non_null(strstr(status.message, "all equal"));
    }
    def.given_m = NULL;
    compare(def);
    direct_spectrum_free(&spectrum);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(ensembles), cmocka_unit_test(heights),
                                       cmocka_unit_test(errors_and_stop)};
    const struct CMUnitTest alone[] = {cmocka_unit_test(ensembles)};
    const struct ranks_options each = {1}, all = {0};
    ranks_begin(&argc, &argv);
    if (!ranks_is_first()) {
        ranks_serve(NULL);
        return 0;
    }
    crew = ranks_crew(&all);
    int failed = (crew != NULL) != (argc > 1 && strcmp(argv[1], "1") != 0);
    failed += cmocka_run_group_tests_name("as many ranks a surface as there are", tests, NULL, NULL);
    crew = ranks_crew(&each);
    failed += cmocka_run_group_tests_name("one rank a surface", alone, NULL, NULL);
    ranks_end();
    return failed;
}
