/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/uncertainty.h"

#include "analysis/surface.h"
#include "spectrum/multitaper.h"
#include "spectrum/simulated_record.h"
#include <math.h>
#include <stdlib.h>

enum {
    RECORDS = SINGLE_SCAN_RECORDS,
    QUARTERS = SINGLE_SCAN_QUARTERS,
    LEAST_POINTS = 64, /* of a scan that is quartered */
    FIRST_SEED = 1
};

/* On one core of 2020: what is allowed, a height of a record, and the leading model at a record's loads. */
static const double most_seconds = 10, height_seconds = 0.25e-6, record_seconds = 1.3e-3;

bool uncertainty_holds(const struct plan *plan, size_t model)
{
    return plan_runs_model(plan, model) && (plan->all_uncertain || model == plan_leading_model(plan));
}

/** One set of loads that records are taken through the models at. */
struct loads {
    double load[UNCERTAINTY_LOADS];
    size_t count, middle; /* `middle`: which of them is the one where the summary stands */
};

/** First, middle (where the summary stands) and last of the task's loads, each once. */
static struct loads record_loads(const struct model_task *task)
{
    size_t last = task->load_count - 1, at[UNCERTAINTY_LOADS] = {0, model_task_operating(task), last};
    struct loads out = {.count = 0};
    for (int i = 0; i < UNCERTAINTY_LOADS; i++) {
        if (i == 0 || at[i] != at[i - 1])
            out.load[out.count++] = task->loads[at[i]];
        out.middle = i == 1 ? out.count - 1 : out.middle;
    }
    return out;
}

/** ln answer of a record of rms height sigma_m; NaN: none. */
static double answer(const struct contact_point *point, enum quantity quantity, const struct model_row *model,
                     double sigma_m)
{
    double value = quantity_shown(point, model_shown(model, quantity), sigma_m);
    return value > 0 ? log(value) : NAN;
}

/** ln answer of every record at one load of a list, in `out`; false: one has none. */
static bool answers_of(double *out, const struct ensemble_curves *records, size_t all, const struct model_row *model,
                       enum quantity quantity, size_t i, double load)
{
    bool complete = records->count == all;
    for (size_t r = 0; r < records->count && complete; r++) {
        const struct model_curve *curve = &records->curves[r];
        out[r] = i < curve->count && curve->points[i].value[QUANTITY_LOAD] == load
                     ? answer(&curve->points[i], quantity, model, records->sigma_m[r])
                     : NAN;
        complete = isfinite(out[r]);
    }
    return complete;
}

/** The records of a scan, their quarters (of each in turn), and the scan's own; the latter two from LEAST_POINTS on. */
struct simulated {
    struct ensemble records, quarters, own;
};

static enum status_code add_quarters(struct ensemble *set, const double *height_m, const struct uncertainty_scan *scan,
                                     struct status *status)
{
    size_t quarter = scan->points / QUARTERS;
    for (size_t k = 0; k < QUARTERS && scan->points >= LEAST_POINTS; k++)
        if (ensemble_add(set, 0, height_m + k * (scan->points - quarter) / (QUARTERS - 1), quarter, scan->spacing_m,
                         &scan->how, status) != STATUS_OK)
            return status->code;
    return STATUS_OK;
}

static enum status_code simulate(struct simulated *out, const struct simulated_record *spectrum, double *height_m,
                                 const struct uncertainty_scan *scan, struct status *status)
{
    for (size_t b = 0; b < RECORDS; b++)
        if (simulated_record_draw(height_m, spectrum, FIRST_SEED + b, status) != STATUS_OK ||
            ensemble_add(&out->records, 0, height_m, scan->points, scan->spacing_m, &scan->how, status) != STATUS_OK ||
            add_quarters(&out->quarters, height_m, scan, status) != STATUS_OK)
            return status->code;
    return add_quarters(&out->own, scan->height_m, scan, status);
}

/** What the curves say of one model. */
static struct uncertainty conclude(const struct ensemble_curves *records, const struct ensemble_curves *quarters,
                                   const struct ensemble_curves *own, const struct model_row *model,
                                   const struct loads *loads)
{
    struct uncertainty out = {.loads = loads->count};
    for (size_t i = 0; i < loads->count; i++)
        out.ln_load[i] = log(loads->load[i]);
    for (int q = 0; q < QUANTITY_COUNT; q++) {
        out.middle[q] = (struct single_scan){.s = NAN, .half_width = NAN};
        for (size_t i = 0; i < loads->count; i++) {
            double record[RECORDS], record_quarter[RECORDS * QUARTERS], quarter[QUARTERS],
                load = loads->load[loads->middle];
            struct single_scan single;
            struct status none = {0};
            enum quantity quantity = (enum quantity)q;
            out.s[q][i] = NAN;
            if (!ensemble_band_holds(quantity) ||
                !answers_of(record, records, RECORDS, model, quantity, i, loads->load[i]))
                continue; /* a record has no answer there: neither has the interval */
            bool quartered = i == loads->middle && answers_of(quarter, own, QUARTERS, model, quantity, 0, load) &&
                             answers_of(record_quarter, quarters, RECORDS * QUARTERS, model, quantity, 0, load);
            if (single_scan_uncertainty(&single, record, RECORDS, quartered ? quarter : NULL, record_quarter, &none) !=
                STATUS_OK)
                continue;
            out.s[q][i] = single.s;
            if (i == loads->middle)
                out.middle[q] = single;
        }
    }
    return out;
}

static enum status_code run_one(struct uncertainty *out, const struct simulated *simulated,
                                const struct model_row *model, const struct model_task *task, struct status *status)
{
    const struct ensemble *const sets[] = {&simulated->records, &simulated->quarters, &simulated->own};
    struct loads all = record_loads(task);
    struct ensemble_curves curves[3] = {{.count = 0}};
    enum status_code rc = STATUS_OK;
    for (int k = 0; k < 3 && rc == STATUS_OK; k++) {
        struct model_task own = k == 0 ? model_task_at(task, all.load, all.count) : surface_middle_task(task);
        own.wanted &= ~QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT);
        rc = sets[k]->count > 0 ? ensemble_run(&curves[k], sets[k], model, &own, status) : STATUS_OK;
    }
    if (rc == STATUS_OK)
        *out = conclude(&curves[0], &curves[1], &curves[2], model, &all);
    out->longest_waves = model_task_longest_waves(task);
    for (int k = 0; k < 3; k++)
        ensemble_curves_free(&curves[k]);
    return rc;
}

double uncertainty_seconds(size_t points)
{
    return RECORDS * (2 * (double)points * height_seconds + record_seconds);
}

bool uncertainty_affordable(size_t points, size_t surfaces)
{
    return (double)surfaces * uncertainty_seconds(points) < most_seconds;
}

enum status_code uncertainty_run(struct uncertainty *out, const struct uncertainty_scan *scan, const struct plan *plan,
                                 struct status *status)
{
    struct simulated_record spectrum = {0};
    struct simulated simulated = {.records = {.count = 0}};
    double *height_m = malloc(2 * scan->points * sizeof *height_m), *square_m2 = height_m + scan->points;
    enum status_code rc = height_m ? STATUS_OK : status_memory(status);
    if (rc == STATUS_OK && scan->points < SIMULATED_RECORD_LEAST_POINTS)
        rc = status_fail(status, STATUS_SCAN, "%zu points are too few to simulate records of", scan->points);
    if (rc == STATUS_OK)
        rc = multitaper_square(square_m2, scan->height_m, scan->points, status);
    if (rc == STATUS_OK)
        rc = simulated_record_prepare(&spectrum, square_m2, scan->points, status);
    if (rc == STATUS_OK)
        rc = simulate(&simulated, &spectrum, height_m, scan, status);
    simulated_record_free(&spectrum);
    free(height_m);
    for (size_t m = 0; m < model_count && rc == STATUS_OK; m++)
        if (uncertainty_holds(plan, m))
            rc = run_one(&out[m], &simulated, model_rows[m], scan->task, status);
    ensemble_free(&simulated.records);
    ensemble_free(&simulated.quarters);
    ensemble_free(&simulated.own);
    return rc;
}

/** Half-width at a load; where the scan is not the same along its length, at least the one its quarters give. */
static double half_width_at(const struct uncertainty *uncertainty, enum quantity quantity, double ln_load)
{
    const struct single_scan *middle = &uncertainty->middle[quantity];
    double ln_known[UNCERTAINTY_LOADS], s[UNCERTAINTY_LOADS];
    size_t count = 0;
    for (size_t i = 0; i < uncertainty->loads; i++)
        if (!isnan(uncertainty->s[quantity][i])) {
            ln_known[count] = uncertainty->ln_load[i];
            s[count++] = uncertainty->s[quantity][i];
        }
    if (count == 0 || !(middle->s > 0))
        return NAN;
    double half_width = single_scan_half_width(single_scan_s_at(ln_load, ln_known, s, count));
    return middle->heterogeneous ? fmax(half_width, middle->half_width) : half_width;
}

struct estimate uncertainty_estimate(const struct uncertainty *uncertainty, const struct model_row *model,
                                     enum quantity quantity, const struct contact_point *point, double sigma_m)
{
    struct single_scan single = uncertainty->middle[quantity];
    if (isnan(single.s))
        return estimate_none;
    single.half_width = half_width_at(uncertainty, quantity, log(point->value[QUANTITY_LOAD]));
    struct estimate out = estimate_single(quantity_shown(point, model_shown(model, quantity), sigma_m), &single, true);
    out.share = quantity == QUANTITY_AREA;
    out.model_sd = model_surface_sd(model, quantity, uncertainty->longest_waves);
    return out;
}
