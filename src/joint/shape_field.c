/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "joint/shape_field.h"

#include <gsl/gsl_interp2d.h>
#include <math.h>
#include <stdlib.h>

enum { CELLS_LEAST = 64, CELLS_MOST = 128, PARTS = 4 }; /* a side; points a side of a cell that bolts are taken at */
static const double cells_across = 4;                   /* a ring of pressure */

void shape_field_free(struct shape_field *field)
{
    free(field->value);
    free(field->share);
    *field = (struct shape_field){0};
}

static size_t cells_of(double asked)
{
    return (size_t)fmin(fmax(ceil(asked), CELLS_LEAST), CELLS_MOST);
}

static enum status_code take_mean(struct shape_field *field)
{
    for (size_t k = 0; k < field->nx * field->ny; k++)
        field->mean += field->value[k] / (double)(field->nx * field->ny);
    return STATUS_OK;
}

enum status_code shape_field_grid(struct shape_field *out, const double *const at_m[2], const size_t count[2],
                                  const double *value, const double side_m[2], struct status *status)
{
    *out = (struct shape_field){.nx = cells_of((double)count[0]), .ny = cells_of((double)count[1])};
    if (count[0] < 2 || count[1] < 2)
        return status_fail(status, STATUS_MODEL, "a field of %zu x %zu points is no grid", count[0], count[1]);
    out->value = calloc(out->nx * out->ny, sizeof *out->value);
    gsl_interp2d *between = gsl_interp2d_alloc(gsl_interp2d_bilinear, count[0], count[1]);
    if (!out->value || !between) {
        gsl_interp2d_free(between);
        return status_memory(status);
    }
    gsl_interp2d_init(between, at_m[0], at_m[1], value, count[0], count[1]);
    for (size_t k = 0; k < out->nx * out->ny; k++) {
        double x = ((double)(k % out->nx) + 0.5) / (double)out->nx * side_m[0];
        double y = ((double)(k / out->nx) + 0.5) / (double)out->ny * side_m[1];
        x = fmin(fmax(x, at_m[0][0]), at_m[0][count[0] - 1]);
        y = fmin(fmax(y, at_m[1][0]), at_m[1][count[1] - 1]);
        out->value[k] = gsl_interp2d_eval(between, at_m[0], at_m[1], value, x, y, NULL, NULL);
    }
    gsl_interp2d_free(between);
    return take_mean(out);
}

double shape_bolt_pressure(const struct shape_bolts *bolts, double r_m)
{
    double b = bolts->hole_m, c = bolts->reach_m, most = 5 * bolts->force_N / (M_PI * pow(c - b, 5) * (c + 3 * b));
    return r_m < b || r_m > c ? 0 : most * pow(c - r_m, 3) * (3 * r_m + c - 4 * b);
}

/** Adds one bolt to the field, in units of `cell_m2`. */
static bool add_bolt(struct shape_field *out, const struct shape_bolts *bolts, size_t bolt, const double side_m[2],
                     double *room)
{
    double force_N = 0;
    const size_t cells = out->nx * out->ny;
    for (size_t k = 0; k < cells; k++) {
        room[k] = 0;
        for (int part = 0; part < PARTS * PARTS; part++) {
            double i = (double)(k % out->nx) + (part % PARTS + 0.5) / PARTS;
            double j = (double)(k / out->nx) + (part / PARTS + 0.5) / PARTS;
            room[k] += shape_bolt_pressure(bolts, hypot(i / (double)out->nx * side_m[0] - bolts->middle_m[bolt][0],
                                                        j / (double)out->ny * side_m[1] - bolts->middle_m[bolt][1]));
        }
        force_N += room[k] * side_m[0] * side_m[1] / (double)cells;
    }
    for (size_t k = 0; k < cells && force_N > 0; k++)
        out->value[k] += room[k] * bolts->force_N / force_N;
    return force_N > 0;
}

enum status_code shape_field_bolts(struct shape_field *out, const struct shape_bolts *bolts, const double side_m[2],
                                   struct status *status)
{
    double cell_m = (bolts->reach_m - bolts->hole_m) / cells_across;
    *out = (struct shape_field){.nx = cells_of(side_m[0] / cell_m), .ny = cells_of(side_m[1] / cell_m)};
    double *room = calloc(out->nx * out->ny, sizeof *room);
    out->value = calloc(out->nx * out->ny, sizeof *out->value);
    enum status_code rc = room && out->value ? STATUS_OK : status_memory(status);
    for (size_t bolt = 0; rc == STATUS_OK && bolt < bolts->count; bolt++)
        if (!add_bolt(out, bolts, bolt, side_m, room))
            rc = status_fail(status, STATUS_MODEL, "bolt %zu presses on less than a cell of the area", bolt + 1);
    free(room);
    return rc == STATUS_OK ? take_mean(out) : rc;
}

void shape_field_press(double *out, const struct shape_field *field, size_t count, double mean_Pa)
{
    size_t i = 0, cells = field->nx * (field->ny > 0 ? field->ny : 1);
    while (i + 2 < count && mean_Pa > field[i + 1].mean)
        i++;
    const struct shape_field *low = &field[i], *high = count > 1 ? low + 1 : low;
    double part = count > 1 ? log(mean_Pa / low->mean) / log(high->mean / low->mean) : 0;
    part = fmin(fmax(part, 0), 1);
    for (size_t k = 0; k < cells; k++)
        out[k] = mean_Pa * ((1 - part) * low->value[k] / low->mean + part * high->value[k] / high->mean);
}
