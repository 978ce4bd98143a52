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
