/* SPDX-License-Identifier: GPL-3.0-or-later */
/* inspect, plan, synth, models, materials, and what the command line says about itself. */
#include "cli/process.h"

#include <inttypes.h>

#include "base/version.h"
#include "cli/command.h"
#include "contact/effect.h"
#include "contact/model.h"
#include "material/material.h"

TEST_IN_WORKSPACE(test_help)
{
    static const char *const spellings[] = {"--help", "-h"};
    for (size_t i = 0; i < 2; i++) {
        struct process process = expect_exit(place, 0, spellings[i]);
        for (size_t c = 0; c < COMMANDS; c++)
            expect_part(process.out, command_rows[c].name);
        expect_part(
            process.out,
            "Exit status:\n0 done; 1 report written but some scan was refused; 2 usage;\n"
            "3 scene invalid; 4 nothing could be reported, or not on standard output; 5 report --check: a limit "
            "is missed;\n6 report --check: no limit is missed, but one is undecided.\n");
        assert_string_equal(process.err, "");
    }
    for (size_t c = 0; c < COMMANDS; c++) {
        struct process process = expect_exit(place, 0, command_rows[c].name, "--help");
        expect_part(process.out, filled("Usage: roughcontact %s", command_rows[c].name));
        if (command_rows[c].argp->options)
            expect_part(process.out, "(default");
        assert_string_equal(process.err, "");
        struct process again = expect_exit(place, 0, command_rows[c].name, "-h");
        assert_string_equal(again.out, process.out);
    }
    struct process help = expect_exit(place, 0, "report", "--help");
    const char *effects = strstr(help.out, "--effects=EFFECTS"), *end = effects ? strstr(effects, "-m, ") : NULL;
    assert_non_null(end);
    char *list = lasting("%.*s", (int)(end - effects), effects);
    for (int e = 0; e < EFFECT_COUNT; e++)
        expect_part(list, effect_rows[e].name);
}

TEST_IN_WORKSPACE(test_version)
{
    const char *version = filled("roughcontact %s\nbuilt by ", version_string());
    struct process process = expect_exit(place, 0, "--version");
    assert_memory_equal(process.out, version, strlen(version));
    expect_output(process, "\nfftw-3.", ", GSL ");
}

/* Loading libraries takes most of the program's start: libcrypto and libzip, with what they load, took five times as
 * long as all the others. */
TEST_IN_WORKSPACE(test_what_is_loaded)
{
    const char *loaded = workspace_shell(place, "LD_TRACE_LOADED_OBJECTS=1 " PROGRAM);
    expect_parts(loaded, "libexpat", "libz.");
    expect_no_parts(loaded, "libcrypto", "libzip");
}

TEST_IN_WORKSPACE(test_usage)
{
    expect_failure(place, 2, 1, "unknown command 'reprot'; did you mean 'report'?", "reprot", "d");
    expect_failure(place, 2, 1,
                   "unknown command '--bogus'; allowed: report, direct, plan, init, inspect, compare, synth, "
                   "models, materials",
                   "--bogus");
    expect_failure(place, 2, 1, "unknown command 'a?b'",
                   "a\x1b"
                   "b");
    static const char *const on_directories[] = {"report", "direct", "plan", "init"};
    for (size_t i = 0; i < sizeof on_directories / sizeof *on_directories; i++)
        expect_failure(place, 2, 3, filled("roughcontact %s: which directory of scans?", on_directories[i]),
                       on_directories[i]);
    expect_failure(place, 2, 3, "roughcontact inspect: which file?", "inspect");
    expect_failure(place, 2, 3, "roughcontact models: Too many arguments", "models", "x");
    expect_failure(place, 2, 3, "option requires an argument -- 'o'", "report", "d", "-o");
    struct process process = run_program(place, PROGRAM);
    assert_int_equal(process.status, 2);
    assert_string_equal(process.out, "");
    expect_part(process.err, "Usage: roughcontact COMMAND");
}

TEST_IN_WORKSPACE(test_tables_are_narrow)
{
    static const char *const commands[] = {"models", "materials"};
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
        struct process process = expect_exit(place, 0, commands[i]);
        assert_true(process.out_length > 1000);
        expect_narrow(process.out);
    }
}

/* The plan says for every effect what it would change, or why it does not run. */
TEST_IN_WORKSPACE(a_plan_says_what_each_effect_changes)
{
    static const char *const materials[] = {"material: tin\n", "material: tin\ngap: {gas: air}\nfilm: 1e-13\n",
                                            "material: {E: 40 GPa, nu: 0.3, Sy: 1e12}\n", ""};
    workspace_scan(place, "d/a.csv", 200, 1);
    for (size_t i = 0; i < sizeof materials / sizeof *materials; i++) {
        workspace_write(place, "d/scene.yaml", materials[i]);
        json_t *plan = process_json(expect_exit(place, 0, "plan", "d", "--json")), *effect;
        size_t k;
        json_array_foreach (json_object_get(plan, "effects"), k, effect) {
            const char *reason = json_text_at(effect, "reason");
            bool told = *json_text_at(effect, "changes") ||
                        (!json_is_true(json_object_get(effect, "runs")) &&
                         (strstr(reason, "below the tolerance") || strstr(filled(" %s", reason), " no ")));
            if (k > 0 && !told)
                fail_msg("%s: %s", json_text_at(effect, "effect"), reason);
        }
        if (i == 2)
            expect_part(json_text_at(plan, "effects.1.reason"), " of the area at most, below the tolerance");
    }
    workspace_write(place, "d/scene.yaml", materials[1]);
    expect_output(expect_exit(place, 0, "plan", "d"), "the report says by how much\n", "changes no other\n",
                  "changes no number\n");
}

TEST_IN_WORKSPACE(test_plan)
{
    workspace_scan(place, "d/a.csv", 200, 1);
    workspace_write(place, "d/scene.yaml", "load: {from: 1e-4, to: 1e-2, points: 7}\n");
    expect_output(expect_exit(place, 0, "plan", "d"), "\nNo material is given, so area and separation");
    expect_output(expect_exit(place, 0, "report", "d", "--no-cost"), "At 2.15·10⁻⁴\u00a0E′Aₙ the contact area is ");
    workspace_write(place, "d/scene.yaml",
                    "material: tin\neffects: [electrical]\nload: {from: 1e-4, to: 1e-2, points: 7}\n");
    char *before = workspace_digest(place, ".");
    struct process process = expect_exit(place, 0, "plan", "d");
    expect_no_part(process.out, "No material is given");
    expect_part(process.out, "\nsurfaces: 1, loads: 7, tolerance 1e-06, closure thesis: about 0.25 s\n");
    expect_narrow(process.out);
    expect_output(
        expect_exit(place, 0, "plan", "d", "--effects", "thermal", "--tolerance", "1e-3", "--material", "gold"),
        "\nelectrical       skipped ", "\nthermal          run     ", "tolerance 0.001");
    expect_digest(place, ".", before); /* no out/, nothing at all */
}

TEST_IN_WORKSPACE(test_inspect)
{
    workspace_scan(place, "a.csv", 300, 1);
    workspace_scan(place, "b.csv", 300, 2);
    workspace_write(place, "bad.csv", "nothing\n");
    assert_int_equal(setenv("COLUMNS", "80", 1), 0);
    struct process process = expect_exit(place, 0, "inspect", "--chart", "a.csv");
    expect_part(process.out, "profile");
    expect_narrow(strstr(process.out, "z (um)"));
    process = expect_exit(place, 0, "inspect", "a.csv");
    expect_no_part(process.out, "z (um)");

    process = expect_exit(place, 1, "inspect", "--chart", "a.csv", "bad.csv", "b.csv");
    expect_parts(process.out, "a.csv\n", "b.csv\n");
    assert_string_equal(process.err, "roughcontact: bad.csv: no line of numbers in it: not a scan; where columns hold "
                                     "text choose others, as in `column: [2, 3]`\n");
    expect_failure(place, 4, 2, "cannot open 'nowhere.csv'", "inspect", "nowhere.csv", "bad.csv");
    assert_int_equal(unsetenv("COLUMNS"), 0);
}

TEST_IN_WORKSPACE(test_inspect_json)
{
    static const char *const numbers[] = {"points", "spacing_m", "length_m",  "missing",  "rq_m", "ra_m",
                                          "pv_m",   "m2",        "m4_per_m2", "alpha_SI", "gamma"};
    static const char *const texts[] = {"file", "format", "kind", "x_unit", "z_unit"};
    workspace_scan(place, "a.csv", 300, 1);
    workspace_write(place, "bad.csv", "nothing\n");
    json_t *json = process_json(expect_exit(place, 1, "inspect", "--json", "a.csv", "bad.csv"));
    assert_int_equal(json_array_size(json), 2);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        (void)json_number_at(json, filled("0.%s", numbers[i]));
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        (void)json_text_at(json, filled("0.%s", texts[i]));
    assert_true(json_is_array(json_at(json, "0.warnings")));
    assert_string_equal(json_text_at(json, "0.kind"), "profile");
    assert_near(json_number_at(json, "0.points"), 300, 0);
    assert_near(json_number_at(json, "0.spacing_m"), 0.5e-6, 1e-12);
    assert_near(json_number_at(json, "0.length_m"), 149.5e-6, 1e-12);
    assert_string_equal(json_text_at(json, "1.file"), "bad.csv");
    expect_part(json_text_at(json, "1.error"), "no line of numbers in it");
    assert_int_equal(json_object_size(json_at(json, "1")), 2);
}

TEST_IN_WORKSPACE(test_synth)
{
    struct process process = expect_exit(place, 0, "synth", "--alpha", "0.1", "--gamma", "1.4", "--length", "0.5mm",
                                         "--points", "1000", "--seed", "7", "-o", "a.csv");
    assert_string_equal(process.out, "");
    process =
        expect_exit(place, 0, "synth", "--alpha=0.1", "--gamma=1.4", "--length=500um", "--points=1000", "--seed=7");
    directory_holds(place, "a.csv", process.out);
    json_t *json = process_json(expect_exit(place, 0, "inspect", "--json", "a.csv"));
    assert_near(json_number_at(json, "0.points"), 1000, 0);
    assert_near(json_number_at(json, "0.spacing_m"), 0.5e-6, 1e-9);
    assert_near(json_number_at(json, "0.gamma"), 1.4, 0.05);
    run_to_exit(place, 0, "synth", "--rq", "5um", "--points", "500", "--lambda-s", "8um", "-o", "b.csv");
    json = process_json(expect_exit(place, 0, "inspect", "--json", "b.csv"));
    assert_near(json_number_at(json, "0.rq_m"), 5e-6, 1e-5);
}

/* A map is read back with its size, Sq and spacing; it does not close, and its rows have the slope of a law of 1.5. */
TEST_IN_WORKSPACE(test_synth_of_a_map)
{
    json_t *found[2];
    for (int k = 0; k < 2; k++) {
        run_to_exit(place, 0, "synth", "--map", "-n", "128", "--length", "0.256mm", "--rq", k ? "0.6um" : "0.3um", "-s",
                    "16um", "-o", "a.sdf");
        found[k] = process_json(expect_exit(place, 0, "inspect", "--json", "a.sdf"));
    }
    assert_string_equal(json_text_at(found[0], "0.format"), "sdf");
    assert_near(json_number_at(found[0], "0.points"), 128 * 128, 0);
    assert_near(json_number_at(found[0], "0.dx_m"), 2e-6, 1e-12);
    assert_near(json_number_at(found[0], "0.sq_m"), 0.3e-6, 0.05); /* about its mean, with its plane */
    assert_near(json_number_at(found[1], "0.sdq"), 2 * json_number_at(found[0], "0.sdq"), 1e-3);
    expect_output(expect_exit(place, 2, "synth", "--map", "-n", "5000"), "");
}

TEST_IN_WORKSPACE(test_synth_refuses)
{
    static const struct {
        const char *option, *value, *message;
        size_t lines;
    } wrong[] = {
        {"--points", "4", "--points must be a whole number from 8 to 100000000, not '4'", 3},
        {"--points", "10.5", "--points must be a whole number", 3},
        {"--points", "many", "not 'many'", 3},
        {"--seed", "1.5", "--seed must be a whole number", 3},
        {"--seed", "-1", "--seed must be a whole number", 3},
        {"--length", "0", "--length must be a length such as 0.31mm, not '0'", 3},
        {"--length", "1parsec", "--length must be a length such as 0.31mm, not '1parsec'", 3},
        {"--gamma", "nan", "--gamma must be a number from -1000 to 1000, not 'nan'", 3},
        {"--alpha", "0", "--alpha must be a number from 1e-300 to 1e+300, not '0'", 3},
        {"--scatter", "3", "--scatter must be a number from 0 to 2, not '3'", 3},
        {"--alpha", "1e300", "Rq would be above 1e+30 m", 1}, /* what is written can be read again */
        {"--gamma", "-300", "Rq would be above 1e+30 m", 1},
        {"--rq", "1e200m", "Rq would be above 1e+30 m", 1},
        {"--length", "1e300m", "--length must be up to 1e+30 m", 1},
        {"--length", "1e-300m", "--length must be up to 1e+30 m", 1},
        {"--bogus", "1", "unrecognized option '--bogus'", 3},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        expect_failure(place, 2, wrong[i].lines, wrong[i].message, "synth", wrong[i].option, wrong[i].value);
    expect_failure(place, 2, 3, "Too many arguments", "synth", "file.csv");
    expect_failure(place, 4, 1, "cannot write 'nowhere/a.csv': No such file", "synth", "-o", "nowhere/a.csv");
}
