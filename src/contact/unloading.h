/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact that has seen more load: what has flowed under the largest keeps its shape, so that more of it touches, and
 * it conducts better, than on the way up (equations: unloading). */
#ifndef CONTACT_UNLOADING_H
#define CONTACT_UNLOADING_H

#include "contact/quantity.h"
#include "contact/strip.h"

enum { UNLOADING_SHARES = 8 }; /* of the largest load, at which both branches are solved */

/** What unloading does to a surface, from its profiles solved as a strip with the hardness, up and down again. */
struct unloading {
    size_t count;                      /* of shares with enough spots */
    double share[UNLOADING_SHARES];    /* from 1 down */
    double value[UNLOADING_SHARES][3]; /* ln of area, gap and constriction length over those of loading */
    double raised; /* the strip's largest load over that given: under a light load too few spots touch in it, but there
                      contact is proportional to load, and the ratios are the shares' alone */
    uint64_t transforms; /* pairs of transforms that it took, times points */
};

/** Loads are P/(A_n E'), hardness H/E'. Errors: STATUS_MODEL: flat rows, P no less than H, no convergence;
 * STATUS_INTERRUPTED when *stop (NULL: never) becomes non-zero; STATUS_MEMORY. */
MUST_CHECK enum status_code unloading_solve(struct unloading *out, const struct strip_rows *rows, double largest_load,
                                            double hardness, const atomic_bool *stop, struct status *status);

/** Bounds the ratios of a quantity so that, times them, a curve of loading with these values at the shares is one of
 * unloading: as the load falls the area does not rise, nor the gap or a resistance fall, which another curve than the
 * strip's own might. */
void unloading_bound(struct unloading *unloading, enum quantity quantity, const double *loading);

/** A quantity at that share of the largest load over its value on the way up, ln straight in ln of the share; NaN below
 * the last share and of what a strip does not tell. */
double unloading_factor(const struct unloading *unloading, enum quantity quantity, double share);

#endif
