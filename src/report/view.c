/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report/view.h"

#include "base/number_format.h"
#include "base/version.h"
#include "output/json.h"
#include <math.h>
#include <string.h>

void view_text(json_t *out, const char *name, const char *string)
{
    json_object_set_new(out, name, json_shown(string));
}

static void set_text(json_t *out, const char *name, struct text *text)
{
    if (text->length > 0)
        json_object_set_new(out, name, json_string(text_string(text)));
    text_free(text);
}

/** Adds " unit", shown. */
static void add_unit(struct text *text, const char *unit)
{
    if (!unit[0])
        return;
    text_add(text, "\u00a0");
    text_add_shown(text, unit);
}

void view_number(json_t *out, const char *name, double value, int digits, const char *unit)
{
    struct text text = {0};
    if (!isfinite(value))
        return;
    number_format(&text, value, digits);
    add_unit(&text, unit);
    set_text(out, name, &text);
}

void view_range(json_t *out, const char *name, double least, double most)
{
    if (isfinite(least) && isfinite(most))
        json_object_set_new(out, name, json_pack("{s:f, s:f}", "least", least, "most", most));
}

bool view_interval(json_t *out, double low, double high, int digits, const char *between)
{
    OWNED(text_free) struct text shown = {0};
    const bool told = number_format_range(&shown, low, high, digits, between);
    if (told)
        json_object_set_new(out, "interval", json_string(text_string(&shown)));
    return told;
}

void view_some(json_t *out, const char *name, size_t count)
{
    if (count > 0)
        json_set_count(out, name, count);
}

void view_counted(json_t *out, const char *name, size_t count, const char *only)
{
    if (count == 0)
        return;
    json_t *part = view_part(out, name);
    json_set_count(part, "count", count);
    view_flag(part, "one", count == 1);
    if (count == 1 && only)
        view_text(part, "surface", only);
}

void view_flag(json_t *out, const char *name, bool flag)
{
    json_object_set_new(out, name, json_boolean(flag));
}

json_t *view_item(json_t *array)
{
    json_t *item = json_object();
    json_array_append_new(array, item);
    return item;
}

json_t *view_part(json_t *out, const char *name)
{
    json_t *part = json_object();
    json_object_set_new(out, name, part);
    return part;
}

json_t *view_list(json_t *out, const char *name)
{
    json_t *list = json_object_get(out, name);
    if (list)
        return list;
    list = json_array();
    json_object_set_new(out, name, list);
    return list;
}

json_t *view_alike(const json_t *list, const char *part, const json_t *other)
{
    size_t i;
    json_t *item;
    json_array_foreach (list, i, item) {
        if (json_equal(part ? json_object_get(item, part) : item, other))
            return item;
    }
    return NULL;
}

void view_load(json_t *out, const char *name, const struct view_source *source, size_t surface, double load)
{
    const struct asked_load as = asked_load_of(source->results, surface);
    struct text text = {0};
    if (!isfinite(load))
        return;
    if (!as.unit[0])
        text_add(&text, "P/(Aₙ\u00a0E′) = ");
    number_format(&text, load * as.scale, 3);
    add_unit(&text, as.unit);
    set_text(out, name, &text);
}

const char *view_name(const struct view_source *source, size_t surface)
{
    return source->results->surfaces[surface].summary.scene->name;
}

const struct surface_summary *view_summary(const struct view_source *source, size_t surface)
{
    return &source->results->surfaces[surface].summary;
}

/** What is to be seen in the picture of a map. */
static void add_map(json_t *figure, const struct view_source *source, size_t surface)
{
    const struct map_contact *contact = &source->results->surfaces[surface].contact;
    view_text(figure, "surface", view_name(source, surface));
    view_load(figure, "load", source, surface, results_operating_load(source->results, surface));
    if (contact->squares > 1)
        json_set_count(figure, "squares", contact->squares);
    view_number(figure, "contact_percent", 100 * contact->touched, 2, "");
    if (contact->flowed > 0)
        view_number(figure, "flowed_percent", 100 * contact->flowed, 2, "");
    json_set_count(figure, "spots", contact->spot_count);
    view_flag(figure, "one_spot", contact->spot_count == 1);
}

/** Charts that were drawn: their files, their numbers in chapter 6, what is to be seen in them. */
static void add_figures(json_t *out, const struct view_source *source, const struct figures *figures)
{
    json_t *list = view_part(out, "figures");
    for (size_t i = 0; i < figures->count; i++) {
        const size_t map = figures->figure[i].map;
        json_t *figure = map > 0 ? view_item(view_list(list, "maps")) : view_part(list, figures->figure[i].name);
        view_text(figure, "name", figures->figure[i].name);
        if (map > 0) {
            add_map(figure, source, map - 1);
            continue;
        }
        view_text(figure, "numbers", figures->figure[i].numbers);
        view_flag(figure, "several_numbers", strchr(figures->figure[i].numbers, ' '));
        for (int n = 0; n < FIGURE_NOTES; n++)
            view_flag(figure, figure_notes[n], figures->figure[i].notes >> n & 1);
        json_set_count(figure, "least_points", FIGURE_FEW_POINTS);
    }
}

enum status_code view_make(json_t **out, const struct results *results, const struct comparison *comparison,
                           json_t *headline, json_t *claims, const struct figures *figures, struct words *words,
                           struct status *status)
{
    struct view_source source = {.results = results,
                                 .comparison = comparison,
                                 .words = words,
                                 .baseline = &results->surfaces[results->baseline],
                                 .asked = asked_of(results),
                                 .headline = headline,
                                 .claims = claims};
    source.leading = plan_leading_model(results->plan);
    static void (*const parts[])(json_t * out, const struct view_source *source) = {
        view_first_page, view_surfaces, view_models, view_joint, view_direct,
        view_accuracy,   view_findings, view_inputs, view_export};
    *out = json_object();
    view_text(*out, "title", results->scene->title);
    view_text(*out, "version", version_string());
    add_figures(*out, &source, figures);
    for (size_t p = 0; p < sizeof parts / sizeof *parts; p++)
        parts[p](*out, &source);
    return status->code;
}
