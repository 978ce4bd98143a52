/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

size_t model_index(const struct model_row *row)
{
    size_t m = 0;
    while (m < model_count && model_rows[m] != row)
        m++;
    return m;
}

uint64_t model_find(const char *name)
{
    uint64_t models = 0;
    for (size_t m = 0; m < model_count; m++)
        if (strcmp(model_rows[m]->name, name) == 0 || strcmp(model_rows[m]->family, name) == 0)
            models |= MODEL_BIT(m);
    return models;
}

uint64_t model_defaults(void)
{
    return MODEL_BIT(model_count) - 1;
}

uint64_t model_flagged(size_t offset)
{
    uint64_t models = 0;
    for (size_t m = 0; m < model_count; m++)
        models |= *(const bool *)((const char *)model_rows[m] + offset) ? MODEL_BIT(m) : 0;
    return models;
}

bool model_runs(size_t m, uint64_t models, unsigned effects)
{
    return m < model_count && (models & MODEL_BIT(m)) &&
           (!model_rows[m]->plastic || (effects & EFFECT_BIT(EFFECT_PLASTICITY)));
}

/** Is the quantity finite at all points? NaN is allowed unless it is `needed`. */
static bool is_finite(const struct contact_point *points, size_t count, int quantity, bool needed)
{
    for (size_t i = 0; i < count; i++) {
        double value = points[i].value[quantity];
        if (isinf(value) || (needed && isnan(value)))
            return false;
    }
    return true;
}

/** k = -dP/d separation from the separations at P exp(-h) and P exp(+h): 2 P sinh(h) over their difference. NaN where
 * the model has no answer on one side. */
static enum status_code add_stiffness(struct model_curve *curve, const struct model_row *row,
                                      const struct model_task *task, struct status *status)
{
    const double step = row->stiffness_step, modulus_Pa = task->pair->effective_modulus_Pa;
    size_t count = task->load_count;
    OWNED(memory_free) struct contact_point *beside = calloc(count + 1, sizeof *beside);
    OWNED(memory_free) double *loads = malloc((count + 1) * sizeof *loads), *lost_m = calloc(count + 1, sizeof *lost_m);
    if (!beside || !loads || !lost_m)
        (void)status_memory(status);
    for (int side = -1; side <= 1 && status->code == STATUS_OK; side += 2) {
        struct model_curve shifted = {.points = beside};
        struct model_task asked = model_task_at(task, loads, count);
        asked.wanted = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_SEPARATION);
        for (size_t i = 0; i < count; i++) {
            loads[i] = task->loads[i] * exp(side * step);
            beside[i] = quantity_nothing();
        }
        if (row->run(&shifted, row, &asked, status) != STATUS_OK)
            break;
        curve->evaluations += shifted.evaluations;
        for (size_t i = 0; i < count; i++) {
            bool there = i < shifted.count && beside[i].value[QUANTITY_LOAD] == loads[i];
            lost_m[i] -= there ? side * beside[i].value[QUANTITY_SEPARATION] : NAN;
        }
    }
    for (size_t i = 0; i < curve->count && i < count && status->code == STATUS_OK; i++)
        if (lost_m[i] > 0)
            curve->points[i].value[QUANTITY_STIFFNESS] = modulus_Pa * task->loads[i] * 2 * sinh(step) / lost_m[i];
    return status->code;
}

enum status_code model_run(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                           struct status *status)
{
    for (size_t i = 0; i <= task->load_count; i++)
        curve->points[i] = quantity_nothing();
    curve->full = quantity_nothing();
    curve->full_load = curve->beta = NAN;
    if (row->run(curve, row, task, status) != STATUS_OK)
        return status->code;
    if (curve->exists && row->stiffness_step > 0 && (task->wanted & QUANTITY_BIT(QUANTITY_STIFFNESS)) &&
        add_stiffness(curve, row, task, status) != STATUS_OK)
        return status->code;
    if (task->evaluations)
        *task->evaluations += curve->evaluations;
    bool full = curve->exists && !(isnan(curve->full_load) && isnan(curve->full.value[QUANTITY_AREA]));
    unsigned always = task->wanted & row->quantities & ~row->may_be_empty & ~QUANTITY_BIT(QUANTITY_STIFFNESS);
    bool finite = true;
    for (int q = 0; q < QUANTITY_COUNT && finite; q++) {
        bool needed = always & QUANTITY_BIT(q);
        finite = is_finite(curve->points, curve->count, q, needed) && (!full || is_finite(&curve->full, 1, q, needed));
    }
    if (!finite) {
        curve->exists = false;
        curve->overflows = true;
        curve->count = 0;
    }
    return STATUS_OK;
}

struct contact_point model_point(const struct transfer_point *contact, const struct model_row *row,
                                 const struct model_task *task)
{
    struct contact_point point = quantity_nothing();
    double resistance_m = 2 * contact->constriction_m; /* (rho_1 + rho_2) l = 2 rho l */
    point.value[QUANTITY_LOAD] = contact->load;
    point.value[QUANTITY_AREA] = contact->area_ratio;
    if (task->wanted & QUANTITY_BIT(QUANTITY_SEPARATION))
        point.value[QUANTITY_SEPARATION] = contact->separation_m;
    if ((task->wanted & QUANTITY_BIT(QUANTITY_STIFFNESS)) && !(row->stiffness_step > 0)) /* Barber: d gap = -2 l dp */
        point.value[QUANTITY_STIFFNESS] = task->pair->effective_modulus_Pa / resistance_m;
    if (task->wanted & QUANTITY_BIT(QUANTITY_ECR))
        point.value[QUANTITY_ECR] = task->pair->resistivity_ohm_m * resistance_m;
    if (task->wanted & QUANTITY_BIT(QUANTITY_TCR))
        point.value[QUANTITY_TCR] = resistance_m / task->pair->conductivity_W_per_mK;
    return point;
}

enum quantity model_shown(const struct model_row *row, enum quantity quantity)
{
    bool adjusts = quantity == QUANTITY_SEPARATION && (row->quantities & QUANTITY_BIT(QUANTITY_ADJUSTED));
    return adjusts ? QUANTITY_ADJUSTED : quantity;
}

struct scans_reach model_task_reach(const struct model_task *task)
{
    return (struct scans_reach){task->open ? spectrum_longest_waves(task->spectrum) : 0, task->two_directions};
}

double model_elastic_share(const struct model_row *row, const struct contact_point *point, double load_over_hardness)
{
    double share = 1 - pow(load_over_hardness / point->value[QUANTITY_AREA], 4);
    return row->plastic && !isnan(share) ? fmax(share, 0) : 1;
}

bool model_area_is_pressed(const struct model_row *row, const struct contact_point *point,
                           const struct material_pair *pair)
{
    const double *value = point->value, pressure_Pa = material_pair_pressure(pair, value[QUANTITY_LOAD]);
    return row->plastic && value[QUANTITY_AREA] < 1 &&
           fabs(value[QUANTITY_AREA] * pair->hardness_Pa / pressure_Pa - 1) < 1e-3;
}

bool model_is_overloaded(const struct model_row *row, const struct contact_point *point,
                         const struct material_pair *pair)
{
    const double *value = point->value, pressure_Pa = material_pair_pressure(pair, value[QUANTITY_LOAD]);
    return !row->plastic && value[QUANTITY_AREA] > 0 && pressure_Pa > pair->hardness_Pa * value[QUANTITY_AREA];
}

bool model_curve_bears(const struct model_curve *curve, double load)
{
    return !(curve->crushed_load > 0 && load >= curve->crushed_load);
}

size_t model_task_operating(const struct model_task *task)
{
    return task->operating_place > 0 ? task->operating_place - 1 : task->load_count / 2;
}

struct model_task model_task_at(const struct model_task *task, const double *loads, size_t load_count)
{
    struct model_task out = *task;
    out.loads = loads;
    out.load_count = load_count;
    out.operating_place = 0;
    return out;
}
