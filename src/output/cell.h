/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers on their way into a file. NaN stands for what was not computed or does not exist; nothing is infinite. */
#ifndef OUTPUT_CELL_H
#define OUTPUT_CELL_H

#include "base/text.h"
#include "results/results.h"
#include <jansson.h>

/** Whose numbers are written, and where the first that is infinite is said, with quantity and surface: a fault of the
 * program, which costs that number. */
struct cell_guard {
    const char *surface;       /* NULL: of no surface */
    struct results_lost *lost; /* NULL: nobody asks */
};

/** Adds a comma and the number (%.17g, SI), nothing more for NaN. */
void cell_number(struct text *row, const struct cell_guard *guard, const char *quantity, double value);
/** The number, null for NaN. */
json_t *cell_json(const struct cell_guard *guard, const char *quantity, double value);

/** What is said of a surface, number by number, under one name in surfaces.csv and results.json. */
struct cell_column {
    const char *name;
    size_t offset;                                                /* in struct surface_summary */
    enum { CELL_ALWAYS, CELL_OF_ASPERITIES, CELL_JSON } in_table; /* only when a model works on them; or never */
};
extern const struct cell_column cell_columns[];
extern const size_t cell_column_count;
double cell_column_of(const struct surface_summary *surface, size_t column);

#endif
