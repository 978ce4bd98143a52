/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/archive.h"
#include "base/limits.h"
#include "scan/bytes.h"

#include <iconv.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <zlib.h>

enum {
    ZIP_LOCAL = 0x04034b50, /* signatures */
    ZIP_CENTRAL = 0x02014b50,
    ZIP_END = 0x06054b50,
    ZIP_END_64 = 0x06064b50,
    ZIP_LOCATOR_64 = 0x07064b50,
    ZIP_LOCAL_SIZE = 30, /* without name and extra field */
    ZIP_END_SIZE = 22,
    ZIP_LOCATOR_SIZE = 20,
    ZIP_COMMENT = 65535,
    ZIP_EXTRA_64 = 1,
    ZIP_ENCRYPTED = 1,
    ZIP_STORED = 0,
    ZIP_DEFLATED = 8,
    ZIP_SLACK = 64 /* an empty entry takes a few bytes, too */
};

static size_t get_u64(struct bytes *bytes)
{
    size_t low = bytes_u32(bytes), high = bytes_u32(bytes);
    return high << 32 | low;
}

static enum status_code fail_damaged(const struct scan_bytes *file, const char *what, struct status *status)
{
    return scan_fail(status, file, 0, "damaged zip archive (%s); copy the file again", what);
}

/* Where the central directory begins, and how many entries it has by the record that ends the file. */
static bool find_directory(const struct scan_bytes *file, size_t *at, size_t *count)
{
    size_t least = file->length > ZIP_END_SIZE + ZIP_COMMENT ? file->length - ZIP_END_SIZE - ZIP_COMMENT : 0, end;
    if (file->length < ZIP_END_SIZE)
        return false;
    for (end = file->length - ZIP_END_SIZE; memcmp(file->bytes + end, "PK\5\6", 4) != 0; end--)
        if (end == least)
            return false;
    struct bytes bytes = bytes_begin(file, end + 10);
    *count = bytes_u16(&bytes);
    bytes_skip(&bytes, 4); /* size of the directory */
    *at = bytes_u32(&bytes);
    if ((*count != UINT16_MAX && *at != UINT32_MAX) || end < ZIP_LOCATOR_SIZE)
        return true;
    bytes = bytes_begin(file, end - ZIP_LOCATOR_SIZE); /* zip64 */
    if (bytes_u32(&bytes) != ZIP_LOCATOR_64)
        return true;
    bytes_skip(&bytes, 4); /* disk */
    bytes = bytes_begin(file, get_u64(&bytes));
    if (bytes_u32(&bytes) != ZIP_END_64)
        return false;
    bytes_skip(&bytes, 28); /* sizes, versions, disks, entries on this disk */
    *count = get_u64(&bytes);
    bytes_skip(&bytes, 8);
    *at = get_u64(&bytes);
    return !bytes.overrun;
}

/* What 32 bits could not hold stands in the extra field 1. */
static void take_extra_64(struct archive_entry *entry, struct bytes extra)
{
    while (bytes_left(&extra) >= 4) {
        unsigned id = bytes_u16(&extra);
        size_t length = bytes_u16(&extra);
        struct bytes field = extra;
        bytes_skip(&extra, length);
        field.end = extra.at;
        if (id != ZIP_EXTRA_64)
            continue;
        size_t *const values[] = {&entry->size, &entry->packed, &entry->at};
        for (size_t i = 0; i < 3; i++)
            if (*values[i] == UINT32_MAX && bytes_left(&field) >= 8)
                *values[i] = get_u64(&field);
        return;
    }
}

enum { UTF8_MOST = 3 }; /* bytes a character of DOS takes */

static bool is_utf8(const char *string)
{
    for (size_t length; *string; string += length) {
        length = (unsigned char)*string < 0x80 ? 1 : text_character(string);
        if (length == 0)
            return false;
    }
    return true;
}

/* A name, NUL-terminated, in UTF-8; what is not is in the code page of DOS, as always was the custom. Returns its end.
 */
static char *put_name(char *to, const char *from, size_t length)
{
    memcpy(to, from, length);
    to[length] = '\0';
    iconv_t convert = is_utf8(to) ? (iconv_t)-1 : iconv_open("UTF-8", "CP437");
    if (convert == (iconv_t)-1)
        return to + length + 1;
    size_t left = length, room = UTF8_MOST * length;
    (void)iconv(convert, &(char *){(char *)from}, &left, &to, &room);
    iconv_close(convert);
    *to = '\0';
    return to + 1;
}

/* One entry of the central directory; its name goes to *names, which moves on. */
static bool take_entry(struct archive_entry *entry, struct bytes *bytes, char **names)
{
    if (bytes_u32(bytes) != ZIP_CENTRAL)
        return false;
    bytes_skip(bytes, 4); /* versions */
    entry->flags = bytes_u16(bytes);
    entry->method = bytes_u16(bytes);
    bytes_skip(bytes, 4); /* time, date */
    entry->crc = bytes_u32(bytes);
    entry->packed = bytes_u32(bytes);
    entry->size = bytes_u32(bytes);
    size_t name = bytes_u16(bytes), extra = bytes_u16(bytes), comment = bytes_u16(bytes);
    bytes_skip(bytes, 8); /* disk, attributes */
    entry->at = bytes_u32(bytes);
    const char *from = bytes->at;
    bytes_skip(bytes, name);
    struct bytes extras = *bytes;
    bytes_skip(bytes, extra);
    extras.end = bytes->at;
    bytes_skip(bytes, comment);
    if (bytes->overrun)
        return false;
    take_extra_64(entry, extras);
    entry->name = *names;
    *names = put_name(*names, from, name);
    return true;
}

/* The packed bytes of an entry; false where they are not in the file. */
static bool find_packed(struct bytes *out, const struct archive *archive, const struct archive_entry *entry)
{
    if (entry->at > archive->file->length)
        return false;
    *out = bytes_begin(archive->file, entry->at);
    if (bytes_u32(out) != ZIP_LOCAL)
        return false;
    bytes_skip(out, 22);
    size_t name = bytes_u16(out), extra = bytes_u16(out);
    bytes_skip(out, name + extra);
    if (out->overrun || bytes_left(out) < entry->packed)
        return false;
    out->end = out->at + entry->packed;
    return true;
}

static int compare_places(const void *a, const void *b)
{
    const struct bytes *first = a, *second = b;
    return first->at < second->at ? -1 : first->at > second->at;
}

/* May all entries be unpacked, one after another: are the claimed sizes within the limits, and no bytes of the file
 * used twice, which makes a small file large? */
static enum status_code check_entries(const struct archive *archive, struct status *status)
{
    const struct scan_bytes *file = archive->file;
    size_t total = 0, most = limit_most(LIMIT_UNPACKED_BYTES), ratio = limit_most(LIMIT_UNPACKED_RATIO);
    struct bytes *places = calloc(archive->count + 1, sizeof *places); /* of header and data */
    if (!places)
        return status_memory(status);
    for (size_t i = 0; i < archive->count && status->code == STATUS_OK; i++) {
        const struct archive_entry *entry = &archive->entries[i];
        if (!find_packed(&places[i], archive, entry))
            scan_fail(status, file, 0, "'%.80s' is not where the archive says; copy the file again", entry->name);
        else if (entry->size / ratio > entry->packed + ZIP_SLACK)
            scan_fail(status, file, 0, "'%.80s' in the archive claims %zu bytes: damaged", entry->name, entry->size);
        else if (entry->size > most - total)
            scan_fail(status, file, 0, "the archive unpacks to more than %zu bytes%s", most,
                      limit_words(LIMIT_UNPACKED_BYTES).text);
        else
            total += entry->size;
        places[i].at = file->bytes + entry->at;
    }
    if (status->code == STATUS_OK)
        qsort(places, archive->count, sizeof *places, compare_places);
    for (size_t i = 1; i < archive->count && status->code == STATUS_OK; i++)
        if (places[i].at < places[i - 1].end)
            scan_fail(status, file, 0, "entries of the archive share their bytes: damaged, or made to fill a memory");
    free(places);
    return status->code;
}

enum status_code archive_open(struct archive *out, const struct scan_bytes *file, struct status *status)
{
    size_t at = 0;
    *out = (struct archive){.file = file};
    if (!find_directory(file, &at, &out->count) || at > file->length)
        return fail_damaged(file, "no list of its files", status);
    if (out->count > limit_most(LIMIT_MEMBERS))
        return scan_fail(status, file, 0, "%zu files in the archive%s", out->count, limit_words(LIMIT_MEMBERS).text);
    struct bytes bytes = bytes_begin(file, at);
    size_t left = bytes_left(&bytes),
           most = out->count * (UINT16_MAX + 1); /* an entry is longer than its name and NUL */
    out->entries = calloc(out->count + 1, sizeof *out->entries);
    char *names = out->names = malloc(UTF8_MOST * (left < most ? left : most) + 1);
    if (!out->entries || !out->names)
        return status_memory(status);
    for (size_t i = 0; i < out->count; i++)
        if (!take_entry(&out->entries[i], &bytes, &names))
            return fail_damaged(file, "the list of its files ends early", status);
    return check_entries(out, status);
}

void archive_close(struct archive *archive)
{
    free(archive->entries);
    free(archive->names);
    *archive = (struct archive){.file = archive->file};
}

size_t archive_find(const struct archive *archive, const char *name, bool anywhere)
{
    size_t i = 0;
    for (; i < archive->count; i++) {
        const char *own = archive->entries[i].name, *slash = anywhere ? strrchr(own, '/') : NULL;
        if (strcasecmp(slash ? slash + 1 : own, name) == 0)
            break;
    }
    return i;
}

bool archive_has(const struct scan_bytes *file, const char *name, bool anywhere, bool damaged)
{
    struct archive archive;
    struct status ignored = {0};
    bool opened = archive_open(&archive, file, &ignored) == STATUS_OK;
    bool found = opened ? archive_find(&archive, name, anywhere) < archive.count : damaged;
    archive_close(&archive);
    return found;
}

/* Inflates `size` bytes to `to`; false where the stream is damaged or, unless it is only begun, ends elsewhere. */
static bool inflate_entry(char *to, size_t size, struct bytes packed, bool begun)
{
    z_stream stream = {.next_in = (Bytef *)packed.at};
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK)
        return false;
    size_t left = bytes_left(&packed), room = size;
    char end = 0; /* the stream's end may come behind its last byte */
    int code = Z_OK;
    while (code == Z_OK && (room > 0 || !begun)) {
        uInt in = left < UINT32_MAX ? (uInt)left : UINT32_MAX, to_fill = room < UINT32_MAX ? (uInt)room : UINT32_MAX;
        stream.avail_in = in;
        stream.next_out = (Bytef *)(room > 0 ? to + (size - room) : &end);
        stream.avail_out = room > 0 ? to_fill : 1;
        code = inflate(&stream, Z_NO_FLUSH);
        left -= in - stream.avail_in;
        if (room == 0 && stream.avail_out == 0)
            code = Z_DATA_ERROR; /* longer than it claims */
        room -= room > 0 ? to_fill - stream.avail_out : 0;
    }
    inflateEnd(&stream);
    return room == 0 && (code == Z_STREAM_END || (begun && code == Z_OK));
}

static uint32_t checksum(const char *bytes, size_t length)
{
    return (uint32_t)crc32_z(crc32_z(0, NULL, 0), (const Bytef *)bytes, length);
}

enum status_code archive_read(struct text *text, const struct archive *archive, size_t index, size_t most,
                              struct status *status)
{
    const struct archive_entry *entry = &archive->entries[index];
    struct bytes packed;
    bool begun = entry->size > most, good = find_packed(&packed, archive, entry);
    size_t size = begun ? most : entry->size;
    if (entry->flags & ZIP_ENCRYPTED)
        return scan_fail(status, archive->file, 0, "'%.80s' in the archive is encrypted; unpack it", entry->name);
    if (entry->method != ZIP_STORED && entry->method != ZIP_DEFLATED)
        return scan_fail(status, archive->file, 0,
                         "'%.80s' in the archive is packed by method %u, and only deflate is read; unpack it",
                         entry->name, entry->method);
    *text = (struct text){.data = malloc(size + 1), .length = size, .capacity = size + 1};
    if (!text->data)
        return *text = (struct text){0}, status_memory(status);
    text->data[size] = '\0';
    if (entry->method == ZIP_DEFLATED)
        good = good && inflate_entry(text->data, size, packed, begun);
    else if ((good = good && entry->packed == entry->size))
        memcpy(text->data, packed.at, size);
    if (!good || (!begun && checksum(text->data, size) != entry->crc))
        return scan_fail(status, archive->file, 0, "'%.80s' in the archive is damaged; copy the file again",
                         entry->name);
    return STATUS_OK;
}
