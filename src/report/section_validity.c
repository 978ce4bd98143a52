/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the models may be trusted. */
#include "report/section.h"

#include <math.h>

static bool runs(const struct section_context *context, size_t m)
{
    return plan_runs_model(context->results->plan, m);
}

/** Does the model yield scale by scale, so that there are counts of it? */
static bool yields_by_scale(size_t m)
{
    return model_rows[m]->plastic && model_rows[m]->stacks_scales;
}

static void validity_text(struct text *out, const struct section_context *context)
{
    struct text fitted = {0};
    bool yields = false;
    for (size_t m = 0; m < model_count; m++) {
        if (runs(context, m) && model_rows[m]->fitted_to)
            text_add(&fitted,
                     ", and %s's also where more than 10 %% of the load rests on asperities beyond %s, the end of its "
                     "fit",
                     model_rows[m]->label, model_rows[m]->fitted_to);
        yields = yields || (runs(context, m) && yields_by_scale(m));
    }
    if (plan_uses_asperities(context->results->plan))
        text_add(out,
                 "The statistical models take asperities as independent, which needs A ≪ Aₙ; their curves are dashed "
                 "from A/Aₙ = 0.1%s. ",
                 text_string(&fitted));
    text_free(&fitted);
    if (yields)
        text_add(out,
                 "The elastic-plastic sinusoid steps up in area (by at most 8 %%) and down in gap where a scale begins "
                 "to yield; the steps are the published model's and are not smoothed. ");
    text_add(out,
             "A jump between the ends of a record leaks amplitude J/(π n) into harmonic n, which looks like γ = 1: the "
             "share is taken at the short end of the fit band. Loads in the table are ");
    const char *unit = results_load_axis(context->results, context->results->baseline).unit;
    text_add(out, unit ? "in " : "P/(Aₙ E′)");
    text_add_markdown(out, unit ? unit : "");
    text_add(out, ".");
}

/** A share of the load in per cent; 0 where it is too small to matter. */
static void share_cell(struct text *out, const struct curve_summary *model, double share)
{
    section_cell(out, model->exists ? share < 1e-4 ? 0 : 100 * share : NAN, 3);
}

static void surface_validity(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = section_surface(context, index);
    section_cell(out, s->jump_m * 1e6, 3);
    section_cell(out, isfinite(s->jump_share) ? 100 * s->jump_share : NAN, 2);
    for (size_t m = 0; m < model_count; m++)
        if (runs(context, m) && model_rows[m]->largest_area > 0)
            section_threshold_cell(out, context, index, surface_model(s, m),
                                   surface_model(s, m)->exists ? surface_model(s, m)->invalid_area_load : NAN);
    for (size_t m = 0; m < model_count; m++)
        if (runs(context, m) && model_rows[m]->fitted_to) {
            section_threshold_cell(out, context, index, surface_model(s, m),
                                   surface_model(s, m)->exists ? surface_model(s, m)->invalid_fit_load : NAN);
            share_cell(out, surface_model(s, m), surface_model(s, m)->most_beyond_fit);
            share_cell(out, surface_model(s, m), surface_model(s, m)->most_radius_clamped);
        }
    for (size_t m = 0; m < model_count; m++)
        if (runs(context, m) && yields_by_scale(m))
            text_add(out, " | %zu of %zu | at %llu of %llu", surface_model(s, m)->yielding_scales, s->harmonics,
                     (unsigned long long)surface_model(s, m)->clamped,
                     (unsigned long long)(s->harmonics * context->results->load_count));
}

static void validity_table(struct text *out, const struct section_context *context)
{
    struct text rule = {0};
    text_add(out, "| surface | end-to-end jump (µm) | its leak (%% of fit)");
    text_add(&rule, "|---|---:|---:|");
    for (size_t m = 0; m < model_count; m++)
        if (runs(context, m) && model_rows[m]->largest_area > 0) {
            text_add(out, " | %s: A/Aₙ > %g from", model_rows[m]->label, model_rows[m]->largest_area);
            text_add(&rule, "---:|");
        }
    for (size_t m = 0; m < model_count; m++)
        if (runs(context, m) && model_rows[m]->fitted_to) {
            text_add(out, " | %s: 10 %% of load beyond %s from | largest share beyond (%%) | clamped at a/R = 1 (%%)",
                     model_rows[m]->label, model_rows[m]->fitted_to);
            text_add(&rule, "---:|---:|---:|");
        }
    for (size_t m = 0; m < model_count; m++)
        if (runs(context, m) && yields_by_scale(m)) {
            text_add(out, " | scales that can yield | areas limited (scales × loads)");
            text_add(&rule, "---:|---:|");
        }
    text_add(out, " |\n%s\n", text_string(&rule));
    text_free(&rule);
    section_each_surface(out, context, surface_validity);
}

static void write(struct text *out, const struct section_context *context)
{
    text_add(out, "## Where the models may be trusted\n\n");
    validity_text(out, context);
    text_add(out, "\n\n");
    validity_table(out, context);
}

const struct section section_validity = {"validity", NULL, write};
