/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Models and sources. */
#include "report/section.h"

#include "base/version.h"

static void write(struct text *out, const struct section_context *context)
{
    text_add(out, "## Models and sources\n\n");
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(context->results->plan, m))
            text_add(out, "- **%s** (eq. %s). Assumes: %s. Valid: %s. Source: %s.\n", model_rows[m]->label,
                     model_rows[m]->equations, model_rows[m]->assumes, model_rows[m]->valid, model_rows[m]->source);
    text_add(out,
             "\nEquations are numbered as in W. E. Wilson, *Surface separation and contact resistance considering "
             "sinusoidal elastic-plastic multiscale rough surface contact*, Auburn University, 2008, whose printed "
             "formulas carry errors; the corrected forms were used. Made by roughcontact %s.\n",
             version_string());
}

const struct section section_sources = {"sources", NULL, write};
