/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/scene_files.h"

#include "base/limits.h"
#include "scan/sidecar.h"
#include "scene/scene_listing.h"
#include "scene/scene_words.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <fnmatch.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

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

static int compare_paths(const void *a, const void *b)
{
    return scene_listing_order(*(char *const *)a, *(char *const *)b);
}

static bool is_regular(int directory, const char *name)
{
    struct stat info;
    return fstatat(directory, name, &info, 0) == 0 && S_ISREG(info.st_mode);
}

bool scene_files_holds_scans(int directory, const char *name)
{
    struct dirent **entries = NULL;
    int count = scandirat(directory, name, &entries, NULL, NULL), files = 0;
    int inside = openat(directory, name, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    bool report = false;
    for (int i = 0; i < count; i++) {
        const char *file = entries[i]->d_name;
        report = report || strcmp(file, "results.json") == 0;
        files += inside >= 0 && file[0] != '.' && is_regular(inside, file);
        free(entries[i]);
    }
    free(entries);
    if (inside >= 0)
        close(inside);
    return files > 0 && !report;
}

static int compare_bytes(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

/* The first of the `count` files in `order`, which is that of strcmp(), whose first `length` characters do not come
 * before those of `name`. */
static size_t find_first(char *const *order, size_t count, const char *name, size_t length)
{
    size_t low = 0, high = count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (strncmp(order[middle], name, length) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Is there a file that `file`, whose name has an ending of sidecars, may be beside: `a` or `a.csv` of `a.txt`? */
static bool has_scan(char *const *order, size_t count, const char *file)
{
    size_t stem = (size_t)(strrchr(file, '.') - file), at = find_first(order, count, file, stem);
    bool bare = at < count && strncmp(order[at], file, stem) == 0 && order[at][stem] == '\0';
    at = find_first(order, count, file, stem + 1); /* the dot too */
    while (!bare && at < count && strncmp(order[at], file, stem + 1) == 0 &&
           !sidecar_fits(basename(file), basename(order[at])))
        at++;
    return bare || (at < count && strncmp(order[at], file, stem + 1) == 0);
}

/* Is it one that only says units of another among them? */
static bool is_sidecar(const struct scene *scene, char *const *order, size_t count, const char *file)
{
    size_t stem;
    struct sidecar sidecar;
    if (!sidecar_ending(basename(file), &stem) || !has_scan(order, count, file))
        return false;
    char *path = scene_file_path(scene, file);
    bool is = path && sidecar_read(&sidecar, path);
    free(path);
    return is;
}

/* Takes the sidecars out of the files from `first` on. */
static enum status_code drop_sidecars(struct scene_surface *surface, const struct scene *scene, size_t first,
                                      struct status *status)
{
    char **files = surface->files + first, **order;
    size_t count = surface->file_count - first, kept = 0, sidecars = 0;
    bool *is = calloc(count + 1, sizeof *is);
    order = malloc((count + 1) * sizeof *order);
    if (!is || !order) {
        free(is);
        free(order);
        return status_memory(status);
    }
    memcpy(order, files, count * sizeof *order);
    qsort(order, count, sizeof *order, compare_bytes);
    for (size_t i = 0; i < count; i++)
        sidecars += is[i] = is_sidecar(scene, order, count, files[i]);
    free(order);
    for (size_t i = 0; i < count; i++)
        if (is[i] && sidecars < count) /* two that fit each other are none */
            free(files[i]);
        else
            files[kept++] = files[i];
    surface->file_count = first + kept;
    free(is);
    return STATUS_OK;
}

enum status_code scene_files_match(struct scene_surface *surface, const struct scene *scene, const char *pattern,
                                   struct status *status)
{
    const char *slash = strrchr(pattern, '/'), *name = slash ? slash + 1 : pattern;
    size_t before = (size_t)(name - pattern), first = surface->file_count;
    char *folder = strndup(pattern, before);
    char *path = folder ? scene_file_path(scene, before ? folder : ".") : NULL;
    struct dirent **entries = NULL;
    enum status_code code = path ? STATUS_OK : status_memory(status);
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
        if (code == STATUS_OK && fnmatch(name, entries[i]->d_name, FNM_PERIOD) == 0 &&
            is_regular(directory, entries[i]->d_name))
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
    qsort(surface->files + first, surface->file_count - first, sizeof *surface->files, compare_paths);
    return drop_sidecars(surface, scene, first, status);
}
