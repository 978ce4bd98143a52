/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The models that the thesis has not, beside its four, on the baseline surface. */
#include "report/section.h"

#include <math.h>

/** Which model the others are held against: of the leading family, elastic or plastic as the other is. */
static size_t yardstick(const struct section_context *context, bool plastic)
{
    size_t leading = context->comparison->leading, elastic = model_index(model_rows[leading]->elastic);
    return elastic < model_count && !plastic ? elastic : leading;
}

/** Value of model `m` over that of model `by` at a load, as shown; NaN where either is empty. */
static double ratio(const struct section_context *context, size_t m, size_t by, enum quantity quantity, double load)
{
    double values[2] = {NAN, NAN};
    const size_t models[2] = {m, by};
    for (int i = 0; i < 2; i++) {
        const struct model_curve *curve = &context->baseline->curves[models[i]];
        for (size_t p = 0; p < curve->count; p++)
            if (curve->points[p].value[QUANTITY_LOAD] == load)
                values[i] = comparison_value(&curve->points[p], quantity, models[i],
                                             context->baseline->summary.asperities.sigma_m);
    }
    return values[0] / values[1];
}

static const enum quantity compared[] = {QUANTITY_AREA, QUANTITY_SEPARATION, QUANTITY_ECR};
enum { COMPARED = sizeof compared / sizeof *compared };

static void ratio_row(struct text *out, const struct section_context *context, size_t m, double load)
{
    size_t by = yardstick(context, model_rows[m]->plastic);
    if (!context->baseline->curves[m].exists || m == by)
        return;
    text_add(out, "| ");
    section_load(out, context->results, context->results->baseline, load);
    text_add(out, " | %s", model_rows[m]->label);
    text_add(out, " | %s", model_rows[by]->label);
    for (int q = 0; q < COMPARED; q++)
        if (section_computes(context, compared[q])) {
            double value = ratio(context, m, by, compared[q], load);
            section_cell(out, isfinite(value) ? value : NAN, 3);
        }
    text_add(out, " |\n");
}

static void ratio_table(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    struct text rule = {0};
    text_add(out, "| ");
    section_load_symbol(out, results);
    text_add(out, " | model | over");
    text_add(&rule, "|---:|---|---|");
    for (int q = 0; q < COMPARED; q++)
        if (section_computes(context, compared[q])) {
            text_add(out, " | %s", quantity_rows[compared[q]].short_symbol);
            text_add(&rule, "---:|");
        }
    text_add(out, " |\n%s\n", text_string(&rule));
    text_free(&rule);
    for (size_t k = 1; k <= 3; k++) {
        const double *loads = results_loads(results, results->baseline);
        double load = loads[section_table_load(results, k)];
        if (k > 1 && load == loads[section_table_load(results, k - 1)])
            continue;
        for (size_t m = 0; m < model_count; m++)
            ratio_row(out, context, m, load);
    }
}

static void introduction(struct text *out, const struct section_context *context)
{
    size_t leading = context->comparison->leading, elastic = yardstick(context, false);
    section_named(out, "Surface ", context->results, context->results->baseline);
    text_add(out, " in every model that ran. ");
    if (elastic != leading)
        text_add(out, "%s: %s. ", model_rows[elastic]->label, model_rows[elastic]->valid);
    text_add(out,
             "%s: %s. What lies outside is left empty. The table gives the other models over these, at three loads.",
             model_rows[leading]->label, model_rows[leading]->valid);
}

static void caption(struct text *out, const struct section_context *context, const struct figure *figure)
{
    struct comparison_extremes models = section_models(context, figure->row->y, false);
    section_cut(out, context, figure);
    if (models.count == 0)
        return;
    section_at_middle(out, context, figure->row->y, models.least);
    if (models.count > 1) {
        text_add(out, " (%s)", model_rows[models.least_at]->label);
        section_to(out, figure->row->y, models.most);
        text_add(out, " (%s)", model_rows[models.most_at]->label);
    }
    text_add(out, ".");
}

static bool called_for(const struct section_context *context)
{
    return plan_beyond_thesis(context->results->plan);
}

static void write(struct text *out, const struct section_context *context)
{
    const char *title = model_rows[context->comparison->leading]->family_title;
    text_add(out, "## %s\n\n", title ? title : "Models beyond the thesis");
    introduction(out, context);
    text_add(out, "\n\n");
    ratio_table(out, context);
    text_add(out, "\n");
    section_figures(out, context, "beyond thesis", caption);
}

const struct section section_beyond_thesis = {"beyond thesis", called_for, write};
