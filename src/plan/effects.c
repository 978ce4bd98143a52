/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "plan/effects.h"
#include "base/costs.h"
#include "base/number_format.h"

#include "contact/convergence.h"
#include "contact/corrected_persson.h"
#include <float.h>
#include <math.h>
#include <stddef.h>

/** Upper bound of the pressure in spots for any height distribution, over that for a Gaussian one. */
static const double heights_factor = 4;

/** Pressure in contact over hardness at the largest area of the corrected theory, where it is highest. */
static double pressure_over_hardness(const struct spectrum *spectrum, const struct material_pair *pair)
{
    double m2 = spectrum_moment(spectrum, 1), area = CORRECTED_PERSSON_LARGEST_AREA;
    double pressure_Pa = m2 > 0 ? corrected_persson_load(area, m2) / area * pair->effective_modulus_Pa : 0;
    return heights_factor * pressure_Pa / pair->hardness_Pa;
}

/** The largest such ratio of the surface, of its scans alone, and, if slopes go on rising below the sampling limit, of
 * waves of atomic length. */
static double bound_pressure(const struct surface_record *record)
{
    const struct surface_summary *summary = &record->summary;
    double most = pressure_over_hardness(&record->spectrum, &summary->pair);
    for (size_t r = 0; r < record->ensemble.count; r++)
        most = fmax(most, pressure_over_hardness(&record->ensemble.members[r].spectrum, &summary->pair));
    if (!(summary->tail.gamma < 1))
        return most;
    double amplitude_m = convergence_tail_amplitude(&summary->tail, convergence_atom_m);
    const struct spectrum end = {.amplitude_m = &amplitude_m, .count = 1, .length_m = convergence_atom_m};
    return fmax(most, pressure_over_hardness(&end, &summary->pair));
}

enum status_code effects_bound(struct surface_record *record, const struct surface_task *asked, struct status *status)
{
    const struct scene *scene = asked->scene;
    const struct plan *plan = asked->plan;
    const double at[2] = {asked->loads[0], asked->loads[asked->load_count - 1]};
    const struct model_task task = surface_model_task(record, asked);
    struct model_task ends = model_task_at(&task, at, at[1] > at[0] ? 2 : 1);
    double *most = &record->summary.scale_dependence;
    if (scene->effects_auto && plan_runs(plan, EFFECT_PLASTICITY))
        record->summary.pressure_over_hardness = bound_pressure(record);
    if (!scene->effects_auto || !plan_runs(plan, EFFECT_SCALE_DEPENDENT))
        return STATUS_OK;
    ends.wanted = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_TCR) |
                  QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT);
    for (size_t m = 0; m < model_count; m++) {
        struct contact_point points[3];
        struct model_curve curve = {.points = points};
        const struct model_row *row = model_rows[m];
        /* an elastic model stands for its plastic partner */
        bool stands_for_it = row->elastic && plan_runs_model(plan, model_index(row->elastic));
        if (!plan_runs_model(plan, m) || stands_for_it ||
            !(row->quantities & QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT)))
            continue;
        if (ensemble_curve(&curve, NULL, &record->ensemble, model_rows[m], &ends, status) != STATUS_OK)
            return status->code;
        for (size_t i = 0; i < curve.count; i++)
            if (points[i].value[QUANTITY_TCR] > 0)
                *most = fmax(*most, points[i].value[QUANTITY_TCR_SCALE_DEPENDENT] / points[i].value[QUANTITY_TCR] - 1);
    }
    return STATUS_OK;
}

enum { SHOWN = 40 };

/** Two digits, as a reader wants them. */
static const char *shown(char out[SHOWN], double value)
{
    OWNED(text_free) struct text text = {0};
    number_format(&text, fmin(value, DBL_MAX), 2);
    snprintf(out, SHOWN, "%s", text_string(&text));
    return out;
}

/** Plasticity changes the area by at most (1 + r^4)^(1/4) - 1, r the pressure in contact over hardness. A plastic model
 * that is named and has no elastic partner needs it in any case. */
static void decide_plasticity(struct plan *plan, const struct scene *scene, const struct surface_record *surfaces,
                              size_t count)
{
    char times[SHOWN], area[SHOWN];
    double most = 0;
    bool needed = false;
    for (size_t i = 0; i < count; i++)
        most = fmax(most, surfaces[i].summary.pressure_over_hardness);
    for (size_t m = 0; m < model_count; m++)
        needed = needed ||
                 (scene->models_named && plan_runs_model(plan, m) && model_rows[m]->plastic && !model_rows[m]->elastic);
    const double change = expm1(log1p(pow(most, 4)) / 4);
    bool runs = needed || change > scene->tolerance;
    plan_decide(plan, EFFECT_PLASTICITY, runs,
                words_say(plan->words, "%s\ntimes %s\nchange %s", runs ? "effect.yields" : "effect.yields_little",
                          shown(times, most), shown(area, 100 * change)));
}

static void decide_scale_dependence(struct plan *plan, const struct surface_record *surfaces, size_t count,
                                    double tolerance)
{
    char by[SHOWN];
    double most = 0;
    for (size_t i = 0; i < count; i++)
        most = fmax(most, surfaces[i].summary.scale_dependence);
    plan_decide(plan, EFFECT_SCALE_DEPENDENT, most > tolerance,
                words_say(plan->words, "%s\nby %s\n%s", most > 0 ? "effect.raises_tcr" : "effect.no_model",
                          shown(by, 100 * most), most > tolerance ? "" : "little"));
}

/** Runs if a surface has a single scan, but where the direct solution of maps leads. */
static void decide_uncertainty(struct plan *plan, const struct surface_record *surfaces, size_t count)
{
    size_t single = 0;
    for (size_t i = 0; i < count && !model_rows[plan_leading_model(plan)]->uses_map; i++)
        single += surfaces[i].summary.usable && surfaces[i].summary.single_points > 0;
    plan_decide(plan, EFFECT_UNCERTAINTY, single > 0,
                words_say(plan->words, "%s\nsurfaces %zu%s%s", single > 0 ? "effect.one_scan" : "effect.no_scan",
                          single, single == 1 ? "\none" : "", count > 0 && surfaces->counterface ? "\npaired" : ""));
}

/** Strips run if any surface has them. */
static void decide_strips(struct plan *plan, const struct surface_record *surfaces, size_t count)
{
    size_t has = 0, lacking = 0;
    const uint64_t users = model_flagged(offsetof(struct model_row, uses_strip));
    for (size_t i = 0; i < count; i++) {
        has += surfaces[i].summary.has_strips;
        lacking += surfaces[i].summary.usable && !surfaces[i].summary.has_strips;
    }
    if (has > 0 || lacking == 0 || !(plan->models & users))
        return;
    plan->models &= ~users;
    plan->area_reason = words_say(plan->words, "area.no_strips");
}

/** The direct solution of maps leads if every surface has one; if only some have, it is shown beside the leading model.
 */
static void decide_tiles(struct plan *plan, const struct surface_record *surfaces, size_t count)
{
    double cost = 0;
    size_t maps = 0, dear = 0, lacking = 0;
    const uint64_t users = plan->models & model_flagged(offsetof(struct model_row, uses_map));
    for (size_t i = 0; i < count; i++) {
        const struct surface_summary *summary = &surfaces[i].summary;
        maps += summary->usable && summary->has_tiles;
        lacking += summary->usable && !summary->has_tiles;
        dear += summary->usable && !summary->has_tiles && summary->tile_cost > 0;
        cost += summary->usable ? summary->tile_cost : 0;
    }
    if (users == 0 || lacking == 0)
        return;
    if (maps > 0 && dear == 0)
        plan->beside |= users;
    else
        plan->models &= ~users;
    if (maps > 0 || dear > 0)
        plan->area_reason = words_say(plan->words, "%s\nseconds %.2g\nsurfaces %zu\n%s",
                                      dear > 0 ? "area.dear_maps" : "area.without_map", cost * costs.transform_s,
                                      lacking, lacking == 1 ? "one" : "");
}

void effects_fit_models(struct plan *plan, const struct surface_record *surfaces, size_t count)
{
    decide_strips(plan, surfaces, count);
    decide_tiles(plan, surfaces, count);
}

void effects_decide(struct plan *plan, const struct scene *scene, const struct surface_record *surfaces, size_t count)
{
    effects_fit_models(plan, surfaces, count);
    if (!scene->effects_auto)
        return;
    unsigned open = plan->running & ~scene->effects; /* listed effects run in any case */
    if (open & EFFECT_BIT(EFFECT_PLASTICITY))
        decide_plasticity(plan, scene, surfaces, count);
    if (open & EFFECT_BIT(EFFECT_SCALE_DEPENDENT))
        decide_scale_dependence(plan, surfaces, count, scene->tolerance);
    if (open & EFFECT_BIT(EFFECT_UNCERTAINTY))
        decide_uncertainty(plan, surfaces, count);
}
