/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What was done, effect by effect, and the time that it took. */
#ifndef RESULTS_WORK_H
#define RESULTS_WORK_H

#include "members/surface.h"

/** One row of the account: an effect, or the base that always runs (the elastic models' area). */
struct work_row {
    const char *name;
    bool runs;
    const char *reason;
    const char *changes;  /* of the numbers, as a plan says it; "": the reason does */
    uint64_t evaluations; /* done because of it: visits of scales, asperity laws, loads solved, contacts; 0: none of its
                             own */
    double seconds;       /* that these took, all threads together */
};
enum { WORK_ROWS = EFFECT_COUNT + 1 };

/** What the convergence study and the direct solutions took, which are no single surface's. */
struct work_studies {
    uint64_t sweep_scales, contacts;
    double sweep_seconds, contact_seconds;
};

struct results;

/** The account of a plan: the base first, then the effects. Before a run the studies are zero, and so is all that was
 * done. */
void work_account(struct work_row rows[WORK_ROWS], const struct results *results);

/** The plan as a table for a terminal: effect, run or skipped, why, what it would change; with what was done and the
 * time it took when `done`. Returns the evaluations, of all effects. */
uint64_t work_table(struct text *out, const struct results *results, bool done);

/** Roughly how long a report on these described surfaces takes on `threads` threads [s], from counts: points, loads,
 * models, simulated records; and direct solutions. */
double work_seconds(const struct results *results, size_t threads);

#endif
