/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "profile/filter.h"

#include "base/fft.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double filter_alpha = 0.46971863934982566; /* sqrt(ln 2/pi), ISO 16610-21 */
static const double filter_smallest = 1e-9;             /* weight at which the tail is cut, of the largest */

/** How many neighbours on either side have a weight; never more than there are. */
static size_t reach_of(size_t points, double spacing_m, double cutoff_m)
{
    double reach = filter_alpha * cutoff_m * sqrt(-log(filter_smallest) / M_PI) / spacing_m;
    return reach < (double)(points - 1) ? (size_t)reach : points - 1;
}

/** Divides by the sum of the weights that lie within the record. `kernel` holds weight k at [k]. */
static void renormalise(double *smooth, const double *kernel, size_t points, size_t reach, bool periodic)
{
    double right = kernel[0], left = 0; /* of the point itself and those after it; of those before */
    for (size_t k = 1; k <= reach; k++)
        right += kernel[k];
    for (size_t i = 0; i < points && periodic; i++)
        smooth[i] /= 2 * right - kernel[0];
    for (size_t i = 0; i < points && !periodic; i++) {
        smooth[i] /= left + right;
        if (i + 1 <= reach)
            left += kernel[i + 1];
        if (points - 1 - i <= reach)
            right -= kernel[points - 1 - i];
    }
}

/** The weighted sums of all points at once, by transforms: n log n whatever the reach. A transform of the record's own
 * length goes around its ends. */
static enum status_code convolve(double *smooth, const double *height_m, const double *kernel, size_t points,
                                 size_t reach, bool periodic, struct status *status)
{
    size_t length = 1;
    while (length < points + reach)
        length *= 2;
    length = periodic ? points : length;
    double *record = fftw_alloc_real(length);
    fftw_complex *weights = fftw_alloc_complex(length / 2 + 1), *heights = fftw_alloc_complex(length / 2 + 1);
    enum status_code code = STATUS_OK;
    if (record && weights && heights) {
        memset(record, 0, length * sizeof *record);
        record[0] = kernel[0];
        for (size_t k = 1; k <= reach; k++) {
            record[k] += kernel[k];
            record[length - k] += kernel[k];
        }
        fft_forward(weights, record, length);
        memset(record, 0, length * sizeof *record);
        memcpy(record, height_m, points * sizeof *record);
        fft_forward(heights, record, length);
        for (size_t k = 0; k <= length / 2; k++) { /* the weights are even: their transform is real */
            heights[k][0] *= weights[k][0] / (double)length;
            heights[k][1] *= weights[k][0] / (double)length;
        }
        fft_backward(record, heights, length);
        memcpy(smooth, record, points * sizeof *smooth);
    } else {
        code = status_memory(status);
    }
    fftw_free(heights);
    fftw_free(weights);
    fftw_free(record);
    return code;
}

enum status_code filter_gaussian(double *smooth_m, const double *height_m, size_t points, double spacing_m,
                                 double cutoff_m, bool periodic, struct status *status)
{
    size_t reach = reach_of(points, spacing_m, cutoff_m);
    double *kernel = malloc((reach + 1) * sizeof *kernel);
    if (!kernel)
        return status_memory(status);
    for (size_t k = 0; k <= reach; k++) {
        double x = (double)k * spacing_m / (filter_alpha * cutoff_m);
        kernel[k] = exp(-M_PI * x * x);
    }
    enum status_code code = convolve(smooth_m, height_m, kernel, points, reach, periodic, status);
    if (code == STATUS_OK)
        renormalise(smooth_m, kernel, points, reach, periodic);
    free(kernel);
    return code;
}
