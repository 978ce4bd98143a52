/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The self-test: right as it is, wrong wherever a number or its expected value is planted wrong. */
#include "contact/model.h"
#include "selftest/selftest.h"
#include "support.h"

#include <dirent.h>
#include <stdbool.h>
#include <stdio.h>

static struct selftest_result run(const struct selftest_group *group)
{
    struct selftest_result result;
    struct status status = {0};
    assert_int_equal(selftest_run(&result, group, &status), STATUS_OK);
    return result;
}

static void all_groups_are_right(void **state)
{
    (void)state;
    size_t numbers = 0;
    for (size_t g = 0; g < selftest_group_count; g++) {
        const struct selftest_group *group = selftest_groups[g];
        struct selftest_result result = run(group);
        if (result.problem.code != STATUS_OK || result.wrong > 0)
            fail_msg("%s: %zu wrong, %s", group->name, result.wrong, result.problem.message);
        assert_true(result.worst <= 1 && strlen(group->source) > 10);
        for (size_t i = 0; i < group->count; i++)
            assert_near(result.values[i], group->references[i].expected, group->references[i].tolerance);
        numbers += group->count;
        selftest_result_free(&result);
    }
    assert_true(numbers > 200);
}

/** One number after another is expected a little off: that one alone is wrong, and is said to be the worst. */
static void every_number_counts(void **state)
{
    (void)state;
    for (size_t g = 0; g < selftest_group_count; g++) {
        struct selftest_group group = *selftest_groups[g];
        struct selftest_reference *planted = malloc(group.count * sizeof *planted);
        assert_non_null(planted);
        memcpy(planted, group.references, group.count * sizeof *planted);
        group.references = planted;
        for (size_t i = 0; i<group.count; i += group.count> 40 ? 7 : 1) {
            struct selftest_reference right = planted[i];
            for (int sign = -1; sign <= 1; sign += 2) {
                planted[i].expected = right.expected * (1 + sign * 2.5 * right.tolerance);
                struct selftest_result result = run(&group);
                assert_int_equal(result.wrong, 1);
                assert_int_equal(result.worst_place, i);
                assert_true(result.worst > 1);
                selftest_result_free(&result);
            }
            planted[i] = right;
        }
        free(planted);
    }
}

/** The numbers are computed from the arguments: others give others. */
static void arguments_count(void **state)
{
    (void)state;
    size_t changed = 0;
    for (size_t g = 0; g < selftest_group_count; g++) {
        struct selftest_group group = *selftest_groups[g];
        struct selftest_reference *planted = malloc(group.count * sizeof *planted);
        assert_non_null(planted);
        memcpy(planted, group.references, group.count * sizeof *planted);
        group.references = planted;
        bool argued = false;
        for (size_t i = 0; i < group.count; i++) {
            bool takes = planted[i].at[0] > 0 && strcmp(group.name, "spectrum") != 0;
            planted[i].at[0] *= takes ? 1.01 : 1;
            argued = argued || takes;
        }
        struct selftest_result result = run(&group);
        if (argued) {
            if (result.problem.code != STATUS_OK || result.wrong == 0)
                fail_msg("%s does not look at its arguments", group.name);
            changed++;
        }
        selftest_result_free(&result);
        free(planted);
    }
    assert_true(changed >= 6);
}

static enum status_code compute_nothing(double *values, const struct selftest_reference *references, size_t count,
                                        struct status *status)
{
    (void)references;
    for (size_t i = 0; i < count; i++)
        values[i] = i == 0 ? NAN : 1;
    return count > 2 ? status_fail(status, STATUS_MODEL, "nothing came out") : STATUS_OK;
}

static void no_number_is_wrong(void **state)
{
    (void)state;
    static const struct selftest_reference ones[] = {
        {"a", "b", {0}, 1, 1e-3}, {"a", "b", {0}, 1, 1e-3}, {"a", "b", {0}, 1, 1}};
    struct selftest_group group = {"none", "made up", ones, 2, compute_nothing};
    struct selftest_result result = run(&group);
    assert_true(result.wrong == 1 && isinf(result.worst) && result.worst_place == 0);
    selftest_result_free(&result);
    group.count = 3;
    result = run(&group);
    assert_true(result.wrong == 3 && result.problem.code == STATUS_MODEL);
    selftest_result_free(&result);
}

/** A new model needs its numbers in src/selftest/selftest_models.c. */
static void every_model_is_covered(void **state)
{
    (void)state;
    for (size_t m = 0; m < model_count; m++)
        if (!selftest_covers_model(m))
            fail_msg("the self-test has no numbers of %s", model_rows[m]->name);
}

enum { NUMBERS_MOST = 40000 };

struct numbers {
    double value[NUMBERS_MOST];
    size_t count;
};

static void read_numbers(struct numbers *numbers, const char *folder)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/golden/%s", TEST_DATA, folder);
    DIR *directory = opendir(path);
    assert_non_null(directory);
    for (const struct dirent *entry; (entry = readdir(directory));) {
        if (!strstr(entry->d_name, ".csv"))
            continue;
        snprintf(path, sizeof path, "golden/%s/%s", folder, entry->d_name);
        struct table table = table_read(path);
        for (size_t cell = table.columns; cell < (table.rows + 1) * table.columns; cell++) {
            char *end;
            double value = strtod(table.cell[cell], &end);
            if (end == table.cell[cell] || *end != '\0')
                continue;
            assert_true(numbers->count < NUMBERS_MOST);
            numbers->value[numbers->count++] = value;
        }
        table_free(&table);
    }
    closedir(directory);
}

static bool has_number(const struct numbers *numbers, double value)
{
    for (size_t i = 0; i < numbers->count; i++)
        if (fabs(numbers->value[i] - value) <= 1e-15 * fabs(value))
            return true;
    return false;
}

/** What the models are held against stands in the reference tables: it was not printed by this program. */
static void model_numbers_are_the_references(void **state)
{
    (void)state;
    static const char *const folders[] = {".", "models", "two-band", "contacting-slopes"};
    struct numbers *numbers = calloc(1, sizeof *numbers);
    size_t made = 0;
    assert_non_null(numbers);
    for (size_t f = 0; f < sizeof folders / sizeof *folders; f++)
        read_numbers(numbers, folders[f]);
    for (size_t g = 0; g < selftest_group_count; g++) {
        const struct selftest_group *group = selftest_groups[g];
        if (strcmp(group->name, "models") != 0 && strcmp(group->name, "sinusoid") != 0)
            continue;
        for (size_t i = 0; i < group->count; i++) {
            const struct selftest_reference *r = &group->references[i];
            bool copied = has_number(numbers, r->expected) || /* or h = 1/TCR, or rho times the length behind an ECR */
                          has_number(numbers, 1 / r->expected) || has_number(numbers, r->expected / (2 * 11.5e-8));
            if (!copied && (strcmp(r->what, "persson") != 0 || strcmp(r->of, "area_ratio") != 0))
                fail_msg("%s, %s: %.17g stands in no reference table", r->what, r->of, r->expected);
            made += !copied;
        }
    }
    assert_true(made <= 3); /* Persson's areas: bisection on erf(p/sqrt(m2 (g + (1-g) A))) = A */
    free(numbers);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_groups_are_right),   cmocka_unit_test(every_number_counts),
        cmocka_unit_test(arguments_count),        cmocka_unit_test(no_number_is_wrong),
        cmocka_unit_test(every_model_is_covered), cmocka_unit_test(model_numbers_are_the_references),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
