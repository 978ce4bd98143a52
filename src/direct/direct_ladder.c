/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_ladder.h"

#include "direct/direct_constriction.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

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
    struct direct_contact_effort effort = {0};
    if (direct_contact_solve(contact, &load, &effort, status) != STATUS_OK)
        return status->code;
    out->exists = true;
    out->quantities = direct_quantities_of(contact, &load);
    if (direct_patches(&out->patches, contact, status) != STATUS_OK)
        return status->code;
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

enum status_code direct_ladder_of_heights(struct direct_point *out, double *rms_m, uint8_t *touching, double *height_m,
                                          size_t n, double spacing_m, const struct direct_ladder_def *def,
                                          const struct direct_team *team, struct status *status)
{
    struct direct_contact contact;
    enum status_code rc = STATUS_OK;
    if (team && team->rank == 0)
        rc = team->call(team, n, spacing_m, def, status);
    if (rc == STATUS_OK)
        rc = direct_contact_make(&contact, team, height_m, n, n, spacing_m, status);
    free(height_m);
    if (rc != STATUS_OK)
        return rc;
    if (rms_m)
        *rms_m = contact.rms_m;
    rc = direct_ladder_run(out, &contact, def, status);
    if (rc == STATUS_OK && touching)
        memcpy(touching, team ? contact.touching : contact.member, n * n); /* of the last solution */
    direct_contact_free(&contact);
    return rc;
}
