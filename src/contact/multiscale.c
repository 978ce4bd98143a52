#include "contact/multiscale.h"

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

enum status_code multiscale_make(struct multiscale *out, const struct spectrum *spectrum,
                                 const struct material_pair *pair, bool plastic, enum sinusoid_fit_id closure,
                                 struct status *status)
{
    *out = (struct multiscale){
        .scales = malloc(spectrum->count * sizeof *out->scales),
        .count = spectrum->count,
        .closure = &sinusoid_fits[closure],
        .effective_modulus_Pa = pair->effective_modulus_Pa,
    };
    if (!out->scales)
        return status_memory(status);
    for (size_t i = 0; i < spectrum->count; i++)
        out->scales[i] = sinusoid_scale(spectrum->amplitude_m[i], spectrum_frequency(spectrum, i), pair, plastic);
    multiscale_complete(out);
    return STATUS_OK;
}

void multiscale_complete(struct multiscale *stack)
{
    double full_Pa = 0, closed_Pa = 0;
    stack->critical_scales = 0;
    for (size_t i = 0; i < stack->count; i++) {
        stack->critical_scales += isfinite(stack->scales[i].critical_pressure_Pa);
        double closed = sinusoid_closed_pressure(&stack->scales[i]);
        closed_Pa = fmax(closed_Pa, closed);
        if (closed > full_Pa) /* else this scale cannot be the last to fill */
            full_Pa = fmax(full_Pa, sinusoid_full_area_pressure(&stack->scales[i]));
    }
    stack->full_load = load_reaching(full_Pa, stack->effective_modulus_Pa);
    stack->closed_load = load_reaching(closed_Pa, stack->effective_modulus_Pa);
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
    double nominal_Pa = load * stack->effective_modulus_Pa;
    double area = 1, separation = 0;
    size_t clamped = 0;
    struct constriction_sum sum = {0};
    for (size_t i = 0; i < stack->count; i++) {
        const struct sinusoid_scale *scale = &stack->scales[i];
        struct sinusoid_cell cell;
        sinusoid_press(&cell, scale, stack->closure, nominal_Pa / area, with_gap);
        clamped += cell.limited;
        if (with_gap)
            separation += scale->amplitude_m * cell.gap_ratio;
        if (conducts && cell.area_complement > 0)
            constriction_add_scale(&sum, cell.area_ratio, cell.area_complement, scale->frequency_per_m, area);
        area *= cell.area_ratio;
    }
    *evaluations += stack->count;
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
