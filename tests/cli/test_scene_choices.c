/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Choices of a scene: its report's template, the accuracy, a gap as the target. */
#include "cli/process.h"
#include "contact/model.h"

TEST_IN_WORKSPACE(a_scene_brings_its_template)
{
    workspace_scan(place, "d/a.csv", 200, 1);
    workspace_write(place, "d/own.md", "Mine: {{title}}\n");
    workspace_write(place, "other.md", "Other: {{title}}\n");
    report_scene(place, "o", "title: T\ntemplate: own.md\n");
    expect_in_file(place, "o/report.md", "Mine: T");
    run_to_exit(place, 0, "report", "d", "--no-cost", "-o", "o", "--template", "other.md");
    expect_in_file(place, "o/report.md", "Other: T");
    workspace_write(place, "d/scene.yaml", "title: T\ntemplate: none.md\n");
    expect_failure(place, 3, 1, "scene.yaml:2: cannot read the template 'none.md': No such file", "report", "d");
}

/* A scan that is not periodic and holds less than 2.5 of its longest waves adds 1.3 ln(2.5/waves) to every model's
 * error; a periodic one does not. */
TEST_IN_WORKSPACE(few_waves_are_expected_to_cost_accuracy)
{
    for (int closed = 0; closed < 2; closed++) {
        run_to_exit(place, 0, "synth", "--alpha", "0.05", "--gamma", "1.6", "--length", closed ? "0.1mm" : "0.4mm",
                    "--points", closed ? "400" : "1600", "-o", "whole.csv");
        workspace_shell(place, closed ? "mkdir -p d; cp whole.csv d/a.csv"
                                      : "mkdir -p d; head -n 1 whole.csv > d/a.csv; tail -n 400 whole.csv >> d/a.csv");
        run_to_exit(place, 0, "report", "d", "-m", "tin", "-o", "o", "--accuracy", "70 %");
        json_t *results = workspace_json(place, "o/results.json"), *view = workspace_json(place, "o/view.json");
        double waves = json_number_at(results, "surfaces.0.longest_waves");
        assert_true(waves > 0 && waves < 2.2);
        if (!closed) {
            double own = model_sd(model_rows[model_named("strip-plastic")], QUANTITY_ECR, false),
                   few_sd = 1.3 * log(2.5 / waves);
            size_t last = json_array_size(json_at(view, "accuracy.models")) - 1;
            assert_near(json_number_at(view, "accuracy.few_waves"), exp(1.96 * few_sd), 0.01);
            assert_near(json_number_at(view, filled("accuracy.models.%zu.factor", last)),
                        exp(1.96 * hypot(own, few_sd)), 0.01);
        } else
            assert_null(json_at(view, "accuracy.few_waves"));
    }
}

/* The cheapest model within the accuracy runs alone: the textbook within a factor of 6, Gaussian heights within 3.9,
 * strips within 3. */
TEST_IN_WORKSPACE(no_dearer_model_than_the_accuracy_asks_for)
{
    static const struct {
        const char *accuracy, *model, *says;
    } cases[] = {
        {"500 %", "cmy", "CMY is the cheapest of the models asked for whose own error is within 500\u00a0%"},
        {"290 %", "corrected-persson-plastic",
         "Gaussian heights with hardness is the cheapest of the models asked for whose own error is within 290\u00a0%"},
        {"200 %", "strip-plastic",
         "strip transfer with hardness is the cheapest of the models asked for whose own error is within 200 %"},
        {"10 %", "strip-plastic",
         "None of the quick models asked for is within 10 % (95 %); strip transfer with hardness comes nearest"},
    };
    workspace_scan(place, "d/a.csv", 400, 1);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        report_scene(place, "o", filled("material: tin\naccuracy: %s\n", cases[i].accuracy));
        expect_in_file(place, "o/report.md", cases[i].says);
        json_t *results = workspace_json(place, "o/results.json");
        assert_string_equal(json_text_at(results, "leading"), cases[i].model);
        struct table contact = workspace_table(place, "o/data/contact.csv");
        for (size_t r = 0; r < contact.rows; r++) /* and what it yields from */
            assert_true(strncmp(table_text(&contact, r, "model"), cases[i].model, strcspn(cases[i].model, "-")) == 0);
    }
    run_to_exit(place, 0, "report", "d", "--no-cost", "-o", "o", "--accuracy", "290 %");
    expect_in_file(place, "o/report.md", "Gaussian heights with hardness is the cheapest");
    report_scene(place, "o", "material: tin\n");
    expect_not_in_file(place, "o/report.md", "the cheapest model");
}

/* Scans of unlike spacing make no strips, so with strips alone nothing is left to run. */
TEST_IN_WORKSPACE(a_model_that_is_not_there_is_told)
{
    workspace_scan(place, "d/a-1.csv", 200, 1);
    workspace_shell(place, "awk -F, 'NR == 1 { print; next } { print 3 * $1 \",\" $2 }' d/a-1.csv > d/a-2.csv");
    workspace_write(place, "d/scene.yaml", "models: [strip]\nsurfaces: [{name: a, file: 'a-*.csv'}]\n");
    expect_failure(place, 4, 3, "no model is left for these scans and this material; name others in 'models'", "report",
                   "d");
    assert_false(workspace_has(place, "out/d/report.md"));
    /* what was measured is checked before: its mistakes come first */
    static const struct {
        const char *csv, *scene, *surface;
        int status;
        const char *said;
    } rows[] = {
        {"load (N),ECR (mohm)\n1,2\n2,x\n", "measured: {file: m.txt}\n", "", 3, "m.txt:3: 'x' is no number"},
        {"1,2\n", "measured: {file: m.txt}\n", "", 3, "m.txt: nothing says the unit of the load"},
        {"load (N),ECR (mohm)\n1,2\n", "", ", measured: {file: m.txt, quantity: tcr}", 3, "m.txt"},
        {"load (N),ECR (mohm)\n1,2\n", "measured: {file: m.txt}\n", ", measured: {file: m.txt}", 3,
         "the baseline, 'a', has 'measured' of its own and the scene's; remove either"},
        {"load (N),ECR (mohm)\n1,2\n", "measured: {file: m.txt}\n", "", 4, "no model is left for these scans"},
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        workspace_write(place, "d/m.txt", rows[k].csv);
        workspace_write(place, "d/scene.yaml",
                        filled("material: tin\nmodels: [strip]\nnominal_area: 1 mm2\n%ssurfaces: [{name: a, file: "
                               "'a-*.csv'%s}]\n",
                               rows[k].scene, rows[k].surface));
        expect_failure(place, rows[k].status, rows[k].status == 3 ? 1 : 3, rows[k].said, "report", "d");
    }
}

/* At the load that a target of the gap needs, the gap is the target. */
TEST_IN_WORKSPACE(a_gap_is_asked_for)
{
    static const char head[] = "material: tin\nnominal_area: 1 mm2\nsurfaces: [{name: s, file: '*.csv'}]\n";
    workspace_scans(place, "d", 3, 400, 1);
    report_scene(place, "o", filled("%starget%s: [{gap: 0.1 um}]\nlimits: {gap: {least: 1 nm}}\n", head, "s"));
    expect_in_file(place, "o/report.md", "**To reach 0.1\u00a0µm, *s* needs ", "✓ met");
    struct table answers = workspace_table(place, "o/data/answers.csv"), contact;
    double load = table_number(&answers, table_find(&answers, 0, "model", "strip-plastic"), "load_over_AnEp");
    report_scene(place, "o", filled("%sload: {values: [%.17g]}\n", head, load));
    contact = workspace_table(place, "o/data/contact.csv");
    size_t row = table_find(&contact, 0, "model", "strip-plastic");
    assert_near(table_number(&contact, row, "gap_m"), 1e-7, 1e-5);
    assert_true(table_number(&contact, row, "separation_m") == table_number(&contact, row, "gap_m"));
    workspace_write(place, "d/scene.yaml", filled("%seffects: [electrical]\ntargets: [{gap: 0.1 um}]\n", head));
    expect_failure(place, 3, 1, "'gap' needs the effect 'separation', which is not listed", "report", "d");
}

/** What the report says that an effect multiplies the asked number by; NaN: nothing. */
static double factor_of(const json_t *view, const char *effect)
{
    size_t i;
    const json_t *row;
    json_array_foreach (json_object_get(view, "effects"), i, row) {
        const json_t *factor = json_object_get(row, "factor");
        if (strcmp(json_string_value(json_object_get(row, "name")), effect) == 0)
            return json_is_number(factor) ? json_number_value(factor) : NAN;
    }
    fail_msg("no effect %s", effect);
    return NAN;
}

/* The report says what each effect changes: the ratio of the data with and without it. */
TEST_IN_WORKSPACE(effects_say_what_they_change)
{
    workspace_scan(place, "d/a.csv", 400, 1);
    report_scene(place, "o", "material: tin\nload: {values: [1e-5]}\nfilm: 3e-10 ohm m2\n");
    struct table contact = workspace_table(place, "o/data/contact.csv");
    const size_t leads = table_find(&contact, 0, "model", "strip-plastic"),
                 elastic = table_find(&contact, 0, "model", "strip");
    const double joint = table_number(&contact, leads, "joint_ecr_ohm_m2");
    json_t *view = workspace_json(place, "o/view.json");
    assert_near(factor_of(view, "film"), joint / table_number(&contact, leads, "ecr_ohm_m2"), 0.05);
    assert_near(factor_of(view, "plasticity"), joint / table_number(&contact, elastic, "joint_ecr_ohm_m2"), 0.05);
    assert_true(isnan(factor_of(view, "thermal")) && isnan(factor_of(view, "uncertainty")));
    expect_in_file(place, "o/report.md", "needs no more than E'; changes no other number",
                   "records can be simulated of the one scan of 1 surface; changes no number");
}

/* Without a material a load is P/(A_n E'), no force. */
TEST_IN_WORKSPACE(loads_without_a_material)
{
    workspace_scan(place, "d/a.csv", 200, 1);
    workspace_write(place, "d/scene.yaml", "models: [corrected-persson]\ntargets: [{area: 0.01}]\n");
    char *page = workspace_shell(place, PROGRAM " report d -o o --no-cost");
    expect_part(page, "surface  P/(Aₙ E′) ");
    expect_in_file(place, "o/report.md", "| surface | load for 0.01 (P/(Aₙ E′), 95 %) |", "·10⁻⁵ (95 %) |");
    workspace_write(place, "d/scene.yaml",
                    "models: [corrected-persson]\nmaterial: tin\nnominal_area: 1 mm2\ntargets: [{area: 0.01}]\n");
    expect_part(workspace_shell(place, PROGRAM " report d -o o --no-cost"), "force/N ");
    expect_in_file(place, "o/report.md", "| surface | force for 0.01 (N) | contact area at 0.432\u00a0N | Rq");
}

/* Table 6.1 says of a material in several pairs which row is whose, and names its source once. */
TEST_IN_WORKSPACE(a_material_in_several_pairs)
{
    for (unsigned i = 0; i < 3; i++)
        workspace_scan(place, filled("d/%c.csv", 'a' + i), 200, i);
    report_scene(place, "o",
                 "models: [corrected-persson]\nmaterial: tin\nsurfaces: [{name: a, file: a.csv}, "
                 "{name: b, file: b.csv, counterface: copper}, {name: c, file: c.csv}]\n");
    char *page = workspace_read(place, "o/report.md"), *source = strstr(page, "\ntin: ");
    expect_part(page, "| tin (*a* and 1 more) |");
    expect_part(page, "| tin (*b*) |");
    expect_part(page, "\n| copper |");
    assert_non_null(source);
    expect_no_part(source + 1, " tin: ");
    expect_part(source, ". copper: ");
    report_scene(place, "o", "models: [corrected-persson]\nmaterial: tin\n");
    expect_in_file(place, "o/report.md", "\n| tin |");
}

TEST_IN_WORKSPACE(the_page_names_what_is_no_scan)
{
    workspace_scan(place, "d/a.csv", 200, 1);
    workspace_write(place, "d/readme.md", "Text.\n");
    report_scene(place, "o", "models: [corrected-persson]\n");
    expect_in_file(place, "o/report.md", "\n- passed over, no scan: 1 x text (readme.md)\n");
}
