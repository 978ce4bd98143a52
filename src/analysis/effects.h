/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which effects a surface calls for: `effects: auto` runs only what can matter on it, by cheap bounds on what each
 * effect could change; and what the surfaces of a run called for together, with what that took. */
#ifndef ANALYSIS_EFFECTS_H
#define ANALYSIS_EFFECTS_H

#include "analysis/surface.h"

/** Fills the bounds of a described surface, for an `auto` scene: what its spots bear, over the hardness, up to nearly
 * full contact and whatever its heights; and what scale dependence adds to TCR at the first and the last load. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code effects_bound(struct surface_record *record, const struct surface_task *asked,
                                          struct status *status);

/** Takes the effects out of an `auto` plan that no usable one of the `count` surfaces of a run calls for, and gives
 * every effect its reason with the number that decided. A plan from a list of effects keeps what was listed. */
void effects_decide(struct plan *plan, const struct scene *scene, const struct surface_record *surfaces, size_t count);
/** Takes the models out of a plan, or beside the others, that have no answer on all of these surfaces (one, or all of a
 * run): strips, direct solutions of maps. */
void effects_fit_models(struct plan *plan, const struct surface_record *surfaces, size_t count);

/** One row of the account: an effect, or the base that always runs (the elastic models' area). */
struct effects_row {
    const char *name;
    bool runs;
    const char *reason;
    uint64_t evaluations; /* done because of it: visits of scales, asperity laws, loads solved, contacts; 0: none of its
                             own */
    double seconds;       /* that these took, all threads together */
};
enum { EFFECTS_ROWS = EFFECT_COUNT + 1 };

/** What the convergence study and the direct solutions took, which are no single surface's. */
struct effects_studies {
    uint64_t sweep_scales, contacts;
    double sweep_seconds, contact_seconds;
};

/** The account of a plan: the base first, then the effects. Before a run `studies` is zero, and so is all that was
 * done. */
void effects_account(struct effects_row rows[EFFECTS_ROWS], const struct plan *plan,
                     const struct surface_record *surfaces, size_t count, const struct effects_studies *studies);

/** Roughly how long a report on these described surfaces takes on `threads` threads [s], from counts: points, loads,
 * models, simulated records; and direct solutions, which take direct_seconds of one core. */
double effects_rough_seconds(const struct plan *plan, const struct surface_record *surfaces, size_t count,
                             size_t load_count, double direct_seconds, size_t threads);

#endif
