/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `self-test`: does this build compute correctly here? */
#include "cli/command.h"
#include "contact/model.h"
#include "selftest/selftest.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct arguments {
    bool json, verbose;
};

enum { KEY_JSON = 0x100 };

static const struct argp_option options[] = {
    {"json", KEY_JSON, 0, 0, "print an object with every number (default: text)", 0},
    {"verbose", 'v', 0, 0, "print every number (default: a line a group)", 0},
    {0},
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    struct arguments *arguments = state->input;
    (void)value;
    switch (key) {
    case KEY_JSON:
        arguments->json = true;
        return 0;
    case 'v':
        arguments->verbose = true;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

const struct argp command_self_test_argp = {
    .options = options,
    .parser = parse,
    .doc =
        "Computes numbers that are known from elsewhere (softgauges, closed forms, other programs) and compares. They "
        "stand in PREFIX/share/roughcontact/selftest.csv; nothing is written. Ends with 1 where a number is off."};

/** Numbers that are told together: references of a table, one behind the other. */
struct group {
    const struct selftest_reference *references;
    double *values;
    size_t count, wrong, worst; /* how many are off, and which one most; all where `problem` says why */
    struct status problem;
};

static void print_group(const struct group *group, bool verbose)
{
    const struct selftest_reference *worst = &group->references[group->worst];
    printf("%-12s %3zu number%s  ", group->references->group, group->count, group->count == 1 ? " " : "s");
    if (group->problem.code != STATUS_OK)
        printf("WRONG: %s\n", group->problem.message);
    else if (group->wrong > 0)
        printf("WRONG: %zu of them; %s, %s is %.17g, not %.17g\n", group->wrong, worst->of, worst->quantity,
               group->values[group->worst], worst->expected);
    else
        printf("right  largest error %.2g of its tolerance  (%s)\n", selftest_error(worst, group->values[group->worst]),
               group->references->source);
    for (size_t i = 0; i < group->count && verbose && group->problem.code == STATUS_OK; i++) {
        const struct selftest_reference *reference = &group->references[i];
        double value = group->values[i], error = selftest_error(reference, value);
        printf("  %-20s %-24s %-9.4g %-9.4g %-9.4g %24.17g %24.17g  %.2g of %.2g%s\n", reference->of,
               reference->quantity, reference->at[0], reference->at[1], reference->at[2], value, reference->expected,
               error * reference->tolerance, reference->tolerance, error <= 1 ? "" : "  WRONG");
    }
}

static json_t *group_json(const struct group *group)
{
    bool computed = group->problem.code == STATUS_OK;
    json_t *numbers = json_array();
    for (size_t i = 0; i < group->count; i++) {
        const struct selftest_reference *reference = &group->references[i];
        json_array_append_new(numbers,
                              json_pack("{s:s, s:s, s:[f, f, f], s:o, s:f, s:f, s:b}", "of", reference->of, "quantity",
                                        reference->quantity, "arguments", reference->at[0], reference->at[1],
                                        reference->at[2], "value", json_finite(computed ? group->values[i] : NAN),
                                        "expected", reference->expected, "relative_tolerance", reference->tolerance,
                                        "right", computed && selftest_error(reference, group->values[i]) <= 1));
    }
    double worst = selftest_error(&group->references[group->worst], group->values[group->worst]);
    return json_pack("{s:s, s:s, s:b, s:o, s:o, s:o}", "group", group->references->group, "source",
                     group->references->source, "right", group->wrong == 0, "problem",
                     json_shown(computed ? NULL : group->problem.message), "largest_error_over_tolerance",
                     json_finite(computed ? worst : INFINITY), "numbers", numbers);
}

/** The models that nothing here speaks of, a blank between two. */
static void add_uncovered(struct text *out, const struct selftest_table *table)
{
    for (size_t m = 0; m < model_count; m++)
        if (!selftest_covers_model(table, model_rows[m]->name))
            text_add(out, "%s%s", out->length > 0 ? " " : "", model_rows[m]->name);
}

/** Computes the group that begins at reference `first`. */
static struct group run_group(const struct selftest_table *table, size_t first, double *values)
{
    struct group group = {.references = &table->references[first], .values = values};
    for (; first + group.count < table->count; group.count++) {
        const struct selftest_reference *reference = &group.references[group.count];
        double *value = &values[group.count];
        if (strcmp(reference->group, group.references->group) != 0)
            break;
        *value = NAN;
        if (group.problem.code != STATUS_OK || selftest_value(value, reference, table, &group.problem) != STATUS_OK)
            continue;
        group.wrong += !(selftest_error(reference, *value) <= 1);
        if (selftest_error(reference, *value) > selftest_error(&group.references[group.worst], values[group.worst]))
            group.worst = group.count;
    }
    if (group.problem.code != STATUS_OK)
        group.wrong = group.count;
    return group;
}

/** Runs one group after another, and prints each or adds it to `groups`. Returns how many numbers are wrong in
 * `wrong`. */
static enum status_code run_groups(size_t *wrong, json_t *groups, const struct selftest_table *table, bool verbose,
                                   struct status *status)
{
    double *values = calloc(table->count, sizeof *values);
    if (!values)
        return status_memory(status);
    for (size_t first = 0; first < table->count;) {
        struct group group = run_group(table, first, values + first);
        if (group.problem.code == STATUS_IO) { /* the table is of another version */
            *status = group.problem;
            break;
        }
        if (groups)
            json_array_append_new(groups, group_json(&group));
        else
            print_group(&group, verbose);
        *wrong += group.wrong;
        first += group.count;
    }
    free(values);
    return status->code;
}

static bool print_end(size_t wrong, json_t *groups, const struct selftest_table *table)
{
    struct text uncovered = {0};
    bool right = wrong == 0;
    add_uncovered(&uncovered, table);
    if (groups)
        right = command_json_print(json_pack("{s:b, s:I, s:I, s:o, s:O}", "right", right, "numbers",
                                             (json_int_t)table->count, "wrong", (json_int_t)wrong, "models_not_covered",
                                             json_shown(text_string(&uncovered)), "groups", groups)) &&
                right;
    else {
        if (uncovered.length > 0)
            printf("not covered: %s\n", text_string(&uncovered));
        printf(right ? "%zu numbers: this build computes correctly here\n"
                     : "%zu numbers: this build does NOT compute correctly here; please report this with --verbose and "
                       "--version\n",
               table->count);
    }
    text_free(&uncovered);
    return right;
}

int command_self_test(int argc, char **argv)
{
    struct arguments arguments = {0};
    struct status status = {0};
    struct selftest_table table = {.count = 0};
    struct text path = {0};
    size_t wrong = 0;
    command_parse(&command_self_test_argp, argc, argv, &arguments);
    json_t *groups = arguments.json ? json_array() : NULL;
    bool done = command_share(&path, "selftest.csv", &status) == STATUS_OK &&
                selftest_table_read(&table, text_string(&path), &status) == STATUS_OK &&
                run_groups(&wrong, groups, &table, arguments.verbose, &status) == STATUS_OK;
    bool right = done && print_end(wrong, groups, &table);
    if (!done && groups)
        (void)command_json_print(json_pack("{s:b, s:o}", "right", 0, "error", json_shown(status.message)));
    json_decref(groups);
    selftest_table_free(&table);
    text_free(&path);
    return done ? command_finish(right ? COMMAND_DONE : COMMAND_REFUSED, NULL) : command_fail(&status);
}
