/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is done with hostile bytes, the same by libFuzzer (cmake --workflow --preset fuzz) and by test_fuzz_corpus,
 * which replays the committed corpus. A broken promise ends the process with the line that says it. */
#ifndef TEST_FUZZ_H
#define TEST_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FUZZ_REQUIRE(promise)                                                                                          \
    do {                                                                                                               \
        if (!(promise)) {                                                                                              \
            fprintf(stderr, "%s:%d: broken: %s\n", __FILE__, __LINE__, #promise);                                      \
            abort();                                                                                                   \
        }                                                                                                              \
    } while (0)

/** The bytes of a file of scans, whatever its format. */
void fuzz_scan(const uint8_t *bytes, size_t length);
/** The text of a scene.yaml. */
void fuzz_scene(const uint8_t *bytes, size_t length);
/** One letter, then a text: E or T a file of measured resistances, J a sidecar, M the properties of a material, as they
 * stand in a scene. */
void fuzz_measured(const uint8_t *bytes, size_t length);
/** The results.json of two reports, which are compared, with a form feed between, or one that is compared with itself;
 * and what is said of them. */
void fuzz_compare(const uint8_t *bytes, size_t length);
/** A template, which is filled. */
void fuzz_template(const uint8_t *bytes, size_t length);

/** The bytes of a file of scans, as fuzz_scan() takes them, whose last ones choose the scene of a whole report. */
void fuzz_report(const uint8_t *bytes, size_t length);

/** A file on the heap, so that AddressSanitizer sees every read beyond its end. Inputs that begin with "zip:" or "gz:"
 * are packed first. To be freed. */
char *fuzz_file(const char *bytes, size_t *length);

/** How many runs so far were of a good scan of that format. */
size_t fuzz_scan_good(const char *format);
/** How many pairs of reports were compared, and how many templates filled. */
size_t fuzz_compare_good(void);
size_t fuzz_template_good(void);
/** How many reports were written. */
size_t fuzz_report_good(void);

/** Prints how many runs each format, kind of text, or call had. */
void fuzz_scan_counts(void);
void fuzz_scene_counts(void);
void fuzz_measured_counts(void);
void fuzz_compare_counts(void);
void fuzz_template_counts(void);
void fuzz_report_counts(void);

#endif
