/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report/section.h"

#include "analysis/direct_study.h"
#include <math.h>
#include <string.h>
#include <strings.h>

void section_surface_name(struct text *out, const struct results *results, size_t index)
{
    text_add_markdown(out, results->surfaces[index].summary.scene->name);
}

void section_named(struct text *out, const char *article, const struct results *results, size_t index)
{
    const char *name = results->surfaces[index].summary.scene->name;
    if (strncasecmp(name, article, strlen(article) - 1) != 0)
        text_add(out, "%s", article);
    section_surface_name(out, results, index);
}

const char *const section_first_page[SECTION_FIRST_PLACES] = {"first page", "first page, direct"};

static bool is_numbered(const struct figure *figure)
{
    return figure->row->number > 0 && figure->number[0] == '6';
}

static const char *place_of(const struct figure *figure)
{
    if (!figure->decides)
        return figure->row->section;
    return section_first_page[figure->row->kind == FIGURE_SURFACES ? SECTION_FIRST_SURFACES : SECTION_FIRST_DIRECT];
}

bool section_has_figures(const struct section_context *context, const char *place)
{
    for (size_t i = 0; i < context->figures->count; i++)
        if (strcmp(place_of(&context->figures->figures[i]), place) == 0)
            return true;
    return false;
}

void section_figures(struct text *out, const struct section_context *context, const char *place,
                     section_caption *caption)
{
    for (size_t i = 0; i < context->figures->count; i++) {
        const struct figure *figure = &context->figures->figures[i];
        if (strcmp(place_of(figure), place) != 0)
            continue;
        text_add(out, "![");
        if (is_numbered(figure))
            text_add(out, "Figure %s. ", figure->number);
        text_add(out, "%s", figure->title);
        if (figure->row->kind == FIGURE_MODELS || figure->row->kind == FIGURE_SENSITIVITY ||
            figure->row->kind == FIGURE_DIRECT || figure->row->kind == FIGURE_DIRECT_RATIO ||
            figure->row->kind == FIGURE_PATCHES) {
            text_add(out, ", ");
            section_named(out, "surface ", context->results, context->results->baseline);
        }
        text_add(out, ".");
        if (caption)
            caption(out, context, figure);
        text_add(out, "](figures/%s%s)\n\n", figure->number, figure_extension(figure->row));
    }
    for (size_t i = 0; i < context->figures->count; i++) {
        const struct figure *figure = &context->figures->figures[i];
        if (figure->decides && strcmp(figure->row->section, place) == 0)
            text_add(out, "%s%s: see the first page.\n\n", is_numbered(figure) ? "Figure " : "",
                     is_numbered(figure) ? figure->number : figure->title);
    }
}

void section_cut(struct text *out, const struct section_context *context, const struct figure *figure)
{
    bool first = true;
    for (size_t m = 0; m < model_count && figure->row->y == QUANTITY_SEPARATION; m++) {
        const struct model_curve *curve = &context->baseline->curves[m];
        double sigma_m = context->baseline->summary.asperities.sigma_m, lowest = INFINITY;
        if (!curve->exists || !section_computes(context, QUANTITY_ADJUSTED) ||
            !(model_rows[m]->quantities & QUANTITY_BIT(QUANTITY_ADJUSTED)))
            continue;
        for (size_t i = 0; i < curve->count; i++)
            lowest = fmin(lowest, curve->points[i].value[QUANTITY_SEPARATION] / sigma_m);
        if (!(lowest < figure_lowest_separation))
            continue;
        if (first)
            number_format_between(out, " Cut at ", figure_lowest_separation, 1, " σ: unadjusted, ");
        text_add(out, "%s%s", first ? "" : ", ", model_rows[m]->label);
        number_format_between(out, first ? " goes down to " : " to ", lowest, 2, " σ");
        first = false;
    }
    text_add(out, "%s", first ? "" : ".");
}

void section_at_middle(struct text *out, const struct section_context *context, enum quantity quantity, double value)
{
    const struct quantity_row *row = &quantity_rows[quantity];
    text_add(out, " At ");
    section_at_load(out, context->results, context->results->baseline, context->comparison->middle_load);
    text_add(out, row->over_sigma ? ", the %s is " : ", %s is ", row->over_sigma ? row->short_symbol : row->symbol);
    number_format(out, value, 3);
    text_add(out, "%s%s", row->unit[0] ? " " : "", row->unit);
}

void section_to(struct text *out, enum quantity quantity, double value)
{
    const char *unit = quantity_rows[quantity].unit;
    number_format_between(out, " to ", value, 3, unit[0] ? " " : "");
    text_add(out, "%s", unit);
}

const struct surface_summary *section_surface(const struct section_context *context, size_t index)
{
    return &context->results->surfaces[index].summary;
}

const struct surface_summary *section_smoothest(const struct section_context *context, size_t k)
{
    return section_surface(context, context->results->by_roughness[k]);
}

bool section_extended(const struct section_context *context)
{
    for (size_t k = 0; k < context->results->usable_count; k++)
        for (size_t m = 0; m < model_count; m++)
            if (surface_model(section_smoothest(context, k), m)->extended)
                return true;
    return false;
}

const char *section_law(size_t model, const char *plastic)
{
    const struct model_row *row = model_rows[model];
    return row->thesis_place == 0 ? row->label : row->plastic ? plastic : "elastic";
}

bool section_computes(const struct section_context *context, enum quantity quantity)
{
    return plan_quantities(context->results->plan) & QUANTITY_BIT(quantity);
}

size_t section_table_load(const struct results *results, size_t k)
{
    return k * (results->load_count - 1) / 4;
}

const struct contact_point *section_middle(const struct section_context *context, size_t model)
{
    const struct model_curve *curve = &context->baseline->curves[model];
    for (size_t i = 0; i < curve->count; i++)
        if (curve->points[i].value[QUANTITY_LOAD] == context->comparison->middle_load)
            return &curve->points[i];
    return NULL;
}

void section_middle_pressure(struct text *out, const struct section_context *context)
{
    double load = context->comparison->middle_load, pressure_Pa = material_pair_pressure(section_pair(context), load);
    bool force = context->results->scene->load.unit_text[0] && context->results->scene->load.kind == UNIT_FORCE;
    if (isnan(pressure_Pa) || force)
        section_at_load(out, context->results, context->results->baseline, load);
    if (!isnan(pressure_Pa))
        number_format_between(out, force ? " (" : "", pressure_Pa * 1e-6, 3, force ? " MPa)" : " MPa");
}

void section_load(struct text *out, const struct results *results, size_t surface, double load)
{
    struct results_load_axis axis = results_load_axis(results, surface);
    if (axis.unit)
        number_format(out, load * axis.scale, 3);
    else
        number_format_power(out, load, 3);
}

void section_load_symbol(struct text *out, const struct results *results)
{
    struct results_load_axis axis = results_load_axis(results, results->baseline);
    if (!axis.unit) {
        text_add(out, "P/(Aₙ E′)");
        return;
    }
    text_add(out, results->scene->load.kind == UNIT_FORCE ? "load in " : "pressure in ");
    text_add_markdown(out, axis.unit);
}

void section_at_load(struct text *out, const struct results *results, size_t surface, double load)
{
    struct results_load_axis axis = results_load_axis(results, surface);
    text_add(out, axis.unit ? "" : "P/(Aₙ E′) = ");
    section_load(out, results, surface, load);
    if (axis.unit) {
        text_add(out, " ");
        text_add_markdown(out, axis.unit);
    }
}

const struct material_pair *section_pair(const struct section_context *context)
{
    return results_pair(context->results, context->results->baseline);
}

bool section_is_valid(const struct surface_summary *summary, size_t model, double load)
{
    return curve_summary_is_valid(surface_model(summary, model), load);
}

bool section_exceeds_hardness(const struct section_context *context, size_t surface, const struct contact_point *point)
{
    static const double allowed = 1.001;
    const struct material_pair *pair = results_pair(context->results, surface);
    return material_pair_pressure(pair, point->value[QUANTITY_LOAD]) >
           allowed * pair->hardness_Pa * point->value[QUANTITY_AREA];
}

void section_hardness(struct text *out, const struct material_pair *pair)
{
    bool given = fabs(pair->hardness_Pa / (material_hardness_ratio * pair->yield_strength_Pa) - 1) > 1e-12;
    number_format_between(out, "the hardness of ", pair->hardness_Pa * 1e-6, 3, " MPa");
    text_add(out, given ? "" : " (%.3g S_y, as none is given)", material_hardness_ratio);
}

bool section_is_unfit(const struct section_context *context, size_t surface, size_t m)
{
    const struct contact_point point = comparison_middle(context->results, m, surface);
    return model_rows[context->comparison->leading]->plastic && !model_rows[m]->plastic &&
           section_exceeds_hardness(context, surface, &point);
}

double section_contact_pressure(const struct section_context *context, size_t surface,
                                const struct contact_point *point)
{
    const struct material_pair *pair = results_pair(context->results, surface);
    return point->value[QUANTITY_LOAD] / point->value[QUANTITY_AREA] * pair->effective_modulus_Pa /
           pair->yield_strength_Pa;
}

bool section_knows_yield(const struct section_context *context)
{
    return isfinite(section_pair(context)->yield_strength_Pa);
}

struct comparison_extremes section_models(const struct section_context *context, enum quantity quantity, bool valid)
{
    struct comparison_extremes extremes = {.least = INFINITY, .most = -INFINITY};
    for (size_t m = 0; m < model_count; m++) {
        const struct contact_point *point = section_middle(context, m);
        double value =
            point ? comparison_value(point, quantity, m, context->baseline->summary.asperities.sigma_m) : NAN;
        if (isnan(value) ||
            (valid && (!section_is_valid(&context->baseline->summary, m, context->comparison->middle_load) ||
                       section_is_unfit(context, context->results->baseline, m))))
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

bool section_range(double *least, double *most, const struct section_context *context, size_t model,
                   double (*number)(const struct curve_summary *))
{
    *least = INFINITY;
    *most = -INFINITY;
    for (size_t k = 0; k < context->results->usable_count; k++) {
        const struct curve_summary *summary = surface_model(section_smoothest(context, k), model);
        double value = summary->exists ? number(summary) : NAN;
        if (isfinite(value)) {
            *least = fmin(*least, value);
            *most = fmax(*most, value);
        }
    }
    return *least <= *most;
}

void section_each_surface(struct text *out, const struct section_context *context,
                          void (*row)(struct text *out, const struct section_context *context, size_t index))
{
    size_t rows = 0;
    for (size_t i = 0; i < context->results->surface_count && rows < SECTION_ROWS; i++)
        if (section_surface(context, i)->usable) {
            text_add(out, "| ");
            section_surface_name(out, context->results, i);
            row(out, context, i);
            text_add(out, " |\n");
            rows++;
        }
    if (rows < context->results->usable_count)
        text_add(out, "| … %zu more in data/ |\n", context->results->usable_count - rows);
}

void section_interval(struct text *out, const struct estimate *estimate, double scale, int digits)
{
    number_format(out, estimate->count > 0 ? scale * estimate_value(estimate) : NAN, digits);
    number_format_interval(out, " (", scale * estimate_end(estimate, 0), scale * estimate_end(estimate, 1), digits,
                           ")");
}

void section_factor(struct text *out, const struct estimate *estimate, double half_width)
{
    bool known = estimate_has_width(estimate, half_width);
    text_add(out, "%s", !known ? "" : estimate->logarithmic ? "×÷ " : "± ");
    number_format(out, !known ? NAN : estimate->logarithmic ? exp(half_width) : half_width, 3);
}

void section_cell(struct text *out, double value, int digits)
{
    text_add(out, " | ");
    number_format(out, value, digits);
}

void section_load_cell(struct text *out, const struct section_context *context, size_t index, double load)
{
    text_add(out, " | ");
    section_load(out, context->results, index, load);
}

void section_threshold_cell(struct text *out, const struct section_context *context, size_t index,
                            const struct curve_summary *curve, double load)
{
    if (load <= curve->first_load)
        text_add(out, " | from the first load on");
    else
        section_load_cell(out, context, index, load);
}

void section_error_cell(struct text *out, double value, double error)
{
    text_add(out, " | ");
    number_format_uncertain(out, value, error);
}

void section_given(struct text *out, const char *before, double value, const char *after)
{
    text_add(out, "%s", before);
    number_format_given(out, value);
    text_add(out, "%s", after);
}
