/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far each model is from a direct numerical solution on the same surface. */
#include "analysis/direct_study.h"
#include "report/section.h"

#include <math.h>
#include <string.h>

/** Does a quantity that is compared belong to this run? */
static bool has(const struct section_context *context, int q)
{
    return context->results->plan->wanted & QUANTITY_BIT(direct_study_quantities[q]);
}

static const char *const quantity_words[DIRECT_STUDY_QUANTITIES] = {"area", "gap", "ECR"};

/* Below this gamma the slope of Delta = alpha lambda^gamma has no limit as its shortest wave gets shorter. */
static const double law_without_end = 1.5;

static void resolution(struct text *out, const struct direct_study *study, const struct power_law *fitted)
{
    const struct direct_plan *plan = &study->plan;
    if (plan->side > 0) {
        text_add(out, " the map itself: ");
        text_add(out,
                 plan->mirrored ? "the first square of %zu points a side, its plane off, mirrored to %zu × %zu points, "
                                  "which makes it periodic"
                                : "all of its %zu points a side (%zu × %zu), as it closes on itself",
                 plan->side, plan->grid, plan->grid);
        if (plan->lambda_s_m > 0)
            number_format_between(out, ", low-passed at ", plan->lambda_s_m * 1e6, 3, " µm");
        text_add(out, ". Below that there is nothing: the direct solution is true at this resolution.");
        return;
    }
    text_add(out,
             " %zu isotropic surface%s of %zu × %zu points, as long as the scan, whose rows have its mean square "
             "height and slope and the moment between: ",
             plan->seeds, plan->seeds == 1 ? "" : "s", plan->grid, plan->grid);
    number_format_between(out, "Δ = α λ^γ with γ = ", plan->law.gamma, 4, "");
    number_format_between(out, ", α = ", plan->law.alpha, 3, "");
    text_add(out, " (SI)");
    if (plan->law.roll_off > 1)
        number_format_between(out, " from ", plan->length_m / plan->law.roll_off * 1e6, 3, " µm, level above,");
    number_format_between(out, " down to λs = ", plan->lambda_s_m * 1e6, 3, " µm");
    if (plan->coarse)
        text_add(out, ", which is what this grid resolves and not all that the scan holds");
    else if (plan->of_spacing)
        text_add(out, ", four spacings of the scan (twice its Nyquist wavelength), as neither the scene nor a band of "
                      "the fit says where the roughness ends");
    number_format_between(out, " (their mean square curvature is then ", study->m4_over_scan, 2, " times the scan's");
    if (isfinite(fitted->gamma) && isfinite(fitted->alpha)) {
        number_format_between(out, "; the law fitted to the scan has γ = ", fitted->gamma, 4, "");
        number_format_between(out, ", α = ", fitted->alpha, 3, "");
    }
    text_add(out, "). Below λs there is nothing: the direct solution is true at this resolution");
    if (plan->law.gamma < law_without_end && (plan->of_spacing || plan->coarse))
        text_add(out, ", and no further: with γ < 1.5 slopes grow as λs falls, and the area goes to 0 with it");
    number_format_between(out, ". A row is levelled, a surface is not, so its Sq is ", study->rms_m * 1e6, 3, "");
    number_format_between(out, " µm where its rows' Rq is ", sqrt(study->moments.m0_m2) * 1e6, 3, " µm.");
}

/** Whose heights the surfaces have. */
static void heights(struct text *out, const struct direct_study *study)
{
    if (study->plan.heights)
        text_add(out,
                 " The surfaces are given the scan's distribution of heights; Gaussian ones with the same spectrum "
                 "stand beside them, which shows what skewness does.");
}

static void introduction(struct text *out, const struct section_context *context, const struct direct_study *study)
{
    section_named(out, "Surface ", context->results, study->surface);
    text_add(out, ", solved by boundary elements without the models' assumptions:");
    resolution(out, study, &context->results->surfaces[study->surface].summary.power_law);
    heights(out, study);
    text_add(out,
             " The models are given the spectrum of the same surface%s rows, so a ratio is the model's error and "
             "not the scan's.",
             study->plan.side > 0 ? "'s" : "s'");
    if (study->curves[DIRECT_STUDY_CAPPED].points) {
        number_format_between(
            out,
            " Elastic-plastic models are held against a solution whose pressure is capped at a "
            "hardness of ",
            study->plan.hardness * results_pair(context->results, study->surface)->effective_modulus_Pa * 1e-6, 3,
            " MPa, at the loads below it; its area is P over the hardness, whatever the roughness, "
            "so there area tests the hardness alone.");
    }
    text_add(out, "\n\n");
}

/** What the error of a direct solution is. */
static const char *error_words(const struct direct_study *study)
{
    return study->plan.side > 0 ? "what every second point alone, the low-pass and so small a part of a surface change"
                                : "one standard error over the surfaces";
}

/** The three loads of the table. */
static size_t table_load(const struct direct_study *study, int k)
{
    return (size_t)k * (study->plan.loads - 1) / 2;
}

static void direct_row(struct text *out, const struct section_context *context, const struct direct_study *study,
                       enum direct_study_kind kind, size_t i, const char *name)
{
    const struct material_pair *pair = results_pair(context->results, study->surface);
    if (!study->curves[kind].points || i >= study->curves[kind].loads)
        return;
    text_add(out, "| ");
    section_load(out, context->results, study->surface, study->plan.load[i]);
    text_add(out, " | %s", name);
    for (int q = 0; q < DIRECT_STUDY_QUANTITIES; q++) {
        double error, value = direct_study_value(study, pair, kind, direct_study_quantities[q], i, &error);
        double scale = direct_study_quantities[q] == QUANTITY_SEPARATION ? 1e6 : 1;
        if (!has(context, q))
            continue;
        text_add(out, " | ");
        if (isfinite(error) && error > 0)
            number_format_uncertain(out, value * scale, error * scale);
        else
            number_format(out, value * scale, 3);
    }
    text_add(out, " | | |\n");
}

static void model_row(struct text *out, const struct section_context *context, const struct direct_study *study,
                      const struct surface_record *scan, size_t m, size_t i)
{
    const struct material_pair *pair = results_pair(context->results, study->surface);
    double as_scanned = NAN;
    if (i >= study->curves[direct_study_kind_of(study, m)].loads)
        return;
    text_add(out, "| ");
    section_load(out, context->results, study->surface, study->plan.load[i]);
    text_add(out, " | %s", model_rows[m]->label);
    text_add(out, " over it");
    for (int q = 0; q < DIRECT_STUDY_QUANTITIES; q++)
        if (has(context, q))
            section_cell(out, direct_study_ratio(study, pair, m, direct_study_quantities[q], i), 3);
    for (size_t p = 0; p < scan->curves[m].count; p++)
        if (scan->curves[m].points[p].value[QUANTITY_LOAD] == study->plan.load[i])
            as_scanned = scan->curves[m].points[p].value[QUANTITY_AREA] /
                         direct_study_value(study, pair, direct_study_kind_of(study, m), QUANTITY_AREA, i, NULL);
    section_cell(out, as_scanned, 3);
    section_cell(out, direct_study_conductance(study, pair, m, i), 3);
    text_add(out, " |\n");
}

static void table(struct text *out, const struct section_context *context, const struct direct_study *study,
                  const struct surface_record *scan)
{
    static const char *const columns[DIRECT_STUDY_QUANTITIES] = {"A/Aₙ", "gap (µm)", "ECR·Aₙ (Ω·m²)"};
    struct text rule = {0};
    text_add(out, "| ");
    section_load_symbol(out, context->results);
    text_add(out, " | ");
    text_add(&rule, "|---:|---");
    for (int q = 0; q < DIRECT_STUDY_QUANTITIES; q++)
        if (has(context, q)) {
            text_add(out, " | %s", columns[q]);
            text_add(&rule, "|---:");
        }
    text_add(out, " | area, the scan's own | conductance |\n%s|---:|---:|\n", text_string(&rule));
    text_free(&rule);
    for (int k = 0; k < 3; k++) {
        size_t i = table_load(study, k);
        if (k > 0 && i == table_load(study, k - 1))
            continue;
        enum direct_study_kind other =
            study->leading == DIRECT_STUDY_HEIGHTS ? DIRECT_STUDY_GAUSSIAN : DIRECT_STUDY_HEIGHTS;
        direct_row(out, context, study, study->leading, i, "**direct, elastic**");
        direct_row(out, context, study, other, i,
                   other == DIRECT_STUDY_GAUSSIAN ? "direct, Gaussian heights" : "direct, the scan's heights");
        direct_row(out, context, study, DIRECT_STUDY_CAPPED, i, "**direct, with the hardness**");
        for (size_t m = 0; m < model_count; m++)
            if (study->models[m].exists)
                model_row(out, context, study, scan, m, i);
    }
    text_add(out,
             "\nModels as ratios to the direct solution; the last but one column for the scan's own spectrum "
             "instead of the surface's rows. Conductance: −½(ρ₁+ρ₂)E′ dḡ/dp̄ of an elastic model's own gap over its "
             "own ECR, 1 in a consistent model (Barber). ± is %s.",
             error_words(study));
    if (study->plan.side == 0 && study->curves[study->leading].seeds == 1)
        text_add(out, " Where it is missing a single surface was solved, which has no scatter to tell.");
    for (int kind = 0; kind < DIRECT_STUDY_KINDS; kind++)
        if (study->plan.side == 0 && study->curves[kind].points && study->curves[kind].seeds < 4 &&
            study->curves[kind].seeds < study->curves[study->leading].seeds) {
            text_add(out, " Of fewer than four surfaces it is at least the relative scatter of the first kind.");
            break;
        }
    text_add(out, "\n");
    text_add(out, "\n");
}

/** "area within 25 % (0.97 to 1.05)". */
static void add_distance(struct text *out, const struct direct_study_distance *distance, int q)
{
    double worst = fmax(distance->most, 1 / distance->least);
    text_add(out, "%s %s (", quantity_words[q],
             worst <= 1.25 ? "within 25 %"
             : worst <= 2  ? "within a factor 2"
                           : "beyond a factor 2");
    number_format_range(out, distance->least, distance->most, 2);
    text_add(out, ")");
}

static void sentences(struct text *out, const struct section_context *context, const struct direct_study *study)
{
    const struct material_pair *pair = results_pair(context->results, study->surface);
    for (size_t m = 0; m < model_count; m++) {
        bool first = true;
        for (int q = 0; q < DIRECT_STUDY_QUANTITIES; q++) {
            struct direct_study_distance distance = direct_study_distance(study, pair, m, direct_study_quantities[q]);
            if (!study->models[m].exists || !has(context, q) || distance.loads == 0)
                continue;
            if (first) {
                text_add(out, "- **%s**", model_rows[m]->label);
            }
            text_add(out, first ? ": " : "; ");
            add_distance(out, &distance, q);
            if (q == 0 || distance.loads < study->curves[direct_study_kind_of(study, m)].loads)
                text_add(out, " at %zu load%s", distance.loads, distance.loads == 1 ? "" : "s");
            first = false;
        }
        if (!first)
            text_add(out, ".\n");
    }
    size_t nearest[DIRECT_STUDY_QUANTITIES];
    bool any = false;
    for (int q = 0; q < DIRECT_STUDY_QUANTITIES; q++) {
        nearest[q] = has(context, q) ? direct_study_nearest(study, pair, direct_study_quantities[q]) : model_count;
        if (nearest[q] == model_count)
            continue;
        text_add(out, any ? ", for %s " : "\nOf the elastic models the nearest for %s is ", quantity_words[q]);
        text_add(out, "**%s**", model_rows[nearest[q]]->label);
        number_format_between(out, " (a factor ",
                              direct_study_distance(study, pair, nearest[q], direct_study_quantities[q]).mean_factor, 3,
                              " off on average)");
        any = true;
    }
    text_add(out, any ? ".\n\n" : "\n");
}

void section_direct_caption(struct text *out, const struct section_context *context, const struct figure *figure)
{
    const struct direct_study *study = figure_direct(context->results);
    enum quantity quantity = figure->row->y;
    double error = NAN, load = study->plan.load[study->plan.picture];
    double value = direct_study_value(study, results_pair(context->results, study->surface), study->leading, quantity,
                                      study->plan.picture, &error);
    text_add(out, " At ");
    section_at_load(out, context->results, study->surface, load);
    if (figure->row->kind == FIGURE_PATCHES) {
        text_add(out, " the first surface touches in %zu patch%s; ", study->patches, study->patches == 1 ? "" : "es");
        number_format_between(out, "the picture is ", study->plan.length_m * 1e6, 3, " µm wide.");
    } else if (!isfinite(value)) {
        text_add(out, " fewer than %d points of this grid touch: no number.", DIRECT_ENSEMBLE_POINTS);
    } else if (figure->row->kind == FIGURE_DIRECT) {
        const struct quantity_row *row = &quantity_rows[quantity];
        text_add(out, " the direct solution has ");
        number_format(out, row->over_sigma ? value / sqrt(study->moments.m0_m2) : value, 3);
        text_add(out, "%s%s; error bars: %s.", row->unit[0] ? " " : "", row->unit, error_words(study));
    } else {
        size_t nearest = direct_study_nearest(study, results_pair(context->results, study->surface), quantity);
        if (nearest < model_count)
            number_format_between(out, " the nearest elastic model over the whole range has ",
                                  direct_study_ratio(study, results_pair(context->results, study->surface), nearest,
                                                     quantity, study->plan.picture),
                                  3, "");
        text_add(out, nearest < model_count ? " (%s)." : "%s no model has a value.",
                 nearest < model_count ? model_rows[nearest]->label : "");
    }
}

static bool called_for(const struct section_context *context)
{
    return plan_runs(context->results->plan, EFFECT_DIRECT);
}

/** Surfaces that were to be solved and have no answer, each with why. */
static void not_solved(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    for (size_t i = 0; i < results->surface_count; i++) {
        const struct surface_summary *s = section_surface(context, i);
        if (!s->usable || !s->direct || s->direct->possible ||
            strstr(results->plan->effects[EFFECT_DIRECT].reason, s->direct->problem)) /* said already */
            continue;
        section_named(out, "Surface ", results, i);
        text_add(out, " is not solved: ");
        text_add_markdown(out, s->direct->problem);
        text_add(out, ".\n\n");
    }
}

static void write_direct(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    text_add(out, "## Against a direct solution\n\n");
    if (results->direct_count == 0) {
        text_add(out, "There is none: ");
        text_add_markdown(out, results->plan->effects[EFFECT_DIRECT].reason);
        text_add(out, ".\n\n");
        not_solved(out, context);
        return;
    }
    for (size_t k = 0; k < results->direct_count && k < SECTION_ROWS; k++) {
        const struct direct_study *study = &results->direct[k];
        introduction(out, context, study);
        sentences(out, context, study);
        table(out, context, study, &results->surfaces[study->surface]);
        if (study->surface == results->baseline)
            section_figures(out, context, "direct", section_direct_caption);
    }
    not_solved(out, context);
    if (results->scene->direct.budget_s > 0) {
        text_add(out, "The direct solution was ");
        text_add_markdown(out, results->plan->effects[EFFECT_DIRECT].reason);
        text_add(out, ".\n");
    }
}

const struct section section_direct = {"direct", called_for, write_direct};
