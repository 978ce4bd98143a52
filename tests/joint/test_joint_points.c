/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What lies in and around the spots, added to points: in its limits, and off. */
#include "joint/joint.h"

#include "joint/heating.h"
#include "support.h"

static struct contact_point point_of(double area, double separation_m)
{
    struct contact_point point = quantity_nothing();
    point.value[QUANTITY_LOAD] = 1e-4;
    point.value[QUANTITY_AREA] = area;
    point.value[QUANTITY_SEPARATION] = separation_m;
    point.value[QUANTITY_ECR] = 2e-10;
    point.value[QUANTITY_TCR] = 4e-5;
    return point;
}

static const struct material_pair pair = {.resistivity_ohm_m = 6e-8, .side_resistivity_ohm_m = {1e-7, 2e-8}};

/** One point through all effects of `effects`. */
static struct contact_point apply(const struct joint *joint, unsigned effects, struct contact_point point)
{
    const struct joint_task task = {joint, &pair, 1e-6, 2e-6, effects, 1e-12, NULL};
    joint_apply(&point, NULL, 1, &task, NULL);
    return point;
}

/** A quantity of such a point. */
static double applied(const struct joint *joint, unsigned effects, double area, double separation_m, enum quantity q)
{
    return apply(joint, effects, point_of(area, separation_m)).value[q];
}

/** What a model may be off by in area: that of an elastic area exp(0.37) times as large, beside the same hardness, and
 * of the rule for both. */
TEST_CASE(areas_error)
{
    const struct model_row *plastic = model_rows[0];
    for (size_t m = 0; m < model_count; m++)
        plastic = model_rows[m]->plastic && model_rows[m]->uses_strip ? model_rows[m] : plastic;
    const struct joint joint = joint_default();
    struct material_pair yielding = {.effective_modulus_Pa = 1e11, .hardness_Pa = 1e9};
    const struct joint_task task = {&joint, &yielding, 1e-6, 2e-6, 0, 1e-12, NULL};
    const double over[] = {1.002, 1.02, 1.1, 100}; /* A/(P/H) */
    for (size_t k = 0; k < sizeof over / sizeof *over; k++) {
        double sd[QUANTITY_COUNT], own = log(hypot(sqrt(pow(over[k], 4) - 1) * exp(2 * 0.37), 1) / pow(over[k], 2)) / 2;
        const struct contact_point point = point_of(1e-2 * over[k], 1e-6);
        joint_model_sd(sd, &point, plastic, &task, (struct scans_reach){0});
        assert_near(sd[QUANTITY_AREA], sqrt(own * own + 0.03 * 0.03), 1e-9);
        joint_model_sd(sd, &point, plastic->elastic, &task, (struct scans_reach){0});
        assert_near(sd[QUANTITY_AREA], model_sd(plastic->elastic, QUANTITY_AREA, false), 1e-12);
    }
}

/** Nothing bears more than the hardness: an area is at least P/H, a resistance at most that of one spot so large; what
 * is made of it by a film too. Without a hardness, or without a nominal area, there is no such bound. */
TEST_CASE(physics_bounds)
{
    const double hardness_Pa = 1e9, area_m2 = 1e-6;
    struct joint joint = joint_default();
    joint.film_ohm_m2 = 1e-12;
    struct material_pair yielding = {.effective_modulus_Pa = 1e11,
                                     .hardness_Pa = hardness_Pa,
                                     .resistivity_ohm_m = 2e-8,
                                     .conductivity_W_per_mK = 400};
    const struct model_row *plastic = model_rows[model_named("strip-plastic")];
    const struct joint_task task = {&joint, &yielding, 1e-6, area_m2, EFFECT_BIT(EFFECT_FILM), 1e-12, NULL};
    const struct contact_point point = point_of(1e-2, 1e-6);
    double bound[QUANTITY_COUNT][2];
    joint_bounds(bound, &point, plastic, &task);
    const double force_N = material_pair_pressure(&yielding, point.value[QUANTITY_LOAD]) * area_m2,
                 radius_m = sqrt(force_N / (M_PI * hardness_Pa)), one_ohm = (2e-8 + 2e-8) / (4 * radius_m);
    assert_near(bound[QUANTITY_AREA][0], force_N / hardness_Pa / area_m2, 1e-12);
    assert_near(bound[QUANTITY_AREA][1], 1, 0);
    assert_near(bound[QUANTITY_ECR][1], one_ohm * area_m2, 1e-12);
    assert_near(bound[QUANTITY_TCR][1], (1 / 400.0 + 1 / 400.0) / (4 * radius_m) * area_m2, 1e-12);
    assert_near(bound[QUANTITY_JOINT_ECR][1], (one_ohm + 1e-12 / (M_PI * radius_m * radius_m)) * area_m2, 1e-9);
    assert_true(bound[QUANTITY_SEPARATION][0] == 0 && bound[QUANTITY_SEPARATION][1] == 0);
    assert_near(bound[QUANTITY_JOINT][0], 2 * radius_m * 400 / area_m2, 1e-12); /* however wide the gaps may be */
    joint.fill = JOINT_MEDIUM;
    joint.conductivity_W_per_mK = 0.8;
    joint.bond_line_m = 0.5e-6;
    struct joint_task filled = task;
    filled.effects = EFFECT_BIT(EFFECT_GAP);
    joint_bounds(bound, &point, plastic, &filled);
    assert_near(bound[QUANTITY_GAP][1], 0.8 / 0.5e-6, 1e-12);
    assert_near(bound[QUANTITY_MEAN_GAP][0], 0.5e-6, 1e-12);
    assert_near(bound[QUANTITY_SEPARATION][0], 0.5, 1e-12);
    joint_bounds(bound, &point, plastic->elastic, &task);
    assert_true(bound[QUANTITY_AREA][0] == 0 && bound[QUANTITY_ECR][1] == 0);
    const struct joint_task unsized = {&joint, &yielding, 1e-6, NAN, 0, 1e-12, NULL};
    joint_bounds(bound, &point, plastic, &unsized);
    assert_true(bound[QUANTITY_AREA][0] > 0 && bound[QUANTITY_ECR][1] == 0);
}

/** What an effect does not fill stays empty, and what the model computed stays as it is. */
TEST_CASE(off_is_empty)
{
    struct joint joint = joint_default();
    joint.film_ohm_m2 = 1e-12;
    joint.plating_thickness_m = 1e-6;
    joint.plating_ohm_m = 2e-8;
    joint.current_A = 1;
    for (unsigned effects = 0; effects < 1u << EFFECT_COUNT; effects++) {
        if (effects & EFFECT_BIT(EFFECT_SHAPE))
            continue; /* it takes a whole curve */
        struct contact_point before = point_of(0.01, 1e-6), after = apply(&joint, effects, before);
        for (int q = 0; q < QUANTITY_COUNT; q++) {
            double value = after.value[q];
            if (quantity_rows[q].from)
                assert_int_equal(isfinite(value), (effects & quantity_rows[q].effect) != 0);
            else
                assert_true(isnan(value) || value == before.value[q]);
        }
    }
}

TEST_CASE(gaps)
{
    struct joint joint = joint_default();
    const unsigned gap = EFFECT_BIT(EFFECT_GAP);
    struct contact_point air = apply(&joint, gap, point_of(0.01, 2e-6));
    assert_near(air.value[QUANTITY_JOINT], 1 / 4e-5 + air.value[QUANTITY_GAP], 1e-15);
    /* a thousandth of an atmosphere: free molecules, k/M */
    joint.pressure_Pa = 1e-6 * gas_table_pressure_Pa;
    double jump_m = gas_jump_length(joint.gas, 300, joint.pressure_Pa, joint.accommodation, joint.accommodation);
    /* of the gaps that a cut at 2 sigma leaves, a share of the Gaussian distribution */
    assert_near(applied(&joint, gap, 0.01, 2e-6, QUANTITY_GAP),
                0.99 * joint.gas->conductivity_W_per_mK / jump_m * erfc(-2 / M_SQRT2) / 2, 1e-4);
    joint.pressure_Pa = 0;
    assert_within(applied(&joint, gap, 0.01, 2e-6, QUANTITY_GAP), 0, 0);
    joint.fill = JOINT_VACUUM;
    struct contact_point vacuum = apply(&joint, gap, point_of(0.01, 2e-6));
    assert_within(vacuum.value[QUANTITY_GAP], 0, 0);
    assert_near(vacuum.value[QUANTITY_JOINT], 1 / 4e-5, 1e-15);
    /* grease: k/Y on what does not touch */
    joint.fill = JOINT_MEDIUM;
    joint.conductivity_W_per_mK = 0.8;
    assert_near(applied(&joint, gap, 0.25, 2e-6, QUANTITY_GAP), 0.75 * 0.8 / 2e-6, 1e-15);
    assert_true(isnan(applied(&joint, gap, 0.25, 0, QUANTITY_GAP)));
    /* a bond line counts where it is thicker than the gap */
    joint.bond_line_m = 3e-6;
    assert_near(applied(&joint, gap, 0.25, 2e-6, QUANTITY_GAP), 0.75 * 0.8 / 3e-6, 1e-15);
    assert_near(applied(&joint, gap, 0.25, -1e-6, QUANTITY_GAP), 0.75 * 0.8 / 3e-6, 1e-15);
    assert_near(applied(&joint, gap, 0.25, 4e-6, QUANTITY_GAP), 0.75 * 0.8 / 4e-6, 1e-15);
    /* a model without a separation has none, whatever fills the gaps */
    for (int fill = JOINT_VACUUM; fill <= JOINT_MEDIUM; fill++) {
        joint.fill = (enum joint_fill)fill;
        struct contact_point none = apply(&joint, gap, point_of(0.25, NAN));
        assert_true(isnan(none.value[QUANTITY_GAP]) && isnan(none.value[QUANTITY_JOINT]));
    }
    /* planes that have met count as touching */
    joint = joint_default();
    assert_near(applied(&joint, gap, 0.3, -1e-6, QUANTITY_GAP), applied(&joint, gap, 0.3, 0, QUANTITY_GAP), 1e-15);
}

/** A filler's bond line t: from where the gap passes it on, what touches stays; where it never was wider no metal
 * touches and h = k/t; a thinner one, another filling and a joint without the effect change nothing. */
TEST_CASE(a_bond_line_holds)
{
    enum { COUNT = 4 };
    struct joint joint = {.fill = JOINT_MEDIUM, .conductivity_W_per_mK = 0.8, .film_ohm_m2 = 1e-12};
    const unsigned gap = EFFECT_BIT(EFFECT_GAP) | EFFECT_BIT(EFFECT_FILM);
    struct joint_task task = {&joint, &pair, 1e-6, 2e-6, gap, 1e-12, NULL};
    struct contact_point own[COUNT], held[COUNT];
    for (int i = 0; i < COUNT; i++) {
        own[i] = point_of(1e-3 * pow(4, i), (4 - i) * 1e-6);
        own[i].value[QUANTITY_LOAD] = 1e-5 * pow(4, i);
        own[i].value[QUANTITY_ECR] /= pow(4, i);
        own[i].value[QUANTITY_TCR] /= pow(4, i);
        own[i].value[QUANTITY_STIFFNESS] = 1e12;
    }
    const struct {
        double bond_line_m;
        enum joint_fill fill;
        unsigned effects;
    } nothing[] = {{0, JOINT_MEDIUM, gap},
                   {0.99e-6, JOINT_MEDIUM, gap},
                   {1e-6, JOINT_MEDIUM, gap},
                   {25e-6, JOINT_GAS, gap},
                   {25e-6, JOINT_MEDIUM, 0}};
    for (size_t k = 0; k < sizeof nothing / sizeof *nothing; k++) {
        memcpy(held, own, sizeof own);
        joint.bond_line_m = nothing[k].bond_line_m;
        joint.fill = nothing[k].fill;
        task.effects = nothing[k].effects;
        joint_hold(held, COUNT, &task);
        assert_memory_equal(held, own, sizeof own);
    }
    joint.fill = JOINT_MEDIUM;
    task.effects = gap;
    joint.bond_line_m = 2.25e-6; /* three quarters of the way from the second to the third */
    memcpy(held, own, sizeof own);
    for (int again = 0; again < 2; again++) {
        joint_hold(held, COUNT, &task);
        joint_apply(held, NULL, COUNT, &task, NULL);
        assert_false(joint_is_held(&held[1], &task));
        assert_near(held[1].value[QUANTITY_TCR], 1e-5, 1e-14);
        for (int i = 2; i < COUNT; i++) {
            const double *value = held[i].value;
            assert_true(joint_is_held(&held[i], &task));
            assert_near(value[QUANTITY_LOAD], 1e-5 * pow(4, i), 1e-14);
            assert_near(value[QUANTITY_AREA], 1e-3 * pow(4, 1.75), 1e-12);
            assert_near(value[QUANTITY_ECR], 2e-10 * pow(4, -1.75), 1e-12);
            assert_near(value[QUANTITY_JOINT], pow(4, 1.75) / 4e-5 + (1 - value[QUANTITY_AREA]) * 0.8 / 2.25e-6, 1e-12);
            assert_true(isnan(value[QUANTITY_STIFFNESS]));
        }
        held[3] = own[3]; /* the next time a model whose gap has no number there */
        held[3].value[QUANTITY_SEPARATION] = NAN;
    }
    joint.bond_line_m = 25e-6;
    memcpy(held, own, sizeof own);
    joint_hold(held, COUNT, &task);
    joint_apply(held, NULL, COUNT, &task, NULL);
    for (int i = 0; i < COUNT; i++) {
        const double *value = held[i].value;
        assert_true(value[QUANTITY_AREA] == 0 && isinf(value[QUANTITY_ECR]) && isinf(value[QUANTITY_TCR]));
        assert_near(value[QUANTITY_GAP], 0.8 / 25e-6, 1e-15);
        assert_near(value[QUANTITY_JOINT], 0.8 / 25e-6, 1e-15);
        assert_true(isnan(value[QUANTITY_JOINT_ECR]) && isnan(value[QUANTITY_SPOT_DENSITY]));
    }
}

/** Errors of area, gap and resistance together, as on a rougher surface, make those of the joint. */
TEST_CASE(errors_are_carried_into_the_joint)
{
    const struct joint joint = {.fill = JOINT_MEDIUM, .conductivity_W_per_mK = 0.8};
    const struct joint_task task = {&joint, &pair, 1e-6, 2e-6, EFFECT_BIT(EFFECT_GAP), 1e-12, NULL};
    struct contact_point point = point_of(0.01, 4e-6);
    double sd[QUANTITY_COUNT] = {0}, metal = 1 / 4e-5, grease = 0.99 * 0.8 / 4e-6;
    joint_apply(&point, NULL, 1, &task, NULL);
    sd[QUANTITY_AREA] = 0.2;
    sd[QUANTITY_SEPARATION] = 0.1;
    sd[QUANTITY_TCR] = 0.5;
    joint_carry_sd(sd, &point, model_rows[0], &task);
    double open = (1 - 0.01 * exp(-0.2)) / 0.99;
    assert_near(sd[QUANTITY_GAP], -log(open * exp(-0.1)), 1e-12);
    assert_near(sd[QUANTITY_JOINT], log((metal + grease) / (metal * exp(-0.5) + grease * open * exp(-0.1))), 1e-12);
    assert_near(sd[QUANTITY_TCR], 0.5, 0);
}

/** Equal spots have the area and the resistance they are made from; own ones come through as they are. */
TEST_CASE(spots)
{
    struct contact_spots spots = joint_equal_spots(0.02, 3e-10, 6e-8);
    assert_near(spots.density_per_m2 * M_PI * pow(spots.radius_m, 2), 0.02, 1e-14);
    assert_near(6e-8 / (2 * spots.radius_m * spots.density_per_m2), 3e-10, 1e-14);
    assert_true(isfinite(joint_equal_spots(0.0999, 3e-10, 6e-8).radius_m));
    assert_true(isnan(joint_equal_spots(0.1001, 3e-10, 6e-8).radius_m));
    assert_true(isnan(joint_equal_spots(0, 3e-10, 6e-8).radius_m) && isnan(joint_equal_spots(NAN, 1, 1).radius_m));
    const struct joint joint = {.film_ohm_m2 = 1e-12};
    const struct joint_task task = {&joint, &pair, 1e-6, 2e-6, EFFECT_BIT(EFFECT_FILM), 1e-12, NULL};
    const struct contact_spots own = {5e7, 3e-6};
    struct contact_point point = point_of(0.5, 1e-6);
    joint_apply(&point, &own, 1, &task, NULL);
    assert_within(point.value[QUANTITY_SPOT_DENSITY] - 5e7, 0, 0);
    assert_within(point.value[QUANTITY_SPOT_RADIUS] - 3e-6, 0, 0);
}

/** No film: no change; a film alone adds s_f A_n/A. */
TEST_CASE(films)
{
    struct joint joint = {.film_ohm_m2 = 0};
    assert_within(applied(&joint, EFFECT_BIT(EFFECT_FILM), 0.04, NAN, QUANTITY_JOINT_ECR) - 2e-10, 0, 0);
    joint.film_ohm_m2 = 1e-12;
    assert_near(applied(&joint, EFFECT_BIT(EFFECT_FILM), 0.04, NAN, QUANTITY_JOINT_ECR), 2e-10 + 1e-12 / 0.04, 1e-15);
    assert_near(applied(&joint, EFFECT_BIT(EFFECT_FILM), 0.5, NAN, QUANTITY_JOINT_ECR), 2e-10 + 1e-12 / 0.5,
                1e-15); /* needs no spots */
}

/** No plating: 1; a thick one: a body of plating; the surface's side alone, or both; nothing beyond independent spots.
 */
TEST_CASE(platings)
{
    const unsigned plating = EFFECT_BIT(EFFECT_PLATING);
    struct joint joint = {.plating_thickness_m = 1e-18, .plating_ohm_m = 1e-8};
    assert_near(applied(&joint, plating, 0.04, NAN, QUANTITY_PLATING_FACTOR), 1, 1e-9);
    joint.plating_thickness_m = 1;
    assert_near(applied(&joint, plating, 0.04, NAN, QUANTITY_PLATING_FACTOR), (1e-8 + 2e-8) / 1.2e-7, 1e-4);
    joint.both_plated = true;
    assert_near(applied(&joint, plating, 0.04, NAN, QUANTITY_PLATING_FACTOR), (1e-8 + 1e-8) / 1.2e-7, 1e-4);
    joint.plating_thickness_m = 1e-6;
    struct contact_point both = apply(&joint, plating, point_of(0.04, NAN));
    double t = 1e-6 / both.value[QUANTITY_SPOT_RADIUS];
    assert_near(both.value[QUANTITY_PLATING_FACTOR],
                1e-8 * (plating_factor(t, 1e-8, 1e-7) + plating_factor(t, 1e-8, 2e-8)) / 1.2e-7, 1e-14);
    assert_near(both.value[QUANTITY_JOINT_ECR], 2e-10 * both.value[QUANTITY_PLATING_FACTOR], 1e-15);
    joint.both_plated = false;
    assert_near(applied(&joint, plating, 0.04, NAN, QUANTITY_PLATING_FACTOR),
                (1e-8 * plating_factor(t, 1e-8, 1e-7) + 2e-8) / 1.2e-7, 1e-14);
    struct contact_point dense = apply(&joint, plating, point_of(0.11, NAN));
    assert_true(isnan(dense.value[QUANTITY_PLATING_FACTOR]) && isnan(dense.value[QUANTITY_JOINT_ECR]));
    /* of full contact the film is left */
    struct contact_point full = point_of(1, 0);
    full.value[QUANTITY_ECR] = 0;
    joint.film_ohm_m2 = 3e-12;
    full = apply(&joint, plating | EFFECT_BIT(EFFECT_FILM), full);
    assert_true(isnan(full.value[QUANTITY_PLATING_FACTOR]) && full.value[QUANTITY_JOINT_ECR] == 3e-12);
}

/** V = I R; the film and the plating are part of R when they run; no current to speak of heats nothing. */
TEST_CASE(heat)
{
    struct joint joint = joint_default();
    joint.current_A = 500;
    joint.film_ohm_m2 = 1e-12;
    const unsigned heating = EFFECT_BIT(EFFECT_HEATING);
    struct contact_point hot = apply(&joint, heating, point_of(0.04, NAN));
    assert_near(hot.value[QUANTITY_VOLTAGE], 500 * 2e-10 / 2e-6, 1e-14);
    assert_near(pow(hot.value[QUANTITY_TEMPERATURE], 2), 300. * 300 + pow(0.05, 2) / (4 * heating_lorenz_number()),
                1e-13);
    assert_near(applied(&joint, heating | EFFECT_BIT(EFFECT_FILM), 0.04, NAN, QUANTITY_VOLTAGE),
                500 * (2e-10 + 1e-12 / 0.04) / 2e-6, 1e-14);
    joint.temperature_K = 400;
    assert_near(pow(applied(&joint, heating, 0.04, NAN, QUANTITY_TEMPERATURE), 2),
                400. * 400 + pow(0.05, 2) / (4 * heating_lorenz_number()), 1e-13);
    joint.current_A = 1e-12;
    assert_near(applied(&joint, heating, 0.04, NAN, QUANTITY_TEMPERATURE), 400, 1e-15);
}
