/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene_directory.h"

#define NAMED(name) MODEL_BIT(model_named(name))
#define DATA(name)  TEST_DATA "/scene/" name
#define TIN_Pa      (41.369e9 / (1 - 0.36 * 0.36))

/* Numbers of a scene: where it says nothing, and of full/scene.yaml. */
static const struct {
    size_t place;
    double otherwise, full;
} numbers[] = {
    {offsetof(struct scene, nominal_area_m2), NAN, 1e-6},
    {offsetof(struct scene, load.from), 1e-6, 1e-5},
    {offsetof(struct scene, load.to), 0.1, 1e-2},
    {offsetof(struct scene, tolerance), 1e-6, 1e-9},
    {offsetof(struct scene, fit_band_m[0]), 0, 8e-6},
    {offsetof(struct scene, fit_band_m[1]), INFINITY, 3e-4},
    {offsetof(struct scene, max_missing), 0.1, 0.25},
    {offsetof(struct scene, lay), 0, 0.25},
    {offsetof(struct scene, lambda_s_m), 0, 2.5e-6},
    {offsetof(struct scene, lambda_c_m), 0, 8e-4},
    {offsetof(struct scene, tip_radius_m), 0, 2e-6},
    {offsetof(struct scene, convergence.alpha), 0.085, 0.1},
    {offsetof(struct scene, convergence.gamma), 1.5, 1.25},
    {offsetof(struct scene, convergence.load), 1e-3, 2e-3},
    {offsetof(struct scene, convergence.scan_length_m), 3e-4, 4e-4},
};

static void check_numbers(const struct scene *scene, bool full)
{
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        double expected = full ? numbers[i].full : numbers[i].otherwise;
        double actual = *(const double *)(const void *)((const char *)scene + numbers[i].place);
        if (!(actual == expected || (isnan(actual) && isnan(expected))))
            fail_msg("number %zu is %g, not %g", i, actual, expected);
    }
}

static void check_defaults(const struct scene *scene)
{
    check_numbers(scene, false);
    assert_int_equal(scene->models, NAMED("multiscale-elastic") | NAMED("multiscale-plastic") | NAMED("gw") |
                                        NAMED("jg") | NAMED("corrected-persson") | NAMED("corrected-persson-plastic") |
                                        NAMED("strip") | NAMED("strip-plastic") | NAMED("direct") |
                                        NAMED("direct-plastic") | NAMED("cmy"));
    assert_false(scene->models_named);
    assert_true(isnan(scene->bodies.hardness_Pa)); /* 2.84 S_y */
    assert_true(scene->effects_auto);
    assert_true(isnan(scene->bodies.material.youngs_modulus_Pa)); /* none is assumed */
    assert_int_equal(scene->mean_free_path, SCENE_MEAN_FREE_PATH_THESIS);
    assert_int_equal(scene->bodies.counterface_kind, MATERIAL_COUNTERFACE_RIGID);
    assert_int_equal(scene->load.points, 121);
    assert_null(scene->load.values);
    assert_false(scene->load.kind == UNIT_PRESSURE);
    assert_int_equal(scene->level, LEVEL_LINE);
    assert_int_equal(scene->window, SPECTRUM_WINDOW_AUTO);
    assert_int_equal(scene->fit, POWER_LAW_AUTO);
    assert_false(scene->level_given || scene->fit_band_given);
    assert_int_equal(scene->moments, ROUGHNESS_MOMENTS_DIFFERENCE);
    assert_int_equal(scene->closure, SINUSOID_FIT_THESIS);
    assert_null(scene->baseline);
    assert_int_equal(scene->convergence.scales, 4096);
}

TEST_CASE(test_defaults_without_scene)
{
    struct scene *scene = scene_directory_read(DATA("bare"), NULL);
    check_defaults(scene);
    assert_null(scene->path);
    assert_string_equal(scene->directory, DATA("bare"));
    assert_string_equal(scene->title, "bare");
}

TEST_IN_DIRECTORY(test_defaults_of_texts_that_say_nothing)
{
    static const char *const texts[] = {"", "\n", "# only a comment\n", "---\n", "---\n...\n", "{}", "~\n", "load: {}"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        directory_write(place, "scene.yaml", texts[i]);
        struct scene *scene = scene_directory_read(place->path, NULL);
        check_defaults(scene);
        assert_non_null(scene->path);
        assert_int_equal(scene->surface_count, 0); /* scene.yaml is no scan */
    }
}

static void check_full_material(const struct material *material)
{
    static const double values[] = {97e9, 0.34, 250e6, 6.8e-8, 113, 8460, 377, 4400}; /* in the order of the table */
    assert_string_equal(material->name, "CuZn39Pb3");
    for (size_t p = 0; p < sizeof values / sizeof *values; p++)
        assert_near(material_value(material, &material_properties[p]), values[p], 0);
}

static void check_full_surfaces(const struct scene *scene)
{
    static const char *const said[] = {"1: surface-1.csv [][]", "2: a.csv ../full/b.csv [mm][um]"};
    assert_int_equal(scene->surface_count, 2);
    for (size_t i = 0; i < 2; i++) {
        const struct scene_surface *surface = &scene->surfaces[i];
        struct text *text = support_text();
        text_add(text, "%s:", surface->name);
        for (size_t f = 0; f < surface->files.count; f++)
            text_add(text, " %s", surface->files.path[f]);
        text_add(text, " [%s][%s]", surface->x_unit, surface->z_unit);
        assert_string_equal(text_string(text), said[i]);
    }
}

TEST_CASE(test_every_key)
{
    struct scene *scene = scene_directory_read(DATA("full"), NULL);
    assert_string_equal(scene->path, DATA("full") "/scene.yaml");
    assert_string_equal(scene->title, "Two brass blanks");
    assert_int_equal(scene->models, NAMED("multiscale-elastic") | NAMED("multiscale-plastic"));
    assert_false(scene->effects_auto);
    assert_int_equal(scene->effects,
                     EFFECT_BIT(EFFECT_ELECTRICAL) | EFFECT_BIT(EFFECT_THERMAL) | EFFECT_BIT(EFFECT_SCALE_DEPENDENT));
    check_full_material(&scene->bodies.material);
    assert_int_equal(scene->bodies.counterface_kind, MATERIAL_COUNTERFACE_RIGID);
    assert_int_equal(scene->load.points, 31);
    assert_int_equal(scene->level, LEVEL_PARABOLA);
    assert_int_equal(scene->window, SPECTRUM_WINDOW_HANN);
    assert_int_equal(scene->moments, ROUGHNESS_MOMENTS_SPECTRAL);
    assert_int_equal(scene->closure, SINUSOID_FIT_NUMERIC);
    assert_string_equal(scene->baseline, "2");
    assert_int_equal(scene->convergence.scales, 512);
    check_numbers(scene, true);
    check_full_surfaces(scene);
}

TEST_CASE(test_two_metals_and_listed_loads)
{
    struct scene *scene = scene_directory_read(DATA("connector"), NULL);
    assert_int_equal(scene->effects, EFFECT_BIT(EFFECT_PLASTICITY) | EFFECT_BIT(EFFECT_ELECTRICAL));
    assert_string_equal(scene->bodies.material.name, "bronze");
    assert_int_equal(scene->bodies.counterface_kind, MATERIAL_COUNTERFACE_ELASTIC);
    assert_string_equal(scene->bodies.counterface.name, "gold");
    assert_int_equal(scene->surface_count, 1);

    size_t count;
    double *loads = scene_loads_of(scene, 1e11, &count);
    static const double expected[] = {1e-5, 3e-4, 1e-3}; /* ascending, one of each */
    assert_int_equal(count, 3);
    for (size_t i = 0; i < count; i++)
        assert_near(loads[i], expected[i], 0);
}

TEST_CASE(test_same_metal_and_pressures)
{
    struct scene *scene = scene_directory_read(DATA("same"), NULL);
    assert_int_equal(scene->bodies.counterface_kind, MATERIAL_COUNTERFACE_ELASTIC);
    assert_string_equal(scene->bodies.counterface.name, "copper");
    assert_string_equal(scene->surfaces[0].bodies.material.name, "copper");
    assert_false(scene->surfaces[0].bodies.material_given); /* its own, which results.json would repeat */
    assert_true(scene->load.kind == UNIT_PRESSURE);
    size_t count;
    double *loads = scene_loads_of(scene, 5e10, &count);
    assert_int_equal(count, 5);
    for (size_t i = 0; i < count; i++)
        assert_near(loads[i], pow(10, (double)i) * 1e5 / 5e10, 1e-15);

    struct scene_overrides overrides = {.material = "nickel"};
    scene = scene_directory_read(DATA("same"), &overrides);
    assert_string_equal(scene->bodies.material.name, "nickel");
    assert_string_equal(scene->bodies.counterface.name, "nickel"); /* the same as whatever the material is */
}

TEST_CASE(test_a_material_may_know_little)
{
    struct scene *scene = scene_directory_read(DATA("elastic"), NULL);
    assert_true(scene->effects_auto);
    assert_string_equal(scene->bodies.material.name, "custom");
    assert_near(scene->bodies.material.youngs_modulus_Pa, 70e9, 0);
    assert_near(scene->bodies.counterface.poisson_ratio, 0.3, 0); /* through the alias */
    assert_true(isnan(scene->bodies.material.yield_strength_Pa) && isnan(scene->bodies.material.sound_speed_m_per_s));
    assert_true(isnan(scene->nominal_area_m2));
    assert_true(isinf(scene->fit_band_m[1]));
}

TEST_CASE(test_spellings_that_are_allowed)
{
    static const char *const texts[] = {
        "effects: []\r\ntolerance: \"1E-3\"\r\n",
        "\xef\xbb\xbf{effects: [], tolerance: +.001}",
        "effects: [ ]\ntolerance: 00.1e-2 # a comment\n",
        "effects: []\nbaseline: 01\ntolerance: !!float 1.e-3\nsurfaces: [{name: 01, file: a.csv}, {name: 1, file: "
        "a.csv}]\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        struct scene *scene = scene_of(texts[i]);
        assert_false(scene->effects_auto); /* none at all */
        assert_int_equal(scene->effects, 0);
        assert_near(scene->tolerance, 1e-3, 0);
    }
}

/* Beside the directory's, and named by its file. */
TEST_CASE(test_absolute_file)
{
    struct scene *scene = scene_of("surfaces: [{file: " DATA("full/a.csv") "}]\n");
    assert_string_equal(scene->surfaces[0].name, "a");
    static const char *const rows[][3] = {{"some/where", "a.csv", "some/where/a.csv"},
                                          {"some/", "../a.csv", "some/../a.csv"},
                                          {"some/", DATA("full/a.csv"), DATA("full/a.csv")}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(memory_free) char *path = scene_file_path(&(struct scene){.directory = (char *)rows[i][0]}, rows[i][1]);
        assert_string_equal(path, rows[i][2]);
    }
}

/* Filters bound the wavelengths that the fit uses, unless a line says otherwise. */
TEST_CASE(test_filters_bound_the_fit)
{
    static const struct {
        const char *text;
        double shortest, longest;
    } rows[] = {
        {"lambda_s_m: 2.5e-6\n", 2.5e-6, INFINITY},
        {"lambda_c_m: 8e-4\n", 0, 8e-4},
        {"lambda_c_m: 8e-4\nlambda_s_m: 2.5e-6\n", 2.5e-6, 8e-4},
        {"lambda_s_m: none\nlambda_c_m: none\n", 0, INFINITY},
        {"lambda_c_m: 8e-4\nfit_band_m: all\n", 0, INFINITY},
        {"lambda_c_m: 8e-4\nfit_band_m: [1e-5, 1e-4]\n", 1e-5, 1e-4},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct scene *scene = scene_of(rows[i].text);
        assert_true(scene->fit_band_m[0] == rows[i].shortest && scene->fit_band_m[1] == rows[i].longest);
        assert_near(scene->max_missing, 0.1, 0);
    }
}

TEST_CASE(test_default_loads)
{
    struct scene *scene = scene_directory_read(DATA("bare"), NULL);
    size_t count;
    double *loads = scene_loads_of(scene, 1e11, &count);
    assert_int_equal(count, 121);
    assert_near(loads[0], 1e-6, 0);
    assert_near(loads[120], 0.1, 0);
    for (size_t i = 0; i < count; i++) /* 24 a decade, whole decades exactly */
        assert_near(loads[i], pow(10, -6 + (double)i / 24), i % 24 == 0 ? 1e-16 : 1e-14);

    scene->load.from = scene->load.to = 0.3;
    loads = scene_loads_of(scene, 1e11, &count);
    assert_int_equal(count, 1);
    assert_near(loads[0], 0.3, 0);
}

/* The program's own loads, 1e-6 to 0.1, reach a decade beyond operating_load, up to 1; the scene's do not. */
TEST_CASE(test_loads_reach_a_decade_beyond)
{
    static const struct {
        const char *text;
        double from, to;
    } cases[] = {{"operating_load: 1e-4", 1e-6, 0.1},
                 {"operating_load: 2e-6", 2e-7, 0.1},
                 {"operating_load: 1e-8", 1e-9, 0.1},
                 {"operating_load: 0.03", 1e-6, 0.3},
                 {"operating_load: 0.5", 1e-6, 1},
                 {"nominal_area: 1 cm2\noperating_load: 1 N", 1e3 / TIN_Pa, 0.1}, /* 10 kPa over ten */
                 {"operating_load: 2e-6\nload: {from: 1e-6, to: 1e-3}", 1e-6, 1e-3}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct scene *scene = scene_of(filled("material: tin\n%s\n", cases[i].text));
        assert_near(scene->load.from, cases[i].from, 1e-12);
        assert_near(scene->load.to, cases[i].to, 1e-12);
    }
}

TEST_CASE(test_the_command_line_wins)
{
    struct scene_overrides overrides = {
        .material = "Silver", .effects = "plasticity, separation", .tolerance = "1e-3", .x_unit = "nm", .z_unit = "pm"};
    struct scene *scene = scene_directory_read(DATA("full"), &overrides);
    assert_string_equal(scene->bodies.material.name, "silver");
    assert_int_equal(scene->effects, EFFECT_BIT(EFFECT_PLASTICITY) | EFFECT_BIT(EFFECT_SEPARATION));
    assert_near(scene->tolerance, 1e-3, 0);
    for (size_t i = 0; i < scene->surface_count; i++) {
        assert_string_equal(scene->surfaces[i].x_unit, "nm");
        assert_string_equal(scene->surfaces[i].z_unit, "pm");
    }
    assert_string_equal(scene->title, "Two brass blanks"); /* the rest stays */

    overrides = (struct scene_overrides){.effects = "auto"};
    scene = scene_directory_read(DATA("full"), &overrides);
    assert_true(scene->effects_auto);
    assert_int_equal(scene->effects, 0);

    overrides = (struct scene_overrides){.effects = "auto,direct"}; /* and what is listed beside it */
    scene = scene_directory_read(DATA("full"), &overrides);
    assert_true(scene->effects_auto && scene->direct.called);
    assert_int_equal(scene->effects, EFFECT_BIT(EFFECT_DIRECT));

    overrides = (struct scene_overrides){.material = "tin", .budget = "0.1 min"};
    scene = scene_directory_read(DATA("bare"), &overrides);
    assert_true(scene->effects_auto && scene->direct.called);
    assert_near(scene->direct.budget_s, 6, 1e-15);

    overrides = (struct scene_overrides){.material = "tin", .effects = "scale-dependent", .x_unit = "um"};
    scene = scene_directory_read(DATA("bare"), &overrides);
    assert_int_equal(scene->effects, EFFECT_BIT(EFFECT_SCALE_DEPENDENT) | EFFECT_BIT(EFFECT_THERMAL));
    assert_string_equal(scene->surfaces[0].x_unit, "um");
    assert_string_equal(scene->surfaces[0].z_unit, "");
}

TEST_CASE(test_wrong_overrides)
{
    static const struct {
        struct scene_overrides overrides;
        const char *message;
    } rows[] = {
        {{.material = "aluminim"}, "--material: unknown material 'aluminim'; did you mean 'aluminium'?"},
        {{.effects = "thermal,elctrical"}, "--effects: unknown effect 'elctrical'; did you mean 'electrical'?"},
        {{.budget = "3 N"}, "--budget: 'budget' is '3 N'; give a number in s or one with its unit: s, ms, min, h"},
        {{.effects = " ,"}, "--effects: 'effects' names none; give 'auto' or names such as 'electrical,thermal'"},
        {{.tolerance = "0.5"}, "--tolerance: 'tolerance' is 0.5; allowed is 1e-14 to 0.1"},
        {{.tolerance = "nan"}, "--tolerance: 'tolerance' is 'nan'; give a number such as 1.5e-6"},
        {{.x_unit = "a very long unit"}, "--x-unit: 'unit' is longer than 15 bytes; shorten it"},
        {{.effects = "auto,electrical"},
         "--effects: 'electrical' needs 'resistivity'; add it to 'material' in scene.yaml, or leave the effect out"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        scene_directory_refused(DATA("elastic"), &rows[i].overrides,
                                strstr(rows[i].message, "scene.yaml") ? STATUS_SCENE : STATUS_USAGE, rows[i].message);
}

/* What is wrong in the file is told of the file, whatever the command line overrode. */
TEST_IN_DIRECTORY(test_an_override_is_read_alone)
{
    scene_directory_add(place, "a.csv");
    directory_write(place, "scene.yaml", "\nbaseline: b\n");
    scene_directory_refused(place->path, &(struct scene_overrides){.tolerance = "1e-3"}, STATUS_SCENE,
                            "/scene.yaml:2: 'baseline' is 'b'");
}

TEST_CASE(test_units_of_loads_and_what_fills_the_gaps)
{
    struct scene *scene = scene_of("material: tin\nnominal_area: 1 mm2\nload: {from: 1, to: 10, unit: kN}\n"
                                   "gap: {conductivity: 0.8}\n");
    assert_near(scene->load.from, 1e3, 0);
    assert_near(scene->load.to, 1e4, 0);
    assert_string_equal(scene->load.unit_text, "kN");
    assert_int_equal(scene->joint.fill, JOINT_MEDIUM);
    scene = scene_of("material: tin\nnominal_area: 1 mm2\nload: {values: [1 N, 2 N]}\ngap: {gas: vacuum}\n");
    assert_near(scene->load.values[1], 2, 0);
    assert_string_equal(scene->load.unit_text, "N");
    assert_int_equal(scene->joint.fill, JOINT_VACUUM);
}

/* A unit of the operating load is the charts' where no loads are given, before `load` and behind it; it does not change
 * what the loads are. */
TEST_CASE(test_the_operating_loads_unit_is_that_of_the_loads)
{
    static const struct {
        const char *loads, *unit;
    } cases[] = {{"operating_load: 200 cN", "cN"},
                 {"operating_load: 200 cN\nload: {points: 31}", "cN"},
                 {"operating_load: 2 MPa", "MPa"},
                 {"operating_load: 200 cN\nload: {from: 1 N, to: 10 N}", "N"},
                 {"load: {from: 1e-6, to: 1e-3}\noperating_load: 200 cN", ""},
                 {"operating_load: 1e-4", ""}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct scene *scene = scene_of(filled("material: tin\nnominal_area: 1 mm2\n%s\n", cases[i].loads));
        assert_string_equal(scene->load.unit_text, cases[i].unit);
        assert_int_equal(scene->load.kind, i == 3 ? UNIT_FORCE : UNIT_NUMBER);
    }
}

/** A Vickers number is in kgf/mm²; a correlation holds for surfaces without a hardness of their own. */
TEST_CASE(test_hardness)
{
    static const char *const same[] = {"HV 120", "HV120", "120 HV", "1.176798 GPa"};
    for (size_t i = 0; i < 4; i++) {
        struct scene *scene = scene_of(filled("material: tin\nhardness: %s\n", same[i]));
        assert_near(scene_pair(&scene->bodies).hardness_Pa, 120 * 9.80665e6, 1e-14);
    }
    struct scene *scene = scene_of("material: tin\nhardness: {c1: 3 GPa, c2: -0.2}\nsurfaces:\n  - {file: a.csv}\n"
                                   "  - {file: b.csv, hardness: 1 GPa}\n");
    assert_near(scene_pair(&scene->surfaces[0].bodies).vickers_Pa, 3e9, 0);
    assert_near(scene_pair(&scene->surfaces[0].bodies).vickers_exponent, -0.2, 0);
    assert_within(scene_pair(&scene->surfaces[1].bodies).vickers_Pa, 0, 0);
}

/* A number beside a name is what counts. */
TEST_CASE(test_platings_and_fillers_by_name)
{
    const struct scene *scene =
        scene_of("material: Al\ncounterface: carbon steel\nshape: {flatness: 5 um, over: 20 mm, size: [20 mm, 10 mm]}\n"
                 "gap: {filler: filled grease, bond_line: 30 um}\n"
                 "plating: {metal: hard gold, thickness: 0.8 um}\n");
    assert_string_equal(scene->bodies.material.name, "aluminium");
    assert_string_equal(scene->bodies.counterface.name, "carbon-steel");
    assert_near(scene->joint.conductivity_W_per_mK, 4, 0);
    assert_near(scene->joint.bond_line_m, 3e-5, 1e-15);
    assert_int_equal(scene->joint.fill, JOINT_MEDIUM);
    assert_near(scene->joint.plating_ohm_m, 2.3e-8, 0);
    assert_near(scene->joint.bulge_per_m, 5e-6 / pow(10e-3, 2), 1e-14);
    assert_near(scene->nominal_area_m2, 200e-6, 1e-14);
    assert_near(scene->joint.size_m[1], 10e-3, 0);
    scene = scene_of("material: tin\nnominal_area: 4 cm2\nshape: {crown: 2 m}\n");
    assert_near(scene->joint.bulge_per_m, 0.25, 1e-15);
    assert_near(scene->joint.size_m[0], 20e-3, 1e-14);
    assert_near(scene->joint.size_m[1], 20e-3, 1e-14);
    assert_true(scene->called & EFFECT_BIT(EFFECT_SHAPE));
    scene = scene_of("material: tin\ngap: {filler: pad, conductivity: 3}\n"
                     "plating: {resistivity: 1e-7, metal: nickel, thickness: 2 um}\n");
    assert_near(scene->joint.conductivity_W_per_mK, 3, 0);
    assert_near(scene->joint.plating_ohm_m, 1e-7, 0);
}

TEST_CASE(test_titles)
{
    OWNED(memory_free) char *before = getcwd(NULL, 0);
    assert_int_equal(chdir(DATA("full/..")), 0);
    static const char *const paths[][2] = {{"bare", "bare"},
                                           {"bare/", "bare"},
                                           {"bare///", "bare"},
                                           {"./bare/.", "bare"},
                                           {"full/../same/../bare", "bare"},
                                           {"../scene/bare/..", "scene"},
                                           {".", "scene"},
                                           {"./", "scene"},
                                           {"/", "/"}};
    for (size_t i = 0; i < sizeof paths / sizeof *paths; i++) {
        struct scene *scene = scene_directory_read(paths[i][0], NULL);
        assert_string_equal(scene->title, paths[i][1]);
    }
    assert_int_equal(chdir(before), 0);
}

TEST_CASE(test_targets_and_limits)
{
    static const char text[] =
        "material: tin\ntargets: [{ecr: 1 mohm}, {ecr: 3e-9 ohm m2}, {tcr: 0.5 K/W, area: 5 %}, {conductance: 10 "
        "kW/m2/K}]\n"
        "limits:\n  conductance: {least: 1e4}\n  area: {most: 0.2, least: 1 %}\n  ecr: {most: 2 mohm}\n"
        "nominal_area: 2 mm2\n";
    struct scene *scene = scene_of(text);
    static const struct {
        const char *name, *text;
        double value, shown; /* as the models have it, as the scene does */
        enum quantity quantity;
    } targets[] = {
        {"ecr", "1 mohm", 2e-9, 1, QUANTITY_ECR},
        {"ecr", "3e-09 ohm m2", 3e-9, 3e-9, QUANTITY_ECR},
        {"tcr", "0.5 K/W", 1e-6, 0.5, QUANTITY_TCR},
        {"area", "5 %", 0.05, 5, QUANTITY_AREA},
        {"conductance", "10 kW/m2/K", 1e-4, 10, QUANTITY_TCR},
    };
    assert_int_equal(scene->target_count, 5);
    for (size_t t = 0; t < 5; t++) {
        assert_string_equal(scene->targets[t].how->key, targets[t].name);
        assert_string_equal(scene->targets[t].text, targets[t].text);
        assert_int_equal(scene->targets[t].quantity, targets[t].quantity);
        assert_near(scene->targets[t].value, targets[t].value, 1e-15);
        assert_near(scene_asked_shown(&scene->targets[t], targets[t].value), targets[t].shown, 1e-14);
    }
    static const struct {
        const char *name;
        double value;
        bool is_most, is_upper;
    } limits[] = {{"conductance", 1e-4, false, true},
                  {"area", 0.2, true, true},
                  {"area", 0.01, false, false},
                  {"ecr", 4e-9, true, true}};
    assert_int_equal(scene->limit_count, 4);
    for (size_t l = 0; l < 4; l++) {
        assert_string_equal(scene->limits[l].how->key, limits[l].name);
        assert_near(scene->limits[l].value, limits[l].value, 1e-15);
        assert_int_equal(scene->limits[l].is_most, limits[l].is_most);
        assert_int_equal(scene->limits[l].is_upper, limits[l].is_upper);
    }
}
