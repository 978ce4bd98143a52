/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/measured_file.h"
#include "base/limits.h"

#include "scene/scene_words.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of a measurement, and of a field of pressure. */
static const char *const column_names[][MEASURED_COLUMNS] = {{"load", "resistance", "error"}, {"x", "y", "pressure"}};
static const char *const row_names[] = {"load, resistance and perhaps its error", "x, y and pressure"};
/* Headings that say P/(A_n E'): the column of contact.csv, and how it is written. */
static const char *const dimensionless_names[] = {"load_over_AnEp", "P/(A_n E')", "P/(Aₙ E′)"};

enum { CELLS_MOST = 8, NUMBER_EITHER = NUMBER_POINT | NUMBER_COMMA }; /* no comma is left in cells split at it */

/* Orders of load, resistance and error; the first one unless the units show another. */
static const size_t orders[][MEASURED_COLUMNS] = {{0, 1, 2}, {1, 0, 2}, {2, 0, 1}, {0, 2, 1}};

/* The cells of a line; those beyond the last are empty. */
struct cells {
    struct string_view cell[CELLS_MOST];
    size_t count;
};

/* The state of reading a file. */
struct reading {
    struct measured_file *out;
    const unsigned *quantities; /* of each column */
    bool field;                 /* of pressure: its places are any number */
    const size_t *order;        /* one of `orders` */
    size_t line;                /* of messages */
    struct cells heading;       /* the last line of titles above the rows */
    size_t heading_line;
    bool labels; /* the first column names the rows */
    struct status *status;
};

static bool starts_number(struct string_view cell)
{
    double value;
    const char *end = number_scan(cell, NUMBER_EITHER, NULL, &value);
    return end && (end == cell.end || string_view_is_blank_char(*end));
}

/* Cells end at semicolons, else at tabs, else at commas, else at blanks; quotes around them are removed. */
static struct cells split(struct string_view line)
{
    const char *delimiter = ";\t,";
    struct cells out = {0};
    while (*delimiter && !memchr(line.start, *delimiter, string_view_length(line)))
        delimiter++;
    for (struct string_view cell; out.count < CELLS_MOST && cell_next(&line, *delimiter ? *delimiter : ' ', &cell);) {
        if (string_view_length(cell) > 1 && *cell.start == '"' && cell.end[-1] == '"')
            cell = string_view_trim((struct string_view){cell.start + 1, cell.end - 1});
        out.cell[out.count++] = cell;
    }
    while (out.count > 0 && out.cell[out.count - 1].start == out.cell[out.count - 1].end)
        out.count--;
    return out;
}

static bool is_no_value(struct string_view cell)
{
    return cell.start == cell.end || string_view_is_one_of(cell, "nan inf +inf -inf - --");
}

static void without_first(struct cells *cells)
{
    memmove(cells->cell, cells->cell + 1, (CELLS_MOST - 1) * sizeof *cells->cell);
    cells->cell[CELLS_MOST - 1] = (struct string_view){0};
    cells->count -= cells->count > 0;
}

/* Titles, or the units below them: no cell is a number, but perhaps the unit 1. */
static bool is_heading(const struct cells *cells)
{
    bool numbers = false;
    for (size_t i = 0; i < cells->count; i++)
        numbers = numbers || (starts_number(cells->cell[i]) && !string_view_equals(cells->cell[i], "1"));
    return cells->count >= 2 && !numbers;
}

static bool is_unit(struct measured_unit *out, struct string_view text, unsigned quantities)
{
    size_t length = string_view_length(text);
    out->known = length > 0 && unit_read(&out->unit, text.start, length) && unit_of(&out->unit, quantities) &&
                 unit_shown(out->text, text.start, length);
    return out->known;
}

/* The unit in a title: in brackets, behind a slash, or at its end. False: none; then *unknown is what stands in
 * brackets or behind a slash, where only a unit belongs. */
static bool title_unit(struct measured_unit *out, struct string_view *unknown, struct string_view title,
                       unsigned quantities)
{
    *unknown = (struct string_view){0};
    for (size_t i = 0; i < sizeof dimensionless_names / sizeof *dimensionless_names; i++) {
        size_t length = strlen(dimensionless_names[i]);
        if (string_view_length(title) >= length && memcmp(title.end - length, dimensionless_names[i], length) == 0)
            return is_unit(out, string_view_of("dimensionless"), quantities & UNIT_LOADS);
    }
    for (const char *open = title.start; open < title.end; open++) {
        bool bracket = *open == '(' || *open == '[';
        const char *end = bracket ? memrchr(open, *open == '(' ? ')' : ']', (size_t)(title.end - open)) : title.end;
        struct string_view inside = string_view_trim((struct string_view){open + 1, end ? end : title.end});
        bool opened = inside.start < inside.end && (*inside.start == '(' || *inside.start == '[');
        if (strchr("([/ \t_,:=", *open) && !opened && is_unit(out, inside, quantities))
            return true;
        if ((bracket || *open == '/') && end && inside.start < inside.end)
            *unknown = inside;
    }
    return is_unit(out, title, quantities & ~(unsigned)UNIT_LOADS); /* K/W */
}

static enum status_code refuse_unit(struct reading *in, size_t column, struct string_view text)
{
    unsigned asked = in->quantities[column];
    in->line = in->heading_line;
    return status_fail(in->status, STATUS_SCENE, "'%s' is no unit of %s; understood: %s; columns are %s",
                       scene_words_show_view(text).text,
                       in->field                  ? column_names[1][column]
                       : column == MEASURED_LOAD  ? "load"
                       : column == MEASURED_ERROR ? "the error"
                       : asked & UNIT_RESISTANCE  ? "electrical resistance"
                                                  : "thermal resistance",
                       unit_known(asked).text,
                       in->field ? row_names[1] : "load, the scene's 'quantity', perhaps its error");
}

/* Reads the units of the heading in in->order. Do all of its cells name one? `alone`: the cells are only units. */
static bool heading_units(struct reading *in, bool alone, struct string_view unknown[MEASURED_COLUMNS])
{
    size_t known = 0;
    for (size_t c = 0; c < MEASURED_COLUMNS; c++) {
        struct measured_unit *unit = &in->out->units[c];
        struct string_view cell = in->heading.cell[in->order[c]];
        *unit = (struct measured_unit){.line = in->heading_line};
        unknown[c] = (struct string_view){0};
        if (cell.start < cell.end)
            known +=
                alone ? is_unit(unit, cell, in->quantities[c]) : title_unit(unit, &unknown[c], cell, in->quantities[c]);
    }
    return known > 0 && known == in->heading.count;
}

/* Finds the order of columns in which all titles name a fitting unit, else takes the first order. */
static enum status_code heading_read(struct reading *in)
{
    struct string_view unknown[MEASURED_COLUMNS];
    for (int alone = 1; alone >= 0; alone--)
        for (size_t i = 0; i < sizeof orders / sizeof *orders; i++) {
            in->order = orders[i];
            if (heading_units(in, alone, unknown))
                return STATUS_OK;
        }
    in->order = orders[0];
    (void)heading_units(in, false, unknown);
    for (size_t c = 0; c < MEASURED_COLUMNS; c++)
        if (!in->out->units[c].known && unknown[c].start)
            return refuse_unit(in, c, unknown[c]);
    return STATUS_OK;
}

static enum status_code row_read(const struct reading *in, struct measured_row *row, const struct cells *cells)
{
    static const double least = 1e-100, most = 1e100; /* any that keeps its distance from the ends of double */
    if (in->heading.count > 0 && cells->count > in->heading.count)
        return status_fail(in->status, STATUS_SCENE,
                           "more cells than titles in line %zu; write decimals with a point, and give an error a title",
                           in->heading_line);
    if (cells->count < 2 || cells->count > MEASURED_COLUMNS)
        return status_fail(in->status, STATUS_SCENE, "a row is %s", row_names[in->field]);
    for (size_t c = 0; c < MEASURED_COLUMNS; c++) {
        struct string_view cell = cells->cell[in->order[c]];
        if (c == MEASURED_ERROR && cells->count == 2 && in->order[c] == 2)
            continue;
        const char *end = number_scan(cell, NUMBER_EITHER, NULL, &row->value[c]);
        if (!end || end != cell.end)
            return status_fail(in->status, STATUS_SCENE,
                               "'%s' is no number; write it as 1.5e-3, its unit in the heading",
                               scene_words_show_view(cell).text);
        bool any = c == MEASURED_ERROR || in->field;
        double lowest = any ? 0 : least, size = any ? fabs(row->value[c]) : row->value[c];
        if (!(size >= lowest && size <= most))
            return status_fail(in->status, STATUS_SCENE, "%s %s of %g; allowed is %g to %g",
                               c == MEASURED_ERROR && !in->field ? "an" : "a", column_names[in->field][c],
                               row->value[c], lowest, most);
    }
    return STATUS_OK;
}

static enum status_code row_add(struct reading *in, const struct cells *cells)
{
    struct measured_file *out = in->out;
    if (out->count == 0 && heading_read(in) != STATUS_OK)
        return in->status->code;
    if ((out->count & (out->count - 1)) == 0) { /* full at 0, 1, 2, 4, 8 */
        struct measured_row *more = reallocarray(out->rows, 2 * out->count + 1, sizeof *more);
        if (!more)
            return status_memory(in->status);
        out->rows = more;
    }
    out->rows[out->count] = (struct measured_row){{0, 0, NAN}, in->line};
    enum status_code rc = row_read(in, &out->rows[out->count], cells);
    out->count += rc == STATUS_OK;
    return rc;
}

static enum status_code line_read(struct reading *in, struct string_view line)
{
    if (in->line > limit_most(LIMIT_MEASURED_LINES))
        return status_fail(in->status, STATUS_SCENE, "too many lines%s", limit_words(LIMIT_MEASURED_LINES).text);
    if (string_view_length(line) > limit_most(LIMIT_MEASURED_LINE_BYTES))
        return status_fail(in->status, STATUS_SCENE, "a line of %zu bytes%s", string_view_length(line),
                           limit_words(LIMIT_MEASURED_LINE_BYTES).text);
    const char *remark = memchr(line.start, '#', string_view_length(line));
    line = string_view_trim((struct string_view){line.start, remark ? remark : line.end});
    struct cells cells = split(line);
    if (line.start == line.end)
        return STATUS_OK;
    double value;
    if (in->out->count == 0 && !in->labels && cells.count > 2 && cells.count == in->heading.count &&
        !is_heading(&cells)) {
        in->labels = !starts_number(cells.cell[0]) && !is_no_value(cells.cell[0]) && starts_number(cells.cell[1]) &&
                     starts_number(cells.cell[2]);
        if (in->labels)
            without_first(&in->heading);
    }
    if (in->labels)
        without_first(&cells);
    const struct string_view first = cells.cell[0];
    if (number_scan(first, NUMBER_EITHER, NULL, &value))
        return row_add(in, &cells);
    if (in->out->count > 0 || (is_no_value(first) && starts_number(cells.cell[1])))
        return status_fail(in->status, STATUS_SCENE,
                           "'%s' is no %s; correct the row or remove it, or put # before a remark",
                           scene_words_show_view(first).text, column_names[in->field][in->order[MEASURED_LOAD] > 0]);
    if (is_heading(&cells)) {
        in->heading = cells;
        in->heading_line = in->line;
    }
    return STATUS_OK;
}

enum status_code measured_file_read(struct measured_file *out, struct string_view content, const char *name,
                                    const unsigned quantities[MEASURED_COLUMNS], struct status *status)
{
    *out = (struct measured_file){0};
    struct reading in = {.out = out,
                         .quantities = quantities,
                         .field = quantities[MEASURED_LOAD] & UNIT_DISTANCE,
                         .order = orders[0],
                         .status = status};
    if (string_view_starts(content, "\xEF\xBB\xBF"))
        content.start += 3;
    struct lines lines = lines_begin(content);
    enum status_code rc = STATUS_OK;
    for (struct string_view line; rc == STATUS_OK && lines_next(&lines, &line);) {
        in.line = lines.number;
        rc = line_read(&in, line);
    }
    if (rc == STATUS_SCENE)
        return status_prefix(status, "%s:%zu", name, in.line);
    return rc == STATUS_OK && out->count == 0
               ? status_fail(status, STATUS_SCENE, "%s: no row of %s", name, row_names[in.field])
               : rc;
}

enum status_code measured_file_take(struct measured_file *out, const char *path, const char *name,
                                    const unsigned quantities[MEASURED_COLUMNS], struct status *status)
{
    OWNED(text_free) struct text content = {0};
    enum status_code rc = text_read_file(&content, path, status);
    const char *start = text_string(&content);
    if (rc == STATUS_OK && memchr(start, '\0', content.length))
        rc = status_fail(status, STATUS_SCENE, "%s: a NUL byte in the file; save it as plain text (UTF-8)", name);
    return rc == STATUS_OK
               ? measured_file_read(out, (struct string_view){start, start + content.length}, name, quantities, status)
               : rc;
}

void measured_file_free(struct measured_file *file)
{
    free(file->rows);
    *file = (struct measured_file){0};
}
