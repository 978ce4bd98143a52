/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How the models' bounds decide on effects. The program has a table of its own, of models whose bounds are known. */
#include "analysis/effects.h"
#include "support.h"

#include <stdio.h>

/* ---------------------------------------------------------------- models */

/** The amplitude of the first harmonic, in metres. */
static double amplitude_bound(const struct model_row *row, const struct model_task *task)
{
    (void)row;
    return task->spectrum->amplitude_m[0];
}

static double no_bound(const struct model_row *row, const struct model_task *task)
{
    (void)row, (void)task;
    return 0;
}

static void reason(char *out, size_t size, double bound, bool runs)
{
    snprintf(out, size, "%s %.3g", runs ? "yields" : "rests", bound);
}

static size_t asked; /* how often raise_bound() was */

/** Twice the amplitude. */
static enum status_code raise_bound(double *most, const struct model_row *row, const struct model_task *task,
                                    struct status *status)
{
    (void)row, (void)status;
    *most = 2 * task->spectrum->amplitude_m[0];
    asked++;
    return STATUS_OK;
}

enum { ALL = (1u << QUANTITY_COUNT) - 1 };
enum { ELASTIC, STACK, SPHERES, UNBOUNDED };

static struct model_row elastic = {.name = "elastic", .label = "Elastic", .family = "f", .quantities = ALL};
static struct model_row stack = {.name = "stack",
                                 .label = "Stack",
                                 .family = "f",
                                 .plastic = true,
                                 .stacks_scales = true,
                                 .quantities = ALL,
                                 .yield_bound = amplitude_bound,
                                 .yield_reason = reason,
                                 .scale_dependence_bound = raise_bound};
static struct model_row spheres = {.name = "spheres",
                                   .label = "Spheres",
                                   .family = "g",
                                   .plastic = true,
                                   .quantities = ALL,
                                   .yield_bound = no_bound,
                                   .yield_reason = reason,
                                   .scale_dependence_bound = raise_bound};
static struct model_row unbounded = {
    .name = "unbounded", .label = "Unbounded", .family = "h", .plastic = true, .quantities = ALL};

const struct model_row *const model_rows[] = {&elastic, &stack, &spheres, &unbounded};
const size_t model_count = 4;

/* ---------------------------------------------------------------- a surface */

static struct scene scene;
static struct plan plan;
static struct surface_record record;
static double amplitudes_m[3]; /* of the mean and of two scans */
static struct member parts[2];
static struct ensemble_scan scans[2];
static const double loads[] = {1e-4};

/* The spectrum's short end along alpha lambda^gamma. */
static struct convergence_tail tail(double alpha, double gamma)
{
    return (struct convergence_tail){
        .wavelength_m = 1e-4, .amplitude_m = alpha * pow(1e-4, gamma), .gamma = gamma, .count = 1};
}

static int make(void **state)
{
    (void)state;
    elastic.scale_dependence_bound = raise_bound;
    amplitudes_m[0] = 1e-6;
    amplitudes_m[1] = amplitudes_m[2] = 0.5e-6;
    scene = (struct scene){.effects_auto = true, .tolerance = 1e-8, .convergence.load = 1e-3};
    plan = (struct plan){.running = (1u << EFFECT_COUNT) - 1,
                         .wanted = ALL,
                         .models = MODEL_BIT(ELASTIC) | MODEL_BIT(STACK) | MODEL_BIT(SPHERES)};
    record = (struct surface_record){
        .summary = {.usable = true, .length_m = 1e-3, .spacing_m = 1e-6, .pair = {.effective_modulus_Pa = 1e11}}};
    record.spectrum = (struct spectrum){&amplitudes_m[0], 1, 1e-3, false};
    record.summary.tail = tail(1e-4, NAN);
    return 0;
}

static int end(void **state)
{
    (void)state;
    free(record.summary.bounds);
    return 0;
}

static const struct curve_bounds *bounds_of(size_t m)
{
    struct status status = {0};
    asked = 0;
    free(record.summary.bounds);
    record.summary.bounds = NULL;
    assert_int_equal(effects_bound(&record, &scene, &plan, loads, 1, &status), STATUS_OK);
    return &record.summary.bounds[m];
}

static void add_repeats(void)
{
    for (size_t p = 0; p < 2; p++) {
        parts[p] = (struct member){.spectrum = {&amplitudes_m[p + 1], 1, 1e-3, false}, .scan = p};
        scans[p] = (struct ensemble_scan){.weight = 1};
    }
    record.ensemble = (struct ensemble){.members = parts, .count = 2, .scans = scans, .scan_count = 2};
}

#define PLACED(name) TEST_WITH(name, make, end)

/* ---------------------------------------------------------------- bounds */

PLACED(test_yield_of_the_surface_its_scans_and_its_extension)
{
    assert_near(bounds_of(STACK)->yield, 1e-6, 1e-12);
    add_repeats();
    assert_near(bounds_of(STACK)->yield, 1e-6, 1e-12);
    amplitudes_m[2] = 3e-6;
    assert_near(bounds_of(STACK)->yield, 3e-6, 1e-12);
    scene.convergence.load = 1e-9; /* not converged */
    /* the tail at the shortest wavelength: 0.1 (1e-3)^1.5; at an atom's only where it is the steeper end */
    record.summary.tail = tail(0.1, 1.5);
    assert_near(bounds_of(STACK)->yield, 0.1 * pow(1e-3, 1.5), 1e-9);
    assert_near(bounds_of(SPHERES)->yield, 0, 0);
    plan_switch_off(&plan, EFFECT_CONVERGENCE);
    assert_near(bounds_of(STACK)->yield, 3e-6, 1e-12);
    plan.running |= EFFECT_BIT(EFFECT_CONVERGENCE);
    record.summary.tail = tail(1, -0.1);
    assert_near(bounds_of(STACK)->yield, pow(3e-10, -0.1), 1e-9);
    plan.models |= MODEL_BIT(UNBOUNDED);
    assert_near(bounds_of(UNBOUNDED)->yield, 0, 0);
    scene.models_named = true;
    assert_true(isinf(bounds_of(UNBOUNDED)->yield));
}

/* Converged: gamma >= 1, and the nominal pressure at least p* = sqrt2 pi E' Delta f at the sampling limit. */
PLACED(test_converged)
{
    double limit_m = 1e-3;
    for (int side = -1; side <= 1; side += 2) {
        double slope = 1e-3 / (sqrt(2) * M_PI) * (1 + 1e-6 * side); /* Delta f */
        record.summary.tail = tail(slope / pow(limit_m, 0.5), 1.5);
        bounds_of(STACK);
        assert_int_equal(record.summary.converged, side < 0);
        record.summary.tail = tail(0.5 * slope, 1);
        bounds_of(STACK);
        assert_true(record.summary.converged);
        record.summary.tail = tail(0.5 * slope * pow(limit_m, 0.001), 0.999);
        bounds_of(STACK);
        assert_false(record.summary.converged);
    }
}

/* Scale dependence is bounded until an elastic model decides; a plastic one that cannot yield is not asked. */
PLACED(test_scale_dependence)
{
    assert_near(bounds_of(ELASTIC)->scale_dependence, 2e-6, 1e-12);
    assert_near(bounds_of(STACK)->scale_dependence, 0, 0);
    assert_int_equal(asked, 1);
    scene.tolerance = 3e-6;
    assert_near(bounds_of(STACK)->scale_dependence, 2e-6, 1e-12);
    assert_near(bounds_of(SPHERES)->scale_dependence, 0, 0);
    assert_int_equal(asked, 2);
    scene.tolerance = 2e-6; /* at the tolerance is within it */
    bounds_of(ELASTIC);
    assert_int_equal(asked, 2);
    elastic.scale_dependence_bound = NULL;
    assert_true(isinf(bounds_of(ELASTIC)->scale_dependence));
    plan_switch_off(&plan, EFFECT_SCALE_DEPENDENT);
    assert_near(bounds_of(ELASTIC)->scale_dependence, 0, 0);
}

/* Of scans run alone: of each, until one exceeds the tolerance; their mean spectrum has no curve. */
PLACED(test_scale_dependence_of_scans_alone)
{
    add_repeats();
    assert_near(bounds_of(ELASTIC)->scale_dependence, 1e-6, 1e-12);
    assert_int_equal(asked, 1);
    amplitudes_m[2] = 3e-6;
    scene.tolerance = 2e-6; /* the first is within it */
    assert_near(bounds_of(ELASTIC)->scale_dependence, 6e-6, 1e-12);
    assert_int_equal(asked, 2);
    scene.tolerance = 1e-5;
    plan_switch_off(&plan, EFFECT_PLASTICITY);
    assert_near(bounds_of(ELASTIC)->scale_dependence, 6e-6, 1e-12); /* the larger one's, whatever their order */
    amplitudes_m[1] = 4e-6;
    assert_near(bounds_of(ELASTIC)->scale_dependence, 8e-6, 1e-12);
}

/* ---------------------------------------------------------------- decisions */

static void decide(double yield, double raise)
{
    bool auto_effects = scene.effects_auto;
    scene.effects_auto = true; /* so that there are bounds */
    bounds_of(STACK);
    scene.effects_auto = auto_effects;
    record.summary.bounds[STACK].yield = yield;
    record.summary.bounds[SPHERES].yield = 0.5e-8;
    record.summary.bounds[ELASTIC].scale_dependence = raise;
    effects_decide(&plan, &scene, &record, 1);
}

PLACED(test_decisions)
{
    record.summary.tail = tail(1, 0.9);
    decide(1.01e-8, 1.01e-8);
    assert_true(plan_runs(&plan, EFFECT_PLASTICITY) && plan_runs(&plan, EFFECT_SCALE_DEPENDENT));
    assert_string_equal(plan.effects[EFFECT_PLASTICITY].reason, "yields 1.01e-08");
    assert_string_equal(plan.effects[EFFECT_SCALE_DEPENDENT].reason, "(8/3π) λmfp/a can raise TCR by 1e-08");
    assert_string_equal(plan.effects[EFFECT_CONVERGENCE].reason,
                        "1 of 1 surfaces may lose area below their sampling limit");
    decide(0.99e-8, 0.99e-8);
    assert_false(plan_runs(&plan, EFFECT_PLASTICITY) || plan_runs(&plan, EFFECT_SCALE_DEPENDENT));
    assert_string_equal(plan.effects[EFFECT_PLASTICITY].reason, "rests 9.9e-09, and rests 5e-09");
    assert_false(plan.wanted & QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT));
}

/* Too few harmonics tell nothing of the waves below the sampling limit. */
PLACED(test_no_tail_to_carry_on)
{
    record.summary.tail = tail(1, NAN);
    assert_near(bounds_of(STACK)->yield, 1e-6, 1e-12);
    decide(0, 0);
    assert_string_equal(
        plan.effects[EFFECT_CONVERGENCE].reason,
        "sweeps only: of 1 of 1 surfaces the spectrum does not tell how it goes on below what is known");
}

/* A refused surface has no say; nor has a bound in a scene that lists its effects. */
PLACED(test_who_has_no_say)
{
    record.summary.usable = false;
    decide(1, 1);
    assert_false(plan_runs(&plan, EFFECT_PLASTICITY) || plan_runs(&plan, EFFECT_SCALE_DEPENDENT));
    plan.running = (1u << EFFECT_COUNT) - 1;
    scene.effects_auto = false;
    record.summary.usable = true;
    decide(0, 0);
    assert_true(plan_runs(&plan, EFFECT_PLASTICITY) && plan_runs(&plan, EFFECT_SCALE_DEPENDENT));
}

/* Where none is named, one that is all yield runs if another calls for it. */
PLACED(test_models_without_a_bound)
{
    plan.models |= MODEL_BIT(UNBOUNDED);
    scene.tolerance = 1e-5; /* above the others' bounds */
    decide(0, 0);
    assert_false(plan_runs(&plan, EFFECT_PLASTICITY));
    assert_string_equal(plan.effects[EFFECT_PLASTICITY].reason, "rests 0, and rests 5e-09");
    plan.running = (1u << EFFECT_COUNT) - 1;
    scene.models_named = true;
    decide(0, 0);
    assert_true(plan_runs(&plan, EFFECT_PLASTICITY) && plan_runs(&plan, EFFECT_SCALE_DEPENDENT));
    assert_string_equal(plan.effects[EFFECT_PLASTICITY].reason, "Unbounded yields");
    assert_string_equal(plan.effects[EFFECT_SCALE_DEPENDENT].reason, "Unbounded has no bound on it");
}
