/* SPDX-License-Identifier: GPL-3.0-or-later */
/* comparison_make() on curves made up to order: every ratio worked out by hand. */
#include "directory.h"
#include "made_up_results.h"
#include "support.h"

static struct made_up made;

static int end(void **state)
{
    (void)state;
    made_up_free(&made);
    return 0;
}

#define PLACED(name) TEST_WITH(name, NULL, end)

/* Powers of the load: see made_up_results.h. Loads 1e-6 ... 1e-2, so that i = 4 is the middle. */
PLACED(test_power_laws)
{
    made_up_make(&made, NULL);
    const size_t leading = model_named("multiscale-plastic");
    assert_int_equal(plan_leading_model(&made.plan), leading);
    assert_near(comparison_middle(&made.results, leading, 0).value[QUANTITY_AREA], 0.1, 1e-12);
    assert_near(comparison_middle(&made.results, leading, 1).value[QUANTITY_AREA], 0.2, 1e-12);
    assert_near(comparison_middle(&made.results, leading, 2).value[QUANTITY_ECR], 3.75e-10, 1e-12);
    assert_true(isnan(comparison_middle(&made.results, leading, 3).value[QUANTITY_LOAD])); /* refused */
}

/** Bands of their own: the first surface's narrow, the second's scattered. */
static void band_each(struct surface_record *record, size_t index)
{
    static const double band_m[][2] = {{1e-6, 5e-6}, {1e-5, 2e-5}, {2e-6, 1e-4}, {1, 1}};
    static const enum power_law_band_class found[] = {POWER_LAW_BAND_NARROW, POWER_LAW_BAND_SCATTERED,
                                                      POWER_LAW_BAND_LAW, POWER_LAW_BAND_LAW};
    memcpy(record->summary.power_law.band_m, band_m[index], sizeof band_m[index]);
    record->summary.power_law.found = found[index];
}

/* Table 6.2 compares amplitudes in the middle of what the bands share, without narrow and scattered ones, and
 * docs/report.md says so. */
PLACED(test_where_laws_are_compared)
{
    made_up_make_of(&made, MODEL_BIT(model_named("jg")), 0, band_each);
    assert_near(results_law_wavelength_m(&made.results), sqrt(2e-6 * 1e-4), 1e-12);
    made.surfaces[2].summary.power_law.found = POWER_LAW_BAND_NARROW;
    assert_true(isnan(results_law_wavelength_m(&made.results)));
    assert_non_null(strstr(directory_read(PROJECT_SOURCE, "docs/report.md"),
                           "(the middle of what the bands share, narrow and scattered ones left out; where no other is "
                           "left, of each band)"));
}

/** JG of the first surface ends below the middle load, and the second has none. */
static void cut_short(struct surface_record *record, size_t index)
{
    struct model_curve *jg = &record->curves[model_named("jg")];
    jg->count = index == 0 ? 4 : jg->count;
    jg->exists = index != 1;
}

/* What the leading model shows: of JG the adjusted separation, over sigma, and of what is cut short nothing. */
PLACED(test_what_is_shown)
{
    made_up_make_of(&made, MODEL_BIT(model_named("jg")), (1u << EFFECT_COUNT) - 1, cut_short);
    const size_t jg = model_named("jg");
    for (size_t i = 0; i < MADE_UP_USABLE; i++) {
        const struct contact_point at = comparison_middle(&made.results, jg, i);
        double gap = comparison_value(&at, QUANTITY_SEPARATION, jg, made_up_surface(&made, i)->asperities.sigma_m);
        if (i == 2)
            assert_near(gap, 1 - 200 * 0.8 * 1e-4, 1e-12);
        else
            assert_true(isnan(gap));
    }
}

/* The last halving of the wavelength: from the scale in the middle to the last. */
PLACED(test_a_settled_sweep)
{
    made_up_make(&made, NULL);
    size_t model = model_named("multiscale-plastic");
    made_up_sweep(&made, CONVERGENCE_GAMMA, "multiscale-plastic", 3, 0.5 * 0.99901);
    assert_true(comparison_converges(&made.results, CONVERGENCE_GAMMA, model, 3));
    made_up_sweep(&made, CONVERGENCE_GAMMA, "multiscale-plastic", 3, 0.5 * 0.99899);
    assert_false(comparison_converges(&made.results, CONVERGENCE_GAMMA, model, 3));
    made.scene.convergence.scales = 1;
    assert_true(comparison_converges(&made.results, CONVERGENCE_ALPHA, model, 0));
    made.scene.convergence.scales = MADE_UP_SCALES;
}

/* Where the scene says no load, a model that yields is swept at a hundredth of the hardness, below which not all of a
 * scale yields at once; the elastic one, and what a scene asks for, stay. */
PLACED(test_loads_of_sweeps)
{
    made_up_make(&made, NULL);
    const struct material_pair *pair = results_pair(&made.results, made.results.baseline);
    size_t plastic = model_named("multiscale-plastic"), elastic = model_named("multiscale-elastic");
    const bool given = made.scene.convergence.load_given;
    made.scene.convergence.load_given = false;
    assert_near(results_sweep_load(&made.results, elastic), made.scene.convergence.load, 1e-15);
    made.scene.convergence.load = 1;
    assert_near(material_pair_pressure(pair, results_sweep_load(&made.results, plastic)), pair->hardness_Pa / 100,
                1e-12);
    made.scene.convergence.load = 1e-12;
    assert_near(results_sweep_load(&made.results, plastic), 1e-12, 1e-12);
    made.scene.convergence = (struct scene_convergence){.load_given = true, .load = 1};
    assert_near(results_sweep_load(&made.results, plastic), 1, 1e-15);
    made.scene.convergence.load_given = given;
}

/* A leading strip over Gaussian heights of the same material law; nothing where one has no number or does not run. */
PLACED(test_heights_factor)
{
    made_up_make(&made, NULL);
    assert_true(isnan(comparison_heights_factor(&made.results, 1))); /* multiscale leads */
    struct curve_summary strip = {.exists = true}, gaussian = {.exists = true};
    size_t s = model_named("strip"), g = model_named("corrected-persson");
    struct curve_summary **models = made_up_surface(&made, 1)->models, *before[] = {models[s], models[g]};
    strip.operating.value[QUANTITY_ECR] = 6e-9;
    gaussian.operating.value[QUANTITY_ECR] = 2e-9;
    models[s] = &strip;
    models[g] = &gaussian;
    made.plan.models |= MODEL_BIT(s) | MODEL_BIT(g);
    double factor = comparison_heights_factor(&made.results, 1);
    strip.operating.value[QUANTITY_ECR] = INFINITY; /* a filler keeps the metals apart */
    double apart = comparison_heights_factor(&made.results, 1);
    gaussian.exists = false;
    double without = comparison_heights_factor(&made.results, 1);
    made.plan.models &= ~MODEL_BIT(g);
    double alone = comparison_heights_factor(&made.results, 1);
    models[s] = before[0];
    models[g] = before[1];
    assert_near(factor, 3, 1e-12);
    assert_true(isnan(apart) && isnan(without) && isnan(alone));
}

/* Four surfaces of one scan each, of which one scatters little by chance: it is not told apart where it would be by its
 * own scatter alone, as two surfaces are, or one of more scans. */
TEST_CASE(test_a_scan_that_scatters_little_by_chance)
{
    struct estimate of[] = {estimate_of_error(1, 0.3, 4), estimate_of_error(1.1, 0.3, 4),
                            estimate_of_error(2.2, 0.02, 4), estimate_of_error(2.2, 0.02, 4)};
    const struct estimate *estimates[] = {&of[0], &of[1], &of[2], &of[3]};
    const struct comparison_pair two = comparison_of_two(&of[0], &of[2]);
    for (size_t scans = 1; scans < 4; scans += 2) {
        struct comparison ranking = {.count = 4};
        of[2].count = of[3].count = scans;
        expect_ok(comparison_test, &ranking, estimates);
        const struct comparison_pair *pair = comparison_pair_of(&ranking, 0, 2);
        assert_true((pair->high - pair->low > 1.01 * (two.high - two.low)) == (scans == 1));
        comparison_free(&ranking);
    }
}
