/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bulged plates on each other: tests/data/golden/joint/shape.csv, closed forms and limits. */
#include "joint/shape.h"
#include "support.h"

/** The joint of a test: its gap is -u ln(p/p0) and its conductance c p^power, of points over 22 decades. */
static struct {
    size_t nx, ny;
    double side_m[2], bulge_m, modulus_Pa, p0_Pa, u_m, c, power, hardness_Pa;
    struct shape_body bodies[2];
    struct shape shape;
    struct shape_curve gap, conductance;
    double *gap_m;
} of;

static void clear(void)
{
    shape_free(&of.shape);
    shape_curve_free(&of.gap);
    shape_curve_free(&of.conductance);
}

/** A new one, in place of that before. */
static void joint_make(size_t n, double side_m, double bulge_m)
{
    clear();
    of.nx = of.ny = n;
    of.side_m[0] = of.side_m[1] = side_m;
    of.bulge_m = bulge_m;
    of.modulus_Pa = 3.9e10;
    of.p0_Pa = 3e8;
    of.u_m = 0.3e-6;
    of.c = 0.05;
    of.power = 0.95;
    of.hardness_Pa = INFINITY;
    of.bodies[0] = of.bodies[1] = (struct shape_body){1. / 170, INFINITY};
}

enum { POINTS = 221 };

/** Grid, curves and the bulge F (2 r/over)², over the first side. */
static void lay_out(void)
{
    double pressure_Pa[POINTS], gap_m[POINTS], conductance[POINTS];
    for (int i = 0; i < POINTS; i++) {
        pressure_Pa[i] = pow(10, -12 + 0.1 * i);
        gap_m[i] = -of.u_m * log(pressure_Pa[i] / of.p0_Pa);
        conductance[i] = of.c * pow(pressure_Pa[i], of.power);
    }
    expect_ok(shape_make, &of.shape, of.nx, of.ny, of.side_m);
    expect_ok(shape_curve_gap, &of.gap, pressure_Pa, gap_m, POINTS, of.hardness_Pa);
    expect_ok(shape_curve_conductance, &of.conductance, pressure_Pa, conductance, POINTS);
    of.gap_m = support_room(of.nx * of.ny * sizeof *of.gap_m);
    for (size_t j = 0; j < of.ny; j++)
        for (size_t i = 0; i < of.nx; i++) {
            double x = ((double)i + 0.5) * of.side_m[0] / (double)of.nx - of.side_m[0] / 2;
            double y = ((double)j + 0.5) * of.side_m[1] / (double)of.ny - of.side_m[1] / 2;
            of.gap_m[j * of.nx + i] = of.bulge_m * (x * x + y * y) / pow(of.side_m[0] / 2, 2);
        }
}

/** Its pressures under the mean one, which they balance. */
static struct shape_spread press(double mean_Pa)
{
    double sum = 0;
    expect_ok(shape_press, &of.shape, of.gap_m, &of.gap, of.modulus_Pa, mean_Pa);
    for (size_t k = 0; k < of.shape.cells; k++)
        sum += of.shape.pressure_Pa[k];
    assert_near(sum / (double)of.shape.cells, mean_Pa, 1e-9);
    return shape_spread(&of.shape, of.hardness_Pa);
}

static double resist(void)
{
    double out, spots;
    expect_ok(shape_resistance, &out, &spots, &of.shape, &of.conductance, of.bodies);
    return out;
}

/** R over that of the flat joint. */
static double over_uniform(double mean_Pa)
{
    (void)press(mean_Pa);
    return resist() * of.c * pow(mean_Pa, of.power) * of.side_m[0] * of.side_m[1];
}

TEST_CASE(matches_reference)
{
    struct table table = table_read("golden/joint/shape.csv");
    assert_int_equal(table.rows, 7);
    for (size_t i = 0; i < table.rows; i++) {
        joint_make((size_t)table_number(&table, i, "n"), table_number(&table, i, "side_m"),
                   table_number(&table, i, "bulge_m"));
        of.modulus_Pa = table_number(&table, i, "E_Pa");
        of.p0_Pa = table_number(&table, i, "p0_Pa");
        of.u_m = table_number(&table, i, "u_m");
        of.c = table_number(&table, i, "c");
        of.bodies[0].resistivity = 1 / table_number(&table, i, "k1");
        of.bodies[1].resistivity = 1 / table_number(&table, i, "k2");
        lay_out();
        struct shape_spread spread = press(table_number(&table, i, "mean_pressure_Pa"));
        assert_cell(spread.largest_Pa, table, i, "largest_pressure_Pa", 1e-9);
        assert_within(spread.area, table_number(&table, i, "share_of_area_for_90_percent_of_load"),
                      1.5 / (double)of.shape.cells);
        assert_true(of.shape.steps < 30);
        assert_cell(resist(), table, i, "resistance_K_per_W", 1e-9);
    }
}

/** Parts that are flat have what their surfaces have at uniform pressure. */
TEST_CASE(flat_parts_change_nothing)
{
    joint_make(16, 20e-3, 0);
    of.ny = 9;
    of.side_m[1] = 7e-3;
    lay_out();
    assert_near(over_uniform(1.2345e6), 1, 1e-12);
    assert_near(press(1.2345e6).largest_Pa, 1.2345e6, 1e-12);
}

/** Perfect contact in a disc of radius a in the middle of a square of side b: a tube of the same area has
 * (1 - a/b)^1.5/(2 k a), a/b by areas (Cooper, Mikic and Yovanovich 1969, Int. J. Heat Mass Transfer 12, 279). */
TEST_CASE(tube)
{
    const double a = 4e-3, side = 20e-3, k = 200;
    joint_make(128, side, 0);
    of.c = 1;
    of.power = 1;
    of.bodies[0].resistivity = of.bodies[1].resistivity = 1 / k;
    lay_out();
    (void)press(1e6);
    double area = 0;
    for (size_t i = 0; i < of.shape.cells; i++) {
        double x = ((double)(i % of.nx) + 0.5) / (double)of.nx - 0.5,
               y = ((double)(i / of.nx) + 0.5) / (double)of.ny - 0.5;
        bool touches = hypot(x, y) * side < a;
        of.shape.ln_pressure[i] = touches ? log(1e9) : log(1e-6);
        area += touches * side * side / (double)of.shape.cells;
    }
    double radius = sqrt(area / M_PI), ratio = sqrt(area) / side;
    assert_near(resist(), pow(1 - ratio, 1.5) / (2 * k * radius), 0.02);
    /* with plates much thinner than it is wide the heat has no way to spread on: only the disc conducts */
    of.bodies[0].thickness_m = of.bodies[1].thickness_m = 1e-6;
    assert_near(resist(), 1 / (1e9 * area) + 2e-6 / k * (1 / area - 1 / (side * side)), 0.02);
}

/** Smooth parts: Hertz's pressures under a crown of radius R (Johnson 1985, eq. 4.22 to 4.24). */
TEST_CASE(hertz)
{
    const double a = 2e-3, radius = 1, side = 12e-3;
    joint_make(64, side, pow(side / 2, 2) / (2 * radius));
    of.u_m = 2e-9;
    lay_out();
    double force_N = 4 * of.modulus_Pa * pow(a, 3) / (3 * radius), most_Pa = 2 * of.modulus_Pa * a / (M_PI * radius);
    struct shape_spread spread = press(force_N / (side * side));
    assert_near(spread.largest_Pa, most_Pa, 0.02);
    /* 90 % of the load within r: 1 - (1 - r²/a²)^1.5 */
    assert_near(spread.area, M_PI * a * a * (1 - pow(0.1, 2. / 3)) / (side * side), 0.02);
}

/** More bulge costs more, more load less; both sides of the area count alike; a strip is one of any width. */
TEST_CASE(monotone)
{
    double last = 1 - 1e-12, wide[3];
    for (double bulge_m = 1e-7; bulge_m < 1e-4; bulge_m *= 3) {
        joint_make(32, 20e-3, bulge_m);
        lay_out();
        double now = over_uniform(1e6);
        assert_true(now > last);
        last = now;
    }
    last = INFINITY;
    for (double mean_Pa = 1e3; mean_Pa < 1e9; mean_Pa *= 10) {
        joint_make(32, 20e-3, 5e-6);
        lay_out();
        (void)press(mean_Pa);
        assert_true(resist() < last);
        last = resist();
    }
    for (int turned = 0; turned < 3; turned++) {
        joint_make(32, 20e-3, 10e-6);
        of.ny = turned == 2 ? 3 : 24;
        of.side_m[1] = turned == 2 ? 3e-3 : 12e-3;
        if (turned == 1) {
            of.nx = 24, of.ny = 32;
            of.side_m[0] = 12e-3, of.side_m[1] = 20e-3;
        }
        lay_out();
        for (size_t i = 0; i < of.shape.cells; i++) {
            double along = turned == 1 ? ((double)(i / of.nx) + 0.5) / 32 : ((double)(i % of.nx) + 0.5) / 32;
            of.gap_m[i] = 20e-6 * pow(along - 0.3, 2);
        }
        wide[turned] = over_uniform(1e6);
    }
    assert_near(wide[1], wide[0], 1e-9);
    assert_near(wide[2], wide[0], 1e-9);
    assert_true(wide[0] > 1.1);
}

/** Nothing presses harder than the hardness, and what would is counted. */
TEST_CASE(hardness)
{
    joint_make(64, 20e-3, 50e-6);
    of.hardness_Pa = 30e6;
    lay_out();
    struct shape_spread spread = press(1e6);
    assert_near(spread.largest_Pa, 30e6, 1e-6);
    assert_true(spread.yielding_load > 0.2 && spread.yielding_load < 1);
    double cells = spread.yielding_load * 1e6 * (double)of.shape.cells / 30e6;
    assert_true(cells > 20);
    assert_near(cells, round(cells), 1e-6);
    for (double hardness_Pa = 1.1e6; hardness_Pa < 50e6; hardness_Pa *= 2.1) {
        joint_make(32, 20e-3, 50e-6);
        of.hardness_Pa = hardness_Pa;
        lay_out();
        spread = press(1e6);
        assert_true(spread.largest_Pa <= hardness_Pa * (1 + 1e-12) && of.shape.steps < 60);
    }
    joint_make(64, 20e-3, 50e-6);
    of.hardness_Pa = 50e6;
    lay_out();
    spread = press(1e6);
    assert_true(spread.yielding_load == 0 && spread.largest_Pa < 50e6);
}

/** Elastic parts of stiff surfaces: it converges where cells without any load come into contact late. */
TEST_CASE(converges)
{
    for (double u_m = 1e-9; u_m < 2e-6; u_m *= 6)
        for (double bulge_m = 1e-6; bulge_m < 1e-3; bulge_m *= 8)
            for (double mean_Pa = 1e4; mean_Pa < 1e8; mean_Pa *= 100) {
                joint_make(32, 20e-3, bulge_m);
                of.u_m = u_m;
                lay_out();
                (void)press(mean_Pa);
                assert_true(of.shape.steps < 40);
            }
}

/** A gap that falls by steps, as of a model that was solved at some loads, has bends that whole steps go to and fro
 * over. */
TEST_CASE(bends)
{
    double pressure_Pa[POINTS], gap_m[POINTS];
    for (double mean_Pa = 1e6; mean_Pa < 1e7; mean_Pa *= 1.3) {
        joint_make(32, 20e-3, 5e-6);
        lay_out();
        for (int i = 0; i < POINTS; i++) {
            pressure_Pa[i] = pow(10, -12 + 0.1 * i);
            gap_m[i] = -0.3e-6 * (log(pressure_Pa[i]) + sin(5 * log(pressure_Pa[i])) / 5.2);
        }
        shape_curve_free(&of.gap);
        expect_ok(shape_curve_gap, &of.gap, pressure_Pa, gap_m, POINTS, INFINITY);
        (void)press(mean_Pa);
    }
}

/** A curve that is bent, rises by a hair, and ends. */
TEST_CASE(curves)
{
    const double pressure_Pa[] = {1e3, 1e4, 1e5, 1e6, 1e7}, gap_m[] = {5e-6, 3e-6, 3.01e-6, 1e-6, 1e-6};
    const double twice_Pa[] = {1e3, 1e3, 1e5}, lost_m[] = {3e-6, NAN, 1e-6};
    struct shape_curve gap, conductance;
    double slope, last = INFINITY, unused;
    expect_ok(shape_curve_gap, &gap, pressure_Pa, gap_m, 5, 1e9);
    for (double x = log(1e2); x < log(2e9); x += 0.01) {
        double now = shape_curve_value(&slope, &gap, x);
        assert_true(now < last && slope < 0);
        last = now;
    }
    assert_near(shape_curve_value(&slope, &gap, log(1e6)), 1e-6, 1e-14);
    assert_near(shape_curve_value(&slope, &gap, log(1e9)), 1e-6, 0.02);
    double light_m = shape_curve_value(&slope, &gap, log(1e2));
    assert_near(light_m, 5e-6 - slope * log(10), 1e-14);
    expect_ok(shape_curve_conductance, &conductance, pressure_Pa, pressure_Pa, 5);
    assert_near(shape_curve_value(&slope, &conductance, log(3e5)), log(3e5), 1e-14);
    assert_near(shape_curve_value(&unused, &conductance, log(3e9)), log(1e7), 1e-14);
    assert_near(shape_curve_value(&unused, &conductance, log(3e1)), log(3e1), 1e-13);
    shape_curve_free(&gap);
    shape_curve_free(&conductance);
    const struct {
        const double *pressure_Pa, *gap_m;
        double hardness_Pa;
        const char *says;
    } wrong[] = {{pressure_Pa, gap_m, 5e4, "its curve over pressure has 2 points; at least 3 are needed"},
                 {pressure_Pa, pressure_Pa, INFINITY, "its gap does not fall with the pressure"},
                 {twice_Pa, gap_m, INFINITY, "its curve over pressure is not finite at 0.001 MPa"},
                 {pressure_Pa, lost_m, INFINITY, "its curve over pressure is not finite at 0.01 MPa"}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        expect_fails(STATUS_MODEL, wrong[i].says, shape_curve_gap, &gap, wrong[i].pressure_Pa, wrong[i].gap_m, 3,
                     wrong[i].hardness_Pa);
        shape_curve_free(&gap);
    }
}
