/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Maps solved directly and interpolated to any load, against solutions at those loads; squares of larger maps; two maps
 * pressed together. */
#include "members/tiles.h"

#include "direct_points.h"

enum { SIDE = 64 };

static const double few_waves[] = {4, 24, 3.6},
                    long_waves[] = {1, 48, 3.4}; /* long: four times as long as a map of 4 SIDE */

/** How the heights of a Gaussian surface are changed. */
static double as_they_are(double z)
{
    return z;
}
static double worn(double z)
{
    return fmin(z, 0.2) + 0.1 * z;
}
static double pitted(double z)
{
    return 0.2 * z - 3 * fmax(-1.2 - z, 0);
}
static double two_levels(double z)
{
    return 1 / (1 + exp(-8 * z)) + 0.05 * z;
}

/** A few high peaks carry the light loads; then all the rest touches within a factor of two. */
static double spiky(double z)
{
    return 0.1 * z + fmax(z - 1, 0);
}

/** A map of nx by ny heights, 1 um apart, cut from a surface of n by n so that it does not close. */
static struct tiles cut(size_t nx, size_t ny, uint64_t seed, double (*look)(double), size_t n, const double band[3])
{
    double *surface = band_surface(n, band, seed);
    struct scan scan = {.kind = SCAN_AREAL, .nx = nx, .ny = ny, .dx_m = 1e-6, .dy_m = 1e-6};
    struct tiles tiles = {.height_m = NULL};
    scan.z_m = malloc(nx * ny * sizeof *scan.z_m);
    assert_non_null(scan.z_m);
    for (size_t k = 0; k < nx * ny; k++)
        scan.z_m[k] = 1e-6 * look(surface[k / nx * n + k % nx]);
    const struct direct_map_def def = {nx, ny, 1e-6, 1e-6, false, 0, false, false};
    tiles_take(&tiles, &scan, &def);
    assert_null(scan.z_m);
    return tiles;
}

static struct tiles map_of(size_t nx, size_t ny, uint64_t seed, double (*look)(double))
{
    enum { WIDE = 512 };
    return cut(nx, ny, seed, look, nx > SIDE || ny > SIDE ? WIDE : 2 * SIDE, few_waves);
}

/** Root mean square of ln(answer/solution) of area, gap and length, at loads between those of the ladder. */
static void compare(double rms[3], const struct tiles *tiles, double hardness)
{
    struct direct_map map;
    struct direct_contact contact;
    size_t count = 0;
    double gradient = sqrt(2 * spectrum_moment(&tiles->transfer->spectrum, 1));
    expect_ok(direct_map_make, &map, tiles->height_m, &tiles->def, SIZE_MAX);
    map.grid.single = false;
    expect_ok(direct_contact_make, &contact, map.height_m, &map.grid);
    rms[0] = rms[1] = rms[2] = 0;
    for (double share = 0.0021; share < 2; share *= 1.9) {
        double load = share * gradient;
        struct direct_ladder_def ladder = {&load, 1, hardness, 1e-4, true, NULL, false};
        struct direct_point truth;
        struct transfer_point own;
        expect_ok(direct_ladder_run, &truth, &contact, &ladder);
        if (!truth.exists || truth.quantities.area_ratio > 0.9)
            break;
        assert_true(transfer_at(&own, tiles->transfer, isfinite(hardness), load));
        rms[0] += pow(log(own.area_ratio / truth.quantities.area_ratio), 2);
        rms[1] += pow(log(own.separation_m / truth.quantities.gap_m), 2);
        rms[2] += pow(log(own.constriction_m / truth.constriction_m), 2);
        count++;
    }
    assert_true(count >= 4);
    for (int q = 0; q < 3; q++)
        rms[q] = sqrt(rms[q] / (double)count);
    direct_contact_free(&contact);
    direct_map_free(&map);
}

/** Root mean square gradient. */
static double gradient_of(const struct tiles *tiles)
{
    double sum = 0;
    for (size_t k = 0; k < (SIDE - 1) * SIDE; k++)
        sum += k % SIDE < SIDE - 1 ? pow(tiles->height_m[k + 1] - tiles->height_m[k], 2) +
                                         pow(tiles->height_m[k + SIDE] - tiles->height_m[k], 2)
                                   : 0;
    return sqrt(sum) / (SIDE - 1) * 1e6;
}

static void expect_monotone(const struct transfer_curve *curve)
{
    for (size_t k = 1; k < curve->count; k++)
        for (int q = 0; q < 3; q++)
            assert_true(q == 0 ? curve->value[k][q] >= curve->value[k - 1][q]
                               : curve->value[k][q] <= curve->value[k - 1][q]);
}

/** Elastic, and with hardnesses from nearly plastic throughout to one that hardly matters. */
TEST_CASE(a_map_is_its_direct_solution)
{
    static double (*const looks[])(double) = {as_they_are, worn, pitted, two_levels, spiky};
    static const double hardness[] = {0.03, 0.3, 3};
    double rms[2][3];
    for (size_t l = 0; l < sizeof looks / sizeof *looks; l++)
        for (size_t h = 0; h < 3; h++) {
            if (l > 0 && h == 1 + l % 2) /* the other looks with two of them */
                continue;
            struct tiles tiles = map_of(SIDE, SIDE, 3 + l, looks[l]);
            double own = hardness[h] * gradient_of(&tiles);
            expect_ok(tiles_solve, &tiles, own, &test_alone);
            assert_non_null(tiles.transfer);
            if (h == 0) /* the hardness does not matter to it */
                compare(rms[0], &tiles, INFINITY);
            compare(rms[1], &tiles, own);
            for (int kind = 0; kind < 2; kind++) {
                const double most =
                    kind == 0 && looks[l] == spiky ? 0.07 : 0.055; /* above a hardness steps are coarse */
                assert_true(rms[kind][0] < most && rms[kind][1] < 0.06 && rms[kind][2] < 0.10);
                expect_monotone(&tiles.transfer->curve[kind]);
                for (int q = 0; q < 3; q++)
                    assert_true(transfer_error(tiles.transfer, kind, q, 0.1 * own) >= 0);
            }
            tiles_free(&tiles);
        }
}

/** ln area, gap and constriction length of a part of a map at one load. */
static void solve_part(double out[3], const struct direct_map *map, enum direct_map_part part, double load)
{
    struct direct_map taken;
    struct direct_contact contact;
    struct direct_ladder_def ladder = {&load, 1, INFINITY, 1e-6, true, NULL, false};
    struct direct_point point;
    expect_ok(direct_map_take, &taken, map, part);
    expect_ok(direct_contact_make, &contact, taken.height_m, &taken.grid);
    expect_ok(direct_ladder_run, &point, &contact, &ladder);
    const double value[] = {point.quantities.area_ratio, point.quantities.gap_m, point.constriction_m};
    for (int q = 0; q < 3; q++)
        out[q] = log(value[q]);
    direct_contact_free(&contact);
    direct_map_free(&taken);
}

/** The error combines the change by taking every second point, the change by a wider low-pass if the map has had one,
 * and the scatter of its quarters. */
TEST_CASE(errors_are_of_all_that_tells_them)
{
    for (int filtered = 0; filtered < 2; filtered++) {
        struct tiles tiles = map_of(SIDE, SIDE, 5, as_they_are);
        struct direct_map map;
        double wider = 0;
        size_t known = 0;
        tiles.def.cutoff = filtered ? 6 : 0;
        expect_ok(tiles_solve, &tiles, INFINITY, &test_alone);
        expect_ok(direct_map_make, &map, tiles.height_m, &tiles.def, SIZE_MAX);
        assert_int_equal(direct_map_has(&map, DIRECT_MAP_WIDER), filtered);
        const struct transfer_errors *error = &tiles.transfer->error[0];
        for (size_t k = 1; k < error->count; k++) {
            double of[DIRECT_MAP_PARTS][3] = {{0}}, load = exp(error->ln_load[k]);
            for (int p = 0; p < DIRECT_MAP_PARTS; p++)
                if (p == DIRECT_MAP_WHOLE || direct_map_has(&map, (enum direct_map_part)p))
                    solve_part(of[p], &map, (enum direct_map_part)p, load);
            for (int q = 0; q < 3; q++) {
                double mean = 0, square = pow(of[DIRECT_MAP_WHOLE][q] - of[DIRECT_MAP_SECOND][q], 2);
                for (int p = 0; p < 4; p++)
                    mean += of[DIRECT_MAP_QUARTER + p][q] / 4;
                for (int p = 0; p < 4; p++)
                    square += pow(of[DIRECT_MAP_QUARTER + p][q] - mean, 2) / 3;
                double more = filtered ? pow(of[DIRECT_MAP_WIDER][q] - of[DIRECT_MAP_SECOND][q], 2) : 0;
                if (isnan(error->value[k][q])) /* too few points touch, or all of a quarter does */
                    continue;
                assert_near(error->value[k][q], sqrt(square + more), 3e-2);
                wider = fmax(wider, more / square);
                known++;
            }
        }
        assert_true(known >= 6);
        assert_int_equal(wider > 0.2, filtered); /* which would be missed */
        direct_map_free(&map);
        tiles_free(&tiles);
    }
}

/** The spectrum of a map with a lay is that of rows and columns alike, with the mean square gradient of the map. */
TEST_CASE(a_map_with_a_lay)
{
    for (int columns = 0; columns < 2; columns++) {
        struct tiles tiles = map_of(SIDE, SIDE, 1, as_they_are);
        double profile_m[SIDE], gradient;
        memcpy(profile_m, tiles.height_m, sizeof profile_m);
        for (size_t k = 0; k < SIDE * SIDE; k++)
            tiles.height_m[k] = 0.1 * tiles.height_m[k] + profile_m[columns ? k / SIDE : k % SIDE];
        gradient = gradient_of(&tiles);
        expect_ok(tiles_solve, &tiles, INFINITY, &test_alone);
        assert_near(sqrt(2 * spectrum_moment(&tiles.transfer->spectrum, 1)), gradient, 0.12);
        tiles_free(&tiles);
    }
}

enum { MAPS = 10, SHARES = 3, ASKED = 3 };
static const double shares[SHARES] = {0.005, 0.03, 0.2};

/** ln answers of ten maps, and their standard errors. */
static void ask(double value[MAPS][SHARES][ASKED], double s[MAPS][SHARES][ASKED], double (*look)(double), size_t n,
                const double band[3])
{
    double gradient = 0;
    for (int m = 0; m < MAPS; m++) {
        struct tiles tiles = cut(SIDE, SIDE, 20 + (uint64_t)m, look, n, band);
        expect_ok(tiles_solve, &tiles, INFINITY, &test_alone);
        gradient = m > 0 ? gradient : gradient_of(&tiles);
        for (int i = 0; i < SHARES; i++) {
            struct transfer_point point;
            assert_true(transfer_at(&point, tiles.transfer, false, shares[i] * gradient));
            const double own[ASKED] = {point.area_ratio, point.separation_m, point.constriction_m};
            for (int q = 0; q < ASKED; q++) {
                value[m][i][q] = log(own[q]);
                s[m][i][q] = transfer_error(tiles.transfer, false, q, shares[i] * gradient);
            }
        }
        tiles_free(&tiles);
    }
}

/** Of ten maps of one surface, the 95 % intervals (four degrees of freedom) contain the mean of all. */
TEST_CASE(errors_hold_the_surface)
{
    static const double t = 2.776;
    double value[MAPS][SHARES][ASKED], s[MAPS][SHARES][ASKED], held = 0;
    ask(value, s, worn, 2 * SIDE, few_waves);
    for (int i = 0; i < SHARES; i++)
        for (int q = 0; q < ASKED; q++) {
            double mean = 0;
            for (int m = 0; m < MAPS; m++)
                mean += value[m][i][q] / MAPS;
            for (int m = 0; m < MAPS; m++)
                held += fabs(value[m][i][q] - mean) <= t * s[m][i][q];
        }
    print_message("holds %g of %d\n", held, MAPS * SHARES * ASKED);
    assert_true(held >= 0.9 * MAPS * SHARES * ASKED);
}

/** Maps shorter than the surface's waves scatter no more than their stated errors. */
TEST_CASE(errors_know_waves_longer_than_the_map)
{
    double value[MAPS][SHARES][ASKED], s[MAPS][SHARES][ASKED];
    ask(value, s, as_they_are, 4 * SIDE, long_waves);
    for (int i = 0; i < SHARES; i++)
        for (int q = 0; q < ASKED; q++) {
            double sum = 0, square = 0, stated = 0;
            for (int m = 0; m < MAPS; m++) {
                sum += value[m][i][q] / MAPS;
                square += pow(value[m][i][q], 2) / MAPS;
                stated += pow(s[m][i][q], 2) / MAPS;
            }
            print_message("%g: stated %.3f, found %.3f\n", shares[i], sqrt(stated),
                          sqrt((square - sum * sum) * MAPS / (MAPS - 1)));
            assert_true(stated >= (square - sum * sum) * MAPS / (MAPS - 1));
        }
}

/** A long map is divided into squares, each levelled; a smaller budget solves fewer of them; their scatter is the
 * error.
 */
TEST_CASE(squares_of_a_larger_map)
{
    enum { LONG = 4 * SIDE + 10 };
    const double longer = 1.6; /* a map's transform than a strip's */
    struct tiles tiles = map_of(LONG, SIDE, 9, worn);
    double rms[3], all = tiles_cost(&tiles, false);
    assert_int_equal(tiles.columns, 4);
    assert_int_equal(tiles.rows, 1);
    assert_true(tiles_fit(&tiles, false, all));
    assert_int_equal(tiles.columns, 4);
    assert_true(tiles_fit(&tiles, false, 0.6 * all));
    assert_int_equal(tiles.columns, 2);
    assert_false(tiles_fit(&tiles, false, 0.2 * all));
    assert_int_equal(tiles.columns, 1);
    tiles.columns = 4;
    expect_ok(tiles_solve, &tiles, INFINITY, &test_alone);
    double likely = all / longer;
    assert_true((double)tiles.transforms[0] > likely / 1.3 && (double)tiles.transforms[0] < 1.3 * likely);
    assert_true(tiles.transfer->curve[0].count > 0 && tiles.transfer->curve[1].count == 0);
    struct tiles one = map_of(SIDE, SIDE, 9, worn); /* a corner of it alone says less of it */
    expect_ok(tiles_solve, &one, INFINITY, &test_alone);
    double load = 0.05 * sqrt(2 * spectrum_moment(&tiles.transfer->spectrum, 1));
    rms[0] = transfer_error(tiles.transfer, false, 0, load);
    rms[1] = transfer_error(one.transfer, false, 0, load);
    assert_true(rms[0] > 0 && rms[0] < rms[1]);
    tiles_free(&one);
    tiles_free(&tiles);
}

/** A map with unequal spacings, or too small, is left as it is; one that cannot be solved says why. */
TEST_CASE(other_maps)
{
    double height[40 * 40] = {0};
    struct scan scan = {.nx = 40, .ny = 40, .dx_m = 1e-6, .dy_m = 1.02e-6, .z_m = height};
    struct tiles tiles = {.height_m = NULL};
    const struct direct_map_def def = {40, 40, 1e-6, 1e-6, false, 0, false, false};
    tiles_take(&tiles, &scan, &def);
    assert_true(scan.z_m && !tiles.height_m && tiles_cost(&tiles, false) == 0 && !tiles_fit(&tiles, false, INFINITY));
    scan.dy_m = 1e-6;
    scan.ny = 20;
    tiles_take(&tiles, &scan, &def);
    assert_true(scan.z_m && !tiles.height_m);
    struct tiles slow = map_of(77, 77, 1, as_they_are); /* 7 and 11 are slow to transform */
    assert_int_equal(slow.side, 75);
    tiles_free(&slow);
    struct tiles flat = map_of(SIDE, SIDE, 1, as_they_are);
    for (size_t k = 0; k < SIDE * SIDE; k++)
        flat.height_m[k] = 0;
    expect_ok(tiles_solve, &flat, INFINITY, &test_alone);
    assert_true(!flat.transfer && flat.problem.code != STATUS_OK);
    tiles_free(&flat);
}

/** Heights of two maps of one spacing add, from some place of the other on; with another spacing there is no direct
 * solution. */
TEST_CASE(two_maps)
{
    struct tiles own = map_of(SIDE, SIDE, 1, as_they_are), other = map_of(40, 48, 2, worn),
                 alone = map_of(SIDE, SIDE, 1, as_they_are);
    own.def.cutoff = 6; /* the wider low-pass is what both are known to */
    other.def.cutoff = 8;
    tiles_pair(&own, &other);
    assert_true(own.def.cutoff == 8);
    size_t found = 0;
    for (size_t down = 0; down < 2 * 48; down++)
        for (size_t right = 0; right < 2 * 40; right++) {
            bool same = true;
            for (size_t k = 0; k < SIDE * SIDE && same; k++) {
                size_t i = (k % SIDE + right) % 80, j = (k / SIDE + down) % 96;
                i = i < 40 ? i : 79 - i;
                j = j < 48 ? j : 95 - j;
                same = fabs(own.height_m[k] - alone.height_m[k] - other.height_m[j * 40 + i]) < 1e-18;
            }
            found += same;
        }
    assert_int_equal(found, 1);
    other.def.cutoff = 6;
    tiles_pair(&own, &other);
    assert_true(own.def.cutoff == 8);
    other.def.dx_m *= 1.02;
    tiles_pair(&own, &other);
    assert_null(own.height_m);
    tiles_free(&other);
    tiles_free(&alone);
}
