/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/surface_bytes.h"

#include "base/large.h"
#include <assert.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/** An array of nothing may be NULL, which fwrite() must not be given. */
static bool put_array(FILE *file, const void *array, size_t size, size_t count)
{
    return count == 0 || fwrite(array, size, count, file) == count;
}

enum { POINT_COLUMNS = sizeof(struct contact_point) / sizeof(double) };
static_assert(POINT_COLUMNS * sizeof(double) == sizeof(struct contact_point) && POINT_COLUMNS <= 32,
              "a point is doubles alone");

/** A curve's points column by column; one whose numbers are all the same, such as of what did not run, as one number.
 */
static bool put_points(FILE *file, const struct contact_point *points, size_t count)
{
    const double *value = (const double *)points;
    uint32_t varied = 0;
    for (size_t c = 0; c < POINT_COLUMNS; c++)
        for (size_t i = 1; i < count && !(varied >> c & 1); i++)
            if (memcmp(&value[i * POINT_COLUMNS + c], &value[c], sizeof *value) != 0)
                varied |= UINT32_C(1) << c;
    double *column = malloc(count * sizeof *column);
    bool ok = column && put_array(file, &varied, sizeof varied, 1);
    for (size_t c = 0; c < POINT_COLUMNS && ok; c++) {
        size_t numbers = varied >> c & 1 ? count : 1;
        for (size_t i = 0; i < numbers; i++)
            column[i] = value[i * POINT_COLUMNS + c];
        ok = put_array(file, column, sizeof *column, numbers);
    }
    free(column);
    return ok;
}

/** Where bytes come from: a place of a file, which any number of threads read at once. */
struct source {
    const char *next; /* held, not taken yet: `left` of them */
    size_t left;
    int file; /* -1: none */
    off_t at; /* where in it the others begin */
    char *held;
};

enum { SOURCE_HELD = 1 << 15 /* the curves of an ordinary surface; larger arrays go past it */ };

static bool get_bytes(struct source *from, void *out, size_t size)
{
    char *to = out;
    while (size > 0) {
        bool past = size >= SOURCE_HELD;
        if (from->left == 0) {
            ssize_t got =
                from->file < 0 ? 0 : pread(from->file, past ? to : from->held, past ? size : SOURCE_HELD, from->at);
            if (got <= 0)
                return false;
            from->at += got;
            from->next = past ? to : from->held;
            from->left = (size_t)got;
        }
        size_t taken = from->left < size ? from->left : size;
        if (from->next != to)
            memcpy(to, from->next, taken);
        from->next += taken;
        from->left -= taken;
        to += taken;
        size -= taken;
    }
    return true;
}

static struct contact_point *get_points(struct source *file, size_t count, bool *ok)
{
    struct contact_point *points = malloc(count * sizeof *points);
    double *value = (double *)points, *column = malloc(count * sizeof *column);
    uint32_t varied;
    *ok = *ok && points && column && get_bytes(file, &varied, sizeof varied);
    for (size_t c = 0; c < POINT_COLUMNS && *ok; c++) {
        bool one = !(varied >> c & 1);
        *ok = get_bytes(file, column, (one ? 1 : count) * sizeof *column);
        for (size_t i = 0; i < count && *ok; i++)
            value[i * POINT_COLUMNS + c] = column[one ? 0 : i];
    }
    free(column);
    if (*ok)
        return points;
    free(points);
    return NULL;
}

bool surface_bytes_put_curves(FILE *file, const struct surface_record *record)
{
    bool ok = put_array(file, record, offsetof(struct surface_record, preview_x_m), 1);
    ok = ok && put_array(file, record->preview_x_m, sizeof(double), record->preview_points);
    ok = ok && put_array(file, record->preview_z_m, sizeof(double), record->preview_points);
    ok = ok && put_array(file, record->curves, sizeof *record->curves, record->curves ? model_count : 0);
    ok = ok && put_array(file, record->bands, sizeof *record->bands, record->bands ? model_count : 0);
    for (size_t m = 0; record->curves && m < model_count; m++) {
        ok =
            ok && (record->curves[m].count == 0 || put_points(file, record->curves[m].points, record->curves[m].count));
        ok = ok &&
             put_array(file, record->bands[m], sizeof(struct repeats_band), record->bands[m] ? record->band_count : 0);
    }
    ok = ok && put_array(file, record->work, sizeof *record->work, record->work ? model_count : 0);
    return ok;
}

bool surface_bytes_put_arrays(FILE *file, const struct surface_record *record)
{
    bool ok = put_array(file, record->spectrum.amplitude_m, sizeof(double), record->spectrum.count);
    ok = ok && put_array(file, record->tapered.amplitude_m, sizeof(double), record->tapered.count);
    for (int v = 0; v < SENSITIVITY_VARIANTS; v++) {
        const struct spectrum *changed = &record->sensitivity.variants[v].spectrum;
        ok = ok && put_array(file, changed->amplitude_m, sizeof(double), changed->count);
    }
    ok = ok && put_array(file, record->points, sizeof *record->points, record->points ? record->summary.heights : 0);
    ok = ok && put_array(file, record->direct_m, sizeof(double), record->direct_count);
    const struct repeat_set *set = &record->repeats;
    ok = ok && put_array(file, record->height_m, sizeof(double), record->height_m ? record->summary.single_points : 0);
    ok = ok && put_array(file, set->scans, sizeof *set->scans, set->scan_count);
    ok = ok && put_array(file, set->parts, sizeof *set->parts, set->count);
    for (size_t p = 0; p < set->count; p++)
        ok = ok && put_array(file, set->parts[p].spectrum.amplitude_m, sizeof(double), set->parts[p].spectrum.count);
    return ok;
}

/** The next array, malloc'ed; NULL for one of nothing. */
static void *get_array(struct source *file, size_t size, size_t count, bool *ok)
{
    if (count == 0 || !*ok)
        return NULL;
    void *array = large_alloc(count, size);
    if (array && get_bytes(file, array, count * size))
        return array;
    free(array);
    *ok = false;
    return NULL;
}

/** The scans run alone; set->count and set->scan_count are already there. */
static void get_repeats(struct repeat_set *set, struct source *file, bool *ok)
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

/** What the record says apart from its large arrays, of which it then has none. */
static void get_header(struct surface_record *out, struct source *file, bool *ok)
{
    size_t preview = 0;
    *ok = *ok && get_bytes(file, out, offsetof(struct surface_record, preview_x_m));
    if (!*ok)
        *out = (struct surface_record){0};
    preview = out->preview_points;
    *ok = *ok && preview <= SURFACE_PREVIEW && get_bytes(file, out->preview_x_m, preview * sizeof(double)) &&
          get_bytes(file, out->preview_z_m, preview * sizeof(double));
}

/** The curves, their bands and what they took, of which the record has the place. */
static void get_curves(struct surface_record *out, struct source *file, bool *ok)
{
    out->curves = get_array(file, sizeof *out->curves, out->curves ? model_count : 0, ok);
    out->bands = get_array(file, sizeof *out->bands, out->bands ? model_count : 0, ok);
    for (size_t m = 0; out->curves && m < model_count; m++) {
        out->curves[m].points = out->curves[m].count > 0 ? get_points(file, out->curves[m].count, ok) : NULL;
        if (out->bands && out->bands[m])
            out->bands[m] = get_array(file, sizeof(struct repeats_band), out->band_count, ok);
    }
    out->work = get_array(file, sizeof *out->work, out->work ? model_count : 0, ok);
}

/** The arrays behind the spectrum. */
static void get_rest(struct surface_record *out, struct source *file, bool *ok)
{
    out->tapered.amplitude_m = get_array(file, sizeof(double), out->tapered.count, ok);
    for (int v = 0; v < SENSITIVITY_VARIANTS; v++) {
        struct spectrum *changed = &out->sensitivity.variants[v].spectrum;
        changed->amplitude_m = get_array(file, sizeof(double), changed->count, ok);
    }
    out->points = get_array(file, sizeof *out->points, out->points ? out->summary.heights : 0, ok);
    out->direct_m = get_array(file, sizeof(double), out->direct_count, ok);
    out->height_m = get_array(file, sizeof(double), out->height_m ? out->summary.single_points : 0, ok);
    get_repeats(&out->repeats, file, ok);
}

/** Of the arrays behind the spectrum: none. */
static void leave_rest(struct surface_record *out)
{
    out->tapered = (struct spectrum){0};
    for (int v = 0; v < SENSITIVITY_VARIANTS; v++)
        out->sensitivity.variants[v].spectrum = (struct spectrum){0};
    out->points = NULL;
    out->direct_m = out->height_m = NULL;
    out->direct_count = 0;
    out->repeats = (struct repeat_set){0};
}

static bool get_record(struct surface_record *out, struct source *file, off_t arrays_at,
                       const struct surface_summary *summary, enum surface_bytes_part part)
{
    bool ok = true;
    get_header(out, file, &ok);
    out->summary = *summary;
    get_curves(out, file, &ok);
    if (part == SURFACE_BYTES_CURVES)
        out->spectrum = (struct spectrum){0};
    else {
        file->at = arrays_at;
        file->left = 0;
    }
    out->spectrum.amplitude_m = get_array(file, sizeof(double), out->spectrum.count, &ok);
    if (part == SURFACE_BYTES_ALL)
        get_rest(out, file, &ok);
    else
        leave_rest(out);
    return ok;
}

bool surface_bytes_get(struct surface_record *out, int file, off_t curves_at, off_t arrays_at,
                       const struct surface_summary *summary, enum surface_bytes_part part)
{
    struct source source = {.file = file, .at = curves_at, .held = malloc(SOURCE_HELD)};
    if (!source.held)
        source.file = -1;
    bool ok = get_record(out, &source, arrays_at, summary, part);
    free(source.held);
    return ok;
}
