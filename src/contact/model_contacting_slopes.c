/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacting slopes as a model: elastic, of a surface whose heights need not be Gaussian. */
#include "contact/model.h"

#include <math.h>

enum {
    AREA = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA),
    BEYOND_AREA = QUANTITY_BIT(QUANTITY_SEPARATION) | QUANTITY_BIT(QUANTITY_ECR) | QUANTITY_BIT(QUANTITY_TCR)
};

static void solve(struct contact_point *out, const struct contacting_slopes *slopes, const struct persson *persson,
                  const struct model_task *task, double load)
{
    struct contacting_slopes_area area = contacting_slopes_area(slopes, load);
    struct contacting_slopes_gap gap = {NAN, NAN, NAN, NAN};
    if (task->wanted & BEYOND_AREA)
        (void)contacting_slopes_gap(&gap, slopes, persson, load, area.area_ratio); /* false: nothing to show */
    double resistance_m = 2 * gap.constriction_m;                                  /* (rho_1 + rho_2) l = 2 rho l */
    *out = quantity_nothing();
    out->value[QUANTITY_LOAD] = load;
    out->value[QUANTITY_AREA] = area.area_ratio;
    if (task->wanted & QUANTITY_BIT(QUANTITY_SEPARATION))
        out->value[QUANTITY_SEPARATION] = gap.separation_m;
    if (task->wanted & QUANTITY_BIT(QUANTITY_ECR))
        out->value[QUANTITY_ECR] = task->pair->resistivity_ohm_m * resistance_m;
    if (task->wanted & QUANTITY_BIT(QUANTITY_TCR))
        out->value[QUANTITY_TCR] = resistance_m / task->pair->conductivity_W_per_mK;
    out->beyond_fit = area.mark == CONTACTING_SLOPES_INSIDE ? 0 : 1;
}

static enum status_code run(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                            struct status *status)
{
    struct contacting_slopes slopes;
    struct persson persson;
    struct status none = {0};
    (void)row;
    if (task->point_count == 0)
        return STATUS_OK;
    curve->evaluations = task->load_count;
    enum status_code rc =
        contacting_slopes_make(&slopes, task->points, task->point_count, persson_energy_factor, &none);
    if (rc != STATUS_OK)
        return rc == STATUS_MEMORY ? status_memory(status) : STATUS_OK; /* too few points: no curve */
    if (persson_make(&persson, task->spectrum, persson_energy_factor, status) != STATUS_OK) {
        contacting_slopes_free(&slopes);
        return status->code;
    }
    for (size_t i = 0; i < task->load_count; i++)
        solve(&curve->points[curve->count++], &slopes, &persson, task, task->loads[i]);
    curve->exists = true; /* the lowest point touches last, at a load that is not known */
    persson_free(&persson);
    contacting_slopes_free(&slopes);
    return STATUS_OK;
}

const struct model_row model_contacting_slopes = {
    .name = "contacting-slopes",
    .label = "contacting slopes",
    .short_label = "slopes",
    .family = "contacting-slopes",
    .by_default = true,
    .uses_heights = true,
    .quantities = AREA | BEYOND_AREA,
    .may_be_empty = BEYOND_AREA,
    .style = "cs",
    .colour = "#B5477B",
    .marker = 10,
    .equations = "contacting slopes",
    .source =
        "area by the slope averaged over the contact: Müser and Wang, Lubricants 6 (2018) 85, which the highest "
        "points predict; separation: Persson, Phys. Rev. Lett. 99 (2007) 125502; resistance: Barber, Proc. R. Soc. A "
        "459 (2003) 53",
    .assumes = "isotropic surface of any height distribution, known from the scan's points; no yield",
    .valid = "area at any load within a factor 0.7 to 1.3 of direct solutions of skewed surfaces, separation and "
             "resistance up to A/A_n = 0.15 (empty beyond); dashed where fewer than 30 points touch",
    .method = "one sort; separation by Persson's sum",
    .run = run,
};
