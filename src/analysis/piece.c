/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/piece.h"

#include "base/large.h"
#include "profile/record_window.h"
#include <stdlib.h>
#include <string.h>

struct piece_how piece_how_of(const struct scene *scene, bool periodic)
{
    return (struct piece_how){scene->level, !scene->level_given, periodic, scene->window, scene->moments};
}

enum status_code piece_describe(struct spectrum *spectrum, struct roughness *roughness, const double *height_m,
                                size_t points, double spacing_m, const struct piece_how *how, struct status *status)
{
    bool periodic = how->periodic && record_window_is_periodic(height_m, points);
    enum level level = periodic && how->periodic_mean ? LEVEL_MEAN : how->level;
    struct levelling levelling;
    struct status none = {0};
    *spectrum = (struct spectrum){0};
    double *own_m = large_alloc(points, sizeof *own_m);
    if (!own_m)
        return status_memory(status);
    memcpy(own_m, height_m, points * sizeof *own_m);
    enum status_code rc = level_remove(&levelling, own_m, NULL, points, spacing_m, level, &none);
    if (rc != STATUS_MEMORY)
        rc = spectrum_compute(spectrum, own_m, points, spacing_m, spectrum_window_for(how->window, periodic), &none);
    if (rc == STATUS_OK) {
        *roughness = roughness_of_heights(own_m, points, spacing_m);
        if (how->moments == ROUGHNESS_MOMENTS_SPECTRAL)
            roughness_from_spectrum(roughness, spectrum);
    }
    free(own_m);
    return rc == STATUS_OK ? rc : status_memory(status);
}
