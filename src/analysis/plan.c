#include "analysis/plan.h"

#include "contact/point.h"

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
    if (effect == EFFECT_CONVERGENCE && !(scene->models & SCENE_MODEL_MULTISCALE)) {
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
    static const unsigned quantity[EFFECT_COUNT] = {
        [EFFECT_SEPARATION] = CONTACT_SEPARATION,
        [EFFECT_ELECTRICAL] = CONTACT_ELECTRICAL,
        [EFFECT_THERMAL] = CONTACT_THERMAL,
        [EFFECT_SCALE_DEPENDENT] = CONTACT_SCALE_DEPENDENT,
    };
    *out = (struct plan){
        .families = scene->models,
        .pair = material_pair(&scene->material, scene->counterface_kind, &scene->counterface),
    };
    for (int e = 0; e < EFFECT_COUNT; e++) {
        decide(out, (enum effect)e, scene);
        if (out->effects[e].runs)
            out->wanted |= quantity[e];
    }
}

bool plan_runs(const struct plan *plan, enum effect effect)
{
    return plan->running & EFFECT_BIT(effect);
}
