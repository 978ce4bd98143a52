/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a surface's heights do, whatever their distribution: profiles solved as strips of an elastic half space, without
 * strain across, beside Gaussian strips of the same spectrum. Their ratio at equal area is carried over to the surface
 * (equations: strip transfer). */
#ifndef CONTACT_STRIP_H
#define CONTACT_STRIP_H

#include "base/threads.h"
#include "contact/corrected_persson.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    STRIP_LOADS = 17,     /* rungs of the ladder */
    STRIP_KNOTS = 32,     /* at most, of a curve */
    STRIP_SURROGATES = 2, /* Gaussian strips a ratio is against; one row's and the same turned over scatter as four */
    STRIP_ROUGHLY = 5,    /* in place of their number where only the scatter of answers is asked: one, half the loads */
    STRIP_LEAST_POINTS = 12 /* in contact, below which a solution says nothing */
};

/** Profiles of one surface, of equal length and spacing, levelled, their heights from one reference. */
struct strip_rows {
    const double *height_m; /* rows x points */
    size_t rows, points;
    double spacing_m;
    bool periodic;        /* each closes on itself; else it is mirrored */
    const uint64_t *seed; /* one a row, of its surrogates' phases; NULL: its number */
    double smoothing;     /* what follows from them is smoothed over so much of logit A: strip_smoothing(); 0: not */
};

/** For rows of so many scans: measured ratios have the least error with it (any-heights: 1 for one, .6 from three on),
 * and the stairs that their noise makes are gone. */
double strip_smoothing(size_t scans);

/** The rows one after another, each with its mirror image behind it unless periodic: so many heights, malloc'ed; NULL:
 * out of memory. */
double *strip_join(size_t *points, const struct strip_rows *rows);

/** Solutions of one strip by area, ascending. */
struct strip_curve {
    size_t count;
    double logit[STRIP_KNOTS];    /* of A/A_n, corrected for the outline */
    double value[STRIP_KNOTS][3]; /* ln of p, l, gap: as struct strip_ratio */
    size_t unsolved;              /* loads at which the solution did not converge, which are left out */
};

/** A strip and the Gaussian ones beside it. */
struct strip {
    struct strip_curve own, surrogate[STRIP_SURROGATES];
    size_t surrogates;   /* that have a solution */
    size_t unsolved;     /* of all of them */
    uint64_t transforms; /* pairs of transforms that it took, times points */
    double smoothing;    /* as of the rows */
};

/** Joins the rows to one strip and solves it, and as many surrogates:
 * every row with random phases on these rows' mean power and a normal mean of these rows' mean and deviation, hashed
 * from the row's seed, so that it keeps its phases whatever other rows there are;
 * every second one is the one before turned over. Loads and surrogates that do not converge are left out. Errors:
 * STATUS_MODEL: flat rows, or not one load under which enough points touch and the solution converges;
 * STATUS_INTERRUPTED; STATUS_MEMORY. The same from any number of threads. */
MUST_CHECK enum status_code strip_solve(struct strip *out, const struct strip_rows *rows, size_t surrogates,
                                        const struct threads *threads, struct status *status);

/** Pairs of transforms times points that strip_solve() takes with STRIP_SURROGATES, about. */
uint64_t strip_cost(const struct strip_rows *rows);

/** ln of the strip's load, constriction length and gap over those of its surrogates (mean of ln) at equal area. */
struct strip_ratio {
    double load, constriction, separation;
};
struct strip_ratio strip_ratio_at(const struct strip *strip, double area_ratio);

/** A/A_n (up to that of corrected_persson.h; NaN beyond) at ascending loads P/(A_n E') of a surface whose rows have the
 * mean-square slope m2: p(A) of the corrected theory times the ratio, made monotone. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code strip_areas(double *area_ratio, const double *loads, size_t count,
                                        const struct strip *strip, double m2, struct status *status);

/** A surface under a load. */
struct strip_contact {
    double area_ratio, constriction_m, separation_m;
    double least_area_per_load; /* A/(A_n p) at this load or a smaller one */
};

/** What goes with ascending areas up to the largest of corrected_persson.h, the corrected theory's times the ratio:
 * lengths and separations never rise, and none depends on which other areas there are. Where at a smaller one it was
 * less, the area per load becomes that. with_separation false: NaN. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code strip_contact(struct strip_contact *contact, size_t count, const struct strip *strip,
                                          const struct persson *persson, bool with_separation, struct status *status);

#endif
