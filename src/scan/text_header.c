/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/text_header.h"
#include "base/unit.h"
#include "scan/reader.h"

#include <math.h>
#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof *(array))

enum { KEY_WORDS = 6 };

static const char separators[] = " \t_[](){}<>/,;:=\"'";

/* The words between two numbers of a line, the first KEY_WORDS of them. */
struct key {
    struct string_view word[KEY_WORDS];
    size_t count;
    const char *unit; /* named in brackets among them */
    bool other;       /* and that is no unit of length: [Hz], [mm/s], [points] */
};

#define PLACE(member) offsetof(struct text_header, member)

/* words that make a step one of heights or rows, not along the profile */
#define OTHER_AXES                                                                                                     \
    "y z dy dz deltay deltaz row rows line lines track tracks profile profiles trace traces height heights vertical "
/* what else has a step, a pitch or a resolution, or is sampled */
#define OTHER_THINGS                                                                                                   \
    "length lengths time speed velocity rate frequency points number count counts mean average rsm psm wsm sm "        \
    "evaluation peak peaks groove grooves thread threads grating optical filter cutoff tip stylus bit bits depth "     \
    "angle force temperature"

/* What a number is, by the words before it: one of `any`, one of `also` if there are such, and none of `none`. */
static const struct {
    const char *any, *also, *none;
    size_t place; /* offset of its struct text_quantity in struct text_header */
} meanings[] = {
    {"factor", "conversion", "", PLACE(z_factor)},
    {"dx deltax spacing step resolution interval increment pitch sampling x-spacing x-step x-resolution x-interval "
     "x-increment x-pitch",
     "", OTHER_AXES OTHER_THINGS, PLACE(spacing)},
    {"scale", "data", "", PLACE(data_scale)},
    {"scale", "x", "y z", PLACE(pixel)},
    {"scale", "y", "x z", PLACE(pixel_y)},
    {"pixel", "size", OTHER_AXES OTHER_THINGS, PLACE(pixel)},
    {"width x-length", "", "pixel", PLACE(width)},
    {"height y-length", "", "pixel step", PLACE(height)},
};

/* A length per one of these is a step; and words that look like units and are none of length. */
static const char samples[] = "sample samples pixel pixels px point points pt pts step steps";
static const char counted[] =
    "points point pts pt samples sample pixels pixel px lines dpi ppi bit bits counts hz khz sec second seconds %";

enum { AXIS_X = 1, AXIS_Y = 2, AXIS_Z = 4 };

/* Words beside `unit` that say of which axis, and words that say both. */
static const struct {
    const char *words;
    unsigned axes;
    bool unit;
} axis_words[] = {
    {"x x-axis lateral horizontal", AXIS_X, false},
    {"y y-axis", AXIS_Y, false},
    {"z z-axis value height vertical data", AXIS_Z, false},
    {"xy", AXIS_X | AXIS_Y, false},
    {"xyz", AXIS_X | AXIS_Y | AXIS_Z, false},
    {"unit units einheit", 0, true},
    {"x-unit x-units xunit xunits", AXIS_X, true},
    {"y-unit y-units yunit yunits", AXIS_Y, true},
    {"z-unit z-units zunit zunits", AXIS_Z, true},
    {"xyunits", AXIS_X | AXIS_Y, true},
};

static const char *either(const char *first, const char *second)
{
    return first ? first : second;
}

/* Does `word` begin with a number? */
static bool is_number(struct string_view word)
{
    double value;
    return number_scan(word, NUMBER_POINT, NULL, &value) != NULL;
}

static bool is_separator(char c)
{
    return c && strchr(separators, c);
}

/* Cuts the next word off `rest`; um/mm is one. *before is the separator before it: a bracket or a slash if there is
 * one, else the first that is no blank, else a blank or 0. */
static bool next_word(struct string_view *rest, struct string_view *word, char *before)
{
    *before = '\0';
    for (; rest->start < rest->end && is_separator(*rest->start); rest->start++)
        if (*before == '\0' || *before == ' ' || *before == '\t' || strchr("[({/", *rest->start))
            *before = *rest->start;
    word->start = rest->start;
    for (; rest->start < rest->end && !is_separator(*rest->start); rest->start++)
        ;
    word->end = rest->start;
    if (rest->start < rest->end && *rest->start == '/') {
        const char *end = rest->start + 1;
        for (; end < rest->end && !is_separator(*end); end++)
            ;
        if (scan_unit_find((struct string_view){word->start, end}).name == scan_slope)
            word->end = rest->start = end;
    }
    return word->end > word->start;
}

static bool has_any(const struct key *key, const char *words)
{
    for (size_t i = 0; i < key->count; i++)
        if (string_view_is_one_of(key->word[i], words))
            return true;
    return false;
}

/* Is `word` a unit, but not of length? */
static bool is_other_unit(struct string_view word)
{
    struct unit unit;
    return word.start < word.end && !scan_unit_find(word).name &&
           (string_view_is_one_of(word, counted) ||
            (unit_read(&unit, word.start, string_view_length(word)) && !unit_of(&unit, UNIT_NUMBER)));
}

/* Does `rest` begin with a sign that a value follows? */
static bool is_key(struct string_view rest)
{
    rest = string_view_trim(rest);
    return rest.start < rest.end && strchr("=:", *rest.start);
}

/* Is the unit of length before `rest` divided by something, and not by samples: mm/s, um per second? */
static bool is_rate(struct string_view rest)
{
    struct string_view word;
    char before;
    if (!next_word(&rest, &word, &before))
        return false;
    bool per = string_view_equals(word, "per");
    return (before == '/' || (per && next_word(&rest, &word, &before))) && !string_view_is_one_of(word, samples);
}

/* Are both equal, to the digits that headers have? A number without a unit may be in any. */
static bool is_same(const struct text_quantity *a, const struct text_quantity *b)
{
    static const double rounding = 5e-3;
    double a_m = a->unit && b->unit ? scan_unit_m(a->unit) : 1, b_m = a->unit && b->unit ? scan_unit_m(b->unit) : 1;
    return fabs(a->value * a_m - b->value * b_m) <= rounding * b->value * b_m;
}

/* Does `rest` begin with "/pixel"? */
static bool is_per_pixel(struct string_view rest)
{
    struct string_view word;
    char before;
    return next_word(&rest, &word, &before) && before == '/' && string_view_is_one_of(word, "pixel pixels px");
}

/* Takes over `value` of line `line`, in `unit` (NULL: none), that follows `key`; `sign`: behind a '=' or the like.
 * Returns whether the key means something. */
static bool take_number(struct text_header *header, const struct key *key, double value, const char *unit, bool sign,
                        size_t line)
{
    for (size_t i = 0; i < COUNT(meanings); i++) {
        if (!has_any(key, meanings[i].any) || (*meanings[i].also && !has_any(key, meanings[i].also)) ||
            has_any(key, meanings[i].none))
            continue;
        if (!(value > 0 && value < 1e300) || !(unit || sign) || (!unit && key->other))
            return true;
        struct text_quantity found = {value, unit, line, 0}, *known = (void *)((char *)header + meanings[i].place);
        if (known->value > 0)
            found.other = is_same(known, &found) ? known->other : known->line;
        if (known->unit && !unit)
            found = (struct text_quantity){known->value, known->unit, known->line, found.other ? line : 0};
        *known = found;
        return true;
    }
    return false;
}

static bool is_unit_word(struct string_view word)
{
    for (size_t i = 0; i < COUNT(axis_words); i++)
        if (axis_words[i].unit && string_view_is_one_of(word, axis_words[i].words))
            return true;
    return false;
}

/* Takes over the unit named after `key`. Returns whether it is the key of a unit; *all: of that of every axis. */
static bool take_unit(struct text_header *header, const struct key *key, const char *name, bool *all)
{
    unsigned axes = 0;
    bool unit = false;
    for (size_t i = 0; i < COUNT(axis_words); i++) {
        if (!has_any(key, axis_words[i].words))
            continue;
        axes |= axis_words[i].axes;
        unit = unit || axis_words[i].unit;
    }
    *all = unit && axes == 0 && key->count == 1;
    if (!unit || (axes == 0 && !*all))
        return false;
    header->x_unit = axes & AXIS_X ? name : header->x_unit;
    header->y_unit = axes & AXIS_Y ? name : header->y_unit;
    header->z_unit = axes & AXIS_Z ? name : header->z_unit;
    header->all_unit = *all ? name : header->all_unit;
    return true;
}

/* A comma has cut the number off at `end`: of `0,5 um` only `0` was read. Returns the end of the whole number, which
 * goes to *value, and of `word`. Three digits after the comma may be thousands, except behind 0: then the value is 0,
 * which no length is. */
static const char *decimal_comma(struct string_view *line, struct string_view *word, const char *end, double *value)
{
    struct string_view all = {word->start, line->end};
    double with_comma;
    const char *stop = number_scan(all, NUMBER_COMMA, NULL, &with_comma);
    if (end != word->end || !stop || stop <= end || (stop < line->end && *stop == ','))
        return end;
    *value = stop - end == 4 && *value != 0 ? 0 : with_comma;
    for (word->end = line->start = stop; line->start < line->end && !is_separator(*line->start);)
        word->end = ++line->start;
    return stop;
}

static const struct key pixel_size = {.word = {{"pixel", "pixel" + 5}, {"size", "size" + 4}}, .count = 2};

/* Takes over what the keys in `line` say, and tells whether one of them names a unit. */
static bool add_line(struct text_header *header, struct string_view line, size_t number)
{
    struct key key = {.count = 0};
    struct string_view word;
    bool any = false, all = false;
    for (char before; next_word(&line, &word, &before);) {
        double value;
        const char *end = number_scan(word, NUMBER_POINT, NULL, &value), *name = scan_unit_find(word).name;
        if (end && before != ',' && end == line.start)
            end = decimal_comma(&line, &word, end, &value);
        if (end) { /* its unit follows at once, or is the next word */
            bool sign = before && strchr("=:,;\t", before);
            struct string_view behind = {end, word.end}, rest = line;
            char between;
            if (end == word.end && !next_word(&rest, &behind, &between))
                behind = (struct string_view){end, end};
            struct scan_unit found = scan_unit_find(behind);
            const char *unit = found.si > 0 ? found.name : NULL;
            rest = end == word.end ? rest : line;
            bool other = unit ? is_rate(rest) : is_other_unit(behind) && !is_key(rest);
            line = unit ? rest : line;
            if (!other && !take_number(header, &key, value, unit ? unit : key.unit, sign, number) && unit &&
                is_per_pixel(rest) && key.count > 0 && !has_any(&key, OTHER_AXES OTHER_THINGS))
                take_number(header, &pixel_size, value, unit, sign, number); /* `XY-Justierung,277.8,nm/pixel` */
            key = (struct key){.count = 0};
            continue;
        }
        if (name && all)
            header->all_unit = NULL; /* `units: mm, um`: it is not said which is whose */
        bool named = before && strchr("=:,;", before);
        named = named || (key.count > 0 && is_unit_word(key.word[key.count - 1]));
        if (name && named && take_unit(header, &key, name, &all)) {
            any = true;
            key = (struct key){.count = 0};
            continue;
        }
        if (before && strchr("[({>", before)) {
            key.unit = name ? name : key.unit;
            key.other = is_other_unit(word) || (name && is_rate(line));
            key.unit = key.other ? NULL : key.unit;
        }
        if (key.count < KEY_WORDS)
            key.word[key.count++] = word;
    }
    return any;
}

static const char *const comment_marks[] = {"#", "//", "%", ";"};

struct string_view text_header_uncomment(struct string_view line, bool *comment)
{
    line = string_view_trim(line);
    const char *start = line.start;
    for (size_t i = 0; i < COUNT(comment_marks); i++)
        while (string_view_starts(line, comment_marks[i]))
            line.start += strlen(comment_marks[i]);
    *comment = line.start > start;
    return string_view_trim(line);
}

bool text_header_title_slope(struct string_view title)
{
    static const char taken_out[] =
        "removed removal corrected correction subtracted subtraction compensated compensation detrended out";
    bool slope = text_header_says(title, "slope slopes gradient");
    struct string_view rest = title, word, last = {NULL, NULL};
    for (char before; next_word(&rest, &word, &before); last = word)
        slope = slope || (before == '/' && last.start && string_view_equals(word, "dx") &&
                          string_view_is_one_of(last, "dz dh dy"));
    return slope && !text_header_says(title, taken_out);
}

bool text_header_says(struct string_view title, const char *words)
{
    struct string_view word;
    for (char before; next_word(&title, &word, &before);)
        if (string_view_is_one_of(word, words))
            return true;
    return false;
}

/* The unit that a column's title names: its last word that is one. A word that might be something else ("A", "in", any
 * word of a line with numbers, as `Length, 1500.0 um`) counts only in brackets or behind a slash. A short word in
 * brackets that is no unit, [km], is *unknown. */
static const char *cell_unit(struct string_view cell, bool with_numbers, struct string_view *unknown)
{
    enum { SHORT = 6 };
    const char *unit = NULL;
    struct string_view word;
    for (char before; next_word(&cell, &word, &before);) {
        const char *name = scan_unit_find(word).name;
        bool is_word = with_numbers || string_view_is_one_of(word, "a in u");
        if (name && (!is_word || (before && strchr("[({/", before))))
            unit = name;
        if (!name && before && strchr("[(", before) && string_view_length(word) <= SHORT && !is_number(word))
            *unknown = word;
    }
    return unit;
}

/* Is it only a unit, or something in brackets, as in a line of units below the titles? */
static bool is_bare(struct string_view cell)
{
    return scan_unit_find(cell).name ||
           (string_view_length(cell) > 2 && strchr("[({", *cell.start) && strchr("])}", cell.end[-1]));
}

static bool has_numbers(struct string_view line)
{
    struct string_view word;
    for (char before; next_word(&line, &word, &before);)
        if (is_number(word))
            return true;
    return false;
}

/* The titles in `line`; false where it is no line of them: not `columns` cells, or numbers among them. */
static bool read_titles(struct text_header *header, struct string_view line, char delimiter, size_t columns)
{
    struct text_header found = *header;
    size_t count = 0, filled = 0, bare = 0, last_bare = 0;
    bool with_numbers = has_numbers(line);
    /* above one column of heights it speaks of x, or is a key with its number: `dx [mm] = 0.5` */
    if (columns == 1 &&
        (with_numbers || text_header_says(line, "x dx lateral horizontal spacing step length position")))
        return false;
    for (struct string_view cell; cell_next(&line, delimiter, &cell); count++) {
        if (is_number(cell))
            return false;
        if (cell.start == cell.end)
            continue;
        filled = count + 1;
        if (string_view_equals(cell, "valid"))
            found.valid = count;
        if (count >= TEXT_HEADER_COLUMNS)
            continue;
        found.unit[count] = either(cell_unit(cell, with_numbers, &found.unknown[count]), header->unit[count]);
        if (header->unit[count] == scan_slope || text_header_title_slope(cell))
            found.unit[count] = scan_slope; /* whatever its unit is said to be */
        bare += is_bare(cell) ? 1 : 0;
        last_bare = is_bare(cell) ? count : last_bare;
    }
    if (filled != columns)
        return false;
    if (columns > 1 && bare == 1) /* a single unit, `X: mm`, need not be that of the column below it */
        found.unit[last_bare] = header->unit[last_bare];
    *header = found;
    return true;
}

bool text_header_add(struct text_header *header, struct string_view text)
{
    bool any = false, comment;
    struct lines lines = lines_begin(text);
    for (struct string_view line; lines_next(&lines, &line);)
        any = add_line(header, text_header_uncomment(line, &comment), lines.number) || any;
    return any;
}

/* The unit of what follows the last colon of `line`: a length (*value > 0) or the unit alone; NULL: neither. */
static const char *value_of(struct string_view line, double *value)
{
    const char *colon = memrchr(line.start, ':', string_view_length(line));
    struct string_view rest = string_view_trim((struct string_view){colon ? colon + 1 : line.end, line.end});
    const char *end = number_scan(rest, NUMBER_POINT | NUMBER_COMMA, NULL, value);
    *value = end && isfinite(*value) ? *value : 0;
    return scan_unit_find(string_view_trim((struct string_view){end ? end : rest.start, rest.end})).name;
}

/* Gwyddion's header in any language: comments with a name, a width, a height and a unit. Where there are exactly two
 * lengths, in lines that follow each other, they are kept. */
static void find_lengths(struct text_header *header, struct string_view preamble)
{
    struct text_quantity found[2] = {{0}};
    const char *unit_behind = NULL;
    size_t count = 0;
    struct lines lines = lines_begin(preamble);
    for (struct string_view line; lines_next(&lines, &line);) {
        bool comment;
        double value;
        line = text_header_uncomment(line, &comment);
        const char *unit = comment ? value_of(line, &value) : NULL;
        if (!unit)
            continue;
        if (value > 0 && count < 2)
            found[count] = (struct text_quantity){value, unit, lines.number, 0};
        count += value > 0 ? 1 : 0;
        if (value == 0 && count == 2 && lines.number == found[1].line + 1)
            unit_behind = unit;
    }
    if (count != 2 || found[1].line != found[0].line + 1)
        return;
    memcpy(header->length, found, sizeof found);
    header->behind_lengths = unit_behind;
}

struct text_header text_header_read(struct string_view preamble, char delimiter, size_t columns)
{
    const char delimiters[] = {delimiter, '\t', ';', ',', ' '}; /* titles may be separated differently from numbers */
    struct text_header header = {.valid = SIZE_MAX};
    struct string_view last[TEXT_HEADER_LINES]; /* line i, blank ones aside, at i % TEXT_HEADER_LINES */
    size_t count = 0;
    bool spip = false, scaled = false;
    struct lines lines = lines_begin(preamble);
    for (struct string_view line; lines_next(&lines, &line);) {
        bool comment;
        line = text_header_uncomment(line, &comment);
        if (line.start == line.end)
            continue;
        spip = spip || string_view_equals(line, "File Format = ASCII") || string_view_starts(line, "Created by SPIP");
        scaled = scaled || string_view_equals(line, "DataScaleNeeded = yes");
        if (add_line(&header, line, lines.number))
            line.end = line.start; /* `X unit: mm` is no pair of titles */
        last[count++ % TEXT_HEADER_LINES] = line;
    }
    for (size_t i = count > TEXT_HEADER_LINES ? count - TEXT_HEADER_LINES : 0; i < count; i++)
        for (size_t k = 0; k < sizeof delimiters; k++)
            if (read_titles(&header, last[i % TEXT_HEADER_LINES], delimiters[k], columns))
                break;
    find_lengths(&header, preamble);
    if (scaled)
        header.z_factor = header.data_scale;
    if (spip) { /* whose lengths are in nm if no unit is given */
        header.width.unit = either(header.width.unit, "nm");
        header.height.unit = either(header.height.unit, "nm");
    }
    return header;
}

static const char *column_unit(const struct text_header *header, size_t column)
{
    return column > 0 && column <= TEXT_HEADER_COLUMNS ? header->unit[column - 1] : NULL;
}

const char *text_header_x_unit(const struct text_header *header, size_t column)
{
    return either(either(column_unit(header, column), header->x_unit), header->all_unit);
}

const char *text_header_z_unit(const struct text_header *header, size_t column)
{
    const char *y_unit = column == 1 || column == 2 ? header->y_unit : NULL;
    const char *unit = either(column_unit(header, column), either(header->z_factor.unit, header->z_unit));
    return either(unit, either(y_unit, header->all_unit));
}
