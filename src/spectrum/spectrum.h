/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From heights to harmonics (docs/equations.md, From scan to spectrum). */
#ifndef SPECTRUM_SPECTRUM_H
#define SPECTRUM_SPECTRUM_H

#include "base/fft.h"
#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>

/** Window on a record before its transform. */
enum spectrum_window {
    SPECTRUM_WINDOW_AUTO, /* none for a record that closes on itself, else Hann: spectrum_window_for() */
    SPECTRUM_WINDOW_NONE,
    SPECTRUM_WINDOW_HANN,
    SPECTRUM_WINDOW_COUNT
};
extern const char *const spectrum_window_names[SPECTRUM_WINDOW_COUNT]; /* as a scene spells them */

/** The window of one record: auto becomes none or Hann. */
enum spectrum_window spectrum_window_for(enum spectrum_window asked, bool periodic);

/** Amplitudes of the harmonics n = 1 ... count of a record of length L = N h. Owned: spectrum_free(). */
struct spectrum {
    double *amplitude_m; /* Delta_n at index n - 1 */
    size_t count;
    double length_m;  /* L: harmonic n has wavelength L/n */
    bool has_nyquist; /* the last harmonic is the Nyquist one: its mean square is Delta², not Delta²/2 */
};

/** Delta_n = 2|Z_n|/N, n = 1 ... ceil(N/2)-1, and |Z_{N/2}|/N at the Nyquist bin of an even N, of `points` >= 3 heights
 * at `spacing_m`, after the mean is removed. The Hann window has the factor sqrt(8/3), which keeps the mean square of
 * many records but not of each: profile.h. Not for AUTO. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code spectrum_compute(struct spectrum *out, const double *height_m, size_t points,
                                             double spacing_m, enum spectrum_window window, struct status *status);

/** The same of the heights in room->record, which are overwritten. */
MUST_CHECK enum status_code spectrum_of_record(struct spectrum *out, struct fft_room *room, size_t points,
                                               double spacing_m, enum spectrum_window window, struct status *status);

/** grid_average() of a record's spectrum without a window. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code spectrum_add_record(struct spectrum *mean, size_t so_far, const double *height_m,
                                                size_t points, double spacing_m, struct status *status);

/** A copy with amplitudes of its own. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code spectrum_copy(struct spectrum *out, const struct spectrum *in, struct status *status);

void spectrum_free(struct spectrum *spectrum);

/** Some harmonics of a spectrum. */
struct spectrum_bin {
    size_t count;
    double wavelength_m; /* their geometric mean */
    double amplitude_m;  /* count amplitude²/2 is their mean square height */
};

/** Index i and the following in the same tenth of a decade, floor(10 log10(i + 1) + 1e-9). */
struct spectrum_bin spectrum_bin_from(const struct spectrum *spectrum, size_t i);
/** Index i alone. */
struct spectrum_bin spectrum_bin_of(const struct spectrum *spectrum, size_t i);

/** f of index i (harmonic i + 1) [1/m]. */
double spectrum_frequency(const struct spectrum *spectrum, size_t i);
/** Mean square height of index i: half the squared amplitude, the whole at the Nyquist bin [m²]. */
double spectrum_power(const struct spectrum *spectrum, size_t i);
/** How many of its longest waves a record holds: its length over the wavelength above which half of the mean square
 * height lies, interpolated between harmonics; 0: flat. */
double spectrum_longest_waves(const struct spectrum *spectrum);
/** How many harmonics describe the surface: those not shorter than shortest_m (0: no limit), up to where the mean
 * square height of all shorter ones falls below q²/6, twice what rounding to steps of q adds; q is step_m, or 1e-4 of
 * the root mean square height if that is more. */
size_t spectrum_known(const struct spectrum *spectrum, double shortest_m, double step_m);
/** Spectral moment m_{2k} = sum (2 pi f)^{2k} power [m^(2-2k)], k = 0, 1, 2. */
double spectrum_moment(const struct spectrum *spectrum, int k);

/* Spectra of records of different lengths and spacings on one grid of wavelengths. */

/** Puts `in` on the harmonics n = 1 ... count of a record of length_m: the power of each harmonic, spread evenly over
 * its frequency band (half a step to either side), goes to the bands of the new ones, so that none is lost or counted
 * twice between them. `out` is owned: spectrum_free(). Error: STATUS_MEMORY. */
MUST_CHECK enum status_code grid_spectrum(struct spectrum *out, const struct spectrum *in, double length_m,
                                          size_t count, struct status *status);

/** Amplitudes add as squares: two rough surfaces in contact. `other` is put on the grid of `sum` first; where it has no
 * harmonics (above its Nyquist frequency, below its first) nothing is added. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code grid_add(struct spectrum *sum, const struct spectrum *other, struct status *status);

/** Adds a spectrum to a mean over `so_far` others, of which 0 begin one: powers averaged harmonic by harmonic. Spectra
 * that differ are first put on the grid of the shorter record and of the lower Nyquist frequency. Error: STATUS_MEMORY.
 */
MUST_CHECK enum status_code grid_average(struct spectrum *mean, const struct spectrum *other, size_t so_far,
                                         struct status *status);
/** The same with geometric means of amplitudes; a harmonic that is 0 in one of them is 0 in the mean. */
MUST_CHECK enum status_code grid_average_logs(struct spectrum *mean, const struct spectrum *other, size_t so_far,
                                              struct status *status);

#endif
