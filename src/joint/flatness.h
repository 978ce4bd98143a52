/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What parts whose flatness is not known may cost, at one load, by the pressures over their nominal area (shape.h). */
#ifndef JOINT_FLATNESS_H
#define JOINT_FLATNESS_H

#include "joint/joint.h"

/** Bulge over length of a good ground or lapped part: 1 um over 10 mm. Drawings ask for less: 50 um over 100 mm under
 * power modules (Fuji Electric, heat sink flatness), 50 um over 30 mm by ISO 2768-2 H. */
extern const double flatness_usual;

/** The factor by which a bulge of flatness_usual over the side of a square nominal area multiplies the resistance, of
 * JOINT_WAYS; the curve, which is the law in its cells, has its own points. NaN: not known, as where the curve ends
 * below the local pressures, or there is no memory. */
double flatness_factor(const struct model_curve *curve, const struct model_row *row, const struct joint_task *joint,
                       double load, int way);

#endif
