#include "scan/text_key.h"
#include "scan/number.h"
#include "scan/reader.h"

#include <string.h>

enum { KEY_WORDS = 6 };

#define COUNT(array) (sizeof(array) / sizeof *(array))

static const char separators[] = " \t_[](){}<>/,;:=\"'";

/* The words between two numbers of a line, the first KEY_WORDS of them. */
struct key {
    struct string_view word[KEY_WORDS];
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

/* Words in front of the name of a unit. */
static const struct {
    const char *all[3];
    size_t unit; /* offset of a const char * in struct text_header */
} unit_keys[] = {
    {{"x-unit", NULL}, QUANTITY(x_unit)},         {{"x", "unit", NULL}, QUANTITY(x_unit)},
    {{"x", "units", NULL}, QUANTITY(x_unit)},     {{"z-unit", NULL}, QUANTITY(z_unit)},
    {{"z", "unit", NULL}, QUANTITY(z_unit)},      {{"z", "units", NULL}, QUANTITY(z_unit)},
    {{"value", "units", NULL}, QUANTITY(z_unit)},
};

bool text_key_word(struct string_view *rest, struct string_view *word, char *before)
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

bool text_key_number(struct string_view word)
{
    double value;
    return number_scan(word, NUMBER_POINT, NULL, &value) != NULL;
}

static bool has_word(const struct key *key, const char *word)
{
    for (size_t i = 0; i < key->count; i++)
        if (string_view_equals(key->word[i], word))
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

static void take_unit(struct text_header *header, const struct key *key, const char *unit)
{
    for (size_t i = 0; i < COUNT(unit_keys); i++)
        if (has_all(key, unit_keys[i].all))
            memcpy((char *)header + unit_keys[i].unit, &unit, sizeof unit);
}

void text_key_read(struct text_header *header, struct string_view line)
{
    struct key key = {.count = 0};
    struct string_view word;
    char before;
    while (text_key_word(&line, &word, &before)) {
        double value;
        const char *name = scan_unit_name(word.start, string_view_length(word));
        const char *end = number_scan(word, NUMBER_POINT, NULL, &value);
        if (end) {
            bool sign = before && strchr("=:,;\t", before);
            struct string_view behind = {end, word.end}, rest = line;
            char between;
            if (behind.start == behind.end && !text_key_word(&rest, &behind, &between))
                behind = (struct string_view){word.end, word.end};
            const char *unit = scan_unit_name(behind.start, string_view_length(behind));
            take_number(header, &key, value, unit ? unit : key.unit, sign);
            key = (struct key){.count = 0};
        } else {
            if (name && before && strchr("=:,;", before))
                take_unit(header, &key, name);
            if (name && before && strchr("[({>", before))
                key.unit = name;
            if (key.count < KEY_WORDS)
                key.word[key.count++] = word;
        }
    }
}
