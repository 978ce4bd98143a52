/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scene directories made for one test, and reading them. */
#ifndef TEST_SCENE_DIRECTORY_H
#define TEST_SCENE_DIRECTORY_H

#include "base/text.h"
#include "scene/scene.h"
#include "support.h"

#include <ftw.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

struct scene_directory {
    char path[256];
};

static inline struct scene_directory scene_directory_make(void)
{
    struct scene_directory directory;
    const char *temporary = getenv("TMPDIR");
    snprintf(directory.path, sizeof directory.path, "%s/roughcontact-scene-XXXXXX", temporary ? temporary : P_tmpdir);
    assert_non_null(mkdtemp(directory.path));
    return directory;
}

static inline void scene_directory_write(const struct scene_directory *directory, const char *file, const char *bytes,
                                         size_t length)
{
    char path[512];
    struct status status = {0};
    snprintf(path, sizeof path, "%s/%s", directory->path, file);
    assert_int_equal(text_write_file(path, bytes, length, &status), STATUS_OK);
}

/* A file with something in it. */
static inline void scene_directory_add(const struct scene_directory *directory, const char *file)
{
    scene_directory_write(directory, file, "0 1\n", 4);
}

static inline void scene_directory_says(const struct scene_directory *directory, const char *scene)
{
    scene_directory_write(directory, "scene.yaml", scene, strlen(scene));
}

static inline int scene_directory_unlink(const char *path, const struct stat *info, int kind, struct FTW *walk)
{
    (void)info, (void)kind, (void)walk;
    return remove(path);
}

static inline void scene_directory_remove(const struct scene_directory *directory)
{
    assert_int_equal(nftw(directory->path, scene_directory_unlink, 8, FTW_DEPTH | FTW_PHYS), 0);
}

/* Reads a scene that has to be valid. */
static inline struct scene scene_directory_read(const char *path, const struct scene_overrides *overrides)
{
    struct scene scene;
    struct status status = {0};
    if (scene_read(&scene, path, overrides, &status) != STATUS_OK)
        fail_msg("%s", status.message);
    return scene;
}

/* The scene that the text is in a directory of two scans, which has gone. */
static inline struct scene scene_of(const char *text)
{
    struct scene_directory directory = scene_directory_make();
    scene_directory_add(&directory, "a.csv");
    scene_directory_add(&directory, "b.csv");
    scene_directory_says(&directory, text);
    struct scene scene = scene_directory_read(directory.path, NULL);
    scene_directory_remove(&directory);
    return scene;
}

/* Its loads on bodies of that E', malloc'ed, which rise. */
static inline double *scene_loads_of(const struct scene *scene, double modulus_Pa, size_t *count)
{
    const struct material_pair pair = {.effective_modulus_Pa = modulus_Pa};
    struct status status = {0};
    size_t operating;
    double *loads;
    assert_int_equal(scene_loads(&loads, count, &operating, scene, &pair, &status), STATUS_OK);
    assert_true(*count > 0 && loads[0] > 0 && isfinite(loads[*count - 1]));
    for (size_t i = 1; i < *count; i++)
        assert_true(loads[i] > loads[i - 1]);
    return loads;
}

#endif
