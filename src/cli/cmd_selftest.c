/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `self-test`: does this build compute correctly here? */
#include "cli/command.h"
#include "selftest/selftest.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const struct argp_option options[] = {
    {"verbose", 'v', 0, 0, "print every number (default: a line a group)", 0},
    {0},
};

static error_t parse(int key, __attribute__((unused)) char *value, struct argp_state *state)
{
    *(bool *)state->input |= key == 'v';
    return key == 'v' ? 0 : ARGP_ERR_UNKNOWN;
}

const struct argp command_self_test_argp = {
    .options = options,
    .parser = parse,
    .doc =
        "Computes numbers that are known from elsewhere (softgauges, closed forms, other programs) and compares. They "
        "stand in PREFIX/share/roughcontact/selftest.csv; nothing is written. Ends with 1 where a number is off."};

/** One number, its arguments and its error. */
static void print_number(const struct selftest_reference *reference, double value)
{
    double error = selftest_error(reference, value);
    printf("  %-20s %-24s %-9.4g %-9.4g %-9.4g %24.17g %24.17g  %.2g of %.2g%s\n", reference->of, reference->quantity,
           reference->at[0], reference->at[1], reference->at[2], value, reference->expected,
           error * reference->tolerance, reference->tolerance, error <= 1 ? "" : "  WRONG");
}

/** Computes and prints the group whose first reference is `first`; adds how many are off to *wrong. Returns where the
 * next one begins. */
static size_t run_group(const struct selftest_table *table, size_t first, bool verbose, size_t *wrong)
{
    const struct selftest_reference *group = &table->references[first], *worst = group;
    double value, worst_value = NAN, most = -1;
    size_t count = 0, off = 0;
    struct status problem = {0};
    for (; first + count < table->count && strcmp(group[count].group, group->group) == 0; count++) {
        if (problem.code != STATUS_OK || selftest_value(&value, &group[count], table, &problem) != STATUS_OK)
            continue;
        double error = selftest_error(&group[count], value);
        if (verbose)
            print_number(&group[count], value);
        off += !(error <= 1);
        if (error > most) {
            most = error;
            worst = &group[count];
            worst_value = value;
        }
    }
    printf("%-12s %3zu number%s  ", group->group, count, count == 1 ? " " : "s");
    if (problem.code != STATUS_OK)
        printf("WRONG: %s\n", problem.message);
    else if (off > 0)
        printf("WRONG: %zu of them; %s, %s is %.17g, not %.17g\n", off, worst->of, worst->quantity, worst_value,
               worst->expected);
    else
        printf("right  largest error %.2g of its tolerance  (%s)\n", most, group->source);
    *wrong += problem.code != STATUS_OK ? count : off;
    return first + count;
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
    for (size_t first = 0; done && first < table.count;)
        first = run_group(&table, first, verbose, &wrong);
    if (done)
        printf(wrong == 0 ? "%zu numbers: this build computes correctly here\n"
                          : "%zu numbers: this build does NOT compute correctly here; please report this with "
                            "--verbose and --version\n",
               table.count);
    selftest_table_free(&table);
    text_free(&path);
    return done ? command_finish(wrong == 0 ? COMMAND_DONE : COMMAND_REFUSED, NULL) : command_fail(&status);
}
