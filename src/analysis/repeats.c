#include "analysis/repeats.h"

#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

void repeats_add(struct repeats_number *number, double value)
{
    number->count++;
    double before = value - number->mean;
    number->mean += before / (double)number->count;
    number->square += before * (value - number->mean);
}

double repeats_deviation(const struct repeats_number *number)
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
static enum status_code bootstrap(struct repeats *out, const struct repeat *parts, size_t count, const double band_m[2],
                                  struct status *status)
{
    double gamma[REPEATS_BOOTSTRAP], alpha[REPEATS_BOOTSTRAP];
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
    for (int b = 0; b < REPEATS_BOOTSTRAP; b++) {
        memset(mean.amplitude_m, 0, mean.count * sizeof *mean.amplitude_m);
        for (size_t draw = 0; draw < count; draw++) {
            const double *amplitude_m = parts[gsl_rng_uniform_int(random, count)].spectrum.amplitude_m;
            for (size_t i = 0; i < mean.count; i++)
                mean.amplitude_m[i] += amplitude_m[i] * amplitude_m[i] / (double)count;
        }
        for (size_t i = 0; i < mean.count; i++)
            mean.amplitude_m[i] = sqrt(mean.amplitude_m[i]);
        struct power_law law = power_law_fit(&mean, band_m);
        gamma[b] = law.gamma;
        alpha[b] = law.alpha;
    }
    interval(out->gamma_interval, gamma, REPEATS_BOOTSTRAP);
    interval(out->alpha_interval, alpha, REPEATS_BOOTSTRAP);
    gsl_rng_free(random);
    free(mean.amplitude_m);
    return STATUS_OK;
}

enum status_code repeats_laws(struct repeats *out, const struct repeat *parts, size_t count, const double band_m[2],
                              struct status *status)
{
    *out = (struct repeats){.count = count < 2 ? 0 : count, .gamma_interval = {NAN, NAN}, .alpha_interval = {NAN, NAN}};
    bool fitted = true;
    for (size_t p = 0; p < out->count; p++) {
        struct power_law law = power_law_fit(&parts[p].spectrum, band_m);
        repeats_add(&out->rq_m, parts[p].roughness.rq_m);
        fitted = fitted && isfinite(law.gamma);
        if (isfinite(law.gamma)) {
            repeats_add(&out->gamma, law.gamma);
            repeats_add(&out->log_alpha, log(law.alpha));
        }
    }
    return out->count >= 3 && fitted ? bootstrap(out, parts, count, band_m, status) : STATUS_OK;
}

bool repeats_band_holds(enum quantity quantity)
{
    return quantity == QUANTITY_AREA || quantity == QUANTITY_SEPARATION || quantity == QUANTITY_ECR ||
           quantity == QUANTITY_TCR;
}

/** Sums at one load over the parts, a quantity each. */
struct sums {
    struct repeats_number of[QUANTITY_COUNT];
};

static void add_value(struct repeats_number *number, double value, bool logarithmic)
{
    if (!logarithmic)
        repeats_add(number, value);
    else if (value > 0)
        repeats_add(number, log(value));
}

static void add_curve(struct sums *sums, const struct model_curve *curve, const struct model_task *task,
                      const struct model_row *model)
{
    for (size_t i = 0; i < curve->count && i < task->load_count; i++) {
        const struct contact_point *point = &curve->points[i];
        if (point->load != task->loads[i])
            break; /* a statistical curve closes at a load of its own */
        for (int q = 0; q < QUANTITY_COUNT; q++)
            if (repeats_band_holds((enum quantity)q) && (task->wanted & QUANTITY_BIT(q)))
                add_value(&sums[i].of[q], quantity_value(point, model_shown(model, (enum quantity)q)),
                          quantity_rows[q].logarithmic);
    }
}

/** Mean less and plus one standard deviation, when all `count` scans have the quantity. */
static void limits(double out[2], const struct repeats_number *number, size_t count, bool logarithmic)
{
    double deviation = number->count == count ? repeats_deviation(number) : NAN;
    for (int side = 0; side < 2; side++) {
        double value = number->mean + (side ? deviation : -deviation);
        out[side] = logarithmic ? exp(value) : value;
    }
}

struct model_task repeats_task(struct asperities *asperities, const struct repeat *part, const struct model_task *task)
{
    struct model_task own = *task;
    struct status none = {0};
    own.spectrum = &part->spectrum;
    own.asperities = roughness_asperities(asperities, &part->roughness, &none) == STATUS_OK ? asperities : NULL;
    return own;
}

struct model_work repeats_work(const struct repeat *parts, size_t count, const struct model_row *model,
                               const struct model_task *task)
{
    struct model_work sum = {0};
    for (size_t p = 0; p < count; p++) {
        struct asperities asperities;
        struct model_task own = repeats_task(&asperities, &parts[p], task);
        struct model_work work = model->work(model, &own);
        model_work_add(&sum, &work);
    }
    return sum;
}

enum status_code repeats_model(struct repeats_number *beta, struct repeats_number *log_full_load,
                               struct repeats_band *band, const struct repeat *parts, size_t count,
                               const struct model_row *model, const struct model_task *task, struct model_work *work,
                               struct status *status)
{
    struct sums *sums = calloc(task->load_count, sizeof *sums);
    struct contact_point *points = calloc(task->load_count + 1, sizeof *points);
    enum status_code rc = sums && points ? STATUS_OK : status_memory(status);
    for (size_t p = 0; p < count && rc == STATUS_OK; p++) {
        struct asperities asperities;
        struct model_task own = repeats_task(&asperities, &parts[p], task);
        struct model_curve curve = {.points = points};
        rc = model_run(&curve, model, &own, status);
        if (rc != STATUS_OK)
            break;
        model_work_add(work, &curve.work);
        if (!curve.exists)
            continue;
        add_curve(sums, &curve, task, model);
        add_value(log_full_load, curve.full_load, true);
        if (isfinite(curve.beta))
            repeats_add(beta, curve.beta);
    }
    for (size_t i = 0; i < task->load_count && rc == STATUS_OK; i++) {
        band[i].load = task->loads[i];
        for (int q = 0; q < QUANTITY_COUNT; q++)
            limits(band[i].limits[q], &sums[i].of[q], count, quantity_rows[q].logarithmic);
    }
    free(points);
    free(sums);
    return rc;
}
