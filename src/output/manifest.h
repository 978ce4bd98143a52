/* SPDX-License-Identifier: GPL-3.0-or-later */
/* manifest.txt in OUT names the files of the report, one a line; only these are ever replaced or removed. */
#ifndef OUTPUT_MANIFEST_H
#define OUTPUT_MANIFEST_H

#include "base/text.h"

#define MANIFEST_NAME "manifest.txt"
/** Its first line, by which it is told from a file of the user's. */
#define MANIFEST_HEADER "# the files of this report by roughcontact, which its next run replaces; no others\n"

/** What a directory holds, sorted by name, "data/contact.csv" where it lies in one of a report's folders. */
struct manifest_entries {
    char **names;
    size_t count;
};

/** Lists all in `directory` and its folders data and figures, but these two. Links are not followed. To be freed
 * whatever comes back. Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code manifest_entries(struct manifest_entries *out, const char *directory,
                                             struct status *status);
void manifest_entries_free(struct manifest_entries *entries);

/** Writes the manifest of all that lies in `directory`, itself included. Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code manifest_write(const char *directory, struct status *status);

/** Reads the manifest of `directory`; empty when there is none or it is not the program's. Errors: STATUS_IO,
 * STATUS_MEMORY. */
MUST_CHECK enum status_code manifest_read(struct text *out, const char *directory, struct status *status);

/** Does the manifest name this entry? */
bool manifest_lists(const struct text *manifest, const char *name);

#endif
