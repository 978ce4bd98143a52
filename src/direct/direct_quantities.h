/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Area, gap and patches of a solved contact; and these with the constriction of one surface under rising loads. */
#ifndef DIRECT_QUANTITIES_H
#define DIRECT_QUANTITIES_H

#include "direct/direct_contact.h"

/** A grid point in contact counts as dx², which is too much along the outline, by kappa dx² for each face between a
 * point in contact and one that is not. DIRECT_KAPPA was measured on random surfaces against extrapolation to dx = 0
 * (0.084 ... 0.125); for outlines of any direction it is (pi - 1 + ln 2)/24 (Yastrebov, Anciaux and Molinari, J. Mech.
 * Phys. Solids 107 (2017) 469). */
extern const double direct_kappa, direct_kappa_yastrebov;

/** Of one solution, counted on the points of its grid, without mirror images. */
struct direct_quantities {
    size_t contact_points;  /* p > 0 */
    size_t perimeter_faces; /* between such a point and one that is not, periodic; outline S_d = faces dx */
    double area_ratio; /* A/A_n = contact points over all - kappa S_d dx/L², kappa = direct_kappa; under a hardness at
                          least p̄/H */
    double gap_m;      /* mean of max(g, 0): 0 at complete contact */
};

/** Of a contact just solved for `load`. */
struct direct_quantities direct_quantities_of(struct direct_contact *contact, const struct direct_contact_load *load);

/** Area corrected with another kappa, neither limited by the hardness nor below 0. */
double direct_area_corrected(const struct direct_quantities *quantities, size_t points, double kappa);

/** Number of connected patches of contact in a period, mirror images included; points connect along a face. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code direct_patches(size_t *count, struct direct_contact *contact, struct status *status);

/* One surface under rising loads, each solved from the solution before. */

struct direct_ladder_def {
    const double *load; /* p̄/E', ascending */
    size_t loads;
    double hardness;  /* H/E'; INFINITY: elastic */
    double tolerance; /* of the contact, and of the constriction length */
    bool resistance;
    const atomic_bool *stop; /* NULL: never */
    bool without_patches;    /* which are not counted then */
};

/** At one load. */
struct direct_point {
    bool exists; /* false: p̄ >= H, complete contact, which a hardness does not define; no number then */
    struct direct_quantities quantities;
    double constriction_m; /* NaN where not asked for. The mean gap falls by 2 constriction_m per p̄/E' if elastic */
    size_t patches;        /* connected ones of contact */
    size_t convolutions;
};

/** The quantities that are averaged. */
enum direct_quantity { DIRECT_AREA, DIRECT_GAP, DIRECT_CONSTRICTION, DIRECT_PATCHES, DIRECT_QUANTITIES };
double direct_point_value(const struct direct_point *point, enum direct_quantity quantity);

/** Solves every load of the ladder: `loads` points. Errors: those of the solutions. */
MUST_CHECK enum status_code direct_ladder_run(struct direct_point *out, struct direct_contact *contact,
                                              const struct direct_ladder_def *def, struct status *status);

#endif
