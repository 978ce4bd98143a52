/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "profile/level.h"

#include <float.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>

const char *const level_names[LEVEL_COUNT] = {"none", "mean", "line", "parabola", "circle", "robust"};

static const double tukey_tuning = 4.685;        /* 95 % efficiency for Gaussian residuals */
static const double mad_to_deviation = 1.482602; /* 1/Phi^-1(3/4) */
enum { ROBUST_STEPS = 50, ARC_STEPS = 50, ARC_HALVINGS = 40 };

/** Where the points are, as u = -1...1 over the record. */
struct record {
    const double *x_m; /* NULL: uniform */
    size_t points;
    double middle_m, half_m;
};

/** a0 + a1 (u - centre) + a2 ((u - centre)² - bend (u - centre) - square): orthogonal over the record. */
struct polynomial {
    double a[3];
    double centre, bend, square;
};

static double place(const struct record *record, size_t i)
{
    if (record->x_m)
        return (record->x_m[i] - record->middle_m) / record->half_m;
    double half = (double)(record->points - 1) / 2;
    return ((double)i - half) / half;
}

static struct record record_of(const double *x_m, size_t points, double spacing_m)
{
    if (x_m)
        return (struct record){x_m, points, (x_m[points - 1] + x_m[0]) / 2, (x_m[points - 1] - x_m[0]) / 2};
    return (struct record){NULL, points, 0, (double)(points - 1) / 2 * spacing_m};
}

/** Least squares, weighted where `weight` is not NULL, of degree 0 to 2. */
static struct polynomial fit(const struct record *record, const double *z, const double *weight, int degree)
{
    struct polynomial p = {0};
    double count = 0, mean = 0, square = 0, cube = 0, slope = 0;
    for (size_t i = 0; i < record->points; i++) {
        double w = weight ? weight[i] : 1;
        count += w;
        p.centre += w * place(record, i);
        mean += w * (z[i] - z[0]);
    }
    p.centre /= count;
    mean = mean / count + z[0]; /* about the first height, so that an offset of many Rq costs no digits */
    p.a[0] = mean;
    if (degree < 1)
        return p;
    for (size_t i = 0; i < record->points; i++) {
        double w = weight ? weight[i] : 1, v = place(record, i) - p.centre;
        square += w * v * v;
        cube += w * v * v * v;
        slope += w * v * (z[i] - mean);
    }
    p.a[1] = slope / square;
    if (degree < 2)
        return p;
    p.bend = cube / square;
    p.square = square / count;
    double along = 0, norm = 0;
    for (size_t i = 0; i < record->points; i++) {
        double v = place(record, i) - p.centre, form = v * v - p.bend * v - p.square;
        along += form * (z[i] - mean - p.a[1] * v);
        norm += form * form;
    }
    p.a[2] = norm > 0 ? along / norm : 0;
    return p;
}

static void take_out(const struct record *record, double *z, const struct polynomial *p)
{
    for (size_t i = 0; i < record->points; i++) {
        double v = place(record, i) - p->centre;
        z[i] = z[i] - p->a[0] - p->a[1] * v - p->a[2] * (v * v - p->bend * v - p->square);
    }
}

/** Median of |values|; `work` holds as many. */
static double median_size(const double *values, double *work, size_t count)
{
    for (size_t i = 0; i < count; i++)
        work[i] = fabs(values[i]);
    return gsl_stats_median(work, 1, count);
}

/** A line that nearly half the points cannot move far: the median slope over half the record, the median height. */
static struct polynomial first_line(const struct record *record, const double *z, double *work)
{
    size_t half = record->points / 2, pairs = record->points - half;
    struct polynomial p = {0};
    for (size_t i = 0; i < pairs; i++)
        work[i] = (z[i + half] - z[i]) / (place(record, i + half) - place(record, i));
    p.a[1] = gsl_stats_median(work, 1, pairs);
    for (size_t i = 0; i < record->points; i++)
        work[i] = z[i] - p.a[1] * place(record, i);
    p.a[0] = gsl_stats_median(work, 1, record->points);
    return p;
}

/** Tukey's weights of the residuals; how many are 0: less than half, since half the residuals are below the scale. */
static size_t weigh(double *weight, const double *residual, size_t points, double scale)
{
    size_t outliers = 0;
    for (size_t i = 0; i < points; i++) {
        double r = residual[i] / (tukey_tuning * scale);
        weight[i] = fabs(r) < 1 ? (1 - r * r) * (1 - r * r) : 0;
        outliers += weight[i] == 0 ? 1 : 0;
    }
    return outliers;
}

static enum status_code take_robust_line(struct levelling *out, const struct record *record, double *z,
                                         struct status *status)
{
    size_t n = record->points;
    double *work = malloc(3 * n * sizeof *work);
    if (!work)
        return status_memory(status);
    double *weight = work + n, *residual = work + 2 * n, last = INFINITY, largest = 0;
    for (size_t i = 0; i < n; i++)
        largest = fmax(largest, fabs(z[i]));
    struct polynomial line = first_line(record, z, work);
    for (int step = 0; step < ROBUST_STEPS; step++) {
        for (size_t i = 0; i < n; i++)
            residual[i] = z[i] - line.a[0] - line.a[1] * (place(record, i) - line.centre);
        /* never below what rounding leaves of points on one line */
        double scale = fmax(mad_to_deviation * median_size(residual, work, n), 4 * DBL_EPSILON * largest);
        out->outliers = weigh(weight, residual, n, scale);
        line = fit(record, z, weight, 1);
        if (fabs(line.a[1] - last) <= 1e-12 * scale)
            break;
        last = line.a[1];
    }
    take_out(record, z, &line);
    out->tilt = line.a[1] / record->half_m;
    free(work);
    return STATUS_OK;
}

/** c, s, k of an arc in u and z/half_m (level.h). */
struct arc {
    double height, sine, bend;
};

static double arc_at(const struct arc *arc, double u)
{
    double end = arc->sine + arc->bend * u;
    return arc->height + u * (arc->sine + end) / (sqrt(1 - arc->sine * arc->sine) + sqrt(1 - end * end));
}

static bool arc_is_whole(const struct arc *arc)
{
    return fabs(arc->sine) + fabs(arc->bend) < 0.9999;
}

static double arc_misfit(const struct record *record, const double *z, const struct arc *arc)
{
    double sum = 0;
    for (size_t i = 0; i < record->points; i++) {
        double r = z[i] / record->half_m - arc_at(arc, place(record, i));
        sum += r * r;
    }
    return sum;
}

/** Derivatives of the arc by its three parameters: 1, integrals of cos^-3 b and of u cos^-3 b, the last by its series
 * for a small bend and by parts else. */
static void arc_gradient(double gradient[3], const struct arc *arc, double u)
{
    double end = arc->sine + arc->bend * u, a = asin(arc->sine), b = asin(end), cube = pow(cos(a), -3);
    gradient[0] = 1;
    gradient[1] = u * cos((b - a) / 2) / (cos((a + b) / 2) * cos(a) * cos(b));
    if (fabs(arc->bend) < 1e-3)
        gradient[2] = u * u * cube * (0.5 + arc->sine * arc->bend * u / (cos(a) * cos(a)));
    else
        gradient[2] = (u * tan(b) - (arc_at(arc, u) - arc->height)) / arc->bend;
}

/** One step of Gauss and Newton, halved until the misfit falls. Returns whether it moved. */
static bool improve(const struct record *record, const double *z, struct arc *arc, double *misfit)
{
    double m[3][3] = {{0}}, v[3] = {0}, g[3];
    for (size_t i = 0; i < record->points; i++) {
        double u = place(record, i), r = z[i] / record->half_m - arc_at(arc, u);
        arc_gradient(g, arc, u);
        for (int a = 0; a < 3; a++) {
            v[a] += g[a] * r;
            for (int b = 0; b < 3; b++)
                m[a][b] += g[a] * g[b];
        }
    }
    gsl_matrix_view normal = gsl_matrix_view_array(m[0], 3, 3);
    gsl_vector_view change = gsl_vector_view_array(v, 3);
    if (gsl_linalg_cholesky_decomp1(&normal.matrix) != GSL_SUCCESS ||
        gsl_linalg_cholesky_svx(&normal.matrix, &change.vector) != GSL_SUCCESS)
        return false;
    for (int half = 0; half < ARC_HALVINGS; half++) {
        struct arc next = {arc->height + v[0], arc->sine + v[1], arc->bend + v[2]};
        double error = arc_is_whole(&next) ? arc_misfit(record, z, &next) : INFINITY;
        if (error < *misfit) {
            bool moved = *misfit - error > 1e-14 * error;
            *arc = next;
            *misfit = error;
            return moved;
        }
        v[0] /= 2, v[1] /= 2, v[2] /= 2;
    }
    return false;
}

static enum status_code take_arc(struct levelling *out, const struct record *record, double *z, struct status *status)
{
    double first = z[0]; /* 3 mm of offset would cost digits */
    for (size_t i = 0; i < record->points; i++)
        z[i] -= first;
    struct polynomial p = fit(record, z, NULL, 2);
    double slope = (p.a[1] - p.a[2] * (2 * p.centre + p.bend)) / record->half_m;
    struct arc arc = {p.a[0] / record->half_m, slope / sqrt(1 + slope * slope), 2 * p.a[2] / record->half_m};
    if (!arc_is_whole(&arc))
        arc = (struct arc){p.a[0] / record->half_m, 0, copysign(0.9, arc.bend)};
    double misfit = arc_misfit(record, z, &arc);
    for (int step = 0; step < ARC_STEPS && improve(record, z, &arc, &misfit); step++)
        ;
    if (!isfinite(misfit))
        return status_fail(status, STATUS_SCAN, "no arc fits the record; use level: parabola");
    for (size_t i = 0; i < record->points; i++)
        z[i] -= arc_at(&arc, place(record, i)) * record->half_m;
    out->tilt = arc.sine / sqrt(1 - arc.sine * arc.sine);
    out->radius_m = record->half_m / arc.bend;
    return STATUS_OK;
}

enum status_code level_remove(struct levelling *out, double *height_m, const double *x_m, size_t points,
                              double spacing_m, enum level level, struct status *status)
{
    *out = (struct levelling){.radius_m = INFINITY};
    struct record record = record_of(x_m, points, spacing_m);
    if (level == LEVEL_NONE)
        return STATUS_OK;
    if (level == LEVEL_ROBUST)
        return take_robust_line(out, &record, height_m, status);
    if (level == LEVEL_CIRCLE)
        return take_arc(out, &record, height_m, status);
    int degree = level == LEVEL_MEAN ? 0 : level == LEVEL_LINE ? 1 : 2;
    struct polynomial form = fit(&record, height_m, NULL, degree);
    take_out(&record, height_m, &form);
    if (degree > 0)
        out->tilt = form.a[1] / record.half_m;
    return STATUS_OK;
}
