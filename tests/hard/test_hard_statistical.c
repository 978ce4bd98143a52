/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The statistical models far out: heights from 37 sigma_s down to -60, every Nayak parameter, every material. */
#include "contact/gaussian.h"
#include "hard_support.h"

HARD_CASES("Statistical models, from 1e-300 of a load to complete contact")

static struct statistical make(const struct asperities *surface, const struct material_pair *pair, bool plastic,
                               double lowest)
{
    return model_support_statistical(surface, pair, plastic, 1e-10, lowest);
}

/** Area and load to 1e-9 though they are 1e-300, ratios of the integrals to 1e-10. */
TEST_CASE(matches_reference_far_out)
{
    struct table table = table_read("hard/statistical_extreme.csv");
    struct material_pair pair = model_support_tin();
    assert_int_equal(table.rows, 48);
    for (size_t i = 0; i < table.rows; i++) {
        struct asperities surface = model_support_asperities(
            table_number(&table, i, "m0_m2"), table_number(&table, i, "m2"), table_number(&table, i, "m4_per_m2"));
        double d = table_number(&table, i, "d_over_sigma_s");
        bool plastic = strcmp(table_text(&table, i, "model"), "jg") == 0;
        struct statistical model = make(&surface, &pair, plastic, fmin(d, 0));
        struct contact_point point;
        statistical_at(&point, &model, d);
        double area = table_number(&table, i, "area_ratio");
        hard_case("planes 37 σ_s above the mean to 60 below: areas of 1e-300", "the tail of the heights underflows",
                  "integrals keep a factor e^-d² apart: the numbers of 30 digits", "area, relative",
                  off_by(point.value[QUANTITY_AREA], area), 1e-9);
        assert_near(point.value[QUANTITY_LOAD], table_number(&table, i, "load_over_AnEp"), 1e-9);
        hard_case("the same: pressure in the contacts", "1e-300 over 1e-300", "their ratio keeps its digits",
                  "load over area, relative",
                  off_by(point.value[QUANTITY_LOAD] / point.value[QUANTITY_AREA] * pair.effective_modulus_Pa,
                         table_number(&table, i, "load_over_area_Pa")),
                  1e-10);
        if (area < 1) { /* Psi depends on 1 - A/A_n, whose relative error is that of A over it */
            double allowed = 1e-10 * (1 + 1 / (1 - area));
            assert_near(point.value[QUANTITY_ECR], table_number(&table, i, "ecr_ohm_m2"), allowed);
            assert_near(point.value[QUANTITY_TCR], table_number(&table, i, "tcr_K_m2_per_W"), allowed);
            assert_near(point.value[QUANTITY_TCR_SCALE_DEPENDENT], table_number(&table, i, "tcr_sd_K_m2_per_W"),
                        allowed);
            double psi = constriction_alleviation(area, 1 - area);
            assert_near(psi * pair.resistivity_ohm_m / (2 * point.value[QUANTITY_ECR] * point.value[QUANTITY_AREA]),
                        table_number(&table, i, "radius_over_area_per_m"), allowed);
        } else {
            hard_case("planes below the one where A = A_n (D → 0)", "areas above all there is, negative resistance",
                      "complete contact: no resistance", "resistances",
                      point.value[QUANTITY_ECR] + point.value[QUANTITY_TCR] + point.value[QUANTITY_TCR_SCALE_DEPENDENT],
                      0);
        }
    }
}

/** Loads from 1e-100 (and the ends of the curve) must come back, with everything bounded and monotone. */
static void check_curve(const struct statistical *model)
{
    struct contact_point point, again,
        before = {.value[QUANTITY_SEPARATION] = INFINITY, .value[QUANTITY_ECR] = INFINITY};
    double d = 3, last = model->full_load * (1 - 1e-9);
    for (double load = fmin(1e-100, last); load <= last; load = load * 1e5 < last || load == last ? load * 1e5 : last) {
        assert_true(statistical_solve(&point, model, load, &d));
        statistical_at(&again, model, d);
        hard_case("loads from 1e-100 A_n E' to complete contact, Nayak 0.897 to 1e6, all materials",
                  "a search that ends at another load", "the plane found has that load", "load, relative",
                  off_by(again.value[QUANTITY_LOAD], load), 1e-9);
        const double *value = point.value;
        for (int q = QUANTITY_AREA; q <= QUANTITY_TCR_SCALE_DEPENDENT; q++)
            assert_true(isfinite(value[q]));
        assert_true(value[QUANTITY_AREA] > before.value[QUANTITY_AREA] && value[QUANTITY_AREA] <= 1);
        assert_true(value[QUANTITY_SEPARATION] < before.value[QUANTITY_SEPARATION] && value[QUANTITY_ADJUSTED] >= 0);
        assert_true(value[QUANTITY_ECR] > 0 && value[QUANTITY_ECR] <= before.value[QUANTITY_ECR]);
        assert_true(value[QUANTITY_TCR] > 0 && value[QUANTITY_TCR_SCALE_DEPENDENT] >= value[QUANTITY_TCR]);
        assert_true(point.radius_clamped >= 0 && point.radius_clamped <= point.beyond_fit && point.beyond_fit <= 1);
        assert_true(model->plastic || point.beyond_fit == 0);
        before = point;
    }
    static const double beyond[] = {1, 1 + 1e-15, 1e6};
    for (int i = 0; i < 3; i++)
        assert_false(statistical_solve(&point, model, model->full_load * beyond[i], &d));
    statistical_full(&point, model);
    assert_true(point.value[QUANTITY_AREA] == 1 && point.value[QUANTITY_LOAD] == model->full_load);
    for (int q = QUANTITY_ADJUSTED; q <= QUANTITY_TCR_SCALE_DEPENDENT; q++)
        assert_true(point.value[q] == 0);
    statistical_at(&again, model, model->full_d);
    hard_case("the load of complete contact", "β of a plane where the contact is not yet complete",
              "A = A_n at the root", "area, relative", off_by(again.value[QUANTITY_AREA], 1), 1e-12);
    hard_case("β at the root", "adjusted separation below 0, or open where all touches", "β = -2 D/σ of that very root",
              "β, relative", off_by(model->beta, -2 * again.value[QUANTITY_SEPARATION] / model->surface.sigma_m),
              1e-14);
    hard_case("loads of (1 + 1e-15) and 1e6 times complete contact", "separation below the last one",
              "adjusted separation 0, resistance 0", "both", point.value[QUANTITY_ADJUSTED] + point.value[QUANTITY_ECR],
              0);
}

/** Nayak from just above its limit over 0.9 to 1e6, slopes from 1e-6 to 10 (mean square), every material. */
TEST_CASE(every_surface_in_every_material)
{
    static const double nayaks[] = {0.89696, 0.9, 1.5, 30, 1e6}, slopes[] = {1e-6, 1e-3, 10};
    for (int k = 0; k < 5; k++)
        for (int s = 0; s < 3; s++) {
            struct asperities surface =
                model_support_asperities(1e-14, slopes[s], nayaks[k] * slopes[s] * slopes[s] / 1e-14);
            hard_case("Nayak's parameter just above its limit 0.89696, to 1e6", "σ_s² = σ² (1 - 0.8968/α) cancels",
                      "asperities as long as σ_s² > 0, else none and said so", "α, relative",
                      off_by(surface.nayak, nayaks[k]), 1e-12);
            for (int y = 0; y < HARD_YIELD_RATIOS; y++)
                for (int n = 0; n < HARD_NUS; n += 3)
                    for (int plastic = 0; plastic < 2; plastic++) {
                        struct material_pair pair = hard_pair(hard_yield_ratios[y], hard_nus[n]);
                        struct statistical model = make(&surface, &pair, plastic, INFINITY);
                        check_curve(&model);
                    }
        }
}

/** Full contact from -60 sigma_s to +8 sigma_s: A = A_n at the root to 1e-12 for both laws. */
TEST_CASE(roots_of_full_contact)
{
    struct material_pair pair = model_support_tin();
    for (double target = -60; target <= 8; target += 2) {
        struct asperities surface = {
            .radius_m = 1e-5, .sigma_s_m = 1e-7, .offset_m = 5e-8, .sigma_m = 1.2e-7, .nayak = 10};
        struct gaussian_integrals f = gaussian_integrals(target);
        surface.density_per_m2 = 1 / (M_PI * surface.radius_m * surface.sigma_s_m * f.one) * exp(-f.log_factor);
        double d[2];
        for (int plastic = 0; plastic < 2; plastic++) {
            struct statistical model = make(&surface, &pair, plastic, INFINITY);
            check_curve(&model);
            struct contact_point point;
            statistical_at(&point, &model, model.full_d);
            assert_near(point.value[QUANTITY_AREA], 1, 1e-12);
            d[plastic] = model.full_d;
        }
        hard_case("complete contact at -60 to +8 σ_s", "no bracket holds the root",
                  "found from any density of asperities", "its place, in σ_s or relative",
                  fabs(d[false] - target) / fmax(1, fabs(target)), 1e-10);
        assert_true(d[true] >= d[false]); /* the larger area: beta_JG <= beta_GW */
    }
}

/** Any first guess leads to the same solution. */
TEST_CASE(first_guess_does_not_matter)
{
    static const double guesses[] = {-1e300, -1e9, -60, 0, 40, 1e4, 1e9, 1e300};
    struct material_pair pair = model_support_tin();
    struct asperities surface = model_support_asperities(1.156e-13, 0.0012, 4.5e8);
    for (int plastic = 0; plastic < 2; plastic++) {
        struct statistical model = make(&surface, &pair, plastic, INFINITY);
        for (double load = 1e-100; load < model.full_load; load *= 1e11) {
            double first = 3;
            struct contact_point point;
            assert_true(statistical_solve(&point, &model, load, &first));
            for (size_t i = 0; i < sizeof guesses / sizeof guesses[0]; i++) {
                double d = guesses[i];
                assert_true(statistical_solve(&point, &model, load, &d));
                hard_case("first guesses of -1e300 to 1e300", "the answer hangs on where the search begins",
                          "the same plane from all of them", "its place, in σ_s or relative",
                          fabs(d - first) / fmax(1, fabs(first)), 1e-12);
            }
        }
    }
}
