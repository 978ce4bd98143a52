/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the user asked for: the load that each target takes, and whether the limits hold. */
#include "report/report.h"
#include "report/section.h"

#include <math.h>
#include <stdio.h>

/** Where text goes: to the report's Markdown, or to a terminal. */
struct page {
    struct text *out;
    const struct results *results;
    bool markdown;
};

static const struct scene *scene_of(const struct page *page)
{
    return page->results->scene;
}

static void put_foreign(const struct page *page, const char *string)
{
    if (page->markdown)
        text_add_markdown(page->out, string);
    else
        text_add_shown(page->out, string);
}

static void put_surface(const struct page *page, size_t index)
{
    if (page->markdown) {
        section_named(page->out, "surface ", page->results, index);
        return;
    }
    text_add(page->out, "surface '");
    text_add_shown(page->out, page->results->surfaces[index].summary.scene->name);
    text_add(page->out, "'");
}

static const struct answer *answer_of(const struct results *results, size_t surface, size_t target, size_t m)
{
    return &results->surfaces[surface].summary.answers[target * model_count + m];
}

/** What loads of a surface stand in: the scene's unit, else N, else MPa, else P/(A_n E'). */
static const char *load_unit(const struct results *results, size_t surface, double *scale)
{
    struct results_load_axis axis = results_load_axis(results, surface);
    const struct material_pair *pair = results_pair(results, surface);
    double area_m2 = results->scene->nominal_area_m2;
    *scale = axis.unit ? axis.scale : 1;
    if (axis.unit || pair->unknown)
        return axis.unit ? axis.unit : "";
    *scale = pair->effective_modulus_Pa * (isfinite(area_m2) ? area_m2 : 1e-6);
    return isfinite(area_m2) ? "N" : "MPa";
}

/** "ECR ≤ 1 mohm". */
static void put_asked(const struct page *page, const struct scene_asked *asked, bool at_most)
{
    text_add(page->out, "%s %s ", asked->row->symbol, at_most ? "≤" : "≥");
    put_foreign(page, asked->text);
}

/** Is a target met from some load on by falling below it? */
static bool falls(const struct scene_asked *target)
{
    return !target->row->rises && !target->row->reciprocal;
}

/** "0.0405 N (0.031…0.052)", with "P/(Aₙ E′) = " where there is no unit; "at most 0.0405 N". */
static void put_load(const struct page *page, const struct answer *answer, size_t surface, bool with_unit)
{
    double scale;
    const char *unit = load_unit(page->results, surface, &scale);
    text_add(page->out, answer->full ? "at most " : "");
    text_add(page->out, with_unit && !*unit ? "P/(Aₙ E′) = " : "");
    number_format(page->out, answer->load * scale, 3);
    text_add(page->out, with_unit && *unit ? " " : "");
    put_foreign(page, with_unit ? unit : "");
    number_format_interval(page->out, " (", answer->low * scale, answer->high * scale, 3, ")");
}

/** Usable surfaces whose leading model answers a target so; the least and the most of those that meet it. */
struct tally {
    size_t met, not_reached, none, best, worst;
    bool alike; /* those two loads are, to the tolerance */
};

static struct tally count_answers(const struct results *results, size_t target, size_t leading)
{
    struct tally out = {0};
    double least = 0, most = 0;
    for (size_t k = 0; k < results->usable_count; k++) {
        size_t i = results->by_roughness[k];
        const struct answer *answer = answer_of(results, i, target, leading);
        double own, scale;
        out.none += answer->kind == ANSWER_NONE;
        out.not_reached += answer->kind == ANSWER_NOT_REACHED;
        if (answer->kind != ANSWER_LOAD && answer->kind != ANSWER_LIGHTEST)
            continue;
        (void)load_unit(results, i, &scale);
        own = answer->load * scale;
        if (out.met == 0 || own < least) {
            least = own;
            out.best = i;
        }
        if (out.met == 0 || own > most) {
            most = own;
            out.worst = i;
        }
        out.met++;
    }
    out.alike = most - least <= 2 * results->scene->tolerance * most;
    return out;
}

/** "0.0405 N on surface 1, the least"; of several that are alike with their number. */
static void put_met(const struct page *page, size_t target, size_t surface, const char *which, size_t alike)
{
    const struct answer *answer = answer_of(page->results, surface, target, plan_leading_model(page->results->plan));
    put_load(page, answer, surface, true);
    text_add(page->out, "%s on ", answer->kind == ANSWER_LIGHTEST ? ", the lightest load, or less" : "");
    if (alike > 1)
        text_add(page->out, "%s%zu surfaces alike", alike == page->results->usable_count ? "all " : "", alike);
    else
        put_surface(page, surface);
    text_add(page->out, "%s%s", which, answer->invalid ? " (beyond the model's validity)" : "");
}

/** One sentence for a target, by the leading model. */
static void target_sentence(const struct page *page, size_t target)
{
    const struct scene_asked *asked = &scene_of(page)->targets[target];
    size_t leading = plan_leading_model(page->results->plan);
    struct tally tally = count_answers(page->results, target, leading);
    text_add(page->out, page->markdown ? "- **" : "");
    put_asked(page, asked, falls(asked));
    text_add(page->out, page->markdown ? "** " : " ");
    if (tally.met == 0) {
        text_add(page->out, tally.not_reached > 0 ? "is not reached within the loads" : "has no answer");
    } else {
        text_add(page->out, "takes ");
        bool two = tally.met > 1 && !tally.alike;
        put_met(page, target, tally.best, two ? ", the least" : "", two ? 1 : tally.met);
        text_add(page->out, two ? ", and " : "");
        if (two)
            put_met(page, target, tally.worst, ", the most", 1);
        if (tally.not_reached > 0)
            text_add(page->out, "; not reached within the loads on %zu of %zu surfaces", tally.not_reached,
                     page->results->usable_count);
    }
    if (tally.none > 0 && tally.met + tally.not_reached > 0)
        text_add(page->out, "; no number on %zu", tally.none);
    text_add(page->out, " (%s%s).\n", model_rows[leading]->label,
             results_intervals(page->results) ? "; intervals for scans of this length" : "");
}

/** "0.02 (GW) to 0.05 (JG)": of the other models that meet it within their validity; beside a plastic one without those
 * above the hardness. */
static void others_cell(const struct page *page, size_t target, size_t leading, size_t surface)
{
    size_t least = model_count, most = model_count;
    double scale;
    (void)load_unit(page->results, surface, &scale);
    for (size_t m = 0; m < model_count; m++) {
        const struct answer *answer = answer_of(page->results, surface, target, m);
        if (m == leading || answer->kind != ANSWER_LOAD || answer->full || answer->invalid ||
            (answer->above_hardness && model_rows[leading]->plastic))
            continue;
        if (least == model_count || answer->load < answer_of(page->results, surface, target, least)->load)
            least = m;
        if (most == model_count || answer->load > answer_of(page->results, surface, target, most)->load)
            most = m;
    }
    text_add(page->out, " | ");
    if (least == model_count) {
        text_add(page->out, "–");
        return;
    }
    number_format(page->out, answer_of(page->results, surface, target, least)->load * scale, 3);
    text_add(page->out, " (%s)", model_rows[least]->label);
    if (most == least)
        return;
    number_format_between(page->out, " to ", answer_of(page->results, surface, target, most)->load * scale, 3, "");
    text_add(page->out, " (%s)", model_rows[most]->label);
}

static void spots_cell(const struct page *page, const struct answer *answer)
{
    double spots = answers_spots(answer, scene_of(page)->nominal_area_m2);
    text_add(page->out, " | ");
    number_format(page->out, spots, 2);
    if (!isnan(spots))
        text_add(page->out, " (%s)", model_rows[answer->counted_by]->label);
}

/** Are the spots of any surface known? */
static bool knows_spots(const struct page *page, size_t target, size_t leading)
{
    bool any = false;
    for (size_t k = 0; k < page->results->usable_count; k++)
        any = any || isfinite(answers_spots(answer_of(page->results, page->results->by_roughness[k], target, leading),
                                            scene_of(page)->nominal_area_m2));
    return any;
}

static void target_row(const struct page *page, size_t target, size_t leading, size_t surface, bool spots)
{
    const struct answer *answer = answer_of(page->results, surface, target, leading);
    double scale;
    struct text unit = {0};
    text_add_markdown(&unit, load_unit(page->results, surface, &scale));
    text_add(page->out, " | ");
    if (answer->kind == ANSWER_LOAD || answer->kind == ANSWER_LIGHTEST)
        put_load(page, answer, surface, false);
    else
        text_add(page->out, "–");
    others_cell(page, target, leading, surface);
    if (spots)
        spots_cell(page, answer);
    text_add(page->out, " | ");
    answers_note(page->out, answer, scene_of(page)->nominal_area_m2, scale, text_string(&unit));
    text_free(&unit);
}

static void each_surface(const struct section_context *context, const struct page *page, size_t target, size_t leading,
                         bool spots)
{
    size_t rows = 0;
    for (size_t i = 0; i < context->results->surface_count && rows < SECTION_ROWS; i++) {
        if (!section_surface(context, i)->usable)
            continue;
        text_add(page->out, "| ");
        section_surface_name(page->out, context->results, i);
        target_row(page, target, leading, i, spots);
        text_add(page->out, " |\n");
        rows++;
    }
    if (rows < context->results->usable_count)
        text_add(page->out, "| … %zu more in data/ |\n", context->results->usable_count - rows);
}

static void target_table(const struct section_context *context, const struct page *page, size_t target)
{
    size_t leading = plan_leading_model(page->results->plan);
    bool spots = knows_spots(page, target, leading);
    double scale;
    const char *unit = load_unit(page->results, page->results->baseline, &scale);
    text_add(page->out, "\n| ");
    put_asked(page, &scene_of(page)->targets[target], falls(&scene_of(page)->targets[target]));
    text_add(page->out, " | %s takes%s", model_rows[leading]->label, *unit ? ", " : " P/(Aₙ E′)");
    put_foreign(page, unit);
    text_add(page->out,
             " (95 %% interval, for scans of this length) | other models, least to most%s | remark "
             "|\n|---|---:|---|%s---|\n",
             spots ? " | spots" : "", spots ? "---|" : "");
    each_surface(context, page, target, leading, spots);
}

/** A verdict is told by its word; the mark makes it quick to find. */
static const struct {
    const char *mark, *word;
} verdicts[] = {
    [LIMIT_NO_VALUE] = {"–", "no value"},
    [LIMIT_MET] = {"✓", "meets"},
    [LIMIT_MISSED] = {"✗", "**misses**"},
    [LIMIT_CANNOT_TELL] = {"?", "cannot tell"},
};

/** "1.2 mohm (1.0…1.5)". */
static void put_value(const struct page *page, const struct scene_asked *limit, const struct limit_check *check)
{
    int low = limit->row->reciprocal;
    double ends[2] = {scene_asked_shown(limit, check->low), scene_asked_shown(limit, check->high)};
    number_format(page->out, scene_asked_shown(limit, check->value), 3);
    text_add(page->out, "%s", limit->unit_text[0] ? " " : "");
    put_foreign(page, limit->unit_text);
    number_format_interval(page->out, " (", ends[low], ends[!low], 3, ")");
}

/** The same; without a number there, where the verdict comes from. */
static void put_check(const struct page *page, const struct scene_asked *limit, const struct limit_check *check)
{
    if (isfinite(scene_asked_shown(limit, check->value)))
        put_value(page, limit, check);
    else
        text_add(page->out, "from a lighter load on");
}

/** One sentence for a limit. */
static void limit_sentence(const struct page *page, size_t limit)
{
    const struct results *results = page->results;
    size_t counts[LIMIT_CANNOT_TELL + 1] = {0};
    for (size_t k = 0; k < results->usable_count; k++)
        counts[results->surfaces[results->by_roughness[k]].summary.limits[limit].verdict]++;
    text_add(page->out, page->markdown ? "- Limit **" : "limit ");
    put_asked(page, &scene_of(page)->limits[limit], scene_of(page)->limits[limit].is_most);
    text_add(page->out, page->markdown ? "**" : "");
    text_add(page->out, ": %zu of %zu surfaces meet it, %zu miss it", counts[LIMIT_MET], results->usable_count,
             counts[LIMIT_MISSED]);
    if (counts[LIMIT_CANNOT_TELL] > 0)
        text_add(page->out, ", of %zu the interval straddles it", counts[LIMIT_CANNOT_TELL]);
    if (counts[LIMIT_NO_VALUE] > 0)
        text_add(page->out, ", %zu have no value", counts[LIMIT_NO_VALUE]);
    text_add(page->out, ".\n");
}

static void limit_table(const struct section_context *context, const struct page *page)
{
    const struct scene *scene = scene_of(page);
    size_t leading = plan_leading_model(page->results->plan), rows = 0;
    text_add(page->out, "\nLimits at the operating load (");
    section_at_load(page->out, page->results, page->results->baseline, context->comparison->middle_load);
    text_add(
        page->out,
        "), by %s; a limit inside a surface's 95 %% interval, for scans of this length, cannot be told:\n\n| surface",
        model_rows[leading]->label);
    for (size_t l = 0; l < scene->limit_count; l++) {
        text_add(page->out, " | ");
        put_asked(page, &scene->limits[l], scene->limits[l].is_most);
    }
    text_add(page->out, " |\n|---");
    for (size_t l = 0; l < scene->limit_count; l++)
        text_add(page->out, "|---");
    text_add(page->out, "|\n");
    for (size_t i = 0; i < page->results->surface_count && rows < SECTION_ROWS; i++) {
        const struct surface_summary *summary = section_surface(context, i);
        if (!summary->usable)
            continue;
        text_add(page->out, "| ");
        section_surface_name(page->out, page->results, i);
        for (size_t l = 0; l < scene->limit_count; l++) {
            const struct limit_check *check = &summary->limits[l];
            text_add(page->out, " | %s %s", verdicts[check->verdict].mark, verdicts[check->verdict].word);
            if (check->verdict == LIMIT_NO_VALUE)
                continue;
            text_add(page->out, ": ");
            put_check(page, &scene->limits[l], check);
        }
        text_add(page->out, " |\n");
        rows++;
    }
    if (rows < page->results->usable_count)
        text_add(page->out, "| … %zu more in results.json |\n", page->results->usable_count - rows);
}

static void sentences(const struct page *page)
{
    for (size_t t = 0; t < scene_of(page)->target_count; t++)
        target_sentence(page, t);
    for (size_t l = 0; l < scene_of(page)->limit_count; l++)
        limit_sentence(page, l);
}

void report_terminal_answers(struct text *out, const struct results *results)
{
    const struct page page = {out, results, false};
    sentences(&page);
}

size_t report_missed_limits(struct text *out, const struct results *results)
{
    const struct page page = {out, results, false};
    size_t missed = 0;
    for (size_t i = 0; i < results->surface_count; i++)
        for (size_t l = 0; l < results->scene->limit_count && results->surfaces[i].summary.usable; l++) {
            const struct limit_check *check = &results->surfaces[i].summary.limits[l];
            if (check->verdict != LIMIT_MISSED)
                continue;
            put_surface(&page, i);
            text_add(out, " misses the limit ");
            put_asked(&page, &results->scene->limits[l], results->scene->limits[l].is_most);
            text_add(out, ": ");
            put_check(&page, &results->scene->limits[l], check);
            text_add(out, isnan(check->low) ? "\n" : ", for scans of this length\n");
            missed++;
        }
    return missed;
}

static bool called_for(const struct section_context *context)
{
    return context->results->scene->target_count > 0 || context->results->scene->limit_count > 0;
}

void section_answers_lead(struct text *out, const struct section_context *context)
{
    const struct page page = {out, context->results, true};
    sentences(&page);
    if (called_for(context))
        text_add(out, "\n");
}

static void write(struct text *out, const struct section_context *context)
{
    const struct page page = {out, context->results, true};
    text_add(out, "## Answers\n\n");
    for (size_t t = 0; t < scene_of(&page)->target_count; t++)
        target_table(context, &page, t);
    if (scene_of(&page)->limit_count > 0)
        limit_table(context, &page);
}

const struct section section_answers = {"answers", called_for, write};
