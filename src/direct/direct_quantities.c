/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_quantities.h"

#include "direct/direct_constriction.h"
#include <math.h>
#include <stdlib.h>

const double direct_kappa = 0.10;
const double direct_kappa_yastrebov = (M_PI - 1 + M_LN2) / 24;

double direct_area_corrected(const struct direct_quantities *quantities, size_t points, double kappa)
{
    return fmax(0, ((double)quantities->contact_points - kappa * (double)quantities->perimeter_faces) / (double)points);
}

/** The row or column after the k-th of n: after the last the first, or its own mirror image. */
static size_t behind(const struct direct_kernel *kernel, size_t k, size_t n)
{
    return k + 1 < n ? k + 1 : kernel->mirrored ? k : 0;
}

struct direct_quantities direct_quantities_of(struct direct_contact *contact, const struct direct_contact_load *load)
{
    const struct direct_kernel *kernel = &contact->kernel;
    const uint8_t *touching = direct_contact_touching(contact);
    struct direct_quantities out = {0};
    double open = 0;
    size_t nx = kernel->nx;
    for (size_t j = 0; j < kernel->ny; j++) {
        const double *gap_m = contact->gap_m + j * kernel->stride;
        const uint8_t *row = touching + j * nx, *above = touching + behind(kernel, j, kernel->ny) * nx;
        double sum = 0;
        for (size_t i = 0; i < nx; i++) {
            sum += gap_m[i] > 0 ? gap_m[i] : 0;
            out.contact_points += row[i];
            out.perimeter_faces += (row[i] ^ row[behind(kernel, i, nx)]) + (row[i] ^ above[i]);
        }
        open += sum;
    }
    out.area_ratio =
        fmax(direct_area_corrected(&out, kernel->points, direct_kappa), load->mean_pressure / load->hardness);
    bool complete = out.contact_points == kernel->points && isinf(load->hardness);
    out.gap_m = complete ? 0 : open / (double)kernel->points; /* what is left is the tolerance of the solver */
    return out;
}

/** Root of the tree of a point; halves the path to it. */
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

/** Index of the point at (i, j) of a period. */
static size_t place(const struct direct_kernel *kernel, size_t i, size_t j)
{
    size_t column = i < kernel->nx ? i : 2 * kernel->nx - 1 - i, row = j < kernel->ny ? j : 2 * kernel->ny - 1 - j;
    return row * kernel->nx + column;
}

enum status_code direct_patches(size_t *count, struct direct_contact *contact, struct status *status)
{
    const struct direct_kernel *kernel = &contact->kernel;
    const uint8_t *touching = direct_contact_touching(contact);
    const size_t times = kernel->mirrored ? 2 : 1, nx = times * kernel->nx, ny = times * kernel->ny, points = nx * ny;
    OWNED(memory_free) uint32_t *parent = malloc((points + 1) * sizeof *parent);
    *count = 0;
    if (!parent)
        return status_memory(status);
    for (size_t k = 0; k < points; k++)
        parent[k] = (uint32_t)k;
    for (size_t j = 0; j < ny; j++)
        for (size_t i = 0; i < nx; i++) { /* each point is a patch until it is joined */
            size_t right = i + 1 < nx ? i + 1 : 0, above = j + 1 < ny ? j + 1 : 0, k = j * nx + i;
            bool own = touching[place(kernel, i, j)];
            *count += own;
            *count -= own && touching[place(kernel, right, j)] && join(parent, k, j * nx + right);
            *count -= own && touching[place(kernel, i, above)] && join(parent, k, above * nx + i);
        }
    return STATUS_OK;
}

double direct_point_value(const struct direct_point *point, enum direct_quantity quantity)
{
    const double values[] = {[DIRECT_AREA] = point->quantities.area_ratio,
                             [DIRECT_GAP] = point->quantities.gap_m,
                             [DIRECT_CONSTRICTION] = point->constriction_m,
                             [DIRECT_PATCHES] = (double)point->patches};
    return values[quantity];
}

static enum status_code solve_load(struct direct_point *out, struct direct_contact *contact,
                                   const struct direct_ladder_def *def, double mean_pressure, struct status *status)
{
    struct direct_contact_load load = {mean_pressure, def->hardness, def->tolerance, true, def->stop};
    if (direct_contact_solve(contact, &load, status) != STATUS_OK)
        return status->code;
    out->exists = true;
    out->quantities = direct_quantities_of(contact, &load);
    if (!def->without_patches && direct_patches(&out->patches, contact, status) != STATUS_OK)
        return status->code;
    if (def->resistance &&
        direct_constriction_of_contact(&out->constriction_m, contact, def->tolerance, def->stop, status) != STATUS_OK)
        return status->code;
    out->convolutions = contact->convolutions;
    return STATUS_OK;
}

enum status_code direct_ladder_run(struct direct_point *out, struct direct_contact *contact,
                                   const struct direct_ladder_def *def, struct status *status)
{
    for (size_t i = 0; i < def->loads; i++) {
        out[i] = (struct direct_point){.constriction_m = NAN};
        if (def->load[i] < def->hardness && solve_load(&out[i], contact, def, def->load[i], status) != STATUS_OK)
            return status->code;
    }
    return STATUS_OK;
}
