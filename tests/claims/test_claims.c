/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every claim is said where it has to be, with its numbers, and not where it must not be: tests/claims.tsv. */
#include "cli/process.h"

enum { ROWS_MOST = 300 };

static char *lines[ROWS_MOST][3];
static size_t line_count;

/** Cuts the table into its cells. */
static void read_rows(void)
{
    char *file = directory_read(PROJECT_SOURCE, "tests/claims.tsv");
    line_count = 0;
    for (char *line = strtok(file, "\n"); line; line = strtok(NULL, "\n")) {
        if (line[0] == '#')
            continue;
        assert_true(line_count < ROWS_MOST);
        lines[line_count][0] = line;
        for (int c = 1; c < 3; c++) {
            char *tab = strchr(lines[line_count][c - 1], '\t');
            assert_non_null(tab);
            *tab = '\0';
            lines[line_count][c] = tab + 1;
        }
        line_count++;
    }
}

/** Scans of four surfaces, three of each, one whose ends are open, one that is refused, two with copies, and
 * measurements: as the model, of parts that are not flat, with a resistance in series, and of a single point. */
static void make_folder(const char *place)
{
    static const struct {
        const char *name, *law;
        int first;
    } surfaces[] = {{"a", "--alpha 0.06 --gamma 1.55 --scatter 0.28", 11},
                    {"b", "--alpha 0.02 --gamma 1.35 --scatter 0.28", 21},
                    {"d", "--gamma 1.8 --rq 0.02um --scatter 0", 31}};
    for (size_t s = 0; s < sizeof surfaces / sizeof *surfaces; s++)
        for (int k = 0; k < 3; k++)
            workspace_shell(place, filled("mkdir -p d && " PROGRAM " synth --lambda-s 4um --seed %d %s --length 0.4mm "
                                          "--points 400 -o d/%s-%d.csv",
                                          surfaces[s].first + k, surfaces[s].law, surfaces[s].name, k + 1));
    workspace_shell(place, PROGRAM " synth --lambda-s 4um --seed 5 --gamma 1.0 --rq 5.8um --length 0.4mm --points 400 "
                                   "-o d/c.csv");
    workspace_shell(place, PROGRAM " synth --lambda-s 4um --seed 7 --alpha 0.06 --gamma 1.55 --length 1.6mm --points "
                                   "1600 -o w.csv; (head -n1 w.csv; tail -n 400 w.csv) > d/open.csv");
    workspace_shell(
        place,
        PROGRAM " synth --map --points 64 --length 0.128mm --gamma 1.25 --lambda-s 8um --rq 0.4um --seed 3 -o m.sdf");
    struct text *map = support_text(); /* of waves longer than itself */
    text_add(map, "aISO-1.0\nNumPoints = 48\nNumProfiles = 48\nXscale = 1e-6\nYscale = 1e-6\nZscale = 1e-9\n*\n");
    for (int k = 0; k < 48 * 48; k++) {
        const double x = k % 48, y = (double)(k / 48);
        text_add(map, "%.0f\n", 400 * sin(x / 11 + 0.3) * cos(y / 13) + 30 * sin(0.9 * x + 0.4 * y) * cos(0.7 * y));
    }
    workspace_write(place, "long.sdf", text_string(map));
    workspace_write(place, "d/bad.csv", "x_um,z_um\n1,2\n");
    workspace_shell(place,
                    "cd d && mkdir two three && cp b-1.csv b-2.csv two && cp b-1.csv two/b-9.csv && cp two/* three "
                    "&& cp b-1.csv three/b-8.csv");
    static const struct {
        const char *name, *heading;
        double power, series;
    } measured[] = {{"m95", "load_N,resistance_mohm", -0.95, 0},
                    {"m40", "load_N,resistance_mohm", -0.4, 0},
                    {"mser", "load_N,resistance_mohm", -0.95, 0.5},
                    {"mtcr", "load (N),R (K/W)", -0.95, 0}};
    workspace_shell(place, "cd d && printf 'load_N,resistance_mohm\\n1,9\\n' >mone.txt");
    for (size_t m = 0; m < 4; m++) {
        struct text *text = support_text();
        text_add(text, "%s\n", measured[m].heading);
        for (int i = 0; i < 9; i++) {
            double load = 0.1 * pow(10, i / 4.0), own = (m == 2 ? 0.4 : 1) * pow(load, measured[m].power);
            text_add(text, "%.6g,%.6g\n", load, (own + measured[m].series) * (i % 2 ? 1.01 : 0.99));
        }
        workspace_write(place, filled("d/%s.txt", measured[m].name), text_string(text));
    }
}

/** The claims of a scene. */
static json_t *claims_of(const char *place, const char *scene)
{
    const bool none = strncmp(scene, "none", 4) == 0;
    if (none)
        workspace_shell(place, "rm -f d/scene.yaml");
    else
        workspace_write(place, "d/scene.yaml", filled("%s\n", scene));
    workspace_shell(place, filled(PROGRAM " report d -o o --no-cost --brief%s >/dev/null 2>&1 || test $? = 1",
                                  none ? scene + 4 : ""));
    return json_object_get(workspace_json(place, "o/results.json"), "claims");
}

/** The text of a claim of that key that holds `part`, or any; NULL: there is none. */
static const char *said(const json_t *claims, const char *key, const char *part)
{
    size_t i;
    const json_t *claim;
    json_array_foreach (claims, i, claim) {
        const char *text = json_string_value(json_object_get(claim, "text"));
        if (strcmp(json_string_value(json_object_get(claim, "key")), key) == 0 && strstr(text, part))
            return text;
    }
    return NULL;
}

/** A claim of one surface or of all is said once; within a level the largest factor comes first; the parts of the
 * uncertainty make the whole. Numbers of one claim are in one unit, SI. */
static void expect_list(const json_t *claims)
{
    size_t i, k;
    const json_t *claim, *other;
    double before = INFINITY, factor, model, scans, waves, load, low, high;
    json_array_foreach (claims, i, claim) {
        const char *key = json_string_value(json_object_get(claim, "key")),
                   *text = json_string_value(json_object_get(claim, "text"));
        const json_t *numbers = json_object_get(claim, "numbers");
        json_array_foreach (claims, k, other)
            if (k < i && strncmp(key, "target", 6) && strncmp(key, "limit", 5))
                assert_string_not_equal(json_string_value(json_object_get(other, "key")), key);
        /* a limit that is missed is the first of the verdicts */
        const json_t *prior = i > 0 ? json_array_get(claims, i - 1) : NULL;
        if (strcmp(key, "limit") == 0 && strstr(text, " is missed by ") && prior)
            assert_true(strcmp(json_string_value(json_object_get(prior, "level")), "verdict") != 0 ||
                        strstr(json_string_value(json_object_get(prior, "text")), " is missed by "));
        /* only copies and a claim that stops say that they hold for others, and only where there are */
        const bool others = strstr(text, "The same holds for ") != NULL;
        assert_int_equal(others, json_object_get(numbers, "others") != NULL);
        assert_true(!others || strcmp(key, "duplicates") == 0 ||
                    strcmp(json_string_value(json_object_get(claim, "level")), "stop") == 0);
        if (strcmp(key, "target") == 0 &&
            json_unpack((json_t *)numbers, "{s:F, s:[F, F]}", "load", &load, "interval", &low, &high) == 0)
            assert_true(low <= load && load <= high);
        if (strcmp(key, "by-roughness") == 0 &&
            json_unpack((json_t *)numbers, "{s:[F, F]}", "values", &low, &high) == 0)
            assert_true(fmax(low, high) < 1e-3); /* ohm m2 of 1 mm2, not microohms */
        if (strcmp(json_string_value(json_object_get(claim, "level")), "uncertainty") != 0)
            continue;
        if (json_unpack((json_t *)numbers, "{s:F}", "factor", &factor) == 0) {
            assert_true(factor <= before);
            before = factor;
        }
        if (strcmp(key, "uncertainty") == 0) {
            assert_int_equal(
                json_unpack((json_t *)numbers, "{s:F, s:F, s:F}", "model", &model, "scans", &scans, "waves", &waves),
                0);
            assert_near(model + scans + waves, 1, 1e-12);
        }
    }
}

TEST_IN_WORKSPACE(every_row_holds)
{
    make_folder(place);
    read_rows();
    const json_t *claims[ROWS_MOST];
    size_t scenes = 0, every = support_number("ROUGHCONTACT_EVERY", 1);
    for (size_t i = 0; i < line_count; i++) {
        const char *scene = lines[i][1];
        size_t same = 0; /* the first row of this scene, which runs it */
        while (strcmp(lines[same][1], scene) != 0)
            same++;
        if (same == i) {
            claims[i] = scenes++ % every == 0 ? claims_of(place, scene) : NULL;
            expect_list(claims[i]);
        }
        if (!claims[same])
            continue;
        const bool wanted = lines[i][2][0] != '-';
        const char *text = said(claims[same], lines[i][0], lines[i][2] + !wanted);
        if ((text != NULL) != wanted)
            fail_msg("'%s' of %s: %s\n%s", lines[i][0], scene, text ? text : "is not said",
                     json_dumps(claims[same], JSON_INDENT(1)));
    }
}

/** The first table has letters of three surfaces or more, where a claim says what the ranking finds: not beside a
 * measured number, nor beside one that is not ranked. */
TEST_IN_WORKSPACE(two_surfaces_need_no_letters)
{
    static const char letters[] = "Surfaces with a letter in common";
    static const struct {
        const char *others, *said;
    } cases[] = {{"", NULL},
                 {", {name: B, file: \"b-*.csv\"}", NULL},
                 {", {name: B, file: \"b-*.csv\"}, {name: D, file: \"d-*.csv\"}", letters},
                 {", {name: B, file: \"b-*.csv\", measured: {file: m95.txt}}, {name: D, file: \"d-*.csv\"}", NULL},
                 {", {name: B, file: \"b-*.csv\"}, {name: D, file: \"d-*.csv\"}], targets: [{gap: 1 um}", NULL}};
    make_folder(place);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        claims_of(place, filled("{material: bronze, counterface: same, nominal_area: 1 mm2, operating_load: 1 N, "
                                "surfaces: [{name: A, file: \"a-*.csv\"}%s]}",
                                cases[i].others));
        const char *report = workspace_read(place, "o/report.md");
        assert_int_equal(strstr(report, letters) != NULL, cases[i].said == letters);
        assert_int_equal(strstr(report, "| differs |") != NULL, cases[i].said == letters);
    }
}

/** Each claim that has words has a scene that says it and one that does not. */
TEST_CASE(every_key_has_both)
{
    const char *words = directory_read(PROJECT_SOURCE, "templates/words.txt");
    size_t keys = 0;
    read_rows();
    for (const char *line = strstr(words, "\nclaim."); line; line = strstr(line + 1, "\nclaim.")) {
        const char *key = filled("%.*s", (int)strcspn(line + 7, " "), line + 7);
        bool both[2] = {false, false};
        for (size_t i = 0; i < line_count; i++)
            if (strcmp(lines[i][0], key) == 0)
                both[strcmp(lines[i][2], "-") == 0] = true;
        if (!both[0] || !both[1])
            fail_msg("tests/claims.tsv has no scene %s '%s'", both[0] ? "against" : "for", key);
        keys++;
    }
    assert_true(keys > 30);
}
