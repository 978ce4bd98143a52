/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The self-test: right as it is, wrong wherever a number or its expected value is planted wrong; its table is the
 * reference tables', and refused when damaged. */
#include "contact/model.h"
#include "directory.h"
#include "selftest/selftest.h"

#define TABLE PROJECT_SOURCE "/src/selftest/selftest.csv"

static struct selftest_table table;

static int read_table(void **state)
{
    struct status status = {0};
    (void)state;
    return selftest_table_read(&table, TABLE, &status) != STATUS_OK;
}

static int free_table(void **state)
{
    (void)state;
    selftest_table_free(&table);
    return 0;
}

/** Its error as a share of its tolerance. */
static double error_of(const struct selftest_reference *reference)
{
    double value;
    expect_ok(selftest_value, &value, reference, &table);
    return selftest_error(reference, value);
}

/** Every number is right, and wrong where it is expected a little off. */
TEST_CASE(every_number_counts)
{
    const char *group = "";
    assert_true(table.count >= 190);
    for (size_t i = 0; i < table.count; i++) {
        struct selftest_reference planted = table.references[i];
        assert_true(error_of(&planted) <= 1);
        assert_true(strcmp(planted.group, group) == 0 || strlen(planted.source) > 10);
        group = planted.group;
        for (int sign = -1; sign <= 1; sign += 2) {
            planted.expected = table.references[i].expected * (1 + sign * 2.5 * planted.tolerance);
            assert_true(error_of(&planted) > 1);
        }
    }
}

/** The numbers are computed from the arguments: others give others. */
TEST_CASE(arguments_count)
{
    static const char *const same[] = {"constriction", "contact points", "corrected area", "faces"};
    for (size_t i = 0; i < table.count; i++) {
        struct selftest_reference planted = table.references[i];
        bool may_stay = planted.at[0] == 0 || planted.expected == 1 || strcmp(planted.group, "spectrum") == 0;
        for (size_t k = 0; k < sizeof same / sizeof *same; k++) /* as many points of the grid are in contact */
            may_stay = may_stay || strcmp(planted.quantity, same[k]) == 0;
        planted.at[0] *= 1.01;
        if (!may_stay && error_of(&planted) <= 1)
            fail_msg("%s, %s at %g: its argument does not count", planted.of, planted.quantity, planted.at[0]);
    }
}

TEST_CASE(no_number_is_wrong)
{
    struct selftest_reference none = {
        "models", "corrected-persson", quantity_rows[QUANTITY_GAP].name, {1e-4, 64, 0}, 1, 1e-10, ""};
    assert_true(isinf(error_of(&none))); /* which that model does not compute */
    none.of = "no such model";
    assert_true(isinf(error_of(&none)));
}

/** A table of these bytes, of NULL none at all, is an error that says where and `part`. */
static void expect_refused(const struct directory *place, const char *bytes, size_t length, const char *part)
{
    struct status status = {0};
    struct selftest_table damaged;
    const char *path = directory_path(place, "selftest.csv");
    (void)remove(path);
    if (bytes)
        expect_ok(text_write_file, path, bytes, length);
    assert_int_equal(selftest_table_read(&damaged, path, &status), STATUS_IO);
    assert_non_null(strstr(status.message, path));
    assert_non_null(strstr(status.message, part));
    selftest_table_free(&damaged);
}

/** No table, a cell that is no number, a tolerance of none, a column too few, an input that is none.
 */
TEST_IN_DIRECTORY(a_damaged_table_is_refused)
{
    static const struct {
        const char *from, *to;
    } changes[] = {{"gap,integral,1,", "gap,integral,one,"},
                   {"\njoint,air,", "\njoint;air,"},
                   {",1e-11,another solver", ",0,another solver"},
                   {"F_1/2,-10,,", "F_1/2,-10,"},
                   {"input,plateau,", "input,elsewhere,"},
                   {" -20.74669085342877", ""},
                   {",2.228,", ",inf,"}};
    struct text *whole = support_text();
    expect_ok(text_read_file, whole, TABLE);
    expect_refused(place, NULL, 0, "selftest.csv");
    for (size_t length = 0; length < whole->length; length += 997)
        expect_refused(place, whole->data, length, "; install the program again");
    for (size_t i = 0; i < sizeof changes / sizeof *changes; i++) {
        struct text *changed = support_text();
        const char *at = strstr(whole->data, changes[i].from);
        if (!at)
            fail_msg("the table has no '%s'", changes[i].from);
        text_add_bytes(changed, whole->data, (size_t)(at - whole->data));
        text_add(changed, "%s", changes[i].to);
        text_add_bytes(changed, at + strlen(changes[i].from), strlen(at) - strlen(changes[i].from));
        expect_refused(place, changed->data, changed->length, ": damaged; install the program again");
    }
}

enum { NUMBERS_MOST = 40000 };

struct numbers {
    double value[NUMBERS_MOST];
    size_t count;
};

static void read_numbers(struct numbers *numbers, const char *folder)
{
    DIR *directory = opendir(filled("%s/%s", TEST_DATA, folder));
    assert_non_null(directory);
    for (const struct dirent *entry; (entry = readdir(directory));) {
        if (!strstr(entry->d_name, ".csv"))
            continue;
        struct table golden = table_read(filled("%s/%s", folder, entry->d_name));
        for (size_t cell = golden.columns; cell < (golden.rows + 1) * golden.columns; cell++) {
            char *end;
            double value = strtod(golden.cell[cell], &end);
            if (end == golden.cell[cell] || *end != '\0')
                continue;
            assert_true(numbers->count < NUMBERS_MOST);
            numbers->value[numbers->count++] = value;
        }
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

/** What the models are held against, and the inputs, stand in the reference tables: this program did not print them. */
TEST_CASE(numbers_are_the_references)
{
    static const char *const folders[] = {"golden", "golden/models", "golden/strip", "statistics"};
    struct numbers *numbers = support_room(sizeof *numbers);
    for (size_t f = 0; f < sizeof folders / sizeof *folders; f++)
        read_numbers(numbers, folders[f]);
    for (size_t i = 0; i < table.count; i++) {
        const struct selftest_reference *r = &table.references[i];
        if (strcmp(r->group, "models") != 0 && strcmp(r->group, "sinusoid") != 0 && strcmp(r->of, "strip") != 0)
            continue;
        bool copied = has_number(numbers, r->expected) || /* or h = 1/TCR, or rho times the length behind an ECR */
                      has_number(numbers, 1 / r->expected) || has_number(numbers, r->expected / (2 * 11.5e-8));
        if (!copied)
            fail_msg("%s, %s: %.17g stands in no reference table", r->of, r->quantity, r->expected);
    }
    for (size_t i = 0; i < SELFTEST_PLATEAU; i++)
        assert_true(has_number(numbers, table.plateau_m[i]));
    for (size_t i = 0; i < SELFTEST_LAW; i++)
        assert_true(has_number(numbers, table.law_m2[i]));
}

TEST_GROUP(read_table, free_table)
