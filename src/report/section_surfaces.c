/* The surfaces: roughness, spectra and what they stand for. */
#include "report/section.h"

#include <math.h>

static void surfaces_text(struct text *out, const struct section_context *context)
{
    const struct scene *scene = context->results->scene;
    text_add(out,
             "Each profile was levelled (%s) and transformed %s%s. The power law is the least-squares line of log Δ on "
             "log λ",
             level_names[scene->level],
             scene->window == SPECTRUM_WINDOW_HANN ? "under a Hann window" : "without a window",
             plan_stacks_scales(context->results->plan) ? "; every harmonic is a scale of the multiscale models" : "");
    if (scene->fit_band_m[0] > 0 || isfinite(scene->fit_band_m[1])) {
        text_add(out, " for wavelengths ");
        if (scene->fit_band_m[0] > 0)
            section_given(out, "from ", scene->fit_band_m[0] * 1e6, " µm");
        if (isfinite(scene->fit_band_m[1]))
            section_given(out, scene->fit_band_m[0] > 0 ? " to " : "up to ", scene->fit_band_m[1] * 1e6, " µm");
    }
    text_add(out, ".");
    if (plan_uses_asperities(context->results->plan))
        text_add(out, " Moments are %s.",
                 scene->moments == ROUGHNESS_MOMENTS_SPECTRAL
                     ? "those of the spectrum"
                     : "finite differences (slope: central, curvature: 3-point)");
}

static void surface_6_2(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = section_surface(context, index);
    section_cell(out, s->roughness.rq_m * 1e6, 3);
    section_cell(out, s->roughness.ra_m * 1e6, 3);
    section_cell(out, s->length_m * 1e3, 3);
    section_cell(out, s->spacing_m * 1e6, 3);
    text_add(out, " | %zu", s->points);
    section_error_cell(out, s->power_law.alpha, s->power_law.alpha_error);
    section_error_cell(out, s->power_law.gamma, s->power_law.gamma_error);
    section_cell(out, s->power_law.rms_decades, 3);
}

static void surface_asperities(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = section_surface(context, index);
    section_cell(out, s->roughness.m2, 3);
    section_cell(out, s->roughness.m4_per_m2 * 1e-12, 3);
    section_cell(out, s->asperities.nayak, 3);
    section_cell(out, s->asperities.density_per_m2 * 1e-6, 3);
    section_cell(out, s->asperities.radius_m * 1e6, 3);
    section_cell(out, s->asperities.sigma_s_m * 1e6, 3);
    section_cell(out, s->asperities.offset_m * 1e6, 3);
}

static void profiles_caption(struct text *out, const struct section_context *context, const struct figure *figure)
{
    (void)context;
    (void)figure;
    text_add(out, " Levelled heights; each panel has its own height scale.");
}

static void spectra_caption(struct text *out, const struct section_context *context, const struct figure *figure)
{
    (void)context;
    (void)figure;
    text_add(out, " Solid: the law over the wavelengths it was fitted to; dashed: carried on beyond them.");
}

static void write(struct text *out, const struct section_context *context)
{
    text_add(out, "## The surfaces\n\n");
    surfaces_text(out, context);
    text_add(out, "\n\n**Table 6.2.** Roughness and power law Δ = α·λᵞ of each surface (λ in metres, so α is in m¹⁻ᵞ; "
                  "± one standard error).\n\n"
                  "| surface | Rq (µm) | Ra (µm) | length (mm) | spacing (µm) | points | α (SI) | γ | RMS of fit "
                  "(decades) |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|\n");
    section_each_surface(out, context, surface_6_2);
    text_add(out, "\nA Gaussian random surface by itself scatters by ");
    number_format(out, power_law_gaussian_scatter_decades, 3);
    text_add(out, " decades about its law.\n\n");
    section_figures(out, context, "profiles", profiles_caption);
    section_figures(out, context, "power law", spectra_caption);
    if (!plan_uses_asperities(context->results->plan))
        return;
    text_add(out, "Spectral moments and the asperities they stand for: density η, radius R, standard deviation σₛ of "
                  "summit heights and height yₛ of the summits' mean plane above the surface's.\n\n"
                  "| surface | m₂ | m₄ (µm⁻²) | Nayak | η (mm⁻²) | R (µm) | σₛ (µm) | yₛ (µm) |\n"
                  "|---|---:|---:|---:|---:|---:|---:|---:|\n");
    section_each_surface(out, context, surface_asperities);
}

const struct section section_surfaces = {"surfaces", NULL, write};
