/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The statistical models: asperities of one radius with Gaussian heights, elastic (GW) or elastic-plastic (JG) (thesis
 * 4.19-4.38, 4.43-4.46, 4.54). */
#include "contact/multiscale.h"
#include "contact/statistical.h"

#include <math.h>

static enum status_code run(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                            struct status *status)
{
    if (!task->asperities)
        return STATUS_OK;
    struct statistical model;
    if (statistical_make(&model, task, row->plastic, INFINITY, status) != STATUS_OK) {
        statistical_free(&model);
        return status->code;
    }
    curve->evaluations += model.panels.count;
    double d = 3; /* first guess; then the last solution */
    for (size_t i = 0; i < task->load_count; i++) {
        curve->evaluations++;
        if (statistical_solve(&curve->points[curve->count], &model, task->loads[i], &d))
            curve->count++;
    }
    statistical_full(&curve->full, &model);
    if (curve->count < task->load_count)
        curve->points[curve->count++] = curve->full;
    curve->full_load = model.full_load;
    curve->beta = model.beta;
    curve->exists = true;
    statistical_free(&model);
    return STATUS_OK;
}

static enum status_code spots(struct contact_spots *out, const struct model_row *row, const struct model_task *task,
                              struct status *status)
{
    struct statistical model;
    struct model_task spots_alone = *task;
    spots_alone.wanted = 0;
    for (size_t i = 0; i < task->load_count; i++)
        out[i] = (struct contact_spots){NAN, NAN};
    if (!task->asperities)
        return STATUS_OK;
    enum status_code rc = statistical_make(&model, &spots_alone, row->plastic, INFINITY, status);
    struct contact_point point;
    double d = 3;
    for (size_t i = 0; rc == STATUS_OK && i < task->load_count; i++)
        if (statistical_solve(&point, &model, task->loads[i], &d))
            out[i] = statistical_spots(&model, d);
    statistical_free(&model);
    return rc;
}

enum { COMPUTES = QUANTITY_USUAL | QUANTITY_BIT(QUANTITY_ADJUSTED) | QUANTITY_RESISTANCES };
#define TOUCHING_AREA 0.1 /* A/A_n up to which asperities are apart */

const struct model_row model_gw = {
    .name = "gw",
    .label = "GW",
    .family = "statistical",
    .counterpart = &model_multiscale_elastic,
    .sums_asperities = true,
    .quantities = COMPUTES,
    .stiffness_step = MODEL_STIFFNESS_STEP,
    .largest_area = TOUCHING_AREA,
    .precedence = 1,
    .thesis_place = 4,
    .in_findings = true,
    .colour = "#E58A1F",
    .marker = 4,
    .does = "presses asperities of one radius and Gaussian heights, without yield",
    .equations = "A/Aₙ = πηRσₛ F₁(d/σₛ), P/(AₙE′) = (4/3) ηR^(1/2)σₛ^(3/2) F₁.₅(d/σₛ) (4.19-4.30, 4.43, 4.54)",
    .source = "Greenwood and Williamson, Proc. R. Soc. A 295 (1966) 300; McCool, Wear 107 (1986) 37",
    .assumes = "asperities of one radius, Gaussian heights, no interaction, no yield",
    .valid = "A/A_n up to 0.1: asperities must not touch each other",
    .method = "closed forms",
    .run = run,
    .spots = spots,
};

const struct model_row model_jg = {
    .name = "jg",
    .label = "JG",
    .family = "statistical",
    .plastic = true,
    .elastic = &model_gw,
    .counterpart = &model_multiscale_plastic,
    .sums_asperities = true,
    .quantities = COMPUTES,
    .stiffness_step = MODEL_STIFFNESS_STEP,
    .largest_area = TOUCHING_AREA,
    .precedence = 2,
    .thesis_place = 3,
    .in_findings = true,
    .colour = "#B8400A",
    .marker = 5,
    .does = "presses asperities of one radius and Gaussian heights, and lets them yield",
    .equations =
        "as GW; asperities pressed by ω over 1.9 ω_c have the area πRω(ω/1.9ω_c)^B (4.31-4.38, 4.45-4.46, 4.54)",
    .source = "Jackson and Green, J. Tribol. 127 (2005) 343; Jackson and Green, Tribol. Int. 39 (2006) 906",
    .assumes = "as GW, with Jackson and Green's elastic-plastic sphere",
    .valid = "A/A_n up to 0.1; fitted for contact radius / asperity radius up to 0.41",
    .method = "Gauss-Legendre panels split where its law changes",
    .run = run,
    .spots = spots,
};
