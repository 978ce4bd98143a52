/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Heights of a surface as functions of normal ones. */
#ifndef VALIDATION_HEIGHT_LAWS_H
#define VALIDATION_HEIGHT_LAWS_H

enum height_law {
    HEIGHTS_GAUSSIAN,
    HEIGHTS_PLATEAU,
    HEIGHTS_PITS,
    HEIGHTS_PEAKS,
    HEIGHTS_LOGNORMAL,
    HEIGHTS_VALLEYS,
    HEIGHTS_WORN,
    HEIGHTS_BIMODAL,
    HEIGHTS_HEAVY,
    HEIGHT_LAWS
};

struct height_law_row {
    const char *name;
    double (*of)(double normal);
};
extern const struct height_law_row height_laws[HEIGHT_LAWS];

#endif
