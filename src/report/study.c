#include "report/study.h"

#include <math.h>

/** Points of two curves that stand at the same loads. */
static size_t common_points(const struct model_curve *a, const struct model_curve *b)
{
    size_t count = a->count < b->count ? a->count : b->count;
    while (count > 0 && a->points[count - 1].load != b->points[count - 1].load)
        count--; /* a statistical curve closes with a load of its own */
    return count;
}

/** Separation over sigma as the report compares it: adjusted for the statistical models. */
static double separation(const struct contact_point *point, enum model_id model, double sigma_m)
{
    return (model_rows[model].family == SCENE_MODEL_STATISTICAL ? point->adjusted_m : point->separation_m) / sigma_m;
}

static void compare_neighbours(struct study *study, const struct surface_record *smooth,
                               const struct surface_record *rough)
{
    for (int m = 0; m < MODEL_COUNT; m++) {
        const struct model_curve *a = &smooth->curves[m], *b = &rough->curves[m];
        struct study_rank *rank = &study->rank[m];
        size_t count = a->exists && b->exists ? common_points(a, b) : 0;
        for (size_t i = 0; i < count; i++) {
            const struct contact_point *p = &a->points[i], *q = &b->points[i];
            if (p->area_ratio == 1 && q->area_ratio == 1)
                continue; /* both full: nothing to rank */
            rank->pairs++;
            rank->area += p->area_ratio >= q->area_ratio;
            rank->separation += separation(p, (enum model_id)m, smooth->summary.asperities.sigma_m) <=
                                separation(q, (enum model_id)m, rough->summary.asperities.sigma_m);
            rank->ecr += p->ecr_ohm_m2 <= q->ecr_ohm_m2;
            rank->tcr += p->tcr_K_m2_per_W <= q->tcr_K_m2_per_W;
        }
    }
}

static void compare_laws(struct study_plastic *out, const struct model_curve *elastic,
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

static void check_proportion(struct study *study, const struct surface_record *record, const struct plan *plan)
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

/** Mean distance of the two families on the baseline surface, in decades. */
static void compare_families(struct study *study, const struct surface_record *record)
{
    bool plastic = record->curves[MODEL_JG].exists && record->curves[MODEL_MULTISCALE_PLASTIC].exists;
    const struct model_curve *a = &record->curves[plastic ? MODEL_MULTISCALE_PLASTIC : MODEL_MULTISCALE_ELASTIC];
    const struct model_curve *b = &record->curves[plastic ? MODEL_JG : MODEL_GW];
    size_t count = a->exists && b->exists ? common_points(a, b) : 0, used = 0;
    double area = 0, ecr = 0;
    for (size_t i = 0; i < count; i++) {
        const struct contact_point *p = &a->points[i], *q = &b->points[i];
        if (!(p->ecr_ohm_m2 > 0) || !(q->ecr_ohm_m2 > 0))
            continue;
        area += fabs(log10(p->area_ratio / q->area_ratio));
        ecr += fabs(log10(p->ecr_ohm_m2 / q->ecr_ohm_m2));
        used++;
    }
    if (used > 0) {
        study->area_gap = area / (double)used;
        study->ecr_gap = ecr / (double)used;
    }
}

/** Areas of the surfaces at the middle load, in one model. */
struct area_range {
    size_t surfaces;
    double least, most;
};

static void widen(struct area_range spreads[MODEL_COUNT], const struct surface_record *record, double load)
{
    for (int m = 0; m < MODEL_COUNT; m++)
        for (size_t i = 0; i < record->curves[m].count; i++)
            if (record->curves[m].points[i].load == load) {
                struct area_range *spread = &spreads[m];
                double area = record->curves[m].points[i].area_ratio;
                spread->least = spread->surfaces > 0 ? fmin(spread->least, area) : area;
                spread->most = fmax(spread->most, area);
                spread->surfaces++;
            }
}

enum status_code study_make(struct study *out, const struct results *results, struct status *status)
{
    struct area_range spreads[MODEL_COUNT] = {0};
    *out = (struct study){.proportional_error = NAN,
                          .area_gap = NAN,
                          .ecr_gap = NAN,
                          .middle_load = results->loads[results->load_count / 2]};
    struct surface_record previous = {0};
    for (size_t k = 0; k < results->usable_count; k++) {
        struct surface_record record;
        size_t index = results->by_roughness[k];
        if (spool_get(&record, results->spool, index, status) != STATUS_OK) {
            surface_record_free(&previous, false);
            return status->code;
        }
        if (k > 0)
            compare_neighbours(out, &previous, &record);
        compare_laws(&out->plastic[0], &record.curves[MODEL_MULTISCALE_ELASTIC],
                     &record.curves[MODEL_MULTISCALE_PLASTIC]);
        compare_laws(&out->plastic[1], &record.curves[MODEL_GW], &record.curves[MODEL_JG]);
        check_proportion(out, &record, results->plan);
        widen(spreads, &record, out->middle_load);
        if (index == results->baseline)
            compare_families(out, &record);
        surface_record_free(&previous, false);
        previous = record;
    }
    surface_record_free(&previous, false);
    for (int m = 0; m < MODEL_COUNT; m++)
        out->area_spread[m] = spreads[m].surfaces > 1 ? spreads[m].most / spreads[m].least : NAN;
    return STATUS_OK;
}
