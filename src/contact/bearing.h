/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A surface of a given hardness: the heights that bear the load, and what they do to an elastic contact (equations:
 * hardness). */
#ifndef CONTACT_BEARING_H
#define CONTACT_BEARING_H

#include "contact/strip.h"

/** What lies below the height d that a share A/A_n of the surface exceeds. */
struct bearing_at {
    double gap_m;    /* g_b: mean of (d - z) where positive */
    double length_m; /* l_b = (1 - sqrt A)^1.5/(2 nu), nu how many times per metre a profile rises through d */
};

/** Of Gaussian heights of the mean square m0 whose profiles have the mean-square slope m2. */
struct bearing_at bearing_gaussian(double area_ratio, double m0_m2, double m2);

/** The heights of profiles, in order. Owned: bearing_free(). */
struct bearing {
    double *height_m; /* above the lowest, highest first, all rows */
    double *below_m;  /* at index k the sum of height_m[k ...] */
    size_t count;
    double *ln_length;    /* of l_b at nodes, by even factors of A/(1-A), 1 in the middle: never rising */
    size_t nodes, end[2]; /* the first and the last at whose height the profiles rise through it often enough */
};

/** Error: STATUS_MEMORY. */
MUST_CHECK enum status_code bearing_make(struct bearing *out, const struct strip_rows *rows, struct status *status);
void bearing_free(struct bearing *bearing);
/** At a share of 0 ... 1; crossings are counted, a mean over heights near it. Beyond the ends, and of the gap below six
 * points, where a few of the highest or lowest of the scans are left, both keep their ratio to those of Gaussian
 * heights. Neither rises with the share. */
struct bearing_at bearing_counted(double area_ratio, const struct bearing *bearing);

/** A under the hardness, P/H given: min(1, (A_e^4 + (P/H)^4)^(1/4)). */
double bearing_area(double elastic_area_ratio, double load_over_hardness);
/** Standard deviation of its ln beside the elastic area's own: what it was off by against direct solutions of 18
 * synthetic maps with a hardness where between 0.1 and 3 % of the load was elastic. */
extern const double bearing_area_sd;
/** Gap and constriction length there, of the elastic ones at that load: (g_e^-3 + w g_b^-3)^(-1/3) and (l_e^-3 + w
 * (l_b/0.8)^-3)^(-1/3), with the share of the contact that bears the hardness, w = (P/H)/A, with which the bearing
 * curve goes out where nothing yields. Exponents measured on 192 direct solutions with a hardness, w on 108 more of
 * 0.03 to 50 E' g. */
double bearing_gap(double elastic_m, double share, const struct bearing_at *at);
double bearing_length(double elastic_m, double share, const struct bearing_at *at);

#endif
