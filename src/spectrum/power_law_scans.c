/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/power_law_scans.h"

#include "spectrum/multitaper.h"
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>

enum { BLOCKS = 16 };

/** The multitaper spectrum as amplitudes. */
static enum status_code taper(struct spectrum *out, const double *height_m, size_t points, double spacing_m,
                              struct status *status)
{
    size_t count = multitaper_count(points);
    *out = (struct spectrum){.amplitude_m = reallocarray(NULL, count, sizeof *out->amplitude_m),
                             .count = count,
                             .length_m = (double)points * spacing_m};
    if (!out->amplitude_m)
        return status_memory(status);
    if (multitaper_square(out->amplitude_m, height_m, points, status) != STATUS_OK)
        return status->code;
    for (size_t i = 0; i < count; i++)
        out->amplitude_m[i] = sqrt(out->amplitude_m[i]);
    return STATUS_OK;
}

enum status_code power_law_scans_add(struct power_law_scans *scans, const double *height_m, size_t points,
                                     double spacing_m, double step_m, struct status *status)
{
    struct power_law_scan *more = reallocarray(scans->scan, scans->scan_count + 1, sizeof *more);
    if (!more)
        return status_memory(status);
    scans->scan = more;
    struct spectrum own;
    if (taper(&own, height_m, points, spacing_m, status) != STATUS_OK ||
        grid_average(&scans->mean, &own, scans->scan_count, status) != STATUS_OK) {
        spectrum_free(&own);
        return status->code;
    }
    scans->scan[scans->scan_count++] = (struct power_law_scan){own, scans->files};
    scans->step_m = fmax(scans->step_m, step_m);
    return STATUS_OK;
}

/** Mean over the bins of log10 amplitude; bins without power are left out. */
static double level_of(const struct spectrum *spectrum)
{
    struct log_bin bin[LOG_BIN_MOST];
    double sum = 0;
    size_t used = 0, bins = log_bin_fill(bin, spectrum->amplitude_m, spectrum->count, spectrum->length_m, 1, NULL);
    for (size_t j = 0; j < bins; j++)
        if (isfinite(bin[j].y)) {
            sum += bin[j].y;
            used++;
        }
    return used > 0 ? sum / (double)used : 0;
}

/** How many independent rows neighbouring ones count as: n = B (1-r)/(1+r) for the means of B blocks of rows,
 * r = sum d_i d_{i+1}/sum d² + 1/B the correlation of neighbouring blocks (Bayley & Hammersley 1946,
 * doi:10.2307/2983560; Kendall 1954, doi:10.1093/biomet/41.3-4.403, for the 1/B). */
static double rows_worth(const struct power_law_scan *row, size_t count)
{
    size_t blocks = count < BLOCKS ? count : BLOCKS;
    double mean[BLOCKS] = {0};
    for (size_t b = 0; b < blocks; b++) {
        size_t first = b * count / blocks, end = (b + 1) * count / blocks;
        for (size_t i = first; i < end; i++)
            mean[b] += level_of(&row[i].spectrum) / (double)(end - first);
    }
    double of_all = gsl_stats_mean(mean, 1, blocks), squares = 0, products = 0;
    for (size_t b = 0; b < blocks; b++) {
        squares += (mean[b] - of_all) * (mean[b] - of_all);
        products += b > 0 ? (mean[b] - of_all) * (mean[b - 1] - of_all) : 0;
    }
    const double rounding = 1e-9; /* decades: equal rows differ by less */
    if (!(squares > (double)blocks * rounding * rounding))
        return 1;
    double correlation = fmin(fmax(products / squares + 1 / (double)blocks, 0), 0.8);
    return fmax(2, (double)blocks * (1 - correlation) / (1 + correlation));
}

void power_law_scans_end_file(struct power_law_scans *scans, size_t used, bool rows)
{
    size_t count = scans->scan_count - scans->closed;
    scans->independent += rows && count > 1 ? rows_worth(scans->scan + scans->closed, count) : (double)used;
    scans->closed = scans->scan_count;
    scans->files++;
}

/** The law of one spectrum that is the mean of `independent` scans. */
static void fit(struct power_law_band *out, const struct spectrum *spectrum, double independent, double step_m,
                double lambda_s_m, const double *band_m)
{
    size_t known = spectrum_known(spectrum, 0, step_m);
    double shortest_m = known < spectrum->count ? spectrum->length_m / fmax(1, (double)known) : 0;
    const struct power_law_band_spectrum of = {spectrum->amplitude_m, spectrum->count, spectrum->length_m, independent,
                                               fmax(2 * lambda_s_m, shortest_m)};
    if (band_m)
        power_law_band_fit_in(out, &of, band_m);
    else
        power_law_band_find(out, &of);
}

void power_law_scans_fit(struct power_law_band *out, const struct power_law_scans *scans, double lambda_s_m,
                         const double *band_m)
{
    *out = (struct power_law_band){.law = POWER_LAW_BAND_NONE};
    if (scans->scan_count > 0)
        fit(out, &scans->mean, fmax(1, scans->independent), scans->step_m, lambda_s_m, band_m);
}

void power_law_scans_fit_alone(struct power_law_band *out, const struct power_law_scans *scans, size_t i,
                               double lambda_s_m, const struct power_law_band *mean)
{
    fit(out, &scans->scan[i].spectrum, 1, scans->step_m, lambda_s_m, mean->fit.band_m);
}

void power_law_scans_free(struct power_law_scans *scans)
{
    for (size_t i = 0; i < scans->scan_count; i++)
        spectrum_free(&scans->scan[i].spectrum);
    free(scans->scan);
    spectrum_free(&scans->mean);
    *scans = (struct power_law_scans){0};
}
