#include "scan/text_header.h"
#include "scan/number.h"
#include "scan/reader.h"
#include "scan/text_key.h"

#include <stdint.h>
#include <string.h>

static const char *const comment_marks[] = {"#", "//", "%", ";"};

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

bool text_header_title_slope(struct span title)
{
    static const char *const slopes[] = {"slope", "slopes", "gradient"};
    static const char *const heights[] = {"dz", "dh", "dy"};
    static const char *const undone[] = {"removed",     "removal",     "corrected",    "correction", "subtracted",
                                         "subtraction", "compensated", "compensation", "detrended",  "out"};
    bool slope = false;
    struct span word, last = {NULL, NULL};
    for (char before; text_key_word(&title, &word, &before); last = word) {
        slope = slope || is_one_of(word, slopes, COUNT(slopes)) ||
                (before == '/' && last.start && span_equals(word, "dx") && is_one_of(last, heights, COUNT(heights)));
        if (is_one_of(word, undone, COUNT(undone)))
            return false;
    }
    return slope;
}

/* The unit a column's title names: its last word that is one. Where a word might be something else ("A", "in", and all
 * of them in a line with numbers, `Length, 1500.0 um`) brackets or a slash have to say that a unit is meant. */
static const char *cell_unit(struct span cell, bool with_numbers)
{
    const char *unit = NULL;
    struct span word, last = {NULL, NULL};
    for (char before; text_key_word(&cell, &word, &before); last = word) {
        const char *name = text_key_unit(word);
        bool is_word = with_numbers || span_equals(word, "a") || span_equals(word, "in") || span_equals(word, "u");
        if (name && (!is_word || (before && strchr("[({/", before))))
            unit = name;
        if (name && before == '/' && last.start && last.end + 1 == word.start) { /* um/mm */
            name = scan_unit_slope_name(last.start, (size_t)(word.end - last.start));
            unit = name ? name : unit;
        }
    }
    return unit;
}

/* Nothing but a unit, or something in brackets, as in a line of units below the titles. */
static bool is_bare(struct span cell)
{
    return text_key_unit(cell) || (span_length(cell) > 2 && strchr("[({", *cell.start) && strchr("])}", cell.end[-1]));
}

/* Is the only column's line about x, or a key with its number (`dx [mm] = 0.5`)? */
static bool is_about_x(struct span line)
{
    static const char *const words[] = {"x", "dx", "lateral", "horizontal", "spacing", "step", "length", "position"};
    bool number = false, sign = false, about = false;
    struct span word;
    for (char before; text_key_word(&line, &word, &before);) {
        sign = sign || before == '=' || before == ':';
        number = number || (text_key_number(word) && sign);
        about = about || is_one_of(word, words, COUNT(words));
    }
    return number || about;
}

static bool has_numbers(struct span line)
{
    struct span word;
    for (char before; text_key_word(&line, &word, &before);)
        if (text_key_number(word))
            return true;
    return false;
}

/* The titles of a line of `columns` cells; false when it is none: another number of cells, or numbers among them. */
static bool read_titles(struct text_header *header, struct span line, char delimiter, size_t columns)
{
    const char *units[TEXT_HEADER_COLUMNS] = {NULL};
    bool slopes[TEXT_HEADER_COLUMNS] = {false}, bares[TEXT_HEADER_COLUMNS] = {false};
    size_t count = 0, filled = 0, valid = SIZE_MAX, bare = 0;
    bool with_numbers = has_numbers(line);
    if (columns == 1 && is_about_x(line))
        return false;
    struct span cell;
    while (cell_next(&line, delimiter, &cell)) {
        if (text_key_number(cell))
            return false;
        if (count < TEXT_HEADER_COLUMNS) {
            units[count] = cell_unit(cell, with_numbers);
            slopes[count] = text_header_title_slope(cell);
            bares[count] = cell.end > cell.start && is_bare(cell);
            bare += bares[count] ? 1 : 0;
        }
        if (span_equals(cell, "valid"))
            valid = count;
        count++;
        if (cell.end > cell.start)
            filled = count;
    }
    if (filled != columns)
        return false;
    for (size_t i = 0; i < columns && i < TEXT_HEADER_COLUMNS; i++) {
        /* one unit alone, `X: mm`, need not be that of the column it stands above */
        if (units[i] && !(columns > 1 && bare == 1 && bares[i]))
            header->unit[i] = units[i];
        header->slope[i] = header->slope[i] || slopes[i];
    }
    if (valid < columns)
        header->valid = valid;
    return true;
}

/* The last lines of `preamble` that are not blank, uncommented: *count of them, the oldest first. */
static void last_lines(struct span last[TEXT_HEADER_LINES], size_t *count, struct span preamble)
{
    *count = 0;
    struct lines lines = lines_begin(preamble);
    for (struct span line; lines_next(&lines, &line);) {
        bool comment;
        line = text_header_uncomment(line, &comment);
        if (line.start == line.end)
            continue;
        if (*count == TEXT_HEADER_LINES)
            memmove(last, last + 1, (TEXT_HEADER_LINES - 1) * sizeof *last);
        else
            ++*count;
        last[*count - 1] = line;
    }
}

static const char others[] = {'\t', ';', ',', ' '}; /* titles may be set differently from the numbers */

struct text_header text_header_read(struct span preamble, char delimiter, size_t columns)
{
    struct text_header header = {.valid = SIZE_MAX, .z_factor = 1}, ignored = {.z_factor = 1};
    struct span last[TEXT_HEADER_LINES], line;
    size_t count;
    struct lines lines = lines_begin(preamble);
    while (lines_next(&lines, &line)) {
        bool comment;
        (void)text_key_read(&header, text_header_uncomment(line, &comment));
    }
    last_lines(last, &count, preamble);
    for (size_t i = 0; i < count; i++) {
        if (text_key_read(&ignored, last[i])) /* `X unit: mm` is no pair of titles */
            continue;
        bool found = read_titles(&header, last[i], delimiter, columns);
        for (size_t k = 0; k < COUNT(others) && !found; k++)
            found = read_titles(&header, last[i], others[k], columns);
    }
    return header;
}

/* `title` without quotes around it and, where `bare`, without a unit in brackets behind it. */
static struct span title_of(struct span cell, bool bare)
{
    const char *bracket = cell.start;
    if (span_length(cell) > 1 && *cell.start == '"' && cell.end[-1] == '"')
        cell = (struct span){cell.start + 1, cell.end - 1};
    for (bracket = cell.start; bare && bracket < cell.end; bracket++)
        if (strchr("[({", *bracket) && *bracket)
            break;
    return span_trim((struct span){cell.start, bare && bracket > cell.start ? bracket : cell.end});
}

/* The column of `line` titled so; as text_header_find(). */
static size_t find_title(struct span line, char delimiter, size_t columns, const char *title)
{
    size_t cells = 0, whole = 0, bare = 0, wholes = 0, bares = 0;
    for (struct span cell; cell_next(&line, delimiter, &cell);) {
        if (cell.end > cell.start)
            cells++;
        if (span_equals(title_of(cell, false), title) && wholes++ == 0)
            whole = cells;
        if (span_equals(title_of(cell, true), title) && bares++ == 0)
            bare = cells;
    }
    if (cells != columns)
        return 0;
    return wholes > 0 ? (wholes > 1 ? SIZE_MAX : whole) : bares > 1 ? SIZE_MAX : bare;
}

size_t text_header_find(struct span preamble, char delimiter, size_t columns, const char *title)
{
    struct span last[TEXT_HEADER_LINES];
    size_t count, found = 0;
    last_lines(last, &count, preamble);
    for (size_t i = count; i-- > 0 && found == 0;) {
        found = find_title(last[i], delimiter, columns, title);
        for (size_t k = 0; k < COUNT(others) && found == 0; k++)
            found = find_title(last[i], others[k], columns, title);
    }
    return found;
}

static const char *column_unit(const struct text_header *header, size_t column)
{
    return column > 0 && column <= TEXT_HEADER_COLUMNS ? header->unit[column - 1] : NULL;
}

static const char *either(const char *first, const char *second)
{
    return first ? first : second;
}

const char *text_header_x_unit(const struct text_header *header, size_t column)
{
    return either(either(column_unit(header, column), header->x_unit), header->all_unit);
}

const char *text_header_z_unit(const struct text_header *header, size_t column, bool slope)
{
    const char *y_unit = column == 1 || column == 2 ? header->y_unit : NULL;
    const char *unit = either(either(column_unit(header, column), header->z_unit), either(y_unit, header->all_unit));
    if (!unit || !slope || scan_unit_slope(unit, strlen(unit)) > 0)
        return unit;
    return header->factors ? scan_unit_of(scan_unit_m(unit, strlen(unit)), SCAN_SLOPE) : NULL;
}

bool text_header_is_slope(const struct text_header *header, size_t column)
{
    const char *unit = text_header_z_unit(header, column, false);
    return header->z_slope || (column > 0 && column <= TEXT_HEADER_COLUMNS && header->slope[column - 1]) ||
           (unit && scan_unit_slope(unit, strlen(unit)) > 0);
}

enum status_code text_header_units(struct scan *out, const struct text_header *header, const char *x_unit, double *x_m,
                                   double *z_m, const struct scan_bytes *file, const struct scan_options *options,
                                   struct status *status)
{
    bool slope = text_header_is_slope(header, out->z_column);
    x_unit = either(x_unit, text_header_x_unit(header, out->x_column));
    const char *z_unit = text_header_z_unit(header, out->z_column, slope);
    out->quantity = slope ? SCAN_SLOPE : SCAN_HEIGHT;
    if (scan_units(out, x_unit, z_unit, x_m, z_m, file, options, status) != STATUS_OK)
        return status->code;
    if (header->all_unit && (x_unit == header->all_unit) && (z_unit == header->all_unit))
        scan_warn(out, "the file names one unit for x and z alike, %s", out->x_unit);
    return STATUS_OK;
}
