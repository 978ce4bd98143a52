/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/archive.h"
#include "base/limits.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

bool scan_tells_at_end(const char *bytes, size_t length)
{
    return length > 4 && memcmp(bytes, "PK\3\4", 4) == 0;
}

/** libzip does not always say that it was memory; malloc() does. */
static enum status_code fail_open(const struct scan_file *file, zip_error_t *error)
{
    return errno == ENOMEM
               ? status_memory(file->status)
               : scan_fail(file, 0, "damaged zip archive (%s); copy the file again", zip_error_strerror(error));
}

/* May all entries be unpacked, one after another: are the claimed sizes within the limits, and do the packed bytes fit
 * into the file one behind another? Where they do not, entries share them, which makes a small file large. */
static enum status_code check_entries(struct archive *archive)
{
    const struct scan_file *file = archive->file;
    size_t total = 0, packed = 0, most = limit_most(LIMIT_UNPACKED_BYTES);
    for (size_t i = 0; i < archive->count; i++) {
        zip_stat_t stat, *entry = &stat;
        if (zip_stat_index(archive->zip, i, 0, entry) != 0)
            return fail_open(file, zip_get_error(archive->zip));
        if (entry->comp_size > file->length - packed)
            return scan_fail(file, 0, "entries of the archive share their bytes: damaged, or made to fill a memory");
        if (entry->size > limit_unpacked(entry->comp_size))
            return scan_fail(file, 0, "'%.80s' in the archive claims %zu bytes, packed in %zu%s", entry->name,
                             (size_t)entry->size, (size_t)entry->comp_size, limit_words(LIMIT_UNPACKED_RATIO).text);
        if (entry->size > most - total)
            return scan_fail(file, 0, "the archive unpacks to more than %zu bytes%s", most,
                             limit_words(LIMIT_UNPACKED_BYTES).text);
        packed += entry->comp_size;
        total += entry->size;
    }
    return STATUS_OK;
}

enum status_code archive_open(struct archive *out, const struct scan_file *file)
{
    zip_error_t error;
    errno = 0;
    zip_error_init(&error);
    *out = (struct archive){.file = file};
    zip_source_t *source = zip_source_buffer_create(file->bytes, file->length, 0, &error);
    out->zip = source ? zip_open_from_source(source, ZIP_RDONLY, &error) : NULL;
    if (!out->zip) {
        zip_source_free(source);
        fail_open(file, &error);
        zip_error_fini(&error);
        return file->status->code;
    }
    out->count = (size_t)zip_get_num_entries(out->zip, 0);
    if (out->count > limit_most(LIMIT_MEMBERS))
        return scan_fail(file, 0, "%zu files in the archive%s", out->count, limit_words(LIMIT_MEMBERS).text);
    return check_entries(out);
}

void archive_close(struct archive *archive)
{
    zip_discard(archive->zip);
}

zip_stat_t archive_entry(const struct archive *archive, size_t index)
{
    zip_stat_t entry = {0};
    (void)zip_stat_index(archive->zip, index, 0, &entry); /* it was found when the archive was opened */
    return entry;
}

size_t archive_find(const struct archive *archive, const char *name, bool anywhere)
{
    size_t i = 0;
    for (; i < archive->count; i++) {
        const char *own = archive_entry(archive, i).name, *slash = anywhere ? strrchr(own, '/') : NULL;
        if (strcasecmp(slash ? slash + 1 : own, name) == 0)
            break;
    }
    return i;
}

enum status_code archive_read(struct text *text, const struct archive *archive, size_t index, size_t most,
                              const struct scan_file *file)
{
    const zip_stat_t stat = archive_entry(archive, index), *entry = &stat;
    size_t size = entry->size < most ? (size_t)entry->size : most;
    if (entry->encryption_method != ZIP_EM_NONE)
        return scan_fail(file, 0, "'%.80s' in the archive is encrypted; unpack it", entry->name);
    if (entry->comp_method != ZIP_CM_STORE && entry->comp_method != ZIP_CM_DEFLATE)
        return scan_fail(file, 0, "'%.80s' in the archive is packed by method %u, and only deflate is read; unpack it",
                         entry->name, entry->comp_method);
    *text = (struct text){.data = malloc(size + 1), .length = size, .capacity = size + 1};
    if (!text->data)
        return *text = (struct text){0}, status_memory(file->status);
    text->data[size] = '\0';
    errno = 0;
    zip_file_t *opened = zip_fopen_index(archive->zip, index, 0);
    char beyond; /* reading on behind the last byte compares size and checksum */
    bool good = opened && zip_fread(opened, text->data, size) == (zip_int64_t)size &&
                (size < entry->size || zip_fread(opened, &beyond, 1) == 0);
    if (opened)
        zip_fclose(opened);
    if (!good)
        return errno == ENOMEM
                   ? status_memory(file->status)
                   : scan_fail(file, 0, "'%.80s' in the archive is damaged; copy the file again", entry->name);
    return STATUS_OK;
}
