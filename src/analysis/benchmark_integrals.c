/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Methods for the integrals of the statistical models (thesis 4.25, 4.26, 4.43), over the separations the curves span.
 */
#include "analysis/benchmark.h"
#include "contact/statistical.h"

#include <gsl/gsl_integration.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    QUANTITIES = 4,
    SEPARATIONS = 100, /* so that what is made once weighs as in a curve */
    APART = 11,        /* Simpson is timed at every eleventh of them, first and last included */
    SAMPLES = SEPARATIONS / APART + 1,
    ADAPTIVE_PIECES = 1000
};
enum { AREA, LOAD, RADIUS, RADIUS_SCALE_DEPENDENT };

/** The integrals of one surface in one law: int law(sigma_s u) phi(u + d) du without exp(-d²/2) where d > 0. */
struct problem {
    struct asperity asperity;
    enum asperity_model_id law;
    double sigma_s_m, knudsen_m;
    unsigned quantities; /* bits 1 << AREA ... */
    double d[SEPARATIONS];
    double lowest_d;
};

/** One method at work on a problem. */
struct attempt {
    const struct problem *problem;
    size_t intervals; /* Simpson */
    double tolerance; /* adaptive, panels */
    gsl_integration_workspace *workspace;
    uint64_t evaluations;
    double value[SEPARATIONS][QUANTITIES];
    double d; /* the separation being integrated, and the quantity, for the integrand */
    int quantity;
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
    value[RADIUS_SCALE_DEPENDENT] =
        u > 0 ? weight * contact.radius_m * contact.radius_m / (contact.radius_m + problem->knudsen_m) : 0;
}

/** Composite Simpson over [0, last_u], as the thesis with its 1000 sub-intervals. */
static void simpson(void *context)
{
    struct attempt *attempt = context;
    attempt->evaluations = 0;
    for (int s = 0; s < SEPARATIONS; s += APART) {
        double d = attempt->problem->d[s], step = last_u(d) / (double)attempt->intervals, sum[QUANTITIES] = {0};
        for (size_t i = 0; i <= attempt->intervals; i++) {
            double value[QUANTITIES], weight = i == 0 || i == attempt->intervals ? 1 : i % 2 ? 4 : 2;
            integrand(value, attempt->problem, d, step * (double)i);
            for (int q = 0; q < QUANTITIES; q++)
                sum[q] += weight * value[q];
        }
        for (int q = 0; q < QUANTITIES; q++)
            attempt->value[s][q] = sum[q] * step / 3;
        attempt->evaluations += attempt->intervals + 1;
    }
}

static double one_quantity(double u, void *context)
{
    struct attempt *attempt = context;
    double value[QUANTITIES];
    integrand(value, attempt->problem, attempt->d, u);
    attempt->evaluations++;
    return value[attempt->quantity];
}

/** GSL's adaptive integration, quantity by quantity, between the places where the law changes. */
static void adaptive(void *context)
{
    struct attempt *attempt = context;
    const struct problem *problem = attempt->problem;
    gsl_function function = {one_quantity, attempt};
    attempt->evaluations = 0;
    for (int s = 0; s < SEPARATIONS; s += APART) {
        attempt->d = problem->d[s];
        double last = last_u(attempt->d), breaks[5] = {0}, error;
        size_t count = 1;
        double changes[] = {asperity_yield_onset * problem->asperity.critical_interference_m / problem->sigma_s_m,
                            asperity_interference_at(&problem->asperity, 1) / problem->sigma_s_m};
        for (int i = 0; i < 2; i++)
            if (changes[i] > breaks[count - 1] && changes[i] < last)
                breaks[count++] = changes[i];
        breaks[count] = last;
        for (attempt->quantity = 0; attempt->quantity < QUANTITIES; attempt->quantity++) {
            if (!(problem->quantities & 1u << attempt->quantity))
                continue;
            double *value = &attempt->value[s][attempt->quantity];
            *value = 0;
            for (size_t b = 0; b < count; b++) {
                double part = 0;
                gsl_integration_qags(&function, breaks[b], breaks[b + 1], 0, attempt->tolerance, ADAPTIVE_PIECES,
                                     attempt->workspace, &part, &error);
                *value += part;
            }
        }
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
    if (quadrature_make(&panels, &problem->asperity, problem->law, problem->sigma_s_m, problem->knudsen_m,
                        problem->lowest_d, attempt->tolerance, &attempt->evaluations, &status) != STATUS_OK)
        attempt->failed = true;
    for (int s = 0; s < SEPARATIONS && !attempt->failed; s++) {
        struct quadrature_sums sums;
        quadrature_sum(&sums, &panels, problem->d[s]);
        attempt->value[s][AREA] = sums.area;
        attempt->value[s][LOAD] = sums.load;
        attempt->value[s][RADIUS] = sums.radius;
        attempt->value[s][RADIUS_SCALE_DEPENDENT] = sums.radius_scale_dependent;
    }
    quadrature_free(&panels);
}

static double largest_error(const struct attempt *attempt, const struct attempt *better, unsigned quantities)
{
    double error = 0;
    for (int s = 0; s < SEPARATIONS; s += APART)
        for (int q = 0; q < QUANTITIES; q++)
            if (quantities & 1u << q)
                error = fmax(error, fabs(attempt->value[s][q] / better->value[s][q] - 1));
    return error;
}

/** What a study adds rows with: its problem, and a better result from an unlike method. */
struct integrals {
    struct benchmark *cost;
    const struct model_row *model;
    struct attempt *attempt;
    const struct attempt *better;
    struct status *status;
};

static enum status_code add(const struct integrals *study, const char *method, const char *setting,
                            void (*work)(void *), bool chosen)
{
    struct attempt *attempt = study->attempt;
    struct benchmark_row row = {
        .model = study->model, .method = method, .chosen = chosen, .chart = BENCHMARK_INTEGRALS};
    snprintf(row.study, sizeof row.study, "%s-integrals", study->model->name);
    snprintf(row.setting, sizeof row.setting, "%s", setting);
    size_t times = work == simpson ? SEPARATIONS / SAMPLES : 1;
    row.seconds = (double)times * benchmark_time(work, attempt);
    row.evaluations = times * attempt->evaluations;
    row.error = largest_error(attempt, study->better, attempt->problem->quantities);
    return attempt->failed ? status_memory(study->status) : benchmark_add(study->cost, &row, study->status);
}

static enum status_code add_methods(const struct integrals *study, double tolerance)
{
    static const size_t intervals[] = {10, 30, 100, 300, 1000, 3000, 10000};
    const double tolerances[] = {1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, tolerance};
    size_t count = sizeof tolerances / sizeof *tolerances;
    char setting[24];
    for (size_t i = 0; i < sizeof intervals / sizeof intervals[0]; i++) {
        study->attempt->intervals = intervals[i];
        snprintf(setting, sizeof setting, "%zu", intervals[i]);
        if (add(study, "Simpson", setting, simpson, false) != STATUS_OK)
            return study->status->code;
    }
    for (size_t i = 0; i + 1 < count; i++)
        if (tolerances[i] == tolerance)
            count--;
    for (size_t i = 0; i < count; i++) {
        study->attempt->tolerance = tolerances[i];
        snprintf(setting, sizeof setting, "%.3g", tolerances[i]);
        if (add(study, "Gauss-Legendre", setting, panels, tolerances[i] == tolerance) != STATUS_OK)
            return study->status->code;
    }
    return STATUS_OK;
}

/** Separations at loads by equal factors from the first to the last of a curve that ends at full contact. */
static bool choose_separations(struct problem *problem, const struct statistical *model,
                               const struct benchmark_task *task)
{
    size_t last = task->load_count;
    while (last > 0 && task->loads[last - 1] >= model->full_load)
        last--;
    double d = 3;
    for (int s = 0; last > 0 && s < SEPARATIONS; s++) {
        struct contact_point point;
        double share = (double)s / (SEPARATIONS - 1),
               load = task->loads[0] * pow(task->loads[last - 1] / task->loads[0], share);
        if (!statistical_solve(&point, model, load, &d))
            return false;
        problem->d[s] = d;
    }
    return last > 0;
}

static enum status_code one_law(struct benchmark *cost, const struct benchmark_task *task, const struct model_row *row,
                                struct status *status)
{
    const struct plan *plan = task->plan;
    enum asperity_model_id law = (enum asperity_model_id)(row->asperity_model - asperity_models);
    struct statistical model;
    uint64_t none = 0;
    if (statistical_make(&model, &task->surface->summary.asperities, &task->surface->summary.pair, law, plan->wanted,
                         task->scene->tolerance, INFINITY, &none, status) != STATUS_OK)
        return status->code;
    struct problem problem = {
        .asperity = model.asperity,
        .law = law,
        .sigma_s_m = model.surface.sigma_s_m,
        .knudsen_m = plan_runs(plan, EFFECT_SCALE_DEPENDENT) ? model.spot.knudsen_length_m : 0,
        .quantities = 1u << AREA | 1u << LOAD,
        .lowest_d = model.full_d,
    };
    if (plan->wanted & (QUANTITY_BIT(QUANTITY_ECR) | QUANTITY_BIT(QUANTITY_TCR)))
        problem.quantities |= 1u << RADIUS;
    if (plan_runs(plan, EFFECT_SCALE_DEPENDENT))
        problem.quantities |= 1u << RADIUS_SCALE_DEPENDENT;
    bool any = choose_separations(&problem, &model, task);
    statistical_free(&model);
    if (!any)
        return STATUS_OK;
    gsl_integration_workspace *workspace = gsl_integration_workspace_alloc(ADAPTIVE_PIECES);
    if (!workspace)
        return status_memory(status);
    struct attempt attempt = {.problem = &problem},
                   better = {.problem = &problem, .workspace = workspace, .tolerance = 1e-13};
    adaptive(&better);
    struct integrals study = {cost, row, &attempt, &better, status};
    enum status_code rc = add_methods(&study, task->scene->tolerance);
    gsl_integration_workspace_free(workspace);
    return rc;
}

enum status_code benchmark_integrals(struct benchmark *cost, const struct benchmark_task *task, struct status *status)
{
    enum status_code rc = STATUS_OK;
    for (size_t m = 0; m < model_count && rc == STATUS_OK; m++)
        if (model_rows[m]->asperity_model && task->surface->curves[m].exists)
            rc = one_law(cost, task, model_rows[m], status);
    return rc;
}
