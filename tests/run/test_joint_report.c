/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gas, films, platings, heating and shape through the whole program: every number recomputed from others in data/. */
#include "base/number_format.h"
#include "contact/cmy.h"
#include "joint/gas.h"
#include "joint/heating.h"
#include "joint/joint.h"
#include "run/pipeline.h"

#include <jansson.h>

#define MATERIAL                                                                                                       \
    "material: {E: 50 GPa, nu: 0.3, Sy: 20 MPa, resistivity: 1.1e-7, conductivity: 60}\n"                              \
    "load: {from: 1e-7, to: 1e-2, points: 16}\ntolerance: 1e-12\n"                                                     \
    "models: [multiscale, corrected-persson, statistical, strip, cmy]\n"
#define JOINT                                                                                                          \
    "nominal_area: 2 mm2\ngap: {gas: helium, pressure: 0.5 atm, temperature: 320 K, accommodation: 0.5}\n"             \
    "film: 3e-13 ohm m2\nplating: {thickness: 0.8 um, resistivity: 2.2e-8 ohm m}\ncurrent: 20 A\n"

#define LOADS "load: {from: 1e-7, to: 1e-2, points: 5}\noperating_load: 1e-6\n"

static int place_setup(void **state)
{
    static struct directory place;
    place = directory_make();
    pipeline_rough(&place, "in/a.csv", 600, 1, 3);
    pipeline_rough(&place, "in/b.csv", 600, 2, 4);
    *state = &place;
    return 0;
}

/** The report of a scene. */
static char *report_on(const struct directory *place, const char *scene)
{
    pipeline_report(place, "in", "out", scene);
    return directory_read(place, "out/report.md");
}

/** The same of that material. */
static char *report_of(const struct directory *place, const char *more)
{
    return report_on(place, filled(MATERIAL "%s", more));
}

/** NaN: the cell is empty. */
static double number(const struct table *table, size_t row, const char *column)
{
    return *table_text(table, row, column) ? table_number(table, row, column) : NAN;
}

/** Both are equal numbers, or neither is a number. */
static void expect(double actual, double expected)
{
    if (isnan(actual) != !isfinite(expected))
        fail_msg("%g for %g", actual, expected);
    if (isfinite(expected))
        assert_near(actual, expected, 1e-10);
}

TEST_IN_PLACE(columns_follow_from_the_others)
{
    char *report = report_of(place, JOINT);
    struct table contact = directory_table(place, "out/data/contact.csv");
    const struct gas *helium = gas_named("helium");
    double jump_m = gas_jump_length(helium, 320, 0.5 * 101325, 0.5, 0.5);
    size_t gaps = 0, equal = 0, own = 0, plated = 0, hot = 0;
    for (size_t i = 0; i < contact.rows; i++) {
        double area = number(&contact, i, "area_ratio"), y = number(&contact, i, "separation_m"),
               sigma_m = y / number(&contact, i, "separation_over_sigma"), ecr = number(&contact, i, "ecr_ohm_m2"),
               tcr = number(&contact, i, "tcr_K_m2_per_W"), a = number(&contact, i, "spot_radius_m"),
               n = number(&contact, i, "spots_per_m2"), voltage = number(&contact, i, "contact_voltage_V");
        if (isfinite(y) && y != 0) {
            double h = gas_conductance(gas_conductivity(helium, 320), sigma_m, y, jump_m, area, 1e-13);
            expect(number(&contact, i, "gap_W_per_m2K"), h);
            expect(number(&contact, i, "joint_W_per_m2K"), h + 1 / tcr);
            gaps++;
        } else if (isnan(y)) {
            expect(number(&contact, i, "gap_W_per_m2K"), NAN);
            expect(number(&contact, i, "joint_W_per_m2K"), NAN);
        }
        if (!model_rows[model_named(table_text(&contact, i, "model"))]->spots) {
            expect(a, area < 0.1 ? 2 * area * ecr / (M_PI * 1.1e-7) : NAN);
            expect(n, area < 0.1 ? area / (M_PI * a * a) : NAN);
            equal += area < 0.1;
        } else {
            own += fabs(a / joint_equal_spots(fmin(area, 0.099), ecr, 1.1e-7).radius_m - 1) > 0.01; /* its own */
        }
        double factor =
            area < 0.1 && isfinite(a) ? (2.2e-8 * plating_factor(0.8e-6 / a, 2.2e-8, 1.1e-7) + 1.1e-7) / 2.2e-7 : NAN;
        expect(number(&contact, i, "plating_factor"), factor);
        double joint = (ecr > 0 ? ecr * factor : ecr) + 3e-13 / area; /* of full contact the film alone */
        expect(number(&contact, i, "joint_ecr_ohm_m2"), joint);
        expect(voltage, 20 * joint / 2e-6);
        expect(number(&contact, i, "contact_temperature_K"),
               sqrt(320. * 320 + voltage * voltage / (4 * heating_lorenz_number())));
        plated += isfinite(factor) ? 1 : 0;
        hot += voltage > 1e-3;
    }
    assert_true(gaps > 100 && equal > 50 && own > 30 && plated > 80 && hot > 10);
    expect_parts(report, "## The joint", "helium at 50.7 kPa and 320 K", "The film has 3.00·10⁻¹³ Ω·m²",
                 "The plating is 0.800 µm", "](figures/joint.svg)");
    expect_no_parts(report, "nan");
    expect_in_file(place, "out/results.json", "\"gap\": \"helium\"", "\"gap_pressure_Pa\": 50662.5",
                   "\"temperature_K\": 320", "\"plated_sides\": 1", "\"current_A\": 20", "\"joint_ecr_ohm_m2\": [");
}

/** Without keys of the joint there is no column, chart or section; each key brings only its own. */
TEST_IN_PLACE(nothing_that_is_not_called_for)
{
    char *report = report_of(place, "");
    char *plain = directory_read(place, "out/data/contact.csv");
    expect_no_parts(report, "## The joint", "joint.svg");
    expect_no_parts(plain, "spot", "joint");
    static const struct {
        const char *scene, *columns;
    } rows[] = {
        {"gap: {gas: vacuum}\n", ",gap_W_per_m2K,joint_W_per_m2K,gap_m\n"},
        {"film: 0\n", ",spots_per_m2,spot_radius_m,joint_ecr_ohm_m2,gap_m\n"},
        {"effects: [electrical]\nplating: {thickness: 1 nm, resistivity: 2e-8, sides: both}\n",
         ",ecr_ohm_m2,spots_per_m2,spot_radius_m,plating_factor,joint_ecr_ohm_m2\n"},
        {"current: 1 mA\nnominal_area: 1 cm2\n",
         ",spots_per_m2,spot_radius_m,contact_voltage_V,contact_temperature_K,gap_m\n"},
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        report = report_of(place, rows[k].scene);
        expect_parts(report, "## The joint");
        expect_no_parts(report, "nan");
        expect_in_file(place, "out/data/contact.csv", rows[k].columns);
    }
    /* what the models say is what they said without */
    report_of(place, JOINT);
    struct table with = directory_table(place, "out/data/contact.csv");
    directory_write(place, "plain.csv", plain);
    struct table without = directory_table(place, "plain.csv");
    assert_int_equal(with.rows, without.rows);
    for (size_t i = 0; i < with.rows; i++)
        assert_string_equal(table_text(&with, i, "ecr_ohm_m2"), table_text(&without, i, "ecr_ohm_m2"));
}

/** A surface's quantity in results.json, by the leading model at the operating load. */
static const json_t *known(const json_t *results, size_t surface, const char *quantity)
{
    const char *leading = json_string_value(json_object_get(results, "leading"));
    const json_t *known =
        json_at(results, filled("surfaces/%zu/models/%s/at_middle_load/%s", surface, leading, quantity));
    if (!known)
        fail_msg("nothing is known of %s", quantity);
    return known;
}

/** An end of its 95 % interval over its value. */
static double end_of(const json_t *results, size_t surface, const char *quantity, size_t side)
{
    const json_t *own = known(results, surface, quantity);
    return json_number_at(own, side ? "mean_95/1" : "mean_95/0") / json_number_at(own, "mean");
}

static json_t *results_of(const struct directory *place, const char *scene)
{
    report_on(place, scene);
    return directory_json(place, "out/results.json");
}

/* The joint's interval comes from what dominates it: with a thick film that of the area; without film that of the
 * resistance; in vacuum that of TCR; with a thick bond line none. For one scan and for three, by two models. */
TEST_IN_PLACE(intervals_hold_all_that_scatters)
{
    static const char *const models[] = {"strip", "corrected-persson"};
    static const struct {
        const char *more, *quantity, *same; /* NULL: no scatter */
        bool inverse;
    } rows[] = {
        {"film: 1e-3\n", "joint_ecr_ohm_m2", "area_ratio", true},
        {"film: 0\n", "joint_ecr_ohm_m2", "ecr_ohm_m2", false},
        {"film: 0\ncurrent: 1 A\n", "contact_voltage_V", "ecr_ohm_m2", false},
        {"gap: {gas: vacuum}\n", "joint_W_per_m2K", "tcr_K_m2_per_W", true},
        {"gap: {conductivity: 1e4, bond_line: 1 mm}\n", "joint_W_per_m2K", NULL, false},
    };
    static const double size[] = {1, 1, 1.5, 2};
    for (unsigned long i = 0; i < 4; i++)
        pipeline_rough(place, filled("short-%lu.csv", i), 256, size[i], i + 3);
    for (size_t k = 0; k < 2 * sizeof rows / sizeof *rows; k++) {
        size_t row = k / 2;
        json_t *results = results_of(
            place, filled("material: {E: 50 GPa, nu: 0.3, resistivity: 1.1e-7, conductivity: 60}\nnominal_area: 2 mm2\n"
                          "load: {from: 1e-6, to: 1e-4, points: 5}\nmodels: [%s]\n%s"
                          "effects: [separation, electrical, thermal, uncertainty]\n"
                          "surfaces: [{name: a, file: [../short-0.csv, ../short-1.csv, ../short-2.csv]}, {name: b, "
                          "file: ../short-3.csv}]\n",
                          models[k % 2], rows[row].more));
        for (size_t surface = 0; surface < 2; surface++)
            for (size_t side = 0; side < 2; side++) {
                double own = rows[row].same ? end_of(results, surface, rows[row].quantity, side) : 1;
                double other = 1;
                if (rows[row].same)
                    other = end_of(results, surface, rows[row].same, rows[row].inverse ? !side : side);
                else
                    assert_within(json_number_at(known(results, surface, rows[row].quantity), "standard_error"), 0,
                                  0.01); /* 1/TCR beside it is next to nothing */
                assert_near(own, rows[row].inverse ? 1 / other : other, 1e-6);
                assert_true(!rows[row].same || fabs(log(own)) > 0.1);
            }
    }
}

/* With film and constriction equally large, limits use the same interval as the page and results.json. */
TEST_IN_PLACE(limits_go_by_the_interval_of_the_page)
{
    pipeline_rough(place, "in/a2.csv", 600, 1, 5);
    pipeline_rough(place, "in/a3.csv", 600, 1.5, 6);
    json_t *results = results_of(
        place, "material: bronze\nnominal_area: 2 mm2\nmodels: [strip]\nload: {from: 1e-6, to: 1e-4, points: 5}\n"
               "effects: [plasticity, electrical, uncertainty]\nfilm: 1e-13\n"
               "plating: {thickness: 0.8 um, resistivity: 5e-8}\ncurrent: 30 A\n"
               "targets: [{ecr: 1 mohm}]\nlimits: {ecr: {most: 1 mohm}, temperature: {most: 400 K}}\n"
               "surfaces: [{name: a, file: [a.csv, a2.csv, a3.csv]}, {name: b, file: b.csv}]\n");
    json_t *view = directory_json(place, "out/view.json");
    for (size_t surface = 0; surface < 2; surface++) {
        const json_t *ecr = json_at(results, filled("limits/%zu/interval_95", 2 * surface)),
                     *heat = json_at(results, filled("limits/%zu/interval_95", 2 * surface + 1));
        assert_true(json_equal(ecr, json_at(known(results, surface, "joint_ecr_ohm_m2"), "mean_95")));
        char shown[2][40];
        for (size_t side = 0; side < 2; side++) {
            double end = json_number_value(json_array_get(ecr, side)), volts = 30 * end / 2e-6;
            struct text *number = support_text();
            assert_near(json_number_value(json_array_get(heat, side)),
                        sqrt(300. * 300 + volts * volts / (4 * heating_lorenz_number())), 1e-9);
            number_format(number, end / 2e-6 * 1e3, 2);
            snprintf(shown[side], sizeof shown[side], "%s", text_string(number));
        }
        const char *interval = json_string_value(json_at(view, filled("rows/%zu/value/interval", surface)));
        assert_non_null(interval);
        expect_parts(interval, shown[0], shown[1]);
    }
    unlink(directory_path(place, "in/a2.csv"));
    unlink(directory_path(place, "in/a3.csv"));
}

/** The hardness of the first surface. */
static double hardness_of(const json_t *results)
{
    double own = json_number_at(results, "surfaces/0/hardness_Pa");
    return isnan(own) ? json_number_at(results, "scene/hardness_Pa") : own;
}

/* A plating thicker than the indents are deep gives the hardness, and the page says which hardness is used. */
TEST_IN_PLACE(a_plating_has_its_hardness)
{
#define BRONZE "material: bronze\nmodels: [corrected-persson]\nnominal_area: 1 mm2\noperating_load: 1 N\nbaseline: a\n"
    const double bronze_Pa = material_hardness(material_find("bronze"));
    const struct {
        const char *more;
        double hardness_Pa;
        const char *said; /* NULL: nothing of a plating's hardness */
    } rows[] = {
        {"plating: {metal: tin, thickness: 20 um}\n", 100e6,
         "- The hardness of a and b is the plating's, 100\u00a0MPa."},
        {"plating: {metal: tin, thickness: 1 nm}\n", bronze_Pa, "- The hardness of a and b is the softer body's, "},
        {"plating: {metal: tin, thickness: 20 um}\nhardness: 900 MPa\n", 900e6,
         "- The hardness of a and b is the scene's, 900"},
        {"plating: {metal: hard gold, thickness: 20 um}\n", 1.667e9,
         "- The hardness of a and b is the plating's, 1667"},
        {"counterface: same\nplating: {metal: hard gold, thickness: 20 um}\n", bronze_Pa,
         "- The hardness of a and b is the softer body's, "},
        {"counterface: same\nplating: {metal: hard gold, thickness: 20 um, sides: both}\n", 1.667e9,
         "- The hardness of a and b is the plating's, 1667"},
        {"plating: {resistivity: 1e-7, thickness: 20 um}\n", bronze_Pa,
         "- The hardness of a and b is the softer body's, "},
        {"film: 0\n", bronze_Pa, NULL},
    };
    double area[2] = {0};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        json_t *results = results_of(place, filled(BRONZE "%s", rows[k].more));
        char *page = directory_read(place, "out/report.md");
        *strstr(page, "\n---\n") = '\0';
        assert_near(hardness_of(results), rows[k].hardness_Pa, 1e-12);
        if (rows[k].said)
            expect_parts(page, rows[k].said);
        else
            expect_no_parts(page, "The hardness of");
    }
    const json_t *thick = results_of(place, BRONZE "plating: {metal: tin, thickness: 20 um}\nexport: comsol\n");
    expect_in_file(place, "out/export/a.comsol.txt", "\n% Hc 100000000[Pa] hardness\n");
    const struct cmy surface = {json_number_at(thick, "surfaces/0/sigma_m"),
                                json_number_at(thick, "surfaces/0/mean_slope")};
    const double indent_um = 1e6 * cmy_indent_m(&surface, 0.01); /* 1 MPa on 100 MPa */
    for (int side = 0; side < 2; side++) {                       /* on either side of that depth */
        const char *plating =
            filled(BRONZE "plating: {metal: tin, thickness: %g um}\n", indent_um * (side ? 1.02 : 0.98));
        assert_near(hardness_of(results_of(place, plating)), side ? 100e6 : bronze_Pa, 1e-12);
    }
    for (int given = 0; given < 2; given++) { /* as if the scene gave it */
        report_on(place,
                  filled(BRONZE "plating: {metal: tin, thickness: 20 um}\n%s", given ? "hardness: 100 MPa\n" : ""));
        struct table contact = directory_table(place, "out/data/contact.csv");
        for (size_t i = 0; i < contact.rows; i++)
            area[given] += number(&contact, i, "area_ratio");
    }
    assert_near(area[0], area[1], 1e-12);
    for (int k = 1; k < JOINT_PLATINGS; k++) {
        assert_true(joint_platings[k].hardness_Pa > 1e7 && joint_platings[k].hardness_Pa < 1e10);
        expect_parts(joint_platings[k].source, "hardness: ");
    }
}

/* A shape that is flat gives the numbers of flat parts; the more the parts bulge, the less area carries the load and
 * the less the joint conducts. */
TEST_IN_PLACE(shape_of_the_parts)
{
    static const char *const shapes[] = {"{crown: 1e9 m}", "{flatness: 1 um, over: 20 mm}",
                                         "{flatness: 3 um, over: 20 mm}", "{flatness: 9 um, over: 20 mm}"};
    static const char *const names[][2] = {{"shape_W_per_m2K", "joint_W_per_m2K"},
                                           {"shape_ecr_ohm_m2", "joint_ecr_ohm_m2"}};
    struct table before = {0};
    double carried_mm2 = 400;
    size_t compared = 0;
    for (size_t k = 0; k < sizeof shapes / sizeof *shapes; k++) {
        char *page = report_on(
            place, filled("material: copper\ncounterface: aluminium\nnominal_area: 400 mm2\nshape: %s\n"
                          "load: {from: 1 bar, to: 100 bar, points: 5}\noperating_load: 10 bar\ntolerance: 1e-12\n"
                          "models: [strip]\nbaseline: a\ngap: {gas: air}\nfilm: 1e-14\n"
                          "targets: [{conductance: 1e4 W/m2/K}]\nsurfaces: [{name: a, file: a.csv}]\n",
                          shapes[k]));
        struct table contact = directory_table(place, "out/data/contact.csv");
        size_t known[2] = {0};
        for (size_t i = 0; i < contact.rows; i++)
            for (int way = 0; way < 2; way++) {
                double value = number(&contact, i, names[way][0]), flat = number(&contact, i, names[way][1]);
                if (!isfinite(value))
                    continue;
                known[way]++;
                if (k == 0)
                    assert_near(value, flat, 1e-12);
                else if (isfinite(number(&before, i, names[way][0])))
                    assert_true((value < number(&before, i, names[way][0])) == (way == 0));
            }
        assert_true(known[0] >= contact.rows / 2 && known[1] >= contact.rows / 2);
        const char *factor = strstr(page, "the scene has 'shape'; conductance × ");
        for (size_t i = 0; i < contact.rows && k > 1; i++) /* what the list of effects says, to two digits */
            if (fabs(number(&contact, i, "pressure_Pa") / 1e6 - 1) < 1e-9 &&
                strcmp(table_text(&contact, i, "model"), "strip-plastic") == 0) {
                assert_non_null(factor);
                assert_near(strtod(factor + strlen("the scene has 'shape'; conductance × "), NULL),
                            number(&contact, i, names[0][0]) / number(&contact, i, names[0][1]), 0.045);
                compared++;
            }
        const char *said = strstr(page, "- Of 400\u00a0mm², ");
        assert_non_null(said);
        double carries_mm2 = strtod(said + strlen("- Of 400\u00a0mm², "), NULL);
        assert_true(carries_mm2 > 0 && carries_mm2 < carried_mm2);
        carried_mm2 = carries_mm2;
        before = contact;
    }
    assert_int_equal(compared, sizeof shapes / sizeof *shapes - 2);
}

/* If the shape has no solution, a note says at which load and what to do; else there is no note. */
TEST_IN_PLACE(a_shape_without_an_answer)
{
    static const struct {
        const char *more, *said;
    } rows[] = {
        {"shape: {crown: 1 mm}\n", "no shape with JG: at 0.098 MPa its pressures do not converge; narrow 'load', or "
                                   "correct 'shape'\n"},
        {"shape: {flatness: 9 um, over: 20 mm}\nhardness: 2 MPa\n",
         "no shape with JG: from 0.098 MPa on over 5 % of the load lies where 'shape' presses at the hardness; begin "
         "'load' lower, or correct 'shape' or 'hardness'\n"},
        {"shape: {flatness: 3 um, over: 20 mm}\n", NULL},
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        char *page =
            report_on(place, filled("material: copper\ncounterface: aluminium\nnominal_area: 400 mm2\nmodels: [jg]\n"
                                    "load: {from: 1 bar, to: 100 bar, points: 7}\noperating_load: 10 bar\n%s"
                                    "surfaces: [{name: a, file: a.csv}]\n",
                                    rows[k].more));
        assert_int_equal(strstr(page, "no shape with") != NULL, rows[k].said != NULL);
        if (rows[k].said)
            expect_parts(page, rows[k].said);
    }
}

/* A shape given as a map of heights has the same numbers. Uniform pressures, however given, have those of flat parts.
 * Pressures on shares of the area without place leave out the way to the spots. */
TEST_IN_PLACE(shape_from_files)
{
    static const char *const shapes[] = {
        "{flatness: 3 um, over: 20 mm}", "{height: ../m.csv}",
        "{pressure: ../p.csv}",          "{pressure: ../rows.csv}",
        "{pressure: ../two.csv}",        "{flatness: 3 um, over: 20 mm, thickness: [1 mm, 1 mm]}"};
    struct text *map = support_text();
    double bulged = NAN, flat = NAN;
    text_add(map, "x [mm],y [mm],z [um]\n");
    for (int k = 0; k < 41 * 41; k++)
        text_add(map, "%g,%g,%.17g\n", k % 41 * 0.5, k / 41 * 0.5,
                 -3 * (pow(k % 41 - 20., 2) + pow(k / 41 - 20., 2)) / 400);
    directory_write(place, "m.csv", text_string(map));
    directory_write(place, "p.csv", "x [mm], y [mm], p [bar]\n0,0,10\n20,0,10\n0,20,10\n20,20,10\n");
    directory_write(place, "rows.csv", "A [mm2], p [MPa]\n300, 1\n100, 1\n");
    directory_write(place, "two.csv", "A [mm2], p [MPa]\n200, 1.9\n200, 0.1\n");
    for (size_t k = 0; k < sizeof shapes / sizeof *shapes; k++) {
        char *page = report_on(
            place, filled("material: copper\ncounterface: aluminium\nnominal_area: 400 mm2\nshape: %s\n"
                          "load: {from: 1 bar, to: 100 bar, points: 5}\noperating_load: 10 bar\ntolerance: 1e-12\n"
                          "models: [corrected-persson]\nbaseline: a\ngap: {gas: vacuum}\n"
                          "surfaces: [{name: a, file: a.csv}]\n",
                          shapes[k]));
        struct table contact = directory_table(place, "out/data/contact.csv");
        size_t middle = contact.rows / 2;
        double value = number(&contact, middle, "shape_W_per_m2K"),
               uniform = number(&contact, middle, "joint_W_per_m2K");
        assert_true(isfinite(value) && isfinite(uniform));
        bulged = k == 0 ? value : bulged;
        flat = uniform;
        if (k == 1)
            assert_near(value, bulged, 5e-3);
        else if (k == 5) /* heat has less of a way to come together */
            assert_true(value > 1.05 * bulged && value < flat);
        else if (k == 4) /* h grows with nearly the load: halves of it are nearly the whole */
            assert_true(value < 0.999 * flat && value > 0.9 * flat);
        else if (k > 1)
            assert_near(value, flat, 1e-12);
        char *script = directory_read(place, "out/figures/joint.gp");
        assert_true(!strstr(script, "Pressure at the operating load") == (k == 3 || k == 4)); /* there is no middle */
        expect_parts(script, "with the shape", "flat parts");
        char *drawn = directory_read(place, "out/figures/joint.csv"); /* 1 MPa in the middle and at the corners */
        assert_true(!strstr(drawn, "\n0.147313913,1\n") == (k != 2));
        assert_true(!strstr(drawn, "\n13.9948217,1\n") == (k != 2));
        assert_true(!strstr(page, "The resistance of the way to the spots is left out") == (k < 3 || k == 5));
        assert_true(!strstr(page, "The pressures grow with the load") == (k < 2 || k == 5));
    }
}

/** The appendix's table to paste, to four digits, from data/ at the operating load; its hardness is empty without one.
 */
TEST_IN_PLACE(to_paste)
{
    const char *tail = "gap: {gas: air}\nload: {values: [1e-6, 1e-5, 1e-4]}\noperating_load: 1e-5\n"
                       "models: [corrected-persson]\neffects: [separation, thermal, gap]\n"
                       "surfaces: [{name: a, file: a.csv}]\n";
    static const char *const bodies[] = {"{E: 50 GPa, nu: 0.3, Sy: 20 MPa, conductivity: 60}",
                                         "{E: 50 GPa, nu: 0.3, conductivity: 60}"};
    for (int k = 0; k < 2; k++) {
        pipeline_report(place, "in", "out", filled("material: %s\n%s", bodies[k], tail));
        char *report = directory_read(place, "out/report.md");
        struct table contact = directory_table(place, "out/data/contact.csv");
        struct table scalars = directory_table(place, "out/data/surfaces.csv");
        const char *row = strstr(report, "# Appendices");
        row = strstr(row, "## To paste into");
        assert_true(row && (row = strstr(row, "\n| a |")));
        double modulus_Pa = 50e9 / (1 - 0.09), shown[6] = {0};
        row += strlen("\n| a |");
        for (int c = 0; c < 6; c++) {
            char *end;
            shown[c] = strtod(row, &end);
            shown[c] = end == row ? NAN : shown[c];
            row = strchr(row, '|') + 1;
        }
        assert_near(shown[0], 1e6 * number(&scalars, 0, "rq_m"), 1e-3);
        assert_near(shown[1], sqrt(2 * number(&scalars, 0, "m2") / M_PI), 1e-3);
        if (k == 0)
            assert_near(shown[2], 2.84 * 0.02, 1e-3);
        assert_true(isnan(shown[2]) == (k == 1));
        assert_near(shown[3], 1e-5 * modulus_Pa * 1e-6, 1e-3);
        for (size_t i = 0; i < contact.rows; i++)
            if (number(&contact, i, "load_over_AnEp") == 1e-5) {
                assert_near(shown[4], 1 / number(&contact, i, "tcr_K_m2_per_W"), 1e-3);
                assert_near(shown[5], 1e-6 * number(&contact, i, "joint_W_per_m2K"), 1e-3);
            }
    }
}

/** "Flatness counts" states the same factor that a shape of that flatness gives. Without area, with a shape, or with
 * little effect, it is not said. */
TEST_IN_PLACE(flatness_that_is_not_given)
{
    static const char said[] = " would multiply the resistance by ", effect[] = "the scene has 'shape'; conductance × ";
    static const char *const silent[] = {"", "nominal_area: 1e-3 mm2\n",
                                         "nominal_area: 4 cm2\nshape: {flatness: 5 um, over: 20 mm}\n"};
    const char *rest = "material: copper\ncounterface: aluminium\nload: {from: 1 bar, to: 500 bar, points: 16}\n"
                       "operating_load: 10 bar\nmodels: [corrected-persson]\ngap: {gas: vacuum}\n"
                       "targets: [{conductance: 1e4 W/m2/K}]\nsurfaces: [{name: a, file: a.csv}]\n";
    char *report = report_on(place, filled("nominal_area: 4 cm2\n%s", rest));
    expect_parts(report, "**Flatness counts:** 2.0");
    const char *found = strstr(report, said);
    assert_non_null(found);
    double factor = strtod(found + strlen(said), NULL);
    report = report_on(place, filled("nominal_area: 4 cm2\nshape: {flatness: 2 um, over: 20 mm}\n%s", rest));
    found = strstr(report, effect);
    assert_non_null(found);
    assert_near(factor, 1 / strtod(found + strlen(effect), NULL), 0.05);
    for (size_t i = 0; i < sizeof silent / sizeof *silent; i++) {
        report = report_on(place, filled("%s%s", silent[i], rest));
        assert_null(strstr(report, "Flatness counts"));
    }
}

/** Vacuum conducts nothing, and a film of 0 adds nothing; the report says what is in the joint. */
TEST_IN_PLACE(sentences)
{
    expect_no_parts(report_of(place, "gap: {gas: argon, pressure: 0}\n"), "argon at");
    char *report = report_of(place, "gap: {gas: vacuum}\nfilm: 0\n");
    struct table contact = directory_table(place, "out/data/contact.csv");
    for (size_t i = 0; i < contact.rows; i++) {
        double h_g = number(&contact, i, "gap_W_per_m2K"), film = number(&contact, i, "joint_ecr_ohm_m2");
        assert_true(isnan(h_g) || h_g == 0);
        assert_true(isnan(film) || film == number(&contact, i, "ecr_ohm_m2"));
    }
    expect_parts(report, "The gaps are empty and carry no heat.\nRadiation would");
    expect_no_parts(report, "of the heat", "matters more than");
    static const struct {
        const char *scene, *says;
    } rows[] = {
        {"material: tin\ngap: {conductivity: 0.8}\n", ": no bond_line: the filler is taken as thin as the gaps"},
        {"material: tin\ngap: {filler: pad, bond_line: 100 um}\n",
         "The gaps are filled with pad of 1.00 W/(m·K), at least 100 µm thick."},
        {"material: tin\ngap: {liquid: water, temperature: 350 K}\n",
         "The gaps are filled with water of 0.668 W/(m·K)."},
        {"material: tin\ngap: {gas: SF6}\n", "Gaps are filled with SF6 at 101 kPa and 300 K."},
        {"material: tin\ngap: {gas: air, temperature: 400 K}\n",
         "Radiation would add at most 15 W/(m²·K) and is left out."},
        {"material: tin\nplating: {thickness: 9 um, metal: hard gold}\n",
         ": 9 um of hard gold, of which 0.5 to 1.3 um are usual"},
        {"material: tin\nplating: {thickness: 2 um, resistivity: 1e-8}\n", "The plating is 2.00 µm."},
        {"material: tin\nfilm: 1e-3 ohm m2\n", "The film has 0.00100 Ω·m²."},
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        report = report_on(place, filled("models: [strip]\n" LOADS "%s", rows[k].scene));
        expect_parts(strstr(report, "## The joint"), rows[k].says);
    }
}

/** Limits and targets name the film and plating they include, and say if they are met only outside the loads. */
TEST_IN_PLACE(what_is_in_the_answer)
{
    static const struct {
        const char *key, *says, *unsaid;
    } rows[] = {
        {"film: 1e-9 ohm m2\n", "film", "plating"},
        {"plating: {thickness: 2 um, resistivity: 1e-8}\n", "plating", "film"},
        {"film: 1e-9 ohm m2\nplating: {thickness: 2 um, resistivity: 1e-8}\n", "film and plating", "between them"},
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        char *report =
            report_on(place, filled("material: tin\nmodels: [strip, cmy]\nnominal_area: 1 mm2\n"
                                    "load: {from: 1 N, to: 30 N, points: 5}\n"
                                    "targets: [{ecr: 1 ohm}, {ecr: 1 nohm}]\nlimits: {ecr: {most: 1 ohm}}\n%s",
                                    rows[k].key));
        *strstr(report, "\n---\n") = '\0';
        expect_parts(report, " | ≤ 1\u00a0Ω | ", "✓ met",
                     filled("\n- ECR with %s 1\u00a0nΩ is not reached at the loads of this report.\n", rows[k].says),
                     "*a* needs at most 1.00\u00a0N");
        expect_no_parts(report, rows[k].unsaid);
    }
}

/** If a bond line keeps the metals apart, the page says nothing of spots, their uncertainty, or the load; numbers and
 * verdicts are the filler's. With a thin bond line the page says it all. */
TEST_IN_PLACE(a_bond_line_that_keeps_the_metals_apart)
{
    static const char *const of_spots[] = {
        "**Uncertainty", "longest waves", "**Textbook", "Few metal spots", "bears more than the hardness",
        "widen `load`"};
    for (int thick = 0; thick < 2; thick++) {
        char *report = report_on(
            place, filled(LOADS "material: tin\nnominal_area: 400 mm2\neffects: [separation, electrical, thermal, "
                                "plasticity, uncertainty, gap, plating]\n"
                                "plating: {thickness: 1 mm, resistivity: 1e-8}\n"
                                "gap: {filler: silicone grease, bond_line: %s}\n"
                                "targets: [{conductance: 9e8 W/m2/K}, {ecr: 1 nohm}]\n"
                                "limits: {conductance: {least: 3.3e4 W/m2/K}}\n",
                          thick ? "25 um" : "1 nm"));
        bool said = false;
        for (size_t k = 0; k < sizeof of_spots / sizeof *of_spots; k++) {
            said = said || strstr(report, of_spots[k]);
            if (thick)
                expect_no_parts(report, of_spots[k]);
        }
        assert_true(said != thick);
        struct table contact = directory_table(place, "out/data/contact.csv");
        for (size_t i = 0; i < contact.rows && thick; i++) {
            assert_near(number(&contact, i, "joint_W_per_m2K"), 0.8 / 25e-6, 1e-12);
            assert_near(number(&contact, i, "gap_W_per_m2K"), 0.8 / 25e-6, 1e-12);
            assert_near(number(&contact, i, "separation_m"), 25e-6, 1e-12);
            assert_true(number(&contact, i, "area_ratio") == 0 && isnan(number(&contact, i, "ecr_ohm_m2")) &&
                        isnan(number(&contact, i, "tcr_K_m2_per_W")) && isnan(number(&contact, i, "spots_per_m2")));
        }
        if (thick)
            expect_parts(report, "no load is known for *a*", "**The filler carries all heat:** its 25.0\u00a0µm keep",
                         "| – | 3.20·10⁴ | ✗ missed |",
                         "- gap: the scene has 'gap'\n"); /* no factor: it holds the metals */
        else
            expect_no_parts(report, "The filler carries all heat", "- gap: the scene has 'gap'\n");
    }
}

/** Load flattens the parts, also if a bond line fixes the gap: targets are then found between the loads of the curve,
 * but none above the conductance of flat parts. */
TEST_IN_PLACE(a_bond_line_between_parts_that_are_not_flat)
{
    static const char with[] = "load: {from: 1e-7, to: 3e-4, points: 9}\noperating_load: 1e-6\nmaterial: tin\n"
                               "models: [cmy]\nnominal_area: 4 cm2\nshape: {flatness: 2 um, over: 20 mm}\n"
                               "surfaces: [{name: a, file: a.csv}]\n"
                               "gap: {filler: silicone grease, bond_line: %.17g m}\n%s";
    enum { CROSSED = 4, LAST = 7 };
    (void)report_on(place, filled(with, 1e-9, ""));
    struct table bare = directory_table(place, "out/data/contact.csv");
    double gap_m = number(&bare, CROSSED, "separation_m"), shape[2], loads[2];
    (void)report_on(place, filled(with, gap_m, ""));
    struct table contact = directory_table(place, "out/data/contact.csv");
    for (size_t k = 0; k < 2; k++) {
        shape[k] = number(&contact, LAST - 1 + k, "shape_W_per_m2K");
        loads[k] = number(&contact, LAST - 1 + k, "load_over_AnEp");
        assert_near(number(&contact, LAST - 1 + k, "separation_m"), gap_m, 1e-12);
    }
    double flat = number(&contact, LAST, "joint_W_per_m2K"), asked = (shape[0] + shape[1]) / 2;
    assert_true(shape[1] > shape[0] * (1 + 1e-6) && flat > shape[1]);
    expect_in_file(place, "out/report.md", "- shape: the scene has 'shape'; conductance");
    char *even = report_on(place, filled(with, 1e-4, "")); /* what fills the gaps evenly conducts so on any shape */
    expect_parts(even, "- shape: the scene has 'shape'; conductance changes by 0 %");
    (void)report_on(place, filled(with, gap_m,
                                  filled("targets: [{conductance: %.9g W/m2/K}, {conductance: %.9g W/m2/K}]\n", asked,
                                         1.01 * flat)));
    struct table answers = directory_table(place, "out/data/answers.csv");
    double load = number(&answers, 0, "load_over_AnEp");
    assert_true(load > loads[0] * 1.01 && load < loads[1] / 1.01);
    assert_string_equal(table_text(&answers, 1, "note"),
                        "no load reaches it: the gap stays at the bond line of the filler");
}

/** All models but CMY take the hardness of CMY's spots at the operating load. */
TEST_IN_PLACE(one_hardness_for_the_others)
{
    char *report = report_of(place, "film: 0\nnominal_area: 1 mm2\noperating_load: 1e-6\n"
                                    "hardness: {c1: 60 MPa, c2: -0.2}\n");
    struct table contact = directory_table(place, "out/data/contact.csv");
    size_t checked = 0;
    for (size_t i = 0; i < contact.rows; i++)
        if (strcmp(table_text(&contact, i, "model"), "cmy") == 0 && number(&contact, i, "load_over_AnEp") == 1e-6) {
            double hardness_MPa = 60 * pow(sqrt(2 * M_PI) * number(&contact, i, "spot_radius_m") / 1e-6, -0.2);
            expect_parts(report, filled("H is %.4g MPa, that of CMY's spots at the operating load", hardness_MPa));
            checked++;
        }
    assert_int_equal(checked, 2);
}

TEST_GROUP(place_setup, directory_teardown)
