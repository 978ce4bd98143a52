/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Replays the committed corpus of the fuzz drivers: inputs that once crashed or are hard to reach, as they are, cut
 * off, and changed in ways that are the same in every run. A broken promise aborts. */
#include "fuzz/fuzz.h"

#include "base/text.h"
#include "scan/format.h"
#include "support.h"
#include <glob.h>

typedef void fuzz_target(const uint8_t *bytes, size_t length);

/* xorshift64*: the same changes on every machine. */
static size_t below(uint64_t *seed, size_t limit)
{
    *seed ^= *seed >> 12;
    *seed ^= *seed << 25;
    *seed ^= *seed >> 27;
    return (size_t)((*seed * 2685821657736338717u >> 16) % limit);
}

/* A stretch of the text: nothing, a byte, a word between blanks and punctuation, or a line with its end. */
static const char *pick(const struct text *text, size_t *length, uint64_t *seed)
{
    static const char *const separators[] = {" \n,:;[]{}\"<>", "\n"};
    size_t kind = below(seed, 4), start = below(seed, text->length + 1), end = start;
    end += kind == 1 && end < text->length ? 1 : 0;
    for (; kind >= 2 && start > 0 && !strchr(separators[kind - 2], text->data[start - 1]); start--)
        ;
    for (; kind >= 2 && end < text->length && !strchr(separators[kind - 2], text->data[end]); end++)
        ;
    *length = end - start + (kind == 3 && end < text->length);
    return text->data + start;
}

/* Puts something else in the place of one stretch: a byte, a number or sign, or another stretch. */
static void change(struct text *text, uint64_t *seed)
{
    static const char *const pieces[] = {"0",    "-1",    "1e999",    "nan", "12", "~",  "same",
                                         "auto", "4 mm2", "10 N",     "&a ", "*a", "- ", ": ",
                                         "\t",   "#",     "\xff\xff", ".",   ",",  "\"", "[1, 2]"};
    size_t length, other_length;
    const char *old = pick(text, &length, seed), *other = pick(text, &other_length, seed);
    const char *piece = pieces[below(seed, sizeof pieces / sizeof *pieces)], byte = (char)below(seed, 256);
    size_t start = (size_t)(old - text->data), how = below(seed, 3);
    struct text changed = {0};
    text_add_bytes(&changed, text->data, start);
    if (how == 0)
        text_add_bytes(&changed, other, other_length);
    else if (how == 1)
        text_add_bytes(&changed, &byte, 1);
    else
        text_add_bytes(&changed, piece, strlen(piece));
    text_add_bytes(&changed, old + length, text->length - start - length);
    text_free(text);
    *text = changed;
}

/* The file as it is, and what becomes of it: a quarter of `versions` cut off, the rest changed. */
static void run(const struct text *bytes, fuzz_target *target, size_t versions)
{
    static uint64_t seed = 20240229;
    const uint8_t *data = (const uint8_t *)text_string(bytes);
    target(data, bytes->length);
    for (size_t k = 1; k < versions / 4; k++)
        target(data, bytes->length * k / (versions / 4));
    for (size_t i = versions / 4; i < versions; i++) {
        OWNED(text_free) struct text text = {0};
        text_add_bytes(&text, text_string(bytes), bytes->length);
        for (size_t changes = 1 + below(&seed, 3); changes > 0 && text.length > 0; changes--)
            change(&text, &seed);
        target((const uint8_t *)text_string(&text), text.length);
    }
}

/* Runs the files of that pattern and returns how many there are. */
static size_t replay(const char *pattern, fuzz_target *target, size_t versions)
{
    glob_t files;
    assert_int_equal(glob(pattern, 0, NULL, &files), 0);
    for (size_t i = 0; i < files.gl_pathc; i++) {
        OWNED(text_free) struct text bytes = {0};
        expect_ok(text_read_file, &bytes, files.gl_pathv[i]);
        fprintf(stderr, "%s\n", strrchr(files.gl_pathv[i], '/') + 1); /* the last of these is the one that aborted */
        run(&bytes, target, versions);
    }
    size_t count = files.gl_pathc;
    globfree(&files);
    return count;
}

#define CORPUS PROJECT_SOURCE "/tests/fuzz/corpus/"

TEST_CASE(test_scan)
{
    assert_true(replay(CORPUS "scan/*/*", fuzz_scan, 80) > 150);
    for (size_t i = 0; i < format_count; i++)
        if (format_rows[i].kind <= FORMAT_PACKED && fuzz_good(format_rows[i].name) == 0)
            fail_msg("no scan of format %s in the corpus: add one", format_rows[i].name);
}

TEST_CASE(test_others)
{
    static const struct {
        const char *name, *counted; /* NULL: not asked */
        fuzz_target *target;
        size_t versions, files, good; /* more than so many */
    } rows[] = {{"scene", "scene", fuzz_scene, 80, 20, 20},
                {"measured", NULL, fuzz_measured, 80, 20, 0},
                {"compare", "compare", fuzz_compare, 80, 1, 0},
                {"template", "template", fuzz_template, 80, 5, 20},
                {"report", "report", fuzz_report, 12, 15, 20}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        assert_true(replay(filled(CORPUS "%s/*", rows[i].name), rows[i].target, rows[i].versions) > rows[i].files);
        if (rows[i].counted && fuzz_good(rows[i].counted) <= rows[i].good)
            fail_msg("the corpus has too few good inputs of %s", rows[i].name);
    }
}
