/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a scene asks of the contact: `targets`, whose load is sought, and `limits`, to be kept. Private to src/scene,
 * but for its table. */
#ifndef SCENE_SCENE_ASKED_H
#define SCENE_SCENE_ASKED_H

#include "scene/scene_source.h"

/** To stand in scene_key.read: a list of `key: value` pairs, each a quantity; or `key: {most: value, least: value}`. */
bool scene_asked_targets(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value);
bool scene_asked_limits(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value);

/** Turns what was read into the models' quantities, now that the nominal area is known. */
MUST_CHECK bool scene_asked_complete(struct scene *scene, struct scene_source *source);

#endif
