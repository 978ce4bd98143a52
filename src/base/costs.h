/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rough times of the parts of a report on one core of 2020: for plans, budgets, and what is too dear to solve.
 * Processor time of `report -v -j 1 --no-cost -m tin`, measured beside other work; but profile_point_s is of 10^7
 * points on a quiet machine, 16 s. Measure again where a solver changes. */
#ifndef BASE_COSTS_H
#define BASE_COSTS_H

static const struct {
    double report_s, surface_s, profile_point_s, map_point_s, load_s, shape_s, transform_s, map_transforms_elastic,
        map_transforms, map_power, record_s, record_point_s, direct_s, direct_power, direct_map_point_s;
} costs = {
    .report_s = 0.25,           /* a scan of 1000 points, gnuplot's too */
    .surface_s = 1e-3,          /* 100 surfaces of 1000 points less one, without strips */
    .profile_point_s = 1.15e-6, /* 10^7 points less 10^6, whose strips are as long: reading, spectra, tables */
    .map_point_s = 0.4e-6,      /* `plan` of 1024 x 1024 points */
    .load_s = 3e-6,             /* a load of a model: 10 000 loads less 1000 */
    .shape_s = 0.06,     /* a model's curve with the parts' shape: thermal-interface's less those of flat parts */
    .transform_s = 8e-9, /* a point of a strip, there and back: stage `strips` of 10^4 and 10^5 points, over the
                            evaluations of `area` */
    /* transforms of a map's square, and those of a hardness besides: the stage `direct of maps` of squares of 256 and
     * 512 points a side over transform_s, their points, and side^(1/3), as which their number grows */
    .map_transforms_elastic = 150,
    .map_transforms = 80,
    .map_power = 1. / 3, /* of points a side that these grow as */
    .record_s = 1.3e-3,  /* a simulated record: stage `uncertainty` without strips, of 1000 and of 16 000 points */
    .record_point_s = 0.25e-6,
    .direct_s = 0.020,    /* a load of 256 x 256 points solved: 0.009 to 0.022 on three surfaces, 64 ... 1024 a side */
    .direct_power = 2.15, /* how it grows with the points a side */
    .direct_map_point_s = 0.45e-6, /* a point of a map at a load: 0.3e-6 to 0.65e-6 on 15 maps, 80 ... 400 a side */
};

#endif
