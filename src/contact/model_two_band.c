/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The two-band models: the multiscale stack with two scales of equal elastic energy, elastic and with yield limited by
 * the hardness. What the direct solutions do not bear out is left empty. */
#include "contact/two_band.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum {
    COMPUTES = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_SEPARATION) |
               QUANTITY_RESISTANCES
};

/** What is made of one surface. */
struct prepared {
    bool splits; /* there is an amplitude */
    struct two_band bands;
    struct multiscale stack;
};

static void free_prepared(void *state)
{
    struct prepared *prepared = state;
    multiscale_free(&prepared->stack);
    free(prepared);
}

/** The task's surface, from what is kept or made. release() it. Error: STATUS_MEMORY. */
static enum status_code prepare(struct prepared **out, const struct model_row *row, const struct model_task *task,
                                struct status *status)
{
    struct model_kept_state *kept = model_kept(task, row);
    if (kept && kept->state) {
        *out = kept->state;
        return STATUS_OK;
    }
    struct prepared *prepared = *out = calloc(1, sizeof *prepared);
    if (!prepared)
        return status_memory(status);
    prepared->splits = two_band_split(&prepared->bands, task->spectrum);
    if (prepared->splits &&
        two_band_stack(&prepared->stack, &prepared->bands, task->pair, row->plastic,
                       row->plastic ? task->hardness_Pa : INFINITY, task->sinusoid_fit, status) != STATUS_OK) {
        free(prepared);
        return status->code;
    }
    if (kept)
        *kept = (struct model_kept_state){prepared, free_prepared};
    return STATUS_OK;
}

static void release(struct prepared *prepared, const struct model_row *row, const struct model_task *task)
{
    if (!model_kept(task, row))
        free_prepared(prepared);
}

/** Two scales at every load and at full contact, and the elastic separations. */
static struct model_work work(const struct model_row *row, const struct model_task *task)
{
    uint64_t visits = TWO_BAND_COUNT * (task->load_count + 1);
    bool gap = task->wanted & QUANTITY_BIT(QUANTITY_SEPARATION);
    return (struct model_work){
        .scales = visits,
        .gaps = gap && row->plastic ? visits : 0,
        .constrictions = task->wanted & QUANTITY_RESISTANCES ? visits : 0,
        .separations = gap && !row->plastic ? task->load_count : 0,
    };
}

/** Takes out what should not be trusted at this point. */
static void blank(struct contact_point *point, const struct model_row *row, const struct model_task *task)
{
    double pressure_Pa = point->load * task->pair->effective_modulus_Pa;
    if (!two_band_trusted(point->area_ratio))
        point->separation_m = point->ecr_ohm_m2 = point->tcr_K_m2_per_W = point->tcr_sd_K_m2_per_W = NAN;
    if (row->plastic && !two_band_plastic_gap_trusted(point->area_ratio, pressure_Pa, task->hardness_Pa))
        point->separation_m = NAN;
}

/** Barber's integral in place of the elastic gaps, which light loads know less well. */
static enum status_code elastic_separation(struct model_curve *curve, struct multiscale *stack,
                                           const struct model_task *task, struct status *status)
{
    double *separation_m = malloc(task->load_count * sizeof *separation_m);
    uint64_t visits = 0; /* as many as the tolerance takes; the plan counts loads */
    if (!separation_m)
        return status_memory(status);
    two_band_separation(separation_m, task->loads, task->load_count, stack, task->tolerance, &visits);
    for (size_t i = 0; i < task->load_count; i++)
        curve->points[i].separation_m = separation_m[i];
    curve->work.separations = task->load_count;
    free(separation_m);
    return STATUS_OK;
}

static enum status_code run(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                            struct status *status)
{
    struct prepared *prepared;
    struct constriction constriction = constriction_make(task->pair);
    uint64_t visits = 0;
    unsigned gap = task->wanted & QUANTITY_BIT(QUANTITY_SEPARATION),
             wanted = row->plastic ? task->wanted : task->wanted & ~gap;
    if (prepare(&prepared, row, task, status) != STATUS_OK)
        return status->code;
    struct multiscale *stack = &prepared->stack;
    if (!prepared->splits) {
        curve->work = work(row, task); /* as predicted, which knows no amplitudes */
        release(prepared, row, task);
        return STATUS_OK;
    }
    for (size_t i = 0; i < task->load_count; i++)
        curve->clamped += multiscale_solve(&curve->points[i], stack, &constriction, wanted, task->loads[i], &visits);
    multiscale_solve(&curve->full, stack, &constriction, wanted, stack->full_load, &visits);
    enum status_code rc = STATUS_OK;
    curve->work = (struct model_work){
        .scales = visits,
        .gaps = wanted & gap ? visits : 0,
        .constrictions = wanted & QUANTITY_RESISTANCES ? visits : 0,
    };
    if (!row->plastic && gap)
        rc = elastic_separation(curve, stack, task, status);
    for (size_t i = 0; i < task->load_count; i++)
        blank(&curve->points[i], row, task);
    blank(&curve->full, row, task);
    curve->count = task->load_count;
    curve->full_load = stack->full_load;
    curve->yielding_scales = stack->critical_scales;
    curve->exists = true;
    release(prepared, row, task);
    return rc;
}

/** p_c over p* of the steeper band, inverted, where it yields before it is complete; else 0. */
static double yield_bound(const struct model_row *row, const struct model_task *task)
{
    struct two_band bands;
    double most = 0;
    (void)row;
    bool splits = two_band_split(&bands, task->spectrum);
    for (int b = 0; splits && b < TWO_BAND_COUNT; b++) {
        struct sinusoid_scale scale = sinusoid_scale(bands.amplitude_m[b], bands.frequency_per_m[b], task->pair, true);
        most = fmax(most, scale.full_pressure_Pa / scale.critical_pressure_Pa);
    }
    return most > 1 ? most : 0;
}

static void yield_reason(char *out, size_t size, double bound, bool runs)
{
    if (runs)
        snprintf(out, size, "a band yields at %.3g p*", 1 / bound);
    else
        snprintf(out, size, "neither band yields before it is complete");
}

/** Two scales are quick: every load. */
static enum status_code scale_dependence_bound(double *most, uint64_t *visits, const struct model_row *row,
                                               const struct model_task *task, struct status *status)
{
    struct prepared *prepared;
    struct constriction constriction = constriction_make(task->pair);
    *most = 0;
    if (prepare(&prepared, row, task, status) != STATUS_OK)
        return status->code;
    for (size_t i = 0; prepared->splits && i < task->load_count; i++) {
        struct contact_point point;
        multiscale_solve(&point, &prepared->stack, &constriction, QUANTITY_RESISTANCES, task->loads[i], visits);
        if (point.tcr_K_m2_per_W > 0)
            *most = fmax(*most, point.tcr_sd_K_m2_per_W / point.tcr_K_m2_per_W - 1);
    }
    release(prepared, row, task);
    return STATUS_OK;
}

const struct model_row model_two_band_elastic = {
    .name = "two-band-elastic",
    .label = "two-band elastic",
    .short_label = "2B el.",
    .family = "two-band",
    .family_title = "Two bands",
    .by_default = true,
    .quantities = COMPUTES,
    .may_be_empty = COMPUTES & ~(QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA)),
    .precedence = 5,
    .style = "te",
    .colour = "#35A27B",
    .marker = 8,
    .equations = "two bands; 4.3-4.11, 4.40-4.42",
    .source =
        "Jackson and Streator, Wear 261 (2006) 1337, with two scales of equal elastic energy; separation: Barber, "
        "Proc. R. Soc. A 459 (2003) 53",
    .assumes = "isotropic Gaussian surface; two scales, each with half of the energy of flattening it; no yield",
    .valid = "area at A/A_n from 0.001 on within a factor 0.5 to 1.3 of direct solutions, separation and resistance up "
             "to A/A_n = 0.75 (empty beyond); not for a single wave",
    .method = "direct sum over two scales; separation by adaptive quadrature",
    .work = work,
    .run = run,
    .scale_dependence_bound = scale_dependence_bound,
};

const struct model_row model_two_band_plastic = {
    .name = "two-band-plastic",
    .label = "two-band elastic-plastic",
    .short_label = "2B pl.",
    .family = "two-band",
    .family_title = "Two bands",
    .by_default = true,
    .plastic = true,
    .elastic = &model_two_band_elastic,
    .quantities = COMPUTES,
    .may_be_empty = COMPUTES & ~(QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA)),
    .precedence = 6,
    .style = "tp",
    .colour = "#137A56",
    .marker = 9,
    .equations = "two bands; 4.12-4.18, 4.40-4.42",
    .source = "Krithivasan and Jackson, Tribol. Lett. 27 (2007) 31, with two scales of equal elastic energy and the "
              "contact pressure limited by the hardness",
    .assumes = "as two-band elastic, with yield; a yielding scale carries at most the hardness; no hardening",
    .valid = "area and resistance within a factor 0.56 to 1.31 of direct solutions with the same hardness; separation "
             "up to a quarter of the hardness, both up to A/A_n = 0.75 (empty beyond)",
    .method = "direct sum over two scales",
    .work = work,
    .run = run,
    .yield_bound = yield_bound,
    .yield_reason = yield_reason,
    .scale_dependence_bound = scale_dependence_bound,
};
