/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/command.h"
#include "contact/model.h"
#include "material/material.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { KEY_JSON = 0x100, WIDTH = 80, NAME_WIDTH = 21, COLUMNS = 4, COLUMN_WIDTH = 13 };

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

/** A name and what is said of it, in lines that a terminal takes. */
static void add_row(struct text *text, const char *before, int width, const char *name, const char *said)
{
    text_add(text, "%s%-*s ", before, width, name);
    text_add_wrapped(text, said, WIDTH, (int)strlen(before) + width + 1);
    text_add(text, "\n");
}

static int print_text(struct text *text)
{
    fputs(text_string(text), stdout);
    text_free(text);
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
    struct text text = {0};
    for (size_t m = 0; m < model_count; m++) {
        const char *const said[][2] = {{"equations", model_rows[m]->equations},
                                       {"assumes", model_rows[m]->assumes},
                                       {"valid", model_rows[m]->valid},
                                       {"source", model_rows[m]->source}};
        text_add(&text, "%s%s (%s)\n", m > 0 ? "\n" : "", model_rows[m]->name, model_rows[m]->label);
        for (size_t i = 0; i < sizeof said / sizeof *said; i++)
            add_row(&text, "  ", 10, said[i][0], said[i][1]);
    }
    return print_text(&text);
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
    struct text text = {0};
    for (size_t from = 0; from < material_property_count; from += COLUMNS) { /* as many columns as a terminal takes */
        size_t to = from + COLUMNS < material_property_count ? from + COLUMNS : material_property_count;
        text_add(&text, "%s%-*s", from > 0 ? "\n" : "", NAME_WIDTH, "material");
        for (size_t p = from; p < to; p++)
            text_add(&text, " %*s", COLUMN_WIDTH, material_properties[p].name);
        text_add(&text, "\n%-*s", NAME_WIDTH, "");
        for (size_t p = from; p < to; p++)
            text_add(&text, " %*s",
                     COLUMN_WIDTH + (int)strlen(material_properties[p].unit) -
                         text_characters(material_properties[p].unit),
                     material_properties[p].unit);
        text_add(&text, "\n");
        for (size_t i = 0; i < material_table_count; i++) {
            text_add(&text, "%-*s", NAME_WIDTH, material_table[i].name);
            for (size_t p = from; p < to; p++) {
                double value = material_value(&material_table[i], &material_properties[p]);
                if (isnan(value))
                    text_add(&text, " %*s", COLUMN_WIDTH, "-");
                else
                    text_add(&text, " %*.6g", COLUMN_WIDTH, value);
            }
            text_add(&text, "\n");
        }
    }
    text_add(&text, "\nsources\n");
    for (size_t i = 0; i < material_table_count; i++)
        add_row(&text, "", NAME_WIDTH, material_table[i].name, material_table[i].source);
    return print_text(&text);
}
