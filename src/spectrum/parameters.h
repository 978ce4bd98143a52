/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Profile parameters of ISO 21920-2:2021 (as defined in ISO 4287:1997), for P and R profiles.
 *
 * With these conventions the values that instruments print are met to their last digit (tests/spectrum):
 *  - Heights count from 0, the reference line; no line and no mean is removed here. The NIST and NPL EDM profile comes
 *    without its line; from ASME's sine the mean is removed before, from a Mitutoyo R profile nothing.
 *  - a, q, p, v, z, sk, ku, dq are means over the sampling lengths (ISO 4287, with which Mitutoyo's Rq is met; in ISO
 *    21920-2 a, q, sk, ku, dq are of the evaluation length). A P profile has one sampling length, its whole record, so
 *    that both agree. t and sm are of the evaluation length.
 *  - Mean values are 1/n; ku is 3 for a Gaussian.
 *  - dq uses the 7-point slope (z[3] - 9 z[2] + 45 z[1] - 45 z[-1] + 9 z[-2] - z[-3])/(60 h) at the points that have
 *    three neighbours on both sides; m2 of roughness.h is another number, of central differences.
 *  - sm: a profile element is a hill above 10 % of p and a dale below 10 % of v, between crossings of the reference
 *    line, counted in both directions; there is no least width.
 */
#ifndef SPECTRUM_PARAMETERS_H
#define SPECTRUM_PARAMETERS_H

#include "base/status.h"
#include <stddef.h>

enum { PARAMETERS_COUNT = 10 };

extern const char *const parameters_names[PARAMETERS_COUNT]; /* after P or R: "a" for Pa, Ra */

struct parameters {
    char letter; /* 'P' or 'R' */
    size_t sampling_lengths;
    double first_m, evaluation_length_m; /* where in the profile it begins, and its length */
    double value[PARAMETERS_COUNT];      /* of parameters_names, lengths in m; NaN: not defined */
};

/** Parameters of `points` >= 3 heights cut into `sampling_lengths` equal parts. */
struct parameters parameters_compute(char letter, const double *height_m, size_t points, double spacing_m,
                                     size_t sampling_lengths);

/** Those of an R profile (high-pass filtered), as instruments do it: half a cutoff_m is left out at either end, where
 * the filter runs in, less `margin_m` that was left out before (NULL: a periodic profile, nothing is left out). As many
 * sampling lengths of cutoff_m as fit are taken from the middle of the rest; one that is at most 1 % short fits. Error:
 * STATUS_SCAN: not one fits. */
MUST_CHECK enum status_code parameters_of_roughness(struct parameters *out, const double *height_m, size_t points,
                                                    double spacing_m, double cutoff_m, const double margin_m[2],
                                                    struct status *status);

#endif
