/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the readers share among themselves; nothing here is for other stages. */
#ifndef SCAN_READER_H
#define SCAN_READER_H

#include "scan/scan.h"
#include "scan/string_view.h"

#include <stdint.h>

/** What a reader is given: the bytes of a file as in struct scan_bytes, what is asked of it, and where errors go. */
struct scan_file {
    const char *bytes;
    size_t length;
    const char *path;
    const struct scan_options *options; /* NULL where the bytes are only looked at */
    struct status *status;              /* the same */
};

/** What every unit of slope (mrad, deg, um/mm, ...) is called: "rad". No scan may be in one. */
extern const char scan_slope[];

/** A unit of length: its name as the program prints it ("um" for every spelling of micrometre), and metres per unit; or
 * scan_slope and 0. */
struct scan_unit {
    const char *name;
    double si;
};
/** The unit spelled so; name NULL and 0 when there is none. */
struct scan_unit scan_unit_find(struct string_view name);
/** The unit of so many metres; NULL when it has no name. */
const char *scan_unit_of(double factor);

/** Stores STATUS_SCAN with "path:line: " (line 0: "path: ") before the message; control characters become '?'. */
enum status_code scan_fail(const struct scan_file *file, size_t line, const char *format, ...) PRINTF_LIKE(3, 4);

/** Control characters of `string` become '?'. */
void scan_printable(char *string);

/** At most 24 characters of `view`, printable ASCII only ('?' for the rest), to quote in a message. */
struct scan_quote {
    char text[32];
};
struct scan_quote scan_quote(struct string_view view);

/** Copies `view` into the `size` bytes at `to`, cut off where it is longer. */
void scan_copy(char *to, size_t size, struct string_view view);

/** SI per unit of both axes, which the file names (x_named, z_named; NULL or "" where it does not), else the sidecar
 * for out->x_column and out->z_column, else the scene. Fills out->x_unit and out->z_unit. Error: STATUS_SCAN, one
 * message that says every scene line that is lacking, or that z is a slope. */
MUST_CHECK enum status_code scan_units(struct scan *out, const char *x_named, const char *z_named, double *x_m,
                                       double *z_m, const struct scan_file *file);
/** Sets the unit of both axes where the format fixes it. */
void scan_set_units(struct scan *out, const char *x_unit, const char *z_unit);
/** Warns of units of the scene that are not used, because the file or its sidecar names others. */
void scan_warn_units(struct scan *out, const struct scan_file *file);

/** Are ny rows of nx points within LIMIT_POINTS? To be asked before anything is unpacked for them. Error: STATUS_SCAN.
 */
MUST_CHECK enum status_code scan_check_points(size_t nx, size_t ny, const struct scan_file *file);

/** Room for ny rows of nx heights, which the caller fills; kind areal when ny > 1. `room` is the largest number of
 * points that the bytes left can hold: a header that claims more, or more than LIMIT_POINTS, is an error before
 * anything is allocated. */
MUST_CHECK enum status_code scan_reserve(struct scan *out, size_t nx, size_t ny, size_t room,
                                         const struct scan_file *file);

/** The same for a profile of n points with their positions. */
MUST_CHECK enum status_code scan_reserve_x(struct scan *out, size_t n, size_t room, const struct scan_file *file);

/** A key of a header, and where its value goes: one of the three; a unit has SCAN_UNIT_SIZE bytes. */
struct scan_key {
    const char *key;
    size_t *count;
    double *number;
    char *unit;
};
/** Takes over `line`, `Key = value`, where it is one of the keys, which end in one that is NULL. Error: STATUS_SCAN. */
MUST_CHECK enum status_code scan_take_key(const struct scan_key *keys, struct string_view line, size_t line_number,
                                          const struct scan_file *file);

/** Is `cell` what instruments write where they measured nothing: BAD, NaN or stars? */
bool scan_is_missing(struct string_view cell);

/** scan_reserve() of out->nx times out->ny points, filled from `text`: numbers between blanks or line ends, or missing
 * points, in units of z_m; behind the last stands nothing, or what begins with `end` (NULL: nothing). Error:
 * STATUS_SCAN with the line: too few or too many, or no number. */
MUST_CHECK enum status_code scan_take_text(struct scan *out, struct string_view text, double z_m, const char *end,
                                           const struct scan_file *file);

/** Cuts the next word (no blanks, no line ends) off `text`; false when nothing is left. */
bool scan_word(struct string_view *text, struct string_view *word);

/** The line, from 1, of the byte at `at`. */
size_t scan_line(const struct scan_file *file, const char *at);

static inline struct string_view scan_view(const struct scan_file *file)
{
    return (struct string_view){file->bytes, file->bytes + file->length};
}

/** Index of the first of n positions, `stride` numbers apart, that breaks the order set by the first two (strictly up
 * or strictly down), n when none does. A non-finite position breaks it. */
size_t scan_disorder(const double *x, size_t stride, size_t n);

/* Does it look like that format (cheap)? Where its first bytes alone do not tell. */
typedef bool scan_sniffer(const struct scan_file *file);
scan_sniffer scan_x3p_sniff, scan_sdf_sniff, scan_npl_prf_sniff, scan_smd_sniff, scan_nist_xml_sniff, scan_text_sniff,
    scan_wyko_sniff, scan_zygo_sniff;

typedef enum status_code scan_reading(struct scan *out, const struct scan_file *file);
scan_reading scan_x3p_read, scan_mahr_prf_read, scan_sur_read, scan_al3d_read, scan_sdf_read, scan_gsf_read,
    scan_gwy_read, scan_surfer_read, scan_mahr_text_read, scan_npl_prf_read, scan_smd_read, scan_nist_xml_read,
    scan_text_read, scan_wyko_read, scan_zygo_read;

/** Are there NUL bytes, or control characters that no text has, in the first bytes? */
bool scan_is_binary(const struct scan_file *file);

/** Is there a row of numbers in this text? */
bool scan_text_has_numbers(const struct scan_file *file);

struct text_header;
/** Takes over what the lines of a file say that are units or other keys (text_header_add()); false, and nothing, where
 * a line is a row of numbers: that is a scan. */
bool scan_text_read_keys(struct text_header *out, const struct scan_file *file);

/* Numbers in binary files: a cursor that never leaves the file. */

/** Kinds of numbers, in the order of ISO 25178-71's data types. */
enum bytes_type { BYTES_U8, BYTES_U16, BYTES_U32, BYTES_F32, BYTES_I8, BYTES_I16, BYTES_I32, BYTES_F64, BYTES_COUNT };

/** Reads forward, little-endian. Past the end every number is 0 and `overrun` stays set, so that a header can be read
 * in one go and checked once. */
struct bytes {
    const char *at, *end;
    bool overrun;
};

struct bytes bytes_begin(const struct scan_file *file, size_t offset);
size_t bytes_left(const struct bytes *bytes);
void bytes_skip(struct bytes *bytes, size_t count);
double bytes_number(struct bytes *bytes, enum bytes_type type);
/** A text field of `count` bytes, without what follows a NUL and without blanks around it. */
struct string_view bytes_text(struct bytes *bytes, size_t count);

/** Bytes a number takes. */
size_t bytes_size(enum bytes_type type);

#endif
