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

const char *const folder_names[FOLDERS] = {".", "data", "figures"};

static int open_directory(int parent, const char *name)
{
    return openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

bool folders_open(struct folders *out, int parent, const char *path)
{
    *out = (struct folders){{open_directory(parent, path), -1, -1}};
    for (int i = 1; i < FOLDERS && out->at[0] >= 0; i++)
        out->at[i] = open_directory(out->at[0], folder_names[i]);
    return out->at[0] >= 0;
}

void folders_close(const struct folders *folders)
{
    for (int i = 0; i < FOLDERS; i++)
        if (folders->at[i] >= 0)
            close(folders->at[i]);
}

int folders_in(const struct folders *folders, const char *name, const char **base)
{
    const char *slash = strchr(name, '/');
    *base = slash ? slash + 1 : name;
    return folders->at[!slash ? 0 : *name == 'd' ? 1 : 2];
}

static int compare(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

static bool add(struct names *names, const char *folder, const char *name)
{
    if ((names->count & (names->count - 1)) == 0) { /* as many as there is room for: a power of two */
        char **more = reallocarray(names->at, names->count ? 2 * names->count : 1, sizeof *more);
        if (!more)
            return false;
        names->at = more;
    }
    return asprintf(&names->at[names->count], "%s%s", folder, name) >= 0 && ++names->count > 0;
}

static void sort(struct names *names)
{
    if (names->count > 0)
        qsort(names->at, names->count, sizeof *names->at, compare);
}

bool names_list(struct names *out, const struct folders *folders)
{
    static const char *const prefixes[FOLDERS] = {"", "data/", "figures/"};
    bool ok = true;
    for (int i = 0; i < FOLDERS && ok; i++) {
        int again = folders->at[i] >= 0 ? open_directory(folders->at[i], ".") : -1;
        DIR *list = again >= 0 ? fdopendir(again) : NULL;
        ok = list || folders->at[i] < 0;
        for (const struct dirent *entry; list && ok && (entry = readdir(list));) {
            bool passed = strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0;
            for (int k = 1; k < FOLDERS && i == 0; k++)
                passed |= folders->at[k] >= 0 && strcmp(entry->d_name, folder_names[k]) == 0;
            ok = passed || add(out, prefixes[i], entry->d_name);
        }
        if (list)
            closedir(list);
    }
    sort(out);
    return ok;
}

bool names_read(struct names *out, const struct folders *folders)
{
    struct stat info;
    char *line = NULL;
    size_t size = 0;
    ssize_t length;
    int file = openat(folders->at[0], MANIFEST_NAME, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    bool ours = file >= 0 && fstat(file, &info) == 0 && S_ISREG(info.st_mode) && info.st_size <= LARGEST, ok = true;
    FILE *stream = ours ? fdopen(file, "r") : NULL;
    if (!stream) {
        if (file >= 0)
            close(file);
        return true;
    }
    if (getline(&line, &size, stream) > 0 && strcmp(line, MANIFEST_HEADER) == 0)
        while (ok && (length = getline(&line, &size, stream)) > 0 && line[length - 1] == '\n') {
            line[length - 1] = '\0';
            ok = add(out, "", line);
        }
    ok = ok && !ferror(stream);
    fclose(stream);
    free(line);
    sort(out);
    return ok;
}

bool names_have(const struct names *names, const char *name)
{
    return names->count > 0 && bsearch(&name, names->at, names->count, sizeof *names->at, compare);
}

void names_free(struct names *names)
{
    for (size_t i = 0; i < names->count; i++)
        free(names->at[i]);
    free(names->at);
}

bool manifest_write(const struct folders *folders)
{
    struct names names = {0};
    const char *base;
    int made = openat(folders->at[0], MANIFEST_NAME, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    FILE *stream = made >= 0 ? fdopen(made, "w") : NULL;
    bool ok = stream && names_list(&names, folders) && fputs(MANIFEST_HEADER, stream) >= 0;
    for (size_t i = 0; i < names.count && ok; i++) {
        assert(!strchr(names.at[i], '\n'));
        ok = fprintf(stream, "%s\n", names.at[i]) >= 0;
    }
    ok = ok && fflush(stream) == 0;
    for (size_t i = 0; i < 2 * names.count && ok; i++) { /* all begin to be written before one is waited for */
        int in = folders_in(folders, names.at[i % names.count], &base), file = openat(in, base, O_RDONLY | O_CLOEXEC);
        ok =
            file >= 0 && (i < names.count ? (sync_file_range(file, 0, 0, SYNC_FILE_RANGE_WRITE), 0) : fsync(file)) == 0;
        if (file >= 0)
            close(file);
    }
    for (int i = 0; i < FOLDERS && ok; i++)
        (void)!fsync(folders->at[i]); /* which not every file system can */
    int reason = errno;
    names_free(&names);
    if (stream)
        fclose(stream);
    errno = reason;
    return ok;
}
