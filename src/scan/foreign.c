/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/status.h"
#include "scan/format.h"
#include "scan/reader.h"

#include <string.h>

enum { FOREIGN_LOOKED_AT = 4096 };

const char foreign_usual_remedy[] = "export it as text (x z columns), .sdf, .sur or .x3p";

#define MAGIC(bytes) .magic = bytes, .magic_length = sizeof bytes - 1

#define SHEET   "save the sheet with the scan as CSV (x z columns)"
#define BY_GWY  "open it in Gwyddion and save it as .gwy, or export it there as text or .sdf"
#define ODS     "mimetypeapplication/vnd.oasis.opendocument.spreadsheet" /* behind the first entry's header */
#define MATLAB  "write x and z with writematrix([x z], 'scan.txt')"
#define OLE     "\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" /* of old office programs */
#define PROGRAM "write x and z from it as text columns"

/* The first row that fits counts: those with an ending of their own stand before the general ones. */
static const struct foreign rows[] = {
    /* instruments */
    {"Wyko OPD file", "export it in Vision as ASCII or .sdf, or save it as .gwy with Gwyddion", MAGIC("\1\0Directory")},
    {"Dektak or Bruker OPDx file", "export it in Vision64 as CSV or ASCII, or save it as .gwy with Gwyddion",
     MAGIC("VCA DATA\1\0\0\x55")},
    {"Sensofar PLUX file", "export it in SensoSCAN or SensoVIEW as .sdf, .x3p or text", .entry = "LAYER_0.raw"},
    {"Sensofar PLU file", "export it in SensoSCAN as .sdf or text, or save it as .gwy with Gwyddion",
     .endings = ".plu .apx"},
    {"Zygo MetroPro file", "export it in MetroPro as XYZ text or .sdf, or save it as .gwy with Gwyddion",
     MAGIC("\x88\x1b\x03")},
    {"FRT MicroProf file", "export it in FRT Mark III as text or .sdf, or save it as .gwy with Gwyddion",
     MAGIC("FRTM_")},
    {"MountainsMap document", "save the studiable in MountainsMap as .sur, .pro, .sdf or text",
     .endings = ".mnt .mntx"},
    {"Igor Pro binary wave", "save the wave in Igor Pro as delimited text", .endings = ".ibw .bwav"},
    {"Bruker Nanoscope file", BY_GWY, MAGIC("*File list\r\n"), .offset = 1},
    {"Bruker Nanoscope file", BY_GWY, MAGIC("\\*EC File list\r\n")},
    {"Bruker Nanoscope force file", BY_GWY, MAGIC("\\*Force file list\r\n")},
    {"JPK image", BY_GWY, MAGIC("MM\0*"), .endings = ".jpk .jpk-qi-image"},
    {"Keyence VK file", "export it in VK Analyzer or MultiFileAnalyzer as CSV, or save it as .gwy with Gwyddion",
     MAGIC("VK"), .endings = ".vk3 .vk4 .vk6 .vk7"},
    {"Olympus LEXT file", "export it in the LEXT software as CSV, or save it as .gwy with Gwyddion", MAGIC("II*\0"),
     .endings = ".lext .ols"},
    {"Olympus POIR file", "export it in the LEXT software as CSV", .endings = ".poir"},
    {"Park Systems PS-PPT file", BY_GWY, MAGIC("PS-PPT/v1\n")},
    {"Nanosurf file", BY_GWY, MAGIC("[DataSet]\r\n")},
    {"Nanonis file", BY_GWY, MAGIC(":NANONIS_VERSION:")},
    {"Molecular Imaging or Agilent MI file", BY_GWY, MAGIC("fileType      Image")},
    {"Molecular Imaging STP file", BY_GWY, MAGIC("UK SOFT\r\n")},
    {"Nanotec WSxM file", BY_GWY, MAGIC("WSxM file copyright")},
    {"Gwyddion file of version 1", "open it in Gwyddion and save it again", MAGIC("GWYO")},
    {"Gwyddion XYZ file", "rasterize it in Gwyddion and save that as .gwy", MAGIC("Gwyddion XYZ Field 1.0\n")},
    {"NanoFocus NMS file", "export it in the NanoFocus software as .sur, .sdf or text", .endings = ".nms"},
    {"ZEISS CZI file", "export its height map in ZEN or ConfoMap as .sur, .x3p or text", MAGIC("ZISRAWFILE")},
    {"HDF5 file", PROGRAM, MAGIC("\x89HDF\r\n\x1a\n")},
    {"MATLAB file", MATLAB, MAGIC("MATLAB ")},
    {"MATLAB file", MATLAB, .endings = ".mat"},
    {"NumPy array", "write x and z with numpy.savetxt('scan.txt', array)", MAGIC("\x93NUMPY")},
    {"tar archive", "unpack it", MAGIC("ustar"), .offset = 257},
    {"7-Zip archive", "unpack it", MAGIC("7z\xbc\xaf\x27\x1c")},
    {"RAR archive", "unpack it", MAGIC("Rar!\x1a\7")},
    {"bzip2 file", "unpack it, or pack it with gzip or zip", MAGIC("BZh")},
    {"xz file", "unpack it, or pack it with gzip or zip", MAGIC("\xfd\x37zXZ\0")},
    {"Zstandard file", "unpack it, or pack it with gzip or zip", MAGIC("\x28\xb5\x2f\xfd")},
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
    {"TIFF picture", "if it holds heights, " BY_GWY, MAGIC("II*\0"), .kind = FOREIGN_DOCUMENT},
    {"TIFF picture", "if it holds heights, " BY_GWY, MAGIC("MM\0*"), .kind = FOREIGN_DOCUMENT},
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
    bool binary = foreign_is_binary(file), archive = archive_sniff(file);
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
