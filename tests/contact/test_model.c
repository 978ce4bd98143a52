/* What every model goes through: a curve that is not finite does not exist. */
#include "contact/model.h"
#include "support.h"

enum {
    LOADS = 5,
    EVERYTHING = QUANTITY_BIT(QUANTITY_SEPARATION) | QUANTITY_BIT(QUANTITY_ECR) | QUANTITY_BIT(QUANTITY_TCR)
};

static struct model_curve run(const struct asperities *surface, double yield_strength_Pa, struct contact_point *points)
{
    static const double loads[LOADS] = {1e-8, 1e-6, 1e-4, 1e-2, 1e4};
    struct material tin = *material_find("tin");
    tin.yield_strength_Pa = yield_strength_Pa;
    struct material_pair pair = material_pair(&tin, MATERIAL_COUNTERFACE_RIGID, NULL);
    struct model_task task = {.asperities = surface,
                              .pair = &pair,
                              .loads = loads,
                              .load_count = LOADS,
                              .wanted = EVERYTHING,
                              .tolerance = 1e-6};
    struct model_curve curve = {.points = points};
    struct status status = {0};
    assert_int_equal(model_run(&curve, model_rows[model_named("jg")], &task, &status), STATUS_OK);
    return curve;
}

/* B = 0.14 exp(23 S_y/E') is beyond double for a yield strength of a hundred times the modulus; asperities so sharp
 * that they yield all the same have no area then. */
static void test_numbers_beyond_double(void **state)
{
    (void)state;
    const struct roughness blunt = {.m0_m2 = 1e-12, .m2 = 1e-2, .m4_per_m2 = 1e9};
    const struct roughness sharp = {.m0_m2 = 1e30, .m2 = 1e40, .m4_per_m2 = 1e51};
    struct contact_point points[LOADS + 1];
    struct asperities surface;
    struct status status = {0};
    assert_int_equal(roughness_asperities(&surface, &blunt, &status), STATUS_OK);
    struct model_curve curve = run(&surface, 14e6, points);
    assert_true(curve.exists && !curve.overflows && curve.count > 1);
    assert_int_equal(roughness_asperities(&surface, &sharp, &status), STATUS_OK);
    curve = run(&surface, 4e12, points);
    assert_true(!curve.exists && curve.overflows && curve.count == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_numbers_beyond_double)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
