/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every row of the table of limits, here with small values in place of the program's: files at a limit are read, those
 * just beyond it are refused with the limit and what to do. */
#include "base/limits.h"
#include "base/mustache.h"
#include "report/report.h"
#include "scan/zip_support.h"
#include "scene/measured_file.h"
#include "scene/scene_directory.h"

enum {
    SMALL_FILES = 5,
    SMALL_SCENE_FILES = 4,
    SMALL_FILE_BYTES = 3000,
    SMALL_UNPACKED_BYTES = 5 << 20,
    SMALL_UNPACKED_RATIO = 100,
    SMALL_MEMBERS = 4,
    SMALL_PACKED_DEPTH = 1,
    SMALL_POINTS = 12,
    SMALL_CELLS = 40,
    SMALL_COLUMNS = 10,
    SMALL_LINE_BYTES = 200,
    SMALL_HEADER_BYTES = 300,
    SMALL_XML_BYTES = 400000,
    SMALL_XML_ELEMENTS = 40,
    SMALL_XML_TAG_BYTES = 100000,
    SMALL_XML_DEPTH = 8,
    SMALL_MEASURED_LINES = 5,
    SMALL_MEASURED_LINE_BYTES = 60,
    SMALL_NAME_BYTES = 20,
    SMALL_RESULTS_BYTES = 400,
    SMALL_RESULTS_VALUES = 110,
    SMALL_COMPARED = 5,
    SMALL_RANKED = REPORTS_COMPARED + 1,
    SMALL_TEMPLATE_BYTES = 400,
    SMALL_TEMPLATE_STEPS = 1200,
    SMALL_PAGE_BYTES = 1600,
    SMALL_DIRECT_POINTS = 4 * 64 * 64
};

const struct limit_row limit_rows[LIMIT_COUNT] = {
#define LIMIT_ROW(key, most, unit, name, meaning, remedy) {name, SMALL_##key, unit, meaning, remedy},
    LIMITS(LIMIT_ROW)
#undef LIMIT_ROW
};

static bool met[LIMIT_COUNT];

static const char *from_object(void *context, const char *name)
{
    return json_string_value(json_object_get(context, name));
}

static const struct scan_options um = {.x_unit = "um", .z_unit = "um"};

static void expect_limit(const char *message, enum limit limit)
{
    if (!strstr(message, limit_words(limit).text) || strchr(message, '\n'))
        fail_msg("'%s' should end with '%s'", message, limit_words(limit).text);
    met[limit] = true;
}

/* Is this scan, which is freed, refused where it is over the limit, else of nx by ny points? */
static void expect_scan(struct text text, bool over, enum limit limit, size_t nx, size_t ny)
{
    struct scan scan;
    struct status status = {0};
    assert_false(text.failed);
    enum status_code code = read_bytes(&scan, text_string(&text), text.length, &um, &status);
    if (code != (over ? STATUS_SCAN : STATUS_OK))
        fail_msg("'%s' at the limit '%s'", status.message, limit_rows[limit].name);
    if (over) {
        expect_limit(status.message, limit);
        assert_null(scan.z_m);
    } else {
        assert_sound(&scan);
        assert_int_equal(scan.nx, nx);
        assert_int_equal(scan.ny, ny);
    }
    scan_free(&scan);
    text_free(&text);
}

/* The same of a scene in a directory, unless `text` is NULL of this text; `surfaces`: as many it has. */
static void expect_scene(const struct directory *directory, const char *text, bool over, enum limit limit,
                         size_t surfaces)
{
    struct scene scene;
    struct status status = {0};
    if (text)
        directory_write(directory, "scene.yaml", text);
    enum status_code code = scene_read(&scene, directory->path, NULL, &status);
    if (code != (over ? STATUS_SCENE : STATUS_OK))
        fail_msg("'%s' at the limit '%s'", status.message, limit_rows[limit].name);
    if (over)
        expect_limit(status.message, limit);
    else
        assert_int_equal(scene.surface_count, surfaces);
    scene_free(&scene);
}

/* Rows of x, z and what else there is, after `above` bytes of comments. */
static struct text table(size_t rows, size_t columns, size_t above)
{
    struct text text = {0};
    for (size_t line; above > 0; above -= line) {
        line = above < 100 ? above : 100;
        text_add(&text, "#%*s\n", (int)line - 2, "");
    }
    for (size_t row = 0; row < rows; row++)
        for (size_t i = 0; i < columns; i++)
            text_add(&text, "%zu%c", row * (i + 1) % 9 + (i == 0 ? row * 9 : 0), i + 1 < columns ? ' ' : '\n');
    return text;
}

TEST_CASE(test_texts)
{
    static const struct {
        enum limit limit;
        size_t rows, columns, above, more_rows, more_columns, more_above; /* the more are over it */
    } cases[] = {
        {LIMIT_POINTS, SMALL_POINTS, 2, 0, 1, 0, 0},
        {LIMIT_CELLS, SMALL_CELLS / 5, 5, 0, 1, 0, 0},
        {LIMIT_COLUMNS, 4, SMALL_COLUMNS, 0, 0, 1, 0},
        {LIMIT_HEADER_BYTES, 4, 2, SMALL_HEADER_BYTES, 0, 0, 100},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (size_t over = 0; over < 2; over++)
            expect_scan(table(cases[i].rows + over * cases[i].more_rows,
                              cases[i].columns + over * cases[i].more_columns,
                              cases[i].above + over * cases[i].more_above),
                        over, cases[i].limit, cases[i].rows, 1);
}

/* A row in any place, and a line above the rows. */
TEST_CASE(test_lines)
{
    for (size_t place = 0; place < 3; place++)
        for (size_t over = 0; over < 2; over++) {
            struct text text = {0};
            text_add(&text, "%s", place == 2 ? "0 1\n1 2\n2 1\n" : "");
            text_add(&text, place == 1 ? "#%*s\n" : "3%*s\n", SMALL_LINE_BYTES - 1 + (int)over, "1");
            text_add(&text, "%s", place < 2 ? "4 1\n5 2\n6 1\n" : "");
            expect_scan(text, over, LIMIT_LINE_BYTES, place == 1 ? 3 : 4, 1);
        }
}

/* The points that the header of a binary field announces. */
TEST_CASE(test_maps)
{
    for (size_t rows = 3; rows < 5; rows++) {
        struct text text = {0};
        text_add(&text, "Gwyddion Simple Field 1.0\nXRes = 4\nYRes = %zu\nXReal = 1\nYReal = 1\n", rows);
        put_field(&text, "", 4 - text.length % 4);
        for (size_t i = 0; i < 4 * rows; i++)
            put_f32(&text, (double)(i * i % 7));
        expect_scan(text, rows > 3, LIMIT_POINTS, 4, 3);
    }
}

TEST_IN_DIRECTORY(test_files)
{
    for (size_t over = 0; over < 2; over++) {
        struct text text = table(4, 2, 0);
        const char *path = directory_path(place, "a.dat");
        while (text.length < SMALL_FILE_BYTES + over)
            text_add(&text, "\n");
        directory_write(place, "a.dat", text.data);
        text_free(&text);
        FILE *file = fopen(path, "rb");
        int ends[2];
        struct scan scan;
        struct status status = {0}, streamed = {0}, piped = {0};
        enum status_code expected = over ? STATUS_IO : STATUS_OK;
        assert_non_null(file);
        assert_int_equal(scan_read(&scan, path, &um, &status), expected);
        assert_int_equal(text_read_stream(&text, file, "-", &streamed), expected);
        scan_free(&scan);
        text_free(&text);
        fclose(file);
        /* of a pipe nobody knows the length */
        assert_int_equal(pipe(ends), 0);
        for (size_t i = 0; i < SMALL_FILE_BYTES + over; i++)
            assert_int_equal(write(ends[1], "x", 1), 1);
        close(ends[1]);
        assert_non_null(file = fdopen(ends[0], "rb"));
        assert_int_equal(text_read_stream(&text, file, "-", &piped), expected);
        assert_true(over || text.length == SMALL_FILE_BYTES);
        text_free(&text);
        fclose(file);
        if (!over)
            continue;
        expect_limit(status.message, LIMIT_FILE_BYTES);
        expect_limit(streamed.message, LIMIT_FILE_BYTES);
        expect_limit(piped.message, LIMIT_FILE_BYTES);
    }
}

/* The scene, a directory that is listed, one inside it. */
TEST_CASE(test_directories)
{
    for (size_t over = 0; over < 2; over++)
        for (size_t inside = 0; inside < 2; inside++) {
            struct directory directory = directory_make();
            for (size_t i = 0; i < SMALL_FILES - 2 + over; i++) /* and . and .. */
                scene_directory_add(&directory, filled(inside ? "s/%zu.csv" : "%zu.csv", i));
            expect_scene(&directory, NULL, over, LIMIT_FILES, inside ? 1 : SMALL_FILES - 2);
            directory_remove(&directory);
        }
}

TEST_IN_DIRECTORY(test_scene_files)
{
    scene_directory_add(place, "a.csv");
    for (size_t over = 0; over < 2; over++) {
        struct text *text = support_text();
        text_add(text, "surfaces:\n");
        for (size_t i = 0; i < SMALL_SCENE_FILES / 2 + over; i++)
            text_add(text, "  - {name: s%zu, file: [a.csv, ./a.csv]}\n", i);
        directory_write(place, "scene.yaml", text->data);
        if (over)
            scene_directory_refused(place->path, NULL, STATUS_SCENE, "more than 4 files in one scene; split it");
        else
            (void)scene_directory_read(place->path, NULL);
    }
    met[LIMIT_SCENE_FILES] = true;
}

/* Lines of a measured file, whatever is in them, and bytes of one: a heading, a row, a remark. */
TEST_CASE(test_measured)
{
    static const unsigned quantities[MEASURED_COLUMNS] = {UNIT_LOADS, UNIT_RESISTANCE, UNIT_RESISTANCE};
    static const char *const begun[] = {"F (N),R (mOhm)", "1,2", "#"};
    for (size_t over = 0; over < 2; over++)
        for (size_t kind = 0; kind < 4; kind++) {
            struct text *text = support_text();
            struct measured_file file;
            struct status status = {0};
            if (kind < 3)
                text_add(text, "%-*s\n1,2\n", SMALL_MEASURED_LINE_BYTES + (int)over, begun[kind]);
            for (size_t i = 0; kind == 3 && i < SMALL_MEASURED_LINES + over; i++)
                text_add(text, i % 2 ? "1,2\n" : "\n");
            enum status_code code = measured_file_read(&file, string_view_of(text->data), "a", quantities, &status);
            assert_int_equal(code, over ? STATUS_SCENE : STATUS_OK);
            if (over)
                expect_limit(status.message, kind < 3 ? LIMIT_MEASURED_LINE_BYTES : LIMIT_MEASURED_LINES);
            measured_file_free(&file);
        }
}

/* Limits of what a scene says. */
TEST_IN_DIRECTORY(test_scenes)
{
    scene_directory_add(place, "a.csv");
    expect_scene(place, "surfaces: [{file: a.csv, name: abcdefghijklmnopqrst}]\n", false, LIMIT_NAME_BYTES, 1);
    expect_scene(place, "surfaces: [{file: a.csv, name: abcdefghijklmnopqrstu}]\n", true, LIMIT_NAME_BYTES, 0);
    expect_scene(place, "direct: {grid: 64, seeds: 4}\n", false, LIMIT_DIRECT_POINTS, 1);
    expect_scene(place, "direct: {grid: 66, seeds: 4}\n", true, LIMIT_DIRECT_POINTS, 0);
}

static const char heights[] = "x [um],z [um]\n0,0.5\n0.5,-1.25\n1,2.75\n1.5,0.125\n2,8\n2.5,-3.5\n";

/* The heights, then remarks, no two of which are alike, and blank lines up to `length` bytes. */
static struct text long_heights(size_t length)
{
    enum { LINE = 186, ROUGHLY = 8 };
    struct text text = {0};
    text_add(&text, "%s", heights);
    for (uint32_t seed = 1; text.length + LINE + ROUGHLY < length;) {
        char line[LINE + ROUGHLY] = "#";
        for (int at = 1; at < LINE; at += 4, seed = seed * 1664525 + 1013904223)
            snprintf(line + at, sizeof line - (size_t)at, "%04x", seed >> 16);
        text_add(&text, "%s\n", line);
    }
    while (text.length < length)
        text_add(&text, "\n");
    return text;
}

TEST_CASE(test_gzip)
{
    for (size_t over = 0; over < 2; over++)
        for (size_t members = 1; members < 4; members++) {
            struct text inner = long_heights(SMALL_UNPACKED_BYTES + over), text = {0};
            size_t cut = inner.length / members;
            for (size_t i = 0; i < members; i++) {
                size_t from = i * cut, to = i + 1 < members ? from + cut : inner.length;
                struct text member = gzip(inner.data + from, to - from);
                put_copy(&text, &member);
                text_free(&member);
            }
            text_free(&inner);
            expect_scan(text, over, LIMIT_UNPACKED_BYTES, SAMPLE_POINTS, 1);
        }
    for (size_t over = 0; over < 2; over++) { /* what is a thousandth of it when it is packed */
        size_t length = over ? SMALL_UNPACKED_BYTES : limit_unpacked(0), of_heights = sizeof heights - 1;
        char *blanks = support_room(length);
        memset(blanks, '\n', length);
        memcpy(blanks, heights, of_heights);
        expect_scan(gzip(blanks, length), over, LIMIT_UNPACKED_RATIO, SAMPLE_POINTS, 1);
    }
    struct text once = gzip(heights, sizeof heights - 1), twice = gzip(once.data, once.length);
    text_free(&once);
    expect_scan(twice, true, LIMIT_PACKED_DEPTH, 0, 0);
    const struct member in_zip[] = {{"a.csv", heights, sizeof heights - 1}, {NULL, NULL, 0}};
    once = zip(in_zip, true);
    twice = gzip(once.data, once.length);
    text_free(&once);
    expect_scan(twice, true, LIMIT_PACKED_DEPTH, 0, 0);
}

static struct text archive_of(size_t members, size_t bytes_each)
{
    struct packed all[SMALL_MEMBERS + 1];
    char names[SMALL_MEMBERS + 1][32];
    assert_true(members <= SMALL_MEMBERS + 1);
    for (size_t i = 0; i < members; i++) {
        struct text text = long_heights(bytes_each);
        snprintf(names[i], sizeof names[i], "%zu.csv", i);
        all[i] = pack(names[i], text.data, text.length, i % 2 == 1);
        text_free(&text);
    }
    struct text text = zip_of(all, members);
    for (size_t i = 0; i < members; i++)
        text_free(&all[i].bytes);
    return text;
}

TEST_CASE(test_archives)
{
    for (size_t over = 0; over < 2; over++) {
        expect_scan(archive_of(SMALL_MEMBERS + over, 100), over, LIMIT_MEMBERS, SAMPLE_POINTS, 1);
        expect_scan(archive_of(4, SMALL_UNPACKED_BYTES / 4 + over), over, LIMIT_UNPACKED_BYTES, SAMPLE_POINTS, 1);
        struct packed member = pack("a.csv", heights, sizeof heights - 1, false);
        member.size = limit_unpacked(member.bytes.length) + over;
        struct text text = zip_of(&member, 1);
        if (!over) /* believed until it is unpacked */
            assert_refused_bytes(text.data, text.length, &um, "is damaged; copy the file again");
        else
            expect_scan(text, over, LIMIT_UNPACKED_RATIO, 0, 0);
        if (!over)
            text_free(&text);
        text_free(&member.bytes);
    }
}

#define AXIS(name, kind) "<" name "><AxisType>" kind "</AxisType><Increment>1e-6</Increment></" name ">"

/* A profile of six points in main.xml itself, with `more` in it. */
static struct text x3p(const char *more, size_t length)
{
    struct text *main = support_text();
    text_add(main, "<p:ISO5436_2><Record1><FeatureType>PRF</FeatureType><Axes>" AXIS("CX", "I") AXIS("CY", "I")
                       AXIS("CZ", "A") "</Axes></Record1><Record3><ListDimension>6</ListDimension><DataList>");
    for (size_t i = 0; i < SAMPLE_POINTS; i++)
        text_add(main, "<Datum>%g</Datum>", sample_um[i]);
    text_add(main, "</DataList></Record3>%s", more);
    while (main->length + strlen("</p:ISO5436_2>") < length)
        text_add(main, "\n");
    text_add(main, "</p:ISO5436_2>");
    const struct member members[] = {{"main.xml", main->data, main->length}, {NULL, NULL, 0}};
    struct text text = zip(members, false);
    return text;
}

/* One with `more`, which is freed. */
static void expect_x3p(struct text *more, size_t length, bool over, enum limit limit)
{
    expect_scan(x3p(text_string(more), length), over, limit, SAMPLE_POINTS, 1);
    text_free(more);
}

TEST_CASE(test_x3p)
{
    enum { OWN_ELEMENTS = 22 };
    for (size_t over = 0; over < 2; over++) {
        struct text more = {0};
        expect_x3p(&more, SMALL_XML_BYTES + over, over, LIMIT_XML_BYTES);
        for (size_t i = 0; i < SMALL_XML_ELEMENTS - OWN_ELEMENTS + over; i++)
            text_add(&more, "<a/>");
        expect_x3p(&more, 0, over, LIMIT_XML_ELEMENTS);
        /* looked at in pieces of 64 KiB */
        text_add(&more, "<!--%*s-->", SMALL_XML_TAG_BYTES + (over ? 2 : -1) * 65536, "");
        expect_x3p(&more, 0, over, LIMIT_XML_TAG_BYTES);
        for (size_t i = 0; i < SMALL_XML_DEPTH - 1 + over; i++)
            text_add(&more, "<a>");
        for (size_t i = 0; i < SMALL_XML_DEPTH - 1 + over; i++)
            text_add(&more, "</a>");
        expect_x3p(&more, 0, over, LIMIT_XML_DEPTH);
    }
}

/* The bytes of a finished report that is compared. */
TEST_IN_DIRECTORY(test_results)
{
    char *const both[] = {directory_here.path, directory_here.path};
    for (int over = 0; over < 2; over++) {
        json_t *view;
        struct status status = {0};
        directory_write(
            place, "results.json",
            filled(
                "%-*s", SMALL_RESULTS_BYTES + over,
                "{\"program\": \"roughcontact\", \"leading\": \"m\", \"surfaces\": [{\"surface\": \"a\", \"models\": "
                "{\"m\": {\"operating\": {\"load_over_AnEp\": 1e-4, \"area_ratio\": 0.1}}}}]}"));
        assert_int_equal(report_compare(&view, both, 2, &status), over ? STATUS_IO : STATUS_OK);
        if (over)
            expect_limit(status.message, LIMIT_RESULTS_BYTES);
        json_decref(view);
    }
}

/* Reports with `a`, `b`, `a` ... beside what they have alike. */
static void expect_compared(const char *a, const char *b, size_t count, bool over, enum limit limit)
{
    static const char rest[] = "\"program\": \"roughcontact\", \"leading\": \"m\", \"surfaces\": [{\"surface\": "
                               "\"a\", \"models\": {\"m\": {\"operating\": {\"load_over_AnEp\": 1e-4, "
                               "\"area_ratio\": 0.1}}}}]}";
    const char *const more[] = {a, b};
    struct directory directory = directory_make();
    char first[sizeof directory.path + 2], second[sizeof first], *both[2 * REPORTS_COMPARED];
    json_t *view;
    struct status status = {0};
    for (size_t i = 0; i < count; i++)
        both[i] = i % 2 ? second : first;
    for (int i = 0; i < 2; i++) {
        struct text *text = support_text();
        snprintf(both[i], sizeof first, "%s/%d", directory.path, i);
        text_add(text, "{%s%s", more[i], rest);
        assert_true(text->length <= SMALL_RESULTS_BYTES);
        directory_write(&directory, i ? "1/results.json" : "0/results.json", text->data);
    }
    enum status_code code = report_compare(&view, both, count, &status);
    if ((code != STATUS_OK) != over)
        fail_msg("'%s' at the limit '%s'", status.message, limit_rows[limit].name);
    if (over)
        expect_limit(status.message, limit);
    json_decref(view);
    directory_remove(&directory);
}

/* Of what they have alike a report counts 50: 10 are left, and signs within a text are none. */
TEST_CASE(test_compared_values)
{
    static const char *const kinds[][2] = {
        {"\"x\": [1,2,3,4,5,6], ", "\"x\": [1,2,3,4,5,6,7], "},
        {"\"x\": \"[1,2,3\\\"{{{{,\", \"y\": \"\", ", "\"x\": \"\", \"y\": \"\", \"z\": \"\", "},
        {"\"x\": [], \"y\": [], ", "\"x\": [], \"y\": {}, "},
    };
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        for (size_t over = 0; over < 2; over++)
            expect_compared("", kinds[i][over], 2, over, LIMIT_RESULTS_VALUES);
    /* a surface, a number and an input of two reports each; two inputs */
    expect_compared("", "\"version\": 2, ", 2, false, LIMIT_COMPARED);
    expect_compared("\"scene\": 1, ", "\"version\": 2, ", 2, true, LIMIT_COMPARED);
    /* of many reports two are held at a time, and what they would print side by side is not counted */
    expect_compared("\"scene\": 1, ", "\"version\": 2, ", SMALL_RANKED, false, LIMIT_RANKED);
    expect_compared("", "", SMALL_RANKED + 1, true, LIMIT_RANKED);
    expect_compared("", kinds[0][1], SMALL_RANKED, true, LIMIT_RESULTS_VALUES);
}

/* Adds what a template makes of `list`, an item a number. */
static void expect_filled(const char *source, const char *partial, size_t items, bool over, enum limit limit)
{
    json_auto_t *view = json_object(), *partials = json_pack("{s:s}", "p", partial);
    json_t *list = json_array();
    struct mustache how = {view, NULL, from_object, partials};
    struct text *out = support_text();
    struct status status = {0};
    for (size_t i = 0; i < items; i++)
        json_array_append_new(list, json_integer((json_int_t)i));
    json_object_set_new(view, "list", list);
    enum status_code code = mustache_render(out, source, "it.md", &how, &status);
    if (code != (over ? STATUS_USAGE : STATUS_OK))
        fail_msg("'%s' at the limit '%s'", status.message, limit_rows[limit].name);
    if (over)
        expect_limit(status.message, limit);
}

TEST_CASE(test_templates)
{
    for (size_t over = 0; over < 2; over++) {
        char partial[SMALL_TEMPLATE_BYTES];
        expect_filled(filled("%*s", SMALL_TEMPLATE_BYTES + (int)over, "x"), "", 0, over, LIMIT_TEMPLATE_BYTES);
        snprintf(partial, sizeof partial, "%*s", SMALL_TEMPLATE_BYTES - 20 + (int)over, "x"); /* one after the other */
        expect_filled("{{>p}}{{>p}}{{>p}}|x", partial, 0, over, LIMIT_TEMPLATE_BYTES);
        memset(partial, '\n', 200); /* and what it is indented by */
        partial[over ? 60 : 40] = '\0';
        expect_filled("       {{> p  }}\n", partial, 0, over, LIMIT_TEMPLATE_BYTES);
        expect_filled(filled("{{#list}}%*s{{/list}}", SMALL_PAGE_BYTES / 5, "x"), "", 5 + over, over, LIMIT_PAGE_BYTES);
        /* 4^3 items against 4^4 */
        expect_filled(over ? "{{#list}}{{#list}}{{#list}}{{#list}}{{.}}{{/list}}{{/list}}{{/list}}{{/list}}"
                           : "{{#list}}{{#list}}{{#list}}{{.}}{{/list}}{{/list}}{{/list}}",
                      "", 4, over, LIMIT_TEMPLATE_STEPS);
        snprintf(partial, sizeof partial, "{{!%*s}}", 100, ""); /* which is read for each item */
        expect_filled("{{#list}}{{>p}}{{/list}}", partial, over ? 20 : 10, over, LIMIT_TEMPLATE_STEPS);
    }
}

TEST_CASE(test_no_row_is_without_its_test)
{
    for (size_t i = 0; i < LIMIT_COUNT; i++)
        if (!met[i])
            fail_msg("nothing was refused for the limit '%s'", limit_rows[i].name);
}
