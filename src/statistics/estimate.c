/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "statistics/estimate.h"

#include "statistics/interval.h"
#include <assert.h>
#include <math.h>
#include <stdlib.h>

const double estimate_level = 0.95;
const struct estimate estimate_none = {
    .mean = NAN, .sd = NAN, .s = NAN, .degrees = NAN, .half_width = NAN, .next_half_width = NAN, .effective = NAN};

/** The value or its logarithm; NaN: not known. */
static double scaled(double value, bool logarithmic)
{
    if (!logarithmic)
        return isfinite(value) ? value : NAN;
    return value > 0 && isfinite(value) ? log(value) : NAN;
}

/** NaN if an end of the logarithmic interval is out of the range of double. */
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
        .next_half_width = bounded(interval->mean, interval_next_half_width(interval), logarithmic),
        .effective = interval->effective,
        .logarithmic = logarithmic,
    };
}

/** One value without an interval. */
static struct estimate alone(double value, bool logarithmic)
{
    struct estimate out = estimate_none;
    out.count = 1;
    out.mean = value;
    out.logarithmic = logarithmic;
    return out;
}

enum status_code estimate_make(struct estimate *out, const double *value, const double *weight, size_t count,
                               bool logarithmic, struct status *status)
{
    struct interval interval;
    bool known = count > 0;
    OWNED(memory_free) double *own = malloc((count + 1) * sizeof *own);
    *out = estimate_none;
    out->logarithmic = logarithmic;
    if (!own)
        return status_memory(status);
    for (size_t i = 0; i < count; i++) {
        own[i] = scaled(value[i], logarithmic);
        known = known && !isnan(own[i]);
    }
    if (known && count == 1) {
        *out = alone(own[0], logarithmic);
    } else if (known) {
        if (interval_scans(&interval, own, weight, count, estimate_level, status) == STATUS_OK)
            *out = from_interval(&interval, logarithmic);
    }
    return status->code;
}

struct estimate estimate_of_error(double value, double s, double degrees)
{
    struct estimate out = alone(scaled(value, true), true);
    if (isnan(out.mean))
        return estimate_none;
    out.sd = out.s = s;
    out.degrees = degrees;
    out.half_width = bounded(out.mean, interval_quantile(estimate_level, degrees) * s, true);
    return out;
}

double estimate_value(const struct estimate *estimate)
{
    return estimate->logarithmic ? exp(estimate->mean) : estimate->mean;
}

/** Is a half-width known and more than rounding? */
static bool has_width(const struct estimate *estimate, double half_width)
{
    static const double least = 1e-6; /* relative: what models are solved to */
    return half_width > least * (estimate->logarithmic ? 1 : fabs(estimate->mean));
}

double estimate_within(double value, const double bound[2])
{
    value = bound[0] > 0 && value < bound[0] ? bound[0] : value;
    return bound[1] > 0 && value > bound[1] ? bound[1] : value;
}

static double end(const struct estimate *estimate, double half_width, int side)
{
    if (!has_width(estimate, half_width))
        return NAN;
    if (estimate->model_sd > 0) {
        double s = estimate->s * (half_width / estimate->half_width), both = hypot(s, estimate->model_sd);
        half_width = interval_quantile(estimate_level, estimate->degrees * pow(both / s, 4)) * both;
    }
    double value = estimate->mean + (side ? half_width : -half_width);
    return estimate_within(estimate->logarithmic ? exp(value) : value, estimate->bound);
}

double estimate_end(const struct estimate *estimate, int side)
{
    return end(estimate, estimate->half_width, side);
}

double estimate_next_end(const struct estimate *estimate, int side)
{
    return end(estimate, estimate->next_half_width, side);
}

static const double unknown_quarters = 0.5;

/** Standard deviation of those that are finite; NaN: fewer than `least`. */
static double deviation(const double *value, size_t count, size_t least)
{
    double mean = 0, square = 0, finite = 0;
    for (size_t i = 0; i < count; i++) {
        if (!isfinite(value[i]))
            continue;
        double step = value[i] - mean;
        mean += step / ++finite;
        square += step * (value[i] - mean);
    }
    return finite >= (double)least ? sqrt(square / (finite - 1)) : NAN;
}

double single_scan_s(const double *record, size_t records, const double *quarter, size_t quarters)
{
    double own = deviation(quarter, quarters, SINGLE_SCAN_QUARTERS - 1);
    assert(records >= 4);
    return hypot(deviation(record, records, records / 2), M_SQRT1_2 * (isnan(own) ? unknown_quarters : own));
}

double single_scan_s_at(double ln_load, const double *node_ln_load, const double *node_s, size_t nodes)
{
    double at = NAN, s = NAN; /* the last known node below */
    for (size_t i = 0; i < nodes; i++) {
        if (isnan(node_s[i]))
            continue;
        if (ln_load <= node_ln_load[i])
            return isnan(s) ? node_s[i] : s + (ln_load - at) / (node_ln_load[i] - at) * (node_s[i] - s);
        at = node_ln_load[i];
        s = node_s[i];
    }
    return s;
}
