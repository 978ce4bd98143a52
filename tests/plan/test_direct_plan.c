/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plan of a direct solution: the matched law, loads, hardness, and choices within a budget. */
#include "plan/direct_plan.h"
#include "support.h"

enum { LOADS = 121 };

static double loads[LOADS];
static struct spectrum smooth; /* of the scan */

static void fill_loads(void)
{
    for (int i = 0; i < LOADS; i++)
        loads[i] = pow(10, -6 + 5.0 * i / (LOADS - 1));
}

/** A profile of 300 um, cut off at 8 um. */
static struct direct_plan_task a_task(const struct scene_direct *direct)
{
    return (struct direct_plan_task){.direct = direct,
                                     .divisor = 1,
                                     .operating = LOADS / 2,
                                     .loads = loads,
                                     .load_count = LOADS,
                                     .length_m = 3e-4,
                                     .lambda_s_m = 8e-6,
                                     .slope = 0.02,
                                     .spectrum = &smooth,
                                     .hardness = INFINITY,
                                     .resistance = true,
                                     .gaussian = true};
}

static struct spectrum rough_spectrum(size_t count)
{
    struct spectrum spectrum = {malloc(count * sizeof(double)), count, 3e-4, false};
    assert_non_null(spectrum.amplitude_m);
    for (size_t i = 0; i < count; i++) /* steep, with an uneven part */
        spectrum.amplitude_m[i] = 3e-7 * pow((double)(i + 1), -1.3) * (1 + 0.5 * sin(2.3 * (double)i));
    return spectrum;
}

/** m0, m1 and m2 of the law's rows over those of the spectrum, low-passed below `cut_m` as the law is. */
static void assert_moments(const struct direct_law *law, const struct spectrum *spectrum, double cut_m)
{
    double of_law[3] = {0}, of_scan[3] = {0};
    for (size_t m = 1; m <= direct_law_harmonics(law); m++)
        for (int k = 0; k < 3; k++)
            of_law[k] += pow(2 * M_PI * (double)m / 3e-4, k) * pow(direct_law_amplitude(law, m), 2) / 2;
    for (size_t i = 0; i < spectrum->count; i++) {
        double above = cut_m * (double)(i + 1) / 3e-4, share = above > 1 ? exp(-log(2) * (above * above - 1)) : 1;
        for (int k = 0; k < 3; k++)
            of_scan[k] += pow(2 * M_PI * (double)(i + 1) / 3e-4, k) * pow(share * spectrum->amplitude_m[i], 2) / 2;
    }
    for (int k = 0; k < 3; k++)
        assert_near(of_law[k], of_scan[k], 1e-9);
}

TEST_CASE(the_law_has_the_scans_moments)
{
    struct direct_plan plan;
    struct spectrum noisy = rough_spectrum(500);
    struct direct_plan_task task = a_task(&(struct scene_direct){.seeds = 1});
    direct_plan_make(&plan, &task);
    assert_int_equal(plan.grid, 256);
    assert_false(plan.coarse);
    assert_true(plan.possible);
    assert_moments(&plan.law, &smooth, 0);
    task = a_task(&(struct scene_direct){.seeds = 1, .grid = 64});
    task.spectrum = &noisy;
    direct_plan_make(&plan, &task);
    assert_true(plan.coarse);
    assert_near(plan.lambda_s_m, 6 * 3e-4 / 64, 1e-12);
    assert_moments(&plan.law, &noisy, plan.lambda_s_m);
    spectrum_free(&noisy);
}

/* Loads are the scene's own, the middle one among them, where the grid resolves the contact. */
TEST_CASE(loads_are_the_scenes)
{
    struct direct_plan plan;
    struct direct_plan_task task = a_task(&(struct scene_direct){.seeds = 2});
    task.hardness = 8e-4;
    direct_plan_make(&plan, &task);
    assert_int_equal(plan.loads, 13);
    for (size_t k = 0; k < plan.loads; k++) {
        size_t i = 0;
        while (i < LOADS && loads[i] != plan.load[k])
            i++;
        assert_true(i < LOADS);
        assert_true(k == 0 || plan.load[k] > plan.load[k - 1]);
        assert_true(plan.load[k] * 2 / (M_SQRT2 * 0.02) * 256 * 256 > 100); /* points in contact */
        assert_true((plan.load[k] < 8e-4) == (k < plan.capped_loads));
    }
    assert_true(plan.capped_loads > 0);
    task.hardness = INFINITY;
    direct_plan_make(&plan, &task);
    assert_int_equal(plan.capped_loads, 0);
    task = a_task(&(struct scene_direct){.seeds = 2, .loads = 2, .values = (double[]){1e-4, 3e-4}});
    direct_plan_make(&plan, &task);
    assert_int_equal(plan.loads, 2);
    assert_near(plan.load[1], 3e-4, 0);
}

/* More budget never buys a coarser grid, nor fewer surfaces on the same one. */
TEST_CASE(a_budget_buys_in_order)
{
    struct direct_plan plan, before = {0};
    for (double budget = 0.01; budget < 100; budget *= 1.3) {
        struct direct_plan_task task = a_task(&(struct scene_direct){.budget_s = budget});
        direct_plan_make(&plan, &task);
        assert_true(plan.over_budget || plan.seconds <= budget);
        assert_true(plan.grid > before.grid ||
                    (plan.grid == before.grid && (plan.seeds >= before.seeds || plan.fine_times > before.fine_times)));
        assert_true(plan.grid <= 256);
        before = plan;
    }
    assert_int_equal(plan.grid, 256);
    assert_int_equal(plan.seeds, 12);
    assert_int_equal(plan.fine_times, 2);
}

/* A hardness is solved on four surfaces, unless the scene asks for fewer, and costs time; so does making surfaces with
 * a scan's heights. */
TEST_CASE(time_is_counted)
{
    struct direct_plan elastic, capped, heights;
    struct direct_plan_task task = a_task(&(struct scene_direct){.seeds = 12});
    direct_plan_make(&elastic, &task);
    assert_near(elastic.seconds, 13 * 0.020 * (12 + pow(2, 2.15)), 1e-12); /* with the finer grid of the first */
    task.gaussian = false;
    direct_plan_make(&heights, &task);
    assert_near(heights.seconds - elastic.seconds, 0.020 * 7.5 * 13, 1e-12); /* the first made twice */
    task.hardness = 8e-4;
    direct_plan_make(&capped, &task);
    assert_int_equal(capped.fewer, 4);
    assert_true(capped.seconds > 1.1 * heights.seconds);
    task = a_task(&(struct scene_direct){.seeds = 1});
    direct_plan_make(&capped, &task);
    assert_int_equal(capped.fewer, 1);
}

/* Without a known cut-off it is four spacings of the scan, unless the grid is coarser. */
TEST_CASE(four_spacings_are_said)
{
    struct direct_plan plan;
    struct direct_plan_task task = a_task(&(struct scene_direct){.seeds = 1});
    direct_plan_make(&plan, &task);
    assert_false(plan.of_spacing);
    task.of_spacing = true;
    direct_plan_make(&plan, &task);
    assert_true(plan.of_spacing);
    task.direct = &(struct scene_direct){.seeds = 1, .grid = 64};
    direct_plan_make(&plan, &task);
    assert_true(plan.coarse && !plan.of_spacing);
}

static double heights[101 * 101]; /* of a map */

TEST_CASE(a_map_is_one_surface)
{
    struct direct_plan plan;
    struct direct_plan_task task = a_task(&(struct scene_direct){.grid = 64, .seeds = 5});
    task.height_m = heights;
    task.map = (struct direct_map_def){101, 101, 3e-4 / 101, 3e-4 / 101, false, 6, false, false};
    direct_plan_make(&plan, &task);
    assert_int_equal(plan.side, 100); /* transforms of 101 points are slow */
    assert_int_equal(plan.grid, 200);
    assert_int_equal(plan.seeds, 1);
    assert_int_equal(plan.fine_times, 0);
    assert_near(plan.length_m, 2 * 3e-4 * 100 / 101, 1e-12);
    assert_near(plan.seconds, 0.45e-6 * 100 * 100 * (double)plan.loads * (1 + 6. / 4), 1e-12); /* not of the images */
    assert_near(plan.lambda_s_m, 6 * task.map.dx_m, 1e-12);
    task.map = (struct direct_map_def){100,  100, 3e-6,  3e-6,
                                       true, 0,   false, false}; /* clean and whole: neither filter nor mirror */
    direct_plan_make(&plan, &task);
    assert_int_equal(plan.grid, 100);
    assert_near(plan.length_m, 3e-4, 1e-12);
    assert_true(plan.lambda_s_m == 0);
    assert_near(plan.seconds, 0.45e-6 * 100 * 100 * (double)plan.loads * (1 + 1. / 4), 1e-12);
}

/* What direct_map_make() would refuse is known before anything runs. */
TEST_CASE(a_map_that_cannot_be_solved)
{
    static double most_missing[101 * 101];
    struct direct_plan plan;
    struct direct_plan_task task = a_task(&(struct scene_direct){.grid = 64});
    task.map = (struct direct_map_def){101, 101, 3e-6, 6e-6, false, 6, false, false};
    task.height_m = heights;
    direct_plan_make(&plan, &task);
    assert_false(plan.possible);
    assert_true(plan.seconds == 0);
    expect_parts(direct_plan_problem(&plan, support_words()), "spacings of 3e-06 m along and 6e-06 m across the rows");
    task.map.dy_m = task.map.dx_m;
    for (size_t k = 0; k < 101 * 101; k++)
        most_missing[k] = k % 101 < 49 ? 0 : NAN;
    task.height_m = most_missing;
    direct_plan_make(&plan, &task);
    assert_false(plan.possible);
    expect_parts(direct_plan_problem(&plan, support_words()), "5100 of the map's 10000 points are missing");
}

TEST_CASE(no_load_is_said)
{
    static const double one = 1e-9;
    struct direct_plan plan;
    struct direct_plan_task task = a_task(&(struct scene_direct){.grid = 64});
    task.loads = &one;
    task.load_count = 1;
    task.operating = 0;
    direct_plan_make(&plan, &task);
    assert_false(plan.possible);
    assert_true(0 < plan.range[0] && plan.range[0] < plan.range[1]);
    plan.range[0] = 2e-5;
    plan.range[1] = 0.25;
    assert_string_equal(direct_plan_problem(&plan, support_words()),
                        "no load of the scene lies between 2e-05 and 0.25 E', where the grid of 64 points a side "
                        "resolves the contact");
}

static int set_up(void **state)
{
    (void)state;
    fill_loads();
    smooth = rough_spectrum(40);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    spectrum_free(&smooth);
    return 0;
}

TEST_GROUP(set_up, tear_down)
