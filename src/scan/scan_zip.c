/* A zip archive that holds a scan, as some instruments pack theirs: the first entry that a reader knows by its content
 * (text only when nothing else is there). */
#include "scan/archive.h"

#include <stdio.h>
#include <string.h>

/* entries looked at; an archive of one scan has a few */
enum { ZIP_ENTRIES = 64 };

bool scan_zip_sniff(const struct scan_bytes *file)
{
    return file->length > 4 && memcmp(file->bytes, "PK\3\4", 4) == 0;
}

/* Reads entry `index` when it is a scan of the wanted kind, text or not; *tried tells whether it was. */
static enum status_code try_entry(struct scan *out, const struct archive *archive, size_t index, bool as_text,
                                  const struct scan_options *options, bool *tried, struct status *status)
{
    const char *name = archive_name(archive, index);
    *tried = false;
    if (!name || *name == '\0' || name[strlen(name) - 1] == '/')
        return STATUS_OK;
    struct text text = {0};
    enum status_code code = archive_read(&text, archive, index, status);
    char path[512];
    snprintf(path, sizeof path, "%.300s(%.200s)", archive->file->path, name);
    struct scan_bytes entry = {text_string(&text), text.length, path};
    bool open = code == STATUS_OK && entry.length > 0 && !scan_zip_sniff(&entry); /* no archives within archives */
    const struct scan_reader *reader = open ? scan_reader_find(&entry) : NULL;
    if (reader && (reader->read == scan_text_read) == as_text) {
        *tried = true;
        out->format = reader->name;
        code = reader->read(out, &entry, options, status);
    }
    text_free(&text);
    return code;
}

/* Tries the entries one after the other; a text that is no scan (a readme) is passed over. */
static enum status_code try_entries(struct scan *out, const struct archive *archive, const struct scan_options *options,
                                    struct status *status)
{
    size_t count = archive_count(archive) < ZIP_ENTRIES ? archive_count(archive) : ZIP_ENTRIES;
    struct status first = {0};
    for (int as_text = 0; as_text < 2; as_text++) {
        for (size_t i = 0; i < count; i++) {
            struct status problem = {0};
            bool tried;
            enum status_code code = try_entry(out, archive, i, as_text, options, &tried, &problem);
            if (code == STATUS_OK && tried)
                return STATUS_OK;
            first = first.code == STATUS_OK ? problem : first;
            if (code != STATUS_OK && (!as_text || code != STATUS_SCAN))
                return status_fail(status, code, "%s", problem.message);
            scan_free(out);
            *out = (struct scan){.ny = 1};
        }
    }
    if (first.code != STATUS_OK)
        return status_fail(status, first.code, "%s", first.message);
    return scan_fail(status, archive->file, 0, "no scan in this zip archive");
}

enum status_code scan_zip_read(struct scan *out, const struct scan_bytes *file, const struct scan_options *options,
                               struct status *status)
{
    struct archive archive;
    enum status_code code = archive_open(&archive, file, status);
    if (code == STATUS_OK)
        code = try_entries(out, &archive, options, status);
    if (code == STATUS_OK && archive_count(&archive) > 1)
        scan_warn(out, "the archive holds %zu files: only one scan was read", archive_count(&archive));
    archive_close(&archive);
    return code;
}
