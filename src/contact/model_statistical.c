/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The statistical models: asperities of one radius with Gaussian heights, by Hertz's law (GW) or Jackson and Green's
 * (JG) (thesis 4.19-4.38, 4.43-4.46, 4.54). */
#include "contact/gaussian.h"
#include "contact/multiscale.h"
#include "contact/statistical.h"

#include <assert.h>
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

/** The largest relative change of a number of the statistical models (of a separation: over sigma) that JG can make,
 * from the asperities beyond its yield at GW's full contact, where they are most.
 *  - load: JG's is between 0 and 1.08 times Hertz's. u^(3/2) <= sqrt2 (v^(3/2) + y^(3/2)) for u = y + v, y the yield.
 *  - area and radius: JG's grow by at most (u/y)^B <= exp(B v/y), which only shifts the Gaussian.
 * At a given load, or at full contact, d moves by the change over the slope of its logarithm; the resistance takes the
 * slope of Psi at `area`, the largest A/A_n short of full contact. */
static double jg_excess(const struct asperities *surface, const struct model_task *task, double full_d, double area)
{
    static const double highest_d = 40; /* exp(-d²/2) is below the smallest double */
    struct asperity asperity = asperity_make(surface->radius_m, task->pair, ASPERITY_JG);
    double yield = asperity_yield_onset * asperity.critical_interference_m / surface->sigma_s_m;
    if (full_d + yield > highest_d)
        return 0;
    double shift = asperity.area_exponent / yield;
    struct gaussian_integrals all = gaussian_integrals(full_d), beyond = gaussian_integrals(full_d + yield),
                              grown = gaussian_integrals(full_d + yield - shift);
    double load = M_SQRT2 * (beyond.three_halves + yield * sqrt(yield) * beyond.zero) / all.three_halves *
                  exp(beyond.log_factor - all.log_factor);
    double more = (grown.one + yield * grown.zero) / all.one *
                  exp(shift * (shift / 2 - full_d - yield) + grown.log_factor - all.log_factor);
    double change = isnan(more) ? INFINITY : 1.5 * more + load;
    double sigma_s = surface->sigma_s_m / surface->sigma_m;
    if (task->wanted & QUANTITY_BIT(QUANTITY_SEPARATION)) /* beta is twice a separation */
        change =
            fmax(change, 2 * sigma_s * fmax(more * all.one / all.zero, load * all.three_halves / (1.5 * all.half)));
    if (task->wanted &
        (QUANTITY_BIT(QUANTITY_ECR) | QUANTITY_BIT(QUANTITY_TCR))) /* d ln Psi/d ln A = -(3/4) sqrt(A)/(1 - sqrt(A)) */
        change = fmax(change, more + 2 * load + 0.75 * sqrt(area) / (1 - sqrt(area)) * (more + load));
    return change;
}

/** K F_0 over sqrt(R sigma_s) F_1/2 at the lowest load: K over the mean radius of GW. TCR_sd/TCR - 1 is
 * K E[g]/E[a g] with g = a/(a + K), which rises with a, so at most that; as does the mean of g with the load, since a
 * lower d weights larger spots. JG's spots are no smaller than GW's where they carry the same load or less. */
static double statistical_raise(const struct asperities *surface, const struct model_task *task, double d)
{
    struct gaussian_integrals f = gaussian_integrals(d);
    return constriction_make(task->pair).knudsen_length_m * f.zero /
           (sqrt(surface->radius_m * surface->sigma_s_m) * f.half);
}

/** GW, in closed forms. */
static struct statistical closed_gw(const struct model_task *task)
{
    struct statistical model;
    struct status status = {0};
    uint64_t none = 0;
    enum status_code rc =
        statistical_make(&model, task->asperities, task->pair, ASPERITY_HERTZ, 0, 1, INFINITY, &none, &status);
    assert(rc == STATUS_OK && none == 0); /* no quadrature, so nothing is allocated */
    (void)rc;
    return model;
}

static double yield_bound(const struct model_row *row, const struct model_task *task)
{
    (void)row;
    if (!task->asperities)
        return 0;
    struct statistical model = closed_gw(task);
    struct contact_point point = {0};
    double d = 3;
    for (size_t loads = task->load_count; loads > 0 && !statistical_solve(&point, &model, task->loads[loads - 1], &d);)
        loads--;
    return jg_excess(task->asperities, task, model.full_d, point.value[QUANTITY_AREA]);
}

static void yield_reason(char *out, size_t size, double bound, bool runs)
{
    if (runs)
        snprintf(out, size, "asperities beyond 1.9 ωc can change a number by %s%.2g, up to full contact",
                 bound > 1 ? "over " : "up to ", fmin(bound, 1));
    else
        snprintf(out, size, "JG stays within %.2g of GW up to full contact", bound);
}

static enum status_code scale_dependence_bound(double *most, const struct model_row *row, const struct model_task *task,
                                               struct status *status)
{
    static const double jg_load_most = 1.08; /* JG's load over Hertz's, at 1.9 omega_c for nu = 0 */
    (void)status;
    *most = 0;
    if (!task->asperities)
        return STATUS_OK;
    struct statistical model = closed_gw(task);
    struct contact_point point;
    double d = 3;
    if (statistical_solve(&point, &model, row->plastic ? task->loads[0] / jg_load_most : task->loads[0], &d))
        *most = statistical_raise(task->asperities, task, d);
    return STATUS_OK;
}

enum {
    COMPUTES = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_SEPARATION) |
               QUANTITY_BIT(QUANTITY_STIFFNESS) | QUANTITY_BIT(QUANTITY_ADJUSTED) | QUANTITY_RESISTANCES
};
#define TOUCHING_AREA 0.1 /* A/A_n up to which asperities may be taken as apart */

const struct model_row model_gw = {
    .name = "gw",
    .label = "GW",
    .short_label = "GW",
    .family = "statistical",
    .by_default = true,
    .counterpart = &model_multiscale_elastic,
    .asperity_model = &asperity_models[ASPERITY_HERTZ],
    .quantities = COMPUTES,
    .stiffness_step = MODEL_STIFFNESS_STEP,
    .largest_area = TOUCHING_AREA,
    .precedence = 1,
    .thesis_place = 4,
    .in_findings = true,
    .style = "gw",
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
    .scale_dependence_bound = scale_dependence_bound,
};

const struct model_row model_jg = {
    .name = "jg",
    .label = "JG",
    .short_label = "JG",
    .family = "statistical",
    .by_default = true,
    .plastic = true,
    .elastic = &model_gw,
    .counterpart = &model_multiscale_plastic,
    .asperity_model = &asperity_models[ASPERITY_JG],
    .quantities = COMPUTES,
    .stiffness_step = MODEL_STIFFNESS_STEP,
    .largest_area = TOUCHING_AREA,
    .fitted_to = "a/R = 0.41",
    .precedence = 2,
    .thesis_place = 3,
    .in_findings = true,
    .style = "jg",
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
    .scale_dependence_bound = scale_dependence_bound,
};
