/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The reports in docs/sample and the README's are those that the program writes today: words to the byte, numbers to
 * one unit of their last printed digit, times aside. surfaces/make.sh makes them again. */
#include "cli/process.h"

#include <ctype.h>

/** Bytes of a time at `at`, "12 ms", with whatever blank stands between; 0: there is none. */
static size_t time_at(const char *at)
{
    static const char *const units[] = {"ms", "s", "min"};
    size_t length = strspn(at, "0123456789.");
    if (length == 0)
        return 0;
    length += strncmp(at + length, "\u00a0", 2) == 0 ? 2 : at[length] == ' ';
    for (size_t u = 0; u < sizeof units / sizeof *units; u++) {
        size_t more = strlen(units[u]);
        if (strncmp(at + length, units[u], more) == 0 && !isalnum((unsigned char)at[length + more]))
            return length + more;
    }
    return 0;
}

/** Reads a number: *unit is one of its last digit. 0 bytes: there is none. */
static size_t number_at(const char *at, double *value, double *unit)
{
    size_t whole = strspn(at, "0123456789"), decimals = 0;
    if (whole == 0)
        return 0;
    if (at[whole] == '.')
        decimals = strspn(at + whole + 1, "0123456789");
    *value = strtod(at, NULL);
    *unit = pow(10, -(double)decimals);
    if (decimals == 0) /* zeros at the end may be rounded ones: of three digits, or two */
        for (size_t i = whole; i-- > 2 && at[i] == '0';)
            *unit *= 10;
    return whole + (decimals > 0 ? decimals + 1 : 0);
}

/** Fails where two texts differ otherwise than in times and by one unit of a number's last digit. */
static void expect_alike(const char *kept, const char *fresh, const char *what)
{
    const char *a = kept, *b = fresh;
    while (*a || *b) {
        double x = 0, y = 0, units[2] = {0};
        size_t time = time_at(a), other = time_at(b), first = number_at(a, &x, &units[0]),
               second = number_at(b, &y, &units[1]);
        if (time > 0 && other > 0) {
            a += time;
            b += other;
        } else if (first > 0 && second > 0 && fabs(x - y) <= 1.01 * fmax(units[0], units[1])) {
            a += first;
            b += second;
        } else if (*a == *b) {
            a++;
            b++;
        } else
            fail_msg("%s: '%.60s' is kept, '%.60s' is written today; see surfaces/make.sh", what, a, b);
    }
}

/** The text of a picture, without its tags. */
static char *words_of(char *svg)
{
    char *to = svg;
    bool mark = false;
    for (const char *at = strstr(svg, "<desc>") ? strstr(svg, "</desc>") : svg; *at; at++) {
        mark = mark || *at == '<';
        if (!mark)
            *to++ = *at;
        mark = mark && *at != '>';
    }
    *to = '\0';
    return svg;
}

/** A report but for the sentence and table of times: which of two models is the faster may change. */
static char *without_times(char *report)
{
    char *from = strstr(report, "**What accuracy costs"), *to = from ? strstr(from, "\n\n**What ran") : NULL;
    assert_non_null(to);
    memmove(from, to, strlen(to) + 1);
    return report;
}

static char *view_without_times(char *text)
{
    json_t *view = support_json(text);
    json_object_del(view, "accuracy");
    return test_owns(json_dumps(view, JSON_INDENT(1)), free);
}

static void expect_sample(const char *place, const char *name)
{
    struct process run = expect_exit(place, 0, "report", filled(PROJECT_SOURCE "/surfaces/%s", name), "-o", "o");
    char *readme = workspace_read(PROJECT_SOURCE, "README.md"), *end = strstr(run.out, "\n\no/report.html");
    assert_non_null(end); /* the README has all that the terminal shows of two, but where the report is */
    *end = '\0';
    char *pasted = strstr(readme, filled("build/bin/roughcontact report surfaces/%s", name));
    assert_non_null(pasted);
    if (strcmp(name, "lapped-map") != 0) {
        pasted = strstr(pasted, "```text\n") + strlen("```text\n");
        *strstr(pasted, "\n```") = '\0';
        expect_alike(pasted, run.out, filled("README.md, %s", name));
    }
    static const char *const files[] = {"report.md", "view.json"};
    for (int f = 0; f < 2; f++) {
        char *(*cut)(char *) = f == 0 ? without_times : view_without_times;
        const char *kept = lasting("docs/sample/%s/%s", name, files[f]);
        expect_alike(cut(workspace_read(PROJECT_SOURCE, kept)), cut(workspace_read(place, filled("o/%s", files[f]))),
                     kept);
    }
    char *list = workspace_shell(place, "cd o/figures && ls *.svg"), *rest = list;
    for (char *file; (file = strsep(&rest, "\n")) && *file;) {
        if (strcmp(file, "accuracy.svg") == 0) /* its axis is of times */
            continue;
        const char *kept = lasting("docs/sample/%s/figures/%s", name, file);
        expect_alike(words_of(workspace_read(PROJECT_SOURCE, kept)),
                     words_of(workspace_read(place, filled("o/figures/%s", file))), kept);
    }
}

TEST_IN_WORKSPACE(chapter6_is_the_sample)
{
    expect_sample(place, "chapter6");
}

TEST_IN_WORKSPACE(the_map_is_the_sample)
{
    expect_sample(place, "lapped-map");
}

TEST_IN_WORKSPACE(the_connector_is_the_sample)
{
    expect_sample(place, "connector");
}
