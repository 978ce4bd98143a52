/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_constriction.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_ITERATIONS = 500 };

/** Puts values on the contact's set into the field, 0 elsewhere, and convolves it with the compliance or stiffens it.
 * Gives its mean over the set, and its product with the values. */
static double convolve(double *product, struct direct_contact *contact, const double *values, bool stiffen)
{
    struct direct_kernel *kernel = &contact->kernel;
    const uint32_t *set = contact->set;
    double part[2][4] = {{0}};
    if (stiffen)
        direct_contact_clear(contact);
    else
        memset(kernel->field, 0, kernel->ny * kernel->stride * sizeof(double));
    for (size_t k = 0; k < contact->set_count; k++)
        kernel->field[set[k]] = values[k];
    if (stiffen)
        direct_contact_stiffen(contact);
    else
        direct_kernel_convolve(kernel, DIRECT_COMPLIANCE, contact->rows);
    for (size_t k = 0; k < contact->set_count; k += 4)
        for (size_t i = 0; i < 4 && k + i < contact->set_count; i++) {
            part[0][i] += kernel->field[set[k + i]];
            part[1][i] += kernel->field[set[k + i]] * values[k + i];
        }
    *product = (part[1][0] + part[1][1]) + (part[1][2] + part[1][3]);
    return ((part[0][0] + part[0][1]) + (part[0][2] + part[0][3])) / (double)contact->set_count;
}

static double dot(const struct direct_contact *contact, const double *a, const double *b)
{
    double part[4] = {0};
    for (size_t k = 0; k < contact->set_count; k += 4)
        for (size_t i = 0; i < 4 && k + i < contact->set_count; i++)
            part[i] += a[k + i] * b[k + i];
    return (part[0] + part[1]) + (part[2] + part[3]);
}

/** On the contact's set; `current`: room for one value a point. */
static enum status_code iterate(double *length_m, struct direct_contact *contact, double *current, double tolerance,
                                const atomic_bool *stop, struct status *status)
{
    const struct direct_kernel *kernel = &contact->kernel;
    const uint32_t *set = contact->set;
    size_t count = contact->set_count;
    double *residual = contact->gap_m, *direction = contact->direction, points = (double)kernel->points;
    double last = INFINITY, product, curvature;
    for (size_t k = 0; k < count; k++) {
        current[k] = points / (double)count;
        direction[k] = 0;
    }
    double potential = convolve(&product, contact, current, false);
    for (size_t k = 0; k < count; k++)
        residual[k] = kernel->field[set[k]] - potential;
    for (int iteration = 0;; iteration++) {
        double most = 0;
        for (size_t k = 0; contact->response && k < count; k++)
            most = fabs(residual[k]) > most ? fabs(residual[k]) : most;
        *length_m = potential + dot(contact, current, residual) / points;
        if (contact->response && most <= sqrt(tolerance) * fabs(*length_m))
            return STATUS_OK;
        if (stop && *stop)
            return status_fail(status, STATUS_INTERRUPTED, "stopped");
        if (!isfinite(*length_m) || iteration >= MOST_ITERATIONS)
            return status_fail(status, STATUS_MODEL,
                               "the constriction of %zu contact points does not converge; use a finer grid", count);
        double mean = convolve(&product, contact, residual, true);
        if (!contact->response && product <= tolerance * points * fabs(*length_m))
            return STATUS_OK;
        for (size_t k = 0; k < count; k++)
            direction[k] = kernel->field[set[k]] - mean + product / last * direction[k];
        last = product;
        mean = convolve(&curvature, contact, direction, false);
        double tau = dot(contact, residual, direction) / curvature;
        for (size_t k = 0; k < count; k++) {
            current[k] -= tau * direction[k];
            residual[k] -= tau * (kernel->field[set[k]] - mean);
        }
        potential -= tau * mean;
        contact->iterations++;
    }
}

enum status_code direct_constriction_of_contact(double *length_m, struct direct_contact *contact, double tolerance,
                                                const atomic_bool *stop, struct status *status)
{
    const struct direct_kernel *kernel = &contact->kernel;
    size_t before = kernel->transforms;
    *length_m = 0;
    direct_contact_select(contact, false);
    OWNED(memory_free) double *current = calloc(contact->set_count + 1, sizeof *current);
    if (!current)
        return status_memory(status);
    assert(contact->set_count > 0 && tolerance > 0);
    if (contact->set_count < kernel->points)
        (void)iterate(length_m, contact, current, tolerance, stop, status);
    for (size_t k = 0; contact->response && *length_m > 0 && k < contact->set_count; k++)
        contact->response[contact->set[k]] = current[k];
    contact->convolutions += (kernel->transforms - before) / 2;
    return status->code;
}
