/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/command.h"
#include "contact/model.h"
#include "joint/joint.h"
#include "material/material.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { KEY_JSON = 0x100, WIDTH = 80, KEY_WIDTH = 25 };

static const struct argp_option options[] = {
    {"json", KEY_JSON, 0, 0, "print an array of objects, one a row (default: text)", 0},
    {0},
};

static error_t parse(int key, __attribute__((unused)) char *value, struct argp_state *state)
{
    *(bool *)state->input |= key == KEY_JSON;
    return key == KEY_JSON ? 0 : ARGP_ERR_UNKNOWN;
}

const struct argp command_models_argp = {
    .options = options, .parser = parse, .doc = "The models, their sources and where they are valid."};
const struct argp command_materials_argp = {
    .options = options, .parser = parse, .doc = "The materials, platings, fillers and fluids, and their sources."};

/** Prints the rows as JSON, or as text: a name and below it texts and numbers. Returns the exit status. */
static int print(json_t *rows, bool as_json)
{
    OWNED(text_free) struct text text = {0};
    const char *key;
    json_t *row, *value;
    size_t i;
    if (as_json) {
        command_json_print(rows);
        return command_finish(COMMAND_DONE, NULL);
    }
    json_array_foreach (rows, i, row) {
        int before = 0;
        text_add(&text, i > 0 ? "\n" : "");
        json_object_foreach (row, key, value) {
            if (!json_is_string(value) && !json_is_number(value))
                continue;
            char number[32];
            snprintf(number, sizeof number, "%.6g", json_number_value(value));
            if (before > 0)
                text_add(&text, "  %-*s", KEY_WIDTH, key);
            else if (string_view_is_one_of(string_view_of(key), "plating filler gas liquid"))
                text_add(&text, "%s ", key);
            text_add_wrapped(&text, json_is_string(value) ? json_string_value(value) : number, WIDTH, before);
            text_add(&text, "\n");
            before = 2 + KEY_WIDTH;
        }
    }
    fputs(text_string(&text), stdout);
    json_decref(rows);
    return command_finish(COMMAND_DONE, NULL);
}

static json_t *model_json(const struct model_row *row)
{
    json_t *quantities = json_array();
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if (row->quantities & QUANTITY_BIT(q))
            json_array_append_new(quantities, json_string(quantity_rows[q].name));
    return json_pack("{s:s, s:s, s:s, s:b, s:b, s:o, s:o, s:o, s:s, s:s, s:s, s:s, s:s}", "model", row->name, "label",
                     row->label, "family", row->family, "by_default", true, "plastic", row->plastic, "elastic_model",
                     json_shown(row->elastic ? row->elastic->name : NULL), "quantities", quantities,
                     "largest_valid_area_ratio", json_finite(row->largest_area > 0 ? row->largest_area : NAN),
                     "equations", row->equations, "assumes", row->assumes, "valid", row->valid, "method", row->method,
                     "source", row->source);
}

int command_models(int argc, char **argv)
{
    bool json = false;
    command_parse(&command_models_argp, argc, argv, &json);
    json_t *rows = json_array();
    for (size_t m = 0; m < model_count; m++)
        json_array_append_new(rows, model_json(model_rows[m]));
    return print(rows, json);
}

static json_t *material_json(const struct material *material)
{
    json_t *json = json_pack("{s:s}", "material", material->name);
    for (size_t p = 0; p < material_property_count; p++)
        json_object_set_new(json, material_properties[p].key,
                            json_finite(material_value(material, &material_properties[p])));
    json_object_set_new(json, "source", json_string(material->source));
    return json;
}

int command_materials(int argc, char **argv)
{
    bool json = false;
    command_parse(&command_materials_argp, argc, argv, &json);
    json_t *rows = json_array();
    for (size_t i = 0; i < material_table_count; i++)
        json_array_append_new(rows, material_json(&material_table[i]));
    for (size_t i = 0; i < JOINT_PLATINGS + JOINT_FILLERS; i++) {
        size_t f = i < JOINT_PLATINGS ? 0 : i - JOINT_PLATINGS;
        const struct joint_layer *layer = f ? &joint_fillers[f] : &joint_platings[i % JOINT_PLATINGS];
        if (layer->source)
            json_array_append_new(rows, json_pack("{s:s, s:f, s:f, s:f, s:o*, s:s}", f ? "filler" : "plating",
                                                  f ? joint_filler_names[f] : joint_plating_names[i],
                                                  f ? "conductivity_W_per_mK" : "resistivity_ohm_m", layer->value,
                                                  "least_thickness_m", layer->least_m, "most_thickness_m",
                                                  layer->most_m, "hardness_Pa",
                                                  layer->hardness_Pa > 0 ? json_real(layer->hardness_Pa) : NULL,
                                                  "source", layer->source));
    }
    for (size_t i = 0; i < gas_count + gas_liquid_count; i++) {
        const bool liquid = i >= gas_count;
        const struct gas *fluid = liquid ? &gas_liquids[i - gas_count] : &gas_table[i];
        json_array_append_new(rows,
                              json_pack("{s:s, s:f, s:f, s:f, s:o*, s:o*, s:o*, s:s}", liquid ? "liquid" : "gas",
                                        fluid->name, "conductivity_W_per_mK", fluid->conductivity_W_per_mK,
                                        "least_temperature_K", fluid->least_K, "most_temperature_K", fluid->most_K,
                                        "prandtl", liquid ? NULL : json_real(gas_prandtl(fluid)), "heat_ratio",
                                        liquid ? NULL : json_real(fluid->heat_ratio), "accommodation",
                                        liquid ? NULL : json_real(fluid->accommodation), "source", fluid->source));
    }
    return print(rows, json);
}
