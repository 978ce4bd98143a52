/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Formats that are not read are known by their bytes, or by their name where the file is binary. */
#include "scan/format.h"
#include "zip_support.h"

#define BYTES(text) text, sizeof(text) - 1

static void expect_format(const char *path, const char *bytes, size_t length, const char *name, enum format_kind kind)
{
    struct scan_bytes file = bytes_copy(bytes, length);
    for (size_t shown = 0; shown < length; shown++) /* every prefix */
        (void)format_of(&(struct scan_file){.bytes = file.bytes, .length = shown, .path = path}, false);
    struct format format = format_of(&(struct scan_file){.bytes = file.bytes, .length = length, .path = path}, true);
    free((char *)file.bytes);
    if (format.kind != kind || (name ? !format.name || strcmp(format.name, name) != 0 : format.name != NULL))
        fail_msg("%s, %s: %s", path, name, format.name);
}

TEST_CASE(test_files)
{
    static const struct {
        const char *path, *bytes;
        size_t length;
        const char *name; /* NULL: not known */
        enum format_kind kind;
    } files[] = {
        {"a", BYTES("\1\0Directory\0\0\0\0"), "Wyko OPD file", FORMAT_FOREIGN},
        {"a.PLU", BYTES("Mon Jan 01 2001\0\0\0\1"), "Sensofar PLU file", FORMAT_FOREIGN},
        {"a.plu", BYTES("1 2\n3 4\n"), "text", FORMAT_SCAN}, /* text of that name */
        {"a.dat", BYTES("\x88\x1b\x03\x6f\0\1\0\0"), "Zygo MetroPro file", FORMAT_FOREIGN},
        {"a.dat", BYTES("\x88\x1b\x04\x6f\0\1\0\0"), NULL, FORMAT_UNKNOWN},
        {"a.ibw", BYTES("\5\0\x12\x34"), "Igor Pro binary wave", FORMAT_FOREIGN},
        {"a.dat", BYTES("\5\0\x12\x34"), NULL, FORMAT_UNKNOWN},
        {"a.001", BYTES("\\*File list\r\n\\Version: 0x05\r\n"), "Bruker Nanoscope file", FORMAT_FOREIGN},
        {"a.vk4", BYTES("VK4_\0\0\0\0"), "Keyence VK file", FORMAT_FOREIGN},
        {"a.lext", BYTES("II*\0\x08\0\0\0\0\0"), "Olympus LEXT file", FORMAT_FOREIGN},
        {"a.poir", BYTES("PK\3\4\0\0\0\0\1"), "Olympus POIR file", FORMAT_FOREIGN},
        {"a", BYTES("\x89HDF\r\n\x1a\n\0"), "HDF5 file", FORMAT_FOREIGN},
        {"a.tiff", BYTES("II*\0\xff\xff\xff\xff\1\0"), "TIFF picture", FORMAT_OTHER},
        {"a", BYTES("%PDF-1.7\n"), "PDF document", FORMAT_OTHER},
        {"a", BYTES("\x89PNG\r\n\x1a\n\0"), "PNG picture", FORMAT_OTHER},
        {"a.xls", BYTES("\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1\0"), "old Excel workbook", FORMAT_OTHER},
        {"a.xyz", BYTES("\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1\0"), NULL, FORMAT_UNKNOWN}, /* instruments use it too */
        {"a.csv", BYTES("0 1\n1 2\n"), "text", FORMAT_SCAN},
        {"a.bin", BYTES("\0\1\2\3"), NULL, FORMAT_UNKNOWN},
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        expect_format(files[i].path, files[i].bytes, files[i].length, files[i].name, files[i].kind);
}

TEST_CASE(test_archives)
{
    static const struct {
        const char *entry, *content, *name;
        enum format_kind kind;
    } archives[] = {
        {"LAYER_0.raw", "x", "Sensofar PLUX file", FORMAT_FOREIGN},
        {"xl/workbook.xml", "x", "Excel workbook", FORMAT_OTHER},
        {"word/document.xml", "x", "Word document", FORMAT_OTHER},
        {"mimetype", "application/vnd.oasis.opendocument.spreadsheet", "OpenDocument spreadsheet", FORMAT_OTHER},
        {"mimetype", "application/vnd.oasis.opendocument.text", "OpenDocument file", FORMAT_OTHER},
        {"scan.csv", "0 1\n", "zip", FORMAT_PACKED},
    };
    for (size_t i = 0; i < sizeof archives / sizeof *archives; i++) {
        const struct member members[] = {{archives[i].entry, archives[i].content, strlen(archives[i].content)},
                                         {NULL, NULL, 0}};
        struct text text = zip(members, false);
        expect_format("a", text.data, text.length, archives[i].name, archives[i].kind);
        text_free(&text);
    }
}

/* Every row has a name, a kind, and what tells a file of it: its bytes, an entry of an archive, or its ending. */
TEST_CASE(test_rows)
{
    for (size_t i = 0; i < format_count; i++) {
        const struct format *row = &format_rows[i];
        if (!row->name || !*row->name || row->kind == FORMAT_UNKNOWN)
            fail_msg("row %zu has no name or kind", i);
        assert_true((row->read != NULL) == (row->kind == FORMAT_SCAN));
        assert_true((row->magic != NULL) == (row->magic_length > 0));
        if (row->read ? (row->sniff != NULL) == (row->magic != NULL)
                      : row->sniff || !(row->magic || row->entry || row->endings))
            fail_msg("%s: nothing tells a file of this format", row->name);
    }
}

/* Files that are certainly no scans, and files that may be. */
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
