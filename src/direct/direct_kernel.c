/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_kernel.h"

#include "base/fft.h"
#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum {
    BLOCK = 8, /* columns copied out together: two lines of cache a row */
    GAP = 4    /* values between them, lest all begin at the same place of the cache */
};

/** Waves along a side of n points of what repeats, with the mean. */
static size_t waves(const struct direct_kernel *kernel, size_t n)
{
    return kernel->mirrored ? n + 1 : n / 2 + 1;
}

/** Both tables, the 1/points of an unnormalised pair of transforms included. */
static void fill_tables(struct direct_kernel *kernel)
{
    size_t rows = waves(kernel, kernel->ny), columns = waves(kernel, kernel->nx);
    double longest = (kernel->mirrored ? 2 : 1) * kernel->spacing_m, n = (double)kernel->points;
    double fx = 2 * M_PI / ((double)kernel->nx * longest), fy = 2 * M_PI / ((double)kernel->ny * longest);
    for (size_t k = 0; kernel->mirrored && k < 2 * kernel->nx; k++) {
        kernel->turn[k][0] = cos(M_PI * (double)k / (2 * (double)kernel->nx));
        kernel->turn[k][1] = -sin(M_PI * (double)k / (2 * (double)kernel->nx));
    }
    for (size_t i = 0; i < columns; i++)
        for (size_t j = 0; j < rows; j++) {
            double q = hypot(fx * (double)i, fy * (double)j);
            kernel->compliance[i * rows + j] = q > 0 ? 1 / (q * n) : 0;
            kernel->stiffness[i * rows + j] = q / n;
        }
}

static void make_plans(void *context)
{
    struct direct_kernel *kernel = context;
    int nx = (int)kernel->nx, ny = (int)kernel->ny;
    kernel->row_forward = fftw_plan_dft_r2c_1d(nx, kernel->field, kernel->row, FFTW_ESTIMATE);
    kernel->row_backward = fftw_plan_dft_c2r_1d(nx, kernel->row, kernel->field, FFTW_ESTIMATE);
    kernel->column_forward = fftw_plan_dft_1d(ny, kernel->columns, kernel->transformed, FFTW_FORWARD, FFTW_ESTIMATE);
    kernel->column_backward = fftw_plan_dft_1d(ny, kernel->transformed, kernel->columns, FFTW_BACKWARD, FFTW_ESTIMATE);
}

/** Room, plans and tables. */
static enum status_code make(struct direct_kernel *out, struct status *status)
{
    size_t quarter = waves(out, out->nx) * waves(out, out->ny);
    out->field = fftw_alloc_real(out->ny * out->stride);
    out->line = out->mirrored ? fftw_alloc_real(out->stride) : NULL;
    out->turn = out->mirrored ? fftw_alloc_complex(2 * out->nx) : NULL;
    out->row = fftw_alloc_complex(out->nx / 2 + 1);
    out->columns = fftw_alloc_complex(BLOCK * (out->ny + GAP));
    out->transformed = fftw_alloc_complex(out->ny);
    out->compliance = malloc(quarter * sizeof(double));
    out->stiffness = malloc(quarter * sizeof(double));
    if (!out->field || !out->row || !out->columns || !out->transformed || !out->compliance || !out->stiffness ||
        (out->mirrored && (!out->line || !out->turn)))
        (void)status_memory(status);
    if (status->code != STATUS_OK) {
        direct_kernel_free(out);
    } else {
        fft_plan(make_plans, out);
        fill_tables(out);
    }
    return status->code;
}

enum status_code direct_kernel_make(struct direct_kernel *out, const struct direct_grid *grid, struct status *status)
{
    const size_t nx = grid->nx, ny = grid->ny;
    const double spacing_m = grid->spacing_m;
    *out = (struct direct_kernel){
        .nx = nx, .ny = ny, .points = nx * ny, .spacing_m = spacing_m, .mirrored = grid->mirrored};
    assert(!grid->mirrored || nx == ny);
    out->stride = 2 * (nx / 2 + 1);
    size_t most = (size_t)DIRECT_KERNEL_MOST * DIRECT_KERNEL_MOST;
    if (nx < 2 || ny < 1 || nx > most / ny)
        return status_fail(status, STATUS_USAGE,
                           "a grid of %zu x %zu points cannot be solved; take at least 2, and at most %d x %d", nx, ny,
                           DIRECT_KERNEL_MOST, DIRECT_KERNEL_MOST);
    if (!(spacing_m > 0) || !isfinite(spacing_m))
        return status_fail(status, STATUS_USAGE, "a spacing of %g m cannot be; give a positive length", spacing_m);
    return make(out, status);
}

void direct_kernel_free(struct direct_kernel *kernel)
{
    fft_plan_free(kernel->row_forward);
    fft_plan_free(kernel->row_backward);
    fft_plan_free(kernel->column_forward);
    fft_plan_free(kernel->column_backward);
    fftw_free(kernel->field);
    fftw_free(kernel->line);
    fftw_free(kernel->turn);
    fftw_free(kernel->row);
    fftw_free(kernel->columns);
    fftw_free(kernel->transformed);
    free(kernel->compliance);
    free(kernel->stiffness);
    *kernel = (struct direct_kernel){0};
}

/** Where the k-th of n values stands that a mirrored line's transform takes: first every second one, then the others
 * from the end on. */
static size_t place(size_t k, size_t n)
{
    return 2 * k < n ? 2 * k : 2 * (n - k) - 1;
}

/** Transforms the rows to where they are. */
static void transform_rows(struct direct_kernel *kernel)
{
    size_t stride = kernel->stride;
    for (size_t j = 0; j < kernel->ny; j++) {
        double *row = kernel->field + j * stride;
        if (row[0] == 0 && memcmp(row, row + 1, (stride - 1) * sizeof *row) == 0)
            continue; /* all of it is 0, and so is its transform */
        for (size_t i = 0, n = kernel->nx; kernel->mirrored && i < n / 2; i++) {
            kernel->line[i] = row[2 * i];
            kernel->line[n - 1 - i] = row[2 * i + 1];
        }
        if (kernel->mirrored && kernel->nx % 2)
            kernel->line[kernel->nx / 2] = row[kernel->nx - 1];
        fftw_execute_dft_r2c(kernel->row_forward, kernel->mirrored ? kernel->line : row, kernel->row);
        memcpy(row, kernel->row, stride * sizeof *row);
    }
    kernel->transforms++;
}

/** Those wanted; NULL: all. */
static void transform_rows_back(struct direct_kernel *kernel, const uint8_t *wanted)
{
    for (size_t j = 0; j < kernel->ny; j++) {
        double *row = kernel->field + j * kernel->stride;
        if (wanted && !wanted[j])
            continue;
        memcpy(kernel->row, row, kernel->stride * sizeof *row);
        fftw_execute_dft_c2r(kernel->row_backward, kernel->row, kernel->mirrored ? kernel->line : row);
        for (size_t i = 0, n = kernel->nx; kernel->mirrored && i < n / 2; i++) {
            row[2 * i] = kernel->line[i];
            row[2 * i + 1] = kernel->line[n - 1 - i];
        }
        if (kernel->mirrored && kernel->nx % 2)
            row[kernel->nx - 1] = kernel->line[kernel->nx / 2];
    }
    kernel->transforms++;
}

/** How often a column of the transform, which has but half of them, stands in the whole one. */
static double times(const struct direct_kernel *kernel, size_t i)
{
    return i == 0 || 2 * i == kernel->nx ? 1 : 2;
}

/** A transformed column times `factor` of |j|. */
static void multiply(fftw_complex *transformed, const double *factor, size_t ny)
{
    for (size_t j = 0; j < ny; j++) {
        double f = factor[j <= ny / 2 ? j : ny - j];
        transformed[j][0] *= f;
        transformed[j][1] *= f;
    }
}

static double square(const fftw_complex value)
{
    return value[0] * value[0] + value[1] * value[1];
}

/** <f, factor f> of a transformed column. */
static double energy_of(fftw_complex *transformed, const double *factor, size_t ny)
{
    double part[4] = {0};
    for (size_t j = 0; j < ny; j += 4)
        for (size_t i = 0; i < 4 && j + i < ny; i++)
            part[i] += factor[j + i <= ny / 2 ? j + i : ny - j - i] * square(transformed[j + i]);
    return (part[0] + part[1]) + (part[2] + part[3]);
}

static void turn(double out[2], const fftw_complex value, const fftw_complex by, double sign)
{
    out[0] = value[0] * by[0] - sign * value[1] * by[1];
    out[1] = sign * value[0] * by[1] + value[1] * by[0];
}

/* Four places at a time, by AVX2 where there is a choice to be made when the program starts, which sanitizers come too
 * late for. No product is fused with a sum: the bytes are the same without. */
#if defined __x86_64__ && defined __GLIBC__ && !defined __clang__ && !defined __SANITIZE_ADDRESS__ &&                  \
    !defined __SANITIZE_THREAD__
#define CLONES __attribute__((target_clones("avx2", "default")))
#else
#define CLONES
#endif
#define INLINE  static inline __attribute__((always_inline))
#define SHUFFLE __builtin_shufflevector
enum { LANES = 4 };
typedef double lanes __attribute__((vector_size(32), aligned(8), may_alias));

/** Real and imaginary parts at the places from k on, or (`down`) from k back. */
INLINE void take(lanes out[2], const fftw_complex *k, bool down)
{
    const lanes *at = (const lanes *)(k - (down ? LANES - 1 : 0));
    out[0] = down ? SHUFFLE(at[0], at[1], 6, 4, 2, 0) : SHUFFLE(at[0], at[1], 0, 2, 4, 6);
    out[1] = down ? SHUFFLE(at[0], at[1], 7, 5, 3, 1) : SHUFFLE(at[0], at[1], 1, 3, 5, 7);
}

INLINE void put(fftw_complex *k, const lanes in[2], bool down)
{
    lanes *at = (lanes *)(k - (down ? LANES - 1 : 0));
    at[0] = down ? SHUFFLE(in[0], in[1], 3, 7, 2, 6) : SHUFFLE(in[0], in[1], 0, 4, 1, 5);
    at[1] = down ? SHUFFLE(in[0], in[1], 1, 5, 0, 4) : SHUFFLE(in[0], in[1], 2, 6, 3, 7);
}

INLINE void take_real(lanes *out, const double *k, bool down)
{
    const lanes *at = (const lanes *)(k - (down ? LANES - 1 : 0));
    *out = down ? SHUFFLE(*at, *at, 3, 2, 1, 0) : SHUFFLE(*at, *at, 0, 1, 2, 3);
}

/** turn() of four. */
INLINE void turn_lanes(lanes out[2], const lanes value[2], const lanes by[2], double sign)
{
    out[0] = value[0] * by[0] - sign * value[1] * by[1];
    out[1] = sign * value[0] * by[1] + value[1] * by[0];
}

/** mirrored_place() of j ... j + 3, and of n - j ... n - j - 3, which are none of them. */
INLINE void mirrored_lanes(lanes *energy, const struct direct_kernel *kernel, size_t i, size_t j, const double *near,
                           const double *far, bool filter)
{
    const size_t n = kernel->ny;
    lanes at[2], other[2], by[2], back[2], a[2], b[2], factor[4];
    take(at, kernel->transformed + j, false);
    take(other, kernel->transformed + n - j, true);
    take(by, kernel->turn + i + j, false);
    take(back, kernel->turn + i + n - j, true);
    turn_lanes(a, at, by, 1);
    turn_lanes(b, other, back, 1);
    take_real(&factor[0], near + j, false);
    take_real(&factor[1], far + n - j, true);
    take_real(&factor[2], near + n - j, true);
    take_real(&factor[3], far + j, false);
    lanes c[4] = {a[0] - b[1], -a[0] - b[1], b[0] - a[1], -b[0] - a[1]};
    for (int k = 0; k < 4; k++) {
        *energy += filter ? 0 * c[k] : factor[k] * c[k] * c[k];
        c[k] *= factor[k] / 2;
    }
    if (!filter)
        return;
    const lanes turned[2][2] = {{c[0] - c[1], -c[2] - c[3]}, {c[2] - c[3], -c[0] - c[1]}};
    turn_lanes(at, turned[0], by, -1);
    turn_lanes(other, turned[1], back, -1);
    put(kernel->transformed + j, at, false);
    put(kernel->transformed + n - j, other, true);
}

/** Place j of column i of a mirrored grid, and n - j, which hold four of its cosines: with c(i, j) half of one, turned
 * value j is (c(i, j) - c(n - i, n - j) - i c(n - i, j) - i c(i, n - j))/2, that at n - j alike. Each times its own
 * factor, or (`filter` false) their energy. */
static double mirrored_place(const struct direct_kernel *kernel, size_t i, size_t j, const double *near,
                             const double *far, bool filter)
{
    const size_t n = kernel->ny;
    fftw_complex *at = &kernel->transformed[j], *other = &kernel->transformed[j > 0 ? n - j : 0];
    double a[2], b[2], energy = 0;
    turn(a, *at, kernel->turn[i + j], 1);
    turn(b, *other, kernel->turn[i + n - j], 1);
    double c[4] = {a[0] - b[1], -a[0] - b[1], b[0] - a[1], -b[0] - a[1]};
    const double factor[4] = {near[j], far[n - j], near[n - j], far[j]};
    for (int k = 0; k < 4; k++) {
        energy += factor[k] * c[k] * c[k];
        c[k] *= factor[k] / 2;
    }
    if (filter) {
        turn(*at, (double[2]){c[0] - c[1], -c[2] - c[3]}, kernel->turn[i + j], -1);
        turn(*other, (double[2]){c[2] - c[3], -c[0] - c[1]}, kernel->turn[i + n - j], -1);
    }
    return energy;
}

/** All places of the column. */
CLONES static double mirrored_column(const struct direct_kernel *kernel, size_t i, const double *table, bool filter)
{
    const size_t n = kernel->ny, rows = n + 1;
    const double *near = table + i * rows, *far = table + (n - i) * rows;
    double energy = mirrored_place(kernel, i, 0, near, far, filter) / 2;
    lanes sums = {0};
    size_t j = 1;
    if (filter)
        for (; 2 * (j + LANES) <= n + 1; j += LANES)
            mirrored_lanes(&sums, kernel, i, j, near, far, true);
    else
        for (; 2 * (j + LANES) <= n + 1; j += LANES)
            mirrored_lanes(&sums, kernel, i, j, near, far, false);
    energy += (sums[0] + sums[1]) + (sums[2] + sums[3]);
    for (; 2 * j <= n; j++)
        energy += mirrored_place(kernel, i, j, near, far, filter) / (2 * j == n ? 2 : 1);
    return i == 0 || 2 * i == n ? energy / 2 : energy;
}

/** `width` columns out, from the first one on; or back. */
static inline void copy(struct direct_kernel *kernel, size_t first, size_t width, bool back)
{
    for (size_t j = 0; j < kernel->ny; j++) {
        double *row = kernel->field + (kernel->mirrored ? place(j, kernel->ny) : j) * kernel->stride + 2 * first;
        double *out = kernel->columns[j];
        for (size_t i = 0; i < width; i++)
            if (back)
                memcpy(row + 2 * i, out + 2 * i * (kernel->ny + GAP), sizeof(fftw_complex));
            else
                memcpy(out + 2 * i * (kernel->ny + GAP), row + 2 * i, sizeof(fftw_complex));
    }
}

/** A width that the compiler knows is faster. */
static void copy_columns(struct direct_kernel *kernel, size_t first, size_t width, bool back)
{
    if (width == BLOCK)
        copy(kernel, first, BLOCK, back);
    else
        copy(kernel, first, width, back);
}

/** A convolution, or (`filter` false) half of one for its energy. */
struct pass {
    struct direct_kernel *kernel;
    const double *table;
    const uint8_t *wanted;
    bool filter;
    double energy;
};

/** All columns, some at a time: forth, times the table, and back; or only their energy. */
static void pass_columns(struct pass *pass)
{
    struct direct_kernel *kernel = pass->kernel;
    size_t count = kernel->nx / 2 + 1, length = kernel->ny + GAP, rows = waves(kernel, kernel->ny);
    fftw_complex *columns = kernel->columns, *transformed = kernel->transformed;
    for (size_t first = 0; first < count; first += BLOCK) {
        size_t width = count - first < BLOCK ? count - first : BLOCK;
        copy_columns(kernel, first, width, false);
        for (size_t i = 0; i < width; i++) {
            const double *factor = pass->table + (first + i) * rows;
            fftw_execute_dft(kernel->column_forward, columns + i * length, transformed);
            if (kernel->mirrored)
                pass->energy += mirrored_column(kernel, first + i, pass->table, pass->filter);
            else if (pass->filter)
                multiply(transformed, factor, kernel->ny);
            if (pass->filter)
                fftw_execute_dft(kernel->column_backward, transformed, columns + i * length);
            else if (!kernel->mirrored)
                pass->energy += times(kernel, first + i) * energy_of(transformed, factor, kernel->ny);
        }
        if (pass->filter)
            copy_columns(kernel, first, width, true);
    }
}

/** The same of a strip, which has no columns, from its field to its field. */
static void pass_row(struct pass *pass)
{
    struct direct_kernel *kernel = pass->kernel;
    fftw_execute_dft_r2c(kernel->row_forward, kernel->field, kernel->row);
    kernel->transforms += pass->filter ? 2 : 1;
    for (size_t i = 0; i <= kernel->nx / 2; i++)
        if (pass->filter) {
            kernel->row[i][0] *= pass->table[i];
            kernel->row[i][1] *= pass->table[i];
        } else
            pass->energy += times(kernel, i) * pass->table[i] * square(kernel->row[i]);
    if (pass->filter)
        fftw_execute_dft_c2r(kernel->row_backward, kernel->row, kernel->field);
}

static void make_pass(struct pass *pass)
{
    if (pass->kernel->ny == 1) {
        pass_row(pass);
        return;
    }
    transform_rows(pass->kernel);
    pass_columns(pass);
    if (pass->filter)
        transform_rows_back(pass->kernel, pass->wanted);
}

void direct_kernel_convolve(struct direct_kernel *kernel, const double *table, const uint8_t *wanted)
{
    make_pass(&(struct pass){kernel, table, wanted, true, 0});
}

double direct_kernel_energy(struct direct_kernel *kernel, const double *table)
{
    struct pass pass = {kernel, table, NULL, false, 0};
    make_pass(&pass);
    return pass.energy;
}
