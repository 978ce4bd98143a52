/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "members/map_contact.h"

#include "direct/direct_contact.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double tolerance = 1e-4;   /* enough for a picture and for spots that are counted in points */
static const double at_hardness = 1e-6; /* relative: a pressure this near to the hardness has reached it */

/** The points of a contact while its spots are collected. */
struct field {
    const struct direct_contact *contact;
    size_t n;
    uint8_t *left; /* is in contact, and not in a spot yet */
    uint32_t *at;  /* the points of the current spot */
};

static double pressure_at(const struct field *field, size_t k)
{
    return field->contact->pressure[k / field->n * field->contact->kernel.stride + k % field->n];
}

/** The spot that holds point k; takes all of its points. */
static struct map_spot take_spot(struct field *field, size_t k)
{
    const size_t n = field->n;
    const bool closes = !field->contact->kernel.mirrored;
    const double dx_m = field->contact->kernel.spacing_m;
    const double first_x = (double)(k % n), first_y = (double)(k / n);
    struct map_spot out = {0};
    size_t count = 0;
    double x = 0, y = 0; /* sums of distances from the first point, the shorter way around */
    field->left[k] = 0;
    field->at[count++] = (uint32_t)k;
    for (size_t i = 0; i < count; i++) {
        const size_t own = field->at[i], column = own % n, row = own / n;
        const size_t beside[4] = {row * n + (column + 1) % n, row * n + (column + n - 1) % n,
                                  (row + 1) % n * n + column, (row + n - 1) % n * n + column};
        const bool inside[4] = {column + 1 < n, column > 0, row + 1 < n, row > 0};
        x += remainder((double)column - first_x, closes ? (double)n : INFINITY);
        y += remainder((double)row - first_y, closes ? (double)n : INFINITY);
        out.force_m2 += pressure_at(field, own) * dx_m * dx_m;
        for (int b = 0; b < 4; b++)
            if ((inside[b] || closes) && field->left[beside[b]]) {
                field->left[beside[b]] = 0;
                field->at[count++] = (uint32_t)beside[b];
            }
    }
    out.area_m2 = (double)count * dx_m * dx_m;
    out.x_m = fmod(first_x + x / (double)count + (double)n, (double)n) * dx_m;
    out.y_m = fmod(first_y + y / (double)count + (double)n, (double)n) * dx_m;
    return out;
}

static enum status_code take_spots(struct map_contact *out, struct field *field, size_t touching, struct status *status)
{
    out->spots = malloc((touching < MAP_CONTACT_SPOTS ? touching : MAP_CONTACT_SPOTS) * sizeof *out->spots + 1);
    if (!out->spots)
        return status_memory(status);
    for (size_t k = 0; k < field->n * field->n; k++) {
        if (!field->left[k])
            continue;
        struct map_spot spot = take_spot(field, k);
        spot.x_m += out->from_m[0];
        spot.y_m += out->from_m[1];
        if (out->spot_count++ < MAP_CONTACT_SPOTS)
            out->spots[out->spot_count - 1] = spot;
    }
    if (out->spot_count > MAP_CONTACT_SPOTS) {
        free(out->spots);
        out->spots = NULL;
    }
    return STATUS_OK;
}

/** Cells, section and spots of the solution. */
static enum status_code draw_contact(struct map_contact *out, const struct direct_map *map, struct field *field,
                                     double hardness, struct status *status)
{
    const size_t n = field->n, block = (n + MAP_CONTACT_CELLS - 1) / MAP_CONTACT_CELLS, cells = n / block;
    double most = -1;
    size_t touching = 0, flowing = 0, section = 0;
    out->cell_m = (double)block * out->spacing_m;
    out->height_m = calloc(cells * cells, sizeof *out->height_m);
    out->is = calloc(cells * cells, sizeof *out->is);
    out->pressure = calloc(n, sizeof *out->pressure);
    if (!out->height_m || !out->is || !out->pressure)
        return status_memory(status);
    for (size_t j = 0; j < n; j++) {
        double carried = 0;
        for (size_t i = 0; i < n; i++) {
            const size_t k = j * n + i, cell = j / block * cells + i / block;
            const double pressure = pressure_at(field, k);
            const bool flows = pressure >= hardness * (1 - at_hardness);
            carried += pressure;
            touching += field->left[k];
            flowing += flows;
            if (i / block >= cells || j / block >= cells)
                continue;
            out->height_m[cell] += map->height_m[k] / (double)(block * block);
            out->is[cell] = flows                                         ? MAP_FLOWS
                            : field->left[k] && out->is[cell] == MAP_OPEN ? MAP_TOUCHES
                                                                          : out->is[cell];
        }
        if (carried > most) {
            most = carried;
            section = j;
        }
    }
    for (size_t i = 0; i < n; i++)
        out->pressure[i] = pressure_at(field, section * n + i);
    out->section_m = (double)section * out->spacing_m;
    out->touched = (double)touching / (double)(n * n);
    out->flowed = touching > 0 ? (double)flowing / (double)touching : 0;
    out->cells = cells;
    return take_spots(out, field, touching, status);
}

static enum status_code solve_square(struct map_contact *out, const struct direct_map *map,
                                     const struct direct_contact_load *load, struct status *status)
{
    OWNED(direct_contact_free) struct direct_contact contact = {.set = NULL};
    const size_t n = map->grid.nx;
    struct field field = {&contact, n, malloc(n * n), malloc(n * n * sizeof *field.at)};
    enum status_code rc = field.left && field.at ? STATUS_OK : status_memory(status);
    if (rc == STATUS_OK && (rc = direct_contact_make(&contact, map->height_m, &map->grid, status)) == STATUS_OK &&
        (rc = direct_contact_solve(&contact, load, status)) == STATUS_OK) {
        memcpy(field.left, direct_contact_touching(&contact), n * n);
        rc = draw_contact(out, map, &field, load->hardness, status);
    }
    free(field.left);
    free(field.at);
    return rc;
}

enum status_code map_contact_find(struct map_contact *out, const struct tiles *tiles, double load, double hardness,
                                  const atomic_bool *stop, struct status *status)
{
    const struct direct_map_def *def = &tiles->def;
    const size_t x = tiles->columns > 1 ? 0 : (def->nx - tiles->side) / 2,
                 y = tiles->rows > 1 ? 0 : (def->ny - tiles->side) / 2; /* where the first square begins */
    const struct direct_contact_load task = {load, hardness, tolerance, false, stop};
    OWNED(direct_map_free) struct direct_map map = {.height_m = NULL};
    struct status problem = {0};
    *out = (struct map_contact){.points = tiles->side,
                                .squares = tiles->columns * tiles->rows,
                                .spacing_m = def->dx_m,
                                .from_m = {(double)x * def->dx_m, (double)y * def->dx_m}};
    enum status_code rc = direct_map_make(&map, tiles->height_m + y * def->nx + x, def, tiles->side, &problem);
    if (rc == STATUS_OK)
        rc = solve_square(out, &map, &task, &problem);
    if (rc != STATUS_OK)
        map_contact_free(out);
    return rc == STATUS_INTERRUPTED || rc == STATUS_MEMORY ? status_fail(status, rc, "%s", problem.message) : STATUS_OK;
}

void map_contact_free(struct map_contact *contact)
{
    free(contact->height_m);
    free(contact->is);
    free(contact->pressure);
    free(contact->spots);
    *contact = (struct map_contact){0};
}
