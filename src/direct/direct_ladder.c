/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_ladder.h"

#include "direct/direct_constriction.h"
#include <math.h>

static enum status_code solve_load(struct direct_point *out, struct direct_contact *contact,
                                   const struct direct_ladder_def *def, double mean_pressure, struct status *status)
{
    struct direct_contact_load load = {mean_pressure, def->hardness, def->tolerance, 0, true, def->stop};
    struct direct_contact_effort effort = {0};
    struct direct_patches patches;
    if (direct_contact_solve(contact, &load, &effort, status) != STATUS_OK)
        return status->code;
    out->exists = true;
    out->quantities = direct_quantities_of(contact, &load);
    if (direct_patches_find(&patches, contact, status) != STATUS_OK)
        return status->code;
    out->patches = patches.count;
    out->largest_patch = patches.points[0];
    direct_patches_free(&patches);
    if (def->resistance && direct_constriction_of_contact(&out->constriction_m, contact, sqrt(def->tolerance),
                                                          def->stop, &effort, status) != STATUS_OK)
        return status->code;
    out->convolutions = effort.convolutions;
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

enum status_code direct_ladder_of_heights(struct direct_point *out, uint8_t *touching, const double *height_m, size_t n,
                                          double spacing_m, const struct direct_ladder_def *def,
                                          const struct direct_crew *crew, struct status *status)
{
    struct direct_contact contact = {0};
    if (crew)
        return crew->heights(crew, out, touching, height_m, n, spacing_m, def, status);
    if (direct_contact_make(&contact, height_m, n, n, spacing_m, status) != STATUS_OK)
        return status->code;
    enum status_code rc = direct_ladder_run(out, &contact, def, status);
    for (size_t k = 0; touching && rc == STATUS_OK && k < n * n; k++)
        touching[k] = contact.pressure[k / n * contact.kernel.stride + k % n] > 0;
    direct_contact_free(&contact);
    return rc;
}
