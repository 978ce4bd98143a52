/* SPDX-License-Identifier: GPL-3.0-or-later */
/* All surfaces, model by model (thesis 6.4). */
#include "report/section.h"

#include <math.h>

static void shown_text(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    if (results->usable_count == 1) {
        text_add(out, "There is one surface, so these charts show it alone, model by model.");
        return;
    }
    text_add(out,
             "A surface has the same colour in every chart, and a quantity the same axis. Where curves lie on each "
             "other their colours alternate.");
    if (results->shown_count < results->usable_count)
        text_add(
            out,
            " The charts show %zu of the %zu surfaces, spread evenly from the smoothest to the roughest; tables and "
            "data hold all of them.",
            results->shown_count, results->usable_count);
    if (results->plan->running & (EFFECT_BIT(EFFECT_ELECTRICAL) | EFFECT_BIT(EFFECT_THERMAL)))
        text_add(out, " Axes of resistance end where A/Aₙ passes 0.99, and curves leave through the lower edge at "
                      "full contact, where resistance is 0.");
}

static void full_contact_note(struct text *out, const struct section_context *context)
{
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(context->results->plan, m) && model_rows[m]->plastic && model_rows[m]->stacks_scales &&
            section_computes(context, QUANTITY_SEPARATION)) {
            text_add(out,
                     " (the published elastic-plastic area gets there before the last gap closes: see the checks)");
            return;
        }
}

static void surface_full(struct text *out, const struct section_context *context, size_t index)
{
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(context->results->plan, m)) {
            const struct curve_summary *model = surface_model(section_surface(context, index), m);
            section_load_cell(out, context, index, model->exists ? model->full_load : NAN);
        }
}

static void full_table(struct text *out, const struct section_context *context)
{
    struct text rule = {0};
    text_add(out, "| surface");
    text_add(&rule, "|---|");
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(context->results->plan, m)) {
            text_add(out, " | %s", model_rows[m]->label);
            text_add(&rule, "---:|");
        }
    text_add(out, " |\n%s\n", text_string(&rule));
    text_free(&rule);
    section_each_surface(out, context, surface_full);
}

/** Beta of every model that adjusts its separation, in either estimate. */
static bool adjusts(const struct section_context *context, size_t m)
{
    return plan_runs_model(context->results->plan, m) && (model_rows[m]->quantities & QUANTITY_BIT(QUANTITY_ADJUSTED));
}

static void surface_6_3(struct text *out, const struct section_context *context, size_t index)
{
    for (int nearest = 0; nearest < 2; nearest++)
        for (size_t m = 0; m < model_count; m++) {
            const struct curve_summary *model = surface_model(section_surface(context, index), m);
            if (adjusts(context, m))
                section_cell(out, !model->exists ? NAN : nearest ? model->beta_multiscale : model->beta, 3);
        }
}

static void table_6_3(struct text *out, const struct section_context *context)
{
    struct text rule = {0};
    text_add(out, "| surface");
    text_add(&rule, "|---|");
    for (int nearest = 0; nearest < 2; nearest++)
        for (size_t m = 0; m < model_count; m++)
            if (adjusts(context, m)) {
                text_add(out, nearest ? " | %s, nearest multiscale" : " | β %s", model_rows[m]->label);
                text_add(&rule, "---:|");
            }
    text_add(out, " |\n%s\n", text_string(&rule));
    text_free(&rule);
    section_each_surface(out, context, surface_6_3);
}

static void beta_text(struct text *out, const struct section_context *context)
{
    size_t negative = 0, below = 0, above = 0;
    for (size_t k = 0; k < context->results->usable_count; k++)
        for (size_t m = 0; m < model_count; m++) {
            const struct curve_summary *model = surface_model(section_smoothest(context, k), m);
            if (!model->exists || !adjusts(context, m))
                continue;
            negative += model->beta < 0;
            below += model->beta >= 0 && model->beta < 4;
            above += model->beta > 12;
        }
    if (negative + below + above == 0) {
        text_add(out, "Every β lies in the expected 4…12.");
        return;
    }
    text_add(out, "Outside 4…12:");
    if (negative > 0)
        text_add(out, " %zu negative (the asperities fill the nominal area before the flat reaches the mean plane);",
                 negative);
    if (below > 0)
        text_add(out, " %zu between 0 and 4 (full contact within 2σ below the mean plane: many or blunt asperities);",
                 below);
    if (above > 0)
        text_add(out,
                 " %zu above 12 (full contact only below −6σ: few or sharp asperities, where GW's asperities no longer "
                 "describe the surface);",
                 above);
    out->length--; /* the last semicolon */
    text_add(out, ".");
}

/** "0.18 (surface 4) to 0.31 (surface 1)." */
static void surfaces_range(struct text *out, const struct section_context *context, const struct figure *figure)
{
    enum quantity y = figure->row->y;
    const struct comparison_extremes *extremes = &context->comparison->models[figure->model].extremes[y];
    if (extremes->count == 0)
        return;
    section_at_middle(out, context, y, extremes->least);
    if (extremes->least < extremes->most) {
        text_add(out, " (");
        section_named(out, "surface ", context->results, extremes->least_at);
        text_add(out, ")");
        section_to(out, y, extremes->most);
        text_add(out, " (");
        section_named(out, "surface ", context->results, extremes->most_at);
        text_add(out, ")");
    }
    if (extremes->count < context->results->usable_count)
        text_add(out, "; %zu of %zu surfaces, the others are past full contact or without a solution", extremes->count,
                 context->results->usable_count);
    text_add(out, ".");
}

static double gap_at_full(const struct curve_summary *summary)
{
    return summary->gap_at_full;
}

/** Separation against area: what is left of it where A = Aₙ. */
static void left_at_full(struct text *out, const struct section_context *context, size_t model)
{
    static const double closed = 1e-3; /* σ; less counts as closed */
    double least, most;
    if (model_shown(model_rows[model], QUANTITY_SEPARATION) == QUANTITY_ADJUSTED) {
        text_add(out, " β makes every curve end at 0 where A = Aₙ.");
    } else if (!section_range(&least, &most, context, model, gap_at_full)) {
        text_add(out, " No surface reaches A = Aₙ within the loads.");
    } else if (most < closed) {
        text_add(out, " Less than 0.001 σ is left where A = Aₙ.");
    } else {
        text_add(out, " Where A = Aₙ first holds, ");
        number_format_range(out, fmax(least, 0), most, 2);
        text_add(out, " σ are left.");
    }
}

void section_all_surfaces_caption(struct text *out, const struct section_context *context, const struct figure *figure)
{
    if (figure->row->x == QUANTITY_AREA)
        left_at_full(out, context, figure->model);
    else
        surfaces_range(out, context, figure);
}

/** The parts of the section: heading, quantity it needs, and the figures' place. */
static const struct part {
    const char *heading;
    enum quantity quantity;
    const char *place;
    bool with_beta; /* table 6.3 ends it */
} parts[] = {
    {"Area against load", QUANTITY_AREA, "surfaces area", false},
    {"Separation against load", QUANTITY_SEPARATION, "surfaces separation", false},
    {"Separation against area", QUANTITY_SEPARATION, "surfaces separation-area", true},
    {"ECR against load", QUANTITY_ECR, "surfaces electrical", false},
    {"TCR against load", QUANTITY_TCR, "surfaces thermal", false},
};

static void write(struct text *out, const struct section_context *context)
{
    text_add(out, "## All surfaces, model by model\n\n");
    shown_text(out, context);
    text_add(out, "\n\n**Load to full contact**, ");
    section_load_symbol(out, context->results);
    text_add(out, " at which A = Aₙ");
    full_contact_note(out, context);
    text_add(out, ".\n\n");
    full_table(out, context);
    for (size_t p = 0; p < sizeof parts / sizeof *parts; p++) {
        if (!section_computes(context, parts[p].quantity))
            continue;
        text_add(out, "\n### %s\n\n", parts[p].heading);
        section_figures(out, context, parts[p].place, section_all_surfaces_caption);
        if (!parts[p].with_beta || !section_computes(context, QUANTITY_ADJUSTED))
            continue;
        text_add(out, "**Table 6.3.** β of the adjusted separation (4.54): the value that makes it 0 where A = Aₙ, and "
                      "the one that brings it closest to the multiscale model of the same material law.\n\n");
        table_6_3(out, context);
        text_add(out, "\n");
        beta_text(out, context);
        text_add(out, "\n\n");
    }
}

const struct section section_all_surfaces = {"all surfaces", NULL, write};
