#include "results/surface.h"

#include "base/clock.h"
#include "base/hash.h"
#include "contact/statistical.h"
#include "results/condense.h"
#include "spectrum/grid.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void note(struct surface_summary *summary, const char *format, ...) PRINTF_LIKE(2, 3);

/** Adds a line to the surface's notes; a note that cannot be stored for want of memory is dropped. */
static void note(struct surface_summary *summary, const char *format, ...)
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

static void record_free_parts(struct surface_record *record)
{
    for (size_t p = 0; p < record->part_count; p++)
        spectrum_free(&record->parts[p].spectrum);
    record->part_count = 0;
}

static void note_scan(struct surface_summary *summary, const struct scan *scan, const struct profile *profile,
                      const char *file)
{
    for (size_t w = 0; w < scan->warning_count; w++)
        note(summary, "%s: %s", file, scan->warnings[w]);
    for (size_t n = 0; n < profile->note_count; n++)
        note(summary, "%s: %s", file, profile->notes[n]);
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

/** Averages `spectrum` into the record's mean, on the grid of the shorter record and of the lower Nyquist frequency. */
static enum status_code average_spectrum(struct surface_record *record, const struct spectrum *spectrum,
                                         struct status *status)
{
    struct spectrum *mean = &record->spectrum, same;
    size_t so_far = record->summary.scans;
    bool alike = fabs(spectrum->length_m / mean->length_m - 1) < 1e-6 && spectrum->has_nyquist == mean->has_nyquist &&
                 spectrum->count == mean->count;
    if (alike) {
        spectrum_average(mean, spectrum, so_far);
        return STATUS_OK;
    }
    double length_m = fmin(mean->length_m, spectrum->length_m);
    double highest = fmin(spectrum_frequency(mean, mean->count - 1), spectrum_frequency(spectrum, spectrum->count - 1));
    size_t count = (size_t)fmax(1, floor(length_m * highest * (1 + 1e-9)));
    if (grid_spectrum(&same, mean, length_m, count, status) != STATUS_OK)
        return status->code;
    spectrum_free(mean);
    *mean = same;
    if (grid_spectrum(&same, spectrum, length_m, count, status) != STATUS_OK)
        return status->code;
    spectrum_average(mean, &same, so_far);
    spectrum_free(&same);
    return STATUS_OK;
}

/** Keeps the scan for a run of its own; when there are too many, every second one goes. Takes the spectrum over. */
static void keep_part(struct surface_record *record, struct spectrum *spectrum, const struct roughness *roughness)
{
    record->part_stride = record->part_stride ? record->part_stride : 1;
    if (record->summary.scans % record->part_stride != 0) {
        spectrum_free(spectrum);
        return;
    }
    if (record->part_count == SPREAD_PARTS) {
        record->part_count = 0;
        for (size_t p = 0; p < SPREAD_PARTS; p++)
            if (p % 2 == 0)
                record->parts[record->part_count++] = record->parts[p];
            else
                spectrum_free(&record->parts[p].spectrum);
        record->part_stride *= 2;
        if (record->summary.scans % record->part_stride != 0) {
            spectrum_free(spectrum);
            return;
        }
    }
    record->parts[record->part_count++] = (struct spread_part){*spectrum, *roughness};
}

/** Adds one profile to the surface: averages its spectrum and moments into the record's. */
static enum status_code add_profile(struct surface_record *record, const struct profile *profile,
                                    const struct scene *scene, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    struct spectrum spectrum;
    struct roughness roughness = roughness_of_heights(profile->height_m, profile->points, profile->spacing_m);
    double started = clock_seconds();
    if (spectrum_compute(&spectrum, profile->height_m, profile->points, profile->spacing_m, scene->window, status) !=
        STATUS_OK) {
        spectrum_free(&spectrum);
        return status->code;
    }
    if (scene->moments == SCENE_MOMENTS_SPECTRAL)
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
        rc = average_spectrum(record, &spectrum, status);
        roughness_average(&summary->roughness, &roughness, summary->scans);
    }
    keep_part(record, &spectrum, &roughness);
    summary->length_m = record->spectrum.length_m;
    summary->scans++;
    return rc;
}

/** Puts the parts on the mean's grid and lets them say how far they differ. A single scan has no parts. */
static enum status_code describe_parts(struct surface_record *record, const struct scene *scene, struct status *status)
{
    const struct spectrum *mean = &record->spectrum;
    if (record->part_count < 2)
        record_free_parts(record);
    for (size_t p = 0; p < record->part_count; p++) {
        struct spectrum *own = &record->parts[p].spectrum, same;
        if (own->count == mean->count && fabs(own->length_m / mean->length_m - 1) < 1e-6)
            continue;
        if (grid_spectrum(&same, own, mean->length_m, mean->count, status) != STATUS_OK)
            return status->code;
        spectrum_free(own);
        *own = same;
    }
    return spread_laws(&record->summary.spread, record->parts, record->part_count, scene->fit_band_m, status);
}

/** Every row of a scan (a profile has one) into the surface. A row of a map that cannot be used (all missing, flat) is
 * left out and counted; the map is refused when none is left. */
static enum status_code add_rows(struct surface_record *record, const struct scan *scan, const struct scene *scene,
                                 const char *file, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    const struct profile_options how = profile_options_of(scene);
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
        note(summary, "%s: a map; its %zu %s were averaged as profiles", file, scan->ny - unusable,
             scene->direction == SCENE_DIRECTION_X ? "rows" : "columns");
    if (unusable > 0)
        note(summary, "%s: %zu rows left out, the first because %s", file, unusable, first.message);
    return STATUS_OK;
}

static enum status_code read_file(struct surface_record *record, const struct scene *scene,
                                  const struct scene_surface *surface, const char *file, struct hash *hash,
                                  struct status *status)
{
    struct surface_summary *summary = &record->summary;
    struct text bytes = {0};
    struct scan scan = {0};
    char *path = scene_file_path(scene, file);
    if (!path)
        return status_memory(status);
    struct scan_options options = {surface->x_unit, surface->z_unit};

    double started = clock_seconds();
    enum status_code rc = text_read_file(&bytes, path, status);
    if (rc == STATUS_OK) {
        hash_add(hash, bytes.data, bytes.length);
        struct scan_bytes content = {bytes.data, bytes.length, file};
        rc = scan_read_bytes(&scan, &content, &options, status);
    }
    text_free(&bytes);
    if (rc == STATUS_OK && scan.kind == SCAN_AREAL && scene->direction == SCENE_DIRECTION_Y)
        rc = scan_turn(&scan, status);
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

/** Two rough bodies: amplitudes and moments of the surface and of its counterface add as squares (physics §2). */
static enum status_code pair_with(struct surface_record *record, const struct surface_record *counterface,
                                  struct status *status)
{
    struct roughness *own = &record->summary.roughness;
    double own_rq_m = own->rq_m;
    roughness_add(own, &counterface->summary.roughness);
    note(&record->summary, "pressed against a rough counterface: Rq %.4g um and %.4g um give %.4g um together",
         own_rq_m * 1e6, counterface->summary.roughness.rq_m * 1e6, own->rq_m * 1e6);
    for (size_t p = 0; p < record->part_count; p++) {
        roughness_add(&record->parts[p].roughness, &counterface->summary.roughness);
        if (grid_add(&record->parts[p].spectrum, &counterface->spectrum, status) != STATUS_OK)
            return status->code;
    }
    return grid_add(&record->spectrum, &counterface->spectrum, status);
}

/** Power law, statistical parameters, and what the end-to-end jump may have leaked into them. */
static void describe(struct surface_record *record, const struct scene *scene)
{
    struct surface_summary *summary = &record->summary;
    summary->harmonics = record->spectrum.count;
    summary->law = powerlaw_fit(&record->spectrum, scene->fit_band_m);
    struct status status = {0};
    summary->has_asperities = roughness_asperities(&summary->asperities, &summary->roughness, &status) == STATUS_OK;
    if (!summary->has_asperities && (scene->models & SCENE_MODEL_STATISTICAL))
        note(summary, "no GW and JG: %s", status.message);

    const struct powerlaw *law = &summary->law;
    if (isnan(law->gamma)) {
        note(summary, "no power law: fewer than 3 harmonics lie in the fit band; widen fit_band_m");
        return;
    }
    /* a jump J at the border of the record adds J/(pi n) to harmonic n, an f^-1 tail */
    double shortest = law->band_m[0], leak_m = summary->jump_m * shortest / (M_PI * summary->length_m);
    summary->jump_share = scene->window == SCENE_WINDOW_HANN ? 0 : leak_m / powerlaw_amplitude(law, shortest);
    if (summary->jump_share > 0.5)
        note(summary,
             "the ends of the record differ by %.3g um; that jump alone gives %.0f %% of the amplitude at %.3g um, "
             "so gamma is drawn towards 1: try window: hann",
             summary->jump_m * 1e6, 100 * summary->jump_share, shortest * 1e6);
    if (isfinite(law->knee_m))
        note(summary, "two slopes fit better than one: gamma %.2f above %.3g um, %.2f below; consider fit_band_m",
             law->gamma_above, law->knee_m * 1e6, law->gamma_below);
    if (law->gamma < 1)
        note(summary, "gamma = %.2f is below 1: the elastic multiscale area depends on the shortest wavelength sampled",
             law->gamma);
}

/** The second estimate of beta, against the multiscale model of the same material law. */
static void estimate_beta(struct surface_record *record, enum model_id statistical, enum model_id multiscale)
{
    const struct model_curve *low = &record->curves[statistical], *high = &record->curves[multiscale];
    if (!low->exists || !high->exists)
        return;
    double sigma_m = record->summary.asperities.sigma_m, sum = 0;
    size_t common = 0;
    for (size_t i = 0; i < low->count && i < high->count; i++)
        if (low->points[i].load == high->points[i].load) {
            sum += statistical_beta_multiscale(&low->points[i].separation_m, &high->points[i].separation_m, 1, sigma_m);
            common++;
        }
    record->summary.models[statistical].beta_multiscale = common > 0 ? sum / (double)common : NAN;
}

struct model_task surface_task(const struct surface_record *record, const struct scene *scene, const struct plan *plan,
                               const double *loads, size_t load_count)
{
    return (struct model_task){
        .spectrum = &record->spectrum,
        .asperities = record->summary.has_asperities ? &record->summary.asperities : NULL,
        .pair = &plan->pair,
        .loads = loads,
        .load_count = load_count,
        .wanted = plan->wanted,
        .tolerance = scene->tolerance,
        .closure = scene->closure,
    };
}

bool surface_extends(const struct surface_summary *summary, const struct scene *scene)
{
    return !isnan(summary->law.gamma) && !(scene->effects_auto && summary->bound.settled);
}

/** Carries the fitted law on below the sampling limit (twice the spacing), where that can change anything. */
static void extend(struct surface_summary *summary, const struct scene *scene, const struct plan *plan)
{
    double started = clock_seconds();
    for (int m = 0; m < MODEL_COUNT; m++) {
        struct surface_model *model = &summary->models[m];
        if (model_rows[m].family != SCENE_MODEL_MULTISCALE || !model->exists || !surface_extends(summary, scene))
            continue;
        model->extension = convergence_extend(&summary->law, summary->length_m, 2 * summary->spacing_m, &plan->pair,
                                              model_rows[m].plastic, scene->convergence.load);
        model->extended = true;
    }
    summary->times.convergence = clock_seconds() - started;
}

/** Every scan of the surface alone in one model. */
static enum status_code run_parts(struct surface_record *record, enum model_id model, const struct model_task *task,
                                  struct status *status)
{
    if (record->part_count < 2)
        return STATUS_OK;
    record->band_count = task->load_count;
    record->bands[model] = calloc(task->load_count, sizeof *record->bands[model]);
    if (!record->bands[model])
        return status_memory(status);
    return spread_model(&record->summary.spread, record->bands[model], record->parts, record->part_count, model, task,
                        &record->summary.models[model].work, status);
}

enum status_code surface_run_models(struct surface_record *record, const struct scene *scene, const struct plan *plan,
                                    const double *loads, size_t load_count, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    struct model_task task = surface_task(record, scene, plan, loads, load_count);
    for (int m = 0; m < MODEL_COUNT; m++) {
        struct model_curve *curve = &record->curves[m];
        if (!model_called_for((enum model_id)m, plan->families, plan->running))
            continue;
        curve->points = calloc(load_count + 1, sizeof *curve->points);
        if (!curve->points)
            return status_memory(status);
        double started = clock_seconds();
        if (model_rows[m].run(curve, &model_rows[m], &task, status) != STATUS_OK)
            return status->code;
        summary->times.models[m] = clock_seconds() - started;
        if (curve->exists)
            condense_curve(&summary->models[m], curve, &model_rows[m], summary->asperities.sigma_m);
        if (run_parts(record, (enum model_id)m, &task, status) != STATUS_OK)
            return status->code;
    }
    if (plan_runs(plan, EFFECT_SEPARATION)) {
        estimate_beta(record, MODEL_GW, MODEL_MULTISCALE_ELASTIC);
        estimate_beta(record, MODEL_JG, MODEL_MULTISCALE_PLASTIC);
    }
    if (plan_runs(plan, EFFECT_CONVERGENCE))
        extend(summary, scene, plan);
    return STATUS_OK;
}

enum status_code surface_describe(struct surface_record *out, const struct scene *scene,
                                  const struct scene_surface *surface, const struct surface_record *counterface,
                                  struct status *status)
{
    struct surface_summary *summary = &out->summary;
    struct status problem = {0};
    struct hash hash = hash_start();
    summary->scene = surface;
    enum status_code rc = STATUS_OK;
    for (size_t f = 0; f < surface->file_count && rc == STATUS_OK; f++)
        rc = read_file(out, scene, surface, surface->files[f], &hash, &problem);
    hash_finish(&hash, summary->hash);
    if (rc == STATUS_MEMORY)
        return status_memory(status);
    if (rc != STATUS_OK) {
        summary->refusal = strdup(problem.message);
        return summary->refusal ? STATUS_OK : status_memory(status);
    }
    summary->usable = true;
    if (counterface && pair_with(out, counterface, status) != STATUS_OK)
        return status->code;
    describe(out, scene);
    return describe_parts(out, scene, status);
}

void surface_record_free(struct surface_record *record, bool with_texts)
{
    spectrum_free(&record->spectrum);
    for (int m = 0; m < MODEL_COUNT; m++)
        free(record->curves[m].points);
    for (int m = 0; m < MODEL_COUNT; m++)
        free(record->bands[m]);
    memset(record->curves, 0, sizeof record->curves);
    memset(record->bands, 0, sizeof record->bands);
    record_free_parts(record);
    if (with_texts) {
        free(record->summary.refusal);
        free(record->summary.notes);
        record->summary.refusal = record->summary.notes = NULL;
    }
}
