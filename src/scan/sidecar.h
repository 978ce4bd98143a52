/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A file beside a scan that says its units: `scan.dat` may have `scan.txt`, `scan.json`, `scan.hdr` or `scan.dat.txt`,
 * ... Two kinds are known: the JSON of the DABAM metrology database (X1_FACTOR, Y1_FACTOR, ...: metres or radians per
 * unit of a column), and lines or JSON members such as `x_unit: mm`, as in the header of a text scan. */
#ifndef SCAN_SIDECAR_H
#define SCAN_SIDECAR_H

#include "base/text.h"
#include "scan/text_header.h"

/** Can a file named `beside` be the sidecar of one named `scan`? Both without a directory. */
bool sidecar_fits(const char *beside, const char *scan);

/** Has `name` the ending of a sidecar? *length gets how much stands before that ending. */
bool sidecar_ending(const char *name, size_t *length);

/** Reads the file at `path`. Returns whether it is a regular file that names units and has no row of numbers. */
bool sidecar_read(struct sidecar *out, const char *path);
/** The same of the file's content. */
bool sidecar_read_text(struct sidecar *out, const struct text *bytes, const char *path);

/** Reads the first sidecar there is of the scan at `path`: *found gets its path (malloc'ed), NULL where there is none.
 * Error: STATUS_MEMORY. */
MUST_CHECK enum status_code sidecar_find(struct sidecar *out, char **found, const char *path, struct status *status);

#endif
