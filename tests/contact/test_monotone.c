/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contact only grows with load, and more contact never conducts less, whatever the heights: no model but the thesis's
 * four, which stay as printed, has an area that falls, or a separation or a resistance that rises. */
#include "contact/corrected_persson.h"
#include "direct/direct_surface.h"
#include "model_support.h"

enum {
    POINTS = 200,
    ROWS = 3,
    LOADS = 121,
    EVERY = 8, /* of the loads, asked for alone */
#if defined __SANITIZE_ADDRESS__ || defined __SANITIZE_THREAD__
    PROFILES = 48
#else
    PROFILES = 300
#endif
};

static const char *const models[] = {"corrected-persson", "corrected-persson-plastic", "strip", "strip-plastic", "cmy"};
enum { MODELS = sizeof models / sizeof *models };

/** Waves of random phases, amplitudes falling as of a Hurst exponent 0.2 ... 1 below a longest one of L/1 ... L/6;
 * rms 1. */
static void draw_waves(double *z, uint64_t seed)
{
    double hurst = 0.2 + 0.8 * direct_random(seed, 1), square = 0, most = POINTS / (4 + 12 * direct_random(seed, 2));
    double first = 1 + floor(6 * direct_random(seed, 3));
    memset(z, 0, ROWS * POINTS * sizeof *z);
    for (size_t r = 0; r < ROWS; r++)
        for (double n = first; n <= most; n++) {
            double amplitude = pow(n, -0.5 - hurst), phase = direct_random(seed, 1000 * (r + 1) + (size_t)n);
            for (size_t i = 0; i < POINTS; i++)
                z[r * POINTS + i] += amplitude * cos(2 * M_PI * (n * (double)i / POINTS + phase));
            square += amplitude * amplitude / 2 / ROWS;
        }
    for (size_t i = 0; i < ROWS * POINTS; i++)
        z[i] /= sqrt(square);
}

/** What wear, etching, an instrument or a drawing makes of waves. */
static double shape(double z, size_t kind, double strength, double chance)
{
    switch (kind) {
    case 1: /* plateaus */
        return fmin(z, 0) + 0.3 * strength * fmax(z, 0);
    case 2: /* pits */
        return 0.05 * z - (z < -1.2 ? 3 * (1 + strength) : 0);
    case 3: /* peaks */
        return exp((0.5 + strength) * z);
    case 4: /* worn, and a little rough */
        return fmin(z, strength - 0.5) + 1e-3 * chance;
    case 5: /* terraces, and a little rough */
        return round(z / (0.2 + strength)) * (0.2 + strength) + 0.01 * chance;
    case 6: /* clipped above, below or on both sides */
        return fmin(fmax(z, strength < 0.6 ? -2 * strength : -9), strength > 0.3 ? strength : 9);
    case 7: /* quantised */
        return round(z * (3 + 20 * strength));
    case 8: /* two-valued */
        return z > 2 * strength - 1;
    case 9: /* spikes */
        return 0.1 * z + (chance > 0.97 ? 5 * strength : 0);
    case 10: /* upside down */
        return -exp((0.5 + strength) * z);
    case 11: /* noise */
        return z * strength + chance;
    default:
        return z;
    }
}

static void draw(double *height_m, size_t number)
{
    uint64_t seed = 4242 + number;
    double strength = direct_random(seed, 4);
    draw_waves(height_m, seed);
    for (size_t i = 0; i < ROWS * POINTS; i++)
        height_m[i] = 1e-6 * shape(height_m[i], number % 12, strength, direct_random(seed, 100000 + i));
    for (size_t r = 0; r < ROWS; r++) {
        double mean = 0;
        for (size_t i = 0; i < POINTS; i++)
            mean += height_m[r * POINTS + i] / POINTS;
        for (size_t i = 0; i < POINTS; i++)
            height_m[r * POINTS + i] -= mean;
    }
}

/** A profile, or three, ready for the models. */
struct made {
    double height_m[ROWS * POINTS], load[LOADS];
    struct strip_rows rows;
    struct spectrum spectrum;
    struct strip strip;
    struct material_pair pair;
    struct model_task task;
};

/** False: nothing to solve, as the heights happen to be. */
static bool make(struct made *out, size_t number)
{
    struct status status = {0};
    size_t rows = 1 + number / 12 % ROWS, surrogates = 1 + number % 2;
    draw(out->height_m, number);
    out->rows = (struct strip_rows){out->height_m, rows, POINTS, 1e-6, number % 5 == 0, NULL, rows};
    out->spectrum = model_support_spectrum(out->height_m, rows, POINTS, 1e-6);
    double slope = sqrt(2 * spectrum_moment(&out->spectrum, 1));
    if (!(slope > 0) || strip_solve(&out->strip, &out->rows, surrogates, &test_alone, &status) != STATUS_OK)
        return false;
    model_support_loads(out->load, LOADS, 1e-6 * slope, 10 * slope);
    out->pair = model_support_tin();
    out->task = model_support_task(&out->spectrum, &out->pair, out->load, LOADS);
    out->task.hardness_Pa = 0.02 * pow(200, direct_random(number, 5)) * slope * out->pair.effective_modulus_Pa;
    out->task.strip = &out->strip;
    out->task.bearing = model_support_bearing(&out->rows);
    return true;
}

static const struct {
    enum quantity quantity;
    double sign; /* of what it does with load */
} curves[] = {{QUANTITY_AREA, 1}, {QUANTITY_SEPARATION, -1}, {QUANTITY_ECR, -1}, {QUANTITY_TCR, -1}};
enum { CURVES = sizeof curves / sizeof *curves };

static const double rounding = 1e-9; /* relative */

/** By how much at most, in ln, a quantity goes the wrong way. */
static double wrong(const struct contact_point *point, size_t count, size_t c)
{
    double most = 0, best = -INFINITY;
    for (size_t i = 0; i < count; i++) {
        double value = curves[c].sign * log(point[i].value[curves[c].quantity]);
        most = fmax(most, best - value);
        best = fmax(best, value);
    }
    return most;
}

/** Nor do a strip's own solutions. */
static void expect_solutions_fall(const struct strip_curve *curve)
{
    for (size_t k = 1; k < curve->count; k++)
        for (size_t q = 1; q < 3; q++)
            assert_true(curve->value[k][q] <= curve->value[k - 1][q] + rounding);
}

/** The longest stretch of loads, in decades, over which a curve's logarithm changes by less than 1e-3, where A is .001
 * to .9. */
static double level_stretch(const struct contact_point *point, size_t count, enum quantity quantity)
{
    double most = 0;
    for (size_t i = 0, first = 0; i < count; i++) {
        const double area = point[i].value[QUANTITY_AREA];
        if (!(area > 1e-3 && area < 0.9 && point[i].value[quantity] > 0)) { /* two heights alone leave no gap */
            first = i + 1;
            continue;
        }
        while (fabs(log(point[first].value[quantity] / point[i].value[quantity])) >= 1e-3)
            first++;
        most = fmax(most, log10(point[i].value[QUANTITY_LOAD] / point[first].value[QUANTITY_LOAD]));
    }
    return most;
}

/** No curve turns back, and no leading one of gap or resistance has a stair of more than a fifth of a decade. */
TEST_CASE(curves_are_monotone_without_stairs)
{
    struct made *made = support_room(sizeof *made);
    struct contact_point point[LOADS + 1];
    size_t solved = 0, wrong_ones = 0;
    for (size_t n = 0; n < PROFILES; n++) {
        if (!make(made, n))
            continue;
        solved++;
        expect_solutions_fall(&made->strip.own);
        expect_solutions_fall(&made->strip.surrogate[0]);
        for (size_t m = 0; m < MODELS; m++) {
            struct model_curve curve = model_support_run(point, models[m], &made->task);
            assert_true(curve.exists);
            for (size_t c = 0; c < CURVES; c++) {
                const double by = wrong(point, curve.count, c);
                const bool leads = strncmp(models[m], "strip", 5) == 0 && c > 0;
                const double level = leads ? level_stretch(point, curve.count, curves[c].quantity) : 0;
                if (by <= rounding && level <= 0.2)
                    continue;
                wrong_ones++;
                print_message("%s of profile %zu, %s: turns back by a factor %.3g, stair of %.2g decades\n", models[m],
                              n, quantity_rows[curves[c].quantity].name, exp(by), level);
            }
        }
    }
    assert_true(10 * solved > 9 * PROFILES);
    assert_int_equal(wrong_ones, 0);
}

/** What stands at a load does not depend on which others are asked for. */
TEST_CASE(each_load_alone)
{
    struct made *made = support_room(sizeof *made);
    struct contact_point point[LOADS + 1], alone[2];
    for (size_t n = 0; n < 12; n++) {
        if (!make(made, n))
            continue;
        for (size_t m = 0; m < MODELS; m++) {
            struct model_curve curve = model_support_run(point, models[m], &made->task);
            for (size_t i = n % EVERY; i < curve.count; i += EVERY) {
                struct model_task one = model_task_at(&made->task, made->load + i, 1);
                assert_int_equal(model_support_run(alone, models[m], &one).count, 1);
                for (size_t c = 0; c < CURVES; c++)
                    assert_same_number(alone[0].value[curves[c].quantity], point[i].value[curves[c].quantity], 1e-4);
            }
        }
    }
}

/* One of several scans goes on where it ends, as there, and says so. */
TEST_CASE(carried_on)
{
    struct made *made = support_room(sizeof *made);
    struct contact_point point[LOADS + 1], own[LOADS + 1];
    assert_true(make(made, 0));
    for (size_t m = 0; m + 1 < MODELS; m++) { /* cmy ends at another place */
        struct model_curve alone = model_support_run(own, models[m], &made->task);
        struct model_task task = made->task;
        task.carries_on = true;
        struct model_curve curve = model_support_run(point, models[m], &task);
        assert_in_range(alone.count, 1, LOADS - 1);
        assert_int_equal(curve.count, LOADS);
        assert_int_equal(curve.carried, LOADS - alone.count);
        assert_near(point[LOADS - 1].value[QUANTITY_AREA], CORRECTED_PERSSON_LARGEST_AREA, 0);
        assert_near(point[0].value[QUANTITY_ECR], own[0].value[QUANTITY_ECR], 1e-9);
    }
}
