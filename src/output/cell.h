/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers of a surface that its table and results.json share. */
#ifndef OUTPUT_CELL_H
#define OUTPUT_CELL_H

#include "results/results.h"
#include <stddef.h>

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
