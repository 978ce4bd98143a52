/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "members/surface_read.h"

#include "base/clock.h"
#include "contact/cmy.h"

#include "spectrum/simulated_record.h"
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/** Does a model that may run use strips? */
static bool wants_strips(const struct scene *scene)
{
    return scene->models & model_flagged(offsetof(struct model_row, uses_strip));
}

enum status_code surface_read_counterface(struct surface_record *record, struct power_law_scans *scans,
                                          const struct surface_record *counterface, struct status *status)
{
    struct roughness *own = &record->summary.roughness;
    double own_rq_m = own->rq_m;
    roughness_add(own, &counterface->summary.roughness);
    record->summary.between_m2 += counterface->summary.between_m2;
    note_add(&record->summary.notes, NULL, "note.pressed\nown %.4g\nother %.4g\nboth %.4g", own_rq_m * 1e6,
             counterface->summary.roughness.rq_m * 1e6, own->rq_m * 1e6);
    for (size_t i = 0; i < counterface->summary.notes.count; i++) {
        const struct note *note = &counterface->summary.notes.notes[i];
        if (note->subject || note->refused_scan)
            note_add_counterface(&record->summary.notes, note);
    }
    if (ensemble_pair(&record->ensemble, &counterface->ensemble, status) != STATUS_OK)
        return status->code;
    if (record->ensemble.count < 2)
        ensemble_free(&record->ensemble);
    const bool tapered = scans->scan_count > 0 && counterface->tapered.count > 0;
    for (size_t i = 0; i < scans->scan_count && tapered; i++)
        if (grid_add(&scans->scan[i].spectrum, &counterface->tapered, status) != STATUS_OK)
            return status->code;
    if ((tapered && grid_add(&scans->mean, &counterface->tapered, status) != STATUS_OK) ||
        grid_add(&record->typical, &counterface->typical, status) != STATUS_OK)
        return status->code;
    return grid_add(&record->spectrum, &counterface->spectrum, status);
}

/** Keeps the heights of the first scan, or of a row in the middle of the map, if records like it are to be simulated.
 */
static void keep_first(struct surface_record *record, const struct power_law_scans *scans, const struct scene *scene)
{
    const struct ensemble *set = &record->ensemble;
    struct member *part = &set->members[set->members[0].is_row ? set->count / 2 : 0];
    if (!part->height_m || part->points < SIMULATED_RECORD_LEAST_POINTS ||
        !(scene->effects_auto || (scene->effects & EFFECT_BIT(EFFECT_UNCERTAINTY))) ||
        (scans->scan_count > 0 && !simulated_record_possible(scans->scan[0].spectrum.amplitude_m, part->points)))
        return;
    record->summary.single_points = part->points;
    record->height_m = part->height_m;
    part->height_m = NULL;
}

enum status_code surface_read_members(struct surface_record *record, struct power_law_scans *scans,
                                      const struct scene *scene, struct status *status)
{
    struct ensemble *set = &record->ensemble;
    size_t all = set->count;
    bool profiles = true;
    for (size_t p = 0; p < all; p++)
        profiles = profiles && !set->members[p].is_row;
    if (all == 0) /* a map none of whose chosen rows can be used */
        return STATUS_OK;
    if (set->count > 1 && profiles &&
        repeats_cut_to_shortest(set, &record->summary.repeats.cut, scene, status) != STATUS_OK)
        return status->code;
    bool paired = scene->counterface_surface.files.count > 0;
    if (set->keeps_heights && strips_gather(&record->strips, set, paired, status) != STATUS_OK)
        return status->code;
    if (set->keeps_heights && record->strips.rows.rows == 0)
        note_add(&record->summary.notes, NULL, "note.unlike");
    if (set->count == 1 || set->scan_count == 1 || paired)
        keep_first(record, scans, scene);
    if (set->count == 1) { /* the surface itself */
        ensemble_free(set);
        return STATUS_OK;
    }
    for (size_t p = 0; p < set->count; p++) {
        free(set->members[p].height_m);
        set->members[p].height_m = NULL;
    }
    return STATUS_OK;
}

/** Notes on the fitted law (none, two slopes, spectral lines, divergence), and on the models that cannot run because
 * the surface has no asperities (`why_none`). */
static void note_description(struct surface_summary *summary, const struct scene *scene, const double *line_m,
                             size_t line_count, const char *why_none)
{
    struct note_list *notes = &summary->notes;
    const struct power_law *law = &summary->power_law;
    OWNED(text_free) struct text lines = {0}, models = {0};
    for (size_t i = 0; i < line_count; i++)
        text_add(&lines, "\n%s %.2g", i > 0 ? "others" : "first", line_m[i] * 1e6);
    for (size_t m = 0; m < model_count && !summary->has_asperities; m++)
        if ((scene->models & MODEL_BIT(m)) && model_rows[m]->sums_asperities)
            text_add(&models, "\n%s %s", models.length > 0 ? "others" : "first", model_rows[m]->label);
    if (scene->fit == POWER_LAW_THESIS && isnan(law->gamma))
        note_add(notes, NULL, law->harmonics < 3 ? "note.few_harmonics" : "note.no_alpha");
    else if (law->found == POWER_LAW_BAND_NONE)
        note_add(notes, NULL, "note.no_law");
    else if (law->found == POWER_LAW_BAND_SCATTERED)
        note_add(notes, NULL, "note.scattered\nrms %.2g", law->misfit_decades);
    else if (law->found == POWER_LAW_BAND_NARROW)
        note_add(notes, NULL, "note.narrow\nfrom %.3g\nto %.3g", law->band_m[0] * 1e6, law->band_m[1] * 1e6);
    if (isfinite(law->knee_m))
        note_add(notes, NULL, "note.knee\nabove %.2f\nat %.3g\nbelow %.2f", law->gamma_above, law->knee_m * 1e6,
                 law->gamma_below);
    if (lines.length > 0)
        note_add(notes, NULL, "note.lines%s", text_string(&lines));
    if (models.length > 0)
        note_add(notes, NULL, "note.no_models%s\nwhy\t%s", text_string(&models), why_none);
    if (surface_diverges(summary))
        note_add(notes, NULL, "note.diverges\ngamma %.2f", surface_short_gamma(law));
}

/** The cut-off of the low-pass that the scans had. */
static double cutoff_m(const struct surface_summary *summary, const struct scene *scene)
{
    return fmax(scene->lambda_s_m, summary->cutoff_m);
}

/** Fits every scan's law in the band found for their mean. */
static enum status_code fit_alone(struct surface_record *record, const struct power_law_scans *scans,
                                  const struct scene *scene, struct status *status)
{
    struct repeats *repeats = &record->summary.repeats;
    size_t count = scans->scan_count;
    if (repeats->scans < 2)
        return STATUS_OK;
    OWNED(memory_free) struct ensemble_value *gamma = malloc(2 * count * sizeof *gamma);
    if (!gamma)
        return status_memory(status);
    struct ensemble_value *psd_m3 = gamma + count;
    for (size_t i = 0; i < count; i++) {
        struct power_law_band alone;
        power_law_scans_fit_alone(&alone, scans, i, cutoff_m(&record->summary, scene), record->band);
        struct power_law law = power_law_of_band(&alone, &record->typical);
        gamma[i] = (struct ensemble_value){law.gamma, scans->scan[i].file};
        psd_m3[i] = (struct ensemble_value){law.psd_m3, scans->scan[i].file};
    }
    enum status_code rc = ensemble_estimate(&repeats->gamma, &record->ensemble, gamma, count, false, status);
    if (rc == STATUS_OK)
        rc = ensemble_estimate(&repeats->psd_m3, &record->ensemble, psd_m3, count, true, status);
    repeats->gamma.model_sd = record->band->fit.gamma_bias_s;
    repeats->psd_m3.model_sd = 2 * M_LN10 * record->band->fit.log10_amplitude_bias_s;
    return rc;
}

/** Power law and statistical parameters. */
static enum status_code describe(struct surface_record *record, struct power_law_scans *scans,
                                 const struct scene *scene, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    struct power_law *law = &summary->power_law;
    const double lambda_s_m = cutoff_m(summary, scene);
    struct status none = {0};
    double started = clock_seconds(), line_m[LOG_BIN_MOST];
    size_t lines = 0;
    summary->longest_waves = spectrum_longest_waves(&record->spectrum);
    summary->independent = fmax(1, scans->independent);
    size_t known = spectrum_known(&record->spectrum, fmax(2 * lambda_s_m, scene->fit_band_m[0]), scans->step_m);
    summary->tail = convergence_tail(&record->spectrum, known);
    summary->line = power_law_fit(&record->typical, scene->fit_band_m);
    if (scene->fit == POWER_LAW_THESIS) {
        *law = summary->line;
    } else {
        if (!(record->band = malloc(sizeof *record->band)))
            return status_memory(status);
        power_law_scans_fit(record->band, scans, lambda_s_m, scene->fit_band_given ? scene->fit_band_m : NULL);
        *law = power_law_of_band(record->band, &record->typical);
        lines = power_law_band_lines(line_m, record->band);
        record->tapered = scans->mean;
        scans->mean = (struct spectrum){0};
    }
    summary->has_asperities = roughness_asperities(&summary->asperities, &summary->roughness, &none) == STATUS_OK;
    summary->times.spectrum += clock_seconds() - started;
    note_description(summary, scene, line_m, lines, none.message);
    return STATUS_OK;
}

static bool is_map(const struct surface_record *record)
{
    return record->ensemble.count == 0 || record->ensemble.members[0].is_row;
}

/** Copies what belongs to the surface, whichever direction its scans have. */
static void tell(struct surface_summary *summary, const struct surface_summary *of)
{
    summary->scene = of->scene;
    summary->pair = of->pair;
    summary->notes = of->notes;
    summary->all_scans = of->all_scans;
    summary->refused_scans = of->refused_scans;
    memcpy(summary->format, of->format, sizeof summary->format);
    memcpy(summary->units, of->units, sizeof summary->units);
}

/** Of scans in two directions the steeper ones are taken to run across the lay, whatever the scene calls them, so that
 * r <= 1. On 18 measured maps the rms error of ln area, gap and resistance is then .28 .38 .41; with strips of the
 * flatter scans in their place it is .48 .70 .84. A map has both directions and stays as it is. */
static enum status_code place_along(const struct surface_scans *task, const struct surface_scans *other,
                                    struct status *status)
{
    struct surface_record *record = task->record, *along = other->record;
    struct surface_summary *summary = &record->summary;
    const bool maps = is_map(record) || is_map(along);
    if (!maps && along->summary.roughness.m2 > summary->roughness.m2) {
        const struct surface_record across = *along;
        const struct power_law_scans scans = *other->scans;
        *along = *record;
        *record = across;
        *other->scans = *task->scans;
        *task->scans = scans;
        record->counterface = along->counterface;
        tell(summary, &along->summary);
        note_add(&summary->notes, NULL, "note.turned");
    }
    const double unlike = along->summary.spacing_m / summary->spacing_m;
    surface_set_lay(summary, sqrt(along->summary.roughness.m2 / summary->roughness.m2), "along");
    if (!(fabs(log(unlike)) < 0.1))
        note_add(&summary->notes, NULL, "note.along\ntimes %.3g", unlike);
    along->summary.notes = (struct note_list){0}; /* they are the surface's now */
    if (maps || !wants_strips(task->scene) || task->scene->counterface_surface.files.count > 0)
        return STATUS_OK;
    if (!(record->flatter = malloc(sizeof *record->flatter)))
        return status_memory(status);
    *record->flatter = *along;
    *along = (struct surface_record){.flatter = NULL};
    return surface_read_members(record->flatter, other->scans, task->scene, status);
}

/** Finds r from the scans in the other direction, which are read like the first. */
static enum status_code take_along(const struct surface_scans *task, struct hash *hash, struct status *status)
{
    struct surface_record *record = task->record;
    const struct scene_surface *surface = record->summary.scene;
    struct scene_surface others = *surface;
    struct surface_record along = {.ensemble = {.keeps_heights = record->ensemble.keeps_heights}};
    OWNED(power_law_scans_free) struct power_law_scans scans = {0};
    struct status problem = {0};
    const struct surface_scans other = {&along, &scans, task->scene, task->copies};
    tell(&along.summary, &record->summary);
    others.files = others.along;
    along.summary.scene = &others;
    enum status_code rc = surface_files_read(&other, hash, &problem);
    along.summary.scene = surface;
    tell(&record->summary, &along.summary);
    if (rc == STATUS_OK && along.summary.scans == 0)
        rc = status_fail(&problem, STATUS_SCAN, "its scans are those of 'file'; name others, or leave it out");
    if (rc == STATUS_OK)
        rc = place_along(task, &other, &problem);
    along.summary.notes = (struct note_list){0};
    surface_record_free(&along);
    return rc == STATUS_OK ? STATUS_OK : status_fail(status, rc, "along: %s", problem.message);
}

static enum status_code find_lay(const struct surface_scans *task, struct hash *hash, struct status *status)
{
    struct surface_summary *summary = &task->record->summary;
    const struct scene_surface *surface = summary->scene;
    const struct scene *scene = task->scene;
    if (surface->along.count > 0)
        return take_along(task, hash, status);
    if (surface->lay_given || (scene->lay_given && !summary->has_lay))
        surface_set_lay(summary, surface->lay_given ? surface->lay : scene->lay, "given");
    return STATUS_OK;
}

static void stretch_member(struct member *member, double kappa)
{
    member->spectrum.length_m /= kappa;
    member->spacing_m /= kappa;
    member->roughness.m2 *= pow(kappa, 2);
    member->roughness.m4_per_m2 *= pow(kappa, 4);
}

/** Turns a surface with a lay into the isotropic one of the same mean-square gradient, for the models (equations: lay).
 * The numbers that describe the scans stay as measured. */
static void stretch(struct surface_record *record, double kappa)
{
    record->spectrum.length_m /= kappa;
    record->strips.rows.spacing_m /= kappa;
    record->summary.tail.wavelength_m /= kappa;
    record->summary.asperities.density_per_m2 *= pow(kappa, 2);
    record->summary.asperities.radius_m /= pow(kappa, 2);
    for (size_t p = 0; p < record->ensemble.count; p++)
        stretch_member(&record->ensemble.members[p], kappa);
    for (int variant = 0; variant < VARIANT_COUNT; variant++)
        stretch_member(&record->variants.of[variant], kappa);
}

/** Approximate cost of the strips, in pairs of transforms times points: all rows joined, and each alone, or the
 * quarters of a single scan. */
static double cost_of_strips(const struct surface_record *record)
{
    const struct strip_rows *rows = &record->strips.rows,
                            one = {NULL, 1, rows->points, rows->spacing_m, rows->periodic, NULL, 0};
    const double quarters = 0.35; /* they have two strips at nine loads, the whole has three at seventeen */
    double alone = record->ensemble.count > 1 ? (double)rows->rows * (double)strip_cost(&one) : 0,
           flatter = record->flatter ? (double)strip_cost(&record->flatter->strips.rows) : 0;
    return (double)strip_cost(rows) * (record->summary.single_points > 0 ? 1 + quarters : 1) + alone + flatter;
}

/** Describes the surface once all scans are read. */
static enum status_code conclude(struct surface_record *record, struct power_law_scans *scans,
                                 const struct scene *scene, const struct surface_record *counterface,
                                 struct status *status)
{
    struct surface_summary *summary = &record->summary;
    if (counterface && (strips_pair(&record->strips, &record->ensemble, &counterface->strips, &counterface->ensemble,
                                    status) != STATUS_OK ||
                        surface_read_counterface(record, scans, counterface, status) != STATUS_OK))
        return status->code;
    if (summary->scene != &scene->counterface_surface &&
        (record->ensemble.scan_count > 1 || (counterface && !counterface->height_m))) {
        free(record->height_m); /* the scatter of several scans needs no simulated records */
        record->height_m = NULL;
        summary->single_points = 0;
    }
    if (counterface && wants_strips(scene) && counterface->strips.rows.rows == 0)
        note_add(&summary->notes, NULL, "note.unlike\ncounterface");
    summary->has_strips = record->strips.rows.rows > 0;
    summary->strip_cost = summary->has_strips ? cost_of_strips(record) : 0;
    if (counterface)
        tiles_pair(&record->tiles, &counterface->tiles);
    if (summary->has_map && !record->tiles.height_m && summary->scene != &scene->counterface_surface &&
        (scene->models & model_flagged(offsetof(struct model_row, uses_map))))
        note_add(&summary->notes, NULL, "note.no_square");
    bool capped = summary->pair.hardness_Pa > 0;
    double most = scene->models_named ? INFINITY : tiles_budget / (double)scene->surface_count;
    const double missing = tiles_missing(&record->tiles);
    if (missing > 0)
        note_add(&summary->notes, NULL, "note.holes\n%s\npercent %.2g", missing > DIRECT_MAP_HOLES ? "much" : "",
                 100 * missing);
    if (missing > DIRECT_MAP_HOLES)
        tiles_free(&record->tiles);
    summary->has_tiles = tiles_fit(&record->tiles, capped, most);
    summary->tile_cost = tiles_cost(&record->tiles, capped);
    if (describe(record, scans, scene, status) != STATUS_OK)
        return status->code;
    record->ensemble.sigma_m = sqrt(summary->roughness.m0_m2);
    if (repeats_compare(&summary->repeats, &record->ensemble, &record->spectrum, status) != STATUS_OK)
        return status->code;
    bool found = scene->fit == POWER_LAW_AUTO && record->band->law >= POWER_LAW_BAND_NARROW;
    if (found && !counterface && fit_alone(record, scans, scene, status) != STATUS_OK)
        return status->code;
    double kappa = surface_kappa(summary);
    if (!summary->has_map)
        summary->measured = (struct areal_parameters){NAN, NAN, NAN, NAN, NAN, NAN};
    const double rq_m = summary->roughness.rq_m;
    summary->rough = (struct cmy){sqrt(rq_m * rq_m + summary->between_m2), kappa * cmy_slope(summary->roughness.m2)};
    stretch(record, kappa);
    if (record->flatter) /* by sqrt((1 + 1/r²)/2), to the same mean-square gradient */
        stretch(record->flatter, kappa / summary->lay);
    return STATUS_OK;
}

static const double usual_area = 0.01; /* A/A_n at which spots are considered if the scene has no operating load */

/** The contact has the plating's hardness if the plating is thicker than the indents are deep and the other body is not
 * softer and bare. A hardness given in the scene goes first. */
static void find_plating_hardness(struct surface_summary *summary, const struct cmy *surface, double load,
                                  const struct scene *scene)
{
    const struct scene_bodies *bodies = &summary->scene->bodies;
    const struct joint *joint = &scene->joint;
    double own_Pa = joint_platings[joint->plating].hardness_Pa, other_Pa = INFINITY,
           pressure_Pa = material_pair_pressure(&summary->pair, load);
    summary->hardness = bodies->hardness_Pa > 0 ? SURFACE_HARDNESS_SCENE : SURFACE_HARDNESS_BODIES;
    if (!joint->plating || bodies->hardness_Pa > 0)
        return;
    double indent_m = cmy_indent_m(surface, load > 0 ? pressure_Pa / own_Pa : usual_area);
    if (bodies->counterface_kind == MATERIAL_COUNTERFACE_ELASTIC && !joint->both_plated)
        other_Pa = material_hardness(&bodies->counterface);
    if (joint->plating_thickness_m > indent_m && !isnan(other_Pa)) {
        summary->hardness = own_Pa < other_Pa ? SURFACE_HARDNESS_PLATING : SURFACE_HARDNESS_BODIES;
        summary->pair.hardness_Pa = fmin(own_Pa, other_Pa);
    }
}

/** Finds the hardness of a plating. Where hardness depends on size, all models but cmy get that of cmy's spots at the
 * operating load or, without one, at an area of 1 %. */
static void find_hardness(struct surface_record *record, const struct scene *scene)
{
    struct material_pair *pair = &record->summary.pair;
    const double c1 = pair->vickers_Pa, c2 = pair->vickers_exponent;
    const struct cmy surface = record->summary.rough;
    double load = scene_load_of(&scene->operating, scene, pair), own_Pa = NAN;
    if (!pair->unknown)
        find_plating_hardness(&record->summary, &surface, load, scene);
    if (!(c1 > 0 && surface.sigma_m > 0))
        return;
    if (load > 0)
        own_Pa = cmy_microhardness(&surface, material_pair_pressure(pair, load), c1, c2);
    pair->hardness_Pa = own_Pa > 0 ? own_Pa : cmy_spot_hardness(&surface, usual_area, c1, c2);
    note_add(&record->summary.notes, NULL, "note.hardness\nothers %.4g\n%s", pair->hardness_Pa * 1e-6,
             own_Pa > 0 ? "loaded" : "");
}

enum status_code surface_read(struct surface_record *out, const struct scene *scene,
                              const struct scene_surface *surface, const struct surface_record *counterface,
                              struct status *status)
{
    struct surface_summary *summary = &out->summary;
    struct status problem = {0};
    struct hash hash = hash_start();
    struct power_law_scans scans = {0};
    OWNED(copies_free) struct copies copies = {0};
    const struct surface_scans task = {out, &scans, scene, &copies};
    out->counterface = counterface;
    summary->scene = surface;
    summary->pair = scene_pair(&surface->bodies);
    out->ensemble.keeps_heights = wants_strips(scene);
    enum status_code rc = surface_files_read(&task, &hash, &problem);
    if (rc == STATUS_OK && surface != &scene->counterface_surface) /* the counterface has the surface's lay */
        rc = find_lay(&task, &hash, &problem);
    hash_finish(&hash, summary->hash);
    if (rc == STATUS_OK)
        rc = surface_read_members(out, &scans, scene, &problem);
    if (rc == STATUS_OK)
        rc = conclude(out, &scans, scene, counterface, &problem);
    power_law_scans_free(&scans);
    if (rc == STATUS_MEMORY && status_memory(status))
        return surface_put_aside(out, scene, status);
    if (rc == STATUS_OK && surface != &scene->counterface_surface)
        find_hardness(out, scene);
    summary->usable = rc == STATUS_OK;
    if (!summary->usable && !(summary->refusal = strdup(problem.message)))
        return status_memory(status);
    return STATUS_OK;
}
