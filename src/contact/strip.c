/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/strip.h"

#include "base/fft.h"
#include "contact/corrected_persson.h"
#include "direct/direct_constriction.h"
#include "direct/direct_quantities.h"
#include "direct/direct_surface.h"
#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/** p over the strip's rms slope, and the tolerance of its solution: tighter where little touches, and where the gap is
 * small. What it costs in the middle moves areas by 1 %, lengths and gaps by 2 %. */
static const struct {
    double load, tolerance;
} ladder[STRIP_LOADS] = {
    {1e-4, 1e-4},  {3e-4, 2e-4}, {1e-3, 5e-4}, {3e-3, 1e-3}, {0.006, 2e-3}, {0.012, 3e-3},
    {0.025, 5e-3}, {0.05, 5e-3}, {0.1, 5e-3},  {0.17, 5e-3}, {0.26, 5e-3},  {0.38, 5e-3},
    {0.55, 5e-3},  {0.8, 2e-3},  {1.1, 1e-3},  {1.6, 1e-3},  {2.3, 1e-3},
};

static const double least_share = 0.3; /* of the points in contact that their outline leaves */

static double logit(double area_ratio)
{
    return log(area_ratio) - log1p(-area_ratio);
}

size_t strip_row_length(const struct strip_rows *rows)
{
    return rows->periodic ? rows->points : 2 * rows->points;
}

void strip_lay_row(double *out, const struct strip_rows *rows, size_t row)
{
    const double *height_m = rows->height_m + row * rows->points;
    size_t length = strip_row_length(rows);
    memcpy(out, height_m, rows->points * sizeof *out);
    for (size_t i = rows->points; i < length; i++)
        out[i] = height_m[length - 1 - i];
}

/** The rows' means, and the amplitudes that stand for all of them. */
struct phases {
    struct fft_room room; /* of one row */
    double *amplitude;    /* sqrt of the mean power of harmonic k, over the points */
    double mean_m, deviation_m;
};

static enum status_code phases_of(struct phases *out, const double *strip_m, size_t length, size_t count,
                                  struct status *status)
{
    double n = (double)length, square = 0;
    *out = (struct phases){.amplitude = calloc(length / 2 + 1, sizeof(double))};
    if (!out->amplitude || !fft_room_make(&out->room, length))
        return status_memory(status);
    for (size_t r = 0; r < count; r++) {
        memcpy(out->room.record, strip_m + r * length, length * sizeof(double));
        if (!fft_forward(out->room.transform, out->room.record, length))
            return status_memory(status);
        for (size_t k = 0; k <= length / 2; k++)
            out->amplitude[k] +=
                (pow(out->room.transform[k][0] / n, 2) + pow(out->room.transform[k][1] / n, 2)) / (double)count;
        out->mean_m += out->room.transform[0][0] / n / (double)count;
    }
    square = out->amplitude[0] - out->mean_m * out->mean_m; /* of the means */
    out->deviation_m = count > 1 ? sqrt(fmax(square, 0) * (double)count / (double)(count - 1)) : 0;
    for (size_t k = 0; k <= length / 2; k++)
        out->amplitude[k] = sqrt(out->amplitude[k]);
    return STATUS_OK;
}

static void phases_free(struct phases *phases)
{
    free(phases->amplitude);
    fft_room_free(&phases->room);
}

/** A Gaussian row. */
static void draw_row(double *out, struct phases *phases, size_t length, size_t row, uint64_t seed,
                     struct status *status)
{
    uint64_t first = (uint64_t)row << 32;
    double normal = gsl_cdf_ugaussian_Pinv(direct_random(seed, first) + ldexp(1, -54));
    phases->room.transform[0][0] = phases->mean_m + phases->deviation_m * normal;
    phases->room.transform[0][1] = 0;
    for (size_t k = 1; k <= length / 2; k++) {
        double angle = 2 * M_PI * direct_random(seed, first + k);
        bool nyquist = 2 * k == length; /* real, and its mean square that of its amplitude */
        phases->room.transform[k][0] = phases->amplitude[k] * (nyquist ? copysign(1, cos(angle)) : cos(angle));
        phases->room.transform[k][1] = nyquist ? 0 : phases->amplitude[k] * sin(angle);
    }
    if (!fft_backward(phases->room.record, phases->room.transform, length))
        (void)status_memory(status);
    memcpy(out, phases->room.record, length * sizeof *out);
}

/** Mean-square slope of a periodic strip. */
static double mean_square_slope(const double *strip_m, size_t points, double spacing_m)
{
    double sum = 0;
    for (size_t i = 0; i < points; i++) {
        double slope = (strip_m[i + 1 < points ? i + 1 : 0] - strip_m[i > 0 ? i - 1 : points - 1]) / (2 * spacing_m);
        sum += slope * slope;
    }
    return sum / (double)points;
}

/** Mean gap of the points that do not touch: what is left at the others is the solver's tolerance. */
static double open_gap(const struct direct_contact *contact)
{
    double sum = 0;
    for (size_t k = 0; k < contact->kernel.nx; k++)
        if (!(contact->pressure[k] > 0))
            sum += fmax(contact->gap_m[k], 0);
    return sum / (double)contact->kernel.points;
}

/** Puts a solution into the curve, from its end on; those that complete contact or come no further down say nothing. */
static enum status_code add_solution(struct strip_curve *curve, struct direct_contact *contact, size_t touching,
                                     const struct direct_contact_load *load, double area,
                                     struct direct_contact_effort *effort, struct status *status)
{
    size_t at = STRIP_LOADS - 1 - curve->count;
    double length_m, gap_m = open_gap(contact);
    if (touching == contact->kernel.points)
        return STATUS_OK;
    if (direct_constriction_of_contact(&length_m, contact, sqrt(load->tolerance), load->stop, effort, status) !=
        STATUS_OK)
        return status->code;
    if (!(length_m > 0 && gap_m > 0) || (curve->count > 0 && !(logit(area) < curve->logit[at + 1])))
        return STATUS_OK;
    curve->logit[at] = logit(area);
    curve->value[at][0] = log(load->mean_pressure);
    curve->value[at][1] = log(length_m);
    curve->value[at][2] = log(gap_m);
    curve->count++;
    return STATUS_OK;
}

/** Down the ladder until too few points touch. */
static enum status_code descend(struct strip_curve *curve, struct direct_contact *contact, double slope,
                                const atomic_bool *stop, struct direct_contact_effort *effort, struct status *status)
{
    size_t points = contact->kernel.points;
    *curve = (struct strip_curve){0};
    for (size_t i = STRIP_LOADS; i-- > 0;) {
        struct direct_contact_load load = {ladder[i].load * slope, INFINITY, ladder[i].tolerance, true, stop};
        if (direct_contact_solve(contact, &load, effort, status) != STATUS_OK)
            return status->code;
        struct direct_quantities found = direct_quantities_of(contact, &load);
        if (found.contact_points < STRIP_LEAST_POINTS)
            break;
        double area = fmax(direct_area_corrected(&found, points, direct_kappa),
                           least_share * (double)found.contact_points / (double)points);
        if (add_solution(curve, contact, found.contact_points, &load, area, effort, status) != STATUS_OK)
            return status->code;
    }
    if (curve->count == 0)
        return status_fail(status, STATUS_MODEL,
                           "no load of the strip has %d points in contact; take longer or denser scans",
                           STRIP_LEAST_POINTS);
    size_t first = STRIP_LOADS - curve->count;
    memmove(curve->logit, curve->logit + first, curve->count * sizeof *curve->logit);
    memmove(curve->value, curve->value + first, curve->count * sizeof *curve->value);
    return STATUS_OK;
}

static enum status_code solve_strip(struct strip_curve *curve, const double *strip_m, size_t points, double spacing_m,
                                    uint64_t *transforms, const atomic_bool *stop, struct status *status)
{
    struct direct_contact contact;
    struct direct_contact_effort effort = {0};
    if (direct_contact_make(&contact, strip_m, points, 1, spacing_m, status) != STATUS_OK)
        return status->code;
    (void)descend(curve, &contact, sqrt(mean_square_slope(strip_m, points, spacing_m)), stop, &effort, status);
    direct_contact_free(&contact);
    *transforms += effort.convolutions * points;
    return status->code;
}

enum status_code strip_solve(struct strip *out, const struct strip_rows *rows, const size_t *which, size_t count,
                             size_t surrogates, const atomic_bool *stop, struct status *status)
{
    size_t length = strip_row_length(rows), points = count * length;
    struct phases phases = {0};
    double *strip_m = malloc((points + 1) * sizeof *strip_m);
    *out = (struct strip){.surrogates = surrogates};
    if (!strip_m)
        return status_memory(status);
    for (size_t r = 0; r < count; r++)
        strip_lay_row(strip_m + r * length, rows, which[r]);
    if (phases_of(&phases, strip_m, length, count, status) == STATUS_OK)
        (void)solve_strip(&out->own, strip_m, points, rows->spacing_m, &out->transforms, stop, status);
    for (size_t s = 0; s < surrogates && status->code == STATUS_OK; s++) {
        for (size_t r = 0; r < count; r++)
            draw_row(strip_m + r * length, &phases, length, which[r], s + 1, status);
        if (status->code == STATUS_OK)
            (void)solve_strip(&out->surrogate[s], strip_m, points, rows->spacing_m, &out->transforms, stop, status);
    }
    phases_free(&phases);
    free(strip_m);
    return status->code;
}

uint64_t strip_cost(const struct strip_rows *rows, size_t count, size_t surrogates)
{
    double points = (double)(count * strip_row_length(rows)),
           pairs = 2.8 * sqrt(sqrt(points)); /* a load, as measured */
    return (uint64_t)(pairs * points * (double)(STRIP_LOADS * (1 + surrogates)));
}

/** A line through two neighbours, carried on above the last; below the first p goes as A, l as 1/A, the gap stays. */
static void add_values(double sum[3], const struct strip_curve *curve, double at, double weight)
{
    static const double slope_below[3] = {1, -1, 0};
    size_t k = 0;
    while (k + 2 < curve->count && at > curve->logit[k + 1])
        k++;
    for (size_t q = 0; q < 3; q++) {
        double slope = slope_below[q];
        if (at > curve->logit[0] && curve->count > 1)
            slope = (curve->value[k + 1][q] - curve->value[k][q]) / (curve->logit[k + 1] - curve->logit[k]);
        sum[q] += weight * (curve->value[k][q] + slope * (at - curve->logit[k]));
    }
}

struct strip_ratio strip_ratio_at(const struct strip *strip, double area_ratio)
{
    double sum[3] = {0}, at = logit(area_ratio);
    add_values(sum, &strip->own, at, 1);
    for (size_t s = 0; s < strip->surrogates; s++)
        add_values(sum, &strip->surrogate[s], at, -1 / (double)strip->surrogates);
    return (struct strip_ratio){sum[0], sum[1], sum[2]};
}

static const double grid_step = 0.05; /* in logit A */

enum status_code strip_areas(double *area_ratio, const double *loads, size_t count, const struct strip *strip,
                             double m2, struct status *status)
{
    double low = strip->own.logit[0], high = logit(corrected_persson_largest_area);
    for (size_t s = 0; s < strip->surrogates; s++)
        low = fmin(low, strip->surrogate[s].logit[0]);
    low = fmin(low, high - grid_step);
    size_t steps = (size_t)ceil((high - low) / grid_step), at = 0;
    double *load = malloc((steps + 1) * sizeof *load); /* ln p, never falling */
    if (!load)
        return status_memory(status);
    for (size_t k = 0; k <= steps; k++) {
        double area = 1 / (1 + exp(-(low + (high - low) * (double)k / (double)steps)));
        load[k] = log(corrected_persson_load(area, m2)) + strip_ratio_at(strip, area).load;
        load[k] = k > 0 ? fmax(load[k], load[k - 1]) : load[k];
    }
    double lowest = exp(strip_ratio_at(strip, 1 / (1 + exp(-low))).load);
    for (size_t i = 0; i < count; i++) {
        double wanted = log(loads[i]);
        while (at < steps && load[at + 1] < wanted)
            at++;
        double share = (wanted - load[at]) / (load[at + 1 - (at == steps)] - load[at]);
        if (wanted <= load[0])
            area_ratio[i] = corrected_persson_area(loads[i] / lowest, m2);
        else if (wanted > load[steps])
            area_ratio[i] = NAN;
        else
            area_ratio[i] = 1 / (1 + exp(-(low + (high - low) * ((double)at + share) / (double)steps)));
    }
    free(load);
    return STATUS_OK;
}
