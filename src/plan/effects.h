/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `effects: auto` runs only effects that can matter on some surface, judged by cheap bounds on what each could change.
 */
#ifndef PLAN_EFFECTS_H
#define PLAN_EFFECTS_H

#include "members/surface.h"

/** Finds the bounds of a surface for an `auto` scene: pressure in the spots over hardness, up to nearly full contact
 * and for any height distribution; and what scale dependence adds to TCR at the first and the last load. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code effects_bound(struct surface_record *record, const struct surface_task *asked,
                                          struct status *status);

/** First effects_fit_models(). Then takes effects out of an `auto` plan that none of the `count` surfaces needs, and
 * records the reason with its number. Effects that the scene lists stay. */
void effects_decide(struct plan *plan, const struct scene *scene, const struct surface_record *surfaces, size_t count);
/** Takes models out of a plan, or to the side, that cannot answer for all of these surfaces: strips, direct solutions
 * of maps. */
void effects_fit_models(struct plan *plan, const struct surface_record *surfaces, size_t count);

#endif
