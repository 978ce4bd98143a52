/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is run on hostile bytes, by libFuzzer (cmake --workflow --preset fuzz) and by test_fuzz_corpus, which replays
 * the committed corpus. A broken promise ends the process and names its line. */
#ifndef TEST_FUZZ_H
#define TEST_FUZZ_H

#include <stdbool.h>
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
/** A letter, then a text: E or T a file of measured resistances, J a sidecar, M a scene's material, P a map of pressure
 * on the parts. */
void fuzz_measured(const uint8_t *bytes, size_t length);
/** The results.json of two reports, with a form feed between, or of one: compared with the other or itself, and shown.
 */
void fuzz_compare(const uint8_t *bytes, size_t length);
/** A template to be filled. */
void fuzz_template(const uint8_t *bytes, size_t length);
/** The bytes of a file of scans, as fuzz_scan() takes them; the last ones choose the scene of a whole report. */
void fuzz_report(const uint8_t *bytes, size_t length);

/** A file on the heap, so that AddressSanitizer sees every read beyond its end. Inputs that begin with "zip:" or "gz:"
 * are packed first. To be freed. */
char *fuzz_file(const char *bytes, size_t *length);

/** The path of a directory, in memory where there is such a place, which is removed at the end. */
const char *fuzz_place(void);

/** Counts a run of that kind of input: a format, or what the function above takes. */
void fuzz_count(const char *kind, bool good);
/** How many of them were good. */
size_t fuzz_good(const char *kind);
void fuzz_print_counts(void);

#endif
