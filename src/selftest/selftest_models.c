/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every contact model of the table, as a run calls it. */
#include "contact/model.h"
#include "selftest/selftest.h"
#include "selftest/selftest_profile.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* at: P/(A_n E') */
static const struct selftest_reference references[] = {
    {"multiscale-elastic", "area_ratio", {9.9999999999999995e-07}, 0.00032558454278657699, 1e-10},
    {"multiscale-elastic", "ecr_ohm_m2", {9.9999999999999995e-07}, 5.7056512595961599e-09, 1e-10},
    {"multiscale-elastic", "tcr_K_m2_per_W", {9.9999999999999995e-07}, 0.00074272992184277011, 1e-10},
    {"multiscale-elastic", "tcr_sd_K_m2_per_W", {9.9999999999999995e-07}, 0.00074401239493287368, 1e-10},
    {"multiscale-elastic", "separation_over_sigma", {9.9999999999999995e-07}, 1.4807425299138366, 1e-10},
    {"multiscale-plastic", "area_ratio", {9.9999999999999995e-07}, 0.00098682607240482595, 1e-10},
    {"multiscale-plastic", "ecr_ohm_m2", {9.9999999999999995e-07}, 1.5999935189820791e-09, 1e-10},
    {"multiscale-plastic", "tcr_K_m2_per_W", {9.9999999999999995e-07}, 0.00020827825032310323, 1e-10},
    {"multiscale-plastic", "tcr_sd_K_m2_per_W", {9.9999999999999995e-07}, 0.00020872309045558902, 1e-10},
    {"multiscale-plastic", "separation_over_sigma", {9.9999999999999995e-07}, 1.357131967822601, 1e-10},
    {"multiscale-elastic", "area_ratio", {0.0001}, 0.029130904103463477, 1e-10},
    {"multiscale-elastic", "ecr_ohm_m2", {0.0001}, 9.4284937225153351e-11, 1e-10},
    {"multiscale-elastic", "tcr_K_m2_per_W", {0.0001}, 1.2273488313610173e-05, 1e-10},
    {"multiscale-elastic", "tcr_sd_K_m2_per_W", {0.0001}, 1.2287954265822765e-05, 1e-10},
    {"multiscale-elastic", "separation_over_sigma", {0.0001}, 1.1188199101398113, 1e-10},
    {"multiscale-plastic", "area_ratio", {0.0001}, 0.095284982111300237, 1e-10},
    {"multiscale-plastic", "ecr_ohm_m2", {0.0001}, 3.3281523032835491e-11, 1e-10},
    {"multiscale-plastic", "tcr_K_m2_per_W", {0.0001}, 4.3324034148445055e-06, 1e-10},
    {"multiscale-plastic", "tcr_sd_K_m2_per_W", {0.0001}, 4.3360041699935449e-06, 1e-10},
    {"multiscale-plastic", "separation_over_sigma", {0.0001}, 0.71721142195619858, 1e-10},
    {"multiscale-elastic", "area_ratio", {0.00029999999999999997}, 0.0827496059103838, 1e-10},
    {"multiscale-elastic", "ecr_ohm_m2", {0.00029999999999999997}, 3.9721695604663615e-11, 1e-10},
    {"multiscale-elastic", "tcr_K_m2_per_W", {0.00029999999999999997}, 5.1707492325779248e-06, 1e-10},
    {"multiscale-elastic", "tcr_sd_K_m2_per_W", {0.00029999999999999997}, 5.1753190397399997e-06, 1e-10},
    {"multiscale-elastic", "separation_over_sigma", {0.00029999999999999997}, 0.81498753868920959, 1e-10},
    {"multiscale-plastic", "area_ratio", {0.00029999999999999997}, 0.27997335895026892, 1e-10},
    {"multiscale-plastic", "ecr_ohm_m2", {0.00029999999999999997}, 1.0179134785572668e-11, 1e-10},
    {"multiscale-plastic", "tcr_K_m2_per_W", {0.00029999999999999997}, 1.3250631066874079e-06, 1e-10},
    {"multiscale-plastic", "tcr_sd_K_m2_per_W", {0.00029999999999999997}, 1.325782925054088e-06, 1e-10},
    {"multiscale-plastic", "separation_over_sigma", {0.00029999999999999997}, 0.309672051425675, 1e-10},
    {"gw", "area_ratio", {0.0032555639334493325}, 0.075085863397601454, 1e-10},
    {"gw", "separation_over_sigma", {0.0032555639334493325}, 0.86922912977931732, 1e-10},
    {"gw", "ecr_ohm_m2", {0.0032555639334493325}, 4.2368911191120662e-12, 1e-10},
    {"gw", "tcr_K_m2_per_W", {0.0032555639334493325}, 5.5153490225358844e-07, 1e-10},
    {"gw", "tcr_sd_K_m2_per_W", {0.0032555639334493325}, 5.6022178024424742e-07, 1e-10},
    {"gw", "area_ratio", {0.00011087688382496633}, 0.0032231690238341722, 1e-10},
    {"gw", "separation_over_sigma", {0.00011087688382496633}, 2.3504930862520439, 1e-10},
    {"gw", "ecr_ohm_m2", {0.00011087688382496633}, 1.1329132938769641e-10, 1e-10},
    {"gw", "tcr_K_m2_per_W", {0.00011087688382496633}, 1.474763465083265e-05, 1e-10},
    {"gw", "tcr_sd_K_m2_per_W", {0.00011087688382496633}, 1.5055924847028727e-05, 1e-10},
    {"gw", "area_ratio", {7.4035293183140334e-08}, 2.7124228330610433e-06, 1e-10},
    {"gw", "separation_over_sigma", {7.4035293183140334e-08}, 4.325511694882346, 1e-10},
    {"gw", "ecr_ohm_m2", {7.4035293183140334e-08}, 1.1484011214470251e-07, 1e-10},
    {"gw", "tcr_K_m2_per_W", {7.4035293183140334e-08}, 0.014949246569214073, 1e-10},
    {"gw", "tcr_sd_K_m2_per_W", {7.4035293183140334e-08}, 0.015352979213332823, 1e-10},
    {"jg", "area_ratio", {0.00015621671528098449}, 0.2682755427527021, 1e-10},
    {"jg", "separation_over_sigma", {0.00015621671528098449}, 0.86922912977931732, 1e-10},
    {"jg", "ecr_ohm_m2", {0.00015621671528098449}, 1.2378488035995551e-12, 1e-10},
    {"jg", "tcr_K_m2_per_W", {0.00015621671528098449}, 1.6113626706581034e-07, 1e-10},
    {"jg", "tcr_sd_K_m2_per_W", {0.00015621671528098449}, 1.6250862611479381e-07, 1e-10},
    {"jg", "area_ratio", {6.8522791518797232e-06}, 0.010766104574635957, 1e-10},
    {"jg", "separation_over_sigma", {6.8522791518797232e-06}, 2.3504930862520439, 1e-10},
    {"jg", "ecr_ohm_m2", {6.8522791518797232e-06}, 5.8831388428672076e-11, 1e-10},
    {"jg", "tcr_K_m2_per_W", {6.8522791518797232e-06}, 7.6583426749117518e-06, 1e-10},
    {"jg", "tcr_sd_K_m2_per_W", {6.8522791518797232e-06}, 7.7482594922089275e-06, 1e-10},
    {"jg", "area_ratio", {5.8105561101167e-09}, 8.4777922417955533e-06, 1e-10},
    {"jg", "separation_over_sigma", {5.8105561101167e-09}, 4.325511694882346, 1e-10},
    {"jg", "ecr_ohm_m2", {5.8105561101167e-09}, 6.6570790440090037e-08, 1e-10},
    {"jg", "tcr_K_m2_per_W", {5.8105561101167e-09}, 0.0086658149492436914, 1e-10},
    {"jg", "tcr_sd_K_m2_per_W", {5.8105561101167e-09}, 0.0088020089551026012, 1e-10},
    {"two-band-elastic", "area_ratio", {9.9999999999999995e-07}, 0.00014370081157352041, 1e-10},
    {"two-band-elastic", "separation_m", {9.9999999999999995e-07}, 1.3208884182366824e-06, 1e-10},
    {"two-band-elastic", "ecr_ohm_m2", {9.9999999999999995e-07}, 7.3236439156198432e-09, 1e-10},
    {"two-band-elastic", "tcr_K_m2_per_W", {9.9999999999999995e-07}, 0.00095335119963809464, 1e-10},
    {"two-band-elastic", "area_ratio", {0.0001}, 0.0097991015865426523, 1e-10},
    {"two-band-elastic", "separation_m", {0.0001}, 8.5794005744511964e-07, 1e-10},
    {"two-band-elastic", "ecr_ohm_m2", {0.0001}, 1.7882712156779138e-10, 1e-10},
    {"two-band-elastic", "tcr_K_m2_per_W", {0.0001}, 2.3278719287658338e-05, 1e-10},
    {"two-band-elastic", "area_ratio", {0.00029999999999999997}, 0.027163051759270935, 1e-10},
    {"two-band-elastic", "separation_m", {0.00029999999999999997}, 6.6454060040421476e-07, 1e-10},
    {"two-band-elastic", "ecr_ohm_m2", {0.00029999999999999997}, 7.5708120894094978e-11, 1e-10},
    {"two-band-elastic", "tcr_K_m2_per_W", {0.00029999999999999997}, 9.8552617670001264e-06, 1e-10},
    {"two-band-plastic", "area_ratio", {9.9999999999999995e-07}, 0.0011953904030802462, 1e-10},
    {"two-band-plastic", "separation_m", {9.9999999999999995e-07}, 6.7345450175902655e-07, 1e-10},
    {"two-band-plastic", "ecr_ohm_m2", {9.9999999999999995e-07}, 9.8230637864510431e-10, 1e-10},
    {"two-band-plastic", "tcr_K_m2_per_W", {9.9999999999999995e-07}, 0.00012787117660050825, 1e-10},
    {"two-band-plastic", "area_ratio", {0.0001}, 0.11953904030802462, 1e-10},
    {"two-band-plastic", "separation_m", {0.0001}, 3.7255108581652701e-07, 1e-10},
    {"two-band-plastic", "ecr_ohm_m2", {0.0001}, 3.125398900343977e-11, 1e-10},
    {"two-band-plastic", "tcr_K_m2_per_W", {0.0001}, 4.0684703206768776e-06, 1e-10},
    {"two-band-plastic", "area_ratio", {0.00029999999999999997}, 0.35861712092407383, 1e-10},
    {"two-band-plastic", "ecr_ohm_m2", {0.00029999999999999997}, 9.1727470984381732e-12, 1e-10},
    {"two-band-plastic", "tcr_K_m2_per_W", {0.00029999999999999997}, 1.1940571593905458e-06, 1e-10},
    {"persson", "area_ratio", {5.6234132519034912e-06}, 0.00066368333192702545, 1e-10},
    {"persson", "separation_over_sigma", {5.6234132519034912e-06}, 3.0463480066881132, 1e-10},
    {"persson", "area_ratio", {0.0005623413251903491}, 0.063877559042490914, 1e-10},
    {"persson", "separation_over_sigma", {0.0005623413251903491}, 1.138689112113241, 1e-10},
    {"persson", "area_ratio", {0.0031622776601683794}, 0.30977087957790927, 1e-10},
    {"persson", "separation_over_sigma", {0.0031622776601683794}, 0.34956805209757003, 1e-10},
    {"contacting-slopes", "area_ratio", {0.0001}, 0.0066886490010461958, 1e-10},
    {"contacting-slopes", "separation_m", {0.0001}, 1.1699955949748899e-06, 1e-10},
    {"contacting-slopes", "ecr_ohm_m2", {0.0001}, 1.6207807787382801e-10, 1e-10},
    {"contacting-slopes", "area_ratio", {0.00029999999999999997}, 0.020065947003138584, 1e-10},
    {"contacting-slopes", "separation_m", {0.00029999999999999997}, 1.0132865686426899e-06, 1e-10},
    {"contacting-slopes", "ecr_ohm_m2", {0.00029999999999999997}, 5.5095935087610481e-11, 1e-10},
    {"contacting-slopes", "area_ratio", {0.001}, 0.066501081128166467, 1e-10},
    {"contacting-slopes", "separation_m", {0.001}, 8.0224561279628095e-07, 1e-10},
    {"contacting-slopes", "ecr_ohm_m2", {0.001}, 1.7881010359383709e-11, 1e-10},
    {"contacting-slopes", "area_ratio", {0.0030000000000000001}, 0.20754171637148711, 1e-10},
    {"contacting-slopes", "area_ratio", {0.01}, 0.42416244600415692, 1e-10},
    {"cmy", "area_ratio", {9.9999999999999995e-08}, 0.00012124674088385355, 1e-10},
    {"cmy", "separation_over_sigma", {9.9999999999999995e-08}, 3.6700600643210266, 1e-10},
    {"cmy", "ecr_ohm_m2", {9.9999999999999995e-08}, 7.5605773737073313e-09, 1e-10},
    {"cmy", "tcr_K_m2_per_W", {9.9999999999999995e-08}, 0.00098419387837898084, 1e-10},
    {"cmy", "spot_density_per_m2", {9.9999999999999995e-08}, 1449705.114925883, 1e-10},
    {"cmy", "spot_radius_m", {9.9999999999999995e-08}, 5.1596502633840774e-06, 1e-10},
    {"cmy", "area_ratio", {1.0000000000000001e-05}, 0.012124674088385355, 1e-10},
    {"cmy", "separation_over_sigma", {1.0000000000000001e-05}, 2.2531554670882743, 1e-10},
    {"cmy", "ecr_ohm_m2", {1.0000000000000001e-05}, 9.7125692401306312e-11, 1e-10},
    {"cmy", "tcr_K_m2_per_W", {1.0000000000000001e-05}, 1.2643282010063306e-05, 1e-10},
    {"cmy", "spot_density_per_m2", {1.0000000000000001e-05}, 63996045.83352229, 1e-10},
    {"cmy", "spot_radius_m", {1.0000000000000001e-05}, 7.7657522299862094e-06, 1e-10},
    {"cmy", "area_ratio", {0.0001}, 0.12124674088385354, 1e-10},
    {"cmy", "separation_over_sigma", {0.0001}, 1.1687770187823361, 1e-10},
    {"cmy", "ecr_ohm_m2", {0.0001}, 9.5221707750040067e-12, 1e-10},
    {"cmy", "tcr_K_m2_per_W", {0.0001}, 1.2395431886232762e-06, 1e-10},
    {"cmy", "spot_density_per_m2", {0.0001}, 261623394.43208069, 1e-10},
    {"cmy", "spot_radius_m", {0.0001}, 1.2145679377088223e-05, 1e-10},
    {"sridhar-yovanovich", "area_ratio", {9.9999999999999995e-08}, 0.00012305472284730078, 1e-10},
    {"sridhar-yovanovich", "separation_over_sigma", {9.9999999999999995e-08}, 3.6595635399114346, 1e-10},
    {"sridhar-yovanovich", "ecr_ohm_m2", {9.9999999999999995e-08}, 7.3703161159875796e-09, 1e-10},
    {"sridhar-yovanovich", "tcr_K_m2_per_W", {9.9999999999999995e-08}, 0.00095942672689242124, 1e-10},
    {"sridhar-yovanovich", "spot_density_per_m2", {9.9999999999999995e-08}, 1502731.5121138096, 1e-10},
    {"sridhar-yovanovich", "spot_radius_m", {9.9999999999999995e-08}, 5.1054439204634849e-06, 1e-10},
    {"sridhar-yovanovich", "area_ratio", {1.0000000000000001e-05}, 0.012305472284730079, 1e-10},
    {"sridhar-yovanovich", "separation_over_sigma", {1.0000000000000001e-05}, 2.2373339877615361, 1e-10},
    {"sridhar-yovanovich", "ecr_ohm_m2", {1.0000000000000001e-05}, 9.4841623571907937e-11, 1e-10},
    {"sridhar-yovanovich", "tcr_K_m2_per_W", {1.0000000000000001e-05}, 1.2345954643570416e-05, 1e-10},
    {"sridhar-yovanovich", "spot_density_per_m2", {1.0000000000000001e-05}, 65947317.529316843, 1e-10},
    {"sridhar-yovanovich", "spot_radius_m", {1.0000000000000001e-05}, 7.7068275198509243e-06, 1e-10},
    {"sridhar-yovanovich", "area_ratio", {0.0001}, 0.12305472284730079, 1e-10},
    {"sridhar-yovanovich", "separation_over_sigma", {0.0001}, 1.1439480207876018, 1e-10},
    {"sridhar-yovanovich", "ecr_ohm_m2", {0.0001}, 9.3189696341681004e-12, 1e-10},
    {"sridhar-yovanovich", "tcr_K_m2_per_W", {0.0001}, 1.2130915951793935e-06, 1e-10},
    {"sridhar-yovanovich", "spot_density_per_m2", {0.0001}, 265952417.06397572, 1e-10},
    {"sridhar-yovanovich", "spot_radius_m", {0.0001}, 1.2135906899694607e-05, 1e-10},
};
enum { REFERENCES = sizeof references / sizeof references[0], WAVES_MOST = 256 };

/** The surface that a family's numbers are of. */
enum surface_kind {
    SURFACE_LAW,       /* alpha lambda^gamma of 256 waves */
    SURFACE_SHORT,     /* the same of 64 */
    SURFACE_MOMENTS,   /* m0, m2, m4 alone: asperities */
    SURFACE_TRUNCATED, /* sigma and mean slope alone: one wave that has them */
    SURFACE_PLATEAU,   /* a profile whose heights are not Gaussian */
};

static const struct {
    const char *model;
    enum surface_kind surface;
    double hardness_over_Sy; /* of tin; NaN: not called for */
} surfaces[] = {
    {"multiscale-elastic", SURFACE_LAW, NAN},
    {"multiscale-plastic", SURFACE_LAW, NAN},
    {"gw", SURFACE_MOMENTS, NAN},
    {"jg", SURFACE_MOMENTS, NAN},
    {"two-band-elastic", SURFACE_LAW, NAN},
    {"two-band-plastic", SURFACE_LAW, 2.84},
    {"persson", SURFACE_SHORT, NAN},
    {"contacting-slopes", SURFACE_PLATEAU, NAN},
    {"cmy", SURFACE_TRUNCATED, 2.8},
    {"sridhar-yovanovich", SURFACE_TRUNCATED, NAN},
};
enum { SURFACES = sizeof surfaces / sizeof surfaces[0] };

/** A surface, with room for all that a task may point at. */
struct surface {
    struct spectrum spectrum;
    double amplitude_m[WAVES_MOST];
    struct asperities asperities;
    struct slope_point points[SELFTEST_PROFILE_POINTS];
    double sigma_m;
};

/** Heights -> spectrum and slopes. The reference has no Nyquist wave. */
static enum status_code make_plateau(struct surface *out, struct model_task *task, struct status *status)
{
    double height_m[SELFTEST_PROFILE_POINTS];
    struct spectrum computed;
    for (size_t i = 0; i < SELFTEST_PROFILE_POINTS; i++)
        height_m[i] = selftest_profile_height[i] / 1e17;
    if (spectrum_compute(&computed, height_m, SELFTEST_PROFILE_POINTS, selftest_profile_spacing_m, SPECTRUM_WINDOW_NONE,
                         status) != STATUS_OK)
        return status->code;
    out->spectrum.length_m = computed.length_m;
    out->spectrum.count = computed.count - computed.has_nyquist;
    memcpy(out->amplitude_m, computed.amplitude_m, out->spectrum.count * sizeof *out->amplitude_m);
    spectrum_free(&computed);
    task->points = out->points;
    task->point_count =
        contacting_slopes_of_profile(out->points, height_m, SELFTEST_PROFILE_POINTS, selftest_profile_spacing_m);
    return STATUS_OK;
}

static enum status_code make_surface(struct surface *out, struct model_task *task, enum surface_kind kind,
                                     struct status *status)
{
    const struct roughness moments = {.m0_m2 = 1.156e-13, .m2 = 1.2e-3, .m4_per_m2 = 4.5e8};
    out->spectrum = (struct spectrum){out->amplitude_m, kind == SURFACE_SHORT ? 64 : WAVES_MOST, 3e-4, false};
    for (size_t i = 0; i < out->spectrum.count; i++)
        out->amplitude_m[i] = 0.085 * pow(3e-4 / (double)(i + 1), 1.5);
    if (kind == SURFACE_PLATEAU && make_plateau(out, task, status) != STATUS_OK)
        return status->code;
    if (kind == SURFACE_TRUNCATED) { /* m0 = 4e-13 m², m2 = 2.5e-3 */
        out->spectrum.count = 1;
        out->amplitude_m[0] = sqrt(8e-13);
        out->spectrum.length_m = 2 * M_PI * sqrt(4e-13 / 2.5e-3);
    }
    out->sigma_m = sqrt(spectrum_moment(&out->spectrum, 0));
    if (kind == SURFACE_MOMENTS) {
        if (roughness_asperities(&out->asperities, &moments, status) != STATUS_OK)
            return status->code;
        out->sigma_m = out->asperities.sigma_m;
        task->asperities = &out->asperities;
    }
    task->spectrum = &out->spectrum;
    return STATUS_OK;
}

static double number_of(const char *name, const struct contact_point *point, const struct contact_spots *spots,
                        double sigma_m)
{
    if (strcmp(name, "spot_density_per_m2") == 0)
        return spots->density_per_m2;
    if (strcmp(name, "spot_radius_m") == 0)
        return spots->radius_m;
    if (strcmp(name, "separation_over_sigma") == 0)
        return point->value[QUANTITY_SEPARATION] / sigma_m;
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if (strcmp(quantity_rows[q].name, name) == 0)
            return point->value[q];
    return NAN;
}

/** One model at one load. */
static enum status_code press(struct contact_point *point, struct contact_spots *spots, const struct model_row *row,
                              const struct model_task *task, struct status *status)
{
    struct contact_point points[2] = {quantity_nothing()};
    struct model_curve curve = {.points = points};
    if (model_run(&curve, row, task, status) != STATUS_OK)
        return status->code;
    *point = curve.exists && curve.count > 0 ? points[0] : quantity_nothing();
    return row->spots ? row->spots(spots, row, task, status) : STATUS_OK;
}

static enum status_code compute_model(double *values, const struct selftest_reference *all, size_t count, size_t which,
                                      struct surface *surface, struct status *status)
{
    const char *name = surfaces[which].model;
    struct material_pair pair = material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    struct model_task task = {.pair = &pair,
                              .load_count = 1,
                              .wanted = QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_SEPARATION) |
                                        QUANTITY_RESISTANCES,
                              .tolerance = 1e-11,
                              .sinusoid_fit = SINUSOID_FIT_THESIS,
                              .hardness_Pa = surfaces[which].hardness_over_Sy * pair.yield_strength_Pa};
    if (make_surface(surface, &task, surfaces[which].surface, status) != STATUS_OK)
        return status->code;
    size_t m = 0;
    while (m < model_count && strcmp(model_rows[m]->name, name) != 0)
        m++;
    for (size_t i = 0; i < count; i++) {
        struct contact_point point;
        struct contact_spots spots = {0};
        if (strcmp(all[i].what, name) != 0)
            continue;
        values[i] = NAN;
        task.loads = all[i].at;
        if (m < model_count && press(&point, &spots, model_rows[m], &task, status) != STATUS_OK)
            return status->code;
        if (m < model_count)
            values[i] = number_of(all[i].of, &point, &spots, surface->sigma_m);
    }
    return STATUS_OK;
}

static enum status_code compute(double *values, const struct selftest_reference *all, size_t count,
                                struct status *status)
{
    struct surface *surface = calloc(1, sizeof *surface);
    if (!surface)
        return status_memory(status);
    enum status_code rc = STATUS_OK;
    for (size_t i = 0; i < count; i++)
        values[i] = NAN; /* of a model without a surface */
    for (size_t which = 0; which < SURFACES && rc == STATUS_OK; which++)
        rc = compute_model(values, all, count, which, surface, status);
    free(surface);
    return rc;
}

bool selftest_covers_model(size_t model)
{
    size_t i = 0;
    while (i < REFERENCES && strcmp(references[i].what, model_rows[model]->name) != 0)
        i++;
    return i < REFERENCES;
}

const struct selftest_group selftest_models = {
    .name = "models",
    .source = "the equations evaluated in 30 to 40 digits (contacting-slopes: by another program)",
    .references = references,
    .count = REFERENCES,
    .compute = compute,
};
