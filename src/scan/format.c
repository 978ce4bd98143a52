/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/format.h"
#include "base/limits.h"

#include <errno.h>
#include <iconv.h>
#include <string.h>
#include <strings.h>

static const char usual_remedy[] =
    "export it as text (x z columns), .sdf, .sur or .x3p, or save it as .gwy with Gwyddion";

#define MAGIC(bytes) .magic = bytes, .magic_length = sizeof bytes - 1

#define SHEET "save the sheet with the scan as CSV (x z columns)"
#define ODS   "mimetypeapplication/vnd.oasis.opendocument.spreadsheet" /* behind the first entry's header */
#define OLE   "\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"                       /* of old office programs */

/* Does the file begin with a UTF-16 byte order mark, and have an even number of bytes? */
static bool is_utf16(const struct scan_file *file)
{
    return file->length >= 4 && file->length % 2 == 0 &&
           (memcmp(file->bytes, "\xFF\xFE", 2) == 0 || memcmp(file->bytes, "\xFE\xFF", 2) == 0);
}

/* Reads a UTF-16 file, which some Windows program wrote, as UTF-8. */
static enum status_code read_utf16(struct scan *out, const struct scan_file *file)
{
    iconv_t convert = iconv_open("UTF-8", "UTF-16");
    if (convert == (iconv_t)-1)
        return scan_fail(file, 0, "cannot convert from UTF-16 (%s); save it as UTF-8", strerror(errno));
    OWNED(text_free) struct text text = {0};
    char *from = (char *)file->bytes; /* iconv takes the mark off */
    bool stopped = false;             /* at half a surrogate pair */
    for (size_t left = file->length; left > 0 && !stopped;) {
        char piece[4096], *to = piece;
        size_t room = sizeof piece;
        stopped = iconv(convert, &from, &left, &to, &room) == (size_t)-1 && errno != E2BIG;
        text_add_bytes(&text, piece, sizeof piece - room);
    }
    iconv_close(convert);
    struct scan_file utf8 = {text.failed ? "" : text_string(&text), text.length, file->path, file->options,
                             file->status};
    return text.failed ? status_memory(file->status)
           : stopped   ? scan_fail(file, 0, "damaged UTF-16; save it as UTF-8")
                       : format_read(out, &utf8);
}

const struct format format_rows[] = {
    {"text", FORMAT_SCAN, read_utf16, .sniff = is_utf16},
    {"gz", FORMAT_PACKED, MAGIC("\x1f\x8b\x08")},
    {"x3p", FORMAT_SCAN, scan_x3p_read, .sniff = scan_x3p_sniff},
    {"mahr-prf", FORMAT_SCAN, scan_mahr_prf_read, MAGIC("[p3dlin]")},
    {"sur", FORMAT_SCAN, scan_sur_read, MAGIC("DIGITAL SURF")},
    {"sur", FORMAT_SCAN, scan_sur_read, MAGIC("DSCOMPRESSED")},
    {"al3d", FORMAT_SCAN, scan_al3d_read, MAGIC("AliconaImaging")},
    {"sdf", FORMAT_SCAN, scan_sdf_read, .sniff = scan_sdf_sniff},
    {"gsf", FORMAT_SCAN, scan_gsf_read, MAGIC("Gwyddion Simple Field 1.0\n")},
    {"gwy", FORMAT_SCAN, scan_gwy_read, MAGIC("GWYPGwyContainer")},
    {"surfer", FORMAT_SCAN, scan_surfer_read, MAGIC("DSAA")},
    {"mahr-text", FORMAT_SCAN, scan_mahr_text_read, MAGIC("[PROFILE_HEADER]")},
    {"npl-prf", FORMAT_SCAN, scan_npl_prf_read, .sniff = scan_npl_prf_sniff},
    {"smd", FORMAT_SCAN, scan_smd_read, .sniff = scan_smd_sniff},
    {"nist-xml", FORMAT_SCAN, scan_nist_xml_read, .sniff = scan_nist_xml_sniff},
    {"wyko", FORMAT_SCAN, scan_wyko_read, MAGIC("Wyko ASCII Data File Format")},
    {"zygo", FORMAT_SCAN, scan_zygo_read, MAGIC("Zygo ASCII Data File")},
    {"zygo", FORMAT_SCAN, scan_zygo_read, MAGIC("Zygo XYZ Data File")},
    /* instruments */
    {"Wyko OPD file", FORMAT_FOREIGN, MAGIC("\1\0Directory")},
    {"Dektak or Bruker OPDx file", FORMAT_FOREIGN, MAGIC("VCA DATA\1\0\0\x55")},
    {"Sensofar PLUX file", FORMAT_FOREIGN, .entry = "LAYER_0.raw"},
    {"Sensofar PLU file", FORMAT_FOREIGN, .endings = ".plu .apx"},
    {"Zygo MetroPro file", FORMAT_FOREIGN, MAGIC("\x88\x1b\x03")},
    {"FRT MicroProf file", FORMAT_FOREIGN, MAGIC("FRTM_")},
    {"MountainsMap document", FORMAT_FOREIGN, .endings = ".mnt .mntx"},
    {"binary Surfer grid", FORMAT_FOREIGN, MAGIC("DSBB")},
    {"binary Surfer grid", FORMAT_FOREIGN, MAGIC("DSRB")},
    {"Igor Pro binary wave", FORMAT_FOREIGN, .endings = ".ibw .bwav"},
    {"Bruker Nanoscope file", FORMAT_FOREIGN, MAGIC("*File list\r\n"), .offset = 1},
    {"Keyence VK file", FORMAT_FOREIGN, MAGIC("VK"), .endings = ".vk3 .vk4 .vk6 .vk7"},
    {"Olympus LEXT file", FORMAT_FOREIGN, MAGIC("II*\0"), .endings = ".lext .ols"},
    {"Olympus POIR file", FORMAT_FOREIGN, .endings = ".poir"},
    {"NanoFocus NMS file", FORMAT_FOREIGN, .endings = ".nms"},
    {"ZEISS CZI file", FORMAT_FOREIGN, MAGIC("ZISRAWFILE")},
    {"Agilent MI file", FORMAT_FOREIGN, MAGIC("fileType      Image")},
    {"Nanosurf NID file", FORMAT_FOREIGN, MAGIC("[DataSet]")},
    {"WSxM file", FORMAT_FOREIGN, MAGIC("WSxM file copyright")},
    {"TrueMap TMD file", FORMAT_FOREIGN, MAGIC("Binary TrueMap Data File")},
    {"BCRF file", FORMAT_FOREIGN, MAGIC("fileformat = bcr")},
    {"NetCDF file", FORMAT_FOREIGN, MAGIC("CDF\1")},
    {"NetCDF file", FORMAT_FOREIGN, MAGIC("CDF\2")},
    {"HDF5 file", FORMAT_FOREIGN, MAGIC("\x89HDF\r\n\x1a\n")},
    {"MATLAB file", FORMAT_FOREIGN, MAGIC("MATLAB ")},
    {"NumPy array", FORMAT_FOREIGN, MAGIC("\x93NUMPY")},
    {"tar archive", FORMAT_FOREIGN, .remedy = "unpack it", MAGIC("ustar"), .offset = 257},
    {"7-Zip archive", FORMAT_FOREIGN, .remedy = "unpack it", MAGIC("7z\xbc\xaf\x27\x1c")},
    {"RAR archive", FORMAT_FOREIGN, .remedy = "unpack it", MAGIC("Rar!\x1a\7")},
    {"bzip2 file", FORMAT_FOREIGN, .remedy = "unpack it", MAGIC("BZh")},
    {"xz file", FORMAT_FOREIGN, .remedy = "unpack it", MAGIC("\xfd\x37zXZ\0")},
    /* sheets, which may hold a scan, and other documents */
    {"Excel workbook", FORMAT_OTHER, .remedy = SHEET, .entry = "xl/workbook.xml"},
    {"Word document", FORMAT_OTHER, .entry = "word/document.xml"},
    {"PowerPoint presentation", FORMAT_OTHER, .entry = "ppt/presentation.xml"},
    {"OpenDocument spreadsheet", FORMAT_OTHER, .remedy = SHEET, MAGIC(ODS), .offset = 30},
    {"OpenDocument file", FORMAT_OTHER, MAGIC("mimetypeapplication/vnd.oasis.opendocument"), .offset = 30},
    {"old Excel workbook", FORMAT_OTHER, .remedy = SHEET, MAGIC(OLE), .endings = ".xls .xlt"},
    {"Office document", FORMAT_OTHER, MAGIC(OLE), .endings = ".doc .ppt .pps .vsd .msg .db .dot .opj"},
    {"PDF document", FORMAT_OTHER, MAGIC("%PDF-")},
    {"PostScript file", FORMAT_OTHER, MAGIC("%!PS-Adobe")},
    {"RTF document", FORMAT_OTHER, MAGIC("{\\rtf")},
    {"PNG picture", FORMAT_OTHER, MAGIC("\x89PNG\r\n\x1a\n")},
    {"JPEG picture", FORMAT_OTHER, MAGIC("\xff\xd8\xff")},
    {"GIF picture", FORMAT_OTHER, MAGIC("GIF8")},
    {"TIFF picture", FORMAT_OTHER, MAGIC("II*\0")},
    {"TIFF picture", FORMAT_OTHER, MAGIC("MM\0*")},
    {"WebP picture", FORMAT_OTHER, MAGIC("WEBPVP8"), .offset = 8},
    {"BMP picture", FORMAT_OTHER, MAGIC("BM"), .endings = ".bmp .dib"},
    {"film", FORMAT_OTHER, MAGIC("ftyp"), .offset = 4},
    {"film", FORMAT_OTHER, MAGIC("RIFF"), .endings = ".avi"},
    {"Windows program", FORMAT_OTHER, MAGIC("MZ\x90\0")},
    {"program", FORMAT_OTHER, MAGIC("\177ELF")},
    {"shortcut", FORMAT_OTHER, MAGIC("L\0\0\0\1\x14\2\0"), .endings = ".lnk"},
    {"SQLite database", FORMAT_OTHER, MAGIC("SQLite format 3")},
    /* what no other row knows */
    {"zip", FORMAT_PACKED, MAGIC("PK\3\4")},
    {"dektak", FORMAT_SCAN, scan_text_read, MAGIC("Scan Parameters")}, /* Bruker: keys, titles with units, x and z */
    {"hommel", FORMAT_SCAN, scan_text_read, MAGIC("X;Y;valid")},       /* x, z, 1 where the point is valid */
    {"text", FORMAT_SCAN, scan_text_read, .sniff = scan_text_sniff},
};
const size_t format_count = sizeof format_rows / sizeof *format_rows;

/* Does the name end in one of `endings` (".a .b", ASCII case ignored)? */
static bool has_ending(const char *path, const char *endings)
{
    const char *slash = strrchr(path, '/'), *dot = strrchr(slash ? slash + 1 : path, '.');
    return dot && string_view_is_one_of(string_view_of(dot), endings);
}

/* Is the file of that format? A row without magic and entry takes binary files only. */
static bool is_format(const struct format *row, const struct scan_file *file, bool binary)
{
    if (row->sniff)
        return row->sniff(file);
    if (row->read)
        return string_view_starts(scan_view(file), row->magic);
    bool begins = file->length >= row->offset + row->magic_length &&
                  memcmp(file->bytes + row->offset, row->magic ? row->magic : "", row->magic_length) == 0;
    bool holds = row->entry ? scan_tells_at_end(file->bytes, file->length) &&
                                  memmem(file->bytes, file->length, row->entry, strlen(row->entry))
                            : row->magic || binary;
    return begins && holds && (!row->endings || has_ending(file->path, row->endings));
}

/* Texts with these names are no scans, even with numbers in them. */
static const char other_endings[] = ".md .rst .tex .html .htm .css .js .py .ipynb .m .r .rmd .jl .c .h .cpp .hpp .sh "
                                    ".bat .ps1 .cmake .gp .toml .ini .cfg "
                                    ".yaml .yml .svg .url .bib .log";
static const char *const other_names[] = {"readme",    "license", "licence", "copying",
                                          "changelog", "authors", "makefile"};
/* Texts with these are scans or damaged ones, even without numbers. */
static const char table_endings[] = ".csv .tsv .dat .asc .xyz .prf .prn .pro .sdf .smd .gsf .grd .sur .al3d";

/* What a text is that is no scan; NULL: it may be one. */
static const char *other_text(const struct scan_file *file, bool whole)
{
    const char *slash = strrchr(file->path, '/'), *name = slash ? slash + 1 : file->path;
    for (size_t i = 0; i < sizeof other_names / sizeof *other_names; i++) {
        size_t length = strlen(other_names[i]);
        if (strncasecmp(name, other_names[i], length) == 0 && strchr(".-_", name[length]))
            return "text";
    }
    if (has_ending(name, other_endings))
        return "text";
    if (!whole || !strrchr(name, '.') || has_ending(name, table_endings) || scan_text_has_numbers(file))
        return NULL;
    return "text without a row of numbers";
}

struct format format_of(const struct scan_file *file, bool whole)
{
    const struct format *row = format_rows, *end = format_rows + format_count;
    bool binary = !scan_text_sniff(file);
    while (row < end && (file->length == 0 || !is_format(row, file, binary)))
        row++;
    struct format format = row < end ? *row : (struct format){.kind = FORMAT_UNKNOWN};
    const char *other = format.read == scan_text_read ? other_text(file, whole) : NULL;
    if (other) {
        format.kind = FORMAT_OTHER;
        format.name = other;
    }
    return format;
}

const char *scan_is_other(const struct scan_bytes *bytes, bool whole)
{
    struct format format =
        format_of(&(struct scan_file){.bytes = bytes->bytes, .length = bytes->length, .path = bytes->path}, whole);
    return format.kind == FORMAT_OTHER ? format.name : NULL;
}

enum status_code format_refuse(const struct scan_file *file, const struct format *format)
{
    if (format->kind == FORMAT_UNKNOWN)
        return scan_fail(file, 0, "is a binary file of no known format; %s", usual_remedy);
    if (format->kind == FORMAT_OTHER && !format->remedy)
        return scan_fail(file, 0, "it is no scan: %s", format->name);
    return scan_fail(file, 0, "the format is not read here: %s; %s", format->name,
                     format->remedy ? format->remedy : usual_remedy);
}

enum status_code format_read(struct scan *out, const struct scan_file *file)
{
    struct format format = format_of(file, false);
    if (file->length == 0)
        return scan_fail(file, 0, "the file is empty");
    if (format.kind == FORMAT_PACKED)
        return scan_fail(file, 0, "a packed file within a packed file%s", limit_words(LIMIT_PACKED_DEPTH).text);
    out->format = format.name;
    if (!format.read)
        return format_refuse(file, &format);
    if (format.read(out, file) == STATUS_OK && format.read != read_utf16) /* which has warned already */
        scan_warn_units(out, file);
    return file->status->code;
}
