/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The correlations that handbooks print for contact by truncation, beside the closed forms they are fitted to. */
#include "report/section.h"

#include "contact/truncation_model.h"
#include <math.h>

static bool truncates(const struct section_context *context, size_t m)
{
    return plan_runs_model(context->results->plan, m) && model_rows[m]->truncation_model;
}

static bool called_for(const struct section_context *context)
{
    bool conducts = section_computes(context, QUANTITY_ECR) || section_computes(context, QUANTITY_TCR);
    for (size_t m = 0; m < model_count && conducts; m++)
        if (truncates(context, m))
            return true;
    return false;
}

/** Calls `each` for the law of every model that runs, and for the elastic one, which is nobody's model. */
static void each_law(struct text *out, const struct section_context *context, const struct model_task *task,
                     void (*each)(struct text *out, const struct section_context *context,
                                  const struct model_task *task, const struct truncation_model *model))
{
    for (size_t m = 0; m < model_count; m++)
        if (truncates(context, m))
            each(out, context, task, model_rows[m]->truncation_model);
    each(out, context, task, &truncation_model_elastic);
}

/** Contact resistance and conductance of h sigma/(k m) = conductance. */
static void conductance_cells(struct text *out, const struct section_context *context, const struct truncation *law,
                              double conductance)
{
    const struct material_pair *pair = section_pair(context);
    const struct truncation_contact contact = {.conductance = conductance};
    if (section_computes(context, QUANTITY_ECR))
        section_cell(out, truncation_resistance(law, &contact, pair->resistivity_ohm_m), 3);
    if (section_computes(context, QUANTITY_TCR))
        section_cell(out, 1 / truncation_resistance(law, &contact, 1 / pair->conductivity_W_per_mK), 3);
}

static void law_row(struct text *out, const struct section_context *context, const struct model_task *task,
                    const struct truncation_model *model)
{
    const struct truncation law = model->law(task);
    double ratio = truncation_model_ratio(&law, task, task->loads[0]);
    double correlation = model->correlation(ratio, task);
    struct truncation_contact contact = {.conductance = NAN};
    if (!truncation_press(&contact, &law, ratio))
        correlation = NAN; /* nothing to hold it against */
    text_add(out, "| ");
    section_load(out, context->results, context->results->baseline, task->loads[0]);
    text_add(out, " | %s", model->label);
    section_cell(out, ratio, 3);
    conductance_cells(out, context, &law, contact.conductance);
    conductance_cells(out, context, &law, correlation);
    section_cell(out, correlation / contact.conductance, 3);
    text_add(out, "%s |\n", isnan(correlation) || truncation_model_tested(model, ratio) ? "" : " †");
}

static void table(struct text *out, const struct section_context *context, const struct model_task *task)
{
    const struct results *results = context->results;
    const double *loads = results_loads(results, results->baseline);
    const bool shown[] = {section_computes(context, QUANTITY_ECR), section_computes(context, QUANTITY_TCR)};
    static const char *const heads[] = {"ECR·Aₙ (Ω·m²)", "h (W/(m²·K))"};
    struct text rule = {0};
    text_add(out, "| ");
    section_load_symbol(out, results);
    text_add(out, " | closed form | P/H");
    text_add(&rule, "|---:|---|---:|");
    for (int by = 0; by < 2; by++)
        for (int q = 0; q < 2; q++)
            if (shown[q]) {
                text_add(out, " | %s%s", heads[q], by ? " by correlation" : "");
                text_add(&rule, "---:|");
            }
    text_add(out, " | ratio |\n%s---:|\n", text_string(&rule));
    text_free(&rule);
    for (size_t k = 1; k <= 3; k++) {
        struct model_task one = *task;
        one.loads = &loads[section_table_load(results, k)];
        one.load_count = 1;
        if (k == 1 || one.loads[0] != loads[section_table_load(results, k - 1)])
            each_law(out, context, &one, law_row);
    }
}

static void law_line(struct text *out, const struct section_context *context, const struct model_task *task,
                     const struct truncation_model *model)
{
    (void)context;
    text_add(out, "- %s: h σ/(k m) = %s; H is %s, ", model->label, model->formula, model->hardness);
    number_format_between(out, "", model->law(task).hardness_Pa * 1e-6, 4, " MPa. For P/H from ");
    number_format_range(out, model->least, model->most, 2);
    text_add(out, ": %s.\n", model->agreement);
}

static void write(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    const struct model_task task = surface_model_task(context->baseline, results->scene, results->plan,
                                                      results_loads(results, results->baseline), results->load_count);
    text_add(out, "## Correlations in use\n\n");
    section_named(out, "Surface ", results, results->baseline);
    number_format_between(out, ": σ = ", truncation_model_sigma(&task) * 1e6, 4,
                          " µm and the mean absolute slope m = ");
    number_format(out, truncation_model_slope(&task), 4);
    text_add(out, ", both of its spectrum%s. ",
             surface_repeats(&context->baseline->summary)->count > 0
                 ? ", averaged over its scans (curves are means over the scans)"
                 : "");
    text_add(out, "Handbooks print powers of the load for the contact conductance h of such a surface; here they stand "
                  "beside the closed forms that they are fitted to. The ratio is the conductance by correlation over "
                  "the closed form's; † outside the P/H in which that was tested. Contact is elastic where E′m/√2 is "
                  "below the hardness.\n\n");
    table(out, context, &task);
    text_add(out, "\n");
    each_law(out, context, &task, law_line);
    text_add(out, "\nAll need Gaussian heights and are for the first loading, up to P/H = %g.\n\n",
             TRUNCATION_VALID_AREA);
}

const struct section section_correlations = {"correlations", called_for, write};
