#include "results/measured_file.h"

#include "scan/number.h"
#include "scene/scene_words.h"
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char byte_order_mark[] = "\xEF\xBB\xBF";
static const char *const column_names[MEASURED_COLUMNS] = {"load", "resistance", "error"};
/* Headings that say P/(A_n E'): the column of contact.csv, and how it is written. */
static const char *const dimensionless_names[] = {"load_over_AnEp", "P/(A_n E')", "P/(An E')", "P/(AnE')", "P/(Aₙ E′)"};

enum { CELLS_MOST = 8 };

/* What a file is read with. */
struct reading {
    struct measured_file *out;
    const char *name;
    const unsigned *quantities; /* of each column */
    struct status *status;
};

/* A line of cells. */
struct cells {
    struct span cell[CELLS_MOST];
    size_t count;
};

static struct span rest_from(struct span span, const char *start)
{
    return span_trim((struct span){start, span.end});
}

/* Cuts the next cell off `rest`, without the quotes around it. */
static bool cut(struct span *rest, char delimiter, struct span *cell)
{
    while (rest->start < rest->end && *rest->start == ' ')
        rest->start++;
    if (rest->start < rest->end && *rest->start == '"') {
        const char *close = memchr(rest->start + 1, '"', span_length(*rest) - 1);
        if (close) {
            struct span ignored;
            *cell = span_trim((struct span){rest->start + 1, close});
            rest->start = close + 1;
            if (delimiter != ' ')
                (void)cell_next(rest, delimiter, &ignored);
            return true;
        }
    }
    return cell_next(rest, delimiter, cell);
}

/* Does it begin with a number, alone or before a blank? `4-wire R` does not. */
static bool starts_number(struct span cell)
{
    double value;
    const char *end = number_scan(cell, NUMBER_POINT, NULL, &value);
    return end && (end == cell.end || span_is_blank_char(*end));
}

/* The first of semicolon, tab and comma that stands outside quotes, else a blank. */
static char delimiter_of(struct span line)
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
static struct cells split(struct span line, char delimiter, bool row)
{
    struct cells out = {.count = 0};
    for (struct span cell; cut(&line, delimiter, &cell);) {
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
static bool is_unit(struct unit *unit, struct span text, unsigned quantities)
{
    return unit_read(unit, text.start, span_length(text)) && unit_of(unit, quantities);
}

static enum status_code refuse_unit(const struct reading *in, size_t column, struct span text, size_t line)
{
    static const unsigned thermal = UNIT_THERMAL_RESISTANCE | UNIT_THERMAL_RESISTANCE_AREA;
    static const unsigned electrical = UNIT_RESISTANCE | UNIT_RESISTANCE_AREA;
    struct text known = {0};
    struct unit unit;
    unsigned asked = in->quantities[column];
    bool other = column != MEASURED_LOAD && is_unit(&unit, text, (thermal | electrical) & ~asked);
    unit_add_known(&known, asked);
    enum status_code rc =
        known.failed ? status_memory(in->status)
                     : status_fail(in->status, STATUS_SCENE, "%s:%zu: '%s' is no unit of %s%s; understood: %s%s",
                                   in->name, line, scene_words_show(text.start, span_length(text)).text,
                                   column == MEASURED_LOAD    ? "load"
                                   : column == MEASURED_ERROR ? "the error"
                                   : asked & UNIT_RESISTANCE  ? "electrical resistance"
                                                              : "thermal resistance",
                                   other ? ", the 'quantity' of 'measured' in the scene" : "", text_string(&known),
                                   "; columns are load, resistance and perhaps its error");
    text_free(&known);
    return rc;
}

/* Notes a column's unit, or that it is the one known already. */
static enum status_code settle(const struct reading *in, size_t column, const struct unit *unit, struct span text,
                               size_t line)
{
    struct measured_unit *known = &in->out->units[column];
    if (known->known && !unit_equal(&known->unit, unit))
        return status_fail(in->status, STATUS_SCENE,
                           "%s:%zu: '%s' as unit of %s, but line %zu says '%s'; correct one of them", in->name, line,
                           scene_words_show(text.start, span_length(text)).text, column_names[column], known->line,
                           known->text);
    if (!known->known) {
        size_t length = span_length(text);
        assert(length < UNIT_LENGTH); /* or it would not have been read */
        *known = (struct measured_unit){.known = true, .unit = *unit, .line = line};
        memcpy(known->text, text.start, length);
        size_t shown = 0;
        for (size_t bytes; (bytes = text_character(known->text + shown)) > 0;)
            shown += bytes;
        if (shown < length) /* latin-1: in ASCII */
            (void)unit_spell(known->text, text.start, length);
    }
    return STATUS_OK;
}

enum found { FOUND_NOTHING, FOUND_UNIT, FOUND_UNKNOWN };

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

static bool is_dimensionless_name(struct span cell)
{
    for (size_t i = 0; i < sizeof dimensionless_names / sizeof *dimensionless_names; i++) {
        size_t length = strlen(dimensionless_names[i]);
        if (span_length(cell) >= length && memcmp(cell.end - length, dimensionless_names[i], length) == 0)
            return true;
    }
    return false;
}

/* The unit that a heading names beside its name; *text is how it is written. Brackets and a slash can hold nothing but
 * a unit, so that what is none there is FOUND_UNKNOWN; so is a known unit of something else at the end, of two letters
 * or more (R_s, F_A are names). */
static enum found heading_unit(struct unit *unit, struct span *text, struct span cell, unsigned quantities)
{
    enum found found = FOUND_NOTHING;
    if ((quantities & UNIT_NUMBER) && (quantities & UNIT_FORCE) && is_dimensionless_name(cell)) {
        static const char one[] = "dimensionless";
        *text = (struct span){one, one + strlen(one)};
        return is_unit(unit, *text, quantities) ? FOUND_UNIT : FOUND_NOTHING;
    }
    for (const char *p = cell.start; p < cell.end; p++) {
        const char *close = *p == '(' || *p == '[' ? closing(p, cell.end) : NULL;
        if (!close)
            continue;
        struct span inside = span_trim((struct span){p + 1, close});
        if (inside.start < inside.end) {
            *text = inside;
            found = FOUND_UNKNOWN;
            if (is_unit(unit, *text, quantities))
                return FOUND_UNIT;
        }
        p = close;
    }
    const char *slash = memchr(cell.start, '/', span_length(cell));
    if (slash) {
        struct span behind = rest_from(cell, slash + 1);
        bool is = is_unit(unit, behind, quantities);
        if (is || found == FOUND_NOTHING)
            *text = behind;
        if (is)
            return FOUND_UNIT;
        found = FOUND_UNKNOWN;
        if (is_unit(unit, cell, quantities)) { /* K/W */
            *text = cell;
            return FOUND_UNIT;
        }
    }
    for (const char *p = cell.start; p < cell.end; p++) {
        if (!strchr(" \t_,:=", *p))
            continue;
        struct span behind = rest_from(cell, p + 1);
        if (is_unit(unit, behind, quantities)) {
            *text = behind;
            return FOUND_UNIT;
        }
        if (found == FOUND_NOTHING && span_length(behind) > 1 && unit_read(unit, behind.start, span_length(behind))) {
            *text = behind;
            found = FOUND_UNKNOWN;
        }
    }
    return found;
}

/* Units of the columns as one line says them. */
struct heading {
    enum found found[MEASURED_COLUMNS];
    struct unit unit[MEASURED_COLUMNS];
    struct span text[MEASURED_COLUMNS];
};

/* Is it a line of cells without a number among them? */
static bool is_heading(struct span line)
{
    char delimiter = delimiter_of(line);
    struct cells cells = split(line, delimiter, false);
    for (size_t i = 0; i < cells.count; i++)
        if (starts_number(cells.cell[i]) && !span_equals(cells.cell[i], "1"))
            return false;
    return cells.count >= 2 && (delimiter != ' ' || cells.count <= MEASURED_COLUMNS);
}

/* `below_names`: the line may be one of units, of which not all need be known. */
static struct heading heading_read(struct span line, const unsigned *quantities, bool below_names)
{
    struct heading out = {.found = {FOUND_NOTHING}};
    struct cells cells = split(line, delimiter_of(line), false);
    size_t count = cells.count < MEASURED_COLUMNS ? cells.count : MEASURED_COLUMNS, units = 0, filled = 0;
    struct unit whole[MEASURED_COLUMNS];
    bool is_whole[MEASURED_COLUMNS] = {false};
    for (size_t c = 0; c < count; c++) {
        out.found[c] = heading_unit(&out.unit[c], &out.text[c], cells.cell[c], quantities[c]);
        is_whole[c] = is_unit(&whole[c], cells.cell[c], quantities[c]);
        units += is_whole[c] || out.found[c] == FOUND_UNIT;
        filled += cells.cell[c].start < cells.cell[c].end;
    }
    bool any = is_whole[MEASURED_LOAD] || is_whole[MEASURED_RESISTANCE];
    for (size_t c = 0; c < count && any && (units == filled || below_names); c++)
        if (out.found[c] != FOUND_UNIT && cells.cell[c].start < cells.cell[c].end) {
            out.found[c] = is_whole[c] ? FOUND_UNIT : FOUND_UNKNOWN;
            out.unit[c] = whole[c];
            out.text[c] = cells.cell[c];
        }
    return out;
}

/* Settles the units of a heading. */
static enum status_code heading_use(const struct reading *in, const struct heading *heading, size_t line)
{
    for (size_t c = 0; c < MEASURED_COLUMNS; c++)
        if (heading->found[c] == FOUND_UNIT && settle(in, c, &heading->unit[c], heading->text[c], line) != STATUS_OK)
            return in->status->code;
    return STATUS_OK;
}

/* Lines above the rows that may be headings. */
struct above {
    struct span line[2], comment; /* the last two, and the last comment */
    size_t number[2], comment_number, count;
};

/* Has a row more cells than the heading above it, and no point? Then `10,4,8` may be 10 and 4,8. */
static bool may_be_decimal_commas(const struct above *above, struct span row)
{
    if (above->count == 0 || delimiter_of(row) != ',' || delimiter_of(above->line[1]) != ',' ||
        memchr(row.start, '.', span_length(row)))
        return false;
    struct cells cells = split(row, ',', true);
    size_t digits = 0, second = cells.count > 1 ? span_length(cells.cell[1]) : 0;
    while (digits < second && cells.cell[1].start[digits] >= '0' && cells.cell[1].start[digits] <= '9')
        digits++;
    return cells.count > split(above->line[1], ',', false).count && digits == second;
}

static void above_note(struct above *above, struct span line, size_t number)
{
    bool comment = *line.start == '#';
    while (line.start < line.end && *line.start == '#')
        line.start++;
    line = span_trim(line);
    if (line.start == line.end || !is_heading(line))
        return;
    if (comment) {
        above->comment = line;
        above->comment_number = number;
        return;
    }
    above->line[0] = above->line[1];
    above->number[0] = above->number[1];
    above->line[1] = line;
    above->number[1] = number;
    above->count++;
}

/* The units of the headings. What is no unit in one line may be told by the other. */
static enum status_code headings_use(const struct reading *in, const struct above *above)
{
    struct heading heading[2];
    size_t first = above->count >= 2 ? 0 : above->count == 1 ? 1 : 2;
    for (size_t i = first; i < 2; i++) {
        heading[i] = heading_read(above->line[i], in->quantities, i > first);
        if (heading_use(in, &heading[i], above->number[i]) != STATUS_OK)
            return in->status->code;
    }
    for (size_t i = first; i < 2; i++)
        for (size_t c = 0; c < MEASURED_COLUMNS; c++)
            if (heading[i].found[c] == FOUND_UNKNOWN && !in->out->units[c].known)
                return refuse_unit(in, c, heading[i].text[c], above->number[i]);
    if (!above->comment.start)
        return STATUS_OK;
    struct heading comment = heading_read(above->comment, in->quantities, false);
    bool all = comment.found[MEASURED_LOAD] == FOUND_UNIT && comment.found[MEASURED_RESISTANCE] == FOUND_UNIT;
    return all ? heading_use(in, &comment, above->comment_number) : STATUS_OK;
}

static enum status_code row_read(const struct reading *in, struct measured_row *row, struct span line)
{
    if (memchr(line.start, ';', span_length(line)) && memchr(line.start, ',', span_length(line)))
        return status_fail(in->status, STATUS_SCENE, "%s:%zu: both ',' and ';' in a row; write decimals with a point",
                           in->name, row->line);
    struct cells cells = split(line, delimiter_of(line), true);
    bool gap = false;
    for (size_t c = 0; c < cells.count; c++)
        gap = gap || cells.cell[c].start == cells.cell[c].end;
    if (cells.count < 2 || cells.count > MEASURED_COLUMNS || gap)
        return status_fail(in->status, STATUS_SCENE, "%s:%zu: a row is load, resistance and perhaps its error",
                           in->name, row->line);
    for (size_t c = 0; c < cells.count; c++) {
        const char *end = number_scan(cells.cell[c], NUMBER_POINT, NULL, &row->value[c]);
        if (!end || (end < cells.cell[c].end && *end == ',') || !isfinite(row->value[c]))
            return status_fail(in->status, STATUS_SCENE, "%s:%zu: '%s' is no number; write it as 1.5e-3", in->name,
                               row->line, scene_words_show(cells.cell[c].start, span_length(cells.cell[c])).text);
        struct span behind = rest_from(cells.cell[c], end);
        struct unit unit;
        if (behind.start == behind.end)
            continue;
        if (!is_unit(&unit, behind, in->quantities[c]))
            return refuse_unit(in, c, behind, row->line);
        if (settle(in, c, &unit, behind, row->line) != STATUS_OK)
            return in->status->code;
    }
    if (!(row->value[MEASURED_LOAD] > 0 && row->value[MEASURED_RESISTANCE] > 0))
        return status_fail(in->status, STATUS_SCENE, "%s:%zu: load and resistance must be positive", in->name,
                           row->line);
    static const char *const columns[MEASURED_COLUMNS] = {"a load", "a resistance", "an error"};
    static const double least = 1e-100, most = 1e100; /* any that keeps its distance from the ends of double */
    for (size_t c = 0; c < cells.count; c++) {
        double size = fabs(row->value[c]), lowest = c == MEASURED_ERROR ? 0 : least;
        if (!(size >= lowest && size <= most))
            return status_fail(in->status, STATUS_SCENE, "%s:%zu: %s of %g; allowed is %g to %g", in->name, row->line,
                               columns[c], row->value[c], lowest, most);
    }
    return STATUS_OK;
}

/* Is it what programs write where they measured nothing? */
static bool is_no_value(struct span cell)
{
    static const char *const words[] = {"nan", "inf", "+inf", "-inf", "-", "--"};
    bool is = cell.start == cell.end;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        is = is || span_equals(cell, words[i]);
    return is;
}

/* A row whose load is no number, and no remark such as `unloading 2`? Above the rows `Samples, 3` is one, too. */
static bool is_broken_row(struct span line, bool above)
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

static enum status_code refuse_broken(const struct reading *in, struct span line, size_t number)
{
    struct span load = split(line, delimiter_of(line), false).cell[0];
    return status_fail(in->status, STATUS_SCENE,
                       "%s:%zu: '%s' is no load; correct the row or remove it, or put # before a remark", in->name,
                       number, scene_words_show(load.start, span_length(load)).text);
}

/* Does the line begin as a row does, perhaps quoted? */
static bool is_row(struct span line)
{
    const char *p = line.start + (*line.start == '"');
    while (p < line.end && strchr("+-. ", *p))
        p++;
    return p < line.end && *p >= '0' && *p <= '9';
}

static enum status_code row_add(const struct reading *in, size_t *capacity, struct span line, size_t number)
{
    struct measured_file *out = in->out;
    if (out->count == *capacity) {
        *capacity = *capacity ? 2 * *capacity : 64;
        struct measured_row *more = reallocarray(out->rows, *capacity, sizeof *more);
        if (!more)
            return status_memory(in->status);
        out->rows = more;
    }
    struct measured_row row = {{0, 0, NAN}, number};
    if (row_read(in, &row, line) != STATUS_OK)
        return in->status->code;
    out->rows[out->count++] = row;
    return STATUS_OK;
}

enum status_code measured_file_read(struct measured_file *out, struct span content, const char *name,
                                    const unsigned quantities[MEASURED_COLUMNS], struct status *status)
{
    *out = (struct measured_file){0};
    const struct reading in = {out, name, quantities, status};
    struct above above = {.count = 0};
    size_t capacity = 0;
    if (span_starts(content, byte_order_mark))
        content.start += strlen(byte_order_mark);
    struct lines lines = lines_begin(content);
    for (struct span line; lines_next(&lines, &line);) {
        enum status_code rc = STATUS_OK;
        line = span_trim(line);
        if (line.start == line.end)
            continue;
        const char *comment = memchr(line.start, '#', span_length(line));
        if (comment && comment > line.start)
            line = span_trim((struct span){line.start, comment});
        if (is_row(line)) {
            if (out->count == 0)
                rc = headings_use(&in, &above);
            if (rc == STATUS_OK && may_be_decimal_commas(&above, line))
                rc = status_fail(status, STATUS_SCENE,
                                 "%s:%zu: more cells than titles in line %zu: decimal commas? Write decimals with a "
                                 "point, and give an error a title",
                                 name, lines.number, above.number[1]);
            if (rc == STATUS_OK)
                rc = row_add(&in, &capacity, line, lines.number);
        } else if (is_broken_row(line, out->count == 0)) {
            rc = refuse_broken(&in, line, lines.number);
        } else if (out->count == 0) {
            above_note(&above, line, lines.number);
        } else if (is_heading(line) && *line.start != '#') { /* of a second block: the same units, or none */
            struct heading heading = heading_read(line, quantities, false);
            rc = heading_use(&in, &heading, lines.number);
        }
        if (rc != STATUS_OK)
            return rc;
    }
    if (out->count == 0)
        return status_fail(status, STATUS_SCENE, "%s: no row of load and resistance", name);
    return STATUS_OK;
}

void measured_file_free(struct measured_file *file)
{
    free(file->rows);
    *file = (struct measured_file){0};
}
