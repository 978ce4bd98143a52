/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the readers of formats share. */
#ifndef SCAN_READER_H
#define SCAN_READER_H

#include "base/text.h"
#include "scan/scan.h"
#include "scan/string_view.h"

#include <stdint.h>

/** What a reader gets: the bytes of a file as in struct scan_bytes, what the scene asks, and where errors go. */
struct scan_file {
    const char *bytes;
    size_t length;
    const char *path;
    const struct scan_options *options; /* NULL where only the format is asked */
    struct status *status;              /* the same */
};

/** The name of every unit of slope (mrad, deg, um/mm, ...): "rad". Heights cannot be in one. */
extern const char scan_slope[];

/** A unit of length, its name as printed ("um" for every spelling of micrometre) and metres per unit; or scan_slope and
 * 0. */
struct scan_unit {
    const char *name;
    double si;
};
/** The unit with this spelling; name NULL and 0: there is none. */
struct scan_unit scan_unit_find(struct string_view name);
/** The unit of so many metres; NULL: it has no name. */
const char *scan_unit_of(double factor);

/** STATUS_SCAN with "path:line: " (line 0: "path: ") before the message; control characters become '?'. */
enum status_code scan_fail(const struct scan_file *file, size_t line, const char *format, ...) PRINTF_LIKE(3, 4);

/** Control characters of `string` become '?'. */
void scan_printable(char *string);

/** At most 24 characters of `view` to quote in a message, all but printable ASCII as '?'. */
struct scan_quote {
    char text[32];
};
struct scan_quote scan_quote(struct string_view view);

/** Copies `view` into the `size` bytes at `to`, cut off if it is longer. */
void scan_copy(char *to, size_t size, struct string_view view);

/** Metres per unit of both axes, by the file (x_named, z_named; NULL or "": it does not say), else by the sidecar for
 * out->x_column and out->z_column, else by the scene. Fills out->x_unit and out->z_unit. Error: STATUS_SCAN, which
 * names every line that the scene lacks, or says that z is a slope. */
MUST_CHECK enum status_code scan_units(struct scan *out, const char *x_named, const char *z_named, double *x_m,
                                       double *z_m, const struct scan_file *file);
/** Sets the units where the format fixes them. */
void scan_set_units(struct scan *out, const char *x_unit, const char *z_unit);
/** Warns of units of the scene that are not used because the file or its sidecar names others. */
void scan_warn_units(struct scan *out, const struct scan_file *file);

/** Are these, as a header says them, ny rows of nx points and within LIMIT_POINTS? To be asked before anything is
 * unpacked. Error: STATUS_SCAN. */
MUST_CHECK enum status_code scan_check_points(double nx, double ny, const struct scan_file *file);
/** Memory for ny rows of nx heights, which the caller fills; ny > 1: a map. `room` is how many points the remaining
 * bytes can hold: a header that claims more, or more than LIMIT_POINTS, is refused before anything is allocated. */
MUST_CHECK enum status_code scan_reserve(struct scan *out, double nx, double ny, size_t room,
                                         const struct scan_file *file);
/** The same for a profile of n points with positions. */
MUST_CHECK enum status_code scan_reserve_x(struct scan *out, double n, size_t room, const struct scan_file *file);

/** A key of a header, and where its value goes: one of the two (a unit has SCAN_UNIT_SIZE bytes). */
struct scan_key {
    const char *key;
    double *number;
    char *unit;
};
/** Takes over `line`, `Key = value`, if it is of one of the keys (the last is NULL). Error: STATUS_SCAN. */
MUST_CHECK enum status_code scan_take_key(const struct scan_key *keys, struct string_view line, size_t line_number,
                                          const struct scan_file *file);

/** Is `cell` what instruments write where they measured nothing: BAD, NaN or stars? */
bool scan_is_missing(struct string_view cell);

/** scan_reserve() of ny rows of nx points, filled with the numbers of `text` times z_m; those from `blank` on
 * are missing points, as is what scan_is_missing() says. Behind the last stands nothing, or what begins with `end`
 * (NULL: nothing). Error: STATUS_SCAN with the line: too few or too many, or no number. */
MUST_CHECK enum status_code scan_take_text(struct scan *out, double nx, double ny, struct string_view text, double z_m,
                                           double blank, const char *end, const struct scan_file *file);

/** Cuts the next word, between blanks or line ends, off `text`; false when nothing is left. */
bool scan_word(struct string_view *text, struct string_view *word);

/** The line, from 1, of the byte at `at`. */
size_t scan_line(const struct scan_file *file, const char *at);

static inline struct string_view scan_view(const struct scan_file *file)
{
    return (struct string_view){file->bytes, file->bytes + file->length};
}

/** Index of the first of n positions, `stride` numbers apart, that breaks the order of the first two (strictly up or
 * strictly down) or is not finite; n: none does. */
size_t scan_disorder(const double *x, size_t stride, size_t n);

/* Is it of that format? Where its first bytes alone do not tell. */
typedef bool scan_sniffer(const struct scan_file *file);
scan_sniffer scan_x3p_sniff, scan_sdf_sniff, scan_npl_prf_sniff, scan_smd_sniff, scan_nist_xml_sniff, scan_text_sniff;

typedef enum status_code scan_reading(struct scan *out, const struct scan_file *file);
scan_reading scan_x3p_read, scan_mahr_prf_read, scan_sur_read, scan_al3d_read, scan_sdf_read, scan_gsf_read,
    scan_gwy_read, scan_surfer_read, scan_mahr_text_read, scan_npl_prf_read, scan_smd_read, scan_nist_xml_read,
    scan_text_read, scan_wyko_read, scan_zygo_read;

/** Is there a row of numbers in this text? */
bool scan_text_has_numbers(const struct scan_file *file);

struct text_header;
/** Takes over what the lines of a file say in units and other keys (text_header_add()); false, and nothing, where one
 * is a row of numbers: that is a scan. */
bool scan_text_read_keys(struct text_header *out, const struct scan_file *file);

/* Numbers in binary files. */

/** Kinds of numbers, in the order of ISO 25178-71's data types. */
enum bytes_type { BYTES_U8, BYTES_U16, BYTES_U32, BYTES_F32, BYTES_I8, BYTES_I16, BYTES_I32, BYTES_F64, BYTES_COUNT };

/** A place in the file, read forward, little-endian. Beyond the end every number is 0 and `overrun` stays set, so that
 * a header can be read first and checked once. */
struct bytes {
    const char *at, *end;
    bool overrun;
};

struct bytes bytes_begin(const struct scan_file *file, size_t offset);
size_t bytes_left(const struct bytes *bytes);
void bytes_skip(struct bytes *bytes, size_t count);
double bytes_number(struct bytes *bytes, enum bytes_type type);
/** A text field of `count` bytes, up to a NUL and trimmed. */
struct string_view bytes_text(struct bytes *bytes, size_t count);
/** Bytes of a number. */
size_t bytes_size(enum bytes_type type);

/* Zip archives in memory (PKWARE APPNOTE 6.3 with ZIP64), entries stored or deflated. Before anything is unpacked, the
 * number of entries, the size that they claim and their bytes in the file are checked against base/limits.h. */

struct archive_entry {
    char name[512];     /* its beginning */
    size_t size;        /* unpacked, as the directory claims */
    const char *packed; /* of packed_size bytes; NULL: they do not lie in the file */
    size_t packed_size;
    unsigned method, flags;
    uint32_t checksum;
};

struct archive {
    const struct scan_file *file;
    struct archive_entry *entries; /* owned */
    size_t count;
};

/** Opens `file`, which has to outlive the archive; archive_close() frees it whatever is returned. Error: STATUS_SCAN,
 * also where entries share bytes or claim more than LIMIT_MEMBERS, LIMIT_UNPACKED_BYTES or LIMIT_UNPACKED_RATIO. */
MUST_CHECK enum status_code archive_open(struct archive *out, const struct scan_file *file);
void archive_close(struct archive *archive);

/** Index of the entry `name` (case ignored; `anywhere`: in any folder); archive->count: there is none. */
size_t archive_find(const struct archive *archive, const char *name, bool anywhere);
/** Unpacks an entry into `text`, which is empty, and compares its checksum; of an entry above `most` bytes only these,
 * without the checksum. Errors name `file`. */
MUST_CHECK enum status_code archive_read(struct text *text, const struct archive *archive, size_t index, size_t most,
                                         const struct scan_file *file);

#endif
