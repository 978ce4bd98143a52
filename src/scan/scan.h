/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scan files: one reader a format, found by content (never by the file's ending). Everything leaves here in SI. */
#ifndef SCAN_SCAN_H
#define SCAN_SCAN_H

#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>

enum scan_kind { SCAN_PROFILE, SCAN_AREAL };

/** Which profiles are taken from a map: its rows or its columns. */
enum scan_direction { SCAN_DIRECTION_X, SCAN_DIRECTION_Y, SCAN_DIRECTION_COUNT };
extern const char *const scan_direction_names[SCAN_DIRECTION_COUNT]; /* as a scene spells them */

enum { SCAN_WARNINGS = 12, SCAN_WARNING_LENGTH = 240, SCAN_UNIT_SIZE = 16 };

/** What a file holds, as read: not levelled, not resampled. */
struct scan {
    const char *format; /* the reader's name */
    enum scan_kind kind;
    size_t nx, ny;       /* points a row, rows (ny = 1 for a profile) */
    double *x_m;         /* nx positions, or NULL where the file gives a spacing only */
    double dx_m, dy_m;   /* spacing; dx_m = (last - first)/(nx - 1) when x_m is given; dy_m 0 for a profile */
    double nominal_dx_m; /* spacing that the header names beside the positions x_m; 0: none */
    double margin_m[2];  /* run-up and overtravel at its ends, as the header names them; 0: none */
    double *z_m;         /* ny*nx heights, row after row; NaN where a point is missing */
    size_t missing;      /* how many are */
    char x_unit[SCAN_UNIT_SIZE], z_unit[SCAN_UNIT_SIZE]; /* by the file, else by a sidecar, else by the scene */
    char part[104];                                      /* of an archive: which file in it; else "" */
    size_t next_entry;                                   /* where its next scan is; 0: there is none */
    size_t x_column, z_column;                           /* of a table of text, from 1; 0: none */
    bool units_lacking;                                  /* the file itself does not name both units */
    char unknown_unit[2][8];                             /* for x, z: what it names in brackets instead; "": nothing */
    bool units_beside;                                   /* one or both came from a sidecar */
    char *sidecar;                                       /* path of that sidecar; NULL: none was used */
    char warnings[SCAN_WARNINGS][SCAN_WARNING_LENGTH];   /* each one line, lower case */
    size_t warning_count;
};

struct sidecar;
struct text;

/** What the scene says about a file; "" or NULL where it says nothing. Its units are used only where neither the file
 * nor a sidecar names any. */
struct scan_options {
    const char *x_unit, *z_unit;   /* units of length */
    size_t x_column, z_column;     /* of a table of text, from 1; 0: the header decides */
    size_t entry;                  /* of an archive of several scans: 0 the first, then next_entry of the one before */
    const struct sidecar *sidecar; /* set by scan_read_beside() */
    struct text *spent;            /* the file's text, to be freed once its numbers are read; NULL: it stays */
};

/** The bytes of a file in memory; `bytes[length]` is readable and 0. */
struct scan_bytes {
    const char *bytes;
    size_t length;
    const char *path; /* for messages only */
};

/** Lengths [m] that a scan may have; beyond them a unit or an exponent is wrong, and squares of slopes and curvatures
 * might overflow or vanish. */
extern const double scan_least_m, scan_most_m;

/** Reads `path`; scan_free() frees `out` whatever is returned. Lengths are in m; x ascends strictly; at least 3 points;
 * every number is finite or, for z, NaN (missing); steps, the extent and the largest difference of heights (unless all
 * are equal) are scan_least_m to scan_most_m. Errors: STATUS_IO, STATUS_SCAN (no scan; one line: what, where, what to
 * do), STATUS_MEMORY. */
MUST_CHECK enum status_code scan_read(struct scan *out, const char *path, const struct scan_options *options,
                                      struct status *status);
/** The same from bytes in memory, the content of `path`. Where they do not name both units, a sidecar of `path`
 * (text_header.h) is read too: its units come before the scene's, and out->sidecar names it. */
MUST_CHECK enum status_code scan_read_beside(struct scan *out, const struct scan_bytes *file, const char *path,
                                             const struct scan_options *options, struct status *status);
/** The same without a sidecar. */
MUST_CHECK enum status_code scan_read_bytes(struct scan *out, const struct scan_bytes *file,
                                            const struct scan_options *options, struct status *status);
/** What a file is that is certainly no scan, by its name and its bytes (`whole`: all, else only the first): "PNG
 * picture", "text without a row of numbers"; NULL: it may be a scan. */
const char *scan_is_other(const struct scan_bytes *file, bool whole);
/** Is it a zip archive, whose last bytes say what is in it? */
bool scan_tells_at_end(const char *bytes, size_t length);
void scan_free(struct scan *scan);
/** Frees heights and positions only. */
void scan_free_points(struct scan *scan);
/** Exchanges rows and columns of a map. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code scan_transpose(struct scan *scan, struct status *status);
/** Notes a warning; beyond SCAN_WARNINGS it is dropped. */
void scan_warn(struct scan *scan, const char *format, ...) PRINTF_LIKE(2, 3);

/** Metres per unit for "m", "mm", "um", "µm", "micron(s)", "nm", "pm", "A", "in", "mil", "uin" ..., mu in UTF-8 or
 * Latin-1; 0 where the name is no length. */
double scan_unit_m(const char *name);

#endif
