/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What an engineer wants first: contact area, resistance, the best surface, and how far to trust it. */
#include "report/section.h"

#include "analysis/direct_study.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const struct scene_bodies *bodies_of(const struct results *results, size_t surface)
{
    return results->surfaces[surface].summary.scene->bodies;
}

/** Have all usable surfaces bodies of one name? */
static bool same_bodies(const struct results *results)
{
    const struct scene_bodies *first = bodies_of(results, results->by_roughness[0]);
    for (size_t k = 1; k < results->usable_count; k++) {
        const struct scene_bodies *other = bodies_of(results, results->by_roughness[k]);
        if (strcmp(first->material.name, other->material.name) != 0 ||
            first->counterface_kind != other->counterface_kind ||
            strcmp(first->counterface.name, other->counterface.name) != 0)
            return false;
    }
    return true;
}

/** ", of tin", ", of tin and copper". */
static void of_what(struct text *out, const struct results *results)
{
    size_t named = 0;
    for (size_t i = 0; i < results->surface_count; i++) {
        const char *name = bodies_of(results, i)->material.name;
        bool known = !results->surfaces[i].summary.usable || !name[0];
        for (size_t j = 0; j < i && !known; j++)
            known = results->surfaces[j].summary.usable && strcmp(bodies_of(results, j)->material.name, name) == 0;
        if (known)
            continue;
        text_add(out, named++ == 0 ? ", of " : ", ");
        text_add_markdown(out, name);
    }
}

static void load_range(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    const double *loads = results_loads(results, results->baseline);
    double first = loads[0], last = loads[results->load_count - 1];
    const struct results_load_axis axis = results_load_axis(results, results->baseline);
    double modulus_MPa = section_pair(context)->effective_modulus_Pa * 1e-6;
    if (axis.unit && results->scene->load.kind == UNIT_FORCE) {
        text_add(out, " at loads of ");
        number_format_range(out, first * axis.scale, last * axis.scale, 3);
        text_add(out, " ");
        text_add_markdown(out, axis.unit);
    } else if (section_pair(context)->unknown) {
        text_add(out, " at P/(Aₙ E′) of ");
        number_format_power(out, first, 3);
        text_add(out, " to ");
        number_format_power(out, last, 3);
    } else {
        text_add(out, " at nominal pressures of ");
        number_format_range(out, first * modulus_MPa, last * modulus_MPa, 3);
        text_add(out, " MPa");
    }
}

static void surfaces(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    size_t count = results->usable_count;
    text_add(out, "- %zu surface%s, Rq ", count, count == 1 ? "" : "s");
    number_format_range(out, section_surface(context, results->by_roughness[0])->roughness.rq_m * 1e6,
                        section_surface(context, results->by_roughness[count - 1])->roughness.rq_m * 1e6, 3);
    text_add(out, " µm");
    of_what(out, results);
    const struct scene_bodies *bodies = same_bodies(results) ? bodies_of(results, results->by_roughness[0]) : NULL;
    if (results->counterface) {
        text_add(out, ", pressed against a rough counterface (Rq ");
        number_format(out, results->counterface->summary.roughness.rq_m * 1e6, 3);
        text_add(out, " µm; the Rq given are of both together)");
        if (bodies && bodies->counterface_kind == MATERIAL_COUNTERFACE_ELASTIC && bodies->counterface.name[0]) {
            text_add(out, " of ");
            text_add_markdown(out, bodies->counterface.name);
        }
    } else if (!bodies) {
        text_add(out, ", each pressed against a smooth flat");
    } else if (bodies->counterface_kind == MATERIAL_COUNTERFACE_RIGID) {
        text_add(out, ", pressed against a rigid flat%s",
                 results->plan->running & (EFFECT_BIT(EFFECT_ELECTRICAL) | EFFECT_BIT(EFFECT_THERMAL))
                     ? " that conducts like it"
                     : "");
    } else {
        text_add(out, bodies->counterface.name[0] ? ", pressed against a smooth flat of "
                                                  : ", pressed against a smooth flat");
        text_add_markdown(out, bodies->counterface.name);
    }
    load_range(out, context);
    text_add(out, ".\n");
    if (!results_has_material(results))
        text_add(out, "- %s\n", results_without_material);
}

/** "; TCR·Aₙ is … K·m²/W" of the leading model over all surfaces; nothing where it has none. */
static void range(struct text *out, const struct comparison_extremes *extremes, enum quantity quantity)
{
    const struct quantity_row *row = &quantity_rows[quantity];
    bool area = quantity == QUANTITY_AREA;
    if (extremes->count == 0)
        return;
    text_add(out, area ? "; the real contact area is " : "; %s is ", row->symbol);
    number_format_range(out, (area ? 100 : 1) * extremes->least, (area ? 100 : 1) * extremes->most, 3);
    text_add(out, area ? " %% of the nominal one" : " %s", row->unit);
}

/** "1.50·10⁻¹⁰ Ω·m² (95 % 9.57·10⁻¹¹…2.35·10⁻¹⁰; surface beta)" */
static void answer(struct text *out, const struct section_context *context, enum quantity quantity, double value,
                   size_t surface)
{
    size_t leading = context->comparison->leading;
    const struct estimate *estimate =
        curve_summary_estimate(surface_model(section_surface(context, surface), leading), quantity);
    double scale = quantity == QUANTITY_AREA ? 100 : 1;
    number_format(out, scale * value, 3);
    text_add(out, " %s (", quantity == QUANTITY_AREA ? "%" : quantity_rows[quantity].unit);
    number_format_interval(out, "95 % ", scale * estimate_end(estimate, 0), scale * estimate_end(estimate, 1), 3, "; ");
    section_named(out, "surface ", context->results, surface);
    text_add(out, ")");
}

/** What the leading model says at the operating load: the resistance asked for, else the area, of the only surface or
 * from the least to the most, with the intervals. */
static void lead_leading(struct text *out, const struct section_context *context)
{
    const struct comparison *study = context->comparison;
    const struct comparison_extremes *extremes = study->models[study->leading].extremes;
    enum quantity quantity = results_criterion(context->results);
    double nominal_m2 = context->results->scene->nominal_area_m2;
    if (extremes[quantity].count == 0)
        quantity = QUANTITY_AREA;
    if (extremes[quantity].count == 0)
        return;
    text_add(out, "**At ");
    section_middle_pressure(out, context);
    text_add(out, " %s is ", quantity == QUANTITY_AREA ? "the real contact area" : quantity_rows[quantity].symbol);
    answer(out, context, quantity, extremes[quantity].least, extremes[quantity].least_at);
    if (extremes[quantity].count > 1) {
        text_add(out, " to ");
        answer(out, context, quantity, extremes[quantity].most, extremes[quantity].most_at);
    }
    text_add(out, "**%s%s, by %s", quantity == QUANTITY_AREA ? " of the nominal one" : "",
             results_intervals(context->results) ? ", for scans of this length" : "",
             model_rows[study->leading]->label);
    if (!section_pair(context)->unknown && !context->results->loads_apart) {
        text_add(out, " at P/(Aₙ E′) = ");
        number_format_power(out, study->middle_load, 3);
    }
    if (quantity == QUANTITY_ECR && isfinite(nominal_m2)) {
        text_add(out, "; on ");
        number_format_given(out, nominal_m2 * 1e6);
        text_add(out, " mm² ");
        number_format_range(out, extremes[quantity].least / nominal_m2, extremes[quantity].most / nominal_m2, 3);
        text_add(out, " Ω");
    }
    static const enum quantity others[] = {QUANTITY_AREA, QUANTITY_TCR};
    for (size_t k = 0; k < sizeof others / sizeof *others; k++)
        if (others[k] != quantity)
            range(out, &extremes[others[k]], others[k]);
    text_add(out, ".\n\n");
}

/* What the report says first: each writes a paragraph, or nothing. */
static void (*const leads[])(struct text *out, const struct section_context *context) = {section_answers_lead,
                                                                                         lead_leading};

/** " (×0.71, 95 % 0.60…0.84, p = 0.003, 3 and 3 scans)": of the better place i over the worse j. */
static void pair_text(struct text *out, const struct section_context *context, size_t i, size_t j)
{
    const struct comparison_ranking *ranking = &context->comparison->ranking;
    const struct comparison_pair *pair = comparison_pair_of(ranking, i, j);
    size_t leading = context->comparison->leading;
    number_format_between(out, " (×", pair->ratio, 3, "");
    bool adjusted = pair->test == COMPARISON_WELCH && ranking->adjusted > 1;
    number_format_between(out, ", 95 % ", pair->low, 3, "…");
    number_format_between(out, "", pair->high, 3, adjusted ? " of this pair alone" : "");
    if (pair->test == COMPARISON_WELCH)
        text_add(out, pair->p < 1e-4 ? ", p < 0.0001" : ", p = %.2g", pair->p);
    text_add(out, "%s", adjusted ? " over all pairs" : "");
    size_t counts[2];
    for (int k = 0; k < 2; k++)
        counts[k] =
            curve_summary_estimate(surface_model(section_surface(context, ranking->surface[k ? j : i]), leading),
                                   ranking->criterion)
                ->count;
    if (counts[0] == 1 && counts[1] == 1)
        text_add(out, ", one scan each)");
    else
        text_add(out, ", %zu and %zu %s)", counts[0], counts[1],
                 surface_repeats(section_surface(context, ranking->surface[i]))->scans == 1 ? "scans or blocks of rows"
                                                                                            : "scans");
}

/** "surface 2": at place i. */
static void place(struct text *out, const char *before, const struct section_context *context, size_t i)
{
    text_add(out, "%s", before);
    section_named(out, "surface ", context->results, context->comparison->ranking.surface[i]);
}

/** Surfaces with an answer of whose scatter nothing is known. */
static size_t untested(const struct comparison *study)
{
    return study->models[study->leading].extremes[study->ranking.criterion].count - study->ranking.count;
}

/** The best one, told apart from all others. */
static void best_surface(struct text *out, const struct section_context *context)
{
    const struct comparison *study = context->comparison;
    const struct comparison_ranking *ranking = &study->ranking;
    enum quantity quantity = ranking->criterion;
    const char *more = quantity == QUANTITY_AREA ? "larger" : "lower";
    size_t best = ranking->surface[0], agreeing = 0, asked = 0;
    text_add(out, "- **");
    section_named(out, "Surface ", context->results, best);
    text_add(out, " has the %s %s** there%s, for scans of this length: %s than ",
             quantity == QUANTITY_AREA ? "largest" : "lowest", quantity_rows[quantity].short_symbol,
             untested(study) > 0 ? " of those tested" : "", more);
    place(out, "", context, 1);
    text_add(out, ranking->count > 2 ? ", the next" : "");
    pair_text(out, context, 0, 1);
    if (ranking->count > 2) {
        place(out, ", and than ", context, ranking->count - 1);
        text_add(out, ", the worst");
        pair_text(out, context, 0, ranking->count - 1);
    }
    for (size_t m = 0; m < model_count; m++) {
        const struct comparison_extremes *extremes = &study->models[m].extremes[quantity];
        if (extremes->count > 1) {
            asked++;
            agreeing += (quantity == QUANTITY_AREA ? extremes->most_at : extremes->least_at) == best;
        }
    }
    if (asked > 1)
        text_add(out, ". It comes first in %zu of %zu models", agreeing, asked);
}

/** The first are not told apart: no best one is named. */
static void no_best_surface(struct text *out, const struct section_context *context)
{
    enum { MOST = 4 };
    const struct comparison_ranking *ranking = &context->comparison->ranking;
    size_t like = 0, heterogeneous = 0, told = 0;
    for (size_t j = 1; j < ranking->count; j++) {
        const struct comparison_pair *pair = comparison_pair_of(ranking, 0, j);
        told += comparison_told_apart(pair);
        heterogeneous += pair->verdict == RANKING_NO_VERDICT;
    }
    text_add(out, "- **No surface stands out by its %s** there, for scans of this length: ",
             quantity_rows[ranking->criterion].short_symbol);
    place(out, "", context, 0);
    text_add(out, " is not told apart from ");
    for (size_t j = 1; j < ranking->count; j++) {
        if (comparison_told_apart(comparison_pair_of(ranking, 0, j)))
            continue;
        if (like++ < MOST) {
            place(out, like > 1 ? ", nor from " : "", context, j);
            pair_text(out, context, 0, j);
        }
    }
    if (like > MOST)
        text_add(out, ", nor from %zu more", like - MOST);
    if (told > 0)
        text_add(out, "; from the other%s it is", told == 1 ? "" : "s");
    if (heterogeneous > 0)
        text_add(out, ". Single scans that are not the same along their length get no verdict");
}

/** What surfaces differ by, and whether more scans would say the same. */
static void ranking_text(struct text *out, const struct section_context *context)
{
    const struct comparison *study = context->comparison;
    const struct comparison_ranking *ranking = &study->ranking;
    const struct comparison_extremes *extremes = &study->models[study->leading].extremes[ranking->criterion];
    const char *symbol = quantity_rows[ranking->criterion].short_symbol;
    if (extremes->count < 2)
        return;
    if (extremes->count > COMPARISON_RANKED_MOST) {
        text_add(out, "- **The surfaces are not ranked**: there are more than %d.\n", COMPARISON_RANKED_MOST);
        return;
    }
    if (ranking->count < 2) {
        text_add(out, "- **The surfaces are not ranked by %s**: ", symbol);
        text_add(out,
                 context->results->counterface ? "how far the rough counterface's scans scatter is not known"
                 : plan_runs(context->results->plan, EFFECT_UNCERTAINTY)
                     ? "how far another scan would be off is known of fewer than two"
                     : "there is one scan of a surface, and the effect `uncertainty`, which tells how far a scan at "
                       "another place would be off, did not run");
        number_format_between(out, "; as scanned, the largest value is ", extremes->most / extremes->least, 3,
                              " times the smallest.\n");
        return;
    }
    bool best = true;
    for (size_t j = 1; j < ranking->count; j++)
        best = best && comparison_told_apart(comparison_pair_of(ranking, 0, j));
    if (best)
        best_surface(out, context);
    else
        no_best_surface(out, context);
    if (untested(study) > 0)
        text_add(out, ". %zu more %s not tested: how far another scan would be off is not known", untested(study),
                 untested(study) == 1 ? "was" : "were");
    text_add(out, ".\n");
}

static void one_spread(struct text *out, const struct section_context *context, enum quantity quantity,
                       const char *before, double scale, const char *unit)
{
    struct comparison_extremes models = section_models(context, quantity, true);
    if (models.count < 2)
        return;
    number_format_between(out, before, models.least * scale, 3, " (");
    text_add(out, "%s", model_rows[models.least_at]->label);
    text_add(out, ") to ");
    number_format(out, models.most * scale, 3);
    text_add(out, "%s (%s", unit, model_rows[models.most_at]->label);
    text_add(out, ")");
}

static bool is_invalid(const struct section_context *context, size_t m)
{
    return !section_is_valid(&context->baseline->summary, m, context->comparison->middle_load);
}

static bool is_too_hard(const struct section_context *context, size_t m)
{
    return !is_invalid(context, m) && section_is_unfit(context, context->results->baseline, m);
}

/** "; without GW and JG" of the models that are so; returns how many there are. */
static size_t left_out(struct text *out, const struct section_context *context,
                       bool (*is)(const struct section_context *context, size_t m))
{
    size_t count = 0, named = 0;
    for (int pass = 0; pass < 2; pass++)
        for (size_t m = 0; m < model_count; m++) {
            if (!section_middle(context, m) || !is(context, m))
                continue;
            if (pass == 0) {
                count++;
                continue;
            }
            text_add(out, "%s%s",
                     named == 0           ? "; without "
                     : named + 1 == count ? " and "
                                          : ", ",
                     model_rows[m]->label);
            named++;
        }
    return count;
}

static void model_spread(struct text *out, const struct section_context *context)
{
    enum quantity quantity = context->comparison->ranking.criterion;
    if (section_models(context, QUANTITY_AREA, false).count < 2)
        return;
    text_add(out, "- **Between the models**, for ");
    section_named(out, "surface ", context->results, context->results->baseline);
    if (section_models(context, QUANTITY_AREA, true).count < 2)
        text_add(out, ": fewer than two are valid at that load");
    one_spread(out, context, QUANTITY_AREA, " at that load, the area is ", 100, " %");
    if (quantity == QUANTITY_ECR)
        one_spread(out, context, quantity, ", ECR·Aₙ ", 1, " Ω·m²");
    if (quantity == QUANTITY_TCR)
        one_spread(out, context, quantity, ", TCR·Aₙ ", 1, " K·m²/W");
    size_t invalid = left_out(out, context, is_invalid);
    text_add(out, "%s",
             invalid == 0   ? ""
             : invalid == 1 ? ", outside its range of validity there"
                            : ", outside their range of validity there");
    if (left_out(out, context, is_too_hard) > 0)
        text_add(out, ", elastic and above the hardness there");
    text_add(out, ".\n");
}

/** "by a factor of 1.6": an RMS distance in decades. */
static void factor_off(struct text *out, const struct measured_distance *distance)
{
    number_format_between(out, "by a factor of ", pow(10, distance->rms_decades), 3, "");
}

/** How well the models agree with what was measured: the nearest of them, and the farthest. */
static void agreement(struct text *out, const struct section_context *context)
{
    const struct measured *measured = context->results->measured;
    if (!measured)
        return;
    const struct measured_answers *answers = context->results->answers;
    struct measured_ranking rank = measured_rank(measured, answers);
    text_add(out, "- **Measured %s** (%zu point%s): ",
             quantity_rows[measured_quantity(measured, context->results->plan->running)].short_symbol, measured->count,
             measured->count == 1 ? "" : "s");
    if (rank.nearest == model_count) {
        text_add(out, "no measured load lies within those of the models; widen `load` in the scene.\n");
        return;
    }
    struct measured_distance near = measured_compare(measured, answers, rank.nearest);
    text_add(out, "on ");
    section_named(out, "surface ", context->results, context->results->baseline);
    text_add(out, ", %s is nearest, off ", model_rows[rank.nearest]->label);
    factor_off(out, &near);
    text_add(out, " (root mean square over %zu of %zu points) and ", near.points, measured->count);
    number_format_between(out, "", pow(10, near.bias_decades), 3, " times the measured on average");
    if (rank.farthest != rank.nearest) {
        struct measured_distance far = measured_compare(measured, answers, rank.farthest);
        text_add(out, "; %s is farthest, off ", model_rows[rank.farthest]->label);
        factor_off(out, &far);
    }
    text_add(out, ".\n");
}

/** One limit of trust: how many surfaces it concerns. */
static void limit(struct text *out, const struct section_context *context, size_t count, const char *what,
                  const char *then)
{
    if (count == 0)
        return;
    text_add(out, "%s%s", out->length > 0 ? "; " : "", what);
    size_t all = context->results->usable_count;
    if (all > 1 && count == all)
        text_add(out, " on all %zu surfaces", all);
    else if (all > 1)
        text_add(out, " on %zu of %zu surfaces", count, all);
    text_add(out, "%s", then);
}

/** A plastic model whose contact bears more than the hardness. */
static void hard(struct text *list, const struct section_context *context, size_t m)
{
    const struct results *results = context->results;
    size_t count = 0;
    double most = 0;
    struct text what = {0};
    char then[60];
    for (size_t k = 0; k < results->usable_count; k++) {
        const struct contact_point point = comparison_middle(context->results, m, results->by_roughness[k]);
        double pressure = section_contact_pressure(context, results->by_roughness[k], &point);
        if (!(point.value[QUANTITY_AREA] < 1) || !section_exceeds_hardness(context, results->by_roughness[k], &point))
            continue;
        count++;
        most = fmax(most, pressure);
    }
    text_add(&what, "in %s the real contact bears more than ", model_rows[m]->label);
    if (same_bodies(results))
        section_hardness(&what, section_pair(context));
    else
        text_add(&what, "the hardness");
    snprintf(then, sizeof then, " (up to %.2g S_y)", most);
    limit(list, context, count, text_string(&what), then);
    text_free(&what);
}

static void limits(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    double fall = 0;
    size_t leaks = 0, knees = 0, diverging = 0, lawless = 0;
    struct text list = {0};
    for (size_t m = 0; m < model_count; m++) {
        size_t invalid = 0;
        char what[120];
        for (size_t k = 0; k < results->usable_count; k++) {
            const struct curve_summary *model = surface_model(section_smoothest(context, k), m);
            double load = results_operating_load(results, results->by_roughness[k]);
            invalid += model->exists && !section_is_valid(section_smoothest(context, k), m, load);
            if (model->extension.area_measured > 0)
                fall = fmax(fall, 1 - model->extension.area_extended / model->extension.area_measured);
        }
        snprintf(what, sizeof what, "%s is outside its range of validity at that load", model_rows[m]->label);
        limit(&list, context, invalid, what, "");
        if (model_rows[m]->plastic)
            hard(&list, context, m);
    }
    for (size_t k = 0; k < results->usable_count; k++) {
        const struct surface_summary *s = section_smoothest(context, k);
        leaks += s->jump_share > 0.5;
        knees += isfinite(s->power_law.knee_m);
        lawless += !power_law_holds(&s->power_law);
        diverging += surface_diverges(s);
    }
    if (plan_stacks_scales(results->plan))
        limit(&list, context, diverging, "γ is below 1", ", so the elastic area depends on the sampling");
    if (fall > 1e-3) {
        text_add(&list, "%s", list.length > 0 ? "; " : "");
        number_format_between(&list, "scales below the shortest wavelength known would take up to ", 100 * fall, 2,
                              " % more of the area");
    }
    limit(&list, context, leaks, "a jump between the ends of the record draws γ towards 1", "");
    limit(&list, context, lawless, "no power law of a decade was found in the spectrum", "");
    limit(&list, context, knees, "two slopes fit the spectrum better than one law", "");
    if (list.length > 0)
        text_add(out, "- **Limits**: %s.\n", text_string(&list));
    text_free(&list);
}

static void summary(struct text *out, const struct section_context *context)
{
    size_t refused = context->results->surface_count - context->results->usable_count, scans = 0;
    for (size_t k = 0; k < sizeof leads / sizeof *leads; k++)
        leads[k](out, context);
    surfaces(out, context);
    ranking_text(out, context);
    model_spread(out, context);
    agreement(out, context);
    limits(out, context);
    if (refused > 0)
        text_add(out, "- **%zu surface%s refused**: see the end of this report.\n", refused,
                 refused == 1 ? " was" : "s were");
    for (size_t k = 0; k < context->results->usable_count; k++)
        scans += section_smoothest(context, k)->refused_scans;
    if (scans > 0)
        text_add(out,
                 "- **%zu scan%s refused**, of surfaces that go on with their others: see the end of this report.\n",
                 scans, scans == 1 ? " was" : "s were");
}

static bool has_column(const struct section_context *context, int q)
{
    bool form = q == QUANTITY_ADJUSTED || q == QUANTITY_TCR_SCALE_DEPENDENT; /* of a column that is there */
    bool part = q == QUANTITY_GAP || q == QUANTITY_SPOT_RADIUS || q == QUANTITY_PLATING_FACTOR || q == QUANTITY_VOLTAGE;
    return q != QUANTITY_LOAD && !form && !part && /* parts stand where the joint is spoken of */
           section_computes(context, (enum quantity)q);
}

/** How many times the best one's answer a surface's is, with Welch's p, and the letters of the groups that it is in. */
static void ranking_cells(struct text *out, const struct comparison_ranking *ranking, size_t index)
{
    char letters[RANKING_LETTERS + 1] = "–";
    size_t i = 0;
    while (i < ranking->count && ranking->surface[i] != index)
        i++;
    text_add(out, " | ");
    if (i == ranking->count) {
        text_add(out, "–");
    } else if (i == 0) {
        text_add(out, "1");
    } else {
        const struct comparison_pair *pair = comparison_pair_of(ranking, 0, i);
        number_format(out, 1 / pair->ratio, 3);
        if (pair->test == COMPARISON_WELCH)
            text_add(out, pair->p < 1e-4 ? " (p < 0.0001)" : " (p = %.2g)", pair->p);
    }
    if (i < ranking->count)
        ranking_groups_letters(letters, &ranking->groups, i);
    text_add(out, " | %s", letters);
}

static void surface_key(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = section_surface(context, index);
    size_t leading = context->comparison->leading;
    const struct contact_point own = comparison_middle(context->results, leading, index), *point = &own;
    section_cell(out, s->roughness.rq_m * 1e6, 3);
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if (has_column(context, q)) {
            double value = comparison_value(point, (enum quantity)q, leading, s->asperities.sigma_m);
            const struct estimate *estimate = curve_summary_estimate(surface_model(s, leading), q);
            if (estimate->count == 0) {
                section_cell(out,
                             isnan(point->value[QUANTITY_LOAD]) ? NAN
                             : q == QUANTITY_AREA               ? 100 * value
                                                                : value,
                             3);
            } else {
                text_add(out, " | ");
                section_interval(out, estimate, q == QUANTITY_AREA ? 100 : 1, 3);
            }
            if (q == QUANTITY_AREA && section_knows_yield(context))
                section_cell(out, section_contact_pressure(context, index, point), 3);
        }
    if (context->comparison->ranking.count > 1)
        ranking_cells(out, &context->comparison->ranking, index);
    section_load_cell(out, context, index,
                      surface_model(s, leading)->exists ? surface_model(s, leading)->full_load : NAN);
}

/** Below a map's low-pass there is nothing, and area falls with what there is. */
static void name_cutoffs(struct text *out, const struct section_context *context)
{
    double least = INFINITY, most = 0;
    for (size_t i = 0; i < context->results->surface_count; i++) {
        double cutoff_m = section_surface(context, i)->cutoff_m;
        least = cutoff_m > 0 ? fmin(least, cutoff_m) : least;
        most = fmax(most, cutoff_m);
    }
    if (!(most > 0))
        return;
    number_format_between(out,
                          "\nMaps whose short waves are noise were low-passed: their A is that of waves longer than ",
                          least * 1e6, 3, "");
    if (most > least)
        number_format_between(out, " to ", most * 1e6, 3, "");
    text_add(out, " µm.\n");
}

static void key_table(struct text *out, const struct section_context *context)
{
    struct text rule = {0};
    text_add(out, "| surface | Rq (µm)");
    text_add(&rule, "|---|---:|");
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if (has_column(context, q)) {
            const struct quantity_row *row = &quantity_rows[q];
            const char *unit = q == QUANTITY_AREA ? "%" : row->over_sigma ? "" : row->unit;
            text_add(out, unit[0] ? " | %s (%s)" : " | %s", row->symbol, unit);
            text_add(&rule, "---:|");
            if (q == QUANTITY_AREA && section_knows_yield(context)) {
                text_add(out, " | P/A (S_y)");
                text_add(&rule, "---:|");
            }
        }
    const struct comparison_ranking *ranking = &context->comparison->ranking;
    if (ranking->count > 1) {
        text_add(out, " | over the best | alike");
        text_add(&rule, "---:|---|");
    }
    text_add(out, " | full contact at ");
    section_load_symbol(out, context->results);
    text_add(out, " |\n%s---:|\n", text_string(&rule));
    text_free(&rule);
    section_each_surface(out, context, surface_key);
    if (results_intervals(context->results))
        text_add(out, "\nIn brackets: the 95 %% interval of the mean, for scans of this length.");
    if (ranking->count > 1)
        text_add(
            out,
            " Surfaces that share a letter are not told apart by their %s: Welch's test of the scans, with Holm's "
            "adjustment over all pairs, or, of one scan, whether the difference exceeds what the place of the scan "
            "alone makes.",
            quantity_rows[ranking->criterion].short_symbol);
    text_add(out, results_intervals(context->results) ? "\n" : "");
    name_cutoffs(out, context);
}

static void write_summary(struct text *out, const struct section_context *context)
{
    text_add(out, "# ");
    text_add_markdown(out, context->results->scene->title);
    text_add(out, "\n\n");
    summary(out, context);
    text_add(out, "\n**At ");
    section_middle_pressure(out, context);
    text_add(out, "**, %s:\n\n", model_rows[context->comparison->leading]->label);
    key_table(out, context);
}

const struct section section_summary = {"summary", NULL, write_summary};
