/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "joint/flatness.h"

#include <math.h>
#include <stdlib.h>

enum { CELLS = 32 }; /* a side of a quarter of the area, the others being its mirror images */

const double flatness_usual = 1e-4;

double flatness_factor(const struct model_curve *curve, const struct model_row *row, const struct joint_task *joint,
                       double load, int way)
{
    const struct material_pair *pair = joint->pair;
    const double side_m[2] = {sqrt(joint->nominal_area_m2) / 2, sqrt(joint->nominal_area_m2) / 2};
    const double hardness_Pa = row->plastic ? pair->hardness_Pa : INFINITY,
                 mean_Pa = material_pair_pressure(pair, load);
    const double resistivity = way == JOINT_HEAT ? 1 / pair->conductivity_W_per_mK : pair->resistivity_ohm_m;
    const struct shape_body bodies[2] = {{resistivity, INFINITY}, {resistivity, INFINITY}};
    double *at = calloc(3 * curve->count + CELLS * CELLS, sizeof *at), factor = NAN, share, slope;
    if (!at)
        return NAN;
    double *gap_m = at + curve->count, *conductance = gap_m + curve->count, *bulge_m = conductance + curve->count;
    struct shape shape = {0};
    struct shape_curve gap = {0}, law = {0};
    struct status status = {0};
    size_t count = 0;
    for (size_t i = 0; i < curve->count; i++) {
        const double *value = curve->points[i].value;
        at[count] = material_pair_pressure(pair, value[QUANTITY_LOAD]);
        gap_m[count] = value[QUANTITY_SEPARATION];
        conductance[count] = 1 / joint_resistance(value, joint, way);
        count += value[QUANTITY_AREA] <= shape_largest_area && isfinite(gap_m[count]) && isfinite(conductance[count]) &&
                 conductance[count] > 0;
    }
    for (size_t k = 0; k < CELLS * CELLS; k++) /* from the middle, over a half of the side */
        bulge_m[k] = 2 * flatness_usual * side_m[0] *
                     (pow(((double)(k % CELLS) + 0.5) / CELLS, 2) + pow(((double)(k / CELLS) + 0.5) / CELLS, 2));
    if (mean_Pa < hardness_Pa && shape_make(&shape, CELLS, CELLS, side_m, &status) == STATUS_OK &&
        shape_curve_gap(&gap, at, gap_m, count, hardness_Pa, &status) == STATUS_OK &&
        shape_curve_conductance(&law, at, conductance, count, &status) == STATUS_OK &&
        shape_press(&shape, bulge_m, &gap, pair->effective_modulus_Pa, hardness_Pa, mean_Pa, &status) == STATUS_OK &&
        shape_resistance(&factor, &share, &shape, &law, bodies, &status) == STATUS_OK) {
        const struct shape_spread spread = shape_spread(&shape, hardness_Pa);
        bool known = spread.yielding_load <= shape_yielding_most && spread.largest_Pa <= at[count - 1];
        factor *= known ? side_m[0] * side_m[1] * exp(shape_curve_value(&slope, &law, log(mean_Pa))) : NAN;
    }
    shape_free(&shape);
    shape_curve_free(&gap);
    shape_curve_free(&law);
    free(at);
    return factor;
}
