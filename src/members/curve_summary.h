/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a curve says, in a few numbers: small, so that it can be kept for every model that runs, of a hundred thousand
 * surfaces. */
#ifndef MEMBERS_CURVE_SUMMARY_H
#define MEMBERS_CURVE_SUMMARY_H

#include "contact/convergence.h"
#include "members/ensemble.h"

/** What is changed, one thing at a time. */
enum sensitivity_change {
    SENSITIVITY_CUTOFF_DOUBLED,
    SENSITIVITY_SCAN_HALVED,
    SENSITIVITY_HARDNESS_RAISED, /* by a tenth, with the yield strength; of plastic models */
    SENSITIVITY_CHANGES
};
/** Answer changed / answer as it is, at the middle load; NaN where either is empty, or the change is none for the
 * model. The other way (cut-off halved, scan doubled, hardness lowered) is predicted by the inverses. */
struct sensitivity_factors {
    double area[SENSITIVITY_CHANGES], ecr[SENSITIVITY_CHANGES];
};

struct curve_summary {
    bool exists;
    double first_load;              /* of the curve */
    struct contact_point operating; /* where the summary stands; quantity_nothing(): the curve has no point there */
    double full_load, beta, beta_multiscale;
    double area_slope;          /* d ln A/d ln P, least squares over A/A_n < 0.1 */
    double elbow_load;          /* where |d ln ECR/d ln P| first exceeds 2, over the loads; NaN: nowhere; the
                                   first load: there or below */
    double sd_most;             /* largest TCR_sd/TCR - 1 of the curve */
    double invalid_load;        /* first load from a valid one on beyond the model's validity; NaN: none */
    double most_beyond_fit;     /* largest share of the load beyond the fitted range */
    double gap_at_full;         /* separation/sigma as shown, at the load of A = A_n */
    uint64_t clamped;           /* visits in which the published plastic area was cut off at 1 */
    double most_radius_clamped; /* largest share of the load on asperities whose a/R is clamped to 1 */
    uint64_t evaluations;       /* that the curve and what is known of it took */
    struct convergence_extension extension; /* the fitted power law carried on below the sampling limit */
    double law_factor; /* area at the operating load with the fitted law in place of the harmonics of its band, over
                          that with them; NaN: not asked, or no law */
    struct estimate *estimates; /* CURVE_ESTIMATES of them; owned; NULL: none known, as of most single scans */
    struct sensitivity_factors sensitivity;
    double seconds; /* that the curve took */
};

/** Is it inside the model's validity: its largest area, and a tenth of the load beyond a law's fitted range? */
bool curve_summary_point_is_valid(const struct contact_point *point, const struct model_row *row);

/** Points of a curve inside the model's validity: from `first` to before `end`, which are the same when none is. Light
 * loads may be outside too (contacting slopes: too few points touch). */
struct curve_validity {
    size_t first, end;
};
struct curve_validity curve_summary_validity(const struct model_curve *curve, const struct model_row *row);

/** How far number `which` (a quantity, CURVE_FULL_LOAD, CURVE_BETA) may be off; estimate_none: not known. */
const struct estimate *curve_summary_estimate(const struct curve_summary *model, int which);
/** Keeps a copy of `all`, CURVE_ESTIMATES of them. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code curve_summary_put_estimates(struct curve_summary *model, const struct estimate *all,
                                                        struct status *status);
/** Is the model inside its range of validity there, as far as the curve's summary tells? */
bool curve_summary_is_valid(const struct curve_summary *model, double load);

/** Condenses one model's curve on a surface of rms height sigma_m; sensitivity, seconds and evaluations are kept. Loads
 * that are not the model's own answer are points of the curve. */
void curve_summary_make(struct curve_summary *out, const struct model_curve *curve, const struct model_row *row,
                        double sigma_m, double operating_load);

#endif
