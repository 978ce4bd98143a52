/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/note.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void note_list_free(struct note_list *list)
{
    for (size_t i = 0; i < list->count; i++) {
        free(list->notes[i].subject);
        free(list->notes[i].what);
    }
    free(list->notes);
    *list = (struct note_list){0};
}

/** Adds a note, whose line is malloc'ed and taken over (NULL: out of memory). */
static void insert(struct note_list *list, size_t at, const char *subject, char *what, bool refused_scan)
{
    struct note *notes = reallocarray(list->notes, list->count + 1, sizeof *notes);
    struct note note = {subject ? strdup(subject) : NULL, what, 0, refused_scan};
    if (notes)
        list->notes = notes;
    if (!notes || !what || (subject && !note.subject)) {
        free(note.subject);
        free(what);
        status_lost = true;
        return;
    }
    memmove(notes + at + 1, notes + at, (list->count - at) * sizeof *notes);
    notes[at] = note;
    list->count++;
}

void note_add(struct note_list *list, const char *subject, const char *format, ...)
{
    char *what = NULL;
    va_list args;
    va_start(args, format);
    what = vasprintf(&what, format, args) < 0 ? NULL : what;
    va_end(args);
    for (size_t i = 0; i < list->count && subject && what; i++)
        if (list->notes[i].subject && strcmp(list->notes[i].what, what) == 0) {
            list->notes[i].more++;
            free(what);
            return;
        }
    insert(list, list->count, subject, what, false);
}

void note_add_refused(struct note_list *list, const char *format, ...)
{
    char *what = NULL;
    va_list args;
    va_start(args, format);
    what = vasprintf(&what, format, args) < 0 ? NULL : what;
    va_end(args);
    size_t at = 0;
    while (at < list->count && list->notes[at].refused_scan)
        at++;
    insert(list, at, NULL, what, true);
}

void note_line(struct text *out, const struct note *note)
{
    text_add(out, "%s%s%s", note->subject ? note->subject : "", note->subject ? ": " : "", note->what);
    if (note->more > 0)
        text_add(out, " (and of %zu more scan%s)", note->more, note->more == 1 ? "" : "s");
}
