/* What the curves say when they are held against each other: the figures behind the report's checks. One pass over the
 * spool, surfaces from smoothest to roughest, two in memory at a time. */
#ifndef REPORT_STUDY_H
#define REPORT_STUDY_H

#include "results/tables.h"

/** Neighbours in roughness compared load by load in one model. */
struct study_rank {
    size_t pairs;      /* comparisons made */
    size_t area;       /* in which the smoother surface has the larger area */
    size_t separation; /* in which the smoother one has the smaller (adjusted) separation/sigma */
    size_t ecr, tcr;   /* in which the smoother one has the smaller resistance */
};

/** A plastic model against its elastic counterpart, load by load. */
struct study_plastic {
    size_t points, above;    /* compared; plastic area not below the elastic one */
    double least, most;      /* ratio of the areas */
    size_t surfaces, sooner; /* compared; plastic full contact at the lower load */
};

struct study {
    struct study_rank rank[MODEL_COUNT];
    struct study_plastic plastic[2]; /* multiscale, statistical */
    double middle_load;              /* P/(A_n E') at which the spreads are taken */
    double area_spread[MODEL_COUNT]; /* largest/smallest area of the surfaces there; NaN: fewer than two */
    double proportional_error;       /* largest |TCR/ECR / (1/(rho k)) - 1|; NaN: not both computed */
    double area_gap, ecr_gap;        /* baseline, multiscale against statistical of the plastic law (else elastic):
                                        mean |log10 ratio| of area and ECR over common loads; NaN: not both run */
};

/** Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code study_make(struct study *out, const struct results *results, struct status *status);

#endif
