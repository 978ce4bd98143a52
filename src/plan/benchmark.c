/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "plan/benchmark.h"

#include "contact/statistical.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum {
    QUANTITIES = 3,
    SEPARATIONS = 100, /* so that what is made once weighs as in a curve */
    APART = 11,        /* Simpson is timed at every eleventh of them, first and last included */
    SAMPLES = SEPARATIONS / APART + 1,
    SETTINGS = 7,           /* of a method, at most */
    HARMONICS_MOST = 100000 /* of a longer scan no more are summed again at every tolerance: they show it too */
};
enum { AREA, LOAD, RADIUS };

/** Separation, in standard deviations of the asperities' heights, from which on they are taken down to full contact. */
static const double farthest = 4;

_Static_assert(ASPERITY_MODEL_COUNT * 2 * SETTINGS + 4 <= BENCHMARK_ROWS, "room for all rows");

/** Seconds that this thread has worked, whatever others do meanwhile. */
static double own_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/** Times `work(context)`: the least of several runs while they are short. */
static double time_of(void (*work)(void *context), void *context)
{
    enum { RUNS_MOST = 12 };
    const double enough_seconds = 2e-3;
    double least = INFINITY, total = 0;
    for (int run = 0; run < RUNS_MOST && total < enough_seconds; run++) {
        double started = own_seconds();
        work(context);
        double passed = own_seconds() - started;
        least = fmin(least, passed);
        total += passed;
    }
    return least;
}

/* ---- Integrals of the statistical models, from far apart to full contact ---- */

/** The integrals of one surface in one law: int law(sigma_s u) phi(u + d) du without exp(-d²/2) where d > 0. */
struct problem {
    struct asperity asperity;
    enum asperity_model_id law;
    double sigma_s_m;
    double d[SEPARATIONS];
    double lowest_d;
};

/** One method at work on a problem. */
struct attempt {
    const struct problem *problem;
    double setting; /* Simpson: sub-intervals; panels: tolerance */
    uint64_t evaluations;
    double value[SEPARATIONS][QUANTITIES];
    bool failed;
};

/** Beyond it the Gaussian is below 1e-17 of its largest value. */
static double last_u(double d)
{
    double cut = 40;
    return d > 0 ? 2 * cut / (d + sqrt(d * d + 2 * cut)) : sqrt(2 * cut) - d;
}

/** All quantities of the integrand at u. */
static void integrand(double value[QUANTITIES], const struct problem *problem, double d, double u)
{
    struct asperity_contact contact;
    asperity_models[problem->law].press(&contact, &problem->asperity, problem->sigma_s_m * u);
    double weight = exp(d > 0 ? -u * (u / 2 + d) : -(u + d) * (u + d) / 2) / sqrt(2 * M_PI);
    value[AREA] = weight * contact.area_m2;
    value[LOAD] = weight * contact.load_N;
    value[RADIUS] = weight * contact.radius_m;
}

/** Composite Simpson over [0, last_u], as the thesis with its 1000 sub-intervals. */
static void simpson(void *context)
{
    struct attempt *attempt = context;
    size_t intervals = (size_t)attempt->setting;
    attempt->evaluations = 0;
    for (int s = 0; s < SEPARATIONS; s += APART) {
        double d = attempt->problem->d[s], step = last_u(d) / (double)intervals, sum[QUANTITIES] = {0};
        for (size_t i = 0; i <= intervals; i++) {
            double value[QUANTITIES], weight = i == 0 || i == intervals ? 1 : i % 2 ? 4 : 2;
            integrand(value, attempt->problem, d, step * (double)i);
            for (int q = 0; q < QUANTITIES; q++)
                sum[q] += weight * value[q];
        }
        for (int q = 0; q < QUANTITIES; q++)
            attempt->value[s][q] = sum[q] * step / 3;
        attempt->evaluations += intervals + 1;
    }
}

/** Gauss-Legendre panels, the making of them included. */
static void panels(void *context)
{
    struct attempt *attempt = context;
    const struct problem *problem = attempt->problem;
    struct quadrature panels;
    struct status status = {0};
    attempt->evaluations = 0;
    if (quadrature_make(&panels, &problem->asperity, problem->law, problem->sigma_s_m, 0, problem->lowest_d,
                        attempt->setting, &attempt->evaluations, &status) != STATUS_OK)
        attempt->failed = true;
    for (int s = 0; s < SEPARATIONS && !attempt->failed; s++) {
        struct quadrature_sums sums;
        quadrature_sum(&sums, &panels, problem->d[s]);
        attempt->value[s][AREA] = sums.area;
        attempt->value[s][LOAD] = sums.load;
        attempt->value[s][RADIUS] = sums.radius;
    }
    quadrature_free(&panels);
}

static double largest_error(const struct attempt *attempt, const struct attempt *better)
{
    double error = 0;
    for (int s = 0; s < SEPARATIONS; s += APART)
        for (int q = 0; q < QUANTITIES; q++)
            error = fmax(error, fabs(attempt->value[s][q] / better->value[s][q] - 1));
    return error;
}

static enum status_code add_methods(struct benchmark *out, const struct model_row *model, const struct problem *problem,
                                    struct status *status)
{
    static const struct {
        const char *method;
        void (*work)(void *context);
        double times; /* as much work for all separations */
        double settings[SETTINGS];
    } methods[] = {{"Simpson", simpson, SEPARATIONS / SAMPLES, {10, 30, 100, 300, 1000, 3000, 10000}},
                   {"Gauss-Legendre", panels, 1, {1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}}};
    struct attempt better = {.problem = problem, .setting = 1e-14};
    panels(&better);
    for (size_t m = 0; m < sizeof methods / sizeof *methods && !better.failed; m++)
        for (int i = 0; i < SETTINGS && methods[m].settings[i] > 0; i++) {
            struct attempt attempt = {.problem = problem, .setting = methods[m].settings[i]};
            struct benchmark_row *row = &out->rows[out->count++];
            *row = (struct benchmark_row){.model = model, .method = methods[m].method, .setting = attempt.setting};
            snprintf(row->study, sizeof row->study, "%s-integrals", model->name);
            row->seconds = methods[m].times * time_of(methods[m].work, &attempt);
            row->evaluations = (uint64_t)methods[m].times * attempt.evaluations;
            row->error = largest_error(&attempt, &better);
            better.failed |= attempt.failed;
        }
    return better.failed ? status_memory(status) : STATUS_OK;
}

static enum status_code integrals_of(struct benchmark *out, const struct surface_record *surface,
                                     const struct surface_task *asked, const struct model_row *row,
                                     struct status *status)
{
    enum asperity_model_id law = (enum asperity_model_id)(row->asperity_model - asperity_models);
    struct statistical model;
    uint64_t none = 0;
    if (statistical_make(&model, &surface->summary.asperities, &surface->summary.pair, law, asked->plan->wanted,
                         asked->scene->tolerance, INFINITY, &none, status) != STATUS_OK)
        return status->code;
    struct problem problem = {
        .asperity = model.asperity, .law = law, .sigma_s_m = model.surface.sigma_s_m, .lowest_d = model.full_d};
    for (int s = 0; s < SEPARATIONS; s++)
        problem.d[s] = farthest + (model.full_d - farthest) * s / (SEPARATIONS - 1);
    statistical_free(&model);
    return add_methods(out, row, &problem, status);
}

/* ---- The tolerance of the curves ---- */

/** The curves of all models that run, from the surface on. */
struct curves_attempt {
    const struct surface_record *surface;
    const struct surface_task *asked;
    struct spectrum spectrum; /* of the surface, no more of it than HARMONICS_MOST */
    double tolerance;
    struct contact_point *points; /* of every model */
    uint64_t evaluations;
    bool failed;
};

static void solve_curves(void *context)
{
    struct curves_attempt *attempt = context;
    struct model_task task = surface_model_task(attempt->surface, attempt->asked);
    struct status status = {0};
    attempt->evaluations = 0;
    task.spectrum = &attempt->spectrum;
    task.tolerance = attempt->tolerance;
    for (size_t m = 0; m < model_count; m++) {
        struct model_curve curve = {.points = attempt->points + m * (task.load_count + 1)};
        if (!attempt->surface->curves[m].exists)
            continue;
        attempt->failed = attempt->failed || model_run(&curve, model_rows[m], &task, &status) != STATUS_OK;
        attempt->evaluations += curve.evaluations;
    }
}

/** The curves of the report's own loads at rising tolerances; errors against the first, of every quantity that a chart
 * shows. The rows stand the other way round. */
static enum status_code tolerances(struct benchmark *out, const struct surface_record *surface,
                                   const struct surface_task *asked, struct status *status)
{
    static const double tolerance[] = {1e-13, 1e-10, 1e-6, 1e-2};
    enum { STEPS = sizeof tolerance / sizeof *tolerance };
    size_t count = model_count * (asked->load_count + 1);
    struct contact_point *best = calloc(2 * count, sizeof *best);
    if (!best)
        return status_memory(status);
    struct curves_attempt attempt = {.surface = surface, .asked = asked, .spectrum = surface->spectrum};
    if (attempt.spectrum.count > HARMONICS_MOST) {
        attempt.spectrum.count = HARMONICS_MOST;
        attempt.spectrum.has_nyquist = false;
    }
    out->count += STEPS;
    for (int t = 0; t < STEPS && !attempt.failed; t++) {
        struct benchmark_row *row = &out->rows[out->count - 1 - (size_t)t];
        attempt.tolerance = tolerance[t];
        attempt.points = t == 0 ? best : best + count;
        *row = (struct benchmark_row){.study = "tolerance", .method = "all models", .setting = tolerance[t]};
        row->seconds = time_of(solve_curves, &attempt);
        row->evaluations = attempt.evaluations;
        for (size_t i = 0; i < count; i++)
            for (int q = 0; q < QUANTITY_COUNT; q++) {
                double better = best[i].value[q], ratio = attempt.points[i].value[q] / better;
                if ((quantity_rows[q].is & QUANTITY_BANDED) && better > 0 && isfinite(ratio))
                    row->error = fmax(row->error, fabs(ratio - 1));
            }
    }
    free(best);
    return attempt.failed ? status_memory(status) : STATUS_OK;
}

enum status_code benchmark_measure(struct benchmark *out, const struct surface_record *surface,
                                   const struct surface_task *asked, struct status *status)
{
    enum status_code rc = STATUS_OK;
    *out = (struct benchmark){0};
    for (size_t m = 0; m < model_count && rc == STATUS_OK; m++)
        if (model_rows[m]->asperity_model && surface->curves[m].exists)
            rc = integrals_of(out, surface, asked, model_rows[m], status);
    if (rc == STATUS_OK)
        rc = tolerances(out, surface, asked, status);
    return rc;
}
