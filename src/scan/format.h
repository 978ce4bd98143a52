/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the bytes of a file are, and reading those of any format that is not packed. */
#ifndef SCAN_FORMAT_H
#define SCAN_FORMAT_H

#include "scan/foreign.h"

enum format_kind {
    FORMAT_UNKNOWN, /* empty, or binary of no known format */
    FORMAT_SCAN,    /* a reader knows its bytes, or a text that may be a scan */
    FORMAT_PACKED,  /* "zip", an archive that may hold scans, or "gz" */
    FORMAT_FOREIGN, /* a measurement in a format that is not read */
    FORMAT_OTHER    /* certainly no scan */
};

struct format {
    enum format_kind kind;
    const char *name; /* of the reader or of what it is; NULL: not known */
    const struct scan_reader *reader;
    const struct foreign *foreign;
};

/** What these bytes, all of the file (`whole`) or its first, are by themselves and by its name. */
struct format format_of(const struct scan_file *file, bool whole);

/** Reads a file, or what was within a packed one; packed it may not be. */
MUST_CHECK enum status_code format_read(struct scan *out, const struct scan_file *file);

/** STATUS_SCAN: what the file is, and how to get a scan out of it. */
enum status_code format_fail_foreign(const struct scan_file *file, const struct foreign *foreign);

/** Reads a zip archive with scans of any other format in it, one scan packed by gzip, or a file as it is. */
MUST_CHECK enum status_code scan_packed_read(struct scan *out, const struct scan_file *file);

#endif
