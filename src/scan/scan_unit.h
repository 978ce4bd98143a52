/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Units of length and of slope, as instruments spell them. */
#ifndef SCAN_SCAN_UNIT_H
#define SCAN_SCAN_UNIT_H

#include "scan/scan.h"
#include "scan/string_view.h"

/** A unit of length or of slope: its name as the program prints it ("um" for every spelling of micrometre), and metres
 * or dz/dx per unit. */
struct scan_unit {
    const char *name;
    double si;
};
/** The unit of that quantity spelled so; name NULL and 0 when there is none. Of slopes: "rad", "mrad", "urad", "nrad"
 * (an angle counts as its tangent, as is the custom for slope errors), "um/mm", "um/m", "nm/mm"..., "1". */
struct scan_unit scan_unit_find(struct string_view name, enum scan_quantity quantity);
/** The unit of so many metres, or of that slope; NULL when it has no name. */
const char *scan_unit_of(double factor, enum scan_quantity quantity);

#endif
