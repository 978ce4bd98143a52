/* `material` and `counterface` of a scene: a built-in name or a mapping of properties. Private to src/scene. */
#ifndef SCENE_SCENE_MATERIAL_H
#define SCENE_SCENE_MATERIAL_H

#include "material/material.h"
#include "scene/scene_source.h"
#include "scene/scene_words.h"

/** Reads a struct material; to stand in scene_key.read. The key's choices are named
 * in the message about an unknown name. */
enum status_code scene_material_read(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                     void *field);
/** What to write instead of the unknown built-in name `word`. */
struct scene_words_hint scene_material_hint(const char *word);

#endif
