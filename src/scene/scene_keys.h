/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The keys of scene.yaml. Private to src/scene. */
#ifndef SCENE_SCENE_KEYS_H
#define SCENE_SCENE_KEYS_H

#include "scene/scene_source.h"

/* Range of the relative tolerance: below is rounding, above is no accuracy. */
#define SCENE_KEYS_TOLERANCE_LEAST 1e-14
#define SCENE_KEYS_TOLERANCE_MOST  0.1

/** Reads the outermost node into source->scene, which holds the defaults. */
MUST_CHECK bool scene_keys_read(struct scene_source *source, const yaml_node_t *root);

/** Name of every effect, in the order of the enum. */
void scene_keys_effect_names(const char *names[EFFECT_COUNT]);
/** `effects` with those they build on. */
unsigned scene_keys_with_needed(unsigned effects);

#endif
