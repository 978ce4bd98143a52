/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One message per error, passed explicitly from where it happened to the command that prints it. */
#ifndef BASE_STATUS_H
#define BASE_STATUS_H

#define MUST_CHECK        __attribute__((warn_unused_result))
#define PRINTF_LIKE(f, a) __attribute__((format(printf, f, a)))

/* code, what it means */
#define STATUS_CODES(X)                                                                                                \
    X(OK, "done")                                                                                                      \
    X(MEMORY, "out of memory")                                                                                         \
    X(IO, "a file or directory could not be read or written")                                                          \
    X(USAGE, "the command line is wrong")                                                                              \
    X(SCENE, "the scene is invalid")                                                                                   \
    X(SCAN, "a file is not a usable scan")                                                                             \
    X(MODEL, "a model does not exist for this surface")                                                                \
    X(NUMBER, "a number that is not finite came out: a fault of the program")                                          \
    X(CHART, "the charts could not be drawn")                                                                          \
    X(INTERRUPTED, "stopped by a signal")

enum status_code {
#define STATUS_ENUM(name, meaning) STATUS_##name,
    STATUS_CODES(STATUS_ENUM)
#undef STATUS_ENUM
};

/** The outcome of the last call that failed. Zero-initialise; a message is lower case, the problem first, then the
 * remedy, with the subject quoted and file and line where there is one. */
struct status {
    enum status_code code;
    char message[1024];
};

/** Stores code and message in `status` and returns `code`, so that a caller can `return status_fail(...)`.
 * An error already stored is kept: the lower level knows best. */
enum status_code status_fail(struct status *status, enum status_code code, const char *format, ...) PRINTF_LIKE(3, 4);

/** Puts "`prefix`: " before the stored message (say, the file's name) and returns its code. */
enum status_code status_prefix(struct status *status, const char *format, ...) PRINTF_LIKE(2, 3);

/** What errno says; of a file that the limits do not allow, which limit. */
const char *status_reason(int error);

/** Shorthand for an allocation that failed. */
enum status_code status_memory(struct status *status);

#endif
