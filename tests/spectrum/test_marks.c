/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How often a line is seen where there are marks, and where there are none: some twenty thousand made-up files. */
#include "base/fft.h"
#include "profile/synth.h"
#include "spectrum/multitaper.h"
#include "spectrum/power_law_band.h"
#include "support.h"

#include <gsl/gsl_randist.h>

/* Profiles of Gaussian heights, of an amplitude (wavelength/10)^gamma between sharp ends, low-passed, with white noise;
 * or those of `synth`, whose amplitudes are log-normal. Lengths in points, heights in units of 0.1 um. */
struct kind {
    double gamma, shortest, longest, low_pass, noise;
    bool synth;
    double feed, depth; /* of turning marks: parabolic grooves */
};

enum { LONG = 1024, CUT_FROM = 4 };

static void draw(double height_m[LONG], const struct kind *kind, struct fft_room *room, gsl_rng *random)
{
    struct synth_def def = synth_def_default();
    struct status status = {STATUS_MODEL, ""};
    def.gamma = kind->gamma;
    def.points = LONG;
    def.lambda_s_m = kind->low_pass * def.length_m / LONG;
    while (kind->synth && status.code != STATUS_OK) { /* not every law can be made level */
        status = (struct status){0};
        def.seed = gsl_rng_get(random);
        (void)!synth_profile(height_m, &def, &status);
    }
    const size_t all = CUT_FROM * LONG; /* a part of a longer profile: it does not close */
    memset(room->transform, 0, (all / 2 + 1) * sizeof *room->transform);
    for (size_t n = 1; !kind->synth && n < all / 2; n++) {
        double wavelength = (double)all / (double)n, low_pass = kind->low_pass / wavelength;
        bool inside = wavelength > kind->shortest && (kind->longest <= 0 || wavelength < kind->longest);
        double size = inside ? 1e-7 * pow(wavelength / 10, kind->gamma) * exp(-M_LN2 * low_pass * low_pass) : 0;
        for (int part = 0; part < 2; part++)
            room->transform[n][part] = gsl_ran_gaussian(random, size / sqrt(8 * CUT_FROM));
    }
    if (!kind->synth) {
        assert_true(fft_backward(room->record, room->transform, all));
        memcpy(height_m, room->record, LONG * sizeof *height_m);
    }
    double phase = gsl_rng_uniform(random);
    for (size_t i = 0; i < LONG; i++) {
        double along = kind->feed > 0 ? fmod((double)i / kind->feed + phase, 1) - 0.5 : 0;
        height_m[i] += 1e-7 * (4 * kind->depth * along * along + gsl_ran_gaussian(random, kind->noise));
    }
}

/* How many of how many sets of scans have a line, of one scan, 3, 10, 100 and 1000, all out of the same profiles. */
enum { COUNTS = 5, PROFILES = 1000 };
static const size_t scans_of[COUNTS] = {1, 3, 10, 100, 1000}, sets_of[COUNTS] = {400, 200, 50, 5, 1};

/* Does the mean of so many profiles' spectra have a line; where `feed` is given, at that? */
static bool has_line(const struct kind *kind, double (*of_profile_m2)[LONG], size_t scans)
{
    double amplitude_m[LONG] = {0}, line_m[LOG_BIN_MOST];
    size_t count = multitaper_count(LONG);
    for (size_t m = 0; m < scans; m++)
        for (size_t n = 0; n < count; n++)
            amplitude_m[n] = hypot(amplitude_m[n], sqrt(of_profile_m2[m][n] / (double)scans));
    const struct power_law_band_spectrum spectrum = {amplitude_m, count, LONG, (double)scans, 0};
    struct power_law_band band;
    power_law_band_find(&band, &spectrum);
    size_t lines = power_law_band_lines(line_m, &band);
    bool found = lines > 0 && kind->feed <= 0;
    for (size_t i = 0; i < lines && kind->feed > 0; i++)
        found = found || fabs(log10(line_m[i] / kind->feed)) < 0.1;
    return found;
}

static void count_sets_with_a_line(size_t found[COUNTS], const struct kind *kind, struct fft_room *room,
                                   gsl_rng *random)
{
    static double square_m2[PROFILES][LONG];
    double height_m[LONG];
    for (size_t i = 0; i < PROFILES; i++) {
        draw(height_m, kind, room, random);
        expect_ok(multitaper_square, square_m2[i], height_m, LONG);
    }
    for (int count = 0; count < COUNTS; count++) {
        found[count] = 0;
        for (size_t set = 0; set < sets_of[count]; set++)
            found[count] += has_line(kind, square_m2 + set * scans_of[count], scans_of[count]);
    }
}

/* Without marks at most 2 % of files have a line, whatever their number of scans and however sharply their spectrum
 * ends: of one kind beside another, and all together. */
TEST_CASE(test_no_lines_without_marks)
{
    static const struct kind kinds[] = {
        {.gamma = 1},
        {.gamma = 1, .shortest = 16},
        {.gamma = 1.5, .shortest = 40},
        {.gamma = 1.2, .shortest = 20, .noise = 0.02},
        {.gamma = 1.2, .low_pass = 60, .noise = 0.01},
        {.gamma = 1.4, .shortest = 60},
        {.gamma = 1, .shortest = 100, .noise = 0.1},
        {.gamma = 1.5, .shortest = 10, .longest = 40},
        {.gamma = 2, .shortest = 15, .longest = 60},
        {.gamma = 1.2, .shortest = 10, .longest = 40, .noise = 0.01},
        {.gamma = 1.2, .longest = 100},
        {.gamma = 1.2, .shortest = 8, .longest = 128},
        {.gamma = 1, .synth = true},
        {.gamma = 1.5, .synth = true},
        {.gamma = 1.2, .synth = true, .low_pass = 20},
    };
    enum { KINDS = sizeof kinds / sizeof *kinds };
    gsl_rng *random = support_random();
    struct fft_room room;
    assert_true(fft_room_make(&room, CUT_FROM * LONG));
    size_t all[COUNTS] = {0};
    for (int k = 0; k < KINDS; k++) {
        size_t found[COUNTS];
        count_sets_with_a_line(found, &kinds[k], &room, random);
        for (int count = 0; count < COUNTS; count++) {
            assert_true(found[count] <= (sets_of[count] + 24) / 50); /* 2 %, to the nearest file */
            all[count] += found[count];
        }
    }
    for (int count = 0; count < COUNTS; count++)
        assert_true(50 * all[count] <= KINDS * sets_of[count]);
    fft_room_free(&room);
}

/* A turned surface: grooves of a feed, on roughness alone, filtered, or without long waves. Ten scans always tell, one
 * where the grooves are deep. */
TEST_CASE(test_marks_of_a_turned_surface)
{
    static const struct {
        struct kind kind;
        size_t least[COUNTS];
    } turned[] = {
        {{.gamma = 1, .feed = 50, .depth = 200}, {365, 196, 50, 5, 1}},
        {{.gamma = 1, .feed = 50, .depth = 2000}, {390, 196, 50, 5, 1}},
        {{.gamma = 1.2, .feed = 37, .depth = 200, .low_pass = 12}, {360, 196, 50, 5, 1}},
        {{.gamma = 1.2, .feed = 50, .depth = 200, .longest = 400}, {255, 190, 50, 5, 1}},
        {{.gamma = 1.5, .feed = 100, .depth = 2000, .low_pass = 12}, {110, 160, 50, 5, 1}},
    };
    gsl_rng *random = support_random();
    struct fft_room room;
    assert_true(fft_room_make(&room, CUT_FROM * LONG));
    for (size_t k = 0; k < sizeof turned / sizeof *turned; k++) {
        size_t found[COUNTS];
        count_sets_with_a_line(found, &turned[k].kind, &room, random);
        for (int count = 0; count < COUNTS; count++)
            assert_true(found[count] >= turned[k].least[count]);
    }
    fft_room_free(&room);
}
