/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/results.h"

#include "answers/direct_study.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Which of all curves of the sweeps it is, of each value those of the models that stack scales. */
static size_t curve_of(int sweep, size_t model, size_t value)
{
    size_t values = value, before = 0, stacking = 0;
    for (int s = 0; s < sweep; s++)
        values += convergence_sweeps[s].count;
    for (size_t m = 0; m < model_count; m++) {
        before += m < model && model_rows[m]->stacks_scales;
        stacking += model_rows[m]->stacks_scales;
    }
    return values * stacking + before;
}

const double *results_sweep(const struct results *results, enum convergence_sweep sweep, size_t model, size_t value)
{
    return results->convergence + curve_of((int)sweep, model, value) * results->scene->convergence.scales;
}

double results_sweep_load(const struct results *results, size_t model)
{
    const struct scene_convergence *study = &results->scene->convergence;
    const struct material_pair *pair = results_pair(results, results->baseline);
    bool yields = model_rows[model]->plastic && pair->hardness_Pa > 0 && !study->load_given;
    return yields ? fmin(study->load, pair->hardness_Pa / material_pair_pressure(pair, 100)) : study->load;
}

size_t results_sweep_size(const struct results *results)
{
    return curve_of(CONVERGENCE_SWEEP_COUNT, 0, 0) * results->scene->convergence.scales;
}

size_t results_sweep_scales(size_t *index, size_t most, size_t scales)
{
    size_t count = 0, next = 0; /* the first scale not yet taken */
    for (size_t k = 0; k < most; k++) {
        double n = pow((double)scales, (double)k / (double)(most - 1));
        size_t i = (size_t)lround(n) - 1;
        if (i >= next) {
            index[count++] = i;
            next = i + 1;
        }
    }
    return count;
}

const double *results_loads(const struct results *results, size_t surface)
{
    return results->loads + (results->loads_apart ? surface * results->load_count : 0);
}

struct surface_task results_task(const struct results *results, size_t surface)
{
    return (struct surface_task){.scene = results->scene,
                                 .plan = results->plan,
                                 .loads = results_loads(results, surface),
                                 .load_count = results->load_count};
}

double results_operating_load(const struct results *results, size_t surface)
{
    size_t place = results->plan->operating_place;
    return results_loads(results, surface)[place > 0 ? place - 1 : results->load_count / 2];
}

double results_law_wavelength_m(const struct results *results)
{
    double band_m[2] = {NAN, NAN};
    for (size_t i = 0; i < results->surface_count; i++) {
        const struct surface_summary *summary = &results->surfaces[i].summary;
        if (!summary->usable || !power_law_holds(&summary->power_law))
            continue;
        band_m[0] = fmax(band_m[0], summary->power_law.band_m[0]);
        band_m[1] = fmin(band_m[1], summary->power_law.band_m[1]);
    }
    return sqrt(band_m[0]) * sqrt(band_m[1]);
}

const struct material_pair *results_pair(const struct results *results, size_t surface)
{
    return &results->surfaces[surface].summary.pair;
}

bool results_has_material(const struct results *results)
{
    for (size_t i = 0; i < results->surface_count; i++)
        if (!results->surfaces[i].summary.pair.unknown)
            return true;
    return false;
}

const struct measured *results_measured(const struct results *results, size_t surface)
{
    return results->measured && results->measured[surface].count > 0 ? &results->measured[surface] : NULL;
}

enum quantity results_measured_quantity(const struct results *results)
{
    for (size_t i = 0; i < results->surface_count; i++)
        if (results_measured(results, i))
            return measured_quantity(&results->measured[i], results->plan->running);
    return QUANTITY_COUNT;
}

bool results_solves(const struct results *results, size_t index)
{
    const struct surface_summary *summary = &results->surfaces[index].summary;
    bool called = results->scene->direct.surfaces == SCENE_DIRECT_ALL || index == results->baseline;
    return called && summary->usable && summary->direct && summary->direct->possible;
}

const struct direct_study *results_direct_baseline(const struct results *results)
{
    for (size_t k = 0; k < results->direct_count; k++)
        if (results->direct[k].surface == results->baseline)
            return &results->direct[k];
    return NULL;
}

static const struct scene_asked *first_ratio(const struct scene_asked *asked, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (quantity_unit(asked[i].quantity).offset == 0)
            return &asked[i];
    return NULL;
}

const struct scene_asked *results_asked(const struct results *results, bool *is_target)
{
    const struct scene *scene = results->scene;
    const struct scene_asked *target = first_ratio(scene->targets, scene->target_count);
    *is_target = target != NULL;
    return target || results->measured ? target : first_ratio(scene->limits, scene->limit_count);
}

enum quantity results_asked_quantity(const struct results *results)
{
    bool is_target;
    const struct scene_asked *asked = results_asked(results, &is_target);
    return asked               ? asked->quantity
           : results->measured ? results_measured_quantity(results)
                               : quantity_first(plan_quantities(results->plan));
}

enum quantity results_criterion(const struct results *results)
{
    unsigned computed = plan_quantities(results->plan);
    const enum quantity asked = results_asked_quantity(results);
    for (enum quantity q = 0; q < QUANTITY_COUNT; q++)
        computed &= quantity_rows[q].from ? ~QUANTITY_BIT(q) : ~0U;
    if (asked == QUANTITY_TCR || (quantity_rows[asked].from & QUANTITY_BIT(QUANTITY_TCR)))
        computed &= ~QUANTITY_BIT(QUANTITY_ECR);
    return quantity_first(computed);
}

const struct estimate *results_estimate(const struct results *results, size_t surface, enum quantity quantity)
{
    const struct surface_summary *summary = &results->surfaces[surface].summary;
    const struct curve_summary *leading = surface_model(summary, plan_leading_model(results->plan));
    return isnan(leading->operating.value[quantity]) ? &estimate_none : curve_summary_estimate(leading, (int)quantity);
}

double results_cost(const struct results *results, size_t surface, enum quantity criterion)
{
    const struct curve_summary *leading =
        surface_model(&results->surfaces[surface].summary, plan_leading_model(results->plan));
    const double value = leading->exists ? leading->operating.value[criterion] : NAN;
    return isnan(value) ? INFINITY : (quantity_rows[criterion].is & QUANTITY_RISES) ? -value : value;
}

enum { SHOWN_MOST = 8 };

static int compare_roughness(const void *a, const void *b, void *context)
{
    const struct surface_record *surfaces = context;
    size_t i = *(const size_t *)a, j = *(const size_t *)b;
    double x = surfaces[i].summary.roughness.rq_m, y = surfaces[j].summary.roughness.rq_m;
    return x < y ? -1 : x > y ? 1 : i < j ? -1 : 1;
}

static int compare_answers(const void *a, const void *b, void *context)
{
    const struct results *results = context;
    const enum quantity criterion = results_criterion(results);
    double x = results_cost(results, *(const size_t *)a, criterion),
           y = results_cost(results, *(const size_t *)b, criterion);
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
