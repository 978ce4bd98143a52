/* SPDX-License-Identifier: GPL-3.0-or-later */
/* XML of the NIST surface metrology database: <UNITS>, <NUMPOINTS>, <SPACING> and blocks of heights, a line each: the
 * profile as measured, and perhaps its roughness or waviness. */
#include "scan/reader.h"

#include <math.h>
#include <string.h>

enum { NIST_SNIFF = 65536 };

/* The first block with heights in it is read; the format's name says which. */
static const struct {
    const char *tag, *format;
} nist_blocks[] = {
    {"DATA_POINT_VALUES", "nist-xml (DATA_POINT_VALUES)"},
    {"ROUGHNESS_DATA_POINT_VALUES", "nist-xml (ROUGHNESS_DATA_POINT_VALUES)"},
    {"WAVINESS_DATA_POINT_VALUES", "nist-xml (WAVINESS_DATA_POINT_VALUES)"},
};

bool scan_nist_xml_sniff(const struct scan_file *file)
{
    size_t length = file->length < NIST_SNIFF ? file->length : NIST_SNIFF;
    return string_view_starts(scan_view(file), "<") && memmem(file->bytes, length, "<DATAFILE>", 10) != NULL &&
           memmem(file->bytes, length, "DATA_POINT_VALUES", 17) != NULL;
}

static const char *find(struct string_view text, const char *what)
{
    return memmem(text.start, string_view_length(text), what, strlen(what));
}

/* What stands between the first <tag> in `text` and </tag>; empty: there is none. */
static struct string_view element(struct string_view text, const char *tag)
{
    char open[64] = "<", close[64] = "</";
    strcat(strcat(open, tag), ">");
    strcat(strcat(close, tag), ">");
    const char *start = find(text, open);
    if (!start)
        return (struct string_view){text.end, text.end};
    struct string_view rest = {start + strlen(open), text.end};
    const char *stop = find(rest, close);
    return string_view_trim((struct string_view){rest.start, stop ? stop : rest.start});
}

enum status_code scan_nist_xml_read(struct scan *out, const struct scan_file *file)
{
    struct string_view text = scan_view(file), data = {text.end, text.end}, word = data;
    text.start = find(text, "<DATAFILE>");
    for (size_t i = 0; i < sizeof nist_blocks / sizeof *nist_blocks && word.start == word.end; i++) {
        data = element(text, nist_blocks[i].tag);
        out->format = nist_blocks[i].format;
        (void)scan_word(&data, &word);
    }
    if (word.start == word.end)
        return scan_fail(file, 0, "no heights in <DATA_POINT_VALUES>");
    data.start = word.start;
    double points, spacing, x_m, z_m;
    if (!number_read(element(text, "NUMPOINTS"), &points))
        return scan_fail(file, 0, "no number of points in <NUMPOINTS>");
    if (!number_read(element(text, "SPACING"), &spacing))
        return scan_fail(file, 0, "no spacing in <SPACING>");
    char unit[SCAN_UNIT_SIZE];
    scan_copy(unit, sizeof unit, element(text, "UNITS"));
    if (scan_units(out, unit, unit, &x_m, &z_m, file) != STATUS_OK ||
        scan_take_text(out, points, 1, data, z_m, INFINITY, NULL, file) != STATUS_OK)
        return file->status->code;
    out->dx_m = spacing * x_m;
    return STATUS_OK;
}
