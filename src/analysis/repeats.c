/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/repeats.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

void repeats_free(struct repeat_set *set)
{
    for (size_t p = 0; p < set->count; p++) {
        spectrum_free(&set->parts[p].spectrum);
        free(set->parts[p].height_m);
    }
    free(set->parts);
    free(set->scans);
    *set = (struct repeat_set){0};
}

bool repeats_are_rows(const struct repeat_set *set)
{
    return set->scan_count == 1;
}

/** The mean of every scan's values (of logarithms where logarithmic), and its weight. Returns how many scans have any.
 */
static size_t scan_means(double *mean, double *weight, const double *value, const struct repeats_grouping *of,
                         bool logarithmic)
{
    size_t scans = 0;
    for (size_t i = 0, end; i < of->count; i = end, scans++) {
        double sum = 0, first = logarithmic ? log(value[i]) : value[i];
        for (end = i; end < of->count && of->scan[end] == of->scan[i]; end++)
            sum += (logarithmic ? log(value[end]) : value[end]) - first;
        double own = first + sum / (double)(end - i); /* equal values have this very mean */
        mean[scans] = end == i + 1 ? value[i] : logarithmic ? exp(own) : own;
        weight[scans] = of->set->scans[of->scan[i]].weight;
    }
    return scans;
}

enum status_code repeats_estimate_grouped(struct estimate *out, const double *value, const struct repeats_grouping *of,
                                          bool logarithmic, struct status *status)
{
    enum status_code rc;
    if (of->count > 1 && of->scan[0] == of->scan[of->count - 1] && repeats_are_rows(of->set)) {
        rc = estimate_rows(out, value, of->count, logarithmic, status);
    } else {
        double *mean = malloc(2 * of->count * sizeof *mean);
        if (!mean)
            return status_memory(status);
        double *weight = mean + of->count;
        size_t scans = scan_means(mean, weight, value, of, logarithmic);
        rc = estimate_scans(out, mean, weight, scans, logarithmic, status);
        free(mean);
    }
    if (of->set->no_intervals)
        out->s = out->sd = out->half_width = out->next_half_width = NAN;
    return rc;
}

enum status_code repeats_estimate(struct estimate *out, const double *value, const struct repeat_set *set,
                                  bool logarithmic, struct status *status)
{
    size_t *scan = malloc(set->count * sizeof *scan);
    if (!scan)
        return status_memory(status);
    for (size_t p = 0; p < set->count; p++)
        scan[p] = set->parts[p].scan;
    const struct repeats_grouping all = {set, scan, set->count};
    enum status_code rc = repeats_estimate_grouped(out, value, &all, logarithmic, status);
    free(scan);
    return rc;
}

enum status_code repeats_laws(struct repeats *out, const struct repeat_set *set, const struct power_law *law,
                              struct status *status)
{
    out->rq_m = out->gamma = out->psd_m3 = estimate_none;
    out->count = set->count;
    out->scans = set->scan_count;
    if (set->count == 0)
        return STATUS_OK;
    double *rq_m = malloc(3 * set->count * sizeof *rq_m);
    if (!rq_m)
        return status_memory(status);
    double *gamma = rq_m + set->count, *psd_m3 = gamma + set->count;
    double middle_m = law ? sqrt(law->band_m[0]) * sqrt(law->band_m[1]) : NAN;
    for (size_t p = 0; p < set->count; p++) {
        const struct repeat *part = &set->parts[p];
        rq_m[p] = part->roughness.rq_m;
        gamma[p] = psd_m3[p] = NAN;
        if (!law || isnan(law->gamma))
            continue;
        struct power_law own = power_law_fit(&part->spectrum, law->band_m);
        gamma[p] = own.gamma;
        psd_m3[p] = pow(power_law_amplitude(&own, middle_m), 2) * part->spectrum.length_m / 2;
    }
    enum status_code rc = repeats_estimate(&out->rq_m, rq_m, set, true, status);
    if (rc == STATUS_OK)
        rc = repeats_estimate(&out->gamma, gamma, set, false, status);
    if (rc == STATUS_OK)
        rc = repeats_estimate(&out->psd_m3, psd_m3, set, true, status);
    free(rq_m);
    return rc;
}

struct repeats_band *repeats_band_make(const double *loads, size_t count)
{
    struct repeats_band *band = malloc(count * sizeof *band);
    for (size_t i = 0; band && i < count; i++) {
        band[i].load = loads[i];
        for (int q = 0; q < QUANTITY_COUNT; q++)
            for (int side = 0; side < 2; side++)
                band[i].mean[q][side] = band[i].next[q][side] = NAN;
    }
    return band;
}

bool repeats_band_holds(enum quantity quantity)
{
    return quantity == QUANTITY_AREA || quantity == QUANTITY_SEPARATION || quantity == QUANTITY_ECR ||
           quantity == QUANTITY_TCR;
}

struct model_task repeats_task(struct asperities *asperities, const struct repeat *part, const struct model_task *task)
{
    struct model_task own = *task;
    struct status none = {0};
    own.spectrum = &part->spectrum;
    own.asperities = roughness_asperities(asperities, &part->roughness, &none) == STATUS_OK ? asperities : NULL;
    return own;
}

/** The curves of all runs on which the model has a solution. */
struct runs {
    struct model_curve *curves;
    struct contact_point *points; /* of all */
    size_t *scan;
    double *value, *sigma_m; /* one a run: to work with; its own rms height */
    size_t count;
};

static void free_runs(struct runs *runs)
{
    free(runs->curves);
    free(runs->points);
    free(runs->scan);
    free(runs->value);
    free(runs->sigma_m);
}

static enum status_code run_all(struct runs *out, struct model_curve *curve, struct repeats_result *result,
                                const struct repeat_set *set, const struct model_row *model,
                                const struct model_task *task, struct status *status)
{
    size_t all = set->count, room = task->load_count + 1;
    *out = (struct runs){.curves = calloc(all, sizeof *out->curves),
                         .points = calloc(all * room, sizeof *out->points),
                         .scan = calloc(all, sizeof *out->scan),
                         .value = calloc(all, sizeof *out->value),
                         .sigma_m = calloc(all, sizeof *out->sigma_m)};
    if (!out->curves || !out->points || !out->scan || !out->value || !out->sigma_m)
        return status_memory(status);
    for (size_t r = 0; r < all; r++) {
        struct asperities asperities;
        struct model_curve *own = &out->curves[out->count];
        struct model_task alone = repeats_task(&asperities, &set->parts[r], task);
        *own = (struct model_curve){.points = out->points + out->count * room};
        out->scan[out->count] = set->parts[r].scan;
        out->sigma_m[out->count] = sqrt(set->parts[r].roughness.m0_m2);
        if (model_run(own, model, &alone, status) != STATUS_OK)
            return status->code;
        curve->evaluations += own->evaluations;
        curve->overflows = curve->overflows || own->overflows;
        curve->clamped += own->clamped;
        curve->yielding_scales =
            own->yielding_scales > curve->yielding_scales ? own->yielding_scales : curve->yielding_scales;
        out->count += own->exists;
    }
    result->left_out = all - out->count;
    return STATUS_OK;
}

/** The mean of what is in runs->value. Where nothing is left of a positive quantity in any run, that is the mean. */
static enum status_code mean_of(double *mean, struct estimate *estimate, const struct runs *runs,
                                const struct repeat_set *set, bool logarithmic, struct status *status)
{
    const struct repeats_grouping all = {set, runs->scan, runs->count};
    bool zero = logarithmic;
    for (size_t r = 0; r < runs->count && zero; r++)
        zero = runs->value[r] == 0;
    if (repeats_estimate_grouped(estimate, runs->value, &all, logarithmic, status) != STATUS_OK)
        return status->code;
    *mean = zero ? 0 : estimate_value(estimate);
    return STATUS_OK;
}

/** Mean of one number of the curves. */
static enum status_code mean_number(double *mean, struct estimate *estimate, const struct runs *runs,
                                    const struct repeat_set *set, size_t offset, bool logarithmic,
                                    struct status *status)
{
    for (size_t r = 0; r < runs->count; r++)
        memcpy(&runs->value[r], (const char *)&runs->curves[r] + offset, sizeof *runs->value);
    return mean_of(mean, estimate, runs, set, logarithmic, status);
}

/** Point `at` of a run's curve; SIZE_MAX: that of full contact. */
static const struct contact_point *point_of(const struct runs *runs, size_t r, size_t at)
{
    return at == SIZE_MAX ? &runs->curves[r].full : &runs->curves[r].points[at];
}

/** Fills the quantities of `out` from a point of every run, `at` (in each curve's points), or the one of full contact
 * where that is SIZE_MAX. estimates: NULL, or QUANTITY_COUNT; lengths over sigma. */
static enum status_code mean_point(struct contact_point *out, struct estimate *estimates, const struct runs *runs,
                                   const struct repeat_set *set, const struct model_row *model, size_t at,
                                   struct status *status)
{
    struct estimate unused = estimate_none;
    *out = quantity_nothing();
    for (int q = QUANTITY_AREA; q < QUANTITY_COUNT; q++) {
        const struct quantity_row *row = &quantity_rows[q];
        struct estimate *estimate = estimates ? &estimates[q] : &unused;
        bool logarithmic = row->logarithmic || q == (int)model_shown(model, QUANTITY_SEPARATION);
        double mean = NAN;
        *estimate = estimate_none;
        if (row->from) /* of the mean curve: joint_apply() */
            continue;
        for (size_t r = 0; r < runs->count; r++)
            runs->value[r] = point_of(runs, r, at)->value[q] / (row->over_sigma ? runs->sigma_m[r] : 1);
        if (mean_of(&mean, estimate, runs, set, logarithmic, status) != STATUS_OK)
            return status->code;
        estimate->share = q == QUANTITY_AREA;
        out->value[q] = mean * (row->over_sigma ? set->sigma_m : 1);
    }
    for (size_t r = 0; r < runs->count; r++)
        runs->value[r] = point_of(runs, r, at)->beyond_fit;
    if (mean_of(&out->beyond_fit, &unused, runs, set, false, status) != STATUS_OK)
        return status->code;
    for (size_t r = 0; r < runs->count; r++)
        runs->value[r] = point_of(runs, r, at)->radius_clamped;
    return mean_of(&out->radius_clamped, &unused, runs, set, false, status);
}

/** Have all runs a point at load i of the task, not one of their own? */
static bool all_reach(const struct runs *runs, size_t i, double load)
{
    for (size_t r = 0; r < runs->count; r++)
        if (i >= runs->curves[r].count || runs->curves[r].points[i].value[QUANTITY_LOAD] != load)
            return false;
    return true;
}

/** Does every run end with its own point of full contact? */
static bool all_close(const struct runs *runs)
{
    for (size_t r = 0; r < runs->count; r++) {
        const struct model_curve *curve = &runs->curves[r];
        if (curve->count == 0 || curve->points[curve->count - 1].value[QUANTITY_LOAD] != curve->full_load)
            return false;
    }
    return true;
}

static void fill_band(struct repeats_band *band, const struct estimate *estimates, const struct model_row *model)
{
    for (int q = 0; q < QUANTITY_COUNT; q++)
        for (int side = 0; side < 2; side++) {
            const struct estimate *estimate = &estimates[model_shown(model, (enum quantity)q)];
            bool holds = repeats_band_holds((enum quantity)q);
            band->mean[q][side] = holds ? estimate_end(estimate, side) : NAN;
            band->next[q][side] = holds ? estimate_next_end(estimate, side) : NAN;
        }
}

static enum status_code mean_curve(struct model_curve *curve, struct repeats_result *result, const struct runs *runs,
                                   const struct repeat_set *set, const struct model_row *model,
                                   const struct model_task *task, struct status *status)
{
    struct estimate unused, estimates[QUANTITY_COUNT];
    size_t full = offsetof(struct model_curve, full_load), closed = offsetof(struct model_curve, closed_load),
           beta = offsetof(struct model_curve, beta);
    estimates[QUANTITY_LOAD] = estimate_none;
    curve->exists = true;
    if (mean_number(&curve->full_load, &result->full_load, runs, set, full, true, status) != STATUS_OK ||
        mean_number(&curve->closed_load, &unused, runs, set, closed, true, status) != STATUS_OK ||
        mean_number(&curve->beta, &result->beta, runs, set, beta, false, status) != STATUS_OK ||
        mean_point(&curve->full, NULL, runs, set, model, SIZE_MAX, status) != STATUS_OK)
        return status->code;
    curve->full.value[QUANTITY_LOAD] = curve->full_load;
    for (size_t i = 0; i < task->load_count && all_reach(runs, i, task->loads[i]); i++) {
        struct contact_point *point = &curve->points[curve->count++];
        if (mean_point(point, estimates, runs, set, model, i, status) != STATUS_OK)
            return status->code;
        point->value[QUANTITY_LOAD] = task->loads[i];
        fill_band(&result->band[i], estimates, model);
        for (int q = 0; q < QUANTITY_COUNT && i == model_task_operating(task); q++)
            result->middle[q] = estimates[model_shown(model, (enum quantity)q)];
    }
    if (curve->count < task->load_count && all_close(runs))
        curve->points[curve->count++] = curve->full;
    return STATUS_OK;
}

enum status_code repeats_model(struct model_curve *curve, struct repeats_result *result, const struct repeat_set *set,
                               const struct model_row *model, const struct model_task *task, struct status *status)
{
    struct runs runs;
    result->full_load = result->beta = estimate_none;
    for (int q = 0; q < QUANTITY_COUNT; q++)
        result->middle[q] = estimate_none;
    enum status_code rc = run_all(&runs, curve, result, set, model, task, status);
    if (rc == STATUS_OK && runs.count > 0)
        rc = mean_curve(curve, result, &runs, set, model, task, status);
    free_runs(&runs);
    return rc;
}
