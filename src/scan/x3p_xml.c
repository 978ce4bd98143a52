#include "scan/x3p_xml.h"
#include "scan/number.h"
#include "scan/reader.h"

#include <expat.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { X3P_PATH = 256, X3P_TEXT = 256 };

struct parse {
    struct x3p_xml *out;
    XML_Parser parser;
    char path[X3P_PATH]; /* names of the open elements, each after a '/' */
    size_t hidden;       /* open elements deeper than `path` has room for */
    char text[X3P_TEXT]; /* of the innermost element */
    size_t length;
    const char *problem; /* NULL, or why parsing was stopped */
    bool memory;         /* an allocation failed */
};

static void stop(struct parse *parse, const char *problem)
{
    parse->problem = problem;
    XML_StopParser(parse->parser, XML_FALSE);
}

static void XMLCALL on_start(void *user, const XML_Char *name, const XML_Char **attributes)
{
    (void)attributes;
    struct parse *parse = user;
    const char *colon = strrchr(name, ':'); /* the prefix of the name space is the writer's choice */
    size_t used = strlen(parse->path);
    name = colon ? colon + 1 : name;
    parse->length = 0;
    if (parse->hidden > 0 || used + strlen(name) + 2 > sizeof parse->path)
        parse->hidden++;
    else
        snprintf(parse->path + used, sizeof parse->path - used, "/%s", name);
}

static void XMLCALL on_text(void *user, const XML_Char *text, int length)
{
    struct parse *parse = user;
    size_t room = sizeof parse->text - 1 - parse->length, count = (size_t)length < room ? (size_t)length : room;
    memcpy(parse->text + parse->length, text, count);
    parse->length += count;
}

/* `value` or `value;value`: a stored x, if any, comes first and z last. An empty datum is a missing point. */
static void add_datum(struct parse *parse, struct string_view text)
{
    struct x3p_xml *out = parse->out;
    double point[2] = {0.0, NAN};
    size_t count = 0;
    for (struct string_view cell; cell_next(&text, ';', &cell); count++) {
        if (!number_read(cell, &point[1])) {
            stop(parse, "a <Datum> that is no number");
            return;
        }
        if (count == 0)
            point[0] = point[1];
    }
    if (out->datum_count == out->datum_capacity) {
        size_t capacity = out->datum_capacity ? 2 * out->datum_capacity : 256;
        double *datum = reallocarray(out->datum, capacity, sizeof point);
        if (!datum) {
            parse->memory = true;
            stop(parse, "out of memory");
            return;
        }
        out->datum = datum;
        out->datum_capacity = capacity;
    }
    memcpy(out->datum + 2 * out->datum_count++, point, sizeof point);
}

/* Takes the text of a leaf over where its path ends as one of these; numbers that are missing or empty keep what they
 * were set to before. */
static void take_leaf(struct parse *parse, struct string_view text)
{
    struct x3p_xml *out = parse->out;
    struct {
        const char *end;
        char *string;
        size_t size;
        double *number;
    } leaves[] = {
        {"/FeatureType", out->feature, sizeof out->feature, NULL},
        {"/CX/AxisType", &out->axis[0].kind, 1, NULL},
        {"/CY/AxisType", &out->axis[1].kind, 1, NULL},
        {"/CZ/AxisType", &out->axis[2].kind, 1, NULL},
        {"/CX/DataType", &out->axis[0].type, 1, NULL},
        {"/CY/DataType", &out->axis[1].type, 1, NULL},
        {"/CZ/DataType", &out->axis[2].type, 1, NULL},
        {"/CX/Increment", NULL, 0, &out->axis[0].increment},
        {"/CY/Increment", NULL, 0, &out->axis[1].increment},
        {"/CZ/Increment", NULL, 0, &out->axis[2].increment},
        {"/CX/Offset", NULL, 0, &out->axis[0].offset},
        {"/CY/Offset", NULL, 0, &out->axis[1].offset},
        {"/CZ/Offset", NULL, 0, &out->axis[2].offset},
        {"/MatrixDimension/SizeX", NULL, 0, &out->size[0]},
        {"/MatrixDimension/SizeY", NULL, 0, &out->size[1]},
        {"/MatrixDimension/SizeZ", NULL, 0, &out->size[2]},
        {"/Record3/ListDimension", NULL, 0, &out->list},
        {"/DataLink/PointDataLink", out->data_link, sizeof out->data_link, NULL},
        {"/DataLink/ValidPointsLink", out->valid_link, sizeof out->valid_link, NULL},
        {"/DataLink/MD5ChecksumPointData", out->data_md5, sizeof out->data_md5, NULL},
    };
    size_t used = strlen(parse->path);
    for (size_t i = 0; i < sizeof leaves / sizeof *leaves; i++) {
        size_t length = strlen(leaves[i].end);
        if (used < length || strcmp(parse->path + used - length, leaves[i].end) != 0 || text.start == text.end)
            continue;
        if (leaves[i].size == 1)
            *leaves[i].string = *text.start;
        else if (leaves[i].string)
            scan_copy(leaves[i].string, leaves[i].size, text);
        else if (!number_read(text, leaves[i].number))
            stop(parse, "text where a number should be");
    }
}

static void XMLCALL on_end(void *user, const XML_Char *name)
{
    (void)name;
    struct parse *parse = user;
    struct string_view text = string_view_trim((struct string_view){parse->text, parse->text + parse->length});
    while (text.start < text.end && *text.start == '\n')
        text = string_view_trim((struct string_view){text.start + 1, text.end});
    while (text.end > text.start && text.end[-1] == '\n')
        text = string_view_trim((struct string_view){text.start, text.end - 1});
    parse->length = 0;
    if (parse->hidden > 0) {
        parse->hidden--;
        return;
    }
    char *last = strrchr(parse->path, '/');
    if (strcmp(last, "/Datum") == 0)
        add_datum(parse, text);
    else
        take_leaf(parse, text);
    *last = '\0';
}

/* X3P declares no entities; files that do want to make little bytes large. */
static void XMLCALL on_entity(void *user, const XML_Char *name, int is_parameter, const XML_Char *value, int length,
                              const XML_Char *base, const XML_Char *system, const XML_Char *public,
                              const XML_Char *notation)
{
    (void)name, (void)is_parameter, (void)value, (void)length, (void)base, (void)system, (void)public, (void)notation;
    stop(user, "an entity declaration");
}

enum status_code x3p_xml_read(struct x3p_xml *out, const struct text *xml, const struct scan_bytes *file,
                              struct status *status)
{
    *out = (struct x3p_xml){0};
    for (size_t i = 0; i < 3; i++)
        out->axis[i] = (struct x3p_axis){'A', 'D', 1.0, 0.0};
    struct parse parse = {.out = out, .parser = XML_ParserCreate(NULL)};
    if (!parse.parser)
        return status_memory(status);
    XML_SetUserData(parse.parser, &parse);
    XML_SetElementHandler(parse.parser, on_start, on_end);
    XML_SetCharacterDataHandler(parse.parser, on_text);
    XML_SetEntityDeclHandler(parse.parser, on_entity);
    /* in pieces: the length is an int */
    enum XML_Status good = XML_STATUS_OK;
    for (size_t at = 0; good == XML_STATUS_OK && at <= xml->length; at += 1 << 20) {
        size_t left = xml->length - at, piece = left < 1 << 20 ? left : 1 << 20;
        good = XML_Parse(parse.parser, text_string(xml) + at, (int)piece, piece == left);
    }
    if (parse.memory)
        status_memory(status);
    else if (good != XML_STATUS_OK)
        scan_fail(status, file, 0, "main.xml, line %lu: %s; export the scan again",
                  (unsigned long)XML_GetCurrentLineNumber(parse.parser),
                  parse.problem ? parse.problem : XML_ErrorString(XML_GetErrorCode(parse.parser)));
    XML_ParserFree(parse.parser);
    return status->code;
}

void x3p_xml_free(struct x3p_xml *xml)
{
    free(xml->datum);
    xml->datum = NULL;
}
