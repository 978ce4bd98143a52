/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answers/answers.h"

#include "answers/measured.h"
#include "base/clock.h"
#include "joint/heating.h"
#include "joint/joint.h"
#include "members/surface.h"
#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>
#include <math.h>
#include <stdlib.h>

const double answers_least_spots = 10;

static const struct answer no_answer = {.load = NAN, .low = NAN, .high = NAN, .spots_per_m2 = NAN};

/** Relative distance at which a target counts as met where a curve ends before full contact. */
static const double end_slack = 0.01;

/** Does the quantity rise with the load? */
static bool rises(const struct scene_asked *asked)
{
    return quantity_rows[asked->quantity].is & QUANTITY_RISES;
}

/** The value at full contact, where only a film's resistance is left. */
static double full_value(enum quantity quantity, const struct joint_task *joint)
{
    struct contact_point point = quantity_nothing();
    for (int q = 0; q < QUANTITY_COUNT; q++)
        point.value[q] = quantity_rows[q].from ? NAN : quantity_rows[q].at_full;
    joint_apply(&point, NULL, 1, joint, NULL);
    return isinf(quantity_rows[quantity].at_full) ? INFINITY : point.value[quantity];
}

/** The value at a point; infinite for a resistance through metals that do not touch. */
static double value_at(const struct contact_point *point, enum quantity quantity)
{
    bool apart = quantity_rows[quantity].from & QUANTITY_BIT(QUANTITY_ECR) && isinf(point->value[QUANTITY_ECR]);
    return apart && (quantity_rows[quantity].is & QUANTITY_ENDS) ? INFINITY : point->value[quantity];
}

/** The same within what physics allows. */
static double value_within(const struct contact_point *point, enum quantity quantity, const struct model_row *row,
                           const struct joint_task *joint)
{
    double bound[QUANTITY_COUNT][2];
    joint_bounds(bound, point, row, joint);
    return estimate_within(value_at(point, quantity), bound[quantity]);
}

/** The lower or upper end of the band about a curve. */
struct band_end {
    const struct model_curve *curve;
    const struct ensemble_band *band;
    size_t count;
    enum quantity quantity;
    int side;
    const struct joint_task *joint;
};

/** The end of the band at load i. For a temperature it follows from that of the voltage. */
static double at_end(const struct band_end *end, size_t i)
{
    const double(*mean)[2] = (const double(*)[2])end->band[i].mean;
    return end->quantity == QUANTITY_TEMPERATURE ? joint_temperature(end->joint, mean[QUANTITY_VOLTAGE][end->side])
                                                 : mean[end->quantity][end->side];
}

/** ln of band end over curve: linear in ln P between the loads that have one, constant beyond them. */
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

/** The search for a target on a surface's curve, or on an end of its band. */
struct search {
    const struct model_row *row;
    struct model_task task; /* the search is between its first and its last load */
    const struct ensemble *set;
    struct joint_task joint;
    const struct scene_asked *target;
    const struct model_curve *known; /* the curve, where it is already computed */
    const struct band_end *end;      /* NULL: the curve itself */
    struct contact_point point;      /* at the load of the last run_at(); nothing if the curve has no point there */
    bool asks_wider, carried;        /* carried: the curve is multiplied by a measured factor */
    double value, full_load;         /* NaN: none there */
    struct status *status;
};

/** The value at the search's point: of the curve within what physics allows, but where a measured factor is carried. */
static double found_value(const struct search *search)
{
    const enum quantity quantity = search->target->quantity;
    return search->end || search->carried ? value_at(&search->point, quantity)
                                          : value_within(&search->point, quantity, search->row, &search->joint);
}

/** Looks up a load on the known curve, to rounding. */
static bool look_up(struct search *search, double load)
{
    const struct model_curve *known = search->known;
    size_t i = 0;
    while (i < known->count && known->points[i].value[QUANTITY_LOAD] < load * (1 - 1e-14))
        i++;
    if (i == known->count || known->points[i].value[QUANTITY_LOAD] > load * (1 + 1e-14))
        return false;
    const bool ends = joint_is_held(&known->points[i], &search->joint) || !model_curve_bears(known, known->full_load);
    search->full_load = ends ? NAN : known->full_load;
    search->point = known->points[i];
    search->value = found_value(search);
    return true;
}

/** First point of the known curve whose gap the bond line fixes; all heavier loads are the same. NULL: none. */
static const struct contact_point *first_held(const struct search *search)
{
    for (size_t i = 0; i < search->known->count; i++)
        if (joint_is_held(&search->known->points[i], &search->joint))
            return &search->known->points[i];
    return NULL;
}

/** Evaluates the model at one load. */
static void run_at(struct search *search, double load)
{
    struct contact_point points[2] = {quantity_nothing(), quantity_nothing()};
    struct model_curve curve = {.points = points};
    const struct contact_point *held = first_held(search);
    const struct model_task one = model_task_at(&search->task, &load, 1);
    search->point = quantity_nothing();
    search->value = search->full_load = NAN;
    if (!model_curve_bears(search->known, load) || look_up(search, load))
        return;
    bool beyond = held && held->value[QUANTITY_LOAD] <= load;
    if (!beyond && ensemble_curve(&curve, NULL, search->set, search->row, &one, search->status) != STATUS_OK)
        return;
    joint_hold(points, curve.count, &search->joint);
    if (held && (beyond || joint_is_held(points, &search->joint))) {
        points[0] = *held; /* only the parts' shape still depends on the load */
        points[0].value[QUANTITY_LOAD] = load;
        curve = (struct model_curve){.points = points, .count = 1, .exists = true, .full_load = NAN};
    }
    if (joint_curve(&curve, search->row, &one, &search->joint, search->status) != STATUS_OK)
        return;
    search->full_load = curve.exists && model_curve_bears(search->known, curve.full_load) ? curve.full_load : NAN;
    if (curve.count > 0 && points[0].value[QUANTITY_LOAD] == load) {
        search->point = points[0];
        search->value = found_value(search);
    }
}

/** ln(value/target) at ln P, with the sign changed for quantities that fall with load: negative below the load that
 * meets the target. Far beyond it where there is no value. */
static double excess(double ln_load, void *context)
{
    static const double beyond = 1e3;
    struct search *search = context;
    run_at(search, exp(ln_load));
    double ratio = log(search->value / search->target->value) + (search->end ? band_shift(ln_load, search->end) : 0);
    return isnan(search->value) ? beyond : fmin(fmax(rises(search->target) ? ratio : -ratio, -beyond), beyond);
}

/** Narrows two loads around the target to the tolerance: first to neighbours on the known curve, then by Brent's
 * method. */
static enum status_code narrow(double ends[2], struct search *search)
{
    enum { STEPS_MOST = 200 };
    for (size_t begin = 0, end = search->known->count; begin < end;) {
        size_t middle = (begin + end) / 2;
        double load = search->known->points[middle].value[QUANTITY_LOAD];
        bool inside = load > ends[0] && load < ends[1];
        bool before = inside ? excess(log(load), search) < 0 : load <= ends[0];
        if (inside)
            ends[before ? 0 : 1] = load;
        *(before ? &begin : &end) = before ? middle + 1 : middle;
    }
    gsl_function function = {excess, search};
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    if (!solver)
        return status_memory(search->status);
    int rc = gsl_root_fsolver_set(solver, &function, log(ends[0]), log(ends[1]));
    for (int i = 0; i < STEPS_MOST && rc == GSL_SUCCESS && search->status->code == STATUS_OK; i++) {
        rc = gsl_root_fsolver_iterate(solver);
        if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver), gsl_root_fsolver_x_upper(solver),
                                   search->task.tolerance, 0) == GSL_SUCCESS)
            break;
    }
    ends[0] = fmax(exp(gsl_root_fsolver_x_lower(solver)), ends[0]);
    ends[1] = fmin(exp(gsl_root_fsolver_x_upper(solver)), ends[1]);
    gsl_root_fsolver_free(solver);
    return search->status->code;
}

/** Would flat parts meet the target here? With a shape, more load flattens the parts. */
static bool flat_meets(const struct search *search)
{
    bool rising = rises(search->target),
         shaped = quantity_rows[search->target->quantity].effect & EFFECT_BIT(EFFECT_SHAPE);
    double flat = joint_resistance(search->point.value, &search->joint, rising ? JOINT_HEAT : JOINT_CURRENT);
    return shaped && (rising ? 1 / flat >= search->target->value : flat <= search->target->value);
}

/** Is the target passed at loads up to a thousand times lighter (`heavy`: heavier)? */
static bool found_beyond(struct search *search, bool heavy)
{
    const struct model_task *task = &search->task;
    double load = task->loads[heavy ? task->load_count - 1 : 0];
    for (int decade = 0; decade < 3; decade++) {
        load *= heavy ? 10 : 0.1;
        bool met = excess(log(load), search) >= 0;
        if (met == heavy && !isnan(search->value))
            return true;
    }
    return false;
}

/** Finds the load at which the target is met. */
static enum status_code find_load(struct answer *out, struct search *search)
{
    const enum quantity quantity = search->target->quantity;
    const double first = search->task.loads[0], last = search->task.loads[search->task.load_count - 1];
    const double full = full_value(quantity, &search->joint);
    double ends[2] = {first, last}, at_last = excess(log(last), search), at_first = excess(log(first), search);
    bool known = !isnan(search->value), full_meets;
    *out = no_answer;
    out->load = first;
    full_meets = rises(search->target) ? full >= search->target->value : full <= search->target->value;
    if (known && at_first >= 0) {
        out->kind = ANSWER_LIGHTEST;
    } else if (known && at_last < 0) {
        out->kind = ANSWER_NOT_REACHED;
        out->load = last;
    } else if (known && narrow(ends, search) == STATUS_OK) {
        out->kind = ANSWER_LOAD;
        out->load = ends[1];
    }
    if (known && search->asks_wider && (at_first >= 0 || at_last < 0))
        out->wider = found_beyond(search, at_first < 0);
    run_at(search, out->load);
    if (isnan(search->value) && search->full_load <= last && full_meets) {
        out->most = search->full_load > first;
        out->kind = out->most ? ANSWER_LOAD : ANSWER_LIGHTEST;
        out->load = fmax(search->full_load, first);
    } else if (isnan(search->value) && known) { /* the values end before the last load */
        run_at(search, ends[0]);
        bool near = quantity != QUANTITY_TEMPERATURE && /* of which most is the surroundings' */
                    fabs(log(search->value / search->target->value)) < end_slack;
        out->kind = near ? ANSWER_LOAD : ANSWER_NOT_REACHED;
        out->load = near ? ends[1] : search->full_load <= last ? last : ends[0];
    }
    if (out->kind == ANSWER_LOAD && !out->most)
        out->most = fabs(log(value_at(&search->point, quantity) / search->value)) > end_slack;
    if (search->full_load <= out->load)
        search->point = (struct contact_point){.value[QUANTITY_AREA] = 1};
    out->held = joint_is_held(&search->point, &search->joint);
    if (out->held && out->kind == ANSWER_NOT_REACHED && !flat_meets(search)) {
        *out = no_answer;
        out->held = true;
    }
    out->invalid = !curve_summary_point_is_valid(&search->point, search->row);
    out->above_hardness = !out->held && !search->row->plastic &&
                          material_pair_pressure(search->task.pair, out->load) >
                              search->task.hardness_Pa * search->point.value[QUANTITY_AREA];
    return search->status->code;
}

/** The model that counts the spots for an answer of model `m`: itself if it can; else among the models that run, count
 * spots, are valid there, and are not elastic if `m` is plastic: the textbook's, whose count depends least on the
 * scan's spacing, or the one of greatest precedence. model_count: none. */
static size_t counting_model(const struct surface_record *record, const struct plan *plan, size_t m, double load)
{
    size_t found = model_count;
    for (size_t k = 0; k < model_count && !model_rows[m]->spots; k++) {
        const struct curve_summary *model = surface_model(&record->summary, k);
        if (plan_runs_model(plan, k) && model_rows[k]->spots && (model_rows[k]->plastic || !model_rows[m]->plastic) &&
            model->exists && curve_summary_is_valid(model, load) &&
            (found == model_count || model_rows[k]->textbook ||
             (!model_rows[found]->textbook && model_rows[k]->precedence > model_rows[found]->precedence)))
            found = k;
    }
    return model_rows[m]->spots ? m : found;
}

/** Counts the spots at the answer's load, averaged over several scans. */
static enum status_code count_spots(struct answer *out, const struct ensemble *set, size_t by,
                                    const struct model_task *task, struct status *status)
{
    const struct model_row *row = model_rows[by];
    struct model_task one = model_task_at(task, &out->load, 1);
    size_t runs = set->count > 1 && !row->textbook ? set->count : 1, counted = 0;
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

/** Finds the loads at which the ends of the band meet the target. */
static enum status_code find_interval(struct answer *out, const struct surface_record *record, struct search *search)
{
    size_t m = model_index(search->row);
    for (int side = 0; side < 2; side++) {
        const struct band_end end = {
            &record->curves[m], record->bands[m], record->band_count, search->target->quantity, side, &search->joint};
        struct answer one;
        struct search on_end = *search;
        on_end.end = &end;
        if (find_load(&one, &on_end) != STATUS_OK)
            return search->status->code;
        double load = one.kind == ANSWER_LOAD && !one.most ? one.load : NAN;
        out->wider = out->wider || one.wider;
        *(side == rises(search->target) ? &out->low : &out->high) = load; /* it meets it at the lighter load, or not */
    }
    return STATUS_OK;
}

/** Answers a target by the model of `search`. */
static enum status_code answer_target(struct answer *out, const struct surface_record *record,
                                      const struct scene_asked *target, struct search search)
{
    const size_t m = model_index(search.row);
    const unsigned from = quantity_rows[target->quantity].from, needed = from ? from : QUANTITY_BIT(target->quantity);
    const bool holds = joint_has_bond_line(&search.joint);
    search.target = target;
    *out = no_answer;
    search.joint.effects &= from ? ~0u : holds ? EFFECT_BIT(EFFECT_GAP) : 0;
    search.task.wanted &= (holds ? QUANTITY_BIT(QUANTITY_SEPARATION) : 0) | QUANTITY_BIT(QUANTITY_LOAD) |
                          QUANTITY_BIT(QUANTITY_AREA) | needed;
    if (!record->curves[m].exists || (search.row->quantities & search.task.wanted & needed) != needed)
        return STATUS_OK;
    search.asks_wider = record->bands[m];
    if (find_load(out, &search) != STATUS_OK)
        return search.status->code;
    const struct band_end any = {&record->curves[m], record->bands[m], record->band_count, target->quantity, 0,
                                 &search.joint};
    bool banded = record->bands[m] && !out->above_hardness && !isnan(band_shift(log(out->load), &any));
    out->wider = out->wider && banded;
    return banded && out->kind == ANSWER_LOAD && !out->most ? find_interval(out, record, &search) : STATUS_OK;
}

const char *const limit_verdict_words[] = {
    [LIMIT_NO_VALUE] = "no value", [LIMIT_MET] = "met", [LIMIT_MISSED] = "missed", [LIMIT_UNDECIDED] = "undecided"};

enum limit_verdict answers_judge(const struct limit_check *check, const struct scene_asked *limit)
{
    if (isnan(check->value))
        return LIMIT_NO_VALUE;
    bool known = !isnan(check->low) && !isnan(check->high);
    double low = known ? check->low : check->value, high = known ? check->high : check->value;
    if (limit->is_upper ? high <= limit->value : low >= limit->value)
        return LIMIT_MET;
    return (limit->is_upper ? low > limit->value : high < limit->value) ? LIMIT_MISSED : LIMIT_UNDECIDED;
}

/** Checks a limit at point i of the leading model's curve. */
static struct limit_check check_point(const struct surface_record *record, size_t leading,
                                      const struct scene_asked *limit, const struct joint_task *joint, size_t i)
{
    const struct model_curve *curve = &record->curves[leading];
    const struct ensemble_band *band = record->bands[leading];
    enum quantity quantity = limit->quantity;
    const double own = value_at(&curve->points[i], quantity);
    struct limit_check out = {value_within(&curve->points[i], quantity, model_rows[leading], joint), NAN, NAN, 0};
    if (band && i < record->band_count && band[i].load == curve->points[i].value[QUANTITY_LOAD]) {
        out.low = at_end(&(struct band_end){curve, band, record->band_count, quantity, 0, joint}, i);
        out.high = at_end(&(struct band_end){curve, band, record->band_count, quantity, 1, joint}, i);
    }
    out.verdict = answers_judge(&out, limit);
    if (out.verdict == LIMIT_MISSED && fabs(log(own / out.value)) > end_slack)
        out.verdict = LIMIT_UNDECIDED;                 /* of what is known only to be beyond an end */
    out.value = isfinite(out.value) ? out.value : NAN; /* no metal touches */
    return out;
}

/** Checks a limit at a load; where the curve has ended the contact may be full, or the gap fixed by a bond line. */
static struct limit_check check_limit(const struct surface_record *record, size_t leading,
                                      const struct scene_asked *limit, const struct joint_task *joint, double load)
{
    const struct model_curve *curve = &record->curves[leading];
    struct limit_check out = {.value = NAN, .low = NAN, .high = NAN};
    if (!model_curve_bears(curve, load))
        return out;
    for (size_t i = 0; curve->exists && i < curve->count; i++)
        if (curve->points[i].value[QUANTITY_LOAD] == load &&
            (!model_rows[leading]->textbook || curve_summary_point_is_valid(&curve->points[i], model_rows[leading])))
            out = check_point(record, leading, limit, joint, i);
    if (out.verdict == LIMIT_NO_VALUE && curve->exists && curve->count > 0 &&
        joint_is_held(&curve->points[curve->count - 1], joint)) {
        out = check_point(record, leading, limit, joint, curve->count - 1);
    } else if (out.verdict == LIMIT_NO_VALUE && curve->exists && curve->full_load <= load) {
        out.value = full_value(limit->quantity, joint);
        out.verdict = answers_judge(&out, limit);
        out.value = isfinite(out.value) ? out.value : NAN;
    }
    return out;
}

/** What the model has to say where a target is met: the measured resistance is the model's over the carried factor, and
 * so is the voltage that heats. */
static double carried_target(const struct scene_asked *target, const struct surface_summary *summary,
                             const struct scene *scene, const struct plan *plan)
{
    const struct quantity_asked *how;
    const double ambient_K = scene->joint.temperature_K, factor = summary->carried;
    if (target->quantity == summary->carried_quantity)
        return target->value * measured_as(target->quantity, factor); /* conductance is the model's times it */
    if (target->quantity != QUANTITY_TEMPERATURE ||
        summary->carried_quantity != quantity_of_key(&how, "ecr", plan->running))
        return target->value;
    return ambient_K + heating_rise(factor * heating_voltage(target->value, ambient_K), ambient_K);
}

enum status_code answers_find(struct surface_record *record, const struct scene *scene, const struct plan *plan,
                              const struct model_task *task, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    const struct joint_task joint = surface_joint(record, scene, plan, task);
    free(summary->answers);
    free(summary->limits);
    summary->answers = NULL;
    summary->limits = NULL;
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
        struct search search = {.row = model_rows[m],
                                .task = own,
                                .set = &record->ensemble,
                                .joint = joint,
                                .known = &record->curves[m],
                                .status = status};
        for (size_t t = 0; t < scene->target_count; t++) {
            struct answer *answer = &summary->answers[t * model_count + m];
            struct scene_asked target = scene->targets[t];
            if (summary->carried > 0 && m == summary->carried_model)
                target.value = carried_target(&target, summary, scene, plan);
            search.carried = target.value != scene->targets[t].value;
            if (answer_target(answer, record, &target, search) != STATUS_OK)
                return status->code;
            bool met =
                (answer->kind == ANSWER_LOAD || answer->kind == ANSWER_LIGHTEST) && !answer->most && !answer->held;
            size_t by = met ? counting_model(record, plan, m, answer->load) : model_count;
            if (by < model_count && count_spots(answer, &record->ensemble, by, &own, status) != STATUS_OK)
                return status->code;
        }
        model->seconds += clock_seconds() - started;
    }
    answers_check_limits(record, scene, plan, task);
    return STATUS_OK;
}

void answers_check_limits(struct surface_record *record, const struct scene *scene, const struct plan *plan,
                          const struct model_task *task)
{
    const struct joint_task joint = surface_joint(record, scene, plan, task);
    for (size_t l = 0; l < scene->limit_count; l++)
        record->summary.limits[l] = check_limit(record, plan_leading_model(plan), &scene->limits[l], &joint,
                                                task->loads[model_task_operating(task)]);
}

void answers_note(struct text *out, const struct answer *answer, double nominal_area_m2)
{
    double spots = answer->spots_per_m2 * nominal_area_m2;
    if (answer->kind == ANSWER_NONE)
        text_add(out, "%s",
                 answer->held ? "no load reaches it: the gap stays at the bond line of the filler" : "no value");
    if (answer->kind == ANSWER_LIGHTEST)
        text_add(out, "already at the lightest load");
    if (answer->kind == ANSWER_NOT_REACHED)
        text_add(out, "not reached up to P/(A_n E') = %.3g", answer->load);
    if (answer->most)
        text_add(out, "at the latest");
    const char *before = answer->kind == ANSWER_LOAD && !answer->most ? "" : "; ";
    const char *const marks[] = {answer->invalid ? "beyond the model's validity" : NULL,
                                 answer->above_hardness ? "above the hardness" : NULL};
    for (int k = 0; k < 2 && answer->kind != ANSWER_NONE; k++)
        if (marks[k]) {
            text_add(out, "%s%s", before, marks[k]);
            before = "; ";
        }
    if (spots < answers_least_spots)
        text_add(out, "%stoo few spots for statistics (%.2g)", before, spots);
}
