/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/plan.h"

#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

void plan_decide(struct plan *plan, enum effect effect, bool runs, const char *format, ...)
{
    struct plan_effect *out = &plan->effects[effect];
    va_list args;
    va_start(args, format);
    vsnprintf(out->reason, sizeof out->reason, format, args);
    va_end(args);
    out->runs = runs;
    plan->running = runs ? plan->running | EFFECT_BIT(effect) : plan->running & ~EFFECT_BIT(effect);
    plan->wanted = quantity_wanted(plan->running);
}

/** Says what an effect lacks to run on every surface, and whose; false: nothing. */
static bool say_lack(struct plan *plan, enum effect effect, const struct scene *scene)
{
    size_t lacking = 0, count = scene->surface_count > 0 ? scene->surface_count : 1, first = 0;
    const struct material_property *property = NULL;
    for (size_t k = count; k-- > 0;) {
        const char *body;
        const struct material_property *own = scene_lack(&body, scene_bodies_of(scene, k), &effect_rows[effect]);
        lacking += own != NULL;
        first = own ? k : first;
        property = own ? own : property;
    }
    if (lacking == 0)
        return false;
    if (lacking < count) { /* escaped where the reason is written */
        const char *name = scene->surfaces[first].name;
        plan_decide(plan, effect, false, "the material of surface '%.*s' has no %s", (int)text_fit(name, 100), name,
                    property->name);
    } else {
        bool none = isnan(scene_bodies_of(scene, 0)->material.youngs_modulus_Pa);
        plan_decide(plan, effect, false, none ? "no material is given, so no %s" : "the material has no %s",
                    property->name);
    }
    return true;
}

static void decide(struct plan *plan, enum effect effect, const struct scene *scene)
{
    const struct effect_row *row = &effect_rows[effect];
    const bool listed = scene->effects & EFFECT_BIT(effect);
    if (effect == EFFECT_CONVERGENCE &&
        !(plan_running_models(plan) & model_flagged(offsetof(struct model_row, stacks_scales)))) {
        plan_decide(plan, effect, false, "a question to the multiscale models, which do not run");
    } else if (effect == EFFECT_DIRECT) { /* seconds where the rest takes milliseconds: never unasked */
        plan_decide(plan, effect, scene->direct.called,
                    "not called for; it says how far each model is off, in seconds to minutes");
    } else if (row->only_listed && !listed) {
        plan_decide(plan, effect, false, "only where effects lists it");
    } else if (effect == EFFECT_UNLOADING) {
        const struct model_row *leading = model_rows[plan_leading_model(plan)];
        plan_decide(plan, effect, leading->plastic,
                    leading->plastic ? "listed in the scene" : "%s, which leads, has no hardness", leading->label);
    } else if (row->key && !(scene->called & EFFECT_BIT(effect))) {
        plan_decide(plan, effect, false, "no '%s' is given", row->key);
    } else if (!scene->effects_auto) {
        plan_decide(plan, effect, row->key || listed,
                    row->key ? "the scene has '%s'"
                    : listed ? "listed in the scene"
                             : "not listed in the scene",
                    row->key);
    } else if (say_lack(plan, effect, scene)) {
        return;
    } else if (row->needs_effects & ~plan->running) {
        plan_decide(plan, effect, false, "builds on an effect that does not run");
    } else {
        plan_decide(plan, effect, true,
                    row->key             ? "the scene has '%s'"
                    : row->properties[0] ? "the material gives what it needs"
                                         : "needs no more than E'",
                    row->key);
    }
}

/** What a report is asked for first: the first target, else what models compute of the greatest precedence. */
static enum quantity asked_quantity(const struct plan *plan, const struct scene *scene)
{
    return scene->target_count > 0 ? scene->targets[0].quantity : quantity_first(plan_quantities(plan));
}

void plan_make(struct plan *out, const struct scene *scene)
{
    *out = (struct plan){
        .models = scene->models,
        .all_uncertain = scene->effects & EFFECT_BIT(EFFECT_UNCERTAINTY),
        .area_reason = "every report has it",
    };
    for (int e = 0; e < EFFECT_COUNT; e++)
        decide(out, (enum effect)e, scene);
}

bool plan_runs(const struct plan *plan, enum effect effect)
{
    return plan->running & EFFECT_BIT(effect);
}

bool plan_runs_model(const struct plan *plan, size_t m)
{
    return model_runs(m, plan->models, plan->running);
}

uint64_t plan_running_models(const struct plan *plan)
{
    uint64_t models = 0;
    for (size_t m = 0; m < model_count; m++)
        models |= plan_runs_model(plan, m) ? MODEL_BIT(m) : 0;
    return models;
}

unsigned plan_quantities(const struct plan *plan)
{
    unsigned computed = 0;
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(plan, m))
            computed |= quantity_with_made(model_rows[m]->quantities);
    return computed & plan->wanted;
}

bool plan_uses_asperities(const struct plan *plan)
{
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(plan, m) && model_rows[m]->asperity_model)
            return true;
    return false;
}

size_t plan_leading_model(const struct plan *plan)
{
    size_t leading = 0;
    int most = -1;
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(plan, m) && !(plan->beside & MODEL_BIT(m)) && model_rows[m]->precedence > most) {
            most = model_rows[m]->precedence;
            leading = m;
        }
    return leading;
}

void plan_choose_model(struct scene *scene)
{
    struct plan plan;
    plan_make(&plan, scene);
    const bool hard = plan_runs(&plan, EFFECT_PLASTICITY);
    size_t chosen = model_count;
    bool met = false;
    for (size_t i = 0; i < scene->surface_count; i++)
        scene->one_scan = scene->one_scan || scene->surfaces[i].files.count == 1;
    for (size_t m = 0; m < model_count; m++) {
        const struct model_row *row = model_rows[m], *before = chosen < model_count ? model_rows[chosen] : NULL;
        const double rms = plan_runs_model(&plan, m) && row->plastic == hard
                               ? model_rms(row, asked_quantity(&plan, scene), scene->one_scan, hard)
                               : 0;
        const bool good = expm1(rms) <= scene->accuracy;
        if (!(rms > 0) || (met && !good))
            continue;
        if (!before || (good && !met) || (good && row->uses_strip < before->uses_strip) ||
            (row->uses_strip == before->uses_strip && rms < scene->chosen_rms) || (!good && rms < scene->chosen_rms)) {
            chosen = m;
            scene->chosen_rms = rms;
        }
        met = met || good;
    }
    if (chosen == model_count)
        return;
    scene->models_named = true;
    scene->models = MODEL_BIT(chosen);
    if (model_rows[chosen]->elastic)
        scene->models |= MODEL_BIT(model_index(model_rows[chosen]->elastic));
}
