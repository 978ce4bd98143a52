/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz.h"

#include "chart/gnuplot.h"
#include "run/pipeline.h"
#include "wild_scene.h"
#include <ctype.h>
#include <gsl/gsl_errno.h>

enum { CHOICES = 8 };

/* In place of gnuplot (ld --wrap, tests/CMakeLists.txt): every picture is written, and empty. */
enum status_code __wrap_gnuplot_start(struct gnuplot *out, const char *directory, struct status *status);
void __wrap_gnuplot_send(struct gnuplot *gnuplot, const char *commands);
enum status_code __wrap_gnuplot_finish(struct gnuplot *gnuplot, struct status *status);

static char figures[4096];

enum status_code __wrap_gnuplot_start(struct gnuplot *out, const char *directory, struct status *status)
{
    (void)status;
    *out = (struct gnuplot){.input = -1};
    snprintf(figures, sizeof figures, "%s", directory);
    return STATUS_OK;
}

void __wrap_gnuplot_send(struct gnuplot *gnuplot, const char *commands)
{
    char name[64];
    OWNED(text_free) struct text path = {0};
    struct status status = {0};
    (void)gnuplot;
    FUZZ_REQUIRE(sscanf(commands, "load '%63[a-z0-9-].gp'", name) == 1);
    text_add(&path, "%s/%s.svg", figures, name);
    FUZZ_REQUIRE(text_write_file(text_string(&path), "<svg/>", 6, &status) == STATUS_OK);
}

enum status_code __wrap_gnuplot_finish(struct gnuplot *gnuplot, struct status *status)
{
    (void)gnuplot, (void)status;
    return STATUS_OK;
}

/* splitmix64 of the input's last bytes, which choose the scene */
static uint64_t chosen;

static size_t below(size_t count)
{
    uint64_t z = chosen += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return (size_t)((z ^ (z >> 31)) % count);
}

static const struct directory *place;

/* A directory with a good scan. */
static void make_place(void)
{
    static struct directory made;
    if (place)
        return;
    snprintf(made.path, sizeof made.path, "%s", fuzz_place());
    place = &made;
    gsl_set_error_handler_off(); /* as the program does */
    pipeline_rough(place, "good.csv", 64, 1, 1);
    directory_write(place, "s1/scan0.csv", "");
    pipeline_rough(place, "s1/scan0.csv", 40, 1, 2);
}

static void put(const char *name, const char *bytes, size_t length)
{
    struct status status = {0};
    FUZZ_REQUIRE(text_write_file(directory_path(place, name), bytes, length, &status) == STATUS_OK);
}

/* No file of the report has a NaN or an infinity. */
static void require_numbers(const char *name)
{
    static const char *const words[] = {"nan", "inf", "infinity"};
    OWNED(text_free) struct text text = {0};
    struct status status = {0};
    FUZZ_REQUIRE(text_read_file(&text, directory_path(place, name), &status) == STATUS_OK);
    for (const char *at = text_string(&text); *at;) {
        size_t length = 0;
        while (isalnum((unsigned char)at[length]) || at[length] == '_')
            length++;
        for (size_t w = 0; w < sizeof words / sizeof *words; w++)
            FUZZ_REQUIRE(strlen(words[w]) != length || strncasecmp(at, words[w], length) != 0);
        at += length ? length : 1;
    }
    FUZZ_REQUIRE(text.length > 0);
}

static bool report(const struct scene *scene)
{
    struct run_outcome outcome;
    struct status status = {0};
    char out[256];
    snprintf(out, sizeof out, "%s/out", place->path);
    const struct run_options options = {.output = out,
                                        .templates = PROJECT_SOURCE "/templates",
                                        .no_cost = below(16) > 0,
                                        .brief = below(4) > 0,
                                        .jobs = 1};
    enum status_code code = run_report(&outcome, scene, &options, &status);
    if (code == STATUS_OK) {
        FUZZ_REQUIRE(outcome.refused < scene->surface_count && outcome.path);
        require_numbers("out/data/surfaces.csv");
        if (access(directory_path(place, "out/data/contact.csv"), F_OK) == 0) /* not where all is pressed flat */
            require_numbers("out/data/contact.csv");
    } else {
        FUZZ_REQUIRE((code == STATUS_SCAN || code == STATUS_SCENE || code == STATUS_MODEL) && *status.message);
        FUZZ_REQUIRE(!strchr(status.message, '\n'));
    }
    run_outcome_free(&outcome);
    return code == STATUS_OK;
}

/* A surface of the file, of it twice, of it and a good scan, or two surfaces. */
void fuzz_report(const uint8_t *bytes, size_t length)
{
    static const char *const surfaces[] = {
        "{name: s1, file: scan.dat, x_unit: um, z_unit: um}",
        "{name: s1, file: [scan.dat, again.dat], x_unit: um, z_unit: um}",
        "{name: s1, file: scan.dat, x_unit: mm, z_unit: nm, column: [1, 2]}, {name: s2, file: good.csv}",
        "{name: s1, file: [good.csv, scan.dat], x_unit: um, z_unit: um}"};
    static const char *const quick[] = {"load", "tolerance", "direct", "effects", NULL}; /* no seconds for a run */
    static const char *const effects[] = {"[]", "[separation, convergence]", "[separation, stiffness, last-scale]",
                                          "auto"};
    struct scene scene;
    struct status status = {0};
    OWNED(text_free) struct text text = {0};
    make_place();
    chosen = 0;
    memcpy(&chosen, bytes + (length > CHOICES ? length - CHOICES : 0), length > CHOICES ? CHOICES : length);
    OWNED(memory_free) char *file = fuzz_file((const char *)bytes, &length);
    put("scan.dat", file, length);
    put("again.dat", file, length);
    wild_scene(&text, quick, below, SIZE_MAX);
    text_add(&text, "load: {from: 1e-4, to: 0.1, points: 3}\ntolerance: 0.1\neffects: %s\n",
             effects[below(below(8) > 0 ? 3 : 4)]);
    text_add(&text, "surfaces: [%s]\n", surfaces[below(sizeof surfaces / sizeof *surfaces)]);
    enum status_code code = scene_read(&scene, place->path, &(struct scene_overrides){.text = &text}, &status);
    FUZZ_REQUIRE(code == STATUS_OK || (code == STATUS_SCENE && *status.message));
    fuzz_count("report", code == STATUS_OK && report(&scene));
    scene_free(&scene);
}
