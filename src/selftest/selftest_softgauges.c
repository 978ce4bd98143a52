/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Software gauges (ISO 5436-2, type F2): profiles that are formulas, read as a file would be, and their parameters. */
#include "profile/profile.h"
#include "scan/scan.h"
#include "selftest/selftest_compute.h"
#include "spectrum/parameters.h"

#include <math.h>
#include <string.h>

/** NIST's sine of ASME B46: to four decimals, with a pi of 3.14155. All 8000 points are those of its file. */
static double sine_um(size_t i)
{
    return round(sin(2 * 3.14155 * 0.5 / 400 * (double)i) * 1e4) / 1e4;
}

/** A triangle (ISO 5436-1, type C2) of 1 um and 100 um, 200 points a wave, half a step from its corners. */
static double triangle_um(size_t i)
{
    double phase = ((double)(i % 200) + 0.5) / 50; /* 0 to 4 */
    return phase < 1 ? phase : phase < 3 ? 2 - phase : phase - 4;
}

static const struct gauge {
    const char *name;
    size_t points;
    double (*height_um)(size_t i);
} gauges[] = {{"sine", 8000, sine_um}, {"triangle", 4000, triangle_um}};

static enum status_code measure(struct parameters *out, const struct gauge *gauge, struct status *status)
{
    static const struct scan_options options = {.no_programs = true};
    struct text file = {0};
    struct scan scan = {0};
    struct profile profile = {0};
    text_add(&file, "x [um],z [um]\n");
    for (size_t i = 0; i < gauge->points; i++)
        text_add(&file, "%.1f,%.17g\n", 0.5 * (double)i, gauge->height_um(i));
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

enum status_code selftest_softgauge(double *value, const struct selftest_reference *r,
                                    const struct selftest_table *table, struct status *status)
{
    struct parameters parameters;
    size_t g = 0;
    (void)table;
    while (g < 2 && strcmp(gauges[g].name, r->of) != 0)
        g++;
    if (g == 2)
        return selftest_unknown(r, status);
    if (measure(&parameters, &gauges[g], status) != STATUS_OK)
        return status->code;
    *value = parameters_value(&parameters, r->quantity);
    return STATUS_OK;
}
