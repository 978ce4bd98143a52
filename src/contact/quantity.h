/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a model says of a contact: one row a quantity, with all there is to know of it. Columns, charts, tables, targets
 * and comparisons walk over these rows; what a chart calls it stands in templates/words.txt by its name. */
#ifndef CONTACT_QUANTITY_H
#define CONTACT_QUANTITY_H

#include "contact/effect.h"
#include "material/material.h"

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
    QUANTITY_SHAPE_JOINT,         /* h of the whole nominal area with the parts' shape [W/(m² K)] */
    QUANTITY_SHAPE_ECR,           /* ECR A_n of it [ohm m²] */
    QUANTITY_VOLTAGE,             /* over the contact [V] */
    QUANTITY_TEMPERATURE,         /* of the hottest place [K] */
    QUANTITY_MEAN_GAP,            /* the separation, with an interval of its own [m] */
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

/** The resistances, and what every model computes. */
enum {
    QUANTITY_RESISTANCES =
        QUANTITY_BIT(QUANTITY_ECR) | QUANTITY_BIT(QUANTITY_TCR) | QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT),
    QUANTITY_USUAL = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_SEPARATION) |
                     QUANTITY_BIT(QUANTITY_STIFFNESS) | QUANTITY_BIT(QUANTITY_ECR) | QUANTITY_BIT(QUANTITY_TCR)
};

/** What a number is printed in: scale times the SI number (of a length: of the multiple of sigma) less an offset. */
struct quantity_unit {
    const char *unit;
    double scale; /* 0: there is no such unit */
    double offset;
};

/** A key of the scene's targets and limits that stands for a quantity. Of several quantities with one key the last that
 * the scene calls for is meant: that of the whole joint. */
struct quantity_asked {
    const char *key;          /* NULL: none */
    const char *symbol;       /* in running text */
    unsigned total, per_area; /* enum unit_quantity bits: of the whole contact (0: not so), and as the models have it */
    double least, most;       /* SI */
    bool reciprocal;          /* it is 1/quantity */
};

/** A panel of the quantity in every model. */
struct quantity_panel {
    const char *file; /* figure of all surfaces, a panel a model; "": none; NULL: no panel at all */
    enum quantity against;
    int number; /* of the baseline's panel in chapter 6; 0: it is not there */
    int first;  /* of the four of all surfaces; 0: the same */
};

/** How a direct solution has the quantity: a mean of its, times a factor. */
struct quantity_solved {
    const char *column; /* in direct.csv; NULL: it has not */
    const char *ratio;  /* in direct_ratio.csv, and of its error in direct.csv; NULL: in neither */
    int mean;           /* of direct_ensemble.h */
    double (*factor)(const struct material_pair *pair, double mean); /* NULL: 1 */
    bool elastic;                                                    /* only of a contact that is elastic throughout */
};

/** What a quantity is: bits. */
enum {
    QUANTITY_LINEAR = 1,      /* else its mean is geometric, its axis logarithmic */
    QUANTITY_RISES = 2,       /* with the load: more of it is better */
    QUANTITY_ENDS = 4,        /* at full contact it is 0 or infinite: charts stop before */
    QUANTITY_BANDED = 8,      /* it is known with an interval */
    QUANTITY_SIGMA_ALONE = 16 /* data/ has it as a multiple of sigma only */
};

/** Which of what a model is off by, or a scan leaves open, changes the quantity: the factor of area, gap or resistance.
 */
enum quantity_follows { FOLLOWS_NOTHING, FOLLOWS_AREA, FOLLOWS_GAP, FOLLOWS_RESISTANCE, FOLLOWS_COUNT };

struct quantity_row {
    const char *name;         /* in results.json and data/, with its SI unit */
    const char *short_symbol; /* in running text: "ECR" */
    const char *unit;         /* SI, "" for a ratio */
    const char *meaning;      /* in docs/report.md */
    unsigned effect;          /* EFFECT_BITs that it belongs to, any of them; 0: every run has it */
    unsigned from;            /* QUANTITY_BITs that it is made of once a model has run; 0: the model computes it */
    unsigned is;              /* the bits above */
    enum quantity_follows follows;
    const char *sigma_column;   /* of a length that is shown as a multiple of sigma, in data/; NULL: none */
    struct quantity_unit shown; /* tables and charts have it in that; none: SI */
    struct quantity_unit handy; /* `compare` does; none: it leaves it out */
    double at_full;             /* of what the model computes: where contact is full */
    int precedence;             /* where nothing is asked, the computed one of the greatest is; of those that models
                                   compute, surfaces are ranked by it; 0: never */
    struct quantity_asked asked[2];
    struct quantity_panel panels[2];
    enum quantity dotted; /* drawn beside it; QUANTITY_LOAD: none */
    const char *note;     /* that a chart has of it, of figure_notes; NULL: none */
    struct quantity_solved solved;
    /** Makes it of the others. NULL: the model computes it, or joint/ makes it. */
    double (*derive)(const double value[QUANTITY_COUNT], const struct material_pair *pair);
};

extern const struct quantity_row quantity_rows[]; /* QUANTITY_COUNT */

/** Made by an effect of what lies in the joint? */
bool quantity_of_joint(enum quantity quantity);
/** What tables and charts have it in. */
struct quantity_unit quantity_unit(enum quantity quantity);
/** A quantity as tables and charts show it: a length as a multiple of sigma_m. */
double quantity_shown(const struct contact_point *point, enum quantity quantity, double sigma_m);
/** Its name, with the SI unit or as a multiple of sigma. */
const char *quantity_shown_name(enum quantity quantity);
/** Of a set of quantities (QUANTITY_BITs) the one of the greatest precedence. */
enum quantity quantity_first(unsigned quantities);
/** The quantity that a key stands for where the scene calls for these EFFECT_BITs, and *how: it needs an effect that is
 * not called for where that is NULL; QUANTITY_COUNT: no such key. */
enum quantity quantity_of_key(const struct quantity_asked **how, const char *key, unsigned called);
/** QUANTITY_BITs of all quantities that a set of EFFECT_BITs calls for. */
unsigned quantity_wanted(unsigned effects);
/** QUANTITY_BITs `computed` by a model, with those that are made of them. */
unsigned quantity_with_made(unsigned computed);

/** A point of which nothing is known: every quantity NaN, the shares 0. */
struct contact_point quantity_nothing(void);

#endif
