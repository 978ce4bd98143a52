/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model_support.h"

struct model_curve model_support_run(struct contact_point *points, const char *model, const struct model_task *task)
{
    const struct model_row *row = model_rows[model_named(model)];
    struct model_curve curve = {.points = points};
    struct model_task counted = *task;
    uint64_t evaluations = 0;
    counted.evaluations = &evaluations;
    expect_ok(model_run, &curve, row, &counted);
    assert_int_equal(evaluations, curve.evaluations);
    assert_true(curve.count <= task->load_count + 1);
    return curve;
}

void model_support_loads(double *load, size_t count, double from, double to)
{
    for (size_t i = 0; i < count; i++)
        load[i] = count > 1 ? from * pow(to / from, (double)i / (double)(count - 1)) : from;
}

struct spectrum model_support_law(double length_m, double alpha, double gamma, size_t count)
{
    struct spectrum spectrum = {malloc(count * sizeof(double)), count, length_m, false};
    assert_non_null(spectrum.amplitude_m);
    for (size_t i = 0; i < count; i++)
        spectrum.amplitude_m[i] = alpha * pow(length_m / (double)(i + 1), gamma);
    return spectrum;
}

struct persson model_support_persson(const struct spectrum *spectrum)
{
    struct persson persson;
    expect_ok(persson_make, &persson, spectrum, 0);
    return persson;
}

struct material_pair model_support_tin(void)
{
    return material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
}
