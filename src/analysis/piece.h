/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A piece of a profile, or a record made like one, as the models see it. */
#ifndef ANALYSIS_PIECE_H
#define ANALYSIS_PIECE_H

#include "scene/scene.h"

/** How a piece is made ready: as the scan that it is of. */
struct piece_how {
    enum level level;
    bool periodic_mean;          /* of a periodic piece the mean is taken out instead */
    bool periodic;               /* the scan closes on itself, so that a piece may */
    enum spectrum_window window; /* auto: by whether the piece closes on itself */
    enum roughness_moments moments;
};
struct piece_how piece_how_of(const struct scene *scene, bool periodic);

/** Levels a copy of the heights and takes its spectrum (owned: spectrum_free()) and roughness; of a periodic scan it is
 * looked at whether the piece closes too. A form that no longer fits leaves it as it is. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code piece_describe(struct spectrum *spectrum, struct roughness *roughness,
                                           const double *height_m, size_t points, double spacing_m,
                                           const struct piece_how *how, struct status *status);

/** The same of the heights in room->record, which are used up; how->periodic: they close on themselves. */
MUST_CHECK enum status_code piece_of_record(struct spectrum *spectrum, struct roughness *roughness,
                                            struct fft_room *room, size_t points, double spacing_m,
                                            const struct piece_how *how, struct status *status);

#endif
