/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/limits.h"
#include "scan/reader.h"

#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <zlib.h>

bool scan_tells_at_end(const char *bytes, size_t length)
{
    return length > 4 && memcmp(bytes, "PK\3\4", 4) == 0;
}

static size_t read_whole(struct bytes *bytes, enum bytes_type type)
{
    return (size_t)bytes_number(bytes, type);
}

static size_t read_long(struct bytes *bytes)
{
    size_t low = read_whole(bytes, BYTES_U32);
    return low + (read_whole(bytes, BYTES_U32) << 32);
}

/* The directory and the number of its entries, from the record at the archive's end (APPNOTE 4.3.14 to 4.3.16). */
static struct bytes find_directory(size_t *count, const struct scan_file *file)
{
    enum { END = 22, COMMENT = UINT16_MAX, LOCATOR = 20 };
    size_t at = file->length > END ? file->length - END : 0, first = at > COMMENT ? at - COMMENT - 1 : 0;
    while (at > first && memcmp(file->bytes + at, "PK\5\6", 4) != 0)
        at--;
    struct bytes end = bytes_begin(file, at > first ? at + 10 : SIZE_MAX);
    *count = read_whole(&end, BYTES_U16);
    bytes_skip(&end, 4);
    size_t start = read_whole(&end, BYTES_U32);
    if (at > LOCATOR && (*count == UINT16_MAX || start == UINT32_MAX) &&
        memcmp(file->bytes + at - LOCATOR, "PK\6\7", 4) == 0) {
        struct bytes locator = bytes_begin(file, at - LOCATOR + 8);
        size_t record = read_long(&locator);
        end = bytes_begin(file, record < file->length ? record + 32 : SIZE_MAX);
        *count = read_long(&end);
        bytes_skip(&end, 8);
        start = read_long(&end);
    }
    return end.overrun ? end : bytes_begin(file, start);
}

/* Sizes and a place that are all ones stand in the ZIP64 field of the `length` extra bytes (4.5.3). */
static void read_zip64(struct archive_entry *entry, size_t *place, struct bytes bytes, size_t length)
{
    bytes.end = length < bytes_left(&bytes) ? bytes.at + length : bytes.end;
    while (bytes_left(&bytes) > 4) {
        size_t id = read_whole(&bytes, BYTES_U16), size = read_whole(&bytes, BYTES_U16);
        size_t *said[] = {&entry->size, &entry->packed_size, place};
        struct bytes field = bytes;
        for (size_t i = 0; id == 1 && i < 3; i++)
            *said[i] = *said[i] == UINT32_MAX ? read_long(&field) : *said[i];
        bytes_skip(&bytes, size);
    }
}

/* Reads an entry of the directory (4.3.12), and the length of the header before its bytes (4.3.7). */
static void read_entry(struct archive_entry *out, struct bytes *bytes, const struct scan_file *file)
{
    bytes->overrun = bytes->overrun || bytes_left(bytes) < 4 || memcmp(bytes->at, "PK\1\2", 4) != 0;
    bytes_skip(bytes, 8);
    out->flags = (unsigned)bytes_number(bytes, BYTES_U16);
    out->method = (unsigned)bytes_number(bytes, BYTES_U16);
    bytes_skip(bytes, 4);
    out->checksum = (uint32_t)bytes_number(bytes, BYTES_U32);
    out->packed_size = read_whole(bytes, BYTES_U32);
    out->size = read_whole(bytes, BYTES_U32);
    size_t name = read_whole(bytes, BYTES_U16), extra = read_whole(bytes, BYTES_U16);
    size_t comment = read_whole(bytes, BYTES_U16);
    bytes_skip(bytes, 8);
    size_t place = read_whole(bytes, BYTES_U32);
    const char *start = bytes->at;
    bytes_skip(bytes, name);
    scan_copy(out->name, sizeof out->name, (struct string_view){start, bytes->at});
    read_zip64(out, &place, *bytes, extra);
    bytes_skip(bytes, extra + comment);
    struct bytes header = bytes_begin(file, place);
    bool found = bytes_left(&header) > 4 && memcmp(header.at, "PK\3\4", 4) == 0;
    bytes_skip(&header, 26);
    size_t lengths = read_whole(&header, BYTES_U16) + read_whole(&header, BYTES_U16);
    bytes_skip(&header, lengths);
    out->packed = found && !header.overrun && out->packed_size <= bytes_left(&header) ? header.at : NULL;
}

/* Are the claimed sizes within the limits, and do the packed bytes fit into the file one behind another? If not,
 * entries share bytes, and a small file unpacks to a huge one. */
static enum status_code check_entries(const struct archive *archive)
{
    const struct scan_file *file = archive->file;
    size_t total = 0, packed = 0, most = limit_most(LIMIT_UNPACKED_BYTES);
    for (size_t i = 0; i < archive->count; i++) {
        const struct archive_entry *entry = &archive->entries[i];
        if (entry->packed_size > file->length - packed)
            return scan_fail(file, 0, "entries of the archive share their bytes: damaged, or made to fill a memory");
        if (entry->size > limit_unpacked(entry->packed_size))
            return scan_fail(file, 0, "'%.80s' in the archive claims %zu bytes, packed in %zu%s", entry->name,
                             entry->size, entry->packed_size, limit_words(LIMIT_UNPACKED_RATIO).text);
        if (entry->size > most - total)
            return scan_fail(file, 0, "the archive unpacks to more than %zu bytes%s", most,
                             limit_words(LIMIT_UNPACKED_BYTES).text);
        packed += entry->packed_size;
        total += entry->size;
    }
    return STATUS_OK;
}

enum status_code archive_open(struct archive *out, const struct scan_file *file)
{
    *out = (struct archive){.file = file};
    size_t count;
    struct bytes directory = find_directory(&count, file);
    if (!directory.overrun && count > limit_most(LIMIT_MEMBERS))
        return scan_fail(file, 0, "%zu files in the archive%s", count, limit_words(LIMIT_MEMBERS).text);
    out->entries = calloc(directory.overrun ? 1 : count + 1, sizeof *out->entries);
    if (!out->entries)
        return status_memory(file->status);
    while (!directory.overrun && out->count < count)
        read_entry(&out->entries[out->count++], &directory, file);
    return directory.overrun ? scan_fail(file, 0, "damaged zip archive; copy the file again") : check_entries(out);
}

void archive_close(struct archive *archive)
{
    free(archive->entries);
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

/* Unpacks into `text`, which has room for one byte more than its length; false where the bytes are fewer or, of a whole
 * entry, more than it claims, or have another checksum. */
static bool unpack(const struct text *text, const struct archive_entry *entry)
{
    bool whole = text->length == entry->size, good = false;
    z_stream stream = {.next_in = (Bytef *)(uintptr_t)entry->packed,
                       .avail_in = (uInt)entry->packed_size,
                       .next_out = (Bytef *)text->data,
                       .avail_out = (uInt)text->capacity};
    if (entry->method == 0) {
        good = entry->packed_size == entry->size;
        memcpy(text->data, entry->packed, good ? text->length : 0);
    } else if (inflateInit2(&stream, -MAX_WBITS) == Z_OK) {
        int code = inflate(&stream, Z_FINISH);
        good = whole ? code == Z_STREAM_END && stream.total_out == text->length : stream.total_out >= text->length;
        inflateEnd(&stream);
    }
    return good && (!whole || crc32_z(0, (const Bytef *)text->data, text->length) == entry->checksum);
}

enum status_code archive_read(struct text *text, const struct archive *archive, size_t index, size_t most,
                              const struct scan_file *file)
{
    const struct archive_entry *entry = &archive->entries[index];
    size_t size = entry->size < most ? entry->size : most;
    if (entry->flags & 1)
        return scan_fail(file, 0, "'%.80s' in the archive is encrypted; unpack it", entry->name);
    if (entry->method != 0 && entry->method != Z_DEFLATED)
        return scan_fail(file, 0, "'%.80s' in the archive is packed by method %u, and only deflate is read; unpack it",
                         entry->name, entry->method);
    *text = (struct text){.data = malloc(size + 1), .length = size, .capacity = size + 1};
    if (!text->data)
        return *text = (struct text){0}, status_memory(file->status);
    errno = 0;
    bool good = entry->packed && unpack(text, entry);
    text->data[size] = '\0';
    if (!good)
        return errno == ENOMEM
                   ? status_memory(file->status)
                   : scan_fail(file, 0, "'%.80s' in the archive is damaged; copy the file again", entry->name);
    return STATUS_OK;
}
