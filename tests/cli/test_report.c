/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The main job on the command line: options over the scene, real scans, the terminal's charts and times. */
#include "cli/process.h"
#include "direct/direct_surface.h"

#include <fcntl.h>

/** The number of a surface in out/d/data/surfaces.csv. */
static double surface_number(const char *place, const char *surface, const char *column)
{
    struct table table = workspace_table(place, "out/d/data/surfaces.csv");
    return table_number(&table, table_find(&table, 0, "surface", surface), column);
}

TEST_IN_WORKSPACE(test_overrides)
{
    workspace_scans(place, "d", 2, 200, 1);
    workspace_write(place, "d/scene.yaml", "material: tin\neffects: [thermal]\ntolerance: 1e-8\n");
    run_to_exit(place, 0, "report", "d");
    expect_in_file(place, "out/d/data/contact.csv", "tcr_K_m2_per_W");
    expect_not_in_file(place, "out/d/data/contact.csv", "ecr_ohm_m2");
    assert_false(workspace_has(place, "out/d/figures/stiffness.svg"));

    run_to_exit(place, 0, "report", "d", "--material=copper", "--effects", "electrical,stiffness", "--tolerance",
                "1e-3");
    expect_in_file(place, "out/d/data/contact.csv", "ecr_ohm_m2"); /* electrical alone asks for no yield */
    expect_not_in_file(place, "out/d/data/contact.csv", "tcr_K_m2_per_W", "-plastic");
    expect_in_file(place, "out/d/results.json", "\"name\": \"copper\"", "\"tolerance\": 0.001");
    expect_in_file(place, "out/d/report.md", "copper", "](figures/ecr.svg)", "](figures/stiffness.svg)");
    expect_not_in_file(place, "out/d/report.md", "](figures/tcr.svg)");
    assert_true(workspace_has(place, "out/d/figures/ecr.svg"));
    assert_false(workspace_has(place, "out/d/figures/tcr.svg"));
    assert_false(workspace_has(place, "out/d/data/convergence.csv"));
}

TEST_IN_WORKSPACE(test_units)
{
    workspace_write(place, "d/a.csv", "0,1\n1,3\n2,2\n3,5\n4,1\n5,4\n6,2\n7,6\n8,3\n9,1\n10,2\n11,5\n");
    expect_failure(place, 4, 2, "give --x-unit mm --z-unit um", "report", "d");
    run_to_exit(place, 0, "report", "d", "--x-unit", "um", "--z-unit", "nm", "-m", "tin", "-e", "plasticity");
    assert_near(surface_number(place, "a", "spacing_m"), 1e-6, 1e-12);
    assert_true(surface_number(place, "a", "rq_m") < 5e-9);
}

TEST_IN_WORKSPACE(test_wrong_options)
{
    static const struct {
        const char *option, *value, *message;
        size_t lines; /* 3: with two that point to --help; 1: also of `plan` */
    } wrong[] = {
        {"--material", "unobtainium", "unknown material 'unobtainium'; allowed: tin, copper", 1},
        {"--effects", "thermal,plastic", "unknown effect 'plastic'; ", 1},
        {"--effects", "", "--effects: 'effects' names none; give 'auto'", 1},
        {"--tolerance", "2", "--tolerance: 'tolerance' is 2; allowed is 1e-14 to 0.1", 1},
        {"--tolerance", "1e-3x", "'1e-3x'; give a number", 1},
        {"--x-unit", "furlong", "--x-unit must be a unit of length", 3},
        {"--jobs", "0", "--jobs must be 1 to 64, not '0'", 3},
        {"--jobs", "-1", "--jobs must be 1 to 64", 3},
        {"--jobs", "99999999999999999999", "--jobs must be 1 to 64", 3},
        {"--bogus", "x", "unrecognized option '--bogus'", 3},
        {"d", "d", "Too many arguments", 3},
    };
    workspace_scan(place, "d/a.csv", 200, 1);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        for (size_t c = 0; c < (wrong[i].lines == 1 ? 2 : 1); c++)
            expect_failure(place, 2, wrong[i].lines, wrong[i].message, c ? "plan" : "report", "d", wrong[i].option,
                           wrong[i].value);
    assert_false(workspace_has(place, "out"));
}

static void synthesise(const char *place, const char *alpha, const char *gamma, const char *length, const char *path)
{
    run_to_exit(place, 0, "synth", "-a", alpha, "-g", gamma, "-l", length, "-n", "1200", "-o", path);
}

TEST_IN_WORKSPACE(test_terminal)
{
    workspace_scans(place, "d", 2, 300, 1);
    assert_int_equal(setenv("COLUMNS", "80", 1), 0);
    struct process process = expect_exit(place, 0, "report", "d", "-m", "tin", "--show", "--verbose");
    assert_int_equal(unsetenv("COLUMNS"), 0);
    expect_output(process, "contact resistance (", "surface  ", "  contact resistance");
    expect_narrow(process.out);
    static const char path[] = "\nout/d/report.html\n";
    assert_true(process.out_length > sizeof path);
    assert_string_equal(process.out + process.out_length - (sizeof path - 1), path);
    expect_errors(process, "\nstage ", "\nread scans ", "\nstrips ", "\nmultiscale elastic ", "\nGW ", "\ngnuplot ",
                  "\ntotal ", "\nlargest memory ");
    assert_true(strtod(strstr(process.err, "\nstrips ") + strlen("\nstrips "), NULL) > 0);
    assert_null(strchr(process.err, '\r')); /* progress is for terminals only */
    process = expect_exit(place, 0, "report", "d");
    expect_no_part(process.err, "stage ");
    expect_no_part(process.out, "+--");
}

/** Where all surfaces are pressed flat at every load, the report says so in place of a number. */
TEST_IN_WORKSPACE(test_pressed_flat)
{
    workspace_scan(place, "d/a.csv", 300, 1);
    workspace_write(place, "d/scene.yaml",
                    "material: tin\nmodels: [corrected-persson]\neffects: []\n"
                    "load: {from: 100, to: 1000, points: 3}\n");
    expect_output(expect_exit(place, 0, "report", "d", "--no-cost"), " the contact area is not known on a.");
    expect_in_file(place, "out/d/report.md", " the contact area is not known on *a*.**");
    expect_not_in_file(place, "out/d/report.md", "One surface, every model");
    assert_false(workspace_has(place, "out/d/data/contact.csv"));
}

/** Each figure can be drawn again as the first line of its script says. It is the same but for an empty group with the
 * colour that the figure before ended with. */
TEST_IN_WORKSPACE(test_figures_drawn_by_hand)
{
    workspace_scans(place, "d", 2, 300, 1);
    run_to_exit(place, 0, "report", "d", "-m", "tin", "-o", "out", "--no-cost");
    workspace_shell(place, "cp -r out/figures again && cd again && for f in *.gp; do gnuplot \"$f\" || exit 1; done && "
                           "sed -i '/^<g fill=\"none\" color=\"#FFFFFF\"/d' *.svg ../out/figures/*.svg && "
                           "ls area.svg models.svg && diff -r . ../out/figures");
}

/** On a terminal (made by `script`) a line shows the progress of a long stage, and is gone at the end. */
TEST_IN_WORKSPACE(test_progress)
{
    int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    if (terminal < 0) {
        print_message("[  SKIPPED ] no pseudo-terminals here\n");
        skip();
    }
    close(terminal);
    workspace_scan(place, "d/a.csv", 160, 1);
    workspace_write(place, "d/scene.yaml",
                    "load: {from: 1e-4, to: 1e-2, points: 5}\n"
                    "direct: {grid: 64, seeds: 4, loads: 3}\n");
    (void)expect_status(
        run_program(place, "script", "-qec", PROGRAM " report d -e direct -m tin --no-cost", "typescript"), 0);
    char *seen = workspace_read(place, "typescript");
    expect_parts(seen, "\r\033[Kmodels of a: 0 %", "\r\033[Kdirect solution of a: 0 %", " s left\r\033[K");
    double before = -1; /* it grows, and ends before it is full */
    for (const char *at = seen; (at = strstr(at, "direct solution of a: ")); before = strtod(at, NULL)) {
        at += strlen("direct solution of a: ");
        assert_true(strtod(at, NULL) > before && strtod(at, NULL) < 100);
    }
    assert_true(before > 50);
}

/* Surfaces' laws are compared by their amplitudes at one wavelength, the geometric middle of what the bands share:
 * bands 0.5 ... 300 and 1 ... 600 um, so sqrt(1 x 300) um. alpha, the value at 1 m, is no number to compare. */
TEST_IN_WORKSPACE(test_laws_at_one_wavelength)
{
    workspace_write(place, "d/scene.yaml", "models: [multiscale]\nfit: thesis\n");
    synthesise(place, "0.085", "1.5", "0.3mm", "d/a.csv");
    synthesise(place, "1e-3", "1", "0.6mm", "d/b.csv");
    run_to_exit(place, 0, "report", "d", "--no-cost");
    expect_in_file(place, "out/d/report.md", "at 17.3 µm", "| α (m¹⁻ᵞ) | γ | rms (decades) | Δ (µm) |",
                   " | 0.00613 ×÷ 1.07 |", /* 0.085 17.32e-6^1.5 m */
                   " | 0.00100 | 1.000 ± 0.027 | ");
    workspace_write(place, "d/scene.yaml", "surfaces: [{name: a, file: a.csv}]\nfit: thesis\n");
    run_to_exit(place, 0, "report", "d", "--no-cost");
    expect_in_file(place, "out/d/report.md", "at 12.2 µm"); /* of one surface, its band's middle */
}

/** Made-up measurements: GW's curve doubled, on loading and unloading. The report shows them in their units and order,
 * with GW nearest, off by that factor. Then two surfaces have measurements: one has two runs, 1/0.5 and 1/0.72 of GW,
 * whose geometric mean carries into the target, the other has the first run. */
TEST_IN_WORKSPACE(test_measured)
{
    static const char scene[] = "material: tin\nnominal_area_m2: 1e-6\neffects: [plasticity, electrical]\n%s";
    static const char apart[] =
        "models: gw\ntargets: [{ecr: %.15g ohm}]\nbaseline: a\nsurfaces:\n  - {name: b, file: a.csv}\n"
        "  - {name: a, file: a.csv, measured: {file: [ecr.csv, .run.csv], carry: true}}\n"
        "  - {name: c, file: a.csv, measured: {file: ecr.csv}}\n";
    static const size_t order[] = {20, 50, 80, 65, 35, 5};
    enum { POINTS = sizeof order / sizeof *order, TURN = 2 };
    workspace_scan(place, "d/a.csv", 300, 1);
    workspace_write(place, "d/scene.yaml", filled(scene, ""));
    run_to_exit(place, 0, "report", "d", "--no-cost");
    expect_not_in_file(place, "out/d/report.md", "Measured");
    struct table contact = workspace_table(place, "out/d/data/contact.csv");
    size_t gw = table_find(&contact, 0, "model", "gw");
    struct text *csv = support_text(), *run = support_text();
    text_add(csv, "Load (mN);ECR (m\xCE\xA9);error (%%)\n");
    text_add(run, "P/(A_n E');ECR (Ohm m2)\n");
    double target_ohm = table_number(&contact, gw + order[1], "ecr_ohm_m2") / sqrt(0.5 * 0.72) / 1e-6;
    double target_load = table_number(&contact, gw + order[1], "load_over_AnEp");
    double passed[2]; /* where the runs, straight in the logarithms, have the target */
    for (int k = 0; k < 2; k++) {
        double side[2][2], ratio = log(target_ohm * 1e-6 / (k == 0 ? 2 : 1 / 0.72));
        for (int end = 0; end < 2; end++) {
            size_t at = gw + order[k == 0 ? 1 + end : end];
            side[0][end] = log(table_number(&contact, at, "load_over_AnEp"));
            side[1][end] = log(table_number(&contact, at, "ecr_ohm_m2"));
        }
        passed[k] = exp(side[0][0] + (side[0][1] - side[0][0]) * (ratio - side[1][0]) / (side[1][1] - side[1][0]));
    }
    double least = INFINITY; /* Ω m² */
    for (size_t i = 0; i < POINTS; i++) {
        double resistance_ohm_m2 = 2 * table_number(&contact, gw + order[i], "ecr_ohm_m2");
        assert_string_equal(table_text(&contact, gw + order[i], "model"), "gw");
        text_add(csv, "%.15g;%.15g;10\n", table_number(&contact, gw + order[i], "pressure_Pa") * 1e-6 * 1e3,
                 resistance_ohm_m2 / 1e-6 * 1e3);
        text_add(run, "%.15g;%.15g\n", table_number(&contact, gw + order[i], "load_over_AnEp"),
                 resistance_ohm_m2 / 2 / 0.72);
        least = fmin(least, resistance_ohm_m2);
    }
    workspace_write(place, "d/ecr.csv", text_string(csv));
    workspace_write(place, "d/.run.csv", text_string(run));
    workspace_write(place, "d/scene.yaml", filled(scene, "measured: {file: ecr.csv}\n"));
    run_to_exit(place, 0, "report", "d", "--no-cost");
    expect_in_file(place, "out/d/report.md", "GW is nearest to the 6 points measured on *a*", "GW 0.500, ×÷ 2.00",
                   "](figures/measured.svg)");
    char *data = workspace_read(place, "out/d/figures/answer.csv");
    char *rest = strstr(data, "# measured, loading\n"), *back = strstr(data, "# measured, unloading\n");
    assert_true(rest && back);
    rest += strlen("# measured, loading\n");
    double load[POINTS], found = INFINITY, scale = 0;
    for (size_t i = 0; i < POINTS; i++) {
        if (i == TURN + 1)
            rest = back + strlen("# measured, unloading\n");
        load[i] = strtod(rest, &rest);
        double value = strtod(rest + 1, &rest), low = strtod(rest + 1, &rest), high = strtod(rest + 1, &rest);
        assert_near(low, 0.9 * value, 1e-8); /* nine digits */
        assert_near(high, 1.1 * value, 1e-8);
        assert_true(i == 0 || (load[i] > load[i - 1]) == (i <= TURN));
        found = fmin(found, value);
        scale = fmax(scale, value);
    }
    assert_near(log10(found / least), round(log10(found / least)), 1e-8); /* in the unit of the chart: a power of ten */
    assert_true(scale > found);

    workspace_write(place, "d/scene.yaml", filled(scene, filled(apart, target_ohm)));
    run_to_exit(place, 0, "report", "d", "--no-cost");
    expect_in_file(place, "out/d/report.md", "*a* conducts 0.60 times what the model says (95\u00a0%: 0.059 to 6.1)",
                   "; its numbers above are the test's, and beyond it the model's with that factor.\n",
                   "12 points measured on *a* in 2 runs", "6 points measured on *c*.\n");
    struct table answers = workspace_table(place, "out/d/data/answers.csv");
    assert_string_equal(table_text(&answers, 1, "surface"), "a");
    assert_near(table_number(&answers, 1, "load_over_AnEp"), sqrt(passed[0] * passed[1]), 1e-8); /* the page's, too */
    assert_near(table_number(&answers, 1, "load_over_AnEp"), target_load, 0.01);
    assert_string_equal(table_text(&answers, 1, "low"), "");
    assert_true(table_number(&answers, 0, "load_over_AnEp") < 0.99 * target_load);
    workspace_write(place, "d/scene.yaml", filled(scene, "measured: {file: ecr.csv, load_unit: N}\n"));
    expect_failure(place, 3, 1, "ecr.csv:1: the unit is 'mN' here, but the scene's load_unit says 'N'", "report", "d");
    workspace_write(place, "d/ecr.csv", "load,ecr\n1,4.8\n");
    expect_failure(place, 3, 1, "add 'resistance_unit' to 'measured' in the scene", "report", "d");
}

/* Beyond a test the model goes on with its factor. How far that is off nobody knows: neither page nor table says. */
TEST_IN_WORKSPACE(beyond_a_test_there_is_no_interval)
{
    workspace_scans(place, "d", 3, 300, 1);
    workspace_write(place, "m.txt", "load_N,resistance_mohm\n1,0.9\n");
    workspace_write(place, "d/scene.yaml",
                    "material: tin\nnominal_area: 1 mm2\noperating_load: 1 N\nmodels: [corrected-persson]\n"
                    "targets: [{ecr: 0.5 mohm}]\n"
                    "surfaces: [{name: a, file: '*.csv', measured: {file: ../m.txt}}]\n");
    run_to_exit(place, 0, "report", "d", "--no-cost");
    struct table answers = workspace_table(place, "out/d/data/answers.csv");
    size_t leading = table_find(&answers, 0, "model", "corrected-persson-plastic");
    assert_true(table_number(&answers, leading, "load_N") > 1.1);
    assert_string_equal(table_text(&answers, leading, "low"), "");
    assert_string_equal(table_text(&answers, leading, "high"), "");
}
