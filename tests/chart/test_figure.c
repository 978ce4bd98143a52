/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "chart/figure_data.h"
#include "run/pipeline.h"

#include <ctype.h>

enum { BLOCKS_MOST = 40, ROWS_MOST = 1100, SPIKE = 1234 };
static const double written = 1e-8; /* relative: figures' data have nine digits */

/* A quote, an end of line, commands, gnuplot's marks: YAML escapes, and what of it may reach a data file. */
static const char hostile_yaml[] = "\"x'); system('touch pwned') #\\\"`touch pwned` @a $b %d \\\\n {c} µ, \"";
static const char hostile_field[] = "\"x'); system('touch pwned') #'`touch pwned` @a $b %d \\\\n {c} µ, ";

static int place_setup(void **state)
{
    static struct directory place;
    struct text scene = {0};
    place = directory_make();
    pipeline_rough(&place, "in/a.csv", 120, 0.1, 1);
    pipeline_rough(&place, "in/b.csv", 120, 1, 2);
    double *height_m = calloc(3000, sizeof *height_m);
    assert_non_null(height_m);
    for (size_t i = 0; i < 3000; i++)
        height_m[i] = 5e-6 * sin(0.01 * (double)i) + (i == SPIKE ? 3e-5 : 0);
    pipeline_scan(&place, "in/c.csv", height_m, 3000);
    free(height_m);
    text_add(&scene,
             "material: tin\neffects: [plasticity, separation, electrical, thermal, scale-dependent, convergence]\n"
             "load: {from: 1e-6, to: 1, points: 25}\nconvergence: {scales: 30}\nsurfaces:\n"
             "  - {name: a, file: a.csv}\n  - {name: %s, file: b.csv}\n  - {name: c, file: c.csv}\n",
             hostile_yaml);
    directory_write(&place, "in/scene.yaml", text_string(&scene));
    text_free(&scene);
    assert_int_equal(pipeline_run(&place, "in", "out", 1), 0);
    *state = &place;
    return 0;
}

/* A figure's data as gnuplot sees it, with the style words its script gives to the blocks. */
struct drawn {
    size_t blocks, rows[BLOCKS_MOST];
    char legend[BLOCKS_MOST][300], style[BLOCKS_MOST][32];
    double x[BLOCKS_MOST][ROWS_MOST], y[BLOCKS_MOST][ROWS_MOST];
};

/* What a figure's script says behind a word at the beginning of a line; owned. */
static char *script_line(const struct directory *place, const char *out, const char *number, const char *word)
{
    char name[96];
    snprintf(name, sizeof name, "%s/figures/%s.gp", out, number);
    struct text script = directory_read(place, name);
    const char *start = strstr(script.data, word);
    assert_non_null(start);
    start += strlen(word);
    char *line = strndup(start, strcspn(start, "\n"));
    text_free(&script);
    return line;
}

static void read_styles(struct drawn *drawing, const struct directory *place, const char *number)
{
    char *line = script_line(place, "out", number, "\n# curves:"), *rest;
    size_t count = 0;
    for (char *word = strtok_r(line, " ", &rest); word; word = strtok_r(NULL, " ", &rest), count++) {
        assert_true(count < BLOCKS_MOST);
        snprintf(drawing->style[count], sizeof drawing->style[0], "%s", word);
    }
    assert_int_equal(count, drawing->blocks);
    free(line);
}

static struct drawn *read_drawing(const struct directory *place, const char *number)
{
    struct drawn *drawing = calloc(1, sizeof *drawing);
    char name[64], *rest;
    assert_non_null(drawing);
    snprintf(name, sizeof name, "out/figures/%s.csv", number);
    struct text data = directory_read(place, name);
    for (char *line = data.data, *next; line && *line; line = next) {
        next = strchr(line, '\n');
        assert_non_null(next);
        *next++ = '\0';
        if (*line == '\0')
            continue;
        if (*line == '"') { /* two empty lines stand between blocks, none before the first */
            assert_true(drawing->blocks < BLOCKS_MOST);
            assert_true(line == data.data || (line[-1] == '\0' && line[-2] == '\0' && line[-3] == '\0'));
            assert_int_equal(line[strlen(line) - 1], '"');
            snprintf(drawing->legend[drawing->blocks++], sizeof drawing->legend[0], "%s", line);
            continue;
        }
        assert_true(drawing->blocks > 0);
        size_t block = drawing->blocks - 1, row = drawing->rows[block]++;
        assert_true(row < ROWS_MOST);
        drawing->x[block][row] = strtod(line, &rest);
        assert_int_equal(*rest, ',');
        drawing->y[block][row] = strtod(rest + 1, &rest);
        for (int column = 2; *rest == ',' && column < 5; column++) /* of a bin: its error, decades over the law */
            assert_true(isfinite(strtod(rest + 1, &rest)));
        assert_int_equal(*rest, '\0');
        assert_true(isfinite(drawing->x[block][row]) && isfinite(drawing->y[block][row]));
    }
    text_free(&data);
    read_styles(drawing, place, number);
    return drawing;
}

/* The four models of the thesis, in the order of its charts of all surfaces. */
static const char *const thesis_models[4] = {"multiscale-plastic", "multiscale-elastic", "jg", "gw"};
enum { ALL_EFFECTS = (1u << EFFECT_GAP) - 1, ALL_MODELS = 15 }; /* those of the joint: tests/run/test_joint_report.c */

/* Those of the thesis's models whose bits are set in `which`, as a plan has them. */
static uint64_t models_of(unsigned which)
{
    uint64_t models = 0;
    for (int k = 0; k < 4; k++)
        if (which & 1u << k)
            models |= MODEL_BIT(model_named(thesis_models[k]));
    return models;
}

/* The figures of a run with these effects and models; `benchmark` may be NULL. To be freed. */
static struct figure_list list_of(unsigned effects, unsigned which, const struct benchmark *benchmark)
{
    static const double sweeps = 0;
    const struct plan plan = {.running = effects, .wanted = quantity_wanted(effects), .models = models_of(which)};
    const struct results results = {.plan = &plan,
                                    .convergence = effects & EFFECT_BIT(EFFECT_CONVERGENCE) ? &sweeps : NULL,
                                    .benchmark = benchmark};
    struct figure_list list;
    struct status status = {0};
    assert_int_equal(figure_list_make(&list, &results, &status), STATUS_OK);
    return list;
}

/* Number of the chapter's figure; good until the next call. */
static const char *numbered(int n)
{
    static char number[8];
    snprintf(number, sizeof number, "6-%02d", n);
    return number;
}

/* How many figures of that number the list has. */
static size_t times_listed(const struct figure_list *list, const char *number)
{
    size_t times = 0;
    for (size_t i = 0; i < list->count; i++)
        times += strcmp(list->figures[i].number, number) == 0;
    return times;
}

TEST_CASE(test_every_number_exists_once)
{
    struct benchmark_row rows[] = {{.chart = BENCHMARK_CURVES}, {.chart = BENCHMARK_INTEGRALS}};
    const struct benchmark cost = {.rows = rows, .count = 2};
    struct figure_list list = list_of(ALL_EFFECTS, ALL_MODELS, &cost);
    for (int n = 1; n <= 30; n++) {
        assert_int_equal(times_listed(&list, numbered(n)), 1);
        assert_string_equal(list.figures[n - 1].number, numbered(n)); /* in the order of the chapter */
    }
    assert_int_equal(list.count, 33);
    assert_int_equal(times_listed(&list, "cost-integrals"), 1);
    assert_int_equal(times_listed(&list, "cost-curves"), 1);
    assert_int_equal(times_listed(&list, "power-law"), 1);
    for (size_t i = 0; i < list.count; i++) {
        const struct figure *figure = &list.figures[i];
        assert_true(figure->title[0] && strlen(figure->title) < sizeof figure->title - 1);
        assert_null(strpbrk(figure->title, "'\"\\\n")); /* it stands in a gnuplot string */
        bool one_model = figure->row->kind == FIGURE_SURFACES || figure->row->kind == FIGURE_SWEEP;
        assert_int_equal(figure->model < model_count, one_model);
    }
    figure_list_free(&list);
}

/* The figures of all surfaces and the sweeps are of one model each: which, by the contract. */
TEST_CASE(test_which_model_a_figure_shows)
{
    struct figure_list list = list_of(ALL_EFFECTS, ALL_MODELS, NULL);
    for (size_t n = 11; n <= 30; n++)
        assert_int_equal(list.figures[n - 1].model, model_named(thesis_models[(n - 11) % 4]));
    for (size_t n = 1; n <= 4; n++)
        assert_int_equal(list.figures[n - 1].model, model_named(thesis_models[n % 2]));
    figure_list_free(&list);
}

/* The list of figures in docs/report.md: what each needs. */
static bool is_called_for(int n, unsigned effects, unsigned which)
{
    bool plastic = effects & EFFECT_BIT(EFFECT_PLASTICITY), separation = effects & EFFECT_BIT(EFFECT_SEPARATION);
    bool electrical = effects & EFFECT_BIT(EFFECT_ELECTRICAL), thermal = effects & EFFECT_BIT(EFFECT_THERMAL);
    bool needed[] = {true, separation, separation, electrical, thermal}; /* 6-11, 6-15, 6-19, 6-23, 6-27 on */
    unsigned running = plastic ? which : which & 10;                     /* multiscale-elastic and gw */
    if (n <= 4)
        return (effects & EFFECT_BIT(EFFECT_CONVERGENCE)) && (running & (n % 2 == 1 ? 2 : 1));
    if (n == 10)
        return true;
    if (n < 10)
        return running && (n == 5 || (n <= 7 && separation) || (n == 8 && electrical) || (n == 9 && thermal));
    return needed[(n - 11) / 4] && (running & 1u << (n - 11) % 4);
}

TEST_CASE(test_effects_and_models_that_are_off_remove_their_figures)
{
    struct benchmark_row row = {.chart = BENCHMARK_CURVES};
    const struct benchmark cost = {.rows = &row, .count = 1};
    for (unsigned effects = 0; effects <= ALL_EFFECTS; effects++)
        for (unsigned which = 1; which <= ALL_MODELS; which++) {
            struct figure_list list = list_of(effects, which, NULL), timed = list_of(effects, which, &cost);
            for (int n = 1; n <= 30; n++) {
                if (times_listed(&list, numbered(n)) != is_called_for(n, effects, which))
                    fail_msg("figure %s, effects %x, models %x", numbered(n), effects, which);
            }
            assert_int_equal(times_listed(&list, "power-law"), 1);
            assert_int_equal(times_listed(&list, "cost-curves"), 0);
            assert_int_equal(times_listed(&timed, "cost-curves"), 1);
            assert_int_equal(times_listed(&timed, "cost-integrals"), 0);
            assert_int_equal(timed.count, list.count + 1);
            figure_list_free(&list);
            figure_list_free(&timed);
        }
}

/* A figure that is not called for leaves no file. */
TEST_CASE(test_the_files_are_those_of_the_figures)
{
    const struct directory *place = *state;
    pipeline_rough(place, "electrical/a.csv", 64, 1, 1);
    directory_write(place, "electrical/scene.yaml", "material: tin\neffects: [electrical]\n");
    assert_int_equal(pipeline_run(place, "electrical", "out-electrical", 1), 0);
    static const char *const outs[] = {"out", "out-electrical"}, *const endings[] = {"csv", "gp", "svg"};
    static const unsigned effects[] = {ALL_EFFECTS, EFFECT_BIT(EFFECT_ELECTRICAL)};
    static const struct {
        const char *name;
        bool on[2]; /* in which of outs: models that lead there, what the effects give */
    } others[] = {
        {"power-law", {true, true}},
        {"models-area", {true, true}},
        {"models-separation", {true, false}},
        {"models-ecr", {true, true}},
        {"normal-probability", {true, true}}, /* c has waves, 64 points are too few to look Gaussian */
        {"area-load-corrected-persson-plastic", {true, false}},
        {"separation-load-corrected-persson-plastic", {true, false}},
        {"separation-area-corrected-persson-plastic", {true, false}},
        {"ecr-load-corrected-persson-plastic", {true, false}},
        {"tcr-load-corrected-persson-plastic", {true, false}},
        {"area-load-corrected-persson", {false, true}},
        {"ecr-load-corrected-persson", {false, true}},
        {"sensitivity-area", {true, true}},
        {"sensitivity-ecr", {true, true}},
    };
    for (size_t o = 0; o < 2; o++) {
        size_t files = 0;
        char name[96];
        for (size_t i = 0; i < 30 + sizeof others / sizeof *others; i++)
            for (int e = 0; e < 3; e++) {
                int n = (int)i + 1;
                bool on = n <= 30 ? is_called_for(n, effects[o], ALL_MODELS) : others[i - 30].on[o];
                snprintf(name, sizeof name, "%s/figures/%s.%s", outs[o], n <= 30 ? numbered(n) : others[i - 30].name,
                         endings[e]);
                if (directory_has(place, name) != on)
                    fail_msg("%s", name);
                files += on;
            }
        snprintf(name, sizeof name, "%s/figures", outs[o]);
        assert_int_equal(directory_entries(place, name), files);
    }
}

/* Every block has a style word, and rows that its axes can show. */
TEST_CASE(test_every_data_file_fits_its_script)
{
    struct figure_list list = list_of(ALL_EFFECTS, ALL_MODELS, NULL); /* timings are not made here */
    for (size_t i = 0; i < list.count; i++) {
        const struct figure_row *row = list.figures[i].row;
        struct drawn *drawing = read_drawing(*state, list.figures[i].number);
        size_t expected = row->kind == FIGURE_SWEEP      ? row->sweep == CONVERGENCE_ALPHA ? 7 : 9
                          : row->kind == FIGURE_PROFILES ? 3
                          : row->kind == FIGURE_SPECTRA
                              ? 3 * 7 /* points, law in and out of its band, bins of three kinds, knees */
                              : 0;
        size_t hidden = 0;
        bool resistance = QUANTITY_BIT(row->y) & QUANTITY_RESISTANCES;
        for (size_t b = 0; b < drawing->blocks; b++) {
            hidden += strcmp(drawing->legend[b], "\"hidden\"") == 0;
            for (size_t k = 0; k < drawing->rows[b] && row->kind != FIGURE_PROFILES; k++) {
                bool ends = resistance && k + 1 == drawing->rows[b] && drawing->y[b][k] == 0; /* full contact */
                assert_true(drawing->x[b][k] > 0);
                assert_true(row->y == QUANTITY_SEPARATION || ends || drawing->y[b][k] > 0);
            }
        }
        if (expected)
            assert_int_equal(drawing->blocks - hidden, expected);
        free(drawing);
    }
    figure_list_free(&list);
}

TEST_CASE(test_a_hostile_name_is_only_a_legend)
{
    const struct directory *place = *state;
    struct figure_list list = list_of(ALL_EFFECTS, ALL_MODELS, NULL);
    size_t seen = 0;
    for (size_t i = 0; i < list.count; i++) {
        char name[96];
        snprintf(name, sizeof name, "out/figures/%s.gp", list.figures[i].number);
        /* marks of the name come as escapes */
        expect_not_in_file(place, name, "x');", "system('", "#`", "`", "@a", "$b", "{c}");
        struct drawn *drawing = read_drawing(place, list.figures[i].number);
        for (size_t b = 0; b < drawing->blocks; b++)
            seen += strncmp(drawing->legend[b], hostile_field, strlen(hostile_field)) == 0;
        free(drawing);
    }
    figure_list_free(&list);
    assert_true(seen >= 20 + 2); /* 6-11 to 6-30, profiles, spectra */
    assert_false(directory_has(place, "out/figures/pwned"));
    assert_int_not_equal(access("pwned", F_OK), 0);
}

/* A column of contact.csv for the rows of one surface and model, which have a load and that column. */
static size_t read_column(double *load, double *value, const struct directory *place, const char *model,
                          const char *column)
{
    struct text text = directory_read(place, "out/data/contact.csv");
    size_t rows = 0, wanted = 0;
    char prefix[64];
    snprintf(prefix, sizeof prefix, "a,%s,", model);
    for (const char *c = text.data, *end = strstr(text.data, column); c < end; c++)
        wanted += *c == ',';
    for (const char *line = text.data; (line = strchr(line, '\n')) && *++line;) {
        const char *cell = line;
        if (strncmp(line, prefix, strlen(prefix)) != 0)
            continue;
        load[rows] = atof(line + strlen(prefix));
        for (size_t c = 0; c < wanted; c++)
            cell = strchr(cell, ',') + 1;
        value[rows++] = *cell == ',' || *cell == '\n' ? NAN : atof(cell);
    }
    text_free(&text);
    return rows;
}

/* Solid up to the last valid point, dashed from that same point on; together the whole curve. */
static void assert_solid_then_dashed(const struct drawn *drawing, size_t block, const struct directory *place,
                                     const char *model, double touching)
{
    double load[64], area[64];
    size_t rows = read_column(load, area, place, model, "area_ratio"), solid = drawing->rows[block];
    assert_int_equal(solid + drawing->rows[block + 1] - 1, rows);
    assert_true(solid > 1 && solid < rows);
    for (size_t k = 0; k < rows; k++) {
        size_t b = k < solid ? block : block + 1, row = k < solid ? k : k - solid + 1;
        assert_near(drawing->x[b][row], load[k], written);
        assert_near(drawing->y[b][row], area[k], written);
        if (k < solid)
            assert_true(area[k] <= 0.1);
    }
    assert_near(drawing->x[block + 1][0], load[solid - 1], written);
    assert_near(drawing->y[block + 1][0], area[solid - 1], written);
    if (touching > 0)
        assert_true(area[solid] > touching);
}

TEST_CASE(test_dashed_curves_begin_at_the_last_valid_point)
{
    struct drawn *gw = read_drawing(*state, "6-14"), *jg = read_drawing(*state, "6-13"),
                 *elastic = read_drawing(*state, "6-12");
    assert_string_equal(gw->style[0], "s1");
    assert_string_equal(gw->style[1], "s1x");
    assert_string_equal(gw->legend[0], gw->legend[1]);
    assert_solid_then_dashed(gw, 0, *state, "gw", 0.1); /* GW ends where asperities touch */
    assert_string_equal(jg->style[1], "s1x");
    assert_solid_then_dashed(jg, 0, *state, "jg", 0); /* JG there or where a/R leaves the fit */
    for (size_t b = 0; b < elastic->blocks; b++)      /* multiscale models are valid at any area */
        assert_null(strchr(elastic->style[b], 'x'));
    free(gw);
    free(jg);
    free(elastic);
}

/* The chart of the baseline names its curves by model; adjusted and scale-dependent ones stand beside the plain. */
TEST_CASE(test_the_models_of_the_baseline)
{
    static const struct {
        const char *number, *styles;
    } rows[] = {
        {"6-05", "me mp gw gwx jg jgx "},
        {"6-06", "me mp gw gwx gwa gwax jg jgx jga jgax "},
        {"6-07", "me mp gw gwx gwa gwax jg jgx jga jgax "},
        {"6-08", "me mp gw gwx jg jgx "},
        {"6-09", "me meS mp mpS gw gwx gwS gwSx jg jgx jgS jgSx "},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct drawn *drawing = read_drawing(*state, rows[i].number);
        struct text styles = {0};
        for (size_t b = 0; b < drawing->blocks; b++)
            text_add(&styles, "%s ", drawing->style[b]);
        assert_string_equal(text_string(&styles), rows[i].styles);
        text_free(&styles);
        free(drawing);
    }
}

/* Each model is drawn in the colour of its row. */
TEST_CASE(test_models_have_their_colours)
{
    struct text svg = directory_read(*state, "out/figures/6-05.svg");
    for (int k = 0; k < 4; k++) {
        unsigned red, green, blue;
        char colour[64];
        const char *of_row = model_rows[model_named(thesis_models[k])]->colour;
        assert_int_equal(sscanf(of_row, "#%2x%2x%2x", &red, &green, &blue), 3);
        snprintf(colour, sizeof colour, "<path stroke='rgb(%3u, %3u, %3u)'", red, green, blue);
        if (!strstr(svg.data, colour))
            fail_msg("no %s", colour);
    }
    text_free(&svg);
}

/* A profile is thinned for its chart, but no peak is lost. */
TEST_CASE(test_a_thinned_profile_keeps_its_spike)
{
    struct drawn *drawing = read_drawing(*state, "6-10");
    size_t block = 2, highest = 0;
    assert_in_range(drawing->rows[block], 500, 1000);
    for (size_t k = 1; k < drawing->rows[block]; k++) {
        assert_true(drawing->x[block][k] > drawing->x[block][k - 1]);
        highest = drawing->y[block][k] > drawing->y[block][highest] ? k : highest;
    }
    assert_near(drawing->x[block][highest], SPIKE * 0.5e-3, 1e-6); /* mm */
    assert_true(drawing->y[block][highest] > 20);                  /* um */
    assert_int_equal(drawing->rows[0], 120);
    free(drawing);
}

/* The block of that style. */
static size_t block_of(const struct drawn *drawing, const char *style)
{
    for (size_t b = 0; b < drawing->blocks; b++)
        if (strcmp(drawing->style[b], style) == 0)
            return b;
    fail_msg("no block %s", style);
    return 0;
}

/* What the axes of a figure's script hold; returns how many numbers that are. */
static size_t read_axes(double *axes, const struct directory *place, const char *out, const char *number)
{
    char *line = script_line(place, out, number, "\n# axes: "), *rest = line;
    size_t count = 0;
    for (char *from = rest; count < 6; count++, from = rest) {
        axes[count] = strtod(from, &rest);
        if (rest == from)
            break;
    }
    free(line);
    return count;
}

/* The charts of all surfaces have one y range a quantity and one x range. */
TEST_CASE(test_charts_of_all_surfaces_share_their_axes)
{
    double first[6], axes[6];
    static const struct {
        int from, to;
        size_t count;
    } quantities[] = {{11, 14, 4}, {15, 22, 4}, {23, 26, 4}, {27, 30, 6}};
    for (size_t q = 0; q < sizeof quantities / sizeof *quantities; q++)
        for (int n = quantities[q].from; n <= quantities[q].to; n++) {
            assert_int_equal(read_axes(axes, *state, "out", numbered(n)), quantities[q].count);
            if (n == quantities[q].from)
                memcpy(first, axes, sizeof first);
            for (size_t k = 2; k < quantities[q].count; k++)
                assert_near(axes[k], first[k], 0);
            if (n == 19)
                memcpy(first, axes, 2 * sizeof *first); /* against area */
            assert_near(axes[0], first[0], 0);
            assert_near(axes[1], first[1], 0);
            struct drawn *drawing = read_drawing(*state, numbered(n));
            for (size_t b = 0; b < drawing->blocks; b++)
                for (size_t k = 0; k < drawing->rows[b] && !strchr(drawing->style[b], 'S'); k++)
                    assert_true(drawing->y[b][k] <= axes[3] * (1 + 1e-5));
            free(drawing);
        }
}

/* A chart that shows separations adjusted as well is cut at -0.5 sigma, others are not. */
TEST_CASE(test_separations_are_cut)
{
    double axes[6], least = INFINITY;
    struct drawn *drawing = read_drawing(*state, "6-07");
    for (size_t b = 0; b < drawing->blocks; b++)
        for (size_t k = 0; k < drawing->rows[b]; k++)
            least = fmin(least, drawing->y[b][k]);
    assert_true(least < -0.5); /* the data go on */
    read_axes(axes, *state, "out", "6-07");
    assert_near(axes[2], -0.5, 0);
    read_axes(axes, *state, "out", "6-06");
    assert_near(axes[2], -0.5, 0);
    free(drawing);
}

/* Every curve of a resistance ends with a row of 0 at its full contact, between the last load before and the next. */
TEST_CASE(test_resistances_end_at_full_contact)
{
    struct drawn *drawing = read_drawing(*state, "6-23"); /* multiscale-plastic */
    size_t block = block_of(drawing, "s1"), last = drawing->rows[block] - 1;
    double load[64], ecr[64];
    size_t rows = read_column(load, ecr, *state, "multiscale-plastic", "ecr_ohm_m2"), full = 0;
    while (full < rows && ecr[full] > 0)
        full++;
    assert_true(full > 1 && full < rows);
    assert_int_equal(last, full);
    assert_near(drawing->y[block][last], 0, 0);
    assert_true(drawing->x[block][last] > load[full - 1] && drawing->x[block][last] <= load[full]);
    assert_true(drawing->x[block][last] < load[full] * 0.999); /* at its own load, not that of the next row */
    for (size_t k = 0; k < full; k++)
        assert_near(drawing->y[block][k], ecr[k], written);
    free(drawing);
}

/* The mean of scans is not known between the first that is in full contact and the last: its curve ends before. */
TEST_CASE(test_means_of_scans_end_where_they_are_known)
{
    const struct directory *place = *state;
    pipeline_rough(place, "scans/a.csv", 120, 0.1, 1);
    pipeline_rough(place, "scans/b.csv", 120, 1, 2);
    directory_write(place, "scans/scene.yaml",
                    "material: tin\neffects: [electrical]\nload: {from: 1e-6, to: 1, points: 60}\n"
                    "surfaces: [{name: both, file: [a.csv, b.csv]}, {name: a, file: a.csv}]\n");
    assert_int_equal(pipeline_run(place, "scans", "out-scans", 1), 0);
    struct text data = directory_read(place, "out-scans/figures/6-24.csv");
    const char *both = strstr(data.data, "\"both, "), *end = both ? strstr(both, "\n\n\n") : NULL;
    assert_non_null(both);
    const char *zero = strstr(both, ",0\n");
    assert_true(!zero || (end && zero > end));
    assert_non_null(strstr(data.data, ",0\n")); /* the other surface's */
    text_free(&data);
}

/* The panel below holds scale-dependent over plain, and is not there without the effect. */
TEST_CASE(test_the_panel_below_holds_ratios)
{
    const struct directory *place = *state;
    struct drawn *drawing = read_drawing(place, "6-28"); /* multiscale-elastic */
    size_t block = block_of(drawing, "s1S"), rows;
    double load[64], plain[64], dependent[64];
    rows = read_column(load, plain, place, "multiscale-elastic", "tcr_K_m2_per_W");
    assert_int_equal(read_column(load, dependent, place, "multiscale-elastic", "tcr_sd_K_m2_per_W"), rows);
    assert_true(drawing->rows[block] > 5);
    for (size_t k = 0; k < drawing->rows[block]; k++) {
        assert_near(drawing->x[block][k], load[k], written);
        assert_near(drawing->y[block][k], dependent[k] / plain[k], written);
        assert_true(drawing->y[block][k] > 1);
    }
    free(drawing);
    pipeline_rough(place, "thermal/a.csv", 64, 1, 1);
    directory_write(place, "thermal/scene.yaml", "material: tin\neffects: [thermal]\n");
    assert_int_equal(pipeline_run(place, "thermal", "out-thermal", 1), 0);
    expect_in_file(place, "out-thermal/figures/6-09.gp", "# curves: me ");
    expect_not_in_file(place, "out-thermal/figures/6-09.gp", "meS");
    double axes[6];
    assert_int_equal(read_axes(axes, place, "out-thermal", "6-09"), 4);
}

/* A rough counterface has its profile beside those of the surfaces. */
TEST_CASE(test_the_counterface_is_drawn)
{
    const struct directory *place = *state;
    pipeline_rough(place, "pair/a.csv", 64, 1, 1);
    pipeline_rough(place, "pair/other.csv", 64, 2, 2);
    directory_write(place, "pair/scene.yaml",
                    "material: tin\neffects: []\nsurfaces: [{name: a, file: a.csv}]\n"
                    "counterface: {surface: other.csv, material: tin}\n");
    assert_int_equal(pipeline_run(place, "pair", "out-pair", 1), 0);
    expect_in_file(place, "out-pair/figures/6-10.gp", "# curves: s1 cf\n");
    struct text data = directory_read(place, "out-pair/figures/6-10.csv");
    const char *block = strstr(data.data, "\"counterface, Rq ");
    assert_non_null(block);
    size_t rows = 0;
    for (const char *line = block; (line = strchr(line, '\n')); line++)
        rows += line[1] != '\0';
    assert_int_equal(rows, 64);
    text_free(&data);
}

/* The blocks that figure_hidden_put() adds to lines of y = 10^exponent against x = 1...20. */
static struct text hidden_of(double (*exponent)(size_t line, double x), size_t lines, char *styles, size_t size)
{
    struct figure_file file = figure_data_start(NULL);
    for (size_t i = 0; i < lines; i++) {
        char style[24];
        snprintf(style, sizeof style, "s%zu", i + 1);
        figure_hidden_begin(&file.lines, style);
        for (int x = 1; x <= 20; x++)
            figure_hidden_keep(&file.lines, x, pow(10, exponent(i, x)));
    }
    figure_hidden_put(&file, (struct figure_extent){1, 20}, (struct figure_extent){1, 1e4}, false, true);
    assert_false(file.lines.failed);
    struct text out = {0};
    size_t used = 0;
    *styles = '\0';
    for (size_t b = 0; b < file.drawing.blocks; b++)
        used += (size_t)snprintf(styles + used, size - used, "%s%s", b > 0 ? " " : "", file.drawing.block[b].style);
    drawing_data(&out, &file.drawing);
    figure_data_free(&file);
    return out;
}

static double joining(size_t line, double x)
{
    return line == 0 ? fmin(1 + 0.1 * x, 2) : fmin(0.5 + 0.15 * x, 2); /* together from 10 on */
}

static double crossing(size_t line, double x)
{
    return line == 0 ? 0.2 * x : 4 - 0.2 * x;
}

static double within_a_point(size_t line, double x)
{
    return 0.1 * x + 4.0 / 340 * (double)line * 1.4; /* the third is beyond a point and a half of the first */
}

static double same(size_t line, double x)
{
    (void)line;
    return 0.2 * x;
}

TEST_CASE(test_hidden_stretches)
{
    static const struct {
        double (*exponent)(size_t line, double x);
        size_t lines;
        const char *styles, *begins;
        size_t rows;
    } cases[] = {
        {joining, 2, "s1h12", "\"hidden\"\n10,100\n11,100\n", 1 + 11},
        {crossing, 2, "", "", 0},
        {same, 3, "s1h23 s2h13", "\"hidden\"\n", 2 + 2 * 20 + 2},
        /* each next one hides the one before, the third not the first */
        {within_a_point, 3, "s1h12 s2h13", "\"hidden\"\n", 2 + 2 * 20 + 2},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char styles[100];
        struct text hidden = hidden_of(cases[i].exponent, cases[i].lines, styles, sizeof styles);
        size_t rows = 0;
        for (const char *c = text_string(&hidden); *c; c++)
            rows += *c == '\n';
        assert_string_equal(styles, cases[i].styles);
        assert_int_equal(strncmp(text_string(&hidden), cases[i].begins, strlen(cases[i].begins)), 0);
        assert_int_equal(rows, cases[i].rows);
        text_free(&hidden);
    }
}

TEST_GROUP(place_setup, directory_teardown)
