/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A surface's record as bytes, for a file of this process. Structs go as they lie in memory. */
#ifndef RESULTS_SURFACE_BYTES_H
#define RESULTS_SURFACE_BYTES_H

#include "analysis/surface.h"
#include <stdio.h>
#include <sys/types.h>

/** Writes the arrays that a record has from its description: spectra, heights, scans; false: an error of the file. */
bool surface_bytes_put_arrays(FILE *file, const struct surface_record *record);
/** Writes the rest: what stands in the record itself, how much the arrays hold, curves. */
bool surface_bytes_put_curves(FILE *file, const struct surface_record *record);
/** How much of a record is wanted: a spectrum has millions of numbers, a curve a hundred. */
enum surface_bytes_part {
    SURFACE_BYTES_CURVES,   /* curves, bands, what stands in the record itself; the other arrays are NULL, of count 0 */
    SURFACE_BYTES_SPECTRUM, /* and the spectrum */
    SURFACE_BYTES_ALL
};

/** Reads a part of them back into `out`, which takes `summary` as its own: what surface_bytes_put_curves() wrote, from
 * `curves_at` of the file, then the arrays from `arrays_at`; those that the record has dropped since they were written
 * stay away. Where the file stands does not matter, so that several threads may read at once. False: an error of the
 * file, or no memory. Whatever comes back: surface_record_free(). */
bool surface_bytes_get(struct surface_record *out, int file, off_t curves_at, off_t arrays_at,
                       const struct surface_summary *summary, enum surface_bytes_part part);

#endif
