/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The contact of a map at one load: its spots lie on the bumps and carry all of the load. */
#include "members/map_contact.h"

#include "support.h"

enum { SIDE = 96 };
static const double dx_m = 1e-6, radius_m = 1e-3;

/** Bumps of one curvature at places in points, on a map that closes or goes on as its mirror image, with a dent that
 * keeps it apart from a plane. */
static struct tiles bumps(double *height_m, size_t side, const double (*at)[3], size_t count, bool closes)
{
    const double n = (double)side;
    for (size_t k = 0; k < side * side; k++) {
        height_m[k] = -1e-6;
        for (size_t b = 0; b < count; b++) {
            double x = (double)(k % side) - at[b][0], y = (double)(k / side) - at[b][1];
            x = closes ? remainder(x, n) : x;
            y = closes ? remainder(y, n) : y;
            height_m[k] = fmax(height_m[k], at[b][2] - (x * x + y * y) * dx_m * dx_m / (2 * radius_m));
        }
    }
    return (struct tiles){
        .height_m = height_m, .def = {side, side, dx_m, dx_m, closes, 0}, .side = side, .columns = 1, .rows = 1};
}

static struct map_contact contact_of(const struct tiles *tiles, double load, double hardness)
{
    struct map_contact out;
    expect_ok(map_contact_find, &out, tiles, load, hardness, NULL);
    return out;
}

static double force(const struct map_contact *contact)
{
    double sum = 0;
    for (size_t i = 0; i < contact->spot_count; i++)
        sum += contact->spots[i].force_m2;
    return sum;
}

/* Of four bumps the two low ones do not touch; the others are two spots at their places, which carry all of the load.
 * With a hardness no pressure exceeds it, and the picture shows where it is reached. */
TEST_CASE(bumps_are_spots)
{
    static const double at[][3] = {{24, 30, 0}, {71, 65, 0}, {20, 80, -8e-7}, {75, 15, -8e-7}};
    const double load = 2e-6, area_m2 = SIDE * dx_m * SIDE * dx_m;
    double *height_m = support_room(SIDE * SIDE * sizeof *height_m);
    const struct tiles tiles = bumps(height_m, SIDE, at, 4, false);
    struct map_contact elastic = contact_of(&tiles, load, INFINITY);
    assert_int_equal(elastic.spot_count, 2);
    assert_int_equal(elastic.cells, SIDE);
    for (size_t i = 0; i < 2; i++) {
        assert_within(elastic.spots[i].x_m, at[i][0] * dx_m, 1.5e-6);
        assert_within(elastic.spots[i].y_m, at[i][1] * dx_m, 1.5e-6);
        assert_int_equal(elastic.is[(size_t)at[i][1] * SIDE + (size_t)at[i][0]], MAP_TOUCHES);
    }
    assert_int_equal(elastic.is[80 * SIDE + 20], MAP_OPEN);
    assert_near(force(&elastic), load * area_m2, 1e-6);
    assert_within(elastic.flowed, 0, 0);
    double most = 0;
    for (size_t i = 0; i < elastic.points; i++)
        most = fmax(most, elastic.pressure[i]);
    const double hardness = most / 3;
    struct map_contact capped = contact_of(&tiles, load, hardness);
    size_t flowing = 0, touching = 0;
    for (size_t k = 0; k < SIDE * SIDE; k++) {
        flowing += capped.is[k] == MAP_FLOWS;
        touching += capped.is[k] != MAP_OPEN;
    }
    assert_near(force(&capped), load * area_m2, 1e-6);
    assert_near(capped.flowed, (double)flowing / (double)touching, 1e-12);
    assert_true(capped.flowed < 1 && capped.touched > elastic.touched);
    assert_true(capped.flowed * capped.touched < load / hardness); /* what flows carries no more than all */
    for (size_t i = 0; i < capped.points; i++)
        assert_true(capped.pressure[i] <= hardness * (1 + 1e-9));
    map_contact_free(&elastic);
    map_contact_free(&capped);
}

/* A bump on the corner of a periodic map is a single spot; on a map that is not periodic its quarters are four spots.
 */
TEST_CASE(spots_go_on_over_the_edge)
{
    static const double corners[][3] = {{0, 0, 0}, {SIDE - 1, 0, 0}, {0, SIDE - 1, 0}, {SIDE - 1, SIDE - 1, 0}};
    double *height_m = support_room(SIDE * SIDE * sizeof *height_m);
    struct tiles tiles = bumps(height_m, SIDE, corners, 1, true);
    struct map_contact one = contact_of(&tiles, 1e-6, INFINITY);
    assert_int_equal(one.spot_count, 1);
    assert_true(one.spots[0].x_m < 1e-6 || one.spots[0].x_m > (SIDE - 1) * dx_m);
    tiles = bumps(height_m, SIDE, corners, 4, false);
    struct map_contact four = contact_of(&tiles, 1e-6, INFINITY);
    assert_int_equal(four.spot_count, 4);
    map_contact_free(&one);
    map_contact_free(&four);
}

/* The picture of a larger map has half as many cells a side and still shows every spot; above the hardness there is
 * none. */
TEST_CASE(pictures_are_small)
{
    enum { LARGE = 320 };
    static const double at[][3] = {{200, 101, 0}};
    double *height_m = support_room(LARGE * LARGE * sizeof *height_m);
    const struct tiles tiles = bumps(height_m, LARGE, at, 1, false);
    struct map_contact contact = contact_of(&tiles, 1e-7, INFINITY), none = contact_of(&tiles, 1e-3, 1e-4);
    assert_int_equal(contact.cells, LARGE / 2);
    assert_near(contact.cell_m, 2 * dx_m, 1e-12);
    assert_int_equal(contact.is[50 * LARGE / 2 + 100], MAP_TOUCHES);
    assert_int_equal(contact.points, LARGE);
    assert_near(contact.section_m, 101 * dx_m, 0.02);
    assert_int_equal(none.cells, 0);
    assert_null(none.spots);
    map_contact_free(&contact);
}
