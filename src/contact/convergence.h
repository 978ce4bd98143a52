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

/** A parameter and the values that it takes. */
struct convergence_sweep_row {
    const char *name; /* as in convergence.csv */
    size_t count;
    double values[CONVERGENCE_VALUES_MOST];
};
extern const struct convergence_sweep_row convergence_sweeps[CONVERGENCE_SWEEP_COUNT];

/** A law Delta_n = alpha lambda_n^gamma, lambda_n = L/n, under a load P/(A_n E'). */
struct convergence_law {
    double alpha, gamma, length_m, load;
    size_t scales;
};

/** A/A_n after each scale n = 1 ... scales (4.53, closure thesis). */
void convergence_areas(double *area_ratio, const struct convergence_law *law, const struct material_pair *pair,
                       bool plastic, uint64_t *evaluations);

/** Smallest wavelength of a continuum: about an atom's diameter. */
extern const double convergence_atom_m;

/** Continues a measured spectrum below its last known harmonic: Delta = amplitude (lambda/wavelength)^gamma. */
struct convergence_tail {
    double wavelength_m; /* geometric mean of the harmonics fitted */
    double amplitude_m;  /* of the line there */
    double gamma;        /* local slope; NaN: fewer than 3 harmonics, or a filter's flank */
    size_t count;        /* known harmonics */
};

/** Least-squares line of log Delta on log lambda over the shortest half decade of the first `count` harmonics, without
 * those of zero amplitude. A slope above 3 is taken for a filter's. */
struct convergence_tail convergence_tail(const struct spectrum *spectrum, size_t count);
/** Amplitude of the tail at a wavelength [m]. */
double convergence_tail_amplitude(const struct convergence_tail *tail, double wavelength_m);

/** Area with and without the scales below the last known harmonic. */
struct convergence_extension {
    double area_measured; /* A/A_n of the known harmonics */
    double area_extended; /* the same with the tail down to atomic size */
    uint64_t scales;      /* visited */
};

/** Stacks the known harmonics and then the tail at one load (4.1, 4.2; closure thesis), down to atomic size or to the
 * first scale beyond which p* cannot exceed the pressure (gamma >= 1, 4.55). */
struct convergence_extension convergence_extend(const struct spectrum *spectrum, const struct convergence_tail *tail,
                                                const struct material_pair *pair, bool plastic, double load);

#endif
