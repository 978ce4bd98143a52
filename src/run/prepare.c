#include "run/prepare.h"

#include "analysis/effect_bounds.h"
#include "run/workers.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/** Reads the rough counterface, if the scene has one. It must be readable: no result would mean anything without it. */
static enum status_code read_counterface(struct prepared *out, const struct scene *scene, struct status *status)
{
    if (scene->counterface_surface.file_count == 0)
        return STATUS_OK;
    out->counterface = calloc(1, sizeof *out->counterface);
    if (!out->counterface)
        return status_memory(status);
    if (surface_describe(out->counterface, scene, &scene->counterface_surface, NULL, status) != STATUS_OK)
        return status->code;
    if (!out->counterface->summary.usable)
        return status_fail(status, STATUS_SCENE, "the counterface cannot be read: %s",
                           out->counterface->summary.refusal);
    out->results.counterface = out->counterface;
    return STATUS_OK;
}

enum status_code prepare(struct prepared *out, const struct scene *scene, const struct run_options *options,
                         const char *directory, struct status *status)
{
    *out = (struct prepared){0};
    plan_make(&out->plan, scene);
    size_t load_count = 0;
    if (scene_loads(&out->loads, &load_count, scene, out->plan.pair.effective_modulus_Pa, status) != STATUS_OK)
        return status->code;
    out->results = (struct results){
        .scene = scene, .plan = &out->plan, .loads = out->loads, .load_count = load_count, .store = &out->store};
    if (scene->surface_count == 0)
        return status_fail(status, STATUS_SCAN, "no scan in '%s': put the profilometer's files there",
                           scene->directory);
    if (read_counterface(out, scene, status) != STATUS_OK)
        return status->code;
    if (surface_store_open(&out->store, directory, scene->surface_count, status) != STATUS_OK ||
        workers_run(&out->results, workers_describe, options, status) != STATUS_OK)
        return status->code;
    effect_bounds_plan(&out->plan, scene, out->store.summaries, out->store.count);
    if (scene->measured.file) {
        if (measured_read(&out->measured, scene, &out->plan, status) != STATUS_OK)
            return status->code;
        out->results.measured = &out->measured;
    }
    out->results.predicted = work_predict(out->store.summaries, out->store.count, scene, &out->plan, load_count);
    return STATUS_OK;
}

void prepared_free(struct prepared *prepared)
{
    surface_store_close(&prepared->store);
    measured_free(&prepared->measured);
    if (prepared->counterface)
        surface_record_free(prepared->counterface, true);
    free(prepared->counterface);
    free(prepared->loads);
    *prepared = (struct prepared){0};
}

static void add_message(struct text *messages, const char *surface, const char *what, const char *message)
{
    text_add(messages, "surface '");
    text_add_shown(messages, surface);
    text_add(messages, "'%s: ", what);
    text_add_shown(messages, message);
    text_add(messages, "\n");
}

size_t prepare_messages(struct text *messages, const struct surface_store *store)
{
    size_t refused = 0;
    for (size_t i = 0; i < store->count; i++) {
        const struct surface_summary *summary = &store->summaries[i];
        refused += summary->refusal != NULL;
        if (summary->refusal)
            add_message(messages, summary->scene->name, " refused", summary->refusal);
        for (const char *line = summary->notes; line && *line;) {
            size_t length = strcspn(line, "\n");
            struct text one = {0};
            text_add_bytes(&one, line, length);
            add_message(messages, summary->scene->name, "", text_string(&one));
            text_free(&one);
            line += length + (line[length] == '\n');
        }
    }
    return refused;
}

void prepare_table(struct text *out, const struct prepared *prepared, const struct work *done)
{
    struct work_row predicted[WORK_ROWS], actual[WORK_ROWS];
    double seconds, unused;
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    double memory =
        work_memory(prepared->store.summaries, prepared->store.count, processors > 0 ? (unsigned)processors : 1);
    uint64_t total = work_total(&prepared->results.predicted, &prepared->plan, &seconds);
    uint64_t total_done = work_total(done ? done : &prepared->results.predicted, &prepared->plan, &unused);
    work_table(predicted, &prepared->results.predicted, &prepared->plan);
    work_table(actual, done ? done : &prepared->results.predicted, &prepared->plan);
    text_add(out, "%-16s %-8s %14s%s %10s %8s  %s\n", "effect", "", "evaluations", done ? "           done" : "",
             "seconds", "memory", "why; how");
    for (int r = 0; r < WORK_ROWS; r++) {
        const struct work_row *row = &predicted[r];
        text_add(out, "%-16s %-8s %14llu", row->name, row->runs ? "run" : "skipped",
                 (unsigned long long)row->evaluations);
        if (done)
            text_add(out, " %14llu", (unsigned long long)actual[r].evaluations);
        double bytes = r == 0 ? memory : row->bytes; /* the area's arrays serve the others too */
        text_add(out, " %10.4f %5.1f MB  %s%s%s\n", row->seconds, bytes / 1e6, row->reason, row->runs ? "; " : "",
                 row->method);
    }
    text_add(out, "%-16s %-8s %14llu", "all", "", (unsigned long long)total);
    if (done)
        text_add(out, " %14llu", (unsigned long long)total_done);
    text_add(out, " %10.4f %5.1f MB\n", seconds, (memory + predicted[EFFECT_CONVERGENCE + 1].bytes) / 1e6);
}
