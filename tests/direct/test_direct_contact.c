/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct_support.h"

#include "direct/direct_constriction.h"
#include "direct/direct_quantities.h"

/** Every so many of the rows of a table that have a grid of n points a side, against solutions to `tolerance`. */
static void random_rows(const char *file, size_t n, size_t every, int expected_rows, double tolerance)
{
    struct table table = table_read(file);
    double *height = recipe_surface(n);
    struct direct_contact contact = contact_of(height, n, n);
    int rows = 0;
    for (size_t row = 0; row < table.rows; row += every) {
        if (table_number(&table, row, "N") != (double)n)
            continue;
        double hardness = strcmp(table_text(&table, row, "hardness"), "inf") == 0 ? INFINITY : 0.5;
        struct direct_contact_load load = load_of(table_number(&table, row, "p"), hardness, tolerance);
        struct direct_quantities found = solved(&contact, &load);
        assert_cell((double)found.contact_points, table, row, "contact_points", 0);
        assert_cell((double)found.perimeter_faces, table, row, "perimeter_faces", 0);
        struct overlap overlap = overlap_of(&contact, hardness);
        assert_cell((double)overlap.capped_points, table, row, "capped_points", 0);
        assert_cell(direct_area_corrected(&found, n * n, direct_kappa_yastrebov), table, row, "area_corrected", 1e-9);
        assert_cell(found.gap_m, table, row, "open_gap", 1e-9);
        assert_cell(overlap.plane_gap_m, table, row, "mean_plane_gap", 1e-9);
        assert_true(violation_of(&contact, &load) < tolerance + (n > 256 ? 1e-11 : 1e-12)); /* rounding grows with n */
        double length = constriction_of(&contact, 1e-10);
        assert_cell(length, table, row, "constriction_length", 1e-9);
        assert_cell(2 * length, table, row, "minus_dgap_dp_fixed_set", 1e-9);
        rows++;
    }
    assert_int_equal(rows, expected_rows);
    direct_contact_free(&contact);
}

TEST_CASE(random_surface)
{
    random_rows("golden/direct/random.csv", 64, 1, 12, 1e-12);
    random_rows("golden/direct/random.csv", 128, 1, 12, 1e-12);
    random_rows("golden/direct/random.csv", 256, 5, 3, 1e-12);
}

/** Minutes; only where the environment asks for it. */
TEST_CASE(random_surface_fine)
{
    if (!getenv("ROUGHCONTACT_SLOW_TESTS"))
        skip();
    random_rows("golden/direct/random_fine.csv", 512, 1, 12, 1e-12);
    random_rows("golden/direct/random_fine.csv", 1024, 1, 12, 1e-12);
    random_rows("golden/direct/random_fine.csv", 2048, 1, 6, 1e-10);
}

/** One wave along x: A = (2/pi) asin sqrt x, gap = Delta (1 - x + x ln x), x = p/(pi E' Delta/L) (Westergaard 1939). */
TEST_CASE(westergaard_strip)
{
    struct table table = table_read("golden/direct/westergaard.csv");
    double amplitude = 0.01;
    for (size_t row = 0; row < table.rows; row++) {
        size_t n = (size_t)table_number(&table, row, "N");
        double *height = wave_of(n, 2, amplitude), x = table_number(&table, row, "p_over_pstar");
        struct direct_contact contact = contact_of(height, n, 2);
        struct direct_contact_load load = load_of(x * M_PI * amplitude, INFINITY, 1e-12);
        struct direct_quantities found = solved(&contact, &load);
        assert_near((double)found.contact_points, 2 * table_number(&table, row, "contact_points"), 0);
        assert_within(found.gap_m / amplitude, table_number(&table, row, "gap_over_amplitude"), 2e-12);
        if (n == 4096)
            assert_cell(found.gap_m / amplitude, table, row, "gap_exact", 7.5e-7);
        assert_cell(2 * M_PI * constriction_of(&contact, 1e-10), table, row, "minus_dgap_dx_fixed_set", 1e-9);
        direct_contact_free(&contact);
    }
}

/** cos cos, shifted so that no points tie, against the same cell solved on 1024 x 1024. */
TEST_CASE(sinusoidal_cell)
{
    struct table table = table_read("golden/direct/sinusoid.csv");
    for (size_t row = 0; row < table.rows; row++) {
        size_t n = (size_t)table_number(&table, row, "N");
        if (n == 512 && row % 4 != 0) /* light, half and nearly complete contact */
            continue;
        double *height = support_room(n * n * sizeof *height), x = table_number(&table, row, "p_over_pstar");
        for (size_t j = 0; j < n; j++)
            for (size_t i = 0; i < n; i++)
                height[j * n + i] = 0.01 * cos(2 * M_PI * ((double)i + 0.25) / (double)n) *
                                    cos(2 * M_PI * ((double)j + 0.4) / (double)n);
        struct direct_contact contact = contact_of(height, n, n);
        struct direct_contact_load load = load_of(x * sqrt(2) * M_PI * 0.01, INFINITY, n < 512 ? 1e-12 : 1e-9);
        struct direct_quantities found = solved(&contact, &load);
        assert_cell((double)found.contact_points, table, row, "contact_points", 0);
        assert_cell((double)found.perimeter_faces, table, row, "perimeter_faces", 0);
        assert_within(found.gap_m / 0.01, table_number(&table, row, "gap_over_amplitude"), n < 512 ? 1e-11 : 1e-9);
        assert_within(direct_area_corrected(&found, n * n, direct_kappa_yastrebov),
                      table_number(&table, row, "area_corrected"), 1e-11);
        assert_cell(2 * sqrt(2) * M_PI * constriction_of(&contact, 1e-12), table, row, "minus_dgap_dx_fixed_set", 1e-9);
        if (n == 512) {
            assert_within(found.gap_m / 0.01, table_number(&table, row, "gap_golden_1024"), 1.5e-6);
            assert_within(direct_area_corrected(&found, n * n, direct_kappa_yastrebov),
                          table_number(&table, row, "area_golden_1024"), 3.6e-4);
        }
        direct_contact_free(&contact);
    }
}

/** A paraboloid of radius 1 with its apex off the grid's points: a³ = 3 P R/4E', p = 2 E' a/(pi R) sqrt(1 - r²/a²)
 * (Hertz 1882), of its images the more the larger a/L. The gap in the table is that of the apex' plane. */
TEST_CASE(sphere_after_hertz)
{
    struct table table = table_read("golden/direct/hertz.csv");
    assert_int_equal(table.rows, 12);
    for (size_t row = 0; row < table.rows; row++) {
        size_t n = (size_t)table_number(&table, row, "N");
        double a = table_number(&table, row, "a_over_L"), mean, *height = paraboloid_of(n, &mean);
        if (n == 512 && a < 0.15) /* the finest grid: once */
            continue;
        struct direct_contact contact = contact_of(height, n, n);
        struct direct_contact_load load = load_of(4.0 / 3 * a * a * a, INFINITY, n < 512 ? 1e-12 : 1e-11);
        struct direct_quantities found = solved(&contact, &load);
        double most = largest_pressure(&contact);
        for (size_t k = 0; k < n * n; k++) {
            double p = contact.pressure[k / n * contact.kernel.stride + k % n], square = -2 * height[k] / (a * a);
            if (n >= 256 && a < 0.06 && square < 0.5)
                assert_near(p, 2 * a / M_PI * sqrt(1 - square), 4e-3);
        }
        assert_cell((double)found.contact_points, table, row, "contact_points", 0);
        assert_cell((double)found.perimeter_faces, table, row, "perimeter_faces", 0);
        assert_cell((double)found.contact_points / ((double)(n * n) * M_PI * a * a), table, row, "area_over_hertz",
                    1e-9);
        assert_cell(direct_area_corrected(&found, n * n, direct_kappa_yastrebov) / (M_PI * a * a), table, row,
                    "corrected_area_over_hertz", 1e-9);
        assert_cell(most / (2 * a / M_PI), table, row, "pmax_over_hertz", 1e-9);
        assert_cell(overlap_of(&contact, INFINITY).plane_gap_m + mean, table, row, "mean_gap", 1e-9);
        assert_cell(2 * constriction_of(&contact, 1e-9), table, row, "stiffness_fixed_set_dgap_dp", 1e-9);
        if (n >= 256)
            assert_near(most, 2 * a / M_PI, a < 0.06 ? 8.1e-5 : a < 0.11 ? 1.3e-3 : 0.011);
        direct_contact_free(&contact);
    }
}

static enum status_code result_of(const double *height, size_t n, const struct direct_contact_load *load,
                                  struct status *status)
{
    struct direct_contact contact;
    if (direct_contact_make(&contact, height, &(struct direct_grid){n, n, 1 / (double)n, false, false}, status) !=
        STATUS_OK)
        return status->code;
    enum status_code rc = direct_contact_solve(&contact, load, status);
    direct_contact_free(&contact);
    return rc;
}

/** Beside what tests/hard/test_hard_direct.c has. */
TEST_CASE(refuses_what_cannot_be_solved)
{
    double *height = recipe_surface(64);
    static const atomic_bool stop = true;
    struct direct_contact_load load = load_of(0.01, 0.5, 1e-300);
    expect_fails(STATUS_MODEL, "not converge", result_of, height, 64, &load);
    load = load_of(0.01, INFINITY, 1e-6);
    load.stop = &stop;
    expect_fails(STATUS_INTERRUPTED, "stopped", result_of, height, 64, &load);
    height[7] = NAN;
    expect_fails(STATUS_MODEL, "height 7", result_of, height, 64, &load);
}

/** With a hardness the load of one point, p̄ n², spreads to p̄ n²/H points. */
TEST_CASE(spike)
{
    enum { N = 16 };
    double height[N * N] = {0};
    height[5 * N + 11] = 1;
    struct direct_contact contact = contact_of(height, N, N);
    struct direct_contact_load load = load_of(1e-3, 1e-3 * N * N / 10.5, 1e-9); /* the spike flows down to the plane */
    struct direct_quantities found = solved(&contact, &load);
    struct overlap overlap = overlap_of(&contact, load.hardness);
    assert_true(found.contact_points >= 11 && overlap.capped_points >= 1 && overlap.plane_gap_m < found.gap_m);
    assert_true(violation_of(&contact, &load) < 1e-9);
    direct_contact_free(&contact);
}

/** The smallest grids, odd ones too, and loads from one point to all. */
TEST_CASE(small_grids)
{
    for (size_t n = 4; n <= 17; n++) {
        double *height = support_room(n * n * sizeof *height);
        uint32_t random = 12345;
        for (size_t k = 0; k < n * n; k++) {
            random = random * 1664525u + 1013904223u;
            height[k] = (double)random / 4294967296.0;
        }
        struct direct_contact contact = contact_of(height, n, n);
        for (double p = 1e-3; p < 1e3; p *= 10)
            for (int capped = 0; capped < 2; capped++) {
                struct direct_contact_load load = load_of(p, capped ? 3 * p : INFINITY, 1e-9);
                struct direct_quantities found = solved(&contact, &load);
                assert_true(violation_of(&contact, &load) < 1.1e-9);
                assert_true(found.area_ratio > 0 || !capped);
                assert_true(!capped || 3 * found.contact_points >= n * n);
                assert_true(found.gap_m >= 0);
            }
        direct_contact_free(&contact);
    }
}

/** More load: more area, less gap, less constriction, with a hardness too. */
TEST_CASE(monotone_and_warm)
{
    double *height = recipe_surface(64);
    struct direct_contact cold = contact_of(height, 64, 64), warm = contact_of(height, 64, 64);
    for (int capped = 0; capped < 2; capped++) {
        struct direct_quantities last = {.gap_m = INFINITY};
        double last_length = INFINITY;
        size_t cold_effort = 0, warm_effort = 0;
        for (double p = 1e-3; p < 0.4; p *= 1.8) {
            struct direct_contact_load load = load_of(p, capped ? 0.5 : INFINITY, 1e-9);
            expect_ok(direct_contact_solve, &cold, &load);
            load.warm = true;
            expect_ok(direct_contact_solve, &warm, &load);
            struct direct_quantities found = direct_quantities_of(&cold, &load);
            struct direct_quantities other = direct_quantities_of(&warm, &load);
            assert_int_equal(found.contact_points, other.contact_points);
            assert_int_equal(overlap_of(&cold, load.hardness).capped_points,
                             overlap_of(&warm, load.hardness).capped_points);
            assert_near(found.gap_m, other.gap_m, 1e-7);
            cold_effort += cold.convolutions;
            warm_effort += warm.convolutions;
            double length = constriction_of(&cold, 1e-9);
            assert_true(found.contact_points >= last.contact_points && found.gap_m < last.gap_m);
            assert_true(length < last_length);
            last = found;
            last_length = length;
        }
        assert_true(warm_effort < cold_effort);
    }
    direct_contact_free(&cold);
    direct_contact_free(&warm);
}

/** Everything scales: heights and cell by s, at the same p/E'. */
TEST_CASE(scale_free)
{
    double *height = recipe_surface(64);
    struct direct_contact contact = contact_of(height, 64, 64), small;
    for (size_t k = 0; k < 64 * 64; k++)
        height[k] = height[k] * 1e-9 + 1e-3; /* far off its datum */
    expect_ok(direct_contact_make, &small, height, &(struct direct_grid){64, 64, 1e-9 / 64, false, false});
    struct direct_contact_load load = load_of(0.05, INFINITY, 1e-9);
    struct direct_quantities found = solved(&contact, &load), other = solved(&small, &load);
    assert_int_equal(found.contact_points, other.contact_points);
    assert_near(other.gap_m, 1e-9 * found.gap_m, 1e-6); /* 1e-3 m leaves 1e-8 of the roughness */
    assert_near(constriction_of(&small, 1e-9), 1e-9 * constriction_of(&contact, 1e-9), 1e-6);
    direct_contact_free(&contact);
    direct_contact_free(&small);
}

/** Iterations count as a result: a solver that lost its preconditioner or its directions still converges, slowly. */
TEST_CASE(effort_as_known)
{
    double *height = recipe_surface(256);
    struct direct_contact contact = contact_of(height, 256, 256);
    struct {
        double p, hardness;
        size_t convolutions;
    } cases[] = {{0.005, INFINITY, 60}, {0.1, INFINITY, 60}, {0.3, INFINITY, 65}, {0.005, 0.5, 90}, {0.1, 0.5, 120}};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        struct direct_contact_load load = load_of(cases[k].p, cases[k].hardness, 1e-6);
        expect_ok(direct_contact_solve, &contact, &load);
        if (contact.convolutions > cases[k].convolutions)
            fail_msg("%zu convolutions at %g", contact.convolutions, cases[k].p);
    }
    direct_contact_free(&contact);
}

/** Three quarters in contact and only a handful of points at the hardness: these change sides in every iteration unless
 * violators wait until they are the worst, and 400 iterations would not do. */
TEST_CASE(few_points_at_the_hardness)
{
    enum { N = 256 };
    struct direct_law law = {1, 1.297, 1.0 / 40, 1, 1};
    struct direct_spectrum spectrum;
    double *height = support_room(N * N * sizeof *height);
    expect_ok(direct_spectrum_of_law, &spectrum, &law);
    expect_ok(direct_surface_make, height, N, &(struct direct_recipe){direct_spectrum_variance, &spectrum, NULL, 0}, 1);
    struct direct_contact contact = contact_of(height, N, N);
    for (size_t k = 0; k < N * N; k++)
        height[k] *= 9.84e-4 / contact.rms_m;
    direct_contact_free(&contact);
    contact = contact_of(height, N, N);
    struct direct_contact_load load = load_of(0.01, 0.05, 1e-6);
    expect_ok(direct_contact_solve, &contact, &load);
    struct direct_quantities found = direct_quantities_of(&contact, &load);
    assert_true((double)found.contact_points > 0.6 * N * N);
    assert_in_range(overlap_of(&contact, load.hardness).capped_points, 1, 19);
    assert_true(contact.convolutions < 200);
    assert_true(violation_of(&contact, &load) < 1.1e-6);
    direct_contact_free(&contact);
    direct_spectrum_free(&spectrum);
}

/** A hardness that no load reaches costs nothing, from load to load either: no answer moves, and no convolution is
 * added. One that is reached is no such. */
TEST_CASE(hardness_not_reached)
{
    enum { N = 64, LOADS = 4 };
    static const double pressure[LOADS] = {0.005, 0.01, 0.02, 0.04}, hardness[] = {1e3, 0.3};
    double *height = recipe_surface(N);
    for (int h = 0; h < 2; h++) {
        struct direct_contact elastic = contact_of(height, N, N), capped = contact_of(height, N, N);
        bool same = true;
        for (int i = 0; i < LOADS; i++) {
            struct direct_contact_load load = load_of(pressure[i], INFINITY, 1e-6);
            load.warm = true;
            (void)solved(&elastic, &load);
            load.hardness = hardness[h];
            (void)solved(&capped, &load);
            same &= capped.convolutions == elastic.convolutions && capped.pressure[0] == elastic.pressure[0];
        }
        assert_int_equal(same, h == 0);
        direct_contact_free(&elastic);
        direct_contact_free(&capped);
    }
}

/** A grid of 256 points a side starts from one of 128, and that from one of 64: fewer convolutions, those of the coarse
 * ones included, for the same solution. The same load again is no work. */
TEST_CASE(starts_from_coarse_grids)
{
    enum { N = 256 };
    double *height = recipe_surface(N);
    for (double p = 1e-3; p < 0.01; p *= 9) {
        struct direct_contact nested = contact_of(height, N, N), plain = contact_of(height, N, N);
        assert_int_equal(nested.coarse->coarse->kernel.nx, 64);
        assert_null(nested.coarse->coarse->coarse);
        direct_contact_free(plain.coarse);
        free(plain.coarse);
        plain.coarse = NULL;
        struct direct_contact_load load = load_of(p, INFINITY, 1e-6);
        expect_ok(direct_contact_solve, &nested, &load);
        expect_ok(direct_contact_solve, &plain, &load);
        struct direct_quantities found = direct_quantities_of(&nested, &load);
        assert_near(found.gap_m, direct_quantities_of(&plain, &load).gap_m, 1e-5);
        assert_true(3 * nested.convolutions < 2 * plain.convolutions);
        load.warm = true;
        expect_ok(direct_contact_solve, &nested, &load);
        assert_int_equal(nested.iterations, 0);
        direct_contact_free(&nested);
        direct_contact_free(&plain);
    }
}

/** An iteration takes two convolutions and a half: the residual stiffened, the step's energy, and the displacement. A
 * grid too small for a coarse one takes one more to begin with. */
TEST_CASE(convolutions_of_an_iteration)
{
    enum { N = 64 };
    double *height = recipe_surface(N);
    for (double p = 1e-3; p < 1; p *= 9) {
        struct direct_contact contact = contact_of(height, N, N);
        struct direct_contact_load load = load_of(p, INFINITY, 1e-6);
        expect_ok(direct_contact_solve, &contact, &load);
        assert_true(contact.iterations > 5);
        assert_int_equal(contact.convolutions, 1 + 5 * contact.iterations / 2);
        direct_contact_free(&contact);
    }
}

/** A mirrored grid is in contact as its images are: pressures, and all that is counted of it, also from a coarse grid.
 */
TEST_CASE(mirror_images)
{
    enum { N = 128, LOADS = 3 };
    static const double hardness[] = {INFINITY, 0.08};
    const double *height = recipe_surface(N);
    double *images = support_room(4 * N * N * sizeof *images), load[LOADS];
    for (size_t k = 0; k < 4 * N * N; k++) {
        size_t i = k % (2 * N), j = k / (2 * N);
        images[k] = height[(j < N ? j : 2 * N - 1 - j) * N + (i < N ? i : 2 * N - 1 - i)];
    }
    double gradient = gradient_of(images, 2 * N, 1.0 / N);
    for (int l = 0; l < LOADS; l++)
        load[l] = gradient * pow(10, l - 2.5);
    for (int h = 0; h < 2; h++) {
        struct direct_contact own, whole;
        struct direct_point found[LOADS], expected[LOADS];
        const struct direct_ladder_def ladder = {load, LOADS, hardness[h] * gradient, 1e-9, true, NULL, false};
        expect_ok(direct_contact_make, &own, height, &(struct direct_grid){N, N, 1.0 / N, true, false});
        expect_ok(direct_contact_make, &whole, images, &(struct direct_grid){2 * N, 2 * N, 1.0 / N, false, false});
        assert_non_null(own.coarse);
        expect_ok(direct_ladder_run, found, &own, &ladder);
        expect_ok(direct_ladder_run, expected, &whole, &ladder);
        for (int l = 0; l < LOADS; l++) {
            if (!found[l].exists && !expected[l].exists)
                continue;
            assert_int_equal(4 * found[l].quantities.contact_points, expected[l].quantities.contact_points);
            assert_int_equal(4 * found[l].quantities.perimeter_faces, expected[l].quantities.perimeter_faces);
            assert_int_equal(found[l].patches, expected[l].patches);
            assert_near(found[l].quantities.gap_m, expected[l].quantities.gap_m, 1e-6);
            assert_near(found[l].constriction_m, expected[l].constriction_m, 1e-4);
            assert_true(found[l].convolutions < 2 * expected[l].convolutions);
        }
        direct_contact_free(&own);
        direct_contact_free(&whole);
    }
}
