/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "members/ensemble.h"

#include "profile/profile.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

void solved_strip_free(struct solved_strip *solved)
{
    if (solved)
        bearing_free(&solved->bearing);
    free(solved);
}

static void member_free(struct member *member)
{
    spectrum_free(&member->spectrum);
    free(member->height_m);
    solved_strip_free(member->strip);
    strip_nodes_free(&member->prepared.nodes);
    *member = (struct member){.strip = NULL};
}

void ensemble_free(struct ensemble *set)
{
    for (size_t p = 0; p < set->count; p++)
        member_free(&set->members[p]);
    free(set->members);
    free(set->scan_weight);
    *set = (struct ensemble){0};
}

struct member *ensemble_room(struct ensemble *set)
{
    struct member *members = reallocarray(set->members, set->count + 1, sizeof *members);
    if (!members)
        return NULL;
    set->members = members;
    set->members[set->count] = (struct member){0};
    return &set->members[set->count++];
}

static size_t place_of(const struct ensemble *set, size_t p)
{
    return set->members[p].is_row ? p : set->members[p].scan;
}

size_t ensemble_partner(const struct ensemble *set, size_t p, const struct ensemble *other)
{
    size_t q = 0;
    while (q < other->count && place_of(other, q) != place_of(set, p))
        q++;
    return q;
}

struct record_conditioning record_conditioning_of(const struct scene *scene, bool periodic)
{
    return (struct record_conditioning){scene->level,  !scene->level_given, periodic,
                                        scene->window, scene->moments,      false};
}

enum status_code member_of_record(struct member *out, struct fft_room *room, size_t points, double spacing_m,
                                  const struct record_conditioning *how, struct status *status)
{
    struct levelling levelling;
    struct status none = {0};
    enum level level = how->periodic && how->periodic_mean ? LEVEL_MEAN : how->level;
    *out = (struct member){.points = points, .spacing_m = spacing_m, .periodic = how->periodic};
    if (level_remove(&levelling, room->record, NULL, points, spacing_m, level, &none) == STATUS_MEMORY)
        return status_memory(status);
    if (how->keeps_heights) {
        if (!(out->height_m = malloc(points * sizeof *out->height_m)))
            return status_memory(status);
        memcpy(out->height_m, room->record, points * sizeof *out->height_m);
    }
    out->roughness = roughness_of_heights(room->record, points, spacing_m);
    enum spectrum_window window = spectrum_window_for(how->window, how->periodic);
    if (spectrum_of_record(&out->spectrum, room, points, spacing_m, window, status) != STATUS_OK)
        return status->code;
    if (how->moments == ROUGHNESS_MOMENTS_SPECTRAL)
        roughness_from_spectrum(&out->roughness, &out->spectrum);
    return STATUS_OK;
}

enum status_code ensemble_add(struct ensemble *set, size_t scan, const struct record_heights *of,
                              const struct record_conditioning *how, struct status *status)
{
    OWNED(fft_room_free) struct fft_room room = {0};
    struct record_conditioning own = *how;
    struct member *member = ensemble_room(set);
    own.periodic = how->periodic && record_window_is_periodic(of->height_m, of->points);
    own.keeps_heights = set->keeps_heights;
    if (!member || !fft_room_make(&room, of->points))
        return status_memory(status);
    memcpy(room.record, of->height_m, of->points * sizeof *of->height_m);
    enum status_code rc = member_of_record(member, &room, of->points, of->spacing_m, &own, status);
    member->scan = scan;
    return rc;
}

enum status_code ensemble_pair(struct ensemble *set, const struct ensemble *other, struct status *status)
{
    size_t kept = 0;
    for (size_t p = 0; p < set->count; p++) {
        size_t q = ensemble_partner(set, p, other);
        struct member member = set->members[p];
        if (q == other->count) {
            member_free(&set->members[p]);
            continue;
        }
        set->members[p] = (struct member){.strip = NULL};
        roughness_add(&member.roughness, &other->members[q].roughness);
        set->members[kept] = member;
        if (grid_add(&set->members[kept++].spectrum, &other->members[q].spectrum, status) != STATUS_OK)
            return status->code;
    }
    set->count = kept;
    return STATUS_OK;
}

struct model_task member_task(struct asperities *asperities, const struct member *member, const struct model_task *task)
{
    struct model_task own = *task;
    struct status none = {0};
    own.spectrum = &member->spectrum;
    own.rough = (struct cmy){member->roughness.rq_m, cmy_slope(member->roughness.m2)};
    if (member->strip) {
        own.strip = &member->strip->strip;
        own.bearing = &member->strip->bearing;
    }
    own.prepared = &member->prepared;
    own.asperities = roughness_asperities(asperities, &member->roughness, &none) == STATUS_OK ? asperities : NULL;
    return own;
}

enum status_code ensemble_prepare(struct ensemble *set, const struct model_task *task, struct status *status)
{
    for (size_t p = 0; p < set->count; p++) {
        struct asperities asperities;
        struct member *member = &set->members[p];
        const struct model_task own = member_task(&asperities, member, task);
        if (own.strip && (member->strip || !set->solved_alone) &&
            model_strips_prepare(&member->prepared, &own, status) != STATUS_OK)
            return status->code;
    }
    return STATUS_OK;
}

enum status_code ensemble_estimate(struct estimate *out, const struct ensemble *set, const struct ensemble_value *of,
                                   size_t count, bool logarithmic, struct status *status)
{
    OWNED(memory_free) double *mean = malloc(2 * (count + 1) * sizeof *mean);
    size_t scans = 0;
    if (!mean)
        return status_memory(status);
    double *weight = mean + count;
    for (size_t i = 0, end; i < count; i = end, scans++) {
        double sum = 0, first = logarithmic ? log(of[i].value) : of[i].value;
        for (end = i; end < count && of[end].scan == of[i].scan; end++)
            sum += (logarithmic ? log(of[end].value) : of[end].value) - first;
        double own = first + sum / (double)(end - i); /* equal values give exactly themselves */
        mean[scans] = end == i + 1 ? of[i].value : logarithmic ? exp(own) : own;
        weight[scans] = set->scan_weight[of[i].scan];
    }
    return estimate_make(out, mean, weight, scans, logarithmic, status);
}

void ensemble_curves_free(struct ensemble_curves *curves)
{
    free(curves->curves);
    free(curves->points);
    free(curves->of);
    free(curves->sigma_m);
}

enum status_code ensemble_run(struct ensemble_curves *out, const struct ensemble *set, const struct model_row *model,
                              const struct model_task *task, const struct joint_task *joint, struct status *status)
{
    size_t all = set->count, room = task->load_count + 1;
    struct joint_task between = joint ? *joint : (struct joint_task){.pair = task->pair};
    *out = (struct ensemble_curves){.curves = calloc(all, sizeof *out->curves),
                                    .points = calloc(all * room, sizeof *out->points),
                                    .of = calloc(all, sizeof *out->of),
                                    .sigma_m = calloc(all, sizeof *out->sigma_m)};
    if (!out->curves || !out->points || !out->of || !out->sigma_m)
        return status_memory(status);
    for (size_t p = 0; p < all; p++) {
        struct asperities asperities;
        struct model_task alone = member_task(&asperities, &set->members[p], task);
        if (set->solved_alone && model->uses_strip && !set->members[p].strip)
            continue;
        struct model_curve *own = &out->curves[out->count];
        *own = (struct model_curve){.points = out->points + out->count * room};
        out->of[out->count].scan = set->members[p].scan;
        out->sigma_m[out->count] = sqrt(set->members[p].roughness.m0_m2);
        between.sigma_m = out->sigma_m[out->count];
        if (model_run(own, model, &alone, status) != STATUS_OK ||
            joint_curve(own, model, &alone, &between, status) != STATUS_OK)
            return status->code;
        out->evaluations += own->evaluations;
        out->overflows = out->overflows || own->overflows;
        out->count += own->exists;
        out->left_out += !own->exists;
    }
    return STATUS_OK;
}

struct ensemble_band *ensemble_band_make(const double *loads, size_t count)
{
    struct ensemble_band *band = malloc(count * sizeof *band);
    for (size_t i = 0; band && i < count; i++) {
        band[i].load = loads[i];
        for (int q = 0; q < QUANTITY_COUNT; q++)
            for (int side = 0; side < 2; side++)
                band[i].mean[q][side] = band[i].next[q][side] = NAN;
    }
    return band;
}

/** The curves that are averaged. */
struct mean {
    const struct ensemble_curves *curves;
    const struct ensemble *set;
    const struct model_row *model;
    const struct model_task *task;
    const struct model_curve *joined; /* of all rows in one strip, or of the textbook model; NULL: other models */
};

/** Mean of the numbers in curves->of; where a positive quantity is 0 in all of them, 0. */
static enum status_code mean_of(double *mean, struct estimate *estimate, const struct mean *of, bool logarithmic,
                                struct status *status)
{
    const struct ensemble_curves *curves = of->curves;
    bool zero = logarithmic;
    for (size_t r = 0; r < curves->count && zero; r++)
        zero = curves->of[r].value == 0;
    if (ensemble_estimate(estimate, of->set, curves->of, curves->count, logarithmic, status) != STATUS_OK)
        return status->code;
    *mean = zero ? 0 : estimate_value(estimate);
    return STATUS_OK;
}

/** Point `at` of a curve; SIZE_MAX: full contact. */
static const struct contact_point *point_of(const struct ensemble_curves *curves, size_t r, size_t at)
{
    return at == SIZE_MAX ? &curves->curves[r].full : &curves->curves[r].points[at];
}

/** Fills the quantities of `out` with the means over point `at` of all curves. estimates: NULL, or QUANTITY_COUNT of
 * them; lengths are over sigma. */
static enum status_code mean_point(struct contact_point *out, struct estimate *estimates, const struct mean *of,
                                   size_t at, struct status *status)
{
    const struct ensemble_curves *curves = of->curves;
    struct estimate unused = estimate_none;
    *out = quantity_nothing();
    for (int q = QUANTITY_AREA; q < QUANTITY_COUNT; q++) {
        const struct quantity_row *row = &quantity_rows[q];
        struct estimate *estimate = estimates ? &estimates[q] : &unused;
        bool logarithmic = !(row->is & QUANTITY_LINEAR) || q == (int)model_shown(of->model, QUANTITY_SEPARATION);
        double mean = NAN;
        *estimate = estimate_none;
        if (row->from && isnan(point_of(curves, 0, at)->value[q]))
            continue; /* not asked for, or not known */
        for (size_t r = 0; r < curves->count; r++)
            curves->of[r].value = point_of(curves, r, at)->value[q] / (row->sigma_column ? curves->sigma_m[r] : 1);
        if (mean_of(&mean, estimate, of, logarithmic, status) != STATUS_OK)
            return status->code;
        out->value[q] = row->from ? NAN
                                  : mean * (row->sigma_column ? of->set->sigma_m
                                                              : 1); /* joint_apply() fills in what depends on others */
    }
    for (size_t r = 0; r < curves->count; r++)
        curves->of[r].value = point_of(curves, r, at)->beyond_fit;
    if (mean_of(&out->beyond_fit, &unused, of, false, status) != STATUS_OK)
        return status->code;
    for (size_t r = 0; r < curves->count; r++)
        curves->of[r].value = point_of(curves, r, at)->radius_clamped;
    return mean_of(&out->radius_clamped, &unused, of, false, status);
}

/** Do all curves have a point at load i of the task, and at least half of them one that is not merely the last value
 * kept? */
static bool all_reach(const struct ensemble_curves *curves, size_t i, double load)
{
    size_t carried = 0;
    for (size_t r = 0; r < curves->count; r++) {
        const struct model_curve *curve = &curves->curves[r];
        if (i >= curve->count || curve->points[i].value[QUANTITY_LOAD] != load)
            return false;
        carried += i >= curve->count - curve->carried;
    }
    return 2 * carried <= curves->count;
}

/** Does every curve end at full contact? */
static bool all_close(const struct ensemble_curves *curves)
{
    for (size_t r = 0; r < curves->count; r++) {
        const struct model_curve *curve = &curves->curves[r];
        if (curve->count == 0 || curve->points[curve->count - 1].value[QUANTITY_LOAD] != curve->full_load)
            return false;
    }
    return true;
}

static void fill_band(struct ensemble_band *band, const struct estimate *estimates, const struct model_row *model)
{
    for (int q = 0; q < QUANTITY_COUNT; q++) {
        const struct estimate *estimate = &estimates[model_shown(model, (enum quantity)q)];
        bool holds = quantity_rows[q].is & QUANTITY_BANDED;
        for (int side = 0; side < 2; side++) /* two ends, one quantile */
            band->mean[q][side] = holds ? estimate_end(estimate, side) : NAN;
        for (int side = 0; side < 2; side++)
            band->next[q][side] = holds ? estimate_next_end(estimate, side) : NAN;
    }
}

/** Moves a point by `share` of the way, in logarithms, towards that of the joined rows. */
static void join(struct contact_point *point, struct estimate *estimates, const struct contact_point *joined,
                 double share)
{
    for (int q = QUANTITY_AREA; q < QUANTITY_COUNT; q++) {
        double shift = share * log(joined->value[q] / point->value[q]);
        if (!isfinite(shift))
            continue;
        point->value[q] *= exp(shift);
        estimates[q].mean += shift;
    }
}

void ensemble_hold(struct estimate estimates[QUANTITY_COUNT], const struct contact_point *point,
                   const struct model_row *model, const struct joint_task *joint)
{
    double bound[QUANTITY_COUNT][2];
    joint_bounds(bound, point, model, joint);
    for (int q = 0; q < QUANTITY_COUNT; q++)
        memcpy(estimates[q].bound, bound[q], sizeof bound[q]);
    if (joint_has_bond_line(joint) &&
        !joint_is_held(point, joint)) /* no more than the most of the spots and that of the filler together */
        estimates[QUANTITY_JOINT].bound[1] = bound[QUANTITY_GAP][1] + 1 / estimate_end(&estimates[QUANTITY_TCR], 0);
    for (int q = QUANTITY_AREA; q < QUANTITY_COUNT && joint_is_held(point, joint); q++) {
        bool filler = q == QUANTITY_GAP || q == QUANTITY_JOINT;
        if (filler && !(point->value[QUANTITY_AREA] > 0)) /* the filler alone, which does not scatter */
            estimates[q].s = estimates[q].half_width = estimates[q].next_half_width = estimates[q].model_sd = 0;
        else if (q <= QUANTITY_TCR_SCALE_DEPENDENT && point->value[QUANTITY_AREA] > 0 && q != QUANTITY_SEPARATION &&
                 q != QUANTITY_ADJUSTED)
            estimates[q].mean = log(point->value[q]);
        else if (!quantity_rows[q].from || quantity_rows[q].derive || !(point->value[QUANTITY_AREA] > 0))
            estimates[q] = estimate_none;
    }
}

void ensemble_settle(struct estimate estimates[QUANTITY_COUNT], const struct contact_point *point,
                     const struct model_row *model, const struct joint_task *joint, struct scans_reach reach)
{
    double sd[QUANTITY_COUNT];
    joint_model_sd(sd, point, model, joint, reach);
    for (int q = 0; q < QUANTITY_COUNT; q++) {
        estimates[q].model_sd = sd[q];
        if (quantity_rows[q].from && point->value[q] > 0)
            estimates[q].mean = log(point->value[q]);
        else if (quantity_rows[q].from)
            estimates[q] = estimate_none;
    }
    ensemble_hold(estimates, point, model, joint);
    if (model_area_is_pressed(model, point, joint->pair))
        estimates[QUANTITY_AREA].half_width = estimates[QUANTITY_AREA].next_half_width = NAN;
    for (int q = 0; q < QUANTITY_COUNT && model_is_overloaded(model, point, joint->pair); q++)
        estimates[q].half_width = estimates[q].next_half_width = NAN;
}

static enum status_code mean_curve(struct model_curve *curve, struct ensemble_result *result, const struct mean *of,
                                   struct status *status)
{
    const struct model_task *task = of->task;
    const struct model_row *model = of->model;
    const struct model_curve *joined = of->joined;
    struct estimate estimates[QUANTITY_COUNT];
    const struct joint_task bare = {.pair = task->pair}, *joint = result->joint ? result->joint : &bare;
    const struct scans_reach reach = model_task_reach(task);
    double share = of->set->scan_count > 1 && model->uses_strip ? 0.5 : 1;
    estimates[QUANTITY_LOAD] = estimate_none;
    curve->exists = true;
    for (size_t r = 0; r < of->curves->count; r++)
        of->curves->of[r].value = of->curves->curves[r].full_load;
    if (mean_of(&curve->full_load, &result->estimates[CURVE_FULL_LOAD], of, true, status) != STATUS_OK)
        return status->code;
    for (size_t r = 0; r < of->curves->count; r++)
        of->curves->of[r].value = of->curves->curves[r].beta;
    if (mean_of(&curve->beta, &result->estimates[CURVE_BETA], of, false, status) != STATUS_OK ||
        mean_point(&curve->full, NULL, of, SIZE_MAX, status) != STATUS_OK)
        return status->code;
    curve->full.value[QUANTITY_LOAD] = curve->full_load;
    size_t count = joined && joined->count < task->load_count ? joined->count : task->load_count;
    for (size_t i = 0; i < count && all_reach(of->curves, i, task->loads[i]); i++) {
        struct contact_point *point = &curve->points[curve->count++];
        if (mean_point(point, estimates, of, i, status) != STATUS_OK)
            return status->code;
        point->value[QUANTITY_LOAD] = task->loads[i];
        if (joined)
            join(point, estimates, &joined->points[i], share);
        joint_hold(i > 0 ? point - 1 : point, i > 0 ? 2 : 1, joint);
        const struct model_task here = model_task_at(task, &task->loads[i], 1);
        struct model_curve alone = {.exists = true, .points = point, .count = 1};
        if (joint_curve(&alone, model, &here, joint, status) != STATUS_OK)
            return status->code;
        ensemble_settle(estimates, point, model, joint, reach);
        if (result->band)
            fill_band(&result->band[i], estimates, model);
        for (int q = 0; q < QUANTITY_COUNT && i == model_task_operating(task); q++)
            result->estimates[q] = estimates[model_shown(model, (enum quantity)q)];
    }
    if (curve->count < task->load_count && all_close(of->curves))
        curve->points[curve->count++] = curve->full;
    return STATUS_OK;
}

enum status_code ensemble_curve(struct model_curve *curve, struct ensemble_result *result, const struct ensemble *set,
                                const struct model_row *model, const struct model_task *task, struct status *status)
{
    struct ensemble_result unused = {.band = NULL};
    struct ensemble_curves curves;
    if (set->count <= 1 || model->uses_map)
        return model_run(curve, model, task, status);
    result = result ? result : &unused;
    for (int q = 0; q < CURVE_ESTIMATES; q++)
        result->estimates[q] = estimate_none;
    struct model_task each = *task;
    each.carries_on = true; /* a scan that reaches full contact early must not end the others' mean */
    enum status_code rc = ensemble_run(&curves, set, model, &each, result->joint, status);
    curve->evaluations = curves.evaluations;
    curve->overflows = curves.overflows;
    for (size_t r = 0; rc == STATUS_OK && r < curves.count; r++)
        curve->clamped += curves.curves[r].clamped;
    result->scans = curves.count;
    result->left_out = curves.left_out;
    struct model_curve joined = {.points = malloc((task->load_count + 1) * sizeof *joined.points)};
    if (rc == STATUS_OK && !joined.points)
        rc = status_memory(status);
    if (rc == STATUS_OK && (model->uses_strip || model->textbook))
        rc = model_run(&joined, model, task, status);
    const struct mean of = {&curves, set, model, task, joined.exists ? &joined : NULL};
    if (rc == STATUS_OK && curves.count > 0)
        rc = mean_curve(curve, result, &of, status);
    free(joined.points);
    ensemble_curves_free(&curves);
    return rc;
}
