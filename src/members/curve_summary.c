/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "members/curve_summary.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double beyond_fit_share = 0.1;
static const double elbow_slope = 2;  /* of -ln ECR over ln P: light loads have about 1 */
static const double slope_area = 0.1; /* A/A_n up to which the area goes as a power of the load */

/** Least-squares slope of ln A over ln P where A/A_n < 0.1. */
static void fit_area_slope(struct curve_summary *model, const struct model_curve *curve)
{
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (size_t i = 0; i < curve->count; i++) {
        const struct contact_point *point = &curve->points[i];
        if (i + 1 < curve->count && point->value[QUANTITY_AREA] == point[1].value[QUANTITY_AREA])
            break; /* a bond line holds it from here on */
        if (point->value[QUANTITY_AREA] >= slope_area || !(point->value[QUANTITY_AREA] > 0))
            continue;
        double x = log(point->value[QUANTITY_LOAD]), y = log(point->value[QUANTITY_AREA]);
        n += 1;
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    model->area_slope = n < 5 ? NAN : (sxy - sx * sy / n) / (sxx - sx * sx / n);
}

bool curve_summary_point_is_valid(const struct contact_point *point, const struct model_row *row)
{
    return !(row->largest_area > 0 && point->value[QUANTITY_AREA] > row->largest_area) &&
           !(point->beyond_fit > beyond_fit_share);
}

struct curve_validity curve_summary_validity(const struct model_curve *curve, const struct model_row *row)
{
    struct curve_validity valid = {0, 0};
    while (valid.first < curve->count && !curve_summary_point_is_valid(&curve->points[valid.first], row))
        valid.first++;
    if (valid.first == curve->count)
        valid.first = 0;
    valid.end = valid.first;
    while (valid.end < curve->count && curve_summary_point_is_valid(&curve->points[valid.end], row) &&
           model_curve_bears(curve, curve->points[valid.end].value[QUANTITY_LOAD]))
        valid.end++;
    return valid;
}

const struct estimate *curve_summary_estimate(const struct curve_summary *model, int which)
{
    return model->estimates ? &model->estimates[which] : &estimate_none;
}

enum status_code curve_summary_put_estimates(struct curve_summary *model, const struct estimate *all,
                                             struct status *status)
{
    if (!model->estimates && !(model->estimates = malloc(CURVE_ESTIMATES * sizeof *all)))
        return status_memory(status);
    memcpy(model->estimates, all, CURVE_ESTIMATES * sizeof *all);
    return STATUS_OK;
}

bool curve_summary_is_valid(const struct curve_summary *model, double load)
{
    return !(model->invalid_load <= load);
}

void curve_summary_make(struct curve_summary *model, const struct model_curve *curve, const struct model_row *row,
                        double sigma_m, double operating_load)
{
    *model = (struct curve_summary){
        .exists = curve->exists,
        .first_load = curve->count > 0 ? curve->points[0].value[QUANTITY_LOAD] : NAN,
        .full_load = curve->full_load,
        .beta = curve->beta,
        .beta_multiscale = NAN,
        .law_factor = NAN,
        .elbow_load = NAN,
        .sd_most = -INFINITY,
        .invalid_load = NAN,
        .gap_at_full = quantity_shown(&curve->full, model_shown(row, QUANTITY_SEPARATION), sigma_m),
        .clamped = curve->clamped,
        .sensitivity = model->sensitivity,
        .seconds = model->seconds,
        .evaluations = model->evaluations,
        .operating = quantity_nothing(),
    };
    struct curve_validity valid = curve_summary_validity(curve, row);
    if (valid.end < curve->count)
        model->invalid_load = curve->points[valid.end].value[QUANTITY_LOAD];
    fit_area_slope(model, curve);
    for (size_t i = 0; i < curve->count; i++) {
        const struct contact_point *point = &curve->points[i], *before = i > 0 ? point - 1 : NULL;
        if (point->value[QUANTITY_LOAD] == operating_load && model_curve_bears(curve, operating_load))
            model->operating = *point;
        model->most_beyond_fit = fmax(model->most_beyond_fit, point->beyond_fit);
        model->most_radius_clamped = fmax(model->most_radius_clamped, point->radius_clamped);
        if (point->value[QUANTITY_TCR] > 0) /* fmax() ignores NaN */
            model->sd_most =
                fmax(model->sd_most, point->value[QUANTITY_TCR_SCALE_DEPENDENT] / point->value[QUANTITY_TCR] - 1);
        /* a resistance that falls to 0 is an elbow too */
        if (before && before->value[QUANTITY_ECR] > 0 && !isnan(point->value[QUANTITY_ECR]) &&
            isnan(model->elbow_load) &&
            !(point->value[QUANTITY_ECR] > 0 &&
              log(before->value[QUANTITY_ECR] / point->value[QUANTITY_ECR]) <
                  elbow_slope * log(point->value[QUANTITY_LOAD] / before->value[QUANTITY_LOAD])))
            model->elbow_load = before->value[QUANTITY_LOAD];
    }
}
