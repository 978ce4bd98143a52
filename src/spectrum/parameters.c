/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/parameters.h"

#include <math.h>

static const double element_threshold = 0.1; /* of p and v, ISO 21920-2 default */
static const double short_of_fit = 0.01;     /* of a sampling length */

enum { A, Q, P, V, Z, T, SK, KU, DQ, SM };
const char *const parameters_names[PARAMETERS_COUNT] = {
    [A] = "a", [Q] = "q",   [P] = "p",   [V] = "v",   [Z] = "z",
    [T] = "t", [SK] = "sk", [KU] = "ku", [DQ] = "dq", [SM] = "sm",
};

/** sqrt of the mean square 7-point slope, in heights a point. */
static double slope_7_point(const double *z, size_t points)
{
    double sum = 0;
    if (points < 7)
        return NAN;
    for (size_t i = 3; i + 3 < points; i++) {
        double slope = (z[i + 3] - 9 * z[i + 2] + 45 * z[i + 1] - 45 * z[i - 1] + 9 * z[i - 2] - z[i - 3]) / 60;
        sum += slope * slope;
    }
    return sqrt(sum / (double)(points - 6));
}

/** All but t and sm of one sampling length, dq in heights a point. */
static void measure(double value[PARAMETERS_COUNT], const double *z, size_t points)
{
    double size = 0, square = 0, cube = 0, fourth = 0, highest = z[0], lowest = z[0], n = (double)points;
    for (size_t i = 0; i < points; i++) {
        size += fabs(z[i]);
        square += z[i] * z[i];
        highest = z[i] > highest ? z[i] : highest;
        lowest = z[i] < lowest ? z[i] : lowest;
    }
    double q = sqrt(square / n);
    for (size_t i = 0; i < points; i++) {
        double of_q = z[i] / q, of_square = of_q * of_q;
        cube += of_square * of_q;
        fourth += of_square * of_square;
    }
    value[A] = size / n;
    value[Q] = q;
    value[P] = highest;
    value[V] = -lowest;
    value[Z] = highest - lowest;
    value[SK] = cube / n;
    value[KU] = fourth / n;
    value[DQ] = slope_7_point(z, points);
}

/** Crossings of the reference line between one threshold and the other, in one direction. */
struct crossings {
    double first, last; /* since the last threshold, in points; NaN: none yet */
    double begin, end;  /* the first and the last that counted */
    size_t count;
};

static void crossings_pass(struct crossings *crossings, double at)
{
    crossings->first = isnan(crossings->first) ? at : crossings->first;
    crossings->last = at;
}

/** The other threshold is reached: the crossing in the middle counts. */
static void crossings_close(struct crossings *crossings)
{
    double at = (crossings->first + crossings->last) / 2;
    crossings->begin = crossings->count == 0 ? at : crossings->begin;
    crossings->end = at;
    crossings->count++;
}

/** Mean width of the elements in points; p and v are of the same heights. */
static double element_width(const double *z, size_t points, double p, double v)
{
    double hill = element_threshold * p, dale = -element_threshold * v;
    struct crossings up = {NAN, NAN, 0, 0, 0}, down = up;
    int side = 0; /* the threshold passed last: 1 of hills, -1 of dales */
    if (!(hill > 0 && dale < 0))
        return NAN;
    for (size_t i = 0; i < points; i++) {
        if (i > 0 && (z[i - 1] < 0) != (z[i] < 0))
            crossings_pass(z[i] < 0 ? &down : &up, (double)i - z[i] / (z[i] - z[i - 1]));
        int now = z[i] > hill ? 1 : z[i] < dale ? -1 : 0;
        if (now == 0)
            continue;
        if (side == -now)
            crossings_close(now > 0 ? &up : &down);
        side = now;
        up.first = down.first = NAN;
    }
    size_t elements = (up.count > 0 ? up.count - 1 : 0) + (down.count > 0 ? down.count - 1 : 0);
    return elements > 0 ? (up.end - up.begin + down.end - down.begin) / (double)elements : NAN;
}

struct parameters parameters_compute(char letter, const double *height_m, size_t points, double spacing_m,
                                     size_t sampling_lengths)
{
    struct parameters out = {
        .letter = letter, .sampling_lengths = sampling_lengths, .evaluation_length_m = (double)points * spacing_m};
    double whole[PARAMETERS_COUNT] = {0}, part[PARAMETERS_COUNT] = {0};
    for (size_t s = 0; s < sampling_lengths; s++) {
        size_t first = s * points / sampling_lengths, end = (s + 1) * points / sampling_lengths;
        measure(part, height_m + first, end - first);
        for (size_t p = 0; p < PARAMETERS_COUNT; p++)
            out.value[p] += part[p] / (double)sampling_lengths;
    }
    measure(whole, height_m, points);
    out.value[DQ] /= spacing_m;
    out.value[T] = whole[Z];
    out.value[SM] = element_width(height_m, points, whole[P], whole[V]) * spacing_m;
    return out;
}

enum status_code parameters_of_roughness(struct parameters *out, const double *height_m, size_t points,
                                         double spacing_m, double cutoff_m, const double margin_m[2],
                                         struct status *status)
{
    size_t run_in[2] = {0, 0};
    for (int end = 0; end < 2 && margin_m; end++)
        run_in[end] = (size_t)fmax(round((cutoff_m / 2 - margin_m[end]) / spacing_m), 0);
    const double all_m = (double)points * spacing_m, length_m = all_m - (double)(run_in[0] + run_in[1]) * spacing_m,
                 fit = floor(length_m / cutoff_m + short_of_fit);
    if (fit < 1)
        return status_fail(status, STATUS_SCAN,
                           "the scan of %.6g m is shorter than one sampling length of %.6g m with %s", all_m, cutoff_m,
                           margin_m ? "half of one at either end for the filter" : "nothing left out");
    if (!(cutoff_m >= 3 * spacing_m))
        return status_fail(status, STATUS_SCAN, "a sampling length of %.6g m has under 3 points, %.6g m apart",
                           cutoff_m, spacing_m);
    const size_t between = points - run_in[0] - run_in[1];
    const double wanted = round(fit * cutoff_m / spacing_m);
    const size_t used = wanted < (double)between ? (size_t)wanted : between, first = run_in[0] + (between - used) / 2;
    *out = parameters_compute('R', height_m + first, used, spacing_m, (size_t)fit);
    out->first_m = (double)first * spacing_m;
    return STATUS_OK;
}
