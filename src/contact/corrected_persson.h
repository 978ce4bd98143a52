/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Persson's theory corrected at equal area: over direct solutions of 456 Gaussian surfaces the theory's error depends
 * on the area ratio alone, whatever the spectrum (equations: corrected Persson). */
#ifndef CONTACT_CORRECTED_PERSSON_H
#define CONTACT_CORRECTED_PERSSON_H

#include "contact/persson.h"
#include <math.h>

static inline double logit(double share)
{
    return log(share) - log1p(-share);
}

/** Inverse of logit(). */
static inline double logistic(double logit)
{
    return 1 / (1 + exp(-logit));
}

/** Largest A/A_n that the direct solutions reach. */
#define CORRECTED_PERSSON_LARGEST_AREA 0.97

/** ln s and ln c at A/A_n (0...1, exclusive). */
struct corrected_persson_factors {
    double load;         /* ln s: p = s p_0 */
    double constriction; /* ln c: l = c l_0 */
};
struct corrected_persson_factors corrected_persson_factors(double area_ratio);

/** p = P/(A_n E') at an area ratio (0...1, exclusive) of a surface of mean-square profile slope m2. */
double corrected_persson_load(double area_ratio, double m2);
/** Its inverse, A = erf(p/(s sqrt(m2 (g + (1-g) A)))), by iteration; meaningless above the largest area. */
double corrected_persson_area(double load, double m2);

/** A surface under a load. */
struct corrected_persson_point {
    double area_ratio;
    double constriction_m;      /* l(A): R A_n = (rho_1 + rho_2) l */
    double separation_m;        /* 2 int_A^1 l dp (Barber 2003, Proc. R. Soc. A 459, 53) */
    double least_area_per_load; /* least A/(A_n p) up to this load: for strips and yield, not set here */
};

/** Length and separation of `count` points of ascending area ratios above 0 and up to the largest. Relative error of
 * the separation below 1e-4 (tests); NaN if not with_separation, in a tenth of the time. */
void corrected_persson_curve(struct corrected_persson_point *point, size_t count, const struct persson *persson,
                             bool with_separation);
/** The same below a point that is known; with separations if that has one. */
void corrected_persson_below(struct corrected_persson_point *point, size_t count, const struct persson *persson,
                             const struct corrected_persson_point *known);

#endif
