/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A synthetic profile that follows a power law, such as the four surfaces of the thesis's table 6.2. */
#ifndef PROFILE_SYNTH_H
#define PROFILE_SYNTH_H

#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>

/** Amplitudes are Delta_n = alpha lambda_n^gamma 10^(scatter xi_n), lambda_n = L/n, phases random. */
struct synth_def {
    double alpha; /* m^(1-gamma) */
    double gamma;
    double rq_m;     /* Rq to reach; 0: whatever alpha, gamma and scatter give */
    bool scaled;     /* by another alpha; else by the scatter, and alpha stays */
    double length_m; /* L = points * spacing */
    size_t points;
    double scatter_decades; /* RMS of log10 amplitude about the law */
    double lambda_s_m;      /* below it amplitudes fall as through a Gaussian low-pass, which is 1 there; 0: none */
    unsigned long seed;
};

struct synth_def synth_def_default(void);

/** Fills height_m (`points` values). The least-squares line of log10 Delta over lambda_s ... L gives alpha, gamma and
 * the scatter back exactly, for xi is made orthogonal to it. Rq is met by another xi of that kind, or by scaling alpha.
 * The phase of one long wave makes the least-squares line of the profile level, so that levelling changes nothing.
 * Errors: STATUS_USAGE (points < 8, a number out of range, no such scatter gives rq_m), STATUS_MEMORY. */
MUST_CHECK enum status_code synth_profile(double *height_m, const struct synth_def *def, struct status *status);

#endif
