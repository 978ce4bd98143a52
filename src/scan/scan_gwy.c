/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Native Gwyddion files: `GWYP` and a serialized GwyContainer, whose components are a name, a letter for the type, and
 * the value; little-endian. `/N/data` are GwyDataFields (maps), of which the first whose values are lengths is read.
 * Described in Gwyddion's user guide, Format of Gwyddion Files. */
#include "scan/reader.h"

#include <math.h>
#include <string.h>

struct component {
    struct string_view name;
    char type;
    struct bytes value;
};

/* A map or a mask, in the file. */
struct field {
    size_t number; /* N of /N/data */
    double nx, ny, width, height;
    char xy_unit[SCAN_UNIT_SIZE], z_unit[SCAN_UNIT_SIZE];
    struct bytes data; /* `count` doubles */
    size_t count;
};

/* The map to be read and its mask, which is not 0 where a point does not count. */
struct found {
    struct field map, mask; /* mask.count 0: there is none */
    size_t maps;
};

/* Takes a string and its NUL. */
static struct string_view take_string(struct bytes *bytes)
{
    const char *end = memchr(bytes->at, '\0', bytes_left(bytes));
    struct string_view string = {bytes->at, end ? end : bytes->at};
    bytes_skip(bytes, end ? (size_t)(end - bytes->at) + 1 : bytes_left(bytes) + 1);
    return string;
}

/* Takes an object: its name, and its components in *inner. */
static struct string_view take_object(struct bytes *bytes, struct bytes *inner)
{
    struct string_view name = take_string(bytes);
    size_t size = (size_t)bytes_number(bytes, BYTES_U32);
    *inner = *bytes;
    bytes_skip(bytes, size);
    inner->overrun = bytes->overrun;
    inner->end = bytes->overrun ? inner->at : bytes->at;
    return name;
}

/* Skips a value of that type; an unknown type is an overrun. */
static void skip_value(struct bytes *bytes, char type)
{
    static const char numbers[] = "bciqdCIQD"; /* capitals: arrays of them */
    static const size_t sizes[] = {1, 1, 4, 8, 8, 1, 4, 8, 8};
    const char *number = type ? strchr(numbers, type) : NULL;
    struct bytes inner;
    if (number) {
        size_t count = type <= 'Z' ? (size_t)bytes_number(bytes, BYTES_U32) : 1;
        bytes_skip(bytes, count * sizes[number - numbers]);
    } else if (type == 's') {
        (void)take_string(bytes);
    } else if (type == 'o') {
        (void)take_object(bytes, &inner);
    } else if (type == 'S' || type == 'O') {
        for (size_t count = (size_t)bytes_number(bytes, BYTES_U32); count > 0 && !bytes->overrun; count--)
            skip_value(bytes, type == 'S' ? 's' : 'o');
    } else {
        bytes_skip(bytes, bytes_left(bytes) + 1);
    }
}

/* Takes the next component; false behind the last, or where the file is damaged (bytes->overrun). */
static bool take_component(struct bytes *bytes, struct component *out)
{
    if (bytes_left(bytes) == 0)
        return false;
    out->name = take_string(bytes);
    out->type = (char)(unsigned char)bytes_number(bytes, BYTES_U8);
    out->value = *bytes;
    skip_value(bytes, out->type);
    out->value.end = bytes->at;
    return !bytes->overrun;
}

/* The unit of a serialized GwySIUnit; empty where it has none. */
static void read_unit(char *unit, const struct component *component)
{
    struct bytes value = component->value, inner;
    struct component member;
    (void)take_object(&value, &inner);
    while (take_component(&inner, &member))
        if (member.type == 's' && string_view_equals(member.name, "unitstr"))
            scan_copy(unit, SCAN_UNIT_SIZE, take_string(&member.value));
}

/* Reads a GwyDataField; false where it is another object or damaged. */
static bool read_field(struct field *out, const struct component *component)
{
    const struct {
        const char *name;
        char type;
        double *number;
    } numbers[] = {
        {"xres", 'i', &out->nx}, {"yres", 'i', &out->ny}, {"xreal", 'd', &out->width}, {"yreal", 'd', &out->height}};
    struct bytes value = component->value, inner;
    struct component member;
    if (!string_view_equals(take_object(&value, &inner), "GwyDataField"))
        return false;
    while (take_component(&inner, &member)) {
        struct bytes at = member.value;
        for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
            if (member.type == numbers[i].type && string_view_equals(member.name, numbers[i].name))
                *numbers[i].number = bytes_number(&at, member.type == 'i' ? BYTES_U32 : BYTES_F64);
        if (member.type == 'o' && string_view_equals(member.name, "si_unit_xy"))
            read_unit(out->xy_unit, &member);
        else if (member.type == 'o' && string_view_equals(member.name, "si_unit_z"))
            read_unit(out->z_unit, &member);
        else if (member.type == 'D' && string_view_equals(member.name, "data")) {
            out->count = (size_t)bytes_number(&at, BYTES_U32);
            out->data = at;
        }
    }
    return !inner.overrun;
}

/* N of `/N/data` or `/N/mask`, whichever `end` says. */
static bool is_key(struct string_view name, const char *end, size_t *number)
{
    size_t length = string_view_length(name), tail = strlen(end);
    return length > tail + 1 && memcmp(name.end - tail, end, tail) == 0 && *name.start == '/' &&
           number_read_size((struct string_view){name.start + 1, name.end - tail}, number);
}

/* Is `field` to be read rather than `best`? Lengths come before others, then the lower number. */
static bool is_better(const struct field *field, const struct field *best)
{
    bool length = scan_unit_m(field->z_unit) > 0, best_length = scan_unit_m(best->z_unit) > 0;
    return length != best_length ? length : field->number < best->number;
}

/* Moves on to the next map or mask, whichever `end` says; false when there is none. */
static bool next_field(struct bytes *inner, const char *end, struct field *out, bool *damaged)
{
    struct component component;
    while (take_component(inner, &component)) {
        *out = (struct field){0};
        if (component.type != 'o' || !is_key(component.name, end, &out->number))
            continue;
        *damaged = *damaged || !read_field(out, &component) || out->nx * out->ny != (double)out->count ||
                   bytes_left(&out->data) / sizeof(double) < out->count;
        return true;
    }
    return false;
}

static enum status_code find_fields(struct found *out, const struct scan_file *file)
{
    struct bytes bytes = bytes_begin(file, 4), inner; /* behind GWYP */
    struct field field;
    bool damaged = false;
    (void)take_object(&bytes, &inner);
    struct bytes again = inner;
    *out = (struct found){.maps = 0};
    while (next_field(&inner, "/data", &field, &damaged))
        if (out->maps++ == 0 || is_better(&field, &out->map))
            out->map = field;
    while (next_field(&again, "/mask", &field, &damaged))
        if (field.number == out->map.number)
            out->mask = field;
    if (inner.overrun || bytes.overrun || damaged)
        return scan_fail(file, 0, "the file is cut off or damaged; copy it again");
    if (out->maps == 0)
        return scan_fail(file, 0, "no map in it (/0/data); export its profiles from Gwyddion as text");
    if (out->mask.count > 0 && (out->mask.nx != out->map.nx || out->mask.ny != out->map.ny))
        return scan_fail(file, 0, "the mask is of %.0f x %.0f points, the map of %.0f x %.0f; copy the file again",
                         out->mask.nx, out->mask.ny, out->map.nx, out->map.ny);
    return STATUS_OK;
}

enum status_code scan_gwy_read(struct scan *out, const struct scan_file *file)
{
    struct found found;
    struct field *map = &found.map;
    size_t masked = 0;
    double x_m, z_m;
    if (find_fields(&found, file) != STATUS_OK ||
        scan_units(out, map->xy_unit, map->z_unit, &x_m, &z_m, file) != STATUS_OK ||
        scan_reserve(out, map->nx, map->ny, map->count, file) != STATUS_OK)
        return file->status->code;
    for (size_t i = 0; i < map->count; i++)
        out->z_m[i] = bytes_number(&map->data, BYTES_F64) * z_m;
    out->dx_m = map->width / map->nx * x_m;
    out->dy_m = map->height / map->ny * x_m;
    for (size_t i = 0; i < found.mask.count; i++) /* Gwyddion fills in points that were not measured, and masks them */
        if (bytes_number(&found.mask.data, BYTES_F64) != 0) {
            out->z_m[i] = NAN;
            masked++;
        }
    if (masked > 0)
        scan_warn(out, "%zu points under the mask of Gwyddion are taken as missing", masked);
    if (found.maps > 1)
        scan_warn(out, "the file holds %zu maps: /%zu/data was read", found.maps, map->number);
    return STATUS_OK;
}
