/* SPDX-License-Identifier: GPL-3.0-or-later */
/* CMY and Sridhar-Yovanovich as a run calls them, against tests/data/golden/models, and their limits; Mikic's closed
 * form, which only its correlation needs. */
#include "analysis/curve_summary.h"
#include "contact/cmy.h"
#include "contact/sridhar_yovanovich.h"
#include "contact/truncation_model.h"
#include "model_support.h"

/** One wave with that rms height and mean absolute slope of Gaussian heights: m2 = (pi/2) m². To be freed. */
static struct spectrum wave(double sigma_m, double slope)
{
    struct spectrum spectrum = model_support_law(1, 0, 0, 1);
    spectrum.amplitude_m[0] = M_SQRT2 * sigma_m;
    spectrum.length_m = 2 * M_PI * sigma_m / (sqrt(M_PI / 2) * slope);
    return spectrum;
}

static struct model_task task_of(const struct spectrum *spectrum, const struct material_pair *pair, const double *loads,
                                 size_t count)
{
    return (struct model_task){.spectrum = spectrum,
                               .pair = pair,
                               .loads = loads,
                               .load_count = count,
                               .wanted = MODEL_EVERYTHING,
                               .tolerance = 1e-8,
                               .hardness_Pa = material_hardness_ratio * pair->yield_strength_Pa};
}

static void spots_of(struct contact_spots *spots, const char *model, const struct model_task *task)
{
    const struct model_row *row = model_rows[model_named(model)];
    struct status status = {0};
    assert_non_null(row->spots);
    assert_int_equal(row->spots(spots, row, task, &status), STATUS_OK);
}

/** Flow stress behind a listed H_ep = 2.76 S_f/[1 + (6.5/e)²]^(1/2), e = 1.67 E' m/S_f. */
static double flow_of(double hardness_Pa, double modulus_Pa, double slope)
{
    double c = 6.5 / (1.67 * modulus_Pa * slope);
    return hardness_Pa / sqrt(2.76 * 2.76 - hardness_Pa * hardness_Pa * c * c);
}

TEST_CASE(the_rows_match_the_reference)
{
    struct table table = table_read("golden/models/truncation.csv");
    size_t held = 0, below = 0;
    for (size_t i = 0; i < table.rows; i++) {
        const char *model = table_text(&table, i, "model");
        bool tin = strcmp(table_text(&table, i, "set"), "tin") == 0, cmy = strcmp(model, "cmy") == 0;
        double sigma_m = table_number(&table, i, "sigma_m"), slope = table_number(&table, i, "slope_mean_abs");
        double load = table_number(&table, i, "load_over_AnEp"), hardness_Pa = table_number(&table, i, "hardness_Pa");
        if (strcmp(model, "mikic") == 0)
            continue;
        struct material_pair pair = {.effective_modulus_Pa = table_number(&table, i, "Ep_Pa"),
                                     .resistivity_ohm_m = tin ? 11.5e-8 : 2.65e-8,
                                     .conductivity_W_per_mK = tin ? 66.8 : 237};
        pair.yield_strength_Pa = cmy ? 1 : flow_of(hardness_Pa, pair.effective_modulus_Pa, slope);
        struct spectrum spectrum = wave(sigma_m, slope);
        struct model_task task = task_of(&spectrum, &pair, &load, 1);
        task.hardness_Pa = cmy ? hardness_Pa : 1;
        struct contact_point point[2];
        struct contact_spots spots;
        assert_true(model_support_run(point, model, &task).exists);
        spots_of(&spots, model, &task);
        assert_near(point->value[QUANTITY_AREA], table_number(&table, i, "area_ratio"), 1e-10);
        double separation = table_number(&table, i, "separation_over_sigma");
        assert_same_number(point->value[QUANTITY_SEPARATION] / sigma_m, separation >= 0 ? separation : NAN, 1e-10);
        assert_near(point->value[QUANTITY_ECR], table_number(&table, i, "ecr_ohm_m2"), 1e-10);
        assert_near(1 / point->value[QUANTITY_TCR], table_number(&table, i, "h_W_per_m2K"), 1e-10);
        assert_near(spots.density_per_m2, table_number(&table, i, "spot_density_per_m2"), 1e-10);
        assert_near(spots.radius_m, table_number(&table, i, "spot_radius_m"), 1e-10);
        spectrum_free(&spectrum);
        below += separation < 0; /* the mean plane: no gap is left to speak of */
        held++;
    }
    assert_int_equal(held, 75);
    assert_true(below > 0);
    table_free(&table);
}

/** The force that brings tin's ECR on 1 mm² down to a target, and the spots there: 1 mohm takes 40.5 mN, by 9.1 spots
 * of 6.0 um. */
TEST_CASE(forces_for_a_target)
{
    struct table table = table_read("golden/models/answers_tin_cmy.csv");
    struct material_pair pair = model_support_tin();
    struct spectrum spectrum = wave(sqrt(4e-13), truncation_slope(2.5e-3));
    for (size_t i = 0; i < table.rows; i++) {
        double area_m2 = table_number(&table, i, "nominal_area_m2");
        double load = table_number(&table, i, "force_N") / (area_m2 * pair.effective_modulus_Pa);
        struct model_task task = task_of(&spectrum, &pair, &load, 1);
        task.hardness_Pa = 2.8 * pair.yield_strength_Pa;
        struct contact_point point[2];
        struct contact_spots spots;
        model_support_run(point, "cmy", &task);
        spots_of(&spots, "cmy", &task);
        assert_near(point->value[QUANTITY_ECR] / area_m2, table_number(&table, i, "target_ohm"), 1e-10);
        assert_near(1 / point->value[QUANTITY_TCR], table_number(&table, i, "h_W_per_m2K"), 1e-10);
        assert_near(spots.density_per_m2 * area_m2, table_number(&table, i, "spots"), 1e-10);
        assert_near(spots.radius_m, table_number(&table, i, "spot_radius_m"), 1e-10);
        if (table_number(&table, i, "target_ohm") == 1e-3) {
            assert_within(load * pair.effective_modulus_Pa * area_m2, 40.5e-3, 0.05e-3);
            assert_within(spots.density_per_m2 * area_m2, 9.1, 0.05);
            assert_within(spots.radius_m, 6.0e-6, 0.05e-6);
        }
    }
    spectrum_free(&spectrum);
    table_free(&table);
}

/** To P/H = f and no further; outside the stated range from A/A_n = P/H = 0.1 on. */
TEST_CASE(the_curve_ends_and_is_marked)
{
    static const char *const names[] = {"cmy", "sridhar-yovanovich"};
    struct spectrum spectrum = model_support_law(3e-4, 0.085, 1.5, 256);
    struct material_pair pair = model_support_tin();
    double load[MODEL_LOADS];
    struct contact_point points[MODEL_LOADS + 1];
    struct contact_spots spots[MODEL_LOADS];
    model_support_loads(load, MODEL_LOADS, 1e-7, 1e-2);
    struct model_task task = task_of(&spectrum, &pair, load, MODEL_LOADS);
    for (int n = 0; n < 2; n++) {
        const struct model_row *row = model_rows[model_named(names[n])];
        struct truncation law = row->truncation_model->law(&task);
        struct model_curve curve = model_support_run(points, names[n], &task);
        assert_true(curve.exists && curve.count > 4 && curve.count < MODEL_LOADS);
        double last = truncation_model_ratio(&law, &task, load[curve.count - 1]),
               next = truncation_model_ratio(&law, &task, load[curve.count]);
        assert_true(last < law.fraction && next >= law.fraction);
        assert_true(isnan(curve.full_load) && isnan(curve.full.value[QUANTITY_AREA]) && isnan(curve.beta));
        struct curve_validity valid = curve_summary_validity(&curve, row);
        assert_true(valid.first == 0 && valid.end > 0 && valid.end < curve.count);
        assert_true(points[valid.end - 1].value[QUANTITY_AREA] <= 0.1 && points[valid.end].value[QUANTITY_AREA] > 0.1);
        spots_of(spots, names[n], &task);
        for (size_t i = 0; i < curve.count; i++) {
            assert_near(points[i].value[QUANTITY_AREA], load[i] * pair.effective_modulus_Pa / law.hardness_Pa, 1e-14);
            assert_true(isnan(points[i].value[QUANTITY_ADJUSTED]) &&
                        isnan(points[i].value[QUANTITY_TCR_SCALE_DEPENDENT]));
            assert_near(spots[i].density_per_m2 * M_PI * spots[i].radius_m * spots[i].radius_m,
                        points[i].value[QUANTITY_AREA], 1e-12); /* the spots are the area */
        }
        for (size_t i = curve.count; i < MODEL_LOADS; i++)
            assert_true(isnan(spots[i].density_per_m2) && isnan(spots[i].radius_m));
        task.wanted = QUANTITY_BIT(QUANTITY_AREA);
        model_support_run(points, names[n], &task);
        assert_true(isnan(points->value[QUANTITY_SEPARATION]) && isnan(points->value[QUANTITY_ECR]) &&
                    isnan(points->value[QUANTITY_TCR]));
        task.wanted = MODEL_EVERYTHING;
    }
    spectrum_free(&spectrum);
}

/** CMY has the hardness it is given; Sridhar and Yovanovich's that of the yield strength: CMY's with 2.76 S_y where
 * plastic, Mikic's where elastic. */
TEST_CASE(hardness_and_limits)
{
    struct spectrum spectrum = wave(1e-6, 0.1);
    struct material_pair pair = model_support_tin();
    double load = 1e-5;
    struct contact_point cmy[2], other[2];
    struct model_task task = task_of(&spectrum, &pair, &load, 1);
    model_support_run(cmy, "cmy", &task);
    assert_near(cmy->value[QUANTITY_AREA], load * pair.effective_modulus_Pa / (2.84 * pair.yield_strength_Pa), 1e-14);
    task.hardness_Pa *= 2;
    model_support_run(other, "cmy", &task);
    assert_near(other->value[QUANTITY_AREA], cmy->value[QUANTITY_AREA] / 2, 1e-14);
    model_support_run(cmy, "sridhar-yovanovich", &task);
    task.hardness_Pa = NAN;
    assert_false(model_support_run(other, "cmy", &task).exists);
    assert_true(model_support_run(other, "sridhar-yovanovich", &task).exists);
    assert_near(other->value[QUANTITY_ECR], cmy->value[QUANTITY_ECR], 0);

    pair.yield_strength_Pa = 1e4; /* e = 8e5 */
    load = 1e-9;
    task.hardness_Pa = 2.76e4;
    model_support_run(cmy, "cmy", &task);
    model_support_run(other, "sridhar-yovanovich", &task);
    assert_near(other->value[QUANTITY_AREA], cmy->value[QUANTITY_AREA], 1e-5);
    assert_near(other->value[QUANTITY_ECR], cmy->value[QUANTITY_ECR], 1e-5);
    assert_near(other->value[QUANTITY_SEPARATION], cmy->value[QUANTITY_SEPARATION], 1e-5);

    pair.yield_strength_Pa = 1e16; /* e = 8e-7: 0.7091 m E' for Mikic's 0.7071 */
    load = 1e-4;
    model_support_run(other, "sridhar-yovanovich", &task);
    struct truncation elastic = truncation_model_elastic.law(&task);
    struct truncation_contact contact;
    assert_true(truncation_press(&contact, &elastic, truncation_model_ratio(&elastic, &task, load)));
    assert_near(other->value[QUANTITY_AREA], contact.area_ratio, 0.004);
    assert_near(other->value[QUANTITY_ECR], truncation_resistance(&elastic, &contact, pair.resistivity_ohm_m), 0.004);
    /* A = sqrt(pi/m2) p, whatever the modulus: BGT's asymptote */
    assert_near(contact.area_ratio, sqrt(M_PI / spectrum_moment(&spectrum, 1)) * load, 1e-12);

    pair.yield_strength_Pa = NAN; /* not known */
    assert_false(model_support_run(other, "sridhar-yovanovich", &task).exists);
    spectrum.amplitude_m[0] = 0; /* flat */
    assert_false(model_support_run(other, "cmy", &task).exists);
    spectrum_free(&spectrum);
}

/** The correlations are those of the literature, within what is stated of them where they are said to be tested, and
 * the ends of that are where they are said to be. */
TEST_CASE(correlations_keep_what_is_stated)
{
    struct spectrum spectrum = wave(1e-6, 0.1);
    struct material_pair pair = model_support_tin();
    double load = 1e-5;
    struct model_task task = task_of(&spectrum, &pair, &load, 1);
    static const char *const names[] = {"cmy", "sridhar-yovanovich", NULL};
    static const double low[] = {0.987, 0.96, 1 - 0.027}, high[] = {1.010, 1.04, 1 + 0.027};
    for (int n = 0; n < 3; n++) {
        const struct truncation_model *model =
            names[n] ? model_rows[model_named(names[n])]->truncation_model : &truncation_model_elastic;
        struct truncation law = model->law(&task);
        for (double ratio = model->least; ratio <= model->most; ratio *= 1.05) {
            struct truncation_contact contact;
            assert_true(truncation_model_tested(model, ratio));
            assert_true(truncation_press(&contact, &law, ratio));
            double over = model->correlation(ratio, &task) / contact.conductance;
            assert_true(over > low[n] - 5e-4 && over < high[n] + 5e-4);
        }
        assert_false(truncation_model_tested(model, model->least * 0.99));
        assert_false(truncation_model_tested(model, model->most * 1.01));
        assert_false(truncation_model_tested(model, NAN));
    }
    const struct truncation_model *plastic = model_rows[model_named("cmy")]->truncation_model;
    assert_near(plastic->correlation(1e-3, &task), 1.25 * pow(1e-3, 0.95), 1e-14);
    double pressure_Pa = load * pair.effective_modulus_Pa;
    struct truncation elastic = truncation_model_elastic.law(&task);
    assert_near(truncation_model_elastic.correlation(truncation_model_ratio(&elastic, &task, load), &task),
                1.55 * pow(M_SQRT2 * pressure_Pa / (pair.effective_modulus_Pa * 0.1), 0.94), 1e-12);
    struct truncation_contact contact;
    struct truncation law = plastic->law(&task);
    assert_true(truncation_press(&contact, &law, 0.07));
    assert_within(plastic->correlation(0.07, &task) / contact.conductance, 0.94, 0.005); /* "6 % less" */
    spectrum_free(&spectrum);
}

/** Constants that nobody here could read up are said to be so wherever the model is listed, and neither model runs
 * unasked or stands for the thesis. */
TEST_CASE(what_the_rows_say)
{
    const struct model_row *cmy = model_rows[model_named("cmy")], *sy = model_rows[model_named("sridhar-yovanovich")];
    assert_non_null(strstr(sy->source, "not seen in a readable source"));
    assert_non_null(strstr(sy->truncation_model->agreement, "not seen in a readable source"));
    assert_null(strstr(cmy->source, "not seen"));
    for (int n = 0; n < 2; n++) {
        const struct model_row *row = n ? sy : cmy;
        assert_false(row->by_default || row->in_findings || row->thesis_place > 0);
        assert_true(row->plastic && row->largest_area == 0.1);
        assert_non_null(strstr(row->valid, "Gaussian"));
        assert_non_null(strstr(row->valid, "first loading"));
        assert_int_equal(model_find(row->name), MODEL_BIT(model_index(row)));
        assert_false(model_defaults() & MODEL_BIT(model_index(row)));
    }
}
