/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surfaces from the files of a directory, for a scene that lists none. Private to src/scene. */
#ifndef SCENE_SCENE_LISTING_H
#define SCENE_SCENE_LISTING_H

#include "scene/scene.h"

/** Adds to a scene without surfaces one for each regular file of its directory that is not hidden, not
 * scene.yaml, no sidecar, and may be a scan, and one for each such sub-directory that holds files, which are its
 * repeated scans; what is passed over is told in scene->passed_over; names and order as scene_read() says. Errors:
 * STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code scene_listing_read(struct scene *scene, struct status *status);

#endif
