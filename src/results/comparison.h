/* What the curves say when they are held against each other: the figures behind the report's checks. One pass over the
 * store, surfaces from smoothest to roughest, two in memory at a time. */
#ifndef RESULTS_COMPARISON_H
#define RESULTS_COMPARISON_H

#include "results/results.h"

/** Neighbours in roughness compared load by load in one model. */
struct comparison_rank {
    size_t pairs;                  /* comparisons made */
    size_t ranked[QUANTITY_COUNT]; /* in which the smoother surface has the larger area, the smaller shown
                                      separation/sigma, the smaller resistance */
};

/** A plastic model against its elastic partner, load by load. */
struct comparison_plastic {
    size_t points, above;    /* compared; plastic area not below the elastic one */
    double least, most;      /* ratio of the areas */
    size_t surfaces, sooner; /* compared; plastic full contact at the lower load */
};

/** Smallest and largest value of a quantity over the surfaces, and which surfaces these are. */
struct comparison_extremes {
    double least, most;
    size_t least_at, most_at;
    size_t count; /* surfaces that have the value; 0: none, and the rest says nothing */
};

/** Multiscale against statistical model of one material law, on the baseline surface: mean |log10 ratio| over their
 * common loads; NaN: not both computed. */
struct comparison_gap {
    double area, ecr;
};

/** What one model adds to the comparison. */
struct comparison_model {
    struct comparison_rank rank;
    struct comparison_plastic plastic;                   /* against its elastic partner; points 0: not compared */
    struct comparison_gap gap;                           /* against its counterpart */
    struct comparison_extremes extremes[QUANTITY_COUNT]; /* at the middle load */
};

struct comparison {
    struct comparison_model *models; /* model_count of them; owned */
    double proportional_error;       /* largest |TCR/ECR / (1/(rho k)) - 1|; NaN: not both computed */
    double middle_load;              /* P/(A_n E') at which surfaces and models are compared */
    size_t leading;                  /* the model the summary speaks of: the running one of the greatest precedence */
    struct contact_point *middle;    /* the leading model at the middle load, one a surface of the scene; load is
                                        NaN where it has no point; owned */
};

/** End it with comparison_free() whatever comes back. Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code comparison_make(struct comparison *out, const struct results *results,
                                            struct status *status);
void comparison_free(struct comparison *study);

/** Value of a quantity of a model's point, as tables and charts show it. */
double comparison_value(const struct contact_point *point, enum quantity quantity, size_t model, double sigma_m);

/** Has a sweep's curve converged: does the last halving of the wavelength change the area by less than 0.1 %? */
bool comparison_converges(const struct results *results, enum convergence_sweep sweep, size_t model, size_t value);

#endif
