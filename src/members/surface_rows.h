/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From one scan to its surface: every row conditioned, its spectrum and moments taken and averaged. */
#ifndef MEMBERS_SURFACE_ROWS_H
#define MEMBERS_SURFACE_ROWS_H

#include "members/surface.h"

/** A surface whose scans are being taken. */
struct surface_rows_task {
    struct surface_record *record;
    struct power_law_scans *scans; /* that its law will be fitted to */
    const struct scene *scene;
};

/** Adds a scan, `file` of the scene: a profile, whose heights are taken over, or every row of a map. A row of a map
 * that cannot be used (all missing, flat) is left out and counted. Errors: STATUS_SCAN where none is left (one line
 * with the file's name; then nothing was added), STATUS_MEMORY. */
MUST_CHECK enum status_code surface_rows_add(const struct surface_rows_task *task, struct scan *scan, const char *file,
                                             struct status *status);

#endif
