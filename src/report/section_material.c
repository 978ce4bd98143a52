/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Material and load: table 6.1, E' and the loads as pressures. */
#include "report/section.h"

#include "joint/electron.h"
#include <math.h>
#include <string.h>

/** Is the property one that a model or an effect of this run needs? */
static bool is_needed(const struct plan *plan, const char *key)
{
    bool needed = strcmp(key, "E_Pa") == 0 || strcmp(key, "nu") == 0;
    for (int e = 0; e < EFFECT_COUNT; e++)
        for (int k = 0; plan_runs(plan, (enum effect)e) && effect_rows[e].properties[k]; k++)
            needed = needed || strcmp(effect_rows[e].properties[k], key) == 0;
    return needed;
}

/** Is it the same metal: of the same name and numbers from the same source? */
static bool same_metal(const struct material *a, const struct material *b)
{
    bool same = strcmp(a->name, b->name) == 0 && strcmp(a->source, b->source) == 0;
    for (size_t i = 0; i < material_property_count && same; i++) {
        double x = material_value(a, &material_properties[i]), y = material_value(b, &material_properties[i]);
        same = x == y || (isnan(x) && isnan(y));
    }
    return same;
}

/** A metal of the table, and where it stands. */
struct metal {
    const struct material *material;
    bool counterface;
};

enum { METALS = 12 /* more are not shown */ };

/** The different metals of all usable surfaces: first what surfaces are made of, then counterfaces. */
static size_t find_metals(struct metal metals[METALS], const struct results *results)
{
    size_t count = 0;
    for (int side = 0; side < 2; side++)
        for (size_t k = 0; k < results->surface_count && count < METALS; k++) {
            const struct surface_summary *surface = &results->surfaces[k].summary;
            const struct scene_bodies *bodies = surface->scene->bodies;
            if (!surface->usable || (side == 1 && bodies->counterface_kind != MATERIAL_COUNTERFACE_ELASTIC))
                continue;
            const struct material *metal = side == 1 ? &bodies->counterface : &bodies->material;
            bool known = false;
            for (size_t i = 0; i < count; i++)
                known = known || same_metal(metals[i].material, metal);
            if (!known)
                metals[count++] = (struct metal){metal, side == 1};
        }
    return count;
}

/** A metal's name, with its side where another has the same. */
static void metal_name(struct text *out, const struct metal *metals, size_t count, size_t i)
{
    bool shared = false;
    for (size_t j = 0; j < count; j++)
        shared = shared || (j != i && strcmp(metals[j].material->name, metals[i].material->name) == 0);
    text_add_markdown(out, metals[i].material->name);
    text_add(out, "%s", !shared ? "" : metals[i].counterface ? " (counterface)" : " (surface)");
}

static void table_6_1(struct text *out, const struct section_context *context, const struct metal *metals, size_t count)
{
    const struct scene_bodies *bodies = context->baseline->summary.scene->bodies;
    bool both = bodies->counterface_kind == MATERIAL_COUNTERFACE_ELASTIC && count == 1;
    text_add(out, "| property | symbol");
    for (size_t i = 0; i < count; i++) {
        text_add(out, " | ");
        metal_name(out, metals, count, i);
    }
    text_add(out, "%s | unit |\n|---|---|", both ? ", both bodies" : "");
    for (size_t i = 0; i < count; i++)
        text_add(out, "---:|");
    text_add(out, "---|\n");
    for (size_t p = 0; p < material_property_count; p++) {
        const struct material_property *property = &material_properties[p];
        bool given = false;
        for (size_t i = 0; i < count; i++)
            given = given || material_value(metals[i].material, property) > 0;
        if (property->optional ? !given : !is_needed(context->results->plan, property->key))
            continue;
        text_add(out, "| %s | %s", property->meaning, property->symbol);
        for (size_t i = 0; i < count; i++) {
            text_add(out, " | ");
            number_format_given(out, material_value(metals[i].material, property));
        }
        text_add(out, " | %s |\n", property->unit);
    }
}

/** Have all usable surfaces one E'? */
static bool one_pair(const struct results *results)
{
    const struct material_pair *first = results_pair(results, results->baseline);
    for (size_t k = 0; k < results->usable_count; k++)
        if (memcmp(results_pair(results, results->by_roughness[k]), first, sizeof *first) != 0)
            return false;
    return true;
}

/** "E′ = 47.5 GPa, C = …" of one surface's bodies. */
static void pair_text(struct text *out, const struct results *results, const struct material_pair *pair)
{
    number_format_between(out, "E′ = ", pair->effective_modulus_Pa * 1e-9, 4, " GPa");
    if (plan_runs(results->plan, EFFECT_PLASTICITY))
        number_format_between(out, ", C = ", pair->yield_coefficient, 4, " (a spot yields at the mean pressure C·S_y)");
    if (plan_runs(results->plan, EFFECT_SCALE_DEPENDENT))
        number_format_between(out, ", mean free path of the heat carriers ", pair->mean_free_path_m[0] * 1e9, 3, " nm");
}

/** What the thesis's mean free path is, where the scale dependence of TCR hangs on it. */
static void mean_free_path_note(struct text *out, const struct results *results, const struct metal *metals,
                                size_t count)
{
    if (!plan_runs(results->plan, EFFECT_SCALE_DEPENDENT) ||
        results->scene->mean_free_path != SCENE_MEAN_FREE_PATH_THESIS)
        return;
    for (size_t i = 0; i < count; i++) {
        const struct material *metal = metals[i].material;
        const struct electron_metal *electrons = metal->electrons ? electron_metal_find(metal->electrons) : NULL;
        if (metal->mean_free_path_m > 0 || !electrons || !(metal->resistivity_ohm_m > 0))
            continue;
        text_add(out, " That mean free path is one of phonons (4.52); in a metal electrons carry the heat, in ");
        text_add_markdown(out, metal->name);
        number_format_between(
            out, " over ", electron_mean_free_path(electrons->density_per_m3, metal->resistivity_ohm_m) * 1e9, 2,
            " nm: with `mean_free_path: electron` the scale dependence of TCR is in that proportion.");
        return;
    }
}

static void material_text(struct text *out, const struct section_context *context, const struct metal *metals,
                          size_t count)
{
    const struct results *results = context->results;
    const struct material_pair *pair = section_pair(context);
    const double *loads = results_loads(results, results->baseline);
    double first = loads[0], last = loads[results->load_count - 1];
    bool several = results->load_count > 1;
    if (one_pair(results)) {
        pair_text(out, results, pair);
    } else {
        for (size_t k = 0; k < results->surface_count; k++) {
            if (!results->surfaces[k].summary.usable)
                continue;
            section_named(out, out->length > 0 && k > 0 ? "; surface " : "Surface ", results, k);
            text_add(out, ": ");
            pair_text(out, results, results_pair(results, k));
        }
    }
    text_add(out, ". %zu load%s, ", results->load_count, several ? "s" : "");
    if (!results->loads_apart) {
        text_add(out, "P/(Aₙ E′) = ");
        number_format_power(out, first, 3);
        if (several) {
            text_add(out, " to ");
            number_format_power(out, last, 3);
        }
        text_add(out, ", that is ");
    }
    if (results->scene->load.unit_text[0] && results->scene->load.kind == UNIT_FORCE) {
        section_load(out, results, results->baseline, first);
        if (several) {
            text_add(out, " to ");
            section_load(out, results, results->baseline, last);
        }
        text_add(out, " ");
        text_add_markdown(out, results->scene->load.unit_text);
        text_add(out, " or ");
    }
    number_format_between(out, "", material_pair_pressure(pair, first) * 1e-6, 3, "");
    if (several)
        number_format_between(out, " to ", material_pair_pressure(pair, last) * 1e-6, 3, "");
    text_add(out, " MPa of nominal pressure. Properties: ");
    for (size_t i = 0; i < count; i++) {
        text_add(out, "%s", i > 0 ? "; " : "");
        if (count > 1) {
            metal_name(out, metals, count, i);
            text_add(out, ": ");
        }
        text_add_markdown(out, metals[i].material->source[0] ? metals[i].material->source : "given in the scene");
    }
    text_add(out, ".");
    mean_free_path_note(out, results, metals, count);
}

static void write(struct text *out, const struct section_context *context)
{
    struct metal metals[METALS];
    size_t count = find_metals(metals, context->results);
    text_add(out, "## Material and load\n\n");
    if (!results_has_material(context->results)) {
        const double *loads = results_loads(context->results, context->results->baseline);
        text_add(out, "%s %zu load%s, P/(Aₙ E′) = ", results_without_material, context->results->load_count,
                 context->results->load_count == 1 ? "" : "s");
        number_format_power(out, loads[0], 3);
        text_add(out, " to ");
        number_format_power(out, loads[context->results->load_count - 1], 3);
        text_add(out, ".\n");
        return;
    }
    material_text(out, context, metals, count);
    text_add(out, "\n\n**Table 6.1.** Material.\n\n");
    table_6_1(out, context, metals, count);
}

const struct section section_material = {"material", NULL, write};
