/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The documents against the program: what they name exists, and what exists is named. */
#include "base/limits.h"
#include "base/text.h"
#include "contact/model.h"
#include "directory.h"
#include "material/material.h"
#include "scan/format.h"
#include "scan/scan.h"

#include <fnmatch.h>
#include <fts.h>
#include <glob.h>
#include <stdio.h>
#include <unistd.h>

enum { NAME = 96, EQUATIONS = 55, ROOMS = 32, NAMES_MOST = 16 };

static const char *const documents[] = {"README.md",        "docs/equations.md",    "docs/formats.md",
                                        "docs/report.md",   "docs/CONTRIBUTING.md", "docs/tutorial.md",
                                        "docs/commands.md", "docs/limits.md"};

/** A file of the project as text. */
static char *read_document(const char *path)
{
    return directory_read(PROJECT_SOURCE, path);
}

static bool is_word_char(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/** Where `word` stands next as a whole word, from `at` to `end` (NULL: the end of the text). */
static const char *find_word(const char *at, const char *end, const char *word)
{
    size_t length = strlen(word);
    for (const char *start = at; (at = strstr(at, word)) && (!end || at + length <= end); at++)
        if ((at == start || !is_word_char(at[-1])) && !is_word_char(at[length]))
            return at;
    return NULL;
}

/** Has the source a function or a value called `name` at the outermost level? */
static bool defines(const char *source, const char *name)
{
    for (const char *at = source; (at = find_word(at, NULL, name)); at++) {
        const char *line = at;
        while (line > source && line[-1] != '\n')
            line--;
        if ((is_word_char(*line) || *line == '}') && strchr("([ ;)", at[strlen(name)]))
            return true;
    }
    return false;
}

/** The text between two spans, blanks and line ends as one blank each. */
static void normalise(char out[NAME], const char *start, const char *end)
{
    size_t used = 0;
    for (; start < end && used + 1 < NAME; start++) {
        bool blank = *start == ' ' || *start == '\n';
        if (!blank)
            out[used++] = *start;
        else if (used == 0 || out[used - 1] != ' ')
            out[used++] = ' ';
    }
    out[used] = '\0';
}

struct span {
    const char *start, *end;
};

/** The next text between backticks, without them. */
static bool next_span(struct span *out, const char *at)
{
    const char *open = strchr(at, '`'), *close = open ? strchr(open + 1, '`') : NULL;
    if (!close)
        return false;
    *out = (struct span){open + 1, close};
    return true;
}

/** Which equations (4.n) of the thesis the first cell of the table row at `at` names; starred[n]: with a star, which
 * marks an erratum. */
static void row_numbers(const char *text, const char *at, bool there[EQUATIONS + 1], bool starred[EQUATIONS + 1])
{
    while (at > text && at[-1] != '\n')
        at--;
    const char *end = *at == '|' ? strchr(at + 1, '|') : at;
    for (int n = 1; n <= EQUATIONS; n++) {
        char number[16];
        snprintf(number, sizeof number, "4.%d", n);
        const char *found = find_word(at, end, number);
        there[n] = found;
        starred[n] = found && found[strlen(number)] == '*';
    }
}

/** Does the file define the name, and have it or its header the equation numbers of the row at `at`? */
static void check_place(const char *text, const char *at, const char *name, const char *path)
{
    bool there[EQUATIONS + 1], starred[EQUATIONS + 1];
    char header_path[NAME], number[16], *source = read_document(path);
    if (!defines(source, name))
        fail_msg("%s has no %s", path, name);
    row_numbers(text, at, there, starred);
    snprintf(header_path, sizeof header_path, "%.*sh", (int)strlen(path) - 1, path);
    for (int n = 1; n <= EQUATIONS; n++) {
        snprintf(number, sizeof number, "4.%d", n);
        if (!there[n] || find_word(source, NULL, number))
            continue;
        char *header = read_document(header_path);
        if (!find_word(header, NULL, number))
            fail_msg("%s in %s does not carry the number %s", name, path, number);
    }
}

/** Checks every `name` in `src/...` of a document, and returns how many there are. */
static size_t check_places(const char *text)
{
    char names[NAMES_MOST][NAME], between[NAME], word[NAME];
    size_t pending = 0, places = 0;
    struct span span;
    const char *at = text;
    for (; next_span(&span, at); at = span.end + 1) {
        normalise(between, at, span.start - 1);
        size_t length = (size_t)(span.end - span.start);
        if (length >= NAME ||
            (strcmp(between, ", ") != 0 && strcmp(between, " and ") != 0 && strcmp(between, " in ") != 0))
            pending = 0;
        if (length >= NAME)
            continue;
        memcpy(word, span.start, length);
        word[length] = '\0';
        if (strncmp(word, "src/", 4) != 0) {
            assert_true(pending < NAMES_MOST);
            memcpy(names[pending++], word, length + 1);
            continue;
        }
        for (size_t i = 0; i < pending && strcmp(between, " in ") == 0; i++, places++)
            check_place(text, span.start, names[i], word);
        pending = 0;
    }
    return places;
}

TEST_CASE(places_exist)
{
    size_t places = 0;
    for (size_t d = 0; d < sizeof documents / sizeof *documents; d++)
        places += check_places(read_document(documents[d]));
    assert_true(places > 80); /* else the search is broken */
}

/** Every equation of the thesis has a row; those with a star, and no others, have an erratum. */
TEST_CASE(equations_are_complete)
{
    char *text = read_document("docs/equations.md"), *errata = strstr(text, "\n## Errata");
    bool placed[EQUATIONS + 1] = {false}, corrected[EQUATIONS + 1] = {false}, listed[EQUATIONS + 1] = {false};
    assert_non_null(errata);
    for (const char *line = text; line; line = strchr(line, '\n') ? strchr(line, '\n') + 1 : NULL) {
        bool there[EQUATIONS + 1], starred[EQUATIONS + 1];
        const char *end = strchr(line, '\n') ? strchr(line, '\n') : line + strlen(line), *place = strstr(line, "`src/");
        const char *aside = strstr(line, "(text)");
        row_numbers(text, line, there, starred);
        for (int n = 1; n <= EQUATIONS; n++) {
            placed[n] = placed[n] || (there[n] && place && place < end);
            corrected[n] = corrected[n] || starred[n];
            listed[n] = listed[n] || (there[n] && line > errata && !(aside && aside < end));
        }
    }
    for (int n = 1; n <= EQUATIONS; n++) {
        if (!placed[n])
            fail_msg("no row of docs/equations.md says where (4.%d) is", n);
        if (corrected[n] != listed[n])
            fail_msg("(4.%d) %s", n, listed[n] ? "has an erratum but no star" : "has a star but no erratum");
    }
}

static void expect_there(const char *document, const char *folder, const char *target, size_t length)
{
    if (access(filled("%s/%s%.*s", PROJECT_SOURCE, folder, (int)length, target), R_OK) != 0)
        fail_msg("%s names %.*s, which is not there", document, (int)length, target);
}

/** Files and folders that the documents name, and links from one to another. */
TEST_CASE(paths_exist)
{
    static const char *const folders[] = {"src/", "tests/", "templates/", "docs/", "surfaces/"};
    size_t paths = 0, links = 0;
    for (size_t d = 0; d < sizeof documents / sizeof *documents; d++) {
        char *text = read_document(documents[d]), folder[NAME] = "";
        const char *slash = strrchr(documents[d], '/');
        struct span span;
        for (const char *at = text; next_span(&span, at); at = span.end + 1) {
            size_t length = (size_t)(span.end - span.start);
            bool ours = false, pattern = strcspn(span.start, "<*{") < length;
            for (size_t f = 0; f < sizeof folders / sizeof *folders; f++)
                ours = ours || strncmp(span.start, folders[f], strlen(folders[f])) == 0;
            if (!ours || pattern)
                continue;
            expect_there(documents[d], "", span.start, length);
            paths++;
        }
        snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash + 1 - documents[d]) : 0, documents[d]);
        for (const char *at = text; (at = strstr(at, "](")); at++) {
            size_t length = strcspn(at + 2, ")#");
            if (length == 0 || strncmp(at + 2, "http", 4) == 0)
                continue;
            expect_there(documents[d], folder, at + 2, length);
            links++;
        }
    }
    assert_true(paths > 100 && links > 5);
}

/** Fails unless `document` names `name` between backticks. */
static void expect_named(const char *document, const char *text, const char *name)
{
    if (!strstr(text, filled("`%s`", name)))
        fail_msg("%s does not name %s", document, name);
}

TEST_CASE(tables_are_described)
{
    char *laws = read_document("docs/equations.md"), *formats = read_document("docs/formats.md");
    char *report = read_document("docs/report.md");
    for (size_t m = 0; m < model_count; m++)
        expect_named("docs/equations.md", laws, model_rows[m]->name);
    for (size_t i = 0; i < format_count; i++)
        if (format_rows[i].kind <= FORMAT_PACKED)
            expect_named("docs/formats.md", formats, format_rows[i].name);
    for (int q = 0; q < QUANTITY_COUNT; q++)
        expect_named("docs/report.md", report, q == QUANTITY_LOAD ? "load_over_AnEp" : quantity_rows[q].name);
    for (size_t p = 0; p < material_property_count; p++)
        expect_named("docs/report.md", report, material_properties[p].key);
}

/** docs/limits.md has the rows of the table, all of them, in order, and no others. */
TEST_CASE(limits_are_stated)
{
    char *text = read_document("docs/limits.md"), *line = strstr(text, "|---|");
    assert_non_null(line);
    line = strchr(line, '\n') + 1;
    for (size_t i = 0; i < LIMIT_COUNT; i++) {
        const struct limit_row *row = &limit_rows[i];
        char expected[512];
        snprintf(expected, sizeof expected, "| `%s` | %zu %s | %s | %s |\n", row->name, row->most, row->unit,
                 row->meaning, row->remedy);
        if (strncmp(line, expected, strlen(expected)) != 0)
            fail_msg("docs/limits.md should have here:\n%sbut has:\n%.200s", expected, line);
        line += strlen(expected);
    }
    assert_int_equal(*line, '\n');
}

/** The rooms of src/ as docs/CONTRIBUTING.md orders them, which the README repeats. */
struct rooms {
    char name[ROOMS][NAME];
    size_t count;
};

static struct rooms read_rooms(const char *document)
{
    struct rooms rooms = {.count = 0};
    char *text = read_document(document), *line = strstr(text, "\n    base → ");
    if (!line)
        fail_msg("%s has no order of rooms", document);
    line[1 + strcspn(line + 1, "\n")] = '\0';
    char *rest = line;
    for (char *word; (word = strsep(&rest, " \n"));)
        if (*word >= 'a' && *word <= 'z') {
            assert_true(rooms.count < ROOMS);
            snprintf(rooms.name[rooms.count++], NAME, "%s", word);
        }
    return rooms;
}

static size_t room_index(const struct rooms *rooms, const char *name, size_t length)
{
    size_t i = 0;
    while (i < rooms->count && (strlen(rooms->name[i]) != length || strncmp(rooms->name[i], name, length) != 0))
        i++;
    return i;
}

/** Is it a file that can hold a comment? */
static bool takes_comments(const char *name)
{
    static const char *const patterns[] = {"*.[ch]", "*.cmake", "*.md",          "*.html", "*.py",
                                           "*.sh",   "*.yaml",  "*.map",         "*.1",    "*.pc.in",
                                           "*.bash", "*.dict",  "CMakeLists.txt"};
    bool takes = false;
    for (size_t i = 0; i < sizeof patterns / sizeof *patterns; i++)
        takes = takes || fnmatch(patterns[i], name, 0) == 0;
    return takes;
}

/** Every file begins with its licence, apart from the data of tests. */
TEST_CASE(licences_are_named)
{
    static char places[][sizeof PROJECT_SOURCE + 32] = {
        PROJECT_SOURCE "/README.md", PROJECT_SOURCE "/CMakeLists.txt", PROJECT_SOURCE "/cmake",
        PROJECT_SOURCE "/docs",      PROJECT_SOURCE "/examples",       PROJECT_SOURCE "/src",
        PROJECT_SOURCE "/surfaces",  PROJECT_SOURCE "/templates",      PROJECT_SOURCE "/tests"};
    char *paths[sizeof places / sizeof *places + 1] = {NULL};
    for (size_t i = 0; i < sizeof places / sizeof *places; i++)
        paths[i] = places[i];
    FTS *tree = fts_open(paths, FTS_PHYSICAL | FTS_NOCHDIR, NULL);
    assert_non_null(tree);
    size_t files = 0;
    for (FTSENT *entry; (entry = fts_read(tree));) {
        const char *path = entry->fts_path + sizeof PROJECT_SOURCE;
        if (entry->fts_info == FTS_D && (strcmp(path, "tests/data") == 0 || strcmp(path, "tests/fuzz/corpus") == 0 ||
                                         strcmp(path, "docs/sample") == 0)) /* what the program writes */
            fts_set(tree, entry, FTS_SKIP);
        if (entry->fts_info != FTS_F || !takes_comments(entry->fts_name))
            continue;
        char *text = read_document(path), *named = strstr(text, "SPDX-License-Identifier: GPL-3.0-or-later");
        if (!named || named - text > 64)
            fail_msg("%s does not begin with its SPDX-License-Identifier", path);
        files++;
    }
    fts_close(tree);
    assert_true(files > 500);
}

static void check_includes(const struct rooms *rooms, size_t room, const char *path)
{
    char *text = read_document(path);
    for (const char *at = text; (at = strstr(at, "#include \"")); at++) {
        const char *name = at + strlen("#include \"");
        size_t used = room_index(rooms, name, strcspn(name, "/\""));
        if (used > room)
            fail_msg("%s uses %.*s, which is no room before %s", path, (int)strcspn(name, "\""), name,
                     rooms->name[room]);
    }
}

TEST_CASE(rooms_use_only_those_before)
{
    struct rooms rooms = read_rooms("docs/CONTRIBUTING.md"), again = read_rooms("README.md");
    bool there[ROOMS] = {false};
    glob_t files;
    assert_int_equal(rooms.count, again.count);
    assert_int_equal(glob(PROJECT_SOURCE "/src/*/*.[ch]", 0, NULL, &files), 0);
    assert_true(files.gl_pathc > 100);
    for (size_t i = 0; i < files.gl_pathc; i++) {
        const char *path = files.gl_pathv[i] + sizeof PROJECT_SOURCE, *name = path + strlen("src/");
        size_t room = room_index(&rooms, name, strcspn(name, "/"));
        if (room == rooms.count)
            fail_msg("the room of %s stands in no order", path);
        there[room] = true;
        check_includes(&rooms, room, path);
    }
    globfree(&files);
    for (size_t room = 0; room < rooms.count; room++) {
        assert_string_equal(rooms.name[room], again.name[room]);
        if (!there[room])
            fail_msg("there is no room src/%s", rooms.name[room]);
    }
}
