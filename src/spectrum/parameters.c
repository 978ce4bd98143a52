/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/parameters.h"

#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const parameters_slope = "7-point";

static const double element_threshold = 0.1; /* of p and v, ISO 21920-2 default */
static const double core_share = 0.4;        /* of the material ratio curve, ISO 13565-2 */
static const double short_of_fit = 0.01;     /* of a sampling length */

static double mean_power(const struct parameters_part *part, int power)
{
    double sum = 0;
    for (size_t i = 0; i < part->points; i++) {
        double z = part->height_m[i], square = z * z;
        sum += power == 1 ? fabs(z) : power == 2 ? square : power == 3 ? square * z : square * square;
    }
    return sum / (double)part->points;
}

static double highest(const struct parameters_part *part)
{
    double most = part->height_m[0];
    for (size_t i = 1; i < part->points; i++)
        most = part->height_m[i] > most ? part->height_m[i] : most;
    return most;
}

static double deepest(const struct parameters_part *part)
{
    double least = part->height_m[0];
    for (size_t i = 1; i < part->points; i++)
        least = part->height_m[i] < least ? part->height_m[i] : least;
    return -least;
}

static double mean_size(const struct parameters_part *part)
{
    return mean_power(part, 1);
}

static double root_mean_square(const struct parameters_part *part)
{
    return sqrt(mean_power(part, 2));
}

static double total_height(const struct parameters_part *part)
{
    return highest(part) + deepest(part);
}

static double skewness(const struct parameters_part *part)
{
    double q = root_mean_square(part);
    return mean_power(part, 3) / (q * q * q);
}

static double kurtosis(const struct parameters_part *part)
{
    double square = mean_power(part, 2);
    return mean_power(part, 4) / (square * square);
}

static double slope_7_point(const struct parameters_part *part)
{
    const double *z = part->height_m;
    double sum = 0;
    if (part->points < 7)
        return NAN;
    for (size_t i = 3; i + 3 < part->points; i++) {
        double slope = (z[i + 3] - 9 * z[i + 2] + 45 * z[i + 1] - 45 * z[i - 1] + 9 * z[i - 2] - z[i - 3]) / 60;
        sum += slope * slope;
    }
    return sqrt(sum / (double)(part->points - 6)) / part->spacing_m;
}

/** Crossings of the reference line on the way from one side's threshold to the other's. */
struct crossings {
    double first, last; /* of those on the way now, in points; NaN: none yet */
    double begin, end;  /* of the ways done so far: the first and the last one */
    size_t count;
};

static void crossings_pass(struct crossings *crossings, double at)
{
    crossings->first = isnan(crossings->first) ? at : crossings->first;
    crossings->last = at;
}

/** The way is done: its crossing is halfway between what either direction would take. */
static void crossings_close(struct crossings *crossings)
{
    double at = (crossings->first + crossings->last) / 2;
    crossings->begin = crossings->count == 0 ? at : crossings->begin;
    crossings->end = at;
    crossings->count++;
}

static double element_width(const struct parameters_part *part)
{
    const double *z = part->height_m;
    double hill = element_threshold * highest(part), dale = -element_threshold * deepest(part);
    struct crossings up = {NAN, NAN, 0, 0, 0}, down = up;
    int side = 0; /* 1: last beyond the hills' threshold, -1: the dales' */
    if (!(hill > 0 && dale < 0))
        return NAN;
    for (size_t i = 0; i < part->points; i++) {
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
    return elements > 0 ? (up.end - up.begin + down.end - down.begin) / (double)elements * part->spacing_m : NAN;
}

/** The straight core of the material ratio curve, carried on to 0 and to 100 %. */
struct parameters_core {
    double upper_m, lower_m;
    double upper_ratio, lower_ratio; /* where the curve crosses those heights */
    double peak_area_m, valley_area_m;
};

/** Material ratio of the `i`th highest of `points` heights. */
static double ratio_at(double i, size_t points)
{
    return (i + 0.5) / (double)points;
}

/** Where the curve falls to `height_m`, given how many heights are above. */
static double ratio_of(const struct parameters_part *part, size_t above, double height_m)
{
    const double *z = part->sorted_m;
    if (above == 0 || above == part->points)
        return above == 0 ? 0 : 1;
    double share = (z[above - 1] - height_m) / (z[above - 1] - z[above]);
    return ratio_at((double)above - 1 + share, part->points);
}

static struct parameters_core core_of(const struct parameters_part *part)
{
    const double *z = part->sorted_m;
    size_t n = part->points, width = (size_t)lround(core_share * (double)n), first = 0;
    width = width < 1 ? 1 : width;
    for (size_t i = 1; i + width < n; i++)
        first = z[i] - z[i + width] < z[first] - z[first + width] ? i : first;
    double middle = ratio_at((double)first + (double)width / 2, n), mean = 0, along = 0, norm = 0;
    for (size_t i = first; i <= first + width; i++)
        mean += z[i] / (double)(width + 1);
    for (size_t i = first; i <= first + width; i++) {
        double r = ratio_at((double)i, n) - middle;
        along += r * (z[i] - mean);
        norm += r * r;
    }
    double slope = along / norm;
    struct parameters_core core = {.upper_m = mean - slope * middle, .lower_m = mean + slope * (1 - middle)};
    size_t above = 0, below = n;
    for (; above < n && z[above] > core.upper_m; above++)
        core.peak_area_m += (z[above] - core.upper_m) / (double)n;
    for (; below > 0 && z[below - 1] < core.lower_m; below--)
        core.valley_area_m += (core.lower_m - z[below - 1]) / (double)n;
    core.upper_ratio = ratio_of(part, above, core.upper_m);
    core.lower_ratio = ratio_of(part, below, core.lower_m);
    return core;
}

static double core_height(const struct parameters_part *part)
{
    return part->core->upper_m - part->core->lower_m;
}

static double reduced_peak(const struct parameters_part *part)
{
    const struct parameters_core *core = part->core;
    return core->upper_ratio > 0 ? 2 * core->peak_area_m / core->upper_ratio : 0;
}

static double reduced_valley(const struct parameters_part *part)
{
    const struct parameters_core *core = part->core;
    return core->lower_ratio < 1 ? 2 * core->valley_area_m / (1 - core->lower_ratio) : 0;
}

static double peak_ratio(const struct parameters_part *part)
{
    return part->core->upper_ratio;
}

static double valley_ratio(const struct parameters_part *part)
{
    return part->core->lower_ratio;
}

const struct parameters_row parameters_rows[PARAMETERS_COUNT] = {
    {"a", "m", "mean absolute height", "ISO 4287 4.2.1; ISO 21920-2 arithmetic mean height", false, mean_size},
    {"q", "m", "root mean square height", "ISO 4287 4.2.2; ISO 21920-2 root mean square height", false,
     root_mean_square},
    {"p", "m", "highest peak above the line", "ISO 4287 4.1.1; ISO 21920-2 mean peak height", false, highest},
    {"v", "m", "deepest valley below the line", "ISO 4287 4.1.2; ISO 21920-2 mean pit depth", false, deepest},
    {"z", "m", "highest peak plus deepest valley", "ISO 4287 4.1.3; ISO 21920-2 maximum height per section", false,
     total_height},
    {"t", "m", "highest peak plus deepest valley of the evaluation length", "ISO 4287 4.1.5; ISO 21920-2 total height",
     true, total_height},
    {"sk", "", "skewness of the heights", "ISO 4287 4.2.3; ISO 21920-2 skewness", false, skewness},
    {"ku", "", "kurtosis of the heights, 3 for a Gaussian", "ISO 4287 4.2.4; ISO 21920-2 kurtosis", false, kurtosis},
    {"dq", "", "root mean square slope, 7-point formula", "ISO 4287 4.4.1; ISO 21920-2 root mean square gradient",
     false, slope_7_point},
    {"sm", "m", "mean width of profile elements", "ISO 4287 4.3.1; ISO 21920-2 mean profile element spacing", true,
     element_width},
    {"k", "m", "core height", "ISO 13565-2 4.2; ISO 21920-2 core height", true, core_height},
    {"pk", "m", "reduced peak height", "ISO 13565-2 4.2; ISO 21920-2 reduced peak height", true, reduced_peak},
    {"vk", "m", "reduced valley depth", "ISO 13565-2 4.2; ISO 21920-2 reduced pit depth", true, reduced_valley},
    {"mrk1", "", "material ratio at the top of the core (Mr1)", "ISO 13565-2 4.2; ISO 21920-2 material ratio", true,
     peak_ratio},
    {"mrk2", "", "material ratio at the foot of the core (Mr2)", "ISO 13565-2 4.2; ISO 21920-2 material ratio", true,
     valley_ratio},
};

/** The heights, highest first. */
static void sort_heights(double *sorted_m, const double *height_m, size_t points)
{
    for (size_t k = 0; k < points; k++)
        sorted_m[k] = -height_m[k];
    gsl_sort(sorted_m, 1, points);
    for (size_t k = 0; k < points; k++)
        sorted_m[k] = -sorted_m[k];
}

static void fill_curve(struct parameters *out, const double *sorted_m, size_t points)
{
    for (size_t i = 0; i < PARAMETERS_CURVE; i++) {
        double at = (double)i / (PARAMETERS_CURVE - 1) * (double)points - 0.5;
        at = fmin(fmax(at, 0), (double)(points - 1));
        size_t before = (size_t)at < points - 1 ? (size_t)at : points - 2;
        out->material_ratio_m[i] = sorted_m[before] + (at - (double)before) * (sorted_m[before + 1] - sorted_m[before]);
    }
}

enum status_code parameters_compute(struct parameters *out, char letter, const double *height_m, size_t points,
                                    double spacing_m, size_t sampling_lengths, struct status *status)
{
    *out = (struct parameters){
        .letter = letter, .sampling_lengths = sampling_lengths, .evaluation_length_m = (double)points * spacing_m};
    double *sorted_m = malloc(points * sizeof *sorted_m);
    if (!sorted_m)
        return status_memory(status);
    sort_heights(sorted_m, height_m, points);
    fill_curve(out, sorted_m, points);
    struct parameters_part whole = {height_m, points, spacing_m, sorted_m, NULL};
    const struct parameters_core core = core_of(&whole); /* once: five parameters are of it */
    whole.core = &core;
    for (size_t p = 0; p < PARAMETERS_COUNT; p++) {
        const struct parameters_row *row = &parameters_rows[p];
        if (row->whole) {
            out->value[p] = row->evaluate(&whole);
            continue;
        }
        for (size_t s = 0; s < sampling_lengths; s++) {
            size_t first = s * points / sampling_lengths, end = (s + 1) * points / sampling_lengths;
            struct parameters_part part = {height_m + first, end - first, spacing_m, NULL, NULL};
            out->value[p] += row->evaluate(&part) / (double)sampling_lengths;
        }
    }
    free(sorted_m);
    return STATUS_OK;
}

enum status_code parameters_of_roughness(struct parameters *out, const double *height_m, size_t points,
                                         double spacing_m, double cutoff_m, struct status *status)
{
    double length_m = (double)points * spacing_m, fit = floor(length_m / cutoff_m + short_of_fit);
    if (fit < 1)
        return status_fail(status, STATUS_SCAN, "the scan of %.6g m is shorter than one sampling length, %.6g m",
                           length_m, cutoff_m);
    if (!(cutoff_m >= 3 * spacing_m))
        return status_fail(status, STATUS_SCAN, "a sampling length of %.6g m has under 3 points, %.6g m apart",
                           cutoff_m, spacing_m);
    double wanted = round(fit * cutoff_m / spacing_m);
    size_t used = wanted < (double)points ? (size_t)wanted : points;
    return parameters_compute(out, 'R', height_m + (points - used) / 2, used, spacing_m, (size_t)fit, status);
}

double parameters_value(const struct parameters *parameters, const char *name)
{
    for (size_t p = 0; p < PARAMETERS_COUNT; p++)
        if (strcmp(parameters_rows[p].name, name) == 0)
            return parameters->value[p];
    return NAN;
}
