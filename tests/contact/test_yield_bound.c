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
