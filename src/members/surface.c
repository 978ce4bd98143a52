/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "members/surface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

double surface_short_gamma(const struct power_law *law)
{
    return isfinite(law->knee_m) ? law->gamma_below : law->gamma;
}

bool surface_tells_gamma(const struct surface_summary *summary)
{
    const struct power_law *law = &summary->power_law;
    double known_m = summary->length_m / (double)summary->tail.count;
    return power_law_holds(law) && (isnan(law->knee_m) || known_m <= law->band_m[0] * (1 + 1e-9));
}

bool surface_diverges(const struct surface_summary *summary)
{
    const struct power_law *law = &summary->power_law;
    return surface_tells_gamma(summary) && surface_short_gamma(law) + law->gamma_error < 1;
}

const struct curve_summary *surface_model(const struct surface_summary *summary, size_t m)
{
    static const struct curve_summary none;
    return summary->models && summary->models[m] ? summary->models[m] : &none;
}

struct curve_summary *surface_model_room(struct surface_summary *summary, size_t m)
{
    if (!summary->models && !(summary->models = calloc(model_count, sizeof *summary->models)))
        return NULL;
    if (!summary->models[m])
        summary->models[m] = calloc(1, sizeof *summary->models[m]);
    return summary->models[m];
}

struct model_task surface_model_task(const struct surface_record *record, const struct surface_task *asked)
{
    const struct scene *scene = asked->scene;
    const struct surface_record *flatter = record->flatter;
    return (struct model_task){
        .spectrum = &record->spectrum,
        .rough = record->summary.rough,
        .asperities = record->summary.has_asperities ? &record->summary.asperities : NULL,
        .pair = &record->summary.pair,
        .loads = asked->loads,
        .load_count = asked->load_count,
        .operating_place = asked->plan->operating_place,
        .wanted = asked->plan->wanted,
        .tolerance = scene->tolerance,
        .sinusoid_fit = scene->closure,
        .hardness_Pa = record->summary.pair.hardness_Pa,
        .open = record->summary.periodic < record->summary.scans,
        .levelled = scene->level >= LEVEL_LINE && (scene->level_given || record->summary.periodic == 0) &&
                    !(scene->lambda_c_m > 0),
        .strip = record->strips.joined ? &record->strips.joined->strip : NULL,
        .bearing = record->strips.joined ? &record->strips.joined->bearing : NULL,
        .prepared = &record->strips.prepared,
        .transfer = record->tiles.transfer,
        .two_directions = surface_knows_both(&record->summary),
        .flatter = flatter && flatter->strips.joined
                       ? (struct model_strips){&flatter->spectrum, &flatter->strips.joined->strip,
                                               &flatter->strips.joined->bearing, &flatter->strips.prepared}
                       : (struct model_strips){NULL},
    };
}

void surface_set_lay(struct surface_summary *summary, double lay, const char *from)
{
    summary->has_lay = isfinite(lay);
    summary->lay = lay;
    if (summary->has_lay && lay > 1.5)
        note_add(&summary->notes, NULL, "note.lay\ntimes %.3g\n%s", lay, from);
}

bool surface_knows_both(const struct surface_summary *summary)
{
    return summary->has_lay && summary->lay <= 1 && summary->scans > 1;
}

double surface_kappa(const struct surface_summary *summary)
{
    return summary->has_lay ? sqrt((1 + summary->lay * summary->lay) / 2) : 1;
}

struct joint_task surface_joint(const struct surface_record *record, const struct scene *scene, const struct plan *plan,
                                const struct model_task *task)
{
    return (struct joint_task){&scene->joint,          task->pair,    record->summary.asperities.sigma_m,
                               scene->nominal_area_m2, plan->running, task->tolerance,
                               record->shapes};
}

void surface_drop_scans(struct surface_record *record)
{
    ensemble_free(&record->ensemble);
    free(record->height_m);
    record->height_m = NULL;
}

void surface_drop_arrays(struct surface_record *record)
{
    for (size_t m = 0; m < model_count; m++) {
        if (record->curves)
            free(record->curves[m].points);
        if (record->bands)
            free(record->bands[m]);
        if (record->shapes)
            joint_shape_free(&record->shapes[m]);
    }
    surface_drop_scans(record);
    spectrum_free(&record->spectrum);
    spectrum_free(&record->typical);
    spectrum_free(&record->tapered);
    variants_free(&record->variants);
    strips_free(&record->strips);
    if (record->flatter)
        surface_record_free(record->flatter);
    free(record->flatter);
    tiles_free(&record->tiles);
    map_contact_free(&record->contact);
    free(record->curves);
    free(record->bands);
    free(record->shapes);
    free(record->direct_m);
    free(record->band);
    free(record->preview_x_m);
    free(record->preview_z_m);
    *record = (struct surface_record){.summary = record->summary};
}

void surface_record_free(struct surface_record *record)
{
    struct surface_summary *summary = &record->summary;
    surface_drop_arrays(record);
    for (size_t m = 0; summary->models && m < model_count; m++)
        if (summary->models[m]) {
            free(summary->models[m]->estimates);
            free(summary->models[m]);
        }
    free(summary->models);
    free(summary->refusal);
    note_list_free(&summary->notes);
    free(summary->direct);
    free(summary->answers);
    free(summary->limits);
    *summary = (struct surface_summary){0};
}

enum status_code surface_put_aside(struct surface_record *record, const struct scene *scene, struct status *status)
{
    struct surface_summary kept = {.scene = record->summary.scene, .pair = record->summary.pair};
    if (scene->surface_count == 1 || kept.scene == &scene->counterface_surface ||
        !(kept.refusal = strdup("out of memory; thin its scans, or report it alone")))
        return status->code;
    memcpy(kept.hash, record->summary.hash, sizeof kept.hash);
    surface_record_free(record);
    record->summary = kept;
    *status = (struct status){0};
    return STATUS_OK;
}
