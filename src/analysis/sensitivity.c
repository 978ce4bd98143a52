/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/sensitivity.h"

#include <math.h>
#include <string.h>

const struct sensitivity_change_row sensitivity_changes[SENSITIVITY_CHANGES] = {
    [SENSITIVITY_CUTOFF_DOUBLED] = {"cut-off x2", false},
    [SENSITIVITY_SCAN_HALVED] = {"scan /2", false},
    [SENSITIVITY_HARDNESS_RAISED] = {"hardness x1.1", true},
};

/** What hardness and yield strength are raised by: 1.1, about how well they are known of a metal whose state is not. */
static const double sensitivity_hardness_factor = 1.1;

enum { LEAST_POINTS = 16 };

/** Half of the profile, or the whole of it, smoothed or not, in room->record. */
static enum status_code take_variant(struct fft_room *room, size_t points, enum sensitivity_variant variant,
                                     const struct profile *profile, double lambda_s_m, struct status *status)
{
    double cutoff_m = 2 * (lambda_s_m > 0 ? lambda_s_m : 2 * profile->spacing_m);
    if (variant == SENSITIVITY_CUTOFF)
        return filter_gaussian(room->record, profile->height_m, points, profile->spacing_m, cutoff_m, profile->periodic,
                               status);
    const double *first_m = profile->height_m + (variant == SENSITIVITY_SECOND_HALF ? profile->points - points : 0);
    memcpy(room->record, first_m, points * sizeof *first_m);
    return STATUS_OK;
}

/** Adds a scan's variant, whose spectrum it takes over, to the mean over `so_far` of them. */
static enum status_code add_mean(struct member *mean, size_t so_far, struct member *own, struct status *status)
{
    if (so_far == 0) {
        *mean = *own;
        return STATUS_OK;
    }
    roughness_average(&mean->roughness, &own->roughness, so_far);
    enum status_code rc = grid_average(&mean->spectrum, &own->spectrum, so_far, status);
    spectrum_free(&own->spectrum);
    return rc;
}

/** One variant of a profile. */
static enum status_code add_variant(struct member *mean, size_t so_far, enum sensitivity_variant variant,
                                    const struct profile *profile, const struct profile_options *how,
                                    const struct record_conditioning *record, struct status *status)
{
    bool whole = variant == SENSITIVITY_CUTOFF || variant == SENSITIVITY_WHOLE;
    size_t points = whole ? profile->points : profile->points / 2;
    struct fft_room room;
    struct member own;
    if (!fft_room_make(&room, points))
        return status_memory(status);
    enum status_code rc = take_variant(&room, points, variant, profile, how->lambda_s_m, status);
    if (rc == STATUS_OK)
        rc = member_of_record(&own, &room, points, profile->spacing_m, record, false, status);
    fft_room_free(&room);
    return rc == STATUS_OK ? add_mean(mean, so_far, &own, status) : rc;
}

enum status_code sensitivity_add(struct sensitivity *out, const struct profile *profile,
                                 const struct profile_options *how, enum spectrum_window window,
                                 enum roughness_moments moments, struct status *status)
{
    struct record_conditioning record = {how->level, how->periodic_mean, false, window, moments};
    if (profile->points < LEAST_POINTS)
        return STATUS_OK;
    for (int variant = 0; variant < SENSITIVITY_VARIANTS; variant++) {
        record.periodic = profile->periodic && variant == SENSITIVITY_CUTOFF;
        out->levelled[variant] =
            how->level >= LEVEL_LINE && !(record.periodic && how->periodic_mean) && !(how->lambda_c_m > 0);
        if (add_variant(&out->variants[variant], out->scans, (enum sensitivity_variant)variant, profile, how, &record,
                        status) != STATUS_OK)
            return status->code;
    }
    out->scans++;
    return STATUS_OK;
}

void sensitivity_free(struct sensitivity *sensitivity)
{
    for (int v = 0; v < SENSITIVITY_VARIANTS; v++)
        spectrum_free(&sensitivity->variants[v].spectrum);
    *sensitivity = (struct sensitivity){0};
}

/** Area and ECR at the one load of the task; NaN where the model has no answer there. */
static enum status_code solve_one(struct contact_point *out, const struct model_row *model,
                                  const struct model_task *task, struct status *status)
{
    struct contact_point points[2] = {0};
    struct model_curve curve = {.points = points};
    struct model_task own = *task;
    own.wanted &= QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_ECR);
    *out = quantity_nothing();
    if (model_run(&curve, model, &own, status) != STATUS_OK)
        return status->code;
    if (curve.exists && curve.count > 0 && points[0].value[QUANTITY_LOAD] == task->loads[0])
        *out = points[0];
    return STATUS_OK;
}

/** The geometric mean of two numbers over a third; NaN where that is 0. */
static double ratio(const struct contact_point *a, const struct contact_point *b, const struct contact_point *as_is,
                    enum quantity quantity)
{
    double whole = as_is->value[quantity];
    return whole > 0 ? sqrt(a->value[quantity]) * sqrt(b->value[quantity]) / whole : NAN;
}

enum status_code sensitivity_run(struct sensitivity_factors *out, const struct sensitivity *sensitivity,
                                 const struct model_row *model, const struct model_task *task, struct status *status)
{
    struct contact_point as_is, harder = quantity_nothing(), points[SENSITIVITY_VARIANTS];
    struct material_pair pair = *task->pair;
    struct model_task raised = *task;
    for (int c = 0; c < SENSITIVITY_CHANGES; c++)
        out->area[c] = out->ecr[c] = NAN;
    if (sensitivity->scans == 0 || model->uses_map) /* the map stays as it is */
        return STATUS_OK;
    if (solve_one(&as_is, model, task, status) != STATUS_OK)
        return status->code;
    for (int v = 0; v < SENSITIVITY_VARIANTS; v++) {
        struct asperities asperities;
        struct model_task own = member_task(&asperities, &sensitivity->variants[v], task);
        own.levelled = sensitivity->levelled[v];
        if (solve_one(&points[v], model, &own, status) != STATUS_OK)
            return status->code;
    }
    pair.yield_strength_Pa *= sensitivity_hardness_factor;
    raised.pair = &pair;
    raised.hardness_Pa *= sensitivity_hardness_factor;
    if (model->plastic && solve_one(&harder, model, &raised, status) != STATUS_OK)
        return status->code;
    const struct contact_point *cutoff = &points[SENSITIVITY_CUTOFF];
    const struct {
        const struct contact_point *first, *second, *as_is;
    } changes[SENSITIVITY_CHANGES] = {
        [SENSITIVITY_CUTOFF_DOUBLED] = {cutoff, cutoff, &as_is},
        [SENSITIVITY_SCAN_HALVED] = {&points[SENSITIVITY_FIRST_HALF], &points[SENSITIVITY_SECOND_HALF],
                                     &points[SENSITIVITY_WHOLE]},
        [SENSITIVITY_HARDNESS_RAISED] = {&harder, &harder, &as_is},
    };
    for (int c = 0; c < SENSITIVITY_CHANGES; c++) {
        out->area[c] = ratio(changes[c].first, changes[c].second, changes[c].as_is, QUANTITY_AREA);
        out->ecr[c] = ratio(changes[c].first, changes[c].second, changes[c].as_is, QUANTITY_ECR);
    }
    return STATUS_OK;
}
