#include "scene/scene_material.h"
#include "scene/scene_value.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MOST_NAMES = 32 };

/* The `word_count` words, then the names of the built-in materials; how many all in all. */
static size_t known_names(const char *names[MOST_NAMES], const char *const *words, size_t word_count)
{
    size_t count = 0;
    assert(word_count + material_table_count <= MOST_NAMES);
    for (size_t i = 0; i < word_count; i++)
        names[count++] = words[i];
    for (size_t i = 0; i < material_table_count; i++)
        names[count++] = material_table[i].name;
    return count;
}

struct scene_words_hint scene_material_hint(const char *word)
{
    const char *names[MOST_NAMES];
    size_t count = known_names(names, NULL, 0);
    return scene_words_hint(word, names, count);
}

static enum status_code read_name(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                  struct material *material)
{
    const char *word = (const char *)value->data.scalar.value;
    const struct material *found = strlen(word) == value->data.scalar.length ? material_find(word) : NULL;
    if (found) {
        *material = *found;
        return STATUS_OK;
    }
    const char *names[MOST_NAMES];
    size_t count = known_names(names, key->choices, key->choice_count);
    return scene_source_unknown(source, value, key->name, names, count);
}

enum status_code scene_material_read(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                     void *field)
{
    struct material *material = field;
    if (value->type == YAML_SCALAR_NODE)
        return read_name(source, key, value, material);
    if (value->type != YAML_MAPPING_NODE)
        return scene_source_wrong_type(source, value, key->name, "a name or a mapping of properties");

    struct scene_key keys[MOST_NAMES] = {
        {"name", scene_value_short_text, .offset = offsetof(struct material, name), .most = sizeof material->name}};
    size_t count = 1, lines[MOST_NAMES];
    assert(material_property_count < MOST_NAMES);
    for (size_t i = 0; i < material_property_count; i++) {
        const struct material_property *property = &material_properties[i];
        keys[count++] = (struct scene_key){property->key, scene_value_number, .offset = property->offset,
                                           .least = property->least, .most = property->most};
    }
    *material = material_unknown("custom");
    snprintf(material->source, sizeof material->source, "given in scene.yaml");
    enum status_code code = scene_source_mapping(source, value, key->name, keys, count, material, lines);
    if (code != STATUS_OK)
        return code;
    static const char *const required[] = {"E_Pa", "nu"};
    for (size_t i = 0; i < sizeof required / sizeof *required; i++) {
        size_t k = 0;
        while (strcmp(keys[k].name, required[i]) != 0)
            k++;
        if (lines[k] == 0)
            return scene_source_fail(source, scene_source_line(value), "'%s' has no '%s'; add it", key->name,
                                     required[i]);
    }
    return STATUS_OK;
}
