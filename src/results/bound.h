/* Cheap bounds on what an effect could change on a surface: `effects: auto` runs only what can matter. */
#ifndef RESULTS_BOUND_H
#define RESULTS_BOUND_H

#include "results/surface.h"

/** Fills the bounds of a described surface, for an `auto` scene, over all the numbers it reports. Not all of them lie
 * between the first and the last of `loads`: the load of full contact and that of no gap, what is left of the gap
 * there, beta and with it the adjusted separation at any load, the law carried on below the sampling limit (at the
 * convergence study's load), and the same of scans run alone. So whether plasticity matters is asked up to full
 * contact:
 *  - yield: p_c/p* of the steepest scale. Below 1 it yields before it is complete, which moves the load of full
 * contact; else no scale yields at any load.
 *  - jg_excess: the asperities pressed beyond 1.9 omega_c at GW's full contact, times what they can change.
 *  - scale_dependent: TCR_sd/TCR - 1, solved at so many of the loads that a bound on the others decides (multiscale);
 *    (8/3pi) lambda_mfp over the mean contact radius at the lowest load (statistical).
 *  - settled: gamma >= 1 and the nominal pressure alone is at least p* at the sampling limit.
 * Error: STATUS_MEMORY. */
MUST_CHECK enum status_code bound_surface(struct surface_record *record, const struct scene *scene,
                                          const struct plan *plan, const double *loads, size_t load_count,
                                          struct status *status);

struct spool;

/** Takes the effects out of an `auto` plan that no usable surface calls for, and gives every effect its reason with the
 * number that decided. A plan from a list of effects keeps what was listed. */
void bound_plan(struct plan *plan, const struct scene *scene, const struct spool *spool);

#endif
