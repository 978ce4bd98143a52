/* ISO 25178-72 X3P: a zip archive with main.xml (perhaps in a folder) and the points, all in metres, in main.xml or in
 * a binary file. Stored axes (kind A) lie side by side, point by point; a value is stored x increment + offset. */
#include "scan/archive.h"
#include "scan/md5.h"
#include "scan/x3p_xml.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* type letters of X3P and what they are */
static const struct {
    char letter;
    enum bytes_type type;
} x3p_types[] = {{'I', BYTES_I16}, {'L', BYTES_I32}, {'F', BYTES_F32}, {'D', BYTES_F64}};

struct x3p {
    struct archive archive;
    struct text main, points, valid;
    struct x3p_xml xml;
    char folder[256]; /* of main.xml, with its last '/' */
};

bool scan_x3p_sniff(const struct scan_bytes *file)
{
    return archive_sniff(file) && memmem(file->bytes, file->length, "main.xml", 8) != NULL;
}

static bool stored(const struct x3p_axis *axis)
{
    return axis->kind == 'A';
}

/* Unpacks the file a link in main.xml names, which is relative to main.xml. */
static enum status_code read_link(struct text *text, const struct x3p *x3p, const char *link,
                                  const struct scan_bytes *file, struct status *status)
{
    char path[512];
    snprintf(path, sizeof path, "%s%s", x3p->folder, link);
    size_t index = archive_find(&x3p->archive, path, false), count = archive_count(&x3p->archive);
    if (index == count)
        index = archive_find(&x3p->archive, link, false);
    if (index == count)
        return scan_fail(status, file, 0, "no '%.80s' in the archive, which main.xml names", link);
    return archive_read(text, &x3p->archive, index, status);
}

static void compare_md5(struct scan *out, const struct text *text, const char *expected, const char *what)
{
    struct md5_hex actual = md5(text_string(text), text->length);
    if (strlen(expected) >= 32 && strncasecmp(actual.text, expected, 32) != 0)
        scan_warn(out, "the checksum of %s does not fit: it was changed after it was written", what);
}

static enum status_code open_main(struct x3p *x3p, const struct scan_bytes *file, struct scan *out,
                                  struct status *status)
{
    if (archive_open(&x3p->archive, file, status) != STATUS_OK)
        return status->code;
    size_t index = archive_find(&x3p->archive, "main.xml", true), count = archive_count(&x3p->archive);
    if (index == count)
        return scan_fail(status, file, 0, "no main.xml in the archive");
    const char *name = archive_name(&x3p->archive, index), *slash = strrchr(name, '/');
    scan_copy(x3p->folder, sizeof x3p->folder, (struct string_view){name, slash ? slash + 1 : name});
    if (archive_read(&x3p->main, &x3p->archive, index, status) != STATUS_OK ||
        x3p_xml_read(&x3p->xml, &x3p->main, file, status) != STATUS_OK)
        return status->code;
    struct text sum = {0};
    index = archive_find(&x3p->archive, "md5checksum.hex", true);
    if (index < count && archive_read(&sum, &x3p->archive, index, status) == STATUS_OK)
        compare_md5(out, &x3p->main, text_string(&sum), "main.xml");
    text_free(&sum);
    return status->code;
}

/* Points a row and rows, checked to be what can be read. */
static enum status_code read_size(const struct x3p_xml *xml, size_t *nx, size_t *ny, const struct scan_bytes *file,
                                  struct status *status)
{
    bool profile = strcmp(xml->feature, "PRF") == 0;
    if (!profile && strcmp(xml->feature, "SUR") != 0)
        return scan_fail(status, file, 0, "feature type '%s' is neither profile (PRF) nor surface (SUR); export one",
                         scan_quote((struct string_view){xml->feature, xml->feature + strlen(xml->feature)}).text);
    double x = xml->list > 0 ? xml->list : xml->size[0], y = xml->list > 0 ? 1 : xml->size[1];
    double z = xml->list > 0 || xml->size[2] == 0 ? 1 : xml->size[2];
    if (!(x >= 1 && x <= 1e12 && y >= 1 && y <= 1e12) || z != 1 || (profile && y != 1))
        return scan_fail(status, file, 0, "%g x %g x %g points are no %s", x, y, z,
                         profile ? "profile" : "surface of one layer");
    if (!stored(&xml->axis[2]))
        return scan_fail(status, file, 0, "no heights: CZ is no absolute axis");
    if (y > 1 && (stored(&xml->axis[0]) || stored(&xml->axis[1])))
        return scan_fail(status, file, 0, "positions stored point by point: only surfaces on a grid can be read");
    *nx = (size_t)x;
    *ny = (size_t)y;
    return STATUS_OK;
}

static bool find_type(char letter, enum bytes_type *type)
{
    for (size_t i = 0; i < sizeof x3p_types / sizeof *x3p_types; i++) {
        *type = x3p_types[i].type;
        if (x3p_types[i].letter == letter)
            return true;
    }
    return false;
}

static double scaled(const struct x3p_axis *axis, double value)
{
    double result = value * axis->increment + axis->offset;
    return isfinite(result) ? result : NAN;
}

static enum status_code allocate(struct scan *out, size_t nx, size_t ny, size_t room, bool with_x,
                                 const struct scan_bytes *file, struct status *status)
{
    if (scan_reserve(out, nx, ny, room, file, status) != STATUS_OK || !with_x)
        return status->code;
    out->x_m = malloc(nx * sizeof *out->x_m);
    return out->x_m ? STATUS_OK : status_memory(status);
}

static enum status_code read_binary(struct scan *out, const struct x3p *x3p, size_t nx, size_t ny,
                                    const struct scan_bytes *file, struct status *status)
{
    const struct x3p_axis *axis = x3p->xml.axis;
    enum bytes_type type[3];
    size_t size = 0;
    for (size_t i = 0; i < 3; i++) {
        if (!find_type(axis[i].type, &type[i]))
            return scan_fail(status, file, 0, "data type '%c' is none of ISO 25178-72", axis[i].type);
        size += stored(&axis[i]) ? bytes_size(type[i]) : 0;
    }
    struct bytes bytes = {text_string(&x3p->points), text_string(&x3p->points) + x3p->points.length, false};
    if (allocate(out, nx, ny, bytes_left(&bytes) / size, stored(&axis[0]), file, status) != STATUS_OK)
        return status->code;
    for (size_t i = 0; i < nx * ny; i++) {
        double value[3] = {0};
        for (size_t k = 0; k < 3; k++)
            value[k] = stored(&axis[k]) ? scaled(&axis[k], bytes_number(&bytes, type[k])) : 0.0;
        out->z_m[i] = value[2];
        if (out->x_m)
            out->x_m[i] = value[0];
    }
    return STATUS_OK;
}

static enum status_code read_list(struct scan *out, const struct x3p *x3p, size_t nx, size_t ny,
                                  const struct scan_bytes *file, struct status *status)
{
    const struct x3p_xml *xml = &x3p->xml;
    if (allocate(out, nx, ny, xml->datum_count, stored(&xml->axis[0]), file, status) != STATUS_OK)
        return status->code;
    for (size_t i = 0; i < nx * ny; i++) {
        out->z_m[i] = scaled(&xml->axis[2], xml->datum[2 * i + 1]);
        if (out->x_m)
            out->x_m[i] = scaled(&xml->axis[0], xml->datum[2 * i]);
    }
    return STATUS_OK;
}

/* valid.bin: bit i, from the lowest of the first byte on, says whether point i was measured. */
static enum status_code read_valid(struct scan *out, struct x3p *x3p, const struct scan_bytes *file,
                                   struct status *status)
{
    if (!*x3p->xml.valid_link)
        return STATUS_OK;
    if (read_link(&x3p->valid, x3p, x3p->xml.valid_link, file, status) != STATUS_OK)
        return status->code;
    size_t points = out->nx * out->ny;
    if (x3p->valid.length < (points + 7) / 8)
        return scan_fail(status, file, 0, "'%.80s' holds fewer bits than there are points", x3p->xml.valid_link);
    for (size_t i = 0; i < points; i++)
        if (!((unsigned char)x3p->valid.data[i / 8] >> i % 8 & 1))
            out->z_m[i] = NAN;
    return STATUS_OK;
}

static enum status_code read_points(struct scan *out, struct x3p *x3p, const struct scan_bytes *file,
                                    struct status *status)
{
    size_t nx = 0, ny = 0;
    if (open_main(x3p, file, out, status) != STATUS_OK || read_size(&x3p->xml, &nx, &ny, file, status) != STATUS_OK)
        return status->code;
    if (*x3p->xml.data_link) {
        if (read_link(&x3p->points, x3p, x3p->xml.data_link, file, status) != STATUS_OK)
            return status->code;
        compare_md5(out, &x3p->points, x3p->xml.data_md5, x3p->xml.data_link);
        if (read_binary(out, x3p, nx, ny, file, status) != STATUS_OK)
            return status->code;
    } else if (read_list(out, x3p, nx, ny, file, status) != STATUS_OK) {
        return status->code;
    }
    out->dx_m = x3p->xml.axis[0].increment;
    out->dy_m = out->kind == SCAN_AREAL ? x3p->xml.axis[1].increment : 0.0;
    scan_set_units(out, "m", "m");
    return read_valid(out, x3p, file, status);
}

enum status_code scan_x3p_read(struct scan *out, const struct scan_bytes *file, const struct scan_options *options,
                               struct status *status)
{
    (void)options;
    struct x3p x3p = {0};
    enum status_code code = read_points(out, &x3p, file, status);
    text_free(&x3p.main);
    text_free(&x3p.points);
    text_free(&x3p.valid);
    x3p_xml_free(&x3p.xml);
    archive_close(&x3p.archive);
    return code;
}
