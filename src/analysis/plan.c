#include "analysis/plan.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const struct material_property *property_find(const char *key)
{
    for (size_t i = 0; i < material_property_count; i++)
        if (strcmp(material_properties[i].key, key) == 0)
            return &material_properties[i];
    return NULL;
}

/** The first property of `row` that one of the bodies lacks, NULL when all are given. */
static const char *missing_property(const struct effect_row *row, const struct scene *scene)
{
    for (size_t i = 0; row->properties[i]; i++) {
        const struct material_property *property = property_find(row->properties[i]);
        bool other = scene->counterface_kind == MATERIAL_COUNTERFACE_ELASTIC;
        if (isnan(material_value(&scene->material, property)) ||
            (other && isnan(material_value(&scene->counterface, property))))
            return row->properties[i];
    }
    return NULL;
}

static void decide(struct plan *plan, enum effect effect, const struct scene *scene)
{
    const struct effect_row *row = &effect_rows[effect];
    struct plan_effect *out = &plan->effects[effect];
    const char *missing = missing_property(row, scene);
    unsigned lacking = row->needs_effects & ~plan->running;
    if (effect == EFFECT_CONVERGENCE && !plan_stacks_scales(plan)) {
        snprintf(out->reason, sizeof out->reason, "a question to the multiscale models, which do not run");
    } else if (!scene->effects_auto) {
        out->runs = scene->effects & EFFECT_BIT(effect);
        snprintf(out->reason, sizeof out->reason, out->runs ? "listed in the scene" : "not listed in the scene");
    } else if (missing) {
        snprintf(out->reason, sizeof out->reason, "the material has no %s", missing);
    } else if (lacking) {
        snprintf(out->reason, sizeof out->reason, "builds on an effect that does not run");
    } else {
        out->runs = true;
        const char *key = row->properties[0];
        if (key)
            snprintf(out->reason, sizeof out->reason, "the material gives what it needs: %s %.4g", key,
                     material_value(&scene->material, property_find(key)));
        else
            snprintf(out->reason, sizeof out->reason, "needs E' alone: %.4g Pa", plan->pair.effective_modulus_Pa);
    }
    if (out->runs)
        plan->running |= EFFECT_BIT(effect);
}

void plan_make(struct plan *out, const struct scene *scene)
{
    *out = (struct plan){
        .models = scene->models,
        .all_uncertain = !scene->effects_auto,
        .pair = material_pair(&scene->material, scene->counterface_kind, &scene->counterface),
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
            computed |= model_rows[m]->quantities;
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

bool plan_beyond_thesis(const struct plan *plan)
{
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(plan, m) && model_rows[m]->thesis_place == 0)
            return true;
    return false;
}
