/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `self-test`: does this build compute correctly here? */
#include "cli/command.h"
#include "cli/command_json.h"
#include "contact/model.h"
#include "selftest/selftest.h"

#include <stdio.h>
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
    switch (key) {
    case KEY_JSON:
        arguments->json = true;
        return 0;
    case 'v':
        arguments->verbose = true;
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

static void print_number(const struct selftest_reference *reference, double value)
{
    printf("  %-20s %-24s", reference->of, reference->quantity);
    for (int i = 0; i < 3; i++)
        printf(" %-9.4g", reference->at[i]);
    printf(" %24.17g %24.17g  %.2g of %.2g%s\n", value, reference->expected,
           selftest_error(reference, value) * reference->tolerance, reference->tolerance,
           selftest_error(reference, value) <= 1 ? "" : "  WRONG");
}

static void print_group(const struct selftest_group *group, const struct selftest_result *result, bool verbose)
{
    const struct selftest_reference *worst = &group->references[result->worst_place];
    printf("%-12s %3zu number%s  ", group->references->group, group->count, group->count == 1 ? " " : "s");
    if (result->problem.code != STATUS_OK)
        printf("WRONG: %s\n", result->problem.message);
    else if (result->wrong > 0)
        printf("WRONG: %zu of them; %s, %s is %.17g, not %.17g\n", result->wrong, worst->of, worst->quantity,
               result->values[result->worst_place], worst->expected);
    else
        printf("right  largest error %.2g of its tolerance  (%s)\n", result->worst, group->references->source);
    for (size_t i = 0; i < group->count && verbose && result->problem.code == STATUS_OK; i++)
        print_number(&group->references[i], result->values[i]);
}

static json_t *group_json(const struct selftest_group *group, const struct selftest_result *result)
{
    json_t *numbers = json_array();
    for (size_t i = 0; i < group->count; i++) {
        const struct selftest_reference *reference = &group->references[i];
        json_t *at = json_array();
        for (int k = 0; k < 3; k++)
            json_array_append_new(at, json_real(reference->at[k]));
        json_array_append_new(
            numbers,
            json_pack("{s:s, s:s, s:o, s:o, s:o, s:o, s:b}", "of", reference->of, "quantity", reference->quantity,
                      "arguments", at, "value",
                      result->problem.code == STATUS_OK ? command_json_number(result->values[i]) : json_null(),
                      "expected", json_real(reference->expected), "relative_tolerance", json_real(reference->tolerance),
                      "right", result->problem.code == STATUS_OK && selftest_error(reference, result->values[i]) <= 1));
    }
    return json_pack("{s:s, s:s, s:b, s:o, s:o, s:o}", "group", group->references->group, "source",
                     group->references->source, "right", result->wrong == 0, "problem",
                     command_json_optional(result->problem.code == STATUS_OK ? NULL : result->problem.message),
                     "largest_error_over_tolerance", command_json_number(result->worst), "numbers", numbers);
}

/** The models that nothing here speaks of, a blank between two. */
static void add_uncovered(struct text *out, const struct selftest_table *table)
{
    for (size_t m = 0; m < model_count; m++)
        if (!selftest_covers_model(table, model_rows[m]->name))
            text_add(out, "%s%s", out->length > 0 ? " " : "", model_rows[m]->name);
}

/** Runs one group after another, and prints each or adds it to `groups`. Returns how many numbers are wrong in
 * `wrong`. */
static enum status_code run_groups(size_t *wrong, json_t *groups, const struct selftest_table *table, bool verbose,
                                   struct status *status)
{
    struct selftest_group group;
    for (size_t first = 0; first < table->count; first += group.count) {
        struct selftest_result result;
        group = selftest_group(table, first);
        enum status_code rc = selftest_run(&result, table, &group, status);
        if (rc == STATUS_OK && groups)
            json_array_append_new(groups, group_json(&group, &result));
        else if (rc == STATUS_OK)
            print_group(&group, &result, verbose);
        *wrong += result.wrong;
        selftest_result_free(&result);
        if (rc != STATUS_OK)
            return rc;
    }
    return STATUS_OK;
}

static bool print_end(size_t wrong, json_t *groups, const struct selftest_table *table)
{
    struct text uncovered = {0};
    bool right = wrong == 0;
    add_uncovered(&uncovered, table);
    if (groups)
        right = command_json_print(json_pack("{s:b, s:I, s:I, s:o, s:O}", "right", right, "numbers",
                                             (json_int_t)table->count, "wrong", (json_int_t)wrong, "models_not_covered",
                                             command_json_text(text_string(&uncovered)), "groups", groups)) &&
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
        (void)command_json_print(json_pack("{s:b, s:o}", "right", 0, "error", command_json_text(status.message)));
    json_decref(groups);
    selftest_table_free(&table);
    text_free(&path);
    return done ? command_finish(right ? COMMAND_DONE : COMMAND_REFUSED, NULL) : command_fail(&status);
}
