/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/limits.h"

const struct limit_row limit_rows[LIMIT_COUNT] = {
#define LIMIT_ROW(key, most, unit, name, meaning, remedy) {name, most, unit, meaning, remedy},
    LIMITS(LIMIT_ROW)
#undef LIMIT_ROW
};
