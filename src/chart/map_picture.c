/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "chart/map_picture.h"

#include "chart/chart.h"
#include "output/record.h"
#include <stdio.h>
#include <string.h>

static const double micro = 1e6, milli = 1e3; /* lengths from 1 mm on are in mm */

void map_picture_name(char *out, size_t size, const char *surface)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-";
    snprintf(out, size, "map-%s", surface);
    for (char *c = out; *c; c++)
        if (!strchr(letters, *c))
            *c = '-';
}

enum status_code map_picture_write(const struct map_contact *contact, const struct material_pair *pair,
                                   const char *name, const char *title, struct mustache_folder *templates,
                                   const char *directory)
{
    const size_t cells = contact->cells;
    const double side_m = (double)cells * contact->cell_m;
    const bool small = side_m < 1e-3;
    const bool flows = contact->flowed > 0;
    const double length = small ? micro : milli, stress = pair->unknown ? 1 : pair->effective_modulus_Pa * 1e-6;
    struct text script = {0}, data = {0};
    for (int block = 0; block < 2; block++, text_add(&data, "\n\n"))
        for (size_t k = 0; k < cells * cells; k++)
            text_add(&data, block == 0 ? "%.3g%s" : "%.0f%s",
                     block == 0 ? contact->height_m[k] * micro : (double)contact->is[k], (k + 1) % cells ? "," : "\n");
    for (size_t i = 0; i < contact->points; i++)
        text_add(&data, "%.6g,%.6g\n", (double)i * contact->spacing_m * length, contact->pressure[i] * stress);
    json_t *view = json_pack("{ss so ss sf sf sf sb sb}", "name", name, "title", json_shown(title), "length_unit",
                             small ? "µm" : "mm", "cell", contact->cell_m * length, "side", side_m * length, "section",
                             contact->section_m * length, "has_material", !pair->unknown, "flows", flows);
    if (view && flows)
        json_set(view, "hardness", pair->hardness_Pa / pair->effective_modulus_Pa * stress);
    enum status_code rc =
        view ? mustache_file(&script, templates, "charts/map", view, chart_escape) : status_memory(templates->status);
    if (rc == STATUS_OK)
        rc = text_save(&script, templates->status, "%s/%s.gp", directory, name);
    if (rc == STATUS_OK)
        rc = text_save(&data, templates->status, "%s/%s.csv", directory, name);
    json_decref(view);
    text_free(&script);
    text_free(&data);
    return rc;
}
