/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The textbook's contact recomputed, as a reader could, from the sigma, m and H printed beside it. */
#include "run/pipeline.h"

#include <gsl/gsl_cdf.h>
#include <jansson.h>

enum { POINTS = 300, ROWS = 24 };
static const double hardness_Pa = 40e6;

/* Heights in um that close on nothing: waves of 6 to 120 points in all directions. */
static double height_um(double x, double y, unsigned long seed)
{
    double z = 0, random = (double)seed;
    for (int wave = 0; wave < 40; wave++) {
        double part[3];
        for (int k = 0; k < 3; k++)
            part[k] = random = fmod(random * 16807 + 11, 2147483647);
        double length = 6 * pow(20, part[0] / 2147483647), angle = 2 * M_PI * part[1] / 2147483647;
        z += 0.004 * length *
             cos(2 * M_PI / length * (x * cos(angle) + y * sin(angle)) + 2 * M_PI * part[2] / 2147483647);
    }
    return z;
}

static void write_profile(const struct directory *place, const char *name, double size, unsigned long seed)
{
    struct text *csv = support_text();
    text_add(csv, "x [um],z [um]\n");
    for (int i = 0; i < POINTS; i++)
        text_add(csv, "%d,%.6f\n", i, size * height_um(i, 0, seed));
    directory_write(place, name, text_string(csv));
}

static void write_map(const struct directory *place, const char *name, double stretched)
{
    struct text *xyz = support_text();
    text_add(xyz, "x [um],y [um],z [um]\n");
    for (int y = 0; y < ROWS; y++)
        for (int x = 0; x < 2 * ROWS; x++)
            text_add(xyz, "%d,%d,%.6f\n", x, y, height_um(x, y / stretched, 7));
    directory_write(place, name, text_string(xyz));
}

static void report(const struct directory *place, const char *out, const char *file, const char *load)
{
    pipeline_report(place, "in", out,
                    filled("material: {Sy: 14 MPa, E: 40 GPa, nu: 0.3, resistivity: 1e-7 ohm m, "
                           "conductivity: 60 W/m/K}\nhardness: 40 MPa\nnominal_area: 1 mm2\nload: {from: 0.01 N, to: "
                           "30 N, points: 7}\noperating_load: %s\neffects: [plasticity, separation, electrical, "
                           "thermal]\nmodels: [corrected-persson, cmy]\nsurfaces: [{name: s, file: \"%s\"}]\n",
                           load, file));
}

static double number(const struct directory *place, const char *out, const char *key)
{
    return pipeline_number(place, out, filled("surfaces/0/%s", key));
}

/** Every row of CMY follows from the printed sigma and m; m is the levelled profile's, times kappa with a lay. */
static void expect_textbook(const struct directory *place, const char *out)
{
    const double sigma_m = number(place, out, "sigma_m"), slope = number(place, out, "mean_slope");
    const double kappa = number(place, out, "lay/kappa");
    struct table table = directory_table(place, filled("%s/data/contact.csv", out));
    size_t rows = 0;
    assert_near(slope, kappa * sqrt(2 * number(place, out, "m2") / M_PI), 1e-12);
    for (size_t r = 0; r < table.rows; r++) {
        double ratio = table_number(&table, r, "pressure_Pa") / hardness_Pa, l = gsl_cdf_ugaussian_Qinv(ratio);
        if (strcmp(table_text(&table, r, "model"), "cmy") != 0)
            continue;
        double h = slope / sigma_m * exp(-l * l / 2) / (2 * sqrt(2 * M_PI) * pow(1 - sqrt(ratio), 1.5));
        if (l > 0)
            assert_near(table_number(&table, r, "separation_m"), l * sigma_m, 1e-9);
        assert_near(table_number(&table, r, "ecr_ohm_m2"), 1e-7 / h, 1e-9);
        assert_near(table_number(&table, r, "tcr_K_m2_per_W"), 1 / (60 * h), 1e-9);
        rows++;
    }
    assert_int_equal(rows, 8); /* the operating load is one */
}

TEST_IN_DIRECTORY(it_follows_from_what_is_printed_beside_it)
{
    for (unsigned long s = 0; s < 4; s++)
        write_profile(place, filled("in/p-%lu.csv", s), 1 + 0.4 * (double)s, 20 + s);
    report(place, "one", "p-0.csv", "1 N");
    expect_textbook(place, "one");
    assert_near(number(place, "one", "sigma_m"), number(place, "one", "rq_m"), 0);
    report(place, "several", "p-*.csv", "1 N");
    expect_textbook(place, "several");
    assert_near(number(place, "several", "sigma_m"), number(place, "several", "rq_m"), 1e-15);
    for (int stretched = 1; stretched < 3; stretched++) { /* with a lay, too */
        write_map(place, "in/map.csv", stretched);
        report(place, "map", "map.csv", "1 N");
        expect_textbook(place, "map");
        assert_true(number(place, "map", "sigma_m") > number(place, "map", "rq_m"));
    }
}

/** Of a map sigma is Sq: rows that are each level, at heights that differ, are rougher together. */
TEST_IN_DIRECTORY(of_a_map_it_takes_sq)
{
    double square = 0, mean = 0, tilt[2] = {0, 0}, all = 2 * ROWS * ROWS, spread[2] = {0, 0};
    for (int pass = 0; pass < 2; pass++)
        for (int k = 0; k < 2 * ROWS * ROWS; k++) {
            double x = k % (2 * ROWS) - ROWS + 0.5, y = k / (2 * ROWS) - ROWS / 2.0 + 0.5;
            double z = height_um(x + ROWS - 0.5, y + ROWS / 2.0 - 0.5, 7);
            mean += pass == 0 ? z / all : 0;
            tilt[0] += pass == 0 ? z * x : 0;
            tilt[1] += pass == 0 ? z * y : 0;
            spread[0] += pass == 0 ? x * x : 0;
            spread[1] += pass == 0 ? y * y : 0;
            square += pass == 0 ? 0 : pow(z - mean - tilt[0] / spread[0] * x - tilt[1] / spread[1] * y, 2) / all;
        }
    write_map(place, "in/map.csv", 1);
    report(place, "map", "map.csv", "1 N");
    assert_near(number(place, "map", "sigma_m"), sqrt(square) * 1e-6, 1e-5);
}
