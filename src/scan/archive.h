/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Zip archives in memory (PKWARE APPNOTE 6.3, ZIP64 too), entries stored or deflated. Nothing of one is trusted: before
 * an entry is unpacked their number, what all of them claim to unpack to and what they take in the file were checked
 * against base/limits.h and the file. */
#ifndef SCAN_ARCHIVE_H
#define SCAN_ARCHIVE_H

#include "base/text.h"
#include "scan/reader.h"

#include <stdint.h>

struct archive_entry {
    char name[512];     /* its beginning */
    size_t size;        /* unpacked, as the directory claims */
    const char *packed; /* of packed_size bytes; NULL: they do not lie in the file */
    size_t packed_size;
    unsigned method, flags;
    uint32_t checksum;
};

struct archive {
    const struct scan_file *file;
    struct archive_entry *entries; /* owned */
    size_t count;
};

/** Opens `file`, which has to outlive the archive; archive_close() ends it whatever comes back. Error: STATUS_SCAN,
 * also where entries share bytes or more is claimed than LIMIT_MEMBERS, LIMIT_UNPACKED_BYTES and LIMIT_UNPACKED_RATIO
 * allow. */
MUST_CHECK enum status_code archive_open(struct archive *out, const struct scan_file *file);
void archive_close(struct archive *archive);

/** Index of the entry `name` (case ignored; anywhere: in any folder), archive->count when there is none. */
size_t archive_find(const struct archive *archive, const char *name, bool anywhere);
/** Unpacks an entry into `text`, which is empty, and compares its checksum; or only its first `most` bytes, where there
 * are more, and no checksum. Errors are told of `file`. */
MUST_CHECK enum status_code archive_read(struct text *text, const struct archive *archive, size_t index, size_t most,
                                         const struct scan_file *file);

#endif
