/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A zip archive of scans: every entry that a reader knows by its content, or that is text with numbers, is one.
 * options->entry is the index where the search starts. An entry that cannot be read is refused in its turn, and the
 * search goes on behind it. */
#include "base/limits.h"
#include "scan/format.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <zlib.h>

enum { ZIP_NAMED = 5 };

/* An entry, unpacked. Its text is owned. */
struct entry {
    struct text text;
    char path[512]; /* for messages: archive(entry) */
    struct scan_file file;
};

/* Is the entry empty, or what an operating system leaves in archives? */
static bool is_empty(const struct archive_entry *entry)
{
    const char *slash = strrchr(entry->name, '/'), *own = slash ? slash + 1 : entry->name;
    return entry->size == 0 || *own == '\0' || *own == '.' || strncmp(entry->name, "__MACOSX/", 9) == 0;
}

/* Unpacks entry `index` and returns what it is. FORMAT_FOREIGN: damaged, or a format that is not read; file->status
 * says which. */
static enum format_kind open_entry(struct entry *out, const struct archive *archive, size_t index,
                                   const struct scan_file *file)
{
    const char *name = archive->entries[index].name;
    snprintf(out->path, sizeof out->path, "%.300s(%.200s)", file->path, name);
    if (archive_read(&out->text, archive, index, SIZE_MAX, file) != STATUS_OK)
        return FORMAT_FOREIGN;
    out->file = (struct scan_file){text_string(&out->text), out->text.length, out->path, file->options, file->status};
    struct scan_file named = out->file;
    named.path = name;
    struct format format = format_of(&named, true);
    if (format.kind == FORMAT_FOREIGN)
        format_refuse(&out->file, &format);
    return format.kind == FORMAT_UNKNOWN || format.kind == FORMAT_PACKED ? FORMAT_OTHER : format.kind;
}

/* Reads the first scan from options->entry on, and finds the next. At the start of the archive it looks at all entries,
 * to say which are no scans. */
static enum status_code read_archive(struct scan *out, const struct archive *archive)
{
    const struct scan_file *file = archive->file;
    size_t others = 0;    /* entries that are no scans */
    char names[120] = ""; /* of the first of them */
    enum status_code code = STATUS_OK;
    bool found = false, all = file->options->entry == 0;
    for (size_t i = file->options->entry; i < archive->count && (all || out->next_entry == 0); i++) {
        const struct archive_entry *own = &archive->entries[i];
        const char *name = own->name;
        struct status ignored = {0};
        struct scan_file quiet = *file;
        struct entry entry = {0};
        if (is_empty(own))
            continue;
        quiet.status = found ? &ignored : file->status;
        enum format_kind kind = open_entry(&entry, archive, i, &quiet);
        if (kind == FORMAT_OTHER) {
            size_t used = strlen(names);
            if (others++ < ZIP_NAMED)
                snprintf(names + used, sizeof names - used, "%s%.60s", used > 0 ? ", " : "", name);
        } else if (!found) {
            found = true;
            snprintf(out->part, sizeof out->part, "%.100s", name);
            scan_printable(out->part);
            code = kind == FORMAT_FOREIGN ? file->status->code : format_read(out, &entry.file);
        } else if (out->next_entry == 0) {
            out->next_entry = i;
        }
        text_free(&entry.text);
        if (quiet.status->code == STATUS_MEMORY)
            return status_memory(file->status);
    }
    if (!found)
        return scan_fail(file, 0, "no scan in this zip archive%s%s", others > 0 ? ", only " : "", names);
    if (all && others > 0)
        scan_warn(out, "passed over in the archive, no scan%s: %s%s", others == 1 ? "" : "s", names,
                  others > ZIP_NAMED ? ", ..." : "");
    return code;
}

/* Unpacks all members of a gzip file (RFC 1952), one after another, into `text`. */
static enum status_code unpack_gz(struct text *text, const struct scan_file *file)
{
    z_stream stream = {.next_in = (Bytef *)file->bytes};
    const char *end = file->bytes + file->length;
    enum { PIECE = 16384 };
    unsigned char piece[PIECE];
    int code = inflateInit2(&stream, 16 + MAX_WBITS); /* gzip's header */
    size_t most = limit_most(LIMIT_UNPACKED_BYTES), room = limit_unpacked(file->length);
    enum limit limit = room < most ? LIMIT_UNPACKED_RATIO : LIMIT_UNPACKED_BYTES;
    most = room < most ? room : most;
    if (code != Z_OK)
        return status_memory(file->status);
    while (code == Z_OK || (code == Z_STREAM_END && (const char *)stream.next_in < end)) {
        size_t left = (size_t)(end - (const char *)stream.next_in);
        if (code == Z_STREAM_END && inflateReset(&stream) != Z_OK)
            break;
        stream.avail_in = left < PIECE ? (uInt)left : PIECE;
        stream.next_out = piece;
        stream.avail_out = PIECE;
        code = inflate(&stream, Z_NO_FLUSH);
        text_add_bytes(text, (const char *)piece, PIECE - stream.avail_out);
        if (text->failed || text->length > most || (left == 0 && stream.avail_out > 0))
            break;
    }
    inflateEnd(&stream);
    if (text->failed || code == Z_MEM_ERROR)
        return status_memory(file->status);
    if (text->length > most)
        return scan_fail(file, 0, "it unpacks to more than %zu bytes%s", most, limit_words(limit).text);
    if (code != Z_STREAM_END)
        return scan_fail(file, 0, "damaged or cut off within the gzip data; copy the file again");
    return STATUS_OK;
}

enum status_code scan_packed_read(struct scan *out, const struct scan_file *file)
{
    bool goes_on = file->options->entry > 0; /* through an archive, which is not looked through again */
    struct format format = goes_on ? (struct format){.name = "zip", .kind = FORMAT_PACKED} : format_of(file, false);
    if (format.kind != FORMAT_PACKED)
        return format_read(out, file);
    out->format = format.name;
    OWNED(archive_close) struct archive archive = {0};
    OWNED(text_free) struct text text = {0};
    bool zip = strcmp(format.name, "zip") == 0;
    enum status_code code = zip ? archive_open(&archive, file) : unpack_gz(&text, file);
    if (code == STATUS_OK && zip)
        code = read_archive(out, &archive);
    else if (code == STATUS_OK)
        code = format_read(
            out, &(struct scan_file){text_string(&text), text.length, file->path, file->options, file->status});
    return code;
}
