/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A name that a template fills in is one that it can have: a mistyped one would be filled with nothing, in silence. */
#include "base/words.h"
#include "directory.h"

#include <dirent.h>
#include <stdio.h>

enum { DEPTH = 20, NAME = 80 };

/** Adds what stands in the files of a folder that end so; NULL: in all. */
static void add_folder(struct text *out, const char *folder, const char *ending)
{
    struct dirent **entry;
    int count = scandir(filled("%s/%s", PROJECT_SOURCE, folder), &entry, NULL, alphasort);
    assert_true(count > 0);
    for (int i = 0; i < count; i++) {
        const char *dot = strrchr(entry[i]->d_name, '.');
        if (dot && dot[1] && (!ending || strcmp(dot, ending) == 0))
            expect_ok(text_read_file, out, filled("%s/%s/%s", PROJECT_SOURCE, folder, entry[i]->d_name));
        free(entry[i]);
    }
    free(entry);
}

/** Is `name`, between two marks, in the first `length` characters? */
static bool has(const char *text, size_t length, char mark, const char *name)
{
    const char *found = strstr(text, filled("%c%s%c", mark, name, mark));
    return found && found < text + length;
}

/** Does docs/templates.md name `name` in a row that names what it stands in (`of`; NULL: in one that is of nothing, or
 * as what a row is of)? */
static bool is_listed(const char *document, const char *of, const char *name)
{
    for (const char *row = strstr(document, "\n| where"); (row = strstr(row, "\n| ")); row++) {
        size_t left = (size_t)(strstr(row, " | ") - row), length = strcspn(row + 1, "\n") + 1;
        const char *as = strstr(row, "as in `"), *counted = strstr(row, "as what is counted");
        bool counts = strcmp(name, "count") == 0 || strcmp(name, "one") == 0 || strcmp(name, "surface") == 0;
        char like[NAME];
        if (of ? has(row, length, '`', of) && has(row, length, '`', name)
               : has(row, strchr(row + 1, '`') < row + left ? left : length, '`', name))
            return true;
        if (of && has(row, length, '`', of) && counts && counted && counted < row + length)
            return true;
        if (of && has(row, length, '`', of) && as && as < row + length && sscanf(as, "as in `%79[^`]", like) == 1 &&
            strcmp(like, of) != 0 && is_listed(document, like, name))
            return true;
    }
    return false;
}

/** What a name of a template stands in: the words of the sections around it, the innermost last. */
struct around {
    char words[DEPTH][NAME];
    size_t count;
};

/** Adds the parts of "a.b". */
static void add_words(struct around *around, const char *tag)
{
    for (const char *part = tag; *part; part += part[0] == '.') {
        size_t length = strcspn(part, ".");
        assert_true(around->count < DEPTH);
        snprintf(around->words[around->count++], NAME, "%.*s", (int)length, part);
        part += length;
    }
}

typedef bool known_name(const char *known, const struct around *around, const char *name);

/** Does it say where an item of a list stands? */
static bool is_place(const struct around *around, const char *name)
{
    static const char *const places[] = {"first", "last", "more"};
    for (size_t i = 0; i < sizeof places / sizeof *places && around->count > 0; i++)
        if (strcmp(name, places[i]) == 0)
            return true;
    return false;
}

/** Fails where a template fills in a name that is not `is_known`; `of`: the section that all of it is, or "". Returns
 * how many there are. */
static size_t check_template(const char *file, const char *template, const char *of, const char *known,
                             known_name *is_known)
{
    char open[DEPTH][NAME];
    size_t depth = 0, names = 0;
    for (const char *at = template; (at = strstr(at, "{{")); at += 2) {
        char tag[NAME], kind = at[2];
        if (kind == '/')
            depth--;
        if (strchr("!>/", kind))
            continue;
        assert_int_equal(sscanf(at + 2 + strspn(at + 2, "#^&{ "), "%79[^}| \n]", tag), 1);
        struct around around = {.count = 0}, own = {.count = 0};
        add_words(&around, of);
        for (size_t d = 0; d < depth; d++)
            add_words(&around, open[d]);
        add_words(&own, strcmp(tag, ".") == 0 ? "" : tag);
        for (size_t w = 0; w < own.count; w++, names++) {
            if (!is_place(&around, own.words[w]) && !is_known(known, &around, own.words[w]))
                fail_msg("%s fills in '%s' of '%s', which nothing says", file, own.words[w],
                         around.count > 0 ? around.words[around.count - 1] : "");
            add_words(&around, own.words[w]);
        }
        if (kind == '#' || kind == '^')
            snprintf(open[depth++], NAME, "%s", tag);
        assert_true(depth < DEPTH);
    }
    assert_int_equal(depth, 0);
    return names;
}

/** Is it in docs/templates.md, which test_view holds against the view? */
static bool is_documented(const char *document, const struct around *around, const char *name)
{
    static struct text schema; /* "as results.json has" */
    if (!schema.data)
        expect_ok(text_read_file, &schema, PROJECT_SOURCE "/docs/results.schema.json");
    bool listed = is_listed(document, NULL, name) || has(text_string(&schema), schema.length, '"', name);
    for (size_t w = 0; w < around->count && !listed; w++)
        listed = is_listed(document, around->words[w], name);
    return listed;
}

/** Is it a text of the source, or a line of one up to its first blank? */
static bool is_text(const char *source, const char *name)
{
    size_t length = strlen(name);
    for (const char *at = source; (at = strstr(at, name)); at += length)
        if (at > source + 1 && (at[-1] == '"' || strncmp(at - 2, "\\n", 2) == 0) && strchr("\" \\%", at[length]))
            return true;
    return false;
}

/** Does the program say it, as a text of its source; or as a parameter of `inspect` behind its P or R? */
static bool is_in_source(const char *source, const struct around *around, const char *name)
{
    bool parameter = around->count > 0 && strcmp(around->words[0], "parameters") == 0 && strchr("PR", *name);
    return is_text(source, name) ||
           (parameter && (is_text(source, name + 1) || is_text(source, filled("%%c%s", name + 1))));
}

TEST_CASE(templates_of_the_report_fill_in_documented_names)
{
    static const char *const folders[][3] = {{"templates", ".md", ""}, {"templates/export", NULL, "exports"}};
    const char *document = directory_read(PROJECT_SOURCE, "docs/templates.md"),
               *terminal = directory_read(PROJECT_SOURCE, "templates/terminal.txt");
    size_t names = check_template("terminal.txt", terminal, "", document, is_documented);
    for (size_t f = 0; f < sizeof folders / sizeof *folders; f++) {
        struct text *all = support_text();
        add_folder(all, folders[f][0], folders[f][1]);
        names += check_template(folders[f][0], text_string(all), folders[f][2], document, is_documented);
    }
    assert_true(names > 800);
}

/** A line of a template can be read in an editor. */
TEST_CASE(lines_of_templates_are_short)
{
    static const char *const folders[] = {"templates", "templates/charts", "templates/export"};
    struct text *all = support_text();
    for (size_t f = 0; f < sizeof folders / sizeof *folders; f++)
        add_folder(all, folders[f], NULL);
    for (char *line = strtok(all->data, "\n"); line; line = strtok(NULL, "\n"))
        if (text_characters(line) > 400)
            fail_msg("%d characters: %.60s", text_characters(line), line);
}

/* Each by what makes its view: a name that only another template has is as mistyped as one that none has. */
TEST_CASE(other_templates_fill_in_what_the_program_says)
{
    static const struct {
        const char *file, *of[12]; /* folders end in "/" */
    } templates[] = {{"compare.txt", {"src/report/report_compare.c", "src/report/view.c"}},
                     {"inspect.txt", {"src/cli/inspection.c", "src/output/record.c", "src/spectrum/parameters.c"}},
                     {"words.txt",
                      {"src/chart/", "src/report/", "src/results/", "src/scene/", "src/plan/", "src/run/",
                       "src/members/", "src/answers/", "src/claims/", "src/cli/"}},
                     {"scene.yaml", {"src/cli/cmd_init.c"}},
                     {"page.html", {"src/report/html.c"}},
                     {"charts/letters.gp", {"src/chart/"}},
                     {"charts/panels.gp", {"src/chart/"}},
                     {"charts/style.gp", {"src/chart/"}}};
    size_t names = 0;
    for (size_t f = 0; f < sizeof templates / sizeof *templates; f++) {
        struct text *source = support_text();
        char *template = directory_read(PROJECT_SOURCE, filled("templates/%s", templates[f].file));
        char *comment = strstr(template, "{{names}}"); /* of words.txt, on names */
        for (const char *const *of = templates[f].of; *of; of++) {
            if ((*of)[strlen(*of) - 1] == '/')
                add_folder(source, *of, ".c");
            else
                expect_ok(text_read_file, source, filled("%s/%s", PROJECT_SOURCE, *of));
        }
        if (comment)
            memcpy(comment, "(names)", 7), memset(comment + 7, ' ', 2);
        names += check_template(templates[f].file, template, "", text_string(source), is_in_source);
    }
    assert_true(names > 150);
}

/** What asks for words. */
static struct text *asking_sources(void)
{
    static const char *const folders[] = {"src/chart",   "src/report",  "src/cli",   "src/results",
                                          "src/contact", "src/scene",   "src/plan",  "src/run",
                                          "src/members", "src/answers", "src/claims"};
    struct text *source = support_text();
    for (size_t f = 0; f < sizeof folders / sizeof *folders; f++)
        add_folder(source, folders[f], ".c");
    return source;
}

/** Is a name that is put together of parts, "load-is-interval", asked for part by part? */
static bool parts_are_asked(const char *source, const char *parts)
{
    for (size_t length; (length = strcspn(parts, "-")) > 0; parts += length + (parts[length] == '-'))
        if (!is_text(source, filled("%.*s", (int)length, parts)) &&
            !is_text(source, filled("-%.*s", (int)length, parts)))
            return false;
    return true;
}

/** Every line of words.txt is asked for: whole, or as the words of a kind ("axis.%s") and of a row's name. */
TEST_CASE(words_are_asked_for)
{
    char *words = directory_read(PROJECT_SOURCE, "templates/words.txt");
    const char *source = text_string(asking_sources());
    size_t lines = 0;
    for (char *line = strtok(words, "\n"); line; line = strtok(NULL, "\n")) {
        char name[NAME], kind[NAME], *dot;
        if (line[0] == '#')
            continue;
        assert_int_equal(sscanf(line, "%79s", name), 1);
        snprintf(kind, sizeof kind, "%s", name);
        bool asked = is_text(source, name) || strncmp(name, "6-", 2) == 0 ||
                     (strncmp(name, "headline.", 9) == 0 && parts_are_asked(source, name + 9));
        if (!asked && (dot = strrchr(kind, '.'))) {
            asked = is_text(source, name + (dot + 1 - kind));
            snprintf(dot, 4, ".%%s");
            asked = asked && (strstr(source, filled("\"%s", kind)) ||
                              strstr(source, filled("source, \"%.*s\"", (int)(dot - kind), kind)));
        }
        if (!asked)
            fail_msg("words.txt has '%s', which nothing asks for", name);
        lines++;
    }
    assert_true(lines > 110);
}

/** Fails where a text "name\na %d\n..." of a source tells what its line of words.txt does not fill in. */
static void check_told(const char *text, const char *line)
{
    const char *end = strchr(text, '"'), *line_end = strchr(line + 1, '\n');
    for (const char *at = text; (at = strstr(at, "\\n")) && at < end;) {
        at += 2;
        int length = (int)strspn(at, "abcdefghijklmnopqrstuvwxyz_");
        const char *found = length > 0 ? line : NULL; /* else what stands there is a text of its own */
        while (found && (found = strstr(found + 1, filled("%.*s}}", length, at))) && found < line_end &&
               !strchr("{#^", found[-1]))
            ;
        if (length > 0 && (!found || found > line_end))
            fail_msg("'%.*s' is told, which %.40s does not say", length, at, line + 1);
    }
}

/** And what is asked for by its whole is there: a text that begins as the words of a kind do. */
TEST_CASE(what_is_asked_for_has_words)
{
    const char *all = directory_read(PROJECT_SOURCE, "templates/words.txt");
    size_t names = 0;
    for (const char *at = text_string(asking_sources()); (at = strchr(at, '"')); at++) {
        const char *name = at + 1;
        int length = (int)strspn(name, "abcdefghijklmnopqrstuvwxyz_."), kind = (int)strcspn(name, ".");
        if (kind + 1 >= length || !strchr("\"\\%", name[length]) || name[length - 1] == '.' ||
            !strstr(all, filled("\n%.*s.", kind, name)))
            continue;
        const char *line = strstr(all, filled("\n%.*s ", length, name));
        if (line)
            check_told(name, line);
        else if (!strstr(all, filled("\n%.*s.", length, name))) /* which is a kind itself */
            fail_msg("words.txt has no '%.*s'", length, name);
        names++;
    }
    assert_true(names > 95);
}
