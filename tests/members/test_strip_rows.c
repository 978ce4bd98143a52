/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The strips of a surface: which rows they take, what they cost, and the curve from them. */
#include "members/repeats.h"
#include "members/scan_strips.h"
#include "plan/effects.h"
#include "statistics/interval.h"
#include "support.h"

enum { POINTS = 256, LOADS = 5 };

static struct ensemble set;
static struct strips strips;

static int end(void **state)
{
    (void)state;
    strips_free(&strips);
    ensemble_free(&set);
    return 0;
}

#define FREED(name) TEST_WITH(name, NULL, end)

/** A member of waves whose phases its number gives, of a file of its own where there is none of that number yet. */
static struct member *add(size_t scan, size_t points, double spacing_m)
{
    const struct record_conditioning how = {
        .level = LEVEL_MEAN, .periodic = true, .moments = ROUGHNESS_MOMENTS_SPECTRAL};
    double *height_m = support_room(points * sizeof *height_m);
    for (size_t i = 0; i < points; i++)
        for (int n = 2; n < 24; n++)
            height_m[i] += 1e-7 * pow(n, -1.3) *
                           cos(2 * M_PI * n * (double)i / (double)points + 7.1 * n * n * (double)(set.count + 1));
    set.keeps_heights = true;
    while (set.scan_count <= scan)
        expect_ok(repeats_add_scan, &set);
    expect_ok(ensemble_add, &set, scan, &(struct record_heights){height_m, points, spacing_m}, &how);
    set.sigma_m = sqrt(set.members[0].roughness.m0_m2);
    return &set.members[set.count - 1];
}

static void gather(void)
{
    strips_free(&strips);
    for (size_t p = 0; p < set.count; p++) {
        solved_strip_free(set.members[p].strip);
        set.members[p].strip = NULL;
        set.members[p].pieces = 0;
    }
    expect_ok(strips_gather, &strips, &set, false);
}

static void assert_row(size_t row, size_t member)
{
    assert_memory_equal(strips.height_m + row * strips.rows.points, set.members[member].height_m,
                        strips.rows.points * sizeof(double));
}

/* One scan; several; pieces. If one is not periodic, none is treated as periodic. */
FREED(rows_of_scans)
{
    struct scene scene = {.level = LEVEL_MEAN, .level_given = true};
    size_t cut;
    for (size_t scans = 1; scans <= 3; scans++) {
        add(scans - 1, scans < 3 ? POINTS : 2 * POINTS, 1e-6)->periodic = scans < 2;
        if (scans == 3)
            expect_ok(repeats_cut_to_shortest, &set, &cut, &scene);
        gather();
        assert_int_equal(set.count, scans < 3 ? scans : 4); /* the long one is two */
        assert_int_equal(strips.rows.rows, set.count);
        assert_int_equal(strips.rows.points, POINTS);
        assert_near(strips.rows.spacing_m, 1e-6, 0);
        assert_int_equal(strips.rows.periodic, scans == 1);
        for (size_t r = 0; r < set.count; r++)
            assert_row(r, r);
    }
}

/* Of a map evenly spaced rows among those without missing points. */
FREED(rows_of_a_map)
{
    for (size_t r = 0; r < 72; r++) {
        add(0, POINTS, 1e-6)->is_row = true;
        if (r == 7) {
            gather();
            assert_int_equal(strips.rows.rows, 8);
        }
    }
    gather();
    assert_int_equal(strips.rows.rows, STRIPS_PIECES);
    for (size_t r = 0; r < STRIPS_PIECES; r++)
        assert_row(r, 3 * r + 1);
    set.members[0].points = POINTS - 1; /* then 71 are left */
    gather();
    assert_int_equal(strips.rows.points, POINTS);
    for (size_t r = 0; r < STRIPS_PIECES; r++)
        assert_row(r, (2 * r + 1) * 71 / 48 + 1);
}

/* No strips of scans that cannot be joined, or whose heights are not there. */
FREED(no_rows)
{
    for (int how = 0; how < 3; how++) {
        ensemble_free(&set);
        add(0, POINTS, 1e-6);
        struct member *other = add(1, how == 0 ? POINTS / 2 : POINTS, how == 1 ? 1.00001e-6 : 1e-6);
        if (how == 2) {
            free(other->height_m);
            other->height_m = NULL;
        }
        gather();
        assert_int_equal(strips.rows.rows, 0);
        assert_null(strips.height_m);
    }
}

/* Scans are taken whole if they are at most 24 with 65 536 points together; else pieces, evenly spread over the scans
 * and along them. The cost does not grow with the scans. */
FREED(pieces)
{
    static const struct {
        size_t scans, points, rows, length, each;
    } cases[] = {
        {1, 65536, 1, 65536, 1}, {1, 65537, 6, 8192, 6},  {1, 200000, 6, 8192, 6},
        {2, 40000, 6, 8192, 3},  {3, 30000, 6, 8192, 2},  {5, 20000, 5, 8192, 1},
        {24, 2730, 24, 2730, 1}, {24, 3000, 21, 3000, 1}, {60, 100, 24, 100, 1},
    };
    const struct strip_rows largest = {.rows = 1, .points = STRIPS_POINTS};
    const uint64_t most_cost = strip_cost(&largest);
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        size_t scans = cases[c].scans, points = cases[c].points, length = cases[c].length, each = cases[c].each;
        ensemble_free(&set);
        for (size_t p = 0; p < scans; p++) {
            struct member *member = ensemble_room(&set);
            *member = (struct member){.scan = p, .points = points, .spacing_m = 1e-6, .periodic = true};
            expect_ok(repeats_add_scan, &set);
            assert_non_null(member->height_m = malloc(points * sizeof(double)));
            for (size_t i = 0; i < points; i++)
                member->height_m[i] = (double)(p * points + i);
        }
        gather();
        assert_int_equal(strips.rows.rows, cases[c].rows);
        assert_int_equal(strips.rows.points, length);
        assert_true(strips.rows.periodic == (length == points));
        assert_true(strips.rows.rows <= STRIPS_PIECES && strips.rows.rows * length <= STRIPS_POINTS);
        size_t chosen = 0, least = points, most = 0;
        for (size_t p = 0; p < scans; p++) {
            const struct member *member = &set.members[p];
            assert_true(member->pieces == 0 || (member->pieces == each && member->first_piece == chosen * each));
            chosen += member->pieces > 0;
            for (size_t k = member->first_piece; k < member->first_piece + member->pieces; k++) {
                const double *row = strips.height_m + k * length;
                size_t first = (size_t)row[0] - p * points;
                least = first < least ? first : least;
                most = first > most ? first : most;
                for (size_t i = 0; i < length; i++)
                    assert_near(row[i], (double)(p * points + first + i), 0);
            }
        }
        assert_int_equal(chosen * each, strips.rows.rows);
        assert_true(least == 0 && most == points - length);
        assert_true(strip_cost(&strips.rows) <= most_cost);
    }
}

/** Open scans lose a few points so that their transforms are fast; periodic ones keep all. */
FREED(quick_lengths)
{
    static const struct {
        size_t points, length;
    } cases[] = {{1009, 1008}, {4280, 4235}, {1001, 1001}, {64, 64}};
    for (int periodic = 0; periodic < 2; periodic++)
        for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
            size_t points = cases[c].points, length = periodic ? points : cases[c].length;
            ensemble_free(&set);
            struct member *member = ensemble_room(&set);
            *member = (struct member){.points = points, .spacing_m = 1e-6, .periodic = periodic};
            expect_ok(repeats_add_scan, &set);
            assert_non_null(member->height_m = calloc(points, sizeof(double)));
            gather();
            assert_int_equal(strips.rows.points, length);
            assert_int_equal(strips.rows.periodic, periodic);
        }
}

static enum status_code solve(const struct threads *threads)
{
    struct status status = {0};
    enum status_code rc = strips_solve(&strips, threads, &status);
    if (rc == STATUS_OK && set.scan_count > 1)
        rc = strips_solve_members(&strips, &set, threads, &status);
    return rc;
}

/* All rows joined, and each scan alone; a flat surface has no solution; nothing is solved when stopped. */
FREED(solved)
{
    atomic_bool stop = true;
    add(0, POINTS, 1e-6);
    add(0, POINTS, 1e-6);
    gather();
    assert_int_equal(solve(&(struct threads){1, &stop}), STATUS_INTERRUPTED);
    assert_null(strips.joined);
    gather();
    assert_int_equal(solve(&test_alone), STATUS_OK);
    assert_non_null(strips.joined);
    struct strip expected;
    expect_ok(strip_solve, &expected, &strips.rows, STRIP_SURROGATES, &test_alone);
    assert_memory_equal(&strips.joined->strip, &expected, sizeof expected);
    assert_null(set.members[0].strip); /* rows of a map */
    assert_int_equal(strips.transforms, strips.joined->strip.transforms);
    set.members[1].scan = 1;
    expect_ok(repeats_add_scan, &set);
    expect_ok(strips_solve_members, &strips, &set, &test_alone);
    uint64_t alone = 0;
    for (size_t p = 0; p < 2; p++) {
        const struct solved_strip *own = set.members[p].strip;
        assert_non_null(own);
        assert_true(own->strip.own.count > 3);
        struct strip_rows row = strips.rows;
        row.height_m = set.members[p].height_m;
        row.seed += set.members[p].first_piece;
        row.rows = 1;
        expect_ok(strip_solve, &expected, &row, STRIP_SURROGATES, &test_alone);
        assert_memory_equal(&own->strip, &expected, sizeof expected);
        assert_int_equal(own->bearing.count, POINTS);
        alone += own->strip.transforms;
    }
    assert_true(set.members[0].strip->strip.own.value[0][0] != set.members[1].strip->strip.own.value[0][0]);
    assert_int_equal(strips.transforms, strips.joined->strip.transforms + alone);
    strips_free(&strips);
    ensemble_free(&set);
    memset(add(0, POINTS, 1e-6)->height_m, 0, POINTS * sizeof(double));
    gather();
    assert_int_equal(solve(&test_alone), STATUS_OK);
    assert_null(strips.joined);
    expect_parts(strips.problem.message, "is flat"); /* the note's reason */
}

/* Three scans, joined and each alone, and the task of the second under the joined strip. */
static struct model_task three_scans(const double *loads, size_t count)
{
    static struct material_pair tin;
    tin = material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    for (size_t p = 0; p < 3; p++)
        add(p, POINTS, 1e-6);
    gather();
    assert_int_equal(solve(&test_alone), STATUS_OK);
    return (struct model_task){.spectrum = &set.members[1].spectrum,
                               .pair = &tin,
                               .loads = loads,
                               .load_count = count,
                               .wanted = quantity_wanted((1u << EFFECT_COUNT) - 1),
                               .tolerance = 1e-8,
                               .hardness_Pa = NAN,
                               .strip = &strips.joined->strip};
}

/* With a hardness every scan uses its own bearing curve; scans not solved alone have no answer. */
FREED(scans_alone)
{
    static const double load = 1e-3;
    const struct model_row *model = model_rows[model_named("strip-plastic")];
    struct model_task task = three_scans(&load, 1);
    task.hardness_Pa = 0.1 * task.pair->effective_modulus_Pa;
    task.bearing = &strips.joined->bearing;
    for (size_t left = 3; left > 0; left--) { /* the others are not solved */
        struct ensemble_curves curves;
        expect_ok(ensemble_run, &curves, &set, model, &task, NULL);
        assert_int_equal(curves.count, left);
        assert_int_equal(curves.left_out, 0);
        for (size_t p = 0; p < left; p++) {
            struct contact_point points[2];
            struct model_curve own = {.points = points};
            struct model_task alone = task;
            alone.spectrum = &set.members[p].spectrum;
            alone.strip = &set.members[p].strip->strip;
            alone.bearing = &set.members[p].strip->bearing;
            expect_ok(model_run, &own, model, &alone);
            assert_near(curves.points[2 * p].value[QUANTITY_ECR], points[0].value[QUANTITY_ECR], 0);
            alone.bearing = &strips.joined->bearing;
            expect_ok(model_run, &own, model, &alone);
            assert_true(curves.points[2 * p].value[QUANTITY_ECR] != points[0].value[QUANTITY_ECR]);
        }
        ensemble_curves_free(&curves);
        solved_strip_free(set.members[left - 1].strip);
        set.members[left - 1].strip = NULL;
    }
}

/* The model's error grows for open scans with few of their longest waves. */
static double sd_of(double model_sd, double waves)
{
    return hypot(model_sd, 1.3 * log(2.5 / waves));
}

/* Scans: the geometric mean of their curves and that of the joined rows; a map: the latter alone. The model's error and
 * the scatter add as variances; no end of an area exceeds 1. */
FREED(a_curve_from_strips)
{
    static const double loads[LOADS] = {1e-5, 1e-4, 1e-3, 2e-3, 4e-3};
    static const enum quantity quantities[] = {QUANTITY_AREA, QUANTITY_SEPARATION, QUANTITY_ECR};
    const struct model_row *model = model_rows[model_named("strip")];
    struct model_task task = three_scans(loads, LOADS);
    struct material_pair hard = *task.pair; /* an elastic contact that would yield has no interval */
    hard.hardness_Pa = INFINITY;
    task.pair = &hard;
    struct contact_point points[LOADS + 1], own_points[4][LOADS + 1];
    struct model_curve curve, own[4];
    for (size_t p = 0; p < 4; p++) { /* the fourth is the joined rows' */
        struct asperities none;
        struct model_task alone = p < 3 ? member_task(&none, &set.members[p], &task) : task;
        own[p] = (struct model_curve){.points = own_points[p]};
        expect_ok(model_run, &own[p], model, &alone);
        assert_int_equal(own[p].count, LOADS);
    }
    size_t cut_off = 0;
    double waves = spectrum_longest_waves(task.spectrum);
    assert_true(waves > 1 && waves < 2.5 && strips.rows.periodic);
    task.open = true;
    for (int map = 0; map < 2; map++) {
        struct ensemble_result result = {.band = test_owns(ensemble_band_make(loads, LOADS), free)};
        set.scan_count = map ? 1 : 3;
        curve = (struct model_curve){.points = points};
        expect_ok(ensemble_curve, &curve, &result, &set, model, &task);
        assert_int_equal(curve.count, LOADS);
        for (size_t i = 0; i < LOADS; i++)
            for (int k = 0; k < 3; k++) {
                enum quantity q = quantities[k];
                double sum = 0, square = 0, joined = log(own_points[3][i].value[q]),
                       own_sd = sd_of(model_sd(model, quantities[k], false), waves);
                for (size_t p = 0; p < 3; p++) {
                    double over = q == QUANTITY_SEPARATION ? sqrt(set.members[p].roughness.m0_m2) / set.sigma_m : 1;
                    double value = log(own_points[p][i].value[q] / over);
                    sum += value;
                    square += value * value;
                }
                double mean = map ? joined : (sum / 3 + joined) / 2;
                assert_near(points[i].value[q], exp(mean), 1e-12);
                if (map)
                    continue;
                double sd = sqrt((square - sum * sum / 3) / 2);
                double mean_sd[] = {sd / sqrt(3), sd * sqrt(1 + 1 / 3.0)};
                const double *ends[] = {result.band[i].mean[q], result.band[i].next[q]};
                double factor = q == QUANTITY_SEPARATION ? set.sigma_m : 1;
                for (int which = 0; which < 2; which++) {
                    double both = hypot(mean_sd[which], own_sd); /* Satterthwaite, from 2 */
                    double half = interval_quantile(0.95, 2 * pow(both / mean_sd[which], 4)) * both;
                    bool above = q == QUANTITY_AREA && mean + half > 0;
                    assert_near(factor * ends[which][0], exp(mean - half), 1e-6);
                    assert_near(factor * ends[which][1], above ? 1 : exp(mean + half), 1e-6);
                    cut_off += above;
                }
                if (i == LOADS / 2)
                    assert_near(result.estimates[q].model_sd, sd_of(model_sd(model, quantities[k], false), waves),
                                1e-15);
            }
    }
    assert_true(cut_off > 0);
}

/* Strips run if a surface has them; else the corrected theory leads, with the reason. */
TEST_CASE(strips_are_left_out)
{
    static const struct {
        bool has[2];
        const char *models, *leading; /* NULL: the defaults */
        const char *reason;
    } rows[] = {
        {{true, true}, NULL, "strip", "every report has it"},
        {{true, false}, NULL, "strip", "every report has it"}, /* which has no number on the other */
        {{false, false}, NULL, "corrected-persson", "every report has it; no surface has strips"},
        {{false, false}, "statistical", "gw", "every report has it"},
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        struct scene scene = {.models = rows[k].models ? model_find(rows[k].models) : model_defaults()};
        struct surface_record surfaces[2] = {{.summary = {.usable = true}}, {.summary = {.usable = true}}};
        struct plan plan;
        for (int s = 0; s < 2; s++)
            surfaces[s].summary.has_strips = rows[k].has[s];
        plan_make(&plan, &scene, support_words());
        effects_fit_models(&plan, surfaces, 2);
        assert_string_equal(plan.area_reason, rows[k].reason);
        assert_string_equal(model_rows[plan_leading_model(&plan)]->name, rows[k].leading);
    }
}
