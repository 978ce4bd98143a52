/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Upper limits, so that no input exhausts memory or time: one table, used by the code and listed in docs/limits.md. */
#ifndef BASE_LIMITS_H
#define BASE_LIMITS_H

#include <stddef.h>
#include <stdio.h>

/* Name in the code, value, unit, name as printed, what is counted, what to do where there is more: it is refused. */
#define LIMITS(X)                                                                                                      \
    X(FILES, 1000000, "files", "files", "entries of one directory that is listed",                                     \
      "spread them over several directories")                                                                          \
    X(SCENE_FILES, 100000, "files", "scene-files", "files that one scene names", "split it")                           \
    X(FILE_BYTES, 2147483648, "bytes", "file", "a file, or standard input", "cut it down")                             \
    X(UNPACKED_BYTES, 2147483648, "bytes", "unpacked", "all that one file on disk unpacks to",                         \
      "unpack it, or split it")                                                                                        \
    X(UNPACKED_RATIO, 100, "times", "ratio", "what unpacks to more than 4 MiB against its packed size",                \
      "unpack it, or export it again")                                                                                 \
    X(MEMBERS, 1000, "files", "members", "files in an archive (zip, X3P)", "unpack it, or split it")                   \
    X(PACKED_DEPTH, 1, "level", "packed", "files packed within files", "unpack it")                                    \
    X(POINTS, 100000000, "points", "points", "points of a profile or a map", "cut it into parts, or thin it")          \
    X(CELLS, 300000000, "numbers", "numbers", "numbers in all columns of a text",                                      \
      "keep the columns of the scan alone, or thin it")                                                                \
    X(COLUMNS, 65536, "columns", "columns", "columns of a text", "cut the map into parts")                             \
    X(LINE_BYTES, 2097152, "bytes", "line", "a line of a text", "give every row of points a line of its own")          \
    X(HEADER_BYTES, 4194304, "bytes", "header", "what stands above the first row of numbers of a text", "shorten it")  \
    X(XML_BYTES, 67108864, "bytes", "xml", "main.xml of an X3P file", "store the points in a binary file")             \
    X(XML_ELEMENTS, 1000000, "items", "elements", "elements and attributes of main.xml",                               \
      "store the points in a binary file")                                                                             \
    X(XML_TAG_BYTES, 1048576, "bytes", "tag", "a tag or comment of main.xml", "export the scan again")                 \
    X(XML_DEPTH, 64, "elements", "depth", "elements of main.xml within one another", "export the scan again")          \
    X(MEASURED_LINES, 100000, "lines", "measured", "lines of a file of measured resistance, rows of all", "thin it")   \
    X(MEASURED_LINE_BYTES, 1000, "bytes", "measured-line", "a line of it", "shorten it")                               \
    X(NAME_BYTES, 255, "bytes", "name", "the name of a surface, which every row of the tables repeats", "shorten it")  \
    X(RESULTS_BYTES, 134217728, "bytes", "results", "a results.json that `compare` reads", "report fewer surfaces")    \
    X(RESULTS_VALUES, 10000000, "values", "values",                                                                    \
      "values of all that `compare` reads at once, an array as two, an object as four, a text or name one more",       \
      "compare fewer reports at once")                                                                                 \
    X(COMPARED, 200000, "items", "compared", "numbers and inputs that `compare` prints, each of every report",         \
      "compare fewer reports at once")                                                                                 \
    X(RANKED, 2000, "surfaces", "ranked", "surfaces of all reports that `compare` ranks, each tested against each",    \
      "compare fewer reports at once")                                                                                 \
    X(TEMPLATE_BYTES, 1048576, "bytes", "template", "a template, with its partials within one another", "cut it down") \
    X(TEMPLATE_STEPS, 100000000, "steps", "steps",                                                                     \
      "tokens that are filled in, parts of the view that are looked into, and bytes of partials",                      \
      "put fewer sections within each other")                                                                          \
    X(PAGE_BYTES, 536870912, "bytes", "page", "what a template makes", "print less of each item")                      \
    X(DIRECT_POINTS, 1073741824, "points", "direct", "the square of the grid times the seeds of the direct solution",  \
      "take a smaller grid, or fewer seeds")

enum limit {
#define LIMIT_ENUM(key, most, unit, name, meaning, remedy) LIMIT_##key,
    LIMITS(LIMIT_ENUM)
#undef LIMIT_ENUM
        LIMIT_COUNT
};

struct limit_row {
    const char *name;    /* as printed, one word */
    size_t most;         /* allowed */
    const char *unit;    /* of `most` */
    const char *meaning; /* what is counted */
    const char *remedy;  /* what to do where there is more */
};

extern const struct limit_row limit_rows[LIMIT_COUNT];

static inline size_t limit_most(enum limit limit)
{
    return limit_rows[limit].most;
}

/** Bytes that `packed` bytes may unpack to, by LIMIT_UNPACKED_RATIO: no measurement makes more. */
static inline size_t limit_unpacked(size_t packed)
{
    return (4 << 20) + packed * limit_most(LIMIT_UNPACKED_RATIO);
}

/** The end of a message about a limit: "; at most 1000 files: unpack it, or split it". */
struct limit_words {
    char text[160];
};
static inline struct limit_words limit_words(enum limit limit)
{
    const struct limit_row *row = &limit_rows[limit];
    struct limit_words words;
    snprintf(words.text, sizeof words.text, "; at most %zu %s: %s", row->most, row->unit, row->remedy);
    return words;
}

#endif
