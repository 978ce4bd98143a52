/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The direct solution of a wave and of a sphere on small grids, and of a profile. */
#include "direct/direct_constriction.h"
#include "direct/direct_quantities.h"
#include "selftest/selftest.h"

#include <math.h>
#include <string.h>

enum { SIDE = 64 };
static const double amplitude = 0.01;

static double largest_pressure(const struct direct_contact *contact)
{
    const struct direct_kernel *kernel = &contact->kernel;
    double largest = 0;
    for (size_t k = 0; k < kernel->points; k++)
        largest = fmax(largest, contact->pressure[k / kernel->nx * kernel->stride + k % kernel->nx]);
    return largest;
}

/** The number of a contact, which is freed, under a mean pressure. */
static enum status_code solve(double *value, const struct selftest_reference *r, struct direct_contact *contact,
                              double pressure, struct status *status)
{
    const struct direct_contact_load load = {.mean_pressure = pressure, .hardness = INFINITY, .tolerance = 1e-12};
    enum status_code rc = direct_contact_solve(contact, &load, status);
    if (rc == STATUS_OK && strcmp(r->quantity, "constriction") == 0) {
        rc = direct_constriction_of_contact(value, contact, 1e-10, NULL, status);
    } else if (rc == STATUS_OK) {
        const struct direct_quantities q = direct_quantities_of(contact, &load);
        const struct {
            const char *name;
            double value;
        } numbers[] = {{"gap over amplitude", q.gap_m / amplitude},
                       {"gap", q.gap_m},
                       {"faces", (double)q.perimeter_faces},
                       {"contact points", (double)q.contact_points},
                       {"corrected area", direct_area_corrected(&q, contact->kernel.points, direct_kappa_yastrebov)},
                       {"largest pressure", largest_pressure(contact)}};
        for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
            *value = strcmp(numbers[i].name, r->quantity) == 0 ? numbers[i].value : *value;
    }
    direct_contact_free(contact);
    return rc;
}

/** A wave: amplitude cos(2 pi x), its crest off the points; p* = pi E' amplitude/L. A sphere: a paraboloid of radius 1,
 * its apex off the points; P = 4 E' a³/(3 R). A strip: the profile `plateau`, in one row. */
enum status_code selftest_direct(double *value, const struct selftest_reference *r, const struct selftest_table *table,
                                 struct status *status)
{
    double height[SIDE * SIDE], a = r->at[0], pressure = a;
    struct direct_contact contact;
    enum status_code rc;
    if (strcmp(r->of, "strip") == 0) {
        rc = direct_contact_make(&contact, table->plateau_m, &(struct direct_grid){SELFTEST_PLATEAU, 1, 1e-6, false},
                                 status);
    } else if (strcmp(r->of, "wave") == 0) {
        for (int i = 0; i < SIDE; i++)
            height[i] = height[SIDE + i] = amplitude * cos(2 * M_PI * (i + 0.3) / SIDE);
        pressure = a * M_PI * amplitude;
        rc = direct_contact_make(&contact, height, &(struct direct_grid){SIDE, 2, 1.0 / SIDE, false}, status);
    } else if (strcmp(r->of, "sphere") == 0) {
        for (int k = 0; k < SIDE * SIDE; k++) {
            double x = (double)(k % SIDE) / SIDE - 0.5 - 0.357 / 256, y = (double)(k / SIDE) / SIDE - 0.5 - 0.123 / 256;
            height[k] = -(pow(remainder(x, 1), 2) + pow(remainder(y, 1), 2)) / 2;
        }
        pressure = 4.0 / 3 * a * a * a;
        rc = direct_contact_make(&contact, height, &(struct direct_grid){SIDE, SIDE, 1.0 / SIDE, false}, status);
    } else {
        return STATUS_OK;
    }
    return rc == STATUS_OK ? solve(value, r, &contact, pressure, status) : rc;
}
