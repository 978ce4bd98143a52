/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The files of OUT/data (docs/report.md): CSV, every number SI with 17 digits. Columns and rows of effects that did
 * not run are absent; what a model does not compute is an empty cell. */
#ifndef OUTPUT_TABLES_H
#define OUTPUT_TABLES_H

#include "base/threads.h"
#include "results/results.h"

/** Writes surfaces, spectrum and contact; convergence, cost, and (where a surface has several scans) spread and bands
 * when there are such, below `directory` (data/ exists). What is a surface's own is made by `threads`, in the surfaces'
 * order whatever their number. Errors: STATUS_IO, STATUS_MEMORY, STATUS_INTERRUPTED. */
MUST_CHECK enum status_code tables_write(const struct results *results, const char *directory,
                                         const struct threads *threads, struct status *status);

#endif
