/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How sure the numbers are: by the scatter of repeated scans, or by records simulated from a single one. */
#include "report/section.h"

#include <math.h>

/** "0.240 (0.21…0.27)": a number with its 95 % interval, as a cell. */
static void interval_cell(struct text *out, const struct estimate *estimate, double scale)
{
    text_add(out, " | ");
    section_interval(out, estimate, scale, 3);
}

static bool called_for(const struct section_context *context)
{
    return results_intervals(context->results);
}

static bool has_several(const struct section_context *context)
{
    for (size_t k = 0; k < context->results->usable_count; k++)
        if (surface_repeats(section_smoothest(context, k))->count > 0)
            return true;
    return false;
}

/** What a surface's interval comes from. */
static void origin(struct text *out, const struct surface_summary *summary, const struct estimate *middle,
                   bool simulated)
{
    const struct repeats *repeats = surface_repeats(summary);
    text_add(out, " | ");
    if (repeats->count == 0) {
        text_add(out, summary->single_points > 0 && simulated ? "1 scan, %d simulated records" : "1 scan",
                 SINGLE_SCAN_RECORDS);
        if (middle->heterogeneous)
            text_add(out, "; **not the same along the scan**");
    } else if (repeats->scans == 1) {
        double effective = middle->count > 0 ? middle->effective : repeats->rq_m.effective;
        text_add(out, "%zu rows of a map", repeats->count);
        if (isfinite(effective)) {
            number_format_between(out, ", worth ", effective, 2, " independent ones");
            if (effective < ESTIMATE_LEAST_EFFECTIVE)
                text_add(out, "; **the map is too small for its longest waves**");
        }
    } else {
        text_add(out, "%zu scans", repeats->scans);
        if (repeats->cut > 0)
            text_add(out, ", cut to %zu pieces of the shortest one's length", repeats->cut);
    }
}

static void surface_row(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *summary = section_surface(context, index);
    size_t leading = context->comparison->leading;
    const struct estimate *middle =
        curve_summary_estimate(surface_model(summary, leading), context->comparison->ranking.criterion);
    origin(out, summary, middle, plan_runs(context->results->plan, EFFECT_UNCERTAINTY));
    if (has_several(context)) {
        interval_cell(out, &surface_repeats(summary)->rq_m, 1e6);
        interval_cell(out, &surface_repeats(summary)->gamma, 1);
        interval_cell(out, curve_summary_estimate(surface_model(summary, leading), CURVE_FULL_LOAD), 1);
    }
    text_add(out, " | ");
    section_factor(out, middle, middle->half_width);
    text_add(out, " | ");
    section_factor(out, middle, middle->next_half_width);
}

static void write(struct text *out, const struct section_context *context)
{
    const struct comparison *study = context->comparison;
    const char *symbol = quantity_rows[study->ranking.criterion].short_symbol;
    bool several = has_several(context);
    text_add(out, "## How sure the numbers are\n\n");
    if (several)
        text_add(out,
                 "Every scan goes through the models alone; a surface's curve is the geometric mean of theirs "
                 "and the interval in which the mean of many scans lies, 95 times of 100, "
                 "is Student's on the logarithms. Scans longer than the shortest are cut to pieces of its length, rows "
                 "of a map follow each other and count as the independent ones they are worth. The averaged spectrum "
                 "is there for drawing and fitting alone. ");
    if (plan_runs(context->results->plan, EFFECT_UNCERTAINTY))
        text_add(out,
                 "Of a surface with one scan, %d Gaussian records of the same spectrum and length went through the "
                 "same steps; what they scatter is what the place of the scan alone makes: 95 %% within 2.3 standard "
                 "deviations. Where the quarters of the scan differ more than those of any record, it is not the same "
                 "along its length, and the interval follows the quarters. Periodic marks make the interval too wide. ",
                 SINGLE_SCAN_RECORDS);
    text_add(out, "The charts' bands are these intervals.\n\n| surface | from");
    if (several)
        text_add(out, " | Rq (µm) | γ of each | full contact at P/(Aₙ E′)");
    text_add(out, " | %s, 95 %% of the mean, for scans of this length | of another scan |\n|---|---%s|---:|---:|\n",
             symbol, several ? "|---:|---:|---:" : "");
    section_each_surface(out, context, surface_row);
}

const struct section section_repeats = {"repeats", called_for, write};
