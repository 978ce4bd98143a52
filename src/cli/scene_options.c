#include "cli/scene_options.h"

#include "scan/scan.h"
#include <stdlib.h>
#include <string.h>

enum { KEY_X_UNIT = 0x100, KEY_Z_UNIT };

static const struct argp_option options[] = {
    {"material", 'm', "NAME", 0, "a built-in material (default: the scene's, else tin)", 1},
    {"effects", 'e', "LIST", 0,
     "auto, or some of plasticity,separation,electrical,thermal,scale-dependent,convergence "
     "(default: the scene's, else auto)",
     1},
    {"tolerance", 't', "REL", 0, "relative tolerance of every number, 1e-14 to 0.1 (default: the scene's, else 1e-6)",
     1},
    {"x-unit", KEY_X_UNIT, "UNIT", 0, "unit of x where a file names none (default: the scene's)", 1},
    {"z-unit", KEY_Z_UNIT, "UNIT", 0, "unit of z where a file names none (default: the scene's)", 1},
    {0},
};

static const char *unit(const char *value, const char *name, struct argp_state *state)
{
    if (scan_unit_m(value, strlen(value)) == 0)
        argp_error(state, "--%s must be a unit of length such as m, mm, um, nm or in, not '%s'", name, value);
    return value;
}

static error_t parse(int key, char *value, struct argp_state *state)
{
    struct scene_overrides *overrides = state->input;
    char *end;
    switch (key) {
    case 'm':
        overrides->material = value;
        return 0;
    case 'e':
        overrides->effects = value;
        return 0;
    case 't':
        overrides->tolerance = strtod(value, &end);
        if (*end != '\0' || end == value || !(overrides->tolerance >= 1e-14 && overrides->tolerance <= 0.1))
            argp_error(state, "--tolerance must be a number from 1e-14 to 0.1, not '%s'", value);
        return 0;
    case KEY_X_UNIT:
        overrides->x_unit = unit(value, "x-unit", state);
        return 0;
    case KEY_Z_UNIT:
        overrides->z_unit = unit(value, "z-unit", state);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

const struct argp scene_options_argp = {options, parse, NULL, NULL, NULL, NULL, NULL};
