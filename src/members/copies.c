/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "members/copies.h"

#include "profile/profile.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double same_spacing = 1e-4; /* relative: formats write few digits */
static const double same_rq = 0.02;
static const double same_height = 1e-3; /* of Rq: allows for digits lost in writing, where no rounding step was seen */
static const double rounded_most = 0.1; /* of Rq: more coarsely rounded heights cannot be compared */

void copies_free(struct copies *copies)
{
    for (size_t i = 0; i < copies->count; i++)
        free(copies->prints[i].file);
    free(copies->prints);
    *copies = (struct copies){0};
}

static struct copies_print print_of(const struct scan *scan)
{
    struct copies_print out = {.points = scan->nx * scan->ny, .spacing_m = scan->dx_m};
    double sum_m = 0, square_m2 = 0, count = 0;
    for (size_t i = 0; i < out.points; i++)
        if (!isnan(scan->z_m[i])) {
            sum_m += scan->z_m[i];
            count++;
        }
    for (size_t i = 0; i < out.points; i++)
        if (!isnan(scan->z_m[i]))
            square_m2 += pow(scan->z_m[i] - sum_m / count, 2);
    out.rq_m = sqrt(square_m2 / count);
    out.digit_m = profile_digitiser_step(scan->z_m, out.points);
    for (size_t k = 0; k < COPIES_HEIGHTS; k++)
        out.height_m[k] = scan->z_m[k * (out.points - 1) / (COPIES_HEIGHTS - 1)] - sum_m / count;
    return out;
}

static bool are_same(const struct copies_print *a, const struct copies_print *b)
{
    const double rounding_m = (a->digit_m + b->digit_m) / 2 * (1 + 1e-6), most_m = rounding_m + same_height * a->rq_m;
    if (a->points != b->points || fabs(a->spacing_m / b->spacing_m - 1) > same_spacing ||
        fabs(a->rq_m / b->rq_m - 1) > same_rq || rounding_m > rounded_most * a->rq_m)
        return false;
    for (size_t k = 0; k < COPIES_HEIGHTS; k++) {
        const bool gap = isnan(a->height_m[k]);
        if (gap != isnan(b->height_m[k]) || (!gap && !(fabs(a->height_m[k] - b->height_m[k]) <= most_m)))
            return false;
    }
    return true;
}

enum status_code copies_find(const char **of, struct copies *copies, const struct scan *scan, const char *file,
                             struct status *status)
{
    struct copies_print own = print_of(scan);
    *of = NULL;
    for (size_t i = 0; i < copies->count && !*of; i++)
        if (are_same(&copies->prints[i], &own))
            *of = copies->prints[i].file;
    if (*of)
        return STATUS_OK;
    struct copies_print *more = reallocarray(copies->prints, copies->count + 1, sizeof *more);
    copies->prints = more ? more : copies->prints;
    if (!more || !(own.file = strdup(file)))
        return status_memory(status);
    copies->prints[copies->count++] = own;
    return STATUS_OK;
}
