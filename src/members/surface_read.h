/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads the scans of a surface, conditions and averages them, and fits its law. */
#ifndef MEMBERS_SURFACE_READ_H
#define MEMBERS_SURFACE_READ_H

#include "base/hash.h"
#include "members/copies.h"
#include "members/surface.h"

/** Reads one surface: everything before effects and models. Unusable files are no error: then summary.usable is false
 * and summary.refusal says why in one line. counterface: a rough one that has been read; NULL: smooth. Error:
 * STATUS_MEMORY. `out` comes zeroed; owned in any case: surface_record_free(). */
MUST_CHECK enum status_code surface_read(struct surface_record *out, const struct scene *scene,
                                         const struct scene_surface *surface, const struct surface_record *counterface,
                                         struct status *status);

/* Its steps, in their order. */

/** A surface whose scans are being read. */
struct surface_scans {
    struct surface_record *record;
    struct power_law_scans *scans; /* to which its law will be fitted */
    const struct scene *scene;
    struct copies *copies; /* its scans so far, to recognise copies */
};

/** Adds every file of a surface, sorted by content, so that neither names nor the order in the scene matter. Copies are
 * left out and unusable scans refused, with a note. `hash` takes all bytes. Errors: STATUS_SCAN with the first reason
 * if no scan is left, STATUS_MEMORY, STATUS_INTERRUPTED. */
MUST_CHECK enum status_code surface_files_read(const struct surface_scans *task, struct hash *hash,
                                               struct status *status);

/** Adds a scan called `name`, its file and place in an archive: a profile, whose heights are taken over, or
 * every row of a map. Unusable rows (all missing, flat) are left out and counted. Errors: STATUS_SCAN if none is left
 * (one line with the file's name; nothing was added), STATUS_MEMORY. */
MUST_CHECK enum status_code surface_rows_add(const struct surface_scans *task, struct scan *scan, const char *name,
                                             struct status *status);

/** Two rough bodies: squares of amplitudes and moments add (docs/equations.md, From scan to spectrum), also scan by
 * scan, for as many as both have, and in `scans`. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code surface_read_counterface(struct surface_record *record, struct power_law_scans *scans,
                                                     const struct surface_record *counterface, struct status *status);

/** After all files: cuts longer profiles to pieces as long as the shortest, gathers the strips, and drops the members
 * of a single scan, which is the surface itself. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code surface_read_members(struct surface_record *record, struct power_law_scans *scans,
                                                 const struct scene *scene, struct status *status);

#endif
