/* The report's tables. */
#include "report/section.h"

#include "report/claim.h"
#include "report/words.h"
#include <math.h>
#include <string.h>

static const struct surface_summary *summary_at(const struct section_context *context, size_t index)
{
    return &context->results->spool->summaries[index];
}

/** Calls `row` for every usable surface in the scene's order. */
static void each_surface(struct text *out, const struct section_context *context,
                         void (*row)(struct text *out, const struct section_context *context, size_t index))
{
    for (size_t i = 0; i < context->results->spool->count; i++)
        if (summary_at(context, i)->usable) {
            text_add(out, "| ");
            words_surface(out, context->results, i);
            row(out, context, i);
            text_add(out, " |\n");
        }
}

static void cell(struct text *out, double value, int digits)
{
    text_add(out, " | ");
    words_number(out, value, digits);
}

static void cell_error(struct text *out, double value, double error, int digits)
{
    cell(out, value, digits);
    if (isfinite(error)) {
        text_add(out, " ± ");
        words_number(out, error, 2);
    }
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
    const struct surface_summary *s = summary_at(context, index);
    cell(out, s->roughness.rq_m * 1e6, 3);
    cell(out, s->roughness.ra_m * 1e6, 3);
    cell(out, s->length_m * 1e3, 3);
    cell(out, s->spacing_m * 1e6, 3);
    text_add(out, " | %zu", s->points);
    cell_error(out, s->law.alpha, s->law.alpha_error, 3);
    cell_error(out, s->law.gamma, s->law.gamma_error, 3);
    cell(out, s->law.rms_decades, 3);
}

static void table_6_2(struct text *out, const struct section_context *context)
{
    text_add(
        out,
        "| surface | Rq (µm) | Ra (µm) | length (mm) | spacing (µm) | points | α (SI) | γ | RMS of fit (decades) |\n"
        "|---|---:|---:|---:|---:|---:|---:|---:|---:|\n");
    each_surface(out, context, surface_6_2);
}

static void surface_asperities(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = summary_at(context, index);
    cell(out, s->roughness.m2, 3);
    cell(out, s->roughness.m4_per_m2 * 1e-12, 3);
    cell(out, s->asperities.nayak, 3);
    cell(out, s->asperities.density_per_m2 * 1e-6, 3);
    cell(out, s->asperities.radius_m * 1e6, 3);
    cell(out, s->asperities.sigma_s_m * 1e6, 3);
    cell(out, s->asperities.offset_m * 1e6, 3);
}

static void asperity_table(struct text *out, const struct section_context *context)
{
    text_add(out, "| surface | m₂ | m₄ (µm⁻²) | Nayak | η (mm⁻²) | R (µm) | σₛ (µm) | yₛ (µm) |\n"
                  "|---|---:|---:|---:|---:|---:|---:|---:|\n");
    each_surface(out, context, surface_asperities);
}

static void table_6_1(struct text *out, const struct section_context *context)
{
    const struct scene *scene = context->results->scene;
    bool two = scene->counterface_kind == MATERIAL_COUNTERFACE_ELASTIC;
    text_add(out, "| property | symbol | ");
    text_add_markdown(out, scene->material.name);
    if (two) {
        text_add(out, " | ");
        text_add_markdown(out, scene->counterface.name);
    }
    text_add(out, " | unit |\n|---|---|---:|%s---|\n", two ? "---:|" : "");
    for (size_t i = 0; i < material_property_count; i++) {
        const struct material_property *property = &material_properties[i];
        double values[2] = {material_value(&scene->material, property), material_value(&scene->counterface, property)};
        if (isnan(values[0]) && (!two || isnan(values[1])))
            continue;
        text_add(out, "| %s | %s", property->meaning, property->symbol);
        for (int side = 0; side <= (int)two; side++)
            cell(out, values[side], 5);
        text_add(out, " | %s |\n", property->unit);
    }
}

static void surface_full(struct text *out, const struct section_context *context, size_t index)
{
    const struct plan *plan = context->results->plan;
    for (int m = 0; m < MODEL_COUNT; m++)
        if (model_called_for((enum model_id)m, plan->families, plan->running)) {
            const struct surface_model *model = &summary_at(context, index)->models[m];
            cell(out, model->exists ? model->full_load : NAN, 3);
        }
}

static void full_table(struct text *out, const struct section_context *context)
{
    model_header(out, context, "surface", 1, context->results->plan->families, "");
    each_surface(out, context, surface_full);
}

static void surface_6_3(struct text *out, const struct section_context *context, size_t index)
{
    const struct plan *plan = context->results->plan;
    for (int m = MODEL_GW; m <= MODEL_JG; m++)
        if (model_called_for((enum model_id)m, plan->families, plan->running)) {
            const struct surface_model *model = &summary_at(context, index)->models[m];
            cell(out, model->exists ? model->beta : NAN, 3);
        }
    for (int m = MODEL_GW; m <= MODEL_JG; m++)
        if (model_called_for((enum model_id)m, plan->families, plan->running)) {
            const struct surface_model *model = &summary_at(context, index)->models[m];
            cell(out, model->exists ? model->beta_multiscale : NAN, 3);
        }
}

static void table_6_3(struct text *out, const struct section_context *context)
{
    bool jg = plan_runs(context->results->plan, EFFECT_PLASTICITY);
    text_add(
        out,
        jg ? "| surface | β GW | β JG | GW, nearest multiscale | JG, nearest multiscale |\n|---|---:|---:|---:|---:|\n"
           : "| surface | β GW | GW, nearest multiscale |\n|---|---:|---:|\n");
    each_surface(out, context, surface_6_3);
}

static void surface_key(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = summary_at(context, index);
    cell(out, s->roughness.rq_m * 1e6, 3);
    cell(out, s->law.gamma, 3);
    surface_full(out, context, index);
}

static void key_table(struct text *out, const struct section_context *context)
{
    model_header(out, context, "surface | Rq (µm) | γ", 3, context->results->plan->families, "full contact, ");
    each_surface(out, context, surface_key);
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
        {plan_runs(plan, EFFECT_ELECTRICAL), "ECR·Aₙ (Ω m²)"},
        {plan_runs(plan, EFFECT_THERMAL), "TCR·Aₙ (K m²/W)"},
        {plan_runs(plan, EFFECT_SCALE_DEPENDENT), "scale-dependent"},
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
                words_number(out, load, 3);
                cell(out, load * plan->pair.effective_modulus_Pa * 1e-6, 3);
                text_add(out, " | %s", model_rows[m].label);
                cell(out, p->area_ratio, 3);
                for (size_t c = 0; c < sizeof columns / sizeof columns[0]; c++)
                    if (columns[c].present)
                        cell(out, values[c], 3);
                text_add(out, " |\n");
            }
    }
}

static void surface_extension(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = summary_at(context, index);
    cell_error(out, s->law.gamma, s->law.gamma_error, 3);
    cell(out, 2 * s->spacing_m * 1e6, 3);
    for (int m = MODEL_MULTISCALE_ELASTIC; m <= MODEL_MULTISCALE_PLASTIC; m++) {
        const struct convergence_extension *extension = &s->models[m].extension;
        if (!model_called_for((enum model_id)m, SCENE_MODEL_MULTISCALE, context->results->plan->running))
            continue;
        bool known = s->models[m].exists && extension->scales > 0;
        cell(out, known ? extension->area_measured : NAN, 3);
        cell(out, known ? 100 * (1 - extension->area_extended / extension->area_measured) : NAN, 2);
    }
}

static void extension_table(struct text *out, const struct section_context *context)
{
    bool plastic = plan_runs(context->results->plan, EFFECT_PLASTICITY);
    if (!(context->results->plan->families & SCENE_MODEL_MULTISCALE))
        return;
    text_add(
        out,
        "| surface | γ | sampling limit (µm) | A/Aₙ elastic | would fall by (%%)%s |\n|---|---:|---:|---:|---:|%s\n",
        plastic ? " | A/Aₙ plastic | would fall by (%)" : "", plastic ? "---:|---:|" : "");
    each_surface(out, context, surface_extension);
}

static void surface_validity(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = summary_at(context, index);
    const struct plan *plan = context->results->plan;
    bool leaks = isfinite(s->jump_share);
    cell(out, s->jump_m * 1e6, 3);
    cell(out, leaks ? 100 * s->jump_share : NAN, 2);
    for (int m = MODEL_GW; m <= MODEL_JG; m++)
        if (model_called_for((enum model_id)m, plan->families, plan->running))
            cell(out, s->models[m].exists ? s->models[m].invalid_area_load : NAN, 3);
    if (model_called_for(MODEL_JG, plan->families, plan->running)) {
        cell(out, s->models[MODEL_JG].exists ? s->models[MODEL_JG].invalid_fit_load : NAN, 3);
        cell(out, s->models[MODEL_JG].exists ? 100 * s->models[MODEL_JG].most_outside : NAN, 3);
    }
    if (model_called_for(MODEL_MULTISCALE_PLASTIC, plan->families, plan->running))
        text_add(out, " | %zu of %zu", s->models[MODEL_MULTISCALE_PLASTIC].yielding_scales, s->harmonics);
}

static void validity_table(struct text *out, const struct section_context *context)
{
    const struct plan *plan = context->results->plan;
    bool gw = model_called_for(MODEL_GW, plan->families, plan->running);
    bool jg = model_called_for(MODEL_JG, plan->families, plan->running);
    bool plastic = model_called_for(MODEL_MULTISCALE_PLASTIC, plan->families, plan->running);
    text_add(out, "| surface | end-to-end jump (µm) | its leak / fit (%%)%s%s%s |\n|---|---:|---:|%s%s%s\n",
             gw ? " | GW: A/Aₙ > 0.1 from load" : "",
             jg ? " | JG: A/Aₙ > 0.1 from load | JG: a/R > 0.41 bears 10 % from load | most of the load there (%)" : "",
             plastic ? " | scales that can yield" : "", gw ? "---:|" : "", jg ? "---:|---:|---:|" : "",
             plastic ? "---:|" : "");
    each_surface(out, context, surface_validity);
}

static void claims(struct text *out, const struct section_context *context)
{
    claim_table(out, context->results, context->study);
}

static void effects_table(struct text *out, const struct section_context *context)
{
    text_add(out, "| effect | | why | adds |\n|---|---|---|---|\n");
    for (int e = 0; e < EFFECT_COUNT; e++) {
        const struct plan_effect *effect = &context->results->plan->effects[e];
        text_add(out, "| %s | %s | %s | %s |\n", effect_rows[e].name, effect->runs ? "run" : "skipped", effect->reason,
                 effect_rows[e].adds);
    }
}

static void surface_inputs(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = summary_at(context, index);
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
    each_surface(out, context, surface_inputs);
}

static void notes(struct text *out, const struct section_context *context)
{
    for (size_t i = 0; i < context->results->spool->count; i++)
        for (const char *line = summary_at(context, i)->notes; line && *line;) {
            char single[1200];
            size_t length = strcspn(line, "\n");
            snprintf(single, sizeof single, "%.*s", (int)length, line);
            text_add(out, "- ");
            words_surface(out, context->results, i);
            text_add(out, ": ");
            text_add_markdown(out, single);
            text_add(out, "\n");
            line += length + (line[length] == '\n');
        }
}

static void refused(struct text *out, const struct section_context *context)
{
    for (size_t i = 0; i < context->results->spool->count; i++)
        if (summary_at(context, i)->refusal) {
            text_add(out, "- ");
            words_surface(out, context->results, i);
            text_add(out, ": ");
            text_add_markdown(out, summary_at(context, i)->refusal);
            text_add(out, "\n");
        }
}

static void models_table(struct text *out, const struct section_context *context)
{
    const struct plan *plan = context->results->plan;
    text_add(out, "| model | assumes | valid | equations | source |\n|---|---|---|---|---|\n");
    for (int m = 0; m < MODEL_COUNT; m++)
        if (model_called_for((enum model_id)m, plan->families, plan->running))
            text_add(out, "| %s | %s | %s | %s | %s |\n", model_rows[m].label, model_rows[m].assumes,
                     model_rows[m].valid, model_rows[m].equations, model_rows[m].source);
}

const struct section_row section_tables[] = {
    {"table_6_1", table_6_1},
    {"table_6_2", table_6_2},
    {"table_6_3", table_6_3},
    {"key_table", key_table},
    {"asperity_table", asperity_table},
    {"baseline_table", baseline_table},
    {"full_table", full_table},
    {"extension_table", extension_table},
    {"validity_table", validity_table},
    {"claims", claims},
    {"effects_table", effects_table},
    {"inputs_table", inputs_table},
    {"notes", notes},
    {"refused", refused},
    {"models_table", models_table},
    {NULL, NULL},
};
