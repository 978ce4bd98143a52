/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "certainty/sensitivity.h"

#include <math.h>

const struct sensitivity_change_row sensitivity_changes[SENSITIVITY_CHANGES] = {
    [SENSITIVITY_CUTOFF_DOUBLED] = {"cut-off x2", false},
    [SENSITIVITY_SCAN_HALVED] = {"scan /2", false},
    [SENSITIVITY_HARDNESS_RAISED] = {"hardness x1.1", true},
};

/** Factor on hardness and yield strength: about how well they are known of a metal of unknown temper. */
static const double sensitivity_hardness_factor = 1.1;

/** Area and ECR at the one load of the task; NaN: no answer. */
static enum status_code solve_one(struct contact_point *out, const struct model_row *model,
                                  const struct model_task *task, struct status *status)
{
    struct contact_point points[2] = {0};
    struct model_curve curve = {.points = points};
    struct model_task own = *task;
    own.wanted &= QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_ECR);
    *out = quantity_nothing();
    if (model_run(&curve, model, &own, status) != STATUS_OK)
        return status->code;
    if (curve.exists && curve.count > 0 && points[0].value[QUANTITY_LOAD] == task->loads[0])
        *out = points[0];
    return STATUS_OK;
}

/** Geometric mean of two numbers over a third; NaN where that is 0. */
static double ratio(const struct contact_point *a, const struct contact_point *b, const struct contact_point *as_is,
                    enum quantity quantity)
{
    double whole = as_is->value[quantity];
    return whole > 0 ? sqrt(a->value[quantity]) * sqrt(b->value[quantity]) / whole : NAN;
}

enum status_code sensitivity_run(struct sensitivity_factors *out, const struct variants *variants,
                                 const struct model_row *model, const struct model_task *asked, struct status *status)
{
    struct model_task whole = *asked, *task = &whole;
    whole.transfer = NULL; /* a map's spectrum stays as it is, that of its rows does not */
    struct contact_point as_is, harder = quantity_nothing(), points[VARIANT_COUNT];
    struct material_pair pair = *task->pair;
    struct model_task raised = *task;
    for (int c = 0; c < SENSITIVITY_CHANGES; c++)
        out->area[c] = out->ecr[c] = NAN;
    if (variants->scans == 0 || model->uses_map) /* the map stays as it is */
        return STATUS_OK;
    if (solve_one(&as_is, model, task, status) != STATUS_OK)
        return status->code;
    for (int v = 0; v < VARIANT_COUNT; v++) {
        struct asperities asperities;
        struct model_task own = member_task(&asperities, &variants->of[v], task);
        own.levelled = variants->levelled[v];
        if (solve_one(&points[v], model, &own, status) != STATUS_OK)
            return status->code;
    }
    pair.yield_strength_Pa *= sensitivity_hardness_factor;
    raised.pair = &pair;
    raised.hardness_Pa *= sensitivity_hardness_factor;
    if (model->plastic && solve_one(&harder, model, &raised, status) != STATUS_OK)
        return status->code;
    const struct contact_point *cutoff = &points[VARIANT_CUTOFF];
    const struct {
        const struct contact_point *first, *second, *as_is;
    } changes[SENSITIVITY_CHANGES] = {
        [SENSITIVITY_CUTOFF_DOUBLED] = {cutoff, cutoff, &as_is},
        [SENSITIVITY_SCAN_HALVED] = {&points[VARIANT_FIRST_HALF], &points[VARIANT_SECOND_HALF], &points[VARIANT_WHOLE]},
        [SENSITIVITY_HARDNESS_RAISED] = {&harder, &harder, &as_is},
    };
    for (int c = 0; c < SENSITIVITY_CHANGES; c++) {
        out->area[c] = ratio(changes[c].first, changes[c].second, changes[c].as_is, QUANTITY_AREA);
        out->ecr[c] = ratio(changes[c].first, changes[c].second, changes[c].as_is, QUANTITY_ECR);
    }
    return STATUS_OK;
}
