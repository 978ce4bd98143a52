#include "direct/direct_quantities.h"

#include <math.h>
#include <stdlib.h>

const double direct_kappa = 0.10;
const double direct_kappa_yastrebov = (M_PI - 1 + M_LN2) / 24;

/** Place of the point one further along x, or y, periodic. */
static size_t right_of(const struct direct_kernel *kernel, size_t i, size_t j)
{
    return j * kernel->stride + (i + 1 < kernel->nx ? i + 1 : 0);
}

static size_t above(const struct direct_kernel *kernel, size_t i, size_t j)
{
    return (j + 1 < kernel->ny ? j + 1 : 0) * kernel->stride + i;
}

double direct_area_corrected(const struct direct_quantities *quantities, size_t points, double kappa)
{
    return fmax(0, ((double)quantities->contact_points - kappa * (double)quantities->perimeter_faces) / (double)points);
}

struct direct_quantities direct_quantities_of(const struct direct_contact *contact,
                                              const struct direct_contact_load *load)
{
    const struct direct_kernel *kernel = &contact->kernel;
    const double *pressure = contact->pressure;
    struct direct_quantities out = {0};
    double open = 0, plane = 0;
    for (size_t j = 0; j < kernel->ny; j++) {
        double row_open = 0, row_plane = 0;
        for (size_t i = 0; i < kernel->nx; i++) {
            double p = pressure[j * kernel->stride + i], g = contact->gap_m[j * kernel->stride + i];
            out.contact_points += p > 0;
            out.capped_points += p >= load->hardness;
            out.perimeter_faces += (p > 0) != (pressure[right_of(kernel, i, j)] > 0);
            out.perimeter_faces += (p > 0) != (pressure[above(kernel, i, j)] > 0);
            row_open += fmax(g, 0);
            row_plane += g;
        }
        open += row_open;
        plane += row_plane;
    }
    out.area_raw = (double)out.contact_points / (double)kernel->points;
    out.area_ratio =
        fmax(direct_area_corrected(&out, kernel->points, direct_kappa), load->mean_pressure / load->hardness);
    bool complete = out.contact_points == kernel->points && isinf(load->hardness);
    out.gap_m = complete ? 0 : open / (double)kernel->points; /* what is left of g there is the solver's tolerance */
    out.plane_gap_m = complete ? 0 : plane / (double)kernel->points;
    return out;
}

/** The root of a place's tree, the path to it halved. */
static uint32_t root(uint32_t *parent, uint32_t k)
{
    while (parent[k] != k)
        k = parent[k] = parent[parent[k]];
    return k;
}

static void join(uint32_t *parent, size_t a, size_t b)
{
    uint32_t x = root(parent, (uint32_t)a), y = root(parent, (uint32_t)b);
    if (x < y)
        parent[y] = x;
    else
        parent[x] = y;
}

static int descending(const void *a, const void *b)
{
    uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x < y) - (x > y);
}

enum status_code direct_patches_find(struct direct_patches *out, struct direct_contact *contact, struct status *status)
{
    const struct direct_kernel *kernel = &contact->kernel;
    const double *pressure = contact->pressure;
    size_t places = kernel->ny * kernel->stride;
    uint32_t *parent = contact->set, *size = calloc(places, sizeof *size);
    *out = (struct direct_patches){0};
    if (!size)
        return status_memory(status);
    for (size_t k = 0; k < places; k++)
        parent[k] = (uint32_t)k;
    for (size_t j = 0; j < kernel->ny; j++)
        for (size_t i = 0; i < kernel->nx; i++) {
            size_t k = j * kernel->stride + i, next[] = {right_of(kernel, i, j), above(kernel, i, j)};
            for (size_t n = 0; n < 2; n++)
                if (pressure[k] > 0 && pressure[next[n]] > 0)
                    join(parent, k, next[n]);
        }
    for (size_t j = 0; j < kernel->ny; j++)
        for (size_t k = j * kernel->stride; k < j * kernel->stride + kernel->nx; k++)
            if (pressure[k] > 0)
                out->count += size[root(parent, (uint32_t)k)]++ == 0;
    out->points = malloc((out->count + 1) * sizeof *out->points);
    if (out->points) {
        for (size_t k = 0, n = 0; k < places; k++)
            if (size[k])
                out->points[n++] = size[k];
        qsort(out->points, out->count, sizeof *out->points, descending);
    }
    free(size);
    return out->points ? STATUS_OK : status_memory(status);
}

void direct_patches_free(struct direct_patches *patches)
{
    free(patches->points);
    *patches = (struct direct_patches){0};
}
