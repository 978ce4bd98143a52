/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/scene_quantity.h"

#include "scan/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

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
