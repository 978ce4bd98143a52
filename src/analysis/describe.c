/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/describe.h"

#include "base/clock.h"
#include "spectrum/areal.h"
#include "spectrum/grid.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void note_scan(struct surface_summary *summary, const struct scan *scan, const struct profile *profile,
                      const char *file)
{
    for (size_t w = 0; w < scan->warning_count; w++)
        note_add(&summary->notes, file, scan->warnings[w]);
    for (size_t n = 0; n < profile->note_count; n++)
        note_add(&summary->notes, file, profile->notes[n]);
}

/** The profile thinned for its chart: of every run of points the lowest and the highest, in their order. */
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

enum { DIRECT_HEIGHTS = 65536, DIRECT_SIDE = 400 }; /* kept for the direct solution: heights, and points along a map */

/** Keeps what a direct solution is made from: heights of a profile, thinned evenly, or the first square of a map. */
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

/** One profile of a surface and what is made of it. */
struct making {
    struct surface_record *record;
    const struct scan *scan;
    const struct profile *profile;
    const struct profile_options *how;
    const struct scene *scene;
    struct power_law_scans *scans;
    enum spectrum_window window;
    struct spectrum spectrum;
    struct roughness roughness;
    double spectrum_seconds, law_seconds;
};

static enum status_code make_law(struct making *making, struct status *status)
{
    const struct profile *profile = making->profile;
    double started = clock_seconds();
    making->scans->step_m = fmax(making->scans->step_m, profile->digit_m);
    /* of a map also to know how many independent rows it has */
    if (making->scene->fit != POWER_LAW_AUTO && making->scan->kind != SCAN_AREAL)
        return STATUS_OK;
    enum status_code rc = power_law_scans_add(making->scans, profile->height_m, profile->points, profile->spacing_m,
                                              profile->digit_m, status);
    making->law_seconds = clock_seconds() - started;
    return rc;
}

static enum status_code make_spectrum(struct making *making, struct status *status)
{
    const struct profile *profile = making->profile;
    double started = clock_seconds();
    making->roughness = profile->measured_x_m
                            ? roughness_of_points(profile->measured_x_m, profile->measured_z_m, profile->points)
                            : roughness_of_heights(profile->height_m, profile->points, profile->spacing_m);
    enum status_code rc = spectrum_compute(&making->spectrum, profile->height_m, profile->points, profile->spacing_m,
                                           making->window, status);
    if (rc == STATUS_OK && making->scene->moments == ROUGHNESS_MOMENTS_SPECTRAL)
        roughness_from_spectrum(&making->roughness, &making->spectrum);
    making->spectrum_seconds = clock_seconds() - started;
    return rc;
}

static enum status_code make_variant(struct making *making, enum sensitivity_variant variant, struct status *status)
{
    const struct scene *scene = making->scene;
    if (scene->counterface_surface.file_count > 0)
        return STATUS_OK;
    return sensitivity_add(&making->record->sensitivity, variant, making->profile, making->how, scene->window,
                           scene->moments, status);
}

/** All that is made of a profile. */
static enum status_code make_all(struct making *making, struct status *status)
{
    if (make_law(making, status) != STATUS_OK || make_spectrum(making, status) != STATUS_OK)
        return status->code;
    for (int variant = 0; variant < SENSITIVITY_VARIANTS; variant++)
        if (make_variant(making, (enum sensitivity_variant)variant, status) != STATUS_OK)
            return status->code;
    return STATUS_OK;
}

/** Adds one profile to the surface: averages its spectrum and moments into the record's. Takes over the spectrum and
 * what a part of its own keeps of the profile. */
static enum status_code add_profile(struct making *making, struct profile *profile, size_t row, struct status *status)
{
    struct surface_record *record = making->record;
    struct surface_summary *summary = &record->summary;
    struct spectrum spectrum = making->spectrum;
    struct roughness roughness = making->roughness;
    summary->periodic += profile->periodic;
    summary->windowed += making->window == SPECTRUM_WINDOW_HANN;
    summary->times.spectrum += making->spectrum_seconds + making->law_seconds;
    if (making->scene->counterface_surface.file_count == 0)
        sensitivity_end(&record->sensitivity, profile);
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
        if (rc == STATUS_OK)
            rc = keep_preview(record, profile, status);
    } else {
        rc = grid_average(&record->spectrum, &spectrum, summary->scans, status);
        roughness_average(&summary->roughness, &roughness, summary->scans);
    }
    if (rc == STATUS_OK)
        rc = repeats_add(&record->ensemble, row, making->scan->ny, profile, &spectrum, &roughness, status);
    else
        spectrum_free(&spectrum);
    summary->length_m = record->spectrum.length_m;
    summary->scans++;
    return rc;
}

/** Is a direct solution called for, and the surface its own? A map is alone; two rough bodies have no heights in
 * common.
 */
static bool keeps_direct(const struct surface_record *record, const struct scene *scene)
{
    return scene->direct.called && scene->counterface_surface.file_count == 0 &&
           (record->summary.map.nx == 0 || record->direct_count == 0);
}

/** How the scene wants scans to be made ready. */
static struct profile_options profile_options_of(const struct scene *scene)
{
    return (struct profile_options){.level = scene->level,
                                    .max_missing = scene->max_missing,
                                    .lambda_s_m = scene->lambda_s_m,
                                    .lambda_c_m = scene->lambda_c_m,
                                    .tip_radius_m = scene->tip_radius_m,
                                    .periodic_mean = !scene->level_given};
}

/* The first harmonic whose estimate by five sine tapers keeps off the ends of the spectrum is the fifth
 * (docs/equations.md, power_law_band.h); a record has it below its Nyquist frequency from 11 points on. */
enum { LEAST_POINTS = 11 };

static void note_rows_left_out(struct surface_summary *summary, const char *file, size_t count, const char *kind,
                               const struct status *first)
{
    struct text line = {0};
    text_add(&line, "%zu %s%s left out, the first because %s", count, kind, count == 1 ? "" : "s", first->message);
    note_add(&summary->notes, file, text_string(&line));
    text_free(&line);
}

/** Takes out of a map what neither a row nor a direct solution can hold: both are of the heights that are left. */
static enum status_code condition_map(struct surface_record *record, struct direct_map_def *map, struct scan *scan,
                                      struct status *status)
{
    size_t side = scan->nx < scan->ny ? scan->nx : scan->ny;
    *map = (struct direct_map_def){.nx = scan->nx, .ny = scan->ny, .dx_m = scan->dx_m, .dy_m = scan->dy_m};
    if (direct_map_condition(scan->z_m, map, status) != STATUS_OK)
        return status->code;
    record->summary.cutoff_m = fmax(record->summary.cutoff_m, map->cutoff * map->dx_m);
    side = side < DIRECT_SIDE ? side : DIRECT_SIDE;
    map->periodic = map->periodic && map->nx == side && map->ny == side;
    map->nx = map->ny = side;
    return STATUS_OK;
}

/** Mean-square difference of a map's heights that lie so many points apart, less that of its plane. */
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

/** r of the surface; what makes it doubtful is said. */
static void set_lay(struct surface_summary *summary, double lay, const char *instead)
{
    summary->has_lay = isfinite(lay);
    summary->lay = lay;
    if (summary->has_lay && lay > 1.5)
        surface_note(summary, "it is %.3g times as steep along as across its lay; %s", lay, instead);
}

/** A map knows its lay from its rows, taken across, and its columns, over steps of about the same length. */
static void measure_lay(struct surface_summary *summary, const struct scan *scan)
{
    double right = fmax(1, round(scan->dy_m / scan->dx_m)), down = fmax(1, round(scan->dx_m / scan->dy_m));
    if (right < (double)scan->nx && down < (double)scan->ny)
        set_lay(summary,
                sqrt(mean_square_step(scan, 0, (size_t)down) / mean_square_step(scan, (size_t)right, 0)) *
                    (right * scan->dx_m) / (down * scan->dy_m),
                "take its profiles in the other direction");
}

/** Every row of a scan (a profile has one, whose heights are taken over) into the surface. A row of a map that cannot
 * be used (all missing, flat) is left out and counted; the map is refused when none is left. */
static enum status_code add_rows(struct surface_record *record, struct power_law_scans *scans, struct scan *scan,
                                 const struct scene *scene, const char *scene_file, struct status *status)
{
    char file[512];
    struct surface_summary *summary = &record->summary;
    const struct profile_options how = profile_options_of(scene);
    struct direct_map_def map = {0};
    size_t unusable = 0, run_before = record->ensemble.count;
    struct status first = {0};
    if (repeats_add_scan(&record->ensemble, scene_file, status) != STATUS_OK)
        return status->code;
    if (scan->kind == SCAN_AREAL && condition_map(record, &map, scan, status) != STATUS_OK)
        return status->code;
    struct profile_options had = how; /* what its heights have been through */
    had.lambda_s_m = surface_lambda_s(summary, scene);
    snprintf(file, sizeof file, *scan->part ? "%.400s(%s)" : "%.400s%s", scene_file, scan->part);
    for (size_t row = 0; row < scan->ny; row++) {
        struct profile profile;
        struct status problem = {0};
        double started = clock_seconds();
        enum status_code rc = scan->kind == SCAN_PROFILE ? profile_take(&profile, scan, &how, &problem)
                                                         : profile_make(&profile, scan, row, &how, &problem);
        summary->times.prepare += clock_seconds() - started;
        if (rc == STATUS_OK && profile.points < LEAST_POINTS)
            rc =
                status_fail(&problem, STATUS_SCAN,
                            "%zu points carry no spectrum; at least %d are needed: take a longer scan, or leave it out",
                            profile.points, LEAST_POINTS);
        if (rc == STATUS_OK && row == unusable) /* the first usable one speaks for all */
            note_scan(summary, scan, &profile, file);
        struct making making = {.record = record,
                                .scan = scan,
                                .profile = &profile,
                                .how = &had,
                                .scene = scene,
                                .scans = scans,
                                .window = spectrum_window_for(scene->window, rc == STATUS_OK && profile.periodic)};
        if (rc == STATUS_OK)
            rc = make_all(&making, &problem);
        if (rc == STATUS_OK && scan->kind == SCAN_PROFILE && keeps_direct(record, scene))
            rc = keep_direct(record, scan, &profile, &problem);
        if (rc == STATUS_OK)
            rc = add_profile(&making, &profile, row, &problem);
        else
            spectrum_free(&making.spectrum);
        profile_free(&profile);
        if (rc == STATUS_MEMORY)
            return status_memory(status);
        if (rc != STATUS_OK && unusable++ == 0)
            first = problem;
    }
    if (unusable == scan->ny)
        return status_fail(status, first.code, "%s: %s", file, first.message);
    if (scan->kind == SCAN_AREAL && summary->scans == scan->ny - unusable)
        measure_lay(summary, scan);
    if (scan->kind == SCAN_AREAL && summary->scans == scan->ny - unusable &&
        scene->counterface_surface.file_count == 0) { /* the first file: it speaks for all */
        summary->map = map;
        if (keeps_direct(record, scene) && keep_direct(record, scan, NULL, status) != STATUS_OK)
            return status->code;
    }
    size_t run = record->ensemble.count - run_before, used = scan->ny - unusable;
    const char *rows = scene->direction == SCAN_DIRECTION_X ? "rows" : "columns";
    char note[300], models[100] = "", filtered[100] = "";
    if (run < used)
        snprintf(models, sizeof models, ", and %zu of them, evenly spaced, go through the models", run);
    if (map.cutoff > 0)
        snprintf(filtered, sizeof filtered, ", low-passed at %.3g um as more than 2 %% of its slopes are shorter",
                 map.cutoff * map.dx_m * 1e6);
    snprintf(note, sizeof note, "a map%s; its %zu %s were averaged as profiles for spectrum and fit%s", filtered, used,
             rows, models);
    if (scan->kind == SCAN_AREAL)
        note_add(&summary->notes, file, note);
    if (unusable > 0)
        note_rows_left_out(summary, file, unusable, scene->direction == SCAN_DIRECTION_X ? "row" : "column", &first);
    return power_law_scans_end_file(scans, scan->ny - unusable, scan->kind == SCAN_AREAL, status);
}

/** Does a model that may run use strips, or unloading? */
static bool wants_strips(const struct scene *scene)
{
    if (scene->effects & EFFECT_BIT(EFFECT_UNLOADING))
        return true;
    for (size_t m = 0; m < model_count; m++)
        if ((scene->models & MODEL_BIT(m)) && model_rows[m]->uses_strip)
            return true;
    return false;
}

/** A file as it was read, and what is made of it. */
struct file_task {
    struct surface_record *record;
    struct power_law_scans *scans;
    const struct scene *scene;
    const struct scene_surface *surface;
    const char *file, *path;
    const struct text *bytes;
    char *sidecar; /* a file whose text belongs to it; owned, NULL: none */
    size_t added;  /* scans of it */
};

/** Notes a scan that its surface goes on without. */
static void note_refused_scan(struct surface_summary *summary, const char *why, const char *others)
{
    struct text line = {0};
    text_add(&line, "%s%s", why, others);
    note_add_refused(&summary->notes, text_string(&line));
    summary->refused_scans++;
    text_free(&line);
}

/** Reads the scan at options->entry out of the bytes, and adds it. */
static enum status_code add_scan_at(struct file_task *task, struct scan_options *options, struct scan *scan,
                                    struct status *status)
{
    struct surface_summary *summary = &task->record->summary;
    struct scan_bytes content = {task->bytes->data, task->bytes->length, task->file};
    double started = clock_seconds();
    enum status_code rc = scan_read_beside(scan, &content, task->path, options, status);
    if (rc == STATUS_OK && scan->sidecar && options->entry == 0 && !(task->sidecar = strdup(scan->sidecar)))
        rc = status_memory(status);
    if (rc == STATUS_OK && scan->kind == SCAN_AREAL && task->scene->direction == SCAN_DIRECTION_Y)
        rc = scan_transpose(scan, status);
    summary->times.read += clock_seconds() - started;
    if (rc != STATUS_OK)
        return rc;
    snprintf(summary->format, sizeof summary->format, "%s", scan->format);
    snprintf(summary->units, sizeof summary->units, "x %s, z %s", scan->x_unit, scan->z_unit);
    task->added++;
    return add_rows(task->record, task->scans, scan, task->scene, task->file, status);
}

/** Adds the scans of the file, of which an archive may hold several: one that cannot be read costs itself alone. */
static enum status_code add_scans(struct file_task *task, struct status *status)
{
    const struct scene_surface *surface = task->surface;
    struct scan_options options = {.x_unit = surface->x_unit,
                                   .z_unit = surface->z_unit,
                                   .quantity = surface->quantity,
                                   .x_column = surface->x_column,
                                   .z_column = surface->z_column};
    struct status refused = {0};
    for (bool more = true; more;) {
        struct scan scan = {0};
        struct status problem = {0};
        size_t before = task->added;
        enum status_code rc = add_scan_at(task, &options, &scan, &problem);
        bool unread = rc == STATUS_SCAN && task->added == before, of_several = scan.next_entry > 0 || options.entry > 0;
        options.entry = scan.next_entry;
        more = options.entry > 0;
        scan_free(&scan);
        if (rc == STATUS_OK)
            continue;
        if (!unread || !of_several)
            return status_fail(status, rc, "%s", problem.message);
        if (refused.code == STATUS_OK)
            refused = problem;
        note_refused_scan(&task->record->summary, problem.message, " - refused; the others of the archive are used");
    }
    return task->added > 0 ? STATUS_OK : status_fail(status, refused.code, "%s", refused.message);
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

enum status_code describe_file(struct surface_record *record, struct power_law_scans *scans, const struct scene *scene,
                               const struct scene_surface *surface, const char *file, struct hash *hash,
                               struct status *status)
{
    struct text bytes = {0};
    char *path = scene_file_path(scene, file);
    if (!path)
        return status_memory(status);
    struct file_task task = {record, scans, scene, surface, file, path, &bytes, NULL, 0};
    double started = clock_seconds();
    record->ensemble.keeps_heights = wants_strips(scene);
    enum status_code rc = text_read_file(&bytes, path, status);
    record->summary.times.read += clock_seconds() - started;
    if (rc == STATUS_OK) {
        hash_add(hash, bytes.data, bytes.length); /* of a file that is refused, too */
        rc = add_scans(&task, status);
    }
    struct status problem = {0}; /* what a sidecar says changes the numbers too */
    if (task.sidecar && hash_file(hash, task.sidecar, &problem) != STATUS_OK && rc == STATUS_OK)
        rc = status_fail(status, problem.code, "%s", problem.message);
    free(task.sidecar);
    text_free(&bytes);
    free(path);
    return rc;
}

/** Repeats, for a surface, what was noted about the scans of its counterface. */
static void note_counterface(struct surface_summary *summary, const struct surface_summary *counterface)
{
    for (size_t i = 0; i < counterface->notes.count; i++) {
        const struct note *note = &counterface->notes.notes[i];
        struct text line = {0};
        note_line(&line, note);
        if (note->subject || note->refused_scan)
            surface_note(summary, "counterface %s", text_string(&line));
        text_free(&line);
    }
}

enum status_code describe_counterface(struct surface_record *record, struct power_law_scans *scans,
                                      const struct surface_record *counterface, struct status *status)
{
    struct roughness *own = &record->summary.roughness;
    double own_rq_m = own->rq_m;
    roughness_add(own, &counterface->summary.roughness);
    surface_note(&record->summary, "pressed against a rough counterface: Rq %.4g um and %.4g um give %.4g um together",
                 own_rq_m * 1e6, counterface->summary.roughness.rq_m * 1e6, own->rq_m * 1e6);
    note_counterface(&record->summary, &counterface->summary);
    struct ensemble *set = &record->ensemble;
    set->no_intervals = true;
    for (size_t p = 0; p < set->count; p++) {
        roughness_add(&set->members[p].roughness, &counterface->summary.roughness);
        if (grid_add(&set->members[p].spectrum, &counterface->spectrum, status) != STATUS_OK)
            return status->code;
    }
    if (set->count > 0)
        surface_note(&record->summary, "no intervals: how far the rough counterface's own scans scatter is not told by "
                                       "those of the surface");
    for (size_t i = 0; i < scans->scan_count && counterface->tapered.count > 0; i++)
        if (grid_add(&scans->scan[i], &counterface->tapered, status) != STATUS_OK)
            return status->code;
    if (scans->scan_count > 0 && counterface->tapered.count > 0 &&
        grid_add(&scans->mean, &counterface->tapered, status) != STATUS_OK)
        return status->code;
    return grid_add(&record->spectrum, &counterface->spectrum, status);
}

enum status_code describe_repeats(struct surface_record *record, const struct scene *scene, struct status *status)
{
    struct ensemble *set = &record->ensemble;
    set->sigma_m = sqrt(record->summary.roughness.m0_m2);
    if (set->count == 0)
        return STATUS_OK;
    struct repeats *repeats = surface_repeats_room(&record->summary);
    if (!repeats)
        return status_memory(status);
    if (repeats_align(set, &record->spectrum, status) != STATUS_OK)
        return status->code;
    return repeats_laws(repeats, set, scene->fit == POWER_LAW_THESIS ? &record->summary.power_law : NULL, status);
}

/** One scan: the surface itself, of which others may be simulated. */
static enum status_code keep_single(struct surface_record *record, const struct power_law_scans *scans,
                                    const struct scene *scene, struct status *status)
{
    struct member *part = &record->ensemble.members[0];
    const struct spectrum *tapered = scans->scan_count == 1 ? &scans->scan[0] : NULL;
    bool listed = scene->effects & EFFECT_BIT(EFFECT_UNCERTAINTY), simulable = false;
    if (part->height_m && scene->counterface_surface.file_count == 0 && (scene->effects_auto || listed)) {
        bool wanted = listed || uncertainty_affordable(part->points, scene->surface_count);
        simulable = true;
        if (wanted && uncertainty_possible(&simulable, part->height_m, part->points, tapered, status) != STATUS_OK)
            return status->code;
        record->summary.single_points = simulable ? part->points : 0;
        record->summary.simulates = simulable && wanted;
        if (record->summary.simulates) {
            record->height_m = part->height_m;
            part->height_m = NULL;
        }
    }
    ensemble_free(&record->ensemble);
    return STATUS_OK;
}

/** Scans of unlike lengths are cut to subrecords of the shortest one's. */
static enum status_code cut_to_shortest(struct surface_record *record, const struct scene *scene, struct status *status)
{
    const char *odd;
    size_t cut;
    if (repeats_cut_to_shortest(&record->ensemble, &cut, &odd, scene, status) != STATUS_OK)
        return status->code;
    if (odd)
        surface_note(&record->summary,
                     "%s is less than half as long as the others, which are all cut to its length; leave it out", odd);
    if (cut == 0)
        return STATUS_OK;
    struct repeats *repeats = surface_repeats_room(&record->summary);
    if (!repeats)
        return status_memory(status);
    repeats->cut = cut;
    return STATUS_OK;
}

enum status_code describe_conclude(struct surface_record *record, struct power_law_scans *scans,
                                   const struct scene *scene, struct status *status)
{
    struct ensemble *set = &record->ensemble;
    size_t all = set->count;
    bool profiles = true;
    for (size_t p = 0; p < all; p++)
        profiles = profiles && !set->members[p].is_row;
    if (all == 0) /* a map of which other rows were chosen than can be used */
        return STATUS_OK;
    if (all > 1 && repeats_merge_identical(set)) {
        surface_note(&record->summary, "its %zu scans are the same to the last digit: they count as one", all);
        scans->independent = 1;
    }
    if (set->count > 1 && profiles && cut_to_shortest(record, scene, status) != STATUS_OK)
        return status->code;
    if (set->keeps_heights && strips_gather(&record->strips, set, status) != STATUS_OK)
        return status->code;
    if (set->keeps_heights && record->strips.rows.rows == 0)
        surface_note(&record->summary, "no strip transfer: its scans differ in spacing or points");
    if (set->count == 1)
        return keep_single(record, scans, scene, status);
    for (size_t p = 0; p < set->count; p++) {
        free(set->members[p].height_m);
        set->members[p].height_m = NULL;
    }
    return STATUS_OK;
}

/** Names the models that were asked for and work on asperities, when the surface has none. */
static void note_models_lost(struct surface_summary *summary, uint64_t models, const char *why)
{
    struct text names = {0};
    for (size_t m = 0; m < model_count; m++)
        if ((models & MODEL_BIT(m)) && model_rows[m]->asperity_model)
            text_add(&names, "%s%s", names.length > 0 ? " and " : "", model_rows[m]->label);
    if (names.length > 0)
        surface_note(summary, "no %s: %s", text_string(&names), why);
    text_free(&names);
}

/** What the line through all harmonics leaves to say: a step between the ends, two slopes. */
static void note_thesis_fit(struct surface_summary *summary)
{
    const struct power_law *law = &summary->power_law;
    if (isnan(law->gamma)) {
        surface_note(summary, "no power law: %s",
                     law->harmonics < 3 ? "fewer than 3 harmonics lie in the fit band; widen fit_band"
                                        : "its alpha is beyond the range of numbers; are the units right?");
        return;
    }
    /* a jump J at the border of the record adds J/(pi n) to harmonic n, an f^-1 tail */
    double shortest = law->band_m[0], leak_m = summary->jump_m * shortest / (M_PI * summary->length_m);
    bool leaks = summary->windowed < summary->scans && summary->periodic < summary->scans;
    summary->jump_share = leaks ? leak_m / power_law_amplitude(law, shortest) : 0;
    if (summary->jump_share > 0.5)
        surface_note(
            summary,
            "the ends of the record differ by %.3g um; that jump alone leaks %s of the fitted amplitude at %.3g um, "
            "so gamma is drawn towards 1: try window: hann",
            summary->jump_m * 1e6, summary->jump_share > 1 ? "more than the whole" : "over half", shortest * 1e6);
    if (isfinite(law->knee_m))
        surface_note(summary, "two slopes fit better than one: gamma %.2f above %.3g um, %.2f below; consider fit_band",
                     law->gamma_above, law->knee_m * 1e6, law->gamma_below);
}

static void note_band(struct surface_summary *summary, const struct power_law_band *band)
{
    const struct power_law *law = &summary->power_law;
    double line_m[LOG_BIN_MOST];
    size_t count = power_law_band_lines(line_m, band);
    struct text lines = {0};
    if (law->found == POWER_LAW_BAND_NONE)
        surface_note(summary, "no power law found");
    else if (law->found == POWER_LAW_BAND_NARROW)
        surface_note(summary, "the power law is narrow: it holds from %.3g to %.3g um only, under a decade",
                     law->band_m[0] * 1e6, law->band_m[1] * 1e6);
    for (size_t i = 0; i < count; i++)
        text_add(&lines, "%s%.3g um", i > 0 ? ", " : "", line_m[i] * 1e6);
    if (count > 0)
        surface_note(summary, "lines of periodic marks, left out of the fit: %s", text_string(&lines));
    text_free(&lines);
}

static struct power_law_scans_def fit_def(const struct surface_summary *summary, const struct scene *scene)
{
    return (struct power_law_scans_def){surface_lambda_s(summary, scene),
                                        scene->fit_band_given ? scene->fit_band_m : NULL};
}

/** Every scan's law in the band of their mean. */
static enum status_code fit_alone(struct surface_record *record, const struct power_law_scans *scans,
                                  const struct scene *scene, struct status *status)
{
    const struct power_law_scans_def def = fit_def(&record->summary, scene);
    struct repeats *repeats = record->summary.repeats;
    size_t count = scans->scan_count;
    if (!repeats)
        return STATUS_OK;
    double *gamma = malloc(2 * count * sizeof *gamma);
    if (!gamma)
        return status_memory(status);
    double *psd_m3 = gamma + count;
    enum status_code rc = STATUS_OK;
    for (size_t i = 0; i < count && rc == STATUS_OK; i++) {
        struct power_law_band alone;
        rc = power_law_scans_fit_alone(&alone, scans, i, &def, record->band, status);
        struct power_law law = power_law_of_band(&alone);
        gamma[i] = law.gamma;
        psd_m3[i] = law.psd_m3;
    }
    if (rc == STATUS_OK)
        rc = ensemble_estimate(&repeats->gamma, &record->ensemble, gamma, scans->file, count, false, status);
    if (rc == STATUS_OK)
        rc = ensemble_estimate(&repeats->psd_m3, &record->ensemble, psd_m3, scans->file, count, true, status);
    repeats->gamma.model_sd = record->band->fit.gamma_bias_s;
    repeats->psd_m3.model_sd = 2 * M_LN10 * record->band->fit.log10_amplitude_bias_s;
    free(gamma);
    return rc;
}

static enum status_code fit_band(struct surface_record *record, struct power_law_scans *scans,
                                 const struct scene *scene, struct status *status)
{
    const struct power_law_scans_def def = fit_def(&record->summary, scene);
    if (!(record->band = malloc(sizeof *record->band)))
        return status_memory(status);
    if (power_law_scans_fit(record->band, scans, &def, status) != STATUS_OK)
        return status->code;
    record->summary.power_law = power_law_of_band(record->band);
    note_band(&record->summary, record->band);
    record->tapered = scans->mean;
    scans->mean = (struct spectrum){0};
    return STATUS_OK;
}

/** Power law and statistical parameters. */
static enum status_code describe(struct surface_record *record, struct power_law_scans *scans,
                                 const struct scene *scene, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    struct status none = {0};
    double started = clock_seconds();
    summary->harmonics = record->spectrum.count;
    summary->longest_waves = spectrum_longest_waves(&record->spectrum);
    summary->independent = fmax(1, scans->independent);
    double shortest_m = fmax(2 * surface_lambda_s(summary, scene), scene->fit_band_m[0]);
    summary->tail =
        convergence_tail(&record->spectrum, convergence_known(&record->spectrum, shortest_m, scans->step_m));
    if (scene->fit == POWER_LAW_THESIS) {
        summary->power_law = power_law_fit(&record->spectrum, scene->fit_band_m);
        note_thesis_fit(summary);
    } else if (fit_band(record, scans, scene, status) != STATUS_OK) {
        return status->code;
    }
    summary->times.spectrum += clock_seconds() - started;
    summary->has_asperities = roughness_asperities(&summary->asperities, &summary->roughness, &none) == STATUS_OK;
    if (!summary->has_asperities)
        note_models_lost(summary, scene->models, none.message);
    if (surface_diverges(summary))
        surface_note(summary,
                     "gamma = %.2f is below 1: the elastic multiscale area depends on the shortest wavelength sampled",
                     surface_short_gamma(&summary->power_law));
    return STATUS_OK;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/** The files by name: what comes out does not depend on the order in which a scene lists them. malloc'ed; NULL: out of
 * memory. */
static const char **sorted_files(const struct scene_surface *surface)
{
    const char **files = malloc((surface->file_count + 1) * sizeof *files);
    if (!files)
        return NULL;
    for (size_t f = 0; f < surface->file_count; f++)
        files[f] = surface->files[f];
    qsort(files, surface->file_count, sizeof *files, by_name);
    return files;
}

/** r from the scans along the lay, each of which has to be readable: the answer hangs on it. */
static enum status_code take_along(struct surface_summary *summary, const struct scene *scene, struct hash *hash,
                                   struct status *status)
{
    struct scene_surface surface = *summary->scene;
    struct surface_record along = {.summary = {.scene = &surface}};
    struct power_law_scans scans = {0};
    struct status problem = {0};
    surface.files = surface.along;
    surface.file_count = surface.along_count;
    enum status_code rc = STATUS_OK;
    for (size_t f = 0; f < surface.file_count && rc == STATUS_OK; f++)
        rc = describe_file(&along, &scans, scene, &surface, surface.files[f], hash, &problem);
    double unlike = along.summary.spacing_m / summary->spacing_m;
    if (rc == STATUS_OK)
        set_lay(summary, sqrt(along.summary.roughness.m2 / summary->roughness.m2), "are 'file' and 'along' exchanged?");
    if (rc == STATUS_OK && !(fabs(log(unlike)) < 0.1))
        surface_note(summary,
                     "its scans along the lay have %.3g times the spacing of those across: slopes so taken do "
                     "not compare well",
                     unlike);
    surface_record_free(&along);
    power_law_scans_free(&scans);
    return rc == STATUS_OK ? STATUS_OK : status_fail(status, rc, "along: %s", problem.message);
}

static enum status_code find_lay(struct surface_summary *summary, const struct scene *scene, struct hash *hash,
                                 struct status *status)
{
    const struct scene_surface *surface = summary->scene;
    if (surface->along_count > 0)
        return take_along(summary, scene, hash, status);
    if (surface->lay_given || (scene->lay_given && !summary->has_lay))
        set_lay(summary, surface->lay_given ? surface->lay : scene->lay, "");
    return STATUS_OK;
}

static void stretch_member(struct member *member, double kappa)
{
    member->spectrum.length_m /= kappa;
    member->spacing_m /= kappa;
    member->roughness.m2 *= pow(kappa, 2);
    member->roughness.m4_per_m2 *= pow(kappa, 4);
}

/** Makes of a surface with a lay the isotropic one of the same mean-square gradient that the models are asked about;
 * what describes the scans stays as it was measured (equations: lay). */
static void stretch(struct surface_record *record, double kappa)
{
    record->spectrum.length_m /= kappa;
    record->strips.rows.spacing_m /= kappa;
    record->summary.tail.wavelength_m /= kappa;
    record->summary.asperities.density_per_m2 *= pow(kappa, 2);
    record->summary.asperities.radius_m /= pow(kappa, 2);
    for (size_t p = 0; p < record->ensemble.count; p++)
        stretch_member(&record->ensemble.members[p], kappa);
    for (int variant = 0; variant < SENSITIVITY_VARIANTS; variant++)
        stretch_member(&record->sensitivity.variants[variant], kappa);
}

/** From what was gathered to the description of the surface. */
static enum status_code conclude(struct surface_record *record, struct power_law_scans *scans,
                                 const struct scene *scene, const struct surface_record *counterface,
                                 struct status *status)
{
    if (counterface && (describe_counterface(record, scans, counterface, status) != STATUS_OK ||
                        strips_pair(&record->strips, &counterface->strips, status) != STATUS_OK))
        return status->code;
    if (counterface && wants_strips(scene) && counterface->strips.rows.rows == 0)
        surface_note(&record->summary, "no strip transfer: the counterface's scans differ in spacing or points");
    record->summary.strip_cost = (double)strips_cost(&record->strips, STRIP_SURROGATES);
    record->summary.has_strips = strips_surrogates(&record->strips, scene) > 0;
    if (describe(record, scans, scene, status) != STATUS_OK)
        return status->code;
    if (describe_repeats(record, scene, status) != STATUS_OK)
        return status->code;
    bool found = scene->fit == POWER_LAW_AUTO && record->band->law != POWER_LAW_BAND_NONE;
    if (found && fit_alone(record, scans, scene, status) != STATUS_OK)
        return status->code;
    stretch(record, surface_kappa(&record->summary));
    return STATUS_OK;
}

/** The files of a surface, and which of them are refused. */
struct files {
    const char **name; /* sorted */
    size_t count, refused;
    char **refusal; /* why; NULL: not refused */
};

static void free_files(struct files *files)
{
    for (size_t f = 0; files->refusal && f < files->count; f++)
        free(files->refusal[f]);
    free(files->refusal);
    free(files->name);
}

/** Gathers every file that is not refused. What cannot be used is refused, and *again set where it left something
 * behind. */
static enum status_code take_files(struct surface_record *out, struct power_law_scans *scans, const struct scene *scene,
                                   struct files *files, struct hash *hash, bool *again, struct status *status)
{
    *again = false;
    for (size_t f = 0; f < files->count; f++) {
        struct status problem = {0};
        size_t before = out->ensemble.scan_count;
        if (files->refusal[f])
            continue;
        enum status_code rc = describe_file(out, scans, scene, out->summary.scene, files->name[f], hash, &problem);
        if (rc == STATUS_MEMORY || rc == STATUS_INTERRUPTED)
            return status_fail(status, rc, "%s", problem.message);
        if (rc == STATUS_OK)
            continue;
        *again = *again || out->ensemble.scan_count > before;
        files->refusal[f] = strdup(problem.message);
        files->refused++;
        if (!files->refusal[f])
            return status_memory(status);
    }
    return STATUS_OK;
}

/** Notes which scans were refused, but for the `first` of a surface that has no other: that is its own refusal. */
static void note_refused(struct surface_summary *summary, const struct files *files, size_t first)
{
    size_t used = files->count - files->refused;
    char others[80] = "";
    if (used > 0)
        snprintf(others, sizeof others, " - refused; %zu of its %zu scans are used", used, files->count);
    for (size_t f = 0; f < files->count; f++)
        if (files->refusal[f] && (used > 0 || f != first))
            note_refused_scan(summary, files->refusal[f], others);
}

/** Gathers the scans of a surface that can be used. Error: why there is none. */
static enum status_code take_usable(struct surface_record *out, struct power_law_scans *scans,
                                    const struct scene *scene, struct files *files, struct hash *hash,
                                    struct status *status)
{
    struct hash unused = hash_start();
    bool again;
    enum status_code rc = take_files(out, scans, scene, files, hash, &again, status);
    while (rc == STATUS_OK && again && files->refused < files->count) { /* from the start, without those */
        struct surface_summary again_from = {
            .scene = out->summary.scene, .pair = out->summary.pair, .times = out->summary.times};
        surface_record_free(out);
        power_law_scans_free(scans);
        *scans = (struct power_law_scans){0};
        *out = (struct surface_record){.summary = again_from};
        rc = take_files(out, scans, scene, files, &unused, &again, status);
    }
    if (rc != STATUS_OK || files->refused == 0)
        return rc;
    size_t first = 0;
    while (!files->refusal[first])
        first++;
    if (files->count > 1)
        note_refused(&out->summary, files, first);
    if (files->refused < files->count)
        return STATUS_OK;
    return status_fail(status, STATUS_SCAN, "%s", files->refusal[first]);
}

enum status_code describe_surface(struct surface_record *out, const struct scene *scene,
                                  const struct scene_surface *surface, const struct surface_record *counterface,
                                  struct status *status)
{
    struct surface_summary *summary = &out->summary;
    struct status problem = {0};
    struct hash hash = hash_start();
    struct power_law_scans scans = {0};
    struct files files = {sorted_files(surface), surface->file_count, 0,
                          calloc(surface->file_count + 1, sizeof(char *))};
    summary->scene = surface;
    summary->pair = scene_pair(surface->bodies);
    enum status_code rc = files.name && files.refusal ? take_usable(out, &scans, scene, &files, &hash, &problem)
                                                      : status_memory(&problem);
    free_files(&files);
    if (rc == STATUS_OK && surface != &scene->counterface_surface) /* whose lay is taken to be the surface's */
        rc = find_lay(summary, scene, &hash, &problem);
    hash_finish(&hash, summary->hash);
    if (rc == STATUS_OK)
        rc = describe_conclude(out, &scans, scene, &problem);
    if (rc == STATUS_OK) {
        summary->usable = true;
        rc = conclude(out, &scans, scene, counterface, &problem);
    }
    power_law_scans_free(&scans);
    if (rc == STATUS_MEMORY)
        return status_memory(status);
    if (rc != STATUS_OK) {
        summary->usable = false;
        summary->refusal = strdup(problem.message);
        return summary->refusal ? STATUS_OK : status_memory(status);
    }
    return STATUS_OK;
}
