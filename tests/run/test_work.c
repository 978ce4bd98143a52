/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Only what the scene calls for: each effect switched off removes exactly its work, the plan's counts are those done,
 * and `auto` leaves out what cannot change a number. */
#include "run/prepare.h"
#include "support.h"

#include <ftw.h>
#include <stdio.h>
#include <unistd.h>

static char directory[256];

static void write_scene(const char *text)
{
    char path[300];
    struct status status = {0};
    snprintf(path, sizeof path, "%s/scene.yaml", directory);
    assert_int_equal(text_write_file(path, text, strlen(text), &status), STATUS_OK);
}

/** Predicts the scene's work; what a run then does has to be the same. */
static struct work work_of(const char *scene_text, struct plan *plan)
{
    struct scene scene;
    struct status status = {0};
    struct prepared prepared;
    struct run_outcome outcome;
    char output[300];
    snprintf(output, sizeof output, "%s/out", directory);
    struct run_options options = {
        .output = output, .templates = PROJECT_SOURCE "/templates", .jobs = 1, .no_cost = true};
    write_scene(scene_text);
    assert_int_equal(scene_read(&scene, directory, &(struct scene_overrides){0}, &status), STATUS_OK);
    assert_int_equal(prepare(&prepared, &scene, &options, NULL, &status), STATUS_OK);
    struct work work = prepared.results.predicted;
    if (plan)
        *plan = prepared.plan;
    prepared_free(&prepared);
    if (run_report(&outcome, &scene, &options, &status) != STATUS_OK)
        fail_msg("%s", status.message);
    assert_true(outcome.work_agrees);
    run_outcome_free(&outcome);
    scene_free(&scene);
    return work;
}

#define SURFACES "surfaces: [{name: a, file: a.csv}, {name: b, file: b.csv}]\n"
#define FILES    SURFACES "material: tin\nfit: thesis\nfit_band: [8 um, 2 mm]\nload: {from: 1e-6, to: 0.1, points: 31}\n"
#define ALL      "plasticity, separation, electrical, thermal, scale-dependent, convergence"

/** The two material laws, elastic and plastic, of one kind of work. */
static uint64_t gaps(const struct work *work)
{
    return work->elastic.gaps + work->plastic.gaps;
}

static uint64_t constrictions(const struct work *work)
{
    return work->elastic.constrictions + work->plastic.constrictions;
}

/** Asserts that two works differ in nothing but what the caller has already set equal. */
static void assert_same(const struct work *a, const struct work *b)
{
    assert_memory_equal(a, b, sizeof *a);
}

static void assert_none(const struct model_work *work)
{
    const struct model_work none = {0};
    assert_memory_equal(work, &none, sizeof none);
}

static void each_effect_removes_its_own_work(void **state)
{
    (void)state;
    struct work all = work_of(FILES "effects: [" ALL "]\n", NULL), less;
    assert_true(gaps(&all) > 0 && constrictions(&all) > 0 && all.sweep_scales > 0 && all.extensions == 4);

    less = work_of(FILES "effects: [plasticity, electrical, thermal, scale-dependent, convergence]\n", NULL);
    assert_int_equal(gaps(&less), 0);
    assert_int_equal(all.elastic.separations - less.elastic.separations, 2 * 31); /* two-band elastic: Barber's */
    less.elastic.separations = all.elastic.separations;
    less.elastic.gaps = all.elastic.gaps;
    less.plastic.gaps = all.plastic.gaps;
    assert_int_equal(all.elastic.searches - less.elastic.searches, 2); /* GW's beta nearest to the stack, twice */
    assert_int_equal(all.plastic.searches - less.plastic.searches, 2);
    less.elastic.searches = all.elastic.searches;
    less.plastic.searches = all.plastic.searches;
    assert_same(&less, &all);

    less = work_of(FILES "effects: [separation, electrical, thermal, scale-dependent, convergence]\n", NULL);
    assert_none(&less.plastic);
    less.plastic = all.plastic;
    assert_int_equal(less.sweep_scales * 2, all.sweep_scales);
    assert_int_equal(less.extensions * 2, all.extensions);
    less.sweep_scales = all.sweep_scales;
    less.extensions = all.extensions;
    assert_same(&less, &all);

    less = work_of(FILES "effects: [plasticity, separation, electrical, thermal, scale-dependent]\n", NULL);
    assert_int_equal(less.sweep_scales + less.extensions, 0);
    less.sweep_scales = all.sweep_scales;
    less.extensions = all.extensions;
    assert_same(&less, &all);

    less = work_of(FILES "effects: [plasticity, separation, electrical, thermal, convergence]\n", NULL);
    assert_true(all.elastic.scale_dependent_nodes > 0);
    assert_int_equal(less.elastic.nodes + less.elastic.scale_dependent_nodes, 0); /* closed forms do */
    assert_true(less.plastic.nodes > 0 && less.plastic.nodes <= all.plastic.nodes);
    less.elastic.scale_dependent_nodes = all.elastic.scale_dependent_nodes;
    less.plastic.nodes = all.plastic.nodes;
    assert_same(&less, &all);

    struct work thermal = work_of(FILES "effects: [plasticity, separation, thermal, convergence]\n", NULL);
    struct work electrical = work_of(FILES "effects: [plasticity, separation, electrical, convergence]\n", NULL);
    assert_true(constrictions(&thermal) > 0 && constrictions(&thermal) < constrictions(&electrical));
    thermal.elastic.constrictions = electrical.elastic.constrictions; /* sensitivity speaks of ECR alone */
    thermal.plastic.constrictions = electrical.plastic.constrictions;
    assert_same(&thermal, &electrical); /* the two share their sums over contact spots */
    less = work_of(FILES "effects: [plasticity, separation, convergence]\n", NULL);
    assert_int_equal(constrictions(&less), 0);
    less.elastic.constrictions = electrical.elastic.constrictions;
    less.plastic.constrictions = electrical.plastic.constrictions;
    assert_same(&less, &electrical);
}

/** What all families take is what each takes alone: visits of scales in stacks, solved loads and laws in others. */
static void families_remove_their_own_work(void **state)
{
    (void)state;
    struct work all = work_of(FILES "effects: [plasticity]\n"
                                    "models: [multiscale, statistical, two-band, persson, contacting-slopes, "
                                    "cmy, sridhar-yovanovich]\n",
                              NULL);
    struct work multiscale = work_of(FILES "effects: [plasticity]\nmodels: [multiscale]\n", NULL);
    struct work statistical = work_of(FILES "effects: [plasticity]\nmodels: [statistical]\n", NULL);
    struct work sum = multiscale;
    model_work_add(&sum.elastic, &statistical.elastic);
    model_work_add(&sum.plastic, &statistical.plastic);
    static const char *const others[] = {"two-band", "persson", "contacting-slopes", "cmy", "sridhar-yovanovich"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        char scene[200];
        snprintf(scene, sizeof scene, FILES "effects: [plasticity]\nmodels: [%s]\n", others[i]);
        struct work other = work_of(scene, NULL);
        assert_true(model_evaluations(&other.elastic) + model_evaluations(&other.plastic) > 0);
        assert_int_equal(other.elastic.nodes + other.plastic.nodes, 0);
        assert_true((other.plastic.scales > other.elastic.scales) == (i == 0)); /* once more, with a harder metal */
        assert_true(i == 0 || other.plastic.scales == 0);
        model_work_add(&sum.elastic, &other.elastic);
        model_work_add(&sum.plastic, &other.plastic);
    }
    assert_same(&sum, &all);
    const struct model_work *laws[2][2] = {{&multiscale.elastic, &statistical.elastic},
                                           {&multiscale.plastic, &statistical.plastic}};
    for (int law = 0; law < 2; law++) {
        assert_true(laws[law][0]->scales > 0 && laws[law][1]->separations > 0);
        assert_int_equal(laws[law][0]->separations + laws[law][0]->nodes + laws[law][0]->scale_dependent_nodes, 0);
        assert_int_equal(laws[law][1]->scales + laws[law][1]->gaps + laws[law][1]->constrictions, 0);
    }
}

/** A metal so hard that nothing yields: auto skips plasticity, and the models it skips would have given the same area.
 */
static void auto_skips_what_cannot_matter(void **state)
{
    (void)state;
    struct plan plan;
    struct work work = work_of(SURFACES "material: {E_Pa: 1e9, nu: 0.3, Sy_Pa: 1e12}\n"
                                        "load: {from: 1e-6, to: 1e-3, points: 31}\n",
                               &plan);
    assert_false(plan_runs(&plan, EFFECT_PLASTICITY));
    assert_none(&work.plastic);
    assert_true(work.elastic.scales > 0 && work.elastic.separations > 0);
    assert_non_null(strstr(plan.effects[EFFECT_PLASTICITY].reason, "every scale"));
    assert_false(plan_runs(&plan, EFFECT_ELECTRICAL));
    assert_non_null(strstr(plan.effects[EFFECT_ELECTRICAL].reason, "no resistivity"));

    work_of(FILES "effects: auto\n", &plan);
    assert_true(plan_runs(&plan, EFFECT_PLASTICITY) && plan_runs(&plan, EFFECT_SCALE_DEPENDENT));
}

static int set_up(void **state)
{
    (void)state;
    const char *base = getenv("TMPDIR");
    char a[300], b[300];
    snprintf(directory, sizeof directory, "%s/test-work-XXXXXX", base ? base : "/tmp");
    if (!mkdtemp(directory))
        return -1;
    snprintf(a, sizeof a, "%s/a.csv", directory);
    snprintf(b, sizeof b, "%s/b.csv", directory);
    return symlink(PROJECT_SOURCE "/surfaces/chapter6/surface-1.csv", a) |
           symlink(PROJECT_SOURCE "/surfaces/chapter6/surface-4.csv", b);
}

static int remove_entry(const char *path, const struct stat *info, int type, struct FTW *level)
{
    (void)info;
    (void)type;
    (void)level;
    return remove(path);
}

static int tear_down(void **state)
{
    (void)state;
    return nftw(directory, remove_entry, 16, FTW_DEPTH | FTW_PHYS);
}

/** A target is a search on every model's curve of each surface, and nothing else; no target is none. */
static void targets_are_searches(void **state)
{
    (void)state;
    static const char without[] = FILES "models: [gw, jg, cmy]\neffects: [plasticity, electrical]\n";
    struct work none = work_of(without, NULL), two;
    two = work_of(FILES "models: [gw, jg, cmy]\neffects: [plasticity, electrical]\n"
                        "targets: [{ecr: 1e-9 ohm m2}, {area: 1 %}]\nlimits: {area: {least: 1 %}}\n",
                  NULL);
    assert_int_equal(two.elastic.searches, none.elastic.searches + 2 * 2 * 1);
    assert_int_equal(two.plastic.searches, none.plastic.searches + 2 * 2 * 2);
    two.elastic.searches = none.elastic.searches;
    two.plastic.searches = none.plastic.searches;
    assert_same(&two, &none);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_effect_removes_its_own_work),
        cmocka_unit_test(targets_are_searches),
        cmocka_unit_test(families_remove_their_own_work),
        cmocka_unit_test(auto_skips_what_cannot_matter),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
