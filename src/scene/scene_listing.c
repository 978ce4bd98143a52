/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/scene_listing.h"
#include "base/limits.h"
#include "base/text.h"
#include "scan/scan.h"
#include "scan/sidecar.h"
#include "scene/scene_files.h"
#include "scene/scene_surfaces.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

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

int scene_listing_order(const char *a, const char *b)
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

static int compare_surfaces(const void *a, const void *b)
{
    const struct scene_surface *first = a, *second = b;
    int order = scene_listing_order(first->name, second->name);
    return order ? order : strcmp(first->files[0], second->files[0]);
}

static enum status_code add_surface(struct scene *scene, const char *file, struct status *status)
{
    struct scene_surface *surface = &scene->surfaces[scene->surface_count++];
    *surface = (struct scene_surface){.name = scene_surfaces_name(file, false), .files = calloc(1, sizeof(char *))};
    if (!surface->files)
        return status_memory(status);
    surface->file_count = 1;
    surface->files[0] = strdup(file);
    return surface->name && surface->files[0] ? STATUS_OK : status_memory(status);
}

/* Gives surfaces that share a name the ending of their file, until all differ (file names do). */
static enum status_code tell_apart(struct scene *scene, struct status *status)
{
    struct scene_surface *all = scene->surfaces;
    for (bool again = true; again;) {
        again = false;
        qsort(all, scene->surface_count, sizeof *all, compare_surfaces);
        for (size_t i = 0, end; i < scene->surface_count; i = end) {
            for (end = i + 1; end < scene->surface_count && strcmp(all[i].name, all[end].name) == 0;)
                end++;
            for (size_t j = i; end > i + 1 && j < end; j++) {
                if (strchr(all[j].files[0], '/')) /* a directory's name is all it has */
                    continue;
                free(all[j].name);
                if (!(all[j].name = scene_surfaces_name(all[j].files[0], true)))
                    return status_memory(status);
                again = true;
            }
        }
    }
    return STATUS_OK;
}

static bool is_same(int directory, const char *file, const struct stat *info)
{
    struct stat other;
    return fstatat(directory, file, &other, 0) == 0 && other.st_dev == info->st_dev && other.st_ino == info->st_ino;
}

/* Is the file spoken for, however its path is spelt: the counterface's scan, or measurements? */
static bool is_taken(const struct scene *scene, int directory, const struct stat *info)
{
    for (size_t i = 0; i < scene->counterface_surface.file_count; i++)
        if (is_same(directory, scene->counterface_surface.files[i], info))
            return true;
    return scene->measured.file && is_same(directory, scene->measured.file, info);
}

static bool is_candidate(const struct scene *scene, int directory, const char *file)
{
    struct stat info;
    return file[0] != '.' && strcmp(file, "scene.yaml") != 0 && fstatat(directory, file, &info, 0) == 0 &&
           S_ISREG(info.st_mode) && !is_taken(scene, directory, &info);
}

static int compare_files(const void *a, const void *b)
{
    return strcmp(((const struct scene_surface *)a)->files[0], ((const struct scene_surface *)b)->files[0]);
}

/* Is `file` the name of a sidecar of one of the first `count` surfaces, which are in order, or of a counterface's scan?
 */
static bool has_scan(const struct scene *scene, size_t count, const char *file)
{
    size_t stem, low = 0, high = count;
    if (!sidecar_ending(file, &stem))
        return false;
    while (low < high) { /* the first that begins with the stem */
        size_t middle = low + (high - low) / 2;
        if (strncmp(scene->surfaces[middle].files[0], file, stem) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    for (; low < count && strncmp(scene->surfaces[low].files[0], file, stem) == 0; low++)
        if (sidecar_fits(file, scene->surfaces[low].files[0]))
            return true;
    for (size_t i = 0; i < scene->counterface_surface.file_count; i++)
        if (sidecar_fits(file, basename(scene->counterface_surface.files[i])))
            return true;
    return false;
}

/* Takes out the files that only say units of scans beside them. */
static void drop_sidecars(struct scene *scene)
{
    struct scene_surface *all = scene->surfaces;
    size_t count = scene->surface_count, scans = 0, stem;
    for (size_t i = 0; i < count; i++) { /* what may be a sidecar goes behind the scans */
        struct scene_surface surface = all[i];
        struct sidecar sidecar;
        char *path = sidecar_ending(surface.files[0], &stem) ? scene_file_path(scene, surface.files[0]) : NULL;
        if (!path || !sidecar_read(&sidecar, path)) {
            all[i] = all[scans];
            all[scans++] = surface;
        }
        free(path);
    }
    qsort(all, scans, sizeof *all, compare_files);
    scene->surface_count = scans;
    for (size_t i = scans; i < count; i++) {
        if (has_scan(scene, scans, all[i].files[0]))
            scene_surfaces_free(&all[i], NULL);
        else
            all[scene->surface_count++] = all[i];
    }
}

/* A file that is no scan, and what it is. */
struct other {
    const char *kind;
    char *file;
};

/* By kind, then by name. */
static int compare_others(const void *a, const void *b)
{
    const struct other *first = a, *second = b;
    int order = strcmp(first->kind, second->kind);
    return order ? order : scene_listing_order(first->file, second->file);
}

/* "passed over: 2 PNG pictures (a.png, b.png)", a line a kind. */
static enum status_code tell_others(struct scene *scene, struct other *others, size_t count, struct status *status)
{
    enum { NAMED = 8 };
    struct text lines = {0};
    qsort(others, count, sizeof *others, compare_others);
    for (size_t i = 0, end; i < count; i = end) {
        for (end = i + 1; end < count && strcmp(others[end].kind, others[i].kind) == 0;)
            end++;
        text_add(&lines, "%spassed over, no scan%s: %zu x %s (", i > 0 ? "\n" : "", end - i == 1 ? "" : "s", end - i,
                 others[i].kind);
        for (size_t k = i; k < end && k < i + NAMED; k++) {
            text_add(&lines, "%s", k > i ? ", " : "");
            text_add_shown(&lines, others[k].file);
        }
        text_add(&lines, "%s)", end - i > NAMED ? ", ..." : "");
    }
    if (lines.failed)
        return text_free(&lines), status_memory(status);
    scene->passed_over = lines.data;
    return STATUS_OK;
}

/* What the file at `path` is that is no scan; NULL: it may be one. Only its beginning is read where that tells. */
static const char *kind_of_other(const char *path, struct status *status)
{
    enum { BEGINNING = 65536 };
    char *bytes = malloc(BEGINNING + 1);
    int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC); /* some files of a kernel wait for news */
    FILE *file = descriptor < 0 ? NULL : fdopen(descriptor, "rb");
    const char *kind = NULL;
    struct text all = {0};
    if (!bytes)
        status_memory(status);
    if (bytes && file) {
        size_t length = fread(bytes, 1, BEGINNING, file);
        bytes[length] = '\0';
        struct scan_bytes content = {bytes, length, path};
        bool whole = length < BEGINNING;
        if (!whole && scan_tells_at_end(&content) && text_read_file(&all, path, &(struct status){0}) == STATUS_OK) {
            content = (struct scan_bytes){text_string(&all), all.length, path};
            whole = true;
        }
        kind = scan_is_other(&content, whole);
    }
    if (file)
        fclose(file);
    text_free(&all);
    free(bytes);
    return kind;
}

/* The file's kind, if it is no scan; NULL: it may be one. */
static const char *kind_of_file(const struct scene *scene, const char *file, struct status *status)
{
    char *path = scene_file_path(scene, file);
    const char *kind = path ? kind_of_other(path, status) : NULL;
    if (!path)
        status_memory(status);
    free(path);
    return kind;
}

/* Takes out the files that are no scans: pictures, documents, programs, texts; and surfaces that then have none. */
static enum status_code drop_others(struct scene *scene, struct status *status)
{
    size_t kept = 0, count = 0, files = 0;
    for (size_t i = 0; i < scene->surface_count; i++)
        files += scene->surfaces[i].file_count;
    struct other *others = calloc(files + 1, sizeof *others);
    if (!others)
        return status_memory(status);
    for (size_t i = 0; i < scene->surface_count; i++) {
        struct scene_surface surface = scene->surfaces[i];
        size_t left = 0;
        for (size_t f = 0; f < surface.file_count; f++) {
            const char *kind = kind_of_file(scene, surface.files[f], status);
            if (kind)
                others[count++] = (struct other){kind, surface.files[f]};
            else
                surface.files[left++] = surface.files[f];
        }
        surface.file_count = left;
        if (left == 0)
            scene_surfaces_free(&surface, NULL);
        else
            scene->surfaces[kept++] = surface;
    }
    scene->surface_count = kept;
    if (status->code == STATUS_OK && count > 0)
        (void)tell_others(scene, others, count, status);
    for (size_t i = 0; i < count; i++)
        free(others[i].file);
    free(others);
    return status->code;
}

/* A sub-directory is a surface, its files the repeated scans. */
static enum status_code add_directory(struct scene *scene, int directory, const char *name, struct status *status)
{
    struct scene_surface *surface = &scene->surfaces[scene->surface_count++];
    char *pattern;
    *surface = (struct scene_surface){.name = strdup(name)};
    if (!surface->name || asprintf(&pattern, "%s/*", name) < 0)
        return status_memory(status);
    enum status_code code = scene_files_match(surface, scene, pattern, status);
    size_t kept = 0;
    for (size_t i = 0; i < surface->file_count; i++) {
        struct stat info;
        if (fstatat(directory, surface->files[i], &info, 0) == 0 && is_taken(scene, directory, &info))
            free(surface->files[i]);
        else
            surface->files[kept++] = surface->files[i];
    }
    surface->file_count = kept;
    free(pattern);
    if (kept == 0 && code == STATUS_OK) {
        scene_surfaces_free(surface, NULL);
        scene->surface_count--;
    }
    return code;
}

/* Those behind the files, so that these alone may be sidecars. */
static enum status_code add_directories(struct scene *scene, int directory, struct dirent *const *entries, int count,
                                        struct status *status)
{
    enum status_code code = STATUS_OK;
    for (int i = 0; i < count && code == STATUS_OK; i++) {
        const char *name = entries[i]->d_name;
        struct stat info;
        if (name[0] != '.' && fstatat(directory, name, &info, 0) == 0 && S_ISDIR(info.st_mode) &&
            scene_files_holds_scans(directory, name))
            code = add_directory(scene, directory, name, status);
    }
    return code;
}

enum status_code scene_listing_read(struct scene *scene, struct status *status)
{
    struct dirent **entries = NULL;
    int directory = open(scene->directory, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    int count = directory < 0 ? -1 : scandirat(directory, ".", &entries, NULL, NULL);
    enum status_code code = STATUS_OK;
    if (count < 0)
        code = status_fail(status, STATUS_IO, "cannot list '%s': %s", scene->directory, strerror(errno));
    else if ((size_t)count > limit_most(LIMIT_FILES))
        code = status_fail(status, STATUS_SCENE, "%d files in '%s'%s", count, scene->directory,
                           limit_words(LIMIT_FILES).text);
    else if (!(scene->surfaces = calloc((size_t)count + 1, sizeof *scene->surfaces)))
        code = status_memory(status);
    for (int i = 0; i < count && code == STATUS_OK; i++)
        if (is_candidate(scene, directory, entries[i]->d_name))
            code = add_surface(scene, entries[i]->d_name, status);
    if (code == STATUS_OK) {
        drop_sidecars(scene);
        code = add_directories(scene, directory, entries, count, status);
    }
    for (int i = 0; i < count; i++)
        free(entries[i]);
    free(entries);
    if (directory >= 0)
        close(directory);
    if (code == STATUS_OK)
        code = drop_others(scene, status);
    return code == STATUS_OK ? tell_apart(scene, status) : code;
}
