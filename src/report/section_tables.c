/* The report's tables. */
#include "report/section.h"

#include "base/number_format.h"
#include "report/claim.h"
#include <math.h>
#include <string.h>

static void cell_error(struct text *out, double value, double error)
{
    text_add(out, " | ");
    number_format_uncertain(out, value, error);
}

/** A header cell a model that ran, then the rule below the header; `first` is the header's beginning. */
static void model_header(struct text *out, const struct section_context *context, const char *first, int columns,
                         unsigned families, const char *format)
{
    const struct plan *plan = context->results->plan;
    text_add(out, "| %s", first);
    for (int m = 0; m < MODEL_COUNT; m++)
        if ((model_rows[m].family & families) && model_called_for((enum model_id)m, plan->families, plan->running)) {
            text_add(out, " | %s%s", format, model_rows[m].label);
            columns++;
        }
    text_add(out, " |\n|---|");
    for (int c = 1; c < columns; c++)
        text_add(out, "---:|");
    text_add(out, "\n");
}

static void surface_6_2(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = section_surface(context, index);
    section_cell(out, s->roughness.rq_m * 1e6, 3);
    section_cell(out, s->roughness.ra_m * 1e6, 3);
    section_cell(out, s->length_m * 1e3, 3);
    section_cell(out, s->spacing_m * 1e6, 3);
    text_add(out, " | %zu", s->points);
    cell_error(out, s->power_law.alpha, s->power_law.alpha_error);
    cell_error(out, s->power_law.gamma, s->power_law.gamma_error);
    section_cell(out, s->power_law.rms_decades, 3);
}

static void table_6_2(struct text *out, const struct section_context *context)
{
    text_add(
        out,
        "| surface | Rq (µm) | Ra (µm) | length (mm) | spacing (µm) | points | α (SI) | γ | RMS of fit (decades) |\n"
        "|---|---:|---:|---:|---:|---:|---:|---:|---:|\n");
    section_each_surface(out, context, surface_6_2);
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

static void asperity_table(struct text *out, const struct section_context *context)
{
    text_add(out, "| surface | m₂ | m₄ (µm⁻²) | Nayak | η (mm⁻²) | R (µm) | σₛ (µm) | yₛ (µm) |\n"
                  "|---|---:|---:|---:|---:|---:|---:|---:|\n");
    section_each_surface(out, context, surface_asperities);
}

/** Is the property one that a model or an effect of this run needs? */
static bool is_needed(const struct plan *plan, const char *key)
{
    bool needed = strcmp(key, "E_Pa") == 0 || strcmp(key, "nu") == 0;
    for (int e = 0; e < EFFECT_COUNT; e++)
        for (int k = 0; plan_runs(plan, (enum effect)e) && effect_rows[e].properties[k]; k++)
            needed = needed || strcmp(effect_rows[e].properties[k], key) == 0;
    return needed;
}

static void table_6_1(struct text *out, const struct section_context *context)
{
    const struct scene *scene = context->results->scene;
    bool elastic = scene->counterface_kind == MATERIAL_COUNTERFACE_ELASTIC;
    bool two = elastic && strcmp(scene->material.name, scene->counterface.name) != 0;
    text_add(out, "| property | symbol | ");
    text_add_markdown(out, scene->material.name);
    if (two) {
        text_add(out, " | ");
        text_add_markdown(out, scene->counterface.name);
    }
    text_add(out, "%s | unit |\n|---|---|---:|%s---|\n", elastic && !two ? ", both bodies" : "", two ? "---:|" : "");
    for (size_t i = 0; i < material_property_count; i++) {
        const struct material_property *property = &material_properties[i];
        double values[2] = {material_value(&scene->material, property), material_value(&scene->counterface, property)};
        if (!is_needed(context->results->plan, property->key))
            continue;
        text_add(out, "| %s | %s", property->meaning, property->symbol);
        for (int side = 0; side <= (int)two; side++) {
            text_add(out, " | ");
            number_format_given(out, values[side]);
        }
        text_add(out, " | %s |\n", property->unit);
    }
}

static void surface_full(struct text *out, const struct section_context *context, size_t index)
{
    const struct plan *plan = context->results->plan;
    for (int m = 0; m < MODEL_COUNT; m++)
        if (model_called_for((enum model_id)m, plan->families, plan->running)) {
            const struct curve_summary *model = &section_surface(context, index)->models[m];
            section_load_cell(out, model->exists ? model->full_load : NAN);
        }
}

static void full_table(struct text *out, const struct section_context *context)
{
    model_header(out, context, "surface", 1, context->results->plan->families, "");
    section_each_surface(out, context, surface_full);
}

static void surface_6_3(struct text *out, const struct section_context *context, size_t index)
{
    const struct plan *plan = context->results->plan;
    for (int m = MODEL_GW; m <= MODEL_JG; m++)
        if (model_called_for((enum model_id)m, plan->families, plan->running)) {
            const struct curve_summary *model = &section_surface(context, index)->models[m];
            section_cell(out, model->exists ? model->beta : NAN, 3);
        }
    for (int m = MODEL_GW; m <= MODEL_JG; m++)
        if (model_called_for((enum model_id)m, plan->families, plan->running)) {
            const struct curve_summary *model = &section_surface(context, index)->models[m];
            section_cell(out, model->exists ? model->beta_multiscale : NAN, 3);
        }
}

static void table_6_3(struct text *out, const struct section_context *context)
{
    bool jg = plan_runs(context->results->plan, EFFECT_PLASTICITY);
    text_add(
        out,
        jg ? "| surface | β GW | β JG | GW, nearest multiscale | JG, nearest multiscale |\n|---|---:|---:|---:|---:|\n"
           : "| surface | β GW | GW, nearest multiscale |\n|---|---:|---:|\n");
    section_each_surface(out, context, surface_6_3);
}

/** The baseline's quantities at three loads, a row a load and model. */
static void baseline_table(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    const struct plan *plan = results->plan;
    bool separation = plan_runs(plan, EFFECT_SEPARATION), statistical = plan->families & SCENE_MODEL_STATISTICAL;
    struct text rule = {0};
    text_add(out, "| P/(Aₙ E′) | pressure (MPa) | model | A/Aₙ");
    text_add(&rule, "|---:|---:|---|---:|");
    const struct {
        bool present;
        const char *head;
    } columns[] = {
        {separation, "separation/σ"},
        {separation && statistical, "adjusted"},
        {plan_runs(plan, EFFECT_ELECTRICAL), "ECR·Aₙ (Ω·m²)"},
        {plan_runs(plan, EFFECT_THERMAL), "TCR·Aₙ (K·m²/W)"},
        {plan_runs(plan, EFFECT_SCALE_DEPENDENT), "TCR·Aₙ, scale-dependent"},
        {plan_runs(plan, EFFECT_ELECTRICAL) && isfinite(results->scene->nominal_area_m2), "ECR (Ω)"},
    };
    for (size_t c = 0; c < sizeof columns / sizeof columns[0]; c++)
        if (columns[c].present) {
            text_add(out, " | %s", columns[c].head);
            text_add(&rule, "---:|");
        }
    text_add(out, " |\n%s\n", text_string(&rule));
    text_free(&rule);
    double sigma_m = context->baseline->summary.asperities.sigma_m;
    for (size_t k = 1; k <= 3; k++) {
        double load = results->loads[k * (results->load_count - 1) / 4];
        if (k > 1 && load == results->loads[(k - 1) * (results->load_count - 1) / 4])
            continue;
        for (int m = 0; m < MODEL_COUNT; m++)
            for (size_t i = 0; i < context->baseline->curves[m].count; i++) {
                const struct contact_point *p = &context->baseline->curves[m].points[i];
                if (p->load != load)
                    continue;
                const double values[] = {p->separation_m / sigma_m,
                                         p->adjusted_m / sigma_m,
                                         p->ecr_ohm_m2,
                                         p->tcr_K_m2_per_W,
                                         p->tcr_sd_K_m2_per_W,
                                         p->ecr_ohm_m2 / results->scene->nominal_area_m2};
                text_add(out, "| ");
                number_format_power(out, load, 3);
                section_cell(out, load * plan->pair.effective_modulus_Pa * 1e-6, 3);
                text_add(out, " | %s", model_rows[m].label);
                section_cell(out, p->area_ratio, 3);
                for (size_t c = 0; c < sizeof columns / sizeof columns[0]; c++)
                    if (columns[c].present)
                        section_cell(out, values[c], 3);
                text_add(out, " |\n");
            }
    }
}

static void surface_extension(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = section_surface(context, index);
    cell_error(out, s->power_law.gamma, s->power_law.gamma_error);
    section_cell(out, 2 * s->spacing_m * 1e6, 3);
    for (int m = MODEL_MULTISCALE_ELASTIC; m <= MODEL_MULTISCALE_PLASTIC; m++) {
        const struct convergence_extension *extension = &s->models[m].extension;
        if (!model_called_for((enum model_id)m, SCENE_MODEL_MULTISCALE, context->results->plan->running))
            continue;
        bool known = s->models[m].exists && extension->scales > 0;
        section_cell(out, known ? extension->area_measured : NAN, 3);
        section_cell(out, known ? 100 * (1 - extension->area_extended / extension->area_measured) : NAN, 2);
    }
}

static void extension_table(struct text *out, const struct section_context *context)
{
    bool plastic = plan_runs(context->results->plan, EFFECT_PLASTICITY);
    if (!section_extended(context))
        return;
    text_add(
        out,
        "| surface | γ | sampling limit (µm) | A/Aₙ elastic | further fall (%%)%s |\n|---|---:|---:|---:|---:|%s\n",
        plastic ? " | A/Aₙ elastic-plastic | further fall (%)" : "", plastic ? "---:|---:|" : "");
    section_each_surface(out, context, surface_extension);
}

static void surface_validity(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = section_surface(context, index);
    const struct plan *plan = context->results->plan;
    bool leaks = isfinite(s->jump_share);
    section_cell(out, s->jump_m * 1e6, 3);
    section_cell(out, leaks ? 100 * s->jump_share : NAN, 2);
    for (int m = MODEL_GW; m <= MODEL_JG; m++)
        if (model_called_for((enum model_id)m, plan->families, plan->running))
            section_load_cell(out, s->models[m].exists ? s->models[m].invalid_area_load : NAN);
    if (model_called_for(MODEL_JG, plan->families, plan->running)) {
        section_load_cell(out, s->models[MODEL_JG].exists ? s->models[MODEL_JG].invalid_fit_load : NAN);
        double outside = s->models[MODEL_JG].most_beyond_fit;
        section_cell(out, s->models[MODEL_JG].exists ? outside < 1e-4 ? 0 : 100 * outside : NAN, 3);
        double saturated = s->models[MODEL_JG].most_radius_clamped;
        section_cell(out, s->models[MODEL_JG].exists ? saturated < 1e-4 ? 0 : 100 * saturated : NAN, 3);
    }
    if (model_called_for(MODEL_MULTISCALE_PLASTIC, plan->families, plan->running))
        text_add(out, " | %zu of %zu | %llu", s->models[MODEL_MULTISCALE_PLASTIC].yielding_scales, s->harmonics,
                 (unsigned long long)s->models[MODEL_MULTISCALE_PLASTIC].clamped);
}

static void validity_table(struct text *out, const struct section_context *context)
{
    const struct plan *plan = context->results->plan;
    bool gw = model_called_for(MODEL_GW, plan->families, plan->running);
    bool jg = model_called_for(MODEL_JG, plan->families, plan->running);
    bool plastic = model_called_for(MODEL_MULTISCALE_PLASTIC, plan->families, plan->running);
    text_add(out, "| surface | end-to-end jump (µm) | its leak (%% of fit)%s%s%s |\n|---|---:|---:|%s%s%s\n",
             gw ? " | GW: A/Aₙ > 0.1 from" : "",
             jg ? " | JG: A/Aₙ > 0.1 from | JG: 10 % of load beyond a/R = 0.41 from | largest share beyond (%) | "
                  "clamped at a/R = 1 (%)"
                : "",
             plastic ? " | scales that can yield | areas limited" : "", gw ? "---:|" : "",
             jg ? "---:|---:|---:|---:|" : "", plastic ? "---:|---:|" : "");
    section_each_surface(out, context, surface_validity);
}

static void claims(struct text *out, const struct section_context *context)
{
    claim_table(out, context->results, context->study);
}

static void surface_inputs(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = section_surface(context, index);
    text_add(out, " | ");
    for (size_t f = 0; f < s->scene->file_count; f++) {
        text_add(out, "%s", f > 0 ? ", " : "");
        text_add_markdown(out, s->scene->files[f]);
    }
    text_add(out, " | %s | ", s->format);
    text_add_markdown(out, s->units);
    text_add(out, " | `%.16s…`", s->hash);
}

static void inputs_table(struct text *out, const struct section_context *context)
{
    text_add(out, "| surface | files | format | units | SHA-256 |\n|---|---|---|---|---|\n");
    section_each_surface(out, context, surface_inputs);
}

/** One line of the lists of notes and refusals. */
static void list_item(struct text *out, const struct section_context *context, size_t index, const char *line)
{
    text_add(out, "- ");
    section_surface_name(out, context->results, index);
    text_add(out, ": ");
    text_add_markdown(out, line);
    text_add(out, "\n");
}

static void notes(struct text *out, const struct section_context *context)
{
    size_t items = 0;
    for (size_t i = 0; i < context->results->store->count; i++)
        for (const char *line = section_surface(context, i)->notes; line && *line;) {
            char single[1200];
            size_t length = strcspn(line, "\n");
            snprintf(single, sizeof single, "%.*s", (int)length, line);
            if (items++ < SECTION_ROWS)
                list_item(out, context, i, single);
            line += length + (line[length] == '\n');
        }
    if (items > SECTION_ROWS)
        text_add(out, "- … %zu more in results.json\n", items - SECTION_ROWS);
}

static void refused(struct text *out, const struct section_context *context)
{
    size_t items = 0;
    for (size_t i = 0; i < context->results->store->count; i++)
        if (section_surface(context, i)->refusal && items++ < SECTION_ROWS)
            list_item(out, context, i, section_surface(context, i)->refusal);
    if (items > SECTION_ROWS)
        text_add(out, "- … %zu more in results.json\n", items - SECTION_ROWS);
}

/** What was learned of each model of the baseline: a row a model, a column an effect. */
static void model_table(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    bool separation = plan_runs(results->plan, EFFECT_SEPARATION);
    bool electrical = plan_runs(results->plan, EFFECT_ELECTRICAL);
    bool scale_dependent = plan_runs(results->plan, EFFECT_SCALE_DEPENDENT);
    text_add(out, "| model | n in A ∝ Pⁿ | A = Aₙ at%s%s%s |\n|---|---:|---:|%s%s%s\n", separation ? " | gap 0 at" : "",
             electrical ? " | ECR elbow at" : "", scale_dependent ? " | scale dependence adds (%)" : "",
             separation ? "---:|" : "", electrical ? "---:|" : "", scale_dependent ? "---:|" : "");
    for (int m = 0; m < MODEL_COUNT; m++) {
        const struct curve_summary *model = &context->baseline->summary.models[m];
        if (!model->exists)
            continue;
        text_add(out, "| %s", model_rows[m].label);
        section_cell(out, model->area_slope, 3);
        section_load_cell(out, model->full_load);
        if (separation)
            section_load_cell(out, model->closed_load);
        if (electrical)
            section_load_cell(out, model->elbow_load);
        if (scale_dependent) {
            text_add(out, " | ");
            number_format_range(out, 100 * model->sd_least, 100 * model->sd_most, 2);
        }
        text_add(out, " |\n");
    }
}

static void models_list(struct text *out, const struct section_context *context)
{
    for (int m = 0; m < MODEL_COUNT; m++)
        if (section_called_for(context, (enum model_id)m))
            text_add(out, "- **%s** (eq. %s). Assumes: %s. Valid: %s. Source: %s.\n", model_rows[m].label,
                     model_rows[m].equations, model_rows[m].assumes, model_rows[m].valid, model_rows[m].source);
}

const struct section_row section_tables[] = {
    {"table_6_1", table_6_1},
    {"table_6_2", table_6_2},
    {"table_6_3", table_6_3},
    {"asperity_table", asperity_table},
    {"baseline_table", baseline_table},
    {"full_table", full_table},
    {"extension_table", extension_table},
    {"validity_table", validity_table},
    {"claims", claims},
    {"inputs_table", inputs_table},
    {"notes", notes},
    {"refused", refused},
    {"models_list", models_list},
    {"model_table", model_table},
    {NULL, NULL},
};
