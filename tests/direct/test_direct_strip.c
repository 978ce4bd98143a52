/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Grids of one row: a strip, against tests/data/golden/strip/strip.csv (an independent program), and closed forms of
 * Westergaard, J. Appl. Mech. 6 (1939) A49. */
#include "direct_support.h"

#include "direct/direct_constriction.h"

static struct direct_contact strip_of(const double *height, size_t points, double spacing_m)
{
    struct direct_contact contact;
    struct status status = {0};
    assert_int_equal(direct_contact_make(&contact, NULL, height, points, 1, spacing_m, &status), STATUS_OK);
    return contact;
}

TEST_CASE(matches_reference)
{
    struct table profiles = table_read("golden/strip/profiles.csv");
    struct table table = table_read("golden/strip/strip.csv");
    double *height = malloc(profiles.rows * sizeof *height);
    assert_non_null(height);
    assert_int_equal(table.rows, 9);
    for (size_t i = 0; i < table.rows; i++) {
        for (size_t k = 0; k < profiles.rows; k++)
            height[k] = table_number(&profiles, k, table_text(&table, i, "profile"));
        struct direct_contact contact = strip_of(height, profiles.rows, 1e-6);
        struct direct_contact_load load = load_of(table_number(&table, i, "load_over_AnEp"), INFINITY, 1e-12);
        struct direct_quantities found = solved(&contact, &load);
        assert_near((double)found.contact_points, table_number(&table, i, "contact_points"), 0);
        assert_near((double)found.perimeter_faces, table_number(&table, i, "faces"), 0);
        assert_near(found.gap_m, table_number(&table, i, "gap_m"), 1e-8);
        assert_near(constriction_of(&contact, 1e-9), table_number(&table, i, "constriction_length_m"), 1e-8);
        direct_contact_free(&contact);
    }
    free(height);
    table_free(&profiles);
    table_free(&table);
}

/** A wave of amplitude D and length L touches over A where p = pi D/L sin²(pi A/2), and its strips of contact have the
 * constriction length -(L/pi) ln sin(pi A/2); the gap is the integral of twice that over the load. */
TEST_CASE(sinusoid)
{
    enum { POINTS = 4096 };
    double *height = malloc(POINTS * sizeof *height), wavelength_m = 1e-3, amplitude_m = 2e-6;
    assert_non_null(height);
    for (size_t k = 0; k < POINTS; k++)
        height[k] = amplitude_m * cos(2 * M_PI * (double)k / POINTS);
    struct direct_contact contact = strip_of(height, POINTS, wavelength_m / POINTS);
    double full = M_PI * amplitude_m / wavelength_m;
    for (double share = 0.01; share < 1; share += 0.14) {
        struct direct_contact_load load = load_of(full * share, INFINITY, 1e-12);
        struct direct_quantities found = solved(&contact, &load);
        double sine = sqrt(share), length_m = -wavelength_m / M_PI * log(sine);
        /* int_p^full of -(2L/pi) ln sqrt(p/full) dp */
        double gap_m = wavelength_m / M_PI * full * (1 - share + share * log(share));
        assert_within(((double)found.contact_points - 0.5) / POINTS, 2 / M_PI * asin(sine), 1.5 / POINTS);
        assert_near(constriction_of(&contact, 1e-9), length_m, 5e-3);
        assert_near(found.gap_m, gap_m, 5e-3);
    }
    direct_contact_free(&contact);
    free(height);
}
