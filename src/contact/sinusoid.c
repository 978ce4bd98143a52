/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/sinusoid.h"

#include <math.h>

static const double link_exponent = 0.01; /* the linking equation's exponents (4.5): 1.5 + 0.01 and 1 + 4 x 0.01 */
static const double sinusoid_link_switch = 0.8;
static const double critical_strain = 2.0 / 3; /* exp(2 nu/3) in Delta_c (docs/equations.md, Unsettled) */

/** a_1 = pi (3x/8pi)^(2/3), the Hertz limit (4.3*); from ln x. */
static double area_low(double ln_x)
{
    static const double factor = 0.7616184731724445; /* pi (3/(8 pi))^(2/3) */
    return factor * exp(2.0 / 3 * ln_x);
}

/** 1 - a_2 = (3/2pi)(1-x), near complete contact (4.4). */
static double area_high_complement(double x)
{
    return 3 / (2 * M_PI) * (1 - x);
}

/** The linking equation a_low (1-x^1.51) + a_2 x^1.04, 0 < x < 1, with a_low elastic (4.5) or plastic (4.17*). Near x =
 * 1 the complement is summed from small terms, so that 1 - sqrt(a) keeps its digits. With t = x^0.01, the only
 * exponential, x^1.51 = x sqrt(x) t and x^1.04 = x t^4. */
static void link_areas(struct sinusoid_cell *cell, double low, double x, double ln_x)
{
    double high_complement = area_high_complement(x), root = sqrt(x);
    if (x < 0.5) {
        double t = exp(link_exponent * ln_x), square = t * t;
        cell->area_ratio = low * (1 - x * root * t) + (1 - high_complement) * x * square * square;
        cell->area_complement = 1 - cell->area_ratio;
    } else { /* with s = 1 - t: 1 - x^1.5 t = 1 - x^1.5 + x^1.5 s, and 1 - t^4 = s (1 + t)(1 + t^2) */
        double rest = 1 - x, s = -expm1(link_exponent * ln_x), t = 1 - s;
        double fall_low = rest * (1 + x / (1 + root)) + x * root * s;
        double fall_high = rest + x * s * (1 + t) * (1 + t * t);
        cell->area_complement = fall_high + high_complement * (1 - fall_high) - low * fall_low;
        cell->area_ratio = 1 - cell->area_complement;
    }
    cell->limited = cell->area_complement <= 0;
    if (cell->limited) {
        cell->area_ratio = 1;
        cell->area_complement = 0;
    }
}

/** Elastic area ratio, thesis (4.5), (4.6). */
static void thesis_area(struct sinusoid_cell *cell, double x)
{
    if (x >= 1) {
        cell->area_ratio = 1;
        cell->area_complement = 0;
    } else if (x >= sinusoid_link_switch) {
        cell->area_complement = area_high_complement(x);
        cell->area_ratio = 1 - cell->area_complement;
    } else {
        double ln_x = log(x);
        link_areas(cell, area_low(ln_x), x, ln_x);
    }
}

/** Mean gap / amplitude G = (1-x)^(5/2 (0.696x + 0.158)^-0.847), (4.10*). */
static double thesis_gap(double x)
{
    if (x >= 1)
        return 0;
    double exponent = 2.5 * exp(-0.847 * log(0.696 * x + 0.158));
    return exp(exponent * log1p(-x));
}

const struct sinusoid_fit sinusoid_fits[SINUSOID_FIT_COUNT] = {
    /* W. E. Wilson, Auburn University 2008, eq. 4.3-4.10; after Johnson, Greenwood and Higginson 1985, Jackson and
     * Streator 2006 */
    [SINUSOID_FIT_THESIS] = {"thesis", false, thesis_area, thesis_gap},
    /* direct numerical solution of the elastic cell on a 1024 x 1024 grid, interpolated */
    [SINUSOID_FIT_NUMERIC] = {"numeric", true, sinusoid_numeric_area, sinusoid_numeric_gap},
};

double sinusoid_full_pressure(double amplitude_m, double frequency_per_m, double effective_modulus_Pa)
{
    return M_SQRT2 * M_PI * effective_modulus_Pa * amplitude_m * frequency_per_m;
}

double sinusoid_critical_amplitude(double frequency_per_m, const struct material_pair *pair)
{
    return M_SQRT2 * pair->yield_strength_Pa * exp(critical_strain * pair->poisson_ratio) /
           (3 * M_PI * pair->effective_modulus_Pa * frequency_per_m);
}

struct sinusoid_scale sinusoid_scale(double amplitude_m, double frequency_per_m, const struct material_pair *pair,
                                     bool plastic)
{
    double modulus = pair->effective_modulus_Pa;
    struct sinusoid_scale scale = {
        .amplitude_m = amplitude_m,
        .frequency_per_m = frequency_per_m,
        .full_pressure_Pa = sinusoid_full_pressure(amplitude_m, frequency_per_m, modulus),
        .critical_pressure_Pa = INFINITY,
    };
    double critical_amplitude_m = plastic ? sinusoid_critical_amplitude(frequency_per_m, pair) : INFINITY;
    if (amplitude_m <= critical_amplitude_m)
        return scale;

    double flow_Pa = pair->yield_coefficient * pair->yield_strength_Pa; /* C S_y */
    double slope = amplitude_m * frequency_per_m;                       /* Delta f */
    scale.critical_pressure_Pa = flow_Pa * flow_Pa * flow_Pa / (48 * M_PI * slope * modulus * slope * modulus);
    scale.plastic_full_pressure_Pa =
        scale.full_pressure_Pa * pow(11 / (4 * (amplitude_m / critical_amplitude_m) + 7), 3.0 / 5);
    /* a_p = 2 f² A_c^(1/(1+q)) (3p/(4 C S_y f²))^(q/(1+q)), with f² A_c = (C S_y/(8 Delta f E'))²/pi: the f² cancel. */
    double q = 3.8 * pow(modulus * slope / pair->yield_strength_Pa, 0.11);
    double cell_critical_area = pow(flow_Pa / (8 * slope * modulus), 2) / M_PI;
    scale.plastic_area_exponent = q / (1 + q);
    scale.plastic_area_log = M_LN2 + log(cell_critical_area) / (1 + q) +
                             scale.plastic_area_exponent * log(3 * scale.plastic_full_pressure_Pa / (4 * flow_Pa));
    return scale;
}

double sinusoid_closed_pressure(const struct sinusoid_scale *scale)
{
    if (scale->critical_pressure_Pa >= scale->full_pressure_Pa)
        return scale->full_pressure_Pa;
    return fmax(scale->plastic_full_pressure_Pa, scale->critical_pressure_Pa);
}

double sinusoid_ordered_pressure(const struct material_pair *pair)
{
    double flow_Pa = pair->yield_coefficient * pair->yield_strength_Pa, modulus = pair->effective_modulus_Pa;
    double critical_Pa = sinusoid_full_pressure(sinusoid_critical_amplitude(1, pair), 1, modulus);
    return fmax(cbrt(M_PI / 24) * flow_Pa, critical_Pa); /* p_c = p* at the first */
}

/** Below p_p, where the elastic area is below 1 too (p_p <= p*). */
static void raise_to_elastic(struct sinusoid_cell *cell, const struct sinusoid_scale *scale,
                             const struct sinusoid_fit *closure, double pressure_Pa)
{
    struct sinusoid_cell elastic;
    closure->area(&elastic, pressure_Pa / scale->full_pressure_Pa);
    if (elastic.area_ratio <= cell->area_ratio)
        return;
    cell->area_ratio = elastic.area_ratio;
    cell->area_complement = elastic.area_complement;
    cell->limited = true;
}

bool sinusoid_press(struct sinusoid_cell *cell, const struct sinusoid_scale *scale, const struct sinusoid_fit *closure,
                    double pressure_Pa, bool with_gap)
{
    bool plastic = pressure_Pa > scale->critical_pressure_Pa;
    double complete_Pa = plastic ? scale->plastic_full_pressure_Pa : scale->full_pressure_Pa;
    if (pressure_Pa >= complete_Pa) { /* also a scale of zero amplitude, where p* is 0 */
        *cell = (struct sinusoid_cell){.area_ratio = 1};
        return plastic;
    }
    double x = pressure_Pa / complete_Pa;
    if (plastic) {
        double ln_x = log(x);
        double low = exp(scale->plastic_area_log + scale->plastic_area_exponent * ln_x);
        link_areas(cell, low, x, ln_x);
        if (closure->floors_plastic)
            raise_to_elastic(cell, scale, closure, pressure_Pa);
    } else {
        cell->limited = false;
        closure->area(cell, x);
    }
    if (with_gap)
        cell->gap_ratio = closure->gap(x);
    return plastic;
}

double sinusoid_full_area_pressure(const struct sinusoid_scale *scale)
{
    double high = sinusoid_closed_pressure(scale), low = scale->critical_pressure_Pa;
    if (!(low < high))
        return high;
    const struct sinusoid_fit *closure = &sinusoid_fits[SINUSOID_FIT_THESIS]; /* plastic: not asked */
    for (;;) { /* bisects down to neighbouring numbers: the area never falls */
        double middle = low + (high - low) / 2;
        if (!(middle > low && middle < high))
            return high;
        struct sinusoid_cell cell;
        sinusoid_press(&cell, scale, closure, middle, false);
        if (cell.area_complement <= 0)
            high = middle;
        else
            low = middle;
    }
}
