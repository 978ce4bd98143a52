#include "analysis/gather.h"

#include "base/clock.h"
#include "spectrum/grid.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void gather_note(struct surface_summary *summary, const char *format, ...)
{
    char *line = NULL, *all = NULL;
    va_list args;
    va_start(args, format);
    int length = vasprintf(&line, format, args);
    va_end(args);
    if (length < 0)
        return;
    if (!summary->notes) {
        summary->notes = line;
    } else if (asprintf(&all, "%s\n%s", summary->notes, line) >= 0) {
        free(summary->notes);
        free(line);
        summary->notes = all;
    } else {
        free(line);
    }
}

void gather_free_repeats(struct surface_record *record)
{
    for (size_t p = 0; p < record->repeat_count; p++)
        spectrum_free(&record->repeats[p].spectrum);
    record->repeat_count = 0;
}

static void note_scan(struct surface_summary *summary, const struct scan *scan, const struct profile *profile,
                      const char *file)
{
    for (size_t w = 0; w < scan->warning_count; w++)
        gather_note(summary, "%s: %s", file, scan->warnings[w]);
    for (size_t n = 0; n < profile->note_count; n++)
        gather_note(summary, "%s: %s", file, profile->notes[n]);
}

/** The profile thinned for its chart: of every run of points the lowest and the highest, in their order. */
static void keep_preview(struct surface_record *record, const struct profile *profile)
{
    size_t runs = SURFACE_PREVIEW / 2, stride = (profile->points + runs - 1) / runs, n = 0;
    if (profile->points <= SURFACE_PREVIEW)
        stride = 1;
    for (size_t start = 0; start < profile->points; start += stride) {
        size_t low = start, high = start;
        for (size_t i = start; i < start + stride && i < profile->points; i++) {
            low = profile->height_m[i] < profile->height_m[low] ? i : low;
            high = profile->height_m[i] > profile->height_m[high] ? i : high;
        }
        size_t ends[2] = {low < high ? low : high, low < high ? high : low};
        for (int e = 0; e < (low == high ? 1 : 2) && n < SURFACE_PREVIEW; e++, n++) {
            record->preview_x_m[n] = (double)ends[e] * profile->spacing_m;
            record->preview_z_m[n] = profile->height_m[ends[e]];
        }
    }
    record->preview_points = n;
}

/** Keeps the scan for a run of its own; when there are too many, every second one goes. Takes the spectrum over. */
static void keep_repeat(struct surface_record *record, struct spectrum *spectrum, const struct roughness *roughness)
{
    record->repeat_stride = record->repeat_stride ? record->repeat_stride : 1;
    if (record->summary.scans % record->repeat_stride != 0) {
        spectrum_free(spectrum);
        return;
    }
    if (record->repeat_count == REPEATS_MOST) {
        record->repeat_count = 0;
        for (size_t p = 0; p < REPEATS_MOST; p++)
            if (p % 2 == 0)
                record->repeats[record->repeat_count++] = record->repeats[p];
            else
                spectrum_free(&record->repeats[p].spectrum);
        record->repeat_stride *= 2;
        if (record->summary.scans % record->repeat_stride != 0) {
            spectrum_free(spectrum);
            return;
        }
    }
    record->repeats[record->repeat_count++] = (struct repeat){*spectrum, *roughness};
}

/** Adds one profile to the surface: averages its spectrum and moments into the record's. */
static enum status_code add_profile(struct surface_record *record, const struct profile *profile,
                                    const struct scene *scene, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    struct spectrum spectrum;
    struct roughness roughness =
        profile->measured_x_m ? roughness_of_points(profile->measured_x_m, profile->measured_z_m, profile->points)
                              : roughness_of_heights(profile->height_m, profile->points, profile->spacing_m);
    double started = clock_seconds();
    if (spectrum_compute(&spectrum, profile->height_m, profile->points, profile->spacing_m, scene->window, status) !=
        STATUS_OK) {
        spectrum_free(&spectrum);
        return status->code;
    }
    if (scene->moments == ROUGHNESS_MOMENTS_SPECTRAL)
        roughness_from_spectrum(&roughness, &spectrum);
    summary->times.spectrum += clock_seconds() - started;
    double jumps =
        (double)summary->scans * summary->jump_m * summary->jump_m + profile->end_jump_m * profile->end_jump_m;
    summary->jump_m = sqrt(jumps / (double)(summary->scans + 1));
    enum status_code rc = STATUS_OK;
    if (summary->scans == 0) {
        rc = spectrum_copy(&record->spectrum, &spectrum, status);
        summary->roughness = roughness;
        summary->points = profile->points;
        summary->spacing_m = profile->spacing_m;
        summary->grid = profile->grid;
        summary->tilt = profile->tilt;
        keep_preview(record, profile);
    } else {
        rc = grid_average(&record->spectrum, &spectrum, summary->scans, status);
        roughness_average(&summary->roughness, &roughness, summary->scans);
    }
    keep_repeat(record, &spectrum, &roughness);
    summary->length_m = record->spectrum.length_m;
    summary->scans++;
    return rc;
}

/** Every row of a scan (a profile has one) into the surface. A row of a map that cannot be used (all missing, flat) is
 * left out and counted; the map is refused when none is left. */
static enum status_code add_rows(struct surface_record *record, const struct scan *scan, const struct scene *scene,
                                 const char *file, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    const struct profile_options how = {scene->level, scene->max_missing, scene->lambda_s_m, scene->lambda_c_m,
                                        scene->tip_radius_m};
    size_t unusable = 0;
    struct status first = {0};
    for (size_t row = 0; row < scan->ny; row++) {
        struct profile profile;
        struct status problem = {0};
        double started = clock_seconds();
        enum status_code rc = profile_make(&profile, scan, row, &how, &problem);
        summary->times.prepare += clock_seconds() - started;
        if (rc == STATUS_OK && row == unusable) /* the first usable one speaks for all */
            note_scan(summary, scan, &profile, file);
        if (rc == STATUS_OK)
            rc = add_profile(record, &profile, scene, &problem);
        profile_free(&profile);
        if (rc == STATUS_MEMORY)
            return status_memory(status);
        if (rc != STATUS_OK && unusable++ == 0)
            first = problem;
    }
    if (unusable == scan->ny)
        return status_fail(status, first.code, "%s: %s", file, first.message);
    if (scan->kind == SCAN_AREAL)
        gather_note(summary, "%s: a map; its %zu %s were averaged as profiles", file, scan->ny - unusable,
                    scene->direction == SCAN_DIRECTION_X ? "rows" : "columns");
    if (unusable > 0)
        gather_note(summary, "%s: %zu %s%s left out, the first because %s", file, unusable,
                    scene->direction == SCAN_DIRECTION_X ? "row" : "column", unusable == 1 ? "" : "s", first.message);
    return STATUS_OK;
}

enum status_code gather_file(struct surface_record *record, const struct scene *scene,
                             const struct scene_surface *surface, const char *file, struct hash *hash,
                             struct status *status)
{
    struct surface_summary *summary = &record->summary;
    struct text bytes = {0};
    struct scan scan = {0};
    char *path = scene_file_path(scene, file);
    if (!path)
        return status_memory(status);
    struct scan_options options = {.x_unit = surface->x_unit,
                                   .z_unit = surface->z_unit,
                                   .quantity = surface->quantity,
                                   .x_column = surface->x_column,
                                   .z_column = surface->z_column};

    double started = clock_seconds();
    enum status_code rc = text_read_file(&bytes, path, status);
    if (rc == STATUS_OK) {
        hash_add(hash, bytes.data, bytes.length);
        struct scan_bytes content = {bytes.data, bytes.length, file};
        rc = scan_read_beside(&scan, &content, path, &options, status);
    }
    text_free(&bytes);
    if (rc == STATUS_OK && scan.sidecar && (rc = text_read_file(&bytes, scan.sidecar, status)) == STATUS_OK) {
        hash_add(hash, bytes.data, bytes.length); /* what it says changes the numbers too */
        text_free(&bytes);
    }
    if (rc == STATUS_OK && scan.kind == SCAN_AREAL && scene->direction == SCAN_DIRECTION_Y)
        rc = scan_transpose(&scan, status);
    summary->times.read += clock_seconds() - started;
    if (rc == STATUS_OK) {
        snprintf(summary->format, sizeof summary->format, "%s", scan.format);
        snprintf(summary->units, sizeof summary->units, "x %s, z %s", scan.x_unit, scan.z_unit);
        rc = add_rows(record, &scan, scene, file, status);
    }
    scan_free(&scan);
    free(path);
    return rc;
}

/** Repeats, for a surface, what was noted about the scans of its counterface. */
static void note_counterface(struct surface_summary *summary, const struct surface_summary *counterface)
{
    const struct scene_surface *scene = counterface->scene;
    for (const char *line = counterface->notes; line && *line;) {
        size_t length = strcspn(line, "\n");
        for (size_t f = 0; f < scene->file_count; f++) {
            size_t name = strlen(scene->files[f]);
            if (length > name && strncmp(line, scene->files[f], name) == 0 && line[name] == ':') {
                gather_note(summary, "counterface %.*s", (int)length, line);
                break;
            }
        }
        line += length + (line[length] == '\n');
    }
}

enum status_code gather_counterface(struct surface_record *record, const struct surface_record *counterface,
                                    struct status *status)
{
    struct roughness *own = &record->summary.roughness;
    double own_rq_m = own->rq_m;
    roughness_add(own, &counterface->summary.roughness);
    gather_note(&record->summary, "pressed against a rough counterface: Rq %.4g um and %.4g um give %.4g um together",
                own_rq_m * 1e6, counterface->summary.roughness.rq_m * 1e6, own->rq_m * 1e6);
    note_counterface(&record->summary, &counterface->summary);
    for (size_t p = 0; p < record->repeat_count; p++) {
        roughness_add(&record->repeats[p].roughness, &counterface->summary.roughness);
        if (grid_add(&record->repeats[p].spectrum, &counterface->spectrum, status) != STATUS_OK)
            return status->code;
    }
    return grid_add(&record->spectrum, &counterface->spectrum, status);
}

/** Puts the parts on the mean's grid and lets them say how far they differ. A single scan has no parts. */
enum status_code gather_describe_repeats(struct surface_record *record, const struct scene *scene,
                                         struct status *status)
{
    const struct spectrum *mean = &record->spectrum;
    if (record->repeat_count < 2)
        gather_free_repeats(record);
    for (size_t p = 0; p < record->repeat_count; p++) {
        struct spectrum *own = &record->repeats[p].spectrum, same;
        if (own->count == mean->count && fabs(own->length_m / mean->length_m - 1) < 1e-6)
            continue;
        if (grid_spectrum(&same, own, mean->length_m, mean->count, status) != STATUS_OK)
            return status->code;
        spectrum_free(own);
        *own = same;
    }
    return repeats_laws(&record->summary.repeats, record->repeats, record->repeat_count, scene->fit_band_m, status);
}
