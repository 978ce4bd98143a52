/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/scene_source.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ASKED_MOST = 32, KEYS_MOST = 2 * QUANTITY_COUNT };

/* What is being read into: targets, or limits. */
struct list {
    struct scene_asked *items;
    size_t *count;
    const char *key; /* of a limit */
};

static bool read_value(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value, void *field)
{
    const struct list *list = field;
    struct scene_quantity quantity;
    if (!scene_source_quantity_of(source, key, value, &quantity))
        return false;
    if (*list->count == ASKED_MOST)
        return scene_source_fail_at(source, value, "more than %d of them; leave some out", ASKED_MOST);
    struct scene_asked *asked = &list->items[(*list->count)++];
    *asked = (struct scene_asked){.is_most = strcmp(key->name, "most") == 0,
                                  .kind = quantity.kind,
                                  .unit = quantity.unit,
                                  .value = quantity.value,
                                  .line = scene_source_line(value)};
    (void)quantity_of_key(&asked->how, list->key ? list->key : key->name,
                          ~0U); /* until it is known what is called for */
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
    list->key = key->name;
    keys[0].name = "most";
    keys[1].name = "least";
    keys[0].read = keys[1].read = read_value;
    return scene_source_mapping(source, value, SCENE_RULED(key->name, keys, .needs = "most or least"), list);
}

bool scene_asked_read(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value, void *field)
{
    struct scene *scene = field;
    bool limits = strcmp(key->name, "limits") == 0;
    struct scene_asked **items = limits ? &scene->limits : &scene->targets;
    size_t *count = limits ? &scene->limit_count : &scene->target_count;
    struct list list = {.items = *items = calloc(ASKED_MOST, sizeof **items), .count = count};
    struct scene_key keys[KEYS_MOST];
    size_t known = 0;
    if (!*items)
        return scene_source_memory(source);
    for (size_t r = 0; r < KEYS_MOST; r++) {
        const struct quantity_asked *how = &quantity_rows[r / 2].asked[r % 2];
        size_t k = 0;
        while (k < known && how->key && strcmp(keys[k].name, how->key) != 0)
            k++;
        if (how->key && k == known)
            keys[known++] = (struct scene_key){how->key,
                                               NULL,
                                               limits ? read_ends : read_value,
                                               .least = how->least,
                                               .most = how->most,
                                               .quantities = how->total | how->per_area};
    }
    const struct scene_mapping mapping = {.name = key->name, .keys = keys, .count = known};
    for (size_t i = 0; i < (limits ? 1 : scene_source_item_count(value)); i++)
        if (!scene_source_mapping(source, limits ? value : scene_source_item(source, value, i), &mapping, &list))
            return false;
    return *count > 0 || scene_source_fail_at(source, value, "'%s' names none; remove the line, or give one such as %s",
                                              key->name, limits ? "ecr: {most: 2 mohm}" : "{ecr: 1 mohm}");
}

/* Will the models compute it on every surface? */
static bool check_effects(const struct scene *scene, struct scene_source *source, const struct scene_asked *asked)
{
    const struct quantity_row *quantity = &quantity_rows[asked->quantity];
    struct scene_lack_words lack;
    const unsigned needed = quantity_of_joint(asked->quantity) ? quantity->effect & scene->called : quantity->effect;
    for (int e = 0; e < EFFECT_COUNT; e++) {
        if (!(needed & EFFECT_BIT(e)))
            continue;
        if (!scene->effects_auto && !(scene->effects & EFFECT_BIT(e)))
            return scene_source_fail(source, asked->line,
                                     "'%s' needs the effect '%s', which is not listed; add it or leave '%s' out",
                                     asked->how->key, effect_rows[e].name, asked->how->key);
        for (size_t i = 0; i < scene->surface_count; i++)
            if (scene_lack_words(&lack, &scene->surfaces[i].bodies, scene->surfaces[i].name, &effect_rows[e]))
                return scene_source_fail(source, asked->line, "'%s' needs %s or leave '%s' out", asked->how->key,
                                         lack.text, asked->how->key);
    }
    return true;
}

/** What it is called: of a quantity that several effects change, with those that do. */
static void name(struct scene_asked *asked, unsigned called)
{
    const unsigned any = quantity_rows[asked->quantity].effect;
    int used = snprintf(asked->symbol, sizeof asked->symbol, "%s", asked->how->symbol);
    const char *before = " with ";
    for (int e = 0; e < EFFECT_COUNT && (any & (any - 1)); e++)
        if (any & called & EFFECT_BIT(e)) {
            used += snprintf(asked->symbol + used, sizeof asked->symbol - (size_t)used, "%s%s", before,
                             effect_rows[e].name);
            before = " and ";
        }
}

static bool complete(const struct scene *scene, struct scene_source *source, struct scene_asked *asked)
{
    const char *key = asked->how->key;
    bool total = asked->kind & asked->how->total;
    asked->quantity = quantity_of_key(&asked->how, key, scene->called);
    if (!asked->how) {
        int e = 0;
        while (!(quantity_rows[asked->quantity].effect & EFFECT_BIT(e)))
            e++;
        return scene_source_fail(source, asked->line, "'%s' needs a %s; add '%s' or leave '%s' out", key,
                                 effect_rows[e].key, effect_rows[e].key, key);
    }
    if (total && isnan(scene->nominal_area_m2))
        return scene_source_fail(
            source, asked->line, "'%s' is %s, but on which area? add 'nominal_area', or give it times an area (%s)",
            key, unit_quantity_name(asked->kind), unit_si((enum unit_quantity)asked->how->per_area));
    name(asked, scene->called);
    asked->factor = asked->unit.factor * (total ? scene->nominal_area_m2 : 1);
    asked->value *= total ? scene->nominal_area_m2 : 1;
    if (asked->how->reciprocal)
        asked->value = 1 / asked->value;
    asked->is_upper = asked->is_most != asked->how->reciprocal;
    return check_effects(scene, source, asked);
}

void scene_asked_complete(struct scene *scene, struct scene_source *source)
{
    bool good = true;
    for (size_t t = 0; t < scene->target_count && good; t++)
        good = complete(scene, source, &scene->targets[t]);
    for (size_t l = 0; l < scene->limit_count && good; l++)
        good = complete(scene, source, &scene->limits[l]);
}

double scene_asked_shown(const struct scene_asked *asked, double value)
{
    return ((asked->how->reciprocal ? 1 / value : value) - asked->unit.offset) / asked->factor;
}
