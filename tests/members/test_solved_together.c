/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is solved on several threads is the same to the byte, whatever their number. */
#include "direct_points.h"
#include "members/scan_strips.h"
#include "members/tiles.h"

enum { SIDE = 64, WIDE = 160 };

/** Heights of rms 1 um of which `nx` of every row are taken, malloc'ed. */
static double *heights(size_t nx, size_t ny)
{
    double *surface = band_surface(WIDE, (const double[]){10, 40, 3.6}, 1), *out = malloc(nx * ny * sizeof *out);
    for (size_t k = 0; k < nx * ny; k++)
        out[k] = 1e-6 * surface[k / nx * WIDE + k % nx];
    return out;
}

/** A map of so many squares, with a low-pass of 6 spacings. */
static struct tiles tiles_of(size_t squares)
{
    struct scan scan = {.kind = SCAN_AREAL, .nx = squares * SIDE, .ny = SIDE, .dx_m = 1e-6, .dy_m = 1e-6};
    const struct direct_map_def def = {scan.nx, scan.ny, 1e-6, 1e-6, false, 6, false, false};
    struct tiles out = {.height_m = NULL};
    scan.z_m = heights(scan.nx, scan.ny);
    tiles_take(&out, &scan, &def);
    return out;
}

/** Squares and parts, elastic and below a hardness; nothing when stopped. */
TEST_CASE(maps)
{
    static const double hardness[] = {INFINITY, 0.1};
    uint64_t alone = 0; /* elastic */
    for (size_t squares = 1; squares <= 2; squares++)
        for (int capped = 0; capped < 2; capped++) {
            struct tiles one = tiles_of(squares), many = tiles_of(squares);
            expect_ok(tiles_solve, &one, hardness[capped], &test_alone);
            expect_ok(tiles_solve, &many, hardness[capped], &((struct threads){2 + (unsigned)squares, NULL}));
            assert_true(one.transfer && many.transfer && one.transforms[0] > 0);
            assert_memory_equal(one.transforms, many.transforms, sizeof one.transforms);
            assert_memory_equal(one.transfer->curve, many.transfer->curve, sizeof one.transfer->curve);
            assert_memory_equal(one.transfer->error, many.transfer->error, sizeof one.transfer->error);
            for (int kind = 0; kind < 2; kind++)
                assert_true((one.transfer->error[kind].count > 0) == (kind <= capped));
            assert_true(capped ? one.capped > 0.05 && one.capped < 0.95 : one.capped == 0); /* half of the work */
            assert_true(capped ? many.capped > 0.05 && many.capped < 0.95 : many.capped == 0);
            alone = capped ? alone : one.transforms[0];
            assert_true(one.transforms[0] <= alone); /* beyond the hardness it has fewer loads */
            tiles_free(&one);
            tiles_free(&many);
        }
    atomic_bool stop = true;
    struct tiles stopped = tiles_of(2);
    expect_fails(STATUS_INTERRUPTED, "", tiles_solve, &stopped, 0.1, &((struct threads){3, &stop}));
    assert_null(stopped.transfer);
    tiles_free(&stopped);
}

/** A strip and its surrogates. */
TEST_CASE(strips)
{
    OWNED(memory_free) double *height_m = heights(2 * SIDE, 4);
    const struct strip_rows rows = {height_m, 4, 2 * SIDE, 1e-6, false, NULL, 0};
    struct strip one, many;
    expect_ok(strip_solve, &one, &rows, STRIP_SURROGATES, &test_alone);
    for (unsigned jobs = 2; jobs < 5; jobs++) {
        expect_ok(strip_solve, &many, &rows, STRIP_SURROGATES, &((struct threads){jobs, NULL}));
        assert_memory_equal(&one, &many, sizeof one);
    }
    assert_true(one.surrogates == STRIP_SURROGATES && one.transforms > 0);
}
