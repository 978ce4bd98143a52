/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/manifest.h"

#include <assert.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { LARGEST = 1 << 20 }; /* bytes; a larger one is none of ours */

static bool is_folder(int root, const char *name)
{
    struct stat info;
    return (strcmp(name, "data") == 0 || strcmp(name, "figures") == 0) &&
           fstatat(root, name, &info, AT_SYMLINK_NOFOLLOW) == 0 && S_ISDIR(info.st_mode);
}

/** Adds the entries of `path`, each after `prefix`. */
static enum status_code add_entries(struct manifest_entries *out, const char *path, const char *prefix,
                                    struct status *status)
{
    int descriptor = open(path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    DIR *directory = descriptor >= 0 ? fdopendir(descriptor) : NULL;
    if (!directory) {
        int reason = errno;
        if (descriptor >= 0)
            close(descriptor);
        if (*prefix && (reason == ENOENT || reason == ENOTDIR))
            return STATUS_OK;
        return status_fail(status, STATUS_IO, "cannot read directory '%s': %s", path, strerror(reason));
    }
    enum status_code rc = STATUS_OK;
    errno = 0;
    for (const struct dirent *entry; rc == STATUS_OK && (entry = readdir(directory)); errno = 0) {
        const char *name = entry->d_name;
        if (strcmp(name, ".") == 0 || strcmp(name, "..") == 0 || (!*prefix && is_folder(descriptor, name)))
            continue;
        char **names = realloc(out->names, (out->count + 1) * sizeof *names);
        if (names)
            out->names = names;
        if (!names || asprintf(&names[out->count], "%s%s", prefix, name) < 0)
            rc = status_memory(status);
        else
            out->count++;
    }
    if (rc == STATUS_OK && errno)
        rc = status_fail(status, STATUS_IO, "cannot read directory '%s': %s", path, strerror(errno));
    closedir(directory);
    return rc;
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

enum status_code manifest_entries(struct manifest_entries *out, const char *directory, struct status *status)
{
    static const char *const prefixes[] = {"", "data/", "figures/"};
    enum status_code rc = STATUS_OK;
    *out = (struct manifest_entries){0};
    for (size_t i = 0; rc == STATUS_OK && i < sizeof prefixes / sizeof *prefixes; i++) {
        struct text path = {0};
        text_add(&path, "%s/%.*s", directory, (int)strcspn(prefixes[i], "/"), prefixes[i]);
        rc = path.failed ? status_memory(status) : add_entries(out, path.data, prefixes[i], status);
        text_free(&path);
    }
    if (out->count > 0)
        qsort(out->names, out->count, sizeof *out->names, compare_names);
    return rc;
}

void manifest_entries_free(struct manifest_entries *entries)
{
    for (size_t i = 0; i < entries->count; i++)
        free(entries->names[i]);
    free(entries->names);
    *entries = (struct manifest_entries){0};
}

static enum status_code write_lines(const char *path, const struct manifest_entries *entries, struct status *status)
{
    struct text text = {0};
    text_add(&text, MANIFEST_HEADER);
    for (size_t i = 0; i < entries->count; i++) {
        assert(!strchr(entries->names[i], '\n'));
        text_add(&text, "%s\n", entries->names[i]);
    }
    enum status_code rc = text.failed ? status_memory(status) : text_write_file(path, text.data, text.length, status);
    text_free(&text);
    return rc;
}

enum status_code manifest_write(const char *directory, struct status *status)
{
    struct manifest_entries entries = {0};
    struct text path = {0};
    text_add(&path, "%s/" MANIFEST_NAME, directory);
    enum status_code rc = path.failed ? status_memory(status) : write_lines(path.data, &entries, status);
    if (rc == STATUS_OK) /* it is there now, and so lists itself */
        rc = manifest_entries(&entries, directory, status);
    if (rc == STATUS_OK)
        rc = write_lines(path.data, &entries, status);
    manifest_entries_free(&entries);
    text_free(&path);
    return rc;
}

enum status_code manifest_read(struct text *out, const char *directory, struct status *status)
{
    struct text path = {0};
    struct stat info;
    enum status_code rc = STATUS_OK;
    text_add(&path, "%s/" MANIFEST_NAME, directory);
    if (path.failed)
        rc = status_memory(status);
    else if (lstat(path.data, &info) == 0 && S_ISREG(info.st_mode) && info.st_size <= LARGEST)
        rc = text_read_file(out, path.data, status);
    text_free(&path);
    if (rc == STATUS_OK && strncmp(text_string(out), MANIFEST_HEADER, strlen(MANIFEST_HEADER)) != 0)
        text_free(out);
    return rc;
}

bool manifest_lists(const struct text *manifest, const char *name)
{
    size_t length = strlen(name);
    const char *line = text_string(manifest);
    line += strcspn(line, "\n"); /* the header is no name */
    while (*line) {
        line++;
        size_t size = strcspn(line, "\n");
        if (size == length && line[size] == '\n' && memcmp(line, name, length) == 0)
            return true;
        line += size;
    }
    return false;
}
