/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/bearing.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/** l_b where profiles rise through a height `crossings_per_m` times per metre; INFINITY where they never do. */
static double length_of(double area_ratio, double crossings_per_m)
{
    return crossings_per_m > 0 ? pow(1 - sqrt(area_ratio), 1.5) / (2 * crossings_per_m) : INFINITY;
}

struct bearing_at bearing_gaussian(double area_ratio, double m0_m2, double m2)
{
    double t = gsl_cdf_ugaussian_Qinv(area_ratio);
    return (struct bearing_at){sqrt(m0_m2) * (t * (1 - area_ratio) + gsl_ran_ugaussian_pdf(t)),
                               length_of(area_ratio, sqrt(m2 / m0_m2) / (2 * M_PI) * exp(-t * t / 2))};
}

enum {
    LEAST_CROSSINGS = 6,
    TURN = 8 /* nodes per doubling of the odds A/(1-A) */
};

/** Area ratio at node k: the odds A/(1-A) are 1 at the middle node. */
static double share_at(size_t k, size_t nodes)
{
    double odds = exp2(((double)k - (double)(nodes / 2)) / TURN);
    return odds / (1 + odds);
}

/** Index, with its fraction, of the height that a share of the surface exceeds. */
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

/** Integral of the number of upward crossings over height, from the lowest height to each level (highest first). A
 * profile adds one crossing above each point where it starts to rise, and takes one away where it stops. */
static void integrate_crossings(double *integral_m, const double *level_m, size_t nodes, const struct strip_rows *rows,
                                double lowest_m, double *rising)
{
    memset(integral_m, 0, nodes * sizeof *integral_m);
    memset(rising, 0, nodes * sizeof *rising);
    for (size_t i = 0; i < rows->rows * rows->points; i++) {
        const double *z = rows->height_m + i / rows->points * rows->points;
        size_t n = rows->points, at = i % n;
        bool first = at == 0 && !rows->periodic, last = at + 1 == n && !rows->periodic;
        int turn = (!last && z[at + 1 < n ? at + 1 : 0] > z[at]) - (!first && z[at] > z[at > 0 ? at - 1 : n - 1]);
        size_t above = 0; /* nodes above z */
        while (turn != 0 && above < nodes && level_m[above] > z[at] - lowest_m)
            above++;
        if (above > 0) {
            rising[above - 1] += turn;
            integral_m[above - 1] -= turn * (z[at] - lowest_m);
        }
    }
    for (size_t k = nodes; k-- > 0;) {
        rising[k] += k + 1 < nodes ? rising[k + 1] : 0;
        integral_m[k] += k + 1 < nodes ? integral_m[k + 1] : 0;
    }
    for (size_t k = 0; k < nodes; k++)
        integral_m[k] += rising[k] * level_m[k];
}

/** ln l_b at the nodes with enough crossings, made never to rise. Crossings are averaged over the heights from half to
 * twice the odds, since at a single height their number is whole and changes in steps. */
static void fill_lengths(struct bearing *out, const struct strip_rows *rows, double lowest_m, double *room)
{
    size_t nodes = out->nodes, middle = nodes / 2, steps = rows->rows * (rows->points - !rows->periodic);
    double *integral_m = room, *level_m = room + nodes, length_m = (double)steps * rows->spacing_m;
    for (size_t k = 0; k < nodes; k++)
        level_m[k] = height_at(share_at(k, nodes), out);
    integrate_crossings(integral_m, level_m, nodes, rows, lowest_m, out->ln_length);
    out->end[0] = out->end[1] = middle;
    for (size_t k = 0; k < nodes; k++) {
        size_t up = k > TURN ? k - TURN : 0, down = k + TURN < nodes ? k + TURN : nodes - 1;
        double wide_m = level_m[up] - level_m[down];
        double number = wide_m > 0 ? (integral_m[up] - integral_m[down]) / wide_m : 0;
        out->ln_length[k] = log(length_of(share_at(k, nodes), number / length_m));
        if (number >= LEAST_CROSSINGS) {
            out->end[0] = k < out->end[0] ? k : out->end[0];
            out->end[1] = k > out->end[1] ? k : out->end[1];
        }
    }
    for (size_t k = out->end[0] + 1; k <= out->end[1]; k++)
        out->ln_length[k] = fmin(out->ln_length[k], out->ln_length[k - 1]);
}

enum status_code bearing_make(struct bearing *out, const struct strip_rows *rows, struct status *status)
{
    size_t count = rows->rows * rows->points, nodes = 2 * (size_t)(TURN * log2((double)count + 1)) + 1;
    OWNED(memory_free) double *room = malloc(2 * nodes * sizeof *room);
    double lowest_m = INFINITY;
    *out = (struct bearing){.height_m = malloc((count + 1) * sizeof(double)),
                            .below_m = malloc((count + 1) * sizeof(double)),
                            .ln_length = malloc(nodes * sizeof(double)),
                            .count = count,
                            .nodes = nodes};
    if (!out->height_m || !out->below_m || !out->ln_length || !room) {
        bearing_free(out);
        return status_memory(status);
    }
    for (size_t i = 0; i < count; i++) {
        out->height_m[i] = -rows->height_m[i];
        lowest_m = fmin(lowest_m, rows->height_m[i]);
    }
    gsl_sort(out->height_m, 1, count);
    out->below_m[count] = 0;
    for (size_t i = count; i-- > 0;) {
        out->height_m[i] = -out->height_m[i] - lowest_m; /* relative to the lowest, so that sums keep their digits */
        out->below_m[i] = out->below_m[i + 1] + out->height_m[i];
    }
    fill_lengths(out, rows, lowest_m, room);
    return STATUS_OK;
}

void bearing_free(struct bearing *bearing)
{
    free(bearing->height_m);
    free(bearing->below_m);
    free(bearing->ln_length);
    *bearing = (struct bearing){0};
}

static double gap_at(double area_ratio, const struct bearing *bearing)
{
    size_t below = (size_t)place_of(area_ratio, bearing) + 1;
    double points = (double)(bearing->count - below);
    return (points * height_at(area_ratio, bearing) - bearing->below_m[below]) / (double)bearing->count;
}

/** ln l_b between nodes. */
static double counted_length(double area_ratio, const struct bearing *bearing)
{
    double place = TURN * log2(area_ratio / (1 - area_ratio)) + (double)(bearing->nodes / 2);
    size_t k = (size_t)place;
    if (place <= (double)bearing->end[0])
        return bearing->ln_length[bearing->end[0]];
    if (place >= (double)bearing->end[1])
        return bearing->ln_length[bearing->end[1]];
    return bearing->ln_length[k] + (place - (double)k) * (bearing->ln_length[k + 1] - bearing->ln_length[k]);
}

struct bearing_at bearing_counted(double area_ratio, const struct bearing *bearing)
{
    double least = share_at(bearing->end[0], bearing->nodes), most = share_at(bearing->end[1], bearing->nodes);
    double points = fmin(fmax(area_ratio, LEAST_CROSSINGS / (double)bearing->count), most);
    double counted = fmin(fmax(area_ratio, least), most);
    struct bearing_at out = {gap_at(points, bearing), exp(counted_length(counted, bearing))};
    if (points != area_ratio)
        out.gap_m *= bearing_gaussian(area_ratio, 1, 1).gap_m / bearing_gaussian(points, 1, 1).gap_m;
    if (counted != area_ratio)
        out.length_m *= bearing_gaussian(area_ratio, 1, 1).length_m / bearing_gaussian(counted, 1, 1).length_m;
    return out;
}

const double bearing_area_sd = 0.03;

double bearing_area(double elastic_area_ratio, double load_over_hardness)
{
    double most = fmax(elastic_area_ratio, load_over_hardness),
           share = fmin(elastic_area_ratio, load_over_hardness) / most; /* the fourth powers alone may underflow */
    return fmin(1, most * pow(1 + pow(share, 4), 0.25));
}

/** (a^-3 + b^-3)^(-1/3) of positive numbers; the smaller where the other is infinite. */
static double in_parallel(double a, double b)
{
    double least = fmin(a, b), share = least / fmax(a, b);
    return least / cbrt(1 + share * share * share);
}

double bearing_gap(double elastic_m, double share, const struct bearing_at *at)
{
    return in_parallel(elastic_m, at->gap_m / cbrt(share));
}

double bearing_length(double elastic_m, double share, const struct bearing_at *at)
{
    return in_parallel(elastic_m, at->length_m / cbrt(share) / 0.8);
}
