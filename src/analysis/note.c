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

static void insert(struct note_list *list, size_t at, const char *subject, const char *what, bool refused_scan)
{
    struct note *notes = reallocarray(list->notes, list->count + 1, sizeof *notes);
    if (!notes)
        return;
    list->notes = notes;
    struct note note = {subject ? strdup(subject) : NULL, strdup(what), 0, refused_scan};
    if (!note.what || (subject && !note.subject)) {
        free(note.subject);
        free(note.what);
        return;
    }
    memmove(notes + at + 1, notes + at, (list->count - at) * sizeof *notes);
    notes[at] = note;
    list->count++;
}

void note_add(struct note_list *list, const char *subject, const char *what)
{
    for (size_t i = 0; i < list->count && subject; i++)
        if (list->notes[i].subject && strcmp(list->notes[i].what, what) == 0) {
            list->notes[i].more++;
            return;
        }
    insert(list, list->count, subject, what, false);
}

void note_say(struct note_list *list, const char *format, ...)
{
    char *line = NULL;
    va_list args;
    va_start(args, format);
    int length = vasprintf(&line, format, args);
    va_end(args);
    if (length < 0)
        return;
    insert(list, list->count, NULL, line, false);
    free(line);
}

void note_add_refused(struct note_list *list, const char *what)
{
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
