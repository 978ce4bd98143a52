/* The report's sentences: short, and every figure in them computed. */
#include "report/section.h"

#include "base/number_format.h"
#include "contact/sinusoid.h"
#include <math.h>

/** A number of the scene, as it stands there, between two texts. */
static void given(struct text *out, const char *before, double value, const char *after)
{
    text_add(out, "%s", before);
    number_format_given(out, value);
    text_add(out, "%s", after);
}

static void surfaces_text(struct text *out, const struct section_context *context)
{
    const struct scene *scene = context->results->scene;
    unsigned families = context->results->plan->families;
    text_add(out,
             "Each profile was levelled (%s) and transformed %s%s. The power law is the least-squares line of log Δ on "
             "log λ",
             level_names[scene->level],
             scene->window == SPECTRUM_WINDOW_HANN ? "under a Hann window" : "without a window",
             families & SCENE_MODEL_MULTISCALE ? "; every harmonic is a scale of the multiscale models" : "");
    if (scene->fit_band_m[0] > 0 || isfinite(scene->fit_band_m[1])) {
        text_add(out, " for wavelengths ");
        if (scene->fit_band_m[0] > 0)
            given(out, "from ", scene->fit_band_m[0] * 1e6, " µm");
        if (isfinite(scene->fit_band_m[1]))
            given(out, scene->fit_band_m[0] > 0 ? " to " : "up to ", scene->fit_band_m[1] * 1e6, " µm");
    }
    text_add(out, ".");
    if (families & SCENE_MODEL_STATISTICAL)
        text_add(out, " Moments are %s.",
                 scene->moments == ROUGHNESS_MOMENTS_SPECTRAL
                     ? "those of the spectrum"
                     : "finite differences (slope: central, curvature: 3-point)");
}

static void gaussian_scatter(struct text *out, const struct section_context *context)
{
    (void)context;
    number_format_number(out, power_law_gaussian_scatter_decades, 3);
}

static void material_text(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    const struct material_pair *pair = &results->plan->pair;
    number_format_add(out, "E′ = ", pair->effective_modulus_Pa * 1e-9, 4, " GPa");
    if (plan_runs(results->plan, EFFECT_PLASTICITY))
        number_format_add(out, ", C = ", pair->yield_coefficient, 4, " (a spot yields at the mean pressure C·S_y)");
    if (plan_runs(results->plan, EFFECT_SCALE_DEPENDENT))
        number_format_add(out, ", mean free path of the heat carriers ", pair->mean_free_path_m[0] * 1e9, 3, " nm");
    text_add(out, ". %zu load%s, ", results->load_count, results->load_count == 1 ? "" : "s");
    text_add(out, "P/(Aₙ E′) = ");
    number_format_power(out, results->loads[0], 3);
    if (results->load_count > 1) {
        text_add(out, " to ");
        number_format_power(out, results->loads[results->load_count - 1], 3);
    }
    number_format_add(out, ", that is ", results->loads[0] * pair->effective_modulus_Pa * 1e-6, 3, "");
    if (results->load_count > 1)
        number_format_add(out, " to ", results->loads[results->load_count - 1] * pair->effective_modulus_Pa * 1e-6, 3,
                          "");
    text_add(out, " MPa of nominal pressure. Properties: ");
    text_add_markdown(out, results->scene->material.source[0] ? results->scene->material.source : "given in the scene");
    text_add(out, ".");
}

/** One law's line of the convergence study: for which α, and from which γ up, the area settles. */
static void sweeps_text(struct text *out, const struct results *results, bool plastic)
{
    const struct convergence_sweep_row *alphas = &convergence_sweeps[CONVERGENCE_ALPHA];
    const struct convergence_sweep_row *gammas = &convergence_sweeps[CONVERGENCE_GAMMA];
    size_t settled = 0, from = gammas->count;
    for (size_t v = 0; v < alphas->count; v++)
        settled += comparison_converges(results, CONVERGENCE_ALPHA, plastic, v);
    while (from > 0 && comparison_converges(results, CONVERGENCE_GAMMA, plastic, from - 1))
        from--;
    text_add(out, "- %s: for %zu of %zu α and for ", plastic ? "elastic-plastic" : "elastic", settled, alphas->count);
    if (from == gammas->count)
        text_add(out, "no γ.\n");
    else
        given(out, from == 0 ? "every γ from " : "γ from ", gammas->values[from], " up.\n");
}

static void convergence_text(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    const struct scene_convergence *study = &results->scene->convergence;
    text_add(out, "Synthetic spectra Δ = α·λᵞ of %zu scales", study->scales);
    given(out, ", longest wavelength ", study->scan_length_m * 1e3, " mm");
    given(out, ", at P/(Aₙ E′) = ", study->load, "");
    given(out, "; α is varied at γ = ", study->gamma, "");
    given(out, ", γ at α = ", study->alpha,
          ". The area has settled, so that the last halving of the wavelength changes it ");
    text_add(out, "by less than 0.1 %%:\n\n");
    sweeps_text(out, results, false);
    if (plan_runs(results->plan, EFFECT_PLASTICITY))
        sweeps_text(out, results, true);
}

static void extension_text(struct text *out, const struct section_context *context)
{
    if (!section_extended(context)) {
        text_add(out,
                 "No scale below the sampling limit can take any area from the measured surfaces at that load: γ ≥ 1, "
                 "and the nominal pressure alone exceeds p* there.");
        return;
    }
    text_add(out,
             "The measured surfaces at that load: the area of their fitted laws down to the sampling limit (twice the "
             "spacing), and by how much it would fall if the law went on ");
    given(out, "to ", convergence_atom_m * 1e9, " nm.");
}

static void baseline(struct text *out, const struct section_context *context)
{
    section_named(out, "Surface ", context->results, context->results->baseline);
}

static void baseline_text(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    const struct surface_summary *s = &context->baseline->summary;
    baseline(out, context);
    text_add(out, " (%s), Rq ",
             results->scene->baseline    ? "chosen in the scene"
             : results->usable_count > 1 ? "the second smoothest"
                                         : "the only one");
    number_format_add(out, "", s->roughness.rq_m * 1e6, 3, " µm.");
    if (!s->has_asperities && (results->plan->families & SCENE_MODEL_STATISTICAL))
        text_add(out, " No statistical model exists for it: see the notes.");
    else if (section_called_for(context, MODEL_GW))
        text_add(out,
                 " A statistical model's curve ends at its full contact; it is dashed outside its range of validity.");
    text_add(out, " At the loads of the table:");
}

/** The smallest and largest of a number over the baseline's models. */
static bool model_range(const struct section_context *context, double (*number)(const struct curve_summary *),
                        double *least, double *most, int *most_at)
{
    *least = INFINITY;
    *most = -INFINITY;
    for (int m = 0; m < MODEL_COUNT; m++) {
        const struct curve_summary *model = &context->baseline->summary.models[m];
        double value = model->exists ? number(model) : NAN;
        if (!isfinite(value))
            continue;
        *least = fmin(*least, value);
        if (value > *most) {
            *most = value;
            *most_at = m;
        }
    }
    return *least <= *most;
}

static double area_slope(const struct curve_summary *model)
{
    return model->area_slope;
}

static double elbow_share(const struct curve_summary *model)
{
    return model->elbow_load / model->full_load;
}

static double scale_dependence(const struct curve_summary *model)
{
    return model->sd_most;
}

static void area_text(struct text *out, const struct section_context *context)
{
    static const enum model_id laws[2][2] = {{MODEL_MULTISCALE_ELASTIC, MODEL_MULTISCALE_PLASTIC},
                                             {MODEL_GW, MODEL_JG}};
    double least, most;
    int unused;
    if (model_range(context, area_slope, &least, &most, &unused)) {
        text_add(out, "Up to A/Aₙ = 0.1 the area grows as Pⁿ with n = ");
        number_format_range(out, least, most, 3);
        text_add(out, ". ");
    }
    bool first = true;
    for (int f = 0; f < 2; f++) {
        const struct contact_point *elastic = section_middle(context, laws[f][0]);
        const struct contact_point *plastic = section_middle(context, laws[f][1]);
        if (!elastic || !plastic)
            continue;
        if (first) {
            text_add(out, "At ");
            section_middle_pressure(out, context);
            text_add(out, " yielding multiplies it by ");
        }
        number_format_add(out, first ? "" : " and by ", plastic->area_ratio / elastic->area_ratio, 3, "");
        text_add(out, " (%s against %s)", model_rows[laws[f][1]].label, model_rows[laws[f][0]].label);
        first = false;
    }
    text_add(out, "%s", first ? "" : ".");
}

static void separation_text(struct text *out, const struct section_context *context)
{
    const struct surface_summary *s = &context->baseline->summary;
    bool first = true;
    for (int m = MODEL_GW; m <= MODEL_JG; m++) {
        if (!s->models[m].exists)
            continue;
        number_format_add(
            out,
            first ? "Statistical separations are adjusted (4.54) to be 0 at full contact; before, they are there "
                  : ", ",
            -s->models[m].beta / 2, 3, " σ");
        text_add(out, " (%s)", model_rows[m].label);
        first = false;
    }
    text_add(out, "%s", first ? "" : ".");
    const struct curve_summary *plastic = &s->models[MODEL_MULTISCALE_PLASTIC];
    if (plastic->exists && plastic->gap_at_full > 0.001)
        number_format_add(out, first ? "" : " ", plastic->gap_at_full, 2,
                          " σ are left where the elastic-plastic multiscale area first is complete.");
}

static void electrical_text(struct text *out, const struct section_context *context)
{
    static const char *const laws[2] = {"elastic", "plastic"};
    double least, most;
    int unused;
    if (model_range(context, elbow_share, &least, &most, &unused)) {
        text_add(out, "The elbow, from which ECR falls faster than P⁻², lies at ");
        number_format_range(out, 100 * least, 100 * most, 2);
        text_add(out, " %% of the load to full contact. ");
    }
    bool first = true;
    for (int law = 0; law < 2; law++) {
        const struct comparison_gap *gap = &context->study->gap[law];
        if (isnan(gap->ecr))
            continue;
        number_format_add(out, first ? "Multiscale and statistical curves lie " : "; ", gap->ecr, 2, "");
        number_format_add(out, first ? " decades apart in ECR and " : " and ", gap->area, 2, first ? " in area" : "");
        text_add(out, " (%s)", laws[law]);
        first = false;
    }
    text_add(out, "%s", first ? "" : ".");
}

static void thermal_text(struct text *out, const struct section_context *context)
{
    if (isfinite(context->study->proportional_error)) {
        const struct material_pair *pair = &context->results->plan->pair;
        number_format_add(out,
                          "TCR is ECR times 1/(ρ k) = ", 1 / (pair->resistivity_ohm_m * pair->conductivity_W_per_mK), 4,
                          " K/(W·Ω) in every model, so the curves have the same shape. ");
    }
    double least, most;
    int at = 0;
    if (plan_runs(context->results->plan, EFFECT_SCALE_DEPENDENT) &&
        model_range(context, scale_dependence, &least, &most, &at)) {
        number_format_add(out, "Scale dependence raises it by at most ", 100 * most, 2, " %");
        text_add(out, " (%s).", model_rows[at].label);
    }
}

static void shown_text(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    if (results->usable_count == 1) {
        text_add(out, "There is one surface, so these charts show it alone, model by model.");
        return;
    }
    text_add(out, "A surface has the same colour in every chart.");
    if (results->shown_count < results->usable_count)
        text_add(
            out,
            " The charts show %zu of the %zu surfaces, spread evenly from the smoothest to the roughest; tables and "
            "data hold all of them.",
            results->shown_count, results->usable_count);
    if (results->plan->running & (EFFECT_BIT(EFFECT_ELECTRICAL) | EFFECT_BIT(EFFECT_THERMAL)))
        text_add(out, " Axes of resistance end where A/Aₙ passes 0.99: at full contact resistance is 0.");
}

static void full_contact_note(struct text *out, const struct section_context *context)
{
    if (section_called_for(context, MODEL_MULTISCALE_PLASTIC) && plan_runs(context->results->plan, EFFECT_SEPARATION))
        text_add(out, " (the published elastic-plastic area gets there before the last gap closes: see the checks)");
}

static void beta_text(struct text *out, const struct section_context *context)
{
    size_t negative = 0, below = 0, above = 0;
    for (size_t k = 0; k < context->results->usable_count; k++)
        for (int m = MODEL_GW; m <= MODEL_JG; m++) {
            const struct curve_summary *model = &section_surface(context, context->results->by_roughness[k])->models[m];
            if (!model->exists)
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

static void validity_text(struct text *out, const struct section_context *context)
{
    if (context->results->plan->families & SCENE_MODEL_STATISTICAL)
        text_add(out,
                 "The statistical models take asperities as independent, which needs A ≪ Aₙ; their curves are dashed "
                 "from A/Aₙ = 0.1%s. ",
                 section_called_for(context, MODEL_JG)
                     ? ", and JG's also where more than 10 % of the "
                       "load rests on asperities beyond a/R = 0.41, the end of its fit"
                     : "");
    if (section_called_for(context, MODEL_MULTISCALE_PLASTIC))
        text_add(out,
                 "The elastic-plastic sinusoid steps up in area (by at most 8 %%) and down in gap where a scale begins "
                 "to yield; the steps are the published model's and are not smoothed. ");
    text_add(out,
             "A jump between the ends of a record leaks amplitude J/(π n) into harmonic n, which looks like γ = 1: the "
             "share is taken at the short end of the fit band. Loads in the table are P/(Aₙ E′).");
}

static void settings_text(struct text *out, const struct section_context *context)
{
    const struct scene *scene = context->results->scene;
    given(out, "Tolerance ", scene->tolerance, " (relative)");
    if (context->results->plan->families & SCENE_MODEL_MULTISCALE)
        text_add(out, ", sinusoid closure `%s`: %s", sinusoid_fit_names[scene->closure],
                 sinusoid_fits[scene->closure].source);
    text_add(out, ".");
}

const struct section_row section_prose[] = {
    {"surfaces_text", surfaces_text},
    {"gaussian_scatter", gaussian_scatter},
    {"material_text", material_text},
    {"convergence_text", convergence_text},
    {"extension_text", extension_text},
    {"baseline", baseline},
    {"baseline_text", baseline_text},
    {"area_text", area_text},
    {"separation_text", separation_text},
    {"electrical_text", electrical_text},
    {"thermal_text", thermal_text},
    {"shown_text", shown_text},
    {"full_contact_note", full_contact_note},
    {"beta_text", beta_text},
    {"validity_text", validity_text},
    {"settings_text", settings_text},
    {NULL, NULL},
};
