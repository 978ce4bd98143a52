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

/** Delta (i+1), in proportion to p* = sqrt2 pi E' Delta f. */
static double steepness(const struct multiscale *stack, size_t i)
{
    return stack->spectrum->amplitude_m[i] * (double)(i + 1);
}

static const double rounding = 1e-9; /* of a pressure by its steepness */

static struct sinusoid_scale make_scale(const struct multiscale *stack, size_t i)
{
    return sinusoid_scale(stack->spectrum->amplitude_m[i], spectrum_frequency(stack->spectrum, i), &stack->pair,
                          stack->plastic);
}

static const struct sinusoid_scale *scale_at(struct multiscale *stack, size_t i)
{
    struct sinusoid_scale *scale = &stack->scales[i];
    if (!(scale->frequency_per_m > 0))
        *scale = make_scale(stack, i);
    return scale;
}

/** The first scale from index i on that may be open at `pressure_Pa`. The pressure rises from scale to scale, so blocks
 * that close below it are skipped. */
static size_t next_open(const struct multiscale *stack, size_t i, double pressure_Pa)
{
    double closed = pressure_Pa * stack->closed_steepness_per_Pa;
    while (i < stack->count && steepness(stack, i) <= closed) {
        i++;
        while (i % MULTISCALE_BLOCK == 0 && i < stack->count &&
               stack->block_closed_Pa[i / MULTISCALE_BLOCK] <= pressure_Pa)
            i += MULTISCALE_BLOCK;
    }
    return i < stack->count ? i : stack->count;
}

/** Fills block_closed_Pa; returns the highest closing pressure of the blocks' steepest scales. Above the ordered
 * pressure the steepest scale closes last. */
static double find_blocks(struct multiscale *stack)
{
    double ordered_Pa = stack->plastic ? sinusoid_ordered_pressure(&stack->pair) : 0, most_Pa = 0;
    for (size_t first = 0; first < stack->count; first += MULTISCALE_BLOCK) {
        size_t steepest = first;
        for (size_t i = first; i < stack->count && i < first + MULTISCALE_BLOCK; i++)
            if (steepness(stack, i) > steepness(stack, steepest))
                steepest = i;
        const struct sinusoid_scale scale =
            make_scale(stack, steepest); /* not stored: saves a page of memory a block */
        double closed_Pa = sinusoid_closed_pressure(&scale);
        stack->block_closed_Pa[first / MULTISCALE_BLOCK] =
            fmin(scale.full_pressure_Pa, fmax(closed_Pa, ordered_Pa)) * (1 + rounding);
        most_Pa = fmax(most_Pa, closed_Pa);
    }
    return most_Pa;
}

/** Fills full_load and closed_load; at least one scale closes at `closed_Pa` or above. */
static void find_loads(struct multiscale *stack, double closed_Pa)
{
    size_t last = 0;
    for (size_t i = 0; (i = next_open(stack, i, closed_Pa)) < stack->count; i++) {
        double own_Pa = sinusoid_closed_pressure(scale_at(stack, i));
        if (own_Pa >= closed_Pa) {
            closed_Pa = own_Pa;
            last = i;
        }
    }
    double full_Pa = stack->count > 0 ? sinusoid_full_area_pressure(scale_at(stack, last)) : 0;
    for (size_t i = 0; (i = next_open(stack, i, full_Pa)) < stack->count; i++) {
        struct sinusoid_cell cell;
        sinusoid_press(&cell, scale_at(stack, i), &sinusoid_fits[SINUSOID_FIT_THESIS], full_Pa, false);
        if (cell.area_complement > 0)
            full_Pa = sinusoid_full_area_pressure(scale_at(stack, i));
    }
    stack->full_load = load_reaching(full_Pa, stack->pair.effective_modulus_Pa);
    stack->closed_load = load_reaching(closed_Pa, stack->pair.effective_modulus_Pa);
}

enum status_code multiscale_make(struct multiscale *out, const struct spectrum *spectrum,
                                 const struct material_pair *pair, bool plastic, enum sinusoid_fit_id closure,
                                 struct status *status)
{
    *out = (struct multiscale){
        .scales = calloc(spectrum->count + 1, sizeof *out->scales),
        .block_closed_Pa = malloc((spectrum->count / MULTISCALE_BLOCK + 1) * sizeof *out->block_closed_Pa),
        .count = spectrum->count,
        .spectrum = spectrum,
        .pair = *pair,
        .plastic = plastic,
        .closure = &sinusoid_fits[closure],
    };
    if (!out->scales || !out->block_closed_Pa) {
        multiscale_free(out);
        return status_memory(status);
    }
    out->closed_steepness_per_Pa =
        (1 - rounding) / sinusoid_full_pressure(1, 1 / spectrum->length_m, pair->effective_modulus_Pa);
    find_loads(out, find_blocks(out));
    return STATUS_OK;
}

void multiscale_free(struct multiscale *stack)
{
    free(stack->scales);
    free(stack->block_closed_Pa);
    *stack = (struct multiscale){0};
}

size_t multiscale_solve(struct contact_point *out, struct multiscale *stack, const struct constriction *spot,
                        unsigned wanted, double load, uint64_t *evaluations)
{
    bool with_gap = wanted & QUANTITY_BIT(QUANTITY_SEPARATION);
    bool conducts = wanted & (QUANTITY_RESISTANCES);
    double nominal_Pa = load * stack->pair.effective_modulus_Pa;
    double area = 1, separation_m = 0;
    size_t clamped = 0;
    struct constriction_sum sum = {0}, last = {0};
    for (size_t i = 0; (i = next_open(stack, i, nominal_Pa / area)) < stack->count; i++) {
        const struct sinusoid_scale *scale = scale_at(stack, i);
        struct sinusoid_cell cell;
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
static size_t closing_scale(struct multiscale *stack, double low, double high, size_t first, size_t end)
{
    const double nominal_Pa[] = {low * stack->pair.effective_modulus_Pa, high * stack->pair.effective_modulus_Pa};
    double area[] = {1, 1};
    for (size_t i = 0; (i = next_open(stack, i, fmin(nominal_Pa[0] / area[0], nominal_Pa[1] / area[1]))) < end; i++) {
        bool complete[2];
        for (int at = 0; at < 2; at++) {
            struct sinusoid_cell cell;
            sinusoid_press(&cell, scale_at(stack, i), stack->closure, nominal_Pa[at] / area[at], false);
            complete[at] = !(cell.area_complement > 0);
            area[at] *= cell.area_ratio;
        }
        if (i >= first && !complete[0] && complete[1])
            return i;
    }
    return end;
}

bool multiscale_closing(struct model_kink *out, struct multiscale *stack, double low, double high)
{
    double open = low;
    size_t k = closing_scale(stack, low, high, 0, stack->count);
    if (k == stack->count)
        return false;
    while (high > open * (1 + 1e-4)) {
        double middle = sqrt(open * high);
        *(closing_scale(stack, low, middle, k, k + 1) == k ? &high : &open) = middle;
    }
    *out = (struct model_kink){high, 1 / scale_at(stack, k)->frequency_per_m};
    return true;
}
