/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/accuracy.h"

#include "answers/direct_study.h"
#include "results/comparison.h"
#include <math.h>

double accuracy_few_waves_sd(const struct results *results, size_t surface)
{
    const struct surface_task asked = results_task(results, surface);
    const struct model_task task = surface_model_task(&results->surfaces[surface], &asked);
    return model_few_waves_sd(model_task_reach(&task).longest_waves);
}

/** Sets what is known of a model's error: the table's, and how far it is from the direct solution of this surface. */
static void set_error(struct accuracy *out, const struct results *results, size_t m, enum quantity quantity)
{
    const struct surface_summary *summary = &results->surfaces[results->baseline].summary;
    const struct direct_study *study = results_direct_baseline(results);
    const enum quantity held = quantity == QUANTITY_MEAN_GAP      ? QUANTITY_SEPARATION
                               : quantity_rows[quantity].from > 0 ? results_criterion(results)
                                                                  : quantity;
    const size_t leading = plan_leading_model(results->plan);
    struct direct_study_distance distance = {0};
    if (study && study->models && direct_study_kind_of(study, m) == direct_study_kind_of(study, leading))
        distance = direct_study_distance(study, &summary->pair, m, held);
    out->here = distance.loads > 0 ? fmax(distance.most, 1 / distance.least) : NAN;
    out->sd = model_sd(model_rows[m], quantity, surface_knows_both(summary));
    if (out->sd > 0)
        out->sd = hypot(out->sd, accuracy_few_waves_sd(results, results->baseline));
    else if (model_rows[m]->uses_map)
        out->sd = curve_summary_estimate(surface_model(summary, m), (int)held)->half_width / log(model_factor(1));
    if (!(out->sd > 0))
        out->sd = NAN;
}

struct accuracy accuracy_of(const struct results *results, size_t model, enum quantity quantity)
{
    struct accuracy out = {.sd = 0};
    const struct benchmark *cost = results->benchmark;
    const struct surface_summary *summary = &results->surfaces[results->baseline].summary;
    size_t first = 0;
    while (cost && first < cost->count && cost->rows[first].model != model)
        first++;
    if (!cost || first == cost->count)
        return out;
    const double solved = (model_rows[model]->uses_strip ? summary->times.strips : 0) +
                          (model_rows[model]->uses_map ? summary->times.tiles[model_rows[model]->plastic] : 0);
    set_error(&out, results, model, quantity);
    for (size_t i = 0; i < BENCHMARK_STEPS; i++) {
        const struct benchmark_row *row = &cost->rows[first + i];
        const double tolerance = results->scene->tolerance;
        out.seconds[i] = solved + row->seconds;
        out.total_error[i] = hypot(model_factor(out.sd) - 1, row->error);
        if (fabs(log(row->tolerance / tolerance)) < fabs(log(cost->rows[first + out.used].tolerance / tolerance)))
            out.used = i;
    }
    return out;
}

double accuracy_effect_factor(const struct results *results, enum effect effect, enum quantity quantity)
{
    const size_t leading = plan_leading_model(results->plan), surface = results->baseline;
    const struct model_row *row = model_rows[leading];
    const struct contact_point with = comparison_middle(results, leading, surface);
    struct contact_point without = with;
    if (!plan_runs(results->plan, effect) || effect_rows[effect].adds || effect_rows[effect].studies ||
        (effect != EFFECT_SHAPE && effect != EFFECT_PLASTICITY && plan_runs(results->plan, EFFECT_SHAPE)))
        return NAN; /* in the last case the shape would have to be solved again */
    if (effect == EFFECT_PLASTICITY && row->elastic)
        without = comparison_middle(results, model_index(row->elastic), surface);
    if (effect == EFFECT_PLASTICITY)
        return row->elastic ? with.value[quantity] / without.value[quantity] : NAN;
    const struct surface_record *record = &results->surfaces[surface];
    const struct surface_task asked = results_task(results, surface);
    const struct model_task task = surface_model_task(record, &asked);
    struct joint_task joint = surface_joint(record, results->scene, results->plan, &task);
    if (effect == EFFECT_GAP && joint_is_held(&with, &joint))
        return NAN; /* without the filler the metals would come closer */
    joint.effects &= ~EFFECT_BIT(effect);
    for (enum quantity q = 0; q < QUANTITY_COUNT; q++)
        without.value[q] = quantity_of_joint(q) ? NAN : with.value[q];
    joint_apply(&without, NULL, 1, &joint, row);
    double before = without.value[quantity];
    if (isnan(before) && quantity_rows[quantity].from > 0) { /* without it there is none such, but what it is of */
        const bool rises = quantity_rows[quantity].is & QUANTITY_RISES;
        before = joint_resistance(without.value, &joint, rises ? JOINT_HEAT : JOINT_CURRENT);
        before = rises ? 1 / before : before;
    }
    return with.value[quantity] / before;
}
