/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One surface in every model, quantity by quantity (thesis 6.3). */
#include "report/section.h"

#include <math.h>
#include <string.h>

/** Heads of the table's columns beyond area: the quantities of this run, and ohms where the nominal area is known. */
static bool has_column(const struct section_context *context, int q)
{
    return q > QUANTITY_AREA && q < QUANTITY_COUNT && !quantity_rows[q].from &&
           section_computes(context, (enum quantity)q);
}

static bool has_ohms(const struct section_context *context)
{
    return section_computes(context, QUANTITY_ECR) && isfinite(context->results->scene->nominal_area_m2);
}

static void add_head(struct text *out, const struct quantity_row *row)
{
    bool unit = row->unit[0] && !row->over_sigma && !strchr(row->symbol, ',');
    text_add(out, unit ? " | %s (%s)" : " | %s", row->symbol, row->unit);
}

/** The baseline's quantities at three loads, a row a load and model. */
static void baseline_table(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    struct text rule = {0};
    bool yields = section_knows_yield(context);
    bool pressure = !section_pair(context)->unknown;
    const double *loads = results_loads(results, results->baseline);
    text_add(out, "| ");
    section_load_symbol(out, results);
    text_add(out, "%s | model | A/Aₙ%s", pressure ? " | pressure (MPa)" : "", yields ? " | P/A (S_y)" : "");
    text_add(&rule, "|---:|%s---|---:|%s", pressure ? "---:|" : "", yields ? "---:|" : "");
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if (has_column(context, q)) {
            add_head(out, &quantity_rows[q]);
            text_add(&rule, "---:|");
        }
    text_add(out, "%s |\n%s%s\n", has_ohms(context) ? " | ECR (Ω)" : "", text_string(&rule),
             has_ohms(context) ? "---:|" : "");
    text_free(&rule);
    double sigma_m = context->baseline->summary.asperities.sigma_m;
    for (size_t k = 1; k <= 3; k++) {
        double load = loads[section_table_load(results, k)];
        if (k > 1 && load == loads[section_table_load(results, k - 1)])
            continue;
        for (size_t m = 0; m < model_count; m++)
            for (size_t i = 0; i < context->baseline->curves[m].count; i++) {
                const struct contact_point *p = &context->baseline->curves[m].points[i];
                if (p->value[QUANTITY_LOAD] != load)
                    continue;
                text_add(out, "| ");
                section_load(out, results, results->baseline, load);
                if (pressure)
                    section_cell(out, material_pair_pressure(section_pair(context), load) * 1e-6, 3);
                text_add(out, " | %s", model_rows[m]->label);
                section_cell(out, p->value[QUANTITY_AREA], 3);
                if (yields)
                    section_cell(out, section_contact_pressure(context, results->baseline, p), 3);
                for (int q = 0; q < QUANTITY_COUNT; q++)
                    if (has_column(context, q))
                        section_cell(out, quantity_shown(p, (enum quantity)q, sigma_m), 3);
                if (has_ohms(context))
                    section_cell(out, p->value[QUANTITY_ECR] / results->scene->nominal_area_m2, 3);
                text_add(out, " |\n");
            }
    }
}

/** What was learned of each model of the baseline: a row a model, a column an effect. */
static void model_table(struct text *out, const struct section_context *context)
{
    bool separation = section_computes(context, QUANTITY_SEPARATION),
         electrical = section_computes(context, QUANTITY_ECR);
    bool scale_dependent = section_computes(context, QUANTITY_TCR_SCALE_DEPENDENT);
    text_add(out, "| model | n in A ∝ Pⁿ | A = Aₙ at%s%s%s |\n|---|---:|---:|%s%s%s\n", separation ? " | gap 0 at" : "",
             electrical ? " | ECR elbow at" : "", scale_dependent ? " | scale dependence adds (%)" : "",
             separation ? "---:|" : "", electrical ? "---:|" : "", scale_dependent ? "---:|" : "");
    for (size_t m = 0; m < model_count; m++) {
        const struct curve_summary *model = surface_model(&context->baseline->summary, m);
        if (!model->exists)
            continue;
        text_add(out, "| %s", model_rows[m]->label);
        section_cell(out, model->area_slope, 3);
        section_load_cell(out, context, context->results->baseline, model->full_load);
        if (separation)
            section_load_cell(out, context, context->results->baseline, model->closed_load);
        if (electrical)
            section_threshold_cell(out, context, context->results->baseline, model, model->elbow_load);
        if (scale_dependent) {
            text_add(out, " | ");
            number_format_range(out, 100 * model->sd_least, 100 * model->sd_most, 2);
        }
        text_add(out, " |\n");
    }
}

static void baseline_text(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    const struct surface_summary *s = &context->baseline->summary;
    section_named(out, "Surface ", results, results->baseline);
    text_add(out, " (%s), Rq ",
             results->scene->baseline    ? "chosen in the scene"
             : results->usable_count > 1 ? "the second smoothest"
                                         : "the only one");
    number_format_between(out, "", s->roughness.rq_m * 1e6, 3, " µm.");
    if (!s->has_asperities && plan_uses_asperities(results->plan))
        text_add(out, " No statistical model exists for it: see the notes.");
    else if (plan_uses_asperities(results->plan))
        text_add(out,
                 " A statistical model's curve ends at its full contact; it is dashed outside its range of validity.");
    text_add(out, " At the loads of the table:");
}

/** The smallest and largest of a number over the baseline's models. */
static bool model_range(const struct section_context *context, double (*number)(const struct curve_summary *),
                        double *least, double *most, size_t *most_at)
{
    *least = INFINITY;
    *most = -INFINITY;
    for (size_t m = 0; m < model_count; m++) {
        const struct curve_summary *model = surface_model(&context->baseline->summary, m);
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

static double scale_dependence(const struct curve_summary *model)
{
    return model->sd_most;
}

/** Where a plastic model lets the contact bear more than the hardness: " P/A … exceeds the hardness … between …". */
static void hard_text(struct text *out, const struct section_context *context, size_t m)
{
    const struct model_curve *curve = &context->baseline->curves[m];
    double most = 0, from = NAN, to = NAN;
    for (size_t i = 0; i < curve->count; i++) {
        double pressure = section_contact_pressure(context, context->results->baseline, &curve->points[i]);
        if (!(curve->points[i].value[QUANTITY_AREA] < 1) ||
            !section_exceeds_hardness(context, context->results->baseline, &curve->points[i]))
            continue;
        most = fmax(most, pressure);
        from = fmin(from, curve->points[i].value[QUANTITY_LOAD]); /* of a number and NaN, the number */
        to = fmax(to, curve->points[i].value[QUANTITY_LOAD]);
    }
    if (isnan(from))
        return;
    text_add(out, " In %s the mean pressure P/A of the partial contact exceeds ", model_rows[m]->label);
    section_hardness(out, section_pair(context));
    text_add(out, " ");
    if (from < to) {
        text_add(out, "between ");
        section_at_load(out, context->results, context->results->baseline, from);
        text_add(out, " and ");
        section_load(out, context->results, context->results->baseline, to);
    } else {
        text_add(out, "at ");
        section_at_load(out, context->results, context->results->baseline, to);
    }
    number_format_between(out, " (up to ", most, 2, " S_y).");
}

static void area_text(struct text *out, const struct section_context *context)
{
    double least, most;
    size_t unused;
    if (model_range(context, area_slope, &least, &most, &unused)) {
        text_add(out, "Up to A/Aₙ = 0.1 the area grows as Pⁿ with n = ");
        number_format_range(out, least, most, 3);
        text_add(out, ". ");
    }
    bool first = true;
    for (size_t m = 0; m < model_count; m++) {
        size_t partner = model_index(model_rows[m]->elastic);
        const struct contact_point *plastic = section_middle(context, m);
        const struct contact_point *elastic = partner < model_count ? section_middle(context, partner) : NULL;
        if (!elastic || !plastic)
            continue;
        if (first) {
            text_add(out, "At ");
            section_middle_pressure(out, context);
            text_add(out, " yielding multiplies it by ");
        }
        number_format_between(out, first ? "" : " and by ",
                              plastic->value[QUANTITY_AREA] / elastic->value[QUANTITY_AREA], 3, "");
        text_add(out, " (%s against %s)", model_rows[m]->label, model_rows[partner]->label);
        first = false;
    }
    text_add(out, "%s", first ? "" : ".");
    for (size_t m = 0; m < model_count; m++)
        if (model_rows[m]->plastic)
            hard_text(out, context, m);
}

static void separation_text(struct text *out, const struct section_context *context)
{
    const struct surface_summary *s = &context->baseline->summary;
    bool first = true;
    for (size_t m = 0; m < model_count; m++) {
        if (!surface_model(s, m)->exists || !(model_rows[m]->quantities & QUANTITY_BIT(QUANTITY_ADJUSTED)))
            continue;
        number_format_between(
            out,
            first ? "Statistical separations are adjusted (4.54) to be 0 at full contact; before, they are there "
                  : ", ",
            -surface_model(s, m)->beta / 2, 3, " σ");
        text_add(out, " (%s)", model_rows[m]->label);
        first = false;
    }
    text_add(out, "%s", first ? "" : ".");
    for (size_t m = 0; m < model_count; m++) {
        const struct curve_summary *plastic = surface_model(s, m);
        if (!plastic->exists || !model_rows[m]->plastic || !model_rows[m]->stacks_scales ||
            !(plastic->gap_at_full > 0.001))
            continue;
        number_format_between(out, first ? "" : " ", plastic->gap_at_full, 2, " σ are left where the ");
        text_add(out, "%s area first is complete.", model_rows[m]->label);
        first = false;
    }
}

static void electrical_text(struct text *out, const struct section_context *context)
{
    double least, most;
    size_t unused;
    if (model_range(context, curve_summary_elbow_share, &least, &most, &unused)) {
        text_add(out, "The elbow, from which ECR falls faster than P⁻², lies at ");
        number_format_range(out, 100 * least, 100 * most, 2);
        text_add(out, " %% of the load to full contact. ");
    }
    bool first = true;
    for (size_t m = 0; m < model_count; m++) {
        const struct comparison_gap *gap = &context->comparison->models[m].gaps[context->results->baseline];
        if (isnan(gap->ecr))
            continue;
        number_format_between(out, first ? "Multiscale and statistical curves lie " : "; ", gap->ecr, 2, "");
        number_format_between(out, first ? " decades apart in ECR and " : " and ", gap->area, 2,
                              first ? " in area" : "");
        text_add(out, " (%s)", section_law(m, "plastic"));
        first = false;
    }
    text_add(out, "%s", first ? "" : ".");
}

static void thermal_text(struct text *out, const struct section_context *context)
{
    if (isfinite(context->comparison->proportional_error)) {
        const struct material_pair *pair = section_pair(context);
        number_format_between(
            out, "TCR is ECR times 1/(ρ k) = ", 1 / (pair->resistivity_ohm_m * pair->conductivity_W_per_mK), 4,
            " K/(W·Ω) in every model, so the curves have the same shape. ");
    }
    double least, most;
    size_t at = 0;
    if (plan_runs(context->results->plan, EFFECT_SCALE_DEPENDENT) &&
        model_range(context, scale_dependence, &least, &most, &at)) {
        number_format_between(out, "Scale dependence raises it by at most ", 100 * most, 2, " %");
        text_add(out, " (%s).", model_rows[at]->label);
    }
}

/** Does a model's resistance become 0 on the baseline? */
static bool any_vanishes(const struct section_context *context, enum quantity y)
{
    for (size_t m = 0; m < model_count; m++)
        for (size_t i = 0; i < context->baseline->curves[m].count; i++)
            if (context->baseline->curves[m].points[i].value[y] == 0)
                return true;
    return false;
}

static void kinks(struct text *out, const struct section_context *context)
{
    bool first = true;
    for (size_t m = 0; m < model_count; m++) {
        const struct model_curve *curve = &context->baseline->curves[m];
        for (size_t k = 0; k < curve->kink_count && model_rows[m]->thesis_place > 0; k++) {
            text_add(out,
                     first ? " Kinks, where a scale's contact becomes complete and its resistance is gone: %s" : "; %s",
                     model_rows[m]->label);
            text_add(out, " at ");
            number_format_power(out, curve->kinks[k].load, 2);
            number_format_between(out, " (wavelength ", curve->kinks[k].wavelength_m * 1e6, 3, " µm)");
            first = false;
        }
    }
    text_add(out, "%s", first ? "" : ".");
}

/** Smallest and largest value at the middle load over the models that the charts here show: the thesis's, or others
 * where none of those has a curve. */
static struct comparison_extremes models_drawn(const struct section_context *context, enum quantity y)
{
    struct comparison_extremes extremes = {.least = INFINITY, .most = -INFINITY};
    bool thesis = false;
    for (size_t m = 0; m < model_count; m++)
        thesis = thesis || (context->baseline->curves[m].exists && model_rows[m]->thesis_place > 0);
    for (size_t m = 0; m < model_count; m++) {
        const struct contact_point *point = section_middle(context, m);
        double value = point ? comparison_value(point, y, m, context->baseline->summary.asperities.sigma_m) : NAN;
        if (isnan(value) || (thesis && model_rows[m]->thesis_place == 0))
            continue;
        extremes.count++;
        if (value < extremes.least) {
            extremes.least = value;
            extremes.least_at = m;
        }
        if (value > extremes.most) {
            extremes.most = value;
            extremes.most_at = m;
        }
    }
    return extremes;
}

static void caption(struct text *out, const struct section_context *context, const struct figure *figure)
{
    enum quantity y = figure->row->y;
    struct comparison_extremes models = models_drawn(context, y);
    if (y == QUANTITY_SEPARATION && section_computes(context, QUANTITY_ADJUSTED))
        text_add(out, " Bold with squares: adjusted by (4.54); thin: the statistical models' own separation.");
    section_cut(out, context, figure);
    if (y == QUANTITY_TCR && section_computes(context, QUANTITY_TCR_SCALE_DEPENDENT))
        text_add(out, " Below: scale-dependent over plain.");
    if (figure->row->x != QUANTITY_LOAD || models.count == 0)
        return;
    section_at_middle(out, context, y, models.least);
    if (models.count > 1) {
        text_add(out, " (%s)", model_rows[models.least_at]->label);
        section_to(out, y, models.most);
        text_add(out, " (%s)", model_rows[models.most_at]->label);
    }
    text_add(out, ".");
    if (QUANTITY_BIT(y) & QUANTITY_RESISTANCES) {
        if (any_vanishes(context, y))
            text_add(out, " A curve leaves the chart at its full contact, where resistance is 0%s.",
                     context->baseline->summary.scans > 1 ? "; a mean of scans ends where the first of them gets there"
                                                          : "");
        kinks(out, context);
    }
}

/** The parts of the section: heading, quantity it needs, text, and the figures' place. */
static const struct part {
    const char *heading;
    enum quantity quantity;
    void (*text)(struct text *out, const struct section_context *context);
    const char *place;
} parts[] = {
    {"Real contact area", QUANTITY_AREA, area_text, "baseline area"},
    {"Separation", QUANTITY_SEPARATION, separation_text, "baseline separation"},
    {"Electrical contact resistance", QUANTITY_ECR, electrical_text, "baseline electrical"},
    {"Thermal contact resistance", QUANTITY_TCR, thermal_text, "baseline thermal"},
};

static void write(struct text *out, const struct section_context *context)
{
    text_add(out, "## ");
    section_named(out, "Surface ", context->results, context->results->baseline);
    text_add(out, " in every model\n\n");
    baseline_text(out, context);
    text_add(out, "\n\n");
    baseline_table(out, context);
    text_add(out, "\nOver all loads:\n\n");
    model_table(out, context);
    for (size_t p = 0; p < sizeof parts / sizeof *parts; p++) {
        if (!section_computes(context, parts[p].quantity))
            continue;
        text_add(out, "\n### %s\n\n", parts[p].heading);
        parts[p].text(out, context);
        text_add(out, "\n\n");
        section_figures(out, context, parts[p].place, caption);
    }
}

const struct section section_baseline = {"baseline", NULL, write};
