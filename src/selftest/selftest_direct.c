/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The direct solution of a wave and of a sphere on small grids, and of a profile. */
#include "direct/direct_constriction.h"
#include "direct/direct_quantities.h"
#include "selftest/selftest.h"

#include <math.h>
#include <string.h>

enum { SIDE = 64 };
static const double amplitude = 0.01;

static double largest_pressure(const struct direct_contact *contact, size_t points)
{
    double largest = 0;
    for (size_t k = 0; k < points; k++)
        largest = fmax(largest, contact->pressure[k / SIDE * contact->kernel.stride + k % SIDE]);
    return largest;
}

/** The number of a contact that was solved. */
static enum status_code measure(double *value, const struct selftest_reference *r, struct direct_contact *contact,
                                const struct direct_contact_load *load, struct status *status)
{
    struct direct_contact_effort effort = {0};
    const struct direct_quantities quantities = direct_quantities_of(contact, load);
    if (strcmp(r->quantity, "constriction") == 0)
        return direct_constriction_of_contact(value, contact, 1e-10, NULL, &effort, status);
    if (strcmp(r->quantity, "gap over amplitude") == 0)
        *value = quantities.gap_m / amplitude;
    else if (strcmp(r->quantity, "gap") == 0)
        *value = quantities.gap_m;
    else if (strcmp(r->quantity, "faces") == 0)
        *value = (double)quantities.perimeter_faces;
    else if (strcmp(r->quantity, "contact points") == 0)
        *value = (double)quantities.contact_points;
    else if (strcmp(r->quantity, "corrected area") == 0)
        *value = direct_area_corrected(&quantities, (size_t)SIDE * SIDE, direct_kappa_yastrebov);
    else if (strcmp(r->quantity, "largest pressure") == 0)
        *value = largest_pressure(contact, (size_t)SIDE * SIDE);
    else
        return STATUS_OK;
    return STATUS_OK;
}

static enum status_code solve(double *value, const struct selftest_reference *r, const double *height, size_t nx,
                              size_t ny, double spacing_m, double pressure, struct status *status)
{
    struct direct_contact contact;
    struct direct_contact_effort effort = {0};
    const struct direct_contact_load load = {.mean_pressure = pressure, .hardness = INFINITY, .tolerance = 1e-12};
    if (direct_contact_make(&contact, height, nx, ny, spacing_m, status) != STATUS_OK)
        return status->code;
    enum status_code rc = direct_contact_solve(&contact, &load, &effort, status);
    if (rc == STATUS_OK)
        rc = measure(value, r, &contact, &load, status);
    direct_contact_free(&contact);
    return rc;
}

/** A wave: amplitude cos(2 pi x), its crest off the points; p* = pi E' amplitude/L. A sphere: a paraboloid of radius 1,
 * its apex off the points; P = 4 E' a³/(3 R). A strip: the profile `plateau`, in one row. */
enum status_code selftest_direct(double *value, const struct selftest_reference *r, const struct selftest_table *table,
                                 struct status *status)
{
    double height[SIDE * SIDE], a = r->at[0];
    if (strcmp(r->of, "strip") == 0)
        return solve(value, r, table->plateau_m, SELFTEST_PLATEAU, 1, 1e-6, a, status);
    if (strcmp(r->of, "wave") == 0) {
        for (int i = 0; i < SIDE; i++)
            height[i] = height[SIDE + i] = amplitude * cos(2 * M_PI * (i + 0.3) / SIDE);
        return solve(value, r, height, SIDE, 2, 1.0 / SIDE, a * M_PI * amplitude, status);
    }
    if (strcmp(r->of, "sphere") != 0)
        return STATUS_OK;
    for (int k = 0; k < SIDE * SIDE; k++) {
        double x = (double)(k % SIDE) / SIDE - 0.5 - 0.357 / 256, y = (double)(k / SIDE) / SIDE - 0.5 - 0.123 / 256;
        height[k] = -(pow(remainder(x, 1), 2) + pow(remainder(y, 1), 2)) / 2;
    }
    return solve(value, r, height, SIDE, SIDE, 1.0 / SIDE, 4.0 / 3 * a * a * a, status);
}
