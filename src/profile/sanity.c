/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "profile/sanity.h"

#include <math.h>

static const double sanity_steepest = 10;     /* slope */
static const double sanity_digit_share = 0.2; /* of m4 */
static const double sanity_noise_ratio = 8;   /* of m4 at h to m4 at 2h: amplitudes as lambda^0.5 */
static const double sanity_end_jump = 3;      /* Rq */
enum { SANITY_POINTS = 64, SANITY_STEPS = 30 };

/** Of the differences of neighbours the one nearest to their mean: the tilt, rounded as the heights are. */
static double rounded_tilt(const double *height_m, size_t points)
{
    double mean = (height_m[points - 1] - height_m[0]) / (double)(points - 1), nearest = INFINITY;
    for (size_t i = 1; i < points; i++) {
        double d = height_m[i] - height_m[i - 1];
        nearest = fabs(d - mean) < fabs(nearest - mean) ? d : nearest;
    }
    return nearest;
}

double sanity_digitising(const double *height_m, size_t points)
{
    double largest = 0, least = INFINITY, sum = 0, tilt = rounded_tilt(height_m, points);
    for (size_t i = 0; i < points; i++)
        largest = fmax(largest, fabs(height_m[i]));
    double nothing = 1e-13 * largest; /* equal heights may differ by what conversion of units rounds */
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
        return 0; /* all neighbours differ alike */
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

static void check_units(struct profile *profile, double rq_m)
{
    double length_m = (double)profile->points * profile->spacing_m, steepest = 0;
    for (size_t i = 1; i < profile->points; i++)
        steepest = fmax(steepest, fabs(profile->height_m[i] - profile->height_m[i - 1]) / profile->spacing_m);
    if (rq_m > length_m)
        profile_note(profile, "Rq %.3g m is above the length of the scan, %.3g m: check x_unit and z_unit", rq_m,
                     length_m);
    else if (steepest > sanity_steepest)
        profile_note(profile, "the steepest slope is %.3g (%.0f degrees): check the units, or spikes in the scan",
                     steepest, atan(steepest) * 180 / M_PI);
}

static void check_curvature(struct profile *profile, double digit_m, const struct profile_options *options)
{
    double m4 = curvature(profile, 1), coarse = curvature(profile, 2), h = profile->spacing_m;
    bool filtered = options->lambda_s_m > 2 * h; /* what follows then is not in the profile any more */
    double digit_m4 = digit_m / h / h * (digit_m / h / h) / 2;
    if (!filtered && digit_m4 > sanity_digit_share * m4)
        profile_note(
            profile,
            "heights come in steps of %.3g nm, whose rounding alone makes %.0f %% of m4: the statistical models "
            "follow the digitiser; give lambda_s",
            digit_m * 1e9, fmin(100, 100 * digit_m4 / m4));
    else if (!filtered && coarse > 0 && m4 > sanity_noise_ratio * coarse)
        profile_note(
            profile,
            "m4 is noise of the shortest wavelengths: %.1f times smaller with every other point (white noise: 16); "
            "give lambda_s",
            m4 / coarse);
    double tip_m = options->tip_radius_m, shortest_m = fmax(2 * h, options->lambda_s_m);
    if (!filtered && m4 * tip_m * tip_m > 1)
        profile_note(profile,
                     "the RMS radius of curvature, %.3g um, is below the tip radius, %.3g um: the stylus cannot have "
                     "followed it; give lambda_s",
                     1e6 / sqrt(m4), tip_m * 1e6);
    else if (tip_m > shortest_m && (filtered || m4 > 2 * coarse))
        profile_note(
            profile,
            "the shortest wavelength, %.3g um, is below the tip radius, %.3g um: the stylus rounds it off; give "
            "lambda_s of at least that",
            shortest_m * 1e6, tip_m * 1e6);
}

void sanity_check(struct profile *profile, double digit_m, const struct profile_options *options)
{
    double square = 0, mean = 0;
    for (size_t i = 0; i < profile->points; i++)
        mean += profile->height_m[i] / (double)profile->points;
    for (size_t i = 0; i < profile->points; i++)
        square += (profile->height_m[i] - mean) * (profile->height_m[i] - mean);
    double rq_m = sqrt(square / (double)profile->points);
    double jump_m = fabs(profile->height_m[profile->points - 1] - profile->height_m[0]);
    check_units(profile, rq_m);
    check_curvature(profile, digit_m, options);
    if (jump_m > sanity_end_jump * rq_m)
        profile_note(profile, "the ends of the record differ by %.3g um, %.1f Rq: as a period it has a step there",
                     jump_m * 1e6, jump_m / rq_m);
    if (profile->points < SANITY_POINTS)
        profile_note(profile, "only %zu points; the spectrum has %zu harmonics", profile->points, profile->points / 2);
}
