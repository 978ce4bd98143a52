/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One message per error, passed explicitly from where it happened to the command that prints it. */
#ifndef BASE_STATUS_H
#define BASE_STATUS_H

#include <stdatomic.h>
#include <stdbool.h>

#define MUST_CHECK        __attribute__((warn_unused_result))
#define PRINTF_LIKE(f, a) __attribute__((format(printf, f, a)))
/** Of a local variable: `release` is called with its address where its block is left, whichever way. */
#define OWNED(release) __attribute__((cleanup(release)))

enum status_code {
    STATUS_OK,
    STATUS_MEMORY,
    STATUS_IO,         /* a file or directory could not be read or written */
    STATUS_USAGE,      /* the command line is wrong */
    STATUS_SCENE,      /* the scene is invalid */
    STATUS_SCAN,       /* a file is not a usable scan */
    STATUS_MODEL,      /* a model does not exist for this surface */
    STATUS_NUMBER,     /* a number that is not finite came out: a fault of the program */
    STATUS_CHART,      /* the charts could not be drawn */
    STATUS_INTERRUPTED /* stopped by a signal */
};

/** The first failure. Zero-initialise. A message is lower case, the problem first, then the remedy, with the subject
 * quoted and file and line where there is one. */
struct status {
    enum status_code code;
    char message[1024];
};

/** Stores code and message and returns the code. An error already stored is kept: the lower level knows best. */
enum status_code status_fail(struct status *status, enum status_code code, const char *format, ...) PRINTF_LIKE(3, 4);

/** Puts "`prefix`: ", such as a file's name, before the stored message and returns its code. */
enum status_code status_prefix(struct status *status, const char *format, ...) PRINTF_LIKE(2, 3);

/** The text of an errno; for a file too large for `ulimit -f`, that. */
const char *status_reason(int error);

/** status_fail() for a failed allocation. */
enum status_code status_memory(struct status *status);

/** The release of OWNED() memory, given the address of the pointer to it. */
void memory_free(void *pointer);

/** Memory was short in a text or a JSON tree, where not every step is checked: output of this process may be incomplete
 * and must not be handed out. */
extern atomic_bool status_lost;

#endif
