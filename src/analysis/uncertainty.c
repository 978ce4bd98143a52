/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/uncertainty.h"

#include "spectrum/multitaper.h"
#include "spectrum/simulated_record.h"
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    RECORDS = SINGLE_SCAN_RECORDS,
    QUARTERS = SINGLE_SCAN_QUARTERS,
    LEAST_POINTS = 64, /* of a scan that is quartered */
    FIRST_SEED = 1
};

const double uncertainty_most_seconds = 1, uncertainty_height_seconds = 0.25e-6;

bool uncertainty_holds(const struct plan *plan, size_t model)
{
    return plan_runs_model(plan, model) && (plan->all_uncertain || model == plan_leading_model(plan));
}

/** All answers, as logarithms. */
struct answers {
    double record[QUANTITY_COUNT][UNCERTAINTY_LOADS][RECORDS];
    double record_quarter[QUANTITY_COUNT][RECORDS * QUARTERS];
    double quarter[QUANTITY_COUNT][QUARTERS];
};

/** One set of loads that records are taken through the models at. */
struct loads {
    double load[UNCERTAINTY_LOADS];
    size_t count, middle; /* `middle`: which of them is the one where the summary stands */
};

/** First, middle (where the summary stands) and last of the task's loads, each once, and the middle one alone. */
static struct loads record_loads(const struct model_task *task)
{
    size_t last = task->load_count - 1, at[UNCERTAINTY_LOADS] = {0, model_task_operating(task), last};
    struct loads out = {.count = 0};
    for (int i = 0; i < UNCERTAINTY_LOADS; i++) {
        if (i == 0 || at[i] != at[i - 1]) {
            out.load[out.count] = task->loads ? task->loads[at[i]] : NAN;
            out.count++;
        }
        out.middle = i == 1 ? out.count - 1 : out.middle;
    }
    return out;
}

static struct loads middle_load(const struct model_task *task)
{
    return (struct loads){{task->loads ? task->loads[model_task_operating(task)] : NAN}, 1, 0};
}

static struct model_task record_task(const struct model_task *task, const struct spectrum *spectrum,
                                     const struct asperities *asperities, const struct loads *loads)
{
    struct model_task own = model_task_at(task, loads->load, loads->count);
    own.spectrum = spectrum;
    own.asperities = asperities;
    own.wanted &= ~QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT);
    return own;
}

/** ln answer of a record of rms height sigma_m. */
static double answer(const struct contact_point *point, enum quantity quantity, const struct model_row *model,
                     double sigma_m)
{
    double value = quantity_shown(point, model_shown(model, quantity), sigma_m);
    return value > 0 ? log(value) : NAN;
}

/** Takes heights through everything. put: where the answer of model m, quantity and load goes. */
struct pass {
    struct answers *answers; /* model_count */
    const struct uncertainty_scan *scan;
    const struct plan *plan;
};

static double *place(struct answers *answers, enum quantity quantity, size_t load, size_t record, size_t quarter)
{
    if (quarter == QUARTERS)
        return &answers->record[quantity][load][record];
    return record == RECORDS ? &answers->quarter[quantity][quarter]
                             : &answers->record_quarter[quantity][record * QUARTERS + quarter];
}

/** record RECORDS: the scan's own; quarter QUARTERS: the whole of it. */
static enum status_code take(struct pass *pass, const double *height_m, size_t points, size_t record, size_t quarter,
                             struct status *status)
{
    const struct uncertainty_scan *scan = pass->scan;
    struct spectrum spectrum;
    struct roughness roughness;
    struct asperities asperities;
    struct status none = {0};
    struct loads loads = quarter == QUARTERS ? record_loads(scan->task) : middle_load(scan->task);
    if (piece_describe(&spectrum, &roughness, height_m, points, scan->spacing_m, &scan->how, status) != STATUS_OK) {
        spectrum_free(&spectrum);
        return status->code;
    }
    bool has_asperities = roughness_asperities(&asperities, &roughness, &none) == STATUS_OK;
    struct model_task task = record_task(scan->task, &spectrum, has_asperities ? &asperities : NULL, &loads);
    enum status_code rc = STATUS_OK;
    for (size_t m = 0; m < model_count && rc == STATUS_OK; m++) {
        struct contact_point room[UNCERTAINTY_LOADS + 1];
        struct model_curve curve = {.points = room};
        if (!uncertainty_holds(pass->plan, m))
            continue;
        rc = model_run(&curve, model_rows[m], &task, status);
        for (size_t i = 0; i < loads.count; i++)
            for (int q = 0; q < QUANTITY_COUNT; q++)
                *place(&pass->answers[m], (enum quantity)q, i, record, quarter) =
                    rc == STATUS_OK && curve.exists && i < curve.count && room[i].value[QUANTITY_LOAD] == loads.load[i]
                        ? answer(&room[i], (enum quantity)q, model_rows[m], asperities.sigma_m)
                        : NAN;
    }
    spectrum_free(&spectrum);
    return rc;
}

static enum status_code take_quarters(struct pass *pass, const double *height_m, size_t record, struct status *status)
{
    size_t points = pass->scan->points, quarter = points / QUARTERS;
    for (size_t k = 0; k < QUARTERS && points >= LEAST_POINTS; k++)
        if (take(pass, height_m + k * (points - quarter) / (QUARTERS - 1), quarter, record, k, status) != STATUS_OK)
            return status->code;
    return STATUS_OK;
}

static bool all_finite(const double *value, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!isfinite(value[i]))
            return false;
    return true;
}

/** What the answers say of one model. */
static struct uncertainty conclude(const struct answers *answers, const struct uncertainty_scan *scan)
{
    struct loads loads = record_loads(scan->task);
    struct uncertainty out = {.loads = loads.count};
    size_t middle = loads.middle;
    bool quartered = scan->points >= LEAST_POINTS;
    for (size_t i = 0; i < loads.count; i++)
        out.ln_load[i] = log(loads.load[i]);
    for (int q = 0; q < QUANTITY_COUNT; q++) {
        out.middle[q] = (struct single_scan){.s = NAN, .half_width = NAN};
        for (size_t i = 0; i < loads.count; i++) {
            struct single_scan single;
            struct status none = {0};
            bool quarters = quartered && i == middle && all_finite(answers->quarter[q], QUARTERS) &&
                            all_finite(answers->record_quarter[q], (size_t)RECORDS * QUARTERS);
            out.s[q][i] = NAN;
            if (!repeats_band_holds((enum quantity)q) ||
                single_scan_uncertainty(&single, answers->record[q][i], RECORDS, quarters ? answers->quarter[q] : NULL,
                                        answers->record_quarter[q], &none) != STATUS_OK)
                continue; /* a record has no answer there: neither has the interval */
            out.s[q][i] = single.s;
            if (i == middle)
                out.middle[q] = single;
        }
    }
    return out;
}

static enum status_code simulate(struct pass *pass, const struct simulated_record *spectrum, double *height_m,
                                 struct status *status)
{
    for (size_t b = 0; b < RECORDS; b++)
        if (simulated_record_draw(height_m, spectrum, FIRST_SEED + b, status) != STATUS_OK ||
            take(pass, height_m, pass->scan->points, b, QUARTERS, status) != STATUS_OK ||
            take_quarters(pass, height_m, b, status) != STATUS_OK)
            return status->code;
    return take_quarters(pass, pass->scan->height_m, RECORDS, status);
}

/** The squared amplitudes of the multitaper spectrum, malloc'ed. */
static enum status_code squares(double **out, const double *height_m, size_t points, struct status *status)
{
    *out = malloc(points * sizeof **out);
    if (!*out)
        return status_memory(status);
    return multitaper_square(*out, height_m, points, status);
}

enum status_code uncertainty_possible(bool *out, const double *height_m, size_t points, const struct spectrum *tapered,
                                      struct status *status)
{
    *out = false;
    if (tapered || points < SIMULATED_RECORD_LEAST_POINTS) {
        *out = tapered && simulated_record_possible(tapered->amplitude_m, points);
        return STATUS_OK;
    }
    struct status none = {0};
    double *square_m2;
    enum status_code rc = squares(&square_m2, height_m, points, &none);
    *out = rc == STATUS_OK && simulated_record_possible(square_m2, points);
    free(square_m2);
    return rc == STATUS_MEMORY ? status_memory(status) : STATUS_OK;
}

bool uncertainty_affordable(size_t points, size_t surfaces)
{
    return (double)surfaces * (double)points * 2 * RECORDS * uncertainty_height_seconds < uncertainty_most_seconds;
}

enum status_code uncertainty_run(struct uncertainty *out, const struct uncertainty_scan *scan, const struct plan *plan,
                                 struct status *status)
{
    struct simulated_record spectrum = {0};
    struct pass pass = {calloc(model_count, sizeof *pass.answers), scan, plan};
    double *height_m = malloc(scan->points * sizeof *height_m);
    double *square_m2 = NULL;
    enum status_code rc = pass.answers && height_m ? STATUS_OK : status_memory(status);
    if (rc == STATUS_OK)
        rc = squares(&square_m2, scan->height_m, scan->points, status);
    if (rc == STATUS_OK)
        rc = simulated_record_prepare(&spectrum, square_m2, scan->points, status);
    free(square_m2);
    assert(rc != STATUS_SCAN);
    if (rc == STATUS_OK)
        rc = simulate(&pass, &spectrum, height_m, status);
    for (size_t m = 0; m < model_count && rc == STATUS_OK; m++)
        out[m] = conclude(&pass.answers[m], scan);
    simulated_record_free(&spectrum);
    free(height_m);
    free(pass.answers);
    return rc;
}

struct estimate uncertainty_estimate(const struct uncertainty *uncertainty, enum quantity quantity, double value)
{
    const struct single_scan *single = &uncertainty->middle[quantity];
    struct estimate out = isnan(single->s) ? estimate_none : estimate_single(value, single, true);
    out.share = quantity == QUANTITY_AREA;
    return out;
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

void uncertainty_band(struct repeats_band *band, const struct uncertainty *uncertainty, const struct model_curve *curve,
                      const struct model_row *model, double sigma_m)
{
    for (int q = 0; q < QUANTITY_COUNT; q++)
        for (size_t i = 0; i < curve->count; i++) {
            const struct contact_point *point = &curve->points[i];
            struct estimate own = estimate_none;
            own.logarithmic = true;
            own.share = q == QUANTITY_AREA;
            own.mean = answer(point, (enum quantity)q, model, sigma_m);
            own.half_width = repeats_band_holds((enum quantity)q)
                                 ? half_width_at(uncertainty, (enum quantity)q, log(point->value[QUANTITY_LOAD]))
                                 : NAN;
            if (point->value[QUANTITY_LOAD] != band[i].load)
                continue; /* a statistical curve closes at a load of its own */
            for (int side = 0; side < 2; side++)
                band[i].mean[q][side] = estimate_end(&own, side);
        }
}
