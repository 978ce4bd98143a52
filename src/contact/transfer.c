/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/transfer.h"

#include "base/isotonic.h"
#include "contact/corrected_persson.h"
#include "contact/model.h"
#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

const double transfer_ladder[TRANSFER_LADDER] = {1e-4, 2.5e-4, 6e-4, 1.5e-3, 4e-3, 0.01, 0.022, 0.045, 0.085,
                                                 0.15, 0.25,   0.4,  0.6,    0.9,  1.35, 2.1,   3.5};

extern const struct model_row model_strip;

static const double grid_step = 0.1, grid_below = 20; /* in ln p; the grid starts so far below the first solution */

size_t transfer_capped_loads(double load[TRANSFER_LOADS], double gradient, double hardness)
{
    static const double shares[] = {0.25, 0.4, 0.55, 0.7, 0.8, 0.9}, apart = 1.25;
    size_t count = 0;
    for (size_t k = 0; k < TRANSFER_LADDER && isfinite(hardness); k++)
        if (transfer_ladder[k] * gradient < shares[0] / apart * hardness)
            load[count++] = transfer_ladder[k] * gradient;
    for (size_t k = 0; k < sizeof shares / sizeof *shares && count > 0; k++)
        if (shares[k] * hardness <= transfer_ladder[TRANSFER_LADDER - 1] * gradient)
            load[count++] = shares[k] * hardness;
    return count;
}

/** Adds ln of corrected-persson's answer at the knots of `out`. */
static void add_gaussian(struct strip_curve *out, const struct persson *persson)
{
    struct corrected_persson_point point[STRIP_KNOTS];
    for (size_t k = 0; k < out->count; k++)
        point[k].area_ratio = logistic(out->logit[k]);
    corrected_persson_curve(point, out->count, persson, true);
    for (size_t k = 0; k < out->count; k++) {
        out->value[k][0] += log(corrected_persson_load(point[k].area_ratio, persson->m2));
        out->value[k][1] += log(point[k].constriction_m);
        out->value[k][2] += log(point[k].separation_m);
    }
}

/** A square's elastic solutions as a strip, with corrected-persson as its surrogate; the last one is interpolated at
 * the largest area. */
static void make_strip(struct strip *out, const struct transfer_point *point, size_t count,
                       const struct persson *persson)
{
    const double last = logit(CORRECTED_PERSSON_LARGEST_AREA);
    struct strip_curve *own = &out->own;
    double before = -INFINITY, known[3] = {0};
    *out = (struct strip){.surrogates = 1};
    for (size_t i = 0; i < count && before < last && own->count < STRIP_KNOTS; i++, point++) {
        double at = logit(point->area_ratio), share = fmin(1, (last - before) / (at - before));
        const double value[3] = {log(point->load), log(point->constriction_m), log(point->separation_m)};
        if (!(at > before) || !isfinite(value[1]) || !isfinite(value[2]) || (own->count == 0 && at > last))
            continue;
        own->logit[own->count] = fmin(at, last);
        for (int q = 0; q < 3; q++)
            known[q] = own->value[own->count][q] = own->count > 0 ? known[q] + share * (value[q] - known[q]) : value[q];
        own->count++;
        before = at;
    }
    out->surrogate[0].count = own->count;
    memcpy(out->surrogate[0].logit, own->logit, sizeof own->logit);
    add_gaussian(&out->surrogate[0], persson);
}

/** The mean ratio of the squares, as a strip of the whole surface. */
static void join(struct strip *out, const struct strip *strip, size_t count, const struct persson *persson)
{
    const double last = logit(CORRECTED_PERSSON_LARGEST_AREA);
    struct strip_curve *own = &out->own;
    double low = 0;
    *out = (struct strip){.surrogates = 1};
    for (size_t s = 0; s < count; s++)
        low += strip[s].own.logit[0] / (double)count;
    *own = strip[0].own;
    own->count = count > 1 ? STRIP_KNOTS : own->count;
    for (size_t k = 0; k < own->count; k++) {
        own->logit[k] = count > 1 ? low + (last - low) * (double)k / (STRIP_KNOTS - 1) : own->logit[k];
        for (int q = 0; q < 3; q++)
            own->value[k][q] = 0;
        for (size_t s = 0; s < count; s++) {
            struct strip_ratio ratio = strip_ratio_at(&strip[s], logistic(own->logit[k]));
            own->value[k][0] += ratio.load / (double)count;
            own->value[k][1] += ratio.constriction / (double)count;
            own->value[k][2] += ratio.separation / (double)count;
        }
    }
    struct strip_curve *gaussian = &out->surrogate[0];
    gaussian->count = own->count;
    memcpy(gaussian->logit, own->logit, sizeof own->logit);
    add_gaussian(gaussian, persson);
    add_gaussian(own, persson);
}

static void put_ln(double out[3], const struct transfer_point *point)
{
    out[0] = log(point->area_ratio);
    out[1] = log(point->separation_m);
    out[2] = log(point->constriction_m);
}

/** Adds a contact; false beyond the largest area. */
static bool add_point(struct transfer_curve *curve, const struct transfer_point *point)
{
    double value[3];
    put_ln(value, point);
    if (!(point->area_ratio <= CORRECTED_PERSSON_LARGEST_AREA) || !isfinite(value[0] + value[1] + value[2]))
        return false;
    curve->ln_load[curve->count] = log(point->load);
    memcpy(curve->value[curve->count++], value, sizeof value);
    return true;
}

static void make_monotone(struct transfer_curve *curve)
{
    for (size_t q = 0; q < 3; q++)
        isotonic(&curve->value[0][q], curve->count, 3, q > 0);
}

/** The elastic curve, by strip transfer. */
static enum status_code make_elastic(struct transfer_curve *out, const struct spectrum *spectrum,
                                     const struct strip *strip, struct status *status)
{
    static const struct material_pair pair = {.effective_modulus_Pa = 1, .resistivity_ohm_m = 0.5}; /* ECR A_n is l */
    double load[TRANSFER_GRID];
    struct model_curve curve = {.points = malloc((TRANSFER_GRID + 1) * sizeof *curve.points)};
    const struct model_task task = {.spectrum = spectrum,
                                    .pair = &pair,
                                    .loads = load,
                                    .load_count = TRANSFER_GRID,
                                    .strip = strip,
                                    .wanted = QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_SEPARATION) |
                                              QUANTITY_BIT(QUANTITY_ECR)};
    out->count = 0;
    if (!curve.points)
        return status_memory(status);
    for (size_t k = 0; k < TRANSFER_GRID; k++)
        load[k] = exp(strip->own.value[0][0] - grid_below + grid_step * (double)k);
    if (model_run(&curve, &model_strip, &task, status) == STATUS_OK && curve.exists)
        for (size_t k = 0; k < curve.count; k++) {
            const double *value = curve.points[k].value;
            const struct transfer_point point = {load[k], value[QUANTITY_AREA], value[QUANTITY_SEPARATION],
                                                 value[QUANTITY_ECR]};
            if (!add_point(out, &point))
                break;
        }
    make_monotone(out);
    free(curve.points);
    return status->code;
}

/** Linear interpolation between ascending places, constant beyond the ends. */
static double between(double at, const double *place, size_t step, const double *value, size_t stride, size_t count)
{
    size_t high = 1;
    if (count < 2 || at <= place[0])
        return value[0];
    while (high + 1 < count && place[high * step] < at)
        high++;
    const double *ends = place + (high - 1) * step, *values = value + (high - 1) * stride;
    double share = fmin(1, (at - ends[0]) / (ends[step] - ends[0]));
    return (1 - share) * values[0] + share * values[stride];
}

static const double bearing_first = -9, bearing_step = 0.2; /* in logit A */

void transfer_bearing(double out[TRANSFER_BEARING], double *height_m, size_t count)
{
    double below = 0, least; /* sum of the depths below the present height */
    size_t k = 0;
    gsl_sort(height_m, 1, count);
    least = 1e-6 * (height_m[count - 1] - height_m[0]); /* where the lowest heights are equal */
    for (size_t i = 0; i < count && k < TRANSFER_BEARING; i++) {
        below += i > 0 ? (double)i * (height_m[i] - height_m[i - 1]) : 0;
        for (; k < TRANSFER_BEARING; k++) { /* falling shares */
            double share = logistic(bearing_first + bearing_step * (double)(TRANSFER_BEARING - 1 - k));
            if ((double)(count - i) > share * (double)count + 1)
                break;
            out[TRANSFER_BEARING - 1 - k] = log(fmax(below / (double)count, least));
        }
    }
}

/** A surface that yields: its elastic curve and its bearing curve. */
struct yielding {
    const struct transfer_curve *elastic;
    const double *bearing;
    double hardness;
};

/** The closed form that solutions with a hardness are compared with (equations: hardness): area (A_e^4 +
 * (P/H)^4)^(1/4), gap of elastic contact and bearing curve in parallel, length of the elastic curve at that area. False
 * beyond its end. */
static bool hardened(double out[3], const struct yielding *of, double load)
{
    const struct transfer_curve *elastic = of->elastic;
    const double *values = &elastic->value[0][0], at = log(load), ratio = load / of->hardness;
    if (elastic->count < 2 || at > elastic->ln_load[elastic->count - 1])
        return false;
    double area = bearing_area(exp(between(at, elastic->ln_load, 1, values, 3, elastic->count)), ratio);
    double place = fmin(fmax((logit(area) - bearing_first) / bearing_step, 0), TRANSFER_BEARING - 1.001);
    size_t k = (size_t)place;
    double borne = of->bearing[k] + (place - (double)k) * (of->bearing[k + 1] - of->bearing[k]);
    out[0] = log(area);
    out[1] = between(at, elastic->ln_load, 1, values + 1, 3, elastic->count);
    out[1] -= log1p(ratio / area * exp(3 * (out[1] - borne))) / 3;
    out[2] = between(out[0], values, 3, values + 2, 3, elastic->count);
    return area <= exp(elastic->value[elastic->count - 1][0]);
}

/** Adds `weight` times the ln ratios of a square's solutions with the hardness to their closed form; NaN: none. */
static void add_capped(struct transfer_curve *out, const struct transfer_square *square, const struct yielding *of,
                       double weight)
{
    for (size_t k = 0; k < out->count; k++) {
        double own[3], base[3] = {NAN, NAN, NAN};
        bool there = hardened(base, of, square->point[1][k].load);
        put_ln(own, &square->point[1][k]);
        out->ln_load[k] = log(square->point[1][k].load);
        for (int q = 0; q < 3; q++)
            out->value[k][q] += there ? weight * (own[q] - base[q]) : NAN;
    }
}

/** Removes loads with NaN. */
static void keep_finite(struct transfer_curve *ratios)
{
    size_t kept = 0;
    for (size_t k = 0; k < ratios->count; k++)
        if (isfinite(ratios->value[k][0] + ratios->value[k][1] + ratios->value[k][2])) {
            ratios->ln_load[kept] = ratios->ln_load[k];
            memmove(ratios->value[kept++], ratios->value[k], sizeof *ratios->value);
        }
    ratios->count = kept;
}

/** The curve with the hardness: the closed form times the ratios. */
static void make_capped(struct transfer_curve *out, const struct yielding *of, const struct transfer_curve *ratios)
{
    const struct transfer_curve *elastic = of->elastic;
    double value[3];
    for (size_t k = 0; k < elastic->count && ratios->count > 0; k++) {
        double at = elastic->ln_load[k], load = exp(at);
        if (load >= of->hardness || !hardened(value, of, load))
            break;
        for (size_t q = 0; q < 3; q++)
            value[q] += between(at, ratios->ln_load, 1, &ratios->value[0][q], 3, ratios->count);
        const struct transfer_point point = {load, fmax(exp(value[0]), load / of->hardness), exp(value[1]),
                                             exp(value[2])};
        if (!add_point(out, &point))
            break;
    }
    make_monotone(out);
}

enum status_code transfer_make(struct transfer *out, const struct transfer_squares *squares, double hardness,
                               struct status *status)
{
    const size_t count = squares->count;
    OWNED(memory_free) struct strip *strip = calloc(count + 1, sizeof *strip);
    struct strip *joined = strip ? strip + count : NULL;
    struct persson own = {0}, whole = {0};
    double bearing[TRANSFER_BEARING] = {0};
    struct transfer_curve capped = {.count = squares->loads[1]};
    enum status_code rc = strip ? persson_make(&whole, &out->spectrum, 0, status) : status_memory(status);
    for (size_t s = 0; s < count && rc == STATUS_OK; s++) {
        const struct transfer_square *square = &squares->square[s];
        if ((rc = persson_make(&own, &square->spectrum, 0, status)) != STATUS_OK)
            break;
        make_strip(&strip[s], square->point[0], squares->loads[0], &own);
        persson_free(&own);
        if (strip[s].own.count == 0)
            rc = status_fail(status, STATUS_MODEL, "no load of its ladder resolves the contact of the map");
        else if (capped.count > 0 && /* curve[0] is the square's for now */
                 (rc = make_elastic(&out->curve[0], &square->spectrum, &strip[s], status)) == STATUS_OK)
            add_capped(&capped, square, &(struct yielding){&out->curve[0], square->bearing, hardness},
                       1 / (double)count);
        for (size_t k = 0; k < TRANSFER_BEARING; k++)
            bearing[k] += square->bearing[k] / (double)count;
    }
    if (rc == STATUS_OK) {
        keep_finite(&capped);
        join(joined, strip, count, &whole);
        rc = make_elastic(&out->curve[0], &out->spectrum, joined, status);
    }
    if (rc == STATUS_OK)
        make_capped(&out->curve[1], &(struct yielding){&out->curve[0], bearing, hardness}, &capped);
    persson_free(&whole);
    return rc;
}

void transfer_free(struct transfer *transfer)
{
    spectrum_free(&transfer->spectrum);
    *transfer = (struct transfer){.spectrum = {0}};
}

bool transfer_at(struct transfer_point *out, const struct transfer *transfer, bool plastic, double load)
{
    const struct transfer_curve *curve = &transfer->curve[plastic];
    double at = log(load), value[3];
    if (curve->count < 2 || at > curve->ln_load[curve->count - 1])
        return false;
    size_t k = (size_t)fmax(0, floor((at - curve->ln_load[0]) / grid_step));
    k = k < curve->count - 2 ? k : curve->count - 2;
    for (int q = 0; q < 3; q++) /* below the first, on the first line */
        value[q] = curve->value[k][q] + (curve->value[k + 1][q] - curve->value[k][q]) * (at - curve->ln_load[k]) /
                                            (curve->ln_load[k + 1] - curve->ln_load[k]);
    *out = (struct transfer_point){load, exp(value[0]), exp(value[1]), exp(value[2])};
    return true;
}

double transfer_error(const struct transfer *transfer, bool plastic, int which, double load)
{
    const struct transfer_errors *error = &transfer->error[plastic];
    double place[TRANSFER_ERRORS], value[TRANSFER_ERRORS];
    size_t count = 0;
    for (size_t k = 0; k < error->count; k++)
        if (!isnan(error->value[k][which])) {
            place[count] = error->ln_load[k];
            value[count++] = error->value[k][which];
        }
    return count > 0 ? between(log(load), place, 1, value, 1, count) : NAN;
}
