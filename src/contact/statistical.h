/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The statistical models GW (law of Hertz) and JG (Jackson and Green): asperities of one radius with Gaussian heights
 * against a flat at height d (docs/equations.md, Statistical models; 4.25, 4.26, 4.29, 4.43-4.46, 4.49-4.51, 4.54). */
#ifndef CONTACT_STATISTICAL_H
#define CONTACT_STATISTICAL_H

#include "contact/constriction.h"
#include "contact/model.h"
#include "contact/quadrature.h"
#include <stdbool.h>

/** One surface and one law. Owned: statistical_free(). */
struct statistical {
    struct asperities surface;
    struct asperity asperity;
    bool plastic;
    struct constriction spot;
    unsigned wanted;          /* QUANTITY_BITs */
    struct quadrature panels; /* empty where closed forms do */
    double full_d;            /* d/sigma_s at which A = A_n */
    double full_load;         /* P/(A_n E') there */
    double beta;              /* -2 delta_full/sigma: makes delta_ADJ = 0 at A = A_n (4.54) */
};

/** Prepares the model of a task, with beta (4.54), for separations down to full contact or to `lowest_d` sigma_s if
 * that is lower, above about -2000 (always so with roughness_asperities()). Error: STATUS_MEMORY. */
MUST_CHECK enum status_code statistical_make(struct statistical *out, const struct model_task *task, bool plastic,
                                             double lowest_d, struct status *status);
void statistical_free(struct statistical *model);

/** Contact with the flat at d = `d` sigma_s: A (4.25), P (4.26), delta (4.29), delta_ADJ (4.54), and the resistances
 * (4.43*, 4.46*, 4.49*, 4.50*, 4.51) with the Psi of (4.44). Below full contact (A > A_n) the area ratio exceeds 1 and
 * the resistances are 0. `beyond_fit` is the share of the load on asperities with a/R > 0.41 (JG). */
void statistical_at(struct contact_point *out, const struct statistical *model, double d);

/** Contact at P/(A_n E') = load; false, with nothing written, beyond full contact. `*d`, d/sigma_s, is any finite first
 * guess and becomes that of the solution. */
bool statistical_solve(struct contact_point *out, const struct statistical *model, double load, double *d);

/** Spots at d = `d` sigma_s: all touching asperities, n = eta F_0(d), and their mean radius over the contact area, int
 * a³ phi/int a² phi (GW: sqrt(R sigma_s) F_3/2/F_1). Both depend on the resolution of the scan through m4. */
struct contact_spots statistical_spots(const struct statistical *model, double d);

/** Full contact: area ratio 1, adjusted separation and resistances 0. */
void statistical_full(struct contact_point *out, const struct statistical *model);

/** The beta in (4.54) for which delta_ADJ is the multiscale separation at a load. */
double statistical_beta_multiscale(double separation_m, double multiscale_m, double sigma_m);

#endif
