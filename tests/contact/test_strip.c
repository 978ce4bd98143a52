/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The strip transfer: what is known of it in closed form, and what has to hold whatever the heights. */
#include "contact/corrected_persson.h"
#include "contact/model.h"
#include "contact/strip.h"
#include "direct_points.h"
#include "model_support.h"

enum { POINTS = 1024, ROWS = 4 };

/** Gaussian rows, periodic, wavelengths from L/2 to 16 points, amplitudes falling as of Hurst exponent 0.8. */
static double *gaussian_rows(size_t rows, uint64_t seed)
{
    double *height = support_room(rows * POINTS * sizeof *height);
    for (size_t r = 0; r < rows; r++)
        for (size_t n = 2; n <= POINTS / 16; n++) {
            double amplitude = 1e-6 * pow((double)n, -1.3), phase = 2 * M_PI * direct_random(seed, 1000 * r + n);
            for (size_t i = 0; i < POINTS; i++)
                height[r * POINTS + i] += amplitude * cos(2 * M_PI * (double)(n * i % POINTS) / POINTS + phase);
        }
    return height;
}

static struct strip solved(const struct strip_rows *rows, size_t surrogates)
{
    struct strip strip;
    expect_ok(strip_solve, &strip, rows, surrogates, &test_alone);
    return strip;
}

/** A wave is its own strip: Westergaard's p = pi D/L sin²(pi A/2) and l = -(L/pi) ln sin(pi A/2). Mirrored, two. */
TEST_CASE(sinusoid)
{
    double height[POINTS], length_m = POINTS * 1e-6, amplitude_m = 1e-6;
    for (int periodic = 0; periodic < 2; periodic++) {
        for (size_t i = 0; i < POINTS; i++)
            height[i] = amplitude_m * cos(2 * M_PI * ((double)i + 0.5) / POINTS);
        struct strip_rows rows = {height, 1, POINTS, 1e-6, periodic, NULL, 0};
        struct strip strip = solved(&rows, 0);
        assert_in_range(strip.own.count, 8, STRIP_LOADS);
        assert_true(strip.transforms > 0);
        for (size_t k = 0; k < strip.own.count; k++) {
            double area = logistic(strip.own.logit[k]), sine = sin(M_PI * area / 2);
            if (area < 0.1 || area > 0.97) /* a wave hardly touches, or hardly gapes: few points */
                continue;
            assert_near(exp(strip.own.value[k][0]), M_PI * amplitude_m / length_m * sine * sine, 0.13);
            assert_near(exp(strip.own.value[k][1]), -length_m / M_PI * log(sine), 0.05);
        }
    }
}

/** Gaussian rows differ from their surrogates by chance alone, of which the surrogates' is the same for all. */
TEST_CASE(gaussian_rows_have_a_ratio_of_one)
{
    enum { SURFACES = 6 };
    double sum[3] = {0};
    for (uint64_t s = 0; s < SURFACES; s++) {
        double *height = gaussian_rows(ROWS, 77 + s);
        struct strip_rows rows = {height, ROWS, POINTS, 1e-6, true, NULL, 0};
        struct strip strip = solved(&rows, STRIP_SURROGATES);
        struct strip_ratio ratio = strip_ratio_at(&strip, 0.2);
        sum[0] += ratio.load / SURFACES;
        sum[1] += ratio.constriction / SURFACES;
        sum[2] += ratio.separation / SURFACES;
    }
    for (int q = 0; q < 3; q++)
        assert_within(sum[q], 0, 0.1);
}

/** Plateaus with pits: at half contact a tenth of the load of a Gaussian surface will do. The same again is the same
 * bits; a row's phases are those of its seed. */
TEST_CASE(heights_tell)
{
    double *height = gaussian_rows(ROWS, 5);
    for (size_t i = 0; i < ROWS * POINTS; i++)
        height[i] = fmin(height[i], 0) + 0.02 * fmax(height[i], 0);
    struct strip_rows rows = {height, ROWS, POINTS, 1e-6, false, NULL, 0},
                      alone = {height + POINTS, 1, POINTS, 1e-6, false, NULL, 0};
    struct strip strip = solved(&rows, STRIP_SURROGATES), again = solved(&rows, STRIP_SURROGATES);
    assert_memory_equal(&strip, &again, sizeof strip);
    double cost = (double)strip_cost(&rows);
    assert_true(cost > 0.5 * (double)strip.transforms && cost < 2 * (double)strip.transforms);
    struct strip_ratio at = strip_ratio_at(&strip, 0.4);
    assert_true(at.load < log(0.5) && at.separation > 0);
    assert_int_equal(strip.surrogates, 2);
    strip.own = strip.surrogate[0]; /* the other one, turned over: valleys for peaks, but as steep */
    strip.surrogate[0] = strip.surrogate[--strip.surrogates];
    at = strip_ratio_at(&strip, 0.1);
    assert_true(fabs(at.load) > 1e-3 && fabs(at.load) < 0.5);
    strip = solved(&alone, 1);
    uint64_t seeds[] = {5};
    alone.seed = seeds;
    again = solved(&alone, 1);
    assert_memory_equal(&strip.own, &again.own, sizeof strip.own);
    assert_memory_not_equal(&strip.surrogate[0], &again.surrogate[0], sizeof strip.own);
}

/** Areas at these loads on a surface of mean-square slope m2. */
static void areas_of(double *area, const double *loads, size_t count, const struct strip *strip, double m2)
{
    struct strip_nodes nodes;
    expect_ok(strip_nodes_make, &nodes, strip, &(struct persson){.m2 = m2}, false);
    for (size_t i = 0; i < count; i++)
        area[i] = strip_area(loads[i], &nodes);
    strip_nodes_free(&nodes);
}

/** Without a ratio the areas are the corrected theory's; with one, p(A) never falls, and below the last solution the
 * ratio stays. */
TEST_CASE(areas)
{
    enum { LOADS = 60 };
    struct strip strip = {.own = {.count = 3, .logit = {-4, -1, 2}, .value = {{-9, 1, 2}, {-6, 0, 1}, {-3, -2, 0}}},
                          .surrogates = 1};
    double loads[LOADS], area[LOADS];
    model_support_loads(loads, LOADS, 1e-9, 2);
    strip.surrogate[0] = strip.own;
    areas_of(area, loads, LOADS, &strip, 0.04);
    for (size_t i = 0; i < LOADS; i++) {
        double expected = corrected_persson_area(loads[i], 0.04);
        if (expected > CORRECTED_PERSSON_LARGEST_AREA)
            assert_true(isnan(area[i]));
        else
            assert_near(area[i], expected, 2e-4);
    }
    strip.own.value[1][0] = -8.9; /* hardly more load for a lot more area */
    strip.surrogate[0].logit[0] = -3.5;
    areas_of(area, loads, LOADS, &strip, 0.04);
    for (size_t i = 1; i < LOADS && !isnan(area[i]); i++)
        assert_true(area[i] >= area[i - 1]);
    double low = exp(strip_ratio_at(&strip, 1e-6).load);
    assert_near(low, exp(strip_ratio_at(&strip, 1e-4).load), 1e-3); /* p as A: logit A, nearly ln A */
    assert_near(area[0], corrected_persson_area(loads[0] / low, 0.04), 1e-2);
    double between = 1 / (1 + exp(3.75)); /* below the surrogate's last: its gap stays */
    assert_near(strip_ratio_at(&strip, between).separation, 2 - 0.25 / 3 - 2, 1e-9);
    assert_near(strip_ratio_at(&strip, 1e-6).separation, strip_ratio_at(&strip, 1e-4).separation, 1e-12);
}

/** Ratios smoothed in logit A: those that are a line stay, of a peak less is left, the wider the less. */
TEST_CASE(smoothed)
{
    enum { LOADS = 40 };
    static const double widths[] = {0, 0.6, 1};
    double loads[LOADS], area[2][3][LOADS], off[3] = {0};
    model_support_loads(loads, LOADS, 1e-4, 0.1);
    for (int peaked = 0; peaked < 2; peaked++)
        for (int w = 0; w < 3; w++) {
            struct strip strip = {
                .own = {.count = 4, .logit = {-9, -3, -2.5, 4}}, .surrogates = 1, .smoothing = widths[w]};
            strip.surrogate[0] = strip.own;
            for (size_t k = 0; k < 4; k++)
                strip.own.value[k][0] = 0.05 * strip.own.logit[k] + (peaked && k == 1 ? 0.3 : 0);
            areas_of(area[peaked][w], loads, LOADS, &strip, 0.04);
        }
    for (size_t i = 0; i < LOADS; i++)
        for (int w = 0; w < 3; w++) {
            assert_near(area[0][w][i], area[0][0][i], 1e-6);
            off[w] = fmax(off[w], fabs(log(area[1][w][i] / area[0][w][i])));
        }
    assert_true(off[0] > 1.05 * off[1] && off[1] > 1.05 * off[2] && off[2] > 0.01);
}

/* Pieces of a longer scan, one far above the other, are loaded by the steepness of their waves: what the step between
 * them has would leave out the light loads. */
TEST_CASE(steps_between_rows_are_no_slope)
{
    double *height = gaussian_rows(2, 9), light[2];
    for (int step = 0; step < 2; step++) {
        for (size_t i = 0; step > 0 && i < POINTS; i++)
            height[i] += 1e-4;
        const struct strip_rows rows = {height, 2, POINTS, 1e-6, true, NULL, 0};
        struct strip strip = solved(&rows, 0);
        light[step] = strip.own.value[0][0];
    }
    assert_true(light[1] < light[0] + 0.1);
}

/** Where three scans are joined lighter loads count, with 8 points in contact instead of 12, and the others are solved
 * as before; not where one of them is solved alone. */
TEST_CASE(several_scans_reach_lighter_loads)
{
    size_t lighter = 0;
    for (uint64_t seed = 1; seed <= 4; seed++) {
        double *height = gaussian_rows(3, seed);
        for (size_t rows = 1; rows <= 3; rows += 2) {
            struct strip of[4];
            for (size_t scans = 0; scans < 4; scans++)
                of[scans] = solved(&(struct strip_rows){height, rows, POINTS, 1e-6, true, NULL, scans}, 0);
            const struct strip_curve *one = &of[1].own, *three = &of[3].own;
            assert_memory_equal(one, &of[0].own, sizeof *one);
            assert_memory_equal(one, &of[2].own, sizeof *one);
            const size_t more = three->count - one->count;
            assert_true(three->count >= one->count && (rows == 3 || more == 0));
            assert_memory_equal(three->logit + more, one->logit, one->count * sizeof *one->logit);
            lighter += more;
        }
    }
    assert_true(lighter > 0);
}

/** A row that does not close on itself is mirrored, not repeated: a ramp then has no cliff, and gives what the mirrored
 * rows give as they are. */
TEST_CASE(rows_are_mirrored)
{
    double *height = gaussian_rows(2, 9), *mirrored = support_room(4 * POINTS * sizeof *mirrored);
    for (size_t r = 0; r < 2; r++)
        for (size_t i = 0; i < POINTS; i++) {
            double at = height[r * POINTS + i] += 5e-9 * (double)i;
            mirrored[2 * r * POINTS + i] = mirrored[2 * (r + 1) * POINTS - 1 - i] = at;
        }
    struct strip strip = solved(&(struct strip_rows){height, 2, POINTS, 1e-6, false, NULL, 0}, 1);
    struct strip expected = solved(&(struct strip_rows){mirrored, 2, 2 * POINTS, 1e-6, true, NULL, 0}, 1);
    assert_memory_equal(&strip, &expected, sizeof strip);
}

/** The gap is that of the points which do not touch: what the solver's tolerance leaves on the others would make it 6 %
 * too large where most touch. Truth: the same strip solved to 1e-9. */
TEST_CASE(gap_of_the_open_points)
{
    double *height = gaussian_rows(1, 9), sum = 0;
    const struct strip_rows rows = {height, 1, POINTS, 1e-6, true, NULL, 0};
    struct strip strip = solved(&rows, 0);
    struct direct_contact contact;
    size_t count = 0;
    expect_ok(direct_contact_make, &contact, height, &(struct direct_grid){POINTS, 1, 1e-6, false, false});
    assert_true(logistic(strip.own.logit[0]) * POINTS >=
                0.3 * (double)strip_least_points(&rows)); /* of fewer it says nothing */
    for (size_t k = 0; k < strip.own.count; k++) {
        struct direct_contact_load load = {exp(strip.own.value[k][0]), INFINITY, 1e-9, true, NULL};
        expect_ok(direct_contact_solve, &contact, &load);
        struct direct_quantities truth = direct_quantities_of(&contact, &load);
        if (truth.area_ratio < 0.4 || truth.area_ratio > 0.97)
            continue;
        sum += strip.own.value[k][2] - log(truth.gap_m);
        count++;
    }
    assert_true(count >= 3);
    assert_within(sum / (double)count, 0, 0.02);
    direct_contact_free(&contact);
}

/** Flat rows have no strip. */
TEST_CASE(nothing_to_solve)
{
    double height[POINTS] = {0};
    struct strip_rows rows = {height, 1, POINTS, 1e-6, false, NULL, 0};
    struct strip strip;
    expect_fails(STATUS_MODEL, "", strip_solve, &strip, &rows, 1, &test_alone);
}

enum { SIDE = 128, TRUTHS = 4, LINES = 5 };

/** Four longest waves, Hurst exponent 0.8, down to 8 points. */
/** rms ln of area, gap and constriction length by the corrected theory (ratio NULL) or the strip, over the truths. */
static void errors(double rms[3], const struct strip *strip, const struct persson *persson, const double *loads,
                   const struct direct_point *truth)
{
    double area[TRUTHS];
    struct corrected_persson_point point[TRUTHS];
    if (strip)
        areas_of(area, loads, TRUTHS, strip, persson->m2);
    for (size_t i = 0; i < TRUTHS; i++)
        point[i].area_ratio = strip ? area[i] : corrected_persson_area(loads[i], persson->m2);
    corrected_persson_curve(point, TRUTHS, persson, true);
    memset(rms, 0, 3 * sizeof *rms);
    for (size_t i = 0; i < TRUTHS; i++) {
        struct strip_ratio ratio = strip ? strip_ratio_at(strip, point[i].area_ratio) : (struct strip_ratio){0};
        rms[0] += pow(log(point[i].area_ratio / truth[i].quantities.area_ratio), 2) / TRUTHS;
        rms[1] += pow(log(point[i].separation_m / truth[i].quantities.gap_m) + ratio.separation, 2) / TRUTHS;
        rms[2] += pow(log(point[i].constriction_m / truth[i].constriction_m) + ratio.constriction, 2) / TRUTHS;
    }
    for (int q = 0; q < 3; q++)
        rms[q] = sqrt(rms[q]);
}

/** What was prepared for a surface serves it, and no other. */
TEST_CASE(prepared_for_a_surface)
{
    enum { LOADS = 5 };
    struct material_pair pair = model_support_tin();
    double *height = gaussian_rows(ROWS, 3), load[LOADS];
    struct strip strip = solved(&(struct strip_rows){height, ROWS, POINTS, 1e-6, true, NULL, 3}, 2);
    struct spectrum spectrum[2] = {model_support_spectrum(height, ROWS, POINTS, 1e-6),
                                   model_support_law(POINTS * 1e-6, 0.05, 1.4, 100)};
    struct prepared_strip prepared = {.strip = NULL};
    model_support_loads(load, LOADS, 1e-7, 1e-3); /* below the nodes too */
    for (int s = 0; s < 2; s++) {
        struct contact_point points[2][LOADS + 1];
        struct model_task task = model_support_task(&spectrum[s], &pair, load, LOADS);
        task.strip = &strip;
        if (s == 0)
            expect_ok(model_strips_prepare, &prepared, &task);
        for (int known = 0; known < 2; known++) {
            task.prepared = known ? &prepared : NULL;
            assert_true(model_support_run(points[known], "strip", &task).exists);
        }
        assert_memory_equal(points[0], points[1], LOADS * sizeof *points[0]);
    }
    strip_nodes_free(&prepared.nodes);
}

/** Two surfaces of one spectrum solved directly, Gaussian and with deep pits, against five of their rows. */
TEST_CASE(against_direct_solutions)
{
    static const double waves[] = {4, SIDE / 8.0, 3.6};
    double *height = support_room(SIDE * SIDE * sizeof *height), row[LINES * SIDE], given[1000];
    for (size_t i = 0; i < 1000; i++)
        given[i] = log(((double)i + 0.5) / 1000);
    for (int pits = 0; pits < 2; pits++) {
        double loads[TRUTHS], rms[3];
        struct direct_point truth[TRUTHS];
        expect_ok(direct_surface_make, height, SIDE,
                  &(struct direct_recipe){band_variance, waves, pits ? given : NULL, 1000}, 1);
        for (size_t k = 0; k < SIDE * SIDE; k++)
            height[k] *= 1e-6;
        for (size_t r = 0; r < LINES; r++)
            memcpy(row + r * SIDE, height + r * SIDE / LINES * SIDE, SIDE * sizeof *row);
        struct spectrum mean = model_support_spectrum(row, LINES, SIDE, 1e-6);
        struct persson persson = model_support_persson(&mean);
        for (size_t i = 0; i < TRUTHS; i++)
            loads[i] = sqrt(2 * persson.m2) * (double[TRUTHS]){0.02, 0.08, 0.25, 0.6}[i];
        struct direct_ladder_def ladder = {loads, TRUTHS, INFINITY, 1e-5, true, NULL, false};
        struct direct_contact contact;
        expect_ok(direct_contact_make, &contact, height, &(struct direct_grid){SIDE, SIDE, 1e-6, false, false});
        expect_ok(direct_ladder_run, truth, &contact, &ladder);
        struct strip_rows rows = {row, LINES, SIDE, 1e-6, true, NULL, 0};
        struct strip strip = solved(&rows, STRIP_SURROGATES);
        errors(rms, NULL, &persson, loads, truth);
        for (int q = 0; q < 3; q++)
            assert_true(pits ? rms[q] > 0.5 : rms[q] < 0.08);
        errors(rms, &strip, &persson, loads, truth);
        for (int q = 0; q < 3; q++)
            assert_true(rms[q] < 0.25);
        direct_contact_free(&contact);
    }
}

/** Roughly, for a scatter: one surrogate and a third of the loads, a third of the work, and much the same ratio. */
TEST_CASE(roughly)
{
    double *height = gaussian_rows(ROWS, 5);
    struct strip_rows rows = {height, ROWS, POINTS, 1e-6, true, NULL, 0};
    struct strip strip = solved(&rows, STRIP_SURROGATES), rough = solved(&rows, STRIP_ROUGHLY);
    assert_int_equal(rough.surrogates, 1);
    assert_int_equal(rough.own.count, (strip.own.count + 1) / 3);
    assert_true(rough.transforms > 0 && 3 * rough.transforms < strip.transforms);
    for (double area = 0.02; area < 0.9; area *= 2)
        assert_true(fabs(strip_ratio_at(&rough, area).load - strip_ratio_at(&strip, area).load) < 0.25);
}
