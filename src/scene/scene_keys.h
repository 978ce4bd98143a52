/* The keys of scene.yaml: one const table a mapping. Private to src/scene. */
#ifndef SCENE_SCENE_KEYS_H
#define SCENE_SCENE_KEYS_H

#include "scene/scene.h"
#include "scene/scene_source.h"

/* Range of the relative tolerance: below is rounding, above is no accuracy. */
#define SCENE_KEYS_TOLERANCE_LEAST 1e-14
#define SCENE_KEYS_TOLERANCE_MOST  0.1

/** Reads the whole text of `source` into `scene`, which holds the defaults.
 * Errors: STATUS_SCENE with file, line and key; STATUS_MEMORY. */
MUST_CHECK enum status_code scene_keys_read(struct scene *scene, struct scene_source *source);

/** Name of every effect, in the order of the enum. */
void scene_keys_effect_names(const char *names[EFFECT_COUNT]);
/** `effects` with those they build on. */
unsigned scene_keys_with_needed(unsigned effects);

#endif
