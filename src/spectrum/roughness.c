/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/roughness.h"

#include <math.h>

const char *const roughness_moments_names[ROUGHNESS_MOMENTS_COUNT] = {"difference", "spectral"};

static const double summit_variance = 3.717e-4;       /* McCool 1986, thesis (4.24) */
static const double summit_variance_digits = 1.35e-4; /* its relative rounding: half a unit of the last digit printed */
static const double summit_offset = 0.045944;         /* Front, thesis (4.30) */

static const double most_nayak = 1e24; /* beyond it slopes are rounding, of differences of equal heights */

struct roughness roughness_of_heights_alone(const double *height_m, size_t points)
{
    double square = 0, cube = 0, fourth = 0, absolute = 0, lowest = INFINITY, highest = -INFINITY, count = 0;
    for (size_t i = 0; i < points; i++) {
        if (isnan(height_m[i]))
            continue;
        double z2 = height_m[i] * height_m[i];
        square += z2;
        cube += z2 * height_m[i];
        fourth += z2 * z2;
        absolute += fabs(height_m[i]);
        lowest = height_m[i] < lowest ? height_m[i] : lowest;
        highest = height_m[i] > highest ? height_m[i] : highest;
        count++;
    }
    return (struct roughness){.rq_m = sqrt(square / count),
                              .ra_m = absolute / count,
                              .pv_m = highest - lowest,
                              .m0_m2 = square / count,
                              .cube_m3 = cube / count,
                              .fourth_m4 = fourth / count};
}

struct roughness roughness_of_heights(const double *height_m, size_t points, double spacing_m)
{
    struct roughness roughness = roughness_of_heights_alone(height_m, points);
    double slope_square = 0, curve_square = 0, slopes = 0, curves = 0;
    for (size_t i = 1; i + 1 < points; i++) {
        double slope = (height_m[i + 1] - height_m[i - 1]) / (2 * spacing_m);
        double curvature = (height_m[i + 1] - 2 * height_m[i] + height_m[i - 1]) / spacing_m / spacing_m;
        slope_square += isnan(slope) ? 0 : slope * slope;
        curve_square += isnan(curvature) ? 0 : curvature * curvature;
        slopes += !isnan(slope);
        curves += !isnan(curvature);
    }
    roughness.m2 = slope_square / slopes;
    roughness.m4_per_m2 = curve_square / curves;
    return roughness;
}

struct roughness roughness_of_points(const double *x_m, const double *height_m, size_t points)
{
    struct roughness roughness = roughness_of_heights_alone(height_m, points);
    double slope_square = 0, curve_square = 0;
    for (size_t i = 1; i + 1 < points; i++) {
        double before = (height_m[i] - height_m[i - 1]) / (x_m[i] - x_m[i - 1]);
        double after = (height_m[i + 1] - height_m[i]) / (x_m[i + 1] - x_m[i]), span_m = x_m[i + 1] - x_m[i - 1];
        double slope = (height_m[i + 1] - height_m[i - 1]) / span_m, curvature = 2 * (after - before) / span_m;
        slope_square += slope * slope;
        curve_square += curvature * curvature;
    }
    roughness.m2 = slope_square / (double)(points - 2);
    roughness.m4_per_m2 = curve_square / (double)(points - 2);
    return roughness;
}

void roughness_from_spectrum(struct roughness *roughness, const struct spectrum *spectrum)
{
    roughness->m0_m2 = spectrum_moment(spectrum, 0);
    roughness->m2 = spectrum_moment(spectrum, 1);
    roughness->m4_per_m2 = spectrum_moment(spectrum, 2);
}

void roughness_average(struct roughness *mean, const struct roughness *other, size_t so_far)
{
    double weight = 1 / (double)(so_far + 1);
    if (so_far == 0) {
        *mean = *other;
        return;
    }
    mean->ra_m += weight * (other->ra_m - mean->ra_m);
    mean->m0_m2 += weight * (other->m0_m2 - mean->m0_m2);
    mean->m2 += weight * (other->m2 - mean->m2);
    mean->m4_per_m2 += weight * (other->m4_per_m2 - mean->m4_per_m2);
    mean->cube_m3 += weight * (other->cube_m3 - mean->cube_m3);
    mean->fourth_m4 += weight * (other->fourth_m4 - mean->fourth_m4);
    mean->rq_m = sqrt(mean->m0_m2);
    mean->pv_m = fmax(mean->pv_m, other->pv_m);
}

void roughness_add(struct roughness *sum, const struct roughness *other)
{
    sum->cube_m3 += other->cube_m3; /* cumulants of independent heights add */
    sum->fourth_m4 += other->fourth_m4 + 6 * sum->m0_m2 * other->m0_m2;
    sum->m0_m2 += other->m0_m2;
    sum->m2 += other->m2;
    sum->m4_per_m2 += other->m4_per_m2;
    sum->rq_m = sqrt(sum->m0_m2);
    sum->ra_m = sum->pv_m = NAN; /* of the two together neither is known */
}

double roughness_skewness(const struct roughness *roughness)
{
    return roughness->cube_m3 / (roughness->m0_m2 * sqrt(roughness->m0_m2));
}

double roughness_kurtosis(const struct roughness *roughness)
{
    return roughness->fourth_m4 / roughness->m0_m2 / roughness->m0_m2;
}

double roughness_nayak(const struct roughness *roughness)
{
    if (!(roughness->m2 > 0))
        return NAN;
    double nayak = roughness->m0_m2 / roughness->m2 * (roughness->m4_per_m2 / roughness->m2);
    return nayak <= most_nayak ? nayak : NAN;
}

enum status_code roughness_asperities(struct asperities *out, const struct roughness *roughness, struct status *status)
{
    double m0 = roughness->m0_m2, m2 = roughness->m2, m4 = roughness->m4_per_m2;
    *out = (struct asperities){NAN, NAN, NAN, NAN, NAN, sqrt(m0)};
    out->nayak = m0 > 0 && m4 > 0 ? roughness_nayak(roughness) : NAN;
    if (isnan(out->nayak))
        return status_fail(status, STATUS_MODEL,
                           "the profile is flat, or rises nowhere from one point to the next but one: no asperities "
                           "to count");
    out->density_per_m2 = m4 / m2 / (6 * M_PI * sqrt(3));
    out->radius_m = 0.375 * sqrt(M_PI / m4);
    double density_radius = out->density_per_m2 * out->radius_m;
    out->offset_m = summit_offset / density_radius;
    double variance = m0 - summit_variance / (density_radius * density_radius);
    if (variance <= summit_variance_digits * m0)
        return status_fail(
            status, STATUS_MODEL,
            "Nayak parameter %.5g is not above 0.897, so the summit height variance is not positive (its "
            "formula has no more digits) and no statistical model exists; sample the surface more finely, "
            "or use models: [multiscale]",
            out->nayak);
    out->sigma_s_m = sqrt(variance);
    return STATUS_OK;
}
