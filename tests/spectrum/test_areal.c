/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Maps: a plane under waves along x, with and without missing points. */
#include "spectrum/areal.h"
#include "support.h"

enum { NX = 400, NY = 30 };
static const double dx_m = 1e-6, amplitude_m = 5e-8;

static double z[NX * NY];

/* Ten waves along x in every row, on a plane high up; `missing` of the points are not there. */
static struct scan make_map(bool with_gaps)
{
    struct scan scan = {.kind = SCAN_AREAL, .nx = NX, .ny = NY, .dx_m = dx_m, .dy_m = 3e-6, .z_m = z};
    for (size_t i = 0; i < NX * NY; i++) {
        double x = (double)(i % NX) * dx_m, y = (double)(i / NX) * 3e-6;
        z[i] = 0.07 + 0.3 * x - 0.1 * y + amplitude_m * cos(2 * M_PI * 10 * ((double)(i % NX) + 0.5) / NX);
        if (with_gaps && (i % 97 == 0 || i % NX < 3)) {
            z[i] = NAN;
            scan.missing++;
        }
    }
    return scan;
}

/* The plane makes rows that do not close on themselves: under a Hann window a line keeps 2/3 of its power. */
static const double windowed = 0.81649658092772603;

static struct areal compute(const struct scan *scan)
{
    struct areal areal;
    expect_ok(areal_compute, &areal, scan);
    return areal;
}

TEST_CASE(test_waves_on_a_plane)
{
    struct scan scan = make_map(false);
    struct areal areal = compute(&scan);
    double k = 2 * M_PI * 10 / NX, slope = sin(k) / dx_m, curvature = (2 - 2 * cos(k)) / dx_m / dx_m;
    assert_near(areal.surface.sq_m, amplitude_m / sqrt(2), 1e-9);
    assert_near(areal.surface.sa_m, amplitude_m * 2 / M_PI, 1e-2);
    assert_near(areal.surface.sz_m, 2 * amplitude_m, 1e-2);
    assert_near(areal.rows.rq_m, amplitude_m / sqrt(2), 1e-9);
    assert_near(areal.rows.m2, amplitude_m * amplitude_m / 2 * slope * slope, 1e-2);
    assert_near(areal.rows.m4_per_m2, amplitude_m * amplitude_m / 2 * curvature * curvature, 1e-2);
    assert_int_equal(areal.scans.scan_count, NY);
    assert_near(areal.spectrum.amplitude_m[9], windowed * amplitude_m, 1e-9);
    assert_within(areal.spectrum.amplitude_m[20], 0, 1e-15);
    areal_free(&areal);
}

/* a cos(kx) cos(qy) of whole periods with the spacings 1 and 3 um, on a plane: Sq = a/2, Sa = a (2/pi)², Ssk 0, Sku
 * (3/2)², Sdq² = a²/4 (k'² + q'²), k' = sin(k dx)/dx as central differences have it; missing points move little. */
TEST_CASE(test_the_surface_over_its_plane)
{
    struct scan scan = make_map(false);
    struct areal_parameters of;
    const double k = 2 * M_PI * 8 / NX, q = 2 * M_PI * 3 / NY;
    for (int gaps = 0; gaps < 2; gaps++) {
        for (size_t i = 0; i < NX * NY; i++) {
            double x = (double)(i % NX), y = (double)(i / NX);
            double wave = amplitude_m * cos(k * (x + 0.5)) * cos(q * (y + 0.5));
            scan.z_m[i] = gaps && i % 97 == 0 ? NAN : 0.07 + 0.3 * x * dx_m - 0.1 * y * 3e-6 + wave;
        }
        expect_ok(areal_parameters_of, &of, &scan);
        const double close = gaps ? 0.02 : 1e-9;
        assert_near(of.sq_m, amplitude_m / 2, close);
        assert_near(of.sa_m, amplitude_m * 4 / M_PI / M_PI, 0.05);
        assert_near(of.sz_m, 2 * amplitude_m * cos(q / 2), 0.03);
        assert_within(of.ssk, 0, close);
        assert_near(of.sku, 2.25, close);
        assert_near(of.sdq, amplitude_m / 2 * hypot(sin(k) / dx_m, sin(q) / 3e-6), 0.03); /* edges are left out */
    }
}

/* A hundredth and three points of every row missing: every figure stays within a few per cent. */
TEST_CASE(test_missing_points_are_left_out)
{
    struct scan scan = make_map(true);
    struct areal areal = compute(&scan);
    double k = 2 * M_PI * 10 / NX, slope = sin(k) / dx_m, curvature = (2 - 2 * cos(k)) / dx_m / dx_m;
    assert_near(areal.surface.sq_m, amplitude_m / sqrt(2), 0.02);
    assert_near(areal.rows.rq_m, amplitude_m / sqrt(2), 0.02);
    assert_near(areal.rows.m2, amplitude_m * amplitude_m / 2 * slope * slope, 0.03);
    assert_near(areal.rows.m4_per_m2, amplitude_m * amplitude_m / 2 * curvature * curvature, 0.03);
    assert_int_equal(areal.scans.scan_count, NY);
    assert_near(areal.spectrum.amplitude_m[9], windowed * amplitude_m, 0.05);
    areal_free(&areal);
}

/* Rows that are all missing or flat have no spectrum, and the others have theirs. */
TEST_CASE(test_rows_that_are_none)
{
    struct scan scan = make_map(false);
    for (size_t i = 0; i < NX; i++) {
        z[i] = NAN;
        z[NX + i] = 0.07;
    }
    struct areal areal = compute(&scan);
    assert_int_equal(areal.scans.scan_count, NY - 2);
    assert_near(areal.spectrum.amplitude_m[9], windowed * amplitude_m, 1e-9);
    assert_near(areal.rows.m0_m2, amplitude_m * amplitude_m / 2 * (NY - 2) / (NY - 1), 1e-6);
    areal_free(&areal);
}

TEST_CASE(test_maps_that_are_none)
{
    struct scan scan = make_map(false);
    struct areal areal;
    for (size_t i = 0; i < NX * NY; i++)
        z[i] = NAN;
    expect_fails(STATUS_SCAN, "", areal_compute, &areal, &scan);
    areal_free(&areal);
    for (size_t i = 0; i < NX * NY; i += 2)
        z[i] = (double)(i % 7);
    expect_fails(STATUS_SCAN, "side by side", areal_compute, &areal, &scan);
    areal_free(&areal);
}
