/* SPDX-License-Identifier: GPL-3.0-or-later */
/* docs/results.schema.json and docs/first_chart.py against the results.json of the examples. */
#include "cli/process.h"
#include "contact/quantity.h"

static const char *const examples[] = {"connector", "chapter6", "thermal-interface", "lapped-map"};
enum { EXAMPLES = 4, TEXT = 256 };
static json_t *results[EXAMPLES], *schema, *defs;

static int reports_setup(void **state)
{
    directory_setup(state);
    schema = workspace_json(PROJECT_SOURCE, "docs/results.schema.json");
    defs = json_object_get(schema, "$defs");
    for (size_t e = 0; e < EXAMPLES; e++) {
        run_to_exit(*state, 0, "report", filled("%s/surfaces/%s", PROJECT_SOURCE, examples[e]), "-o", examples[e],
                    "--no-cost", "--brief");
        results[e] = workspace_json(*state, filled("%s/results.json", examples[e]));
    }
    return 0;
}

TEST_GROUP(reports_setup, directory_teardown)

/** Is the value one of these, or of a type of these? */
static bool is_any(const json_t *told, const json_t *value, bool by_type)
{
    static const char *const types[] = {"object", "array", "string", "integer", "number", "boolean", "boolean", "null"};
    const char *type = json_string_value(told), *own = types[json_typeof(value)];
    bool any = by_type && type && (strcmp(type, own) == 0 || (json_is_integer(value) && strcmp(type, "number") == 0));
    for (size_t i = 0; i < json_array_size(told); i++) {
        const json_t *one = json_array_get(told, i);
        any = any || (by_type ? is_any(one, value, true) : json_equal(one, value));
    }
    return any;
}

/** Does the value at `where` follow the rule? If not, `fault` says where, and which keyword is broken. */
static bool holds(const json_t *rule, json_t *value, const char *where, char fault[TEXT])
{
    char inner[TEXT];
    const char *word, *key;
    json_t *told, *part;
    size_t i;
    assert_non_null(rule);
    json_object_foreach ((json_t *)rule, word, told) {
        bool good = true, items = strcmp(word, "items") == 0, named = strcmp(word, "properties") == 0;
        if (strcmp(word, "type") == 0 || strcmp(word, "enum") == 0)
            good = is_any(told, value, *word == 't');
        else if (strcmp(word, "minimum") == 0)
            good = !json_is_number(value) || json_number_value(value) >= json_number_value(told);
        else if (strcmp(word, "required") == 0)
            json_array_foreach (told, i, part)
                good = good && json_object_get(value, json_string_value(part));
        else if (strcmp(word, "$ref") == 0 &&
                 !holds(json_object_get(defs, json_string_value(told) + 8), value, where, fault))
            return false;
        else if (!items && !named && strcmp(word, "additionalProperties") != 0 && !strchr("$td", *word))
            fail_msg("this test does not know the schema's keyword '%s'", word);
        if (!good) {
            snprintf(fault, TEXT, "%s: %s", where, word);
            return false;
        }
        json_array_foreach (items ? value : NULL, i, part) {
            snprintf(inner, sizeof inner, "%s/%zu", where, i);
            if (!holds(told, part, inner, fault))
                return false;
        }
        json_object_foreach (named || *word == 'a' ? value : NULL, key, part) {
            const json_t *own = json_object_get(json_object_get(rule, "properties"), key);
            snprintf(inner, sizeof inner, "%s/%s", where, key);
            if (named == (own != NULL) && !holds(named ? own : told, part, inner, fault))
                return false;
        }
    }
    return true;
}

TEST_CASE(examples_hold_to_the_schema)
{
    char fault[TEXT];
    for (size_t e = 0; e < EXAMPLES; e++)
        if (!holds(schema, results[e], examples[e], fault))
            fail_msg("%s", fault);
    for (int q = 0; q < QUANTITY_COUNT; q++)
        assert_non_null(
            json_object_get(json_object_get(json_object_get(defs, "curve"), "properties"), quantity_rows[q].name));
}

TEST_CASE(faults_do_not)
{
    /* example and path, what is put there, what is found */
    static const char *const faults[][3] = {
        {"0/schema_version", NULL, ": required"},
        {"0/surfaces/0/spread/files", "-1", "/surfaces/0/spread/files: minimum"},
        {"0/comparison/pairs/0/verdict", "\"perhaps\"", "/comparison/pairs/0/verdict: enum"},
        {"0/surfaces/0/measured/joint_ecr_ohm_m2", "[\"7\"]", "/surfaces/0/measured/joint_ecr_ohm_m2/0: type"},
        {"0/surfaces/0/measured/models/cmy/rms_decades", NULL, "/surfaces/0/measured/models/cmy: required"},
        {"0/answers/0/value", "[]", "/answers/0/value: type"},
        {"0/limits/1/verdict", "\"fails\"", "/limits/1/verdict: enum"},
        {"1/direct/0/solutions/0/ecr_ohm_m2", "7", "/direct/0/solutions/0/ecr_ohm_m2: type"}};
    for (size_t f = 0; f < sizeof faults / sizeof *faults; f++) {
        char fault[TEXT] = "", names[TEXT], *rest = names + 2, *name;
        json_auto_t *copy = json_deep_copy(results[*faults[f][0] - '0']);
        json_t *at = copy;
        snprintf(names, sizeof names, "%s", faults[f][0]);
        while ((name = strsep(&rest, "/")) && rest)
            at = json_is_array(at) ? json_array_get(at, strtoul(name, NULL, 10)) : json_object_get(at, name);
        assert_int_equal(json_object_del(at, name), 0);
        if (faults[f][1])
            json_object_set_new(at, name, json_loads(faults[f][1], JSON_DECODE_ANY, NULL));
        assert_false(holds(schema, copy, "", fault));
        assert_string_equal(fault, faults[f][2]);
    }
}

/* The points as the file has them, 50 mN and 13.9 mohm the first; the ratio within its interval. */
TEST_CASE(measured_points_and_ratios)
{
    double modulus, area, load, resistance, ratio, low, high, p;
    assert_int_equal(json_unpack(results[0], "{s:{s:F,s:F}, s:[{s:{s:[F],s:[F]}}], s:{s:[{s:F,s:[F,F],s:F}]}}", "scene",
                                 "effective_modulus_Pa", &modulus, "nominal_area_m2", &area, "surfaces", "measured",
                                 "load_over_AnEp", &load, "joint_ecr_ohm_m2", &resistance, "comparison", "pairs",
                                 "ratio", &ratio, "ratio_95", &low, &high, "p", &p),
                     0);
    assert_near(load * modulus * area, 0.05, 1e-12);
    assert_near(resistance, 0.0139 * area, 1e-12);
    assert_true(low < ratio && ratio < 1 && ratio < high && (1 < high) == (p > 0.05));
}

/* The chart has the points of the leading model in data/contact.csv, and the measured ones; a module that prints them
 * stands for matplotlib. */
TEST_CASE(first_chart_is_drawn)
{
    if (!workspace_can_run(*state, "command -v python3 >/dev/null"))
        skip();
    workspace_write(*state, "matplotlib/pyplot.py",
                    "def loglog(x, y, style, label):\n"
                    "    print(label, style, *('%.17g %.17g' % point for point in zip(x, y)), sep='\\n')\n"
                    "def xlabel(text): pass\n"
                    "ylabel = savefig = xlabel\n"
                    "def legend(): pass\n");
    static const char command[] =
        "PYTHONPATH=. python3 " PROJECT_SOURCE "/docs/first_chart.py connector/results.json a.svg";
    char *at = workspace_shell(*state, command);
    struct table contact = workspace_table(*state, "connector/data/contact.csv");
    const char *surface = "";
    for (size_t r = 0; r < contact.rows; r++) {
        if (strcmp(table_text(&contact, r, "model"), "strip-plastic") != 0)
            continue;
        if (strcmp(table_text(&contact, r, "surface"), surface) != 0) { /* behind what was measured of the one before */
            surface = table_text(&contact, r, "surface");
            char *title = strstr(at, filled("%s\n-\n", surface));
            assert_non_null(title);
            at = strstr(title, "-\n") + 2;
        }
        assert_near(strtod(at, &at), table_number(&contact, r, "pressure_Pa"), 1e-14);
        assert_near(strtod(at, &at), table_number(&contact, r, "joint_ecr_ohm_m2"), 0);
    }
    at = strstr(workspace_shell(*state, command), ", measured\no\n");
    assert_non_null(at);
    assert_near(strtod(at + strlen(", measured\no\n"), &at), 5e4, 1e-14); /* 50 mN on 1 mm² */
}
