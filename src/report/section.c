#include "report/section.h"

#include "base/number_format.h"
#include <math.h>

const struct surface_summary *section_surface(const struct section_context *context, size_t index)
{
    return &context->results->store->summaries[index];
}

bool section_extended(const struct section_context *context)
{
    for (size_t i = 0; i < context->results->store->count; i++)
        for (int m = 0; m < MODEL_COUNT; m++)
            if (section_surface(context, i)->models[m].extended)
                return true;
    return false;
}

bool section_called_for(const struct section_context *context, enum model_id model)
{
    const struct plan *plan = context->results->plan;
    return model_called_for(model, plan->families, plan->running);
}

const struct contact_point *section_middle(const struct section_context *context, enum model_id model)
{
    const struct model_curve *curve = &context->baseline->curves[model];
    for (size_t i = 0; i < curve->count; i++)
        if (curve->points[i].load == context->study->middle_load)
            return &curve->points[i];
    return NULL;
}

void section_middle_pressure(struct text *out, const struct section_context *context)
{
    number_format_add(out, "", context->study->middle_load * context->results->plan->pair.effective_modulus_Pa * 1e-6,
                      3, " MPa");
}

struct comparison_extremes section_models(const struct section_context *context, enum comparison_quantity quantity)
{
    struct comparison_extremes extremes = {.least = INFINITY, .most = -INFINITY};
    for (int m = 0; m < MODEL_COUNT; m++) {
        const struct contact_point *point = section_middle(context, (enum model_id)m);
        double value =
            point ? comparison_value(point, quantity, (enum model_id)m, context->baseline->summary.asperities.sigma_m)
                  : NAN;
        if (isnan(value))
            continue;
        extremes.count++;
        if (value < extremes.least) {
            extremes.least = value;
            extremes.least_at = (size_t)m;
        }
        if (value > extremes.most) {
            extremes.most = value;
            extremes.most_at = (size_t)m;
        }
    }
    return extremes;
}

void section_each_surface(struct text *out, const struct section_context *context,
                          void (*row)(struct text *out, const struct section_context *context, size_t index))
{
    size_t rows = 0;
    for (size_t i = 0; i < context->results->store->count && rows < SECTION_ROWS; i++)
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

void section_cell(struct text *out, double value, int digits)
{
    text_add(out, " | ");
    number_format_number(out, value, digits);
}

void section_load_cell(struct text *out, double load)
{
    text_add(out, " | ");
    number_format_power(out, load, 3);
}
