/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Several scans in a zip archive, gzip, Gwyddion's own files. */
#include "zip_support.h"

static const char csv[] = "x [um],z [um]\n0,0.5\n0.5,-1.25\n1,2.75\n1.5,0.125\n2,8\n2.5,-3.5\n";
static const char sdf[] = "aISO-1.0\nNumPoints=6\nNumProfiles=1\nXscale=0.5e-6\nYscale=0\nZscale=1e-6\n*\n"
                          "0.5 -1.25 2.75 0.125 8 -3.5\n*\n";

static bool has_warning(const struct scan *scan, const char *words)
{
    for (size_t i = 0; i < scan->warning_count; i++)
        if (strstr(scan->warnings[i], words))
            return true;
    return false;
}

/* Reads the scans of an archive one after another. Their names are `parts`, which NULL ends; only the first has
 * `warning` (NULL: not asked). */
static void assert_parts(const struct text *text, const char *const *parts, const char *warning)
{
    struct scan_options options = {.x_unit = "um", .z_unit = "um"};
    size_t count = 0;
    do {
        struct scan scan;
        assert_non_null(parts[count]);
        expect_ok(read_bytes, &scan, text->data, text->length, &options);
        assert_sound(&scan);
        assert_string_equal(scan.part, parts[count]);
        assert_int_equal(scan.nx, SAMPLE_POINTS);
        for (size_t i = 0; i < SAMPLE_POINTS; i++)
            assert_within(scan.z_m[i], sample_um[i] * 1e-6, 1e-12);
        if (warning)
            assert_true(has_warning(&scan, warning) == (count == 0));
        options.entry = scan.next_entry;
        scan_free(&scan);
        count++;
    } while (options.entry > 0);
    assert_null(parts[count]);
}

static size_t searched; /* bytes, by the whole program */

/* In place of memmem() where any file calls it (ld --wrap, tests/CMakeLists.txt). */
void *__real_memmem(const void *bytes, size_t length, const void *part, size_t part_length);
void *__wrap_memmem(const void *bytes, size_t length, const void *part, size_t part_length);
void *__wrap_memmem(const void *bytes, size_t length, const void *part, size_t part_length)
{
    searched += length;
    return __real_memmem(bytes, length, part, part_length);
}

/* An archive is looked through once, not for each scan in it. */
TEST_CASE(test_many_beside_a_large_one)
{
    enum { SCANS = 20, LARGE = 1 << 20 };
    static char large[LARGE], names[SCANS][8];
    struct member members[SCANS + 2] = {[SCANS] = {"photo.jpg", large, LARGE}};
    const char *parts[SCANS + 1] = {NULL};
    memcpy(large, "\xff\xd8\xff\xe0", 4);
    for (size_t i = 0; i < SCANS; i++) {
        snprintf(names[i], sizeof names[i], "%zu.csv", i);
        members[i] = (struct member){parts[i] = names[i], csv, sizeof csv - 1};
    }
    struct text text = zip(members, false);
    searched = 0;
    assert_parts(&text, parts, "passed over in the archive, no scan: photo.jpg");
    assert_true(searched > 0 && searched < 10 * text.length);
    text_free(&text);
}

TEST_CASE(test_several)
{
    const struct member texts[] = {{"README.md", "1 2\n3 4\n", 8},           {"folder/", "", 0},
                                   {"folder/b.csv", csv, sizeof csv - 1},    {"__MACOSX/folder/._b.csv", "\0\1", 2},
                                   {".b.csv", csv, sizeof csv - 1},          {"a.txt", csv, sizeof csv - 1},
                                   {"photo.jpg", "\xff\xd8\xff\xe0\0\0", 6}, {"notes.txt", "by hand\n", 8},
                                   {"c.csv", csv, sizeof csv - 1},           {NULL, NULL, 0}};
    static const char *const text_parts[] = {"folder/b.csv", "a.txt", "c.csv", NULL};
    for (int deflated = 0; deflated < 2; deflated++) {
        struct text text = zip(texts, deflated);
        assert_parts(&text, text_parts, "passed over in the archive, no scans: README.md, photo.jpg, notes.txt");
        text_free(&text);
    }
    const struct member mixed[] = {{"a.txt", csv, sizeof csv - 1}, {"b.sdf", sdf, sizeof sdf - 1}, {NULL, NULL, 0}};
    static const char *const mixed_parts[] = {"a.txt", "b.sdf", NULL};
    for (size_t first = 0; first < 2; first++) { /* both, and the last alone */
        struct text text = zip(mixed + first, first > 0);
        assert_parts(&text, mixed_parts + first, NULL);
        text_free(&text);
    }
}

/* A file that is damaged, encrypted or of a format that is not read is refused by its name, and the others are read. */
TEST_CASE(test_the_others_are_read)
{
    enum { FILES = 7 };
    static const char wyko[] = "\1\0Directory\0\0";
    static const char *const parts[FILES] = {"a", "b", "c", "d", "e", "f", "g"};
    static const char *const refused[FILES] = {"file(a): the format is not read here: Wyko OPD file",
                                               NULL,
                                               "'c' in the archive is damaged; copy the file again",
                                               NULL,
                                               "'e' in the archive is encrypted",
                                               NULL,
                                               "'g' in the archive is damaged"};
    for (int texts = 0; texts < 2; texts++) {
        const char *bytes = texts ? csv : sdf;
        size_t length = texts ? sizeof csv - 1 : sizeof sdf - 1;
        struct packed all[FILES];
        for (size_t i = 0; i < FILES; i++)
            all[i] = pack(parts[i], i == 0 ? wyko : bytes, i == 0 ? sizeof wyko : length, i > 2);
        all[2].bytes.data[8]++;
        all[4].flags = 1;
        all[6].crc++;
        struct text text = zip_of(all, FILES);
        struct scan_options options = {.x_unit = "um", .z_unit = "um"};
        for (size_t i = 0; i < FILES; i++) {
            struct scan scan;
            struct status status = {0};
            enum status_code code = read_bytes(&scan, text.data, text.length, &options, &status);
            assert_int_equal(code, refused[i] ? STATUS_SCAN : STATUS_OK);
            if (refused[i] && !strstr(status.message, refused[i]))
                fail_msg("'%s' without '%s'", status.message, refused[i]);
            assert_string_equal(scan.part, parts[i]);
            options.entry = scan.next_entry;
            assert_int_equal(options.entry > 0, i + 1 < FILES);
            scan_free(&scan);
        }
        text_free(&text);
        for (size_t i = 0; i < FILES; i++)
            text_free(&all[i].bytes);
    }
}

/* A file that may be a scan is refused, not passed over. */
TEST_CASE(test_refusals)
{
    const struct member damaged[] = {{"a.csv", csv, sizeof csv - 1}, {"b.csv", "no numbers\n", 11}, {NULL, NULL, 0}};
    const struct member wyko[] = {{"a.txt", "by hand\n", 8}, {"b.opd", "\1\0Directory\0\0", 13}, {NULL, NULL, 0}};
    struct scan_options second = {.entry = 1};
    refuse_text(zip(damaged, true), &second, "file(b.csv): no line of numbers in it");
    refuse_text(zip(wyko, true), &no_units,
                "file(b.opd): the format is not read here: Wyko OPD file; export it as text");
    struct text text = zip(wyko, true);
    const struct member nested[] = {{"inner.zip", text.data, text.length}, {NULL, NULL, 0}};
    refuse_text(zip(nested, false), &no_units, "no scan in this zip archive, only inner.zip");
    assert_refused_bytes(text.data, text.length - 30, &no_units, "damaged zip archive");
    text_free(&text);
    const struct member workbook[] = {{"[Content_Types].xml", "x", 1}, {"xl/workbook.xml", "y", 1}, {NULL, NULL, 0}};
    refuse_text(zip(workbook, true), &no_units, "Excel workbook; save the sheet with the scan as CSV");
    static struct member many[1002];
    for (size_t i = 0; i < 1001; i++)
        many[i] = (struct member){"a.csv", csv, sizeof csv - 1};
    refuse_text(zip(many, true), &no_units, "1001 files in the archive; at most 1000 files: unpack it");
}

static void assert_prefixes_refused(const struct text *text)
{
    for (size_t length = 0; length < text->length; length++) {
        struct scan scan;
        expect_fails(STATUS_SCAN, "", read_bytes, &scan, text->data, length, &no_units);
        scan_free(&scan);
    }
}

TEST_CASE(test_gzip)
{
    struct text text = gzip(csv, sizeof csv - 1);
    assert_sample(&text, "text", SCAN_PROFILE, SAMPLE_POINTS, &no_units);
    assert_prefixes_refused(&text);
    assert_refused_bytes(text.data, text.length - 1, &no_units, "damaged or cut off within the gzip data");
    refuse_text(gzip(text.data, text.length), &no_units,
                "a packed file within a packed file; at most 1 level: unpack it");
    text_free(&text);
    /* members one after another are one file */
    text = gzip(csv, 30);
    struct text rest = gzip(csv + 30, sizeof csv - 1 - 30);
    put_copy(&text, &rest);
    assert_sample(&text, "text", SCAN_PROFILE, SAMPLE_POINTS, &no_units);
    text_free(&rest);
    text_free(&text);
    expect_sample(gzip(sdf, sizeof sdf - 1), "sdf", SCAN_PROFILE, SAMPLE_POINTS, &no_units);
    refuse_text(gzip("\x89PNG\r\n\x1a\n\0", 9), &no_units, "it is no scan: PNG picture");
}

static void put_name(struct text *text, const char *name, char type)
{
    text_add_bytes(text, name, strlen(name) + 1);
    text_add_bytes(text, &type, 1);
}

/* An object of that name around `inner`, which is freed. */
static void put_object(struct text *text, const char *name, struct text *inner)
{
    text_add_bytes(text, name, strlen(name) + 1);
    put_bytes(text, inner->length, 4);
    put_copy(text, inner);
    text_free(inner);
}

static void put_unit(struct text *text, const char *key, const char *unit)
{
    struct text inner = {0};
    put_name(&inner, "unitstr", 's');
    text_add_bytes(&inner, unit, strlen(unit) + 1);
    put_name(text, key, 'o');
    put_object(text, "GwySIUnit", &inner);
}

/* A map of the sample's heights times `factor`, as a component `key`. */
static void put_field_object(struct text *text, const char *key, double factor, const char *z_unit, size_t claimed)
{
    struct text inner = {0};
    put_name(&inner, "xres", 'i');
    put_bytes(&inner, SAMPLE_COLUMNS, 4);
    put_name(&inner, "yres", 'i');
    put_bytes(&inner, SAMPLE_ROWS, 4);
    put_name(&inner, "xreal", 'd');
    put_f64(&inner, 1.5e-6);
    put_name(&inner, "yreal", 'd');
    put_f64(&inner, 4e-6);
    put_unit(&inner, "si_unit_xy", "m");
    put_unit(&inner, "si_unit_z", z_unit);
    put_name(&inner, "data", 'D');
    put_bytes(&inner, claimed, 4);
    for (size_t i = 0; i < SAMPLE_POINTS; i++)
        put_f64(&inner, factor == 0 ? (i == 2 ? 1 : 0) : sample_um[i] * factor);
    put_name(text, key, 'o');
    put_object(text, "GwyDataField", &inner);
}

static struct text gwy(struct text *components)
{
    struct text text = {0};
    text_add_bytes(&text, "GWYP", 4);
    put_object(&text, "GwyContainer", components);
    return text;
}

TEST_CASE(test_gwy)
{
    struct text inner = {0};
    put_name(&inner, "/0/data/title", 's');
    text_add_bytes(&inner, "Height", 7);
    put_name(&inner, "/0/data/visible", 'b');
    put_bytes(&inner, 1, 1);
    put_name(&inner, "/0/data/icon", 'C');
    PUT(&inner, {3, 4}, {7, 3});
    put_field_object(&inner, "/0/data", 1e-6, "m", SAMPLE_POINTS);
    put_name(&inner, "/names", 'S');
    put_bytes(&inner, 2, 4);
    text_add_bytes(&inner, "a\0b", 4);
    struct text text = gwy(&inner);
    assert_sample(&text, "gwy", SCAN_AREAL, SAMPLE_POINTS, &no_units);
    assert_prefixes_refused(&text);
    expect_sample(gzip(text.data, text.length), "gwy", SCAN_AREAL, SAMPLE_POINTS, &no_units);
    text_free(&text);

    /* of several the first that holds lengths, without the points under its own mask */
    put_field_object(&inner, "/0/data", 1, "V", SAMPLE_POINTS);
    put_field_object(&inner, "/10/data", 2e-6, "m", SAMPLE_POINTS);
    put_field_object(&inner, "/0/mask", 1, "", SAMPLE_POINTS);
    put_field_object(&inner, "/2/data", 1e3, "nm", SAMPLE_POINTS);
    put_field_object(&inner, "/2/mask", 0, "", SAMPLE_POINTS);
    text = gwy(&inner);
    assert_sample(&text, "gwy", SCAN_AREAL, 2, &no_units);
    struct scan scan;
    expect_ok(read_bytes, &scan, text.data, text.length, &no_units);
    assert_true(has_warning(&scan, "1 points under the mask of Gwyddion are taken as missing"));
    assert_true(has_warning(&scan, "the file holds 3 maps: /2/data was read"));
    scan_free(&scan);
    text_free(&text);
}

TEST_CASE(test_gwy_refusals)
{
    struct text inner = {0};
    put_field_object(&inner, "/0/data", 1e-6, "m", SAMPLE_POINTS + 1);
    refuse_text(gwy(&inner), &no_units, "cut off or damaged");
    put_field_object(&inner, "/0/data", 1e-6, "m", SAMPLE_POINTS - 1);
    refuse_text(gwy(&inner), &no_units, "cut off or damaged");
    put_field_object(&inner, "/0/data", 1, "V", SAMPLE_POINTS);
    refuse_text(gwy(&inner), &no_units, "z is in 'V' by the file, which is no unit of length");
    put_name(&inner, "/0/filename", 's');
    text_add_bytes(&inner, "a", 2);
    refuse_text(gwy(&inner), &no_units, "no map in it (/0/data)");
    put_name(&inner, "/0/odd", '?');
    refuse_text(gwy(&inner), &no_units, "cut off or damaged");
}
