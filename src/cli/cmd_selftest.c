/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `self-test`: does this build compute correctly here? */
#include "cli/command.h"
#include "selftest/selftest.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct argp_option options[] = {
    {"verbose", 'v', 0, 0, "print every number (default: a line a group)", 0},
    {0},
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    switch (key) {
    case 'v':
        *(bool *)state->input = true;
        return 0;
    case ARGP_KEY_ARG:
        return command_no_argument(value, state);
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

int command_self_test(int argc, char **argv)
{
    bool verbose = false;
    struct status status = {0};
    struct selftest_table table = {.count = 0};
    struct text path = {0};
    size_t wrong = 0;
    command_parse(&command_self_test_argp, argc, argv, &verbose);
    bool done = command_share(&path, "selftest.csv", &status) == STATUS_OK &&
                selftest_table_read(&table, text_string(&path), &status) == STATUS_OK;
    double *values = calloc(table.count + 1, sizeof *values);
    if (!values && done)
        done = status_memory(&status) == STATUS_OK;
    for (size_t first = 0; done && first < table.count;) {
        struct group group = run_group(&table, first, values + first);
        print_group(&group, verbose);
        wrong += group.wrong;
        first += group.count;
    }
    if (done)
        printf(wrong == 0 ? "%zu numbers: this build computes correctly here\n"
                          : "%zu numbers: this build does NOT compute correctly here; please report this with "
                            "--verbose and --version\n",
               table.count);
    free(values);
    selftest_table_free(&table);
    text_free(&path);
    return done ? command_finish(wrong == 0 ? COMMAND_DONE : COMMAND_REFUSED, NULL) : command_fail(&status);
}
