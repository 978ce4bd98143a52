/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct_support.h"

/** Constriction length of a set drawn on an n x n grid of a cell of length 1. */
static double length_of_set(size_t n, bool (*inside)(double x, double y, const void *context), const void *context,
                            size_t *points)
{
    uint8_t *drawing = support_room(n * n);
    size_t iterations;
    *points = 0;
    for (size_t k = 0; k < n * n; k++) {
        drawing[k] = inside((double)(k % n) / (double)n, (double)(k / n) / (double)n, context);
        *points += drawing[k];
    }
    double length = constriction_of_drawing(drawing, n, &iterations);
    assert_true(iterations > 0 && iterations < 20); /* 10 to 21 to 1e-12 */
    return length;
}

struct circle {
    double x, y, radius;
};

/** Within a circle of a periodic cell. */
static bool in_circle(double x, double y, const void *context)
{
    const struct circle *circle = context;
    double dx = remainder(x - circle->x, 1), dy = remainder(y - circle->y, 1);
    return dx * dx + dy * dy <= circle->radius * circle->radius;
}

/** l/L = (L/4a)(1 - 2.482986 a/L + 1.9172 (a/L)³ ...): Holm's spot among its images on a square lattice. */
TEST_CASE(one_spot)
{
    struct table table = table_read("golden/direct/spot.csv");
    for (size_t row = 0; row < table.rows; row++) {
        size_t n = (size_t)table_number(&table, row, "N"), points;
        double a = table_number(&table, row, "a_over_L");
        if (n > 512 && a > 0.15 && !getenv("ROUGHCONTACT_SLOW_TESTS"))
            continue; /* no more to be learnt */
        struct circle circle = {0.5 + 0.123 / (double)n, 0.5 + 0.234 / (double)n, a};
        double length = length_of_set(n, in_circle, &circle, &points);
        assert_cell((double)points, table, row, "points", 0);
        assert_cell(length, table, row, "constriction_length_over_L", 1e-9);
        if (n >= 512 && a < 0.15)
            assert_near(length, 1 / (4 * a) - 2.482986 / 4 + 1.9172 * a * a / 4, 6e-3);
    }
}

/** Twenty spots: Greenwood's sum with the periodic Green's function, extrapolated from 512 and 1024 points a side. */
TEST_CASE(twenty_spots)
{
    struct table table = table_read("golden/direct/greenwood.csv");
    double length[3];
    for (size_t row = 0; row < table.rows; row++) {
        length[row] = twenty_spots_of((size_t)table_number(&table, row, "N"));
        assert_cell(length[row], table, row, "constriction_length", 1e-9);
    }
    assert_cell(2 * length[2] - length[1], table, 0, "greenwood_periodic", 5e-3);
}

static bool in_strip(double x, double y, const void *context)
{
    (void)y;
    return fabs(remainder(x - 0.4997, 1)) <= *(const double *)context;
}

/** Strips of half width a, period L: l = -(L/2 pi) ln sin²(pi a/L), first order in dx. */
TEST_CASE(strips)
{
    for (double a = 0.05; a < 0.45; a += 0.05) {
        size_t points;
        double length = length_of_set(1024, in_strip, &a, &points), half = (double)points / 1024 / 1024 / 2;
        assert_near(length, -log(pow(sin(M_PI * half), 2)) / (2 * M_PI), 0.02);
    }
}

/** l = -(E'/2) d(mean gap)/d(p̄): the exact derivative on the grid while the set stays. */
TEST_CASE(derivative_of_the_gap)
{
    double *height = recipe_surface(64), gap[2];
    struct direct_contact contact = contact_of(height, 64, 64);
    size_t points[2];
    for (double p = 0.02; p < 0.35; p *= 2) {
        double step = 1e-6 * p;
        for (int side = 0; side < 2; side++) {
            struct direct_contact_load load = load_of(side ? p + step : p - step, INFINITY, 1e-13);
            struct direct_quantities found = solved(&contact, &load);
            gap[side] = found.gap_m;
            points[side] = found.contact_points;
        }
        assert_int_equal(points[0], points[1]);
        assert_near(constriction_of(&contact, 1e-10), (gap[0] - gap[1]) / (4 * step), 1e-5);
    }
    direct_contact_free(&contact);
}

/** The length is too large, by at most the tolerance; a wider one takes fewer iterations. */
TEST_CASE(tolerance_bounds_the_error)
{
    double *height = recipe_surface(64);
    for (double p = 0.01; p < 0.35; p *= 3) {
        struct direct_contact contact = contact_of(height, 64, 64);
        struct direct_contact_load load = load_of(p, INFINITY, 1e-10);
        size_t before = SIZE_MAX;
        (void)solved(&contact, &load);
        const double exact = constriction_of(&contact, 1e-13);
        for (double tolerance = 1e-5; tolerance < 1; tolerance *= 10) {
            contact.iterations = 0;
            double error = constriction_of(&contact, tolerance) / exact - 1;
            assert_true(error > -1e-10 && error <= tolerance && error >= tolerance / 1000);
            assert_true(contact.iterations <= before);
            before = contact.iterations;
        }
        direct_contact_free(&contact);
    }
}
