/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/plan.h"

#include <math.h>
#include <stddef.h>

void plan_decide(struct plan *plan, enum effect effect, bool runs, const char *reason)
{
    plan->reasons[effect] = reason;
    plan->running = runs ? plan->running | EFFECT_BIT(effect) : plan->running & ~EFFECT_BIT(effect);
    plan->wanted = quantity_wanted(plan->running);
}

/** Says what an effect lacks to run on every surface, and on which; NULL: nothing. */
static const char *say_lack(const struct plan *plan, enum effect effect, const struct scene *scene)
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
        return NULL;
    if (lacking < count) /* escaped where the reason is written */
        return words_say(plan->words, "effect.surface_lacks\nproperty %s\nsurface\t%s", property->name,
                         scene->surfaces[first].name);
    bool none = isnan(scene_bodies_of(scene, 0)->material.youngs_modulus_Pa);
    return words_say(plan->words, "%s\nproperty %s", none ? "effect.no_material" : "effect.material_lacks",
                     property->name);
}

static void decide(struct plan *plan, enum effect effect, const struct scene *scene)
{
    const struct effect_row *row = &effect_rows[effect];
    const bool listed = scene->effects & EFFECT_BIT(effect);
    const char *key = effect == EFFECT_CONVERGENCE ? "convergence" : row->key;
    bool runs = false;
    const char *why, *lack = NULL;
    if (effect == EFFECT_CONVERGENCE &&
        !(plan_running_models(plan) & model_flagged(offsetof(struct model_row, stacks_scales)))) {
        why = "effect.no_model";
    } else if (effect == EFFECT_DIRECT) { /* seconds where the rest takes milliseconds: never unasked */
        runs = scene->direct.called;
        why = "effect.direct";
    } else if (row->only_listed && !listed) {
        why = "effect.only_listed";
    } else if (effect == EFFECT_CONVERGENCE && scene->effects_auto && !listed && !scene->convergence.given) {
        why = "effect.no_key"; /* its sweeps are of made-up surfaces: never unasked */
    } else if (row->key && !(scene->called & EFFECT_BIT(effect))) {
        why = "effect.no_key";
    } else if (!scene->effects_auto) {
        runs = row->key || listed;
        why = row->key ? "effect.key" : listed ? "effect.listed" : "effect.not_listed";
    } else if ((lack = say_lack(plan, effect, scene)) || (row->needs_effects & ~plan->running)) {
        why = "effect.needs_effect";
    } else {
        runs = true;
        why = listed               ? "effect.listed"
              : key                ? "effect.key"
              : row->properties[0] ? "effect.material"
                                   : "effect.needs_none";
    }
    plan_decide(plan, effect, runs, lack ? lack : words_say(plan->words, "%s\nkey %s", why, key ? key : ""));
}

void plan_make(struct plan *out, const struct scene *scene, struct words *words)
{
    *out = (struct plan){
        .models = scene->models,
        .all_uncertain = scene->effects & EFFECT_BIT(EFFECT_UNCERTAINTY),
        .area_reason = words_say(words, "area.always"),
        .words = words,
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
    bool uses = false;
    for (size_t m = 0; m < model_count; m++)
        uses = uses || (plan_runs_model(plan, m) && model_rows[m]->sums_asperities);
    return uses;
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

/** Models by cost: a closed form of moments, a sum over the spectrum, strips of the scans. */
static int cost_rank(const struct model_row *row)
{
    return row->uses_strip ? 2 : row->textbook ? 0 : 1;
}

void plan_choose_model(struct scene *scene)
{
    struct plan plan;
    plan_make(&plan, scene, NULL);
    const bool hard = plan_runs(&plan, EFFECT_PLASTICITY);
    const enum quantity asked =
        scene->target_count > 0 ? scene->targets[0].quantity : quantity_first(plan_quantities(&plan));
    size_t chosen = model_count;
    bool met = false;
    for (size_t m = 0; m < model_count; m++) {
        const struct model_row *row = model_rows[m], *before = chosen < model_count ? model_rows[chosen] : NULL;
        const double sd = plan_runs_model(&plan, m) && row->plastic == hard ? model_sd(row, asked, false) : 0;
        const bool good = model_factor(sd) - 1 <= scene->accuracy;
        if (!(sd > 0) || (met && !good))
            continue;
        const int dearer = before && good ? cost_rank(row) - cost_rank(before) : 0;
        if (!before || (good && !met) || dearer < 0 || (dearer == 0 && sd < scene->chosen_sd)) {
            chosen = m;
            scene->chosen_sd = sd;
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
