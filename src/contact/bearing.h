/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contact of a surface with a given hardness: the elastic answer and the bearing curve (Abbott and Firestone) in
 * parallel (equations: hardness). */
#ifndef CONTACT_BEARING_H
#define CONTACT_BEARING_H

#include "contact/strip.h"

/** The bearing curve at the height d that a share A/A_n of the surface exceeds. */
struct bearing_at {
    double gap_m;    /* g_b: mean of (d - z) where positive */
    double length_m; /* l_b = (1 - sqrt A)^1.5/(2 nu), nu how many times per metre a profile rises through d */
};

/** The same of Gaussian heights with mean square m0 and mean-square profile slope m2. */
struct bearing_at bearing_gaussian(double area_ratio, double m0_m2, double m2);

/** The measured heights of profiles, sorted. Owned: bearing_free(). */
struct bearing {
    double *height_m; /* above the lowest, highest first, all rows */
    double *below_m;  /* at index k the sum of height_m[k ...] */
    size_t count;
    double *ln_length; /* ln l_b at nodes spaced by equal factors of A/(1-A), which is 1 in the middle; never rises */
    size_t nodes, end[2]; /* first and last node with enough crossings to count */
};

/** Error: STATUS_MEMORY. */
MUST_CHECK enum status_code bearing_make(struct bearing *out, const struct strip_rows *rows, struct status *status);
void bearing_free(struct bearing *bearing);
/** The measured curve at a share of 0 ... 1; crossings are averaged over nearby heights. Where too few crossings (for
 * the gap: fewer than six points) are left, both values follow Gaussian heights, scaled to meet the last measured one.
 * Neither rises with the share. */
struct bearing_at bearing_counted(double area_ratio, const struct bearing *bearing);

/** Area ratio with the hardness: min(1, (A_e^4 + (P/H)^4)^(1/4)). */
double bearing_area(double elastic_area_ratio, double load_over_hardness);
/** Standard deviation of its ln, without that of the elastic area: its error against direct solutions of 18 synthetic
 * maps with a hardness where 0.1 to 3 % of the load was elastic. */
extern const double bearing_area_sd;
/** Gap and constriction length with the hardness, from the elastic ones at the same load: (g_e^-3 + w g_b^-3)^(-1/3)
 * and (l_e^-3 + w (l_b/0.8)^-3)^(-1/3). The share w = (P/H)/A of the contact bears the hardness; without yield the
 * bearing curve has no effect. Exponents fitted to 192 direct solutions with a hardness, w to 108 more of 0.03 to 50 E'
 * g. */
double bearing_gap(double elastic_m, double share, const struct bearing_at *at);
double bearing_length(double elastic_m, double share, const struct bearing_at *at);

#endif
