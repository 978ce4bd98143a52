/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "joint/joint.h"

#include "joint/heating.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** A/A_n up to which spots count as independent, and so have a radius and a plating factor. */
static const double joint_independent_area = 0.1;

/** The effects whose quantities depend on spots. */
static const unsigned on_spots = EFFECT_BIT(EFFECT_FILM) | EFFECT_BIT(EFFECT_PLATING) | EFFECT_BIT(EFFECT_HEATING);

#define HARTING "resistivity: Harting catalogue 2013, table of specific resistances; "
#define COPPER  "thickness: copper.org, connector design guide, plating summary"
const char *const joint_plating_names[] = {"none", "hard gold", "soft gold", "tin", "silver", "nickel"};
const struct joint_layer joint_platings[] = {
    {0},
    {2.3e-8, 0.5e-6, 1.3e-6, 1.667e9,
     HARTING "that of gold, unchecked for hard gold, whose cobalt raises it: give the plater's; " COPPER
             ", 20 to 50 microinches; hardness: 170 HK, of the 130 to 200 of code C of ASTM B488 (aotco.com)"},
    {2.3e-8, 0.25e-6, 5e-6, 0.883e9,
     HARTING "thickness: classes 0.25 to 5 of ASTM B488 as told by aotco.com; hardness: 90 HK, the most of its code A"},
    {12e-8, 2.5e-6, 10e-6, 100e6,
     HARTING COPPER ", 100 microinches at least; the upper end is unchecked; hardness: 10 HV of matte tin, unchecked "
                    "(bulk tin 0.04 GPa, brightened tin more): give the plater's"},
    {1.6e-8, 2e-6, 10e-6, 0.736e9,
     HARTING "the thickness is unchecked; hardness: 75 HV, the least of the 75 to 200 HV of silver contact surfaces "
             "(materion.com, In Our Element); brightened silver has more"},
    {6.9e-8, 1.25e-6, 5e-6, 1.96e9,
     HARTING
     "thickness: 50 microinches below gold (spcprecision.com) to 5 um alone (Harting); hardness: 200 HV, of the "
     "150 to 350 HV of electroplated nickel (finishing.com 2522)"},
};

#define BOND "bond line: rfessentials.com, comparison of thermal interface materials"
const char *const joint_filler_names[] = {"none", "silicone grease", "filled grease", "pad", "gallium alloy"};
const struct joint_layer joint_fillers[] = {
    {0},
    {0.8, 25e-6, 75e-6, 0, "conductivity: Assmann WSW at digikey, thermal compound; " BOND},
    {4, 25e-6, 75e-6, 0, "conductivity: arctic.de, 1 to 4 W/(m K) whatever is advertised, its upper end; " BOND},
    {1, 50e-6, 1e-3, 0, "conductivity, most: Bergquist Gap Pad VO Ultra Soft, 1.02 mm (elcodis.com); least " BOND},
    {16.5, 25e-6, 50e-6, 0, "galinstan; conductivity: Wikipedia; bond line: indium.com on liquid metal, 1 to 2 mils"},
};

struct joint joint_default(void)
{
    return (struct joint){.fill = JOINT_GAS,
                          .gas = &gas_table[0],
                          .pressure_Pa = gas_table_pressure_Pa,
                          .accommodation = gas_table[0].accommodation,
                          .conductivity_W_per_mK = NAN,
                          .temperature_K = gas_table_temperature_K,
                          .film_ohm_m2 = NAN,
                          .thickness_m = {INFINITY, INFINITY},
                          .plating_thickness_m = NAN,
                          .plating_ohm_m = NAN,
                          .current_A = NAN};
}

static bool runs(const struct joint_task *task, enum effect effect)
{
    return task->effects & EFFECT_BIT(effect);
}

static double finite_or_nan(double value)
{
    return isfinite(value) ? value : NAN;
}

/** What a quantity is derived from. */
struct making {
    const double *value;
    struct contact_spots spots;
    const struct joint_task *task;
    const struct joint_shape *shape; /* of the model; NULL: none */
};

/* Each make_...() derives a quantity from those before it in quantity_rows, and from the spots. */

/** h_g [W/m²/K]; NaN without a separation, or where the gap of a medium closes. */
static double make_gap(const struct making *of)
{
    const struct joint *joint = of->task->joint;
    double separation_m = of->value[QUANTITY_SEPARATION];
    if (isnan(separation_m))
        return NAN;
    if (joint->fill == JOINT_VACUUM)
        return 0;
    if (joint->fill == JOINT_MEDIUM) {
        double open = fmax(1 - of->value[QUANTITY_AREA], 0), gap_m = fmax(separation_m, joint->bond_line_m);
        return gap_m > 0 ? open * joint->conductivity_W_per_mK / gap_m : NAN;
    }
    double jump_m = gas_jump_length(joint->gas, joint->temperature_K, joint->pressure_Pa, joint->accommodation,
                                    joint->accommodation);
    return gas_conductance(gas_conductivity(joint->gas, joint->temperature_K), of->task->sigma_m, separation_m, jump_m,
                           of->value[QUANTITY_AREA], of->task->tolerance);
}

static double make_joint(const struct making *of)
{
    return 1 / of->value[QUANTITY_TCR] + of->value[QUANTITY_GAP];
}

static double make_density(const struct making *of)
{
    return of->spots.density_per_m2;
}

static double make_radius(const struct making *of)
{
    return of->spots.radius_m;
}

struct contact_spots joint_equal_spots(double area_ratio, double ecr_ohm_m2, double resistivity_ohm_m)
{
    double radius_m = 2 * area_ratio * ecr_ohm_m2 / (M_PI * resistivity_ohm_m);
    double density_per_m2 = area_ratio / (M_PI * radius_m * radius_m);
    if (!(area_ratio < joint_independent_area && radius_m > 0 && isfinite(density_per_m2)))
        return (struct contact_spots){NAN, NAN};
    return (struct contact_spots){density_per_m2, radius_m};
}

/** |Q|^n [atan(1/u) - (u/2) ln(1 + 1/u²)], u = nT. The bracket is int_0^inf exp(-2u x) sin²(x)/x² dx, so that these are
 * moments of a positive measure. */
static double term(double n, double thickness_over_radius, double magnitude_log)
{
    double u = n * thickness_over_radius;
    double logarithm = u < 1 ? log1p(u * u) - 2 * log(u) : log1p(1 / u / u);
    double bracket = u > 0 ? atan(1 / u) - u / 2 * logarithm : M_PI_2;
    return exp(n * magnitude_log) * bracket;
}

/** sum_j 2^j term(2^j k): van Wijngaarden's k-th term, which makes a series of one sign alternate. */
static double condensed(double k, double thickness_over_radius, double magnitude_log)
{
    double sum = 0;
    for (double power = 1;; power *= 2) {
        double next = power * term(power * k, thickness_over_radius, magnitude_log);
        sum += next;
        if (!(next > 1e-17 * sum))
            return sum;
    }
}

/** sum_{n>=1} |Q|^n [...], with one sign or `alternating` (the first less), by algorithm 1 of Cohen, Rodriguez Villegas
 * and Zagier (2000, Experimental Mathematics 9, 3), whose relative error is 2/5.8^TERMS here. */
static double series(double thickness_over_radius, double magnitude_log, bool alternating)
{
    enum { TERMS = 18 };
    double at[TERMS + 1];
    double power = pow(3 + sqrt(8), TERMS), d = (power + 1 / power) / 2, b = -1, c = -d, sum = 0;
    for (int k = TERMS; k > 0; k--) /* the k-th condensed term holds that of 2 k twice */
        at[k] = !alternating && 2 * k > TERMS
                    ? condensed(k, thickness_over_radius, magnitude_log)
                    : term(k, thickness_over_radius, magnitude_log) + (alternating ? 0 : 2 * at[2 * k]);
    for (int k = 0; k < TERMS; k++) {
        c = b - c;
        sum += c * at[k + 1];
        b *= (k + TERMS) * (double)(k - TERMS) / ((k + 0.5) * (k + 1));
    }
    return sum / d;
}

double plating_factor(double thickness_over_radius, double plating_resistivity, double body_resistivity)
{
    if (plating_resistivity == body_resistivity)
        return 1;
    bool poorer = plating_resistivity > body_resistivity; /* Q < 0 */
    double lower = poorer ? body_resistivity : plating_resistivity, sum = plating_resistivity + body_resistivity;
    double total =
        4 / M_PI * series(thickness_over_radius, log1p(-2 * (lower / sum)), poorer); /* |Q| = 1 - 2 lower/sum */
    return poorer ? fmax(1 - total, body_resistivity / plating_resistivity) : 1 + total;
}

/** Resistance of a plated spot over that of a bare one: (rho_p F_1 + rho_2)/(rho_1 + rho_2), F_1 the plating_factor()
 * of the plated side; with both plated (rho_p F_1 + rho_p F_2)/(rho_1 + rho_2). */
static double make_plating(const struct making *of)
{
    const struct joint *joint = of->task->joint;
    const double *bare = of->task->pair->side_resistivity_ohm_m;
    double thickness = joint->plating_thickness_m / of->spots.radius_m, plated = 0;
    if (!(of->value[QUANTITY_AREA] < joint_independent_area && of->spots.radius_m > 0))
        return NAN;
    for (int side = 0; side < 2; side++)
        plated += side == 0 || joint->both_plated
                      ? joint->plating_ohm_m * plating_factor(thickness, joint->plating_ohm_m, bare[side])
                      : bare[side];
    return plated / (bare[0] + bare[1]);
}

double joint_temperature(const struct joint_task *task, double voltage_V)
{
    double ambient_K = task->joint->temperature_K;
    return finite_or_nan(ambient_K + heating_rise(voltage_V, ambient_K));
}

/** R A_n [ohm m²], with plating; with a film of resistance s_f in series each of equal spots has rho/(2a) + s_f/(pi
 * a²), together R_c A_n + s_f/(A/A_n) (Holm 1967, Electric Contacts, 4th edition). The resistance of a film is not
 * predicted: that of tunnelling spans ten decades within 1.5 nm. */
static double make_ecr(const struct making *of)
{
    double ecr_ohm_m2 = of->value[QUANTITY_ECR];
    if (runs(of->task, EFFECT_PLATING) && ecr_ohm_m2 > 0) /* 0: full contact */
        ecr_ohm_m2 *= of->value[QUANTITY_PLATING_FACTOR];
    if (runs(of->task, EFFECT_FILM))
        ecr_ohm_m2 += of->task->joint->film_ohm_m2 / of->value[QUANTITY_AREA];
    return ecr_ohm_m2;
}

void joint_shape_free(struct joint_shape *shape)
{
    for (int way = 0; way < JOINT_WAYS; way++) {
        shape_curve_free(&shape->flat[way]);
        shape_curve_free(&shape->over[way]);
        shape_curve_free(&shape->spots[way]);
    }
    shape_curve_free(&shape->area);
}

double joint_shape_area(const struct joint_shape *shape, double load)
{
    double slope;
    return load >= shape->least && load <= shape->most ? exp(shape_curve_value(&slope, &shape->area, log(load))) : NAN;
}

/** Resistance with the shape, of a contact that has `own` where the parts are flat: that of the curve solved with the
 * shape, the part of its spots scaled as `own` differs from the flat curve. */
static double shaped(const struct making *of, int way, double own)
{
    const struct joint_shape *shape = of->shape;
    double load = of->value[QUANTITY_LOAD], slope;
    if (!shape || shape->over[way].count == 0 || !(load >= shape->least && load <= shape->most))
        return NAN;
    double flat = exp(shape_curve_value(&slope, &shape->flat[way], log(load)));
    double over = exp(shape_curve_value(&slope, &shape->over[way], log(load)));
    return over * flat * (1 + exp(shape_curve_value(&slope, &shape->spots[way], log(load))) * (own / flat - 1));
}

double joint_resistance(const double *value, const struct joint_task *task, int way)
{
    const struct making of = {.value = value, .task = task};
    if (way == JOINT_CURRENT)
        return make_ecr(&of);
    return runs(task, EFFECT_GAP) ? 1 / value[QUANTITY_JOINT] : value[QUANTITY_TCR];
}

static double make_shape_joint(const struct making *of)
{
    return 1 / shaped(of, JOINT_HEAT, joint_resistance(of->value, of->task, JOINT_HEAT));
}

static double make_shape_ecr(const struct making *of)
{
    return shaped(of, JOINT_CURRENT, make_ecr(of));
}

static double make_voltage(const struct making *of)
{
    double ecr_ohm_m2 = runs(of->task, EFFECT_SHAPE) ? of->value[QUANTITY_SHAPE_ECR] : make_ecr(of);
    return of->task->joint->current_A * (ecr_ohm_m2 / of->task->nominal_area_m2);
}

static double make_temperature(const struct making *of)
{
    return joint_temperature(of->task, of->value[QUANTITY_VOLTAGE]);
}

static double (*const makers[QUANTITY_COUNT])(const struct making *of) = {[QUANTITY_GAP] = make_gap,
                                                                          [QUANTITY_JOINT] = make_joint,
                                                                          [QUANTITY_SPOT_DENSITY] = make_density,
                                                                          [QUANTITY_SPOT_RADIUS] = make_radius,
                                                                          [QUANTITY_PLATING_FACTOR] = make_plating,
                                                                          [QUANTITY_JOINT_ECR] = make_ecr,
                                                                          [QUANTITY_SHAPE_JOINT] = make_shape_joint,
                                                                          [QUANTITY_SHAPE_ECR] = make_shape_ecr,
                                                                          [QUANTITY_VOLTAGE] = make_voltage,
                                                                          [QUANTITY_TEMPERATURE] = make_temperature};

bool joint_has_bond_line(const struct joint_task *task)
{
    return runs(task, EFFECT_GAP) && task->joint->fill == JOINT_MEDIUM && task->joint->bond_line_m > 0;
}

bool joint_is_held(const struct contact_point *point, const struct joint_task *task)
{
    return joint_has_bond_line(task) && point->value[QUANTITY_SEPARATION] == task->joint->bond_line_m;
}

void joint_hold(struct contact_point *points, size_t count, const struct joint_task *task)
{
    for (size_t i = 0; i < count && joint_has_bond_line(task); i++) {
        const struct contact_point own = points[i], *before = i > 0 ? &points[i - 1] : NULL;
        const double gap_m = task->joint->bond_line_m, *end = own.value;
        double *value = points[i].value;
        bool goes_on = before && isnan(end[QUANTITY_SEPARATION]) && joint_is_held(before, task); /* no gap known */
        if (!(end[QUANTITY_SEPARATION] < gap_m) && !goes_on)
            continue;
        points[i] = quantity_nothing();
        for (int q = QUANTITY_AREA; q <= QUANTITY_TCR_SCALE_DEPENDENT; q++)
            if (!isnan(end[q]))
                value[q] = q == QUANTITY_AREA ? 0 : INFINITY;
        if (before && before->value[QUANTITY_SEPARATION] >= gap_m) {
            const double *first = before->value, fall_m = first[QUANTITY_SEPARATION] - end[QUANTITY_SEPARATION];
            double part = (first[QUANTITY_SEPARATION] - gap_m) / fall_m;
            points[i].beyond_fit = before->beyond_fit;
            points[i].radius_clamped = before->radius_clamped;
            for (int q = QUANTITY_AREA; q <= QUANTITY_TCR_SCALE_DEPENDENT; q++) /* part 0: as at the load before */
                value[q] = !(part > 0) ? first[q] : isnan(value[q]) ? NAN : pow(first[q], 1 - part) * pow(end[q], part);
        }
        value[QUANTITY_SEPARATION] = gap_m;
        value[QUANTITY_ADJUSTED] = isnan(end[QUANTITY_ADJUSTED]) ? NAN : gap_m;
        value[QUANTITY_LOAD] = end[QUANTITY_LOAD];
    }
}

void joint_apply(struct contact_point *points, const struct contact_spots *spots, size_t count,
                 const struct joint_task *task, const struct model_row *model)
{
    for (size_t i = 0; i < count; i++) {
        double *value = points[i].value;
        struct making of = {value, {NAN, NAN}, task, task->shapes && model ? &task->shapes[model_index(model)] : NULL};
        if (task->effects & on_spots)
            of.spots =
                spots ? spots[i]
                      : joint_equal_spots(value[QUANTITY_AREA], value[QUANTITY_ECR], task->pair->resistivity_ohm_m);
        for (int q = 0; q < QUANTITY_COUNT; q++) {
            const struct quantity_row *row = &quantity_rows[q];
            if (row->derive && (!row->effect || (task->effects & row->effect)))
                value[q] = finite_or_nan(row->derive(value, task->pair));
            else if (makers[q] && (task->effects & row->effect))
                value[q] = finite_or_nan(makers[q](&of));
        }
    }
}

void joint_carry_sd(double sd[QUANTITY_COUNT], const struct contact_point *point, const struct model_row *row,
                    const struct joint_task *task)
{
    struct contact_point rougher = *point;
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if (q != QUANTITY_SEPARATION || !joint_is_held(point, task))
            rougher.value[q] *= exp(q == QUANTITY_AREA ? -sd[q] : sd[q]);
    joint_apply(&rougher, NULL, 1, task, row);
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if (quantity_rows[q].from)
            sd[q] = fabs(log(rougher.value[q] / point->value[q]));
}

void joint_model_sd(double out[QUANTITY_COUNT], const struct contact_point *point, const struct model_row *row,
                    const struct joint_task *task, struct scans_reach reach)
{
    const double pressure_Pa = material_pair_pressure(task->pair, point->value[QUANTITY_LOAD]);
    for (int q = 0; q < QUANTITY_COUNT; q++) {
        out[q] = q == QUANTITY_AREA || q == QUANTITY_SEPARATION || q == QUANTITY_ADJUSTED ||
                         (QUANTITY_RESISTANCES & QUANTITY_BIT(q))
                     ? model_surface_sd(row, (enum quantity)q, reach)
                     : 0;
        if (q == QUANTITY_AREA && row->plastic && row->uses_strip) { /* with exp(sd) times the elastic area */
            double share = model_elastic_share(row, point, pressure_Pa / task->pair->hardness_Pa),
                   elastic_sd = model_surface_sd(row->elastic, QUANTITY_AREA, reach);
            out[q] = hypot(bearing_area_sd, log1p(share * expm1(4 * elastic_sd)) / 4);
        }
    }
    if (model_sd(row, QUANTITY_AREA, reach.two_directions) > 0)
        joint_carry_sd(out, point, row, task);
}

void joint_bounds(double out[QUANTITY_COUNT][2], const struct contact_point *point, const struct model_row *row,
                  const struct joint_task *task)
{
    const double share = material_pair_pressure(task->pair, point->value[QUANTITY_LOAD]) / task->pair->hardness_Pa;
    memset(out, 0, QUANTITY_COUNT * sizeof *out);
    if (joint_is_held(point, task)) /* no metal touches */
        return;
    out[QUANTITY_AREA][1] = 1;
    if (joint_has_bond_line(task)) {
        out[QUANTITY_SEPARATION][0] = task->joint->bond_line_m / task->sigma_m;
        out[QUANTITY_MEAN_GAP][0] = task->joint->bond_line_m;
        out[QUANTITY_GAP][1] = task->joint->conductivity_W_per_mK / task->joint->bond_line_m;
    }
    if (!row->plastic || !(share > 0 && share < 1))
        return;
    out[QUANTITY_AREA][0] = share;
    struct contact_point one = *point;
    const double radius_m = sqrt(share * task->nominal_area_m2 / M_PI),
                 length_m = task->nominal_area_m2 / (2 * radius_m); /* (rho_1 + rho_2) A_n/(4a) is rho times that */
    if (!(length_m > 0))
        return;
    one.value[QUANTITY_AREA] = share;
    one.value[QUANTITY_ECR] = task->pair->resistivity_ohm_m * length_m;
    one.value[QUANTITY_TCR] = length_m / task->pair->conductivity_W_per_mK;
    joint_apply(&one, NULL, 1, task, NULL);
    static const enum quantity most[] = {QUANTITY_ECR, QUANTITY_TCR, QUANTITY_JOINT_ECR, QUANTITY_VOLTAGE,
                                         QUANTITY_TEMPERATURE};
    for (size_t k = 0; k < sizeof most / sizeof *most; k++)
        if (isfinite(one.value[most[k]]))
            out[most[k]][1] = one.value[most[k]];
    out[QUANTITY_JOINT][0] = 1 / one.value[QUANTITY_TCR];
}

enum status_code joint_curve(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                             const struct joint_task *joint, struct status *status)
{
    OWNED(memory_free) struct contact_spots *spots = NULL;
    enum status_code rc = STATUS_OK;
    if (!curve->exists)
        return STATUS_OK;
    if (row->spots && (joint->effects & on_spots)) {
        spots = calloc(task->load_count + 1, sizeof *spots);
        if (!spots)
            return status_memory(status);
        rc = row->spots(spots, row, task, status);
        for (size_t i = 0; i < curve->count; i++)
            if (i >= task->load_count || curve->points[i].value[QUANTITY_LOAD] != task->loads[i]) /* full contact */
                spots[i] = (struct contact_spots){NAN, NAN};
            else if (joint_is_held(&curve->points[i], joint)) /* the metal does not carry the whole load */
                spots[i] = joint_equal_spots(curve->points[i].value[QUANTITY_AREA],
                                             curve->points[i].value[QUANTITY_ECR], joint->pair->resistivity_ohm_m);
    }
    if (rc == STATUS_OK)
        joint_apply(curve->points, spots, curve->count, joint, row);
    return rc;
}
