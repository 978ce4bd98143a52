/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_kernel.h"

#include "base/fft.h"
#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum {
    BLOCK = 8, /* columns copied together: two cache lines a row */
    GAP = 4    /* values between them, so that they do not share a place of the cache */
};

/** Place of the k-th of n values in the transform of a mirrored line: first every second value, then the others
 * backwards. */
static size_t place(size_t k, size_t n)
{
    return 2 * k < n ? 2 * k : 2 * (n - k) - 1;
}

/** Complex numbers that hold a row of n points; of a few, one each, as lanes are longer than half of them. */
static size_t numbers_of(size_t n)
{
    return n % 2 || n < 8 ? n : n / 2;
}

/** How often a column of the stored half stands in the whole transform. */
static double times(const struct direct_kernel *kernel, size_t i)
{
    return i == 0 || 2 * i == kernel->nx ? 1 : 2;
}

/** A convolution, or (`filter` false) half of one for the energy. */
struct pass {
    struct direct_kernel *kernel;
    const double *from; /* shaped as its field */
    enum direct_table table;
    const uint8_t *wanted;
    bool filter;
    double energy;
};

#define INLINE static inline __attribute__((always_inline))

#define REAL      double
#define OF(name)  name##_double
#define FFT(name) fftw_##name
#define LANES     4
#define SWAPPED   1, 0, 3, 2
#define REVERSED  2, 3, 0, 1
#define BACKWARDS 3, 2, 1, 0
#define TWICE     0, 0, 1, 1
#include "direct/direct_passes.h"

#define REAL      float
#define OF(name)  name##_single
#define FFT(name) fftwf_##name
#define LANES     8
#define SWAPPED   1, 0, 3, 2, 5, 4, 7, 6
#define REVERSED  6, 7, 4, 5, 2, 3, 0, 1
#define BACKWARDS 7, 6, 5, 4, 3, 2, 1, 0
#define TWICE     0, 0, 1, 1, 2, 2, 3, 3
#include "direct/direct_passes.h"

enum status_code direct_kernel_make(struct direct_kernel *out, const struct direct_grid *grid, struct status *status)
{
    const size_t nx = grid->nx, ny = grid->ny;
    const double spacing_m = grid->spacing_m;
    *out = (struct direct_kernel){.nx = nx,
                                  .ny = ny,
                                  .points = nx * ny,
                                  .spacing_m = spacing_m,
                                  .mirrored = grid->mirrored,
                                  .single = grid->single};
    assert(!grid->mirrored || (nx == ny && nx >= BLOCK));
    assert(ny > 1 || nx >= 4);
    out->stride = 2 * (nx / 2 + 1);
    size_t most = (size_t)DIRECT_KERNEL_MOST * DIRECT_KERNEL_MOST;
    if (nx < 2 || ny < 1 || nx > most / ny)
        return status_fail(status, STATUS_USAGE,
                           "a grid of %zu x %zu points cannot be solved; take at least 2, and at most %d x %d", nx, ny,
                           DIRECT_KERNEL_MOST, DIRECT_KERNEL_MOST);
    if (!(spacing_m > 0) || !isfinite(spacing_m))
        return status_fail(status, STATUS_USAGE, "a spacing of %g m cannot be; give a positive length", spacing_m);
    out->field = fftw_alloc_real(ny * out->stride);
    if (out->field && (out->single ? make_single(out) : make_double(out)))
        return STATUS_OK;
    direct_kernel_free(out);
    return status_memory(status);
}

void direct_kernel_free(struct direct_kernel *kernel)
{
    if (kernel->single)
        free_single(kernel);
    else
        free_double(kernel);
    fftw_free(kernel->field);
    *kernel = (struct direct_kernel){0};
}

static void make_pass(struct pass *pass)
{
    if (pass->kernel->single)
        pass_single(pass);
    else
        pass_double(pass);
}

void direct_kernel_convolve(struct direct_kernel *kernel, enum direct_table table, const uint8_t *wanted)
{
    make_pass(&(struct pass){kernel, kernel->field, table, wanted, true, 0});
}

void direct_kernel_convolve_of(struct direct_kernel *kernel, const double *from, enum direct_table table)
{
    make_pass(&(struct pass){kernel, from, table, NULL, true, 0});
}

double direct_kernel_energy(struct direct_kernel *kernel, enum direct_table table)
{
    struct pass pass = {kernel, kernel->field, table, NULL, false, 0};
    make_pass(&pass);
    return pass.energy;
}
