/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "members/variants.h"

#include <string.h>

enum { LEAST_POINTS = 16 };

/** Puts half of the profile or all of it, smoothed or not, into room->record. */
static enum status_code take_variant(struct fft_room *room, size_t points, enum variant variant,
                                     const struct profile *profile, double lambda_s_m, struct status *status)
{
    double cutoff_m = 2 * (lambda_s_m > 0 ? lambda_s_m : 2 * profile->spacing_m);
    if (variant == VARIANT_CUTOFF)
        return filter_gaussian(room->record, profile, cutoff_m, status);
    const double *first_m = profile->height_m + (variant == VARIANT_SECOND_HALF ? profile->points - points : 0);
    memcpy(room->record, first_m, points * sizeof *first_m);
    return STATUS_OK;
}

/** Averages one variant of a profile with those of the profiles before. */
static enum status_code add_variant(struct variants *out, enum variant variant, const struct profile *profile,
                                    double lambda_s_m, const struct record_conditioning *how, struct status *status)
{
    bool whole = variant == VARIANT_CUTOFF || variant == VARIANT_WHOLE;
    size_t points = whole ? profile->points : profile->points / 2;
    OWNED(fft_room_free) struct fft_room room = {0};
    struct member own = {.strip = NULL}, *mean = &out->of[variant];
    if (!fft_room_make(&room, points))
        return status_memory(status);
    if (take_variant(&room, points, variant, profile, lambda_s_m, status) == STATUS_OK &&
        member_of_record(&own, &room, points, profile->spacing_m, how, status) == STATUS_OK) {
        roughness_average(&mean->roughness, &own.roughness, out->scans);
        (void)!grid_average(&mean->spectrum, &own.spectrum, out->scans, status);
    }
    spectrum_free(&own.spectrum);
    return status->code;
}

enum status_code variants_add(struct variants *out, const struct profile *profile, double lambda_s_m,
                              const struct scene *scene, struct status *status)
{
    struct record_conditioning how = record_conditioning_of(scene, false);
    if (profile->points < LEAST_POINTS)
        return STATUS_OK;
    for (int variant = 0; variant < VARIANT_COUNT; variant++) {
        how.periodic = profile->periodic && variant == VARIANT_CUTOFF;
        out->levelled[variant] =
            how.level >= LEVEL_LINE && !(how.periodic && how.periodic_mean) && !(scene->lambda_c_m > 0);
        if (add_variant(out, (enum variant)variant, profile, lambda_s_m, &how, status) != STATUS_OK)
            return status->code;
    }
    out->scans++;
    return STATUS_OK;
}

void variants_free(struct variants *variants)
{
    for (int v = 0; v < VARIANT_COUNT; v++)
        spectrum_free(&variants->of[v].spectrum);
    *variants = (struct variants){0};
}
