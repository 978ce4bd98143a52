/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "made_up_results.h"

#include "claims/claims.h"

#include "contact/convergence.h"
#include "support.h"

#include <stdio.h>

static const struct {
    char *name;
    double rq_m, area, ecr, gamma;
} surfaces[MADE_UP_USABLE] = {
    {"beta", 2e-7, 500, 3, 1.4}, {"alpha", 1e-7, 1000, 1, 1.6}, {"gamma", 4e-7, 200, 7.5, 1.2}};

/** Area of a model over that of multiscale elastic. */
static double factor_of(size_t m)
{
    static const double factors[] = {1, 2, 1, 0.8, 0.5}; /* by place in chapter 6, 0: none */
    return factors[model_rows[m]->thesis_place];
}

/** Takes out what was not asked for. */
static void keep_wanted(struct contact_point *point, unsigned wanted)
{
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if (!(wanted & QUANTITY_BIT(q)))
            point->value[q] = NAN;
}

static void make_curve(struct surface_record *record, size_t index, size_t m, const double *loads, unsigned wanted)
{
    struct model_curve *curve = &record->curves[m];
    double area = surfaces[index].area * factor_of(m), sigma_m = surfaces[index].rq_m;
    bool adjusts = model_rows[m]->quantities & QUANTITY_BIT(QUANTITY_ADJUSTED);
    *curve = (struct model_curve){.exists = true,
                                  .points = calloc(MADE_UP_LOADS, sizeof *curve->points),
                                  .count = MADE_UP_LOADS,
                                  .full_load = 1 / area,
                                  .beta = adjusts ? 6 : NAN,
                                  .full = {.value[QUANTITY_LOAD] = 1 / area,
                                           .value[QUANTITY_AREA] = 1,
                                           .value[QUANTITY_ADJUSTED] = adjusts ? 0 : NAN}};
    assert_non_null(curve->points);
    for (size_t i = 0; i < MADE_UP_LOADS; i++) {
        double ratio = fmin(1, area * loads[i]);
        double ecr = ratio < 1 ? surfaces[index].ecr * 1e-14 / factor_of(m) / loads[i] : 0;
        curve->points[i] = (struct contact_point){.value[QUANTITY_LOAD] = loads[i],
                                                  .value[QUANTITY_AREA] = ratio,
                                                  .value[QUANTITY_SEPARATION] = sigma_m * (1 - ratio),
                                                  .value[QUANTITY_ADJUSTED] = adjusts ? sigma_m * (1 - ratio) : NAN,
                                                  .value[QUANTITY_ECR] = ecr,
                                                  .value[QUANTITY_TCR] = 2e5 * ecr,
                                                  .value[QUANTITY_TCR_SCALE_DEPENDENT] = 1.02 * 2e5 * ecr,
                                                  .value[QUANTITY_STIFFNESS] = 1e12 * ratio,
                                                  .value[QUANTITY_ECR_LAST_SCALE] = 0.1 * ecr};
        for (int q = 0; q < QUANTITY_COUNT; q++) /* any number that goes as its row says */
            if (quantity_rows[q].from)
                curve->points[i].value[q] = (quantity_rows[q].is & QUANTITY_RISES) ? 1e4 * ratio : 3e12 * ecr;
        keep_wanted(&curve->points[i], wanted);
    }
    keep_wanted(&curve->full, wanted);
}

/** Of two scans a standard deviation of `deviation` apart (of ln value where `logarithmic`) about this number. */
static struct estimate about(double value, double deviation, bool logarithmic)
{
    struct estimate estimate;
    double step = deviation / M_SQRT2;
    const double scans[2] = {logarithmic ? value * exp(-step) : value - step,
                             logarithmic ? value * exp(step) : value + step};
    expect_ok(estimate_make, &estimate, scans, NULL, 2, logarithmic);
    return estimate;
}

/** What is known of a model's answers: by two scans of the first surface, else by simulated records if they run. */
static void make_estimates(struct made_up *made, struct surface_record *record, size_t index, size_t m)
{
    struct curve_summary *model = record->summary.models[m];
    struct estimate all[CURVE_ESTIMATES];
    const struct contact_point *middle = &record->curves[m].points[MADE_UP_LOADS / 2];
    bool several = index == 0, known = several || plan_runs(&made->plan, EFFECT_UNCERTAINTY);
    all[CURVE_FULL_LOAD] = several ? about(model->full_load, log(1.5), true) : estimate_none;
    all[CURVE_BETA] = several && isfinite(model->beta) ? about(model->beta, 0.5, false) : estimate_none;
    for (int q = 0; q < QUANTITY_COUNT; q++) {
        enum quantity shown = model_shown(model_rows[m], (enum quantity)q);
        double value = quantity_shown(middle, shown, record->summary.asperities.sigma_m);
        bool held = known && (quantity_rows[q].is & QUANTITY_BANDED) && isfinite(value);
        all[q] = !held ? estimate_none : several ? about(value, 0.05, true) : estimate_of_error(value, 0.05, 4);
    }
    expect_ok(curve_summary_put_estimates, model, all);
}

static void make_surface(struct made_up *made, size_t index, void (*change)(struct surface_record *, size_t))
{
    struct surface_record *record = &made->surfaces[index];
    struct surface_summary *summary = &record->summary;
    *summary = (struct surface_summary){.scene = &made->names[index],
                                        .usable = index < MADE_UP_USABLE,
                                        .all_scans = 1,
                                        .pair = {.effective_modulus_Pa = 1e11,
                                                 .yield_strength_Pa = 1e8,
                                                 .hardness_Pa = 2.84e8,
                                                 .poisson_ratio = 0.3,
                                                 .yield_coefficient = 1.6,
                                                 .resistivity_ohm_m = 1e-7,
                                                 .conductivity_W_per_mK = 50,
                                                 .mean_free_path_m = {2e-8, 2e-8},
                                                 .side_conductivity_W_per_mK = {50, 50}},
                                        .format = "text",
                                        .units = "x um, z um",
                                        .hash = "0123456789abcdef0123"};
    if (!summary->usable) {
        summary->refusal = strdup("broken.csv: no number in it");
    } else {
        double rq_m = surfaces[index].rq_m, gamma = surfaces[index].gamma;
        summary->roughness =
            (struct roughness){rq_m, 0.8 * rq_m, 6 * rq_m, rq_m * rq_m, 0.01, 1e9, 0, 3 * pow(rq_m, 4)};
        summary->asperities = (struct asperities){10, 1e10, 2e-6, 0.9 * rq_m, 0.1 * rq_m, rq_m};
        summary->has_asperities = true;
        summary->power_law = (struct power_law){.found = POWER_LAW_BAND_LAW,
                                                .alpha = 0.5,
                                                .gamma = gamma,
                                                .gamma_error = 0.01,
                                                .amplitude_m = 0.5 * pow(sqrt(2e-10), gamma),
                                                .amplitude_error_decades = 0.1,
                                                .wavelength_m = sqrt(2e-10),
                                                .psd_m3 = 3e-19,
                                                .misfit_decades = 0.2,
                                                .band_m = {2e-6, 1e-4},
                                                .harmonics = 3,
                                                .knee_m = NAN};
        summary->points = 200;
        summary->spacing_m = 1e-6;
        summary->length_m = 2e-4;
        summary->scans = summary->periodic = index == 0 ? 2 : 1;
        summary->independent = (double)summary->scans;
        if (index == 0)
            note_add(&summary->notes, "beta.csv", "note.text\ntext\ta note");
        record->curves = calloc(model_count, sizeof *record->curves);
        for (size_t m = 0; m < model_count; m++) {
            if (plan_runs_model(&made->plan, m))
                make_curve(record, index, m, made->loads, made->plan.wanted);
        }
        if (change)
            change(record, index);
        for (size_t m = 0; m < model_count; m++) {
            if (!record->curves[m].exists)
                continue;
            struct curve_summary *model = surface_model_room(summary, m);
            assert_non_null(model);
            curve_summary_make(model, &record->curves[m], model_rows[m], rq_m, made->loads[MADE_UP_LOADS / 2]);
            if (model_rows[m]->stacks_scales)
                model->extension = (struct convergence_extension){0.4, 0.3, 100};
            else
                model->beta_multiscale = 7;
            make_estimates(made, record, index, m);
        }
        if (index == 0) {
            summary->repeats = (struct repeats){.count = 2,
                                                .scans = 2,
                                                .rq_m = about(rq_m, 0.05, true),
                                                .gamma = about(gamma, 0.02, false),
                                                .psd_m3 = about(1e-20, 0.1, true)};
        }
    }
}

/** 1.5 times the baseline's ECR by multiscale plastic, whose law is 1.5e-14/load. */
static void make_measured(struct made_up *made)
{
    static const double loads[MADE_UP_MEASURED] = {1e-5, 3e-5, 1e-4};
    double *values = made->measured_values;
    made->run = (struct measured_run){0, MADE_UP_MEASURED - 1, MADE_UP_MEASURED};
    made->measured[0] = (struct measured){.count = MADE_UP_MEASURED,
                                          .run_count = 1,
                                          .given = &made->scene.measured,
                                          .runs = &made->run,
                                          .load = values,
                                          .resistance = values + MADE_UP_MEASURED,
                                          .error = values + 2 * MADE_UP_MEASURED};
    for (size_t i = 0; i < MADE_UP_MEASURED; i++) {
        values[i] = loads[i];
        values[MADE_UP_MEASURED + i] = 1.5 * 1.5e-14 / loads[i];
        values[2 * MADE_UP_MEASURED + i] = NAN;
    }
    made->answers[0].resistance = calloc(model_count * MADE_UP_MEASURED, sizeof(double));
    assert_non_null(made->answers[0].resistance);
    for (size_t m = 0; m < model_count; m++)
        for (size_t i = 0; i < MADE_UP_MEASURED; i++)
            made->answers[0].resistance[m * MADE_UP_MEASURED + i] =
                plan_runs_model(&made->plan, m) ? surfaces[0].ecr * 1e-14 / factor_of(m) / loads[i] : NAN;
    expect_ok(measured_fit, made->answers, made->measured, plan_leading_model(&made->plan));
    made->answers->exponent = (struct measured_exponent){0};
}

static void make_benchmark(struct made_up *made)
{
    static const double tolerance[BENCHMARK_STEPS] = {1e-2, 1e-6, 1e-10, 1e-13};
    made->benchmark.count = 0;
    for (size_t m = 0; m < model_count; m++)
        for (int t = 0; plan_runs_model(&made->plan, m) && t < BENCHMARK_STEPS; t++)
            made->benchmark.rows[made->benchmark.count++] =
                (struct benchmark_row){m, tolerance[t], 100, 1e-6 * (double)(m + 1), t == 0 ? 1e-3 : 0};
}

void made_up_sweep(struct made_up *made, enum convergence_sweep sweep, const char *model, size_t value, double last)
{
    double *area =
        made->sweeps + (results_sweep(&made->results, sweep, model_named(model), value) - made->results.convergence);
    for (size_t i = 0; i < MADE_UP_SCALES; i++)
        area[i] = i < MADE_UP_SCALES / 2 ? 0.5 : last;
}

/** All settle that should. */
static void make_sweeps(struct made_up *made)
{
    made->sweeps = support_room(results_sweep_size(&made->results) * sizeof *made->sweeps);
    made->results.convergence = made->sweeps;
    for (int s = 0; s < CONVERGENCE_SWEEP_COUNT; s++)
        for (size_t v = 0; v < convergence_sweeps[s].count; v++)
            for (size_t m = 0; m < model_count; m++)
                if (plan_runs_model(&made->plan, m) && model_rows[m]->stacks_scales)
                    made_up_sweep(made, (enum convergence_sweep)s, model_rows[m]->name, v,
                                  s == CONVERGENCE_ALPHA || convergence_sweeps[s].values[v] >= 1 ? 0.5 : 0.4);
}

uint64_t made_up_models(void)
{
    uint64_t models = 0;
    for (size_t m = 0; m < model_count; m++)
        models |= model_rows[m]->thesis_place > 0 ? MODEL_BIT(m) : 0;
    return models;
}

static void make_plan(struct plan *plan, uint64_t models, unsigned effects)
{
    *plan = (struct plan){.models = models, .running = effects, .wanted = quantity_wanted(effects)};
    for (int e = 0; e < EFFECT_COUNT; e++)
        plan->reasons[e] = effect_rows[e].name;
}

void made_up_again(struct made_up *made)
{
    static const struct figures drawn = {.figure = {{"answer", "", false},
                                                    {"one-surface", "6-05 to 6-09", false},
                                                    {"area", "6-11 to 6-14", false},
                                                    {"accuracy", "", false}},
                                         .count = 4};
    comparison_free(&made->comparison);
    json_decref(made->view);
    expect_ok(comparison_make, &made->comparison, &made->results);
    json_auto_t *claims = NULL, *headline = NULL;
    expect_ok(claims_make, &claims, &made->results, &made->comparison, support_words());
    expect_ok(claims_headline, &headline, &made->results, &made->comparison, support_words());
    expect_ok(view_make, &made->view, &made->results, &made->comparison, headline, claims, &drawn, support_words());
}

void made_up_make(struct made_up *made, void (*change)(struct surface_record *record, size_t index))
{
    made_up_make_of(made, made_up_models(), (1u << EFFECT_COUNT) - 1, change);
}

void made_up_make_of(struct made_up *made, uint64_t models, unsigned effects,
                     void (*change)(struct surface_record *record, size_t index))
{
    *made = (struct made_up){.files = {"scan.csv"}, .order = {1, 0, 2}, .shown = {0, 1, 2}};
    make_plan(&made->plan, models, effects);
    for (size_t i = 0; i < MADE_UP_SURFACES; i++) {
        made->bodies[i] = (struct scene_bodies){.material = *material_find("tin"),
                                                .counterface_kind = MATERIAL_COUNTERFACE_RIGID,
                                                .counterface = material_unknown("rigid"),
                                                .hardness_Pa = NAN};
        made->names[i] = (struct scene_surface){.name = i < MADE_UP_USABLE ? surfaces[i].name : "broken",
                                                .files = {made->files, 1},
                                                .bodies = made->bodies[i]};
    }
    for (size_t i = 0; i < MADE_UP_LOADS; i++)
        made->loads[i] = pow(10, -6 + (double)i / 2);
    made->scene = (struct scene){
        .title = "Made up",
        .models = made->plan.models,
        .nominal_area_m2 = 1e-6,
        .tolerance = 1e-8,
        .fit = POWER_LAW_THESIS,
        .fit_band_m = {0, INFINITY},
        .bodies = made->bodies[0],
        .convergence = {.alpha = 0.1, .gamma = 1.5, .load = 1e-3, .scan_length_m = 1e-3, .scales = MADE_UP_SCALES},
        .surfaces = made->names,
        .surface_count = MADE_UP_SURFACES,
    };
    make_measured(made);
    make_benchmark(made);
    made->results = (struct results){.scene = &made->scene,
                                     .plan = &made->plan,
                                     .loads = made->loads,
                                     .load_count = MADE_UP_LOADS,
                                     .surfaces = made->surfaces,
                                     .surface_count = MADE_UP_SURFACES,
                                     .measured = made->measured,
                                     .answers = made->answers,
                                     .benchmark = &made->benchmark,
                                     .shown = made->shown,
                                     .shown_count = MADE_UP_USABLE,
                                     .by_roughness = made->order,
                                     .usable_count = MADE_UP_USABLE,
                                     .baseline = 0};
    if (plan_runs(&made->plan, EFFECT_CONVERGENCE))
        make_sweeps(made);
    for (size_t i = 0; i < MADE_UP_SURFACES; i++)
        make_surface(made, i, change);
    made_up_again(made);
}

void made_up_free(struct made_up *made)
{
    comparison_free(&made->comparison);
    json_decref(made->view);
    for (size_t i = 0; i < MADE_UP_SURFACES; i++)
        surface_record_free(&made->surfaces[i]);
    measured_answers_free(made->answers);
}

struct surface_summary *made_up_surface(struct made_up *made, size_t index)
{
    return &made->surfaces[index].summary;
}
