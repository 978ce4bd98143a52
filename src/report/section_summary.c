/* What an engineer wants first: contact area, resistance, the best surface, and how far to trust it. */
#include "report/section.h"

#include "report/words.h"
#include "results/measured.h"
#include <math.h>

static void surfaces(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    const struct scene *scene = results->scene;
    size_t count = results->usable_count;
    double modulus_MPa = results->plan->pair.effective_modulus_Pa * 1e-6;
    text_add(out, "- %zu surface%s, Rq ", count, count == 1 ? "" : "s");
    words_range(out, section_surface(context, results->by_roughness[0])->roughness.rq_m * 1e6,
                section_surface(context, results->by_roughness[count - 1])->roughness.rq_m * 1e6, 3);
    text_add(out, " µm, of ");
    text_add_markdown(out, scene->material.name);
    if (results->counterface) {
        text_add(out, ", pressed against a rough counterface (Rq ");
        words_number(out, results->counterface->summary.roughness.rq_m * 1e6, 3);
        text_add(out, " µm; the Rq given are of both together)");
        if (scene->counterface_kind == MATERIAL_COUNTERFACE_ELASTIC) {
            text_add(out, " of ");
            text_add_markdown(out, scene->counterface.name);
        }
    } else if (scene->counterface_kind == MATERIAL_COUNTERFACE_RIGID) {
        text_add(out, ", pressed against a rigid flat%s",
                 results->plan->running & (EFFECT_BIT(EFFECT_ELECTRICAL) | EFFECT_BIT(EFFECT_THERMAL))
                     ? " that conducts like it"
                     : "");
    } else {
        text_add(out, ", pressed against a smooth flat of ");
        text_add_markdown(out, scene->counterface.name);
    }
    text_add(out, " at nominal pressures of ");
    words_range(out, results->loads[0] * modulus_MPa, results->loads[results->load_count - 1] * modulus_MPa, 3);
    text_add(out, " MPa.\n");
}

/** ", ECR·Aₙ is … Ω·m²" of the leading model over all surfaces. */
static void resistance(struct text *out, const struct study_extremes *extremes, const char *name, const char *unit)
{
    if (extremes->count == 0)
        return;
    text_add(out, "; %s·Aₙ is ", name);
    words_range(out, extremes->least, extremes->most, 3);
    text_add(out, " %s", unit);
}

static void at_middle(struct text *out, const struct section_context *context)
{
    const struct study *study = context->study;
    const struct study_extremes *extremes = study->extremes[study->leading];
    double nominal_m2 = context->results->scene->nominal_area_m2;
    if (extremes[STUDY_AREA].count == 0)
        return;
    text_add(out, "- **At ");
    section_middle_pressure(out, context);
    text_add(out, "** (P/(Aₙ E′) = ");
    words_power(out, study->middle_load, 3);
    text_add(out, "; %s) the real contact area is ", model_rows[study->leading].label);
    words_range(out, 100 * extremes[STUDY_AREA].least, 100 * extremes[STUDY_AREA].most, 3);
    text_add(out, " %% of the nominal one");
    resistance(out, &extremes[STUDY_ECR], "ECR", "Ω·m²");
    if (extremes[STUDY_ECR].count > 0 && isfinite(nominal_m2)) {
        text_add(out, " (");
        words_range(out, extremes[STUDY_ECR].least / nominal_m2, extremes[STUDY_ECR].most / nominal_m2, 3);
        text_add(out, " Ω on ");
        words_given(out, nominal_m2 * 1e6);
        text_add(out, " mm²)");
    }
    resistance(out, &extremes[STUDY_TCR], "TCR", "K·m²/W");
    text_add(out, ".\n");
}

/** What surfaces are ranked by: the resistance asked for, else the area. */
static enum study_quantity criterion(const struct plan *plan)
{
    return plan_runs(plan, EFFECT_ELECTRICAL) ? STUDY_ECR : plan_runs(plan, EFFECT_THERMAL) ? STUDY_TCR : STUDY_AREA;
}

static size_t best_of(const struct study_extremes *extremes, enum study_quantity quantity)
{
    return quantity == STUDY_AREA ? extremes->most_at : extremes->least_at;
}

/** The surface next to the best in the leading model. */
static size_t second_of(const struct section_context *context, size_t best, enum study_quantity quantity)
{
    const struct study *study = context->study;
    double second = NAN;
    size_t at = best;
    for (size_t i = 0; i < context->results->spool->count; i++) {
        double value =
            study_value(&study->middle[i], quantity, study->leading, section_surface(context, i)->asperities.sigma_m);
        if (i == best || isnan(study->middle[i].load) || isnan(value))
            continue;
        if (isnan(second) || (quantity == STUDY_AREA ? value > second : value < second)) {
            second = value;
            at = i;
        }
    }
    return at;
}

/** "surface 4, the worst, has 7.5 times its ECR". */
static void versus(struct text *out, const struct section_context *context, double best, size_t other, const char *rank,
                   enum study_quantity quantity)
{
    static const char *const names[] = {
        [STUDY_AREA] = "area", [STUDY_SEPARATION] = "", [STUDY_ECR] = "ECR", [STUDY_TCR] = "TCR"};
    double value = study_value(&context->study->middle[other], quantity, context->study->leading, 1);
    text_add(out, " ");
    words_named(out, "surface ", context->results, other);
    words_add(out, rank, value / best, 3, "");
    text_add(out, " times its %s", names[quantity]);
}

static void best_surface(struct text *out, const struct section_context *context)
{
    const struct study *study = context->study;
    enum study_quantity quantity = criterion(context->results->plan);
    const struct study_extremes *extremes = &study->extremes[study->leading][quantity];
    size_t best = best_of(extremes, quantity), agreeing = 0, asked = 0;
    double value = quantity == STUDY_AREA ? extremes->most : extremes->least;
    size_t worst = quantity == STUDY_AREA ? extremes->least_at : extremes->most_at;
    if (extremes->count < 2 || worst == best || !(value > 0))
        return;
    static const char *const names[] = {
        [STUDY_AREA] = "largest area", [STUDY_SEPARATION] = "", [STUDY_ECR] = "lowest ECR", [STUDY_TCR] = "lowest TCR"};
    text_add(out, "- **");
    words_named(out, "Surface ", context->results, best);
    text_add(out, " has the %s** there:", names[quantity]);
    size_t second = second_of(context, best, quantity);
    if (second != worst) {
        versus(out, context, value, second, ", the next, has ", quantity);
        text_add(out, ",");
    }
    versus(out, context, value, worst, second != worst ? ", the worst, " : " has ", quantity);
    for (int m = 0; m < MODEL_COUNT; m++)
        if (study->extremes[m][quantity].count > 1) {
            asked++;
            agreeing += best_of(&study->extremes[m][quantity], quantity) == best;
        }
    if (asked > 1)
        text_add(out, ". It is best in %zu of %zu models", agreeing, asked);
    text_add(out, ".\n");
}

static void one_spread(struct text *out, const struct section_context *context, enum study_quantity quantity,
                       const char *before, double scale, const char *unit)
{
    struct study_extremes models = section_models(context, quantity);
    if (models.count < 2)
        return;
    words_add(out, before, models.least * scale, 3, " (");
    text_add(out, "%s) to ", model_rows[models.least_at].label);
    words_number(out, models.most * scale, 3);
    text_add(out, "%s (%s)", unit, model_rows[models.most_at].label);
}

static void model_spread(struct text *out, const struct section_context *context)
{
    enum study_quantity quantity = criterion(context->results->plan);
    if (section_models(context, STUDY_AREA).count < 2)
        return;
    text_add(out, "- **Between the models**, for ");
    words_named(out, "surface ", context->results, context->results->baseline);
    one_spread(out, context, STUDY_AREA, " at that load, the area is ", 100, " %");
    if (quantity == STUDY_ECR)
        one_spread(out, context, quantity, ", ECR·Aₙ ", 1, " Ω·m²");
    if (quantity == STUDY_TCR)
        one_spread(out, context, quantity, ", TCR·Aₙ ", 1, " K·m²/W");
    text_add(out, ".\n");
}

/** "by a factor of 1.6": an RMS distance in decades. */
static void factor_off(struct text *out, const struct measured_distance *distance)
{
    words_add(out, "by a factor of ", pow(10, distance->rms_decades), 3, "");
}

/** How well the models agree with what was measured: the nearest of them, and the farthest. */
static void agreement(struct text *out, const struct section_context *context)
{
    const struct measured *measured = context->results->measured;
    if (!measured)
        return;
    const struct model_curve *curves = context->baseline->curves;
    struct measured_ranking rank = measured_rank(measured, curves);
    text_add(out, "- **Measured %s** (%zu point%s): ", measured->thermal ? "TCR" : "ECR", measured->count,
             measured->count == 1 ? "" : "s");
    if (rank.nearest == MODEL_COUNT) {
        text_add(out, "no measured load lies within those of the models; widen `load` in the scene.\n");
        return;
    }
    struct measured_distance near = measured_compare(measured, &curves[rank.nearest]);
    text_add(out, "on ");
    words_named(out, "surface ", context->results, context->results->baseline);
    text_add(out, ", %s is nearest, off ", model_rows[rank.nearest].label);
    factor_off(out, &near);
    text_add(out, " (root mean square over %zu of %zu points) and ", near.points, measured->count);
    words_add(out, "", pow(10, near.bias_decades), 3, " times the measured on average");
    if (rank.farthest != rank.nearest) {
        struct measured_distance far = measured_compare(measured, &curves[rank.farthest]);
        text_add(out, "; %s is farthest, off ", model_rows[rank.farthest].label);
        factor_off(out, &far);
    }
    text_add(out, ".\n");
}

/** One limit of trust: how many surfaces it concerns. */
static void limit(struct text *out, const struct section_context *context, size_t count, const char *what,
                  const char *then)
{
    if (count == 0)
        return;
    text_add(out, "%s%s", out->length > 0 ? "; " : "", what);
    size_t all = context->results->usable_count;
    if (all > 1 && count == all)
        text_add(out, " on all %zu surfaces", all);
    else if (all > 1)
        text_add(out, " on %zu of %zu surfaces", count, all);
    text_add(out, "%s", then);
}

static void limits(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    double load = context->study->middle_load, fall = 0;
    size_t gw = 0, jg = 0, leaks = 0, knees = 0, diverging = 0;
    for (size_t k = 0; k < results->usable_count; k++) {
        const struct surface_summary *s = section_surface(context, results->by_roughness[k]);
        gw += s->models[MODEL_GW].exists && s->models[MODEL_GW].invalid_area_load <= load;
        jg += s->models[MODEL_JG].exists &&
              (s->models[MODEL_JG].invalid_area_load <= load || s->models[MODEL_JG].invalid_fit_load <= load);
        leaks += s->jump_share > 0.5;
        knees += isfinite(s->law.knee_m);
        diverging += s->law.gamma + s->law.gamma_error < 1;
        for (int m = 0; m < MODEL_COUNT; m++)
            if (s->models[m].extension.area_measured > 0)
                fall = fmax(fall, 1 - s->models[m].extension.area_extended / s->models[m].extension.area_measured);
    }
    struct text list = {0};
    limit(&list, context, gw, "GW is outside its range of validity at that load", "");
    limit(&list, context, jg, "JG is outside its range at that load", "");
    if (results->plan->families & SCENE_MODEL_MULTISCALE)
        limit(&list, context, diverging, "γ is below 1", ", so the elastic area depends on the sampling");
    if (fall > 1e-3) {
        text_add(&list, "%s", list.length > 0 ? "; " : "");
        words_add(&list, "scales below the sampling limit would take up to ", 100 * fall, 2, " % more of the area");
    }
    limit(&list, context, leaks, "a jump between the ends of the record draws γ towards 1", "");
    limit(&list, context, knees, "two slopes fit the spectrum better than one law", "");
    if (list.length > 0)
        text_add(out, "- **Limits**: %s.\n", text_string(&list));
    text_free(&list);
}

static void summary(struct text *out, const struct section_context *context)
{
    size_t refused = context->results->spool->count - context->results->usable_count;
    surfaces(out, context);
    at_middle(out, context);
    best_surface(out, context);
    model_spread(out, context);
    agreement(out, context);
    limits(out, context);
    if (refused > 0)
        text_add(out, "- **%zu surface%s refused**: see the end of this report.\n", refused,
                 refused == 1 ? " was" : "s were");
}

static void key_caption(struct text *out, const struct section_context *context)
{
    text_add(out, "**At ");
    section_middle_pressure(out, context);
    text_add(out, "**, %s:", model_rows[context->study->leading].label);
}

/** Columns of the key table, those of effects that ran. */
static const struct key_column {
    const char *head;
    unsigned effect;
    enum study_quantity quantity;
    double scale;
} key_columns[] = {
    {"A/Aₙ (%)", 0, STUDY_AREA, 100},
    {"separation/σ", EFFECT_BIT(EFFECT_SEPARATION), STUDY_SEPARATION, 1},
    {"ECR·Aₙ (Ω·m²)", EFFECT_BIT(EFFECT_ELECTRICAL), STUDY_ECR, 1},
    {"TCR·Aₙ (K·m²/W)", EFFECT_BIT(EFFECT_THERMAL), STUDY_TCR, 1},
};
enum { KEY_COLUMNS = sizeof key_columns / sizeof key_columns[0] };

static bool has_column(const struct section_context *context, int column)
{
    return (context->results->plan->running & key_columns[column].effect) == key_columns[column].effect;
}

static void surface_key(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = section_surface(context, index);
    const struct contact_point *point = &context->study->middle[index];
    section_cell(out, s->roughness.rq_m * 1e6, 3);
    for (int c = 0; c < KEY_COLUMNS; c++)
        if (has_column(context, c))
            section_cell(out,
                         isnan(point->load)
                             ? NAN
                             : key_columns[c].scale * study_value(point, key_columns[c].quantity,
                                                                  context->study->leading, s->asperities.sigma_m),
                         3);
    section_load_cell(out,
                      s->models[context->study->leading].exists ? s->models[context->study->leading].full_load : NAN);
}

static void key_table(struct text *out, const struct section_context *context)
{
    struct text rule = {0};
    text_add(out, "| surface | Rq (µm)");
    text_add(&rule, "|---|---:|");
    for (int c = 0; c < KEY_COLUMNS; c++)
        if (has_column(context, c)) {
            text_add(out, " | %s", key_columns[c].head);
            text_add(&rule, "---:|");
        }
    text_add(out, " | full contact at P/(Aₙ E′) |\n%s---:|\n", text_string(&rule));
    text_free(&rule);
    section_each_surface(out, context, surface_key);
}

const struct section_row section_summary[] = {
    {"summary", summary},
    {"key_caption", key_caption},
    {"key_table", key_table},
    {NULL, NULL},
};
