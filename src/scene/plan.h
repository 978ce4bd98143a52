/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which effects run and why (docs/scene.md, `effects`). Decided once, before any model. */
#ifndef SCENE_PLAN_H
#define SCENE_PLAN_H

#include "base/words.h"
#include "scene/scene.h"

struct plan_effect {
    bool runs;
    const char *reason;
};

struct plan {
    struct plan_effect effects[EFFECT_COUNT];
    unsigned running;        /* EFFECT_BITs of those that run */
    unsigned wanted;         /* QUANTITY_BITs that follow */
    uint64_t models;         /* MODEL_BITs asked for; a plastic one runs only with plasticity */
    uint64_t beside;         /* those that some surfaces alone have an answer by: they do not lead */
    bool all_uncertain;      /* the effect uncertainty was listed: of all models; else of the leading one alone */
    size_t operating_place;  /* as in struct model_task */
    const char *area_reason; /* why the area is computed as it is, for the account */
    struct words *words;     /* that reasons are said in; NULL: they are not */
};

/** Listed effects run (the scene was checked); with `auto` an effect runs where the given properties allow it. */
void plan_make(struct plan *out, const struct scene *scene, struct words *words);

/** Leaves in scene->models the cheapest one whose answers lie within scene->accuracy 95 times of 100, with the elastic
 * one that it yields from: by docs/validation.md for so many scans, metal that yields or not. Dearer is what solves
 * strips; of those that cost the same the better. Where none is as good the best. */
void plan_choose_model(struct scene *scene);

/** Does `effect` run? */
bool plan_runs(const struct plan *plan, enum effect effect);
/** Puts an effect into the plan, or takes it and the quantities that belong to it out again, and says why. */
void plan_decide(struct plan *plan, enum effect effect, bool runs, const char *reason);

/** Does model `m` of the table run? */
bool plan_runs_model(const struct plan *plan, size_t m);
/** MODEL_BITs of all that run. */
uint64_t plan_running_models(const struct plan *plan);
/** The model that the summary speaks of: of those that may lead the one of the greatest precedence. */
size_t plan_leading_model(const struct plan *plan);
/** QUANTITY_BITs that the effects call for and some running model computes. */
unsigned plan_quantities(const struct plan *plan);
/** Does a model run that works on asperities? */
bool plan_uses_asperities(const struct plan *plan);

#endif
