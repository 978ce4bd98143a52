/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A thin insulating film on the spots (equations: films). Holm 1967, Electric Contacts, 4th edition. */
#ifndef JOINT_FILM_H
#define JOINT_FILM_H

/** R A_n [ohm m²] of spots with a film of resistance `film_ohm_m2` (s_f) in series: each spot has rho/(2a) + s_f/(pi
 * a²), alike spots R_c A_n + s_f/(A/A_n). The film's resistance is never predicted: a tunnel resistance spans ten
 * decades within 1.5 nm. */
double film_resistance(double contact_ohm_m2, double film_ohm_m2, double area_ratio);

#endif
