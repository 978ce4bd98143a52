/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bodies of a surface, and what they lack. */
#include "scene/scene.h"

#include <gsl/gsl_sort_double.h>
#include <math.h>
#include <string.h>

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

/* `points` loads in equal steps of their logarithm; by powers of ten, so that whole decades come out exactly. */
static void fill_decades(double *loads, const struct scene_load *load)
{
    double first = log10(load->from), last = log10(load->to);
    for (size_t i = 1; i + 1 < load->points; i++) {
        double step = (last - first) * (double)i / (double)(load->points - 1);
        loads[i] = fmin(fmax(pow(10.0, first + step), load->from), load->to);
    }
    loads[load->points - 1] = load->to;
    loads[0] = load->from;
}

double scene_load_divisor(const struct scene *scene, enum unit_quantity kind, const struct material_pair *pair)
{
    double modulus_Pa = pair->unknown ? NAN : pair->effective_modulus_Pa;
    return kind == UNIT_NUMBER ? 1 : kind == UNIT_PRESSURE ? modulus_Pa : modulus_Pa * scene->nominal_area_m2;
}

const struct material *scene_softer(const struct scene_bodies *bodies)
{
    const bool other = bodies->counterface_kind == MATERIAL_COUNTERFACE_ELASTIC &&
                       bodies->counterface.yield_strength_Pa < bodies->material.yield_strength_Pa;
    return other ? &bodies->counterface : &bodies->material;
}

double scene_load_as(const struct scene_quantity *one, const struct scene *scene, const struct material_pair *pair)
{
    if (one->value == 0 || one->kind == scene->load.kind)
        return one->value;
    return one->value / scene_load_divisor(scene, one->kind, pair) * scene_load_divisor(scene, scene->load.kind, pair);
}

double scene_load_of(const struct scene_quantity *one, const struct scene *scene, const struct material_pair *pair)
{
    return scene_load_as(one, scene, pair) / scene_load_divisor(scene, scene->load.kind, pair);
}

size_t scene_loads(double *all, size_t *operating, const struct scene *scene, const struct material_pair *pair)
{
    const struct scene_load *load = &scene->load;
    double divisor = scene_load_divisor(scene, load->kind, pair),
           operates = scene_load_as(&scene->operating, scene, pair);
    size_t points = load->points, count = 0;
    if (load->values)
        memcpy(all, load->values, points * sizeof *all);
    else
        fill_decades(all, load);
    if (operates > 0)
        all[points++] = operates;
    gsl_sort(all, 1, points);
    for (size_t i = 0; i < points; i++)
        if (i == 0 || all[i] != all[count - 1])
            all[count++] = all[i];
    *operating = count / 2;
    for (size_t i = 0; i < count; i++)
        if (operates > 0 && all[i] == operates)
            *operating = i;
    for (size_t i = 0; i < count && load->kind != UNIT_NUMBER; i++) {
        all[i] /= divisor;
        if (i > 0 && !(all[i] > all[i - 1])) /* neighbours that rounding made one: as many on every surface */
            all[i] = nextafter(all[i - 1], INFINITY);
    }
    return count;
}
