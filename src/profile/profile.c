/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "profile/profile.h"

#include "base/extremes.h"
#include "profile/filter.h"
#include "profile/gaps.h"
#include "profile/level.h"
#include "profile/record_window.h"
#include "profile/sanity.h"
#include "profile/spacing.h"
#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const struct profile_options profile_defaults = {.level = LEVEL_LINE, .max_missing = 0.1, .periodic_mean = true};

void profile_note(struct profile *profile, const char *format, ...)
{
    if (profile->note_count == PROFILE_NOTES)
        return;
    va_list args;
    va_start(args, format);
    vsnprintf(profile->notes[profile->note_count++], PROFILE_NOTE_LENGTH, format, args);
    va_end(args);
}

static double peak_to_valley(const struct profile *profile)
{
    double highest = -INFINITY, lowest = INFINITY;
    for (size_t i = 0; i < profile->points; i++) {
        highest = extremes_larger(highest, profile->height_m[i]);
        lowest = extremes_smaller(lowest, profile->height_m[i]);
    }
    return highest - lowest;
}

/** Keeps the measured points of an uneven scan and puts its heights on a uniform grid. */
static enum status_code even_out(struct profile *profile, const double *x_m, struct status *status)
{
    size_t points = profile->points;
    double *uniform_m = malloc(points * sizeof *uniform_m);
    profile->measured_x_m = malloc(points * sizeof *x_m);
    profile->measured_z_m = profile->height_m;
    profile->height_m = uniform_m;
    if (!uniform_m || !profile->measured_x_m)
        return status_memory(status);
    memcpy(profile->measured_x_m, x_m, points * sizeof *x_m);
    if (spacing_resample(uniform_m, x_m, profile->measured_z_m, points, profile->spacing_m, status) != STATUS_OK)
        return status->code;
    profile_note(profile, "x is uneven; heights were interpolated (Steffen) to a uniform %.6g um",
                 profile->spacing_m * 1e6);
    return STATUS_OK;
}

/** What a step makes of heights with nothing but form or waves in them is rounding: up to some units of the last place
 * of the heights as measured. */
static double rounding(const struct profile *profile)
{
    return 32 * DBL_EPSILON * (fabs(profile->height_m[0]) + peak_to_valley(profile));
}

static enum status_code take_level(struct profile *profile, const struct profile_options *options,
                                   struct status *status)
{
    struct levelling levelling, ignored;
    double before_m = peak_to_valley(profile), rounding_m = rounding(profile);
    if (before_m == 0)
        return status_fail(status, STATUS_SCAN, "the scan is flat: every height is %.9g m; check the column",
                           profile->height_m[0]);
    if (before_m < scan_least_m) /* a row of a map; a profile was refused as a scan */
        return status_fail(status, STATUS_SCAN, "the scan is flat: its heights differ by no more than %.3g m",
                           before_m);
    if (profile->measured_x_m && level_remove(&ignored, profile->measured_z_m, profile->measured_x_m, profile->points,
                                              0, options->level, status) != STATUS_OK)
        return status->code;
    if (level_remove(&levelling, profile->height_m, NULL, profile->points, profile->spacing_m, options->level,
                     status) != STATUS_OK)
        return status->code;
    if (peak_to_valley(profile) <= rounding_m)
        return status_fail(status, STATUS_SCAN,
                           "the scan is flat: no roughness is left after level: %s; check the column",
                           level_names[options->level]);
    profile->tilt = levelling.tilt;
    profile->radius_m = levelling.radius_m;
    if (options->level == LEVEL_CIRCLE && isinf(levelling.radius_m))
        profile_note(profile, "a line was taken out: the best arc is straight");
    else if (options->level == LEVEL_CIRCLE)
        profile_note(profile, "an arc of radius %.6g mm (%s) was taken out", fabs(levelling.radius_m) * 1e3,
                     levelling.radius_m < 0 ? "crown" : "hollow");
    if (options->level == LEVEL_ROBUST)
        profile_note(profile, "a robust line was taken out; %zu of %zu points (%.2g %%) are outliers of it",
                     levelling.outliers, profile->points, 100 * (double)levelling.outliers / (double)profile->points);
    return STATUS_OK;
}

/** Takes the Gaussian low-pass or, where `high`, what it leaves, of the heights. */
static enum status_code pass(struct profile *profile, double cutoff_m, bool high, struct status *status)
{
    double *smooth_m = malloc(profile->points * sizeof *smooth_m);
    if (!smooth_m)
        return status_memory(status);
    if (filter_gaussian(smooth_m, profile->height_m, profile->points, profile->spacing_m, cutoff_m, profile->periodic,
                        status) != STATUS_OK) {
        free(smooth_m);
        return status->code;
    }
    for (size_t i = 0; i < profile->points; i++)
        profile->height_m[i] = high ? profile->height_m[i] - smooth_m[i] : smooth_m[i];
    free(smooth_m);
    profile_note(profile, "gaussian %s = %.6g um (ISO 16610-21; %s)", high ? "high-pass lambda_c" : "low-pass lambda_s",
                 cutoff_m * 1e6,
                 profile->periodic ? "its end goes on at its beginning" : "weights renormalised at the ends");
    return STATUS_OK;
}

static enum status_code take_filters(struct profile *profile, const struct profile_options *options,
                                     struct status *status)
{
    double rounding_m = rounding(profile), length_m = (double)profile->points * profile->spacing_m;
    double lambda_s_m = options->lambda_s_m, lambda_c_m = options->lambda_c_m;
    if (!(lambda_s_m > 0 || lambda_c_m > 0))
        return STATUS_OK;
    if (lambda_s_m > 0 && lambda_s_m < 2 * profile->spacing_m)
        profile_note(profile, "lambda_s %.4g um is below twice the spacing: the filter takes little away",
                     lambda_s_m * 1e6);
    if (lambda_s_m > 0 && pass(profile, lambda_s_m, false, status) != STATUS_OK)
        return status->code;
    if (lambda_c_m > length_m)
        return status_fail(status, STATUS_SCAN,
                           "lambda_c is %.6g m, longer than the scan of %.6g m; give a shorter one", lambda_c_m,
                           length_m);
    if (lambda_c_m > 0 && pass(profile, lambda_c_m, true, status) != STATUS_OK)
        return status->code;
    free(profile->measured_x_m); /* these points did not go through the filters */
    free(profile->measured_z_m);
    profile->measured_x_m = profile->measured_z_m = NULL;
    return peak_to_valley(profile) > rounding_m
               ? STATUS_OK
               : status_fail(status, STATUS_SCAN, "no roughness is left between lambda_s and lambda_c");
}

/** From the raw heights in out->height_m, nx of them, to the profile. */
static enum status_code make_ready(struct profile *out, const struct scan *scan, const struct profile_options *options,
                                   struct status *status)
{
    struct spacing spacing = spacing_judge(scan);
    out->points = scan->nx;
    out->radius_m = INFINITY;
    out->grid = spacing.grid;
    out->spacing_m = spacing.step_m;

    size_t first = 0;
    if (gaps_close(out, &first, scan->x_m, options->max_missing, status) != STATUS_OK)
        return status->code;
    out->digit_m = sanity_digitising(out->height_m, out->points);
    if (out->grid == PROFILE_ROUNDED)
        profile_note(out, "x is rounded to a few digits; %s spacing of %.6g um was used",
                     spacing.nominal ? "the header's" : "its mean", out->spacing_m * 1e6);
    if (out->grid == PROFILE_RESAMPLED) {
        const double *x_m = scan->x_m + first;
        out->spacing_m = (x_m[out->points - 1] - x_m[0]) / (double)(out->points - 1);
        if (even_out(out, x_m, status) != STATUS_OK)
            return status->code;
    }
    out->periodic = record_window_is_periodic(out->height_m, out->points);
    struct profile_options how = *options;
    if (out->periodic && how.periodic_mean && how.level == LEVEL_LINE)
        how.level = LEVEL_MEAN;
    if (take_level(out, &how, status) != STATUS_OK)
        return status->code;
    sanity_check(out, out->digit_m, &how);
    if (take_filters(out, &how, status) != STATUS_OK)
        return status->code;
    out->end_jump_m = out->height_m[out->points - 1] - out->height_m[0];
    return STATUS_OK;
}

enum status_code profile_make(struct profile *out, const struct scan *scan, size_t row,
                              const struct profile_options *options, struct status *status)
{
    *out = (struct profile){.height_m = malloc(scan->nx * sizeof *out->height_m)};
    if (!out->height_m)
        return status_memory(status);
    memcpy(out->height_m, scan->z_m + row * scan->nx, scan->nx * sizeof *out->height_m);
    return make_ready(out, scan, options, status);
}

enum status_code profile_take(struct profile *out, struct scan *scan, const struct profile_options *options,
                              struct status *status)
{
    assert(scan->ny == 1);
    *out = (struct profile){.height_m = scan->z_m};
    scan->z_m = NULL;
    return make_ready(out, scan, options, status);
}

void profile_free(struct profile *profile)
{
    free(profile->height_m);
    free(profile->measured_x_m);
    free(profile->measured_z_m);
    *profile = (struct profile){0};
}
