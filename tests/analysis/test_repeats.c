#include "analysis/repeats.h"
#include "support.h"

enum { SCALES = 60, LOADS = 21 };

static struct repeat part_of(double alpha, double gamma)
{
    struct repeat part = {.spectrum = {malloc(SCALES * sizeof(double)), SCALES, 3e-4, false}};
    assert_non_null(part.spectrum.amplitude_m);
    for (size_t i = 0; i < SCALES; i++)
        part.spectrum.amplitude_m[i] = alpha * pow(3e-4 / (double)(i + 1), gamma);
    roughness_from_spectrum(&part.roughness, &part.spectrum);
    part.roughness.rq_m = sqrt(part.roughness.m0_m2);
    return part;
}

static void mean_and_deviation(void **state)
{
    (void)state;
    struct repeats_number number = {0};
    assert_true(isnan(repeats_deviation(&number)));
    static const double values[] = {1e9 + 2, 1e9 + 4, 1e9 + 4, 1e9 + 4, 1e9 + 5, 1e9 + 5, 1e9 + 7, 1e9 + 9};
    for (int i = 0; i < 8; i++)
        repeats_add(&number, values[i]);
    assert_near(number.mean, 1e9 + 5, 1e-15);
    assert_near(repeats_deviation(&number), sqrt(32.0 / 7), 1e-8); /* 1e-16 of the 1e9 offset */
}

/** Exact laws: the spread of gamma is that of the laws; the bootstrap stays within them and repeats. */
static void laws_of_parts(void **state)
{
    (void)state;
    static const double band[2] = {0, INFINITY}, gammas[] = {1.4, 1.5, 1.6, 1.5};
    struct status status = {0};
    struct repeat parts[4];
    struct repeats first, again;
    for (int p = 0; p < 4; p++)
        parts[p] = part_of(0.085, gammas[p]);
    assert_int_equal(repeats_laws(&first, parts, 4, band, &status), STATUS_OK);
    assert_near(first.gamma.mean, 1.5, 1e-9);
    assert_near(repeats_deviation(&first.gamma), sqrt(0.02 / 3), 1e-6);
    assert_true(first.gamma_interval[0] >= 1.4 - 1e-9 && first.gamma_interval[1] <= 1.6 + 1e-9);
    assert_true(first.gamma_interval[1] - first.gamma_interval[0] > 0.05);
    assert_int_equal(repeats_laws(&again, parts, 4, band, &status), STATUS_OK);
    assert_memory_equal(&first, &again, sizeof first);
    assert_int_equal(repeats_laws(&again, parts, 2, band, &status), STATUS_OK);
    assert_int_equal(again.count, 2);
    assert_true(isnan(again.gamma_interval[0])); /* two scans cannot be resampled */
    assert_int_equal(repeats_laws(&again, parts, 1, band, &status), STATUS_OK);
    assert_int_equal(again.count, 0);
    for (int p = 0; p < 4; p++)
        spectrum_free(&parts[p].spectrum);
}

/** The band's limits are exp(mean -+ deviation) of the logarithms of the two curves run by hand. */
static void band_of_two(void **state)
{
    (void)state;
    struct status status = {0};
    struct material_pair pair = material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    struct repeat parts[2] = {part_of(0.085, 1.5), part_of(0.06, 1.45)};
    double loads[LOADS];
    for (int i = 0; i < LOADS; i++)
        loads[i] = 1e-7 * pow(10, 3.0 * i / (LOADS - 1));
    struct model_task task = {
        .pair = &pair, .loads = loads, .load_count = LOADS, .wanted = QUANTITY_BIT(QUANTITY_ECR), .tolerance = 1e-8};
    for (size_t m = 0; m < model_count; m++) {
        struct contact_point points[2][LOADS + 1] = {0};
        for (int p = 0; p < 2; p++) {
            struct asperities asperities;
            struct model_curve curve = {.points = points[p]};
            assert_int_equal(roughness_asperities(&asperities, &parts[p].roughness, &status), STATUS_OK);
            task.spectrum = &parts[p].spectrum;
            task.asperities = &asperities;
            assert_int_equal(model_rows[m]->run(&curve, model_rows[m], &task, &status), STATUS_OK);
        }
        struct repeats_number beta = {0}, log_full_load = {0};
        struct repeats_band band[LOADS] = {0};
        struct model_work work = {0};
        assert_int_equal(repeats_model(&beta, &log_full_load, band, parts, 2, model_rows[m], &task, &work, &status),
                         STATUS_OK);
        assert_true(work.scales + work.separations > 0);
        struct model_work predicted = repeats_work(parts, 2, model_rows[m], &task);
        assert_memory_equal(&work, &predicted, sizeof work);
        assert_int_equal(log_full_load.count, 2);
        assert_int_equal(beta.count, model_rows[m]->quantities & QUANTITY_BIT(QUANTITY_ADJUSTED) ? 2 : 0);
        for (int i = 0; i < LOADS; i++) {
            double a = log(points[0][i].ecr_ohm_m2), b = log(points[1][i].ecr_ohm_m2);
            double half = fabs(a - b) / sqrt(2);
            assert_near(band[i].limits[QUANTITY_ECR][0], exp((a + b) / 2 - half), 1e-9);
            assert_near(band[i].limits[QUANTITY_ECR][1], exp((a + b) / 2 + half), 1e-9);
            assert_true(isnan(band[i].limits[QUANTITY_TCR][0]) && isnan(band[i].limits[QUANTITY_SEPARATION][0]));
        }
    }
    spectrum_free(&parts[0].spectrum);
    spectrum_free(&parts[1].spectrum);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mean_and_deviation),
        cmocka_unit_test(laws_of_parts),
        cmocka_unit_test(band_of_two),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
