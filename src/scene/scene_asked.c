/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/scene_source.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ASKED_MOST = 32 };

/* A quantity of the models that can be asked for needs its row here. */
const struct scene_asked_row scene_asked_rows[] = {
    {"ecr", "ECR", UNIT_RESISTANCE, UNIT_RESISTANCE_AREA, QUANTITY_ECR, false, false, 1e-30, 1e30},
    {"tcr", "TCR", UNIT_THERMAL_RESISTANCE, UNIT_THERMAL_RESISTANCE_AREA, QUANTITY_TCR, false, false, 1e-30, 1e30},
    {"conductance", "h", 0, UNIT_CONDUCTANCE_AREA, QUANTITY_TCR, true, false, 1e-30, 1e30},
    {"area", "A/Aₙ", 0, UNIT_NUMBER | UNIT_PERCENT, QUANTITY_AREA, false, true, 1e-12, 1},
    {"temperature", "T", 0, UNIT_TEMPERATURE, QUANTITY_COUNT, false, true, 0, 1e5},
};
enum { ROWS = SCENE_COUNT(scene_asked_rows) };

/* What takes the row's place where the scene calls for these effects: the number of the whole joint. The last one that
 * fits does. */
static const struct {
    unsigned effects;
    struct scene_asked_row row;
} joint_rows[] = {
    {EFFECT_BIT(EFFECT_FILM),
     {"ecr", "ECR with film", UNIT_RESISTANCE, UNIT_RESISTANCE_AREA, QUANTITY_JOINT_ECR, false, false, 1e-30, 1e30}},
    {EFFECT_BIT(EFFECT_PLATING),
     {"ecr", "ECR with plating", UNIT_RESISTANCE, UNIT_RESISTANCE_AREA, QUANTITY_JOINT_ECR, false, false, 1e-30, 1e30}},
    {EFFECT_BIT(EFFECT_FILM) | EFFECT_BIT(EFFECT_PLATING),
     {"ecr", "ECR with film and plating", UNIT_RESISTANCE, UNIT_RESISTANCE_AREA, QUANTITY_JOINT_ECR, false, false,
      1e-30, 1e30}},
    {EFFECT_BIT(EFFECT_GAP),
     {"conductance", "h_j", 0, UNIT_CONDUCTANCE_AREA, QUANTITY_JOINT, false, true, 1e-30, 1e30}},
    {EFFECT_BIT(EFFECT_HEATING),
     {"temperature", "T_max", 0, UNIT_TEMPERATURE, QUANTITY_TEMPERATURE, false, false, 0, 1e5}},
};

/* What is being read into: targets, or limits. */
struct list {
    struct scene_asked *items;
    size_t *count;
    const struct scene_asked_row *row; /* of a limit */
};

static const struct scene_asked_row *row_named(const char *name)
{
    const struct scene_asked_row *row = scene_asked_rows;
    while (strcmp(row->name, name) != 0)
        row++;
    return row;
}

static bool read_value(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value, void *field)
{
    const struct list *list = field;
    struct scene_quantity quantity;
    if (!scene_source_quantity_of(&quantity, source, key, value))
        return false;
    if (*list->count == ASKED_MOST)
        return scene_source_fail_at(source, value, "more than %d of them; leave some out", ASKED_MOST);
    struct scene_asked *asked = &list->items[(*list->count)++];
    *asked = (struct scene_asked){.row = list->row ? list->row : row_named(key->name),
                                  .is_most = strcmp(key->name, "most") == 0,
                                  .kind = quantity.kind,
                                  .unit = quantity.unit,
                                  .value = quantity.value,
                                  .line = scene_source_line(value)};
    const char *si = unit_si(quantity.kind);
    snprintf(asked->unit_text, sizeof asked->unit_text, "%s", quantity.has_unit ? quantity.text : si);
    snprintf(asked->text, sizeof asked->text, "%.6g%s%s",
             (quantity.value - quantity.unit.offset) / quantity.unit.factor, asked->unit_text[0] ? " " : "",
             asked->unit_text);
    return true;
}

static bool read_ends(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value, void *field)
{
    struct list *list = field;
    struct scene_key keys[2] = {*key, *key};
    size_t lines[2];
    list->row = row_named(key->name);
    keys[0].name = "most";
    keys[1].name = "least";
    keys[0].read = keys[1].read = read_value;
    if (!scene_source_mapping(source, value, key->name, keys, SCENE_COUNT(keys), lines, list))
        return false;
    return lines[0] > 0 || lines[1] > 0 ||
           scene_source_fail_at(source, value, "'%s' has no limit; give 'most' or 'least'", key->name);
}

bool scene_asked_read(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value, void *field)
{
    struct scene *scene = field;
    bool limits = strcmp(key->name, "limits") == 0;
    struct scene_asked **items = limits ? &scene->limits : &scene->targets;
    size_t *count = limits ? &scene->limit_count : &scene->target_count;
    struct list list = {.items = *items = calloc(ASKED_MOST, sizeof **items), .count = count};
    struct scene_key keys[ROWS];
    size_t lines[ROWS];
    if (!*items)
        return scene_source_memory(source);
    for (size_t r = 0; r < ROWS; r++) {
        const struct scene_asked_row *row = &scene_asked_rows[r];
        keys[r] = (struct scene_key){row->name,
                                     NULL,
                                     limits ? read_ends : read_value,
                                     .least = row->least,
                                     .most = row->most,
                                     .quantities = row->total | row->per_area};
    }
    for (size_t i = 0; i < (limits ? 1 : scene_source_item_count(value)); i++)
        if (!scene_source_mapping(source, limits ? value : scene_source_item(source, value, i), key->name, keys, ROWS,
                                  lines, &list))
            return false;
    return *count > 0 || scene_source_fail_at(source, value, "'%s' names none; remove the line, or give one such as %s",
                                              key->name, limits ? "ecr: {most: 2 mohm}" : "{ecr: 1 mohm}");
}

/* Will the models compute it on every surface? */
static bool check_effects(const struct scene *scene, struct scene_source *source, const struct scene_asked *asked)
{
    const struct quantity_row *quantity = &quantity_rows[asked->row->quantity];
    struct scene_lack_words lack;
    const unsigned needed = quantity->from ? quantity->effect & scene->called : quantity->effect;
    for (int e = 0; e < EFFECT_COUNT; e++) {
        if (!(needed & EFFECT_BIT(e)))
            continue;
        if (!scene->effects_auto && !(scene->effects & EFFECT_BIT(e)))
            return scene_source_fail(source, asked->line,
                                     "'%s' needs the effect '%s', which is not listed; add it or leave '%s' out",
                                     asked->row->name, effect_rows[e].name, asked->row->name);
        for (size_t i = 0; i < scene->surface_count; i++)
            if (scene_lack_words(&lack, &scene->surfaces[i].bodies, scene->surfaces[i].name, &effect_rows[e]))
                return scene_source_fail(source, asked->line, "'%s' needs %s or leave '%s' out", asked->row->name,
                                         lack.text, asked->row->name);
    }
    return true;
}

static bool complete(const struct scene *scene, struct scene_source *source, struct scene_asked *asked)
{
    bool total = asked->kind & asked->row->total;
    for (size_t r = 0; r < SCENE_COUNT(joint_rows); r++)
        if (!(joint_rows[r].effects & ~scene->called) && strcmp(joint_rows[r].row.name, asked->row->name) == 0)
            asked->row = &joint_rows[r].row;
    if (asked->row->quantity == QUANTITY_COUNT)
        return scene_source_fail(source, asked->line,
                                 "'%s' is what a current heats the spots to; add 'current' or leave it out",
                                 asked->row->name);
    if (total && isnan(scene->nominal_area_m2))
        return scene_source_fail(
            source, asked->line, "'%s' is %s, but on which area? add 'nominal_area', or give it times an area (%s)",
            asked->row->name, unit_quantity_name(asked->kind), unit_si((enum unit_quantity)asked->row->per_area));
    asked->factor = asked->unit.factor * (total ? scene->nominal_area_m2 : 1);
    asked->value *= total ? scene->nominal_area_m2 : 1;
    if (asked->row->reciprocal)
        asked->value = 1 / asked->value;
    asked->is_upper = asked->is_most != asked->row->reciprocal;
    return check_effects(scene, source, asked);
}

bool scene_asked_complete(struct scene *scene, struct scene_source *source)
{
    bool good = true;
    for (size_t t = 0; t < scene->target_count && good; t++)
        good = complete(scene, source, &scene->targets[t]);
    for (size_t l = 0; l < scene->limit_count && good; l++)
        good = complete(scene, source, &scene->limits[l]);
    return good;
}

double scene_asked_shown(const struct scene_asked *asked, double value)
{
    return ((asked->row->reciprocal ? 1 / value : value) - asked->unit.offset) / asked->factor;
}
