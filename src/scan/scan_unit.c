/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/scan_unit.h"
#include "base/unit.h"

#include <math.h>
#include <string.h>

/* Names of units of length and of slope, in every spelling instruments write: more lenient than unit_read(), and
 * whatever their case. */
struct spelled_unit {
    struct scan_unit unit;
    const char *spellings; /* lower case, every mu as 'u', without plural s */
};

static const struct spelled_unit lengths[] = {
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
    {{NULL, 0.0}, NULL},
};

#define DEGREE (M_PI / 180)

/* An angle stands for the slope that it is where it is small. */
static const struct spelled_unit slopes[] = {
    {{"rad", 1.0}, "rad radian"},
    {{"mrad", 1e-3}, "mrad millirad milliradian"},
    {{"urad", 1e-6}, "urad microrad microradian"},
    {{"nrad", 1e-9}, "nrad nanorad nanoradian"},
    {{"1", 1.0}, "1 m/m mm/mm um/um nm/nm"},
    {{"mm/m", 1e-3}, "mm/m"},
    {{"um/mm", 1e-3}, "um/mm"},
    {{"nm/um", 1e-3}, "nm/um"},
    {{"um/m", 1e-6}, "um/m"},
    {{"nm/mm", 1e-6}, "nm/mm"},
    {{"nm/m", 1e-9}, "nm/m"},
    {{"deg", DEGREE}, "deg degree \xC2\xB0"},
    {{"arcmin", DEGREE / 60}, "arcmin"},
    {{"arcsec", DEGREE / 3600}, "arcsec arcsecond"},
    {{NULL, 0.0}, NULL},
};

static const struct spelled_unit *const unit_tables[SCAN_QUANTITY_COUNT] = {lengths, slopes};

struct scan_unit scan_unit_find(struct string_view name, enum scan_quantity quantity)
{
    char spelling[UNIT_LENGTH];
    const struct spelled_unit *row = unit_tables[quantity];
    bool angstrom = string_view_length(name) == 1 && *name.start == 'A'; /* but not 'a' */
    if (!unit_spell(spelling, angstrom ? "angstrom" : name.start,
                    angstrom ? strlen("angstrom") : string_view_length(name)))
        return (struct scan_unit){NULL, 0.0};
    struct string_view singular = string_view_of(spelling);
    if (string_view_length(singular) > 3 && (singular.end[-1] == 's' || singular.end[-1] == 'S'))
        singular.end--;
    while (row->spellings && !string_view_is_one_of(singular, row->spellings))
        row++;
    return row->unit;
}

double scan_unit_m(const char *name)
{
    return scan_unit_find(string_view_of(name), SCAN_HEIGHT).si;
}

const char *scan_unit_of(double factor, enum scan_quantity quantity)
{
    const struct spelled_unit *row = unit_tables[quantity];
    while (row->spellings && !(fabs(factor - row->unit.si) <= 1e-9 * row->unit.si))
        row++;
    return row->unit.name;
}
