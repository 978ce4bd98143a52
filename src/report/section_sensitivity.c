/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which results survive another cut-off, another scan length and another hardness. */
#include "report/section.h"

#include <math.h>
#include <stdio.h>

static const double survives = 1.1; /* factor within which an answer counts as unchanged */

static bool is_stable(double factor)
{
    return factor <= survives && factor >= 1 / survives;
}

static bool has(const struct section_context *context, size_t m)
{
    return plan_runs_model(context->results->plan, m);
}

/** Is there a model that the change is one for? */
static bool has_change(const struct section_context *context, int change)
{
    bool any = !sensitivity_changes[change].plastic;
    for (size_t m = 0; m < model_count; m++)
        any |= has(context, m) && model_rows[m]->plastic;
    return any;
}

/** "area within 10 % on 3 of 4 surfaces" for one change; nothing where no surface has a value. */
static void count_stable(struct text *out, const struct section_context *context, size_t m, int change, bool ecr)
{
    size_t stable = 0, all = 0;
    for (size_t k = 0; k < context->results->usable_count; k++) {
        const struct curve_summary *model = surface_model(section_smoothest(context, k), m);
        double factor = !model->exists ? NAN : ecr ? model->sensitivity.ecr[change] : model->sensitivity.area[change];
        all += isfinite(factor);
        stable += is_stable(factor);
    }
    if (all > 0)
        text_add(out, "%s%s on %zu of %zu", ecr ? " and " : "", ecr ? "ECR" : "area", stable, all);
}

static void sentence(struct text *out, const struct section_context *context)
{
    bool electrical = section_computes(context, QUANTITY_ECR);
    for (int c = 0; c < SENSITIVITY_CHANGES; c++) {
        size_t leading = context->comparison->leading;
        if (sensitivity_changes[c].plastic && !model_rows[leading]->plastic)
            continue;
        text_add(out, "%s leaves within 10 %%, in the %s model: ", sensitivity_changes[c].doing,
                 model_rows[leading]->label);
        count_stable(out, context, leading, c, false);
        if (electrical)
            count_stable(out, context, leading, c, true);
        text_add(out, " surfaces. ");
    }
    text_add(
        out,
        "The other way about (cut-off halved, scan doubled, hardness lowered) the inverse factors are to be expected.");
}

static void surface_rows(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = section_surface(context, index);
    bool electrical = section_computes(context, QUANTITY_ECR);
    for (size_t m = 0; m < model_count; m++) {
        const struct sensitivity_factors *factors = &surface_model(s, m)->sensitivity;
        if (!has(context, m) || !surface_model(s, m)->exists)
            continue;
        text_add(out, "| ");
        section_surface_name(out, context->results, index);
        text_add(out, " | %s", model_rows[m]->label);
        for (int c = 0; c < SENSITIVITY_CHANGES; c++) {
            bool none = sensitivity_changes[c].plastic && !model_rows[m]->plastic;
            if (!has_change(context, c))
                continue;
            section_cell(out, !none && isfinite(factors->area[c]) ? factors->area[c] : NAN, 3);
            if (electrical)
                section_cell(out, !none && isfinite(factors->ecr[c]) ? factors->ecr[c] : NAN, 3);
        }
        text_add(out, " |\n");
    }
}

static void table(struct text *out, const struct section_context *context)
{
    bool electrical = section_computes(context, QUANTITY_ECR);
    size_t rows = 0;
    struct text rule = {0};
    text_add(out, "| surface | model");
    for (int c = 0; c < SENSITIVITY_CHANGES; c++) {
        if (!has_change(context, c))
            continue;
        text_add(out, electrical ? " | area, %s | ECR, %s" : " | area, %s", sensitivity_changes[c].heading,
                 sensitivity_changes[c].heading);
        text_add(&rule, electrical ? "---:|---:|" : "---:|");
    }
    text_add(out, " |\n|---|---|%s\n", text_string(&rule));
    text_free(&rule);
    for (size_t i = 0; i < context->results->surface_count && rows < SECTION_ROWS; i++)
        if (section_surface(context, i)->usable) {
            surface_rows(out, context, i);
            rows++;
        }
    if (rows < context->results->usable_count)
        text_add(out, "| … %zu more in data/ |\n", context->results->usable_count - rows);
}

static void caption(struct text *out, const struct section_context *context, const struct figure *figure)
{
    const struct sensitivity_curves *curves = context->results->sensitivity;
    const struct scene *scene = context->results->scene;
    (void)figure;
    text_add(out, " At ");
    section_at_load(out, context->results, context->results->baseline, context->comparison->middle_load);
    if (curves->unsure_m > curves->wavelength_m[SENSITIVITY_WAVELENGTHS - 1] * (1 + 1e-9)) {
        text_add(out, "; shaded: below ");
        number_format(out, curves->unsure_m * 1e6, 3);
        text_add(out, " µm, %s",
                 curves->unsure_m == scene->tip_radius_m ? "the tip's radius"
                 : scene->lambda_s_m > 0                 ? "the cut-off λs"
                                                         : "twice the spacing");
    }
    text_add(out, ".");
}

static bool called_for(const struct section_context *context)
{
    for (size_t k = 0; k < context->results->usable_count; k++)
        for (size_t m = 0; m < model_count; m++)
            if (has(context, m) && isfinite(surface_model(section_smoothest(context, k), m)->sensitivity.area[0]))
                return true;
    return false;
}

static void write(struct text *out, const struct section_context *context)
{
    text_add(out, "## What the answers hang on: cut-off, scan length, hardness\n\n");
    sentence(out, context);
    text_add(out, " Factors on the answer at ");
    section_middle_pressure(out, context);
    text_add(out, " when the heights are low-passed at twice the cut-off, for halves of the scan (their geometric "
                  "mean, over the whole under their window), and for plastic models with hardness and yield strength "
                  "raised by a tenth:\n\n");
    table(out, context);
    text_add(out, "\n");
    section_figures(out, context, "sensitivity", caption);
}

const struct section section_sensitivity = {"sensitivity", called_for, write};
