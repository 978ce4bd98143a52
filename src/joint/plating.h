/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A plating under the spots (equations: platings). */
#ifndef JOINT_PLATING_H
#define JOINT_PLATING_H

/** Resistance of the plated side of a spot of radius a over that of a body of plating alone, rho_1/(4a): 1 + (4/pi)
 * sum_{n>=1} Q^n [atan(1/(nT)) - (nT/2) ln(1 + 1/(nT)²)], T = thickness/a, Q = (rho_2-rho_1)/(rho_2+rho_1), rho_1 the
 * plating's and rho_2 the body's resistivity. From the flux of a spot on a uniform body, hence an upper bound
 * (Thomson's principle); exact for T = 0, rho_2/rho_1, and T = infinity, 1. */
double plating_factor(double thickness_over_radius, double plating_resistivity, double body_resistivity);

#endif
