/* SPDX-License-Identifier: GPL-3.0-or-later */
/* --json prints one value and nothing else, with what the text says; docs/commands.md lists its keys. */
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

/** The object of the array whose `key` is `name`. */
static json_t *find(const json_t *array, const char *key, const char *name)
{
    size_t index;
    json_t *item;
    json_array_foreach (array, index, item)
        if (strcmp(json_text_at(item, key), name) == 0)
            return item;
    fail_msg("nothing is called '%s'", name);
    return NULL;
}

static void expect_described(json_t *json)
{
    assert_true(expect_keys_described(workspace_read(PROJECT_SOURCE, "docs/commands.md"), json, false) > 0);
}

/* `models` and `materials`: each text in the JSON also stands in the printed table. */
TEST_IN_WORKSPACE(test_tables)
{
    static const char *const commands[] = {"models", "materials"};
    for (size_t c = 0; c < 2; c++) {
        json_t *json = process_json(expect_exit(place, 0, commands[c], "--json")), *row, *value;
        struct process text = expect_exit(place, 0, commands[c]);
        const char *key;
        size_t i;
        process_unwrap(&text);
        const size_t fluids = gas_count + gas_liquid_count;
        size_t layers = c == 0 ? 0 : JOINT_PLATINGS - 1 + JOINT_FILLERS - 1 + fluids;
        assert_int_equal(json_array_size(json), (c == 0 ? model_count : material_table_count) + layers);
        json_array_foreach (json, i, row) {
            bool material = c == 1 && i < material_table_count;
            if (c == 0 || material)
                assert_string_equal(json_text_at(row, c == 0 ? "model" : "material"),
                                    c == 0 ? model_rows[i]->name : material_table[i].name);
            else if (i >= json_array_size(json) - fluids)
                assert_true(json_number_at(row, "least_temperature_K") < json_number_at(row, "most_temperature_K"));
            else
                assert_true(json_number_at(row, "least_thickness_m") < json_number_at(row, "most_thickness_m"));
            assert_true(strlen(json_text_at(row, "source")) > 0);
            json_object_foreach (row, key, value)
                if (json_is_string(value))
                    expect_part(text.out, json_string_value(value));
            for (size_t p = 0; p < material_property_count && material; p++)
                if (!isnan(material_value(&material_table[i], &material_properties[p])))
                    assert_near(json_number_at(row, material_properties[p].key),
                                material_value(&material_table[i], &material_properties[p]), 0);
        }
        expect_described(json);
    }
    expect_output(expect_exit(place, 0, "materials"), "\nindium\n  E_Pa                     1.27e+10\n",
                  "\nplating tin\n  resistivity_ohm_m        1.2e-07\n", "\nfiller pad\n");
}

/** Two surfaces, and a third whose file cannot be read. */
static void make_scans(const char *place)
{
    workspace_scans(place, "d", 2, 300, 1);
    workspace_write(place, "d/broken.csv", "x [um],z [um]\n0,1\n1,two\n");
    workspace_write(place, "d/scene.yaml", scene);
}

TEST_IN_WORKSPACE(test_plan)
{
    make_scans(place);
    struct process process = expect_exit(place, 1, "plan", "d", "--json"), text = expect_exit(place, 1, "plan", "d");
    process_unwrap(&text);
    json_t *json = support_json(process.out);
    assert_string_equal(process.err, text.err);
    const json_t *effects = json_object_get(json, "effects"), *row;
    size_t index;
    assert_int_equal(json_array_size(effects), EFFECT_COUNT + 1);
    json_array_foreach (effects, index, row) {
        char start[64], runs[16];
        snprintf(start, sizeof start, "\n%-16s ", json_text_at(row, "effect"));
        const char *line = strstr(text.out, start);
        assert_non_null(line);
        assert_int_equal(sscanf(line + strlen(start), "%15s", runs), 1);
        assert_int_equal(strcmp(runs, "run") == 0, json_is_true(json_object_get(row, "runs")));
        expect_part(line, json_text_at(row, "reason"));
    }
    expect_part(text.out, filled(": about %.2g s\n", json_number_at(json, "seconds")));
    for (size_t m = 0; m < model_count; m++) {
        const json_t *model = find(json_object_get(json, "models"), "model", model_rows[m]->name);
        expect_part(text.out, filled("\n%-31s %-8s ", model_rows[m]->label,
                                     json_is_true(json_object_get(model, "runs")) ? "run" : "skipped"));
    }
    static const struct {
        const char *key;
        double value;
    } numbers[] = {{"loads", 7}, {"targets", 2}, {"tolerance", 1e-6}, {"exit_status", 1}};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        assert_near(json_number_at(json, numbers[i].key), numbers[i].value, 0);
    assert_string_equal(json_text_at(json, "closure"), "thesis");
    assert_true(json_is_true(json_object_get(json, "material_known")));
    const json_t *surfaces = json_object_get(json, "surfaces");
    assert_int_equal(json_array_size(surfaces), 3);
    assert_true(json_is_true(json_object_get(find(surfaces, "surface", "a"), "usable")));
    expect_part(text.err, json_text_at(find(surfaces, "surface", "broken"), "refused"));
    expect_described(json);
    assert_true(json_equal(json, process_json(expect_exit(place, 1, "plan", "d", "--json"))));
}

TEST_IN_WORKSPACE(test_report)
{
    make_scans(place);
    struct process process = expect_exit(place, 1, "report", "d", "-o", "out", "--json", "--no-cost");
    json_t *json = support_json(process.out), *results = workspace_json(place, "out/results.json");
    assert_string_equal(json_text_at(json, "report"), "out/report.html");
    assert_string_equal(json_text_at(json, "results"), "out/results.json");
    assert_true(json_is_null(json_object_get(json, "error")));
    assert_int_equal(json_number_at(json, "exit_status"), 1);
    assert_string_equal(json_text_at(json, "exit_reason"), "report written but some scan was refused");
    static const char *const same[] = {"answers", "limits", "refused"};
    for (size_t i = 0; i < 3; i++)
        assert_true(json_equal(json_object_get(json, same[i]), json_object_get(results, same[i])));
    assert_int_equal(json_array_size(json_object_get(json, "missed_limits")), 2);
    static const char *const names[] = {"a", "b"};
    for (size_t i = 0; i < 2; i++) {
        const json_t *missed = find(json_object_get(json, "missed_limits"), "surface", names[i]);
        assert_string_equal(json_text_at(missed, "verdict"), "missed");
        assert_string_equal(json_text_at(missed, "limit"), "ecr most 1e-12 mohm");
    }
    expect_parts(process.err, json_text_at(json, "refused.0.error"), json_text_at(json, "messages.0"));
    assert_true(json_number_at(json, "work.evaluations") > 0);
    expect_described(json);
    json_t *again = process_json(expect_exit(place, 1, "report", "d", "-o", "out", "--json", "--no-cost"));
    assert_true(json_equal(json, again));
    json_t *checked = process_json(expect_exit(place, 5, "report", "d", "-o", "out", "--json", "--no-cost", "--check"));
    assert_int_equal(json_number_at(checked, "exit_status"), 5);
    assert_string_equal(json_text_at(checked, "exit_reason"), "report --check: a limit is missed");
}

/** A command that fails says so in JSON as well as on standard error. */
TEST_IN_WORKSPACE(test_failures)
{
    static const char *const commands[] = {"report", "direct", "plan"};
    static const struct {
        const char *directory, *message;
        int status;
    } wrong[] = {{"nowhere", "cannot open directory 'nowhere'", 4},
                 {"bad", "bad/scene.yaml:1: unknown key 'x'", 3},
                 {"none", "no usable surface in 'none'", 4}};
    workspace_scan(place, "bad/a.csv", 100, 1);
    workspace_write(place, "bad/scene.yaml", "x: 1\n");
    workspace_write(place, "none/broken.csv", "x [um],z [um]\n0,1\n1,two\n");
    for (size_t c = 0; c < sizeof commands / sizeof *commands; c++)
        for (size_t w = 0; w < sizeof wrong / sizeof *wrong; w++) {
            struct process process = expect_exit(place, wrong[w].status, commands[c], wrong[w].directory, "--json");
            json_t *json = support_json(process.out);
            expect_part(process.err, wrong[w].message);
            expect_part(json_text_at(json, "error"), wrong[w].message);
            assert_string_equal(json_text_at(json, "directory"), wrong[w].directory);
            assert_int_equal(json_number_at(json, "exit_status"), wrong[w].status);
            expect_described(json);
            if (w == 2 && c < 2)
                expect_part(json_text_at(json, "messages.0"), "two");
        }
    workspace_write(place, "bad/scene.yaml", "material: tin\n");
    json_t *json = process_json(expect_exit(place, 2, "report", "bad", "--json", "--check"));
    expect_part(json_text_at(json, "error"), "--check: the scene has no 'limits' to check");
    expect_failure(place, 2, 3, "--show draws where --json prints", "report", "bad", "--json", "--show");
    assert_false(workspace_has(place, "out"));
}
