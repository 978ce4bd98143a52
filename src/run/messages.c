/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/messages.h"

#include <string.h>

enum {
    KINDS = 64,        /* kinds of notes that are counted; notes of further kinds get a line each */
    REFUSALS_SAID = 10 /* lines on refused surfaces and scans; more are only counted */
};

/** Notes that differ only in numbers and names. */
struct kind {
    size_t surfaces;
    const char *first, *last; /* of the surfaces */
    const struct note *note;  /* of the first */
};

/** Skips digits and names in single quotes. */
static const char *skip_names(const char *line)
{
    for (;;) {
        line += strspn(line, "0123456789.");
        const char *end = *line == '\'' ? strchr(line + 1, '\'') : NULL;
        if (!end)
            return line;
        line = end + 1;
    }
}

static bool is_alike(const char *a, const char *b)
{
    while (a = skip_names(a), b = skip_names(b), *a && *a == *b) {
        a++;
        b++;
    }
    return *a == *b;
}

/** The file of a counterface's note; files of the surface itself are not distinguished. */
static const char *file_of(const struct note *note)
{
    return !note->counterface ? "/" : note->counterface->subject ? note->counterface->subject : "";
}

static void say(struct text *messages, const char *surface, const char *what, const char *line)
{
    text_add(messages, "surface '");
    text_add_shown(messages, surface);
    text_add(messages, "'%s: ", what);
    text_add_shown(messages, line);
    text_add(messages, "\n");
}

/** Adds the line of a kind. */
static void say_note(struct text *messages, const struct kind *kind, struct words *words)
{
    OWNED(text_free) struct text line = {0};
    note_line(&line, words, kind->note);
    if (kind->surfaces > 1) /* whose numbers may be others */
        text_add(&line, " (and such a note on %zu more)", kind->surfaces - 1);
    say(messages, kind->first, "", text_string(&line));
}

/** Counts a note with its kind; false: there are too many kinds. */
static bool take(struct kind kinds[KINDS], const char *surface, const struct note *note)
{
    size_t k = 0;
    while (k < KINDS && kinds[k].note &&
           !(is_alike(kinds[k].note->what, note->what) && is_alike(file_of(kinds[k].note), file_of(note))))
        k++;
    if (k == KINDS)
        return false;
    if (!kinds[k].note)
        kinds[k] = (struct kind){0, surface, NULL, note};
    kinds[k].surfaces += kinds[k].last != surface;
    kinds[k].last = surface;
    return true;
}

size_t messages_add(struct text *messages, size_t *left_out, const struct results *results, bool reported)
{
    size_t refused = 0, refusals = 0; /* surfaces; surfaces and scans */
    struct kind kinds[KINDS] = {0};   /* in the order in which they were met */
    *left_out = results->counterface ? results->counterface->summary.refused_scans : 0;
    if (results->scene && results->scene->passed_over)
        text_add(messages, "%s\n", results->scene->passed_over);
    for (size_t i = 0; results->surfaces && i < results->surface_count; i++) {
        const struct surface_summary *summary = &results->surfaces[i].summary;
        const char *name = summary->scene ? summary->scene->name : NULL;
        refused += summary->refusal != NULL;
        *left_out += summary->usable ? summary->refused_scans : 0;
        if (summary->refusal && refusals++ < REFUSALS_SAID)
            say(messages, name, " refused", summary->refusal);
        for (size_t n = 0; n < summary->notes.count; n++) {
            const struct note *note = &summary->notes.notes[n];
            refusals += note->refused_scan;
            if ((summary->refusal || note->refused_scan) && refusals > REFUSALS_SAID)
                continue;
            bool alone = !reported || summary->refusal || note->refused_scan; /* not in the report, or needs action */
            if (alone || !take(kinds, name, note))
                say_note(messages, &(struct kind){1, name, name, note}, results->plan->words);
        }
    }
    if (refusals > REFUSALS_SAID)
        text_add(messages, "and %zu more refused; `roughcontact inspect --json` names all\n", refusals - REFUSALS_SAID);
    for (size_t k = 0; k < KINDS && kinds[k].note; k++)
        say_note(messages, &kinds[k], results->plan->words);
    return refused;
}
