/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What lies in and around the spots of a contact, added to a model's curve point by point (equations: gas in the gaps,
 * films, platings, heating). */
#ifndef JOINT_JOINT_H
#define JOINT_JOINT_H

#include "contact/model.h"
#include "joint/gas.h"
#include "joint/shape.h"
#include "joint/shape_field.h"
#include "material/material.h"

enum joint_fill {
    JOINT_VACUUM,
    JOINT_GAS,   /* with its temperature jump */
    JOINT_MEDIUM /* grease: conducts to the walls */
};

/** A plating or filler that goes by name; of each the first is none. */
struct joint_layer {
    double value;           /* a plating's resistivity [ohm m], a filler's conductivity [W/m/K] */
    double least_m, most_m; /* usual thickness */
    double hardness_Pa;     /* of a plating as deposited; 0: it is none */
    const char *source;     /* what was read, and what is unchecked */
};
enum { JOINT_PLATINGS = 6, JOINT_FILLERS = 5 };
extern const char *const joint_plating_names[JOINT_PLATINGS], *const joint_filler_names[JOINT_FILLERS];
extern const struct joint_layer joint_platings[JOINT_PLATINGS], joint_fillers[JOINT_FILLERS];

/** A joint; a member counts when its effect is called for. */
struct joint {
    enum joint_fill fill;
    const struct gas *gas; /* or the liquid of a medium; NULL: neither */
    double pressure_Pa, accommodation;
    double conductivity_W_per_mK; /* of a medium */
    double bond_line_m;           /* least thickness of a medium; 0: that of the gaps */
    unsigned filler, plating;     /* which by name */
    double temperature_K;         /* of the joint */
    double film_ohm_m2;
    double plating_thickness_m, plating_ohm_m;
    unsigned both_plated; /* 1: both bodies; 0: the first, which is the surface's */
    double current_A;
    double bulge_per_m;         /* gap of the unloaded parts over the square of the distance from the middle; 0: flat */
    double size_m[2];           /* of the nominal area; 0: not given */
    double thickness_m[2];      /* of the parts; INFINITY: half spaces */
    struct shape_field *fields; /* in place of the bulge, of rising load; owned by the scene */
    size_t field_count;
    bool pressed; /* they are pressures, not the gap of the unloaded parts */
};

/** What the parts' shape makes of one model on one surface, over ln P/(A_n E'): heat, with the gaps; current, with
 * plating and film. Owned: joint_shape_free(). */
enum { JOINT_HEAT, JOINT_CURRENT, JOINT_WAYS, JOINT_RINGS = 48 };
struct joint_shape {
    struct shape_curve flat[JOINT_WAYS];  /* resistance of flat parts, [m²K/W] or [ohm m²] */
    struct shape_curve over[JOINT_WAYS];  /* that with the shape, over it */
    struct shape_curve spots[JOINT_WAYS]; /* the spots' share of that */
    struct shape_curve area;              /* share of the nominal area that carries 90 % of the load */
    double least, most;                   /* loads within which it is known */
    double ring_Pa[JOINT_RINGS];          /* mean pressures at the operating load, from the middle to the corners */
};
void joint_shape_free(struct joint_shape *shape);
/** The share of the nominal area that carries 90 % of the load; NaN: not known. */
double joint_shape_area(const struct joint_shape *shape, double load);
/** The factor by which the resistance changes where that of flat parts does so by `factor`; NaN: not known. `shape`: or
 * NULL. */
double joint_shape_change(const struct joint_shape *shape, double load, int way, double factor);

/** 300 K, at which the table of gases holds. */
struct joint joint_default(void);

struct joint_task {
    const struct joint *joint;
    const struct material_pair *pair;
    double sigma_m;
    double nominal_area_m2;
    unsigned effects;                 /* EFFECT_BITs that run */
    double tolerance;                 /* relative, of the integral over the gaps */
    const struct joint_shape *shapes; /* of every model; NULL: the parts are flat, or it is not known yet */
};

/** Spots, all alike, that have the model's area and resistance between them: n pi a² = A/A_n and n 2a/rho = 1/(ECR
 * A_n), so a = 2 (A/A_n)(ECR A_n)/(pi rho). NaN beyond joint_independent_area. */
struct contact_spots joint_equal_spots(double area_ratio, double ecr_ohm_m2, double resistivity_ohm_m);

/** R A_n [ohm m²] of spots with a film of resistance `film_ohm_m2` (s_f) in series: each spot has rho/(2a) + s_f/(pi
 * a²), alike spots R_c A_n + s_f/(A/A_n) (Holm 1967, Electric Contacts, 4th edition). The film's resistance is never
 * predicted: a tunnel resistance spans ten decades within 1.5 nm. */
double joint_film(double contact_ohm_m2, double film_ohm_m2, double area_ratio);

/** Is there a filler with a bond line? */
bool joint_has_bond_line(const struct joint_task *task);
/** Does a filler's bond line t hold the mean planes apart at a point, which is then the metal's at a gap of t? */
bool joint_is_held(const struct contact_point *point, const struct joint_task *task);
/** Where the metal's own gap is less than the bond line t of what fills it, a rigid layer of t bears the rest of the
 * load: from where the curve's gap passes t on, what touches stays as it was there (straight in the logarithms between
 * two loads); where it is less from the first load on, no metal touches: area 0, resistances infinite, h = k/t. Gap: t;
 * stiffness and what else the model knows: NaN. Points of rising load; those that are held already stay as they are. */
void joint_hold(struct contact_point *points, size_t count, const struct joint_task *task);

/** Fills the quantities that are made of the model's (quantity_row.from) and that the effects call for, or none.
 * `spots`: the model's, one a point; NULL: it has none, so equal ones. `model`: that whose shape counts; NULL: none.
 * What is not finite is NaN. */
void joint_apply(struct contact_point *points, const struct contact_spots *spots, size_t count,
                 const struct joint_task *task, const struct model_row *model);

/** Of a point, the resistance that its spots and gaps have between them, of JOINT_WAYS. */
double joint_resistance(const double *value, const struct joint_task *task, int way);

/** Of standard deviations `sd` of the logarithm of what a model computes, those of what the joint makes of it: of all
 * together, as on a rougher surface, with less area, a wider gap and more resistance. */
void joint_carry_sd(double sd[QUANTITY_COUNT], const struct contact_point *point, const struct model_row *row,
                    const struct joint_task *task);
/** Standard deviations of the logarithm of all quantities at a point that come of the model's own error
 * (model_surface_sd(), of a plastic area what bearing_area() makes of it, and bearing_area_sd; joint_carry_sd()). 0:
 * not counted in; what is NaN there is not known. */
void joint_model_sd(double out[QUANTITY_COUNT], const struct contact_point *point, const struct model_row *row,
                    const struct joint_task *task, struct scans_reach reach);

/** The least and the most that physics allows at a point of a model with a hardness H, 0: anything. Area: at least P/H,
 * as nothing bears more. Resistance: at most that of one spot of the area P/H of all, (rho_1 + rho_2)/(4a), pi a² = P/H
 * (Holm 1967), where the nominal area is known; what the joint makes of a resistance follows it. */
void joint_bounds(double out[QUANTITY_COUNT][2], const struct contact_point *point, const struct model_row *row,
                  const struct joint_task *task);

/** T_max [K] at a voltage over the contact. */
double joint_temperature(const struct joint_task *task, double voltage_V);

/** Adds to `curve`, of `row` at the loads of `task`, what the joint's effects make of it: joint_apply() with the spots
 * of the model, which are those of the task's one surface. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code joint_curve(struct model_curve *curve, const struct model_row *row,
                                        const struct model_task *task, const struct joint_task *joint,
                                        struct status *status);

#endif
