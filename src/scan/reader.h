/* What the readers share among themselves; nothing here is for other stages. */
#ifndef SCAN_READER_H
#define SCAN_READER_H

#include "scan/scan.h"
#include "scan/span.h"

/** Stores STATUS_SCAN with "path:line: " (line 0: "path: ") before the message; control characters become '?'. */
enum status_code scan_fail(struct status *status, const struct scan_bytes *file, size_t line, const char *format, ...)
    PRINTF_LIKE(4, 5);

/** At most 24 characters of `span`, printable ASCII only ('?' for the rest), to quote in a message. */
struct scan_quote {
    char text[32];
};
struct scan_quote scan_quote(struct span span);

/** The unit's name as the program prints it ("um" for every spelling of micrometre); NULL when it is no length. */
const char *scan_unit_name(const char *name, size_t length);

/** The unit of one axis: `named` by the file, else the one of the scene. Copies its name into `name` and returns
 * metres; 0 when there is none. */
double scan_unit_choose(char name[16], const char *named, const char *scene);

/** Index of the first position that breaks the order set by the first two (strictly up or strictly down), n when none
 * does. A non-finite position breaks it. */
size_t scan_disorder(const double *x, size_t n);

/* text: one row a point, columns of numbers */
bool scan_text_sniff(const struct scan_bytes *file);
enum status_code scan_text_read(struct scan *out, const struct scan_bytes *file, const struct scan_options *options,
                                struct status *status);

#endif
