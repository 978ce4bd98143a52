/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/limits.h"
#include "scan/text_header.h"
#include "scene/scene_source.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <fnmatch.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

static const char repeat_marks[] = "-_ ("; /* between the name of a surface and the number of its scan */

char *scene_file_path(const struct scene *scene, const char *file)
{
    const char *directory = file[0] == '/' ? "" : scene->directory;
    size_t length = strlen(directory);
    char *path;
    bool joined = length == 0 || directory[length - 1] == '/';
    return asprintf(&path, "%s%s%s", directory, joined ? "" : "/", file) < 0 ? NULL : path;
}

enum status_code scene_files_add(struct scene_files *files, const char *file, struct status *status)
{
    if ((files->count & (files->count - 1)) == 0) { /* full at 0, 1, 2, 4, 8 */
        char **path = reallocarray(files->path, 2 * files->count + 1, sizeof *path);
        if (!path)
            return status_memory(status);
        files->path = path;
    }
    if (!(files->path[files->count] = strdup(file)))
        return status_memory(status);
    files->count++;
    return STATUS_OK;
}

/* Does `file` only give the units of scans? */
static bool is_sidecar(const struct scene *scene, const char *file)
{
    size_t stem;
    struct sidecar sidecar;
    OWNED(memory_free) char *path = sidecar_ending(file, &stem) ? scene_file_path(scene, file) : NULL;
    return path && sidecar_read(&sidecar, path);
}

enum status_code scene_files_match(struct scene_files *files, const struct scene *scene, const char *pattern,
                                   mode_t kind, struct status *status)
{
    const char *slash = strrchr(pattern, '/'), *name = slash ? slash + 1 : pattern;
    OWNED(memory_free) char *folder = strndup(pattern, (size_t)(name - pattern));
    OWNED(memory_free) char *path = folder && *folder ? scene_file_path(scene, folder) : strdup(scene->directory);
    struct dirent **entries = NULL;
    enum status_code code = folder && path ? STATUS_OK : status_memory(status);
    int count = path ? scandir(path, &entries, NULL, versionsort) : 0;
    if (count < 0)
        code = status_fail(status, STATUS_IO, "cannot list '%s': %s", scene_words_show(path).text, strerror(errno));
    if (count > 0 && (size_t)count > limit_most(LIMIT_FILES))
        code = status_fail(status, STATUS_SCENE, "%d files in '%s'%s", count, scene_words_show(path).text,
                           limit_words(LIMIT_FILES).text);
    for (int i = 0; i < count; i++) {
        OWNED(memory_free) char *file = NULL, *at = NULL;
        struct stat info;
        if (code == STATUS_OK && fnmatch(name, entries[i]->d_name, FNM_PERIOD) == 0) {
            if (asprintf(&file, "%s%s", folder, entries[i]->d_name) < 0 || !(at = scene_file_path(scene, file)))
                code = status_memory(status);
            else if (stat(at, &info) == 0 && (info.st_mode & S_IFMT) == kind &&
                     (kind == S_IFDIR || !is_sidecar(scene, file)))
                code = scene_files_add(files, file, status);
        }
        free(entries[i]);
    }
    free(entries);
    return code;
}

char *scene_files_name(const char *file, bool ending)
{
    const char *start = basename(file), *dot = strrchr(start, '.');
    return !ending && dot && dot > start ? strndup(start, (size_t)(dot - start)) : strdup(start);
}

void scene_files_free(struct scene_files *files)
{
    for (size_t i = 0; i < files->count; i++)
        free(files->path[i]);
    free(files->path);
}

void scene_surfaces_free(struct scene_surface *surface)
{
    scene_files_free(&surface->files);
    scene_files_free(&surface->along);
    scene_files_free(&surface->measured.files);
    free(surface->name);
}

static int compare_surfaces(const void *a, const void *b)
{
    const struct scene_surface *first = a, *second = b;
    int order = strverscmp(first->name, second->name);
    return order ? order : strcmp(first->files.path[0], second->files.path[0]);
}

/* Gives surfaces of one name the ending of their file, until all names differ. */
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
                if (strchr(all[j].files.path[0], '/')) /* a directory has no ending */
                    continue;
                free(all[j].name);
                if (!(all[j].name = scene_files_name(all[j].files.path[0], true)))
                    return status_memory(status);
                again = true;
            }
        }
    }
    return STATUS_OK;
}

/* Are both paths the same file? */
static bool is_same(const struct scene *scene, const char *a, const char *b)
{
    OWNED(memory_free) char *first = scene_file_path(scene, a), *second = scene_file_path(scene, b);
    struct stat info[2];
    return first && second && stat(first, &info[0]) == 0 && stat(second, &info[1]) == 0 &&
           info[0].st_dev == info[1].st_dev && info[0].st_ino == info[1].st_ino;
}

/* Is the file the scene, a scan of the counterface, a measurement or the parts' shape? */
static bool is_taken(const struct scene *scene, const char *file)
{
    const struct scene_files *const all[] = {&scene->counterface_surface.files, &scene->measured.files,
                                             &scene->shape.files};
    for (size_t k = 0; k < SCENE_COUNT(all); k++)
        for (size_t i = 0; i < all[k]->count; i++)
            if (is_same(scene, all[k]->path[i], file))
                return true;
    return strcmp(file, "scene.yaml") == 0;
}

/* 2 before 10. */
static int compare_naturally(const void *a, const void *b)
{
    return strverscmp(*(char *const *)a, *(char *const *)b);
}

/* "passed over: 2 x PNG picture (a.png, b.png)", a line a kind. Each of `others` is its kind, a line end, its name. */
static enum status_code tell_others(struct scene *scene, struct scene_files *others, struct status *status)
{
    enum { NAMED = 8 };
    struct text lines = {0};
    char **files = others->path;
    size_t count = others->count;
    if (count > 0)
        qsort(files, count, sizeof *files, compare_naturally);
    for (size_t i = 0, end; i < count; i = end) {
        size_t kind = strcspn(files[i], "\n") + 1;
        for (end = i + 1; end < count && strncmp(files[end], files[i], kind) == 0;)
            end++;
        text_add(&lines, "%spassed over, no scan%s: %zu x %.*s (", i > 0 ? "\n" : "", end - i == 1 ? "" : "s", end - i,
                 (int)kind - 1, files[i]);
        for (size_t k = i; k < end && k < i + NAMED; k++) {
            text_add(&lines, "%s", k > i ? ", " : "");
            text_add_shown(&lines, files[k] + kind);
        }
        text_add(&lines, "%s)", end - i > NAMED ? ", ..." : "");
    }
    scene->passed_over = lines.data;
    return lines.failed ? status_memory(status) : STATUS_OK;
}

/* What a file is that is no scan; NULL: it may be one. If possible only its beginning is read. */
static const char *kind_of_other(const struct scene *scene, const char *name)
{
    char bytes[32768], *path = scene_file_path(scene, name);
    int descriptor = path ? open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC) : -1; /* a file of the kernel's may block */
    FILE *file = descriptor < 0 ? NULL : fdopen(descriptor, "rb");
    size_t length = file ? fread(bytes, 1, sizeof bytes, file) : 0;
    bool whole = length < sizeof bytes;
    OWNED(text_free) struct text all = {0};
    text_add_bytes(&all, bytes, length);
    if (!whole && scan_tells_at_end(text_string(&all), all.length))
        whole = text_read_stream(&all, file, path, &(struct status){0}) == STATUS_OK;
    const struct scan_bytes content = {text_string(&all), all.length, path};
    const char *kind = file ? scan_is_other(&content, whole) : NULL;
    if (file)
        fclose(file);
    free(path);
    return kind;
}

/* Adds a surface of one file, or of the files of a folder as repeated scans. Files of is_taken() are left out, and
 * those that are no scans go to `others`; a surface without files is not added. */
static enum status_code add_surface(struct scene *scene, struct scene_files *others, const char *name, bool folder,
                                    struct status *status)
{
    struct scene_surface *surface = &scene->surfaces[scene->surface_count++];
    *surface = (struct scene_surface){.name = folder ? strdup(name) : scene_files_name(name, false)};
    OWNED(memory_free) char *pattern = NULL;
    size_t kept = 0;
    if (!surface->name || (folder && asprintf(&pattern, "%s/*", name) < 0))
        return status_memory(status);
    enum status_code code = folder ? scene_files_match(&surface->files, scene, pattern, S_IFREG, status)
                                   : scene_files_add(&surface->files, name, status);
    for (size_t i = 0; i < surface->files.count; i++) {
        char *file = surface->files.path[i];
        OWNED(memory_free) char *noted = NULL;
        bool taken = is_taken(scene, file);
        const char *kind = taken ? NULL : kind_of_other(scene, file);
        if (!taken && !kind) {
            surface->files.path[kept++] = file;
            continue;
        }
        if (kind && code == STATUS_OK)
            code = asprintf(&noted, "%s\n%s", kind, file) < 0 ? status_memory(status)
                                                              : scene_files_add(others, noted, status);
        free(file);
    }
    surface->files.count = kept;
    if (kept == 0) {
        scene_surfaces_free(surface);
        scene->surface_count--;
    }
    return code;
}

/* Can the folder be listed, and is it no report of this program? */
static bool may_hold_scans(const struct scene *scene, const char *folder)
{
    OWNED(memory_free) char *path = scene_file_path(scene, folder), *results = NULL;
    return path && asprintf(&results, "%s/results.json", path) >= 0 && access(path, R_OK | X_OK) == 0 &&
           access(results, F_OK) != 0;
}

void scene_files_list(struct scene *scene, struct scene_source *source)
{
    OWNED(scene_files_free) struct scene_files files = {0}, folders = {0}, others = {0};
    struct status *status = source->status;
    if (scene->surface_count > 0)
        return;
    if (scene_files_match(&files, scene, "*", S_IFREG, status) == STATUS_OK &&
        scene_files_match(&folders, scene, "*", S_IFDIR, status) == STATUS_OK) {
        scene->surfaces = calloc(files.count + folders.count + 1, sizeof *scene->surfaces);
        if (!scene->surfaces)
            (void)status_memory(status);
    }
    for (size_t i = 0; i < files.count && status->code == STATUS_OK; i++)
        (void)add_surface(scene, &others, files.path[i], false, status);
    for (size_t i = 0; i < folders.count && status->code == STATUS_OK; i++)
        if (may_hold_scans(scene, folders.path[i]))
            (void)add_surface(scene, &others, folders.path[i], true, status);
    if (status->code == STATUS_OK && tell_others(scene, &others, status) == STATUS_OK)
        (void)tell_apart(scene, status);
}

static const char *ending_of(const char *file)
{
    const char *dot = strrchr(file, '.');
    return dot && dot > file ? dot : "";
}

/* How many bytes of a file's name name its surface: without ending and without the number (a-1, a 2, a (3), a4) or
 * letter behind a mark (a-b; but x, y and z are directions) of a repeated scan. 0.5 is a value, and behind some words
 * the number counts surfaces. */
static size_t root_length(const char *file)
{
    static const char *const counted[] = {"surface", "sample", "specimen", "part"};
    size_t whole = strlen(file) - strlen(ending_of(file)), end = whole - (file[whole - 1] == ')'), root = end;
    while (root > 0 && isdigit((unsigned char)file[root - 1]))
        root--;
    if (root == end && end > 1 && isalpha((unsigned char)file[end - 1]) && !strchr("xyzXYZ", file[end - 1]) &&
        strchr(repeat_marks, file[end - 2]))
        root--;
    bool repeated = root < end;
    while (root > 0 && strchr(repeat_marks, file[root - 1]))
        root--;
    for (size_t i = 0; i < SCENE_COUNT(counted); i++) {
        size_t length = strlen(counted[i]);
        repeated = repeated && (root < length || strncasecmp(file + root - length, counted[i], length) != 0);
    }
    return repeated && root > 0 && file[root - 1] != '.' ? root : whole;
}

/* 0: they differ only in the number. The "ending" of a file in a folder with a dot holds a slash. */
static int compare_roots(const char *a, const char *b)
{
    size_t first = root_length(a), second = root_length(b);
    int order = first != second ? (first > second) - (first < second) : strncmp(a, b, first);
    return order ? order : strcmp(ending_of(a), ending_of(b));
}

static int compare_repeats(const void *a, const void *b)
{
    const char *first = ((const struct scene_surface *)a)->files.path[0];
    const char *second = ((const struct scene_surface *)b)->files.path[0];
    int order = compare_roots(first, second);
    return order ? order : strverscmp(first, second);
}

/* Ends of names, behind a mark, of a surface's scans across and along. */
static const char *const directions[][2] = {{"x", "y"}, {"0", "90"}, {"across", "along"}, {"q", "l"}, {"perp", "par"}};

/* Index of the word (x 0, y 1, 0 2, 90 3, ...) that a surface's name ends in, perhaps before the number of a scan, and
 * the bytes before it; -1: none. */
static int direction_of(size_t *before, const struct scene_surface *surface)
{
    const size_t ends[] = {strlen(surface->name), root_length(surface->files.path[0])};
    for (int i = 0; i < 2 * (int)(2 * SCENE_COUNT(directions)); i++) {
        const char *word = directions[i / 4][i / 2 % 2];
        const size_t length = strlen(word), end = ends[i % 2];
        const char *at = surface->name + end - length;
        *before = end - length - 1;
        if (end <= ends[0] && end > length + 1 && strncasecmp(at, word, length) == 0 && strchr(repeat_marks, at[-1]))
            return i / 2;
    }
    return -1;
}

/* How many bytes two names have in common that mean two directions of a surface, the second along; 0: they do not. */
static size_t two_directions(const struct scene_surface *one, const struct scene_surface *other)
{
    size_t length, along;
    const int across = direction_of(&length, one);
    const bool are = across >= 0 && across % 2 == 0 && direction_of(&along, other) == across + 1 && length == along;
    return are && strncmp(one->name, other->name, length) == 0 ? length : 0;
}

static void join_directions(struct scene *scene)
{
    struct scene_surface *all = scene->surfaces;
    for (size_t i = 0; i < scene->surface_count; i++)
        for (size_t j = 0; j < scene->surface_count; j++) {
            const size_t length = two_directions(&all[i], &all[j]);
            if (length == 0)
                continue;
            all[i].name[length] = '\0';
            all[i].along = all[j].files;
            all[j].files = (struct scene_files){0};
            scene_surfaces_free(&all[j]);
            memmove(all + j, all + j + 1, (--scene->surface_count - j) * sizeof *all);
            i -= j < i;
            break;
        }
}

enum status_code scene_join_repeats(struct scene *scene, struct status *status)
{
    struct scene_surface *all = scene->surfaces;
    size_t joined = 0;
    qsort(all, scene->surface_count, sizeof *all, compare_repeats);
    for (size_t i = 0, end; i < scene->surface_count; i = end) {
        struct scene_surface *surface = &all[joined++];
        *surface = all[i];
        const char *file = surface->files.path[0];
        for (end = i + 1; end < scene->surface_count && compare_roots(file, all[end].files.path[0]) == 0;)
            end++;
        if (end == i + 2 && (two_directions(&all[i], &all[i + 1]) || two_directions(&all[i + 1], &all[i])))
            end--;
        for (size_t k = i + 1; k < end; k++) {
            (void)!scene_files_add(&surface->files, all[k].files.path[0], status); /* the status tells */
            scene_surfaces_free(&all[k]);
        }
        if (end == i + 1)
            continue;
        free(surface->name);
        if (!(surface->name = strndup(file, root_length(file))))
            (void)status_memory(status);
    }
    scene->surface_count = joined;
    if (status->code == STATUS_OK)
        join_directions(scene);
    return status->code == STATUS_OK ? tell_apart(scene, status) : status->code;
}
