/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Two rough bodies: profiles paired at random places. */
#include "members/scan_strips.h"
#include "profile/synth.h"
#include "support.h"

enum { POINTS = 256, THEIRS = 100 };

static double own_m[2 * POINTS], their_m[2 * THEIRS];
static struct member own_members[2], their_members[2];
static struct ensemble own_set = {.members = own_members}, their_set = {.members = their_members, .count = 2};

/** Strips of `rows` copied from heights. */
static struct strips strips_of(const double *height_m, size_t rows, size_t points, double spacing_m, bool periodic)
{
    struct strips strips = {.height_m = malloc(rows * points * sizeof(double))};
    strips.seed = calloc(rows, sizeof *strips.seed);
    assert_true(strips.height_m && strips.seed);
    memcpy(strips.height_m, height_m, rows * points * sizeof(double));
    for (size_t r = 0; r < rows; r++)
        strips.seed[r] = (uint64_t)r << 32;
    strips.rows = (struct strip_rows){strips.height_m, rows, points, spacing_m, periodic, strips.seed, 0};
    return strips;
}

static struct strips pair(size_t rows, const double *theirs_m, size_t points, double spacing_m, bool periodic)
{
    struct strips strips = strips_of(own_m, rows, POINTS, 1e-6, true),
                  other = strips_of(theirs_m, 2, points, spacing_m, periodic);
    own_set.count = rows;
    for (size_t r = 0; r < 2; r++)
        own_members[r] = their_members[r] = (struct member){.scan = r, .first_piece = r, .pieces = 1};
    expect_ok(strips_pair, &strips, &own_set, &other, &their_set);
    strips_free(&other);
    return strips;
}

static void make_heights(void)
{
    for (size_t i = 0; i < 2 * POINTS; i++)
        own_m[i] = 1e-6 * sin(0.37 * (double)(i * i));
    for (size_t i = 0; i < 2 * THEIRS; i++)
        their_m[i] = 1e-6 * cos(0.11 * (double)(i * i));
}

/** Is row r of the pairs its own row plus a stretch of a row of the other body, mirrored at its ends or carried around?
 * Where it begins, or SIZE_MAX. */
static size_t beginning(const struct strips *strips, size_t r, bool periodic)
{
    const double *own = own_m + r / own_members[0].pieces * POINTS, *paired = strips->rows.height_m + r * POINTS;
    size_t period = periodic ? THEIRS : 2 * THEIRS;
    for (size_t begin = 0; begin < 2 * period; begin++) {
        bool same = true;
        for (size_t i = 0; i < POINTS && same; i++) {
            size_t at = (begin % period + i) % period;
            at = at < THEIRS ? at : 2 * THEIRS - 1 - at;
            same = fabs(paired[i] - own[i] - their_m[begin / period * THEIRS + at]) < 1e-18;
        }
        if (same)
            return begin;
    }
    return SIZE_MAX;
}

TEST_CASE(pairs_are_profiles_at_random_places)
{
    make_heights();
    for (int k = 0; k < 4; k++) {
        size_t rows = k < 2 ? 1 : 2, first = 0, unlike = 0;
        struct strips strips = pair(rows, their_m, THEIRS, 1e-6, k % 2 == 0),
                      again = pair(rows, their_m, THEIRS, 1e-6, k % 2 == 0);
        assert_int_equal(strips.rows.rows, STRIPS_PAIRINGS);
        for (size_t p = 0; p < rows; p++) {
            assert_int_equal(own_members[p].pieces, STRIPS_PAIRINGS / rows);
            assert_int_equal(own_members[p].first_piece, p * STRIPS_PAIRINGS / rows);
        }
        assert_false(strips.rows.periodic); /* their lengths differ */
        assert_memory_equal(strips.height_m, again.height_m, STRIPS_PAIRINGS * POINTS * sizeof(double));
        for (size_t r = 0; r < strips.rows.rows; r++) {
            size_t begin = beginning(&strips, r, k % 2 == 0);
            assert_true(begin != SIZE_MAX);
            size_t period = k % 2 == 0 ? THEIRS : 2 * THEIRS; /* scan i of one with scan i of the other */
            assert_int_equal(begin / period, r / own_members[0].pieces);
            first = r == 0 ? begin : first;
            unlike += begin != first;
        }
        assert_true(unlike >= 5);
        strips_free(&strips);
        strips_free(&again);
    }
    struct strips same = pair(1, own_m, POINTS, 1e-6, true), many = pair(2, their_m, THEIRS, 1e-6, true);
    assert_true(same.rows.periodic);
    struct strips none = {.rows = {.rows = 0}};
    expect_ok(strips_pair, &many, &own_set, &none, &their_set);
    assert_int_equal(many.rows.rows, 0);
    strips_free(&same);
}

/** A slope of 3 points 2.5 um apart is one of points 1 um apart. */
TEST_CASE(the_other_body_may_have_another_spacing)
{
    double ramp_m[2 * THEIRS];
    make_heights();
    for (size_t i = 0; i < 2 * THEIRS; i++)
        ramp_m[i] = 1e-6 * (double)(i % THEIRS);
    struct strips strips = pair(1, ramp_m, THEIRS, 2.5e-6, false);
    for (size_t r = 0; r < strips.rows.rows; r++) {
        const double *z = strips.rows.height_m + r * POINTS;
        size_t straight = 0;
        for (size_t i = 1; i < POINTS; i++) {
            double step = z[i] - z[i - 1] - (own_m[i] - own_m[i - 1]);
            assert_true(fabs(step) < 0.4e-6 * (1 + 1e-9));
            straight += fabs(fabs(step) - 0.4e-6) < 1e-15;
        }
        assert_true(straight >= POINTS - 10); /* but where it turns */
    }
    strips_free(&strips);
}

/** A flat other body changes nothing: eight times the same strip. Two Gaussian bodies make a Gaussian one: no load,
 * length or gap is far from those of the surrogates. */
TEST_CASE(pairs_solve_as_what_they_are)
{
    double flat_m[2 * POINTS] = {0}, noise_m[2 * POINTS];
    struct synth_def def = synth_def_default();
    def.points = POINTS;
    def.length_m = POINTS * 1e-6;
    for (size_t r = 0; r < 2; r++) {
        def.seed = r + 1;
        expect_ok(synth_profile, own_m + r * POINTS, &def);
        def.seed = r + 11;
        expect_ok(synth_profile, noise_m + r * POINTS, &def);
    }
    struct strips one = strips_of(own_m, 1, POINTS, 1e-6, true), eight = pair(1, flat_m, POINTS, 1e-6, true),
                  rough = pair(2, noise_m, POINTS, 1e-6, true);
    expect_ok(strips_solve, &one, &test_alone);
    expect_ok(strips_solve, &eight, &test_alone);
    expect_ok(strips_solve, &rough, &test_alone);
    expect_ok(strips_solve_members, &rough, &own_set, &test_alone);
    const struct strip_curve *flat = &eight.joined->strip.own, *alike = &one.joined->strip.own;
    for (size_t back = 1; back <= 8; back++)
        for (int q = 0; q < 3; q++)
            assert_within(flat->value[flat->count - back][q], alike->value[alike->count - back][q], 0.05);
    for (double area = 0.05; area < 0.5; area *= 2) {
        struct strip_ratio ratio = strip_ratio_at(&rough.joined->strip, area);
        assert_within(ratio.load, 0, 0.3);
        assert_within(ratio.constriction, 0, 0.4);
        assert_within(ratio.separation, 0, 0.4);
    }
    for (size_t p = 0; p < 2; p++) { /* a scan alone: its own pairs */
        struct strip_rows rows = rough.rows;
        struct strip alone;
        rows.height_m += 4 * p * POINTS;
        rows.seed += 4 * p;
        rows.rows = 4;
        expect_ok(strip_solve, &alone, &rows, STRIP_SURROGATES, &test_alone);
        assert_non_null(own_members[p].strip);
        assert_memory_equal(&own_members[p].strip->strip, &alone, sizeof alone);
        solved_strip_free(own_members[p].strip);
    }
    strips_free(&one);
    strips_free(&eight);
    strips_free(&rough);
}
