/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/format.h"
#include "base/limits.h"
#include "base/text.h"

#include <errno.h>
#include <iconv.h>
#include <string.h>
#include <strings.h>

const struct scan_reader scan_readers[] = {
    {"x3p", NULL, scan_x3p_sniff, scan_x3p_read},
    {"mahr-prf", "[p3dlin]", NULL, scan_mahr_prf_read},
    {"sur", "DIGITAL SURF", NULL, scan_sur_read},
    {"sur", "DSCOMPRESSED", NULL, scan_sur_read},
    {"al3d", "AliconaImaging", NULL, scan_al3d_read},
    {"sdf", NULL, scan_sdf_sniff, scan_sdf_read},
    {"gsf", "Gwyddion Simple Field 1.0\n", NULL, scan_gsf_read},
    {"gwy", "GWYPGwyContainer", NULL, scan_gwy_read},
    {"surfer", "DSAA", NULL, scan_surfer_read},
    {"mahr-text", "[PROFILE_HEADER]", NULL, scan_mahr_text_read},
    {"npl-prf", NULL, scan_npl_prf_sniff, scan_npl_prf_read},
    {"smd", NULL, scan_smd_sniff, scan_smd_read},
    {"nist-xml", NULL, scan_nist_xml_sniff, scan_nist_xml_read},
    {"text", NULL, scan_text_sniff, scan_text_read},
};
const size_t scan_reader_count = sizeof scan_readers / sizeof *scan_readers;

static const struct scan_reader *find_reader(const struct scan_file *file)
{
    for (const struct scan_reader *row = scan_readers; row < scan_readers + scan_reader_count; row++)
        if (row->magic ? string_view_starts(scan_view(file), row->magic) : row->sniff(file))
            return row;
    return NULL;
}

/* Does the file begin with a UTF-16 byte order mark, and have an even number of bytes? */
static bool is_utf16(const struct scan_file *file)
{
    return file->length >= 4 && file->length % 2 == 0 &&
           (memcmp(file->bytes, "\xFF\xFE", 2) == 0 || memcmp(file->bytes, "\xFE\xFF", 2) == 0);
}

/* Texts of these names are no scans, whatever numbers are in them. */
static const char other_endings[] = ".md .rst .tex .html .htm .css .js .py .ipynb .m .r .rmd .jl .c .h .cpp .hpp .sh "
                                    ".bat .ps1 .cmake .gp .toml .ini .cfg "
                                    ".yaml .yml .svg .url .bib .log";
static const char *const other_names[] = {"readme",    "license", "licence", "copying",
                                          "changelog", "authors", "makefile"};
/* And these are scans, or damaged ones, even without numbers. */
static const char table_endings[] = ".csv .tsv .dat .asc .xyz .prf .prn .pro .sdf .smd .gsf .grd .sur .al3d";

/* What a text is that is certainly no scan; NULL: it may be one. */
static const char *other_text(const struct scan_file *file, bool whole)
{
    const char *slash = strrchr(file->path, '/'), *name = slash ? slash + 1 : file->path;
    for (size_t i = 0; i < sizeof other_names / sizeof *other_names; i++) {
        size_t length = strlen(other_names[i]);
        if (strncasecmp(name, other_names[i], length) == 0 && strchr(".-_", name[length]))
            return "text";
    }
    if (foreign_has_ending(name, other_endings))
        return "text";
    if (!whole || !strrchr(name, '.') || foreign_has_ending(name, table_endings) || scan_text_has_numbers(file))
        return NULL;
    return "text without a row of numbers";
}

struct format format_of(const struct scan_file *file, bool whole)
{
    if (file->length == 0)
        return (struct format){.kind = FORMAT_UNKNOWN};
    if (is_utf16(file))
        return (struct format){FORMAT_SCAN, "text", NULL, NULL};
    if (file->length > 18 && memcmp(file->bytes, "\x1f\x8b\x08", 3) == 0)
        return (struct format){FORMAT_PACKED, "gz", NULL, NULL};
    const struct scan_reader *reader = find_reader(file);
    bool text = reader && reader->read == scan_text_read;
    const struct foreign *foreign = !reader || text ? foreign_find(file) : NULL;
    const char *other = text ? other_text(file, whole) : NULL;
    if (foreign)
        return (struct format){foreign->kind == FOREIGN_SCAN ? FORMAT_FOREIGN : FORMAT_OTHER, foreign->name, NULL,
                               foreign};
    if (!reader && scan_tells_at_end(file->bytes, file->length))
        return (struct format){FORMAT_PACKED, "zip", NULL, NULL};
    if (!reader)
        return (struct format){.kind = FORMAT_UNKNOWN};
    return (struct format){other ? FORMAT_OTHER : FORMAT_SCAN, other ? other : reader->name, reader, NULL};
}

const char *scan_is_other(const struct scan_bytes *bytes, bool whole)
{
    struct format format =
        format_of(&(struct scan_file){.bytes = bytes->bytes, .length = bytes->length, .path = bytes->path}, whole);
    return format.kind == FORMAT_OTHER ? format.name : NULL;
}

enum status_code format_fail_foreign(const struct scan_file *file, const struct foreign *foreign)
{
    if (foreign->kind == FOREIGN_DOCUMENT && !foreign->remedy)
        return scan_fail(file, 0, "it is no scan: %s", foreign->name);
    return scan_fail(file, 0, "the format is not read here: %s; %s", foreign->name,
                     foreign->remedy ? foreign->remedy : foreign_usual_remedy);
}

/* The same file, which some Windows program wrote in UTF-16, in UTF-8. */
static enum status_code read_utf16(struct scan *out, const struct scan_file *file)
{
    iconv_t convert = iconv_open("UTF-8", "UTF-16");
    if (convert == (iconv_t)-1)
        return scan_fail(file, 0, "cannot convert from UTF-16 (%s); save it as UTF-8", strerror(errno));
    struct text text = {0};
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
    enum status_code code = text.failed ? status_memory(file->status)
                            : stopped   ? scan_fail(file, 0, "damaged UTF-16; save it as UTF-8")
                                        : format_read(out, &utf8);
    text_free(&text);
    return code;
}

enum status_code format_read(struct scan *out, const struct scan_file *file)
{
    if (file->length == 0)
        return scan_fail(file, 0, "the file is empty");
    if (is_utf16(file))
        return read_utf16(out, file);
    struct format format = format_of(file, false);
    if (format.kind == FORMAT_PACKED)
        return scan_fail(file, 0, "a packed file within a packed file%s", limit_words(LIMIT_PACKED_DEPTH).text);
    out->format = format.name;
    if (format.foreign)
        return format_fail_foreign(file, format.foreign);
    if (!format.reader)
        return scan_fail(file, 0, "is a binary file of no known format; %s", foreign_usual_remedy);
    if (format.reader->read(out, file) == STATUS_OK)
        scan_warn_units(out, file);
    return file->status->code;
}
