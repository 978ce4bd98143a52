/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Materials: the built-in table and the pair of them that a contact is made of (docs/equations.md, Material). */
#ifndef MATERIAL_MATERIAL_H
#define MATERIAL_MATERIAL_H

#include "base/status.h"
#include "base/unit.h"

/** A metal, or a gap filler that bears no load (E not known). Unknown properties are NaN. */
struct material {
    char name[64];
    double youngs_modulus_Pa;       /* E */
    double poisson_ratio;           /* nu */
    double yield_strength_Pa;       /* S_y */
    double resistivity_ohm_m;       /* rho_L */
    double conductivity_W_per_mK;   /* k */
    double density_kg_per_m3;       /* rho */
    double specific_heat_J_per_kgK; /* c_p, per unit mass */
    double sound_speed_m_per_s;     /* v_s */
    const char *source;             /* where the numbers are from; a constant of the program */
    double hardness_Pa;             /* H; NaN: 2.84 S_y */
    double mean_free_path_m;        /* of what carries the heat; NaN: 3k/(density v_s c_p) */
    double electrons_per_m3;        /* free ones; 0: not known */
    const char *aliases;            /* of a built-in one, with commas between; NULL: none */
};

/** A property: drives scene keys, the `materials` command and range checks. */
struct material_property {
    const char *key;    /* in tables and results.json, and a scene key: E_Pa, nu, Sy_Pa, ... */
    const char *name;   /* the scene key without unit: E, nu, Sy, ...; the same where there is none */
    const char *symbol; /* E, ν, S_y, ... */
    const char *unit;   /* Pa, Ω·m, ... ("" for a ratio) */
    const char *meaning;
    size_t offset;      /* of the double in struct material */
    double least, most; /* allowed range, inclusive */
    enum unit_quantity quantity;
    bool optional; /* has a default: shown only where given */
};

extern const struct material_property material_properties[];
extern const size_t material_property_count;
extern const struct material material_table[];
extern const size_t material_table_count;

/** The built-in material of that name or alias (CuSn6, C17200; case-insensitive); NULL: none. */
const struct material *material_find(const char *name);
/** A material with every property NaN and the given name. */
struct material material_unknown(const char *name);
/** The row of that key (E_Pa); NULL: none. */
const struct material_property *material_property_find(const char *key);
/** Value of a property row in a material. */
double material_value(const struct material *material, const struct material_property *property);

enum material_counterface {
    MATERIAL_COUNTERFACE_RIGID,   /* a rigid flat that conducts like the material */
    MATERIAL_COUNTERFACE_ELASTIC, /* a second elastic body */
};

/** The two bodies together. A quantity whose properties are missing is NaN. */
struct material_pair {
    bool unknown;                        /* no material given: E' = 1, so that pressures are P/(A_n E') */
    double effective_modulus_Pa;         /* E': E/(1-nu²), or 1/E' = (1-nu1²)/E1 + (1-nu2²)/E2 */
    double yield_strength_Pa;            /* S_y of the softer body */
    double poisson_ratio;                /* nu of the softer body */
    double hardness_Pa;                  /* H of the softer body: as given, else 2.84 S_y */
    double vickers_Pa, vickers_exponent; /* H = c1 (d/1 um)^c2 of an indentation of diagonal d; c1 0: not given */
    double yield_coefficient;            /* C = 1.295 exp(0.736 nu) */
    double resistivity_ohm_m;            /* (rho1 + rho2)/2 */
    double conductivity_W_per_mK;        /* 2 k1 k2/(k1 + k2) */
    double mean_free_path_m[2];          /* lambda_mfp of each side: as given, else 3k/(density v_s c_p) (4.52) */
    double side_conductivity_W_per_mK[2];
    double side_resistivity_ohm_m[2];
};

/** 2.84: hardness over yield strength without hardening: Tabor 1951; Jackson and Green 2005 (H_G at a -> 0). */
extern const double material_hardness_ratio;

/** H [Pa] of one body: as given, else 2.84 S_y. */
double material_hardness(const struct material *material);

/** Combines `material` with its counterface (`other` only for MATERIAL_COUNTERFACE_ELASTIC). The softer body has the
 * lower yield strength. Source: docs/equations.md, Material; thesis (4.14), (4.52). */
struct material_pair material_pair(const struct material *material, enum material_counterface kind,
                                   const struct material *other);

/** The pair without a material: E' = 1, all else NaN. Elastic models, with loads as P/(A_n E'), then hold for any
 * material. */
struct material_pair material_pair_unknown(void);

/** P/A_n [Pa] at P/(A_n E') = load; NaN where no material is given. */
double material_pair_pressure(const struct material_pair *pair, double load);

/** Mean free path of electrons in a metal, l = (rho l)/rho [m], rho l = hbar (3 pi²)^(1/3)/(e² n^(2/3)) of n free
 * electrons per m³ (Drude's formula, spherical Fermi surface; Ashcroft and Mermin 1976, Solid State Physics). In a
 * metal electrons carry the heat; (4.52) is for phonons. */
double electron_mean_free_path(double density_per_m3, double resistivity_ohm_m);

#endif
