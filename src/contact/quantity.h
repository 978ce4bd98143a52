/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a model says of a contact: one row a quantity. Columns, charts, captions and comparisons all loop over this
 * table; what a chart calls it stands in templates/words.txt by its name. */
#ifndef CONTACT_QUANTITY_H
#define CONTACT_QUANTITY_H

#include "contact/effect.h"

/** Of a contact at one load, SI. */
enum quantity {
    QUANTITY_LOAD,       /* P/(A_n E') */
    QUANTITY_AREA,       /* A/A_n, 0...1 */
    QUANTITY_SEPARATION, /* mean gap (multiscale: H), or distance of the mean planes (statistical: delta) [m] */
    QUANTITY_ADJUSTED,   /* statistical: delta_ADJ (4.54) [m] */
    QUANTITY_ECR,        /* ECR A_n [ohm m²] */
    QUANTITY_TCR,        /* TCR A_n [K m²/W] */
    QUANTITY_TCR_SCALE_DEPENDENT, /* the same, scale-dependent */
    QUANTITY_ECR_LAST_SCALE,      /* multiscale: of the finest scale that is not complete, alone [ohm m²] */
    QUANTITY_STIFFNESS,           /* k = -dP/d separation, of the mean planes, per A_n [Pa/m] */
    QUANTITY_GAP,                 /* h_g: of what fills the gaps [W/(m² K)] */
    QUANTITY_JOINT,               /* h_j = 1/(TCR A_n) + h_g [W/(m² K)] */
    QUANTITY_SPOT_DENSITY,        /* of contact_spots, or of equal spots with the model's area and resistance [1/m²] */
    QUANTITY_SPOT_RADIUS,         /* [m] */
    QUANTITY_PLATING_FACTOR,      /* resistance of a spot with its plating over that without */
    QUANTITY_JOINT_ECR,           /* ECR A_n with plating and film [ohm m²] */
    QUANTITY_VOLTAGE,             /* over the contact [V] */
    QUANTITY_TEMPERATURE,         /* of the hottest place [K] */
    QUANTITY_COUNT
};

/** Contact at one load. What was not wanted, or what a model does not compute, is NaN: see quantity_nothing(). */
struct contact_point {
    double value[QUANTITY_COUNT];
    double beyond_fit;     /* share of the load on asperities beyond the law's fitted range, 0...1 (JG), else 0 */
    double radius_clamped; /* share of the load on asperities whose a/R is clamped to 1 (JG), else 0 */
};

/** The spots that make up a contact at one load, each as round; NaN: the model has no answer there. Both depend on how
 * finely the surface was measured: finer scans have more and smaller spots. */
struct contact_spots {
    double density_per_m2; /* n: of them in an area S there are n S */
    double radius_m;       /* a, mean over the area of contact */
};

/** Bit of a quantity in a set of quantities. */
#define QUANTITY_BIT(quantity) (1u << (quantity))

/** The resistances. */
enum {
    QUANTITY_RESISTANCES =
        QUANTITY_BIT(QUANTITY_ECR) | QUANTITY_BIT(QUANTITY_TCR) | QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT)
};

struct quantity_row {
    const char *name;         /* in results.json, with its SI unit */
    const char *column;       /* in data/; NULL: only as a multiple of sigma */
    const char *sigma_column; /* of a length that is shown as a multiple of sigma, in data/; NULL: none */
    const char *symbol;       /* as tables and captions print it: "ECR·Aₙ" */
    const char *short_symbol; /* in running text: "ECR" */
    const char *unit;         /* as printed, "" for a ratio; lengths are printed as multiples of sigma */
    unsigned effect;          /* EFFECT_BITs that it belongs to, any of them; 0: every run has it */
    unsigned from;            /* QUANTITY_BITs that it is made of once a model has run; 0: the model computes it */
    bool logarithmic;         /* axis */
};

extern const struct quantity_row quantity_rows[]; /* QUANTITY_COUNT */

/** A quantity as tables and charts show it: a length as a multiple of sigma_m. */
double quantity_shown(const struct contact_point *point, enum quantity quantity, double sigma_m);
/** Its name, with the SI unit or as a multiple of sigma. */
const char *quantity_shown_name(enum quantity quantity);
/** QUANTITY_BITs of all quantities that a set of EFFECT_BITs calls for. */
unsigned quantity_wanted(unsigned effects);
/** QUANTITY_BITs `computed` by a model, with those that are made of them. */
unsigned quantity_with_made(unsigned computed);

/** A point of which nothing is known: every quantity NaN, the shares 0. */
struct contact_point quantity_nothing(void);

#endif
