/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `compare`: reports that the program made, and results.json files made up so that tests can be worked out by hand. */
#include "cli/process.h"
#include "hard_case.h"

HARD_CASES("Reports that others made")

/** The number at a path such as "inputs.0.key", where `expected` stands as JSON (NULL: anything). */
static double at(const json_t *view, const char *path, const char *expected)
{
    view = json_at(view, path);
    OWNED(memory_free) char *dumped = json_dumps(view, JSON_ENCODE_ANY);
    if (expected && strcmp(dumped ? dumped : "", expected) != 0)
        fail_msg("%s is %s", path, dumped);
    return json_number_value(view);
}

/** The view. Text, of at most 80 columns, and Markdown hold `part` and no control characters. */
static json_t *compare(const char *place, const char *a, const char *b, const char *part)
{
    for (int markdown = 0; markdown < 2; markdown++) {
        struct process process = expect_exit(place, 0, "compare", a, b, markdown ? "--markdown" : NULL);
        process_expect_clean(process.out, process.out_length, "compare", false);
        expect_part(process.out, part);
        if (!markdown)
            expect_narrow(process.out);
    }
    return process_json(expect_exit(place, 0, "compare", a, b, "--json"));
}

/** Makes the report of two surfaces of three scans each, those of a from `seed` on. */
static void make_report(const char *place, const char *out, unsigned seed, const char *more)
{
    for (unsigned i = 0; i < 6; i++)
        workspace_scan(place, filled("d/%c%u.csv", i < 3 ? 'a' : 'b', i), 200, i < 3 ? seed + i : 100 + i);
    workspace_write(
        place, "d/scene.yaml",
        filled("models: [corrected-persson]\nnominal_area: 1 mm2\nload: {from: 1 N, to: 20 N, points: 9}\n"
               "effects: [plasticity, separation, electrical, uncertainty, film]\nfilm: 1e-12\nbaseline: b\n"
               "surfaces: [{name: a, file: 'a*.csv'}, {name: b, file: 'b*.csv'}]\n%s\n",
               more));
    run_to_exit(place, 0, "report", "d", "-o", out, "--no-cost", "--brief");
}

TEST_IN_WORKSPACE(finished_reports)
{
    make_report(place, "one", 1, "material: tin\noperating_load: 2 N");
    make_report(place, "hard", 1, "material: tin\noperating_load: 2 N\nhardness: 60 MPa");
    make_report(place, "scans", 11, "material: tin\noperating_load: 2 N");
    make_report(place, "load", 1, "material: copper\noperating_load: 5 N");
    make_report(place, "copper", 1, "material: copper\noperating_load: 2 N");
    json_t *view = compare(place, "one", "one", "Nothing differs.");
    at(view, "surfaces.1.numbers.3.lines.1.same", "true");
    view = compare(place, "one", "hard", "same scans");
    at(view, "inputs.0.key", "\"scene.hardness_Pa\"");
    at(view, "inputs.0.values.1.value", "\"60000000.0\"");
    at(view, "inputs.1", "");
    at(view, "surfaces.0.numbers.0.lines.1.same_scans", "true");
    json_t *results = workspace_json(place, "hard/results.json");
    assert_near(at(view, "surfaces.0.numbers.0.lines.1.value", NULL),
                at(results, "surfaces.0.models.corrected-persson-plastic.operating.area_ratio", NULL), 1e-15);
    view = compare(place, "one", "copper", "material"); /* the loads are the same newtons */
    char *inputs = test_owns(json_dumps(json_object_get(view, "inputs"), 0), free);
    expect_part(inputs, "scene.material.E_Pa");
    expect_no_part(inputs, "loads");
    view = compare(place, "one", "scans", "(p = ");
    at(view, "inputs.0.key", "\"a.sha256\"");
    at(view, "inputs.1", "");
    at(view, "surfaces.1.numbers.2.lines.1.same", "true");
    /* differences of a surface's record come behind the models' numbers; b, which is the same, has none */
    results = workspace_json(place, "scans/results.json");
    size_t told = 0;
    while (strcmp(json_text_at(view, filled("surfaces.0.numbers.%zu.quantity", told)), "rq_m") != 0)
        told++;
    const json_t *rq = json_at(view, filled("surfaces.0.numbers.%zu", told));
    at(rq, "unit", "\"µm\"");
    at(rq, "lines.1.undecided", "true");
    assert_near(at(rq, "lines.1.value", NULL), at(results, "surfaces.0.rq_m", NULL), 1e-15);
    assert_int_equal(json_array_size(json_at(view, "surfaces.1.numbers")), told);
    view = compare(place, "one", "load", "scene.loads_N");
    /* with another load and E' the value is interpolated in contact.csv at 2 MPa; b with hardness comes last there */
    view = compare(place, "one", "load", "Operating loads differ");
    struct table table = workspace_table(place, "load/data/contact.csv");
    double expected = 0;
    for (size_t row = 2; row < table.rows; row++) {
        double p = table_number(&table, row - 1, "pressure_Pa"),
               y = table_number(&table, row - 1, "separation_over_sigma");
        double share = log(2e6 / p) / log(table_number(&table, row, "pressure_Pa") / p);
        if (share > 0 && share < 1)
            expected = y * pow(table_number(&table, row, "separation_over_sigma") / y, share);
    }
    assert_near(at(view, "surfaces.1.numbers.1.lines.1.value", NULL), expected, 1e-12);
    at(view, "surfaces.1.numbers.1.lines.1.low_95", "null");
}

/* What was measured, targets and limits went in as well; the numbers are the models' all the same, and that is said. */
TEST_IN_WORKSPACE(measured_files_targets_and_limits_went_in)
{
    static const char own[] = "material: tin\noperating_load: 2 N\n%s",
                      given[] = "measured: {file: ../%s, quantity: ecr}\n"
                                "targets: [{ecr: 1 mohm}, {ecr: 2 mohm}]\nlimits: {ecr: {most: %s}}";
    workspace_write(place, "m1.txt", "load_N,resistance_mohm\n1,0.9\n2,0.5\n4,0.26\n8,0.14\n");
    workspace_write(place, "m2.txt", "load_N,resistance_mohm\n1,0.9\n2,0.5\n4,0.26\n8,0.15\n");
    make_report(place, "none", 1, filled(own, ""));
    make_report(place, "one", 1, filled(own, filled(given, "m1.txt", "3 mohm")));
    make_report(place, "same", 1, filled(own, filled(given, "m1.txt", "3 mohm")));
    make_report(place, "other", 1, filled(own, filled(given, "m2.txt", "4 mohm")));
    static const char said[] = "All numbers are the models'";
    json_t *view = compare(place, "one", "same", said);
    at(view, "inputs", "");
    at(view, "nothing_differs", "true");
    view = compare(place, "one", "other", said);
    char *inputs = test_owns(json_dumps(json_object_get(view, "inputs"), 0), free);
    expect_parts(inputs, "\"scene.limits.ecr most 3 mohm\"", "\"scene.limits.ecr most 4 mohm\"", "\"b.measured.files\"",
                 "m2.txt", "\"b.measured.values\"");
    expect_no_part(inputs, "targets");
    view = compare(place, "none", "one", said);
    inputs = test_owns(json_dumps(json_object_get(view, "inputs"), 0), free);
    expect_parts(inputs, "\"scene.targets.ecr 2 mohm\"", "\"scene.limits.ecr most 3 mohm\"", "\"b.measured.files\"");
    expect_no_part(expect_exit(place, 0, "compare", "none", "none").out, said);
    make_report(place, "alone", 1, filled(own, "measured: {file: ../m1.txt, quantity: ecr}")); /* no target of it */
    (void)compare(place, "none", "alone", said);
    make_report(place, "beside", 1, filled(own, "measured: {file: ../m1.txt, quantity: ecr, carry: false}"));
    expect_no_part(expect_exit(place, 0, "compare", "none", "beside").out, said);
}

/** A report of one surface: ECR 2e-9 `factor`, from 1e-9 to 4e-9 of it, and with a film of 1e-9; `known` of both. */
static void make_results(const char *place, const char *out, const char *name, double factor, const char *known)
{
    char *text = lasting(
        "{'program': 'roughcontact', 'version': '1', 'leading': 'm', 'scene': {'tolerance': 1e-6, 'baseline': "
        "'%s'}, 'surfaces': [{'surface': '%s', 'sha256': '%s', 'models': {'m': {'operating': {'load_over_AnEp': "
        "1e-4, 'ecr_ohm_m2': %.17g, 'joint_ecr_ohm_m2': %.17g}, 'at_middle_load': {'ecr_ohm_m2': {'mean_95': "
        "[%.17g, %.17g], %s}, 'joint_ecr_ohm_m2': {'mean_95': [%.17g, %.17g], %s}}}}}]}",
        name, name, out, 2e-9 * factor, 2e-9 * factor + 1e-9, 1e-9 * factor, 4e-9 * factor, known, 1e-9 * factor + 1e-9,
        4e-9 * factor + 1e-9, known);
    for (char *quote; (quote = strchr(text, '\''));)
        *quote = '"';
    workspace_write(place, filled("%s/results.json", out), text);
}

/* t = ln(ratio)/s, s² = s_a² + s_b², with s⁴/(s_a⁴/f_a + s_b⁴/f_b) degrees of freedom: p by Simpson's rule on Student's
 * density. */
TEST_IN_WORKSPACE(tests_are_those_of_the_textbook)
{
#define KNOWN(s, f) "'geometric': true, 'standard_error': " s ", 'degrees_of_freedom': " f
    static const struct {
        const char *verdict, *a, *b;
        double ratio, p; /* 0: none */
    } cases[] = {
        {"significant", KNOWN("0.1", "2"), KNOWN("0.2", "4"), 2, 0.023359912432827},
        {"significant", KNOWN("0.2", "4"), KNOWN("0.1", "2"), 0.5, 0.023359912432827},
        {"not_significant", KNOWN("0.3", "1"), KNOWN("0.3", "1"), 3, 0.122358750204021},
        {"undecided", KNOWN("0.1", "0"), KNOWN("0.2", "0"), 3, 0},
        {"undecided", KNOWN("0.1", "2"), "'geometric': true", 3, 0},
        {"undecided", KNOWN("0.1", "-1"), KNOWN("0.1", "1e-9"), 3, 0},
        {"significant", KNOWN("0.2", "1"), KNOWN("0.2", "1"), 4, 0.039196233021664},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char verdict[64] = "surfaces.0.numbers.0.lines.1.";
        make_results(place, "a", "s", 1, cases[i].a);
        make_results(place, "b", "s", cases[i].ratio, cases[i].b);
        json_t *view = compare(place, "a", "b", "ECR");
        at(view, strcat(verdict, cases[i].verdict), "true");
        assert_near(at(view, "surfaces.0.numbers.0.lines.1.ratio", NULL), cases[i].ratio, 1e-12);
        assert_near(at(view, "surfaces.0.numbers.0.lines.1.p", cases[i].p > 0 ? NULL : ""), cases[i].p, 1e-9);
        if (cases[i].ratio == 4) {
            /* with the film 9 and 3 by its own errors */
            assert_near(at(view, "surfaces.0.numbers.1.lines.1.high_95", NULL), 17e-9, 1e-12);
            assert_near(at(view, "surfaces.0.numbers.1.lines.1.p", NULL), 0.060345272708532, 1e-9);
        }
    }
}

TEST_IN_WORKSPACE(what_reports_say_is_hostile)
{
    static const char *const damaged[][2] = {
        {"{\n\"program\": \"roughcontact\",\n", "damaged, or not of roughcontact (line 3)"},
        {"{\"program\": \"\\u001b\"}", "damaged, or not of roughcontact"},
        {"{\"program\": \"roughcontact\", \"leading\": \"m\", \"scene\": [], \"surfaces\": [1, {\"surface\": \"s\", "
         "\"models\": "
         "{\"m\": {\"operating\": {\"load_over_AnEp\": \"1\", \"ecr_ohm_m2\": -1}, \"ecr_ohm_m2\": 1}}}]}",
         "nothing to compare"},
    };
    make_results(place, "a", "\\u001b[31m|\\u202e\\t*x", 1, "'\\u001b]0;x': 1");
    make_results(place, "b", "\\u001b[31m|\\u202e\\t*x", 2, "'': {'': []}");
    make_results(place, "c", "s", 2, "'x': 1");
    workspace_shell(place, "sed -i 's/\"1\"/\"\\\\u009b1;|\"/; s/baseline/\\\\n`b\\\\u001b/' b/results.json");
    compare(place, "a", "b", "x1b");
    expect_output(expect_exit(place, 0, "compare", "a", "b", "--markdown"), "[31m\\|");
    expect_output(expect_exit(place, 0, "compare", "a", "b", "c"), "in 1.\n- s has no partner in 2.\n");
    for (size_t i = 0; i < sizeof damaged / sizeof *damaged; i++) {
        workspace_write(place, "b/results.json", damaged[i][0]);
        struct process forged = process_run(place, "compare", "b", "c");
        hard_case("a results.json that is cut off, of no program, or has words where numbers belong",
                  "it is compared with zeros", "refused: damaged, or nothing to compare", "tables printed",
                  *forged.out != '\0', 0);
        expect_failure(place, 4, 1, damaged[i][1], "compare", "b", "c");
        expect_output(expect_exit(place, 4, "compare", "b", "c", "--json"), "\"error\": ");
    }
    /* small files that would be parsed to gigabytes; scenes of which every key differs */
    workspace_shell(place, "(printf '{\"x\": ['; yes '{},' | head -n 2000000; printf '0]}') > b/results.json");
    expect_failure(place, 4, 1, "; at most 10000000 values: ", "compare", "c", "b");
    struct process values = process_run(place, "compare", "c", "b");
    hard_case("a results.json of two million empty objects, 8 MB", "it is parsed to gigabytes",
              "counted before it is parsed: at most 10 000 000 values", "tables printed", *values.out != '\0', 0);
    for (int i = 0; i < 2; i++) {
        struct text *many = support_text();
        char *made = workspace_read(place, "c/results.json"), *inside = strstr(made, "\"tolerance\"");
        text_add_bytes(many, made, (size_t)(inside - made));
        for (int k = 0; k < 80000; k++)
            text_add(many, "\"k%d\": %d, ", k, k + i);
        text_add(many, "%s", inside);
        workspace_write(place, i ? "b/results.json" : "a/results.json", text_string(many));
    }
    expect_output(expect_exit(place, 0, "compare", "a", "b"), "- scene.k79999: 79999 in 1, 80000 in 2\n");
    workspace_shell(place, "rm b/results.json; mkfifo b/results.json");
    expect_failure(place, 4, 1, "b/results.json", "compare", "a", "b");
    expect_errors(expect_exit(place, 2, "compare", "a"), "give the OUT of two reports or more");
}

/** The value at a path such as "ranking.lines.0.letters", as JSON. */
#define LINE(i, key) filled("ranking.lines.%d." key, i)

/* Ten folders of one surface, each with scatter s = 0.2: some of the 45 pairs differ by more than 1.96 s sqrt(2), but
 * not by what Holm's test asks of 45. A surface 8 times as bad differs from all. */
TEST_IN_WORKSPACE(ten_folders_of_one_surface_are_not_ranked_apart)
{
    static const double z[10] = {-1.62, -1.04, -0.68, -0.39, -0.13, 0.13, 0.39, 0.68, 1.04, 1.62};
    for (int i = 0; i < 10; i++) {
        int shuffled = 3 * i % 10;
        make_results(place, filled("out/%c", 'a' + i), "pin", exp(0.2 * z[shuffled]), KNOWN("0.2", "20"));
    }
    json_t *view = process_json(run_program(place, "sh", "-c", PROGRAM " compare --json out/*"));
    for (int i = 0; i < 10; i++) {
        at(view, LINE(i, "letters"), "\"a\"");
        assert_near(at(view, LINE(i, "value"), NULL), 2e-9 * exp(0.2 * z[i]) + 1e-9, 1e-12); /* the least first */
        at(view, LINE(i, "worse"), i ? "false" : "");
    }
    at(view, LINE(1, "p"), "1.0");
    double two_alone = at(view, LINE(9, "p"), NULL) / 45; /* Holm's factor of the largest difference */
    assert_true(two_alone < 0.05 && at(view, LINE(9, "p"), NULL) > 0.05);
    at(view, "surfaces.0.surface", "\"pin\""); /* few enough to stand side by side too */

    make_results(place, "out/bad", "pin", 8, KNOWN("0.2", "20"));
    make_results(place, "out/other", "nut", 1.0001, KNOWN("0.2", "0"));
    view = process_json(run_program(place, "sh", "-c", PROGRAM " compare --json out/*"));
    at(view, LINE(11, "path"), "\"out/bad\"");
    at(view, LINE(11, "letters"), "\"b\"");
    at(view, LINE(11, "worse"), "true");
    at(view, LINE(5, "path"), "\"out/other\""); /* in its place by its value, untested */
    at(view, LINE(5, "letters"), "\"\"");
    at(view, LINE(5, "p"), "");
    at(view, "ranking.untested", "1");
}

/* The film is part of what a contact resists: where one of two reports has one, they are ranked and compared with it,
 * the other by its contact alone; where none has, nothing speaks of a joint. */
TEST_IN_WORKSPACE(a_film_counts)
{
    make_results(place, "film", "s", 1, KNOWN("0.1", "20"));
    make_results(place, "bare", "s", 1.2, KNOWN("0.1", "20"));
    workspace_shell(place, "sed -i 's/\"joint_ecr_ohm_m2\"/\"none\"/g' bare/results.json");
    json_t *view = compare(place, "film", "bare", "joint ECR");
    at(view, LINE(0, "path"), "\"bare\"");
    assert_near(at(view, LINE(0, "value"), NULL), 2.4e-9, 1e-12);
    assert_near(at(view, LINE(1, "value"), NULL), 3e-9, 1e-12);
    assert_near(at(view, "surfaces.0.numbers.0.lines.1.ratio", NULL), 1.2, 1e-12);
    assert_near(at(view, "surfaces.0.numbers.1.lines.1.ratio", NULL), 0.8, 1e-12);
    view = compare(place, "bare", "bare", "ECR");
    at(view, "ranking.symbol", "\"ECR\"");
    at(view, "surfaces.0.numbers.1", "");
}

/* So is the shape: a report of flat parts is compared with one of others by what the whole contact resists. */
TEST_IN_WORKSPACE(a_shape_counts)
{
    make_results(place, "shaped", "s", 1, KNOWN("0.1", "20"));
    make_results(place, "flat", "s", 1.2, KNOWN("0.1", "20"));
    workspace_shell(place, "sed -i 's/\"joint_ecr_ohm_m2\"/\"shape_ecr_ohm_m2\"/g' shaped/results.json");
    workspace_shell(place, "sed -i 's/\"joint_ecr_ohm_m2\"/\"none\"/g' flat/results.json");
    for (int first = 0; first < 2; first++) {
        json_t *view = compare(place, first ? "flat" : "shaped", first ? "shaped" : "flat", "ECR with shape");
        at(view, LINE(0, "path"), "\"flat\"");
        assert_near(at(view, LINE(1, "value"), NULL), 3e-9, 1e-12);
        assert_near(at(view, "surfaces.0.numbers.1.lines.1.ratio", NULL), first ? 1.25 : 0.8, 1e-12);
        at(view, "surfaces.0.numbers.2", "");
    }
}

/** A report of one surface 's' whose leading model is called so. */
static void make_led(const char *place, const char *out, const char *leading, double factor)
{
    make_results(place, out, "s", factor, KNOWN("0.1", "20"));
    workspace_shell(place, filled("sed -i 's/\"m\"/\"%s\"/g' %s/results.json", leading, out));
}

/* Strips with hardness are compared with the elastic strips of a report without a hardness: each page's own numbers.
 * For a report led by another model there is no number, and the comparison says so. */
TEST_IN_WORKSPACE(each_report_speaks_by_its_leading_model)
{
    make_led(place, "hard", "strip-plastic", 1);
    make_led(place, "elastic", "strip", 2);
    make_led(place, "gw", "gw", 3);
    json_t *view = compare(place, "hard", "elastic", "each report by the model");
    assert_near(at(view, "surfaces.0.numbers.0.lines.1.ratio", NULL), 2, 1e-12);
    at(view, LINE(1, "shown.ratio"), "\"1.67\""); /* of the worse to the best, with their film */
    assert_true(at(view, LINE(1, "low_95"), NULL) < at(view, LINE(1, "value"), NULL));
    at(view, LINE(0, "shown.ratio"), "\"1.00\"");
    at(view, "reports.0.label", "\"strip transfer with hardness\"");
    at(view, "models.1.label", "\"strip transfer\"");
    at(view, "without.0", "");
    expect_output(expect_exit(place, 0, "compare", "elastic", "gw", "hard"),
                  "No joint ECR by strip transfer, hence not ranked: s of report 2.\n");
    make_results(place, "other", "t", 1, KNOWN("0.1", "20"));
    workspace_shell(place, "sed -i 's/\"m\"/\"strip\"/g' other/results.json");
    expect_parts(expect_exit(place, 0, "compare", "elastic", "other").out, "- s has no partner in 2",
                 "- t has no partner in 1");
    view = process_json(expect_exit(place, 0, "compare", "elastic", "gw", "hard", "--json"));
    at(view, "ranking.lines.2", "");
    at(view, LINE(1, "report"), "1");
    expect_failure(place, 4, 1, "nothing to compare: no two surfaces have a number of 'gw'", "compare", "gw", "hard");
    make_led(place, "elastic", "strip-plastic", 2);
    struct process same = expect_exit(place, 0, "compare", "hard", "elastic");
    expect_part(same.out, "By strip transfer with hardness. Welch");
    expect_no_parts(same.out, "that leads it", "not ranked", "strip-plastic");
}

/* Two reports: what differs comes first; more than two: the ranking. */
TEST_IN_WORKSPACE(the_ranking_comes_first_of_more_than_two)
{
    for (int i = 0; i < 3; i++)
        make_led(place, (const char *const[]){"a", "b", "c"}[i], "strip", i + 1);
    const char *two = expect_exit(place, 0, "compare", "a", "b").out,
               *three = expect_exit(place, 0, "compare", "a", "b", "c", "--markdown").out;
    expect_parts(two, "Reports compared\n", "\nSide by side\n", "\nAll surfaces, the best first\n");
    assert_null(strchr(two, '#'));
    assert_true(strstr(two, "Side by side") < strstr(two, "All surfaces"));
    expect_parts(three, "# Reports compared\n", "\n## Side by side\n", "\n## All surfaces, the best first\n");
    assert_true(strstr(three, "Side by side") > strstr(three, "All surfaces"));
}

/** Sets keys of a report's scene. */
static void set_scene(const char *place, const char *out, const char *keys)
{
    workspace_shell(place, filled("sed -i 's|\"tolerance\": 1e-6|%s|' %s/results.json", keys, out));
}

/* Where fillers keep the metals apart nothing is ranked by the metals' resistance, and h_j stands side by side. */
TEST_IN_WORKSPACE(bond_lines_are_compared)
{
    workspace_scan(place, "d/a.csv", 200, 1);
    for (int mm = 1; mm <= 2; mm++) {
        workspace_write(place, "d/scene.yaml",
                        filled("models: [corrected-persson]\nmaterial: tin\noperating_load: 1 MPa\n"
                               "gap: {filler: pad, bond_line: %d mm}\n",
                               mm));
        run_to_exit(place, 0, "report", "d", "-o", mm == 1 ? "thin" : "thick", "--no-cost", "--brief");
    }
    json_t *view = compare(place, "thin", "thick", "h_j (W/(m²·K))");
    at(view, "ranking", "");
    at(view, "without", "");
}

/* Numbers whose errors overlap are the same, and so are inputs that differ in the eleventh digit. */
TEST_IN_WORKSPACE(rounding_is_no_difference)
{
    static const struct {
        double apart;
        const char *tolerance;
        bool same;
    } cases[] = {{1.5e-6, "1e-6", true}, {3e-6, "1e-6", false},  {-1.5e-6, "1e-6", true},
                 {1e-12, "1e-14", true}, {1e-8, "1e-14", false}, {0.1, "7", false},
                 {0.1, "null", false},   {1e-12, "null", true},  {1.5e-6, "1e-14", false}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        make_led(place, "a", "strip", 1);
        make_led(place, "b", "strip", 1 + cases[i].apart);
        for (int k = 0; k < 2; k++)
            set_scene(place, k ? "b" : "a",
                      filled("\"tolerance\": %s, \"hardness_Pa\": %s", cases[i].tolerance,
                             k ? "39760000.000000007" : "39760000.0"));
        json_t *view = process_json(expect_exit(place, 0, "compare", "a", "b", "--json"));
        at(view, "surfaces.0.numbers.0.lines.1.same", cases[i].same ? "true" : "");
        at(view, "inputs.0.key", "\"s.sha256\"");
        at(view, "inputs.1", "");
    }
}

/* Loads and resistances are in the first scene's units, of the whole contact where the nominal area is one. */
TEST_IN_WORKSPACE(numbers_are_in_the_units_of_the_scene)
{
    static const struct {
        const char *first, *second, *load, *unit, *value;
    } cases[] = {
        {"\"load_unit\": \"cN\", \"nominal_area_m2\": 2e-6, ", "\"nominal_area_m2\": 2e-6, ", "2000\u00a0cN", "mΩ",
         "1.50"},
        {"\"operating_load_unit\": \"bar\", \"nominal_area_m2\": 2e-8, ", "\"nominal_area_m2\": 2e-8, ", "100\u00a0bar",
         "mΩ", "150"},
        {"\"nominal_area_m2\": 2e-6, ", "\"nominal_area_m2\": 2e-6, ", "20.0\u00a0N", "mΩ", "1.50"},
        {"\"nominal_area_m2\": 2e-6, ", "\"nominal_area_m2\": 3e-6, ", "10.0\u00a0MPa", "mΩ·mm²", "3.00"},
        {"\"load_unit\": \"N\", ", "", "10.0\u00a0MPa", "mΩ·mm²", "3.00"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        make_led(place, "a", "strip", 1);
        make_led(place, "b", "strip", 2);
        static const char common[] = "\"effective_modulus_Pa\": 1e11, \"operating_load_over_AnEp\": 1e-4, ";
        set_scene(place, "a", filled("%s%s\"tolerance\": 1e-6", common, cases[i].first));
        set_scene(place, "b", filled("%s%s\"tolerance\": 1e-6", common, cases[i].second));
        json_t *view = compare(place, "a", "b", "");
        at(view, "load", filled("\"%s\"", cases[i].load));
        at(view, "ranking.unit", filled("\"%s\"", cases[i].unit));
        at(view, "ranking.lines.0.shown.value", filled("\"%s\"", cases[i].value));
        at(view, "surfaces.0.numbers.0.unit", filled("\"%s\"", cases[i].unit));
        assert_near(at(view, "ranking.lines.0.value", NULL), 3e-9, 1e-12); /* SI, per area, with the film */
    }
    /* the load is the baseline's, and so over the E' of its own material */
    workspace_shell(place, "sed -i 's|\"sha256\"|\"effective_modulus_Pa\": 2e11, &|' a/results.json b/results.json");
    at(compare(place, "a", "b", ""), "load", "\"20.0\u00a0MPa\"");
}

/* The ranking's test is that of a report: a surface of one scan is not held to scatter less than such do on average,
 * one of several scans is. */
TEST_IN_WORKSPACE(one_scan_alone_takes_the_usual_scatter)
{
    for (int scans = 1; scans <= 3; scans += 2) {
        const char *const s[] = {"0.05", "0.05", "0.5"};
        for (int i = 0; i < 3; i++)
            make_results(
                place, (const char *const[]){"a", "b", "c"}[i], "s", 1 + 0.5 * i,
                filled("'geometric': true, 'scans': %d, 'standard_error': %s, 'degrees_of_freedom': 4", scans, s[i]));
        json_t *view = process_json(expect_exit(place, 0, "compare", "a", "b", "c", "--json"));
        at(view, LINE(1, "worse"), scans > 1 ? "true" : "false");
    }
}

/* More reports than fit side by side are only ranked; beyond 100 without letters. */
TEST_IN_WORKSPACE(many_reports_make_one_table)
{
    for (int i = 0; i < 3; i++)
        make_results(place, filled("some/%d", i), filled("s%d", i), 1 + 0.5 * i, KNOWN("0.05", "20"));
    workspace_shell(place, "i=0; while [ $i -lt 201 ]; do cp -r some/$((i % 3)) out-$i; i=$((i + 1)); done");
    json_t *view = process_json(run_program(place, "sh", "-c", PROGRAM " compare --json out-*"));
    at(view, LINE(0, "surface"), "\"s0\"");
    at(view, LINE(200, "surface"), "\"s2\"");
    at(view, LINE(200, "worse"), "true");
    at(view, LINE(66, "worse"), "false"); /* the last of the best */
    at(view, LINE(66, "p"), "1.0");
    at(view, "ranking.too_many", "100");
    at(view, LINE(0, "letters"), "\"\"");
    at(view, "surfaces", "");
    char *page = workspace_shell(place, PROGRAM " compare --html out-*");
    expect_part(page, "<td>201: s2, ");
}

/** The block of docs/many.md that begins so, as a text. */
static char *documented(const char *start)
{
    char *page = workspace_read(PROJECT_SOURCE, "docs/many.md"), *at = strstr(page, start), *end;
    assert_non_null(at);
    end = strstr(at, "\n```\n");
    assert_non_null(end);
    return lasting("%.*s", (int)(end + 1 - at), at);
}

/* The commands of docs/many.md, word for word: by GNU parallel, as the tasks of a Slurm array, and by make. */
TEST_IN_WORKSPACE(ten_folders_as_documented)
{
    static const char *const ways[][2] = {
        {"parallel", "for folder in"}, {"sh", "#!/bin/sh\n#SBATCH"}, {"make", "folders :="}};
    static const char *const runs[] = {
        "rm -rf out; sh block 2>&1",
        "rm -rf out; for SLURM_ARRAY_TASK_ID in 1 2 3 4 5 6 7 8 9 10; do . ./block; done",
        "rm -rf out; make -f block >log 2>&1; touch scans/part-3/1.csv; make -f block",
    };
    char *path = lasting("%s", getenv("PATH"));
    assert_int_equal(setenv("PATH", filled("%.*s:%s", (int)(strrchr(PROGRAM, '/') - PROGRAM), PROGRAM, path), 1), 0);
    workspace_write(place, "scene.yaml", filled("%smodels: [corrected-persson]\n", documented("# scene.yaml")));
    for (unsigned i = 0; i < 20; i++)
        workspace_scan(place, filled("scans/part-%u/%u.csv", i / 2, i % 2), 200, i);
    for (size_t way = 0; way < sizeof ways / sizeof *ways; way++) {
        if (!workspace_can_run(place, filled("command -v %s", ways[way][0]))) {
            print_message("docs/many.md: not tested by %s, which is not there\n", ways[way][0]);
            continue;
        }
        workspace_write(place, "block", documented(ways[way][1]));
        char *said = workspace_shell(place, runs[way]);
        if (way == 2) { /* of newer scans alone */
            const char *first = strstr(said, " report ");
            assert_true(workspace_has(place, "ranked.html"));
            assert_ptr_equal(first, strstr(said, " report scans/part-3 "));
            assert_null(strstr(first + 1, " report "));
        }
        json_t *view = process_json(run_program(place, "sh", "-c", PROGRAM " compare --json out/*"));
        assert_int_equal(json_array_size(json_at(view, "ranking.lines")), 10);
    }
    setenv("PATH", path, 1);
}
