/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "members/surface_read.h"

#include "base/clock.h"
#include "spectrum/areal.h"
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void note_scan(struct surface_summary *summary, const struct scan *scan, size_t row,
                      const struct profile *profile, const char *file)
{
    const bool map = scan->kind == SCAN_AREAL;
    char one[512];
    snprintf(one, sizeof one, "%.480s, profile %zu", file, row + 1);
    for (size_t w = 0; w < scan->warning_count; w++)
        note_add(&summary->notes, file, "note.text\ntext\t%s", scan->warnings[w]);
    for (size_t n = 0; n < profile->note_count; n++)
        note_add(&summary->notes, map ? one : file, "note.text\ntext\t%s", profile->notes[n]);
}

/** Thins the profile for its chart: the lowest and the highest point of every few, in order. */
static enum status_code keep_preview(struct surface_record *record, const struct profile *profile,
                                     struct status *status)
{
    size_t runs = SURFACE_PREVIEW / 2, stride = (profile->points + runs - 1) / runs, n = 0;
    if (profile->points <= SURFACE_PREVIEW)
        stride = 1;
    size_t room = profile->points < SURFACE_PREVIEW ? profile->points : SURFACE_PREVIEW;
    record->preview_x_m = malloc(room * sizeof *record->preview_x_m);
    record->preview_z_m = malloc(room * sizeof *record->preview_z_m);
    if (!record->preview_x_m || !record->preview_z_m)
        return status_memory(status);
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
    return STATUS_OK;
}

enum { DIRECT_HEIGHTS = 65536, DIRECT_SIDE = 400 }; /* kept for the direct study: heights; points a side of a map */

/** Keeps heights for the direct study: of profiles, thinned evenly, or the first square of a map. */
static enum status_code keep_direct(struct surface_record *record, const struct scan *scan,
                                    const struct profile *profile, struct status *status)
{
    size_t side = record->summary.map.nx, room = DIRECT_HEIGHTS - record->direct_count;
    size_t step = profile ? (profile->points + DIRECT_HEIGHTS - 1) / DIRECT_HEIGHTS : 1;
    size_t more = profile ? profile->points / step : side * side;
    if (profile && more > room)
        more = room;
    double *all = reallocarray(record->direct_m, record->direct_count + more + 1, sizeof *all);
    if (!all)
        return status_memory(status);
    record->direct_m = all;
    for (size_t k = 0; k < more; k++)
        all[record->direct_count++] = profile ? profile->height_m[k * step] : scan->z_m[k / side * scan->nx + k % side];
    return STATUS_OK;
}

/** Are heights kept for the direct study? Only those of the first map, also for a mere plan, which says whether it can
 * be solved; none of two rough bodies. */
static bool keeps_direct(const struct surface_record *record, const struct scene *scene)
{
    const bool planned = record->summary.map.nx > 0 && record->variants.left_out;
    return (scene->direct.called || planned) && scene->counterface_surface.files.count == 0 &&
           (record->summary.map.nx == 0 || record->direct_count == 0);
}

/** Finds a profile's spectrum and moments, as the scene asks. */
static enum status_code take_spectrum(struct spectrum *spectrum, struct roughness *roughness,
                                      const struct profile *profile, const struct scene *scene, struct status *status)
{
    *roughness = profile->measured_x_m
                     ? roughness_of_points(profile->measured_x_m, profile->measured_z_m, profile->points)
                     : roughness_of_heights(profile->height_m, profile->points, profile->spacing_m);
    if (spectrum_compute(spectrum, profile->height_m, profile->points, profile->spacing_m,
                         spectrum_window_for(scene->window, profile->periodic), status) != STATUS_OK)
        return status->code;
    if (scene->moments == ROUGHNESS_MOMENTS_SPECTRAL)
        roughness_from_spectrum(roughness, spectrum);
    return STATUS_OK;
}

/** Averages a profile's spectrum and moments into the surface's, as powers; for the thesis's line as logarithms too,
 * which do not depend on the number of scans. Of points the most count, of spacings the coarsest. */
static enum status_code average(struct surface_record *record, const struct profile *profile,
                                const struct spectrum *spectrum, const struct roughness *roughness,
                                struct status *status)
{
    struct surface_summary *summary = &record->summary;
    summary->points = profile->points > summary->points ? profile->points : summary->points;
    summary->spacing_m = fmax(profile->spacing_m, summary->spacing_m);
    summary->periodic += profile->periodic;
    roughness_average(&summary->roughness, roughness, summary->scans);
    if (grid_average(&record->spectrum, spectrum, summary->scans, status) != STATUS_OK ||
        grid_average_logs(&record->typical, spectrum, summary->scans, status) != STATUS_OK)
        return status->code;
    return summary->scans++ > 0 ? STATUS_OK : keep_preview(record, profile, status);
}

/** Hash (FNV-1a) of where heights rise, from the first to the last or (`back`) the other way. */
static uint64_t hash_rises(const double *height_m, size_t points, bool back)
{
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (size_t i = 1; i < points; i++) {
        const double *at = &height_m[back ? points - 1 - i : i];
        hash = (hash ^ (uint64_t)(*at > at[back ? 1 : -1])) * UINT64_C(0x100000001b3);
    }
    return hash;
}

/** A seed from a row as measured, which neither the file's name nor conditioning changes, nor other units or another
 * direction of travel: the same scan has the same surrogates. */
static uint64_t seed_of(const struct scan *scan, size_t row)
{
    const double *height_m = &scan->z_m[row * scan->nx];
    return hash_rises(height_m, scan->nx, false) + hash_rises(height_m, scan->nx, true);
}

/** Adds one profile, a row of a scan, to the mean, to the spectra for the law, to the variants, and as a member.
 * lambda_s_m: of the low-pass it had. */
static enum status_code add_profile(const struct surface_scans *task, double lambda_s_m, const struct scan *scan,
                                    size_t row, uint64_t seed, struct profile *profile, struct status *status)
{
    struct surface_record *record = task->record;
    const struct scene *scene = task->scene;
    struct member own = {
        .points = profile->points, .spacing_m = profile->spacing_m, .periodic = profile->periodic, .seed = seed};
    double started = clock_seconds();
    enum status_code rc = take_spectrum(&own.spectrum, &own.roughness, profile, scene, status);
    if (rc == STATUS_OK)
        task->scans->step_m = fmax(task->scans->step_m, profile->digit_m);
    if (rc == STATUS_OK && (scene->fit == POWER_LAW_AUTO ||
                            scan->kind == SCAN_AREAL)) /* for a map it tells how many rows are independent */
        rc = power_law_scans_add(task->scans, profile->height_m, profile->points, profile->spacing_m, profile->digit_m,
                                 status);
    if (rc == STATUS_OK && scene->counterface_surface.files.count == 0 && !record->variants.left_out)
        rc = variants_add(&record->variants, profile, lambda_s_m, scene, status);
    if (rc == STATUS_OK && scan->kind == SCAN_PROFILE && keeps_direct(record, scene))
        rc = keep_direct(record, scan, profile, status);
    if (rc == STATUS_OK)
        rc = average(record, profile, &own.spectrum, &own.roughness, status);
    record->summary.windowed += spectrum_window_for(scene->window, profile->periodic) == SPECTRUM_WINDOW_HANN;
    record->summary.length_m = record->spectrum.length_m;
    record->summary.times.spectrum += clock_seconds() - started;
    if (rc == STATUS_OK)
        return repeats_add(&record->ensemble, row, scan->ny, profile, &own, status);
    spectrum_free(&own.spectrum);
    return rc;
}

/** Levels and low-passes a map, for its rows and its direct solution alike. */
static enum status_code condition_map(struct areal_parameters of[2], struct direct_map_def *map, struct scan *scan,
                                      const struct scene *scene, struct status *status)
{
    struct status none = {0}; /* a map without a plane has no parameters, and no usable row */
    size_t side = scan->nx < scan->ny ? scan->nx : scan->ny;
    *map = (struct direct_map_def){.nx = scan->nx,
                                   .ny = scan->ny,
                                   .dx_m = scan->dx_m,
                                   .dy_m = scan->dy_m,
                                   .cutoff = scene->lambda_s_m / scan->dx_m};
    (void)!areal_parameters_of(&of[0], scan, &none);
    if (direct_map_condition(scan->z_m, map, scene->lambda_s_given && !(scene->lambda_s_m > 0), status) != STATUS_OK)
        return status->code;
    of[1] = of[0];
    if (map->cutoff > 0)
        (void)!areal_parameters_of(&of[1], scan, &none);
    side = side < DIRECT_SIDE ? side : DIRECT_SIDE;
    map->periodic = map->periodic && map->nx == side && map->ny == side;
    map->nx = map->ny = side;
    return STATUS_OK;
}

/** Mean-square difference of a map's heights at this distance in points, less that of its plane. */
static double mean_square_step(const struct scan *scan, size_t right, size_t down)
{
    double sum = 0, squares = 0, count = 0;
    for (size_t row = down; row < scan->ny; row++)
        for (size_t column = right; column < scan->nx; column++) {
            double step = scan->z_m[row * scan->nx + column] - scan->z_m[(row - down) * scan->nx + column - right];
            if (isnan(step))
                continue;
            sum += step;
            squares += step * step;
            count++;
        }
    return squares / count - sum / count * (sum / count);
}

/** Finds the lay of a map from its rows (across) and columns, over steps of about the same length. */
static void measure_lay(struct surface_summary *summary, const struct scan *scan)
{
    double right = fmax(1, round(scan->dy_m / scan->dx_m)), down = fmax(1, round(scan->dx_m / scan->dy_m));
    if (right < (double)scan->nx && down < (double)scan->ny)
        surface_set_lay(summary,
                        sqrt(mean_square_step(scan, 0, (size_t)down) / mean_square_step(scan, (size_t)right, 0)) *
                            (right * scan->dx_m) / (down * scan->dy_m),
                        "map");
}

/** Makes the profile of a row. */
static enum status_code take_row(struct profile *out, struct scan *scan, size_t row, const struct profile_options *how,
                                 struct status *status)
{
    enum status_code rc = profile_make(out, scan, row, how, status);
    if (scan->kind == SCAN_PROFILE)
        scan_free_points(scan);
    if (rc != STATUS_OK || out->points >= PROFILE_SPECTRUM_POINTS)
        return rc;
    return status_fail(status, STATUS_SCAN,
                       "%zu points carry no spectrum; at least %d are needed: take a longer scan, or leave it out",
                       out->points, PROFILE_SPECTRUM_POINTS);
}

/** Notes on a map whose rows are read, `unusable` of them left out, `run` of them members. */
static void note_map(const struct surface_scans *task, const char *file, const struct scan *scan,
                     const struct direct_map_def *map, const struct areal_parameters of[2], size_t unusable, size_t run)
{
    size_t used = scan->ny - unusable;
    struct note_list *notes = &task->record->summary.notes;
    note_add(notes, file, "note.map\nused %zu\n%s\n%s %zu", used,
             task->scene->direction == SCAN_DIRECTION_X ? "" : "columns", run < used ? "run" : "all", run);
    if (map->cutoff > 0)
        note_add(notes, file, "note.cut\ncut %.3g\n%s\nsq %.3g\nsq_left %.3g\nslope %.2g\nslope_left %.2g",
                 map->cutoff * map->dx_m * 1e6,
                 task->scene->lambda_s_m > 0 ? ""
                 : map->noisy                ? "noisy"
                                             : "untold",
                 of[0].sq_m * 1e6, of[1].sq_m * 1e6, of[0].sdq, of[1].sdq);
}

/** The first map of a surface gives its lay and the square for the direct study. */
static enum status_code keep_map(const struct surface_scans *task, const struct scan *scan,
                                 const struct direct_map_def *map, struct status *status)
{
    struct surface_record *record = task->record;
    measure_lay(&record->summary, scan);
    if (task->scene->counterface_surface.files.count > 0)
        return STATUS_OK;
    record->summary.map = *map;
    return keeps_direct(record, task->scene) ? keep_direct(record, scan, NULL, status) : STATUS_OK;
}

/** Averages the excess of Sq² of the last file over its rows' mean square height (NaN: none) over the files. */
static void add_between(struct surface_summary *summary, size_t scans_before, double rq_before_m, double sq_m2)
{
    double before = (double)scans_before, all = (double)summary->scans, rq_m = summary->roughness.rq_m;
    double rows_m2 = (all * rq_m * rq_m - before * rq_before_m * rq_before_m) / (all - before);
    double excess_m2 = isnan(sq_m2) ? 0 : fmax(0, sq_m2 - rows_m2);
    summary->between_m2 += (excess_m2 - summary->between_m2) * (all - before) / all;
}

enum status_code surface_rows_add(const struct surface_scans *task, struct scan *scan, const char *name,
                                  struct status *status)
{
    struct surface_summary *summary = &task->record->summary;
    struct ensemble *set = &task->record->ensemble;
    const struct scene *scene = task->scene;
    struct profile_options how = {.level = scene->level,
                                  .max_missing = scene->max_missing,
                                  .lambda_s_m = scene->lambda_s_m,
                                  .lambda_c_m = scene->lambda_c_m,
                                  .tip_radius_m = scene->tip_radius_m,
                                  .periodic_mean = !scene->level_given};
    struct direct_map_def map = {0};
    size_t unusable = 0, run_before = set->count;
    bool areal = scan->kind == SCAN_AREAL, first_file = summary->scans == 0;
    const size_t scans_before = summary->scans;
    const double rq_before_m = summary->roughness.rq_m;
    double sq_m2 = NAN;
    struct areal_parameters of[2] = {{0}}; /* a map, as measured and after the low-pass */
    struct status first = {0};
    const double side_m = fmin((double)scan->nx * scan->dx_m, (double)scan->ny * scan->dy_m);
    if (areal && scene->lambda_s_m > side_m * (1 + 1e-9))
        return status_fail(status, STATUS_SCAN,
                           "%s: lambda_s is %.6g m, longer than a side of the map of %.6g m; give a shorter one", name,
                           scene->lambda_s_m, side_m);
    if ((areal && condition_map(of, &map, scan, scene, status) != STATUS_OK) ||
        repeats_add_scan(set, status) != STATUS_OK)
        return status->code;
    const double cutoff_m = fmax(summary->cutoff_m, map.cutoff * map.dx_m);
    how.lambda_s_m = areal ? 0 : scene->lambda_s_m; /* a map was filtered in both directions */
    for (size_t row = 0; row < scan->ny; row++) {
        struct profile profile;
        struct status problem = {0};
        const uint64_t seed = seed_of(scan, row);
        double started = clock_seconds();
        enum status_code rc = take_row(&profile, scan, row, &how, &problem);
        summary->times.prepare += clock_seconds() - started;
        if (rc == STATUS_OK)
            rc = add_profile(task, fmax(scene->lambda_s_m, cutoff_m), scan, row, seed, &profile, &problem);
        if (rc == STATUS_OK && row == unusable) /* of a map those of the first usable row */
            note_scan(summary, scan, row, &profile, name);
        profile_free(&profile);
        if (rc == STATUS_MEMORY)
            return status_memory(status);
        if (rc != STATUS_OK && unusable++ == 0)
            first = problem;
    }
    if (unusable == scan->ny) {
        set->scan_count--;
        return status_fail(status, first.code, "%s: %s", name, first.message);
    }
    summary->cutoff_m = cutoff_m;
    if (areal) {
        summary->measured = summary->has_map ? summary->measured : of[0];
        summary->has_map = true;
        if (scene->level == LEVEL_LINE && !(scene->lambda_c_m > 0)) /* else more than a plane is removed from rows */
            sq_m2 = of[1].sq_m * of[1].sq_m;
    }
    add_between(summary, scans_before, rq_before_m, sq_m2);
    if (areal && first_file && keep_map(task, scan, &map, status) != STATUS_OK)
        return status->code;
    if (areal)
        note_map(task, name, scan, &map, of, unusable, set->count - run_before);
    tiles_free(&task->record->tiles); /* a surface of several scans is not a single map */
    if (areal && first_file && (scene->models & model_flagged(offsetof(struct model_row, uses_map))))
        tiles_take(&task->record->tiles, scan, &map);
    if (unusable > 0)
        note_add(&summary->notes, name, "note.left_out\ncount %zu\n%s\n%s\nwhy\t%s", unusable,
                 unusable == 1 ? "one" : "", scene->direction == SCAN_DIRECTION_X ? "" : "columns", first.message);
    power_law_scans_end_file(task->scans, scan->ny - unusable, areal);
    return STATUS_OK;
}
