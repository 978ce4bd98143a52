/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The charts of whole reports: each caption says what is drawn and no more, the direct solution is where it belongs,
 * and the page shows a chart whole on a telephone. */
#include "base/program.h"
#include "cli/process.h"

/** A file of a chart. To be freed. */
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

/** Makes a report and holds all its captions against its charts. */
static void expect_captions(const char *place, const char *directory, const char *out)
{
    run_to_exit(place, 0, "report", directory, "-o", out);
    json_t *view = workspace_json(place, filled("%s/view.json", out)), *figure;
    const char *name;
    json_object_foreach(json_object_get(view, "figures"), name, figure)
    {
        expect_flags(place, out, name, figure);
        expect_titles_whole(file_of(place, out, name, "gp"));
    }
}

TEST_IN_WORKSPACE(captions_say_what_is_drawn)
{
    expect_captions(place, PROJECT_SOURCE "/surfaces/connector", "connector");
    expect_in_file(place, "connector/report.md", "![Figures 6\\-05 to 6-09. as plated in every model",
                   "Shaded: ", "Gap versus load", "ECR versus load");
    expect_captions(place, PROJECT_SOURCE "/surfaces/chapter6", "tin");
    expect_in_file(place, "tin/report.md", "Figures 6\\-01 to 6-04. ", "Figures 6\\-05 to 6-09. ",
                   "Figures 6\\-11 to 6-14. ", "dashed outside", "dotted: TCR scale-dependent",
                   "statistical gaps adjusted, dot-dash: not adjusted", "up to 99 % contact",
                   "TCR versus load, up to 99 % contact; dotted: scale-dependent.");
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
    /* an elastic model of the thesis alone, two surfaces too smooth for it to end, at light loads */
    workspace_scan(place, "d/a.csv", 400, 1);
    workspace_scan(place, "d/b.csv", 400, 2);
    workspace_write(place, "d/scene.yaml",
                    "material: tin\nmodels: [gw, multiscale-elastic]\nload: {from: 1e-7, to: 1e-6, points: 5}\n"
                    "effects: [separation, electrical, thermal, convergence]\n");
    expect_captions(place, "d", "light");
    expect_in_file(place, "light/report.md", "Figures 6\\-01, 6-03. ", "Figures 6\\-05 to 6-09. ",
                   "Figures 6\\-12, 6-14. ", "![Figures 6\\-28, 6-30. TCR versus load.]");
    expect_not_in_file(place, "light/report.md", "Shaded", "dotted: ", "99 % contact");
}

/** How many rows the curves have that a script draws with point type `type`, and their colour if it is of all. */
static size_t rows_of_points(const char *script, const char *data, int type, char colour[8])
{
    char wanted[20];
    size_t rows = 0;
    snprintf(wanted, sizeof wanted, " pt %d", type);
    for (const char *at = script; (at = strstr(at, "csv' index ")); at++) {
        const char *end = at + strcspn(at, "\n"), *marked = strstr(at, wanted), *block = data;
        if (!marked || marked > end)
            continue;
        snprintf(colour, 8, "%s", strstr(at, "rgb '") + strlen("rgb '"));
        for (int i = atoi(at + strlen("csv' index ")); i > 0; i--)
            block = strstr(block, "\n\n\n") + 3;
        for (block = strchr(block, '\n') + 1; *block && *block != '\n'; block = strchr(block, '\n') + 1)
            rows++;
    }
    return rows;
}

/* A direct solution has its surface's colour, and is open where few points of its grid touch. */
TEST_IN_WORKSPACE(direct_solutions_are_of_their_surface)
{
    workspace_scan(place, "d/a.csv", 400, 3);
    workspace_scan(place, "d/b.csv", 400, 4);
    for (int some = 0; some < 2; some++) {
        char colour[8] = "", open_colour[8] = "";
        workspace_write(place, "d/scene.yaml",
                        filled("material: tin\nbaseline: b\nmodels: [strip, gw]\neffects: [separation, electrical]\n"
                               "direct: {grid: 64, seeds: 2, loads: [%s6e-3, 1e-2]}\n",
                               some ? "2.5e-4, 3e-4, " : ""));
        run_to_exit(place, 0, "report", "d", "-o", "out", "--no-cost");
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
        const char *line = strstr(data, "# b\n");
        assert_non_null(line);
        expect_part(script, filled("lines lc rgb '%s' lw 2.6 dt 1 title 'b'", colour));
        script = file_of(place, "out", "direct", "gp");
        data = file_of(place, "out", "direct", "csv");
        assert_int_equal(rows_of_points(script, data, 6, open_colour) > 0, some);
        char *report = workspace_read(place, "out/report.md");
        assert_int_equal(strstr(report, "pen squares: fewer than 200 points of the grid touch.") != NULL, some);
        assert_int_equal(strstr(report, "; open: fewer than 200 points of the grid touch.") != NULL, some);
    }
}

/* What a contact is heated by comes to a few units in the last place of its temperature. */
/* What was measured is filled on loading and open on unloading, in its surface's colour, over all lines, and named for
 * it where others were measured too; marks say their values. */
TEST_IN_WORKSPACE(measured_points_are_of_their_surface)
{
    static const char test[] = "F (N);R (mohm)\n1;900\n2;500\n4;300\n6;200\n4;220\n2;320\n";
    workspace_scan(place, "d/a.csv", 400, 3);
    workspace_scan(place, "d/b.csv", 400, 4);
    workspace_write(place, "d/ecr.txt", test);
    for (int both = 0; both < 2; both++) {
        char filled_in[8] = "", open[8] = "";
        workspace_write(
            place, "d/scene.yaml",
            filled("material: tin\nnominal_area: 1 mm2\nbaseline: b\nmodels: [strip, gw]\n"
                   "load: {from: 1 N, to: 10 N, points: 9}\noperating_load: 2 N\ntargets: [{ecr: 2.5 mohm}]\n"
                   "measured: {file: ecr.txt, quantity: ecr}\nsurfaces:\n"
                   "  - {name: a, file: a.csv%s}\n  - {name: b, file: b.csv}\n",
                   both ? ", measured: {file: ecr.txt, quantity: ecr}" : ""));
        run_to_exit(place, 0, "report", "d", "-o", "out", "--no-cost");
        char *script = file_of(place, "out", "answer", "gp"), *data = file_of(place, "out", "answer", "csv");
        assert_int_equal(rows_of_points(script, data, 7, filled_in), both ? 8 : 4);
        assert_int_equal(rows_of_points(script, data, 6, open), both ? 4 : 2);
        expect_parts(script, "'target 2.5\u00a0mΩ'", "'operating load 2.00\u00a0N'",
                     both ? "'measured on a, loading'" : "'measured, loading'",
                     both ? "'measured on b, unloading'" : "'measured, unloading'");
        expect_part(script, filled("lines lc rgb '%s' lw 2.6 dt 1 title 'b'", filled_in));
        assert_string_equal(filled_in, open);
        const char *dots = strstr(script, "yerrorbars"), *line = strstr(dots, "with lines");
        assert_true(line > strstr(dots, "# The legend")); /* no line is drawn over them */
    }
}

/* Sweeps of an elastic-plastic model that yields from the first scale on would lie on each other. */
TEST_IN_WORKSPACE(sweeps_that_yield_are_told_apart)
{
    workspace_scan(place, "d/a.csv", 300, 1);
    workspace_write(place, "d/scene.yaml", "material: tin\nmodels: [multiscale]\neffects: [plasticity, convergence]\n");
    run_to_exit(place, 0, "report", "d", "--no-cost", "-o", "o");
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
    expect_parts(script, "α: multiscale elastic at 0.0010'", "γ: multiscale elastic-plastic at 8.4·10⁻⁶'");
}

/* Of a report's only surface the chart of what the first page has drawn, and gap against area, are the appendix's; of
 * two all are together. */
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

TEST_IN_WORKSPACE(a_temperature_that_hardly_changes)
{
    static const char *const lightest[] = {"3e4", "5e4"};
    workspace_scan(place, "d/a.csv", 400, 1);
    for (size_t l = 0; l < sizeof lightest / sizeof *lightest; l++) {
        workspace_write(
            place, "d/scene.yaml",
            filled("material: copper\nnominal_area: 1e3 m2\ncurrent: 1 A\ngap: {gas: vacuum, temperature: 1000 K}\n"
                   "plating: {metal: tin, thickness: 3 um, resistivity: 1.1e-7 ohm m}\n"
                   "load: {from: %s N, to: 1e9 N, points: 41}\n"
                   "effects: [plasticity, separation, thermal, electrical, gap, plating, heating]\n",
                   lightest[l]));
        run_to_exit(place, 0, "report", "d", "-o", "out", "--no-cost");
        expect_in_file(place, "out/figures/joint.gp", "set yrange [654.165:799.535]");
    }
}

/* At 400 px every chart is whole, and nothing makes the page wider than its window. */
/* No chart is cut at 400 px, no table, not even 6.2 with its bands, at 1400 px. */
TEST_IN_WORKSPACE(charts_and_tables_are_whole)
{
    char program[4096], frame[4300];
    if (!program_find(program, sizeof program, "chromium"))
        skip();
    run_to_exit(place, 0, "report", PROJECT_SOURCE "/surfaces/connector", "-o", "out", "--no-cost");
    workspace_write(place, "frame.html",
                    "<iframe id=f src=out/report.html width=400 height=800 style=border:0></iframe>\n"
                    "<iframe id=d src=out/report.html width=1400 height=800 style=border:0></iframe><script>\n"
                    "onload = () => { const tables = [...d.contentDocument.querySelectorAll('.table')];\n"
                    "const wide = tables.filter(one => one.scrollWidth > one.clientWidth).length; const page = "
                    "f.contentDocument, figures = [...page.querySelectorAll('figure')];\n"
                    "const cut = figures.filter(one => one.scrollWidth > one.clientWidth).length;\n"
                    "document.title = `${figures.length} charts, ${cut} cut, page ${page.documentElement.scrollWidth}`"
                    " + (tables.length > 4 ? `, ${wide} tables cut` : '');\n"
                    "};</script>\n");
    snprintf(frame, sizeof frame, "file://%s/frame.html", place);
    const char *const dump[] = {"chromium",
                                "--headless",
                                "--no-sandbox",
                                "--disable-gpu",
                                "--hide-scrollbars",
                                "--allow-file-access-from-files",
                                "--dump-dom",
                                frame,
                                NULL};
    struct process shown = process_end(process_start_list(place, dump, NULL));
    expect_output(shown, " charts, 0 cut, page 400, 0 tables cut</title>");
}
