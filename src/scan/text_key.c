#include "scan/text_key.h"
#include "scan/number.h"
#include "scan/reader.h"

#include <string.h>

enum { KEY_WORDS = 6 };

#define COUNT(array) (sizeof(array) / sizeof *(array))

static const char separators[] = " \t_[](){}<>/,;:=\"'";

/* The words between two numbers of a line, the first KEY_WORDS of them. */
struct key {
    struct span word[KEY_WORDS];
    size_t count;
    const char *unit; /* named in brackets among them */
};

/* What a number is, by the words in front of it: all of those in `all` and none of `none` (each list ends in NULL). */
struct meaning {
    const char *all[4], *none[8];
    size_t quantity; /* offset of a struct text_quantity in struct text_header, for numbers with a unit */
    size_t number;   /* offset of a double, for numbers without; NO_PLACE: takes `quantity` too */
};

enum { NO_PLACE = 0xffff };
#define QUANTITY(member) offsetof(struct text_header, member)

/* a step of the heights or of the rows is none along the profile */
#define OTHER_AXES                                                                                                     \
    {                                                                                                                  \
        "y", "z", "dy", "dz", "height", "vertical", NULL                                                               \
    }

static const struct meaning meanings[] = {
    {{"spacing", NULL}, OTHER_AXES, QUANTITY(spacing), NO_PLACE},
    {{"dx", NULL}, OTHER_AXES, QUANTITY(spacing), NO_PLACE},
    {{"deltax", NULL}, OTHER_AXES, QUANTITY(spacing), NO_PLACE},
    {{"step", NULL}, OTHER_AXES, QUANTITY(spacing), NO_PLACE},
    {{"resolution", NULL}, OTHER_AXES, QUANTITY(spacing), NO_PLACE},
    {{"interval", NULL}, OTHER_AXES, QUANTITY(spacing), NO_PLACE},
    {{"increment", NULL}, OTHER_AXES, QUANTITY(spacing), NO_PLACE},
    {{"pitch", NULL}, OTHER_AXES, QUANTITY(spacing), NO_PLACE},
    {{"sampling", NULL}, OTHER_AXES, QUANTITY(spacing), NO_PLACE},
    {{"pixel", "size", NULL}, OTHER_AXES, QUANTITY(pixel), NO_PLACE},
    {{"width", NULL}, {NULL}, QUANTITY(width), NO_PLACE},
    {{"x-length", NULL}, {NULL}, QUANTITY(width), NO_PLACE},
    {{"height", NULL}, {"conversion", NULL}, QUANTITY(height), NO_PLACE},
    {{"y-length", NULL}, {NULL}, QUANTITY(height), NO_PLACE},
    {{"w", NULL}, {NULL}, QUANTITY(width), QUANTITY(columns)},
    {{"h", NULL}, {NULL}, QUANTITY(height), QUANTITY(rows)},
    {{"x-pixels", NULL}, {NULL}, QUANTITY(width), QUANTITY(columns)},
    {{"y-pixels", NULL}, {NULL}, QUANTITY(height), QUANTITY(rows)},
};

enum { AXIS_X = 1, AXIS_Y = 2, AXIS_Z = 4 };

/* Words beside `unit` or `units` that say of what, and words that say both. */
static const struct {
    const char *word;
    unsigned axes;
    bool unit;
} axis_words[] = {
    {"x", AXIS_X, false},
    {"x-axis", AXIS_X, false},
    {"lateral", AXIS_X, false},
    {"horizontal", AXIS_X, false},
    {"xy", AXIS_X | AXIS_Y, false},
    {"xyz", AXIS_X | AXIS_Y | AXIS_Z, false},
    {"y", AXIS_Y, false},
    {"y-axis", AXIS_Y, false},
    {"z", AXIS_Z, false},
    {"z-axis", AXIS_Z, false},
    {"value", AXIS_Z, false},
    {"height", AXIS_Z, false},
    {"vertical", AXIS_Z, false},
    {"unit", 0, true},
    {"units", 0, true},
    {"x-unit", AXIS_X, true},
    {"x-units", AXIS_X, true},
    {"xunit", AXIS_X, true},
    {"xunits", AXIS_X, true},
    {"y-unit", AXIS_Y, true},
    {"y-units", AXIS_Y, true},
    {"yunit", AXIS_Y, true},
    {"yunits", AXIS_Y, true},
    {"z-unit", AXIS_Z, true},
    {"z-units", AXIS_Z, true},
    {"zunit", AXIS_Z, true},
    {"zunits", AXIS_Z, true},
    {"xyunits", AXIS_X | AXIS_Y, true},
};

bool text_key_word(struct span *rest, struct span *word, char *before)
{
    *before = '\0';
    for (; rest->start < rest->end && strchr(separators, *rest->start) && *rest->start; rest->start++)
        if (*before == '\0' || *before == ' ' || *before == '\t' || strchr("[({/", *rest->start))
            *before = *rest->start;
    word->start = rest->start;
    while (rest->start < rest->end && !(strchr(separators, *rest->start) && *rest->start))
        rest->start++;
    word->end = rest->start;
    return word->end > word->start;
}

bool text_key_number(struct span word)
{
    double value;
    return number_scan(word, NUMBER_POINT, NULL, &value) != NULL;
}

static bool has_word(const struct key *key, const char *word)
{
    for (size_t i = 0; i < key->count; i++)
        if (span_equals(key->word[i], word))
            return true;
    return false;
}

static bool has_all(const struct key *key, const char *const *words)
{
    for (; *words; words++)
        if (!has_word(key, *words))
            return false;
    return true;
}

static bool has_any(const struct key *key, const char *const *words)
{
    for (; *words; words++)
        if (has_word(key, *words))
            return true;
    return false;
}

/* Takes over `value`, in `unit` (NULL: none), that follows `key`. `sign`: a '=' or the like stands between. */
static void take_number(struct text_header *header, const struct key *key, double value, const char *unit, bool sign)
{
    if (!(value > 0 && value < 1e300) || !(unit || sign))
        return;
    if (has_word(key, "conversion") && has_word(key, "factor")) {
        header->z_factor = value;
        header->z_unit = unit ? unit : header->z_unit;
        return;
    }
    for (size_t i = 0; i < COUNT(meanings); i++) {
        if (!has_all(key, meanings[i].all) || has_any(key, meanings[i].none))
            continue;
        if (unit || meanings[i].number == NO_PLACE)
            memcpy((char *)header + meanings[i].quantity, &(struct text_quantity){value, unit},
                   sizeof(struct text_quantity));
        else
            memcpy((char *)header + meanings[i].number, &value, sizeof value);
        return;
    }
}

const char *text_key_unit(struct span word)
{
    size_t length = span_length(word);
    const char *name = scan_unit_name(word.start, length);
    return name || text_key_number(word) ? name : scan_unit_slope_name(word.start, length);
}

static bool is_unit_word(struct span word)
{
    for (size_t i = 0; i < COUNT(axis_words); i++)
        if (axis_words[i].unit && span_equals(word, axis_words[i].word))
            return true;
    return false;
}

/* Takes over the unit named behind `key`. Returns whether that is a key of a unit; *all: one of everything. */
static bool take_unit(struct text_header *header, const struct key *key, const char *name, bool *all)
{
    unsigned axes = 0;
    bool unit = false;
    for (size_t i = 0; i < COUNT(axis_words); i++) {
        if (!has_word(key, axis_words[i].word))
            continue;
        axes |= axis_words[i].axes;
        unit = unit || axis_words[i].unit;
    }
    *all = unit && axes == 0 && key->count == 1;
    if (!unit || (axes == 0 && !*all))
        return false;
    const char **places[] = {&header->x_unit, &header->y_unit, &header->z_unit};
    for (unsigned i = 0; i < COUNT(places); i++)
        if (axes & (1u << i))
            *places[i] = name;
    if (*all)
        header->all_unit = name;
    return true;
}

static bool says_slope(const struct key *key, struct span word, char before)
{
    static const char *const words[] = {"quantity", "signal", "z", "value", "values", NULL};
    return (before == ':' || before == '=') && (span_equals(word, "slope") || span_equals(word, "slopes")) &&
           has_any(key, words);
}

bool text_key_read(struct text_header *header, struct span line)
{
    struct key key = {.count = 0};
    struct span word;
    const char *taken = NULL; /* the word that a number took as its unit */
    bool any = false, all = false;
    for (char before; text_key_word(&line, &word, &before);) {
        double value;
        const char *name = text_key_unit(word);
        const char *end = number_scan(word, NUMBER_POINT, NULL, &value);
        if (end) {
            bool sign = before && strchr("=:,;\t", before);
            struct span behind = {end, word.end}, rest = line;
            char between;
            if (behind.start == behind.end && !text_key_word(&rest, &behind, &between))
                behind = (struct span){word.end, word.end};
            const char *unit = scan_unit_name(behind.start, span_length(behind));
            taken = unit ? behind.start : NULL;
            take_number(header, &key, value, unit ? unit : key.unit, sign);
            key = (struct key){.count = 0};
            continue;
        }
        if (name && all && word.start != taken)
            header->all_unit = NULL; /* `units: mm, um`: which is whose is not said */
        struct span rest = line, next;
        char between;
        if (name && word.end < line.end && *word.end == '/' && text_key_word(&rest, &next, &between)) {
            const char *ratio = scan_unit_slope_name(word.start, (size_t)(next.end - word.start)); /* um/mm */
            name = ratio ? ratio : name;
            line = ratio ? rest : line;
        }
        bool named = before && strchr("=:,;", before);
        named = named || (key.count > 0 && is_unit_word(key.word[key.count - 1]));
        if (name && named && take_unit(header, &key, name, &all)) {
            any = true;
            key = (struct key){.count = 0};
            continue;
        }
        if (says_slope(&key, word, before))
            any = header->z_slope = true;
        if (name && before && strchr("[({>", before))
            key.unit = name;
        if (key.count < KEY_WORDS)
            key.word[key.count++] = word;
    }
    return any;
}
