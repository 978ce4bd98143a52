/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/temporary.h"
#include "base/words.h"
#include "chart/chart.h"
#include "chart/gnuplot.h"
#include "cli/command.h"
#include "cli/inspection.h"
#include "scan/string_view.h"
#include "scene/scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { KEY_JSON = 0x100, KEY_CHART, KEY_X_UNIT, KEY_Z_UNIT, KEY_COLUMN, KEY_LAMBDA_S, KEY_LAMBDA_C };

struct arguments {
    struct scan_options scan;
    struct profile_options how;
    bool json, chart;
    char **files;
    int file_count;
};

static const struct argp_option options[] = {
    {"json", KEY_JSON, 0, 0, "print an array of objects, one a scan (default: text)", 0},
    {"chart", KEY_CHART, 0, 0, "draw the profile even when the output is no terminal (default: only on one)", 0},
    {"x-unit", KEY_X_UNIT, "UNIT", 0, "unit of x where the file names none (default: such a file is refused)", 0},
    {"z-unit", KEY_Z_UNIT, "UNIT", 0, "unit of z where the file names none (default: such a file is refused)", 0},
    {"column", KEY_COLUMN, "Z|X,Z", 0, "columns by number (default: the first two that can be x and z)", 0},
    {"lambda-s", KEY_LAMBDA_S, "LENGTH", 0, "cut-off of a Gaussian low-pass (default: none; profiles only)", 0},
    {"lambda-c", KEY_LAMBDA_C, "LENGTH", 0,
     "cut-off of a high-pass (profiles only): R beside P parameters, over whole sampling lengths (default: none)", 0},
    {0},
};

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
    if (key == KEY_JSON)
        arguments->json = true;
    else if (key == KEY_CHART)
        arguments->chart = true;
    else if (key == KEY_X_UNIT)
        arguments->scan.x_unit = value;
    else if (key == KEY_Z_UNIT)
        arguments->scan.z_unit = value;
    else if (key == KEY_COLUMN)
        parse_column(arguments, value, state);
    else if (key == KEY_LAMBDA_S)
        arguments->how.lambda_s_m = command_length("lambda-s", value, state);
    else if (key == KEY_LAMBDA_C)
        arguments->how.lambda_c_m = command_length("lambda-c", value, state);
    else if (key == ARGP_KEY_NO_ARGS)
        argp_error(state, "which file?");
    else if (key == ARGP_KEY_ARGS) {
        arguments->files = state->argv + state->next;
        arguments->file_count = state->argc - state->next;
    } else if (key != ARGP_KEY_END)
        return ARGP_ERR_UNKNOWN;
    else if (arguments->how.lambda_c_m > 0 && arguments->how.lambda_c_m <= arguments->how.lambda_s_m)
        argp_error(state, "--lambda-c is not above --lambda-s; nothing would be left between them");
    return 0;
}

/** Prints the profile as a chart of characters, as wide as the terminal. */
static enum status_code draw(const struct profile *profile, struct status *status)
{
    enum { MOST = 400 }; /* points; no terminal shows more */
    OWNED(text_free) struct text letters = {0}, script = {0};
    const char *folder = "";
    OWNED(chart_free) struct chart chart = chart_make("profile");
    OWNED(words_free) struct words words = {0};
    struct gnuplot gnuplot;
    struct temporary temporary;
    char size[40], path[PATH_MAX + 32];
    int columns, rows;
    command_terminal_size(&columns, &rows);
    snprintf(size, sizeof size, "%d,%d", columns, rows > 24 ? 24 : rows - 1);
    if (temporary_make(&temporary, NULL, NULL, status) != STATUS_OK)
        return status->code;
    enum status_code rc = command_templates(&folder, status);
    OWNED(mustache_folder_free) struct mustache_folder templates = {folder, ".gp", NULL, status};
    if (rc == STATUS_OK && (rc = words_read(&words, folder, status)) == STATUS_OK) {
        chart_panel(&chart, words_say(&words, "inspect.profile"), words_say(&words, "inspect.profile.x"),
                    words_say(&words, "inspect.profile.y"), false, false);
        chart_curve(&chart,
                    &(struct chart_curve){.legend = words_say(&words, "inspect.profile.legend"), .colour = "#000000"});
        for (size_t i = 0, step = 1 + (profile->points - 1) / MOST; i < profile->points; i += step)
            chart_row(&chart, (double)i * profile->spacing_m * 1e3, profile->height_m[i] * 1e6, 0, 0);
        rc = chart_write(&chart, &templates, temporary.path);
    }
    if (rc == STATUS_OK)
        rc = chart_script(&script, &chart, &templates, size);
    if (rc == STATUS_OK && (rc = gnuplot_start(&gnuplot, temporary.path, status)) == STATUS_OK) {
        gnuplot_send(&gnuplot, text_string(&script));
        rc = gnuplot_finish(&gnuplot, status);
    }
    snprintf(path, sizeof path, "%s/profile.txt", temporary.path);
    if (rc == STATUS_OK)
        rc = gnuplot_take_text(&letters, path, status);
    temporary_remove(&temporary);
    fputs(text_string(&letters), stdout);
    return rc;
}

enum { REFUSALS_SAID = 10 }; /* more are counted */

/** The scans so far. */
struct outcome {
    json_t *all;
    struct mustache_folder templates; /* of what is printed */
    size_t scans, refused;
};

static void refuse(struct outcome *outcome, const struct arguments *arguments, const char *path, const char *message)
{
    outcome->scans++;
    outcome->refused++;
    if (arguments->json)
        json_array_append_new(outcome->all,
                              json_pack("{s:o, s:o}", "file", json_shown(path), "error", json_shown(message)));
    else if (outcome->refused <= REFUSALS_SAID)
        command_complain("", message);
}

static void show(struct outcome *outcome, const struct arguments *arguments, const char *path,
                 const struct inspection *inspection)
{
    struct status chart = {0};
    OWNED(text_free) struct text lines = {0};
    outcome->scans++;
    if (arguments->json) {
        json_array_append_new(outcome->all, inspection_json(path, inspection));
        return;
    }
    json_auto_t *view = inspection_view(path, inspection);
    if (mustache_file(&lines, &outcome->templates, "inspect", view, NULL) == STATUS_OK)
        fputs(text_string(&lines), stdout);
    if ((arguments->chart || isatty(STDOUT_FILENO)) && inspection->profile.points > 0 &&
        draw(&inspection->profile, &chart) != STATUS_OK)
        command_complain("no chart: ", chart.message);
}

/** Inspects the scans of a file (an archive may have several), or of standard input, called "-". */
static void inspect_file(struct outcome *outcome, const struct arguments *arguments, const char *path,
                         struct scan_options how)
{
    struct status status = {0};
    OWNED(text_free) struct text text = {0};
    enum status_code code =
        strcmp(path, "-") == 0 ? text_read_stream(&text, stdin, "-", &status) : text_read_file(&text, path, &status);
    const struct scan_bytes file = {text_string(&text), text.length, path};
    how.spent = &text;
    if (code != STATUS_OK)
        refuse(outcome, arguments, path, status.message);
    while (code == STATUS_OK) {
        struct status problem = {0};
        struct inspection inspection;
        OWNED(text_free) struct text name = {0};
        bool good = inspection_make(&inspection, &file, &how, &arguments->how, &problem) == STATUS_OK;
        const char *part = inspection.scan.part;
        text_add(&name, *part ? "%s(%s)" : "%s%s", path, part);
        if (good)
            show(outcome, arguments, text_string(&name), &inspection);
        else
            refuse(outcome, arguments, text_string(&name), problem.message);
        how.entry = inspection.scan.next_entry;
        inspection_free(&inspection);
        if (how.entry == 0)
            break;
    }
}

/** The command line's options, else the scene's. */
static struct scan_options options_of(const struct arguments *arguments, const struct scene_surface *surface)
{
    struct scan_options how = arguments->scan;
    how.x_unit = how.x_unit ? how.x_unit : surface->x_unit;
    how.z_unit = how.z_unit ? how.z_unit : surface->z_unit;
    if (how.z_column == 0) {
        how.x_column = surface->x_column;
        how.z_column = surface->z_column;
    }
    return how;
}

/** Inspects the scans of a directory, as a report would read them. */
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
    struct arguments own = *arguments;
    own.how.max_missing = scene.max_missing;
    for (size_t i = 0; code == STATUS_OK && i <= scene.surface_count; i++) {
        const struct scene_surface *surface = i < scene.surface_count ? &scene.surfaces[i] : &scene.counterface_surface;
        const size_t across = surface->files.count;
        for (size_t f = 0; f < across + surface->along.count; f++) {
            const char *path_of = f < across ? surface->files.path[f] : surface->along.path[f - across];
            OWNED(memory_free) char *file = scene_file_path(&scene, path_of);
            if (file)
                inspect_file(outcome, &own, file, options_of(arguments, surface));
            else
                refuse(outcome, arguments, path_of, "out of memory");
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

int command_inspect(int argc, char **argv)
{
    struct arguments arguments = {.how = profile_defaults};
    command_parse(&command_inspect_argp, argc, argv, &arguments);
    struct status status = {0};
    const char *templates = "";
    if (!arguments.json && command_templates(&templates, &status) != STATUS_OK)
        return command_finish(command_fail(&status), NULL);
    struct outcome outcome = {.all = json_array(), .templates = {templates, ".txt", NULL, &status}};
    for (int i = 0; i < arguments.file_count && status.code == STATUS_OK; i++) {
        const char *path = arguments.files[i];
        struct stat info;
        if (stat(path, &info) == 0 && S_ISDIR(info.st_mode))
            inspect_directory(&outcome, &arguments, path);
        else
            inspect_file(&outcome, &arguments, path, arguments.scan);
    }
    if (!arguments.json && outcome.refused > REFUSALS_SAID)
        fprintf(stderr, "and %zu more scans refused; --json names all\n", outcome.refused - REFUSALS_SAID);
    if (!arguments.json)
        json_decref(outcome.all);
    else
        command_json_print(outcome.all);
    mustache_folder_free(&outcome.templates);
    if (status.code != STATUS_OK)
        return command_finish(command_fail(&status), NULL);
    return command_finish(outcome.refused == 0               ? COMMAND_DONE
                          : outcome.refused == outcome.scans ? COMMAND_NOTHING
                                                             : COMMAND_REFUSED,
                          NULL);
}
