/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/plan.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/** The bodies of surface `i`; the scene's where it has no surface. */
static const struct scene_bodies *bodies_of(const struct scene *scene, size_t i)
{
    return i < scene->surface_count ? &scene->surfaces[i].bodies : &scene->bodies;
}

/** What an effect lacks to run on every surface. */
struct lack {
    const char *property; /* NULL: nothing */
    const char *surface;  /* the first that lacks it, where not all do; else NULL */
    bool material;        /* nothing at all is known of its material */
};

static struct lack find_lack(const struct effect_row *row, const struct scene *scene)
{
    struct lack out = {0};
    size_t lacking = 0, count = scene->surface_count > 0 ? scene->surface_count : 1;
    for (size_t k = 0; k < count; k++) {
        const struct scene_bodies *bodies = bodies_of(scene, k);
        bool other = bodies->counterface_kind == MATERIAL_COUNTERFACE_ELASTIC, lacks = false;
        for (size_t i = 0; row->properties[i] && !lacks; i++) {
            const struct material_property *property = material_property_find(row->properties[i]);
            lacks = isnan(material_value(&bodies->material, property)) ||
                    (other && isnan(material_value(&bodies->counterface, property)));
            if (lacks && !out.property)
                out = (struct lack){property->name, k < scene->surface_count ? scene->surfaces[k].name : NULL,
                                    isnan(bodies->material.youngs_modulus_Pa)};
        }
        lacking += lacks;
    }
    if (lacking == count)
        out.surface = NULL;
    return out;
}

static void say_lack(struct plan_effect *out, const struct lack *lack)
{
    char whose[140] = "";
    if (lack->surface) /* escaped where the reason is written */
        snprintf(whose, sizeof whose, " of surface '%.*s'", (int)text_fit(lack->surface, 100), lack->surface);
    if (lack->material && !lack->surface)
        snprintf(out->reason, sizeof out->reason, "no material is given, so no %s", lack->property);
    else
        snprintf(out->reason, sizeof out->reason, "the material%s has no %s", whose, lack->property);
}

static bool same_bodies(const struct scene *scene)
{
    for (size_t i = 1; i < scene->surface_count; i++)
        if (strcmp(scene->surfaces[i].bodies.material.name, scene->surfaces[0].bodies.material.name) != 0)
            return false;
    return true;
}

static void decide(struct plan *plan, enum effect effect, const struct scene *scene)
{
    const struct effect_row *row = &effect_rows[effect];
    struct plan_effect *out = &plan->effects[effect];
    const struct lack lack = find_lack(row, scene);
    unsigned lacking = row->needs_effects & ~plan->running;
    if (effect == EFFECT_CONVERGENCE && !plan_stacks_scales(plan)) {
        snprintf(out->reason, sizeof out->reason, "a question to the multiscale models, which do not run");
    } else if (effect == EFFECT_DIRECT) { /* seconds where the rest takes milliseconds: never unasked */
        out->runs = scene->direct.called;
    } else if (row->only_listed && !(scene->effects & EFFECT_BIT(effect))) {
        snprintf(out->reason, sizeof out->reason, "runs only where effects lists it");
    } else if (row->only_listed) {
        const struct model_row *leading = model_rows[plan_leading_model(plan)];
        out->runs = leading->plastic;
        snprintf(out->reason, sizeof out->reason,
                 leading->plastic ? "listed in the scene" : "%s, which leads, has no hardness", leading->label);
    } else if (row->key && !(scene->called & EFFECT_BIT(effect))) {
        snprintf(out->reason, sizeof out->reason, "the scene has no '%s'", row->key);
    } else if (row->key && !scene->effects_auto) {
        out->runs = true;
        snprintf(out->reason, sizeof out->reason, "the scene has '%s'", row->key);
    } else if (!scene->effects_auto) {
        out->runs = scene->effects & EFFECT_BIT(effect);
        snprintf(out->reason, sizeof out->reason, out->runs ? "listed in the scene" : "not listed in the scene");
    } else if (lack.property) {
        say_lack(out, &lack);
    } else if (lacking) {
        snprintf(out->reason, sizeof out->reason, "builds on an effect that does not run");
    } else {
        out->runs = true;
        const char *key = row->properties[0];
        const struct scene_bodies *bodies = bodies_of(scene, 0);
        struct material_pair pair = scene_pair(bodies);
        if (row->key)
            snprintf(out->reason, sizeof out->reason, "the scene has '%s'", row->key);
        else if (key && same_bodies(scene))
            snprintf(out->reason, sizeof out->reason, "the material gives what it needs: %s %.4g %s",
                     material_property_find(key)->name, material_value(&bodies->material, material_property_find(key)),
                     material_property_find(key)->unit);
        else if (key)
            snprintf(out->reason, sizeof out->reason, "every surface's material gives what it needs: %s",
                     material_property_find(key)->name);
        else if (pair.unknown)
            snprintf(out->reason, sizeof out->reason, "needs no material");
        else if (same_bodies(scene))
            snprintf(out->reason, sizeof out->reason, "needs E' alone: %.4g Pa", pair.effective_modulus_Pa);
        else
            snprintf(out->reason, sizeof out->reason, "needs E' alone, which every surface's material gives");
    }
    if (out->runs)
        plan->running |= EFFECT_BIT(effect);
}

void plan_make(struct plan *out, const struct scene *scene)
{
    *out = (struct plan){
        .models = scene->models,
        .all_uncertain = !scene->effects_auto,
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

unsigned plan_quantities(const struct plan *plan)
{
    unsigned computed = 0;
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(plan, m))
            computed |= quantity_with_made(model_rows[m]->quantities);
    return computed & plan->wanted;
}

bool plan_stacks_scales(const struct plan *plan)
{
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(plan, m) && model_rows[m]->stacks_scales)
            return true;
    return false;
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
        if (plan_runs_model(plan, m) && model_rows[m]->precedence > most) {
            most = model_rows[m]->precedence;
            leading = m;
        }
    return leading;
}
