/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct_support.h"

static const struct direct_grid shapes[] = {
    {64, 64, 0.1, false, false}, {20, 18, 0.1, false, false}, {15, 9, 0.1, false, false}, {17, 40, 0.1, false, false},
    {2, 2, 0.1, false, false},   {96, 1, 0.1, false, false},  {35, 1, 0.1, false, false}, {24, 24, 0.1, true, false},
    {15, 15, 0.1, true, false},  {8, 8, 0.1, true, false},
};

enum { SHAPES = sizeof shapes / sizeof *shapes };

static struct direct_kernel kernel_of(size_t shape)
{
    struct direct_kernel kernel;
    expect_ok(direct_kernel_make, &kernel, &shapes[shape]);
    return kernel;
}

/** Some value, 0 at the first, at each point of every `step`-th row, `rest` in the others. */
static double value_at(size_t i, size_t j, size_t step, double rest)
{
    return j % step == 0 ? sin(3.7 * (double)i + 1.3 * (double)(i * j)) : rest;
}

static void lay(struct direct_kernel *kernel, size_t step, double rest)
{
    memset(kernel->field, 0, kernel->ny * kernel->stride * sizeof(double));
    for (size_t j = 0; j < kernel->ny; j++)
        for (size_t i = 0; i < kernel->nx; i++)
            kernel->field[j * kernel->stride + i] = value_at(i, j, step, rest);
}

/** A wave comes out as itself, times 1/|q| or |q|; of a strip also those of all sizes. */
TEST_CASE(waves)
{
    struct direct_grid grids[SHAPES + 40];
    size_t count = 0;
    for (size_t shape = 0; shape < SHAPES; shape++)
        if (!shapes[shape].mirrored)
            grids[count++] = shapes[shape];
    for (size_t n = 4; n < 40; n++)
        grids[count++] = (struct direct_grid){n, 1, 0.1, false, false};
    for (size_t g = 0; g < count; g++) {
        const size_t nx = grids[g].nx, ny = grids[g].ny;
        struct direct_kernel kernel;
        expect_ok(direct_kernel_make, &kernel, &grids[g]);
        for (size_t wave = 0; wave < nx * ny; wave++) {
            const double i = (double)(wave % nx) / (double)nx, j = (double)(wave / nx) / (double)ny;
            const double q = 2 * M_PI / 0.1 * hypot(fmin(i, 1 - i), fmin(j, 1 - j));
            for (enum direct_table table = 0; table < DIRECT_TABLES; table++) {
                const double factor = table == DIRECT_STIFFNESS ? q : q > 0 ? 1 / q : 0;
                for (int step = 0; step < 2; step++) { /* laid, then compared */
                    for (size_t k = 0; k < nx * ny; k++) {
                        double *at = &kernel.field[k / nx * kernel.stride + k % nx];
                        const double phase = i * (double)(k % nx) + j * (double)(k / nx);
                        const double value = 1 + cos(2 * M_PI * phase + 0.3);
                        if (step == 0)
                            *at = value;
                        else
                            assert_within(*at, (wave > 0 ? value - 1 : 0) * factor,
                                          table == DIRECT_STIFFNESS ? 1e-10 : 1e-12);
                    }
                    if (step == 0)
                        direct_kernel_convolve(&kernel, table, NULL);
                }
            }
        }
        direct_kernel_free(&kernel);
    }
}

/** <f, K f> is what the field times its convolution sums up to, for one transform instead of two. */
TEST_CASE(energy_by_parseval)
{
    for (size_t shape = 0; shape < SHAPES; shape++)
        for (size_t step = 1; step < 4; step++) {
            struct direct_kernel kernel = kernel_of(shape);
            for (enum direct_table table = 0; table < DIRECT_TABLES; table++) {
                size_t before = kernel.transforms;
                double product = 0;
                lay(&kernel, step, 0);
                double energy = direct_kernel_energy(&kernel, table);
                assert_int_equal(kernel.transforms - before, 1);
                lay(&kernel, step, 0);
                direct_kernel_convolve(&kernel, table, NULL);
                assert_int_equal(kernel.transforms - before, 3);
                for (size_t j = 0; j < kernel.ny; j++)
                    for (size_t i = 0; i < kernel.nx; i++)
                        product += kernel.field[j * kernel.stride + i] * value_at(i, j, step, 0);
                assert_near(energy, product, 1e-12);
                assert_true(energy > 0);
            }
            direct_kernel_free(&kernel);
        }
}

/** Rows of zeros are passed over: what comes out is what next to nothing there gives. Rows that are not wanted do not
 * change those that are. */
TEST_CASE(rows_left_out)
{
    for (size_t shape = 0; shape < SHAPES; shape++) {
        struct direct_kernel kernels[3] = {kernel_of(shape), kernel_of(shape), kernel_of(shape)};
        size_t nx = kernels[0].nx, ny = kernels[0].ny, stride = kernels[0].stride;
        uint8_t wanted[64];
        for (size_t j = 0; j < ny; j++)
            wanted[j] = j % 3 == 0;
        lay(&kernels[0], 3, 0);
        lay(&kernels[1], 3, 0);
        lay(&kernels[2], 3, 1e-200);
        direct_kernel_convolve(&kernels[0], DIRECT_COMPLIANCE, NULL);
        direct_kernel_convolve(&kernels[1], DIRECT_COMPLIANCE, wanted);
        direct_kernel_convolve(&kernels[2], DIRECT_COMPLIANCE, NULL);
        for (size_t j = 0; j < ny; j++)
            for (size_t i = 0; i < nx; i++) {
                double found = kernels[0].field[j * stride + i];
                assert_within(found, kernels[2].field[j * stride + i], 1e-14);
                assert_true(!wanted[j] || found == kernels[1].field[j * stride + i]);
            }
        for (size_t k = 0; k < 3; k++)
            direct_kernel_free(&kernels[k]);
    }
}

/** Where point k of what a mirrored side of n points repeats has its value from. */
static size_t image(size_t k, size_t n)
{
    return k < n ? k : 2 * n - 1 - k;
}

/** A mirrored grid gives what the grid of all its images gives. */
TEST_CASE(mirror_images)
{
    for (size_t shape = 0; shape < SHAPES; shape++) {
        const size_t n = shapes[shape].nx;
        struct direct_kernel kernel, whole;
        if (!shapes[shape].mirrored)
            continue;
        for (enum direct_table table = 0; table < DIRECT_TABLES; table++) {
            kernel = kernel_of(shape);
            expect_ok(direct_kernel_make, &whole, &(struct direct_grid){2 * n, 2 * n, 0.1, false, false});
            lay(&kernel, 1, 0);
            for (size_t k = 0; k < 4 * n * n; k++)
                whole.field[k / (2 * n) * whole.stride + k % (2 * n)] =
                    value_at(image(k % (2 * n), n), image(k / (2 * n), n), 1, 0);
            direct_kernel_convolve(&kernel, table, NULL);
            direct_kernel_convolve(&whole, table, NULL);
            for (size_t k = 0; k < n * n; k++)
                assert_near(kernel.field[k / n * kernel.stride + k % n], whole.field[k / n * whole.stride + k % n],
                            1e-12);
            direct_kernel_free(&kernel);
            direct_kernel_free(&whole);
        }
    }
}

/** Single precision is good to a millionth of a field's size, in any unit of length. */
TEST_CASE(single_precision)
{
    for (size_t shape = 0; shape < SHAPES; shape++)
        for (double spacing_m = 1e-30; spacing_m < 1e31; spacing_m *= 1e30)
            for (enum direct_table table = 0; table < DIRECT_TABLES; table++) {
                struct direct_grid grid = shapes[shape];
                struct direct_kernel whole, single;
                double size = table == DIRECT_STIFFNESS ? spacing_m : 1, most = 0;
                grid.spacing_m = spacing_m;
                expect_ok(direct_kernel_make, &whole, &grid);
                grid.single = true;
                expect_ok(direct_kernel_make, &single, &grid);
                lay(&whole, 1, 0);
                for (size_t k = 0; k < grid.ny * whole.stride; k++)
                    single.field[k] = whole.field[k] *= size;
                direct_kernel_convolve(&whole, table, NULL);
                direct_kernel_convolve(&single, table, NULL);
                for (size_t k = 0; k < grid.nx * grid.ny; k++)
                    most = fmax(most, fabs(whole.field[k / grid.nx * whole.stride + k % grid.nx]));
                for (size_t k = 0; k < grid.nx * grid.ny; k++) {
                    size_t at = k / grid.nx * whole.stride + k % grid.nx;
                    assert_within(single.field[at] / most, whole.field[at] / most, 1e-6);
                }
                lay(&whole, 1, 0);
                for (size_t k = 0; k < grid.ny * whole.stride; k++)
                    single.field[k] = whole.field[k] *= size;
                assert_near(direct_kernel_energy(&single, table), direct_kernel_energy(&whole, table), 1e-6);
                direct_kernel_free(&whole);
                direct_kernel_free(&single);
            }
}
