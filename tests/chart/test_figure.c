#include "chart/figure.h"
#include "run/pipeline.h"

#include <ctype.h>

enum { BLOCKS_MOST = 32, ROWS_MOST = 1100, SPIKE = 1234 };

/* A quote, an end of line, commands, gnuplot's marks: YAML escapes, and what of it may reach a data file. */
static const char hostile_yaml[] = "\"x'); system('touch pwned') #\\\"`touch pwned` @a $b %d \\\\n {c} µ, \"";
static const char hostile_field[] = "\"x'); system('touch pwned') #'`touch pwned` @a $b %d \\\\n {c} µ, ";

static int place_setup(void **state)
{
    static struct directory place;
    struct text scene = {0};
    place = directory_make();
    mkdir(directory_path(&place, "in"), 0777);
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

static int place_teardown(void **state)
{
    directory_remove(*state);
    return 0;
}

/* A figure's data as gnuplot sees it, with the style words its script gives to the blocks. */
struct drawing {
    size_t blocks, rows[BLOCKS_MOST];
    char legend[BLOCKS_MOST][300], style[BLOCKS_MOST][32];
    double x[BLOCKS_MOST][ROWS_MOST], y[BLOCKS_MOST][ROWS_MOST];
};

static void read_styles(struct drawing *drawing, const struct directory *place, const char *number)
{
    char name[64], *word, *rest;
    snprintf(name, sizeof name, "out/figures/%s.gp", number);
    struct text script = directory_read(place, name);
    char *end = strrchr(script.data, '\'');
    assert_non_null(end);
    assert_string_equal(end, "'\n");
    *end = '\0';
    char *start = strrchr(script.data, '\'');
    assert_non_null(start);
    if (isdigit((unsigned char)start[1])) { /* what the axes are to hold follows the styles */
        assert_int_equal(start[-2], '\'');
        start[-2] = '\0';
        start = strrchr(script.data, '\'');
        assert_non_null(start);
    }
    size_t count = 0;
    for (word = strtok_r(start + 1, " ", &rest); word; word = strtok_r(NULL, " ", &rest), count++) {
        assert_true(count < BLOCKS_MOST);
        snprintf(drawing->style[count], sizeof drawing->style[0], "%s", word);
    }
    assert_int_equal(count, drawing->blocks);
    text_free(&script);
}

static struct drawing *read_drawing(const struct directory *place, const char *number)
{
    struct drawing *drawing = calloc(1, sizeof *drawing);
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
enum { ALL_EFFECTS = (1u << EFFECT_COUNT) - 1, ALL_MODELS = 15 };

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

/* How many figures of that number the list has. */
static size_t times_listed(const struct figure_list *list, const char *number)
{
    size_t times = 0;
    for (size_t i = 0; i < list->count; i++)
        times += strcmp(list->figures[i].number, number) == 0;
    return times;
}

static void test_every_number_exists_once(void **state)
{
    (void)state;
    struct benchmark_row rows[] = {{.chart = BENCHMARK_CURVES}, {.chart = BENCHMARK_INTEGRALS}};
    const struct benchmark cost = {.rows = rows, .count = 2};
    struct figure_list list = list_of(ALL_EFFECTS, ALL_MODELS, &cost);
    for (int n = 1; n <= 30; n++) {
        char number[8];
        snprintf(number, sizeof number, "6-%02d", n);
        assert_int_equal(times_listed(&list, number), 1);
        assert_string_equal(list.figures[n - 1].number, number); /* in the order of the chapter */
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
static void test_which_model_a_figure_shows(void **state)
{
    (void)state;
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

static void test_effects_and_models_that_are_off_remove_their_figures(void **state)
{
    (void)state;
    struct benchmark_row row = {.chart = BENCHMARK_CURVES};
    const struct benchmark cost = {.rows = &row, .count = 1};
    for (unsigned effects = 0; effects <= ALL_EFFECTS; effects++)
        for (unsigned which = 1; which <= ALL_MODELS; which++) {
            struct figure_list list = list_of(effects, which, NULL), timed = list_of(effects, which, &cost);
            for (int n = 1; n <= 30; n++) {
                char number[8];
                snprintf(number, sizeof number, "6-%02d", n);
                if (times_listed(&list, number) != is_called_for(n, effects, which))
                    fail_msg("figure %s, effects %x, models %x", number, effects, which);
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
static void test_the_files_are_those_of_the_figures(void **state)
{
    const struct directory *place = *state;
    mkdir(directory_path(place, "electrical"), 0777);
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
        {"area-load-two-band-plastic", {true, false}},
        {"separation-load-two-band-plastic", {true, false}},
        {"separation-area-two-band-plastic", {true, false}},
        {"ecr-load-two-band-plastic", {true, false}},
        {"tcr-load-two-band-plastic", {true, false}},
        {"area-load-two-band-elastic", {false, true}},
        {"ecr-load-two-band-elastic", {false, true}},
        {"sensitivity-area", {true, true}},
        {"sensitivity-ecr", {true, true}},
    };
    for (size_t o = 0; o < 2; o++) {
        size_t files = 0;
        char name[64];
        for (int n = 1; n <= 30; n++)
            for (int e = 0; e < 3; e++) {
                snprintf(name, sizeof name, "%s/figures/6-%02d.%s", outs[o], n, endings[e]);
                assert_int_equal(directory_has(place, name), is_called_for(n, effects[o], ALL_MODELS));
                files += directory_has(place, name);
            }
        for (size_t i = 0; i < sizeof others / sizeof *others; i++)
            for (int e = 0; e < 3; e++) {
                snprintf(name, sizeof name, "%s/figures/%s.%s", outs[o], others[i].name, endings[e]);
                if (directory_has(place, name) != others[i].on[o])
                    fail_msg("%s", name);
                files += others[i].on[o];
            }
        snprintf(name, sizeof name, "%s/figures", outs[o]);
        assert_int_equal(directory_entries(place, name), files + 10); /* the templates and models.gp */
    }
}

/* Every block has a style word, and rows that its axes can show. */
static void test_every_data_file_fits_its_script(void **state)
{
    struct figure_list list = list_of(ALL_EFFECTS, ALL_MODELS, NULL); /* timings are not made here */
    for (size_t i = 0; i < list.count; i++) {
        const struct figure_row *row = list.figures[i].row;
        struct drawing *drawing = read_drawing(*state, list.figures[i].number);
        size_t expected = row->kind == FIGURE_SWEEP      ? row->sweep == CONVERGENCE_ALPHA ? 7 : 9
                          : row->kind == FIGURE_PROFILES ? 3
                          : row->kind == FIGURE_SPECTRA
                              ? 3 * 7 /* points, law in and out of its band, bins of three kinds, knees */
                              : 0;
        if (expected)
            assert_int_equal(drawing->blocks, expected);
        for (size_t b = 0; b < drawing->blocks; b++)
            for (size_t k = 0; k < drawing->rows[b] && row->kind != FIGURE_PROFILES; k++) {
                assert_true(drawing->x[b][k] > 0);
                assert_true(row->y == QUANTITY_SEPARATION || drawing->y[b][k] > 0);
            }
        free(drawing);
    }
    figure_list_free(&list);
}

static void test_a_hostile_name_is_only_a_legend(void **state)
{
    const struct directory *place = *state;
    struct figure_list list = list_of(ALL_EFFECTS, ALL_MODELS, NULL);
    size_t seen = 0;
    for (size_t i = 0; i < list.count; i++) {
        char name[96];
        snprintf(name, sizeof name, "out/figures/%s.gp", list.figures[i].number);
        struct text script = directory_read(place, name);
        assert_null(strstr(script.data, "pwned"));
        text_free(&script);
        struct drawing *drawing = read_drawing(place, list.figures[i].number);
        for (size_t b = 0; b < drawing->blocks; b++)
            seen += strncmp(drawing->legend[b], hostile_field, strlen(hostile_field)) == 0;
        free(drawing);
    }
    figure_list_free(&list);
    assert_true(seen >= 20 + 2); /* 6-11 to 6-30, profiles, spectra */
    assert_false(directory_has(place, "out/figures/pwned"));
    assert_int_not_equal(access("pwned", F_OK), 0);
}

/* The rows of one surface and model in contact.csv, whose names here hold no comma. */
static size_t read_curve(double *load, double *area, const struct directory *place, const char *model)
{
    struct text text = directory_read(place, "out/data/contact.csv");
    char start[64];
    size_t rows = 0;
    snprintf(start, sizeof start, "\na,%s,", model);
    for (const char *line = text.data; (line = strstr(line, start)); rows++) {
        char *rest;
        line += strlen(start);
        load[rows] = strtod(line, &rest);
        strtod(rest + 1, &rest); /* pressure */
        area[rows] = strtod(rest + 1, &rest);
    }
    text_free(&text);
    return rows;
}

/* Solid up to the last valid point, dashed from that same point on; together the whole curve. */
static void assert_solid_then_dashed(const struct drawing *drawing, size_t block, const struct directory *place,
                                     const char *model, double touching)
{
    double load[64], area[64];
    size_t rows = read_curve(load, area, place, model), solid = drawing->rows[block];
    assert_int_equal(solid + drawing->rows[block + 1] - 1, rows);
    assert_true(solid > 1 && solid < rows);
    for (size_t k = 0; k < rows; k++) {
        size_t b = k < solid ? block : block + 1, row = k < solid ? k : k - solid + 1;
        assert_near(drawing->x[b][row], load[k], 0);
        assert_near(drawing->y[b][row], area[k], 0);
        if (k < solid)
            assert_true(area[k] <= 0.1);
    }
    assert_near(drawing->x[block + 1][0], load[solid - 1], 0);
    assert_near(drawing->y[block + 1][0], area[solid - 1], 0);
    if (touching > 0)
        assert_true(area[solid] > touching);
}

static void test_dashed_curves_begin_at_the_last_valid_point(void **state)
{
    struct drawing *gw = read_drawing(*state, "6-14"), *jg = read_drawing(*state, "6-13"),
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
static void test_the_models_of_the_baseline(void **state)
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
        struct drawing *drawing = read_drawing(*state, rows[i].number);
        struct text styles = {0};
        for (size_t b = 0; b < drawing->blocks; b++)
            text_add(&styles, "%s ", drawing->style[b]);
        assert_string_equal(text_string(&styles), rows[i].styles);
        text_free(&styles);
        free(drawing);
    }
}

/* Each model is drawn in the colour of its row. */
static void test_models_have_their_colours(void **state)
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
static void test_a_thinned_profile_keeps_its_spike(void **state)
{
    struct drawing *drawing = read_drawing(*state, "6-10");
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_number_exists_once),
        cmocka_unit_test(test_which_model_a_figure_shows),
        cmocka_unit_test(test_effects_and_models_that_are_off_remove_their_figures),
        cmocka_unit_test(test_the_files_are_those_of_the_figures),
        cmocka_unit_test(test_every_data_file_fits_its_script),
        cmocka_unit_test(test_a_hostile_name_is_only_a_legend),
        cmocka_unit_test(test_dashed_curves_begin_at_the_last_valid_point),
        cmocka_unit_test(test_the_models_of_the_baseline),
        cmocka_unit_test(test_models_have_their_colours),
        cmocka_unit_test(test_a_thinned_profile_keeps_its_spike),
    };
    return cmocka_run_group_tests(tests, place_setup, place_teardown);
}
