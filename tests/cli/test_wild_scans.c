/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Folders of random scans and scenes from fixed seeds: the program ends with 0, 1, 3 or 4, reports no fault of its own,
 * and writes no NaN or infinity. Each value of each key is in at least one of them. ROUGHCONTACT_WILD=10000 makes that
 * many, ROUGHCONTACT_WILD_FIRST=17 begins with that seed, ROUGHCONTACT_EVERY=3 takes each third. */
#include "cli/process.h"
#include "hard_case.h"
#include "scene/scene_source.h"
#include "wild_scene.h"

HARD_CASES("Folders that no one would make")

static uint64_t random_state;

/* splitmix64, from 0 to below 1 */
static double uniform(void)
{
    uint64_t z = random_state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

static size_t below(size_t count)
{
    return (size_t)(uniform() * (double)count);
}

static bool once_in(size_t count)
{
    return below(count) == 0;
}

static double between(double low, double high)
{
    return low + (high - low) * uniform();
}

static double normal(void)
{
    return sqrt(-2 * log(1 - uniform())) * cos(2 * M_PI * uniform());
}

enum kind { BROWNIAN, WHITE, SINE, STEPS, PITS, EXPONENTIAL, PARABOLA, QUANTISED, CAUCHY, CHIRP, KINDS };

/* Heights of that kind, of the order of 1. */
static void make_heights(double *z, size_t points, enum kind kind)
{
    double walk = 0, level = 0, waves = between(0.5, 20), step = between(0.01, 1), phase = between(0, 6);
    for (size_t i = 0; i < points; i++) {
        double t = (double)i / (double)points;
        walk += normal() / sqrt((double)points);
        level = once_in(10) ? normal() : level;
        double of[KINDS] = {[BROWNIAN] = walk,
                            [WHITE] = normal(),
                            [SINE] = sin(2 * M_PI * waves * t + phase),
                            [STEPS] = level,
                            [PITS] = once_in(20) ? -uniform() : 0,
                            [EXPONENTIAL] = -log(1 - uniform()),
                            [PARABOLA] = 4 * t * (1 - t),
                            [QUANTISED] = step * round(walk / step),
                            [CAUCHY] = tan(M_PI * (uniform() - 0.5)),
                            [CHIRP] = sin(2 * M_PI * waves * t * t)};
        z[i] = of[kind];
    }
}

static void write_scan(const char *place, const char *path, size_t points, enum kind kind, double height_m,
                       double spacing_m)
{
    struct text *csv = support_text();
    double *z = support_room(points * sizeof *z);
    make_heights(z, points, kind);
    text_add(csv, "x [m],z [m]\n");
    for (size_t i = 0; i < points; i++)
        text_add(csv, "%.17g,%.17g\n", spacing_m * (double)i, height_m * z[i]);
    workspace_write(place, path, text_string(csv));
}

static size_t some_points(void)
{
    return once_in(20) ? 3 + below(14) : (size_t)(16 * pow(400.0 / 16, uniform()));
}

/* Repeated scans of one surface, alike or not. */
static void write_surface(const char *place, size_t surface)
{
    size_t scans = once_in(3) ? 1 : 2 + below(3), points = some_points();
    enum kind kind = (enum kind)below(KINDS);
    double height_m = pow(10, between(-15, 0)), spacing_m = pow(10, between(-13, 2));
    bool usual = once_in(2); /* as instruments have them */
    if (usual) {
        height_m = pow(10, between(-8, -5));
        spacing_m = pow(10, between(-7, -5));
    }
    for (size_t scan = 0; scan < scans; scan++) {
        write_scan(place, filled("in/s%zu/scan%zu.csv", surface, scan), points, kind, height_m, spacing_m);
        if (once_in(3))
            height_m *= pow(10, once_in(3) ? between(-15, 5) : between(-1, 1));
        if (once_in(6))
            spacing_m *= once_in(2) ? 1000 : pow(10, between(-1, 1));
        if (once_in(6))
            points = some_points();
        if (once_in(6))
            kind = (enum kind)below(KINDS);
    }
}

/* How many values the keys of a scene have together. */
static size_t wild_values(void)
{
    return wild_scene(support_text(), (const char *const[]){NULL}, below, SIZE_MAX);
}

static void expect_reported_or_refused(const char *place, size_t seed)
{
    size_t sure = seed % wild_values();
    struct text *scene = support_text();
    random_state = seed;
    print_message("seed %zu\n", seed);
    for (size_t surface = 1 + below(3); surface > 0; surface--)
        write_surface(place, surface);
    wild_scene(scene, (const char *const[]){NULL}, below, sure);
    workspace_write(place, "in/scene.yaml", text_string(scene));
    struct process run = process_run(place, "report", "in", "-o", "out", once_in(8) ? "-v" : "--no-cost");
    print_message("exit status %d\n", run.status);
    if (run.status == 3 &&
        !strstr(run.err, "the counterface cannot be read")) /* what the material lacks for what was asked */
        expect_part(run.err, "in/scene.yaml:");
    else if (run.status != 0 && run.status != 1 && run.status != 3 && run.status != 4)
        fail_msg("exit status %d: ...%s", run.status, run.err + (strlen(run.err) > 400 ? strlen(run.err) - 400 : 0));
    if (run.status == 4 && !strstr(run.err, "no scan in") && /* the only one is the counterface */
        !strstr(run.err, "no model is left for"))            /* of those that the scene names */
        expect_part(run.err, "no usable surface");
    expect_no_parts(run.err, "fault of the program", "please report", "ERROR: ");
    static struct hard_case row = {
        .words = {
            "210 folders of made-up scans and scenes: walks, steps, pits, chirps, Cauchy's heights, 1e-15 to 1 m, "
            "1e-13 to 100 m apart, unlike scans in one surface",
            "what no author of a test has thought of",
            "reported, or refused with the reason; no word of a fault of its own",
            "other exit statuses than 0, 1, 3, 4"}};
    hard_case_met(&row, run.status > 4 || run.status == 2, 0, __FILE__, __LINE__);
    process_expect_numbers(run.out, "stdout");
    process_expect_numbers(run.err, "stderr");
    if (run.status < 2)
        assert_true(workspace_expect_numbers(place, "out") > 5);
}

TEST_WITH(folders_are_reported_or_refused, directory_setup, directory_teardown)
{
    size_t first = support_number("ROUGHCONTACT_WILD_FIRST", 1),
           count = support_number("ROUGHCONTACT_WILD", 2 * wild_values());
    size_t every = support_number("ROUGHCONTACT_EVERY", 1);
    for (size_t seed = first; seed < first + count; seed += every) {
        expect_reported_or_refused(*state, seed);
        assert_true(directory_teardown(state) == 0 &&
                    directory_setup(state) == 0); /* the next begins with an empty one */
    }
}

/* A key that is new is tried with the others. */
TEST_CASE(every_key_is_tried)
{
    for (size_t k = 0; k < scene_key_count; k++) {
        const char *name = scene_keys[k].name;
        bool elsewhere = strcmp(name, "title") == 0 || strcmp(name, "surfaces") == 0 || strcmp(name, "measured") == 0 ||
                         strcmp(name, "template") == 0;
        for (size_t i = 0; i < WILD_KEYS; i++)
            elsewhere = elsewhere || strcmp(name, wild_keys[i].key) == 0;
        if (!elsewhere)
            fail_msg("no scene of tests/wild_scene.h has the key '%s'", name);
    }
}
