/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bodies of a scene: its surfaces, what they are pressed against, and their materials. Private to src/scene. */
#ifndef SCENE_SCENE_SURFACES_H
#define SCENE_SCENE_SURFACES_H

#include "scene/scene_source.h"

enum { SCENE_SURFACES_MATERIALS = 32 };

/* To stand in scene_key.read. */
/** The list `surfaces`, into source->scene. */
bool scene_surfaces_read(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value);
/** rigid | same | a material's name | a mapping of properties | {surface: file, material: ..., x_unit, z_unit}, into
 * source->scene. */
bool scene_surfaces_counterface(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value);
/** A built-in name or a mapping of properties, into a struct scene_bodies. */
bool scene_surfaces_body(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value);
/** One file or a list of them, each checked to exist, into a struct scene_surface. */
bool scene_surfaces_files(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value);

/** The `word_count` words, then the names of the built-in materials of bodies; how many all in all. */
size_t scene_surfaces_materials(const char *names[SCENE_SURFACES_MATERIALS], const char *const *words,
                                size_t word_count);
/** A property that the effect needs and one of the bodies does not have, and which body; NULL: they have all. */
const struct material_property *scene_surfaces_lack(const char **body, const struct scene_bodies *bodies,
                                                    const struct effect_row *effect);

#endif
