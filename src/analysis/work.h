/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How much was, or will be, evaluated. Predicted from the scene and the scans before any model runs, counted while they
 * run: the two agree exactly, because a model's work is fixed by what it is asked. How far down its stack of scales a
 * load gets is told by the areas alone; what simulated records take is counted as on the scan they are made of. */
#ifndef ANALYSIS_WORK_H
#define ANALYSIS_WORK_H

#include "analysis/surface.h"

struct work {
    struct model_work elastic, plastic;    /* of all surfaces in the models without and with yielding */
    uint64_t sweep_scales;                 /* scales of the synthetic spectra of the convergence study */
    uint64_t extensions;                   /* fitted power laws carried on below the sampling limit */
    uint64_t bounds;                       /* scales visited to decide on scale dependence */
    struct uncertainty_work simulated;     /* records in place of scans that are not there */
    uint64_t contacts;                     /* solved directly */
    double contact_seconds, contact_bytes; /* likely for those, on one core, and most at once */
};

/** One row of the plan: an effect, or the base that always runs (the elastic models' area). */
struct work_row {
    const char *name;
    bool runs;
    const char *reason;
    char method[200];     /* how its numbers come about */
    uint64_t evaluations; /* that are there because of it; what effects share counts at the first of them that runs */
    double seconds;       /* likely, on one core */
    double bytes;         /* of arrays that only this effect needs; the others share those of the area */
};
enum { WORK_ROWS = EFFECT_COUNT + 1 };

/** Work of all usable ones of `count` described surfaces, for a bounded plan. */
struct work work_predict(const struct surface_summary *surfaces, size_t count, const struct scene *scene,
                         const struct plan *plan);
/** The part of it that model `m` takes on one usable surface. */
struct model_work work_of_model(const struct surface_summary *surface, size_t m, const struct scene *scene,
                                const struct plan *plan);
/** Its likely seconds on one core. */
double work_seconds(const struct model_work *work);
/** What simulating the single scans of the surfaces will take (uncertainty.h). */
struct uncertainty_work work_simulated(const struct surface_summary *surfaces, size_t count, const struct plan *plan);
/** Its evaluations, heights and answers of the models, and their likely seconds on one core. */
uint64_t work_uncertainty(const struct uncertainty_work *work, double *seconds);
/** Work that was done: by the `models`, whose sum it is; `sweep_scales` is what the convergence study counted. */
struct work work_done(const struct work *models, const struct surface_summary *surfaces, size_t count,
                      uint64_t sweep_scales);
/** Adds what model `m` takes or took besides. */
void work_add(struct work *work, size_t m, const struct model_work *more);
/** Evaluations of all rows of the plan, and their likely seconds on one core. */
uint64_t work_total(const struct work *work, const struct plan *plan, double *seconds);

/** The table of the plan: WORK_ROWS rows, the base first, then the effects. */
void work_table(struct work_row rows[WORK_ROWS], const struct work *work, const struct plan *plan);

/** Bytes that a run is likely to need at its largest: one scan a thread, and a summary a surface. */
double work_memory(const struct surface_summary *surfaces, size_t count, unsigned jobs);

#endif
