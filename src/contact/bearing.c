/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/bearing.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>

struct bearing_at bearing_gaussian(double area_ratio, double m0_m2, double m2)
{
    double t = gsl_cdf_ugaussian_Qinv(area_ratio);
    return (struct bearing_at){sqrt(m0_m2) * (t * (1 - area_ratio) + gsl_ran_ugaussian_pdf(t)),
                               sqrt(m2 / m0_m2) / (2 * M_PI) * exp(-t * t / 2)};
}

enum { LEAST_CROSSINGS = 6 };

static double crossings_at(double area_ratio, const struct bearing *bearing);

/** The share nearest to none (side 0) or to all of the surface (1) at which the profiles rise through its height
 * LEAST_CROSSINGS times; a half where at none nearer. */
static double last_area(const struct bearing *bearing, int side)
{
    double length_m = (double)(bearing->rows->rows * bearing->rows->points) * bearing->rows->spacing_m, share;
    for (share = 1.5 / (double)bearing->count; share < 0.5; share *= 1.25)
        if (crossings_at(side ? 1 - share : share, bearing) * length_m >= LEAST_CROSSINGS)
            break;
    share = fmin(share, 0.5);
    return side ? 1 - share : share;
}

enum status_code bearing_make(struct bearing *out, const struct strip_rows *rows, struct status *status)
{
    size_t count = rows->rows * rows->points;
    *out = (struct bearing){
        rows, malloc((count + 1) * sizeof(double)), malloc((count + 1) * sizeof(double)), count, {0, 1}};
    if (!out->height_m || !out->below_m) {
        bearing_free(out);
        return status_memory(status);
    }
    for (size_t i = 0; i < count; i++)
        out->height_m[i] = -rows->height_m[i];
    gsl_sort(out->height_m, 1, count);
    out->below_m[count] = 0;
    for (size_t i = count; i-- > 0;) {
        out->height_m[i] = -out->height_m[i];
        out->below_m[i] = out->below_m[i + 1] + out->height_m[i];
    }
    for (int side = 0; side < 2; side++)
        out->area[side] = last_area(out, side);
    return STATUS_OK;
}

void bearing_free(struct bearing *bearing)
{
    free(bearing->height_m);
    free(bearing->below_m);
    *bearing = (struct bearing){0};
}

/** Where in the ordered heights the one is that a share of the surface exceeds. */
static double place_of(double area_ratio, const struct bearing *bearing)
{
    double n = (double)bearing->count;
    return fmin(fmax(area_ratio * n - 0.5, 0), n - 1);
}

static double height_at(double area_ratio, const struct bearing *bearing)
{
    double place = place_of(area_ratio, bearing);
    size_t above = (size_t)place, next = above + 1 < bearing->count ? above + 1 : above;
    return bearing->height_m[above] + (place - (double)above) * (bearing->height_m[next] - bearing->height_m[above]);
}

/** Times per metre that profiles rise through a height, mean over those of low_m ... high_m. */
static double crossings(const struct strip_rows *rows, double low_m, double high_m)
{
    double risen_m = 0;
    size_t steps = rows->points - !rows->periodic; /* of a row */
    for (size_t r = 0; r < rows->rows; r++) {
        const double *z = rows->height_m + r * rows->points;
        for (size_t i = 0; i < steps; i++) {
            double to_m = z[i + 1 < rows->points ? i + 1 : 0], from_m = z[i] > low_m ? z[i] : low_m;
            to_m = to_m < high_m ? to_m : high_m; /* inline, as fmin() is not */
            risen_m += to_m > from_m ? to_m - from_m : 0;
        }
    }
    return risen_m / (high_m - low_m) / ((double)(rows->rows * steps) * rows->spacing_m);
}

/** Mean over the heights of half to twice the odds A/(1-A): crossings of one height alone go by whole numbers. */
static double crossings_at(double area_ratio, const struct bearing *bearing)
{
    double odds = area_ratio / (1 - area_ratio);
    double low = height_at(2 * odds / (1 + 2 * odds), bearing), high = height_at(odds / (2 + odds), bearing);
    return crossings(bearing->rows, low, fmax(high, nextafter(low, INFINITY)));
}

static double gap_at(double area_ratio, const struct bearing *bearing)
{
    size_t below = (size_t)place_of(area_ratio, bearing) + 1;
    double points = (double)(bearing->count - below), all = (double)bearing->count;
    return (points * height_at(area_ratio, bearing) - bearing->below_m[below]) / all;
}

struct bearing_at bearing_counted(double area_ratio, const struct bearing *bearing)
{
    double points = fmin(fmax(area_ratio, LEAST_CROSSINGS / (double)bearing->count), bearing->area[1]);
    double counted = fmax(points, bearing->area[0]);
    struct bearing_at here = bearing_gaussian(area_ratio, 1, 1);
    return (struct bearing_at){
        gap_at(points, bearing) * (points == area_ratio ? 1 : here.gap_m / bearing_gaussian(points, 1, 1).gap_m),
        crossings_at(counted, bearing) *
            (counted == area_ratio ? 1 : here.crossings_per_m / bearing_gaussian(counted, 1, 1).crossings_per_m)};
}

double bearing_area(double elastic_area_ratio, double load_over_hardness)
{
    double most = fmax(elastic_area_ratio, load_over_hardness),
           share = fmin(elastic_area_ratio, load_over_hardness) / most; /* the fourth powers alone may underflow */
    return fmin(1, most * pow(1 + pow(share, 4), 0.25));
}

/** (a^-3 + b^-3)^(-1/3) of positive numbers, the smaller if one is without bound. */
static double in_parallel(double a, double b)
{
    double least = fmin(a, b), share = least / fmax(a, b);
    return least / cbrt(1 + share * share * share);
}

struct bearing_contact bearing_contact(double area_ratio, double load_over_hardness,
                                       const struct bearing_contact *elastic, const struct bearing_at *at)
{
    double longer = cbrt(area_ratio / load_over_hardness); /* w^(-1/3) */
    double length_m = pow(1 - sqrt(area_ratio), 1.5) / (2 * at->crossings_per_m);
    return (struct bearing_contact){area_ratio, in_parallel(elastic->separation_m, longer * at->gap_m),
                                    in_parallel(elastic->constriction_m, longer * length_m / 0.8)};
}
