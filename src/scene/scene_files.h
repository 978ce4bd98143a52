/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files of a directory as the repeated scans of one surface: those a pattern matches, or all. Private to src/scene. */
#ifndef SCENE_SCENE_FILES_H
#define SCENE_SCENE_FILES_H

#include "scene/scene.h"

/** Does the path hold a sign of a pattern, * ? or [? */
bool scene_files_is_pattern(const char *path);

/** Adds to surface->files the regular files that `pattern` (fnmatch(3); its last component alone is one) matches, below
 * the scene's directory unless it is absolute, ordered by name, digits by value; hidden files and sidecars of others
 * among them are left out. None may match. Errors: STATUS_IO: the directory cannot be listed; STATUS_MEMORY. */
MUST_CHECK enum status_code scene_files_match(struct scene_surface *surface, const struct scene *scene,
                                              const char *pattern, struct status *status);

/** Does the sub-directory hold scans: is it no report of this program, and has it a file that is not hidden? */
bool scene_files_holds_scans(int directory, const char *name);

/** Adds one file. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code scene_files_add(struct scene_surface *surface, const char *file, struct status *status);

#endif
