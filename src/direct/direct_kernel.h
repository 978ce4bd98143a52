/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The periodic elastic half space on a grid: convolutions by FFTW's real transforms, in place.
 *
 * A pressure p on the surface of a half space displaces it by u with û(q) = 2 p̂(q)/(E' |q|) (Johnson, Contact
 * Mechanics, 1985, sec. 13.2; Stanley and Kato 1997); the same 1/|q| gives the potential under a current density. The
 * kernel is the continuous one at the grid's wave numbers, q = 2 pi (i/(nx dx), j/(ny dx)): nodal collocation, for
 * which the mean gap of a smooth surface converges faster than with the kernel of a pressed pixel. q = 0 is left out:
 * mean u = 0.
 */
#ifndef DIRECT_KERNEL_H
#define DIRECT_KERNEL_H

#include "base/status.h"
#include <fftw3.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Loops over all points are also compiled for AVX2, chosen when the program starts (not under sanitizers, which start
 * too late). No product is fused with a sum, so that the bytes are the same. */
#if defined __x86_64__ && defined __GLIBC__ && !defined __clang__ && !defined __SANITIZE_ADDRESS__ &&                  \
    !defined __SANITIZE_THREAD__
#define CLONES __attribute__((target_clones("avx2", "default")))
#else
#define CLONES
#endif

/** Points a side of a square: indices fit 31 bits. */
enum { DIRECT_KERNEL_MOST = 32768 };

/** ny rows of nx points, repeated periodically; or (`mirrored`, a square or one row) continued by their mirror images,
 * with a period of two sides. */
struct direct_grid {
    size_t nx, ny;
    double spacing_m; /* dx, the same in both directions */
    bool mirrored;
    bool single; /* transforms in single precision: a third to a half faster, with errors of about 1e-6 of the field */
};

/** Factors of a convolution. */
enum direct_table {
    DIRECT_COMPLIANCE, /* 1/|q| [m], 0 at q = 0 */
    DIRECT_STIFFNESS,  /* |q| [1/m] */
    DIRECT_TABLES
};

/** A grid and one field on it to transform. Of a mirrored grid only the points themselves are stored, a quarter of a
 * period: their cosine transform equals the transform with all images (Makhoul, IEEE Trans. Acoust. Speech Signal
 * Process. 28 (1980) 27). Owned: direct_kernel_free(). */
struct direct_kernel {
    size_t nx, ny;
    size_t points;    /* nx ny */
    size_t stride;    /* values from row to row of `field`: 2 (nx/2 + 1), the last ones unused */
    double spacing_m; /* dx */
    bool mirrored, single;
    double *field;     /* ny x stride */
    void *room;        /* room, plans and tables in the kernel's precision (direct_passes.h) */
    size_t transforms; /* of the field, forth or back, done so far: two a convolution */
    bool exhausted;    /* out of memory: the field and what follows from it are of no use */
};

/** nx >= 2, ny >= 1, the same, 8 or more, of a mirrored grid; with ny = 1 it is a strip, of 4 or more, without strain
 * across. A transform is made of transforms of rows and columns, each column copied to a place of its own and its
 * product transformed back at once: from 512 points a side on that is 1.2 to 1.9 times as fast as FFTW's own plan of
 * two dimensions. Plans are made with FFTW_ESTIMATE: the same plan, hence the same bytes, in every thread and run,
 * within 1 ms (FFTW_MEASURE would take 0.2 to 2 s and choose by the clock). Any thread may call this at any time.
 * Errors: STATUS_MEMORY; STATUS_USAGE: a grid too large or too small, a spacing that is no length. */
MUST_CHECK enum status_code direct_kernel_make(struct direct_kernel *out, const struct direct_grid *grid,
                                               struct status *status);
void direct_kernel_free(struct direct_kernel *kernel);

/** Multiplies the transform of `field` by the table; stiffness is the inverse of compliance for a field of mean 0.
 * `wanted`: one flag a row, NULL: all rows; other rows hold nothing of use afterwards. Rows of zeros and those not
 * wanted cost nothing. */
void direct_kernel_convolve(struct direct_kernel *kernel, enum direct_table table, const uint8_t *wanted);

/** The same of another field of its shape, which is kept. */
void direct_kernel_convolve_of(struct direct_kernel *kernel, const double *from, enum direct_table table);

/** <f, table f> by Parseval's theorem, for half a convolution; `field` f is overwritten. */
double direct_kernel_energy(struct direct_kernel *kernel, enum direct_table table);

#endif
