/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Software gauges: profiles that are formulas, read as a file would be, and their parameters as others print them. */
#include "base/text.h"
#include "profile/profile.h"
#include "scan/scan_support.h"
#include "spectrum/parameters.h"

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

static struct parameters measure(size_t points, double (*height_um)(size_t i))
{
    static const struct scan_options options = {0};
    struct text *file = support_text();
    struct scan scan;
    struct profile profile;
    text_add(file, "x [um],z [um]\n");
    for (size_t i = 0; i < points; i++)
        text_add(file, "%.1f,%.17g\n", 0.5 * (double)i, height_um(i));
    expect_ok(read_bytes, &scan, file->data, file->length, &options);
    expect_ok(profile_make, &profile, &scan, 0, &(struct profile_options){.level = LEVEL_MEAN});
    struct parameters parameters = parameters_compute('P', profile.height_m, profile.points, profile.spacing_m, 1);
    profile_free(&profile);
    scan_free(&scan);
    return parameters;
}

TEST_CASE(softgauges_measure_as_printed)
{
    struct table table = table_read("softgauges.csv");
    const struct parameters sine = measure(8000, sine_um), triangle = measure(4000, triangle_um);
    for (size_t row = 0; row < table.rows; row++) {
        const char *gauge = table_text(&table, row, "gauge"), *name = table_text(&table, row, "parameter");
        double expected = table_number(&table, row, "expected"), tolerance = table_number(&table, row, "tolerance");
        double value = parameter_named(strcmp(gauge, "sine") == 0 ? &sine : &triangle, name);
        if (!(fabs(value - expected) <= tolerance * expected))
            fail_msg("%s, P%s: %.17g, not %.17g", gauge, name, value, expected);
    }
    assert_int_equal(table.rows, 13);
}
