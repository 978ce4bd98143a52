/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/work.h"

#include "base/costs.h"
#include "base/text.h"
#include "certainty/uncertainty.h"
#include "plan/direct_plan.h"
#include "plan/effects.h"
#include "results/results.h"
#include <math.h>

/** What a surface's models and the squares of its map took, by material law. */
static void add_models(struct work_row *elastic, struct work_row *plastic, const struct surface_summary *summary)
{
    for (size_t m = 0; m < model_count; m++) {
        const struct curve_summary *model = surface_model(summary, m);
        struct work_row *row = model_rows[m]->plastic ? plastic : elastic;
        row->evaluations += model->evaluations;
        row->seconds += model->seconds;
    }
    for (int kind = 0; kind < 2; kind++) {
        struct work_row *row = kind ? plastic : elastic;
        row->evaluations += summary->tile_transforms[kind];
        row->seconds += summary->times.tiles[kind];
    }
}

/** What an effect would change: nothing else, nothing at all, or as much as a solve says. "": it is skipped, by a bound
 * that its reason has or for what the scene lacks. */
static const char *change_of(struct words *words, enum effect effect, bool runs)
{
    const struct effect_row *row = &effect_rows[effect];
    return row->adds      ? words_say(words, "changes.no_other")
           : row->studies ? words_say(words, "changes.none")
           : runs         ? words_say(words, "changes.solve")
                          : "";
}

void work_account(struct work_row rows[WORK_ROWS], const struct results *results)
{
    const struct plan *plan = results->plan;
    const struct work_studies *studies = &results->studies;
    rows[0] = (struct work_row){.name = "area", .runs = true, .reason = plan->area_reason, .changes = ""};
    for (enum effect e = 0; e < EFFECT_COUNT; e++)
        rows[e + 1] = (struct work_row){.name = effect_rows[e].name,
                                        .runs = plan_runs(plan, e),
                                        .reason = plan->reasons[e],
                                        .changes = change_of(plan->words, e, plan_runs(plan, e))};
    struct work_row *convergence = &rows[1 + EFFECT_CONVERGENCE], *direct = &rows[1 + EFFECT_DIRECT],
                    *uncertainty = &rows[1 + EFFECT_UNCERTAINTY];
    convergence->evaluations = studies->sweep_scales;
    convergence->seconds = studies->sweep_seconds;
    direct->evaluations = studies->contacts;
    direct->seconds = studies->contact_seconds;
    for (size_t i = 0; i < results->surface_count; i++) {
        const struct surface_summary *summary = &results->surfaces[i].summary;
        add_models(&rows[0], &rows[1 + EFFECT_PLASTICITY], summary);
        rows[0].evaluations += summary->strip_transforms;
        rows[0].seconds += summary->times.strips;
        convergence->seconds += summary->times.convergence;
        uncertainty->evaluations += summary->simulated_evaluations;
        uncertainty->seconds += summary->times.uncertainty;
    }
}

uint64_t work_table(struct text *out, const struct results *results, bool done)
{
    enum { WIDTH = 80, INDENT = 26 };
    uint64_t evaluations = 0;
    struct work_row rows[WORK_ROWS];
    struct words *words = results->plan->words;
    work_account(rows, results);
    text_add(out, "%s\n", words_say(words, done ? "plan.done" : "plan.effects"));
    for (int r = 0; r < WORK_ROWS; r++) {
        text_add(out, "%-16s %-8s", rows[r].name, words_say(words, rows[r].runs ? "plan.run" : "plan.skipped"));
        if (done)
            text_add(out, " %12llu %10.4f", (unsigned long long)rows[r].evaluations, rows[r].seconds);
        OWNED(text_free) struct text why = {0};
        text_add_shown(&why, rows[r].reason); /* may name a surface */
        text_add(&why, "%s%s", done || !rows[r].changes[0] ? "" : "; ", done ? "" : rows[r].changes);
        text_add(out, "  ");
        text_add_wrapped(out, text_string(&why), done ? 1 << 20 : WIDTH, INDENT);
        text_add(out, "\n");
        evaluations += rows[r].evaluations;
    }
    return evaluations;
}

double work_seconds(const struct results *results, size_t threads)
{
    const struct plan *plan = results->plan;
    double sum = 0, longest = 0, direct = 0;
    const double busy = threads >= 2 * results->surface_count ? 2 : 1; /* threads, by what a surface is solved by */
    size_t models = 0;
    for (size_t m = 0; m < model_count; m++)
        models += plan_runs_model(plan, m);
    for (size_t i = 0; i < results->surface_count; i++) {
        const struct surface_summary *summary = &results->surfaces[i].summary;
        bool map = summary->map.nx > 0; /* whose rows speak as one */
        double points = (double)summary->points * (double)summary->scans, transforms = 0;
        double one = costs.surface_s + points * (map ? costs.map_point_s : costs.profile_point_s);
        one += (double)(models * results->load_count) * fmax(1, map ? 1 : (double)summary->scans) * costs.load_s;
        one += plan_runs(plan, EFFECT_SHAPE) ? (double)models * costs.shape_s : 0;
        transforms += summary->has_strips ? summary->strip_cost : 0;
        transforms += summary->has_tiles ? summary->tile_cost : 0;
        one += transforms * costs.transform_s;
        if (plan_runs(plan, EFFECT_UNCERTAINTY) && summary->single_points > 0)
            one += uncertainty_seconds(summary->single_points);
        if (plan_runs(plan, EFFECT_DIRECT) && results_solves(results, i))
            direct += summary->direct->seconds;
        sum += one;
        longest = fmax(longest, one - transforms * costs.transform_s * (1 - 1 / busy));
    }
    return costs.report_s + fmax(sum / (double)threads, longest) + direct / (double)threads;
}
