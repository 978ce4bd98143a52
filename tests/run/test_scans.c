/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Several scans of a surface, one alone, and surfaces held against each other, through the whole program. */
#include "cli/process.h"
#include "run/pipeline.h"
#include "statistics/interval.h"

#include <gsl/gsl_cdf.h>
#include <jansson.h>

enum { POINTS = 256, SCANS = 5 };

/* A scene with these lines before its surfaces. */
static void write_scene(const struct directory *place, const char *in, const char *more, const char *surfaces)
{
    directory_write(
        place, filled("%s/scene.yaml", in),
        filled("material: tin\nload: {from: 1e-6, to: 1e-3, points: 7}\n%ssurfaces: [%s]\n", more, surfaces));
}

/* The report in place/OUT of such a one. */
static void report(const struct directory *place, const char *out, const char *more, const char *surfaces)
{
    write_scene(place, "in", more, surfaces);
    assert_int_equal(pipeline_run(place, "in", out, 1), 0);
}

static const char listed[] = "effects: [plasticity, separation, electrical]\n",
                  /* strips join the scans, in their order */
    no_strips[] = "effects: [plasticity, separation, electrical]\n"
                  "models: [multiscale, statistical, corrected-persson, cmy]\n";

/* Like pipeline_rough(), with a seed whose surface exists. */
static void rough(const struct directory *place, const char *name, size_t points, double size, unsigned long seed)
{
    struct synth_def def = synth_def_default();
    struct status status = {0};
    double height_m[2 * POINTS];
    def.points = points;
    def.length_m = 5e-7 * (double)points;
    def.alpha *= size;
    for (def.seed = 100 * seed; synth_profile(height_m, &def, &status) != STATUS_OK; def.seed++)
        status = (struct status){0};
    pipeline_scan(place, name, height_m, points);
}

/** The same scans in other units, or from their other end, have the same answers: also by strips, whose surrogates are
 * drawn and whose rows, beside one another, press on each other. */
TEST_IN_DIRECTORY(other_units_and_directions)
{
    enum { LONG = 600, AS = 3 };
    static const char *const columns[] = {"area_ratio", "separation_m", "ecr_ohm_m2"};
    struct synth_def def = synth_def_default();
    double height_m[LONG];
    def.points = LONG;
    def.length_m = 5e-7 * LONG;
    for (int s = 0; s < 3; s++, def.seed++) {
        expect_ok(synth_profile, height_m, &def);
        for (int k = 0; k < AS; k++) {
            struct text *file = support_text();
            text_add(file, k == 1 ? "x [mm],z [nm]\n" : "x [um],z [um]\n");
            for (size_t i = 0; i < LONG; i++)
                text_add(file, "%g,%.6f\n", 0.5 * (double)i * (k == 1 ? 1e-3 : 1),
                         height_m[k == 2 ? LONG - 1 - i : i] * (k == 1 ? 1e9 : 1e6));
            directory_write(place, filled("in/%d-%d.csv", k, s), text_string(file));
        }
    }
    for (int f = 0; f < 2; f++) {
        struct table as[AS];
        for (int k = 0; k < AS; k++) {
            report(place, filled("as-%d", k), "models: [strip]\neffects: [separation, electrical]\n",
                   filled(f == 0 ? "{name: m, file: '%d-0.csv'}" : "{name: m, file: '%d-*.csv'}", k));
            as[k] = directory_table(place, filled("as-%d/data/contact.csv", k));
            assert_int_equal(as[k].rows, as[0].rows);
            for (size_t i = 0; i < as[k].rows; i++)
                for (int q = 0; q < 3; q++)
                    assert_near(table_number(&as[k], i, columns[q]), table_number(&as[0], i, columns[q]),
                                k == 1 ? 1e-3 : 0.05);
        }
    }
}

/** The surface's curve (except the textbook's, see test_textbook.c) is the geometric mean of the curves of its scans,
 * each from a report of its own. Separations are averaged over sigma; what may be negative has the arithmetic mean. The
 * order of the scans in the scene does not matter. */
TEST_IN_DIRECTORY(the_mean_of_five_reports)
{
    static const char *const columns[] = {"area_ratio", "ecr_ohm_m2", "separation_over_sigma",
                                          "adjusted_separation_over_sigma"};
    struct table alone[SCANS];
    for (int s = 0; s < SCANS; s++) {
        rough(place, filled("in/%d.csv", s), POINTS, 1, (unsigned long)s + 1);
        report(place, filled("alone-%d", s), no_strips, filled("{name: m, file: %d.csv}", s));
        alone[s] = directory_table(place, filled("alone-%d/data/contact.csv", s));
    }
    report(place, "all", no_strips, "{name: m, file: [0.csv, 1.csv, 2.csv, 3.csv, 4.csv]}");
    struct table all = directory_table(place, "all/data/contact.csv");
    size_t compared = 0;
    for (size_t r = 0; r < all.rows; r++)
        for (size_t c = 0; c < 4; c++) {
            double sum = 0, load = table_number(&all, r, "load_over_AnEp");
            const char *model = table_text(&all, r, "model");
            bool signed_one = c == 2 && (strcmp(model, "gw") == 0 || strcmp(model, "jg") == 0);
            if (strcmp(model, "cmy") == 0 || table_text(&all, r, columns[c])[0] == '\0' ||
                table_number(&all, r, "area_ratio") == 1)
                continue;
            for (int s = 0; s < SCANS; s++) {
                double value = table_number(&alone[s], pipeline_row(&alone[s], "m", model, load), columns[c]);
                sum += signed_one ? value : log(value);
            }
            double mean = signed_one ? sum / SCANS : exp(sum / SCANS);
            assert_near(table_number(&all, r, columns[c]), mean, 1e-12);
            compared++;
        }
    assert_true(compared > 50);
    report(place, "turned", no_strips, "{name: m, file: [3.csv, 0.csv, 4.csv, 2.csv, 1.csv]}");
    directory_expect_same(place, "all/data/contact.csv", "turned/data/contact.csv");
    directory_expect_same(place, "all/data/bands.csv", "turned/data/bands.csv");
    directory_expect_same(place, "all/data/spread.csv", "turned/data/spread.csv");
    directory_expect_same(place, "all/data/spectrum.csv", "turned/data/spectrum.csv");
}

/** Half the 95 % interval, of ln, of two scans' s, of one degree of freedom, and the model's own error. */
static double half_of(double s, double model)
{
    const double both = hypot(s, model);
    return gsl_cdf_tdist_Pinv(0.975, pow(both / s, 4)) * both;
}

/** The interval of the mean is Student's over ln answer, of the scans' s, |a - b|/2 of two, and of GW's error, 0.87 of
 * ECR and 1.85 of a separation, by Satterthwaite. The mean lies in it, and it in that of another scan. */
TEST_IN_DIRECTORY(the_interval_of_two)
{
    static const char elastic[] = "effects: [separation, electrical]\nhardness: 900 GPa\n";
    double ln[2], ln_gap[2];
    rough(place, "in/0.csv", POINTS, 1, 1);
    rough(place, "in/1.csv", POINTS, 1, 2);
    for (int s = 0; s < 2; s++) {
        report(place, s ? "one" : "zero", elastic, s ? "{name: m, file: 1.csv}" : "{name: m, file: 0.csv}");
        struct table table = directory_table(place, s ? "one/data/contact.csv" : "zero/data/contact.csv");
        ln[s] = log(table_number(&table, pipeline_row(&table, "m", "gw", 1e-5), "ecr_ohm_m2"));
        ln_gap[s] = log(table_number(&table, pipeline_row(&table, "m", "gw", 1e-5), "adjusted_separation_over_sigma"));
    }
    report(place, "both", elastic, "{name: m, file: [0.csv, 1.csv]}");
    struct table bands = directory_table(place, "both/data/bands.csv");
    size_t row = pipeline_row(&bands, "m", "gw", 1e-5);
    double mean = (ln[0] + ln[1]) / 2, s = fabs(ln[0] - ln[1]) / 2, half = half_of(s, 0.87);
    assert_near(table_number(&bands, row, "ecr_ohm_m2_mean_low_95"), exp(mean - half), 1e-9);
    assert_near(table_number(&bands, row, "ecr_ohm_m2_mean_high_95"), exp(mean + half), 1e-9);
    assert_near(table_number(&bands, row, "ecr_ohm_m2_next_scan_high_95"), exp(mean + half_of(sqrt(3) * s, 0.87)),
                1e-9);
    mean = (ln_gap[0] + ln_gap[1]) / 2; /* each over its own sigma */
    half = half_of(fabs(ln_gap[0] - ln_gap[1]) / 2, 1.85);
    assert_near(table_number(&bands, row, "separation_over_sigma_mean_low_95"), exp(mean - half), 1e-9);
    assert_near(table_number(&bands, row, "separation_over_sigma_mean_high_95"), exp(mean + half), 1e-9);
    struct table spread = directory_table(place, "both/data/spread.csv"); /* results.json has the same */
    assert_near(pipeline_number(place, "both", "surfaces/0/spread/rq_m/mean_95/0"),
                table_number(&spread, 0, "mean_low_95"), 1e-15);
    assert_near(pipeline_number(place, "both", "surfaces/0/spread/rq_m/next_scan_95/0"),
                table_number(&spread, 0, "next_scan_low_95"), 1e-15);
    expect_in_file(place, "both/report.md", "(95\u00a0%: ");
}

/** A cell; NaN where it is empty. */
static double cell(const struct table *table, size_t row, const char *column)
{
    return *table_text(table, row, column) ? table_number(table, row, column) : NAN;
}

/** Intervals of one scan and of two very different ones, up to full contact: they contain the value, have a width, lie
 * above 0 and for areas below 1. A quantity given by the load alone has none. */
TEST_IN_DIRECTORY(intervals_in_the_data)
{
    static const char *const names[] = {"area_ratio", "separation_over_sigma", "ecr_ohm_m2"};
    rough(place, "in/0.csv", POINTS, 1, 1);
    rough(place, "in/1.csv", POINTS, 4, 2);
    rough(place, "in/2.csv", POINTS, 0.02, 3);
    rough(place, "in/3.csv", POINTS, 100, 4);
    report(place, "out",
           "models: [multiscale, statistical, cmy]\neffects: [plasticity, separation, electrical, uncertainty]\n",
           "{name: one, file: 0.csv}, {name: two, file: [0.csv, 1.csv]}, {name: smooth, file: 2.csv}, {name: rough, "
           "file: 3.csv}");
    struct table bands = directory_table(place, "out/data/bands.csv"),
                 contact = directory_table(place, "out/data/contact.csv");
    size_t known[2][3] = {{0}}, at_most[2] = {0}, alike = 0, pressed = 0, yielding = 0;
    const struct material *tin = material_find("tin");
    const double modulus_over_hardness =
        tin->youngs_modulus_Pa / (1 - tin->poisson_ratio * tin->poisson_ratio) / material_hardness(tin);
    for (size_t r = 0; r < bands.rows; r++)
        for (int q = 0; q < 3; q++) {
            const char *surface = table_text(&bands, r, "surface"), *model = table_text(&bands, r, "model");
            bool statistical = strcmp(model, "gw") == 0 || strcmp(model, "jg") == 0,
                 several = strcmp(surface, "two") == 0;
            double low = cell(&bands, r, filled("%s_mean_low_95", names[q])),
                   high = cell(&bands, r, filled("%s_mean_high_95", names[q]));
            assert_int_equal(isnan(low), isnan(high));
            if (strcmp(model, "cmy") == 0 && q == 0)
                alike += isnan(low) != 0;
            bool elastic = strcmp(model, "gw") == 0 || strcmp(model, "multiscale-elastic") == 0;
            yielding += elastic && isnan(low);
            if (isnan(low))
                continue;
            assert_true(low > 0 && low <= high && (q > 0 || high <= 1));
            double load = table_number(&bands, r, "load_over_AnEp"),
                   value = cell(&contact, pipeline_row(&contact, surface, model, load),
                                statistical && q == 1 ? "adjusted_separation_over_sigma" : names[q]);
            if (elastic && q == 0) /* where it bears more than the hardness it has none */
                assert_true(value >= load * modulus_over_hardness);
            if (strcmp(model, "multiscale-plastic") == 0 && q == 0 &&
                load * modulus_over_hardness < 1) { /* that of load over hardness at the least */
                assert_true(low >= load * modulus_over_hardness * (1 - 1e-9));
                assert_true(value <= high * (1 + 1e-9) || high <= load * modulus_over_hardness * (1 + 1e-9));
                pressed += value < low;
            } else {
                assert_true(low < high && low <= value * (1 + 1e-9) && value <= high * (1 + 1e-9));
            }
            known[several][q]++;
            at_most[several] += q == 0 && high == 1 ? 1 : 0;
        }
    /* pressed lightly, a separation goes as sigma: record by record their scatter cancels; in metres it is 14 times */
    size_t light = pipeline_row(&bands, "rough", "multiscale-plastic", 1e-6);
    double half = log(cell(&bands, light, "separation_over_sigma_mean_high_95") /
                      cell(&bands, light, "separation_over_sigma_mean_low_95")) /
                  2; /* with the model's error, 2.50, taken out of it */
    assert_true(sqrt(pow(half / 1.96, 2) - pow(2.50, 2)) < log(4) / 2 / 1.96);
    for (int several = 0; several < 2; several++)
        for (int q = 0; q < 3; q++)
            assert_true(known[several][q] > 10);
    assert_true(at_most[0] > 0 && at_most[1] > 0 && alike > 4 && pressed > 4 && yielding > 4);
}

/** A scan of twice the length is cut in two, and gives the same as its halves given as two scans. */
TEST_IN_DIRECTORY(unlike_lengths)
{
    double height_m[2 * POINTS];
    struct synth_def def = synth_def_default();
    def.points = 2 * POINTS;
    def.length_m = 5e-7 * (double)def.points;
    def.seed = 4;
    expect_ok(synth_profile, height_m, &def);
    pipeline_scan(place, "in/long.csv", height_m, 2 * POINTS);
    pipeline_scan(place, "in/left.csv", height_m, POINTS);
    pipeline_scan(place, "in/right.csv", height_m + POINTS, POINTS);
    rough(place, "in/short.csv", POINTS, 1, 2);
    report(place, "out", listed,
           "{name: cut, file: [long.csv, short.csv]}, {name: halves, file: [left.csv, right.csv]}, "
           "{name: short, file: short.csv}, {name: l, file: [long.csv, left.csv]}, {name: r, file: [long.csv, "
           "right.csv]}");
    struct table contact = directory_table(place, "out/data/contact.csv"),
                 surfaces = directory_table(place, "out/data/surfaces.csv"),
                 spread = directory_table(place, "out/data/spread.csv");
    double ln[3];
    static const char *const names[] = {"cut", "halves", "short"};
    for (int s = 0; s < 3; s++)
        ln[s] = log(table_number(&contact, pipeline_row(&contact, names[s], "multiscale-elastic", 1e-5), "ecr_ohm_m2"));
    assert_within(ln[0], (2 * ln[1] + ln[2]) / 3, 1e-6); /* the long one weighs two; heights are written to 1e-15 m */
    for (size_t i = 0; i < surfaces.rows; i++)           /* of the longest, whichever was read first */
        assert_near(table_number(&surfaces, i, "points"), i == 1 || i == 2 ? POINTS : 2 * POINTS, 0);
    assert_near(table_number(&spread, 0, "effective"), 3, 1e-12);
    assert_near(table_number(&spread, 0, "scans"), 2, 1e-12);
    expect_in_file(place, "out/report.md", "| 2 (cut to 3 pieces) |");
}

/** Some copies among scans, in another format and unit: as if they were not there. */
TEST_IN_DIRECTORY(copies_among_scans)
{
    for (int s = 0; s < 3; s++)
        rough(place, s == 0 ? "in/0.csv" : s == 1 ? "in/1.csv" : "in/2.csv", POINTS, 1, (unsigned)s + 1);
    struct text *csv = support_text(), *copy = support_text();
    expect_ok(text_read_file, csv, directory_path(place, "in/1.csv"));
    text_add(copy, "x [mm];z [nm]\n");
    char *line = strtok(csv->data, "\n");
    for (double x, z; (line = strtok(NULL, "\n"));)
        if (sscanf(line, "%lf,%lf", &x, &z) == 2)
            text_add(copy, "%.7f;%.2f\n", x * 1e-3, z * 1e3 + 70); /* rounded, and from another zero */
    directory_write(place, "in/copy.txt", text_string(copy));
    report(place, "three", "", "{name: m, file: [0.csv, 1.csv, 2.csv]}");
    report(place, "four", "", "{name: m, file: [0.csv, 1.csv, 2.csv, copy.txt]}");
    struct table three = directory_table(place, "three/data/spread.csv"),
                 four = directory_table(place, "four/data/spread.csv");
    assert_near(table_number(&four, 0, "scans"), 3, 0);
    assert_near(table_number(&four, 0, "effective"), table_number(&three, 0, "effective"), 0);
    expect_in_file(place, "four/report.md", "holds the same heights as");
    report(place, "twice", "", "{name: m, file: [0.csv, 1.csv, 2.csv, 1.csv]}");
    expect_in_file(place, "twice/report.md",
                   "**Copies:** 1.csv repeats heights that were read before; they count once.",
                   "1.csv: is listed more than once and counts once");
    expect_no_parts(directory_read(place, "twice/report.md"), "same heights");
}

/** Copies of a scan that cannot be used are none either. */
TEST_IN_DIRECTORY(copies_of_a_refused_scan)
{
    for (int s = 0; s < 2; s++)
        directory_write(place, s ? "in/b.csv" : "in/a.csv", "x [um],z [um]\n0,1\n1,2\n2,1\n3,2\n4,1\n5,3\n");
    rough(place, "in/good.csv", POINTS, 1, 1);
    directory_write(place, "in/scene.yaml",
                    "surfaces: [{name: bad, file: [a.csv, b.csv]}, {name: good, file: good.csv}]\n");
    struct process run = process_run(place->path, "report", "in", "-o", "out", "--no-cost");
    assert_int_equal(run.status, 1);
    expect_parts(run.err, "surface 'bad' refused", "6 points carry no spectrum");
}

/** New names change no number, not even in the last digit. */
TEST_IN_DIRECTORY(names_change_nothing)
{
    for (int s = 0; s < 3; s++)
        rough(place, s == 0 ? "in/a.csv" : s == 1 ? "in/b.csv" : "in/c.csv", POINTS, 1, (unsigned)s + 1);
    report(place, "before", "models: [strip, gw]\n", "{name: m, file: [a.csv, b.csv, c.csv]}");
    for (int move = 0; move < 3; move++) {
        static const char *const moves[][2] = {{"in/a.csv", "in/x"}, {"in/c.csv", "in/a.csv"}, {"in/x", "in/c.csv"}};
        char from[4096];
        snprintf(from, sizeof from, "%s", directory_path(place, moves[move][0]));
        assert_int_equal(rename(from, directory_path(place, moves[move][1])), 0);
    }
    report(place, "after", "models: [strip, gw]\n", "{name: m, file: [a.csv, b.csv, c.csv]}");
    static const char *const data[] = {"contact", "bands", "spread", "spectrum"};
    for (size_t d = 0; d < 4; d++)
        directory_expect_same(place, filled("before/data/%s.csv", data[d]), filled("after/data/%s.csv", data[d]));
}

/** What results.json knows of the first surface's resistance by a model. */
static double of_resistance(const struct directory *place, const char *out, const char *model, const char *key)
{
    return pipeline_number(place, out, filled("surfaces/0/models/%s/at_middle_load/ecr_ohm_m2/%s", model, key));
}

/** The width of its 95 % interval, of the logarithm. */
static double width_of(const struct directory *place, const char *out, const char *model)
{
    return log(of_resistance(place, out, model, "mean_95/1") / of_resistance(place, out, model, "mean_95/0"));
}

/** The interval of one open scan with few of its longest waves is wider, by what it cannot know of them. */
TEST_IN_DIRECTORY(few_longest_waves)
{
    struct synth_def def = synth_def_default();
    double height_m[4 * POINTS];
    def.points = 4 * POINTS;
    def.gamma = 1.8;
    def.length_m = 5e-7 * 4 * POINTS;
    expect_ok(synth_profile, height_m, &def);
    pipeline_scan(place, "in/0.csv", height_m, POINTS);
    report(place, "out", "effects: [separation, electrical, uncertainty]\nmodels: [strip]\n", "{name: m, file: 0.csv}");
    const double waves = pipeline_number(place, "out", "surfaces/0/longest_waves"),
                 s = of_resistance(place, "out", "strip", "standard_deviation");
    assert_true(waves > 1 && waves < 2);
    double square = pow(0.54, 2) + pow(1.3 * log(2.5 / waves), 2) + s * s;
    assert_near(width_of(place, "out", "strip") / 2,
                interval_quantile(0.95, 4 * pow(square / (s * s), 2)) * sqrt(square), 1e-9);
}

/** Records simulated from a long scan are of means over neighbouring heights, and scatter like those of all heights. */
TEST_IN_DIRECTORY(long_scans_are_thinned)
{
    enum { RECORD = 1 << 14, EACH = 3 };
    struct synth_def def = synth_def_default();
    double height_m[EACH * RECORD], mean_m[RECORD] = {0}, s[2];
    def.points = EACH * RECORD;
    def.length_m = 5e-7 * EACH * RECORD;
    def.lambda_s_m = 2e-5;
    expect_ok(synth_profile, height_m, &def);
    for (size_t i = 0; i < EACH * RECORD; i++)
        mean_m[i / EACH] += height_m[i] / EACH;
    for (int thin = 0; thin < 2; thin++) {
        struct text *csv = support_text();
        text_add(csv, "x [um],z [um]\n");
        for (size_t i = 0; i < (thin ? RECORD : EACH * RECORD); i++)
            text_add(csv, "%.1f,%.9f\n", (thin ? 1.5 : 0.5) * (double)i, (thin ? mean_m[i] : height_m[i]) * 1e6);
        directory_write(place, "in/0.csv", text_string(csv));
        report(place, "out", "effects: [separation, electrical, uncertainty]\nmodels: [corrected-persson]\n",
               "{name: m, file: 0.csv}");
        s[thin] = of_resistance(place, "out", "corrected-persson", "standard_deviation");
    }
    assert_near(s[0], s[1], 1e-3);
}

/** Two rough bodies: scan i of one with scan i of the other, as many as both have; of one scan of either, records with
 * records and quarters with quarters. */
TEST_IN_DIRECTORY(two_rough_bodies)
{
    static const struct {
        const char *own, *other;
        double degrees;
    } cases[] = {{"a*.csv", "b*.csv", 2},
                 {"a*.csv", "b[01].csv", 1},
                 {"a0.csv", "b*.csv", 4},
                 {"a0.csv", "b0.csv", 4},
                 {"a*.csv", "b0.csv", 4}};
    for (unsigned long i = 0; i < 3; i++) {
        rough(place, filled("in/a%lu.csv", i), POINTS, 1, i + 1);
        rough(place, filled("in/b%lu.csv", i), POINTS, 1, i + 11);
    }
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        report(place, "out",
               filled("hardness: 900 GPa\neffects: [separation, electrical, uncertainty]\nmodels: "
                      "[strip]\ncounterface: {surface: '%s'}\n",
                      cases[k].other),
               filled("{name: m, file: '%s'}", cases[k].own));
        assert_near(of_resistance(place, "out", "strip", "degrees_of_freedom"), cases[k].degrees, 0);
        assert_true(width_of(place, "out", "strip") > 2 * 1.9 * 0.5 && width_of(place, "out", "strip") < 20);
        expect_in_file(place, "out/report.md", "(95\u00a0%: ");
    }
    report(place, "out", "models: [strip]\ncounterface: {surface: b0.csv}\n", "{name: m, file: 'a*.csv'}");
    expect_in_file(place, "out/report.md", "records can be simulated of the one pair of scans of 1 surface");
}

/** A scan with equal quarters, and one that is a hundred times as rough from its middle on: the quarters are solved
 * alone, and their scatter widens the interval. */
TEST_IN_DIRECTORY(a_scan_that_changes)
{
    double width[2];
    struct synth_def def = synth_def_default();
    double height_m[4 * POINTS];
    def.points = 4 * POINTS;
    def.length_m = 5e-7 * 4 * POINTS;
    def.gamma = 0.8;
    expect_ok(synth_profile, height_m, &def);
    for (size_t i = 0; i < 4 * POINTS; i++) /* so flat that nothing bears more than the hardness */
        height_m[i] *= 1e-4;
    for (int k = 0; k < 2; k++) {
        for (size_t i = 2 * POINTS; k == 1 && i < 4 * POINTS; i++)
            height_m[i] *= 100;
        pipeline_scan(place, "in/0.csv", height_m, 4 * POINTS);
        report(place, "out", "hardness: 900 GPa\neffects: [separation, electrical, uncertainty]\nmodels: [strip]\n",
               "{name: m, file: 0.csv}");
        assert_near(of_resistance(place, "out", "strip", "degrees_of_freedom"), 4, 0);
        width[k] = width_of(place, "out", "strip");
    }
    assert_true(width[1] > 2 * width[0]);
}

/** Up to 24 scans are solved whole, more in pieces; all count in the degrees of freedom. */
TEST_IN_DIRECTORY(many_scans)
{
    for (unsigned long i = 0; i < 26; i++)
        rough(place, filled("in/%02lu.csv", i), 64, 1, i + 1);
    for (int many = 0; many < 2; many++) {
        report(place, "out", "effects: [separation, electrical]\nmodels: [strip]\n",
               many ? "{name: m, file: '*.csv'}" : "{name: m, file: '[01]*.csv'}");
        assert_near(of_resistance(place, "out", "strip", "degrees_of_freedom"), many ? 23 : 19, 0);
    }
}

/** Without `uncertainty` single scans have no bands, and nothing is said about significant differences. */
TEST_IN_DIRECTORY(one_scan_each)
{
    rough(place, "in/a.csv", POINTS, 1, 1);
    rough(place, "in/b.csv", POINTS, 3, 2);
    report(place, "off", listed, "{name: a, file: a.csv}, {name: b, file: b.csv}");
    assert_false(directory_has(place, "off/data/bands.csv"));
    expect_not_in_file(place, "off/report.md", "differ significantly", "significantly better", "(95\u00a0%: ");
    report(place, "on", "effects: [plasticity, separation, electrical, uncertainty]\n",
           "{name: a, file: a.csv}, {name: b, file: b.csv}");
    expect_in_file(place, "on/report.md", "(95\u00a0%: ", "differ significantly");
}

/** Rows of a map are no scans: strips of them have an answer, and nothing tells an interval. */
TEST_IN_DIRECTORY(a_map_by_rows)
{
    enum { NX = 64, NY = 300 };
    struct text *grid = support_text();
    text_add(grid, "DSAA\n%d %d\n0 %.9g\n0 %.9g\n-1 1\n", NX, NY, 5e-7 * (NX - 1), 5e-7 * (NY - 1));
    for (int row = 0; row < NY; row++) {
        for (int i = 0; i < NX; i++)
            text_add(grid, "%.9g ", (1 + row / 300.0) * (1e-7 * sin(0.7 * i) + 4e-8 * sin(2.1 * i * (i % 5))));
        text_add(grid, "\n");
    }
    directory_write(place, "in/map.grd", text_string(grid));
    report(place, "out", "effects: [separation, electrical]\nmodels: [strip]\n",
           "{name: m, file: map.grd, x_unit: m, z_unit: m}");
    struct table contact = directory_table(place, "out/data/contact.csv");
    assert_true(contact.rows > 0 && table_number(&contact, 0, "area_ratio") > 0);
    assert_false(directory_has(place, "out/data/spread.csv") || directory_has(place, "out/data/bands.csv"));
    expect_in_file(place, "out/report.md", "24 of them, evenly spaced, go through the models");
}

/* Scans that cannot be used change no number: the surface is that of the other scans, and the report says so. */
TEST_IN_DIRECTORY(bad_scans_of_several)
{
    static const char *const folders[] = {"good", "bad"};
    for (int f = 0; f < 2; f++) {
        for (unsigned s = 0; s < 3; s++)
            rough(place, filled("%s/%c.csv", folders[f], "ace"[s]), POINTS, 1, 7 + s);
        write_scene(place, folders[f], listed, "{name: s, file: [\"*.csv\"]}");
    }
    directory_write(place, "bad/b.csv", "x [um],z [um]\n0,1\n1,oops\n2,3\n");
    directory_write(place, "bad/d.csv", "x [um],z [um]\n0,1\n1,0.5\n2,0.7\n"); /* refused for its spectrum */
    assert_int_equal(pipeline_outcome(place, "good", "out-good", (struct run_options){.jobs = 2})->left_out, 0);
    const struct run_outcome *bad = pipeline_outcome(place, "bad", "out-bad", (struct run_options){.jobs = 2});
    assert_int_equal(bad->left_out, 2);
    assert_int_equal(bad->refused, 0);
    directory_expect_same(place, "out-good/data/contact.csv", "out-bad/data/contact.csv");
    directory_expect_same(place, "out-good/data/spread.csv", "out-bad/data/spread.csv");
    expect_parts(
        text_string(&bad->messages),
        "surface 's': b.csv:3: 'oops' in a column of numbers; correct or remove this line - refused; 3 of its 5 scans "
        "are used\n",
        "surface 's': d.csv: 3 points carry no spectrum; at least 11 are needed: take a longer scan, or leave it out - "
        "refused; 3 of its 5 scans are used\n");
    expect_in_file(place, "out-bad/report.md", "Not used: 2 of 5 files", "at least 11 are needed");
}

/* A surface whose only scan is too short is refused; the shortest scan that is accepted has 11 points. */
TEST_IN_DIRECTORY(too_short_to_lead)
{
    rough(place, "in/long.csv", POINTS, 1, 3);
    static const double height_m[] = {0, 3e-7, 1e-7, 4e-7, -2e-7, 2e-7, 5e-7, -1e-7, 1e-7, 3e-7, -3e-7};
    pipeline_scan(place, "in/eleven.csv", height_m, 11);
    pipeline_scan(place, "in/ten.csv", height_m, 10);
    write_scene(place, "in", listed,
                "{name: ten, file: ten.csv}, {name: eleven, file: eleven.csv}, {name: long, file: long.csv}");
    const struct run_outcome *outcome = pipeline_outcome(place, "in", "out", (struct run_options){.jobs = 2});
    assert_int_equal(outcome->left_out, 0);
    assert_int_equal(outcome->refused, 1);
    expect_parts(text_string(&outcome->messages), "surface 'ten' refused: ten.csv: 10 points carry no spectrum");
}

/* Scans of one surface without common wavelengths, such as um read as mm: numbers that cannot be computed are empty,
 * with the reason, and the report is written. */
TEST_IN_DIRECTORY(scans_that_have_nothing_in_common)
{
    struct text *csv = support_text();
    rough(place, "in/a.csv", POINTS, 1, 3);
    rough(place, "in/b.csv", POINTS, 1, 4);
    rough(place, "in/c.csv", POINTS, 0.3, 5);
    text_add(csv, "x [mm],z [um]\n");
    for (int i = 0; i < POINTS; i++)
        text_add(csv, "%g,%.9f\n", 0.5 * i, sin(0.7 * i) + 0.5 * sin(2.1 * i));
    directory_write(place, "in/mm.csv", text_string(csv));
    directory_write(place, "in/scene.yaml",
                    "material: tin\nmodels: [multiscale, corrected-persson]\nfit: thesis\n"
                    "surfaces: [{name: s, file: [a.csv, mm.csv]}, "
                    "{name: t, file: [b.csv, c.csv]}]\n");
    const struct run_outcome *outcome = pipeline_outcome(place, "in", "out", (struct run_options){.jobs = 2});
    assert_int_equal(outcome->left_out, 0);
    expect_parts(text_string(&outcome->messages), "surface 's': no power law: fewer than 3 harmonics",
                 "surface 's': Gaussian heights has no solution for 1 of the scans run alone");
    struct table surfaces = directory_table(place, "out/data/surfaces.csv");
    assert_string_equal(table_text(&surfaces, 0, "fit_high_m"), "");
}
