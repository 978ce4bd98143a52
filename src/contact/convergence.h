/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Does the area converge as ever smaller scales are included? (4.53, 4.55; thesis 6.2); docs/equations.md,
 * Convergence. */
#ifndef CONTACT_CONVERGENCE_H
#define CONTACT_CONVERGENCE_H

#include "material/material.h"
#include "spectrum/spectrum.h"
#include <stdint.h>

enum convergence_sweep { CONVERGENCE_ALPHA, CONVERGENCE_GAMMA, CONVERGENCE_SWEEP_COUNT };
enum { CONVERGENCE_VALUES_MOST = 9 };

/** One row a sweep: which parameter runs over which values. */
struct convergence_sweep_row {
    const char *name; /* as in convergence.csv */
    size_t count;
    double values[CONVERGENCE_VALUES_MOST];
};
extern const struct convergence_sweep_row convergence_sweeps[CONVERGENCE_SWEEP_COUNT];

/** Area ratio after each scale of a synthetic law Delta_n = alpha lambda_n^gamma, lambda_n = L/n. */
struct convergence_law {
    double alpha, gamma, length_m, load;
    size_t scales;
};

/** Fills area_ratio[scales] with A/A_n after scale n = 1 ... scales of (4.53) (closure thesis). */
void convergence_areas(double *area_ratio, const struct convergence_law *law, const struct material_pair *pair,
                       bool plastic, uint64_t *evaluations);

/** Smallest wavelength a continuum can have: about an atom's diameter. */
extern const double convergence_atom_m;

/** How a measured spectrum goes on below the last harmonic that is known: Delta = amplitude (lambda/wavelength)^gamma.
 */
struct convergence_tail {
    double wavelength_m; /* geometric mean of the harmonics that say so */
    double amplitude_m;  /* of the line there */
    double gamma;        /* local slope; NaN: fewer than 3 harmonics to tell it from, or a filter's flank */
    size_t count;        /* harmonics that are known */
};

/** The spectrum's own short end: the least-squares line of log Delta on log lambda over the shortest half decade of
 * wavelengths of its first `count` harmonics; amplitudes of zero are left out. A slope above 3 is a filter's. */
struct convergence_tail convergence_tail(const struct spectrum *spectrum, size_t count);
/** Amplitude of the tail at a wavelength [m]. */
double convergence_tail_amplitude(const struct convergence_tail *tail, double wavelength_m);

/** What the scales below the last known harmonic of a surface would still take from its area. */
struct convergence_extension {
    double area_measured; /* A/A_n of the known harmonics */
    double area_extended; /* the same with its tail carried on to atomic size */
    uint64_t scales;      /* visited */
};

/** Stacks the known harmonics (4.1, 4.2; closure thesis) and goes on along the tail, at one load. Stops at the first
 * scale of the tail from which p* can no longer exceed the pressure (gamma >= 1, 4.55), or at atomic size. */
struct convergence_extension convergence_extend(const struct spectrum *spectrum, const struct convergence_tail *tail,
                                                const struct material_pair *pair, bool plastic, double load);

#endif
