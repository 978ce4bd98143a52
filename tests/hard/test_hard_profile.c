/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scans that strain the way from heights to spectra: offsets, tilt, quantised heights. */
#include "hard_support.h"
#include "profile/profile.h"
#include "spectrum/power_law.h"
#include "spectrum/roughness.h"

HARD_CASES("Scans, from heights to spectra")

static const double pi = 3.14159265358979323846;
static const double spacing_m = 1e-6;

/** Roughness of a few nm from harmonics that fit the record. */
static double rough(size_t i, size_t points)
{
    double phase = 2 * pi * (double)i / (double)points, sum = 0;
    static const double harmonics[] = {3, 7, 19, 41};
    for (int k = 0; k < 4; k++)
        sum += 5e-9 / sqrt(harmonics[k]) * cos(harmonics[k] * phase + 1.7 * k);
    return sum;
}

static struct profile profile_of(double *height_m, size_t points, enum level level)
{
    struct scan scan = {.kind = SCAN_PROFILE, .nx = points, .ny = 1, .dx_m = spacing_m, .z_m = height_m};
    struct profile profile;
    expect_ok(profile_make, &profile, &scan, 0, &(struct profile_options){.level = level});
    for (size_t i = 0; i < points; i++)
        assert_true(isfinite(profile.height_m[i]));
    return profile;
}

static void check_same_roughness(const struct profile *profile, const struct profile *plain, double rtol,
                                 double rtol_m4)
{
    struct roughness first = roughness_of_heights(plain->height_m, plain->points, spacing_m);
    struct roughness second = roughness_of_heights(profile->height_m, profile->points, spacing_m);
    assert_near(second.m0_m2, first.m0_m2, rtol);
    assert_near(second.ra_m, first.ra_m, rtol);
    assert_near(second.pv_m, first.pv_m, rtol);
    assert_near(second.m2, first.m2, rtol);
    assert_near(second.m4_per_m2, first.m4_per_m2, rtol_m4);
    assert_near(first.rq_m * first.rq_m, first.m0_m2, 1e-14);
}

static double *heights(size_t points, double offset_m, double tilt)
{
    double *height_m = support_room(points * sizeof *height_m);
    for (size_t i = 0; i < points; i++)
        height_m[i] = offset_m + tilt * spacing_m * (double)i + rough(i, points);
    return height_m;
}

/** A 100 mm offset under 10 nm of roughness: what is left is what doubles at 100 mm hold, 1.4e-17 m. A tilt of 45
 * degrees: the line takes it out and leaves the roughness. */
TEST_CASE(offset_and_tilt)
{
    static const struct {
        size_t points;
        double offset_m, tilt, rtol, rtol_m4, tilt_error;
    } rows[] = {
        {3000, 0.1, 0, 2e-7, 1e-5, 1e-12}, {100003, 0.1, 0, 2e-7, INFINITY, 1e-12}, {3000, 0, 1, 1e-9, 1e-8, 1e-13}};
    for (int level = LEVEL_MEAN; level <= LEVEL_PARABOLA; level++)
        for (int r = 0; r < 3; r++)
            for (int sign = -1; sign <= 1 && (level > LEVEL_MEAN || rows[r].tilt == 0); sign += 2) {
                size_t points = rows[r].points;
                double tilt = sign * rows[r].tilt;
                double *low = heights(points, 0, 0), *high = heights(points, sign * rows[r].offset_m, tilt);
                struct profile plain = profile_of(low, points, (enum level)level);
                struct profile lifted = profile_of(high, points, (enum level)level);
                check_same_roughness(&lifted, &plain, rows[r].rtol, rows[r].rtol_m4);
                double moved = off_by(roughness_of_heights(lifted.height_m, points, spacing_m).m0_m2,
                                      roughness_of_heights(plain.height_m, points, spacing_m).m0_m2);
                if (tilt != 0)
                    hard_case("10 nm of roughness under a tilt of 45°", "squares of 3 mm beside those of 10 nm",
                              "the line is taken out and leaves the roughness", "mean square, relative", moved, 1e-9);
                else
                    hard_case("an offset of 100 mm, 10^7 times the roughness, 3000 and 100 003 points",
                              "the mean of the squares less the square of the mean cancels",
                              "heights are centred before they are squared", "mean square, relative", moved, 2e-7);
                assert_within(lifted.tilt, tilt + plain.tilt, rows[r].tilt_error);
                profile_free(&plain);
                profile_free(&lifted);
            }
}

/** Everything that is made of a levelled profile is finite, or says that it does not exist. */
static void check_description(const struct profile *profile)
{
    struct spectrum spectrum;
    struct status status = {0};
    const double everything_m[2] = {0, INFINITY};
    for (int window = SPECTRUM_WINDOW_NONE; window < SPECTRUM_WINDOW_COUNT; window++) {
        expect_ok(spectrum_compute, &spectrum, profile->height_m, profile->points, spacing_m,
                  (enum spectrum_window)window);
        for (size_t i = 0; i < spectrum.count; i++)
            assert_true(isfinite(spectrum.amplitude_m[i]) && spectrum.amplitude_m[i] >= 0);
        struct power_law law = power_law_fit(&spectrum, everything_m);
        assert_true(law.harmonics < 3 ? isnan(law.gamma) : isfinite(law.gamma) && isfinite(law.alpha) && law.alpha > 0);
        spectrum_free(&spectrum);
    }
    struct roughness roughness = roughness_of_heights(profile->height_m, profile->points, spacing_m);
    assert_true(roughness.m0_m2 > 0 && isfinite(roughness.m4_per_m2) && roughness.ra_m <= roughness.rq_m * (1 + 1e-12));
    struct asperities surface;
    if (roughness_asperities(&surface, &roughness, &status) == STATUS_OK)
        assert_true(surface.sigma_s_m > 0 && surface.sigma_s_m < surface.sigma_m && isfinite(surface.offset_m));
    else
        assert_int_equal(status.code, STATUS_MODEL);
}

/** What the amplitudes of a record do not hold of its mean square. */
static double lost(const struct profile *profile)
{
    struct spectrum spectrum;
    double sum = 0, square = 0;
    expect_ok(spectrum_compute, &spectrum, profile->height_m, profile->points, spacing_m, SPECTRUM_WINDOW_NONE);
    for (size_t i = 0; i < spectrum.count; i++) /* the last of an even record has no partner */
        sum += spectrum.amplitude_m[i] * spectrum.amplitude_m[i] / (2 * (i + 1) == profile->points ? 1 : 2);
    for (size_t i = 0; i < profile->points; i++)
        square += profile->height_m[i] * profile->height_m[i] / (double)profile->points;
    spectrum_free(&spectrum);
    return off_by(sum, square);
}

/* Rq is 3.5 nm. */
TEST_CASE(an_offset_of_a_million_millions)
{
    struct profile plain = profile_of(heights(3000, 0, 0), 3000, LEVEL_MEAN);
    struct profile lifted = profile_of(heights(3000, 5e3, 0), 3000, LEVEL_MEAN);
    double moved = off_by(roughness_of_heights(lifted.height_m, 3000, spacing_m).m0_m2,
                          roughness_of_heights(plain.height_m, 3000, spacing_m).m0_m2);
    profile_free(&plain);
    profile_free(&lifted);
    hard_case("an offset of 5 km, 10^12 times the roughness", "what is left of it is rounding, 1e-12 m",
              "the roughness that doubles still hold at that height", "mean square, relative", moved, 1e-4);
}

/** Shapes that are nothing but one kind of feature. */
TEST_CASE(extreme_shapes)
{
    enum { POINTS = 1000 };
    for (int kind = 0; kind < 4; kind++) {
        double *height_m = support_room(POINTS * sizeof *height_m);
        for (size_t i = 0; i < POINTS; i++) {
            const double of[] = {cos(2 * pi * 7 * (double)i / POINTS), i < POINTS / 2 ? 0 : 1, i % 2 ? 1 : -1,
                                 i == 333 ? 1 : 0};
            height_m[i] = 1e-6 * of[kind];
        }
        struct profile profile = profile_of(height_m, POINTS, LEVEL_MEAN);
        check_description(&profile);
        double left = lost(&profile);
        if (kind == 0) {
            struct spectrum spectrum;
            double others = 0;
            expect_ok(spectrum_compute, &spectrum, profile.height_m, POINTS, spacing_m, SPECTRUM_WINDOW_NONE);
            for (size_t i = 0; i < spectrum.count; i++)
                others = fmax(others, i == 6 ? 0 : spectrum.amplitude_m[i] / spectrum.amplitude_m[6]);
            hard_case("periodic: 7 waves and nothing else", "leakage looks like roughness at every wavelength",
                      "one harmonic, the others rounding", "largest of the others, relative", others, 1e-13);
            spectrum_free(&spectrum);
        } else if (kind == 1) {
            hard_case("steps: half of the points at 0, half at 1 µm", "nothing but a jump: γ = 1 for ever",
                      "a spectrum that holds all of it", "mean square, relative", left, 1e-12);
        } else if (kind == 2) {
            hard_case("two-valued: ± 1 µm in turns", "all of it at the shortest wavelength, which has no phase",
                      "one harmonic, counted once", "mean square, relative", left, 1e-12);
        } else {
            hard_case("one spike of 1 µm in 1000 flat points", "no wavelength leads; no law fits",
                      "every harmonic has its share", "mean square, relative", left, 1e-12);
        }
        profile_free(&profile);
    }
}

TEST_CASE(ten_million_points)
{
    enum { POINTS = 10000000 / HARD_COARSER };
    double *height_m = heights(POINTS, 0.1, 0);
    struct profile profile = profile_of(height_m, POINTS, LEVEL_MEAN);
    hard_case("10^7 points under an offset of 100 mm", "rounding adds up over 10^7 points",
              "sums and transforms keep their digits", "mean square of the amplitudes, relative", lost(&profile), 1e-9);
    profile_free(&profile);
}

/** Heights on a grid of a few levels, down to two; a single spike; the shortest records. */
TEST_CASE(quantised_heights)
{
    static const double steps[] = {1e-12, 1e-9, 4e-9, 1e-8};
    for (int s = 0; s < 4; s++)
        for (int level = 0; level < LEVEL_COUNT; level++) {
            double *height_m = heights(1200, 0, 0);
            for (size_t i = 0; i < 1200; i++)
                height_m[i] = steps[s] * round(height_m[i] / steps[s]);
            height_m[600] += steps[s]; /* never flat */
            struct profile profile = profile_of(height_m, 1200, (enum level)level);
            check_description(&profile);
            if (steps[s] == 1e-9 && level == LEVEL_MEAN) {
                double *whole = heights(1200, 0, 0);
                hard_case("heights of a few levels, 1 nm apart", "digitised heights are taken for roughness",
                          "the mean square changes by no more than step²/12 in four",
                          "mean square, difference in step²/12",
                          fabs(roughness_of_heights(height_m, 1200, spacing_m).m0_m2 -
                               roughness_of_heights(whole, 1200, spacing_m).m0_m2) *
                              12e18,
                          4);
            }
            profile_free(&profile);
        }
    for (size_t points = 3; points < 40; points++)
        for (size_t spike = 0; spike < points; spike += 2) {
            double *height_m = support_room(points * sizeof *height_m);
            height_m[spike] = 1e-9;
            struct profile profile = profile_of(height_m, points, LEVEL_MEAN);
            check_description(&profile);
            hard_case("one spike in 3 to 39 points, at every place", "a spectrum of one or two harmonics",
                      "the amplitudes hold all of the mean square", "their sum, relative", lost(&profile), 1e-12);
            profile_free(&profile);
        }
}
