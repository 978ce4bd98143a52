/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "members/surface_read.h"

#include "base/clock.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Notes a scan that is not used; the surface has others. */
static void note_refused_scan(struct surface_summary *summary, const char *others, const char *why)
{
    note_add_refused(&summary->notes, others, why);
    summary->refused_scans++;
}

static enum status_code hash_file(struct hash *hash, const char *path, struct status *status)
{
    OWNED(text_free) struct text bytes = {0};
    enum status_code rc = text_read_file(&bytes, path, status);
    if (rc == STATUS_OK)
        hash_add(hash, bytes.data, bytes.length);
    return rc;
}

/** `kept` becomes `own`, or `several` where an earlier scan had another. */
static void keep_common(char *kept, size_t size, const char *own, const char *several)
{
    snprintf(kept, size, "%s", *kept && strcmp(kept, own) != 0 ? several : own);
}

/** Adds the scan at options->entry, and moves that to the next one. A file beside it that holds its units changes the
 * numbers, so that the hash takes it too. */
static enum status_code add_scan(const struct surface_scans *task, const struct scan_bytes *bytes, const char *path,
                                 struct scan_options *options, struct hash *hash, struct status *status)
{
    struct surface_summary *summary = &task->record->summary;
    OWNED(scan_free) struct scan scan = {0};
    double started = clock_seconds();
    summary->all_scans++;
    enum status_code rc = scan_read_beside(&scan, bytes, path, options, status);
    if (rc == STATUS_OK && scan.sidecar && options->entry == 0)
        rc = hash_file(hash, scan.sidecar, status);
    if (rc == STATUS_OK && scan.kind == SCAN_AREAL && task->scene->direction == SCAN_DIRECTION_Y)
        rc = scan_transpose(&scan, status);
    const char *of = NULL;
    char name[512];
    snprintf(name, sizeof name, *scan.part ? "%.400s(%s)" : "%.400s%s", bytes->path, scan.part);
    if (rc == STATUS_OK)
        rc = copies_find(&of, task->copies, &scan, name, status);
    summary->times.read += clock_seconds() - started;
    if (of)
        note_add(&summary->notes, name, "note.copy\nof\t%s", strcmp(of, name) == 0 ? "" : of);
    else if (rc == STATUS_OK) {
        rc = surface_rows_add(task, &scan, name, status);
        if (rc != STATUS_OK) /* a copy of a refused scan is not called a copy */
            free(task->copies->prints[--task->copies->count].file);
    }
    if (rc == STATUS_OK && !of) {
        char units[sizeof summary->units];
        snprintf(units, sizeof units, "x %s, z %s", scan.x_unit, scan.z_unit);
        keep_common(summary->format, sizeof summary->format, scan.format, "several formats");
        keep_common(summary->units, sizeof summary->units, units, "several units");
    }
    options->entry = scan.next_entry;
    return rc;
}

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
        if (rc != STATUS_OK)
            (void)status_fail(&refused, rc, "%s", problem.message); /* the first */
    } while (options.entry > 0);
    return added > 0 ? STATUS_OK : status_fail(status, refused.code, "%s", refused.message);
}

/** Adds the scans of one file; of an archive with several, only those that cannot be used are left out. `hash` takes
 * its bytes, and those of a file that belongs to it. */
static enum status_code read_one(const struct surface_scans *task, const char *file, struct hash *hash,
                                 struct status *status)
{
    OWNED(text_free) struct text bytes = {0};
    OWNED(memory_free) char *path = scene_file_path(task->scene, file);
    if (!path)
        return status_memory(status);
    double started = clock_seconds();
    enum status_code rc = text_read_file(&bytes, path, status);
    task->record->summary.times.read += clock_seconds() - started;
    task->record->summary.all_scans += rc != STATUS_OK;
    if (rc == STATUS_OK) {
        hash_add(hash, bytes.data, bytes.length); /* also of a file that is refused */
        rc = add_scans(task, &bytes, file, path, hash, status);
    }
    return rc;
}

/** A file and the hash of its bytes; "" if it cannot be read, which is an error once it is added. */
struct content {
    char digits[2 * HASH_BYTES + 1];
    const char *file;
};

static int by_content(const void *a, const void *b)
{
    const struct content *one = a, *other = b;
    const int order = strcmp(one->digits, other->digits);
    return order != 0 ? order : strcmp(one->file, other->file);
}

/** The files of a surface in the order of their contents, malloc'ed; NULL: out of memory. */
static struct content *files_by_content(const struct surface_scans *task, const struct scene_surface *surface)
{
    struct content *out = calloc(surface->files.count + 1, sizeof *out);
    for (size_t f = 0; out && f < surface->files.count; f++) {
        struct status unread = {0};
        struct hash hash = hash_start();
        OWNED(memory_free)
        char *path = surface->files.count > 1 ? scene_file_path(task->scene, surface->files.path[f]) : NULL;
        out[f].file = surface->files.path[f];
        if (path && hash_file(&hash, path, &unread) == STATUS_OK)
            hash_finish(&hash, out[f].digits);
    }
    if (out)
        qsort(out, surface->files.count, sizeof *out, by_content);
    return out;
}

/** Notes which scans were refused; where none is used, the first reason is the surface's own. */
static void note_refused(struct surface_summary *summary, char *const *refusal, size_t count, size_t used)
{
    char others[80] = "";
    if (used > 0)
        snprintf(others, sizeof others, "used %zu\nscans %zu", used, count);
    for (size_t f = used > 0 ? 0 : 1; f < count; f++)
        if (refusal[f])
            note_refused_scan(summary, others, refusal[f]);
}

enum status_code surface_files_read(const struct surface_scans *task, struct hash *hash, struct status *status)
{
    const struct scene_surface *surface = task->record->summary.scene;
    size_t count = surface->files.count, used = 0;
    OWNED(memory_free) struct content *file = files_by_content(task, surface);
    char **refusal = calloc(count + 1, sizeof *refusal);
    enum status_code rc = file && refusal ? STATUS_OK : status_memory(status);
    for (size_t f = 0; f < count && rc == STATUS_OK; f++) {
        struct status problem = {0};
        enum status_code own = read_one(task, file[f].file, hash, &problem);
        used += own == STATUS_OK;
        if (own == STATUS_MEMORY || own == STATUS_INTERRUPTED)
            rc = status_fail(status, own, "%s", problem.message);
        else if (own != STATUS_OK && !(refusal[f] = strdup(problem.message)))
            rc = status_memory(status);
    }
    if (rc == STATUS_OK && count > 1)
        note_refused(&task->record->summary, refusal, count, used);
    if (rc == STATUS_OK && used == 0)
        rc = status_fail(status, STATUS_SCAN, "%s", refusal[0]);
    for (size_t f = 0; refusal && f < count; f++)
        free(refusal[f]);
    free(refusal);
    return rc;
}
