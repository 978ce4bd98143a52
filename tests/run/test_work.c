/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Only what the scene calls for is computed: an effect that is off costs nothing, one that is on only its own
 * evaluations, and `auto` leaves out what cannot change a number. */
#include "pipeline.h"
#include "results/results.h"

#include <jansson.h>

static size_t described;

enum status_code __real_surface_read(struct surface_record *out, const struct scene *scene,
                                     const struct scene_surface *surface, const struct surface_record *counterface,
                                     struct status *status);
enum status_code __wrap_surface_read(struct surface_record *out, const struct scene *scene,
                                     const struct scene_surface *surface, const struct surface_record *counterface,
                                     struct status *status)
{
    described++;
    return __real_surface_read(out, scene, surface, counterface, status);
}

/** What a run did, by effect. */
struct work {
    json_int_t area, plasticity, convergence, uncertainty, all;
};

static json_int_t evaluations(const json_t *work, const char *effect)
{
    return json_integer_value(json_object_get(json_object_get(work, effect), "evaluations"));
}

static struct work work_of(const char *scene)
{
    directory_write(&directory_here, "in/scene.yaml", scene);
    assert_int_equal(pipeline_run(&directory_here, "in", "out", 2), 0);
    json_t *results = directory_json(&directory_here, "out/results.json");
    const json_t *work = json_object_get(results, "work"), *row;
    const char *name;
    assert_int_equal(json_object_size(work), WORK_ROWS);
    struct work out = {evaluations(work, "area"), evaluations(work, "plasticity"), evaluations(work, "convergence"),
                       evaluations(work, "uncertainty"), 0};
    json_object_foreach ((json_t *)work, name, row)
        out.all += evaluations(work, name);
    return out;
}

#define FILES                                                                                                          \
    "surfaces: [{name: a, file: a.csv}, {name: b, file: b.csv}]\nmaterial: tin\nfit: thesis\n"                         \
    "fit_band: [8 um, 2 mm]\nload: {from: 1e-6, to: 0.1, points: 31}\noperating_load: 1e-3\n"
#define ALL "plasticity, separation, electrical, thermal, scale-dependent, convergence, uncertainty"

TEST_CASE(each_effect_removes_its_own_work)
{
    struct work all = work_of(FILES "effects: [" ALL "]\n"), less;
    assert_true(all.area > 0 && all.plasticity > 0 && all.convergence > 0 && all.uncertainty > 0);
    assert_int_equal(all.area + all.plasticity + all.convergence + all.uncertainty, all.all);

    less = work_of(FILES "effects: [separation, electrical, thermal, scale-dependent, convergence, uncertainty]\n");
    assert_int_equal(less.plasticity, 0);
    assert_int_equal(less.area, all.area);
    assert_int_equal(less.convergence * 2, all.convergence); /* of the elastic stack alone */
    assert_true(less.uncertainty < all.uncertainty);

    less = work_of(FILES "effects: [plasticity, separation, electrical, thermal, scale-dependent, uncertainty]\n");
    assert_int_equal(less.convergence, 0);
    assert_int_equal(less.all, all.all - all.convergence);

    less = work_of(FILES "effects: [plasticity, separation, electrical, thermal, scale-dependent, convergence]\n");
    assert_int_equal(less.uncertainty, 0);
    assert_int_equal(less.all, all.all - all.uncertainty);

    less = work_of(FILES "effects: [plasticity, separation, electrical, thermal, convergence, uncertainty]\n");
    assert_true(less.area < all.area); /* GW has closed forms for all but scale dependence */
    assert_int_equal(less.convergence, all.convergence);

    /* both share their sums over contact spots; sensitivity and landmarks speak of ECR, else of the area */
    less = work_of(FILES "effects: [plasticity, electrical, thermal]\n");
    struct work electrical = work_of(FILES "effects: [plasticity, electrical]\n");
    assert_memory_equal(&less, &electrical, sizeof less);
}

/** All families together cost the sum of each alone. */
TEST_CASE(families_remove_their_own_work)
{
    static const char *const families[] = {"multiscale", "statistical", "corrected-persson", "strip", "cmy"};
    struct text *scene = support_text();
    struct work sum = {0}, all;
    for (size_t i = 0; i <= sizeof families / sizeof *families; i++) {
        bool one = i < sizeof families / sizeof *families;
        scene->length = 0;
        text_add(scene, FILES "effects: [plasticity]\nmodels: [%s]\n",
                 one ? families[i] : "multiscale, statistical, corrected-persson, strip, cmy");
        all = work_of(text_string(scene));
        assert_true(all.all > 0);
        if (one) {
            sum.area += all.area;
            sum.plasticity += all.plasticity;
        }
    }
    assert_int_equal(all.area, sum.area);
    assert_int_equal(all.plasticity, sum.plasticity);
}

/** A metal so hard that nothing yields: `auto` skips plasticity on both surfaces; a softer one runs it. */
TEST_CASE(auto_skips_what_cannot_matter)
{
    struct work work = work_of("surfaces: [{name: a, file: a.csv}, {name: b, file: b.csv}]\n"
                               "material: {E: 1 GPa, nu: 0.3, Sy: 1000 GPa}\nload: {from: 1e-6, to: 1e-3, points: "
                               "31}\noperating_load: 1e-3\n");
    assert_true(work.area > 0);
    assert_int_equal(work.plasticity, 0);
    expect_in_file(&directory_here, "out/report.md", "plasticity (no spot bears more than ");
    assert_true(work_of(FILES "effects: auto\n").plasticity > 0);
}

/** Each surface is read once, also if the baseline is needed for the loads, and effects differ between surfaces. */
TEST_CASE(a_surface_is_described_once)
{
    described = 0;
    work_of("surfaces: [{name: hard, file: a.csv, material: {E: 1 GPa, nu: 0.3, Sy: 1000 GPa}}, {name: soft, file: "
            "b.csv}, {name: same, file: a.csv}]\nmaterial: {E: 1 GPa, nu: 0.3, Sy: 1 MPa}\nmodels: [multiscale]\n"
            "load: {from: 1e-6, to: 1e-3, points: 5}\n");
    assert_int_equal(described, 3);
}

/** A hard surface has the elastic numbers, a soft one in the same report its own. */
TEST_CASE(effects_are_a_surfaces_own)
{
    work_of("surfaces: [{name: hard, file: a.csv, material: {E: 1 GPa, nu: 0.3, Sy: 1000 GPa}}, {name: soft, file: "
            "a.csv}]\n"
            "material: {E: 1 GPa, nu: 0.3, Sy: 1 MPa}\nmodels: [multiscale]\n"
            "load: {from: 1e-6, to: 1e-3, points: 5}\n");
    struct table table = directory_table(&directory_here, "out/data/contact.csv");
    size_t same = 0, other = 0;
    for (size_t i = 0; i < table.rows; i++)
        for (size_t j = 0; j < table.rows; j++) {
            if (strcmp(table_text(&table, i, "surface"), table_text(&table, j, "surface")) != 0 ||
                strcmp(table_text(&table, i, "model"), "multiscale-elastic") != 0 ||
                strcmp(table_text(&table, j, "model"), "multiscale-plastic") != 0 ||
                strcmp(table_text(&table, i, "load_over_AnEp"), table_text(&table, j, "load_over_AnEp")) != 0)
                continue;
            bool hard = strcmp(table_text(&table, i, "surface"), "hard") == 0;
            bool equal = strcmp(table_text(&table, i, "area_ratio"), table_text(&table, j, "area_ratio")) == 0;
            assert_true(!hard || equal);
            same += hard;
            other += !hard && !equal;
        }
    assert_int_equal(same, 5);
    assert_true(other > 0);
}

/** A target is a search on every model's curve of each surface; no target is none. */
TEST_CASE(targets_are_searches)
{
    struct work none = work_of(FILES "models: [gw, jg, cmy]\neffects: [plasticity, electrical]\n");
    struct work two = work_of(FILES "models: [gw, jg, cmy]\neffects: [plasticity, electrical]\n"
                                    "targets: [{ecr: 1e-9 ohm m2}, {area: 1 %}]\n");
    assert_true(two.area > none.area && two.plasticity > none.plasticity);
}

static int set_up(void **state)
{
    directory_setup(state);
    return mkdir(directory_path(*state, "in"), 0700) |
           symlink(PROJECT_SOURCE "/surfaces/chapter6/surface-1.csv", directory_path(*state, "in/a.csv")) |
           symlink(PROJECT_SOURCE "/surfaces/chapter6/surface-4.csv", directory_path(*state, "in/b.csv"));
}

TEST_GROUP(set_up, directory_teardown)
