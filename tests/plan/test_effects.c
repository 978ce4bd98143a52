/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How two bounds on a surface decide on effects. */
#include "contact/corrected_persson.h"
#include "plan/effects.h"
#include "support.h"

enum { HARMONICS = 2, SCANS = 2 };

static struct scene scene;
static struct plan plan;
static struct surface_record record;
static double amplitudes_m[1 + SCANS][HARMONICS]; /* of the mean and of the scans */
static struct member parts[SCANS];
static double weights[SCANS];
static const double loads[] = {1e-5, 1e-4};
static const struct surface_task asked = {.scene = &scene, .plan = &plan, .loads = loads, .load_count = 2};

/** A tin surface of 0.1 um and 10 nm, in models that have scale dependence. */
static int make(void **state)
{
    (void)state;
    scene = (struct scene){.effects_auto = true, .tolerance = 1e-8, .convergence.load = 1e-3};
    plan = (struct plan){
        .running = (1u << EFFECT_COUNT) - 1, .wanted = (1u << QUANTITY_COUNT) - 1, .models = model_find("multiscale")};
    record = (struct surface_record){
        .summary = {.usable = true,
                    .length_m = 1e-3,
                    .spacing_m = 1e-6,
                    .tail.gamma = NAN,
                    .pair = material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL)}};
    for (int k = 0; k < 1 + SCANS; k++)
        memcpy(amplitudes_m[k], (double[HARMONICS]){1e-7, 1e-8}, sizeof amplitudes_m[k]);
    record.spectrum = (struct spectrum){amplitudes_m[0], HARMONICS, 1e-3, false};
    return 0;
}

static void bound(void)
{
    record.summary.pressure_over_hardness = record.summary.scale_dependence = 0;
    expect_ok(effects_bound, &record, &asked);
}

static void add_scans(void)
{
    for (size_t p = 0; p < SCANS; p++) {
        parts[p] = (struct member){.spectrum = {amplitudes_m[p + 1], HARMONICS, 1e-3, false}, .scan = p};
        weights[p] = 1;
    }
    record.ensemble = (struct ensemble){.members = parts, .count = SCANS, .scan_weight = weights, .scan_count = SCANS};
}

#define PLACED(name) TEST_WITH(name, make, NULL)

/** Four times the pressure at A/A_n = 0.97 over the hardness. */
static double expected(double m2)
{
    const struct material_pair *pair = &record.summary.pair;
    return 4 * corrected_persson_load(0.97, m2) / 0.97 * pair->effective_modulus_Pa / pair->hardness_Pa;
}

PLACED(test_pressure_of_the_surface_its_scans_and_the_waves_below)
{
    bound();
    assert_near(record.summary.pressure_over_hardness, expected(spectrum_moment(&record.spectrum, 1)), 1e-12);
    add_scans();
    amplitudes_m[2][0] = 3e-7;
    bound();
    assert_near(record.summary.pressure_over_hardness, expected(spectrum_moment(&parts[1].spectrum, 1)), 1e-12);
    record.summary.tail =
        (struct convergence_tail){.wavelength_m = 1e-4, .amplitude_m = 1e-8, .gamma = 0.5, .count = HARMONICS};
    bound();
    double slope = 1e-8 * sqrt(convergence_atom_m / 1e-4) / convergence_atom_m; /* of the tail at an atom's length */
    assert_near(record.summary.pressure_over_hardness, expected(2 * pow(M_PI * slope, 2)), 1e-9);
    record.summary.tail.gamma = 1; /* no steeper than what is known */
    bound();
    assert_near(record.summary.pressure_over_hardness, expected(spectrum_moment(&parts[1].spectrum, 1)), 1e-12);
}

PLACED(test_scale_dependence_is_the_elastic_models_own)
{
    struct contact_point points[3];
    struct model_curve curve = {.points = points};
    struct model_task task = surface_model_task(&record, &asked);
    bound();
    expect_ok(model_run, &curve, model_rows[model_named("multiscale-elastic")], &task);
    double first = points[0].value[QUANTITY_TCR_SCALE_DEPENDENT] / points[0].value[QUANTITY_TCR] - 1;
    assert_true(first > 0);
    assert_near(record.summary.scale_dependence, first, 1e-12);
    plan_decide(&plan, EFFECT_SCALE_DEPENDENT, false, "not asked");
    bound();
    assert_true(record.summary.scale_dependence == 0);
    scene.effects_auto = false;
    bound();
    assert_true(record.summary.pressure_over_hardness == 0);
}

/** No line is removed from periodic scans unless asked for; a filter with lambda_c counts as no levelling. */
PLACED(test_levelled)
{
    static const struct {
        enum level level;
        bool given;
        size_t periodic;
        double lambda_c_m;
        bool levelled;
    } cases[] = {{LEVEL_LINE, false, 0, 0, true}, {LEVEL_ROBUST, true, 0, 0, true},
                 {LEVEL_MEAN, true, 0, 0, false}, {LEVEL_LINE, false, 1, 0, false},
                 {LEVEL_LINE, true, 1, 0, true},  {LEVEL_LINE, false, 0, 1e-3, false}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        scene.level = cases[i].level;
        scene.level_given = cases[i].given;
        scene.lambda_c_m = cases[i].lambda_c_m;
        record.summary.periodic = cases[i].periodic;
        assert_int_equal(surface_model_task(&record, &asked).levelled, cases[i].levelled);
    }
}

static void decide(double pressure, double raise)
{
    plan.running = (1u << EFFECT_COUNT) - 1;
    record.summary.pressure_over_hardness = pressure;
    record.summary.scale_dependence = raise;
    effects_decide(&plan, &scene, &record, 1);
}

/* The convergence study runs only if its key is given or the effect is listed. */
PLACED(test_convergence_is_asked_for)
{
    struct plan made;
    scene.models = (1u << model_count) - 1;
    plan_make(&made, &scene, support_words());
    assert_false(plan_runs(&made, EFFECT_CONVERGENCE));
    assert_string_equal(made.reasons[EFFECT_CONVERGENCE], "no 'convergence' is given");
    scene.convergence.given = true;
    plan_make(&made, &scene, support_words());
    assert_true(plan_runs(&made, EFFECT_CONVERGENCE));
    assert_string_equal(made.reasons[EFFECT_CONVERGENCE], "the scene has 'convergence'");
    scene.convergence.given = false;
    scene.effects = EFFECT_BIT(EFFECT_CONVERGENCE);
    plan_make(&made, &scene, support_words());
    assert_true(plan_runs(&made, EFFECT_CONVERGENCE));
    assert_string_equal(made.reasons[EFFECT_CONVERGENCE], "called for");
    scene.effects = 0;
}

/* (1 + r^4)^(1/4) - 1 = 1e-4 at r = 0.14143. */
PLACED(test_decisions)
{
    plan.words = support_words();
    scene.tolerance = 1e-4;
    decide(0.1415, 1.01e-4);
    assert_true(plan_runs(&plan, EFFECT_PLASTICITY) && plan_runs(&plan, EFFECT_SCALE_DEPENDENT));
    assert_string_equal(plan.reasons[EFFECT_PLASTICITY], "spots might bear up to 0.14 times the hardness");
    assert_string_equal(plan.reasons[EFFECT_SCALE_DEPENDENT], "(8/3π) λmfp/a raises TCR by up to 0.010 %");
    assert_true(plan_runs(&plan, EFFECT_CONVERGENCE));
    decide(0.1413, 0.99e-4);
    assert_false(plan_runs(&plan, EFFECT_PLASTICITY) || plan_runs(&plan, EFFECT_SCALE_DEPENDENT));
    assert_string_equal(
        plan.reasons[EFFECT_PLASTICITY],
        "no spot bears more than 0.14 times the hardness: 0.010 % of the area at most, below the tolerance");
    assert_string_equal(plan.reasons[EFFECT_SCALE_DEPENDENT],
                        "(8/3π) λmfp/a raises TCR by up to 0.0099 %, below the tolerance");
    assert_false(plan.wanted & QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT));
    decide(1e-3, 0); /* r^4/4, which would be lost in 1 + r^4 */
    assert_non_null(strstr(plan.reasons[EFFECT_PLASTICITY], ": 2.5·10⁻¹¹ % of the area"));
    decide(INFINITY, INFINITY); /* beyond what can be computed with: no number is written so */
    assert_string_equal(plan.reasons[EFFECT_PLASTICITY], "spots might bear up to 1.8·10³⁰⁸ times the hardness");
    assert_string_equal(plan.reasons[EFFECT_SCALE_DEPENDENT], "(8/3π) λmfp/a raises TCR by up to 1.8·10³⁰⁸ %");
    scene.effects_auto = false; /* listed: run */
    decide(0, 0);
    assert_true(plan_runs(&plan, EFFECT_PLASTICITY) && plan_runs(&plan, EFFECT_SCALE_DEPENDENT));
}

/* A plastic model without elastic partner runs if named, else only if another model needs plasticity. */
PLACED(test_models_without_an_elastic_partner)
{
    plan.models |= MODEL_BIT(model_named("cmy"));
    decide(0, 0);
    assert_false(plan_runs(&plan, EFFECT_PLASTICITY));
    scene.models_named = true;
    decide(0, 0);
    assert_true(plan_runs(&plan, EFFECT_PLASTICITY));
}

/** The direct solution of maps leads if all surfaces have one, stands aside if some have, and does not run if it is too
 * expensive for one of them or none has a map. */
PLACED(test_maps_lead_where_all_are)
{
    static const struct {
        struct {
            double cost;
            bool has;
        } of[2];
        bool runs, leads;
    } cases[] = {{{{1e9, true}, {1e9, true}}, true, true},
                 {{{1e9, true}, {0, false}}, true, false},
                 {{{1e9, true}, {1e12, false}}, false, false},
                 {{{0, false}, {0, false}}, false, false}};
    const size_t direct = model_named("direct");
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        struct surface_record two[2] = {record, record};
        struct plan own = plan;
        own.models = model_defaults();
        for (int k = 0; k < 2; k++) {
            two[k].summary.has_strips = true;
            two[k].summary.tile_cost = cases[c].of[k].cost;
            two[k].summary.has_tiles = cases[c].of[k].has;
        }
        effects_fit_models(&own, two, 2);
        assert_true(plan_runs_model(&own, direct) == cases[c].runs);
        assert_true(model_rows[plan_leading_model(&own)]->uses_map == cases[c].leads);
    }
}
