/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/string_view.h"

#include <string.h>
#include <strings.h>

struct string_view string_view_trim(struct string_view view)
{
    while (view.start < view.end && string_view_is_blank_char(*view.start))
        view.start++;
    while (view.start < view.end && string_view_is_blank_char(view.end[-1]))
        view.end--;
    return view;
}

bool string_view_starts(struct string_view view, const char *prefix)
{
    size_t length = strlen(prefix);
    return string_view_length(view) >= length && strncasecmp(view.start, prefix, length) == 0;
}

bool string_view_equals(struct string_view view, const char *word)
{
    return string_view_length(view) == strlen(word) && string_view_starts(view, word);
}

bool string_view_is_one_of(struct string_view view, const char *words)
{
    size_t length = string_view_length(view);
    for (const char *end; *words; words = end + (*end == ' ')) {
        end = strchrnul(words, ' ');
        if (length > 0 && (size_t)(end - words) == length && strncasecmp(view.start, words, length) == 0)
            return true;
    }
    return false;
}

struct lines lines_begin(struct string_view text)
{
    bool has_lf = string_view_length(text) > 0 && memchr(text.start, '\n', string_view_length(text));
    return (struct lines){.next = text.start, .end = text.end, .stop = has_lf ? '\n' : '\r'};
}

bool lines_next(struct lines *lines, struct string_view *line)
{
    if (lines->next >= lines->end)
        return false;
    const char *stop = memchr(lines->next, lines->stop, (size_t)(lines->end - lines->next));
    *line = (struct string_view){lines->next, stop ? stop : lines->end};
    lines->next = stop ? stop + 1 : lines->end;
    lines->number++;
    while (line->end > line->start && line->end[-1] == '\r')
        line->end--;
    return true;
}

bool cell_next(struct string_view *rest, char delimiter, struct string_view *cell)
{
    if (delimiter == ' ')
        *rest = string_view_trim(*rest);
    if (rest->start >= rest->end)
        return false;
    const char *stop = rest->start;
    if (delimiter != ' ') {
        stop = memchr(rest->start, delimiter, string_view_length(*rest));
        *cell = string_view_trim((struct string_view){rest->start, stop ? stop : rest->end});
        rest->start = stop ? stop + 1 : rest->end;
        return true;
    }
    for (; stop < rest->end; stop++) {
        if (!string_view_is_blank_char(*stop))
            continue;
        const char *next = stop;
        while (string_view_is_blank_char(*next)) /* `rest` is trimmed: a word follows */
            next++;
        if (*next != '[' && *next != '(')
            break;
        stop = next;
    }
    *cell = (struct string_view){rest->start, stop};
    rest->start = stop;
    return true;
}
