/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Slopes, columns and sidecars from the command line to the report. */
#include "cli/process.h"
#include "support.h"

#include <jansson.h>
#include <math.h>
#include <stdio.h>

enum { POINTS = 256 };

/* Slopes and heights of one rough profile, 10 um apart, in a file without a header. The heights are what the
 * trapezoidal rule makes of the slopes. */
static void write_scan(const char *place, const char *path)
{
    char text[POINTS * 64];
    size_t used = 0;
    double z_um = 0, before_urad = 0;
    for (int i = 0; i < POINTS; i++) {
        double urad = 40e3 * sin(0.3 * i * i) + 9e3 * sin(0.2 * i);
        z_um += i > 0 ? 0.5e-6 * (urad + before_urad) * 10 : 0;
        before_urad = urad;
        used += (size_t)snprintf(text + used, sizeof text - used, "%d %.17g %.17g\n", 10 * i, urad, z_um);
    }
    workspace_write(place, path, text);
}

/* As DABAM writes it; X1_FACTOR is to be filled in. */
static void write_sidecar(const char *place, const char *path, const char *factor)
{
    char text[256];
    snprintf(text, sizeof text,
             "{\"FILE_FORMAT\": 1, \"X1_FACTOR\": %s, \"Y1_FACTOR\": 1e-6, \"Y2_FACTOR\": 1e-6,\n"
             "\"PLOT_TITLE_Y2\": \"height\"}\n",
             factor);
    workspace_write(place, path, text);
}

static double inspected(const char *out, const char *key)
{
    json_t *all = json_loads(out, 0, NULL);
    double value = json_number_value(json_object_get(json_array_get(all, 0), key));
    json_decref(all);
    return value;
}

TEST_IN_WORKSPACE(test_inspect)
{
    const char *place = *state;
    write_scan(place, "a.dat");
    expect_failure(place, 4, 1, "no unit for x nor for z", "inspect", "a.dat");
    write_sidecar(place, "a.txt", "1e-6");
    expect_failure(place, 4, 1,
                   "a.dat: column 2 is a slope in urad by its sidecar 'a.txt', not heights; to integrate it", "inspect",
                   "a.dat");
    expect_failure(place, 4, 1, "column 3 has heights in um by its sidecar 'a.txt', not slopes", "inspect", "a.dat",
                   "--column", "3", "--quantity", "slope");
    expect_failure(place, 4, 1, "there is no column 7: there are 3 columns", "inspect", "a.dat", "--column", "7");
    expect_failure(place, 2, 3, "unknown quantity 'slops'; allowed: height, slope", "inspect", "a.dat", "--quantity",
                   "slops");
    struct process slopes = expect_exit(place, 0, "inspect", "--json", "--quantity", "slope", "a.dat"),
                   heights = expect_exit(place, 0, "inspect", "--json", "--column", "1,3", "a.dat");
    assert_near(inspected(slopes.out, "rq_m"), inspected(heights.out, "rq_m"), 1e-12);
    assert_near(inspected(slopes.out, "m2"), inspected(heights.out, "m2"), 1e-12);
    expect_parts(slopes.out, "the sidecar 'a.txt' gave the units: x in um, z in urad",
                 "slopes in urad, integrated to heights by the trapezoidal rule");
    process_free(&slopes);
    process_free(&heights);
}

/* The first cell of `column` in every row of data/surfaces.csv, which has no quoted cells. */
static void surfaces_of(const char *place, const char *column, double values[2])
{
    char *csv = workspace_read(place, "out/d/data/surfaces.csv");
    char *line = csv;
    size_t at = 0;
    for (const char *cell = csv; strncmp(cell, column, strlen(column)) != 0; at++)
        cell = strchr(cell, ',') + 1;
    for (size_t i = 0; i < 2; i++) {
        line = strchr(line, '\n') + 1;
        const char *cell = line;
        for (size_t k = 0; k < at; k++)
            cell = strchr(cell, ',') + 1;
        values[i] = strtod(cell, NULL);
    }
    free(csv);
}

static char *hash_of(const char *place)
{
    char *json = workspace_read(place, "out/d/results.json");
    char *at = strstr(json, "\"sha256\"");
    assert_non_null(at);
    at = strndup(at, strcspn(at, ","));
    free(json);
    return at;
}

TEST_IN_WORKSPACE(test_report)
{
    const char *place = *state;
    double rq_m[2];
    write_scan(place, "d/a.dat");
    write_sidecar(place, "d/a.txt", "1e-6");
    expect_failure(place, 4, 2, "column 2 is a slope in urad by its sidecar 'a.txt', not heights", "report", "d",
                   "--no-cost");
    workspace_write(place, "d/scene.yaml",
                    "effects: []\nmodels: [multiscale]\nsurfaces:\n"
                    "  - {name: slopes, file: a.dat, quantity: slope}\n"
                    "  - {name: heights, file: a.dat, column: 3}\n");
    run_to_exit(place, 0, "report", "d", "--no-cost");
    surfaces_of(place, "rq_m", rq_m);
    assert_true(rq_m[0] > 0);
    assert_near(rq_m[0], rq_m[1], 1e-12);
    char *hash = hash_of(place);
    expect_in_file(place, "out/d/report.md", "integrated to heights by the trapezoidal rule",
                   "gave the units: x in um, z in urad");
    /* what the sidecar says is input as the scan is */
    write_sidecar(place, "d/a.txt", "1e-3");
    run_to_exit(place, 0, "report", "d", "--no-cost");
    char *other = hash_of(place);
    assert_string_not_equal(hash, other);
    free(hash);
    free(other);
    surfaces_of(place, "rq_m", rq_m);
    assert_near(rq_m[0], 1000 * rq_m[1], 1e-9); /* a thousand times the way, the heights as they are */
}

/* A scan and its sidecar are one surface, not a surface and a refusal. */
TEST_IN_WORKSPACE(test_directory)
{
    const char *place = *state;
    workspace_scan(place, "d/a.dat", 128, 1);
    write_sidecar(place, "d/a.txt", "1e-3");
    struct process process = expect_exit(place, 0, "report", "d", "--no-cost");
    expect_no_part(process.err, "refused");
    process_free(&process);
    char *csv = workspace_read(place, "out/d/data/surfaces.csv");
    expect_part(csv, "\na,a.dat,");
    expect_no_part(csv, "a.txt");
    free(csv);
}

/* What is done to the scan of a counterface is said as for any other. */
TEST_IN_WORKSPACE(test_counterface)
{
    const char *place = *state;
    workspace_scan(place, "d/s.csv", 256, 1);
    write_scan(place, "d/a.dat");
    write_sidecar(place, "d/a.txt", "1e-6");
    workspace_write(place, "d/scene.yaml",
                    "effects: []\nmodels: [multiscale]\ncounterface: {surface: a.dat, quantity: slope}\n"
                    "surfaces: [{name: s, file: s.csv}]\n");
    struct process process = expect_exit(place, 0, "report", "d", "--no-cost");
    expect_parts(process.err, "surface 's': counterface a.dat: slopes in urad, integrated to heights",
                 "surface 's': counterface a.dat: the sidecar 'a.txt' gave the units: x in um, z in urad");
    expect_no_part(process.err, "counterface gamma");
    process_free(&process);
    char *report = workspace_read(place, "out/d/report.md");
    expect_part(report, "counterface a.dat: slopes in urad, integrated to heights");
    free(report);
}
