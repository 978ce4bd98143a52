/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/statistical.h"

#include "contact/gaussian.h"

#include <math.h>

static bool is_scale_dependent(const struct statistical *model)
{
    return model->wanted & QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT);
}

/** The integrals of (4.25), (4.26), (4.43*), (4.46*) at d: closed forms for GW, else the panels, which GW needs for the
 * scale-dependent one (4.51) alone. */
static void integrate(struct quadrature_sums *sums, const struct statistical *model, double d)
{
    bool scale_dependence = is_scale_dependent(model);
    if (model->plastic || scale_dependence)
        quadrature_sum(sums, &model->panels, d);
    if (model->plastic)
        return;
    struct gaussian_integrals f = gaussian_integrals(d);
    double radius_m = model->asperity.radius_m, sigma_s_m = model->surface.sigma_s_m;
    double scale_dependent = 0; /* the panels have another log_factor */
    if (scale_dependence)
        scale_dependent = sums->radius_scale_dependent * exp(sums->log_factor - f.log_factor);
    *sums = (struct quadrature_sums){
        .area = M_PI * radius_m * sigma_s_m * f.one,
        .load =
            4.0 / 3 * model->asperity.effective_modulus_Pa * sqrt(radius_m * sigma_s_m) * sigma_s_m * f.three_halves,
        .radius = sqrt(radius_m * sigma_s_m) * f.half,
        .radius_scale_dependent = scale_dependent,
        .log_factor = f.log_factor,
    };
}

/** ln of A (4.25) or P/(A_n E') (4.26) and its derivatives with respect to d. */
struct logarithm {
    double value, first, second;
};

/** Hertz's: F = F_n, n = 1 or 3/2, of which F' = -n F_{n-1} and F'' = n F - d F'. */
static struct logarithm closed_logarithm(const struct statistical *model, bool area, double d)
{
    double radius_m = model->asperity.radius_m, sigma_s_m = model->surface.sigma_s_m, n = area ? 1 : 1.5;
    struct gaussian_integrals f = gaussian_integrals(d);
    double upper = area ? f.one : f.three_halves, lower = area ? f.zero : f.half;
    double scale = area ? M_PI * radius_m * sigma_s_m : 4.0 / 3 * sqrt(radius_m * sigma_s_m) * sigma_s_m;
    double first = -n * lower / upper, second = n - first * (d + first);
    return (struct logarithm){log(model->surface.density_per_m2 * scale * upper) + f.log_factor, first, second};
}

/** Any law: the derivatives are cumulants of the interference u, since d ln phi(u + d)/dd = -(u + d). */
static struct logarithm panel_logarithm(const struct statistical *model, bool area, double d)
{
    double sum[3], log_factor;
    double scale = model->surface.density_per_m2 / (area ? 1 : model->asperity.effective_modulus_Pa);
    quadrature_moments(sum, &log_factor, &model->panels, area, d);
    double mean = sum[1] / sum[0];
    return (struct logarithm){log(scale * sum[0]) + log_factor, -mean - d, sum[2] / sum[0] - mean * mean - 1};
}

/** Solves ln A (4.25) or ln(P/(A_n E')) (4.26) = log_target for d by Newton's method, with the second-order term where
 * that is small. The logarithm falls and is concave in d, so the iterates converge from one side after the first step.
 */
static double solve(const struct statistical *model, bool area, double log_target, double d)
{
    static const double highest_d = 40; /* exp(-d²/2) is below the smallest double */
    static const double small = 0.25;
    d = fmin(d, highest_d);
    for (int iteration = 0; iteration < 200; iteration++) {
        struct logarithm f = model->plastic ? panel_logarithm(model, area, d) : closed_logarithm(model, area, d);
        if (!(isfinite(f.value) && f.first < 0))
            return NAN; /* out of range: model_run() drops the curve */
        double newton = (log_target - f.value) / f.first, bend = newton * f.second / (2 * f.first);
        d += fabs(bend) <= small ? newton * (1 - bend) : newton;
        if (fabs(newton) <= 1e-6 * fmax(1, fabs(d))) /* the rest is below rounding */
            return d;
    }
    return d;
}

enum status_code statistical_make(struct statistical *out, const struct model_task *task, bool plastic, double lowest_d,
                                  struct status *status)
{
    const struct asperities *surface = task->asperities;
    *out = (struct statistical){
        .surface = *surface,
        .asperity = asperity_make(surface->radius_m, task->pair, plastic),
        .plastic = plastic,
        .spot = constriction_make(task->pair),
        .wanted = task->wanted,
    };
    struct statistical elastic = *out;
    const bool scale_dependent = is_scale_dependent(out);
    elastic.plastic = false;
    out->full_d = solve(&elastic, true, 0, 0); /* no law is needed below it */
    if ((plastic || scale_dependent) &&        /* else closed forms do */
        quadrature_make(&out->panels, &out->asperity, surface->sigma_s_m,
                        scale_dependent ? out->spot.knudsen_length_m : 0, fmin(lowest_d, out->full_d), task->tolerance,
                        status) != STATUS_OK)
        return status->code;
    if (plastic)
        out->full_d = solve(out, true, 0, out->full_d);
    struct contact_point full;
    statistical_at(&full, out, out->full_d);
    out->full_load = full.value[QUANTITY_LOAD];
    out->beta = -2 * full.value[QUANTITY_SEPARATION] / surface->sigma_m;
    return STATUS_OK;
}

void statistical_free(struct statistical *model)
{
    quadrature_free(&model->panels);
}

void statistical_at(struct contact_point *out, const struct statistical *model, double d)
{
    struct quadrature_sums sums;
    integrate(&sums, model, d);
    const struct asperities *surface = &model->surface;
    double scale = surface->density_per_m2 * exp(sums.log_factor);
    double area = scale * sums.area;
    double separation_m = d * surface->sigma_s_m + surface->offset_m;
    double full_m = model->full_d * surface->sigma_s_m + surface->offset_m;
    /* 1/R = (1/Psi) eta int g(a) phi: psi/(2 eta int a phi), per nominal area */
    double psi = area < 1 ? constriction_alleviation(area, 1 - area) : 0;
    unsigned wanted = model->wanted;
    double spread = psi > 0 ? psi / (2 * scale * sums.radius) : 0;
    *out = quantity_nothing();
    out->value[QUANTITY_LOAD] = scale * sums.load / model->asperity.effective_modulus_Pa;
    out->value[QUANTITY_AREA] = area;
    out->value[QUANTITY_SEPARATION] = separation_m;
    out->value[QUANTITY_ADJUSTED] = (separation_m - full_m) / 2; /* (delta + beta sigma/2)/2 (4.54) */
    if (wanted & QUANTITY_BIT(QUANTITY_ECR))
        out->value[QUANTITY_ECR] = model->spot.resistivity_ohm_m * spread;
    if (wanted & QUANTITY_BIT(QUANTITY_TCR))
        out->value[QUANTITY_TCR] = spread / model->spot.conductivity_W_per_mK;
    if (wanted & QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT))
        out->value[QUANTITY_TCR_SCALE_DEPENDENT] =
            psi > 0 ? psi / (2 * scale * sums.radius_scale_dependent) / model->spot.conductivity_W_per_mK : 0;
    out->beyond_fit = sums.load > 0 ? sums.load_beyond_fit / sums.load : 0;
    out->radius_clamped = sums.load > 0 ? sums.load_radius_clamped / sums.load : 0;
}

bool statistical_solve(struct contact_point *out, const struct statistical *model, double load, double *d)
{
    if (!(load < model->full_load))
        return false;
    *d = solve(model, false, log(load), fmax(*d, model->full_d));
    *d = fmax(*d, model->full_d);
    statistical_at(out, model, *d);
    out->value[QUANTITY_LOAD] = load;
    out->value[QUANTITY_AREA] = fmin(1, out->value[QUANTITY_AREA]); /* rounding */
    return true;
}

struct contact_spots statistical_spots(const struct statistical *model, double d)
{
    struct gaussian_integrals f = gaussian_integrals(d);
    const struct asperities *surface = &model->surface;
    return (struct contact_spots){
        .density_per_m2 = surface->density_per_m2 * f.zero * exp(f.log_factor),
        .radius_m = model->plastic ? quadrature_mean_radius(&model->panels, d)
                                   : sqrt(surface->radius_m * surface->sigma_s_m) * (f.three_halves / f.one),
    };
}

void statistical_full(struct contact_point *out, const struct statistical *model)
{
    statistical_at(out, model, model->full_d);
    out->value[QUANTITY_LOAD] = model->full_load;
    out->value[QUANTITY_AREA] = 1;
    out->value[QUANTITY_ADJUSTED] = 0;
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if ((QUANTITY_RESISTANCES & QUANTITY_BIT(q)) && !isnan(out->value[q]))
            out->value[q] = 0;
}

double statistical_beta_multiscale(double separation_m, double multiscale_m, double sigma_m)
{
    return 4 * (multiscale_m - separation_m / 2) / sigma_m; /* delta/2 + beta sigma/4 = H */
}
