/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "certainty/uncertainty.h"
#include "base/costs.h"

#include "base/clock.h"
#include "spectrum/multitaper.h"
#include "spectrum/simulated_record.h"
#include "statistics/estimate.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    UNCERTAINTY_LOADS = 3, /* first, operating and last; linear in ln load between */
    RECORDS = SINGLE_SCAN_RECORDS,
    QUARTERS = SINGLE_SCAN_QUARTERS,
    LEAST_POINTS = 64,       /* of a scan that is quartered */
    RECORD_POINTS = 1 << 14, /* of a record at most */
    FIRST_SEED = 1
};

/** The scan to be simulated and quartered. */
struct uncertainty_scan {
    struct record_heights body[2]; /* levelled; the second: the rough counterface; points 0: it is smooth */
    struct record_conditioning how;
    const struct model_task *task; /* of the scan itself */
    const struct joint_task *joint;
    const struct threads *threads;
};

/** Standard errors of the ln answers of one model; NaN: not known. */
struct uncertainty {
    double ln_load[UNCERTAINTY_LOADS], s[QUANTITY_COUNT][UNCERTAINTY_LOADS];
    size_t loads;
};

/** Is a model's uncertainty computed? By default that of the leading model alone, if listed that of all. */
static bool uncertainty_holds(const struct plan *plan, size_t model)
{
    return plan_runs_model(plan, model) && !model_rows[model]->uses_map &&
           (plan->all_uncertain || model == plan_leading_model(plan));
}

/** First, operating and last load of the task, each once; returns how many. */
static size_t record_loads(double load[UNCERTAINTY_LOADS], const struct model_task *task)
{
    size_t at[UNCERTAINTY_LOADS] = {0, model_task_operating(task), task->load_count - 1}, count = 0;
    for (int i = 0; i < UNCERTAINTY_LOADS; i++)
        if (i == 0 || at[i] != at[i - 1])
            load[count++] = task->loads[at[i]];
    return count;
}

/** ln answers of all members at load i; NaN: none. */
static void answers_of(double *out, size_t all, const struct ensemble_curves *curves, enum quantity shown, size_t i,
                       double load)
{
    for (size_t r = 0; r < all; r++) {
        out[r] = NAN;
        if (r < curves->count && i < curves->curves[r].count &&
            curves->curves[r].points[i].value[QUANTITY_LOAD] == load)
            out[r] = log(quantity_shown(&curves->curves[r].points[i], shown, curves->sigma_m[r]));
    }
}

/** Simulated records and quarters of a scan. */
struct simulated {
    struct ensemble records, quarters;
    struct strips strips; /* of the quarters */
};

static void simulated_free(struct simulated *simulated)
{
    ensemble_free(&simulated->records);
    ensemble_free(&simulated->quarters);
    strips_free(&simulated->strips);
}

static enum status_code add_quarters(struct simulated *out, const struct record_heights *body,
                                     const struct uncertainty_scan *scan, struct status *status)
{
    size_t quarter = body->points / QUARTERS;
    for (size_t k = 0; k < QUARTERS && body->points >= LEAST_POINTS; k++) {
        const struct record_heights part = {body->height_m + k * (body->points - quarter) / (QUARTERS - 1), quarter,
                                            body->spacing_m};
        if (ensemble_add(&out->quarters, k, &part, &scan->how, status) != STATUS_OK)
            return status->code;
        out->quarters.members[k].seed = (uint64_t)k << 48;
    }
    if (out->quarters.keeps_heights &&
        strips_gather(&out->strips, &out->quarters, scan->body[1].points > 0, status) == STATUS_OK)
        out->strips.roughly = true;
    return status->code;
}

/** Averages neighbouring heights so that at most RECORD_POINTS are left, malloc'ed; NULL: out of memory. The long waves
 * make records scatter: for scans of 64 000 and 10^6 heights the intervals change by less than 0.5 %. */
static double *thin(struct record_heights *out, const struct record_heights *body)
{
    size_t each = 1 + body->points / (RECORD_POINTS + 1);
    double *mean_m = calloc(body->points / each + 1, sizeof *mean_m);
    *out = (struct record_heights){mean_m, body->points / each, body->spacing_m * (double)each};
    for (size_t i = 0; mean_m && i < each * out->points; i++)
        mean_m[i / each] += body->height_m[i] / (double)each;
    return mean_m;
}

static enum status_code add_records(struct simulated *out, const struct record_heights *scanned, unsigned long seed,
                                    const struct uncertainty_scan *scan, struct status *status)
{
    OWNED(simulated_record_free) struct simulated_record spectrum = {0};
    struct record_heights thinned, *body = &thinned;
    OWNED(memory_free) double *mean_m = thin(&thinned, scanned);
    if (!mean_m)
        return status_memory(status);
    if (body->points < SIMULATED_RECORD_LEAST_POINTS)
        return status_fail(status, STATUS_SCAN, "%zu points are too few to simulate records of", body->points);
    OWNED(memory_free) double *height_m = malloc(2 * body->points * sizeof *height_m);
    if (!height_m)
        return status_memory(status);
    double *square_m2 = height_m + body->points;
    if (multitaper_square(square_m2, body->height_m, body->points, status) != STATUS_OK ||
        simulated_record_prepare(&spectrum, square_m2, body->points, status) != STATUS_OK)
        return status->code;
    const struct record_heights drawn = {height_m, body->points, body->spacing_m};
    for (size_t b = 0; b < RECORDS; b++)
        if (simulated_record_draw(height_m, &spectrum, seed + b, status) != STATUS_OK ||
            ensemble_add(&out->records, b, &drawn, &scan->how, status) != STATUS_OK)
            return status->code;
    return STATUS_OK;
}

/** Simulates both bodies, pressed against each other. */
static enum status_code simulate(struct simulated out[2], const struct uncertainty_scan *scan, struct status *status)
{
    size_t bodies = scan->body[1].points > 0 ? 2 : 1;
    for (size_t k = 0; k < bodies; k++)
        if (add_records(&out[k], &scan->body[k], FIRST_SEED + k * RECORDS, scan, status) != STATUS_OK ||
            add_quarters(&out[k], &scan->body[k], scan, status) != STATUS_OK)
            return status->code;
    if (bodies > 1 &&
        (strips_pair(&out->strips, &out->quarters, &out[1].strips, &out[1].quarters, status) != STATUS_OK ||
         ensemble_pair(&out->quarters, &out[1].quarters, status) != STATUS_OK ||
         ensemble_pair(&out->records, &out[1].records, status) != STATUS_OK))
        return status->code;
    return out->quarters.keeps_heights ? strips_solve_members(&out->strips, &out->quarters, scan->threads, status)
                                       : STATUS_OK;
}

static enum status_code run_one(struct uncertainty *out, const struct simulated *simulated,
                                const struct model_row *model, const struct uncertainty_scan *scan,
                                struct status *status)
{
    double load[UNCERTAINTY_LOADS], record[RECORDS], quarter[QUARTERS];
    size_t loads = record_loads(load, scan->task);
    struct model_task own = model_task_at(scan->task, load, loads);
    OWNED(ensemble_curves_free) struct ensemble_curves records = {.count = 0}, quarters = {.count = 0};
    own.wanted &= ~QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT);
    if (ensemble_run(&records, &simulated->records, model, &own, scan->joint, status) != STATUS_OK ||
        (simulated->quarters.count > 0 &&
         ensemble_run(&quarters, &simulated->quarters, model, &own, scan->joint, status) != STATUS_OK))
        return status->code;
    out->loads = loads;
    for (size_t i = 0; i < loads; i++)
        for (int q = 0; q < QUANTITY_COUNT; q++) {
            enum quantity shown = model_shown(model, (enum quantity)q);
            answers_of(record, RECORDS, &records, shown, i, load[i]);
            answers_of(quarter, QUARTERS, &quarters, shown, i, load[i]);
            out->ln_load[i] = log(load[i]);
            out->s[q][i] =
                (quantity_rows[q].is & QUANTITY_BANDED) ? single_scan_s(record, RECORDS, quarter, QUARTERS) : NAN;
        }
    return STATUS_OK;
}

double uncertainty_seconds(size_t points)
{
    return RECORDS * (2 * fmin((double)points, RECORD_POINTS) * costs.record_point_s + costs.record_s);
}

/** Errors of all running models; STATUS_SCAN: no records of it. */
static enum status_code find_errors(struct uncertainty *out, const struct uncertainty_scan *scan,
                                    const struct plan *plan, struct status *status)
{
    struct simulated simulated[2] = {{.records = {.count = 0}}};
    for (size_t m = 0; m < model_count; m++)
        if (uncertainty_holds(plan, m) && model_rows[m]->uses_strip)
            simulated[0].quarters.keeps_heights = simulated[1].quarters.keeps_heights = true;
    enum status_code rc = simulate(simulated, scan, status);
    if (rc == STATUS_OK && simulated[0].quarters.keeps_heights) {
        rc = ensemble_prepare(&simulated[0].records, scan->task, status);
        if (rc == STATUS_OK)
            rc = ensemble_prepare(&simulated[0].quarters, scan->task, status);
    }
    for (size_t m = 0; m < model_count && rc == STATUS_OK; m++)
        if (uncertainty_holds(plan, m))
            rc = run_one(&out[m], simulated, model_rows[m], scan, status);
    for (size_t k = 0; k < 2; k++)
        simulated_free(&simulated[k]);
    return rc;
}

/** How much another place on the surface may differ from this point of the curve, without the error of the model
 * (ensemble_settle()); sigma_m: rms height of the scan. */
static struct estimate estimate_at(const struct uncertainty *uncertainty, const struct model_row *model,
                                   enum quantity quantity, const struct contact_point *point, double sigma_m)
{
    double s = single_scan_s_at(log(point->value[QUANTITY_LOAD]), uncertainty->ln_load, uncertainty->s[quantity],
                                uncertainty->loads);
    return isnan(s) ? estimate_none
                    : estimate_of_error(quantity_shown(point, model_shown(model, quantity), sigma_m), s,
                                        SINGLE_SCAN_DEGREES);
}

/** Puts the estimates at one load into the band. */
static void put_band(struct ensemble_band *band, const struct estimate own[QUANTITY_COUNT])
{
    for (int q = 0; q < QUANTITY_COUNT; q++)
        for (int side = 0; side < 2; side++)
            band->mean[q][side] = estimate_end(&own[q], side);
}

/** The estimates of model `m` at the operating load, and its band where one is wanted, from these errors. */
static enum status_code put_errors(struct surface_record *record, size_t m, const struct uncertainty *errors,
                                   bool banded, const struct uncertainty_scan *scan, struct status *status)
{
    const struct model_curve *curve = &record->curves[m];
    const struct model_task *task = scan->task;
    const struct scans_reach reach = model_task_reach(task);
    struct estimate estimates[CURVE_ESTIMATES];
    for (int which = 0; which < CURVE_ESTIMATES; which++)
        estimates[which] = estimate_none;
    if (banded && !(record->bands[m] = ensemble_band_make(task->loads, task->load_count)))
        return status_memory(status);
    for (size_t i = banded ? 0 : model_task_operating(task); i < curve->count; i++) {
        const struct contact_point *point = &curve->points[i];
        if (i == task->load_count || point->value[QUANTITY_LOAD] != task->loads[i])
            break; /* a statistical curve ends at its own full load */
        struct estimate own[QUANTITY_COUNT];
        for (int q = 0; q < QUANTITY_COUNT; q++)
            own[q] = estimate_at(errors, model_rows[m], (enum quantity)q, point, record->summary.asperities.sigma_m);
        ensemble_settle(own, point, model_rows[m], scan->joint, reach);
        if (banded)
            put_band(&record->bands[m][i], own);
        if (i == model_task_operating(task))
            memcpy(estimates, own, sizeof own);
        if (!banded)
            break;
    }
    return curve_summary_put_estimates(record->summary.models[m], estimates, status);
}

enum status_code uncertainty_run(struct surface_record *record, const struct surface_task *asked,
                                 const struct model_task *task, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    struct model_task counted = *task;
    counted.evaluations = &summary->simulated_evaluations;
    counted.transfer = NULL; /* records have spectra of their own */
    double started = clock_seconds();
    const struct joint_task joint = surface_joint(record, asked->scene, asked->plan, task);
    const struct surface_record *const bodies[] = {record, record->counterface};
    struct uncertainty_scan scan = {.how = record_conditioning_of(asked->scene, false),
                                    .task = &counted,
                                    .joint = &joint,
                                    .threads = &asked->threads};
    for (size_t k = 0; k < 2 && bodies[k]; k++)
        scan.body[k] = (struct record_heights){bodies[k]->height_m, bodies[k]->summary.single_points,
                                               bodies[k]->summary.spacing_m / surface_kappa(summary)};
    OWNED(memory_free) struct uncertainty *all = calloc(model_count, sizeof *all);
    if (!all)
        return status_memory(status);
    struct status problem = {0};
    enum status_code rc = find_errors(all, &scan, asked->plan, &problem);
    if (rc != STATUS_OK && rc != STATUS_SCAN)
        (void)status_fail(status, rc, "%s", problem.message);
    for (size_t m = 0; m < model_count && rc == STATUS_OK; m++)
        if (record->curves[m].exists && !model_rows[m]->uses_map) {
            const bool own = uncertainty_holds(asked->plan, m); /* else that of the leading model */
            rc = put_errors(record, m, &all[own ? m : plan_leading_model(asked->plan)], own, &scan, status);
        }
    summary->times.uncertainty += clock_seconds() - started;
    return rc == STATUS_SCAN ? STATUS_OK : rc; /* no records of this one */
}

enum { MAP_DEGREES = 4 /* of freedom, about, of standard errors from four quarters */ };

enum status_code uncertainty_of_map(struct surface_record *record, size_t m, const struct model_task *task,
                                    const struct joint_task *joint, struct status *status)
{
    static const double carried[] = {0.02, 0.015, 0.033}; /* rms of ln between solved loads, eight synthetic maps */
    struct estimate estimates[CURVE_ESTIMATES];
    const struct model_curve *curve = &record->curves[m];
    for (int k = 0; k < CURVE_ESTIMATES; k++)
        estimates[k] = estimate_none;
    if (!(record->bands[m] = ensemble_band_make(task->loads, task->load_count)))
        return status_memory(status);
    for (size_t i = 0; i < curve->count; i++) {
        const struct contact_point *point = &curve->points[i];
        struct estimate own[QUANTITY_COUNT];
        double sd[QUANTITY_COUNT] = {0};
        for (int q = 0; q < QUANTITY_COUNT; q++) {
            const int which = quantity_rows[q].solved.mean; /* area, gap, constriction */
            if ((quantity_rows[q].is & QUANTITY_BANDED) && !quantity_rows[q].from)
                sd[q] = hypot(transfer_error(task->transfer, model_rows[m]->plastic, which, task->loads[i]),
                              carried[which]);
        }
        joint_carry_sd(sd, point, model_rows[m], joint);
        for (int q = 0; q < QUANTITY_COUNT; q++) {
            const double value = quantity_shown(point, (enum quantity)q, record->summary.asperities.sigma_m);
            const bool banded =
                (quantity_rows[q].is & QUANTITY_BANDED) && !model_is_overloaded(model_rows[m], point, joint->pair);
            own[q] = banded ? estimate_of_error(value, sd[q], MAP_DEGREES) : estimate_none;
        }
        ensemble_hold(own, point, model_rows[m], joint);
        put_band(&record->bands[m][i], own);
        if (i == model_task_operating(task))
            memcpy(estimates, own, sizeof own);
    }
    return curve_summary_put_estimates(record->summary.models[m], estimates, status);
}
