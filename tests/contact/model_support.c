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

struct model_task model_support_task(const struct spectrum *spectrum, const struct material_pair *pair,
                                     const double *loads, size_t count)
{
    return (struct model_task){.spectrum = spectrum,
                               .pair = pair,
                               .loads = loads,
                               .load_count = count,
                               .wanted = MODEL_EVERYTHING,
                               .tolerance = 1e-8,
                               .hardness_Pa = material_hardness_ratio * pair->yield_strength_Pa};
}

void model_support_spots(struct contact_spots *spots, const char *model, const struct model_task *task)
{
    const struct model_row *row = model_rows[model_named(model)];
    expect_ok(row->spots, spots, row, task);
}

void model_support_matches(const struct contact_point *point, const struct table *table, size_t row, double rtol)
{
    static const enum quantity compared[] = {QUANTITY_LOAD, QUANTITY_AREA, QUANTITY_ECR, QUANTITY_TCR,
                                             QUANTITY_TCR_SCALE_DEPENDENT};
    for (size_t q = 0; q < sizeof compared / sizeof *compared; q++)
        assert_near(point->value[compared[q]], table_number(table, row, quantity_rows[compared[q]].name), rtol);
}

void model_support_loads(double *load, size_t count, double from, double to)
{
    for (size_t i = 0; i < count; i++)
        load[i] = count > 1 ? from * pow(to / from, (double)i / (double)(count - 1)) : from;
}

struct spectrum model_support_law(double length_m, double alpha, double gamma, size_t count)
{
    struct spectrum spectrum = {support_room(count * sizeof(double)), count, length_m, false};
    for (size_t i = 0; i < count; i++)
        spectrum.amplitude_m[i] = alpha * pow(length_m / (double)(i + 1), gamma);
    return spectrum;
}

struct spectrum model_support_spectrum(const double *height_m, size_t rows, size_t points, double spacing_m)
{
    struct spectrum mean;
    for (size_t r = 0; r < rows; r++)
        expect_ok(spectrum_add_record, &mean, r, height_m + r * points, points, spacing_m);
    test_owns(mean.amplitude_m, free);
    return mean;
}

struct persson model_support_persson(const struct spectrum *spectrum)
{
    struct persson persson;
    expect_ok(persson_make, &persson, spectrum, 0);
    if (persson.node)
        test_owns(persson.node, free);
    return persson;
}

struct multiscale model_support_stack(const struct spectrum *spectrum, const struct material_pair *pair, bool plastic,
                                      enum sinusoid_fit_id closure)
{
    struct multiscale stack;
    expect_ok(multiscale_make, &stack, spectrum, pair, plastic, closure);
    test_owns(stack.scales, free);
    test_owns(stack.block_closed_Pa, free);
    return stack;
}

struct statistical model_support_statistical(const struct asperities *surface, const struct material_pair *pair,
                                             bool plastic, double tolerance, double lowest_d)
{
    struct statistical model;
    const struct model_task task = {
        .asperities = surface, .pair = pair, .wanted = MODEL_EVERYTHING, .tolerance = tolerance};
    expect_ok(statistical_make, &model, &task, plastic, lowest_d);
    if (model.panels.node)
        test_owns(model.panels.node, free);
    return model;
}

static void end_bearing(void *bearing)
{
    bearing_free(bearing);
    free(bearing);
}

const struct bearing *model_support_bearing(const struct strip_rows *rows)
{
    struct bearing *bearing = test_owns(calloc(1, sizeof *bearing), end_bearing);
    expect_ok(bearing_make, bearing, rows);
    return bearing;
}

struct asperities model_support_asperities(double m0_m2, double m2, double m4_per_m2)
{
    const struct roughness roughness = {.m0_m2 = m0_m2, .m2 = m2, .m4_per_m2 = m4_per_m2};
    struct asperities surface;
    expect_ok(roughness_asperities, &surface, &roughness);
    return surface;
}

struct material_pair model_support_tin(void)
{
    return material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
}
