/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/power_law.h"

#include <math.h>

const char *const power_law_method_names[POWER_LAW_METHOD_COUNT] = {"auto", "thesis"};

static struct power_law no_law(const double band_m[2])
{
    struct power_law law = {.found = POWER_LAW_BAND_NONE, .band_m = {band_m[0], band_m[1]}};
    law.alpha = law.gamma = law.gamma_error = law.amplitude_m = law.amplitude_error_decades = NAN;
    law.wavelength_m = law.psd_m3 = law.misfit_decades = law.knee_m = law.gamma_below = law.gamma_above = NAN;
    return law;
}

/** Sums for a straight line y = intercept + slope x. */
struct sums {
    double n, x, y, xx, xy, yy;
};

struct line {
    double slope, intercept, residual; /* residual: sum of squares */
    double x_mean, x_spread;           /* x_spread: sum (x - x_mean)² */
};

static void sums_add(struct sums *sums, double x, double y)
{
    sums->n += 1;
    sums->x += x;
    sums->y += y;
    sums->xx += x * x;
    sums->xy += x * y;
    sums->yy += y * y;
}

static struct sums sums_rest(const struct sums *all, const struct sums *part)
{
    return (struct sums){all->n - part->n,   all->x - part->x,   all->y - part->y,
                         all->xx - part->xx, all->xy - part->xy, all->yy - part->yy};
}

static struct line line_of(const struct sums *sums)
{
    double x_mean = sums->x / sums->n, y_mean = sums->y / sums->n;
    double xx = sums->xx - sums->n * x_mean * x_mean, xy = sums->xy - sums->n * x_mean * y_mean;
    double yy = sums->yy - sums->n * y_mean * y_mean;
    double slope = xy / xx;
    return (struct line){slope, y_mean - slope * x_mean, fmax(0, yy - slope * xy), x_mean, xx};
}

static double wavelength(const struct spectrum *spectrum, size_t i)
{
    return spectrum->length_m / (double)(i + 1);
}

static bool in_band(const struct spectrum *spectrum, size_t i, const double band_m[2])
{
    double wavelength_m = wavelength(spectrum, i);
    return spectrum->amplitude_m[i] > 0 && wavelength_m >= band_m[0] * (1 - 1e-12) &&
           wavelength_m <= band_m[1] * (1 + 1e-12);
}

/** The sums are of x = log10(lambda/L) and y = log10(Delta/1 um), which keeps digits. */
static double log_wavelength(size_t i)
{
    return -log10((double)(i + 1));
}

static double log_amplitude(const struct spectrum *spectrum, size_t i)
{
    return log10(spectrum->amplitude_m[i] / 1e-6);
}

/** Looks for the wavelength at which two straight lines are better than one by 10 ("very strong") of the Bayesian
 * information criterion, each over at least 8 harmonics and a factor of 2 in wavelength, with slopes 0.3 apart. */
static void find_knee(struct power_law *law, const struct spectrum *spectrum, size_t first, size_t last,
                      const struct sums *all, double residual)
{
    struct sums longer = {0};
    double best = residual, first_x = log_wavelength(first), last_x = log_wavelength(last);
    for (size_t i = first; i <= last; i++) {
        if (!in_band(spectrum, i, law->band_m))
            continue;
        double x = log_wavelength(i);
        sums_add(&longer, x, log_amplitude(spectrum, i));
        struct sums shorter = sums_rest(all, &longer);
        if (longer.n < 8 || shorter.n < 8 || first_x - x < M_LN2 / M_LN10 || x - last_x < M_LN2 / M_LN10)
            continue;
        struct line above = line_of(&longer), below = line_of(&shorter);
        double both = above.residual + below.residual;
        if (both < best && fabs(above.slope - below.slope) > 0.3) {
            best = both;
            law->knee_m = wavelength(spectrum, i);
            law->gamma_above = above.slope;
            law->gamma_below = below.slope;
        }
    }
    /* three more parameters; 0: an exact law */
    double gain = residual > 0 ? all->n * log(residual / fmax(best, 1e-300)) - 3 * log(all->n) : 0;
    if (gain <= 10)
        law->knee_m = law->gamma_above = law->gamma_below = NAN;
}

struct power_law power_law_fit(const struct spectrum *spectrum, const double band_m[2])
{
    struct power_law law = no_law(band_m);
    struct sums sums = {0};
    size_t first = 0, last = 0;
    for (size_t i = 0; i < spectrum->count; i++)
        if (in_band(spectrum, i, band_m)) {
            first = sums.n > 0 ? first : i;
            last = i;
            sums_add(&sums, log_wavelength(i), log_amplitude(spectrum, i));
        }
    law.harmonics = (size_t)sums.n;
    if (law.harmonics < 3) {
        law.band_m[0] = law.band_m[1] = NAN;
        return law;
    }
    law.band_m[0] = wavelength(spectrum, last);
    law.band_m[1] = wavelength(spectrum, first);

    struct line line = line_of(&sums);
    double variance = line.residual / (sums.n - 2);
    double log_length = log10(spectrum->length_m);
    double log_alpha = line.intercept - 6 - line.slope * log_length;
    double alpha = pow(10, log_alpha);
    if (!isnormal(alpha)) /* a steep law through a record of 1e-20 m */
        return law;
    law.gamma = line.slope;
    law.gamma_error = sqrt(variance / line.x_spread);
    law.alpha = alpha;
    law.misfit_decades = sqrt(line.residual / sums.n);
    law.found = POWER_LAW_BAND_LAW;
    law.wavelength_m = sqrt(law.band_m[0]) * sqrt(law.band_m[1]);
    law.amplitude_m = power_law_amplitude(&law, law.wavelength_m);
    double lever = log10(law.wavelength_m) - log_length - line.x_mean;
    law.amplitude_error_decades = sqrt(variance * (1 / sums.n + lever * lever / line.x_spread));
    law.psd_m3 = law.amplitude_m * law.amplitude_m * spectrum->length_m / 2;
    find_knee(&law, spectrum, first, last, &sums, line.residual);
    return law;
}

/** Factor of standard errors where a window correlates neighbouring residuals: sqrt(1 + 2 r), r their correlation. */
static double neighbours_factor(const struct spectrum *spectrum, const struct power_law *law)
{
    double before = NAN, squares = 0, products = 0;
    for (size_t i = 0; i < spectrum->count; i++) {
        if (!in_band(spectrum, i, law->band_m))
            continue;
        double r = log10(spectrum->amplitude_m[i] / power_law_amplitude(law, wavelength(spectrum, i)));
        squares += r * r;
        products += isnan(before) ? 0 : r * before;
        before = r;
    }
    return sqrt(1 + 2 * fmax(0, squares > 0 ? products / squares : 0));
}

static struct power_law scattered_law(const struct spectrum *spectrum, const double band_m[2])
{
    struct power_law law = power_law_fit(spectrum, band_m);
    if (law.found == POWER_LAW_BAND_NONE)
        return law;
    double factor = neighbours_factor(spectrum, &law);
    law.found = POWER_LAW_BAND_SCATTERED;
    law.gamma_error *= factor;
    law.amplitude_error_decades *= factor;
    law.knee_m = law.gamma_below = law.gamma_above = NAN;
    return law;
}

struct power_law power_law_of_band(const struct power_law_band *band, const struct spectrum *spectrum)
{
    struct power_law law = no_law(band->fit.band_m);
    if (band->law == POWER_LAW_BAND_SCATTERED)
        return scattered_law(spectrum, band->fit.band_m);
    const struct power_law_band_fit *fit = &band->fit;
    double alpha = pow(10, fit->log10_amplitude - fit->gamma * log10(fit->wavelength_m));
    if (band->law == POWER_LAW_BAND_NONE || !isnormal(alpha)) /* a steep law through a record of 1e-20 m */
        return law;
    law.found = band->law;
    law.alpha = alpha;
    law.gamma = fit->gamma;
    law.gamma_error = fit->gamma_s;
    law.amplitude_m = pow(10, fit->log10_amplitude);
    law.amplitude_error_decades = fit->log10_amplitude_s;
    law.wavelength_m = fit->wavelength_m;
    law.psd_m3 = band->psd_m3;
    law.misfit_decades = fit->misfit_decades;
    return law;
}

bool power_law_holds(const struct power_law *law)
{
    return law->found == POWER_LAW_BAND_LAW && isfinite(law->gamma);
}

double power_law_amplitude(const struct power_law *law, double wavelength_m)
{
    return law->alpha * pow(wavelength_m, law->gamma);
}

double power_law_error_decades(const struct power_law *law, double wavelength_m)
{
    return hypot(law->amplitude_error_decades, law->gamma_error * log10(wavelength_m / law->wavelength_m));
}
