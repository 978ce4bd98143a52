/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct_support.h"

#include "direct/direct_ladder.h"
#include "direct/direct_map.h"

static double even_wave(size_t i)
{
    return cos(2 * M_PI * ((double)i + 0.5) / 16);
}

/** A plane and an offset go, the mirror image joins without a step, the filter halves a wave of its cut-off in each
 * direction, holes are filled from beside them. */
TEST_CASE(conditioning)
{
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
    /* cos(2 pi (i + 1/2)/16) is even about both ends of the square: mirrored it stays one wave, along and across */
    for (int filtered = 0; filtered < 2; filtered++) {
        double amplitude = filtered ? 0.25 : 1;
        for (size_t k = 0; k < NX * NY; k++)
            height[k] = even_wave(k % NX) * even_wave(k / NX);
        assert_int_equal(direct_map_make(&map, height, NX, NY, 2, 2, N, filtered ? 16 : 0, &status), STATUS_OK);
        for (size_t k = 0; k < map.n * map.n; k++)
            assert_within(map.height_m[k], amplitude * even_wave(k % map.n) * even_wave(k / map.n), 1e-12);
        assert_near(map.rms_m, amplitude / 2, 1e-12);
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

TEST_CASE(refused_maps)
{
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

/** v(r) flat up to *context waves in the cell, falling with Hurst exponent 0.8 up to 16. */
static double rolled_off(double r, const void *context)
{
    return r > 16 ? 0 : pow(fmax(r, *(const double *)context), -3.6);
}

enum { MIRROR_LOADS = 3 };
static const double mirror_loads[MIRROR_LOADS] = {0.03, 0.1, 0.3}; /* over the root mean square gradient */

static void solve_mirrored(struct direct_point out[MIRROR_LOADS], const double *height, size_t n, double gradient)
{
    double load[MIRROR_LOADS];
    struct direct_contact contact;
    struct status status = {0};
    struct direct_ladder_def ladder = {load, MIRROR_LOADS, INFINITY, 1e-6, true, NULL};
    for (int i = 0; i < MIRROR_LOADS; i++)
        load[i] = mirror_loads[i] * gradient;
    if (direct_contact_make(&contact, NULL, height, n, n, 1, &status) != STATUS_OK ||
        direct_ladder_run(out, &contact, &ladder, &status) != STATUS_OK)
        fail_msg("%s", status.message);
    direct_contact_free(&contact);
}

/** What plane and mirror cost: a periodic surface against what is made of it as if it were a map. Means over seeds of
 * area, gap and constriction over those of the periodic one: the longest waves are what is lost, so a map as long as
 * its longest wave loses gap, one of four of them little. */
TEST_CASE(mirrored_periodic_surface)
{
    enum { N = 128, SEEDS = 4 };
    static const struct {
        double waves, area, gap, constriction; /* most by which a mean differs from 1 */
    } cases[] = {{1, 0.06, 0.25, 0.30}, {4, 0.02, 0.035, 0.04}};
    double *height = malloc(N * N * sizeof *height), change[2] = {0};
    for (size_t c = 0; c < 2; c++) {
        double mean[MIRROR_LOADS][3] = {{0}};
        for (uint64_t seed = 1; seed <= SEEDS; seed++) {
            struct direct_point periodic[MIRROR_LOADS], mirrored[MIRROR_LOADS];
            struct direct_map map;
            struct status status = {0};
            assert_int_equal(direct_surface_make(height, N, rolled_off, &cases[c].waves, NULL, 0, seed, &status),
                             STATUS_OK);
            assert_int_equal(direct_map_make(&map, height, N, N, 1, 1, N, 0, &status), STATUS_OK);
            double gradient = gradient_of(map.height_m, map.n, 1);
            solve_mirrored(periodic, height, N, gradient);
            solve_mirrored(mirrored, map.height_m, map.n, gradient);
            for (size_t i = 0; i < MIRROR_LOADS; i++) {
                mean[i][0] += mirrored[i].quantities.area_ratio / periodic[i].quantities.area_ratio / SEEDS;
                mean[i][1] += mirrored[i].quantities.gap_m / periodic[i].quantities.gap_m / SEEDS;
                mean[i][2] += mirrored[i].constriction_m / periodic[i].constriction_m / SEEDS;
            }
            direct_map_free(&map);
        }
        for (size_t i = 0; i < MIRROR_LOADS; i++) {
            assert_within(mean[i][0], 1, cases[c].area);
            assert_within(mean[i][1], 1, cases[c].gap);
            assert_within(mean[i][2], 1, cases[c].constriction);
            change[c] += fabs(log(mean[i][1])) / MIRROR_LOADS;
        }
    }
    assert_true(change[0] > 3 * change[1] && change[1] > 0.005);
    free(height);
}
