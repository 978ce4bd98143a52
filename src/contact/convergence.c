#include "contact/convergence.h"

#include "contact/sinusoid.h"
#include <math.h>

const double convergence_atom_m = 3e-10;

const struct convergence_sweep_row convergence_sweeps[CONVERGENCE_SWEEP_COUNT] = {
    [CONVERGENCE_ALPHA] = {"alpha", 7, {1e-3, 1e-2, 1e-1, 1, 10, 100, 1000}},
    [CONVERGENCE_GAMMA] = {"gamma", 9, {0, 0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75, 2}},
};

void convergence_areas(double *area_ratio, const struct convergence_law *law, const struct material_pair *pair,
                       bool plastic, uint64_t *evaluations)
{
    const struct sinusoid_fit *closure = &sinusoid_fits[SINUSOID_FIT_THESIS];
    double nominal_Pa = law->load * pair->effective_modulus_Pa, area = 1;
    for (size_t i = 0; i < law->scales; i++) {
        double frequency = (double)(i + 1) / law->length_m;
        double amplitude_m = law->alpha * pow(1 / frequency, law->gamma);
        struct sinusoid_scale scale = sinusoid_scale(amplitude_m, frequency, pair, plastic);
        struct sinusoid_cell cell;
        sinusoid_press(&cell, &scale, closure, nominal_Pa / area, false);
        area *= cell.area_ratio;
        area_ratio[i] = area;
    }
    *evaluations += law->scales;
}

struct convergence_extension convergence_extend(const struct power_law *law, double length_m, double shortest_m,
                                                const struct material_pair *pair, bool plastic, double load)
{
    const struct sinusoid_fit *closure = &sinusoid_fits[SINUSOID_FIT_THESIS];
    struct convergence_extension out = {1, 1, NAN, 0};
    double nominal_Pa = load * pair->effective_modulus_Pa;
    bool rising = law->gamma < 1; /* p* ~ lambda^(gamma-1) (4.55) */
    for (double n = 1; length_m / n >= convergence_atom_m; n++) {
        double wavelength_m = length_m / n;
        struct sinusoid_scale scale =
            sinusoid_scale(power_law_amplitude(law, wavelength_m), n / length_m, pair, plastic);
        struct sinusoid_cell cell;
        sinusoid_press(&cell, &scale, closure, nominal_Pa / out.area_extended, false);
        out.scales++;
        out.area_extended *= cell.area_ratio;
        bool measured = wavelength_m >= shortest_m * (1 - 1e-9);
        if (measured)
            out.area_measured = out.area_extended;
        if (cell.area_complement == 0 && !rising) {
            out.settled_m = wavelength_m;
            break;
        }
        /* On a rising law every scale is soon just short of complete: d ln p/dn = (3/2pi)(1 - p/p*) keeps p within
         * (2pi/3)(1-gamma)/n of p*, so the last scale's complete pressure gives the area without visiting the rest. */
        if (rising && !measured && n > 1000 && cell.area_complement < 1e-3) {
            double last_m = convergence_atom_m;
            scale = sinusoid_scale(power_law_amplitude(law, last_m), 1 / last_m, pair, plastic);
            out.area_extended = fmin(out.area_extended, nominal_Pa / sinusoid_full_area_pressure(&scale));
            break;
        }
    }
    return out;
}
