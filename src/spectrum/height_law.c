/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/height_law.h"

#include "spectrum/simulated_record.h"
#include <assert.h>
#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

enum { SCANS = 256, LEAST_HARMONICS = 31, MOST_HARMONICS = 511, FIRST_SEED = 1, DRAWING_SEED = SCANS + 1 };

static const double most_skewness = 0.5, least_kurtosis = 2.5, most_kurtosis = 4;
static const double power_held = 0.99; /* of the variance: shorter waves hardly move Rsk and Rku */
static const double significance = 0.025;

const struct height_verdict_row height_verdicts[HEIGHT_VERDICTS] = {
    [HEIGHTS_GAUSSIAN] = {"gaussian", ""},
    [HEIGHTS_CANNOT_TELL] = {"cannot tell", "‡?"},
    [HEIGHTS_NOT_GAUSSIAN] = {"not gaussian", "‡"},
};

/** Share of values as far from their median as `value`, two-sided. */
static double chance_of(const double value[SCANS], double own)
{
    size_t below = 0, above = 0;
    for (size_t k = 0; k < SCANS; k++) {
        below += value[k] <= own;
        above += value[k] >= own;
    }
    return fmin(1, 2 * (double)(below < above ? below : above) / SCANS);
}

/** How many harmonics of the spectrum are simulated. */
static size_t harmonics_held(const struct spectrum *spectrum)
{
    double all = spectrum_moment(spectrum, 0), held = 0;
    size_t n = 0;
    while (n < spectrum->count && n < MOST_HARMONICS && (n < LEAST_HARMONICS || held < power_held * all)) {
        held += spectrum->amplitude_m[n] * spectrum->amplitude_m[n] / 2;
        n++;
    }
    return n;
}

/** Moments of simulated scans, each levelled. */
static enum status_code simulate(struct roughness one[SCANS], const struct simulated_record *record, enum level level,
                                 struct status *status)
{
    size_t points = record->points;
    double *height_m = malloc(points * sizeof *height_m);
    enum status_code rc = height_m ? STATUS_OK : status_memory(status);
    for (size_t k = 0; k < SCANS && rc == STATUS_OK; k++) {
        struct levelling levelling;
        rc = simulated_record_draw(height_m, record, FIRST_SEED + k, status);
        if (rc == STATUS_OK) /* what was taken out does not matter: any spacing does */
            rc = level_remove(&levelling, height_m, NULL, points, 1, level, status);
        if (rc == STATUS_OK)
            one[k] = roughness_of_heights_alone(height_m, points);
    }
    free(height_m);
    return rc;
}

/** Chances of the surface's own Rsk and Rku, each the mean's over `scans` drawn from those simulated. */
static enum status_code find_chances(double chance[2], const struct roughness *own, const struct roughness one[SCANS],
                                     size_t scans, struct status *status)
{
    double skewness[SCANS], kurtosis[SCANS];
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    if (!random)
        return status_memory(status);
    gsl_rng_set(random, DRAWING_SEED);
    for (size_t k = 0; k < SCANS; k++) {
        struct roughness mean = one[k];
        for (size_t more = 1; more < scans; more++)
            roughness_average(&mean, &one[gsl_rng_uniform_int(random, SCANS)], more);
        skewness[k] = roughness_skewness(&mean);
        kurtosis[k] = roughness_kurtosis(&mean);
    }
    gsl_rng_free(random);
    chance[0] = chance_of(skewness, roughness_skewness(own));
    chance[1] = chance_of(kurtosis, roughness_kurtosis(own));
    return STATUS_OK;
}

/** Leaves the chances NaN where nothing can be simulated. */
static enum status_code simulate_chances(double chance[2], const struct roughness *own, const struct spectrum *spectrum,
                                         double scans, enum level level, struct status *status)
{
    struct status problem = {0};
    struct simulated_record record = {0};
    struct roughness one[SCANS];
    double square_m2[MOST_HARMONICS];
    size_t count = harmonics_held(spectrum), points = 2 * (count + 1);
    if (points < SIMULATED_RECORD_LEAST_POINTS)
        return STATUS_OK;
    for (size_t i = 0; i < count; i++)
        square_m2[i] = spectrum->amplitude_m[i] * spectrum->amplitude_m[i];
    enum status_code rc = simulated_record_prepare(&record, square_m2, points, &problem);
    if (rc == STATUS_OK) /* an arc takes out what a parabola does */
        rc = simulate(one, &record, level == LEVEL_CIRCLE ? LEVEL_PARABOLA : level, &problem);
    simulated_record_free(&record);
    if (rc == STATUS_MEMORY)
        return status_memory(status);
    return rc == STATUS_OK ? find_chances(chance, own, one, (size_t)fmin(fmax(1, scans), SCANS), status) : STATUS_OK;
}

enum status_code height_law_find(struct height_law *out, const struct roughness *roughness,
                                 const struct spectrum *spectrum, double scans, enum level level, struct status *status)
{
    double kurtosis = roughness_kurtosis(roughness);
    bool beyond[2] = {!(fabs(roughness_skewness(roughness)) < most_skewness),
                      !(kurtosis >= least_kurtosis && kurtosis <= most_kurtosis)};
    *out = (struct height_law){HEIGHTS_GAUSSIAN, {NAN, NAN}};
    if (!beyond[0] && !beyond[1])
        return STATUS_OK;
    if (simulate_chances(out->chance, roughness, spectrum, scans, level, status) != STATUS_OK)
        return status->code;
    out->verdict = HEIGHTS_CANNOT_TELL;
    for (int i = 0; i < 2; i++)
        if (beyond[i] && !(out->chance[i] >= significance))
            out->verdict = HEIGHTS_NOT_GAUSSIAN;
    return STATUS_OK;
}
