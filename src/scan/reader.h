/* What the readers share among themselves; nothing here is for other stages. */
#ifndef SCAN_READER_H
#define SCAN_READER_H

#include "scan/scan.h"
#include "scan/span.h"

/** Stores STATUS_SCAN with "path:line: " (line 0: "path: ") before the message; control characters become '?'. */
enum status_code scan_fail(struct status *status, const struct scan_bytes *file, size_t line, const char *format, ...)
    PRINTF_LIKE(4, 5);

/** Control characters of `string` become '?'. */
void scan_printable(char *string);

/** At most 24 characters of `span`, printable ASCII only ('?' for the rest), to quote in a message. */
struct scan_quote {
    char text[32];
};
struct scan_quote scan_quote(struct span span);

/** Copies `span` into the `size` bytes at `to`, cut off where it is longer. */
void scan_copy(char *to, size_t size, struct span span);

/** The unit's name as the program prints it ("um" for every spelling of micrometre); NULL when it is no length. */
const char *scan_unit_name(const char *name, size_t length);
/** The same of a unit of slope ("urad" for every spelling of microradian); NULL when it is none. */
const char *scan_unit_slope_name(const char *name, size_t length);
/** The unit of so many metres, or of that slope; NULL when it has no name. */
const char *scan_unit_of(double factor, enum scan_quantity quantity);

/** SI per unit of both axes, which the file names (x_named, z_named; NULL or "" where it does not), else the sidecar
 * for out->x_column and out->z_column, else the scene. out->quantity says whether the file calls z a slope in other
 * words than by its unit. Fills out->x_unit, out->z_unit and out->quantity. Error: STATUS_SCAN, one message that says
 * every scene line that is lacking; a slope that the scene does not call one, or heights that it calls slopes. */
MUST_CHECK enum status_code scan_units(struct scan *out, const char *x_named, const char *z_named, double *x_m,
                                       double *z_m, const struct scan_bytes *file, const struct scan_options *options,
                                       struct status *status);
/** Sets the unit of both axes where the format fixes it. */
void scan_set_units(struct scan *out, const char *x_unit, const char *z_unit);

/** Room for ny rows of nx heights, which the caller fills; kind areal when ny > 1. `room` is the largest number of
 * points that the bytes left can hold: a header that claims more is an error before anything is allocated. */
MUST_CHECK enum status_code scan_reserve(struct scan *out, size_t nx, size_t ny, size_t room,
                                         const struct scan_bytes *file, struct status *status);

/** Is `cell` what instruments write where they measured nothing: BAD or NaN? */
bool scan_is_missing(struct span cell);

/** Fills the heights that scan_reserve() made from `text`, numbers between blanks or line ends, or missing points.
 * Moves text->start behind the last. Error: STATUS_SCAN with the line: too few, or no number. */
MUST_CHECK enum status_code scan_fill(struct scan *out, struct span *text, double z_m, const struct scan_bytes *file,
                                      struct status *status);

/** Cuts the next word (no blanks, no line ends) off `text`; false when nothing is left. */
bool scan_word(struct span *text, struct span *word);

/** The line, from 1, of the byte at `at`. */
size_t scan_line(const struct scan_bytes *file, const char *at);

static inline struct span scan_span(const struct scan_bytes *file)
{
    return (struct span){file->bytes, file->bytes + file->length};
}

/** Index of the first position that breaks the order set by the first two (strictly up or strictly down), n when none
 * does. A non-finite position breaks it. */
size_t scan_disorder(const double *x, size_t n);

/** The slopes dz/dx in scan->z_m become heights by the trapezoidal rule, from 0 at the first point; a missing point
 * stays missing and is bridged. Error: STATUS_SCAN: a map. */
MUST_CHECK enum status_code scan_integrate(struct scan *scan, const struct scan_bytes *file, struct status *status);

/* One pair a format; see the table in scan.c. */
#define SCAN_READER(name)                                                                                              \
    bool scan_##name##_sniff(const struct scan_bytes *file);                                                           \
    enum status_code scan_##name##_read(struct scan *out, const struct scan_bytes *file,                               \
                                        const struct scan_options *options, struct status *status)
SCAN_READER(x3p);
SCAN_READER(zip);
SCAN_READER(mahr_prf);
SCAN_READER(sur);
SCAN_READER(al3d);
SCAN_READER(sdf);
SCAN_READER(gsf);
SCAN_READER(surfer);
SCAN_READER(mahr_text);
SCAN_READER(npl_prf);
SCAN_READER(smd);
SCAN_READER(nist_xml);
SCAN_READER(text);
bool scan_dektak_sniff(const struct scan_bytes *file); /* read as text */
bool scan_hommel_sniff(const struct scan_bytes *file); /* read as text */

#endif
