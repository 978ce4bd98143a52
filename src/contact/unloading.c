/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/unloading.h"

#include "direct/direct_ladder.h"

#include <math.h>
#include <stdlib.h>

static const double shares[UNLOADING_SHARES] = {1, 0.75, 0.5, 0.35, 0.2, 0.13, 0.08, 0.05};

/** Of a strip on the way up. Its ratio of resistances is off from a surface's by a factor 1.6 with 4 ... 7 of them, 1.4
 * with 8 ... 15, 1.3 with 16 ... 63 and 1.25 with more. */
enum { LEAST_SPOTS = 16 };

/** Of the strip's solutions, over its rms height. */
static const double tolerance = 1e-3;

static double ratio(const struct direct_point *down, const struct direct_point *up, enum direct_quantity quantity)
{
    return log(direct_point_value(down, quantity) / direct_point_value(up, quantity));
}

/** Loads to which a strip with too few spots may be taken in place of the largest, over the hardness. */
static const double light = 0.2;

static enum status_code solve(struct unloading *out, struct direct_contact *strip, double largest_load, double hardness,
                              const atomic_bool *stop, struct status *status)
{
    double load[UNLOADING_SHARES];
    struct direct_point up[UNLOADING_SHARES], down[UNLOADING_SHARES];
    const struct direct_ladder_def def = {load, UNLOADING_SHARES, hardness, tolerance, true, stop};
    for (size_t i = 0; i < UNLOADING_SHARES; i++)
        load[i] = shares[i] * largest_load;
    enum status_code rc = direct_ladder_loop(up, down, strip, &def, LEAST_SPOTS, status);
    out->count = 0;
    for (size_t i = 0; i < UNLOADING_SHARES && rc == STATUS_OK && up[i].exists; i++) {
        for (int q = DIRECT_AREA; q <= DIRECT_CONSTRICTION; q++)
            out->value[i][q] = i > 0 ? ratio(&down[i], &up[i], (enum direct_quantity)q) : 0;
        out->transforms += strip->kernel.points * (up[i].convolutions + down[i].convolutions);
        out->share[out->count++] = shares[i];
    }
    return rc;
}

enum status_code unloading_solve(struct unloading *out, const struct strip_rows *rows, double largest_load,
                                 double hardness, const atomic_bool *stop, struct status *status)
{
    size_t points;
    double *strip_m = strip_join(&points, rows);
    *out = (struct unloading){.raised = 1};
    if (!strip_m)
        return status_memory(status);
    for (bool few = true; few; out->raised *= few ? 2 : 1) {
        struct direct_contact strip;
        if (direct_contact_make(&strip, strip_m, &(struct direct_grid){points, 1, rows->spacing_m, false}, status) ==
            STATUS_OK)
            (void)solve(out, &strip, out->raised * largest_load, hardness, stop, status);
        direct_contact_free(&strip);
        few = status->code == STATUS_OK && out->count < UNLOADING_SHARES &&
              2 * out->raised * largest_load <= light * hardness;
    }
    free(strip_m);
    return status->code;
}

/** Where a quantity stands in struct unloading; -1: nowhere. */
static int column_of(enum quantity quantity)
{
    const struct quantity_solved *solved = &quantity_rows[quantity].solved;
    return solved->column && !solved->elastic ? solved->mean : -1;
}

void unloading_bound(struct unloading *unloading, enum quantity quantity, const double *loading)
{
    int q = column_of(quantity);
    for (size_t k = 1; q >= 0 && k < unloading->count; k++) {
        double most = unloading->value[k - 1][q] + log(loading[k - 1] / loading[k]);
        if (isfinite(most) && (q == DIRECT_AREA ? unloading->value[k][q] > most : unloading->value[k][q] < most))
            unloading->value[k][q] = most;
    }
}

static const double rounding = 1e-9; /* of a load given twice, in different units */

double unloading_factor(const struct unloading *unloading, enum quantity quantity, double share)
{
    int q = column_of(quantity);
    size_t k = 0;
    if (q < 0 || unloading->count < 2 || !(share <= 1 + rounding && share >= unloading->share[unloading->count - 1]))
        return NAN;
    while (k + 2 < unloading->count && share < unloading->share[k + 1])
        k++;
    double from = unloading->share[k], place = log(share / from) / log(unloading->share[k + 1] / from);
    double ln = unloading->value[k][q] + place * (unloading->value[k + 1][q] - unloading->value[k][q]);
    return isfinite(ln) ? exp(ln) : NAN; /* what touches everywhere has no gap and no resistance left */
}
