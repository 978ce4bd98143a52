/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elbow and limits of curves, solved to the tolerance whatever the list of loads. */
#include "analysis/landmarks.h"
#include "support.h"

enum {
    HARMONICS = 60,
    LOADS_MOST = 200,
    QUANTITIES = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_SEPARATION) |
                 QUANTITY_BIT(QUANTITY_ECR)
};

static const struct ensemble alone; /* one scan */

/* A tin surface that yields, and its task without loads. */
struct fixture {
    double amplitudes_m[HARMONICS];
    struct spectrum spectrum;
    struct asperities asperities;
    struct material_pair pair;
    struct model_task task;
};

static void make(struct fixture *f)
{
    f->spectrum = (struct spectrum){.amplitude_m = f->amplitudes_m, .count = HARMONICS, .length_m = 3e-4};
    for (int n = 1; n <= HARMONICS; n++)
        f->amplitudes_m[n - 1] = 3e-7 * pow(n, -1.4) * (1 + 0.5 * sin(7.0 * n));
    f->asperities = (struct asperities){.density_per_m2 = 1e10, .radius_m = 8e-6, .sigma_s_m = 2e-7, .sigma_m = 2.1e-7};
    f->pair = material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    f->task = (struct model_task){.spectrum = &f->spectrum,
                                  .asperities = &f->asperities,
                                  .pair = &f->pair,
                                  .wanted = quantity_wanted((1u << EFFECT_COUNT) - 1),
                                  .tolerance = 1e-8,
                                  .hardness_Pa = NAN};
}

/* Summary of a model over `count` loads from `from` to 30, its landmarks solved. */
static struct curve_summary summarise(const struct fixture *f, const char *name, double from, size_t count)
{
    static struct contact_point points[LOADS_MOST + 1];
    double loads[LOADS_MOST];
    struct model_task task = f->task;
    struct model_curve curve = {.points = points};
    struct curve_summary summary = {.exists = true};
    struct status status = {0};
    const struct model_row *row = model_rows[model_named(name)];
    for (size_t i = 0; i < count; i++)
        loads[i] = from * pow(30 / from, (double)i / (double)(count - 1));
    task.loads = loads;
    task.load_count = count;
    assert_int_equal(model_run(&curve, row, &task, &status), STATUS_OK);
    assert_true(curve.exists);
    curve_summary_make(&summary, &curve, row, f->asperities.sigma_m, NAN);
    struct landmarks_model model = {row, task, QUANTITIES, &alone};
    const struct landmarks_curve searched = {landmarks_run_model, &model, task.tolerance};
    assert_int_equal(landmarks_solve(&summary, &curve, row, &searched, &status), STATUS_OK);
    return summary;
}

/* The model at one load; beyond full contact the point is closed. */
static struct contact_point at(const struct fixture *f, const char *name, double load)
{
    static struct contact_point points[2];
    struct landmarks_model model = {model_rows[model_named(name)], f->task, QUANTITIES, &alone};
    struct model_curve curve = {.points = points};
    struct status status = {0};
    assert_int_equal(landmarks_run_model(&curve, &load, 1, &model, &status), STATUS_OK);
    return points[0];
}

static double slope(const struct fixture *f, const char *name, double load)
{
    double half = exp(landmarks_slope_step / 2);
    double before = at(f, name, load / half).value[QUANTITY_ECR], after = at(f, name, load * half).value[QUANTITY_ECR];
    return after > 0 ? log(before / after) / landmarks_slope_step : INFINITY;
}

static const char *const names[] = {"multiscale-elastic", "multiscale-plastic", "gw", "jg", "corrected-persson"};
enum { NAMES = sizeof names / sizeof *names };

/* Just below the load it is not so yet, just above it is. */
TEST_CASE(landmarks_are_where_it_changes)
{
    struct fixture f;
    size_t areas = 0, fits = 0, elbows = 0;
    make(&f);
    for (int n = 0; n < NAMES; n++) {
        const struct model_row *row = model_rows[model_named(names[n])];
        struct curve_summary s = summarise(&f, names[n], 1e-9, 80);
        double less = 1 - 3e-8, more = 1 + 1e-8;
        if (isnan(s.full_load)) { /* it ends at the largest area that it is good for */
            assert_true(isnan(s.invalid_area_load));
        } else if (row->largest_area > 0) {
            assert_true(at(&f, names[n], s.invalid_area_load * less).value[QUANTITY_AREA] <= row->largest_area);
            assert_true(at(&f, names[n], s.invalid_area_load * more).value[QUANTITY_AREA] > row->largest_area);
            areas++;
        }
        if (row->fitted_to && isfinite(s.invalid_fit_load) && s.invalid_fit_load > 1e-9) {
            assert_true(at(&f, names[n], s.invalid_fit_load * less).beyond_fit <= 0.1);
            assert_true(at(&f, names[n], s.invalid_fit_load * more).beyond_fit > 0.1);
            fits++;
        }
        assert_true(slope(&f, names[n], s.elbow_load * less) <= 2);
        assert_true(slope(&f, names[n], s.elbow_load * more) > 2);
        assert_false(s.elbow_load >= s.full_load);
        elbows++;
    }
    assert_true(areas == 2 && fits == 1 && elbows == NAMES);
}

/* The same from 9 loads as from 150. */
TEST_CASE(the_list_of_loads_does_not_matter)
{
    struct fixture f;
    make(&f);
    for (int n = 0; n < NAMES; n++) {
        struct curve_summary few = summarise(&f, names[n], 1e-8, 9), many = summarise(&f, names[n], 1e-8, 150);
        if (isfinite(many.invalid_area_load))
            assert_near(few.invalid_area_load, many.invalid_area_load, 3e-8);
        if (isfinite(many.invalid_fit_load) && many.invalid_fit_load > 1e-8)
            assert_near(few.invalid_fit_load, many.invalid_fit_load, 3e-8);
        assert_near(few.elbow_load, many.elbow_load, 3e-8);
    }
}

/* What holds at the first load is that load; what never does stays unknown. */
TEST_CASE(the_first_load_and_none)
{
    struct fixture f;
    make(&f);
    struct curve_summary before = summarise(&f, "gw", 1e-9, 80);
    double from = before.invalid_area_load * 1.01;
    assert_near(summarise(&f, "gw", from, 20).invalid_area_load, from, 0);
    from = before.elbow_load * 1.01;
    assert_near(summarise(&f, "gw", from, 20).elbow_load, from, 1e-12);
    from = before.elbow_load * 0.97; /* between the first two loads */
    assert_near(summarise(&f, "gw", from, 20).elbow_load, before.elbow_load, 3e-8);
    assert_true(isnan(summarise(&f, "multiscale-elastic", 29, 5).elbow_load));
}

/* Against the mean at many loads: nearly the tolerance for the smooth curves, near it for the steps of the plastic one.
 */
TEST_CASE(the_nearest_beta)
{
    static const struct {
        const char *statistical, *multiscale;
        double tolerance;
    } pairs[] = {{"gw", "multiscale-elastic", 1e-5}, {"jg", "multiscale-plastic", 3e-3}};
    enum { MANY = 4000 };
    struct fixture f;
    struct status status = {0};
    make(&f);
    for (int p = 0; p < 2; p++) {
        struct landmarks_model own = {model_rows[model_named(pairs[p].statistical)], f.task, QUANTITIES, &alone},
                               other = {model_rows[model_named(pairs[p].multiscale)], f.task, QUANTITIES, &alone};
        const struct landmarks_curve a = {landmarks_run_model, &own, 1e-8}, b = {landmarks_run_model, &other, 1e-8};
        double from = 1e-7, to = summarise(&f, pairs[p].statistical, 1e-9, 20).full_load, beta, sum = 0;
        double *loads = malloc(MANY * sizeof *loads);
        struct contact_point *low = malloc((MANY + 1) * sizeof *low), *high = malloc((MANY + 1) * sizeof *high);
        struct model_curve low_curve = {.points = low}, high_curve = {.points = high};
        assert_true(loads && low && high);
        for (int i = 0; i < MANY; i++)
            loads[i] = from * pow(to / from, (i + 0.5) / MANY);
        assert_int_equal(landmarks_run_model(&low_curve, loads, MANY, &own, &status), STATUS_OK);
        assert_int_equal(landmarks_run_model(&high_curve, loads, MANY, &other, &status), STATUS_OK);
        for (int i = 0; i < MANY; i++)
            sum += 4 * (high[i].value[QUANTITY_SEPARATION] - low[i].value[QUANTITY_SEPARATION] / 2) /
                   f.asperities.sigma_m / MANY;
        assert_int_equal(landmarks_nearest_beta(&beta, &a, &b, from, to, f.asperities.sigma_m, &status), STATUS_OK);
        assert_within(beta, sum, pairs[p].tolerance * fmax(1, fabs(sum)));
        assert_int_equal(landmarks_nearest_beta(&beta, &a, &b, to, from, f.asperities.sigma_m, &status), STATUS_OK);
        assert_true(isnan(beta)); /* full from the first load on */
        free(loads);
        free(low);
        free(high);
    }
}
