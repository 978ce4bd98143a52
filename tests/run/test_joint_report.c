/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gas in the gaps, films, platings and heating through the whole program: every number of the section and of its
 * columns from what else is in data/. */
#include "base/number_format.h"
#include "joint/gas.h"
#include "joint/heating.h"
#include "joint/joint.h"
#include "joint/plating.h"
#include "run/pipeline.h"

#define MATERIAL                                                                                                       \
    "material: {E: 50 GPa, nu: 0.3, Sy: 20 MPa, resistivity: 1.1e-7, conductivity: 60}\n"                              \
    "load: {from: 1e-7, to: 1e-2, points: 16}\ntolerance: 1e-12\n"                                                     \
    "models: [multiscale, corrected-persson, statistical, strip, cmy]\n"
#define JOINT                                                                                                          \
    "nominal_area: 2 mm2\ngap: {gas: helium, pressure: 0.5 atm, temperature: 320 K, accommodation: 0.5}\n"             \
    "film: 3e-13 ohm m2\nplating: {thickness: 0.8 um, resistivity: 2.2e-8 ohm m}\ncurrent: 20 A\n"

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
static struct text report_on(const struct directory *place, const char *scene)
{
    directory_write(place, "in/scene.yaml", scene);
    assert_int_equal(pipeline_run(place, "in", "out", 1), 0);
    return directory_read(place, "out/report.md");
}

/** The same of that material. */
static struct text report_of(const struct directory *place, const char *more)
{
    char scene[1024];
    snprintf(scene, sizeof scene, MATERIAL "%s", more);
    return report_on(place, scene);
}

/** NaN: the cell is empty. */
static double number(const struct table *table, size_t row, const char *column)
{
    return *table_text(table, row, column) ? table_number(table, row, column) : NAN;
}

/** As its rows are: equal where both are numbers, else neither is one. */
static void expect(double actual, double expected)
{
    if (isnan(actual) != !isfinite(expected))
        fail_msg("%g for %g", actual, expected);
    if (isfinite(expected))
        assert_near(actual, expected, 1e-10);
}

TEST_CASE(columns_follow_from_the_others)
{
    const struct directory *place = *state;
    struct text report = report_of(place, JOINT);
    struct table contact = directory_table(place, "out/data/contact.csv");
    const struct gas *helium = gas_find("helium");
    double jump_m = gas_jump_length(helium, 320, 0.5 * 101325, 0.5, 0.5);
    size_t gaps = 0, equal = 0, own = 0, plated = 0, hot = 0;
    for (size_t i = 0; i < contact.rows; i++) {
        double area = number(&contact, i, "area_ratio"), y = number(&contact, i, "separation_m"),
               sigma_m = y / number(&contact, i, "separation_over_sigma"), ecr = number(&contact, i, "ecr_ohm_m2"),
               tcr = number(&contact, i, "tcr_K_m2_per_W"), a = number(&contact, i, "spot_radius_m"),
               n = number(&contact, i, "spots_per_m2"), voltage = number(&contact, i, "contact_voltage_V");
        if (isfinite(y) && y != 0) {
            double h = gas_conductance(helium, sigma_m, y, jump_m, area, 1e-13);
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
        plated += isfinite(factor);
        hot += voltage > 1e-3;
    }
    assert_true(gaps > 100 && equal > 50 && own > 30 && plated > 80 && hot > 10);
    table_free(&contact);
    expect_parts(text_string(&report), "## The joint", "helium at 50.6625 kPa and 320 K, accommodation 0.5",
                 "A film of 3·10⁻¹³ Ω·m²", "The surface's side is plated, 0.8 µm of 2.2·10⁻⁸ Ω·m", "not of this metal");
    expect_parts(text_string(&report), "joint-conductance", "joint-gap", "joint-ecr", "joint-temperature");
    expect_no_parts(text_string(&report), "nan");
    text_free(&report);
    expect_in_file(place, "out/results.json", "\"gap\": \"helium\"", "\"gap_pressure_Pa\": 50662.5",
                   "\"temperature_K\": 320", "\"plated_sides\": 1", "\"current_A\": 20", "\"joint_ecr_ohm_m2\": [");
}

/** The table's cells against the row of contact.csv they come from, at the operating load. */
TEST_CASE(the_table_is_of_the_data)
{
    const struct directory *place = *state;
    struct text report = report_of(place, JOINT "operating_load: 1e-6\nbaseline: a\n");
    struct table contact = directory_table(place, "out/data/contact.csv");
    const char *section = strstr(text_string(&report), "## The joint"),
               *row = strstr(section, "\n| Gaussian heights |");
    assert_non_null(strstr(section, "Surface a at that load in every model"));
    assert_non_null(row);
    for (size_t i = 0, held = 0; i <= contact.rows; i++) {
        if (i == contact.rows) {
            assert_int_equal(held, 1);
            break;
        }
        double load = number(&contact, i, "load_over_AnEp");
        if (strcmp(table_text(&contact, i, "model"), "corrected-persson") != 0 ||
            strcmp(table_text(&contact, i, "surface"), "a") != 0 || fabs(load / 1e-6 - 1) > 0.5)
            continue;
        double h_g = number(&contact, i, "gap_W_per_m2K"), h_j = number(&contact, i, "joint_W_per_m2K"),
               joint = number(&contact, i, "joint_ecr_ohm_m2");
        const double cells[] = {1 / number(&contact, i, "tcr_K_m2_per_W"),
                                h_g,
                                h_j,
                                100 * h_g / h_j,
                                1e-6 * number(&contact, i, "spots_per_m2"),
                                1e6 * number(&contact, i, "spot_radius_m"),
                                number(&contact, i, "ecr_ohm_m2"),
                                number(&contact, i, "plating_factor"),
                                joint,
                                100 * 3e-13 / number(&contact, i, "area_ratio") / joint,
                                1e3 * number(&contact, i, "contact_voltage_V"),
                                number(&contact, i, "contact_temperature_K")};
        struct text expected = {0};
        for (size_t c = 0; c < sizeof cells / sizeof *cells; c++) {
            text_add(&expected, " | ");
            number_format(&expected, cells[c], 3);
        }
        const char *end = strchr(row + 1, '\n'), *found = strstr(row, text_string(&expected));
        if (!found || found > end)
            fail_msg("'%.*s' has not '%s'", (int)(end - row), row, text_string(&expected));
        text_free(&expected);
        held++;
    }
    table_free(&contact);
    text_free(&report);
}

/** Off: no column, chart, section, word; a key alone brings its own. */
TEST_CASE(nothing_that_is_not_called_for)
{
    const struct directory *place = *state;
    struct text report = report_of(place, "");
    struct text plain = directory_read(place, "out/data/contact.csv");
    expect_no_parts(text_string(&report), "## The joint", "joint-");
    expect_no_parts(text_string(&plain), "spot", "joint");
    text_free(&report);
    static const struct {
        const char *scene, *columns;
    } rows[] = {
        {"gap: {gas: vacuum}\n", ",gap_W_per_m2K,joint_W_per_m2K\n"},
        {"film: 0\n", ",spots_per_m2,spot_radius_m,joint_ecr_ohm_m2\n"},
        {"effects: [electrical]\nplating: {thickness: 1 nm, resistivity: 2e-8, sides: both}\n",
         ",ecr_ohm_m2,spots_per_m2,spot_radius_m,plating_factor,joint_ecr_ohm_m2\n"},
        {"current: 1 mA\nnominal_area: 1 cm2\n",
         ",spots_per_m2,spot_radius_m,contact_voltage_V,contact_temperature_K\n"},
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        report = report_of(place, rows[k].scene);
        expect_parts(text_string(&report), "## The joint");
        expect_no_parts(text_string(&report), "nan");
        expect_in_file(place, "out/data/contact.csv", rows[k].columns);
        text_free(&report);
    }
    /* what the models say is what they said without */
    report = report_of(place, JOINT);
    text_free(&report);
    struct table with = directory_table(place, "out/data/contact.csv");
    directory_write(place, "plain.csv", text_string(&plain));
    struct table without = directory_table(place, "plain.csv");
    assert_int_equal(with.rows, without.rows);
    for (size_t i = 0; i < with.rows; i++)
        assert_string_equal(table_text(&with, i, "ecr_ohm_m2"), table_text(&without, i, "ecr_ohm_m2"));
    table_free(&with);
    table_free(&without);
    text_free(&plain);
}

/** Vacuum carries nothing, no film adds nothing; tin says when it softens and melts. */
TEST_CASE(sentences)
{
    const struct directory *place = *state;
    struct text report = report_of(place, "gap: {gas: vacuum}\nfilm: 0\n");
    struct table contact = directory_table(place, "out/data/contact.csv");
    for (size_t i = 0; i < contact.rows; i++) {
        double h_g = number(&contact, i, "gap_W_per_m2K"), film = number(&contact, i, "joint_ecr_ohm_m2");
        assert_true(isnan(h_g) || h_g == 0);
        assert_true(isnan(film) || film == number(&contact, i, "ecr_ohm_m2"));
    }
    table_free(&contact);
    expect_parts(text_string(&report), "vacuum: the gaps carry no heat");
    expect_no_parts(text_string(&report), "What fills the gaps carries");
    text_free(&report);
    static const struct {
        const char *scene, *says;
    } rows[] = {
        {"material: tin\nnominal_area: 1 mm2\ncurrent: 1 uA\n", "below what its metal softens or melts at"},
        {"material: tin\nnominal_area: 1 mm2\ncurrent: 1 MA\n", "**its metal softens or melts** on 2 of 2 surfaces"},
        {"material: tin\nnominal_area: 1 mm2\ncurrent: 1 MA\n", " | melts |"},
        {"material: copper\ncounterface: tin\nnominal_area: 1 mm2\ncurrent: 1 uA\n", " | stays hard |"},
        {"material: copper\ncounterface: {E: 50 GPa, nu: 0.3, Sy: 1 MPa, resistivity: 1e-7}\nnominal_area: 1 mm2\n"
         "current: 1 uA\n",
         "not of this metal"},
        {"material: tin\ngap: {conductivity: 5000 W/m/K}\n", "**the finish matters more than the load**"},
        {"material: tin\ngap: {gas: air, pressure: 1 Pa}\n", "**the load matters more than what fills the gaps**"},
        {"material: tin\nplating: {thickness: 2 um, resistivity: 1e-8}\n", "The plating **helps**"},
        {"material: tin\nplating: {thickness: 2 um, resistivity: 1e-6}\n", "The plating **does not help**"},
        {"material: tin\nfilm: 1e-3 ohm m2\n", "The film is 100 % of the resistance"},
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        char scene[1024];
        snprintf(scene, sizeof scene, "load: {from: 1e-7, to: 1e-2, points: 5}\noperating_load: 1e-6\n%s",
                 rows[k].scene);
        report = report_on(place, scene);
        expect_parts(strstr(text_string(&report), "## The joint"), rows[k].says);
        text_free(&report);
    }
}

TEST_GROUP(place_setup, directory_teardown)
