/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contact of an elastic surface whose heights are not Gaussian: Persson's area with the slope of the highest fraction A
 * of the surface, where it touches, in place of the slope of the whole (equations: contacting slopes). That the area
 * follows from the slope averaged over the true contact is Müser and Wang's (2018). */
#ifndef CONTACT_CONTACTING_SLOPES_H
#define CONTACT_CONTACTING_SLOPES_H

#include "base/status.h"
#include "contact/persson.h"
#include <stdbool.h>
#include <stddef.h>

/** A point of the surface: its height, and the mean-square slope of a profile there: s² of a row, half of
 * s_x² + s_y² of a map. */
struct slope_point {
    double height_m;
    double slope_square;
};

/** The inner points of a levelled profile of `points` >= 3 heights: s_j = (z_{j+1} - z_{j-1})/(2h), j = 1...points-2.
 * Writes and returns points - 2 of them. The rows of a map, which share the height reference, are written one after
 * another. */
size_t contacting_slopes_of_profile(struct slope_point *out, const double *height_m, size_t points, double spacing_m);

/** The same of a map of nx*ny heights over its plane, row after row, with both slopes: (s_x² + s_y²)/2 at the inner
 * points whose four neighbours are there (NaN: missing). Writes and returns at most (nx - 2)(ny - 2) of them. */
size_t contacting_slopes_of_map(struct slope_point *out, const double *height_m, size_t nx, size_t ny, double dx_m,
                                double dy_m);

/** Fewest points k whose slopes are averaged: 30. A surface needs one more. */
extern const size_t contacting_slopes_least;
/** Area ratio up to which separation and resistance are given: 0.15. Beyond, the line through the highest points no
 * longer stands for what touches. */
extern const double contacting_slopes_separation_area;

/** One surface, ready for any load. Owned: contacting_slopes_free(). */
struct contacting_slopes {
    size_t points;        /* M */
    double energy_factor; /* g */
    double *height_m;     /* z_(i), highest first */
    double *mean_square;  /* m2(k), the mean s² of the k highest points, at index k; from k = 1 */
    double *load;         /* p_k at which A = k/M, never falling, at index k; from k = 30 */
    size_t lines;         /* largest k of the lines */
    struct {
        double offset_m, scale_m;
    } * line; /* z = offset + scale y through the k highest points, y their normal scores, at index k; from k = 30 */
};

/** Sorts `point` (highest first, ties by index) and prepares A(p): p_k = erf^-1(A_k) sqrt(m2(k) (g + (1-g) A_k)), made
 * monotone, A_k = k/M, k = 30...M-1; and the least-squares lines.
 * Errors: STATUS_MEMORY; STATUS_MODEL for fewer than 31
 * points or without any slope. */
MUST_CHECK enum status_code contacting_slopes_make(struct contacting_slopes *out, const struct slope_point *point,
                                                   size_t points, double energy_factor, struct status *status);
/** The heights and the lines alone, without any area: what a chart of the heights needs. Errors: STATUS_MEMORY;
 * STATUS_MODEL for fewer than 31 points. */
MUST_CHECK enum status_code contacting_slopes_lines(struct contacting_slopes *out, const struct slope_point *point,
                                                    size_t points, struct status *status);
void contacting_slopes_free(struct contacting_slopes *slopes);

enum contacting_slopes_mark {
    CONTACTING_SLOPES_INSIDE,
    CONTACTING_SLOPES_FEW,    /* fewer than 30 points touch: the area is proportional to the load */
    CONTACTING_SLOPES_BEYOND, /* all but the lowest point touch: A = (M-1)/M at any higher load */
};

struct contacting_slopes_area {
    double area_ratio;
    enum contacting_slopes_mark mark;
};

/** A at p = P/(A_n E') >= 0: between the last k with p_k <= p and the next by logarithms. */
struct contacting_slopes_area contacting_slopes_area(const struct contacting_slopes *slopes, double load);

/** Normal score of the i-th highest (from 0) of M points: y_i = Phi^-1(1 - (i + 1/2)/M). */
double contacting_slopes_score(size_t i, size_t points);
/** k_2 = floor(2AM), at least 30: how many of the highest points the line goes through at A = area_ratio <= 0.15. */
size_t contacting_slopes_fitted(const struct contacting_slopes *slopes, double area_ratio);

/** The Gaussian surface that fits the part in contact. */
struct contacting_slopes_gap {
    double offset_m, scale_m; /* a, b: z = a + b y through the floor(2AM) highest points */
    double separation_m;      /* a + b u_P(p/b), from the mean plane of the heights given */
    double constriction_m;    /* ell = -u_P'(p/b)/2: ECR A_n = (rho_1 + rho_2) ell */
};

/** Separation and constriction at p > 0, area_ratio the A of contacting_slopes_area() there; false, and nothing
 * written, beyond A = 0.15. `persson` holds the spectrum, of which the shape counts, not the height: its waves D_n at
 * f_n become D_n/sigma_D at f_n kappa, kappa² = m2(k_A)/b² sigma_D²/m2_D, k_A = floor(AM), so that u_P(p/b) =
 * u_D(p')/sigma_D and u_P'(p/b) = u_D'(p')/kappa with p' = p sqrt(m2_D/m2(k_A)). */
bool contacting_slopes_gap(struct contacting_slopes_gap *out, const struct contacting_slopes *slopes,
                           const struct persson *persson, double load, double area_ratio);

#endif
