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
        "Computes numbers that are known from elsewhere (softgauges, closed forms, other programs) and compares. All "
        "of it is compiled in: no file is read or written. Ends with 1 where a number is off."};

static void print_number(const struct selftest_reference *reference, double value)
{
    printf("  %-20s %-24s", reference->what, reference->of);
    for (int i = 0; i < 3; i++)
        printf(" %-9.4g", reference->at[i]);
    printf(" %24.17g %24.17g  %.2g of %.2g%s\n", value, reference->expected,
           selftest_error(reference, value) * reference->tolerance, reference->tolerance,
           selftest_error(reference, value) <= 1 ? "" : "  WRONG");
}

static void print_group(const struct selftest_group *group, const struct selftest_result *result, bool verbose)
{
    const struct selftest_reference *worst = &group->references[result->worst_place];
    printf("%-12s %3zu number%s  ", group->name, group->count, group->count == 1 ? " " : "s");
    if (result->problem.code != STATUS_OK)
        printf("WRONG: %s\n", result->problem.message);
    else if (result->wrong > 0)
        printf("WRONG: %zu of them; %s, %s is %.17g, not %.17g\n", result->wrong, worst->what, worst->of,
               result->values[result->worst_place], worst->expected);
    else
        printf("right  largest error %.2g of its tolerance  (%s)\n", result->worst, group->source);
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
            json_pack("{s:s, s:s, s:o, s:o, s:o, s:o, s:b}", "of", reference->what, "quantity", reference->of,
                      "arguments", at, "value",
                      result->problem.code == STATUS_OK ? command_json_number(result->values[i]) : json_null(),
                      "expected", json_real(reference->expected), "relative_tolerance", json_real(reference->tolerance),
                      "right", result->problem.code == STATUS_OK && selftest_error(reference, result->values[i]) <= 1));
    }
    return json_pack("{s:s, s:s, s:b, s:o, s:o, s:o}", "group", group->name, "source", group->source, "right",
                     result->wrong == 0, "problem",
                     command_json_optional(result->problem.code == STATUS_OK ? NULL : result->problem.message),
                     "largest_error_over_tolerance", command_json_number(result->worst), "numbers", numbers);
}

/** The models that nothing here speaks of, a blank between two. */
static void add_uncovered(struct text *out)
{
    for (size_t m = 0; m < model_count; m++)
        if (!selftest_covers_model(m))
            text_add(out, "%s%s", out->length > 0 ? " " : "", model_rows[m]->name);
}

int command_self_test(int argc, char **argv)
{
    struct arguments arguments = {0};
    struct status status = {0};
    command_parse(&command_self_test_argp, argc, argv, &arguments);
    json_t *groups = json_array();
    size_t numbers = 0, wrong = 0;
    for (size_t g = 0; g < selftest_group_count; g++) {
        struct selftest_result result;
        if (selftest_run(&result, selftest_groups[g], &status) != STATUS_OK) {
            json_decref(groups);
            return command_fail(&status);
        }
        if (arguments.json)
            json_array_append_new(groups, group_json(selftest_groups[g], &result));
        else
            print_group(selftest_groups[g], &result, arguments.verbose);
        numbers += selftest_groups[g]->count;
        wrong += result.wrong;
        selftest_result_free(&result);
    }
    struct text uncovered = {0};
    add_uncovered(&uncovered);
    bool right = wrong == 0;
    if (arguments.json)
        right = command_json_print(json_pack("{s:b, s:I, s:I, s:o, s:o}", "right", right, "numbers",
                                             (json_int_t)numbers, "wrong", (json_int_t)wrong, "models_not_covered",
                                             command_json_text(text_string(&uncovered)), "groups", groups)) &&
                right;
    else {
        json_decref(groups);
        if (uncovered.length > 0)
            printf("not covered: %s\n", text_string(&uncovered));
        printf(right ? "%zu numbers: this build computes correctly here\n"
                     : "%zu numbers: this build does NOT compute correctly here; please report this with --verbose and "
                       "--version\n",
               numbers);
    }
    text_free(&uncovered);
    return command_finish(right ? COMMAND_DONE : COMMAND_REFUSED, NULL);
}
