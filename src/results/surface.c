#include "results/surface.h"

#include "base/clock.h"
#include "base/hash.h"
#include "contact/statistical.h"
#include "results/condense.h"
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
    summary->jump_m = fmax(summary->jump_m, fabs(profile->end_jump_m));
    if (summary->scans == 0) {
        record->spectrum = spectrum;
        summary->roughness = roughness;
        summary->points = profile->points;
        summary->spacing_m = profile->spacing_m;
        summary->length_m = spectrum.length_m;
        summary->grid = profile->grid;
        summary->tilt = profile->tilt;
        keep_preview(record, profile);
    } else {
        spectrum_average(&record->spectrum, &spectrum, summary->scans);
        roughness_average(&summary->roughness, &roughness, summary->scans);
        spectrum_free(&spectrum);
    }
    summary->scans++;
    return STATUS_OK;
}

/** Scans of one surface can be averaged harmonic by harmonic when their lengths and spacings agree to 0.1 %. */
static enum status_code check_alike(const struct surface_summary *summary, const struct profile *profile,
                                    struct status *status)
{
    if (summary->scans == 0)
        return STATUS_OK;
    double length_m = (double)profile->points * profile->spacing_m;
    if (fabs(length_m / summary->length_m - 1) > 1e-3 || fabs(profile->spacing_m / summary->spacing_m - 1) > 1e-3)
        return status_fail(status, STATUS_SCAN,
                           "%.6g mm at %.6g um spacing, but the surface's first scan has %.6g mm at %.6g um; list scans "
                           "of another length or spacing as surfaces of their own",
                           length_m * 1e3, profile->spacing_m * 1e6, summary->length_m * 1e3, summary->spacing_m * 1e6);
    return STATUS_OK;
}

static enum status_code read_file(struct surface_record *record, const struct scene *scene,
                                  const struct scene_surface *surface, const char *file, struct hash *hash,
                                  struct status *status)
{
    struct surface_summary *summary = &record->summary;
    struct text bytes = {0};
    struct scan scan = {0};
    struct profile profile = {0};
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
    summary->times.read += clock_seconds() - started;
    if (rc == STATUS_OK && scan.kind == SCAN_AREAL)
        rc = status_fail(status, STATUS_SCAN, "%s: an areal map; export a profile from it", file);
    started = clock_seconds();
    if (rc == STATUS_OK) {
        struct profile_options how = profile_options_of(scene);
        rc = profile_make(&profile, &scan, 0, &how, status);
        if (rc == STATUS_OK)
            rc = check_alike(summary, &profile, status);
        if (rc != STATUS_OK)
            status_prefix(status, "%s", file);
    }
    summary->times.prepare += clock_seconds() - started;
    if (rc == STATUS_OK) {
        snprintf(summary->format, sizeof summary->format, "%s", scan.format);
        snprintf(summary->units, sizeof summary->units, "x %s, z %s", scan.x_unit, scan.z_unit);
        note_scan(summary, &scan, &profile, file);
        rc = add_profile(record, &profile, scene, status);
    }
    profile_free(&profile);
    scan_free(&scan);
    free(path);
    return rc;
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
        note(summary, "the ends of the record differ by %.3g um; that jump alone gives %.0f %% of the amplitude at %.3g um, "
             "so gamma is drawn towards 1: try window: hann", summary->jump_m * 1e6, 100 * summary->jump_share,
             shortest * 1e6);
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
                                  const struct scene_surface *surface, struct status *status)
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
    describe(out, scene);
    return STATUS_OK;
}

void surface_record_free(struct surface_record *record, bool with_texts)
{
    spectrum_free(&record->spectrum);
    for (int m = 0; m < MODEL_COUNT; m++)
        free(record->curves[m].points);
    memset(record->curves, 0, sizeof record->curves);
    if (with_texts) {
        free(record->summary.refusal);
        free(record->summary.notes);
        record->summary.refusal = record->summary.notes = NULL;
    }
}
