#include "scene/scene_keys.h"
#include "scene/scene_material.h"
#include "scene/scene_pair.h"
#include "scene/scene_surfaces.h"
#include "scene/scene_value.h"
#include "scene/scene_words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof *(array))

static const char *const closure_names[SINUSOID_FIT_COUNT] = {"thesis", "numeric"};
static const char *const load_unit_names[] = {"dimensionless", "Pa"};

/* Loads, in Pa or P/(A_n E'): any that keeps its distance from the ends of double. */
#define LOAD_LEAST       1e-100
#define LOAD_MOST        1e100
#define LOAD_POINTS_MOST 100000

/* Parts of a key's row; offset 0 stands for the whole struct. */
#define RANGE(type, member, low, high)  .offset = offsetof(type, member), .least = (low), .most = (high)
#define NUMBER(type, member, low, high) scene_value_number, RANGE(type, member, low, high)
#define WHOLE(type, member, low, high)  scene_value_count, RANGE(type, member, low, high)
#define CHOICES(type, member, spellings)                                                                               \
    .offset = offsetof(type, member), .choices = (spellings), .choice_count = COUNT(spellings)

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

/* One or more words out of `names`, as a list or as one text: a bit for each in `bits`, its line in `lines`. */
static enum status_code read_set(struct scene_source *source, const struct scene_key *key, const char *what,
                                 const yaml_node_t *value, const char *const *names, size_t count, uint64_t bits[2],
                                 size_t *lines)
{
    bits[0] = bits[1] = 0;
    for (size_t i = 0; i < scene_source_item_count(value); i++) {
        const yaml_node_t *item = scene_source_item(source, value, i);
        if (item->type != YAML_SCALAR_NODE)
            return scene_source_wrong_type(source, item, key->name, "a list of names");
        const char *rest = (const char *)item->data.scalar.value, *word;
        for (size_t length; (word = scene_words_next(&rest, &length));) {
            size_t n = scene_words_find(word, length, names, count);
            if (n == count)
                return scene_source_unknown(source, item, what, names, count);
            bits[n / 64] |= UINT64_C(1) << (n % 64);
            lines[n] = scene_source_line(item);
        }
    }
    return STATUS_OK;
}

/* Families, each once, then single models: what `models` may name. */
static size_t model_names(const char *names[MODEL_NAMES])
{
    size_t count = 0;
    for (size_t m = 0; m < model_count; m++) {
        const char *family = model_rows[m]->family;
        if (scene_words_find(family, strlen(family), names, count) == count)
            names[count++] = family;
    }
    for (size_t m = 0; m < model_count; m++)
        if (scene_words_find(model_rows[m]->name, strlen(model_rows[m]->name), names, count) == count)
            names[count++] = model_rows[m]->name;
    return count;
}

static enum status_code read_models(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                    void *field)
{
    struct scene *scene = field;
    const char *names[MODEL_NAMES] = {0};
    size_t lines[MODEL_NAMES], count = model_names(names);
    uint64_t named[2];
    enum status_code code = read_set(source, key, "model", value, names, count, named, lines);
    if (code != STATUS_OK)
        return code;
    scene->models = 0;
    for (size_t i = 0; i < count; i++)
        if (named[i / 64] >> (i % 64) & 1)
            scene->models |= model_find(names[i]);
    if (scene->models == 0)
        return scene_source_fail(source, scene_source_line(value),
                                 "'models' names none; remove the line for the default ones");
    return STATUS_OK;
}

static enum status_code read_effects(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                     void *field)
{
    struct scene *scene = field;
    if (scene_source_is(value, "auto"))
        return STATUS_OK;
    const char *names[EFFECT_COUNT];
    scene_keys_effect_names(names);
    scene->effects_auto = false;
    uint64_t named[2];
    enum status_code code = read_set(source, key, "effect", value, names, EFFECT_COUNT, named, source->effect_line);
    scene->effects = scene_keys_with_needed((unsigned)named[0]);
    for (int i = 0; i < EFFECT_COUNT; i++)
        for (int needed = 0; needed < EFFECT_COUNT; needed++)
            if ((effect_rows[i].needs_effects & EFFECT_BIT(needed)) && source->effect_line[needed] == 0)
                source->effect_line[needed] = source->effect_line[i];
    return code;
}

static enum status_code read_fit_band(struct scene_source *source, const struct scene_key *key,
                                      const yaml_node_t *value, void *field)
{
    double *band = field;
    if (scene_source_is(value, key->word))
        return STATUS_OK;
    if (value->type != YAML_SEQUENCE_NODE || scene_source_item_count(value) != 2)
        return scene_source_wrong_type(source, value, key->name, "two wavelengths [shortest, longest] in m");
    for (size_t i = 0; i < 2; i++) {
        enum status_code code = scene_value_number(source, key, scene_source_item(source, value, i), &band[i]);
        if (code != STATUS_OK)
            return code;
    }
    if (!(band[0] < band[1]))
        return scene_source_fail(source, scene_source_line(value),
                                 "'%s' is [%g, %g]; give the shorter wavelength first", key->name, band[0], band[1]);
    return STATUS_OK;
}

static enum status_code read_load_values(struct scene_source *source, const struct scene_key *key,
                                         const yaml_node_t *value, void *field)
{
    struct scene_load *load = field;
    size_t count = scene_source_item_count(value);
    if (count == 0 || count > LOAD_POINTS_MOST)
        return scene_source_fail(source, scene_source_line(value), "'values' holds %zu loads; allowed is 1 to %d",
                                 count, LOAD_POINTS_MOST);
    load->values = malloc(count * sizeof *load->values);
    if (!load->values)
        return status_memory(source->status);
    load->points = count;
    struct scene_key number = {.name = key->name, .least = LOAD_LEAST, .most = LOAD_MOST};
    enum status_code code = STATUS_OK;
    for (size_t i = 0; code == STATUS_OK && i < count; i++)
        code = scene_value_number(source, &number, scene_source_item(source, value, i), &load->values[i]);
    return code;
}

static enum status_code read_load_unit(struct scene_source *source, const struct scene_key *key,
                                       const yaml_node_t *value, void *field)
{
    unsigned unit = 0;
    enum status_code code = scene_value_choice(source, key, value, &unit);
    *(bool *)field = unit == 1;
    return code;
}

enum { LOAD_FROM, LOAD_TO, LOAD_POINTS, LOAD_VALUES, LOAD_UNIT };

static enum status_code read_load(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                  void *field)
{
    static const struct scene_key keys[] = {
        [LOAD_FROM] = {"from", NUMBER(struct scene_load, from, LOAD_LEAST, LOAD_MOST)},
        [LOAD_TO] = {"to", NUMBER(struct scene_load, to, LOAD_LEAST, LOAD_MOST)},
        [LOAD_POINTS] = {"points", WHOLE(struct scene_load, points, 1, LOAD_POINTS_MOST)},
        [LOAD_VALUES] = {"values", read_load_values, .offset = 0},
        [LOAD_UNIT] = {"unit", read_load_unit, CHOICES(struct scene_load, in_pascal, load_unit_names)},
    };
    struct scene_load *load = field;
    size_t lines[COUNT(keys)];
    enum status_code code = scene_source_mapping(source, value, key->name, keys, COUNT(keys), load, lines);
    if (code != STATUS_OK)
        return code;
    if (lines[LOAD_VALUES]) {
        for (int k = LOAD_FROM; k <= LOAD_POINTS; k++)
            if (lines[k])
                return scene_source_fail(source, lines[k], "'%s' stands beside 'values'; remove one of them",
                                         keys[k].name);
        return STATUS_OK;
    }
    if (load->in_pascal && !(lines[LOAD_FROM] && lines[LOAD_TO]))
        return scene_source_fail(source, lines[LOAD_UNIT],
                                 "'unit: Pa' leaves the default loads without meaning; "
                                 "add 'from' and 'to', or 'values'");
    size_t line = lines[LOAD_TO] ? lines[LOAD_TO] : lines[LOAD_FROM];
    if (load->from > load->to)
        return scene_source_fail(source, line, "'from' is %g, above 'to', %g; exchange them", load->from, load->to);
    if (load->points == 1 && load->from < load->to)
        return scene_source_fail(source, lines[LOAD_POINTS],
                                 "'points' is 1, too few from %g to %g; give 2 or more, or 'values'", load->from,
                                 load->to);
    return STATUS_OK;
}

static enum status_code read_convergence(struct scene_source *source, const struct scene_key *key,
                                         const yaml_node_t *value, void *field)
{
    static const struct scene_key keys[] = {
        {"alpha", NUMBER(struct scene_convergence, alpha, 1e-12, 1e12)},
        {"gamma", NUMBER(struct scene_convergence, gamma, 0.0, 5.0)},
        {"load", NUMBER(struct scene_convergence, load, LOAD_LEAST, LOAD_MOST)},
        {"scan_length_m", NUMBER(struct scene_convergence, scan_length_m, 1e-9, 1e3)},
        {"scales", WHOLE(struct scene_convergence, scales, 1, 1e6)},
    };
    size_t lines[COUNT(keys)];
    return scene_source_mapping(source, value, key->name, keys, COUNT(keys), field, lines);
}

static enum status_code read_baseline(struct scene_source *source, const struct scene_key *key,
                                      const yaml_node_t *value, void *field)
{
    source->baseline_line = scene_source_line(value);
    return scene_value_text(source, key, value, field);
}

static const struct scene_key scene_keys[] = {
    {"title", scene_value_text, .offset = offsetof(struct scene, title)},
    {"models", read_models, .offset = 0},
    {"effects", read_effects, .offset = 0},
    {"material", scene_material_read, .offset = offsetof(struct scene, material)},
    {"counterface", scene_pair_counterface, .offset = 0},
    {"direction", scene_value_choice, CHOICES(struct scene, direction, scan_direction_names)},
    {"measured", scene_pair_measured, .offset = offsetof(struct scene, measured)},
    {"nominal_area_m2", NUMBER(struct scene, nominal_area_m2, 1e-18, 1e6), .word = "none"},
    {"hardness", NUMBER(struct scene, hardness_Pa, 1e3, 1e12)},
    {"load", read_load, .offset = offsetof(struct scene, load)},
    {"tolerance", NUMBER(struct scene, tolerance, SCENE_KEYS_TOLERANCE_LEAST, SCENE_KEYS_TOLERANCE_MOST)},
    {"level", scene_value_choice, CHOICES(struct scene, level, level_names)},
    {"window", scene_value_choice, CHOICES(struct scene, window, spectrum_window_names)},
    {"fit", scene_value_choice, CHOICES(struct scene, fit, power_law_method_names)},
    {"fit_band_m", read_fit_band, RANGE(struct scene, fit_band_m, 1e-12, 1e3), .word = "all"},
    {"moments", scene_value_choice, CHOICES(struct scene, moments, roughness_moments_names)},
    {"closure", scene_value_choice, CHOICES(struct scene, closure, closure_names)},
    {"max_missing", NUMBER(struct scene, max_missing, 0.0, 0.9)},
    {"lambda_s_m", NUMBER(struct scene, lambda_s_m, 1e-12, 1e3), .word = "none"},
    {"lambda_c_m", NUMBER(struct scene, lambda_c_m, 1e-12, 1e3), .word = "none"},
    {"tip_radius_m", NUMBER(struct scene, tip_radius_m, 1e-12, 1.0), .word = "none"},
    {"baseline", read_baseline, .offset = offsetof(struct scene, baseline)},
    {"convergence", read_convergence, .offset = offsetof(struct scene, convergence)},
    {"surfaces", scene_surfaces_read, .offset = 0},
};

/* The line of a key of scene_keys, 0 where it is not given. */
static size_t line_of(const size_t *lines, const char *name)
{
    size_t k = 0;
    while (strcmp(scene_keys[k].name, name) != 0)
        k++;
    return lines[k];
}

/* The two cut-offs of the filters against one another; a fit that no line asks for keeps to what they leave. */
static enum status_code join_filters(struct scene *scene, struct scene_source *source, const size_t *lines)
{
    if (scene->lambda_s_m > 0 && scene->lambda_c_m > 0 && !(scene->lambda_s_m < scene->lambda_c_m))
        return scene_source_fail(source, line_of(lines, "lambda_c_m"),
                                 "'lambda_c_m' is %g, not above 'lambda_s_m', %g; nothing would be left between them",
                                 scene->lambda_c_m, scene->lambda_s_m);
    scene->level_given = line_of(lines, "level") > 0;
    scene->fit_band_given =
        line_of(lines, "fit_band_m") > 0 && (scene->fit_band_m[0] > 0 || isfinite(scene->fit_band_m[1]));
    if (line_of(lines, "fit_band_m"))
        return STATUS_OK;
    scene->fit_band_m[0] = scene->lambda_s_m;
    if (scene->lambda_c_m > 0)
        scene->fit_band_m[1] = scene->lambda_c_m;
    return STATUS_OK;
}

enum status_code scene_keys_read(struct scene *scene, struct scene_source *source)
{
    const yaml_node_t *root = scene_source_root(source);
    size_t lines[COUNT(scene_keys)];
    if (!root)
        return STATUS_OK;
    enum status_code code = scene_source_mapping(source, root, "scene", scene_keys, COUNT(scene_keys), scene, lines);
    return code == STATUS_OK ? join_filters(scene, source, lines) : code;
}
