/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rough times of the parts of a report on one core of 2020: for plans, budgets, and what is too dear to solve. */
#ifndef BASE_COSTS_H
#define BASE_COSTS_H

struct costs {
    double report_s, surface_s, profile_point_s, map_point_s, load_s; /* a load of a model */
    double transform_s;                                               /* a point of a strip, there and back */
    double map_transforms_elastic, map_transforms; /* of a map's square, and those of a hardness besides, as strips' */
    double map_power;                              /* of points a side that these grow as */
    double record_s, record_point_s;               /* of simulated records */
    double direct_s, direct_power; /* a load of 256 x 256 points solved, and how it grows with the points a side */
};
extern const struct costs costs;

#endif
