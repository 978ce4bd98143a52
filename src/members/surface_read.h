/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From the scans of a surface to its description: read, conditioned, averaged, fitted. */
#ifndef MEMBERS_SURFACE_READ_H
#define MEMBERS_SURFACE_READ_H

#include "members/surface_files.h"

/** Reads and describes one surface: everything but effects and models. What is wrong with its files is no error: then
 * summary.usable is false and summary.refusal says why in one line. `counterface` is the described rough counterface,
 * NULL for a smooth one. Error: STATUS_MEMORY. `out` is zeroed; owned: surface_record_free() whatever comes back. */
MUST_CHECK enum status_code surface_read(struct surface_record *out, const struct scene *scene,
                                         const struct scene_surface *surface, const struct surface_record *counterface,
                                         struct status *status);

/* Its steps, in their order. */

/** Two rough bodies: amplitudes and moments of the surface and of its counterface add as squares (docs/equations.md,
 * From scan to spectrum), scan by scan as many as both have; those the law is fitted to are added to `scans`. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code surface_read_counterface(struct surface_record *record, struct power_law_scans *scans,
                                                     const struct surface_record *counterface, struct status *status);

/** Once all of the files were added, in this order: a single scan (or several that are identical, which are
 * one independent scan) is the surface itself; of several profiles the longer ones are cut to subrecords as long as the
 * shortest. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code surface_read_members(struct surface_record *record, struct power_law_scans *scans,
                                                 const struct scene *scene, struct status *status);

/** Puts the scans to be run alone on the mean's grid and lets them say how far they differ. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code surface_read_repeats(struct surface_record *record, struct status *status);

#endif
