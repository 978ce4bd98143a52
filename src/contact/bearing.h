/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A surface of a given hardness: the heights that bear the load, and what they do to an elastic contact (equations:
 * hardness). */
#ifndef CONTACT_BEARING_H
#define CONTACT_BEARING_H

#include "contact/strip.h"

/** What lies below the height d that a share A/A_n of the surface exceeds. */
struct bearing_at {
    double gap_m;           /* g_b: mean of (d - z) where positive */
    double crossings_per_m; /* nu: times a profile rises through d */
};

/** Of Gaussian heights of the mean square m0 whose profiles have the mean-square slope m2. */
struct bearing_at bearing_gaussian(double area_ratio, double m0_m2, double m2);

/** The heights of profiles, in order. Owned: bearing_free(). */
struct bearing {
    const struct strip_rows *rows;
    double *height_m; /* highest first, all rows */
    double *below_m;  /* at index k the sum of height_m[k ...] */
    size_t count;
    double area[2]; /* least and largest share at whose height the profiles rise through it often enough for a count */
};

/** Error: STATUS_MEMORY. `rows` has to outlive it. */
MUST_CHECK enum status_code bearing_make(struct bearing *out, const struct strip_rows *rows, struct status *status);
void bearing_free(struct bearing *bearing);
/** At a share of 0 ... 1; crossings are counted, a mean over heights near it. Beyond area[], and of the gap below six
 * points, where a few of the highest or lowest of the scans are left, both keep their ratio to those of Gaussian
 * heights. */
struct bearing_at bearing_counted(double area_ratio, const struct bearing *bearing);

/** A point of contact. */
struct bearing_contact {
    double area_ratio, separation_m, constriction_m;
};

/** A under the hardness, P/H given: min(1, (A_e^4 + (P/H)^4)^(1/4)). */
double bearing_area(double elastic_area_ratio, double load_over_hardness);
/** Gap and constriction length at that area: (g_e^-3 + w g_b^-3)^(-1/3) and (l_e^-3 + w (l_b/0.8)^-3)^(-1/3), with
 * l_b = (1 - sqrt A)^1.5/(2 nu) and the share that bears the hardness, w = (P/H)/A, with which the bearing curve goes
 * out where nothing yields. Exponents measured on 192 direct solutions with a hardness, w on 108 more of 0.03 to 50
 * E' g. */
struct bearing_contact bearing_contact(double area_ratio, double load_over_hardness,
                                       const struct bearing_contact *elastic, const struct bearing_at *at);

#endif
