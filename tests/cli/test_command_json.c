/* SPDX-License-Identifier: GPL-3.0-or-later */
/* --json: one value on standard output and nothing else, which says what the text says; docs/commands.md has its keys.
 */
#include "cli/process.h"
#include "contact/effect.h"
#include "contact/model.h"
#include "joint/joint.h"
#include "material/material.h"

#include <inttypes.h>

static const char *const scene = "material: tin\neffects: [plasticity, electrical]\nnominal_area: 1 mm2\n"
                                 "load: {from: 1e-7, to: 1e-5, points: 7}\nmodels: [multiscale, corrected-persson]\n"
                                 "targets: [{ecr: 1 uohm}, {area: 5 %}]\n"
                                 "limits: {ecr: {most: 1e-12 mohm}, area: {least: 1e-9}}\n";

static json_t *run_json(const char *place, int status, const char *command, const char *directory)
{
    return process_json(directory ? expect_exit(place, status, command, directory, "--json")
                                  : expect_exit(place, status, command, "--json"));
}

static const char *text_of(const json_t *json, const char *key)
{
    const char *text = json_string_value(json_object_get(json, key));
    if (!text)
        fail_msg("no text '%s'", key);
    return text;
}

static double number_of(const json_t *json, const char *key)
{
    const json_t *number = json_object_get(json, key);
    if (!json_is_number(number))
        fail_msg("no number '%s'", key);
    return json_number_value(number);
}

/** The object of the array whose `key` is `name`. */
static json_t *find(const json_t *array, const char *key, const char *name)
{
    size_t index;
    json_t *item;
    json_array_foreach(array, index, item) if (strcmp(text_of(item, key), name) == 0) return item;
    fail_msg("nothing is called '%s'", name);
    return NULL;
}

/** Names of models, effects and materials' properties are keys or texts of their own. */
static bool is_row_name(const char *key)
{
    for (size_t m = 0; m < model_count; m++)
        if (strcmp(key, model_rows[m]->name) == 0)
            return true;
    for (size_t p = 0; p < material_property_count; p++)
        if (strcmp(key, material_properties[p].key) == 0)
            return true;
    return false;
}

static size_t check_described(const char *document, json_t *json)
{
    size_t keys = 0, index;
    const char *key;
    json_t *value;
    json_object_foreach(json, key, value)
    {
        if (!is_row_name(key))
            expect_part(document, filled("`%s`", key));
        keys += 1 + check_described(document, value);
    }
    if (json_is_array(json))
        json_array_foreach(json, index, value) keys += check_described(document, value);
    return keys;
}

static void expect_described(json_t *json)
{
    char *document = workspace_read(PROJECT_SOURCE, "docs/commands.md");
    assert_true(check_described(document, json) > 0);
}

/* The tables of the program: every word of a row of its JSON stands in its text. */
TEST_IN_WORKSPACE(test_tables)
{
    static const char *const commands[] = {"models", "materials"};
    for (size_t c = 0; c < 2; c++) {
        json_t *json = run_json(place, 0, commands[c], NULL), *row, *value;
        struct process text = expect_exit(place, 0, commands[c]);
        const char *key;
        size_t i;
        process_unwrap(&text);
        const size_t fluids = gas_count + gas_liquid_count;
        size_t layers = c == 0 ? 0 : JOINT_PLATINGS - 1 + JOINT_FILLERS - 1 + fluids;
        assert_int_equal(json_array_size(json), (c == 0 ? model_count : material_table_count) + layers);
        json_array_foreach(json, i, row)
        {
            bool material = c == 1 && i < material_table_count;
            if (c == 0 || material)
                assert_string_equal(text_of(row, c == 0 ? "model" : "material"),
                                    c == 0 ? model_rows[i]->name : material_table[i].name);
            else if (i >= json_array_size(json) - fluids)
                assert_true(number_of(row, "least_temperature_K") < number_of(row, "most_temperature_K"));
            else
                assert_true(number_of(row, "least_thickness_m") < number_of(row, "most_thickness_m"));
            assert_true(strlen(text_of(row, "source")) > 0);
            json_object_foreach(row, key, value) if (json_is_string(value))
                expect_part(text.out, json_string_value(value));
            for (size_t p = 0; p < material_property_count && material; p++)
                if (!isnan(material_value(&material_table[i], &material_properties[p])))
                    assert_near(number_of(row, material_properties[p].key),
                                material_value(&material_table[i], &material_properties[p]), 0);
        }
        expect_described(json);
    }
    expect_output(expect_exit(place, 0, "materials"), "\nindium\n  E_Pa                     1.27e+10\n",
                  "\nplating tin\n  resistivity_ohm_m        1.2e-07\n", "\nfiller pad\n");
}

/** Two surfaces, one file of which cannot be read. */
static void make_scans(const char *place, bool broken)
{
    workspace_scans(place, "d", 2, 300, 1);
    if (broken)
        workspace_write(place, "d/broken.csv", "x [um],z [um]\n0,1\n1,two\n");
    workspace_write(place, "d/scene.yaml", scene);
}

TEST_IN_WORKSPACE(test_plan)
{
    make_scans(place, true);
    struct process process = expect_exit(place, 1, "plan", "d", "--json"), text = expect_exit(place, 1, "plan", "d");
    process_unwrap(&text);
    json_t *json = support_json(process.out);
    assert_string_equal(process.err, text.err);
    const json_t *effects = json_object_get(json, "effects"), *row;
    size_t index;
    assert_int_equal(json_array_size(effects), EFFECT_COUNT + 1);
    json_array_foreach(effects, index, row)
    {
        char start[64], runs[16];
        snprintf(start, sizeof start, "\n%-16s ", text_of(row, "effect"));
        const char *line = strstr(text.out, start);
        assert_non_null(line);
        assert_int_equal(sscanf(line + strlen(start), "%15s", runs), 1);
        assert_int_equal(strcmp(runs, "run") == 0, json_is_true(json_object_get(row, "runs")));
        expect_part(line, text_of(row, "reason"));
    }
    expect_part(text.out, filled(": about %.2g s\n", number_of(json, "seconds")));
    for (size_t m = 0; m < model_count; m++) {
        const json_t *model = find(json_object_get(json, "models"), "model", model_rows[m]->name);
        expect_part(text.out, filled("\n%-31s %-8s ", model_rows[m]->label,
                                     json_is_true(json_object_get(model, "runs")) ? "run" : "skipped"));
    }
    assert_int_equal(json_integer_value(json_object_get(json, "loads")), 7);
    assert_int_equal(json_integer_value(json_object_get(json, "targets")), 2);
    assert_near(number_of(json, "tolerance"), 1e-6, 0);
    assert_string_equal(text_of(json, "closure"), "thesis");
    assert_true(json_is_true(json_object_get(json, "material_known")));
    assert_int_equal(number_of(json, "exit_status"), 1);
    const json_t *surfaces = json_object_get(json, "surfaces");
    assert_int_equal(json_array_size(surfaces), 3);
    assert_true(json_is_true(json_object_get(find(surfaces, "surface", "a"), "usable")));
    expect_part(text.err, text_of(find(surfaces, "surface", "broken"), "refused"));
    expect_described(json);
    json_t *second = run_json(place, 1, "plan", "d");
    assert_true(json_equal(json, second));
}

TEST_IN_WORKSPACE(test_report)
{
    make_scans(place, true);
    struct process process = expect_exit(place, 1, "report", "d", "-o", "out", "--json", "--no-cost");
    json_t *json = support_json(process.out), *results = workspace_json(place, "out/results.json");
    assert_string_equal(text_of(json, "report"), "out/report.html");
    assert_string_equal(text_of(json, "results"), "out/results.json");
    assert_true(json_is_null(json_object_get(json, "error")));
    assert_int_equal(number_of(json, "exit_status"), 1);
    assert_string_equal(text_of(json, "exit_reason"), "report written but some scan was refused");
    assert_true(json_equal(json_object_get(json, "answers"), json_object_get(results, "answers")));
    assert_true(json_equal(json_object_get(json, "limits"), json_object_get(results, "limits")));
    assert_int_equal(json_array_size(json_object_get(json, "missed_limits")), 2);
    static const char *const names[] = {"a", "b"};
    for (size_t i = 0; i < 2; i++) {
        const json_t *missed = find(json_object_get(json, "missed_limits"), "surface", names[i]);
        assert_string_equal(text_of(missed, "verdict"), "missed");
        assert_string_equal(text_of(missed, "limit"), "ecr most 1e-12 mohm");
    }
    assert_true(json_equal(json_object_get(json, "refused"), json_object_get(results, "refused")));
    expect_part(process.err, text_of(json_array_get(json_object_get(json, "refused"), 0), "error"));
    expect_part(process.err, json_string_value(json_array_get(json_object_get(json, "messages"), 0)));
    const json_t *work = json_object_get(json, "work");
    assert_true(json_integer_value(json_object_get(work, "evaluations")) > 0);
    expect_described(json);
    /* again the same */
    json_t *second = process_json(expect_exit(place, 1, "report", "d", "-o", "out", "--json", "--no-cost"));
    assert_true(json_equal(json, second));
    json_t *checked = process_json(expect_exit(place, 5, "report", "d", "-o", "out", "--json", "--no-cost", "--check"));
    assert_int_equal(number_of(checked, "exit_status"), 5);
    assert_string_equal(text_of(checked, "exit_reason"), "report --check: a limit is missed");
}

/** A command that fails says so in JSON too, and on standard error as ever. */
TEST_IN_WORKSPACE(test_failures)
{
    static const char *const commands[] = {"report", "direct", "plan"};
    static const struct {
        const char *directory, *message;
        int status;
    } wrong[] = {{"nowhere", "cannot open directory 'nowhere'", 4},
                 {"bad", "bad/scene.yaml:1: unknown key 'x'", 3},
                 {"none", "no readable scan in 'none'", 4}};
    workspace_scan(place, "bad/a.csv", 100, 1);
    workspace_write(place, "bad/scene.yaml", "x: 1\n");
    workspace_write(place, "none/broken.csv", "x [um],z [um]\n0,1\n1,two\n");
    for (size_t c = 0; c < sizeof commands / sizeof *commands; c++)
        for (size_t w = 0; w < sizeof wrong / sizeof *wrong; w++) {
            struct process process = expect_exit(place, wrong[w].status, commands[c], wrong[w].directory, "--json");
            json_t *json = support_json(process.out);
            expect_part(process.err, wrong[w].message);
            expect_part(text_of(json, "error"), wrong[w].message);
            assert_string_equal(text_of(json, "directory"), wrong[w].directory);
            assert_int_equal(number_of(json, "exit_status"), wrong[w].status);
            expect_described(json);
            if (w == 2 && c < 2)
                expect_part(json_string_value(json_array_get(json_object_get(json, "messages"), 0)), "two");
        }
    workspace_write(place, "bad/scene.yaml", "material: tin\n");
    json_t *json = process_json(expect_exit(place, 2, "report", "bad", "--json", "--check"));
    expect_part(text_of(json, "error"), "--check: the scene has no 'limits' to check");
    expect_failure(place, 2, 3, "--show draws where --json prints", "report", "bad", "--json", "--show");
    assert_false(workspace_has(place, "out"));
}
