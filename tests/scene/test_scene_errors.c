/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every way a scene can be wrong, but for rules between keys (test_scene_rules.c): the message names file, line and
 * key, and what to do. */
#include "scene/scene_words.h"
#include "scene_directory.h"

#define WAYS "'flatness', 'crown', 'height', 'pressure' or 'bolts'; give one"

struct wrong {
    const char *text;     /* of scene.yaml */
    size_t line;          /* that the message has to name */
    const char *expected; /* the message after "file:line: "; where it ends in "...", its beginning */
};

#define DULL "material: {E_Pa: 70e9, nu: 0.3}\n"
#define AREA "material: tin\nnominal_area: 1 mm2\n"

static const struct wrong rows[] = {
    /* What is no YAML, or no mapping. */
    {"title: [a\nlevel: line\n", 2,
     "not valid YAML: did not find expected ',' or ']'; check brackets, quotes and indentation"},
    {"title: a\nlevel: \xff\n", 2,
     "not valid YAML: invalid leading UTF-8 octet; check brackets, quotes and indentation"},
    {"title: a\n---\ntitle: b\n", 2, "a second document starts here; a scene is one, remove the '---'"},
    {"title: [[[[[[[[[[[[[[[[[[[[", 1, "nested too deep; a scene needs at most 4 levels"},
    {"just a text\n", 1, "'scene' is 'just a text'; give 'key: value' pairs"},
    {"title: a\n[x, y]: 1\n", 2, "a key of 'scene' is no text; write 'key: value'"},
    {"&s\ntitle: a\nconvergence: *s\n", 2, "unknown key 'title'; allowed: alpha, gamma, load, scan_length, scales"},
    {"surfaces: &s [*s]\n", 1, "'surfaces' is a list; give 'key: value' pairs"},
    /* Keys. */
    {"title: a\ntolerence: 1\n", 2, "unknown key 'tolerence'; did you mean 'tolerance'?"},
    {"foo: 1\n", 1, "unknown key 'foo'; allowed: title, models, effects, ..."},
    {"level: line\ntitle: a\nlevel: mean\n", 3, "'level' is given twice, first in line 1; remove one"},
    {"title: a\ntolerance:\nlevel: line\n", 2, "'tolerance' has no value; give one or remove the line"},
    {"baseline: ~\n", 1, "'baseline' has no value; give one or remove the line"},
    {"title: ''\n", 1, "'title' is empty; give a text or remove the line"},
    {"title: \"a\\0b\"\n", 1, "'title' has a line end or control character inside; remove it"},
    {"title: [a]\n", 1, "'title' is a list; give text"},
    {"material:\n  E_pa: 1e9\n", 2, "unknown key 'E_pa'; did you mean 'E_Pa'?"},
    {"surfaces:\n  - file: a.csv\n    x_units: mm\n", 3, "unknown key 'x_units'; did you mean 'x_unit'?"},
    {"\"ti\\ntle\\e\": 1\n", 1, "unknown key 'ti?tle?'; did you mean 'title'?"},
    /* Numbers. */
    {"tolerance: [1e-3]\n", 1, "'tolerance' is a list; give a number such as 1.5e-6"},
    {"tolerance: 0\n", 1, "'tolerance' is 0; allowed is 1e-14 to 0.1"},
    {"tolerance: 0.11\n", 1, "'tolerance' is 0.11; allowed is 1e-14 to 0.1"},
    {"%YAML 1.1\n---\ntitle: x\n", 1, "a directive of YAML (%); a scene needs none, remove it"},
    {"title: x\n...\n%TAG ! tag:x\n---\ntitle: x\n", 3, "a directive of YAML (%); a scene needs none, remove it"},
    {"lambda_c_m: 8e-6\nlambda_s_m: 8e-6\n", 1, "'lambda_c' is 8e-06 m, not above 'lambda_s', 8e-06 m; correct either"},
    {"nominal_area_m2: 1e999\n", 1, "'nominal_area_m2' is 1e999; allowed is 1e-18 to 1e+06 m2"},
    {"convergence: {scales: 1.5}\n", 1, "'scales' is '1.5'; give a whole number"},
    {"fit_band_m: [1e-5]\n", 1, "'fit_band_m' is a list; give two lengths, as [10 mm, 20 mm]"},
    {"fit_band_m:\n- 3e-4\n- 8e-6\n", 2, "'fit_band_m' is [0.0003, 8e-06]; give the shorter wavelength first"},
    /* Words. */
    {"level: lines\n", 1, "unknown level 'lines'; did you mean 'line'?"},
    {"moments: [spectral]\n", 1, "'moments' is a list; give one word"},
    {"models: [multiscale,\n  greenwood]\n", 2, "unknown model 'greenwood'; allowed: multiscale, statistical, ..."},
    {"models: []\n", 1, "'models' names none; remove the line for the default ones"},
    {"effects:\n  - thermal\n  - electric\n", 3, "unknown effect 'electric'; did you mean 'electrical'?"},
    {"effects: {thermal: yes}\n", 1, "'effects' is a mapping; give a list of names"},
    {"measured: {file: a.csv,\n load_unit: furlong}\n", 2,
     "'load_unit' is 'furlong'; understood: dimensionless; N, mN, cN, kN, gf, kgf, lbf; Pa, kPa, MPa, GPa, N/mm2, "
     "bar, psi, atm"},
    {"measured: {file: a.csv, quantity: tcr, resistance_unit: mohm}\n", 1,
     "'resistance_unit' is 'mohm'; understood: K/W, mK/W; K m2/W, K mm2/W, K cm2/W"},
    /* Loads. */
    {"load:\n  from: 1e-2\n  to: 1e-3\n", 2, "'from' is 0.01, above 'to', 0.001; exchange them"},
    {"load: {points: 1}\n", 1, "'points' is 1, too few from 1e-06 to 0.1; give 2 or more, or 'values'"},
    {"load: {unit: bar}\n", 1, "'load' is a pressure, of which there is no default; give 'from' and 'to'"},
    {"load: {values: []}\n", 1, "'values' holds 0 loads; allowed is 1 to 100000"},
    {"load:\n  values:\n  - 1e-3\n  - -1e-3\n", 4, "'values' is -1e-3; allowed is 1e-100 to 1e+100"},
    /* Materials. */
    {"material: tim\n", 1, "unknown material 'tim'; did you mean 'tin'?"},
    {"title: a\ncounterface: unobtainium\n", 2, "unknown counterface 'unobtainium'; allowed: rigid, same, tin, ..."},
    {"material: rigid\n", 1, "unknown material 'rigid'; allowed: tin, copper, ..."},
    {"title: a\nmaterial:\n  E_Pa: 1e9\n", 3, "'material' needs 'nu'; add it, or leave 'material' out"},
    {"material:\n  E_Pa: 70e9\n  name: 0123456789012345678901234567890123456789012345678901234567890123\n", 3,
     "'name' is longer than 63 bytes; shorten it"},
    /* Effects that lack a property. */
    {DULL "effects: plasticity\n", 2, "effect 'plasticity' needs 'Sy'; add it to 'material' or leave the effect out"},
    {"effects:\n- separation\n- electrical\n" DULL, 1,
     "effect 'electrical' needs 'resistivity'; add it to 'material' or leave the effect out"},
    /* Effects that a key calls for, and what such a key may say. */
    {"material: tin\neffects: [separation, gap]\n", 2,
     "effect 'gap' needs 'gap'; add that key or leave the effect out"},
    {"effects: [electrical]\nfilm: 0\nmaterial: {E_Pa: 70e9, nu: 0.3, resistivity_ohm_m: 1e-7}\n"
     "gap: {gas: air}\n",
     1, "effect 'thermal' needs 'conductivity'; add it to 'material' or leave the effect out"},
    {"effects: [separation]\nfilm: 0\n", 1,
     "effect 'electrical' needs a material; add 'material' or leave the effect out"},
    {"gap: {gas: phosgene}\n", 1,
     "unknown gas 'phosgene'; allowed: air, nitrogen, helium, argon, hydrogen, carbon dioxide, SF6, neon, "
     "krypton, vacuum"},
    {"gap: {liquid: mercury}\n", 1, "unknown liquid 'mercury'; allowed: water, oil, glycerin"},
    {"gap: {liquid: water, temperature: 380 K}\n", 1,
     "water at 380 K: known as a liquid at 1 atm from 273.15 to 373.15 K; correct 'temperature'"},
    {"gap: {liquid: water,\n temperature: 270 K}\n", 2,
     "water at 270 K: known as a liquid at 1 atm from 273.15 to 373.15 K; correct 'temperature'"},
    {"gap: {gas: krypton, temperature: 119 K}\n", 1,
     "krypton at 119 K: known as a gas at 1 atm from 121 to 600 K; correct 'temperature'"},
    {"gap: {temperature: 601 K}\n", 1,
     "air at 601 K: known as a gas at 1 atm from 100 to 600 K; correct 'temperature'"},
    {"gap: {liquid: oil, gas: air}\n", 1, "'liquid' stands beside 'gas'; remove either"},
    {"gap: {filler: jam}\n", 1,
     "unknown filler 'jam'; allowed: none, silicone grease, filled grease, pad, gallium alloy"},
    {"gap: {bond_line: 20 um}\n", 1, "'bond_line' needs 'conductivity' or 'filler'; add one, or leave 'bond_line' out"},
    {"plating: {thickness: 1 um, metal: chrome}\n", 1,
     "unknown metal 'chrome'; allowed: none, hard gold, soft gold, tin, silver, nickel"},
    {"plating: {thickness: 1 um, metal: none}\n", 1,
     "'plating' needs 'resistivity' or 'metal'; add one, or leave 'plating' out"},
    {"hardness: {c1: 3 GPa, c2: 0.2}\n", 1, "'c2' is 0.2; allowed is -0.99 to 0"},
    {"hardness: HV hard\n", 1,
     "'hardness' is 'HV hard'; give a number in Pa or one with its unit: Pa, kPa, MPa, GPa, N/mm2, bar, psi, atm"},
    {"material: tin\nshape: {crown: 2 m}\n", 2, "'shape' is of which area? add 'nominal_area', or 'size' to it"},
    {"material: tin\nnominal_area: 1 mm2\nshape: {crown: 2 m, size: [2 mm, 1 mm]}\n", 3,
     "'size' is 2e-06 m2 and 'nominal_area' 1e-06 m2; correct either"},
    {"shape: {flatness: 5 um}\n", 1, "'flatness' needs 'over'; add it, or leave 'flatness' out"},
    {"shape: {flatness: 5 um, over: 20 mm, crown: 2 m}\n", 1, "'shape' has several of " WAYS},
    {"shape: {size: [1 mm, 2 mm]}\n", 1, "'shape' has none of " WAYS},
    {"shape: {crown: 2 m, size: 2 mm}\n", 1, "'size' is '2 mm'; give two lengths, as [10 mm, 20 mm]"},
    /* Every key with a dimension takes its unit, and no other; it goes by one name. */
    {"nominal_area: 0 mm2\n", 1, "'nominal_area' is 0 mm2; allowed is 1e-18 to 1e+06 m2"},
    {"nominal_area_m2: 1e-6\nnominal_area: 1 mm2\n", 2, "'nominal_area' is given twice, first in line 1; remove one"},
    /* Loads with units. */
    {"material: tin\nload: {from: 1 N, to: 10 N}\n", 2, "'load' is a force, but on which area? add 'nominal_area'"},
    {"load: {from: 1 MPa, to: 10 MPa}\n", 1,
     "'load' is a pressure, which without a material is no P/(A_n E'); add 'material', or give P/(A_n E')"},
    {AREA "load: {from: 1 N,\n to: 10 MPa}\n", 4, "'to' is a pressure beside a force; give all loads in one unit"},
    {AREA "load: {from: 1 N,\n to: 10}\n", 4, "'to' is a plain number beside a force; give all loads in one unit"},
    {AREA "load: {from: 1 N}\n", 3, "'load' is a force, of which there is no default; give 'from' and 'to'"},
    {AREA "load: {from: 1 MPa, to: 10 MPa,\n unit: N}\n", 4,
     "'unit' is given beside loads that have their own; remove it"},
    {AREA "load: {from: 100 N, to: 10 N}\n", 3, "'from' is 100, above 'to', 10; exchange them"},
    {AREA "load: {from: 1 N, to: 10 N}\noperating_load: 20 N\n", 4,
     "'operating_load' is 20 N, outside the loads, 1 to 10; correct it or 'load'"},
    {"unload_from: 1e-3\n", 1, "unknown key 'unload_from'; allowed: ..."},
    {"data: full\n", 1, "unknown key 'data'; ..."},
    {"effects: unloading\n", 1, "..."},
    {"operating_load: 2e-13\n", 1, "'operating_load' is 2e-13, outside the loads, 1e-06 to 0.1; correct it or 'load'"},
    {"\noperating_load: 5 N\n", 2, "'operating_load' is a force, but on which area? add 'nominal_area'"},
    {AREA "load: {from: 1 N, to: 10 N}\noperating_load: 1e-4\nsurfaces: [{file: a.csv}, {file: b.csv, material: "
          "copper}]\n",
     4,
     "'operating_load' is a plain number and the loads are a force, which differ from material to material; give "
     "both in one kind of unit"},
    {AREA "direct: {loads: [1e-3, 2 MPa]}\n", 3,
     "'loads' is a pressure beside a plain number; give all loads in one unit"},
    /* Nothing is assumed where no material is given. */
    {"effects: [separation,\n electrical]\n", 1,
     "effect 'electrical' needs a material; add 'material' or leave the effect out"},
    {"\ncounterface: copper\n", 2,
     "'counterface' is 'copper', but no material is given to press it on; add 'material'"},
    {"\nmaterial: galinstan\n", 2, "'material' is 'galinstan', which bears no load; give the material of a body"},
    {"\nmaterial: nickel\nmean_free_path: electron\n", 3,
     "'mean_free_path' is 'electron', but that of 'nickel' is not known; give the material's own, such as 40 nm"},
    /* A surface's own bodies. */
    {"effects: electrical\nsurfaces:\n  - {file: a.csv, material: tin}\n  - {file: b.csv, material: {E: 1 GPa, nu: "
     "0.3}}\n",
     1, "effect 'electrical' needs 'resistivity'; add it to 'material' of surface 'b' or leave the effect out"},
    {"load: {from: 1 Pa, to: 9 Pa}\nsurfaces:\n  - {file: a.csv, material: tin}\n  - {file: b.csv}\n", 1,
     "'load' is a pressure, which without a material is no P/(A_n E'); add 'material', or give P/(A_n E')"},
    /* Surfaces. */
    {"surfaces:\n  - {file: a.csv, along: c.csv}\n", 2,
     "cannot find 'c.csv': No such file or directory; paths start at the scene's directory"},
    {"surfaces: a.csv\n", 1, "'surfaces' is 'a.csv'; give a list of '- {name: ..., file: ...}'"},
    {"surfaces: []\n", 1, "'surfaces' lists none; remove it to report every file of the directory"},
    {"surfaces:\n  - {file: a.csv}\n  - {name: b}\n", 3, "'surfaces' needs 'file'; add it, or leave 'surfaces' out"},
    {"surfaces:\n  - {file: []}\n", 2, "'file' lists none; name one or more scans"},
    {"surfaces:\n  - {file: {a: b}}\n", 2, "'file' is a mapping; give text"},
    {"surfaces:\n  - file:\n    - a.csv\n    - c.csv\n", 4,
     "cannot find 'c.csv': No such file or directory; paths start at the scene's directory"},
    {"material: tin\nmeasured: {file: c.csv}\n", 2,
     "cannot find 'c.csv': No such file or directory; paths start at the scene's directory"},
    {"surfaces:\n  - {name: x, file: ..}\n", 2, "'..' is no regular file; name one"},
    {"surfaces:\n  - {name: 1, file: a.csv}\n  - {name: 2, file: a.csv}\n  - {name: \"1\", file: b.csv}\n", 4,
     "two surfaces are named '1', the first in line 2; give each its own 'name'"},
    {"surfaces:\n  - {file: a.csv, column: 0}\n", 2, "'column' is 0; allowed is 1 to 65536"},
    {"surfaces:\n  - {file: a.csv, column: [1, 2, 3]}\n", 2,
     "'column' is no column; give one, as in `column: 3`, or x and z, as in `column: [1, 3]`"},
    {"surfaces:\n  - {file: a.csv, z_unit: micrometremicrometre}\n", 2, "'z_unit' is longer than 15 bytes; shorten it"},
    {"surfaces:\n  - {file: a.csv}\n\nbaseline: b\n", 4, "'baseline' is 'b', no surface's name; the first is 'a'"},
    /* Targets and limits: what is asked, in which unit, and whether the models will compute it. */
    {"targets: []\n", 1, "'targets' names none; remove the line, or give one such as {ecr: 1 mohm}"},
    {"targets: [{foo: 1}]\n", 1, "unknown key 'foo'; allowed: area, ecr, tcr, conductance, temperature, gap"},
    {"targets: [{temperature: 60 degC}]\n", 1,
     "'temperature' needs a current; add 'current' or leave 'temperature' out"},
    {"material: tin\ntargets:\n  - ecr: 1 mohm\n", 3,
     "'ecr' is a resistance, but on which area? add 'nominal_area', or give it times an area (ohm m2)"},
    {"material: tin\neffects: [thermal]\ntargets: [{ecr: 1e-9 ohm m2}]\n", 3,
     "'ecr' needs the effect 'electrical', which is not listed; add it or leave 'ecr' out"},
    {"targets: [{ecr: 1e-9 ohm m2}]\n", 1, "'ecr' needs a material; add 'material' or leave 'ecr' out"},
    {"material: {E: 41 GPa, nu: 0.36}\ntargets: [{conductance: 1e4}]\n", 2,
     "'conductance' needs 'conductivity'; add it to 'material' or leave 'conductance' out"},
    {"limits: {}\n", 1, "'limits' names none; remove the line, or give one such as ecr: {most: 2 mohm}"},
    {"limits:\n  area: {}\n", 2, "'area' needs 'most' or 'least'; add one, or leave 'area' out"},
    {"limits:\n  area: {max: 1}\n", 2, "unknown key 'max'; allowed: most, least"},
    {"limits:\n  ecr:\n    most: 2 mohm\nmaterial: tin\n", 3,
     "'ecr' is a resistance, but on which area? add 'nominal_area', or give it times an area (ohm m2)"},
};

/* Reads a scene in a directory of two scans, which is refused with that message. */
static void check_message(const struct directory *directory, const char *text, size_t line, const char *message)
{
    struct scene scene;
    struct status status = {0};
    char expected[sizeof status.message];
    directory_write(directory, "scene.yaml", text);
    snprintf(expected, sizeof expected, "%s/scene.yaml:%zu: %s", directory->path, line, message);
    if (scene_read(&scene, directory->path, NULL, &status) != STATUS_SCENE)
        fail_msg("accepted: %s", text);
    size_t before = strlen(expected) - strlen("...");
    if (strcmp(expected + before, "...") == 0)
        expected[before] = status.message[before] = '\0';
    assert_string_equal(status.message, expected);
    scene_free(&scene);
}

static void add_two_scans(const struct directory *directory)
{
    scene_directory_add(directory, "a.csv");
    scene_directory_add(directory, "b.csv");
}

TEST_IN_DIRECTORY(test_every_message)
{
    add_two_scans(place);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        check_message(place, rows[i].text, rows[i].line, rows[i].expected);
}

/* Every key with a dimension takes its units, and no other; only decimal numbers are numbers. */
TEST_IN_DIRECTORY(test_quantities)
{
    static const struct {
        const char *text; /* with @ for the value, in its first line */
        const char *key;
        unsigned quantities;
        const char *values[14];
    } keys[] = {
        {"tolerance: @\n",
         "tolerance",
         UNIT_NUMBER,
         {"abc", ".nan", ".inf", "nan", "0x1p-9", "1_0e-3", "0,001", "1e", ".", "1d-3", "1e-3 m", "1 %"}},
        {"nominal_area: @\n", "nominal_area", UNIT_AREA, {"4 mm", "4 furlongs2", "mm2", "4 1"}},
        {"hardness: @\nmaterial: tin\n", "hardness", UNIT_PRESSURE, {"40 mm"}},
        {"surfaces: [{file: a.csv, hardness: @}]\n", "hardness", UNIT_PRESSURE, {"40 s"}},
        {"lambda_s: @\n", "lambda_s", UNIT_DISTANCE, {"8 s"}},
        {"fit_band: [8 um, @]\n", "fit_band", UNIT_DISTANCE, {"3 mm2"}},
        {"material: {E: @, nu: 0.3}\n", "E", UNIT_PRESSURE, {"70 N"}},
        {"material: {E: 70 GPa, nu: 0.3, conductivity: @}\n", "conductivity", UNIT_CONDUCTIVITY, {"90 W/mK"}},
        {"direct: {budget: @}\n", "budget", UNIT_TIME, {"3 m"}},
        {"gap: {gas: air, pressure: @}\n", "pressure", UNIT_PRESSURE, {"5 mm"}},
        {"film: @\n", "film", UNIT_RESISTANCE_AREA, {"1 ohm"}},
        {"targets: [{area: @}]\n", "area", UNIT_NUMBER | UNIT_PERCENT, {"60 degC"}},
        {"targets: [{conductance: @}]\n", "conductance", UNIT_CONDUCTANCE_AREA, {"5 K/W"}},
        {"operating_load: @\n", "operating_load", UNIT_LOADS, {"5 s"}},
    };
    add_two_scans(place);
    for (size_t k = 0; k < sizeof keys / sizeof *keys; k++)
        for (const char *const *value = keys[k].values; *value; value++) {
            const char *text = keys[k].text, *at = strchr(text, '@');
            check_message(
                place, filled("%.*s%s%s", (int)(at - text), text, *value, at + 1), 1,
                filled("'%s' is '%s'; give %s", keys[k].key, *value, scene_quantity_help(keys[k].quantities).text));
        }
}

/* Texts too large to write down: `count` times `part` between `start` and `end`. */
static void check_large(const char *start, const char *part, size_t count, const char *end, const char *expected)
{
    struct directory directory = directory_make();
    scene_directory_add(&directory, "a");
    struct text *text = support_text();
    text_add(text, "%s", start);
    for (size_t i = 0; i < count; i++)
        text_add_bytes(text, part, strlen(part));
    text_add(text, "%s", end);
    directory_write(&directory, "scene.yaml", text->data);
    scene_directory_refused(directory.path, NULL, STATUS_SCENE, expected);
    directory_remove(&directory);
}

TEST_CASE(test_sizes)
{
    check_large("", "# nothing\n", 110000, "", "/scene.yaml' is larger than 1 MiB; a scene is a few lines of text");
    check_large("a: ", "[", 1000000, "", "/scene.yaml:1: nested too deep; a scene needs at most 4 levels");
    check_large("", "- ", 500000, "", "/scene.yaml:1: nested too deep; a scene needs at most 4 levels");
    check_large("title: [&a b, ", "*a, ", 200000, "]",
                "/scene.yaml:1: more than 1000 anchors and aliases; write the values out");
    check_large("surfaces:\n- {file: [", "a, ", 100001, "]}\n",
                "/scene.yaml:2: more than 100000 files in one scene; split it");
    check_large("foo", "o", 900, ": 1\n", "oooooooooo...'; allowed: title, models, effects");
}

TEST_CASE(test_aliases_do_not_multiply)
{
    struct text *end = support_text();
    text_add(end, "]}\n");
    for (int i = 1; i < 500; i++)
        text_add(end, "- {name: n%d, file: *f}\n", i);
    check_large("surfaces:\n- {file: &f [", "a, ", 50001, text_string(end),
                "/scene.yaml:2: more than 100000 files in one scene; split it");
}

TEST_IN_DIRECTORY(test_scene_that_is_no_file)
{
    const char *path = directory_path(place, "scene.yaml");
    assert_int_equal(symlink("nowhere", path), 0);
    scene_directory_refused(place->path, NULL, STATUS_IO, "/scene.yaml': No such file or directory");
    assert_int_equal(unlink(path), 0);
    assert_int_equal(mkfifo(path, 0600), 0); /* reading it would wait for ever */
    scene_directory_refused(place->path, NULL, STATUS_SCENE, "/scene.yaml' is no regular file; remove it");
}
