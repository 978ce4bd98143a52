/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/measured_file.h"
#include "base/limits.h"

#include "scan/string_view.h"
#include "scene/scene_words.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const column_names[MEASURED_COLUMNS] = {"load", "resistance", "error"};
/* Headings that say P/(A_n E'): the column of contact.csv, and how it is written. */
static const char *const dimensionless_names[] = {"load_over_AnEp", "P/(A_n E')", "P/(An E')", "P/(AnE')", "P/(Aₙ E′)"};

enum { CELLS_MOST = 8 };

/* In which cells load, resistance and error may stand; the first where the units do not say another. */
static const size_t orders[][MEASURED_COLUMNS] = {{0, 1, 2}, {1, 0, 2}, {2, 0, 1}, {0, 2, 1}};

/* What a file is read with. */
struct reading {
    struct measured_file *out;
    const unsigned *quantities; /* of each column */
    const size_t *order;        /* one of `orders` */
    size_t line;                /* what is read now, which messages name */
    struct status *status;
};

/* A line of cells; those beyond the last are empty. */
struct cells {
    struct string_view cell[CELLS_MOST];
    size_t count;
};

static struct string_view rest_from(struct string_view span, const char *start)
{
    return string_view_trim((struct string_view){start, span.end});
}

/* Cuts the next cell off `rest`, without the quotes around it. */
static bool cut(struct string_view *rest, char delimiter, struct string_view *cell)
{
    while (rest->start < rest->end && *rest->start == ' ')
        rest->start++;
    bool quoted = rest->start < rest->end && *rest->start == '"';
    const char *close = quoted ? memchr(rest->start + 1, '"', string_view_length(*rest) - 1) : NULL;
    if (!close)
        return cell_next(rest, delimiter, cell);
    *cell = string_view_trim((struct string_view){rest->start + 1, close});
    rest->start = close + 1;
    struct string_view ignored;
    if (delimiter != ' ')
        (void)cell_next(rest, delimiter, &ignored);
    return true;
}

/* Does it begin with a number, alone or before a blank? `4-wire R` does not. */
static bool starts_number(struct string_view cell)
{
    double value;
    const char *end = number_scan(cell, NUMBER_POINT, NULL, &value);
    return end && (end == cell.end || string_view_is_blank_char(*end));
}

/* The first of semicolon, tab and comma that stands outside quotes, else a blank. */
static char delimiter_of(struct string_view line)
{
    static const char delimiters[] = ";\t,";
    for (const char *d = delimiters; *d; d++) {
        bool quoted = false;
        for (const char *p = line.start; p < line.end; p++) {
            quoted ^= *p == '"';
            if (*p == *d && !quoted)
                return *d;
        }
    }
    return ' ';
}

/* Between blanks, a word that is no number belongs to the number before it in a row (`10 N 4.8 mOhm`). */
static struct cells split(struct string_view line, char delimiter, bool row)
{
    struct cells out = {0};
    for (struct string_view cell; cut(&line, delimiter, &cell);) {
        if (row && delimiter == ' ' && out.count > 0 && !starts_number(cell)) {
            out.cell[out.count - 1].end = cell.end;
            continue;
        }
        if (out.count == CELLS_MOST)
            break;
        out.cell[out.count++] = cell;
    }
    while (out.count > 0 && out.cell[out.count - 1].start == out.cell[out.count - 1].end)
        out.count--;
    return out;
}

/* A cell's unit, when it is one of `quantities`. */
static bool is_unit(struct unit *unit, struct string_view text, unsigned quantities)
{
    return unit_read(unit, text.start, string_view_length(text)) && unit_of(unit, quantities);
}

/* What a cell says of its column's unit. */
struct cell_unit {
    enum { FOUND_NOTHING, FOUND_UNIT, FOUND_UNKNOWN } found;
    struct unit unit;
    struct string_view text; /* as written */
};

static enum status_code refuse_unit(const struct reading *in, size_t column, struct string_view text)
{
    static const unsigned resistances =
        UNIT_RESISTANCE | UNIT_RESISTANCE_AREA | UNIT_THERMAL_RESISTANCE | UNIT_THERMAL_RESISTANCE_AREA;
    struct unit unit;
    unsigned asked = in->quantities[column];
    bool other = column != MEASURED_LOAD && is_unit(&unit, text, resistances & ~asked);
    return status_fail(in->status, STATUS_SCENE,
                       "'%s' is no unit of %s%s; understood: %s; columns are load, resistance and perhaps its error",
                       scene_words_show_view(text).text,
                       column == MEASURED_LOAD    ? "load"
                       : column == MEASURED_ERROR ? "the error"
                       : asked & UNIT_RESISTANCE  ? "electrical resistance"
                                                  : "thermal resistance",
                       other ? ", the 'quantity' of 'measured' in the scene" : "", unit_known(asked).text);
}

/* Notes a column's unit, or that it is the one known already. */
static enum status_code settle(const struct reading *in, size_t column, const struct cell_unit *cell)
{
    struct measured_unit *known = &in->out->units[column];
    size_t length = string_view_length(cell->text);
    if (known->known && !unit_equal(&known->unit, &cell->unit))
        return status_fail(in->status, STATUS_SCENE, "'%s' as unit of %s, but line %zu says '%s'; correct one of them",
                           scene_words_show_view(cell->text).text, column_names[column], known->line, known->text);
    if (known->known)
        return STATUS_OK;
    *known = (struct measured_unit){.known = true, .unit = cell->unit, .line = in->line};
    (void)unit_shown(known->text, cell->text.start, length); /* as it was read, it fits */
    return STATUS_OK;
}

/* The end of the bracket that opens at `open`, NULL where it is not closed. */
static const char *closing(const char *open, const char *end)
{
    const char close = *open == '(' ? ')' : ']';
    int depth = 0;
    for (const char *p = open; p < end; p++) {
        depth += *p == *open;
        depth -= *p == close;
        if (depth == 0)
            return p;
    }
    return NULL;
}

static bool is_dimensionless_name(struct string_view cell)
{
    for (size_t i = 0; i < sizeof dimensionless_names / sizeof *dimensionless_names; i++) {
        size_t length = strlen(dimensionless_names[i]);
        if (string_view_length(cell) >= length && memcmp(cell.end - length, dimensionless_names[i], length) == 0)
            return true;
    }
    return false;
}

/* Is the text a unit? If none is found yet, one that has to be a unit is noted as unknown. */
static bool offer(struct cell_unit *out, struct string_view text, unsigned quantities, bool has_to_be)
{
    bool is = is_unit(&out->unit, text, quantities);
    if (is || (has_to_be && out->found == FOUND_NOTHING)) {
        out->text = text;
        out->found = is ? FOUND_UNIT : FOUND_UNKNOWN;
    }
    return is;
}

/* The unit that a heading names beside its name. Brackets and a slash can hold nothing but a unit, so that what is none
 * there is FOUND_UNKNOWN; so is a known unit of something else at the end, of two letters or more (R_s, F_A are names).
 */
static struct cell_unit heading_unit(struct string_view cell, unsigned quantities)
{
    static const char one[] = "dimensionless";
    struct cell_unit out = {.found = FOUND_NOTHING};
    if ((quantities & UNIT_NUMBER) && (quantities & UNIT_FORCE) && is_dimensionless_name(cell)) {
        (void)offer(&out, (struct string_view){one, one + strlen(one)}, quantities, false);
        return out;
    }
    for (const char *p = cell.start; p < cell.end; p++) {
        const char *close = *p == '(' || *p == '[' ? closing(p, cell.end) : NULL;
        if (!close)
            continue;
        struct string_view inside = string_view_trim((struct string_view){p + 1, close});
        p = close;
        if (inside.start == inside.end)
            continue;
        out.found = FOUND_NOTHING; /* of several the last */
        if (offer(&out, inside, quantities, true))
            return out;
    }
    const char *slash = memchr(cell.start, '/', string_view_length(cell));
    if (slash &&
        (offer(&out, rest_from(cell, slash + 1), quantities, true) || offer(&out, cell, quantities, false))) /* K/W */
        return out;
    for (const char *p = cell.start; p < cell.end; p++) {
        struct string_view behind = rest_from(cell, p + 1);
        size_t length = string_view_length(behind);
        struct unit any;
        if (strchr(" \t_,:=", *p) &&
            offer(&out, behind, quantities,
                  length > 1 && unit_read(&any, behind.start, length) &&
                      !string_view_is_one_of(behind, "in min mil"))) /* words that are units, too */
            return out;
    }
    return out;
}

/* A line above the rows that may be a heading, and the units of the columns as it says them. */
struct heading {
    struct string_view text;
    size_t line;
    struct cell_unit unit[MEASURED_COLUMNS];
};

/* Those that are looked at: the last two lines, and the last comment. */
enum { HEADING_NAMES, HEADING_LAST, HEADING_COMMENT, HEADINGS };

/* Is it a line of cells without a number among them? */
static bool is_heading(struct string_view line)
{
    char delimiter = delimiter_of(line);
    struct cells cells = split(line, delimiter, false);
    for (size_t i = 0; i < cells.count; i++)
        if (starts_number(cells.cell[i]) && !string_view_equals(cells.cell[i], "1"))
            return false;
    return cells.count >= 2 && (delimiter != ' ' || cells.count <= MEASURED_COLUMNS);
}

/* `below_names`: the line may be one of units, of which not all need be known. */
static void heading_read(struct heading *out, const struct reading *in, bool below_names)
{
    struct cells cells = {0};
    if (out->text.start)
        cells = split(out->text, delimiter_of(out->text), false);
    size_t units = 0, filled = 0;
    struct cell_unit whole[MEASURED_COLUMNS] = {0}; /* a cell that is nothing but a unit */
    for (size_t c = 0; c < MEASURED_COLUMNS; c++) {
        struct string_view cell = cells.cell[in->order[c]];
        out->unit[c] = (struct cell_unit){.found = FOUND_NOTHING};
        if (cell.start == cell.end)
            continue;
        out->unit[c] = heading_unit(cell, in->quantities[c]);
        units += offer(&whole[c], cell, in->quantities[c], true) || out->unit[c].found == FOUND_UNIT;
        filled++;
    }
    bool any = whole[MEASURED_LOAD].found == FOUND_UNIT || whole[MEASURED_RESISTANCE].found == FOUND_UNIT;
    for (size_t c = 0; c < MEASURED_COLUMNS && any && (units == filled || below_names); c++)
        if (out->unit[c].found != FOUND_UNIT && whole[c].found != FOUND_NOTHING)
            out->unit[c] = whole[c];
}

/* Settles the units of a heading. */
static enum status_code heading_use(struct reading *in, const struct heading *heading)
{
    in->line = heading->line;
    for (size_t c = 0; c < MEASURED_COLUMNS; c++)
        if (heading->unit[c].found == FOUND_UNIT && settle(in, c, &heading->unit[c]) != STATUS_OK)
            return in->status->code;
    return STATUS_OK;
}

/* Has a row more cells than the heading above it, and no point? Then `10,4,8` may be 10 and 4,8. */
static bool may_be_decimal_commas(struct string_view heading, struct string_view row)
{
    if (!heading.start || delimiter_of(row) != ',' || delimiter_of(heading) != ',' ||
        memchr(row.start, '.', string_view_length(row)))
        return false;
    struct cells cells = split(row, ',', true);
    size_t digits = 0, second = cells.count > 1 ? string_view_length(cells.cell[1]) : 0;
    while (digits < second && cells.cell[1].start[digits] >= '0' && cells.cell[1].start[digits] <= '9')
        digits++;
    return cells.count > split(heading, ',', false).count && digits == second;
}

/* Notes a line above the rows where it may be a heading. */
static void headings_note(struct heading headings[HEADINGS], struct string_view text, size_t line)
{
    bool comment = *text.start == '#';
    while (text.start < text.end && *text.start == '#')
        text.start++;
    text = string_view_trim(text);
    if (text.start == text.end || !is_heading(text))
        return;
    if (!comment)
        headings[HEADING_NAMES] = headings[HEADING_LAST];
    headings[comment ? HEADING_COMMENT : HEADING_LAST] = (struct heading){text, line, {{0}}};
}

/* Reads the headings in in->order; do they name the unit of every column? */
static bool headings_read(struct heading headings[HEADINGS], const struct reading *in)
{
    size_t known = 0;
    struct string_view titles = headings[headings[HEADING_LAST].text.start ? HEADING_LAST : HEADING_COMMENT].text;
    for (size_t i = 0; i < HEADINGS; i++)
        heading_read(&headings[i], in, i == HEADING_LAST && headings[HEADING_NAMES].text.start);
    for (size_t c = 0; c < MEASURED_COLUMNS; c++) {
        bool is_known = false;
        for (size_t i = 0; i < HEADINGS; i++)
            is_known = is_known || headings[i].unit[c].found == FOUND_UNIT;
        known += is_known;
    }
    return titles.start && known == split(titles, delimiter_of(titles), false).count;
}

/* The same in the first order that they do so in; as before where there is none. */
static void headings_order(struct heading headings[HEADINGS], struct reading *in)
{
    const size_t *before = in->order;
    for (size_t i = 0; i < sizeof orders / sizeof *orders; i++) {
        in->order = orders[i];
        if (headings_read(headings, in))
            return;
    }
    in->order = before;
    (void)headings_read(headings, in);
}

/* The units of the headings. What is no unit in one line may be told by the other. */
static enum status_code headings_use(struct heading headings[HEADINGS], struct reading *in)
{
    headings_order(headings, in);
    if (heading_use(in, &headings[HEADING_NAMES]) != STATUS_OK || heading_use(in, &headings[HEADING_LAST]) != STATUS_OK)
        return in->status->code;
    for (size_t i = 0; i < HEADING_COMMENT; i++)
        for (size_t c = 0; c < MEASURED_COLUMNS; c++)
            if (headings[i].unit[c].found == FOUND_UNKNOWN && !in->out->units[c].known) {
                in->line = headings[i].line;
                return refuse_unit(in, c, headings[i].unit[c].text);
            }
    const struct heading *comment = &headings[HEADING_COMMENT];
    bool complete =
        comment->unit[MEASURED_LOAD].found == FOUND_UNIT && comment->unit[MEASURED_RESISTANCE].found == FOUND_UNIT;
    return complete ? heading_use(in, comment) : STATUS_OK;
}

static enum status_code row_read(const struct reading *in, struct measured_row *row, struct string_view line)
{
    if (memchr(line.start, ';', string_view_length(line)) && memchr(line.start, ',', string_view_length(line)))
        return status_fail(in->status, STATUS_SCENE, "both ',' and ';' in a row; write decimals with a point");
    struct cells cells = split(line, delimiter_of(line), true);
    bool gap = false;
    for (size_t c = 0; c < cells.count && c < MEASURED_COLUMNS; c++)
        gap = gap || cells.cell[in->order[c]].start == cells.cell[in->order[c]].end;
    if (cells.count < 2 || cells.count > MEASURED_COLUMNS || gap)
        return status_fail(in->status, STATUS_SCENE, "a row is load, resistance and perhaps its error");
    for (size_t c = 0; c < cells.count; c++) {
        struct string_view cell = cells.cell[in->order[c]];
        const char *end = number_scan(cell, NUMBER_POINT, NULL, &row->value[c]);
        if (!end || (end < cell.end && *end == ',') || !isfinite(row->value[c]))
            return status_fail(in->status, STATUS_SCENE, "'%s' is no number; write it as 1.5e-3",
                               scene_words_show_view(cell).text);
        struct cell_unit unit = {.text = rest_from(cell, end)};
        if (unit.text.start == unit.text.end)
            continue;
        if (!is_unit(&unit.unit, unit.text, in->quantities[c]))
            return refuse_unit(in, c, unit.text);
        if (settle(in, c, &unit) != STATUS_OK)
            return in->status->code;
    }
    if (!(row->value[MEASURED_LOAD] > 0 && row->value[MEASURED_RESISTANCE] > 0))
        return status_fail(in->status, STATUS_SCENE, "load and resistance must be positive");
    static const double least = 1e-100, most = 1e100; /* any that keeps its distance from the ends of double */
    for (size_t c = 0; c < cells.count; c++) {
        double size = fabs(row->value[c]), lowest = c == MEASURED_ERROR ? 0 : least;
        if (!(size >= lowest && size <= most))
            return status_fail(in->status, STATUS_SCENE, "%s %s of %g; allowed is %g to %g",
                               c == MEASURED_ERROR ? "an" : "a", column_names[c], row->value[c], lowest, most);
    }
    return STATUS_OK;
}

/* Is it what programs write where they measured nothing? */
static bool is_no_value(struct string_view cell)
{
    static const char *const words[] = {"nan", "inf", "+inf", "-inf", "-", "--"};
    bool is = cell.start == cell.end;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        is = is || string_view_equals(cell, words[i]);
    return is;
}

/* A row whose load is no number, and no remark such as `unloading 2`? Above the rows `Samples, 3` is one, too. */
static bool is_broken_row(struct string_view line, bool above)
{
    char delimiter = delimiter_of(line);
    struct cells cells = split(line, delimiter, false);
    if (*line.start == '#' || cells.count < 2 || !starts_number(cells.cell[1]))
        return false;
    bool digit = false;
    for (const char *p = cells.cell[0].start; p < cells.cell[0].end; p++)
        digit = digit || (*p >= '0' && *p <= '9');
    return is_no_value(cells.cell[0]) || (!above && (digit || delimiter != ' '));
}

static enum status_code refuse_broken(const struct reading *in, struct string_view line)
{
    struct string_view first = split(line, delimiter_of(line), false).cell[0];
    return status_fail(in->status, STATUS_SCENE,
                       "'%s' is no %s; correct the row or remove it, or put # before a remark",
                       scene_words_show_view(first).text, column_names[in->order[MEASURED_LOAD] > 0]);
}

/* Does the line begin as a row does, perhaps quoted? */
static bool is_row(struct string_view line)
{
    const char *p = line.start + (*line.start == '"');
    while (p < line.end && strchr("+-. ", *p))
        p++;
    return p < line.end && *p >= '0' && *p <= '9';
}

static enum status_code row_add(const struct reading *in, size_t *capacity, struct string_view line)
{
    struct measured_file *out = in->out;
    if (out->count == *capacity) {
        *capacity = *capacity ? 2 * *capacity : 64;
        struct measured_row *more = reallocarray(out->rows, *capacity, sizeof *more);
        if (!more)
            return status_memory(in->status);
        out->rows = more;
    }
    out->rows[out->count] = (struct measured_row){{0, 0, NAN}, in->line};
    enum status_code rc = row_read(in, &out->rows[out->count], line);
    out->count += rc == STATUS_OK;
    return rc;
}

enum status_code measured_file_read(struct measured_file *out, struct string_view content, const char *name,
                                    const unsigned quantities[MEASURED_COLUMNS], struct status *status)
{
    *out = (struct measured_file){0};
    struct reading in = {out, quantities, orders[0], 0, status};
    struct heading headings[HEADINGS] = {0};
    size_t capacity = 0;
    if (string_view_starts(content, "\xEF\xBB\xBF"))
        content.start += 3;
    struct lines lines = lines_begin(content);
    enum status_code rc = STATUS_OK;
    for (struct string_view line; rc == STATUS_OK && lines_next(&lines, &line);) {
        in.line = lines.number;
        if (lines.number > limit_most(LIMIT_MEASURED_LINES))
            rc = status_fail(status, STATUS_SCENE, "too many lines%s", limit_words(LIMIT_MEASURED_LINES).text);
        else if (string_view_length(line) > limit_most(LIMIT_MEASURED_LINE_BYTES))
            rc = status_fail(status, STATUS_SCENE, "a line of %zu bytes%s", string_view_length(line),
                             limit_words(LIMIT_MEASURED_LINE_BYTES).text);
        line = string_view_trim(line);
        if (rc != STATUS_OK || line.start == line.end)
            continue;
        const char *comment = memchr(line.start, '#', string_view_length(line));
        if (comment && comment > line.start)
            line = string_view_trim((struct string_view){line.start, comment});
        bool row = is_row(line);
        if (row && out->count == 0)
            rc = headings_use(headings, &in);
        if (rc != STATUS_OK)
            break;
        in.line = lines.number;
        if (row && may_be_decimal_commas(headings[HEADING_LAST].text, line)) {
            rc = status_fail(status, STATUS_SCENE,
                             "more cells than titles in line %zu: decimal commas? Write decimals with a point, and "
                             "give an error a title",
                             headings[HEADING_LAST].line);
        } else if (row) {
            rc = row_add(&in, &capacity, line);
        } else if (is_broken_row(line, out->count == 0)) {
            rc = refuse_broken(&in, line);
        } else if (out->count == 0) {
            headings_note(headings, line, lines.number);
        } else if (is_heading(line) && *line.start != '#') { /* of a second block: the same units, or none */
            struct heading block[HEADINGS] = {[HEADING_LAST] = {line, lines.number, {{0}}}};
            headings_order(block, &in);
            rc = heading_use(&in, &block[HEADING_LAST]);
        }
    }
    if (rc == STATUS_SCENE)
        return status_prefix(status, "%s:%zu", name, in.line);
    if (rc == STATUS_OK && out->count == 0)
        rc = status_fail(status, STATUS_SCENE, "%s: no row of load and resistance", name);
    return rc;
}

void measured_file_free(struct measured_file *file)
{
    free(file->rows);
    *file = (struct measured_file){0};
}
