/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/persson.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_eigen.h>
#include <math.h>
#include <pthread.h>
#include <stdlib.h>

const double persson_energy_factor = 0.45;

static const double group_width = 0.5; /* in ln y */
static const double group_reach = 3; /* p/y_N beyond which the tail of s is too steep for the groups: each ring then */
static const double negligible = 60; /* exp(-60) is nothing, even times the ratio of two weights */
enum { GROUP_NODES = 10, GROUP_LEAST = 40 };

double persson_erf_inverse(double y)
{
    if (y > 0.5) /* l = Phi^-1(1 - (1-y)/2), erf(l/sqrt2) = y */
        return gsl_cdf_ugaussian_Qinv((1 - y) / 2) / M_SQRT2;
    double x = gsl_cdf_ugaussian_Pinv(0.5 + y / 2) / M_SQRT2; /* 1/2 + y/2 has lost digits of y: */
    return x - (erf(x) - y) * exp(x * x) / M_2_SQRTPI;        /* one step of Newton's finds them */
}

double persson_load(double area_ratio, double m2, double energy_factor)
{
    return persson_erf_inverse(area_ratio) * sqrt(m2 * (energy_factor + (1 - energy_factor) * area_ratio));
}

double persson_area(double load, double m2, double energy_factor)
{
    if (!(load > 0))
        return 0;
    if (!(m2 > 0))
        return 1;
    double x = load / sqrt(m2);
    double low = erf(x), high = erf(x / sqrt(energy_factor)), area = high;
    if (low == 1)
        return 1;
    for (int iteration = 0; iteration < 60; iteration++) {
        double eased = energy_factor + (1 - energy_factor) * area, t = x / sqrt(eased);
        double excess = area - erf(t); /* rises with area */
        if (excess > 0)
            high = area;
        else
            low = area;
        double slope = 1 + M_2_SQRTPI * exp(-t * t) * t / 2 * (1 - energy_factor) / eased;
        double next = area - excess / slope;
        if (!(next > low && next < high))
            next = low + (high - low) / 2;
        if (fabs(next - area) <= 1e-16 * area || next <= low || next >= high)
            return next;
        area = next;
    }
    return area;
}

static enum status_code allocate(struct persson_nodes *nodes, size_t most, struct status *status)
{
    nodes->count = 0;
    nodes->slope = malloc((3 * most + 1) * sizeof *nodes->slope);
    if (!nodes->slope)
        return status_memory(status);
    nodes->logarithm = nodes->slope + most;
    nodes->weight_m = nodes->logarithm + most;
    return STATUS_OK;
}

static void append(struct persson_nodes *nodes, double logarithm, double weight_m)
{
    if (!(weight_m > 0))
        return;
    nodes->logarithm[nodes->count] = logarithm;
    nodes->slope[nodes->count] = exp(logarithm);
    nodes->weight_m[nodes->count++] = weight_m;
}

/** q_n = sqrt2 2 pi f_n. */
static double wave_number(const struct spectrum *spectrum, size_t i)
{
    return M_SQRT2 * 2 * M_PI * spectrum_frequency(spectrum, i);
}

/** y_n and c_n of every harmonic; those before the first amplitude have y = 0, where S is 0. */
static void lay_rings(struct persson *persson, const struct spectrum *spectrum)
{
    for (size_t i = 0; i < spectrum->count; i++) {
        double omega = 2 * M_PI * spectrum_frequency(spectrum, i), power = spectrum_power(spectrum, i);
        persson->m0_m2 += power;
        persson->m2 += omega * omega * power;
        if (!(persson->m2 > 0))
            continue;
        double q = wave_number(spectrum, i), weight = 1 / q;
        if (i + 1 < spectrum->count) {
            double next = wave_number(spectrum, i + 1);
            weight = (next - q) / q / next;
        }
        append(&persson->rings, log(persson->m2) / 2, M_2_SQRTPI * weight);
    }
}

/** Recurrence coefficients of the polynomials orthogonal on `count` points with positive weights: diagonal alpha,
 * off-diagonal sqrt(beta) of the Jacobi matrix (Stieltjes's procedure; Gautschi 2004, Orthogonal Polynomials, 2.2.3).
 */
static void stieltjes(double alpha[GROUP_NODES], double beta[GROUP_NODES], const double *x, const double *weight,
                      size_t count, double scratch[][2])
{
    double norm_before = 1;
    for (size_t i = 0; i < count; i++) {
        scratch[i][0] = 0; /* p_{k-1} */
        scratch[i][1] = 1; /* p_k */
    }
    for (int k = 0; k < GROUP_NODES; k++) {
        double norm = 0, moment = 0;
        for (size_t i = 0; i < count; i++) {
            double term = weight[i] * scratch[i][1] * scratch[i][1];
            norm += term;
            moment += term * x[i];
        }
        alpha[k] = moment / norm;
        beta[k] = k > 0 ? norm / norm_before : norm;
        norm_before = norm;
        for (size_t i = 0; i < count; i++) {
            double next = (x[i] - alpha[k]) * scratch[i][1] - (k > 0 ? beta[k] : 0) * scratch[i][0];
            scratch[i][0] = scratch[i][1];
            scratch[i][1] = next;
        }
    }
}

/** Working memory of the grouping. */
struct grouping {
    gsl_eigen_symmv_workspace *workspace;
    gsl_matrix *matrix, *vectors;
    gsl_vector *values;
    double *place;        /* ln y from the middle of the group, in half widths */
    double (*scratch)[2]; /* two polynomials at each ring */
};

/** Appends the nodes of Gauss's rule for rings `first` to `last - 1` (Golub and Welsch 1969). */
static void append_group(struct persson_nodes *groups, const struct persson_nodes *rings, size_t first, size_t last,
                         struct grouping *work)
{
    double middle = rings->logarithm[first] + group_width / 2;
    for (size_t i = first; i < last; i++)
        work->place[i - first] = (rings->logarithm[i] - middle) / (group_width / 2);
    double alpha[GROUP_NODES], beta[GROUP_NODES];
    stieltjes(alpha, beta, work->place, rings->weight_m + first, last - first, work->scratch);
    gsl_matrix_set_zero(work->matrix);
    for (size_t k = 0; k < GROUP_NODES; k++) {
        gsl_matrix_set(work->matrix, k, k, alpha[k]);
        if (k > 0) {
            gsl_matrix_set(work->matrix, k, k - 1, sqrt(beta[k]));
            gsl_matrix_set(work->matrix, k - 1, k, sqrt(beta[k]));
        }
    }
    gsl_eigen_symmv(work->matrix, work->values, work->vectors, work->workspace);
    gsl_eigen_symmv_sort(work->values, work->vectors, GSL_EIGEN_SORT_VAL_ASC);
    for (size_t k = 0; k < GROUP_NODES; k++) {
        double component = gsl_matrix_get(work->vectors, 0, k);
        append(groups, middle + gsl_vector_get(work->values, k) * group_width / 2, beta[0] * component * component);
    }
}

/** How many rings from `first` on lie within a group's width. */
static size_t group_end(const struct persson_nodes *rings, size_t first)
{
    size_t last = first;
    while (last < rings->count && rings->logarithm[last] <= rings->logarithm[first] + group_width)
        last++;
    return last;
}

/** A group of many distinct rings; equal ones (zero amplitudes between) count once. */
static bool crowded(const struct persson_nodes *rings, size_t first, size_t last)
{
    size_t distinct = 0;
    for (size_t i = first; i < last && distinct < GROUP_LEAST; i++)
        distinct += i == first || rings->logarithm[i] > rings->logarithm[i - 1];
    return distinct >= GROUP_LEAST;
}

static enum status_code group(struct persson *persson, struct status *status)
{
    const struct persson_nodes *rings = &persson->rings;
    size_t most = rings->count + 1;
    struct grouping work = {
        gsl_eigen_symmv_alloc(GROUP_NODES),         gsl_matrix_alloc(GROUP_NODES, GROUP_NODES),
        gsl_matrix_alloc(GROUP_NODES, GROUP_NODES), gsl_vector_alloc(GROUP_NODES),
        malloc(most * sizeof *work.place),          malloc(most * sizeof *work.scratch),
    };
    enum status_code rc = STATUS_OK;
    if (!work.workspace || !work.matrix || !work.vectors || !work.values || !work.place || !work.scratch)
        rc = status_memory(status);
    for (size_t first = 0, last; rc == STATUS_OK && first < rings->count; first = last) {
        last = group_end(rings, first);
        if (crowded(rings, first, last))
            append_group(&persson->groups, rings, first, last, &work);
        else
            for (size_t i = first; i < last; i++)
                append(&persson->groups, rings->logarithm[i], rings->weight_m[i]);
    }
    gsl_eigen_symmv_free(work.workspace);
    gsl_matrix_free(work.matrix);
    gsl_matrix_free(work.vectors);
    gsl_vector_free(work.values);
    free(work.place);
    free(work.scratch);
    return rc;
}

/** That of the usual energy factor, made once in a process: its panels cost more than the waves of a short scan. */
static struct persson_kernel usual_kernel;
static pthread_once_t usual_kernel_made = PTHREAD_ONCE_INIT;

static void make_usual_kernel(void)
{
    usual_kernel = persson_kernel(persson_energy_factor);
}

static struct persson_kernel kernel_of(double energy_factor)
{
    if (energy_factor != persson_energy_factor)
        return persson_kernel(energy_factor);
    pthread_once(&usual_kernel_made, make_usual_kernel);
    return usual_kernel;
}

enum status_code persson_make(struct persson *out, const struct spectrum *spectrum, double energy_factor,
                              struct status *status)
{
    *out = (struct persson){.kernel = kernel_of(energy_factor)};
    enum status_code rc = allocate(&out->rings, spectrum->count, status);
    if (rc == STATUS_OK)
        rc = allocate(&out->groups, spectrum->count, status);
    if (rc == STATUS_OK) {
        lay_rings(out, spectrum);
        rc = group(out, status);
    }
    if (rc != STATUS_OK)
        persson_free(out);
    return rc;
}

void persson_free(struct persson *persson)
{
    free(persson->rings.slope);
    free(persson->groups.slope);
    persson->rings = persson->groups = (struct persson_nodes){0};
}

struct persson_separation persson_separation(const struct persson *persson, double load)
{
    struct persson_separation sum = {0, 0};
    if (persson->rings.count == 0)
        return sum;
    double logarithm = log(load), steepest = load / sqrt(persson->m2);
    const struct persson_nodes *nodes = steepest < group_reach ? &persson->groups : &persson->rings;
    for (size_t i = nodes->count; i-- > 0;) {
        double x = load / nodes->slope[i];
        if (x * x > steepest * steepest + negligible)
            break;
        struct persson_integrals at = persson_integrals(&persson->kernel, x, logarithm - nodes->logarithm[i]);
        sum.separation_m += nodes->weight_m[i] * nodes->slope[i] * at.separation;
        sum.constriction_m += nodes->weight_m[i] * at.conductance;
    }
    return sum;
}
