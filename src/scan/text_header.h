/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the lines above the numbers of a text scan say: titles and units of columns, keys with values. */
#ifndef SCAN_TEXT_HEADER_H
#define SCAN_TEXT_HEADER_H

#include "base/text.h"
#include "scan/string_view.h"

#include <stdint.h>

enum { TEXT_HEADER_COLUMNS = 64, TEXT_HEADER_LINES = 3 };

/** A number with its unit as scan_unit_find() names it; value 0 and unit NULL where the file says nothing. */
struct text_quantity {
    double value;
    const char *unit;
    size_t line, other; /* where it stands, from 1, and where another value is given; 0: nowhere */
};

struct text_header {
    const char *unit[TEXT_HEADER_COLUMNS]; /* of each column, scan_slope if its title says so; NULL: none named */
    struct string_view unknown[TEXT_HEADER_COLUMNS]; /* what stands in brackets there and is no unit; in the preamble */
    size_t valid;                                    /* column that says whether a point is valid; SIZE_MAX: none */
    struct text_quantity spacing;                    /* `spacing 0.5 um`, `dx=0.5um`, `Resolution,0.156 um/sample` */
    struct text_quantity pixel;                      /* `pixel size = 0.5 um`, `Scale X = 0.5` */
    struct text_quantity pixel_y;                    /* `Scale Y = 0.5` */
    struct text_quantity width, height;              /* of a map: `Width: 10 um`, `x-length = 10 um` */
    const char *x_unit, *y_unit, *z_unit;            /* `x_unit: mm`, `Value units: m`; NULL where not said */
    const char *all_unit;                            /* `unit: um`: of every axis that has none of its own */
    struct text_quantity z_factor;                   /* `height conversion factor (-> m) = 1e-9` */
    struct text_quantity data_scale;                 /* Nova's `Scale Data = 1`, a factor where it says one is needed */
    struct text_quantity length[2];                  /* the only lengths of a comment header, if in consecutive lines */
    const char *behind_lengths;                      /* unit in the line after these; NULL: none */
};

/** What a file beside a scan says of it (sidecar.h). */
struct sidecar {
    char name[256]; /* without its directory, to print */
    struct text_header header;
};

/** The unit of x, and of z, in `column` (from 1; 0: no table): the column's own, else the one that a key names; NULL
 * where none is given. In column 1 or 2 a unit of y is that of z. */
const char *text_header_x_unit(const struct text_header *header, size_t column);
const char *text_header_z_unit(const struct text_header *header, size_t column);
/** Is it a title of a column of slopes: `Slope (urad)`, `dz/dx`? */
bool text_header_title_slope(struct string_view title);
/** Is one of `words`, which blanks separate, a word of the title? */
bool text_header_says(struct string_view title, const char *words);

/** `line` trimmed and, if it is a comment (*comment), without its mark (#, //, %, ;). */
struct string_view text_header_uncomment(struct string_view line, bool *comment);

/** Takes over what the keys in every line of `text` say (struct text_header); tells whether one names a unit. */
bool text_header_add(struct text_header *header, struct string_view text);

/** Reads `preamble`, the lines above the numbers: keys from any line, titles from the last TEXT_HEADER_LINES that are
 * not blank, if they have `columns` cells; a later line counts. */
struct text_header text_header_read(struct string_view preamble, char delimiter, size_t columns);

/* Sidecar: a file beside a scan that gives its units. `scan.dat` may have `scan.txt`, `scan.json`, `scan.hdr`,
 * `scan.dat.txt` ... It is the JSON of the DABAM metrology database (X1_FACTOR, Y1_FACTOR ...: metres or radians per
 * unit of a column), or has lines such as `x_unit: mm`, as the header of a text scan. */

/** Has `name` the ending of a sidecar? *length is that of what stands before the ending. */
bool sidecar_ending(const char *name, size_t *length);

/** Reads the file at `path`. Returns whether it is a regular file that names units and has no row of numbers. */
bool sidecar_read(struct sidecar *out, const char *path);
/** The same of the file's content. */
bool sidecar_read_text(struct sidecar *out, const struct text *bytes, const char *path);

/** Reads the first sidecar of the scan at `path`; *found is its path (malloc'ed), NULL: none. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code sidecar_find(struct sidecar *out, char **found, const char *path, struct status *status);

#endif
