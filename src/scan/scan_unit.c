/* Names of units of length and of slope, in every spelling instruments write. */
#include "scan/reader.h"
#include "scan/scan.h"

#include <math.h>
#include <string.h>

struct unit {
    const char *spelling; /* lower case, every mu as 'u', without plural s */
    const char *name;     /* as the program prints it */
    double si;            /* metres, or dz/dx */
};

static const struct unit units[] = {
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

static const struct unit slopes[] = {
    {"rad", "rad", 1.0},        {"radian", "rad", 1.0},        {"mrad", "mrad", 1e-3},
    {"millirad", "mrad", 1e-3}, {"milliradian", "mrad", 1e-3}, {"urad", "urad", 1e-6},
    {"microrad", "urad", 1e-6}, {"microradian", "urad", 1e-6}, {"nrad", "nrad", 1e-9},
    {"nanorad", "nrad", 1e-9},  {"nanoradian", "nrad", 1e-9},  {"1", "1", 1.0},
    {"m/m", "1", 1.0},          {"mm/mm", "1", 1.0},           {"um/um", "1", 1.0},
    {"nm/nm", "1", 1.0},        {"mm/m", "mm/m", 1e-3},        {"um/mm", "um/mm", 1e-3},
    {"nm/um", "nm/um", 1e-3},   {"um/m", "um/m", 1e-6},        {"nm/mm", "nm/mm", 1e-6},
    {"nm/m", "nm/m", 1e-9},
};

#define COUNT(array) (sizeof(array) / sizeof *(array))

enum { UNIT_LENGTH = 16 };

/* Bytes that stand for another spelling of one letter: micro sign and Greek mu (UTF-8), micro sign (latin-1), A with
 * ring and Angstrom sign (UTF-8), A with ring (latin-1). Longer forms first: 0xC2 0xB5 ends in the latin-1 form. */
static const struct {
    const char *bytes, *letters;
} unit_letters[] = {
    {"\xC2\xB5", "u"},    {"\xCE\xBC", "u"}, {"\xB5", "u"}, {"\xC3\x85", "angstrom"}, {"\xE2\x84\xAB", "angstrom"},
    {"\xC5", "angstrom"},
};

/* `name` in the spelling of the table; false when it is too long to be a unit. */
static bool unit_normalise(char spelling[UNIT_LENGTH], const char *name, size_t length)
{
    size_t used = 0;
    for (size_t i = 0; i < length;) {
        const char *letters = NULL;
        for (size_t k = 0; k < sizeof unit_letters / sizeof *unit_letters && !letters; k++) {
            size_t bytes = strlen(unit_letters[k].bytes);
            if (length - i >= bytes && memcmp(name + i, unit_letters[k].bytes, bytes) == 0) {
                letters = unit_letters[k].letters;
                i += bytes;
            }
        }
        char lower[2] = {name[i < length ? i : length - 1], '\0'};
        if (!letters) {
            if (lower[0] >= 'A' && lower[0] <= 'Z')
                lower[0] = (char)(lower[0] + ('a' - 'A'));
            letters = lower;
            i++;
        }
        if (used + strlen(letters) >= UNIT_LENGTH)
            return false;
        memcpy(spelling + used, letters, strlen(letters));
        used += strlen(letters);
    }
    spelling[used] = '\0';
    return used > 0;
}

static const struct unit *unit_find(const struct unit *table, size_t count, const char *name, size_t length)
{
    char spelling[UNIT_LENGTH];
    if (length == 1 && name[0] == 'A') /* but not 'a' */
        return unit_find(table, count, "angstrom", strlen("angstrom"));
    if (!unit_normalise(spelling, name, length))
        return NULL;
    size_t used = strlen(spelling);
    if (used > 3 && spelling[used - 1] == 's')
        spelling[used - 1] = '\0';
    for (size_t i = 0; i < count; i++)
        if (strcmp(spelling, table[i].spelling) == 0)
            return &table[i];
    return NULL;
}

double scan_unit_m(const char *name, size_t length)
{
    const struct unit *unit = unit_find(units, COUNT(units), name, length);
    return unit ? unit->si : 0.0;
}

const char *scan_unit_name(const char *name, size_t length)
{
    const struct unit *unit = unit_find(units, COUNT(units), name, length);
    return unit ? unit->name : NULL;
}

double scan_unit_slope(const char *name, size_t length)
{
    const struct unit *unit = unit_find(slopes, COUNT(slopes), name, length);
    return unit ? unit->si : 0.0;
}

const char *scan_unit_slope_name(const char *name, size_t length)
{
    const struct unit *unit = unit_find(slopes, COUNT(slopes), name, length);
    return unit ? unit->name : NULL;
}

const char *scan_unit_of(double factor, enum scan_quantity quantity)
{
    const struct unit *table = quantity == SCAN_SLOPE ? slopes : units;
    size_t count = quantity == SCAN_SLOPE ? COUNT(slopes) : COUNT(units);
    for (size_t i = 0; i < count; i++)
        if (fabs(factor - table[i].si) <= 1e-9 * table[i].si)
            return table[i].name;
    return NULL;
}
