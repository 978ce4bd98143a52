/* What the surfaces are pressed against, and what was measured when they were. Private to src/scene. */
#ifndef SCENE_SCENE_PAIR_H
#define SCENE_SCENE_PAIR_H

#include "scene/scene_source.h"

/** rigid | same | a material's name | a mapping of properties | {surface: file, material: ..., x_unit, z_unit}, into a
 * struct scene. */
enum status_code scene_pair_counterface(struct scene_source *source, const struct scene_key *key,
                                        const yaml_node_t *value, void *field);

/** {file, quantity, load_unit, resistance_unit} into a struct scene_measured. */
enum status_code scene_pair_measured(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                     void *field);

#endif
