/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The surfaces: roughness, spectra and what they stand for. */
#include "report/section.h"

#include <math.h>

static bool by_thesis(const struct section_context *context)
{
    return context->results->scene->fit == POWER_LAW_THESIS;
}

/** " from 8 µm to 2000 µm" of the scene. */
static void given_band(struct text *out, const struct scene *scene)
{
    text_add(out, " for wavelengths ");
    if (scene->fit_band_m[0] > 0)
        section_given(out, "from ", scene->fit_band_m[0] * 1e6, " µm");
    if (isfinite(scene->fit_band_m[1]))
        section_given(out, scene->fit_band_m[0] > 0 ? " to " : "up to ", scene->fit_band_m[1] * 1e6, " µm");
}

/** "2 of 3 periodic: no window; 1: Hann": what the scans of all surfaces got; which scan is in the table. */
static void window_text(struct text *out, const struct section_context *context)
{
    size_t scans = 0, periodic = 0, windowed = 0;
    for (size_t k = 0; k < context->results->usable_count; k++) {
        const struct surface_summary *s = section_smoothest(context, k);
        scans += s->scans;
        periodic += s->periodic;
        windowed += s->windowed;
    }
    text_add(out, "%zu of %zu scan%s close%s on %s (by step and slopes across the ends, before levelling). ", periodic,
             scans, scans == 1 ? "" : "s", periodic == 1 ? "s" : "", periodic == 1 ? "itself" : "themselves");
    text_add(out, "Spectrum of the models: ");
    if (windowed < scans)
        text_add(out, "no window for %zu", scans - windowed);
    if (windowed > 0)
        text_add(out, "%sHann × √(8/3) for %zu", windowed < scans ? ", " : "", windowed);
}

static void surfaces_text(struct text *out, const struct section_context *context)
{
    const struct scene *scene = context->results->scene;
    text_add(out, "Each profile was levelled (%s%s). ", level_names[scene->level],
             scene->level_given ? "" : "; mean of one that closes on itself");
    window_text(out, context);
    text_add(out, "%s. ",
             plan_stacks_scales(context->results->plan) ? "; every harmonic is a scale of the multiscale models" : "");
    if (by_thesis(context))
        text_add(out, "The power law is the least-squares line of log Δ on log λ through all harmonics");
    else
        text_add(out, "The power law is fitted to another spectrum: prewhitened sine multitaper, powers averaged over "
                      "scans, mean logarithms in ten bins a decade, weighted by their scatter, ");
    if (!by_thesis(context) && !scene->fit_band_given)
        text_add(out, "in the widest band that is straight");
    if (scene->fit_band_m[0] > 0 || isfinite(scene->fit_band_m[1]))
        if (by_thesis(context) || scene->fit_band_given)
            given_band(out, scene);
    text_add(out, ".");
    if (plan_uses_asperities(context->results->plan))
        text_add(out, " Moments are %s.",
                 scene->moments == ROUGHNESS_MOMENTS_SPECTRAL
                     ? "those of the spectrum"
                     : "finite differences (slope: central, curvature: 3-point), which need no window");
}

static void roughness_cells(struct text *out, const struct surface_summary *s)
{
    section_cell(out, s->roughness.rq_m * 1e6, 3);
    section_cell(out, s->roughness.ra_m * 1e6, 3);
    section_cell(out, s->length_m * 1e3, 3);
    section_cell(out, s->spacing_m * 1e6, 3);
    text_add(out, " | %zu", s->points);
}

/** Is there more than one law? Then their amplitudes stand at one wavelength too. */
static bool compares_laws(const struct section_context *context)
{
    size_t laws = 0;
    for (size_t k = 0; k < context->results->usable_count; k++)
        laws += power_law_holds(&section_smoothest(context, k)->power_law);
    return laws > 1;
}

static void amplitude_cell(struct text *out, const struct power_law *law, double wavelength_m)
{
    section_cell(out, power_law_amplitude(law, wavelength_m) * 1e6, 3);
    number_format_between(out, " ×÷ ", pow(10, power_law_error_decades(law, wavelength_m)), 3, "");
}

static void surface_6_2(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = section_surface(context, index);
    const struct power_law *law = &s->power_law;
    roughness_cells(out, s);
    if (law->found == POWER_LAW_BAND_NONE) {
        text_add(out, " | %s | – | – | – | – | –%s", power_law_band_class_names[law->found],
                 compares_laws(context) ? " | –" : "");
        return;
    }
    section_error_cell(out, law->gamma, law->gamma_error);
    text_add(out, "%s", law->found == POWER_LAW_BAND_NARROW ? " (narrow)" : "");
    text_add(out, " | ");
    number_format(out, law->band_m[0] * 1e6, 3);
    number_format_between(out, "…", law->band_m[1] * 1e6, 3, "");
    amplitude_cell(out, law, law->wavelength_m);
    number_format_between(out, " at ", law->wavelength_m * 1e6, 3, "");
    if (compares_laws(context))
        amplitude_cell(out, law, results_law_wavelength_m(context->results));
    section_cell(out, law->psd_m3, 3);
    section_cell(out, law->misfit_decades, 2);
    section_cell(out, law->alpha, 3);
}

static void table_6_2(struct text *out, const struct section_context *context)
{
    text_add(out,
             "**Table 6.2.** Roughness and power law Δ = α·λᵞ of each surface: γ ± one standard error, the band, "
             "the %s at its middle ×÷ the factor of one standard error, C = Δ²L/2 there, which unlike Δ does not "
             "depend on the scan's length, and the ",
             by_thesis(context) ? "line's Δ" : "rms amplitude Δ");
    if (by_thesis(context))
        number_format_between(out, "RMS of the residual, of which a Gaussian random surface has ",
                              power_law_gaussian_scatter(1), 2, " decades by itself in one scan");
    else
        text_add(out, "lack of fit beyond the scatter of a Gaussian random surface");
    text_add(out, ". α (SI) follows: Δ (m) carried on to λ = 1 m.");
    if (by_thesis(context))
        text_add(out, " The standard errors take harmonics as independent and the law as exact.");
    text_add(out, "\n\n| surface | Rq (µm) | Ra (µm) | length (mm) | spacing (µm) | points | γ | band (µm) | Δ (µm) "
                  "at λ (µm)");
    if (compares_laws(context))
        number_format_between(out, " | Δ (µm) at ", results_law_wavelength_m(context->results) * 1e6, 3, " µm");
    text_add(out,
             " | C (m³) | misfit (decades) | α (SI) |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|"
             "---:|%s\n",
             compares_laws(context) ? "---:|" : "");
    section_each_surface(out, context, surface_6_2);
    text_add(out, "\n");
}

/** Window of each surface's scans, and what its spectrum shows beside the law: only where they differ or something was
 * seen. */
static void surface_spectrum(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = section_surface(context, index);
    text_add(out, " | %zu | %zu", s->scans, s->periodic);
    text_add(out, " | %s", s->windowed == 0 ? "none" : s->windowed == s->scans ? "Hann" : "none or Hann");
    text_add(out, " | %s", power_law_band_class_names[s->power_law.found]);
    section_cell(out, s->independent, 3);
    section_cell(out, roughness_skewness(&s->roughness), 3);
    section_cell(out, roughness_kurtosis(&s->roughness), 3);
}

static void spectrum_table(struct text *out, const struct section_context *context)
{
    text_add(out, "| surface | scans | periodic | window | power law | independent scans | Rsk | Rku | heights |\n"
                  "|---|---:|---:|---|---|---:|---:|---:|---|\n");
    section_each_surface(out, context, surface_spectrum);
    text_add(out,
             "\nHeights count as Gaussian with Rsk within ±0.5 and Rku in 2.5…4. Beyond, 256 Gaussian scans of the "
             "same spectrum are simulated, levelled and averaged alike; in brackets, how many have an Rsk and an "
             "Rku as far out. What is beyond its limit and met in fewer than 2.5 %% of them is not Gaussian, else "
             "the scan cannot tell. With fewer than 7 harmonics nothing is simulated, and the limits decide.\n\n");
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
    const struct results *results = context->results;
    (void)figure;
    text_add(out, " Levelled heights%s%s.",
             results->counterface                           ? ", and the counterface's"
             : results->shown_count < results->usable_count ? ", of the surfaces shown in charts"
                                                            : "",
             results->shown_count + (results->counterface != NULL) > 1
                 ? "; left, each on its own scale, right, all on one"
                 : "");
}

static void spectra_caption(struct text *out, const struct section_context *context, const struct figure *figure)
{
    (void)figure;
    text_add(out, " Solid: the law over the wavelengths it was fitted to; dashed: carried on beyond them.");
    if (!by_thesis(context))
        text_add(out,
                 " Bars: bins of the multitaper spectrum, ± one standard error, dark where the law is fitted, with "
                 "a ring where they are lines; upright dashes: knees; below: the bins over the law, in decades. "
                 "The cloud is the spectrum that the models use.");
}

static void write(struct text *out, const struct section_context *context)
{
    text_add(out, "## The surfaces\n\n");
    surfaces_text(out, context);
    text_add(out, "\n\n");
    table_6_2(out, context);
    spectrum_table(out, context);
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
