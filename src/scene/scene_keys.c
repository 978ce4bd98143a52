#include "scene/scene_keys.h"
#include "scene/scene_surfaces.h"
#include "scene/scene_words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const closure_names[SINUSOID_FIT_COUNT] = {"thesis", "numeric"};
static const char *const load_unit_names[] = {"dimensionless", "Pa"};
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

unsigned scene_keys_with_needed(unsigned effects)
{
    for (int i = 0; i < EFFECT_COUNT; i++)
        if (effects & EFFECT_BIT(i))
            effects |= effect_rows[i].needs_effects;
    return effects;
}

enum { MODEL_NAMES = 128 }; /* a family and a name for each of at most 64 models */

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
                return scene_source_unknown(source, item, what, names, count);
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
    return *models || scene_source_fail(source, scene_source_line(value),
                                        "'models' names none; remove the line for the default ones");
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
    scene->effects = scene_keys_with_needed(scene->effects);
    for (int i = 0; i < EFFECT_COUNT; i++)
        for (int needed = 0; needed < EFFECT_COUNT; needed++)
            if ((effect_rows[i].needs_effects & EFFECT_BIT(needed)) && source->effect_line[needed] == 0)
                source->effect_line[needed] = source->effect_line[i];
    return true;
}

/* The items of a list, or one number, into the doubles at key->field. */
static bool read_numbers(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct scene_key number = *key;
    double *numbers = key->field;
    for (size_t i = 0; i < scene_source_item_count(value); i++) {
        number.field = &numbers[i];
        if (!scene_source_number(source, &number, scene_source_item(source, value, i)))
            return false;
    }
    return true;
}

static bool read_fit_band(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    const double *band = key->field;
    if (scene_source_is(value, key->word))
        return true;
    if (value->type != YAML_SEQUENCE_NODE || scene_source_item_count(value) != 2)
        return scene_source_wrong_type(source, value, key->name, "two wavelengths [shortest, longest] in m");
    return read_numbers(source, key, value) &&
           (band[0] < band[1] ||
            scene_source_fail(source, scene_source_line(value), "'%s' is [%g, %g]; give the shorter wavelength first",
                              key->name, band[0], band[1]));
}

static bool read_load_values(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct scene_load *load = key->field;
    size_t count = scene_source_item_count(value);
    if (count == 0 || count > LOAD_POINTS_MOST)
        return scene_source_fail(source, scene_source_line(value), "'values' holds %zu loads; allowed is 1 to %d",
                                 count, LOAD_POINTS_MOST);
    load->values = malloc(count * sizeof *load->values);
    if (!load->values)
        return scene_source_memory(source);
    load->points = count;
    return read_numbers(
        source, &(struct scene_key){key->name, .field = load->values, .least = LOAD_LEAST, .most = LOAD_MOST}, value);
}

static bool read_load(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct scene_load *load = key->field;
    unsigned unit = 0;
    struct scene_key keys[] = {
        {"from", SCENE_NUMBER(load->from, LOAD_LEAST, LOAD_MOST)},
        {"to", SCENE_NUMBER(load->to, LOAD_LEAST, LOAD_MOST)},
        {"points", SCENE_WHOLE(load->points, 1, LOAD_POINTS_MOST)},
        {"values", read_load_values, .field = load},
        {"unit", SCENE_CHOICE(unit, load_unit_names)},
    };
    if (!scene_source_mapping(source, value, key->name, keys, SCENE_COUNT(keys)))
        return false;
    load->in_pascal = unit == 1;
    if (load->values) {
        for (size_t k = 0; k < 3; k++)
            if (keys[k].line)
                return scene_source_fail(source, keys[k].line, "'%s' stands beside 'values'; remove one of them",
                                         keys[k].name);
        return true;
    }
    size_t from = scene_source_line_of(keys, "from"), to = scene_source_line_of(keys, "to");
    if (load->in_pascal && !(from && to))
        return scene_source_fail(source, scene_source_line_of(keys, "unit"),
                                 "'unit: Pa' leaves the default loads without meaning; "
                                 "add 'from' and 'to', or 'values'");
    if (load->from > load->to)
        return scene_source_fail(source, to ? to : from, "'from' is %g, above 'to', %g; exchange them", load->from,
                                 load->to);
    if (load->points == 1 && load->from < load->to)
        return scene_source_fail(source, scene_source_line_of(keys, "points"),
                                 "'points' is 1, too few from %g to %g; give 2 or more, or 'values'", load->from,
                                 load->to);
    return true;
}

static bool read_convergence(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct scene_convergence *convergence = key->field;
    struct scene_key keys[] = {
        {"alpha", SCENE_NUMBER(convergence->alpha, 1e-12, 1e12)},
        {"gamma", SCENE_NUMBER(convergence->gamma, 0.0, 5.0)},
        {"load", SCENE_NUMBER(convergence->load, LOAD_LEAST, LOAD_MOST)},
        {"scan_length_m", SCENE_NUMBER(convergence->scan_length_m, 1e-9, 1e3)},
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
        good = scene_source_fail(source, scene_source_line(value), "'%s' names %zu files; name one", key->name,
                                 one.file_count);
    if (good && !(*file = strdup(one.files[0])))
        good = scene_source_memory(source);
    scene_surfaces_free(&one);
    return good;
}

/* Is what the key gives, if anything, a unit of one of `quantities`? */
static bool check_unit(struct scene_source *source, const struct scene_key *key, unsigned quantities)
{
    struct unit unit;
    const char *text = key->field;
    return key->line == 0 || (unit_read(&unit, text, strlen(text)) && unit_of(&unit, quantities)) ||
           scene_source_fail(source, key->line, "'%s' is '%s'; understood: %s", key->name,
                             scene_words_show(text, strlen(text)).text, unit_known(quantities).text);
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
        return scene_source_fail(source, scene_source_line(value),
                                 "'measured' has no 'file'; name a CSV of load and resistance");
    return check_unit(source, &keys[2], SCENE_MEASURED_LOADS) &&
           check_unit(source, &keys[3], scene_measured_resistances[measured->quantity]);
}

static bool read_baseline(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    source->baseline_line = scene_source_line(value);
    return scene_source_text(source, key, value);
}

bool scene_keys_read(struct scene_source *source, const yaml_node_t *root)
{
    struct scene *scene = source->scene;
    struct scene_key keys[] = {
        {"title", scene_source_text, .field = &scene->title},
        {"models", read_models, .field = &scene->models},
        {"effects", read_effects, .field = NULL},
        {"material", scene_surfaces_material, .field = &scene->material},
        {"counterface", scene_surfaces_counterface, .field = NULL},
        {"direction", SCENE_CHOICE(scene->direction, scan_direction_names)},
        {"measured", read_measured, .field = &scene->measured},
        {"nominal_area_m2", SCENE_NUMBER(scene->nominal_area_m2, 1e-18, 1e6), .word = "none"},
        {"hardness", SCENE_NUMBER(scene->hardness_Pa, 1e3, 1e12)},
        {"load", read_load, .field = &scene->load},
        {"tolerance", SCENE_NUMBER(scene->tolerance, SCENE_KEYS_TOLERANCE_LEAST, SCENE_KEYS_TOLERANCE_MOST)},
        {"level", SCENE_CHOICE(scene->level, level_names)},
        {"window", SCENE_CHOICE(scene->window, spectrum_window_names)},
        {"fit", SCENE_CHOICE(scene->fit, power_law_method_names)},
        {"fit_band_m", read_fit_band, scene->fit_band_m, 1e-12, 1e3, .word = "all"},
        {"moments", SCENE_CHOICE(scene->moments, roughness_moments_names)},
        {"closure", SCENE_CHOICE(scene->closure, closure_names)},
        {"max_missing", SCENE_NUMBER(scene->max_missing, 0.0, 0.9)},
        {"lambda_s_m", SCENE_NUMBER(scene->lambda_s_m, 1e-12, 1e3), .word = "none"},
        {"lambda_c_m", SCENE_NUMBER(scene->lambda_c_m, 1e-12, 1e3), .word = "none"},
        {"tip_radius_m", SCENE_NUMBER(scene->tip_radius_m, 1e-12, 1.0), .word = "none"},
        {"baseline", read_baseline, .field = &scene->baseline},
        {"convergence", read_convergence, .field = &scene->convergence},
        {"surfaces", scene_surfaces_read, .field = NULL},
    };
    if (!scene_source_mapping(source, root, "scene", keys, SCENE_COUNT(keys)))
        return false;
    if (scene->lambda_s_m > 0 && scene->lambda_c_m > 0 && !(scene->lambda_s_m < scene->lambda_c_m))
        return scene_source_fail(source, scene_source_line_of(keys, "lambda_c_m"),
                                 "'lambda_c_m' is %g, not above 'lambda_s_m', %g; nothing would be left between them",
                                 scene->lambda_c_m, scene->lambda_s_m);
    scene->level_given = scene_source_line_of(keys, "level") > 0;
    bool band = scene_source_line_of(keys, "fit_band_m") > 0;
    scene->fit_band_given = band && (scene->fit_band_m[0] > 0 || isfinite(scene->fit_band_m[1]));
    if (!band) { /* what the filters leave */
        scene->fit_band_m[0] = scene->lambda_s_m;
        if (scene->lambda_c_m > 0)
            scene->fit_band_m[1] = scene->lambda_c_m;
    }
    return true;
}
