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
    uint64_t models = 0;
    for (size_t m = 0; m < model_count; m++)
        if (model_rows[m]->by_default)
            models |= MODEL_BIT(m);
    return models;
}

bool model_runs(size_t m, uint64_t models, unsigned effects)
{
    return m < model_count && (models & MODEL_BIT(m)) &&
           (!model_rows[m]->plastic || (effects & EFFECT_BIT(EFFECT_PLASTICITY)));
}

/** Is the quantity infinite at none of the points, and there where it is `needed`? */
static bool is_finite(const struct contact_point *points, size_t count, enum quantity quantity, bool needed)
{
    for (size_t i = 0; i < count; i++) {
        double value = points[i].value[quantity];
        if (isinf(value) || (needed && isnan(value)))
            return false;
    }
    return true;
}

enum status_code model_run(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                           struct status *status)
{
    for (size_t i = 0; i <= task->load_count; i++)
        curve->points[i] = quantity_nothing();
    curve->full = quantity_nothing();
    curve->full_load = curve->closed_load = curve->beta = NAN;
    if (row->run(curve, row, task, status) != STATUS_OK)
        return status->code;
    if (task->evaluations)
        *task->evaluations += curve->evaluations;
    /* a model that knows of no full contact says nothing of it */
    bool full = curve->exists && !(isnan(curve->full_load) && isnan(curve->full.value[QUANTITY_AREA]));
    unsigned always = task->wanted & row->quantities & ~row->may_be_empty;
    bool finite = true;
    for (int q = 0; q < QUANTITY_COUNT && finite; q++) {
        bool needed = always & QUANTITY_BIT(q);
        finite = is_finite(curve->points, curve->count, (enum quantity)q, needed) &&
                 (!full || is_finite(&curve->full, 1, (enum quantity)q, needed));
    }
    if (!finite) {
        curve->exists = false;
        curve->overflows = true;
        curve->count = 0;
    }
    return STATUS_OK;
}

enum quantity model_shown(const struct model_row *row, enum quantity quantity)
{
    bool adjusts = quantity == QUANTITY_SEPARATION && (row->quantities & QUANTITY_BIT(QUANTITY_ADJUSTED));
    return adjusts ? QUANTITY_ADJUSTED : quantity;
}

double model_sd(const struct model_row *row, enum quantity quantity)
{
    bool resistance = QUANTITY_RESISTANCES & QUANTITY_BIT(quantity);
    return quantity == QUANTITY_AREA         ? row->ln_sd[0]
           : quantity == QUANTITY_SEPARATION ? row->ln_sd[1]
           : resistance                      ? row->ln_sd[2]
                                             : 0;
}

double model_task_longest_waves(const struct model_task *task)
{
    return task->rows && !task->rows->periodic ? spectrum_longest_waves(task->spectrum) : 0;
}

double model_surface_sd(const struct model_row *row, enum quantity quantity, double longest_waves)
{
    static const double waves = 2.5, sd = 1.3;
    double own = model_sd(row, quantity);
    return own > 0 && longest_waves > 0 && longest_waves < waves ? hypot(own, sd * log(waves / longest_waves)) : own;
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
