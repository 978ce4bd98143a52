#include "scene/scene_listing.h"
#include "scan/sidecar.h"
#include "scene/scene_surfaces.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
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

/* Natural order: runs of digits by value, the rest by bytes; 2 before 10. */
static int compare_natural(const char *a, const char *b)
{
    const char *first = a, *second = b;
    while (*first && *second) {
        int order;
        if (is_digit(*first) && is_digit(*second))
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
    int order = compare_natural(first->name, second->name);
    return order ? order : strcmp(first->files[0], second->files[0]);
}

static enum status_code add_surface(struct scene *scene, size_t *capacity, const char *file, struct status *status)
{
    if (scene->surface_count == *capacity) {
        size_t larger = *capacity ? 2 * *capacity : 64;
        struct scene_surface *surfaces = realloc(scene->surfaces, larger * sizeof *surfaces);
        if (!surfaces)
            return status_memory(status);
        scene->surfaces = surfaces;
        *capacity = larger;
    }
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
    for (bool again = true; again;) {
        again = false;
        qsort(scene->surfaces, scene->surface_count, sizeof *scene->surfaces, compare_surfaces);
        for (size_t i = 0; i < scene->surface_count;) {
            size_t end = i + 1;
            while (end < scene->surface_count && strcmp(scene->surfaces[i].name, scene->surfaces[end].name) == 0)
                end++;
            for (size_t j = i; end > i + 1 && j < end; j++) {
                free(scene->surfaces[j].name);
                scene->surfaces[j].name = scene_surfaces_name(scene->surfaces[j].files[0], true);
                if (!scene->surfaces[j].name)
                    return status_memory(status);
                again = true;
            }
            i = end;
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

static const char *last_component(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

static int compare_texts(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* Is `file` the name of a sidecar of one of `names`, which are in order, or of a counterface's scan? */
static bool has_scan(const struct scene *scene, const char *const *names, size_t count, const char *file)
{
    size_t stem, low = 0, high = count;
    if (!sidecar_ending(file, &stem))
        return false;
    while (low < high) { /* the first that begins with the stem */
        size_t middle = low + (high - low) / 2;
        if (strncmp(names[middle], file, stem) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    for (; low < count && strncmp(names[low], file, stem) == 0; low++)
        if (sidecar_fits(file, names[low]))
            return true;
    for (size_t i = 0; i < scene->counterface_surface.file_count; i++)
        if (sidecar_fits(file, last_component(scene->counterface_surface.files[i])))
            return true;
    return false;
}

/* Takes out the files that only say units of scans beside them. */
static enum status_code drop_sidecars(struct scene *scene, struct status *status)
{
    size_t count = scene->surface_count, scans = 0, kept = 0, stem;
    const char **names = malloc(count * sizeof *names);
    bool *beside = calloc(count, sizeof *beside);
    enum status_code code = names && beside ? STATUS_OK : status_memory(status);
    for (size_t i = 0; i < count && code == STATUS_OK; i++) {
        const char *file = scene->surfaces[i].files[0];
        struct sidecar sidecar;
        char *path = sidecar_ending(file, &stem) ? scene_surfaces_path(scene->directory, file) : NULL;
        beside[i] = path && sidecar_read(&sidecar, path);
        free(path);
        if (!beside[i])
            names[scans++] = file;
    }
    if (code == STATUS_OK)
        qsort(names, scans, sizeof *names, compare_texts);
    for (size_t i = 0; i < count && code == STATUS_OK; i++)
        beside[i] = beside[i] && has_scan(scene, names, scans, scene->surfaces[i].files[0]);
    for (size_t i = 0; i < count && code == STATUS_OK; i++) {
        if (beside[i])
            scene_surfaces_free(&scene->surfaces[i]);
        else
            scene->surfaces[kept++] = scene->surfaces[i];
    }
    scene->surface_count = code == STATUS_OK ? kept : count;
    free(names);
    free(beside);
    return code;
}

enum status_code scene_listing_read(struct scene *scene, struct status *status)
{
    DIR *directory = opendir(scene->directory);
    if (!directory)
        return status_fail(status, STATUS_IO, "cannot list '%s': %s", scene->directory, strerror(errno));
    enum status_code code = STATUS_OK;
    size_t capacity = 0;
    while (code == STATUS_OK) {
        errno = 0;
        const struct dirent *entry = readdir(directory);
        if (!entry) {
            if (errno != 0)
                code = status_fail(status, STATUS_IO, "cannot list '%s': %s", scene->directory, strerror(errno));
            break;
        }
        if (is_candidate(scene, dirfd(directory), entry->d_name))
            code = add_surface(scene, &capacity, entry->d_name, status);
    }
    closedir(directory);
    if (code != STATUS_OK || scene->surface_count == 0)
        return code;
    code = drop_sidecars(scene, status);
    return code == STATUS_OK ? tell_apart(scene, status) : code;
}
