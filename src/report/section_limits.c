/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The end of the first page: what limits the answer, and what to measure next. */
#include "report/section.h"
#include "results/limits_of_answer.h"

#include <math.h>

/** Is the factor as far off as a property not known well? */
static bool matters(const struct limit_of_answer *doubt)
{
    return fabs(log(doubt->factor)) >= log(1 + limit_of_answer_tolerance) * (1 - 1e-9);
}

static void row(struct text *out, const struct section_context *context, const struct limit_of_answer *doubt)
{
    text_add(out, "| %s | %s | %s", doubt->row->what, doubt->row->changed, doubt->row->either_way ? "×÷ " : "× ");
    number_format(out, doubt->factor, 3);
    if (!doubt->alike) {
        text_add(out, " (");
        section_named(out, "surface ", context->results, doubt->surface);
        text_add(out, ")");
    }
    text_add(out, " | %s |\n", matters(doubt) ? doubt->next : "–");
}

static bool called_for(const struct section_context *context)
{
    struct limit_of_answer doubts[LIMITS_OF_ANSWER_MOST];
    return limits_of_answer(doubts, context->results, context->comparison) > 0;
}

static void write(struct text *out, const struct section_context *context)
{
    struct limit_of_answer doubts[LIMITS_OF_ANSWER_MOST];
    size_t count = limits_of_answer(doubts, context->results, context->comparison);
    text_add(out, "**What limits this answer**, the most first: factors on %s, one thing changed at a time%s.\n\n",
             quantity_rows[results_criterion(context->results)].symbol,
             context->results->usable_count > 1 ? ", on the surface that it changes most" : "");
    text_add(out, "| what | changed | factor | to measure next |\n|---|---|---:|---|\n");
    for (size_t k = 0; k < count; k++)
        row(out, context, &doubts[k]);
}

const struct section section_limits = {"doubts", called_for, write};
