/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "profile/synth.h"

#include "base/fft.h"
#include "scan/scan.h"
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct synth_def synth_def_default(void)
{
    return (struct synth_def){
        .alpha = 0.085, .gamma = 1.5, .length_m = 3e-4, .points = 1200, .scatter_decades = 0.2785, .seed = 1};
}

/** The harmonics; arrays of `count`, index n - 1. */
struct synth {
    const struct synth_def *def;
    size_t count;   /* the last is the Nyquist harmonic when the points are even */
    size_t in_band; /* harmonics with wavelength >= lambda_s: the first ones */
    double *xi[2];  /* two directions of scatter, each of RMS 1 in the band and orthogonal to 1 and log lambda there */
    double *amplitude, *phase;
};

/** The Nyquist harmonic has no sine part, and its mean square is the whole amplitude squared. */
static bool is_nyquist(const struct synth *synth, size_t i)
{
    return 2 * (i + 1) == synth->def->points;
}

static double log_index(size_t i)
{
    return log10((double)(i + 1));
}

/** Takes the mean and the straight line in log n out of the first `n` values and scales them to RMS 1. */
static void make_orthogonal(double *values, size_t n, const double *other)
{
    double sx = 0, sxx = 0, sy = 0, sxy = 0;
    for (size_t i = 0; i < n; i++) {
        double x = log_index(i);
        sx += x;
        sxx += x * x;
        sy += values[i];
        sxy += x * values[i];
    }
    double count = (double)n, slope = (count * sxy - sx * sy) / (count * sxx - sx * sx);
    double intercept = (sy - slope * sx) / count, projection = 0, norm = 0;
    for (size_t i = 0; i < n; i++) {
        values[i] -= intercept + slope * log_index(i);
        if (other)
            projection += values[i] * other[i] / count;
    }
    for (size_t i = 0; i < n; i++) {
        if (other)
            values[i] -= projection * other[i];
        norm += values[i] * values[i];
    }
    for (size_t i = 0; i < n; i++)
        values[i] /= sqrt(norm / count);
}

/** Amplitudes for one mixture of the two directions; returns the Rq they give. */
static double set_amplitudes(struct synth *synth, double angle)
{
    const struct synth_def *def = synth->def;
    double power = 0;
    for (size_t i = 0; i < synth->count; i++) {
        double wavelength = def->length_m / (double)(i + 1);
        double scatter = def->scatter_decades * (cos(angle) * synth->xi[0][i] + sin(angle) * synth->xi[1][i]);
        double amplitude = def->alpha * pow(wavelength, def->gamma) * pow(10, scatter);
        if (wavelength < def->lambda_s_m) /* Gaussian filter of ISO 16610-21, one half at lambda_s, relative to that */
            amplitude *= exp(-M_LN2 * (pow(def->lambda_s_m / wavelength, 2) - 1));
        synth->amplitude[i] = amplitude;
        power += amplitude * amplitude / (is_nyquist(synth, i) ? 1 : 2);
    }
    return sqrt(power);
}

/** Scales the amplitudes to Rq, or mixes the two directions of scatter until it is met. */
static enum status_code meet_rq(struct synth *synth, struct status *status)
{
    enum { STEPS = 720 };
    double target = synth->def->rq_m, turn = 2 * M_PI / STEPS, least = INFINITY, most = 0;
    double before = set_amplitudes(synth, 0);
    if (!(before <= scan_most_m && target <= scan_most_m))
        return status_fail(status, STATUS_USAGE, "Rq would be above %g m; correct --alpha, --gamma, --length or --rq",
                           scan_most_m);
    double factor = target / before;
    if (synth->def->scaled && target > 0 && isfinite(factor)) {
        for (size_t i = 0; i < synth->count; i++)
            synth->amplitude[i] *= factor;
        return STATUS_OK;
    }
    for (int k = 1; target > 0 && k <= STEPS; k++) {
        double after = set_amplitudes(synth, k * turn);
        least = fmin(least, after);
        most = fmax(most, after);
        if ((before - target) * (after - target) <= 0) {
            double low = (k - 1) * turn, high = k * turn;
            for (int i = 0; i < 80; i++) {
                double middle = (low + high) / 2, value = set_amplitudes(synth, middle);
                if ((before - target) * (value - target) <= 0)
                    high = middle;
                else
                    low = middle;
            }
            set_amplitudes(synth, (low + high) / 2);
            return STATUS_OK;
        }
        before = after;
    }
    if (target > 0)
        return status_fail(status, STATUS_USAGE,
                           "no scatter of %g decades with this seed gives an Rq of %g m (it can reach %.4g to %.4g); "
                           "change --length, --alpha, --scatter or --seed, or leave --alpha out to scale the profile",
                           synth->def->scatter_decades, target, least, most);
    return STATUS_OK;
}

/** Slope of the least-squares line of sin(2 pi n j/N), up to a factor common to all n: sum_j j sin(2 pi n j/N). */
static double line_of_sine(size_t n, size_t points)
{
    return -0.5 * (double)points / tan(M_PI * (double)n / (double)points);
}

/** Makes sum_j j z_j = 0 for z_j = sum a_n cos(2 pi n j/N + phase_n), to which a cosine part adds -N/2 and a sine part
 * line_of_sine(), by the phase of one harmonic. */
static bool make_level(struct synth *synth)
{
    size_t points = synth->def->points;
    for (size_t m = 0; m < synth->count && !is_nyquist(synth, m); m++) {
        double rest = 0, cosine = -0.5 * (double)points, sine = -line_of_sine(m + 1, points);
        for (size_t i = 0; i < synth->count; i++)
            if (i != m)
                rest += synth->amplitude[i] * (-0.5 * (double)points * cos(synth->phase[i]) -
                                               line_of_sine(i + 1, points) * sin(synth->phase[i]));
        /* amplitude (cosine cos p + sine sin p) = -rest */
        double wanted = -rest / (synth->amplitude[m] * hypot(cosine, sine));
        if (fabs(wanted) <= 1) {
            synth->phase[m] = atan2(sine, cosine) + acos(wanted);
            return true;
        }
    }
    return false;
}

static enum status_code check(const struct synth_def *def, struct status *status)
{
    if (def->points < 8 || def->points > 100000000)
        return status_fail(status, STATUS_USAGE, "--points must be 8 to 100000000");
    if (!(def->alpha > 0 && def->length_m > 0 && def->scatter_decades >= 0 && def->rq_m >= 0 && def->lambda_s_m >= 0 &&
          isfinite(def->gamma) && isfinite(def->alpha) && isfinite(def->length_m)))
        return status_fail(status, STATUS_USAGE,
                           "--alpha and --length must be positive, --scatter, --rq and --lambda-s "
                           "not negative");
    if (!(def->length_m <= scan_most_m && def->length_m / (double)def->points >= scan_least_m))
        return status_fail(status, STATUS_USAGE, "--length must be up to %g m, and points at least %g m apart",
                           scan_most_m, scan_least_m);
    if (def->scatter_decades > 2)
        return status_fail(status, STATUS_USAGE, "--scatter must be at most 2 decades");
    return STATUS_OK;
}

/** Sums the harmonics. */
static enum status_code transform(double *height_m, const struct synth *synth, struct status *status)
{
    size_t points = synth->def->points;
    OWNED(fft_room_free) struct fft_room room = {0};
    if (!fft_room_make(&room, points))
        return status_memory(status);
    for (size_t n = 0; n <= points / 2; n++) {
        bool has = n > 0 && n <= synth->count;
        double size = has ? synth->amplitude[n - 1] / (is_nyquist(synth, n - 1) ? 1 : 2) : 0;
        room.transform[n][0] = has ? size * cos(synth->phase[n - 1]) : 0;
        room.transform[n][1] = has ? size * sin(synth->phase[n - 1]) : 0;
    }
    bool done = fft_backward(room.record, room.transform, points);
    memcpy(height_m, room.record, points * sizeof *height_m);
    return done ? STATUS_OK : status_memory(status);
}

static enum status_code fill(struct synth *synth, double *height_m, struct status *status)
{
    const struct synth_def *def = synth->def;
    while (synth->in_band < synth->count &&
           def->length_m / (double)(synth->in_band + 1) >= def->lambda_s_m * (1 - 1e-12))
        synth->in_band++;
    if (def->scatter_decades > 0 && synth->in_band < 6)
        return status_fail(status, STATUS_USAGE,
                           "only %zu harmonics, scatter needs 6; give more points, a shorter --lambda-s or --scatter 0",
                           synth->in_band);
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    if (!random)
        return status_memory(status);
    gsl_rng_set(random, def->seed);
    size_t last = synth->count - 1, ordinary = is_nyquist(synth, last) ? last : synth->count;
    for (int d = 0; d < 2; d++)
        for (size_t i = 0; i < ordinary; i++)
            synth->xi[d][i] = gsl_ran_gaussian_ziggurat(random, 1);
    for (size_t i = 0; i < ordinary; i++)
        synth->phase[i] = 2 * M_PI * gsl_rng_uniform(random);
    for (int d = 0; d < 2 && ordinary == last; d++)
        synth->xi[d][last] = gsl_ran_gaussian_ziggurat(random, 1);
    if (ordinary == last)
        synth->phase[last] = 0;
    gsl_rng_free(random);
    if (def->scatter_decades > 0) {
        make_orthogonal(synth->xi[0], synth->in_band, NULL);
        make_orthogonal(synth->xi[1], synth->in_band, synth->xi[0]);
    }
    if (meet_rq(synth, status) != STATUS_OK)
        return status->code;
    if (!make_level(synth))
        return status_fail(status, STATUS_USAGE, "this law cannot be made level; use another --seed");
    return transform(height_m, synth, status);
}

enum status_code synth_profile(double *height_m, const struct synth_def *def, struct status *status)
{
    if (check(def, status) != STATUS_OK)
        return status->code;
    struct synth synth = {.def = def, .count = def->points / 2};
    OWNED(memory_free) double *block = malloc(4 * synth.count * sizeof *block);
    if (!block)
        return status_memory(status);
    synth.xi[0] = block;
    synth.xi[1] = block + synth.count;
    synth.amplitude = block + 2 * synth.count;
    synth.phase = block + 3 * synth.count;
    return fill(&synth, height_m, status);
}
