/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What ranks solve together is what one process solves. Run by mpirun; how many ranks it should find is the argument.
 */
#include "direct/direct_ensemble.h"
#include "direct_points.h"
#include "ranks/ranks.h"
#include "support.h"

#include <pthread.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

static const double loads[] = {5e-3, 0.1};
enum { LOADS = sizeof loads / sizeof loads[0], N = 128 };

static const struct direct_team *team;

static struct direct_spectrum spectrum_of_law(void)
{
    struct direct_law law = {1, 1.2, 1.0 / 20, 1, 1};
    struct direct_spectrum spectrum;
    struct status status = {0};
    double slope = 0;
    for (size_t m = 1; m <= direct_law_harmonics(&law); m++)
        slope += pow(2 * M_PI * (double)m * direct_law_amplitude(&law, m), 2);
    law.alpha = 0.1 / sqrt(slope);
    assert_int_equal(direct_spectrum_of_law(&spectrum, &law, &status), STATUS_OK);
    return spectrum;
}

/** Ensembles with and without a finer grid, given heights, a hardness below the last load. */
static void ensembles(void **state)
{
    (void)state;
    static const struct {
        size_t fine_times, seeds, given;
        double hardness;
    } cases[] = {{2, 2, 0, INFINITY}, {2, 1, 200, INFINITY}, {0, 3, 0, 0.05}};
    struct direct_spectrum spectrum = spectrum_of_law();
    double given[200];
    for (size_t k = 0; k < 200; k++)
        given[k] = pow((double)k, 2);
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        struct direct_ensemble_def def = {.ladder = {loads, LOADS, cases[c].hardness, 1e-6, true, NULL},
                                          .length_m = 1,
                                          .n = N,
                                          .fine_times = cases[c].fine_times,
                                          .variance = direct_spectrum_variance,
                                          .context = &spectrum,
                                          .given_m = cases[c].given ? given : NULL,
                                          .given_count = cases[c].given,
                                          .seeds = cases[c].seeds,
                                          .threads = 2};
        struct direct_ensemble found, expected;
        struct status status = {0};
        assert_int_equal(direct_ensemble_run(&expected, &def, &status), STATUS_OK);
        def.team = team;
        assert_int_equal(direct_ensemble_run(&found, &def, &status), STATUS_OK);
        assert_int_equal(found.seeds, expected.seeds);
        expect_same(found.seed_point, expected.seed_point, found.seeds * LOADS);
        for (size_t i = 0; i < LOADS; i++) {
            struct direct_mean one = found.point[i].mean[DIRECT_GAP], two = expected.point[i].mean[DIRECT_GAP];
            assert_int_equal(isnan(one.value), isnan(two.value));
            if (isnan(two.value))
                continue;
            assert_near(one.value, two.value, 1e-9);
            assert_near(one.fine_ratio, two.fine_ratio, 1e-9);
        }
        direct_ensemble_free(&found);
        direct_ensemble_free(&expected);
    }
    direct_spectrum_free(&spectrum);
}

static enum status_code solve(struct direct_point *out, const double *height, const struct direct_team *by,
                              const atomic_bool *stop, struct status *status)
{
    struct direct_ladder_def ladder = {loads, LOADS, INFINITY, 1e-6, true, stop};
    double *copy = malloc(N * N * sizeof *copy);
    assert_non_null(copy);
    memcpy(copy, height, N * N * sizeof *copy);
    *status = (struct status){0};
    return direct_ladder_of_heights(out, copy, N, 1.0 / N, &ladder, by, status);
}

/** The first rank's stop ends all, and so does what one rank finds wrong; and the
 * ranks are there for the next surface. */
static void heights_errors_and_stop(void **state)
{
    (void)state;
    static const atomic_bool stop = true;
    struct direct_spectrum spectrum = spectrum_of_law();
    struct direct_point expected[LOADS], found[LOADS];
    double *height = malloc(N * N * sizeof *height);
    struct status status = {0};
    assert_non_null(height);
    assert_int_equal(direct_surface_make(height, N, direct_spectrum_variance, &spectrum, NULL, 0, 1, &status),
                     STATUS_OK);
    assert_int_equal(solve(expected, height, NULL, NULL, &status), STATUS_OK);
    for (int round = 0; round < 2; round++) {
        double last = height[N * N - 1];
        assert_int_equal(solve(found, height, team, NULL, &status), STATUS_OK);
        expect_same(found, expected, LOADS);
        assert_int_equal(solve(found, height, team, &stop, &status), STATUS_INTERRUPTED);
        height[N * N - 1] = INFINITY; /* on the last rank */
        assert_int_equal(solve(found, height, team, NULL, &status), STATUS_MODEL);
        assert_non_null(strstr(status.message, "height 16383 of the surface"));
        height[N * N - 1] = last;
    }
    free(height);
    direct_spectrum_free(&spectrum);
}

/** What a rank that waits uses of its processor in half a second; the first one sleeps for so long. */
static void *watch(void *used)
{
    const struct timespec pause = {.tv_nsec = 250000000}, half = {.tv_nsec = 500000000};
    struct timespec begun, ended;
    nanosleep(&pause, NULL); /* MPI starts threads of its own */
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &begun);
    nanosleep(&half, NULL);
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &ended);
    *(double *)used = (double)(ended.tv_sec - begun.tv_sec) + 1e-9 * (double)(ended.tv_nsec - begun.tv_nsec);
    return NULL;
}

/** Another rank than the first: leaves the processor to others while it waits. */
static int serve(void)
{
    pthread_t watcher;
    double used = 1;
    bool watched = pthread_create(&watcher, NULL, watch, &used) == 0;
    ranks_serve(NULL);
    if (watched)
        pthread_join(watcher, NULL);
    if (used > 0.1)
        fprintf(stderr, "a rank that waits used the processor for %.2f s of half a second\n", used);
    return used > 0.1;
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(ensembles), cmocka_unit_test(heights_errors_and_stop)};
    team = ranks_begin(&argc, &argv);
    if (team && team->rank > 0)
        return serve();
    sleep(1);
    int failed = (team ? team->size : 1) != (argc > 1 ? strtoul(argv[1], NULL, 10) : 1);
    failed += cmocka_run_group_tests(tests, NULL, NULL);
    ranks_end();
    return failed;
}
