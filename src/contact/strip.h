/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The effect of a height distribution: profiles are solved as strips of an elastic half space in plane strain, and so
 * are Gaussian strips of the same spectrum ("surrogates"). Their ratio at equal area is applied to the surface
 * (equations: strip transfer). */
#ifndef CONTACT_STRIP_H
#define CONTACT_STRIP_H

#include "base/threads.h"
#include "contact/corrected_persson.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    STRIP_LOADS = 17,     /* solved */
    STRIP_KNOTS = 32,     /* at most, of a curve */
    STRIP_SURROGATES = 2, /* a Gaussian strip and the same upside down, which scatter no more than four do */
    STRIP_LONG = 32768,   /* points of all rows from which one is enough: strip_surrogates() */
    STRIP_ROUGHLY = 5     /* as the number of surrogates, for a scatter alone: one surrogate, a third of the loads */
};

/** Levelled profiles of one surface, of equal length and spacing, with a common height reference. */
struct strip_rows {
    const double *height_m; /* rows x points */
    size_t rows, points;
    double spacing_m;
    bool periodic;        /* each row; else it is mirrored */
    const uint64_t *seed; /* one per row, for the phases of surrogates; NULL: its number */
    size_t scans;         /* of the surface, 0: ratios are not smoothed */
};

/** The width in logit A with the least measured error: 1 for one scan, .6 from three on (any-heights). Smoothing also
 * removes steps that noise makes. */
double strip_smoothing(size_t scans);

/** Points in contact that a usable solution has: 12, but 8 where three scans or more are joined. On surfaces of all
 * heights leading answers of five scans then err by .21 .25 .31 instead of .22 .25 .32 (rms ln of area, gap,
 * resistance); single scans would err by .36 .54 .54 instead of .34 .55 .50. */
size_t strip_least_points(const struct strip_rows *rows);

/** Gaussian strips that a strip is compared with. Of 64 000 points a second one changes area, gap and resistance by
 * .03, .1 and .12 (rms ln, one longest wave) to .05, .02 and .04 (300 of them), where models err by .37, .48 and .54;
 * without it 64 000 points take a fifth less. */
size_t strip_surrogates(const struct strip_rows *rows);

/** The rows one after another, each followed by its mirror image unless periodic; malloc'ed; NULL: out of memory. */
double *strip_join(size_t *points, const struct strip_rows *rows);

/** Solutions of one strip, by ascending area. */
struct strip_curve {
    size_t count;
    double logit[STRIP_KNOTS];    /* of A/A_n, corrected for the outline */
    double value[STRIP_KNOTS][3]; /* ln of p, l, gap: as struct strip_ratio */
    size_t unsolved;              /* loads that did not converge and are left out */
};

/** A strip and its surrogates. */
struct strip {
    struct strip_curve own, surrogate[STRIP_SURROGATES];
    size_t surrogates;   /* with a solution */
    size_t unsolved;     /* loads of all strips */
    uint64_t transforms; /* pairs of transforms, times points */
    double smoothing;    /* strip_smoothing(); 0: none */
};

/** Joins the rows to one strip and solves it and its surrogates. A surrogate's rows have the mean power of all rows
 * with random phases, and a normal mean with the mean and deviation of the rows; both are hashed from the row's seed,
 * and so do not depend on other rows. Every second surrogate is the one before upside down. Loads and surrogates that
 * do not converge are left out. Errors: STATUS_MODEL: flat rows, or no load with enough points in contact that
 * converges; STATUS_INTERRUPTED; STATUS_MEMORY. The result does not depend on the number of threads. */
MUST_CHECK enum status_code strip_solve(struct strip *out, const struct strip_rows *rows, size_t surrogates,
                                        const struct threads *threads, struct status *status);

/** Expected `transforms` of strip_solve() with strip_surrogates(). */
uint64_t strip_cost(const struct strip_rows *rows);

/** ln of load, constriction length and gap over those of the surrogates (mean of ln) at equal area. */
struct strip_ratio {
    double load, constriction, separation;
};
struct strip_ratio strip_ratio_at(const struct strip *strip, double area_ratio);

/** A strip's answers for one surface at a grid of areas, up to the largest of corrected_persson.h: corrected Persson's
 * times the ratio, made monotone. Owned: strip_nodes_free(). */
struct strip_nodes {
    struct persson persson; /* of the surface */
    bool with_separation;
    double falls; /* share of the theory's fall of lengths and gaps that they have at least */
    size_t steps;
    double range[2];                      /* logit A of the first and last node */
    double *ln_load;                      /* ln of P/(A_n E') at the nodes, never falling */
    double (*value)[3];                   /* ln of l and gap, and A/(A_n p), never rising */
    double lowest[3], raised[2];          /* below the first node: the ratios, and what is added to ln of l and gap */
    struct corrected_persson_point first; /* the theory at the first node */
};

/** Takes over `persson`, also in an error: STATUS_MEMORY. Gaps are NaN if not with_separation, in half the time. */
MUST_CHECK enum status_code strip_nodes_make(struct strip_nodes *out, const struct strip *strip,
                                             const struct persson *persson, bool with_separation,
                                             struct status *status);
void strip_nodes_free(struct strip_nodes *nodes);

/** A/A_n at a load P/(A_n E'); NaN beyond the last node. */
double strip_area(double load, const struct strip_nodes *nodes);

/** Constriction length and separation at ascending areas; they do not depend on the other areas asked. Lowers
 * least_area_per_load where a smaller area had less. */
void strip_contact(struct corrected_persson_point *contact, size_t count, const struct strip_nodes *nodes);

#endif
