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
