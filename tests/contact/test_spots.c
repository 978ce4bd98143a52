/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Number and radius of the spots of the asperity models, against integrals over asperities taken one by one. */
#include "base/integral.h"
#include "model_support.h"

/** a^power phi(u + d) of the asperities that stand u sigma_s above the flat. */
struct spot_integrand {
    const struct asperity *asperity;
    double sigma_s_m, d, power;
};

static double spot_integrand(double u, void *context)
{
    const struct spot_integrand *f = context;
    struct asperity_contact contact = asperity_press(f->asperity, f->sigma_s_m * u);
    return (f->power > 0 ? pow(contact.radius_m, f->power) : 1) * exp(-(u + f->d) * (u + f->d) / 2) / sqrt(2 * M_PI);
}

static double over_asperities(struct spot_integrand f, double power)
{
    double onset = asperity_yield_onset * f.asperity->critical_interference_m / f.sigma_s_m, end = 14 + fmax(0, -f.d);
    f.power = power;
    double middle = fmin(onset, end);
    return integral(spot_integrand, &f, 0, middle, 1e-12) +
           (middle < end ? integral(spot_integrand, &f, middle, end, 1e-12) : 0);
}

static const struct {
    double m0, m2, m4;
} surfaces[] = {{1.156e-13, 0.0012, 4.5e8}, {1e-12, 0.0098696044, 1.2e8}, {3.3872e-11, 0.02, 2.4e10}};

/** n = eta int phi, a = int a³ phi/int a² phi, at the separation of each load; more load, more and larger spots. */
TEST_CASE(spots_are_integrals_over_asperities)
{
    static const char *const names[] = {"gw", "jg"};
    struct material_pair pair = model_support_tin();
    double load[MODEL_LOADS];
    struct contact_point points[MODEL_LOADS + 1];
    struct contact_spots spots[MODEL_LOADS];
    model_support_loads(load, MODEL_LOADS, 1e-8, 1e-2);
    for (size_t s = 0; s < sizeof surfaces / sizeof *surfaces; s++)
        for (int plastic = 0; plastic < 2; plastic++) {
            struct asperities surface = model_support_asperities(surfaces[s].m0, surfaces[s].m2, surfaces[s].m4);
            struct asperity asperity = asperity_make(surface.radius_m, &pair, plastic);
            struct model_task task = model_support_task(NULL, &pair, load, MODEL_LOADS);
            task.asperities = &surface;
            task.tolerance = 1e-10;
            struct model_curve curve = model_support_run(points, names[plastic], &task);
            model_support_spots(spots, names[plastic], &task);
            bool closed = curve.points[curve.count - 1].value[QUANTITY_LOAD] == curve.full_load;
            size_t pressed = curve.count - closed;
            assert_true(pressed > 5);
            for (size_t i = 0; i < pressed; i++) {
                struct spot_integrand f = {
                    &asperity, surface.sigma_s_m,
                    (points[i].value[QUANTITY_SEPARATION] - surface.offset_m) / surface.sigma_s_m, 0};
                double area = over_asperities(f, 2);
                assert_near(surface.density_per_m2 * M_PI * area, points[i].value[QUANTITY_AREA],
                            1e-8); /* the same spots */
                assert_near(spots[i].density_per_m2, surface.density_per_m2 * over_asperities(f, 0), 1e-8);
                assert_near(spots[i].radius_m, over_asperities(f, 3) / area, 1e-8);
                if (i > 0)
                    assert_true(spots[i].density_per_m2 > spots[i - 1].density_per_m2 &&
                                spots[i].radius_m > spots[i - 1].radius_m);
            }
            for (size_t i = pressed; i < MODEL_LOADS; i++)
                assert_true(isnan(spots[i].density_per_m2) && isnan(spots[i].radius_m));
        }
}

/** Where nothing yields JG has GW's spots; far apart GW's are those of exponential heights. */
TEST_CASE(spots_in_the_limits)
{
    struct asperities surface = model_support_asperities(1e-12, 1e-4, 1e5);
    struct material soft = *material_find("tin");
    soft.yield_strength_Pa = 2e9; /* beyond what these blunt asperities bear at any height that counts */
    struct material_pair pair = material_pair(&soft, MATERIAL_COUNTERFACE_RIGID, NULL);
    double load[MODEL_LOADS];
    struct contact_spots gw[MODEL_LOADS], jg[MODEL_LOADS];
    model_support_loads(load, MODEL_LOADS, 1e-9, 1e-5);
    struct model_task task = {
        .asperities = &surface, .pair = &pair, .loads = load, .load_count = MODEL_LOADS, .tolerance = 1e-10};
    model_support_spots(gw, "gw", &task);
    model_support_spots(jg, "jg", &task);
    for (size_t i = 0; i < MODEL_LOADS; i++) {
        assert_near(jg[i].density_per_m2, gw[i].density_per_m2, 1e-8);
        assert_near(jg[i].radius_m, gw[i].radius_m, 1e-8);
    }
    /* far apart, heights above the flat are exponential: F_3/2/F_1 = Gamma(5/2)/sqrt(d) */
    struct statistical model = model_support_statistical(&surface, &pair, false, 1e-10, INFINITY);
    double d = 35;
    struct contact_spots far = statistical_spots(&model, d);
    assert_near(far.radius_m, sqrt(surface.radius_m * surface.sigma_s_m / d) * 0.75 * sqrt(M_PI), 2e-3);
    assert_near(far.density_per_m2, surface.density_per_m2 * erfc(d / M_SQRT2) / 2, 1e-12);
    task.asperities = NULL; /* no statistical model exists */
    model_support_spots(gw, "gw", &task);
    assert_true(isnan(gw->density_per_m2) && isnan(gw->radius_m));
}

/** Stacked scales have spots on spots: no number of them. */
TEST_CASE(stacked_scales_have_none)
{
    for (size_t m = 0; m < model_count; m++)
        assert_false(model_rows[m]->stacks_scales && model_rows[m]->spots);
    assert_null(model_rows[model_named("corrected-persson")]->spots);
    assert_null(model_rows[model_named("strip")]->spots);
}
