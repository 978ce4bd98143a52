/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_quantities.h"

#include <math.h>
#include <stdlib.h>

const double direct_kappa = 0.10;
const double direct_kappa_yastrebov = (M_PI - 1 + M_LN2) / 24;

double direct_area_corrected(const struct direct_quantities *quantities, size_t points, double kappa)
{
    return fmax(0, ((double)quantities->contact_points - kappa * (double)quantities->perimeter_faces) / (double)points);
}

/** The points one further along x and along y of point k, periodic. */
static size_t right_of(size_t k, size_t nx)
{
    return (k + 1) % nx ? k + 1 : k + 1 - nx;
}

static size_t above(size_t k, size_t nx, size_t points)
{
    return k + nx < points ? k + nx : k + nx - points;
}

struct direct_quantities direct_quantities_of(struct direct_contact *contact, const struct direct_contact_load *load)
{
    const struct direct_kernel *kernel = &contact->kernel;
    const uint8_t *touching = direct_contact_touching(contact);
    struct direct_quantities out = {0};
    double open = 0;
    for (size_t j = 0; j < kernel->ny; j++) {
        double row = 0;
        for (size_t k = j * kernel->stride; k < j * kernel->stride + kernel->nx; k++)
            row += fmax(contact->gap_m[k], 0);
        open += row;
    }
    for (size_t k = 0; k < kernel->points; k++) {
        out.contact_points += touching[k];
        out.perimeter_faces += touching[k] != touching[right_of(k, kernel->nx)];
        out.perimeter_faces += touching[k] != touching[above(k, kernel->nx, kernel->points)];
    }
    out.area_ratio =
        fmax(direct_area_corrected(&out, kernel->points, direct_kappa), load->mean_pressure / load->hardness);
    bool complete = out.contact_points == kernel->points && isinf(load->hardness);
    out.gap_m = complete ? 0 : open / (double)kernel->points; /* what is left there is the solver's tolerance */
    return out;
}

/** The root of a point's tree, the path to it halved. */
static uint32_t root(uint32_t *parent, size_t k)
{
    while (parent[k] != k)
        k = parent[k] = parent[parent[k]];
    return (uint32_t)k;
}

/** Joins the patches of two points in contact; false: they were one. */
static bool join(uint32_t *parent, size_t a, size_t b)
{
    uint32_t x = root(parent, a), y = root(parent, b);
    parent[x > y ? x : y] = x > y ? y : x;
    return x != y;
}

enum status_code direct_patches(size_t *count, struct direct_contact *contact, struct status *status)
{
    const struct direct_kernel *kernel = &contact->kernel;
    const uint8_t *touching = direct_contact_touching(contact);
    size_t nx = kernel->nx, points = kernel->points;
    uint32_t *parent = malloc((points + 1) * sizeof *parent);
    *count = 0;
    if (!parent)
        return status_memory(status);
    for (size_t k = 0; k < points; k++)
        parent[k] = (uint32_t)k;
    for (size_t k = 0; k < points; k++) { /* each point is one until it is joined */
        size_t right = right_of(k, nx), next = above(k, nx, points);
        *count += touching[k];
        *count -= touching[k] && touching[right] && join(parent, k, right);
        *count -= touching[k] && touching[next] && join(parent, k, next);
    }
    free(parent);
    return STATUS_OK;
}
