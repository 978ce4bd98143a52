/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A profile made of the 255 waves of a power law gives them back; the band of a law is found in a rough spectrum. */
#include "selftest/selftest.h"
#include "spectrum/power_law.h"
#include "spectrum/power_law_band.h"
#include "spectrum/spectrum.h"

#include <math.h>
#include <stdlib.h>
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
    {"band", "gamma", {0}, 1.4133778691934802, 1e-12},
    {"band", "standard error of gamma", {0}, 0.10907764099181795, 1e-12},
    {"band", "log10 amplitude", {0}, -7.337190378066575, 1e-12},
    {"band", "shortest wave", {0}, 1.6666666666666657e-05, 1e-12},
    {"band", "longest wave", {0}, 0.00020000000000000004, 1e-12},
};

/** tests/data/statistics/spectrum60.csv: squared amplitudes of a multitaper spectrum of 1 mm. */
static const double square_m2[] = {
    8.148890915196245e-12,  1.157776025547263e-12,  2.5610119779163898e-13, 5.9873036361564447e-14,
    1.3409364159823642e-13, 2.9074493134097438e-14, 2.0958647563752943e-14, 6.8900811899948818e-15,
    8.8590152225330752e-15, 9.8601204238872388e-15, 1.0354507289157097e-14, 1.2926001112244403e-14,
    3.5939905748847929e-15, 6.4459248113692483e-15, 1.5859131248688647e-15, 2.099179895076045e-15,
    2.4597349631413744e-15, 1.2591574572313706e-15, 9.5246517986635252e-16, 1.7449122092107141e-15,
    2.3385918678786667e-15, 1.5261713112378944e-15, 4.8095031253012492e-16, 4.8554380634689066e-16,
    1.157945019205405e-15,  1.0429559130754094e-15, 7.4068148049660102e-16, 3.0237642847904555e-16,
    2.6128916477487803e-16, 8.1973051032467525e-16, 5.9626998880080661e-16, 4.5667376865734118e-16,
    2.17523140368202e-16,   5.0333900502249515e-16, 2.0260335166382816e-16, 1.6594366053984771e-16,
    2.0025608331372596e-16, 3.938116387295501e-16,  1.2471619072619833e-16, 2.4029069348572172e-16,
    4.4587391555064372e-16, 1.4501871344400033e-16, 1.5820814658331459e-16, 7.5083006040771611e-17,
    1.5372355596546146e-16, 2.0457174529815964e-16, 7.6933876201765363e-17, 8.7105810543737468e-17,
    9.8993296435162189e-17, 3.9115925163629019e-17, 4.073312670154542e-17,  1.0537104996679731e-16,
    8.1636934086820326e-17, 9.7820768509920835e-17, 6.1749468264191526e-17, 7.213853745255187e-17,
    5.0895093474452353e-17, 3.3213814349695886e-17, 4.3028744459040056e-17, 1.2029965591380059e-16};

static double band_number(const struct power_law_band_fit *fit, const char *of)
{
    return strcmp(of, "gamma") == 0             ? fit->gamma
           : strcmp(of, "log10 amplitude") == 0 ? fit->log10_amplitude
           : strcmp(of, "shortest wave") == 0   ? fit->band_m[0]
           : strcmp(of, "longest wave") == 0    ? fit->band_m[1]
                                                : fit->gamma_s;
}

static enum status_code find_band(double *values, const struct selftest_reference *all, size_t count,
                                  struct status *status)
{
    const struct power_law_band_spectrum spectrum = {square_m2, sizeof square_m2 / sizeof square_m2[0], 1e-3, 1, 0};
    struct power_law_band *band = malloc(sizeof *band);
    if (!band)
        return status_memory(status);
    enum status_code rc = power_law_band_find(band, &spectrum, status);
    for (size_t i = 0; i < count && rc == STATUS_OK; i++)
        if (strcmp(all[i].what, "band") == 0)
            values[i] = band_number(&band->fit, all[i].of);
    free(band);
    return rc;
}

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
    return find_band(values, all, count, status);
}

const struct selftest_group selftest_spectrum = {
    .name = "spectrum",
    .source = "the law that the profile is made of, and its sums; plain loops over the definitions of the band's fit",
    .references = references,
    .count = sizeof references / sizeof references[0],
    .compute = compute,
};
