/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/limits.h"
#include "scene/scene_source.h"

#include <assert.h>
#include <errno.h>
#include <math.h>
#include <search.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { MATERIALS_MOST = 32 }; /* names of them, or properties */

static bool read_material_name(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                               struct material *out)
{
    const char *names[MATERIALS_MOST], *word = (const char *)value->data.scalar.value;
    const struct material *found = strlen(word) == value->data.scalar.length ? material_find(word) : NULL;
    size_t count = key->choice_count;
    assert(count + material_table_count <= MATERIALS_MOST);
    for (size_t i = 0; i < count; i++)
        names[i] = key->choices[i];
    for (size_t i = 0; i < material_table_count; i++)
        if (!isnan(material_table[i].youngs_modulus_Pa))
            names[count++] = material_table[i].name;
    if (!found)
        return scene_source_unknown(source, value, scene_source_scalar(value), key->name, names, count);
    *out = *found;
    return !isnan(found->youngs_modulus_Pa) ||
           scene_source_fail_at(source, value, "'%s' is '%s', which bears no load; give the material of a body",
                                key->name, found->name);
}

/* A built-in name or a mapping of properties. The key's choices are named in the message about an unknown name. */
bool scene_surfaces_material(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                             void *field)
{
    struct material *material = field;
    if (value->type == YAML_SCALAR_NODE)
        return read_material_name(source, key, value, material);
    if (value->type != YAML_MAPPING_NODE)
        return scene_source_wrong_type(source, value, key->name, "a name or a mapping of properties");

    struct scene_key keys[MATERIALS_MOST] = {
        {"name", NULL, SCENE_SHORT_TEXT(offsetof(struct material, name), sizeof material->name)}};
    assert(material_property_count < SCENE_COUNT(keys));
    for (size_t i = 0; i < material_property_count; i++) {
        const struct material_property *row = &material_properties[i];
        keys[1 + i] =
            (struct scene_key){row->name, NULL, SCENE_QUANTITY(row->offset, row->quantity, row->least, row->most),
                               .alias = strcmp(row->name, row->key) != 0 ? row->key : NULL};
    }
    const struct scene_mapping mapping = {key->name, keys, 1 + material_property_count, .needs = "E, nu"};
    *material = material_unknown("custom");
    material->source = "given in scene.yaml";
    return scene_source_mapping(source, value, &mapping, material);
}

/* Counts files of the scene, which aliases of long lists multiply. */
static bool count_files(struct scene_source *source, size_t more, size_t line)
{
    source->file_count += more;
    return source->file_count <= limit_most(LIMIT_SCENE_FILES) ||
           scene_source_fail(source, line, "more than %zu files in one scene; split it", limit_most(LIMIT_SCENE_FILES));
}

/* Adds what a path names: one file, or those that its pattern matches where no file has that name. */
static bool add_files(struct scene_source *source, struct scene_files *files, const yaml_node_t *node, const char *file)
{
    size_t before = files->count, line = scene_source_line(node);
    struct scene_words_shown shown = scene_words_show(file);
    struct stat info;
    OWNED(memory_free) char *path = scene_file_path(source->scene, file);
    if (!path)
        return scene_source_memory(source);
    int failed = stat(path, &info), reason = errno;
    if (!failed || !strpbrk(file, "*?[")) {
        if (scene_files_add(files, file, source->status) != STATUS_OK)
            return false;
        if (failed)
            return scene_source_fail(source, line, "cannot find '%s': %s; paths start at the scene's directory",
                                     shown.text, strerror(reason));
        return S_ISREG(info.st_mode) ||
               scene_source_fail(source, line, "'%s' is no regular file; name one", shown.text);
    }
    struct status problem = {0};
    if (scene_files_match(files, source->scene, file, S_IFREG, &problem) == STATUS_MEMORY)
        return scene_source_memory(source);
    if (problem.code != STATUS_OK)
        return scene_source_fail(source, line, "%s", problem.message);
    if (!count_files(source, files->count - before, line))
        return false;
    return files->count > before ||
           scene_source_fail(source, line, "'%s' matches no file; paths start at the scene's directory", shown.text);
}

bool scene_surfaces_files(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                          void *field)
{
    size_t count = scene_source_item_count(value), line = scene_source_line(value);
    if (count == 0)
        return scene_source_fail(source, line, "'%s' lists none; name one or more scans", key->name);
    if (!count_files(source, count, line))
        return false;
    for (size_t i = 0; i < count; i++) {
        OWNED(memory_free) char *file = NULL;
        const yaml_node_t *item = scene_source_item(source, value, i);
        bool good = scene_source_text(source, key, item, &file) && add_files(source, field, item, file);
        if (!good)
            return false;
    }
    return true;
}

static const char *const measured_quantity_names[SCENE_MEASURED_QUANTITY_COUNT] = {"ecr", "tcr"};
const unsigned scene_measured_resistances[SCENE_MEASURED_QUANTITY_COUNT] = {
    [SCENE_MEASURED_ECR] = UNIT_RESISTANCE | UNIT_RESISTANCE_AREA,
    [SCENE_MEASURED_TCR] = UNIT_THERMAL_RESISTANCE | UNIT_THERMAL_RESISTANCE_AREA,
};

#define MEASURED(member) offsetof(struct scene_measured, member)
static const struct scene_key measured_keys[] = {
    {"file", NULL, scene_surfaces_files, .at = MEASURED(files)},
    {"quantity", NULL, SCENE_CHOICE(MEASURED(quantity), measured_quantity_names)},
    {"load_unit", NULL, scene_source_unit, .at = MEASURED(load_unit), .quantities = UNIT_LOADS},
    {"resistance_unit", NULL, scene_source_unit, .at = MEASURED(resistance_unit),
     .quantities = UNIT_RESISTANCE | UNIT_RESISTANCE_AREA | UNIT_THERMAL_RESISTANCE | UNIT_THERMAL_RESISTANCE_AREA},
    {"carry", NULL, SCENE_YES(MEASURED(carry))},
};

static bool complete_measured(struct scene_source *source, const size_t *lines, size_t line, void *into)
{
    struct scene_measured *measured = into;
    const char *text = measured->resistance_unit;
    const unsigned known = scene_measured_resistances[measured->quantity];
    struct unit unit;
    (void)line;
    measured->carry = measured->carry || lines[4] == 0; /* what was measured stands above a model unless told not to */
    return !*text || !unit_read(&unit, text, strlen(text)) || unit_of(&unit, known) ||
           scene_source_fail(source, lines[3], "'resistance_unit' is '%s'; understood: %s", text,
                             unit_known(known).text);
}

const struct scene_mapping scene_surfaces_measured = {"measured", measured_keys, SCENE_COUNT(measured_keys),
                                                      .needs = "file", .then = complete_measured};

/* A column or two of them, x and z. */
static bool read_columns(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                         void *field)
{
    struct scene_surface *surface = field;
    const struct scene_key column = {key->name, NULL, SCENE_WHOLE(0, 1, (double)limit_most(LIMIT_COLUMNS))};
    if (value->type == YAML_SCALAR_NODE)
        return scene_source_whole(source, &column, value, &surface->z_column);
    if (scene_source_item_count(value) != 2)
        return scene_source_fail_at(
            source, value, "'%s' is no column; give one, as in `column: 3`, or x and z, as in `column: [1, 3]`",
            key->name);
    return scene_source_whole(source, &column, scene_source_item(source, value, 0), &surface->x_column) &&
           scene_source_whole(source, &column, scene_source_item(source, value, 1), &surface->z_column);
}

/* A word, a material's name or its properties, into struct scene_bodies. */
static bool read_body(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value, void *field)
{
    static const char *const words[] = {"rigid", "same"}; /* besides materials */
    struct scene_bodies *bodies = field;
    const struct scene_key material = {key->name, .choices = words, .choice_count = SCENE_COUNT(words)};
    bodies->counterface_given = true;
    bodies->counterface_line = scene_source_line(value);
    if (scene_source_is(value, "rigid"))
        return true;
    bodies->counterface_kind = MATERIAL_COUNTERFACE_ELASTIC;
    bodies->counterface_same = scene_source_is(value, "same");
    return bodies->counterface_same || scene_surfaces_material(source, &material, value, &bodies->counterface);
}

#define AT(member) offsetof(struct scene_surface, member)
enum { UNIT_BYTES = sizeof((struct scene_surface *)NULL)->x_unit };
bool scene_surfaces_counterface(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                void *field)
{
    static const struct scene_key keys[] = {
        {"surface", NULL, scene_surfaces_files, .at = AT(files)},
        {"material", NULL, read_body, .at = AT(bodies)},
        {"x_unit", NULL, SCENE_SHORT_TEXT(AT(x_unit), UNIT_BYTES)},
        {"z_unit", NULL, SCENE_SHORT_TEXT(AT(z_unit), UNIT_BYTES)},
        {"column", NULL, read_columns, .at = 0},
    };
    struct scene_surface *surface = &source->scene->counterface_surface;
    struct scene_bodies *bodies = field;
    bool rough = false;
    if (value->type == YAML_MAPPING_NODE)
        for (const yaml_node_pair_t *p = value->data.mapping.pairs.start; p < value->data.mapping.pairs.top; p++)
            rough = rough || scene_source_is(yaml_document_get_node(&source->document, p->key), "surface");
    if (!rough)
        return read_body(source, key, value, field);
    if (!scene_source_mapping(source, value, SCENE_MAPPING(key->name, keys), surface))
        return false;
    const bool given = surface->bodies.counterface_given; /* else two rough bodies of one material */
    bodies->counterface_kind = given ? surface->bodies.counterface_kind : MATERIAL_COUNTERFACE_ELASTIC;
    bodies->counterface_same = !given || surface->bodies.counterface_same;
    bodies->counterface = surface->bodies.counterface;
    bodies->counterface_line = surface->bodies.counterface_line;
    bodies->counterface_given = true;
    surface->name = strdup("counterface");
    return surface->name || scene_source_memory(source);
}

static const struct scene_key vickers_keys[] = {
    {"c1", NULL, SCENE_QUANTITY(offsetof(struct scene_bodies, hardness_Pa), UNIT_PRESSURE, 1e3, 1e12)},
    {"c2", NULL, SCENE_NUMBER(offsetof(struct scene_bodies, hardness_exponent), -0.99, 0)},
};
const struct scene_mapping scene_surfaces_vickers = {"hardness", vickers_keys, SCENE_COUNT(vickers_keys),
                                                     .needs = "c1, c2"};

bool scene_surfaces_hardness(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                             void *field)
{
    char text[64], number[40], end;
    yaml_node_t node = *value;
    if (value->type == YAML_MAPPING_NODE)
        return scene_source_within(source, key, value, field);
    if (value->type == YAML_SCALAR_NODE &&
        sscanf((const char *)value->data.scalar.value, "HV %39[0-9.] %c", number, &end) == 1) {
        snprintf(text, sizeof text, "%s HV", number);
        node.data.scalar.value = (yaml_char_t *)text;
        node.data.scalar.length = strlen(text);
    }
    return scene_source_quantity(source, key, &node, &((struct scene_bodies *)field)->hardness_Pa);
}

static const struct scene_key surface_keys[] = {
    {"name", NULL, scene_source_text, .at = AT(name)},
    {"file", NULL, scene_surfaces_files, .at = AT(files)},
    {"along", NULL, scene_surfaces_files, .at = AT(along)},
    {"lay", NULL, SCENE_NUMBER(AT(lay), 0.0, 1.0), .given = AT(lay_given), .excludes = "along"},
    {"material", NULL, scene_surfaces_material, .at = AT(bodies.material), .given = AT(bodies.material_given)},
    {"counterface", NULL, read_body, .at = AT(bodies)},
    {"hardness", NULL, SCENE_HARDNESS(AT(bodies))},
    {"x_unit", NULL, SCENE_SHORT_TEXT(AT(x_unit), UNIT_BYTES)},
    {"z_unit", NULL, SCENE_SHORT_TEXT(AT(z_unit), UNIT_BYTES)},
    {"column", NULL, read_columns, .at = 0},
    {"measured", NULL, SCENE_MEASURED(AT(measured))},
};

static bool complete_surface(struct scene_source *source, const size_t *lines, size_t line, void *into)
{
    struct scene_surface *surface = into;
    (void)line;
    if (surface->name && strlen(surface->name) > limit_most(LIMIT_NAME_BYTES))
        return scene_source_fail(source, lines[0], "a name of %zu bytes%s", strlen(surface->name),
                                 limit_words(LIMIT_NAME_BYTES).text);
    if (!surface->name)
        surface->name = scene_files_name(surface->files.path[0], false);
    return surface->name || scene_source_memory(source);
}

const struct scene_mapping scene_surfaces_each = {"surfaces", surface_keys, SCENE_COUNT(surface_keys), .needs = "file",
                                                  .then = complete_surface};

static int compare_names(const void *a, const void *b)
{
    return strcmp(((const struct scene_surface *)a)->name, ((const struct scene_surface *)b)->name);
}

static void keep(void *surface)
{
    (void)surface;
}

static bool check_names(struct scene_source *source, const struct scene *scene, const yaml_node_t *list)
{
    void *tree = NULL;
    bool good = true;
    for (size_t i = 0; i < scene->surface_count && good; i++) {
        const struct scene_surface *surface = &scene->surfaces[i], **found = tsearch(surface, &tree, compare_names);
        if (!found)
            good = scene_source_memory(source);
        else if (*found != surface)
            good = scene_source_fail_at(
                source, scene_source_item(source, list, i),
                "two surfaces are named '%s', the first in line %zu; give each its own 'name'",
                scene_words_show(surface->name).text,
                scene_source_line(scene_source_item(source, list, (size_t)(*found - scene->surfaces))));
    }
    tdestroy(tree, keep);
    return good;
}

bool scene_surfaces_read(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                         void *field)
{
    struct scene *scene = field;
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
        if (!scene_source_mapping(source, scene_source_item(source, value, i), key->within, &scene->surfaces[i]))
            return false;
    return check_names(source, scene, value);
}

bool scene_lack_words(struct scene_lack_words *out, const struct scene_bodies *bodies, const char *owner,
                      const struct effect_row *effect)
{
    const char *body;
    const struct material_property *property = scene_lack(&body, bodies, effect);
    bool own = owner && (bodies->material_given || bodies->counterface_given);
    if (property && isnan(bodies->material.youngs_modulus_Pa))
        strcpy(out->text, "a material; add 'material'");
    else if (property)
        snprintf(out->text, sizeof out->text, own ? "'%s'; add it to '%s' of surface '%s'" : "'%s'; add it to '%s'",
                 property->name, body, own ? scene_words_show(owner).text : "");
    return property;
}
