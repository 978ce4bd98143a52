/* SPDX-License-Identifier: GPL-3.0-or-later */
/* ISO 25178-72 X3P: a zip archive with main.xml (perhaps in a folder) and the points, in metres, in main.xml or in a
 * binary file. Each point has the values of the stored axes (kind A); a coordinate is value x increment + offset. */
#include "base/limits.h"
#include "scan/reader.h"

#include <ctype.h>
#include <expat.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* What main.xml says. */
struct x3p_axis {
    char kind; /* 'I': increment x index, 'A': stored for each point */
    char type; /* of stored values: 'I' int16, 'L' int32, 'F' float, 'D' double */
    double increment, offset;
};

struct main_xml {
    char feature[8]; /* PRF, SUR or PCL */
    struct x3p_axis axis[3];
    double size[3]; /* of the matrix; 0 where there is none */
    double list;    /* points of a list; 0 where there is none */
    char data_link[256], valid_link[256];
    struct text listed; /* of <DataList>, two doubles each: x, 0 where it is not stored, z, NaN where not measured */
};

struct x3p {
    struct archive archive;
    struct text main, points, valid;
    struct main_xml xml;
    char folder[256]; /* of main.xml, with its last '/' */
};

/* Is it an archive with main.xml? In a damaged one that name counts wherever it stands. */
bool scan_x3p_sniff(const struct scan_file *file)
{
    struct archive archive;
    struct status ignored = {0};
    struct scan_file quiet = *file;
    quiet.status = &ignored;
    if (!scan_tells_at_end(file->bytes, file->length) || !memmem(file->bytes, file->length, "main.xml", 8))
        return false;
    bool found =
        archive_open(&archive, &quiet) != STATUS_OK || archive_find(&archive, "main.xml", true) < archive.count;
    archive_close(&archive);
    return found;
}

enum { X3P_DEPTH = 64, X3P_NAME = 32, X3P_TEXT = 256 }; /* LIMIT_XML_DEPTH allows that depth */

struct parse {
    struct main_xml *out;
    XML_Parser parser;
    char name[X3P_DEPTH + 1][X3P_NAME]; /* of the open elements, from 1; long ones are cut off */
    size_t depth, elements;             /* open elements; all, with attributes */
    char text[X3P_TEXT];                /* of the innermost element */
    size_t length;
    const struct scan_file *file;
};

static const char export_again[] = "; export the scan again";

static void stop(struct parse *parse, const char *problem, const char *remedy)
{
    scan_fail(parse->file, 0, "main.xml, line %lu: %s%s", (unsigned long)XML_GetCurrentLineNumber(parse->parser),
              problem, remedy);
    XML_StopParser(parse->parser, XML_FALSE);
}

static void XMLCALL on_start(void *user, const XML_Char *name, const XML_Char **attributes)
{
    (void)attributes;
    struct parse *parse = user;
    parse->elements += 1 + (size_t)XML_GetSpecifiedAttributeCount(parse->parser) / 2;
    if (parse->depth == X3P_DEPTH || parse->depth == limit_most(LIMIT_XML_DEPTH)) {
        stop(parse, "elements within elements", limit_words(LIMIT_XML_DEPTH).text);
    } else if (parse->elements > limit_most(LIMIT_XML_ELEMENTS)) {
        stop(parse, "too many elements", limit_words(LIMIT_XML_ELEMENTS).text);
    } else {
        const char *colon = strrchr(name, ':'); /* whatever the prefix of the name space is */
        snprintf(parse->name[++parse->depth], X3P_NAME, "%s", colon ? colon + 1 : name);
        parse->length = 0;
    }
}

static void XMLCALL on_text(void *user, const XML_Char *text, int length)
{
    struct parse *parse = user;
    size_t room = sizeof parse->text - 1 - parse->length, count = (size_t)length < room ? (size_t)length : room;
    memcpy(parse->text + parse->length, text, count);
    parse->length += count;
}

/* `z` or `x;z`. An empty datum is a missing point. */
static void add_datum(struct parse *parse, struct string_view text)
{
    double point[2] = {0.0, NAN};
    bool first = true;
    for (struct string_view cell; cell_next(&text, ';', &cell); first = false) {
        if (!number_read(cell, &point[1])) {
            stop(parse, "a <Datum> that is no number", export_again);
            return;
        }
        point[0] = first ? point[1] : point[0];
    }
    text_add_bytes(&parse->out->listed, (const char *)point, sizeof point);
}

/* Takes over the text of an element by its name and its parent's; an empty one changes nothing. */
static void take_leaf(struct parse *parse, const char *parent, const char *name, struct string_view text)
{
    struct main_xml *out = parse->out;
    const char *letter = parent[0] == 'C' && parent[1] && !parent[2] ? strchr("XYZ", parent[1]) : NULL;
    struct x3p_axis none = {0}, *axis = letter ? &out->axis[letter - "XYZ"] : &none;
    const char *const own = letter ? parent : ""; /* name of the axis */
    const struct {
        const char *parent, *name;
        char *string;
        size_t size;
        double *number;
    } leaves[] = {
        {"Record1", "FeatureType", out->feature, sizeof out->feature, NULL},
        {own, "AxisType", &axis->kind, 1, NULL},
        {own, "DataType", &axis->type, 1, NULL},
        {own, "Increment", NULL, 0, &axis->increment},
        {own, "Offset", NULL, 0, &axis->offset},
        {"MatrixDimension", "SizeX", NULL, 0, &out->size[0]},
        {"MatrixDimension", "SizeY", NULL, 0, &out->size[1]},
        {"MatrixDimension", "SizeZ", NULL, 0, &out->size[2]},
        {"Record3", "ListDimension", NULL, 0, &out->list},
        {"DataLink", "PointDataLink", out->data_link, sizeof out->data_link, NULL},
        {"DataLink", "ValidPointsLink", out->valid_link, sizeof out->valid_link, NULL},
    };
    for (size_t i = 0; i < sizeof leaves / sizeof *leaves; i++) {
        if (strcmp(leaves[i].name, name) != 0 || strcmp(leaves[i].parent, parent) != 0 || text.start == text.end)
            continue;
        if (leaves[i].size == 1)
            *leaves[i].string = *text.start;
        else if (leaves[i].string)
            scan_copy(leaves[i].string, leaves[i].size, text);
        else if (!number_read(text, leaves[i].number))
            stop(parse, "text where a number should be", export_again);
    }
}

static void XMLCALL on_end(void *user, const XML_Char *name)
{
    (void)name;
    struct parse *parse = user;
    if (parse->file->status->code != STATUS_OK) /* stopped at this element's start */
        return;
    struct string_view text = {parse->text, parse->text + parse->length};
    while (text.start < text.end && isspace((unsigned char)*text.start))
        text.start++;
    while (text.start < text.end && isspace((unsigned char)text.end[-1]))
        text.end--;
    const char *own = parse->name[parse->depth], *parent = parse->name[parse->depth - 1];
    parse->length = 0;
    parse->depth--;
    if (strcmp(own, "Datum") == 0)
        add_datum(parse, text);
    else
        take_leaf(parse, parent, own, text);
}

/* X3P has none, and one may be made to take a parser's time: entities of entities, attributes for every element. */
static void XMLCALL on_doctype(void *user, const XML_Char *name, const XML_Char *system, const XML_Char *public,
                               int has_declarations)
{
    (void)name, (void)system, (void)public, (void)has_declarations;
    stop(user, "a DOCTYPE", export_again);
}

/* main.xml; `out->listed` is to be freed whatever comes back. */
static enum status_code read_xml(struct main_xml *out, const struct text *xml, const struct scan_file *file)
{
    *out = (struct main_xml){0};
    for (size_t i = 0; i < 3; i++)
        out->axis[i] = (struct x3p_axis){'A', 'D', NAN, 0.0};
    struct parse parse = {.out = out, .parser = XML_ParserCreate(NULL), .file = file};
    if (!parse.parser)
        return status_memory(file->status);
    XML_SetUserData(parse.parser, &parse);
    XML_SetElementHandler(parse.parser, on_start, on_end);
    XML_SetCharacterDataHandler(parse.parser, on_text);
    XML_SetStartDoctypeDeclHandler(parse.parser, on_doctype);
    /* in pieces, so that a tag that is too long is not read to its end */
    enum { PIECE = 65536 };
    enum XML_Status good = XML_STATUS_OK;
    for (size_t at = 0; good == XML_STATUS_OK && at <= xml->length; at += PIECE) {
        size_t left = xml->length - at, piece = left < PIECE ? left : PIECE;
        good = XML_Parse(parse.parser, text_string(xml) + at, (int)piece, piece == left);
        if (good == XML_STATUS_OK &&
            at > (size_t)XML_GetCurrentByteIndex(parse.parser) + limit_most(LIMIT_XML_TAG_BYTES)) {
            stop(&parse, "too long a tag", limit_words(LIMIT_XML_TAG_BYTES).text);
            good = XML_STATUS_ERROR;
        }
    }
    if (out->listed.failed)
        (void)status_memory(file->status);
    else if (good != XML_STATUS_OK && file->status->code == STATUS_OK)
        stop(&parse, XML_ErrorString(XML_GetErrorCode(parse.parser)), export_again);
    XML_ParserFree(parse.parser);
    return file->status->code;
}

static bool stored(const struct x3p_axis *axis)
{
    return axis->kind == 'A';
}

/* Unpacks up to `most` bytes of the file that a link in main.xml names, which is relative to main.xml. */
static enum status_code read_link(struct text *text, const struct x3p *x3p, const char *link, size_t most,
                                  const struct scan_file *file)
{
    char path[512];
    snprintf(path, sizeof path, "%s%s", x3p->folder, link);
    size_t index = archive_find(&x3p->archive, path, false), count = x3p->archive.count;
    if (index == count)
        index = archive_find(&x3p->archive, link, false);
    if (index == count)
        return scan_fail(file, 0, "no '%.80s' in the archive, which main.xml names", link);
    return archive_read(text, &x3p->archive, index, most, file);
}

static enum status_code open_main(struct x3p *x3p, const struct scan_file *file)
{
    if (archive_open(&x3p->archive, file) != STATUS_OK)
        return file->status->code;
    size_t index = archive_find(&x3p->archive, "main.xml", true), count = x3p->archive.count;
    if (index == count)
        return scan_fail(file, 0, "no main.xml in the archive");
    if (x3p->archive.entries[index].size > limit_most(LIMIT_XML_BYTES))
        return scan_fail(file, 0, "main.xml is too large%s", limit_words(LIMIT_XML_BYTES).text);
    const char *name = x3p->archive.entries[index].name, *slash = strrchr(name, '/');
    scan_copy(x3p->folder, sizeof x3p->folder, (struct string_view){name, slash ? slash + 1 : name});
    if (archive_read(&x3p->main, &x3p->archive, index, SIZE_MAX, file) != STATUS_OK)
        return file->status->code;
    return read_xml(&x3p->xml, &x3p->main, file);
}

/* Points in a row and rows; refuses what cannot be read. */
static enum status_code read_size(const struct main_xml *xml, double *nx, double *ny, const struct scan_file *file)
{
    bool profile = strcmp(xml->feature, "PRF") == 0;
    if (!profile && strcmp(xml->feature, "SUR") != 0)
        return scan_fail(file, 0, "feature type '%s' is neither profile (PRF) nor surface (SUR); export one",
                         scan_quote((struct string_view){xml->feature, xml->feature + strlen(xml->feature)}).text);
    double x = xml->list > 0 ? xml->list : xml->size[0], y = xml->list > 0 ? 1 : xml->size[1];
    double z = xml->list > 0 || xml->size[2] == 0 ? 1 : xml->size[2];
    if (!(x >= 1 && y >= 1) || z != 1 || (profile && y != 1))
        return scan_fail(file, 0, "%g x %g x %g points are no %s", x, y, z,
                         profile ? "profile" : "surface of one layer");
    if (!stored(&xml->axis[2]))
        return scan_fail(file, 0, "no heights: CZ is no absolute axis");
    if (y > 1 && (stored(&xml->axis[0]) || stored(&xml->axis[1])))
        return scan_fail(file, 0, "positions stored point by point: only surfaces on a grid can be read");
    *nx = x;
    *ny = y;
    return scan_check_points(x, y, file);
}

static double scaled(const struct x3p_axis *axis, double value)
{
    double result = value * (isnan(axis->increment) ? 1 : axis->increment) + axis->offset;
    return isfinite(result) ? result : NAN;
}

/* The types of the stored axes, and the bytes of a point. */
static enum status_code find_types(enum bytes_type type[3], size_t *size, const struct x3p_axis axis[3],
                                   const struct scan_file *file)
{
    static const char letters[] = "ILFD";
    static const enum bytes_type types[] = {BYTES_I16, BYTES_I32, BYTES_F32, BYTES_F64};
    *size = 0;
    for (size_t i = 0; i < 3; i++) {
        const char *found = strchr(letters, axis[i].type);
        if (!found)
            return scan_fail(file, 0, "data type '%c' is none of ISO 25178-72", axis[i].type);
        type[i] = types[found - letters];
        *size += stored(&axis[i]) ? bytes_size(type[i]) : 0;
    }
    return STATUS_OK;
}

/* Reads the points from the file that main.xml names or, if it names none, from main.xml. */
static enum status_code read_values(struct scan *out, struct x3p *x3p, double nx, double ny,
                                    const struct scan_file *file)
{
    const struct main_xml *xml = &x3p->xml;
    const struct x3p_axis *axis = xml->axis;
    enum bytes_type type[3];
    bool listed = !*xml->data_link;
    size_t size = 1;
    if (!listed && (find_types(type, &size, axis, file) != STATUS_OK ||
                    read_link(&x3p->points, x3p, xml->data_link, (size_t)(nx * ny) * size, file) != STATUS_OK))
        return file->status->code;
    struct bytes bytes = {text_string(&x3p->points), text_string(&x3p->points) + x3p->points.length, false};
    const double *point = (const void *)xml->listed.data;
    size_t room = listed ? xml->listed.length / sizeof *point / 2 : bytes_left(&bytes) / size;
    if ((stored(&axis[0]) ? scan_reserve_x(out, nx, room, file) : scan_reserve(out, nx, ny, room, file)) != STATUS_OK)
        return file->status->code;
    for (size_t i = 0; i < out->nx * out->ny; i++) {
        double value[3] = {0};
        for (size_t k = 0; k < 3; k++)
            if (stored(&axis[k]))
                value[k] = listed ? point[2 * i + k / 2] : bytes_number(&bytes, type[k]);
        out->z_m[i] = scaled(&axis[2], value[2]);
        if (out->x_m)
            out->x_m[i] = scaled(&axis[0], value[0]);
    }
    return STATUS_OK;
}

/* valid.bin: bit i, counted from the lowest of the first byte, says whether point i was measured. */
static enum status_code read_valid(struct scan *out, struct x3p *x3p, const struct scan_file *file)
{
    if (!*x3p->xml.valid_link)
        return STATUS_OK;
    size_t points = out->nx * out->ny;
    if (read_link(&x3p->valid, x3p, x3p->xml.valid_link, points, file) != STATUS_OK)
        return file->status->code;
    if (x3p->valid.length < (points + 7) / 8)
        return scan_fail(file, 0, "'%.80s' holds fewer bits than there are points", x3p->xml.valid_link);
    for (size_t i = 0; i < points; i++)
        if (!((unsigned char)x3p->valid.data[i / 8] >> i % 8 & 1))
            out->z_m[i] = NAN;
    return STATUS_OK;
}

enum status_code scan_x3p_read(struct scan *out, const struct scan_file *file)
{
    struct x3p x3p = {0};
    double nx = 0, ny = 0;
    if (open_main(&x3p, file) == STATUS_OK && read_size(&x3p.xml, &nx, &ny, file) == STATUS_OK &&
        read_values(out, &x3p, nx, ny, file) == STATUS_OK && read_valid(out, &x3p, file) == STATUS_OK) {
        out->dx_m = x3p.xml.axis[0].increment;
        out->dy_m = x3p.xml.axis[1].increment;
        scan_set_units(out, "m", "m");
    }
    text_free(&x3p.main);
    text_free(&x3p.points);
    text_free(&x3p.valid);
    text_free(&x3p.xml.listed);
    archive_close(&x3p.archive);
    return file->status->code;
}
