/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "profile/level.h"

#include <float.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>

const char *const level_names[LEVEL_COUNT] = {"none", "mean", "line", "parabola", "circle", "robust"};

static const double tukey_tuning = 4.685;        /* 95 % efficiency for Gaussian residuals */
static const double mad_to_deviation = 1.482602; /* 1/Phi^-1(3/4) */
enum { ROBUST_STEPS = 50, ARC_STEPS = 50, ARC_PARAMETERS = 3 };

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
    p.a[0] = mean = mean / count + z[0]; /* about the first height, so that a large offset costs no digits */
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

static enum status_code take_robust_line(struct levelling *out, const struct record *record, double *z,
                                         struct status *status)
{
    size_t n = record->points;
    OWNED(memory_free) double *weight = malloc(2 * n * sizeof *weight);
    double last = INFINITY, largest = 0;
    if (!weight)
        return status_memory(status);
    double *size = weight + n;
    for (size_t i = 0; i < n; i++)
        largest = fmax(largest, fabs(z[i]));
    struct polynomial line = fit(record, z, NULL, 1);
    for (int step = 0; step < ROBUST_STEPS; step++) {
        for (size_t i = 0; i < n; i++)
            weight[i] = size[i] = fabs(z[i] - line.a[0] - line.a[1] * (place(record, i) - line.centre));
        /* never below what rounding leaves of points on one line */
        double scale = fmax(mad_to_deviation * gsl_stats_median(size, 1, n), 4 * DBL_EPSILON * largest);
        out->outliers = 0;
        for (size_t i = 0; i < n; i++) {
            double r = weight[i] / (tukey_tuning * scale);
            weight[i] = r < 1 ? (1 - r * r) * (1 - r * r) : 0;
            out->outliers += r < 1 ? 0 : 1;
        }
        line = fit(record, z, weight, 1);
        if (fabs(line.a[1] - last) <= 1e-12 * scale)
            break;
        last = line.a[1];
    }
    take_out(record, z, &line);
    out->tilt = line.a[1] / record->half_m;
    return STATUS_OK;
}

/** Fit of an arc to a record, and its start: c, s, k (level.h) in u and z/half_m. */
struct arc_fit {
    const struct record *record;
    const double *z;
    double start[ARC_PARAMETERS];
};

/** c, s, k at x, which is 1 at the start: GSL's steps are relative to x and so suit a flat arc too. */
static void arc_of(double arc[ARC_PARAMETERS], const struct arc_fit *fit, const gsl_vector *x)
{
    for (size_t i = 0; i < ARC_PARAMETERS; i++)
        arc[i] = fit->start[i] + (gsl_vector_get(x, i) - 1);
}

/** Does it span less than half a circle? */
static bool arc_is_whole(const double arc[ARC_PARAMETERS])
{
    return fabs(arc[1]) + fabs(arc[2]) < 0.9999;
}

static double arc_at(const double arc[ARC_PARAMETERS], double u)
{
    double sine = arc[1], end = sine + arc[2] * u;
    return arc[0] + u * (sine + end) / (sqrt(1 - sine * sine) + sqrt(1 - end * end));
}

static int arc_misfits(const gsl_vector *x, void *context, gsl_vector *misfits)
{
    const struct arc_fit *fit = context;
    double arc[ARC_PARAMETERS];
    arc_of(arc, fit, x);
    for (size_t i = 0; i < fit->record->points; i++)
        gsl_vector_set(misfits, i,
                       arc_is_whole(arc) ? arc_at(arc, place(fit->record, i)) - fit->z[i] / fit->record->half_m : 1e6);
    return GSL_SUCCESS;
}

static enum status_code take_arc(struct levelling *out, const struct record *record, double *z, struct status *status)
{
    if (record->points < ARC_PARAMETERS)
        return status_fail(status, STATUS_SCAN, "no arc fits %zu points; take a longer scan", record->points);
    double first = z[0]; /* a large offset would cost digits */
    for (size_t i = 0; i < record->points; i++)
        z[i] -= first;
    struct polynomial p = fit(record, z, NULL, 2);
    double slope = (p.a[1] - p.a[2] * (2 * p.centre + p.bend)) / record->half_m, bend = 2 * p.a[2] / record->half_m;
    struct arc_fit how = {record, z, {p.a[0] / record->half_m, slope / sqrt(1 + slope * slope), bend}};
    if (!arc_is_whole(how.start))
        how.start[1] = 0, how.start[2] = copysign(0.9, bend);
    gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
    gsl_multifit_nlinear_fdf problem = {
        .f = arc_misfits, .n = record->points, .p = ARC_PARAMETERS, .params = &how}; /* derivatives by differences */
    gsl_multifit_nlinear_workspace *work =
        gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, record->points, ARC_PARAMETERS);
    double ones[ARC_PARAMETERS] = {1, 1, 1}, arc[ARC_PARAMETERS];
    gsl_vector_view start = gsl_vector_view_array(ones, ARC_PARAMETERS);
    int info;
    if (!work)
        return status_memory(status);
    gsl_multifit_nlinear_init(&start.vector, &problem, work);
    (void)gsl_multifit_nlinear_driver(ARC_STEPS, 1e-10, 0, 0, NULL, NULL, &info, work);
    arc_of(arc, &how, gsl_multifit_nlinear_position(work));
    gsl_multifit_nlinear_free(work);
    if (!arc_is_whole(arc))
        return status_fail(status, STATUS_SCAN, "no arc fits the record; use level: parabola");
    for (size_t i = 0; i < record->points; i++)
        z[i] -= arc_at(arc, place(record, i)) * record->half_m;
    out->tilt = arc[1] / sqrt(1 - arc[1] * arc[1]);
    out->radius_m = record->half_m / arc[2];
    return STATUS_OK;
}

enum status_code level_remove(struct levelling *out, double *height_m, const double *x_m, size_t points,
                              double spacing_m, enum level level, struct status *status)
{
    double first_m = x_m ? x_m[0] : -(double)(points - 1) / 2 * spacing_m, last_m = x_m ? x_m[points - 1] : -first_m;
    const struct record record = {x_m, points, (last_m + first_m) / 2, (last_m - first_m) / 2};
    *out = (struct levelling){.radius_m = INFINITY};
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
