/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which effects run and why (docs/scene.md, `effects`): decided once, before any model runs. */
#ifndef SCENE_PLAN_H
#define SCENE_PLAN_H

#include "base/words.h"
#include "scene/scene.h"

struct plan {
    const char *reasons[EFFECT_COUNT]; /* why each effect runs or does not */
    unsigned running;                  /* EFFECT_BITs of those that run */
    unsigned wanted;                   /* QUANTITY_BITs that the running effects call for */
    uint64_t models;                   /* MODEL_BITs asked for; a plastic one runs only with plasticity */
    uint64_t beside;                   /* those with answers for some surfaces only: they do not lead */
    bool all_uncertain;                /* uncertainty was listed: for all models; else for the leading one */
    size_t operating_place;            /* as in struct model_task */
    const char *area_reason;           /* why the area is computed as it is, for the account */
    struct words *words;               /* for the reasons; NULL: none are given */
};

/** Listed effects run (the scene was checked); with `auto`, those that the given properties allow. */
void plan_make(struct plan *out, const struct scene *scene, struct words *words);

/** Sets scene->models to the cheapest model whose 95 % error (docs/validation.md) is within scene->accuracy, and the
 * elastic model that it is based on. Strips cost most; at equal cost the better model, and if none is good enough the
 * best. */
void plan_choose_model(struct scene *scene);

/** Does `effect` run? */
bool plan_runs(const struct plan *plan, enum effect effect);
/** Puts an effect into the plan, or takes it and its quantities out, with the reason. */
void plan_decide(struct plan *plan, enum effect effect, bool runs, const char *reason);

/** Does model `m` of the table run? */
bool plan_runs_model(const struct plan *plan, size_t m);
/** MODEL_BITs of all that run. */
uint64_t plan_running_models(const struct plan *plan);
/** The model of the summary: of those that may lead, the one of the greatest precedence. */
size_t plan_leading_model(const struct plan *plan);
/** QUANTITY_BITs that the effects call for and a running model computes. */
unsigned plan_quantities(const struct plan *plan);
/** Does a model of asperities run? */
bool plan_uses_asperities(const struct plan *plan);

#endif
