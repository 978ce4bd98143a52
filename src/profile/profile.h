/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From a scan to a profile: gaps bridged, uniform spacing, levelled, filtered (docs/equations.md, From scan to
 * spectrum). Every step that changed something adds a line to `notes`. */
#ifndef PROFILE_PROFILE_H
#define PROFILE_PROFILE_H

#include "profile/level.h"
#include "scan/scan.h"

enum profile_spacing { PROFILE_UNIFORM, PROFILE_ROUNDED, PROFILE_RESAMPLED };

enum { PROFILE_NOTES = 24, PROFILE_NOTE_LENGTH = 240 };

/** The scene's keys of the same names. */
struct profile_options {
    enum level level;
    double max_missing;            /* share of the points, 0...1 */
    double lambda_s_m, lambda_c_m; /* cut-offs of the Gaussian low-pass and high-pass; 0: none */
    double tip_radius_m;           /* for a warning only; 0: not known */
    bool periodic_mean;            /* of a periodic record take the mean out: a line would make a step at its ends */
};

/** Points that a report needs: the first harmonic whose estimate by five sine tapers keeps off the ends of the spectrum
 * is the fifth (docs/equations.md, power_law_band.h), below the Nyquist frequency of 11 points. */
enum { PROFILE_SPECTRUM_POINTS = 11 };

struct profile {
    double *height_m; /* `points` heights, spacing_m apart, levelled and filtered */
    size_t points;
    double spacing_m;
    enum profile_spacing grid;           /* as it was; rounded: x is not used; resampled: x was uneven */
    double *measured_x_m, *measured_z_m; /* uneven x and no filter: the points as measured, levelled; else NULL */
    bool periodic;                       /* before levelling: record_window_is_periodic() */
    double digit_m;                      /* step of the digitiser: profile_digitiser_step(); 0: none seen */
    double margin_m[2];                  /* run-up and overtravel that were left out */
    double tilt;                         /* slope that levelling took out (line, parabola, circle, robust), else 0 */
    char notes[PROFILE_NOTES][PROFILE_NOTE_LENGTH]; /* each one line, lower case: steps taken and warnings */
    size_t note_count;
};

/** A line (of a periodic record the mean), a tenth of the points may be missing, no filters. */
extern const struct profile_options profile_defaults;

/** Makes the profile of row `row` of a scan:
 *  missing points are cut off at the ends, and bridged by straight lines elsewhere;
 *  x rounded to few digits: the header's spacing if it fits to 0.5 %, else the mean one; uneven: interpolated
 * (Steffen); run-up and overtravel are left out, with lambda_c after the filters, which use them; levelling (level.h),
 * Gaussian low-pass lambda_s, high-pass lambda_c. profile_free() frees it whatever is returned. Errors: STATUS_SCAN
 * (more missing than options->max_missing, fewer than 3 points, flat before or after a step, lambda_c longer than the
 * scan), STATUS_MEMORY. */
MUST_CHECK enum status_code profile_make(struct profile *out, const struct scan *scan, size_t row,
                                         const struct profile_options *options, struct status *status);
void profile_free(struct profile *profile);

/** The step [m] of the digitiser, 0 where none is seen, in at least 2 heights. From the differences of neighbours the
 * one nearest to their mean is subtracted: the tilt, rounded as heights are, so that it does not matter whether the
 * instrument levelled after digitising. The step is the smallest difference left, if 95 % of those below 3.5 times it
 * are whole multiples of it to 15 % (printing rounds once more) and they are 30 and 1 % of the points or more. */
double profile_digitiser_step(const double *height_m, size_t points);

/* The linear Gaussian profile filter (ISO 16610-21). */

/** Smooths a profile's heights into smooth_m, which does not overlap them: weights exp(-pi (x/(a lambda))²), a =
 * sqrt(ln 2/pi), pass half the amplitude of wavelength lambda = cutoff_m; below 1e-9 of the largest (1.21 cutoff_m)
 * they are 0. Near the ends the weights within the record are scaled to the sum 1: no point is cut off, and a constant
 * stays. A periodic record goes on beyond its ends. By FFT where more than a few neighbours have a weight. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code filter_gaussian(double *smooth_m, const struct profile *profile, double cutoff_m,
                                            struct status *status);

/* A record that does not close on itself has a step between its ends, which spoils the spectrum: it gets a window. */

/** sqrt(8/3), for the mean square of (1 - cos)/2 is 3/8. The same for every record: a factor that keeps the mean square
 * of this one would bring the scatter of its longest waves into all harmonics. Harris 1978,
 * doi:10.1109/PROC.1978.10837 */
extern const double record_window_hann_factor;

/** Is the record periodic? From heights before levelling (a line taken out would make a step): the step from last to
 * first is at most 3 rms differences of neighbours, and each second difference there at most 3 rms second differences.
 * At least 98 % of simulated periodic records pass, and at most 1 % of others. points >= 3, heights finite. A constant
 * record is periodic. */
bool record_window_is_periodic(const double *raw_height_m, size_t points);

/** Multiplies heights of mean zero in place by sqrt(8/3) (1 - cos(2 pi (t + 1/2)/N))/2, t = 0 ... N-1. */
void record_window_hann(double *height_m, size_t points);

#endif
