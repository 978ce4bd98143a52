/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Grids of one row: a strip, against tests/data/golden/strip/strip.csv (an independent program), and closed forms of
 * Westergaard, J. Appl. Mech. 6 (1939) A49. */
#include "direct_support.h"

#include "base/fft.h"
#include "direct/direct_constriction.h"

static struct direct_contact strip_of(const double *height, size_t points, double spacing_m)
{
    struct direct_contact contact;
    expect_ok(direct_contact_make, &contact, height, &(struct direct_grid){points, 1, spacing_m, false, false});
    return contact;
}

TEST_CASE(matches_reference)
{
    struct table profiles = table_read("golden/strip/profiles.csv");
    struct table table = table_read("golden/strip/strip.csv");
    double *height = support_room(profiles.rows * sizeof *height);
    assert_int_equal(table.rows, 9);
    for (size_t i = 0; i < table.rows; i++) {
        for (size_t k = 0; k < profiles.rows; k++)
            height[k] = table_number(&profiles, k, table_text(&table, i, "profile"));
        struct direct_contact contact = strip_of(height, profiles.rows, 1e-6);
        struct direct_contact_load load = load_of(table_number(&table, i, "load_over_AnEp"), INFINITY, 1e-12);
        struct direct_quantities found = solved(&contact, &load);
        assert_cell((double)found.contact_points, table, i, "contact_points", 0);
        assert_cell((double)found.perimeter_faces, table, i, "faces", 0);
        assert_cell(found.gap_m, table, i, "gap_m", 1e-8);
        assert_cell(constriction_of(&contact, 1e-9), table, i, "constriction_length_m", 1e-8);
        direct_contact_free(&contact);
    }
}

/** What stands for the inverse of the compliance on a set is symmetric, and an even field needs no pressure. */
TEST_CASE(stiffness_of_a_set)
{
    enum { POINTS = 64 };
    double height[POINTS], *field, x[2][POINTS] = {{0}}, product[2] = {0};
    for (size_t k = 0; k < POINTS; k++)
        height[k] = cos(2 * M_PI * (double)k / POINTS);
    struct direct_contact contact = strip_of(height, POINTS, 1);
    for (size_t k = 0; k < POINTS; k++)
        contact.pressure[k] = k % 16 > 2 && k % 16 < 9;
    direct_contact_select(&contact, false);
    assert_int_equal(contact.set_count, 24);
    field = contact.kernel.field;
    for (size_t k = 0; k < POINTS; k++)
        field[k] = contact.pressure[k];
    direct_contact_stiffen(&contact);
    for (size_t k = 0; k < contact.set_count; k++)
        assert_within(field[contact.set[k]], 0, 1e-13);
    for (int side = 0; side < 2; side++) { /* <b, S a> and <a, S b> */
        for (size_t k = 0; k < POINTS; k++) {
            x[side][k] = contact.pressure[k] * (double)((k * k * 7 + (size_t)side * k * 3) % 11);
            field[k] = x[side][k];
        }
        direct_contact_stiffen(&contact);
        for (size_t k = 0; k < POINTS; k++)
            product[side] += field[k] * contact.pressure[k] * (double)((k * k * 7 + (size_t)(1 - side) * k * 3) % 11);
    }
    assert_near(product[0], product[1], 1e-12);
    assert_true(fabs(product[0]) > 1);
    direct_contact_free(&contact);
}

/** The current's density is what the pressure answers to the load with, and where the next solution starts: there, a
 * load a little lower is solved as it begins. */
TEST_CASE(response)
{
    enum { POINTS = 512 };
    double height[POINTS], before[POINTS];
    for (size_t k = 0; k < POINTS; k++)
        height[k] = cos(2 * M_PI * ((double)k + 0.3) / POINTS) + 0.3 * cos(14 * M_PI * ((double)k + 0.1) / POINTS);
    struct direct_contact contact = strip_of(height, POINTS, 1);
    struct direct_contact_load load = load_of(2e-3, INFINITY, 1e-11);
    (void)solved(&contact, &load);
    (void)constriction_of(&contact, 1e-9);
    memcpy(before, contact.pressure, sizeof before);
    load.mean_pressure *= 1 - 1e-5;
    load.tolerance = 1e-7;
    load.warm = true;
    expect_ok(direct_contact_solve, &contact, &load);
    assert_int_equal(contact.iterations, 0);
    double most = 0;
    for (size_t k = 0; k < POINTS; k++)
        most = fmax(most, fabs(before[k] - contact.pressure[k]) / 2e-8);
    assert_true(most > 2); /* far more at an edge than on the mean */
    direct_contact_free(&contact);
}

/** Solutions take no more transforms however rough the heights are, and few more the more points there are. */
TEST_CASE(transforms_of_a_solution)
{
    for (size_t points = 1024; points <= 16384; points *= 4) {
        double *height = support_room(points * sizeof *height);
        for (size_t k = 0; k < points; k++) /* white */
            height[k] = (double)((k * k * 2654435761u >> 7) % 1009) * 1e-3;
        struct direct_contact contact = strip_of(height, points, 1);
        struct direct_contact_load load = load_of(0.1, INFINITY, 1e-3);
        size_t pressed = 0, constricted = 0;
        load.warm = true;
        for (int k = 0; k < 5; k++, load.mean_pressure /= 2) {
            expect_ok(direct_contact_solve, &contact, &load);
            pressed += contact.convolutions;
            (void)constriction_of(&contact, 1e-2);
            constricted += contact.convolutions;
        }
        assert_in_range(pressed, 5, 150);
        assert_in_range(constricted - pressed, 5, 50);
        direct_contact_free(&contact);
    }
}

/** A long rough profile that is worn flat, where thousands of points join at once: that throws nothing back. */
TEST_CASE(many_points_join)
{
    enum { POINTS = 32768, SHORTEST = 16 };
    struct fft_room room;
    assert_true(fft_room_make(&room, POINTS));
    double *height = room.record, square = 0, slope = 0;
    memset(room.transform, 0, (POINTS / 2 + 1) * sizeof *room.transform);
    for (size_t k = 1; k <= POINTS / SHORTEST; k++) { /* Hurst exponent 0.3 */
        double amplitude = pow((double)k, -0.8), phase = 2 * M_PI * direct_random(1, k);
        room.transform[k][0] = amplitude * cos(phase);
        room.transform[k][1] = amplitude * sin(phase);
        square += 2 * amplitude * amplitude;
    }
    assert_true(fft_backward(height, room.transform, POINTS));
    for (size_t k = 0; k < POINTS; k++)
        height[k] = fmin(height[k] / sqrt(square), 0.5) + 2e-3 * direct_random(8, k);
    for (size_t k = 0; k < POINTS; k++)
        slope += pow((height[(k + 1) % POINTS] - height[k]), 2) / POINTS;
    struct direct_contact contact = strip_of(height, POINTS, 1);
    struct direct_contact_load load = load_of(2 * sqrt(slope), INFINITY, 1e-3);
    size_t convolutions = 0;
    load.warm = true;
    for (int k = 0; k < 12; k++, load.mean_pressure /= 2) {
        expect_ok(direct_contact_solve, &contact, &load);
        convolutions += contact.convolutions;
    }
    assert_in_range(convolutions, 100, 900);
    direct_contact_free(&contact);
    fft_room_free(&room);
}
