/* What the lines above the numbers of a text scan say: titles and units of the columns, and keys with values. */
#ifndef SCAN_TEXT_HEADER_H
#define SCAN_TEXT_HEADER_H

#include "scan/string_view.h"

enum { TEXT_HEADER_COLUMNS = 8, TEXT_HEADER_LINES = 3 };

/** A number with its unit as scan_unit_name() gives it; value 0 and unit NULL where the file says nothing. */
struct text_quantity {
    double value;
    const char *unit;
};

struct text_header {
    const char *unit[TEXT_HEADER_COLUMNS]; /* of each column; NULL where none is named */
    size_t valid;                          /* column that says whether a point is valid; SIZE_MAX where none does */
    struct text_quantity spacing;          /* `spacing 0.5 um`, `dx=0.5um`, `Resolution,0.156 um/sample` */
    struct text_quantity pixel;            /* `pixel size = 0.5 um` */
    struct text_quantity width, height;    /* of a map: `Width: 10 um`, `x-length = 10 um` */
    double columns, rows;                  /* of a map: `w=101 h=101`, `x-pixels = 101`; 0 where not said */
    const char *x_unit, *z_unit;           /* `x_unit: mm`, `Value units: m`; NULL where not said */
    double z_factor;                       /* `height conversion factor (-> m) = 1e-9`; 1 where not said */
};

/** Without its mark (#, //, %, ;) and trimmed when `line` is a comment, else just trimmed; *comment tells. */
struct string_view text_header_uncomment(struct string_view line, bool *comment);

/** Reads `preamble`, the lines above the numbers. Titles come from its last TEXT_HEADER_LINES lines that are not blank,
 * where such a line has `columns` cells; a later line wins. Keys come from any line. */
struct text_header text_header_read(struct string_view preamble, char delimiter, size_t columns);

#endif
