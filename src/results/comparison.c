/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/comparison.h"

#include <math.h>
#include <stdlib.h>

/** Points of two curves that stand at the same loads. */
static size_t common_points(const struct model_curve *a, const struct model_curve *b)
{
    size_t count = a->count < b->count ? a->count : b->count;
    while (count > 0 && a->points[count - 1].value[QUANTITY_LOAD] != b->points[count - 1].value[QUANTITY_LOAD])
        count--; /* a statistical curve closes with a load of its own */
    return count;
}

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

/** One more case of "x < y", at which a number is off by the tolerance at most; `scale` is what a difference is small
 * against, besides the two. NaN is no case. */
static void count_case(struct comparison_tally *tally, double x, double y, double tolerance, double scale)
{
    if (isnan(x) || isnan(y))
        return;
    bool tie = fabs(x - y) <= tolerance * fmax(fmax(fabs(x), fabs(y)), scale);
    tally->ties += tie;
    tally->agreeing += !tie && x < y;
    tally->opposed += !tie && x > y;
}

/** The same for two points, quantity by quantity: has `p` the larger area and stiffness, the smaller of the others? */
static void count_points(struct comparison_tally tallies[QUANTITY_COUNT], const struct contact_point *p,
                         double p_sigma_m, const struct contact_point *q, double q_sigma_m, size_t m,
                         const struct results *results)
{
    const unsigned computed = quantity_with_made(results->plan->wanted); /* the others are NaN throughout */
    if (p->value[QUANTITY_AREA] == 1 && q->value[QUANTITY_AREA] == 1)
        return; /* both full: nothing to compare */
    for (int k = QUANTITY_AREA; k < QUANTITY_COUNT; k++) {
        if (!(computed & QUANTITY_BIT(k)))
            continue;
        double x = comparison_value(p, (enum quantity)k, m, p_sigma_m);
        double y = comparison_value(q, (enum quantity)k, m, q_sigma_m);
        double scale = quantity_rows[k].sigma_column ? 1 : 0;
        bool larger = quantity_rows[k].is & QUANTITY_RISES;
        count_case(&tallies[k], larger ? y : x, larger ? x : y, results->scene->tolerance, scale);
    }
}

/** ECR, or TCR where that alone was computed: they are proportional. NaN where contact is full. */
static double resistance(const struct contact_point *point)
{
    double value = isnan(point->value[QUANTITY_ECR]) ? point->value[QUANTITY_TCR] : point->value[QUANTITY_ECR];
    return value > 0 ? value : NAN;
}

/** Points of two surfaces' curves at the same places of their lists of loads. */
static size_t listed_points(const struct model_curve *a, const double *loads_a, const struct model_curve *b,
                            const double *loads_b, size_t load_count)
{
    size_t count = a->count < b->count ? a->count : b->count;
    count = count < load_count ? count : load_count;
    while (count > 0 && (a->points[count - 1].value[QUANTITY_LOAD] != loads_a[count - 1] ||
                         b->points[count - 1].value[QUANTITY_LOAD] != loads_b[count - 1]))
        count--; /* a statistical curve closes with a load of its own */
    return count;
}

static void compare_neighbours(struct comparison *out, const struct surface_record *smooth,
                               const struct surface_record *rough, size_t pair, const struct results *results)
{
    const double *smooth_loads = results_loads(results, results->by_roughness[pair]);
    const double *rough_loads = results_loads(results, results->by_roughness[pair + 1]);
    for (size_t m = 0; m < model_count; m++) {
        if (!plan_runs_model(results->plan, m))
            continue;
        const struct model_curve *a = &smooth->curves[m], *b = &rough->curves[m];
        size_t count = a->exists && b->exists ? listed_points(a, smooth_loads, b, rough_loads, results->load_count) : 0;
        size_t used = 0;
        double sum = 0;
        for (size_t i = 0; i < count; i++) {
            const struct contact_point *p = &a->points[i], *q = &b->points[i];
            count_points(out->models[m].rank, p, smooth->summary.asperities.sigma_m, q,
                         rough->summary.asperities.sigma_m, m, results);
            if (pair == 0)
                count_points(out->models[m].smoothest, p, smooth->summary.asperities.sigma_m, q,
                             rough->summary.asperities.sigma_m, m, results);
            if (p->value[QUANTITY_LOAD] >= 0.1 * a->full_load || q->value[QUANTITY_LOAD] >= 0.1 * b->full_load)
                count_points(out->models[m].high_rank, p, smooth->summary.asperities.sigma_m, q,
                             rough->summary.asperities.sigma_m, m, results);
            double step = log10(resistance(q) / resistance(p));
            if (isfinite(step)) {
                sum += step;
                used++;
            }
        }
        out->models[m].steps[pair] = used > 0 ? sum / (double)used : NAN;
    }
}

/** Plastic model `m` against its elastic partner. */
static void compare_laws(struct comparison_plastic *out, const struct model_curve *elastic,
                         const struct model_curve *plastic, size_t m, double sigma_m, const struct results *results)
{
    if (!elastic->exists || !plastic->exists)
        return;
    size_t count = common_points(elastic, plastic);
    for (size_t i = 0; i < count; i++) {
        const struct contact_point *p = &plastic->points[i], *q = &elastic->points[i];
        double ratio = p->value[QUANTITY_AREA] / q->value[QUANTITY_AREA];
        count_points(out->changes, p, sigma_m, q, sigma_m, m, results);
        if (p->value[QUANTITY_AREA] == 1 && q->value[QUANTITY_AREA] == 1)
            continue;
        out->least = out->most > 0 ? fmin(out->least, ratio) : ratio;
        out->most = fmax(out->most, ratio);
    }
    count_case(&out->sooner, plastic->full_load, elastic->full_load, results->scene->tolerance, 0);
}

/** Mean log10 of quantity `p` of one curve over `q` of another, without its sign where `plain`, where both are above 0.
 */
static double mean_decades(const struct model_curve *a, enum quantity p, const struct model_curve *b, enum quantity q,
                           bool plain, size_t points)
{
    double sum = 0, count = 0;
    for (size_t i = 0; i < points; i++) {
        double x = a->points[i].value[p], y = b->points[i].value[q];
        if (!(x > 0) || !(y > 0))
            continue;
        sum += plain ? fabs(log10(x / y)) : log10(x / y);
        count++;
    }
    return sum / count;
}

/** Mean distances of a multiscale and a statistical curve. */
static struct comparison_gap gap_between(const struct model_curve *multiscale, const struct model_curve *statistical,
                                         double sigma_m)
{
    size_t count = multiscale->exists && statistical->exists ? common_points(multiscale, statistical) : 0;
    size_t conducting = 0;
    struct comparison_gap gap = {0};
    for (size_t i = 0; i < count; i++) {
        const struct contact_point *p = &multiscale->points[i], *q = &statistical->points[i];
        gap.plain += fabs(p->value[QUANTITY_SEPARATION] - q->value[QUANTITY_SEPARATION]) / sigma_m;
        gap.adjusted += fabs(p->value[QUANTITY_SEPARATION] - q->value[QUANTITY_ADJUSTED]) / sigma_m;
        if (!(p->value[QUANTITY_ECR] > 0) || !(q->value[QUANTITY_ECR] > 0))
            continue;
        gap.area += fabs(log10(p->value[QUANTITY_AREA] / q->value[QUANTITY_AREA]));
        gap.ecr += fabs(log10(p->value[QUANTITY_ECR] / q->value[QUANTITY_ECR]));
        conducting++;
    }
    double loads = count > 0 ? (double)count : NAN, conducting_loads = conducting > 0 ? (double)conducting : NAN;
    return (struct comparison_gap){
        gap.area / conducting_loads,
        gap.ecr / conducting_loads,
        gap.plain / loads,
        gap.adjusted / loads,
        mean_decades(multiscale, QUANTITY_SEPARATION, statistical, QUANTITY_ADJUSTED, true, count),
        mean_decades(multiscale, QUANTITY_STIFFNESS, statistical, QUANTITY_STIFFNESS, false, count)};
}

static void widen(struct comparison_extent *extent, double value)
{
    if (!isfinite(value))
        return;
    extent->least = extent->count > 0 ? fmin(extent->least, value) : value;
    extent->most = fmax(extent->most, value);
    extent->count++;
}

/** Takes the surface's values at every load of the list at which its contact is partial. */
static void note_extents(struct comparison *out, const struct results *results, const struct surface_record *record,
                         const double *loads)
{
    for (size_t m = 0; m < model_count; m++)
        for (size_t i = 0; i < record->curves[m].count && i < results->load_count; i++) {
            const struct contact_point *point = &record->curves[m].points[i];
            if (point->value[QUANTITY_LOAD] != loads[i] || !(point->value[QUANTITY_AREA] < 1))
                continue;
            widen(&out->models[m].extents[i][COMPARISON_AREAS], point->value[QUANTITY_AREA]);
            widen(&out->models[m].extents[i][COMPARISON_RESISTANCES], resistance(point));
        }
}

/** most/least at load `i`, NaN where not every surface has a value. */
static double spread_at(const struct results *results, const struct comparison_model *model, size_t i,
                        enum comparison_spread of)
{
    const struct comparison_extent *extent = &model->extents[i][of];
    return extent->count > 1 && extent->count == results->usable_count ? extent->most / extent->least : NAN;
}

double comparison_mean_spread(const struct results *results, const struct comparison_model *a,
                              const struct comparison_model *b, enum comparison_spread of)
{
    double sum = 0;
    size_t used = 0;
    for (size_t i = 0; i < results->load_count; i++)
        if (isfinite(spread_at(results, a, i, of)) && isfinite(spread_at(results, b, i, of))) {
            sum += log10(spread_at(results, a, i, of));
            used++;
        }
    return used > 0 ? sum / (double)used : NAN;
}

double comparison_largest_spread(const struct results *results, const struct comparison_model *model,
                                 enum comparison_spread of)
{
    double largest = NAN;
    for (size_t i = 0; i < results->load_count; i++)
        largest = fmax(largest, spread_at(results, model, i, of)); /* of a number and NaN, the number */
    return largest;
}

struct contact_point comparison_middle(const struct results *results, size_t model, size_t surface)
{
    const struct curve_summary *summary = surface_model(&results->surfaces[surface].summary, model);
    return summary->exists ? summary->operating : quantity_nothing();
}

double comparison_heights_factor(const struct results *results, size_t surface, enum quantity quantity)
{
    size_t leading = plan_leading_model(results->plan), gaussian = model_index(model_rows[leading]->gaussian);
    if (!plan_runs_model(results->plan, gaussian))
        return NAN;
    return comparison_middle(results, leading, surface).value[quantity] /
           comparison_middle(results, gaussian, surface).value[quantity];
}

/** Takes the surface's values at the operating load. */
static void note_middle(struct comparison *out, const struct results *results, size_t index)
{
    const struct surface_summary *summary = &results->surfaces[index].summary;
    for (size_t m = 0; m < model_count; m++) {
        const struct contact_point point = comparison_middle(results, m, index);
        for (int q = 0; q < QUANTITY_COUNT && plan_runs_model(results->plan, m); q++) {
            struct comparison_extent *extremes = &out->models[m].extremes[q];
            double value = comparison_value(&point, (enum quantity)q, m, summary->asperities.sigma_m);
            widen(extremes, value);
        }
    }
}

/** What the k-th smoothest surface adds; `previous` is the next smoother one, NULL for the first. Of more surfaces than
 * curves are kept of, those that are shown are held against each other, load by load. */
static void take_in(struct comparison *out, const struct results *results, const struct surface_record *record,
                    size_t k, const struct surface_record *previous)
{
    const struct model_curve *curves = record->curves;
    double sigma_m = record->summary.asperities.sigma_m;
    size_t index = results->by_roughness[k];
    note_middle(out, results, index);
    if (!curves)
        return;
    if (previous && previous->curves)
        compare_neighbours(out, previous, record, k - 1, results);
    for (size_t m = 0; m < model_count; m++) {
        size_t elastic = model_index(model_rows[m]->elastic), counterpart = model_index(model_rows[m]->counterpart);
        if (elastic < model_count)
            compare_laws(&out->models[m].plastic, &curves[elastic], &curves[m], m, sigma_m, results);
        if (plan_runs_model(results->plan, m) && counterpart < model_count)
            out->models[m].gaps[index] = gap_between(&curves[counterpart], &curves[m], sigma_m);
    }
    note_extents(out, results, record, results_loads(results, index));
}

/** The arrays of the models, with nothing in them yet. */
static enum status_code allocate(struct comparison *out, const struct results *results, struct status *status)
{
    size_t surfaces = results->surface_count, loads = results->load_count;
    out->models = calloc(model_count, sizeof *out->models);
    out->gaps = malloc(model_count * surfaces * sizeof *out->gaps);
    out->steps = malloc(model_count * surfaces * sizeof *out->steps);
    out->extents = calloc(model_count * loads, sizeof *out->extents);
    if (!out->models || !out->gaps || !out->steps || !out->extents)
        return status_memory(status);
    for (size_t i = 0; i < model_count * surfaces; i++) {
        out->gaps[i] = (struct comparison_gap){NAN, NAN, NAN, NAN, NAN, NAN};
        out->steps[i] = NAN;
    }
    for (size_t m = 0; m < model_count; m++) {
        out->models[m].gaps = out->gaps + m * surfaces;
        out->models[m].steps = out->steps + m * surfaces;
        out->models[m].extents = out->extents + m * loads;
    }
    return STATUS_OK;
}

struct comparison_pair comparison_of_two(const struct estimate *a, const struct estimate *b)
{
    const struct interval first = {.mean = a->mean, .s = a->s, .degrees = a->degrees},
                          second = {.mean = b->mean, .s = b->s, .degrees = b->degrees};
    struct ranking welch = ranking_welch(&first, &second, estimate_level);
    return (struct comparison_pair){ranking_verdict(welch.difference, welch.p, estimate_level), welch.ratio, welch.low,
                                    welch.high, welch.p};
}

/** Adjusts p over all pairs, and what follows from it. */
static enum status_code adjust(struct comparison_ranking *ranking, size_t pairs, struct status *status)
{
    double *p = malloc((pairs + 1) * sizeof *p);
    bool *apart = malloc((pairs + 1) * sizeof *apart);
    for (size_t k = 0; k < pairs && p; k++)
        p[k] = ranking->pairs[k].p;
    enum status_code rc = p && apart ? ranking_holm(p, p, pairs, status) : status_memory(status);
    for (size_t k = 0; k < pairs && rc == STATUS_OK; k++) {
        struct comparison_pair *pair = &ranking->pairs[k];
        pair->p = p[k];
        pair->verdict = ranking_verdict(log(pair->ratio), pair->p, estimate_level);
        apart[k] = comparison_told_apart(pair);
    }
    if (rc == STATUS_OK)
        rc = ranking_groups_make(&ranking->groups, apart, ranking->count, status);
    free(p);
    free(apart);
    return rc;
}

bool comparison_told_apart(const struct comparison_pair *pair)
{
    return pair->verdict != RANKING_NOT_TOLD_APART;
}

const struct comparison_pair *comparison_pair_of(const struct comparison_ranking *ranking, size_t i, size_t j)
{
    return &ranking->pairs[ranking_pair(i, j, ranking->count)];
}

/** What a surface is ranked by, less being better; NaN: it has no answer. */
static double cost_of(const struct comparison *of, const struct results *results, size_t surface)
{
    double value = comparison_middle(results, of->leading, surface).value[of->ranking.criterion];
    return (quantity_rows[of->ranking.criterion].is & QUANTITY_RISES) ? -value : value;
}

static const struct estimate *estimate_of(const struct comparison *of, const struct results *results, size_t surface)
{
    return curve_summary_estimate(surface_model(&results->surfaces[surface].summary, of->leading),
                                  of->ranking.criterion);
}

/** Ranks the surfaces that have an answer in the leading model at the middle load. */
static enum status_code rank(struct comparison *out, const struct results *results, struct status *status)
{
    struct comparison_ranking *ranking = &out->ranking;
    ranking->criterion = results_criterion(results);
    size_t surfaces = out->models[out->leading].extremes[ranking->criterion].count;
    if (surfaces == 0 || surfaces > COMPARISON_RANKED_MOST)
        return STATUS_OK;
    ranking->surface = malloc(surfaces * sizeof *ranking->surface);
    ranking->pairs = calloc(surfaces * surfaces, sizeof *ranking->pairs);
    if (!ranking->surface || !ranking->pairs)
        return status_memory(status);
    for (size_t i = 0; i < results->surface_count; i++) {
        double cost = cost_of(out, results, i);
        const struct estimate *estimate = estimate_of(out, results, i);
        if (isnan(cost) || estimate->count == 0 || isnan(estimate->half_width))
            continue;
        size_t at = ranking->count++;
        for (; at > 0 && cost < cost_of(out, results, ranking->surface[at - 1]); at--)
            ranking->surface[at] = ranking->surface[at - 1];
        ranking->surface[at] = i;
    }
    size_t pairs = 0; /* in the order of ranking_pair() */
    for (size_t i = 0; i < ranking->count; i++)
        for (size_t j = i + 1; j < ranking->count; j++)
            ranking->pairs[pairs++] = comparison_of_two(estimate_of(out, results, ranking->surface[i]),
                                                        estimate_of(out, results, ranking->surface[j]));
    return adjust(ranking, pairs, status);
}

enum status_code comparison_make(struct comparison *out, const struct results *results, struct status *status)
{
    *out = (struct comparison){.leading = plan_leading_model(results->plan)};
    if (allocate(out, results, status) != STATUS_OK)
        return status->code;
    const struct surface_record *previous = NULL;
    for (size_t k = 0; k < results->usable_count; k++) {
        const struct surface_record *record = &results->surfaces[results->by_roughness[k]];
        take_in(out, results, record, k, previous);
        previous = record;
    }
    return rank(out, results, status);
}

void comparison_free(struct comparison *comparison)
{
    free(comparison->gaps);
    free(comparison->steps);
    free(comparison->extents);
    free(comparison->models);
    free(comparison->ranking.surface);
    free(comparison->ranking.pairs);
    ranking_groups_free(&comparison->ranking.groups);
    *comparison = (struct comparison){0};
}
