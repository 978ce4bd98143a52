#include "analysis/piece.h"

#include <stdlib.h>
#include <string.h>

struct piece_how piece_how_of(const struct scene *scene)
{
    return (struct piece_how){scene->level, scene->window, scene->moments};
}

enum status_code piece_describe(struct spectrum *spectrum, struct roughness *roughness, const double *height_m,
                                size_t points, double spacing_m, const struct piece_how *how, struct status *status)
{
    struct levelling levelling;
    struct status none = {0};
    *spectrum = (struct spectrum){0};
    double *own_m = malloc(points * sizeof *own_m);
    if (!own_m)
        return status_memory(status);
    memcpy(own_m, height_m, points * sizeof *own_m);
    enum status_code rc = level_remove(&levelling, own_m, NULL, points, spacing_m, how->level, &none);
    if (rc != STATUS_MEMORY)
        rc = spectrum_compute(spectrum, own_m, points, spacing_m, how->window, &none);
    if (rc == STATUS_OK) {
        *roughness = roughness_of_heights(own_m, points, spacing_m);
        if (how->moments == ROUGHNESS_MOMENTS_SPECTRAL)
            roughness_from_spectrum(roughness, spectrum);
    }
    free(own_m);
    return rc == STATUS_OK ? rc : status_memory(status);
}
