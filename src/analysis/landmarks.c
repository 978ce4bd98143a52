/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/landmarks.h"

#include "contact/statistical.h"
#include <assert.h>
#include <math.h>
#include <stdlib.h>

const double landmarks_slope_step = M_LN10 / 24;

enum {
    SEARCHES = 3,
    TRIALS = 4,
    LOADS_MOST = SEARCHES * TRIALS * 2,
    PASSES_MOST = 60,
    BETA_PARTS_FIRST = 12,
    BETA_PARTS = 96
};

struct search;
/** What changes sign, from <= 0 below the landmark to > 0 above it; INFINITY is above. */
typedef double excess_function(const struct search *search, const struct contact_point *before,
                               const struct contact_point *after);

/** A landmark that lies between two logarithms of loads. */
struct search {
    excess_function *excess;
    const struct model_row *row;
    const struct landmarks_value *value;
    double half_step; /* of ln P: it looks at the loads that much before and after; 0: at the load */
    double low, high, excess_low, excess_high; /* NaN: not known yet */
    double trials[TRIALS];
    size_t trial_count;
    bool evenly; /* the last pass did not narrow much */
    bool found;  /* something is above; else the landmark may lie beyond */
};

static double area_excess(const struct search *search, const struct contact_point *before,
                          const struct contact_point *after)
{
    (void)after;
    return before ? log(before->value[QUANTITY_AREA] / search->row->largest_area) : INFINITY;
}

static double fit_excess(const struct search *search, const struct contact_point *before,
                         const struct contact_point *after)
{
    (void)search;
    (void)after;
    return before ? before->beyond_fit - curve_summary_beyond_fit_share : INFINITY;
}

static double slope_excess(const struct search *search, const struct contact_point *before,
                           const struct contact_point *after)
{
    if (!before || !(before->value[QUANTITY_ECR] > 0) || !after || !(after->value[QUANTITY_ECR] > 0))
        return INFINITY; /* complete */
    return log(before->value[QUANTITY_ECR] / after->value[QUANTITY_ECR]) -
           curve_summary_elbow_slope * 2 * search->half_step;
}

static double value_excess(const struct search *search, const struct contact_point *before,
                           const struct contact_point *after)
{
    const struct landmarks_value *sought = search->value;
    double value = before ? before->value[sought->quantity] : NAN, ratio = log(value / sought->value);
    (void)after;
    if (before && sought->shift)
        ratio += sought->shift(log(before->value[QUANTITY_LOAD]), sought->context);
    return isnan(value) ? INFINITY : sought->rises ? ratio : -ratio;
}

enum status_code landmarks_run_model(struct model_curve *out, const double *loads, size_t count, void *context,
                                     struct status *status)
{
    const struct landmarks_model *model = context;
    struct model_task task = model_task_at(&model->task, loads, count);
    task.wanted &= model->quantities;
    return ensemble_curve(out, NULL, model->set, model->row, &task, status);
}

static void add_trial(struct search *search, double x)
{
    size_t i = search->trial_count;
    if (!(x > search->low && x < search->high))
        return;
    while (i > 0 && search->trials[i - 1] > x)
        i--;
    if (i > 0 && search->trials[i - 1] == x)
        return;
    for (size_t k = search->trial_count++; k > i; k--)
        search->trials[k] = search->trials[k - 1];
    search->trials[i] = x;
}

/** Loads to try next: close about where a straight line crosses 0, and the middle; or evenly. The ends first, where
 * they are not known. */
static void choose_trials(struct search *search, double tolerance)
{
    double width = search->high - search->low, share = search->excess_low / (search->excess_low - search->excess_high);
    search->trial_count = 0;
    if (isnan(search->excess_low)) {
        for (int i = 0; i < TRIALS; i++)
            search->trials[search->trial_count++] = search->low + width * i / (TRIALS - 1);
    } else if (search->evenly || !isfinite(share)) {
        for (int i = 1; i < TRIALS; i++)
            add_trial(search, search->low + width * i / TRIALS);
    } else {
        double line = search->low + share * width, close = fmax(width * width / 4, tolerance / 4);
        add_trial(search, line - close);
        add_trial(search, line + close);
        add_trial(search, search->low + width / 2);
    }
}

/** The point of a load that was asked for; NULL: beyond full contact, which closes the curve. */
static const struct contact_point *point_at(const struct model_curve *curve, double load)
{
    for (size_t i = 0; i < curve->count; i++)
        if (curve->points[i].value[QUANTITY_LOAD] == load)
            return &curve->points[i];
    return NULL;
}

/** Narrows the search to the first sign change between its trials. */
static void narrow(struct search *search, const struct model_curve *curve)
{
    double width = search->high - search->low;
    for (size_t i = 0; i < search->trial_count; i++) {
        double x = search->trials[i];
        double excess = search->excess(search, point_at(curve, exp(x - search->half_step)),
                                       point_at(curve, exp(x + search->half_step)));
        if (excess > 0) {
            search->high = x;
            search->excess_high = excess;
            search->found = true;
            break;
        }
        search->low = x;
        search->excess_low = excess;
    }
    search->evenly = search->high - search->low > width / 4;
}

static int compare_loads(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/** All searches, a pass at a time, until each is within the tolerance. */
static enum status_code solve(struct search *searches, size_t count, const struct landmarks_curve *searched,
                              struct status *status)
{
    struct contact_point points[LOADS_MOST + 1];
    for (int pass = 0; pass < PASSES_MOST; pass++) {
        double loads[LOADS_MOST];
        size_t load_count = 0, different = 0;
        for (size_t s = 0; s < count; s++) {
            struct search *search = &searches[s];
            search->trial_count = 0;
            bool missing = !search->found && !isnan(search->excess_low);
            if (missing || search->high - search->low <= searched->tolerance)
                continue;
            choose_trials(search, searched->tolerance);
            for (size_t i = 0; i < search->trial_count; i++) {
                loads[load_count++] = exp(search->trials[i] - search->half_step);
                if (search->half_step > 0)
                    loads[load_count++] = exp(search->trials[i] + search->half_step);
            }
        }
        if (load_count == 0)
            return STATUS_OK;
        assert(load_count <= LOADS_MOST);
        qsort(loads, load_count, sizeof *loads, compare_loads);
        for (size_t i = 0; i < load_count; i++)
            if (different == 0 || loads[i] != loads[different - 1])
                loads[different++] = loads[i];
        struct model_curve curve = {.points = points};
        if (searched->evaluate(&curve, loads, different, searched->context, status) != STATUS_OK)
            return status->code;
        for (size_t s = 0; s < count; s++)
            if (searches[s].trial_count > 0)
                narrow(&searches[s], &curve);
    }
    return STATUS_OK;
}

/** Index of the point with this load; curve->count when there is none. */
static size_t index_of(const struct model_curve *curve, double load)
{
    size_t i = 0;
    while (i < curve->count && curve->points[i].value[QUANTITY_LOAD] != load)
        i++;
    return i;
}

enum status_code landmarks_solve(struct curve_summary *summary, const struct model_curve *curve,
                                 const struct model_row *row, const struct landmarks_curve *searched,
                                 struct status *status)
{
    struct search searches[SEARCHES];
    double *results[SEARCHES];
    size_t count = 0;
    const struct {
        double *load;
        excess_function *excess;
        double half_step;
    } sought[SEARCHES] = {{&summary->invalid_area_load, area_excess, 0},
                          {&summary->invalid_fit_load, fit_excess, 0},
                          {&summary->elbow_load, slope_excess, landmarks_slope_step / 2}};
    for (int k = 0; k < SEARCHES; k++) {
        bool slope = sought[k].half_step > 0;
        size_t i = index_of(curve, *sought[k].load); /* the slope's: the load before it is too steep */
        if (slope && isnan(*sought[k].load) && curve->count > 1 &&
            curve->points[curve->count - 1].value[QUANTITY_ECR] > 0)
            i = curve->count - 2; /* it may have become so since the last two loads */
        if (!(slope ? i + 1 < curve->count : i > 0 && i < curve->count))
            continue;
        if (sought[k].excess == fit_excess && !row->fitted_to)
            continue; /* a mark on single points, which no load between them shares */
        const struct contact_point *high = &curve->points[slope ? i + 1 : i], *low = &curve->points[i > 0 ? i - 1 : 0];
        struct search search = {.excess = sought[k].excess,
                                .row = row,
                                .half_step = sought[k].half_step,
                                .low = log(low->value[QUANTITY_LOAD]),
                                .high = log(high->value[QUANTITY_LOAD]),
                                .excess_low = NAN,
                                .excess_high = NAN,
                                .found = !slope};
        if (!slope) {
            search.excess_low = search.excess(&search, low, NULL);
            search.excess_high = search.excess(&search, high, NULL);
        }
        results[count] = sought[k].load;
        searches[count++] = search;
    }
    if (solve(searches, count, searched, status) != STATUS_OK)
        return status->code;
    for (size_t s = 0; s < count; s++)
        if (searches[s].found)
            *results[s] = fmax(exp(searches[s].high), curve->points[0].value[QUANTITY_LOAD]);
    return STATUS_OK;
}

enum status_code landmarks_find(double ends[2], bool *found, const struct landmarks_value *value,
                                const struct landmarks_curve *searched, struct status *status)
{
    struct search search = {.excess = value_excess,
                            .value = value,
                            .low = log(ends[0]),
                            .high = log(ends[1]),
                            .excess_low = NAN,
                            .excess_high = NAN};
    if (solve(&search, 1, searched, status) != STATUS_OK)
        return status->code;
    *found = search.found;
    if (search.found && isnan(search.excess_low)) {
        ends[1] = ends[0];
    } else if (search.found) {
        ends[0] = fmax(exp(search.low), ends[0]);
        ends[1] = fmin(fmax(exp(search.high), ends[0]), ends[1]);
    }
    return STATUS_OK;
}

/** Weight of the load k of 1...parts - 1: (2/n) sin t sum over odd j < n of sin(j t)/j, t = pi k/n (Fejér 1933; Davis
 * and Rabinowitz, Methods of Numerical Integration, 2.5.5). */
static double fejer_weight(int k, int parts)
{
    double angle = M_PI * k / parts, first = sin(angle), twice = 2 * cos(2 * angle);
    double before = -first, sine = first, sum = 0; /* sin((j-2) t), sin(j t) */
    for (int j = 1; j < parts; j += 2) {
        double next = twice * sine - before;
        sum += sine / j;
        before = sine;
        sine = next;
    }
    return 2 * first / parts * sum;
}

/** The mean separation over ln P, by Fejér's second rule on 11, 23, 47 and 95 loads, each list with those of the one
 * before it, until two means agree to `allowed_m`; NaN where the curve does not reach them all. */
static enum status_code mean_separation(double *mean_m, const struct landmarks_curve *curve, const double ends[2],
                                        double allowed_m, struct status *status)
{
    double separation_m[BETA_PARTS];
    *mean_m = NAN;
    for (int parts = BETA_PARTS_FIRST; parts <= BETA_PARTS; parts *= 2) {
        struct contact_point points[BETA_PARTS + 1];
        struct model_curve added = {.points = points};
        double loads[BETA_PARTS], before_m = *mean_m;
        int every = BETA_PARTS / parts, step = parts == BETA_PARTS_FIRST ? 1 : 2;
        size_t count = 0;
        for (int k = 1; k < parts; k += step)
            loads[count++] = ends[0] * pow(ends[1] / ends[0], (1 - cos(M_PI * k / parts)) / 2);
        if (curve->evaluate(&added, loads, count, curve->context, status) != STATUS_OK)
            return status->code;
        *mean_m = NAN;
        if (added.count != count)
            return STATUS_OK;
        for (int k = 1; k < parts; k += step)
            separation_m[k * every] = points[(k - 1) / step].value[QUANTITY_SEPARATION];
        *mean_m = 0;
        for (int k = 1; k < parts / 2; k++) /* weights are the same from both ends */
            *mean_m += fejer_weight(k, parts) * (separation_m[k * every] + separation_m[(parts - k) * every]);
        *mean_m += fejer_weight(parts / 2, parts) * separation_m[BETA_PARTS / 2];
        if (fabs(*mean_m - before_m) <= allowed_m)
            break;
    }
    return STATUS_OK;
}

enum status_code landmarks_nearest_beta(double *beta, const struct landmarks_curve *adjusted,
                                        const struct landmarks_curve *multiscale, double from, double to,
                                        double sigma_m, struct status *status)
{
    const double ends[2] = {from, to}, unit_m = sigma_m / 4; /* of beta, in H */
    double adjusted_m, multiscale_m;
    *beta = NAN;
    if (!(to > from))
        return STATUS_OK;
    if (mean_separation(&adjusted_m, adjusted, ends, 2 * unit_m * adjusted->tolerance, status) != STATUS_OK ||
        mean_separation(&multiscale_m, multiscale, ends, unit_m * multiscale->tolerance, status) != STATUS_OK)
        return status->code;
    *beta = statistical_beta_multiscale(&adjusted_m, &multiscale_m, 1, sigma_m);
    return STATUS_OK;
}
