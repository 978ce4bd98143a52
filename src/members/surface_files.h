/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From the files of a surface to its scans: those that can be used, and why others cannot. */
#ifndef MEMBERS_SURFACE_FILES_H
#define MEMBERS_SURFACE_FILES_H

#include "base/hash.h"
#include "members/surface_rows.h"

/** Adds the scans of one file, of which an archive may hold several: one that cannot be used costs itself alone. `hash`
 * takes its bytes, and those of what belongs to it. Errors: STATUS_IO, STATUS_SCAN (one line with the file's name; then
 * nothing was added), STATUS_MEMORY. */
MUST_CHECK enum status_code surface_files_read_one(const struct surface_rows_task *task,
                                                   const struct scene_surface *surface, const char *file,
                                                   struct hash *hash, struct status *status);

/** Adds every file of a surface, by name: what comes out does not depend on the order in which a scene lists them. One
 * that cannot be used is refused, which is noted. Errors: STATUS_SCAN with the first one's reason where none is left,
 * STATUS_MEMORY, STATUS_INTERRUPTED. */
MUST_CHECK enum status_code surface_files_read(const struct surface_rows_task *task,
                                               const struct scene_surface *surface, struct hash *hash,
                                               struct status *status);

#endif
