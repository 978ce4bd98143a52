/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A film adds its resistance over the true contact area. */
#include "joint/film.h"
#include "support.h"

/** Alike spots: rho/(2a) + s/(pi a²) each, n in parallel, n pi a² = A/A_n. */
static void sums_over_spots(void **state)
{
    (void)state;
    double rho = 1.7e-8, film = 1e-12, n = 1e8, a = 3e-6;
    double area = n * M_PI * a * a, contact = rho / (2 * a) / n;
    assert_near(film_resistance(contact, film, area), (rho / (2 * a) + film / (M_PI * a * a)) / n, 1e-14);
    assert_near(film_resistance(contact, 0, area), contact, 0);
    assert_near(film_resistance(0, film, 1), film, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sums_over_spots),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
