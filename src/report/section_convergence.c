/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Does the area converge as smaller scales are included? (thesis 6.2) */
#include "report/section.h"

#include <math.h>

/** Is model `m` one of those the study speaks of? */
static bool sweeps(const struct section_context *context, size_t m)
{
    return plan_runs_model(context->results->plan, m) && model_rows[m]->stacks_scales;
}

/** One law's line of the convergence study: for which α, and from which γ up, the area settles. */
static void sweeps_text(struct text *out, const struct results *results, size_t m)
{
    const struct convergence_sweep_row *alphas = &convergence_sweeps[CONVERGENCE_ALPHA];
    const struct convergence_sweep_row *gammas = &convergence_sweeps[CONVERGENCE_GAMMA];
    size_t settled = 0, from = gammas->count;
    for (size_t v = 0; v < alphas->count; v++)
        settled += comparison_converges(results, CONVERGENCE_ALPHA, m, v);
    while (from > 0 && comparison_converges(results, CONVERGENCE_GAMMA, m, from - 1))
        from--;
    text_add(out, "- %s: for %zu of %zu α and for ", section_law(m, "elastic-plastic"), settled, alphas->count);
    if (from == gammas->count)
        text_add(out, "no γ.\n");
    else
        section_given(out, from == 0 ? "every γ from " : "γ from ", gammas->values[from], " up.\n");
}

static void convergence_text(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    const struct scene_convergence *study = &results->scene->convergence;
    text_add(out, "Synthetic spectra Δ = α·λᵞ of %zu scales", study->scales);
    section_given(out, ", longest wavelength ", study->scan_length_m * 1e3, " mm");
    section_given(out, ", at P/(Aₙ E′) = ", study->load, "");
    section_given(out, "; α is varied at γ = ", study->gamma, "");
    section_given(out, ", γ at α = ", study->alpha,
                  ". The area has settled, so that the last halving of the wavelength changes it ");
    text_add(out, "by less than 0.1 %%:\n\n");
    for (size_t m = 0; m < model_count; m++)
        if (sweeps(context, m))
            sweeps_text(out, results, m);
}

static void extension_text(struct text *out, const struct section_context *context)
{
    size_t told = 0;
    for (size_t k = 0; k < context->results->usable_count; k++)
        told += isfinite(section_smoothest(context, k)->tail.gamma) ? 1 : 0;
    if (told == 0) {
        text_add(out, "What the measured surfaces are like below their shortest wavelengths their spectra do not tell: "
                      "too few harmonics are known, or a filter has cut them.");
        return;
    }
    if (!section_extended(context)) {
        text_add(out,
                 "No scale below the sampling limit can take any area from the measured surfaces at that load: their "
                 "spectra fall with γ ≥ 1 there, and the nominal pressure alone exceeds p*.");
        return;
    }
    text_add(
        out,
        "The measured surfaces at that load: the area of their spectra down to the shortest wavelength known (above "
        "cut-off, `fit_band` and what rounding leaves), and by how much it would fall if each went on below along its "
        "own slope there (over its last half decade) ");
    section_given(out, "to ", convergence_atom_m * 1e9, " nm.");
}

static void surface_extension(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = section_surface(context, index);
    section_cell(out, s->tail.gamma, 3);
    section_cell(out, s->length_m / (double)s->tail.count * 1e6, 3);
    for (size_t m = 0; m < model_count; m++) {
        const struct convergence_extension *extension = &surface_model(s, m)->extension;
        if (!sweeps(context, m))
            continue;
        bool known = surface_model(s, m)->exists && extension->scales > 0;
        section_cell(out, known ? extension->area_measured : NAN, 3);
        section_cell(out, known ? 100 * (1 - extension->area_extended / extension->area_measured) : NAN, 2);
    }
}

static void extension_table(struct text *out, const struct section_context *context)
{
    struct text rule = {0};
    text_add(out, "| surface | γ at the short end | shortest wavelength (µm)");
    text_add(&rule, "|---|---:|---:|");
    for (size_t m = 0; m < model_count; m++)
        if (sweeps(context, m)) {
            text_add(out, " | A/Aₙ %s | further fall (%%)", section_law(m, "elastic-plastic"));
            text_add(&rule, "---:|---:|");
        }
    text_add(out, " |\n%s\n", text_string(&rule));
    text_free(&rule);
    section_each_surface(out, context, surface_extension);
}

static void sweep_caption(struct text *out, const struct section_context *context, const struct figure *figure)
{
    const struct convergence_sweep_row *sweep = &convergence_sweeps[figure->row->sweep];
    size_t converged = 0;
    for (size_t v = 0; v < sweep->count; v++)
        converged += comparison_converges(context->results, figure->row->sweep, figure->model, v);
    const struct scene_convergence *study = &context->results->scene->convergence;
    bool alpha = figure->row->sweep == CONVERGENCE_ALPHA;
    section_given(out, " At P/(Aₙ E′) = ", study->load, "");
    section_given(out, alpha ? ", γ = " : ", α = ", alpha ? study->gamma : study->alpha, "");
    text_add(out, ". %zu of %zu curves have settled; curves of complete contact lie on each other at 1.", converged,
             sweep->count);
}

static bool called_for(const struct section_context *context)
{
    return plan_runs(context->results->plan, EFFECT_CONVERGENCE);
}

static void write(struct text *out, const struct section_context *context)
{
    text_add(out, "## Does the area converge as smaller scales are included?\n\n");
    convergence_text(out, context);
    text_add(out, "\n");
    section_figures(out, context, "convergence", sweep_caption);
    extension_text(out, context);
    text_add(out, "\n\n");
    if (section_extended(context))
        extension_table(out, context);
}

const struct section section_convergence = {"convergence", called_for, write};
