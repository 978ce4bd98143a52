/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answers/measured.h"
#include "base/limits.h"
#include "directory.h"
#include "scene/measured_file.h"
#include <gsl/gsl_randist.h>

/* What the scene says of a file: quantity, units ("" for none), and the contact's area [m²], NaN for none. */
struct said {
    enum scene_measured_quantity quantity;
    const char *load_unit, *resistance_unit;
    double area_m2;
};

/* Reads `csv` under such a scene, E' being 10 GPa. */
static enum status_code read_csv(struct measured *out, const char *csv, const struct said *said, struct status *status)
{
    static char name[] = "ecr.csv", *names[] = {name};
    struct plan plan = {.running = EFFECT_BIT(EFFECT_ELECTRICAL) | EFFECT_BIT(EFFECT_THERMAL)};
    struct scene scene = {.directory = directory_here.path, .nominal_area_m2 = said->area_m2};
    scene.measured = (struct scene_measured){.files = {names, 1}, .quantity = said->quantity};
    snprintf(scene.measured.load_unit, UNIT_LENGTH, "%s", said->load_unit);
    snprintf(scene.measured.resistance_unit, UNIT_LENGTH, "%s", said->resistance_unit);
    const struct material_pair pair = {.effective_modulus_Pa = 1e10};
    directory_write(&directory_here, name, csv);
    *status = (struct status){0};
    *out = (struct measured){.given = &scene.measured};
    return measured_read(out, &scene, &plan, &pair, status);
}

TEST_CASE(units_are_the_models)
{
    static const struct {
        struct said said;
        double load, resistance;
    } cases[] = {{{SCENE_MEASURED_ECR, "dimensionless", "ohm m2", NAN}, 20, 3e-3},
                 {{SCENE_MEASURED_ECR, "Pa", "ohm m2", NAN}, 2e-9, 3e-3},
                 {{SCENE_MEASURED_ECR, "Pa", "ohm", 1e-6}, 2e-9, 3e-9},
                 {{SCENE_MEASURED_ECR, "Pa", "ohm m2", 1e-6}, 2e-9, 3e-3}, /* the area is in it already */
                 {{SCENE_MEASURED_ECR, "N", "ohm", 1e-6}, 2e-3, 3e-9},
                 {{SCENE_MEASURED_ECR, "kN", "mohm", 1e-6}, 2, 3e-12},
                 {{SCENE_MEASURED_TCR, "bar", "mm2 K/W", NAN}, 2e-4, 3e-9}};
    static const char *const dialects[] = {"load,ecr,error\n20,3e-3,1e-4\n10,6e-3,2e-4\n",
                                           "# mine\r\n20;3e-3;1e-4\r\n10;6e-3;2e-4\r\n",
                                           "20\t3e-3\t1e-4\n\n10 6e-3 2e-4",
                                           "load,ecr,\"error\"\r20,3e-3,1e-4\r10,6e-3,2e-4\r",
                                           "\"20\",\"3e-3\",\"1e-4\"\n10,6e-3,2e-4\n",
                                           "\xEF\xBB\xBF"
                                           "20,3e-3,1e-4 # run 3\n10 , 6e-3 , 2e-4,,\n"};
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++)
        for (size_t d = 0; d < sizeof dialects / sizeof *dialects; d++) {
            struct measured measured;
            expect_ok(read_csv, &measured, dialects[d], &cases[c].said);
            assert_int_equal(measured.count, 2);
            assert_near(measured.load[0], cases[c].load, 1e-14);
            assert_near(measured.load[1], cases[c].load / 2, 1e-14); /* in the file's order */
            assert_near(measured.resistance[0], cases[c].resistance, 1e-14);
            assert_near(measured.error[0] / measured.resistance[0], 1.0 / 30, 1e-12);
            assert_string_equal(measured.load_unit, cases[c].said.load_unit);
            assert_string_equal(measured.resistance_unit, cases[c].said.resistance_unit);
            measured_free(&measured);
        }
}

/* 10 and 4.8 in the units that the file names: the scene says nothing, or the same. */
TEST_CASE(headings_say_the_units)
{
    static const double area_m2 = 1e-6;
    static const struct {
        const char *csv;
        double load, resistance, error; /* N, Ω, Ω */
    } rows[] = {
        {"Load (N), R [m\xCE\xA9]\n10,4.8\n", 10, 4.8e-3, NAN},
        {"F/kN;R/\xC2\xB5Ohm\n10;4.8\n", 1e4, 4.8e-6, NAN},
        {"load_N,ecr_mohm\n10,4.8\n", 10, 4.8e-3, NAN},
        {"\"Load (kN)\",\"R (\xCE\xBC\xE2\x84\xA6)\"\n10,4.8\n", 1e4, 4.8e-6, NAN},
        {"Load, kN; R, mOhm\n10;4.8\n", 1e4, 4.8e-3, NAN},
        {"Load in kN\tresistance mOhm\n10\t4.8\n", 1e4, 4.8e-3, NAN},
        {"load_kN ecr_mohm\n10 4.8\n", 1e4, 4.8e-3, NAN},
        {"Load (kN) R (mOhm)\n10 4.8\n", 1e4, 4.8e-3, NAN},
        {"F,R\nkN,mOhm\n10,4.8\n", 1e4, 4.8e-3, NAN},
        {"F;R;u\n[kN];[m\xCE\xA9];[\xC2\xB5\xCE\xA9]\n10;4.8;30\n", 1e4, 4.8e-3, 3e-5},
        {"N,mOhm\n10,4.8\n", 10, 4.8e-3, NAN},
        {"N/kN,R/mOhm\n10,4.8\n", 1e4, 4.8e-3, NAN}, /* the symbol of a normal load */
        {"force_mN,R_c (4-wire) [mOhm]\n10,4.8\n", 1e-2, 4.8e-3, NAN},
        {"load (N),4-wire R (mOhm)\n10,4.8\n", 10, 4.8e-3, NAN},
        {"p (MPa),ECR (ohm mm\xC2\xB2)\n10,4.8\n", 10, 4.8, NAN}, /* over 1 mm² */
        {"pressure N/mm2,ecr_mohm\n10,4.8\n", 10, 4.8e-3, NAN},
        {"load_over_AnEp,ecr_ohm_m2\n10,4.8\n", 1e5, 4.8e6, NAN},
        {"load P/(A\xE2\x82\x99 E\xE2\x80\xB2),R (Ohm)\n10,4.8\n", 1e5, 4.8, NAN},
        {"# measured (twice), by hand\nLoad (kN), R (mOhm)\n# run 3, wet (a)\n10,4.8\n", 1e4, 4.8e-3, NAN},
        {"Contact test, tin (matt)\nLoad range (mN), 5 to 10\nLoad (kN), R (mOhm)\n\n10,4.8\n", 1e4, 4.8e-3, NAN},
        {"F (N);R (\xB5Ohm)\n10;4.8\n", 10, 4.8e-6, NAN}, /* latin-1 */
        {"load (N),R (mOhm),error\n10,4.8,0.1\n", 10, 4.8e-3, 1e-4},
        {"load (N),R (mOhm),error (uOhm)\n10,4.8,-30\n", 10, 4.8e-3, 3e-5},
        {"load (N),R (mOhm),error (%)\n10,4.8,5\n", 10, 4.8e-3, 2.4e-4},
        {"load (N),R (mOhm),u_r (-)\n10,4.8,0.05\n", 10, 4.8e-3, 2.4e-4},
        {"load (N),R (mOhm),sd (ohm mm2)\n10,4.8,1e-4\n", 10, 4.8e-3, 1e-4},
        {"Samples, 3\nLoad (N)\tR (mOhm)\n10\t4.8\n# unloading 2\n9\t5\n", 10, 4.8e-3, NAN},
        /* decimal commas; a column that names the rows */
        {"Kraft (N);R (mOhm)\n10,0;4,8\n20;2,5\n", 10, 4.8e-3, NAN},
        {"F (kN)\tR (mOhm)\n10\t4,8\n", 1e4, 4.8e-3, NAN},
        {"step,F (N),R (mOhm)\nup,10,4.8\n7,9,5\n", 10, 4.8e-3, NAN},
        {"step;F;R;u\n-;kN;mOhm;uOhm\nup;10;4,8;30,0\n", 1e4, 4.8e-3, 3e-5},
        /* columns in another order, of which all name their unit */
        {"R (mOhm),F (N)\n4.8,10\n", 10, 4.8e-3, NAN},
        {"mOhm;kN\n4.8;10\n", 1e4, 4.8e-3, NAN},
        {"R F\nmOhm kN\n4.8 10\n", 1e4, 4.8e-3, NAN},
        {"R (mOhm),u (uOhm),F (kN)\n4.8,30,10\n", 1e4, 4.8e-3, 3e-5},
        {"R (mOhm),F (kN),u (%)\n4.8,10,5\n", 1e4, 4.8e-3, 2.4e-4},
        {"F (kN),u (%),R (mOhm)\n10,5,4.8\n", 1e4, 4.8e-3, 2.4e-4},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (int agreed = 0; agreed < 2; agreed++) {
            struct measured measured;
            struct status status;
            struct said said = {SCENE_MEASURED_ECR, "", "", area_m2};
            char load_unit[UNIT_LENGTH], resistance_unit[UNIT_LENGTH];
            if (agreed) { /* the scene says what was found, which is no contradiction */
                said.load_unit = load_unit;
                said.resistance_unit = resistance_unit;
            }
            if (read_csv(&measured, rows[i].csv, &said, &status) != STATUS_OK)
                fail_msg("%s: %s", rows[i].csv, status.message);
            if (!(fabs(measured.load[0] * 1e10 * area_m2 / rows[i].load - 1) < 1e-14) ||
                !(fabs(measured.resistance[0] / area_m2 / rows[i].resistance - 1) < 1e-14))
                fail_msg("%s: %g N, %g ohm", rows[i].csv, measured.load[0] * 1e10 * area_m2,
                         measured.resistance[0] / area_m2);
            assert_int_equal(isnan(measured.error[0]), isnan(rows[i].error));
            if (!isnan(rows[i].error))
                assert_near(measured.error[0] / area_m2, rows[i].error, 1e-14);
            snprintf(load_unit, sizeof load_unit, "%s", measured.load_unit);
            snprintf(resistance_unit, sizeof resistance_unit, "%s", measured.resistance_unit);
            measured_free(&measured);
        }
}

TEST_CASE(what_is_wrong_is_named)
{
    static const struct said plain = {SCENE_MEASURED_ECR, "Pa", "ohm m2", NAN};
    static const struct said silent = {SCENE_MEASURED_ECR, "", "", 1e-6};
    static const struct said newton = {SCENE_MEASURED_ECR, "N", "mohm", 1e-6};
    static const struct said huge = {SCENE_MEASURED_ECR, "Pa", "kohm", 1e6};
    static const struct said no_area = {SCENE_MEASURED_ECR, "", "", NAN};
    static const struct said thermal = {SCENE_MEASURED_TCR, "", "", NAN};
    static const struct {
        const char *csv;
        const struct said *said;
        const char *message;
    } cases[] = {
        {"load,ecr\n", &plain, "ecr.csv: no row"},
        {"", &plain, "ecr.csv: no row"},
        {"load,ecr\n1\n", &plain, "ecr.csv:2: a row is load, resistance"},
        {"1,2,3,4\n", &plain, "ecr.csv:1: a row is load, resistance"},
        {"1,2\n0,2\n", &plain, "ecr.csv:2: a load of 0; allowed is 1e-100 to 1e+100"},
        {"load,ecr\n\n\n1,2\n\n1,-1\n", &plain, "ecr.csv:6: a resistance of -1; allowed is"},
        {"1,2,3\n1,,3\n", &plain, "ecr.csv:2: '' is no number"},
        {"1,5,2;2\n", &plain, "ecr.csv:1: '1,5,2' is no number; write it as 1.5e-3, its unit in the heading"},
        {"run,load,ecr\na,1,2\nb,x,2\n", &plain, "ecr.csv:3: 'x' is no load"},
        {"run,load\na,1\n", &plain, "ecr.csv: no row"},
        {"1 N,2 mohm\n", &plain, "ecr.csv:1: '1 N' is no number; write it as 1.5e-3, its unit in the heading"},
        {"1,5,\t2\n", &plain, "ecr.csv:1: '1,5,' is no number"},
        {"1,1e999\n", &plain, "ecr.csv:1: a resistance of inf; allowed is"},
        {"1,1e308\n1,2\n", &huge, "ecr.csv:1: a resistance of 1e+308; allowed is"},
        /* decimal commas between commas; a load that is none */
        {"Load (N),R (mOhm)\n10,4,8\n20,2,1\n", &silent,
         "ecr.csv:2: more cells than titles in line 1; write decimals with a point, and give an error a title"},
        {"Load,R\nN,mOhm\n10,4\n20,2,1\n", &silent, "ecr.csv:4: more cells than titles in line 2"},
        {"load (N),R (mOhm)\n1,2\nload (kN),R (mOhm)\n1,2\n", &silent, "ecr.csv:3: 'load (kN)' is no load; correct"},
        {"1,2\nnan,3\n", &newton, "ecr.csv:2: 'nan' is no load; correct the row or remove it"},
        {"1 2\nInf 3\n", &newton, "ecr.csv:2: 'Inf' is no load"},
        {"1;2\n;3\n", &newton, "ecr.csv:2: '' is no load"},
        {"1,2\nO.5,3\n", &newton, "ecr.csv:2: 'O.5' is no load"},
        {"1 2\nO.5 3\n", &newton, "ecr.csv:2: 'O.5' is no load"},
        {"1,2\nabc,3\n", &newton, "ecr.csv:2: 'abc' is no load"},
        {"load (N),R (mOhm)\n-,3\n1,2\n", &newton, "ecr.csv:2: '-' is no load"},
        /* no unit, and what to add */
        {"load,ecr\n1,2\n", &silent,
         "unit of the load; name it in the heading, such as 'load (N)', or add 'load_unit'"},
        {"load (N),ecr\n1,2\n", &silent,
         "unit of the resistance; name it in the heading, such as 'ECR (mohm)', or add 'resistance_unit'"},
        {"load (N),tcr\n1,2\n", &thermal, "such as 'TCR (K/W)', or add 'resistance_unit'"},
        {"1,2\n", &silent, "add 'load_unit'"},
        {"F_c,R_s\n1,2\n", &silent, "add 'load_unit'"},
        /* unknown, or not a column's */
        {"load (N),R (mOm)\n1,2\n", &newton,
         "ecr.csv:1: 'mOm' is no unit of electrical resistance; understood: ohm (Ω), nohm, uohm (µΩ), mohm (mΩ)"},
        {"\nload [kNm],R (mOhm)\n1,2\n", &newton,
         "ecr.csv:2: 'kNm' is no unit of load; understood: dimensionless; N, "},
        {"F/KN,R/ohm\n1,2\n", &newton, "ecr.csv:1: 'KN' is no unit of load"},
        {"F,R\nN,mOm\n1,2\n", &silent, "ecr.csv: nothing says the unit of the load"},
        {"R (mOhm),load\n1,2\n", &newton, "ecr.csv:1: 'mOhm' is no unit of load"}, /* not all say theirs */
        {"n,F (N),R (mOhm)\n1,2,3\n", &newton, "ecr.csv:1: 'N' is no unit of electrical resistance"},
        {"R (mOhm),F (N)\n1,2\nnan,3\n", &newton, "ecr.csv:3: 'nan' is no resistance; correct the row"},
        {"R (mOhm),u (%),F (N)\n1,2\n", &newton, "ecr.csv:2: '' is no number"},
        {"load (N),R (K/W)\n1,2\n", &silent, "columns are load, the scene's 'quantity', perhaps its error"},
        {"load (N),R (mohm)\n1,2\n", &thermal, "ecr.csv:1: 'mohm' is no unit of thermal resistance"},
        {"load (N),R (mOhm),T (degC)\n1,2,3\n", &newton, "ecr.csv:1: 'degC' is no unit of the error"},
        {"load (%),R (mOhm)\n1,2\n", &silent, "ecr.csv:1: '%' is no unit of load"},
        {"load (N),R (\x1b[31m)\n1,2\n", &newton, "'?[31m' is no unit"},
        /* two that disagree */
        {"load (kN),R (mOhm)\n1,2\n", &newton,
         "ecr.csv:1: the unit is 'kN' here, but the scene's load_unit says 'N'; correct one of them"},
        {"load (N),R (Ohm)\n1,2\n", &newton,
         "ecr.csv:1: the unit is 'Ohm' here, but the scene's resistance_unit says 'mohm'"},
        {"load (Pa),R (Ohm)\n1,2\n", &newton, "'Pa' here, but the scene's load_unit says 'N'"},
        /* without the area */
        {"load (N),R (ohm m2)\n1,2\n", &no_area, "measured loads in N need the contact's area; add nominal_area"},
        {"load (Pa),R (mohm)\n1,2\n", &no_area, "resistances in mohm need the contact's area; add nominal_area"},
    };
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        struct measured measured;
        struct status status;
        if (read_csv(&measured, cases[c].csv, cases[c].said, &status) != STATUS_SCENE)
            fail_msg("'%s' is read", cases[c].csv);
        if (!strstr(status.message, cases[c].message))
            fail_msg("'%s' without '%s'", status.message, cases[c].message);
        measured_free(&measured);
    }
}

/* Any bytes are either read to finite numbers or refused, and nothing behind their end is read. */
TEST_CASE(any_bytes_are_read_or_refused)
{
    static const char sample[] =
        "\xEF\xBB\xBFLoad (N), \"R [m\xCE\xA9]\";u/%\n# K m2/W (a\n10 kN,4.8 \xB5Ohm ,5e-1\r\n\"9\"\t1";
    static const char marks[] = "\"\n\r,;\t ()[]/_#%^*-+.09eNm\xCE\xA9\xC2\xB5";
    static const unsigned quantities[MEASURED_COLUMNS] = {UNIT_LOADS, 255, 255};
    unsigned long seed = 1;
    size_t taken = 0;
    for (int run = 0; run < 2000; run++) {
        size_t length = sizeof sample - 1, cut = 0;
        char *bytes = support_room(length);
        memcpy(bytes, sample, length);
        for (int change = 0; change < 1 + run % 6; change++) {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            size_t at = (seed >> 33) % length;
            bytes[at] = change % 3 ? marks[(seed >> 20) % (sizeof marks - 1)] : (char)(seed >> 25);
            cut = run % 4 ? 0 : at;
        }
        char *exact = support_room(length - cut); /* a byte read behind its end is seen */
        memcpy(exact, bytes, length - cut);
        struct measured_file file;
        struct status status = {0};
        enum status_code rc =
            measured_file_read(&file, (struct string_view){exact, exact + length - cut}, "x", quantities, &status);
        assert_true(rc == STATUS_OK || (rc == STATUS_SCENE && status.message[0] != '\0'));
        taken += rc == STATUS_OK;
        for (size_t i = 0; rc == STATUS_OK && i < file.count; i++)
            assert_true(isfinite(file.rows[i].value[MEASURED_LOAD]) && file.rows[i].value[MEASURED_RESISTANCE] > 0);
        measured_file_free(&file);
    }
    assert_true(taken > 50); /* not only refused */
}

/** Each file has its units, its largest load and its way down; only an effect that runs is compared. */
TEST_CASE(files_are_runs)
{
    static char *names[] = {"1.csv", "2.csv"};
    struct measured measured;
    struct plan plan = {.running = EFFECT_BIT(EFFECT_ELECTRICAL)};
    struct status status = {0};
    struct scene scene = {.directory = directory_here.path, .nominal_area_m2 = 1e-6};
    struct scene_measured given = {.files = {names, 2}};
    const struct material_pair pair = {.effective_modulus_Pa = 1e10};
    directory_write(&directory_here, names[0], "load (N),R (mOhm)\n1,9\n3,5\n2,6\n");
    directory_write(&directory_here, names[1], "R (Ohm),load (mN)\n4e-3,5000\n5e-3,4000\n7e-3,2000\n");
    measured = (struct measured){.given = &given};
    expect_ok(measured_read, &measured, &scene, &plan, &pair);
    assert_int_equal(measured.count, 6);
    const struct measured_run runs[] = {{0, 1, 3}, {3, 3, 6}};
    assert_int_equal(measured.run_count, 2);
    assert_memory_equal(measured.runs, runs, sizeof runs);
    assert_near(measured.load[3], 5e-4, 1e-14);
    assert_near(measured.resistance[1], 5e-9, 1e-14);
    assert_near(measured.resistance[3], 4e-9, 1e-14);
    measured_free(&measured);
    for (size_t over = 0; over < 2; over++) { /* rows of all files of all surfaces */
        size_t before = limit_most(LIMIT_MEASURED_LINES) - 6 + over;
        measured = (struct measured){.given = &given, .before = before};
        assert_int_equal(measured_read(&measured, &scene, &plan, &pair, &status), over ? STATUS_SCENE : STATUS_OK);
        measured_free(&measured);
    }
    assert_non_null(strstr(status.message, "2.csv: too many rows of all that was measured; at most 100000 lines"));
    status = (struct status){0};
    given.quantity = SCENE_MEASURED_TCR;
    measured = (struct measured){.given = &given};
    expect_fails(STATUS_SCENE, "the effect thermal does not run", measured_read, &measured, &scene, &plan, &pair);
}

/** Answers of all models, none yet; good until the next call. */
static struct measured_answers no_answers(const struct measured *measured)
{
    enum { MOST = 64 * 80 };
    static double resistance[MOST];
    assert_true(model_count * measured->count <= MOST);
    for (size_t i = 0; i < MOST; i++)
        resistance[i] = NAN;
    return (struct measured_answers){.resistance = resistance};
}

/** Measurements that are a factor times a model's answers: the distance is the factor's logarithm. Loads without an
 * answer are not compared. */
TEST_CASE(distance_is_in_decades)
{
    double loads[] = {1, 3e-5, 4e-4, 1e-7, 2e-6, 5e-5}, resistances[6]; /* in the order of a measurement */
    struct measured measured = {.count = 6, .load = loads, .resistance = resistances};
    struct measured_answers answers = no_answers(&measured);
    for (int i = 0; i < 6; i++) {
        resistances[i] = 4 * 1e-8 * pow(loads[i] / 1e-6, -0.9);
        if (loads[i] > 1e-6 && loads[i] < 1e-2)
            answers.resistance[6 + i] = resistances[i] / 4;
    }
    struct measured_distance distance = measured_compare(&measured, &answers, 1);
    assert_int_equal(distance.points, 4);
    assert_near(distance.rms_decades, log10(4), 1e-12);
    assert_near(distance.bias_decades, -log10(4), 1e-12);
    assert_true(isnan(measured_compare(&measured, &answers, 0).rms_decades));
}

/** Runs of which the contact carries 0.6 of the conductance of model 1, off by what points and runs scatter; on the way
 * down twice that. */
static struct estimate fit_made(size_t runs, double points_sd, double runs_sd, const gsl_rng *random)
{
    enum { UP = 6, POINTS = 9, MOST = 8 };
    struct measured_run parts[MOST];
    double loads[MOST * POINTS], ohm_m2[MOST * POINTS];
    struct measured measured = {
        .count = runs * POINTS, .run_count = runs, .runs = parts, .load = loads, .resistance = ohm_m2};
    struct measured_answers answers = no_answers(&measured);
    for (size_t r = 0; r < runs; r++) {
        double off = gsl_ran_gaussian(random, runs_sd);
        parts[r] = (struct measured_run){r * POINTS, r * POINTS + UP - 1, (r + 1) * POINTS};
        for (size_t k = 0, i = r * POINTS; k < POINTS; k++, i++) {
            double model = pow(10, -8.0 - (double)(k < UP ? k : 2 * UP - 2 - k) / 3);
            ohm_m2[i] = model / (k < UP ? 0.6 : 1.2) * exp(off + gsl_ran_gaussian(random, points_sd));
            answers.resistance[measured.count + i] = k == 0 ? NAN : model; /* beyond the run's loads */
        }
    }
    expect_ok(measured_fit, &answers, &measured, 1);
    return answers.fit;
}

/** The exponent of two runs of `points` loads over two decades whose conductance goes as P^power, power NaN: as the
 * model's, P^0.95 bent by 5 %, off by what points scatter; runs differ by a factor 3. */
static struct measured_exponent exponent_made(double power, size_t points, double sd, const gsl_rng *random)
{
    enum { MOST = 40 };
    double loads[MOST], ohm_m2[MOST];
    struct measured_run parts[2] = {{0, points - 1, points}, {points, 2 * points - 1, 2 * points}};
    struct measured measured = {
        .count = 2 * points, .run_count = 2, .runs = parts, .load = loads, .resistance = ohm_m2};
    struct measured_answers answers = no_answers(&measured);
    for (size_t i = 0; i < 2 * points; i++) {
        double x = log(100) * (double)(i % points) / (double)(points - 1), curve = 0.95 * x - 0.01 * x * x;
        loads[i] = 1e-6 * exp(x);
        answers.resistance[measured.count + i] = 1e-8 * exp(-curve);
        ohm_m2[i] = (i < points ? 1e-8 : 3e-8) * exp(gsl_ran_gaussian(random, sd) - (isnan(power) ? curve : power * x));
    }
    expect_ok(measured_fit, &answers, &measured, 1);
    return answers.exponent;
}

/** "Not flat" is said if the conductance's exponent is below the model's by more than the error and 0.08, and no series
 * resistance explains that: not for the model's own curve, one as steep within the error, few or scattered points, or a
 * steeper curve. */
TEST_CASE(parts_that_are_not_flat)
{
    static const struct {
        double power, sd;
        size_t points;
        bool not_flat;
    } rows[] = {{0.4, 0.002, 12, true},  {1.0 / 3, 0.02, 12, true}, {0.7, 0.002, 12, true}, {NAN, 0.02, 12, false},
                {0.95, 0.02, 12, false}, {0.87, 0.01, 12, false},   {0.7, 0.6, 4, false},   {1.5, 0.02, 12, false}};
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct measured_exponent told = exponent_made(rows[i].power, rows[i].points, rows[i].sd, random);
        assert_int_equal(told.not_flat, rows[i].not_flat);
        assert_within(told.measured, isnan(rows[i].power) ? 0.95 - 0.01 * log(100) : rows[i].power, 4 * told.sd + 0.01);
        assert_within(told.model, 0.95 - 0.01 * log(100), 1e-3);
    }
    assert_true(isnan(exponent_made(0.95, 2, 0.02, random).measured));
    size_t wrong = 0;
    for (int set = 0; set < 1000; set++)
        wrong += exponent_made(NAN, 5, set % 2 ? 0.1 : 0.3, random).not_flat;
    assert_in_range(wrong, 0, 25);
    gsl_rng_free(random);
}

/** The model's curve with half as much again in series at the last load bends the same way, and is no sign of the
 * parts' shape. */
TEST_CASE(a_resistance_in_series_is_no_shape)
{
    enum { POINTS = 12 };
    double loads[POINTS], ohm_m2[POINTS];
    struct measured_run part = {0, POINTS - 1, POINTS};
    struct measured measured = {.count = POINTS, .run_count = 1, .runs = &part, .load = loads, .resistance = ohm_m2};
    struct measured_answers answers = no_answers(&measured);
    for (size_t i = 0; i < POINTS; i++) {
        loads[i] = 1e-6 * pow(100, (double)i / (POINTS - 1));
        const double model = 1e-8 * pow(loads[i] / 1e-6, -0.95);
        answers.resistance[measured.count + i] = model;
        ohm_m2[i] = (0.6 * model + 1.5e-10) * (i % 2 ? 1.005 : 0.995);
    }
    expect_ok(measured_fit, &answers, &measured, 1);
    assert_true(answers.exponent.measured < 0.8);
    assert_false(answers.exponent.not_flat);
}

/** Without scatter the factor comes back exactly, without an interval; with scatter the interval contains it in 95 % of
 * cases, even if runs differ far more than the points of a run. */
TEST_CASE(the_factor_comes_back)
{
    enum { SETS = 1000 };
    static const struct {
        size_t runs;
        double points_sd, runs_sd;
    } cases[] = {{1, 0.1, 0}, {1, 0.4, 0}, {2, 0.1, 0.1}, {5, 0.05, 0.3}};
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    for (size_t runs = 1; runs <= 8; runs += 7) {
        const struct estimate fit = fit_made(runs, 0, 0, random);
        assert_near(estimate_value(&fit), 0.6, 1e-12);
        assert_int_equal(fit.count, runs > 1 ? runs : 5); /* points on the way up that the model answers */
        assert_true(isnan(estimate_end(&fit, 0)));
    }
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        double held = 0, sum = 0;
        for (int set = 0; set < SETS; set++) {
            const struct estimate fit = fit_made(cases[c].runs, cases[c].points_sd, cases[c].runs_sd, random);
            held += estimate_end(&fit, 0) <= 0.6 && estimate_end(&fit, 1) >= 0.6;
            sum += fit.mean;
        }
        assert_within(held / SETS, 0.95, 0.021); /* three standard deviations */
        assert_within(sum / SETS, log(0.6), 0.02);
    }
    gsl_rng_free(random);
}

/** Only models that answer enough of the points can be the nearest, not one that happens to meet a single point. */
TEST_CASE(models_are_ranked)
{
    enum { MODELS = 4, POINTS = 5 }; /* that have a curve: the first in the table */
    static const double above[MODELS] = {3, 0.5, 7, 1};
    assert_true(model_count >= MODELS);
    double loads[POINTS] = {1e-3, 1e-4, 2e-6, 5e-3, 1e-2}, resistances[POINTS];
    struct measured measured = {.count = POINTS, .load = loads, .resistance = resistances};
    struct measured_answers answers = no_answers(&measured);
    for (int i = 0; i < POINTS; i++) {
        resistances[i] = 1e-14 / loads[i];
        for (int m = 0; m < MODELS; m++)
            if (m < 3 || i == 2) /* the fourth meets one point alone */
                answers.resistance[m * POINTS + i] = resistances[i] * above[m];
    }
    assert_int_equal(measured_nearest(&measured, &answers), 1);
    for (int i = 0; i < POINTS; i++)
        answers.resistance[POINTS + i] = NAN;
    assert_int_equal(measured_nearest(&measured, &answers), 0);
    for (int i = 0; i < 3; i++) /* three of five, and those are met */
        answers.resistance[3 * POINTS + i] = resistances[i];
    assert_int_equal(measured_nearest(&measured, &answers), 3);
    answers = no_answers(&measured);
    assert_int_equal(measured_nearest(&measured, &answers), model_count);
}

/** Models are run at the measured loads themselves, without interpolation; outside the scene's loads, and where the
 * resistance is 0, there is no answer. */
TEST_CASE(models_answer_at_the_measured_loads)
{
    enum { HARMONICS = 40, POINTS = 6 };
    static const double ends[] = {1e-6, 1e-1};
    double amplitudes_m[HARMONICS], loads[POINTS] = {1e-3, 1e-5, 1e-3, 1e-7, 5e-2, 2e-4}, resistances[POINTS];
    struct spectrum spectrum = {.amplitude_m = amplitudes_m, .count = HARMONICS, .length_m = 1e-4};
    for (int n = 1; n <= HARMONICS; n++)
        amplitudes_m[n - 1] = 1e-7 * pow(n, -1.5);
    struct asperities asperities = {.density_per_m2 = 1e10, .radius_m = 2e-6, .sigma_s_m = 1e-7, .sigma_m = 1e-7};
    struct material_pair pair = material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    pair.hardness_Pa = 40e6;
    const struct surface_record record = {.summary = {.pair = pair, .has_asperities = true, .asperities = asperities},
                                          .spectrum = spectrum};
    const struct scene scene = {.tolerance = 1e-6};
    const struct plan plan = {.models = model_find("multiscale") | model_find("statistical"),
                              .running = EFFECT_BIT(EFFECT_PLASTICITY),
                              .wanted = quantity_wanted((1u << EFFECT_COUNT) - 1)};
    const struct surface_task asked = {.scene = &scene, .plan = &plan, .loads = ends, .load_count = 2};
    const struct model_task task = surface_model_task(&record, &asked);
    const uint64_t models = plan.models;
    for (int thermal = 0; thermal < 2; thermal++) {
        struct measured measured = {.count = POINTS, .load = loads, .resistance = resistances, .thermal = thermal};
        struct measured_answers answers;
        expect_ok(measured_answer, &answers, &measured, &record, &asked);
        for (size_t m = 0; m < model_count; m++) {
            for (int i = 0; i < POINTS; i++) {
                double answer = answers.resistance[m * POINTS + (size_t)i];
                struct contact_point points[2];
                struct model_curve curve = {.points = points};
                const struct model_task alone = model_task_at(&task, &loads[i], 1);
                if (!(models & MODEL_BIT(m)) || loads[i] < ends[0]) {
                    assert_true(isnan(answer));
                    continue;
                }
                expect_ok(model_run, &curve, model_rows[m], &alone);
                double expected = thermal ? points[0].value[QUANTITY_TCR] : points[0].value[QUANTITY_ECR];
                if (points[0].value[QUANTITY_LOAD] == loads[i] && expected > 0)
                    assert_near(answer, expected, 1e-9);
                else
                    assert_true(isnan(answer));
            }
            if ((models & MODEL_BIT(m)) && !model_rows[m]->plastic)
                assert_true(answers.resistance[m * POINTS + 1] > 0);
        }
        measured_answers_free(&answers);
    }
}

TEST_GROUP(directory_setup, directory_teardown)
