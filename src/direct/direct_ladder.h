/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One surface under rising loads, each solved from the solution before. */
#ifndef DIRECT_LADDER_H
#define DIRECT_LADDER_H

#include "direct/direct_quantities.h"

struct direct_ladder_def {
    const double *load; /* p̄/E', ascending */
    size_t loads;
    double hardness;  /* H/E'; INFINITY: elastic */
    double tolerance; /* of the contact; its root serves the constriction, which is good to the square of its own */
    bool resistance;
    const atomic_bool *stop; /* NULL: never */
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
