/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contact models, as a run calls them, on the surface that the golden numbers of each are of. */
#include "contact/model.h"
#include "selftest/selftest.h"

#include <math.h>
#include <string.h>

enum { WAVES_MOST = 256 };

/** A surface, with room for all that a task may point at. */
struct surface {
    struct spectrum spectrum;
    double amplitude_m[WAVES_MOST];
    struct asperities asperities;
    double sigma_m;
};

/** Of `waves` waves of the law 0.085 lambda^1.5; 1: m0 = 4e-13 m², m2 = 2.5e-3. */
static void make_law(struct surface *out, size_t waves)
{
    out->spectrum = (struct spectrum){out->amplitude_m, waves, 3e-4, false};
    for (size_t i = 0; i < waves; i++)
        out->amplitude_m[i] = 0.085 * pow(3e-4 / (double)(i + 1), 1.5);
    if (waves == 1) {
        out->amplitude_m[0] = sqrt(8e-13);
        out->spectrum.length_m = 2 * M_PI * sqrt(4e-13 / 2.5e-3);
    }
    out->sigma_m = sqrt(spectrum_moment(&out->spectrum, 0));
}

/** The waves of the profile `plateau`, without the one of two points. */
static enum status_code make_plateau(struct surface *out, const struct selftest_table *table, struct status *status)
{
    struct spectrum spectrum;
    if (spectrum_compute(&spectrum, table->plateau_m, SELFTEST_PLATEAU, 1e-6, SPECTRUM_WINDOW_NONE, status) !=
        STATUS_OK)
        return status->code;
    out->spectrum = (struct spectrum){out->amplitude_m, SELFTEST_PLATEAU / 2 - 1, spectrum.length_m, false};
    memcpy(out->amplitude_m, spectrum.amplitude_m, out->spectrum.count * sizeof *out->amplitude_m);
    out->sigma_m = sqrt(spectrum_moment(&out->spectrum, 0));
    spectrum_free(&spectrum);
    return STATUS_OK;
}

/** Of asperities the moments m0, m2, m4 alone are known. */
static enum status_code make_asperities(struct surface *out, struct model_task *task, struct status *status)
{
    const struct roughness moments = {.m0_m2 = 1.156e-13, .m2 = 1.2e-3, .m4_per_m2 = 4.5e8};
    if (roughness_asperities(&out->asperities, &moments, status) != STATUS_OK)
        return status->code;
    out->sigma_m = out->asperities.sigma_m;
    task->asperities = &out->asperities;
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

static enum status_code press(double *value, const struct selftest_reference *r, const struct model_row *row,
                              const struct model_task *task, double sigma_m, struct status *status)
{
    struct contact_point points[2];
    struct contact_spots spots = {0};
    struct model_curve curve = {.points = points};
    if (model_run(&curve, row, task, status) != STATUS_OK ||
        (row->spots && row->spots(&spots, row, task, status) != STATUS_OK))
        return status->code;
    if (curve.exists && curve.count > 0)
        *value = number_of(r->quantity, points, &spots, sigma_m);
    return STATUS_OK;
}

/** A model at one load, waves of the law, and a hardness over S_y of tin. */
enum status_code selftest_model(double *value, const struct selftest_reference *r, const struct selftest_table *table,
                                struct status *status)
{
    size_t m = 0, waves = (size_t)fmin(r->at[1], WAVES_MOST);
    while (m < model_count && strcmp(model_rows[m]->name, r->of) != 0)
        m++;
    if (m == model_count)
        return STATUS_OK;
    const struct model_row *row = model_rows[m];
    struct material_pair pair = material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    struct surface surface;
    struct model_task task = {.spectrum = &surface.spectrum,
                              .pair = &pair,
                              .loads = r->at,
                              .load_count = 1,
                              .wanted = QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_SEPARATION) |
                                        QUANTITY_RESISTANCES,
                              .tolerance = 1e-11,
                              .sinusoid_fit = SINUSOID_FIT_THESIS,
                              .hardness_Pa = r->at[2] > 0 ? r->at[2] * pair.yield_strength_Pa : NAN};
    if (waves > 0)
        make_law(&surface, waves);
    else if (make_plateau(&surface, table, status) != STATUS_OK)
        return status->code;
    if (row->asperity_model && make_asperities(&surface, &task, status) != STATUS_OK)
        return status->code;
    return press(value, r, row, &task, surface.sigma_m, status);
}
