/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/two_band.h"

#include "base/integral.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

const double two_band_trusted_area = 0.75;
const double two_band_trusted_hardness_share = 0.25;

/** e_n = f_n Delta_n²; Delta_n² is twice the mean square, also at the Nyquist bin. */
static double energy(const struct spectrum *spectrum, size_t i)
{
    return spectrum_frequency(spectrum, i) * 2 * spectrum_power(spectrum, i);
}

bool two_band_split(struct two_band *out, const struct spectrum *spectrum)
{
    double total = 0;
    for (size_t i = 0; i < spectrum->count; i++)
        total += energy(spectrum, i);
    if (!(total > 0))
        return false;
    size_t m = 0;
    double below = 0, next = energy(spectrum, 0); /* E_{m-1} and e_m */
    for (; below + next < total / 2; next = energy(spectrum, ++m))
        below += next;
    double share = (total / 2 - below) / next;

    *out = (struct two_band){.split_harmonic = m + 1, .split_share = share};
    for (int band = 0; band < TWO_BAND_COUNT; band++) {
        double at_split = band == 0 ? share : 1 - share, s0 = 0, s2 = 0;
        size_t first = band == 0 ? 0 : m, last = band == 0 ? m : spectrum->count - 1;
        for (size_t i = first; i <= last; i++) {
            double square = (i == m ? at_split : 1) * 2 * spectrum_power(spectrum, i);
            double frequency = spectrum_frequency(spectrum, i);
            s0 += square;
            s2 += frequency * frequency * square;
        }
        out->amplitude_m[band] = sqrt(2 * s0);
        out->frequency_per_m[band] = sqrt(s2 / s0);
    }
    return true;
}

enum status_code two_band_stack(struct multiscale *out, const struct two_band *bands, const struct material_pair *pair,
                                bool plastic, double hardness_Pa, enum sinusoid_fit_id closure, struct status *status)
{
    *out = (struct multiscale){
        .scales = malloc(TWO_BAND_COUNT * sizeof *out->scales),
        .count = TWO_BAND_COUNT,
        .closure = &sinusoid_fits[closure],
        .effective_modulus_Pa = pair->effective_modulus_Pa,
    };
    if (!out->scales)
        return status_memory(status);
    for (int i = 0; i < TWO_BAND_COUNT; i++) {
        out->scales[i] = sinusoid_scale(bands->amplitude_m[i], bands->frequency_per_m[i], pair, plastic);
        out->scales[i].hardness_Pa = hardness_Pa;
    }
    multiscale_complete(out);
    return STATUS_OK;
}

/** ECR A_n/rho [m] of an elastic stack, to integrate over a load p: directly, over ln p, or over sqrt(end - p). */
struct resistance_length {
    struct multiscale *stack;
    double end; /* load at which a scale completes; above, ECR loses a term (end - p)^(3/2) */
    uint64_t *evaluations;
};

static const struct constriction unit = {.resistivity_ohm_m = 1};

static double length_at(const struct resistance_length *length, double load)
{
    struct contact_point point;
    multiscale_solve(&point, length->stack, &unit, QUANTITY_BIT(QUANTITY_ECR), load, length->evaluations);
    return point.ecr_ohm_m2;
}

static double over_logarithm(double logarithm, void *context)
{
    double load = exp(logarithm);
    return load * length_at(context, load);
}

static double over_root(double root, void *context)
{
    const struct resistance_length *length = context;
    double load = fmax(length->end - root * root, 0.25 * length->end);
    return 2 * root * length_at(length, load);
}

/** The load at which `scale`, the index-th, is pressed by x p*: p/A_above(p) = x p*, found by bisection down to
 * neighbouring numbers (p/A_above rises, but may jump). */
static double load_at_ratio(struct multiscale *stack, size_t index, double x)
{
    struct multiscale above = *stack;
    above.count = index;
    double target = x * stack->scales[index].full_pressure_Pa / stack->effective_modulus_Pa;
    double low = 0, high = target;
    while (index > 0) {
        double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high || middle <= 1e-300)
            break;
        struct contact_point point;
        uint64_t uncounted = 0;
        multiscale_solve(&point, &above, &unit, 0, middle, &uncounted);
        if (middle / point.area_ratio < target)
            low = middle;
        else
            high = middle;
    }
    return high;
}

void two_band_separation(double *separation_m, const double *load, size_t count, struct multiscale *stack,
                         double tolerance, uint64_t *evaluations)
{
    assert(stack->count == TWO_BAND_COUNT && stack->critical_scales == 0);
    /* the law is pieced together where a scale reaches the link's end, and where it completes */
    double link[TWO_BAND_COUNT], complete[TWO_BAND_COUNT];
    for (size_t i = 0; i < TWO_BAND_COUNT; i++) {
        link[i] = load_at_ratio(stack, i, sinusoid_link_switch);
        complete[i] = load_at_ratio(stack, i, 1);
    }
    double upper = stack->full_load, separation = 0;
    for (size_t i = count; i-- > 0;) {
        while (upper > load[i]) {
            double lower = load[i], end = stack->full_load;
            for (int band = 0; band < TWO_BAND_COUNT; band++) {
                if (link[band] < upper)
                    lower = fmax(lower, link[band]);
                if (complete[band] < upper)
                    lower = fmax(lower, complete[band]);
                else
                    end = fmin(end, complete[band]);
            }
            struct resistance_length length = {stack, end, evaluations};
            if (lower > end / 2)
                separation += integral(over_root, &length, sqrt(fmax(end - upper, 0)), sqrt(end - lower), tolerance);
            else
                separation += integral(over_logarithm, &length, log(lower), log(upper), tolerance);
            upper = lower;
        }
        separation_m[i] = separation;
    }
}

bool two_band_trusted(double area_ratio)
{
    return area_ratio <= two_band_trusted_area;
}

bool two_band_plastic_gap_trusted(double area_ratio, double pressure_Pa, double hardness_Pa)
{
    return two_band_trusted(area_ratio) && pressure_Pa <= two_band_trusted_hardness_share * hardness_Pa;
}
