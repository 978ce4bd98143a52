/* SPDX-License-Identifier: GPL-3.0-or-later */
/* comparison_make() on curves made up to order: every count and ratio worked out by hand. */
#include "made_up_results.h"
#include "support.h"

static struct made_up made;

static int end(void **state)
{
    (void)state;
    made_up_free(&made);
    return 0;
}

static const struct comparison_model *of(const char *name)
{
    return &made.comparison.models[made_up_model(name)];
}

/** Area and resistance of one point of one curve. */
static struct contact_point *point_of(struct surface_record *record, const char *model, size_t load)
{
    return &record->curves[made_up_model(model)].points[load];
}

#define PLACED(name) TEST_WITH(name, NULL, end)

/* Powers of the load: see made_up_results.h. Loads 1e-6 ... 1e-2, so that i = 4 is the middle. */
PLACED(test_power_laws)
{
    made_up_make(&made, NULL);
    const struct comparison *c = &made.comparison;
    assert_int_equal(c->leading, made_up_model("multiscale-plastic"));
    assert_near(comparison_middle(&made.results, c->leading, 0).value[QUANTITY_AREA], 0.1, 1e-12);
    assert_near(comparison_middle(&made.results, c->leading, 1).value[QUANTITY_AREA], 0.2, 1e-12);
    assert_near(comparison_middle(&made.results, c->leading, 2).value[QUANTITY_ECR], 3.75e-10, 1e-12);
    assert_true(isnan(comparison_middle(&made.results, c->leading, 3).value[QUANTITY_LOAD])); /* refused */

    /* elastic: full from 1e-3 (alpha), 2e-3 (beta), 5e-3 (gamma), so that both of a pair are full at 1e-2 alone, and
     * alpha and beta at 3.16e-3 too */
    for (int q = 1; q < QUANTITY_COUNT; q++) {
        const struct comparison_tally *rank = &of("multiscale-elastic")->rank[q];
        assert_int_equal(rank->agreeing, q == QUANTITY_ADJUSTED ? 0 : 2 * 9 - 2 - 1);
        assert_int_equal(rank->opposed + rank->ties, 0);
    }

    const struct comparison_plastic *plastic = &of("multiscale-plastic")->plastic;
    size_t partial = plastic->changes[QUANTITY_AREA].agreeing;
    assert_int_equal(partial, 27 - 3 - 2 - 1); /* less those at which both are full: it says nothing of them */
    assert_int_equal(plastic->changes[QUANTITY_AREA].opposed + plastic->changes[QUANTITY_AREA].ties, 0);
    assert_int_equal(plastic->changes[QUANTITY_SEPARATION].agreeing, partial);
    assert_int_equal(plastic->changes[QUANTITY_ECR].agreeing, partial);
    assert_near(plastic->most, 2, 1e-12);
    assert_true(plastic->least > 1);
    assert_int_equal(plastic->sooner.agreeing, 3);
    assert_int_equal(of("multiscale-elastic")->plastic.changes[QUANTITY_AREA].agreeing, 0);

    for (size_t i = 0; i < MADE_UP_USABLE; i++) {
        assert_near(of("gw")->gaps[i].area, log10(2), 1e-12);
        assert_near(of("jg")->gaps[i].ecr, log10(2.5), 1e-12);
        assert_true(isnan(of("multiscale-elastic")->gaps[i].area));
    }
    assert_true(isnan(of("gw")->gaps[3].area)); /* refused */
    /* alpha is full at 1e-3 and beta at 2e-3, so that the last two loads are no cases; gamma at 5e-3 */
    assert_int_equal(of("multiscale-elastic")->smoothest[QUANTITY_SEPARATION].agreeing, 7);
    assert_int_equal(of("multiscale-elastic")->high_rank[QUANTITY_SEPARATION].agreeing, 3 + 3); /* from 1e-4, 2e-4 on */
    double decades = 0, partly = 0; /* of 1 - A/A_n, alpha's in multiscale plastic and JG */
    for (size_t i = 0; i < MADE_UP_LOADS && 2000 * made.loads[i] < 1; i++, partly++)
        decades += log10((1 - 800 * made.loads[i]) / (1 - 2000 * made.loads[i]));
    assert_near(of("jg")->gaps[1].separation, decades / partly, 1e-12);
    /* neighbours: 3 times the resistance from alpha to beta, 2.5 times from beta to gamma */
    assert_near(of("gw")->steps[0], log10(3), 1e-12);
    assert_near(of("gw")->steps[1], log10(2.5), 1e-12);

    const struct comparison_extent *ecr = &of("jg")->extremes[QUANTITY_ECR];
    assert_int_equal(ecr->count, 3);
    assert_near(ecr->least, 1e-10 / 0.8, 1e-12);
    assert_near(ecr->most, 7.5e-10 / 0.8, 1e-12);
    const struct comparison_extent *gap = &of("gw")->extremes[QUANTITY_SEPARATION]; /* over sigma */
    assert_near(gap->least, 0.95, 1e-12);
    assert_near(gap->most, 0.99, 1e-12);
    assert_int_equal(of("multiscale-elastic")->extremes[QUANTITY_ADJUSTED].count, 0);
}

/* One point of the rougher neighbour out of order in each quantity. */
static void turn_one(struct surface_record *record, size_t index)
{
    if (index != 2)
        return;
    struct contact_point *p = point_of(record, "gw", 3);
    p->value[QUANTITY_AREA] *= 10;
    p->value[QUANTITY_ECR] /= 10;
    p->value[QUANTITY_TCR] /= 10;
    p->value[QUANTITY_ADJUSTED] = 0;
    p->value[QUANTITY_SEPARATION] = 0; /* what is shown is the adjusted one */
    point_of(record, "gw", 4)->value[QUANTITY_SEPARATION] = 0;
}

PLACED(test_neighbours_out_of_order)
{
    made_up_make(&made, turn_one);
    const struct comparison_tally *rank = of("gw")->rank;
    assert_int_equal(rank[QUANTITY_AREA].opposed, 1);
    assert_int_equal(rank[QUANTITY_SEPARATION].opposed, 1);
    assert_int_equal(rank[QUANTITY_ECR].opposed, 1);
    assert_int_equal(rank[QUANTITY_TCR].opposed, 1);
    assert_int_equal(of("jg")->rank[QUANTITY_AREA].opposed, 0);
    assert_true(of("jg")->rank[QUANTITY_AREA].agreeing > 10);
}

/* Equal numbers are ties, which speak for neither side, and so are those within the tolerance (1e-8). */
static void make_equal(struct surface_record *record, size_t index)
{
    (void)index;
    for (size_t i = 0; i < MADE_UP_LOADS; i++) {
        struct contact_point *elastic = point_of(record, "gw", i), *plastic = point_of(record, "jg", i);
        elastic->value[QUANTITY_AREA] = 0.01 * (double)(i + 1);
        elastic->value[QUANTITY_ECR] = 1e-10;
        elastic->value[QUANTITY_ADJUSTED] = 0.5 * record->summary.roughness.rq_m;
        plastic->value[QUANTITY_AREA] = elastic->value[QUANTITY_AREA] * (i == 0 ? 1 - 1e-9 : i == 1 ? 1 - 1e-7 : 1.5);
    }
    record->curves[made_up_model("jg")].full_load = record->curves[made_up_model("gw")].full_load;
}

PLACED(test_equal_neighbours_and_laws)
{
    made_up_make(&made, make_equal);
    const struct comparison_tally *rank = of("gw")->rank;
    static const enum quantity alike[] = {QUANTITY_AREA, QUANTITY_SEPARATION, QUANTITY_ECR};
    for (int k = 0; k < 3; k++) {
        assert_int_equal(rank[alike[k]].ties, 18);
        assert_int_equal(rank[alike[k]].agreeing + rank[alike[k]].opposed, 0);
    }
    const struct comparison_plastic *plastic = &of("jg")->plastic;
    assert_int_equal(plastic->changes[QUANTITY_AREA].agreeing, 21);
    assert_int_equal(plastic->changes[QUANTITY_AREA].ties, 3);
    assert_int_equal(plastic->changes[QUANTITY_AREA].opposed, 3);
    assert_near(plastic->most, 1.5, 1e-12);
    assert_near(plastic->least, 1 - 1e-7, 1e-15);
    assert_int_equal(plastic->sooner.ties, 3); /* at the same load is not sooner */
    assert_int_equal(plastic->sooner.agreeing, 0);
}

/* Curves that end early, with a load of their own, are compared up to their last common load; ones that do not exist
 * not at all. */
static void cut_short(struct surface_record *record, size_t index)
{
    struct model_curve *jg = &record->curves[made_up_model("jg")];
    jg->count = 4;
    jg->points[3].value[QUANTITY_LOAD] *= 1.5; /* the point of full contact */
    if (index == 1)
        record->curves[made_up_model("gw")] =
            (struct model_curve){.points = record->curves[made_up_model("gw")].points};
}

PLACED(test_short_curves)
{
    made_up_make(&made, cut_short);
    assert_int_equal(of("jg")->rank[QUANTITY_AREA].agreeing, 2 * 3);
    assert_int_equal(of("jg")->plastic.changes[QUANTITY_AREA].agreeing, 2 * 3);
    assert_int_equal(of("jg")->plastic.sooner.agreeing, 2);
    assert_int_equal(of("gw")->rank[QUANTITY_AREA].agreeing, 9 - 1); /* both full at the last */
    assert_int_equal(of("gw")->extremes[QUANTITY_AREA].count, 2);
    assert_int_equal(of("jg")->extremes[QUANTITY_AREA].count, 0); /* it ends below the middle load */
    assert_near(of("jg")->gaps[0].area, log10(2.5), 1e-12);
}

/* The last halving of the wavelength: from the scale in the middle to the last. */
PLACED(test_a_settled_sweep)
{
    made_up_make(&made, NULL);
    size_t model = made_up_model("multiscale-plastic");
    made_up_sweep(&made, CONVERGENCE_GAMMA, "multiscale-plastic", 3, 0.5 * 0.99901);
    assert_true(comparison_converges(&made.results, CONVERGENCE_GAMMA, model, 3));
    made_up_sweep(&made, CONVERGENCE_GAMMA, "multiscale-plastic", 3, 0.5 * 0.99899);
    assert_false(comparison_converges(&made.results, CONVERGENCE_GAMMA, model, 3));
    made.scene.convergence.scales = 1;
    assert_true(comparison_converges(&made.results, CONVERGENCE_ALPHA, model, 0));
    made.scene.convergence.scales = MADE_UP_SCALES;
}

/* The plastic areas of gamma are doubled: 1000, 2000, 800 times the load, and elastic ones 500, 1000, 200 times. */
static void lessen_spread(struct surface_record *record, size_t index)
{
    for (size_t i = 0; index == 2 && i < MADE_UP_LOADS; i++) {
        double *area = &point_of(record, "multiscale-plastic", i)->value[QUANTITY_AREA];
        *area = fmin(1, 2 * *area);
    }
}

static void fill_all(struct surface_record *record, size_t index)
{
    for (size_t i = 0; index < MADE_UP_USABLE && i < MADE_UP_LOADS; i++) {
        point_of(record, "gw", i)->value[QUANTITY_AREA] = 1;
        point_of(record, "gw", i)->value[QUANTITY_ECR] = 0;
    }
}

PLACED(test_spreads)
{
    made_up_make(&made, lessen_spread);
    const struct comparison_model *elastic = of("multiscale-elastic"), *plastic = of("multiscale-plastic");
    const struct results *results = &made.results;
    assert_near(comparison_mean_spread(results, elastic, plastic, COMPARISON_AREAS), log10(5), 1e-9);
    assert_near(comparison_mean_spread(results, plastic, elastic, COMPARISON_AREAS), log10(2.5), 1e-9);
    assert_near(comparison_largest_spread(results, plastic, COMPARISON_AREAS), 2.5, 1e-9);
    assert_near(comparison_largest_spread(results, elastic, COMPARISON_RESISTANCES), 7.5, 1e-9);
    made_up_free(&made);
    made_up_make(&made, fill_all);
    assert_true(isnan(comparison_largest_spread(results, of("gw"), COMPARISON_AREAS)));
    assert_int_equal(of("gw")->rank[QUANTITY_AREA].agreeing + of("gw")->rank[QUANTITY_AREA].ties, 0);
    assert_true(isnan(of("gw")->steps[0]));
}

/* A leading strip over Gaussian heights of the same material law; nothing where one has no number or does not run. */
PLACED(test_heights_factor)
{
    made_up_make(&made, NULL);
    assert_true(isnan(comparison_heights_factor(&made.results, 1, QUANTITY_ECR))); /* multiscale leads */
    struct curve_summary strip = {.exists = true}, gaussian = {.exists = true};
    size_t s = made_up_model("strip"), g = made_up_model("corrected-persson");
    struct curve_summary **models = made_up_surface(&made, 1)->models, *before[] = {models[s], models[g]};
    strip.operating.value[QUANTITY_ECR] = 6e-9;
    gaussian.operating.value[QUANTITY_ECR] = 2e-9;
    models[s] = &strip;
    models[g] = &gaussian;
    made.plan.models |= MODEL_BIT(s) | MODEL_BIT(g);
    double factor = comparison_heights_factor(&made.results, 1, QUANTITY_ECR);
    gaussian.exists = false;
    double without = comparison_heights_factor(&made.results, 1, QUANTITY_ECR);
    made.plan.models &= ~MODEL_BIT(g);
    double alone = comparison_heights_factor(&made.results, 1, QUANTITY_ECR);
    models[s] = before[0];
    models[g] = before[1];
    assert_near(factor, 3, 1e-12);
    assert_true(isnan(without) && isnan(alone));
}
