/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cheap bounds on what an effect could change on a surface: `effects: auto` runs only what can matter. */
#ifndef ANALYSIS_EFFECT_BOUNDS_H
#define ANALYSIS_EFFECT_BOUNDS_H

#include "analysis/surface.h"

/** Fills the bounds of a described surface, for an `auto` scene, over all the numbers it reports. Not all of them lie
 * between the first and the last of `loads`: the load of full contact and that of no gap, what is left of the gap
 * there, beta and with it the adjusted separation at any load, the power law carried on below the sampling limit (at
 * the convergence study's load), and the same of scans run alone. So each model bounds what yielding can change up to
 * full contact, and scale dependence over the loads; a surface has converged when gamma >= 1 and the nominal pressure
 * alone is at least p* at the sampling limit. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code effect_bounds_surface(struct surface_record *record, const struct scene *scene,
                                                  const struct plan *plan, const double *loads, size_t load_count,
                                                  struct status *status);

/** Takes the effects out of an `auto` plan that no usable one of `count` surfaces calls for, and gives every effect its
 * reason with the number that decided. A plan from a list of effects keeps what was listed. */
void effect_bounds_plan(struct plan *plan, const struct scene *scene, const struct surface_summary *surfaces,
                        size_t count);

/** Takes the models that use heights out of a plan whose scene names no models, when every usable surface is Gaussian.
 */
void effect_bounds_heights(struct plan *plan, const struct scene *scene, const struct surface_summary *surfaces,
                           size_t count);

#endif
