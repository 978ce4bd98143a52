/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The direct solution of a wave and of a sphere on small grids, by another solver and by theory. */
#include "direct/direct_constriction.h"
#include "direct/direct_quantities.h"
#include "selftest/selftest.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 64 };
static const double amplitude = 0.01;

/* wave: one along x of 64 points, at a load over that of full contact; sphere: 64 x 64 points, at its a over the cell
 */
static const struct selftest_reference references[] = {
    {"wave", "gap over amplitude", {0.01}, 0.943893885792, 1e-11},
    {"wave", "gap over amplitude", {0.05}, 0.80019463283, 1e-11},
    {"wave", "gap over amplitude", {0.2}, 0.478017000383, 1e-11},
    {"wave", "constriction", {0.01}, 4.84005079439 / (2 * M_PI), 1e-9},
    {"wave", "constriction", {0.2}, 1.63585597141 / (2 * M_PI), 1e-9},
    {"wave", "gap over amplitude", {0.2}, 0.478112417513, 3e-4}, /* Westergaard 1939: 1 - x + x ln x */
    {"sphere", "contact points", {0.1}, 137, 1e-12},
    {"sphere", "corrected area", {0.1}, 1.01692908594 * M_PI * 0.01, 1e-9},
    {"sphere", "largest pressure", {0.1}, 1.00081883323 * 0.2 / M_PI, 1e-9},
    {"sphere", "largest pressure", {0.1}, 0.2 / M_PI, 2e-3}, /* Hertz 1882: 2 E' a/(pi R) */
};

struct solution {
    struct direct_quantities quantities;
    double constriction, most;
};

static enum status_code solve(struct solution *out, const double *height, size_t nx, size_t ny, double pressure,
                              struct status *status)
{
    struct direct_contact contact;
    struct direct_contact_effort effort = {0};
    const struct direct_contact_load load = {.mean_pressure = pressure, .hardness = INFINITY, .tolerance = 1e-12};
    *out = (struct solution){.most = 0};
    if (direct_contact_make(&contact, NULL, height, nx, ny, 1 / (double)nx, status) != STATUS_OK)
        return status->code;
    enum status_code rc = direct_contact_solve(&contact, &load, &effort, status);
    if (rc == STATUS_OK) {
        out->quantities = direct_quantities_of(&contact, &load);
        for (size_t k = 0; k < nx * ny; k++)
            out->most = fmax(out->most, contact.pressure[k / nx * contact.kernel.stride + k % nx]);
        rc = direct_constriction_of_contact(&out->constriction, &contact, 1e-10, NULL, &effort, status);
    }
    direct_contact_free(&contact);
    return rc;
}

/** Delta cos(2 pi x), its crest off the points. p* = pi E' Delta/L. */
static enum status_code solve_wave(struct solution *out, double load, struct status *status)
{
    double height[2 * SIDE];
    for (int i = 0; i < SIDE; i++)
        height[i] = height[SIDE + i] = amplitude * cos(2 * M_PI * (i + 0.3) / SIDE);
    return solve(out, height, SIDE, 2, load * M_PI * amplitude, status);
}

/** A paraboloid of radius 1, its apex off the points: P = 4 E' a³/(3 R). */
static enum status_code solve_sphere(struct solution *out, double a, struct status *status)
{
    double *height = malloc((size_t)SIDE * SIDE * sizeof *height);
    if (!height)
        return status_memory(status);
    for (int k = 0; k < SIDE * SIDE; k++) {
        double x = (double)(k % SIDE) / SIDE - 0.5 - 0.357 / 256, y = (double)(k / SIDE) / SIDE - 0.5 - 0.123 / 256;
        height[k] = -(pow(remainder(x, 1), 2) + pow(remainder(y, 1), 2)) / 2;
    }
    enum status_code rc = solve(out, height, SIDE, SIDE, 4.0 / 3 * a * a * a, status);
    free(height);
    return rc;
}

static enum status_code compute(double *values, const struct selftest_reference *all, size_t count,
                                struct status *status)
{
    struct solution solution = {.most = 0};
    for (size_t i = 0; i < count; i++) {
        bool wave = strcmp(all[i].what, "wave") == 0;
        bool known = i > 0 && strcmp(all[i].what, all[i - 1].what) == 0 && all[i].at[0] == all[i - 1].at[0];
        enum status_code rc = known  ? STATUS_OK
                              : wave ? solve_wave(&solution, all[i].at[0], status)
                                     : solve_sphere(&solution, all[i].at[0], status);
        if (rc != STATUS_OK)
            return rc;
        const struct direct_quantities *q = &solution.quantities;
        switch (all[i].of[0]) {
        case 'g':
            values[i] = q->gap_m / amplitude;
            break;
        case 'l':
            values[i] = solution.most;
            break;
        default:
            values[i] = strcmp(all[i].of, "constriction") == 0 ? solution.constriction
                        : strcmp(all[i].of, "contact points") == 0
                            ? (double)q->contact_points
                            : direct_area_corrected(q, (size_t)SIDE * SIDE, direct_kappa_yastrebov);
        }
    }
    return STATUS_OK;
}

const struct selftest_group selftest_direct = {
    .name = "direct",
    .source =
        "another solver on the same grids, to 12 digits; Westergaard's wave and Hertz's sphere, to the grid's error",
    .references = references,
    .count = sizeof references / sizeof references[0],
    .compute = compute,
};
