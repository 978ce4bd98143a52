/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A plating under the spots (equations: platings). */
#ifndef JOINT_PLATING_H
#define JOINT_PLATING_H

/** Resistance of the plated side of a spot of radius a over rho_1/(4a), that of a body of the plating's metal: 1 +
 * (4/pi) sum_{n>=1} Q^n [atan(1/(nT)) - (nT/2) ln(1 + 1/(nT)²)], T = thickness/a, Q = (rho_2-rho_1)/(rho_2+rho_1),
 * resistivity rho_1 of the plating, rho_2 of the body. The flux is taken as that of a spot on a uniform body, so it is
 * an upper bound (Thomson's principle), exact for T = 0 (rho_2/rho_1) and T = infinity (1). */
double plating_factor(double thickness_over_radius, double plating_resistivity, double body_resistivity);

#endif
