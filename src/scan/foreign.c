/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/foreign.h"
#include "base/status.h"
#include "scan/archive.h"
#include "scan/reader.h"

#include <string.h>

enum { FOREIGN_LOOKED_AT = 4096 };

const char foreign_usual_remedy[] = "export it as text (x z columns), .sdf, .sur or .x3p";

#define SCAN(name, remedy, magic)                                                                                      \
    {                                                                                                                  \
        name, remedy, magic, sizeof(magic) - 1, 0, NULL, NULL, FOREIGN_SCAN                                            \
    }
#define SCAN_NAMED(name, remedy, endings)                                                                              \
    {                                                                                                                  \
        name, remedy, NULL, 0, 0, endings, NULL, FOREIGN_SCAN                                                          \
    }
#define SCAN_BOTH(name, remedy, m, ending)                                                                             \
    {                                                                                                                  \
        name, remedy, m, sizeof(m) - 1, 0, ending, NULL, FOREIGN_SCAN                                                  \
    }
#define SCAN_ZIP(name, remedy, entry)                                                                                  \
    {                                                                                                                  \
        name, remedy, NULL, 0, 0, NULL, entry, FOREIGN_SCAN                                                            \
    }
#define SCAN_ZIP_NAMED(name, remedy, end)                                                                              \
    {                                                                                                                  \
        name, remedy, "PK\3\4", 4, 0, end, NULL, FOREIGN_SCAN                                                          \
    }
#define OTHER(name, magic)                                                                                             \
    {                                                                                                                  \
        name, NULL, magic, sizeof(magic) - 1, 0, NULL, NULL, FOREIGN_DOCUMENT                                          \
    }
#define OTHER_AT(name, magic, offset)                                                                                  \
    {                                                                                                                  \
        name, NULL, magic, sizeof(magic) - 1, offset, NULL, NULL, FOREIGN_DOCUMENT                                     \
    }
#define OTHER_BOTH(name, magic, endings)                                                                               \
    {                                                                                                                  \
        name, NULL, magic, sizeof(magic) - 1, 0, endings, NULL, FOREIGN_DOCUMENT                                       \
    }
#define OTHER_ZIP(name, remedy, entry)                                                                                 \
    {                                                                                                                  \
        name, remedy, NULL, 0, 0, NULL, entry, FOREIGN_DOCUMENT                                                        \
    }

#define SHEET   "save the sheet with the scan as CSV (x z columns)"
#define BY_GWY  "open it in Gwyddion and save it as .gwy, or export it there as text or .sdf"
#define ODS     "mimetypeapplication/vnd.oasis.opendocument.spreadsheet" /* behind the first entry's header */
#define PROGRAM "write x and z from it as text columns"

/* The first row that fits counts: those with an ending of their own stand before the general ones. */
static const struct foreign rows[] = {
    /* instruments */
    SCAN("Wyko OPD file", "export it in Vision as ASCII or .sdf, or save it as .gwy with Gwyddion", "\1\0Directory"),
    SCAN("Dektak or Bruker OPDx file", "export it in Vision64 as CSV or ASCII, or save it as .gwy with Gwyddion",
         "VCA DATA\1\0\0\x55"),
    SCAN_ZIP("Sensofar PLUX file", "export it in SensoSCAN or SensoVIEW as .sdf, .x3p or text", "LAYER_0.raw"),
    SCAN_ZIP_NAMED("Sensofar PLUX file", "export it in SensoSCAN or SensoVIEW as .sdf, .x3p or text", ".plux"),
    SCAN_NAMED("Sensofar PLU file", "export it in SensoSCAN as .sdf or text, or save it as .gwy with Gwyddion",
               ".plu .apx"),
    SCAN("Zygo MetroPro file", "export it in MetroPro as XYZ text or .sdf, or save it as .gwy with Gwyddion",
         "\x88\x1b\x03\x6f"),
    SCAN("Zygo MetroPro file", "export it in MetroPro as XYZ text or .sdf, or save it as .gwy with Gwyddion",
         "\x88\x1b\x03\x70"),
    SCAN("Zygo MetroPro file", "export it in MetroPro as XYZ text or .sdf, or save it as .gwy with Gwyddion",
         "\x88\x1b\x03\x71"),
    SCAN("FRT MicroProf file", "export it in FRT Mark III as text or .sdf, or save it as .gwy with Gwyddion", "FRTM_"),
    SCAN_NAMED("MountainsMap document", "save the studiable in MountainsMap as .sur, .pro, .sdf or text", ".mnt .mntx"),
    SCAN_BOTH("Igor Pro binary wave", "save the wave in Igor Pro as delimited text", "\2\0", ".ibw .bwav"),
    SCAN_BOTH("Igor Pro binary wave", "save the wave in Igor Pro as delimited text", "\5\0", ".ibw .bwav"),
    SCAN_BOTH("Igor Pro binary wave", "save the wave in Igor Pro as delimited text", "\0\2", ".ibw .bwav"),
    SCAN_BOTH("Igor Pro binary wave", "save the wave in Igor Pro as delimited text", "\0\5", ".ibw .bwav"),
    SCAN("Bruker Nanoscope file", BY_GWY, "\\*File list\r\n"),
    SCAN("Bruker Nanoscope file", BY_GWY, "?*File list\r\n"),
    SCAN("Bruker Nanoscope file", BY_GWY, "\\*EC File list\r\n"),
    SCAN("Bruker Nanoscope force file", BY_GWY, "\\*Force file list\r\n"),
    SCAN_BOTH("JPK image", BY_GWY, "MM\0*", ".jpk .jpk-qi-image"),
    SCAN_ZIP_NAMED("JPK force map", BY_GWY, ".jpk-force .jpk-force-map .jpk-qi-data"),
    SCAN("Keyence VK3 file", "export it in VK Analyzer as CSV, or save it as .gwy with Gwyddion", "VK3_"),
    SCAN("Keyence VK4 file", "export it in VK Analyzer as CSV, or save it as .gwy with Gwyddion", "VK4_"),
    SCAN_BOTH("Keyence VK6 file", "export it in VK Analyzer as CSV, or save it as .gwy with Gwyddion", "VK6", ".vk6"),
    SCAN_BOTH("Keyence VK7 file", "export it in MultiFileAnalyzer as CSV, or save it as .gwy with Gwyddion", "VK7",
              ".vk7"),
    SCAN_BOTH("Olympus LEXT file", "export it in the LEXT software as CSV, or save it as .gwy with Gwyddion", "II*\0",
              ".lext .ols"),
    SCAN_NAMED("Olympus POIR file", "export it in the LEXT software as CSV", ".poir"),
    SCAN("Park Systems PS-PPT file", BY_GWY, "PS-PPT/v1\n"),
    SCAN("Nanosurf file", BY_GWY, "[DataSet]\r\n"),
    SCAN("Nanonis file", BY_GWY, ":NANONIS_VERSION:"),
    SCAN("Molecular Imaging or Agilent MI file", BY_GWY, "fileType      Image"),
    SCAN("Molecular Imaging STP file", BY_GWY, "UK SOFT\r\n"),
    SCAN("Nanotec WSxM file", BY_GWY, "WSxM file copyright"),
    SCAN("Gwyddion file of version 1", "open it in Gwyddion and save it again", "GWYO"),
    SCAN("Gwyddion XYZ file", "rasterize it in Gwyddion and save that as .gwy", "Gwyddion XYZ Field 1.0\n"),
    SCAN_NAMED("NanoFocus NMS file", "export it in the NanoFocus software as .sur, .sdf or text", ".nms"),
    SCAN("ZEISS CZI file", "export its height map in ZEN or ConfoMap as .sur, .x3p or text", "ZISRAWFILE"),
    SCAN("HDF5 file", PROGRAM, "\x89HDF\r\n\x1a\n"),
    SCAN("MATLAB file", "write x and z with writematrix([x z], 'scan.txt')", "MATLAB 5.0 MAT-file"),
    SCAN("MATLAB file", "write x and z with writematrix([x z], 'scan.txt')", "MATLAB 7.3 MAT-file"),
    SCAN_NAMED("MATLAB file", "write x and z with writematrix([x z], 'scan.txt')", ".mat"),
    SCAN("NumPy array", "write x and z with numpy.savetxt('scan.txt', array)", "\x93NUMPY"),
    SCAN_ZIP_NAMED("NumPy archive", "write x and z with numpy.savetxt('scan.txt', array)", ".npz"),
    {"tar archive", "unpack it", "ustar", 5, 257, NULL, NULL, FOREIGN_SCAN},
    SCAN("7-Zip archive", "unpack it", "7z\xbc\xaf\x27\x1c"),
    SCAN("RAR archive", "unpack it", "Rar!\x1a\7"),
    SCAN("bzip2 file", "unpack it, or pack it with gzip or zip", "BZh"),
    SCAN("xz file", "unpack it, or pack it with gzip or zip", "\xfd\x37zXZ\0"),
    SCAN("Zstandard file", "unpack it, or pack it with gzip or zip", "\x28\xb5\x2f\xfd"),
    /* sheets, which may hold a scan, and other documents */
    OTHER_ZIP("Excel workbook", SHEET, "xl/workbook.xml"),
    OTHER_ZIP("Excel workbook", SHEET, "xl/workbook.bin"),
    OTHER_ZIP("Word document", NULL, "word/document.xml"),
    OTHER_ZIP("PowerPoint presentation", NULL, "ppt/presentation.xml"),
    {"OpenDocument spreadsheet", SHEET, ODS, sizeof ODS - 1, 30, NULL, NULL, FOREIGN_DOCUMENT},
    OTHER_AT("OpenDocument file", "mimetypeapplication/vnd.oasis.opendocument", 30),
    {"old Excel workbook", SHEET, "\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", 8, 0, ".xls .xlt", NULL, FOREIGN_DOCUMENT},
    OTHER_BOTH("Office document", "\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", ".doc .ppt .pps .vsd .msg .db .dot .opj"),
    OTHER("PDF document", "%PDF-"),
    OTHER("PostScript file", "%!PS-Adobe"),
    OTHER("RTF document", "{\\rtf"),
    OTHER("PNG picture", "\x89PNG\r\n\x1a\n"),
    OTHER("JPEG picture", "\xff\xd8\xff"),
    OTHER("GIF picture", "GIF87a"),
    OTHER("GIF picture", "GIF89a"),
    OTHER_AT("WebP picture", "WEBPVP8", 8),
    OTHER_BOTH("BMP picture", "BM", ".bmp .dib"),
    OTHER_AT("film", "ftyp", 4),
    OTHER_BOTH("film", "RIFF", ".avi"),
    OTHER("Windows program", "MZ\x90\0"),
    OTHER("program", "\x7f"
                     "ELF"),
    OTHER_BOTH("shortcut", "L\0\0\0\1\x14\2\0", ".lnk"),
    OTHER("SQLite database", "SQLite format 3"),
};

/* A TIFF may be a picture or a map: Park's tag tells. */
static const struct foreign tiff_park = {"Park Systems TIFF", BY_GWY, NULL, 0, 0, NULL, NULL, FOREIGN_SCAN};
static const struct foreign tiff_picture = {"TIFF picture",  "if it holds heights, " BY_GWY, NULL, 0, 0, NULL, NULL,
                                            FOREIGN_DOCUMENT};

bool foreign_is_binary(const struct scan_bytes *file)
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

const char *foreign_remedy(const struct foreign *foreign)
{
    return foreign->remedy ? foreign->remedy : foreign_usual_remedy;
}

static unsigned get_u16(const unsigned char *bytes, bool big)
{
    return big ? (unsigned)bytes[0] << 8 | bytes[1] : (unsigned)bytes[1] << 8 | bytes[0];
}

/* Is tag 50434, Park's heights, in the first directory of this TIFF? */
static bool is_park(const struct scan_bytes *file)
{
    enum { PARK_TAG = 50434, ENTRY = 12 };
    const unsigned char *bytes = (const unsigned char *)file->bytes;
    bool big = bytes[0] == 'M';
    if (file->length < 8)
        return false;
    size_t high = get_u16(bytes + (big ? 4 : 6), big), low = get_u16(bytes + (big ? 6 : 4), big);
    size_t at = high << 16 | low;
    if (at > file->length || file->length - at < 2)
        return false;
    size_t count = get_u16(bytes + at, big), room = (file->length - at - 2) / ENTRY;
    for (size_t i = 0; i < count && i < room; i++)
        if (get_u16(bytes + at + 2 + i * ENTRY, big) == PARK_TAG)
            return true;
    return false;
}

const struct foreign *foreign_find(const struct scan_bytes *file)
{
    bool binary = foreign_is_binary(file), zip = file->length > 4 && memcmp(file->bytes, "PK\3\4", 4) == 0;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const struct foreign *row = &rows[i];
        if (row->entry && !(zip && archive_has(file, row->entry, false, false)))
            continue;
        if (row->endings && !foreign_has_ending(file->path, row->endings))
            continue;
        if (row->magic ? file->length < row->offset + row->magic_length ||
                             memcmp(file->bytes + row->offset, row->magic, row->magic_length) != 0
                       : !binary)
            continue;
        return row;
    }
    if (file->length > 4 && (memcmp(file->bytes, "II*\0", 4) == 0 || memcmp(file->bytes, "MM\0*", 4) == 0))
        return is_park(file) ? &tiff_park : &tiff_picture;
    return NULL;
}
