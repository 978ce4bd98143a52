/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Targets and limits: what the program writes, its exit status, and nothing of them where none is asked. */
#include "cli/process.h"
#include "contact/model.h"

#define SCENE "material: tin\nnominal_area: 1 mm2\nload: {from: 1e-7, to: 1e-2, points: 31}\n"
#define JOINT                                                                                                          \
    "material: tin\nnominal_area: 1 mm2\nfilm: 1e-12 ohm m2\ncurrent: 5 A\n"                                           \
    "gap: {gas: air, pressure: 1 atm}\nmodels: [corrected-persson, statistical, cmy]\n"

/** Runs a scene. */
static struct process run_scene(const char *place, int status, const char *text, const char *check)
{
    workspace_write(place, "in/scene.yaml", text);
    return check ? expect_exit(place, status, "report", "in", "-o", "out", "--no-cost", check)
                 : expect_exit(place, status, "report", "in", "-o", "out", "--no-cost");
}

TEST_IN_WORKSPACE(targets_are_answered)
{
    workspace_scans(place, "in", 2, 300, 1);
    struct process run = run_scene(place, 0, SCENE "targets: [{ecr: 0.1 mohm}, {area: 5 %}]\n", NULL);
    expect_parts(run.out, "To reach 0.1\u00a0mΩ, a needs ", "\n- A/Aₙ 5\u00a0% needs ", " on ");
    expect_in_file(place, "out/report.md", "\n\n**To reach 0.1\u00a0mΩ, *a* needs ",
                   "| surface | force for 0.1\u00a0mΩ (", "\n- A/Aₙ 5\u00a0% needs ");
    expect_in_file(place, "out/results.json", "\"answers\": [");
    expect_not_in_file(place, "out/results.json", "\"limits\"");
    struct table table = workspace_table(place, "out/data/answers.csv");
    size_t intervals = 0;
    for (size_t i = 0; i < table.rows; i++) { /* force = P/(A_n E') times E' times 1 mm², of all models alike */
        double load = table_number(&table, i, "load_over_AnEp");
        if (!*table_text(&table, i, "load_N"))
            continue;
        assert_near(table_number(&table, i, "load_N") / load,
                    table_number(&table, 0, "load_N") / table_number(&table, 0, "load_over_AnEp"), 1e-14);
        if (!*table_text(&table, i, "low") || !*table_text(&table, i, "high"))
            continue;
        assert_true(table_number(&table, i, "low") <= load && load <= table_number(&table, i, "high"));
        intervals++;
    }
    assert_true(table.rows >= 24 && intervals > 0); /* of the leading model, by simulated records */
}

TEST_IN_WORKSPACE(a_missed_limit_ends_with_5)
{
    workspace_scans(place, "in", 2, 300, 1);
    static const char missed[] =
        SCENE "operating_load: 10 N\nlimits: {conductance: {least: 1e12 W/m2/K}, area: {least: 1e-9}}\n";
    struct process run = run_scene(place, 5, missed, "--check");
    expect_parts(run.err,
                 "surface 'a' misses the limit h ≥ 1e+12 W/m2/K: ", "surface 'b' misses the limit h ≥ 1e+12 W/m2/K: ");
    expect_no_part(run.err, "A/Aₙ");
    expect_part(run.out, "  missed       met\n");
    expect_in_file(place, "out/report.md", "| ✗ missed | ✓ met |");
    run = run_scene(place, 0, missed, NULL); /* nobody asked for the check */
    expect_no_part(run.err, "misses");
    workspace_write(place, "in/c.csv", "x [um],z [um]\n0,1\n1,two\n");
    run = run_scene(place, 5, missed, "--check"); /* before 1, of a refused scan */
    expect_part(run.err, "refused");
    run_scene(place, 1, SCENE "limits: {area: {least: 1e-9}}\n", "--check");
    run = run_scene(place, 5, /* where no metal touches, at any load */
                    "material: copper\nmodels: [corrected-persson]\nnominal_area: 1 mm2\noperating_load: 1 N\n"
                    "gap: {filler: pad, bond_line: 500 um}\nlimits: {ecr: {most: 1 mohm}}\n",
                    "--check");
    expect_part(run.err, "surface 'a' misses the limit ECR ≤ 1 mohm\n");
}

/* One scan gives a wide interval of ECR: a limit within it is undecided (status 6), above it met (0), below it missed
 * (5, also beside an undecided one). data/limits.csv, results.json and the first page use the same word. */
TEST_IN_WORKSPACE(an_undecided_limit_ends_with_6)
{
    static const struct {
        double least, most;
        int status;
        const char *verdicts[2];
    } cases[] = {{0, 1, 6, {NULL, "undecided"}},
                 {0, 10, 0, {NULL, "met"}},
                 {0, 0.1, 5, {NULL, "missed"}},
                 {0.1, 1.2, 6, {"met", "undecided"}},
                 {10, 1.2, 5, {"missed", "undecided"}}};
    workspace_scan(place, "in/a.csv", 300, 1);
    run_scene(place, 0, SCENE "operating_load: 10 N\nlimits: {ecr: {most: 1 mohm}}\n", NULL);
    struct table table = workspace_table(place, "out/data/limits.csv");
    const double ohm = table_number(&table, 0, "value") / 1e-6;
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        const char *least = cases[c].least > 0 ? filled("least: %.9g ohm, ", cases[c].least * ohm) : "";
        struct process run = run_scene(
            place, cases[c].status,
            filled(SCENE "operating_load: 10 N\nlimits: {ecr: {%smost: %.9g ohm}, conductance: {least: 1 W/m2/K}}\n",
                   least, cases[c].most * ohm),
            "--check");
        table = workspace_table(place, "out/data/limits.csv");
        size_t row = cases[c].least > 0;
        for (size_t i = 0; i <= row; i++) { /* least, then most; the numbers are per area */
            const char *verdict = cases[c].verdicts[row ? i : 1];
            bool is_most = i == row;
            assert_string_equal(table_text(&table, i, "surface"), "a");
            assert_string_equal(table_text(&table, i, "quantity"), "ecr_ohm_m2");
            assert_string_equal(table_text(&table, i, "verdict"), verdict);
            assert_string_equal(table_text(&table, i, is_most ? "least" : "most"), "");
            assert_near(table_number(&table, i, is_most ? "most" : "least"),
                        1e-6 * ohm * (is_most ? cases[c].most : cases[c].least), 1e-8);
            assert_near(table_number(&table, i, "value"), 1e-6 * ohm, 1e-12);
            const double low = table_number(&table, i, "low") / (1e-6 * ohm),
                         high = table_number(&table, i, "high") / (1e-6 * ohm);
            assert_true(low > 0.1 && low < 1 && high > 1.2 && high < 10);
            assert_string_equal(
                json_text_at(workspace_json(place, "out/results.json"), filled("limits.%zu.verdict", i)), verdict);
            expect_in_file(place, "out/report.md", verdict);
        }
        assert_string_equal(table_text(&table, row + 1, "quantity"), "tcr_K_m2_per_W"); /* at least so much conducts */
        assert_near(table_number(&table, row + 1, "most"), 1, 1e-12);
        assert_string_equal(table_text(&table, row + 1, "verdict"), "met");
        const char *said = "surface 'a' leaves undecided the limit ECR ≤ ";
        if (strcmp(cases[c].verdicts[1], "undecided") == 0)
            expect_parts(run.err, said, " (95 % ");
        else
            expect_no_part(run.err, "undecided");
    }
}

/* Above the hardness there is no value, so a limit is not met. */
TEST_IN_WORKSPACE(a_limit_without_a_value_is_not_met)
{
    workspace_scan(place, "in/a.csv", 300, 1);
    struct process run = run_scene(place, 6,
                                   "material: tin\nmodels: [corrected-persson]\nhardness: 1 MPa\nload: {from: 1e-7, "
                                   "to: 1e-2, points: 9}\noperating_load: 1e-3\nlimits: {gap: {most: 1e-9}}\n",
                                   "--check");
    struct table table = workspace_table(place, "out/data/limits.csv");
    assert_string_equal(table_text(&table, 0, "verdict"), "no value");
    assert_string_equal(table_text(&table, 0, "value"), "");
    expect_part(run.out, " is not known on a.");
    expect_part(run.err, "surface 'a' leaves undecided the limit gap ≤ 1e-09 m: no value\n");
}

TEST_IN_WORKSPACE(a_check_of_nothing_is_refused)
{
    workspace_scans(place, "in", 2, 300, 1);
    workspace_write(place, "in/scene.yaml", SCENE);
    expect_failure(place, 2, 1, "--check: the scene has no 'limits' to check", "report", "in", "-o", "out", "--check");
    assert_false(workspace_has(place, "out"));
    struct process run = run_scene(place, 0, SCENE, NULL); /* nor is there a trace of what was not asked */
    assert_false(workspace_has(place, "out/data/answers.csv"));
    expect_not_in_file(place, "out/results.json", "\"answers\"", "\"limits\"");
    expect_no_part(run.out, "needs");
}

/** The first table has load and interval of a target as answers.csv has them, rounded and in the loads' unit. */
TEST_IN_WORKSPACE(the_first_table_is_of_the_data)
{
    workspace_scans(place, "in", 3, 300, 1);
    run_scene(place, 0,
              "material: tin\nnominal_area: 1 mm2\nload: {from: 0.01 N, to: 1 kN, points: 31}\n"
              "effects: [plasticity, electrical, uncertainty]\ntargets: [{ecr: 0.1 mohm}]\n"
              "surfaces: [{name: a, file: [a.csv, b.csv]}, {name: c, file: c.csv}]\n",
              NULL);
    json_t *view = workspace_json(place, "out/view.json"), *rows = json_object_get(view, "rows"), *row;
    const char *leading = json_text_at(view, "leading");
    size_t compared = 0, k, m = 0;
    while (m < model_count && strcmp(model_rows[m]->label, leading) != 0)
        m++;
    assert_true(m < model_count);
    struct table table = workspace_table(place, "out/data/answers.csv");
    json_array_foreach (rows, k, row)
        for (size_t i = 0; i < table.rows; i++) {
            if (strcmp(table_text(&table, i, "model"), model_rows[m]->name) != 0 ||
                strcmp(table_text(&table, i, "surface"), json_text_at(row, "surface")) != 0)
                continue;
            double scale = table_number(&table, i, "load_N") / table_number(&table, i, "load_over_AnEp");
            char *dash; /* plain numbers at these loads */
            double load = strtod(json_text_at(row, "load.value"), NULL),
                   low = strtod(json_text_at(row, "load.interval"), &dash), high = strtod(dash + strlen("–"), NULL);
            assert_near(load, table_number(&table, i, "load_N"), 6e-2); /* two digits, as the interval is wide */
            assert_near(low, scale * table_number(&table, i, "low"), 6e-2);
            assert_near(high, scale * table_number(&table, i, "high"), 6e-2);
            compared++;
        }
    assert_int_equal(compared, 2);
}

/** The key of every load in results.json names its unit; returns how many there are. */
static size_t check_load_keys(const json_t *json)
{
    static const char *const other[] = {"area_load_slope",
                                        "largest_load_share_beyond_fit",
                                        "largest_load_share_clamped_at_radius",
                                        "load_unit",
                                        "at_middle_load",
                                        "unloading"};
    const char *key;
    json_t *value;
    size_t index, found = 0;
    json_array_foreach ((json_t *)json, index, value)
        found += check_load_keys(value);
    json_object_foreach ((json_t *)json, key, value) {
        bool is_load = strstr(key, "load");
        for (size_t k = 0; k < sizeof other / sizeof *other; k++)
            is_load = is_load && strcmp(key, other[k]) != 0;
        if (is_load && !strstr(key, "_over_AnEp") && strcmp(key, "load_N") != 0)
            fail_msg("what is '%s' in?", key);
        found += is_load + check_load_keys(value);
    }
    return found;
}

/** ... also where the scene has its loads in newtons. */
TEST_IN_WORKSPACE(loads_say_what_they_are_in)
{
    workspace_scans(place, "in", 2, 300, 1);
    run_scene(place, 0,
              "material: tin\nnominal_area: 1 mm2\nload: {from: 0.01 N, to: 100 N, points: 9}\n"
              "targets: [{ecr: 0.1 mohm}]\n",
              NULL);
    json_t *root = workspace_json(place, "out/results.json"), *answers = json_object_get(root, "answers");
    struct table table = workspace_table(place, "out/data/answers.csv");
    size_t intervals = 0;
    assert_true(check_load_keys(root) > 50);
    assert_true(table.rows > 0 && json_array_size(answers) == table.rows);
    for (size_t i = 0; i < table.rows; i++) {
        const json_t *answer = json_array_get(answers, i), *ends = json_object_get(answer, "load_over_AnEp_95");
        assert_int_equal(json_array_size(ends), 2);
        assert_null(json_object_get(answer, "interval_95"));
        for (size_t side = 0; side < 2; side++) {
            const char *cell = table_text(&table, i, side ? "high" : "low");
            assert_int_equal(json_is_null(json_array_get(ends, side)), *cell == '\0');
            assert_true(!*cell || json_number_value(json_array_get(ends, side)) == strtod(cell, NULL));
            intervals += *cell != '\0';
        }
        const char *note = table_text(&table, i, "note"), *limit = strstr(note, "not reached up to ");
        assert_true(!limit || strstr(limit, "up to P/(A_n E') = "));
        assert_string_equal(json_string_value(json_object_get(answer, "note")), note);
    }
    assert_true(intervals > 0);
}

/** Does that model's curve in out/ pass the value between the rows on both sides of that load? */
static bool is_met_at(const char *place, const char *model, double load, const char *column, double value)
{
    struct table table = workspace_table(place, "out/data/contact.csv");
    bool met = false;
    for (size_t i = 1; i < table.rows; i++) {
        double before = table_number(&table, i - 1, column), after = table_number(&table, i, column);
        met |= !strcmp(table_text(&table, i - 1, "model"), model) && !strcmp(table_text(&table, i, "model"), model) &&
               table_number(&table, i - 1, "load_over_AnEp") <= load &&
               load <= table_number(&table, i, "load_over_AnEp") && (before - value) * (after - value) <= 0;
    }
    return met;
}

/** With a film, a gas and a current, targets are of the whole joint, whose curve passes them at the answered load. */
TEST_IN_WORKSPACE(targets_of_a_joint)
{
    static const struct {
        const char *target, *column;
        double value;
    } asked[] = {{"ecr 0.2 mohm", "joint_ecr_ohm_m2", 0.2e-9},
                 {"conductance 200000 W/m2/K", "joint_W_per_m2K", 2e5},
                 {"temperature 30 degC", "contact_temperature_K", 303.15}};
    size_t answered = 0, intervals[3] = {0};
    workspace_scan(place, "in/a.csv", 300, 1);
    struct process run =
        run_scene(place, 0,
                  JOINT "load: {from: 1e-7, to: 1e-2, points: 31}\n"
                        "targets: [{ecr: 0.2 mohm}, {conductance: 2e5 W/m2/K}, {temperature: 30 degC}]\n",
                  NULL);
    expect_parts(run.out, "To reach 0.2\u00a0mΩ, a needs ", "\n- T_max 30\u00a0°C needs ");
    struct table table = workspace_table(place, "out/data/answers.csv");
    for (size_t i = 0; i < table.rows; i++)
        for (size_t a = 0; a < sizeof asked / sizeof *asked; a++)
            if (!strcmp(table_text(&table, i, "target"), asked[a].target) && !*table_text(&table, i, "note")) {
                double load = table_number(&table, i, "load_over_AnEp");
                assert_true(is_met_at(place, table_text(&table, i, "model"), load, asked[a].column, asked[a].value));
                answered++;
                if (!*table_text(&table, i, "low") || !*table_text(&table, i, "high"))
                    continue;
                assert_true(table_number(&table, i, "low") < load && load < table_number(&table, i, "high"));
                intervals[a]++;
            }
    assert_true(answered >= 8 && intervals[0] > 0 && intervals[1] > 0);
}
