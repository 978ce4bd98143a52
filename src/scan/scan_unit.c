/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/scan_unit.h"
#include "base/unit.h"

#include <math.h>
#include <string.h>

#define DEGREE (M_PI / 180)

/* Names of units of length and of slope, in every spelling instruments write: more lenient than unit_read(), and
 * whatever their case. An angle stands for the slope that it is where it is small. */
static const struct spelled_unit {
    struct scan_unit unit;
    enum scan_quantity quantity; /* of heights, and so lengths, or slopes */
    const char *spellings;       /* lower case, every mu as 'u', without plural s */
} units[] = {
    {{"m", 1.0}, SCAN_HEIGHT, "m meter metre"},
    {{"dm", 1e-1}, SCAN_HEIGHT, "dm"},
    {{"cm", 1e-2}, SCAN_HEIGHT, "cm centimeter centimetre"},
    {{"mm", 1e-3}, SCAN_HEIGHT, "mm millimeter millimetre"},
    {{"um", 1e-6}, SCAN_HEIGHT, "um u micron micrometer micrometre"},
    {{"nm", 1e-9}, SCAN_HEIGHT, "nm nanometer nanometre"},
    {{"pm", 1e-12}, SCAN_HEIGHT, "pm picometer picometre"},
    {{"A", 1e-10}, SCAN_HEIGHT, "angstrom"},
    {{"in", 0.0254}, SCAN_HEIGHT, "in inch inche"},
    {{"mil", 2.54e-5}, SCAN_HEIGHT, "mil thou"},
    {{"uin", 2.54e-8}, SCAN_HEIGHT, "uin uinch uinche microinch microinche"},
    {{"rad", 1.0}, SCAN_SLOPE, "rad radian"},
    {{"mrad", 1e-3}, SCAN_SLOPE, "mrad millirad milliradian"},
    {{"urad", 1e-6}, SCAN_SLOPE, "urad microrad microradian"},
    {{"nrad", 1e-9}, SCAN_SLOPE, "nrad nanorad nanoradian"},
    {{"1", 1.0}, SCAN_SLOPE, "1 m/m mm/mm um/um nm/nm"},
    {{"mm/m", 1e-3}, SCAN_SLOPE, "mm/m"},
    {{"um/mm", 1e-3}, SCAN_SLOPE, "um/mm"},
    {{"nm/um", 1e-3}, SCAN_SLOPE, "nm/um"},
    {{"um/m", 1e-6}, SCAN_SLOPE, "um/m"},
    {{"nm/mm", 1e-6}, SCAN_SLOPE, "nm/mm"},
    {{"nm/m", 1e-9}, SCAN_SLOPE, "nm/m"},
    {{"deg", DEGREE}, SCAN_SLOPE, "deg degree \xC2\xB0"},
    {{"arcmin", DEGREE / 60}, SCAN_SLOPE, "arcmin"},
    {{"arcsec", DEGREE / 3600}, SCAN_SLOPE, "arcsec arcsecond"},
};
static const struct spelled_unit *const units_end = units + sizeof units / sizeof *units;

struct scan_unit scan_unit_find(struct string_view name, enum scan_quantity quantity)
{
    char spelling[UNIT_LENGTH];
    bool angstrom = string_view_length(name) == 1 && *name.start == 'A'; /* but not 'a' */
    if (!unit_spell(spelling, angstrom ? "angstrom" : name.start,
                    angstrom ? strlen("angstrom") : string_view_length(name)))
        return (struct scan_unit){NULL, 0.0};
    struct string_view singular = string_view_of(spelling);
    if (string_view_length(singular) > 3 && (singular.end[-1] == 's' || singular.end[-1] == 'S'))
        singular.end--;
    for (const struct spelled_unit *row = units; row < units_end; row++)
        if (row->quantity == quantity && string_view_is_one_of(singular, row->spellings))
            return row->unit;
    return (struct scan_unit){NULL, 0.0};
}

double scan_unit_m(const char *name)
{
    return scan_unit_find(string_view_of(name), SCAN_HEIGHT).si;
}

const char *scan_unit_of(double factor, enum scan_quantity quantity)
{
    for (const struct spelled_unit *row = units; row < units_end; row++)
        if (row->quantity == quantity && fabs(factor - row->unit.si) <= 1e-9 * row->unit.si)
            return row->unit.name;
    return NULL;
}
