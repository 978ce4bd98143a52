/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "members/surface_read.h"

#include "base/clock.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Notes a scan that its surface goes on without. */
static void note_refused_scan(struct surface_summary *summary, const char *others, const char *why)
{
    note_add_refused(&summary->notes, others, why);
    summary->refused_scans++;
}

static enum status_code hash_file(struct hash *hash, const char *path, struct status *status)
{
    struct text bytes = {0};
    enum status_code rc = text_read_file(&bytes, path, status);
    if (rc == STATUS_OK)
        hash_add(hash, bytes.data, bytes.length);
    text_free(&bytes);
    return rc;
}

/** Adds the scan at options->entry of a file's bytes, and where the next one is. What lies beside the file and belongs
 * to it changes the numbers too. */
static enum status_code add_scan(const struct surface_scans *task, const struct scan_bytes *bytes, const char *path,
                                 struct scan_options *options, struct hash *hash, struct status *status)
{
    struct surface_summary *summary = &task->record->summary;
    struct scan scan = {0};
    double started = clock_seconds();
    enum status_code rc = scan_read_beside(&scan, bytes, path, options, status);
    if (rc == STATUS_OK && scan.sidecar && options->entry == 0)
        rc = hash_file(hash, scan.sidecar, status);
    if (rc == STATUS_OK && scan.kind == SCAN_AREAL && task->scene->direction == SCAN_DIRECTION_Y)
        rc = scan_transpose(&scan, status);
    summary->times.read += clock_seconds() - started;
    if (rc == STATUS_OK)
        rc = surface_rows_add(task, &scan, bytes->path, status);
    if (rc == STATUS_OK) {
        snprintf(summary->format, sizeof summary->format, "%s", scan.format);
        snprintf(summary->units, sizeof summary->units, "x %s, z %s", scan.x_unit, scan.z_unit);
    }
    options->entry = scan.next_entry;
    scan_free(&scan);
    return rc;
}

/** Adds the scans of a file, of which an archive may hold several: one that cannot be used costs itself alone. */
static enum status_code add_scans(const struct surface_scans *task, struct text *text, const char *file,
                                  const char *path, struct hash *hash, struct status *status)
{
    const struct scene_surface *surface = task->record->summary.scene;
    struct scan_options options = {.x_unit = surface->x_unit,
                                   .z_unit = surface->z_unit,
                                   .x_column = surface->x_column,
                                   .z_column = surface->z_column,
                                   .spent = text};
    const struct scan_bytes bytes = {text->data, text->length, file};
    struct surface_summary *summary = &task->record->summary;
    struct status refused = {0};
    size_t added = 0, of_archive = 0;
    do {
        struct status problem = {0};
        enum status_code rc = add_scan(task, &bytes, path, &options, hash, &problem);
        of_archive += options.entry > 0;
        if (rc == STATUS_OK)
            added++;
        else if (rc != STATUS_SCAN || of_archive == 0)
            return status_fail(status, rc, "%s", problem.message);
        else
            note_refused_scan(summary, "archive", problem.message);
        if (rc != STATUS_OK && refused.code == STATUS_OK)
            refused = problem;
    } while (options.entry > 0);
    return added > 0 ? STATUS_OK : status_fail(status, refused.code, "%s", refused.message);
}

enum status_code surface_files_read_one(const struct surface_scans *task, const char *file, struct hash *hash,
                                        struct status *status)
{
    struct text bytes = {0};
    char *path = scene_file_path(task->scene, file);
    if (!path)
        return status_memory(status);
    double started = clock_seconds();
    enum status_code rc = text_read_file(&bytes, path, status);
    task->record->summary.times.read += clock_seconds() - started;
    if (rc == STATUS_OK) {
        hash_add(hash, bytes.data, bytes.length); /* of a file that is refused, too */
        rc = add_scans(task, &bytes, file, path, hash, status);
    }
    text_free(&bytes);
    free(path);
    return rc;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/** Notes which scans were refused, where others are used. */
static void note_refused(struct surface_summary *summary, char *const *refusal, size_t count, size_t used)
{
    char others[80] = "";
    if (used > 0)
        snprintf(others, sizeof others, "used %zu\nscans %zu", used, count);
    bool first = true; /* of a surface that has no other: that is its own refusal */
    for (size_t f = 0; f < count; f++) {
        if (refusal[f] && (used > 0 || !first))
            note_refused_scan(summary, others, refusal[f]);
        first = first && !refusal[f];
    }
}

enum status_code surface_files_read(const struct surface_scans *task, struct hash *hash, struct status *status)
{
    const struct scene_surface *surface = task->record->summary.scene;
    size_t count = surface->files.count, used = 0;
    struct status refused = {0};
    const char **file = malloc((count + 1) * sizeof *file);
    char **refusal = calloc(count + 1, sizeof *refusal);
    enum status_code rc = file && refusal ? STATUS_OK : status_memory(status);
    for (size_t f = 0; f < count && rc == STATUS_OK; f++)
        file[f] = surface->files.path[f];
    if (rc == STATUS_OK) /* what comes out does not depend on the order in which a scene lists them */
        qsort(file, count, sizeof *file, by_name);
    for (size_t f = 0; f < count && rc == STATUS_OK; f++) {
        struct status problem = {0};
        enum status_code own = surface_files_read_one(task, file[f], hash, &problem);
        used += own == STATUS_OK;
        if (own == STATUS_MEMORY || own == STATUS_INTERRUPTED)
            rc = status_fail(status, own, "%s", problem.message);
        else if (own != STATUS_OK && !(refusal[f] = strdup(problem.message)))
            rc = status_memory(status);
        else if (own != STATUS_OK && refused.code == STATUS_OK)
            refused = problem;
    }
    if (rc == STATUS_OK && count > 1)
        note_refused(&task->record->summary, refusal, count, used);
    if (rc == STATUS_OK && used == 0)
        rc = status_fail(status, STATUS_SCAN, "%s", refused.message);
    for (size_t f = 0; refusal && f < count; f++)
        free(refusal[f]);
    free(refusal);
    free(file);
    return rc;
}
