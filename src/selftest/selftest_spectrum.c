/* A profile made of the 255 waves of a power law gives them back. */
#include "selftest/selftest.h"
#include "spectrum/power_law.h"
#include "spectrum/spectrum.h"

#include <math.h>
#include <string.h>

enum { POINTS = 512, WAVES = POINTS / 2 - 1 };
static const double length_m = 3e-4, alpha = 0.085, gamma_given = 1.5;

/* alpha (L/n)^gamma, and sums of its squares */
static const struct selftest_reference references[] = {
    {"wave", "amplitude", {1}, 4.416729559300637e-07, 1e-11},
    {"wave", "amplitude", {16}, 6.901139936407245e-09, 1e-10},
    {"wave", "amplitude", {255}, 1.0846522890932809e-10, 1e-8},
    {"moment", "m0", {0}, 1.1724487812733851e-13, 1e-11},
    {"moment", "m2", {1}, 0.00026186134889344376, 1e-10},
    {"law", "alpha", {0}, 0.085, 1e-8},
    {"law", "gamma", {0}, 1.5, 1e-9},
};

static enum status_code compute(double *values, const struct selftest_reference *all, size_t count,
                                struct status *status)
{
    static const double everything[2] = {0, INFINITY};
    double height_m[POINTS] = {0};
    for (int n = 1; n <= WAVES; n++) {
        double amplitude_m = alpha * pow(length_m / n, gamma_given), phase = 0.381966 * n * n; /* no two alike */
        for (int i = 0; i < POINTS; i++)
            height_m[i] += amplitude_m * cos(2 * M_PI * ((double)(n * i % POINTS) / POINTS + phase));
    }
    struct spectrum spectrum;
    if (spectrum_compute(&spectrum, height_m, POINTS, length_m / POINTS, SPECTRUM_WINDOW_NONE, status) != STATUS_OK)
        return status->code;
    spectrum.count = WAVES; /* the Nyquist one is empty */
    spectrum.has_nyquist = false;
    struct power_law law = power_law_fit(&spectrum, everything);
    for (size_t i = 0; i < count; i++)
        values[i] = strcmp(all[i].what, "wave") == 0     ? spectrum.amplitude_m[(size_t)all[i].at[0] - 1]
                    : strcmp(all[i].what, "moment") == 0 ? spectrum_moment(&spectrum, (int)all[i].at[0])
                    : strcmp(all[i].of, "alpha") == 0    ? law.alpha
                                                         : law.gamma;
    spectrum_free(&spectrum);
    return STATUS_OK;
}

const struct selftest_group selftest_spectrum = {
    .name = "spectrum",
    .source = "the law that the profile is made of, and its sums",
    .references = references,
    .count = sizeof references / sizeof references[0],
    .compute = compute,
};
