/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What every test program shares: relative comparison of doubles and reference tables.
 * cmocka 1.1.5 compares floats only, in single precision; hence a comparison of our own. */
#ifndef TEST_SUPPORT_H
#define TEST_SUPPORT_H

#include "base/status.h"
#include "base/threads.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <gsl/gsl_rng.h>
#include <jansson.h>

/** Defines a cmocka test, `TEST_CASE(name) { ... }`, which main.c runs: in the order of the file, with *state from its
 * fixture, if any. TEST_GROUP() is the fixture of all tests of the file together. The files of a room make one program,
 * which runs those of one file at a time. */
#define TEST_CASE(name) TEST_WITH(name, NULL, NULL)
#define TEST_WITH(name, before, after)                                                                                 \
    static void name(void **state);                                                                                    \
    static int name##_end(void **state)                                                                                \
    {                                                                                                                  \
        return test_end(state, after);                                                                                 \
    }                                                                                                                  \
    __attribute__((constructor)) static void name##_add(void)                                                          \
    {                                                                                                                  \
        test_add(__FILE__, #name, name, before, name##_end);                                                           \
    }                                                                                                                  \
    static void name(__attribute__((unused)) void **state)
#define TEST_GROUP(before, after)                                                                                      \
    __attribute__((constructor)) static void group_add(void)                                                           \
    {                                                                                                                  \
        test_group(__FILE__, before, after);                                                                           \
    }

void test_add(const char *file, const char *name, CMUnitTestFunction run, CMFixtureFunction before,
              CMFixtureFunction after);
void test_group(const char *file, CMFixtureFunction before, CMFixtureFunction after);
/** Whether a source file's path ends in this, such as "/test_strip.c". */
bool test_in_file(const char *path, const char *end);

/** What the helpers of the tests give is the test's: it ends with it, and nobody else frees it. What the fixture of a
 * group was given lasts as long as the program. Returns `what`, on which `end` is called then; never NULL. */
void *test_owns(void *what, void (*end)(void *what));
/** The end of a test: its fixture's, then that of all it owns. Returns what the fixture does. */
int test_end(void **state, CMFixtureFunction after);
/** The fixture of the group is made: what was given so far is not the first test's. */
void test_keep(void);

/** The one thread, to the end. */
extern const struct threads test_alone;

/** Fails unless |actual - expected| <= rtol |expected| (both zero passes; non-finite never does). */
#define assert_near(actual, expected, rtol) support_near((actual), (expected), (rtol), 0.0, #actual, __FILE__, __LINE__)
/** Fails unless |actual - expected| <= atol. */
#define assert_within(actual, expected, atol)                                                                          \
    support_near((actual), (expected), 0.0, (atol), #actual, __FILE__, __LINE__)

void support_near(double actual, double expected, double rtol, double atol, const char *what, const char *file,
                  int line);

/** Fails, and says why, unless the function succeeds with these arguments and a status after them. */
#define expect_ok(function, ...)                                                                                       \
    do {                                                                                                               \
        struct status expected_ok = {0};                                                                               \
        if (function(__VA_ARGS__, &expected_ok) != STATUS_OK)                                                          \
            fail_msg("%s: %s", #function, expected_ok.message);                                                        \
    } while (0)

/** The same where it has to fail with this status and a message that holds `words`. */
#define expect_fails(expected, words, function, ...)                                                                   \
    do {                                                                                                               \
        struct status expected_failure = {0};                                                                          \
        assert_int_equal(function(__VA_ARGS__, &expected_failure), (expected));                                        \
        expect_parts(expected_failure.message, (words));                                                               \
    } while (0)

/** Fails unless the text holds every one of these parts, or none of them. */
#define expect_parts(text, ...)                                                                                        \
    support_parts((text), (const char *const[]){__VA_ARGS__, NULL}, true, __FILE__, __LINE__)
#define expect_no_parts(text, ...)                                                                                     \
    support_parts((text), (const char *const[]){__VA_ARGS__, NULL}, false, __FILE__, __LINE__)

void support_parts(const char *text, const char *const *parts, bool there, const char *file, int line);

/** What the environment says of the tests, such as ROUGHCONTACT_EVERY=3: of what is many alike, each third. */
size_t support_number(const char *name, size_t usual);
/** How often a part stands in a text. */
size_t times(const char *text, const char *part);

/** A text made as by printf(), such as a file's name; good until the next 16 calls. */
const char *filled(const char *format, ...) __attribute__((format(printf, 1, 2)));

/** The same, the test's. */
char *lasting(const char *format, ...) __attribute__((format(printf, 1, 2)));

/** So many bytes, zero, the test's; fails it when there are none. */
void *support_room(size_t bytes);
/** Random numbers, always the same ones; the test's. */
gsl_rng *support_random(void);
/** The next number of a sequence that is the same on every machine: from 0 to below 1. */
double support_uniform(uint64_t *seed);
/** An empty text, the test's, to be added to. */
struct text *support_text(void);
/** The words of the program's templates, the test's. */
struct words *support_words(void);
/** A JSON value, the test's; fails it when the text is none, or one with a key twice. */
json_t *support_json(const char *text);
/** What stands at a path such as "surfaces/0/lay" or "surfaces.0.lay"; NULL: nothing. */
json_t *json_at(const json_t *root, const char *path);
/** The same as a number; NaN: it is none. */
double json_number_at(const json_t *root, const char *path);
/** The text at a path of json_at(); fails the test where there is none. */
const char *json_text_at(const json_t *json, const char *path);

struct gas;
struct parameters;
/** Index in the table of models of the one of that name, such as "gw"; fails the test when there is none. */
size_t model_named(const char *name);
/** The gas of the table of that name; fails the test when there is none. */
const struct gas *gas_named(const char *name);
/** The parameter called `name`, such as "q"; NaN: no such row. */
double parameter_named(const struct parameters *parameters, const char *name);

/** A reference table, the test's: a CSV file of tests/data; lines that start with # name its origin. Cells are text. */
struct table {
    size_t rows, columns;
    char **cell; /* (rows + 1) x columns, row 0 is the header */
};

struct table table_read(const char *name);
/** The same of a file anywhere, such as one the program wrote (no quoted cells). */
struct table table_read_path(const char *path);
/** Text of `column` in data row `row` (from 0); fails the test when there is no such column. */
const char *table_text(const struct table *table, size_t row, const char *column);
/** The same as a number. */
double table_number(const struct table *table, size_t row, const char *column);
/** The first row, from `from` on, with this text in a column; fails the test where there is none. */
size_t table_find(const struct table *table, size_t from, const char *column, const char *text);

/** Fails unless `actual` is near the number of a cell. */
#define assert_cell(actual, table, row, column, rtol)                                                                  \
    support_near((actual), table_number(&(table), (row), (column)), (rtol), 0.0, column, __FILE__, __LINE__)

/** Waits a little. */
void support_pause(void);
/** cmocka set-up: signals that end the program do so also where these tests run in the background. */
int support_take_signals(void **state);

#endif
