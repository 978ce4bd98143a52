/* What each figure shows, in one sentence, with its numbers. */
#include "report/section.h"

#include "base/number_format.h"
#include "chart/figure.h"
#include <math.h>
#include <string.h>

/** A quantity as a caption names it. */
static const struct quantity_words {
    enum figure_axis axis;
    const char *name, *unit;
} quantities[] = {
    [COMPARISON_AREA] = {FIGURE_AREA, "A/Aₙ is ", ""},
    [COMPARISON_SEPARATION] = {FIGURE_SEPARATION, "the separation is ", " σ"},
    [COMPARISON_ECR] = {FIGURE_ECR, "ECR·Aₙ is ", " Ω·m²"},
    [COMPARISON_TCR] = {FIGURE_TCR, "TCR·Aₙ is ", " K·m²/W"},
};

static enum comparison_quantity quantity_of(const struct figure_row *row)
{
    for (int q = 0; q < COMPARISON_QUANTITY_COUNT; q++)
        if (quantities[q].axis == row->y)
            return (enum comparison_quantity)q;
    return COMPARISON_AREA;
}

static void at_middle(struct text *out, const struct section_context *context)
{
    text_add(out, " At P/(Aₙ E′) = ");
    number_format_power(out, context->study->middle_load, 3);
    text_add(out, ", ");
}

/** "0.18 (surface 4) to 0.31 (surface 1)." */
static void surfaces_range(struct text *out, const struct section_context *context, const struct figure_row *row)
{
    enum comparison_quantity quantity = quantity_of(row);
    const struct comparison_extremes *extremes = &context->study->extremes[row->model][quantity];
    if (extremes->count == 0)
        return;
    at_middle(out, context);
    number_format_add(out, quantities[quantity].name, extremes->least, 3, quantities[quantity].unit);
    if (extremes->least < extremes->most) {
        text_add(out, " (");
        section_named(out, "surface ", context->results, extremes->least_at);
        number_format_add(out, ") to ", extremes->most, 3, quantities[quantity].unit);
        text_add(out, " (");
        section_named(out, "surface ", context->results, extremes->most_at);
        text_add(out, ")");
    }
    if (extremes->count < context->results->usable_count)
        text_add(out, "; %zu of %zu surfaces, the others are past full contact or without a solution", extremes->count,
                 context->results->usable_count);
    text_add(out, ".");
}

/** Separation against area: what is left of it where A = Aₙ. */
static void left_at_full(struct text *out, const struct section_context *context, enum model_id model)
{
    double least = INFINITY, most = -INFINITY;
    if (model_rows[model].family == SCENE_MODEL_STATISTICAL) {
        text_add(out, " β makes every curve end at 0 where A = Aₙ.");
        return;
    }
    for (size_t k = 0; k < context->results->usable_count; k++) {
        const struct curve_summary *s = &section_surface(context, context->results->by_roughness[k])->models[model];
        if (s->exists && isfinite(s->gap_at_full)) {
            least = fmin(least, s->gap_at_full);
            most = fmax(most, s->gap_at_full);
        }
    }
    if (least > most) {
        text_add(out, " No surface reaches A = Aₙ within the loads.");
    } else if (most < 1e-3) {
        text_add(out, " Less than 0.001 σ is left where A = Aₙ.");
    } else {
        text_add(out, " Where A = Aₙ first holds, ");
        number_format_range(out, fmax(least, 0), most, 2);
        text_add(out, " σ are left.");
    }
}

static void models_range(struct text *out, const struct section_context *context, const struct figure_row *row)
{
    enum comparison_quantity quantity = quantity_of(row);
    struct comparison_extremes models = section_models(context, quantity);
    bool statistical = section_called_for(context, MODEL_GW);
    if (row->y == FIGURE_SEPARATION && statistical)
        text_add(out, " Bold with squares: adjusted by (4.54); thin: the statistical models' own separation.");
    if (row->y == FIGURE_TCR && plan_runs(context->results->plan, EFFECT_SCALE_DEPENDENT))
        text_add(out, " Small crosses: scale-dependent, hidden by the plain curve where they differ little.");
    if (row->x != FIGURE_LOAD || models.count == 0)
        return;
    at_middle(out, context);
    number_format_add(out, quantities[quantity].name, models.least, 3, quantities[quantity].unit);
    if (models.count > 1) {
        text_add(out, " (%s)", model_rows[models.least_at].label);
        number_format_add(out, " to ", models.most, 3, quantities[quantity].unit);
        text_add(out, " (%s)", model_rows[models.most_at].label);
    }
    text_add(out, ".");
}

/** How far the area falls from the first scale to the last, over the sweep's values. */
static void sweep_range(struct text *out, const struct section_context *context, const struct figure_row *row)
{
    const struct results *results = context->results;
    const struct convergence_sweep_row *sweep = &convergence_sweeps[row->sweep];
    size_t settled = 0;
    for (size_t v = 0; v < sweep->count; v++)
        settled += comparison_converges(results, row->sweep, model_rows[row->model].plastic, v);
    text_add(out, " %zu of %zu curves have settled; curves of complete contact lie on each other at 1.", settled,
             sweep->count);
}

/** Does the chart hold a setting that the report uses? */
static bool is_marked(const struct benchmark *cost, enum benchmark_chart chart)
{
    for (size_t i = 0; i < cost->count; i++)
        if (cost->rows[i].chart == chart && cost->rows[i].chosen)
            return true;
    return false;
}

void section_caption(struct text *out, const struct section_context *context, const struct figure_row *row)
{
    text_add(out, "%s", row->title);
    if (row->kind == FIGURE_MODELS) {
        text_add(out, ", ");
        section_named(out, "surface ", context->results, context->results->baseline);
    }
    text_add(out, ".");
    switch (row->kind) {
    case FIGURE_SWEEP:
        sweep_range(out, context, row);
        break;
    case FIGURE_MODELS:
        models_range(out, context, row);
        break;
    case FIGURE_SURFACES:
        if (row->x == FIGURE_AREA)
            left_at_full(out, context, row->model);
        else
            surfaces_range(out, context, row);
        break;
    case FIGURE_PROFILES:
        text_add(out, " Levelled heights; each panel has its own height scale.");
        break;
    case FIGURE_SPECTRA:
        text_add(out, " Solid: the law over the wavelengths it was fitted to; dashed: carried on beyond them.");
        break;
    case FIGURE_COST:
        text_add(out, " Lower left is better%s.",
                 is_marked(context->results->cost, row->cost) ? "; ringed: what this report uses" : "");
        break;
    }
}
