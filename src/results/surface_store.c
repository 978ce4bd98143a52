/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/surface_store.h"

#include <errno.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum status_code surface_store_open(struct surface_store *out, const char *directory, size_t count,
                                    struct status *status)
{
    *out = (struct surface_store){.count = count, .lock = PTHREAD_MUTEX_INITIALIZER};
    out->summaries = calloc(count, sizeof *out->summaries);
    out->places = calloc(count, sizeof *out->places);
    if (!out->summaries || !out->places)
        return status_memory(status);
    if (!directory)
        return STATUS_OK;
    if (!*directory) {
        out->file = tmpfile();
        return out->file ? STATUS_OK
                         : status_fail(status, STATUS_IO, "cannot make a temporary file: %s", strerror(errno));
    }
    struct text path = {0};
    text_add(&path, "%s/store-XXXXXX", directory);
    int descriptor = path.failed ? -1 : mkstemp(path.data);
    if (descriptor >= 0) {
        unlink(path.data);
        out->file = fdopen(descriptor, "w+b");
    }
    text_free(&path);
    if (!out->file)
        return status_fail(status, STATUS_IO, "cannot write in '%s': %s", directory, strerror(errno));
    return STATUS_OK;
}

void surface_store_close(struct surface_store *store)
{
    for (size_t i = 0; store->summaries && i < store->count; i++)
        surface_summary_free(&store->summaries[i]);
    free(store->summaries);
    free(store->places);
    if (store->file)
        fclose(store->file);
    *store = (struct surface_store){0};
}

/** Appends a part of a record; *place is where. */
static enum status_code append(struct surface_store *store, off_t *place,
                               bool (*put)(FILE *file, const struct surface_record *record),
                               const struct surface_record *record, struct status *status)
{
    if (!record->summary.usable || !store->file)
        return STATUS_OK;
    pthread_mutex_lock(&store->lock);
    bool ok = (*place = ftello(store->file)) >= 0; /* it stands at its end: readers do not move it */
    ok = ok && put(store->file, record) && fflush(store->file) == 0;
    int reason = errno;
    pthread_mutex_unlock(&store->lock);
    return ok ? STATUS_OK
              : status_fail(status, STATUS_IO, "cannot write results to a temporary file: %s", status_reason(reason));
}

enum status_code surface_store_put_arrays(struct surface_store *store, size_t index,
                                          const struct surface_record *record, struct status *status)
{
    return append(store, &store->places[index].arrays, surface_bytes_put_arrays, record, status);
}

enum status_code surface_store_update(struct surface_store *store, size_t index, const struct surface_record *record,
                                      struct status *status)
{
    if (append(store, &store->places[index].curves, surface_bytes_put_curves, record, status) != STATUS_OK)
        return status->code;
    pthread_mutex_lock(&store->lock);
    for (size_t m = 0; record->work && m < model_count; m++)
        work_add(&store->models_done, m, &record->work[m]);
    pthread_mutex_unlock(&store->lock);
    store->summaries[index] = record->summary;
    return STATUS_OK;
}

enum status_code surface_store_put(struct surface_store *store, size_t index, const struct surface_record *record,
                                   struct status *status)
{
    return surface_store_put_arrays(store, index, record, status) == STATUS_OK
               ? surface_store_update(store, index, record, status)
               : status->code;
}

enum status_code surface_store_get_part(struct surface_record *out, struct surface_store *store, size_t index,
                                        enum surface_bytes_part part, struct status *status)
{
    memset(out, 0, offsetof(struct surface_record, preview_x_m)); /* the rest is 16 KB, of which few are used */
    const struct surface_place *place = &store->places[index];
    if (surface_bytes_get(out, fileno(store->file), place->curves, place->arrays, &store->summaries[index], part))
        return STATUS_OK;
    surface_record_free(out, false);
    return status_fail(status, STATUS_IO, "cannot read the results back");
}

enum status_code surface_store_get(struct surface_record *out, struct surface_store *store, size_t index,
                                   struct status *status)
{
    return surface_store_get_part(out, store, index, SURFACE_BYTES_ALL, status);
}
