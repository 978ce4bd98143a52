/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A chart from its numbers to its drawing: ranges, tics, what is left out, and names that mean nothing in a script. */
#include "base/words.h"
#include "chart/chart.h"
#include "chart/gnuplot.h"
#include "directory.h"
#include "hard_case.h"

HARD_CASES("Charts")

#define PLACED(name) TEST_WITH(name, directory_setup, directory_teardown)

/* Is `text` well-formed as far as markup goes: quoted attributes, balanced elements, only known entities? */
static void assert_well_formed(const char *text)
{
    enum { DEEPEST = 64 };
    const char *open[DEEPEST];
    size_t length[DEEPEST], depth = 0, elements = 0;
    for (const char *c = text; *c; c++) {
        if (*c == '&')
            assert_true(strncmp(c, "&lt;", 4) == 0 || strncmp(c, "&amp;", 5) == 0 || strncmp(c, "&gt;", 4) == 0);
        assert_false((unsigned char)*c < 0x20 && !strchr("\t\r\n", *c));
        if (*c != '<')
            continue;
        const char *name = ++c;
        bool closing = *name == '/';
        name += closing;
        size_t size = strcspn(name, " \t\r\n/>");
        assert_true(size > 0);
        for (; *c && *c != '>'; c++) {
            assert_int_not_equal(*c, '<');
            if (*c == '"' || *c == '\'') {
                c = strchr(c + 1, *c);
                assert_non_null(c);
            }
        }
        assert_int_equal(*c, '>');
        if (*name == '?' || *name == '!' || c[-1] == '/')
            continue;
        if (closing) {
            assert_true(depth > 0);
            depth--;
            assert_int_equal(length[depth], size);
            assert_memory_equal(open[depth], name, size);
        } else {
            assert_true(depth < DEEPEST);
            open[depth] = name;
            length[depth++] = size;
            elements++;
        }
    }
    assert_int_equal(depth, 0);
    assert_true(elements > 5);
}

#define TEMPLATES(status)                                                                                              \
    {                                                                                                                  \
        PROJECT_SOURCE "/templates", ".gp", NULL, (status)                                                             \
    }

/** What a chart's script, or its text with letters, says. */
static const char *script_of(struct chart *chart, const char *terminal_size)
{
    struct text *out = support_text();
    struct status status = {0};
    OWNED(mustache_folder_free) struct mustache_folder folder = TEMPLATES(&status);
    if (chart_script(out, chart, &folder, terminal_size) != STATUS_OK)
        fail_msg("%s", status.message);
    return text_string(out);
}

/** Writes a chart into `place`, has gnuplot draw it, and takes what it drew. */
static const char *draw(const struct directory *place, struct chart *chart)
{
    struct status status = {0};
    struct gnuplot gnuplot;
    OWNED(mustache_folder_free) struct mustache_folder folder = TEMPLATES(&status);
    if (chart_write(chart, &folder, place->path) != STATUS_OK ||
        gnuplot_start(&gnuplot, place->path, &status) != STATUS_OK)
        fail_msg("%s", status.message);
    gnuplot_send(&gnuplot, filled("load '%s.gp'\n", chart->name));
    expect_ok(gnuplot_finish, &gnuplot);
    const char *svg = directory_read(place, filled("%s.svg", chart->name));
    assert_well_formed(svg);
    return svg;
}

static void line(struct chart *chart, const char *legend, const double (*points)[2], size_t count)
{
    chart_curve(chart, &(struct chart_curve){.legend = legend, .colour = "#1257d0"});
    for (size_t i = 0; i < count; i++)
        chart_row(chart, points[i][0], points[i][1], 0, 0);
}

/* From least to most, on a logarithmic axis or not: the tics. */
static const struct {
    double low, high;
    bool logarithmic;
    const char *tics;
} axes[] = {
    {1, 100, true, "('1' 1, '2' 2, '5' 5, '10' 10, '20' 20, '50' 50, '100' 100)"},
    {1e-6, 0.1, true, "('10⁻⁶' 1e-06, '10⁻⁵' 1e-05, '10⁻⁴' 0.0001, '0.001' 0.001, '0.01' 0.01, '0.1' 0.1)"},
    {1e-20, 1, true, "('10⁻¹⁸'"},
    {1e-200, 1e200, true, "('10⁻¹⁵⁴' 1e-154, '10⁻⁷⁷' 1e-77, '1' 1, "},
    {2e4, 5e4, true, "('2·10⁴' 20000, '5·10⁴' 50000)"},
    {0, 1, false, "('0' 0, '0.2' 0.2"},
    {-3, 3, false, "('−3' -3, '−2' -2"},
    {5, 5, true, "(Four"},
};

TEST_CASE(axes_have_few_tics_with_plain_numbers)
{
    for (size_t i = 0; i + 1 < sizeof axes / sizeof *axes; i++) {
        struct chart chart = chart_make("chart");
        const double points[][2] = {{axes[i].low, 1}, {axes[i].high, 2}};
        chart_panel(&chart, "", "x", "y", axes[i].logarithmic, false);
        line(&chart, "one", points, 2);
        const char *script = script_of(&chart, NULL);
        expect_parts(script, axes[i].tics);
        chart_free(&chart);
    }
}

/* However narrow or wide the data: a few tics, each with a number of its own. */
TEST_CASE(axes_of_any_range_have_few_tics)
{
    for (int power = -300; power <= 300; power += 25)
        for (int width = 0; width < 60; width++) /* from one unit in the last place to a million times the value */
            for (int kind = 0; kind < 3; kind++) {
                double low = (kind == 1 ? -1.37 : 1.37) * pow(10, power), high = low + ldexp(fabs(low), width - 52);
                const double points[][2] = {{low, 1}, {high, 2}};
                struct chart chart = chart_make("chart");
                chart_panel(&chart, "", "x", "y", kind == 2, false);
                line(&chart, "one", points, 2);
                const char *script = script_of(&chart, NULL);
                const char *at = strstr(script, "set xtics"), *before = "";
                assert_non_null(at);
                size_t tics = 0, length = strcspn(at, "\n");
                for (const char *end = at + length, *tic; (tic = strchr(at, '\'')) && tic < end; tics++) {
                    length = strcspn(tic + 1, "'");
                    if (strncmp(tic, before, length + 2) == 0)
                        fail_msg("%.17g to %.17g: two tics are %.*s", low, high, (int)length, tic + 1);
                    before = tic;
                    at = tic + length + 2;
                }
                assert_in_range(tics, 2, 25);
                hard_case("an axis over one unit in the last place, at 1e-300 to 1e300",
                          "thousands of tics, all with the same number", "few tics, each with a number of its own",
                          "tics", (double)tics, 25);
                chart_free(&chart);
            }
}

/** The number behind `name` in a script, from `at` on. */
static double setting(const char *at, const char *name)
{
    at = strstr(at, name);
    assert_non_null(at);
    return strtod(at + strlen(name), NULL);
}

/* Of any number of panels none is narrower than 300 nor lower than its axis's label is long, no label is cut off, and
 * the legend is below all that stands above it. */
TEST_CASE(panels_have_room)
{
    static const char label[] = "a label (W/(m²·K))";
    const double straight[][2] = {{1e-9, 1}, {10, 10}}, letter = 6.5, height_of_label = 16;
    for (int count = 1; count <= 9; count++)
        for (int shares = 0; shares < 2; shares++)
            for (int curves = 1; curves <= 17; curves += 4) {
                struct chart chart = chart_make("room");
                char name[17][40]; /* as long as the chart lives */
                chart.shares = shares;
                chart.panel_height = 40;
                for (int p = 0; p < count; p++) {
                    chart_panel(&chart, "title", p % 3 ? "x (m)" : "area", label, true, true);
                    for (int c = 0; c < curves; c++) {
                        snprintf(name[c], sizeof name[c], "curve of a model, number %d", c);
                        line(&chart, name[c], straight, 2);
                    }
                }
                const char *script = script_of(&chart, NULL);
                const char *at = script;
                double wide = setting(at, "size "), high = setting(at, "size 800,"), lowest = 1;
                assert_float_equal(wide, 800, 0);
                const bool centred = strstr(at, " center top horizontal");
                double beside = setting(at, "set key at screen "), legend = setting(strstr(at, "set key at"), ", ");
                for (int p = 0; p < count; p++) {
                    at = strstr(at, "set lmargin at screen") + 1;
                    double left = setting(at, "margin at screen "), right = setting(at, "rmargin at screen "),
                           bottom = setting(at, "bmargin at screen "), top = setting(at, "tmargin at screen ");
                    bool labelled = !strstr(at, "set xlabel ''") || strstr(at, "set xlabel ''") > strstr(at, "plot ");
                    assert_true(wide * (right - left) >= 300);
                    assert_true(high * (top - bottom) >= letter * (double)text_characters(label));
                    if (strstr(at, label) && strstr(at, label) < strstr(at, "plot "))
                        assert_true(wide * setting(at, "' at screen ") >= height_of_label / 2);
                    assert_true(left >= 0 && right <= 1 && bottom >= 0 && top <= 1);
                    double under = bottom - (labelled ? 44 : 20) / high; /* where its numbers, or its label, end */
                    if (right > beside || centred)
                        lowest = fmin(lowest, under);
                }
                const double rows = ceil(curves / setting(strstr(script, "maxcols "), "maxcols "));
                assert_true(curves == 0 || high * legend >= 22.6 * rows); /* none is cut off below */
                if (legend > lowest)
                    fail_msg("%d panels, %d curves: the legend begins at %g, what is above it ends at %g", count,
                             curves, legend, lowest);
                chart_free(&chart);
            }
}

/* Names on an axis and those of marks have their room, whatever font draws them: above the panel, beside each other, or
 * right of it. */
TEST_CASE(names_of_rows_and_marks_have_room)
{
    static const char row[] = "direct solution of the map with hardness", across[] = "operating load 0.475 N",
                      close[] = "limit 2 mΩ", target[] = "target 20000 W/(m²·K)";
    static const double letter = 7.6;
    for (int at = 0; at <= 10; at++) {
        struct chart chart = chart_make("names");
        chart_panel(&chart, "title", "x", "", false, false);
        chart_name_row(&chart, 1, row);
        chart_curve(&chart, &(struct chart_curve){.kind = CHART_POINTS, .legend = "", .colour = "#000000"});
        for (int x = 0; x <= 10; x++)
            chart_row(&chart, x, 1, 0, 0);
        chart_mark(&chart, true, at, across);
        chart_mark(&chart, true, at < 10 ? at + 0.1 : 9.9, close);
        if (at % 2)
            chart_mark(&chart, false, 1, target);
        const char *script = script_of(&chart, NULL);
        const char *drawn = script, *mark = strstr(drawn, across);
        double left = setting(drawn, "set lmargin at screen "), right = setting(drawn, "set rmargin at screen "),
               top = setting(drawn, "set tmargin at screen "), high = setting(drawn, "size 800,"),
               title = setting(strstr(drawn, "'title' at graph 0, "), "screen "), above = setting(mark, ", screen "),
               from = 800 * setting(mark, "at screen "), beside = 800 * setting(strstr(drawn, close), "at screen "),
               wide = letter * (double)text_characters(across);
        assert_true(800 * left >= letter * (double)text_characters(row));
        assert_true(at % 2 == 0 || 800 * (1 - right) >= letter * (double)text_characters(target));
        assert_true(high * (above - top) >= 8 && high * (title - above) >= 16 && high * (1 - title) >= 8);
        double close_wide = letter * (double)text_characters(close);
        assert_true(fmin(from, beside) >= 0 && fmax(from + wide, beside + close_wide) <= 800);
        assert_true(at < 10 ? from + wide <= beside : beside + close_wide <= from);
        assert_true(at < 2 || at > 7 ||
                    fabs(beside + close_wide / 2 - 800 * (left + (right - left) * (at + 0.1) / 10)) < 9);
        chart_free(&chart);
    }
}

/* Of too many panels the last takes the place of the one before; none is written behind the end. */
TEST_CASE(test_too_many_panels)
{
    struct chart chart = chart_make("many");
    for (int p = 0; p < CHART_PANELS + 3; p++) {
        chart_panel(&chart, filled("%d", p), "x", "y", false, false);
        chart_curve(&chart, &(struct chart_curve){.legend = "", .colour = "#000000"});
        chart_row(&chart, 1, p, 0, 0);
    }
    chart_end(&chart);
    assert_int_equal(chart.panels, CHART_PANELS);
    assert_string_equal(chart.panel[CHART_PANELS - 1].title, filled("%d", CHART_PANELS + 2));
    assert_int_equal(chart.blocks, CHART_PANELS + 3);
    chart_free(&chart);
}

TEST_CASE(what_an_axis_cannot_show_is_left_out)
{
    struct chart chart = chart_make("chart");
    const double points[][2] = {{0, 1}, {1, 0}, {1, NAN}, {INFINITY, 1}, {10, -2}}, seen[][2] = {{2, 3}, {4, 5}};
    chart_panel(&chart, "", "x", "y", true, true);
    line(&chart, "nothing of this", points, 5);
    line(&chart, "one", seen, 2);
    chart_end(&chart);
    assert_string_equal(text_string(&chart.data), "# one\n2,3\n4,5\n");
    assert_int_equal(chart.blocks, 1);
    chart_free(&chart);
    chart = chart_make("empty");
    chart_panel(&chart, "", "x", "y", true, true);
    chart_end(&chart);
    assert_int_equal(chart.blocks, 0);
    chart_free(&chart);
}

PLACED(every_kind_is_drawn_where_it_should)
{
    struct chart chart = chart_make("kinds");
    const double straight[][2] = {{1, 1}, {10, 10}};
    for (int p = 0; p < 5; p++) {
        chart_panel(&chart, p == 0 ? "one" : "other", "x (m)", "y", true, true);
        line(&chart, "line", straight, 2);
        for (int kind = CHART_BAND; kind < CHART_KINDS; kind++) {
            chart_curve(&chart, &(struct chart_curve){
                                    .kind = (enum chart_kind)kind, .legend = "more", .colour = "#cc5500", .marker = 6});
            chart_row(&chart, 2, 3, kind == CHART_DOTS ? 1 : 2, 5);
            chart_row(&chart, 4, 5, kind == CHART_DOTS ? 2 : 4, 8);
        }
        chart_mark(&chart, true, 3, "here");
        chart_mark(&chart, false, 7, "there");
    }
    expect_parts(draw(*state, &chart), "one", "other", "here", "there", "line", "more", "x (m)");
    expect_parts(script_of(&chart, "80,24"), "set terminal dumb size 80,24");
    chart_free(&chart);
}

PLACED(panels_that_share_their_axes_have_one_range)
{
    struct chart chart = chart_make("shared");
    const double low[][2] = {{1, 1}, {2, 2}}, high[][2] = {{100, 5}, {200, 8}};
    chart.shares = true;
    chart_panel(&chart, "", "x", "y", true, false);
    line(&chart, "low", low, 2);
    chart_panel(&chart, "", "x", "y", true, false);
    line(&chart, "high", high, 2);
    const char *script = script_of(&chart, NULL);
    const char *first = strstr(script, "set xrange ["), *second = strstr(first + 1, "set xrange [");
    assert_memory_equal(first, second, strcspn(first, "\n"));
    (void)draw(*state, &chart);
    chart_free(&chart);
}

/* Names from outside act neither in the script nor in the drawing. */
PLACED(hostile_names_mean_nothing)
{
    static const char *const names[] = {"'; system('touch owned'); '",
                                        "`touch owned`",
                                        "\"; exit; \"",
                                        "@macro $x %d",
                                        "ends in \\",
                                        "a]]><script>alert(1)</script>",
                                        "γ_{x}^2 {/Bold b}",
                                        "line\nbreak \x1b[31m \xff"};
    struct chart chart = chart_make("hostile");
    const double points[][2] = {{1, 1}, {2, 2}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        chart_panel(&chart, names[i], names[i], names[i], false, false);
        line(&chart, names[i], points, 2);
        chart_mark(&chart, true, 1.5, names[i]);
    }
    const char *svg = draw(*state, &chart);
    expect_parts(svg, "`touch owned`");
    expect_parts(svg, "γ_{x}^2 {/Bold b}");
    assert_null(strstr(svg, "<script"));
    assert_false(directory_has(*state, "owned"));
    chart_free(&chart);
}

TEST_CASE(a_script_that_is_not_there_is_an_error)
{
    struct chart chart = chart_make("chart");
    struct text *out = support_text();
    struct status status = {0};
    const double points[][2] = {{1, 1}, {2, 2}};
    OWNED(mustache_folder_free) struct mustache_folder folder = {"/no-such-folder", ".gp", NULL, &status};
    chart_panel(&chart, "", "x", "y", false, false);
    line(&chart, "one", points, 2);
    assert_int_equal(chart_script(out, &chart, &folder, NULL), STATUS_IO);
    assert_non_null(strstr(status.message, "/no-such-folder/charts/panels.gp"));
    chart_free(&chart);
}

/** What `words`, as words.txt, say of `name`; NULL: an error. */
static const char *said(const struct directory *place, const char *words, const char *name, struct status *status)
{
    struct words read;
    directory_write(place, "words.txt", words);
    assert_int_equal(words_read(&read, place->path, status), STATUS_OK);
    const char *out =
        lasting("%s", words_say(&read, "%s\n%s\nunit %c\nscan %d\nscan 2\nscan 3\nfile\ta b\nbest", name, "", 'N', 1));
    words_free(&read);
    return out;
}

PLACED(words_are_filled_in_by_name)
{
    static const char words[] = "# of axes\naxis.force  load ({{unit}}){{#best}}, best{{/best}}\naxis\tjust this\n"
                                "scans  {{#scan}}{{.}}, {{/scan}}{{file}}\n";
    struct status status = {0}, missing = {0}, wrong = {0};
    struct words read;
    assert_string_equal(said(*state, words, "axis.force", &status), "load (N)");
    assert_string_equal(said(*state, words, "axis", &status), "just this");
    assert_string_equal(said(*state, words, "scans", &status), "1, 2, 3, a b\nbest"); /* behind a tab all is one text */
    assert_string_equal(said(*state, words, "axis.force\nbest", &status), "load (N), best");
    assert_int_equal(status.code, STATUS_OK);
    assert_string_equal(said(*state, words, "axis.f", &missing), "");
    assert_int_equal(missing.code, STATUS_USAGE);
    assert_non_null(strstr(missing.message, "words.txt of the templates has no 'axis.f'"));
    assert_string_equal(said(*state, "a {{#unit}}\n", "a", &wrong), "");
    assert_int_equal(wrong.code, STATUS_USAGE);
    expect_fails(STATUS_IO, "", words_read, &read, "/no-such-folder");
    words_free(&read);
}

/* A long name is cut in its middle, by characters. */
TEST_CASE(names_are_cut_in_their_middle)
{
    struct text *out = support_text();
    words_cut(out, "µµµµµfffggggg", strlen("µµµµµfffggggg"), 10);
    assert_string_equal(text_string(out), "µµµµµ…gggg");
    assert_int_equal(text_width(text_string(out), out->length), 10);
}
