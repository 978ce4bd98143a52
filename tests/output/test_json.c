/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/results.h"
#include "run/pipeline.h"
#include "scene/scene_source.h"

#include <jansson.h>

/* Three surfaces, one of which has no statistical model, run once for all tests: place/out. */
static int place_setup(void **state)
{
    static struct directory place;
    place = directory_make();
    pipeline_rough(&place, "in/smooth.csv", 120, 0.3, 1);
    pipeline_rough(&place, "in/rough.csv", 120, 1, 2);
    pipeline_bowl(&place, "in/bowl.csv", 121);
    pipeline_rough(&place, "electrical/smooth.csv", 120, 0.3, 1);
    directory_write(&place, "in/scene.yaml",
                    "material: tin\nload: {from: 1e-5, to: 0.5, points: 11}\nconvergence: {scales: 9}\n");
    directory_write(&place, "electrical/scene.yaml", "material: tin\neffects: [electrical]\n");
    assert_int_equal(pipeline_run(&place, "in", "out", 1), 0);
    assert_int_equal(pipeline_run(&place, "electrical", "out-electrical", 1), 0);
    *state = &place;
    return 0;
}

TEST_CASE(test_the_json_names_program_scene_and_input)
{
    json_t *root = directory_json(*state, "out/results.json");
    assert_string_equal(json_text_at(root, "program"), "roughcontact");
    assert_true(strlen(json_text_at(root, "version")) > 0);
    assert_int_equal(json_array_size(json_at(root, "scene/loads_over_AnEp")), 11);
    assert_int_equal(json_array_size(json_object_get(root, "refused")), 0);
    assert_true(json_is_true(json_at(root, "scene/effects/thermal/runs")));
    assert_near(json_number_at(root, "scene/material/E_Pa"), material_find("tin")->youngs_modulus_Pa, 0);
    for (size_t i = 0; i < 3; i++)
        assert_int_equal(strlen(json_text_at(root, filled("surfaces/%zu/sha256", i))), 64);
}

/* What the scene says is told again, whatever its kind. Keys with readers of their own are here by their names in
 * results.json; "": what they ask for stands elsewhere, as the parts of the report that they are. */
TEST_CASE(test_every_key_of_the_scene_is_told)
{
    static const char *const apart[][2] = {
        {"models", "models"},
        {"effects", "effects"},
        {"material", "material"},
        {"counterface", "counterface"},
        {"lay", "lay"},
        {"hardness", "hardness_Pa"},
        {"load", "loads_over_AnEp"},
        {"operating_load", "operating_load_over_AnEp"},
        {"fit_band", "fit_band_m"},
        {"shape", ""},
        {"convergence", "convergence"}, /* where they are given: test_joint_report and others have them */
        {"measured", ""},
        {"targets", ""},
        {"limits", ""},
        {"direct", ""},
        {"export", ""},
        {"surfaces", ""},
    };
    json_t *root = directory_json(*state, "out/results.json");
    const json_t *scene = json_object_get(root, "scene");
    const struct scene defaults = {.tolerance = NAN};
    struct scene_said said;
    size_t plain = 0;
    for (size_t k = 0; scene_said(&said, &defaults, k); k++) {
        const char *key = said.kind == SCENE_SAID_APART ? NULL : said.key;
        for (size_t a = 0; a < sizeof apart / sizeof *apart && !key; a++)
            key = strcmp(apart[a][0], scene_keys[k].name) == 0 ? apart[a][1] : NULL;
        for (int e = 0; e < EFFECT_COUNT && !key; e++) /* in `joint` */
            key = effect_rows[e].key && strcmp(effect_rows[e].key, scene_keys[k].name) == 0 ? "" : NULL;
        if (!key || (*key && !json_object_get(scene, key)))
            fail_msg("results.json does not tell '%s' of the scene", scene_keys[k].name);
        plain += said.kind != SCENE_SAID_APART;
    }
    assert_true(plain > 15);
    assert_near(json_number_at(scene, "max_missing"), 0.1, 0);
    assert_string_equal(json_text_at(scene, "direction"), "x");
    assert_string_equal(json_text_at(scene, "title"), "in");
}

/** The number in the cell of a row of Markdown, the first 0, as 1.2 or 1.2·10⁻⁵; NaN: none. */
static double cell_of(const char *row, size_t cell)
{
    static const char *const raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    char *end;
    for (size_t c = 0; c <= cell; c++)
        row = strchr(row + 1, '|');
    double value = strtod(row + 1, &end), power = 0;
    if (end == row + 1)
        return NAN;
    const char *at = strncmp(end, "·10", strlen("·10")) == 0 ? end + strlen("·10") : "";
    const bool small = strncmp(at, "⁻", strlen("⁻")) == 0;
    at += small ? strlen("⁻") : 0;
    for (int digit = 0; digit < 10; digit++)
        if (strncmp(at, raised[digit], strlen(raised[digit])) == 0) {
            power = 10 * power + digit;
            at += strlen(raised[digit]);
            digit = -1;
        }
    return value * pow(10, small ? -power : power);
}

/** The column of that head in a table that begins behind `from`. */
static size_t column_of(const char *from, const char *head)
{
    size_t column = 0;
    const char *row = strstr(from, "\n| ") + 2, *found = strstr(row, filled("| %s |", head));
    assert_true(found && found < strchr(row, '\n'));
    for (; row < found; row++)
        column += *row == '|';
    return column;
}

/* What tables 6.1 and 6.2 print in a unit is what results.json has in SI: three digits. */
TEST_CASE(test_the_pages_units)
{
    static const struct {
        const char *head, *key;
        double scale;
    } numbers[] = {
        {"Rq (µm)", "rq_m", 1e6},           {"Ra (µm)", "ra_m", 1e6},    {"length (mm)", "scan_length_m", 1e3},
        {"spacing (µm)", "spacing_m", 1e6}, {"α (m¹⁻ᵞ)", "alpha_SI", 1}, {"γ", "gamma", 1},
        {"band (µm)", "fit_low_m", 1e6}};
    static const struct {
        const char *key;
        double scale;
    } properties[] = {{"E_Pa", 1e-9},
                      {"nu", 1},
                      {"Sy_Pa", 1e-6},
                      {"resistivity_ohm_m", 1},
                      {"conductivity_W_per_mK", 1}},
      pair[] = {{"effective_modulus_Pa", 1e-9}, {"hardness_Pa", 1e-6}};
    json_t *root = directory_json(*state, "out/results.json"), *surface;
    const json_t *scene = json_object_get(root, "scene"), *material = json_object_get(scene, "material");
    const char *page = directory_read(*state, "out/report.md");
    const char *materials = strstr(page, "**Table 6.1.**"), *rows = strstr(page, "**Table 6.2.**"),
               *tin = strstr(materials, "\n| tin |") + 1;
    double wavelength_um = strtod(strstr(rows, "αλᵞ at ") + strlen("αλᵞ at "), NULL);
    size_t i, laws = 0;
    json_array_foreach (json_object_get(root, "surfaces"), i, surface) {
        const char *row = strstr(rows, filled("\n| %s |", json_string_value(json_object_get(surface, "surface")))) + 1;
        for (size_t n = 0; n < sizeof numbers / sizeof *numbers; n++) {
            const double shown = cell_of(row, column_of(rows, numbers[n].head));
            if (isfinite(shown))
                assert_within(shown, json_number_at(surface, numbers[n].key) * numbers[n].scale, 5e-3 * fabs(shown));
        }
        double delta_um = cell_of(row, column_of(rows, "Δ (µm)"));
        if (!isfinite(delta_um))
            continue;
        assert_within(json_number_at(surface, "alpha_SI") *
                          pow(wavelength_um * 1e-6, json_number_at(surface, "gamma")) * 1e6,
                      delta_um, 0.02 * delta_um);
        laws++;
    }
    assert_int_equal(i, 3);
    assert_true(laws > 0);
    for (size_t n = 0; n < sizeof properties / sizeof *properties; n++)
        assert_near(cell_of(tin, n), json_number_at(material, properties[n].key) * properties[n].scale, 5e-3);
    for (size_t n = 0; n < sizeof pair / sizeof *pair; n++)
        assert_near(cell_of(tin, 5 + n), json_number_at(scene, pair[n].key) * pair[n].scale, 5e-3);
}

/* Single scans too are told apart by Welch's test, of all pairs: then 1 lies outside the interval of their ratio. */
TEST_CASE(test_the_ratios)
{
    json_t *root = directory_json(*state, "out/results.json"), *pair;
    size_t i;
    json_array_foreach (json_object_get(json_object_get(root, "comparison"), "pairs"), i, pair) {
        double ratio, low, high, p;
        const char *verdict;
        assert_int_equal(json_unpack(pair, "{s:s, s:F, s:[F, F], s:F}", "verdict", &verdict, "ratio", &ratio,
                                     "ratio_95", &low, &high, "p", &p),
                         0);
        assert_string_equal(verdict, p <= 0.05 ? "told apart" : "not told apart");
        assert_true(p > 0.05 || low > 1 || high < 1);
        assert_near(low * high, ratio * ratio, 1e-12);
    }
    assert_true(i > 1);
}

/** ECR of the one surface at the operating load, from the model's curve. */
static double middle_ecr(const json_t *root, const char *model)
{
    const json_t *curves = json_at(root, filled("surfaces/0/models/%s", model));
    for (size_t i = 0; i < json_array_size(json_object_get(curves, "load_over_AnEp")); i++)
        if (json_number_at(curves, filled("load_over_AnEp/%zu", i)) ==
            json_number_at(root, "scene/operating_load_over_AnEp"))
            return json_number_at(curves, filled("ecr_ohm_m2/%zu", i));
    fail_msg("%s has no point at the operating load", model);
    return NAN;
}

/* The leading model is named, and what the heights do to its resistance is that of the curves at the operating load. */
TEST_CASE(test_the_leading_model_and_the_heights)
{
    json_t *root = directory_json(*state, "out/results.json"),
           *elastic = directory_json(*state, "out-electrical/results.json");
    assert_string_equal(json_text_at(root, "leading"), "strip-plastic");
    assert_string_equal(json_text_at(elastic, "leading"), "strip");
    assert_within(json_number_at(elastic, "surfaces/0/models/strip/area_load_slope"), 1, 0.1);
    assert_near(json_number_at(elastic, "surfaces/0/heights_factor_ecr"),
                middle_ecr(elastic, "strip") / middle_ecr(elastic, "corrected-persson"), 1e-12);
}

TEST_GROUP(place_setup, directory_teardown)
