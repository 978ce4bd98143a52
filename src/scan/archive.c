#include "scan/archive.h"

#include <stdlib.h>
#include <string.h>
#include <zip.h>

/* Deflate makes nothing smaller than a 1032nd: an entry that claims more is a bomb or damaged. */
enum { ARCHIVE_RATIO = 1040, ARCHIVE_SLACK = 64 };

enum status_code archive_open(struct archive *out, const struct scan_bytes *file, struct status *status)
{
    *out = (struct archive){NULL, file};
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t *source = zip_source_buffer_create(file->bytes, file->length, 0, &error);
    out->zip = source ? zip_open_from_source(source, ZIP_RDONLY, &error) : NULL;
    if (!out->zip) {
        zip_source_free(source);
        scan_fail(status, file, 0, "damaged zip archive (%s); copy the file again", zip_error_strerror(&error));
    }
    zip_error_fini(&error);
    return status->code;
}

void archive_close(struct archive *archive)
{
    if (archive->zip)
        zip_discard(archive->zip);
    archive->zip = NULL;
}

size_t archive_count(const struct archive *archive)
{
    return (size_t)zip_get_num_entries(archive->zip, 0);
}

const char *archive_name(const struct archive *archive, size_t index)
{
    return zip_get_name(archive->zip, index, 0);
}

size_t archive_find(const struct archive *archive, const char *name, bool anywhere)
{
    zip_int64_t index = zip_name_locate(archive->zip, name, ZIP_FL_NOCASE | (anywhere ? ZIP_FL_NODIR : 0));
    return index < 0 ? archive_count(archive) : (size_t)index;
}

bool archive_has(const struct scan_bytes *file, const char *name, bool anywhere, bool damaged)
{
    struct archive archive;
    struct status ignored = {0};
    bool opened = archive_open(&archive, file, &ignored) == STATUS_OK;
    bool found = opened ? archive_find(&archive, name, anywhere) < archive_count(&archive) : damaged;
    archive_close(&archive);
    return found;
}

enum status_code archive_read(struct text *text, const struct archive *archive, size_t index, struct status *status)
{
    zip_stat_t info;
    const char *name = archive_name(archive, index);
    if (!name || zip_stat_index(archive->zip, index, 0, &info) != 0 || !(info.valid & ZIP_STAT_SIZE) ||
        !(info.valid & ZIP_STAT_COMP_SIZE))
        return scan_fail(status, archive->file, 0, "damaged zip archive; copy the file again");
    if (info.comp_size > archive->file->length || info.size > info.comp_size * ARCHIVE_RATIO + ARCHIVE_SLACK)
        return scan_fail(status, archive->file, 0, "'%.80s' in the archive claims %llu bytes: damaged", name,
                         (unsigned long long)info.size);
    if (info.size > ARCHIVE_MOST_BYTES)
        return scan_fail(status, archive->file, 0, "'%.80s' in the archive unpacks to more than %d MiB", name,
                         ARCHIVE_MOST_BYTES >> 20);
    zip_file_t *entry = zip_fopen_index(archive->zip, index, 0);
    if (!entry)
        return scan_fail(status, archive->file, 0, "cannot unpack '%.80s': %s", name, zip_strerror(archive->zip));
    char *buffer = malloc(info.size + 1);
    /* one byte more than there should be: only at the end does libzip compare the checksum */
    zip_int64_t got = buffer ? zip_fread(entry, buffer, info.size + 1) : -1;
    if (buffer && got == (zip_int64_t)info.size && zip_fread(entry, &(char){0}, 1) == 0)
        text_add_bytes(text, buffer, info.size);
    else
        got = -1;
    bool lacking = !buffer || text->failed;
    free(buffer);
    zip_fclose(entry);
    if (lacking)
        return status_memory(status);
    if (got < 0)
        return scan_fail(status, archive->file, 0, "'%.80s' in the archive is damaged; copy the file again", name);
    return STATUS_OK;
}
