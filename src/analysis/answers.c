/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/answers.h"

#include "analysis/landmarks.h"
#include "analysis/surface.h"
#include "base/clock.h"
#include "joint/joint.h"
#include <math.h>
#include <stdlib.h>

const double answers_least_spots = 10;

static const struct ensemble alone; /* one scan */
static const struct answer no_answer = {.load = NAN, .low = NAN, .high = NAN, .spots_per_m2 = NAN};

/** Share by which a number may miss its target where the curve ends without a full contact. */
static const double end_slack = 0.01;

static const struct contact_point *point_at(const struct model_curve *curve, double load)
{
    for (size_t i = 0; i < curve->count; i++)
        if (curve->points[i].value[QUANTITY_LOAD] == load)
            return &curve->points[i];
    return NULL;
}

/** `point` NULL: contact is full. */
static bool is_invalid(const struct contact_point *point, const struct model_row *row)
{
    double area = point ? point->value[QUANTITY_AREA] : 1;
    return (row->largest_area > 0 && area > row->largest_area) ||
           (point && point->beyond_fit > curve_summary_beyond_fit_share);
}

/** What a quantity is where contact is full: there is no resistance left but the film's. */
static double full_value(enum quantity quantity, const struct joint_task *joint)
{
    struct contact_point point = quantity_nothing();
    point.value[QUANTITY_AREA] = 1;
    point.value[QUANTITY_SEPARATION] = point.value[QUANTITY_ECR] = point.value[QUANTITY_TCR] =
        point.value[QUANTITY_TCR_SCALE_DEPENDENT] = 0;
    if (quantity == QUANTITY_JOINT)
        return INFINITY;
    joint_apply(&point, NULL, 1, joint);
    return point.value[quantity];
}

/** Is what lies between two loads, of which nothing is known at the upper one, the target? It is where the contact
 * becomes complete, or where the curve's end is the target to within a hundredth. */
static bool ends_there(const struct model_curve *curve, const struct contact_point *before,
                       const struct contact_point *after, const struct scene_asked *target, bool full_meets)
{
    if (!after && curve->exists && isfinite(curve->full_load))
        return full_meets;
    double value = before ? before->value[target->row->quantity] : NAN;
    return fabs(log(value / target->value)) < end_slack;
}

/** Does an elastic contact bear more than the hardness? */
static bool is_above_hardness(const struct contact_point *point, double load, const struct model_row *row,
                              const struct model_task *task)
{
    double area = point ? point->value[QUANTITY_AREA] : 1;
    return !row->plastic && material_pair_pressure(task->pair, load) > task->hardness_Pa * area;
}

/** One end of the band about a curve. */
struct band_end {
    const struct model_curve *curve;
    const struct ensemble_band *band;
    size_t count;
    enum quantity quantity;
    int side;
    const struct joint_task *joint; /* NULL: the quantity is the model's own */
    int resistance_side;            /* of the band of the resistances that it is made of */
};

/** A number of the joint with these ECR and TCR (NaN: the model's), area and gap as they are. */
static double made_with(const struct contact_point *point, const double resistance[2], enum quantity quantity,
                        const struct joint_task *joint)
{
    struct contact_point at = *point;
    at.value[QUANTITY_ECR] = isnan(resistance[0]) ? at.value[QUANTITY_ECR] : resistance[0];
    at.value[QUANTITY_TCR] = isnan(resistance[1]) ? at.value[QUANTITY_TCR] : resistance[1];
    joint_apply(&at, NULL, 1, joint);
    return at.value[quantity];
}

/** The number at one end of the band at load i. */
static double at_end(const struct band_end *end, size_t i)
{
    const struct ensemble_band *band = &end->band[i];
    if (!end->joint)
        return band->mean[end->quantity][end->side];
    const double resistance[2] = {band->mean[QUANTITY_ECR][end->resistance_side],
                                  band->mean[QUANTITY_TCR][end->resistance_side]};
    bool known = !isnan(resistance[quantity_rows[end->quantity].from & QUANTITY_BIT(QUANTITY_ECR) ? 0 : 1]);
    return known ? made_with(&end->curve->points[i], resistance, end->quantity, end->joint) : NAN;
}

/** ln of the end over the curve, straight in ln P between the loads that have it; at the ends that of the last one. */
static double band_shift(double ln_load, const void *context)
{
    const struct band_end *end = context;
    double before = NAN, ln_before = NAN;
    for (size_t i = 0; i < end->count && i < end->curve->count; i++) {
        double value = end->curve->points[i].value[end->quantity], ln_own = log(end->band[i].load);
        double shift = log(at_end(end, i) / value);
        if (end->curve->points[i].value[QUANTITY_LOAD] != end->band[i].load || !isfinite(shift))
            continue;
        if (ln_own >= ln_load)
            return isnan(before) ? shift : before + (shift - before) * (ln_load - ln_before) / (ln_own - ln_before);
        before = shift;
        ln_before = ln_own;
    }
    return before;
}

/** The curve that is searched, with what lies in the joint. */
struct search {
    struct landmarks_model model;
    struct joint_task joint;
};

static enum status_code run_search(struct model_curve *out, const double *loads, size_t count, void *context,
                                   struct status *status)
{
    struct search *search = context;
    const struct model_task task = model_task_at(&search->model.task, loads, count);
    if (landmarks_run_model(out, loads, count, &search->model, status) != STATUS_OK)
        return status->code;
    return joint_curve(out, search->model.row, &task, &search->joint, status);
}

/** A target on one curve: of one scan, or the mean of several; or on an end of its band (NULL: the curve itself). */
static enum status_code solve(struct answer *out, struct search *search, const struct scene_asked *target,
                              const struct band_end *end, struct status *status)
{
    const struct landmarks_value value = {target->row->quantity, target->value, target->row->rises,
                                          end ? band_shift : NULL, end};
    const struct landmarks_curve searched = {run_search, search, search->model.task.tolerance};
    const double first = search->model.task.loads[0],
                 last = search->model.task.loads[search->model.task.load_count - 1];
    struct contact_point points[3];
    struct model_curve curve = {.points = points};
    double ends[2] = {first, last};
    bool found;
    *out = no_answer;
    if (landmarks_find(ends, &found, &value, &searched, status) != STATUS_OK)
        return status->code;
    size_t count = found && ends[1] > ends[0] ? 2 : 1; /* else the list has one load */
    const double *loads = found ? ends : &last;
    if (run_search(&curve, loads, count, search, status) != STATUS_OK)
        return status->code;
    const struct contact_point *after = point_at(&curve, loads[count - 1]), *before = point_at(&curve, loads[0]);
    double there = after ? after->value[value.quantity] : NAN;
    bool passed = found || (first == last && (value.rises ? there >= value.value : there <= value.value));
    double full = full_value(value.quantity, &search->joint);
    bool full_meets = value.rises ? full >= value.value : full <= value.value;
    bool closes = curve.exists && curve.full_load <= last;
    out->load = loads[count - 1];
    bool lightest = out->load == first;
    if (!passed) {
        out->kind = isnan(there) ? ANSWER_NONE : ANSWER_NOT_REACHED;
    } else if (!isnan(there) || ends_there(&curve, lightest ? NULL : before, after, target, full_meets)) {
        out->kind = lightest ? ANSWER_LIGHTEST : ANSWER_LOAD;
    } else if (closes && full_meets) {
        out->full = curve.full_load > first;
        out->kind = out->full ? ANSWER_LOAD : ANSWER_LIGHTEST;
        out->load = fmax(curve.full_load, first);
        after = NULL;
    } else {
        out->kind = lightest && !closes ? ANSWER_NONE : ANSWER_NOT_REACHED;
        out->load = closes ? last : ends[0];
        after = closes ? NULL : before;
    }
    out->invalid = is_invalid(after, search->model.row);
    out->above_hardness = is_above_hardness(after, out->load, search->model.row, &search->model.task);
    return STATUS_OK;
}

/** The model that counts the spots of an answer of model `m`: itself, else the running one of the greatest precedence
 * that counts them, is valid there, and is not elastic where `m` is plastic; model_count: none. */
static size_t counting_model(const struct surface_record *record, const struct plan *plan, size_t m, double load)
{
    size_t found = model_count;
    for (size_t k = 0; k < model_count && !model_rows[m]->spots; k++) {
        const struct curve_summary *model = surface_model(&record->summary, k);
        if (plan_runs_model(plan, k) && model_rows[k]->spots && (model_rows[k]->plastic || !model_rows[m]->plastic) &&
            model->exists && curve_summary_is_valid(model, load) &&
            (found == model_count || model_rows[k]->precedence > model_rows[found]->precedence))
            found = k;
    }
    return model_rows[m]->spots ? m : found;
}

/** The spots at the answer's load; of several scans, their mean. */
static enum status_code count_spots(struct answer *out, const struct ensemble *set, size_t by,
                                    const struct model_task *task, struct status *status)
{
    const struct model_row *row = model_rows[by];
    struct model_task one = model_task_at(task, &out->load, 1);
    size_t runs = set->count > 1 ? set->count : 1, counted = 0;
    double sum = 0;
    for (size_t r = 0; r < runs; r++) {
        struct contact_spots spots = {NAN, NAN};
        struct asperities asperities;
        struct model_task own = runs > 1 ? member_task(&asperities, &set->members[r], &one) : one;
        if (row->spots(&spots, row, &own, status) != STATUS_OK)
            return status->code;
        if (isnan(spots.density_per_m2))
            continue;
        sum += spots.density_per_m2;
        counted++;
    }
    out->spots_per_m2 = sum / (double)counted; /* none: NaN */
    out->counted_by = by;
    return STATUS_OK;
}

/** A target on every scan alone. The answer has no load where some of them does not meet it between the loads. */
static enum status_code solve_runs(struct answer *out, const struct search *search, const struct scene_asked *target,
                                   struct status *status)
{
    const struct landmarks_model *model = &search->model;
    const struct ensemble *set = model->set;
    size_t all = set->count, invalid = 0, above = 0;
    double *load = malloc(all * sizeof *load);
    size_t *scan = malloc(all * sizeof *scan), count = 0;
    enum status_code rc = load && scan ? STATUS_OK : status_memory(status);
    *out = no_answer;
    for (size_t r = 0; r < all && rc == STATUS_OK; r++) {
        struct asperities asperities;
        struct answer one;
        struct search run = *search;
        run.model.task = member_task(&asperities, &set->members[r], &model->task);
        run.model.set = &alone;
        rc = solve(&one, &run, target, NULL, status);
        if (rc != STATUS_OK || one.kind == ANSWER_NONE)
            continue; /* on which the model has no solution: its curve is of the others too */
        out->runs++;
        out->unsolved += one.kind != ANSWER_LOAD;
        invalid += one.invalid;
        above += one.above_hardness;
        out->full = out->full || one.full;
        scan[count] = set->members[r].scan;
        load[count++] = one.load;
    }
    if (rc == STATUS_OK && out->runs > 0 && out->unsolved == 0) {
        struct estimate estimate;
        rc = ensemble_estimate(&estimate, set, load, scan, count, true, status);
        out->kind = ANSWER_LOAD;
        out->load = estimate_value(&estimate);
        out->low = out->full ? NAN : estimate_end(&estimate, 0);
        out->high = out->full ? NAN : estimate_end(&estimate, 1);
        out->invalid = 2 * invalid >= out->runs;
        out->above_hardness = 2 * above >= out->runs;
    }
    free(load);
    free(scan);
    return rc;
}

/** The loads at which the ends of the band of one scan pass the target. */
static enum status_code solve_band(struct answer *out, const struct surface_record *record, struct search *search,
                                   const struct scene_asked *target, struct status *status)
{
    size_t m = model_index(search->model.row);
    for (int side = 0; side < 2; side++) {
        const bool made = quantity_rows[target->row->quantity].from;
        const struct band_end end = {&record->curves[m],
                                     record->bands[m],
                                     record->band_count,
                                     target->row->quantity,
                                     side,
                                     made ? &search->joint : NULL,
                                     target->row->rises ? !side : side};
        bool sooner = side == target->row->rises; /* that end gets there at the lighter load */
        struct answer one;
        if (isnan(band_shift(log(out->load), &end)))
            return STATUS_OK;
        if (solve(&one, search, target, &end, status) != STATUS_OK)
            return status->code;
        double load = one.kind == ANSWER_LOAD && !one.full ? one.load : NAN;
        if (sooner)
            out->low = isnan(load) ? NAN : fmin(load, out->load);
        else
            out->high = isnan(load) ? NAN : fmax(load, out->load);
    }
    return STATUS_OK;
}

static enum status_code answer_target(struct answer *out, const struct surface_record *record, size_t m,
                                      const struct scene_asked *target, const struct model_task *task,
                                      const struct joint_task *joint, struct status *status)
{
    const struct model_row *row = model_rows[m];
    const unsigned from = quantity_rows[target->row->quantity].from,
                   needed = from ? from : QUANTITY_BIT(target->row->quantity),
                   quantities = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | needed;
    struct search search = {{row, *task, quantities, &record->ensemble}, *joint};
    /* a model that says how far off it may be has more in its band than the scans' scatter */
    bool several = record->ensemble.count > 1 && model_sd(row, QUANTITY_ECR) == 0;
    *out = no_answer;
    search.joint.effects = from ? joint->effects : 0;
    search.model.task.wanted &= quantities;
    if (!record->curves[m].exists || (row->quantities & task->wanted & needed) != needed)
        return STATUS_OK;
    if (several && solve_runs(out, &search, target, status) != STATUS_OK)
        return status->code;
    if (several && out->kind == ANSWER_LOAD)
        return STATUS_OK;
    size_t runs = out->runs, unsolved = out->unsolved;
    if (solve(out, &search, target, NULL, status) != STATUS_OK)
        return status->code;
    out->runs = runs;
    out->unsolved = unsolved;
    bool banded = !several && record->bands[m] && out->kind == ANSWER_LOAD && !out->full;
    return banded ? solve_band(out, record, &search, target, status) : STATUS_OK;
}

enum limit_verdict answers_judge(const struct limit_check *check, const struct scene_asked *limit)
{
    if (isnan(check->value))
        return LIMIT_NO_VALUE;
    bool known = !isnan(check->low) && !isnan(check->high);
    double low = known ? check->low : check->value, high = known ? check->high : check->value;
    if (limit->is_upper ? high <= limit->value : low >= limit->value)
        return LIMIT_MET;
    return (limit->is_upper ? low > limit->value : high < limit->value) ? LIMIT_MISSED : LIMIT_CANNOT_TELL;
}

/** The leading model at load i of its curve against a limit, with its band. */
static struct limit_check check_point(const struct surface_record *record, size_t leading,
                                      const struct scene_asked *limit, const struct joint_task *joint, size_t i)
{
    const struct model_curve *curve = &record->curves[leading];
    const struct ensemble_band *band = record->bands[leading];
    enum quantity quantity = limit->row->quantity;
    struct limit_check out = {.value = curve->points[i].value[quantity], .low = NAN, .high = NAN};
    if (band && i < record->band_count && band[i].load == curve->points[i].value[QUANTITY_LOAD]) {
        double ends[2];
        for (int side = 0; side < 2; side++) {
            const struct band_end end = {
                curve, band, record->band_count, quantity, side, quantity_rows[quantity].from ? joint : NULL, side};
            ends[side] = at_end(&end, i);
        }
        out.low = fmin(ends[0], ends[1]);
        out.high = fmax(ends[0], ends[1]);
    }
    out.verdict = answers_judge(&out, limit);
    return out;
}

/** Where the model has no number at the load, it may be full contact, or what was met or missed for good below it. */
static struct limit_check check_limit(const struct surface_record *record, size_t leading,
                                      const struct scene_asked *limit, const struct joint_task *joint, double load)
{
    const struct model_curve *curve = &record->curves[leading];
    struct limit_check out = {.value = NAN, .low = NAN, .high = NAN};
    size_t below = 0;
    while (curve->exists && below < curve->count && curve->points[below].value[QUANTITY_LOAD] < load)
        below++;
    if (curve->exists && below < curve->count && curve->points[below].value[QUANTITY_LOAD] == load)
        out = check_point(record, leading, limit, joint, below);
    if (out.verdict == LIMIT_NO_VALUE && curve->exists && curve->full_load <= load) {
        out.value = full_value(limit->row->quantity, joint);
        out.verdict = answers_judge(&out, limit);
        out.value = isfinite(out.value) ? out.value : NAN;
    }
    const enum limit_verdict lasting = limit->is_upper == limit->row->rises ? LIMIT_MISSED : LIMIT_MET;
    for (size_t i = 0; i < below && out.verdict == LIMIT_NO_VALUE; i++)
        if (check_point(record, leading, limit, joint, i).verdict == lasting)
            out.verdict = lasting;
    return out;
}

enum status_code answers_find(struct surface_record *record, const struct scene *scene, const struct plan *plan,
                              const struct model_task *task, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    const struct joint_task joint = surface_joint(record, scene, plan, task);
    if (scene->target_count > 0 &&
        !(summary->answers = calloc(scene->target_count * model_count, sizeof *summary->answers)))
        return status_memory(status);
    if (scene->limit_count > 0 && !(summary->limits = calloc(scene->limit_count, sizeof *summary->limits)))
        return status_memory(status);
    for (size_t i = 0; i < scene->target_count * model_count; i++)
        summary->answers[i] = no_answer;
    for (size_t m = 0; m < model_count && scene->target_count > 0; m++) {
        double started = clock_seconds();
        if (!plan_runs_model(plan, m))
            continue;
        struct curve_summary *model = surface_model_room(summary, m);
        if (!model)
            return status_memory(status);
        struct model_task own = *task;
        own.evaluations = &model->evaluations;
        for (size_t t = 0; t < scene->target_count; t++) {
            struct answer *answer = &summary->answers[t * model_count + m];
            if (answer_target(answer, record, m, &scene->targets[t], &own, &joint, status) != STATUS_OK)
                return status->code;
            bool met = (answer->kind == ANSWER_LOAD || answer->kind == ANSWER_LIGHTEST) && !answer->full;
            size_t by = met ? counting_model(record, plan, m, answer->load) : model_count;
            if (by < model_count && count_spots(answer, &record->ensemble, by, &own, status) != STATUS_OK)
                return status->code;
        }
        model->seconds += clock_seconds() - started;
    }
    for (size_t l = 0; l < scene->limit_count; l++)
        summary->limits[l] = check_limit(record, plan_leading_model(plan), &scene->limits[l], &joint,
                                         task->loads[model_task_operating(task)]);
    return STATUS_OK;
}

double answers_spots(const struct answer *answer, double nominal_area_m2)
{
    return answer->spots_per_m2 * nominal_area_m2;
}

void answers_note(struct text *out, const struct answer *answer, double nominal_area_m2, double load_scale,
                  const char *load_unit)
{
    const char *before = "";
    double spots = answers_spots(answer, nominal_area_m2);
    if (answer->kind == ANSWER_NONE)
        text_add(out, "no value");
    if (answer->kind == ANSWER_LIGHTEST)
        text_add(out, "already at the lightest load");
    if (answer->kind == ANSWER_NOT_REACHED)
        text_add(out, "not reached up to %s%.3g%s%s", *load_unit ? "" : "P/(A_n E') = ", answer->load * load_scale,
                 *load_unit ? " " : "", load_unit);
    if (answer->full)
        text_add(out, "at full contact at the latest");
    before = answer->kind == ANSWER_LOAD && !answer->full ? "" : "; ";
    if (answer->unsolved > 0) {
        text_add(out, "%sno interval: %zu of %zu scans do not meet it between the loads", before, answer->unsolved,
                 answer->runs);
        before = "; ";
    }
    if (answer->invalid && answer->kind != ANSWER_NONE) {
        text_add(out, "%sbeyond the model's validity", before);
        before = "; ";
    }
    if (answer->above_hardness && answer->kind != ANSWER_NONE) {
        text_add(out, "%sabove the hardness", before);
        before = "; ";
    }
    if (spots < answers_least_spots)
        text_add(out, "%stoo few spots for statistics (%.2g)", before, spots);
}
