/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which effects a surface calls for: `effects: auto` runs only what can matter on it, by cheap bounds on what each
 * effect could change; and what the surfaces of a run called for together, with what that took. */
#ifndef PLAN_EFFECTS_H
#define PLAN_EFFECTS_H

#include "members/surface.h"

/** Fills the bounds of a described surface, for an `auto` scene: what its spots bear, over the hardness, up to nearly
 * full contact and whatever its heights; and what scale dependence adds to TCR at the first and the last load. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code effects_bound(struct surface_record *record, const struct surface_task *asked,
                                          struct status *status);

/** Takes the effects out of an `auto` plan that no usable one of the `count` surfaces of a run calls for, and gives
 * every effect its reason with the number that decided. A plan from a list of effects keeps what was listed. Its models
 * are fitted to them first. */
void effects_decide(struct plan *plan, const struct scene *scene, const struct surface_record *surfaces, size_t count);
/** Takes the models out of a plan, or beside the others, that have no answer on all of these surfaces (one, or all of a
 * run): strips, direct solutions of maps. */
void effects_fit_models(struct plan *plan, const struct surface_record *surfaces, size_t count);

#endif
