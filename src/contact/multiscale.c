/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/multiscale.h"

#include <math.h>
#include <stdlib.h>

/** P/(A_n E') at a pressure, rounded up: one ulp below, contact is not full. */
static double load_reaching(double pressure_Pa, double effective_modulus_Pa)
{
    double load = pressure_Pa / effective_modulus_Pa;
    while (load * effective_modulus_Pa < pressure_Pa)
        load = nextafter(load, INFINITY);
    return load;
}

static void find_loads(struct multiscale *stack)
{
    const struct sinusoid_scale *scale = stack->scales;
    double closed_Pa = 0;
    size_t last = 0;
    for (size_t i = 0; i < stack->count; i++)
        if (sinusoid_closed_pressure(&scale[i]) >= closed_Pa)
            closed_Pa = sinusoid_closed_pressure(&scale[last = i]);
    double full_Pa = stack->count > 0 ? sinusoid_full_area_pressure(&scale[last]) : 0;
    for (size_t i = 0; i < stack->count; i++) {
        struct sinusoid_cell cell;
        sinusoid_press(&cell, &scale[i], &sinusoid_fits[SINUSOID_FIT_THESIS], full_Pa, false);
        if (cell.area_complement > 0)
            full_Pa = sinusoid_full_area_pressure(&scale[i]);
    }
    stack->full_load = load_reaching(full_Pa, stack->pair.effective_modulus_Pa);
    stack->closed_load = load_reaching(closed_Pa, stack->pair.effective_modulus_Pa);
}

enum status_code multiscale_make(struct multiscale *out, const struct spectrum *spectrum,
                                 const struct material_pair *pair, bool plastic, enum sinusoid_fit_id closure,
                                 struct status *status)
{
    *out = (struct multiscale){
        .scales = malloc((spectrum->count + 1) * sizeof *out->scales),
        .count = spectrum->count,
        .pair = *pair,
        .closure = &sinusoid_fits[closure],
    };
    if (!out->scales)
        return status_memory(status);
    for (size_t i = 0; i < out->count; i++)
        out->scales[i] = sinusoid_scale(spectrum->amplitude_m[i], spectrum_frequency(spectrum, i), pair, plastic);
    find_loads(out);
    return STATUS_OK;
}

void multiscale_free(struct multiscale *stack)
{
    free(stack->scales);
    *stack = (struct multiscale){0};
}

size_t multiscale_solve(struct contact_point *out, const struct multiscale *stack, const struct constriction *spot,
                        unsigned wanted, double load, uint64_t *evaluations)
{
    bool with_gap = wanted & QUANTITY_BIT(QUANTITY_SEPARATION);
    bool conducts = wanted & (QUANTITY_RESISTANCES);
    double nominal_Pa = load * stack->pair.effective_modulus_Pa;
    double area = 1, separation_m = 0;
    size_t clamped = 0;
    struct constriction_sum sum = {0}, last = {0};
    for (const struct sinusoid_scale *scale = stack->scales; scale < stack->scales + stack->count; scale++) {
        struct sinusoid_cell cell;
        if (sinusoid_closed_pressure(scale) < nominal_Pa / area) /* changes nothing */
            continue;
        sinusoid_press(&cell, scale, stack->closure, nominal_Pa / area, with_gap); /* p_i = P/A_{i-1} (4.2) */
        if (with_gap)
            separation_m += scale->amplitude_m * cell.gap_ratio; /* (4.11*) */
        if (conducts && cell.area_complement > 0) {
            last = (struct constriction_sum){0};
            constriction_add_scale(&last, cell.area_ratio, cell.area_complement, scale->frequency_per_m, area);
            sum.by_radius += last.by_radius; /* scales in series (4.42*) */
            sum.by_radius_squared += last.by_radius_squared;
        }
        area *= cell.area_ratio; /* A_i = a_i A_{i-1} (4.1) */
        clamped += cell.limited;
        ++*evaluations;
    }
    *out = quantity_nothing();
    out->value[QUANTITY_LOAD] = load;
    out->value[QUANTITY_AREA] = area;
    if (with_gap)
        out->value[QUANTITY_SEPARATION] = separation_m;
    if (wanted & QUANTITY_BIT(QUANTITY_ECR))
        out->value[QUANTITY_ECR] = constriction_electrical(spot, &sum);
    if (wanted & QUANTITY_BIT(QUANTITY_ECR_LAST_SCALE))
        out->value[QUANTITY_ECR_LAST_SCALE] = constriction_electrical(spot, &last);
    if (wanted & QUANTITY_BIT(QUANTITY_TCR))
        out->value[QUANTITY_TCR] = constriction_thermal(spot, &sum);
    if (wanted & QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT))
        out->value[QUANTITY_TCR_SCALE_DEPENDENT] = constriction_thermal_scale_dependent(spot, &sum);
    return clamped;
}

/** The first of the scales `first` to `end` - 1 that is open at the load `low` and complete at `high`; `end`: none. */
static size_t closing_scale(const struct multiscale *stack, double low, double high, size_t first, size_t end)
{
    const double nominal_Pa[] = {low * stack->pair.effective_modulus_Pa, high * stack->pair.effective_modulus_Pa};
    double area[] = {1, 1};
    for (size_t i = 0; i < end; i++) {
        bool complete[2];
        for (int at = 0; at < 2; at++) {
            struct sinusoid_cell cell;
            sinusoid_press(&cell, &stack->scales[i], stack->closure, nominal_Pa[at] / area[at], false);
            complete[at] = !(cell.area_complement > 0);
            area[at] *= cell.area_ratio;
        }
        if (i >= first && !complete[0] && complete[1])
            return i;
    }
    return end;
}

bool multiscale_closing(struct model_kink *out, const struct multiscale *stack, double low, double high)
{
    double open = low;
    size_t k = closing_scale(stack, low, high, 0, stack->count);
    if (k == stack->count)
        return false;
    while (high > open * (1 + 1e-4)) {
        double middle = sqrt(open * high);
        *(closing_scale(stack, low, middle, k, k + 1) == k ? &high : &open) = middle;
    }
    *out = (struct model_kink){high, 1 / stack->scales[k].frequency_per_m};
    return true;
}
