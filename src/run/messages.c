/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/messages.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { KINDS = 64 }; /* of others every message is said */

/** Notes that differ in nothing but their numbers and names. */
struct kind {
    uint64_t key;
    size_t count;
    const char *surface; /* the last that was said */
    const struct note *note;
};

struct kinds {
    struct kind of[KINDS]; /* in the order in which they were met */
    size_t count;
};

static bool is_of_number(char c)
{
    return (c >= '0' && c <= '9') || c == '.';
}

/** FNV-1a of what a message says without its digits and what stands between single quotes. */
static uint64_t key_of(const char *line)
{
    uint64_t key = UINT64_C(0xcbf29ce484222325);
    bool quoted = false;
    for (; *line; line++) {
        quoted = quoted != (*line == '\'');
        if (!quoted && !is_of_number(*line))
            key = (key ^ (unsigned char)*line) * UINT64_C(0x100000001b3);
    }
    return key;
}

/** The kind of that key; NULL: a new one for which there is no room. */
static struct kind *kind_of(struct kinds *kinds, uint64_t key)
{
    size_t at = 0;
    while (at < kinds->count && kinds->of[at].key != key)
        at++;
    if (at == KINDS)
        return NULL;
    if (at == kinds->count)
        kinds->of[kinds->count++] = (struct kind){.key = key};
    return &kinds->of[at];
}

static void say(struct text *messages, const char *surface, const char *what, const char *line)
{
    text_add(messages, "surface '");
    text_add_shown(messages, surface);
    text_add(messages, "'%s: ", what);
    text_add_shown(messages, line);
    text_add(messages, "\n");
}

static void say_note(struct text *messages, const char *surface, const struct note *note)
{
    struct text line = {0};
    note_line(&line, note);
    say(messages, surface, "", text_string(&line));
    text_free(&line);
}

/** Says a note, or counts it. */
static void take(struct text *messages, struct kinds *kinds, const char *surface, const struct note *note)
{
    struct kind *kind = kinds ? kind_of(kinds, key_of(note->what)) : NULL;
    if (kind && kind->count++ >= MESSAGES_OF_A_KIND)
        return;
    say_note(messages, surface, note);
    if (kind) {
        kind->surface = surface;
        kind->note = note;
    }
}

/** How many more there are of each kind. */
static void say_more(struct text *messages, const struct kinds *kinds)
{
    for (size_t k = 0; k < kinds->count; k++) {
        const struct kind *kind = &kinds->of[k];
        if (kind->count <= MESSAGES_OF_A_KIND)
            continue;
        text_add(messages, "... and %zu more like this, all in results.json: ", kind->count - MESSAGES_OF_A_KIND);
        say_note(messages, kind->surface, kind->note);
    }
}

size_t messages_add(struct text *messages, const struct results *results, bool reported)
{
    size_t refused = 0;
    struct kinds *kinds = reported ? calloc(1, sizeof *kinds) : NULL; /* out of memory: all are said */
    if (results->scene && results->scene->passed_over)
        text_add(messages, "%s\n", results->scene->passed_over);
    for (size_t i = 0; results->surfaces && i < results->surface_count; i++) {
        const struct surface_summary *summary = &results->surfaces[i].summary;
        const char *name = summary->scene ? summary->scene->name : NULL;
        refused += summary->refusal != NULL;
        if (summary->refusal)
            say(messages, name, " refused", summary->refusal);
        for (size_t n = 0; n < summary->notes.count; n++) {
            const struct note *note = &summary->notes.notes[n];
            bool all = summary->refusal || note->refused_scan; /* of a refused surface the report has none */
            take(messages, all ? NULL : kinds, name, note);
        }
    }
    if (kinds)
        say_more(messages, kinds);
    free(kinds);
    return refused;
}

size_t messages_add_lost(struct text *messages, const struct prepared *prepared)
{
    const struct results *results = &prepared->results;
    size_t lost = prepared->lost.count;
    for (size_t i = 0; results->surfaces && i < results->surface_count; i++)
        lost += results->surfaces[i].summary.usable ? results->surfaces[i].summary.refused_scans : 0;
    lost += prepared->counterface ? prepared->counterface->summary.refused_scans : 0;
    if (prepared->lost.count > 0)
        text_add(messages, "%s\n", prepared->lost.first);
    return lost;
}
