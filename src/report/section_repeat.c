/* Repeated scans and measured resistance: how far scans of one surface, and models and measurement, lie apart. */
#include "report/section.h"

#include "report/words.h"
#include "results/measured.h"
#include <math.h>

static void plus_minus(struct text *out, const struct spread_number *number, double scale, int digits)
{
    text_add(out, " | ");
    words_number(out, number->count >= 2 ? scale * number->mean : NAN, digits);
    if (number->count >= 2) {
        text_add(out, " ± ");
        words_number(out, scale * spread_deviation(number), 2);
    }
}

/** A logarithmic number as its geometric mean, times or divided by a factor. */
static void times_divided(struct text *out, const struct spread_number *number)
{
    text_add(out, " | ");
    words_number(out, number->count >= 2 ? exp(number->mean) : NAN, 3);
    if (number->count >= 2) {
        text_add(out, " ×÷ ");
        words_number(out, exp(spread_deviation(number)), 3);
    }
}

static bool called_for(const struct section_context *context, int model)
{
    const struct plan *plan = context->results->plan;
    return model_called_for((enum model_id)model, plan->families, plan->running);
}

static void repeat_table(struct text *out, const struct section_context *context)
{
    if (!results_repeated(context->results))
        return;
    text_add(out, "| surface | scans | run alone | Rq (µm) | γ | γ, 95 %% of resamples | α");
    for (int m = 0; m < MODEL_COUNT; m++)
        if (called_for(context, m))
            text_add(out, " | full contact, %s", model_rows[m].label);
    text_add(out, " |\n|---|---:|---:|---:|---:|---:|---:");
    for (int m = 0; m < MODEL_COUNT; m++)
        if (called_for(context, m))
            text_add(out, "|---:");
    text_add(out, "|\n");
    for (size_t i = 0; i < context->results->spool->count; i++) {
        const struct surface_summary *summary = &context->results->spool->summaries[i];
        const struct spread *spread = &summary->spread;
        if (!summary->usable || spread->parts == 0)
            continue;
        text_add(out, "| ");
        words_surface(out, context->results, i);
        text_add(out, " | %zu | %zu", summary->scans, spread->parts);
        plus_minus(out, &spread->rq_m, 1e6, 3);
        plus_minus(out, &spread->gamma, 1, 3);
        text_add(out, " | ");
        words_number(out, spread->gamma_interval[0], 3);
        text_add(out, "…");
        words_number(out, spread->gamma_interval[1], 3);
        times_divided(out, &spread->log_alpha);
        for (int m = 0; m < MODEL_COUNT; m++)
            if (called_for(context, m))
                times_divided(out, &spread->log_full_load[m]);
        text_add(out, " |\n");
    }
}

static void measured_text(struct text *out, const struct section_context *context)
{
    const struct measured *measured = context->results->measured;
    if (!measured)
        return;
    text_add(out, "Measured loads were given in ");
    text_add_markdown(out, measured->load_unit);
    text_add(out, ", resistances in ");
    text_add_markdown(out, measured->resistance_unit);
    text_add(out, "; the charts join the points in the order in which they were measured.");
}

static void measured_table(struct text *out, const struct section_context *context)
{
    const struct measured *measured = context->results->measured;
    if (!measured)
        return;
    text_add(out, "| model | points compared | loads compared | RMS distance (decades) | mean (decades) |\n"
                  "|---|---:|---|---:|---:|\n");
    for (int m = 0; m < MODEL_COUNT; m++) {
        if (!context->baseline->curves[m].exists)
            continue;
        struct measured_distance distance = measured_compare(measured, &context->baseline->curves[m]);
        text_add(out, "| %s | %zu of %zu | ", model_rows[m].label, distance.points, measured->count);
        words_range(out, distance.load[0], distance.load[1], 2);
        text_add(out, " | ");
        words_number(out, distance.rms_decades, 3);
        text_add(out, " | ");
        words_number(out, distance.bias_decades, 3);
        text_add(out, " |\n");
    }
}

const struct section_row section_repeat[] = {
    {"repeat_table", repeat_table},
    {"measured_text", measured_text},
    {"measured_table", measured_table},
    {NULL, NULL},
};
