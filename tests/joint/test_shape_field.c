/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fields over the nominal area: planes and their mean, the cone of a bolt, pressures of several loads. */
#include "joint/shape_field.h"
#include "support.h"

static const double sides_m[2] = {30e-3, 20e-3};

/** Between nodes a plane is a plane, and beyond the outermost it stays as there: of a cell that an outer node cuts the
 * mean of both. */
TEST_CASE(test_plane)
{
    const double x[] = {0, 5e-3, 12e-3, 30e-3}, y[] = {5e-3, 6e-3, 15e-3};
    double value[12];
    const struct shape_grid grid = {{x, y}, {4, 3}, value, {false, false}},
                            line = {{x, y}, {4, 1}, value, {false, false}};
    struct shape_field field;
    for (size_t k = 0; k < 12; k++)
        value[k] = 1 + 100 * x[k % 4] + 300 * y[k / 4];
    expect_ok(shape_field_grid, &field, &grid, sides_m);
    assert_int_equal(field.nx, 64);
    for (size_t k = 0; k < field.nx * field.ny; k++) { /* y of 5 and 15 mm are borders of cells */
        double cx = ((double)(k % field.nx) + 0.5) / 64 * sides_m[0];
        double cy = ((double)(k / field.nx) + 0.5) / 64 * sides_m[1];
        assert_near(field.value[k], 1 + 100 * cx + 300 * fmin(fmax(cy, 5e-3), 15e-3), 1e-12);
    }
    assert_near(field.mean, 1 + 100 * 15e-3 + 300 * 10e-3, 1e-12);
    shape_field_free(&field);
    expect_fails(STATUS_MODEL, "", shape_field_grid, &field, &line, sides_m);
    shape_field_free(&field);
}

/** Whatever the number of places, all the force arrives: of a line on an edge, and of a single place. */
TEST_CASE(test_a_grid_of_any_size_keeps_its_force)
{
    static const size_t sizes[][2] = {{2, 2},     {3, 64},  {50, 65},   {64, 128},
                                      {127, 129}, {300, 7}, {300, 300}, {517, 201}};
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++)
        for (int how = 0; how < 8; how++) {
            const bool cells[2] = {how & 1, how & 2};
            const size_t *n = sizes[s];
            double *room = support_room((n[0] * n[1] + n[0] + n[1]) * sizeof *room), force = 0, got = 0;
            double *at[2] = {room + n[0] * n[1], room + n[0] * n[1] + n[0]};
            for (int side = 0; side < 2; side++)
                for (size_t i = 0; i < n[side]; i++)
                    at[side][i] = sides_m[side] * ((double)i + (cells[side] ? 0.5 : 0)) /
                                  ((double)n[side] - (cells[side] ? 0 : 1));
            for (size_t j = 0; j < n[1]; j++)
                room[j * n[0] + n[0] - 1] = how & 4 ? 1 : 0;
            room[n[1] / 2 * n[0] + n[0] / 3] = 7;
            for (size_t k = 0; k < n[0] * n[1]; k++) {
                const size_t of[2] = {k % n[0], k / n[0]};
                double part = room[k];
                for (int side = 0; side < 2; side++) /* an outer node has half of what others have */
                    part *= cells[side] ? 1. / (double)n[side]
                                        : (of[side] == 0 || of[side] == n[side] - 1 ? 0.5 : 1) / ((double)n[side] - 1);
                force += part;
            }
            const struct shape_grid grid = {{at[0], at[1]}, {n[0], n[1]}, room, {cells[0], cells[1]}};
            struct shape_field field;
            expect_ok(shape_field_grid, &field, &grid, sides_m);
            for (size_t k = 0; k < field.nx * field.ny; k++)
                got += field.value[k] / (double)(field.nx * field.ny);
            assert_near(field.mean, force, 1e-12);
            assert_near(got, force, 1e-12);
            shape_field_free(&field);
        }
}

/** A cell of the field takes of each cell of the grid, and of each straight piece, what it has of it. */
TEST_CASE(test_cells_that_a_border_cuts)
{
    const double x[] = {5e-3, 15e-3, 25e-3}, y[] = {0, 20e-3}, value[] = {1, 5, 2, 1, 5, 2};
    struct shape_grid grid = {{x, y}, {3, 2}, value, {true, false}};
    struct shape_field field;
    expect_ok(shape_field_grid, &field, &grid, sides_m);
    for (size_t k = 0; k < 64; k++)
        assert_near(field.value[k],
                    k < 21    ? 1
                    : k == 21 ? 1. / 3 + 5 * 2. / 3
                    : k < 42  ? 5
                    : k == 42 ? 5 * 2. / 3 + 2. / 3
                              : 2,
                    1e-12);
    shape_field_free(&field);
    grid.cells[0] = false;
    expect_ok(shape_field_grid, &field, &grid, sides_m); /* the node at 15 mm is the middle, a border of cells */
    assert_near(field.value[31], 5 - 4 * 0.5 * 30. / 64 / 10, 1e-12);
    assert_near(field.value[32], 5 - 3 * 0.5 * 30. / 64 / 10, 1e-12);
    shape_field_free(&field);
}

/** What is under the cone is the force; the slope is 0 at the hole, and at the reach nothing is left, not even of
 * slope and curvature. */
TEST_CASE(test_cone)
{
    const struct shape_bolts bolts = {.force_N = 700, .hole_m = 2.75e-3, .reach_m = 9.25e-3};
    enum { STEPS = 20000 };
    double step = (bolts.reach_m - bolts.hole_m) / STEPS, force_N = 0, least = INFINITY, far = 1e-4;
    for (int i = 0; i < STEPS; i++) {
        double r = bolts.hole_m + (i + 0.5) * step, p = shape_bolt_pressure(&bolts, r);
        force_N += 2 * M_PI * r * p * step;
        assert_true(p < least);
        least = p;
    }
    assert_near(force_N, 700, 1e-8);
    double top = shape_bolt_pressure(&bolts, bolts.hole_m);
    assert_near((top - shape_bolt_pressure(&bolts, bolts.hole_m + 2 * far)) /
                    (top - shape_bolt_pressure(&bolts, bolts.hole_m + far)),
                4, 0.03); /* quadratic */
    assert_near(shape_bolt_pressure(&bolts, bolts.reach_m - 2 * far) / shape_bolt_pressure(&bolts, bolts.reach_m - far),
                8, 0.02); /* cubic */
    assert_true(shape_bolt_pressure(&bolts, bolts.hole_m * 0.999) == 0);
    assert_true(shape_bolt_pressure(&bolts, bolts.reach_m * 1.001) == 0);
}

/** Each bolt has its force, at the edge too; cells have the pressure of their middle. */
TEST_CASE(test_bolts_on_an_area)
{
    double middle_m[][2] = {{10e-3, 10e-3}, {29e-3, 19e-3}};
    struct shape_bolts bolts = {middle_m, 2, 700, 2.75e-3, 9.25e-3};
    struct shape_field field;
    for (bolts.count = 1; bolts.count <= 2; bolts.count++) {
        expect_ok(shape_field_bolts, &field, &bolts, sides_m);
        assert_near(field.mean * sides_m[0] * sides_m[1], 700. * (double)bolts.count, 1e-9);
        for (size_t k = 0; k < field.nx * field.ny; k++) {
            double x = ((double)(k % field.nx) + 0.5) / (double)field.nx * sides_m[0] - 10e-3;
            double y = ((double)(k / field.nx) + 0.5) / (double)field.ny * sides_m[1] - 10e-3, r = hypot(x, y);
            assert_true(field.value[k] >= 0);
            if (bolts.count == 1 && r > 4e-3 && r < 7.5e-3)
                assert_near(field.value[k], shape_bolt_pressure(&bolts, r), 0.02);
        }
        shape_field_free(&field);
    }
    bolts.reach_m = bolts.hole_m + 1e-9;
    expect_fails(STATUS_MODEL, "bolt 1 presses on less than a cell", shape_field_bolts, &field, &bolts, sides_m);
    shape_field_free(&field);
}

/** At a field's own load it is that field, between two something between, beyond them the outer one, always of the mean
 * asked for. */
TEST_CASE(test_pressures_of_several_loads)
{
    double values[3][4] = {{1, 1, 1, 1}, {0, 4, 8, 4}, {10, 20, 30, 40}};
    const struct shape_field fields[] = {
        {2, 2, values[0], NULL, 1}, {2, 2, values[1], NULL, 4}, {2, 2, values[2], NULL, 25}};
    for (double mean = 0.01; mean < 1e3; mean *= 1.3) {
        double out[4], sum = 0;
        shape_field_press(out, fields, 3, mean);
        for (int k = 0; k < 4; k++)
            sum += out[k];
        assert_near(sum, 4 * mean, 1e-12);
    }
    for (size_t i = 0; i < 3; i++) {
        double out[4], beyond[4];
        shape_field_press(out, fields, 3, fields[i].mean);
        shape_field_press(beyond, fields, 3, i == 0 ? fields[0].mean / 10 : fields[2].mean * 10);
        for (int k = 0; k < 4; k++) {
            assert_near(out[k], values[i][k], 1e-12);
            if (i != 1)
                assert_near(beyond[k], values[i][k] * (i == 0 ? 0.1 : 10), 1e-12);
        }
    }
    double out[4];
    shape_field_press(out, fields, 3, 2); /* half way in ln */
    assert_near(out[0], 2 * (0.5 * 1 + 0.5 * 0), 1e-12);
    assert_near(out[2], 2 * (0.5 * 1 + 0.5 * 2), 1e-12);
}
