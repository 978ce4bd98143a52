/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/command.h"
#include "direct/direct_surface.h"
#include "profile/synth.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct arguments {
    struct synth_def def;
    const char *output;
    bool map;
};

enum { KEY_MAP = 0x100, MOST_SIDE = 4096 };

static const struct argp_option options[] = {
    {"alpha", 'a', "SI", 0, "alpha of amplitude = alpha lambda^gamma, in m^(1-gamma) (default 0.085)", 0},
    {"gamma", 'g', "G", 0, "gamma (default 1.5)", 0},
    {"rq", 'r', "LENGTH", 0,
     "root mean square height: scales the profile, or beside --alpha chooses the draw of scatter (default: as drawn)",
     0},
    {"length", 'l', "LENGTH", 0, "scan length (default 0.3mm)", 0},
    {"points", 'n', "N", 0, "points (default 1200)", 0},
    {"scatter", 'c', "DECADES", 0, "RMS scatter of the amplitudes about the law (default 0.2785, a Gaussian surface's)",
     0},
    {"lambda-s", 's', "LENGTH", 0, "short-wavelength cut-off, as stylus instruments apply one (default: none)", 0},
    {"map", KEY_MAP, 0, 0,
     "a square map of N points (-n) a side, Gaussian and isotropic, whose rows have the law; waves longer than a "
     "quarter of its length are as high as that. Written as binary SDF (ISO 25178-71) of 16 bits a height",
     0},
    {"seed", 'd', "N", 0, "of the random numbers (default 1)", 0},
    {"output", 'o', "FILE", 0, "where to write (default: standard output)", 0},
    {0},
};

/** A number from `least` to `most`, or a whole one. */
static double number(const char *name, const char *value, double least, double most, bool whole,
                     struct argp_state *state)
{
    char *end;
    double result = strtod(value, &end);
    if (end == value || *end != '\0' || !(result >= least && result <= most) || (whole && floor(result) != result))
        argp_error(state, "--%s must be a %snumber from %g to %.10g, not '%s'", name, whole ? "whole " : "", least,
                   most, value);
    return result;
}

static error_t parse(int key, char *value, struct argp_state *state)
{
    struct arguments *arguments = state->input;
    struct synth_def *def = &arguments->def;
    if (key == 'a') {
        def->alpha = number("alpha", value, 1e-300, 1e300, false, state);
        def->scaled = false;
    } else if (key == 'g')
        def->gamma = number("gamma", value, -1e3, 1e3, false, state);
    else if (key == 'r')
        def->rq_m = command_length("rq", value, state);
    else if (key == 'l')
        def->length_m = command_length("length", value, state);
    else if (key == 'n')
        def->points = (size_t)number("points", value, 8, 1e8, true, state);
    else if (key == 'c')
        def->scatter_decades = number("scatter", value, 0, 2, false, state);
    else if (key == 's')
        def->lambda_s_m = command_length("lambda-s", value, state);
    else if (key == 'd')
        def->seed = (unsigned long)number("seed", value, 0, 4294967295.0, true, state);
    else if (key == KEY_MAP)
        arguments->map = true;
    else if (key == ARGP_KEY_END && arguments->map && arguments->def.points > MOST_SIDE)
        argp_error(state, "--points of a map are those of a side, %d at most", MOST_SIDE);
    else if (key == 'o')
        arguments->output = strcmp(value, "-") == 0 ? NULL : value;
    else
        return ARGP_ERR_UNKNOWN;
    return 0;
}

/** A quarter of a periodic surface with sides twice as long, so that the map is not periodic. */
static enum status_code make_map(double *height_m, const struct synth_def *def, struct status *status)
{
    const size_t n = def->points, all = 2 * n;
    const double cutoff_m = def->lambda_s_m > 0 ? def->lambda_s_m : 4 * def->length_m / (double)n;
    const struct direct_law law = {def->alpha, def->gamma, cutoff_m, 2 * def->length_m, 8};
    struct direct_spectrum spectrum;
    OWNED(memory_free) double *surface_m = calloc(all * all, sizeof *surface_m);
    double square = 0;
    enum status_code rc = surface_m ? direct_spectrum_of_law(&spectrum, &law, status) : status_memory(status);
    const struct direct_recipe recipe = {direct_spectrum_variance, &spectrum, NULL, 0};
    if (surface_m && rc == STATUS_OK)
        rc = direct_surface_make(surface_m, all, &recipe, def->seed, status);
    for (size_t k = 0; k < n * n && rc == STATUS_OK; k++) {
        height_m[k] = surface_m[k / n * all + k % n];
        square += height_m[k] * height_m[k] / (double)(n * n);
    }
    for (size_t k = 0; k < n * n && rc == STATUS_OK && def->rq_m > 0; k++)
        height_m[k] *= def->rq_m / sqrt(square);
    if (surface_m)
        direct_spectrum_free(&spectrum);
    return rc;
}

/** Adds the lowest `bytes` of a number, little-endian. */
static void add_bytes(struct text *out, uint64_t bits, int bytes)
{
    for (int b = 0; b < bytes; b++)
        text_add_bytes(out, &(char){(char)(bits >> 8 * b & 0xff)}, 1);
}

static void put_map(struct text *out, const double *height_m, const struct synth_def *def)
{
    const size_t n = def->points;
    double most = 0;
    for (size_t k = 0; k < n * n; k++)
        most = fmax(most, fabs(height_m[k]));
    const double spacing_m = def->length_m / (double)n, scales[] = {spacing_m, spacing_m, most / INT16_MAX, 0};
    text_add(out, "bISO-1.0%-34s", "synth"); /* the maker, and two dates */
    add_bytes(out, n, 2);
    add_bytes(out, n, 2);
    for (int s = 0; s < 4; s++) {
        uint64_t bits;
        memcpy(&bits, &scales[s], sizeof bits);
        add_bytes(out, bits, 8);
    }
    add_bytes(out, 5 << 8, 3); /* not compressed, 16-bit integers, no check sum */
    for (size_t k = 0; k < n * n; k++)
        add_bytes(out, (uint64_t)lround(height_m[k] / scales[2]), 2);
}

static enum status_code write_scan(const struct arguments *arguments, const double *height_m, struct status *status)
{
    const struct synth_def *def = &arguments->def;
    OWNED(text_free) struct text csv = {0};
    double spacing_um = def->length_m / (double)def->points * 1e6;
    if (arguments->map)
        put_map(&csv, height_m, def);
    else
        text_add(&csv, "x [um],z [um]\n");
    for (size_t i = 0; i < def->points && !arguments->map; i++)
        text_add(&csv, "%.10g,%.6f\n", (double)i * spacing_um, height_m[i] * 1e6); /* heights to the picometre */
    enum status_code rc = STATUS_OK;
    if (csv.failed)
        rc = status_memory(status);
    else if (arguments->output)
        rc = command_write(arguments->output, &csv, false, status);
    else
        fwrite(csv.data, 1, csv.length, stdout);
    return rc;
}

const struct argp command_synth_argp = {
    .options = options,
    .parser = parse,
    .doc =
        "Writes a scan whose harmonics obey amplitude = alpha lambda^gamma about which they scatter, with random "
        "phases; the profile is level. The line through all harmonics (fit: thesis) gives alpha (but for --rq, which "
        "scales it), gamma and the scatter back."};

int command_synth(int argc, char **argv)
{
    struct arguments arguments = {.def = synth_def_default()};
    struct status status = {0};
    arguments.def.scaled = true; /* unless --alpha is given */
    command_parse(&command_synth_argp, argc, argv, &arguments);
    const struct synth_def *def = &arguments.def;
    OWNED(memory_free) double *height_m = calloc(def->points * (arguments.map ? def->points : 1) + 1, sizeof *height_m);
    enum status_code rc = !height_m       ? status_memory(&status)
                          : arguments.map ? make_map(height_m, def, &status)
                                          : synth_profile(height_m, def, &status);
    if (rc == STATUS_OK)
        rc = write_scan(&arguments, height_m, &status);
    return command_finish(rc == STATUS_OK ? COMMAND_DONE : command_fail(&status), NULL);
}
