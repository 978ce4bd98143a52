/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Text files with units: rows of load, resistance and perhaps its error; or a field of pressure: rows of x, y and
 * pressure, or of an area and its pressure. */
#ifndef SCENE_MEASURED_FILE_H
#define SCENE_MEASURED_FILE_H

#include "base/text.h"
#include "base/unit.h"
#include "scan/string_view.h"

enum { MEASURED_LOAD, MEASURED_RESISTANCE, MEASURED_ERROR, MEASURED_COLUMNS };

/** What is known of a column's unit. */
struct measured_unit {
    bool known;
    struct unit unit;
    char text[UNIT_LENGTH]; /* as written there */
    size_t line;            /* of the file; 0: the scene says so */
};

struct measured_row {
    double value[MEASURED_COLUMNS]; /* as written; the error NaN where there is none */
    size_t line;
};

/** Owned: measured_file_free(). */
struct measured_file {
    struct measured_row *rows; /* in the file's order */
    size_t count;
    struct measured_unit units[MEASURED_COLUMNS];
};

/** Reads `content`, called `name` in messages. `quantities`: the enum unit_quantity bits of each column; lengths in the
 * first mean a field of pressure. A row is two or three numbers, separated by semicolons, tabs, commas or blanks. The
 * last line of titles above the rows names the units, as `load (N)`, `load [N]`, `F/N`, `load_N`, `load N`, or alone.
 * Columns may stand in another order where all name a unit. Text behind # and other text above the rows is skipped.
 * Errors: STATUS_SCENE with file and line: a malformed row, a cell without a title, a number out of range, a wrong
 * unit; STATUS_MEMORY. */
MUST_CHECK enum status_code measured_file_read(struct measured_file *out, struct string_view content, const char *name,
                                               const unsigned quantities[MEASURED_COLUMNS], struct status *status);
/** The same of the file at `path`, which is text without a NUL byte. Errors also: STATUS_IO. */
MUST_CHECK enum status_code measured_file_take(struct measured_file *out, const char *path, const char *name,
                                               const unsigned quantities[MEASURED_COLUMNS], struct status *status);
void measured_file_free(struct measured_file *file);

#endif
