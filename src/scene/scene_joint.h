/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What lies in and around the spots: 'gap' and 'plating' of a scene. Private to src/scene. */
#ifndef SCENE_SCENE_JOINT_H
#define SCENE_SCENE_JOINT_H

#include "scene/scene_source.h"

/** To stand in scene_key.read; the field is a struct joint that holds the defaults. */
bool scene_joint_gap(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value);
bool scene_joint_plating(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value);

#endif
