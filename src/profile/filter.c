/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "profile/filter.h"

#include "base/fft.h"
#include <math.h>
#include <string.h>

static const double filter_alpha = 0.46971863934982566; /* sqrt(ln 2/pi), ISO 16610-21 */
static const double filter_smallest = 1e-9;             /* weight at which the tail is cut, of the largest */

/** How many neighbours on either side have a weight; never more than there are. */
static size_t reach_of(size_t points, double spacing_m, double cutoff_m)
{
    double reach = filter_alpha * cutoff_m * sqrt(-log(filter_smallest) / M_PI) / spacing_m;
    return reach < (double)(points - 1) ? (size_t)reach : points - 1;
}

/** Adds up the neighbours of each of the first `points` values of `record`, weighted, by transforms: n log n whatever
 * the reach. `weights` is the transform of the weights, which are even; `length` values go around the ends.
 * False: out of memory. */
static bool add_up(double *record, fftw_complex *bins, const fftw_complex *weights, size_t points, size_t length)
{
    memset(record + points, 0, (length - points) * sizeof *record);
    if (!fft_forward(bins, record, length))
        return false;
    for (size_t k = 0; k <= length / 2; k++) {
        bins[k][0] *= weights[k][0] / (double)length;
        bins[k][1] *= weights[k][0] / (double)length;
    }
    return fft_backward(record, bins, length);
}

enum status_code filter_gaussian(double *smooth_m, const double *height_m, size_t points, double spacing_m,
                                 double cutoff_m, bool periodic, struct status *status)
{
    size_t reach = reach_of(points, spacing_m, cutoff_m), length = 1;
    while (length < points + reach)
        length *= 2;
    length = periodic ? points : length;
    double *record = fftw_alloc_real(length);
    fftw_complex *weights = fftw_alloc_complex(length / 2 + 1), *bins = fftw_alloc_complex(length / 2 + 1);
    bool good = record && weights && bins;
    if (good) {
        memset(record, 0, length * sizeof *record);
        for (size_t k = 0; k <= reach; k++) {
            double x = (double)k * spacing_m / (filter_alpha * cutoff_m), weight = exp(-M_PI * x * x);
            record[k] += weight;
            record[(length - k) % length] += k > 0 ? weight : 0;
        }
        good = fft_forward(weights, record, length);
        memcpy(record, height_m, points * sizeof *record);
        good = good && add_up(record, bins, weights, points, length);
        memcpy(smooth_m, record, points * sizeof *smooth_m);
        for (size_t i = 0; i < points; i++)
            record[i] = 1;
        good = good && add_up(record, bins, weights, points, length);
        for (size_t i = 0; i < points; i++) /* by the weights that lie within the record */
            smooth_m[i] /= record[i];
    }
    fftw_free(bins);
    fftw_free(weights);
    fftw_free(record);
    return good ? STATUS_OK : status_memory(status);
}
