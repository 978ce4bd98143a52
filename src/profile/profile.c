/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "profile/profile.h"

#include "profile/level.h"
#include <float.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_spline.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Adds a line to the notes; beyond PROFILE_NOTES it is dropped. */
PRINTF_LIKE(2, 3) static void profile_note(struct profile *profile, const char *format, ...)
{
    if (profile->note_count == PROFILE_NOTES)
        return;
    va_list args;
    va_start(args, format);
    vsnprintf(profile->notes[profile->note_count++], PROFILE_NOTE_LENGTH, format, args);
    va_end(args);
}

/* Limits beyond which numbers of contact are doubtful */
static const double sanity_steepest = 10;     /* slope */
static const double sanity_digit_share = 0.2; /* of m4 */
static const double sanity_noise_ratio = 8;   /* of m4 at h to m4 at 2h: amplitudes as lambda^0.5 */
enum { SANITY_POINTS = 64, SANITY_STEPS = 30 };

double profile_digitiser_step(const double *height_m, size_t points)
{
    double largest = fabs(height_m[0]), least = INFINITY, sum = 0;
    double mean = (height_m[points - 1] - height_m[0]) / (double)(points - 1), tilt = INFINITY;
    for (size_t i = 1; i < points; i++) { /* of the differences the one nearest to their mean, rounded as heights are */
        double d = height_m[i] - height_m[i - 1];
        tilt = fabs(d - mean) < fabs(tilt - mean) ? d : tilt;
        largest = fabs(height_m[i]) > largest ? fabs(height_m[i]) : largest;
    }
    double nothing = 1e-13 * largest; /* equal heights may differ by rounding of units */
    for (size_t i = 1; i < points; i++) {
        double d = fabs(height_m[i] - height_m[i - 1] - tilt);
        least = d > nothing && d < least ? d : least;
    }
    size_t ones = 0, small = 0, whole = 0;
    for (size_t i = 1; i < points; i++) {
        double d = fabs(height_m[i] - height_m[i - 1] - tilt);
        if (d > nothing && d < 1.5 * least)
            sum += d, ones++;
    }
    if (ones == 0)
        return 0; /* all differences are equal */
    double step = sum / (double)ones;
    for (size_t i = 1; i < points; i++) {
        double d = fabs(height_m[i] - height_m[i - 1] - tilt) / step;
        if (d * step <= nothing || d > 3.5)
            continue;
        small++;
        whole += fabs(d - round(d)) <= 0.15 ? 1 : 0;
    }
    bool seen = small >= SANITY_STEPS && small * 100 >= points && (double)whole >= 0.95 * (double)small;
    return seen ? step : 0;
}

/** Mean square of the second difference over `lag` points; 0 where the profile is too short. */
static double curvature(const struct profile *profile, size_t lag)
{
    const double *z = profile->height_m;
    double sum = 0, h = (double)lag * profile->spacing_m;
    size_t count = 0;
    for (size_t i = lag; i + lag < profile->points; i++, count++) {
        double c = (z[i + lag] - 2 * z[i] + z[i - lag]) / h / h;
        sum += c * c;
    }
    return count > 0 ? sum / (double)count : 0;
}

static void check_curvature(struct profile *profile, double digit_m, const struct profile_options *options)
{
    double m4 = curvature(profile, 1), coarse = curvature(profile, 2), h = profile->spacing_m;
    double tip_m = options->tip_radius_m, digit_m4 = digit_m / h / h * (digit_m / h / h) / 2;
    if (options->lambda_s_m > 2 * h) /* the filter takes out what follows */
        return;
    const double share = fmin(1, digit_m4 / m4); /* rounding is far smaller at twice the spacing, a sine is not */
    if (share > sanity_digit_share && coarse < (1 - share / 2) * m4)
        profile_note(
            profile,
            "heights come in steps of %.3g nm, whose rounding alone makes %.0f %% of m4: the statistical models "
            "follow the digitiser; give lambda_s",
            digit_m * 1e9, 100 * share);
    else if (coarse > 0 && m4 > sanity_noise_ratio * coarse)
        profile_note(
            profile,
            "m4 is noise of the shortest wavelengths: %.1f times smaller with every other point (white noise: 16); "
            "give lambda_s",
            m4 / coarse);
    if (m4 * tip_m * tip_m > 1)
        profile_note(profile,
                     "the RMS radius of curvature, %.3g um, is below the tip radius, %.3g um: the stylus cannot have "
                     "followed it; give lambda_s",
                     1e6 / sqrt(m4), tip_m * 1e6);
}

/** Notes what is doubtful about a levelled profile before filtering:
 *  Rq above the length, or a slope above 10: wrong units;
 *  rounding of the digitiser's step q, of variance q²/12, makes m4 = 6 (q²/12)/h^4, above 20 % of m4 (no lambda_s);
 *  noise: m4 is 8 times smaller or more with every other point (white noise: 16, a resolved profile: 1);
 *  a tip radius above the RMS radius of curvature; under 64 points. */
static void check_sanity(struct profile *profile, double digit_m, const struct profile_options *options)
{
    const double *z = profile->height_m, length_m = (double)profile->points * profile->spacing_m;
    double sum_m = 0, square_m2 = 0, steepest = 0;
    for (size_t i = 0; i < profile->points; i++)
        sum_m += z[i];
    for (size_t i = 0; i < profile->points; i++) {
        square_m2 += pow(z[i] - sum_m / (double)profile->points, 2);
        steepest = i > 0 ? fmax(steepest, fabs(z[i] - z[i - 1]) / profile->spacing_m) : 0;
    }
    double rq_m = sqrt(square_m2 / (double)profile->points);
    if (rq_m > length_m)
        profile_note(profile, "Rq %.3g m is above the length of the scan, %.3g m: check x_unit and z_unit", rq_m,
                     length_m);
    else if (steepest > sanity_steepest)
        profile_note(profile, "the steepest slope is %.3g (%.0f degrees): check the units, or spikes in the scan",
                     steepest, atan(steepest) * 180 / M_PI);
    check_curvature(profile, digit_m, options);
    if (profile->points < SANITY_POINTS)
        profile_note(profile, "only %zu points%s", profile->points,
                     profile->points < PROFILE_SPECTRUM_POINTS ? "; a report needs 11" : ": the spectrum is coarse");
}

const struct profile_options profile_defaults = {.level = LEVEL_LINE, .max_missing = 0.1, .periodic_mean = true};

static const double spacing_uniform = 1e-3; /* share of the mean step by which uniform steps may differ */
static const double spacing_same = 1e-4;    /* the same for rounded steps that are equal */
static const double spacing_nominal = 5e-3; /* the same for the header's spacing, which has few digits too */
enum { SPACING_KINDS = 5, LEAST_POINTS = 3 };

static double peak_to_valley(const struct profile *profile)
{
    double lowest, highest;
    gsl_stats_minmax(&lowest, &highest, profile->height_m, 1, profile->points);
    return highest - lowest;
}

/** Bridges the gap between points `start` and `end`. */
static void bridge(double *z, const double *x, size_t start, size_t end)
{
    for (size_t i = start + 1; i < end; i++) {
        double share = x ? (x[i] - x[start]) / (x[end] - x[start]) : (double)(i - start) / (double)(end - start);
        z[i] = z[start] + share * (z[end] - z[start]);
    }
}

/** Cuts missing points off the ends, and bridges the others by straight lines over x_m (NULL: uniform). *first is the
 * point where the profile now starts. */
static enum status_code close_gaps(struct profile *profile, size_t *first, const double *x_m, double most,
                                   struct status *status)
{
    double *z = profile->height_m;
    size_t missing = 0, start = 0, end = profile->points, gaps = 0, widest = 0;
    for (size_t i = 0; i < end; i++)
        missing += isnan(z[i]) ? 1 : 0;
    if (missing == 0)
        return STATUS_OK;
    double share = (double)missing / (double)end;
    if (share > most)
        return status_fail(status, STATUS_SCAN, "%zu of %zu heights are missing, %.3g %% where %.3g %% may be; %s",
                           missing, end, 100 * share, 100 * most,
                           share < 0.9 ? "allow more with `max_missing`, or export the scan with the gaps filled"
                                       : "export the scan with the gaps filled");
    while (start < end && isnan(z[start]))
        start++;
    while (end > start && isnan(z[end - 1]))
        end--;
    size_t trimmed = profile->points - (end - start), bridged = missing - trimmed;
    memmove(z, z + start, (end - start) * sizeof *z);
    *first = start;
    profile->points = end - start;
    if (profile->points < LEAST_POINTS)
        return status_fail(status, STATUS_SCAN, "only %zu heights are there; a profile needs %d", profile->points,
                           LEAST_POINTS);
    for (size_t i = 1, last = 0; i < profile->points; i++) {
        if (isnan(z[i]))
            continue;
        bridge(z, x_m ? x_m + start : NULL, last, i);
        gaps += i > last + 1 ? 1 : 0;
        widest = i - last - 1 > widest ? i - last - 1 : widest;
        last = i;
    }
    if (trimmed > 0)
        profile_note(profile, "missing points cut off at the ends: %zu", trimmed);
    if (bridged > 0)
        profile_note(profile, "missing points bridged by straight lines: %zu; gaps: %zu; points in the longest: %zu",
                     bridged, gaps, widest);
    return STATUS_OK;
}

/** Whether the positions are uniform, rounded or uneven. Rounded: few different steps, the longest at most twice the
 * shortest, and no point is off its place by more than the last digit. Where nearly all steps are the shortest, the
 * longer ones are rows that are missing. */
static enum profile_spacing judge_spacing(const double *x_m, size_t points, double spacing_m)
{
    double shortest = INFINITY, longest = 0, deviation = 0, kinds[SPACING_KINDS];
    size_t kind_count = 0; /* different steps, up to SPACING_KINDS */
    for (size_t i = 1; i < points; i++) {
        double step = x_m[i] - x_m[i - 1];
        shortest = fmin(shortest, step);
        longest = fmax(longest, step);
        deviation = fmax(deviation, fabs(x_m[i] - x_m[0] - (double)i * spacing_m));
        size_t k = 0;
        while (k < kind_count && fabs(step - kinds[k]) > spacing_same * spacing_m)
            k++;
        if (k == kind_count && kind_count < SPACING_KINDS)
            kinds[kind_count++] = step;
    }
    if (longest - shortest <= spacing_uniform * spacing_m)
        return PROFILE_UNIFORM;
    bool gaps = longest > 2.05 * shortest || (longest > 1.95 * shortest && spacing_m < 1.05 * shortest);
    bool rounded = kind_count < SPACING_KINDS && deviation <= 1.05 * (longest - shortest) && !gaps;
    return rounded ? PROFILE_ROUNDED : PROFILE_RESAMPLED;
}

/** Keeps the measured points of an uneven scan, and interpolates its heights to a uniform grid (Steffen, monotonic). */
static enum status_code even_out(struct profile *profile, const double *x_m, struct status *status)
{
    size_t points = profile->points;
    double *uniform_m = malloc(points * sizeof *uniform_m);
    profile->measured_x_m = malloc(points * sizeof *x_m);
    profile->measured_z_m = profile->height_m;
    profile->height_m = uniform_m;
    gsl_interp *spline = gsl_interp_alloc(gsl_interp_steffen, points);
    gsl_interp_accel *accel = gsl_interp_accel_alloc();
    bool good = uniform_m && profile->measured_x_m && spline && accel &&
                gsl_interp_init(spline, x_m, profile->measured_z_m, points) == GSL_SUCCESS;
    for (size_t i = 0; good && i < points; i++) {
        double at_m = fmin(x_m[0] + (double)i * profile->spacing_m, x_m[points - 1]);
        profile->measured_x_m[i] = x_m[i];
        uniform_m[i] = gsl_interp_eval(spline, x_m, profile->measured_z_m, at_m, accel);
    }
    gsl_interp_accel_free(accel);
    gsl_interp_free(spline);
    if (!good)
        return status_memory(status);
    profile_note(profile, "x is uneven; heights were interpolated (Steffen) to a uniform %.6g um",
                 profile->spacing_m * 1e6);
    return STATUS_OK;
}

/** Rounding error [m] of levelling and filtering: heights that differ by no more are flat. */
static double rounding(const struct profile *profile, double peak_to_valley_m)
{
    return 32 * DBL_EPSILON * (fabs(profile->height_m[0]) + peak_to_valley_m);
}

static enum status_code take_level(struct profile *profile, const struct profile_options *options,
                                   struct status *status)
{
    struct levelling levelling;
    double before_m = peak_to_valley(profile), rounding_m = rounding(profile, before_m);
    if (before_m == 0)
        return status_fail(status, STATUS_SCAN, "the scan is flat: every height is %.9g m; check the column",
                           profile->height_m[0]);
    if (before_m < scan_least_m) /* a row of a map; a profile was refused as a scan */
        return status_fail(status, STATUS_SCAN, "the scan is flat: its heights differ by no more than %.3g m",
                           before_m);
    const size_t points = profile->points;
    if ((profile->measured_x_m && level_remove(&levelling, profile->measured_z_m, profile->measured_x_m, points, 0,
                                               options->level, status) != STATUS_OK) ||
        level_remove(&levelling, profile->height_m, NULL, points, profile->spacing_m, options->level, status) !=
            STATUS_OK)
        return status->code;
    if (peak_to_valley(profile) <= rounding_m)
        return status_fail(status, STATUS_SCAN,
                           "the scan is flat: no roughness is left after level: %s; check the column",
                           level_names[options->level]);
    profile->tilt = levelling.tilt;
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

/** Gaussian low-pass of the heights or, where `high`, their difference from it. */
static enum status_code pass(struct profile *profile, double cutoff_m, bool high, struct status *status)
{
    OWNED(memory_free) double *smooth_m = malloc(profile->points * sizeof *smooth_m);
    enum status_code code = smooth_m ? filter_gaussian(smooth_m, profile, cutoff_m, status) : status_memory(status);
    for (size_t i = 0; i < profile->points && code == STATUS_OK; i++)
        profile->height_m[i] = high ? profile->height_m[i] - smooth_m[i] : smooth_m[i];
    if (code != STATUS_OK)
        return code;
    profile_note(profile, "gaussian %s = %.6g um (ISO 16610-21; %s)", high ? "high-pass lambda_c" : "low-pass lambda_s",
                 cutoff_m * 1e6,
                 profile->periodic ? "its end goes on at its beginning" : "weights renormalised at the ends");
    return STATUS_OK;
}

static enum status_code take_filters(struct profile *profile, const struct profile_options *options,
                                     struct status *status)
{
    double length_m = (double)profile->points * profile->spacing_m;
    double lambda_s_m = options->lambda_s_m, lambda_c_m = options->lambda_c_m;
    if (!(lambda_s_m > 0 || lambda_c_m > 0))
        return STATUS_OK;
    const double rounding_m = rounding(profile, peak_to_valley(profile)), longest_m = fmax(lambda_s_m, lambda_c_m);
    if (longest_m > length_m * (1 + 1e-9)) /* which is rounded */
        return status_fail(status, STATUS_SCAN,
                           "lambda_%c is %.6g m, longer than the scan of %.6g m; give a shorter one",
                           longest_m == lambda_c_m ? 'c' : 's', longest_m, length_m);
    if (lambda_s_m > 0 && pass(profile, lambda_s_m, false, status) != STATUS_OK)
        return status->code;
    if (lambda_c_m > 0 && pass(profile, lambda_c_m, true, status) != STATUS_OK)
        return status->code;
    free(profile->measured_x_m); /* these points are not filtered */
    free(profile->measured_z_m);
    profile->measured_x_m = profile->measured_z_m = NULL;
    return peak_to_valley(profile) > rounding_m
               ? STATUS_OK
               : status_fail(status, STATUS_SCAN, "no roughness is left between lambda_s and lambda_c");
}

/** Leaves out the run-up and the overtravel that the scan's header names. */
static enum status_code cut_margins(struct profile *profile, const double margin_m[2], struct status *status)
{
    size_t cut[2];
    if (!(margin_m[0] > 0 || margin_m[1] > 0))
        return STATUS_OK;
    for (int end = 0; end < 2; end++)
        cut[end] = (size_t)fmin(round(margin_m[end] / profile->spacing_m), (double)profile->points);
    if (cut[0] + cut[1] + LEAST_POINTS > profile->points)
        return status_fail(status, STATUS_SCAN,
                           "run-up and overtravel, %.4g and %.4g mm by the header, leave nothing of the record",
                           margin_m[0] * 1e3, margin_m[1] * 1e3);
    profile->points -= cut[0] + cut[1];
    double *const arrays[] = {profile->height_m, profile->measured_x_m, profile->measured_z_m};
    for (int a = 0; a < 3; a++)
        if (arrays[a])
            memmove(arrays[a], arrays[a] + cut[0], profile->points * sizeof *arrays[a]);
    memcpy(profile->margin_m, margin_m, sizeof profile->margin_m);
    profile_note(profile, "run-up of %.4g mm and overtravel of %.4g mm are left out, as the header names them",
                 margin_m[0] * 1e3, margin_m[1] * 1e3);
    return STATUS_OK;
}

enum status_code profile_make(struct profile *out, const struct scan *scan, size_t row,
                              const struct profile_options *options, struct status *status)
{
    *out = (struct profile){.height_m = malloc(scan->nx * sizeof *out->height_m)};
    if (!out->height_m)
        return status_memory(status);
    memcpy(out->height_m, scan->z_m + row * scan->nx, scan->nx * sizeof *out->height_m);
    size_t first = 0;
    bool nominal = false; /* the spacing is the header's */
    out->points = scan->nx;
    out->spacing_m = scan->dx_m;
    if (scan->x_m) {
        out->grid = judge_spacing(scan->x_m, scan->nx, out->spacing_m);
        nominal = out->grid == PROFILE_ROUNDED && fabs(scan->nominal_dx_m / out->spacing_m - 1) <= spacing_nominal;
        out->spacing_m = nominal ? scan->nominal_dx_m : out->spacing_m;
    }
    if (close_gaps(out, &first, scan->x_m, options->max_missing, status) != STATUS_OK)
        return status->code;
    out->digit_m = profile_digitiser_step(out->height_m, out->points);
    if (out->grid == PROFILE_ROUNDED)
        profile_note(out, "x has steps of a few lengths, as if rounded; %s spacing of %.6g um was used",
                     nominal ? "the header's" : "its mean", out->spacing_m * 1e6);
    if (out->grid == PROFILE_RESAMPLED) {
        const double *x_m = scan->x_m + first;
        out->spacing_m = (x_m[out->points - 1] - x_m[0]) / (double)(out->points - 1);
        if (even_out(out, x_m, status) != STATUS_OK)
            return status->code;
    }
    const bool runs_in = options->lambda_c_m > 0; /* the high-pass uses run-up and overtravel for its ends */
    if (!runs_in && cut_margins(out, scan->margin_m, status) != STATUS_OK)
        return status->code;
    out->periodic = out->points >= 3 && record_window_is_periodic(out->height_m, out->points);
    struct profile_options how = *options;
    if (out->periodic && how.periodic_mean && how.level == LEVEL_LINE)
        how.level = LEVEL_MEAN;
    if (take_level(out, &how, status) != STATUS_OK)
        return status->code;
    check_sanity(out, out->digit_m, &how);
    if (take_filters(out, &how, status) != STATUS_OK)
        return status->code;
    return runs_in ? cut_margins(out, scan->margin_m, status) : STATUS_OK;
}

void profile_free(struct profile *profile)
{
    free(profile->height_m);
    free(profile->measured_x_m);
    free(profile->measured_z_m);
    *profile = (struct profile){0};
}
