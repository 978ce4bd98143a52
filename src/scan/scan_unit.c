/* Names of length units, in every spelling instruments write: more lenient than unit_read(), and whatever their case.
 */
#include "base/unit.h"
#include "scan/reader.h"
#include "scan/scan.h"

#include <string.h>

struct length_unit {
    const char *spelling; /* lower case, every mu as 'u', without plural s */
    const char *name;     /* as the program prints it */
    double metres;
};

static const struct length_unit length_units[] = {
    {"m", "m", 1.0},
    {"meter", "m", 1.0},
    {"metre", "m", 1.0},
    {"dm", "dm", 1e-1},
    {"cm", "cm", 1e-2},
    {"centimeter", "cm", 1e-2},
    {"centimetre", "cm", 1e-2},
    {"mm", "mm", 1e-3},
    {"millimeter", "mm", 1e-3},
    {"millimetre", "mm", 1e-3},
    {"um", "um", 1e-6},
    {"u", "um", 1e-6},
    {"micron", "um", 1e-6},
    {"micrometer", "um", 1e-6},
    {"micrometre", "um", 1e-6},
    {"nm", "nm", 1e-9},
    {"nanometer", "nm", 1e-9},
    {"nanometre", "nm", 1e-9},
    {"pm", "pm", 1e-12},
    {"picometer", "pm", 1e-12},
    {"picometre", "pm", 1e-12},
    {"angstrom", "A", 1e-10},
    {"in", "in", 0.0254},
    {"inch", "in", 0.0254},
    {"inche", "in", 0.0254},
    {"mil", "mil", 2.54e-5},
    {"thou", "mil", 2.54e-5},
    {"uin", "uin", 2.54e-8},
    {"uinch", "uin", 2.54e-8},
    {"uinche", "uin", 2.54e-8},
    {"microinch", "uin", 2.54e-8},
    {"microinche", "uin", 2.54e-8},
};

static const struct length_unit *unit_find(const char *name, size_t length)
{
    char spelling[UNIT_LENGTH];
    if (length == 1 && name[0] == 'A') /* but not 'a' */
        return unit_find("angstrom", strlen("angstrom"));
    if (!unit_spell(spelling, name, length))
        return NULL;
    for (char *c = spelling; *c; c++)
        if (*c >= 'A' && *c <= 'Z')
            *c = (char)(*c + ('a' - 'A'));
    size_t used = strlen(spelling);
    if (used > 3 && spelling[used - 1] == 's')
        spelling[used - 1] = '\0';
    for (size_t i = 0; i < sizeof length_units / sizeof *length_units; i++)
        if (strcmp(spelling, length_units[i].spelling) == 0)
            return &length_units[i];
    return NULL;
}

double scan_unit_m(const char *name, size_t length)
{
    const struct length_unit *unit = unit_find(name, length);
    return unit ? unit->metres : 0.0;
}

const char *scan_unit_name(const char *name, size_t length)
{
    const struct length_unit *unit = unit_find(name, length);
    return unit ? unit->name : NULL;
}
