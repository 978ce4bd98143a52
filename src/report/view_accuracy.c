/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What accuracy costs, which effects ran and why, how hard cases were kept stable: the user's three questions. */
#include "report/view.h"

#include <math.h>
#include <string.h>

/** "12 ms", "1.4 s", "3 min". */
static void put_seconds(json_t *out, const char *name, double seconds)
{
    if (seconds < 0.995)
        view_number(out, name, seconds * 1e3, 2, "ms");
    else if (seconds < 120)
        view_number(out, name, seconds, 2, "s");
    else
        view_number(out, name, seconds / 60, 2, "min");
}

/** What the whole report would take at other tolerances: the curves' time as measured, the rest as it was. */
static void put_tolerances(json_t *out, const struct view_source *source)
{
    const struct benchmark *cost = source->results->benchmark;
    const struct benchmark_row *own = NULL;
    json_t *list = view_list(out, "tolerances");
    for (size_t i = 0; i < cost->count; i++)
        if (strcmp(cost->rows[i].study, "tolerance") == 0 &&
            fabs(log(cost->rows[i].setting / source->results->scene->tolerance)) < 0.01)
            own = &cost->rows[i];
    const char *first = NULL;
    bool alike = true;
    double rest = own && cost->before > own->seconds ? cost->before - own->seconds : 0;
    for (size_t i = cost->count; i-- > 0;)
        if (strcmp(cost->rows[i].study, "tolerance") == 0) {
            json_t *item = view_item(list);
            view_number(item, "tolerance", cost->rows[i].setting, 1, "");
            put_seconds(item, "curves", cost->rows[i].seconds);
            put_seconds(item, "report", rest + cost->rows[i].seconds);
            view_flag(item, "used", &cost->rows[i] == own);
            const char *report = json_string_value(json_object_get(item, "report"));
            first = first ? first : report;
            alike = alike && strcmp(first, report) == 0;
        }
    if (first && alike)
        view_text(out, "report_alike", first);
    view_separate(list);
    for (size_t i = 0; i < cost->count; i++)
        if (strcmp(cost->rows[i].method, "Simpson") == 0 && cost->rows[i].setting == 1000)
            view_number(out, "simpson_error", cost->rows[i].error, 2, "");
}

static void put_effects(json_t *out, const struct view_source *source)
{
    struct work_row rows[WORK_ROWS];
    const struct results *results = source->results;
    json_t *list = view_list(out, "effects"), *skipped = NULL;
    work_account(rows, results);
    for (int r = 0; r < WORK_ROWS; r++) {
        json_t *item = view_item(list);
        view_text(item, "name", rows[r].name);
        view_flag(item, "runs", rows[r].runs);
        view_text(item, "reason", rows[r].reason);
        if (skipped && !rows[r].runs)
            view_flag(skipped, "more_skipped", true);
        skipped = rows[r].runs ? skipped : item;
        if (results->benchmark && rows[r].runs && rows[r].seconds > 0)
            put_seconds(item, "time", rows[r].seconds);
    }
    view_flag(out, "any_skipped", skipped != NULL);
}

/** Numbers that were limited, clamped or refused, and on which surface most. */
static void put_stability(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    uint64_t limited = 0, most_limited = 0;
    size_t on = 0, outside = 0, refused_scans = 0, refused = 0, unsolved[2] = {0};
    double clamped = 0;
    for (size_t i = 0; i < results->surface_count; i++) {
        const struct surface_summary *s = view_summary(source, i);
        uint64_t own = 0;
        refused += !s->usable;
        refused_scans += s->refused_scans;
        for (int k = 0; k < 2; k++)
            unsolved[k] += s->strip_unsolved[k];
        for (size_t m = 0; m < model_count && s->usable; m++) {
            const struct curve_summary *curve = surface_model(s, m);
            if (!curve->exists)
                continue;
            own += curve->clamped;
            clamped = fmax(clamped, curve->most_radius_clamped);
            outside += !curve_summary_is_valid(curve, results_operating_load(results, i));
        }
        limited += own;
        if (own > most_limited) {
            most_limited = own;
            on = i;
        }
    }
    json_t *item = view_part(out, "stability");
    view_counted(item, "limited", limited, NULL);
    if (limited > 0)
        view_text(item, "limited_on", view_name(source, on));
    if (clamped > 1e-4)
        view_number(item, "clamped_percent", 100 * clamped, 2, "");
    view_counted(item, "outside", outside, NULL);
    view_counted(item, "unsolved_loads", unsolved[0], NULL);
    view_counted(item, "unsolved_scans", unsolved[1], NULL);
    view_counted(item, "refused", refused, NULL);
    view_counted(item, "refused_scans", refused_scans, NULL);
    view_flag(item, "nothing",
              limited == 0 && !(clamped > 1e-4) && refused + refused_scans + unsolved[0] + unsolved[1] == 0);
}

void view_accuracy(json_t *out, const struct view_source *source)
{
    view_number(out, "tolerance", source->results->scene->tolerance, 1, "");
    if (source->results->benchmark)
        put_tolerances(view_part(out, "accuracy"), source);
    put_effects(out, source);
    put_stability(out, source);
}
