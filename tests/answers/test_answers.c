/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The load that meets a target, against reference forces, the model itself, scans solved one by one here, and bands;
 * limits. */
#include "answers/answers.h"
#include "joint/joint.h"
#include "members/surface.h"
#include "support.h"

enum { HARMONICS = 60, LOADS = 121, SCANS = 3, TARGETS_MOST = 8 };

/* A tin surface; with `scans` of them, of its own heights each. */
static struct {
    double amplitude_m[SCANS][HARMONICS], loads[LOADS];
    struct member parts[SCANS];
    double weights[SCANS];
    struct surface_record record;
    struct model_task task;
    struct scene scene;
    struct scene_asked targets[TARGETS_MOST];
    struct plan plan;
} f;

static int drop(void **state)
{
    (void)state;
    for (size_t m = 0; m < model_count; m++) {
        if (f.record.summary.models && f.record.summary.models[m]) {
            free(f.record.summary.models[m]->estimates);
            free(f.record.summary.models[m]);
        }
        if (f.record.bands)
            free(f.record.bands[m]);
    }
    free(f.record.summary.models);
    free(f.record.summary.answers);
    free(f.record.summary.limits);
    free(f.record.curves);
    free(f.record.bands);
    memset(&f, 0, sizeof f);
    return 0;
}

static void make(size_t scans)
{
    (void)drop(NULL);
    f.scene = (struct scene){.targets = f.targets, .nominal_area_m2 = 1e-6};
    struct surface_summary *summary = &f.record.summary;
    summary->pair = material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    summary->pair.hardness_Pa = NAN; /* so that physics bounds nothing */
    f.record.curves = calloc(model_count, sizeof *f.record.curves);
    f.record.bands = calloc(model_count, sizeof *f.record.bands);
    assert_true(f.record.curves && f.record.bands);
    f.plan = (struct plan){.models = UINT64_MAX, .running = (1u << EFFECT_COUNT) - 1};
    for (size_t s = 0; s < SCANS; s++) {
        double size = 1 + 0.3 * (double)(s * s);
        struct member *part = &f.parts[s];
        for (int n = 1; n <= HARMONICS; n++)
            f.amplitude_m[s][n - 1] = 3e-7 * size * pow(n, -1.4 - 0.15 * (double)s) * (1 + 0.5 * sin(7.0 * n));
        part->scan = s;
        part->spectrum = (struct spectrum){.amplitude_m = f.amplitude_m[s], .count = HARMONICS, .length_m = 3e-4};
        part->roughness = (struct roughness){.m0_m2 = 4e-14 * size * size, .m2 = 2e-3 * size * size, .m4_per_m2 = 5e8};
        f.weights[s] = 1;
    }
    summary->asperities =
        (struct asperities){.density_per_m2 = 1e10, .radius_m = 8e-6, .sigma_s_m = 2e-7, .sigma_m = 2.1e-7};
    if (scans > 1)
        f.record.ensemble =
            (struct ensemble){.members = f.parts, .count = scans, .scan_weight = f.weights, .scan_count = scans};
    for (size_t i = 0; i < LOADS; i++)
        f.loads[i] = 1e-9 * pow(1e7, (double)i / (LOADS - 1));
    f.task = (struct model_task){.spectrum = &f.parts[0].spectrum,
                                 .asperities = &summary->asperities,
                                 .pair = &summary->pair,
                                 .loads = f.loads,
                                 .load_count = LOADS,
                                 .wanted = quantity_wanted((1u << EFFECT_COUNT) - 1),
                                 .tolerance = 1e-10,
                                 .hardness_Pa = 2.8 * summary->pair.yield_strength_Pa};
    for (size_t m = 0; m < model_count; m++)
        f.record.curves[m].exists = true;
}

/* Adds a target; `value` of the quantity. */
static size_t ask(const char *name, double value)
{
    struct scene_asked *target = &f.targets[f.scene.target_count];
    assert_true(f.scene.target_count < TARGETS_MOST);
    *target = (struct scene_asked){.value = value};
    target->quantity = quantity_of_key(&target->how, name, 0);
    assert_non_null(target->how);
    return f.scene.target_count++;
}

static void find(void)
{
    expect_ok(answers_find, &f.record, &f.scene, &f.plan, &f.task);
}

static const struct answer *answer(size_t target, const char *model)
{
    return &f.record.summary.answers[target * model_count + model_named(model)];
}

static void assert_note(const char *expected, const struct answer *given, double area_m2)
{
    struct text *note = support_text();
    answers_note(note, given, area_m2);
    assert_string_equal(text_string(note), expected);
}

/* A quantity of a model at one load, straight from its row; beyond full contact that of full contact. */
static double value_at(const struct model_task *task, const char *model, double load, enum quantity quantity)
{
    struct contact_point points[2];
    struct model_curve curve = {.points = points};
    struct model_task one = model_task_at(task, &load, 1);
    expect_ok(model_run, &curve, model_rows[model_named(model)], &one);
    return curve.count > 0 ? points[0].value[quantity] : NAN;
}

/* With a measured factor of 0.6 the load for a resistance is that at which the model has 0.6 times it. This holds only
 * for the model and the quantity that were measured. */
TEST_CASE(a_measured_factor_is_carried)
{
    make(1);
    size_t asked = ask("ecr", 1e-11), smaller = ask("ecr", 0.6e-11), area = ask("area", 0.01);
    find();
    double carried = answer(smaller, "cmy")->load, other = answer(asked, "gw")->load,
           of_area = answer(area, "cmy")->load;
    f.record.summary.carried = 0.6;
    f.record.summary.carried_model = model_named("cmy");
    f.record.summary.carried_quantity = QUANTITY_ECR;
    find();
    assert_near(answer(asked, "cmy")->load, carried, 0);
    assert_near(answer(asked, "gw")->load, other, 0);
    assert_near(answer(area, "cmy")->load, of_area, 0);
}

/* Force and number of spots at which tin reaches a resistance or a conductance, against reference values. */
TEST_CASE(the_reference_forces)
{
    struct table table = table_read("golden/models/answers_tin_cmy.csv");
    double wave_m = sqrt(2 * 4e-13);
    make(1);
    /* one wave of m0 = 4e-13 and m2 = 2.5e-3 */
    f.parts[0].spectrum = (struct spectrum){&wave_m, 1, 2 * M_PI * sqrt(4e-13 / 2.5e-3), false};
    f.task.tolerance = 1e-13;
    for (size_t i = 0; i < table.rows; i++) {
        double area_m2 = table_number(&table, i, "nominal_area_m2"), target_ohm = table_number(&table, i, "target_ohm");
        f.scene.target_count = 0;
        size_t ecr = ask("ecr", target_ohm * area_m2),
               h = ask("conductance", 1 / table_number(&table, i, "h_W_per_m2K"));
        find();
        double to_N = f.record.summary.pair.effective_modulus_Pa * area_m2;
        assert_int_equal(answer(ecr, "cmy")->kind, ANSWER_LOAD);
        assert_near(answer(ecr, "cmy")->load * to_N, table_number(&table, i, "force_N"), 1e-10);
        assert_near(answer(h, "cmy")->load * to_N, table_number(&table, i, "force_N"), 1e-10);
        double spots = (answer(ecr, "cmy"))->spots_per_m2 * area_m2;
        assert_near(spots, table_number(&table, i, "spots"), 1e-10);
        if (target_ohm == 1e-3) {
            assert_within(answer(ecr, "cmy")->load * to_N, 40.5e-3, 0.05e-3);
            assert_note("too few spots for statistics (9.1)", answer(ecr, "cmy"), area_m2);
        } else if (target_ohm == 3e-4) { /* 26 spots */
            assert_note("", answer(ecr, "cmy"), area_m2);
        }
    }
}

/* The quantity at the load found is the target, in every model. */
TEST_CASE(the_target_is_met)
{
    size_t met = 0;
    for (size_t m = 0; m < model_count; m++) {
        const char *model = model_rows[m]->name;
        make(1);
        double loads[] = {2.1e-8, 3.3e-6, 8.7e-5};
        for (int i = 0; i < 3; i++) {
            double ecr = value_at(&f.task, model, loads[i], QUANTITY_ECR);
            double tcr = value_at(&f.task, model, loads[i], QUANTITY_TCR);
            double area = value_at(&f.task, model, loads[i], QUANTITY_AREA);
            f.scene.target_count = 0;
            const struct {
                size_t target;
                double value;
                enum quantity quantity;
            } asked[] = {{ask("ecr", ecr), ecr, QUANTITY_ECR},
                         {ask("tcr", tcr), tcr, QUANTITY_TCR},
                         {ask("conductance", tcr), tcr, QUANTITY_TCR},
                         {ask("area", area), area, QUANTITY_AREA}};
            find();
            for (int k = 0; k < 4; k++) {
                const struct answer *found = answer(asked[k].target, model);
                if (!(asked[k].value > 0) || (k == 3 && area >= 1))
                    continue; /* the contact is complete */
                if (found->kind != ANSWER_LOAD)
                    fail_msg("%s has no load for target %d", model, k);
                assert_near(value_at(&f.task, model, found->load, asked[k].quantity), asked[k].value, 1e-8);
                assert_near(found->load, loads[i], 1e-7);
                assert_true(isnan(found->low) && isnan(found->high));
                met++;
            }
        }
    }
    assert_true(met > 80);
}

/* Targets met at the first load, met nowhere, and in a quantity that the model lacks. */
TEST_CASE(no_load_within_the_list)
{
    make(1);
    double first = value_at(&f.task, "gw", f.loads[0], QUANTITY_ECR);
    size_t light = ask("ecr", first * 1.01), far = ask("area", 0.9), just = ask("ecr", first * 0.99);
    f.record.curves[model_named("jg")].exists = false;
    find();
    assert_int_equal(answer(light, "gw")->kind, ANSWER_LIGHTEST);
    assert_true(answer(light, "gw")->load == f.loads[0]);
    assert_int_equal(answer(just, "gw")->kind, ANSWER_LOAD);
    assert_int_equal(answer(far, "corrected-persson")->kind, ANSWER_NOT_REACHED);
    assert_true(answer(far, "corrected-persson")->load == f.loads[LOADS - 1]);
    assert_int_equal(answer(far, "jg")->kind, ANSWER_NONE);
    assert_note("not reached up to P/(A_n E') = 0.01; above the hardness", answer(far, "corrected-persson"), NAN);
    assert_note("already at the lightest load; above the hardness", answer(light, "gw"), NAN);
    assert_note("no value", answer(far, "jg"), NAN);
    f.task.load_count = 1; /* one load: met there, or not */
    find();
    assert_int_equal(answer(light, "gw")->kind, ANSWER_LIGHTEST);
    assert_int_equal(answer(just, "gw")->kind, ANSWER_NOT_REACHED);
}

/* Looking up loads on a known curve gives the same answers as running the model, also at its ends. */
TEST_CASE(known_loads)
{
    make(1);
    size_t m = model_named("corrected-persson");
    static struct contact_point points[LOADS + 1];
    struct model_curve known = {.points = points};
    expect_ok(model_run, &known, model_rows[m], &f.task);
    assert_int_equal(known.count, LOADS);
    double first = points[0].value[QUANTITY_AREA], last = points[LOADS - 1].value[QUANTITY_AREA];
    size_t asked[] = {ask("area", 0.99 * first), ask("area", sqrt(first * last)), ask("area", 1.01 * last)};
    f.task.hardness_Pa = 2 * f.loads[LOADS - 1] / last * f.task.pair->effective_modulus_Pa;
    struct answer before[3];
    find();
    for (int k = 0; k < 3; k++)
        before[k] = *answer(asked[k], "corrected-persson");
    assert_false(before[2].above_hardness);
    f.record.curves[m] = known;
    find();
    for (int k = 0; k < 3; k++) {
        const struct answer *now = answer(asked[k], "corrected-persson");
        assert_true(now->kind == before[k].kind && now->above_hardness == before[k].above_hardness);
        assert_near(now->load, before[k].load, 1e-9);
    }
}

/* The corrected theory ends at A/A_n = 0.97: a target counts as met there within one percent. */
TEST_CASE(where_the_numbers_end)
{
    make(1);
    double low = log(1e-9), high = log(1);
    for (int i = 0; i < 60; i++) {
        double middle = (low + high) / 2;
        *(isnan(value_at(&f.task, "corrected-persson", exp(middle), QUANTITY_ECR)) ? &high : &low) = middle;
    }
    double last = value_at(&f.task, "corrected-persson", exp(low), QUANTITY_ECR);
    assert_near(value_at(&f.task, "corrected-persson", exp(low), QUANTITY_AREA), 0.97, 1e-9);
    for (size_t i = 0; i < LOADS; i++)
        f.loads[i] = 1e-9 * pow(1.05 * exp(low) / 1e-9, (double)i / (LOADS - 1));
    size_t within = ask("ecr", last * 0.991), beyond = ask("ecr", last * 0.989), far = ask("ecr", last * 0.92);
    find();
    assert_int_equal(answer(within, "corrected-persson")->kind, ANSWER_LOAD);
    assert_near(answer(within, "corrected-persson")->load, exp(low), 1e-8);
    assert_int_equal(answer(beyond, "corrected-persson")->kind, ANSWER_NOT_REACHED);
    assert_int_equal(answer(far, "corrected-persson")->kind, ANSWER_NOT_REACHED);
    assert_near(answer(far, "corrected-persson")->load, exp(low), 1e-8);
}

/* Loads outside a model's range are marked: for GW just above A/A_n = 0.1, not just below. */
TEST_CASE(the_mark)
{
    make(1);
    size_t below = ask("area", 0.0999), above = ask("area", 0.1001);
    for (size_t i = 0; i < LOADS; i++)
        f.loads[i] = 1e-9 * pow(1e10, (double)i / (LOADS - 1));
    find();
    assert_int_equal(answer(above, "gw")->kind, ANSWER_LOAD);
    assert_false(answer(below, "gw")->invalid);
    assert_true(answer(above, "gw")->invalid);
}

/* With several scans the geometric mean of their values meets the target, even if one scan alone does not reach it. */
TEST_CASE(several_scans_meet_it_together)
{
    make(SCANS);
    f.task.load_count = 80; /* short of the law's end */
    struct asperities asperities;
    double at_end = 0; /* the greatest, which one scan alone has */
    for (size_t s = 0; s < SCANS; s++) {
        struct model_task own = member_task(&asperities, &f.parts[s], &f.task);
        at_end =
            fmax(at_end, value_at(&own, "corrected-persson-plastic", f.loads[f.task.load_count - 1], QUANTITY_ECR));
    }
    size_t target = ask("ecr", at_end * 0.99);
    find();
    const struct answer *found = answer(target, "corrected-persson-plastic");
    assert_int_equal(found->kind, ANSWER_LOAD);
    double ln = 0;
    for (size_t s = 0; s < SCANS; s++) {
        struct model_task own = member_task(&asperities, &f.parts[s], &f.task);
        ln += log(value_at(&own, "corrected-persson-plastic", found->load, QUANTITY_ECR)) / SCANS;
    }
    assert_near(exp(ln), at_end * 0.99, 1e-8);
}

/* The model runs within its validity, so that it may count spots. */
static void let_count(const char *model)
{
    struct curve_summary *summary = surface_model_room(&f.record.summary, model_named(model));
    assert_non_null(summary);
    *summary = (struct curve_summary){.exists = true, .invalid_load = NAN};
}

/* Spots per area of a model at a load; of several scans the mean, of the textbook the surface's. */
static double spots_at(size_t scans, const char *model, double load)
{
    double sum = 0;
    scans = model_rows[model_named(model)]->textbook ? 1 : scans;
    for (size_t s = 0; s < scans; s++) {
        struct asperities asperities;
        struct status status = {0};
        struct contact_spots spots;
        struct model_task own = scans > 1 ? member_task(&asperities, &f.parts[s], &f.task) : f.task,
                          one = model_task_at(&own, &load, 1);
        const struct model_row *row = model_rows[model_named(model)];
        assert_int_equal(row->spots(&spots, row, &one, &status), STATUS_OK);
        sum += spots.density_per_m2 / (double)scans;
    }
    return sum;
}

/* Whichever model counts them: spots are counted at the answer's load, not at the load that the counting model would
 * need, and the same rule says whether they are too few. The textbook model counts where it is valid; otherwise an
 * elastic model does not count for a plastic one. */
TEST_CASE(spots_are_those_at_the_answers_load)
{
    for (size_t scans = 1; scans <= SCANS; scans += SCANS - 1) {
        make(scans);
        f.plan.models = MODEL_BIT(model_named("corrected-persson-plastic")) |
                        MODEL_BIT(model_named("corrected-persson")) | MODEL_BIT(model_named("cmy")) |
                        MODEL_BIT(model_named("gw"));
        let_count("cmy");
        let_count("gw");
        size_t target = ask("ecr", value_at(&f.task, "corrected-persson-plastic", 1e-6, QUANTITY_ECR));
        find();
        const struct answer *plastic = answer(target, "corrected-persson-plastic"), *cmy = answer(target, "cmy"),
                            *elastic = answer(target, "corrected-persson");
        assert_int_equal(plastic->kind, ANSWER_LOAD);
        assert_int_equal(plastic->counted_by, model_named("cmy"));
        assert_near(plastic->spots_per_m2, spots_at(scans, "cmy", plastic->load), 1e-12);
        assert_near(cmy->spots_per_m2, spots_at(scans, "cmy", cmy->load), 1e-12);
        assert_true(fabs(log(cmy->spots_per_m2 / plastic->spots_per_m2)) > 0.1);
        assert_int_equal(elastic->counted_by, model_named("cmy"));
        assert_near(elastic->spots_per_m2, spots_at(scans, "cmy", elastic->load), 1e-12);
        assert_note("too few spots for statistics (9.5)", plastic, 9.5 / plastic->spots_per_m2);
        assert_note("", plastic, 10.5 / plastic->spots_per_m2);
        surface_model_room(&f.record.summary, model_named("cmy"))->invalid_load = f.loads[0];
        find();
        assert_true(isnan(answer(target, "corrected-persson-plastic")->spots_per_m2));
        elastic = answer(target, "corrected-persson");
        assert_int_equal(elastic->counted_by, model_named("gw"));
        assert_near(elastic->spots_per_m2, spots_at(scans, "gw", elastic->load), 1e-12);
    }
}

/* A scan whose spots are not known is left out of the mean, not counted as 0. */
TEST_CASE(spots_of_a_scan_that_has_none_known_are_not_zero)
{
    make(SCANS);
    f.plan.models = MODEL_BIT(model_named("corrected-persson")) | MODEL_BIT(model_named("gw"));
    let_count("gw");
    size_t target = ask("ecr", value_at(&f.task, "corrected-persson", 1e-6, QUANTITY_ECR));
    f.parts[0].roughness.m2 = f.parts[0].roughness.m0_m2 = NAN; /* of its asperities, not the spectrum */
    find();
    const struct answer *elastic = answer(target, "corrected-persson");
    assert_int_equal(elastic->counted_by, model_named("gw"));
    double others = 0;
    for (size_t s = 1; s < SCANS; s++) {
        struct asperities asperities;
        struct status status = {0};
        struct contact_spots spots;
        struct model_task own = member_task(&asperities, &f.parts[s], &f.task),
                          one = model_task_at(&own, &elastic->load, 1);
        assert_int_equal(model_rows[elastic->counted_by]->spots(&spots, model_rows[elastic->counted_by], &one, &status),
                         STATUS_OK);
        others += spots.density_per_m2 / (SCANS - 1);
    }
    assert_near(elastic->spots_per_m2, others, 1e-12);
}

/* A plated surface with a film; its resistance is not known from A/A_n = 0.1 on. */
static void plate(void)
{
    f.scene.joint = joint_default();
    f.scene.joint.film_ohm_m2 = 1e-12;
    f.scene.joint.plating_thickness_m = 1e-6;
    f.scene.joint.plating_ohm_m = 2e-8;
}

/* Loads at which JG's area is 0.1, and 1. */
static void jg_loads(double *tenth, double *full, const struct model_task *task)
{
    struct contact_point points[LOADS + 1];
    struct model_curve curve = {.points = points};
    double low = log(1e-9), high = log(1);
    expect_ok(model_run, &curve, model_rows[model_named("jg")], task);
    *full = curve.full_load;
    for (int i = 0; i < 60; i++) {
        double middle = (low + high) / 2;
        *(value_at(task, "jg", exp(middle), QUANTITY_AREA) < 0.1 ? &low : &high) = middle;
    }
    *tenth = exp(low);
}

/* At full contact only the film has a resistance. */
TEST_CASE(full_contact_meets_every_resistance_above_the_film)
{
    make(1);
    plate();
    double full, end;
    jg_loads(&end, &full, &f.task);
    assert_true(full < f.loads[LOADS - 1] && end < 0.5 * full);
    size_t ecr = ask("ecr", 1e-20), tcr = ask("tcr", 1e-20); /* the model has numbers up to full contact */
    size_t above = ask("ecr", 1.01e-12), below = ask("ecr", 0.99e-12), heat = ask("conductance", 1e15);
    f.targets[above].quantity = f.targets[below].quantity = QUANTITY_JOINT_ECR;
    f.targets[heat].quantity = QUANTITY_JOINT;
    find();
    const size_t met[] = {ecr, tcr, above, heat};
    for (int k = 0; k < 4; k++) {
        const struct answer *found = answer(met[k], "jg");
        assert_int_equal(found->kind, ANSWER_LOAD);
        assert_true(isnan(found->low) && isnan(found->high) && found->invalid);
        assert_near(found->load, full, found->most ? 1e-9 : 1e-4); /* next to nothing just before it */
    }
    assert_true(answer(above, "jg")->most);
    assert_note("at the latest; beyond the model's validity", answer(above, "jg"), NAN);
    assert_int_equal(answer(below, "jg")->kind, ANSWER_NOT_REACHED);
    assert_true(answer(below, "jg")->load == f.loads[LOADS - 1]);
    assert_int_equal(answer(below, "corrected-persson-plastic")->kind, ANSWER_NOT_REACHED); /* which never closes */
    while (f.task.load_count > 0 && f.loads[f.task.load_count - 1] >= full)
        f.task.load_count--;
    find();
    assert_int_equal(answer(above, "jg")->kind, ANSWER_NOT_REACHED);
    assert_near(answer(above, "jg")->load, end, 1e-6);
}

/* One spot of area P/H conducts the least that P can: no resistance below its own needs more load, whatever few spots
 * a model counts. A limit has that number too. */
TEST_CASE(a_single_spot_needs_the_most_load)
{
    make(1);
    const struct material_pair *pair = &f.record.summary.pair;
    const double hardness_Pa = f.record.summary.pair.hardness_Pa = f.task.hardness_Pa,
                 area_m2 = f.scene.nominal_area_m2;
    const size_t m = model_named("cmy");
    struct contact_point points[LOADS + 1];
    struct scene_asked limit = {.quantity = QUANTITY_ECR, .value = 1, .is_upper = true};
    f.scene.limits = &limit;
    f.scene.limit_count = 1;
    f.plan.models = MODEL_BIT(m);
    f.task.load_count = 3 * LOADS / 4;
    f.task.operating_place = 1;
    f.record.curves[m] = (struct model_curve){.points = points};
    expect_ok(model_run, &f.record.curves[m], model_rows[m], &f.task);
    const double load[] = {1e-8, 1e-4}; /* of less than a spot, and of more */
    size_t target[2];
    for (int k = 0; k < 2; k++) {
        const double radius_m = sqrt(material_pair_pressure(pair, load[k]) * area_m2 / (M_PI * hardness_Pa)),
                     single = pair->resistivity_ohm_m * area_m2 / (2 * radius_m),
                     own = value_at(&f.task, "cmy", load[k], QUANTITY_ECR);
        assert_true(k ? own < single : own > 1.02 * single);
        target[k] = ask("ecr", fmin(own, single));
    }
    find();
    for (int k = 0; k < 2; k++) {
        assert_int_equal(answer(target[k], "cmy")->kind, ANSWER_LOAD);
        assert_near(answer(target[k], "cmy")->load, load[k], 1e-8);
        assert_true(answer(target[k], "cmy")->most == (k == 0));
    }
    const double radius_m = sqrt(material_pair_pressure(pair, f.loads[0]) * area_m2 / (M_PI * hardness_Pa));
    assert_near(f.record.summary.limits[0].value, pair->resistivity_ohm_m * area_m2 / (2 * radius_m), 1e-12);
    assert_int_equal(f.record.summary.limits[0].verdict, LIMIT_MET);
    limit.value = 0.9 * f.record.summary.limits[0].value; /* it may be less than that of a spot */
    find();
    assert_int_equal(f.record.summary.limits[0].verdict, LIMIT_UNDECIDED);
}

/* ln of band end over curve; grows with load, linearly in ln P. */
static double widening(double load)
{
    return 0.2 + 0.02 * log(load / 1e-9);
}

/* One scan: the interval ends where the ends of the band meet the target. */
TEST_CASE(intervals_of_a_band)
{
    make(1);
    size_t m = model_named("cmy");
    static struct contact_point points[LOADS];
    f.record.band_count = LOADS;
    f.record.curves[m].points = points;
    f.record.curves[m].count = LOADS;
    f.record.bands[m] = ensemble_band_make(f.loads, LOADS);
    assert_non_null(f.record.bands[m]);
    static const enum quantity held[] = {QUANTITY_ECR, QUANTITY_AREA};
    for (size_t i = 0; i < LOADS; i++) {
        points[i] = (struct contact_point){.value[QUANTITY_LOAD] = f.loads[i]};
        points[i].value[QUANTITY_AREA] = value_at(&f.task, "cmy", f.loads[i], QUANTITY_AREA);
        points[i].value[QUANTITY_ECR] = value_at(&f.task, "cmy", f.loads[i], QUANTITY_ECR);
        for (int k = 0; k < 2; k++)
            for (int side = 0; side < 2; side++)
                f.record.bands[m][i].mean[held[k]][side] = value_at(&f.task, "cmy", f.loads[i], held[k]) *
                                                           exp(side ? widening(f.loads[i]) : -widening(f.loads[i]));
    }
    double ecr = value_at(&f.task, "cmy", 1.23e-6, QUANTITY_ECR),
           area = value_at(&f.task, "cmy", 1.23e-6, QUANTITY_AREA);
    size_t resistance = ask("ecr", ecr), share = ask("area", area);
    size_t light = ask("ecr", 1.1 * value_at(&f.task, "cmy", f.loads[1], QUANTITY_ECR));
    find();
    const struct answer *of_ecr = answer(resistance, "cmy"), *of_area = answer(share, "cmy");
    assert_near(of_ecr->load, 1.23e-6, 1e-9);
    assert_near(value_at(&f.task, "cmy", of_ecr->low, QUANTITY_ECR) * exp(-widening(of_ecr->low)), ecr, 1e-8);
    assert_near(value_at(&f.task, "cmy", of_ecr->high, QUANTITY_ECR) * exp(widening(of_ecr->high)), ecr, 1e-8);
    assert_near(of_area->low * exp(widening(of_area->low)), 1.23e-6, 1e-9); /* the area is P/H */
    assert_near(of_area->high * exp(-widening(of_area->high)), 1.23e-6, 1e-9);
    assert_true(isnan(answer(light, "cmy")->low)); /* below the first load */
    assert_true(answer(light, "cmy")->high > answer(light, "cmy")->load);
}

/** A joint with grease of 0.8 W/(m K) and a bond line, its curve of one model, and what is asked of it. */
static void grease(struct contact_point points[LOADS + 1], size_t m, double bond_line_m)
{
    f.scene.joint = (struct joint){.fill = JOINT_MEDIUM, .conductivity_W_per_mK = 0.8, .bond_line_m = bond_line_m};
    f.plan.models = MODEL_BIT(m);
    f.plan.running = EFFECT_BIT(EFFECT_GAP) | EFFECT_BIT(EFFECT_PLASTICITY) | EFFECT_BIT(EFFECT_ELECTRICAL) |
                     EFFECT_BIT(EFFECT_THERMAL);
    struct model_curve *curve = &f.record.curves[m];
    *curve = (struct model_curve){.points = points};
    expect_ok(model_run, curve, model_rows[m], &f.task);
    const struct joint_task joint = surface_joint(&f.record, &f.scene, &f.plan, &f.task);
    joint_hold(points, curve->count, &joint);
    expect_ok(joint_curve, curve, model_rows[m], &f.task, &joint);
    f.scene.target_count = 0;
}

static size_t ask_joint(double value)
{
    size_t target = ask("conductance", value);
    f.targets[target].quantity = QUANTITY_JOINT;
    return target;
}

/** Grease thicker than the gap carries all heat: every load gives k/t and none gives more. No spots are counted, and
 * limits are judged by k/t. */
TEST_CASE(a_bond_line_thicker_than_the_gap)
{
    static struct contact_point points[LOADS + 1];
    struct scene_asked limit[4] = {{.quantity = QUANTITY_JOINT, .value = 3.1e4},
                                   {.quantity = QUANTITY_JOINT, .value = 3.3e4},
                                   {.quantity = QUANTITY_ECR, .value = 1e9, .is_upper = true},
                                   {.quantity = QUANTITY_AREA, .value = 1e-9}};
    static const enum limit_verdict verdicts[] = {LIMIT_MET, LIMIT_MISSED, LIMIT_MISSED, LIMIT_MISSED};
    for (size_t m = 0; m < model_count; m++) {
        const char *name = model_rows[m]->name;
        if (model_rows[m]->uses_strip || model_rows[m]->uses_map)
            continue;
        make(1);
        f.scene.limits = limit;
        f.scene.limit_count = 4;
        grease(points, m, 25e-6);
        size_t above = ask_joint(5e5), just = ask_joint(3.201e4), below = ask_joint(3.199e4), ecr = ask("ecr", 1),
               area = ask("area", 1e-9);
        find();
        const size_t none[] = {above, just, ecr, area};
        for (int k = 0; k < 4; k++) {
            const struct answer *found = answer(none[k], name);
            if (found->kind != ANSWER_NONE || !found->held || !isnan(found->load) || !isnan(found->spots_per_m2))
                fail_msg("%s, target %d: kind %d, %g", name, k, (int)found->kind, found->load);
            assert_note("no load reaches it: the gap stays at the bond line of the filler", found, 1e-6);
        }
        assert_int_equal(answer(below, name)->kind, ANSWER_LIGHTEST);
        assert_true(isnan(answer(below, name)->spots_per_m2));
        assert_note("already at the lightest load", answer(below, name), 1e-6);
        for (int k = 0; k < 4; k++)
            if (f.record.summary.limits[k].verdict != verdicts[k])
                fail_msg("%s, limit %d: %d", name, k, (int)f.record.summary.limits[k].verdict);
        assert_near(f.record.summary.limits[0].value, 0.8 / 25e-6, 1e-14);
        assert_true(isnan(f.record.summary.limits[2].value));
    }
}

/** Below the load at which the gap closes to the bond line all answers stay the same to the byte; above it more load
 * changes nothing. A bond line thinner than all gaps changes nothing at all. */
TEST_CASE(a_bond_line_that_the_gap_comes_down_to)
{
    static struct contact_point points[LOADS + 1];
    const size_t m = model_named("cmy"), middle = LOADS / 3;
    make(1);
    f.task.load_count = LOADS - LOADS / 4; /* below the hardness */
    grease(points, m, 0);
    const struct contact_point at = points[middle], before = points[middle - 1], last = points[f.task.load_count - 1];
    assert_true(at.value[QUANTITY_SEPARATION] > last.value[QUANTITY_SEPARATION]);
    double between = sqrt(at.value[QUANTITY_JOINT] * before.value[QUANTITY_JOINT]);
    size_t lighter = ask_joint(between), heavier = ask_joint(0.99 * last.value[QUANTITY_JOINT]),
           ecr = ask("ecr", 1.01 * last.value[QUANTITY_ECR]);
    find();
    struct answer free_of[3] = {*answer(lighter, "cmy"), *answer(heavier, "cmy"), *answer(ecr, "cmy")};
    for (int k = 0; k < 3; k++)
        assert_int_equal(free_of[k].kind, ANSWER_LOAD);
    grease(points, m, 0.99 * last.value[QUANTITY_SEPARATION]); /* thinner than all gaps */
    ask_joint(between);
    ask_joint(0.99 * last.value[QUANTITY_JOINT]);
    ask("ecr", 1.01 * last.value[QUANTITY_ECR]);
    find();
    for (size_t k = 0; k < 3; k++)
        assert_memory_equal(answer(k, "cmy"), &free_of[k], sizeof *free_of);
    /* between two loads of the curve */
    double bond_line_m = (at.value[QUANTITY_SEPARATION] + points[middle + 1].value[QUANTITY_SEPARATION]) / 2;
    grease(points, m, bond_line_m);
    double plateau = points[f.task.load_count - 1].value[QUANTITY_JOINT];
    assert_near(points[middle + 1].value[QUANTITY_JOINT], plateau, 1e-14);
    assert_true(plateau > at.value[QUANTITY_JOINT]);
    ask_joint(between);
    ask_joint(0.99 * last.value[QUANTITY_JOINT]);
    ask("ecr", 1.01 * last.value[QUANTITY_ECR]);
    size_t under = ask_joint(plateau * (1 - 1e-3)), over = ask_joint(plateau * (1 + 1e-6));
    find();
    assert_near(answer(0, "cmy")->load, free_of[0].load, 1e-9);
    assert_near(answer(0, "cmy")->spots_per_m2, free_of[0].spots_per_m2, 1e-9);
    assert_true(answer(1, "cmy")->kind == ANSWER_NONE && answer(1, "cmy")->held);
    assert_true(answer(2, "cmy")->kind == ANSWER_NONE && answer(2, "cmy")->held);
    assert_int_equal(answer(under, "cmy")->kind, ANSWER_LOAD);
    assert_within(answer(under, "cmy")->load, f.loads[middle], f.loads[middle + 1]);
    assert_true(answer(over, "cmy")->held);
}

/* A limit that the interval straddles is undecided; without one the value decides. */
TEST_CASE(limits)
{
    static const struct {
        double value, low, high;
        bool is_upper;
        enum limit_verdict verdict;
    } rows[] = {
        {0.9, NAN, NAN, true, LIMIT_MET},        {1.1, NAN, NAN, true, LIMIT_MISSED},
        {1.1, NAN, NAN, false, LIMIT_MET},       {0.9, NAN, NAN, false, LIMIT_MISSED},
        {0.9, 0.8, 0.99, true, LIMIT_MET},       {0.9, 0.8, 1.01, true, LIMIT_UNDECIDED},
        {1.1, 0.99, 1.2, true, LIMIT_UNDECIDED}, {1.1, 1.01, 1.2, true, LIMIT_MISSED},
        {0.9, 0.8, 0.99, false, LIMIT_MISSED},   {1.1, 0.99, 1.2, false, LIMIT_UNDECIDED},
        {1.1, 1.01, 1.2, false, LIMIT_MET},      {NAN, NAN, NAN, true, LIMIT_NO_VALUE},
        {0, NAN, NAN, true, LIMIT_MET}, /* complete contact */
    };
    const struct scene_asked up = {.value = 1, .is_upper = true}, down = {.value = 1};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct limit_check check = {rows[i].value, rows[i].low, rows[i].high, LIMIT_NO_VALUE};
        assert_int_equal(answers_judge(&check, rows[i].is_upper ? &up : &down), rows[i].verdict);
    }
}

/* Limits where the leading model has no value at the operating load: at full contact, or not known. */
TEST_CASE(limits_without_a_number)
{
    static struct contact_point points[LOADS + 1];
    struct scene_asked limit[6] = {{.quantity = QUANTITY_JOINT_ECR}};
    make(1);
    plate();
    size_t m = model_named("jg");
    f.plan.models = MODEL_BIT(m);
    double tenth, full;
    jg_loads(&tenth, &full, &f.task);
    const double loads[] = {0.1 * tenth, 0.9 * tenth, 1.1 * tenth, 0.5 * full, 1.5 * full};
    f.task = model_task_at(&f.task, loads, 5);
    struct model_curve *curve = &f.record.curves[m];
    curve->points = points;
    expect_ok(model_run, curve, model_rows[m], &f.task);
    const struct joint_task joint = surface_joint(&f.record, &f.scene, &f.plan, &f.task);
    expect_ok(joint_curve, curve, model_rows[m], &f.task, &joint);
    double last = points[1].value[QUANTITY_JOINT_ECR];
    assert_true(last > 2e-12 && isnan(points[2].value[QUANTITY_JOINT_ECR]) && curve->full_load < loads[4]);
    const struct {
        enum quantity quantity;
        double value;
        bool is_upper;
        enum limit_verdict complete;
    } rows[6] = {{QUANTITY_JOINT_ECR, 1.001 * last, true, LIMIT_MET},
                 {QUANTITY_JOINT_ECR, 0.999 * last, true, LIMIT_MET},
                 {QUANTITY_JOINT_ECR, 1.001 * last, false, LIMIT_MISSED},
                 {QUANTITY_JOINT_ECR, 0.999 * last, false, LIMIT_MISSED},
                 {QUANTITY_JOINT_ECR, 0.999e-12, true, LIMIT_MISSED}, /* below the film's */
                 {QUANTITY_JOINT, 1e15, false, LIMIT_MET}};           /* which no plating changes: missed before */
    f.scene.limits = limit;
    f.scene.limit_count = 6;
    for (int k = 0; k < 6; k++)
        limit[k] =
            (struct scene_asked){.quantity = rows[k].quantity, .value = rows[k].value, .is_upper = rows[k].is_upper};
    for (size_t at = 2; at < 5; at += 2) {
        f.task.operating_place = at + 1;
        find();
        for (int k = 0; k < 6; k++) {
            const struct limit_check *check = &f.record.summary.limits[k];
            if (check->verdict != (at == 4 ? rows[k].complete : k < 5 ? LIMIT_NO_VALUE : LIMIT_MISSED))
                fail_msg("limit %d at load %zu: verdict %d", k, at, (int)check->verdict);
            if (k < 5)
                assert_true(at == 4 ? fabs(check->value / 1e-12 - 1) < 1e-12 : isnan(check->value));
            else
                assert_int_equal(isnan(check->value), at == 4);
        }
    }
}

TEST_GROUP(NULL, drop)
