/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The whole program on a small scene in a temporary directory. */
#ifndef TEST_PIPELINE_H
#define TEST_PIPELINE_H

#include "directory.h"
#include "profile/synth.h"
#include "run/run.h"

/* Writes a scan of `points` heights, spacing 0.5 um, in place/NAME. */
static inline void pipeline_scan(const struct directory *place, const char *name, const double *height_m, size_t points)
{
    struct text csv = {0};
    text_add(&csv, "x [um],z [um]\n");
    for (size_t i = 0; i < points; i++)
        text_add(&csv, "%g,%.9f\n", 0.5 * (double)i, height_m[i] * 1e6);
    directory_write(place, name, text_string(&csv));
    text_free(&csv);
}

/* Writes a made-up profile in place/NAME. */
static inline void pipeline_synth(const struct directory *place, const char *name, const struct synth_def *def)
{
    double *height_m = calloc(def->points, sizeof *height_m);
    assert_non_null(height_m);
    expect_ok(synth_profile, height_m, def);
    pipeline_scan(place, name, height_m, def->points);
    free(height_m);
}

/* A random surface of a power law, `size` times as rough as that of tin in the thesis. */
static inline void pipeline_rough(const struct directory *place, const char *name, size_t points, double size,
                                  unsigned long seed)
{
    struct synth_def def = synth_def_default();
    def.points = points;
    def.length_m = 5e-7 * (double)points;
    def.alpha *= size;
    def.seed = seed;
    pipeline_synth(place, name, &def);
}

/* A bowl: levelled by a line its Nayak parameter is 0.2, so that no statistical model exists. */
static inline void pipeline_bowl(const struct directory *place, const char *name, size_t points)
{
    double height_m[256];
    assert_true(points <= 256);
    for (size_t i = 0; i < points; i++)
        height_m[i] = 1e-9 * (double)(i * i);
    pipeline_scan(place, name, height_m, points);
}

static inline void pipeline_end(void *outcome)
{
    run_outcome_free(outcome);
    free(outcome);
}

/* Runs the scene in place/IN; status->code says how it ended. What comes back is the test's. */
static inline struct run_outcome *pipeline_try(const struct directory *place, const char *in,
                                               struct run_options options, struct status *status)
{
    struct run_outcome *outcome = test_owns(calloc(1, sizeof *outcome), pipeline_end);
    struct scene scene;
    expect_ok(scene_read, &scene, lasting("%s", directory_path(place, in)), &(struct scene_overrides){0});
    (void)!run_report(outcome, &scene, &options, status);
    scene_free(&scene);
    return outcome;
}

/* The same into place/OUT, on one thread unless the options say otherwise, and without cost. */
static inline struct run_outcome *pipeline_into(const struct directory *place, const char *in, const char *out,
                                                struct run_options options, struct status *status)
{
    options.output = filled("%s", directory_path(place, out));
    options.templates = options.templates ? options.templates : PROJECT_SOURCE "/templates";
    options.no_cost = true;
    options.jobs = options.jobs ? options.jobs : 1;
    return pipeline_try(place, in, options, status);
}

/* The same of a run that has to succeed. */
static inline struct run_outcome *pipeline_outcome(const struct directory *place, const char *in, const char *out,
                                                   struct run_options options)
{
    struct status status = {0};
    struct run_outcome *outcome = pipeline_into(place, in, out, options, &status);
    if (status.code != STATUS_OK)
        fail_msg("%s\n%s", status.message, text_string(&outcome->messages));
    return outcome;
}

/* Returns how many surfaces were refused. */
static inline size_t pipeline_run(const struct directory *place, const char *in, const char *out, unsigned jobs)
{
    return pipeline_outcome(place, in, out, (struct run_options){.jobs = jobs})->refused;
}

/* The report, in place/OUT, of this scene on the files in place/IN, none of which is refused. */
static inline void pipeline_report(const struct directory *place, const char *in, const char *out, const char *scene)
{
    directory_write(place, filled("%s/scene.yaml", in), scene);
    assert_int_equal(pipeline_run(place, in, out, 1), 0);
}

/* A number in place/OUT/results.json, at a path such as "surfaces/0/rq_m"; NaN: none is there. */
static inline double pipeline_number(const struct directory *place, const char *out, const char *path)
{
    return json_number_at(directory_json(place, filled("%s/results.json", out)), path);
}

/* The first row of a surface (NULL: of any) by a model at a load (NaN: at any); fails the test when there is none. */
static inline size_t pipeline_row(const struct table *table, const char *surface, const char *model, double load)
{
    for (size_t row = 0; row < table->rows; row++)
        if ((!surface || strcmp(table_text(table, row, "surface"), surface) == 0) &&
            strcmp(table_text(table, row, "model"), model) == 0 &&
            !(fabs(table_number(table, row, "load_over_AnEp") / load - 1) > 1e-9))
            return row;
    fail_msg("no row of %s, %s at %g", surface ? surface : "any", model, load);
    return 0;
}

#endif
