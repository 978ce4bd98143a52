/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the lines above the numbers of a text scan say: titles and units of the columns, and keys with values. */
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
    size_t line, other; /* where it stands, from 1, and where something else is said; 0: nowhere */
};

struct text_header {
    const char *unit[TEXT_HEADER_COLUMNS]; /* of each column, scan_slope of one whose title says so; NULL: none named */
    struct string_view unknown[TEXT_HEADER_COLUMNS]; /* what stands in brackets there and is no unit; in the preamble */
    size_t valid;                         /* column that says whether a point is valid; SIZE_MAX where none does */
    struct text_quantity spacing;         /* `spacing 0.5 um`, `dx=0.5um`, `Resolution,0.156 um/sample` */
    struct text_quantity pixel;           /* `pixel size = 0.5 um`, `Scale X = 0.5` */
    struct text_quantity pixel_y;         /* `Scale Y = 0.5` */
    struct text_quantity width, height;   /* of a map: `Width: 10 um`, `x-length = 10 um` */
    const char *x_unit, *y_unit, *z_unit; /* `x_unit: mm`, `Value units: m`; NULL where not said */
    const char *all_unit;                 /* `unit: um`: of every axis that has none of its own */
    struct text_quantity z_factor;        /* `height conversion factor (-> m) = 1e-9` */
    struct text_quantity data_scale;      /* Nova's `Scale Data = 1`, a factor where it says one is needed */
    struct text_quantity length[2];       /* the only lengths of a comment header, in lines that follow each other */
    const char *behind_lengths;           /* unit that the next line names; NULL: none */
};

/** What a file beside a scan says of it (sidecar.h). */
struct sidecar {
    char name[256]; /* without its directory, to print */
    struct text_header header;
};

/** The unit of x in `column` (from 1; 0: no table) and of z: the column's own, else the one that a key names; NULL
 * where none is said. A y beside no third column is z. */
const char *text_header_x_unit(const struct text_header *header, size_t column);
const char *text_header_z_unit(const struct text_header *header, size_t column);
/** Is it a title of a column of slopes: `Slope (urad)`, `dz/dx`? */
bool text_header_title_slope(struct string_view title);
/** Is one of `words`, which blanks separate, a word of the title? */
bool text_header_says(struct string_view title, const char *words);

/** Without its mark (#, //, %, ;) and trimmed when `line` is a comment, else just trimmed; *comment tells. */
struct string_view text_header_uncomment(struct string_view line, bool *comment);

/** Takes over what the keys in every line of `text` say, as the members of struct text_header describe it. Does one of
 * them name a unit? */
bool text_header_add(struct text_header *header, struct string_view text);

/** Reads `preamble`, the lines above the numbers. Titles come from its last TEXT_HEADER_LINES lines that are not blank,
 * where such a line has `columns` cells; a later line wins. Keys come from any line. */
struct text_header text_header_read(struct string_view preamble, char delimiter, size_t columns);

/* A file beside a scan that says its units: `scan.dat` may have `scan.txt`, `scan.json`, `scan.hdr` or `scan.dat.txt`,
 * ... Two kinds are known: the JSON of the DABAM metrology database (X1_FACTOR, Y1_FACTOR, ...: metres or radians per
 * unit of a column), and lines such as `x_unit: mm`, as in the header of a text scan. */

/** Has `name` the ending of a sidecar? *length gets how much stands before that ending. */
bool sidecar_ending(const char *name, size_t *length);

/** Reads the file at `path`. Returns whether it is a regular file that names units and has no row of numbers. */
bool sidecar_read(struct sidecar *out, const char *path);
/** The same of the file's content. */
bool sidecar_read_text(struct sidecar *out, const struct text *bytes, const char *path);

/** Reads the first sidecar there is of the scan at `path`: *found gets its path (malloc'ed), NULL where there is none.
 * Error: STATUS_MEMORY. */
MUST_CHECK enum status_code sidecar_find(struct sidecar *out, char **found, const char *path, struct status *status);

#endif
