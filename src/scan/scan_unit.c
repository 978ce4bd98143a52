/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/unit.h"
#include "scan/reader.h"

#include <math.h>
#include <string.h>

const char scan_slope[] = "rad";

/* Units in every spelling that instruments write, in any case: unit_read() takes fewer. */
static const struct {
    struct scan_unit unit;
    const char *spellings; /* lower case, every mu as 'u', without plural s */
} units[] = {
    {{"m", 1.0}, "m meter metre"},
    {{"dm", 1e-1}, "dm"},
    {{"cm", 1e-2}, "cm centimeter centimetre"},
    {{"mm", 1e-3}, "mm millimeter millimetre"},
    {{"um", 1e-6}, "um u micron micrometer micrometre"},
    {{"nm", 1e-9}, "nm nanometer nanometre"},
    {{"pm", 1e-12}, "pm picometer picometre"},
    {{"A", 1e-10}, "angstrom"},
    {{"in", 0.0254}, "in inch inche"},
    {{"mil", 2.54e-5}, "mil thou"},
    {{"uin", 2.54e-8}, "uin uinch uinche microinch microinche"},
    {{scan_slope, 0},
     "rad radian mrad millirad milliradian urad microrad microradian nrad nanorad nanoradian deg degree \xC2\xB0 "
     "arcmin arcsec arcsecond m/m mm/mm um/um nm/nm mm/m um/mm nm/um um/m nm/mm nm/m"},
};
enum { UNITS = sizeof units / sizeof *units };

struct scan_unit scan_unit_find(struct string_view name)
{
    char spelling[UNIT_LENGTH];
    bool angstrom = string_view_length(name) == 1 && *name.start == 'A'; /* but not 'a' */
    if (!unit_spell(spelling, angstrom ? "angstrom" : name.start,
                    angstrom ? strlen("angstrom") : string_view_length(name)))
        return (struct scan_unit){NULL, 0.0};
    struct string_view singular = string_view_of(spelling);
    if (string_view_length(singular) > 3 && (singular.end[-1] == 's' || singular.end[-1] == 'S'))
        singular.end--;
    for (size_t i = 0; i < UNITS; i++)
        if (string_view_is_one_of(singular, units[i].spellings))
            return units[i].unit;
    return (struct scan_unit){NULL, 0.0};
}

double scan_unit_m(const char *name)
{
    return scan_unit_find(string_view_of(name)).si;
}

const char *scan_unit_of(double factor)
{
    for (size_t i = 0; i < UNITS; i++)
        if (units[i].unit.si > 0 && fabs(factor - units[i].unit.si) <= 1e-9 * units[i].unit.si)
            return units[i].unit.name;
    return NULL;
}
