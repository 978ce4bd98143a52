/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The program Gwyddion, where it is installed, reads what no reader here does. It is never needed. */
#ifndef SCAN_GWYDDION_H
#define SCAN_GWYDDION_H

#include "base/text.h"

/** Is there a program `gwyddion` in PATH? */
bool gwyddion_exists(void);

/** Adds the file at `path` to `out` as Gwyddion converts it to its own format (`gwyddion --convert-to-gwy`), in a
 * private directory that is removed again, whatever comes back. Errors: STATUS_SCAN: it cannot read it, or took too
 * long; STATUS_IO, STATUS_MEMORY; STATUS_INTERRUPTED. */
MUST_CHECK enum status_code gwyddion_convert(struct text *out, const char *path, struct status *status);

#endif
