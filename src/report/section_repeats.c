/* How far repeated scans of one surface lie apart. */
#include "report/section.h"

#include <math.h>

static void plus_minus(struct text *out, const struct repeats_number *number, double scale, int digits)
{
    text_add(out, " | ");
    number_format(out, number->count >= 2 ? scale * number->mean : NAN, digits);
    if (number->count >= 2) {
        text_add(out, " ± ");
        number_format(out, scale * repeats_deviation(number), 2);
    }
}

/** A logarithmic number as its geometric mean, times or divided by a factor. */
static void times_divided(struct text *out, const struct repeats_number *number)
{
    text_add(out, " | ");
    number_format(out, number->count >= 2 ? exp(number->mean) : NAN, 3);
    if (number->count >= 2) {
        text_add(out, " ×÷ ");
        number_format(out, exp(repeats_deviation(number)), 3);
    }
}

static bool called_for(const struct section_context *context)
{
    return results_repeated(context->results);
}

static void write(struct text *out, const struct section_context *context)
{
    const struct plan *plan = context->results->plan;
    text_add(out, "## How far repeated scans lie apart\n\n"
                  "Every scan (or row of a map) was also run alone: mean ± one standard deviation of the single scans, "
                  "for α and loads as geometric mean ×÷ factor; γ also as the middle 95 %% of bootstrap resamples of "
                  "the scans. The charts' bands are one standard deviation to either side.\n\n");
    text_add(out, "| surface | scans | run alone | Rq (µm) | γ | γ, 95 %% of resamples | α");
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(plan, m))
            text_add(out, " | full contact, %s", model_rows[m]->label);
    text_add(out, " |\n|---|---:|---:|---:|---:|---:|---:");
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(plan, m))
            text_add(out, "|---:");
    text_add(out, "|\n");
    for (size_t i = 0; i < context->results->store->count; i++) {
        const struct surface_summary *summary = &context->results->store->summaries[i];
        const struct repeats *spread = &summary->repeats;
        if (!summary->usable || spread->count == 0)
            continue;
        text_add(out, "| ");
        section_surface_name(out, context->results, i);
        text_add(out, " | %zu | %zu", summary->scans, spread->count);
        plus_minus(out, &spread->rq_m, 1e6, 3);
        plus_minus(out, &spread->gamma, 1, 3);
        text_add(out, " | ");
        number_format(out, spread->gamma_interval[0], 3);
        text_add(out, "…");
        number_format(out, spread->gamma_interval[1], 3);
        times_divided(out, &spread->log_alpha);
        for (size_t m = 0; m < model_count; m++)
            if (plan_runs_model(plan, m))
                times_divided(out, &summary->models[m].repeated_log_full_load);
        text_add(out, " |\n");
    }
}

const struct section section_repeats = {"repeats", called_for, write};
