/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The first page: the headline, the table of all surfaces, the first claims. */
#include "report/view.h"

#include "base/number_format.h"
#include <math.h>
#include <string.h>

enum { CLAIMS_MOST = 8 };

/** A load or an answer as a cell has it: "0.92 (0.28–3.2)", "0.97 (measured)", "≤ 0.1", "–". */
static void put_known(json_t *out, json_t *row, const char *name, const struct view_source *source,
                      const struct scene_asked *target, size_t surface)
{
    static const char *const signs[] = {[KNOWN_VALUE] = "", [KNOWN_AT_MOST] = "≤\u00a0", [KNOWN_MORE_THAN] = ">\u00a0"};
    const struct known known = known_shown(source->results, &source->asked, target, surface);
    OWNED(text_free) struct text text = {0};
    text_add(&text, "%s", known.kind == KNOWN_NOTHING ? "–" : signs[known.kind]);
    if (known.kind != KNOWN_NOTHING)
        number_format(&text, known.value, known_digits(&known));
    json_t *cell = view_part(row, name);
    view_text(cell, "value", text_string(&text));
    if (known.kind == KNOWN_VALUE && !known.measured &&
        view_interval(cell, known.low, known.high, known_digits(&known), "–"))
        view_flag(out, target ? "load_95" : "value_95", true);
    view_flag(cell, "measured", known.measured && !known.beyond && known.kind != KNOWN_NOTHING);
    view_flag(cell, "overloaded", known.overloaded);
    if (known.overloaded)
        view_flag(out, "some_overloaded", true);
}

static void put_row(json_t *out, json_t *row, const struct view_source *source, size_t surface, bool lettered)
{
    static const char *const verdicts[] = {
        [LIMIT_NO_VALUE] = "no_value", [LIMIT_MET] = "met", [LIMIT_MISSED] = "missed", [LIMIT_UNDECIDED] = "undecided"};
    const struct comparison *ranking = source->comparison;
    const struct surface_summary *summary = view_summary(source, surface);
    const bool both = source->results->counterface; /* rough: heights of both bodies together */
    view_text(row, "surface", view_name(source, surface));
    view_flag(row, "map", summary->has_map);
    json_set(row, "rq_m",
             !summary->has_map ? summary->roughness.rq_m
             : both            ? summary->rough.sigma_m
                               : summary->measured.sq_m);
    view_law(row, &summary->power_law);
    put_known(out, row, "value", source, NULL, surface);
    if (source->asked.target)
        put_known(out, row, "load", source, source->asked.target, surface);
    for (size_t l = 0; l < source->results->scene->limit_count && l < ASKED_LIMIT_COLUMNS; l++)
        view_flag(view_item(view_list(row, "limits")), verdicts[summary->limits[l].verdict], true);
    for (size_t p = 0; lettered && p < ranking->count; p++)
        if (ranking->surface[p] == surface) {
            char letters[RANKING_LETTERS + 1];
            ranking_groups_letters(letters, &ranking->groups, p);
            view_text(row, "letters", letters);
        }
}

/** Is there a claim of the ranking? Else it is not of what the table shows. */
static bool ranking_is_told(const struct view_source *source)
{
    size_t i;
    json_t *claim;
    json_array_foreach (source->claims, i, claim) {
        const char *key = json_string_value(json_object_get(claim, "key"));
        if (strcmp(key, "best") == 0 || strncmp(key, "same", 4) == 0)
            return true;
    }
    return false;
}

static void put_table(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    const struct scene *scene = results->scene;
    const bool lettered = results->usable_count > 2 && ranking_is_told(source) &&
                          source->comparison->criterion == source->asked.quantity; /* what the column shows */
    json_t *rows = view_list(out, "rows");
    for (size_t i = 0; i < results->surface_count; i++)
        if (results->surfaces[i].summary.usable && json_array_size(rows) < VIEW_ROWS)
            put_row(out, view_item(rows), source, i, lettered);
    for (size_t l = 0; l < scene->limit_count && l < ASKED_LIMIT_COLUMNS; l++) {
        char text[UNIT_LENGTH + 20];
        json_t *head = view_item(view_list(out, "limit_heads"));
        asked_text(text, sizeof text, scene->limits[l].text);
        if (scene->limits[l].quantity != source->asked.quantity) /* else it is the column's before */
            view_text(head, "symbol", scene->limits[l].symbol);
        view_text(head, "sign", scene->limits[l].is_most ? "≤" : "≥");
        view_text(head, "text", text);
    }
    view_flag(out, "has_letters", lettered);
    if (results->usable_count > VIEW_ROWS)
        json_set_count(out, "rows_left_out", results->usable_count - VIEW_ROWS);
}

void view_first_page(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    const struct asked *asked = &source->asked;
    const struct asked_load as = asked_load_of(results, results->baseline);
    size_t i;
    json_t *claim, *first = view_list(out, "claims"), *more = view_list(out, "more_claims");
    json_object_set(out, "headline", source->headline);
    json_array_foreach (source->claims, i, claim) {
        json_array_append(i < CLAIMS_MOST ? first : more, claim);
    }
    view_flag(out, "several", results->usable_count > 1);
    view_text(out, "leading", model_rows[source->leading]->label);
    view_text(out, "leading_does", model_rows[source->leading]->does);
    view_text(out, "baseline", view_name(source, results->baseline));
    view_load(out, "operating_load", source, results->baseline, results_operating_load(results, results->baseline));
    json_t *item = view_part(out, "asked");
    view_text(item, "symbol", words_say(source->words, "%s", asked->name));
    view_text(item, "unit", asked->unit);
    if (asked->target) {
        char unit[UNIT_LENGTH + 20];
        asked_text(unit, sizeof unit, asked->target->text);
        view_text(out, "target", unit);
    }
    view_text(out, "load_unit", as.unit[0] ? as.unit : "P/(Aₙ E′)");
    view_text(out, "load_kind", !as.unit[0] ? "" : words_say(source->words, as.force ? "load.force" : "load.pressure"));
    put_table(out, source);
}

size_t view_limits_of(struct text *out, const struct results *results, struct words *words, bool missed)
{
    size_t count = 0;
    for (size_t i = 0; i < results->surface_count; i++)
        for (size_t l = 0; l < results->scene->limit_count && results->surfaces[i].summary.usable; l++) {
            const struct scene_asked *limit = &results->scene->limits[l];
            const struct limit_check *check = &results->surfaces[i].summary.limits[l];
            bool swapped = limit->is_upper != limit->is_most; /* a reciprocal's ends */
            if (check->verdict == LIMIT_MET || (check->verdict == LIMIT_MISSED) != missed)
                continue;
            json_auto_t *view = json_object();
            view_text(view, "surface", results->surfaces[i].summary.scene->name);
            view_text(view, "symbol", limit->symbol);
            view_text(view, "sign", limit->is_most ? "≤" : "≥");
            view_text(view, "text", limit->text);
            view_text(view, "unit", limit->unit_text);
            json_set(view, "value", scene_asked_shown(limit, check->value));
            view_range(view, "interval", scene_asked_shown(limit, swapped ? check->high : check->low),
                       scene_asked_shown(limit, swapped ? check->low : check->high));
            (void)words_fill(out, words, missed ? "limit.missed" : "limit.undecided", view, NULL);
            text_add(out, "\n");
            count++;
        }
    return count;
}
