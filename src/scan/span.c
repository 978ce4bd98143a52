#include "scan/span.h"

#include <string.h>
#include <strings.h>

struct span span_trim(struct span span)
{
    while (span.start < span.end && span_is_blank_char(*span.start))
        span.start++;
    while (span.start < span.end && span_is_blank_char(span.end[-1]))
        span.end--;
    return span;
}

bool span_starts(struct span span, const char *prefix)
{
    size_t length = strlen(prefix);
    return span_length(span) >= length && strncasecmp(span.start, prefix, length) == 0;
}

bool span_equals(struct span span, const char *word)
{
    return span_length(span) == strlen(word) && span_starts(span, word);
}

struct lines lines_begin(struct span text)
{
    bool has_lf = span_length(text) > 0 && memchr(text.start, '\n', span_length(text));
    return (struct lines){.next = text.start, .end = text.end, .stop = has_lf ? '\n' : '\r'};
}

bool lines_next(struct lines *lines, struct span *line)
{
    if (lines->next >= lines->end)
        return false;
    const char *stop = memchr(lines->next, lines->stop, (size_t)(lines->end - lines->next));
    *line = (struct span){lines->next, stop ? stop : lines->end};
    lines->next = stop ? stop + 1 : lines->end;
    lines->number++;
    while (line->end > line->start && line->end[-1] == '\r')
        line->end--;
    return true;
}

bool cell_next(struct span *rest, char delimiter, struct span *cell)
{
    if (delimiter == ' ')
        *rest = span_trim(*rest);
    if (rest->start >= rest->end)
        return false;
    const char *stop = rest->start;
    if (delimiter != ' ') {
        stop = memchr(rest->start, delimiter, span_length(*rest));
        *cell = span_trim((struct span){rest->start, stop ? stop : rest->end});
        rest->start = stop ? stop + 1 : rest->end;
        return true;
    }
    for (; stop < rest->end; stop++) {
        if (!span_is_blank_char(*stop))
            continue;
        const char *next = stop;
        while (span_is_blank_char(*next)) /* `rest` is trimmed: a word follows */
            next++;
        if (*next != '[' && *next != '(')
            break;
        stop = next;
    }
    *cell = (struct span){rest->start, stop};
    rest->start = stop;
    return true;
}
