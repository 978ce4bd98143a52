/* One row of every model's result. */
#ifndef CONTACT_POINT_H
#define CONTACT_POINT_H

/** Quantities beyond area that a run may want: bits, so that what is not called for is not computed. */
enum contact_quantity {
    CONTACT_SEPARATION = 1,
    CONTACT_ELECTRICAL = 2,
    CONTACT_THERMAL = 4,
    CONTACT_SCALE_DEPENDENT = 8,
};

/** Contact at one load. What was not wanted is NaN. */
struct contact_point {
    double load;              /* P/(A_n E') */
    double area_ratio;        /* A/A_n, 0...1 */
    double separation_m;      /* multiscale: H; statistical: delta, distance of the mean planes */
    double adjusted_m;        /* statistical: delta_ADJ (4.54); multiscale: NaN */
    double ecr_ohm_m2;        /* ECR A_n */
    double tcr_K_m2_per_W;    /* TCR A_n */
    double tcr_sd_K_m2_per_W; /* the same, scale-dependent */
    double beyond_fit;        /* share of the load on asperities beyond the law's fitted range, 0...1 (JG), else 0 */
    double radius_clamped;    /* share of the load on asperities whose a/R is clamped to 1 (JG), else 0 */
};

#endif
