/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is to be said of a surface besides its numbers: records, of which lines are made where they are shown. */
#ifndef MEMBERS_NOTE_H
#define MEMBERS_NOTE_H

#include "base/words.h"

struct note {
    char *subject;                  /* the scan's file that it is about; NULL: the surface */
    char *what;                     /* its words, to be said by words_add() */
    size_t more;                    /* other scans of which the same is to be said */
    bool refused_scan;              /* the surface goes on without this scan: never left out */
    const struct note *counterface; /* that of the surface it is pressed against which is repeated; NULL: its own */
};

/** Owned: note_list_free(). A note that cannot be stored for want of memory is dropped. */
struct note_list {
    struct note *notes;
    size_t count;
};
void note_list_free(struct note_list *list);

/** Adds a note on a scan (NULL: the surface), told as words_say() has it; what was told of another is counted there. */
void note_add(struct note_list *list, const char *subject, const char *format, ...) PRINTF_LIKE(3, 4);
/** Adds one of a refused scan, what of the others and `why`, behind the others of that kind and before all else. */
void note_add_refused(struct note_list *list, const char *others, const char *why);
/** Repeats one of the counterface's, which has to stay. */
void note_add_counterface(struct note_list *list, const struct note *note);

/** "scan.csv: what it is (and of 2 more scans)". */
void note_line(struct text *out, struct words *words, const struct note *note);

#endif
