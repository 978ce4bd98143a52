/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Plastic truncation against tests/data/golden/models, as a law and as a run calls it, and its limits. */
#include "contact/cmy.h"
#include "members/curve_summary.h"
#include "model_support.h"

/** One wave with that rms height and mean absolute slope of Gaussian heights: m2 = (pi/2) m². */
static struct spectrum wave(double sigma_m, double slope)
{
    struct spectrum spectrum = model_support_law(1, 0, 0, 1);
    spectrum.amplitude_m[0] = M_SQRT2 * sigma_m;
    spectrum.length_m = 2 * M_PI * sigma_m / (sqrt(M_PI / 2) * slope);
    return spectrum;
}

TEST_CASE(matches_the_reference)
{
    struct table table = table_read("golden/models/cmy.csv");
    size_t below = 0;
    for (size_t i = 0; i < table.rows; i++) {
        bool tin = strcmp(table_text(&table, i, "set"), "tin") == 0;
        double sigma_m = table_number(&table, i, "sigma_m"), slope = table_number(&table, i, "slope_mean_abs");
        double load = table_number(&table, i, "load_over_AnEp");
        struct material_pair pair = {.effective_modulus_Pa = table_number(&table, i, "Ep_Pa"),
                                     .resistivity_ohm_m = tin ? 11.5e-8 : 2.65e-8,
                                     .conductivity_W_per_mK = tin ? 66.8 : 237};
        struct cmy_contact contact;
        assert_true(cmy_press(&contact, &(struct cmy){sigma_m, slope}, table_number(&table, i, "P_over_H")));
        double separation = table_number(&table, i, "separation_over_sigma");
        assert_near(contact.separation_over_sigma, separation, 1e-10);
        assert_near(contact.conductance, table_number(&table, i, "h_sigma_over_km"), 1e-10);
        struct spectrum spectrum = wave(sigma_m, slope);
        struct model_task task = model_support_task(&spectrum, &pair, &load, 1);
        task.hardness_Pa = table_number(&table, i, "hardness_Pa");
        struct contact_point point[2];
        struct contact_spots spots;
        assert_true(model_support_run(point, "cmy", &task).exists);
        model_support_spots(&spots, "cmy", &task);
        assert_near(point->value[QUANTITY_AREA], table_number(&table, i, "area_ratio"), 1e-10);
        assert_same_number(point->value[QUANTITY_SEPARATION] / sigma_m, separation >= 0 ? separation : NAN, 1e-10);
        assert_near(point->value[QUANTITY_ECR], table_number(&table, i, "ecr_ohm_m2"), 1e-10);
        assert_near(1 / point->value[QUANTITY_TCR], table_number(&table, i, "h_W_per_m2K"), 1e-10);
        assert_near(spots.density_per_m2, table_number(&table, i, "spot_density_per_m2"), 1e-10);
        assert_near(spots.radius_m, table_number(&table, i, "spot_radius_m"), 1e-10);
        below += separation < 0; /* the mean plane: no gap is left to speak of */
    }
    assert_true(below > 0 && table.rows > 20);
}

/** h = 2 n a k/Psi and the spots are the area; the handbook's 1.25 (P/H)^0.95 is 0.987...1.010 of the closed form for
 * 1.2e-4 < P/H < 2e-2, and 6 % less at 0.07 (Yovanovich 1981). */
TEST_CASE(identities)
{
    const struct cmy surface = {2e-6, 0.2};
    struct cmy_contact contact;
    for (double ratio = 1e-8; ratio < 0.4; ratio *= 2) {
        assert_true(cmy_press(&contact, &surface, ratio));
        double psi = pow(1 - sqrt(ratio), 1.5);
        assert_near(2 * contact.spot_density_per_m2 * contact.spot_radius_m / psi * 2e-6 / 0.2, contact.conductance,
                    1e-12);
        assert_near(contact.spot_density_per_m2 * M_PI * contact.spot_radius_m * contact.spot_radius_m, ratio, 1e-12);
    }
    for (double ratio = 1.2e-4; ratio < 2e-2; ratio *= 1.1) {
        assert_true(cmy_press(&contact, &surface, ratio));
        double over = 1.25 * pow(ratio, 0.95) / contact.conductance;
        assert_true(over > 0.9865 && over < 1.0105);
    }
    assert_true(cmy_press(&contact, &surface, 0.07));
    assert_within(1.25 * pow(0.07, 0.95) / contact.conductance, 0.94, 0.005);
    assert_near(cmy_slope(2.5e-3), 0.0398942280401432678, 1e-15);
}

/** No load, all truncated or more: refused; the faintest load: finite. */
TEST_CASE(hard_cases)
{
    const struct cmy surface = {1e-6, 0.1};
    struct cmy_contact contact;
    assert_false(cmy_press(&contact, &surface, 0));
    assert_false(cmy_press(&contact, &surface, 1));
    assert_false(cmy_press(&contact, &surface, NAN));
    double conductance = 0, separation = INFINITY;
    for (double ratio = 1e-300; ratio < 1; ratio *= 1.4) {
        assert_true(cmy_press(&contact, &surface, ratio));
        assert_true(isfinite(contact.spot_density_per_m2) && isfinite(contact.spot_radius_m));
        assert_true(contact.conductance > conductance && contact.separation_over_sigma < separation);
        conductance = contact.conductance;
        separation = contact.separation_over_sigma;
    }
}

/** At each load P = H A/A_n with the hardness of that load's spots; what raises the task's hardness raises that of
 * every size. */
TEST_CASE(hardness_of_the_spots_own_size)
{
    struct spectrum spectrum = wave(1e-6, 0.1);
    struct material_pair pair = model_support_tin();
    const double loads[] = {1e-6, 1e-5, 1e-4};
    struct model_task task = model_support_task(&spectrum, &pair, loads, 3);
    struct contact_point points[4], raised[4];
    struct contact_spots spots[3];
    pair.hardness_Pa = task.hardness_Pa;
    pair.vickers_Pa = pair.hardness_Pa;
    pair.vickers_exponent = -0.2;
    model_support_run(points, "cmy", &task);
    model_support_spots(spots, "cmy", &task);
    for (size_t i = 0; i < 3; i++) {
        double hardness_Pa = pair.vickers_Pa * pow(sqrt(2 * M_PI) * spots[i].radius_m / 1e-6, -0.2);
        assert_near(points[i].value[QUANTITY_AREA], loads[i] * pair.effective_modulus_Pa / hardness_Pa, 1e-10);
    }
    assert_true(spots[2].radius_m > 1.1 * spots[0].radius_m);
    task.hardness_Pa *= 1.2;
    model_support_run(raised, "cmy", &task);
    pair.vickers_Pa *= 1.2;
    pair.hardness_Pa *= 1.2;
    model_support_run(points, "cmy", &task);
    assert_near(raised[1].value[QUANTITY_AREA], points[1].value[QUANTITY_AREA], 1e-15);
}

/** To P = H and no further, with the hardness that it is given; outside the stated range from A/A_n = 0.1 on. */
TEST_CASE(the_curve_ends)
{
    const struct model_row *row = model_rows[model_named("cmy")];
    struct spectrum spectrum = model_support_law(3e-4, 0.085, 1.5, 256);
    struct material_pair pair = model_support_tin();
    double load[MODEL_LOADS];
    struct contact_point points[MODEL_LOADS + 1];
    struct contact_spots spots[MODEL_LOADS];
    model_support_loads(load, MODEL_LOADS, 1e-7, 1e-2);
    struct model_task task = model_support_task(&spectrum, &pair, load, MODEL_LOADS);
    struct model_curve curve = model_support_run(points, "cmy", &task);
    assert_true(curve.exists && curve.count > 4 && curve.count < MODEL_LOADS);
    assert_true(load[curve.count] * pair.effective_modulus_Pa >= task.hardness_Pa);
    assert_true(isnan(curve.full_load) && isnan(curve.full.value[QUANTITY_AREA]) && isnan(curve.beta));
    struct curve_validity valid = curve_summary_validity(&curve, row);
    assert_true(valid.first == 0 && valid.end > 0 && valid.end < curve.count);
    assert_true(points[valid.end - 1].value[QUANTITY_AREA] <= 0.1 && points[valid.end].value[QUANTITY_AREA] > 0.1);
    model_support_spots(spots, "cmy", &task);
    for (size_t i = 0; i < curve.count; i++) {
        assert_near(points[i].value[QUANTITY_AREA], load[i] * pair.effective_modulus_Pa / task.hardness_Pa, 1e-14);
        assert_true(isnan(points[i].value[QUANTITY_TCR_SCALE_DEPENDENT]));
    }
    for (size_t i = curve.count; i < MODEL_LOADS; i++)
        assert_true(isnan(spots[i].density_per_m2) && isnan(spots[i].radius_m));
    task.wanted = QUANTITY_BIT(QUANTITY_AREA);
    model_support_run(points, "cmy", &task);
    assert_true(isnan(points->value[QUANTITY_SEPARATION]) && isnan(points->value[QUANTITY_ECR]));
    task.hardness_Pa = NAN;
    assert_false(model_support_run(points, "cmy", &task).exists);
    task.hardness_Pa = 1e9;
    for (size_t n = 0; n < spectrum.count; n++)
        spectrum.amplitude_m[n] = 0;
    assert_false(model_support_run(points, "cmy", &task).exists);
}

/** Constant hardness (c2 = 0) is that hardness; else the hardness belongs to the spots at that hardness, and Song and
 * Yovanovich's explicit fit is near: P/H = [P/(c1 (1.62 sigma/m)^c2)]^(1/(1+0.071 c2)), sigma in um. */
TEST_CASE(microhardness)
{
    const struct cmy surface = {1e-6, 0.1};
    assert_near(cmy_microhardness(&surface, 1e6, 3e9, 0), 3e9, 1e-12);
    double c1 = 6.304e9, c2 = -0.264;
    for (double pressure = 1e4; pressure < 1e8; pressure *= 10) {
        double hardness = cmy_microhardness(&surface, pressure, c1, c2);
        struct cmy_contact contact;
        assert_true(cmy_press(&contact, &surface, pressure / hardness));
        assert_near(c1 * pow(sqrt(2 * M_PI) * contact.spot_radius_m / 1e-6, c2), hardness, 1e-10);
        assert_near(pow(pressure / (c1 * pow(1.62 * 1 / 0.1, c2)), 1 / (1 + 0.071 * c2)), pressure / hardness, 0.02);
    }
    assert_true(isnan(cmy_microhardness(&surface, 1e11, c1, c2)));
}
