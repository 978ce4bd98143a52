/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/limits.h"
#include "scene/scene_source.h"

#include <assert.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

size_t scene_surfaces_materials(const char *names[SCENE_SURFACES_MATERIALS], const char *const *words,
                                size_t word_count)
{
    size_t count = 0;
    assert(word_count + material_table_count <= SCENE_SURFACES_MATERIALS);
    for (size_t i = 0; i < word_count; i++)
        names[count++] = words[i];
    for (size_t i = 0; i < material_table_count; i++)
        if (!isnan(material_table[i].youngs_modulus_Pa))
            names[count++] = material_table[i].name;
    return count;
}

static bool read_material_name(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    const char *names[SCENE_SURFACES_MATERIALS], *word = (const char *)value->data.scalar.value;
    const struct material *found = strlen(word) == value->data.scalar.length ? material_find(word) : NULL;
    size_t count = scene_surfaces_materials(names, key->choices, key->choice_count);
    if (!found)
        return scene_source_unknown(source, value, key->name, names, count, count);
    *(struct material *)key->field = *found;
    return !isnan(found->youngs_modulus_Pa) ||
           scene_source_fail_at(source, value, "'%s' is '%s', which bears no load; give the material of a body",
                                key->name, found->name);
}

/* A built-in name or a mapping of properties, into a struct material. The key's choices are named in the message about
 * an unknown name. */
static bool read_material(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct material *material = key->field;
    if (value->type == YAML_SCALAR_NODE)
        return read_material_name(source, key, value);
    if (value->type != YAML_MAPPING_NODE)
        return scene_source_wrong_type(source, value, key->name, "a name or a mapping of properties");

    struct scene_key keys[SCENE_SURFACES_MATERIALS] = {{"name", SCENE_SHORT_TEXT(material->name)}};
    assert(material_property_count < SCENE_COUNT(keys));
    for (size_t i = 0; i < material_property_count; i++) {
        const struct material_property *property = &material_properties[i];
        keys[1 + i] = (struct scene_key){property->name,
                                         scene_source_quantity,
                                         .field = (char *)material + property->offset,
                                         .least = property->least,
                                         .most = property->most,
                                         .quantities = property->quantity,
                                         .alias = strcmp(property->name, property->key) != 0 ? property->key : NULL};
    }
    *material = material_unknown("custom");
    material->source = "given in scene.yaml";
    if (!scene_source_mapping(source, value, key->name, keys, 1 + material_property_count))
        return false;
    static const char *const required[] = {"E", "nu"};
    for (size_t i = 0; i < SCENE_COUNT(required); i++)
        if (scene_source_line_of(keys, required[i]) == 0)
            return scene_source_fail_at(source, value, "'%s' has no '%s'; add it", key->name, required[i]);
    return true;
}

/* Counts files of the scene, which aliases of long lists multiply. */
static bool count_files(struct scene_source *source, size_t more, size_t line)
{
    source->file_count += more;
    return source->file_count <= limit_most(LIMIT_SCENE_FILES) ||
           scene_source_fail(source, line, "more than %zu files in one scene; split it", limit_most(LIMIT_SCENE_FILES));
}

/* Adds what a path names: one file, or those that its pattern matches where no file has that name. */
static bool add_files(struct scene_source *source, struct scene_surface *surface, const yaml_node_t *node,
                      const char *file)
{
    size_t before = surface->file_count, line = scene_source_line(node);
    struct scene_words_shown shown = scene_words_show(file);
    struct stat info;
    char *path = scene_file_path(source->scene, file);
    if (!path)
        return scene_source_memory(source);
    int failed = stat(path, &info), reason = errno;
    free(path);
    if (!failed || !strpbrk(file, "*?[")) {
        if (scene_files_add(surface, file, source->status) != STATUS_OK)
            return false;
        if (failed)
            return scene_source_fail(source, line,
                                     "cannot find surface file '%s': %s; paths start at the scene's directory",
                                     shown.text, strerror(reason));
        return S_ISREG(info.st_mode) ||
               scene_source_fail(source, line, "surface file '%s' is no regular file; name a scan", shown.text);
    }
    struct status problem = {0};
    if (scene_files_match(surface, source->scene, file, S_IFREG, &problem) == STATUS_MEMORY)
        return scene_source_memory(source);
    if (problem.code != STATUS_OK)
        return scene_source_fail(source, line, "%s", problem.message);
    if (!count_files(source, surface->file_count - before, line))
        return false;
    return surface->file_count > before ||
           scene_source_fail(source, line, "'%s' matches no file; paths start at the scene's directory", shown.text);
}

bool scene_surfaces_files(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct scene_surface *surface = key->field;
    size_t count = scene_source_item_count(value), line = scene_source_line(value);
    if (count == 0)
        return scene_source_fail(source, line, "'%s' lists none; name one or more scans", key->name);
    if (!count_files(source, count, line))
        return false;
    for (size_t i = 0; i < count; i++) {
        char *file = NULL;
        const yaml_node_t *item = scene_source_item(source, value, i);
        bool good = scene_source_text(source, &(struct scene_key){.name = key->name, .field = &file}, item) &&
                    add_files(source, surface, item, file);
        free(file);
        if (!good)
            return false;
    }
    return true;
}

/* A column or two of them, x and z, into a struct scene_surface. */
static bool read_columns(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct scene_surface *surface = key->field;
    const double most = (double)limit_most(LIMIT_COLUMNS);
    const struct scene_key x = {key->name, SCENE_WHOLE(surface->x_column, 1, most)},
                           z = {key->name, SCENE_WHOLE(surface->z_column, 1, most)};
    if (value->type == YAML_SCALAR_NODE)
        return scene_source_whole(source, &z, value);
    if (value->type != YAML_SEQUENCE_NODE || scene_source_item_count(value) != 2)
        return scene_source_fail_at(
            source, value, "'%s' is no column; give one, as in `column: 3`, or x and z, as in `column: [1, 3]`",
            key->name);
    return scene_source_whole(source, &x, scene_source_item(source, value, 0)) &&
           scene_source_whole(source, &z, scene_source_item(source, value, 1));
}

/* How the files of a surface are read: keys of a surface and of the counterface alike. */
#define READING_KEYS(surface)                                                                                          \
    {"x_unit", SCENE_SHORT_TEXT((surface)->x_unit)}, {"z_unit", SCENE_SHORT_TEXT((surface)->z_unit)},                  \
        {"quantity", SCENE_CHOICE((surface)->quantity, scan_quantity_names)},                                          \
    {                                                                                                                  \
        "column", read_columns, .field = (surface)                                                                     \
    }

/* A word, a material's name or its properties, into struct scene_bodies. */
static bool read_body(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    static const char *const words[] = {"rigid", "same"}; /* besides materials */
    struct scene_bodies *bodies = key->field;
    struct scene_key material = {key->name, read_material, &bodies->counterface, .choices = words,
                                 .choice_count = SCENE_COUNT(words)};
    bodies->counterface_given = true;
    bodies->counterface_line = scene_source_line(value);
    if (scene_source_is(value, "rigid"))
        return true;
    bodies->counterface_kind = MATERIAL_COUNTERFACE_ELASTIC;
    bodies->counterface_same = scene_source_is(value, "same");
    return bodies->counterface_same || read_material(source, &material, value);
}

bool scene_surfaces_body(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct scene_bodies *bodies = key->field;
    struct scene_key material = *key;
    material.field = &bodies->material;
    bodies->material_given = true;
    return read_material(source, &material, value);
}

bool scene_surfaces_counterface(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct scene_surface *surface = &source->scene->counterface_surface;
    struct scene_bodies *bodies = &source->scene->bodies;
    if (!scene_source_has(source, value, "surface"))
        return read_body(source, key, value);
    struct scene_key keys[] = {{"surface", scene_surfaces_files, .field = surface},
                               {"material", read_body, .field = bodies},
                               READING_KEYS(surface)};
    if (!scene_source_mapping(source, value, key->name, keys, SCENE_COUNT(keys)))
        return false;
    if (scene_source_line_of(keys, "material") == 0) { /* two rough bodies of one material */
        bodies->counterface_kind = MATERIAL_COUNTERFACE_ELASTIC;
        bodies->counterface_given = bodies->counterface_same = true;
    }
    surface->name = strdup("counterface");
    return surface->name || scene_source_memory(source);
}

/* Scans along the lay. */
static bool read_along(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct scene_surface *surface = key->field, along = {0};
    bool good = scene_surfaces_files(source, &(struct scene_key){.name = key->name, .field = &along}, value);
    surface->along = along.files;
    surface->along_count = along.file_count;
    return good;
}

static bool read_surface(struct scene_source *source, const yaml_node_t *node, struct scene_surface *surface)
{
    struct scene_bodies own = {.hardness_Pa = NAN};
    struct scene_key keys[] = {
        {"name", scene_source_text, .field = &surface->name},
        {"file", scene_surfaces_files, .field = surface},
        {"along", read_along, .field = surface},
        {"lay", SCENE_NUMBER(surface->lay, 0.0, 1.0)},
        {"material", scene_surfaces_body, .field = &own},
        {"counterface", read_body, .field = &own},
        {"hardness", SCENE_QUANTITY(own.hardness_Pa, UNIT_PRESSURE, 1e3, 1e12), .alias = "hardness_Pa"},
        READING_KEYS(surface)};
    if (!scene_source_mapping(source, node, "surfaces", keys, SCENE_COUNT(keys)))
        return false;
    if (scene_source_line_of(keys, "file") == 0)
        return scene_source_fail_at(source, node, "a surface has no 'file'; add one");
    surface->lay_given = scene_source_line_of(keys, "lay") > 0;
    if (surface->lay_given && surface->along_count > 0)
        return scene_source_fail(source, scene_source_line_of(keys, "lay"),
                                 "'lay' stands beside 'along', whose scans tell it; remove one of them");
    if (surface->name && strlen(surface->name) > limit_most(LIMIT_NAME_BYTES))
        return scene_source_fail(source, scene_source_line_of(keys, "name"), "a name of %zu bytes%s",
                                 strlen(surface->name), limit_words(LIMIT_NAME_BYTES).text);
    if (own.material_given || own.counterface_given || !isnan(own.hardness_Pa)) {
        if (!(surface->bodies = malloc(sizeof own)))
            return scene_source_memory(source);
        *surface->bodies = own;
    }
    if (!surface->name)
        surface->name = scene_files_name(surface->files[0], false);
    return surface->name || scene_source_memory(source);
}

/* By name, then in the order of the list. */
static int compare_surfaces(const void *a, const void *b)
{
    const struct scene_surface *first = *(struct scene_surface *const *)a, *second = *(struct scene_surface *const *)b;
    int order = strcmp(first->name, second->name);
    return order ? order : (first > second) - (first < second);
}

static bool check_names(struct scene_source *source, const yaml_node_t *list)
{
    struct scene *scene = source->scene;
    const struct scene_surface **surfaces = malloc(scene->surface_count * sizeof *surfaces);
    if (!surfaces)
        return scene_source_memory(source);
    for (size_t i = 0; i < scene->surface_count; i++)
        surfaces[i] = &scene->surfaces[i];
    qsort(surfaces, scene->surface_count, sizeof *surfaces, compare_surfaces);
    bool good = true;
    for (size_t i = 1; i < scene->surface_count && good; i++) {
        const struct scene_surface *first = surfaces[i - 1], *second = surfaces[i];
        if (strcmp(first->name, second->name) == 0)
            good = scene_source_fail(
                source, scene_source_line(scene_source_item(source, list, (size_t)(second - scene->surfaces))),
                "two surfaces are named '%s', the first in line %zu; give each its own 'name'",
                scene_words_show(second->name).text,
                scene_source_line(scene_source_item(source, list, (size_t)(first - scene->surfaces))));
    }
    free(surfaces);
    return good;
}

bool scene_surfaces_read(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct scene *scene = source->scene;
    if (value->type != YAML_SEQUENCE_NODE)
        return scene_source_wrong_type(source, value, key->name, "a list of '- {name: ..., file: ...}'");
    size_t count = scene_source_item_count(value);
    if (count == 0)
        return scene_source_fail_at(source, value,
                                    "'surfaces' lists none; remove it to report every file of the directory");
    scene->surfaces = calloc(count, sizeof *scene->surfaces);
    if (!scene->surfaces)
        return scene_source_memory(source);
    scene->surface_count = count;
    for (size_t i = 0; i < count; i++)
        if (!read_surface(source, scene_source_item(source, value, i), &scene->surfaces[i]))
            return false;
    return check_names(source, value);
}
