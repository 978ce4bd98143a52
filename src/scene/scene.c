/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/scene.h"
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

/* Reads scene.yaml; if there is none, scene->path becomes NULL. A dangling link of that name is an error. */
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

/* Fails as an effect, listed in the scene or on the command line, lacks `what`. */
static void fail_effect(struct scene_source *source, const struct effect_row *effect, const char *what)
{
    if (!source->effects_overridden)
        FAIL_KEY(source, "effects", "effect '%s' needs %s or leave the effect out", effect->name, what);
    else
        (void)status_fail(source->status, STATUS_SCENE,
                          "--effects: '%s' needs %s in scene.yaml, or leave the effect out", effect->name, what);
}

/* ---- Steps that complete a scene once its keys are read; each uses those before it, the first failure ends them */

static void complete_keys(struct scene *scene, struct scene_source *source)
{
    (void)source;
    if (!scene->fit_band_given) { /* between the filters */
        scene->fit_band_m[0] = scene->lambda_s_m;
        scene->fit_band_m[1] = scene->lambda_c_m > 0 ? scene->lambda_c_m : INFINITY;
    } else
        scene->fit_band_given = scene->fit_band_m[0] > 0 || isfinite(scene->fit_band_m[1]);
}

/* Options of the command line; units follow once the surfaces are known. */
static void override_values(struct scene *scene, struct scene_source *source)
{
    const struct scene_overrides *overrides = source->overrides;
    const char *const all[][2] = {{"material", overrides->material},
                                  {"effects", overrides->effects},
                                  {"tolerance", overrides->tolerance},
                                  {"accuracy", overrides->accuracy},
                                  {"export", overrides->exports}};
    for (size_t i = 0; i < SCENE_COUNT(all); i++)
        if (all[i][1])
            scene_source_option(source, &scene_keys[scene_keys_find(all[i][0])], all[i][0], all[i][1], scene);
    if (overrides->budget)
        scene_source_option(source, scene_budget_key, "budget", overrides->budget, &scene->direct);
    unsigned direct = EFFECT_BIT(EFFECT_DIRECT);
    if (source->effects_overridden && !scene->effects_auto) /* only as listed there */
        scene->direct.called = scene->effects & direct;
    scene->direct.called = scene->direct.called || overrides->direct || overrides->budget || (scene->effects & direct);
    scene->effects |= scene->direct.called ? direct : 0;
}

/* Effects run whose key is given, unless the command line lists others; none runs without its key. */
static void call_effects(struct scene *scene, struct scene_source *source)
{
    for (int i = 0; i < EFFECT_COUNT; i++) {
        const struct effect_row *row = &effect_rows[i];
        const unsigned bit = EFFECT_BIT(i);
        const bool given = row->key && scene_keys_line(source, row->key) > 0,
                   left_out = source->effects_overridden && !scene->effects_auto && !(scene->effects & bit);
        char what[80];
        snprintf(what, sizeof what, "'%s'; add that key", row->key ? row->key : "");
        if (row->key && !given && (scene->effects & bit))
            fail_effect(source, row, what);
        if (!given || row->only_listed || left_out)
            continue;
        scene->called |= bit;
        if (!scene->effects_auto)
            scene->effects = scene_keys_with_needed(scene->effects | bit);
    }
}

/* Sets a body's mean free path, unless it has one. */
static void give_mean_free_path(struct material *material, const struct scene *scene, struct scene_source *source)
{
    if (scene->mean_free_path == SCENE_MEAN_FREE_PATH_THESIS || !isnan(material->mean_free_path_m) ||
        isnan(material->youngs_modulus_Pa))
        return;
    if (material->electrons_per_m3 > 0 && material->resistivity_ohm_m > 0)
        material->mean_free_path_m = electron_mean_free_path(material->electrons_per_m3, material->resistivity_ohm_m);
    else
        FAIL_KEY(
            source, "mean_free_path",
            "'mean_free_path' is 'electron', but that of '%s' is not known; give the material's own, such as 40 nm",
            scene_words_show(material->name).text);
}

/* Completes bodies with the scene's and checks them. `owner`: the surface's name; NULL: the scene's own bodies. */
static void complete_bodies(struct scene_bodies *bodies, const struct scene *scene, struct scene_source *source,
                            const char *owner)
{
    const struct scene_bodies *whole = &scene->bodies;
    struct scene_lack_words lack;
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
        scene_source_fail(source, bodies->counterface_line ? bodies->counterface_line : whole->counterface_line,
                          "'counterface' is '%s', but no material is given to press it on; add 'material'",
                          scene_words_show(bodies->counterface.name).text);
    for (int i = 0; i < EFFECT_COUNT; i++) /* listed ones */
        if ((scene->effects & EFFECT_BIT(i)) && scene_lack_words(&lack, bodies, owner, &effect_rows[i]))
            fail_effect(source, &effect_rows[i], lack.text);
    give_mean_free_path(&bodies->material, scene, source);
    if (elastic)
        give_mean_free_path(&bodies->counterface, scene, source);
}

/* Completes the bodies of every surface, and the scene's where a surface uses them. */
static void complete_all_bodies(struct scene *scene, struct scene_source *source)
{
    bool used = scene->surface_count == 0;
    for (size_t i = 0; i < scene->surface_count; i++)
        used = used || !scene->surfaces[i].bodies.material_given;
    if (used)
        complete_bodies(&scene->bodies, scene, source, NULL);
    for (size_t i = 0; i < scene->surface_count; i++)
        complete_bodies(&scene->surfaces[i].bodies, scene, source, scene->surfaces[i].name);
}

/* Checks the rules of the scene's keys; surfaces may give the material, and `shape` the area. */
static void check_rules(struct scene *scene, struct scene_source *source)
{
    size_t lines[SCENE_KEYS_MOST];
    bool known = !isnan(scene->bodies.material.youngs_modulus_Pa);
    for (size_t i = 0; i < scene->surface_count; i++)
        known = known || !isnan(scene->surfaces[i].bodies.material.youngs_modulus_Pa);
    memcpy(lines, source->lines, sizeof lines);
    lines[scene_keys_find("material")] = known;
    lines[scene_keys_find("nominal_area")] = scene->nominal_area_m2 > 0;
    (void)scene_source_rules(source, &scene_keys_whole, lines, 0, scene);
}

/* Fails if loads of that kind cannot become P/(A_n E') on every surface. */
static void check_load_kind(const struct scene *scene, struct scene_source *source, const char *key, const char *in,
                            enum unit_quantity kind)
{
    bool known = true;
    for (size_t i = 0; i == 0 || i < scene->surface_count; i++)
        known = known && !isnan(scene_bodies_of(scene, i)->material.youngs_modulus_Pa);
    if (kind == UNIT_FORCE && isnan(scene->nominal_area_m2))
        FAIL_KEY(source, in, "'%s' is a force, but on which area? add 'nominal_area'", key);
    if (kind != UNIT_NUMBER && !known)
        FAIL_KEY(source, in,
                 "'%s' is %s, which without a material is no P/(A_n E'); add 'material', or give P/(A_n E')", key,
                 unit_quantity_name(kind));
}

bool scene_has_one_pair(const struct scene *scene, bool modulus_alone)
{
    const struct material_pair first = scene_pair(&scene->surfaces[0].bodies);
    bool one = true;
    for (size_t i = 1; i < scene->surface_count; i++) {
        const struct material_pair own = scene_pair(&scene->surfaces[i].bodies);
        const double apart =
            fmax(fmax(fabs(own.hardness_Pa - first.hardness_Pa), fabs(own.resistivity_ohm_m - first.resistivity_ohm_m)),
                 fabs(own.conductivity_W_per_mK - first.conductivity_W_per_mK));
        one = one && own.effective_modulus_Pa == first.effective_modulus_Pa && (modulus_alone || !(apart > 0));
    }
    return one;
}

static const double least_by_itself = 1e-12; /* P/(A_n E') of the program's own loads */

/* Without `load` the loads reach a decade beyond the operating one, whose unit tables and charts then have. */
static void check_loads(struct scene *scene, struct scene_source *source)
{
    static const char key[] = "operating_load";
    const struct scene_quantity *one = &scene->operating;
    struct scene_load *load = &scene->load;
    double least = load->from, most = load->to;
    if (!load->given && one->kind != UNIT_NUMBER) {
        load->unit = one->unit;
        strcpy(load->unit_text, one->text);
    }
    check_load_kind(scene, source, "load", "load", load->kind);
    check_load_kind(scene, source, "loads", "direct", scene->direct.kind);
    if (one->value == 0)
        return;
    for (size_t i = 0; load->values && i < load->points; i++) {
        least = i == 0 ? load->values[i] : fmin(least, load->values[i]);
        most = i == 0 ? load->values[i] : fmax(most, load->values[i]);
    }
    check_load_kind(scene, source, key, key, one->kind);
    if ((one->kind == UNIT_NUMBER) != (load->kind == UNIT_NUMBER) && !scene_has_one_pair(scene, true))
        FAIL_KEY(
            source, key,
            "'%s' is %s and the loads are %s, which differ from material to material; give both in one kind of unit",
            key, unit_quantity_name(one->kind),
            load->kind == UNIT_NUMBER ? "P/(A_n E')" : unit_quantity_name(load->kind));
    struct material_pair pair = scene_pair(scene_bodies_of(scene, 0));
    double value = scene_load_as(one, scene, &pair);
    if (!load->given && value >= least_by_itself && value <= 1) {
        load->from = least = fmin(least, value / 10);
        load->to = most = fmax(most, fmin(10 * value, 1));
    }
    if (!(value >= least && value <= most))
        FAIL_KEY(source, key, "'%s' is %g%s%s, outside the loads, %g to %g; correct it or 'load'", key, value,
                 load->kind == UNIT_NUMBER ? "" : " ", unit_si(load->kind), least, most);
}

static void override_units(struct scene *scene, struct scene_source *source)
{
    const struct scene_key key = {"unit", NULL, SCENE_SHORT_TEXT(0, sizeof scene->surfaces->x_unit)};
    const char *x_unit = source->overrides->x_unit, *z_unit = source->overrides->z_unit;
    for (size_t i = 0; i <= scene->surface_count; i++) {
        struct scene_surface *surface = i ? &scene->surfaces[i - 1] : &scene->counterface_surface;
        if (x_unit)
            scene_source_option(source, &key, "x-unit", x_unit, surface->x_unit);
        if (z_unit)
            scene_source_option(source, &key, "z-unit", z_unit, surface->z_unit);
    }
}

static void check_surfaces(struct scene *scene, struct scene_source *source)
{
    const char *key = scene->counterface_surface.files.count > 0 ? "counterface" : "measured";
    size_t count = scene->surface_count, i = 0;
    if (count == 0 && scene->counterface_surface.files.count + scene->measured.files.count > 0)
        FAIL_KEY(source, key, "no scan is left for the surfaces beside the files of '%s'", key);
    while (scene->baseline && i < count && strcmp(scene->surfaces[i].name, scene->baseline) != 0)
        i++;
    if (scene->baseline && count > 0 && i == count)
        FAIL_KEY(source, "baseline", "'baseline' is '%s', no surface's name; the first is '%s'",
                 scene_words_show(scene->baseline).text, scene_words_show(scene->surfaces[0].name).text);
}

static void check_template(struct scene *scene, struct scene_source *source)
{
    OWNED(memory_free) char *path = scene->template ? scene_file_path(scene, scene->template) : NULL;
    if (scene->template && (!path || access(path, R_OK) != 0))
        FAIL_KEY(source, "template", "cannot read the template '%s': %s", scene_words_show(scene->template).text,
                 strerror(errno));
}

static void give_title(struct scene *scene, struct scene_source *source)
{
    OWNED(memory_free) char *path = realpath(scene->directory, NULL); /* its own name, however it is given */
    if (!scene->title && !(scene->title = strdup(path ? basename(path) : scene->directory)))
        scene_source_memory(source);
}

static void (*const steps[])(struct scene *scene, struct scene_source *source) = {
    complete_keys,       override_values, scene_shape_size,     call_effects, scene_files_list,
    complete_all_bodies, check_rules,     scene_shape_complete, check_loads,  scene_asked_complete,
    override_units,      check_surfaces,  check_template,       give_title,
};

enum status_code scene_read(struct scene *out, const char *directory, const struct scene_overrides *overrides,
                            struct status *status)
{
    static const struct scene_overrides nothing = {0};
    const struct scene_overrides *over = overrides ? overrides : &nothing;
    struct scene_source source = {.scene = out, .status = status, .overrides = over};
    OWNED(text_free) struct text loaded = {0};
    struct stat info;
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
    bool good = (over->text || load_text(&loaded, out, status) == STATUS_OK) &&
                (!out->path || scene_source_read(&source, text_string(text), text->length));
    for (size_t i = 0; i < SCENE_COUNT(steps) && good; i++) {
        steps[i](out, &source);
        good = status->code == STATUS_OK;
    }
    if (good && out->accuracy > 0)
        plan_choose_model(out);
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
