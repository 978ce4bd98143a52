/* What an engineer wants first: contact area, resistance, the best surface, and how far to trust it. */
#include "report/section.h"

#include <math.h>
#include <stdio.h>

static void surfaces(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    const struct scene *scene = results->scene;
    size_t count = results->usable_count;
    double modulus_MPa = results->plan->pair.effective_modulus_Pa * 1e-6;
    text_add(out, "- %zu surface%s, Rq ", count, count == 1 ? "" : "s");
    number_format_range(out, section_surface(context, results->by_roughness[0])->roughness.rq_m * 1e6,
                        section_surface(context, results->by_roughness[count - 1])->roughness.rq_m * 1e6, 3);
    text_add(out, " µm, of ");
    text_add_markdown(out, scene->material.name);
    if (results->counterface) {
        text_add(out, ", pressed against a rough counterface (Rq ");
        number_format(out, results->counterface->summary.roughness.rq_m * 1e6, 3);
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
    number_format_range(out, results->loads[0] * modulus_MPa, results->loads[results->load_count - 1] * modulus_MPa, 3);
    text_add(out, " MPa.\n");
}

/** ", ECR·Aₙ is … Ω·m²" of the leading model over all surfaces. */
static void resistance(struct text *out, const struct comparison_extremes *extremes, const char *name, const char *unit)
{
    if (extremes->count == 0)
        return;
    text_add(out, "; %s·Aₙ is ", name);
    number_format_range(out, extremes->least, extremes->most, 3);
    text_add(out, " %s", unit);
}

static void at_middle(struct text *out, const struct section_context *context)
{
    const struct comparison *study = context->comparison;
    const struct comparison_extremes *extremes = study->models[study->leading].extremes;
    double nominal_m2 = context->results->scene->nominal_area_m2;
    if (extremes[QUANTITY_AREA].count == 0)
        return;
    text_add(out, "- **At ");
    section_middle_pressure(out, context);
    text_add(out, "** (P/(Aₙ E′) = ");
    number_format_power(out, study->middle_load, 3);
    text_add(out, "; %s) the real contact area is ", model_rows[study->leading]->label);
    number_format_range(out, 100 * extremes[QUANTITY_AREA].least, 100 * extremes[QUANTITY_AREA].most, 3);
    text_add(out, " %% of the nominal one");
    resistance(out, &extremes[QUANTITY_ECR], "ECR", "Ω·m²");
    if (extremes[QUANTITY_ECR].count > 0 && isfinite(nominal_m2)) {
        text_add(out, " (");
        number_format_range(out, extremes[QUANTITY_ECR].least / nominal_m2, extremes[QUANTITY_ECR].most / nominal_m2,
                            3);
        text_add(out, " Ω on ");
        number_format_given(out, nominal_m2 * 1e6);
        text_add(out, " mm²)");
    }
    resistance(out, &extremes[QUANTITY_TCR], "TCR", "K·m²/W");
    text_add(out, ".\n");
}

/** What surfaces are ranked by: the resistance asked for, else the area. */
static enum quantity criterion(const struct section_context *context)
{
    return section_computes(context, QUANTITY_ECR)   ? QUANTITY_ECR
           : section_computes(context, QUANTITY_TCR) ? QUANTITY_TCR
                                                     : QUANTITY_AREA;
}

static size_t best_of(const struct comparison_extremes *extremes, enum quantity quantity)
{
    return quantity == QUANTITY_AREA ? extremes->most_at : extremes->least_at;
}

/** The surface next to the best in the leading model. */
static size_t second_of(const struct section_context *context, size_t best, enum quantity quantity)
{
    const struct comparison *study = context->comparison;
    double second = NAN;
    size_t at = best;
    for (size_t i = 0; i < context->results->store->count; i++) {
        double value = comparison_value(&study->middle[i], quantity, study->leading,
                                        section_surface(context, i)->asperities.sigma_m);
        if (i == best || isnan(study->middle[i].load) || isnan(value))
            continue;
        if (isnan(second) || (quantity == QUANTITY_AREA ? value > second : value < second)) {
            second = value;
            at = i;
        }
    }
    return at;
}

/** "surface 4, the worst, has 7.5 times its ECR". */
static void versus(struct text *out, const struct section_context *context, double best, size_t other, const char *rank,
                   enum quantity quantity)
{
    double value = comparison_value(&context->comparison->middle[other], quantity, context->comparison->leading, 1);
    text_add(out, " ");
    section_named(out, "surface ", context->results, other);
    number_format_between(out, rank, value / best, 3, "");
    text_add(out, " times its %s", quantity_rows[quantity].short_symbol);
}

static void best_surface(struct text *out, const struct section_context *context)
{
    const struct comparison *study = context->comparison;
    enum quantity quantity = criterion(context);
    const struct comparison_extremes *extremes = &study->models[study->leading].extremes[quantity];
    size_t best = best_of(extremes, quantity), agreeing = 0, asked = 0;
    double value = quantity == QUANTITY_AREA ? extremes->most : extremes->least;
    size_t worst = quantity == QUANTITY_AREA ? extremes->least_at : extremes->most_at;
    if (extremes->count < 2 || worst == best || !(value > 0))
        return;
    text_add(out, "- **");
    section_named(out, "Surface ", context->results, best);
    text_add(out, " has the %s %s** there:", quantity == QUANTITY_AREA ? "largest" : "lowest",
             quantity_rows[quantity].short_symbol);
    size_t second = second_of(context, best, quantity);
    if (second != worst) {
        versus(out, context, value, second, ", the next, has ", quantity);
        text_add(out, ",");
    }
    versus(out, context, value, worst, second != worst ? ", the worst, " : " has ", quantity);
    for (size_t m = 0; m < model_count; m++)
        if (study->models[m].extremes[quantity].count > 1) {
            asked++;
            agreeing += best_of(&study->models[m].extremes[quantity], quantity) == best;
        }
    if (asked > 1)
        text_add(out, ". It is best in %zu of %zu models", agreeing, asked);
    text_add(out, ".\n");
}

static void one_spread(struct text *out, const struct section_context *context, enum quantity quantity,
                       const char *before, double scale, const char *unit)
{
    struct comparison_extremes models = section_models(context, quantity);
    if (models.count < 2)
        return;
    number_format_between(out, before, models.least * scale, 3, " (");
    text_add(out, "%s) to ", model_rows[models.least_at]->label);
    number_format(out, models.most * scale, 3);
    text_add(out, "%s (%s)", unit, model_rows[models.most_at]->label);
}

static void model_spread(struct text *out, const struct section_context *context)
{
    enum quantity quantity = criterion(context);
    if (section_models(context, QUANTITY_AREA).count < 2)
        return;
    text_add(out, "- **Between the models**, for ");
    section_named(out, "surface ", context->results, context->results->baseline);
    one_spread(out, context, QUANTITY_AREA, " at that load, the area is ", 100, " %");
    if (quantity == QUANTITY_ECR)
        one_spread(out, context, quantity, ", ECR·Aₙ ", 1, " Ω·m²");
    if (quantity == QUANTITY_TCR)
        one_spread(out, context, quantity, ", TCR·Aₙ ", 1, " K·m²/W");
    text_add(out, ".\n");
}

/** "by a factor of 1.6": an RMS distance in decades. */
static void factor_off(struct text *out, const struct measured_distance *distance)
{
    number_format_between(out, "by a factor of ", pow(10, distance->rms_decades), 3, "");
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
    if (rank.nearest == model_count) {
        text_add(out, "no measured load lies within those of the models; widen `load` in the scene.\n");
        return;
    }
    struct measured_distance near = measured_compare(measured, &curves[rank.nearest]);
    text_add(out, "on ");
    section_named(out, "surface ", context->results, context->results->baseline);
    text_add(out, ", %s is nearest, off ", model_rows[rank.nearest]->label);
    factor_off(out, &near);
    text_add(out, " (root mean square over %zu of %zu points) and ", near.points, measured->count);
    number_format_between(out, "", pow(10, near.bias_decades), 3, " times the measured on average");
    if (rank.farthest != rank.nearest) {
        struct measured_distance far = measured_compare(measured, &curves[rank.farthest]);
        text_add(out, "; %s is farthest, off ", model_rows[rank.farthest]->label);
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
    double load = context->comparison->middle_load, fall = 0;
    size_t leaks = 0, knees = 0, diverging = 0;
    struct text list = {0};
    for (size_t m = 0; m < model_count; m++) {
        size_t invalid = 0;
        char what[120];
        for (size_t k = 0; k < results->usable_count; k++) {
            const struct curve_summary *model = &section_smoothest(context, k)->models[m];
            invalid += model->exists && (model->invalid_area_load <= load || model->invalid_fit_load <= load);
            if (model->extension.area_measured > 0)
                fall = fmax(fall, 1 - model->extension.area_extended / model->extension.area_measured);
        }
        snprintf(what, sizeof what, "%s is outside its range of validity at that load", model_rows[m]->label);
        limit(&list, context, invalid, what, "");
    }
    for (size_t k = 0; k < results->usable_count; k++) {
        const struct surface_summary *s = section_smoothest(context, k);
        leaks += s->jump_share > 0.5;
        knees += isfinite(s->power_law.knee_m);
        diverging += s->power_law.gamma + s->power_law.gamma_error < 1;
    }
    if (plan_stacks_scales(results->plan))
        limit(&list, context, diverging, "γ is below 1", ", so the elastic area depends on the sampling");
    if (fall > 1e-3) {
        text_add(&list, "%s", list.length > 0 ? "; " : "");
        number_format_between(&list, "scales below the sampling limit would take up to ", 100 * fall, 2,
                              " % more of the area");
    }
    limit(&list, context, leaks, "a jump between the ends of the record draws γ towards 1", "");
    limit(&list, context, knees, "two slopes fit the spectrum better than one law", "");
    if (list.length > 0)
        text_add(out, "- **Limits**: %s.\n", text_string(&list));
    text_free(&list);
}

static void summary(struct text *out, const struct section_context *context)
{
    size_t refused = context->results->store->count - context->results->usable_count;
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

static bool has_column(const struct section_context *context, int q)
{
    bool shown = q == QUANTITY_AREA || q == QUANTITY_SEPARATION || q == QUANTITY_ECR || q == QUANTITY_TCR;
    return shown && section_computes(context, (enum quantity)q);
}

static void surface_key(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = section_surface(context, index);
    const struct contact_point *point = &context->comparison->middle[index];
    size_t leading = context->comparison->leading;
    section_cell(out, s->roughness.rq_m * 1e6, 3);
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if (has_column(context, q)) {
            double value = comparison_value(point, (enum quantity)q, leading, s->asperities.sigma_m);
            section_cell(out, isnan(point->load) ? NAN : q == QUANTITY_AREA ? 100 * value : value, 3);
        }
    section_load_cell(out, s->models[leading].exists ? s->models[leading].full_load : NAN);
}

static void key_table(struct text *out, const struct section_context *context)
{
    struct text rule = {0};
    text_add(out, "| surface | Rq (µm)");
    text_add(&rule, "|---|---:|");
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if (has_column(context, q)) {
            const struct quantity_row *row = &quantity_rows[q];
            const char *unit = q == QUANTITY_AREA ? "%" : row->over_sigma ? "" : row->unit;
            text_add(out, unit[0] ? " | %s (%s)" : " | %s", row->symbol, unit);
            text_add(&rule, "---:|");
        }
    text_add(out, " | full contact at P/(Aₙ E′) |\n%s---:|\n", text_string(&rule));
    text_free(&rule);
    section_each_surface(out, context, surface_key);
}

static void write(struct text *out, const struct section_context *context)
{
    text_add(out, "# ");
    text_add_markdown(out, context->results->scene->title);
    text_add(out, "\n\n");
    summary(out, context);
    text_add(out, "\n**At ");
    section_middle_pressure(out, context);
    text_add(out, "**, %s:\n\n", model_rows[context->comparison->leading]->label);
    key_table(out, context);
}

const struct section section_summary = {"summary", NULL, write};
