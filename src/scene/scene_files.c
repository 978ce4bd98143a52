/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/scene_files.h"
#include "base/limits.h"
#include "scan/sidecar.h"
#include "scene/scene_words.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <fnmatch.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

char *scene_file_path(const struct scene *scene, const char *file)
{
    const char *directory = file[0] == '/' ? "" : scene->directory;
    size_t length = strlen(directory);
    char *path;
    bool joined = length == 0 || directory[length - 1] == '/';
    return asprintf(&path, "%s%s%s", directory, joined ? "" : "/", file) < 0 ? NULL : path;
}

bool scene_files_is_pattern(const char *path)
{
    return strpbrk(path, "*?[") != NULL;
}

enum status_code scene_files_add(struct scene_surface *surface, const char *file, struct status *status)
{
    char **files = reallocarray(surface->files, surface->file_count + 1, sizeof *files);
    if (!files)
        return status_memory(status);
    surface->files = files;
    files[surface->file_count] = strdup(file);
    return files[surface->file_count++] ? STATUS_OK : status_memory(status);
}

/* Compares the numbers that `*a` and `*b` start with, and moves both past them. */
static int compare_numbers(const char **a, const char **b)
{
    const char *first = *a + strspn(*a, "0"), *second = *b + strspn(*b, "0");
    size_t length = strspn(first, "0123456789"), other = strspn(second, "0123456789");
    *a = first + length;
    *b = second + other;
    if (length != other)
        return length < other ? -1 : 1;
    return memcmp(first, second, length);
}

int scene_files_order(const char *a, const char *b)
{
    const char *first = a, *second = b;
    while (*first && *second) {
        int order;
        if (isdigit((unsigned char)*first) && isdigit((unsigned char)*second))
            order = compare_numbers(&first, &second);
        else
            order = (unsigned char)*first++ - (unsigned char)*second++;
        if (order != 0)
            return order;
    }
    if (*first || *second)
        return *first ? 1 : -1;
    return strcmp(a, b); /* 01 and 1 */
}

static int compare_naturally(const void *a, const void *b)
{
    return scene_files_order(*(char *const *)a, *(char *const *)b);
}

static int compare_bytes(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

/* Does `file` only say units of scans, wherever these are? */
static bool is_sidecar(const struct scene *scene, const char *file)
{
    size_t stem;
    struct sidecar sidecar;
    char *path = sidecar_ending(file, &stem) ? scene_file_path(scene, file) : NULL;
    bool is = path && sidecar_read(&sidecar, path);
    free(path);
    return is;
}

/* Is one of the scans, in the order of their bytes, what the sidecar `file` may be beside: `a` or `a.csv` of `a.txt`?
 */
static bool has_scan(char *const *scans, size_t count, const char *file)
{
    size_t stem, low = 0, high = count;
    if (!sidecar_ending(file, &stem))
        return false;
    while (low < high) { /* the first that begins with the stem */
        size_t middle = low + (high - low) / 2;
        if (strncmp(scans[middle], file, stem) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    while (low < count && strncmp(scans[low], file, stem) == 0 && !sidecar_fits(file, scans[low]))
        low++;
    return low < count && strncmp(scans[low], file, stem) == 0;
}

/* Takes those out of the files from `first` on that only say units of others among them. */
static void drop_sidecars(struct scene_surface *surface, const struct scene *scene, size_t first)
{
    char **files = surface->files + first;
    size_t count = surface->file_count - first, scans = 0;
    for (size_t i = 0; i < count; i++) { /* sidecars go behind the scans */
        char *file = files[i];
        if (!is_sidecar(scene, file)) {
            files[i] = files[scans];
            files[scans++] = file;
        }
    }
    qsort(files, scans, sizeof *files, compare_bytes);
    surface->file_count = first + scans;
    for (size_t i = scans; i < count; i++) {
        if (has_scan(files, scans, files[i]))
            free(files[i]);
        else
            surface->files[surface->file_count++] = files[i];
    }
}

enum status_code scene_files_match(struct scene_surface *surface, const struct scene *scene, const char *pattern,
                                   mode_t kind, struct status *status)
{
    const char *slash = strrchr(pattern, '/'), *name = slash ? slash + 1 : pattern;
    size_t first = surface->file_count;
    char *folder = strndup(pattern, (size_t)(name - pattern));
    char *path = folder && *folder ? scene_file_path(scene, folder) : strdup(scene->directory);
    struct dirent **entries = NULL;
    enum status_code code = folder && path ? STATUS_OK : status_memory(status);
    int count = path ? scandir(path, &entries, NULL, NULL) : 0;
    int directory = path ? open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC) : -1;
    if (path && (count < 0 || directory < 0))
        code = status_fail(status, STATUS_IO, "cannot list '%s': %s", scene_words_show(path, strlen(path)).text,
                           strerror(errno));
    if (count > 0 && (size_t)count > limit_most(LIMIT_FILES))
        code = status_fail(status, STATUS_SCENE, "%d files in '%s'%s", count, scene_words_show(path, strlen(path)).text,
                           limit_words(LIMIT_FILES).text);
    for (int i = 0; i < count; i++) {
        char *file = NULL;
        struct stat info;
        if (code == STATUS_OK && fnmatch(name, entries[i]->d_name, FNM_PERIOD) == 0 &&
            fstatat(directory, entries[i]->d_name, &info, 0) == 0 && (info.st_mode & S_IFMT) == kind)
            code = asprintf(&file, "%s%s", folder, entries[i]->d_name) < 0 ? status_memory(status)
                                                                           : scene_files_add(surface, file, status);
        free(file);
        free(entries[i]);
    }
    free(entries);
    if (directory >= 0)
        close(directory);
    free(path);
    free(folder);
    if (code != STATUS_OK || surface->file_count == first)
        return code;
    if (kind == S_IFREG)
        drop_sidecars(surface, scene, first);
    qsort(surface->files + first, surface->file_count - first, sizeof *surface->files, compare_naturally);
    return STATUS_OK;
}
