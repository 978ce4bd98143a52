/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The models against a direct solution of the contact, on one and the same surface.
 *
 * A map is solved as it is, mirrored if it does not close on itself. For a profile, isotropic surfaces are made whose
 * rows have the matched power law and whose heights are distributed like the scan's, or are Gaussian where the scan's
 * nearly are. The models are given the spectrum of those surfaces' rows, so that what differs is the models' error and
 * not what a scan leaves open about its surface. */
#ifndef ANSWERS_DIRECT_STUDY_H
#define ANSWERS_DIRECT_STUDY_H

#include "direct/direct_ensemble.h"
#include "members/surface.h"
#include "plan/direct_plan.h"
#include <stdatomic.h>

/** Direct solutions of one kind. */
enum direct_study_kind {
    DIRECT_STUDY_ELASTIC,
    DIRECT_STUDY_CAPPED, /* with a hardness, at the loads below it */
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
    struct spectrum rows;       /* of the surface solved */
    struct model_curve *models; /* model_count of them; NULL: not run */
    uint64_t solutions;         /* contacts solved, as planned */
};

/** How a described surface's contact will be solved, with the law matched: into summary.direct. Error: STATUS_MEMORY.
 */
MUST_CHECK enum status_code direct_study_plan(struct surface_record *record, const struct surface_task *asked,
                                              struct status *status);

/** What is solved. */
struct direct_study_task {
    const struct surface_record *surface; /* described, with its direct_m; its plan is possible */
    size_t index;
    struct surface_task asked;                                /* but its loads: those of the plan are solved */
    void (*progress)(void *context, double done, double all); /* told of work done, from several threads; NULL: not */
    void *progress_context;
};

/** Solves, and runs the models on the same surface. Errors: STATUS_MODEL where the solution does not converge,
 * STATUS_SCAN of a map that cannot be used, STATUS_INTERRUPTED, STATUS_MEMORY. */
MUST_CHECK enum status_code direct_study_run(struct direct_study *out, const struct direct_study_task *task,
                                             struct status *status);
void direct_study_free(struct direct_study *study);

/** Whose heights they are: "map", "scan" or "gaussian". */
const char *direct_study_heights(const struct direct_study *study);
/** A quantity at load `i` by one kind of direct solution, SI, NaN where there is none: the mean gap, ECR A_n =
 * (rho1 + rho2) l, TCR A_n = (1/k1 + 1/k2) l, elastic stiffness
 * E'/(2 l). *error (NULL: not wanted): standard error over the surfaces, NaN from
 * one; of a map as in direct_ensemble.h. */
double direct_study_value(const struct direct_study *study, const struct material_pair *pair,
                          enum direct_study_kind kind, enum quantity quantity, size_t i, double *error);
/** The share by which the fine grid differs from the coarse one there, which the value has been corrected by; 0: none.
 */
double direct_study_grid_error(const struct direct_study *study, enum direct_study_kind kind, enum quantity quantity,
                               size_t i);
/** What a model is held against: with a hardness where it yields and that is solved, else elastic. */
enum direct_study_kind direct_study_kind_of(const struct direct_study *study, size_t model);
/** Model over direct solution; NaN where either has no number. */
double direct_study_ratio(const struct direct_study *study, const struct material_pair *pair, size_t model,
                          enum quantity quantity, size_t i);
/** How far a model is from the direct solution over all loads: exp of the mean |ln ratio|, and the extremes of the
 * ratio. loads 0: nowhere comparable. */
struct direct_study_distance {
    size_t loads;
    double mean_factor, least, most;
};
struct direct_study_distance direct_study_distance(const struct direct_study *study, const struct material_pair *pair,
                                                   size_t model, enum quantity quantity);
/** The model that is nearest in a quantity; model_count: none. */
size_t direct_study_nearest(const struct direct_study *study, const struct material_pair *pair, enum quantity quantity);

#endif
