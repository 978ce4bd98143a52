/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_constriction.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_ITERATIONS = 500 };

/** Values on the set, put into the field, 0 elsewhere. */
static void scatter(struct direct_kernel *kernel, const uint32_t *set, size_t count, const double *values)
{
    memset(kernel->field, 0, kernel->rows * kernel->stride * sizeof(double));
    for (size_t k = 0; k < count; k++)
        kernel->field[set[k]] = values[k];
}

/** Mean of the field over the set, of `total` points on all ranks. */
static double mean_on(const struct direct_kernel *kernel, const uint32_t *set, size_t count, double total)
{
    double part[4] = {0};
    for (size_t k = 0; k < count; k++)
        part[k % 4] += kernel->field[set[k]];
    return direct_team_sum(kernel->team, (part[0] + part[1]) + (part[2] + part[3])) / total;
}

static double dot(const struct direct_kernel *kernel, const double *a, const double *b, size_t count)
{
    double part[4] = {0};
    for (size_t k = 0; k < count; k++)
        part[k % 4] += a[k] * b[k];
    return direct_team_sum(kernel->team, (part[0] + part[1]) + (part[2] + part[3]));
}

enum status_code direct_constriction_of_set(double *length_m, struct direct_kernel *kernel, const uint32_t *set,
                                            size_t count, double *const scratch[3], double tolerance,
                                            const atomic_bool *stop, struct direct_contact_effort *effort,
                                            struct status *status)
{
    const struct direct_team *team = kernel->team;
    double total = direct_team_sum(team, (double)count), points = (double)kernel->points;
    assert(total > 0 && total <= points && tolerance > 0);
    double *current = scratch[0], *residual = scratch[1], *direction = scratch[2], last = INFINITY;
    size_t before = kernel->convolutions;
    *length_m = 0;
    if (total == points)
        return STATUS_OK;
    for (size_t k = 0; k < count; k++) {
        current[k] = points / total;
        direction[k] = 0;
    }
    scatter(kernel, set, count, current);
    direct_kernel_comply(kernel);
    double potential = mean_on(kernel, set, count, total);
    for (size_t k = 0; k < count; k++)
        residual[k] = kernel->field[set[k]] - potential;
    for (int iteration = 0;; iteration++) {
        double worst = 0, most[2];
        for (size_t k = 0; k < count; k++)
            worst = fabs(residual[k]) > worst ? fabs(residual[k]) : worst;
        most[0] = worst;
        most[1] = stop && *stop;
        direct_team_most(team, most, 2);
        worst = most[0];
        *length_m = potential + dot(kernel, current, residual, count) / points;
        effort->violation = worst / fabs(*length_m);
        if (worst <= tolerance * fabs(*length_m))
            break;
        if (most[1] > 0)
            return status_fail(status, STATUS_INTERRUPTED, "stopped");
        if (!isfinite(*length_m) || iteration >= MOST_ITERATIONS)
            return status_fail(status, STATUS_MODEL,
                               "the constriction of %.0f contact points does not converge; use a finer grid", total);
        scatter(kernel, set, count, residual);
        direct_kernel_stiffen(kernel);
        double mean = mean_on(kernel, set, count, total), product = 0;
        for (size_t k = 0; k < count; k++)
            product += residual[k] * (kernel->field[set[k]] - mean);
        product = direct_team_sum(team, product);
        for (size_t k = 0; k < count; k++)
            direction[k] = kernel->field[set[k]] - mean + product / last * direction[k];
        last = product;
        scatter(kernel, set, count, direction);
        direct_kernel_comply(kernel);
        mean = mean_on(kernel, set, count, total);
        double curvature = 0;
        for (size_t k = 0; k < count; k++)
            curvature += direction[k] * kernel->field[set[k]];
        double tau = dot(kernel, residual, direction, count) / direct_team_sum(team, curvature);
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
                                                const atomic_bool *stop, struct direct_contact_effort *effort,
                                                struct status *status)
{
    const struct direct_kernel *kernel = &contact->kernel;
    assert(contact->solved);
    contact->set_count = 0;
    for (size_t j = 0; j < kernel->rows; j++)
        for (size_t k = j * kernel->stride; k < j * kernel->stride + kernel->nx; k++) {
            contact->set[contact->set_count] = (uint32_t)k;
            contact->set_count += contact->pressure[k] > 0;
        }
    double *current = malloc((contact->set_count + 1) * sizeof *current); /* a rank may touch nowhere */
    if (!current)
        (void)status_memory(status);
    if (direct_team_agree(kernel->team, status) != STATUS_OK) {
        free(current);
        return status->code;
    }
    double *const scratch[3] = {current, contact->gap_m, contact->direction};
    enum status_code rc = direct_constriction_of_set(length_m, &contact->kernel, contact->set, contact->set_count,
                                                     scratch, tolerance, stop, effort, status);
    free(current);
    return rc;
}
