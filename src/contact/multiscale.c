/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/multiscale.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

/** The load P/(A_n E') whose pressure is at least `pressure_Pa` through rounding: an ulp short of it contact is not
 * full. */
static double load_reaching(double pressure_Pa, double effective_modulus_Pa)
{
    double load = pressure_Pa / effective_modulus_Pa;
    while (load * effective_modulus_Pa < pressure_Pa)
        load = nextafter(load, INFINITY);
    return load;
}

/** First scale of the k+1-th border's block: blocks grow by a sixteenth, so that a load visits few scales more than it
 * has to, and few borders are tested. */
static size_t next_border(size_t border)
{
    return border + 1 + border / 16;
}

/** Delta (i+1), in proportion to p* = sqrt2 pi E' Delta f. */
static double steepness(const struct spectrum *spectrum, size_t i)
{
    return spectrum->amplitude_m[i] * (double)(i + 1);
}

/** p* of a scale that steep. */
static double full_pressure(const struct multiscale *stack, double steepness)
{
    return sinusoid_full_pressure(steepness, 1 / stack->spectrum->length_m, stack->effective_modulus_Pa);
}

static struct sinusoid_scale make_scale(const struct multiscale *stack, size_t i)
{
    return sinusoid_scale(stack->spectrum->amplitude_m[i], spectrum_frequency(stack->spectrum, i), &stack->pair,
                          stack->plastic);
}

/** Fills closing_Pa; returns the largest steepness. */
static double find_borders(struct multiscale *stack)
{
    double most = 0;
    for (size_t first = 0; first < stack->count; first = next_border(first)) {
        size_t end = next_border(first) < stack->count ? next_border(first) : stack->count;
        double block = 0;
        for (size_t i = first; i < end; i++) {
            double own = steepness(stack->spectrum, i);
            block = own > block ? own : block;
        }
        assert(stack->borders < MULTISCALE_BORDERS_MOST);
        stack->closing_Pa[stack->borders++] = block;
    }
    for (size_t k = stack->borders; k-- > 0;) {
        most = fmax(most, stack->closing_Pa[k]);
        stack->closing_Pa[k] = sinusoid_closing_bound(full_pressure(stack, most), &stack->pair, stack->plastic);
    }
    return most;
}

/** Raises the pressures of full contact and of no gap to those of a scale. */
static void raise_full(double *full_Pa, double *closed_Pa, const struct sinusoid_scale *scale)
{
    double closed = sinusoid_closed_pressure(scale);
    *closed_Pa = fmax(*closed_Pa, closed);
    if (!(closed > *full_Pa)) /* it cannot be the last to fill */
        return;
    struct sinusoid_cell cell = {.area_complement = 1};
    if (*full_Pa > 0)
        sinusoid_press(&cell, scale, &sinusoid_fits[SINUSOID_FIT_THESIS], *full_Pa, false);
    if (cell.area_complement > 0)
        *full_Pa = fmax(*full_Pa, sinusoid_full_area_pressure(scale));
}

static void set_loads(struct multiscale *stack, double full_Pa, double closed_Pa)
{
    stack->full_load = load_reaching(full_Pa, stack->effective_modulus_Pa);
    stack->closed_load = load_reaching(closed_Pa, stack->effective_modulus_Pa);
}

void multiscale_make(struct multiscale *out, const struct spectrum *spectrum, const struct material_pair *pair,
                     bool plastic, enum sinusoid_fit_id closure)
{
    static const double rounding = 1e-9;
    *out = (struct multiscale){
        .count = spectrum->count,
        .spectrum = spectrum,
        .pair = *pair,
        .plastic = plastic,
        .closure = &sinusoid_fits[closure],
        .effective_modulus_Pa = pair->effective_modulus_Pa,
    };
    double most = find_borders(out), unit_Pa = full_pressure(out, 1), full_Pa = 0, closed_Pa = 0;
    bool steepest = !plastic || sinusoid_steepest_fills_last(most * unit_Pa, pair);
    double least = steepest ? most * (1 - rounding) : 0;
    double critical = plastic ? sinusoid_critical_full_pressure(pair) / unit_Pa : INFINITY;
    for (size_t i = 0; i < out->count; i++) {
        double own = steepness(spectrum, i);
        if (own < least && !(own > critical * (1 - rounding)))
            continue;
        bool clear = own > critical * (1 + rounding);
        if (own < least && clear) {
            out->critical_scales++;
            continue;
        }
        struct sinusoid_scale scale = make_scale(out, i);
        out->critical_scales += isfinite(scale.critical_pressure_Pa);
        if (own >= least)
            raise_full(&full_Pa, &closed_Pa, &scale);
    }
    set_loads(out, full_Pa, closed_Pa);
}

void multiscale_complete(struct multiscale *stack)
{
    double full_Pa = 0, closed_Pa = 0;
    stack->critical_scales = 0;
    for (size_t i = 0; i < stack->count; i++) {
        stack->critical_scales += isfinite(stack->scales[i].critical_pressure_Pa);
        raise_full(&full_Pa, &closed_Pa, &stack->scales[i]);
    }
    set_loads(stack, full_Pa, closed_Pa);
}

void multiscale_free(struct multiscale *stack)
{
    free(stack->scales);
    *stack = (struct multiscale){0};
}

struct sinusoid_scale multiscale_scale(struct multiscale *stack, size_t i)
{
    if (i < stack->made)
        return stack->scales[i];
    struct sinusoid_scale scale = make_scale(stack, i);
    if (i > stack->made)
        return scale;
    if (stack->made == stack->room) {
        size_t room = stack->room ? 2 * stack->room : 64;
        struct sinusoid_scale *scales = reallocarray(stack->scales, room, sizeof *scales);
        if (!scales)
            return scale; /* it will be made again */
        stack->scales = scales;
        stack->room = room;
    }
    stack->scales[stack->made++] = scale;
    return scale;
}

size_t multiscale_solve(struct contact_point *out, struct multiscale *stack, const struct constriction *spot,
                        unsigned wanted, double load, uint64_t *evaluations)
{
    bool with_gap = wanted & QUANTITY_BIT(QUANTITY_SEPARATION);
    bool conducts = wanted & (QUANTITY_RESISTANCES);
    double nominal_Pa = load * stack->effective_modulus_Pa;
    double area = 1, separation = 0;
    size_t clamped = 0, i = 0, border = 0, borders = 0;
    struct constriction_sum sum = {0};
    for (; i < stack->count; i++) {
        if (i == border && borders < stack->borders) {
            if (nominal_Pa / area > stack->closing_Pa[borders++])
                break;
            border = next_border(border);
        }
        const struct sinusoid_scale scale = multiscale_scale(stack, i);
        struct sinusoid_cell cell;
        sinusoid_press(&cell, &scale, stack->closure, nominal_Pa / area, with_gap);
        clamped += cell.limited;
        if (with_gap)
            separation += scale.amplitude_m * cell.gap_ratio;
        if (conducts && cell.area_complement > 0)
            constriction_add_scale(&sum, cell.area_ratio, cell.area_complement, scale.frequency_per_m, area);
        area *= cell.area_ratio;
    }
    *evaluations += i;
    *out = (struct contact_point){
        .load = load,
        .area_ratio = area,
        .separation_m = with_gap ? separation : NAN,
        .adjusted_m = NAN,
        .ecr_ohm_m2 = wanted & QUANTITY_BIT(QUANTITY_ECR) ? constriction_electrical(spot, &sum) : NAN,
        .tcr_K_m2_per_W = wanted & QUANTITY_BIT(QUANTITY_TCR) ? constriction_thermal(spot, &sum) : NAN,
        .tcr_sd_K_m2_per_W = wanted & QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT)
                                 ? constriction_thermal_scale_dependent(spot, &sum)
                                 : NAN,
    };
    return clamped;
}

uint64_t multiscale_visits(struct multiscale *stack, const double *loads, size_t count)
{
    static const struct constriction none = {0};
    struct contact_point point;
    uint64_t visits = 0;
    for (size_t i = 0; i <= count; i++)
        multiscale_solve(&point, stack, &none, 0, i < count ? loads[i] : stack->full_load, &visits);
    return visits;
}
