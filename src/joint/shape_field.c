/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "joint/shape_field.h"

#include <math.h>
#include <stdlib.h>

enum { CELLS_LEAST = 64, CELLS_MOST = 128, PARTS = 4 }; /* cells a side; points a side of a cell, for bolts */
static const double cells_across = 4;                   /* the ring of pressure of a bolt */

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

/* Values at places along a line, `step` apart in memory. */
struct line {
    const double *at_m, *value;
    size_t count, step;
    bool cells; /* as shape_grid.cells */
};

/** Value at x, which lies in piece `piece` of the line, after that many borders. */
static double on_line(const struct line *line, size_t piece, double x_m)
{
    const double *at_m = line->at_m, *value = line->value;
    if (line->cells || piece == 0 || piece == line->count)
        return value[line->step * (line->cells || piece == 0 ? piece : piece - 1)];
    double part = (x_m - at_m[piece - 1]) / (at_m[piece] - at_m[piece - 1]);
    return value[line->step * (piece - 1)] * (1 - part) + value[line->step * piece] * part;
}

/** Means over `cells` equal parts of a side, `out_step` apart: exact, as each piece has the mean of its middle. */
static void take_means(double *out, size_t out_step, size_t cells, double side_m, const struct line *line)
{
    const size_t borders = line->cells ? line->count - 1 : line->count;
    size_t piece = 0;
    for (size_t k = 0; k < cells; k++) {
        double from = side_m * (double)k / (double)cells, end = side_m * (double)(k + 1) / (double)cells, sum = 0;
        while (from < end) {
            double border = INFINITY;
            if (piece < borders)
                border = line->cells ? (line->at_m[piece] + line->at_m[piece + 1]) / 2 : line->at_m[piece];
            double to = fmin(fmax(border, from), end);
            sum += to > from ? on_line(line, piece, (from + to) / 2) * (to - from) : 0;
            piece += to < end || border == end;
            from = to;
        }
        out[k * out_step] = sum * (double)cells / side_m;
    }
}

enum status_code shape_field_grid(struct shape_field *out, const struct shape_grid *grid, const double side_m[2],
                                  struct status *status)
{
    const size_t *count = grid->count;
    *out = (struct shape_field){.nx = cells_of((double)count[0]), .ny = cells_of((double)count[1])};
    if (count[0] < 2 || count[1] < 2)
        return status_fail(status, STATUS_MODEL, "a field of %zu x %zu points is no grid", count[0], count[1]);
    OWNED(memory_free) double *rows = calloc(out->nx * count[1], sizeof *rows);
    out->value = calloc(out->nx * out->ny, sizeof *out->value);
    for (size_t j = 0; rows && j < count[1]; j++)
        take_means(rows + j * out->nx, 1, out->nx, side_m[0],
                   &(struct line){grid->at_m[0], grid->value + j * count[0], count[0], 1, grid->cells[0]});
    for (size_t i = 0; rows && out->value && i < out->nx; i++)
        take_means(out->value + i, out->nx, out->ny, side_m[1],
                   &(struct line){grid->at_m[1], rows + i, count[1], out->nx, grid->cells[1]});
    return rows && out->value ? take_mean(out) : status_memory(status);
}

double shape_bolt_pressure(const struct shape_bolts *bolts, double r_m)
{
    double b = bolts->hole_m, c = bolts->reach_m, most = 5 * bolts->force_N / (M_PI * pow(c - b, 5) * (c + 3 * b));
    return r_m < b || r_m > c ? 0 : most * pow(c - r_m, 3) * (3 * r_m + c - 4 * b);
}

/** Adds one bolt to the field. False: it presses on no cell. */
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
    OWNED(memory_free) double *room = calloc(out->nx * out->ny, sizeof *room);
    out->value = calloc(out->nx * out->ny, sizeof *out->value);
    enum status_code rc = room && out->value ? STATUS_OK : status_memory(status);
    for (size_t bolt = 0; rc == STATUS_OK && bolt < bolts->count; bolt++)
        if (!add_bolt(out, bolts, bolt, side_m, room))
            rc = status_fail(status, STATUS_MODEL, "bolt %zu presses on less than a cell of the area", bolt + 1);
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
