/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support.h"

#include "base/words.h"
#include "contact/model.h"
#include "joint/gas.h"
#include "spectrum/parameters.h"
#include <signal.h>
#include <stdio.h>
#include <time.h>

const struct threads test_alone = {.jobs = 1};

static struct {
    void *what;
    void (*end)(void *what);
} * owned;
static size_t owned_count, kept;

void *test_owns(void *what, void (*end)(void *what))
{
    assert_non_null(what);
    if ((owned_count & (owned_count - 1)) == 0) /* full at 0 and powers of 2 */
        owned = realloc(owned, (2 * owned_count + 1) * sizeof *owned);
    assert_non_null(owned);
    owned[owned_count].what = what;
    owned[owned_count++].end = end;
    return what;
}

int test_end(void **state, CMFixtureFunction after)
{
    int rc = after ? after(state) : 0;
    while (owned_count > kept) {
        owned_count--;
        owned[owned_count].end(owned[owned_count].what);
    }
    return rc;
}

void test_keep(void)
{
    kept = owned_count;
}

bool test_in_file(const char *path, const char *end)
{
    size_t length = strlen(end), all = strlen(path);
    return length > 0 && length < all && strcmp(path + all - length, end) == 0;
}

void support_near(double actual, double expected, double rtol, double atol, const char *what, const char *file,
                  int line)
{
    double error = fabs(actual - expected);
    if (isfinite(actual) && isfinite(expected) && error <= rtol * fabs(expected) + atol)
        return;
    print_error("%s = %.17g, expected %.17g: error %.3g relative, %.3g absolute (allowed %.3g, %.3g)\n", what, actual,
                expected, error / fabs(expected), error, rtol, atol);
    _fail(file, line);
}

void support_parts(const char *text, const char *const *parts, bool there, const char *file, int line)
{
    for (; *parts; parts++)
        if ((strstr(text, *parts) != NULL) != there) {
            print_error("%s: %s\nin:\n%.4000s\n", there ? "missing" : "should not be there", *parts, text);
            _fail(file, line);
        }
}

void *support_room(size_t bytes)
{
    return test_owns(calloc(1, bytes), free);
}

static void end_random(void *random)
{
    gsl_rng_free(random);
}

gsl_rng *support_random(void)
{
    return test_owns(gsl_rng_alloc(gsl_rng_mt19937), end_random);
}

double support_uniform(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) * 0x1p-53;
}

static void end_text(void *text)
{
    text_free(text);
    free(text);
}

struct text *support_text(void)
{
    return test_owns(calloc(1, sizeof(struct text)), end_text);
}

static void end_words(void *words)
{
    words_free(words);
}

struct words *support_words(void)
{
    struct status *status = support_room(sizeof *status); /* which the words keep */
    struct words *words = support_room(sizeof *words);
    assert_int_equal(words_read(words, PROJECT_SOURCE "/templates", status), STATUS_OK);
    return test_owns(words, end_words);
}

static void end_json(void *json)
{
    json_decref(json);
}

json_t *support_json(const char *text)
{
    json_error_t error;
    json_t *json = json_loads(text, JSON_REJECT_DUPLICATES, &error);
    if (!json)
        fail_msg("no JSON: %s, line %d: %.400s", error.text, error.line, text);
    return test_owns(json, end_json);
}

json_t *json_at(const json_t *root, const char *path)
{
    const json_t *at = root;
    for (size_t length; at && *path; path += length + (path[length] != '\0')) {
        length = strcspn(path, "./");
        at = json_is_array(at) ? json_array_get(at, strtoul(path, NULL, 10)) : json_object_getn(at, path, length);
    }
    return (json_t *)at;
}

const char *json_text_at(const json_t *json, const char *path)
{
    if (!json_is_string(json_at(json, path)))
        fail_msg("no text '%s'", path);
    return json_string_value(json_at(json, path));
}

double json_number_at(const json_t *root, const char *path)
{
    const json_t *number = json_at(root, path);
    return json_is_number(number) ? json_number_value(number) : NAN;
}

const char *filled(const char *format, ...)
{
    static char texts[16][8192];
    static unsigned next;
    char *text = texts[next++ % 16];
    va_list args;
    va_start(args, format);
    int length = vsnprintf(text, sizeof texts[0], format, args);
    va_end(args);
    assert_true(length >= 0 && (size_t)length < sizeof texts[0]);
    return text;
}

char *lasting(const char *format, ...)
{
    char *text = NULL;
    va_list args;
    va_start(args, format);
    assert_true(vasprintf(&text, format, args) >= 0);
    va_end(args);
    return test_owns(text, free);
}

size_t times(const char *text, const char *part)
{
    size_t count = 0;
    for (; (text = strstr(text, part)); text++)
        count++;
    return count;
}

size_t model_named(const char *name)
{
    for (size_t m = 0; m < model_count; m++)
        if (strcmp(model_rows[m]->name, name) == 0)
            return m;
    fail_msg("no model '%s'", name);
    return model_count;
}

const struct gas *gas_named(const char *name)
{
    for (size_t i = 0; i < gas_count; i++)
        if (strcmp(gas_table[i].name, name) == 0)
            return &gas_table[i];
    fail_msg("no gas '%s'", name);
    return NULL;
}

double parameter_named(const struct parameters *parameters, const char *name)
{
    for (size_t p = 0; p < PARAMETERS_COUNT; p++)
        if (strcmp(parameters_names[p], name) == 0)
            return parameters->value[p];
    return NAN;
}

static size_t count_columns(const char *line)
{
    size_t columns = 1;
    for (; *line; line++)
        columns += *line == ',';
    return columns;
}

struct table table_read(const char *name)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", TEST_DATA, name);
    return table_read_path(path);
}

struct table table_read_path(const char *path)
{
    FILE *file = fopen(path, "r");
    if (!file)
        fail_msg("cannot open %s", path);
    struct table table = {0};
    OWNED(memory_free) char *line = NULL;
    size_t capacity = 0, lines = 0;
    while (getline(&line, &capacity, file) > 0) {
        line[strcspn(line, "\r\n")] = '\0';
        if (line[0] == '#' || line[0] == '\0')
            continue;
        if (lines == 0)
            table.columns = count_columns(line);
        assert_int_equal(count_columns(line), table.columns);
        table.cell = realloc(table.cell, (lines + 1) * table.columns * sizeof *table.cell);
        assert_non_null(table.cell);
        char *rest = test_owns(strdup(line), free);
        for (size_t c = 0; c < table.columns; c++)
            table.cell[lines * table.columns + c] = strsep(&rest, ",");
        lines++;
    }
    fclose(file);
    assert_true(lines > 1);
    table.rows = lines - 1;
    test_owns(table.cell, free);
    return table;
}

const char *table_text(const struct table *table, size_t row, const char *column)
{
    assert_true(row < table->rows);
    for (size_t c = 0; c < table->columns; c++)
        if (strcmp(table->cell[c], column) == 0)
            return table->cell[(row + 1) * table->columns + c];
    fail_msg("no column '%s'", column);
    return NULL;
}

double table_number(const struct table *table, size_t row, const char *column)
{
    return strtod(table_text(table, row, column), NULL);
}

size_t table_find(const struct table *table, size_t from, const char *column, const char *text)
{
    while (from < table->rows && strcmp(table_text(table, from, column), text) != 0)
        from++;
    if (from == table->rows)
        fail_msg("no row with %s '%s'", column, text);
    return from;
}

size_t support_number(const char *name, size_t usual)
{
    const char *said = getenv(name);
    return said ? strtoul(said, NULL, 10) : usual;
}

void support_pause(void)
{
    nanosleep(&(const struct timespec){.tv_nsec = 5000000}, NULL);
}

int support_take_signals(void **state)
{
    static const int used[] = {SIGINT, SIGTERM, SIGHUP};
    (void)state;
    for (size_t i = 0; i < sizeof used / sizeof *used; i++)
        if (signal(used[i], SIG_DFL) == SIG_ERR)
            return 1;
    return 0;
}
