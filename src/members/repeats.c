/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "members/repeats.h"

#include "members/scan_strips.h"
#include "statistics/interval.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum status_code repeats_add_scan(struct ensemble *set, struct status *status)
{
    double *weight = reallocarray(set->scan_weight, set->scan_count + 1, sizeof *weight);
    if (!weight)
        return status_memory(status);
    set->scan_weight = weight;
    set->scan_weight[set->scan_count++] = 1;
    return STATUS_OK;
}

enum status_code repeats_add(struct ensemble *set, size_t row, size_t rows, struct profile *profile, struct member *own,
                             struct status *status)
{
    /* one of STRIPS_PIECES evenly spaced rows; of fewer all are */
    bool wanted = (STRIPS_PIECES * (row + 1) + rows / 2) / rows > (STRIPS_PIECES * row + rows / 2) / rows;
    struct member *member = wanted ? ensemble_room(set) : NULL;
    if (!member) {
        spectrum_free(&own->spectrum);
        return wanted ? status_memory(status) : STATUS_OK;
    }
    *member = *own;
    member->scan = set->scan_count - 1;
    member->is_row = rows > 1;
    member->height_m = profile->height_m;
    profile->height_m = NULL;
    return STATUS_OK;
}

/** Adds one scan to `cut` as pieces of `points`. */
static enum status_code cut_scan(struct ensemble *cut, const struct member *scan, size_t points,
                                 const struct scene *scene, struct status *status)
{
    const struct record_conditioning how = record_conditioning_of(scene, scan->periodic);
    size_t subrecords = interval_subrecords(scan->points, points);
    cut->scan_weight[scan->scan] = (double)subrecords;
    for (size_t k = 0; k < subrecords; k++) {
        const struct record_heights part = {scan->height_m + interval_subrecord_first(scan->points, points, k), points,
                                            scan->spacing_m};
        if (ensemble_add(cut, scan->scan, &part, &how, status) != STATUS_OK)
            return status->code;
        cut->members[cut->count - 1].seed = scan->seed + ((uint64_t)k << 48);
    }
    return STATUS_OK;
}

enum status_code repeats_cut_to_shortest(struct ensemble *set, size_t *cut, const struct scene *scene,
                                         struct status *status)
{
    size_t longer = 0;
    double least_m = INFINITY;
    for (size_t p = 0; p < set->count; p++)
        least_m = fmin(least_m, (double)set->members[p].points * set->members[p].spacing_m);
    struct ensemble out = {
        .scan_weight = set->scan_weight, .scan_count = set->scan_count, .keeps_heights = set->keeps_heights};
    enum status_code rc = STATUS_OK;
    for (size_t p = 0; p < set->count && rc == STATUS_OK; p++) {
        struct member *member = &set->members[p], *kept;
        size_t points = (size_t)floor(least_m / member->spacing_m * (1 + 1e-9) + 1e-9);
        if (points < member->points && points >= 3) {
            rc = cut_scan(&out, member, points, scene, status);
            longer++;
        } else if ((kept = ensemble_room(&out))) {
            *kept = *member;
            *member = (struct member){0};
        } else {
            rc = status_memory(status);
        }
    }
    set->scan_weight = NULL;
    ensemble_free(set);
    *set = out;
    *cut = longer > 0 ? out.count : 0;
    return rc;
}

enum status_code repeats_compare(struct repeats *out, struct ensemble *set, const struct spectrum *mean,
                                 struct status *status)
{
    if (set->count == 0)
        return STATUS_OK;
    out->count = set->count;
    out->scans = set->scan_count;
    out->gamma = out->psd_m3 = estimate_none;
    OWNED(memory_free) struct ensemble_value *rq_m = malloc(set->count * sizeof *rq_m);
    enum status_code rc = rq_m ? STATUS_OK : status_memory(status);
    for (size_t p = 0; p < set->count && rc == STATUS_OK; p++) {
        struct spectrum *own = &set->members[p].spectrum, same;
        rq_m[p] = (struct ensemble_value){set->members[p].roughness.rq_m, set->members[p].scan};
        if (own->count == mean->count && fabs(own->length_m / mean->length_m - 1) < 1e-6)
            continue;
        rc = grid_spectrum(&same, own, mean->length_m, mean->count, status);
        if (rc == STATUS_OK) {
            spectrum_free(own);
            *own = same;
        }
    }
    return rc == STATUS_OK ? ensemble_estimate(&out->rq_m, set, rq_m, set->count, true, status) : rc;
}
