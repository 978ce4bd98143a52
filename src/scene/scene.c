/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/scene.h"
#include "joint/electron.h"
#include "scene/plan.h"
#include "scene/scene_source.h"

#include <errno.h>
#include <libgen.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static struct scene default_scene(void)
{
    return (struct scene){
        .models = model_defaults(),
        .effects_auto = true,
        .bodies = {.material = material_unknown(""),
                   .counterface_kind = MATERIAL_COUNTERFACE_RIGID,
                   .counterface = material_unknown(""),
                   .hardness_Pa = NAN},
        .nominal_area_m2 = NAN,
        .load = {.from = 1e-6, .to = 0.1, .points = 121, .kind = UNIT_NUMBER},
        .tolerance = 1e-6,
        .accuracy = NAN,
        .level = LEVEL_LINE,
        .max_missing = 0.1,
        .window = SPECTRUM_WINDOW_AUTO,
        .fit_band_m = {0.0, INFINITY},
        .moments = ROUGHNESS_MOMENTS_DIFFERENCE,
        .closure = SINUSOID_FIT_THESIS,
        .convergence = {.alpha = 0.085, .gamma = 1.5, .load = 1e-3, .scan_length_m = 3e-4, .scales = 4096},
        .direct = {.hardness_Pa = NAN, .kind = UNIT_NUMBER},
        .joint = joint_default(),
    };
}

bool scene_bins_spectra(const struct scene *scene)
{
    return !scene->exports && scene->surface_count > SCENE_DATA_SURFACES;
}

/* Reads scene.yaml; without one, scene->path goes. A dangling link of that name is an error, not an absence. */
static enum status_code load_text(struct text *bytes, struct scene *scene, struct status *status)
{
    struct stat info;
    if (lstat(scene->path, &info) != 0 && errno == ENOENT) {
        free(scene->path);
        scene->path = NULL;
        return STATUS_OK;
    }
    if (stat(scene->path, &info) != 0)
        return status_fail(status, STATUS_IO, "cannot open '%s': %s", scene->path, strerror(errno));
    if (!S_ISREG(info.st_mode))
        return status_fail(status, STATUS_SCENE, "'%s' is no regular file; remove it", scene->path);
    if (info.st_size > SCENE_BYTES_MOST)
        return status_fail(status, STATUS_SCENE, "'%s' is larger than 1 MiB; a scene is a few lines of text",
                           scene->path);
    return text_read_file(bytes, scene->path, status);
}

/* Effect `effect`, asked for in the scene or else by the command line, lacks `what`. */
static bool fail_effect(struct scene_source *source, const struct effect_row *effect, const char *what)
{
    if (!source->effects_overridden)
        return scene_source_fail(source, scene_keys_line(source, "effects"),
                                 "effect '%s' needs %s or leave the effect out", effect->name, what);
    (void)status_fail(source->status, STATUS_SCENE, "--effects: '%s' needs %s in scene.yaml, or leave the effect out",
                      effect->name, what);
    return false;
}

/* Effects run that a key calls for, unless the command line lists others; none runs without its key. */
static bool call_effects(struct scene *scene, struct scene_source *source)
{
    for (int i = 0; i < EFFECT_COUNT; i++) {
        const struct effect_row *row = &effect_rows[i];
        unsigned bit = EFFECT_BIT(i);
        char what[80];
        bool given = row->key && scene_keys_line(source, row->key) > 0;
        snprintf(what, sizeof what, "'%s'; add that key", row->key ? row->key : "");
        if (row->key && !given && (scene->effects & bit))
            return fail_effect(source, row, what);
        if (!given || row->only_listed ||
            (source->effects_overridden && !scene->effects_auto && !(scene->effects & bit)))
            continue;
        scene->called |= bit;
        if (!scene->effects_auto)
            scene->effects = scene_keys_with_needed(scene->effects | bit);
    }
    return true;
}

/* What the command line says instead of the scene; units once the surfaces are known. */
static bool override_values(struct scene *scene, struct scene_source *source, const struct scene_overrides *overrides)
{
    const struct {
        const char *key, *text;
    } all[] = {{"material", overrides->material},
               {"effects", overrides->effects},
               {"tolerance", overrides->tolerance},
               {"accuracy", overrides->accuracy},
               {"export", overrides->exports}};
    for (size_t i = 0; i < SCENE_COUNT(all); i++)
        for (size_t k = 0; k < scene_key_count && all[i].text; k++)
            if (strcmp(scene_keys[k].name, all[i].key) == 0 &&
                !scene_source_option(source, &scene_keys[k], all[i].key, all[i].text, scene))
                return false;
    if (overrides->budget &&
        !scene_source_option(source, scene_budget_key, "budget", overrides->budget, &scene->direct))
        return false;
    unsigned direct = EFFECT_BIT(EFFECT_DIRECT);
    if (source->effects_overridden && !scene->effects_auto) /* as they are listed there */
        scene->direct.called = scene->effects & direct;
    scene->direct.called = scene->direct.called || overrides->direct || overrides->budget || (scene->effects & direct);
    scene->effects |= scene->direct.called ? direct : 0;
    return scene_shape_size(scene, source) && call_effects(scene, source);
}

static bool override_units(struct scene *scene, struct scene_source *source, const struct scene_overrides *overrides)
{
    const struct scene_key key = {"unit", NULL, SCENE_SHORT_TEXT(0, sizeof scene->surfaces->x_unit)};
    for (size_t i = 0; i <= scene->surface_count; i++) {
        struct scene_surface *surface = i ? &scene->surfaces[i - 1] : &scene->counterface_surface;
        if ((overrides->x_unit && !scene_source_option(source, &key, "x-unit", overrides->x_unit, surface->x_unit)) ||
            (overrides->z_unit && !scene_source_option(source, &key, "z-unit", overrides->z_unit, surface->z_unit)))
            return false;
    }
    return true;
}

/* Fails when the bodies of surface `owner` (NULL: the scene) lack what an effect needs that is asked for by name. */
static bool check_effects(const struct scene *scene, struct scene_source *source, const struct scene_bodies *bodies,
                          const char *owner)
{
    struct scene_lack_words lack;
    for (int i = 0; i < EFFECT_COUNT; i++)
        if ((scene->effects & EFFECT_BIT(i)) && scene_lack_words(&lack, bodies, owner, &effect_rows[i]))
            return fail_effect(source, &effect_rows[i], lack.text);
    return true;
}

/* What some keys say beyond themselves. */
static void complete_keys(struct scene *scene, const struct scene_source *source)
{
    bool band = scene_keys_line(source, "fit_band") > 0;
    scene->lay_given = scene_keys_line(source, "lay") > 0;
    scene->level_given = scene_keys_line(source, "level") > 0;
    scene->fit_band_given = band && (scene->fit_band_m[0] > 0 || isfinite(scene->fit_band_m[1]));
    if (!band) /* what the filters leave */
        scene->fit_band_m[0] = scene->lambda_s_m;
    if (!band && scene->lambda_c_m > 0)
        scene->fit_band_m[1] = scene->lambda_c_m;
}

/* One body's mean free path, unless it has one. */
static bool give_mean_free_path(struct material *material, const struct scene *scene, struct scene_source *source)
{
    if (scene->mean_free_path == SCENE_MEAN_FREE_PATH_THESIS || !isnan(material->mean_free_path_m) ||
        isnan(material->youngs_modulus_Pa))
        return true;
    if (material->electrons_per_m3 > 0 && material->resistivity_ohm_m > 0) {
        material->mean_free_path_m = electron_mean_free_path(material->electrons_per_m3, material->resistivity_ohm_m);
        return true;
    }
    return scene_source_fail(
        source, scene_keys_line(source, "mean_free_path"),
        "'mean_free_path' is 'electron', which is not known of '%s'; give the material's own, such as 40 nm",
        scene_words_show(material->name).text);
}

/* Completes bodies with the scene's, and checks them. `owner`: the surface's name, NULL: the scene's own. */
static bool complete_bodies(struct scene_bodies *bodies, const struct scene *scene, struct scene_source *source,
                            const char *owner)
{
    const struct scene_bodies *whole = &scene->bodies;
    if (!bodies->material_given)
        bodies->material = whole->material;
    if (!bodies->counterface_given) {
        bodies->counterface_kind = whole->counterface_kind;
        bodies->counterface_same = whole->counterface_same;
        bodies->counterface = whole->counterface;
    }
    if (!(bodies->hardness_Pa > 0)) {
        bodies->hardness_Pa = whole->hardness_Pa;
        bodies->hardness_exponent = whole->hardness_exponent;
    }
    if (bodies->counterface_same)
        bodies->counterface = bodies->material;
    bool elastic = bodies->counterface_kind == MATERIAL_COUNTERFACE_ELASTIC;
    if (isnan(bodies->material.youngs_modulus_Pa) && elastic && !bodies->counterface_same)
        return scene_source_fail(source, bodies->counterface_line ? bodies->counterface_line : whole->counterface_line,
                                 "'counterface' is '%s', but no material is given to press it on; add 'material'",
                                 scene_words_show(bodies->counterface.name).text);
    return check_effects(scene, source, bodies, owner) && give_mean_free_path(&bodies->material, scene, source) &&
           (!elastic || give_mean_free_path(&bodies->counterface, scene, source));
}

/* The bodies of every surface; the scene's own count where a surface uses them. */
static bool complete_all_bodies(struct scene *scene, struct scene_source *source)
{
    bool used = scene->surface_count == 0, known = !isnan(scene->bodies.material.youngs_modulus_Pa);
    for (size_t i = 0; i < scene->surface_count; i++)
        used = used || !scene->surfaces[i].bodies.material_given;
    if (used && !complete_bodies(&scene->bodies, scene, source, NULL))
        return false;
    for (size_t i = 0; i < scene->surface_count; i++) {
        struct scene_surface *surface = &scene->surfaces[i];
        if (!complete_bodies(&surface->bodies, scene, source, surface->name))
            return false;
        known = known || !isnan(surface->bodies.material.youngs_modulus_Pa);
    }
    size_t lines[SCENE_KEYS_MOST]; /* with what is known from elsewhere */
    for (size_t k = 0; k < scene_key_count; k++) {
        lines[k] = source->lines[k];
        if (strcmp(scene_keys[k].name, "material") == 0)
            lines[k] = known;
        if (strcmp(scene_keys[k].name, "nominal_area") == 0)
            lines[k] = scene->nominal_area_m2 > 0;
    }
    return scene_source_rules(source, &scene_keys_whole, lines, 0, scene);
}

/* Can loads of that kind be turned into P/(A_n E') on every surface? */
static bool check_load_kind(const struct scene *scene, struct scene_source *source, const char *key,
                            enum unit_quantity kind, size_t line)
{
    bool known = true;
    for (size_t i = 0; i == 0 || i < scene->surface_count; i++)
        known = known && !isnan(scene_bodies_of(scene, i)->material.youngs_modulus_Pa);
    if (kind == UNIT_FORCE && isnan(scene->nominal_area_m2))
        return scene_source_fail(source, line, "'%s' is a force, but on which area? add 'nominal_area'", key);
    return kind == UNIT_NUMBER || known ||
           scene_source_fail(source, line,
                             "'%s' is %s, which without a material is no P/(A_n E'); add 'material', or give "
                             "P/(A_n E')",
                             key, unit_quantity_name(kind));
}

/* Is E' the same for all surfaces? */
static bool has_one_modulus(const struct scene *scene)
{
    for (size_t i = 1; i < scene->surface_count; i++)
        if (scene_pair(&scene->surfaces[i].bodies).effective_modulus_Pa !=
            scene_pair(&scene->surfaces[0].bodies).effective_modulus_Pa)
            return false;
    return true;
}

/* P/(A_n E'), to which loads go by themselves. */
static const double least_by_itself = 1e-12;

/* The loads reach a decade beyond it where the scene leaves them to the program. */
static bool check_one_load(const struct scene_one_load *one, const char *key, struct scene *scene,
                           struct scene_source *source)
{
    size_t line = scene_keys_line(source, key);
    struct scene_load *load = &scene->load;
    double least = load->from, most = load->to;
    for (size_t i = 0; load->values && i < load->points; i++) {
        least = i == 0 ? load->values[i] : fmin(least, load->values[i]);
        most = i == 0 ? load->values[i] : fmax(most, load->values[i]);
    }
    if (one->load == 0)
        return true;
    if (!check_load_kind(scene, source, key, one->kind, line))
        return false;
    if ((one->kind == UNIT_NUMBER) != (load->kind == UNIT_NUMBER) && !has_one_modulus(scene))
        return scene_source_fail(
            source, line, "'%s' is %s and the loads are %s, which differ from material to material; give both alike",
            key, unit_quantity_name(one->kind),
            load->kind == UNIT_NUMBER ? "P/(A_n E')" : unit_quantity_name(load->kind));
    struct material_pair pair = scene_pair(scene_bodies_of(scene, 0));
    double value = scene_load_as(one, scene, &pair);
    if (!load->given && value >= least_by_itself && value <= 1) {
        load->from = least = fmin(least, value / 10);
        load->to = most = fmax(most, fmin(10 * value, 1));
    }
    return (value >= least && value <= most) ||
           scene_source_fail(source, line, "'%s' is %g%s%s, outside the loads, %g to %g", key, value,
                             load->kind == UNIT_NUMBER ? "" : " ", unit_si(load->kind), least, most);
}

/* Where the scene gives no loads, tables and charts stand in the unit of the operating load. */
static void take_load_unit(struct scene_load *load, const struct scene_one_load *operating)
{
    if (load->given || !operating->unit_text[0])
        return;
    load->unit = operating->unit;
    strcpy(load->unit_text, operating->unit_text);
}

static bool check_loads(struct scene *scene, struct scene_source *source)
{
    take_load_unit(&scene->load, &scene->operating);
    return check_load_kind(scene, source, "load", scene->load.kind, scene_keys_line(source, "load")) &&
           check_load_kind(scene, source, "loads", scene->direct.kind, scene_keys_line(source, "direct")) &&
           check_one_load(&scene->operating, "operating_load", scene, source);
}

static bool check_template(const struct scene *scene, struct scene_source *source)
{
    char *path = scene->template ? scene_file_path(scene, scene->template) : NULL;
    bool good = !scene->template || (path && access(path, R_OK) == 0);
    free(path);
    return good || scene_source_fail(source, scene_keys_line(source, "template"), "cannot read the template '%s': %s",
                                     scene_words_show(scene->template).text, strerror(errno));
}

static bool check_baseline(const struct scene *scene, struct scene_source *source)
{
    if (!scene->baseline || scene->surface_count == 0)
        return true;
    for (size_t i = 0; i < scene->surface_count; i++)
        if (strcmp(scene->surfaces[i].name, scene->baseline) == 0)
            return true;
    return scene_source_fail(source, scene_keys_line(source, "baseline"),
                             "'baseline' is '%s', no surface's name; the first is '%s'",
                             scene_words_show(scene->baseline).text, scene_words_show(scene->surfaces[0].name).text);
}

static bool check_left(const struct scene *scene, struct scene_source *source)
{
    const char *key = scene->counterface_surface.files.count > 0 ? "counterface" : "measured";
    if (scene->surface_count > 0 || scene->counterface_surface.files.count + scene->measured.files.count == 0)
        return true;
    return scene_source_fail(source, scene_keys_line(source, key),
                             "no scan is left for the surfaces beside the files of '%s'", key);
}

static enum status_code complete(struct scene *scene, struct scene_source *source,
                                 const struct scene_overrides *overrides)
{
    struct status *status = source->status;
    complete_keys(scene, source);
    if (!override_values(scene, source, overrides) ||
        (scene->surface_count == 0 && scene_files_list(scene, status) != STATUS_OK) ||
        !complete_all_bodies(scene, source) || !scene_shape_complete(scene, source) || !check_loads(scene, source) ||
        !scene_asked_complete(scene, source) || !override_units(scene, source, overrides) ||
        !check_left(scene, source) || !check_baseline(scene, source) || !check_template(scene, source))
        return status->code;
    char *path = realpath(scene->directory, NULL); /* the directory's own name, however it is given */
    if (!scene->title)
        scene->title = strdup(path ? basename(path) : scene->directory);
    free(path);
    return scene->title ? STATUS_OK : status_memory(status);
}

enum status_code scene_read(struct scene *out, const char *directory, const struct scene_overrides *overrides,
                            struct status *status)
{
    static const struct scene_overrides nothing = {0};
    const struct scene_overrides *over = overrides ? overrides : &nothing;
    struct scene_source source = {.scene = out, .status = status, .whole = &scene_keys_whole};
    struct text loaded = {0};
    struct stat info;
    bool good = false;
    *out = default_scene();
    if (stat(directory, &info) != 0)
        return status_fail(status, STATUS_IO, "cannot open directory '%s': %s", directory, strerror(errno));
    if (!S_ISDIR(info.st_mode))
        return status_fail(status, STATUS_IO, "'%s' is no directory; name the one that holds the scans", directory);
    out->directory = strdup(directory);
    out->path = out->directory ? scene_file_path(out, "scene.yaml") : NULL;
    if (!out->path)
        return status_memory(status);
    const struct text *text = over->text ? over->text : &loaded;
    if ((over->text || load_text(&loaded, out, status) == STATUS_OK) &&
        (!out->path || scene_source_read(&source, text_string(text), text->length)))
        good = complete(out, &source, over) == STATUS_OK;
    if (good && out->accuracy > 0)
        plan_choose_model(out);
    text_free(&loaded);
    return status->code;
}

void scene_free(struct scene *scene)
{
    for (size_t i = 0; i < scene->surface_count; i++)
        scene_surfaces_free(&scene->surfaces[i]);
    free(scene->surfaces);
    scene_surfaces_free(&scene->counterface_surface);
    scene_files_free(&scene->measured.files);
    scene_shape_free(scene);
    free(scene->targets);
    free(scene->limits);
    free(scene->load.values);
    free(scene->direct.values);
    free(scene->template);
    free(scene->baseline);
    free(scene->exports);
    free(scene->passed_over);
    free(scene->title);
    free(scene->path);
    free(scene->directory);
    *scene = (struct scene){0};
}
