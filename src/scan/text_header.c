#include "scan/text_header.h"
#include "scan/number.h"
#include "scan/reader.h"

#include <string.h>

static const char *const comment_marks[] = {"#", "//", "%", ";"};
static const char *const spacing_words[] = {"spacing",  "dx",        "deltax", "step",    "resolution",
                                            "interval", "increment", "pitch",  "sampling"};
/* a step of the heights or of the rows is none along the profile */
static const char *const other_axes[] = {"y", "z", "dy", "dz", "height", "vertical"};

#define COUNT(array) (sizeof(array) / sizeof *(array))

struct span text_header_uncomment(struct span line, bool *comment)
{
    line = span_trim(line);
    *comment = false;
    for (size_t i = 0; i < COUNT(comment_marks); i++) {
        while (span_starts(line, comment_marks[i])) {
            line.start += strlen(comment_marks[i]);
            *comment = true;
        }
    }
    return span_trim(line);
}

static bool is_one_of(struct span word, const char *const *words, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (span_equals(word, words[i]))
            return true;
    return false;
}

/* Cuts the next word off `rest`; *before is the separator in front of it that says most ('(', '[', '/', '=' ...). */
static bool word_next(struct span *rest, struct span *word, char *before)
{
    *before = '\0';
    for (; rest->start < rest->end && strchr(" \t_[](){}<>/,;:=\"'", *rest->start); rest->start++)
        if (*before == '\0' || strchr("[({/", *rest->start))
            *before = *rest->start;
    word->start = rest->start;
    while (rest->start < rest->end && !strchr(" \t_[](){}<>/,;:=\"'", *rest->start))
        rest->start++;
    word->end = rest->start;
    return word->end > word->start;
}

static bool is_number(struct span word)
{
    double value;
    return number_scan(word, NUMBER_POINT, NULL, &value) != NULL;
}

/* The unit a column's title names: its last word that is one. Where a word might be something else ("A", "in", and all
 * of them in a line with numbers, `Length, 1500.0 um`) brackets or a slash have to say that a unit is meant. */
static const char *cell_unit(struct span cell, bool with_numbers)
{
    const char *unit = NULL;
    struct span word;
    char before;
    while (word_next(&cell, &word, &before)) {
        const char *name = scan_unit_name(word.start, span_length(word));
        bool is_word = with_numbers || span_equals(word, "a") || span_equals(word, "in") || span_equals(word, "u");
        if (name && (!is_word || (before && strchr("[({/", before))))
            unit = name;
    }
    return unit;
}

/* The units of a line of `columns` titles; false when it is none: another number of cells, or numbers among them
 * (`1500.0 um`). */
static bool read_titles(struct text_header *header, struct span line, char delimiter, size_t columns)
{
    const char *units[TEXT_HEADER_COLUMNS] = {NULL};
    size_t count = 0, filled = 0;
    bool with_numbers = false;
    char before;
    for (struct span rest = line, word; word_next(&rest, &word, &before);)
        with_numbers = with_numbers || is_number(word);
    struct span cell;
    while (cell_next(&line, delimiter, &cell)) {
        if (is_number(cell))
            return false;
        if (count < TEXT_HEADER_COLUMNS)
            units[count] = cell_unit(cell, with_numbers);
        count++;
        if (cell.end > cell.start)
            filled = count;
    }
    if (filled != columns)
        return false;
    for (size_t i = 0; i < columns && i < TEXT_HEADER_COLUMNS; i++)
        if (units[i])
            header->unit[i] = units[i];
    return true;
}

/* `spacing 0.5 um`, `dx=0.5um`, `Resolution,0.156 um/sample`, `Step (um): 0.5`: up to four words, one of them for a
 * spacing, then the number and perhaps a unit, which stands behind the number or in brackets before it. */
static void read_spacing(struct text_header *header, struct span line)
{
    struct span rest = line, word;
    char before;
    const char *unit = NULL;
    bool is_spacing = false;
    for (int words = 0; words < 5 && word_next(&rest, &word, &before); words++) {
        double value;
        const char *end = number_scan(word, NUMBER_POINT, NULL, &value);
        if (!end) {
            if (is_one_of(word, other_axes, COUNT(other_axes)))
                return;
            is_spacing = is_spacing || is_one_of(word, spacing_words, COUNT(spacing_words));
            if (before && strchr("[({", before))
                unit = scan_unit_name(word.start, span_length(word));
            continue;
        }
        struct span behind = {end, word.end};
        bool sign = before && strchr("=:,;\t", before);
        if (behind.start < behind.end || word_next(&rest, &behind, &before))
            unit = scan_unit_name(behind.start, span_length(behind));
        if (is_spacing && (unit || sign) && value > 0 && value < 1e300) {
            header->spacing = value;
            header->spacing_unit = unit;
        }
        return;
    }
}

struct text_header text_header_read(struct span preamble, char delimiter, size_t columns)
{
    struct text_header header = {0};
    struct span last[TEXT_HEADER_LINES];
    size_t count = 0;
    struct lines lines = lines_begin(preamble);
    struct span line;
    while (lines_next(&lines, &line)) {
        bool comment;
        line = text_header_uncomment(line, &comment);
        if (line.start == line.end)
            continue;
        last[count++ % TEXT_HEADER_LINES] = line;
        read_spacing(&header, line);
    }
    static const char others[] = {'\t', ';', ',', ' '}; /* titles may be set differently from the numbers */
    for (size_t i = count < TEXT_HEADER_LINES ? 0 : count - TEXT_HEADER_LINES; i < count; i++) {
        line = last[i % TEXT_HEADER_LINES];
        bool found = read_titles(&header, line, delimiter, columns);
        for (size_t k = 0; k < COUNT(others) && !found; k++)
            found = read_titles(&header, line, others[k], columns);
    }
    return header;
}
