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
 *  levelling (level.h); Gaussian low-pass lambda_s, then high-pass lambda_c (filter.h).
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

#endif
