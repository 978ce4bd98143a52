/* Cheap bounds on what an effect could change on a surface: `effects: auto` runs only what can matter. */
#ifndef ANALYSIS_EFFECT_BOUNDS_H
#define ANALYSIS_EFFECT_BOUNDS_H

#include "analysis/surface.h"

/** Fills the bounds of a described surface for loads between the first and the last of `loads`.
 *  - yield: a scale sees at most max(P, p* of the longer scales), because the elastic area ratio is at least p/p*, so
 *    that p_{i+1} = p_i/a_i <= max(p_i, p*_i); held against p_c of each scale.
 *  - jg_excess: the share of the area on asperities pressed beyond 1.9 omega_c at the highest load, times what they
 *    could gain there.
 *  - scale_dependent: (8/3pi) lambda_mfp over the smallest mean contact radius, at the lowest load.
 *  - settled: gamma >= 1 and the nominal pressure alone is at least p* at the sampling limit. */
void effect_bounds_surface(struct surface_record *record, const struct scene *scene, const struct plan *plan,
                           const double *loads, size_t load_count);

/** Takes the effects out of an `auto` plan that no usable one of `count` surfaces calls for, and gives every effect its
 * reason with the number that decided. A plan from a list of effects keeps what was listed. */
void effect_bounds_plan(struct plan *plan, const struct scene *scene, const struct surface_summary *surfaces,
                        size_t count);

#endif
