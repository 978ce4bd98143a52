/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/plan.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>

/** The bodies of surface `i`; the scene's where it has no surface. */
static const struct scene_bodies *bodies_of(const struct scene *scene, size_t i)
{
    return i < scene->surface_count ? &scene->surfaces[i].bodies : &scene->bodies;
}

/** Says what an effect lacks to run on every surface, and whose; false: nothing. */
static bool say_lack(struct plan_effect *out, const struct effect_row *row, const struct scene *scene)
{
    size_t lacking = 0, count = scene->surface_count > 0 ? scene->surface_count : 1, first = 0;
    const struct material_property *property = NULL;
    for (size_t k = 0; k < count; k++) {
        const struct scene_bodies *bodies = bodies_of(scene, k);
        bool other = bodies->counterface_kind == MATERIAL_COUNTERFACE_ELASTIC, lacks = false;
        for (size_t i = 0; row->properties[i] && !lacks; i++) {
            const struct material_property *own = material_property_find(row->properties[i]);
            lacks = isnan(material_value(&bodies->material, own)) ||
                    (other && isnan(material_value(&bodies->counterface, own)));
            property = property || !lacks ? property : own;
            first = lacks && lacking == 0 ? k : first;
        }
        lacking += lacks;
    }
    if (lacking == 0)
        return false;
    if (lacking < count) { /* escaped where the reason is written */
        const char *name = scene->surfaces[first].name;
        snprintf(out->reason, sizeof out->reason, "the material of surface '%.*s' has no %s", (int)text_fit(name, 100),
                 name, property->name);
    } else {
        bool none = isnan(bodies_of(scene, 0)->material.youngs_modulus_Pa);
        snprintf(out->reason, sizeof out->reason, none ? "no material is given, so no %s" : "the material has no %s",
                 property->name);
    }
    return true;
}

static void decide(struct plan *plan, enum effect effect, const struct scene *scene)
{
    const struct effect_row *row = &effect_rows[effect];
    struct plan_effect *out = &plan->effects[effect];
    unsigned lacking = row->needs_effects & ~plan->running;
    const uint64_t stack_scales = model_flagged(offsetof(struct model_row, stacks_scales));
    if (effect == EFFECT_CONVERGENCE && !(plan_running_models(plan) & stack_scales)) {
        snprintf(out->reason, sizeof out->reason, "a question to the multiscale models, which do not run");
    } else if (effect == EFFECT_DIRECT) { /* seconds where the rest takes milliseconds: never unasked */
        out->runs = scene->direct.called;
        snprintf(out->reason, sizeof out->reason,
                 "not called for; it says how far each model is off, in seconds to minutes");
    } else if (row->only_listed && !(scene->effects & EFFECT_BIT(effect))) {
        snprintf(out->reason, sizeof out->reason, "only where effects lists it");
    } else if (effect == EFFECT_UNLOADING) {
        const struct model_row *leading = model_rows[plan_leading_model(plan)];
        out->runs = leading->plastic;
        snprintf(out->reason, sizeof out->reason,
                 leading->plastic ? "listed in the scene" : "%s, which leads, has no hardness", leading->label);
    } else if (row->key && !(scene->called & EFFECT_BIT(effect))) {
        snprintf(out->reason, sizeof out->reason, "no '%s' is given", row->key);
    } else if (row->key && !scene->effects_auto) {
        out->runs = true;
        snprintf(out->reason, sizeof out->reason, "the scene has '%s'", row->key);
    } else if (!scene->effects_auto) {
        out->runs = scene->effects & EFFECT_BIT(effect);
        snprintf(out->reason, sizeof out->reason, out->runs ? "listed in the scene" : "not listed in the scene");
    } else if (say_lack(out, row, scene)) {
        out->runs = false;
    } else if (lacking) {
        snprintf(out->reason, sizeof out->reason, "builds on an effect that does not run");
    } else {
        out->runs = true;
        snprintf(out->reason, sizeof out->reason,
                 row->key             ? "the scene has '%s'"
                 : row->properties[0] ? "the material gives what it needs"
                                      : "needs no more than E'",
                 row->key);
    }
    if (out->runs)
        plan->running |= EFFECT_BIT(effect);
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
    out->wanted = quantity_wanted(out->running);
}

bool plan_runs(const struct plan *plan, enum effect effect)
{
    return plan->running & EFFECT_BIT(effect);
}

void plan_switch_off(struct plan *plan, enum effect effect)
{
    plan->effects[effect].runs = false;
    plan->running &= ~EFFECT_BIT(effect);
    plan->wanted = quantity_wanted(plan->running);
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
