/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From the scans of a surface to its mean spectrum and roughness: read, conditioned, averaged. Private to src/analysis.
 */
#ifndef ANALYSIS_GATHER_H
#define ANALYSIS_GATHER_H

#include "analysis/surface.h"
#include "base/hash.h"

/** Adds a line to the surface's notes; a note that cannot be stored for want of memory is dropped. */
void gather_note(struct surface_summary *summary, const char *format, ...) PRINTF_LIKE(2, 3);

/** How the scene wants scans to be made ready. */
struct profile_options gather_profile_options(const struct scene *scene);

/** Reads one file into the surface: averages the spectrum and moments of its profile, or of every row of a map, keeps
 * scans for runs of their own, and adds them to those the law is fitted to; what is made of one profile, on all of
 * `threads`. Errors: STATUS_IO, STATUS_SCAN (one line
 * with the file's name), STATUS_MEMORY. */
MUST_CHECK enum status_code gather_file(struct surface_record *record, struct power_law_scans *scans,
                                        const struct scene *scene, const struct scene_surface *surface,
                                        const char *file, struct hash *hash, const struct threads *threads,
                                        struct status *status);

/** Two rough bodies: amplitudes and moments of the surface and of its counterface add as squares (docs/equations.md,
 * From scan to spectrum); those
 * the law is fitted to are added to `scans`. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code gather_counterface(struct surface_record *record, struct power_law_scans *scans,
                                               const struct surface_record *counterface, struct status *status);

/** Once all of the files were added, in this order: a single scan (or several that are identical, which are
 * one independent scan) is the surface itself; of several profiles the longer ones are cut to pieces as long as the
 * shortest. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code gather_conclude(struct surface_record *record, struct power_law_scans *scans,
                                            const struct scene *scene, struct status *status);

/** Puts the scans to be run alone on the mean's grid and lets them say how far they differ. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code gather_describe_repeats(struct surface_record *record, const struct scene *scene,
                                                    struct status *status);

#endif
