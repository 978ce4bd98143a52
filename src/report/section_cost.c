/* What was computed, and what accuracy costs in time. */
#include "report/section.h"

#include "analysis/benchmark.h"
#include "base/number_format.h"
#include <math.h>
#include <string.h>

static void work_rows(struct text *out, const struct section_context *context)
{
    struct work_row predicted[WORK_ROWS], done[WORK_ROWS];
    const struct results *results = context->results;
    work_table(predicted, &results->predicted, results->plan);
    work_table(done, &results->done, results->plan);
    text_add(out, "| effect | | why | method | evaluations predicted | done |\n|---|---|---|---|---:|---:|\n");
    for (int r = 0; r < WORK_ROWS; r++)
        text_add(out, "| %s | %s | %s | %s | %llu | %llu |\n", predicted[r].name, predicted[r].runs ? "run" : "skipped",
                 predicted[r].reason, predicted[r].method, (unsigned long long)predicted[r].evaluations,
                 (unsigned long long)done[r].evaluations);
}

/** The study whose numbers a statistical report rests on: JG where it ran, else GW. */
static const char *main_study(const struct benchmark *cost)
{
    return benchmark_find(cost, "jg-integrals", "Gauss-Legendre", NULL) ? "jg-integrals" : "gw-integrals";
}

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

static void add(struct text *out, const char *before, double value, int digits, const char *after)
{
    text_add(out, "%s", before);
    number_format_number(out, value, digits);
    text_add(out, "%s", after);
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

static void integrals_text(struct text *out, const struct benchmark *cost)
{
    const char *study = main_study(cost), *law = study[0] == 'j' ? "JG" : "GW";
    const struct benchmark_row *panels = benchmark_find(cost, study, "Gauss-Legendre", "0.0001");
    const struct benchmark_row *fine = benchmark_find(cost, study, "Gauss-Legendre", "1e-10");
    const struct benchmark_row *simpson = benchmark_find(cost, study, "Simpson", "1000");
    const struct benchmark_row *closed = benchmark_find(cost, "gw-integrals", "closed form", NULL);
    const struct benchmark_row *chosen = benchmark_find(cost, study, "Gauss-Legendre", NULL);
    if (!panels || !fine || !simpson)
        return;
    if (closed)
        add(out, "GW's area, load and conductance come from closed forms, within ", closed->error, 2, ". ");
    if (chosen) {
        text_add(out, "%s's integrals come from Gauss-Legendre panels at tolerance %s, ", law, chosen->setting);
        add(out, "within ", chosen->error, 2, ". ");
    }
    add(out, "With them one more digit takes ", 100 * (digit_factor(panels, fine) - 1), 2, " % more time. ");
    text_add(out, "The thesis's Simpson rule of 1000 sub-intervals is off by ");
    number_format_number(out, simpson->error, 2);
    const struct benchmark_row *reference = chosen ? chosen : closed ? closed : fine;
    add(out, " and takes ", simpson->seconds / reference->seconds, 2, " times as long. ");
    text_add(out, "The knee, where another digit begins to cost more than twice the time:");
    add_knee(out, cost, study, "Simpson");
    add_knee(out, cost, study, "adaptive");
    add_knee(out, cost, study, "Gauss-Legendre");
    out->length--; /* the last semicolon */
    text_add(out, ".");
}

static void curves_text(struct text *out, const struct benchmark *cost)
{
    const struct benchmark_row *thesis = benchmark_find(cost, "closure-area", "thesis", "");
    const struct benchmark_row *numeric = benchmark_find(cost, "closure-area", "numeric", "");
    if (thesis && numeric) {
        add(out,
            " The sinusoid's closure weighs more than any of this: against the direct numerical solution, `thesis` is "
            "off "
            "by up to ",
            100 * thesis->error, 2, " % in area, `numeric` by ");
        add(out, "", 100 * numeric->error, 2, " %, at ");
        add(out, "", numeric->seconds / thesis->seconds, 2, " times the time.");
    }
    bool first = true;
    for (size_t i = 0; i < cost->count; i++) {
        const struct benchmark_row *row = &cost->rows[i];
        if (strcmp(row->study, "loads") != 0 || strcmp(row->setting, "129") != 0)
            continue;
        text_add(out, "%s%s ", first ? " Between 129 loads, the area interpolated in log-log is off by up to: " : "; ",
                 row->method);
        number_format_number(out, row->error, 2);
        first = false;
    }
    if (!first)
        text_add(out, ".");
}

static void cost_text(struct text *out, const struct section_context *context)
{
    const struct benchmark *cost = context->results->cost;
    if (!cost)
        return;
    section_named(out, "Surface ", context->results, context->results->baseline);
    text_add(
        out,
        ". Each method's largest relative error, against a better result by another method, and its time (the least "
        "of several runs; evaluations do not depend on the machine). ");
    integrals_text(out, cost);
    curves_text(out, cost);
}

static void cost_table(struct text *out, const struct section_context *context)
{
    const struct benchmark *cost = context->results->cost;
    if (!cost)
        return;
    text_add(out, "| study | method | setting | evaluations | time (µs) | largest relative error | |\n"
                  "|---|---|---|---:|---:|---:|---|\n");
    for (size_t i = 0; i < cost->count; i++) {
        const struct benchmark_row *row = &cost->rows[i];
        text_add(out, "| %s | %s | %s | %llu | ", row->study, row->method, row->setting,
                 (unsigned long long)row->evaluations);
        number_format_number(out, row->seconds * 1e6, 3);
        text_add(out, " | ");
        number_format_number(out, row->error, 2);
        text_add(out, " | %s |\n", row->chosen ? "used here" : "");
    }
}

const struct section_row section_cost[] = {
    {"work_table", work_rows},
    {"cost_text", cost_text},
    {"cost_table", cost_table},
    {NULL, NULL},
};
