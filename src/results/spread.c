#include "results/spread.h"

#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

void spread_add(struct spread_number *number, double value)
{
    number->count++;
    double before = value - number->mean;
    number->mean += before / (double)number->count;
    number->square += before * (value - number->mean);
}

double spread_deviation(const struct spread_number *number)
{
    return number->count < 2 ? NAN : sqrt(number->square / (double)(number->count - 1));
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/** 2.5 and 97.5 per cent of `count` sorted values. */
static void interval(double out[2], double *values, size_t count)
{
    qsort(values, count, sizeof *values, compare);
    out[0] = values[(size_t)(0.025 * (double)(count - 1) + 0.5)];
    out[1] = values[(size_t)(0.975 * (double)(count - 1) + 0.5)];
}

/** Fits laws to mean spectra of scans drawn with replacement. */
static enum status_code bootstrap(struct spread *out, const struct spread_part *parts, size_t count,
                                  const double band_m[2], struct status *status)
{
    double gamma[SPREAD_BOOTSTRAP], alpha[SPREAD_BOOTSTRAP];
    struct spectrum mean = parts[0].spectrum;
    for (size_t p = 1; p < count; p++)
        mean.count = parts[p].spectrum.count < mean.count ? parts[p].spectrum.count : mean.count;
    mean.amplitude_m = malloc(mean.count * sizeof *mean.amplitude_m);
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    if (!mean.amplitude_m || !random) {
        free(mean.amplitude_m);
        if (random)
            gsl_rng_free(random);
        return status_memory(status);
    }
    gsl_rng_set(random, 1);
    for (int b = 0; b < SPREAD_BOOTSTRAP; b++) {
        memset(mean.amplitude_m, 0, mean.count * sizeof *mean.amplitude_m);
        for (size_t draw = 0; draw < count; draw++) {
            const double *amplitude_m = parts[gsl_rng_uniform_int(random, count)].spectrum.amplitude_m;
            for (size_t i = 0; i < mean.count; i++)
                mean.amplitude_m[i] += amplitude_m[i] * amplitude_m[i] / (double)count;
        }
        for (size_t i = 0; i < mean.count; i++)
            mean.amplitude_m[i] = sqrt(mean.amplitude_m[i]);
        struct powerlaw law = powerlaw_fit(&mean, band_m);
        gamma[b] = law.gamma;
        alpha[b] = law.alpha;
    }
    interval(out->gamma_interval, gamma, SPREAD_BOOTSTRAP);
    interval(out->alpha_interval, alpha, SPREAD_BOOTSTRAP);
    gsl_rng_free(random);
    free(mean.amplitude_m);
    return STATUS_OK;
}

enum status_code spread_laws(struct spread *out, const struct spread_part *parts, size_t count, const double band_m[2],
                             struct status *status)
{
    *out = (struct spread){.parts = count < 2 ? 0 : count, .gamma_interval = {NAN, NAN}, .alpha_interval = {NAN, NAN}};
    bool fitted = true;
    for (size_t p = 0; p < out->parts; p++) {
        struct powerlaw law = powerlaw_fit(&parts[p].spectrum, band_m);
        spread_add(&out->rq_m, parts[p].roughness.rq_m);
        fitted = fitted && isfinite(law.gamma);
        if (isfinite(law.gamma)) {
            spread_add(&out->gamma, law.gamma);
            spread_add(&out->log_alpha, log(law.alpha));
        }
    }
    return out->parts >= 3 && fitted ? bootstrap(out, parts, count, band_m, status) : STATUS_OK;
}

/** Sums of one quantity at one load over the parts. */
struct sums {
    struct spread_number area, separation, ecr, tcr;
};

static void add_logarithm(struct spread_number *number, double value)
{
    if (value > 0)
        spread_add(number, log(value));
}

static void add_curve(struct sums *sums, const struct model_curve *curve, const struct model_task *task, bool adjusted)
{
    for (size_t i = 0; i < curve->count && i < task->load_count; i++) {
        const struct contact_point *point = &curve->points[i];
        if (point->load != task->loads[i])
            break; /* a statistical curve closes at a load of its own */
        add_logarithm(&sums[i].area, point->area_ratio);
        if (task->wanted & CONTACT_SEPARATION)
            spread_add(&sums[i].separation, adjusted ? point->adjusted_m : point->separation_m);
        if (task->wanted & CONTACT_ELECTRICAL)
            add_logarithm(&sums[i].ecr, point->ecr_ohm_m2);
        if (task->wanted & CONTACT_THERMAL)
            add_logarithm(&sums[i].tcr, point->tcr_K_m2_per_W);
    }
}

/** Mean less and plus one standard deviation, when all `count` scans have the quantity. */
static void limits(double out[2], const struct spread_number *number, size_t count, bool logarithmic)
{
    double deviation = number->count == count ? spread_deviation(number) : NAN;
    for (int side = 0; side < 2; side++) {
        double value = number->mean + (side ? deviation : -deviation);
        out[side] = logarithmic ? exp(value) : value;
    }
}

/** One part through the model. */
static enum status_code run_part(struct spread *out, struct sums *sums, struct contact_point *points,
                                 const struct spread_part *part, enum model_id model, const struct model_task *task,
                                 struct model_work *work, struct status *status)
{
    struct model_task own = *task;
    struct asperities asperities;
    struct status none = {0};
    struct model_curve curve = {.points = points};
    own.spectrum = &part->spectrum;
    own.asperities = roughness_asperities(&asperities, &part->roughness, &none) == STATUS_OK ? &asperities : NULL;
    if (model_run(&curve, model, &own, status) != STATUS_OK)
        return status->code;
    model_work_add(work, &curve.work);
    if (!curve.exists)
        return STATUS_OK;
    add_curve(sums, &curve, task, model_rows[model].family == SCENE_MODEL_STATISTICAL);
    add_logarithm(&out->log_full_load[model], curve.full_load);
    if (isfinite(curve.beta))
        spread_add(&out->beta[model], curve.beta);
    return STATUS_OK;
}

enum status_code spread_model(struct spread *out, struct spread_band *band, const struct spread_part *parts,
                              size_t count, enum model_id model, const struct model_task *task, struct model_work *work,
                              struct status *status)
{
    struct sums *sums = calloc(task->load_count, sizeof *sums);
    struct contact_point *points = calloc(task->load_count + 1, sizeof *points);
    enum status_code rc = sums && points ? STATUS_OK : status_memory(status);
    for (size_t p = 0; p < count && rc == STATUS_OK; p++)
        rc = run_part(out, sums, points, &parts[p], model, task, work, status);
    for (size_t i = 0; i < task->load_count && rc == STATUS_OK; i++) {
        band[i].load = task->loads[i];
        limits(band[i].area, &sums[i].area, count, true);
        limits(band[i].separation_m, &sums[i].separation, count, false);
        limits(band[i].ecr_ohm_m2, &sums[i].ecr, count, true);
        limits(band[i].tcr_K_m2_per_W, &sums[i].tcr, count, true);
    }
    free(points);
    free(sums);
    return rc;
}
