/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files of a directory: those that a pattern matches, in natural order. Private to src/scene. */
#ifndef SCENE_SCENE_FILES_H
#define SCENE_SCENE_FILES_H

#include "scene/scene.h"
#include <sys/stat.h>

/** Adds to surface->files what `pattern` (fnmatch(3); its last component alone is one) matches, below the scene's
 * directory unless it is absolute, and is of `kind`, S_IFREG or S_IFDIR; in natural order (2 before 10). Hidden files
 * and sidecars of others among them are left out. None may match. Errors: STATUS_IO: the directory cannot be listed;
 * STATUS_SCENE: it has more files than LIMIT_FILES; STATUS_MEMORY. */
MUST_CHECK enum status_code scene_files_match(struct scene_surface *surface, const struct scene *scene,
                                              const char *pattern, mode_t kind, struct status *status);

/** Adds one file. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code scene_files_add(struct scene_surface *surface, const char *file, struct status *status);

/** Adds to a scene without surfaces one for each regular file of its directory that is not hidden, not
 * scene.yaml, no sidecar, and may be a scan, and one for each such sub-directory that holds files, which are its
 * repeated scans; what is passed over is told in scene->passed_over; names and order as scene_read() says. Errors:
 * STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code scene_files_list(struct scene *scene, struct status *status);

/** The name of a surface read from `file`: its last component, without the ending unless `ending`; malloc'ed. */
char *scene_files_name(const char *file, bool ending);
/** Frees what one surface holds, its bodies unless they are the `shared` ones. */
void scene_files_free(struct scene_surface *surface, const struct scene_bodies *shared);

#endif
