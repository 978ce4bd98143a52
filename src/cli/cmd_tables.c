/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/command.h"
#include "contact/model.h"
#include "material/material.h"

#include <math.h>
#include <stdio.h>

enum { KEY_JSON = 0x100 };

static const struct argp_option options[] = {
    {"json", KEY_JSON, 0, 0, "print an array of objects, one a row (default: text)", 0},
    {0},
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    bool *json = state->input;
    if (key == ARGP_KEY_ARG)
        return command_no_argument(value, state);
    if (key != KEY_JSON)
        return ARGP_ERR_UNKNOWN;
    *json = true;
    return 0;
}

const struct argp command_models_argp = {
    .options = options, .parser = parse, .doc = "The models, their sources and where they are valid."};
const struct argp command_materials_argp = {
    .options = options, .parser = parse, .doc = "The built-in materials and where their numbers are from."};

/** Prints the table as JSON; returns the exit status. */
static int print_json(json_t *rows)
{
    struct status status = {0};
    if (!command_json_print(rows)) {
        (void)status_memory(&status);
        return command_fail(&status);
    }
    return command_finish(COMMAND_DONE, NULL);
}

static json_t *model_json(const struct model_row *row)
{
    json_t *quantities = json_array();
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if (row->quantities & QUANTITY_BIT(q))
            json_array_append_new(quantities, json_string(quantity_rows[q].name));
    return json_pack("{s:s, s:s, s:s, s:b, s:b, s:o, s:o, s:o, s:s, s:s, s:s, s:s, s:s}", "model", row->name, "label",
                     row->label, "family", row->family, "by_default", row->by_default, "plastic", row->plastic,
                     "elastic_model", command_json_optional(row->elastic ? row->elastic->name : NULL), "quantities",
                     quantities, "largest_valid_area_ratio",
                     command_json_number(row->largest_area > 0 ? row->largest_area : NAN), "equations", row->equations,
                     "assumes", row->assumes, "valid", row->valid, "method", row->method, "source", row->source);
}

int command_models(int argc, char **argv)
{
    bool json = false;
    command_parse(&command_models_argp, argc, argv, &json);
    json_t *rows = json_array();
    for (size_t m = 0; m < model_count && json; m++)
        json_array_append_new(rows, model_json(model_rows[m]));
    if (json)
        return print_json(rows);
    json_decref(rows);
    for (size_t m = 0; m < model_count; m++)
        printf("%s%s (%s)\n  equations  %s\n  assumes    %s\n  valid      %s\n  source     %s\n", m > 0 ? "\n" : "",
               model_rows[m]->name, model_rows[m]->label, model_rows[m]->equations, model_rows[m]->assumes,
               model_rows[m]->valid, model_rows[m]->source);
    return command_finish(COMMAND_DONE, NULL);
}

enum { NAME_WIDTH = 22 };

/* Columns of the table as wide as their headings. */
static int width(size_t property)
{
    return property == 3 ? 19 : property > 3 ? 24 : 12;
}

static json_t *material_json(const struct material *material)
{
    json_t *json = json_pack("{s:s}", "material", material->name);
    for (size_t p = 0; p < material_property_count; p++)
        json_object_set_new(json, material_properties[p].key,
                            command_json_number(material_value(material, &material_properties[p])));
    json_object_set_new(json, "source", json_string(material->source));
    return json;
}

int command_materials(int argc, char **argv)
{
    bool json = false;
    command_parse(&command_materials_argp, argc, argv, &json);
    json_t *rows = json_array();
    for (size_t i = 0; i < material_table_count && json; i++)
        json_array_append_new(rows, material_json(&material_table[i]));
    if (json)
        return print_json(rows);
    json_decref(rows);
    printf("%-*s", NAME_WIDTH, "material");
    for (size_t p = 0; p < material_property_count; p++)
        printf(" %*s", width(p), material_properties[p].key);
    printf("\n");
    for (size_t i = 0; i < material_table_count; i++) {
        printf("%-*s", NAME_WIDTH, material_table[i].name);
        for (size_t p = 0; p < material_property_count; p++) {
            double value = material_value(&material_table[i], &material_properties[p]);
            if (isnan(value))
                printf(" %*s", width(p), "-");
            else
                printf(" %*.6g", width(p), value);
        }
        printf("\n");
    }
    printf("\nsources\n");
    for (size_t i = 0; i < material_table_count; i++)
        printf("%-*s %s\n", NAME_WIDTH, material_table[i].name, material_table[i].source);
    return command_finish(COMMAND_DONE, NULL);
}
