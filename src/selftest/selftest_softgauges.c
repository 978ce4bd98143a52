/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Software gauges (ISO 5436-2, type F2 data in its own file format): profiles that are formulas, read as a file would
 * be, and their parameters. */
#include "base/text.h"
#include "profile/profile.h"
#include "scan/scan.h"
#include "selftest/selftest.h"
#include "spectrum/parameters.h"

#include <math.h>
#include <string.h>

enum { SINE_POINTS = 8000, TRIANGLE_POINTS = 4000, TRIANGLE_QUARTER = 50 };

/** NIST's sine of ASME B46: to four decimals, with a pi of 3.14155. All 8000 points are those of its file. */
static double sine_um(size_t i)
{
    return round(sin(2 * 3.14155 * 0.5 / 400 * (double)i) * 1e4) / 1e4;
}

/** A triangle (ISO 5436-1, type C2) of 1 um and 100 um, 200 points a wave, half a step from its corners. */
static double triangle_um(size_t i)
{
    double phase = ((double)(i % (4 * TRIANGLE_QUARTER)) + 0.5) / TRIANGLE_QUARTER; /* 0 to 4 */
    return phase < 1 ? phase : phase < 3 ? 2 - phase : phase - 4;
}

static const struct gauge {
    const char *name;
    size_t points;
    double (*height_um)(size_t i);
} gauges[] = {{"sine", SINE_POINTS, sine_um}, {"triangle", TRIANGLE_POINTS, triangle_um}};

#define HALF_DIGIT(digit, value) (0.5000001 * (digit) / (value))

/* Printed figures hold to half of their last digit. */
static const struct selftest_reference references[] = {
    {"sine", "a", {0}, 0.63663e-6, HALF_DIGIT(1e-5, 0.63663)},
    {"sine", "q", {0}, 0.70711e-6, HALF_DIGIT(1e-5, 0.70711)},
    {"sine", "dq", {0}, 0.0111, HALF_DIGIT(1e-4, 0.0111)},
    {"sine", "t", {0}, 2e-6, 1e-6},
    {"sine", "ku", {0}, 1.5, 1e-4}, /* of whole waves, which with this pi they nearly are */
    {"sine", "sm", {0}, 400e-6, 1e-4},
    {"triangle", "a", {0}, 0.5e-6, 1e-12},
    {"triangle", "q", {0}, 5.773214009544424e-7, 1e-12}, /* A sqrt(1/3 - 1/(12 n²)), n = 50 a quarter */
    {"triangle", "t", {0}, 1.98e-6, 1e-12},              /* 2 A (1 - 1/(2 n)) */
    {"triangle", "p", {0}, 0.99e-6, 1e-12},
    {"triangle", "v", {0}, 0.99e-6, 1e-12},
    {"triangle", "ku", {0}, 1.7997599759975997, 1e-12},
    {"triangle", "sm", {0}, 100e-6, 1e-9},
};

/** Writes a field or a record's end as SMD has them: NUL and ETX, which stand here as '@' and '$'. */
static void add_smd(struct text *out, const char *pattern)
{
    for (; *pattern; pattern++)
        text_add_bytes(out, *pattern == '@' ? "\0" : *pattern == '$' ? "\3" : pattern, 1);
}

static void write_gauge(struct text *out, const struct gauge *gauge)
{
    add_smd(out, "ISO 5436-2:2012@softgauge@\r\nPRF@ 1 ISO5436@\r\nCX@ I@ ");
    text_add(out, "%zu", gauge->points);
    add_smd(out, " um@ 1.0e0 D@ 0.5\r\nCZ@ A@ ");
    text_add(out, "%zu", gauge->points);
    add_smd(out, " um@ 1.0e0 D@\r\n$\r\n$\r\n");
    for (size_t i = 0; i < gauge->points; i++)
        text_add(out, "%.17g\r\n", gauge->height_um(i));
    add_smd(out, "$\r\n");
}

static enum status_code measure(struct parameters *out, const struct gauge *gauge, struct status *status)
{
    static const struct scan_options options = {.x_unit = ""};
    struct text file = {0};
    struct scan scan = {0};
    struct profile profile = {0};
    write_gauge(&file, gauge);
    enum status_code rc = file.failed ? status_memory(status) : STATUS_OK;
    if (rc == STATUS_OK)
        rc = scan_read_bytes(&scan, &(struct scan_bytes){text_string(&file), file.length, gauge->name}, &options,
                             status);
    if (rc == STATUS_OK)
        rc = profile_make(&profile, &scan, 0, &(struct profile_options){.level = LEVEL_MEAN}, status);
    if (rc == STATUS_OK)
        rc = parameters_compute(out, 'P', profile.height_m, profile.points, profile.spacing_m, 1, status);
    profile_free(&profile);
    scan_free(&scan);
    text_free(&file);
    return rc;
}

static enum status_code compute(double *values, const struct selftest_reference *all, size_t count,
                                struct status *status)
{
    for (size_t g = 0; g < sizeof gauges / sizeof gauges[0]; g++) {
        struct parameters parameters;
        if (measure(&parameters, &gauges[g], status) != STATUS_OK)
            return status->code;
        for (size_t i = 0; i < count; i++)
            if (strcmp(all[i].what, gauges[g].name) == 0)
                values[i] = parameters_value(&parameters, all[i].of);
    }
    return STATUS_OK;
}

const struct selftest_group selftest_softgauges = {
    .name = "softgauges",
    .source =
        "figures that NIST's algorithm testing system prints for its sine of ASME B46; closed forms of ISO 5436-1 "
        "type C2",
    .references = references,
    .count = sizeof references / sizeof references[0],
    .compute = compute,
};
