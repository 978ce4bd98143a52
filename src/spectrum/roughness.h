/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Statistical parameters of a levelled profile (docs/equations.md, Statistical models; 4.19-4.24, 4.30). */
#ifndef SPECTRUM_ROUGHNESS_H
#define SPECTRUM_ROUGHNESS_H

#include "spectrum/spectrum.h"

/** How m2 and m4 are found: by finite differences of the heights, or from the spectrum. */
enum roughness_moments { ROUGHNESS_MOMENTS_DIFFERENCE, ROUGHNESS_MOMENTS_SPECTRAL, ROUGHNESS_MOMENTS_COUNT };
extern const char *const roughness_moments_names[ROUGHNESS_MOMENTS_COUNT]; /* as a scene spells them */

struct roughness {
    double rq_m;      /* root mean square height */
    double ra_m;      /* mean absolute height */
    double pv_m;      /* highest minus lowest */
    double m0_m2;     /* mean square height */
    double m2;        /* mean square slope */
    double m4_per_m2; /* mean square curvature */
    double cube_m3;   /* mean cubed height */
    double fourth_m4; /* mean fourth power of the height */
};

/** Of levelled heights, `points` >= 3: m2 by central differences, m4 by the 3-point second difference, over the inner
 * points (4.19, 4.20). Missing points (NaN) are left out; a slope or curvature counts where none of its points is
 * missing. m2 or m4 is NaN where none counts. */
struct roughness roughness_of_heights(const double *height_m, size_t points, double spacing_m);

/** The same without m2 and m4, which are left 0. */
struct roughness roughness_of_heights_alone(const double *height_m, size_t points);

/** roughness_of_heights() of heights at uneven positions (ascending): m2 by (z[i+1] - z[i-1])/(x[i+1] - x[i-1]), m4 by
 * the second divided difference through three points (4.19, 4.20). */
struct roughness roughness_of_points(const double *x_m, const double *height_m, size_t points);

/** Replaces m0, m2, m4 by those of the spectrum. */
void roughness_from_spectrum(struct roughness *roughness, const struct spectrum *spectrum);

/** Rsk and Rku, mean cube and fourth power over those of Rq (ISO 21920-2): 0 and 3 for Gaussian heights. */
double roughness_skewness(const struct roughness *roughness);
double roughness_kurtosis(const struct roughness *roughness);

/** Adds a scan to a mean over `so_far` others, 0 of which begin one: m0, m2, m4, Ra averaged, Rq from m0, PV the
 * largest. */
void roughness_average(struct roughness *mean, const struct roughness *other, size_t so_far);

/** Two rough surfaces in contact: moments add, Rq follows; Ra and PV become NaN. */
void roughness_add(struct roughness *sum, const struct roughness *other);

/** Nayak parameter m0 m4/m2²; NaN where slopes are 0 but for rounding (above 1e24). */
double roughness_nayak(const struct roughness *roughness);

/** The rough surface as the statistical models see it: asperities of one radius, Gaussian heights. */
struct asperities {
    double nayak;          /* m0 m4/m2²; NaN without slopes */
    double density_per_m2; /* eta = (m4/m2)/(6 pi sqrt3) (4.21) */
    double radius_m;       /* R = 0.375 sqrt(pi/m4) (4.22) */
    double sigma_s_m;      /* sqrt(m0 - 3.717e-4/(eta R)²) (4.24) */
    double offset_m;       /* y_s = 0.045944/(eta R) (4.30) */
    double sigma_m;        /* sqrt(m0) */
};

/** Error: STATUS_MODEL when no statistical model exists: a flat profile, or a Nayak parameter below about 0.8968, for
 * which sigma_s² is not positive to the digits of (4.24). What could be computed is in `out` (sigma_s NaN). */
MUST_CHECK enum status_code roughness_asperities(struct asperities *out, const struct roughness *roughness,
                                                 struct status *status);

#endif
