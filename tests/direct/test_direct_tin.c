/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Two models against direct solutions of surfaces with the power laws of chapter 6's four tin surfaces: the laws as the
 * fit has them, and the laws matched to the surfaces' own mean square height and slope. */
#include "direct_support.h"

#include "contact/model.h"
#include "direct/direct_ensemble.h"
#include "profile/profile.h"
#include "scan/scan.h"
#include "spectrum/spectrum.h"

static const double cut_off_m = 8e-6;

/** The spectrum of a law's rows. */
static struct spectrum rows_of(const struct direct_law *law)
{
    size_t count = direct_law_harmonics(law);
    struct spectrum rows = {malloc(count * sizeof(double)), count, law->length_m, false};
    for (size_t m = 1; m <= count; m++)
        rows.amplitude_m[m - 1] = direct_law_amplitude(law, m);
    return rows;
}

/** Model over direct solution of the same surfaces at P/(A_n E') = load. */
struct ratios {
    double area, gap, ecr;
};

static struct ratios ratios_of(const char *model, const struct direct_law *law,
                               const struct direct_ensemble_point *point, double load)
{
    struct material_pair pair = material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    struct spectrum rows = rows_of(law);
    struct roughness roughness = {0};
    struct asperities asperities;
    struct contact_point points[2];
    struct model_curve curve = {.points = points};
    roughness_from_spectrum(&roughness, &rows);
    expect_ok(roughness_asperities, &asperities, &roughness);
    struct model_task task = {.spectrum = &rows,
                              .asperities = &asperities,
                              .pair = &pair,
                              .sinusoid_fit = SINUSOID_FIT_THESIS,
                              .loads = &load,
                              .load_count = 1,
                              .tolerance = 1e-6,
                              .wanted = QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_SEPARATION) |
                                        QUANTITY_BIT(QUANTITY_ECR)};
    expect_ok(model_run, &curve, model_rows[model_named(model)], &task);
    assert_true(curve.exists && curve.count >= 1);
    spectrum_free(&rows);
    return (struct ratios){points[0].value[QUANTITY_AREA] / point->mean[DIRECT_AREA].value,
                           points[0].value[QUANTITY_SEPARATION] / point->mean[DIRECT_GAP].value,
                           points[0].value[QUANTITY_ECR] /
                               (2 * pair.resistivity_ohm_m * point->mean[DIRECT_CONSTRICTION].value)};
}

/** Ratios with the laws as fitted, measured with another program: A, gap and ECR of both models. Standard errors there
 * are 2 to 4, 1 to 6 and 4 to 12 %, and a gap of the statistical model is a difference of two lengths. */
static const struct {
    const char *surface;
    double alpha, gamma, length_m, load;
    size_t n, seeds;
    struct ratios multiscale, gw;
} known[] = {
    {"1", 0.13, 1.6, 310e-6, 1e-4, 256, 12, {2.11, 0.50, 0.65}, {0.47, 0.92, 0.86}},
    {"1", 0.13, 1.6, 310e-6, 1e-3, 256, 12, {2.12, 0.30, 0.50}, {0.50, 1.10, 0.52}},
    {"3", 0.037, 1.4, 670e-6, 1e-4, 512, 6, {3.11, 0.46, 0.76}, {0.40, 1.02, 0.94}},
    {"3", 0.037, 1.4, 670e-6, 1e-3, 512, 6, {3.26, 0.35, 0.51}, {0.42, 1.31, 0.46}},
    {"4", 0.006, 1.0, 1070e-6, 1e-4, 1024, 4, {7.9, 0.38, 1.05}, {0.55, 1.03, 1.11}},
    {"4", 0.006, 1.0, 1070e-6, 1e-2, 1024, 4, {8.9, 0.11, 0.44}, {0.50, 1.83, 0.59}},
};

static struct direct_ensemble_point solve(const struct direct_law *law, size_t n, size_t seeds, double load)
{
    struct direct_spectrum spectrum;
    struct direct_ensemble ensemble;
    struct direct_ensemble_def def = {.ladder = {&load, 1, INFINITY, 1e-6, true, NULL},
                                      .length_m = law->length_m,
                                      .n = n,
                                      .recipe = {direct_spectrum_variance, &spectrum, NULL, 0},
                                      .seeds = seeds};
    expect_ok(direct_spectrum_of_law, &spectrum, law);
    expect_ok(direct_ensemble_run, &ensemble, &def);
    struct direct_ensemble_point point = ensemble.point[0];
    direct_ensemble_free(&ensemble);
    direct_spectrum_free(&spectrum);
    return point;
}

/** The first surface, and where slow tests are asked for all. */
TEST_CASE(laws_as_fitted)
{
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        struct direct_law law = {known[k].alpha, known[k].gamma, cut_off_m, known[k].length_m, 1};
        if (known[k].n > 256 && !getenv("ROUGHCONTACT_SLOW_TESTS"))
            continue;
        struct direct_ensemble_point point = solve(&law, known[k].n, known[k].seeds, known[k].load);
        struct ratios multiscale = ratios_of("multiscale-elastic", &law, &point, known[k].load),
                      gw = ratios_of("gw", &law, &point, known[k].load);
        assert_near(multiscale.area, known[k].multiscale.area, 0.04);
        assert_within(multiscale.gap, known[k].multiscale.gap, 0.02);
        assert_within(multiscale.ecr, known[k].multiscale.ecr, 0.04);
        assert_within(gw.area, known[k].gw.area, 0.03);
        assert_within(gw.gap, known[k].gw.gap, 0.03);
        assert_within(gw.ecr, known[k].gw.ecr, 0.04);
    }
}

/** Without a roll-off and with the scans' own m0 and m2, the first three laws are flatter than a line through the
 * amplitudes' logarithms says; the multiscale model, which takes each harmonic for a scale, is then further off: its
 * area 3.1 instead of 2.1 times the direct one on the first surface. */
TEST_CASE(laws_matched)
{
    static const double gammas[] = {1.297, 1.189, 1.041, 0.996};
    for (int k = 0; k < 4; k++) {
        struct scan scan;
        struct profile profile;
        struct spectrum spectrum;
        struct direct_law law;
        expect_ok(scan_read, &scan, filled("%s/surfaces/chapter6/surface-%d.csv", PROJECT_SOURCE, k + 1),
                  &(struct scan_options){0});
        expect_ok(profile_make, &profile, &scan, 0, &(struct profile_options){.level = LEVEL_MEAN});
        expect_ok(spectrum_compute, &spectrum, profile.height_m, profile.points, profile.spacing_m,
                  SPECTRUM_WINDOW_NONE);
        const double moments[] = {spectrum_moment(&spectrum, 0), 1e-30, spectrum_moment(&spectrum, 1)};
        expect_ok(direct_law_match, &law, moments, spectrum.length_m, cut_off_m);
        assert_within(law.gamma, gammas[k], 6e-4);
        if (k == 0) {
            struct direct_ensemble_point point = solve(&law, 256, 12, 1e-4);
            assert_within(ratios_of("multiscale-elastic", &law, &point, 1e-4).area, 3.06, 0.1);
            assert_within(ratios_of("gw", &law, &point, 1e-4).area, 0.52, 0.03);
        }
        spectrum_free(&spectrum);
        profile_free(&profile);
        scan_free(&scan);
    }
}
