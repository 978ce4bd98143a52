/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What every model goes through: a curve that is not finite does not exist, and what it took is counted. */
#include "model_support.h"

/** A row says all that tables, charts, `models` and the references say of it. */
TEST_CASE(test_rows_are_whole)
{
    for (size_t m = 0; m < model_count; m++) {
        const struct model_row *row = model_rows[m];
        const char *const texts[] = {row->name,   row->label,   row->family, row->colour, row->equations,
                                     row->source, row->assumes, row->valid,  row->method, row->does};
        for (size_t t = 0; t < sizeof texts / sizeof *texts; t++)
            if (!texts[t] || !texts[t][0])
                fail_msg("row %zu of the models, '%s', leaves text %zu out", m, row->name ? row->name : "", t);
        assert_true(row->run && row->quantities);
        assert_null(strchr(row->label, ','));
        assert_null(strstr(row->valid, "(rms)")); /* how far it may be off is model_errors' to say */
        for (size_t k = 0; k < m; k++) {
            assert_string_not_equal(row->name, model_rows[k]->name);
            assert_string_not_equal(row->label, model_rows[k]->label);
        }
    }
}

/* B = 0.14 exp(23 S_y/E') is beyond double for a yield strength of a hundred times the modulus; asperities so sharp
 * that they yield all the same have no area then. */
TEST_CASE(test_numbers_beyond_double)
{
    static const double loads[] = {1e-8, 1e-6, 1e-4, 1e-2, 1e4};
    const struct asperities surface[] = {model_support_asperities(1e-12, 1e-2, 1e9),
                                         model_support_asperities(1e30, 1e40, 1e51)};
    for (int sharp = 0; sharp < 2; sharp++) {
        struct contact_point points[6];
        struct material tin = *material_find("tin");
        tin.yield_strength_Pa = sharp ? 4e12 : 14e6;
        const struct material_pair pair = material_pair(&tin, MATERIAL_COUNTERFACE_RIGID, NULL);
        struct model_task task = model_support_task(NULL, &pair, loads, 5);
        task.asperities = &surface[sharp];
        struct model_curve curve = model_support_run(points, "jg", &task);
        assert_true(curve.exists == !sharp && curve.overflows == sharp && (sharp ? curve.count == 0 : curve.count > 1));
    }
}

static size_t next_below(uint64_t *seed, size_t count)
{
    return (size_t)(support_uniform(seed) * (double)count);
}

/** Is every quantity of the point unknown, but for those? */
static void assert_nothing(const struct contact_point *point, unsigned but_for)
{
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if (!(but_for & QUANTITY_BIT(q)) && !isnan(point->value[q]))
            fail_msg("%s is %g", quantity_rows[q].name, point->value[q]);
}

enum { HARMONICS_MOST = 60, HEIGHTS_MOST = 90, TASKS = 300 };

/** Spectra of any law, constant ones, single waves, none; with and without asperities and heights; any loads and
 * quantities: every model answers, or says that it does not. */
TEST_CASE(test_any_task)
{
    static const struct transfer_curve solved = {
        2, {-12, -4}, {{-10, -11, -8}, {-2, -12, -14}}}; /* of a map, straight in logarithms */
    const struct transfer transfer = {.curve = {solved, solved}};
    uint64_t seed = 20;
    struct material_pair pair = model_support_tin();
    size_t existing[64] = {0};
    for (int t = 0; t < TASKS; t++) {
        double load[MODEL_LOADS], gamma = 2 * support_uniform(&seed), size = pow(10, 4 * support_uniform(&seed) - 3);
        size_t count = 1 + next_below(&seed, HARMONICS_MOST), loads = 1 + next_below(&seed, MODEL_LOADS);
        struct spectrum spectrum = model_support_law(3e-4, size, gamma, count);
        if (t % 7 == 0)
            for (size_t i = 0; i < count; i++)
                spectrum.amplitude_m[i] = t % 14 == 0 && i != count / 2 ? 0 : 1e-7; /* one wave, or all alike */
        if (t % 29 == 0)
            memset(spectrum.amplitude_m, 0, count * sizeof(double));
        spectrum.has_nyquist = t % 3 == 0;
        struct roughness roughness = {0};
        struct asperities asperities;
        struct status none = {0};
        roughness_from_spectrum(&roughness, &spectrum);
        bool rough = roughness_asperities(&asperities, &roughness, &none) == STATUS_OK && t % 5 != 0;
        double row[HEIGHTS_MOST];
        size_t points = next_below(&seed, HEIGHTS_MOST + 1);
        for (size_t i = 0; i < points; i++)
            row[i] = 1e-6 * support_uniform(&seed);
        struct strip_rows rows = {row, 1, points, 1e-6, t % 2, NULL, 0};
        struct strip strip = {
            .own = {.count = 3, .logit = {-4, -1, 2}, .value = {{-9, 1, 2}, {-5, 0, 1}, {-3, -2, -1}}},
            .surrogate[0] = {.count = 1, .logit = {-1}, .value = {{-6, 0, 1}}},
            .surrogates = 1};
        model_support_loads(load, loads, pow(10, -8 + 4 * support_uniform(&seed)),
                            pow(10, -3 + 4 * support_uniform(&seed)));
        struct model_task task = model_support_task(&spectrum, &pair, load, loads);
        task.asperities = rough ? &asperities : NULL;
        task.wanted = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) |
                      (MODEL_EVERYTHING & (unsigned)next_below(&seed, 1u << QUANTITY_COUNT));
        task.tolerance = t % 2 ? 1e-4 : 1e-8;
        task.sinusoid_fit = t % 4 == 0 ? SINUSOID_FIT_NUMERIC : SINUSOID_FIT_THESIS;
        task.hardness_Pa = pow(10, 6 + 3 * support_uniform(&seed));
        task.transfer = t % 2 ? &transfer : NULL;
        if (points > 1) {
            task.strip = &strip;
            task.bearing = model_support_bearing(&rows);
        }
        for (size_t m = 0; m < model_count; m++) {
            struct contact_point out[MODEL_LOADS + 1];
            struct model_curve curve = model_support_run(out, model_rows[m]->name, &task);
            existing[m] += curve.exists;
            for (size_t i = 0; i < curve.count; i++)
                assert_nothing(&out[i], model_rows[m]->quantities);
            assert_nothing(&curve.full, model_rows[m]->quantities);
        }
    }
    for (size_t m = 0; m < model_count; m++)
        assert_true(existing[m] > TASKS / 3);
}

static struct contact_point answered[2], answered_full;

static enum status_code answer(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                               struct status *status)
{
    (void)row;
    (void)task;
    (void)status;
    curve->points[0] = answered[0];
    curve->points[1] = answered[1];
    curve->count = 2;
    curve->full = answered_full;
    curve->full_load = answered_full.value[QUANTITY_LOAD];
    curve->exists = true;
    return STATUS_OK;
}

/** Does the curve of these points exist? */
static bool stands(void)
{
    static const struct model_row row = {.run = answer,
                                         .quantities = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) |
                                                       QUANTITY_BIT(QUANTITY_ECR) | QUANTITY_BIT(QUANTITY_TCR),
                                         .may_be_empty = QUANTITY_BIT(QUANTITY_ECR)};
    static const struct model_task task = {.wanted = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) |
                                                     QUANTITY_BIT(QUANTITY_SEPARATION) | QUANTITY_BIT(QUANTITY_ECR)};
    struct contact_point points[2];
    struct model_curve curve = {.points = points};
    expect_ok(model_run, &curve, &row, &task);
    assert_true(curve.exists == !curve.overflows && curve.count == (curve.exists ? 2 : 0));
    return curve.exists;
}

/* No number may be infinite, wanted or not; what is wanted and always computed has to be there. */
TEST_CASE(test_a_curve_that_leaves_the_numbers)
{
    struct contact_point good = quantity_nothing();
    good.value[QUANTITY_LOAD] = 1e-3;
    good.value[QUANTITY_AREA] = 0.1;
    struct contact_point *const tried[] = {&answered[0], &answered[1], &answered_full};
    for (size_t t = 0; t < 3; t++) {
        answered[0] = answered[1] = answered_full = good;
        assert_true(stands());
        tried[t]->value[QUANTITY_ECR] = INFINITY;
        assert_false(stands());
        tried[t]->value[QUANTITY_ECR] = NAN; /* may be empty */
        tried[t]->value[QUANTITY_TCR_SCALE_DEPENDENT] = -INFINITY;
        assert_false(stands());
        tried[t]->value[QUANTITY_TCR_SCALE_DEPENDENT] = NAN;
        tried[t]->value[QUANTITY_AREA] = NAN;
        assert_false(stands());
    }
    answered_full.value[QUANTITY_LOAD] = answered_full.value[QUANTITY_AREA] = NAN; /* says nothing of full contact */
    answered_full.value[QUANTITY_ECR] = INFINITY;
    assert_true(stands());
}

static enum status_code set_nothing(struct model_curve *curve, const struct model_row *row,
                                    const struct model_task *task, struct status *status)
{
    (void)row;
    (void)status;
    curve->count = task->load_count;
    curve->exists = true;
    return STATUS_OK;
}

/* What a model does not set is not known, whatever the caller's points held before: not 0, which a resistance may be.
 */
TEST_CASE(test_what_is_not_set)
{
    static const struct model_row row = {.run = set_nothing};
    const double loads[] = {1e-4, 1e-3};
    struct model_task task = {.loads = loads, .load_count = 2, .wanted = (1u << QUANTITY_COUNT) - 1};
    struct contact_point points[3] = {0};
    struct model_curve curve = {.points = points};
    expect_ok(model_run, &curve, &row, &task);
    assert_true(curve.exists && curve.count == 2);
    assert_nothing(&points[0], 0);
    assert_nothing(&points[1], 0);
    assert_nothing(&curve.full, 0);
    assert_true(isnan(curve.full_load) && isnan(curve.beta));
}

/* Where nothing is elastic any more, area is P/H; its elastic share is the slope of bearing_area() in ln A_e. */
TEST_CASE(test_area_of_load_and_hardness)
{
    const struct model_row *plastic = model_rows[model_named("strip-plastic")];
    for (double elastic = 1e-4; elastic < 0.9; elastic *= 1.3) {
        const double ratio = 0.02, step = 1e-5;
        const struct material_pair hard = {.effective_modulus_Pa = 1, .hardness_Pa = 1e-3 / ratio},
                                   unknown = {.effective_modulus_Pa = 1, .hardness_Pa = NAN};
        struct contact_point at = quantity_nothing();
        at.value[QUANTITY_LOAD] = 1e-3;
        at.value[QUANTITY_AREA] = bearing_area(elastic, ratio);
        double slope =
            log(bearing_area(elastic * exp(step), ratio) / bearing_area(elastic * exp(-step), ratio)) / (2 * step);
        assert_within(model_elastic_share(plastic, &at, ratio), slope, 1e-8);
        assert_int_equal(model_area_is_pressed(plastic, &at, &hard), at.value[QUANTITY_AREA] < ratio * 1.001);
        assert_false(model_area_is_pressed(plastic->elastic, &at, &hard));
        assert_false(model_area_is_pressed(plastic, &at, &unknown));
        assert_int_equal(model_is_overloaded(plastic->elastic, &at, &hard), at.value[QUANTITY_AREA] < ratio);
        assert_false(model_is_overloaded(plastic->elastic, &at, &unknown));
        assert_within(model_elastic_share(plastic->elastic, &at, ratio), 1, 0);
        assert_within(model_elastic_share(plastic, &at, NAN), 1, 0);
    }
    struct contact_point full = quantity_nothing();
    full.value[QUANTITY_AREA] = 1;
    full.value[QUANTITY_LOAD] = 1;
    assert_false(
        model_area_is_pressed(plastic, &full, &(struct material_pair){.effective_modulus_Pa = 1, .hardness_Pa = 1}));
}

/* What a model says of itself, and of scans that hold few of their longest waves; only of open ends, and only where it
 * says something. */
TEST_CASE(test_few_longest_waves)
{
    double amplitude_m[40] = {[1] = 1e-6}; /* two waves */
    const struct spectrum spectrum = {.amplitude_m = amplitude_m, .count = 40, .length_m = 1e-3};
    struct model_task task = {.spectrum = &spectrum, .open = true};
    assert_near(model_task_reach(&task).longest_waves, 2, 1e-12);
    task.open = false;
    assert_within(model_task_reach(&task).longest_waves, 0, 0);
    static const struct {
        const char *model;
        enum quantity quantity;
        double waves, own, few; /* the model's own error, and that of so few waves */
    } cases[] = {{"strip", QUANTITY_ECR, 2, 0.54, 1.25},       {"strip", QUANTITY_AREA, 1, 0.37, 2.5},
                 {"strip", QUANTITY_SEPARATION, 2.5, 0.48, 1}, {"strip", QUANTITY_SEPARATION, 0, 0.48, 1},
                 {"gw", QUANTITY_ECR, 1, 0.87, 2.5},           {"direct", QUANTITY_ECR, 1, 0, 1},
                 {"strip", QUANTITY_SPOT_RADIUS, 1, 0, 1}};
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        double sd = model_surface_sd(model_rows[model_named(cases[c].model)], cases[c].quantity,
                                     (struct scans_reach){.longest_waves = cases[c].waves});
        assert_near(sd, hypot(cases[c].own, 1.3 * log(cases[c].few)), 1e-14);
    }
}

/* A model's error of a quantity is that of the area, gap or resistance that it follows. */
TEST_CASE(test_an_error_is_of_what_the_quantity_follows)
{
    static const struct {
        enum quantity quantity;
        int column; /* -1: none */
    } cases[] = {{QUANTITY_AREA, 0},      {QUANTITY_SEPARATION, 1}, {QUANTITY_ADJUSTED, 1},
                 {QUANTITY_MEAN_GAP, 1},  {QUANTITY_GAP, 1},        {QUANTITY_ECR, 2},
                 {QUANTITY_TCR, 2},       {QUANTITY_JOINT, 2},      {QUANTITY_JOINT_ECR, 2},
                 {QUANTITY_SHAPE_ECR, 2}, {QUANTITY_LOAD, -1},      {QUANTITY_SPOT_DENSITY, -1}};
    const struct model_row *strip = model_rows[model_named("strip")];
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const int c = cases[i].column;
        static const double sd[] = {0.37, 0.48, 0.54};
        assert_within(model_sd(strip, cases[i].quantity, false), c < 0 ? 0 : sd[c], 0);
    }
}
