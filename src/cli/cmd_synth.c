/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/command.h"
#include "profile/synth.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct arguments {
    struct synth_def def;
    const char *output;
};

static const struct argp_option options[] = {
    {"alpha", 'a', "SI", 0, "alpha of amplitude = alpha lambda^gamma, in m^(1-gamma) (default 0.085)", 0},
    {"gamma", 'g', "G", 0, "gamma (default 1.5)", 0},
    {"rq", 'r', "LENGTH", 0,
     "root mean square height: scales the profile, or beside --alpha chooses the scatter (default: what alpha gives)",
     0},
    {"length", 'l', "LENGTH", 0, "scan length (default 0.3mm)", 0},
    {"points", 'n', "N", 0, "points (default 1200)", 0},
    {"scatter", 'c', "DECADES", 0, "RMS scatter of the amplitudes about the law (default 0.2785, a Gaussian surface's)",
     0},
    {"lambda-s", 's', "LENGTH", 0, "short-wavelength cut-off, as stylus instruments apply one (default: none)", 0},
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
        def->alpha = number("alpha", value, 0, 1e300, false, state);
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
        def->scatter_decades = number("scatter", value, 0, 100, false, state);
    else if (key == 's')
        def->lambda_s_m = command_length("lambda-s", value, state);
    else if (key == 'd')
        def->seed = (unsigned long)number("seed", value, 0, 4294967295.0, true, state);
    else if (key == 'o')
        arguments->output = strcmp(value, "-") == 0 ? NULL : value;
    else
        return ARGP_ERR_UNKNOWN;
    return 0;
}

static enum status_code write_scan(const struct arguments *arguments, const double *height_m, struct status *status)
{
    const struct synth_def *def = &arguments->def;
    struct text csv = {0};
    text_add(&csv, "x [um],z [um]\n");
    double spacing_um = def->length_m / (double)def->points * 1e6;
    for (size_t i = 0; i < def->points; i++)
        text_add(&csv, "%.10g,%.6f\n", (double)i * spacing_um, height_m[i] * 1e6); /* heights to the picometre */
    enum status_code rc = STATUS_OK;
    if (csv.failed)
        rc = status_memory(status);
    else if (arguments->output)
        rc = command_write(arguments->output, &csv, false, status);
    else
        fwrite(csv.data, 1, csv.length, stdout);
    text_free(&csv);
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
    double *height_m = calloc(arguments.def.points + 1, sizeof *height_m);
    enum status_code rc = height_m ? synth_profile(height_m, &arguments.def, &status) : status_memory(&status);
    if (rc == STATUS_OK)
        rc = write_scan(&arguments, height_m, &status);
    free(height_m);
    return command_finish(rc == STATUS_OK ? COMMAND_DONE : command_fail(&status), NULL);
}
