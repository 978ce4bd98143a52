#include "direct/direct_constriction.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_ITERATIONS = 500 };

/** Values on the set, put into the field, 0 elsewhere. */
static void scatter(struct direct_kernel *kernel, const uint32_t *set, size_t count, const double *values)
{
    memset(kernel->field, 0, kernel->ny * kernel->stride * sizeof(double));
    for (size_t k = 0; k < count; k++)
        kernel->field[set[k]] = values[k];
}

/** Mean of the field over the set. */
static double mean_on(const struct direct_kernel *kernel, const uint32_t *set, size_t count)
{
    double part[4] = {0};
    for (size_t k = 0; k < count; k++)
        part[k % 4] += kernel->field[set[k]];
    return ((part[0] + part[1]) + (part[2] + part[3])) / (double)count;
}

static double dot(const double *a, const double *b, size_t count)
{
    double part[4] = {0};
    for (size_t k = 0; k < count; k++)
        part[k % 4] += a[k] * b[k];
    return (part[0] + part[1]) + (part[2] + part[3]);
}

enum status_code direct_constriction_of_set(double *length_m, struct direct_kernel *kernel, const uint32_t *set,
                                            size_t count, double *const scratch[3], double tolerance,
                                            const volatile sig_atomic_t *stop, struct direct_contact_effort *effort,
                                            struct status *status)
{
    assert(count > 0 && count <= kernel->points && tolerance > 0);
    double *current = scratch[0], *residual = scratch[1], *direction = scratch[2], last = INFINITY;
    size_t before = kernel->convolutions;
    *length_m = 0;
    if (count == kernel->points)
        return STATUS_OK;
    for (size_t k = 0; k < count; k++) {
        current[k] = (double)kernel->points / (double)count;
        direction[k] = 0;
    }
    scatter(kernel, set, count, current);
    direct_kernel_comply(kernel);
    double potential = mean_on(kernel, set, count);
    for (size_t k = 0; k < count; k++)
        residual[k] = kernel->field[set[k]] - potential;
    for (int iteration = 0;; iteration++) {
        double worst = 0;
        for (size_t k = 0; k < count; k++)
            worst = fabs(residual[k]) > worst ? fabs(residual[k]) : worst;
        *length_m = potential + dot(current, residual, count) / (double)kernel->points;
        effort->violation = worst / fabs(*length_m);
        if (worst <= tolerance * fabs(*length_m))
            break;
        if (stop && *stop)
            return status_fail(status, STATUS_INTERRUPTED, "stopped");
        if (!isfinite(*length_m) || iteration >= MOST_ITERATIONS)
            return status_fail(status, STATUS_MODEL,
                               "the constriction of %zu contact points does not converge; use a finer grid", count);
        scatter(kernel, set, count, residual);
        direct_kernel_stiffen(kernel);
        double mean = mean_on(kernel, set, count), product = 0;
        for (size_t k = 0; k < count; k++)
            product += residual[k] * (kernel->field[set[k]] - mean);
        for (size_t k = 0; k < count; k++)
            direction[k] = kernel->field[set[k]] - mean + product / last * direction[k];
        last = product;
        scatter(kernel, set, count, direction);
        direct_kernel_comply(kernel);
        mean = mean_on(kernel, set, count);
        double curvature = 0;
        for (size_t k = 0; k < count; k++)
            curvature += direction[k] * kernel->field[set[k]];
        double tau = dot(residual, direction, count) / curvature;
        for (size_t k = 0; k < count; k++) {
            current[k] -= tau * direction[k];
            residual[k] -= tau * (kernel->field[set[k]] - mean);
        }
        potential -= tau * mean;
        effort->iterations++;
    }
    effort->convolutions += kernel->convolutions - before;
    return STATUS_OK;
}

enum status_code direct_constriction_of_contact(double *length_m, struct direct_contact *contact, double tolerance,
                                                const volatile sig_atomic_t *stop, struct direct_contact_effort *effort,
                                                struct status *status)
{
    const struct direct_kernel *kernel = &contact->kernel;
    assert(contact->solved);
    contact->set_count = 0;
    for (size_t j = 0; j < kernel->ny; j++)
        for (size_t k = j * kernel->stride; k < j * kernel->stride + kernel->nx; k++) {
            contact->set[contact->set_count] = (uint32_t)k;
            contact->set_count += contact->pressure[k] > 0;
        }
    double *current = malloc(contact->set_count * sizeof *current);
    if (!current)
        return status_memory(status);
    double *const scratch[3] = {current, contact->gap_m, contact->direction};
    enum status_code rc = direct_constriction_of_set(length_m, &contact->kernel, contact->set, contact->set_count,
                                                     scratch, tolerance, stop, effort, status);
    free(current);
    return rc;
}
