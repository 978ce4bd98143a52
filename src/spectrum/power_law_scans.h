/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The spectrum to which the power law of a surface is fitted: mean power over its scans, and how many independent scans
 * they are. */
#ifndef SPECTRUM_POWER_LAW_SCANS_H
#define SPECTRUM_POWER_LAW_SCANS_H

#include "spectrum/power_law.h"

/** A scan, and the number of its file, from 0. */
struct power_law_scan {
    struct spectrum spectrum;
    size_t file;
};

/** Starts as {0}. Owned: power_law_scans_free(). */
struct power_law_scans {
    struct spectrum mean;        /* rms amplitudes, grid_average() of those of the scans */
    struct power_law_scan *scan; /* scan_count of them */
    size_t scan_count;
    size_t closed, files; /* scans in files that are complete, and those files */
    double independent;   /* M: profile scans, and what the rows of maps count as */
    double step_m;        /* largest digitising step; 0: none seen */
};

/** Adds the multitaper spectrum of a scan or a row of a map; levelling does not matter. step_m: digitising step, 0:
 * none seen. Errors: of multitaper_square(). */
MUST_CHECK enum status_code power_law_scans_add(struct power_law_scans *scans, const double *height_m, size_t points,
                                                double spacing_m, double step_m, struct status *status);

/** Ends a file of `used` scans or rows. Rows of a map, added in their order, count as fewer independent scans, by the
 * correlation of 16 means of neighbouring rows. The value of a row is the mean over its bins (log_bin.h) of the
 * logarithm of its power, in which every decade of wavelength has the same weight. */
void power_law_scans_end_file(struct power_law_scans *scans, size_t used, bool rows);

/** The law of the mean spectrum: power_law_band_find(), or power_law_band_fit_in() where band_m is not NULL. Waves
 * below twice lambda_s_m, the cut-off of the low-pass that was applied (0: none), are not used. Class NONE without a
 * scan. */
void power_law_scans_fit(struct power_law_band *out, const struct power_law_scans *scans, double lambda_s_m,
                         const double *band_m);

/** The law of scan i alone in the band of `mean`, a law that was found. */
void power_law_scans_fit_alone(struct power_law_band *out, const struct power_law_scans *scans, size_t i,
                               double lambda_s_m, const struct power_law_band *mean);

void power_law_scans_free(struct power_law_scans *scans);

#endif
