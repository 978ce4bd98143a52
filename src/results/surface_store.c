#include "results/surface_store.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum status_code surface_store_open(struct surface_store *out, const char *directory, size_t count,
                                    struct status *status)
{
    *out = (struct surface_store){.count = count, .lock = PTHREAD_MUTEX_INITIALIZER};
    out->summaries = calloc(count, sizeof *out->summaries);
    out->offsets = calloc(count, sizeof *out->offsets);
    if (!out->summaries || !out->offsets)
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
    free(store->offsets);
    if (store->file)
        fclose(store->file);
    *store = (struct surface_store){0};
}

/** An array of nothing may be NULL, which fwrite() must not be given. */
static bool put_array(FILE *file, const void *array, size_t size, size_t count)
{
    return count == 0 || fwrite(array, size, count, file) == count;
}

static bool put_arrays(FILE *file, const struct surface_record *record)
{
    bool ok = put_array(file, record, sizeof *record, 1);
    ok = ok && put_array(file, record->spectrum.amplitude_m, sizeof(double), record->spectrum.count);
    ok = ok && put_array(file, record->tapered.amplitude_m, sizeof(double), record->tapered.count);
    ok = ok && put_array(file, record->curves, sizeof *record->curves, record->curves ? model_count : 0);
    ok = ok && put_array(file, record->bands, sizeof *record->bands, record->bands ? model_count : 0);
    for (size_t m = 0; record->curves && m < model_count; m++) {
        ok = ok && put_array(file, record->curves[m].points, sizeof(struct contact_point), record->curves[m].count);
        ok = ok &&
             put_array(file, record->bands[m], sizeof(struct repeats_band), record->bands[m] ? record->band_count : 0);
    }
    for (int v = 0; v < SENSITIVITY_VARIANTS; v++) {
        const struct spectrum *changed = &record->sensitivity.variants[v].spectrum;
        ok = ok && put_array(file, changed->amplitude_m, sizeof(double), changed->count);
    }
    ok = ok && put_array(file, record->points, sizeof *record->points, record->summary.heights);
    ok = ok && put_array(file, record->direct_m, sizeof(double), record->direct_count);
    const struct repeat_set *set = &record->repeats;
    ok = ok && put_array(file, record->height_m, sizeof(double), record->height_m ? record->summary.single_points : 0);
    ok = ok && put_array(file, set->scans, sizeof *set->scans, set->scan_count);
    ok = ok && put_array(file, set->parts, sizeof *set->parts, set->count);
    for (size_t p = 0; p < set->count; p++)
        ok = ok && put_array(file, set->parts[p].spectrum.amplitude_m, sizeof(double), set->parts[p].spectrum.count);
    return ok;
}

enum status_code surface_store_put(struct surface_store *store, size_t index, const struct surface_record *record,
                                   struct status *status)
{
    if (record->summary.usable && store->file) {
        pthread_mutex_lock(&store->lock);
        bool ok = fseek(store->file, 0, SEEK_END) == 0 && (store->offsets[index] = ftell(store->file)) >= 0;
        ok = ok && put_arrays(store->file, record);
        int reason = errno;
        pthread_mutex_unlock(&store->lock);
        if (!ok)
            return status_fail(status, STATUS_IO, "cannot write results to a temporary file: %s",
                               status_reason(reason));
    }
    store->summaries[index] = record->summary;
    return STATUS_OK;
}

/** The next array of the file, malloc'ed; NULL for one of nothing. */
static void *get_array(FILE *file, size_t size, size_t count, bool *ok)
{
    if (count == 0 || !*ok)
        return NULL;
    void *array = malloc(size * count);
    if (array && fread(array, size, count, file) == count)
        return array;
    free(array);
    *ok = false;
    return NULL;
}

/** The scans run alone; set->count and set->scan_count are already there. */
static void get_repeats(struct repeat_set *set, FILE *file, bool *ok)
{
    size_t count = set->count;
    set->scans = get_array(file, sizeof *set->scans, set->scan_count, ok);
    set->parts = get_array(file, sizeof *set->parts, count, ok);
    set->capacity = set->parts ? count : 0;
    for (set->count = 0; set->count < count && set->parts; set->count++) {
        struct repeat *part = &set->parts[set->count];
        part->spectrum.amplitude_m = get_array(file, sizeof(double), part->spectrum.count, ok);
        part->height_m = NULL;
    }
}

enum status_code surface_store_get(struct surface_record *out, struct surface_store *store, size_t index,
                                   struct status *status)
{
    pthread_mutex_lock(&store->lock);
    bool ok = fseek(store->file, store->offsets[index], SEEK_SET) == 0 && fread(out, sizeof *out, 1, store->file) == 1;
    if (!ok)
        memset(out, 0, sizeof *out);
    out->summary = store->summaries[index];
    out->spectrum.amplitude_m = get_array(store->file, sizeof(double), out->spectrum.count, &ok);
    out->tapered.amplitude_m = get_array(store->file, sizeof(double), out->tapered.count, &ok);
    out->curves = get_array(store->file, sizeof *out->curves, out->curves ? model_count : 0, &ok);
    out->bands = get_array(store->file, sizeof *out->bands, out->bands ? model_count : 0, &ok);
    for (size_t m = 0; out->curves && m < model_count; m++) {
        out->curves[m].points = get_array(store->file, sizeof(struct contact_point), out->curves[m].count, &ok);
        if (out->bands && out->bands[m])
            out->bands[m] = get_array(store->file, sizeof(struct repeats_band), out->band_count, &ok);
    }
    for (int v = 0; v < SENSITIVITY_VARIANTS; v++) {
        struct spectrum *changed = &out->sensitivity.variants[v].spectrum;
        changed->amplitude_m = get_array(store->file, sizeof(double), changed->count, &ok);
    }
    out->points = get_array(store->file, sizeof *out->points, out->summary.heights, &ok);
    out->direct_m = get_array(store->file, sizeof(double), out->direct_count, &ok);
    out->height_m = get_array(store->file, sizeof(double), out->height_m ? out->summary.single_points : 0, &ok);
    get_repeats(&out->repeats, store->file, &ok);
    pthread_mutex_unlock(&store->lock);
    if (ok)
        return STATUS_OK;
    surface_record_free(out, false);
    return status_fail(status, STATUS_IO, "cannot read the results back");
}
