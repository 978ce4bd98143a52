/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct_support.h"

#include "direct/direct_constriction.h"

double recipe_variance(double r, const void *scale)
{
    double square = round(r * r);
    return square <= 256 ? *(const double *)scale * pow(fmax(square, 4), -1.8) : 0;
}

double recipe_scale(void)
{
    double sum = 0, one = 1;
    for (int i = -16; i <= 16; i++)
        for (int j = -16; j <= 16; j++)
            if (i != 0 || j != 0) {
                double r = sqrt((double)(i * i + j * j));
                sum += recipe_variance(r, &one) * pow(2 * M_PI * r, 2);
            }
    return 1 / sum;
}

double *recipe_surface(size_t n)
{
    double *height = support_room(n * n * sizeof *height), scale = recipe_scale();
    expect_ok(direct_surface_make, height, n, &(struct direct_recipe){recipe_variance, &scale, NULL, 0}, 1);
    return height;
}

double *wave_of(size_t nx, size_t ny, double amplitude)
{
    double *height = support_room(nx * ny * sizeof *height);
    for (size_t k = 0; k < nx * ny; k++)
        height[k] = amplitude * cos(2 * M_PI * ((double)(k % nx) + 0.3) / (double)nx);
    return height;
}

double *paraboloid_of(size_t n, double *mean)
{
    double *height = support_room(n * n * sizeof *height);
    *mean = 0;
    for (size_t k = 0; k < n * n; k++) {
        double x = (double)(k % n) / (double)n - 0.5 - 0.357 / 256, y = (double)(k / n) / (double)n - 0.5 - 0.123 / 256;
        height[k] = -(pow(remainder(x, 1), 2) + pow(remainder(y, 1), 2)) / 2;
        *mean += height[k] / (double)(n * n);
    }
    return height;
}

double gradient_of(const double *height, size_t n, double spacing)
{
    double sum = 0;
    for (size_t j = 0; j < n; j++)
        for (size_t i = 0; i < n; i++) {
            double along = height[j * n + (i + 1) % n] - height[j * n + (i + n - 1) % n];
            double across = height[(j + 1) % n * n + i] - height[(j + n - 1) % n * n + i];
            sum += (along * along + across * across) / (double)(n * n);
        }
    return sqrt(sum) / (2 * spacing);
}

struct direct_contact contact_of(const double *height, size_t nx, size_t ny)
{
    struct direct_contact contact;
    expect_ok(direct_contact_make, &contact, height, &(struct direct_grid){nx, ny, 1 / (double)nx, false, false});
    return contact;
}

struct direct_contact_load load_of(double mean_pressure, double hardness, double tolerance)
{
    return (struct direct_contact_load){mean_pressure, hardness, tolerance, false, NULL};
}

struct direct_quantities solved(struct direct_contact *contact, const struct direct_contact_load *load)
{
    expect_ok(direct_contact_solve, contact, load);
    assert_true(contact->convolutions > 0);
    return direct_quantities_of(contact, load);
}

double constriction_of(struct direct_contact *contact, double tolerance)
{
    double length;
    expect_ok(direct_constriction_of_contact, &length, contact, tolerance, NULL);
    return length;
}

double constriction_of_drawing(const uint8_t *drawing, size_t n, size_t *iterations)
{
    double *height = support_room(n * n * sizeof *height), length;
    height[0] = 1; /* no surface is solved, but it must not be flat */
    struct direct_contact contact = contact_of(height, n, n);
    for (size_t k = 0; k < n * n; k++)
        contact.pressure[k / n * contact.kernel.stride + k % n] = drawing[k];
    expect_ok(direct_constriction_of_contact, &length, &contact, 1e-9, NULL);
    *iterations = contact.iterations;
    direct_contact_free(&contact);
    return length;
}

double twenty_spots_of(size_t n)
{
    struct table spots = table_read("golden/direct/greenwood_spots.csv");
    uint8_t *drawing = support_room(n * n);
    size_t iterations;
    for (size_t s = 0; s < spots.rows; s++) {
        double x = table_number(&spots, s, "x"), y = table_number(&spots, s, "y"), a = table_number(&spots, s, "a");
        for (size_t k = 0; k < n * n; k++)
            drawing[k] |= hypot(remainder(((double)(k % n) + 0.5) / (double)n - x, 1),
                                remainder(((double)(k / n) + 0.5) / (double)n - y, 1)) <= a;
    }
    double length = constriction_of_drawing(drawing, n, &iterations);
    return length;
}

double largest_pressure(const struct direct_contact *contact)
{
    double most = 0;
    for (size_t j = 0; j < contact->kernel.ny; j++)
        for (size_t i = 0; i < contact->kernel.nx; i++)
            most = fmax(most, contact->pressure[j * contact->kernel.stride + i]);
    return most;
}

struct overlap overlap_of(const struct direct_contact *contact, double hardness)
{
    const struct direct_kernel *kernel = &contact->kernel;
    struct overlap out = {0};
    for (size_t j = 0; j < kernel->ny; j++)
        for (size_t k = j * kernel->stride; k < j * kernel->stride + kernel->nx; k++) {
            out.capped_points += contact->pressure[k] >= hardness;
            out.plane_gap_m += contact->gap_m[k] / (double)kernel->points;
        }
    return out;
}

/** K p by FFTW's own transform of two dimensions, not in place. */
static double *displacement(const struct direct_contact *contact)
{
    const struct direct_kernel *kernel = &contact->kernel;
    size_t nx = kernel->nx, ny = kernel->ny, columns = nx / 2 + 1;
    double *field = fftw_alloc_real(kernel->points);
    fftw_complex *modes = fftw_alloc_complex(ny * columns);
    fftw_plan forth = fftw_plan_dft_r2c_2d((int)ny, (int)nx, field, modes, FFTW_ESTIMATE);
    fftw_plan back = fftw_plan_dft_c2r_2d((int)ny, (int)nx, modes, field, FFTW_ESTIMATE);
    for (size_t j = 0; j < ny; j++)
        memcpy(field + j * nx, contact->pressure + j * kernel->stride, nx * sizeof *field);
    fftw_execute(forth);
    for (size_t j = 0; j < ny; j++)
        for (size_t i = 0; i < columns; i++) {
            double x = (double)i / (double)nx, y = (double)(j <= ny / 2 ? j : ny - j) / (double)ny;
            double q = 2 * M_PI / kernel->spacing_m * hypot(x, y);
            for (int part = 0; part < 2; part++)
                modes[j * columns + i][part] *= i + j > 0 ? 2 / (q * (double)kernel->points) : 0;
        }
    fftw_execute(back);
    fftw_destroy_plan(forth);
    fftw_destroy_plan(back);
    fftw_free(modes);
    return field;
}

double violation_of(const struct direct_contact *contact, const struct direct_contact_load *load)
{
    const struct direct_kernel *kernel = &contact->kernel;
    double *gap = displacement(contact), mean = 0, sum = 0, count = 0, worst = 0;
    for (size_t j = 0; j < kernel->ny; j++)
        for (size_t i = 0; i < kernel->nx; i++) {
            double p = contact->pressure[j * kernel->stride + i], *g = gap + j * kernel->nx + i;
            assert_true(p >= 0 && p <= load->hardness);
            mean += p / (double)kernel->points;
            *g -= contact->height_m[j * kernel->stride + i];
            if (p > 0 && p < load->hardness) {
                sum += *g;
                count++;
            }
        }
    assert_near(mean, load->mean_pressure, 1e-12);
    for (size_t j = 0; j < kernel->ny && count > 0; j++)
        for (size_t i = 0; i < kernel->nx; i++) {
            double p = contact->pressure[j * kernel->stride + i], g = gap[j * kernel->nx + i] - sum / count;
            worst = fmax(worst, p <= 0 ? -g : p >= load->hardness ? g : fabs(g));
        }
    fftw_free(gap);
    return worst / contact->rms_m;
}
