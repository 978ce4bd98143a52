/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct_support.h"

#include "direct/direct_constriction.h"
#include "direct/direct_ensemble.h"

static const double loads[] = {1e-3, 5e-3, 0.02, 0.08, 0.3, 0.6};
enum { LOADS = sizeof loads / sizeof loads[0] };

static struct direct_ensemble_def def_of(const double *scale, unsigned threads)
{
    return (struct direct_ensemble_def){.ladder = {loads, LOADS, INFINITY, 1e-6, true, NULL},
                                        .length_m = 1,
                                        .n = 64,
                                        .fine_times = 2,
                                        .recipe = {recipe_variance, scale, NULL, 0},
                                        .seeds = 6,
                                        .threads = threads};
}

static struct direct_ensemble ensemble_of(const struct direct_ensemble_def *def)
{
    struct direct_ensemble ensemble;
    expect_ok(direct_ensemble_run, &ensemble, def);
    return ensemble;
}

/** Seed 1 is the golden surface; the mean, its error and the fine grid's ratio are those of the single solutions. */
TEST_CASE(means_of_single_solutions)
{
    double scale = recipe_scale();
    struct direct_ensemble_def def = def_of(&scale, 0);
    struct direct_ensemble found = ensemble_of(&def);
    double *coarse = recipe_surface(64), *fine = recipe_surface(128);
    struct direct_contact contact = contact_of(coarse, 64, 64), finer = contact_of(fine, 128, 128);
    assert_int_equal(found.seeds, 6);
    for (size_t i = 0; i < LOADS; i++) {
        const struct direct_ensemble_point *point = &found.point[i];
        struct direct_contact_load load = load_of(loads[i], INFINITY, 1e-9);
        struct direct_quantities one = solved(&contact, &load), two = solved(&finer, &load);
        double length = constriction_of(&contact, 1e-6), finer_length = constriction_of(&finer, 1e-6);
        assert_int_equal(found.seed_point[i].quantities.contact_points, one.contact_points);
        assert_near(found.seed_point[i].quantities.gap_m, one.gap_m, 1e-5);
        assert_near(found.seed_point[i].constriction_m, length, 1e-6);
        assert_true(found.seed_point[i].patches >= 1 && found.seed_point[i].patches <= one.contact_points);
        double gap = 0, square = 0, least = INFINITY;
        for (size_t k = 0; k < 6; k++) {
            gap += found.seed_point[k * LOADS + i].quantities.gap_m / 6;
            least = fmin(least, (double)found.seed_point[k * LOADS + i].quantities.contact_points);
        }
        for (size_t k = 0; k < 6; k++)
            square += pow(found.seed_point[k * LOADS + i].quantities.gap_m - gap, 2);
        assert_int_equal(isnan(point->mean[DIRECT_GAP].value), least < 100);
        assert_int_equal(isnan(point->mean[DIRECT_AREA].value), least < 100);
        if (least < 100)
            continue;
        double ratio = two.gap_m / one.gap_m;
        assert_near(point->mean[DIRECT_GAP].fine_ratio, ratio, 1e-5);
        assert_near(point->mean[DIRECT_GAP].value, gap * ratio, 1e-5);
        assert_near(point->mean[DIRECT_GAP].standard_error, sqrt(square / 5 / 6) * ratio, 1e-5);
        assert_near(point->mean[DIRECT_CONSTRICTION].fine_ratio, finer_length / length, 1e-5);
        assert_near(point->mean[DIRECT_AREA].fine_ratio, two.area_ratio / one.area_ratio, 1e-9);
    }
    assert_true(isnan(found.point[0].mean[DIRECT_GAP].value) && !isnan(found.point[LOADS - 1].mean[DIRECT_GAP].value));
    direct_ensemble_free(&found);
    direct_contact_free(&contact);
    direct_contact_free(&finer);
}

/** The same bytes from any number of threads, from Gaussian surfaces and from surfaces with given heights. */
TEST_CASE(threads_do_not_matter)
{
    double scale = recipe_scale(), given[200];
    for (size_t k = 0; k < 200; k++)
        given[k] = pow((double)k, 2);
    for (int skewed = 0; skewed < 2; skewed++) {
        struct direct_ensemble first = {0};
        for (unsigned threads = 1; threads <= 5; threads += 2) {
            struct direct_ensemble_def def = def_of(&scale, threads);
            def.recipe.given_m = skewed ? given : NULL;
            def.recipe.given_count = 200;
            struct direct_ensemble found = ensemble_of(&def);
            if (threads == 1) {
                first = found;
                continue;
            }
            for (size_t k = 0; k < 6 * LOADS; k++) {
                assert_true(first.seed_point[k].quantities.gap_m == found.seed_point[k].quantities.gap_m);
                assert_true(first.seed_point[k].constriction_m == found.seed_point[k].constriction_m);
                assert_int_equal(first.seed_point[k].convolutions, found.seed_point[k].convolutions);
            }
            assert_true(first.point[3].mean[DIRECT_GAP].value == found.point[3].mean[DIRECT_GAP].value);
            assert_true(first.point[3].mean[DIRECT_AREA].fine_ratio == found.point[3].mean[DIRECT_AREA].fine_ratio);
            direct_ensemble_free(&found);
        }
        direct_ensemble_free(&first);
    }
}

/** Under a hardness: no number from p̄ = H on, at least p̄/H in contact below it. */
TEST_CASE(ladder_with_a_hardness)
{
    double scale = recipe_scale();
    struct direct_ensemble_def def = def_of(&scale, 2);
    def.ladder.hardness = 0.3;
    struct direct_ensemble found = ensemble_of(&def);
    for (size_t i = 0; i < LOADS; i++) {
        const struct direct_mean *mean = found.point[i].mean;
        if (!isnan(mean[DIRECT_AREA].value)) {
            assert_true(loads[i] < 0.3 && mean[DIRECT_AREA].value > loads[i] / 0.3 - 0.05);
            assert_true(mean[DIRECT_GAP].fine_ratio != 1); /* the finer grid corrects these too */
            assert_within(mean[DIRECT_GAP].fine_ratio, 1, 0.05);
        }
        assert_true(found.seed_point[i].exists == (loads[i] < 0.3));
    }
    assert_true(!isnan(found.point[3].mean[DIRECT_GAP].value) && isnan(found.point[LOADS - 1].mean[DIRECT_GAP].value));
    direct_ensemble_free(&found);
}

struct told {
    double work, largest;
};

static void tell(void *context, double work)
{
    struct told *told = context;
    told->work += work;
    told->largest = fmax(told->largest, work);
}

/** What is told adds up to the work there is, in steps of no more than one load on the fine grid, or one surface made:
 * of surfaces with given heights too, and of a map with all its parts. */
TEST_CASE(work_is_told_step_by_step)
{
    double scale = recipe_scale(), *height_m = recipe_surface(64);
    for (int kind = 0; kind < 3; kind++) {
        struct told told = {0, 0};
        struct direct_map map = {0};
        struct direct_map_def square = {64, 64, 1.0 / 64, 1.0 / 64, false, 6, false, false};
        struct direct_ensemble_def def = def_of(&scale, 1);
        def.seeds = 2;
        def.solved = tell;
        def.solved_context = &told;
        def.recipe.given_m = kind == 1 ? height_m : NULL;
        def.recipe.given_count = 64 * 64;
        if (kind == 2) {
            expect_ok(direct_map_make, &map, height_m, &square, 64);
            def.map = &map;
            def.n = map.grid.nx;
        }
        struct direct_ensemble found = ensemble_of(&def);
        assert_near(told.work, direct_ensemble_work(&def), 1e-12);
        assert_true(told.largest <= fmax(4, direct_ensemble_making) * (double)(def.n * def.n));
        assert_true(told.largest < 0.25 * told.work);
        direct_ensemble_free(&found);
        direct_map_free(&map);
    }
}

/** Errors and the stop come through, of the first surface. */
TEST_CASE(errors_and_stop)
{
    double scale = recipe_scale(), negative = -1;
    static const atomic_bool stop = true;
    struct direct_ensemble_def def = def_of(&scale, 2);
    struct direct_ensemble found;
    def.ladder.stop = &stop;
    expect_fails(STATUS_INTERRUPTED, "", direct_ensemble_run, &found, &def);
    assert_null(found.point);
    def.ladder.stop = NULL;
    def.recipe.context = &negative;
    expect_fails(STATUS_MODEL, "", direct_ensemble_run, &found, &def);
}
