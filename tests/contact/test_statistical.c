/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model_support.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

static struct statistical make(double m0, double m2, double m4, bool plastic, double tolerance, double lowest)
{
    const struct asperities surface = model_support_asperities(m0, m2, m4);
    const struct material_pair pair = model_support_tin();
    return model_support_statistical(&surface, &pair, plastic, tolerance, lowest);
}

TEST_CASE(matches_reference)
{
    static const double tolerances[] = {1e-10, 1e-3, 1e-6};
    struct table table = table_read("golden/statistical.csv");
    for (size_t k = 0; k < 3 * table.rows; k++) {
        const size_t i = k / 3;
        const double allowed = tolerances[k % 3], d = table_number(&table, i, "d_over_sigma_s");
        struct statistical model =
            make(table_number(&table, i, "m0_m2"), table_number(&table, i, "m2"), table_number(&table, i, "m4_per_m2"),
                 strcmp(table_text(&table, i, "model"), "jg") == 0, allowed, d);
        struct contact_point point;
        statistical_at(&point, &model, d);
        model_support_matches(&point, &table, i, allowed);
        assert_near(point.value[QUANTITY_SEPARATION] / model.surface.sigma_m,
                    table_number(&table, i, "separation_over_sigma"), 1e-10);
    }
}

TEST_CASE(beta_matches_reference)
{
    static const struct {
        const char *name;
        double m0, m2, m4;
    } sets[] = {{"moderate", 1.156e-13, 0.0012, 4.5e8},
                {"narrow-band", 1e-12, 0.0098696044, 1.2e8},
                {"broad-band", 3.3872e-11, 0.02, 2.4e10}};
    struct table table = table_read("golden/beta.csv");
    for (size_t i = 0; i < table.rows; i++)
        for (int s = 0; s < 3; s++) {
            if (strcmp(table_text(&table, i, "set"), sets[s].name) != 0)
                continue;
            struct statistical model = make(sets[s].m0, sets[s].m2, sets[s].m4,
                                            strcmp(table_text(&table, i, "model"), "jg") == 0, 1e-10, INFINITY);
            assert_near(model.surface.density_per_m2, table_number(&table, i, "eta_per_m2"), 1e-10);
            assert_near(model.surface.radius_m, table_number(&table, i, "radius_m"), 1e-10);
            assert_near(model.surface.sigma_s_m, table_number(&table, i, "sigma_s_m"), 1e-10);
            assert_near(model.surface.offset_m, table_number(&table, i, "y_s_m"), 1e-10);
            assert_near(model.beta, table_number(&table, i, "beta"), 1e-10);
            struct contact_point full;
            statistical_full(&full, &model);
            assert_near(full.value[QUANTITY_AREA], 1, 0);
            assert_within(full.value[QUANTITY_ADJUSTED], 0, 0);
        }
}

/** Moments over the nodes are those of the sums: j = 0 the sum itself, j = 1 its slope with respect to d. */
TEST_CASE(moments_are_derivatives)
{
    struct statistical model = make(3.3872e-11, 0.02, 2.4e10, true, 1e-10, -3);
    for (double d = -3; d < 6; d += 0.7) {
        struct quadrature_sums sums, before, after;
        double moment[2][3], log_factor, step = 1e-5;
        quadrature_sum(&sums, &model.panels, d);
        quadrature_sum(&before, &model.panels, d - step);
        quadrature_sum(&after, &model.panels, d + step);
        quadrature_moments(moment[0], &log_factor, &model.panels, true, d);
        quadrature_moments(moment[1], &log_factor, &model.panels, false, d);
        assert_true(log_factor == sums.log_factor);
        assert_near(moment[0][0], sums.area, 1e-15);
        assert_near(moment[1][0], sums.load, 1e-15);
        double lower = exp(before.log_factor - log_factor), upper = exp(after.log_factor - log_factor);
        assert_near(moment[0][1] + d * sums.area, (before.area * lower - after.area * upper) / (2 * step), 1e-6);
        assert_near(moment[1][1] + d * sums.load, (before.load * lower - after.load * upper) / (2 * step), 1e-6);
    }
}

/** The share beyond a/R = 0.41 by an independent adaptive integration. */
struct integrand {
    const struct statistical *model;
    double d;
};

static double load_density(double u, void *context)
{
    const struct integrand *in = context;
    struct asperity_contact contact = asperity_press(&in->model->asperity, u * in->model->surface.sigma_s_m);
    return contact.load_N * exp(-(u + in->d) * (u + in->d) / 2);
}

/** ln of the load on asperities beyond u = `from`, by pieces on which the Gaussian falls by exp(-0.5) to exp(-1.5). */
static double log_load_beyond(const struct statistical *model, double d, double from,
                              gsl_integration_workspace *workspace)
{
    struct integrand in = {model, d};
    gsl_function f = {load_density, &in};
    double step = 1 / fmax(1, from + d), sum = 0, piece, error;
    double breaks[] = {asperity_yield_onset * model->asperity.critical_interference_m / model->surface.sigma_s_m,
                       model->panels.beyond_fit, model->panels.radius_clamped};
    for (double low = from, end = from + 60 * step + fmax(0, -d); low < end;) {
        double high = fmin(low + step, end);
        for (int b = 0; b < 3; b++)
            high = breaks[b] > low ? fmin(high, breaks[b]) : high;
        gsl_integration_qag(&f, low, high, 0, 1e-13, 2000, GSL_INTEG_GAUSS41, workspace, &piece, &error);
        sum += piece;
        low = high;
    }
    return log(sum);
}

/** Of the whole load. */
TEST_CASE(load_shares_follow_the_tolerance)
{
    static const double tolerances[] = {0.1, 1e-3, 1e-6, 1e-9}, sizes[] = {1, 0.3, 0.15};
    gsl_integration_workspace *workspace = gsl_integration_workspace_alloc(2000);
    gsl_error_handler_t *handler = gsl_set_error_handler_off(); /* qag cannot reach 1e-13 everywhere */
    size_t shares = 0;
    for (size_t c = 0; c < 3; c++)
        for (size_t t = 0; t < 4; t++) {
            double square = sizes[c] * sizes[c];
            struct statistical model =
                make(3.3872e-11 * square, 0.02 * square, 2.4e10 * square, true, tolerances[t], INFINITY);
            double borders[2] = {model.panels.beyond_fit, model.panels.radius_clamped};
            for (double d = model.full_d; d < 5; d += 0.7) {
                struct contact_point point;
                statistical_at(&point, &model, d);
                double all = log_load_beyond(&model, d, 0, workspace),
                       got[2] = {point.beyond_fit, point.radius_clamped};
                for (int b = 0; b < 2; b++) {
                    double share = exp(log_load_beyond(&model, d, borders[b], workspace) - all);
                    assert_within(got[b], share, tolerances[t]);
                    shares += share > tolerances[t];
                }
            }
        }
    assert_true(shares >= 50);
    gsl_set_error_handler(handler);
    gsl_integration_workspace_free(workspace);
}

/** A beta made up of a known answer: separations that the formula maps onto each other give it back. */
TEST_CASE(second_beta_inverts_the_adjustment)
{
    double sigma = 2e-7, delta[] = {3e-7, 1e-7, -2e-7};
    for (int i = 0; i < 3; i++)
        assert_near(statistical_beta_multiscale(delta[i], (delta[i] + 0.5 * 5.2 * sigma) / 2, sigma), 5.2, 1e-14);
}
