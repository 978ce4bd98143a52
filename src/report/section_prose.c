/* The report's sentences: short, and every figure in them computed. */
#include "report/section.h"

#include "contact/sinusoid.h"
#include "report/words.h"
#include <math.h>

static const struct surface_summary *summary_at(const struct section_context *context, size_t index)
{
    return &context->results->spool->summaries[index];
}

static const struct surface_summary *smoothest(const struct section_context *context)
{
    return summary_at(context, context->results->by_roughness[0]);
}

static const struct surface_summary *roughest(const struct section_context *context)
{
    return summary_at(context, context->results->by_roughness[context->results->usable_count - 1]);
}

static void add(struct text *out, const char *before, double value, int digits, const char *after)
{
    text_add(out, "%s", before);
    words_number(out, value, digits);
    text_add(out, "%s", after);
}

static bool called_for(const struct section_context *context, enum model_id model)
{
    const struct plan *plan = context->results->plan;
    return model_called_for(model, plan->families, plan->running);
}

/** The model the summary speaks of: the first plastic one that ran, else the first that ran. */
static enum model_id leading_model(const struct section_context *context)
{
    static const enum model_id order[] = {MODEL_MULTISCALE_PLASTIC, MODEL_MULTISCALE_ELASTIC, MODEL_JG, MODEL_GW};
    for (int i = 0; i < 3; i++)
        if (called_for(context, order[i]))
            return order[i];
    return MODEL_GW;
}

/** Point of the baseline's curve nearest the middle load, NULL when there is none. */
static const struct contact_point *middle_point(const struct section_context *context, enum model_id model)
{
    const struct model_curve *curve = &context->baseline->curves[model];
    for (size_t i = 0; i < curve->count; i++)
        if (curve->points[i].load == context->study->middle_load)
            return &curve->points[i];
    return NULL;
}

static void summary(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    enum model_id model = leading_model(context);
    const struct contact_point *point = middle_point(context, model);
    text_add(out, "- %zu surface%s, Rq ", results->usable_count, results->usable_count == 1 ? "" : "s");
    words_range(out, smoothest(context)->roughness.rq_m * 1e6, roughest(context)->roughness.rq_m * 1e6, 3);
    text_add(out, " µm, pressed against %s.\n",
             results->scene->counterface_kind == MATERIAL_COUNTERFACE_RIGID
                 ? "a rigid flat that conducts like the material"
                 : "an elastic counterface");
    if (point) {
        text_add(out, "- At P/(Aₙ E′) = ");
        words_number(out, point->load, 2);
        add(out, " (", point->load * results->plan->pair.effective_modulus_Pa * 1e-6, 3, " MPa), surface ");
        words_surface(out, results, results->baseline);
        text_add(out, " touches over ");
        words_number(out, 100 * point->area_ratio, 3);
        text_add(out, " %% of the nominal area (%s)", model_rows[model].label);
        if (!isnan(point->ecr_ohm_m2))
            add(out, ", with ECR·Aₙ = ", point->ecr_ohm_m2, 3, " Ω m²");
        if (!isnan(point->tcr_K_m2_per_W))
            add(out, !isnan(point->ecr_ohm_m2) ? " and TCR·Aₙ = " : ", with TCR·Aₙ = ", point->tcr_K_m2_per_W, 3,
                " K m²/W");
        text_add(out, ".\n");
    }
    if (results->usable_count > 1 && isfinite(context->study->area_spread[model]))
        add(out, "- At that load the areas of all surfaces lie within a factor of ", context->study->area_spread[model],
            3, ".\n");
    size_t refused = 0;
    for (size_t i = 0; i < results->spool->count; i++)
        refused += !summary_at(context, i)->usable;
    if (refused > 0)
        text_add(out, "- %zu surface%s refused: see the end of this report.\n", refused,
                 refused == 1 ? " was" : "s were");
}

static void surfaces_text(struct text *out, const struct section_context *context)
{
    const struct scene *scene = context->results->scene;
    text_add(out,
             "Each profile was levelled (%s) and transformed%s; every harmonic is a scale of the multiscale models. "
             "The power law is the least-squares line of log Δ on log λ",
             scene_level_names[scene->level],
             scene->window == SCENE_WINDOW_HANN ? " under a Hann window" : " without a window");
    if (scene->fit_band_m[0] > 0 || isfinite(scene->fit_band_m[1])) {
        text_add(out, " for wavelengths ");
        if (scene->fit_band_m[0] > 0)
            add(out, "from ", scene->fit_band_m[0] * 1e6, 3, " µm");
        if (isfinite(scene->fit_band_m[1]))
            add(out, " up to ", scene->fit_band_m[1] * 1e6, 4, " µm");
    }
    text_add(out, ". Moments are %s.",
             scene->moments == SCENE_MOMENTS_SPECTRAL ? "those of the spectrum"
                                                      : "finite differences (slope: central, curvature: 3-point)");
}

static void gaussian_scatter(struct text *out, const struct section_context *context)
{
    (void)context;
    words_number(out, powerlaw_gaussian_scatter_decades, 3);
}

static void material_text(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    const struct material_pair *pair = &results->plan->pair;
    add(out, "E′ = ", pair->effective_modulus_Pa * 1e-9, 4, " GPa");
    if (plan_runs(results->plan, EFFECT_PLASTICITY))
        add(out, ", C = ", pair->yield_coefficient, 4, " (C Sᵧ is the mean pressure at which a spot yields)");
    if (plan_runs(results->plan, EFFECT_SCALE_DEPENDENT))
        add(out, ", mean free path of the heat carriers ", pair->mean_free_path_m[0] * 1e9, 3, " nm");
    text_add(out, ". %zu load%s, ", results->load_count, results->load_count == 1 ? "" : "s");
    add(out, "P/(Aₙ E′) = ", results->loads[0], 3, "");
    if (results->load_count > 1)
        add(out, " to ", results->loads[results->load_count - 1], 3, "");
    add(out, ", that is ", results->loads[0] * pair->effective_modulus_Pa * 1e-6, 3, "");
    if (results->load_count > 1)
        add(out, " to ", results->loads[results->load_count - 1] * pair->effective_modulus_Pa * 1e-6, 3, "");
    text_add(out, " MPa of nominal pressure. Properties: ");
    text_add_markdown(out, results->scene->material.source[0] ? results->scene->material.source : "given in the scene");
    text_add(out, ".");
}

/** Does a sweep's curve settle: does the last halving of the wavelength still change the area by over 0.1 %? */
static bool settles(const struct results *results, enum convergence_sweep sweep, bool plastic, size_t value)
{
    size_t scales = results->scene->convergence.scales;
    const double *area = results_sweep(results, sweep, plastic, value);
    return scales < 2 || area[scales - 1] >= 0.999 * area[scales / 2 - 1];
}

static void convergence_text(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    const struct scene_convergence *study = &results->scene->convergence;
    text_add(out, "Synthetic spectra Δ = α·λ^γ of %zu scales, longest wavelength ", study->scales);
    add(out, "", study->scan_length_m * 1e3, 3, " mm, at P/(Aₙ E′) = ");
    add(out, "", study->load, 2, "; α is varied at γ = ");
    add(out, "", study->gamma, 3, ", γ at α = ");
    add(out, "", study->alpha, 3, ".");
    for (int plastic = 0; plastic <= (int)plan_runs(results->plan, EFFECT_PLASTICITY); plastic++) {
        size_t alpha = 0;
        double least = NAN;
        for (size_t v = 0; v < convergence_sweeps[CONVERGENCE_ALPHA].count; v++)
            alpha += settles(results, CONVERGENCE_ALPHA, plastic, v);
        for (size_t v = convergence_sweeps[CONVERGENCE_GAMMA].count; v-- > 0;)
            if (settles(results, CONVERGENCE_GAMMA, plastic, v))
                least = convergence_sweeps[CONVERGENCE_GAMMA].values[v];
            else
                break;
        text_add(out, " %s: the last halving of the wavelength changes the area by less than 0.1 %% for %zu of %zu α",
                 plastic ? "Elastic-plastic" : "Elastic", alpha, convergence_sweeps[CONVERGENCE_ALPHA].count);
        add(out, ", and for every γ from ", least, 3, " up.");
    }
}

static void extension_text(struct text *out, const struct section_context *context)
{
    if (!(context->results->plan->families & SCENE_MODEL_MULTISCALE))
        return;
    text_add(out, "The measured surfaces: their fitted law carried on from the sampling limit (twice the spacing) to ");
    add(out, "", convergence_atom_m * 1e9, 2, " nm, and by how much the area would still fall.");
}

static void baseline(struct text *out, const struct section_context *context)
{
    words_surface(out, context->results, context->results->baseline);
}

static void baseline_text(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    const struct surface_summary *s = &context->baseline->summary;
    text_add(out, "Surface ");
    baseline(out, context);
    text_add(out, " (%s), Rq ",
             results->scene->baseline    ? "chosen in the scene"
             : results->usable_count > 1 ? "the second smoothest"
                                         : "the only one");
    add(out, "", s->roughness.rq_m * 1e6, 3, " µm.");
    if (!s->has_asperities && (results->plan->families & SCENE_MODEL_STATISTICAL))
        text_add(out, " No statistical model exists for it: see the notes.");
    if (called_for(context, MODEL_GW))
        text_add(out, " Dashed parts of a curve lie outside its model's range of validity.");
}

static void area_text(struct text *out, const struct section_context *context)
{
    for (int m = 0; m < MODEL_COUNT; m++) {
        const struct surface_model *model = &context->baseline->summary.models[m];
        if (!model->exists)
            continue;
        text_add(out, "%s%s: A ∝ P^", out->length > 0 && m > 0 ? " " : "", model_rows[m].label);
        add(out, "", model->area_slope, 3, " below A/Aₙ = 0.1 (residual ");
        add(out, "", model->area_slope_rms, 2, " decades), complete at P/(Aₙ E′) = ");
        add(out, "", model->full_load, 3, ".");
    }
}

static void separation_text(struct text *out, const struct section_context *context)
{
    const struct surface_summary *s = &context->baseline->summary;
    for (int m = 0; m < MODEL_COUNT; m++) {
        const struct surface_model *model = &s->models[m];
        const struct contact_point *point = middle_point(context, (enum model_id)m);
        if (!model->exists || !point)
            continue;
        bool statistical = model_rows[m].family == SCENE_MODEL_STATISTICAL;
        text_add(out, "%s: ", model_rows[m].label);
        add(out, "", (statistical ? point->adjusted_m : point->separation_m) / s->asperities.sigma_m, 3, " σ");
        text_add(out, "%s at P/(Aₙ E′) = ", statistical ? " (adjusted)" : "");
        words_number(out, point->load, 2);
        if (statistical)
            add(out, "; its own separation at full contact is ", -model->beta / 2, 3, " σ. ");
        else
            add(out, "; closed at ", model->closed_load, 3, ". ");
    }
}

/** Where the resistance of each model of the baseline begins its steep fall. */
static void electrical_text(struct text *out, const struct section_context *context)
{
    for (int m = 0; m < MODEL_COUNT; m++) {
        const struct surface_model *model = &context->baseline->summary.models[m];
        const struct contact_point *point = middle_point(context, (enum model_id)m);
        if (!model->exists)
            continue;
        text_add(out, "%s: ", model_rows[m].label);
        if (point)
            add(out, "", point->ecr_ohm_m2, 3, " Ω m² at P/(Aₙ E′) = ");
        if (point)
            add(out, "", point->load, 2, ", ");
        if (isfinite(model->elbow_load))
            add(out, "elbow at ", model->elbow_load, 2, ". ");
        else
            text_add(out, "no elbow within the loads. ");
    }
    if (isfinite(context->study->ecr_gap)) {
        add(out, "Multiscale and statistical ECR differ by ", context->study->ecr_gap, 2,
            " decades on average, their areas by ");
        add(out, "", context->study->area_gap, 2, ".");
    }
}

static void thermal_text(struct text *out, const struct section_context *context)
{
    if (isfinite(context->study->proportional_error)) {
        const struct material_pair *pair = &context->results->plan->pair;
        add(out, "TCR is ECR times 1/(ρ k) = ", 1 / (pair->resistivity_ohm_m * pair->conductivity_W_per_mK), 4,
            " K/(W Ω) in every model. ");
    }
    if (!plan_runs(context->results->plan, EFFECT_SCALE_DEPENDENT))
        return;
    text_add(out, "Scale dependence raises it by ");
    bool first = true;
    for (int m = 0; m < MODEL_COUNT; m++) {
        const struct surface_model *model = &context->baseline->summary.models[m];
        if (!model->exists || !(model->sd_most >= model->sd_least))
            continue;
        text_add(out, "%s", first ? "" : "; ");
        words_range(out, 100 * model->sd_least, 100 * model->sd_most, 2);
        text_add(out, " %% (%s)", model_rows[m].label);
        first = false;
    }
    text_add(out, ".");
}

static void shown_text(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    if (results->shown_count < results->usable_count)
        text_add(out,
                 "The charts show %zu of the %zu surfaces, spread evenly from the smoothest to the roughest; tables "
                 "and data hold all of them. ",
                 results->shown_count, results->usable_count);
    if (results->usable_count == 1)
        text_add(out, "There is one surface, so these charts show it alone.");
    else
        text_add(out, "A surface has the same colour in every chart.");
}

static void full_contact_note(struct text *out, const struct section_context *context)
{
    if (called_for(context, MODEL_MULTISCALE_PLASTIC) && plan_runs(context->results->plan, EFFECT_SEPARATION))
        text_add(out, " (the published elastic-plastic area reaches it before the last gap closes: see the checks)");
}

static void beta_text(struct text *out, const struct section_context *context)
{
    size_t negative = 0, below = 0, above = 0;
    for (size_t k = 0; k < context->results->usable_count; k++)
        for (int m = MODEL_GW; m <= MODEL_JG; m++) {
            const struct surface_model *model = &summary_at(context, context->results->by_roughness[k])->models[m];
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
                 called_for(context, MODEL_JG) ? ", and JG's also where more than 10 % of the "
                                                 "load rests on asperities beyond a/R = 0.41, the end of its fit"
                                               : "");
    if (called_for(context, MODEL_MULTISCALE_PLASTIC))
        text_add(out,
                 "The elastic-plastic sinusoid steps up in area (by at most 8 %%) and down in gap where a scale begins "
                 "to yield; the steps are the published model's and are not smoothed. ");
    text_add(out,
             "A jump between the ends of a record leaks amplitude J/(π n) into harmonic n, which looks like γ = 1: the "
             "share is taken at the short end of the fit band.");
}

static void settings_text(struct text *out, const struct section_context *context)
{
    const struct scene *scene = context->results->scene;
    add(out, "Tolerance ", scene->tolerance, 2, "");
    text_add(out, " (relative), sinusoid closure `%s`: %s.", scene_closure_names[scene->closure],
             sinusoid_closures[scene->closure].source);
}

const struct section_row section_prose[] = {
    {"summary", summary},
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
