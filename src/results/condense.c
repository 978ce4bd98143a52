#include "results/condense.h"

#include <math.h>

static const double outside_share = 0.1; /* share of the load beyond the fitted range that dashes a curve */
static const double touching_area = 0.1; /* A/A_n up to which asperities may be taken as apart */
static const double elbow_slope = 2;     /* |d ln ECR/d ln P| that counts as the elbow: twice the slope before it */

/** Least-squares slope of ln A over ln P where A/A_n < 0.1, and its RMS residual in decades. */
static void fit_area_slope(struct surface_model *model, const struct model_curve *curve)
{
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
    for (size_t i = 0; i < curve->count; i++) {
        const struct contact_point *point = &curve->points[i];
        if (point->area_ratio >= touching_area || !(point->area_ratio > 0))
            continue;
        double x = log(point->load), y = log(point->area_ratio);
        n += 1;
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
        syy += y * y;
    }
    model->area_slope = model->area_slope_rms = NAN;
    if (n < 5)
        return;
    double spread = sxx - sx * sx / n, common = sxy - sx * sy / n;
    double residual = syy - sy * sy / n - common * common / spread;
    model->area_slope = common / spread;
    model->area_slope_rms = sqrt(fmax(0, residual) / n) / M_LN10;
}

/** What a curve says, in a few numbers. */
void condense_curve(struct surface_model *model, const struct model_curve *curve, const struct model_row *row,
                    double sigma_m)
{
    bool statistical = row->family == SCENE_MODEL_STATISTICAL;
    *model = (struct surface_model){
        .exists = curve->exists,
        .full_load = curve->full_load,
        .closed_load = curve->closed_load,
        .beta = curve->beta,
        .beta_multiscale = NAN,
        .elbow_load = NAN,
        .sd_least = INFINITY,
        .sd_most = -INFINITY,
        .invalid_area_load = NAN,
        .invalid_fit_load = NAN,
        .gap_at_full = (statistical ? curve->full.adjusted_m : curve->full.separation_m) / sigma_m,
        .area_low = curve->count > 0 ? curve->points[0].area_ratio : NAN,
        .yielding_scales = curve->yielding_scales,
        .clamped = curve->clamped,
        .work = curve->work,
    };
    fit_area_slope(model, curve);
    for (size_t i = 0; i < curve->count; i++) {
        const struct contact_point *point = &curve->points[i], *before = i > 0 ? point - 1 : NULL;
        if (statistical && isnan(model->invalid_area_load) && point->area_ratio > touching_area)
            model->invalid_area_load = point->load;
        if (statistical && isnan(model->invalid_fit_load) && point->outside > outside_share)
            model->invalid_fit_load = point->load;
        model->most_outside = fmax(model->most_outside, point->outside);
        model->most_saturated = fmax(model->most_saturated, point->saturated);
        if (point->tcr_K_m2_per_W > 0 && !isnan(point->tcr_sd_K_m2_per_W)) {
            model->sd_least = fmin(model->sd_least, point->tcr_sd_K_m2_per_W / point->tcr_K_m2_per_W - 1);
            model->sd_most = fmax(model->sd_most, point->tcr_sd_K_m2_per_W / point->tcr_K_m2_per_W - 1);
        }
        /* a load where the resistance has gone to 0 ends the elbow too */
        if (before && before->ecr_ohm_m2 > 0 && isnan(model->elbow_load) &&
            !(point->ecr_ohm_m2 > 0 &&
              log(before->ecr_ohm_m2 / point->ecr_ohm_m2) < elbow_slope * log(point->load / before->load)))
            model->elbow_load = before->load;
    }
}
