/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answers/shaped.h"

#include "joint/shape.h"
#include "members/surface.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    CELLS = 32,  /* a side of one quarter of the area; the others are its mirror images */
    NODES = 240, /* points of the model's curve, at most */
    LOADS = 31   /* resistances interpolated between them are within 0.5 % of those from twice as many */
};
static const double nodes_per_decade = 12;
static const double lighter = 1e-3;      /* the curve begins at this times the lightest load */
static const double beyond = 1.02;       /* beyond the first and the last load, so that all lie within */
static const double carrying = 0.9;      /* the reported area carries this share of the load */
static const double no_pressure = 1e-12; /* over the mean pressure */
const double shaped_usual_flatness = 1e-4;

/** Values over rising pressures or loads. */
struct table {
    size_t count;
    double at[NODES], value[1 + JOINT_WAYS][NODES]; /* gap or area; then by JOINT_WAYS */
};

/** Takes every `step`-th point of a curve that has a gap and a conductance `way`. */
static void take_points(struct table *out, const struct model_curve *curve, size_t step, const struct joint_task *joint,
                        int way)
{
    for (size_t i = 0; i < curve->count; i += step) {
        const double *value = curve->points[i].value;
        double conductance = 1 / joint_resistance(value, joint, way), gap_m = value[QUANTITY_SEPARATION];
        if (!isfinite(conductance) || !isfinite(gap_m) || !(value[QUANTITY_AREA] <= shape_largest_area))
            continue;
        out->at[out->count] = material_pair_pressure(joint->pair, value[QUANTITY_LOAD]);
        out->value[0][out->count] = gap_m;
        out->value[1 + JOINT_HEAT][out->count] = conductance;
        out->value[1 + JOINT_CURRENT][out->count++] = 1 / joint_resistance(value, joint, JOINT_CURRENT);
    }
}

/** Computes the model's curve over all local pressures. */
static enum status_code own_curve(struct table *out, const struct surface_record *record, size_t m,
                                  const struct model_task *task, const struct joint_task *joint, struct status *status)
{
    double loads[NODES], own_gap_m[NODES] = {0}, first = task->loads[0] * lighter, decades = -log10(first);
    size_t count = (size_t)fmin(fmax(decades * nodes_per_decade, 8), NODES);
    OWNED(memory_free) struct contact_point *points = calloc(count + 1, sizeof *points);
    struct model_curve curve = {.points = points};
    for (size_t i = 0; i < count; i++)
        loads[i] = pow(10, decades * ((double)i / (double)(count - 1) - 1));
    const struct model_task dense = model_task_at(task, loads, count);
    if (!points)
        return status_memory(status);
    if (ensemble_curve(&curve, NULL, &record->ensemble, model_rows[m], &dense, status) == STATUS_OK && curve.exists) {
        for (size_t i = 0; i < curve.count && i < count; i++)
            own_gap_m[i] = points[i].value[QUANTITY_SEPARATION];
        joint_hold(points, curve.count, joint);
        (void)!joint_curve(&curve, model_rows[m], &dense, joint, status);
        for (size_t i = 0; i < curve.count && i < count; i++) /* a bond line adds no stiffness */
            points[i].value[QUANTITY_SEPARATION] = own_gap_m[i];
        take_points(out, &curve, 1, joint, JOINT_HEAT);
    }
    return status->code;
}

/** The cells of the nominal area, with a model's curve. */
struct cells {
    const struct joint *joint;
    struct shape shape;
    struct shape_curve gap, conductance[JOINT_WAYS];
    double quarter_m[CELLS * CELLS], hardness_Pa;
    const double *gap_m; /* quarter_m, or the joint's field */
    struct shape_body bodies[JOINT_WAYS][2];
};

static enum status_code lay_out(struct cells *out, const struct joint *joint, const struct table *own,
                                const struct model_task *task, struct status *status)
{
    const struct shape_field *field = joint->fields;
    const double part = field ? 1 : 0.5, side_m[2] = {joint->size_m[0] * part, joint->size_m[1] * part};
    const bool grid = field && !field->share;
    const size_t nx = grid ? field->nx : CELLS, ny = grid ? field->ny : CELLS;
    const struct material_pair *pair = task->pair;
    for (size_t k = 0; k < CELLS * CELLS; k++) { /* from the middle */
        double x = ((double)(k % CELLS) + 0.5) / CELLS * side_m[0], y = ((double)(k / CELLS) + 0.5) / CELLS * side_m[1];
        out->quarter_m[k] = joint->bulge_per_m * (x * x + y * y);
    }
    out->joint = joint;
    out->gap_m = field ? field->value : out->quarter_m;
    for (int side = 0; side < 2; side++) {
        double thickness_m = joint->thickness_m[side];
        out->bodies[JOINT_HEAT][side] = (struct shape_body){1 / pair->side_conductivity_W_per_mK[side], thickness_m};
        out->bodies[JOINT_CURRENT][side] = (struct shape_body){pair->side_resistivity_ohm_m[side], thickness_m};
    }
    size_t current = 0; /* no plating factor once spots meet: the resistance stays as at that point */
    while (current < own->count && own->value[1 + JOINT_CURRENT][current] > 0 &&
           isfinite(own->value[1 + JOINT_CURRENT][current]))
        current++;
    if (shape_make(&out->shape, nx, ny, side_m, status) != STATUS_OK ||
        shape_curve_gap(&out->gap, own->at, own->value[0], own->count, out->hardness_Pa, status) != STATUS_OK ||
        shape_curve_conductance(&out->conductance[JOINT_HEAT], own->at, own->value[1 + JOINT_HEAT], own->count,
                                status) != STATUS_OK ||
        current < 3)
        return status->code;
    return shape_curve_conductance(&out->conductance[JOINT_CURRENT], own->at, own->value[1 + JOINT_CURRENT], current,
                                   status);
}

static void cells_free(struct cells *cells)
{
    shape_free(&cells->shape);
    shape_curve_free(&cells->gap);
    for (int way = 0; way < JOINT_WAYS; way++)
        shape_curve_free(&cells->conductance[way]);
}

/** The solution at one load: share of the area that carries it, share of the load that lies at the hardness, and for
 * each way the resistance times area and the spots' share of it. */
struct solved {
    double area, yielding_load, whole[JOINT_WAYS], spots[JOINT_WAYS];
};

/** Pressures given for shares of the area: side by side, each uniform; the rest of the area carries nothing. */
static enum status_code solve_parts(struct solved *out, struct cells *cells, double mean_Pa, struct status *status)
{
    const struct shape_field *field = cells->joint->fields;
    OWNED(memory_free) double *pressure_Pa = calloc(field->nx + 1, sizeof *pressure_Pa);
    double load = 0, rest = 1, unused;
    if (!pressure_Pa)
        return status_memory(status);
    shape_field_press(pressure_Pa, field, 1, mean_Pa);
    *out = (struct solved){.spots = {1, 1}};
    for (size_t k = 0; k <= field->nx; k++) {
        double share = k < field->nx ? field->share[k] : fmax(rest, 0), carried = share * pressure_Pa[k] / mean_Pa;
        double ln_pressure = log(fmin(fmax(pressure_Pa[k], no_pressure * mean_Pa), cells->hardness_Pa));
        rest -= share;
        out->area += carried > 0 ? share * fmin(1, fmax(carrying - load, 0) / carried) : 0;
        load += carried;
        out->yielding_load += pressure_Pa[k] >= cells->hardness_Pa ? carried : 0;
        for (int way = 0; way < JOINT_WAYS; way++)
            if (cells->conductance[way].count > 0)
                out->whole[way] += share * exp(shape_curve_value(&unused, &cells->conductance[way], ln_pressure));
    }
    for (int way = 0; way < JOINT_WAYS; way++)
        out->whole[way] = 1 / out->whole[way];
    return STATUS_OK;
}

/** Sets given pressures, capped at the hardness. */
static void give_pressures(struct cells *cells, double mean_Pa)
{
    struct shape *shape = &cells->shape;
    shape_field_press(shape->pressure_Pa, cells->joint->fields, cells->joint->field_count, mean_Pa);
    for (size_t k = 0; k < shape->cells; k++) {
        shape->pressure_Pa[k] = fmin(shape->pressure_Pa[k], cells->hardness_Pa);
        shape->ln_pressure[k] = log(fmax(shape->pressure_Pa[k], no_pressure * mean_Pa));
    }
}

static enum status_code solve_one(struct solved *out, struct cells *cells, const struct model_task *task,
                                  double mean_Pa, struct status *status)
{
    const struct joint *joint = cells->joint;
    const double area_m2 = cells->shape.side_m[0] * cells->shape.side_m[1];
    if (joint->fields && joint->fields->share)
        return solve_parts(out, cells, mean_Pa, status);
    if (joint->pressed)
        give_pressures(cells, mean_Pa);
    else if (shape_press(&cells->shape, cells->gap_m, &cells->gap, task->pair->effective_modulus_Pa, mean_Pa, status) !=
             STATUS_OK)
        return status->code;
    const struct shape_spread spread = shape_spread(&cells->shape, cells->hardness_Pa);
    *out = (struct solved){.area = spread.area, .yielding_load = spread.yielding_load};
    for (int way = 0; way < JOINT_WAYS && spread.yielding_load <= shape_yielding_most; way++)
        if (cells->conductance[way].count > 0) {
            if (shape_resistance(&out->whole[way], &out->spots[way], &cells->shape, &cells->conductance[way],
                                 cells->bodies[way], status) != STATUS_OK)
                return status->code;
            out->whole[way] *= area_m2;
        }
    return STATUS_OK;
}

/** Mean pressures of rings about the middle at the operating load; 0 without a solution. */
static enum status_code take_rings(struct joint_shape *out, struct cells *cells, const struct model_task *task,
                                   struct status *status)
{
    const struct shape *shape = &cells->shape;
    const double middle = cells->joint->fields ? 0.5 : 0, *side = shape->side_m;
    const double mean_Pa = material_pair_pressure(task->pair, task->loads[model_task_operating(task)]);
    size_t cells_of[JOINT_RINGS] = {0};
    struct solved unused;
    if ((cells->joint->fields && cells->joint->fields->share) || !(mean_Pa < cells->hardness_Pa))
        return STATUS_OK;
    if (solve_one(&unused, cells, task, mean_Pa, status) != STATUS_OK)
        return status->code;
    for (size_t k = 0; k < shape->cells; k++) {
        double x = ((double)(k % shape->nx) + 0.5) / (double)shape->nx - middle;
        double y = ((double)(k / shape->nx) + 0.5) / (double)shape->ny - middle;
        double far = hypot(x * side[0], y * side[1]) / hypot((1 - middle) * side[0], (1 - middle) * side[1]);
        size_t ring = (size_t)fmin(far * JOINT_RINGS, JOINT_RINGS - 1);
        out->ring_Pa[ring] += (shape->pressure_Pa[k] - out->ring_Pa[ring]) / (double)++cells_of[ring];
    }
    return STATUS_OK;
}

/** Adds to the error what to do: at this pressure, or NaN: for the whole curve. */
static enum status_code explain(double pressure_Pa, struct status *status)
{
    const struct status problem = *status;
    if (problem.code != STATUS_MODEL)
        return problem.code;
    *status = (struct status){0};
    if (isnan(pressure_Pa))
        return status_fail(status, STATUS_MODEL, "%s; with 'shape', choose another of 'models'", problem.message);
    return status_fail(status, STATUS_MODEL, "at %.3g MPa %s; narrow 'load', or correct 'shape'", pressure_Pa * 1e-6,
                       problem.message);
}

/** Solves all loads, and tabulates the resistances. */
static enum status_code solve_loads(struct joint_shape *out, struct cells *cells, const struct model_task *task,
                                    struct status *status)
{
    struct table area = {0}, flat = {0}, over = {0}, spots = {0};
    const double first = task->loads[0] / beyond, last = task->loads[task->load_count - 1] * beyond;
    double yields_Pa = cells->hardness_Pa;
    for (int i = 0; i < LOADS; i++) {
        double load = first * pow(last / first, (double)i / (LOADS - 1)), unused;
        double pressure_Pa = material_pair_pressure(task->pair, load);
        struct solved at;
        if (!(pressure_Pa < cells->hardness_Pa))
            break;
        if (solve_one(&at, cells, task, pressure_Pa, status) != STATUS_OK)
            return explain(pressure_Pa, status);
        if (at.yielding_load > shape_yielding_most) {
            yields_Pa = pressure_Pa;
            break;
        }
        for (int way = 0; way < JOINT_WAYS; way++) {
            if (cells->conductance[way].count == 0)
                continue;
            double own = exp(-shape_curve_value(&unused, &cells->conductance[way], log(pressure_Pa)));
            flat.value[way][area.count] = own;
            over.value[way][area.count] = at.whole[way] / own;
            spots.value[way][area.count] = at.spots[way];
        }
        area.value[0][area.count] = at.area;
        area.at[area.count++] = load;
    }
    if (area.count < 3)
        return status_fail(status, STATUS_MODEL,
                           "from %.3g MPa on over %g %% of the load lies where 'shape' presses at the hardness; begin "
                           "'load' lower, or correct 'shape' or 'hardness'",
                           yields_Pa * 1e-6, 100 * shape_yielding_most);
    if (take_rings(out, cells, task, status) != STATUS_OK)
        return status->code;
    out->least = area.at[0];
    out->most = area.at[area.count - 1];
    for (int way = 0; way < JOINT_WAYS; way++)
        if (cells->conductance[way].count > 0 &&
            (shape_curve_conductance(&out->flat[way], area.at, flat.value[way], area.count, status) != STATUS_OK ||
             shape_curve_conductance(&out->over[way], area.at, over.value[way], area.count, status) != STATUS_OK ||
             shape_curve_conductance(&out->spots[way], area.at, spots.value[way], area.count, status) != STATUS_OK))
            return status->code;
    return shape_curve_conductance(&out->area, area.at, area.value[0], area.count, status);
}

enum status_code shaped_make(struct surface_record *record, size_t m, const struct surface_task *asked,
                             const struct model_task *task, struct status *status)
{
    struct joint_task joint = surface_joint(record, asked->scene, asked->plan, task);
    OWNED(memory_free) struct table *own = calloc(1, sizeof *own);
    OWNED(memory_free) struct cells *cells = calloc(1, sizeof *cells);
    struct status problem = {0};
    if (!record->shapes)
        record->shapes = calloc(model_count, sizeof *record->shapes);
    struct joint_shape *out = record->shapes ? &record->shapes[m] : NULL;
    joint.shapes = NULL;
    if (!own || !cells || !out) {
        (void)status_memory(&problem);
    } else if (own_curve(own, record, m, task, &joint, &problem) == STATUS_OK) {
        cells->hardness_Pa = model_rows[m]->plastic ? task->hardness_Pa : INFINITY;
        (void)(lay_out(cells, &asked->scene->joint, own, task, &problem) == STATUS_OK
                   ? solve_loads(out, cells, task, &problem)
                   : explain(NAN, &problem));
    }
    if (cells)
        cells_free(cells);
    if (problem.code == STATUS_OK)
        return STATUS_OK;
    if (problem.code != STATUS_MODEL)
        return status_fail(status, problem.code, "%s", problem.message);
    joint_shape_free(out);
    *out = (struct joint_shape){0};
    note_add(&record->summary.notes, NULL, "note.no_shape\nmodel %s\nwhy\t%s", model_rows[m]->label, problem.message);
    return STATUS_OK;
}

double shaped_usual_factor(const struct model_curve *curve, const struct model_row *row, const struct joint_task *joint,
                           double load, int way)
{
    const double length_m = sqrt(joint->nominal_area_m2), mean_Pa = material_pair_pressure(joint->pair, load);
    const struct joint bulge = {.bulge_per_m = 4 * shaped_usual_flatness / length_m,
                                .size_m = {length_m, length_m},
                                .thickness_m = {INFINITY, INFINITY}};
    const struct model_task task = {.pair = joint->pair};
    OWNED(memory_free) struct table *own = calloc(1, sizeof *own);
    OWNED(memory_free) struct cells *cells = calloc(1, sizeof *cells);
    struct status status = {0};
    struct solved at;
    double factor = NAN, slope;
    if (own && cells) {
        take_points(own, curve, curve->count / NODES + 1, joint, way);
        cells->hardness_Pa = row->plastic ? joint->pair->hardness_Pa : INFINITY;
    }
    if (own && cells && mean_Pa < cells->hardness_Pa && lay_out(cells, &bulge, own, &task, &status) == STATUS_OK) {
        memcpy(cells->bodies[JOINT_HEAT], cells->bodies[way], sizeof *cells->bodies); /* the only way that is needed */
        shape_curve_free(&cells->conductance[JOINT_CURRENT]);
        if (solve_one(&at, cells, &task, mean_Pa, &status) == STATUS_OK && at.yielding_load <= shape_yielding_most &&
            shape_spread(&cells->shape, cells->hardness_Pa).largest_Pa <= own->at[own->count - 1])
            factor = at.whole[JOINT_HEAT] * exp(shape_curve_value(&slope, cells->conductance, log(mean_Pa)));
    }
    if (cells)
        cells_free(cells);
    return factor;
}
