/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The charts of whole reports: each caption says what is drawn and no more, the direct solution is where it belongs,
 * and the page shows a chart whole on a telephone. */
#include "base/program.h"
#include "cli/process.h"

/** A file of a chart. */
static char *file_of(const char *place, const char *out, const char *name, const char *ending)
{
    return workspace_read(place, filled("%s/figures/%s.%s", out, name, ending));
}

/** The numbers that panels have in a script, as a caption lists them. */
static void numbers_in(char *out, size_t size, const char *script)
{
    bool there[100] = {false};
    out[0] = '\0';
    for (const char *at = script; (at = strstr(at, "set label '6-")); at++)
        there[atoi(at + strlen("set label '6-"))] = true;
    for (int n = 1, end; n + 1 < 100; n = end + 1) {
        for (end = n; there[end]; end++)
            ;
        const int step = end - n > 2 ? end - n - 1 : 1; /* the first and the last of three or more */
        for (int k = n; k < end; k += step)
            snprintf(out + strlen(out), size - strlen(out), "%s6-%02d",
                     k > n && end - n > 2 ? " to "
                     : out[0]             ? ", "
                                          : "",
                     k);
    }
}

/** What the view says of a chart's caption is what its script draws. */
static void expect_flags(const char *place, const char *out, const char *name, const json_t *figure)
{
    const bool surfaces = strcmp(name, "surfaces") == 0, direct = strcmp(name, "direct") == 0,
               at_load = strcmp(name, "surfaces-at-load") == 0, rows = at_load || strcmp(name, "models") == 0;
    char *script = file_of(place, out, name, "gp"), numbers[64];
    const bool dotted = strstr(script, " lw 1.4 dt 3 ");
    const struct {
        const char *flag;
        bool drawn;
    } flags[] = {
        {"band", (strstr(script, "filledcurves") && !direct) || strstr(script, "with xerrorbars")},
        {"outside", strstr(script, " lw 1.2 dt 2 ") || (rows && !at_load && strstr(script, " pt 6"))},
        {"unadjusted", strstr(script, " lw 1.4 dt 4 ")},
        {"measured", at_load && strstr(script, " pt 5")},
        {"bound", at_load && strstr(script, " pt 6")},
        {"limit", at_load && strstr(script, "set label 'limit ")},
        {"scale_dependent", dotted && (strstr(script, "'6-09 ") || strcmp(name, "tcr") == 0)},
        {"last_scale", dotted && strcmp(name, "ecr") == 0},
        {"law", strstr(script, " lw 2.4 ")},
        {"bins", surfaces && strstr(script, " pt 7")},
        {"open_bins", surfaces && strstr(script, " pt 6")},
        {"knees", surfaces && strstr(script, " nohead ")},
        {"direct", direct || strstr(script, "direct solution")},
    };
    for (size_t f = 0; f < sizeof flags / sizeof *flags; f++)
        if (json_is_true(json_object_get(figure, flags[f].flag)) != flags[f].drawn)
            fail_msg("%s/%s: is '%s' %s", out, name, flags[f].flag, flags[f].drawn ? "not said" : "not drawn");
    numbers_in(numbers, sizeof numbers, script);
    const char *said = json_string_value(json_object_get(figure, "numbers"));
    assert_string_equal(said ? said : "", surfaces ? "6-10" : numbers);
}

/** No title of a panel reaches beyond the drawing's right edge, whatever font draws it. */
static void expect_titles_whole(const char *script)
{
    static const char margin[] = "set lmargin at screen ", title[] = "' at graph 0, screen ";
    for (const char *panel = script; (panel = strstr(panel, margin)); panel++) {
        const char *end = strstr(panel, title), *start = end;
        while (end && start[-1] != '\'')
            start--;
        double characters = 0;
        for (const char *c = start; end && c < end; c++)
            characters += (*c & 0xc0) != 0x80;
        if (800 * strtod(panel + strlen(margin), NULL) + 7.4 * characters > 800)
            fail_msg("cut off: %.60s", start);
    }
}

/** Makes a report and checks all its captions against its charts. */
static void expect_captions(const char *place, const char *directory, const char *out)
{
    run_to_exit(place, 0, "report", directory, "-o", out);
    json_t *view = workspace_json(place, filled("%s/view.json", out)), *figure;
    const char *name;
    json_object_foreach (json_object_get(view, "figures"), name, figure) {
        expect_flags(place, out, name, figure);
        expect_titles_whole(file_of(place, out, name, "gp"));
    }
}

TEST_IN_WORKSPACE(captions_say_what_is_drawn)
{
    expect_captions(place, PROJECT_SOURCE "/surfaces/connector", "connector");
    expect_in_file(place, "connector/report.md", "![Figures 6\\-05 to 6-09. as plated in every model",
                   "Shaded: ", "Gap versus load", "ECR versus load");
    workspace_shell(place,
                    "cp -r " PROJECT_SOURCE "/surfaces/chapter6 c6; sed -i 's/budget: 3 s/budget: 400 ms/' c6/s*.yaml");
    expect_captions(place, "c6", "tin");
    expect_in_file(place, "tin/report.md", "Figures 6\\-01 to 6-04. ", "Figures 6\\-05 to 6-09. ",
                   "Figures 6\\-11 to 6-14. ", "dashed outside", "dotted: TCR scale-dependent",
                   "statistical gaps adjusted (dot-dash: not)", "up to 99 % contact",
                   "TCR versus load, up to 99 % contact; dotted: scale-dependent; dashed outside");
    /* no model leaves the axis of its ratio to the direct solution */
    struct table ratios = workspace_table(place, "tin/data/direct_ratio.csv");
    char *script = file_of(place, "tin", "direct", "gp"), *high;
    double least = strtod(strstr(script, "set yrange [") + strlen("set yrange ["), &high),
           most = strtod(high + 1, NULL);
    for (size_t r = 0; r < ratios.rows; r++)
        for (int q = 0; q < 3; q++) {
            double ratio = table_number(&ratios, r, (const char *[]){"area", "gap", "ecr"}[q]);
            if (ratio > 0 && (ratio < least || ratio > most)) /* 0: an empty cell */
                fail_msg("%g is not in %g to %g", ratio, least, most);
        }
    /* elastic models alone, at loads so light that no curve ends */
    workspace_scans(place, "d", 2, 400, 1);
    workspace_write(place, "d/scene.yaml",
                    "material: tin\nmodels: [gw, multiscale-elastic]\nload: {from: 1e-7, to: 1e-6, points: 5}\n"
                    "effects: [separation, electrical, thermal, convergence]\n");
    expect_captions(place, "d", "light");
    expect_in_file(place, "light/report.md", "Figures 6\\-01, 6-03. ", "Figures 6\\-05 to 6-09. ",
                   "Figures 6\\-12, 6-14. ", "![Figures 6\\-28, 6-30. TCR versus load.]");
    expect_not_in_file(place, "light/report.md", "Shaded", "dotted: ", "99 % contact");
}

/** The first row of the `index`th block of a chart's data. */
static const char *block_of(const char *data, int index)
{
    for (; index > 0; index--)
        data = strstr(data, "\n\n\n") + 3;
    return strchr(data, '\n') + 1;
}

/** How many rows the curves have that a script draws with point type `type`, and the colour of the last. */
static size_t rows_of_points(const char *script, const char *data, int type, char colour[8])
{
    char wanted[20];
    size_t rows = 0;
    snprintf(wanted, sizeof wanted, " pt %d", type);
    for (const char *at = script; (at = strstr(at, "csv' index ")); at++) {
        const char *end = at + strcspn(at, "\n"), *marked = strstr(at, wanted);
        if (!marked || marked > end)
            continue;
        snprintf(colour, 8, "%s", strstr(at, "rgb '") + strlen("rgb '"));
        const char *row = block_of(data, atoi(at + strlen("csv' index ")));
        for (; *row && *row != '\n'; row = strchr(row, '\n') + 1)
            rows++;
    }
    return rows;
}

/* A direct solution is drawn in its surface's colour, with open marks where few points of its grid touch. */
TEST_IN_WORKSPACE(direct_solutions_are_of_their_surface)
{
    workspace_scans(place, "d", 2, 400, 3);
    for (int some = 0; some < 2; some++) {
        char colour[8] = "", open_colour[8] = "";
        report_scene(place, "out",
                     filled("material: tin\nbaseline: b\nmodels: [strip, gw]\neffects: [separation, electrical]\n"
                            "direct: {grid: 64, seeds: 2, loads: [%s6e-3, 1e-2]}\noperating_load: 1e-2\n",
                            some ? "2.5e-4, 3e-4, " : ""));
        struct table table = workspace_table(place, "out/data/direct.csv");
        size_t few = 0, many = 0;
        for (size_t r = 0; r < table.rows; r++) {
            double touching = table_number(&table, r, "area_ratio") * 64 * 64;
            few += touching < 200;
            many += touching >= 200;
        }
        char *script = file_of(place, "out", "answer", "gp"), *data = file_of(place, "out", "answer", "csv");
        assert_int_equal(rows_of_points(script, data, 5, colour), many);
        assert_int_equal(rows_of_points(script, data, 4, open_colour), few);
        assert_int_equal(few > 0, some);
        assert_true(many > 0);
        expect_part(script, "'direct solution of b'");
        expect_part(data, "# b\n");
        expect_part(script, filled("lines lc rgb '%s' lw 2.6 dt 1 title 'b'", colour));
        expect_in_file(place, "out/figures/models.gp", "'direct solution'");
        script = file_of(place, "out", "direct", "gp");
        data = file_of(place, "out", "direct", "csv");
        assert_int_equal(rows_of_points(script, data, 6, open_colour) > 0, some);
        char *report = workspace_read(place, "out/report.md");
        assert_int_equal(strstr(report, "pen squares: fewer than 200 points of the grid touch.") != NULL, some);
        assert_int_equal(strstr(report, "; open: fewer than 200 points of the grid touch.") != NULL, some);
    }
}

/** Most of the first and second numbers of the `index`th block of a chart. */
static void block_most(double out[2], const char *data, int index)
{
    out[0] = out[1] = 0;
    for (data = block_of(data, index); *data && *data != '\n'; data = strchr(data, '\n') + 1) {
        double x, y;
        assert_int_equal(sscanf(data, "%lf,%lf", &x, &y), 2);
        out[0] = fmax(out[0], x);
        out[1] = fmax(out[1], y);
    }
}

/* A panel draws in the units of its labels: profile and spectrum are those of data/, which are in SI. */
TEST_IN_WORKSPACE(panels_are_in_the_units_of_their_labels)
{
    run_to_exit(place, 0, "synth", "--points", "400", "--length", "0.4mm", "-o", "s.csv");
    workspace_shell(place, "mkdir -p d; mv s.csv d");
    run_to_exit(place, 0, "report", "d", "-m", "tin", "-o", "out", "--no-cost");
    char *data = file_of(place, "out", "surfaces", "csv"), *script = file_of(place, "out", "surfaces", "gp");
    struct table spectrum = workspace_table(place, "out/data/spectrum.csv"), scan = workspace_table(place, "d/s.csv");
    double most[2] = {0, 0}, drawn[2], high = 0;
    for (size_t r = 0; r < spectrum.rows; r++) {
        most[0] = fmax(most[0], table_number(&spectrum, r, "wavelength_m"));
        most[1] = fmax(most[1], table_number(&spectrum, r, "amplitude_m"));
    }
    for (size_t r = 0; r < scan.rows; r++)
        high = fmax(high, strtod(scan.cell[(r + 1) * scan.columns + 1], NULL)); /* um */
    expect_parts(script, "position (mm)", "height (µm)", "wavelength (µm)", "amplitude (µm)");
    block_most(drawn, data, 0);
    assert_near(drawn[0], 0.399, 0.01);
    assert_near(drawn[1], high, 0.1); /* level */
    block_most(drawn, data, 1);
    assert_near(drawn[0], most[0] * 1e6, 1e-6);
    assert_near(drawn[1], most[1] * 1e6, 1e-6);
    block_most(drawn, data, 2); /* the bins of the fit */
    assert_true(drawn[0] < most[0] * 1e6 && drawn[0] > most[0] * 1e5);
}

/** The four numbers in the first row of the `index`th block of a chart. */
static void block_numbers(double out[4], const char *data, int index)
{
    assert_int_equal(sscanf(block_of(data, index), "%lf,%lf,%lf,%lf", &out[0], &out[1], &out[2], &out[3]), 4);
}

/* One surface alone has no such chart. Of several the best is on top; a measured value is a square, a limit a line; of
 * more than twenty only the ten best and the ten worst are drawn. */
TEST_IN_WORKSPACE(surfaces_stand_in_rows)
{
    static const char scene[] =
        "material: tin\nnominal_area: 1 mm2\nmodels: [strip-plastic]\n"
        "load: {from: 0.1 N, to: 10 N, points: 9}\noperating_load: 1 N\ntargets: [{ecr: 5 mohm}]\n";
    workspace_scan(place, "d/s01.csv", 400, 1);
    workspace_write(place, "d/scene.yaml", scene);
    run_to_exit(place, 0, "report", "d", "-o", "out", "--no-cost", "--brief");
    assert_false(workspace_has(place, "out/figures/surfaces-at-load.svg"));
    expect_not_in_file(place, "out/report.md", "Each surface at the operating load", "models.svg");
    for (int k = 2; k <= 23; k++)
        workspace_scan(place, filled("d/s%02d.csv", k), 400, (unsigned)k);
    report_scene(place, "out", NULL);
    char *script = file_of(place, "out", "surfaces-at-load", "gp"),
         *data = file_of(place, "out", "surfaces-at-load", "csv");
    assert_int_equal(times(script, "with xerrorbars"), 20);
    expect_parts(script, "'… 3 others'", "set logscale x", "contact resistance at the operating load (mΩ)");
    expect_no_parts(script, "'limit ", " pt 5", " pt 6");
    struct table contact = workspace_table(place, "out/data/contact.csv");
    double best = INFINITY, worst = 0, row[4], before = 0;
    for (size_t r = 0; r < contact.rows; r++) {
        double ecr = table_number(&contact, r, "ecr_ohm_m2");
        if (fabs(table_number(&contact, r, "pressure_Pa") / 1e6 - 1) < 1e-6) {
            best = fmin(best, ecr);
            worst = fmax(worst, ecr);
        }
    }
    for (int k = 0; k < 20; k++) {
        block_numbers(row, data, k);
        assert_true(before <= row[0] && row[2] < row[0] && row[0] < row[3] && row[1] == 21 - k - (k >= 10));
        before = row[0];
        if (k % 19 == 0)
            assert_near(row[0] * 1e-9, k ? worst : best, 1e-5);
    }
    expect_in_file(place, "out/report.md", "![Each surface at the operating load, 95 % interval.](");
    /* the measured one, and a limit on what is asked */
    workspace_write(place, "d/ecr.txt", "F (N);R (mohm)\n0.5;9\n1;5\n2;3\n");
    report_scene(place, "out",
                 filled("%slimits: {ecr: {most: 7 mohm}, area: {least: 1e-3}}\nsurfaces:\n  - {name: a, file: s01.csv, "
                        "measured: {file: ecr.txt, quantity: ecr}}\n  - {name: b, file: s02.csv}\n",
                        scene));
    script = file_of(place, "out", "surfaces-at-load", "gp");
    assert_int_equal(times(script, " pt 5"), 1);
    assert_int_equal(times(script, "set label 'limit "), 1);
    expect_parts(script, "arrow from 7, graph 0 to 7,", "'limit 7\u00a0mΩ' at screen ");
    data = file_of(place, "out", "surfaces-at-load", "csv");
    block_numbers(row, data, strstr(script, " pt 5") < strstr(script, " pt 7") ? 0 : 1);
    assert_near(row[0], 5, 1e-6);
    expect_in_file(place, "out/report.md", "interval; square: measured; line: the limit.](");
}

/* Each model is drawn with its interval, hollow where it is outside its range: CMY beyond P/H = 0.1. */
TEST_IN_WORKSPACE(models_have_intervals_and_ranges)
{
    workspace_scan(place, "d/a.csv", 400, 3);
    for (int outside = 0; outside < 2; outside++) {
        report_scene(place, "out",
                     filled("material: tin\nload: {from: 0.1 MPa, to: 30 MPa, points: 9}\noperating_load: %s\n",
                            outside ? "8 MPa" : "1 MPa"));
        char *script = file_of(place, "out", "models", "gp"), *report = workspace_read(place, "out/report.md");
        const char *section = strstr(report, "## One surface, every model"),
                   *chart = strstr(report, "(figures/models.svg)");
        assert_true(section && chart > section);
        size_t overloaded = times(report, ") ¶ |"); /* elastic, of which no error is known */
        assert_true(overloaded > 0);
        assert_int_equal(times(script, "with xerrorbars"), 9 - overloaded);
        assert_int_equal(times(script, " pt 6") > 0, outside);
        assert_int_equal(strstr(report, "hollow: outside the model's range of validity") != NULL, outside);
        assert_int_equal(times(script, " pt 6"), times(report, ") †"));
        expect_in_file(place, "out/report.html", "<a href=\"#cmy\">CMY</a>",
                       "<strong>CMY</strong><a id=\"cmy\"></a></td>", "<a href=\"#strip-transfer-with-hardness\">",
                       "<a id=\"strip-transfer-with-hardness\"></a>");
        expect_parts(report, "(truncation) | Cooper",
                     "by strip transfer with hardness, which solves the scans as strips");
    }
}

/* Where a gap is adjusted, the chart also shows it unadjusted, so that the effect of beta can be seen. */
TEST_IN_WORKSPACE(gaps_stand_adjusted_and_not)
{
    workspace_scans(place, "d", 2, 400, 3);
    for (int statistical = 0; statistical < 2; statistical++) {
        report_scene(place, "out",
                     filled("material: tin\nmodels: [%smultiscale]\neffects: [plasticity, separation]\n",
                            statistical ? "jg, " : ""));
        char *script = file_of(place, "out", "one-surface", "gp"), *data = file_of(place, "out", "one-surface", "csv");
        assert_int_equal(times(script, " lw 1.4 dt 4 "), statistical ? 2 : 0);
        assert_int_equal(times(file_of(place, "out", "separation-load", "gp"), " lw 1.4 dt 4 "), statistical ? 2 : 0);
        char *report = workspace_read(place, "out/report.md");
        assert_int_equal(times(report, "(dot-dash: not)"), statistical ? 3 : 0);
        assert_int_equal(strstr(report, "| β of JG, full contact | β of JG, multiscale elastic-plastic |") != NULL,
                         statistical);
        struct table contact = workspace_table(place, "out/data/contact.csv");
        static const char *const columns[] = {"separation_over_sigma", "adjusted_separation_over_sigma"};
        size_t r = 0;
        while (statistical && (strcmp(table_text(&contact, r, "model"), "jg") != 0 ||
                               strcmp(table_text(&contact, r, "surface"), "b") != 0))
            r++;
        for (int c = 0; c < 2 * statistical; c++)
            expect_part(data, filled("%.9g,%.9g\n", table_number(&contact, r, "load_over_AnEp"),
                                     table_number(&contact, r, columns[c])));
    }
}

/* The factor of the table is the one of the chart; no time is below 0. */
TEST_IN_WORKSPACE(accuracy_is_a_factor)
{
    workspace_scan(place, "d/a.csv", 400, 1);
    workspace_write(place, "d/scene.yaml", "material: copper\neffects: [plasticity, thermal]\n");
    run_to_exit(place, 0, "report", "d", "-o", "out");
    char *report = workspace_read(place, "out/report.md"), *data = file_of(place, "out", "accuracy", "csv");
    const char *row = strstr(report, "| CMY | ×÷ "), *block = strstr(data, "# CMY\n");
    double seconds, factor;
    assert_true(row && block);
    assert_int_equal(sscanf(block, "# CMY\n%lf,%lf", &seconds, &factor), 2);
    assert_near(factor, strtod(row + strlen("| CMY | ×÷ "), NULL), 0.06);
    for (block -= 3; block[-1] != '\n';) /* the line that ends in that mark */
        block--;
    assert_int_equal(sscanf(block, "%lf,%lf", &seconds, &factor), 2);
    assert_true(seconds > 0);
    assert_near(factor, strtod(row + strlen("| CMY | ×÷ "), NULL), 0.06);
    expect_no_parts(report, "takes −", "takes -");
    expect_part(file_of(place, "out", "accuracy", "gp"), "95 % error of contact conductance (×÷)");
}

/* Measured points are filled on loading and open on unloading, in their surface's colour and over all lines; the legend
 * names the surface where several were measured. The marks of target and operating load give their values. */
TEST_IN_WORKSPACE(measured_points_are_of_their_surface)
{
    static const char test[] = "F (N);R (mohm)\n1;900\n2;500\n4;300\n6;200\n4;220\n2;320\n";
    workspace_scans(place, "d", 2, 400, 3);
    workspace_write(place, "d/ecr.txt", test);
    for (int both = 0; both < 2; both++) {
        char filled_in[8] = "", open[8] = "";
        report_scene(place, "out",
                     filled("material: tin\nnominal_area: 1 mm2\nbaseline: b\nmodels: [strip, gw]\n"
                            "load: {from: 1 N, to: 10 N, points: 9}\noperating_load: 2 N\ntargets: [{ecr: 2.5 mohm}]\n"
                            "measured: {file: ecr.txt, quantity: ecr}\nsurfaces:\n"
                            "  - {name: a, file: a.csv%s}\n  - {name: b, file: b.csv}\n",
                            both ? ", measured: {file: ecr.txt, quantity: ecr}" : ""));
        char *script = file_of(place, "out", "answer", "gp"), *data = file_of(place, "out", "answer", "csv");
        assert_int_equal(rows_of_points(script, data, 7, filled_in), both ? 8 : 4);
        assert_int_equal(rows_of_points(script, data, 6, open), both ? 4 : 2);
        expect_parts(script, "'target 2.5\u00a0mΩ'", "'operating load 2.00\u00a0N'",
                     both ? "'measured on a, loading'" : "'measured, loading'",
                     both ? "'measured on b, unloading'" : "'measured, unloading'",
                     filled("lines lc rgb '%s' lw 2.6 dt 1 title 'b'", filled_in));
        assert_string_equal(filled_in, open);
        const char *dots = strstr(script, "yerrorbars"), *line = strstr(dots, "with lines");
        assert_true(line > strstr(dots, "# The legend")); /* no line is drawn over them */
    }
}

/* The sweeps are at a load where they differ: if the metal yields from the first scale on, they coincide. */
TEST_IN_WORKSPACE(sweeps_that_yield_are_told_apart)
{
    workspace_scan(place, "d/a.csv", 300, 1);
    report_scene(place, "o", "material: tin\nmodels: [multiscale]\neffects: [plasticity, convergence]\n");
    struct table sweeps = workspace_table(place, "o/data/convergence.csv");
    double least = 1, most = 0;
    for (size_t r = 0; r < sweeps.rows; r++)
        if (strcmp(table_text(&sweeps, r, "model"), "multiscale-plastic") == 0 &&
            strcmp(table_text(&sweeps, r, "sweep"), "alpha") == 0) {
            least = fmin(least, table_number(&sweeps, r, "area_ratio"));
            most = fmax(most, table_number(&sweeps, r, "area_ratio"));
        }
    assert_true(least < 0.1 && most > 2 * least);
    char *script = file_of(place, "o", "convergence", "gp");
    expect_parts(script, "α: multiscale elastic at 0.0010'", "γ: multiscale elastic-plastic at 8.4·10⁻⁶'",
                 " dt 1 title 'α = ", " dt 4 title 'γ = "); /* 4 is gnuplot's dot-dash */
    expect_in_file(place, "o/report.md", "in each panel; α solid, γ dot-dash.]");
}

/* A report on one surface has the charts that repeat the first page, and gap against area, in its appendix; with two
 * surfaces all panels are together. */
TEST_IN_WORKSPACE(one_surface_repeats_nothing)
{
    workspace_scan(place, "d/a.csv", 300, 1);
    run_to_exit(place, 0, "report", "d", "-m", "tin", "--no-cost", "-o", "o");
    char *report = workspace_read(place, "o/report.md"), *appendix = strstr(report, "# Appendices");
    expect_parts(report, "![Figures 6\\-05, 6-07, 6-09.");
    expect_parts(appendix, "![Figures 6\\-06, 6-08.", "(figures/one-surface-more.svg)");
    workspace_scan(place, "d/b.csv", 300, 2);
    run_to_exit(place, 0, "report", "d", "-m", "tin", "--no-cost", "-o", "o");
    expect_in_file(place, "o/report.md", "![Figures 6\\-05 to 6-09.");
    assert_false(workspace_has(place, "o/figures/one-surface-more.svg"));
}

/* The heating changes the temperature in its last digits only; the axis still has a range. */
TEST_IN_WORKSPACE(a_temperature_that_hardly_changes)
{
    static const char *const lightest[] = {"3e4", "5e4"};
    workspace_scan(place, "d/a.csv", 400, 1);
    for (size_t l = 0; l < sizeof lightest / sizeof *lightest; l++) {
        report_scene(
            place, "out",
            filled("material: copper\nnominal_area: 1e3 m2\ncurrent: 1 A\ngap: {gas: vacuum, temperature: 1000 K}\n"
                   "plating: {metal: tin, thickness: 3 um, resistivity: 1.1e-7 ohm m}\n"
                   "load: {from: %s N, to: 1e9 N, points: 41}\n"
                   "effects: [plasticity, separation, thermal, electrical, gap, plating, heating]\n",
                   lightest[l]));
        expect_in_file(place, "out/figures/joint.gp", "set yrange [654.165:799.535]");
    }
}

/* At 400 px the first three columns of the table are on the screen and no chart is cut; at 1400 px no table is cut. */
TEST_IN_WORKSPACE(charts_and_tables_are_whole)
{
    char program[4096], frame[4300];
    if (!program_find(program, sizeof program, "chromium"))
        skip();
    run_to_exit(place, 0, "report", PROJECT_SOURCE "/surfaces/connector", "-o", "out", "--no-cost");
    workspace_write(
        place, "frame.html",
        "<iframe id=f src=out/report.html width=400 height=800 style=border:0></iframe>\n"
        "<iframe id=d src=out/report.html width=1400 height=800 style=border:0></iframe><script>\n"
        "onload = () => { const tables = [...d.contentDocument.querySelectorAll('.table')];\n"
        "const wide = tables.filter(one => one.scrollWidth > one.clientWidth).length; const page = "
        "f.contentDocument, figures = [...page.querySelectorAll('figure')];\n"
        "const cut = figures.filter(one => one.scrollWidth > one.clientWidth).length;\n"
        "document.title = `${figures.length} charts, ${cut} cut, page ${page.documentElement.scrollWidth}, `"
        "+ `answer ${page.querySelector('th:nth-child(3)').getBoundingClientRect().right <= 400}`"
        " + (tables.length > 4 ? `, ${wide} tables cut` : '');\n"
        "};</script>\n");
    snprintf(frame, sizeof frame, "file://%s/frame.html", place);
    struct process shown = run_program(place, "chromium", "--headless", "--no-sandbox", "--disable-gpu",
                                       "--hide-scrollbars", "--allow-file-access-from-files", "--dump-dom", frame);
    expect_output(shown, " charts, 0 cut, page 400, answer true, 0 tables cut</title>");
}
