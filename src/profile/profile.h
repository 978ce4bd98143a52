/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A scan made ready: gaps bridged, heights at a uniform spacing, levelled, filtered (docs/equations.md, From scan to
 * spectrum). Every step that did something leaves a line in `notes`. */
#ifndef PROFILE_PROFILE_H
#define PROFILE_PROFILE_H

#include "profile/level.h"
#include "scan/scan.h"

enum profile_spacing { PROFILE_UNIFORM, PROFILE_ROUNDED, PROFILE_RESAMPLED };

enum { PROFILE_NOTES = 24, PROFILE_NOTE_LENGTH = 240 };

/** How a scan is made ready; the scene's keys of the same names. */
struct profile_options {
    enum level level;
    double max_missing;            /* share of the points, 0...1 */
    double lambda_s_m, lambda_c_m; /* cut-offs of the Gaussian low-pass and high-pass; 0: none */
    double tip_radius_m;           /* for a warning only; 0: not known */
    bool periodic_mean;            /* of a periodic record the mean is taken out, not a line, which would make a step */
};

struct profile {
    double *height_m; /* `points` heights, spacing_m apart, levelled and filtered */
    size_t points;
    double spacing_m;
    enum profile_spacing grid;           /* as printed; rounded x, nominal spacing used; uneven x, interpolated */
    double *measured_x_m, *measured_z_m; /* uneven x and no filter: the points as measured, levelled; else NULL */
    bool periodic;                       /* it closes on itself, before levelling: record_window_is_periodic() */
    double digit_m;                      /* step of the digitiser: profile_digitiser_step(); 0: none seen */
    double margin_m[2];                  /* of run-up and overtravel, left out at its ends */
    double tilt;                         /* slope the levelling took out (line, parabola, circle, robust), else 0 */
    char notes[PROFILE_NOTES][PROFILE_NOTE_LENGTH]; /* each one line, lower case: steps taken and warnings */
    size_t note_count;
};

/** Line (mean of a periodic record), a tenth of the points may be missing, no filters. */
extern const struct profile_options profile_defaults;

/** Makes the profile of a scan's row `row` (0 for a profile):
 *  missing points: at the ends cut off, between others bridged by straight lines;
 *  x: uniform; or rounded to few digits: the header's spacing where it names one that fits to 0.5 %, else the mean one;
 *     or uneven: interpolated monotonically (Steffen) to a uniform grid;
 *  run-up and overtravel left out, but where lambda_c is given: then they are what the filter runs in on;
 *  levelling (level.h); Gaussian low-pass lambda_s, then high-pass lambda_c.
 * Owned: profile_free(), whatever comes back. Errors: STATUS_SCAN: more points missing than options->max_missing, fewer
 * than 3 left, a flat profile (before or after levelling or the filters), a lambda_c longer than the scan;
 * STATUS_MEMORY. */
MUST_CHECK enum status_code profile_make(struct profile *out, const struct scan *scan, size_t row,
                                         const struct profile_options *options, struct status *status);
void profile_free(struct profile *profile);

/** The step [m] of the digitiser, 0 where none is seen, in at least 2 heights, from the differences of neighbours with
 * the tilt off: less the one that is nearest to their mean, which is rounded as they are, so that it does not matter
 * whether the instrument levelled after it had digitised. The step is the smallest that is left, when at least 95 % of
 * the small ones (below 3.5 of it) are whole multiples of it to 15 % (instruments round once more when they print), and
 * there are enough of them (1 % of the points, 30 or more). */
double profile_digitiser_step(const double *height_m, size_t points);

/* The linear Gaussian profile filter (ISO 16610-21). */

/** Smooths a profile's heights into smooth_m, which does not overlap them: weights exp(-pi (x/(a lambda))²), a =
 * sqrt(ln 2/pi), which let half of the amplitude of wavelength lambda = cutoff_m through, cut off where they fall below
 * 1e-9 of the largest (1.21 cutoff_m). Near the ends only the weights that lie within the record count, renormalised to
 * the sum 1: no point is cut off, and a constant passes unchanged up to both ends. By FFT, n log n, where more than a
 * few neighbours have a weight. Of a periodic record the end goes on at the beginning, with all weights. Errors:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code filter_gaussian(double *smooth_m, const struct profile *profile, double cutoff_m,
                                            struct status *status);

/* Whether a record closes on itself, and the window for one that does not: the spectrum of a record cut out of a longer
 * surface is spoilt by the step between its ends. */

/** sqrt(8/3): the mean square of (1 - cos)/2 is 3/8. A constant, not what keeps this one record's mean square: that
 * would put the scatter of its longest waves into every harmonic. Harris 1978, doi:10.1109/PROC.1978.10837 */
extern const double record_window_hann_factor;

/** Is the record periodic? By RAW heights, before levelling, as a line taken out would make a step: the step from last
 * to first is at most 3 rms differences of neighbours, and each second difference across that join at most 3 rms second
 * differences, the rms over those inside the record. Of simulated periodic records 98 % pass and more, of others 1 % or
 * less. points >= 3; heights finite. A constant record is periodic. */
bool record_window_is_periodic(const double *raw_height_m, size_t points);

/** Multiplies heights of mean zero in place by sqrt(8/3) (1 - cos(2 pi (t + 1/2)/N))/2, t = 0 ... N-1. */
void record_window_hann(double *height_m, size_t points);

#endif
