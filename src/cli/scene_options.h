/* The options that override the scene, shared by `report` and `plan`. */
#ifndef CLI_SCENE_OPTIONS_H
#define CLI_SCENE_OPTIONS_H

#include "scene/scene.h"
#include <argp.h>

/** Parses --material, --effects, --tolerance, --x-unit and --z-unit into a struct scene_overrides, given as the child's
 * input. */
extern const struct argp scene_options_argp;

#endif
