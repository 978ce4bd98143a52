/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/limits.h"
#include "scene/scene_source.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const closure_names[SINUSOID_FIT_COUNT] = {"thesis", "numeric"};
static const char *const mean_free_path_names[SCENE_MEAN_FREE_PATH_COUNT] = {"thesis", "electron"};
/* Loads, in Pa or P/(A_n E'): any that keeps its distance from the ends of double. */
#define LOAD_LEAST       1e-100
#define LOAD_MOST        1e100
#define LOAD_POINTS_MOST 100000

unsigned scene_keys_with_needed(unsigned effects)
{
    for (int i = 0; i < EFFECT_COUNT; i++)
        for (int k = 0; k < EFFECT_COUNT; k++)
            effects |= effects & EFFECT_BIT(k) ? effect_rows[k].needs_effects : 0;
    return effects;
}

/* Names, and which of them a scene gives. */
struct set {
    const char *what;       /* one of them is */
    const char *names[128]; /* a family and a name for each of at most 64 models */
    bool given[128];
    size_t count;
};

/* Words out of the set, as a list or as one text. */
static bool read_set(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                     struct set *set)
{
    for (size_t i = 0; i < scene_source_item_count(value); i++) {
        const yaml_node_t *item = scene_source_item(source, value, i);
        if (item->type != YAML_SCALAR_NODE)
            return scene_source_wrong_type(source, item, key->name, "a list of names");
        const char *rest = (const char *)item->data.scalar.value;
        for (struct string_view word; scene_words_next(&word, &rest);) {
            size_t n = scene_words_find(word, set->names, set->count);
            if (n == set->count)
                return scene_source_unknown(source, item, word, set->what, set->names, set->count);
            set->given[n] = true;
        }
    }
    return true;
}

static void add_name(struct set *set, const char *name)
{
    if (scene_words_find(string_view_of(name), set->names, set->count) == set->count)
        set->names[set->count++] = name;
}

/* Families, each once, then single models. */
static bool read_models(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value, void *field)
{
    struct set set = {.what = "model"};
    for (size_t m = 0; m < model_count; m++)
        add_name(&set, model_rows[m]->family);
    for (size_t m = 0; m < model_count; m++)
        add_name(&set, model_rows[m]->name);
    if (!read_set(source, key, value, &set))
        return false;
    uint64_t *models = field;
    *models = 0;
    for (size_t i = 0; i < set.count; i++)
        *models |= set.given[i] ? model_find(set.names[i]) : 0;
    return *models || scene_source_fail_at(source, value, "'models' names none; remove the line for the default ones");
}

static bool read_effects(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                         void *field)
{
    struct scene *scene = source->scene;
    unsigned *effects = field;
    struct set set = {.what = "effect"};
    *effects = 0;
    source->effects_overridden = source->option;
    for (int i = 0; i < EFFECT_COUNT; i++)
        add_name(&set, effect_rows[i].name);
    add_name(&set, "auto");
    if (!read_set(source, key, value, &set))
        return false;
    for (int i = 0; i < EFFECT_COUNT; i++)
        *effects |= set.given[i] ? EFFECT_BIT(i) : 0;
    *effects = scene_keys_with_needed(*effects);
    scene->effects_auto = set.given[EFFECT_COUNT];
    return *effects || scene->effects_auto || !source->option ||
           scene_source_fail_at(source, value,
                                "'effects' names none; give 'auto' or names such as 'electrical,thermal'");
}

/* Names of programs, joined: export_check() knows which there are. */
static bool read_export(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value, void *field)
{
    OWNED(text_free) struct text names = {0};
    char **exports = field;
    bool good = true;
    for (size_t i = 0; i < scene_source_item_count(value) && good; i++) {
        const yaml_node_t *item = scene_source_item(source, value, i);
        good = item->type == YAML_SCALAR_NODE || scene_source_wrong_type(source, item, key->name, "a list of names");
        text_add(&names, "%s ", good ? (const char *)item->data.scalar.value : "");
    }
    free(*exports);
    *exports = strdup(text_string(&names));
    source->scene->exports_overridden = source->option;
    return good && (*exports || scene_source_memory(source));
}

/* Wavelengths [shortest, longest]. */
static bool read_fit_band(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                          void *field)
{
    const double *band = field;
    if (scene_source_is(value, key->word))
        return true;
    if (!scene_source_pair(source, key, value, field))
        return false;
    return band[0] < band[1] ||
           scene_source_fail_at(source, value, "'%s' is [%g, %g]; give the shorter wavelength first", key->name,
                                band[0], band[1]);
}

/* A load, of the kind that those before it in `load` have. */
static bool read_load_one(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                          struct scene_load *load, double *number)
{
    struct scene_quantity quantity;
    if (!scene_source_quantity_of(source, key, value, &quantity))
        return false;
    if (load->given && quantity.kind != load->kind)
        return scene_source_fail_at(source, value, "'%s' is %s beside %s; give all loads in one unit", key->name,
                                    unit_quantity_name(quantity.kind), unit_quantity_name(load->kind));
    if (!load->given && quantity.kind != UNIT_NUMBER) {
        load->unit = quantity.unit;
        strcpy(load->unit_text, quantity.text);
    }
    load->kind = quantity.kind;
    load->given = true;
    *number = quantity.value;
    return true;
}

static bool read_load_number(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                             void *field)
{
    return read_load_one(source, key, value, &source->scene->load, field);
}

/* A list of them, into a struct scene_load. */
static bool read_load_list(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                           void *field)
{
    struct scene_load *load = field;
    size_t count = scene_source_item_count(value), most = LOAD_POINTS_MOST;
    if (count == 0 || count > most)
        return scene_source_fail_at(source, value, "'%s' holds %zu loads; allowed is 1 to %zu", key->name, count, most);
    load->values = malloc(count * sizeof *load->values);
    if (!load->values)
        return scene_source_memory(source);
    load->points = count;
    for (size_t i = 0; i < count; i++)
        if (!read_load_one(source, key, scene_source_item(source, value, i), load, &load->values[i]))
            return false;
    return true;
}

#define LOADS .least = LOAD_LEAST, .most = LOAD_MOST, .quantities = UNIT_LOADS

#define LOAD(member) offsetof(struct scene_load, member)
enum { LOAD_FROM, LOAD_TO, LOAD_POINTS, LOAD_VALUES, LOAD_UNIT };
static const struct scene_key load_keys[] = {
    {"from", NULL, read_load_number, .at = LOAD(from), LOADS},
    {"to", NULL, read_load_number, .at = LOAD(to), LOADS},
    {"points", NULL, SCENE_WHOLE(LOAD(points), 1, LOAD_POINTS_MOST)},
    {"values", NULL, read_load_list, .at = 0, LOADS, .excludes = "from, to, points"},
    {"unit", NULL, scene_source_unit, .at = LOAD(unit_text), .quantities = UNIT_LOADS},
};

/* Puts plain loads into load->unit_text. Pascals leave the charts over P/(A_n E'), another unit of force or pressure
 * does not. */
static void apply_load_unit(struct scene_load *load)
{
    (void)unit_read(&load->unit, load->unit_text, strlen(load->unit_text)); /* scene_source_unit() has */
    load->kind = (enum unit_quantity)unit_of(&load->unit, UNIT_LOADS);
    if (load->kind == UNIT_NUMBER || strcmp(load->unit_text, "Pa") == 0)
        *load->unit_text = '\0';
    load->from *= load->unit.factor;
    load->to *= load->unit.factor;
    for (size_t i = 0; load->values && i < load->points; i++)
        load->values[i] *= load->unit.factor;
}

static bool complete_load(struct scene_source *source, const size_t *lines, size_t line, void *into)
{
    struct scene_load *load = into;
    if (lines[LOAD_UNIT] && load->kind != UNIT_NUMBER)
        return scene_source_fail(source, lines[LOAD_UNIT],
                                 "'unit' is given beside loads that have their own; remove it");
    if (lines[LOAD_UNIT])
        apply_load_unit(load);
    if (load->kind != UNIT_NUMBER && !load->values && !(lines[LOAD_FROM] && lines[LOAD_TO]))
        return scene_source_fail(source, line, "'load' is %s, of which there is no default; give 'from' and 'to'",
                                 unit_quantity_name(load->kind));
    if (!load->values && load->from > load->to)
        return scene_source_fail(source, line, "'from' is %g, above 'to', %g; exchange them", load->from, load->to);
    return load->values || load->points > 1 || load->from == load->to ||
           scene_source_fail(source, line, "'points' is 1, too few from %g to %g; give 2 or more, or 'values'",
                             load->from, load->to);
}

#define BENCHMARK(member) offsetof(struct scene_convergence, member)
static const struct scene_key convergence_keys[] = {
    {"alpha", NULL, SCENE_NUMBER(BENCHMARK(alpha), 1e-12, 1e12)},
    {"gamma", NULL, SCENE_NUMBER(BENCHMARK(gamma), 0.0, 5.0)},
    {"load", NULL, SCENE_NUMBER(BENCHMARK(load), LOAD_LEAST, LOAD_MOST), .given = BENCHMARK(load_given)},
    {"scan_length", NULL, SCENE_QUANTITY(BENCHMARK(scan_length_m), UNIT_DISTANCE, 1e-9, 1e3), .alias = "scan_length_m"},
    {"scales", NULL, SCENE_WHOLE(BENCHMARK(scales), 1, 1e6)},
};

/* How many, or which. */
static bool read_direct_loads(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                              void *field)
{
    struct scene_direct *direct = field;
    const struct scene_key number = {key->name, LOADS};
    struct scene_load load = {.kind = UNIT_NUMBER};
    if (value->type != YAML_SEQUENCE_NODE)
        return scene_source_whole(source, key, value, &direct->loads);
    bool good = read_load_list(source, &number, value, &load);
    direct->values = load.values;
    direct->loads = load.points;
    direct->kind = load.kind;
    for (size_t i = 1; i < load.points && good; i++)
        good = direct->values[i] > direct->values[i - 1] ||
               scene_source_fail_at(source, value, "'loads' do not rise; order them, each once");
    return good && (load.points <= SCENE_DIRECT_LOADS ||
                    scene_source_fail_at(source, value, "'loads' holds %zu; allowed is 1 to %d", load.points,
                                         SCENE_DIRECT_LOADS));
}

#define DIRECT(member) offsetof(struct scene_direct, member)
enum { DIRECT_BUDGET = 4 };
static const char *const direct_surfaces[SCENE_DIRECT_SURFACES_COUNT] = {"baseline", "all"};
static const struct scene_key direct_keys[] = {
    {"grid", NULL, SCENE_WHOLE(DIRECT(grid), SCENE_DIRECT_GRID_LEAST, SCENE_DIRECT_GRID_MOST)},
    {"seeds", NULL, SCENE_WHOLE(DIRECT(seeds), 1, SCENE_DIRECT_SEEDS)},
    {"loads", NULL, read_direct_loads, .at = 0, .least = 2, .most = SCENE_DIRECT_LOADS, .quantities = UNIT_NUMBER},
    {"hardness", NULL, SCENE_QUANTITY(DIRECT(hardness_Pa), UNIT_PRESSURE, 1e3, 1e12), .word = "auto"},
    [DIRECT_BUDGET] = {"budget", NULL, SCENE_QUANTITY(DIRECT(budget_s), UNIT_TIME, 1e-3, 1e7)},
    {"surfaces", NULL, SCENE_CHOICE(DIRECT(surfaces), direct_surfaces)},
};
const struct scene_key *const scene_budget_key = &direct_keys[DIRECT_BUDGET];

static bool complete_direct(struct scene_source *source, const size_t *lines, size_t line, void *into)
{
    struct scene_direct *direct = into;
    const size_t points = direct->grid * direct->grid * direct->seeds;
    direct->called = true;
    if (direct->grid % 2 != 0)
        return scene_source_fail(source, lines[0], "'grid' is %zu; give an even number", direct->grid);
    return points <= limit_most(LIMIT_DIRECT_POINTS) ||
           scene_source_fail(source, line, "%zu x %zu points, %zu times%s", direct->grid, direct->grid, direct->seeds,
                             limit_words(LIMIT_DIRECT_POINTS).text);
}

static bool read_direct(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value, void *field)
{
    return scene_source_is(value, "off") || scene_source_within(source, key, value, field);
}

static bool read_fluid(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value, void *field)
{
    struct joint *joint = field;
    const char *names[SCENE_KEYS_MOST]; /* those of the table, then of gases none */
    const bool liquid = strcmp(key->name, "liquid") == 0;
    const struct gas *table = liquid ? gas_liquids : gas_table;
    const size_t count = liquid ? gas_liquid_count : gas_count;
    struct scene_key fluids = *key;
    unsigned fluid;
    assert(count < SCENE_KEYS_MOST);
    for (size_t i = 0; i < count; i++)
        names[i] = table[i].name;
    names[count] = "vacuum";
    fluids.choices = names;
    fluids.choice_count = liquid ? count : count + 1;
    if (!scene_source_choice(source, &fluids, value, &fluid))
        return false;
    joint->gas = fluid < count ? &table[fluid] : NULL;
    joint->fill = liquid ? JOINT_MEDIUM : joint->gas ? JOINT_GAS : JOINT_VACUUM;
    return true;
}

/* What fills the gaps between the spots, into a struct joint. */
#define JOINT(member) offsetof(struct joint, member)
static const struct scene_key gap_keys[] = {
    {"conductivity", NULL, SCENE_QUANTITY(JOINT(conductivity_W_per_mK), UNIT_CONDUCTIVITY, 1e-6, 1e4),
     .excludes = "gas, pressure, accommodation"},
    {"filler", NULL, SCENE_CHOICE(JOINT(filler), joint_filler_names), .word = "none",
     .excludes = "gas, pressure, accommodation"},
    {"bond_line", NULL, SCENE_QUANTITY(JOINT(bond_line_m), UNIT_DISTANCE, 1e-9, 1.0),
     .needs = "conductivity or filler"},
    {"gas", NULL, read_fluid, .at = 0},
    {"pressure", NULL, SCENE_QUANTITY(JOINT(pressure_Pa), UNIT_PRESSURE, 0.0, 1e9)},
    {"accommodation", NULL, SCENE_NUMBER(JOINT(accommodation), 1e-3, 1.0)},
    {"temperature", NULL, SCENE_QUANTITY(JOINT(temperature_K), UNIT_TEMPERATURE, 1.0, 1e4)},
    {"liquid", NULL, read_fluid, .at = 0, .excludes = "conductivity, filler, bond_line, gas, pressure, accommodation"},
};
static bool complete_gap(struct scene_source *source, const size_t *lines, size_t line, void *into)
{
    struct joint *joint = into;
    (void)line;
    bool medium = lines[0] || joint->filler;
    if (joint->filler && !lines[0])
        joint->conductivity_W_per_mK = joint_fillers[joint->filler].value;
    joint->fill = medium ? JOINT_MEDIUM : joint->fill;
    joint->gas = medium ? NULL : joint->gas;
    const struct gas *fluid = joint->gas;
    if (fluid && !(joint->temperature_K >= fluid->least_K && joint->temperature_K <= fluid->most_K))
        return scene_source_fail(source, lines[6] ? lines[6] : lines[7],
                                 "%s at %g K: known as a %s at 1 atm from %g to %g K; correct 'temperature'",
                                 fluid->name, joint->temperature_K, lines[7] ? "liquid" : "gas", fluid->least_K,
                                 fluid->most_K);
    if (lines[7])
        joint->conductivity_W_per_mK = gas_conductivity(fluid, joint->temperature_K);
    if (fluid && !lines[5])
        joint->accommodation = fluid->accommodation;
    return true;
}

static const char *const sides[] = {"one", "both"};
static const struct scene_key plating_keys[] = {
    {"thickness", NULL, SCENE_QUANTITY(JOINT(plating_thickness_m), UNIT_DISTANCE, 1e-12, 1.0)},
    {"resistivity", NULL, SCENE_QUANTITY(JOINT(plating_ohm_m), UNIT_RESISTIVITY, 1e-12, 1e10)},
    {"sides", NULL, SCENE_CHOICE(JOINT(both_plated), sides)},
    {"metal", NULL, SCENE_CHOICE(JOINT(plating), joint_plating_names), .word = "none"},
};
static bool complete_plating(struct scene_source *source, const size_t *lines, size_t line, void *into)
{
    struct joint *joint = into;
    (void)source;
    (void)line;
    if (joint->plating && lines[1] == 0)
        joint->plating_ohm_m = joint_platings[joint->plating].value;
    return true;
}

#define AT(member) offsetof(struct scene, member)
const struct scene_key scene_keys[] = {
    {"title", "heading of the report; default: the directory's name", scene_source_text, .at = AT(title)},
    {"models", "families or single models, as `roughcontact models` lists them; default: those that run by default",
     read_models, .at = AT(models), .given = AT(models_named)},
    {"effects", "auto, a list of effects, or both, as --effects takes it; default: auto", read_effects,
     .at = AT(effects)},
    {"material",
     "a built-in material, or a mapping of its properties (E, nu, Sy, resistivity, conductivity, density, "
     "specific_heat, sound_speed, hardness, mean_free_path); default: none, and only what needs no material runs",
     scene_surfaces_material, .at = AT(bodies.material), .given = AT(bodies.material_given)},
    {"counterface",
     "rigid, same, a material, a mapping of its properties, or for all surfaces another rough one: {surface: FILE, "
     "material, x_unit, z_unit, column}, whose amplitudes add as squares and whose profiles are taken in pairs; "
     "default: rigid, a flat that conducts like the material",
     scene_surfaces_counterface, .at = AT(bodies)},
    {"direction", "profiles of a map are its rows or its columns; default: x",
     SCENE_CHOICE(AT(direction), scan_direction_names)},
    {"lay",
     "rms slope along over across the lay, of scans taken across it (0: perfect, 1: none), where a surface does not "
     "say its own and is no map; default: no lay",
     SCENE_NUMBER(AT(lay), 0.0, 1.0), .given = AT(lay_given)},
    {"measured",
     "{file (a list or pattern: each a run), quantity: tcr (default: ecr), load_unit, resistance_unit, carry}: "
     "resistance measured on the baseline; it stands above the models, but with carry: false; default: carry: true",
     SCENE_MEASURED(AT(measured))},
    {"nominal_area", "default: none, and resistances stay per area",
     SCENE_QUANTITY(AT(nominal_area_m2), UNIT_AREA, 1e-18, 1e6), .word = "none", .alias = "nominal_area_m2"},
    {"hardness",
     "of the softer body: a pressure, HV 120 (kgf/mm2), or {c1, c2} of the Vickers hardness c1 (d/1 um)^c2 of an "
     "indentation of diagonal d; default: the material's, else 2.84 of its yield strength",
     SCENE_HARDNESS(AT(bodies)), .needs = "material"},
    {"mean_free_path",
     "of what carries heat, for scale-dependent, where the material does not give its own: of phonons, or of a metal's "
     "free electrons; default: thesis",
     SCENE_CHOICE(AT(mean_free_path), mean_free_path_names)},
    {"load",
     "{from, to, points}, spaced by equal factors, or {values: [...]}, as P/(A_n E') or with a unit, in which charts "
     "and tables then stand; default: 1e-6 to 0.1, and a decade beyond operating_load, in 121 points",
     scene_source_within, .at = AT(load), .within = SCENE_RULED("load", load_keys, .then = complete_load)},
    {"operating_load",
     "where the first page stands; its unit is that of charts and tables where `load` has no loads; default: the "
     "middle of an area of 0.1 to 10 %",
     scene_source_quantity_of, .at = AT(operating), LOADS},
    {"targets", "a list of {ecr, tcr, conductance, gap, area or temperature: value}: the load that each needs",
     scene_asked_read, .at = 0},
    {"limits",
     "a mapping of such quantities, each {most: value} or {least: value}, at the operating load; `report --check` ends "
     "with 5 where one is missed, with 6 where none is and one is undecided",
     scene_asked_read, .at = 0},
    {"tolerance", "relative, of what closed forms are computed to; default: 1e-6",
     SCENE_NUMBER(AT(tolerance), 1e-14, 0.1)},
    {"accuracy",
     "that 95 of 100 answers are to lie within by the model's own error, as 200 % (a factor of 3): of the models that "
     "docs/validation.md finds "
     "as good the cheapest runs; default: none is asked, and all run",
     SCENE_QUANTITY(AT(accuracy), UNIT_NUMBER | UNIT_PERCENT, 1e-3, 1e3)},
    {"level",
     "what is taken out of a profile; a map that is solved directly loses its plane; default: line, of a periodic "
     "record "
     "the mean alone",
     SCENE_CHOICE(AT(level), level_names), .given = AT(level_given)},
    {"window", "of the spectrum; default: auto, none for a periodic record, else Hann",
     SCENE_CHOICE(AT(window), spectrum_window_names)},
    {"fit",
     "of the power law: through a multitaper spectrum in the band found, or through all harmonics; default: auto",
     SCENE_CHOICE(AT(fit), power_law_method_names)},
    {"fit_band", "[shortest, longest] wavelength that the fit uses; default: found (auto), all (thesis)", read_fit_band,
     .at = AT(fit_band_m), .least = 1e-12, .most = 1e3, .word = "all", .quantities = UNIT_DISTANCE,
     .alias = "fit_band_m", .given = AT(fit_band_given)},
    {"moments", "how slopes and curvatures come about; default: difference",
     SCENE_CHOICE(AT(moments), roughness_moments_names)},
    {"closure", "area and gap of a sinusoid; default: thesis", SCENE_CHOICE(AT(closure), closure_names)},
    {"export",
     "programs that tables of conductance over pressure are written for, of abaqus, ansys, calculix, comsol, elmer, "
     "moose; with :mm behind it (calculix:mm) in N, mm, s, else in SI; default: none",
     read_export, .at = AT(exports)},
    {"max_missing", "share of missing points that may be bridged; default: 10 %",
     SCENE_QUANTITY(AT(max_missing), UNIT_NUMBER | UNIT_PERCENT, 0.0, 0.9)},
    {"lambda_s",
     "cut-off of the Gaussian low-pass by ISO 16610-21, of maps 16610-61; none, given, takes maps as measured; "
     "default: "
     "none, and of a noisy map 6 spacings",
     SCENE_QUANTITY(AT(lambda_s_m), UNIT_DISTANCE, 1e-12, 1e3), .word = "none", .alias = "lambda_s_m",
     .given = AT(lambda_s_given)},
    {"lambda_c",
     "cut-off of the Gaussian high-pass of profiles by ISO 16610-21, not of a map that is solved directly; default: "
     "none",
     SCENE_QUANTITY(AT(lambda_c_m), UNIT_DISTANCE, 1e-12, 1e3), .word = "none", .alias = "lambda_c_m",
     .above = "lambda_s"},
    {"tip_radius", "of the stylus: warns where the surface is sharper; default: none",
     SCENE_QUANTITY(AT(tip_radius_m), UNIT_DISTANCE, 1e-12, 1.0), .word = "none", .alias = "tip_radius_m"},
    {"template",
     "a file in DIR that the report is filled from (docs/templates.md), below `--template`; default: the program's",
     scene_source_text, .at = AT(template)},
    {"baseline", "the surface of the one-surface comparison; default: the second smoothest", scene_source_text,
     .at = AT(baseline)},
    {"direct",
     "off, or {grid, seeds, loads (how many, or a list), hardness, budget, surfaces: baseline or all}: the direct "
     "solution; default: off",
     read_direct, .at = AT(direct), .within = SCENE_RULED("direct", direct_keys, .then = complete_direct)},
    {"gap",
     "{gas: air, nitrogen, helium, argon, hydrogen, carbon dioxide, SF6, neon, krypton or vacuum, pressure (1 atm), "
     "temperature (300 K), accommodation (the gas's)}, {liquid: water, oil or glycerin, temperature} or {filler: "
     "silicone grease, filled grease, pad or gallium alloy (or conductivity), bond_line} of what fills the gaps: "
     "the heat that it carries; default: nothing is said of it",
     scene_source_within, .at = AT(joint), .within = SCENE_RULED("gap", gap_keys, .then = complete_gap)},
    {"film", "insulating film on the spots, a resistance times an area; default: none",
     SCENE_QUANTITY(AT(joint.film_ohm_m2), UNIT_RESISTANCE_AREA, 0.0, 1e6)},
    {"shape",
     "{flatness: 5 um, over: 20 mm} or {crown: radius} of parts that bulge towards each other, {height: map of one "
     "part}, {pressure: file of x, y, p or of area, p, or several, each of another load, scale: true} or {bolts: "
     "[[10 mm, 10 mm]], force: 2 kN, head: 8.5 mm}, with thickness: [5 mm, 8 mm] of the parts (default: half-spaces) "
     "and size: [20 mm, 10 mm] of the nominal area (default: a square), from a corner of which places count: "
     "conductance and ECR of the whole of it; default: the parts are flat",
     scene_source_within, .at = 0, .given = AT(shape.given), .within = &scene_shape_ways},
    {"plating",
     "{thickness, metal: hard gold, soft gold, tin, silver or nickel (or resistivity), sides: one (the surface's, "
     "as by default) or both}; thicker than indents are deep, a metal brings its hardness, below that of 'hardness'; "
     "default: none",
     scene_source_within, .at = AT(joint),
     .within =
         SCENE_RULED("plating", plating_keys, .needs = "thickness, resistivity or metal", .then = complete_plating)},
    {"current", "through the contact, for its voltage and temperature; default: none",
     SCENE_QUANTITY(AT(joint.current_A), UNIT_CURRENT, 1e-12, 1e9), .needs = "nominal_area"},
    {"convergence",
     "{alpha (0.085), gamma (1.5), load (1e-3), scan_length (0.3 mm), scales (4096)} of the convergence study; "
     "default: effects: auto runs none",
     scene_source_within, .at = AT(convergence), .given = AT(convergence.given),
     .within = SCENE_MAPPING("convergence", convergence_keys)},
    {"surfaces",
     "a list of {name, file, along (scans in the other direction; the steeper ones are taken as across the lay) or "
     "lay, x_unit, z_unit, column, material, counterface, hardness, measured}; default: every scan in the directory by "
     "its name, a sub-directory a surface of its files",
     scene_surfaces_read, .at = 0, .within = &scene_surfaces_each},
};
const size_t scene_key_count = SCENE_COUNT(scene_keys);
const struct scene_mapping scene_keys_whole = {.name = "scene", .keys = scene_keys, .count = SCENE_COUNT(scene_keys)};

bool scene_said(struct scene_said *out, const struct scene *scene, size_t k)
{
    if (k >= scene_key_count)
        return false;
    const struct scene_key *key = &scene_keys[k];
    const void *at = (const char *)scene + key->at;
    *out = (struct scene_said){.key = key->alias ? key->alias : key->name, .at = at};
    for (int e = 0; e < EFFECT_COUNT; e++)
        if (effect_rows[e].key && strcmp(effect_rows[e].key, key->name) == 0)
            return true;
    if (key->read == scene_source_choice)
        out->at = &key->choices[*(const unsigned *)at];
    out->kind = key->read == scene_source_quantity                                   ? SCENE_SAID_NUMBER
                : key->read == scene_source_whole                                    ? SCENE_SAID_COUNT
                : key->read == scene_source_choice || key->read == scene_source_text ? SCENE_SAID_TEXT
                                                                                     : SCENE_SAID_APART;
    return true;
}
