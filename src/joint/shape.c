/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "joint/shape.h"

#include "base/fft.h"
#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS_MOST = 200, STEPS_WHOLE = 25, ITERATIONS_MOST = 5000, FIELDS = 15 };
const double shape_largest_area = 0.97, shape_yielding_most = 0.05;
static const double precision = 1e-11;     /* of conjugate gradients */
static const double converged = 1e-9;      /* change of a pressure over the mean pressure */
static const double step_most = 2;         /* largest rise of ln(p/(1 - p/H)) below the hardness, largest fall above */
static const double share_least = 1. / 16; /* of a step */
static const double negligible = 1e-6;     /* pressure over the mean pressure */
static const double carried = 0.9;         /* share of the load on the area that counts as carrying it */
static const double yields = 0.999;        /* pressure over the hardness */
static const double kept_slope = 1e-3;     /* least slope of a gap over its mean slope */

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
        return status_fail(status, STATUS_MODEL, "its curve over pressure has %zu points; at least 3 are needed",
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
    shape->forth = fftw_plan_dft_2d(ny, nx, shape->pair, shape->pair, FFTW_FORWARD, FFTW_ESTIMATE);
    shape->back = fftw_plan_dft_2d(ny, nx, shape->pair, shape->pair, FFTW_BACKWARD, FFTW_ESTIMATE);
}

/** The point that a cosine transform of n points has in place k: the even ones, then the odd ones backwards (Makhoul
 * 1980, doi:10.1109/TASSP.1980.1163351). */
static size_t place_of(size_t k, size_t n)
{
    return 2 * k < n ? 2 * k : 2 * (n - k) - 1;
}

enum status_code shape_make(struct shape *out, size_t nx, size_t ny, const double side_m[2], struct status *status)
{
    *out = (struct shape){.nx = nx, .ny = ny, .cells = nx * ny, .side_m = {side_m[0], side_m[1]}};
    out->pair = fftw_alloc_complex(out->cells);
    out->turns = calloc(out->cells, sizeof *out->turns);
    out->place = calloc(out->cells, sizeof *out->place);
    out->room = calloc(FIELDS * out->cells, sizeof(double));
    if (!out->pair || !out->turns || !out->place || !out->room)
        return status_memory(status);
    for (size_t k = 0; k < out->cells; k++) {
        out->place[k] = place_of(k / nx, ny) * nx + place_of(k % nx, nx);
        double of_x = M_PI * (double)(k % nx) / (2 * (double)nx), of_y = M_PI * (double)(k / nx) / (2 * (double)ny);
        const double turns[] = {cos(of_y + of_x), -sin(of_y + of_x), cos(of_y - of_x), -sin(of_y - of_x)};
        memcpy(out->turns[k], turns, sizeof turns);
    }
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
    fftw_free(shape->pair);
    free(shape->turns);
    free(shape->place);
    free(shape->room);
    *shape = (struct shape){0};
}

/** out = (a + sign b) turned by the angle of cosine c and sine s. */
static void turn(fftw_complex out, const double a[2], const double b[2], double sign, double c, double s)
{
    double re = a[0] + sign * b[0], im = a[1] + sign * b[1];
    out[0] = c * re - s * im;
    out[1] = c * im + s * re;
}

/** Multiplies the cosines held by a mode and by its mirror modes (n - k along x, along y and along both) by their
 * factors, in place. */
static void apply_to_four(fftw_complex *const at[4], const double share[4], const double turns[4])
{
    static const double zero[2] = {0};
    fftw_complex one[4] = {{0}};
    double along[2], across[2], both[2], back[2];
    turn(one[0], *at[0], zero, 0, turns[0], turns[1]);
    turn(one[1], *at[1], zero, 0, turns[2], turns[3]);
    turn(one[2], *at[2], zero, 0, turns[2], -turns[3]);
    turn(one[3], *at[3], zero, 0, turns[0], -turns[1]);
    for (int k = 0; k < 2; k++) {
        double p = one[0][k] + one[1][k], m = one[0][k] - one[1][k], r = one[2][k] + one[3][k],
               n = one[2][k] - one[3][k];
        double pr = share[0] * (p + r), rp = share[2] * (p - r), mn = share[1] * (m + n), nm = share[3] * (m - n);
        along[k] = pr + rp;
        across[k] = pr - rp;
        both[k] = mn + nm;
        back[k] = mn - nm;
    }
    turn(*at[0], along, both, 1, turns[0], -turns[1]);
    turn(*at[1], along, both, -1, turns[2], -turns[3]);
    turn(*at[2], across, back, 1, turns[2], turns[3]);
    turn(*at[3], across, back, -1, turns[0], turns[1]);
}

/** Replaces one or two fields by S of them, with the factors of the table: one complex transform for both (second NULL:
 * only one). */
static void apply(struct shape *shape, double *first, double *second)
{
    const size_t nx = shape->nx, ny = shape->ny;
    const double *table = shape->table;
    fftw_complex *pair = shape->pair;
    for (size_t k = 0; k < shape->cells; k++) {
        pair[k][0] = first[shape->place[k]];
        pair[k][1] = second ? second[shape->place[k]] : 0;
    }
    fftw_execute(shape->forth);
    for (size_t j = 0; j <= ny / 2; j++)
        for (size_t i = 0; i <= nx / 2; i++) {
            const size_t right = i > 0 ? nx - i : 0, down = j > 0 ? ny - j : 0,
                         of[4] = {j * nx + i, j * nx + right, down * nx + i, down * nx + right};
            fftw_complex *const at[4] = {&pair[of[0]], &pair[of[1]], &pair[of[2]], &pair[of[3]]};
            const double share[4] = {table[of[0]], table[of[1]], table[of[2]], table[of[3]]};
            apply_to_four(at, share, shape->turns[of[0]]);
        }
    fftw_execute(shape->back);
    for (size_t k = 0; k < shape->cells; k++) {
        first[shape->place[k]] = pair[k][0];
        if (second)
            second[shape->place[k]] = pair[k][1];
    }
}

/** Sum of resistivity tanh(|q| t)/|q| over the two bodies, over the 4 n_x n_y of the cosine transforms. */
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

/** Solves (1 + D S D) y = b for one or two b by conjugate gradients until the residual has fallen to the share `goal`;
 * the matrix is symmetric and has no eigenvalue below 1. `work`: for each b three fields, of which the first is b and
 * is overwritten. */
static enum status_code solve(double *const y[], double *const work[], int count, struct shape *shape,
                              const double *scale, double goal, struct status *status)
{
    size_t n = shape->cells;
    double square[2] = {0}, least[2] = {0};
    for (int b = 0; b < count; b++) {
        square[b] = dot(work[b], work[b], n);
        least[b] = goal * goal * square[b];
        memset(y[b], 0, n * sizeof *y[b]);
        memcpy(work[b] + n, work[b], n * sizeof *work[b]);
    }
    for (size_t i = 0; square[0] > least[0] || (count > 1 && square[1] > least[1]); i++) {
        if (i == ITERATIONS_MOST || !isfinite(square[0] + square[1]))
            return status_fail(status, STATUS_MODEL, "its conjugate gradients do not converge");
        for (int b = 0; b < count; b++) { /* scaled to one size: rounding of a larger one would disturb the other */
            double size = square[b] > least[b] ? 1 / sqrt(square[b]) : 0;
            for (size_t k = 0; k < n; k++)
                work[b][2 * n + k] = scale[k] * work[b][n + k] * size;
        }
        apply(shape, work[0] + 2 * n, count > 1 ? work[1] + 2 * n : NULL);
        for (int b = 0; b < count; b++) {
            if (!(square[b] > least[b])) /* only the other goes on */
                continue;
            double *residual = work[b], *direction = residual + n, *field = direction + n, before = square[b];
            double curvature = 0, size = sqrt(before);
            for (size_t k = 0; k < n; k++) {
                field[k] = direction[k] + scale[k] * size * field[k];
                curvature += direction[k] * field[k];
            }
            square[b] = 0;
            for (size_t k = 0; k < n; k++) {
                y[b][k] += before / curvature * direction[k];
                residual[k] -= before / curvature * field[k];
                square[b] += residual[k] * residual[k];
            }
            for (size_t k = 0; k < n; k++)
                direction[k] = residual[k] + square[b] / before * direction[k];
        }
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

/** One step of Newton's method for z = ln(p/(1 - p/H)), which keeps 0 < p < H. With dp/dz = p (1 - p/H), U = -du/dz,
 * D = sqrt(dp/dz/U), S including 2/E' and the residual r = -u + g0 + S[p]: (1 + D S D) y = D (d - r), Delta z =
 * (d - r - S[D y])/U, d such that p + dp/dz Delta z has the mean pressure. Only the share `share` of the step is taken.
 * `change`: largest change of a pressure over the mean pressure, INFINITY where a step was cut; the value passed in, of
 * the step before, says how exactly to solve. */
static enum status_code step(double *change, struct shape *shape, const double *gap_m, const struct shape_curve *gap,
                             double share, struct status *status)
{
    const double mean_Pa = shape->mean_Pa, ln_hardness = log(gap->most_Pa);
    const double goal =
        *change > 0.1 ? 1e-6 : fmax(1e-3 * *change, precision); /* less exact first steps do not converge */
    size_t n = shape->cells;
    double *scale = shape->room, *slope = scale + n, *rest = slope + n, *const y[2] = {rest + n, rest + 2 * n};
    double *const work[2] = {rest + 3 * n, rest + 6 * n}, *field = work[0], *p = shape->pressure_Pa;
    double *level = shape->level, sums[2], middle = 0, pressures = 0;
    memcpy(field, p, n * sizeof *p);
    apply(shape, field, NULL);
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
    for (size_t k = 0; k < n; k++) {
        work[0][k] = scale[k] * rest[k];
        work[1][k] = scale[k];
    }
    if (solve(y, work, 2, shape, scale, goal, status) != STATUS_OK)
        return status->code;
    for (int side = 0; side < 2; side++)
        sums[side] = dot(scale, y[side], n);
    double approach = ((double)n * mean_Pa - pressures + sums[0]) / sums[1];
    for (size_t k = 0; k < n; k++)
        field[k] = scale[k] * (approach * y[1][k] - y[0][k]);
    apply(shape, field, NULL);
    const double low = log(negligible * mean_Pa), high = ln_hardness + step_most;
    *change = 0;
    for (size_t k = 0; k < n; k++) {
        double asked = level[k] + (approach - rest[k] - field[k]) / -slope[k];
        double now = level[k] > ln_hardness ? fmax(asked, fmin(level[k] - step_most, high))
                                            : fmin(asked, fmax(level[k] + step_most, low));
        slope[k] = p[k]; /* the pressure before the step */
        *change = now != asked ? INFINITY : *change;
        level[k] += share * (now - level[k]);
    }
    set_pressures(shape, ln_hardness);
    for (size_t k = 0; k < n; k++)
        *change = fmax(*change, fabs(p[k] - slope[k]) / (share * mean_Pa));
    return STATUS_OK;
}

enum status_code shape_press(struct shape *shape, const double *gap_m, const struct shape_curve *gap,
                             double effective_modulus_Pa, double mean_Pa, struct status *status)
{
    const struct shape_body bodies[2] = {{2 / effective_modulus_Pa, INFINITY}, {0, INFINITY}};
    double change = INFINITY, last = INFINITY, share = 1;
    if (!(mean_Pa > 0 && mean_Pa < gap->most_Pa))
        return status_fail(status, STATUS_MODEL, "its mean pressure is not below the hardness");
    fill_table(shape, bodies);
    for (size_t k = 0; k < shape->cells; k++) /* starting from the last solution halves the time */
        shape->level[k] = shape->mean_Pa > 0 ? shape->level[k] + log(mean_Pa / shape->mean_Pa)
                                             : log(mean_Pa / (1 - mean_Pa / gap->most_Pa));
    shape->mean_Pa = mean_Pa;
    set_pressures(shape, log(gap->most_Pa));
    for (shape->steps = 0; change > converged; shape->steps++) {
        if (shape->steps == STEPS_MOST)
            return status_fail(status, STATUS_MODEL, "its pressures do not converge");
        if (step(&change, shape, gap_m, gap, share, status) != STATUS_OK)
            return status->code;
        if (shape->steps >= STEPS_WHOLE) /* it circles a bend of the curve */
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
    fill_table(shape, bodies);
    for (size_t k = 0; k < n; k++)
        root[k] = work[k] = exp(shape_curve_value(&unused, conductance, shape->ln_pressure[k]) / 2);
    if (solve(&y, &work, 1, shape, root, precision, status) != STATUS_OK)
        return status->code;
    *spots = dot(y, y, n) / dot(root, y, n);
    *out = (double)n / (dot(root, y, n) * shape->side_m[0] * shape->side_m[1]);
    return STATUS_OK;
}

struct shape_spread shape_spread(struct shape *shape, double hardness_Pa)
{
    size_t n = shape->cells, carrying = 0;
    double *sorted = shape->room, total = 0, yielding = 0, sum = 0;
    memcpy(sorted, shape->pressure_Pa, n * sizeof *sorted);
    gsl_sort(sorted, 1, n);
    for (size_t k = n; k-- > 0;) {
        total += sorted[k];
        yielding += sorted[k] >= yields * hardness_Pa ? sorted[k] : 0;
    }
    for (; carrying < n && sum < carried * total; carrying++)
        sum += sorted[n - 1 - carrying];
    return (struct shape_spread){
        .largest_Pa = sorted[n - 1], .area = (double)carrying / (double)n, .yielding_load = yielding / total};
}
