/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/unit.h"
#include "output/tables.h"
#include "run/pipeline.h"

#include <float.h>

static int place_setup(void **state)
{
    static struct directory place;
    place = directory_make();
    pipeline_rough(&place, "in/rough-1.csv", 120, 1, 2);
    pipeline_rough(&place, "in/rough-2.csv", 120, 1, 3);
    directory_write(&place, "in/scene.yaml",
                    "material: tin\nnominal_area: 1 mm2\nload: {from: 1e-5, to: 0.5, points: 11}\n"
                    "models: [gw, strip]\ntargets: [{ecr: 1 mohm}]\nlimits: {ecr: {most: 1 mohm}}\n"
                    "surfaces: [{name: rough, file: [rough-1.csv, rough-2.csv]}]\n");
    assert_int_equal(pipeline_run(&place, "in", "out", 1), 0);
    *state = &place;
    return 0;
}

/** Can a cell hold it? Pairs, flags and estimates are objects of JSON alone. */
static bool field_is_cell(const struct record_field *field)
{
    return field->kind == RECORD_NUMBER || field->kind == RECORD_COUNT || field->kind == RECORD_TEXT;
}

/** The columns from `first` on are the fields that are in tables, and no more where the record is the `whole` row. */
static void assert_columns(const void *place, const char *name, size_t first, const struct record_field *fields,
                           bool whole)
{
    struct table table = directory_table(place, name);
    size_t column = first;
    for (; fields->key; fields++)
        if (fields->when & (RECORD_CSV | RECORD_ASPERITIES)) {
            assert_true(field_is_cell(fields));
            assert_true(column < table.columns);
            assert_string_equal(table.cell[column++], fields->key);
        }
    assert_true(!whole || column == table.columns);
}

/** The keys from the first field's on are the fields that are in JSON, and no others where it is the `whole` object. */
static void assert_keys(json_t *object, const struct record_field *fields, bool whole)
{
    void *at = json_object_iter(object);
    while (fields->key && !(fields->when & RECORD_JSON))
        fields++;
    while (!whole && at && strcmp(json_object_iter_key(at), fields->key) != 0)
        at = json_object_iter_next(object, at);
    for (; fields->key; fields++)
        if (fields->when & RECORD_JSON) {
            assert_non_null(at);
            assert_string_equal(json_object_iter_key(at), fields->key);
            at = json_object_iter_next(object, at);
        }
    assert_true(!whole || !at);
}

/* A record's columns and its keys come from one table. */
TEST_CASE(test_a_table_of_fields_is_header_and_keys)
{
    json_t *root = directory_json(*state, "out/results.json");
    json_t *surface = json_array_get(json_object_get(root, "surfaces"), 0);
    json_t *spread = json_object_get(surface, "spread");
    assert_columns(*state, "out/data/surfaces.csv", 2, surface_fields, false);
    assert_keys(surface, surface_fields, false);
    assert_columns(*state, "out/data/answers.csv", 0, answer_fields, true);
    assert_keys(json_array_get(json_object_get(root, "answers"), 0), answer_fields, true);
    assert_columns(*state, "out/data/limits.csv", 0, limit_fields, true);
    assert_keys(json_array_get(json_object_get(root, "limits"), 0), limit_fields, true);
    assert_columns(*state, "out/data/spread.csv", 2, record_estimate_fields, true);
    assert_keys(json_object_get(spread, "rq_m"), record_estimate_fields, true);
    assert_keys(spread, repeats_fields, true);
}

/** Fails where two fields of what the bits `when` say lie at one place: one of them has the other's. */
static void assert_apart(const struct record_field *fields, unsigned when)
{
    for (const struct record_field *a = fields; a->key; a++)
        for (const struct record_field *b = fields; b < a; b++)
            if ((a->when & b->when & when) && (a->offset == b->offset || strcmp(a->key, b->key) == 0))
                fail_msg("'%s' and '%s' are one field", a->key, b->key);
}

/* A field lies where its name says: none has another's number, and they obey the equations between them. */
TEST_CASE(test_fields_lie_where_they_say)
{
    const struct record_field *const tables[] = {surface_fields, repeats_fields, answer_fields, limit_fields,
                                                 record_estimate_fields};
    for (size_t t = 0; t < sizeof tables / sizeof *tables; t++) {
        assert_apart(tables[t], RECORD_CSV);
        assert_apart(tables[t], RECORD_JSON);
    }
    struct table surfaces = directory_table(*state, "out/data/surfaces.csv");
#define NUMBER(name) table_number(&surfaces, 0, name)
    assert_near(NUMBER("rq_m") * NUMBER("rq_m"), NUMBER("m0_m2"), 1e-9);
    assert_near(NUMBER("nayak"), NUMBER("m0_m2") * NUMBER("m4_per_m2") / (NUMBER("m2") * NUMBER("m2")), 0.02);
    assert_true(0.7 * NUMBER("rq_m") < NUMBER("ra_m") && NUMBER("ra_m") < NUMBER("rq_m"));
    assert_true(NUMBER("fit_low_m") < NUMBER("fit_wavelength_m") && NUMBER("fit_wavelength_m") < NUMBER("fit_high_m"));
    assert_near(NUMBER("fit_amplitude_m"), NUMBER("alpha_SI") * pow(NUMBER("fit_wavelength_m"), NUMBER("gamma")), 1e-6);
    assert_true(NUMBER("spacing_m") < NUMBER("fit_low_m") && NUMBER("fit_high_m") < NUMBER("scan_length_m"));
#undef NUMBER
}

/* What is shown in a column is a number, in a unit of the dimension that its key ends in. */
TEST_CASE(test_shown_fields_have_units)
{
    size_t shown = 0;
    struct text words = {0};
    expect_ok(text_read_file, &words, PROJECT_SOURCE "/templates/words.txt");
    for (const struct record_field *field = surface_fields; field->key; field++) {
        struct unit unit = {.factor = 1}, key = {.factor = 1};
        const char *ending = strrchr(field->key, '_');
        if (field->digits == 0)
            continue;
        shown++;
        assert_int_equal(field->kind, RECORD_NUMBER);
        assert_in_range(field->digits, 2, 4);
        if (field->unit[0]) {
            assert_true(unit_read(&unit, field->unit, strlen(field->unit)));
            assert_true(ending && unit_read(&key, ending + 1, strlen(ending + 1)));
            assert_memory_equal(unit.power, key.power, sizeof unit.power);
        }
        assert_near(record_unit(field), unit.factor, 0);
        assert_non_null(strstr(text_string(&words), filled("\ncolumn.%s ", field->key)));
    }
    assert_true(shown >= 2);
    text_free(&words);
}

/* And the estimates have the same names in spread.csv and in results.json. */
TEST_CASE(test_estimates_have_one_name)
{
    struct table spread = directory_table(*state, "out/data/spread.csv");
    json_t *root = directory_json(*state, "out/results.json");
    json_t *surface = json_array_get(json_object_get(root, "surfaces"), 0);
    size_t found = 0;
    for (size_t row = 0; row < spread.rows; row++) {
        struct text *quantity = support_text();
        const char *given = table_text(&spread, row, "quantity"), *end = strstr(given, "_gw");
        text_add_bytes(quantity, given, end ? (size_t)(end - given) : strlen(given));
        char *middle = strstr(quantity->data, "_at_middle_load");
        if (middle)
            *middle = '\0';
        json_t *of = json_object_get(json_object_get(json_object_get(surface, "models"), "gw"), "at_middle_load");
        json_t *estimate = json_object_get(end ? of : json_object_get(surface, "spread"), quantity->data);
        if (estimate) {
            assert_near(json_number_value(json_object_get(estimate, "mean")), table_number(&spread, row, "mean"), 0);
            found++;
        }
        assert_true(estimate || (!end && strstr(given, "_strip")));
    }
    assert_true(found > 5);
}

/* One function writes a number, one a text, one what is missing. */
TEST_CASE(test_every_kind_of_field)
{
    struct record {
        double number, none, endless, pair[2];
        const char *text, *missing;
        size_t count;
        bool flag;
    };
    const struct record record = {1.5, NAN, INFINITY, {1, NAN}, "a\x01", NULL, 3, true};
#define FIELD(...) RECORD_FIELD(struct record, __VA_ARGS__)
    static const struct record_field fields[] = {
        FIELD(NUMBER, "number", number, ALWAYS), FIELD(NUMBER, "none", none, ALWAYS),
        FIELD(NUMBER, "endless", endless, JSON), FIELD(PAIR, "pair", pair, JSON),
        FIELD(TEXT, "text", text, ALWAYS),       FIELD(TEXT, "missing", missing, JSON),
        FIELD(COUNT, "count", count, JSON),      FIELD(FLAG, "flag", flag, JSON),
        FIELD(NUMBER, "elsewhere", number, CSV), {0}};
#undef FIELD
    json_t *json = record_json(fields, &record),
           *expected = json_pack("{s:f, s:n, s:n, s:[f, n], s:s, s:n, s:i, s:b}", "number", 1.5, "none", "endless",
                                 "pair", 1.0, "text", "a\\x01", "missing", "count", 3, "flag", true);
    assert_true(json_equal(json, expected));
    json_decref(json);
    json_decref(expected);
}

/* JSON has the bytes that jansson gives it. */
TEST_CASE(test_json_is_as_jansson_prints_it)
{
    static const double numbers[] = {0,      -0.0,    1,      -2,    0.1,    1.0 / 3, 1e-7,  -1.5e-7,  1e16,
                                     1e17,   1e22,    2.5e30, 1e100, 1e-45,  1e-4,    1e-5,  123456.5, 6.02214076e23,
                                     1e-300, DBL_MAX, 1e-10,  1e10,  5e-324, 100,     7e-20, 0.5};
    json_t *json = json_pack("{s:s, s:[], s:{}, s:n, s:b, s:i, s:{s:[[s], {s:s}]}, s:o}", "text \"\\\n", "µ\x01\"",
                             "none", "nothing", "null", "flag", 1, "count", -7, "deep", "er", "a", "b", "ü", "numbers",
                             json_numbers(numbers, sizeof numbers / sizeof *numbers));
    struct text *text = support_text();
    char *expected = json_dumps(json, JSON_INDENT(1) | JSON_REAL_PRECISION(17));
    assert_true(json_text(text, json));
    assert_string_equal(text_string(text), expected);
    assert_false(json_text(text, NULL));
    free(expected);
    json_decref(json);
}

TEST_GROUP(place_setup, directory_teardown)
