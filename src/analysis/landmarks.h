/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where a curve bends and where a model's validity ends, to the tolerance of a run: not read off its list of loads. */
#ifndef ANALYSIS_LANDMARKS_H
#define ANALYSIS_LANDMARKS_H

#include "analysis/curve_summary.h"

/** The curve that is searched: fills `out` (points: count + 1 long) at `count` ascending loads P/(A_n E'), area and ECR
 * at least. Error: STATUS_MEMORY. */
struct landmarks_curve {
    enum status_code (*evaluate)(struct model_curve *out, const double *loads, size_t count, void *context,
                                 struct status *status);
    void *context;
    double tolerance; /* relative, of the loads */
};

/** A model on a task, to be searched as a landmarks_curve: evaluate = landmarks_run_model, context = this. */
struct landmarks_model {
    const struct model_row *row;
    struct model_task task; /* but its loads */
    unsigned quantities;    /* of task.wanted those to compute */
    const struct ensemble *set;
};
MUST_CHECK enum status_code landmarks_run_model(struct model_curve *out, const double *loads, size_t count,
                                                void *context, struct status *status);

/** Step in ln P over which the slope of ECR is taken at an elbow: a 24th of a decade, so that the small steps of the
 * elastic-plastic stack are no elbows, and lists of any density have the same one. */
extern const double landmarks_slope_step;

/** Solves what curve_summary_make() has read off the list of loads in `curve`: elbow_load, where |d ln ECR/d ln P| over
 * landmarks_slope_step about a load first exceeds 2; invalid_area_load, where A/A_n passes row->largest_area; and
 * invalid_fit_load, where a tenth of the load passes the fitted range. What holds at the first load already is that
 * load. Brackets are narrowed by a few loads a pass until they are within the tolerance. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code landmarks_solve(struct curve_summary *summary, const struct model_curve *curve,
                                            const struct model_row *row, const struct landmarks_curve *searched,
                                            struct status *status);

/** A value that a quantity passes as the load rises. */
struct landmarks_value {
    enum quantity quantity;
    double value; /* above 0 */
    bool rises;   /* the quantity does; else it falls */
    /** Added to the quantity's logarithm, as one end of its interval is; NULL: nothing. */
    double (*shift)(double ln_load, const void *context);
    const void *context;
};
/** Where it does, between the loads ends[0] and ends[1]: *found is false where it is not passed up to ends[1], and
 * ends[] are then as they were; else they are narrowed to within the tolerance, ends[1] being the first load known to
 * be beyond, or both the first load where it has been passed there. Loads at which the curve has no such number count
 * as beyond. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code landmarks_find(double ends[2], bool *found, const struct landmarks_value *value,
                                           const struct landmarks_curve *searched, struct status *status);

/** The other estimate of beta (4.54), which brings delta_ADJ closest to the multiscale H in the mean square: the mean
 * of 4 (H - delta/2)/sigma over ln P, from `from` to `to` = P/(A_n E'), below the full contact of the adjusted model.
 * delta and H each by Fejér's second rule on 11, 23, 47 and 95 loads, each of which has those of the one before, until
 * two agree to the tolerance (of 1, in beta): delta is smooth; where H has kinks and steps, 95 loads are the last word,
 * within some 1e-4. NaN where `to` is not above `from`. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code landmarks_nearest_beta(double *beta, const struct landmarks_curve *adjusted,
                                                   const struct landmarks_curve *multiscale, double from, double to,
                                                   double sigma_m, struct status *status);

#endif
