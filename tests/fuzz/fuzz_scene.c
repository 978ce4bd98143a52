/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz.h"

#include "scene/scene.h"
#include <math.h>

static void require_sound(const struct scene *scene)
{
    FUZZ_REQUIRE(scene->surface_count > 0 && scene->title && scene->directory);
    for (size_t i = 0; i < scene->surface_count; i++) {
        const struct scene_surface *surface = &scene->surfaces[i];
        struct material_pair pair = scene_pair(&surface->bodies);
        OWNED(memory_free) double *loads = malloc((scene->load.points + 1) * sizeof *loads);
        size_t operating;
        FUZZ_REQUIRE(surface->name && surface->files.count > 0);
        for (size_t other = 0; other < i; other++)
            FUZZ_REQUIRE(strcmp(surface->name, scene->surfaces[other].name) != 0);
        FUZZ_REQUIRE(pair.unknown || (pair.effective_modulus_Pa > 0 && isfinite(pair.effective_modulus_Pa)));
        const size_t count = scene_loads(loads, &operating, scene, &pair);
        FUZZ_REQUIRE(count > 0 && operating < count);
        for (size_t k = 0; k < count; k++)
            FUZZ_REQUIRE(isfinite(loads[k]) && loads[k] > (k > 0 ? loads[k - 1] : 0));
    }
}

void fuzz_scene(const uint8_t *bytes, size_t length)
{
    struct scene scene;
    struct status status = {0};
    OWNED(text_free) struct text text = {0};
    text_add_bytes(&text, (const char *)bytes, length);
    enum status_code code =
        scene_read(&scene, TEST_DATA "/scene/full", &(struct scene_overrides){.text = &text}, &status);
    if (code == STATUS_OK)
        require_sound(&scene);
    else
        FUZZ_REQUIRE(code == STATUS_SCENE && *status.message && !strchr(status.message, '\n'));
    fuzz_count("scene", code == STATUS_OK);
    scene_free(&scene);
}
