/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/piece.h"

#include "profile/record_window.h"
#include <string.h>

struct piece_how piece_how_of(const struct scene *scene, bool periodic)
{
    return (struct piece_how){scene->level, !scene->level_given, periodic, scene->window, scene->moments};
}

enum status_code piece_of_record(struct spectrum *spectrum, struct roughness *roughness, struct fft_room *room,
                                 size_t points, double spacing_m, const struct piece_how *how, struct status *status)
{
    double *height_m = room->record;
    enum level level = how->periodic && how->periodic_mean ? LEVEL_MEAN : how->level;
    struct levelling levelling;
    struct status none = {0};
    *spectrum = (struct spectrum){0};
    if (level_remove(&levelling, height_m, NULL, points, spacing_m, level, &none) == STATUS_MEMORY)
        return status_memory(status);
    *roughness = roughness_of_heights(height_m, points, spacing_m);
    enum spectrum_window window = spectrum_window_for(how->window, how->periodic);
    if (spectrum_of_record(spectrum, room, points, spacing_m, window, status) != STATUS_OK)
        return status->code;
    if (how->moments == ROUGHNESS_MOMENTS_SPECTRAL)
        roughness_from_spectrum(roughness, spectrum);
    return STATUS_OK;
}

enum status_code piece_describe(struct spectrum *spectrum, struct roughness *roughness, const double *height_m,
                                size_t points, double spacing_m, const struct piece_how *how, struct status *status)
{
    struct fft_room room;
    struct piece_how own = *how;
    own.periodic = how->periodic && record_window_is_periodic(height_m, points);
    *spectrum = (struct spectrum){0};
    if (!fft_room_make(&room, points))
        return status_memory(status);
    memcpy(room.record, height_m, points * sizeof *height_m);
    enum status_code rc = piece_of_record(spectrum, roughness, &room, points, spacing_m, &own, status);
    fft_room_free(&room);
    return rc;
}
