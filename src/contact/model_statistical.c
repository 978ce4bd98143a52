/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The statistical models: asperities of one radius with Gaussian heights, by Hertz's law (GW) or Jackson and Green's
 * (JG) (thesis 4.19-4.38, 4.43-4.46, 4.54). */
#include "contact/multiscale.h"
#include "contact/statistical.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static enum asperity_model_id asperity_model_of(const struct model_row *row)
{
    return (enum asperity_model_id)(row->asperity_model - asperity_models);
}

static enum status_code run(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                            struct status *status)
{
    if (!task->asperities)
        return STATUS_OK;
    struct statistical model;
    if (statistical_make(&model, task->asperities, task->pair, asperity_model_of(row), task->wanted, task->tolerance,
                         INFINITY, &curve->evaluations, status) != STATUS_OK) {
        statistical_free(&model);
        return status->code;
    }
    double d = 3; /* a first guess; the solution of one load starts the next */
    for (size_t i = 0; i < task->load_count; i++) {
        curve->evaluations++;
        if (statistical_solve(&curve->points[curve->count], &model, task->loads[i], &d))
            curve->count++;
    }
    statistical_full(&curve->full, &model);
    if (curve->count < task->load_count)
        curve->points[curve->count++] = curve->full;
    curve->full_load = curve->closed_load = model.full_load;
    curve->beta = model.beta;
    curve->exists = true;
    statistical_free(&model);
    return STATUS_OK;
}

static enum status_code spots(struct contact_spots *out, const struct model_row *row, const struct model_task *task,
                              struct status *status)
{
    struct statistical model;
    uint64_t nodes = 0;
    for (size_t i = 0; i < task->load_count; i++)
        out[i] = (struct contact_spots){NAN, NAN};
    if (!task->asperities)
        return STATUS_OK;
    enum status_code rc = statistical_make(&model, task->asperities, task->pair, asperity_model_of(row), 0,
                                           task->tolerance, INFINITY, &nodes, status);
    struct contact_point point;
    double d = 3;
    for (size_t i = 0; rc == STATUS_OK && i < task->load_count; i++)
        if (statistical_solve(&point, &model, task->loads[i], &d))
            out[i] = statistical_spots(&model, d);
    statistical_free(&model);
    return rc;
}

/** The largest relative change (of a separation: to sigma) that JG makes to GW's numbers at the last load short of full
 * contact, and at full contact: there the most asperities yield, and the farthest. */
static double yield_bound(const struct model_row *row, const struct model_task *task)
{
    struct contact_point points[2][2];
    struct model_curve curve[2] = {{0}, {0}};
    struct status status = {0};
    double most = 0;
    for (size_t last = task->load_count; last > 0; last--) {
        struct model_task at_last = model_task_at(task, task->loads + last - 1, 1);
        at_last.wanted &= ~QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT); /* moves as TCR does */
        at_last.evaluations = NULL;
        for (int side = 0; side < 2; side++) {
            curve[side] = (struct model_curve){.points = points[side]};
            if (model_run(&curve[side], side == 0 ? row->elastic : row, &at_last, &status) != STATUS_OK)
                return INFINITY;
        }
        if (!curve[0].exists)
            return 0;
        if (!curve[1].exists)
            return INFINITY;
        if (task->loads[last - 1] < fmin(curve[0].full_load, curve[1].full_load))
            break;
    }
    if (!curve[1].exists) /* no load was asked for */
        return 0;
    for (int q = 0; q < QUANTITY_COUNT; q++) {
        double elastic = points[0][0].value[q], change = fabs(points[1][0].value[q] - elastic);
        double scale = quantity_rows[q].over_sigma ? task->asperities->sigma_m : elastic;
        if (!isnan(change) && scale > 0)
            most = fmax(most, change / scale);
    }
    return fmax(most, fmax(fabs(curve[1].full_load / curve[0].full_load - 1), fabs(curve[1].beta - curve[0].beta)));
}

static void yield_reason(char *out, size_t size, double bound, bool runs)
{
    if (runs)
        snprintf(out, size, "asperities beyond 1.9 ωc change a number by up to %.2g", bound);
    else
        snprintf(out, size, "JG stays within %.2g of GW up to full contact", bound);
}

enum {
    COMPUTES = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_SEPARATION) |
               QUANTITY_BIT(QUANTITY_ADJUSTED) | QUANTITY_RESISTANCES
};
#define TOUCHING_AREA 0.1 /* A/A_n up to which asperities may be taken as apart */

const struct model_row model_gw = {
    .name = "gw",
    .label = "GW",
    .family = "statistical",
    .by_default = true,
    .counterpart = &model_multiscale_elastic,
    .asperity_model = &asperity_models[ASPERITY_HERTZ],
    .quantities = COMPUTES,
    .largest_area = TOUCHING_AREA,
    .precedence = 1,
    .thesis_place = 4,
    .in_findings = true,
    .colour = "#E58A1F",
    .marker = 4,
    .equations = "4.19-4.30, 4.43, 4.54",
    .source = "Greenwood and Williamson, Proc. R. Soc. A 295 (1966) 300; McCool, Wear 107 (1986) 37",
    .assumes = "asperities of one radius, Gaussian heights, no interaction, no yield",
    .valid = "A/A_n up to 0.1: asperities must not touch each other",
    .method = "closed forms",
    .scale_dependent_method = "Gauss-Legendre panels, since no closed form exists",
    .run = run,
    .spots = spots,
    .scale_dependence_bound = model_scale_dependence,
};

const struct model_row model_jg = {
    .name = "jg",
    .label = "JG",
    .family = "statistical",
    .by_default = true,
    .plastic = true,
    .elastic = &model_gw,
    .counterpart = &model_multiscale_plastic,
    .asperity_model = &asperity_models[ASPERITY_JG],
    .quantities = COMPUTES,
    .largest_area = TOUCHING_AREA,
    .fitted_to = "a/R = 0.41",
    .precedence = 2,
    .thesis_place = 3,
    .in_findings = true,
    .colour = "#B8400A",
    .marker = 5,
    .equations = "4.31-4.38, 4.45-4.46, 4.54",
    .source = "Jackson and Green, J. Tribol. 127 (2005) 343; Jackson and Green, Tribol. Int. 39 (2006) 906",
    .assumes = "as GW, with Jackson and Green's elastic-plastic sphere",
    .valid = "A/A_n up to 0.1; fitted for contact radius / asperity radius up to 0.41",
    .method = "Gauss-Legendre panels split where its law changes",
    .run = run,
    .spots = spots,
    .yield_bound = yield_bound,
    .yield_reason = yield_reason,
    .scale_dependence_bound = model_scale_dependence,
};
