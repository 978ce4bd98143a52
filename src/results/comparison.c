#include "results/comparison.h"

#include <math.h>
#include <stdlib.h>

/** Points of two curves that stand at the same loads. */
static size_t common_points(const struct model_curve *a, const struct model_curve *b)
{
    size_t count = a->count < b->count ? a->count : b->count;
    while (count > 0 && a->points[count - 1].load != b->points[count - 1].load)
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

static void compare_neighbours(struct comparison *out, const struct surface_record *smooth,
                               const struct surface_record *rough)
{
    for (size_t m = 0; m < model_count; m++) {
        const struct model_curve *a = &smooth->curves[m], *b = &rough->curves[m];
        struct comparison_rank *rank = &out->models[m].rank;
        size_t count = a->exists && b->exists ? common_points(a, b) : 0;
        for (size_t i = 0; i < count; i++) {
            const struct contact_point *p = &a->points[i], *q = &b->points[i];
            if (p->area_ratio == 1 && q->area_ratio == 1)
                continue; /* both full: nothing to rank */
            rank->pairs++;
            for (int k = 0; k < QUANTITY_COUNT; k++) {
                double x = comparison_value(p, (enum quantity)k, m, smooth->summary.asperities.sigma_m);
                double y = comparison_value(q, (enum quantity)k, m, rough->summary.asperities.sigma_m);
                rank->ranked[k] += k == QUANTITY_AREA ? x >= y : x <= y;
            }
        }
    }
}

static void compare_laws(struct comparison_plastic *out, const struct model_curve *elastic,
                         const struct model_curve *plastic)
{
    if (!elastic->exists || !plastic->exists)
        return;
    size_t count = common_points(elastic, plastic);
    for (size_t i = 0; i < count; i++) {
        double ratio = plastic->points[i].area_ratio / elastic->points[i].area_ratio;
        out->least = out->points > 0 ? fmin(out->least, ratio) : ratio;
        out->most = fmax(out->most, ratio);
        out->above += ratio >= 1 - 1e-12;
        out->points++;
    }
    out->surfaces++;
    out->sooner += plastic->full_load < elastic->full_load;
}

static void check_proportion(struct comparison *out, const struct surface_record *record, const struct plan *plan)
{
    double product = plan->pair.resistivity_ohm_m * plan->pair.conductivity_W_per_mK;
    for (size_t m = 0; m < model_count; m++)
        for (size_t i = 0; i < record->curves[m].count; i++) {
            const struct contact_point *point = &record->curves[m].points[i];
            if (!(point->ecr_ohm_m2 > 0) || !(point->tcr_K_m2_per_W > 0))
                continue;
            double error = fabs(point->tcr_K_m2_per_W / point->ecr_ohm_m2 * product - 1);
            out->proportional_error = fmax(error, isnan(out->proportional_error) ? 0 : out->proportional_error);
        }
}

/** Mean distance of a multiscale and a statistical curve, in decades. */
static struct comparison_gap gap_between(const struct model_curve *a, const struct model_curve *b)
{
    size_t count = a->exists && b->exists ? common_points(a, b) : 0, used = 0;
    struct comparison_gap gap = {0, 0};
    for (size_t i = 0; i < count; i++) {
        const struct contact_point *p = &a->points[i], *q = &b->points[i];
        if (!(p->ecr_ohm_m2 > 0) || !(q->ecr_ohm_m2 > 0))
            continue;
        gap.area += fabs(log10(p->area_ratio / q->area_ratio));
        gap.ecr += fabs(log10(p->ecr_ohm_m2 / q->ecr_ohm_m2));
        used++;
    }
    return used > 0 ? (struct comparison_gap){gap.area / (double)used, gap.ecr / (double)used}
                    : (struct comparison_gap){NAN, NAN};
}

/** Takes the surface's values at the middle load. */
static void note_middle(struct comparison *out, const struct surface_record *record, size_t index)
{
    for (size_t m = 0; m < model_count; m++)
        for (size_t i = 0; i < record->curves[m].count; i++) {
            const struct contact_point *point = &record->curves[m].points[i];
            if (point->load != out->middle_load)
                continue;
            if (m == out->leading)
                out->middle[index] = *point;
            for (int q = 0; q < QUANTITY_COUNT; q++) {
                struct comparison_extremes *extremes = &out->models[m].extremes[q];
                double value = comparison_value(point, (enum quantity)q, m, record->summary.asperities.sigma_m);
                if (isnan(value))
                    continue;
                if (extremes->count == 0 || value < extremes->least) {
                    extremes->least = value;
                    extremes->least_at = index;
                }
                if (extremes->count == 0 || value > extremes->most) {
                    extremes->most = value;
                    extremes->most_at = index;
                }
                extremes->count++;
            }
            break;
        }
}

static size_t leading_model(const struct plan *plan)
{
    size_t leading = 0;
    int most = -1;
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(plan, m) && model_rows[m]->precedence > most) {
            most = model_rows[m]->precedence;
            leading = m;
        }
    return leading;
}

/** What one surface adds; `previous` is the next smoother one, NULL for the first. */
static void take_in(struct comparison *out, const struct results *results, const struct surface_record *record,
                    size_t index, const struct surface_record *previous)
{
    const struct model_curve *curves = record->curves;
    if (previous)
        compare_neighbours(out, previous, record);
    for (size_t m = 0; m < model_count; m++) {
        size_t elastic = model_index(model_rows[m]->elastic), counterpart = model_index(model_rows[m]->counterpart);
        if (elastic < model_count)
            compare_laws(&out->models[m].plastic, &curves[elastic], &curves[m]);
        if (counterpart < model_count && index == results->baseline)
            out->models[m].gap = gap_between(&curves[counterpart], &curves[m]);
    }
    check_proportion(out, record, results->plan);
    note_middle(out, record, index);
}

enum status_code comparison_make(struct comparison *out, const struct results *results, struct status *status)
{
    *out = (struct comparison){.proportional_error = NAN,
                               .middle_load = results->loads[results->load_count / 2],
                               .leading = leading_model(results->plan),
                               .models = calloc(model_count, sizeof *out->models),
                               .middle = malloc(results->store->count * sizeof *out->middle)};
    if (!out->middle || !out->models)
        return status_memory(status);
    for (size_t m = 0; m < model_count; m++)
        out->models[m].gap = (struct comparison_gap){NAN, NAN};
    for (size_t i = 0; i < results->store->count; i++)
        out->middle[i] = (struct contact_point){.load = NAN};
    struct surface_record previous = {0};
    for (size_t k = 0; k < results->usable_count; k++) {
        struct surface_record record;
        size_t index = results->by_roughness[k];
        if (surface_store_get(&record, results->store, index, status) != STATUS_OK) {
            surface_record_free(&previous, false);
            return status->code;
        }
        take_in(out, results, &record, index, k > 0 ? &previous : NULL);
        surface_record_free(&previous, false);
        previous = record;
    }
    surface_record_free(&previous, false);
    return STATUS_OK;
}

void comparison_free(struct comparison *comparison)
{
    free(comparison->middle);
    free(comparison->models);
    *comparison = (struct comparison){0};
}
