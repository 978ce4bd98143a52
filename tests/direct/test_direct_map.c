#include "direct_support.h"

#include "direct/direct_constriction.h"
#include "direct/direct_map.h"

/** A plane and an offset go, the mirror image joins without a step, the filter halves a wave of its cut-off, holes are
 * filled from beside them. */
static void conditioning(void **state)
{
    (void)state;
    enum { NX = 40, NY = 36, N = 32 };
    double height[NX * NY];
    struct direct_map map;
    struct status status = {0};
    for (size_t k = 0; k < NX * NY; k++)
        height[k] = 5 + 0.3 * (double)(k % NX) - 0.2 * (double)(k / NX);
    assert_int_equal(direct_map_make(&map, height, NX, NY, 2, 2, N, 0, &status), STATUS_OK);
    assert_int_equal(map.n, 2 * N);
    for (size_t k = 0; k < map.n * map.n; k++)
        assert_within(map.height_m[k], 0, 1e-12);
    direct_map_free(&map);
    /* cos(2 pi (i + 1/2)/16) is even about both ends of the square: mirrored it stays one wave */
    for (int filtered = 0; filtered < 2; filtered++) {
        for (size_t k = 0; k < NX * NY; k++)
            height[k] = cos(2 * M_PI * ((double)(k % NX) + 0.5) / 16);
        assert_int_equal(direct_map_make(&map, height, NX, NY, 2, 2, N, filtered ? 16 : 0, &status), STATUS_OK);
        for (size_t k = 0; k < map.n * map.n; k++)
            assert_within(map.height_m[k], (filtered ? 0.5 : 1) * cos(2 * M_PI * ((double)(k % map.n) + 0.5) / 16),
                          1e-12);
        assert_near(map.rms_m, (filtered ? 0.5 : 1) * sqrt(0.5), 1e-12);
        assert_near(map.gradient, map.rms_m * sin(2 * M_PI / 16) / 2, 1e-12);
        direct_map_free(&map);
    }
    for (size_t k = 0; k < NX * NY; k++)
        height[k] = (double)(k % NX % 2);
    height[3 * NX + 5] = NAN; /* all four neighbours are as near: the first in reading order is above it, at 1 */
    assert_int_equal(direct_map_make(&map, height, NX, NY, 2, 2, N, 0, &status), STATUS_OK);
    assert_int_equal(map.filled, 1);
    assert_within(map.height_m[3 * map.n + 5], map.height_m[2 * map.n + 5], 0.01);
    direct_map_free(&map);
}

static void refused_maps(void **state)
{
    (void)state;
    double height[16 * 16] = {0};
    struct direct_map map;
    struct status status = {0};
    assert_int_equal(direct_map_make(&map, height, 16, 7, 1, 1, 400, 6, &status), STATUS_SCAN);
    status = (struct status){0};
    assert_int_equal(direct_map_make(&map, height, 16, 16, 1, 1.1, 400, 6, &status), STATUS_SCAN);
    for (size_t k = 0; k < 129; k++)
        height[k] = NAN;
    status = (struct status){0};
    assert_int_equal(direct_map_make(&map, height, 16, 16, 1, 1, 400, 6, &status), STATUS_SCAN);
    assert_non_null(strstr(status.message, "129"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(conditioning),
        cmocka_unit_test(refused_maps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
