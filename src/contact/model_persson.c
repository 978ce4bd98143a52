/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Persson's theory as a model: elastic, at any load. */
#include "contact/model.h"

#include "contact/persson.h"
#include <math.h>

static enum status_code run(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                            struct status *status)
{
    struct persson persson;
    (void)row;
    bool beyond_area =
        task->wanted & (QUANTITY_BIT(QUANTITY_SEPARATION) | QUANTITY_BIT(QUANTITY_ECR) | QUANTITY_BIT(QUANTITY_TCR));
    if (persson_make(&persson, task->spectrum, persson_energy_factor, status) != STATUS_OK)
        return status->code;
    curve->exists = persson.m2 > 0;
    for (size_t i = 0; i < task->load_count && curve->exists; i++) {
        struct contact_point *point = &curve->points[curve->count++];
        struct persson_separation at = {NAN, NAN};
        *point = quantity_nothing();
        point->value[QUANTITY_LOAD] = task->loads[i];
        point->value[QUANTITY_AREA] = persson_area(task->loads[i], persson.m2, persson_energy_factor);
        if (beyond_area)
            at = persson_separation(&persson, task->loads[i]);
        if (task->wanted & QUANTITY_BIT(QUANTITY_SEPARATION))
            point->value[QUANTITY_SEPARATION] = at.separation_m;
        if (task->wanted & QUANTITY_BIT(QUANTITY_ECR))
            point->value[QUANTITY_ECR] = task->pair->resistivity_ohm_m * at.constriction_m;
        if (task->wanted & QUANTITY_BIT(QUANTITY_TCR))
            point->value[QUANTITY_TCR] = at.constriction_m / task->pair->conductivity_W_per_mK;
    }
    /* complete only in the limit of an infinite load: there is no point of full contact */
    curve->evaluations = task->load_count;
    persson_free(&persson);
    return STATUS_OK;
}

const struct model_row model_persson = {
    .name = "persson",
    .label = "Persson",
    .short_label = "Persson",
    .family = "persson",
    .quantities = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_SEPARATION) |
                  QUANTITY_BIT(QUANTITY_ECR) | QUANTITY_BIT(QUANTITY_TCR),
    .style = "pe",
    .colour = "#9467BD",
    .marker = 12,
    .equations = "Persson",
    .source =
        "Persson, J. Chem. Phys. 115 (2001) 3840; Yang and Persson, J. Phys.: Condens. Matter 20 (2008) 215214; "
        "Almqvist, Campana, Prodanov and Persson, J. Mech. Phys. Solids 59 (2011) 2355; resistance: Barber, Proc. "
        "R. Soc. A 459 (2003) 53",
    .assumes = "isotropic Gaussian surface; no yield",
    .valid = "any area ratio: area within a factor 0.4 to 1.2, separation 0.7 to 1.4 of direct solutions",
    .method = "closed form for the area; grouped sum over rings for the separation",
    .run = run,
};
