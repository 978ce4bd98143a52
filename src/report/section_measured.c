/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measured contact resistance beside the models. */
#include "report/section.h"

static bool called_for(const struct section_context *context)
{
    return context->results->measured != NULL;
}

static void write(struct text *out, const struct section_context *context)
{
    const struct measured *measured = context->results->measured;
    text_add(out, "## Measured contact resistance\n\nDistance of each model from the measurements on ");
    section_named(out, "surface ", context->results, context->results->baseline);
    text_add(out, ": root mean square and mean of log₁₀(model/measured), each model evaluated at the measured loads "
                  "themselves. Measured loads were given in ");
    text_add_markdown(out, measured->load_unit);
    text_add(out, ", resistances in ");
    text_add_markdown(out, measured->resistance_unit);
    text_add(out, "; the charts join the points in the order in which they were measured.\n\n");
    const struct results_load_axis axis = results_load_axis(context->results, context->results->baseline);
    text_add(out, "| model | points compared | loads compared");
    text_add(out, axis.unit ? ", " : "");
    text_add_markdown(out, axis.unit ? axis.unit : "");
    text_add(out, " | RMS distance (decades) | mean (decades) |\n|---|---:|---|---:|---:|\n");
    for (size_t m = 0; m < model_count; m++) {
        if (!context->baseline->curves[m].exists)
            continue;
        struct measured_distance distance = measured_compare(measured, context->results->answers, m);
        text_add(out, "| %s", model_rows[m]->label);
        text_add(out, " | %zu of %zu | ", distance.points, measured->count);
        number_format_range(out, axis.scale * distance.load[0], axis.scale * distance.load[1], 2);
        text_add(out, " | ");
        number_format(out, distance.rms_decades, 3);
        text_add(out, " | ");
        number_format(out, distance.bias_decades, 3);
        text_add(out, " |\n");
    }
}

const struct section section_measured = {"measured", called_for, write};
