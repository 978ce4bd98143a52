/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The joint's shape on cells that have a rough surface's own curves, against that surface solved with the bulge in its
 * heights. */
#include "direct/direct_quantities.h"
#include "direct/direct_surface.h"
#include "joint/shape.h"
#include "statistics/coverage.h"
#include "support.h"
#include "validation/truths.h"

enum { SIDE = 512, CELLS = 64, NODES = 33, BULGES = 3, PRESSED = 4, SEEDS = 3 };
static const double bulges[BULGES] = {2, 8, 30}; /* over the rms height, over the half side */
static const double first_node = 1e-7, last_node = 0.4;
static const double pressed[PRESSED] = {3e-4, 3e-3, 3e-2,
                                        0.1}; /* mean pressure over E' g; lighter ones rest on a dozen spots */
static const double longest = 16, shortest = 128, hurst = 0.8; /* harmonics of the side */

static double variance(double r, const void *context)
{
    (void)context;
    return r >= longest && r <= shortest ? pow(r, -2 * (hurst + 1)) : 0;
}

static double rms_slope(const double *height_m)
{
    double sum = 0;
    for (size_t k = 0; k < SIDE * SIDE; k++)
        sum += pow(height_m[k - k % SIDE + (k + 1) % SIDE] - height_m[k], 2) +
               pow(height_m[(k + SIDE) % (SIDE * SIDE)] - height_m[k], 2);
    return sqrt(sum / (SIDE * SIDE)) * SIDE; /* of a side of 1 */
}

static void solve(struct direct_point *out, const double *height_m, const double *load, size_t loads)
{
    struct direct_contact contact;
    const struct direct_ladder_def def = {
        .load = load, .loads = loads, .hardness = INFINITY, .tolerance = 1e-6, .resistance = true};
    expect_ok(direct_contact_make, &contact, height_m, &(struct direct_grid){SIDE, SIDE, 1. / SIDE, false, false});
    expect_ok(direct_ladder_run, out, &contact, &def);
    direct_contact_free(&contact);
}

/** Length of constriction by the cells, of E' = 1 and a quarter of the area. */
static double by_cells(const struct shape_curve *gap, const struct shape_curve *conductance, double bulge_m,
                       double load)
{
    const double half[] = {0.5, 0.5};
    const struct shape_body bodies[2] = {{.resistivity = 1, .thickness_m = INFINITY}, {.thickness_m = INFINITY}};
    struct shape shape;
    double gap_m[CELLS * CELLS], resistance, spots;
    for (int k = 0; k < CELLS * CELLS; k++)
        gap_m[k] = bulge_m * (pow((k % CELLS + 0.5) / CELLS, 2) + pow((k / CELLS + 0.5) / CELLS, 2));
    expect_ok(shape_make, &shape, CELLS, CELLS, half);
    expect_ok(shape_press, &shape, gap_m, gap, 1, load);
    expect_ok(shape_resistance, &resistance, &spots, &shape, conductance, bodies);
    shape_free(&shape);
    return resistance / 4;
}

void shapes_add(struct page *page)
{
    OWNED(memory_free) double *rough_m = coverage_allocate(2 * SIDE * SIDE, sizeof *rough_m);
    double *height_m = rough_m + SIDE * SIDE, sum = 0;
    double truth[BULGES][PRESSED] = {{0}}, off[BULGES][PRESSED] = {{0}};
    for (int seed = 0; seed < SEEDS; seed++) {
        struct direct_point point[NODES], bulged[PRESSED];
        double load[NODES], gap_m[NODES], conductance[NODES];
        struct shape_curve gap, ways;
        expect_ok(direct_surface_make, rough_m, SIDE, &(struct direct_recipe){variance, NULL, NULL, 0},
                  1 + (uint64_t)seed);
        sum = 0;
        for (size_t k = 0; k < SIDE * SIDE; k++)
            sum += rough_m[k] * rough_m[k] / (SIDE * SIDE);
        const double slope = rms_slope(rough_m);
        size_t nodes = 0;
        for (int i = 0; i < NODES; i++)
            load[i] = slope * first_node * pow(last_node / first_node, i / (NODES - 1.));
        solve(point, rough_m, load, NODES);
        for (; nodes < NODES && direct_point_value(&point[nodes], DIRECT_AREA) < 0.97; nodes++) {
            gap_m[nodes] = direct_point_value(&point[nodes], DIRECT_GAP);
            conductance[nodes] = 1 / point[nodes].constriction_m;
        }
        expect_ok(shape_curve_gap, &gap, load, gap_m, nodes, INFINITY);
        expect_ok(shape_curve_conductance, &ways, load, conductance, nodes);
        for (int b = 0; b < BULGES; b++) {
            double mean[PRESSED], unused;
            for (size_t k = 0; k < SIDE * SIDE; k++) {
                double x = 2 * ((double)(k % SIDE) + 0.5) / SIDE - 1, y = 2 * ((double)(k / SIDE) + 0.5) / SIDE - 1;
                height_m[k] = rough_m[k] - bulges[b] * sqrt(sum) * (x * x + y * y);
            }
            for (int i = 0; i < PRESSED; i++)
                mean[i] = slope * pressed[i];
            solve(bulged, height_m, mean, PRESSED);
            for (int i = 0; i < PRESSED; i++) {
                double own = exp(-shape_curve_value(&unused, &ways, log(mean[i])));
                truth[b][i] += bulged[i].constriction_m / own / SEEDS;
                off[b][i] += by_cells(&gap, &ways, bulges[b] * sqrt(sum), mean[i]) / bulged[i].constriction_m / SEEDS;
            }
        }
        shape_curve_free(&gap);
        shape_curve_free(&ways);
    }
    page_rows(page, "shapes");
    for (int b = 0; b < BULGES; b++)
        for (int i = 0; i < PRESSED; i++) {
            text_add(&page->text, "| %g | %g | %.3g |", bulges[b], pressed[i], truth[b][i]);
            page_number(page, fabs(off[b][i] - 1), 0.1);
            text_add(&page->text, "\n");
        }
}
