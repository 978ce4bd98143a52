/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bodies of a surface, and what they lack. */
#include "scene/scene.h"

#include <math.h>

struct material_pair scene_pair(const struct scene_bodies *bodies)
{
    if (!(bodies->material.youngs_modulus_Pa > 0))
        return material_pair_unknown();
    struct material_pair pair = material_pair(&bodies->material, bodies->counterface_kind, &bodies->counterface);
    if (bodies->hardness_Pa > 0)
        pair.hardness_Pa = bodies->hardness_Pa;
    if (bodies->hardness_exponent < 0) {
        pair.vickers_Pa = bodies->hardness_Pa;
        pair.vickers_exponent = bodies->hardness_exponent;
    }
    return pair;
}

const struct scene_bodies *scene_bodies_of(const struct scene *scene, size_t i)
{
    return i < scene->surface_count ? &scene->surfaces[i].bodies : &scene->bodies;
}

const struct material_property *scene_lack(const char **body, const struct scene_bodies *bodies,
                                           const struct effect_row *effect)
{
    for (const char *const *key = effect->properties; *key; key++) {
        const struct material_property *property = material_property_find(*key);
        *body = isnan(material_value(&bodies->material, property)) ? "material" : "counterface";
        if (isnan(material_value(&bodies->material, property)) ||
            (bodies->counterface_kind == MATERIAL_COUNTERFACE_ELASTIC &&
             isnan(material_value(&bodies->counterface, property))))
            return property;
    }
    return NULL;
}
