/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/scene_words.h"
#include "base/text.h"

#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/param.h>

struct scene_words_shown scene_words_show(const char *text)
{
    return scene_words_show_view(string_view_of(text));
}

struct scene_words_shown scene_words_show_view(struct string_view view)
{
    struct scene_words_shown shown;
    const char *text = view.start;
    size_t length = string_view_length(view);
    const size_t most = sizeof shown.text - sizeof "...";
    const bool whole = length <= most;
    if (!whole)
        length = text_fit(text, most);
    for (size_t i = 0; i < length; i++) {
        unsigned char c = (unsigned char)text[i];
        shown.text[i] = c < 0x20 || c == 0x7f ? '?' : text[i];
    }
    strcpy(shown.text + length, whole ? "" : "...");
    return shown;
}

enum { LONGEST_WORD = 63 };

/* Characters to insert, delete or replace (Levenshtein) to make `b` of `a`, case aside. */
static size_t edit_distance(const char *a, const char *b)
{
    size_t columns = strlen(b), distance[LONGEST_WORD + 1];
    for (size_t j = 0; j <= columns; j++)
        distance[j] = j;
    for (size_t i = 1; a[i - 1]; i++) {
        size_t diagonal = distance[0];
        distance[0] = i;
        for (size_t j = 1; j <= columns; j++) {
            size_t replaced = diagonal + (tolower((unsigned char)a[i - 1]) != tolower((unsigned char)b[j - 1]));
            diagonal = distance[j];
            distance[j] = MIN(replaced, 1 + MIN(distance[j], distance[j - 1]));
        }
    }
    return distance[columns];
}

struct scene_words_hint scene_words_hint(const char *word, const char *const *names, size_t count, size_t all)
{
    struct scene_words_hint hint = {""};
    size_t nearest = 0, best = SIZE_MAX;
    for (size_t i = 0; i < all && strlen(word) <= LONGEST_WORD; i++) {
        size_t distance = edit_distance(word, names[i]);
        if (distance < best) {
            best = distance;
            nearest = i;
        }
    }
    if (best <= 1 + strlen(word) / 4) {
        snprintf(hint.text, sizeof hint.text, "did you mean '%s'?", names[nearest]);
        return hint;
    }
    size_t used = 0;
    for (size_t i = 0; i < count && used < sizeof hint.text; i++)
        used += (size_t)snprintf(hint.text + used, sizeof hint.text - used, "%s%s", i ? ", " : "allowed: ", names[i]);
    return hint;
}

bool scene_words_next(struct string_view *word, const char **rest)
{
    static const char separators[] = ", \t\r\n";
    word->start = *rest + strspn(*rest, separators);
    word->end = word->start + strcspn(word->start, separators);
    *rest = word->end;
    return word->end > word->start;
}

size_t scene_words_find(struct string_view word, const char *const *names, size_t count)
{
    const size_t length = string_view_length(word);
    size_t i = 0;
    while (i < count && !(word.start && strlen(names[i]) == length && memcmp(names[i], word.start, length) == 0))
        i++;
    return i;
}

/* The lowest bit: what a number without a unit is. */
static enum unit_quantity first_of(unsigned quantities)
{
    return (enum unit_quantity)(quantities & -quantities);
}

bool scene_quantity_read(struct scene_quantity *out, struct string_view text, unsigned quantities)
{
    text = string_view_trim(text);
    double number;
    const char *end = number_scan(text, NUMBER_POINT, NULL, &number);
    *out = (struct scene_quantity){.kind = first_of(quantities), .unit = {.factor = 1}};
    for (const char *p = text.start; end && p < end; p++)
        if (*p == 'd' || *p == 'D') /* Fortran's exponent */
            return false;
    if (!end)
        return false;
    struct string_view unit = string_view_trim((struct string_view){end, text.end});
    size_t length = string_view_length(unit);
    out->value = number;
    if (length == 0)
        return true;
    if (!unit_read(&out->unit, unit.start, length))
        return false;
    unsigned kind = unit_of(&out->unit, quantities);
    out->kind = (enum unit_quantity)kind;
    out->has_unit = true;
    /* dividing by a power of ten that double holds exactly rounds once, as in 4e-6 */
    double whole = round(1 / out->unit.factor);
    bool divides = out->unit.factor < 1 && 1 / whole == out->unit.factor;
    out->value = (divides ? number / whole : number * out->unit.factor) + out->unit.offset;
    return kind != 0 && unit_shown(out->text, unit.start, length);
}

struct scene_quantity_help scene_quantity_help(unsigned quantities)
{
    struct scene_quantity_help out;
    const char *si = unit_si(first_of(quantities));
    if (quantities == UNIT_NUMBER)
        strcpy(out.text, "a number such as 1.5e-6");
    else
        snprintf(out.text, sizeof out.text, "a number%s%s or one with its unit: %s", *si ? " in " : "", si,
                 unit_known(quantities & ~(unsigned)UNIT_NUMBER).text);
    return out;
}
