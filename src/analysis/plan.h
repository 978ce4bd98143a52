/* Which effects run and why (contract: "effects: auto"). Decided once, before any model. */
#ifndef ANALYSIS_PLAN_H
#define ANALYSIS_PLAN_H

#include "scene/scene.h"

struct plan_effect {
    bool runs;
    char reason[160];
};

struct plan {
    struct plan_effect effects[EFFECT_COUNT];
    unsigned running;  /* EFFECT_BITs of those that run */
    unsigned wanted;   /* enum contact_quantity bits that follow */
    unsigned families; /* enum scene_model bits */
    struct material_pair pair;
};

/** Listed effects run (the scene was checked); with `auto` an effect runs where the given properties allow it. */
void plan_make(struct plan *out, const struct scene *scene);

/** Does `effect` run? */
bool plan_runs(const struct plan *plan, enum effect effect);

#endif
