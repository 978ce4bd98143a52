/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What accuracy costs, which effects ran and why, how hard cases were kept stable: the user's three questions. */
#include "report/view.h"

#include "results/accuracy.h"
#include <math.h>

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

/** Each model's error of what is asked, and its time. */
static void put_models(json_t *out, const struct view_source *source)
{
    const enum quantity quantity = source->asked.quantity;
    json_t *rows = view_list(out, "models");
    view_text(out, "quantity",
              words_say(source->words, "%s", quantity_of_joint(quantity) ? "asked.spots" : source->asked.name));
    double finest = 0, coarsest = 0;
    for (size_t m = 0; m < model_count; m++) {
        const struct accuracy accuracy = accuracy_of(source->results, m, quantity);
        if (accuracy.sd == 0)
            continue;
        json_t *row = view_item(rows);
        if (isnan(accuracy.sd)) /* it took its time even so */
            view_flag(out, "unknown", true);
        else if (model_rows[m]->uses_map)
            view_flag(out, "map", true);
        view_text(row, "label", model_rows[m]->label);
        json_set(row, "factor", model_factor(accuracy.sd));
        json_set(row, "here", accuracy.here);
        put_seconds(row, "time", accuracy.seconds[accuracy.used]);
        coarsest += accuracy.seconds[0];
        finest += accuracy.seconds[BENCHMARK_STEPS - 1];
    }
    view_flag(out, "low_pass", source->results->surfaces[source->results->baseline].tiles.def.cutoff > 0);
    view_flag(out, "solved_here", results_direct_baseline(source->results) != NULL);
    const double few_waves = accuracy_few_waves_sd(source->results, source->results->baseline);
    if (few_waves > log(1.05))
        json_set(out, "few_waves", model_factor(few_waves));
    if (finest > coarsest) /* two timings: the finer may happen to be faster */
        put_seconds(out, "digits", finest - coarsest);
}

/** By how much an effect that ran changes what is asked. */
static void put_change(json_t *item, const struct view_source *source, enum effect effect)
{
    const double of = accuracy_effect_factor(source->results, effect, source->asked.quantity),
                 factor = source->asked.reciprocal ? 1 / of : of;
    const double change = fabs(factor - 1) < source->results->scene->tolerance ? 0 : factor - 1;
    const bool alike = fabs(change) < 0.1; /* of which two digits of a factor say little */
    view_flag(item, "adds", effect_rows[effect].adds);
    view_flag(item, "studies", effect_rows[effect].studies);
    json_set(item, alike ? "change" : "factor", alike ? change : factor);
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
        if (r > 0 && rows[r].runs)
            put_change(item, source, (enum effect)(r - 1));
        if (skipped && !rows[r].runs)
            view_flag(skipped, "more_skipped", true);
        skipped = rows[r].runs ? skipped : item;
        if (results->benchmark && rows[r].runs && rows[r].seconds > 0)
            put_seconds(item, "time", rows[r].seconds);
    }
    view_flag(out, "any_skipped", skipped != NULL);
}

/** Numbers that were limited, clamped or left out. */
static void put_stability(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    uint64_t limited = 0;
    size_t outside = 0, unsolved[2] = {0};
    double clamped = 0;
    for (size_t i = 0; i < results->surface_count; i++) {
        const struct surface_summary *s = view_summary(source, i);
        for (int k = 0; k < 2; k++)
            unsolved[k] += s->strip_unsolved[k];
        for (size_t m = 0; m < model_count && s->usable; m++) {
            const struct curve_summary *curve = surface_model(s, m);
            if (!curve->exists)
                continue;
            limited += curve->clamped;
            clamped = fmax(clamped, curve->most_radius_clamped);
            outside += isfinite(curve->operating.value[QUANTITY_AREA]) &&
                       !curve_summary_is_valid(curve, results_operating_load(results, i));
        }
    }
    json_t *item = view_part(out, "stability");
    view_counted(item, "limited", limited, NULL);
    if (clamped > 1e-4)
        json_set(item, "clamped", clamped);
    view_counted(item, "outside", outside, NULL);
    view_counted(item, "unsolved_loads", unsolved[0], NULL);
    view_counted(item, "unsolved_scans", unsolved[1], NULL);
    view_flag(item, "nothing", limited == 0 && !(clamped > 1e-4));
}

void view_accuracy(json_t *out, const struct view_source *source)
{
    json_set(out, "tolerance", source->results->scene->tolerance);
    if (source->results->benchmark)
        put_models(view_part(out, "accuracy"), source);
    put_effects(out, source);
    put_stability(out, source);
}
