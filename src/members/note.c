/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "members/note.h"

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
    struct note *notes = reallocarray(list->notes, list->count + 1, sizeof *notes);
    struct note note = {.subject = subject ? strdup(subject) : NULL, .what = what};
    if (notes)
        list->notes = notes;
    if (!notes || !what || (subject && !note.subject)) {
        free(note.subject);
        free(what);
        status_lost = true;
        return;
    }
    notes[list->count++] = note;
}

void note_add_refused(struct note_list *list, const char *others, const char *why)
{
    size_t at = 0, before = list->count;
    note_add(list, NULL, "note.refused\n%s\nwhy\t%s", others, why);
    if (list->count == before)
        return;
    struct note note = list->notes[before];
    note.refused_scan = true;
    while (at < before && list->notes[at].refused_scan)
        at++;
    memmove(list->notes + at + 1, list->notes + at, (before - at) * sizeof note);
    list->notes[at] = note;
}

void note_add_counterface(struct note_list *list, const struct note *note)
{
    size_t before = list->count;
    note_add(list, NULL, "%s", note->what);
    if (list->count > before)
        list->notes[before].counterface = note;
}

void note_line(struct text *out, struct words *words, const struct note *note)
{
    const struct note *of = note->counterface ? note->counterface : note;
    OWNED(text_free) struct text line = {0};
    text_add(&line, "note.line\n%s\n%s %zu\nwhat\t%s%s", of == note ? "" : "counterface",
             of->more > 1   ? "several"
             : of->more > 0 ? "one"
                            : "none",
             of->more, of->subject ? of->subject : "", of->subject ? ": " : "");
    (void)words_add(&line, words, note->what, NULL);
    (void)words_add(out, words, text_string(&line), NULL);
}
