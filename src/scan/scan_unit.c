/* Names of units of length and of slope, in every spelling instruments write: more lenient than unit_read(), and
 * whatever their case. */
#include "base/unit.h"
#include "scan/reader.h"
#include "scan/scan.h"

#include <math.h>
#include <string.h>

struct length_unit {
    const char *spelling; /* lower case, every mu as 'u', without plural s */
    const char *name;     /* as the program prints it */
    double si;            /* metres, or dz/dx */
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

#define DEGREE (M_PI / 180)

/* An angle stands for the slope that it is where it is small. */
static const struct length_unit slopes[] = {
    {"rad", "rad", 1.0},
    {"radian", "rad", 1.0},
    {"mrad", "mrad", 1e-3},
    {"millirad", "mrad", 1e-3},
    {"milliradian", "mrad", 1e-3},
    {"urad", "urad", 1e-6},
    {"microrad", "urad", 1e-6},
    {"microradian", "urad", 1e-6},
    {"nrad", "nrad", 1e-9},
    {"nanorad", "nrad", 1e-9},
    {"nanoradian", "nrad", 1e-9},
    {"1", "1", 1.0},
    {"m/m", "1", 1.0},
    {"mm/mm", "1", 1.0},
    {"um/um", "1", 1.0},
    {"nm/nm", "1", 1.0},
    {"mm/m", "mm/m", 1e-3},
    {"um/mm", "um/mm", 1e-3},
    {"nm/um", "nm/um", 1e-3},
    {"um/m", "um/m", 1e-6},
    {"nm/mm", "nm/mm", 1e-6},
    {"nm/m", "nm/m", 1e-9},
    {"deg", "deg", DEGREE},
    {"degree", "deg", DEGREE},
    {"\xC2\xB0", "deg", DEGREE},
    {"arcmin", "arcmin", DEGREE / 60},
    {"arcsec", "arcsec", DEGREE / 3600},
    {"arcsecond", "arcsec", DEGREE / 3600},
};

#define COUNT(array) (sizeof(array) / sizeof *(array))

static const struct length_unit *unit_find(const struct length_unit *table, size_t count, const char *name,
                                           size_t length)
{
    char spelling[UNIT_LENGTH];
    if (length == 1 && name[0] == 'A') /* but not 'a' */
        return unit_find(table, count, "angstrom", strlen("angstrom"));
    if (!unit_spell(spelling, name, length))
        return NULL;
    for (char *c = spelling; *c; c++)
        if (*c >= 'A' && *c <= 'Z')
            *c = (char)(*c + ('a' - 'A'));
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
    const struct length_unit *unit = unit_find(length_units, COUNT(length_units), name, length);
    return unit ? unit->si : 0.0;
}

const char *scan_unit_name(const char *name, size_t length)
{
    const struct length_unit *unit = unit_find(length_units, COUNT(length_units), name, length);
    return unit ? unit->name : NULL;
}

double scan_unit_slope(const char *name, size_t length)
{
    const struct length_unit *unit = unit_find(slopes, COUNT(slopes), name, length);
    return unit ? unit->si : 0.0;
}

const char *scan_unit_slope_name(const char *name, size_t length)
{
    const struct length_unit *unit = unit_find(slopes, COUNT(slopes), name, length);
    return unit ? unit->name : NULL;
}

const char *scan_unit_of(double factor, enum scan_quantity quantity)
{
    const struct length_unit *table = quantity == SCAN_SLOPE ? slopes : length_units;
    size_t count = quantity == SCAN_SLOPE ? COUNT(slopes) : COUNT(length_units);
    for (size_t i = 0; i < count; i++)
        if (fabs(factor - table[i].si) <= 1e-9 * table[i].si)
            return table[i].name;
    return NULL;
}
