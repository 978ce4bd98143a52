/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What yielding can change at most, against the same sums by a quadrature of their own. */
#include "contact/multiscale.h"
#include "contact/statistical.h"
#include "support.h"

extern const struct model_row model_gw, model_jg;

enum { LOADS = 25 };

static double loads[LOADS];
static struct material_pair pair;
static struct asperities surface;

/** int_0^inf w(u) phi(u + h) du by Simpson's rule in t = sqrt(u), which takes the roots of u out. */
static double gaussian(double (*w)(double u, const double *parameters), const double *parameters, double h)
{
    enum { STEPS = 4000 };
    double last = sqrt(fmax(12 - h, 12) + 8), step = last / STEPS, sum = 0;
    for (int i = 0; i <= STEPS; i++) {
        double t = step * i, u = t * t, s = u + h;
        double value = 2 * t * w(u, parameters) * exp(-s * s / 2) / sqrt(2 * M_PI);
        sum += value * (i == 0 || i == STEPS ? 1 : i % 2 ? 4 : 2);
    }
    return sum * step / 3;
}

static double power(double u, const double *n)
{
    return pow(u, *n);
}

/** F_n(h). */
static double moment(double n, double h)
{
    return gaussian(power, &n, h);
}

/** (v + y) exp(B v/y): Hertz's area beyond the yield y times the largest growth of JG's. */
static double grown(double v, const double *y_and_exponent)
{
    return (v + y_and_exponent[0]) * exp(y_and_exponent[1] * v / y_and_exponent[0]);
}

/** The statement of model_statistical.c, term by term. */
static double expected(unsigned wanted, double d, double area)
{
    struct asperity asperity = asperity_make(surface.radius_m, &pair, ASPERITY_JG);
    double yield = 1.9 * asperity.critical_interference_m / surface.sigma_s_m;
    double load = sqrt(2) * (moment(1.5, d + yield) + pow(yield, 1.5) * moment(0, d + yield)) / moment(1.5, d);
    double more = gaussian(grown, (double[]){yield, asperity.area_exponent}, d + yield) / moment(1, d);
    double change = 1.5 * more + load, scale = 2 * surface.sigma_s_m / surface.sigma_m;
    if (wanted & QUANTITY_BIT(QUANTITY_SEPARATION)) {
        change = fmax(change, scale * more * moment(1, d) / moment(0, d));
        change = fmax(change, scale * load * moment(1.5, d) / (1.5 * moment(0.5, d)));
    }
    if (wanted & (QUANTITY_BIT(QUANTITY_ECR) | QUANTITY_BIT(QUANTITY_TCR)))
        change = fmax(change, more + 2 * load + 0.75 * sqrt(area) / (1 - sqrt(area)) * (more + load));
    return change;
}

static struct model_task task_of(unsigned wanted)
{
    return (struct model_task){.asperities = &surface,
                               .pair = &pair,
                               .loads = loads,
                               .load_count = LOADS,
                               .wanted = wanted,
                               .tolerance = 1e-9};
}

/** Asperities of 2 um radius and 0.1 um height in a metal of this yield strength, loads up to `most`. */
static void make(double yield_Pa, double most)
{
    static struct material metal;
    metal = *material_find("tin");
    metal.yield_strength_Pa = yield_Pa;
    pair = material_pair(&metal, MATERIAL_COUNTERFACE_RIGID, NULL);
    surface = (struct asperities){
        .nayak = 10, .density_per_m2 = 5e11, .radius_m = 2e-6, .sigma_s_m = 1e-7, .offset_m = 1e-8, .sigma_m = 1.1e-7};
    for (int i = 0; i < LOADS; i++)
        loads[i] = most * pow(10, (i - LOADS + 1) / 6.0);
}

/** GW's curve, with no quantity but those asked for. */
static struct model_curve run(struct contact_point *points, const struct model_row *row, unsigned wanted)
{
    struct status status = {0};
    struct model_task task = task_of(wanted);
    struct model_curve curve = {.points = points};
    assert_int_equal(model_run(&curve, row, &task, &status), STATUS_OK);
    assert_true(curve.exists);
    return curve;
}

TEST_CASE(test_the_bound_of_jg)
{
    static const double yields_Pa[] = {5e8, 1e9, 3e9, 9e9}, most[] = {1e-3, 1e-2};
    static const unsigned wanted[] = {0, QUANTITY_BIT(QUANTITY_SEPARATION), QUANTITY_BIT(QUANTITY_ECR),
                                      QUANTITY_BIT(QUANTITY_TCR)};
    size_t small = 0;
    for (size_t y = 0; y < 4; y++)
        for (size_t l = 0; l < 2; l++)
            for (size_t w = 0; w < 4; w++) {
                struct contact_point points[LOADS + 1];
                struct model_task task = task_of(wanted[w]);
                struct statistical gw;
                struct status status = {0};
                uint64_t none = 0;
                make(yields_Pa[y], most[l]);
                struct model_curve curve = run(points, &model_gw, 0);
                assert_int_equal(curve.count, LOADS); /* short of full contact */
                assert_int_equal(statistical_make(&gw, &surface, &pair, ASPERITY_HERTZ, 0, 1, INFINITY, &none, &status),
                                 STATUS_OK);
                double bound = model_jg.yield_bound(&model_jg, &task);
                assert_near(bound, expected(wanted[w], gw.full_d, points[LOADS - 1].value[QUANTITY_AREA]), 1e-6);
                small += bound < 1e-6;
                statistical_free(&gw);
            }
    assert_true(small >= 8); /* also where it decides */
}

static double change(double a, double b)
{
    return fabs(b - a) / fabs(a);
}

/* Nothing that JG computes is farther from GW than that. */
TEST_CASE(test_jg_stays_within_its_bound)
{
    const unsigned wanted = (1u << QUANTITY_COUNT) - 1;
    for (double yield_Pa = 4e8; yield_Pa < 5e9; yield_Pa *= 1.3) {
        struct contact_point a[LOADS + 1], b[LOADS + 1];
        make(yield_Pa, 1e-2);
        struct model_task task = task_of(wanted);
        struct model_curve gw = run(a, &model_gw, wanted), jg = run(b, &model_jg, wanted);
        double bound = model_jg.yield_bound(&model_jg, &task) + 1e-7; /* the integrals' tolerance */
        assert_true(change(gw.full_load, jg.full_load) <= bound);
        assert_true(fabs(gw.beta - jg.beta) <= bound);
        for (size_t i = 0; i < gw.count && i < jg.count; i++) {
            assert_true(change(a[i].value[QUANTITY_AREA], b[i].value[QUANTITY_AREA]) <= bound);
            assert_true(fabs(a[i].value[QUANTITY_ADJUSTED] - b[i].value[QUANTITY_ADJUSTED]) / surface.sigma_m <= bound);
            assert_true(change(a[i].value[QUANTITY_ECR], b[i].value[QUANTITY_ECR]) <= bound);
        }
    }
}

TEST_CASE(test_surfaces_without_asperities)
{
    make(1e9, 1e-3);
    struct model_task task = task_of(0);
    task.asperities = NULL;
    assert_near(model_jg.yield_bound(&model_jg, &task), 0, 0);
    make(4.9e10, 1e-3); /* yields beyond every asperity there is */
    assert_near(model_jg.yield_bound(&model_jg, &(struct model_task){.asperities = &surface, .pair = &pair}), 0, 0);
}

/* The corrected theory: no area differs by more, up to the largest. */
TEST_CASE(test_the_bound_of_spots)
{
    static const char *const names[] = {"corrected-persson", "strip"};
    struct strip strip = {.own = {.count = 1, .logit = {-20}, .value = {{-1, 0, 0}}}, .surrogates = 1};
    double amplitude_m[] = {1e-7, 2e-8, 5e-9}, height_m[] = {0, 1e-7, 0, 2e-7};
    struct spectrum spectrum = {amplitude_m, 3, 1e-5, false};
    struct strip_rows rows = {height_m, 1, 4, 1e-6, true};
    strip.surrogate[0] = strip.own;
    make(1e9, 1e-3);
    struct model_task task = task_of(0);
    task.spectrum = &spectrum;
    task.rows = &rows;
    task.strip = &strip;
    for (int k = 0; k < LOADS; k++)
        loads[k] = 1e-4 * pow(1e4, k / (LOADS - 1.0));
    for (int m = 0; m < 2; m++)
        for (double over = 0.01; over < 3; over *= 3) { /* the slope over the hardness */
            struct contact_point a[LOADS + 1], b[LOADS + 1];
            struct model_curve elastic = {.points = a}, plastic = {.points = b};
            struct status status = {0};
            size_t row = model_named(names[m]);
            task.hardness_Pa = sqrt(spectrum_moment(&spectrum, 1)) * pair.effective_modulus_Pa / over;
            assert_int_equal(model_run(&elastic, model_rows[row], &task, &status), STATUS_OK);
            assert_int_equal(model_run(&plastic, model_rows[row + 1], &task, &status), STATUS_OK);
            double bound = model_rows[row + 1]->yield_bound(model_rows[row + 1], &task), most = 0;
            assert_true(plastic.count > LOADS / 4);
            for (size_t i = 0; i < plastic.count; i++)
                most = fmax(most, b[i].value[QUANTITY_AREA] / a[i].value[QUANTITY_AREA] - 1);
            assert_true(most <= bound);
            assert_true(m == 1 || bound > 0.1 || bound < 1.3 * most);
            if (over == 0.01) {
                char words[80];
                model_rows[row + 1]->yield_reason(words, sizeof words, bound, false);
                assert_string_equal(words, m ? "no spot bears more than 0.06 of the hardness"
                                             : "no spot bears more than 0.015 of the hardness");
            }
        }
}

/* The multiscale bound: p* over p_c of the steepest harmonic where that yields before it is complete, else 0. */
TEST_CASE(test_the_bound_of_the_stack)
{
    double amplitude_m[] = {1e-8, 2e-8, 5e-9};
    struct spectrum spectrum = {amplitude_m, 3, 1e-5, false}; /* slopes 1e-8, 4e-8, 1.5e-8 over 1e-5 */
    make(1e7, 1e-3);
    struct model_task task = task_of(0);
    task.spectrum = &spectrum;
    struct sinusoid_scale steepest = sinusoid_scale(2e-8, 2e5, &pair, true);
    double sooner = steepest.full_pressure_Pa / steepest.critical_pressure_Pa;
    assert_true(sooner > 1);
    assert_near(model_multiscale_plastic.yield_bound(&model_multiscale_plastic, &task), sooner, 1e-12);
    size_t soon = 0, never = 0;
    for (int k = 0; k < 800; k++) {
        pair.yield_strength_Pa *= 1.01;
        steepest = sinusoid_scale(2e-8, 2e5, &pair, true);
        sooner = steepest.full_pressure_Pa / steepest.critical_pressure_Pa;
        soon += sooner > 1 && sooner < 1.1; /* either side of the border was met */
        never += sooner < 1 && sooner > 0.9;
        assert_near(model_multiscale_plastic.yield_bound(&model_multiscale_plastic, &task), sooner > 1 ? sooner : 0,
                    1e-12);
    }
    assert_true(soon > 0 && never > 0);
    spectrum.count = 0;
    assert_near(model_multiscale_plastic.yield_bound(&model_multiscale_plastic, &task), 0, 0);
}
