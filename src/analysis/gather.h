/* From the scans of a surface to its mean spectrum and roughness: read, conditioned, averaged. Private to src/analysis.
 */
#ifndef ANALYSIS_GATHER_H
#define ANALYSIS_GATHER_H

#include "analysis/surface.h"
#include "base/hash.h"

/** Adds a line to the surface's notes; a note that cannot be stored for want of memory is dropped. */
void gather_note(struct surface_summary *summary, const char *format, ...) PRINTF_LIKE(2, 3);

/** Reads one file into the surface: averages the spectrum and moments of its profile, or of every row of a map, and
 * keeps scans for runs of their own. Errors: STATUS_IO, STATUS_SCAN (one line with the file's name), STATUS_MEMORY. */
MUST_CHECK enum status_code gather_file(struct surface_record *record, const struct scene *scene,
                                        const struct scene_surface *surface, const char *file, struct hash *hash,
                                        struct status *status);

/** Two rough bodies: amplitudes and moments of the surface and of its counterface add as squares (docs/equations.md,
 * From scan to spectrum).
 * Error: STATUS_MEMORY. */
MUST_CHECK enum status_code gather_counterface(struct surface_record *record, const struct surface_record *counterface,
                                               struct status *status);

/** Puts the scans to be run alone on the mean's grid and lets them say how far they differ; a single one is let go.
 * Error: STATUS_MEMORY. */
MUST_CHECK enum status_code gather_describe_repeats(struct surface_record *record, const struct scene *scene,
                                                    struct status *status);
void gather_free_repeats(struct surface_record *record);

#endif
