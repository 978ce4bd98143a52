/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From the scans of a surface to its description: read, conditioned, averaged, fitted. */
#ifndef MEMBERS_SURFACE_READ_H
#define MEMBERS_SURFACE_READ_H

#include "base/hash.h"
#include "members/copies.h"
#include "members/surface.h"

/** Reads and describes one surface: everything but effects and models. What is wrong with its files is no error: then
 * summary.usable is false and summary.refusal says why in one line. `counterface` is the described rough counterface,
 * NULL for a smooth one. Error: STATUS_MEMORY. `out` is zeroed; owned: surface_record_free() whatever comes back. */
MUST_CHECK enum status_code surface_read(struct surface_record *out, const struct scene *scene,
                                         const struct scene_surface *surface, const struct surface_record *counterface,
                                         struct status *status);

/* Its steps, in their order. */

/** A surface whose scans are being taken. */
struct surface_scans {
    struct surface_record *record;
    struct power_law_scans *scans; /* that its law will be fitted to */
    const struct scene *scene;
    struct copies *copies; /* of its scans so far */
};

/** Adds every file of a surface, in the order of their contents: what comes out does not depend on their names, nor on
 * the order in which a scene lists them. A scan that is a copy of one before counts once, and one that cannot be used
 * is refused; either is noted. Errors: STATUS_SCAN with the first one's reason where none is left, STATUS_MEMORY,
 * STATUS_INTERRUPTED. */
MUST_CHECK enum status_code surface_files_read(const struct surface_scans *task, struct hash *hash,
                                               struct status *status);
/** Adds the scans of one file, of which an archive may hold several: one that cannot be used costs itself alone. `hash`
 * takes its bytes, and those of what belongs to it. Errors: STATUS_IO, STATUS_SCAN (one line with the file's name; then
 * nothing was added), STATUS_MEMORY. */
MUST_CHECK enum status_code surface_files_read_one(const struct surface_scans *task, const char *file,
                                                   struct hash *hash, struct status *status);

/** Adds a scan, `file` of the scene: a profile, whose heights are taken over, or every row of a map. A row of a map
 * that cannot be used (all missing, flat) is left out and counted. Errors: STATUS_SCAN where none is left (one line
 * with the file's name; then nothing was added), STATUS_MEMORY. */
MUST_CHECK enum status_code surface_rows_add(const struct surface_scans *task, struct scan *scan, const char *file,
                                             struct status *status);

/** Two rough bodies: amplitudes and moments of the surface and of its counterface add as squares (docs/equations.md,
 * From scan to spectrum), scan by scan as many as both have; those the law is fitted to are added to `scans`. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code surface_read_counterface(struct surface_record *record, struct power_law_scans *scans,
                                                     const struct surface_record *counterface, struct status *status);

/** Once all of the files were added, in this order: a single scan is the surface itself; of several profiles the longer
 * ones are cut to subrecords as long as the shortest. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code surface_read_members(struct surface_record *record, struct power_law_scans *scans,
                                                 const struct scene *scene, struct status *status);

#endif
