/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files that no reader reads: known by their bytes, else by their name and that they are binary. */
#include "scan/format.h"
#include "zip_support.h"

#define BYTES(text) text, sizeof(text) - 1

static const struct {
    const char *path, *bytes;
    size_t length;
    const char *name; /* NULL: not known */
    enum foreign_kind kind;
} files[] = {
    {"a", BYTES("\1\0Directory\0\0\0\0"), "Wyko OPD file", FOREIGN_SCAN},
    {"a.PLU", BYTES("Mon Jan 01 2001\0\0\0"), "Sensofar PLU file", FOREIGN_SCAN},
    {"a.plu", BYTES("1 2\n3 4\n"), NULL, FOREIGN_SCAN}, /* text of that name */
    {"a.dat", BYTES("\x88\x1b\x03\x6f\0\1\0\0"), "Zygo MetroPro file", FOREIGN_SCAN},
    {"a.dat", BYTES("\x88\x1b\x04\x6f\0\1\0\0"), NULL, FOREIGN_SCAN},
    {"a.ibw", BYTES("\5\0\x12\x34"), "Igor Pro binary wave", FOREIGN_SCAN},
    {"a.dat", BYTES("\5\0\x12\x34"), NULL, FOREIGN_SCAN},
    {"a.001", BYTES("\\*File list\r\n\\Version: 0x05\r\n"), "Bruker Nanoscope file", FOREIGN_SCAN},
    {"a.vk4", BYTES("VK4_\0\0\0\0"), "Keyence VK file", FOREIGN_SCAN},
    {"a.lext", BYTES("II*\0\x08\0\0\0\0\0"), "Olympus LEXT file", FOREIGN_SCAN},
    {"a.poir", BYTES("PK\3\4\0\0\0\0"), "Olympus POIR file", FOREIGN_SCAN},
    {"a", BYTES("\x89HDF\r\n\x1a\n\0"), "HDF5 file", FOREIGN_SCAN},
    {"a.tiff", BYTES("II*\0\xff\xff\xff\xff\1\0"), "TIFF picture", FOREIGN_DOCUMENT},
    {"a", BYTES("%PDF-1.7\n"), "PDF document", FOREIGN_DOCUMENT},
    {"a", BYTES("\x89PNG\r\n\x1a\n\0"), "PNG picture", FOREIGN_DOCUMENT},
    {"a.xls", BYTES("\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1\0"), "old Excel workbook", FOREIGN_DOCUMENT},
    {"a.xyz", BYTES("\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1\0"), NULL, FOREIGN_DOCUMENT}, /* instruments use it too */
    {"a.csv", BYTES("0 1\n1 2\n"), NULL, FOREIGN_DOCUMENT},
    {"a.bin", BYTES("\0\1\2\3"), NULL, FOREIGN_DOCUMENT},
};

TEST_CASE(test_files)
{
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        for (size_t length = 0; length <= files[i].length; length++) { /* every prefix */
            struct scan_bytes file = bytes_copy(files[i].bytes, length);
            const struct foreign *foreign =
                foreign_find(&(struct scan_file){.bytes = file.bytes, .length = length, .path = files[i].path});
            if (length == files[i].length && (foreign == NULL) != (files[i].name == NULL))
                fail_msg("row %zu, %s: %s", i, files[i].path, foreign ? foreign->name : "not known");
            if (length == files[i].length && foreign) {
                assert_string_equal(foreign->name, files[i].name);
                assert_int_equal(foreign->kind, files[i].kind);
            }
            free((char *)file.bytes);
        }
    }
}

TEST_CASE(test_archives)
{
    static const struct {
        const char *entry, *content, *name;
        enum foreign_kind kind;
    } archives[] = {
        {"LAYER_0.raw", "x", "Sensofar PLUX file", FOREIGN_SCAN},
        {"xl/workbook.xml", "x", "Excel workbook", FOREIGN_DOCUMENT},
        {"word/document.xml", "x", "Word document", FOREIGN_DOCUMENT},
        {"mimetype", "application/vnd.oasis.opendocument.spreadsheet", "OpenDocument spreadsheet", FOREIGN_DOCUMENT},
        {"mimetype", "application/vnd.oasis.opendocument.text", "OpenDocument file", FOREIGN_DOCUMENT},
        {"scan.csv", "0 1\n", NULL, FOREIGN_SCAN},
    };
    for (size_t i = 0; i < sizeof archives / sizeof *archives; i++) {
        const struct member members[] = {{archives[i].entry, archives[i].content, strlen(archives[i].content)},
                                         {NULL, NULL, 0}};
        struct text text = zip(members, false);
        struct scan_bytes file = bytes_copy(text.data, text.length);
        const struct foreign *foreign =
            foreign_find(&(struct scan_file){.bytes = file.bytes, .length = file.length, .path = file.path});
        assert_int_equal(foreign == NULL, archives[i].name == NULL);
        if (foreign) {
            assert_string_equal(foreign->name, archives[i].name);
            assert_int_equal(foreign->kind, archives[i].kind);
        }
        free((char *)file.bytes);
        text_free(&text);
    }
}

/* What lies beside scans, and what may be one. */
TEST_CASE(test_others)
{
    static const struct {
        const char *path, *content;
        bool other;
    } texts[] = {
        {"dir/README", "1 2\n3 4\n", true},
        {"readme.txt", "1 2\n", true},
        {"readmission.csv", "1 2\n", false},
        {"a.py", "0.5, 1\n", true},
        {"a.MD", "1 2\n3 4\n", true},
        {"notes.txt", "by hand\n", true},
        {"notes.txt", "by hand\n1 2\n", false},
        {"a.csv", "by hand\n", false},
        {"scan", "by hand\n", false},
        {"a.txt", "", false},
        {"a.dat", "\0\1\2", false},
        {"a.txt", "# 1 2\n", true},
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        struct scan_bytes file = {texts[i].content, strlen(texts[i].content), texts[i].path};
        if ((scan_is_other(&file, true) != NULL) != texts[i].other)
            fail_msg("%s (%zu)", texts[i].path, i);
    }
    struct scan_bytes start = {"by hand\n", 8, "notes.txt"}; /* the numbers may follow */
    assert_null(scan_is_other(&start, false));
}
