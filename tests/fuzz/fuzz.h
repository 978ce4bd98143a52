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

/** How many runs so far were of a good scan of that format. */
size_t fuzz_scan_good(const char *format);

/** Prints how many runs each format, or kind of text, had. */
void fuzz_scan_counts(void);
void fuzz_scene_counts(void);
void fuzz_measured_counts(void);

#endif
