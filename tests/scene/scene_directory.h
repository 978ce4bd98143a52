/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scene directories made for one test, and reading them. */
#ifndef TEST_SCENE_DIRECTORY_H
#define TEST_SCENE_DIRECTORY_H

#include "directory.h"
#include "scene/scene.h"

/* A file with something in it. */
static inline void scene_directory_add(const struct directory *directory, const char *file)
{
    directory_write(directory, file, "0 1\n");
}

static inline void scene_directory_end(void *scene)
{
    scene_free(scene);
    free(scene);
}

/* Reads a scene that has to be valid; the test's. */
static inline struct scene *scene_directory_read(const char *path, const struct scene_overrides *overrides)
{
    struct scene *scene = test_owns(calloc(1, sizeof *scene), scene_directory_end);
    expect_ok(scene_read, scene, path, overrides);
    return scene;
}

/* Expects that it is refused with a message that holds `words`. */
static inline void scene_directory_refused(const char *path, const struct scene_overrides *overrides,
                                           enum status_code code, const char *words)
{
    struct scene scene;
    expect_fails(code, words, scene_read, &scene, path, overrides);
    scene_free(&scene);
}

/* The scene that the text is in a directory of two scans, which has gone; the test's. */
static inline struct scene *scene_of(const char *text)
{
    struct directory directory = directory_make();
    scene_directory_add(&directory, "a.csv");
    scene_directory_add(&directory, "b.csv");
    directory_write(&directory, "scene.yaml", text);
    struct scene *scene = scene_directory_read(directory.path, NULL);
    directory_remove(&directory);
    return scene;
}

/* Its loads on bodies of that E', which rise; the test's. */
static inline double *scene_loads_of(const struct scene *scene, double modulus_Pa, size_t *count)
{
    const struct material_pair pair = {.effective_modulus_Pa = modulus_Pa};
    size_t operating;
    double *loads = support_room((scene->load.points + 1) * sizeof *loads);
    *count = scene_loads(loads, &operating, scene, &pair);
    assert_true(*count > 0 && loads[0] > 0 && isfinite(loads[*count - 1]));
    for (size_t i = 1; i < *count; i++)
        assert_true(loads[i] > loads[i - 1]);
    return loads;
}

#endif
