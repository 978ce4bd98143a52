/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A zip archive that holds scans, as some instruments pack theirs: every entry that a reader knows by its content is
 * one; text only where nothing else is there, and where it has a row of numbers. options->entry says where the search
 * starts: entry i is at i, and at i + the number of entries when texts are sought. An entry that cannot be read is
 * refused where it comes, and the search goes on behind it. */
#include "base/limits.h"
#include "base/text.h"
#include "scan/format.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum { ZIP_NAMED = 5, ZIP_BEGINNING = 65536 };

/* An entry, unpacked or its first bytes. Its text is owned. */
struct entry {
    struct text text;
    char path[512]; /* for messages: archive(entry) */
    struct scan_file file;
    enum format_kind kind; /* FORMAT_FOREIGN where it cannot be read */
    bool empty;            /* a folder, or nothing in it */
    bool words;            /* a text without numbers */
};

/* What an operating system leaves in archives. */
static bool is_hidden(const char *name)
{
    const char *slash = strrchr(name, '/');
    return (slash ? slash[1] : *name) == '.' || strncmp(name, "__MACOSX/", 9) == 0;
}

/* Unpacks entry `index`, up to `most` bytes; errors go where `file` says. */
static enum status_code unpack(struct entry *out, const struct archive *archive, size_t index, size_t most,
                               const struct scan_file *file)
{
    const char *name = archive->entries[index].name;
    bool empty = archive->entries[index].size == 0 || *name == '\0' || name[strlen(name) - 1] == '/' || is_hidden(name);
    *out = (struct entry){.empty = empty, .kind = empty ? FORMAT_OTHER : FORMAT_FOREIGN};
    snprintf(out->path, sizeof out->path, "%.300s(%.200s)", file->path, name);
    if (!out->empty && archive_read(&out->text, archive, index, most, file) != STATUS_OK)
        return file->status->code;
    out->file = (struct scan_file){text_string(&out->text), out->text.length, out->path, file->options, file->status};
    return STATUS_OK;
}

/* Do the first bytes of an entry not tell what it is? */
static bool is_doubtful(const struct scan_file *file)
{
    return scan_tells_at_end(file->bytes, file->length) || (scan_text_sniff(file) && !scan_text_has_numbers(file));
}

/* Tells the kind of entry `index`, as a rule by its beginning. Error: it is FORMAT_FOREIGN, damaged or a measurement
 * in a format that is not read; or STATUS_MEMORY. */
static enum status_code look_at(struct entry *out, const struct archive *archive, size_t index,
                                const struct scan_file *file)
{
    if (unpack(out, archive, index, ZIP_BEGINNING, file) != STATUS_OK || out->empty)
        return file->status->code;
    bool whole = out->text.length == archive->entries[index].size;
    if (!whole && is_doubtful(&out->file)) {
        text_free(&out->text);
        if (unpack(out, archive, index, SIZE_MAX, file) != STATUS_OK)
            return file->status->code;
        whole = true;
    }
    struct scan_file named = out->file;
    named.path = archive->entries[index].name;
    struct format format = format_of(&named, whole);
    out->kind = format.kind == FORMAT_UNKNOWN || format.kind == FORMAT_PACKED ? FORMAT_OTHER : format.kind;
    out->words = out->kind == FORMAT_OTHER && format.reader;
    return out->kind == FORMAT_FOREIGN ? format_fail_foreign(&out->file, format.foreign) : STATUS_OK;
}

/* The same of an entry of which only its kind counts, and why it cannot be read does not. */
static struct entry peek(const struct archive *archive, size_t index)
{
    struct entry entry;
    struct status problem = {0};
    struct scan_file quiet = *archive->file;
    quiet.status = &problem;
    if (look_at(&entry, archive, index, &quiet) == STATUS_MEMORY)
        (void)status_memory(archive->file->status);
    text_free(&entry.text);
    return entry;
}

static enum status_code fail_text(const struct archive *archive, size_t index)
{
    char path[512];
    struct scan_file entry = *archive->file;
    snprintf(path, sizeof path, "%.300s(%.200s)", entry.path, archive->entries[index].name);
    entry.path = path;
    return scan_fail(&entry, 0, "no line of numbers in it: not a scan");
}

/* What is in an archive, all in all. */
struct survey {
    size_t scans, texts, unreadable, others;
    char names[120];   /* of the first others */
    char text[64];     /* name of the first text */
    size_t first_text; /* without numbers; SIZE_MAX: none */
};

static void note_other(struct survey *survey, const char *name)
{
    size_t used = strlen(survey->names);
    if (survey->others++ < ZIP_NAMED)
        snprintf(survey->names + used, sizeof survey->names - used, "%s%.60s", used > 0 ? ", " : "", name);
}

static struct survey look(const struct archive *archive)
{
    struct survey out = {.first_text = SIZE_MAX};
    for (size_t i = 0; i < archive->count && archive->file->status->code == STATUS_OK; i++) {
        const char *name = archive->entries[i].name;
        struct entry entry = peek(archive, i);
        if (entry.kind == FORMAT_OTHER && !entry.empty) {
            note_other(&out, name);
            if (out.first_text == SIZE_MAX && entry.words)
                out.first_text = i;
        }
        out.scans += entry.kind == FORMAT_SCAN ? 1 : 0;
        out.unreadable += entry.kind == FORMAT_FOREIGN ? 1 : 0;
        if (entry.kind == FORMAT_TEXT && out.texts++ == 0)
            snprintf(out.text, sizeof out.text, "%.60s", name);
    }
    return out;
}

/* Moves *at to the next scan from there on, or what may be one and cannot be read; false when there is none, or no
 * memory. */
static bool seek(size_t *at, const struct archive *archive, bool texts)
{
    size_t count = archive->count;
    for (*at += texts && *at < count ? count : 0; *at < (texts ? 2 * count : count); ++*at) {
        enum format_kind kind = peek(archive, *at % count).kind;
        if (archive->file->status->code == STATUS_MEMORY)
            return false;
        if (kind == FORMAT_FOREIGN || kind == (texts ? FORMAT_TEXT : FORMAT_SCAN))
            return true;
    }
    return false;
}

static enum status_code read_scan(struct scan *out, const struct archive *archive, bool texts)
{
    const struct scan_file *file = archive->file;
    size_t at = file->options->entry;
    if (!seek(&at, archive, texts))
        return file->status->code != STATUS_OK ? file->status->code : scan_fail(file, 0, "no scan in this zip archive");
    struct entry entry;
    size_t index = at % archive->count;
    enum status_code code = look_at(&entry, archive, index, file); /* why it cannot be read */
    text_free(&entry.text);
    if (code == STATUS_OK) {
        code = unpack(&entry, archive, index, SIZE_MAX, file);
        if (code == STATUS_OK)
            code = format_read(out, &entry.file);
        text_free(&entry.text);
    }
    snprintf(out->part, sizeof out->part, "%.100s", archive->entries[index].name);
    scan_printable(out->part);
    at++;
    if (code != STATUS_MEMORY && seek(&at, archive, texts))
        out->next_entry = at;
    return file->status->code;
}

static enum status_code read_archive(struct scan *out, const struct archive *archive)
{
    size_t entry = archive->file->options->entry;
    if (entry > 0)
        return read_scan(out, archive, entry > archive->count);
    const struct survey survey = look(archive);
    if (archive->file->status->code != STATUS_OK)
        return archive->file->status->code;
    if (survey.scans + survey.texts + survey.unreadable == 0 && survey.first_text != SIZE_MAX)
        return fail_text(archive, survey.first_text);
    if (read_scan(out, archive, survey.scans == 0) != STATUS_OK)
        return archive->file->status->code;
    if (survey.scans > 0 && survey.texts > 0)
        scan_warn(out, "%zu text%s in the archive (%s%s) passed over beside its %zu other scan%s", survey.texts,
                  survey.texts == 1 ? "" : "s", survey.text, survey.texts == 1 ? "" : ", ...", survey.scans,
                  survey.scans == 1 ? "" : "s");
    if (survey.others > 0)
        scan_warn(out, "passed over in the archive, no scan%s: %s%s", survey.others == 1 ? "" : "s", survey.names,
                  survey.others > ZIP_NAMED ? ", ..." : "");
    return STATUS_OK;
}

enum status_code scan_zip_read(struct scan *out, const struct scan_file *file)
{
    struct archive archive;
    if (archive_open(&archive, file) == STATUS_OK)
        (void)read_archive(out, &archive);
    archive_close(&archive);
    return file->status->code;
}

/* Any other format, packed by gzip (RFC 1952). */
/* Unpacks every member of the file, which are one after another, into `text`. */
enum status_code scan_gz_unpack(struct text *text, const struct scan_file *file)
{
    z_stream stream = {.next_in = (Bytef *)file->bytes};
    const char *end = file->bytes + file->length;
    int code = inflateInit2(&stream, 16 + MAX_WBITS); /* gzip's header */
    bool ended = false;
    size_t most = limit_most(LIMIT_UNPACKED_BYTES);
    if (code != Z_OK)
        return status_memory(file->status);
    enum { PIECE = 65536 };
    unsigned char *piece = malloc(PIECE);
    text->failed = text->failed || !piece;
    while (piece && (code == Z_OK || (code == Z_STREAM_END && (const char *)stream.next_in < end))) {
        size_t left = (size_t)(end - (const char *)stream.next_in);
        if (code == Z_STREAM_END && inflateReset(&stream) != Z_OK)
            break;
        stream.avail_in = left < PIECE ? (uInt)left : PIECE;
        stream.next_out = piece;
        stream.avail_out = PIECE;
        code = inflate(&stream, Z_NO_FLUSH);
        text_add_bytes(text, (const char *)piece, PIECE - stream.avail_out);
        ended = code == Z_STREAM_END;
        if (text->failed || text->length > most || (left == 0 && stream.avail_out > 0))
            break;
    }
    free(piece);
    inflateEnd(&stream);
    if (text->failed || code == Z_MEM_ERROR)
        return status_memory(file->status);
    if (text->length > most)
        return scan_fail(file, 0, "it unpacks to more than %zu bytes%s", most, limit_words(LIMIT_UNPACKED_BYTES).text);
    if (!ended)
        return scan_fail(file, 0, "damaged or cut off within the gzip data; copy the file again");
    return STATUS_OK;
}
