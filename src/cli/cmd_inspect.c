#include "chart/gnuplot.h"
#include "cli/command.h"
#include "cli/finding.h"

#include <argp.h>
#include <jansson.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct arguments {
    struct scan_options scan;
    char x_column[64];
    struct profile_options how;
    bool json, chart, no_chart;
    char **files;
    int file_count;
};

enum {
    KEY_X_UNIT = 0x100,
    KEY_Z_UNIT,
    KEY_JSON,
    KEY_NO_CHART,
    KEY_CHART,
    KEY_LEVEL,
    KEY_LAMBDA_S,
    KEY_LAMBDA_C,
    KEY_QUANTITY,
    KEY_COLUMN
};

static const struct argp_option options[] = {
    {"json", KEY_JSON, 0, 0, "print an array of objects, one a file (default: text)", 0},
    {"no-chart", KEY_NO_CHART, 0, 0, "leave the charts out (default: drawn to the terminal's size)", 0},
    {"chart", KEY_CHART, 0, 0, "draw the charts even when the output is no terminal (default: only on one)", 0},
    {"x-unit", KEY_X_UNIT, "UNIT", 0, "unit of x where the file names none (default: such a file is refused)", 0},
    {"z-unit", KEY_Z_UNIT, "UNIT", 0, "unit of z where the file names none (default: such a file is refused)", 0},
    {"quantity", KEY_QUANTITY, "NAME", 0, "height or slope, which is integrated to heights (default: height)", 0},
    {"column", KEY_COLUMN, "Z|X,Z", 0, "columns by number or title (default: the first two that can be x and z)", 0},
    {"level", KEY_LEVEL, "NAME", 0, "none, mean, line, parabola, circle or robust (default: line; maps: plane)", 0},
    {"lambda-s", KEY_LAMBDA_S, "METRES", 0, "cut-off of a Gaussian low-pass (default: none; profiles only)", 0},
    {"lambda-c", KEY_LAMBDA_C, "METRES", 0, "cut-off of a high-pass: R beside P parameters (default: none)", 0},
    {0},
};

/** A length in metres that is given as an option. */
static double parse_length(const char *text, struct argp_state *state)
{
    char *end;
    double value = strtod(text, &end);
    if (end == text || *end != '\0' || !(value >= 1e-12 && value <= 1e3))
        argp_error(state, "'%s' is no length in metres, 1e-12 to 1000", text);
    return value;
}

static enum scene_level parse_level(const char *name, struct argp_state *state)
{
    for (int level = 0; level < SCENE_LEVEL_COUNT; level++)
        if (strcmp(name, scene_level_names[level]) == 0)
            return (enum scene_level)level;
    argp_error(state, "unknown level '%s'; allowed: none, mean, line, parabola, circle, robust", name);
    return SCENE_LEVEL_LINE;
}

static enum scan_quantity parse_quantity(const char *name, struct argp_state *state)
{
    for (int quantity = 0; quantity < SCAN_QUANTITY_COUNT; quantity++)
        if (strcmp(name, scan_quantity_names[quantity]) == 0)
            return (enum scan_quantity)quantity;
    argp_error(state, "unknown quantity '%s'; allowed: height, slope", name);
    return SCAN_HEIGHT;
}

/** `Z` or `X,Z`. */
static void parse_column(struct arguments *arguments, const char *text, struct argp_state *state)
{
    const char *comma = strchr(text, ',');
    arguments->scan.z_column = comma ? comma + 1 : text;
    if (*arguments->scan.z_column == '\0' ||
        (comma && (comma == text || (size_t)(comma - text) >= sizeof arguments->x_column)))
        argp_error(state, "'%s' is no column; give one, as in 3, or x and z, as in 1,3", text);
    if (comma) {
        memcpy(arguments->x_column, text, (size_t)(comma - text));
        arguments->scan.x_column = arguments->x_column;
    }
}

static error_t parse(int key, char *value, struct argp_state *state)
{
    struct arguments *arguments = state->input;
    switch (key) {
    case KEY_JSON:
        arguments->json = true;
        return 0;
    case KEY_NO_CHART:
        arguments->no_chart = true;
        return 0;
    case KEY_CHART:
        arguments->chart = true;
        return 0;
    case KEY_X_UNIT:
        arguments->scan.x_unit = value;
        return 0;
    case KEY_Z_UNIT:
        arguments->scan.z_unit = value;
        return 0;
    case KEY_QUANTITY:
        arguments->scan.quantity = parse_quantity(value, state);
        return 0;
    case KEY_COLUMN:
        parse_column(arguments, value, state);
        return 0;
    case KEY_LEVEL:
        arguments->how.level = parse_level(value, state);
        return 0;
    case KEY_LAMBDA_S:
        arguments->how.lambda_s_m = parse_length(value, state);
        return 0;
    case KEY_LAMBDA_C:
        arguments->how.lambda_c_m = parse_length(value, state);
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
        argp_error(state, "which file?");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static json_t *real(double value)
{
    return isfinite(value) ? json_real(value) : json_null();
}

/** Text as it may be shown: JSON is UTF-8, a file name need not be. */
static json_t *string(const char *value)
{
    struct text shown = {0};
    text_add_shown(&shown, value);
    json_t *json = json_string(text_string(&shown));
    text_free(&shown);
    return json;
}

static json_t *finding_json(const char *path, const struct finding *f)
{
    json_t *warnings = json_array();
    const char *warning;
    for (size_t w = 0; (warning = finding_warning(f, w)); w++)
        json_array_append_new(warnings, string(warning));
    json_t *json = json_pack("{s:o, s:s, s:s, s:I, s:o, s:o, s:s, s:s, s:I}", "file", string(path), "format",
                             f->scan.format, "kind", f->scan.kind == SCAN_AREAL ? "areal" : "profile", "points",
                             (json_int_t)(f->scan.nx * f->scan.ny), "spacing_m", real(finding_spacing_m(f)), "length_m",
                             real(finding_length_m(f)), "x_unit", f->scan.x_unit, "z_unit", f->scan.z_unit, "missing",
                             (json_int_t)f->scan.missing);
    const struct {
        const char *key;
        double value;
    } numbers[] = {{"rq_m", f->roughness.rq_m}, {"ra_m", f->roughness.ra_m},           {"pv_m", f->roughness.pv_m},
                   {"m2", f->roughness.m2},     {"m4_per_m2", f->roughness.m4_per_m2}, {"alpha_SI", f->law.alpha},
                   {"gamma", f->law.gamma}};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++)
        json_object_set_new(json, numbers[i].key, real(numbers[i].value));
    json_object_set_new(json, "warnings", warnings);
    finding_add_json(json, f);
    return json;
}

static void print_finding(const char *path, const struct finding *f)
{
    const struct roughness *r = &f->roughness;
    static const char *const grids[] = {"uniform", "rounded x, nominal spacing used", "uneven x, interpolated"};
    static const char *const level_labels[SCENE_LEVEL_COUNT] = {"as it is",     "mean out", "line out",
                                                                "parabola out", "arc out",  "robust line"};
    struct text name = {0};
    text_add_shown(&name, path);
    printf("%s\n", text_string(&name));
    text_free(&name);
    printf("  format      %s, x in %s, z in %s\n", f->scan.format, f->scan.x_unit, f->scan.z_unit);
    if (f->scan.kind == SCAN_AREAL)
        printf("  points      %zu x %zu, spacing %.6g um x %.6g um, %zu missing\n", f->scan.nx, f->scan.ny,
               f->scan.dx_m * 1e6, f->scan.dy_m * 1e6, f->scan.missing);
    else
        printf("  points      %zu, spacing %.6g um (%s), length %.6g mm\n", f->scan.nx, f->profile.spacing_m * 1e6,
               grids[f->profile.grid], finding_length_m(f) * 1e3);
    if (f->scan.kind == SCAN_PROFILE)
        printf("  %-11s tilt %.4g um/mm, end-to-end jump left %.4g um\n", level_labels[f->options.level],
               f->profile.tilt * 1e3, f->profile.end_jump_m * 1e6);
    finding_print(f);
    printf("  roughness   Rq %.6g um, Ra %.6g um, peak to valley %.6g um\n", r->rq_m * 1e6, r->ra_m * 1e6,
           r->pv_m * 1e6);
    printf("  moments     m2 %.6g, m4 %.6g /um2, ", r->m2, r->m4_per_m2 * 1e-12);
    double nayak = roughness_nayak(r);
    if (isnan(nayak))
        printf("Nayak - (no slope from a point to the next but one)\n");
    else
        printf("Nayak %.4g\n", nayak);
    if (isnan(f->law.gamma))
        printf("  power law   - (%s)\n",
               f->law.harmonics < 3 ? "it takes 3 harmonics" : "alpha leaves the range of numbers");
    else
        printf("  power law   alpha %.4g +- %.2g, gamma %.3f +- %.3f, scatter %.3f decades\n", f->law.alpha,
               f->law.alpha_error, f->law.gamma, f->law.gamma_error, f->law.rms_decades);
    const char *warning;
    for (size_t w = 0; (warning = finding_warning(f, w)); w++) {
        struct text note = {0};
        text_add_shown(&note, warning);
        printf("  note        %s\n", text_string(&note));
        text_free(&note);
    }
}

/** Thins `count` points to what a terminal can show; `at` maps an index to a point. */
static void write_points(FILE *file, const struct finding *f, bool spectrum)
{
    enum { MOST = 400 };
    size_t count = spectrum ? f->spectrum.count : f->profile.points, last = SIZE_MAX;
    fprintf(file, "\"%s\"\n", spectrum ? "amplitude" : "height");
    for (size_t k = 0; k < MOST; k++) {
        double share = (double)k / (MOST - 1);
        size_t i =
            spectrum ? (size_t)lround(pow((double)count, share)) - 1 : (size_t)lround(share * (double)(count - 1));
        if (i == last)
            continue;
        last = i;
        if (!spectrum)
            fprintf(file, "%.9g,%.9g\n", (double)i * f->profile.spacing_m * 1e3, f->profile.height_m[i] * 1e6);
        else if (f->spectrum.amplitude_m[i] > 0)
            fprintf(file, "%.9g,%.9g\n", 1e6 / spectrum_frequency(&f->spectrum, i), f->spectrum.amplitude_m[i] * 1e6);
    }
}

static enum status_code write_chart_data(const char *directory, const char *name, const struct finding *f,
                                         bool spectrum, struct status *status)
{
    struct text path = {0};
    text_add(&path, "%s/%s", directory, name);
    FILE *file = fopen(text_string(&path), "w");
    text_free(&path);
    if (!file)
        return status_fail(status, STATUS_IO, "cannot write in '%s'", directory);
    write_points(file, f, spectrum);
    return fclose(file) == 0 ? STATUS_OK : status_fail(status, STATUS_IO, "cannot write in '%s'", directory);
}

/** Draws profile and spectrum as text, sized to the terminal. */
static enum status_code draw(const struct finding *f, struct status *status)
{
    struct text templates = {0}, charts = {0};
    struct gnuplot gnuplot;
    const char *base = getenv("TMPDIR");
    char directory[512], quoted[600];
    int columns, rows;
    command_terminal_size(&columns, &rows);
    snprintf(directory, sizeof directory, "%s/roughcontact-XXXXXX", base && strlen(base) < 400 ? base : P_tmpdir);
    if (command_templates(&templates, status) != STATUS_OK || !mkdtemp(directory)) {
        text_free(&templates);
        return status_fail(status, STATUS_IO, "cannot make a directory like '%s'", directory);
    }
    enum status_code rc = write_chart_data(directory, "profile.csv", f, false, status);
    if (rc == STATUS_OK)
        rc = write_chart_data(directory, "spectrum.csv", f, true, status);
    if (rc == STATUS_OK && (rc = gnuplot_start(&gnuplot, directory, status)) == STATUS_OK) {
        gnuplot_quote(quoted, sizeof quoted, text_string(&templates));
        gnuplot_send(&gnuplot, "set loadpath %s", quoted);
        gnuplot_send(&gnuplot, "dumb_size = '%d,%d'", columns, rows > 24 ? 24 : rows - 1);
        gnuplot_send(&gnuplot, "call 'curves.gp' 'profile.csv' 'profile.txt' 'profile' 'x (mm)' 'z (um)' '' 's1'");
        gnuplot_send(&gnuplot, "call 'curves.gp' 'spectrum.csv' 'spectrum.txt' 'spectrum' 'wavelength (um)' "
                               "'amplitude (um)' 'xy' 's1'");
        rc = gnuplot_finish(&gnuplot, status);
    }
    static const char *const names[] = {"profile", "spectrum"};
    for (int i = 0; i < 2; i++) {
        char path[600];
        snprintf(path, sizeof path, "%s/%s.txt", directory, names[i]);
        if (rc == STATUS_OK)
            rc = gnuplot_take_text(&charts, path, status);
        unlink(path);
        snprintf(path, sizeof path, "%s/%s.csv", directory, names[i]);
        unlink(path);
    }
    rmdir(directory);
    fputs(text_string(&charts), stdout);
    text_free(&charts);
    text_free(&templates);
    return rc;
}

static json_t *error_json(const char *path, const char *message)
{
    return json_pack("{s:o, s:o}", "file", string(path), "error", string(message));
}

int command_inspect(int argc, char **argv)
{
    static const struct argp argp = {
        options, parse, "FILE...", "Says what is in each scan: format, points, spacing, units, roughness, power law.",
        NULL,    NULL,  NULL};
    struct arguments arguments = {.how = profile_defaults};
    argp_parse(&argp, argc, argv, 0, NULL, &arguments);
    json_t *all = json_array();
    int refused = 0;
    for (int i = 0; i < arguments.file_count; i++) {
        struct status status = {0}, chart = {0};
        struct finding finding;
        const char *path = arguments.files[i];
        if (finding_make(&finding, path, &arguments.scan, &arguments.how, &status) != STATUS_OK) {
            refused++;
            if (arguments.json)
                json_array_append_new(all, error_json(path, status.message));
            else
                command_complain("", status.message);
        } else if (arguments.json) {
            json_array_append_new(all, finding_json(path, &finding));
        } else {
            print_finding(path, &finding);
            bool wanted = !arguments.no_chart && (arguments.chart || isatty(STDOUT_FILENO));
            if (wanted && finding.profile.points > 0 && finding.spectrum.count > 0 &&
                draw(&finding, &chart) != STATUS_OK)
                command_complain("no charts: ", chart.message);
        }
        finding_free(&finding);
    }
    if (arguments.json) {
        json_dumpf(all, stdout, JSON_INDENT(1) | JSON_REAL_PRECISION(17));
        printf("\n");
    }
    json_decref(all);
    int exit_status = refused == 0 ? COMMAND_DONE : refused == arguments.file_count ? COMMAND_NOTHING : COMMAND_REFUSED;
    return command_finish(exit_status);
}
