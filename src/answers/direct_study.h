/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The models compared with a direct solution of the contact on the same surface.
 *
 * A map is solved as it is, mirrored if it is not periodic. For a profile, isotropic surfaces are made whose rows
 * follow the matched power law, with the scan's height distribution, or Gaussian if that is nearly so. The models get
 * the spectrum of those rows, so that differences are the models' errors, and not what the scan leaves unknown. */
#ifndef ANSWERS_DIRECT_STUDY_H
#define ANSWERS_DIRECT_STUDY_H

#include "direct/direct_ensemble.h"
#include "members/surface.h"
#include "plan/direct_plan.h"
#include <stdatomic.h>

/** Direct solutions of one kind. */
enum direct_study_kind {
    DIRECT_STUDY_ELASTIC,
    DIRECT_STUDY_CAPPED, /* with a hardness, at loads below it */
    DIRECT_STUDY_KINDS
};

struct direct_study_curve {
    struct direct_ensemble_point *points; /* one a load; NULL: not solved */
    size_t loads, seeds;
};

/** Of one surface. Owned: direct_study_free(). */
struct direct_study {
    size_t surface; /* its index */
    struct direct_plan plan;
    struct direct_study_curve curves[DIRECT_STUDY_KINDS];
    struct spectrum rows;       /* of the surfaces solved */
    struct model_curve *models; /* model_count of them; NULL: not run */
    uint64_t solutions;         /* number of contacts solved */
};

/** Plans the direct solution of a surface, with its matched law, into summary.direct. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code direct_study_plan(struct surface_record *record, const struct surface_task *asked,
                                              struct status *status);

/** What is solved. */
struct direct_study_task {
    const struct surface_record *surface; /* has been read, with its direct_m; its plan is possible */
    size_t index;
    struct surface_task asked; /* except its loads, which are the plan's */
    void (*progress)(void *context, double done,
                     double all); /* called with the work done, from several threads; NULL: not */
    void *progress_context;
};

/** Solves, and runs the models on the same surface. Errors: STATUS_MODEL without convergence, STATUS_SCAN for an
 * unusable map, STATUS_INTERRUPTED, STATUS_MEMORY. */
MUST_CHECK enum status_code direct_study_run(struct direct_study *out, const struct direct_study_task *task,
                                             struct status *status);
void direct_study_free(struct direct_study *study);

/** The heights of the surface solved: "map", "scan" or "gaussian". */
const char *direct_study_heights(const struct direct_study *study);
/** A quantity at load `i` by one kind of direct solution, SI, NaN: not solved. l the constriction length: mean gap, ECR
 * A_n = (rho1 + rho2) l, TCR A_n = (1/k1 + 1/k2) l, elastic stiffness E'/(2 l). *error (NULL: not wanted): standard
 * error over the surfaces, NaN for a single one; for a map as in direct_ensemble.h. */
double direct_study_value(const struct direct_study *study, const struct material_pair *pair,
                          enum direct_study_kind kind, enum quantity quantity, size_t i, double *error);
/** Relative difference of fine and coarse grid there, which the value is corrected for; 0: none. */
double direct_study_grid_error(const struct direct_study *study, enum direct_study_kind kind, enum quantity quantity,
                               size_t i);
/** The solution a model is compared with: with hardness for plastic models, if it is there, else elastic. */
enum direct_study_kind direct_study_kind_of(const struct direct_study *study, size_t model);
/** Model over direct solution; NaN where either has no value. */
double direct_study_ratio(const struct direct_study *study, const struct material_pair *pair, size_t model,
                          enum quantity quantity, size_t i);
/** Distance of a model from the direct solution over all loads: exp of the mean |ln ratio|, and the least and largest
 * ratio. loads 0: nothing to compare. */
struct direct_study_distance {
    size_t loads;
    double mean_factor, least, most;
};
struct direct_study_distance direct_study_distance(const struct direct_study *study, const struct material_pair *pair,
                                                   size_t model, enum quantity quantity);
/** The model nearest to the elastic direct solution in a quantity; model_count: none. */
size_t direct_study_nearest(const struct direct_study *study, const struct material_pair *pair, enum quantity quantity);

#endif
