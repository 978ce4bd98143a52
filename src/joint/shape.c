/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "joint/shape.h"

#include "base/fft.h"
#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS_MOST = 200, STEPS_WHOLE = 25, ITERATIONS_MOST = 5000, FIELDS = 11 };
const double shape_largest_area = 0.97, shape_yielding_most = 0.05;
static const double precision = 1e-12;     /* of conjugate gradients */
static const double converged = 1e-11;     /* change of a pressure over the mean one */
static const double step_most = 2;         /* rise of ln p(1 - p/H)^-1 below the hardness, fall at it */
static const double share_least = 1. / 16; /* of a step */
static const double negligible = 1e-6;     /* over the mean one */
static const double carried = 0.9;         /* share of the load that the area carries which is said to carry it */
static const double yields = 0.999;        /* of the hardness */
static const double kept_slope = 1e-3;     /* over the mean slope of a gap, where it falls no more */

static enum status_code curve_make(struct shape_curve *out, const double *pressure_Pa, const double *value,
                                   size_t count, double most_Pa, struct status *status)
{
    *out = (struct shape_curve){.ln_pressure = calloc(2 * count + 1, sizeof(double)), .most_Pa = most_Pa};
    if (!out->ln_pressure)
        return status_memory(status);
    out->value = out->ln_pressure + count;
    for (size_t i = 0; i < count && pressure_Pa[i] < most_Pa; i++, out->count++) {
        out->ln_pressure[i] = log(pressure_Pa[i]);
        out->value[i] = value[i];
        if (!isfinite(out->ln_pressure[i]) || !isfinite(value[i]) || (i > 0 && pressure_Pa[i] <= pressure_Pa[i - 1]))
            return status_fail(status, STATUS_MODEL, "its curve over pressure is not finite at %.3g MPa",
                               pressure_Pa[i] * 1e-6);
    }
    if (out->count < 3)
        return status_fail(status, STATUS_MODEL, "its curve over pressure has %zu points, of the 3 it takes",
                           out->count);
    out->between = gsl_interp_alloc(gsl_interp_steffen, out->count);
    out->nearest = gsl_interp_accel_alloc();
    return out->between && out->nearest ? STATUS_OK : status_memory(status);
}

static void interpolate(struct shape_curve *curve)
{
    const double *x = curve->ln_pressure, *y = curve->value;
    gsl_interp_init(curve->between, x, y, curve->count);
    curve->below = gsl_interp_eval_deriv(curve->between, x, y, x[0], curve->nearest);
}

enum status_code shape_curve_gap(struct shape_curve *out, const double *pressure_Pa, const double *gap_m, size_t count,
                                 double hardness_Pa, struct status *status)
{
    if (curve_make(out, pressure_Pa, gap_m, count, hardness_Pa, status) != STATUS_OK)
        return status->code;
    const double *x = out->ln_pressure;
    size_t last = out->count - 1;
    double mean = (out->value[last] - out->value[0]) / (x[last] - x[0]);
    if (!(mean < 0))
        return status_fail(status, STATUS_MODEL, "its gap does not fall with the pressure");
    out->above = kept_slope * mean;
    for (size_t i = 1; i <= last; i++)
        out->value[i] = fmin(out->value[i], out->value[i - 1] + out->above * (x[i] - x[i - 1]));
    interpolate(out);
    return STATUS_OK;
}

enum status_code shape_curve_conductance(struct shape_curve *out, const double *pressure_Pa, const double *conductance,
                                         size_t count, struct status *status)
{
    if (curve_make(out, pressure_Pa, conductance, count, INFINITY, status) != STATUS_OK)
        return status->code;
    for (size_t i = 0; i < out->count; i++) {
        out->value[i] = log(out->value[i]);
        if (!isfinite(out->value[i]))
            return status_fail(status, STATUS_MODEL, "it conducts nothing at %.3g MPa", pressure_Pa[i] * 1e-6);
    }
    interpolate(out);
    return STATUS_OK;
}

void shape_curve_free(struct shape_curve *curve)
{
    gsl_interp_free(curve->between);
    gsl_interp_accel_free(curve->nearest);
    free(curve->ln_pressure);
    *curve = (struct shape_curve){0};
}

double shape_curve_value(double *slope, const struct shape_curve *curve, double ln_pressure)
{
    const double *x = curve->ln_pressure, *y = curve->value;
    double inside = fmin(fmax(ln_pressure, x[0]), x[curve->count - 1]);
    *slope = ln_pressure < inside   ? curve->below
             : ln_pressure > inside ? curve->above
                                    : gsl_interp_eval_deriv(curve->between, x, y, inside, curve->nearest);
    double outside = ln_pressure == inside ? 0 : *slope * (ln_pressure - inside);
    *slope = curve->above < 0 ? fmin(*slope, curve->above) : *slope;
    return gsl_interp_eval(curve->between, x, y, inside, curve->nearest) + outside;
}

static void make_plans(void *context)
{
    struct shape *shape = context;
    int nx = (int)shape->nx, ny = (int)shape->ny;
    shape->forth = fftw_plan_r2r_2d(ny, nx, shape->field, shape->field, FFTW_REDFT10, FFTW_REDFT10, FFTW_ESTIMATE);
    shape->back = fftw_plan_r2r_2d(ny, nx, shape->field, shape->field, FFTW_REDFT01, FFTW_REDFT01, FFTW_ESTIMATE);
}

enum status_code shape_make(struct shape *out, size_t nx, size_t ny, const double side_m[2], struct status *status)
{
    *out = (struct shape){.nx = nx, .ny = ny, .cells = nx * ny, .side_m = {side_m[0], side_m[1]}};
    if (nx < 2 || ny < 2 || nx > SHAPE_SIDE_MOST || ny > SHAPE_SIDE_MOST || !(side_m[0] > 0 && side_m[1] > 0) ||
        !isfinite(side_m[0] + side_m[1]))
        return status_fail(status, STATUS_USAGE, "an area of %g m x %g m in %zu x %zu cells cannot be solved",
                           side_m[0], side_m[1], nx, ny);
    out->field = fftw_alloc_real(out->cells);
    out->room = calloc(FIELDS * out->cells, sizeof(double));
    if (!out->field || !out->room)
        return status_memory(status);
    fft_plan(make_plans, out);
    out->pressure_Pa = out->room + (FIELDS - 1) * out->cells;
    out->ln_pressure = out->pressure_Pa - out->cells;
    out->table = out->ln_pressure - out->cells;
    out->level = out->table - out->cells;
    return STATUS_OK;
}

void shape_free(struct shape *shape)
{
    fft_plan_free(shape->forth);
    fft_plan_free(shape->back);
    fftw_free(shape->field);
    free(shape->room);
    *shape = (struct shape){0};
}

/** The field becomes S[field] times what the table has of it. */
static void apply(struct shape *shape)
{
    fftw_execute(shape->forth);
    for (size_t k = 0; k < shape->cells; k++)
        shape->field[k] *= shape->table[k];
    fftw_execute(shape->back);
}

/** Sum of resistivity tanh(|q| t)/|q| over the two bodies, with the 1/(4 n_x n_y) of the cosine transforms. */
static void fill_table(struct shape *shape, const struct shape_body bodies[2])
{
    shape->table[0] = 0;
    for (size_t k = 1; k < shape->cells; k++) {
        double i = (double)(k % shape->nx), j = (double)(k / shape->nx), sum = 0;
        double q = M_PI * hypot(i / shape->side_m[0], j / shape->side_m[1]);
        for (int side = 0; side < 2; side++)
            sum += bodies[side].resistivity * tanh(q * bodies[side].thickness_m) / q;
        shape->table[k] = sum / (4 * (double)shape->cells);
    }
}

static double dot(const double *a, const double *b, size_t count)
{
    double sum = 0;
    for (size_t k = 0; k < count; k++)
        sum += a[k] * b[k];
    return sum;
}

/** Solves (1 + D S D) y = b by conjugate gradients, until of the residual no more than the share `goal` is left; the
 * matrix is symmetric and has no eigenvalue below 1. `work`: two fields, of which the first is b and is used up. */
static enum status_code solve(double *y, struct shape *shape, const double *scale, double *work, double goal,
                              struct status *status)
{
    size_t n = shape->cells;
    double *residual = work, *direction = work + n, *field = shape->field;
    double square = dot(residual, residual, n), least = goal * goal * square;
    memset(y, 0, n * sizeof *y);
    memcpy(direction, residual, n * sizeof *direction);
    for (size_t i = 0; square > least; i++, shape->iterations++) {
        if (i == ITERATIONS_MOST || !isfinite(square))
            return status_fail(status, STATUS_MODEL, "its conjugate gradients do not converge");
        for (size_t k = 0; k < n; k++)
            field[k] = scale[k] * direction[k];
        apply(shape);
        double curvature = 0, before = square;
        for (size_t k = 0; k < n; k++) {
            field[k] = direction[k] + scale[k] * field[k];
            curvature += direction[k] * field[k];
        }
        square = 0;
        for (size_t k = 0; k < n; k++) {
            y[k] += before / curvature * direction[k];
            residual[k] -= before / curvature * field[k];
            square += residual[k] * residual[k];
        }
        for (size_t k = 0; k < n; k++)
            direction[k] = residual[k] + square / before * direction[k];
    }
    return STATUS_OK;
}

/** Pressures of the levels z = ln(p/(1 - p/H)). */
static void set_pressures(struct shape *shape, double ln_hardness)
{
    for (size_t k = 0; k < shape->cells; k++) {
        double over = shape->level[k] - ln_hardness;
        shape->ln_pressure[k] = over < 0 ? shape->level[k] - log1p(exp(over)) : ln_hardness - log1p(exp(-over));
        shape->pressure_Pa[k] = exp(shape->ln_pressure[k]);
    }
}

/** One step of Newton on z = ln(p/(1 - p/H)), which keeps 0 < p < H, with dp/dz = p (1 - p/H), U = -du/dz and D =
 * sqrt(dp/dz/U), S with its 2/E', of the residual r = -u + g0 + S[p]: (1 + D S D) y = D (d - r), Delta z = (d - r - S[D
 * y])/U, d such that the mean of p + dp/dz Delta z is the load's. `change`: the largest of a pressure over the mean
 * one; INFINITY: one was cut short; that of the step before says how exactly the systems are solved. `share` of the
 * step is done. */
static enum status_code step(double *change, struct shape *shape, const double *gap_m, const struct shape_curve *gap,
                             double share, struct status *status)
{
    const double mean_Pa = shape->mean_Pa, ln_hardness = log(gap->most_Pa);
    const double goal = *change < 1 ? fmax(1e-2 * *change, precision) : 1e-6;
    size_t n = shape->cells;
    double *scale = shape->room, *slope = scale + n, *rest = slope + n, *y[2] = {rest + n, rest + 2 * n};
    double *work = rest + 3 * n, *p = shape->pressure_Pa, *level = shape->level, *field = shape->field;
    double sums[2] = {0}, middle = 0, pressures = 0;
    memcpy(field, p, n * sizeof *p);
    apply(shape);
    for (size_t k = 0; k < n; k++) {
        double over = exp(level[k] - ln_hardness), free = 1 / (1 + over);
        double closing = level[k] > shape->ln_pressure[k] ? gap->above * (level[k] - shape->ln_pressure[k]) : 0;
        rest[k] = gap_m[k] + field[k] - shape_curve_value(&slope[k], gap, shape->ln_pressure[k]) - closing;
        slope[k] = slope[k] * free + gap->above * (1 - free);
        scale[k] = sqrt(p[k] * free / -slope[k]);
        middle += p[k] * rest[k];
        pressures += p[k];
    }
    for (size_t k = 0; k < n; k++)
        rest[k] -= middle / pressures;
    for (int side = 0; side < 2; side++) {
        for (size_t k = 0; k < n; k++)
            work[k] = scale[k] * (side ? 1 : rest[k]);
        if (solve(y[side], shape, scale, work, goal, status) != STATUS_OK)
            return status->code;
        sums[side] = dot(scale, y[side], n);
    }
    double approach = ((double)n * mean_Pa - pressures + sums[0]) / sums[1];
    for (size_t k = 0; k < n; k++)
        field[k] = scale[k] * (approach * y[1][k] - y[0][k]);
    apply(shape);
    const double low = log(negligible * mean_Pa), high = ln_hardness + step_most;
    *change = 0;
    for (size_t k = 0; k < n; k++) {
        double asked = level[k] + (approach - rest[k] - field[k]) / -slope[k];
        double now = level[k] > ln_hardness ? fmax(asked, fmin(level[k] - step_most, high))
                                            : fmin(asked, fmax(level[k] + step_most, low));
        work[k] = p[k];
        *change = now != asked ? INFINITY : *change;
        level[k] += share * (now - level[k]);
    }
    set_pressures(shape, ln_hardness);
    for (size_t k = 0; k < n; k++)
        *change = fmax(*change, fabs(p[k] - work[k]) / (share * mean_Pa));
    return STATUS_OK;
}

enum status_code shape_press(struct shape *shape, const double *gap_m, const struct shape_curve *gap,
                             double effective_modulus_Pa, double mean_Pa, struct status *status)
{
    const struct shape_body bodies[2] = {{2 / effective_modulus_Pa, INFINITY}, {0, INFINITY}};
    double change = INFINITY, last = INFINITY, share = 1;
    shape->iterations = 0;
    if (!(mean_Pa > 0 && mean_Pa < gap->most_Pa))
        return status_fail(status, STATUS_MODEL, "its mean pressure is not below the hardness");
    fill_table(shape, bodies);
    for (size_t k = 0; k < shape->cells; k++) /* from the last solution, which takes half the time */
        shape->level[k] = shape->mean_Pa > 0 ? shape->level[k] + log(mean_Pa / shape->mean_Pa)
                                             : log(mean_Pa / (1 - mean_Pa / gap->most_Pa));
    shape->mean_Pa = mean_Pa;
    set_pressures(shape, log(gap->most_Pa));
    for (shape->steps = 0; change > converged; shape->steps++) {
        if (shape->steps == STEPS_MOST)
            return status_fail(status, STATUS_MODEL, "its pressures do not converge");
        if (step(&change, shape, gap_m, gap, share, status) != STATUS_OK)
            return status->code;
        if (shape->steps >= STEPS_WHOLE) /* it goes round a bend of the curve */
            share = change < last * (1 - share / 2) ? fmin(2 * share, 1) : fmax(share / 2, share_least);
        last = change;
    }
    return STATUS_OK;
}

enum status_code shape_resistance(double *out, double *spots, struct shape *shape,
                                  const struct shape_curve *conductance, const struct shape_body bodies[2],
                                  struct status *status)
{
    size_t n = shape->cells;
    double *root = shape->room, *y = root + n, *work = y + n, unused;
    shape->iterations = 0;
    fill_table(shape, bodies);
    for (size_t k = 0; k < n; k++)
        root[k] = work[k] = exp(shape_curve_value(&unused, conductance, shape->ln_pressure[k]) / 2);
    if (solve(y, shape, root, work, precision, status) != STATUS_OK)
        return status->code;
    *spots = dot(y, y, n) / dot(root, y, n);
    *out = (double)n / (dot(root, y, n) * shape->side_m[0] * shape->side_m[1]);
    return STATUS_OK;
}

struct shape_spread shape_spread(struct shape *shape, double hardness_Pa)
{
    size_t n = shape->cells, most = 0, carrying = 0;
    double *sorted = shape->room, total = 0, at_most = 0, sum = 0;
    memcpy(sorted, shape->pressure_Pa, n * sizeof *sorted);
    gsl_sort(sorted, 1, n);
    for (size_t k = n; k-- > 0;)
        total += sorted[k];
    for (; most < n && sorted[n - 1 - most] >= yields * hardness_Pa; most++)
        at_most += sorted[n - 1 - most];
    for (; carrying < n && sum < carried * total; carrying++)
        sum += sorted[n - 1 - carrying];
    return (struct shape_spread){.largest_Pa = sorted[n - 1],
                                 .area = (double)carrying / (double)n,
                                 .yielding = most,
                                 .yielding_load = at_most / total};
}
