#include "base/program.h"
#include "base/text.h"
#include "chart/gnuplot.h"
#include "contact/model.h"
#include "support.h"

#include <dirent.h>
#include <fcntl.h>
#include <glob.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

/* Every test draws in its own directory, which holds copies of all templates and samples, as a report's does. */
struct place {
    char directory[512];
};

static void copy_all(const char *pattern, const char *directory)
{
    glob_t found;
    assert_int_equal(glob(pattern, 0, NULL, &found), 0);
    for (size_t i = 0; i < found.gl_pathc; i++) {
        struct status status = {0};
        struct text bytes = {0};
        char path[1024];
        snprintf(path, sizeof path, "%s/%s", directory, strrchr(found.gl_pathv[i], '/') + 1);
        assert_int_equal(text_read_file(&bytes, found.gl_pathv[i], &status), STATUS_OK);
        assert_int_equal(text_write_file(path, bytes.data, bytes.length, &status), STATUS_OK);
        text_free(&bytes);
    }
    globfree(&found);
}

static int place_setup(void **state)
{
    static struct place place;
    const char *temporary = getenv("TMPDIR");
    snprintf(place.directory, sizeof place.directory, "%s/test_gnuplot.XXXXXX", temporary ? temporary : "/tmp");
    assert_non_null(mkdtemp(place.directory));
    copy_all(PROJECT_SOURCE "/templates/*.gp", place.directory);
    copy_all(TEST_DATA "/chart/*.csv", place.directory);
    *state = &place;
    return 0;
}

static int place_teardown(void **state)
{
    const struct place *place = *state;
    DIR *directory = opendir(place->directory);
    assert_non_null(directory);
    for (const struct dirent *entry; (entry = readdir(directory));)
        if (entry->d_name[0] != '.' || strcmp(entry->d_name, ".gnuplot") == 0)
            assert_int_equal(unlinkat(dirfd(directory), entry->d_name, 0), 0);
    closedir(directory);
    return rmdir(place->directory);
}

static void write_file(const struct place *place, const char *name, const char *content)
{
    struct status status = {0};
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", place->directory, name);
    assert_int_equal(text_write_file(path, content, strlen(content), &status), STATUS_OK);
}

static struct text read_file(const struct place *place, const char *name)
{
    struct status status = {0};
    struct text text = {0};
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", place->directory, name);
    assert_int_equal(text_read_file(&text, path, &status), STATUS_OK);
    return text;
}

static bool exists(const struct place *place, const char *name)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", place->directory, name);
    return access(path, F_OK) == 0;
}

/* The look of the models, as a report has it beside its charts. */
static void write_models(const struct place *place)
{
    struct text script = {0};
    for (size_t m = 0; m < model_count; m++)
        text_add(&script, "colour_%s = '%s'; marker_%s = %d\n", model_rows[m]->style, model_rows[m]->colour,
                 model_rows[m]->style, model_rows[m]->marker);
    write_file(place, "models.gp", text_string(&script));
    text_free(&script);
}

/* Sends `commands` to one gnuplot and returns how it ended. */
static enum status_code run(const struct place *place, const char *commands, struct status *status)
{
    struct gnuplot gnuplot;
    enum status_code code = gnuplot_start(&gnuplot, place->directory, status);
    if (code)
        return code;
    gnuplot_send(&gnuplot, "%s", commands);
    return gnuplot_finish(&gnuplot, status);
}

static void run_well(const struct place *place, const char *commands)
{
    struct status status = {0};
    if (run(place, commands, &status) != STATUS_OK)
        fail_msg("%s\nafter: %s", status.message, commands);
}

static size_t count(const char *text, const char *part)
{
    size_t n = 0;
    for (; (text = strstr(text, part)); text += strlen(part))
        n++;
    return n;
}

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

/* Each sample with how many pieces gnuplot draws: one for the frame (a panel has its own), lines solid and dashed,
 * markers, legend entries. */
static const struct sample {
    const char *name, *template, *rest;
    size_t pieces;
    const char *legend; /* some text that has to be readable in the chart */
} samples[] = {
    {"area", "curves", "'load P/(A_nE′)' 'A/A_n' 'xy' 's1 s1x s2 s2x s3 s3x s4 s4x'", 1 + 8 + 4 + 1, "surface 4, Rq"},
    {"separation", "curves", "'load P/(A_nE′)' 'separation / σ' 'x' 's1 s2 s3 s4'", 1 + 4 + 4, "surface 1, Rq 0.24 µm"},
    {"separation-area", "curves", "'A/A_n' 'separation / σ' '' 's1 s2 s3 s4'", 1 + 4 + 4, "separation / σ"},
    {"ecr", "curves", "'load P/(A_nE′)' 'ECR·A_n in Ω m^2' 'xy' 's1 s2 s3 s4'", 1 + 4 + 4, "surface 2"},
    {"models-area", "curves", "'load' 'A/A_n' 'xy' 'me mp gw gwx jg jgx'", 1 + 6 + 4 + 4 + 1, "Jackson–Green"},
    {"models-separation", "curves", "'load' 'separation in µm' 'x' 'me mp gw gwx gwa gwax jg jgx jga jgax'",
     1 + 10 + 4 + 6 + 1, "Greenwood–Williamson, adjusted"},
    {"models-tcr", "curves", "'load' 'TCR·A_n in K m^2/W' 'xy' 'me meS mp mpS gw gwS jg jgS'",
     1 + 4 + 4 + 4 + (1 + 4 + 4), "multiscale elastic-plastic"},
    {"sweep", "curves", "'wavelength in m' 'A/A_n' 'xy' 'r1 r2 r3 r4 r5 r6 r7 r8 r9'", 1 + 9, "γ = 1.75"},
    {"profiles", "profiles", "'s1 s2 s3 s4'", 2 * 4, "surface 4, Rq 5.82 µm"},
    {"spectra", "spectra", "'s1 fit fitx s2 fit fitx s3 fit fitx s4 fit fitx'", 4 * (1 + 3), "surface 3, Rq 1.05 µm"},
    {"cost", "cost", "'c1 c2 c3 c4 choice'", 1 + 4 + 2, "Gauss–Legendre panels"},
};
enum { SAMPLES = sizeof samples / sizeof *samples };

static void draw_all(const struct place *place, const char *before, const char *ending)
{
    struct gnuplot gnuplot;
    struct status status = {0};
    write_models(place);
    assert_int_equal(gnuplot_start(&gnuplot, place->directory, &status), STATUS_OK);
    gnuplot_send(&gnuplot, "load 'models.gp'");
    gnuplot_send(&gnuplot, "%s", before);
    for (size_t i = 0; i < SAMPLES; i++)
        gnuplot_send(&gnuplot, "call '%s.gp' '%s.csv' '%s.%s' 'a title' %s", samples[i].template, samples[i].name,
                     samples[i].name, ending, samples[i].rest);
    if (gnuplot_finish(&gnuplot, &status) != STATUS_OK)
        fail_msg("%s", status.message);
    assert_true(gnuplot.seconds > 0.0);
}

static void test_every_template_draws_an_svg(void **state)
{
    draw_all(*state, "", "svg");
    for (size_t i = 0; i < SAMPLES; i++) {
        char name[64];
        snprintf(name, sizeof name, "%s.svg", samples[i].name);
        struct text svg = read_file(*state, name);
        assert_well_formed(text_string(&svg));
        if (pieces_of(svg.data) != samples[i].pieces || !strstr(svg.data, samples[i].legend))
            fail_msg("%s: %zu pieces, expected %zu with '%s'", name, pieces_of(svg.data), samples[i].pieces,
                     samples[i].legend);
        assert_non_null(strstr(svg.data, "a title"));
        assert_in_range(svg.length, 10000, 130000);
        text_free(&svg);
    }
}

static void test_every_template_draws_text(void **state)
{
    draw_all(*state, "dumb_size = '90,44'", "txt");
    for (size_t i = 0; i < SAMPLES; i++) {
        char name[64];
        snprintf(name, sizeof name, "%s.txt", samples[i].name);
        struct text chart = read_file(*state, name);
        if (!strstr(text_string(&chart), samples[i].legend))
            fail_msg("no '%s' in\n%s", samples[i].legend, text_string(&chart));
        assert_null(strpbrk(chart.data, "\033{}"));
        assert_in_range(count(chart.data, "\n"), 40, 50);
        text_free(&chart);
    }
    struct text area = read_file(*state, "area.txt");
    for (const char *letter = "ABCD"; *letter; letter++) {
        char run_of_letters[] = {*letter, ' ', ' ', 's', 'u', 'r', 'f', '\0'};
        assert_non_null(strstr(area.data, run_of_letters));
    }
    text_free(&area);
}

static void test_the_same_data_give_the_same_bytes(void **state)
{
    draw_all(*state, "", "svg");
    draw_all(*state, "", "again");
    for (size_t i = 0; i < SAMPLES; i++) {
        char name[64];
        snprintf(name, sizeof name, "%s.svg", samples[i].name);
        struct text first = read_file(*state, name);
        snprintf(name, sizeof name, "%s.again", samples[i].name);
        struct text second = read_file(*state, name);
        assert_string_equal(text_string(&first), text_string(&second));
        text_free(&first);
        text_free(&second);
    }
}

static void test_eight_curves_stay_small(void **state)
{
    struct text data = {0};
    for (int curve = 1; curve <= 8; curve++) {
        text_add(&data, "\"a rather long name of surface %d, cold rolled, Rq 0.24 µm\"\n", curve);
        for (int i = 0; i <= 120; i++)
            text_add(&data, "%.17g,%.17g\n", pow(10, -6 + i / 24.0), fmin(1, curve * pow(10, -4 + i / 25.0)));
        text_add(&data, "\n\n");
    }
    write_file(*state, "eight.csv", text_string(&data));
    text_free(&data);
    run_well(*state, "call 'curves.gp' 'eight.csv' 'eight.svg' '' 'load' 'area' 'xy' 's1 s2 s3 s4 s5 s6 s7 s8'");
    struct text svg = read_file(*state, "eight.svg");
    assert_int_equal(pieces_of(text_string(&svg)), 1 + 8 + 8);
    assert_in_range(svg.length, 20000, 60000);
    text_free(&svg);
}

static void test_empty_blocks_and_single_points_are_drawn_silently(void **state)
{
    write_file(*state, "none.csv", "\"a\"\n\n\n\"b\"\n1,0\n2,nan\n\n\n\"\"\n");
    write_file(*state, "few.csv", "\"a\"\n1e-4,0.5\n\n\n\"b\"\n\n\n\"c\"\n1e-4,1\n1e-3,0\n1e-2,2\n\n3e-2,3\n4e-2,4\n");
    run_well(*state, "call 'curves.gp' 'none.csv' 'curves.svg' '' 'x' 'y' 'xy' 's1 s2 s2x'\n"
                     "call 'profiles.gp' 'few.csv' 'profiles.svg' '' 's1 s2 s3'\n"
                     "call 'spectra.gp' 'none.csv' 'spectra.svg' '' 's1 fit fitx'\n"
                     "call 'cost.gp' 'none.csv' 'cost.svg' '' 'c1 c2 choice'\n"
                     "call 'spectra.gp' 'few.csv' 'few-spectra.svg' '' 's1 s2 fit'\n"
                     "call 'curves.gp' 'few.csv' 'few.svg' '' 'x' 'y' 'xy' 's1 s2 s3'\n"
                     "dumb_size = '60,20'\n"
                     "call 'curves.gp' 'none.csv' 'curves.txt' '' 'x' 'y' 'xy' 's1 s2 s2x'");
    const char *const empty[] = {"curves.svg", "spectra.svg", "cost.svg", "curves.txt"};
    for (size_t i = 0; i < sizeof empty / sizeof *empty; i++) {
        struct text chart = read_file(*state, empty[i]);
        assert_int_equal(count(text_string(&chart), "no data in range"), 1);
        text_free(&chart);
    }
    struct text few = read_file(*state, "few.svg");
    assert_int_equal(pieces_of(text_string(&few)), 1 + 1 + 1 + 2);
    assert_null(strstr(few.data, "no data in range"));
    text_free(&few);
}

/* The pieces of a chart of `data`, drawn by curves.gp with the arguments behind its title. */
static struct text draw_curves(const struct place *place, const char *data, const char *arguments, size_t pieces)
{
    char command[512];
    write_file(place, "data.csv", data);
    write_models(place);
    snprintf(command, sizeof command, "load 'models.gp'\ncall 'curves.gp' 'data.csv' 'data.svg' '' %s", arguments);
    run_well(place, command);
    struct text svg = read_file(place, "data.svg");
    if (pieces_of(text_string(&svg)) != pieces)
        fail_msg("%s: %zu pieces, expected %zu", arguments, pieces_of(svg.data), pieces);
    return svg;
}

/* With one load, models differ by their markers, on the chart and in its legend. */
static void test_single_points_have_the_markers_of_their_models(void **state)
{
    struct text svg = draw_curves(*state, "\"a\"\n1e-4,0.1\n\n\n\"b\"\n1e-4,0.2\n\n\n\"c\"\n1e-4,0.3\n",
                                  "'x' 'y' 'xy' 'me mp gw' '1.0e-4 1.0e-4 1.0e-1 3.0e-1'", 1 + 3 + 3);
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
static void test_two_bands_are_filled_others_are_bars(void **state)
{
    struct text data = {0};
    char arguments[200];
    for (size_t bands = 1; bands <= 4; bands++) {
        text_add(&data, "%s\"band\"\n1e-4,1,2\n1e-3,2,3\n1e-2,3,4\n\n\n\"curve %zu\"\n1e-4,1\n1e-3,2\n1e-2,3\n",
                 bands > 1 ? "\n\n" : "", bands);
        snprintf(arguments, sizeof arguments, "'x' 'y' 'xy' '%.*s'", (int)(7 * bands - 1),
                 "s1b s1 s2b s2 s3b s3 s4b s4 ");
        struct text svg = draw_curves(*state, text_string(&data), arguments, 1 + 3 * bands + 1 + (bands > 2));
        assert_int_equal(strstr(svg.data, "the same, as bars") != NULL, bands > 2);
        assert_int_equal(count(svg.data, "fill-opacity = '0.200000'"), bands < 2 ? 1 : 2);
        text_free(&svg);
    }
    text_free(&data);
}

/* Curves are cut where the axes say; those that are not leave the axis alone. */
static void test_an_axis_ends_where_curves_are_cut(void **state)
{
    static const char data[] = "\"a\"\n1,3\n2,1\n3,-4\n";
    struct text whole = draw_curves(*state, data, "'x' 'y' '' 's1'", 1 + 1 + 1);
    struct text cut = draw_curves(*state, data, "'x' 'y' '' 's1' '1.0 3.0 -0.5 3.0'", 1 + 1 + 1);
    assert_non_null(strstr(whole.data, "−4"));
    assert_null(strstr(cut.data, "−"));
    text_free(&whole);
    text_free(&cut);
}

/* A row of 0 on a logarithmic axis ends its curve at the lower edge, without making room for it. */
static void test_a_zero_ends_at_the_lower_edge(void **state)
{
    double end[2];
    const char *const more[] = {"", "2e-2,0\n"};
    for (int k = 0; k < 2; k++) {
        char data[100];
        snprintf(data, sizeof data, "\"a\"\n1e-4,1e3\n1e-3,1e2\n1e-2,1e1\n%s", more[k]);
        struct text svg = draw_curves(*state, data, "'x' 'y' 'xy' 's1' '1.0e-4 1.0e-1 1.0 1.0e3'", 1 + 1 + 1);
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
static void test_labels_at_ends_do_not_touch(void **state)
{
    struct text svg = draw_curves(*state, "\"p\"\n1,0.5\n2,1\n\n\n\"q\"\n1,0.4\n2,1\n\n\n\"r\"\n1,0.3\n2,0.99\n",
                                  "'x' 'y' 'xy' 'r1 r2 r3'", 1 + 3);
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
static void test_no_error_is_off_the_scale(void **state)
{
    write_file(*state, "some.csv", "\"a\"\n1e-4,1e-2\n1e-3,1e-4\n");
    write_file(*state, "none.csv", "\"a\"\n1e-4,1e-2\n1e-3,1e-4\n1e-2,0\n");
    run_well(*state, "call 'cost.gp' 'some.csv' 'some.svg' '' 'c1'\ncall 'cost.gp' 'none.csv' 'none.svg' '' 'c1'");
    struct text some = read_file(*state, "some.svg"), none = read_file(*state, "none.svg");
    assert_null(strstr(text_string(&some), "lower edge"));
    assert_non_null(strstr(text_string(&none), "lower edge"));
    assert_int_equal(count(none.data, "transform='tr"), count(some.data, "transform='tr") + 2); /* it, and its note */
    assert_null(strstr(none.data, "−5"));
    assert_null(strstr(none.data, "−16<"));
    text_free(&some);
    text_free(&none);
}

static void test_the_smallest_and_largest_numbers_have_axes(void **state)
{
    write_file(*state, "wide.csv", "\"a\"\n1e-30,1e-299\n1e6,1e299\n");
    write_file(*state, "narrow.csv", "\"a\"\n0.02,5\n0.020000001,5\n");
    run_well(*state, "call 'curves.gp' 'wide.csv' 'wide.svg' '' 'x' 'y' 'xy' 's1'\n"
                     "call 'curves.gp' 'narrow.csv' 'narrow.svg' '' 'x' 'y' 'xy' 's1'\n"
                     "call 'curves.gp' 'narrow.csv' 'linear.svg' '' 'x' 'y' '' 's1'\n"
                     "call 'profiles.gp' 'narrow.csv' 'profile.svg' '' 's1'");
    struct text wide = read_file(*state, "wide.svg");
    assert_int_equal(count(text_string(&wide), "<path stroke='rgb( 18,  87, 208)'"), 2); /* the line and its sample */
    assert_in_range(count(wide.data, "<tspan"), 10, 60);
    text_free(&wide);
}

static const char hostile[] =
    "'q' \"d\" \\ \\n \\101 {/*9 x}^_@&<>% `touch pwned1` $(touch pwned2) \n\x1b[31m\x7f\xc2\x9b \xff\xed\xa0\x80,# µ";

static void test_hostile_names_are_only_text(void **state)
{
    char quoted[512], field[512];
    gnuplot_quote(quoted, sizeof quoted, hostile);
    gnuplot_field(field, sizeof field, hostile);
    struct text data = {0};
    text_add(&data, "%s\n1,1\n2,2\n\n\n%s\n1,2\n2,3\n", field, field);
    write_file(*state, "hostile.csv", text_string(&data));
    text_free(&data);

    struct gnuplot gnuplot;
    struct status status = {0};
    assert_int_equal(gnuplot_start(&gnuplot, ((struct place *)*state)->directory, &status), STATUS_OK);
    gnuplot_send(&gnuplot, "call 'curves.gp' 'hostile.csv' 'h1.svg' %s 'x' 'y' 'xy' 's1 s2'", quoted);
    gnuplot_send(&gnuplot, "call 'profiles.gp' 'hostile.csv' 'h2.svg' %s 's1 s2'", quoted);
    gnuplot_send(&gnuplot, "call 'spectra.gp' 'hostile.csv' 'h3.svg' %s 's1 fit'", quoted);
    gnuplot_send(&gnuplot, "call 'cost.gp' 'hostile.csv' 'h4.svg' %s 'c1 choice'", quoted);
    gnuplot_send(&gnuplot, "dumb_size = '120,30'");
    gnuplot_send(&gnuplot, "call 'curves.gp' 'hostile.csv' 'h5.txt' %s 'x' 'y' 'xy' 's1 s2'", quoted);
    if (gnuplot_finish(&gnuplot, &status) != STATUS_OK)
        fail_msg("%s", status.message);

    assert_false(exists(*state, "pwned1") || exists(*state, "pwned2"));
    for (int i = 1; i <= 4; i++) {
        char name[16];
        snprintf(name, sizeof name, "h%d.svg", i);
        struct text svg = read_file(*state, name);
        assert_well_formed(text_string(&svg));
        /* as title with its double quotes, as legend with single ones; nothing enhanced, nothing unescaped */
        assert_non_null(strstr(svg.data, "’q’ \"d\" \\ \\n \\101 {/*9 x}^_@&amp;&lt;>% `touch pwned1` $(touch"));
        assert_non_null(strstr(svg.data, i == 3 ? "'q' 'd' \\ \\n \\101 {/*9 x}^_@&amp;&lt;>% `tou"
                                                : "'q' 'd' \\ \\n \\101 {/*9 x}^_@&amp;&lt;>% `touch pwned1` $(touch"));
        text_free(&svg);
    }
    struct text chart = read_file(*state, "h5.txt");
    assert_null(strpbrk(text_string(&chart), "\033\x7f"));
    text_free(&chart);
}

static void test_quoting(void **state)
{
    (void)state;
    char out[64], tight[8];
    gnuplot_quote(out, sizeof out, "it's \"a\\b\" µ\n\xff");
    assert_string_equal(out, "'it’s \"a\\b\" µ\\x0a\\xff'");
    gnuplot_field(out, sizeof out, "it's \"a\\b\" µ\n\xff");
    assert_string_equal(out, "\"it's 'a\\\\b' µ\\\\x0a\\\\xff\"");
    gnuplot_quote(out, sizeof out, "\xc0\xaf\xed\xa0\x80\xc2\x85\xef\xbf\xbf|\xf0\x9f\x98\x80\xe2");
    assert_string_equal(out, "'\\xc0\\xaf\\xed\\xa0\\x80\\u0085\\uffff|\xf0\x9f\x98\x80\\xe2'");
    gnuplot_quote(out, sizeof out, "]]>]] >>"); /* no "]]>" in an SVG's text */
    assert_string_equal(out, "']]›]] >>'");
    gnuplot_field(out, sizeof out, "=1");
    assert_string_equal(out, "\"'=1\"");
    gnuplot_field(tight, 3, "=1");
    assert_string_equal(tight, "\"\"");
    gnuplot_quote(tight, sizeof tight, "abcdµµ"); /* µ takes two bytes and would leave no room for the mark */
    assert_string_equal(tight, "'abcd'");
    gnuplot_field(tight, sizeof tight, "abcd\\"); /* half a doubled backslash would take the mark */
    assert_string_equal(tight, "\"abcd\"");
    gnuplot_quote(tight, 3, "abc");
    assert_string_equal(tight, "''");
    gnuplot_quote(tight, 2, "abc");
    assert_string_equal(tight, "");
}

static void test_a_missing_gnuplot_names_the_package(void **state)
{
    char *path = strdup(getenv("PATH"));
    const char *const without[] = {"", ":", ".:bin", "/nonexistent"};
    for (size_t i = 0; i < sizeof without / sizeof *without; i++) {
        struct status checked = {0}, started = {0};
        struct gnuplot gnuplot;
        assert_int_equal(setenv("PATH", without[i], 1), 0);
        enum status_code check = gnuplot_check(&checked);
        enum status_code start = gnuplot_start(&gnuplot, ((struct place *)*state)->directory, &started);
        assert_int_equal(setenv("PATH", path, 1), 0);
        assert_int_equal(check, STATUS_CHART);
        assert_int_equal(start, STATUS_CHART);
        assert_non_null(strstr(checked.message, "gnuplot-nox"));
        assert_non_null(strstr(started.message, "gnuplot-nox"));
    }
    free(path);
    struct status status = {0};
    assert_int_equal(gnuplot_check(&status), STATUS_OK);
}

static void test_a_missing_directory_is_an_error(void **state)
{
    (void)state;
    struct gnuplot gnuplot;
    struct status status = {0};
    assert_int_equal(gnuplot_start(&gnuplot, "/nonexistent/charts", &status), STATUS_IO);
    assert_non_null(strstr(status.message, "/nonexistent/charts"));
}

/* commands, what the message has to say */
static const struct complaint {
    const char *commands, *message;
} complaints[] = {
    {"load 'bad.gp'", "gnuplot: \"bad.gp\" line 2: undefined variable: nothing_here"},
    {"load 'syntax.gp'", "gnuplot: \"syntax.gp\" line 1: "},
    {"load 'missing.gp'", "gnuplot: Cannot load input from 'missing.gp'"},
    {"call 'curves.gp' 'missing.csv' 'x.svg' '' 'x' 'y' '' 's1'", "missing.csv"},
    {"call 'curves.gp' 'ecr.csv' 'x.svg' '' 'x' 'y' '' 's1 s2'", "ecr.csv has 4 blocks, but 2 style words were given"},
    {"call 'curves.gp' 'ecr.csv' 'x.svg' '' 'x' 'y' '' 's1 s2 s3 s9'", "'s9' is not a style word"},
    {"call 'curves.gp' 'ecr.csv' 'x.svg' '' 'x' 'y' '' 'me s2 s3 s4'", "'me' is not a style word"}, /* no models.gp */
    {"call 'cost.gp' 'ecr.csv' 'x.svg' '' 'c1 c2 c3 fit'", "'fit' is not a style word"},
    {"call 'spectra.gp' 'ecr.csv' 'x.svg' '' 'fit s1 s2 s3'", "'fit' is not a style word"},
    {"call 'profiles.gp' 'ecr.csv' 'x.svg' '' 's1 s2 s3 me4'", "'me4' is not a style word"},
    {"set terminal dumb\nset output 'x'\nplot [0:1] [0:1] 'none.csv'",
     "warning: Skipping data file with no valid points"},
    {"print 'a word'", "gnuplot: a word"},
    {"exit status 3", "status 3"},
};

static void test_any_complaint_is_a_failure(void **state)
{
    write_file(*state, "bad.gp", "x = 1\nplot nothing_here\n");
    write_file(*state, "syntax.gp", "plot sin(x\n");
    write_file(*state, "none.csv", "# nothing\n");
    for (size_t i = 0; i < sizeof complaints / sizeof *complaints; i++) {
        struct status status = {0};
        assert_int_equal(run(*state, complaints[i].commands, &status), STATUS_CHART);
        if (!strstr(status.message, complaints[i].message))
            fail_msg("'%s' does not say '%s'", status.message, complaints[i].message);
        assert_null(strpbrk(status.message, "\r\n\033"));
    }
}

static void test_a_process_that_ended_early_is_reported_not_deadly(void **state)
{
    struct sigaction before, after;
    assert_int_equal(sigaction(SIGPIPE, NULL, &before), 0);
    struct gnuplot gnuplot;
    struct status status = {0};
    assert_int_equal(gnuplot_start(&gnuplot, ((struct place *)*state)->directory, &status), STATUS_OK);
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

/* One that neither reads nor ends: it is not waited for longer than its time, nor when a signal asks to stop. */
static void test_a_gnuplot_that_hangs_is_ended(void **state)
{
    const struct place *place = *state;
    char path[1024], *before = strdup(getenv("PATH"));
    write_file(place, "gnuplot", "#!/bin/sh\ntrap '' INT TERM HUP\n/bin/sleep 1000\n");
    snprintf(path, sizeof path, "%s/gnuplot", place->directory);
    assert_int_equal(chmod(path, 0755), 0);
    for (int asked = 0; asked < 2; asked++) {
        struct gnuplot gnuplot;
        struct status status = {0};
        sigset_t signals, held;
        assert_int_equal(setenv("PATH", place->directory, 1), 0);
        enum status_code started = gnuplot_start(&gnuplot, place->directory, &status);
        assert_int_equal(setenv("PATH", before, 1), 0);
        assert_int_equal(started, STATUS_OK);
        assert_true(gnuplot.most_seconds >= 60); /* for the slowest of machines */
        for (int i = 0; i < 100000; i++)         /* far more than a pipe holds */
            gnuplot_send(&gnuplot, "x = %d", i);
        if (asked) {
            program_hold_signals(&held);
            raise(SIGTERM);
            assert_int_equal(gnuplot_finish(&gnuplot, &status), STATUS_INTERRUPTED);
            sigemptyset(&signals);
            sigaddset(&signals, SIGTERM);
            assert_int_equal(sigwaitinfo(&signals, NULL), SIGTERM);
            program_let_signals(&held);
        } else {
            gnuplot.most_seconds = 0.2;
            assert_int_equal(gnuplot_finish(&gnuplot, &status), STATUS_CHART);
            assert_non_null(strstr(status.message, "gnuplot did not end within 0.2 s and was stopped"));
        }
    }
    free(before);
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

static void test_the_user_s_setup_has_no_say(void **state)
{
    const struct place *place = *state;
    write_file(place, ".gnuplot", "print 'start-up file'\n");
    const char *home = getenv("HOME");
    char *kept = home ? strdup(home) : NULL;
    setenv("HOME", place->directory, 1);
    setenv("GNUTERM", "nonsense", 1);
    setenv("GNUPLOT_LIB", place->directory, 1);
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

static void test_no_descriptor_is_left_open(void **state)
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

#define PLACED(test) cmocka_unit_test_setup_teardown(test, place_setup, place_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        PLACED(test_every_template_draws_an_svg),
        PLACED(test_every_template_draws_text),
        PLACED(test_the_same_data_give_the_same_bytes),
        PLACED(test_eight_curves_stay_small),
        PLACED(test_empty_blocks_and_single_points_are_drawn_silently),
        PLACED(test_single_points_have_the_markers_of_their_models),
        PLACED(test_two_bands_are_filled_others_are_bars),
        PLACED(test_an_axis_ends_where_curves_are_cut),
        PLACED(test_a_zero_ends_at_the_lower_edge),
        PLACED(test_labels_at_ends_do_not_touch),
        PLACED(test_no_error_is_off_the_scale),
        PLACED(test_the_smallest_and_largest_numbers_have_axes),
        PLACED(test_hostile_names_are_only_text),
        cmocka_unit_test(test_quoting),
        PLACED(test_a_missing_gnuplot_names_the_package),
        cmocka_unit_test(test_a_missing_directory_is_an_error),
        PLACED(test_any_complaint_is_a_failure),
        PLACED(test_a_process_that_ended_early_is_reported_not_deadly),
        PLACED(test_a_gnuplot_that_hangs_is_ended),
        PLACED(test_the_user_s_setup_has_no_say),
        PLACED(test_no_descriptor_is_left_open),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
