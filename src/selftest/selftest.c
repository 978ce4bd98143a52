/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "selftest/selftest.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** A cell that holds one number; an empty one holds 0. */
static bool read_number(double *out, const char *cell)
{
    char *end;
    *out = *cell ? strtod(cell, &end) : 0;
    return !*cell || (end != cell && *end == '\0' && isfinite(*out));
}

static bool read_reference(struct selftest_reference *out, char *line)
{
    char *cell[9] = {NULL};
    for (int c = 0; c < 9; c++)
        if (!(cell[c] = strsep(&line, ",")))
            return false;
    *out = (struct selftest_reference){.group = cell[0], .of = cell[1], .quantity = cell[2], .source = cell[8]};
    for (int k = 0; k < 3; k++)
        if (!read_number(&out->at[k], cell[3 + k]))
            return false;
    return line == NULL && read_number(&out->expected, cell[6]) && read_number(&out->tolerance, cell[7]);
}

/** Reads an input's list of numbers, a blank between two, to where it belongs. */
static bool read_input(struct selftest_table *out, const struct selftest_reference *input)
{
    const struct {
        const char *name;
        double *list;
        size_t count;
    } inputs[] = {{"five scans", out->scans, SELFTEST_SCANS},
                  {"plateau", out->plateau_m, SELFTEST_PLATEAU},
                  {"rough law", out->law_m2, SELFTEST_LAW}};
    size_t i = 0, n = 0;
    while (i < 3 && strcmp(inputs[i].name, input->of) != 0)
        i++;
    const char *at = input->source;
    for (char *end; i < 3 && n < inputs[i].count; n++, at = end) {
        inputs[i].list[n] = strtod(at, &end);
        if (end == at)
            break;
    }
    return i < 3 && n == inputs[i].count && *at == '\0';
}

/** The inputs are the last lines, so that a table that is cut off lacks some. */
static enum status_code read_lines(struct selftest_table *out, const char *path, struct status *status)
{
    size_t number = 0, inputs = 0;
    for (char *rest = out->text.data, *line; (line = strsep(&rest, "\n")) != NULL;) {
        struct selftest_reference *reference = &out->references[out->count];
        number++;
        if (*line == '#' || *line == '\0' || strncmp(line, "group,", 6) == 0)
            continue;
        bool right = read_reference(reference, line), input = right && strcmp(reference->group, "input") == 0;
        right = input ? read_input(out, reference) : right && reference->expected != 0 && reference->tolerance > 0;
        out->count += !input;
        inputs += input;
        if (!right)
            return status_fail(status, STATUS_IO, "%s:%zu: damaged; install the program again", path, number);
    }
    return inputs == 3 ? STATUS_OK : status_fail(status, STATUS_IO, "%s: cut off; install the program again", path);
}

enum status_code selftest_table_read(struct selftest_table *out, const char *path, struct status *status)
{
    *out = (struct selftest_table){.count = 0};
    if (text_read_file(&out->text, path, status) != STATUS_OK)
        return status->code;
    size_t lines = 1;
    for (size_t i = 0; i < out->text.length; i++)
        lines += out->text.data[i] == '\n';
    out->references = calloc(lines, sizeof *out->references);
    if (!out->references)
        return status_memory(status);
    return read_lines(out, path, status);
}

void selftest_table_free(struct selftest_table *table)
{
    text_free(&table->text);
    free(table->references);
    table->references = NULL;
}

enum status_code selftest_value(double *value, const struct selftest_reference *reference,
                                const struct selftest_table *table, struct status *status)
{
    static const struct {
        const char *group;
        selftest_compute *compute;
    } computes[] = {{"softgauges", selftest_softgauge},
                    {"spectrum", selftest_spectrum},
                    {"models", selftest_model},
                    {"direct", selftest_direct}};
    *value = NAN;
    for (size_t i = 0; i < sizeof computes / sizeof computes[0]; i++)
        if (strcmp(computes[i].group, reference->group) == 0)
            return computes[i].compute(value, reference, table, status);
    return selftest_plain(value, reference, table, status);
}

double selftest_error(const struct selftest_reference *reference, double value)
{
    double allowed = reference->tolerance * fabs(reference->expected);
    return isfinite(value) ? fabs(value - reference->expected) / allowed : INFINITY;
}
