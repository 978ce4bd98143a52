/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/limits.h"
#include "scene/scene_source.h"

#include <assert.h>
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const scene_data_names[SCENE_DATA_COUNT] = {"auto", "full"};
static const char *const closure_names[SINUSOID_FIT_COUNT] = {"thesis", "numeric"};
static const char *const measured_quantity_names[SCENE_MEASURED_QUANTITY_COUNT] = {"ecr", "tcr"};
const unsigned scene_measured_resistances[SCENE_MEASURED_QUANTITY_COUNT] = {
    [SCENE_MEASURED_ECR] = UNIT_RESISTANCE | UNIT_RESISTANCE_AREA,
    [SCENE_MEASURED_TCR] = UNIT_THERMAL_RESISTANCE | UNIT_THERMAL_RESISTANCE_AREA,
};

/* Loads, in Pa or P/(A_n E'): any that keeps its distance from the ends of double. */
#define LOAD_LEAST       1e-100
#define LOAD_MOST        1e100
#define LOAD_POINTS_MOST 100000

void scene_keys_effect_names(const char *names[EFFECT_COUNT])
{
    for (int i = 0; i < EFFECT_COUNT; i++)
        names[i] = effect_rows[i].name;
}

unsigned scene_keys_with_needed(struct scene_source *source, unsigned effects)
{
    for (int i = 0; i < EFFECT_COUNT; i++)
        for (int needed = 0; needed < EFFECT_COUNT; needed++)
            if ((effects & EFFECT_BIT(i)) && (effect_rows[i].needs_effects & EFFECT_BIT(needed))) {
                effects |= EFFECT_BIT(needed);
                if (source->effect_line[needed] == 0)
                    source->effect_line[needed] = source->effect_line[i];
            }
    return effects;
}

enum { MODEL_NAMES = 128 }; /* a family and a name for each of at most 64 models */

/* Names of models that went, families among them. */
static const struct {
    const char *name, *now;
} former_models[] = {
    {"two-band", "strip"},          {"two-band-elastic", "strip"},    {"two-band-plastic", "strip-plastic"},
    {"contacting-slopes", "strip"}, {"persson", "corrected-persson"}, {"sridhar-yovanovich", "strip"},
};

static bool fail_word(struct scene_source *source, const yaml_node_t *item, struct string_view word, const char *what,
                      const char *const *names, size_t count)
{
    for (size_t k = 0; k < SCENE_COUNT(former_models) && strcmp(what, "model") == 0; k++)
        if (string_view_equals(word, former_models[k].name))
            return scene_source_fail_at(source, item, "model '%s' is no longer there; '%s' took its place",
                                        former_models[k].name, former_models[k].now);
    return scene_source_unknown(source, item, what, names, count, count);
}

/* One or more words out of `names`, as a list or as one text: in `lines` the last line of each, 0 for the others. */
static bool read_set(struct scene_source *source, const struct scene_key *key, const char *what,
                     const yaml_node_t *value, const char *const *names, size_t count, size_t *lines)
{
    memset(lines, 0, count * sizeof *lines);
    for (size_t i = 0; i < scene_source_item_count(value); i++) {
        const yaml_node_t *item = scene_source_item(source, value, i);
        if (item->type != YAML_SCALAR_NODE)
            return scene_source_wrong_type(source, item, key->name, "a list of names");
        const char *rest = (const char *)item->data.scalar.value, *word;
        for (size_t length; (word = scene_words_next(&rest, &length));) {
            size_t n = scene_words_find(word, length, names, count);
            if (n == count)
                return fail_word(source, item, (struct string_view){word, rest}, what, names, count);
            lines[n] = scene_source_line(item);
        }
    }
    return true;
}

static void add_name(const char *names[MODEL_NAMES], size_t *count, const char *name)
{
    if (scene_words_find(name, strlen(name), names, *count) == *count)
        names[(*count)++] = name;
}

/* Families, each once, then single models. */
static bool read_models(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    const char *names[MODEL_NAMES] = {0};
    size_t lines[MODEL_NAMES], count = 0;
    for (size_t m = 0; m < model_count; m++)
        add_name(names, &count, model_rows[m]->family);
    for (size_t m = 0; m < model_count; m++)
        add_name(names, &count, model_rows[m]->name);
    if (!read_set(source, key, "model", value, names, count, lines))
        return false;
    uint64_t *models = key->field;
    *models = 0;
    source->scene->models_named = true;
    for (size_t i = 0; i < count; i++)
        *models |= lines[i] ? model_find(names[i]) : 0;
    return *models || scene_source_fail_at(source, value, "'models' names none; remove the line for the default ones");
}

static bool read_effects(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct scene *scene = source->scene;
    const char *names[EFFECT_COUNT];
    if (scene_source_is(value, "auto"))
        return true;
    scene_keys_effect_names(names);
    scene->effects_auto = false;
    if (!read_set(source, key, "effect", value, names, EFFECT_COUNT, source->effect_line))
        return false;
    for (int i = 0; i < EFFECT_COUNT; i++)
        scene->effects |= source->effect_line[i] ? EFFECT_BIT(i) : 0;
    scene->effects = scene_keys_with_needed(source, scene->effects);
    return true;
}

/* Names of programs, joined: report/export.h knows which there are. */
static bool read_export(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct text names = {0};
    for (size_t i = 0; i < scene_source_item_count(value); i++) {
        const yaml_node_t *item = scene_source_item(source, value, i);
        if (item->type != YAML_SCALAR_NODE) {
            text_free(&names);
            return scene_source_wrong_type(source, item, key->name, "a list of names");
        }
        text_add(&names, "%s ", (const char *)item->data.scalar.value);
    }
    source->scene->exports = strdup(text_string(&names));
    text_free(&names);
    return source->scene->exports || scene_source_memory(source);
}

/* Wavelengths [shortest, longest]. */
static bool read_fit_band(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    double *band = key->field;
    if (scene_source_is(value, key->word))
        return true;
    if (value->type != YAML_SEQUENCE_NODE || scene_source_item_count(value) != 2)
        return scene_source_wrong_type(source, value, key->name, "two wavelengths [shortest, longest] in m");
    struct scene_key number = *key;
    for (size_t i = 0; i < 2; i++) {
        number.field = &band[i];
        if (!scene_source_quantity(source, &number, scene_source_item(source, value, i)))
            return false;
    }
    return band[0] < band[1] ||
           scene_source_fail_at(source, value, "'%s' is [%g, %g]; give the shorter wavelength first", key->name,
                                band[0], band[1]);
}

/* One load, of the kind and with the unit that those before it in `load` have. */
static bool read_load_one(struct scene_source *source, const struct scene_key *key, struct scene_load *load,
                          double *number, const yaml_node_t *value)
{
    struct scene_quantity quantity;
    if (!scene_source_quantity_of(&quantity, source, key, value))
        return false;
    if (quantity.has_unit && load->kind_line > 0 && load->kind != quantity.kind)
        return scene_source_fail_at(source, value, "'%s' is %s, but %s stands in line %zu; give one kind", key->name,
                                    unit_quantity_name(quantity.kind), unit_quantity_name(load->kind), load->kind_line);
    if (quantity.has_unit && load->kind_line == 0) {
        load->kind = quantity.kind;
        load->kind_line = scene_source_line(value);
        load->unit = quantity.unit;
        strcpy(load->unit_text, quantity.kind == UNIT_NUMBER ? "" : quantity.text);
    }
    load->plain_line = quantity.has_unit ? load->plain_line : scene_source_line(value);
    *number = quantity.value;
    return true;
}

static bool read_load_number(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    double *number = key->field;
    return read_load_one(source, key, &source->scene->load, number, value);
}

static bool read_load_list(struct scene_source *source, const struct scene_key *key, struct scene_load *load,
                           size_t most, const yaml_node_t *value)
{
    size_t count = scene_source_item_count(value);
    if (count == 0 || count > most)
        return scene_source_fail_at(source, value, "'%s' holds %zu loads; allowed is 1 to %zu", key->name, count, most);
    load->values = malloc(count * sizeof *load->values);
    if (!load->values)
        return scene_source_memory(source);
    load->points = count;
    for (size_t i = 0; i < count; i++)
        if (!read_load_one(source, key, load, &load->values[i], scene_source_item(source, value, i)))
            return false;
    return true;
}

static bool read_load_values(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    return read_load_list(source, key, key->field, LOAD_POINTS_MOST, value);
}

/* Loads that have a unit beside some that have none: fails. */
static bool check_units_of_all(struct scene_source *source, const struct scene_load *load)
{
    return load->kind_line == 0 || load->plain_line == 0 ||
           scene_source_fail(source, load->plain_line,
                             "a load has no unit, but one in line %zu has; give all of them theirs", load->kind_line);
}

/* Is what the key gives, if anything, a unit of one of `quantities`? */
static bool check_unit(struct scene_source *source, const struct scene_key *key, unsigned quantities)
{
    struct unit unit;
    const char *text = key->field;
    return key->line == 0 || (unit_read(&unit, text, strlen(text)) && unit_of(&unit, quantities)) ||
           scene_source_fail(source, key->line, "'%s' is '%s'; understood: %s", key->name, scene_words_show(text).text,
                             unit_known(quantities).text);
}

/* Puts plain loads into `unit:`. Pascals leave the charts over P/(A_n E'), another unit of force or pressure does not.
 */
static bool apply_load_unit(struct scene_source *source, struct scene_load *load, const char *text,
                            const struct scene_key *key)
{
    struct unit unit = {.factor = 1};
    if (key->line > 0)
        (void)unit_read(&unit, text, strlen(text)); /* check_unit() has */
    enum unit_quantity kind = key->line > 0 ? (enum unit_quantity)unit_of(&unit, UNIT_LOADS) : UNIT_NUMBER;
    if (load->kind_line > 0 && kind != load->kind && (key->line > 0 || load->plain_line > 0))
        return scene_source_fail(source, key->line > 0 ? key->line : load->plain_line,
                                 "a load is %s, but %s stands in line %zu; give one kind", unit_quantity_name(kind),
                                 unit_quantity_name(load->kind), load->kind_line);
    if (load->kind_line > 0 || key->line == 0)
        return check_units_of_all(source, load);
    load->kind = kind;
    load->kind_line = key->line;
    load->unit = unit;
    if (kind != UNIT_NUMBER && strcmp(text, "Pa") != 0)
        strcpy(load->unit_text, text);
    load->from *= unit.factor;
    load->to *= unit.factor;
    for (size_t i = 0; load->values && i < load->points; i++)
        load->values[i] *= unit.factor;
    return true;
}

static bool read_load(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct scene_load *load = key->field;
    char unit[UNIT_LENGTH] = "";
    struct scene_key keys[] = {
        {"from", read_load_number, .field = &load->from, .least = LOAD_LEAST, .most = LOAD_MOST,
         .quantities = UNIT_LOADS},
        {"to", read_load_number, .field = &load->to, .least = LOAD_LEAST, .most = LOAD_MOST, .quantities = UNIT_LOADS},
        {"points", SCENE_WHOLE(load->points, 1, LOAD_POINTS_MOST)},
        {"values", read_load_values, .field = load, .least = LOAD_LEAST, .most = LOAD_MOST, .quantities = UNIT_LOADS},
        {"unit", SCENE_SHORT_TEXT(unit)},
    };
    if (!scene_source_mapping(source, value, key->name, keys, SCENE_COUNT(keys)) ||
        !check_unit(source, &keys[4], UNIT_LOADS))
        return false;
    if (load->values)
        for (size_t k = 0; k < 3; k++)
            if (keys[k].line)
                return scene_source_fail(source, keys[k].line, "'%s' stands beside 'values'; remove one of them",
                                         keys[k].name);
    size_t from = scene_source_line_of(keys, "from"), to = scene_source_line_of(keys, "to");
    const struct scene_key *unit_key = &keys[4];
    if (!load->values && !(from && to) &&
        (load->kind_line > 0 || (unit_key->line > 0 && strcmp(unit, "dimensionless") != 0)))
        return scene_source_fail(source, unit_key->line > 0 ? unit_key->line : load->kind_line,
                                 unit_key->line > 0 ? "'unit: %s' leaves the default loads without meaning; "
                                                      "add 'from' and 'to', or 'values'"
                                                    : "a load in %s leaves the default of the other without meaning; "
                                                      "add 'from' and 'to', or 'values'",
                                 unit_key->line > 0 ? unit : load->unit_text);
    if (!apply_load_unit(source, load, unit, unit_key) || load->values)
        return source->status->code == STATUS_OK;
    if (load->from > load->to)
        return scene_source_fail(source, to ? to : from, "'from' is %g, above 'to', %g; exchange them", load->from,
                                 load->to);
    if (load->points == 1 && load->from < load->to)
        return scene_source_fail(source, scene_source_line_of(keys, "points"),
                                 "'points' is 1, too few from %g to %g; give 2 or more, or 'values'", load->from,
                                 load->to);
    return true;
}

static bool read_mean_free_path(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    enum scene_mean_free_path *kind = &source->scene->mean_free_path;
    struct scene_quantity quantity;
    if (scene_source_is(value, "thesis"))
        return true;
    *kind = scene_source_is(value, "electron") ? SCENE_MEAN_FREE_PATH_ELECTRON : SCENE_MEAN_FREE_PATH_GIVEN;
    if (*kind == SCENE_MEAN_FREE_PATH_ELECTRON)
        return true;
    if (value->type == YAML_SCALAR_NODE && isalpha(*value->data.scalar.value)) {
        static const char *const words[] = {"thesis", "electron"};
        return scene_source_unknown(source, value, key->name, words, SCENE_COUNT(words), SCENE_COUNT(words));
    }
    if (!scene_source_quantity_of(&quantity, source, key, value))
        return false;
    source->mean_free_path_m = quantity.value;
    return true;
}

static bool read_one_load(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct scene_one_load *load = key->field;
    struct scene_quantity quantity;
    if (!scene_source_quantity_of(&quantity, source, key, value))
        return false;
    *load = (struct scene_one_load){quantity.value, quantity.kind};
    return true;
}

static bool read_convergence(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct scene_convergence *convergence = key->field;
    struct scene_key keys[] = {
        {"alpha", SCENE_NUMBER(convergence->alpha, 1e-12, 1e12)},
        {"gamma", SCENE_NUMBER(convergence->gamma, 0.0, 5.0)},
        {"load", SCENE_NUMBER(convergence->load, LOAD_LEAST, LOAD_MOST)},
        {"scan_length", SCENE_QUANTITY(convergence->scan_length_m, UNIT_DISTANCE, 1e-9, 1e3), .alias = "scan_length_m"},
        {"scales", SCENE_WHOLE(convergence->scales, 1, 1e6)},
    };
    return scene_source_mapping(source, value, key->name, keys, SCENE_COUNT(keys));
}

static bool read_measured_file(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct scene_surface one = {0};
    char **file = key->field;
    bool good = scene_surfaces_files(source, &(struct scene_key){.name = key->name, .field = &one}, value);
    if (good && one.file_count != 1)
        good = scene_source_fail_at(source, value, "'%s' names %zu files; name one", key->name, one.file_count);
    if (good && !(*file = strdup(one.files[0])))
        good = scene_source_memory(source);
    scene_files_free(&one, NULL);
    return good;
}

static bool read_measured(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct scene_measured *measured = key->field;
    struct scene_key keys[] = {
        {"file", read_measured_file, .field = &measured->file},
        {"quantity", SCENE_CHOICE(measured->quantity, measured_quantity_names)},
        {"load_unit", SCENE_SHORT_TEXT(measured->load_unit)},
        {"resistance_unit", SCENE_SHORT_TEXT(measured->resistance_unit)},
    };
    if (!scene_source_mapping(source, value, key->name, keys, SCENE_COUNT(keys)))
        return false;
    if (!measured->file)
        return scene_source_fail_at(source, value, "'measured' has no 'file'; name a CSV of load and resistance");
    return check_unit(source, &keys[2], UNIT_LOADS) &&
           check_unit(source, &keys[3], scene_measured_resistances[measured->quantity]);
}

/* How many, or which. */
static bool read_direct_loads(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct scene_direct *direct = key->field;
    if (value->type != YAML_SEQUENCE_NODE)
        return scene_source_whole(
            source, &(struct scene_key){key->name, SCENE_WHOLE(direct->loads, 2, SCENE_DIRECT_LOADS)}, value);
    const struct scene_key number = {key->name, .least = LOAD_LEAST, .most = LOAD_MOST, .quantities = UNIT_LOADS};
    struct scene_load load = {.kind = UNIT_NUMBER};
    bool good = read_load_list(source, &number, &load, SCENE_DIRECT_LOADS, value) && check_units_of_all(source, &load);
    direct->values = load.values;
    direct->loads = load.points;
    direct->kind = load.kind;
    direct->kind_line = load.kind_line;
    for (size_t i = 1; i < load.points && good; i++)
        if (!(direct->values[i] > direct->values[i - 1]))
            return scene_source_fail_at(source, value, "'loads' do not rise; order them, each once");
    return good;
}

static bool read_direct(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    static const char *const surfaces[SCENE_DIRECT_SURFACES_COUNT] = {"baseline", "all"};
    struct scene_direct *direct = key->field;
    if (scene_source_is(value, "off"))
        return true;
    struct scene_key keys[] = {
        {"grid", SCENE_WHOLE(direct->grid, SCENE_DIRECT_GRID_LEAST, SCENE_DIRECT_GRID_MOST)},
        {"seeds", SCENE_WHOLE(direct->seeds, 1, SCENE_DIRECT_SEEDS)},
        {"loads", read_direct_loads, .field = direct},
        {"hardness", SCENE_QUANTITY(direct->hardness_Pa, UNIT_PRESSURE, 1e3, 1e12), .word = "auto"},
        {"budget", SCENE_QUANTITY(direct->budget_s, UNIT_TIME, 1e-3, 1e7)},
        {"surfaces", SCENE_CHOICE(direct->surfaces, surfaces)},
    };
    direct->called = true;
    if (!scene_source_mapping(source, value, key->name, keys, SCENE_COUNT(keys)))
        return false;
    if (direct->grid % 2 != 0)
        return scene_source_fail(source, scene_source_line_of(keys, "grid"), "'grid' is %zu; give an even number",
                                 direct->grid);
    size_t points = direct->grid * direct->grid * direct->seeds;
    return points <= limit_most(LIMIT_DIRECT_POINTS) ||
           scene_source_fail_at(source, value, "%zu x %zu points, %zu times%s", direct->grid, direct->grid,
                                direct->seeds, limit_words(LIMIT_DIRECT_POINTS).text);
}

/* What fills the gaps between the spots, into a struct joint. */
static bool read_gap(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct joint *joint = key->field;
    const char *names[SCENE_KEYS_MOST]; /* those of the table, then none */
    unsigned gas = 0;
    assert(gas_count < SCENE_KEYS_MOST);
    for (size_t i = 0; i < gas_count; i++)
        names[i] = gas_table[i].name;
    names[gas_count] = "vacuum";
    struct scene_key keys[] = {
        {"gas", scene_source_choice, .field = &gas, .choices = names, .choice_count = gas_count + 1},
        {"pressure", SCENE_QUANTITY(joint->pressure_Pa, UNIT_PRESSURE, 0.0, 1e9)},
        {"accommodation", SCENE_NUMBER(joint->accommodation, 1e-3, 1.0)},
        {"temperature", SCENE_QUANTITY(joint->temperature_K, UNIT_TEMPERATURE, 1.0, 1e4)},
        {"conductivity", SCENE_QUANTITY(joint->conductivity_W_per_mK, UNIT_CONDUCTIVITY, 1e-6, 1e4)},
    };
    if (!scene_source_mapping(source, value, key->name, keys, SCENE_COUNT(keys)))
        return false;
    bool medium = scene_source_line_of(keys, "conductivity") > 0;
    for (size_t k = 0; k < 3 && medium; k++)
        if (keys[k].line > 0)
            return scene_source_fail(source, keys[k].line,
                                     "'%s' stands beside 'conductivity', which is of what fills the gaps; remove one",
                                     keys[k].name);
    joint->gas = gas < gas_count ? &gas_table[gas] : NULL;
    joint->fill = medium ? JOINT_MEDIUM : joint->gas ? JOINT_GAS : JOINT_VACUUM;
    return true;
}

static bool read_plating(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    static const char *const sides[] = {"one", "both"};
    struct joint *joint = key->field;
    unsigned both = joint->both_plated;
    struct scene_key keys[] = {
        {"thickness", SCENE_QUANTITY(joint->plating_thickness_m, UNIT_DISTANCE, 1e-12, 1.0)},
        {"resistivity", SCENE_QUANTITY(joint->plating_ohm_m, UNIT_RESISTIVITY, 1e-12, 1e10)},
        {"sides", SCENE_CHOICE(both, sides)},
    };
    if (!scene_source_mapping(source, value, key->name, keys, SCENE_COUNT(keys)))
        return false;
    for (size_t k = 0; k < 2; k++)
        if (keys[k].line == 0)
            return scene_source_fail_at(source, value, "'%s' has no '%s'; add it", key->name, keys[k].name);
    joint->both_plated = both;
    return true;
}

bool scene_keys_read(struct scene_source *source, const yaml_node_t *root)
{
    struct scene *scene = source->scene;
    struct scene_key keys[] = {
        {"title", scene_source_text, .field = &scene->title},
        {"models", read_models, .field = &scene->models},
        {"effects", read_effects, .field = scene},
        {"material", scene_surfaces_body, .field = &scene->bodies},
        {"counterface", scene_surfaces_counterface, .field = &scene->bodies},
        {"direction", SCENE_CHOICE(scene->direction, scan_direction_names)},
        {"lay", SCENE_NUMBER(scene->lay, 0.0, 1.0)},
        {"measured", read_measured, .field = &scene->measured},
        {"nominal_area", SCENE_QUANTITY(scene->nominal_area_m2, UNIT_AREA, 1e-18, 1e6), .word = "none",
         .alias = "nominal_area_m2"},
        {"hardness", SCENE_QUANTITY(scene->bodies.hardness_Pa, UNIT_PRESSURE, 1e3, 1e12), .alias = "hardness_Pa",
         .at = &source->hardness_line},
        {"mean_free_path", read_mean_free_path, .at = &source->mean_free_path_line, .least = 1e-12, .most = 1e-3,
         .quantities = UNIT_DISTANCE},
        {"load", read_load, .field = &scene->load},
        {"operating_load", read_one_load, .field = &scene->operating, .least = LOAD_LEAST, .most = LOAD_MOST,
         .quantities = UNIT_LOADS, .at = &source->operating_line},
        {"unload_from", read_one_load, .field = &scene->unload_from, .least = LOAD_LEAST, .most = LOAD_MOST,
         .quantities = UNIT_LOADS},
        {"targets", scene_asked_targets, .field = scene},
        {"limits", scene_asked_limits, .field = scene},
        {"tolerance", SCENE_NUMBER(scene->tolerance, SCENE_KEYS_TOLERANCE_LEAST, SCENE_KEYS_TOLERANCE_MOST)},
        {"level", SCENE_CHOICE(scene->level, level_names)},
        {"window", SCENE_CHOICE(scene->window, spectrum_window_names)},
        {"fit", SCENE_CHOICE(scene->fit, power_law_method_names)},
        {"fit_band", read_fit_band, scene->fit_band_m, 1e-12, 1e3, .word = "all", .quantities = UNIT_DISTANCE,
         .alias = "fit_band_m"},
        {"moments", SCENE_CHOICE(scene->moments, roughness_moments_names)},
        {"closure", SCENE_CHOICE(scene->closure, closure_names)},
        {"data", SCENE_CHOICE(scene->data, scene_data_names)},
        {"export", read_export, .field = scene},
        {"max_missing", SCENE_QUANTITY(scene->max_missing, UNIT_NUMBER | UNIT_PERCENT, 0.0, 0.9)},
        {"lambda_s", SCENE_QUANTITY(scene->lambda_s_m, UNIT_DISTANCE, 1e-12, 1e3), .word = "none",
         .alias = "lambda_s_m"},
        {"lambda_c", SCENE_QUANTITY(scene->lambda_c_m, UNIT_DISTANCE, 1e-12, 1e3), .word = "none",
         .alias = "lambda_c_m"},
        {"tip_radius", SCENE_QUANTITY(scene->tip_radius_m, UNIT_DISTANCE, 1e-12, 1.0), .word = "none",
         .alias = "tip_radius_m"},
        {"baseline", scene_source_text, .field = &scene->baseline, .at = &source->baseline_line},
        {"direct", read_direct, .field = &scene->direct},
        {"gap", read_gap, .field = &scene->joint},
        {"film", SCENE_QUANTITY(scene->joint.film_ohm_m2, UNIT_RESISTANCE_AREA, 0.0, 1e6)},
        {"plating", read_plating, .field = &scene->joint},
        {"current", SCENE_QUANTITY(scene->joint.current_A, UNIT_CURRENT, 1e-12, 1e9)},
        {"convergence", read_convergence, .field = &scene->convergence},
        {"surfaces", scene_surfaces_read, .field = scene},
    };
    if (!scene_source_mapping(source, root, "scene", keys, SCENE_COUNT(keys)))
        return false;
    if (scene->direct.called)
        scene->effects |= EFFECT_BIT(EFFECT_DIRECT);
    for (int i = 0; i < EFFECT_COUNT; i++)
        source->call_line[i] = effect_rows[i].key ? scene_source_line_of(keys, effect_rows[i].key) : 0;
    if (scene->lambda_s_m > 0 && scene->lambda_c_m > 0 && !(scene->lambda_s_m < scene->lambda_c_m))
        return scene_source_fail(source, scene_source_line_of(keys, "lambda_c"),
                                 "'lambda_c' is %g m, not above 'lambda_s', %g m; nothing would be left between them",
                                 scene->lambda_c_m, scene->lambda_s_m);
    scene->lay_given = scene_source_line_of(keys, "lay") > 0;
    scene->level_given = scene_source_line_of(keys, "level") > 0;
    bool band = scene_source_line_of(keys, "fit_band") > 0;
    scene->fit_band_given = band && (scene->fit_band_m[0] > 0 || isfinite(scene->fit_band_m[1]));
    if (!band) { /* what the filters leave */
        scene->fit_band_m[0] = scene->lambda_s_m;
        if (scene->lambda_c_m > 0)
            scene->fit_band_m[1] = scene->lambda_c_m;
    }
    return true;
}
