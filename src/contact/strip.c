/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/strip.h"

#include "base/fft.h"
#include "base/isotonic.h"
#include "contact/corrected_persson.h"
#include "direct/direct_constriction.h"
#include "direct/direct_quantities.h"
#include "direct/direct_surface.h"
#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/** p over the strip's rms slope, and the tolerance of the solution: tighter where little area or gap is left. On 66
 * sets of profiles the answers differ by less than .026, .019 and .036 (rms ln of area, gap, resistance) from those of
 * exact solutions; other surrogates change load, length and gap by .08, .13 and .13. */
static const struct {
    double load, tolerance;
} ladder[STRIP_LOADS] = {
    {1e-4, 3e-4},    {3e-4, 6e-4}, {1e-3, 1.4e-3}, {3e-3, 3e-3}, {0.006, 6e-3}, {0.012, 8e-3},
    {0.025, 1.4e-2}, {0.05, 3e-2}, {0.1, 4e-2},    {0.17, 4e-2}, {0.26, 4e-2},  {0.38, 4e-2},
    {0.55, 1.5e-2},  {0.8, 7e-3},  {1.1, 3e-3},    {1.6, 3e-3},  {2.3, 3e-3},
};

/* STRIP_ROUGHLY: every third load, at twice the tolerance; on 100 surfaces of one scan the intervals are within 4 %
 * (rms) of those from every second load at the tolerance itself, and .8 % wider in the mean. */
enum { ROUGH_STEP = 3, ROUGH_TOLERANCE = 2 };

static const double least_share = 0.3; /* of the area in contact, left by the correction for its outline */

double strip_smoothing(size_t scans)
{
    return (const double[]){0, 1, 0.8, 0.6}[scans < 3 ? scans : 3];
}

size_t strip_least_points(const struct strip_rows *rows)
{
    return rows->scans >= 3 && rows->rows >= 3 ? 8 : 12;
}

size_t strip_surrogates(const struct strip_rows *rows)
{
    return rows->rows * rows->points >= STRIP_LONG ? 1 : STRIP_SURROGATES;
}

static size_t row_length(const struct strip_rows *rows)
{
    return rows->periodic ? rows->points : 2 * rows->points;
}

double *strip_join(size_t *points, const struct strip_rows *rows)
{
    const size_t length = row_length(rows), n = rows->points;
    *points = rows->rows * length;
    double *strip_m = malloc((*points + 1) * sizeof *strip_m);
    for (size_t k = 0; k < *points && strip_m; k++) {
        size_t i = k % length;
        strip_m[k] = rows->height_m[k / length * n + (i < n ? i : length - 1 - i)];
    }
    return strip_m;
}

/** Mean spectrum of the rows, and mean and deviation of their mean heights. */
struct phases {
    struct fft_room room; /* of one row */
    double *amplitude;    /* sqrt of the mean power of harmonic k, over the points */
    double mean_m, deviation_m;
};

static enum status_code phases_of(struct phases *out, const double *strip_m, size_t length, size_t count,
                                  struct status *status)
{
    double n = (double)length, square = 0;
    *out = (struct phases){.amplitude = calloc(length / 2 + 1, sizeof(double))};
    if (!out->amplitude || !fft_room_make(&out->room, length))
        return status_memory(status);
    for (size_t r = 0; r < count; r++) {
        memcpy(out->room.record, strip_m + r * length, length * sizeof(double));
        if (!fft_forward(out->room.transform, out->room.record, length))
            return status_memory(status);
        for (size_t k = 0; k <= length / 2; k++)
            out->amplitude[k] +=
                (pow(out->room.transform[k][0] / n, 2) + pow(out->room.transform[k][1] / n, 2)) / (double)count;
        out->mean_m += out->room.transform[0][0] / n / (double)count;
    }
    square = out->amplitude[0] - out->mean_m * out->mean_m; /* of the means */
    out->deviation_m = count > 1 ? sqrt(fmax(square, 0) * (double)count / (double)(count - 1)) : 0;
    for (size_t k = 0; k <= length / 2; k++)
        out->amplitude[k] = sqrt(out->amplitude[k]);
    return STATUS_OK;
}

/** Draws a Gaussian row. */
static void draw_row(double *out, struct phases *phases, size_t length, uint64_t seed, uint64_t first,
                     struct status *status)
{
    double normal = gsl_cdf_ugaussian_Pinv(direct_random(seed, first) + ldexp(1, -54));
    phases->room.transform[0][0] = phases->mean_m + phases->deviation_m * normal;
    phases->room.transform[0][1] = 0;
    for (size_t k = 1; k <= length / 2; k++) {
        double angle = 2 * M_PI * direct_random(seed, first + k);
        bool nyquist = 2 * k == length; /* real, and its mean square that of its amplitude */
        phases->room.transform[k][0] = phases->amplitude[k] * (nyquist ? copysign(1, cos(angle)) : cos(angle));
        phases->room.transform[k][1] = nyquist ? 0 : phases->amplitude[k] * sin(angle);
    }
    if (!fft_backward(phases->room.record, phases->room.transform, length))
        (void)status_memory(status);
    memcpy(out, phases->room.record, length * sizeof *out);
}

/** Mean-square slope of the rows, each periodic: the steps between rows, which are large where rows are pieces of a
 * longer scan, are left out. */
static double mean_square_slope(const double *strip_m, size_t points, size_t length, double spacing_m)
{
    double sum = 0;
    for (size_t i = 0; i < points; i++) {
        const double *row_m = strip_m + i / length * length;
        double slope = (row_m[(i + 1) % length] - row_m[(i + length - 1) % length]) / (2 * spacing_m);
        sum += slope * slope;
    }
    return sum / (double)points;
}

/** Mean gap of the points out of contact; at the others it is solver tolerance. */
static double open_gap(const struct direct_contact *contact)
{
    double sum = 0;
    for (size_t k = 0; k < contact->kernel.nx; k++)
        if (!(contact->pressure[k] > 0))
            sum += fmax(contact->gap_m[k], 0);
    return sum / (double)contact->kernel.points;
}

/** Points that overlap without pressure, because of the tolerance. Counting half of them as in contact brings the
 * ratios to surrogates closer to exact ones: ln p within .031 instead of .039, at half of these tolerances. */
static size_t overlapping(const struct direct_contact *contact)
{
    size_t count = 0;
    for (size_t k = 0; k < contact->kernel.nx; k++)
        count += !(contact->pressure[k] > 0) && contact->gap_m[k] < 0;
    return count;
}

/** A strip and its surrogates, on several threads. */
struct solver {
    struct strip *out;
    const struct strip_rows *rows;
    struct phases phases;
    double *strip_m; /* heights of the strip and of every surrogate, each of so many points */
    size_t points, surrogates;
    bool rough; /* STRIP_ROUGHLY */
    const atomic_bool *stop;
};

/** Puts a solution into the curve, from its end on. Full contact, or an area not below the last, is left out. */
static enum status_code add_solution(struct strip_curve *curve, struct direct_contact *contact,
                                     const struct direct_contact_load *load, const struct direct_quantities *found,
                                     struct status *status)
{
    size_t at = STRIP_LOADS - 1 - curve->count, points = contact->kernel.points;
    double length_m, gap_m = open_gap(contact), area = direct_area_corrected(found, points, direct_kappa);
    area = fmax(area, least_share * (double)found->contact_points / (double)points);
    if (found->contact_points == points)
        return STATUS_OK;
    if (direct_constriction_of_contact(&length_m, contact, 2 * load->tolerance, load->stop, status) != STATUS_OK)
        return status->code;
    if (!(length_m > 0 && gap_m > 0) || (curve->count > 0 && !(logit(area) < curve->logit[at + 1])))
        return STATUS_OK;
    curve->logit[at] = logit(area);
    curve->value[at][0] = log(load->mean_pressure);
    curve->value[at][1] = log(length_m);
    curve->value[at][2] = log(gap_m);
    curve->count++;
    return STATUS_OK;
}

/** Solves the strip or a surrogate at falling loads, until too few points touch. */
static enum status_code solve_strip(struct strip_curve *curve, size_t *convolutions, const struct solver *solver,
                                    size_t index, struct status *status)
{
    OWNED(direct_contact_free) struct direct_contact made = {.set = NULL};
    struct direct_contact *contact = &made;
    const size_t points = solver->points, least_points = strip_least_points(solver->rows);
    const double spacing_m = solver->rows->spacing_m, *strip_m = solver->strip_m + index * points;
    double slope = sqrt(mean_square_slope(strip_m, points, row_length(solver->rows), spacing_m));
    const struct direct_grid grid = {points, 1, spacing_m, false, true};
    if (direct_contact_make(contact, strip_m, &grid, status) != STATUS_OK)
        return status->code;
    const size_t step = solver->rough ? ROUGH_STEP : 1;
    bool enough = true;
    for (size_t i = STRIP_LOADS + step - 1; i >= step && enough && status->code == STATUS_OK;) {
        i -= step;
        double tolerance = ladder[i].tolerance * (solver->rough ? ROUGH_TOLERANCE : 1);
        struct direct_contact_load load = {ladder[i].load * slope, INFINITY, tolerance, true, solver->stop};
        struct status problem = {0};
        if (direct_contact_solve(contact, &load, &problem) == STATUS_OK) {
            struct direct_quantities found = direct_quantities_of(contact, &load);
            found.contact_points += overlapping(contact) / 2;
            enough = found.contact_points >= least_points;
            if (enough)
                (void)add_solution(curve, contact, &load, &found, &problem);
        }
        *convolutions += contact->convolutions;
        if (problem.code == STATUS_MODEL)
            curve->unsolved++; /* the next one starts anew */
        else if (problem.code != STATUS_OK)
            (void)status_fail(status, problem.code, "%s", problem.message);
    }
    if (status->code != STATUS_OK)
        return status->code;
    if (curve->count == 0)
        return status_fail(status, STATUS_MODEL,
                           "no load of the strip has %zu points in contact; take longer or denser scans", least_points);
    size_t first = STRIP_LOADS - curve->count;
    memmove(curve->logit, curve->logit + first, curve->count * sizeof *curve->logit);
    memmove(curve->value, curve->value + first, curve->count * sizeof *curve->value);
    for (size_t q = 1; q < 3; q++) /* length and gap fall with area, except for the outline correction */
        isotonic(&curve->value[0][q], curve->count, 3, true);
    return STATUS_OK;
}

/** Heights of the surrogates, one after another. */
static void draw_surrogates(double *strip_m, size_t points, struct solver *solver, struct status *status)
{
    const struct strip_rows *rows = solver->rows;
    size_t length = row_length(rows);
    for (size_t s = 0; s < solver->surrogates; s++) {
        double *own_m = strip_m + s * points;
        for (size_t r = 0; r < rows->rows && s % 2 == 0; r++)
            draw_row(own_m + r * length, &solver->phases, length, rows->seed ? rows->seed[r] + s / 2 : s / 2 + 1,
                     rows->seed ? 0 : r << 32, status);
        for (size_t k = 0; k < points && s % 2 == 1; k++) /* upside down: as likely, with the opposite error */
            own_m[k] = 2 * solver->phases.mean_m - strip_m[(s - 1) * points + k];
    }
}

/** The strip, and then every surrogate. */
static enum status_code solve_task(void *context, size_t index, struct threads_turn *turn, struct status *status)
{
    struct solver *solver = context;
    struct strip *out = solver->out;
    struct strip_curve curve = {0};
    struct status problem = {0};
    size_t convolutions = 0;
    (void)solve_strip(&curve, &convolutions, solver, index, &problem);
    if (!threads_wait(turn))
        return STATUS_OK;
    *(index == 0 ? &out->own : &out->surrogate[out->surrogates]) = curve;
    out->unsolved += curve.unsolved;
    out->transforms += convolutions * solver->points;
    out->surrogates += index > 0 && problem.code == STATUS_OK;
    if (problem.code == STATUS_OK ||
        (index > 0 && problem.code == STATUS_MODEL && index - out->surrogates < solver->surrogates))
        return STATUS_OK;
    return status_fail(status, problem.code, "%s", problem.message);
}

enum status_code strip_solve(struct strip *out, const struct strip_rows *rows, size_t surrogates,
                             const struct threads *threads, struct status *status)
{
    const bool rough = surrogates == STRIP_ROUGHLY;
    struct solver solver = {
        .out = out, .rows = rows, .surrogates = rough ? 1 : surrogates, .rough = rough, .stop = threads->stop};
    *out = (struct strip){.smoothing = strip_smoothing(rows->scans)};
    double *own_m = strip_join(&solver.points, rows);
    double *strip_m = own_m ? reallocarray(own_m, 1 + solver.surrogates, (solver.points + 1) * sizeof *own_m) : NULL;
    solver.strip_m = strip_m ? strip_m : own_m;
    if (!strip_m)
        (void)status_memory(status);
    else if (phases_of(&solver.phases, strip_m, row_length(rows), rows->rows, status) == STATUS_OK)
        draw_surrogates(strip_m + solver.points, solver.points, &solver, status);
    if (status->code == STATUS_OK)
        (void)!threads_run(threads, 1 + solver.surrogates, solve_task, &solver, status);
    free(solver.phases.amplitude);
    fft_room_free(&solver.phases.room);
    free(solver.strip_m);
    return status->code;
}

uint64_t strip_cost(const struct strip_rows *rows)
{
    double points = (double)(rows->rows * row_length(rows)), length = (double)row_length(rows);
    double pairs = 1.7 * pow(length, 0.25) * pow((double)rows->rows, 0.43); /* a load, as measured */
    return (uint64_t)(pairs * points * (double)(STRIP_LOADS * (1 + strip_surrogates(rows))));
}

/** Linear between neighbours and above the last; below the first p ~ A, l ~ 1/A, the gap is constant. */
static void add_values(double sum[3], const struct strip_curve *curve, double at, double weight)
{
    static const double slope_below[3] = {1, -1, 0};
    size_t k = 0;
    while (k + 2 < curve->count && at > curve->logit[k + 1])
        k++;
    for (size_t q = 0; q < 3; q++) {
        double slope = slope_below[q];
        if (at > curve->logit[0] && curve->count > 1)
            slope = (curve->value[k + 1][q] - curve->value[k][q]) / (curve->logit[k + 1] - curve->logit[k]);
        sum[q] += weight * (curve->value[k][q] + slope * (at - curve->logit[k]));
    }
}

/** ln of the ratios at a logit A: those of struct strip_curve. */
static void add_ratio(double sum[3], const struct strip *strip, double at)
{
    add_values(sum, &strip->own, at, 1);
    for (size_t s = 0; s < strip->surrogates; s++)
        add_values(sum, &strip->surrogate[s], at, -1 / (double)strip->surrogates);
}

struct strip_ratio strip_ratio_at(const struct strip *strip, double area_ratio)
{
    double sum[3] = {0};
    add_ratio(sum, strip, logit(area_ratio));
    return (struct strip_ratio){sum[0], sum[1], sum[2]};
}

static const double grid_step = 0.075; /* in logit A */

/** logit A below all solutions and at the largest area; returns the steps of a grid between them, which does not depend
 * on the loads asked. */
static size_t range_of(double range[2], const struct strip *strip)
{
    range[0] = strip->own.logit[0];
    range[1] = logit(CORRECTED_PERSSON_LARGEST_AREA);
    for (size_t s = 0; s < strip->surrogates; s++)
        range[0] = fmin(range[0], strip->surrogate[s].logit[0]);
    range[0] = fmin(range[0], range[1] - grid_step);
    return (size_t)ceil((range[1] - range[0]) / grid_step);
}

static double area_of(const double range[2], double share)
{
    return logistic(range[0] + (range[1] - range[0]) * share);
}

/** ln of the ratios at the nodes of the grid, smoothed by local least-squares lines with Gaussian weights as wide as
 * the strip's smoothing (Cleveland, J. Am. Stat. Assoc. 74 (1979) 829); malloc'ed; NULL: out of memory. */
static double (*smooth_ratios(const double range[2], size_t steps, const struct strip *strip))[3]
{
    enum { REACH = 42, EVERY = 3 }; /* steps: three widths, of which every third node is enough */
    const double step = (range[1] - range[0]) / (double)steps, width = strip->smoothing / step;
    const size_t reach = (size_t)fmin(3 * width, REACH) / EVERY * EVERY;
    double(*out)[3] = malloc(2 * (steps + 1) * sizeof *out), (*raw)[3] = out + steps + 1, weight[REACH + 1];
    for (size_t k = 0; k <= reach; k++)
        weight[k] = width > 0 ? exp(-pow((double)k / width, 2) / 2) : 1;
    for (size_t k = 0; k <= steps && out; k++) {
        memset(out[k], 0, sizeof *out);
        add_ratio(out[k], strip, range[0] + (double)k * step);
        memcpy(raw[k], out[k], sizeof *out);
    }
    for (size_t k = 0; k <= steps && out && width > 0; k++) {
        double w0 = 0, w1 = 0, w2 = 0, sum[2][3] = {{0}}; /* moments of the weights, and of the ratios */
        for (size_t i = k > reach ? k - reach : k % EVERY; i <= steps && i <= k + reach; i += EVERY) {
            const double x = (double)i - (double)k, w = weight[i > k ? i - k : k - i];
            w0 += w;
            w1 += w * x;
            w2 += w * x * x;
            for (int n = 0; n < 3; n++) {
                sum[0][n] += w * raw[i][n];
                sum[1][n] += w * x * raw[i][n];
            }
        }
        for (int n = 0; n < 3; n++)
            out[k][n] = (w2 * sum[0][n] - w1 * sum[1][n]) / (w0 * w2 - w1 * w1);
    }
    return out;
}

/* Smoothed lengths and gaps fall with ln A at least by this share of the theory's fall. */
static const double least_fall = 0.2;

/** Loads, lengths and gaps at the nodes; of lengths and gaps the theory, `point`, has `falls` of the fall. */
static void fill_nodes(struct strip_nodes *nodes, const struct corrected_persson_point *point, const double (*ratio)[3])
{
    const double falls = nodes->falls;
    for (size_t k = 0; k <= nodes->steps; k++) {
        double *value = nodes->value[k];
        const double area = point[k].area_ratio, load = corrected_persson_load(area, nodes->persson.m2);
        nodes->ln_load[k] = log(load) + ratio[k][0];
        nodes->ln_load[k] = k > 0 ? fmax(nodes->ln_load[k], nodes->ln_load[k - 1]) : nodes->ln_load[k];
        value[0] = (1 - falls) * log(point[k].constriction_m) + ratio[k][1];
        value[1] = (1 - falls) * log(point[k].separation_m) + ratio[k][2];
        value[2] = area / (load * exp(ratio[k][0]));
        value[2] = k > 0 ? fmin(nodes->value[k - 1][2], value[2]) : value[2];
    }
    for (size_t q = 0; q < 1 + (size_t)nodes->with_separation; q++) {
        double raw = nodes->value[0][q];
        isotonic(&nodes->value[0][q], nodes->steps + 1, 3, true);
        nodes->raised[q] = nodes->value[0][q] - raw;
        for (size_t k = 0; k <= nodes->steps; k++)
            nodes->value[k][q] += falls * log(q == 0 ? point[k].constriction_m : point[k].separation_m);
    }
    memcpy(nodes->lowest, ratio[0], sizeof nodes->lowest);
    nodes->first = point[0];
}

enum status_code strip_nodes_make(struct strip_nodes *out, const struct strip *strip, const struct persson *persson,
                                  bool with_separation, struct status *status)
{
    double range[2];
    size_t steps = range_of(range, strip);
    *out = (struct strip_nodes){.persson = *persson,
                                .with_separation = with_separation,
                                .falls = strip->smoothing > 0 ? least_fall : 0,
                                .range = {range[0], range[1]},
                                .steps = steps,
                                .ln_load = malloc((steps + 1) * sizeof *out->ln_load),
                                .value = malloc((steps + 1) * sizeof *out->value)};
    OWNED(memory_free) struct corrected_persson_point *point = malloc((steps + 1) * sizeof *point);
    double(*ratio)[3] = smooth_ratios(range, steps, strip);
    if (out->ln_load && out->value && point && ratio) {
        for (size_t k = 0; k <= steps; k++)
            point[k].area_ratio = area_of(range, (double)k / (double)steps);
        corrected_persson_curve(point, steps + 1, &out->persson, with_separation);
        fill_nodes(out, point, ratio);
    } else {
        strip_nodes_free(out);
        (void)status_memory(status);
    }
    free(ratio);
    return status->code;
}

void strip_nodes_free(struct strip_nodes *nodes)
{
    persson_free(&nodes->persson);
    free(nodes->ln_load);
    free(nodes->value);
    *nodes = (struct strip_nodes){.steps = 0};
}

double strip_area(double load, const struct strip_nodes *nodes)
{
    const double *ln_load = nodes->ln_load, wanted = log(load);
    size_t low = 0, high = nodes->steps;
    if (wanted <= ln_load[0])
        return corrected_persson_area(load / exp(nodes->lowest[0]), nodes->persson.m2);
    if (!(wanted <= ln_load[high]))
        return NAN;
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        if (ln_load[middle] < wanted)
            low = middle;
        else
            high = middle;
    }
    double share = (wanted - ln_load[low]) / (ln_load[high] - ln_load[low]);
    return area_of(nodes->range, ((double)low + share) / (double)nodes->steps);
}

/** The theory's contact below the nodes, where the ratios are constant. */
static void below_nodes(struct corrected_persson_point *contact, const struct strip_nodes *nodes)
{
    const double of[2] = {contact->constriction_m, contact->separation_m}, falls = nodes->falls;
    double value[2];
    for (size_t q = 0; q < 2; q++)
        value[q] = (1 - falls) * log(of[q]) + nodes->lowest[1 + q] + nodes->raised[q] + falls * log(of[q]);
    contact->constriction_m = exp(value[0]);
    contact->separation_m = exp(value[1]);
    contact->least_area_per_load = fmin(
        contact->area_ratio / (corrected_persson_load(contact->area_ratio, nodes->persson.m2) * exp(nodes->lowest[0])),
        contact->least_area_per_load);
}

/** A contact among the nodes. */
static void among_nodes(struct corrected_persson_point *contact, const struct strip_nodes *nodes)
{
    double place =
        (logit(contact->area_ratio) - nodes->range[0]) / (nodes->range[1] - nodes->range[0]) * (double)nodes->steps;
    size_t k = (size_t)fmin(fmax(place, 0), (double)nodes->steps - 1);
    const double *here = nodes->value[k], *next = nodes->value[k + 1], share = place - (double)k;
    contact->constriction_m = exp(here[0] + share * (next[0] - here[0]));
    contact->separation_m = exp(here[1] + share * (next[1] - here[1]));
    contact->least_area_per_load = fmin(here[2], contact->least_area_per_load);
}

void strip_contact(struct corrected_persson_point *contact, size_t count, const struct strip_nodes *nodes)
{
    size_t below = 0;
    while (below < count && contact[below].area_ratio < nodes->first.area_ratio)
        below++;
    corrected_persson_below(contact, below, &nodes->persson, &nodes->first);
    for (size_t i = 0; i < below; i++)
        below_nodes(&contact[i], nodes);
    for (size_t i = below; i < count; i++)
        among_nodes(&contact[i], nodes);
}
