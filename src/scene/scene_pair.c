#include "scene/scene_pair.h"
#include "scene/scene.h"
#include "scene/scene_material.h"
#include "scene/scene_surfaces.h"
#include "scene/scene_value.h"
#include "scene/scene_words.h"

#include <string.h>

enum { PAIR_RIGID, PAIR_SAME, PAIR_WORDS };
static const char *const words[PAIR_WORDS] = {"rigid", "same"}; /* besides materials */
static const char *const quantity_names[SCENE_MEASURED_QUANTITY_COUNT] = {"ecr", "tcr"};
const unsigned scene_measured_resistances[SCENE_MEASURED_QUANTITY_COUNT] = {
    [SCENE_MEASURED_ECR] = UNIT_RESISTANCE | UNIT_RESISTANCE_AREA,
    [SCENE_MEASURED_TCR] = UNIT_THERMAL_RESISTANCE | UNIT_THERMAL_RESISTANCE_AREA,
};

/* A word, a material's name or its properties. */
static enum status_code read_body(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                  void *field)
{
    struct scene *scene = field;
    struct scene_key material = {.name = key->name, .choices = words, .choice_count = PAIR_WORDS};
    if (scene_source_is(value, words[PAIR_RIGID]))
        return STATUS_OK;
    source->counterface_elastic = true;
    source->counterface_same = scene_source_is(value, words[PAIR_SAME]);
    return source->counterface_same ? STATUS_OK : scene_material_read(source, &material, value, &scene->counterface);
}

static bool has_key(struct scene_source *source, const yaml_node_t *mapping, const char *name)
{
    if (mapping->type != YAML_MAPPING_NODE)
        return false;
    for (const yaml_node_pair_t *pair = mapping->data.mapping.pairs.start; pair < mapping->data.mapping.pairs.top;
         pair++)
        if (scene_source_is(scene_source_node(source, pair->key), name))
            return true;
    return false;
}

static enum status_code read_files(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                   void *field)
{
    return scene_surfaces_files(source, key, value, &((struct scene *)field)->counterface_surface);
}

static enum status_code read_column(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                    void *field)
{
    return scene_surfaces_column(source, key, value, &((struct scene *)field)->counterface_surface);
}

enum status_code scene_pair_counterface(struct scene_source *source, const struct scene_key *key,
                                        const yaml_node_t *value, void *field)
{
    if (!has_key(source, value, "surface"))
        return read_body(source, key, value, field);
    enum { SURFACE, MATERIAL, X_UNIT, Z_UNIT, QUANTITY, COLUMN, KEYS };
    static const struct scene_key keys[KEYS] = {
        [SURFACE] = {"surface", read_files, .offset = 0},
        [MATERIAL] = {"material", read_body, .offset = 0},
        [X_UNIT] = {"x_unit", scene_value_short_text, .offset = offsetof(struct scene, counterface_surface.x_unit),
                    .most = sizeof((struct scene_surface *)NULL)->x_unit},
        [Z_UNIT] = {"z_unit", scene_value_short_text, .offset = offsetof(struct scene, counterface_surface.z_unit),
                    .most = sizeof((struct scene_surface *)NULL)->z_unit},
        [QUANTITY] = {"quantity", scene_value_choice, .offset = offsetof(struct scene, counterface_surface.quantity),
                      .choices = scan_quantity_names, .choice_count = SCAN_QUANTITY_COUNT},
        [COLUMN] = {"column", read_column, .offset = 0},
    };
    size_t lines[KEYS];
    enum status_code code = scene_source_mapping(source, value, key->name, keys, KEYS, field, lines);
    struct scene *scene = field;
    if (code == STATUS_OK && lines[MATERIAL] == 0)
        source->counterface_elastic = source->counterface_same = true; /* two rough bodies of one material */
    if (code == STATUS_OK && !(scene->counterface_surface.name = strdup("counterface")))
        code = status_memory(source->status);
    return code;
}

static enum status_code read_measured_file(struct scene_source *source, const struct scene_key *key,
                                           const yaml_node_t *value, void *field)
{
    struct scene_surface one = {0};
    struct scene_measured *measured = field;
    enum status_code code = scene_surfaces_files(source, key, value, &one);
    if (code == STATUS_OK && one.file_count != 1)
        code = scene_source_fail(source, scene_source_line(value), "'%s' names %zu files; name one", key->name,
                                 one.file_count);
    if (code == STATUS_OK && !(measured->file = strdup(one.files[0])))
        code = status_memory(source->status);
    scene_surfaces_free(&one);
    return code;
}

/* Is the unit that stands in line `line`, if any, one of `quantities`? */
static enum status_code check_unit(struct scene_source *source, const char *key, const char *text, size_t line,
                                   unsigned quantities)
{
    struct unit unit;
    if (line == 0 || (unit_read(&unit, text, strlen(text)) && unit_of(&unit, quantities)))
        return STATUS_OK;
    struct text known = {0};
    unit_add_known(&known, quantities);
    enum status_code code = known.failed
                                ? status_memory(source->status)
                                : scene_source_fail(source, line, "'%s' is '%s'; understood: %s", key,
                                                    scene_words_show(text, strlen(text)).text, text_string(&known));
    text_free(&known);
    return code;
}

enum status_code scene_pair_measured(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                     void *field)
{
    enum { MEASURED_FILE, QUANTITY, LOAD_UNIT, RESISTANCE_UNIT, KEYS };
    static const struct scene_key keys[KEYS] = {
        [MEASURED_FILE] = {"file", read_measured_file, .offset = 0},
        [QUANTITY] = {"quantity", scene_value_choice, .offset = offsetof(struct scene_measured, quantity),
                      .choices = quantity_names, .choice_count = SCENE_MEASURED_QUANTITY_COUNT},
        [LOAD_UNIT] = {"load_unit", scene_value_short_text, .offset = offsetof(struct scene_measured, load_unit),
                       .most = UNIT_LENGTH},
        [RESISTANCE_UNIT] = {"resistance_unit", scene_value_short_text,
                             .offset = offsetof(struct scene_measured, resistance_unit), .most = UNIT_LENGTH},
    };
    size_t lines[KEYS];
    struct scene_measured *measured = field;
    enum status_code code = scene_source_mapping(source, value, key->name, keys, KEYS, field, lines);
    if (code == STATUS_OK && lines[MEASURED_FILE] == 0)
        code = scene_source_fail(source, scene_source_line(value),
                                 "'measured' has no 'file'; name a CSV of load and "
                                 "resistance");
    if (code == STATUS_OK)
        code = check_unit(source, keys[LOAD_UNIT].name, measured->load_unit, lines[LOAD_UNIT], SCENE_MEASURED_LOADS);
    if (code == STATUS_OK)
        code = check_unit(source, keys[RESISTANCE_UNIT].name, measured->resistance_unit, lines[RESISTANCE_UNIT],
                          scene_measured_resistances[measured->quantity]);
    return code;
}
