/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The quantities of a contact: one row each. Columns, charts, tables, targets and comparisons loop over these rows; the
 * words of charts are in templates/words.txt, by the quantity's name. */
#ifndef CONTACT_QUANTITY_H
#define CONTACT_QUANTITY_H

#include "contact/effect.h"
#include "material/material.h"

/** Quantities of a contact at one load, SI. */
enum quantity {
    QUANTITY_LOAD,       /* P/(A_n E') */
    QUANTITY_AREA,       /* A/A_n, 0...1 */
    QUANTITY_SEPARATION, /* mean gap (multiscale: H), or distance of the mean planes (statistical: delta) [m] */
    QUANTITY_ADJUSTED,   /* statistical: delta_ADJ (4.54) [m] */
    QUANTITY_ECR,        /* ECR A_n [ohm m²] */
    QUANTITY_TCR,        /* TCR A_n [K m²/W] */
    QUANTITY_TCR_SCALE_DEPENDENT, /* the same, scale-dependent */
    QUANTITY_ECR_LAST_SCALE,      /* multiscale: ECR A_n of the finest open scale alone [ohm m²] */
    QUANTITY_STIFFNESS,           /* k = -dP/d separation, of the mean planes, per A_n [Pa/m] */
    QUANTITY_GAP,                 /* h_g: of what fills the gaps [W/(m² K)] */
    QUANTITY_JOINT,               /* h_j = 1/(TCR A_n) + h_g [W/(m² K)] */
    QUANTITY_SPOT_DENSITY,        /* of contact_spots, or of equal spots with the model's area and resistance [1/m²] */
    QUANTITY_SPOT_RADIUS,         /* [m] */
    QUANTITY_PLATING_FACTOR,      /* resistance of a spot with its plating over that without */
    QUANTITY_JOINT_ECR,           /* ECR A_n with plating and film [ohm m²] */
    QUANTITY_SHAPE_JOINT,         /* h of the whole nominal area with the parts' shape [W/(m² K)] */
    QUANTITY_SHAPE_ECR,           /* ECR A_n of it [ohm m²] */
    QUANTITY_VOLTAGE,             /* over the contact [V] */
    QUANTITY_TEMPERATURE,         /* of the hottest place [K] */
    QUANTITY_MEAN_GAP,            /* the separation, with an interval of its own [m] */
    QUANTITY_COUNT
};

/** Contact at one load. Quantities not wanted or not computed are NaN. */
struct contact_point {
    double value[QUANTITY_COUNT];
    double beyond_fit;     /* share of the load on asperities beyond the law's fitted range, 0...1 (JG), else 0 */
    double radius_clamped; /* share of the load on asperities whose a/R is clamped to 1 (JG), else 0 */
};

/** Round contact spots at one load; NaN: no answer. They depend on the resolution of the scan: finer scans have more
 * and smaller spots. */
struct contact_spots {
    double density_per_m2; /* n */
    double radius_m;       /* a, mean over the area of contact */
};

/** Bit of a quantity in a set of quantities. */
#define QUANTITY_BIT(quantity) (1u << (quantity))

/** The resistances, and the quantities of every model. */
enum {
    QUANTITY_RESISTANCES =
        QUANTITY_BIT(QUANTITY_ECR) | QUANTITY_BIT(QUANTITY_TCR) | QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT),
    QUANTITY_USUAL = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_SEPARATION) |
                     QUANTITY_BIT(QUANTITY_STIFFNESS) | QUANTITY_BIT(QUANTITY_ECR) | QUANTITY_BIT(QUANTITY_TCR)
};

/** Unit of print: number = scale times the SI value (of a length: its multiple of sigma) less the offset. */
struct quantity_unit {
    const char *unit;
    double scale; /* 0: no unit */
    double offset;
};

/** A scene key of targets and limits. Of several quantities with one key, the last whose effect runs is meant: that of
 * the whole joint. */
struct quantity_asked {
    const char *key;          /* NULL: none */
    const char *symbol;       /* in running text */
    unsigned total, per_area; /* enum unit_quantity bits: of the whole contact (0: none), and per area as in models */
    double least, most;       /* SI */
    bool reciprocal;          /* the key is 1/quantity */
};

/** A chart with a panel per model. */
struct quantity_panel {
    const char *file; /* figure of all surfaces; "": none; NULL: no panel at all */
    enum quantity against;
    int number; /* of the baseline's panel in chapter 6; 0: none */
    int first;  /* number of the first of the four of all surfaces; 0: none */
};

/** The quantity from a direct solution: a mean times a factor. */
struct quantity_solved {
    const char *column; /* in direct.csv; NULL: none */
    const char *ratio;  /* column in direct_ratio.csv, and of its error in direct.csv; NULL: in neither */
    int mean;           /* of direct_ensemble.h */
    double (*factor)(const struct material_pair *pair, double mean); /* NULL: 1 */
    bool elastic;                                                    /* of wholly elastic contact only */
};

/** Properties of a quantity: bits. */
enum {
    QUANTITY_LINEAR = 1,      /* arithmetic mean and linear axis, else geometric and logarithmic */
    QUANTITY_RISES = 2,       /* with the load: more is better */
    QUANTITY_ENDS = 4,        /* 0 or infinite at full contact: charts stop before */
    QUANTITY_BANDED = 8,      /* has an interval */
    QUANTITY_SIGMA_ALONE = 16 /* in data/ only as a multiple of sigma */
};

/** Whose error the quantity has: that of area, gap or resistance. */
enum quantity_follows { FOLLOWS_NOTHING, FOLLOWS_AREA, FOLLOWS_GAP, FOLLOWS_RESISTANCE, FOLLOWS_COUNT };

struct quantity_row {
    const char *name;         /* in results.json and data/, with its SI unit */
    const char *short_symbol; /* in running text: "ECR" */
    const char *unit;         /* SI, "" for a ratio */
    unsigned effect;          /* EFFECT_BITs, any of which asks for it; 0: in every run */
    unsigned from;            /* QUANTITY_BITs it is computed from after a model has run; 0: the model computes it */
    unsigned is;              /* the bits above */
    enum quantity_follows follows;
    const char *sigma_column;   /* column in data/ of a length as a multiple of sigma; NULL: none */
    struct quantity_unit shown; /* in tables and charts; none: SI */
    struct quantity_unit handy; /* in `compare`; none: left out */
    double at_full;             /* value at full contact, if a model computes it */
    int precedence;             /* the greatest is the one asked for by default, and (if a model computes it) the one
                                   that surfaces are ranked by; 0: never */
    struct quantity_asked asked[2];
    struct quantity_panel panels[2];
    enum quantity dotted; /* drawn with it, dotted; QUANTITY_LOAD: none */
    const char *note;     /* of a chart, from figure_notes; NULL: none */
    struct quantity_solved solved;
    /** Computes it from the others. NULL: a model or joint/ does. */
    double (*derive)(const double value[QUANTITY_COUNT], const struct material_pair *pair);
};

extern const struct quantity_row quantity_rows[]; /* QUANTITY_COUNT */

/** Does joint/ compute it? */
bool quantity_of_joint(enum quantity quantity);
/** Its unit in tables and charts. */
struct quantity_unit quantity_unit(enum quantity quantity);
/** Its value in tables and charts: a length as a multiple of sigma_m. */
double quantity_shown(const struct contact_point *point, enum quantity quantity, double sigma_m);
/** Its name there. */
const char *quantity_shown_name(enum quantity quantity);
/** The quantity of greatest precedence in a set of QUANTITY_BITs. */
enum quantity quantity_first(unsigned quantities);
/** The quantity of a scene key, given the EFFECT_BITs called for; QUANTITY_COUNT: no such key. *how NULL: it needs an
 * effect that is not called for. */
enum quantity quantity_of_key(const struct quantity_asked **how, const char *key, unsigned called);
/** QUANTITY_BITs that a set of EFFECT_BITs calls for. */
unsigned quantity_wanted(unsigned effects);
/** QUANTITY_BITs `computed` by a model and those computed from them. */
unsigned quantity_with_made(unsigned computed);

/** A point without answers: every quantity NaN, the shares 0. */
struct contact_point quantity_nothing(void);

#endif
