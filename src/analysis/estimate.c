/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/estimate.h"

#include "statistics/interval.h"
#include <math.h>
#include <stdlib.h>

const double estimate_level = 0.95;
static const double normal_95 = 1.96; /* standard deviations of a normal error */
const struct estimate estimate_none = ESTIMATE_NONE;

/** The value, or its logarithm; NaN where there is none. */
static double scaled(double value, bool logarithmic)
{
    if (!logarithmic)
        return isfinite(value) ? value : NAN;
    return value > 0 && isfinite(value) ? log(value) : NAN;
}

/** A half width of logarithms whose ends are no numbers any more is none. */
static double bounded(double mean, double half_width, bool logarithmic)
{
    bool lost = logarithmic && (!isfinite(exp(mean + half_width)) || !(exp(mean - half_width) > 0));
    return lost ? NAN : half_width;
}

static struct estimate from_interval(const struct interval *interval, bool logarithmic)
{
    double half_width = interval->t * interval->s;
    return (struct estimate){
        .count = interval->count,
        .mean = interval->mean,
        .sd = interval->sd,
        .s = interval->s,
        .degrees = interval->degrees,
        .half_width = bounded(interval->mean, half_width, logarithmic),
        .next_half_width = bounded(interval->mean, interval_next_half_width(interval, 1), logarithmic),
        .effective = interval->effective,
        .logarithmic = logarithmic,
    };
}

/** One value, of which nothing more is known. */
static struct estimate alone(double value, bool logarithmic)
{
    struct estimate out = estimate_none;
    out.count = 1;
    out.mean = value;
    out.logarithmic = logarithmic;
    return out;
}

enum status_code estimate_make(struct estimate *out, const double *value, const double *weight, size_t count, bool rows,
                               bool logarithmic, struct status *status)
{
    struct interval interval;
    bool known = count > 0;
    double *own = malloc((count + 1) * sizeof *own);
    *out = estimate_none;
    out->logarithmic = logarithmic;
    if (!own)
        return status_memory(status);
    for (size_t i = 0; i < count; i++) {
        own[i] = scaled(value[i], logarithmic);
        known = known && !isnan(own[i]);
    }
    size_t parts = rows && count > ESTIMATE_BLOCKS ? ESTIMATE_BLOCKS : count;
    for (size_t b = 0; b < parts && parts < count; b++) {
        size_t first = b * count / parts, end = (b + 1) * count / parts;
        double base = own[first], mean = 0;
        for (size_t i = first; i < end; i++)
            mean += (own[i] - base) / (double)(end - first);
        own[b] = mean + base; /* equal rows have this very mean */
    }
    enum status_code rc = STATUS_OK;
    if (known && parts == 1) {
        *out = alone(own[0], logarithmic);
    } else if (known) {
        rc = rows ? interval_rows(&interval, own, parts, estimate_level, status)
                  : interval_scans(&interval, own, weight, parts, estimate_level, status);
        *out = rc == STATUS_OK ? from_interval(&interval, logarithmic) : *out;
    }
    if (rows)
        out->next_half_width = NAN; /* another row is no other scan */
    free(own);
    return rc;
}

struct estimate estimate_single(double value, const struct single_scan *single, bool logarithmic)
{
    struct estimate out = alone(scaled(value, logarithmic), logarithmic);
    if (isnan(out.mean))
        return estimate_none;
    out.sd = out.s = single->s;
    out.degrees = 0;
    out.half_width = bounded(out.mean, single->half_width, logarithmic);
    out.heterogeneous = single->heterogeneous;
    return out;
}

double estimate_value(const struct estimate *estimate)
{
    return estimate->logarithmic ? exp(estimate->mean) : estimate->mean;
}

bool estimate_has_width(const struct estimate *estimate, double half_width)
{
    static const double least = 1e-6; /* relative: what models are solved to */
    return half_width > least * (estimate->logarithmic ? 1 : fabs(estimate->mean));
}

static double end(const struct estimate *estimate, double half_width, int side)
{
    if (!estimate_has_width(estimate, half_width))
        return NAN;
    half_width = hypot(half_width, normal_95 * estimate->model_sd);
    double value = estimate->mean + (side ? half_width : -half_width);
    value = estimate->logarithmic ? exp(value) : value;
    return estimate->share ? fmin(value, 1) : value;
}

double estimate_end(const struct estimate *estimate, int side)
{
    return end(estimate, estimate->half_width, side);
}

double estimate_next_end(const struct estimate *estimate, int side)
{
    return end(estimate, estimate->next_half_width, side);
}
