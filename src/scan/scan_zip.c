/* A zip archive that holds scans, as some instruments pack theirs: every entry that a reader knows by its content is
 * one; text only where nothing else is there, and where it has a row of numbers. options->entry says where the search
 * starts: entry i is at i, and at i + the number of entries when texts are sought. */
#include "scan/archive.h"
#include "scan/foreign.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { ZIP_ENTRIES = 1000, ZIP_NAMED = 5 };

enum entry_kind { ENTRY_OTHER, ENTRY_TEXT, ENTRY_SCAN };

/* An entry, unpacked. Owned: entry_free(). */
struct entry {
    struct text text;
    char path[512]; /* for messages: archive(entry) */
    struct scan_bytes file;
    enum entry_kind kind;
    bool empty; /* a folder, or nothing in it */
};

static void entry_free(struct entry *entry)
{
    text_free(&entry->text);
}

bool scan_zip_sniff(const struct scan_bytes *file)
{
    return file->length > 4 && memcmp(file->bytes, "PK\3\4", 4) == 0;
}

/* What an operating system leaves in archives. */
static bool is_hidden(const char *name)
{
    const char *slash = strrchr(name, '/');
    return (slash ? slash[1] : *name) == '.' || strncmp(name, "__MACOSX/", 9) == 0;
}

static enum entry_kind kind_of(const struct scan_bytes *file)
{
    const struct scan_reader *reader = scan_reader_find(file);
    if (!reader || scan_reader_unpacks(reader)) /* no archives within archives */
        return ENTRY_OTHER;
    if (reader->read != scan_text_read)
        return ENTRY_SCAN;
    return scan_is_other(file, true) ? ENTRY_OTHER : ENTRY_TEXT;
}

/* Unpacks entry `index` and tells its kind. Error: damaged, or a measurement in a format that is not read. */
static enum status_code load(struct entry *out, const struct archive *archive, size_t index, struct status *status)
{
    const char *name = archive_name(archive, index);
    *out = (struct entry){.empty = !name || *name == '\0' || name[strlen(name) - 1] == '/' || is_hidden(name)};
    if (out->empty)
        return STATUS_OK;
    snprintf(out->path, sizeof out->path, "%.300s(%.200s)", archive->file->path, name);
    if (archive_read(&out->text, archive, index, status) != STATUS_OK)
        return status->code;
    out->file = (struct scan_bytes){text_string(&out->text), out->text.length, name};
    out->empty = out->file.length == 0;
    const struct foreign *foreign = out->empty ? NULL : foreign_find(&out->file);
    out->kind = foreign || out->empty ? ENTRY_OTHER : kind_of(&out->file);
    out->file.path = out->path;
    return foreign && foreign->kind == FOREIGN_SCAN ? scan_fail_foreign(&out->file, foreign, status) : STATUS_OK;
}

static enum status_code fail_text(const struct archive *archive, size_t index, struct status *status)
{
    char path[512];
    snprintf(path, sizeof path, "%.300s(%.200s)", archive->file->path, archive_name(archive, index));
    const struct scan_bytes entry = {"", 0, path};
    return scan_fail(status, &entry, 0, "no line of numbers in it: not a scan");
}

/* What is in an archive, all in all. */
struct survey {
    size_t scans, texts, others, bytes;
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

static enum status_code look(struct survey *out, const struct archive *archive, struct status *status)
{
    *out = (struct survey){.first_text = SIZE_MAX};
    for (size_t i = 0; i < archive_count(archive); i++) {
        struct entry entry;
        enum status_code code = load(&entry, archive, i, status);
        out->scans += entry.kind == ENTRY_SCAN ? 1 : 0;
        if (entry.kind == ENTRY_TEXT && out->texts++ == 0)
            snprintf(out->text, sizeof out->text, "%.60s", archive_name(archive, i));
        out->bytes += entry.text.length;
        if (code == STATUS_OK && entry.kind == ENTRY_OTHER && !entry.empty) {
            note_other(out, archive_name(archive, i));
            if (out->first_text == SIZE_MAX && scan_text_sniff(&entry.file))
                out->first_text = i;
        }
        entry_free(&entry);
        if (code != STATUS_OK)
            return code;
        if (out->bytes > ARCHIVE_MOST_BYTES)
            return scan_fail(status, archive->file, 0,
                             "the archive unpacks to more than %d MiB; unpack it, or split it",
                             ARCHIVE_MOST_BYTES >> 20);
    }
    return STATUS_OK;
}

/* Moves *at to the next scan from there on, and leaves it unpacked in `entry`; false when there is none. */
static bool seek(struct entry *entry, size_t *at, const struct archive *archive, struct status *status)
{
    size_t count = archive_count(archive);
    bool first_pass = *at > 0 && *at <= count; /* and a scan was found in it: no texts */
    for (; *at < (first_pass ? count : 2 * count); ++*at) {
        if (load(entry, archive, *at % count, status) == STATUS_OK &&
            entry->kind == (*at < count ? ENTRY_SCAN : ENTRY_TEXT))
            return true;
        entry_free(entry);
        if (status->code != STATUS_OK)
            return false;
    }
    return false;
}

static enum status_code read_scan(struct scan *out, const struct archive *archive, const struct scan_options *options,
                                  struct status *status)
{
    size_t at = options->entry;
    struct entry entry;
    if (!seek(&entry, &at, archive, status))
        return status->code != STATUS_OK ? status->code
                                         : scan_fail(status, archive->file, 0, "no scan in this zip archive");
    enum status_code code = scan_read_inner(out, &entry.file, options, status);
    snprintf(out->part, sizeof out->part, "%.100s", archive_name(archive, at % archive_count(archive)));
    scan_printable(out->part);
    entry_free(&entry);
    at++;
    if (code == STATUS_OK && seek(&entry, &at, archive, status)) {
        out->next_entry = at;
        entry_free(&entry);
    }
    return status->code;
}

static enum status_code read_archive(struct scan *out, const struct archive *archive,
                                     const struct scan_options *options, struct status *status)
{
    struct survey survey = {.scans = 0};
    size_t count = archive_count(archive);
    if (count > ZIP_ENTRIES)
        return scan_fail(status, archive->file, 0, "%zu files in the archive; at most %d: unpack it, or split it",
                         count, ZIP_ENTRIES);
    bool first = options->entry == 0;
    if (first && look(&survey, archive, status) != STATUS_OK)
        return status->code;
    if (first && survey.scans == 0 && survey.texts == 0 && survey.first_text != SIZE_MAX)
        return fail_text(archive, survey.first_text, status);
    if (read_scan(out, archive, options, status) != STATUS_OK)
        return status->code;
    if (survey.scans > 0 && survey.texts > 0)
        scan_warn(out, "%zu text%s in the archive (%s%s) passed over beside its %zu other scan%s", survey.texts,
                  survey.texts == 1 ? "" : "s", survey.text, survey.texts == 1 ? "" : ", ...", survey.scans,
                  survey.scans == 1 ? "" : "s");
    if (survey.others > 0)
        scan_warn(out, "passed over in the archive, no scan%s: %s%s", survey.others == 1 ? "" : "s", survey.names,
                  survey.others > ZIP_NAMED ? ", ..." : "");
    return STATUS_OK;
}

enum status_code scan_zip_read(struct scan *out, const struct scan_bytes *file, const struct scan_options *options,
                               struct status *status)
{
    struct archive archive;
    enum status_code code = archive_open(&archive, file, status);
    if (code == STATUS_OK)
        code = read_archive(out, &archive, options, status);
    archive_close(&archive);
    return code;
}
