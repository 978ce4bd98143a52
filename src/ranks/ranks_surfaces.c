/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "ranks/ranks_surfaces.h"

#include "ranks/ranks_team.h"
#include "results/surface_bytes.h"
#include "run/prepare.h"

#include <stdlib.h>
#include <string.h>

struct ranks_task ranks_surfaces_task(const struct results *results, enum workers_task task,
                                      const struct run_options *options)
{
    const struct scene_overrides *overrides = options->overrides;
    const char *text[RANKS_SOURCE_TEXTS] = {results->scene->directory, overrides->material, overrides->effects,
                                            overrides->x_unit, overrides->z_unit};
    struct ranks_task out = {.task = task,
                             .surfaces = results->store->count,
                             .kept = results->measured ? results->baseline : results->store->count,
                             .jobs = options->jobs ? options->jobs : 1, /* ranks are what it is parallel by */
                             .tolerance = overrides->tolerance,
                             .direct = overrides->direct,
                             .plan = *results->plan};
    for (int i = 0; i < RANKS_SOURCE_TEXTS; i++)
        out.length[i] = text[i] ? strlen(text[i]) + 1 : 0;
    return out;
}

static size_t source_bytes(const struct ranks_task *task)
{
    size_t bytes = 0;
    for (int i = 0; i < RANKS_SOURCE_TEXTS; i++)
        bytes += task->length[i];
    return bytes;
}

/** Tells the others where the scene is. */
static enum status_code tell_source(const struct direct_team *team, MPI_Comm communicator,
                                    const struct ranks_task *task, const struct results *results,
                                    const struct scene_overrides *overrides, struct status *status)
{
    const char *text[RANKS_SOURCE_TEXTS] = {results->scene->directory, overrides->material, overrides->effects,
                                            overrides->x_unit, overrides->z_unit};
    size_t bytes = source_bytes(task), used = 0;
    char *all = malloc(bytes);
    if (!all)
        (void)status_memory(status);
    for (int i = 0; i < RANKS_SOURCE_TEXTS && all; i++) {
        if (text[i])
            memcpy(all + used, text[i], task->length[i]);
        used += task->length[i];
    }
    if (direct_team_agree(team, status) == STATUS_OK)
        ranks_spread(all, bytes, 0, communicator);
    free(all);
    return status->code;
}

/** Puts a surface that another process has worked on into the store; then its texts are the store's. */
static enum status_code put_surface(struct surface_store *store, size_t index, struct surface_record *record,
                                    struct status *status)
{
    struct surface_summary *stored = &store->summaries[index];
    if (stored->direct) { /* decided here, with all other surfaces in view */
        free(record->summary.direct);
        record->summary.direct = stored->direct;
        stored->direct = NULL;
    }
    surface_summary_free(stored);
    *stored = (struct surface_summary){0};
    return surface_store_put(store, index, record, status);
}

/** Takes the surface `index` from the rank that did it, which sends nothing if it cannot; with an error already there,
 * only takes the bytes. */
static enum status_code receive_surface(const struct results *results, size_t index, int from, MPI_Comm communicator,
                                        struct status *status)
{
    size_t size;
    ranks_receive(&size, sizeof size, from, communicator);
    char *bytes = malloc(size + 1);
    struct surface_record *record = malloc(sizeof *record);
    if (!bytes)
        MPI_Abort(communicator, EXIT_FAILURE); /* nowhere to put what is being sent: that rank would wait for ever */
    ranks_receive(bytes, size, from, communicator);
    if (!record || size == 0)
        (void)status_memory(status);
    else if (status->code == STATUS_OK &&
             surface_bytes_unpack(record, bytes, size, results->scene, index, status) == STATUS_OK)
        surface_record_free(record, put_surface(results->store, index, record, status) != STATUS_OK);
    free(record);
    free(bytes);
    return status->code;
}

/** What this rank has of a surface, as bytes: owned. */
static enum status_code pack_surface(char **bytes, size_t *size, const struct results *results, size_t index,
                                     struct status *status)
{
    struct surface_record *record = calloc(1, sizeof *record);
    if (!record)
        return status_memory(status);
    enum status_code rc = STATUS_OK;
    record->summary = results->store->summaries[index];
    if (record->summary.usable)
        rc = surface_store_get(record, results->store, index, status);
    if (rc == STATUS_OK)
        rc = surface_bytes_pack(bytes, size, record, results->scene, status);
    surface_record_free(record, false);
    free(record);
    return rc;
}

static void send_surface(const struct results *results, size_t index, MPI_Comm communicator)
{
    size_t size = 0;
    char *bytes = NULL;
    struct status status = {0};
    if (pack_surface(&bytes, &size, results, index, &status) != STATUS_OK)
        size = 0;
    ranks_send(&size, sizeof size, 0, communicator);
    ranks_send(bytes, size, 0, communicator);
    free(bytes);
}

/** This rank's share; what went wrong on any is everybody's error. */
static enum status_code do_share(const struct direct_team *team, MPI_Comm communicator, enum workers_task task,
                                 const struct results *results, const struct run_options *options,
                                 struct status *status)
{
    enum status_code rc = workers_share(results, task, team->rank, team->size, options, status);
    ranks_wait_for_all(communicator);
    return direct_team_agree(team, status) != STATUS_OK ? status->code : rc;
}

enum status_code ranks_surfaces_lead(const struct direct_team *team, MPI_Comm communicator,
                                     const struct ranks_task *task, const struct results *results,
                                     const struct run_options *options, struct status *status)
{
    struct run_options own = *options;
    own.jobs = task->jobs;
    if (tell_source(team, communicator, task, results, options->overrides, status) != STATUS_OK ||
        direct_team_agree(team, status) != STATUS_OK) /* have all read the scene? */
        return status->code;
    if (do_share(team, communicator, task->task, results, &own, status) != STATUS_OK)
        return status->code;
    for (size_t i = 0; i < task->surfaces; i++)
        if (i % team->size != 0)
            (void)receive_surface(results, i, (int)(i % team->size), communicator, status);
    return status->code;
}

/** Reads the scene that the texts speak of. */
static enum status_code read_scene(struct ranks_surfaces *surfaces, const struct ranks_task *task,
                                   struct status *status)
{
    const char *text[RANKS_SOURCE_TEXTS], *next = surfaces->texts;
    for (int i = 0; i < RANKS_SOURCE_TEXTS; i++) {
        text[i] = task->length[i] ? next : NULL;
        next += task->length[i];
    }
    const struct scene_overrides overrides = {text[1], text[2], task->tolerance, text[3], text[4], task->direct};
    if (scene_read(&surfaces->scene, text[0], &overrides, status) != STATUS_OK)
        return status->code;
    if (surfaces->scene.surface_count != task->surfaces)
        return status_fail(status, STATUS_IO,
                           "'%s' has %zu surfaces for one process and %zu for the first: all have to "
                           "see the same files",
                           text[0], surfaces->scene.surface_count, task->surfaces);
    return prepare_begin(surfaces->prepared, &surfaces->scene, "", status);
}

void ranks_surfaces_free(struct ranks_surfaces *surfaces)
{
    if (surfaces->prepared)
        prepared_free(surfaces->prepared);
    free(surfaces->prepared);
    scene_free(&surfaces->scene);
    free(surfaces->texts);
    *surfaces = (struct ranks_surfaces){0};
}

void ranks_surfaces_follow(struct ranks_surfaces *surfaces, const struct direct_team *team, MPI_Comm communicator,
                           const struct ranks_task *task, const atomic_bool *stop)
{
    static const struct measured asked = {0}; /* stands for the first rank's, which alone looks into it */
    struct status status = {0};               /* the first rank has the same, and says it */
    struct run_options options = {.jobs = task->jobs, .stop = stop};
    if (task->task == WORKERS_DESCRIBE)
        ranks_surfaces_free(surfaces);
    char *texts = malloc(source_bytes(task));
    if (!surfaces->prepared)
        surfaces->prepared = calloc(1, sizeof *surfaces->prepared);
    if (!texts || !surfaces->prepared)
        (void)status_memory(&status);
    if (direct_team_agree(team, &status) != STATUS_OK) {
        free(texts);
        return;
    }
    ranks_spread(texts, source_bytes(task), 0, communicator);
    if (!surfaces->texts) {
        surfaces->texts = texts;
        (void)read_scene(surfaces, task, &status);
    } else
        free(texts);
    if (direct_team_agree(team, &status) != STATUS_OK)
        return;
    struct results *results = &surfaces->prepared->results;
    surfaces->prepared->plan = task->plan;
    results->baseline = task->kept;
    results->measured = task->kept < task->surfaces ? &asked : NULL;
    if (do_share(team, communicator, task->task, results, &options, &status) != STATUS_OK)
        return;
    for (size_t i = team->rank; i < task->surfaces; i += team->size)
        send_surface(results, i, communicator);
}
