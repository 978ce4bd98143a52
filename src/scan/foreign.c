/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/foreign.h"

#include <string.h>

enum { FOREIGN_LOOKED_AT = 4096 };

const char foreign_usual_remedy[] =
    "export it as text (x z columns), .sdf, .sur or .x3p, or save it as .gwy with Gwyddion";

#define MAGIC(bytes) .magic = bytes, .magic_length = sizeof bytes - 1

#define SHEET "save the sheet with the scan as CSV (x z columns)"
#define ODS   "mimetypeapplication/vnd.oasis.opendocument.spreadsheet" /* behind the first entry's header */
#define OLE   "\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"                       /* of old office programs */

/* The first row that fits counts: those with an ending of their own stand before the general ones. */
static const struct foreign rows[] = {
    /* instruments */
    {"Wyko OPD file", MAGIC("\1\0Directory")},
    {"Dektak or Bruker OPDx file", MAGIC("VCA DATA\1\0\0\x55")},
    {"Sensofar PLUX file", .entry = "LAYER_0.raw"},
    {"Sensofar PLU file", .endings = ".plu .apx"},
    {"Zygo MetroPro file", MAGIC("\x88\x1b\x03")},
    {"FRT MicroProf file", MAGIC("FRTM_")},
    {"MountainsMap document", .endings = ".mnt .mntx"},
    {"binary Surfer grid", MAGIC("DSBB")},
    {"binary Surfer grid", MAGIC("DSRB")},
    {"Igor Pro binary wave", .endings = ".ibw .bwav"},
    {"Bruker Nanoscope file", MAGIC("*File list\r\n"), .offset = 1},
    {"Keyence VK file", MAGIC("VK"), .endings = ".vk3 .vk4 .vk6 .vk7"},
    {"Olympus LEXT file", MAGIC("II*\0"), .endings = ".lext .ols"},
    {"Olympus POIR file", .endings = ".poir"},
    {"NanoFocus NMS file", .endings = ".nms"},
    {"ZEISS CZI file", MAGIC("ZISRAWFILE")},
    {"HDF5 file", MAGIC("\x89HDF\r\n\x1a\n")},
    {"MATLAB file", MAGIC("MATLAB ")},
    {"NumPy array", MAGIC("\x93NUMPY")},
    {"tar archive", "unpack it", MAGIC("ustar"), .offset = 257},
    {"7-Zip archive", "unpack it", MAGIC("7z\xbc\xaf\x27\x1c")},
    {"RAR archive", "unpack it", MAGIC("Rar!\x1a\7")},
    {"bzip2 file", "unpack it", MAGIC("BZh")},
    {"xz file", "unpack it", MAGIC("\xfd\x37zXZ\0")},
    /* sheets, which may hold a scan, and other documents */
    {"Excel workbook", SHEET, .entry = "xl/workbook.xml", .kind = FOREIGN_DOCUMENT},
    {"Word document", .entry = "word/document.xml", .kind = FOREIGN_DOCUMENT},
    {"PowerPoint presentation", .entry = "ppt/presentation.xml", .kind = FOREIGN_DOCUMENT},
    {"OpenDocument spreadsheet", SHEET, MAGIC(ODS), .offset = 30, .kind = FOREIGN_DOCUMENT},
    {"OpenDocument file", MAGIC("mimetypeapplication/vnd.oasis.opendocument"), .offset = 30, .kind = FOREIGN_DOCUMENT},
    {"old Excel workbook", SHEET, MAGIC(OLE), .endings = ".xls .xlt", .kind = FOREIGN_DOCUMENT},
    {"Office document", MAGIC(OLE), .endings = ".doc .ppt .pps .vsd .msg .db .dot .opj", .kind = FOREIGN_DOCUMENT},
    {"PDF document", MAGIC("%PDF-"), .kind = FOREIGN_DOCUMENT},
    {"PostScript file", MAGIC("%!PS-Adobe"), .kind = FOREIGN_DOCUMENT},
    {"RTF document", MAGIC("{\\rtf"), .kind = FOREIGN_DOCUMENT},
    {"PNG picture", MAGIC("\x89PNG\r\n\x1a\n"), .kind = FOREIGN_DOCUMENT},
    {"JPEG picture", MAGIC("\xff\xd8\xff"), .kind = FOREIGN_DOCUMENT},
    {"GIF picture", MAGIC("GIF8"), .kind = FOREIGN_DOCUMENT},
    {"TIFF picture", MAGIC("II*\0"), .kind = FOREIGN_DOCUMENT},
    {"TIFF picture", MAGIC("MM\0*"), .kind = FOREIGN_DOCUMENT},
    {"WebP picture", MAGIC("WEBPVP8"), .offset = 8, .kind = FOREIGN_DOCUMENT},
    {"BMP picture", MAGIC("BM"), .endings = ".bmp .dib", .kind = FOREIGN_DOCUMENT},
    {"film", MAGIC("ftyp"), .offset = 4, .kind = FOREIGN_DOCUMENT},
    {"film", MAGIC("RIFF"), .endings = ".avi", .kind = FOREIGN_DOCUMENT},
    {"Windows program", MAGIC("MZ\x90\0"), .kind = FOREIGN_DOCUMENT},
    {"program", MAGIC("\177ELF"), .kind = FOREIGN_DOCUMENT},
    {"shortcut", MAGIC("L\0\0\0\1\x14\2\0"), .endings = ".lnk", .kind = FOREIGN_DOCUMENT},
    {"SQLite database", MAGIC("SQLite format 3"), .kind = FOREIGN_DOCUMENT},
};

bool foreign_is_binary(const struct scan_file *file)
{
    size_t length = file->length < FOREIGN_LOOKED_AT ? file->length : FOREIGN_LOOKED_AT;
    while (length == file->length && length > 0 && (file->bytes[length - 1] == '\0' || file->bytes[length - 1] == 0x1a))
        length--; /* some programs end a text so */
    for (size_t i = 0; i < length; i++) {
        unsigned char c = (unsigned char)file->bytes[i];
        if (c == '\0' || (c < 0x20 && !strchr("\t\n\v\f\r\x1a\x02\x03\x04", c)))
            return true;
    }
    return false;
}

bool foreign_has_ending(const char *path, const char *endings)
{
    const char *slash = strrchr(path, '/'), *dot = strrchr(slash ? slash + 1 : path, '.');
    return dot && string_view_is_one_of(string_view_of(dot), endings);
}

const struct foreign *foreign_find(const struct scan_file *file)
{
    bool binary = foreign_is_binary(file), archive = scan_tells_at_end(file->bytes, file->length);
    for (const struct foreign *row = rows; row < rows + sizeof rows / sizeof *rows; row++) {
        bool begins = file->length >= row->offset + row->magic_length &&
                      memcmp(file->bytes + row->offset, row->magic ? row->magic : "", row->magic_length) == 0;
        bool holds = row->entry ? archive && memmem(file->bytes, file->length, row->entry, strlen(row->entry))
                                : row->magic || binary;
        if (begins && holds && (!row->endings || foreign_has_ending(file->path, row->endings)))
            return row;
    }
    return NULL;
}
