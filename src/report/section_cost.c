/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What accuracy costs in time, and (at the end of the report) every method that was tried. */
#include "report/section.h"

#include <math.h>
#include <string.h>

/** Time factor that one more digit costs between two rows; NaN when the second gains nothing. */
static double digit_factor(const struct benchmark_row *low, const struct benchmark_row *high)
{
    double digits = log10(low->error / high->error);
    return digits > 0 ? pow(high->seconds / low->seconds, 1 / digits) : NAN;
}

/** The last row of a method before another digit more than doubles the time; NULL: it never does. */
static const struct benchmark_row *knee(const struct benchmark *cost, const char *study, const char *method)
{
    for (size_t i = 0; i + 1 < cost->count; i++) {
        const struct benchmark_row *row = &cost->rows[i], *next = row + 1;
        if (strcmp(row->study, study) != 0 || strcmp(next->study, study) != 0 || strcmp(row->method, method) != 0 ||
            strcmp(next->method, method) != 0)
            continue;
        if (row->error < 1e-2 && !(digit_factor(row, next) <= 2)) /* coarser is no answer yet */
            return row;
    }
    return NULL;
}

static void add_knee(struct text *out, const struct benchmark *cost, const char *study, const char *method)
{
    const struct benchmark_row *row = knee(cost, study, method);
    if (row)
        text_add(out, " %s: beyond %s", method, row->setting);
    else
        text_add(out, " %s: nowhere in the settings tried", method);
    text_add(out, ";");
}

/** The row of the last model's integrals by that method and setting (NULL: the chosen one). */
static const struct benchmark_row *integral_row(const struct benchmark *cost, const char *method, const char *setting)
{
    const struct benchmark_row *found = NULL;
    for (size_t i = 0; i < cost->count; i++) {
        const struct benchmark_row *row = &cost->rows[i];
        if (row->chart == BENCHMARK_INTEGRALS && strcmp(row->method, method) == 0 &&
            (setting ? strcmp(row->setting, setting) == 0 : row->chosen))
            found = row;
    }
    return found;
}

static void integrals_text(struct text *out, const struct benchmark *cost)
{
    const struct benchmark_row *panels = integral_row(cost, "Gauss-Legendre", "0.0001");
    const struct benchmark_row *fine = integral_row(cost, "Gauss-Legendre", "1e-10");
    const struct benchmark_row *simpson = integral_row(cost, "Simpson", "1000");
    const struct benchmark_row *closed = integral_row(cost, "closed form", NULL);
    const struct benchmark_row *chosen = integral_row(cost, "Gauss-Legendre", NULL);
    if (!panels || !fine || !simpson)
        return;
    if (chosen && chosen->model != panels->model) /* of the model that the others are of */
        chosen = NULL;
    if (closed) {
        text_add(out, "%s's area, load and conductance come from closed forms, ", closed->model->label);
        number_format_between(out, "within ", closed->error, 2, ". ");
    }
    if (chosen) {
        text_add(out, "%s's integrals come from Gauss-Legendre panels at tolerance %s, ", chosen->model->label,
                 chosen->setting);
        number_format_between(out, "within ", chosen->error, 2, ". ");
    }
    number_format_between(out, "With them one more digit takes ", 100 * (digit_factor(panels, fine) - 1), 2,
                          " % more time. ");
    text_add(out, "The thesis's Simpson rule of 1000 sub-intervals is off by ");
    number_format(out, simpson->error, 2);
    const struct benchmark_row *reference = chosen ? chosen : closed ? closed : fine;
    number_format_between(out, " and takes ", simpson->seconds / reference->seconds, 2, " times as long. ");
    text_add(out, "The knee, where another digit begins to cost more than twice the time:");
    add_knee(out, cost, panels->study, "Simpson");
    add_knee(out, cost, panels->study, "adaptive");
    add_knee(out, cost, panels->study, "Gauss-Legendre");
    out->length--; /* the last semicolon */
    text_add(out, ".");
}

static void curves_text(struct text *out, const struct benchmark *cost)
{
    const struct benchmark_row *thesis = benchmark_find(cost, "closure-area", "thesis", "");
    const struct benchmark_row *numeric = benchmark_find(cost, "closure-area", "numeric", "");
    if (thesis && numeric) {
        number_format_between(
            out,
            " The sinusoid's closure weighs more than any of this: against the direct numerical solution, `thesis` is "
            "off "
            "by up to ",
            100 * thesis->error, 2, " % in area, `numeric` by ");
        number_format_between(out, "", 100 * numeric->error, 2, " %, at ");
        number_format_between(out, "", numeric->seconds / thesis->seconds, 2, " times the time.");
    }
    bool first = true;
    for (size_t i = 0; i < cost->count; i++) {
        const struct benchmark_row *row = &cost->rows[i];
        if (strcmp(row->study, "loads") != 0 || strcmp(row->setting, "129") != 0)
            continue;
        text_add(out, "%s%s ", first ? " Between 129 loads, the area interpolated in log-log is off by up to: " : "; ",
                 row->method);
        number_format(out, row->error, 2);
        first = false;
    }
    if (!first)
        text_add(out, ".");
}

/** What the models' curves take at other tolerances, and how much of the report they are. */
static void tolerance_text(struct text *out, const struct benchmark *cost)
{
    const struct benchmark_row *usual = benchmark_find(cost, "tolerance", "all models", "1e-06");
    if (!usual || !(usual->seconds > 0))
        return;
    text_add(out, " Tolerance: all curves but contacting slopes' take ");
    for (size_t i = 0, listed = 0; i < cost->count; i++) {
        const struct benchmark_row *row = &cost->rows[i];
        if (strcmp(row->study, "tolerance") != 0 || row == usual)
            continue;
        text_add(out, "%s", listed++ > 0 ? ", " : "");
        number_format(out, row->seconds / usual->seconds, 2);
        text_add(out, " (%s)", row->setting);
    }
    text_add(out, " times what they take at 1e-06");
    if (cost->before > 0)
        number_format_between(out, ", which is ", 100 * usual->seconds / cost->before, 2,
                              " % of the time that this report had taken so far");
    text_add(out, ".");
}

static void cost_text(struct text *out, const struct section_context *context)
{
    const struct benchmark *cost = context->results->benchmark;
    section_named(out, "Surface ", context->results, context->results->baseline);
    text_add(
        out,
        ". Each method's largest relative error, against a better result by another method, and its time (the least "
        "of several runs, of integrals for 100 separations, of curves of several loads without what a model makes of "
        "the surface once; evaluations do not depend on the machine). ");
    integrals_text(out, cost);
    curves_text(out, cost);
    tolerance_text(out, cost);
}

static void cost_table(struct text *out, const struct section_context *context)
{
    const struct benchmark *cost = context->results->benchmark;
    text_add(out, "| study | method | setting | evaluations | time (µs) | largest relative error | |\n"
                  "|---|---|---|---:|---:|---:|---|\n");
    for (size_t i = 0; i < cost->count; i++) {
        const struct benchmark_row *row = &cost->rows[i];
        text_add(out, "| %s | %s | %s | %llu | ", row->study, row->method, row->setting,
                 (unsigned long long)row->evaluations);
        number_format(out, row->seconds * 1e6, 3);
        text_add(out, " | ");
        number_format(out, row->error, 2);
        text_add(out, " | %s |\n", row->chosen ? "used here" : row->note);
    }
}

static void caption(struct text *out, const struct section_context *context, const struct figure *figure)
{
    const struct benchmark *benchmark = context->results->benchmark;
    bool marked = false; /* does the chart hold a setting that the report uses? */
    for (size_t i = 0; i < benchmark->count; i++)
        marked = marked || (benchmark->rows[i].chart == figure->row->chart && benchmark->rows[i].chosen);
    if (figure->row->chart >= BENCHMARK_DIRECT_AREA) {
        text_add(out, " Mean error over the loads; lower left is better.");
        return;
    }
    text_add(out, " Lower left is better%s.", marked ? "; ringed: what this report uses" : "");
}

static bool called_for(const struct section_context *context)
{
    return context->results->benchmark != NULL;
}

/** Of that study the row of the same model, or of the direct solution at the same expense; NULL: none. */
static const struct benchmark_row *against_direct(const struct benchmark *cost, const char *study,
                                                  const struct benchmark_row *like)
{
    for (size_t i = 0; i < cost->count; i++) {
        const struct benchmark_row *row = &cost->rows[i];
        if (strcmp(row->study, study) == 0 && row->model == like->model &&
            (row->model || strcmp(row->setting, like->setting) == 0))
            return row;
    }
    return NULL;
}

/** The cheapest model that is within each bound of the direct solution, in area, gap and ECR together. */
static void physics_text(struct text *out, const struct section_context *context)
{
    static const struct {
        double error;
        const char *words;
    } bounds[] = {{1, "a factor 2"}, {0.25, "25 %"}, {0.05, "5 %"}};
    static const char *const studies[] = {"direct-area", "direct-gap", "direct-ecr"};
    const struct benchmark *cost = context->results->benchmark;
    const struct benchmark_row *first = NULL;
    for (size_t i = 0; i < cost->count && !first; i++)
        first = strncmp(cost->rows[i].study, "direct-", 7) == 0 ? &cost->rows[i] : NULL;
    if (!first)
        return;
    text_add(out, "**Physically**, against the direct solution (mean over its loads): ");
    for (size_t b = 0; b < sizeof bounds / sizeof *bounds; b++) {
        const struct benchmark_row *cheapest = NULL;
        for (size_t i = 0; i < cost->count; i++) { /* rows of one method in the first study stand for all */
            const struct benchmark_row *row = &cost->rows[i];
            bool within = strcmp(row->study, first->study) == 0 && (!row->model || !row->model->plastic);
            for (size_t s = 0; s < sizeof studies / sizeof *studies && within; s++) {
                const struct benchmark_row *same = against_direct(cost, studies[s], row);
                bool there = false;
                for (size_t k = 0; k < cost->count && !there; k++)
                    there = strcmp(cost->rows[k].study, studies[s]) == 0;
                within = !there || (same && same->mean <= bounds[b].error);
            }
            if (within && (!cheapest || row->seconds < cheapest->seconds))
                cheapest = row;
        }
        text_add(out, "%swithin %s in every quantity ", b > 0 ? "; " : "", bounds[b].words);
        if (cheapest) {
            text_add(out, "the cheapest is %s%s%s%s, ", cheapest->method, cheapest->model ? "" : " (",
                     cheapest->model ? "" : cheapest->setting, cheapest->model ? "" : ")");
            number_format_between(out, "", cheapest->seconds * 1e3, 2, " ms");
        } else {
            text_add(out, "comes nothing tried here");
        }
    }
    text_add(out, ".\n\n");
}

static void write_cost(struct text *out, const struct section_context *context)
{
    text_add(out, "## What accuracy costs\n\n");
    physics_text(out, context);
    cost_text(out, context);
    text_add(out, "\n\n");
    section_figures(out, context, "cost", caption);
}

static void write_methods(struct text *out, const struct section_context *context)
{
    text_add(out, "## Accuracy and time of every method tried\n\n");
    cost_table(out, context);
}

const struct section section_cost = {"cost", called_for, write_cost};
const struct section section_methods = {"methods", called_for, write_methods};
