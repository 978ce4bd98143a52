/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One surface from its scans to its answers: the pipeline scan -> profile -> spectrum -> description -> curves ->
 * summary. */
#ifndef ANALYSIS_EVALUATE_H
#define ANALYSIS_EVALUATE_H

#include "analysis/surface.h"

/** What is done with a surface. */
struct evaluate_task {
    const struct scene *scene;
    const struct scene_surface *surface;
    const struct surface_record *counterface; /* described; NULL: smooth */
    const struct plan *plan;                  /* of the effects that the scene allows */
    const double *loads;                      /* P/(A_n E') of its own bodies */
    size_t load_count;
    const atomic_bool *stop; /* becomes true when the work is to end early; NULL: never */
    bool describe_only;      /* no model runs */
    bool described;          /* `out` is described already, not zeroed */
    bool keep_scans;         /* measured loads will be answered on each */
};

/** One surface from its scans to its answers: read and described, its effects decided, the models run. What is wrong
 * with its files is no error: then summary.usable is false and summary.refusal says why in one line. Error:
 * STATUS_MEMORY. `out` is zeroed; owned: surface_record_free() whatever comes back. */
MUST_CHECK enum status_code evaluate_surface(struct surface_record *out, const struct evaluate_task *task,
                                             struct status *status);

/** Runs the models that `plan` calls for on a described surface, one after another. Errors: STATUS_INTERRUPTED,
 * STATUS_MEMORY. */
MUST_CHECK enum status_code evaluate_models(struct surface_record *record, const struct scene *scene,
                                            const struct plan *plan, const double *loads, size_t load_count,
                                            const atomic_bool *stop, struct status *status);
#endif
