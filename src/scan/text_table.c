#include "scan/text_table.h"
#include "scan/number.h"
#include "scan/text_header.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT_COLUMNS = 65536 }; /* wider than any areal map; bounds the first row, whose width nothing else bounds */

/* One row while it is read. */
struct row {
    double *cell; /* room for `room` numbers, or NULL just to count */
    size_t room;
    size_t count;               /* cells met, trailing empty ones aside */
    unsigned decimal;           /* decimal signs met */
    struct string_view bad;     /* the first cell that is no finite number */
    struct string_view missing; /* the first cell that says that nothing was measured */
    size_t numbers;             /* cells that are numbers */
};

/* Reads the cells of `line`; false at the first that is no number. */
static bool row_read(struct row *row, struct string_view line, char delimiter)
{
    /* in a file separated by commas a comma is no decimal sign */
    unsigned allowed = delimiter == ',' ? NUMBER_POINT : NUMBER_POINT | NUMBER_COMMA;
    size_t cells = 0;
    row->count = 0;
    for (struct string_view cell; cell_next(&line, delimiter, &cell); cells++) {
        if (cell.start == cell.end)
            continue;
        double value = NAN;
        bool good = number_scan(cell, allowed, &row->decimal, &value) == cell.end && isfinite(value);
        row->numbers += good ? 1 : 0;
        if (!good && scan_is_missing(cell)) {
            row->missing = row->missing.start ? row->missing : cell;
            value = NAN;
            good = true;
        }
        if (!good || cells != row->count) {
            row->bad = cell;
            return false;
        }
        if (row->count < row->room)
            row->cell[row->count] = value;
        row->count++;
    }
    return row->count > 0;
}

/* The delimiter with which `line` is a row of numbers; 0 when it is none. "0,5 1,2" has blanks between decimal commas;
 * "0,5" is two columns, since a single column with decimal commas cannot be told from that. */
static char find_delimiter(struct string_view line, size_t *columns)
{
    static const struct {
        char delimiter;
        size_t least; /* columns */
    } ways[] = {{'\t', 2}, {';', 1}, {' ', 2}, {',', 1}, {' ', 1}};
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        char delimiter = ways[i].delimiter;
        if (delimiter != ' ' && !memchr(line.start, delimiter, string_view_length(line)))
            continue;
        struct row row = {0};
        if (row_read(&row, line, delimiter) && row.count >= ways[i].least && (row.numbers > 0 || row.count > 2)) {
            *columns = row.count;
            return delimiter;
        }
    }
    return 0;
}

static struct string_view text_of(const struct scan_bytes *file)
{
    struct string_view text = {file->bytes, file->bytes + file->length};
    if (string_view_starts(text, "\xEF\xBB\xBF"))
        text.start += 3;
    while (text.end > text.start && (text.end[-1] == '\0' || text.end[-1] == 0x1A))
        text.end--;
    return text;
}

/* Room for one row more; the first guess is as many rows as fit when all are as long as the first. */
static bool reserve(struct text_table *table, size_t *capacity, size_t line_length)
{
    if (table->rows < *capacity)
        return true;
    size_t rows = *capacity ? 2 * *capacity : string_view_length(table->text) / (line_length + 1) + 16;
    double *cell = reallocarray(table->cell, rows, table->columns * sizeof *cell);
    if (!cell)
        return false;
    table->cell = cell;
    *capacity = rows;
    return true;
}

static enum status_code fail_row(const struct text_table *table, const struct row *row, const struct scan_bytes *file,
                                 size_t line, struct status *status)
{
    if (row->bad.start)
        return scan_fail(status, file, line, "'%s' in a column of numbers; correct or remove this line",
                         scan_quote(row->bad).text);
    return scan_fail(status, file, line, "%zu columns where line %zu has %zu; correct or remove this line", row->count,
                     table->first_line, table->columns);
}

/* The rows from `lines` on; the first is there already known to be one. */
static enum status_code read_rows(struct text_table *table, struct lines lines, const struct scan_bytes *file,
                                  struct status *status)
{
    size_t capacity = 0, blank = 0;
    unsigned decimal = 0;
    for (struct string_view line; lines_next(&lines, &line);) {
        struct string_view content = string_view_trim(line);
        if (content.start == content.end) {
            blank = blank ? blank : lines.number;
            continue;
        }
        bool comment = false;
        if (*content.start == '#' || *content.start == '%' || *content.start == '/' ||
            (*content.start == ';' && table->delimiter != ';'))
            (void)text_header_uncomment(content, &comment);
        if (comment)
            continue;
        if (blank && table->columns == 1)
            return scan_fail(status, file, blank, "a blank line among the heights; remove it, or fill in the height");
        if (!reserve(table, &capacity, string_view_length(line)))
            return status_memory(status);
        struct row row = {.cell = table->cell + table->rows * table->columns, .room = table->columns};
        if (!row_read(&row, table->delimiter == ' ' ? content : line, table->delimiter) || row.count != table->columns)
            return fail_row(table, &row, file, lines.number, status);
        decimal |= row.decimal;
        if (decimal == (NUMBER_POINT | NUMBER_COMMA))
            return scan_fail(status, file, lines.number,
                             "both '.' and ',' as decimal signs; use one of them, and no thousands separator");
        if (row.missing.start && table->missing_line == 0) {
            table->missing = row.missing;
            table->missing_line = lines.number;
        }
        table->last_line = lines.number;
        table->rows++;
    }
    return STATUS_OK;
}

/* Is `line`, which stands right above the first row, a row with a damaged cell? It begins with a number, unlike titles
 * and keys. Between blanks anything may stand there (`4000 points`). */
static bool is_damaged_row(const struct text_table *table, struct string_view line, struct row *row)
{
    struct string_view rest = line, cell;
    size_t cells = 0;
    double value;
    if (table->delimiter == ' ' || !cell_next(&rest, table->delimiter, &cell) || !number_read(cell, &value))
        return false;
    for (rest = line; cell_next(&rest, table->delimiter, &cell);)
        cells++;
    return cells == table->columns && table->columns > 1 && !row_read(row, line, table->delimiter);
}

enum status_code text_table_read(struct text_table *out, const struct scan_bytes *file, struct status *status)
{
    *out = (struct text_table){.text = text_of(file)};
    struct lines lines = lines_begin(out->text), before = lines;
    struct string_view above = {NULL, NULL};
    size_t above_line = 0;
    for (struct string_view line; lines_next(&lines, &line); before = lines) {
        bool comment;
        struct string_view content = text_header_uncomment(line, &comment);
        if (comment || content.start == content.end)
            continue;
        out->delimiter = find_delimiter(line, &out->columns);
        if (!out->delimiter) {
            above = line;
            above_line = lines.number;
            continue;
        }
        struct row row = {0};
        if (above_line > 0 && above_line == lines.number - 1 && is_damaged_row(out, above, &row))
            return fail_row(out, &row, file, above_line, status);
        if (out->columns > TEXT_COLUMNS)
            return scan_fail(status, file, lines.number, "%zu columns; at most %d can be read", out->columns,
                             TEXT_COLUMNS);
        out->first_line = lines.number;
        out->preamble = (struct string_view){out->text.start, before.next};
        return read_rows(out, before, file, status);
    }
    return scan_fail(status, file, 0, "no line of numbers in it: not a scan");
}

void text_table_free(struct text_table *table)
{
    free(table->cell);
    *table = (struct text_table){0};
}

size_t text_table_line(const struct text_table *table, size_t row)
{
    struct lines lines = lines_begin(table->text);
    size_t rows = 0;
    for (struct string_view line; lines_next(&lines, &line);) {
        bool comment;
        struct string_view content = text_header_uncomment(line, &comment);
        if (lines.number < table->first_line || content.start == content.end ||
            (comment && !(*string_view_trim(line).start == ';' && table->delimiter == ';')))
            continue;
        if (rows++ == row)
            return lines.number;
    }
    return table->last_line;
}
