/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/limits.h"
#include "base/temporary.h"
#include "chart/chart.h"
#include "chart/gnuplot.h"
#include "chart/words.h"
#include "cli/command.h"
#include "cli/inspection.h"
#include "scene/scene.h"
#include "scene/scene_words.h"

#include <argp.h>
#include <jansson.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { KEY_JSON = 0x100, KEY_NO_CHART, KEY_CHART, KEY_LIMITS, KEY_FLAGS, FLAGS = KEY_FLAGS - KEY_JSON };

struct arguments {
    struct scan_options scan;
    struct profile_options how;
    enum power_law_method fit;
    bool asked[FLAGS];
    char **files;
    int file_count;
};

enum { KEY_X_UNIT = KEY_FLAGS, KEY_Z_UNIT, KEY_LEVEL, KEY_LAMBDA_S, KEY_LAMBDA_C, KEY_QUANTITY, KEY_COLUMN, KEY_FIT };

/** Is that option, which takes no value, given? */
static bool is_asked(const struct arguments *arguments, int key)
{
    return arguments->asked[key - KEY_JSON];
}

static const struct argp_option options[] = {
    {"json", KEY_JSON, 0, 0, "print an array of objects, one a file (default: text)", 0},
    {"no-chart", KEY_NO_CHART, 0, 0, "leave the charts out (default: drawn to the terminal's size)", 0},
    {"chart", KEY_CHART, 0, 0, "draw the charts even when the output is no terminal (default: only on one)", 0},
    {"x-unit", KEY_X_UNIT, "UNIT", 0, "unit of x where the file names none (default: such a file is refused)", 0},
    {"z-unit", KEY_Z_UNIT, "UNIT", 0, "unit of z where the file names none (default: such a file is refused)", 0},
    {"quantity", KEY_QUANTITY, "QUANTITY", 0, "height or slope, which is integrated to heights (default: height)", 0},
    {"column", KEY_COLUMN, "Z|X,Z", 0, "columns by number (default: the first two that can be x and z)", 0},
    {"level", KEY_LEVEL, "LEVEL", 0,
     "none, mean, line, parabola, circle or robust (default: line, mean of a periodic record; maps: plane)", 0},
    {"lambda-s", KEY_LAMBDA_S, "LENGTH", 0, "cut-off of a Gaussian low-pass (default: none; profiles only)", 0},
    {"lambda-c", KEY_LAMBDA_C, "LENGTH", 0, "cut-off of a high-pass: R beside P parameters (default: none)", 0},
    {"fit", KEY_FIT, "FIT", 0, "power law: auto, in the band found, or thesis, all harmonics (default: auto)", 0},
    {"limits", KEY_LIMITS, 0, 0, "print what a file may hold at most, and end (default: inspect files)", 0},
    {0},
};

/** The cut-off of a filter. */
static double parse_cutoff(const char *name, const char *text, struct argp_state *state)
{
    double cutoff_m = command_length(name, text, state);
    if (!(cutoff_m >= 1e-12 && cutoff_m <= 1e3))
        argp_error(state, "--%s is '%s'; allowed is 1e-12 to 1000 m", name, text);
    return cutoff_m;
}

/** Which of the `count` names is `value`? */
static unsigned parse_name(const char *what, const char *value, const char *const *names, size_t count,
                           struct argp_state *state)
{
    size_t length = strlen(value), which = scene_words_find(value, length, names, count);
    if (which == count)
        argp_error(state, "unknown %s '%s'; %s", what,
                   scene_words_show_view((struct string_view){value, value + length}).text,
                   scene_words_hint(value, names, count, 0).text);
    return (unsigned)which;
}

/** `Z` or `X,Z`. */
static void parse_column(struct arguments *arguments, const char *text, struct argp_state *state)
{
    const char *comma = strchr(text, ',');
    size_t *x = &arguments->scan.x_column, *z = &arguments->scan.z_column;
    if (!number_read_size(string_view_of(comma ? comma + 1 : text), z) || *z == 0 ||
        (comma && (!number_read_size((struct string_view){text, comma}, x) || *x == 0)))
        argp_error(state, "'%s' is no column; give one, as in 3, or x and z, as in 1,3", text);
}

static error_t parse(int key, char *value, struct argp_state *state)
{
    struct arguments *arguments = state->input;
    switch (key) {
    case KEY_JSON:
    case KEY_NO_CHART:
    case KEY_CHART:
    case KEY_LIMITS:
        arguments->asked[key - KEY_JSON] = true;
        return 0;
    case KEY_X_UNIT:
        arguments->scan.x_unit = value;
        return 0;
    case KEY_Z_UNIT:
        arguments->scan.z_unit = value;
        return 0;
    case KEY_QUANTITY:
        arguments->scan.quantity = parse_name("quantity", value, scan_quantity_names, SCAN_QUANTITY_COUNT, state);
        return 0;
    case KEY_COLUMN:
        parse_column(arguments, value, state);
        return 0;
    case KEY_LEVEL:
        arguments->how.level = parse_name("level", value, level_names, LEVEL_COUNT, state);
        arguments->how.periodic_mean = false;
        return 0;
    case KEY_FIT:
        arguments->fit = parse_name("fit", value, power_law_method_names, POWER_LAW_METHOD_COUNT, state);
        return 0;
    case KEY_LAMBDA_S:
        arguments->how.lambda_s_m = parse_cutoff("lambda-s", value, state);
        return 0;
    case KEY_LAMBDA_C:
        arguments->how.lambda_c_m = parse_cutoff("lambda-c", value, state);
        return 0;
    case ARGP_KEY_END:
        if (arguments->how.lambda_c_m > 0 && arguments->how.lambda_c_m <= arguments->how.lambda_s_m)
            argp_error(state, "--lambda-c is not above --lambda-s; nothing would be left between them");
        return 0;
    case ARGP_KEY_ARGS:
        arguments->files = state->argv + state->next;
        arguments->file_count = state->argc - state->next;
        return 0;
    case ARGP_KEY_NO_ARGS:
        if (!is_asked(arguments, KEY_LIMITS))
            argp_error(state, "which file?");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const char *const chart_names[] = {"profile", "spectrum"};

/** The data of a chart, thinned to what a terminal can show. */
static void make_chart(struct chart *out, const struct inspection *f, bool spectrum, struct words *words)
{
    enum { MOST = 400 };
    size_t count = spectrum ? f->spectrum.count : f->profile.points, last = SIZE_MAX;
    chart_panel(out, words_say(words, spectrum ? "inspect.spectrum" : "inspect.profile", NULL),
                words_say(words, spectrum ? "inspect.spectrum.x" : "inspect.profile.x", NULL),
                words_say(words, spectrum ? "inspect.spectrum.y" : "inspect.profile.y", NULL), spectrum, spectrum);
    chart_curve(out,
                &(struct chart_curve){
                    .legend = words_say(words, spectrum ? "inspect.spectrum.legend" : "inspect.profile.legend", NULL),
                    .colour = "#000000"});
    for (size_t k = 0; k < MOST; k++) {
        double share = (double)k / (MOST - 1);
        size_t i =
            spectrum ? (size_t)lround(pow((double)count, share)) - 1 : (size_t)lround(share * (double)(count - 1));
        if (i == last)
            continue;
        last = i;
        if (spectrum)
            chart_row(out, 1e6 / spectrum_frequency(&f->spectrum, i), f->spectrum.amplitude_m[i] * 1e6, 0, 0);
        else
            chart_row(out, (double)i * f->profile.spacing_m * 1e3, f->profile.height_m[i] * 1e6, 0, 0);
    }
}

/** Writes a chart's data into `directory`, and adds what draws them. */
static enum status_code write_chart(struct text *script, const char *directory, const struct inspection *f,
                                    bool spectrum, struct mustache_folder *templates, struct words *words,
                                    const char *terminal_size)
{
    struct chart chart = chart_make(chart_names[spectrum]);
    make_chart(&chart, f, spectrum, words);
    enum status_code rc = chart_write(&chart, templates, directory);
    if (rc == STATUS_OK)
        rc = chart_script(script, &chart, templates, terminal_size);
    chart_free(&chart);
    return rc;
}

/** Draws profile and spectrum as text, sized to the terminal. */
static enum status_code draw(const struct inspection *f, struct status *status)
{
    struct text script = {0}, charts = {0}, share = {0};
    struct gnuplot gnuplot;
    struct words words = {0};
    struct temporary temporary;
    char size[40];
    int columns, rows;
    command_terminal_size(&columns, &rows);
    snprintf(size, sizeof size, "%d,%d", columns, rows > 24 ? 24 : rows - 1);
    if (temporary_make(&temporary, NULL, NULL, status) != STATUS_OK)
        return status->code;
    enum status_code rc = command_share(&share, "templates", status);
    struct mustache_folder templates = {text_string(&share), ".gp", NULL, status};
    if (rc == STATUS_OK)
        rc = words_read(&words, text_string(&share), status);
    for (int i = 0; i < 2 && rc == STATUS_OK; i++)
        rc = write_chart(&script, temporary.path, f, i, &templates, &words, size);
    words_free(&words);
    mustache_folder_free(&templates);
    text_free(&share);
    if (rc == STATUS_OK && (rc = gnuplot_start(&gnuplot, temporary.path, status)) == STATUS_OK) {
        gnuplot_send(&gnuplot, text_string(&script));
        rc = gnuplot_finish(&gnuplot, status);
    }
    text_free(&script);
    for (int i = 0; i < 2 && rc == STATUS_OK; i++) {
        char path[PATH_MAX + 32];
        snprintf(path, sizeof path, "%s/%s.txt", temporary.path, chart_names[i]);
        rc = gnuplot_take_text(&charts, path, status);
    }
    temporary_remove(&temporary);
    fputs(text_string(&charts), stdout);
    text_free(&charts);
    return rc;
}

/** What was looked at so far. */
struct outcome {
    json_t *all;
    size_t scans, refused;
};

static void refuse(struct outcome *outcome, const struct arguments *arguments, const char *path, const char *message)
{
    outcome->scans++;
    outcome->refused++;
    if (is_asked(arguments, KEY_JSON))
        json_array_append_new(outcome->all, json_pack("{s:o, s:o}", "file", command_json_text(path), "error",
                                                      command_json_text(message)));
    else
        command_complain("", message);
}

static void show(struct outcome *outcome, const struct arguments *arguments, const char *path,
                 struct inspection *inspection)
{
    struct status chart = {0};
    outcome->scans++;
    if (is_asked(arguments, KEY_JSON)) {
        json_t *json = json_pack("{s:o}", "file", command_json_text(path));
        inspection_add_json(json, inspection);
        json_array_append_new(outcome->all, json);
        return;
    }
    inspection_print(path, inspection);
    bool wanted = !is_asked(arguments, KEY_NO_CHART) && (is_asked(arguments, KEY_CHART) || isatty(STDOUT_FILENO));
    if (wanted && inspection->profile.points > 0 &&
        (inspection_spectrum(inspection, &chart) != STATUS_OK ||
         (inspection->spectrum.count > 0 && draw(inspection, &chart) != STATUS_OK)))
        command_complain("no charts: ", chart.message);
}

/** The scans of a file, or of standard input where it is called "-": one, but for archives. */
static void inspect_file(struct outcome *outcome, const struct arguments *arguments, const char *path,
                         struct scan_options how)
{
    struct status status = {0};
    struct text text = {0};
    enum status_code code =
        strcmp(path, "-") == 0 ? text_read_stream(&text, stdin, "-", &status) : text_read_file(&text, path, &status);
    const struct scan_bytes file = {text_string(&text), text.length, path};
    if (code != STATUS_OK)
        refuse(outcome, arguments, path, status.message);
    while (code == STATUS_OK) {
        struct status problem = {0};
        struct inspection inspection;
        struct text name = {0};
        bool good = inspection_make(&inspection, &file, &how, &arguments->how, arguments->fit, &problem) == STATUS_OK;
        const char *part = inspection.scan.part;
        text_add(&name, *part ? "%s(%s)" : "%s%s", path, part);
        if (good)
            show(outcome, arguments, text_string(&name), &inspection);
        else
            refuse(outcome, arguments, text_string(&name), problem.message);
        how.entry = inspection.scan.next_entry;
        text_free(&name);
        inspection_free(&inspection);
        if (how.entry == 0)
            break;
    }
    text_free(&text);
}

/** Where the command line says nothing the scene does. */
static struct scan_options options_of(const struct arguments *arguments, const struct scene_surface *surface)
{
    struct scan_options how = arguments->scan;
    how.x_unit = how.x_unit ? how.x_unit : surface->x_unit;
    how.z_unit = how.z_unit ? how.z_unit : surface->z_unit;
    how.quantity = how.quantity != SCAN_HEIGHT ? how.quantity : surface->quantity;
    if (how.z_column == 0) {
        how.x_column = surface->x_column;
        how.z_column = surface->z_column;
    }
    return how;
}

/** The scans of a directory, as a report would read them. */
static void inspect_directory(struct outcome *outcome, const struct arguments *arguments, const char *path)
{
    struct status status = {0};
    struct scene scene;
    enum status_code code = scene_read(&scene, path, NULL, &status);
    if (code == STATUS_OK && scene.passed_over)
        fprintf(stderr, "%s\n", scene.passed_over);
    if (code == STATUS_OK && scene.surface_count == 0)
        code = status_fail(&status, STATUS_SCAN, "no scan in '%s'", path);
    if (code != STATUS_OK)
        refuse(outcome, arguments, path, status.message);
    for (size_t i = 0; code == STATUS_OK && i < scene.surface_count; i++) {
        const struct scene_surface *surface = &scene.surfaces[i];
        for (size_t f = 0; f < surface->file_count; f++) {
            char *file = scene_file_path(&scene, surface->files[f]);
            if (file)
                inspect_file(outcome, arguments, file, options_of(arguments, surface));
            else
                refuse(outcome, arguments, surface->files[f], "out of memory");
            free(file);
        }
    }
    scene_free(&scene);
}

const struct argp command_inspect_argp = {
    .options = options,
    .parser = parse,
    .args_doc = "FILE|DIR|-...",
    .doc = "Says what is in each scan: format, points, spacing, units, roughness, power law. Of a directory, the "
           "scans that a report on it would read; - is standard input. An archive (zip) may hold several scans."};

/** What files may hold, as docs/limits.md has it. */
static void print_limits(bool as_json)
{
    json_t *all = json_array();
    for (size_t i = 0; i < LIMIT_COUNT; i++) {
        const struct limit_row *row = &limit_rows[i];
        if (as_json)
            json_array_append_new(all, json_pack("{s:s, s:I, s:s, s:s, s:s}", "name", row->name, "most",
                                                 (json_int_t)row->most, "unit", row->unit, "meaning", row->meaning,
                                                 "remedy", row->remedy));
        else
            printf("%-11s at most %10zu %-9s %s; beyond: %s\n", row->name, row->most, row->unit, row->meaning,
                   row->remedy);
    }
    if (as_json)
        json_dumpf(all, stdout, JSON_INDENT(1));
    fputs(as_json ? "\n" : "", stdout);
    json_decref(all);
}

int command_inspect(int argc, char **argv)
{
    struct arguments arguments = {.how = profile_defaults};
    command_parse(&command_inspect_argp, argc, argv, &arguments);
    if (is_asked(&arguments, KEY_LIMITS)) {
        print_limits(is_asked(&arguments, KEY_JSON));
        return command_finish(COMMAND_DONE, NULL);
    }
    struct outcome outcome = {.all = json_array()};
    for (int i = 0; i < arguments.file_count; i++) {
        const char *path = arguments.files[i];
        struct stat info;
        if (stat(path, &info) == 0 && S_ISDIR(info.st_mode))
            inspect_directory(&outcome, &arguments, path);
        else
            inspect_file(&outcome, &arguments, path, arguments.scan);
    }
    if (!is_asked(&arguments, KEY_JSON))
        json_decref(outcome.all);
    else if (!command_json_print(outcome.all))
        outcome.refused = outcome.scans;
    return command_finish(outcome.refused == 0               ? COMMAND_DONE
                          : outcome.refused == outcome.scans ? COMMAND_NOTHING
                                                             : COMMAND_REFUSED,
                          NULL);
}
