/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is to be said of a surface besides its numbers: records, of which lines are made where they are shown. */
#ifndef MEMBERS_NOTE_H
#define MEMBERS_NOTE_H

#include "base/text.h"

struct note {
    char *subject;     /* the scan's file that it is about; NULL: the surface */
    char *what;        /* one line */
    size_t more;       /* other scans of which the same is to be said */
    bool refused_scan; /* the surface goes on without this scan: never left out */
};

/** Owned: note_list_free(). A note that cannot be stored for want of memory is dropped. */
struct note_list {
    struct note *notes;
    size_t count;
};
void note_list_free(struct note_list *list);

/** Adds a note on a scan (NULL: the surface); what was said of another scan in the same words is counted there. */
void note_add(struct note_list *list, const char *subject, const char *format, ...) PRINTF_LIKE(3, 4);
/** Adds one of a refused scan, `why` and what of the others, behind the others of that kind and before all else. */
void note_add_refused(struct note_list *list, const char *why, const char *others);

/** "scan.csv: what it is (and of 2 more scans)". */
void note_line(struct text *out, const struct note *note);

#endif
