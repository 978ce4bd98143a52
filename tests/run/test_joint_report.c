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

TEST_IN_PLACE(columns_follow_from_the_others)
{
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
    expect_parts(text_string(&report), "## The joint", "helium at 50.7 kPa and 320 K", "The film of 3.00·10⁻¹³ Ω·m²",
                 "The plating of 0.800 µm", "at what voltage this metal softens is not known", "](figures/joint.svg)");
    expect_no_parts(text_string(&report), "nan");
    text_free(&report);
    expect_in_file(place, "out/results.json", "\"gap\": \"helium\"", "\"gap_pressure_Pa\": 50662.5",
                   "\"temperature_K\": 320", "\"plated_sides\": 1", "\"current_A\": 20", "\"joint_ecr_ohm_m2\": [");
}

/** Off: no column, chart, section, word; a key alone brings its own. */
TEST_IN_PLACE(nothing_that_is_not_called_for)
{
    struct text report = report_of(place, "");
    struct text plain = directory_read(place, "out/data/contact.csv");
    expect_no_parts(text_string(&report), "## The joint", "joint.svg");
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
TEST_IN_PLACE(sentences)
{
    struct text report = report_of(place, "gap: {gas: vacuum}\nfilm: 0\n");
    struct table contact = directory_table(place, "out/data/contact.csv");
    for (size_t i = 0; i < contact.rows; i++) {
        double h_g = number(&contact, i, "gap_W_per_m2K"), film = number(&contact, i, "joint_ecr_ohm_m2");
        assert_true(isnan(h_g) || h_g == 0);
        assert_true(isnan(film) || film == number(&contact, i, "ecr_ohm_m2"));
    }
    table_free(&contact);
    expect_parts(text_string(&report), "The gaps are empty and carry no heat.");
    text_free(&report);
    static const struct {
        const char *scene, *says;
    } rows[] = {
        {"material: tin\nnominal_area: 1 mm2\ncurrent: 1 uA\n", ", and the metal does not soften."},
        {"material: tin\nnominal_area: 1 mm2\ncurrent: 1 MA\n", "**the metal softens or melts** on 2"},
        {"material: copper\ncounterface: tin\nnominal_area: 1 mm2\ncurrent: 1 uA\n",
         ", and the metal does not soften."},
        {"material: copper\ncounterface: {E: 50 GPa, nu: 0.3, Sy: 1 MPa, resistivity: 1e-7}\nnominal_area: 1 mm2\n"
         "current: 1 uA\n",
         "at what voltage this metal softens is not known"},
        {"material: tin\ngap: {conductivity: 5000 W/m/K}\n", "**the finish matters more than the load**"},
        {"material: tin\ngap: {conductivity: 0.8}\n", ": no bond_line: the filler is as thin as the gaps"},
        {"material: tin\ngap: {filler: pad, bond_line: 100 um}\n",
         "The gaps are filled with pad of 1.00 W/(m·K), at least 100 µm thick."},
        {"material: tin\ngap: {gas: air, temperature: 400 K}\n",
         "Radiation would add at most 15 W/(m²·K) to their h_j"},
        {"material: tin\nflatness: 5 um over 20 mm\n", "Plates that are flat to 5.00 µm over 20.0 mm touch on "},
        {"material: tin\nflatness: 5 um over 20 mm\n", ": flat to 5 um over 20 mm, of which "},
        {"material: tin\nflatness: 1 pm over 1 m\n",
         "Plates that are flat to 1.00·10⁻⁶ µm over 1000 mm are pressed flat."},
        {"material: tin\nplating: {thickness: 9 um, metal: hard gold}\n",
         ": 9 um of hard gold, of which 0.5 to 1.3 um are usual"},
        {"material: tin\ngap: {gas: air, pressure: 1 Pa}\n", "**the load matters more than the finish**"},
        {"material: tin\nplating: {thickness: 2 um, resistivity: 1e-8}\n", ", so it helps"},
        {"material: tin\nplating: {thickness: 2 um, resistivity: 1e-6}\n", ", so it does not help"},
        {"material: tin\nfilm: 1e-3 ohm m2\n", " is 100 % of the resistance"},
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

/** All models but CMY take the hardness of CMY's spots at the operating load. */
TEST_IN_PLACE(one_hardness_for_the_others)
{
    struct text report = report_of(place, "film: 0\nnominal_area: 1 mm2\noperating_load: 1e-6\n"
                                          "hardness: {c1: 60 MPa, c2: -0.2}\n");
    struct table contact = directory_table(place, "out/data/contact.csv");
    char says[80];
    size_t checked = 0;
    for (size_t i = 0; i < contact.rows; i++)
        if (strcmp(table_text(&contact, i, "model"), "cmy") == 0 && number(&contact, i, "load_over_AnEp") == 1e-6) {
            double hardness_MPa = 60 * pow(sqrt(2 * M_PI) * number(&contact, i, "spot_radius_m") / 1e-6, -0.2);
            snprintf(says, sizeof says, "all else %.4g MPa, theirs at the operating load", hardness_MPa);
            expect_parts(text_string(&report), says);
            checked++;
        }
    assert_int_equal(checked, 2);
    table_free(&contact);
    text_free(&report);
}

TEST_GROUP(place_setup, directory_teardown)
