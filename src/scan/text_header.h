/* What the lines above the numbers of a text scan say: the unit of each column and a spacing. */
#ifndef SCAN_TEXT_HEADER_H
#define SCAN_TEXT_HEADER_H

#include "scan/span.h"

enum { TEXT_HEADER_COLUMNS = 8, TEXT_HEADER_LINES = 3 };

struct text_header {
    const char *unit[TEXT_HEADER_COLUMNS]; /* of each column as scan_unit_name() gives it; NULL where none is named */
    double spacing;                        /* in spacing_unit; 0 where none is named */
    const char *spacing_unit;              /* NULL where none is named */
};

/** Without its mark (#, //, %, ;) and trimmed when `line` is a comment, else just trimmed; *comment tells. */
struct span text_header_uncomment(struct span line, bool *comment);

/** Reads `preamble`, the lines above the numbers. Units come from its last TEXT_HEADER_LINES lines that are not blank,
 * where such a line has `columns` cells; a later line wins. Spacings come from any line: `spacing 0.5 um`,
 * `dx=0.5um`, `Resolution,0.156 um/sample`. */
struct text_header text_header_read(struct span preamble, char delimiter, size_t columns);

#endif
