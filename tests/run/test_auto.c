/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `effects: auto` leaves out an effect only if it would change no number of the report by more than the tolerance, also
 * beyond the scene's loads; and it runs scale dependence only if it changes more than that. */
#include "contact/convergence.h"
#include "members/surface_read.h"
#include "pipeline.h"
#include "run/all_surfaces.h"

/** What all effects change on a scene's surfaces, at a finer tolerance. */
struct truth {
    double plastic;         /* largest relative change by plasticity, up to full contact (separations: over sigma) */
    double scale_dependent; /* largest TCR_sd/TCR - 1 of the models that run */
};

static double difference(double a, double b)
{
    return fabs(a - b) / fabs(a);
}

/** Change of a curve by plasticity. */
static double plastic_change(const struct surface_record *record, const char *elastic, const char *plastic)
{
    const struct model_curve *a = &record->curves[model_named(elastic)], *b = &record->curves[model_named(plastic)];
    double sigma_m = record->summary.roughness.rq_m;
    if (!a->exists)
        return 0;
    double most = difference(a->full_load, b->full_load);
    if (isfinite(a->beta))
        most = fmax(most, fabs(a->beta - b->beta));
    for (size_t i = 0; i < a->count && i < b->count; i++) {
        const struct contact_point *p = &a->points[i], *q = &b->points[i];
        most = fmax(most, difference(p->value[QUANTITY_AREA], q->value[QUANTITY_AREA]));
        most = fmax(most, fabs(p->value[QUANTITY_SEPARATION] - q->value[QUANTITY_SEPARATION]) / sigma_m);
        if (p->value[QUANTITY_TCR] > 0)
            most = fmax(most, difference(p->value[QUANTITY_TCR], q->value[QUANTITY_TCR]));
    }
    return most;
}

static void prepare_scene(struct all_surfaces *prepared, struct scene *scene, const char *text, bool describe_only)
{
    struct run_options options = {.templates = PROJECT_SOURCE "/templates", .jobs = 1};
    directory_write(&directory_here, "scene.yaml", text);
    expect_ok(scene_read, scene, directory_here.path, &(struct scene_overrides){0});
    expect_ok(all_surfaces_run, prepared, scene, &options, describe_only, NULL);
}

static struct truth truth_of(const char *text)
{
    struct scene scene;
    struct all_surfaces prepared;
    struct truth truth = {0, 0};
    prepare_scene(&prepared, &scene, text, false);
    for (size_t s = 0; s < prepared.results.surface_count; s++) {
        const struct surface_record *record = &prepared.results.surfaces[s];
        truth.plastic = fmax(truth.plastic, plastic_change(record, "multiscale-elastic", "multiscale-plastic"));
        truth.plastic = fmax(truth.plastic, plastic_change(record, "gw", "jg"));
        for (size_t m = 0; m < model_count; m++)
            for (size_t i = 0; i < record->curves[m].count; i++) {
                const struct contact_point *point = &record->curves[m].points[i];
                if (point->value[QUANTITY_TCR] > 0)
                    truth.scale_dependent =
                        fmax(truth.scale_dependent,
                             point->value[QUANTITY_TCR_SCALE_DEPENDENT] / point->value[QUANTITY_TCR] - 1);
            }
    }
    all_surfaces_free(&prepared);
    scene_free(&scene);
    return truth;
}

/** What `auto` decides. */
static struct plan plan_of(const char *text)
{
    struct scene scene;
    struct all_surfaces prepared;
    prepare_scene(&prepared, &scene, text, true);
    struct plan plan = prepared.plan;
    all_surfaces_free(&prepared);
    scene_free(&scene);
    return plan;
}

#define ALL "tolerance: 1e-9\neffects: [plasticity, separation, electrical, thermal, scale-dependent]\n"

/** A scene of a made-up material. */
static void describe(char text[800], double E_Pa, double Sy_Pa, double conductivity, const char *loads,
                     const char *family, const char *more)
{
    snprintf(text, 800,
             "material: {E_Pa: %.17g, nu: 0.25, Sy_Pa: %.17g, resistivity_ohm_m: 1e-7, conductivity_W_per_mK: %.17g, "
             "density_kg_per_m3: 5000, specific_heat_J_per_kgK: 300, sound_speed_m_per_s: 3000}\n"
             "load: {%s}\nmodels: [%s]\nsurfaces: [{name: a, file: a.csv}]\n%s",
             E_Pa, Sy_Pa, conductivity, loads, family, more);
}

static void write_surface(const char *name, double gamma, double size, unsigned long seed)
{
    struct synth_def def = synth_def_default();
    def.points = 600;
    def.gamma = gamma;
    def.alpha = size / pow(def.length_m, gamma);
    def.seed = seed;
    pipeline_synth(&directory_here, name, &def);
}

/** Loads far below yield, from soft metals to ones that yield nowhere: plasticity is skipped only where the
 * elastic-plastic models give the same full contact as the elastic ones. */
TEST_CASE(full_contact_is_never_extrapolated_elastically)
{
    static const double yield_Pa[] = {1e9, 1e10, 3e10, 1e11, 1.4e11, 2e11, 5e11, 9e11};
    static const double sizes[] = {3e-8, 3e-7, 3e-6};
    size_t skipped = 0, runs = 0;
    for (size_t k = 0; k < sizeof sizes / sizeof sizes[0]; k++)
        for (size_t y = 0; y < sizeof yield_Pa / sizeof yield_Pa[0]; y++)
            for (int family = 0; family < 2; family++) {
                char text[800];
                const char *name = family ? "statistical" : "multiscale", *loads = "from: 1e-9, to: 1e-7, points: 5";
                write_surface("a.csv", k == 1 ? 1.0 : 1.5, sizes[k], 3 + k);
                describe(text, 2e11, yield_Pa[y], 30, loads, name, "");
                struct plan plan = plan_of(text);
                describe(text, 2e11, yield_Pa[y], 30, loads, name, ALL);
                double change = truth_of(text).plastic;
                if (!plan_runs(&plan, EFFECT_PLASTICITY) && !(change <= 1e-6))
                    fail_msg("Sy %g size %g %s: skipped, but it changes a number by %g; %s", yield_Pa[y], sizes[k],
                             name, change, plan.reasons[EFFECT_PLASTICITY]);
                skipped += !plan_runs(&plan, EFFECT_PLASTICITY);
                runs += plan_runs(&plan, EFFECT_PLASTICITY);
            }
    assert_true(skipped >= 5 && runs >= 5);
}

/** The law extrapolated below the sampling limit counts too: with gamma < 1 its slopes go on rising. */
TEST_CASE(law_below_the_sampling_limit_counts)
{
    char text[800];
    const char *loads = "from: 1e-9, to: 1e-7, points: 5";
    write_surface("a.csv", 0.6, 5e-8, 11);
    describe(text, 2e11, 2e10, 30, loads, "multiscale", ALL);
    assert_within(truth_of(text).plastic, 0, 0); /* nothing measured yields */
    describe(text, 2e11, 2e10, 30, loads, "multiscale", "convergence: {load: 1e-2}\n");
    struct plan plan = plan_of(text);
    assert_true(plan_runs(&plan, EFFECT_PLASTICITY));

    struct scene scene;
    struct all_surfaces prepared;
    prepare_scene(&prepared, &scene, text, true);
    struct surface_record record = {0};
    double area[2];
    expect_ok(surface_read, &record, &scene, &scene.surfaces[0], NULL);
    for (int plastic = 0; plastic < 2; plastic++)
        area[plastic] = convergence_extend(&record.spectrum, &record.summary.tail, &record.summary.pair, plastic, 1e-2)
                            .area_extended;
    surface_record_free(&record);
    assert_true(area[1] > 1.01 * area[0]);
    all_surfaces_free(&prepared);
    scene_free(&scene);
}

/** Mean free paths for which the change, at the first and last load, is below, at and above the tolerance. */
TEST_CASE(scale_dependence_runs_just_where_it_matters)
{
    static const char *const families[] = {"multiscale", "statistical"};
    static const double tolerances[] = {1e-5, 1e-3, 0.05}, share[] = {0.5, 0.97, 1.03, 1.5};
    size_t skipped = 0, runs = 0;
    write_surface("a.csv", 1.5, 3e-7, 31);
    for (size_t t = 0; t < 3; t++)
        for (int family = 0; family < 2; family++) {
            const char *loads = "from: 1e-6, to: 1e-2, points: 41";
            double conductivity = 1e3 * tolerances[t];
            char text[800], own_tolerance[40];
            snprintf(own_tolerance, sizeof own_tolerance, "tolerance: %g\n", tolerances[t]);
            describe(text, 2e10, 1e12, conductivity, loads, families[family], ALL);
            double unit = truth_of(text).scale_dependent; /* nearly proportional to the mean free path */
            for (size_t c = 0; c < 4; c++) {
                double scaled = conductivity * share[c] * tolerances[t] / unit;
                describe(text, 2e10, 1e12, scaled, loads, families[family], ALL);
                double change = truth_of(text).scale_dependent;
                describe(text, 2e10, 1e12, scaled, loads, families[family], own_tolerance);
                struct plan plan = plan_of(text);
                bool run = plan_runs(&plan, EFFECT_SCALE_DEPENDENT);
                if (run != (change > tolerances[t]))
                    fail_msg("it raises TCR by %g: %s", change, plan.reasons[EFFECT_SCALE_DEPENDENT]);
                skipped += !run;
                runs += run;
            }
        }
    assert_true(skipped >= 8 && runs >= 8);
}

TEST_GROUP(directory_setup, directory_teardown)
