/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_surface.h"

#include "base/fft.h"
#include <assert.h>
#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

size_t direct_law_harmonics(const struct direct_law *law)
{
    return (size_t)fmax(1, floor(3.2 * law->length_m / law->lambda_s_m));
}

/** Delta_m/(alpha L^gamma). */
static double shape(const struct direct_law *law, size_t m)
{
    double above = (double)m / (law->length_m / law->lambda_s_m); /* lambda_s/lambda */
    return pow(fmax((double)m, law->roll_off), -law->gamma) * (above > 1 ? exp(-M_LN2 * (above * above - 1)) : 1);
}

double direct_law_amplitude(const struct direct_law *law, size_t m)
{
    return law->alpha * pow(law->length_m, law->gamma) * shape(law, m);
}

/** sums[k] = sum of m^k shape². */
static void sum_powers(double sums[3], const struct direct_law *law)
{
    sums[0] = sums[1] = sums[2] = 0;
    for (size_t m = 1, count = direct_law_harmonics(law); m <= count; m++) {
        double one = shape(law, m), power = one * one;
        for (int k = 0; k < 3; k++, power *= (double)m)
            sums[k] += power;
    }
}

/** Gives the law the exponent, within -2 ... 8, with which sums[2]/sums[0] = `wanted` (the ratio falls with the
 * exponent), and its sums. False: none. By secants of the logarithm of the ratio, which is nearly straight, with the
 * Illinois rule: 10 sums where bisection takes 52. */
static bool match_gamma(struct direct_law *law, double sums[3], double range[2], double wanted)
{
    enum { STEPS = 100 };
    double limits[2] = {8, -2}, off[2]; /* exponents where the ratio is too small and too large; by how much */
    size_t before = 2;
    for (int end = 0; end < 2; end++) {
        law->gamma = limits[end];
        sum_powers(sums, law);
        range[end] = sums[2] / sums[0];
        off[end] = log(range[end] / wanted);
    }
    if (!(off[0] <= 0 && off[1] >= 0))
        return false;
    for (int i = 0; i < STEPS; i++) {
        double last = law->gamma;
        law->gamma = off[1] > off[0] ? (limits[0] * off[1] - limits[1] * off[0]) / (off[1] - off[0]) : limits[0];
        sum_powers(sums, law);
        double now = log(sums[2] / sums[0] / wanted);
        size_t side = now > 0;
        limits[side] = law->gamma;
        off[side] = now;
        off[!side] *= side == before ? 0.5 : 1;
        before = side;
        if (fabs(now) < 1e-15 || fabs(law->gamma - last) < 1e-15)
            break;
    }
    return true;
}

enum status_code direct_law_match(struct direct_law *out, const double moments[3], double length_m, double lambda_s_m,
                                  struct status *status)
{
    double m0_m2 = moments[0], m2 = moments[2], sums[3], range[2];
    *out = (struct direct_law){NAN, NAN, lambda_s_m, length_m, 1};
    if (!(m0_m2 > 0 && moments[1] > 0 && m2 > 0 && length_m > 0 && lambda_s_m > 0 && lambda_s_m <= length_m))
        return status_fail(status, STATUS_MODEL,
                           "no power law can be matched to m0 = %g m², m1 = %g m, m2 = %g, L = %g m and lambda_s = "
                           "%g m",
                           m0_m2, moments[1], m2, length_m, lambda_s_m);
    double low = 1, high = fmax(1, length_m / lambda_s_m / 1.5);
    double wanted = m2 / m0_m2 * pow(length_m / (2 * M_PI), 2), share = moments[1] / sqrt(m0_m2 * m2);
    if (!match_gamma(out, sums, range, wanted))
        return status_fail(status, STATUS_MODEL,
                           "no power law cut off at %g m has the measured heights and slopes (rms %g m and %g): it "
                           "reaches slopes from %.3g to %.3g; take a finer grid, or another lambda_s",
                           lambda_s_m, sqrt(m0_m2), sqrt(m2), sqrt(range[0] * m2 / wanted),
                           sqrt(range[1] * m2 / wanted));
    while (high - low > 1e-12 * high) { /* m1/sqrt(m0 m2) rises with the roll-off until no gamma is steep enough */
        out->roll_off = (low + high) / 2;
        bool found = match_gamma(out, sums, range, wanted);
        if (found && sums[1] < share * sqrt(sums[0] * sums[2]))
            low = out->roll_off;
        else
            high = out->roll_off;
    }
    out->roll_off = low;
    (void)match_gamma(out, sums, range, wanted);
    out->alpha = sqrt(2 * m0_m2 / sums[0]) / pow(length_m, out->gamma);
    return STATUS_OK;
}

/** Variance over weight. */
static double between(const struct direct_spectrum *spectrum, double r)
{
    return pow(fmax(r, spectrum->roll_off), -spectrum->exponent);
}

enum status_code direct_spectrum_of_law(struct direct_spectrum *out, const struct direct_law *law,
                                        struct status *status)
{
    size_t count = direct_law_harmonics(law);
    *out = (struct direct_spectrum){calloc(count + 2, sizeof(double)), count, 2 * law->gamma + 1, law->roll_off};
    if (!out->weight_m2)
        return status_memory(status);
    double *w = out->weight_m2, end = (double)((count + 1) * (count + 1));
    for (size_t m = count; m >= 1; m--) {
        /* P1(m)/2 = v(m, 0) + 2 sum_{j > 0} v(m, j); only the part with w_m is not known yet */
        double known = 0, factor = between(out, (double)m);
        for (size_t j = 1; (double)(m * m + j * j) < end; j++) {
            double r = sqrt((double)(m * m + j * j)), power = 2 * between(out, r);
            size_t below = (size_t)r;
            double share = r - (double)below;
            known += power * share * w[below]; /* w_{below + 1} */
            if (below == m)
                factor += power * (1 - share);
            else
                known += power * (1 - share) * w[below - 1];
        }
        w[m - 1] = (pow(direct_law_amplitude(law, m), 2) / 4 - known) / factor;
        if (!(w[m - 1] >= 0))
            return status_fail(status, STATUS_MODEL,
                               "no isotropic surface has rows of the law with gamma = %g: it would need negative "
                               "powers",
                               law->gamma);
    }
    return STATUS_OK;
}

void direct_spectrum_free(struct direct_spectrum *spectrum)
{
    free(spectrum->weight_m2);
    *spectrum = (struct direct_spectrum){0};
}

double direct_spectrum_variance(double r, const void *context)
{
    const struct direct_spectrum *spectrum = context;
    size_t below = (size_t)r;
    if (below > spectrum->count || below < 1)
        return 0;
    double share = r - (double)below;
    return ((1 - share) * spectrum->weight_m2[below - 1] + share * spectrum->weight_m2[below]) * between(spectrum, r);
}

/** splitmix64's finaliser (Steele, Lea and Flood 2014; Vigna). Whole numbers: the same everywhere. */
static uint64_t mix(uint64_t x)
{
    x += 0x9E3779B97F4A7C15u;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
}

double direct_random(uint64_t seed, uint64_t index)
{
    return ldexp((double)(mix(mix(seed) ^ index) >> 11), -53);
}

/** Phase of the mode (i, j) of the half plane j > 0 or (j = 0, i > 0). */
static double phase(uint64_t seed, long i, long j)
{
    uint64_t index = ((uint64_t)(i + 32768) << 16) | (uint64_t)(j + 32768);
    return 2 * M_PI * direct_random(seed, index);
}

/** Heights of n x n points, or their transform in the same place. */
struct modes {
    size_t n, stride;
    double *field;     /* n x stride */
    double *amplitude; /* sqrt(v) of |i|, |j| = 0 ... n/2, square; NULL where not asked for */
    fftw_plan forward, backward;
};

static void modes_free(struct modes *modes)
{
    fft_plan_free(modes->forward);
    fft_plan_free(modes->backward);
    fftw_free(modes->field);
    free(modes->amplitude);
}

static void plan_modes(void *context)
{
    struct modes *modes = context;
    int n = (int)modes->n;
    fftw_complex *spectrum = (fftw_complex *)modes->field;
    modes->forward = fftw_plan_dft_r2c_2d(n, n, modes->field, spectrum, FFTW_ESTIMATE);
    modes->backward = fftw_plan_dft_c2r_2d(n, n, spectrum, modes->field, FFTW_ESTIMATE);
}

static enum status_code modes_make(struct modes *out, size_t n, struct status *status)
{
    assert(n >= 4 && n % 2 == 0);
    *out = (struct modes){.n = n, .stride = n + 2, .field = fftw_alloc_real(n * (n + 2))};
    if (!out->field)
        return status_memory(status);
    fft_plan(plan_modes, out);
    memset(out->field, 0, n * out->stride * sizeof(double));
    return STATUS_OK;
}

/** The table of amplitudes; none at n/2 and none for the mean. */
static enum status_code modes_amplitudes(struct modes *modes, direct_variance *variance, const void *context,
                                         struct status *status)
{
    size_t half = modes->n / 2;
    modes->amplitude = calloc((half + 1) * (half + 1), sizeof(double));
    if (!modes->amplitude)
        return status_memory(status);
    for (size_t j = 0; j < half; j++)
        for (size_t i = 0; i < half; i++) {
            double v = i + j > 0 ? variance(sqrt((double)(i * i + j * j)), context) : 0;
            if (!(v >= 0) || !isfinite(v))
                return status_fail(status, STATUS_MODEL,
                                   "the surface's spectrum is negative or not finite at (%zu, %zu)", i, j);
            modes->amplitude[j * (half + 1) + i] = sqrt(v);
        }
    return STATUS_OK;
}

/** Complex mode of column i, row j of the transform. */
static double *mode_at(const struct modes *modes, size_t i, size_t j)
{
    return modes->field + j * modes->stride + 2 * i;
}

static double amplitude_at(const struct modes *modes, size_t i, size_t j)
{
    return modes->amplitude[(j <= modes->n / 2 ? j : modes->n - j) * (modes->n / 2 + 1) + i];
}

static void store(double *height_m, const struct modes *modes)
{
    for (size_t j = 0; j < modes->n; j++)
        memcpy(height_m + j * modes->n, modes->field + j * modes->stride, modes->n * sizeof(double));
}

/** A Gaussian surface. */
static void realise(double *height_m, struct modes *modes, uint64_t seed)
{
    size_t n = modes->n;
    for (size_t j = 0; j < n; j++)
        for (size_t i = 0; i < n / 2; i++) {
            long x = (long)i, y = j < n / 2 ? (long)j : (long)j - (long)n;
            bool upper = y > 0 || (y == 0 && x > 0); /* else it is the conjugate of (-x, -y) */
            double angle = upper ? phase(seed, x, y) : -phase(seed, -x, -y), *mode = mode_at(modes, i, j);
            mode[0] = amplitude_at(modes, i, j) * cos(angle);
            mode[1] = amplitude_at(modes, i, j) * sin(angle);
        }
    fftw_execute(modes->backward);
    store(height_m, modes);
}

enum status_code direct_surface_refine(double *fine_m, size_t times, const double *height_m, size_t n,
                                       struct status *status)
{
    struct modes coarse, fine;
    if (modes_make(&coarse, n, status) != STATUS_OK)
        return status->code;
    if (modes_make(&fine, times * n, status) == STATUS_OK) {
        for (size_t j = 0; j < n; j++)
            memcpy(coarse.field + j * coarse.stride, height_m + j * n, n * sizeof(double));
        fftw_execute(coarse.forward);
        for (size_t j = 0; j < n; j++)
            for (size_t i = 0; i < n / 2 && j != n / 2; i++)
                for (int part = 0; part < 2; part++)
                    mode_at(&fine, i, j < n / 2 ? j : times * n - (n - j))[part] =
                        mode_at(&coarse, i, j)[part] / (double)(n * n);
        fftw_execute(fine.backward);
        store(fine_m, &fine);
        modes_free(&fine);
    }
    modes_free(&coarse);
    return status->code;
}

/** `count` quantiles of the given heights, ascending, of mean 0 and the given mean square. */
static enum status_code quantiles(double *out, size_t count, const struct direct_recipe *recipe, double mean_square,
                                  struct status *status)
{
    const double *given_m = recipe->given_m;
    const size_t given_count = recipe->given_count;
    OWNED(memory_free) double *sorted = malloc((given_count + 1) * sizeof *sorted);
    double mean = 0, square = 0;
    if (!sorted)
        return status_memory(status);
    bool finite = given_count >= 2;
    for (size_t k = 0; k < given_count; k++) {
        sorted[k] = given_m[k];
        finite &= isfinite(given_m[k]) != 0;
    }
    gsl_sort(sorted, 1, given_count);
    if (!finite || !(sorted[given_count - 1] > sorted[0]))
        return status_fail(status, STATUS_MODEL, "the heights to give a surface are too few, all equal or not finite");
    for (size_t k = 0; k < count; k++) {
        double at = ((double)k + 0.5) / (double)count * (double)given_count - 0.5;
        at = fmin(fmax(at, 0), (double)(given_count - 1));
        size_t below = (size_t)fmin(floor(at), (double)(given_count - 2));
        out[k] = sorted[below] + (at - (double)below) * (sorted[below + 1] - sorted[below]);
        mean += (out[k] - sorted[0]) / (double)count;
    }
    mean += sorted[0];
    for (size_t k = 0; k < count; k++) {
        out[k] -= mean;
        square += out[k] * out[k] / (double)count;
    }
    for (size_t k = 0; k < count; k++)
        out[k] *= sqrt(mean_square / square);
    return STATUS_OK;
}

/** Gives every mode its amplitude and keeps its phase (0 for a mode that is 0). Returns the rms change of the heights
 * over their rms. */
static double impose_amplitudes(struct modes *modes)
{
    double points = (double)(modes->n * modes->n), changed = 0, all = 0;
    fftw_execute(modes->forward);
    for (size_t j = 0; j < modes->n; j++)
        for (size_t i = 0; i <= modes->n / 2; i++) {
            double *mode = mode_at(modes, i, j), amplitude = amplitude_at(modes, i, j);
            double size = sqrt(mode[0] * mode[0] + mode[1] * mode[1]), change = size / points - amplitude;
            mode[0] = size > 0 ? mode[0] * (amplitude / size) : amplitude;
            mode[1] = size > 0 ? mode[1] * (amplitude / size) : 0;
            changed += change * change;
            all += amplitude * amplitude;
        }
    fftw_execute(modes->backward);
    return sqrt(changed / all);
}

/** Indices of the values in ascending order, to 2^-32 of their range, equal values in the order of their indices: a
 * radix sort. `order`: 2 count, the second half is room. */
static void rank(uint64_t *order, const double *values, size_t count)
{
    enum {
        DIGIT = 8,
        DIGITS = 4,
        SHIFT = 32
    }; /* bits of a digit; an even number of digits, above the bits of an index */
    uint64_t *from = order, *to = order + count, place = ((uint64_t)1 << SHIFT) - 1;
    size_t start[DIGITS][1 << DIGIT] = {{0}};
    double low = values[0], high = values[0];
    for (size_t k = 1; k < count; k++) {
        low = values[k] < low ? values[k] : low;
        high = values[k] > high ? values[k] : high;
    }
    double scale = high > low ? (double)place / (high - low) : 0;
    for (size_t k = 0; k < count; k++) {
        uint64_t step = (uint64_t)((values[k] - low) * scale);
        from[k] = step << SHIFT | k;
        for (size_t d = 0; d < DIGITS; d++)
            start[d][step >> (d * DIGIT) & ((1 << DIGIT) - 1)]++;
    }
    for (size_t d = 0; d < DIGITS; d++) {
        for (size_t i = 0, before = 0, here; i < 1 << DIGIT; i++, before += here) {
            here = start[d][i];
            start[d][i] = before;
        }
        for (size_t k = 0; k < count; k++)
            to[start[d][from[k] >> (SHIFT + d * DIGIT) & ((1 << DIGIT) - 1)]++] = from[k];
        uint64_t *other = from;
        from = to;
        to = other;
    }
    for (size_t k = 0; k < count; k++)
        order[k] &= place;
}

/** Rounds until one changes the heights by less than 3e-3 of their rms; values: n² of room, order: 2 n². */
static void adjust(struct modes *modes, const double *heights, double *values, uint64_t *order, uint64_t seed)
{
    enum { ROUNDS = 60 };
    size_t n = modes->n, count = n * n;
    double changed = 1;
    for (size_t k = 0; k < count; k++)
        values[k] = direct_random(seed, k);
    for (int round = 0; round <= ROUNDS && changed > 3e-3; round++) {
        rank(order, values, count);
        for (size_t k = 0; k < count; k++)
            values[order[k]] = heights[k];
        for (size_t j = 0; j < n; j++)
            memcpy(modes->field + j * modes->stride, values + j * n, n * sizeof *values);
        changed = impose_amplitudes(modes);
        store(values, modes);
    }
}

/** A surface with given heights. */
static enum status_code give_heights(double *height_m, struct modes *modes, const struct direct_recipe *recipe,
                                     uint64_t seed, struct status *status)
{
    size_t n = modes->n;
    double mean_square = 0, *heights = malloc(n * n * sizeof *heights);
    OWNED(memory_free) uint64_t *order = malloc(2 * n * n * sizeof *order);
    for (size_t j = 0; j < n; j++)
        for (size_t i = 0; i < n / 2; i++)
            mean_square += (i > 0 ? 2 : 1) * pow(amplitude_at(modes, i, j), 2);
    if (!heights || !order)
        (void)status_memory(status);
    else if (quantiles(heights, n * n, recipe, mean_square, status) == STATUS_OK)
        adjust(modes, heights, height_m, order, seed);
    free(heights);
    return status->code;
}

enum status_code direct_surface_make(double *height_m, size_t n, const struct direct_recipe *recipe, uint64_t seed,
                                     struct status *status)
{
    struct modes modes;
    if (modes_make(&modes, n, status) != STATUS_OK)
        return status->code;
    if (modes_amplitudes(&modes, recipe->variance, recipe->context, status) == STATUS_OK) {
        if (recipe->given_m)
            (void)give_heights(height_m, &modes, recipe, seed, status);
        else
            realise(height_m, &modes, seed);
    }
    modes_free(&modes);
    return status->code;
}
