#include "scene/scene.h"
#include "base/text.h"
#include "scene/scene_keys.h"
#include "scene/scene_listing.h"
#include "scene/scene_material.h"
#include "scene/scene_source.h"
#include "scene/scene_surfaces.h"
#include "scene/scene_words.h"

#include <assert.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static const off_t most_bytes = 1024 * 1024; /* of scene.yaml */

static struct scene default_scene(void)
{
    return (struct scene){
        .models = model_defaults(),
        .effects_auto = true,
        .material = *material_find("tin"),
        .counterface_kind = MATERIAL_COUNTERFACE_RIGID,
        .counterface = material_unknown(""),
        .nominal_area_m2 = NAN,
        .load = {.from = 1e-6, .to = 0.1, .points = 121},
        .hardness_Pa = NAN,
        .tolerance = 1e-6,
        .level = LEVEL_LINE,
        .max_missing = 0.1,
        .window = SPECTRUM_WINDOW_AUTO,
        .fit_band_m = {0.0, INFINITY},
        .moments = ROUGHNESS_MOMENTS_DIFFERENCE,
        .closure = SINUSOID_FIT_THESIS,
        .convergence = {.alpha = 0.085, .gamma = 1.5, .load = 1e-3, .scan_length_m = 3e-4, .scales = 4096},
    };
}

/* The last component of `path`; NULL when that is not a name of its own: "", ".", "..", "/". */
static char *last_component(const char *path)
{
    size_t end = strlen(path);
    while (end > 0 && path[end - 1] == '/')
        end--;
    size_t start = end;
    while (start > 0 && path[start - 1] != '/')
        start--;
    size_t length = end - start;
    if (length == 0 || (length <= 2 && strncmp(path + start, "..", length) == 0))
        return NULL;
    return strndup(path + start, length);
}

static char *directory_title(const char *directory)
{
    char *title = last_component(directory);
    if (title)
        return title;
    char *resolved = realpath(directory, NULL);
    title = resolved ? last_component(resolved) : NULL;
    free(resolved);
    return title ? title : strdup(directory);
}

static enum status_code check_directory(const char *directory, struct status *status)
{
    struct stat info;
    if (stat(directory, &info) != 0)
        return status_fail(status, STATUS_IO, "cannot open directory '%s': %s", directory, strerror(errno));
    if (!S_ISDIR(info.st_mode))
        return status_fail(status, STATUS_IO, "'%s' is no directory; name the one that holds the scans", directory);
    return STATUS_OK;
}

static enum status_code parse(struct scene *scene, struct scene_source *source)
{
    struct stat info;
    if (stat(scene->path, &info) != 0)
        return status_fail(source->status, STATUS_IO, "cannot open '%s': %s", scene->path, strerror(errno));
    if (!S_ISREG(info.st_mode))
        return status_fail(source->status, STATUS_SCENE, "'%s' is no regular file; remove it", scene->path);
    if (info.st_size > most_bytes)
        return status_fail(source->status, STATUS_SCENE, "'%s' is larger than 1 MiB; a scene is a few lines of text",
                           scene->path);
    struct text bytes = {0};
    enum status_code code = text_read_file(&bytes, scene->path, source->status);
    if (code == STATUS_OK)
        code = scene_source_open(source, text_string(&bytes), bytes.length);
    if (code == STATUS_OK)
        code = scene_keys_read(scene, source);
    scene_source_close(source);
    text_free(&bytes);
    return code;
}

/* Reads scene.yaml when there is one; a dangling link of that name is an error, not an absence. */
static enum status_code read_text(struct scene *scene, struct scene_source *source)
{
    struct stat info;
    scene->path = scene_file_path(scene, "scene.yaml");
    if (!scene->path)
        return status_memory(source->status);
    if (lstat(scene->path, &info) != 0 && errno == ENOENT) {
        free(scene->path);
        scene->path = NULL;
        return STATUS_OK;
    }
    source->path = scene->path;
    return parse(scene, source);
}

static enum status_code override_effects(struct scene *scene, struct scene_source *source, const char *words)
{
    memset(source->effect_line, 0, sizeof source->effect_line);
    scene->effects = 0;
    scene->effects_auto = strcmp(words, "auto") == 0;
    if (scene->effects_auto)
        return STATUS_OK;
    const char *names[EFFECT_COUNT], *word;
    scene_keys_effect_names(names);
    size_t length;
    for (const char *rest = words; (word = scene_words_next(&rest, &length));) {
        struct scene_words_shown shown = scene_words_show(word, length);
        enum effect effect = (enum effect)scene_words_find(word, length, names, EFFECT_COUNT);
        if (effect == EFFECT_COUNT)
            return status_fail(source->status, STATUS_USAGE, "--effects: unknown effect '%s'; %s", shown.text,
                               scene_words_hint(shown.text, names, EFFECT_COUNT).text);
        scene->effects |= EFFECT_BIT(effect);
    }
    if (scene->effects == 0)
        return status_fail(source->status, STATUS_USAGE,
                           "--effects names none; give 'auto' or names such as "
                           "'electrical,thermal'");
    scene->effects = scene_keys_with_needed(scene->effects);
    return STATUS_OK;
}

static enum status_code override_values(struct scene *scene, struct scene_source *source,
                                        const struct scene_overrides *overrides)
{
    if (overrides->material) {
        const struct material *material = material_find(overrides->material);
        struct scene_words_shown shown = scene_words_show(overrides->material, strlen(overrides->material));
        if (!material)
            return status_fail(source->status, STATUS_USAGE, "--material: unknown material '%s'; %s", shown.text,
                               scene_material_hint(overrides->material).text);
        scene->material = *material;
    }
    double tolerance = overrides->tolerance;
    if (tolerance != 0.0) {
        if (!(tolerance >= SCENE_KEYS_TOLERANCE_LEAST && tolerance <= SCENE_KEYS_TOLERANCE_MOST))
            return status_fail(source->status, STATUS_USAGE, "--tolerance is %g; allowed is %g to %g", tolerance,
                               SCENE_KEYS_TOLERANCE_LEAST, SCENE_KEYS_TOLERANCE_MOST);
        scene->tolerance = tolerance;
    }
    return overrides->effects ? override_effects(scene, source, overrides->effects) : STATUS_OK;
}

static enum status_code override_unit(struct scene *scene, size_t offset, const char *unit, const char *option,
                                      struct status *status)
{
    size_t size = sizeof scene->surfaces->x_unit;
    if (!unit)
        return STATUS_OK;
    if (*unit == '\0' || strlen(unit) >= size)
        return status_fail(status, STATUS_USAGE, "%s is '%s'; give a unit of length such as mm or um", option,
                           scene_words_show(unit, strlen(unit)).text);
    for (size_t i = 0; i < scene->surface_count; i++)
        memcpy((char *)&scene->surfaces[i] + offset, unit, strlen(unit) + 1);
    memcpy((char *)&scene->counterface_surface + offset, unit, strlen(unit) + 1);
    return STATUS_OK;
}

static bool has_property(const struct material *material, const char *key)
{
    for (size_t i = 0; i < material_property_count; i++)
        if (strcmp(material_properties[i].key, key) == 0)
            return !isnan(material_value(material, &material_properties[i]));
    assert(!"an effect needs a property that no material has");
    return false;
}

/* Fails when `body` ("material" or "counterface") lacks a property that an effect asked for by name needs. */
static enum status_code check_effects(const struct scene *scene, struct scene_source *source, const char *body,
                                      const struct material *material)
{
    for (int i = 0; i < EFFECT_COUNT; i++) {
        if (scene->effects_auto || !(scene->effects & EFFECT_BIT(i)))
            continue;
        for (const char *const *key = effect_rows[i].properties; *key; key++) {
            if (has_property(material, *key))
                continue;
            if (source->effect_line[i])
                return scene_source_fail(source, source->effect_line[i],
                                         "effect '%s' needs '%s'; add it to '%s' or leave the effect out",
                                         effect_rows[i].name, *key, body);
            return status_fail(source->status, STATUS_SCENE, "--effects: '%s' needs '%s'; add it to '%s' in '%s'",
                               effect_rows[i].name, *key, body, scene->path);
        }
    }
    return STATUS_OK;
}

static enum status_code check_baseline(const struct scene *scene, struct scene_source *source)
{
    if (!scene->baseline || scene->surface_count == 0)
        return STATUS_OK;
    for (size_t i = 0; i < scene->surface_count; i++)
        if (strcmp(scene->surfaces[i].name, scene->baseline) == 0)
            return STATUS_OK;
    const char *first = scene->surfaces[0].name;
    return scene_source_fail(source, source->baseline_line, "'baseline' is '%s', no surface's name; the first is '%s'",
                             scene_words_show(scene->baseline, strlen(scene->baseline)).text,
                             scene_words_show(first, strlen(first)).text);
}

static enum status_code complete(struct scene *scene, struct scene_source *source,
                                 const struct scene_overrides *overrides)
{
    enum status_code code = override_values(scene, source, overrides);
    scene->counterface_kind = source->counterface_elastic ? MATERIAL_COUNTERFACE_ELASTIC : MATERIAL_COUNTERFACE_RIGID;
    if (code == STATUS_OK && source->counterface_same)
        scene->counterface = scene->material;
    if (code == STATUS_OK)
        code = check_effects(scene, source, "material", &scene->material);
    if (code == STATUS_OK && source->counterface_elastic)
        code = check_effects(scene, source, "counterface", &scene->counterface);
    if (code == STATUS_OK && scene->surface_count == 0)
        code = scene_listing_read(scene, source->status);
    if (code == STATUS_OK)
        code =
            override_unit(scene, offsetof(struct scene_surface, x_unit), overrides->x_unit, "--x-unit", source->status);
    if (code == STATUS_OK)
        code =
            override_unit(scene, offsetof(struct scene_surface, z_unit), overrides->z_unit, "--z-unit", source->status);
    if (code == STATUS_OK)
        code = check_baseline(scene, source);
    if (code == STATUS_OK && !scene->title && !(scene->title = directory_title(scene->directory)))
        code = status_memory(source->status);
    return code;
}

enum status_code scene_read(struct scene *out, const char *directory, const struct scene_overrides *overrides,
                            struct status *status)
{
    static const struct scene_overrides nothing = {0};
    struct scene_source source = {.directory = directory, .status = status};
    *out = default_scene();
    enum status_code code = check_directory(directory, status);
    if (code != STATUS_OK)
        return code;
    out->directory = strdup(directory);
    if (!out->directory)
        return status_memory(status);
    code = read_text(out, &source);
    return code == STATUS_OK ? complete(out, &source, overrides ? overrides : &nothing) : code;
}

void scene_free(struct scene *scene)
{
    for (size_t i = 0; i < scene->surface_count; i++)
        scene_surfaces_free(&scene->surfaces[i]);
    free(scene->surfaces);
    scene_surfaces_free(&scene->counterface_surface);
    free(scene->measured.file);
    free(scene->load.values);
    free(scene->baseline);
    free(scene->title);
    free(scene->path);
    free(scene->directory);
    *scene = (struct scene){0};
}

char *scene_file_path(const struct scene *scene, const char *file)
{
    return scene_surfaces_path(scene->directory, file);
}
