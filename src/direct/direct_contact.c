/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_contact.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    PATIENCE = 200, /* iterations in which the violation has to halve */
    FREE = 1,       /* a point of the set with 0 < p < H */
    VIOLATOR = 2,   /* any other point of the set */
    BLOCK = 8,      /* points that are skipped together where none is in the set */
    COARSEST = 64   /* points a side of the coarsest grid */
};

/** Violation at which an elastic solution is good enough as a start for one with a hardness or on a finer grid. */
static const double START = 1e-2;

/** How many times as large the violation may be after a step in which points joined the set. */
static const double THROWN = 8;

/** A solution while it is iterated. */
struct solver {
    struct direct_contact *contact;
    const struct direct_contact_load *load;
    double hardness;
    bool preconditioned;
    bool joined;    /* a point has joined the set, so that earlier directions are no longer conjugate */
    bool violators; /* the set has points that violate a condition */
    bool careful;   /* only those of them join that the step presses: drop_pulled() */
    double last;    /* <g, z> of the last iteration */
    double mean;    /* of the gap on the set */
};

/** Subtracts the mean of the heights, as an offset costs digits. */
static enum status_code centre_heights(struct direct_contact *contact, struct status *status)
{
    const struct direct_kernel *kernel = &contact->kernel;
    double mean = 0, square = 0, highest = 0, points = (double)kernel->points;
    for (size_t j = 0; j < kernel->ny; j++)
        for (size_t i = 0; i < kernel->nx; i++) {
            double height = contact->height_m[j * kernel->stride + i];
            mean += height / points;
            highest = fmax(highest, fabs(height));
            if (!isfinite(height))
                (void)status_fail(status, STATUS_MODEL, "height %zu of the surface is missing or not finite; fill it",
                                  j * kernel->nx + i);
        }
    if (status->code != STATUS_OK)
        return status->code;
    for (size_t j = 0; j < kernel->ny; j++)
        for (size_t k = j * kernel->stride; k < j * kernel->stride + kernel->nx; k++) {
            contact->height_m[k] -= mean;
            square += contact->height_m[k] * contact->height_m[k];
        }
    contact->rms_m = sqrt(square / points);
    if (!(contact->rms_m > 1e-14 * highest) || !isfinite(contact->rms_m))
        return status_fail(status, STATUS_MODEL, "the surface is flat: it has no roughness to solve the contact of");
    return STATUS_OK;
}

/** A grid of every second point, if enough are left and they are not flat. */
static enum status_code make_coarse(struct direct_contact *out, const double *height_m, struct status *status)
{
    const struct direct_kernel *kernel = &out->kernel;
    size_t nx = kernel->nx / 2, ny = kernel->ny / 2;
    struct status problem = {0};
    if (nx < COARSEST || ny < COARSEST || kernel->nx % 2 || kernel->ny % 2)
        return STATUS_OK;
    OWNED(memory_free) double *coarse_m = malloc(nx * ny * sizeof *coarse_m);
    out->coarse = calloc(1, sizeof *out->coarse);
    if (!out->coarse || !coarse_m)
        (void)status_memory(status);
    for (size_t j = 0; coarse_m && j < ny; j++)
        for (size_t i = 0; i < nx; i++)
            coarse_m[j * nx + i] = height_m[2 * (j * kernel->nx + i)];
    if (status->code == STATUS_OK &&
        direct_contact_make(out->coarse, coarse_m,
                            &(struct direct_grid){nx, ny, 2 * kernel->spacing_m, kernel->mirrored, kernel->single},
                            &problem) != STATUS_OK) {
        free(out->coarse);
        out->coarse = NULL;
        if (problem.code != STATUS_MODEL)
            *status = problem;
    }
    return status->code;
}

enum status_code direct_contact_make(struct direct_contact *out, const double *height_m, const struct direct_grid *grid,
                                     struct status *status)
{
    const size_t ny = grid->ny;
    *out = (struct direct_contact){0};
    if (direct_kernel_make(&out->kernel, grid, status) != STATUS_OK)
        return status->code;
    size_t places = ny * out->kernel.stride;
    out->height_m = calloc(places, sizeof(double));
    out->pressure = calloc(places, sizeof(double));
    out->gap_m = calloc(places, sizeof(double));
    out->direction = calloc(places, sizeof(double));
    out->response = ny == 1 ? calloc(places, sizeof(double)) : NULL;
    out->set = malloc(places * sizeof(uint32_t));
    out->member = calloc(places, 1);
    out->taken = calloc(out->kernel.nx, 1);
    out->rows = calloc(ny, 1);
    if (!out->height_m || !out->pressure || !out->gap_m || !out->direction || !out->set || !out->member ||
        !out->taken || !out->rows || (ny == 1 && !out->response))
        (void)status_memory(status);
    for (size_t j = 0; j < ny && status->code == STATUS_OK; j++)
        memcpy(out->height_m + j * out->kernel.stride, height_m + j * grid->nx, grid->nx * sizeof *height_m);
    if (status->code == STATUS_OK && centre_heights(out, status) == STATUS_OK)
        (void)make_coarse(out, height_m, status);
    if (status->code != STATUS_OK)
        direct_contact_free(out);
    return status->code;
}

void direct_contact_free(struct direct_contact *contact)
{
    if (contact->coarse)
        direct_contact_free(contact->coarse);
    free(contact->coarse);
    direct_kernel_free(&contact->kernel);
    free(contact->height_m);
    free(contact->pressure);
    free(contact->gap_m);
    free(contact->direction);
    free(contact->response);
    free(contact->set);
    free(contact->member);
    free(contact->taken);
    free(contact->rows);
    *contact = (struct direct_contact){0};
}

/* Sums over the set run in four parts: faster than one after the other, and the same everywhere. Loops over points
 * compare: fmax() and fmin() are calls. */

static double sum(const double part[4])
{
    return (part[0] + part[1]) + (part[2] + part[3]);
}

/** Puts K p into the field of the kernel: the gap is 2 K p - h - lambda. */
static void displace(struct solver *solver)
{
    struct direct_kernel *kernel = &solver->contact->kernel;
    direct_kernel_convolve_of(kernel, solver->contact->pressure, DIRECT_COMPLIANCE);
}

void direct_contact_select(struct direct_contact *contact, bool all)
{
    const struct direct_kernel *kernel = &contact->kernel;
    const double *pressure = contact->pressure;
    uint32_t *set = contact->set;
    size_t count = 0;
    for (size_t j = 0; j < kernel->ny; j++) {
        size_t before = count;
        for (size_t k = j * kernel->stride; k < j * kernel->stride + kernel->nx; k++) {
            set[count] = (uint32_t)k;
            count += all || pressure[k] != 0;
        }
        contact->rows[j] = count > before;
    }
    contact->set_count = count;
}

/* Four pressures, and four answers of 0 or -1. */
typedef double lanes __attribute__((vector_size(32), aligned(sizeof(double)), may_alias));
typedef int64_t marks __attribute__((vector_size(32)));

/** Sum of `count` pressures plus the shift, each clipped to 0 ... H; `free`: how many are not clipped. Without
 * branches: pressures change sides at random places. */
CLONES static double clipped_sum(double *free, const double *pressure, size_t count, double shift, double hardness)
{
    lanes part = {0}, last = {-INFINITY, -INFINITY, -INFINITY, -INFINITY};
    marks inside = {0};
    if (count % 4 > 0)
        memcpy(&last, pressure + count / 4 * 4, count % 4 * sizeof *pressure);
    for (size_t k = 0; k < count; k += 4) {
        const lanes p = (k + 4 <= count ? *(const lanes *)(pressure + k) : last) + shift;
        const lanes pressed = (lanes)((p > 0) & (marks)p);
        const marks below = pressed < hardness;
        const lanes clipped = (lanes)((below & (marks)pressed) | (~below & (marks)((lanes){0} + hardness)));
        part += clipped;
        inside -= clipped == p;
    }
    *free = (double)(inside[0] + inside[1] + inside[2] + inside[3]);
    return (part[0] + part[1]) + (part[2] + part[3]);
}

/** Shifts the pressure where it is not 0, clipped to 0 ... H, so that its mean is p̄ (Newton's method within a bracket).
 * All points are shifted if fewer than p̄/H of them are loaded. `set` is used for the points. */
static void fit_mean(struct solver *solver)
{
    struct direct_contact *contact = solver->contact;
    struct direct_kernel *kernel = &contact->kernel;
    double wanted = solver->load->mean_pressure * (double)kernel->points, count, bounds[2] = {0};
    double *pressure = contact->pressure, hardness = fmin(solver->hardness, 2 * wanted + 1); /* elastic: no bound */
    bool all = false;
    do {
        direct_contact_select(contact, all);
        all = !all;
        count = (double)contact->set_count;
    } while (count * hardness <= wanted && all);
    double *at = kernel->field; /* the pressures to shift, one after another */
    for (size_t k = 0; k < contact->set_count; k++) {
        double p = at[k] = pressure[contact->set[k]];
        bounds[0] = p > bounds[0] ? p : bounds[0];
        bounds[1] = -p > bounds[1] ? -p : bounds[1];
    }
    double low = -bounds[0], high = hardness + bounds[1], shift = 0;
    for (int step = 0; step < 100; step++) {
        double free = 0, sum = clipped_sum(&free, at, contact->set_count, shift, hardness);
        if (sum < wanted)
            low = shift;
        else
            high = shift;
        double change = free > 0 ? (wanted - sum) / free : INFINITY; /* else halve the bracket */
        if (fabs(sum - wanted) <= 5e-13 * wanted || high - low <= 1e-15 * hardness)
            break;
        shift = shift + change > low && shift + change < high ? shift + change : (low + high) / 2;
    }
    for (size_t k = 0; k < contact->set_count; k++) {
        double p = at[k] + shift;
        p = p < hardness ? p : hardness;
        pressure[contact->set[k]] = p > 0 ? p : 0;
    }
}

/** Of a strip's set: where a step would leave tension at the edge of a patch, the points behind the edge give up as
 * much, as far as they press. Steps act mainly at the edges of patches (direct_contact_stiffen() moves there what lies
 * between patches), so that a patch that opens would otherwise lose only two points an iteration. */
static void give_inwards(struct direct_contact *contact)
{
    const uint32_t *set = contact->set;
    double *pressure = contact->pressure;
    for (size_t k = 0, first = 0; k < contact->set_count; k++) {
        bool last = k + 1 == contact->set_count || set[k + 1] != set[k] + 1; /* of its patch */
        for (size_t i = k; last && i > first && pressure[set[i]] < 0; i--) {
            pressure[set[i - 1]] += pressure[set[i]];
            pressure[set[i]] = 0;
        }
        if (!last && pressure[set[k]] < 0) {
            pressure[set[k + 1]] += pressure[set[k]];
            pressure[set[k]] = 0;
        }
        first = last ? k + 1 : first;
    }
}

/** Elastic contact, on the set: pressures minus tau times the direction, 0 instead of tension, scaled to the mean. */
static void move(struct solver *solver, double tau)
{
    struct direct_contact *contact = solver->contact;
    const uint32_t *set = contact->set;
    const size_t count = contact->set_count;
    double *pressure = contact->pressure, part[4] = {0};
    for (size_t k = 0; k < count && tau != 0; k++)
        pressure[set[k]] -= tau * contact->direction[set[k]];
    if (contact->kernel.ny == 1 && solver->preconditioned && tau != 0)
        give_inwards(contact);
    for (size_t k = 0; k < count; k += 4)
        for (size_t i = 0; i < 4 && k + i < count; i++) {
            const double p = pressure[set[k + i]], pressed = p > 0 ? p : 0;
            pressure[set[k + i]] = pressed;
            part[i] += pressed;
        }
    double scale = solver->load->mean_pressure * (double)contact->kernel.points / sum(part);
    for (size_t k = 0; k < count; k++)
        pressure[set[k]] *= scale;
}

/** lambda, the constant to subtract from 2 u - h, u the field: its mean where 0 < p < H, points that are all in `set`.
 * Without such a point any value between the gaps of the points at H and those at 0 will do; if the first are larger,
 * the value between them violates the conditions of both. */
static double level(const struct solver *solver)
{
    const struct direct_contact *contact = solver->contact;
    const struct direct_kernel *kernel = &contact->kernel;
    const double *u = kernel->field, *pressure = contact->pressure, *height_m = contact->height_m;
    size_t count = contact->set_count, number = 0;
    double part[4] = {0}, ends[2] = {-INFINITY, -INFINITY}; /* highest, and minus the lowest */
    for (size_t k = 0; k < count; k += 4)
        for (size_t i = 0; i < 4 && k + i < count; i++) {
            uint32_t at = contact->set[k + i];
            bool free = pressure[at] > 0 && pressure[at] < solver->hardness;
            part[i] += free ? 2 * u[at] - height_m[at] : 0;
            number += free;
        }
    if (number > 0)
        return sum(part) / (double)number;
    for (size_t j = 0; j < kernel->ny; j++)
        for (size_t k = j * kernel->stride; k < j * kernel->stride + kernel->nx; k++) {
            double g = 2 * u[k] - height_m[k];
            if (pressure[k] > 0)
                ends[0] = fmax(ends[0], g);
            else
                ends[1] = fmax(ends[1], -g);
        }
    return (ends[0] - ends[1]) / 2;
}

/** Of a row, from place `first` on: the gap, from the field, and whether a point is free or violates a condition. */
CLONES static void lay_row(struct direct_contact *contact, size_t first, double lambda, double hardness)
{
    const double *u = contact->kernel.field + first, *p = contact->pressure + first, *h = contact->height_m + first;
    double *restrict gap_m = contact->gap_m + first;
    uint8_t *restrict taken = contact->taken;
    const size_t count = contact->kernel.nx;
    for (size_t i = 0; i < count; i++) {
        const double g = 2 * u[i] - h[i] - lambda;
        gap_m[i] = g;
        taken[i] = (uint8_t)(((p[i] > 0) & ((p[i] < hardness) | (g > 0))) | ((p[i] <= 0) & (g < 0)));
    }
}

/** Whether BLOCK flags are all 0. */
static bool none(const uint8_t flag[BLOCK])
{
    static const uint8_t zeros[BLOCK];
    return memcmp(flag, zeros, BLOCK) == 0;
}

/** Finds the gap from the field, K p, and the new set: {0 < p < H}, and the violators {p = 0, g < 0} and {p = H, g >
 * 0}. Violators join only when they are the worst (proportioning: Dostál, SIAM J. Optim. 7 (1997) 871), as points would
 * otherwise change sides in every iteration and no direction would last. Returns max |g| over all of these. */
static double lay_set(struct solver *solver)
{
    struct direct_contact *contact = solver->contact;
    const struct direct_kernel *kernel = &contact->kernel;
    const double *pressure = contact->pressure, *gap_m = contact->gap_m;
    double lambda = level(solver), hardness = solver->hardness, violated = 0, free = 0, gaps = 0; /* |g| at most */
    uint8_t *member = contact->member;
    uint32_t *set = contact->set;
    size_t count = 0, kept = 0;
    bool joined[2] = {false};
    if (!isfinite(lambda))
        return NAN; /* comparisons below are false for it */
    for (size_t j = 0; j < kernel->ny; j++) {
        const size_t first = j * kernel->stride, before = count;
        lay_row(contact, first, lambda, hardness);
        for (size_t i = 0; i < kernel->nx; i++) {
            const size_t k = first + i;
            if (!contact->taken[i]) {
                if (i % BLOCK == 0 && i + BLOCK <= kernel->nx && none(contact->taken + i)) {
                    memset(member + k, 0, BLOCK);
                    i += BLOCK - 1;
                } else {
                    member[k] = 0;
                }
                continue;
            }
            const double g = fabs(gap_m[k]);
            if (pressure[k] > 0 && pressure[k] < hardness) {
                free = g > free ? g : free;
                joined[1] |= !member[k];
                member[k] = FREE;
            } else {
                violated = g > violated ? g : violated;
                gaps += gap_m[k];
                joined[0] |= !member[k];
                member[k] = VIOLATOR;
            }
            set[count++] = (uint32_t)k;
        }
        contact->rows[j] = count > before;
    }
    const bool all = violated >= free;
    for (size_t k = 0; !all && violated > 0 && k < count; k++) {
        set[kept] = set[k];
        kept += member[set[k]] == FREE;
        member[set[k]] &= FREE;
    }
    contact->set_count = all || violated == 0 ? count : kept;
    solver->joined |= joined[1] || (all && joined[0]);
    solver->violators = all && violated > 0;
    solver->mean = all ? gaps / (double)count : 0; /* without violators it is 0 */
    return all ? violated : free;
}

/** Values on the line first + step i, i = 1 ... count. */
static void fill_line(double *value, size_t count, double first, double step)
{
    for (size_t i = 0; i < count; i++)
        value[i] = first + step * (double)(int)(i + 1);
}

/** Sum of value i, i = 1 ... count, and of i times it. */
static void add_line(double out[2], const double *value, size_t count)
{
    double sums[4] = {0}, moments[4] = {0};
    size_t i = 0;
    for (; i + 4 <= count; i += 4)
        for (size_t k = 0; k < 4; k++) {
            sums[k] += value[i + k];
            moments[k] += value[i + k] * (double)(int)(i + k + 1);
        }
    for (; i < count; i++) {
        sums[0] += value[i];
        moments[0] += value[i] * (double)(int)(i + 1);
    }
    out[0] = sum(sums);
    out[1] = sum(moments);
}

/** Between a point of a strip's set and the next: interpolates values, or (`back`) adds the values between to the two
 * points with the same weights. After the last point comes the first. */
static void bridge(double *field, const uint32_t *set, size_t k, const struct direct_contact *contact, bool back)
{
    size_t points = contact->kernel.nx, last = k + 1 == contact->set_count;
    size_t from = set[k], to = set[last ? 0 : k + 1], wide = last ? points + to - from : to - from;
    size_t here = last ? points - from - 1 : wide - 1, round = last ? to : 0; /* points up to the end, and after it */
    if (back) {
        double sums[2], more[2];
        add_line(sums, field + from + 1, here);
        add_line(more, field, round);
        double moment = (sums[1] + more[1] + (double)here * more[0]) / (double)wide;
        field[from] += sums[0] + more[0] - moment;
        field[to] += moment;
    } else {
        double first = field[from], step = (field[to] - first) / (double)wide;
        fill_line(field + from + 1, here, first, step);
        fill_line(field, round, first + step * (double)here, step);
    }
}

/** The same between all points of a strip's set. */
static void bridge_all(struct direct_contact *contact, bool back)
{
    const uint32_t *set = contact->set;
    for (size_t k = 0; k < contact->set_count; k++)
        if (k + 1 == contact->set_count || set[k + 1] != set[k] + 1)
            bridge(contact->kernel.field, set, k, contact, back);
}

void direct_contact_clear(struct direct_contact *contact)
{
    const struct direct_kernel *kernel = &contact->kernel;
    if (kernel->ny > 1) /* of a strip bridge_all() fills in all places that are not in the set */
        memset(kernel->field, 0, kernel->ny * kernel->stride * sizeof(double));
}

void direct_contact_stiffen(struct direct_contact *contact)
{
    struct direct_kernel *kernel = &contact->kernel;
    if (kernel->ny == 1)
        bridge_all(contact, false);
    direct_kernel_convolve(kernel, DIRECT_STIFFNESS, contact->rows);
    if (kernel->ny == 1)
        bridge_all(contact, true);
}

/** Removes from the set the points without pressure on which a step against z would leave tension. Where many points
 * join at once, z alternates from one to the next; the length of the step assumes that their displacements cancel,
 * which fails when half of the points stay at 0, and the gaps grow tenfold. */
static void drop_pulled(struct solver *solver, const double *z)
{
    struct direct_contact *contact = solver->contact;
    double mean = 0, gaps = 0;
    size_t kept = 0;
    for (size_t k = 0; k < contact->set_count; k++)
        mean += z[contact->set[k]] / (double)contact->set_count;
    for (size_t k = 0; k < contact->set_count; k++) {
        uint32_t at = contact->set[k];
        contact->member[at] = contact->pressure[at] > 0 || z[at] <= mean;
        contact->set[kept] = at;
        kept += contact->member[at];
        gaps += contact->member[at] ? contact->gap_m[at] : 0;
    }
    contact->set_count = kept;
    solver->mean = gaps / (double)kept;
}

/** The next direction t = z + (G/last G) t on the set, with sum zero; z = M g, M = |q| on the set. On a strip the last
 * direction is dropped when G rises, as it does when many points have left. Returns <g, t>; the field holds t. */
static double turn(struct solver *solver)
{
    struct direct_contact *contact = solver->contact;
    struct direct_kernel *kernel = &contact->kernel;
    const uint32_t *set = contact->set;
    const double *gap_m = contact->gap_m, *z = solver->preconditioned ? kernel->field : gap_m;
    double *t = contact->direction, sums[4][4] = {{0}};
    size_t count = contact->set_count, bytes = kernel->ny * kernel->stride * sizeof(double);
    if (solver->preconditioned) {
        direct_contact_clear(contact);
        for (size_t k = 0; k < count; k++)
            kernel->field[set[k]] = gap_m[set[k]] - solver->mean;
        direct_contact_stiffen(contact);
        if (solver->careful && solver->violators)
            drop_pulled(solver, z);
        count = contact->set_count;
    }
    for (size_t k = 0; k < count; k += 4)
        for (size_t i = 0; i < 4 && k + i < count; i++) {
            sums[0][i] += z[set[k + i]];
            sums[1][i] += z[set[k + i]] * gap_m[set[k + i]];
        }
    double z_mean = sum(sums[0]) / (double)count, product = sum(sums[1]) - sum(sums[0]) * solver->mean;
    bool afresh = solver->joined || (kernel->ny == 1 && product > solver->last);
    double share = afresh ? 0 : product / solver->last;
    solver->last = product;
    solver->joined = false;
    for (size_t k = 0; k < count; k += 4)
        for (size_t i = 0; i < 4 && k + i < count; i++) {
            uint32_t at = set[k + i];
            t[at] = z[at] - z_mean + (share != 0 ? share * t[at] : 0);
            sums[2][i] += t[at];
        }
    double t_mean = sum(sums[2]) / (double)count;
    memset(kernel->field, 0, bytes);
    for (size_t k = 0; k < count; k += 4)
        for (size_t i = 0; i < 4 && k + i < count; i++) {
            uint32_t at = set[k + i];
            kernel->field[at] = t[at] -= t_mean;
            sums[3][i] += (gap_m[at] - solver->mean) * t[at];
        }
    return sum(sums[3]);
}

/** One step of conjugate gradients along the direction, and back onto the bounds. */
static void step(struct solver *solver)
{
    struct direct_contact *contact = solver->contact;
    struct direct_kernel *kernel = &contact->kernel;
    double slope = turn(solver), tau = slope / (2 * direct_kernel_energy(kernel, DIRECT_COMPLIANCE));
    if (isinf(solver->hardness)) {
        move(solver, tau);
    } else {
        for (size_t k = 0; k < contact->set_count; k++)
            contact->pressure[contact->set[k]] -= tau * contact->direction[contact->set[k]];
        fit_mean(solver);
    }
    displace(solver);
}

/** Iterates to `tolerance`. */
static enum status_code iterate(struct solver *solver, double tolerance, struct status *status)
{
    struct direct_contact *contact = solver->contact;
    double best = INFINITY, joined_at = INFINITY; /* the violation with which points joined last */
    size_t waited = 0;
    solver->joined = true;
    for (;;) {
        if (contact->kernel.exhausted)
            return status_memory(status);
        double violation = lay_set(solver) / contact->rms_m;
        if (violation < tolerance)
            return STATUS_OK;
        if (solver->load->stop && *solver->load->stop)
            return status_fail(status, STATUS_INTERRUPTED, "stopped");
        solver->careful |= violation > THROWN * joined_at;
        joined_at = solver->violators ? violation : INFINITY;
        waited++;
        if (violation < best / 2) {
            best = violation;
            waited = 0;
        }
        if (!isfinite(violation) || waited > PATIENCE) {
            if (!solver->preconditioned || !isfinite(violation))
                return status_fail(status, STATUS_MODEL,
                                   "the direct solution does not converge at p/E' = %g (violation %.1e of the "
                                   "roughness after %zu iterations); use a finer grid, denser scans or another load",
                                   solver->load->mean_pressure, violation, solver->contact->iterations);
            solver->preconditioned = false; /* try again without */
            solver->joined = true;
            waited = 0;
            best = INFINITY;
        }
        step(solver);
        solver->contact->iterations++;
    }
}

/** Moves the pressures of a strip along their response to the load until their mean is p̄, 0 instead of tension
 * (Newton's method: the mean is convex in the step). */
static void follow_response(struct solver *solver)
{
    struct direct_contact *contact = solver->contact;
    const uint32_t *set = contact->set;
    double *pressure = contact->pressure, *response = contact->response, step = 0;
    double wanted = solver->load->mean_pressure * (double)contact->kernel.points;
    for (int k = 0; k < 100; k++) {
        double sum = 0, slope = 0;
        for (size_t i = 0; i < contact->set_count; i++) {
            double p = pressure[set[i]] + step * response[set[i]];
            sum += p > 0 ? p : 0;
            slope += p > 0 ? response[set[i]] : 0;
        }
        if (fabs(sum - wanted) <= 1e-9 * wanted || !(slope > 0))
            break;
        step += (wanted - sum) / slope;
    }
    for (size_t i = 0; i < contact->set_count; i++)
        pressure[set[i]] += step * response[set[i]];
}

/** Adds the pressure of the coarse grid times `sign`, interpolated linearly, to the direction; also at the edges of a
 * mirrored grid, where it is as good a start. */
static void add_coarse(struct direct_contact *contact, double sign)
{
    const struct direct_kernel *fine = &contact->kernel, *coarse = &contact->coarse->kernel;
    size_t nx = coarse->nx;
    memset(fine->field, 0, fine->ny * fine->stride * sizeof(double));
    for (size_t turn = 0; turn < coarse->ny; turn++) {
        const double *row = contact->coarse->pressure + turn * coarse->stride;
        for (size_t k = 0; k < 3; k++) { /* the fine rows before, on and after it */
            double *to = fine->field + (2 * turn + k + fine->ny - 1) % fine->ny * fine->stride;
            double weight = k == 1 ? sign : sign / 2;
            for (size_t i = 0; i < nx; i++) {
                to[2 * i] += weight * row[i];
                to[2 * i + 1] += weight / 2 * (row[i] + row[i + 1 < nx ? i + 1 : 0]);
            }
        }
    }
    for (size_t k = 0; k < fine->ny * fine->stride; k++)
        contact->direction[k] += fine->field[k];
}

/** Solves on the coarse grid and changes the pressure by as much as it changed there (`warm`), else sets it to the
 * pressure there. False: there is no solution. */
static bool follow_coarse(struct solver *solver, bool warm)
{
    struct direct_contact *contact = solver->contact, *coarse = contact->coarse;
    struct direct_contact_load load = *solver->load;
    struct status problem = {0};
    size_t places = contact->kernel.ny * contact->kernel.stride;
    warm = warm && coarse->solved;
    load.hardness = INFINITY;
    load.tolerance = fmax(load.tolerance, START);
    load.warm = warm;
    memset(contact->direction, 0, places * sizeof(double));
    if (warm)
        add_coarse(contact, -1);
    if (direct_contact_solve(coarse, &load, &problem) != STATUS_OK) {
        contact->kernel.exhausted = problem.code == STATUS_MEMORY;
        return false;
    }
    contact->convolutions += coarse->convolutions / 4;
    if (warm && coarse->iterations == 0)
        return true; /* only rounding has changed, which would put pressure on points that are apart */
    add_coarse(contact, 1);
    for (size_t k = 0; k < places; k++)
        contact->pressure[k] = (warm ? contact->pressure[k] : 0) + contact->direction[k];
    return true;
}

/** Pressures to start from: those of the last solution, changed as on the coarse grid, along the response of a strip or
 * (`begun`) only scaled; without a last solution those of the coarse grid, or p̄ everywhere. `set` becomes all points.
 */
static void start(struct solver *solver, bool warm, bool begun)
{
    struct direct_contact *contact = solver->contact;
    if (warm && contact->response)
        follow_response(solver);
    if (contact->coarse && !begun)
        warm = follow_coarse(solver, warm);
    direct_contact_select(contact, true);
    if (warm)
        move(solver, 0);
    for (size_t k = 0; !warm && k < contact->set_count; k++)
        contact->pressure[contact->set[k]] = solver->load->mean_pressure;
}

static bool exceeds(const struct direct_contact *contact, double hardness)
{
    bool found = false;
    for (size_t k = 0; k < contact->set_count && !found; k++)
        found = contact->pressure[contact->set[k]] > hardness;
    return found;
}

static enum status_code solve(struct solver *solver, struct status *status)
{
    struct direct_contact *contact = solver->contact;
    const struct direct_contact_load *load = solver->load;
    bool capped = isfinite(load->hardness), warm = load->warm && contact->solved;
    bool begun = capped && warm && contact->capped; /* without an elastic solution in between */
    solver->hardness = INFINITY;
    solver->preconditioned = true;
    start(solver, warm, begun);
    if (!begun) {
        displace(solver);
        if (iterate(solver, capped ? fmax(START, load->tolerance) : load->tolerance, status) != STATUS_OK || !capped)
            return status->code;
        if (!exceeds(contact, load->hardness) && iterate(solver, load->tolerance, status) != STATUS_OK)
            return status->code;
        if (!exceeds(contact, load->hardness)) /* the hardness is reached nowhere */
            return STATUS_OK;
    }
    solver->hardness = load->hardness;
    solver->preconditioned = false; /* with it points jump between 0 and H */
    fit_mean(solver);
    displace(solver);
    return iterate(solver, load->tolerance, status);
}

enum status_code direct_contact_solve(struct direct_contact *contact, const struct direct_contact_load *load,
                                      struct status *status)
{
    contact->iterations = contact->convolutions = 0;
    assert(load->tolerance > 0 && load->hardness > 0);
    if (!(load->mean_pressure > 0) || !isfinite(load->mean_pressure))
        return status_fail(status, STATUS_MODEL, "a mean pressure of %g E' cannot be solved; it has to be positive",
                           load->mean_pressure);
    if (load->mean_pressure >= load->hardness)
        return status_fail(status, STATUS_MODEL,
                           "complete contact: a hardness of %g E' is not defined for a mean pressure of %g E'",
                           load->hardness, load->mean_pressure);
    size_t before = contact->kernel.transforms;
    struct solver solver = {.contact = contact, .load = load};
    enum status_code rc = solve(&solver, status);
    contact->convolutions += (contact->kernel.transforms - before) / 2;
    contact->solved = rc == STATUS_OK;
    contact->capped = isfinite(solver.hardness);
    return rc;
}

const uint8_t *direct_contact_touching(struct direct_contact *contact)
{
    const struct direct_kernel *kernel = &contact->kernel;
    for (size_t j = 0; j < kernel->ny; j++)
        for (size_t i = 0; i < kernel->nx; i++)
            contact->member[j * kernel->nx + i] = contact->pressure[j * kernel->stride + i] > 0;
    return contact->member;
}
