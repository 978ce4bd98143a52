/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Zip archives in memory (PKWARE APPNOTE 6.3 with ZIP64), entries stored or deflated. Before anything is unpacked, the
 * number of entries, the size that they claim and their bytes in the file are checked against base/limits.h. */
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

/** Opens `file`, which has to outlive the archive; archive_close() frees it whatever is returned. Error: STATUS_SCAN,
 * also where entries share bytes or claim more than LIMIT_MEMBERS, LIMIT_UNPACKED_BYTES or LIMIT_UNPACKED_RATIO. */
MUST_CHECK enum status_code archive_open(struct archive *out, const struct scan_file *file);
void archive_close(struct archive *archive);

/** Index of the entry `name` (case ignored; `anywhere`: in any folder); archive->count: there is none. */
size_t archive_find(const struct archive *archive, const char *name, bool anywhere);
/** Unpacks an entry into `text`, which is empty, and compares its checksum; of an entry above `most` bytes only these,
 * without the checksum. Errors name `file`. */
MUST_CHECK enum status_code archive_read(struct text *text, const struct archive *archive, size_t index, size_t most,
                                         const struct scan_file *file);

#endif
