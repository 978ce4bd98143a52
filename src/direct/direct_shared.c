/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_shared.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/** The rank that holds row (or column) k of n. */
static size_t holder(const struct direct_team *team, size_t n, size_t k)
{
    return k / ((n + team->size - 1) / team->size);
}

/** Place among `count` harmonics of the harmonic that has place j among n, without that at n/2. */
static size_t place_of(size_t j, size_t n, size_t count)
{
    return j < n / 2 ? j : count - (n - j);
}

/** Rows of n values each from the first rank to those whose rows they are, into `out` with the kernel's stride. */
static void deal_rows(double *out, const struct direct_kernel *kernel, const double *rows)
{
    const struct direct_team *team = kernel->team;
    size_t bytes = kernel->nx * sizeof *rows;
    for (size_t j = 0; j < kernel->ny; j++) {
        size_t to = holder(team, kernel->ny, j);
        double *own = to == team->rank ? out + (j - kernel->first_row) * kernel->stride : NULL;
        if (team->rank == 0 && own)
            memcpy(own, rows + j * kernel->nx, bytes);
        else if (team->rank == 0)
            team->exchange(team, to, rows + j * kernel->nx, team->size, NULL, bytes);
        else if (own)
            team->exchange(team, team->size, NULL, 0, own, bytes);
    }
}

/** Where the bodies touch, n x n bytes, to the first rank; `line`: a row of them. */
static void collect_contact(uint8_t *touching, uint8_t *line, const struct direct_contact *contact)
{
    const struct direct_kernel *kernel = &contact->kernel;
    const struct direct_team *team = kernel->team;
    for (size_t j = 0; j < kernel->ny; j++) {
        size_t from = holder(team, kernel->ny, j);
        if (from == team->rank)
            for (size_t i = 0; i < kernel->nx; i++)
                line[i] = contact->pressure[(j - kernel->first_row) * kernel->stride + i] > 0;
        if (team->rank == 0 && from == 0)
            memcpy(touching + j * kernel->nx, line, kernel->nx);
        else if (team->rank == 0)
            team->exchange(team, team->size, NULL, from, touching + j * kernel->nx, kernel->nx);
        else if (from == team->rank)
            team->exchange(team, 0, line, team->size, NULL, kernel->nx);
    }
}

/** The modes of direct_surface_realise() on n points a side, as far as their columns are here. */
static enum status_code fill_modes(struct direct_kernel *kernel, const struct direct_ensemble_def *def, uint64_t seed,
                                   struct status *status)
{
    size_t n = def->n;
    memset(kernel->columns, 0, kernel->own_columns * kernel->ny * sizeof *kernel->columns);
    for (size_t k = 0; k < kernel->own_columns && kernel->first_column + k < n / 2; k++)
        for (size_t j = 0; j < n && status->code == STATUS_OK; j++) {
            long x = (long)(kernel->first_column + k), y = j < n / 2 ? (long)j : (long)j - (long)n;
            double v =
                j != n / 2 && (x != 0 || y != 0) ? def->variance(sqrt((double)(x * x + y * y)), def->context) : 0;
            if (!(v >= 0) || !isfinite(v))
                (void)status_fail(status, STATUS_MODEL,
                                  "the surface's spectrum is negative or not finite at (%ld, %ld)", x, y);
            else
                direct_surface_mode(kernel->columns[k * kernel->ny + place_of(j, n, kernel->ny)], sqrt(v), seed, x, y);
        }
    return direct_team_agree(kernel->team, status);
}

/** direct_surface_refine(): the columns of the coarse grid's transform to where the finer one has them. */
static void spread_modes(struct direct_kernel *fine, const struct direct_kernel *coarse, fftw_complex *column)
{
    const struct direct_team *team = fine->team;
    size_t n = coarse->ny, bytes = n * sizeof *column;
    memset(fine->columns, 0, fine->own_columns * fine->ny * sizeof *fine->columns);
    for (size_t i = 0; i < n / 2; i++) {
        size_t from = holder(team, n / 2 + 1, i), to = holder(team, fine->nx / 2 + 1, i);
        const fftw_complex *here = from == team->rank ? coarse->columns + (i - coarse->first_column) * n : NULL;
        if (here && to != from)
            team->exchange(team, to, here, team->size, NULL, bytes);
        if (to != team->rank)
            continue;
        if (here)
            memcpy(column, here, bytes);
        else
            team->exchange(team, team->size, NULL, from, column, bytes);
        for (size_t j = 0; j < n; j++)
            for (int part = 0; part < 2 && j != n / 2; part++)
                fine->columns[(i - fine->first_column) * fine->ny + place_of(j, n, fine->ny)][part] =
                    column[j][part] / (double)(n * n);
    }
}

/** Heights distributed as given, made on the first rank: 60 bytes a point, while the rest of the grid is there. */
static enum status_code make_at_once(double **out, const struct direct_ensemble_def *def, uint64_t seed,
                                     struct status *status)
{
    size_t n = def->n;
    double needed = 60 * (double)n * (double)n;
    double there = (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE); /* malloc() promises more */
    *out = needed < there ? malloc(n * n * sizeof **out) : NULL;
    if (*out && direct_surface_with_heights(*out, n, def->variance, def->context, def->given_m, def->given_count, seed,
                                            status) == STATUS_OK)
        return STATUS_OK;
    if (*out && status->code != STATUS_MEMORY)
        return status->code;
    *status = (struct status){0};
    return status_fail(status, STATUS_MEMORY,
                       "heights distributed like the scan's are made in one process, which needs %.2g GB for %zu x %zu "
                       "points; take a node with more memory or a smaller grid",
                       needed / 1e9, n, n);
}

/** The same into the kernel's rows: `out`. */
static enum status_code make_heights(double *out, struct direct_kernel *kernel, const struct direct_ensemble_def *def,
                                     uint64_t seed, struct status *status)
{
    double *height_m = NULL;
    if (kernel->team->rank == 0)
        (void)make_at_once(&height_m, def, seed, status);
    if (direct_team_agree(kernel->team, status) == STATUS_OK)
        deal_rows(out, kernel, height_m);
    free(height_m);
    return status->code;
}

/** The same on a finer grid. */
static enum status_code make_fine_heights(struct direct_kernel *fine, const struct direct_ensemble_def *def,
                                          uint64_t seed, struct status *status)
{
    struct direct_kernel coarse;
    if (direct_kernel_make_shared(&coarse, fine->team, def->n, def->n, 1, status) != STATUS_OK)
        return status->code;
    fftw_complex *column = fftw_alloc_complex(def->n);
    if (!column)
        (void)status_memory(status);
    if (direct_team_agree(fine->team, status) == STATUS_OK &&
        make_heights(coarse.field, &coarse, def, seed, status) == STATUS_OK) {
        direct_kernel_transform(&coarse);
        spread_modes(fine, &coarse, column);
    }
    fftw_free(column);
    direct_kernel_free(&coarse);
    return status->code;
}

enum status_code direct_shared_surface(struct direct_point *out, double *rms_m, const struct direct_team *team,
                                       const struct direct_ensemble_def *def, size_t seed, size_t times,
                                       struct status *status)
{
    struct direct_contact contact;
    struct direct_kernel *kernel = &contact.kernel;
    uint64_t phases = def->first_seed + seed;
    size_t n = def->n * times;
    bool by_modes = !def->given_m || times > 1;
    if (direct_contact_begin(&contact, team, n, n, def->length_m / (double)n, status) != STATUS_OK)
        return status->code;
    if (!def->given_m)
        (void)fill_modes(kernel, def, phases, status);
    else if (times > 1)
        (void)make_fine_heights(kernel, def, phases, status);
    else
        (void)make_heights(contact.height_m, kernel, def, phases, status);
    if (status->code != STATUS_OK) {
        direct_contact_free(&contact);
        return status->code;
    }
    if (by_modes) {
        direct_kernel_transform_back(kernel);
        memcpy(contact.height_m, kernel->field, kernel->rows * kernel->stride * sizeof *kernel->field);
    }
    if (direct_contact_take_heights(&contact, status) != STATUS_OK)
        return status->code;
    *rms_m = contact.rms_m;
    enum status_code rc = direct_ladder_run(out, &contact, &def->ladder, status);
    direct_contact_free(&contact);
    return rc;
}

enum status_code direct_shared_heights(struct direct_point *out, uint8_t *touching, const struct direct_team *team,
                                       const double *height_m, size_t n, double spacing_m,
                                       const struct direct_ladder_def *def, struct status *status)
{
    struct direct_contact contact;
    if (direct_contact_begin(&contact, team, n, n, spacing_m, status) != STATUS_OK)
        return status->code;
    deal_rows(contact.height_m, &contact.kernel, height_m);
    if (direct_contact_take_heights(&contact, status) != STATUS_OK)
        return status->code;
    enum status_code rc = direct_ladder_run(out, &contact, def, status);
    if (rc == STATUS_OK && direct_team_any(team, touching != NULL))
        collect_contact(touching, contact.member, &contact); /* what the solver marked its points in is free now */
    direct_contact_free(&contact);
    return rc;
}
