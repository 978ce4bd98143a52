#include "contact/convergence.h"
#include "contact/multiscale.h"
#include "support.h"

enum { EVERYTHING = QUANTITY_BIT(QUANTITY_SEPARATION) | QUANTITY_RESISTANCES };

static struct spectrum law_spectrum(double length, double alpha, double gamma, size_t count)
{
    struct spectrum spectrum = {malloc(count * sizeof(double)), count, length, false};
    assert_non_null(spectrum.amplitude_m);
    for (size_t i = 0; i < count; i++)
        spectrum.amplitude_m[i] = alpha * pow(length / (double)(i + 1), gamma);
    return spectrum;
}

static void matches_reference(void **state)
{
    (void)state;
    struct table table = table_read("golden/multiscale.csv");
    struct material_pair pair = material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    struct constriction spot = constriction_make(&pair);
    struct status status = {0};
    for (size_t i = 0; i < table.rows; i++) {
        struct spectrum spectrum =
            law_spectrum(table_number(&table, i, "scan_length_m"), table_number(&table, i, "alpha_SI"),
                         table_number(&table, i, "gamma"), (size_t)table_number(&table, i, "scales"));
        double sigma = sqrt(spectrum_moment(&spectrum, 0));
        struct multiscale stack;
        bool plastic = strcmp(table_text(&table, i, "model"), "plastic") == 0;
        assert_int_equal(multiscale_make(&stack, &spectrum, &pair, plastic, SINUSOID_FIT_THESIS, &status), STATUS_OK);
        struct contact_point point;
        uint64_t evaluations = 0;
        multiscale_solve(&point, &stack, &spot, EVERYTHING, table_number(&table, i, "load_over_AnEp"), &evaluations);
        assert_int_equal(evaluations, spectrum.count);
        assert_near(point.area_ratio, table_number(&table, i, "area_ratio"), 1e-10);
        assert_near(point.separation_m / sigma, table_number(&table, i, "separation_over_sigma"), 1e-10);
        assert_near(point.ecr_ohm_m2, table_number(&table, i, "ecr_ohm_m2"), 1e-10);
        assert_near(point.tcr_K_m2_per_W, table_number(&table, i, "tcr_K_m2_per_W"), 1e-10);
        assert_near(point.tcr_sd_K_m2_per_W, table_number(&table, i, "tcr_sd_K_m2_per_W"), 1e-10);
        multiscale_free(&stack);
        spectrum_free(&spectrum);
    }
    table_free(&table);
}

/** full_load is where the area becomes 1 and the separation 0: not before, not after. */
static void full_load_is_sharp(void **state)
{
    (void)state;
    struct material_pair pair = material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    struct constriction spot = constriction_make(&pair);
    struct status status = {0};
    struct spectrum spectrum = law_spectrum(3e-4, 0.085, 1.5, 256);
    for (int plastic = 0; plastic < 2; plastic++) {
        struct multiscale stack;
        assert_int_equal(multiscale_make(&stack, &spectrum, &pair, plastic, SINUSOID_FIT_THESIS, &status), STATUS_OK);
        struct contact_point point;
        uint64_t evaluations = 0;
        multiscale_solve(&point, &stack, &spot, EVERYTHING, stack.full_load * (1 + 1e-12), &evaluations);
        assert_near(point.area_ratio, 1, 0);
        assert_within(point.ecr_ohm_m2, 0, 0);
        multiscale_solve(&point, &stack, &spot, EVERYTHING, stack.full_load * (1 - 1e-3), &evaluations);
        assert_true(point.area_ratio < 1 && point.ecr_ohm_m2 > 0);
        multiscale_solve(&point, &stack, &spot, EVERYTHING, stack.closed_load * (1 + 1e-12), &evaluations);
        assert_within(point.separation_m, 0, 0);
        multiscale_solve(&point, &stack, &spot, EVERYTHING, stack.closed_load * (1 - 1e-3), &evaluations);
        assert_true(point.separation_m > 0);
        multiscale_free(&stack);
    }
    spectrum_free(&spectrum);
}

/** The convergence study's areas after each scale end in the area of the whole stack and never rise. */
static void areas_fall_to_the_total(void **state)
{
    (void)state;
    struct material_pair pair = material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    struct constriction spot = constriction_make(&pair);
    struct status status = {0};
    struct spectrum spectrum = law_spectrum(3e-4, 0.085, 0.5, 400);
    struct multiscale stack;
    assert_int_equal(multiscale_make(&stack, &spectrum, &pair, true, SINUSOID_FIT_THESIS, &status), STATUS_OK);
    double area[400];
    uint64_t evaluations = 0;
    struct convergence_law law = {0.085, 0.5, 3e-4, 1e-3, 400};
    convergence_areas(area, &law, &pair, true, &evaluations);
    struct contact_point point;
    multiscale_solve(&point, &stack, &spot, 0, 1e-3, &evaluations);
    assert_near(area[399], point.area_ratio, 1e-12);
    assert_true(area[0] <= 1);
    for (int i = 1; i < 400; i++)
        assert_true(area[i] <= area[i - 1]);
    assert_true(isnan(point.separation_m) && isnan(point.ecr_ohm_m2) && isnan(point.tcr_K_m2_per_W));
    multiscale_free(&stack);
    spectrum_free(&spectrum);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(matches_reference),
        cmocka_unit_test(full_load_is_sharp),
        cmocka_unit_test(areas_fall_to_the_total),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
