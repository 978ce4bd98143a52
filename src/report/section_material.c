/* Material and load: table 6.1, E' and the loads as pressures. */
#include "report/section.h"

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

/** Is the counterface a body of its own? Two of the same name and numbers from the same source are one metal. */
static bool has_other_body(const struct scene *scene)
{
    if (scene->counterface_kind != MATERIAL_COUNTERFACE_ELASTIC)
        return false;
    bool same = strcmp(scene->material.name, scene->counterface.name) == 0 &&
                strcmp(scene->material.source, scene->counterface.source) == 0;
    for (size_t i = 0; i < material_property_count && same; i++) {
        double a = material_value(&scene->material, &material_properties[i]);
        double b = material_value(&scene->counterface, &material_properties[i]);
        same = a == b || (isnan(a) && isnan(b));
    }
    return !same;
}

/** A body's name, with its side where both have the same. */
static void body_name(struct text *out, const struct scene *scene, bool counterface)
{
    text_add_markdown(out, counterface ? scene->counterface.name : scene->material.name);
    if (has_other_body(scene) && strcmp(scene->material.name, scene->counterface.name) == 0)
        text_add(out, counterface ? " (counterface)" : " (surface)");
}

static void source_of(struct text *out, const struct material *material)
{
    text_add_markdown(out, material->source[0] ? material->source : "given in the scene");
}

static void table_6_1(struct text *out, const struct section_context *context)
{
    const struct scene *scene = context->results->scene;
    bool elastic = scene->counterface_kind == MATERIAL_COUNTERFACE_ELASTIC;
    bool two = has_other_body(scene);
    text_add(out, "| property | symbol | ");
    body_name(out, scene, false);
    if (two) {
        text_add(out, " | ");
        body_name(out, scene, true);
    }
    text_add(out, "%s | unit |\n|---|---|---:|%s---|\n", elastic && !two ? ", both bodies" : "", two ? "---:|" : "");
    for (size_t i = 0; i < material_property_count; i++) {
        const struct material_property *property = &material_properties[i];
        double values[2] = {material_value(&scene->material, property), material_value(&scene->counterface, property)};
        if (!is_needed(context->results->plan, property->key))
            continue;
        text_add(out, "| %s | %s", property->meaning, property->symbol);
        for (int side = 0; side <= (int)two; side++) {
            text_add(out, " | ");
            number_format_given(out, values[side]);
        }
        text_add(out, " | %s |\n", property->unit);
    }
}

static void material_text(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    const struct material_pair *pair = &results->plan->pair;
    number_format_between(out, "E′ = ", pair->effective_modulus_Pa * 1e-9, 4, " GPa");
    if (plan_runs(results->plan, EFFECT_PLASTICITY))
        number_format_between(out, ", C = ", pair->yield_coefficient, 4, " (a spot yields at the mean pressure C·S_y)");
    if (plan_runs(results->plan, EFFECT_SCALE_DEPENDENT))
        number_format_between(out, ", mean free path of the heat carriers ", pair->mean_free_path_m[0] * 1e9, 3, " nm");
    text_add(out, ". %zu load%s, ", results->load_count, results->load_count == 1 ? "" : "s");
    text_add(out, "P/(Aₙ E′) = ");
    number_format_power(out, results->loads[0], 3);
    if (results->load_count > 1) {
        text_add(out, " to ");
        number_format_power(out, results->loads[results->load_count - 1], 3);
    }
    number_format_between(out, ", that is ", results->loads[0] * pair->effective_modulus_Pa * 1e-6, 3, "");
    if (results->load_count > 1)
        number_format_between(out, " to ", results->loads[results->load_count - 1] * pair->effective_modulus_Pa * 1e-6,
                              3, "");
    text_add(out, " MPa of nominal pressure. Properties: ");
    if (has_other_body(results->scene)) {
        body_name(out, results->scene, false);
        text_add(out, ": ");
    }
    source_of(out, &results->scene->material);
    if (has_other_body(results->scene)) {
        text_add(out, "; ");
        body_name(out, results->scene, true);
        text_add(out, ": ");
        source_of(out, &results->scene->counterface);
    }
    text_add(out, ".");
}

static void write(struct text *out, const struct section_context *context)
{
    text_add(out, "## Material and load\n\n");
    material_text(out, context);
    text_add(out, "\n\n**Table 6.1.** Material.\n\n");
    table_6_1(out, context);
}

const struct section section_material = {"material", NULL, write};
