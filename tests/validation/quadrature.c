/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The integrals of the statistical models by Simpson's rule, as the thesis takes them, and by the program's panels. */
#include "contact/statistical.h"
#include "statistics/coverage.h"
#include "support.h"
#include "validation/truths.h"
#include <gsl/gsl_integration.h>

enum { SEPARATIONS = 10, QUANTITIES = 3 };

/** int law(sigma_s u) phi(u + d) du over u > 0 of area, load or radius. */
struct integral {
    const struct statistical *model;
    double d;
    int quantity;
};

static double integrand(double u, void *context)
{
    const struct integral *of = context;
    struct asperity_contact contact = asperity_press(&of->model->asperity, of->model->surface.sigma_s_m * u);
    const double value[QUANTITIES] = {contact.area_m2, contact.load_N, contact.radius_m};
    return value[of->quantity] * exp(-(u + of->d) * (u + of->d) / 2) / sqrt(2 * M_PI);
}

/** Beyond it the Gaussian is below 1e-17 of its largest value. */
static double last_u(double d)
{
    double cut = 40;
    return d > 0 ? 2 * cut / (d + sqrt(d * d + 2 * cut)) : sqrt(2 * cut) - d;
}

/** GSL's adaptive rule, which is told where the law changes. */
static double adaptive(struct integral *of)
{
    enum { PIECES = 1000 };
    const struct asperity *asperity = &of->model->asperity;
    const double changes[] = {asperity_yield_onset * asperity->critical_interference_m,
                              asperity_interference_at(asperity, 1)};
    double end = last_u(of->d), breaks[4] = {0}, value, error;
    size_t count = 1;
    for (size_t k = 0; k < 2; k++) {
        double at = changes[k] / of->model->surface.sigma_s_m;
        if (at > breaks[count - 1] && at < end)
            breaks[count++] = at;
    }
    breaks[count++] = end;
    gsl_integration_workspace *workspace = gsl_integration_workspace_alloc(PIECES);
    gsl_function function = {integrand, of};
    coverage_must(gsl_integration_qagp(&function, breaks, count, 0, 1e-12, PIECES, workspace, &value, &error) == 0
                      ? STATUS_OK
                      : STATUS_MODEL,
                  &(struct status){.message = "an adaptive integral did not converge"});
    gsl_integration_workspace_free(workspace);
    return value;
}

/** Composite Simpson over [0, last_u] with so many sub-intervals. */
static double simpson(struct integral *of, double intervals, uint64_t *evaluations)
{
    double step = last_u(of->d) / intervals, sum = 0;
    for (size_t i = 0; i <= (size_t)intervals; i++)
        sum += (i == 0 || i == (size_t)intervals ? 1 : i % 2 ? 4 : 2) * integrand(step * (double)i, of);
    *evaluations = SEPARATIONS * ((uint64_t)intervals + 1);
    return sum * step / 3;
}

/** The program's Gauss-Legendre panels, which are laid once for all separations. */
static double panels(struct integral *of, double tolerance, uint64_t *evaluations)
{
    const struct statistical *model = of->model;
    struct quadrature laid;
    struct quadrature_sums sums;
    expect_ok(quadrature_make, &laid, &model->asperity, model->surface.sigma_s_m, 0, model->full_d, tolerance);
    *evaluations = laid.count;
    quadrature_sum(&sums, &laid, of->d);
    quadrature_free(&laid);
    const double value[QUANTITIES] = {sums.area, sums.load, sums.radius};
    return value[of->quantity] * exp(sums.log_factor);
}

static const struct row {
    const char *name;
    double (*rule)(struct integral *of, double setting, uint64_t *evaluations);
    double setting, bound;
} rows[] = {{"Simpson", simpson, 10, 0},       {"Simpson", simpson, 100, 0},   {"Simpson", simpson, 1000, 4e-4},
            {"Simpson", simpson, 10000, 2e-5}, {"panels", panels, 1e-3, 1e-3}, {"panels", panels, 1e-4, 1e-4},
            {"panels", panels, 1e-6, 1e-6},    {"panels", panels, 1e-8, 1e-8}, {"panels", panels, 1e-10, 1e-10},
            {"panels", panels, 1e-12, 1e-12}};

void quadrature_add(struct page *page)
{
    struct material_pair pair = material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    struct asperities surface = truths_asperities(2);
    struct statistical models[2];
    uint64_t evaluations;
    const struct model_task task = {.asperities = &surface, .pair = &pair, .tolerance = 1e-10};
    for (int m = 0; m < 2; m++)
        expect_ok(statistical_make, &models[m], &task, m, INFINITY);
    page_rows(page, "quadrature");
    for (const struct row *row = rows; row < rows + sizeof rows / sizeof *rows; row++) {
        text_add(&page->text, "| %s | %g |", row->name, row->setting);
        for (int m = 0; m < 2; m++) {
            double error = 0;
            for (int k = 0; k < SEPARATIONS * QUANTITIES; k++) {
                double d = 4 + (models[m].full_d - 4) * (k / QUANTITIES) / (SEPARATIONS - 1);
                struct integral of = {&models[m], d, k % QUANTITIES};
                error = fmax(error, fabs(row->rule(&of, row->setting, &evaluations) / adaptive(&of) - 1));
            }
            page_number(page, error, row->bound);
            text_add(&page->text, " %zu |", (size_t)evaluations);
        }
        text_add(&page->text, "\n");
    }
    for (int m = 0; m < 2; m++)
        statistical_free(&models[m]);
}
