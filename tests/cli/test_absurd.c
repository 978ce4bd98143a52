/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scans that no instrument measures, each beside a good one: the good one is reported; no NaN is written. */
#include "cli/process.h"
#include "hard_case.h"

enum { POINTS = 200, NX = 20, NY = 10 };

/** Heights in units of the case's `height`, by point. */
typedef double shape(size_t i);

static double rough(size_t i)
{
    return sin(0.3 * (double)i) + 0.6 * cos(1.1 * (double)i * (double)i) + 0.3 * sin(2.9 * (double)i);
}

static double flat(size_t i)
{
    (void)i;
    return 1;
}

static double offset(size_t i)
{
    return 1e15 + rough(i);
}

static double ramp(size_t i)
{
    return (double)i;
}

static double spike(size_t i)
{
    return i == 77 ? 1 : 0;
}

static double alternating(size_t i)
{
    return i % 2 ? -1 : 1;
}

static double all_but_one(size_t i)
{
    return i == 0 ? 0 : 1;
}

static double ridges(size_t i)
{
    return (double)(i / NX % 3);
}

static double first_row_tiny(size_t i)
{
    return (i < NX ? 1e-310 : 1) * rough(i);
}

struct absurd {
    const char *name, *height, *spacing; /* as decimal numbers in the unit; positions start at 0 */
    const char *unit;
    shape *shape;
    size_t points;                         /* 0: a map of NX x NY */
    const char *refusal, *inspect_refusal; /* NULL: not refused */
    const char *danger;                    /* what could go wrong, in docs/hard-cases.md */
};

#define BOTH(message) (message), (message)
#define LIMITS        " m; allowed is 1e-30 to 1e+30 m: is the unit of "

static const struct absurd cases[] = {
    {"tiny", "1e-316", "1e-6", "m", rough, POINTS, BOTH("e-316" LIMITS "z right?"),
     "squares of heights of 1e-316 m are 0"},
    {"least double", "4.94e-324", "1e-6", "m", alternating, POINTS, BOTH("heights of 9.88e-324" LIMITS "z right?"),
     "half a step of the smallest number there is"},
    {"squares vanish", "1e-160", "1e-6", "m", rough, POINTS, BOTH("e-160" LIMITS "z right?"),
     "m0 = 0 of a rough surface"},
    {"small", "1e-29", "1e-6", "m", rough, POINTS, BOTH(NULL), "squares of 1e-58, fourth powers of slopes"},
    {"large", "1e28", "1e-6", "m", rough, POINTS, BOTH(NULL), "squares of 1e56 m²"},
    {"squares overflow", "1e150", "1e-6", "m", rough, POINTS, BOTH("e+150" LIMITS "z right?"), "m0 = inf"},
    {"huge", "1e300", "1", "um", rough, POINTS, BOTH("e+294" LIMITS "z right?"), "a unit that was mistaken, by 10^300"},
    {"differences overflow", "1.7e308", "1e-6", "m", alternating, POINTS, BOTH("heights of 1.7e+308" LIMITS "z right?"),
     "a slope of inf before any is computed"},
    {"dense", "1e-6", "1e-313", "m", rough, POINTS, BOTH("a spacing of 1e-313" LIMITS "x right?"),
     "slopes of 1e307, curvatures of inf"},
    {"denser than atoms", "1e-6", "2e-30", "m", rough, POINTS, BOTH(NULL), "curvatures of 1e54"},
    {"sparse", "1e-6", "1e160", "m", rough, POINTS, BOTH("a spacing of 1e+160" LIMITS "x right?"),
     "slopes of 1e-166, whose squares are 0"},
    {"long", "1e-6", "1e28", "m", rough, POINTS, BOTH("a length of 2e+30" LIMITS "x right?"),
     "a unit that was mistaken"},
    {"offset", "1e-12", "1e-6", "m", offset, POINTS, BOTH("the scan is flat: no roughness is left after level: mean"),
     "rounding is taken for roughness, 10^15 times below the offset"},
    {"flat", "1e-6", "1e-6", "m", flat, POINTS, BOTH("the scan is flat: every height is 1e-06 m"),
     "0/0 in every ratio of roughness"},
    {"ramp", "1e-6", "1e-6", "m", ramp, POINTS, BOTH("the scan is flat: no roughness is left after level: line"),
     "the same, once it is levelled"},
    {"three", "1e-6", "1e-6", "m", rough, 3, "3 points carry no spectrum; at least 11", NULL,
     "a spectrum of one harmonic has a law of any exponent"},
    {"three in a line", "1e-6", "1e-6", "m", ramp, 3, BOTH("the scan is flat: no roughness is left"),
     "nothing is left to scale anything by"},
    {"four", "1e-6", "1e-6", "m", rough, 4, "4 points carry no spectrum; at least 11", NULL,
     "a law through two points"},
    {"eight", "1e-6", "1e-6", "m", rough, 8, "8 points carry no spectrum; at least 11", NULL,
     "the same of four harmonics"},
    {"spike", "1e-6", "1e-6", "m", spike, POINTS, BOTH(NULL), "the law of a spike"},
    {"alternating", "1e-6", "1e-6", "m", alternating, POINTS, BOTH(NULL), "all is at the shortest wavelength: no law"},
    {"alternating odd", "1e-6", "1e-6", "m", alternating, POINTS - 1, BOTH(NULL),
     "the same without a shortest wavelength"},
    {"all but one", "1e-6", "1e-6", "m", all_but_one, POINTS, BOTH(NULL), "one point decides"},
    {"flat map", "1e-6", "1e-6", "m", flat, 0, "the scan is flat: every height is", "the map is flat: every height is",
     "0/0 in every row"},
    {"plane", "1e-6", "1e-6", "m", ramp, 0, "the scan is flat: no roughness is left",
     "the map is flat: no roughness is left", "rounding is all that levelling leaves"},
    {"ridges", "1e-6", "1e-6", "m", ridges, 0, "the scan is flat: every height is", NULL,
     "every row is flat though the map is not"},
    {"map", "1e-6", "1e-6", "m", rough, 0, BOTH(NULL), "few and short rows"},
    {"tiny map", "1e-316", "1e-6", "m", rough, 0, BOTH("e-316" LIMITS "z right?"),
     "the same as of profiles, by another way"},
    {"huge map", "1e300", "1e-6", "m", rough, 0, BOTH("e+300" LIMITS "z right?"),
     "the same as of profiles, by another way"},
    {"dense map", "1e-6", "1e-313", "m", rough, 0, BOTH("a spacing of 1e-313" LIMITS "x right?"),
     "the same across the rows"},
    {"map with a tiny row", "1e-6", "1e-6", "m", first_row_tiny, 0, BOTH(NULL),
     "a row of denormal heights among others"},
    {"eleven", "1e-6", "1e-6", "m", rough, 11, BOTH(NULL), "the fewest points that carry a spectrum"},
};
enum { CASES = sizeof cases / sizeof *cases };

HARD_CASES("Scans no instrument measured, each beside a good one")

/** A row of the page for case `i`; `bad` counts what must not be there. */
static void met(size_t i, size_t bad)
{
    static struct hard_case rows[CASES];
    static char words[CASES][2][200];
    const struct absurd *it = &cases[i];
    snprintf(words[i][0], sizeof words[i][0], "%s: %s %s, heights of %s %s, %s %s apart", it->name,
             it->points ? filled("%zu", it->points) : filled("%d x %d", NX, NY), "points", it->height, it->unit,
             it->spacing, it->unit);
    if (it->refusal)
        snprintf(words[i][1], sizeof words[i][1], "refused: “%s%s”", *it->refusal == 'e' ? "…" : "", it->refusal);
    else
        snprintf(words[i][1], sizeof words[i][1], "reported, every model");
    rows[i].words[0] = words[i][0];
    rows[i].words[1] = it->danger;
    rows[i].words[2] = words[i][1];
    rows[i].words[3] = it->refusal ? "rows of it in the tables" : "areas outside 0 to 1";
    hard_case_met(&rows[i], (double)bad, 0, __FILE__, __LINE__);
}

/** Rows of data/contact.csv in `out` of that surface; *wrong counts those with an area outside 0 to 1. */
static size_t rows_of(const char *place, const char *out, const char *surface, size_t *wrong)
{
    struct table table = workspace_table(place, filled("%s/data/contact.csv", out));
    size_t rows = 0;
    for (size_t r = 0; r < table.rows; r++)
        if (strcmp(table_text(&table, r, "surface"), surface) == 0) {
            double area = table_number(&table, r, "area_ratio");
            *wrong += !(area >= 0 && area <= 1);
            rows++;
        }
    return rows;
}

static void write_case(const char *place, const char *path, const struct absurd *absurd)
{
    struct text *out = support_text();
    const bool map = absurd->points == 0;
    const char *unit = absurd->unit;
    double height = strtod(absurd->height, NULL), spacing = strtod(absurd->spacing, NULL);
    text_add(out, map ? "x [%s],y [%s],z [%s]\n" : "x [%s],z [%s]\n", unit, unit, unit);
    for (size_t i = 0; i < (map ? NX * NY : absurd->points); i++) {
        text_add(out, "%.17g,", (double)(map ? i % NX : i) * spacing);
        if (map)
            text_add(out, "%.17g,", (double)(i / NX) * spacing);
        text_add(out, "%.17g\n", absurd->shape(i) * height);
    }
    workspace_write(place, path, text_string(out));
}

/** Reports `folder`, with a good scan beside what is in it, and reads all that is written. Returns stderr. */
static char *report(const char *place, const char *folder, const char *scene, size_t refused, bool cost)
{
    const char *out = lasting("out-%s", folder), *path = lasting("%s/data/contact.csv", out);
    workspace_scan(place, filled("%s/good.csv", folder), 300, 4);
    workspace_write(place, filled("%s/scene.yaml", folder), scene);
    struct process process =
        expect_exit(place, refused > 0 ? 1 : 0, "report", folder, "-o", out, cost ? "--verbose" : "--no-cost");
    process_expect_numbers(process.out, "stdout");
    process_expect_numbers(process.err, "stderr");
    assert_true(workspace_expect_numbers(place, out) > 20);
    expect_in_file(place, path, "\ngood,jg,");
    if (refused == 0)
        expect_in_file(place, path, "\nbad,multiscale-elastic,");
    json_t *json = workspace_json(place, filled("%s/results.json", out));
    assert_int_equal(json_array_size(json_object_get(json, "refused")), refused);
    return process.err;
}

static const char scene_of_reports[] = "material: tin\nload: {points: 7}\nconvergence: {scales: 16}\n";

/* Accepted scans: each alone with the good one, since a chart's range is that of all its curves; every third with a
 * usual scene, the others with properties and loads at the ends of their ranges. */
TEST_IN_WORKSPACE(test_reports)
{
    static const char rest[] = "effects: [plasticity, separation, electrical, thermal, scale-dependent, convergence]\n"
                               "load: {from: 1e-100, to: 1e100, points: 9}\nnominal_area_m2: 1e6\n"
                               "convergence: {alpha: 1e12, gamma: 5, load: 1e-100, scan_length_m: 1e3, scales: 16}\n";
    static const char *const materials[] = {
        "{E_Pa: 1e13, nu: 0, Sy_Pa: 1e3, resistivity_ohm_m: 1e18, conductivity_W_per_mK: 1e-4, density_kg_per_m3: 1, "
        "specific_heat_J_per_kgK: 1, sound_speed_m_per_s: 1}",
        "{E_Pa: 1e6, nu: 0.5, Sy_Pa: 1e12, resistivity_ohm_m: 1e-12, conductivity_W_per_mK: 1e5, "
        "density_kg_per_m3: 1e5, specific_heat_J_per_kgK: 1e5, sound_speed_m_per_s: 1e5}",
    };
    size_t reports = 0;
    for (size_t i = 0; i < CASES; i++) {
        if (cases[i].refusal)
            continue;
        const char *folder = lasting("d%zu", i);
        print_message("%s\n", cases[i].name);
        write_case(place, filled("%s/bad.csv", folder), &cases[i]);
        size_t which = reports++ % 3;
        report(place, folder, which > 0 ? filled("material: %s\n%s", materials[which - 1], rest) : scene_of_reports, 0,
               which == 0);
        size_t wrong = 0;
        assert_true(rows_of(place, filled("out-%s", folder), "bad", &wrong) > 0);
        met(i, wrong);
    }
}

/* A refused scan leaves nothing but its message: one report for all. */
TEST_IN_WORKSPACE(test_refusals)
{
    size_t refused = 0;
    for (size_t i = 0; i < CASES; i++)
        if (cases[i].refusal) {
            write_case(place, filled("refused/bad-%zu.csv", i), &cases[i]);
            refused++;
        }
    char *messages = report(place, "refused", scene_of_reports, refused, false);
    expect_part(messages, filled("and %zu more refused", refused - 10)); /* results.json has them all */
    json_t *all = json_object_get(workspace_json(place, "out-refused/results.json"), "refused"), *one;
    for (size_t i = 0; i < CASES; i++) {
        if (!cases[i].refusal)
            continue;
        const char *why = NULL;
        size_t k, wrong = 0;
        json_array_foreach (all, k, one) {
            if (strcmp(json_string_value(json_object_get(one, "surface")), filled("bad-%zu", i)) == 0)
                why = json_string_value(json_object_get(one, "error"));
        }
        if (!why)
            fail_msg("%s: not refused", cases[i].name);
        expect_part(why, cases[i].refusal);
        met(i, rows_of(place, "out-refused", filled("bad-%zu", i), &wrong));
    }
}

/* Three thousand scans of one surface, all of them in its mean; a million loads, more than a table is made for. */
TEST_IN_WORKSPACE(test_many)
{
    enum { SCANS = 3000, FEW = 20 };
    for (size_t k = 0; k < SCANS; k++) {
        struct text *csv = support_text();
        text_add(csv, "x [um],z [um]\n");
        for (size_t i = 0; i < FEW; i++)
            text_add(csv, "%zu,%.4f\n", i, rough(i + 31 * k));
        workspace_write(place, filled("d/s/%zu.csv", k), text_string(csv));
    }
    static const char scene[] = "material: tin\nmodels: [multiscale-elastic]\neffects: [electrical]\n";
    workspace_write(place, "d/scene.yaml", filled("%sload: {points: 5}\n", scene));
    run_to_exit(place, 0, "report", "d", "-o", "out", "--no-cost", "--brief");
    json_t *json = workspace_json(place, "out/results.json");
    json_t *files = json_object_get(json_array_get(json_object_get(json, "surfaces"), 0), "spread");
    hard_case("3000 scans of one surface", "memory, open files, a mean of the first ones", "all are in the mean",
              "scans left out", SCANS - json_number_value(json_object_get(files, "files")), 0);
    workspace_write(place, "d/scene.yaml", filled("%sload: {points: 1000000}\n", scene));
    struct process process = process_run(place, "report", "d", "-o", "more", "--no-cost");
    expect_part(process.err, "'points' is 1000000; allowed is 1 to 100000");
    hard_case("a scene of 10^6 loads", "gigabytes of tables", "refused with the most that may be: 100 000",
              "another exit status than 3", process.status != 3, 0);
}

/* A refused file has a line of its own and the others go on; no NaN or infinity is printed. Three batches, as more than
 * ten refusals at once are only counted. */
TEST_IN_WORKSPACE(test_inspect)
{
    enum { BATCH = 11 };
    workspace_scan(place, "good.csv", 300, 4);
    for (size_t from = 0; from < CASES; from += BATCH) {
        const char *words[BATCH + 6] = {PROGRAM, "inspect", "--chart"};
        const size_t count = CASES - from < BATCH ? CASES - from : BATCH;
        for (size_t i = 0; i < count; i++) {
            words[3 + i] = lasting("%zu.csv", from + i);
            write_case(place, words[3 + i], &cases[from + i]);
        }
        words[3 + count] = "good.csv";
        struct process text = expect_status(process_end(process_start_list(place, words, NULL)), 1);
        words[2] = "--json";
        struct process json = expect_status(process_end(process_start_list(place, words, NULL)), 1);
        process_expect_numbers(text.out, "stdout");
        process_expect_numbers(text.err, "stderr");
        process_expect_numbers(json.out, "stdout of --json");
        expect_part(text.out, "good.csv\n  format ");
        json_t *all = support_json(json.out);
        assert_int_equal(json_array_size(all), count + 1);
        assert_true(json_is_real(json_object_get(json_array_get(all, count), "rq_m")));
        for (size_t i = 0; i < count; i++) {
            const char *message = json_string_value(json_object_get(json_array_get(all, i), "error"));
            const char *refusal = cases[from + i].inspect_refusal;
            if ((message != NULL) != (refusal != NULL))
                fail_msg("%s: %s", cases[from + i].name, message ? message : "not refused");
            if (refusal)
                expect_parts(message, refusal);
            expect_part(message ? text.err : text.out, message ? message : filled("%zu.csv\n  format ", from + i));
        }
    }
    write_case(place, "bad.csv", &cases[15]);
    expect_output(expect_exit(place, 0, "inspect", "bad.csv"), "power law   - (no power law found)", "Pdq - ");
    expect_output(expect_exit(place, 0, "inspect", "--json", "bad.csv"), "\"gamma\": null");
}
