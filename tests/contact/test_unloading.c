/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Falling load: direct solutions with a hardness against what others have, and strips of the same surfaces. */
#include "contact/unloading.h"
#include "direct/direct_ladder.h"
#include "direct/direct_surface.h"
#include "support.h"

enum { SIDE = 256, LOADS = 5, LINES = 40 };
static const double share[LOADS] = {1, 0.5, 0.2, 0.1, 0.05};

static double variance(double r, const void *hurst)
{
    return r > SIDE / 8.0 ? 0 : pow(fmax(r, 4), -2 * (*(const double *)hurst + 1));
}

/** Of rms gradient 1 in a cell of length 1: waves from a quarter of it to 8 points. To be freed. */
static double *surface(double hurst, bool pits, uint64_t seed)
{
    double *height = support_room(SIDE * SIDE * sizeof *height), given[1000], square = 0;
    for (size_t i = 0; i < 1000; i++)
        given[i] = log(((double)i + 0.5) / 1000);
    expect_ok(direct_surface_make, height, SIDE, &(struct direct_recipe){variance, &hurst, pits ? given : NULL, 1000},
              seed);
    for (size_t k = 0; k < SIDE * SIDE; k++) {
        double along = height[k - k % SIDE + (k + 1) % SIDE] - height[k], across = height[(k + SIDE) % (SIDE * SIDE)];
        square += along * along + pow(across - height[k], 2);
    }
    for (size_t k = 0; k < SIDE * SIDE; k++)
        height[k] /= sqrt(square);
    return height;
}

/** Area, gap and constriction length on the way down over those on the way up. */
static void loop(double ratio[LOADS][3], const double *height, double largest_load, double hardness)
{
    double load[LOADS];
    struct direct_point up[LOADS], down[LOADS];
    for (size_t i = 0; i < LOADS; i++)
        load[i] = share[i] * largest_load;
    const struct direct_ladder_def def = {load, LOADS, hardness, 1e-5, true, NULL};
    struct direct_contact contact;
    expect_ok(direct_contact_make, &contact, height, &(struct direct_grid){SIDE, SIDE, 1.0 / SIDE, false});
    expect_ok(direct_ladder_loop, up, down, &contact, &def, 0);
    direct_contact_free(&contact);
    for (size_t i = 0; i < LOADS; i++)
        for (int q = DIRECT_AREA; q <= DIRECT_CONSTRICTION; q++)
            ratio[i][q] = direct_point_value(&down[i], (enum direct_quantity)q) /
                          direct_point_value(&up[i], (enum direct_quantity)q);
}

/** Three Gaussian surfaces, unloaded from a tenth of the hardness: means within the ranges found by others (here to 6 %
 * where the hardness is small), whatever the hardness. At the largest load both branches are one. */
TEST_CASE(ranges_of_direct_solutions)
{
    static const double hardness[] = {0.03, 0.3}, slack[] = {1.06, 1};
    static const double areas[][2] = {{1.4, 1.6}, {1.8, 2.2}, {2.2, 2.8}, {2.5, 3.4}},
                        resistances[][2] = {{0.75, 0.81}, {0.58, 0.78}, {0.58, 0.75}, {0.45, 0.68}};
    static const struct {
        double hurst;
        uint64_t seed;
    } made[] = {{0.8, 1}, {0.8, 3}, {0.5, 3}};
    enum { SURFACES = sizeof made / sizeof *made };
    for (int h = 0; h < 2; h++) {
        double mean[LOADS][3] = {{0}};
        for (size_t s = 0; s < SURFACES; s++) {
            double ratio[LOADS][3], *height = surface(made[s].hurst, false, made[s].seed);
            loop(ratio, height, 0.1 * hardness[h], hardness[h]);
            for (size_t i = 0; i < LOADS; i++)
                for (int q = 0; q < 3; q++)
                    mean[i][q] += log(ratio[i][q]) / SURFACES;
        }
        for (int q = 0; q < 3; q++)
            assert_within(mean[0][q], 0, 2e-3);
        for (size_t i = 1; i < LOADS; i++) {
            double area = exp(mean[i][DIRECT_AREA]), resistance = exp(mean[i][DIRECT_CONSTRICTION]);
            assert_true(area > areas[i - 1][0] / slack[h] && area < areas[i - 1][1] * slack[h]);
            assert_true(resistance > resistances[i - 1][0] / slack[h] && resistance < resistances[i - 1][1] * slack[h]);
            assert_true(mean[i][DIRECT_GAP] < mean[i - 1][DIRECT_GAP]);
        }
    }
}

/** The ratios of a strip of 40 rows are the surface's, Gaussian or pitted; twice the same bits. Where no pressure comes
 * near the hardness there is no loop. */
TEST_CASE(strips_tell)
{
    for (int pits = 0; pits < 2; pits++) {
        double ratio[LOADS][3], square[3] = {0}, *height = surface(0.8, pits, 1), row[LINES * SIDE];
        struct unloading own, again;
        for (size_t r = 0; r < LINES; r++)
            memcpy(row + r * SIDE, height + r * SIDE / LINES * SIDE, SIDE * sizeof *row);
        const struct strip_rows rows = {row, LINES, SIDE, 1.0 / SIDE, true, NULL};
        loop(ratio, height, 0.02, 0.1);
        expect_ok(unloading_solve, &own, &rows, 0.02, 0.1, NULL);
        expect_ok(unloading_solve, &again, &rows, 0.02, 0.1, NULL);
        assert_memory_equal(&own, &again, sizeof own);
        assert_int_equal(own.count, UNLOADING_SHARES);
        for (size_t i = 1; i < LOADS; i++) {
            static const enum quantity quantity[] = {QUANTITY_AREA, QUANTITY_SEPARATION, QUANTITY_ECR};
            for (int q = 0; q < 3; q++)
                square[q] += pow(log(unloading_factor(&own, quantity[q], share[i]) / ratio[i][q]), 2) / (LOADS - 1);
        }
        assert_true(sqrt(square[0]) < 0.2 && sqrt(square[1]) < 0.16 && sqrt(square[2]) < 0.25);
        expect_ok(unloading_solve, &own, &rows, 0.02, 20, NULL);
        for (size_t i = 0; i < own.count; i++)
            for (int q = 0; q < 3; q++)
                assert_within(own.value[i][q], 0, 0.03);
    }
}

/** Under a light load few spots of a short strip touch: it is loaded more, in powers of two, but to no more than a
 * fifth of the hardness. A load that completes contact is refused. */
TEST_CASE(few_spots)
{
    double *height = surface(0.8, false, 1);
    struct unloading own;
    struct strip_rows rows = {height, LINES, SIDE, 1.0 / SIDE, true, NULL};
    expect_ok(unloading_solve, &own, &rows, 1e-4, 0.1, NULL);
    assert_true(own.raised >= 2 && own.raised * 1e-4 <= 0.02 && own.count == UNLOADING_SHARES);
    rows.rows = 1;
    expect_ok(unloading_solve, &own, &rows, 1e-4, 0.1, NULL);
    assert_near(own.raised, 128, 0);
    assert_true(own.count < UNLOADING_SHARES);
    expect_fails(STATUS_MODEL, "", unloading_solve, &own, &rows, 0.1, 0.1, NULL);
}

/** Straight in the logarithms between shares, nothing beyond them. */
TEST_CASE(factors)
{
    struct unloading own = {.count = 3, .share = {1, 0.5, 0.25}, .value = {{0}, {1, 2, -1}, {2, 3, -INFINITY}}};
    assert_near(unloading_factor(&own, QUANTITY_AREA, sqrt(0.5)), exp(0.5), 1e-12);
    assert_near(unloading_factor(&own, QUANTITY_SEPARATION, 0.25), exp(3), 1e-12);
    assert_near(unloading_factor(&own, QUANTITY_TCR, 0.5), exp(-1), 1e-12);
    assert_near(unloading_factor(&own, QUANTITY_ECR, 1), 1, 1e-12);
    assert_true(isnan(unloading_factor(&own, QUANTITY_ECR, 0.3)) && isnan(unloading_factor(&own, QUANTITY_AREA, 0.2)));
    assert_true(isnan(unloading_factor(&own, QUANTITY_AREA, 1.01)) &&
                isnan(unloading_factor(&own, QUANTITY_JOINT_ECR, 0.5)));
}

/** A curve that flattens is not carried beyond itself: as the load falls contact falls, and conducts worse. Of one like
 * the strip's own nothing changes. */
TEST_CASE(contact_falls_with_load)
{
    static const double flat[] = {0.9, 0.85, 0.7}, steep[] = {0.4, 0.2, 0.1}, conducting[] = {1, 2, 20},
                        same[] = {1, 2, 4};
    const struct unloading made = {
        .count = 3, .share = {1, 0.5, 0.25}, .value = {{0}, {0.3, 0.2, -1}, {0.5, 0.3, -1.5}}};
    struct unloading own = made;
    unloading_bound(&own, QUANTITY_AREA, steep);
    unloading_bound(&own, QUANTITY_ECR, (double[]){1, 4, 20});
    assert_memory_equal(&own, &made, sizeof own);
    unloading_bound(&own, QUANTITY_AREA, flat);
    unloading_bound(&own, QUANTITY_SEPARATION, same);
    unloading_bound(&own, QUANTITY_TCR, conducting);
    unloading_bound(&own, QUANTITY_STIFFNESS, flat); /* it says nothing of it */
    for (size_t k = 0; k < 3; k++) {
        assert_near(unloading_factor(&own, QUANTITY_AREA, own.share[k]) * flat[k], 0.9, 1e-12);
        assert_near(own.value[k][1], made.value[k][1], 0);
        assert_near(unloading_factor(&own, QUANTITY_ECR, own.share[k]) * conducting[k], k < 2 ? 1 : 20 * exp(-1.5),
                    1e-12);
    }
}
