/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every rule between keys, as in their rows: a scene that breaks it is refused in its line, another is not. */
#include "scene/scene_source.h"
#include "scene_directory.h"

#define AROUND "material: tin\nnominal_area: 1 mm2\n" /* a mapping within the scene */

/* A value of every key that stands in a rule. */
static const struct {
    const char *mapping, *key, *value;
} values[] = {
    {"scene", "material", "tin"},
    {"scene", "nominal_area", "1 mm2"},
    {"scene", "hardness", "1 GPa"},
    {"scene", "current", "1 A"},
    {"scene", "lambda_s", "2 um"},
    {"scene", "lambda_c", "800 um"},
    {"measured", "file", "a.csv"},
    {"hardness", "c1", "1 GPa"},
    {"hardness", "c2", "-0.1"},
    {"load", "values", "[1e-3]"},
    {"load", "from", "1e-4"},
    {"load", "to", "1e-2"},
    {"load", "points", "7"},
    {"gap", "conductivity", "1 W/m/K"},
    {"gap", "filler", "pad"},
    {"gap", "bond_line", "20 um"},
    {"gap", "gas", "air"},
    {"gap", "pressure", "1 atm"},
    {"gap", "accommodation", "0.9"},
    {"gap", "liquid", "water"},
    {"plating", "thickness", "1 um"},
    {"plating", "resistivity", "1e-8"},
    {"plating", "metal", "silver"},
    {"shape", "flatness", "5 um"},
    {"shape", "over", "20 mm"},
    {"shape", "crown", "2 m"},
    {"shape", "height", "f.csv"},
    {"shape", "pressure", "g.csv"},
    {"shape", "bolts", "[[0.5 mm, 0.5 mm]]"},
    {"shape", "thickness", "[1 mm, 2 mm]"},
    {"shape", "scale", "true"},
    {"shape", "force", "1 N"},
    {"shape", "head", "1 mm"},
    {"surfaces", "file", "a.csv"},
    {"surfaces", "along", "b.csv"},
    {"surfaces", "lay", "0.5"},
};

static const char *value_of(const struct scene_mapping *mapping, size_t k)
{
    for (size_t v = 0; v < sizeof values / sizeof *values; v++)
        if (strcmp(values[v].mapping, mapping->name) == 0 && strcmp(values[v].key, mapping->keys[k].name) == 0)
            return values[v].value;
    fail_msg("test_scene_rules.c has no value of '%s' of '%s'", mapping->keys[k].name, mapping->name);
    return NULL;
}

/* Keys that are given, in this order. */
struct given {
    const struct scene_mapping *mapping;
    bool list; /* the mapping is an item of one */
    size_t keys[SCENE_KEYS_MOST], count;
    bool exchanged; /* the values of the first two */
};

static size_t key_of(const struct scene_mapping *mapping, const char *name, size_t length)
{
    for (size_t k = 0; k < mapping->count; k++)
        if (strlen(mapping->keys[k].name) == length && memcmp(mapping->keys[k].name, name, length) == 0)
            return k;
    fail_msg("a rule of '%s' names '%.*s', which is no key of it", mapping->name, (int)length, name);
    return 0;
}

/* The keys of a rule's list, and which of its demands ("a, b or c" makes two) each belongs to. */
struct list {
    size_t keys[SCENE_KEYS_MOST], demand[SCENE_KEYS_MOST], count;
};
static struct list list_of(const struct scene_mapping *mapping, const char *text)
{
    struct list list = {.count = 0};
    size_t demand = 0;
    for (const char *p = text ? text : ""; *p;) {
        size_t length = strcspn(p, ", ");
        list.keys[list.count] = key_of(mapping, p, length);
        list.demand[list.count++] = demand;
        p += length;
        demand += *p == ',';
        p += strncmp(p, " or ", 4) == 0 ? 4 : strspn(p, ", ");
    }
    return list;
}

/* Gives a key, and what it needs: the first of each demand. */
static void give(struct given *given, size_t k)
{
    for (size_t i = 0; i < given->count; i++)
        if (given->keys[i] == k)
            return;
    given->keys[given->count++] = k;
    const struct list needs = list_of(given->mapping, given->mapping->keys[k].needs);
    for (size_t i = 0; i < needs.count; i++)
        if (i == 0 || needs.demand[i] != needs.demand[i - 1])
            give(given, needs.keys[i]);
}

/* The first of what has to be there, but for one demand. */
static struct given least_of(const struct scene_mapping *mapping, bool list, size_t but)
{
    struct given given = {.mapping = mapping, .list = list};
    const struct list required = list_of(mapping, mapping->needs);
    for (size_t i = 0; i < required.count; i++)
        if (required.demand[i] != but && (i == 0 || required.demand[i] != required.demand[i - 1]))
            give(&given, required.keys[i]);
    return given;
}
enum { NO_DEMAND = 100 };

/* Where the mapping asks for one of several keys and none is given: the first one that is not in the list. */
static void give_way(struct given *given, const struct list *but)
{
    const struct list ways = list_of(given->mapping, given->mapping->one_of);
    bool has = false;
    for (size_t w = 0; w < ways.count; w++)
        for (size_t i = 0; i < given->count; i++)
            has = has || given->keys[i] == ways.keys[w];
    for (size_t w = 0; w < ways.count && !has; w++) {
        has = true;
        for (size_t i = 0; i < but->count; i++)
            has = has && but->keys[i] != ways.keys[w];
        if (has)
            give(given, ways.keys[w]);
    }
}

/* The scene, with the mapping in line *line, where its keys begin below it. */
static const char *text_of(const struct given *given, size_t *line)
{
    struct text *text = support_text();
    const bool whole = given->mapping == &scene_keys_whole;
    *line = whole ? 0 : 3;
    if (!whole)
        text_add(text, AROUND "%s: %s{\n", given->mapping->name, given->list ? "[" : "");
    for (size_t i = 0; i < given->count; i++) {
        size_t from = given->exchanged && i < 2 ? 1 - i : i;
        text_add(text, "%s%s: %s%s\n", whole ? "" : "  ", given->mapping->keys[given->keys[i]].name,
                 value_of(given->mapping, given->keys[from]), whole ? "" : ",");
    }
    text_add(text, whole ? "" : given->list ? "}]\n" : "}\n");
    return text_string(text);
}

/* Refused in the line of key `k` (SCENE_KEYS_MOST: of the mapping) by a message with the words; NULL: accepted. */
static void check(const struct given *given, size_t k, const char *words)
{
    struct directory directory = directory_make();
    struct scene scene;
    struct status status = {0};
    size_t line;
    const char *text = text_of(given, &line);
    scene_directory_add(&directory, "a.csv");
    scene_directory_add(&directory, "b.csv");
    directory_write(&directory, "f.csv",
                    "x [mm],y [mm],z [um]\n0,0,1\n.5,0,3\n1,0,1\n0,.5,3\n.5,.5,5\n1,.5,3\n0,1,1\n.5,1,3\n1,1,1\n");
    directory_write(&directory, "g.csv", "A [mm2], p [MPa]\n1, 1\n");
    directory_write(&directory, "scene.yaml", text);
    for (size_t i = 0; i < given->count && k < SCENE_KEYS_MOST; i++)
        line += given->keys[i] == k ? i + 1 : 0;
    enum status_code code = scene_read(&scene, directory.path, NULL, &status);
    const char *start = words ? filled("/scene.yaml:%zu: '", line) : "";
    if (code != (words ? STATUS_SCENE : STATUS_OK) ||
        (words && (!strstr(status.message, start) || !strstr(status.message, words))))
        fail_msg("%s (line %zu: %s):\n%s", status.message, line, words ? words : "accepted", text);
    scene_free(&scene);
    directory_remove(&directory);
}

/* Without a demand of `rule` refused in the line of `k`, with any of its keys not. Returns how many rules there are. */
static size_t check_demands(const struct scene_mapping *mapping, bool is_list, const char *rule, size_t k)
{
    const struct list list = list_of(mapping, rule);
    const bool own = k == SCENE_KEYS_MOST;
    for (size_t i = 0; i < list.count; i++) {
        struct given given = least_of(mapping, is_list, own ? list.demand[i] : NO_DEMAND);
        if (!own)
            given.keys[given.count++] = k;
        for (size_t j = 0; j < list.count && !own; j++) /* its other demands are met */
            if (list.demand[j] != list.demand[i])
                give(&given, list.keys[j]);
        struct given lacking = given;
        give_way(&lacking, &list);
        check(&lacking, k, "' needs '");
        give(&given, list.keys[i]);
        give_way(&given, &list);
        check(&given, k, NULL);
    }
    return list.count;
}

static size_t check_one_of(const struct scene_mapping *mapping, bool is_list)
{
    const struct list list = list_of(mapping, mapping->one_of);
    for (size_t i = 0; i < list.count; i++)
        for (size_t j = 0; j <= i; j++) {
            struct given given = least_of(mapping, is_list, NO_DEMAND);
            if (i == 0)
                check(&given, SCENE_KEYS_MOST, "' has none of '");
            give(&given, list.keys[i]);
            give(&given, list.keys[j]);
            check(&given, SCENE_KEYS_MOST, i == j ? NULL : "' has several of '");
        }
    return list.count;
}

static size_t check_excludes(const struct scene_mapping *mapping, bool is_list, size_t k)
{
    const struct list list = list_of(mapping, mapping->keys[k].excludes);
    for (size_t i = 0; i < list.count; i++) {
        struct given given = least_of(mapping, is_list, NO_DEMAND);
        give(&given, k);
        check(&given, k, NULL);
        give(&given, list.keys[i]);
        check(&given, k, filled("'%s' stands beside '", mapping->keys[k].name));
        given = least_of(mapping, is_list, NO_DEMAND);
        give(&given, list.keys[i]);
        check(&given, k, NULL);
    }
    return list.count;
}

/* Refused where the values are exchanged, or alike. */
static size_t check_above(const struct scene_mapping *mapping, bool is_list, size_t k)
{
    const struct list list = list_of(mapping, mapping->keys[k].above);
    for (size_t i = 0; i < list.count; i++) {
        struct given given = {.mapping = mapping, .list = is_list, .keys = {k, list.keys[i]}, .count = 2};
        check(&given, k, NULL);
        given.exchanged = true;
        check(&given, k, filled(", not above '%s', ", mapping->keys[list.keys[i]].name));
    }
    return list.count;
}

static size_t check_mapping(const struct scene_mapping *mapping, bool is_list)
{
    size_t rules = check_demands(mapping, is_list, mapping->needs, SCENE_KEYS_MOST) + check_one_of(mapping, is_list);
    for (size_t k = 0; k < mapping->count; k++)
        rules += check_demands(mapping, is_list, mapping->keys[k].needs, k) + check_excludes(mapping, is_list, k) +
                 check_above(mapping, is_list, k);
    return rules;
}

TEST_CASE(every_rule_refuses_what_breaks_it_alone)
{
    size_t rules = check_mapping(&scene_keys_whole, false);
    for (size_t k = 0; k < scene_key_count; k++)
        if (scene_keys[k].within)
            rules += check_mapping(scene_keys[k].within, scene_keys[k].read == scene_surfaces_read);
    assert_true(rules >= 43);
}

/* What says `none` is not given; what the command line or a surface says is. */
TEST_IN_DIRECTORY(what_counts_as_given)
{
    static const char *const accepted[] = {
        "gap: {filler: none, gas: air}\n",
        "lambda_s: 8 um\nlambda_c: none\n",
        "lambda_s: none\nlambda_c: 8 um\n",
        "hardness: 1 GPa\nsurfaces: [{file: a.csv, material: tin}]\n",
    };
    for (size_t i = 0; i < sizeof accepted / sizeof *accepted; i++)
        (void)scene_of(accepted[i]);
    scene_directory_add(place, "a.csv");
    directory_write(place, "scene.yaml", "hardness: 1 GPa\n");
    (void)scene_directory_read(place->path, &(struct scene_overrides){.material = "tin"});
    directory_write(place, "scene.yaml", "nominal_area: none\ncurrent: 1 A\n");
    scene_directory_refused(place->path, NULL, STATUS_SCENE, "scene.yaml:2: 'current' needs 'nominal_area'");
    directory_write(place, "scene.yaml", "gap: {filler: none, bond_line: 1 um}\n");
    scene_directory_refused(place->path, NULL, STATUS_SCENE, "scene.yaml:1: 'bond_line' needs");
}
