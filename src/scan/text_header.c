#include "scan/text_header.h"
#include "scan/number.h"
#include "scan/reader.h"
#include "scan/text_key.h"

#include <stdint.h>
#include <string.h>

static const char *const comment_marks[] = {"#", "//", "%", ";"};

#define COUNT(array) (sizeof(array) / sizeof *(array))

struct string_view text_header_uncomment(struct string_view line, bool *comment)
{
    line = string_view_trim(line);
    *comment = false;
    for (size_t i = 0; i < COUNT(comment_marks); i++) {
        while (string_view_starts(line, comment_marks[i])) {
            line.start += strlen(comment_marks[i]);
            *comment = true;
        }
    }
    return string_view_trim(line);
}

/* The unit a column's title names: its last word that is one. Where a word might be something else ("A", "in", and all
 * of them in a line with numbers, `Length, 1500.0 um`) brackets or a slash have to say that a unit is meant. */
static const char *cell_unit(struct string_view cell, bool with_numbers)
{
    const char *unit = NULL;
    struct string_view word;
    char before;
    while (text_key_word(&cell, &word, &before)) {
        const char *name = scan_unit_name(word.start, string_view_length(word));
        bool is_word = with_numbers || string_view_equals(word, "a") || string_view_equals(word, "in") ||
                       string_view_equals(word, "u");
        if (name && (!is_word || (before && strchr("[({/", before))))
            unit = name;
    }
    return unit;
}

/* The titles of a line of `columns` cells; false when it is none: another number of cells, or numbers among them. */
static bool read_titles(struct text_header *header, struct string_view line, char delimiter, size_t columns)
{
    const char *units[TEXT_HEADER_COLUMNS] = {NULL};
    size_t count = 0, filled = 0, valid = SIZE_MAX;
    bool with_numbers = false;
    char before;
    for (struct string_view rest = line, word; text_key_word(&rest, &word, &before);)
        with_numbers = with_numbers || text_key_number(word);
    struct string_view cell;
    while (cell_next(&line, delimiter, &cell)) {
        if (text_key_number(cell))
            return false;
        if (count < TEXT_HEADER_COLUMNS)
            units[count] = cell_unit(cell, with_numbers);
        if (string_view_equals(cell, "valid"))
            valid = count;
        count++;
        if (cell.end > cell.start)
            filled = count;
    }
    if (filled != columns)
        return false;
    for (size_t i = 0; i < columns && i < TEXT_HEADER_COLUMNS; i++)
        if (units[i])
            header->unit[i] = units[i];
    if (valid < columns)
        header->valid = valid;
    return true;
}

struct text_header text_header_read(struct string_view preamble, char delimiter, size_t columns)
{
    struct text_header header = {.valid = SIZE_MAX, .z_factor = 1};
    struct string_view last[TEXT_HEADER_LINES];
    size_t count = 0;
    struct lines lines = lines_begin(preamble);
    struct string_view line;
    while (lines_next(&lines, &line)) {
        bool comment;
        line = text_header_uncomment(line, &comment);
        if (line.start == line.end)
            continue;
        last[count++ % TEXT_HEADER_LINES] = line;
        text_key_read(&header, line);
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
