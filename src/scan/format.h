/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the bytes of a file are, and reading those of any format that is not packed. */
#ifndef SCAN_FORMAT_H
#define SCAN_FORMAT_H

#include "base/text.h"
#include "scan/reader.h"

#include <zip.h>

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

/* Files of known kinds that no reader reads: what they are, and how a scan comes out of them. */

enum foreign_kind {
    FOREIGN_SCAN,     /* holds a measurement */
    FOREIGN_DOCUMENT, /* pictures, documents, programs: lies beside scans */
};

struct foreign {
    const char *name;    /* to follow "is a": "PNG picture" */
    const char *remedy;  /* how to get a scan out of it; NULL: the usual one */
    const char *magic;   /* its first bytes; NULL: only the ending says so */
    size_t magic_length; /* how many */
    size_t offset;       /* where they are */
    const char *endings; /* ".a .b": one of these has to end its name; NULL: any name */
    const char *entry;   /* of a zip archive: the name of an entry; NULL: no archive */
    enum foreign_kind kind;
};

/** What the bytes (the first of the file at least) and its name say; NULL: nothing known. A row without magic takes
 * binary content only. */
const struct foreign *foreign_find(const struct scan_file *file);

/** Are there NUL bytes, or control characters that no text has, in the first bytes? */
bool foreign_is_binary(const struct scan_file *file);

/** How to get a scan out of a file of which no row says it. */
extern const char foreign_usual_remedy[];

/** Does the name end in one of `endings` (".a .b", ASCII case ignored)? */
bool foreign_has_ending(const char *path, const char *endings);

/* Zip archives in memory, entries stored or deflated, by libzip. Nothing of one is trusted: before an entry is unpacked
 * their number, what all of them claim to unpack to and what they take in the file were checked against base/limits.h
 * and the file. */

struct archive {
    const struct scan_file *file;
    zip_t *zip;
    zip_stat_t *entries; /* name (NUL-terminated, UTF-8), size, ... of each */
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
