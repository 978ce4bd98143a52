/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gas, films, platings, heating and the shape of the parts, added to a model's curve point by point (equations: gas in
 * the gaps, films, platings, heating). */
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
    JOINT_MEDIUM /* grease: no temperature jump */
};

/** A plating or filler that has a name; the first of each table is none. */
struct joint_layer {
    double value;           /* resistivity of a plating [ohm m], conductivity of a filler [W/m/K] */
    double least_m, most_m; /* usual thickness */
    double hardness_Pa;     /* of a plating as deposited; 0: a filler */
    const char *source;     /* sources, and what is unchecked */
};
enum { JOINT_PLATINGS = 6, JOINT_FILLERS = 5 };
extern const char *const joint_plating_names[JOINT_PLATINGS], *const joint_filler_names[JOINT_FILLERS];
extern const struct joint_layer joint_platings[JOINT_PLATINGS], joint_fillers[JOINT_FILLERS];

/** A joint; a member counts when its effect runs. */
struct joint {
    enum joint_fill fill;
    const struct gas *gas; /* or the liquid of a medium; NULL: neither */
    double pressure_Pa, accommodation;
    double conductivity_W_per_mK; /* of a medium */
    double bond_line_m;           /* least thickness of a medium; 0: that of the gaps */
    unsigned filler, plating;     /* rows of joint_fillers, joint_platings */
    double temperature_K;
    double film_ohm_m2;
    double plating_thickness_m, plating_ohm_m;
    unsigned both_plated; /* 1: both bodies; 0: only the first, that of the surface */
    double current_A;
    double bulge_per_m;         /* gap of the unloaded parts over the square of the distance from the middle; 0: flat */
    double size_m[2];           /* of the nominal area; 0: not given */
    double thickness_m[2];      /* of the parts; INFINITY: half spaces */
    struct shape_field *fields; /* in place of the bulge, by rising load; owned by the scene */
    size_t field_count;
    bool pressed; /* the fields are pressures, not the gap of the unloaded parts */
};

/** What the shape of the parts does to one model on one surface, curves over ln P/(A_n E'): for heat, gaps included;
 * for current, plating and film included. Owned: joint_shape_free(). */
enum { JOINT_HEAT, JOINT_CURRENT, JOINT_WAYS, JOINT_RINGS = 48 };
struct joint_shape {
    struct shape_curve flat[JOINT_WAYS];  /* resistance of flat parts, [m²K/W] or [ohm m²] */
    struct shape_curve over[JOINT_WAYS];  /* resistance with the shape over that */
    struct shape_curve spots[JOINT_WAYS]; /* share of the spots in the resistance with the shape */
    struct shape_curve area;              /* share of the nominal area that carries 90 % of the load */
    double least, most;                   /* loads between which the curves are known */
    double ring_Pa[JOINT_RINGS];          /* mean pressures at the operating load, from the middle to the corners */
};
void joint_shape_free(struct joint_shape *shape);
/** The share of the nominal area that carries 90 % of the load; NaN: not known. */
double joint_shape_area(const struct joint_shape *shape, double load);

/** Air at 300 K and 101325 Pa, as in the table of gases. */
struct joint joint_default(void);

struct joint_task {
    const struct joint *joint;
    const struct material_pair *pair;
    double sigma_m;
    double nominal_area_m2;
    unsigned effects;                 /* EFFECT_BITs that run */
    double tolerance;                 /* relative, of the integral over the gaps */
    const struct joint_shape *shapes; /* one a model; NULL: the parts are flat, or not solved yet */
};

/** Equal spots with the area and the resistance of the model: n pi a² = A/A_n and n 2a/rho = 1/(ECR A_n), so a = 2
 * (A/A_n)(ECR A_n)/(pi rho). NaN above the area ratio up to which spots are independent, 0.1. */
struct contact_spots joint_equal_spots(double area_ratio, double ecr_ohm_m2, double resistivity_ohm_m);

/** Resistance of the plated side of a spot of radius a over rho_1/(4a), that of a body of the plating's metal: 1 +
 * (4/pi) sum_{n>=1} Q^n [atan(1/(nT)) - (nT/2) ln(1 + 1/(nT)²)], T = thickness/a, Q = (rho_2-rho_1)/(rho_2+rho_1),
 * resistivity rho_1 of the plating, rho_2 of the body. The flux is taken as that of a spot on a uniform body, so it is
 * an upper bound (Thomson's principle), exact for T = 0 (rho_2/rho_1) and T = infinity (1). */
double plating_factor(double thickness_over_radius, double plating_resistivity, double body_resistivity);

/** Is there a filler with a bond line? */
bool joint_has_bond_line(const struct joint_task *task);
/** Does the bond line of a filler hold the mean planes apart at this point? */
bool joint_is_held(const struct contact_point *point, const struct joint_task *task);
/** Where the gap of the bare metals would be less than the bond line t of the filler, a rigid layer of thickness t
 * bears the rest of the load. The gap is t, and area and resistances stay as they are where the curve passes t
 * (straight in logarithms between two loads); if no load has a gap above t, no metal touches: area 0, resistances
 * infinite, h = k/t. Other quantities of the model: NaN. Points by rising load; points that are held already stay as
 * they are. */
void joint_hold(struct contact_point *points, size_t count, const struct joint_task *task);

/** Fills the quantities that are derived from those of the model (quantity_row.from) and belong to no effect or one
 * that runs. `spots`: of the model, one a point; NULL: equal spots. `model`: whose shape to use; NULL: none. What is
 * not finite becomes NaN. */
void joint_apply(struct contact_point *points, const struct contact_spots *spots, size_t count,
                 const struct joint_task *task, const struct model_row *model);

/** Resistance of spots and gaps in parallel at a point of flat parts; way: of JOINT_WAYS. */
double joint_resistance(const double *value, const struct joint_task *task, int way);

/** From standard deviations `sd` of the logarithms of a model's quantities fills in those of what the joint derives
 * from them: all change together as on a rougher surface, with less area, a wider gap and more resistance. */
void joint_carry_sd(double sd[QUANTITY_COUNT], const struct contact_point *point, const struct model_row *row,
                    const struct joint_task *task);
/** Standard deviations of the logarithms of all quantities at a point due to the error of the model:
 * model_surface_sd(); of a plastic area what bearing_area() makes of the elastic one, and bearing_area_sd;
 * joint_carry_sd(). 0: not counted; NaN: not known. */
void joint_model_sd(double out[QUANTITY_COUNT], const struct contact_point *point, const struct model_row *row,
                    const struct joint_task *task, struct scans_reach reach);

/** Physical bounds {least, most} at a point of a model with a hardness H; 0: none. Area: at least P/H. Resistance: at
 * most that of one spot of area P/H, (rho_1 + rho_2)/(4a), pi a² = P/H (Holm 1967), where the nominal area is known;
 * with it the film's, a current's voltage and temperature, the joint's conductance without gaps. Gap: a bond line. */
void joint_bounds(double out[QUANTITY_COUNT][2], const struct contact_point *point, const struct model_row *row,
                  const struct joint_task *task);

/** T_max [K] at a voltage over the contact. */
double joint_temperature(const struct joint_task *task, double voltage_V);

/** joint_apply() on the curve of model `row` at the loads of `task`, with the spots of the model on the task's surface.
 * Error: STATUS_MEMORY. */
MUST_CHECK enum status_code joint_curve(struct model_curve *curve, const struct model_row *row,
                                        const struct model_task *task, const struct joint_task *joint,
                                        struct status *status);

#endif
