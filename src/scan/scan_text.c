/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scans as text: columns x and z, perhaps with others beside them; heights alone below a line that names the spacing;
 * maps, as a list x y z on a grid or as a matrix of heights with its pixel size. */
#include "base/limits.h"
#include "scan/reader.h"
#include "scan/text_header.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT_POINTS = 3, TEXT_MOST_COLUMNS = 8 }; /* of numbers beside x; more are a map */

/* The numbers of a text file in rows and columns, and what the lines above them say. */
struct table {
    struct string_view text; /* the file without byte order mark and end-of-file marks */
    char delimiter;          /* ',' ';' '\t' or ' ' (any number of blanks) */
    size_t rows, columns;
    double *cell;                 /* rows x columns */
    size_t first_line, last_line; /* of the rows, from 1 */
    struct text_header header;
    size_t other_line;       /* of the first comment header below the first row; 0: none */
    struct scan_quote other; /* what it says */
    size_t others;           /* blocks of rows below such headers, which are not read */
    const struct scan_file *file;
};

/* One row while it is read. */
struct row {
    double *cell; /* room for `room` numbers, or NULL just to count */
    size_t room;
    size_t count;                      /* cells so far, without empty ones at the end */
    unsigned decimal;                  /* decimal signs so far */
    struct string_view bad;            /* the first cell that is no finite number */
    size_t numbers;                    /* cells that are numbers */
    const struct scan_options *wanted; /* where the scene chooses x and z: other columns may hold text; else NULL */
};

/* Adds an empty cell, a point that was not measured; false where the row is full. */
static bool take_blank(struct row *row)
{
    if (row->count >= row->room)
        return false;
    row->cell[row->count++] = NAN;
    return true;
}

/* Reads the cells of `line`; false at the first that is no number. Where the number of columns is known, empty cells
 * are points that were not measured, and cells beyond the last column may be empty. */
static bool read_row(struct row *row, struct string_view line, char delimiter)
{
    /* in a file separated by commas a comma is no decimal sign */
    unsigned allowed = delimiter == ',' ? NUMBER_POINT : NUMBER_POINT | NUMBER_COMMA;
    size_t cells = 0;
    bool open = delimiter != ' ' && line.end > line.start && line.end[-1] == delimiter; /* an empty cell at the end */
    row->count = 0;
    const char *start = line.start;
    for (struct string_view cell; cell_next(&line, delimiter, &cell); cells++) {
        if (cell.start == cell.end)
            continue;
        double value = NAN;
        unsigned signs =
            cell.start > start && cell.start[-1] == '"' ? NUMBER_POINT | NUMBER_COMMA : allowed; /* in quotes */
        bool good = number_scan(cell, signs, &row->decimal, &value) == cell.end && isfinite(value);
        row->numbers += good ? 1 : 0;
        if (!good && row->wanted && cells + 1 != row->wanted->z_column && cells + 1 != row->wanted->x_column)
            good = true; /* text in a column that was not chosen: a time, a name */
        /* stars are a missing point, but not a line of them above the numbers */
        if (!good && scan_is_missing(cell) && (*cell.start != '*' || row->room > 0 || row->numbers > 0)) {
            value = NAN;
            good = true;
        }
        while (good && row->count < cells && take_blank(row))
            ;
        if (!good || cells != row->count) {
            row->bad = cell;
            return false;
        }
        if (row->count < row->room)
            row->cell[row->count] = value;
        row->count++;
    }
    while (row->numbers > 0 && row->count < cells + (open ? 1 : 0) && take_blank(row))
        ;
    return row->count > 0;
}

/* The scene's choice, if it chooses x and z. */
static const struct scan_options *wanted_of(const struct scan_file *file)
{
    return file->options && file->options->z_column > 0 && file->options->x_column > 0 ? file->options : NULL;
}

/* The delimiter that makes `line` a row of numbers; 0: it is none. "0,5 1,2" are two numbers with decimal commas; "0,5"
 * counts as two columns, for nothing says that it is one number. */
static char find_delimiter(struct string_view line, const struct scan_file *file, size_t *columns)
{
    static const struct {
        char delimiter;
        size_t least; /* columns */
    } ways[] = {{'\t', 2}, {';', 1}, {' ', 2}, {',', 1}, {' ', 1}};
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        char delimiter = ways[i].delimiter;
        if (delimiter != ' ' && !memchr(line.start, delimiter, string_view_length(line)))
            continue;
        struct row row = {.wanted = wanted_of(file)};
        if (read_row(&row, line, delimiter) && row.count >= ways[i].least &&
            (!row.wanted || (row.count >= row.wanted->z_column && row.count >= row.wanted->x_column)) &&
            (row.numbers > 0 || row.count > 2)) {
            *columns = row.count;
            return delimiter;
        }
    }
    return 0;
}

static struct string_view text_of(const struct scan_file *file)
{
    struct string_view text = scan_view(file);
    if (string_view_starts(text, "\xEF\xBB\xBF"))
        text.start += 3;
    while (text.end > text.start && (text.end[-1] == '\0' || text.end[-1] == 0x1A))
        text.end--;
    return text;
}

static enum status_code fail_row(const struct table *table, const struct row *row, size_t line)
{
    if (row->bad.start)
        return scan_fail(table->file, line, "'%s' in a column of numbers; correct or remove this line",
                         scan_quote(row->bad).text);
    return scan_fail(table->file, line, "%zu columns where line %zu has %zu; correct or remove this line", row->count,
                     table->first_line, table->columns);
}

/* Is `content`, trimmed and not empty, a comment below the first row? */
static bool is_comment(const struct table *table, struct string_view content)
{
    const char *start = content.start;
    return *start == '#' || *start == '%' || (*start == '/' && start[1] == '/') ||
           (*start == ';' && table->delimiter != ';');
}

/* Is there nothing in `content`, which is trimmed, or nothing but delimiters? */
static bool is_blank(const struct table *table, struct string_view content)
{
    while (table->columns > 1 && content.start < content.end &&
           (*content.start == table->delimiter || string_view_is_blank_char(*content.start)))
        content.start++;
    return content.start == content.end;
}

static enum status_code fail_line(const struct table *table, size_t number, struct string_view line)
{
    return scan_fail(table->file, number, "a line of %zu bytes%s", string_view_length(line),
                     limit_words(LIMIT_LINE_BYTES).text);
}

/* Does the comment `content`, below the first row, have a key or a unit? Then it is a header, else a remark or a row
 * that somebody took out. */
static bool is_header(struct string_view content)
{
    bool comment;
    struct text_header said = {.valid = SIZE_MAX};
    content = text_header_uncomment(content, &comment);
    for (const char *c = content.start; c < content.end; c++) {
        bool time = c > content.start && isdigit((unsigned char)c[-1]) && isdigit((unsigned char)c[1]); /* 10:31 */
        if (*c == '=' || *c == '[' || (*c == ':' && !time))
            return true;
    }
    return text_header_add(&said, content) || said.spacing.value > 0;
}

/* The next line that is neither blank nor a comment; false behind the last one. */
static bool next_content(struct lines *lines, struct string_view *line)
{
    bool comment = true;
    struct string_view content = {NULL, NULL};
    while ((comment || content.start == content.end) && lines_next(lines, line))
        content = text_header_uncomment(*line, &comment);
    return !comment && content.start < content.end;
}

/* Columns of the next such line, 0 where it is no row of numbers or there is none. */
static size_t columns_below(struct lines lines, const struct scan_file *file)
{
    struct string_view line;
    size_t columns;
    return next_content(&lines, &line) && find_delimiter(line, file, &columns) ? columns : 0;
}

/* Does the comment `content` begin another block of rows? Then the blocks are counted, for a note. */
static bool ends_block(struct table *table, struct string_view content, struct lines lines)
{
    bool comment;
    if (table->rows == 0 || table->other_line > 0 || !is_header(content))
        return false;
    table->other = scan_quote(text_header_uncomment(content, &comment));
    table->other_line = lines.number;
    if (columns_below(lines, table->file) == 0)
        return false; /* a footer */
    table->others = 1;
    bool rows = false;
    for (struct string_view line; lines_next(&lines, &line);) {
        struct string_view trimmed = string_view_trim(line);
        if (trimmed.start == trimmed.end)
            continue;
        bool header = is_comment(table, trimmed) && is_header(trimmed);
        table->others += header && rows && columns_below(lines, table->file) > 0 ? 1 : 0;
        rows = !header && (rows || !is_comment(table, trimmed));
    }
    return true;
}

/* Reads the rows from `lines` on, of which the first is known to be one. */
static enum status_code read_rows(struct table *table, struct lines lines)
{
    size_t cells = limit_most(LIMIT_CELLS) / table->columns, points = limit_most(LIMIT_POINTS);
    size_t room = 1, blank = 0, most = cells < points ? cells : points;
    unsigned decimal = 0;
    for (const char *at = lines.next; (at = memchr(at, lines.stop, (size_t)(lines.end - at))); at++)
        room++;
    table->cell = malloc((room < most ? room : most) * table->columns * sizeof *table->cell);
    if (!table->cell)
        return status_memory(table->file->status);
    for (struct string_view line; lines_next(&lines, &line);) {
        if (string_view_length(line) > limit_most(LIMIT_LINE_BYTES))
            return fail_line(table, lines.number, line);
        struct string_view content = string_view_trim(line);
        if (is_blank(table, content)) {
            blank = blank ? blank : lines.number;
            continue;
        }
        if (is_comment(table, content) && ends_block(table, content, lines))
            break;
        if (is_comment(table, content))
            continue;
        if (blank && table->columns == 1)
            return scan_fail(table->file, blank, "a blank line among the heights; remove it, or fill in the height");
        if (table->rows >= most)
            return scan_fail(table->file, lines.number, "too many rows%s",
                             limit_words(most == points ? LIMIT_POINTS : LIMIT_CELLS).text);
        struct row row = {.cell = table->cell + table->rows * table->columns,
                          .room = table->columns,
                          .wanted = wanted_of(table->file)};
        if (!read_row(&row, table->delimiter == ' ' ? content : line, table->delimiter) || row.count != table->columns)
            return fail_row(table, &row, lines.number);
        decimal |= row.decimal;
        if (decimal == (NUMBER_POINT | NUMBER_COMMA))
            return scan_fail(table->file, lines.number,
                             "both '.' and ',' as decimal signs; use one of them, and no thousands separator");
        table->last_line = lines.number;
        table->rows++;
    }
    return STATUS_OK;
}

/* Is `line`, right above the first row, a row with a damaged cell? Unlike titles and keys it begins with a number.
 * Words between blanks tell nothing (`4000 points`). */
static bool is_damaged_row(const struct table *table, struct string_view line, struct row *row)
{
    struct string_view rest = line, cell;
    size_t cells = 1;
    double value;
    if (table->delimiter == ' ' || !cell_next(&rest, table->delimiter, &cell) || !number_read(cell, &value))
        return false;
    while (cell_next(&rest, table->delimiter, &cell))
        cells++;
    return cells == table->columns && table->columns > 1 && !read_row(row, line, table->delimiter);
}

/* Does `content` say only how many rows follow? Then the row below it has more columns. */
static bool is_count(size_t *announced, struct string_view content, struct lines lines, const struct scan_file *file)
{
    while (content.end > content.start && strchr(",;", content.end[-1]))
        content.end--;
    return number_read_size(content, announced) && columns_below(lines, file) > 1;
}

/* Is `line` of `text` farther down than a header may go? */
static bool is_too_deep(struct string_view text, struct string_view line)
{
    return (size_t)(line.start - text.start) > limit_most(LIMIT_HEADER_BYTES);
}

/* Finds the first line that is a row of numbers and reads from there to the end; comments and, with two columns or
 * more, blank lines are passed over. */
static enum status_code read_table(struct table *table)
{
    table->text = text_of(table->file);
    struct lines lines = lines_begin(table->text), before = lines;
    struct string_view above = {NULL, NULL};
    size_t above_line = 0, announced = 0, announced_line = 0; /* rows that a line above them says follow */
    for (struct string_view line; lines_next(&lines, &line); before = lines) {
        bool comment;
        if (string_view_length(line) > limit_most(LIMIT_LINE_BYTES))
            return fail_line(table, lines.number, line);
        if (is_too_deep(table->text, line))
            return scan_fail(table->file, lines.number, "no line of numbers so far: not a scan%s",
                             limit_words(LIMIT_HEADER_BYTES).text);
        struct string_view content = text_header_uncomment(line, &comment);
        if (comment || content.start == content.end)
            continue;
        table->delimiter = find_delimiter(line, table->file, &table->columns);
        if (!table->delimiter) {
            above = line;
            above_line = lines.number;
            continue;
        }
        if (table->columns == 1 && is_count(&announced, content, lines, table->file)) {
            announced_line = lines.number;
            continue;
        }
        struct row row = {0};
        if (above_line > 0 && above_line == lines.number - 1 && is_damaged_row(table, above, &row))
            return fail_row(table, &row, above_line);
        if (table->columns > limit_most(LIMIT_COLUMNS))
            return scan_fail(table->file, lines.number, "%zu columns%s", table->columns,
                             limit_words(LIMIT_COLUMNS).text);
        table->first_line = lines.number;
        struct string_view preamble = {table->text.start, before.next};
        table->header = text_header_read(preamble, table->delimiter, table->columns);
        if (read_rows(table, before) == STATUS_OK && announced_line > 0 && announced != table->rows)
            return scan_fail(table->file, announced_line,
                             "%zu points are announced, %zu follow; copy the file again, or remove this line",
                             announced, table->rows);
        return table->file->status->code;
    }
    return scan_fail(
        table->file, 0,
        "no line of numbers in it: not a scan; where columns hold text choose others, as in `column: [2, 3]`");
}

bool scan_text_has_numbers(const struct scan_file *file)
{
    size_t columns;
    struct string_view text = text_of(file);
    struct lines lines = lines_begin(text);
    for (struct string_view line; next_content(&lines, &line) && !is_too_deep(text, line);)
        if (string_view_length(line) <= limit_most(LIMIT_LINE_BYTES) && find_delimiter(line, file, &columns))
            return true;
    return false;
}

bool scan_text_read_keys(struct text_header *out, const struct scan_file *file)
{
    return scan_text_sniff(file) && !scan_text_has_numbers(file) && text_header_add(out, text_of(file));
}

/* The line of row `row` (from 0). */
static size_t line_of_row(const struct table *table, size_t row)
{
    struct lines lines = lines_begin(table->text);
    for (struct string_view line; lines_next(&lines, &line);) {
        struct string_view content = string_view_trim(line);
        if (lines.number >= table->first_line && !is_blank(table, content) && !is_comment(table, content) && row-- == 0)
            break;
    }
    return lines.number;
}

static double at(const struct table *table, size_t row, size_t column)
{
    return table->cell[row * table->columns + column];
}

/* Heights that instruments write where they measured nothing (-25400 um is one inch down). They count as missing only
 * where every other height is this many times smaller. */
static const double sentinels[] = {-25400, -32768, -99999, -9999, 9999, 99999, 1e10, -2147483648.0};
static const double sentinel_distance = 4;
/* Any other height counts as missing where it is repeated and lies this many times the range of the others away. */
static const double gap_distance = 20;
static const double gap_share = 0.1; /* of the points, at most */

static bool is_mark(double height, double mark)
{
    return fabs(height - mark) <= 1e-12 * fabs(mark);
}

static void take_out(struct scan *out, double mark)
{
    for (size_t i = 0; i < out->nx * out->ny; i++)
        out->z_m[i] = is_mark(out->z_m[i], mark) ? NAN : out->z_m[i];
}

/* The highest or the lowest height, where it is repeated and far from all others. */
static void mark_gap(struct scan *out, bool highest)
{
    const size_t points = out->nx * out->ny;
    double extreme = NAN, others[2] = {INFINITY, -INFINITY};
    size_t found = 0;
    for (size_t i = 0; i < points; i++)
        extreme = highest ? fmax(extreme, out->z_m[i]) : fmin(extreme, out->z_m[i]);
    for (size_t i = 0; i < points; i++) {
        found += out->z_m[i] == extreme;
        others[0] = out->z_m[i] != extreme ? fmin(others[0], out->z_m[i]) : others[0];
        others[1] = out->z_m[i] != extreme ? fmax(others[1], out->z_m[i]) : others[1];
    }
    const double range = others[1] - others[0], apart = highest ? extreme - others[1] : others[0] - extreme;
    if (found < 2 || (double)found > gap_share * (double)points || !(range > 0 && apart > gap_distance * range))
        return;
    take_out(out, extreme);
    scan_warn(out, "a height of %g %s, %zu times, lies over %g times the range of all others away: taken as missing",
              extreme / scan_unit_m(out->z_unit), out->z_unit, found, gap_distance);
}

static void mark_missing(struct scan *out)
{
    const double z_m = scan_unit_m(out->z_unit);
    for (size_t k = 0; k < sizeof sentinels / sizeof *sentinels; k++) {
        double mark = sentinels[k] * z_m;
        size_t found = 0, near = 0;
        for (size_t i = 0; i < out->nx * out->ny; i++) {
            bool is = is_mark(out->z_m[i], mark);
            found += is ? 1 : 0;
            near += !is && fabs(out->z_m[i]) * sentinel_distance > fabs(mark) ? 1 : 0;
        }
        if (found < (mark > 0 || mark < -1e6 * z_m ? 2 : 1) || near > 0)
            continue;
        take_out(out, mark);
        scan_warn(out, "a height of %g %s stands for missing points: %zu", sentinels[k], out->z_unit, found);
    }
    mark_gap(out, true);
    mark_gap(out, false);
}

/* Takes the heights of column out->z_column from row `first` on, and the positions of out->x_column if there is one.
 * Points with 0 in the header's column `valid` are missing. */
static enum status_code take_columns(struct scan *out, const struct table *table, size_t first, double x_m, double z_m)
{
    size_t n = table->rows - first, columns = table->columns, valid = table->header.valid;
    struct text *spent = table->file->options->spent;
    if (spent && spent->data == table->file->bytes && !out->units_lacking) /* else a sidecar may make it read again */
        text_free(spent);
    if ((out->x_column > 0 ? scan_reserve_x(out, (double)n, n, table->file)
                           : scan_reserve(out, (double)n, 1, n, table->file)) != STATUS_OK)
        return table->file->status->code;
    for (size_t i = 0; i < n; i++) {
        const double *row = table->cell + (first + i) * columns;
        if (out->x_m)
            out->x_m[i] = row[out->x_column - 1] * x_m;
        out->z_m[i] = valid >= columns || row[valid] != 0 ? row[out->z_column - 1] * z_m : NAN;
    }
    return STATUS_OK;
}

/* Accretech and Surfcom write the length in mm and the number of heights above the heights in um. */
static enum status_code take_accretech(struct scan *out, struct table *table)
{
    double x_m, z_m;
    const struct scan_options *scene = table->file->options;
    bool x_given = scene->x_unit && *scene->x_unit, z_given = scene->z_unit && *scene->z_unit;
    if (scan_units(out, x_given ? "" : "mm", z_given ? "" : "um", &x_m, &z_m, table->file) != STATUS_OK)
        return table->file->status->code;
    out->format = "accretech";
    out->dx_m = table->cell[0] / (double)(table->rows - 3) * x_m;
    if (!x_given || !z_given)
        scan_warn(out, "the file names no units: length taken as %s and heights as %s, as Accretech writes them",
                  out->x_unit, out->z_unit);
    return take_columns(out, table, 2, x_m, z_m);
}

/* scan_units() with what the header says of out->x_column and out->z_column; `x_unit`, where given, comes first. */
static enum status_code take_units(struct scan *out, const struct table *table, const char *x_unit, double *x_m,
                                   double *z_m)
{
    const struct text_header *header = &table->header;
    x_unit = x_unit ? x_unit : text_header_x_unit(header, out->x_column);
    const char *z_unit = text_header_z_unit(header, out->z_column);
    const size_t columns[] = {x_unit ? 0 : out->x_column, z_unit ? 0 : out->z_column};
    for (size_t i = 0; i < 2; i++)
        if (columns[i] > 0 && columns[i] <= TEXT_HEADER_COLUMNS && header->unknown[columns[i] - 1].start)
            scan_copy(out->unknown_unit[i], sizeof out->unknown_unit[i], header->unknown[columns[i] - 1]);
    if (scan_units(out, x_unit, z_unit, x_m, z_m, table->file) != STATUS_OK)
        return table->file->status->code;
    if (header->all_unit && x_unit == header->all_unit && z_unit == header->all_unit)
        scan_warn(out, "the file names one unit for x and z alike, %s", out->x_unit);
    return STATUS_OK;
}

/* Refuses a length that two lines of the header name differently. */
static enum status_code check_said_once(const struct table *table, const struct text_quantity *said, const char *what)
{
    if (said->other == 0)
        return STATUS_OK;
    bool ordered = said->line < said->other;
    size_t first = ordered ? said->line : said->other, second = ordered ? said->other : said->line;
    return scan_fail(table->file, first, "lines %zu and %zu name two %s; remove the one that is not meant", first,
                     second, what);
}

/* Column `z` alone, at the spacing that the header names. */
static enum status_code take_heights(struct scan *out, struct table *table, size_t z)
{
    const struct text_quantity *spacing = &table->header.spacing;
    const double *cell = table->cell;
    size_t rows = table->columns == 1 ? table->rows : 0; /* where the first ones may be none */
    double x_m, z_m;
    out->z_column = z + 1;
    if (spacing->value <= 0 && rows >= TEXT_POINTS + 2 && cell[0] > 0 && cell[1] == (double)(rows - 2))
        return take_accretech(out, table);
    if (spacing->value <= 0)
        return scan_fail(table->file, table->first_line,
                         "one column is heights only: no spacing; add a line `spacing 0.5 um` above the numbers, or a "
                         "column x");
    if (check_said_once(table, spacing, "spacings") != STATUS_OK ||
        take_units(out, table, spacing->unit, &x_m, &z_m) != STATUS_OK)
        return table->file->status->code;
    out->dx_m = spacing->value * x_m;
    size_t whole = 1; /* numbers that may be heights in digits */
    while (whole < rows && cell[whole] == round(cell[whole]))
        whole++;
    const bool counted = rows > TEXT_POINTS && cell[0] == (double)(rows - 1) && whole < rows;
    if (counted)
        scan_warn(out, "the first number, %zu, says how many heights follow", rows - 1);
    return take_columns(out, table, counted ? 1 : 0, x_m, z_m);
}

static const char *or_semicolons(const struct table *table)
{
    return table->delimiter == ',' ? ", or separate the columns by semicolons if the commas are decimal signs" : "";
}

/* The scan in columns `x` and `z`. */
static enum status_code take_points(struct scan *out, struct table *table, size_t x, size_t z)
{
    const struct text_header *header = &table->header;
    double x_m, z_m;
    size_t rows = table->rows, columns = table->columns;
    if (z >= columns)
        return scan_fail(table->file, table->first_line, "no column of heights beside x");
    out->x_column = x + 1;
    out->z_column = z + 1;
    if (take_units(out, table, NULL, &x_m, &z_m) != STATUS_OK)
        return table->file->status->code;
    size_t bad = scan_disorder(table->cell + x, columns, rows);
    if (bad < rows && isnan(at(table, bad, x)))
        return scan_fail(table->file, line_of_row(table, bad), "no x here; fill it in or remove this line");
    if (bad < rows)
        return scan_fail(table->file, line_of_row(table, bad),
                         "x %s; x has to go one way: sort or remove points, choose it by `column`%s",
                         bad > 0 && at(table, bad, x) == at(table, bad - 1, x) ? "is that of the point before"
                                                                               : "turns back",
                         or_semicolons(table));
    if (take_columns(out, table, 0, x_m, z_m) != STATUS_OK)
        return table->file->status->code;
    const char *unit = header->spacing.unit ? header->spacing.unit : out->x_unit;
    if (header->spacing.value > 0 && header->spacing.other == 0)
        out->nominal_dx_m = header->spacing.value * scan_unit_m(unit);
    if (columns > (header->valid < columns ? 3 : 2) && table->file->options->z_column == 0)
        scan_warn(out, "%zu columns: column %zu read as x, column %zu as z, the others ignored", columns, x + 1, z + 1);
    return STATUS_OK;
}

static bool goes_one_way(const struct table *table, size_t column)
{
    return scan_disorder(table->cell + column, table->columns, table->rows) == table->rows;
}

/* Does the first column have equal steps, apart from rounding? */
static bool has_even_steps(const struct table *table)
{
    double first = table->cell[0], last = at(table, table->rows - 1, 0);
    double step = (last - first) / (double)(table->rows - 1);
    for (size_t i = 1; i < table->rows; i++)
        if (!(fabs(at(table, i, 0) - (first + (double)i * step)) <= 0.5 * fabs(step)))
            return false;
    return step != 0;
}

/* Does the first column count, by one from row to row? */
static bool counts(const struct table *table)
{
    for (size_t i = 0; i < table->rows; i++)
        if (at(table, i, 0) != at(table, 0, 0) + (double)i || at(table, i, 0) != round(at(table, i, 0)))
            return false;
    return true;
}

/* The column that is x: the first, unless that counts the points (then the first one with a unit that goes one way) or
 * is the only one of three without a unit. */
static size_t find_x(const struct table *table)
{
    const struct text_header *header = &table->header;
    bool first_named =
        header->unit[0] || (table->file->options->sidecar && table->file->options->sidecar->header.unit[0]);
    if (table->columns < 3 || header->valid <= 2 || first_named)
        return 0;
    if (goes_one_way(table, 1)) {
        bool from_start = table->cell[0] == 0 || table->cell[0] == 1;
        return (header->unit[1] && header->unit[2]) || (from_start && counts(table)) ? 1 : 0;
    }
    for (size_t c = 1; c < table->columns && c < TEXT_HEADER_COLUMNS && counts(table); c++)
        if (header->unit[c] && goes_one_way(table, c))
            return c;
    return 0;
}

/* Are the rows those of a map? Where the header does not say so, only if the first column cannot be x. */
static bool is_matrix(const struct table *table)
{
    const struct text_header *header = &table->header;
    bool said =
        header->pixel.value > 0 || (header->width.value > 0 && header->height.value > 0) || header->behind_lengths;
    if (table->columns < 4 || table->rows < 2 || header->unit[0])
        return false;
    return said || (!has_even_steps(table) && (table->columns > TEXT_MOST_COLUMNS || !goes_one_way(table, 0)));
}

/* The columns that the scene chooses: z, and perhaps x. Where there is no other column that can be x, the header's
 * spacing is used. */
static enum status_code take_chosen(struct scan *out, struct table *table)
{
    const size_t columns = table->columns;
    const size_t given[] = {table->file->options->z_column, table->file->options->x_column};
    for (size_t i = 0; i < 2; i++)
        if (given[i] > columns)
            return scan_fail(table->file, table->first_line, "there is no column %zu: there %s %zu column%s", given[i],
                             columns == 1 ? "is" : "are", columns, columns == 1 ? "" : "s");
    bool x_given = given[1] > 0;
    size_t z = given[0] - 1, x = x_given ? given[1] - 1 : columns > 1 ? find_x(table) : 0;
    bool no_x = x == z || (table->header.spacing.value > 0 && !goes_one_way(table, x));
    if (!x_given && no_x && (columns == 1 || table->header.spacing.value > 0))
        return take_heights(out, table, z);
    if (x == z)
        return scan_fail(table->file, table->first_line,
                         "column %zu cannot be x and z; choose both, as in `column: [1, 2]`", z + 1);
    return take_points(out, table, x, z);
}

enum { LIST_COLUMNS = 3 };

/* How far a point may be off its place on the grid: in steps, for instruments jitter, plus a share of its coordinate,
 * for Gwyddion exports five digits; at most so many steps. */
static const double grid_jitter = 0.01, grid_rounding = 1e-4, grid_most = 0.25;

/* One of the two directions of a list: the fast one steps from point to point, the slow one from line to line. */
struct direction {
    size_t column; /* 0 x, 1 y */
    size_t n;
    double first, step; /* in the unit of the file; the step may be negative */
};

static void find_directions(const struct table *table, struct direction *fast, struct direction *slow)
{
    fast->column = at(table, 0, 0) == at(table, 1, 0) ? 1 : 0;
    slow->column = 1 - fast->column;
    fast->first = at(table, 0, fast->column);
    slow->first = at(table, 0, slow->column);
    for (fast->n = 1; fast->n < table->rows && at(table, fast->n, slow->column) == slow->first;)
        fast->n++;
    slow->n = table->rows / fast->n;
    fast->step = (at(table, fast->n - 1, fast->column) - fast->first) / (double)(fast->n - 1);
    slow->step =
        slow->n > 1 ? (at(table, (slow->n - 1) * fast->n, slow->column) - slow->first) / (double)(slow->n - 1) : 0.0;
}

/* Are the three columns x, y and z: does one of x and y stay while the other steps? */
static bool is_list(const struct table *table)
{
    if (table->columns != LIST_COLUMNS || table->rows < 4)
        return false;
    bool x_stays = at(table, 0, 0) == at(table, 1, 0), y_stays = at(table, 0, 1) == at(table, 1, 1);
    if (x_stays == y_stays)
        return false;
    struct direction fast, slow;
    find_directions(table, &fast, &slow);
    /* the second line starts where the first did; two equal heights in a row do not make a list */
    return slow.n < 2 || fabs(at(table, fast.n, fast.column) - fast.first) <= grid_jitter * fabs(fast.step);
}

static bool on_grid(const struct table *table, size_t row, const struct direction *direction, size_t index)
{
    double place = direction->first + (double)index * direction->step, step = fabs(direction->step);
    return fabs(at(table, row, direction->column) - place) <=
           fmin(grid_most * step, grid_jitter * (1 + grid_jitter) * step + grid_rounding * fabs(place)) +
               1e-12 * fabs(direction->first);
}

/* A point's index in the map, which ascends whichever way the instrument went. */
static size_t place(const struct direction *direction, size_t index)
{
    return direction->step < 0 ? direction->n - 1 - index : index;
}

static enum status_code take_list(struct scan *out, const struct table *table)
{
    double x_m, z_m;
    struct direction fast, slow;
    find_directions(table, &fast, &slow);
    out->x_column = 1;
    out->z_column = LIST_COLUMNS;
    if (take_units(out, table, NULL, &x_m, &z_m) != STATUS_OK)
        return table->file->status->code;
    const char *y_unit = table->header.unit[1] ? table->header.unit[1] : table->header.y_unit;
    double y_m = y_unit ? scan_unit_m(y_unit) : x_m;
    bool along_x = fast.column == 0 || slow.n == 1; /* one line is a profile, whichever way it goes */
    const struct direction *x = along_x ? &fast : &slow, *y = along_x ? &slow : &fast;
    if (scan_reserve(out, (double)x->n, (double)y->n, table->rows, table->file) != STATUS_OK)
        return table->file->status->code;
    for (size_t row = 0; row < table->rows; row++) {
        size_t f = row % fast.n, s = row / fast.n;
        if (!on_grid(table, row, &fast, f) || !on_grid(table, row, &slow, s))
            return scan_fail(table->file, line_of_row(table, row),
                             "this point is not on the grid of the points before; only maps on a grid can be read");
        if (s == slow.n)
            return scan_fail(table->file, table->last_line, "the last row of points is not complete: %zu of %zu",
                             table->rows % fast.n, fast.n);
        size_t ix = place(x, along_x ? f : s), iy = place(y, along_x ? s : f);
        out->z_m[iy * x->n + ix] = at(table, row, 2) * z_m;
    }
    out->dx_m = fabs(x->step) * (x->column == 0 ? x_m : y_m); /* one line may go along y */
    out->dy_m = fabs(y->step) * y_m;
    return STATUS_OK;
}

/* Are the two lengths of the header width and height: in Gwyddion's order of lines, or with square pixels? */
static bool are_extents(const struct table *table, const struct text_quantity *length)
{
    static const double square = 0.02;
    if (!(length[0].value > 0 && length[1].value > 0))
        return false;
    double dx_m = length[0].value * scan_unit_m(length[0].unit) / (double)table->columns;
    double dy_m = length[1].value * scan_unit_m(length[1].unit) / (double)table->rows;
    return table->header.behind_lengths || fabs(dx_m - dy_m) <= square * dx_m;
}

static enum status_code take_matrix(struct scan *out, struct table *table)
{
    struct text_header *header = &table->header;
    double x_m, z_m, factor = header->z_factor.value > 0 ? header->z_factor.value : 1;
    struct text_quantity width = header->width, height = header->height;
    struct text_quantity step = header->pixel.value > 0 ? header->pixel : header->spacing;
    struct text_quantity step_y = header->pixel_y.value > 0 ? header->pixel_y : step;
    if (step.value > 0) {
        width = (struct text_quantity){step.value * (double)table->columns, step.unit, step.line, step.other};
        height = (struct text_quantity){step_y.value * (double)table->rows, step_y.unit, step_y.line, step_y.other};
    } else if (!(width.value > 0 && height.value > 0) && are_extents(table, header->length)) {
        width = header->length[0];
        height = header->length[1];
        header->z_unit = header->z_unit ? header->z_unit : header->behind_lengths;
    }
    if (check_said_once(table, &width, step.value > 0 ? "pixel sizes" : "widths") != STATUS_OK ||
        check_said_once(table, &height, step.value > 0 ? "pixel sizes" : "heights of the map") != STATUS_OK)
        return table->file->status->code;
    if (!(width.value > 0 && height.value > 0))
        return scan_fail(table->file, table->first_line,
                         "a matrix of %zu x %zu heights without its pixel size; add a line `pixel size = 0.5 um` above "
                         "the numbers, or keep two columns, x and z%s",
                         table->columns, table->rows, or_semicolons(table));
    if (take_units(out, table, width.unit, &x_m, &z_m) != STATUS_OK ||
        scan_reserve(out, (double)table->columns, (double)table->rows, table->columns * table->rows, table->file) !=
            STATUS_OK)
        return table->file->status->code;
    for (size_t i = 0; i < table->columns * table->rows; i++)
        out->z_m[i] = table->cell[i] * factor * z_m;
    double y_m = height.unit ? scan_unit_m(height.unit) : x_m;
    out->dx_m = width.value / (double)table->columns * x_m;
    out->dy_m = height.value / (double)table->rows * y_m;
    return STATUS_OK;
}

static enum status_code take_table(struct scan *out, struct table *table)
{
    if (table->file->options->z_column > 0 && table->rows >= TEXT_POINTS)
        return take_chosen(out, table);
    if (is_list(table))
        return take_list(out, table);
    if (is_matrix(table))
        return take_matrix(out, table);
    if (table->rows < TEXT_POINTS)
        return scan_fail(table->file, table->last_line, "points: %zu; a scan needs at least %d", table->rows,
                         TEXT_POINTS);
    if (table->columns == 1)
        return take_heights(out, table, 0);
    size_t x = find_x(table);
    if (x > 1) /* after a counter: the heights are the first other column with a unit */
        for (size_t c = 1; c < table->columns && c < TEXT_HEADER_COLUMNS; c++)
            if (c != x && table->header.unit[c])
                return take_points(out, table, x, c);
    return take_points(out, table, x, table->header.valid == x + 1 ? x + 2 : x + 1);
}

enum status_code scan_text_read(struct scan *out, const struct scan_file *file)
{
    struct table table = {.file = file};
    if (read_table(&table) == STATUS_OK && take_table(out, &table) == STATUS_OK) {
        mark_missing(out);
        if (table.others > 0)
            scan_warn(out,
                      "%zu more block%s of rows, the first below line %zu, '%s': only the first of the file was read; "
                      "save the one you mean as a file of its own",
                      table.others, table.others == 1 ? "" : "s", table.other_line, table.other.text);
    }
    free(table.cell);
    return file->status->code;
}
