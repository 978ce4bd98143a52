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

/** Relative slack of comparisons by steepness in place of pressures, which are rounded otherwise. */
static const double rounding = 1e-9;

/** Delta (i+1), in proportion to p* = sqrt2 pi E' Delta f. */
static double steepness(const struct spectrum *spectrum, size_t i)
{
    return spectrum->amplitude_m[i] * (double)(i + 1);
}

/** The steepest scale of group `at` of a level; level 0 are the scales themselves. */
static double steepest(const struct multiscale *stack, size_t level, size_t at)
{
    return level == 0 ? steepness(stack->spectrum, at) : stack->steepest[level - 1][at];
}

static size_t groups(size_t count)
{
    return (count + MULTISCALE_GROUP - 1) / MULTISCALE_GROUP;
}

/** Fills steepest[]; returns the steepness of the steepest scale. */
static double find_steepest(struct multiscale *stack)
{
    size_t room = 0, size = stack->count;
    double most = 0;
    for (size_t n = size; n > 1; n = groups(n))
        room += groups(n);
    stack->steepest[0] = malloc((room ? room : 1) * sizeof *stack->steepest[0]);
    for (size_t level = 0; stack->steepest[0] && size > 1; level++) {
        for (size_t group = 0; group < groups(size); group++) {
            size_t end = (group + 1) * MULTISCALE_GROUP < size ? (group + 1) * MULTISCALE_GROUP : size;
            double of_group = 0;
            for (size_t at = group * MULTISCALE_GROUP; at < end; at++) {
                double own = steepest(stack, level, at);
                of_group = own > of_group ? own : of_group;
            }
            stack->steepest[level][group] = of_group;
        }
        size = groups(size);
        assert(level + 1 < MULTISCALE_LEVELS);
        stack->steepest[level + 1] = stack->steepest[level] + size;
        stack->levels = level + 1;
    }
    for (size_t at = 0; at < size; at++)
        most = fmax(most, steepest(stack, stack->levels, at));
    return most;
}

/** The first scale from index i on that is steeper than `than`; the count when there is none. Goes up to ever larger
 * groups while none of theirs is, then down to the one. */
static size_t next_steeper(const struct multiscale *stack, size_t i, double than)
{
    size_t level = 0, size = stack->count, at = i;
    for (; at < size && !(steepest(stack, level, at) > than); at++)
        while (level < stack->levels && (at + 1) % MULTISCALE_GROUP == 0) {
            at /= MULTISCALE_GROUP;
            size = groups(size);
            level++;
        }
    if (at >= size)
        return stack->count;
    for (; level > 0; level--)
        for (at *= MULTISCALE_GROUP; !(steepest(stack, level - 1, at) > than);)
            at++;
    return at;
}

static struct sinusoid_scale make_scale(const struct multiscale *stack, size_t i)
{
    return sinusoid_scale(stack->spectrum->amplitude_m[i], spectrum_frequency(stack->spectrum, i), &stack->pair,
                          stack->plastic);
}

/** How many scales have Delta > Delta_c, whose steepness is `critical`. */
static size_t count_critical(const struct multiscale *stack, double critical)
{
    size_t count = 0;
    for (size_t i = 0; i < stack->count; i++) {
        double own = steepness(stack->spectrum, i);
        if (own > critical * (1 - rounding))
            count += own > critical * (1 + rounding) || isfinite(make_scale(stack, i).critical_pressure_Pa);
    }
    return count;
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
    *out = (struct multiscale){
        .count = spectrum->count,
        .spectrum = spectrum,
        .pair = *pair,
        .plastic = plastic,
        .closure = &sinusoid_fits[closure],
        .effective_modulus_Pa = pair->effective_modulus_Pa,
    };
    double unit_Pa = sinusoid_full_pressure(1, 1 / spectrum->length_m, pair->effective_modulus_Pa);
    double most = find_steepest(out), full_Pa = 0, closed_Pa = 0, least = 0;
    out->closed_steepness_per_Pa = (1 - rounding) / unit_Pa;
    if (plastic) {
        out->ordered_Pa = sinusoid_ordered_pressure(pair) * (1 + rounding);
        out->critical_scales = count_critical(out, sinusoid_critical_full_pressure(pair) / unit_Pa);
        out->scales = reallocarray(NULL, out->count, sizeof *out->scales + sizeof *out->made);
        out->made = out->scales ? (bool *)(out->scales + out->count) : NULL;
        for (size_t i = 0; out->made && i < out->count; i++)
            out->made[i] = false;
    }
    if (!plastic || sinusoid_steepest_fills_last(most * unit_Pa, pair))
        least = most * (1 - rounding);
    for (size_t i = 0; (i = next_steeper(out, i, least)) < out->count; i++) {
        struct sinusoid_scale scale = multiscale_scale(out, i);
        raise_full(&full_Pa, &closed_Pa, &scale);
        least = fmax(least, full_Pa * out->closed_steepness_per_Pa); /* p* below: closed before */
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
    free(stack->steepest[0]);
    *stack = (struct multiscale){0};
}

/** The scale of index i: the one that is kept, else made, in `own` where none are. */
static const struct sinusoid_scale *scale_at(struct sinusoid_scale *own, struct multiscale *stack, size_t i)
{
    struct sinusoid_scale *scale = stack->scales ? &stack->scales[i] : own;
    if (scale == own || (stack->made && !stack->made[i]))
        *scale = make_scale(stack, i);
    if (stack->made)
        stack->made[i] = true;
    return scale;
}

struct sinusoid_scale multiscale_scale(struct multiscale *stack, size_t i)
{
    struct sinusoid_scale own;
    return *scale_at(&own, stack, i);
}

/** The first scale from index i on that is not known to be closed: one steeper than `closed`. */
static size_t next_open(const struct multiscale *stack, size_t i, double closed)
{
    bool itself = !stack->spectrum || (i < stack->count && steepness(stack->spectrum, i) > closed); /* mostly */
    return itself ? i : next_steeper(stack, i, closed);
}

size_t multiscale_solve(struct contact_point *out, struct multiscale *stack, const struct constriction *spot,
                        unsigned wanted, double load, uint64_t *evaluations)
{
    bool with_gap = wanted & QUANTITY_BIT(QUANTITY_SEPARATION);
    bool conducts = wanted & (QUANTITY_RESISTANCES);
    double nominal_Pa = load * stack->effective_modulus_Pa;
    double area = 1, separation = 0;
    double closed = 0; /* scales no steeper are: p rises from scale to scale, so that they stay it */
    size_t clamped = 0;
    struct constriction_sum sum = {0};
    for (size_t i = 0;; i++) {
        double pressure_Pa = nominal_Pa / area;
        double too_low = pressure_Pa * stack->closed_steepness_per_Pa;
        closed = too_low > closed ? too_low : closed;
        i = next_open(stack, i, closed);
        if (i >= stack->count)
            break;
        ++*evaluations;
        struct sinusoid_scale own;
        const struct sinusoid_scale *scale = scale_at(&own, stack, i);
        struct sinusoid_cell cell = {.gap_ratio = 1};
        sinusoid_press(&cell, scale, stack->closure, pressure_Pa, with_gap);
        if (cell.area_complement <= 0 && cell.gap_ratio <= 0) {
            if (stack->spectrum && pressure_Pa > stack->ordered_Pa)
                closed = fmax(closed, steepness(stack->spectrum, i) * (1 - rounding));
            continue;
        }
        clamped += cell.limited;
        if (with_gap)
            separation += scale->amplitude_m * cell.gap_ratio;
        if (conducts && cell.area_complement > 0)
            constriction_add_scale(&sum, cell.area_ratio, cell.area_complement, scale->frequency_per_m, area);
        area *= cell.area_ratio;
    }
    *out = quantity_nothing();
    out->value[QUANTITY_LOAD] = load;
    out->value[QUANTITY_AREA] = area;
    if (with_gap)
        out->value[QUANTITY_SEPARATION] = separation;
    if (wanted & QUANTITY_BIT(QUANTITY_ECR))
        out->value[QUANTITY_ECR] = constriction_electrical(spot, &sum);
    if (wanted & QUANTITY_BIT(QUANTITY_TCR))
        out->value[QUANTITY_TCR] = constriction_thermal(spot, &sum);
    if (wanted & QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT))
        out->value[QUANTITY_TCR_SCALE_DEPENDENT] = constriction_thermal_scale_dependent(spot, &sum);
    return clamped;
}

/** The first of the scales `first` to `end` - 1 that is open at the load `low` and complete at `high`; `end`: none. */
static size_t closing_scale(struct multiscale *stack, double low, double high, size_t first, size_t end)
{
    const double nominal_Pa[] = {low * stack->effective_modulus_Pa, high * stack->effective_modulus_Pa};
    double area[] = {1, 1}, closed[] = {0, 0};
    for (size_t i = 0; (i = next_open(stack, i, fmin(closed[0], closed[1]))) < end; i++) {
        struct sinusoid_scale own;
        const struct sinusoid_scale *scale = scale_at(&own, stack, i);
        bool complete[2];
        for (int at = 0; at < 2; at++) {
            struct sinusoid_cell cell = {.gap_ratio = 1};
            double pressure_Pa = nominal_Pa[at] / area[at];
            sinusoid_press(&cell, scale, stack->closure, pressure_Pa, false);
            area[at] *= cell.area_ratio;
            complete[at] = !(cell.area_complement > 0);
            closed[at] = fmax(closed[at], pressure_Pa * stack->closed_steepness_per_Pa);
            if (complete[at] && cell.gap_ratio <= 0 && stack->spectrum && pressure_Pa > stack->ordered_Pa)
                closed[at] = fmax(closed[at], steepness(stack->spectrum, i) * (1 - rounding));
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
    *out = (struct model_kink){high, 1 / multiscale_scale(stack, k).frequency_per_m};
    return true;
}
