/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Units of length, as instruments spell them, and which are none but of slope. */
#ifndef SCAN_SCAN_UNIT_H
#define SCAN_SCAN_UNIT_H

#include "scan/scan.h"
#include "scan/string_view.h"

/** What every unit of slope (mrad, deg, um/mm, ...) is called: "rad". No scan may be in one. */
extern const char scan_slope[];

/** A unit of length: its name as the program prints it ("um" for every spelling of micrometre), and metres per unit; or
 * scan_slope and 0. */
struct scan_unit {
    const char *name;
    double si;
};
/** The unit spelled so; name NULL and 0 when there is none. */
struct scan_unit scan_unit_find(struct string_view name);
/** The unit of so many metres; NULL when it has no name. */
const char *scan_unit_of(double factor);

#endif
