/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The strips of a surface: which rows, at what cost, and what its curve is made of them. */
#include "analysis/effects.h"
#include "analysis/repeats.h"
#include "analysis/strips.h"
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
    struct status status = {0};
    double *height_m = calloc(points, sizeof *height_m);
    assert_non_null(height_m);
    for (size_t i = 0; i < points; i++)
        for (int n = 2; n < 24; n++)
            height_m[i] += 1e-7 * pow(n, -1.3) *
                           cos(2 * M_PI * n * (double)i / (double)points + 7.1 * n * n * (double)(set.count + 1));
    set.keeps_heights = true;
    while (set.scan_count <= scan)
        assert_int_equal(repeats_add_scan(&set, "scan", &status), STATUS_OK);
    assert_int_equal(ensemble_add(&set, scan, height_m, points, spacing_m, &how, &status), STATUS_OK);
    set.sigma_m = sqrt(set.members[0].roughness.m0_m2);
    free(height_m);
    return &set.members[set.count - 1];
}

static void gather(void)
{
    struct status status = {0};
    strips_free(&strips);
    assert_int_equal(strips_gather(&strips, &set, &status), STATUS_OK);
}

static void assert_row(size_t row, size_t member)
{
    assert_memory_equal(strips.height_m + row * strips.rows.points, set.members[member].height_m,
                        strips.rows.points * sizeof(double));
}

/* One scan; several; pieces of them; none of which close where one does not. */
FREED(rows_of_scans)
{
    struct scene scene = {.level = LEVEL_MEAN, .level_given = true};
    struct status status = {0};
    size_t cut;
    for (size_t scans = 1; scans <= 3; scans++) {
        add(scans - 1, scans < 3 ? POINTS : 2 * POINTS, 1e-6)->periodic = scans < 2;
        if (scans == 3)
            assert_int_equal(repeats_cut_to_shortest(&set, &cut, &scene, &status), STATUS_OK);
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

/* Of a map 8 at most, evenly spaced, of those that lack no point. */
FREED(rows_of_a_map)
{
    for (size_t r = 0; r < 40; r++) {
        add(0, POINTS, 1e-6);
        if (r == 7) {
            gather();
            assert_int_equal(strips.rows.rows, 8);
        }
    }
    gather();
    assert_int_equal(strips.rows.rows, 8);
    for (size_t r = 0; r < 8; r++)
        assert_row(r, 5 * r + 2);
    set.members[2].points = POINTS - 1; /* then 39 are left */
    gather();
    assert_int_equal(strips.rows.points, POINTS);
    for (size_t r = 0; r < 8; r++)
        assert_row(r, (2 * r + 1) * 39 / 16 + 1);
}

/* No strips of scans that cannot be joined, or of which no heights are there. */
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

/* As many surrogates as the budget allows, 4, 2, 1 or none; all of them where the models are named. */
FREED(a_budget)
{
    struct scene scene = {.surface_count = 1};
    assert_int_equal(strips_surrogates(&strips, &scene), 0);
    add(0, POINTS, 1e-6);
    gather();
    assert_int_equal(strips_cost(&strips, 3), strip_cost(&strips.rows, 1, 3));
    add(1, POINTS, 1e-6);
    gather();
    assert_int_equal(strips_cost(&strips, 3),
                     strip_cost(&strips.rows, 2, 3) + 2 * strip_cost(&strips.rows, 1, 3)); /* joined, and each alone */
    for (size_t surrogates = STRIP_SURROGATES; surrogates > 0; surrogates /= 2) {
        scene.surface_count = (size_t)(strips_budget / (double)strips_cost(&strips, surrogates));
        assert_int_equal(strips_surrogates(&strips, &scene), surrogates);
        scene.surface_count++;
        assert_int_equal(strips_surrogates(&strips, &scene), surrogates / 2);
    }
    scene.models_named = true;
    assert_int_equal(strips_surrogates(&strips, &scene), STRIP_SURROGATES);
}

static enum status_code solve(const atomic_bool *stop)
{
    struct status status = {0};
    return strips_solve(&strips, &set, 1, stop, &status);
}

/* All rows, and of scans each alone; what touches nowhere has none; nothing when stopped. */
FREED(solved)
{
    atomic_bool stop = true;
    add(0, POINTS, 1e-6);
    add(0, POINTS, 1e-6);
    gather();
    assert_int_equal(solve(&stop), STATUS_INTERRUPTED);
    assert_null(strips.joined);
    gather();
    assert_int_equal(solve(NULL), STATUS_OK);
    assert_non_null(strips.joined);
    struct strip expected;
    static const size_t both[] = {0, 1};
    struct status status = {0};
    assert_int_equal(strip_solve(&expected, &strips.rows, both, 2, 1, NULL, &status), STATUS_OK);
    assert_memory_equal(strips.joined, &expected, sizeof expected);
    assert_null(set.members[0].strip); /* rows of a map */
    assert_int_equal(strips.transforms, strips.joined->transforms);
    bearing_free(&strips.bearing);
    free(strips.joined);
    strips.joined = NULL;
    set.members[1].scan = 1;
    set.scan_count = 2;
    assert_int_equal(solve(NULL), STATUS_OK);
    uint64_t alone = 0;
    for (size_t p = 0; p < 2; p++) {
        assert_non_null(set.members[p].strip);
        assert_true(set.members[p].strip->own.count > 3);
        alone += set.members[p].strip->transforms;
    }
    assert_true(set.members[0].strip->own.value[0][0] != set.members[1].strip->own.value[0][0]);
    assert_int_equal(strips.transforms, 2 * strips.joined->transforms + alone);
    strips_free(&strips);
    ensemble_free(&set);
    memset(add(0, POINTS, 1e-6)->height_m, 0, POINTS * sizeof(double));
    gather();
    assert_int_equal(solve(NULL), STATUS_OK);
    assert_null(strips.joined);
    expect_parts(strips.problem.message, "is flat"); /* the note's reason */
}

/* Scans of few of their longest waves, with open ends, know less. */
static double sd_of(double model_sd, double waves)
{
    return hypot(model_sd, 1.3 * log(2.5 / waves));
}

/* Of scans the geometric mean of their curves and of the joined rows'; of a map the latter alone. Its error and the
 * scatter add in quadrature; no area's end lies above 1. */
FREED(a_curve_from_strips)
{
    static const double loads[LOADS] = {1e-5, 1e-4, 1e-3, 2e-3, 4e-3};
    static const enum quantity quantities[] = {QUANTITY_AREA, QUANTITY_SEPARATION, QUANTITY_ECR};
    const struct material_pair pair = material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    const struct model_row *model = model_rows[model_named("strip")];
    struct status status = {0};
    for (size_t p = 0; p < 3; p++)
        add(p, POINTS, 1e-6);
    gather();
    assert_int_equal(solve(NULL), STATUS_OK);
    struct model_task task = {.spectrum = &set.members[1].spectrum,
                              .pair = &pair,
                              .loads = loads,
                              .load_count = LOADS,
                              .wanted = quantity_wanted((1u << EFFECT_COUNT) - 1),
                              .tolerance = 1e-8,
                              .hardness_Pa = NAN,
                              .rows = &strips.rows,
                              .strip = strips.joined};
    struct contact_point points[LOADS + 1], own_points[4][LOADS + 1];
    struct model_curve curve, own[4];
    for (size_t p = 0; p < 4; p++) { /* the fourth is the joined rows' */
        struct asperities none;
        struct model_task alone = p < 3 ? member_task(&none, &set.members[p], &task) : task;
        own[p] = (struct model_curve){.points = own_points[p]};
        assert_int_equal(model_run(&own[p], model, &alone, &status), STATUS_OK);
        assert_int_equal(own[p].count, LOADS);
    }
    size_t cut_off = 0;
    double waves = spectrum_longest_waves(task.spectrum);
    assert_true(waves > 1 && waves < 2.5 && strips.rows.periodic);
    strips.rows.periodic = false; /* of these, strips are solved above */
    for (int map = 0; map < 2; map++) {
        struct ensemble_result result = {.band = ensemble_band_make(loads, LOADS)};
        assert_non_null(result.band);
        set.scan_count = map ? 1 : 3;
        curve = (struct model_curve){.points = points};
        assert_int_equal(ensemble_curve(&curve, &result, &set, model, &task, &status), STATUS_OK);
        assert_int_equal(curve.count, LOADS);
        for (size_t i = 0; i < LOADS; i++)
            for (int k = 0; k < 3; k++) {
                enum quantity q = quantities[k];
                double sum = 0, square = 0, joined = log(own_points[3][i].value[q]),
                       width = 1.96 * sd_of(model->ln_sd[k], waves);
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
                double sd = sqrt((square - sum * sum / 3) / 2), t = 4.302652729911275; /* t(2) */
                double mean_sd[] = {sd / sqrt(3), sd * sqrt(1 + 1 / 3.0)};
                const double *ends[] = {result.band[i].mean[q], result.band[i].next[q]};
                double factor = q == QUANTITY_SEPARATION ? set.sigma_m : 1;
                for (int which = 0; which < 2; which++) {
                    double half = hypot(t * mean_sd[which], width);
                    bool above = q == QUANTITY_AREA && mean + half > 0;
                    assert_near(factor * ends[which][0], exp(mean - half), 1e-6);
                    assert_near(factor * ends[which][1], above ? 1 : exp(mean + half), 1e-6);
                    cut_off += above;
                }
                if (i == LOADS / 2)
                    assert_near(result.estimates[q].model_sd, sd_of(model->ln_sd[k], waves), 1e-15);
            }
        free(result.band);
    }
    assert_true(cut_off > 0);
}

/* Unasked, strips run where all surfaces have them; else the corrected theory leads, and the account says why. */
TEST_CASE(strips_are_left_out)
{
    static const struct {
        double cost;
        bool has[2];
        const char *models, *leading; /* NULL: the defaults */
        const char *reason;
    } rows[] = {
        {1e9, {true, true}, NULL, "strip", "every report has it"},
        {1e9,
         {true, false},
         NULL,
         "corrected-persson",
         "every report has it; strips of the scans would take about 24 s: name the model strip to have them"},
        {0, {true, false}, NULL, "strip", "every report has it"}, /* which has no number on the other */
        {0, {false, false}, NULL, "corrected-persson", "every report has it; no strip transfer, as no surface has one"},
        {1e9, {true, false}, "statistical", "gw", "every report has it"},
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        struct scene scene = {.models = rows[k].models ? model_find(rows[k].models) : model_defaults()};
        struct surface_record surfaces[2] = {{.summary = {.usable = true}}, {.summary = {.usable = true}}};
        struct plan plan;
        for (int s = 0; s < 2; s++) {
            surfaces[s].summary.has_strips = rows[k].has[s];
            surfaces[s].summary.strip_cost = rows[k].has[s] ? 1e9 : rows[k].cost;
        }
        plan_make(&plan, &scene);
        effects_decide(&plan, &scene, surfaces, 2);
        assert_string_equal(plan.area_reason, rows[k].reason);
        assert_string_equal(model_rows[plan_leading_model(&plan)]->name, rows[k].leading);
    }
}
