/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/scene_words.h"

#include <ctype.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/param.h>

struct scene_words_shown scene_words_show(const char *text)
{
    return scene_words_show_view(string_view_of(text));
}

struct scene_words_shown scene_words_show_view(struct string_view view)
{
    struct scene_words_shown shown;
    const char *text = view.start;
    size_t length = string_view_length(view);
    size_t most = sizeof shown.text - sizeof "...";
    bool whole = length <= most;
    if (!whole) {
        length = most;
        while (length > 0 && ((unsigned char)text[length] & 0xc0) == 0x80) /* not inside a UTF-8 character */
            length--;
    }
    for (size_t i = 0; i < length; i++) {
        unsigned char c = (unsigned char)text[i];
        shown.text[i] = c < 0x20 || c == 0x7f ? '?' : text[i];
    }
    strcpy(shown.text + length, whole ? "" : "...");
    return shown;
}

enum { LONGEST_WORD = 63 };

/* Characters to insert, delete or replace (Levenshtein) to make `b` of `a`, case aside. */
static size_t edit_distance(const char *a, const char *b)
{
    size_t columns = strlen(b), distance[LONGEST_WORD + 1];
    for (size_t j = 0; j <= columns; j++)
        distance[j] = j;
    for (size_t i = 1; a[i - 1]; i++) {
        size_t diagonal = distance[0];
        distance[0] = i;
        for (size_t j = 1; j <= columns; j++) {
            size_t replaced = diagonal + (tolower((unsigned char)a[i - 1]) != tolower((unsigned char)b[j - 1]));
            diagonal = distance[j];
            distance[j] = MIN(replaced, 1 + MIN(distance[j], distance[j - 1]));
        }
    }
    return distance[columns];
}

struct scene_words_hint scene_words_hint(const char *word, const char *const *names, size_t count, size_t all)
{
    struct scene_words_hint hint = {""};
    size_t nearest = 0, best = SIZE_MAX;
    for (size_t i = 0; i < all && strlen(word) <= LONGEST_WORD; i++) {
        size_t distance = edit_distance(word, names[i]);
        if (distance < best) {
            best = distance;
            nearest = i;
        }
    }
    if (best <= 1 + strlen(word) / 4) {
        snprintf(hint.text, sizeof hint.text, "did you mean '%s'?", names[nearest]);
        return hint;
    }
    size_t used = 0;
    for (size_t i = 0; i < count && used < sizeof hint.text; i++)
        used += (size_t)snprintf(hint.text + used, sizeof hint.text - used, "%s%s", i ? ", " : "allowed: ", names[i]);
    return hint;
}

const char *scene_words_next(const char **rest, size_t *length)
{
    static const char separators[] = ", \t\r\n";
    const char *word = *rest + strspn(*rest, separators);
    *length = strcspn(word, separators);
    *rest = word + *length;
    return *length ? word : NULL;
}

size_t scene_words_find(const char *word, size_t length, const char *const *names, size_t count)
{
    size_t i = 0;
    while (i < count && !(strlen(names[i]) == length && memcmp(names[i], word, length) == 0))
        i++;
    return i;
}
