#include "cli/command.h"
#include "contact/model.h"
#include "material/material.h"

#include <argp.h>
#include <math.h>
#include <stdio.h>

static error_t parse(int key, char *value, struct argp_state *state)
{
    if (key != ARGP_KEY_ARG)
        return ARGP_ERR_UNKNOWN;
    argp_error(state, "no argument is taken, but there is '%s'", value);
    return 0;
}

int command_models(int argc, char **argv)
{
    static const struct argp argp = {.parser = parse, .doc = "The models, their sources and where they are valid."};
    argp_parse(&argp, argc, argv, 0, NULL, NULL);
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

int command_materials(int argc, char **argv)
{
    static const struct argp argp = {.parser = parse,
                                     .doc = "The built-in materials and where their numbers are from."};
    argp_parse(&argp, argc, argv, 0, NULL, NULL);
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
