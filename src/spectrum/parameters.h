/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Profile parameters of ISO 21920-2:2021 (as ISO 4287:1997 has them), for P and R profiles.
 *
 * Conventions, under which the values that instruments print come out to their last digit (tests/spectrum):
 *  - Heights count from 0, the reference line, as they come: no line and no mean is taken out here. The NIST and NPL
 *    EDM profile has its line removed already; ASME's sine wants the mean taken out and no line; a Mitutoyo R profile
 *    wants neither.
 *  - a, q, p, v, z, sk, ku, dq are means over the sampling lengths, each of its own points only (ISO 4287; with this
 *    Mitutoyo's Rq comes out; ISO 21920-2 takes a, q, sk, ku, dq over the evaluation length instead). A P profile has
 *    one sampling length, its whole record, so there both agree. t and sm are of the evaluation length.
 *  - Mean values are 1/n; ku is 3 for a Gaussian.
 *  - dq uses the 7-point slope (z[3] - 9 z[2] + 45 z[1] - 45 z[-1] + 9 z[-2] - z[-3])/(60 h) at the points that have
 *    three neighbours on both sides. m2 of roughness.h is of central differences: another number.
 *  - sm: a profile element is a hill above 10 % of p and a dale below 10 % of v, from crossing to crossing of the
 *    reference line, counted in both directions; there is no least width.
 */
#ifndef SPECTRUM_PARAMETERS_H
#define SPECTRUM_PARAMETERS_H

#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>

enum { PARAMETERS_COUNT = 10 };

struct parameters_row {
    const char *name; /* after P or R: "a" for Pa, Ra */
    bool is_length;   /* in m; else a pure number */
};
extern const struct parameters_row parameters_rows[PARAMETERS_COUNT];

struct parameters {
    char letter; /* 'P' or 'R' */
    size_t sampling_lengths;
    double first_m, evaluation_length_m; /* where that begins in the profile; points h, those outside the sampling
                                            lengths left out */
    double value[PARAMETERS_COUNT];      /* of parameters_rows; NaN: not defined for these heights */
};

/** Parameters of `points` >= 3 heights cut into `sampling_lengths` equal parts. */
struct parameters parameters_compute(char letter, const double *height_m, size_t points, double spacing_m,
                                     size_t sampling_lengths);

/** Those of an R profile (high-pass filtered), as instruments have them: the filter runs in on half a cutoff_m at
 * either end, less what was left out there already (`margin_m`; NULL: the profile is periodic, and the filter needs
 * none); of what is between, as many sampling lengths of cutoff_m as fit (one that is at most 1 % short fits), from the
 * middle. Error: STATUS_SCAN: not one fits. */
MUST_CHECK enum status_code parameters_of_roughness(struct parameters *out, const double *height_m, size_t points,
                                                    double spacing_m, double cutoff_m, const double margin_m[2],
                                                    struct status *status);

#endif
