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

double comparison_value(const struct contact_point *point, enum comparison_quantity quantity, enum model_id model,
                        double sigma_m)
{
    bool adjusted = model_rows[model].family == SCENE_MODEL_STATISTICAL;
    switch (quantity) {
    case COMPARISON_AREA:
        return point->area_ratio;
    case COMPARISON_SEPARATION:
        return (adjusted ? point->adjusted_m : point->separation_m) / sigma_m;
    case COMPARISON_ECR:
        return point->ecr_ohm_m2;
    case COMPARISON_TCR:
        return point->tcr_K_m2_per_W;
    case COMPARISON_QUANTITY_COUNT:
        break;
    }
    return NAN;
}

bool comparison_converges(const struct results *results, enum convergence_sweep sweep, bool plastic, size_t value)
{
    size_t scales = results->scene->convergence.scales;
    const double *area = results_sweep(results, sweep, plastic, value);
    return scales < 2 || area[scales - 1] >= 0.999 * area[scales / 2 - 1];
}

static void compare_neighbours(struct comparison *study, const struct surface_record *smooth,
                               const struct surface_record *rough)
{
    for (int m = 0; m < MODEL_COUNT; m++) {
        const struct model_curve *a = &smooth->curves[m], *b = &rough->curves[m];
        struct comparison_rank *rank = &study->rank[m];
        size_t count = a->exists && b->exists ? common_points(a, b) : 0;
        for (size_t i = 0; i < count; i++) {
            const struct contact_point *p = &a->points[i], *q = &b->points[i];
            if (p->area_ratio == 1 && q->area_ratio == 1)
                continue; /* both full: nothing to rank */
            rank->pairs++;
            rank->area += p->area_ratio >= q->area_ratio;
            rank->separation +=
                comparison_value(p, COMPARISON_SEPARATION, (enum model_id)m, smooth->summary.asperities.sigma_m) <=
                comparison_value(q, COMPARISON_SEPARATION, (enum model_id)m, rough->summary.asperities.sigma_m);
            rank->ecr += p->ecr_ohm_m2 <= q->ecr_ohm_m2;
            rank->tcr += p->tcr_K_m2_per_W <= q->tcr_K_m2_per_W;
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

static void check_proportion(struct comparison *study, const struct surface_record *record, const struct plan *plan)
{
    double product = plan->pair.resistivity_ohm_m * plan->pair.conductivity_W_per_mK;
    for (int m = 0; m < MODEL_COUNT; m++)
        for (size_t i = 0; i < record->curves[m].count; i++) {
            const struct contact_point *point = &record->curves[m].points[i];
            if (!(point->ecr_ohm_m2 > 0) || !(point->tcr_K_m2_per_W > 0))
                continue;
            double error = fabs(point->tcr_K_m2_per_W / point->ecr_ohm_m2 * product - 1);
            study->proportional_error = fmax(error, isnan(study->proportional_error) ? 0 : study->proportional_error);
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
static void note_middle(struct comparison *study, const struct surface_record *record, size_t index)
{
    for (int m = 0; m < MODEL_COUNT; m++)
        for (size_t i = 0; i < record->curves[m].count; i++) {
            const struct contact_point *point = &record->curves[m].points[i];
            if (point->load != study->middle_load)
                continue;
            if (m == (int)study->leading)
                study->middle[index] = *point;
            for (int q = 0; q < COMPARISON_QUANTITY_COUNT; q++) {
                struct comparison_extremes *extremes = &study->extremes[m][q];
                double value = comparison_value(point, (enum comparison_quantity)q, (enum model_id)m,
                                                record->summary.asperities.sigma_m);
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

/** The first plastic model that ran, else the first that ran. */
static enum model_id leading_model(const struct plan *plan)
{
    static const enum model_id order[] = {MODEL_MULTISCALE_PLASTIC, MODEL_MULTISCALE_ELASTIC, MODEL_JG};
    for (size_t i = 0; i < sizeof order / sizeof order[0]; i++)
        if (model_called_for(order[i], plan->families, plan->running))
            return order[i];
    return MODEL_GW;
}

/** What one surface adds; `previous` is the next smoother one, NULL for the first. */
static void take_in(struct comparison *study, const struct results *results, const struct surface_record *record,
                    size_t index, const struct surface_record *previous)
{
    const struct model_curve *curves = record->curves;
    if (previous)
        compare_neighbours(study, previous, record);
    compare_laws(&study->plastic[0], &curves[MODEL_MULTISCALE_ELASTIC], &curves[MODEL_MULTISCALE_PLASTIC]);
    compare_laws(&study->plastic[1], &curves[MODEL_GW], &curves[MODEL_JG]);
    check_proportion(study, record, results->plan);
    note_middle(study, record, index);
    if (index == results->baseline) {
        study->gap[0] = gap_between(&curves[MODEL_MULTISCALE_ELASTIC], &curves[MODEL_GW]);
        study->gap[1] = gap_between(&curves[MODEL_MULTISCALE_PLASTIC], &curves[MODEL_JG]);
    }
}

enum status_code comparison_make(struct comparison *out, const struct results *results, struct status *status)
{
    *out = (struct comparison){.proportional_error = NAN,
                               .gap = {{NAN, NAN}, {NAN, NAN}},
                               .middle_load = results->loads[results->load_count / 2],
                               .leading = leading_model(results->plan),
                               .middle = malloc(results->store->count * sizeof *out->middle)};
    if (!out->middle)
        return status_memory(status);
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

void comparison_free(struct comparison *study)
{
    free(study->middle);
    study->middle = NULL;
}
