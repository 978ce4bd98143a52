/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/costs.h"

/* Processor time of `report -v -j 1 --no-cost -m tin`, measured beside other work; but profile_point_s is of 10^7
 * points on a quiet machine, 16 s. Measure again where a solver changes. */
const struct costs costs = {
    .report_s = 0.25,           /* a scan of 1000 points, gnuplot's too */
    .surface_s = 1e-3,          /* 100 surfaces of 1000 points less one, without strips */
    .profile_point_s = 1.15e-6, /* 10^7 points less 10^6, whose strips are as long: reading, spectra, tables */
    .map_point_s = 0.4e-6,      /* `plan` of 1024 x 1024 points */
    .load_s = 3e-6,             /* 10 000 loads less 1000 */
    .transform_s = 12e-9,       /* stage `strips` of 10^4 and 10^5 points, over the evaluations of `area` */
    /* squares of 64 to 512 points a side take 270 side^(1/3) pairs of transforms, 125 of them without a hardness; the
     * stage `direct of maps` takes 1.6 transform_s for each of their points */
    .map_transforms_elastic = 200,
    .map_transforms = 232,
    .map_power = 1. / 3,
    .record_s = 1.3e-3, /* stage `uncertainty` without strips, of 1000 and of 16 000 points, a record */
    .record_point_s = 0.25e-6,
    .direct_s = 0.020, /* 0.009 to 0.022 on three surfaces, 64 ... 1024 points a side */
    .direct_power = 2.15,
};
