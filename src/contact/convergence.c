/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/convergence.h"

#include "contact/sinusoid.h"
#include <math.h>

const double convergence_atom_m = 3e-10;
static const double convergence_steepest = 3; /* twice the slope of the smoothest self-affine surface */

const struct convergence_sweep_row convergence_sweeps[CONVERGENCE_SWEEP_COUNT] = {
    [CONVERGENCE_ALPHA] = {"alpha", 7, {1e-3, 1e-2, 1e-1, 1, 10, 100, 1000}},
    [CONVERGENCE_GAMMA] = {"gamma", 9, {0, 0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75, 2}},
};

/** One scale pressed once. At p* and above it is closed whether it yields or not (p_p <= p*). */
static struct sinusoid_cell press(double amplitude_m, double frequency_per_m, const struct material_pair *pair,
                                  bool plastic, double pressure_Pa)
{
    struct sinusoid_cell cell = {.area_ratio = 1};
    if (pressure_Pa >= sinusoid_full_pressure(amplitude_m, frequency_per_m, pair->effective_modulus_Pa))
        return cell;
    struct sinusoid_scale scale = sinusoid_scale(amplitude_m, frequency_per_m, pair, plastic);
    sinusoid_press(&cell, &scale, &sinusoid_fits[SINUSOID_FIT_THESIS], pressure_Pa, false);
    return cell;
}

void convergence_areas(double *area_ratio, const struct convergence_law *law, const struct material_pair *pair,
                       bool plastic, uint64_t *evaluations)
{
    double nominal_Pa = law->load * pair->effective_modulus_Pa, area = 1;
    for (size_t i = 0; i < law->scales; i++) {
        double frequency = (double)(i + 1) / law->length_m;
        double amplitude_m = law->alpha * pow(1 / frequency, law->gamma);
        area *= press(amplitude_m, frequency, pair, plastic, nominal_Pa / area).area_ratio;
        area_ratio[i] = area;
    }
    *evaluations += law->scales;
}

struct convergence_tail convergence_tail(const struct spectrum *spectrum, size_t count)
{
    static const double half_decade = 3.1622776601683795; /* sqrt(10) */
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, shortest_m = spectrum->length_m / (double)count;
    for (size_t i = count; i-- > 0 && (double)(i + 1) * half_decade >= (double)count;) {
        if (!(spectrum->amplitude_m[i] > 0))
            continue;
        double x = log((double)count / (double)(i + 1)), y = log(spectrum->amplitude_m[i]); /* lambda/shortest_m */
        n += 1;
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    double gamma = n < 3 ? NAN : (sxy - sx * sy / n) / (sxx - sx * sx / n);
    if (!(gamma <= convergence_steepest))
        return (struct convergence_tail){NAN, NAN, NAN, count};
    double wavelength_m = shortest_m * exp(sx / n), amplitude_m = exp(sy / n);
    return (struct convergence_tail){wavelength_m, amplitude_m, gamma, count};
}

double convergence_tail_amplitude(const struct convergence_tail *tail, double wavelength_m)
{
    return tail->amplitude_m * pow(wavelength_m / tail->wavelength_m, tail->gamma);
}

struct convergence_extension convergence_extend(const struct spectrum *spectrum, const struct convergence_tail *tail,
                                                const struct material_pair *pair, bool plastic, double load)
{
    struct convergence_extension out = {1, 1, 0};
    double nominal_Pa = load * pair->effective_modulus_Pa;
    bool rising = tail->gamma < 1; /* p* ~ lambda^(gamma-1) (4.55) */
    for (double n = 1; spectrum->length_m / n >= convergence_atom_m; n++) {
        double wavelength_m = spectrum->length_m / n;
        bool measured = n <= (double)tail->count;
        double amplitude_m =
            measured ? spectrum->amplitude_m[(size_t)n - 1] : convergence_tail_amplitude(tail, wavelength_m);
        struct sinusoid_cell cell =
            press(amplitude_m, n / spectrum->length_m, pair, plastic, nominal_Pa / out.area_extended);
        out.scales++;
        out.area_extended *= cell.area_ratio;
        if (measured) {
            out.area_measured = out.area_extended;
            continue;
        }
        if (cell.area_complement == 0 && !rising)
            break;
        /* On a rising law every scale is soon just short of complete: d ln p/dn = (3/2pi)(1 - p/p*) keeps p within
         * (2pi/3)(1-gamma)/n of p*, so the last scale's complete pressure gives the area without visiting the rest. */
        if (rising && n > 1000 && cell.area_complement < 1e-3) {
            const double last_m = convergence_atom_m, amplitude = convergence_tail_amplitude(tail, last_m);
            struct sinusoid_scale scale = sinusoid_scale(amplitude, 1 / last_m, pair, plastic);
            out.area_extended = fmin(out.area_extended, nominal_Pa / sinusoid_full_area_pressure(&scale));
            break;
        }
    }
    return out;
}
