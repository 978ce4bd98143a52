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

static const struct constriction unit = {.resistivity_ohm_m = 1};

/** ECR A_n/rho [m] of an elastic stack, to integrate over a load p: over ln p, or over sqrt(end - p). */
struct resistance_length {
    struct multiscale *stack;
    double end; /* load at which a scale completes; above, ECR loses a term (end - p)^(3/2) */
    uint64_t *evaluations;
};

static double length_at(const struct resistance_length *length, double load)
{
    struct contact_point point;
    multiscale_solve(&point, length->stack, &unit, QUANTITY_BIT(QUANTITY_ECR), load, length->evaluations);
    return point.value[QUANTITY_ECR];
}

/** Both count downwards from heavy loads, as the integral does. */
static double over_logarithm(double minus_logarithm, void *context)
{
    double load = exp(-minus_logarithm);
    return load * length_at(context, load);
}

static double over_root(double root, void *context)
{
    const struct resistance_length *length = context;
    double load = fmax(length->end - root * root, 0.25 * length->end);
    return 2 * root * length_at(length, load);
}

/** A variable to integrate over, and where a load is in it. */
struct variable {
    integral_function *integrand;
    double (*place)(double load, double end);
};

static double logarithm_place(double load, double end)
{
    (void)end;
    return -log(load);
}

static double root_place(double load, double end)
{
    return sqrt(fmax(end - load, 0));
}

static const struct variable by_logarithm = {over_logarithm, logarithm_place}, by_root = {over_root, root_place};

static const double log_smallest = -690; /* e^-690 = 1e-300 */

static const double rounding = 1e-12; /* breaks as close as that are one */

/** ln of p/A_above(p) over `target`, of a load in logarithms. */
static double excess_at(struct multiscale *above, double logarithm, double target)
{
    struct contact_point point;
    uint64_t uncounted = 0;
    multiscale_solve(&point, above, &unit, 0, exp(logarithm), &uncounted);
    return log(point.value[QUANTITY_LOAD] / (point.value[QUANTITY_AREA] * target));
}

/** The load at which scale `index` is pressed by x p*: p/A_above(p) = x p*, to rounding. p/A_above rises, but may jump:
 * the Illinois method (Dowell and Jarratt 1971) in ln p, with a bisection every third step. */
static double load_at_ratio(struct multiscale *stack, size_t index, double x)
{
    struct multiscale above = *stack;
    above.count = index;
    double target = x * stack->scales[index].full_pressure_Pa / stack->effective_modulus_Pa;
    if (index == 0)
        return target;
    double high = log(target), over = excess_at(&above, high, target), low = high, under = over, step = 3 * over;
    if (over <= rounding) /* all of the above is complete */
        return target;
    while (under > 0 && low > log_smallest) { /* at light loads A_above goes as p^(2/3) */
        low -= fmax(step, 1);
        under = excess_at(&above, low, target);
        step *= 2;
    }
    for (int i = 0; i < 200 && high - low > 4e-16 * fmax(fabs(low), 1); i++) {
        double middle = i % 3 == 2 ? low + (high - low) / 2 : low - under * (high - low) / (over - under);
        if (!(middle > low && middle < high))
            middle = low + (high - low) / 2;
        if (middle <= low || middle >= high)
            break;
        double excess = excess_at(&above, middle, target);
        if (excess < 0) {
            low = middle;
            under = excess;
            over /= 2;
        } else {
            high = middle;
            over = excess;
            under /= 2;
        }
    }
    return exp(high);
}

/** An integral under way from the heaviest load down. */
struct descent {
    struct resistance_length length;
    const struct variable *variable;
    const double *load;
    double *separation_m;
    size_t left;       /* loads not reached yet, the lightest */
    double separation; /* so far */
    double tolerance;
};

enum { LOADS_FEW = 3, HALVINGS_MOST = 3 };
static const double panel_gain = 1e-4; /* of the tolerance: what panels are asked for, at next to no cost */

/** Where the load is that has `more` loads to be reached before it; beyond everything when there is none. */
static double place_of(const struct descent *descent, size_t more)
{
    return more < descent->left ? descent->variable->place(descent->load[descent->left - 1 - more], descent->length.end)
                                : INFINITY;
}

/** Separations at the loads within the panel; false: one of them, or the panel as a whole, misses the tolerance. */
static bool take_panel(struct descent *descent, const struct integral_panel *panel)
{
    double tolerance = fmax(panel_gain * descent->tolerance, 1e-13);
    for (size_t taken = 0;; taken++) {
        double place = place_of(descent, taken), at = fmin(place, panel->to);
        double sum = descent->separation + integral_panel_at(panel, at);
        if (!(panel->error * (at - panel->from) <= tolerance * sum))
            return false;
        if (place > panel->to) {
            descent->left -= taken;
            descent->separation = sum;
            return true;
        }
        descent->separation_m[descent->left - 1 - taken] = sum;
    }
}

/** One load after the other, each from the last. */
static void descend_by_loads(struct descent *descent, double from, double to)
{
    for (;;) {
        double place = place_of(descent, 0), at = fmin(place, to);
        if (at > from)
            descent->separation +=
                integral(descent->variable->integrand, &descent->length, from, at, descent->tolerance);
        from = at;
        if (place > to)
            return;
        descent->separation_m[--descent->left] = descent->separation;
    }
}

/** Down to the place `to`: many loads by panels that are halved until they are exact enough at each, few by themselves;
 * and so those that no panel serves, as the closure `numeric` is itself in pieces. */
static void descend(struct descent *descent, double from, double to, int halvings)
{
    if (place_of(descent, LOADS_FEW - 1) > to || halvings > HALVINGS_MOST) {
        descend_by_loads(descent, from, to);
        return;
    }
    struct integral_panel panel = integral_panel_make(descent->variable->integrand, &descent->length, from, to);
    if (take_panel(descent, &panel))
        return;
    double middle = from + (to - from) / 2;
    descend(descent, from, middle, halvings + 1);
    descend(descent, middle, to, halvings + 1);
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
    struct descent descent = {.load = load, .separation_m = separation_m, .left = count, .tolerance = tolerance};
    double upper = stack->full_load;
    while (descent.left > 0 && load[descent.left - 1] >= upper)
        separation_m[--descent.left] = 0;
    while (descent.left > 0) {
        double lower = load[0], end = stack->full_load, below = upper * (1 - rounding);
        for (int band = 0; band < TWO_BAND_COUNT; band++) {
            if (link[band] < below)
                lower = fmax(lower, link[band]);
            if (complete[band] < below)
                lower = fmax(lower, complete[band]);
            else
                end = fmin(end, complete[band]);
        }
        if (upper > end / 2 && descent.left >= LOADS_FEW && load[descent.left - LOADS_FEW] >= lower)
            lower = fmax(lower, end / 2); /* panels bear no power 3/2 */
        descent.variable = lower >= end / 2 ? &by_root : &by_logarithm;
        descent.length = (struct resistance_length){stack, end, evaluations};
        descend(&descent, descent.variable->place(upper, end), descent.variable->place(lower, end), 0);
        upper = lower;
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
