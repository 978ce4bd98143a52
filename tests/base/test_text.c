/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/text.h"
#include "support.h"

#include <ctype.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

TEST_CASE(test_an_unused_text_is_an_empty_string)
{
    struct text text = {0};
    assert_string_equal(text_string(&text), "");
    text_free(&text);
    text_add_bytes(&text, NULL, 0);
    assert_string_equal(text_string(&text), "");
    assert_int_equal(text.length, 0);
    text_free(&text);
}

TEST_CASE(test_a_text_grows_and_keeps_every_byte)
{
    struct text *text = support_text();
    char expected[6 * 3000 + 1];
    for (int i = 0; i < 3000; i++) {
        text_add(text, "%05d;", i);
        snprintf(expected + 6 * i, 7, "%05d;", i);
    }
    assert_int_equal(text->length, strlen(expected));
    assert_string_equal(text_string(text), expected);
    assert_true(text->capacity > text->length);
    assert_false(text->failed);
    text_add_bytes(text, "a\0b", 3);
    assert_memory_equal(text->data + text->length - 3, "a\0b", 4);
    text_free(text);
    assert_null(text->data);
    assert_int_equal(text->length, 0);
}

TEST_CASE(test_more_than_memory_fails_and_stays_failed)
{
    struct text text = {0};
    text_add(&text, "kept");
    text_add_bytes(&text, "", SIZE_MAX / 2); /* no byte of it is read: there is no such room */
    assert_true(text.failed);
    text_add(&text, "dropped");
    assert_string_equal(text_string(&text), "kept");
    text_free(&text);
    text_add_bytes(&text, "", SIZE_MAX - 4);
    assert_true(text.failed);
    text_free(&text);
}

/* As a name from outside comes into Markdown. */
static void add_markdown(struct text *text, const char *string)
{
    struct text *shown = support_text();
    text_add_shown(shown, string);
    text_add_markdown_shown(text, text_string(shown));
}

/* Every ASCII punctuation mark with a meaning in Markdown or HTML is escaped at a beginning; the rest is left alone. */
TEST_CASE(test_markdown)
{
    struct text text = {0};
    add_markdown(&text, "a|b*c_d`e\\f[g](h)#i<j>&\"k\"\n\t\x7f"
                        "Rq µm");
    assert_string_equal(text_string(&text),
                        "a\\|b\\*c_d\\`e\\\\f\\[g\\](h)\\#i&#60;j&#62;&#38;&#34;k&#34;\\\\x0a\\\\x09\\\\x7fRq µm");
    text_free(&text);
    for (int c = 1; c < 128; c++) {
        char string[2] = {(char)c, '\0'};
        add_markdown(&text, string);
        if (isalnum(c) || c == ' ')
            assert_string_equal(text_string(&text), string);
        else if (iscntrl(c)) {
            assert_string_equal(text_string(&text), filled("\\\\x%02x", (unsigned)c));
        } else if (strchr("<>&\"", c))
            assert_true(strncmp(text_string(&text), "&#", 2) == 0);
        else if (strchr("*_`[])#|\\~$-+=.", c))
            assert_true(text.length == 2 && text.data[0] == '\\' && text.data[1] == c);
        text_free(&text);
    }
}

/* Reads a CSV field back as RFC 4180 has it. */
static void unquote(char *out, const char *field)
{
    if (*field != '"') {
        strcpy(out, field);
        return;
    }
    for (field++; *field; field++) {
        if (*field == '"') {
            field++;
            if (*field != '"') {
                assert_int_equal(*field, '\0');
                break;
            }
        }
        *out++ = *field;
    }
    *out = '\0';
}

TEST_CASE(test_csv)
{
    static const char *const fields[][2] = {
        {"", ""},           {"plain text", "plain text"},       {"a;b", "\"a;b\""}, {"a;-1", "\"a;-1\""},
        {"a,b", "\"a,b\""}, {"say \"x\"", "\"say \"\"x\"\"\""}, {"\"", "\"\"\"\""}, {",\",\"", "\",\"\",\"\"\""},
    };
    struct text *behind = support_text(); /* where semicolons delimit, the cell is cut there, whatever is around it */
    text_add_csv(behind, "a;=HYPERLINK(1)");
    assert_string_equal(text_string(behind), "\"a;'=HYPERLINK(1)\"");
    for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
        struct text *text = support_text();
        char back[64];
        text_add_csv(text, fields[i][0]);
        assert_string_equal(text_string(text), fields[i][1]);
        unquote(back, text_string(text));
        assert_string_equal(back, fields[i][0]);
    }
}

/* Hidden characters are written out, and text that looks like that is escaped. In Markdown, what begins a list, a link
 * or emphasis is escaped, and nothing else. */
TEST_CASE(test_what_means_something_is_escaped)
{
    static const struct {
        void (*add)(struct text *text, const char *string);
        const char *string, *expected;
    } cases[] = {
        {text_add_shown, "Rq µm 粗さ 😀 é", "Rq µm 粗さ 😀 é"},
        {text_add_shown, "\033[31m\a\t\r\n\x7f", "\\x1b[31m\\x07\\x09\\x0d\\x0a\\x7f"},
        {text_add_shown, "\xc2\x9b \xc2\xad \u061c \u200e \u202e \u2066 \u200b \u200d \u2028 \ufeff",
         "\\u009b \\u00ad \\u061c \\u200e \\u202e \\u2066 \\u200b \\u200d \\u2028 \\ufeff"},
        {text_add_shown, "\U000e0041 \uffff \ufdd0 \U0010ffff", "\\U000e0041 \\uffff \\ufdd0 \\U0010ffff"},
        {text_add_shown, "\xff \x80 \xc3 \xc0\xaf \xed\xa0\x80 \xf4\x90\x80\x80",
         "\\xff \\x80 \\xc3 \\xc0\\xaf \\xed\\xa0\\x80 \\xf4\\x90\\x80\\x80"},
        {text_add_shown, "a\\b C:\\dir \\", "a\\b C:\\dir \\"},
        {text_add_shown, "\\x1b \\u202e \\U \\\\ \\\033", "\\\\x1b \\\\u202e \\\\U \\\\\\ \\\\\\x1b"},
        {add_markdown, "surface-1.csv", "surface-1.csv"},
        {add_markdown, "fit_band_m (0.5 um)", "fit_band_m (0.5 um)"},
        {add_markdown, "- item", "\\- item"},
        {add_markdown, "12. item", "12\\. item"},
        {add_markdown, "3) item", "3\\) item"},
        {add_markdown, "# title", "\\# title"},
        {add_markdown, "_a_ __b__", "\\_a\\_ \\_\\_b\\_\\_"},
        {add_markdown, "*a* `b` ~c~", "\\*a\\* \\`b\\` \\~c\\~"},
        {add_markdown, "[x](y)", "\\[x\\](y)"},
        {add_markdown, "![x](y)", "!\\[x\\](y)"},
        {add_markdown, "a|b", "a\\|b"},
        {add_markdown, "a\\b", "a\\\\b"},
        {add_markdown, "http://x", "http\\://x"},
        {add_markdown, "<b>&\"", "&#60;b&#62;&#38;&#34;"},
        {add_markdown, "---", "\\-\\-\\-"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct text *text = support_text();
        cases[i].add(text, cases[i].string);
        assert_string_equal(text_string(text), cases[i].expected);
    }
}

/* No two of all texts of three of these are shown alike: backslashes, letters of the notation, hidden characters. */
TEST_CASE(test_different_texts_are_shown_differently)
{
    static const char *const parts[] = {"", "\\", "x", "1b", "u", "202e", "\033", "\u202e", "\xff"};
    enum { PARTS = sizeof parts / sizeof *parts, ALL = PARTS * PARTS * PARTS };
    char raw[ALL][16];
    struct text *shown[ALL];
    for (size_t i = 0; i < ALL; i++) {
        snprintf(raw[i], sizeof raw[i], "%s%s%s", parts[i % PARTS], parts[i / PARTS % PARTS], parts[i / PARTS / PARTS]);
        text_add_shown(shown[i] = support_text(), raw[i]);
        for (size_t k = 0; k < i; k++)
            if ((strcmp(raw[i], raw[k]) == 0) != (strcmp(text_string(shown[i]), text_string(shown[k])) == 0))
                fail_msg("'%s' and another are both shown as '%s'", raw[i], text_string(shown[i]));
    }
}

/** Does the field of this text begin with an apostrophe more? */
static bool is_guarded(const char *string)
{
    struct text *field = support_text();
    text_add_csv(field, string);
    return strlen(text_string(field)) == strlen(string) + 1;
}

TEST_CASE(test_formulas)
{
    static const char *const formulas[] = {"=1+2",   "+a",      "-b",      "@c",      " =d",    "'=e",
                                           "''+f",   "-",       "--1",     "-1.5 um", "+1e",    "-inf",
                                           "-0x1p3", "\uFF1D1", "\uFF0B1", "\uFF0D1", "\uFF201"};
    static const char *const texts[] = {"", "a=b", "-1.5", "+2e3", "-.5", "it's", "'quoted'", "1-2", "−1"};
    for (size_t i = 0; i < sizeof formulas / sizeof *formulas; i++)
        assert_true(is_guarded(formulas[i]));
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        assert_int_equal(is_guarded(texts[i]), 0);
}

TEST_CASE(test_a_cut_keeps_characters_whole)
{
    assert_int_equal(text_fit("abc", 5), 3);
    assert_int_equal(text_fit("abc", 3), 3);
    assert_int_equal(text_fit("abc", 2), 2);
    assert_int_equal(text_fit("aµc", 2), 1);
    assert_int_equal(text_fit("😀", 3), 0);
    assert_int_equal(text_fit("a😀", 5), 5);
}

/* The time of a line does not grow with the text before it; else this takes longer than a test may. */
TEST_CASE(test_many_lines_are_wrapped)
{
    enum { LINES = 1000000 };
    static const char line[] = "one_long_word_of_a_line_of_a_table\n"; /* one: sanitizers count each piece */
    struct text text = {0};
    for (size_t i = 0; i < LINES; i++)
        text_add_wrapped(&text, line, 80, 0);
    assert_int_equal(text.length, LINES * (sizeof line - 1));
    text_free(&text);
    text_add(&text, "\nthree of "); /* from where the line begins that stands there */
    text_add_wrapped(&text, "them go over", 14, 2);
    assert_string_equal(text_string(&text), "\nthree of them\n  go over");
    text_free(&text);
}

TEST_CASE(test_files_come_back_byte_for_byte)
{
    enum { LENGTH = 300001 };
    const char *temporary = getenv("TMPDIR");
    char path[256], *bytes = support_room(LENGTH);
    snprintf(path, sizeof path, "%s/roughcontact-text-XXXXXX", temporary ? temporary : P_tmpdir);
    close(mkstemp(path));
    for (size_t i = 0; i < LENGTH; i++)
        bytes[i] = (char)(i * i % 251); /* with NULs */
    for (size_t length = 0; length <= LENGTH; length += LENGTH) {
        struct text *text = support_text();
        expect_ok(text_write_file, path, bytes, length);
        expect_ok(text_read_file, text, path);
        assert_int_equal(text->length, length);
        assert_memory_equal(text_string(text), bytes, length);
        assert_int_equal(text->data[length], '\0');
    }
    unlink(path);
}

static void assert_unreadable(const char *path, const char *reason)
{
    expect_fails(STATUS_IO, path, text_read_file, support_text(), path);
    expect_fails(STATUS_IO, reason, text_read_file, support_text(), path);
}

TEST_CASE(test_what_cannot_be_read_is_named)
{
    assert_unreadable("/no such directory/scan.csv", "No such file");
    assert_unreadable("/", "directory");     /* where seeking to the end gives an absurd size */
    assert_unreadable("/proc", "directory"); /* and where it fails */
    assert_unreadable("/dev/null", "no regular file");
}

TEST_CASE(test_what_cannot_be_written_is_named)
{
    char lots[100000] = {0};
    expect_fails(STATUS_IO, "/no such directory/x", text_write_file, "/no such directory/x", "a", 1);
    for (size_t length = 1; length <= sizeof lots; length += sizeof lots - 1) /* noticed at the end, or on the way */
        expect_fails(STATUS_IO, "No space", text_write_file, "/dev/full", lots, length);
}
