/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A made-up profile that obeys a power law: the four surfaces of the thesis's table 6.2 come from here. */
#ifndef PROFILE_SYNTH_H
#define PROFILE_SYNTH_H

#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>

/** What to make. Amplitudes follow Delta_n = alpha lambda_n^gamma 10^(scatter xi_n), lambda_n = L/n, with random
 * phases. */
struct synth_def {
    double alpha; /* m^(1-gamma) */
    double gamma;
    double rq_m;     /* root mean square height to reach; 0: whatever alpha, gamma and scatter give */
    bool scaled;     /* that Rq is met by another alpha; else by the scatter, and alpha stays */
    double length_m; /* L = points * spacing */
    size_t points;
    double scatter_decades; /* RMS of log10 amplitude about the law */
    double lambda_s_m;      /* below it amplitudes fall like a Gaussian low-pass that is 1 here; 0: no cut-off */
    unsigned long seed;
};

struct synth_def synth_def_default(void);

/** Fills height_m (`points` values). In the band lambda_s ... L, and in no other, the least-squares line of log10 Delta
 * gives alpha, gamma and the scatter back exactly: xi is made orthogonal to the fit. Rq is met by turning xi within
 * that space, or by scaling alpha. The phase of one long wave is chosen so that the least-squares line of the profile
 * is level: levelling leaves it as it is. Errors: STATUS_USAGE when points < 8, a number is out of range, or no scatter
 * of that size gives rq_m; STATUS_MEMORY.
 */
MUST_CHECK enum status_code synth_profile(double *height_m, const struct synth_def *def, struct status *status);

#endif
