/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_ladder.h"

#include "direct/direct_constriction.h"
#include <math.h>
#include <stdlib.h>

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
    if (direct_patches(&out->patches, contact, status) != STATUS_OK)
        return status->code;
    if (def->resistance && direct_constriction_of_contact(&out->constriction_m, contact, sqrt(def->tolerance),
                                                          def->stop, status) != STATUS_OK)
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

/** The surface of a solved contact, what overlaps taken off. */
static enum status_code flow(struct direct_contact *out, const struct direct_contact *contact, struct status *status)
{
    const struct direct_kernel *kernel = &contact->kernel;
    double *flowed_m = malloc(kernel->points * sizeof *flowed_m);
    if (!flowed_m)
        return status_memory(status);
    for (size_t p = 0; p < kernel->points; p++) {
        size_t k = p / kernel->nx * kernel->stride + p % kernel->nx;
        flowed_m[p] = contact->height_m[k] + fmin(contact->gap_m[k], 0);
    }
    const struct direct_grid grid = {kernel->nx, kernel->ny, kernel->spacing_m, kernel->mirrored};
    enum status_code rc = direct_contact_make(out, flowed_m, &grid, status);
    free(flowed_m);
    return rc;
}

enum status_code direct_ladder_loop(struct direct_point *up, struct direct_point *down, struct direct_contact *loaded,
                                    const struct direct_ladder_def *def, size_t least_patches, struct status *status)
{
    struct direct_contact flowed = {.height_m = NULL};
    struct direct_contact_load most = {def->load[0], def->hardness, def->tolerance, true, def->stop};
    enum status_code rc = direct_contact_solve(loaded, &most, status);
    if (rc == STATUS_OK)
        rc = flow(&flowed, loaded, status);
    for (size_t i = 0; i < def->loads; i++)
        up[i] = down[i] = (struct direct_point){.constriction_m = NAN};
    for (size_t i = 0; i < def->loads && rc == STATUS_OK; i++) {
        rc = solve_load(&up[i], loaded, def, def->load[i], status);
        if (rc != STATUS_OK || !(up[i].exists = up[i].patches >= least_patches))
            break;
        rc = solve_load(&down[i], &flowed, def, def->load[i], status);
    }
    direct_contact_free(&flowed);
    return rc;
}
