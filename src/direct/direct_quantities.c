/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_quantities.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const double direct_kappa = 0.10;
const double direct_kappa_yastrebov = (M_PI - 1 + M_LN2) / 24;

/** Place of the point one further along x, periodic. */
static size_t right_of(const struct direct_kernel *kernel, size_t i, size_t j)
{
    return j * kernel->stride + (i + 1 < kernel->nx ? i + 1 : 0);
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
    const double *wrapped = direct_kernel_row_above(kernel, pressure);
    struct direct_quantities out = {0};
    double open = 0, plane = 0;
    for (size_t j = 0; j < kernel->rows; j++) {
        const double *next = j + 1 < kernel->rows ? pressure + (j + 1) * kernel->stride : wrapped;
        double row_open = 0, row_plane = 0;
        for (size_t i = 0; i < kernel->nx; i++) {
            double p = pressure[j * kernel->stride + i], g = contact->gap_m[j * kernel->stride + i];
            out.contact_points += p > 0;
            out.capped_points += p >= load->hardness;
            out.perimeter_faces += (p > 0) != (pressure[right_of(kernel, i, j)] > 0);
            out.perimeter_faces += (p > 0) != (next[i] > 0);
            row_open += fmax(g, 0);
            row_plane += g;
        }
        open += row_open;
        plane += row_plane;
    }
    double sums[2] = {open, plane};
    double counts[3] = {(double)out.contact_points, (double)out.perimeter_faces, (double)out.capped_points};
    direct_team_add(kernel->team, sums, 2);
    direct_team_add(kernel->team, counts, 3);
    open = sums[0];
    plane = sums[1];
    out.contact_points = (size_t)counts[0];
    out.perimeter_faces = (size_t)counts[1];
    out.capped_points = (size_t)counts[2];
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

/** Joins neighbours in the rows here, along y within them and, where the grid is all here, across its end. */
static void join_here(uint32_t *parent, const struct direct_kernel *kernel, const double *pressure)
{
    for (size_t k = 0; k < kernel->rows * kernel->stride; k++)
        parent[k] = (uint32_t)k;
    for (size_t j = 0; j < kernel->rows; j++)
        for (size_t i = 0; i < kernel->nx; i++) {
            size_t k = j * kernel->stride + i, right = right_of(kernel, i, j);
            size_t above = (j + 1 < kernel->rows ? j + 1 : 0) * kernel->stride + i;
            if (pressure[k] > 0 && pressure[right] > 0)
                join(parent, k, right);
            if ((j + 1 < kernel->rows || !kernel->team) && pressure[k] > 0 && pressure[above] > 0)
                join(parent, k, above);
        }
}

/** The patches here, and, of each point, 1 + which it belongs to (0: none): `number`, of the kernel's places. */
static enum status_code find_here(struct direct_patches *out, uint32_t *number, struct direct_contact *contact,
                                  struct status *status)
{
    const struct direct_kernel *kernel = &contact->kernel;
    size_t places = kernel->rows * kernel->stride;
    uint32_t *parent = contact->set;
    join_here(parent, kernel, contact->pressure);
    for (size_t j = 0; j < kernel->rows; j++)
        for (size_t k = j * kernel->stride; k < j * kernel->stride + kernel->nx; k++)
            if (contact->pressure[k] > 0)
                out->count += number[root(parent, (uint32_t)k)]++ == 0; /* for now, how many points */
    out->points = malloc((out->count + 1) * sizeof *out->points);
    if (!out->points)
        return status_memory(status);
    for (size_t k = 0, n = 0; k < places; k++)
        if (number[k]) {
            out->points[n++] = number[k];
            number[k] = (uint32_t)n;
        }
    return STATUS_OK;
}

/** What a rank tells of its patches: how many, and 1 + which each point of its first and last row is in. */
static uint32_t *edges_of(const struct direct_patches *patches, const uint32_t *number,
                          const struct direct_contact *contact)
{
    const struct direct_kernel *kernel = &contact->kernel;
    uint32_t *edges = calloc(1 + 2 * kernel->nx, sizeof *edges);
    if (!edges)
        return NULL;
    edges[0] = (uint32_t)patches->count;
    for (size_t side = 0; side < 2 && kernel->rows > 0; side++)
        for (size_t i = 0; i < kernel->nx; i++) {
            size_t k = (side ? kernel->rows - 1 : 0) * kernel->stride + i;
            edges[1 + side * kernel->nx + i] = contact->pressure[k] > 0 ? number[root(contact->set, (uint32_t)k)] : 0;
        }
    return edges;
}

/** Joins the patches of `ranks` ranks, each of which told its edges (nx points) and the points of its patches (`most`
 * places each). `parent` and `points`: as many as there are patches on all ranks. */
static void join_ranks(struct direct_patches *out, const struct direct_kernel *kernel, const uint32_t *edges,
                       const uint32_t *sizes, size_t most, uint32_t *parent)
{
    size_t nx = kernel->nx, ranks = kernel->team->size, all = 0, holders = 0, first, length = 1 + 2 * nx;
    for (size_t rank = 0; rank < ranks; rank++) {
        memcpy(out->points + all, sizes + rank * most, edges[rank * length] * sizeof *out->points);
        all += edges[rank * length];
        holders += direct_team_slab(kernel->ny, ranks, rank, &first) > 0;
    }
    for (size_t k = 0; k < all; k++)
        parent[k] = (uint32_t)k;
    for (size_t rank = 0, offset = 0; rank < holders; rank++) {
        size_t next = rank + 1 < holders ? rank + 1 : 0, next_offset = next ? offset + edges[rank * length] : 0;
        const uint32_t *last = edges + rank * length + 1 + nx, *above = edges + next * length + 1;
        for (size_t i = 0; i < nx; i++)
            if (last[i] && above[i])
                join(parent, offset + last[i] - 1, next_offset + above[i] - 1);
        offset += edges[rank * length];
    }
    for (size_t k = all; k-- > 0;) /* a root comes before what hangs on it */
        if (parent[k] != k)
            out->points[parent[k]] += out->points[k];
    out->count = 0;
    for (size_t k = 0; k < all; k++)
        if (parent[k] == k)
            out->points[out->count++] = out->points[k];
}

/** The patches of all ranks, from those here. */
static enum status_code merge(struct direct_patches *out, const uint32_t *number, const struct direct_contact *contact,
                              struct status *status)
{
    const struct direct_team *team = contact->kernel.team;
    size_t length = 1 + 2 * contact->kernel.nx;
    double most = (double)out->count, all = direct_team_sum(team, most);
    direct_team_most(team, &most, 1);
    size_t width = (size_t)most + 1;
    uint32_t *mine = edges_of(out, number, contact), *edges = malloc(team->size * length * sizeof *edges);
    uint32_t *points = realloc(out->points, width * sizeof *points),
             *sizes = malloc(team->size * width * sizeof *sizes);
    uint32_t *parent = malloc(((size_t)all + 1) * sizeof *parent), *merged = malloc(((size_t)all + 1) * sizeof *merged);
    out->points = points ? points : out->points;
    if (!mine || !edges || !points || !sizes || !parent || !merged)
        (void)status_memory(status);
    if (direct_team_agree(team, status) == STATUS_OK) {
        team->gather(team, edges, mine, length * sizeof *mine);
        team->gather(team, sizes, out->points, width * sizeof *sizes);
        free(out->points);
        out->points = merged;
        merged = NULL;
        join_ranks(out, &contact->kernel, edges, sizes, width, parent);
    }
    free(mine);
    free(edges);
    free(sizes);
    free(parent);
    free(merged);
    return status->code;
}

enum status_code direct_patches_find(struct direct_patches *out, struct direct_contact *contact, struct status *status)
{
    const struct direct_kernel *kernel = &contact->kernel;
    uint32_t *number = calloc(kernel->rows * kernel->stride + 1, sizeof *number);
    *out = (struct direct_patches){0};
    if (!number || find_here(out, number, contact, status) != STATUS_OK)
        (void)status_memory(status);
    if (direct_team_agree(kernel->team, status) == STATUS_OK && kernel->team)
        (void)merge(out, number, contact, status);
    free(number);
    if (status->code != STATUS_OK)
        direct_patches_free(out);
    else
        qsort(out->points, out->count, sizeof *out->points, descending);
    return status->code;
}

void direct_patches_free(struct direct_patches *patches)
{
    free(patches->points);
    *patches = (struct direct_patches){0};
}
