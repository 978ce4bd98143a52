/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "statistics/ranking.h"

#include <assert.h>
#include <float.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_sort_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct ranking ranking_welch(const struct interval *a, const struct interval *b, double level)
{
    struct ranking out = {.difference = a->mean - b->mean, .s = hypot(a->s, b->s)};
    if (out.s > 0) {
        double share = (a->s / out.s) * (a->s / out.s), rest = (b->s / out.s) * (b->s / out.s);
        out.degrees = 1 / (share * share / a->degrees + rest * rest / b->degrees);
        out.t = out.difference / out.s;
        out.p = 2 * gsl_cdf_tdist_Q(fabs(out.t), out.degrees);
    } else {
        out.degrees = a->degrees + b->degrees;
        out.t = out.difference == 0 ? 0 : copysign(DBL_MAX, out.difference);
        out.p = out.difference == 0 ? 1 : 0;
    }
    double half_width = interval_quantile(level, out.degrees) * out.s;
    out.ratio = exp(out.difference);
    out.low = exp(out.difference - half_width);
    out.high = exp(out.difference + half_width);
    return out;
}

enum status_code ranking_holm(double *adjusted, const double *p, size_t count, struct status *status)
{
    OWNED(memory_free) size_t *order = calloc(count + 1, sizeof *order);
    if (!order)
        return status_memory(status);
    gsl_sort_index(order, p, 1, count);
    double largest = 0;
    for (size_t r = 0; r < count; r++) {
        largest = fmax(largest, fmin(1, (double)(count - r) * p[order[r]]));
        adjusted[order[r]] = largest;
    }
    return STATUS_OK;
}

size_t ranking_pair(size_t i, size_t j, size_t count)
{
    assert(i < j && j < count);
    return i * (2 * count - i - 1) / 2 + (j - i - 1);
}

static bool alike(const bool *apart, size_t i, size_t j, size_t count)
{
    return i == j || !apart[i < j ? ranking_pair(i, j, count) : ranking_pair(j, i, count)];
}

/** Does a group other than `except` hold both i and j (i = j: that one)? */
static bool covered(const struct ranking_groups *groups, size_t i, size_t j, size_t except)
{
    for (size_t g = 0; g < groups->groups; g++) {
        const bool *member = groups->member + g * groups->surfaces;
        if (g != except && member[i] && member[j])
            return true;
    }
    return false;
}

/** Adds the group of i and j and, in order, of all that are alike to every member. */
static void add_group(struct ranking_groups *groups, const bool *apart, size_t i, size_t j)
{
    bool *member = groups->member + groups->groups++ * groups->surfaces;
    member[i] = member[j] = true;
    for (size_t k = 0; k < groups->surfaces; k++) {
        bool fits = true;
        for (size_t m = 0; m < groups->surfaces; m++)
            fits = fits && (!member[m] || alike(apart, k, m, groups->surfaces));
        member[k] = fits;
    }
}

static bool needed(const struct ranking_groups *groups, size_t group)
{
    const bool *member = groups->member + group * groups->surfaces;
    for (size_t i = 0; i < groups->surfaces; i++)
        for (size_t j = i; j < groups->surfaces; j++)
            if (member[i] && member[j] && !covered(groups, i, j, group))
                return true;
    return false;
}

/** The group with the first surface that only one of them has comes first. */
static int first_surface_first(const void *a, const void *b, void *surfaces)
{
    return memcmp(b, a, *(const size_t *)surfaces * sizeof(bool));
}

enum status_code ranking_groups_make(struct ranking_groups *out, const bool *apart, size_t surfaces,
                                     struct status *status)
{
    /* one group a pair at most, or one a surface */
    size_t room = surfaces * (surfaces + 1) / 2 + 1;
    *out = (struct ranking_groups){.surfaces = surfaces, .member = calloc(room * (surfaces + 1), sizeof(bool))};
    if (!out->member)
        return status_memory(status);
    for (size_t i = 0; i < surfaces; i++)
        for (size_t j = i + 1; j < surfaces; j++)
            if (alike(apart, i, j, surfaces) && !covered(out, i, j, out->groups))
                add_group(out, apart, i, j);
    for (size_t i = 0; i < surfaces; i++)
        if (!covered(out, i, i, out->groups))
            add_group(out, apart, i, i);
    for (size_t g = out->groups; g-- > 0;)
        if (!needed(out, g)) /* the next ones move up */
            memmove(out->member + g * surfaces, out->member + (g + 1) * surfaces, (--out->groups - g) * surfaces);
    if (out->groups > 1)
        qsort_r(out->member, out->groups, surfaces * sizeof(bool), first_surface_first, &out->surfaces);
    return STATUS_OK;
}

void ranking_groups_free(struct ranking_groups *groups)
{
    free(groups->member);
    *groups = (struct ranking_groups){0};
}

void ranking_groups_letters(char *out, const struct ranking_groups *groups, size_t surface)
{
    static const char letter[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    size_t length = 0;
    for (size_t g = 0; g < groups->groups; g++)
        if (groups->member[g * groups->surfaces + surface] && length < RANKING_LETTERS)
            out[length++] = g < RANKING_LETTERS ? letter[g] : '*';
    out[length] = '\0';
}
