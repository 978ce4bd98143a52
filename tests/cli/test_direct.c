/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The direct solution from the command line to the report: on call, what it writes, and nothing where it is not. */
#include "cli/process.h"
#include "contact/model.h"

#define EFFECTS "effects: [plasticity, separation, electrical, thermal]\n"

static void write_scene(const char *place, const char *text)
{
    workspace_write(place, "d/scene.yaml", filled("material: tin\nsurfaces: [{name: a, file: a.csv}]\n%s", text));
}

static void write_profile(const char *place, const char *scene)
{
    workspace_scan(place, "d/a.csv", 400, 3);
    write_scene(place, scene);
}

/** Root mean square gradient of the surfaces, sqrt(2 m2), of the law in results.json. */
static double gradient_of(const json_t *direct)
{
    double alpha = json_number_at(direct, "alpha_SI"), gamma = json_number_at(direct, "gamma"),
           length = json_number_at(direct, "cell_m"), cut = json_number_at(direct, "lambda_s_m"),
           longest = json_number_at(direct, "roll_off_m"), m2 = 0;
    for (int m = 1; m <= 3.2 * length / cut; m++) {
        double above = m * cut / length, amplitude = alpha * pow(fmin(length / m, longest), gamma);
        amplitude *= above > 1 ? exp(-log(2) * (above * above - 1)) : 1;
        m2 += pow(2 * 3.14159265358979 * m / length * amplitude, 2) / 2;
    }
    return sqrt(2 * m2);
}

/* Area as in the literature, resistance by the slope of the gap, and with a hardness an area of at least P/H. */
TEST_IN_WORKSPACE(test_numbers)
{
    write_profile(place,
                  EFFECTS "direct: {grid: 64, seeds: 2, loads: [1e-3, 1.05e-3, 1.1e-3, 4e-3], hardness: 400 MPa}\n");
    report_scene(place, "out", NULL);
    struct table t = workspace_table(place, "out/data/direct.csv"),
                 r = workspace_table(place, "out/data/direct_ratio.csv");
    expect_in_file(place, "out/data/direct.csv",
                   "surface,source,load_over_AnEp,area_ratio,area_stderr,gap_m,gap_stderr,ecr_ohm_m2,ecr_stderr,"
                   "tcr_K_m2_per_W,patches,seeds,grid,heights,hardness_Pa\n");
    expect_in_file(place, "out/data/direct_ratio.csv", "surface,model,load_over_AnEp,area,gap,ecr\n");
    assert_true(workspace_has(place, "out/figures/direct.svg"));
    expect_in_file(place, "out/report.md", "## The models against the direct solution", " is the nearest elastic one.");
    double g = gradient_of(json_at(workspace_json(place, "out/results.json"), "direct.0")),
           modulus = 41.4e9 / (1 - 0.36 * 0.36);
    size_t elastic = 0, capped = 0;
    for (size_t i = 0; i < t.rows; i++) {
        bool cap = *table_text(&t, i, "hardness_Pa") != '\0';
        double load = table_number(&t, i, "load_over_AnEp"), area = table_number(&t, i, "area_ratio");
        assert_near(table_number(&t, i, "tcr_K_m2_per_W") / table_number(&t, i, "ecr_ohm_m2"), 1 / (66.8 * 11.5e-8),
                    1e-12);
        if (cap) {
            assert_near(table_number(&t, i, "hardness_Pa"), 400e6, 1e-12);
            assert_true(area >= load * modulus / 400e6 * (1 - 1e-12));
            capped++;
        } else if (i + 2 < t.rows && load == 1e-3) {
            assert_within(area * g / load, 2.05, 0.35);
            double slope = (table_number(&t, i + 2, "gap_m") - table_number(&t, i, "gap_m")) / 1e-4;
            assert_near(table_number(&t, i + 1, "ecr_ohm_m2"), -11.5e-8 * slope, 0.01);
            elastic++;
        }
    }
    assert_int_equal(elastic, 1);
    assert_int_equal(capped, 4); /* 4e-3 E' = 190 MPa */
    size_t persson[2] = {0};     /* elastic, and with that hardness */
    for (size_t i = 0; i < r.rows; i++)
        if (strncmp(table_text(&r, i, "model"), "corrected-persson", 17) == 0 && *table_text(&r, i, "area")) {
            assert_within(log(table_number(&r, i, "area")), 0, log(2));
            persson[table_text(&r, i, "model")[17] == '-']++;
        }
    assert_true(persson[0] > 0 && persson[1] > 0);
}

/* `plan` says how long the direct solution takes, whether or not it is called for. A budget calls for it, on the
 * command line as in the scene, to the same bytes. `auto` may stand beside it in --effects. */
TEST_IN_WORKSPACE(test_plan_and_budget)
{
    write_profile(place, "nominal_area: 1 mm2\n");
    expect_output(expect_exit(place, 0, "plan", "d"),
                  "direct           skipped   not called for; `roughcontact direct`", " of one core");
    expect_output(expect_exit(place, 0, "plan", "d", "--effects", "auto,direct"),
                  "called for on 1 surface: 1024 x 1024", " core");
    expect_output(expect_exit(place, 0, "plan", "d", "--budget", "60 ms"), "called for on 1 surface: 64 x 64 points");
    run_to_exit(place, 0, "report", "d", "-o", "line", "--no-cost", "--budget", "60 ms");
    write_scene(place, "nominal_area: 1 mm2\ndirect: {budget: 60 ms}\n");
    report_scene(place, "out", NULL);
    directory_expect_same(place, "line/data/direct.csv", "out/data/direct.csv");
    workspace_scan(place, "d/b.csv", 400, 4);
    workspace_write(place, "d/scene.yaml",
                    "material: tin\nbaseline: b\ndirect: {surfaces: all, budget: 60 ms}\n"
                    "surfaces: [{name: a, file: a.csv}, {name: b, file: b.csv}]\n");
    expect_output(expect_exit(place, 0, "plan", "d"), "called for on 2 surfaces; b: 64 x 64 points");
}

/* Barber: stiffness and conductance of an elastic contact are proportional, k ECR A_n = E' rho; for the models, too. */
TEST_IN_WORKSPACE(test_stiffness)
{
    static const char *const effects[] = {"[separation, stiffness]", "[plasticity, separation, electrical, stiffness]"};
    struct table t[2], r;
    for (int k = 0; k < 2; k++) {
        write_profile(
            place, filled("effects: %s\ndirect: {grid: 64, seeds: 2, loads: [1e-3], hardness: 400 MPa}\n", effects[k]));
        report_scene(place, "out", NULL);
        t[k] = workspace_table(place, "out/data/direct.csv");
    }
    double k = table_number(&t[1], 0, "stiffness_Pa_per_m"), ecr = table_number(&t[1], 0, "ecr_ohm_m2");
    assert_near(k * ecr, 41.369e9 / (1 - 0.36 * 0.36) * 11.5e-8, 1e-9);
    assert_near(table_number(&t[0], 0, "stiffness_Pa_per_m"), k, 1e-12);
    assert_string_equal(table_text(&t[1], 1, "stiffness_Pa_per_m"), ""); /* with a hardness */
    r = workspace_table(place, "out/data/direct_ratio.csv");
    for (size_t i = 0; i < r.rows; i++)
        if (strcmp(table_text(&r, i, "model"), "corrected-persson") == 0)
            assert_near(table_number(&r, i, "stiffness") * table_number(&r, i, "ecr"), 1, 1e-9);
    expect_in_file(place, "out/report.md", "| model | area | gap | ECR | stiffness |", " k/Aₙ (Pa/m) |");
    expect_in_file(place, "out/figures/one-surface.gp", "Stiffness versus load");
}

TEST_IN_WORKSPACE(test_off)
{
    static const char *const scenes[] = {EFFECTS "direct: off\n", "effects: auto\n"};
    for (size_t s = 0; s < 2; s++) {
        write_profile(place, scenes[s]);
        report_scene(place, "out", NULL);
        assert_int_equal(workspace_count(place, "direct"), 0);
        assert_int_equal(workspace_count(place, "patches"), 0);
        run_to_exit(place, 0, "report", "d", "-o", "cost");
        expect_in_file(place, "cost/report.md", "**What accuracy costs.**", ", 95 % | time |");
        expect_not_in_file(place, "cost/report.md", "against the direct solution");
        expect_in_file(place, "out/report.md",
                       "direct (not called for; it takes seconds to minutes and says how far each model is off)");
        assert_null(json_object_get(workspace_json(place, "out/results.json"), "direct"));
    }
}

/* The command line overrides the scene. */
TEST_IN_WORKSPACE(test_called_for)
{
    write_profile(place, "effects: [separation]\ndirect: {grid: 32, seeds: 1, loads: [2e-2]}\n");
    run_to_exit(place, 0, "report", "d", "--no-cost", "--effects", "separation");
    assert_false(workspace_has(place, "out/d/data/direct.csv"));
    run_to_exit(place, 0, "direct", "d", "--no-cost", "--effects", "separation");
    assert_true(workspace_has(place, "out/d/data/direct.csv"));
    struct table t = workspace_table(place, "out/d/data/direct.csv");
    assert_int_equal(t.columns, 12); /* no resistance: no column */
    run_to_exit(place, 0, "report", "d", "--no-cost", "-o", "o2", "--effects", "direct");
    assert_true(workspace_has(place, "o2/data/direct.csv"));
    assert_false(workspace_has(place, "o2/figures/direct-ecr.svg"));
}

/** A map of 24 points along, in m, and 20 across. */
static void write_map(const char *place, double across_m)
{
    struct text *text = support_text();
    text_add(text, "DSAA\n24 20\n0 23e-6\n0 %g\n-1e-6 1e-6\n", across_m);
    for (int j = 0; j < 20; j++)
        for (int i = 0; i < 24; i++)
            text_add(text, "%.9e\n", 4e-7 * sin(0.7 * i + 0.2 * j) * cos(0.9 * j) + 1e-7 * sin(1.1 * i * j));
    workspace_write(place, "d/map.grd", text_string(text));
}

/* A map is solved as it is: one solution, of its own heights, without a power law. */
TEST_IN_WORKSPACE(test_map)
{
    write_map(place, 19e-6);
    workspace_write(place, "d/scene.yaml",
                    "material: tin\neffects: [separation, electrical, direct]\nload: {from: 1e-4, to: 1, points: 41}\n"
                    "surfaces: [{name: m, file: map.grd, x_unit: m, z_unit: m}]\ndirect: {loads: 5}\n");
    report_scene(place, "out", NULL);
    struct table t = workspace_table(place, "out/data/direct.csv");
    assert_int_equal(t.rows, 5);
    size_t numbers = 0;
    double differs = 0;
    for (size_t i = 0; i < t.rows; i++) {
        assert_string_equal(table_text(&t, i, "source"), "map");
        assert_string_equal(table_text(&t, i, "grid"), "40");
        assert_string_equal(table_text(&t, i, "seeds"), "1");
        if (!*table_text(&t, i, "area_ratio"))
            continue;
        double open = table_number(&t, i, "gap_m"); /* so few points may have the same area by chance */
        assert_true(open == 0 || (table_number(&t, i, "gap_stderr") > 0 && table_number(&t, i, "ecr_stderr") > 0));
        differs += table_number(&t, i, "area_stderr");
        if (numbers++ > 0)
            assert_true(table_number(&t, i, "gap_m") < table_number(&t, i - 1, "gap_m"));
    }
    assert_true(numbers >= 2 && differs > 0);
    expect_in_file(place, "out/report.md",
                   "without a model: the map itself, 20 × 20 points, 20.0 µm wide, continued by its mirror image.",
                   "20 x 20 points, the map continued by its mirror image, 5 loads", "This holds at this resolution");
}

/* Without lambda_s the shortest waves are four spacings long: plan and report say so. */
TEST_IN_WORKSPACE(test_resolution)
{
    workspace_scan(place, "d/a.csv", 64, 1);
    write_scene(place, EFFECTS "direct: {grid: 128, seeds: 1, loads: [2e-3, 1e-2]}\n");
    struct process plan = expect_exit(place, 0, "plan", "d");
    process_unwrap(&plan);
    expect_part(plan.out, ", down to waves of four spacings, as no lambda_s is given: it holds at this resolution");
    report_scene(place, "out", NULL);
    expect_in_file(place, "out/report.md", "This holds at this resolution");
    assert_true(json_number_at(workspace_json(place, "out/results.json"), "direct.0.gamma") < 1.5);
    write_scene(place, EFFECTS "direct: {grid: 128, seeds: 2, loads: [2e-3, 1e-2]}\nlambda_s_m: 6e-6\n");
    report_scene(place, "out", NULL);
    expect_not_in_file(place, "out/report.md", "holds at this resolution");
    write_scene(place, EFFECTS "direct: {grid: 32, seeds: 2, loads: [2e-3, 1e-2]}\nlambda_s_m: 3e-6\n");
    report_scene(place, "out", NULL); /* a grid too coarse for that */
    expect_in_file(place, "out/report.md", "This holds at this resolution: finer waves are left out");
}

TEST_IN_WORKSPACE(test_impossible)
{
    write_profile(place, EFFECTS "load: {values: [1e-9]}\ndirect: {grid: 64, seeds: 1}\n");
    report_scene(place, "out", NULL);
    assert_false(workspace_has(place, "out/data/direct.csv"));
    expect_in_file(place, "out/report.md", "## The models against the direct solution\n\n*",
                   "* is not solved: no load of the scene lies between");
    expect_not_in_file(place, "out/report.md", "No direct solution");
    assert_true(json_is_false(json_at(workspace_json(place, "out/results.json"), "scene.effects.direct.runs")));
}

/* A map of two spacings cannot be solved: neither plan nor report say that it is. */
TEST_IN_WORKSPACE(test_impossible_map)
{
    static const char *const why = "spacings of 1e-06 m along and 2e-06 m across the rows are not the same";
    write_map(place, 38e-6);
    workspace_write(place, "d/scene.yaml",
                    "material: tin\nsurfaces: [{name: m, file: map.grd, x_unit: m, z_unit: m}]\n");
    struct process plan = expect_exit(place, 0, "plan", "d");
    process_unwrap(&plan);
    expect_part(plan.out, filled("not called for; %s", why));
    run_to_exit(place, 0, "direct", "d", "--no-cost", "-o", "out");
    const json_t *effect = json_at(workspace_json(place, "out/results.json"), "scene.effects.direct");
    assert_true(json_is_false(json_object_get(effect, "runs")));
    expect_part(json_text_at(effect, "reason"), filled("called for, but %s", why));
    expect_in_file(place, "out/report.md", filled("*m* is not solved: %s", why));
}

TEST_IN_WORKSPACE(test_key)
{
    static const struct {
        const char *key, *message;
    } wrong[] = {
        {"{grid: 63}", "'grid' is 63; give an even number"},
        {"{grid: 8}", "'grid' is 8; allowed is 16 to 16384"},
        {"{loads: [1e-3, 1e-4]}", "'loads' do not rise"},
        {"{budget: 3 MPa}", "'budget'"},
        {"{hardness: -4 MPa}", "'hardness'"},
        {"{surfaces: some}", "allowed: baseline, all"},
        {"{gird: 64}", "unknown key 'gird'; did you mean 'grid'?"},
    };
    workspace_scan(place, "d/a.csv", 400, 3);
    for (size_t w = 0; w < sizeof wrong / sizeof *wrong; w++) {
        write_scene(place, filled("direct: %s\n", wrong[w].key));
        expect_failure(place, 3, 1, wrong[w].message, "plan", "d");
    }
}
