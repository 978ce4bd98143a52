/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/comparison.h"

#include <math.h>
#include <stdlib.h>

double comparison_value(const struct contact_point *point, enum quantity quantity, size_t model, double sigma_m)
{
    return quantity_shown(point, model_shown(model_rows[model], quantity), sigma_m);
}

bool comparison_converges(const struct results *results, enum convergence_sweep sweep, size_t model, size_t value)
{
    size_t scales = results->scene->convergence.scales;
    const double *area = results_sweep(results, sweep, model, value);
    return scales < 2 || area[scales - 1] >= 0.999 * area[scales / 2 - 1];
}

struct contact_point comparison_middle(const struct results *results, size_t model, size_t surface)
{
    const struct curve_summary *summary = surface_model(&results->surfaces[surface].summary, model);
    return summary->exists ? summary->operating : quantity_nothing();
}

bool comparison_overloaded(const struct results *results, size_t model, size_t surface)
{
    const struct contact_point at = comparison_middle(results, model, surface);
    const struct material_pair *pair = results_pair(results, surface);
    return !pair->unknown && model_is_overloaded(model_rows[model], &at, pair);
}

double comparison_heights_factor(const struct results *results, size_t surface)
{
    size_t leading = plan_leading_model(results->plan), gaussian = model_index(model_rows[leading]->gaussian);
    if (!plan_runs_model(results->plan, gaussian))
        return NAN;
    double factor = comparison_middle(results, leading, surface).value[QUANTITY_ECR] /
                    comparison_middle(results, gaussian, surface).value[QUANTITY_ECR];
    return isfinite(factor) ? factor : NAN; /* a filler keeps the metals apart in one of them */
}

struct comparison_pair comparison_of_two(const struct estimate *a, const struct estimate *b)
{
    const struct interval first = {.mean = a->mean, .s = a->s, .degrees = a->degrees},
                          second = {.mean = b->mean, .s = b->s, .degrees = b->degrees};
    struct ranking welch = ranking_welch(&first, &second, estimate_level);
    return (struct comparison_pair){welch.ratio, welch.low, welch.high, welch.p};
}

/** The scatter that surfaces of one scan have on average, where there are some: three or more. One scan's own comes
 * from few degrees of freedom, and among many surfaces some is far too small by chance: none is held to scatter less.
 */
static double usual_scatter(const struct estimate *const *estimates, size_t count)
{
    double sum = 0, of = 0;
    for (size_t i = 0; i < count; i++)
        if (estimates[i]->count == 1 && estimates[i]->s > 0) {
            sum += estimates[i]->s * estimates[i]->s;
            of++;
        }
    return of >= 3 ? sqrt(sum / of) : 0;
}

enum status_code comparison_test(struct comparison *ranking, const struct estimate *const *estimates,
                                 struct status *status)
{
    size_t count = ranking->count, pairs = count * (count - (count > 0)) / 2;
    double least = usual_scatter(estimates, count);
    OWNED(memory_free) double *p = malloc((pairs + 1) * sizeof *p);
    OWNED(memory_free) bool *apart = malloc((pairs + 1) * sizeof *apart);
    ranking->pairs = malloc((pairs + 1) * sizeof *ranking->pairs);
    if (!p || !apart || !ranking->pairs)
        return status_memory(status);
    for (size_t i = 0; i < count; i++)
        for (size_t j = i + 1; j < count; j++) {
            size_t k = ranking_pair(i, j, count);
            struct estimate two[] = {*estimates[i], *estimates[j]};
            for (int t = 0; t < 2; t++)
                two[t].s = two[t].count == 1 && two[t].s > 0 ? fmax(two[t].s, least) : two[t].s;
            ranking->pairs[k] = comparison_of_two(&two[0], &two[1]);
            p[k] = ranking->pairs[k].p;
        }
    if (ranking_holm(p, p, pairs, status) != STATUS_OK)
        return status->code;
    for (size_t k = 0; k < pairs; k++) {
        ranking->pairs[k].p = p[k];
        apart[k] = comparison_told_apart(&ranking->pairs[k]);
    }
    return count <= COMPARISON_RANKED_MOST ? ranking_groups_make(&ranking->groups, apart, count, status) : STATUS_OK;
}

bool comparison_told_apart(const struct comparison_pair *pair)
{
    return pair->p <= 1 - estimate_level;
}

const struct comparison_pair *comparison_pair_of(const struct comparison *ranking, size_t i, size_t j)
{
    return &ranking->pairs[ranking_pair(i, j, ranking->count)];
}

enum status_code comparison_make(struct comparison *out, const struct results *results, struct status *status)
{
    const struct estimate *estimates[COMPARISON_RANKED_MOST];
    size_t surfaces = 0;
    const enum quantity asked = results_asked_quantity(results);
    const bool joined = asked == QUANTITY_JOINT_ECR || asked == QUANTITY_SHAPE_JOINT || asked == QUANTITY_SHAPE_ECR;
    *out = (struct comparison){.criterion = joined ? asked : results_criterion(results)};
    for (size_t k = 0; k < results->usable_count; k++)
        surfaces += isfinite(results_cost(results, results->by_roughness[k], out->criterion)) ? 1 : 0;
    if (surfaces == 0 || surfaces > COMPARISON_RANKED_MOST)
        return STATUS_OK;
    out->surface = malloc(surfaces * sizeof *out->surface);
    if (!out->surface)
        return status_memory(status);
    for (size_t i = 0; i < results->surface_count; i++) {
        const double cost = results_cost(results, i, out->criterion);
        const struct estimate *estimate = results_estimate(results, i, out->criterion);
        if (!isfinite(cost) || estimate->count == 0 || isnan(estimate->half_width))
            continue;
        size_t at = out->count++;
        for (; at > 0 && cost < results_cost(results, out->surface[at - 1], out->criterion); at--)
            out->surface[at] = out->surface[at - 1];
        out->surface[at] = i;
    }
    for (size_t i = 0; i < out->count; i++)
        estimates[i] = results_estimate(results, out->surface[i], out->criterion);
    return comparison_test(out, estimates, status);
}

void comparison_free(struct comparison *comparison)
{
    free(comparison->surface);
    free(comparison->pairs);
    ranking_groups_free(&comparison->groups);
    *comparison = (struct comparison){0};
}
