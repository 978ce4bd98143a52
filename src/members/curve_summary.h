/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A model's curve in a few numbers, small enough to be kept for every model on a hundred thousand surfaces. */
#ifndef MEMBERS_CURVE_SUMMARY_H
#define MEMBERS_CURVE_SUMMARY_H

#include "contact/convergence.h"
#include "members/ensemble.h"

/** The input that is changed, one at a time. */
enum sensitivity_change {
    SENSITIVITY_CUTOFF_DOUBLED,
    SENSITIVITY_SCAN_HALVED,
    SENSITIVITY_HARDNESS_RAISED, /* by a tenth, with the yield strength; plastic models only */
    SENSITIVITY_CHANGES
};
/** The answer with the change over the answer without, at the operating load. NaN: either is empty, or the change does
 * not concern the model. The inverses predict the opposite changes (cut-off halved, scan doubled, hardness lowered). */
struct sensitivity_factors {
    double area[SENSITIVITY_CHANGES], ecr[SENSITIVITY_CHANGES];
};

struct curve_summary {
    bool exists;
    double first_load;              /* of the curve's first point */
    struct contact_point operating; /* at the operating load; quantity_nothing(): the curve has no point there */
    double full_load, beta, beta_multiscale;
    double area_slope;                      /* d ln A/d ln P, least squares over A/A_n < 0.1 */
    double elbow_load;                      /* where |d ln ECR/d ln P| first exceeds 2; NaN: nowhere; the first load:
                                               there or below */
    double sd_most;                         /* largest TCR_sd/TCR - 1 of the curve */
    double invalid_load;                    /* first load above the valid range; NaN: none */
    double most_beyond_fit;                 /* largest share of the load beyond the fitted range */
    double gap_at_full;                     /* separation/sigma as shown, at full contact */
    uint64_t clamped;                       /* times that the published plastic area was cut off at 1 */
    double most_radius_clamped;             /* largest share of the load on asperities whose a/R is clamped to 1 */
    uint64_t evaluations;                   /* for the curve and its uncertainty */
    struct convergence_extension extension; /* the power law extrapolated below the sampling limit */
    double law_factor; /* area at the operating load with the fitted law in place of the measured harmonics, over that
                          with the measured ones; NaN: not asked, or no law */
    struct estimate *estimates; /* CURVE_ESTIMATES of them; owned; NULL: not known, as for most single scans */
    struct sensitivity_factors sensitivity;
    double seconds; /* that the curve took */
};

/** Is the point within the model's range: below its largest area, and at most a tenth of the load beyond the range to
 * which a law was fitted? */
bool curve_summary_point_is_valid(const struct contact_point *point, const struct model_row *row);

/** The valid points of a curve, `first` to before `end`; both are equal where there is none. Light loads may be invalid
 * too, where too few points touch. */
struct curve_validity {
    size_t first, end;
};
struct curve_validity curve_summary_validity(const struct model_curve *curve, const struct model_row *row);

/** The uncertainty of number `which` (a quantity, CURVE_FULL_LOAD or CURVE_BETA); estimate_none: not known. */
const struct estimate *curve_summary_estimate(const struct curve_summary *model, int which);
/** Keeps a copy of `all`, CURVE_ESTIMATES of them. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code curve_summary_put_estimates(struct curve_summary *model, const struct estimate *all,
                                                        struct status *status);
/** Is the load below the model's first invalid one? */
bool curve_summary_is_valid(const struct curve_summary *model, double load);

/** Summarises a model's curve on a surface of rms height sigma_m; sensitivity, seconds and evaluations are kept. */
void curve_summary_make(struct curve_summary *out, const struct model_curve *curve, const struct model_row *row,
                        double sigma_m, double operating_load);

#endif
