/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/results.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SHOWN_MOST = 8 };

static int compare_roughness(const void *a, const void *b, void *context)
{
    const struct surface_record *surfaces = context;
    size_t i = *(const size_t *)a, j = *(const size_t *)b;
    double x = surfaces[i].summary.roughness.rq_m, y = surfaces[j].summary.roughness.rq_m;
    return x < y ? -1 : x > y ? 1 : i < j ? -1 : 1;
}

/** The number that surfaces are compared by where the summary stands, less is better; infinite: none. */
static double answer_of(const struct results *results, size_t surface)
{
    enum quantity criterion = results_criterion(results);
    const struct curve_summary *leading =
        surface_model(&results->surfaces[surface].summary, plan_leading_model(results->plan));
    double value = leading->exists ? leading->operating.value[criterion] : NAN;
    return isnan(value) ? INFINITY : (quantity_rows[criterion].is & QUANTITY_RISES) ? -value : value;
}

static int compare_answers(const void *a, const void *b, void *context)
{
    const struct results *results = context;
    double x = answer_of(results, *(const size_t *)a), y = answer_of(results, *(const size_t *)b);
    return x < y ? -1 : x > y ? 1 : compare_roughness(a, b, results->surfaces);
}

/** Of too many surfaces the best, the worst, the baseline and others evenly between are shown, in that order. */
static void choose_shown(struct results *results, size_t *order, size_t usable)
{
    qsort_r(order, usable, sizeof *order, compare_answers, results);
    for (size_t k = 0; k < SHOWN_MOST; k++)
        results->shown[k] = order[k * (usable - 1) / (SHOWN_MOST - 1)];
    for (size_t i = 1; i + 1 < usable; i++)
        if (order[i] == results->baseline) {
            size_t k = (i * (SHOWN_MOST - 1) + (usable - 1) / 2) / (usable - 1);
            results->shown[k < 1 ? 1 : k > SHOWN_MOST - 2 ? SHOWN_MOST - 2 : k] = results->baseline;
        }
}

size_t results_second_smoothest(const struct results *results)
{
    size_t first = 0, second = 0, found = 0;
    for (size_t i = 0; i < results->surface_count; i++) {
        if (!results->surfaces[i].summary.usable)
            continue;
        bool smoother = found == 0 || compare_roughness(&i, &first, results->surfaces) < 0;
        if (smoother || found == 1 || compare_roughness(&i, &second, results->surfaces) < 0)
            second = smoother && found > 0 ? first : i;
        first = smoother ? i : first;
        found++;
    }
    return second;
}

enum status_code results_rank(struct results *results, struct status *status)
{
    const char *baseline = results->scene->baseline;
    size_t usable = 0, *order = malloc((results->surface_count + SHOWN_MOST) * sizeof *order);
    if (!order)
        return status_memory(status);
    for (size_t i = 0; i < results->surface_count; i++)
        if (results->surfaces[i].summary.usable)
            order[usable++] = i;
    results->by_roughness = order;
    results->usable_count = usable;
    if (usable == 0)
        return STATUS_OK;
    results->shown = order + results->surface_count;
    results->shown_count = usable < SHOWN_MOST ? usable : SHOWN_MOST;
    memcpy(results->shown, order, results->shown_count * sizeof *order);
    results->baseline = results_second_smoothest(results);
    for (size_t i = 0; baseline && i < usable; i++)
        if (strcmp(results->surfaces[order[i]].summary.scene->name, baseline) == 0)
            results->baseline = order[i];
    if (usable > SHOWN_MOST)
        choose_shown(results, order, usable);
    qsort_r(order, usable, sizeof *order, compare_roughness, results->surfaces);
    return STATUS_OK;
}
