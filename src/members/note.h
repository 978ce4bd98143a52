/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Notes on a surface, stored as records; they become sentences where they are shown. */
#ifndef MEMBERS_NOTE_H
#define MEMBERS_NOTE_H

#include "base/words.h"

struct note {
    char *subject;                  /* the file it is about; NULL: the surface */
    char *what;                     /* record for words_add() */
    size_t more;                    /* number of further scans with the same note */
    bool refused_scan;              /* a scan that was not used: this note is always shown */
    const struct note *counterface; /* the note of the counterface that is repeated; NULL: its own */
};

/** Owned: note_list_free(). Out of memory a note is dropped, and status_lost set. */
struct note_list {
    struct note *notes;
    size_t count;
};
void note_list_free(struct note_list *list);

/** Adds a note on a scan (NULL: the surface), a record as for words_say(). The same note on another scan is only
 * counted. */
void note_add(struct note_list *list, const char *subject, const char *format, ...) PRINTF_LIKE(3, 4);
/** Adds a note on a scan that was refused, and `why`, with what became of the others. These notes stand first. */
void note_add_refused(struct note_list *list, const char *others, const char *why);
/** Repeats a note of the counterface, which must outlive this one. */
void note_add_counterface(struct note_list *list, const struct note *note);

/** "scan.csv: what it is (and of 2 more scans)". */
void note_line(struct text *out, struct words *words, const struct note *note);

#endif
