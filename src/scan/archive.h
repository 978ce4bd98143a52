/* Zip archives in memory. */
#ifndef SCAN_ARCHIVE_H
#define SCAN_ARCHIVE_H

#include "base/text.h"
#include "scan/reader.h"

/** No file unpacks to more. */
enum { ARCHIVE_MOST_BYTES = 1 << 30 };

struct archive {
    void *zip; /* libzip's */
    const struct scan_bytes *file;
};

/** Opens `file`, which has to outlive the archive; archive_close() ends it whatever comes back. */
MUST_CHECK enum status_code archive_open(struct archive *out, const struct scan_bytes *file, struct status *status);
void archive_close(struct archive *archive);

size_t archive_count(const struct archive *archive);
/** Name of entry `index`, NULL when it has none. */
const char *archive_name(const struct archive *archive, size_t index);
/** Index of the entry `name` (case ignored; anywhere: in any folder), archive_count() when there is none. */
size_t archive_find(const struct archive *archive, const char *name, bool anywhere);
/** Has the archive in `file` such an entry, as archive_find() seeks it? `damaged` where it cannot be opened. */
bool archive_has(const struct scan_bytes *file, const char *name, bool anywhere, bool damaged);
/** Unpacks an entry into `text`, never more than deflate can have made of the file's bytes. */
MUST_CHECK enum status_code archive_read(struct text *text, const struct archive *archive, size_t index,
                                         struct status *status);

#endif
