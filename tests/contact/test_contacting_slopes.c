/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacting slopes against tests/data/golden/contacting-slopes, against Persson's theory on Gaussian heights, and in
 * what must not change it. */
#include "contact/contacting_slopes.h"
#include "support.h"

enum { POINTS = 512 };
static const double spacing_m = 1e-6;

struct surface {
    struct contacting_slopes slopes;
    struct persson persson;
};

/** The profile's own harmonics without the Nyquist one, no window. */
static struct surface surface_of(const double *height_m, size_t points, double spacing)
{
    struct surface surface;
    struct spectrum spectrum;
    struct status status = {0};
    struct slope_point *point = malloc(points * sizeof *point);
    assert_non_null(point);
    size_t inner = contacting_slopes_of_profile(point, height_m, points, spacing);
    assert_int_equal(inner, points - 2);
    assert_int_equal(contacting_slopes_make(&surface.slopes, point, inner, persson_energy_factor, &status), STATUS_OK);
    assert_int_equal(spectrum_compute(&spectrum, height_m, points, spacing, SPECTRUM_WINDOW_NONE, &status), STATUS_OK);
    spectrum.count -= spectrum.has_nyquist;
    spectrum.has_nyquist = false;
    assert_int_equal(persson_make(&surface.persson, &spectrum, persson_energy_factor, &status), STATUS_OK);
    spectrum_free(&spectrum);
    free(point);
    return surface;
}

static void surface_free(struct surface *surface)
{
    contacting_slopes_free(&surface->slopes);
    persson_free(&surface->persson);
}

static void read_profile(double height_m[POINTS], const char *name)
{
    struct table table = table_read("golden/contacting-slopes/profiles.csv");
    assert_int_equal(table.rows, POINTS);
    for (size_t i = 0; i < POINTS; i++)
        height_m[i] = table_number(&table, i, name);
    table_free(&table);
}

TEST_CASE(matches_reference)
{
    struct table table = table_read("golden/contacting-slopes/contact.csv");
    double height_m[POINTS];
    for (size_t i = 0; i < table.rows; i++) {
        read_profile(height_m, table_text(&table, i, "profile"));
        struct surface surface = surface_of(height_m, POINTS, spacing_m);
        double load = table_number(&table, i, "load_over_AnEp"), reference = table_number(&table, i, "area_ratio");
        struct contacting_slopes_area area = contacting_slopes_area(&surface.slopes, load);
        assert_near(area.area_ratio, reference, 1e-12);
        assert_int_equal(area.mark, reference < 30.0 / 510    ? CONTACTING_SLOPES_FEW
                                    : reference > 508.9 / 510 ? CONTACTING_SLOPES_BEYOND
                                                              : CONTACTING_SLOPES_INSIDE);
        struct contacting_slopes_gap gap;
        bool given = contacting_slopes_gap(&gap, &surface.slopes, &surface.persson, load, area.area_ratio);
        assert_int_equal(given, *table_text(&table, i, "offset_m") != '\0');
        assert_int_equal(given, reference <= 0.15);
        if (given) {
            assert_near(gap.offset_m, table_number(&table, i, "offset_m"), 1e-10);
            assert_near(gap.scale_m, table_number(&table, i, "scale_m"), 1e-10);
            assert_near(gap.separation_m, table_number(&table, i, "separation_m"), 1e-10);
            assert_near(gap.constriction_m, table_number(&table, i, "constriction_length_m"), 1e-10);
        }
        surface_free(&surface);
    }
    table_free(&table);
}

/** Higher by an offset, read from the other end, in other units of height and length: the area at the load that goes
 * with the slope stays, lengths follow the unit, the separation the offset. */
TEST_CASE(invariances)
{
    double height_m[POINTS], changed_m[POINTS];
    read_profile(height_m, "plateau");
    struct surface as_read = surface_of(height_m, POINTS, spacing_m);
    static const struct {
        double offset_m, height_unit, length_unit;
        bool mirrored;
    } changes[] = {{1e-6, 1, 1, false}, {0, 1, 1, true}, {0, 8, 8, false}, {0, 8, 1, false}, {0, 1, 4, true}};
    for (size_t c = 0; c < sizeof changes / sizeof changes[0]; c++) {
        double unit = changes[c].height_unit, steeper = unit / changes[c].length_unit;
        for (size_t i = 0; i < POINTS; i++)
            changed_m[changes[c].mirrored ? POINTS - 1 - i : i] = height_m[i] * unit + changes[c].offset_m;
        struct surface changed = surface_of(changed_m, POINTS, spacing_m * changes[c].length_unit);
        for (double load = 1e-6; load < 1; load *= 1.7) {
            struct contacting_slopes_gap before, after;
            double area = contacting_slopes_area(&as_read.slopes, load).area_ratio;
            assert_near(contacting_slopes_area(&changed.slopes, load * steeper).area_ratio, area, 1e-9);
            bool given = contacting_slopes_gap(&before, &as_read.slopes, &as_read.persson, load, area);
            assert_int_equal(contacting_slopes_gap(&after, &changed.slopes, &changed.persson, load * steeper, area),
                             given);
            if (given) {
                assert_near(after.separation_m - changes[c].offset_m, before.separation_m * unit, 1e-8);
                assert_near(after.constriction_m, before.constriction_m * changes[c].length_unit, 1e-8);
            }
        }
        surface_free(&changed);
    }
    surface_free(&as_read);
}

static uint64_t next_random(uint64_t *state)
{
    uint64_t x = (*state += 0x9E3779B97F4A7C15u);
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
}

static double normal(uint64_t *state)
{
    double u = ((double)(next_random(state) >> 11) + 0.5) * 0x1p-53, v = (double)(next_random(state) >> 11) * 0x1p-53;
    return sqrt(-2 * log(u)) * cos(2 * M_PI * v);
}

/** A Gaussian profile of a million points: slope and height are independent, so that area, separation and constriction
 * are Persson's. From areas of 3 % on: of fewer points, neighbours being alike, the mean-square slope scatters more. */
TEST_CASE(gaussian_heights_give_persson)
{
    enum { MANY = 1000000, WIDE = 8 };
    double *white = malloc((MANY + WIDE) * sizeof *white), *height_m = malloc(MANY * sizeof *height_m);
    assert_true(white && height_m);
    uint64_t seed = 7;
    for (size_t i = 0; i < MANY + WIDE; i++)
        white[i] = normal(&seed);
    double m2 = 0, mean = 0;
    for (size_t i = 0; i < MANY; i++) { /* smoothed by a binomial kernel */
        static const double kernel[WIDE + 1] = {1, 8, 28, 56, 70, 56, 28, 8, 1};
        height_m[i] = 0;
        for (size_t j = 0; j <= WIDE && i + j < MANY + WIDE; j++)
            height_m[i] += 1e-8 * kernel[j] * white[i + j];
        mean += height_m[i] / MANY;
    }
    for (size_t i = 0; i < MANY; i++)
        height_m[i] -= mean;
    struct surface surface = surface_of(height_m, MANY, spacing_m);
    m2 = surface.slopes.mean_square[MANY - 2];
    for (double p = 0.02; p < 1.5; p *= 1.4) {
        double load = p * sqrt(m2);
        struct contacting_slopes_area area = contacting_slopes_area(&surface.slopes, load);
        assert_near(area.area_ratio, persson_area(load, m2, persson_energy_factor), 0.02);
        struct contacting_slopes_gap gap;
        if (contacting_slopes_gap(&gap, &surface.slopes, &surface.persson, load, area.area_ratio)) {
            /* the waves' slope is not that of the central difference: the same x = p/sqrt(m2) is compared */
            struct persson_separation at = persson_separation(&surface.persson, p * sqrt(surface.persson.m2));
            double steeper = sqrt(m2 / surface.persson.m2);
            assert_near(gap.separation_m, at.separation_m, 0.02);
            assert_near(2 * gap.constriction_m * steeper, at.constriction_m, 0.03);
        }
    }
    surface_free(&surface);
    free(white);
    free(height_m);
}

/** With one slope everywhere it is Persson's load at any area, exactly: zigzag heights. */
TEST_CASE(one_slope_is_persson)
{
    struct slope_point point[200];
    for (size_t i = 0; i < 200; i++)
        point[i] = (struct slope_point){1e-7 * (double)(i * 37 % 200), 0.04};
    struct contacting_slopes slopes;
    struct status status = {0};
    assert_int_equal(contacting_slopes_make(&slopes, point, 200, 0.45, &status), STATUS_OK);
    for (size_t k = 30; k < 200; k++) {
        double area = (double)k / 200;
        assert_near(slopes.load[k], persson_load(area, 0.04, 0.45), 1e-14);
        assert_near(contacting_slopes_area(&slopes, slopes.load[k]).area_ratio, area, 1e-14);
    }
    contacting_slopes_free(&slopes);
}

/** Few points, ties, a level top, no slope: monotone and finite, or refused with a message. */
TEST_CASE(hard_cases)
{
    struct slope_point point[32];
    struct contacting_slopes slopes;
    struct status status = {0};
    for (size_t i = 0; i < 32; i++)
        point[i] = (struct slope_point){i < 16 ? 1e-6 : -1e-6 * (double)i, i < 16 ? 0 : 0.01};
    double amplitude[2] = {1e-6, 1e-7};
    struct spectrum spectrum = {amplitude, 2, 1e-4, false};
    struct persson persson;
    assert_int_equal(persson_make(&persson, &spectrum, 0.45, &status), STATUS_OK);
    assert_int_equal(contacting_slopes_make(&slopes, point, 32, 0.45, &status), STATUS_OK);
    double area = 0;
    for (double load = 1e-300; load < 1e10; load *= 3) {
        struct contacting_slopes_area at = contacting_slopes_area(&slopes, load);
        assert_true(at.area_ratio >= area && at.area_ratio <= 31.0 / 32);
        area = at.area_ratio;
        struct contacting_slopes_gap gap;
        if (contacting_slopes_gap(&gap, &slopes, &persson, load, area))
            assert_true(isfinite(gap.separation_m) && isfinite(gap.constriction_m) && gap.constriction_m >= 0);
    }
    assert_near(area, 31.0 / 32, 0);
    assert_near(contacting_slopes_area(&slopes, 0).area_ratio, 0, 0);
    contacting_slopes_free(&slopes);

    for (size_t i = 16; i < 32; i++) /* the 31 highest are level */
        point[i] = (struct slope_point){i < 31 ? 1e-6 : -1e-6, i < 31 ? 0 : 0.01};
    assert_int_equal(contacting_slopes_make(&slopes, point, 32, 0.45, &status), STATUS_MODEL);
    assert_non_null(strstr(status.message, "no slope"));
    point[0].slope_square = 1e-4;
    status = (struct status){0};
    assert_int_equal(contacting_slopes_make(&slopes, point, 32, 0.45, &status), STATUS_OK);
    struct contacting_slopes_gap gap;
    assert_true(contacting_slopes_gap(&gap, &slopes, &persson, 1e-4, 0.1));
    assert_true(gap.separation_m == 1e-6 && gap.constriction_m == 0 && gap.scale_m == 0);
    contacting_slopes_free(&slopes);
    double nothing = 0; /* heights without waves: a spectrum of one silent harmonic */
    struct spectrum silent = {&nothing, 1, 1e-4, false};
    struct persson flat;
    assert_int_equal(persson_make(&flat, &silent, 0.45, &status), STATUS_OK);
    for (size_t i = 0; i < 32; i++)
        point[i] = (struct slope_point){1e-6 * (double)i, 0.01};
    assert_int_equal(contacting_slopes_make(&slopes, point, 32, 0.45, &status), STATUS_OK);
    assert_true(contacting_slopes_gap(&gap, &slopes, &flat, 1e-4, 0.1));
    assert_true(isfinite(gap.separation_m) && gap.constriction_m == 0);
    contacting_slopes_free(&slopes);
    persson_free(&flat);
    assert_int_equal(contacting_slopes_make(&slopes, point, 30, 0.45, &status), STATUS_MODEL);
    assert_non_null(strstr(status.message, "30 inner points are too few"));
    persson_free(&persson);
}

/** Equal heights come in the order of their index, so that the result does not depend on how one sorts. */
TEST_CASE(ties_go_by_index)
{
    struct slope_point point[64];
    struct contacting_slopes slopes;
    struct status status = {0};
    for (size_t i = 0; i < 64; i++)
        point[i] = (struct slope_point){-1e-6 * (double)(i / 16), (double)(i + 1)};
    assert_int_equal(contacting_slopes_make(&slopes, point, 64, 0.45, &status), STATUS_OK);
    for (size_t k = 1; k <= 64; k++)
        assert_near(slopes.mean_square[k], (double)(k + 1) / 2, 1e-15);
    contacting_slopes_free(&slopes);
}
