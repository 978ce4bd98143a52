/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What lies in and around the spots of a contact, added to a model's curve point by point (equations: gas in the gaps,
 * films, platings, heating). */
#ifndef JOINT_JOINT_H
#define JOINT_JOINT_H

#include "contact/model.h"
#include "joint/gas.h"
#include "material/material.h"

enum joint_fill {
    JOINT_VACUUM,
    JOINT_GAS,   /* with its temperature jump */
    JOINT_MEDIUM /* grease: conducts to the walls */
};

/** A joint; a member counts when its effect is called for. */
struct joint {
    enum joint_fill fill;
    const struct gas *gas;
    double pressure_Pa, accommodation;
    double conductivity_W_per_mK; /* of a medium */
    double temperature_K;         /* of the joint */
    double film_ohm_m2;
    double plating_thickness_m, plating_ohm_m;
    unsigned both_plated; /* 1: both bodies; 0: the first, which is the surface's */
    double current_A;
};

/** 300 K, at which the table of gases holds. */
struct joint joint_default(void);

struct joint_task {
    const struct joint *joint;
    const struct material_pair *pair;
    double sigma_m;
    double nominal_area_m2;
    unsigned effects; /* EFFECT_BITs that run */
    double tolerance; /* relative, of the integral over the gaps */
};

/** Spots, all alike, that have the model's area and resistance between them: n pi a² = A/A_n and n 2a/rho = 1/(ECR
 * A_n), so a = 2 (A/A_n)(ECR A_n)/(pi rho). NaN beyond joint_independent_area. */
struct contact_spots joint_equal_spots(double area_ratio, double ecr_ohm_m2, double resistivity_ohm_m);

/** R A_n [ohm m²] of spots with a film of resistance `film_ohm_m2` (s_f) in series: each spot has rho/(2a) + s_f/(pi
 * a²), alike spots R_c A_n + s_f/(A/A_n) (Holm 1967, Electric Contacts, 4th edition). The film's resistance is never
 * predicted: a tunnel resistance spans ten decades within 1.5 nm. */
double joint_film(double contact_ohm_m2, double film_ohm_m2, double area_ratio);

/** Fills what the effects call for: quantities that are made of the model's (quantity_row.from). `spots`: the model's,
 * one a point; NULL: it has none, so equal ones. What is not finite is NaN. */
void joint_apply(struct contact_point *points, const struct contact_spots *spots, size_t count,
                 const struct joint_task *task);

/** Adds to `curve`, of `row` at the loads of `task`, what the joint's effects make of it: joint_apply() with the spots
 * of the model, which are those of the task's one surface. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code joint_curve(struct model_curve *curve, const struct model_row *row,
                                        const struct model_task *task, const struct joint_task *joint,
                                        struct status *status);

#endif
