/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The findings of chapter 6 on curves made up to order: every count worked out by hand, model by model. */
#include "base/number_format.h"
#include "made_up_results.h"
#include "report/report.h"
#include "support.h"

static struct made_up made;

static int end(void **state)
{
    (void)state;
    made_up_free(&made);
    made = (struct made_up){0};
    return 0;
}

#define PLACED(name) TEST_WITH(name, NULL, end)

/** Makes the results of these models alone, with all effects. */
static void make(const char *first, const char *second, void (*change)(struct surface_record *record, size_t index))
{
    made_up_free(&made);
    made_up_make_of(&made, MODEL_BIT(model_named(first)) | MODEL_BIT(model_named(second)), (1u << EFFECT_COUNT) - 1,
                    change);
}

/** The finding says "good of all, ties alike: the numbers' ranges", as far as there is any; NULL: there is none. */
static void assert_found(const char *name, const char *expected)
{
    size_t i, k;
    const json_t *item, *number, *found = NULL;
    struct text *said = support_text();
    json_array_foreach (json_object_get(made.view, "findings"), i, item) {
        found = strcmp(json_text_at(item, "name"), name) == 0 ? item : found;
    }
    if (!found != !expected)
        fail_msg("%s: %s", name, found ? "found" : "not found");
    if (!found)
        return;
    const json_int_t good = json_integer_value(json_object_get(found, "good")),
                     all = json_integer_value(json_object_get(found, "all"));
    assert_int_equal(json_is_true(json_object_get(found, "holds")), good == all);
    assert_int_equal(json_is_true(json_object_get(found, "fails")), 2 * good < all);
    text_add(said, "%lld of %lld", (long long)good, (long long)all);
    if (json_object_get(found, "ties"))
        text_add(said, ", %lld alike", (long long)json_integer_value(json_object_get(found, "ties")));
    json_array_foreach (json_object_get(found, "numbers"), k, number) {
        text_add(said, k == 0 ? ": " : "; ");
        number_format_range(said, json_number_at(number, "range/least"), json_number_at(number, "range/most"), 2,
                            " to ");
    }
    if (strcmp(text_string(said), expected) != 0)
        fail_msg("%s: '%s', not '%s'", name, text_string(said), expected);
}

/** Area and resistance of one point of one curve. */
static double *values_of(struct surface_record *record, const char *model, size_t load)
{
    return record->curves[model_named(model)].points[load].value;
}

/* Loads 1e-6 ... 1e-2; elastic contact is full from 1e-3 (alpha), 2e-3 (beta) and 5e-3 (gamma) on, so that both of a
 * pair are full at 3.16e-3 and 1e-2, or at 1e-2 alone; plastic from half of that on: 2 * 9 - 3 and 2 * 9 - 5. */
PLACED(test_stacked_scales)
{
    make("multiscale-elastic", "multiscale-plastic", NULL);
    assert_found("area_rank", "28 of 28");
    assert_found("ecr_rank", "28 of 28");
    assert_found("tcr_rank", "28 of 28");
    assert_found("separation_rank", "0 of 2");            /* it is */
    assert_found("high_rank", "11 of 11");                /* from 1e-4, 2e-4, and 5e-5, 1e-4 on: 3 + 3, and 2 + 3 */
    assert_found("plastic_area", "21 of 21: 1.6 to 2.0"); /* 27 - 6 at which both are full */
    assert_found("plastic_gap", "21 of 21");
    assert_found("plastic_ecr", "21 of 21");
    assert_found("sooner", "3 of 3");
    assert_found("magnitude", "2 of 2: 5.0; 5.0");
    assert_found("spread", NULL);
    assert_found("equal_steps", "2 of 2: 0.40 to 0.48; 0.40 to 0.48"); /* factors of 3 and 2.5 */
    assert_found("linear", "3 of 3: 1.0; 1.0");                        /* where at least five loads tell it */
    assert_found("scale_dependence", "6 of 6: 2.0; 2.0");
}

/* JG has 0.8 and multiscale plastic 2 times the elastic area: 2.5 in area and resistance. */
PLACED(test_families)
{
    make("multiscale-plastic", "jg", NULL);
    assert_found("families", NULL);
    assert_found("family_ecr", "3 of 3");
    assert_found("adjustment", NULL);
    assert_found("same_order", "3 of 3: 1.1 to 1.2");
    assert_found("stiffer", "3 of 3: 1.9 to 2.2"); /* 2.5, less where the one is full */
    assert_found("sensitive", NULL);
    assert_found("together", "0 of 1: 0.48");
    assert_found("smoothest", "0 of 1: 0");
    assert_found("beta", "3 of 3: 6.0");
    assert_found("beta_rank", NULL); /* nothing to compare */
    assert_found("statistical_gap", "0 of 3: −3.0");
}

/** JG's resistance of gamma is 5 times the multiscale one, and its adjusted gap that of multiscale plastic. */
static void change_jg(struct surface_record *record, size_t index)
{
    static const double beta[MADE_UP_USABLE] = {5, 7, 6};
    if (index >= MADE_UP_USABLE)
        return;
    record->curves[model_named("jg")].beta = beta[index];
    for (size_t i = 0; i < MADE_UP_LOADS; i++) {
        double *jg = values_of(record, "jg", i);
        jg[QUANTITY_ECR] *= index == 2 ? 2 : 1;
        jg[QUANTITY_STIFFNESS] *= index == 2 ? 5 : 1;
        jg[QUANTITY_ADJUSTED] = values_of(record, "multiscale-plastic", i)[QUANTITY_SEPARATION];
    }
}

PLACED(test_families_apart)
{
    make("multiscale-plastic", "jg", change_jg);
    assert_found("families", "0 of 1, 2 alike");
    assert_found("family_ecr", "2 of 3");
    assert_found("adjustment", "3 of 3");
    assert_found("same_order", "3 of 3: 1.0");
    assert_found("stiffer", "2 of 3: 0.44 to 2.0");
    assert_found("sensitive", "1 of 1");
    assert_found("together", "0 of 1: 0.48"); /* 0.70 is not twice that */
    assert_found("beta", "3 of 3: 5.0 to 7.0");
    assert_found("beta_rank", "1 of 1"); /* 7, 5, 6 */
}

/** The rougher, the smaller the gap over sigma: 3, 2, 0. */
static void turn_gaps(struct surface_record *record, size_t index)
{
    static const double gap[MADE_UP_USABLE] = {2, 3, 0};
    for (size_t i = 0; index < MADE_UP_USABLE && i < MADE_UP_LOADS; i++)
        values_of(record, "jg", i)[QUANTITY_ADJUSTED] = gap[index] * record->summary.asperities.sigma_m;
}

PLACED(test_gaps_turned_round)
{
    make("multiscale-plastic", "jg", turn_gaps);
    assert_found("smoothest", "0 of 1: 100"); /* it is not alone */
    assert_found("adjustment", "0 of 3");
    assert_found("separation_rank", "0 of 2");
}

/** The rougher the surface, the larger its area, which is the same elastic and plastic. */
static void turn_areas(struct surface_record *record, size_t index)
{
    static const double area[MADE_UP_USABLE] = {500, 200, 1000};
    for (size_t m = 0; index < MADE_UP_USABLE && m < model_count; m++)
        for (size_t i = 0; record->curves[m].exists && i < MADE_UP_LOADS; i++) {
            double *value = record->curves[m].points[i].value;
            value[QUANTITY_AREA] = fmin(1, area[index] * value[QUANTITY_LOAD]);
        }
}

PLACED(test_areas_turned_round)
{
    make("multiscale-elastic", "multiscale-plastic", turn_areas);
    assert_found("area_rank", "0 of 30");
    assert_found("plastic_area", NULL);
}

/** What the thesis says of stiffness, of a shoulder at 3 times the load, and of its smoothest surface. */
static void as_the_thesis_has_it(struct surface_record *record, size_t index)
{
    for (size_t m = 0; index < MADE_UP_USABLE && m < model_count; m++) {
        struct model_curve *curve = &record->curves[m];
        bool statistical = model_rows[m]->sums_asperities;
        curve->beta = statistical ? -1 : NAN; /* 0.5 σ left */
        if (model_rows[m]->stacks_scales && !model_rows[m]->plastic)
            curve->kink.load = 3 * record->curves[model_named("multiscale-plastic")].full_load;
        for (size_t i = 0; curve->exists && i < curve->count; i++) {
            double *value = curve->points[i].value;
            value[QUANTITY_STIFFNESS] = statistical ? 1e12 : 4e12;
            if (statistical && index == 1)
                value[QUANTITY_ADJUSTED] += 1e-5;
            if (statistical && index == 0)
                value[QUANTITY_ECR] *= 0.5; /* 1.5 times alpha's */
        }
    }
}

PLACED(test_findings_as_the_thesis_has_them)
{
    const struct report_options how = {PROJECT_SOURCE "/templates", PROJECT_SOURCE "/surfaces/chapter6/report.md", 0};
    struct text *out = support_text();
    made_up_make(&made, as_the_thesis_has_it);
    for (size_t i = 0; i < MADE_UP_USABLE; i++)
        for (size_t m = 0; m < model_count; m++)
            if (made_up_surface(&made, i)->models[m])
                made_up_surface(&made, i)->models[m]->law_factor = i == 0 ? 0.25 : 3;
    made_up_again(&made);
    assert_found("statistical_gap", "6 of 6: 0.50; 0.50");
    assert_found("stiffer", "6 of 6: 4.0; 4.0");
    assert_found("law", "6 of 6: 3.0 to 4.0; 3.0 to 4.0");
    assert_found("smoothest", "2 of 2: 100; 100");
    assert_found("shoulder", "3 of 3: 3.0");
    assert_found("together", "2 of 2: 0.18; 0.18");
    expect_ok(report_markdown, out, made.view, &how);
    expect_parts(text_string(out), "| GW, thesis | 153.7 | 5.2 | 8.8 | 6.8 |\n| GW, here | −1.00 | −1.00 | −1.00 |\n",
                 "| JG, here | −1.00 | −1.00 | −1.00 |\n");
    end(NULL); /* without stiffness */
    made_up_make_of(&made, made_up_models(), ~EFFECT_BIT(EFFECT_STIFFNESS) & ((1u << EFFECT_COUNT) - 1), NULL);
    assert_found("stiffer", NULL);
}

/* One point of the rougher neighbour out of order in each quantity. */
static void turn_one(struct surface_record *record, size_t index)
{
    if (index != 2)
        return;
    double *value = values_of(record, "gw", 3);
    value[QUANTITY_AREA] *= 10;
    value[QUANTITY_ECR] /= 10;
    value[QUANTITY_TCR] /= 10;
    value[QUANTITY_ADJUSTED] = 0;
    value[QUANTITY_SEPARATION] = 0; /* what is shown is the adjusted one */
    values_of(record, "gw", 4)[QUANTITY_SEPARATION] = 0;
}

PLACED(test_neighbours_out_of_order)
{
    make("gw", "multiscale-elastic", turn_one);
    assert_found("area_rank", "30 of 31"); /* 15, and 2 * 9 - 2 less the one */
    assert_found("ecr_rank", "30 of 31");
    assert_found("tcr_rank", "30 of 31");
    assert_found("separation_rank", "1 of 2");
}

/* Equal numbers are ties, which speak for neither side, and so are those within the tolerance (1e-8). */
static void make_equal(struct surface_record *record, size_t index)
{
    for (size_t i = 0; index < MADE_UP_USABLE && i < MADE_UP_LOADS; i++) {
        double *elastic = values_of(record, "gw", i), *plastic = values_of(record, "jg", i);
        elastic[QUANTITY_AREA] = 0.01 * (double)(i + 1);
        elastic[QUANTITY_ECR] = plastic[QUANTITY_ECR] = 1e-10;
        elastic[QUANTITY_ADJUSTED] = plastic[QUANTITY_ADJUSTED] = 1e-22 * (double)index; /* nothing, beside σ */
        plastic[QUANTITY_AREA] = elastic[QUANTITY_AREA] * (i == 0 ? 1 - 1e-9 : i == 1 ? 1 - 1e-7 : 1.5);
    }
    record->curves[model_named("jg")].full_load = record->curves[model_named("gw")].full_load;
}

PLACED(test_equal_neighbours_and_laws)
{
    make("gw", "jg", make_equal);
    assert_found("area_rank", NULL);
    assert_found("ecr_rank", NULL);
    assert_found("separation_rank", NULL);
    assert_found("plastic_area", "21 of 24, 3 alike: 1.0 to 1.5");
    assert_found("plastic_ecr", NULL);
    assert_found("sooner", NULL); /* at the same load is not sooner */
}

static void make_as_rough(struct surface_record *record, size_t index)
{
    record->summary.roughness.rq_m = 2e-7 * (1 + 1e-9 * (double)index);
}

PLACED(test_surfaces_as_rough_as_others_have_no_order)
{
    static const char *const names[] = {"area_rank", "ecr_rank", "separation_rank", "gamma_rank", "beta_rank"};
    make("gw", "multiscale-elastic", make_as_rough);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        assert_found(names[i], NULL);
}

/* Surfaces that are the same lie at no distance, which is no unequal one. */
static void make_the_same(struct surface_record *record, size_t index)
{
    for (size_t i = 0; index < MADE_UP_USABLE && i < MADE_UP_LOADS; i++)
        values_of(record, "multiscale-elastic", i)[QUANTITY_ECR] = 1e-10;
}

PLACED(test_the_same_surfaces_lie_at_no_distance)
{
    make("gw", "multiscale-elastic", make_the_same);
    assert_found("equal_steps", NULL);
}

/* Curves that end early, with a load of their own, are compared up to their last common load; ones that do not exist
 * not at all. */
static void cut_short(struct surface_record *record, size_t index)
{
    struct model_curve *jg = &record->curves[model_named("jg")], *gw = &record->curves[model_named("gw")];
    jg->count = 4;
    jg->points[3].value[QUANTITY_LOAD] *= 1.5; /* the point of full contact */
    if (index == 1)
        *gw = (struct model_curve){.points = gw->points};
}

PLACED(test_short_curves)
{
    make("gw", "jg", cut_short);
    assert_found("area_rank", "14 of 14"); /* 2 * 3, and 9 less that at which both are full */
    assert_found("plastic_area", "6 of 6: 1.6");
    assert_found("sooner", "2 of 2");
}

/* The plastic areas of gamma are doubled: 1000, 2000, 800 times the load, and elastic ones 500, 1000, 200 times. */
static void lessen_spread(struct surface_record *record, size_t index)
{
    for (size_t i = 0; index == 2 && i < MADE_UP_LOADS; i++) {
        double *area = &values_of(record, "multiscale-plastic", i)[QUANTITY_AREA];
        *area = fmin(1, 2 * *area);
    }
}

static void fill_all(struct surface_record *record, size_t index)
{
    for (size_t i = 0; index < MADE_UP_USABLE && i < MADE_UP_LOADS; i++) {
        values_of(record, "gw", i)[QUANTITY_AREA] = 1;
        values_of(record, "gw", i)[QUANTITY_ECR] = 0;
    }
}

PLACED(test_spreads)
{
    make("multiscale-elastic", "multiscale-plastic", lessen_spread);
    assert_found("spread", "1 of 1");
    assert_found("magnitude", "2 of 2: 5.0; 2.5");
    make("gw", "multiscale-elastic", fill_all);
    assert_found("magnitude", "1 of 1: 5.0");
    assert_found("area_rank", "15 of 15");
    assert_found("together", NULL);
}

/* γ is 1.6, 1.4, 1.2: what lies within the errors of both laws is alike. */
PLACED(test_laws_within_their_errors)
{
    make("multiscale-elastic", "multiscale-plastic", NULL);
    assert_found("gamma_rank", "2 of 2");
    made_up_surface(&made, 2)->power_law.gamma_error = 0.3;
    made_up_again(&made);
    assert_found("gamma_rank", "1 of 1, 1 alike");
}
