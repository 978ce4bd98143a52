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

/* Runs the scene in place/IN into place/OUT; what comes back is to be freed. */
static inline enum status_code pipeline_try(struct run_outcome *outcome, const struct directory *place, const char *in,
                                            struct run_options options, struct status *status)
{
    const struct scene_overrides none = {0};
    struct scene scene;
    if (scene_read(&scene, filled("%s", directory_path(place, in)), &none, status) != STATUS_OK)
        fail_msg("%s", status->message);
    enum status_code rc = run_report(outcome, &scene, &options, status);
    scene_free(&scene);
    return rc;
}

/* The same into place/OUT, on one thread and without cost unless the options say otherwise. */
static inline enum status_code pipeline_into(struct run_outcome *outcome, const struct directory *place, const char *in,
                                             const char *out, struct run_options options, struct status *status)
{
    options.output = filled("%s", directory_path(place, out));
    options.templates = options.templates ? options.templates : PROJECT_SOURCE "/templates";
    options.no_cost = true;
    options.jobs = options.jobs ? options.jobs : 1;
    return pipeline_try(outcome, place, in, options, status);
}

/* The same of a run that has to succeed. */
static inline void pipeline_outcome(struct run_outcome *outcome, const struct directory *place, const char *in,
                                    const char *out, unsigned jobs)
{
    struct status status = {0};
    if (pipeline_into(outcome, place, in, out, (struct run_options){.jobs = jobs}, &status) != STATUS_OK)
        fail_msg("%s\n%s", status.message, text_string(&outcome->messages));
}

/* Returns how many surfaces were refused. */
static inline size_t pipeline_run(const struct directory *place, const char *in, const char *out, unsigned jobs)
{
    struct run_outcome outcome;
    pipeline_outcome(&outcome, place, in, out, jobs);
    size_t refused = outcome.refused;
    run_outcome_free(&outcome);
    return refused;
}

#endif
