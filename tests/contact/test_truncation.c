/* SPDX-License-Identifier: GPL-3.0-or-later */
/* CMY, Mikic and Sridhar-Yovanovich against tests/data/golden/models/truncation.csv, their correlations within the
 * ranges stated, and their limits. */
#include "contact/cmy.h"
#include "contact/sridhar_yovanovich.h"
#include "support.h"

static const double tin_resistivity = 11.5e-8, tin_flow_Pa = 14e6;

static struct truncation law_of(const struct table *table, size_t i)
{
    const char *model = table_text(table, i, "model");
    double sigma_m = table_number(table, i, "sigma_m"), slope = table_number(table, i, "slope_mean_abs");
    double hardness_Pa = table_number(table, i, "hardness_Pa"), modulus_Pa = table_number(table, i, "Ep_Pa");
    if (strcmp(model, "cmy") == 0)
        return cmy_plastic(sigma_m, slope, hardness_Pa);
    if (strcmp(model, "mikic") == 0)
        return cmy_elastic(sigma_m, slope, modulus_Pa);
    assert_string_equal(model, "sridhar-yovanovich");
    /* the flow stress of aluminium is not listed: from H_ep = 2.76 S_f/[1 + (6.5/e)²]^(1/2), e = 1.67 E' m/S_f, with
     * c = 6.5/(1.67 E' m): S_f² (2.76² - H² c²) = H² */
    double c = 6.5 / (1.67 * modulus_Pa * slope);
    double flow_Pa = strcmp(table_text(table, i, "set"), "tin") == 0
                         ? tin_flow_Pa
                         : hardness_Pa / sqrt(2.76 * 2.76 - hardness_Pa * hardness_Pa * c * c);
    return sridhar_yovanovich(sigma_m, slope, modulus_Pa, flow_Pa);
}

TEST_CASE(matches_reference)
{
    struct table table = table_read("golden/models/truncation.csv");
    for (size_t i = 0; i < table.rows; i++) {
        struct truncation law = law_of(&table, i);
        assert_near(law.hardness_Pa, table_number(&table, i, "hardness_Pa"), 1e-12);
        assert_near(law.fraction, table_number(&table, i, "f_ep"), 1e-12);
        double load = table_number(&table, i, "load_over_AnEp");
        double ratio = load * table_number(&table, i, "Ep_Pa") / law.hardness_Pa;
        assert_near(ratio, table_number(&table, i, "P_over_H"), 1e-12);
        struct truncation_contact contact;
        assert_true(truncation_press(&contact, &law, ratio));
        assert_near(contact.separation_over_sigma, table_number(&table, i, "separation_over_sigma"), 1e-10);
        assert_near(contact.area_ratio, table_number(&table, i, "area_ratio"), 1e-10);
        assert_near(contact.spot_density_per_m2, table_number(&table, i, "spot_density_per_m2"), 1e-10);
        assert_near(contact.spot_radius_m, table_number(&table, i, "spot_radius_m"), 1e-10);
        assert_near(contact.conductance, table_number(&table, i, "h_sigma_over_km"), 1e-10);
        bool tin = strcmp(table_text(&table, i, "set"), "tin") == 0;
        assert_near(truncation_resistance(&law, &contact, tin ? tin_resistivity : 2.65e-8),
                    table_number(&table, i, "ecr_ohm_m2"), 1e-10);
        assert_near(1 / truncation_resistance(&law, &contact, 1 / (tin ? 66.8 : 237)),
                    table_number(&table, i, "h_W_per_m2K"), 1e-10);
        const char *model = table_text(&table, i, "model");
        if (strcmp(model, "cmy") == 0)
            assert_near(cmy_plastic_correlation(ratio), table_number(&table, i, "correlation"), 1e-12);
        if (strcmp(model, "mikic") == 0)
            assert_near(cmy_elastic_correlation(ratio), table_number(&table, i, "correlation"), 1e-12);
    }
    table_free(&table);
}

/** The ranges that the headers state. */
TEST_CASE(correlations_stay_in_their_range)
{
    struct truncation plastic = cmy_plastic(1e-6, 0.1, 1e9), elastic = cmy_elastic(1e-6, 0.1, 1e11);
    struct truncation_contact contact;
    for (double ratio = 1.2e-4; ratio < 2e-2; ratio *= 1.1) {
        assert_true(truncation_press(&contact, &plastic, ratio));
        double over = cmy_plastic_correlation(ratio) / contact.conductance;
        assert_true(over > 0.9865 && over < 1.0105);
    }
    for (double ratio = 3.5e-6; ratio < 0.2; ratio *= 1.2) {
        assert_true(truncation_press(&contact, &elastic, ratio));
        assert_near(cmy_elastic_correlation(ratio), contact.conductance, 0.027);
    }
    static const double strains[] = {0.1, 1, 4.9, 5.1, 20, 100, 1e4};
    for (size_t s = 0; s < sizeof strains / sizeof strains[0]; s++) {
        struct truncation law = sridhar_yovanovich(1e-6, 0.1, 1e11, 1.67 * 1e11 * 0.1 / strains[s]);
        assert_near(sridhar_yovanovich_strain(1e11, 1.67 * 1e11 * 0.1 / strains[s], 0.1), strains[s], 1e-14);
        for (double ratio = 1e-5; ratio < 1e-2; ratio *= 1.5) {
            assert_true(truncation_press(&contact, &law, ratio));
            assert_near(sridhar_yovanovich_correlation(ratio, strains[s]), contact.conductance, 0.04);
        }
    }
}

/** Elastoplastic to plastic for large strain, near elastic for small; h = 2 n a k/Psi; the mean area of the spots. */
TEST_CASE(limits)
{
    struct truncation hard = sridhar_yovanovich(1e-6, 0.1, 1e14, 1e3);
    assert_near(hard.fraction, 1, 1e-8);
    assert_near(hard.hardness_Pa, 2.76e3, 1e-10);
    struct truncation soft = sridhar_yovanovich(1e-6, 0.1, 1e6, 1e14);
    assert_near(soft.fraction, 0.5, 1e-6);
    assert_near(soft.hardness_Pa, cmy_elastic(1e-6, 0.1, 1e6).hardness_Pa, 0.003);
    assert_near(truncation_slope(2.5e-3), 0.0398942280401432678, 1e-15);
    for (int law = 0; law < 2; law++) {
        struct truncation of = law == 0 ? cmy_plastic(2e-6, 0.2, 1e9) : cmy_elastic(2e-6, 0.2, 1e11);
        for (double ratio = 1e-8; ratio < 0.4; ratio *= 2) {
            struct truncation_contact contact;
            assert_true(truncation_press(&contact, &of, ratio));
            double psi = pow(1 - sqrt(ratio), 1.5);
            assert_near(2 * contact.spot_density_per_m2 * contact.spot_radius_m / psi * 2e-6 / 0.2, contact.conductance,
                        1e-12);
            assert_near(contact.spot_density_per_m2 * M_PI * contact.spot_radius_m * contact.spot_radius_m,
                        contact.area_ratio, 1e-12);
        }
    }
}

/** No load, all truncated or more: refused; the faintest load: finite; area 1 of the plastic law is never reached. */
TEST_CASE(hard_cases)
{
    struct truncation plastic = cmy_plastic(1e-6, 0.1, 1e9), elastic = cmy_elastic(1e-6, 0.1, 1e11);
    struct truncation_contact contact;
    assert_false(truncation_press(&contact, &plastic, 0));
    assert_false(truncation_press(&contact, &plastic, 1));
    assert_false(truncation_press(&contact, &plastic, NAN));
    assert_false(truncation_press(&contact, &elastic, 0.5));
    assert_true(truncation_press(&contact, &elastic, 0.4999));
    double conductance = 0, separation = INFINITY;
    for (double ratio = 1e-300; ratio < 1; ratio *= 1.4) {
        assert_true(truncation_press(&contact, &plastic, ratio));
        assert_true(isfinite(contact.spot_density_per_m2) && isfinite(contact.spot_radius_m));
        assert_true(contact.conductance > conductance && contact.separation_over_sigma < separation);
        conductance = contact.conductance;
        separation = contact.separation_over_sigma;
    }
}

/** Constant hardness (c2 = 0) is that hardness; else the hardness belongs to the spots at that hardness, and Song and
 * Yovanovich's explicit fit is near: P/H = [P/(c1 (1.62 sigma/m)^c2)]^(1/(1+0.071 c2)), sigma in um. */
TEST_CASE(microhardness)
{
    assert_near(cmy_microhardness(1e-6, 0.1, 1e6, 3e9, 0), 3e9, 1e-12);
    double c1 = 6.304e9, c2 = -0.264;
    for (double pressure = 1e4; pressure < 1e8; pressure *= 10) {
        double hardness = cmy_microhardness(1e-6, 0.1, pressure, c1, c2);
        struct truncation law = cmy_plastic(1e-6, 0.1, hardness);
        struct truncation_contact contact;
        assert_true(truncation_press(&contact, &law, pressure / hardness));
        assert_near(c1 * pow(sqrt(2 * M_PI) * contact.spot_radius_m / 1e-6, c2), hardness, 1e-10);
        assert_near(pow(pressure / (c1 * pow(1.62 * 1 / 0.1, c2)), 1 / (1 + 0.071 * c2)), pressure / hardness, 0.02);
    }
    assert_true(isnan(cmy_microhardness(1e-6, 0.1, 1e11, c1, c2)));
}
