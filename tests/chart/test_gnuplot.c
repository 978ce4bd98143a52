/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/program.h"
#include "base/text.h"
#include "chart/gnuplot.h"
#include "directory.h"

#include <expat.h>
#include <fcntl.h>
#include <signal.h>

#define PLACED(name) TEST_WITH(name, directory_setup, directory_teardown)

/* Sends `commands` to one gnuplot and returns how it ended. */
static enum status_code run(const struct directory *place, const char *commands, struct status *status)
{
    struct gnuplot gnuplot;
    enum status_code code = gnuplot_start(&gnuplot, place->path, status);
    if (code)
        return code;
    gnuplot_send(&gnuplot, "%s", commands);
    return gnuplot_finish(&gnuplot, status);
}

static void run_well(const struct directory *place, const char *commands)
{
    struct status status = {0};
    if (run(place, commands, &status) != STATUS_OK)
        fail_msg("%s\nafter: %s", status.message, commands);
}

<<<<<<< HEAD
static size_t count(const char *text, const char *part)
{
    size_t n = 0;
    for (; (text = strstr(text, part)); text += strlen(part))
        n++;
    return n;
}

static void assert_well_formed(const struct text *xml)
{
    XML_Parser parser = XML_ParserCreate(NULL);
    if (XML_Parse(parser, text_string(xml), (int)xml->length, XML_TRUE) != XML_STATUS_OK)
        fail_msg("line %lu: %s", XML_GetCurrentLineNumber(parser), XML_ErrorString(XML_GetErrorCode(parser)));
    XML_ParserFree(parser);
}

/* Pieces that are to be seen: those whose points only speak when they are pointed at stay out. */
static size_t pieces_of(const char *svg)
{
    static const char start[] = "<g id=\"gnuplot_plot_";
    size_t pieces = 0;
    for (const char *at = strstr(svg, start), *next; at; at = next) {
        const char *speaks = strstr(at, "showHypertext");
        next = strstr(at + 1, start);
        pieces += !speaks || (next && speaks > next);
    }
    return pieces;
}

/* ---------------------------------------------------------------- charts of data as they stand in files */

/* Adds the blocks of a data file, which have these style words. Cells are numbers; an empty line parts lines. */
static void add_blocks(struct drawing *drawing, const char *data, const char *styles)
{
    char *copy = strdup(data), *words = strdup(styles), *rest, *word = strtok_r(words, " ", &rest);
    size_t empty = 2;
    for (char *line = copy, *next; line && *line; line = next) {
        next = strchr(line, '\n');
        *next++ = '\0';
        if (*line == '\0') {
            empty++;
            continue;
        }
        if (empty >= 2) {
            assert_non_null(word);
            assert_int_equal(*line, '"');
            line[strlen(line) - 1] = '\0';
            drawing_begin(drawing, word, line + 1);
            word = strtok_r(NULL, " ", &rest);
        } else {
            double cell[DRAWING_COLUMNS];
            size_t count = 0;
            if (empty == 1)
                drawing_add(drawing, NULL, 0);
            for (char *at = line; *at && count < DRAWING_COLUMNS; at += *at == ',')
                cell[count++] = strtod(at, &at);
            drawing_add(drawing, cell, count);
        }
        empty = 0;
    }
    assert_null(word);
    free(copy);
    free(words);
}

/* What is drawn: the kind, the file's name, and for curves which axes are logarithmic. */
static struct drawing drawing_of(enum drawing_kind kind, const char *name, const char *logarithmic)
{
    struct drawing drawing = {.kind = kind};
    bool own = kind == DRAWING_SPECTRA || kind == DRAWING_COST;
    snprintf(drawing.name, sizeof drawing.name, "%s", name);
    snprintf(drawing.x_label, sizeof drawing.x_label, "x");
    snprintf(drawing.y_label, sizeof drawing.y_label, "y");
    snprintf(drawing.below_label, sizeof drawing.below_label, "below");
    drawing.log_x = own || strchr(logarithmic, 'x');
    drawing.log_y = own || strchr(logarithmic, 'y');
    return drawing;
}

/* Writes script and data as a report does, and draws. */
static void draw(const struct directory *place, struct drawing *drawing, const char *terminal_size)
{
    struct text script = {0}, data = {0};
    struct status status = {0};
    char name[80];
    assert_int_equal(drawing_script(&script, drawing, terminal_size, &status), STATUS_OK);
    drawing_thin(drawing);
    drawing_data(&data, drawing);
    snprintf(name, sizeof name, "%s.csv", drawing->name);
    directory_write(place, name, text_string(&data));
    run_well(place, text_string(&script));
    text_free(&script);
    text_free(&data);
    drawing_free(drawing);
}

/* Each sample with how many pieces gnuplot draws: one for the frame (a panel has its own), lines solid and dashed,
 * markers, legend entries. */
static const struct sample {
    const char *name;
    enum drawing_kind kind;
    const char *y_label, *logarithmic, *styles;
    size_t pieces;
    const char *legend; /* some text that has to be readable in the chart */
} samples[] = {
    {"area", DRAWING_CURVES, "A/A_n", "xy", "s1 s1x s2 s2x s3 s3x s4 s4x", 1 + 8 + 4 + 1, "surface 4, Rq"},
    {"separation", DRAWING_CURVES, "separation / σ", "x", "s1 s2 s3 s4", 1 + 4 + 4, "surface 1, Rq 0.24 µm"},
    {"separation-area", DRAWING_CURVES, "separation / σ", "", "s1 s2 s3 s4", 1 + 4 + 4, "separation / σ"},
    {"ecr", DRAWING_CURVES, "ECR·A_n in Ω m^2", "xy", "s1 s2 s3 s4", 1 + 4 + 4, "surface 2"},
    {"models-area", DRAWING_CURVES, "A/A_n", "xy", "me mp gw gwx jg jgx", 1 + 6 + 4 + 4 + 1, "Jackson–Green"},
    {"models-separation", DRAWING_CURVES, "separation in µm", "x", "me mp gw gwx gwa gwax jg jgx jga jgax",
     1 + 10 + 4 + 6 + 1, "Greenwood–Williamson, adjusted"},
    {"models-tcr", DRAWING_CURVES, "TCR·A_n in K m^2/W", "xy", "me meS mp mpS gw gwS jg jgS",
     1 + 4 + 4 + 4 + (1 + 4 + 4), "multiscale elastic-plastic"},
    {"sweep", DRAWING_CURVES, "A/A_n", "xy", "r1 r2 r3 r4 r5 r6 r7 r8 r9", 1 + 9, "γ = 1.75"},
    {"profiles", DRAWING_PROFILES, "z", "", "s1 s2 s3 s4", 2 * 4, "surface 4, Rq 5.82 µm"},
    {"spectra", DRAWING_SPECTRA, "a", "xy", "s1 fit fitx s2 fit fitx s3 fit fitx s4 fit fitx", 4 * (1 + 3),
     "surface 3, Rq 1.05 µm"},
    {"cost", DRAWING_COST, "e", "xy", "c1 c2 c3 c4 choice", 1 + 4 + 2, "Gauss–Legendre panels"},
};
enum { SAMPLES = sizeof samples / sizeof *samples };

static struct drawing read_sample(const struct sample *sample)
{
    struct drawing drawing = drawing_of(sample->kind, sample->name, sample->logarithmic);
    struct status status = {0};
    struct text data = {0};
    char path[1024];
    snprintf(path, sizeof path, "%s/chart/%s.csv", TEST_DATA, sample->name);
    assert_int_equal(text_read_file(&data, path, &status), STATUS_OK);
    add_blocks(&drawing, text_string(&data), sample->styles);
    snprintf(drawing.title, sizeof drawing.title, "a title");
    snprintf(drawing.y_label, sizeof drawing.y_label, "%s", sample->y_label);
    text_free(&data);
    return drawing;
}

static struct text draw_sample(const struct directory *place, const struct sample *sample, const char *terminal_size)
{
    struct drawing drawing = read_sample(sample);
    char name[80];
    draw(place, &drawing, terminal_size);
    snprintf(name, sizeof name, "%s.%s", sample->name, terminal_size ? "txt" : "svg");
    return directory_read(place, name);
}

#define PLACED(name) TEST_WITH(name, directory_setup, directory_teardown)

PLACED(test_every_kind_draws_an_svg)
{
    for (size_t i = 0; i < SAMPLES; i++) {
        struct text svg = draw_sample(*state, &samples[i], NULL);
        assert_well_formed(&svg);
        if (pieces_of(svg.data) != samples[i].pieces || !strstr(svg.data, samples[i].legend))
            fail_msg("%s: %zu pieces, expected %zu with '%s'", samples[i].name, pieces_of(svg.data), samples[i].pieces,
                     samples[i].legend);
        assert_non_null(strstr(svg.data, "a title"));
        assert_in_range(svg.length, 10000, 130000);
        text_free(&svg);
    }
}

PLACED(test_curves_are_drawn_as_text)
{
    for (size_t i = 0; i < SAMPLES && samples[i].kind == DRAWING_CURVES; i++) {
        struct text chart = draw_sample(*state, &samples[i], "90,44");
        if (!strstr(text_string(&chart), samples[i].legend))
            fail_msg("no '%s' in\n%s", samples[i].legend, text_string(&chart));
        assert_null(strpbrk(chart.data, "\033{}"));
        assert_in_range(count(chart.data, "\n"), 40, 50);
        for (const char *letter = "ABCD"; i == 0 && *letter; letter++) {
            char run_of_letters[] = {*letter, ' ', ' ', 's', 'u', 'r', 'f', '\0'};
            assert_non_null(strstr(chart.data, run_of_letters));
        }
        text_free(&chart);
    }
}

PLACED(test_the_same_data_give_the_same_bytes)
{
    for (size_t i = 0; i < SAMPLES; i++) {
        struct text first = draw_sample(*state, &samples[i], NULL), second = draw_sample(*state, &samples[i], NULL);
        assert_string_equal(text_string(&first), text_string(&second));
        text_free(&first);
        text_free(&second);
    }
}

/* Draws curves: their data and style words; what axes hold is in `axes` unless it is NULL. */
static struct text draw_curves(const struct directory *place, const char *data, const char *logarithmic,
                               const char *styles, const double *axes, size_t pieces)
{
    struct drawing drawing = drawing_of(DRAWING_CURVES, "data", logarithmic);
    add_blocks(&drawing, data, styles);
    drawing.axes_given = axes != NULL;
    drawing.ratio = (struct figure_extent){INFINITY, -INFINITY};
    if (axes) {
        drawing.x = (struct figure_extent){axes[0], axes[1]};
        drawing.y = (struct figure_extent){axes[2], axes[3]};
    }
    draw(place, &drawing, NULL);
    struct text svg = directory_read(place, "data.svg");
    if (pieces_of(text_string(&svg)) != pieces)
        fail_msg("%s: %zu pieces, expected %zu", styles, pieces_of(svg.data), pieces);
    return svg;
}

/* Draws another kind than curves. */
static struct text draw_kind(const struct directory *place, enum drawing_kind kind, const char *data,
                             const char *styles)
{
    struct drawing drawing = drawing_of(kind, "data", "");
    add_blocks(&drawing, data, styles);
    draw(place, &drawing, NULL);
    return directory_read(place, "data.svg");
}

static void add_eight(struct text *data, int points)
{
    for (int curve = 1; curve <= 8; curve++) {
        text_add(data, "%s\"a rather long name of surface %d, cold rolled, Rq 0.24 µm\"\n", curve > 1 ? "\n\n" : "",
                 curve);
        for (int i = 0; i <= points; i++)
            text_add(data, "%.17g,%.17g\n", pow(10, -6 + 5.0 * i / points),
                     fmin(1, curve * pow(10, -4 + 4.8 * i / points)));
    }
}

/* ... and of ten thousand points they are hardly larger. */
PLACED(test_eight_curves_stay_small)
{
    size_t length[2];
    static const int points[] = {120, 10000};
    for (int k = 0; k < 2; k++) {
        struct text data = {0};
        add_eight(&data, points[k]);
        struct text svg = draw_curves(*state, text_string(&data), "xy", "s1 s2 s3 s4 s5 s6 s7 s8", NULL, 1 + 8 + 8);
        assert_in_range(svg.length, 20000, 60000);
        length[k] = svg.length;
        text_free(&svg);
        text_free(&data);
    }
    assert_true(length[1] <= length[0]);
}

PLACED(test_empty_blocks_and_single_points_are_drawn_silently)
{
    static const char none[] = "\"a\"\n\n\n\"b\"\n1,0\n2,nan\n\n\n\"\"\n",
                      few[] = "\"a\"\n1e-4,0.5\n\n\n\"b\"\n\n\n\"c\"\n1e-4,1\n1e-3,0\n1e-2,2\n\n3e-2,3\n4e-2,4\n";
    static const struct {
        enum drawing_kind kind;
        const char *data, *styles, *terminal_size;
    } cases[] = {
        {DRAWING_CURVES, none, "s1 s2 s2x", NULL},  {DRAWING_SPECTRA, none, "s1 fit fitx", NULL},
        {DRAWING_COST, none, "c1 c2 choice", NULL}, {DRAWING_CURVES, none, "s1 s2 s2x", "60,20"},
        {DRAWING_PROFILES, few, "s1 s2 s3", NULL},  {DRAWING_SPECTRA, few, "s1 s2 fit", NULL},
        {DRAWING_CURVES, few, "s1 s2 s3", NULL},    {DRAWING_PROFILES, none, "s1 s2 s3", NULL},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct drawing drawing = drawing_of(cases[i].kind, "data", "xy");
        drawing.log_x = drawing.log_y = cases[i].kind != DRAWING_PROFILES;
        add_blocks(&drawing, cases[i].data, cases[i].styles);
        draw(*state, &drawing, cases[i].terminal_size);
        struct text chart = directory_read(*state, cases[i].terminal_size ? "data.txt" : "data.svg");
        assert_int_equal(count(text_string(&chart), "no data in range"), i < 4);
        if (i == 6)
            assert_int_equal(pieces_of(chart.data), 1 + 1 + 1 + 2);
        text_free(&chart);
    }
}

/* With one load, models differ by their markers, on the chart and in its legend. */
PLACED(test_single_points_have_the_markers_of_their_models)
{
    struct text svg = draw_curves(*state, "\"a\"\n1e-4,0.1\n\n\n\"b\"\n1e-4,0.2\n\n\n\"c\"\n1e-4,0.3\n", "xy",
                                  "me mp gw", (const double[]){1e-4, 1e-4, 0.1, 0.3}, 1 + 3 + 3);
    const char *const models[] = {"multiscale-elastic", "multiscale-plastic", "gw"};
    for (size_t k = 0; k < 3; k++) {
        char marker[64];
        const struct model_row *row = model_rows[model_named(models[k])];
        snprintf(marker, sizeof marker, "xlink:href='#gpPt%d' transform='tr", row->marker - 1);
        assert_int_equal(count(svg.data, marker), 2);
    }
    text_free(&svg);
}

/* At most two bands are filled. */
PLACED(test_two_bands_are_filled_others_are_bars)
{
    struct text data = {0};
    char styles[100];
    for (size_t bands = 1; bands <= 4; bands++) {
        text_add(&data, "%s\"band\"\n1e-4,1,2\n1e-3,2,3\n1e-2,3,4\n\n\n\"curve %zu\"\n1e-4,1\n1e-3,2\n1e-2,3\n",
                 bands > 1 ? "\n\n" : "", bands);
        snprintf(styles, sizeof styles, "%.*s", (int)(7 * bands - 1), "s1b s1 s2b s2 s3b s3 s4b s4 ");
        struct text svg = draw_curves(*state, text_string(&data), "xy", styles, NULL, 1 + 3 * bands + 1 + (bands > 2));
        assert_int_equal(strstr(svg.data, "the same, as bars") != NULL, bands > 2);
        assert_int_equal(count(svg.data, "fill-opacity = '0.200000'"), bands < 2 ? 1 : 2);
        text_free(&svg);
    }
    text_free(&data);
}

/* Curves are cut where the axes say; those that are not leave the axis alone. */
PLACED(test_an_axis_ends_where_curves_are_cut)
{
    static const char data[] = "\"a\"\n1,3\n2,1\n3,-4\n";
    struct text whole = draw_curves(*state, data, "", "s1", NULL, 1 + 1 + 1);
    struct text cut = draw_curves(*state, data, "", "s1", (const double[]){1, 3, -0.5, 3}, 1 + 1 + 1);
    assert_non_null(strstr(whole.data, "−4"));
    assert_null(strstr(cut.data, "−"));
    text_free(&whole);
    text_free(&cut);
}

/* A row of 0 on a logarithmic axis ends its curve at the lower edge, without making room for it. */
PLACED(test_a_zero_ends_at_the_lower_edge)
{
    double end[2];
    const char *const more[] = {"", "2e-2,0\n"};
    for (int k = 0; k < 2; k++) {
        char data[100];
        snprintf(data, sizeof data, "\"a\"\n1e-4,1e3\n1e-3,1e2\n1e-2,1e1\n%s", more[k]);
        struct text svg = draw_curves(*state, data, "xy", "s1", (const double[]){1e-4, 0.1, 1, 1e3}, 1 + 1 + 1);
        const char *path = strstr(svg.data, "<path stroke='rgb( 18,  87, 208)'  d='M");
        assert_non_null(path);
        const char *last = strchr(strstr(path, "d='"), '>');
        while (*last != ',')
            last--;
        end[k] = atof(last + 1);
        text_free(&svg);
    }
    /* 340 for three decades and 4 % of room at both ends; without the zero the curve ends a decade above the edge */
    assert_near(end[1] - end[0], 340 * (1 + 0.12) / 3.24, 0.005);
}

/* Sweeps are labelled at their curves' ends, apart from each other and in the order of these. */
PLACED(test_labels_at_ends_do_not_touch)
{
    struct text svg = draw_curves(*state, "\"p\"\n1,0.5\n2,1\n\n\n\"q\"\n1,0.4\n2,1\n\n\n\"r\"\n1,0.3\n2,0.99\n", "xy",
                                  "r1 r2 r3", NULL, 1 + 3);
    double at[3] = {0};
    for (int k = 0; k < 3; k++) {
        const char tag[] = {'>', (char)('p' + k), '<', '\0'};
        const char *found = strstr(svg.data, tag), *place = NULL;
        assert_non_null(found);
        for (const char *c = strstr(svg.data, "translate("); c && c < found; c = strstr(c + 1, "translate("))
            place = c;
        assert_int_equal(sscanf(place, "translate(%*f,%lf)", &at[k]), 1);
    }
    assert_true(at[0] - at[1] >= 18 && at[2] - at[0] >= 18); /* upwards: r, then p and q, which end together */
    text_free(&svg);
}

/* An error of 0 stands on the lower edge and makes no room for itself. */
PLACED(test_no_error_is_off_the_scale)
{
    struct text some = draw_kind(*state, DRAWING_COST, "\"a\"\n1e-4,1e-2\n1e-3,1e-4\n", "c1"),
                none = draw_kind(*state, DRAWING_COST, "\"a\"\n1e-4,1e-2\n1e-3,1e-4\n1e-2,0\n", "c1");
    assert_null(strstr(text_string(&some), "lower edge"));
    assert_non_null(strstr(text_string(&none), "lower edge"));
    assert_int_equal(count(none.data, "transform='tr"), count(some.data, "transform='tr") + 2); /* it, and its note */
    expect_no_parts(none.data, "−5", "−16<");
    text_free(&some);
    text_free(&none);
}

PLACED(test_the_smallest_and_largest_numbers_have_axes)
{
    static const char narrow[] = "\"a\"\n0.02,5\n0.020000001,5\n";
    struct text wide = draw_curves(*state, "\"a\"\n1e-30,1e-299\n1e6,1e299\n", "xy", "s1", NULL, 1 + 1 + 1);
    assert_int_equal(count(text_string(&wide), "<path stroke='rgb( 18,  87, 208)'"), 2); /* the line and its sample */
    assert_in_range(count(wide.data, "<tspan"), 10, 60);
    text_free(&wide);
    struct text others[] = {draw_curves(*state, narrow, "xy", "s1", NULL, 1 + 1 + 1),
                            draw_curves(*state, narrow, "", "s1", NULL, 1 + 1 + 1),
                            draw_kind(*state, DRAWING_PROFILES, narrow, "s1")};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        text_free(&others[i]);
}

/* ---------------------------------------------------------------- thinning */

/* Height of the line through the kept points at x, all in the drawing's own units; steps from 0 to 1 span the axes. */
static double line_at(const struct drawing *drawing, const struct drawing_block *block, double x)
{
    size_t i = block->first;
    while (i + 2 < block->end && drawing->row[i + 1][0] < x)
        i++;
    const double *a = drawing->row[i], *b = drawing->row[i + 1];
    return a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
}

static double wavy(double x)
{
    return 0.5 + 0.4 * sin(20 * x) * x;
}

/* What is left out is within the tolerance of what is left; ends, gaps and short lines stay. */
TEST_CASE(test_thinning)
{
    enum { POINTS = 20000, SHORT = 150 };
    struct drawing drawing = drawing_of(DRAWING_CURVES, "data", "");
    struct text script = {0};
    struct status status = {0};
    drawing_begin(&drawing, "s1", "long");
    for (int i = 0; i <= POINTS; i++)
        drawing_add(&drawing, (const double[]){(double)i / POINTS, wavy((double)i / POINTS)}, 2);
    drawing_begin(&drawing, "s2", "a straight line with a peak and a gap");
    for (int i = 0; i <= POINTS; i++) {
        if (i == POINTS / 2)
            drawing_add(&drawing, NULL, 0);
        drawing_add(&drawing, (const double[]){(double)i / POINTS, i == 777 ? 1 : 0.3}, 2);
    }
    drawing_begin(&drawing, "s3", "short");
    for (int i = 0; i <= SHORT; i++)
        drawing_add(&drawing, (const double[]){(double)i / SHORT, 0}, 2);
    assert_int_equal(drawing_script(&script, &drawing, NULL, &status), STATUS_OK);
    drawing_thin(&drawing);
    const struct drawing_block *wave = &drawing.block[0], *peak = &drawing.block[1], *few = &drawing.block[2];
    assert_in_range(wave->end - wave->first, 20, 400);
    assert_near(drawing.row[wave->end - 1][0], 1, 0);
    double most = 0, height = 340 / drawing.block[1].y_high; /* the axis goes from 0 to 1 */
    for (int i = 0; i <= POINTS; i++)
        most = fmax(most, height * fabs(line_at(&drawing, wave, (double)i / POINTS) - wavy((double)i / POINTS)));
    assert_true(most <= drawing_tolerance * 1.0001 && most > 0.5 * drawing_tolerance);
    size_t gaps = 0, highest = 0;
    for (size_t i = peak->first; i < peak->end; i++) {
        gaps += isnan(drawing.row[i][0]) != 0;
        highest = drawing.row[i][1] > 0.9 ? i : highest;
    }
    assert_int_equal(gaps, 1);
    assert_near(drawing.row[highest][0], 777.0 / POINTS, 0);
    assert_near(drawing.row[highest - 1][0], 776.0 / POINTS, 0);
    assert_near(drawing.row[highest + 1][0], 778.0 / POINTS, 0);
    assert_true(peak->end - peak->first <= 9);
    assert_int_equal(few->end - few->first, SHORT + 1);
    text_free(&script);
    drawing_free(&drawing);
}

static const char hostile[] =
    "'q' \"d\" \\ \\n \\101 {/*9 x}^_@&<>% `touch pwned1` $(touch pwned2) \n\x1b[31m\x7f\xc2\x9b \xff\xed\xa0\x80,# µ";

PLACED(test_hostile_names_are_only_text)
{
    static const struct {
        enum drawing_kind kind;
        const char *styles[2], *terminal_size;
        bool cut; /* in a narrow panel's head */
    } cases[] = {
        {DRAWING_CURVES, {"s1", "s2"}, NULL, false},     {DRAWING_PROFILES, {"s1", "s2"}, NULL, false},
        {DRAWING_SPECTRA, {"s1", "fit"}, NULL, true},    {DRAWING_COST, {"c1", "choice"}, NULL, false},
        {DRAWING_CURVES, {"s1", "s2"}, "120,30", false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct drawing drawing = drawing_of(cases[i].kind, "data", "xy");
        snprintf(drawing.title, sizeof drawing.title, "%s", hostile);
        for (int b = 0; b < 2; b++) {
            drawing_begin(&drawing, cases[i].styles[b], hostile);
            drawing_add(&drawing, (const double[]){1, 1 + b}, 2);
            drawing_add(&drawing, (const double[]){2, 2 + b}, 2);
        }
        draw(*state, &drawing, cases[i].terminal_size);
        assert_false(directory_has(*state, "pwned1") || directory_has(*state, "pwned2"));
        struct text chart = directory_read(*state, cases[i].terminal_size ? "data.txt" : "data.svg");
        if (cases[i].terminal_size) {
            assert_null(strpbrk(text_string(&chart), "\033\x7f"));
        } else { /* as title and as legend; nothing enhanced, nothing unescaped */
            assert_well_formed(&chart);
            static const char whole[] = "'q' \"d\" \\ \\n \\101 {/*9 x}^_@&amp;&lt;>% `touch pwned1` $(touch";
            assert_true(count(chart.data, whole) >= (cases[i].cut ? 1 : 2));
            assert_true(count(chart.data, "'q' \"d\" \\ \\n \\101 {/*9 x}^_@&amp;&lt;>% `tou") >= 2);
        }
        text_free(&chart);
    }
}

/* Into `size` bytes; a character, or a mark of what was cut, that does not fit whole is left out. */
TEST_CASE(test_quoting)
{
    static const struct {
        const char *string;
        size_t size;
        const char *field;
    } cases[] = {
        {"it's \"a\\b\" µ\n\xff", 64, "\"it's 'a\\\\b' µ\\\\x0a\\\\xff\""},
        {"=1", 64, "\"'=1\""},
        {"=1", 3, "\"\""},
        {"abcdµµ", 8, "\"abcd\""}, /* µ takes two bytes and would leave no room for the mark */
        {"abcd\\", 8, "\"abcd\""}, /* half a doubled backslash would take the mark */
        {"abc", 3, "\"\""},
        {"abc", 2, ""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char out[64];
        gnuplot_field(out, cases[i].size, cases[i].string);
        assert_string_equal(out, cases[i].field);
    }
}

/* What a script quotes: marks of ASCII come as escapes, what is too long is cut at its end or in its middle. */
TEST_CASE(test_script_strings)
{
    static const struct {
        const char *string, *quoted;
        size_t most;
        bool both_ends;
    } cases[] = {
        {"Rq 0.24 µm, (a-b) = 1/2", "\"Rq 0.24 µm, (a-b) = 1/2\"", 60, false},
        {"'\"`\\@$#%\n\xff", "\"\\047\\042\\140\\134\\100\\044\\043\\045\\134x0a\\134xff\"", 60, false},
        {"a]]>b>", "\"a\\135\\135›b\\076\"", 60, false},
        {"µbcdefgh", "\"µbcd…\"", 5, false},
        {"µbcdefgh", "\"µb…fgh\"", 6, true},
        {"µbcdef", "\"µbcdef\"", 6, true},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct text out = {0};
        drawing_quote(&out, cases[i].string, cases[i].most, cases[i].both_ends);
        assert_string_equal(text_string(&out), cases[i].quoted);
        text_free(&out);
    }
}

=======
>>>>>>> h7
PLACED(test_a_missing_gnuplot_names_the_package)
{
    char *path = strdup(getenv("PATH"));
    const char *const without[] = {"", ":", ".:bin", "/nonexistent"};
    struct status status = {0};
    for (size_t i = 0; i < sizeof without / sizeof *without; i++) {
        struct status checked = {0}, started = {0};
        struct gnuplot gnuplot;
        assert_int_equal(setenv("PATH", without[i], 1), 0);
        enum status_code check = gnuplot_check(&checked);
        enum status_code start = gnuplot_start(&gnuplot, directory_here.path, &started);
        assert_int_equal(setenv("PATH", path, 1), 0);
        assert_int_equal(check, STATUS_CHART);
        assert_int_equal(start, STATUS_CHART);
        expect_parts(checked.message, "gnuplot-nox");
        expect_parts(started.message, "gnuplot-nox");
    }
    free(path);
    assert_int_equal(gnuplot_check(&status), STATUS_OK);
}

TEST_CASE(test_a_missing_directory_is_an_error)
{
    struct gnuplot gnuplot;
    struct status status = {0};
    assert_int_equal(gnuplot_start(&gnuplot, "/nonexistent/charts", &status), STATUS_IO);
    assert_non_null(strstr(status.message, "/nonexistent/charts"));
}

PLACED(test_any_complaint_is_a_failure)
{
    static const struct {
        const char *commands, *message;
    } complaints[] = {
        {"load 'bad.gp'", "gnuplot: \"bad.gp\" line 2: undefined variable: nothing_here"},
        {"load 'syntax.gp'", "gnuplot: \"syntax.gp\" line 1: "},
        {"load 'missing.gp'", "gnuplot: Cannot load input from 'missing.gp'"},
        {"plot 'missing.csv'", "missing.csv"},
        {"set terminal dumb\nset output 'x'\nplot [0:1] [0:1] 'none.csv'",
         "warning: Skipping data file with no valid points"},
        {"print 'a word'", "gnuplot: a word"},
        {"exit status 3", "status 3"},
    };
    directory_write(*state, "bad.gp", "x = 1\nplot nothing_here\n");
    directory_write(*state, "syntax.gp", "plot sin(x\n");
    directory_write(*state, "none.csv", "# nothing\n");
    for (size_t i = 0; i < sizeof complaints / sizeof *complaints; i++) {
        struct status status = {0};
        assert_int_equal(run(*state, complaints[i].commands, &status), STATUS_CHART);
        expect_parts(status.message, complaints[i].message);
        assert_null(strpbrk(status.message, "\r\n\033"));
    }
}

PLACED(test_a_process_that_ended_early_is_reported_not_deadly)
{
    struct sigaction before, after;
    assert_int_equal(sigaction(SIGPIPE, NULL, &before), 0);
    struct gnuplot gnuplot;
    struct status status = {0};
    assert_int_equal(gnuplot_start(&gnuplot, ((struct directory *)*state)->path, &status), STATUS_OK);
    gnuplot_send(&gnuplot, "exit");
    for (int i = 0; i < 100000; i++) /* far more than a pipe holds */
        gnuplot_send(&gnuplot, "x = %d", i);
    assert_int_equal(gnuplot_finish(&gnuplot, &status), STATUS_CHART);
    assert_non_null(strstr(status.message, "before it had read all commands"));
    sigset_t pending;
    assert_int_equal(sigpending(&pending), 0);
    assert_int_equal(sigismember(&pending, SIGPIPE), 0);
    assert_int_equal(sigaction(SIGPIPE, NULL, &after), 0);
    assert_ptr_equal(before.sa_handler, after.sa_handler);
}

static size_t open_files(void)
{
    size_t n = 0;
    DIR *directory = opendir("/proc/self/fd");
    assert_non_null(directory);
    while (readdir(directory))
        n++;
    closedir(directory);
    return n;
}

PLACED(test_the_user_s_setup_has_no_say)
{
    const struct directory *place = *state;
    directory_write(place, ".gnuplot", "print 'start-up file'\n");
    const char *home = getenv("HOME");
    char *kept = home ? strdup(home) : NULL;
    setenv("HOME", place->path, 1);
    setenv("GNUTERM", "nonsense", 1);
    setenv("GNUPLOT_LIB", place->path, 1);
    struct status status = {0};
    enum status_code code =
        run(place, "if (strlen(system('echo $GNUTERM$GNUPLOT_LIB'))) { exit error 'set' }", &status);
    unsetenv("GNUTERM");
    unsetenv("GNUPLOT_LIB");
    if (kept)
        setenv("HOME", kept, 1);
    free(kept);
    if (code)
        fail_msg("%s", status.message);
}

PLACED(test_no_descriptor_is_left_open)
{
    size_t before = open_files();
    run_well(*state, "x = 1");
    struct status status = {0};
    struct gnuplot gnuplot;
    assert_int_equal(run(*state, "plot nothing_here", &status), STATUS_CHART);
    status = (struct status){0};
    assert_int_equal(gnuplot_start(&gnuplot, "/nonexistent", &status), STATUS_IO);
    assert_int_equal(open_files(), before);

    /* and a process started meanwhile by others does not hold the pipe open */
    status = (struct status){0};
    assert_int_equal(gnuplot_start(&gnuplot, "/", &status), STATUS_OK);
    assert_true(fcntl(gnuplot.input, F_GETFD) & FD_CLOEXEC);
    assert_true(fcntl(fileno(gnuplot.complaints), F_GETFD) & FD_CLOEXEC);
    assert_int_equal(gnuplot_finish(&gnuplot, &status), STATUS_OK);
}

/* Starts a gnuplot of these lines. */
static struct gnuplot start_other(const struct directory *place, const char *lines)
{
    struct gnuplot gnuplot;
    struct status status = {0};
    char path[1024], *before = strdup(getenv("PATH"));
    directory_write(place, "gnuplot", lines);
    snprintf(path, sizeof path, "%s/gnuplot", place->path);
    assert_int_equal(chmod(path, 0755), 0);
    assert_int_equal(setenv("PATH", place->path, 1), 0);
    enum status_code started = gnuplot_start(&gnuplot, place->path, &status);
    assert_int_equal(setenv("PATH", before, 1), 0);
    free(before);
    assert_int_equal(started, STATUS_OK);
    return gnuplot;
}

/* What it says is kept to some size, as it lies in memory. */
PLACED(test_endless_messages_are_cut)
{
    struct status status = {0};
    struct stat info;
    struct gnuplot gnuplot =
        start_other(*state, "#!/bin/sh\necho 'line 7: wrong'\n/usr/bin/head -c 30000000 /dev/zero\n");
    assert_int_equal(program_wait(gnuplot.process, INFINITY, -1), PROGRAM_ENDED);
    assert_int_equal(fstat(fileno(gnuplot.complaints), &info), 0);
    assert_true(info.st_size <= 1 << 20);
    assert_int_equal(gnuplot_finish(&gnuplot, &status), STATUS_CHART);
    assert_string_equal(status.message, "gnuplot: line 7: wrong");
}

/* One that neither reads nor ends: it is not waited for longer than its time, nor when asked to stop. The last test:
 * nothing starts after it. */
PLACED(test_a_gnuplot_that_hangs_is_ended)
{
    for (int asked = 0; asked < 2; asked++) {
        struct status status = {0};
        struct gnuplot gnuplot = start_other(*state, "#!/bin/sh\ntrap '' INT TERM HUP\n/bin/sleep 1000\n");
        assert_true(gnuplot.most_seconds >= 60); /* for the slowest of machines */
        for (int i = 0; i < 100000; i++)         /* far more than a pipe holds */
            gnuplot_send(&gnuplot, "x = %d", i);
        if (asked) {
            program_stop();
            assert_int_equal(gnuplot_finish(&gnuplot, &status), STATUS_INTERRUPTED);
        } else {
            gnuplot.most_seconds = 0.2;
            assert_int_equal(gnuplot_finish(&gnuplot, &status), STATUS_CHART);
            assert_non_null(strstr(status.message, "gnuplot did not end within 0.2 s and was stopped"));
        }
    }
}
