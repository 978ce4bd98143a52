/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_kernel.h"

#include "base/fft.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    BLOCK = 8, /* columns copied out together: two lines of cache a row */
    GAP = 4    /* values between them, lest all begin at the same place of the cache */
};

/** Both tables, the 1/points of an unnormalised pair of transforms included. */
static void fill_tables(struct direct_kernel *kernel)
{
    size_t rows = kernel->ny / 2 + 1, columns = kernel->nx / 2 + 1;
    double fx = 2 * M_PI / ((double)kernel->nx * kernel->spacing_m), n = (double)kernel->points;
    double fy = 2 * M_PI / ((double)kernel->ny * kernel->spacing_m);
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
    size_t quarter = (out->nx / 2 + 1) * (out->ny / 2 + 1);
    out->field = fftw_alloc_real(out->ny * out->stride);
    out->row = fftw_alloc_complex(out->nx / 2 + 1);
    out->columns = fftw_alloc_complex(BLOCK * (out->ny + GAP));
    out->transformed = fftw_alloc_complex(out->ny);
    out->compliance = malloc(quarter * sizeof(double));
    out->stiffness = malloc(quarter * sizeof(double));
    if (!out->field || !out->row || !out->columns || !out->transformed || !out->compliance || !out->stiffness ||
        !fft_plan(make_plans, out))
        (void)status_memory(status);
    if (status->code != STATUS_OK)
        direct_kernel_free(out);
    else
        fill_tables(out);
    return status->code;
}

enum status_code direct_kernel_make(struct direct_kernel *out, size_t nx, size_t ny, double spacing_m,
                                    struct status *status)
{
    *out = (struct direct_kernel){.nx = nx, .ny = ny, .points = nx * ny, .spacing_m = spacing_m};
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
    fftw_free(kernel->row);
    fftw_free(kernel->columns);
    fftw_free(kernel->transformed);
    free(kernel->compliance);
    free(kernel->stiffness);
    *kernel = (struct direct_kernel){0};
}

/** Transforms the rows to where they are. */
static void transform_rows(struct direct_kernel *kernel)
{
    for (size_t j = 0; j < kernel->ny; j++) {
        double *row = kernel->field + j * kernel->stride;
        fftw_execute_dft_r2c(kernel->row_forward, row, kernel->row);
        memcpy(row, kernel->row, kernel->stride * sizeof *row);
    }
}

static void transform_rows_back(struct direct_kernel *kernel)
{
    for (size_t j = 0; j < kernel->ny; j++) {
        double *row = kernel->field + j * kernel->stride;
        memcpy(kernel->row, row, kernel->stride * sizeof *row);
        fftw_execute_dft_c2r(kernel->row_backward, kernel->row, row);
    }
}

/** One column forth, times `factor` of |j|, and back. */
static void filter_column(struct direct_kernel *kernel, fftw_complex *column, const double *factor)
{
    fftw_complex *transformed = kernel->transformed;
    size_t ny = kernel->ny;
    fftw_execute_dft(kernel->column_forward, column, transformed);
    for (size_t j = 0; j < ny; j++) {
        double f = factor[j <= ny / 2 ? j : ny - j];
        transformed[j][0] *= f;
        transformed[j][1] *= f;
    }
    fftw_execute_dft(kernel->column_backward, transformed, column);
}

/** All columns, some at a time. */
static void filter_columns(struct direct_kernel *kernel, const double *table)
{
    size_t count = kernel->nx / 2 + 1, length = kernel->ny + GAP, rows = kernel->ny / 2 + 1;
    for (size_t first = 0; first < count; first += BLOCK) {
        size_t width = count - first < BLOCK ? count - first : BLOCK;
        fftw_complex *columns = kernel->columns;
        for (size_t j = 0; j < kernel->ny; j++) {
            const double *from = kernel->field + j * kernel->stride + 2 * first;
            for (size_t i = 0; i < width; i++)
                memcpy(columns[i * length + j], from + 2 * i, sizeof *columns);
        }
        for (size_t i = 0; i < width; i++)
            filter_column(kernel, columns + i * length, table + (first + i) * rows);
        for (size_t j = 0; j < kernel->ny; j++) {
            double *to = kernel->field + j * kernel->stride + 2 * first;
            for (size_t i = 0; i < width; i++)
                memcpy(to + 2 * i, columns[i * length + j], sizeof *columns);
        }
    }
}

/** Of a strip: no columns. */
static void filter_row(struct direct_kernel *kernel, const double *table)
{
    fftw_execute_dft_r2c(kernel->row_forward, kernel->field, kernel->row);
    for (size_t i = 0; i <= kernel->nx / 2; i++) {
        kernel->row[i][0] *= table[i];
        kernel->row[i][1] *= table[i];
    }
    fftw_execute_dft_c2r(kernel->row_backward, kernel->row, kernel->field);
}

static void filter(void *context)
{
    struct direct_kernel *kernel = context;
    if (kernel->ny == 1) {
        filter_row(kernel, kernel->table);
        return;
    }
    transform_rows(kernel);
    filter_columns(kernel, kernel->table);
    transform_rows_back(kernel);
}

void direct_kernel_convolve(struct direct_kernel *kernel, const double *table)
{
    kernel->convolutions++;
    kernel->table = table;
    kernel->exhausted |= !fft_try(filter, kernel);
}
