/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files of a directory: those that a pattern matches, in natural order. Private to src/scene. */
#ifndef SCENE_SCENE_FILES_H
#define SCENE_SCENE_FILES_H

#include "scene/scene.h"
#include <sys/stat.h>

/** Does the path hold a sign of a pattern, * ? or [? */
bool scene_files_is_pattern(const char *path);

/** Adds to surface->files what `pattern` (fnmatch(3); its last component alone is one) matches, below the scene's
 * directory unless it is absolute, and is of `kind`, S_IFREG or S_IFDIR; ordered by scene_files_order(). Hidden files
 * and sidecars of others among them are left out. None may match. Errors: STATUS_IO: the directory cannot be listed;
 * STATUS_SCENE: it has more files than LIMIT_FILES; STATUS_MEMORY. */
MUST_CHECK enum status_code scene_files_match(struct scene_surface *surface, const struct scene *scene,
                                              const char *pattern, mode_t kind, struct status *status);

/** Adds one file. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code scene_files_add(struct scene_surface *surface, const char *file, struct status *status);

/** Compares names in natural order: runs of digits by value, the rest by bytes; 2 before 10. */
int scene_files_order(const char *a, const char *b);

#endif
