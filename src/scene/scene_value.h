/* Readers of single values, to stand in scene_key.read. Private to src/scene.
 * Errors: STATUS_SCENE with file, line and key; STATUS_MEMORY. */
#ifndef SCENE_SCENE_VALUE_H
#define SCENE_SCENE_VALUE_H

#include "scene/scene_source.h"

/* The field is a double, a size_t, an enum, a malloc'ed char *, a char array. */
enum status_code scene_value_number(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                    void *field);
enum status_code scene_value_count(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                   void *field);
enum status_code scene_value_choice(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                    void *field);
enum status_code scene_value_text(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                  void *field);
enum status_code scene_value_short_text(struct scene_source *source, const struct scene_key *key,
                                        const yaml_node_t *value, void *field);

#endif
