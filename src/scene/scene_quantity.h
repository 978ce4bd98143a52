/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A quantity as people write one: a number in SI, or a number with its unit. */
#ifndef SCENE_SCENE_QUANTITY_H
#define SCENE_SCENE_QUANTITY_H

#include "base/unit.h"
#include "scan/string_view.h"

struct scene_quantity {
    double value;            /* in SI */
    enum unit_quantity kind; /* which of those allowed; of a number without a unit the first (lowest) of them */
    bool has_unit;
    struct unit unit;       /* as written; without one: 1 */
    char text[UNIT_LENGTH]; /* the same, its characters as text_character() allows; "": none */
};

/** Reads `4 mm2`, `2.5um`, `1e4 W/m2/K`, `20 degC`, `10 %` or a number alone, which is in SI; `quantities` has the enum
 * unit_quantity bits it may be. False when it is no number (an infinity on overflow is
 * one), or what stands behind is no unit of one of them. */
bool scene_quantity_read(struct scene_quantity *out, struct string_view text, unsigned quantities);

/** What to write for one, to end a message: "a number in Pa or one with its unit: Pa, kPa, ...". */
struct scene_quantity_help {
    char text[600];
};
struct scene_quantity_help scene_quantity_help(unsigned quantities);

#endif
