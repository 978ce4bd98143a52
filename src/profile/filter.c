/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "profile/profile.h"

#include "base/fft.h"
#include <math.h>
#include <string.h>

static const double filter_alpha = 0.46971863934982566; /* sqrt(ln 2/pi), ISO 16610-21 */
static const double filter_smallest = 1e-9;             /* weight at which the tail is cut, of the largest */
enum { NEAR = 24 }; /* up to so many neighbours on either side a sum is quicker than transforms */

/** How many neighbours on either side have a weight; at most all. */
static size_t reach_of(const struct profile *profile, double cutoff_m)
{
    double reach = filter_alpha * cutoff_m * sqrt(-log(filter_smallest) / M_PI) / profile->spacing_m;
    return reach < (double)(profile->points - 1) ? (size_t)reach : profile->points - 1;
}

static double weight_of(size_t apart, double spacing_m, double cutoff_m)
{
    double x = (double)apart * spacing_m / (filter_alpha * cutoff_m);
    return exp(-M_PI * x * x);
}

/** The weighted sums themselves; reach < points. */
static void add_near(double *smooth_m, const struct profile *profile, const double *weight, size_t reach)
{
    const double *height_m = profile->height_m;
    const size_t points = profile->points;
    for (size_t i = 0; i < points; i++) {
        double sum = weight[0] * height_m[i], whole = weight[0];
        for (size_t k = 1; k <= reach; k++) {
            bool before = profile->periodic || i >= k, after = profile->periodic || i + k < points;
            sum += weight[k] * ((before ? height_m[i >= k ? i - k : i + points - k] : 0) +
                                (after ? height_m[i + k < points ? i + k : i + k - points] : 0));
            whole += weight[k] * (before + after);
        }
        smooth_m[i] = sum / whole;
    }
}

/** The weighted sums of the first `points` values of room->record by transforms of `length`; `weights` is the transform
 * of the weights, which are even. False: out of memory. */
static bool add_up(struct fft_room *room, const fftw_complex *weights, size_t points, size_t length)
{
    memset(room->record + points, 0, (length - points) * sizeof *room->record);
    if (!fft_forward(room->transform, room->record, length))
        return false;
    for (size_t k = 0; k <= length / 2; k++) {
        room->transform[k][0] *= weights[k][0] / (double)length;
        room->transform[k][1] *= weights[k][0] / (double)length;
    }
    return fft_backward(room->record, room->transform, length);
}

enum status_code filter_gaussian(double *smooth_m, const struct profile *profile, double cutoff_m,
                                 struct status *status)
{
    size_t points = profile->points, reach = reach_of(profile, cutoff_m), length = 1;
    if (reach <= NEAR) {
        double weight[NEAR + 1];
        for (size_t k = 0; k <= reach; k++)
            weight[k] = weight_of(k, profile->spacing_m, cutoff_m);
        add_near(smooth_m, profile, weight, reach);
        return STATUS_OK;
    }
    while (length < points + reach)
        length *= 2;
    length = profile->periodic ? points : length;
    OWNED(fft_room_free) struct fft_room room = {0}, weights = {0};
    bool good = fft_room_make(&room, length) && fft_room_make(&weights, length);
    if (good) {
        memset(weights.record, 0, length * sizeof *weights.record);
        for (size_t k = 0; k <= reach; k++) {
            double weight = weight_of(k, profile->spacing_m, cutoff_m);
            weights.record[k] += weight;
            weights.record[(length - k) % length] += k > 0 ? weight : 0;
        }
        good = fft_forward(weights.transform, weights.record, length);
        memcpy(room.record, profile->height_m, points * sizeof *room.record);
        good = good && add_up(&room, weights.transform, points, length);
        memcpy(smooth_m, room.record, points * sizeof *smooth_m);
        for (size_t i = 0; i < points; i++)
            room.record[i] = 1;
        good = good && add_up(&room, weights.transform, points, length);
        for (size_t i = 0; i < points; i++) /* by the weights that lie within the record */
            smooth_m[i] /= room.record[i];
    }
    return good ? STATUS_OK : status_memory(status);
}
