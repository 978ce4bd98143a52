/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files of known kinds that no reader reads: what they are, and how a scan comes out of them. */
#ifndef SCAN_FOREIGN_H
#define SCAN_FOREIGN_H

#include "scan/reader.h"

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

#endif
