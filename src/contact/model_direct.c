/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The direct solution of a map, carried to any load. */
#include "contact/model.h"

extern const struct model_row model_corrected_persson, model_corrected_persson_plastic;

static enum status_code run(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                            struct status *status)
{
    struct transfer_point point;
    (void)status;
    for (size_t i = 0; task->transfer && i < task->load_count; i++) {
        if (!transfer_at(&point, task->transfer, row->plastic, task->loads[i]))
            break;
        curve->points[curve->count++] = model_point(&point, row, task);
    }
    curve->exists = curve->count > 0; /* complete contact is beyond */
    curve->evaluations = curve->count;
    return STATUS_OK;
}

#define VALID                                                                                                          \
    "A/A_n up to 0.97 (it ends there); at the map's resolution: area, separation and resistance as its grid, its "     \
    "low-pass and its quarters tell"

const struct model_row model_direct = {
    .name = "direct",
    .label = "direct solution of the map",
    .family = "direct",
    .precedence = 9,
    .gaussian = &model_corrected_persson,
    .uses_map = true,
    MODEL_OF_CORRECTED_PERSSON,
    .colour = "#E07B39",
    .marker = 14,
    .does = "solves the contact of the map itself, without yield",
    .equations = "at equal area p = p_G p₁/p_G1, and so ℓ and the gap; 1 the squares solved, G1 Gaussian heights of "
                 "their spectrum (direct transfer)",
    .source = "Polonsky and Keer, Wear 231 (1999) 206; resistance: the same kernel on the points in contact; between "
              "loads by Gaussian heights of the same spectrum at equal area",
    .assumes = "the map is the surface, and goes on as its mirror image; small slopes; no yield",
    .valid = VALID,
    .method = "conjugate gradients on the map's grid at up to 32 loads",
    .run = run,
};

const struct model_row model_direct_plastic = {
    .name = "direct-plastic",
    .label = "direct solution of the map with hardness",
    .family = "direct",
    .precedence = 10,
    .plastic = true,
    .elastic = &model_direct,
    .gaussian = &model_corrected_persson_plastic,
    .uses_map = true,
    MODEL_OF_CORRECTED_PERSSON,
    .stiffness_step = 0.1, /* one step of the grid that it lies on */
    .colour = "#A94A0E",
    .marker = 15,
    .does = "solves the contact of the map itself, with no pressure above the hardness",
    .equations = "area, gap and resistance as under hardness, times their ratio to these in the squares solved with no "
                 "pressure above H (direct transfer)",
    .source = "as direct; no pressure above the hardness: Almqvist, Sahlin, Larsson and Glavatskih, Tribol. Int. 40 "
              "(2007) 574",
    .assumes = "as direct, with yield: no pressure above the hardness; no hardening",
    .valid = VALID,
    .method = "conjugate gradients on the map's grid, pressures between 0 and the hardness",
    .run = run,
};
