/* The numbers of a text file: rows of one or more columns, with whatever lines stand above them. */
#ifndef SCAN_TEXT_TABLE_H
#define SCAN_TEXT_TABLE_H

#include "scan/reader.h"

struct text_table {
    struct string_view text;     /* the file without byte order mark and end-of-file marks */
    struct string_view preamble; /* the lines above the first row of numbers */
    char delimiter;              /* ',' ';' '\t' or ' ' (any run of blanks) */
    size_t rows, columns;
    double *cell;                 /* rows x columns */
    size_t first_line, last_line; /* where the rows are, counted from 1 */
    struct string_view missing;   /* the first cell that says NaN or BAD, which `cell` has as NaN */
    size_t missing_line;          /* and its line, 0 when there is none */
};

/** Finds the first line that is a row of numbers and reads from there to the end; comments and, with two columns or
 * more, blank lines are passed over. `out` is to be freed with text_table_free() whatever comes back.
 * Errors: STATUS_SCAN with the line: no numbers, a cell that is no number, another number of columns, point and comma
 * both as decimal sign; STATUS_MEMORY. */
MUST_CHECK enum status_code text_table_read(struct text_table *out, const struct scan_bytes *file,
                                            struct status *status);
void text_table_free(struct text_table *table);

/** The line of row `row` (from 0). */
size_t text_table_line(const struct text_table *table, size_t row);

#endif
