/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Forecasts: every stage is there, they add up, more work takes longer, and the rates come from the clock that is
 * given. */
#include "run/forecast.h"
#include "run/pipeline.h"
#include "run/prepare.h"
#include "support.h"

static double now, step, sort_factor = 1;
static size_t looks;

/* A clock that goes on by `step` whenever it is looked at. */
static double ticking(void)
{
    looks++;
    return now += step;
}

static int place_setup(void **state)
{
    static struct directory place;
    place = directory_make();
    mkdir(directory_path(&place, "in"), 0777);
    pipeline_rough(&place, "in/a.csv", 300, 1, 1);
    pipeline_rough(&place, "in/b.csv", 300, 2, 2);
    *state = &place;
    return 0;
}

static int place_teardown(void **state)
{
    directory_remove(*state);
    return 0;
}

static double described = 1.75; /* what reading a surface took in all */

/* Forecasts the scene with rates of a clock of `tick` seconds a look; 0: a clock that stands still. */
static struct forecast forecast_of(const struct directory *place, const char *scene_text, struct run_options options,
                                   double tick, struct forecast_rates *rates)
{
    struct scene scene;
    struct prepared prepared;
    struct status status = {0};
    char directory[4096];
    directory_write(place, "in/scene.yaml", scene_text);
    snprintf(directory, sizeof directory, "%s", directory_path(place, "in"));
    assert_int_equal(scene_read(&scene, directory, &(struct scene_overrides){0}, &status), STATUS_OK);
    assert_int_equal(prepare(&prepared, &scene, &options, NULL, &status), STATUS_OK);
    for (size_t i = 0; i < prepared.store.count; i++) /* what reading took is none of the forecast's own */
        prepared.store.summaries[i].times = (struct surface_times){0.25, 0.5, 1, 0, described};
    step = tick;
    looks = 0;
    assert_int_equal(forecast_calibrate(rates, &prepared.results, ticking, &status), STATUS_OK);
    rates->sort *= sort_factor;
    struct forecast out = forecast_make(&prepared.results, rates, &options);
    prepared_free(&prepared);
    scene_free(&scene);
    return out;
}

#define ONE  "surfaces: [{name: a, file: a.csv}]\n"
#define TWO  "surfaces: [{name: a, file: a.csv}, {name: b, file: b.csv}]\n"
#define ALL  "material: tin\neffects: [plasticity, separation, electrical, thermal, convergence]\n"
#define FEW  "load: {from: 1e-6, to: 0.1, points: 31}\n"
#define MANY "load: {from: 1e-6, to: 0.1, points: 3100}\n"
static const struct run_options one_thread = {.jobs = 1, .templates = PROJECT_SOURCE "/templates"};

static void rates_come_from_the_clock(void **state)
{
    struct forecast_rates slow, fast, still;
    struct forecast long_run = forecast_of(*state, TWO ALL FEW, one_thread, 2e-3, &slow);
    assert_in_range(looks, 100, 400);
    struct forecast short_run = forecast_of(*state, TWO ALL FEW, one_thread, 1e-3, &fast);
    assert_near(slow.number, 2 * fast.number, 1e-9);
    assert_near(slow.speed, 2 * fast.speed, 1e-9);
    assert_near(slow.sort, 2 * fast.sort, 1e-9);
    for (int s = FORECAST_CONVERGENCE; s < FORECAST_OTHER; s++)
        assert_near(long_run.seconds[s], 2 * short_run.seconds[s], 1e-9);
    assert_true(long_run.seconds[FORECAST_OTHER] > short_run.seconds[FORECAST_OTHER]); /* some of it goes with models */
    struct forecast fixed = forecast_of(*state, TWO ALL FEW, one_thread, 0, &still);   /* too coarse: as usual */
    assert_near(still.speed, 1, 1e-12);
    assert_true(fixed.seconds[FORECAST_MODELS] > 0 && fixed.seconds[FORECAST_GNUPLOT] > 0);
}

static void stages_add_up(void **state)
{
    struct forecast_rates rates;
    struct forecast likely = forecast_of(*state, TWO ALL FEW, one_thread, 1e-3, &rates);
    double sum = 0;
    for (int s = 0; s < FORECAST_STAGES; s++) {
        bool runs = s != FORECAST_UNCERTAINTY && s != FORECAST_DIRECT;
        assert_int_equal(likely.seconds[s] > 0, runs);
        assert_non_null(forecast_names[s]);
        sum += likely.seconds[s];
    }
    assert_near(likely.seconds[FORECAST_READ], 0.5, 1e-12);
    assert_near(likely.seconds[FORECAST_LEVEL], 1, 1e-12);
    assert_near(likely.seconds[FORECAST_SPECTRA], 2, 1e-12);
    assert_near(likely.total, sum, 1e-9);
    struct text table = {0};
    forecast_table(&table, &likely, &likely);
    for (int s = 0; s < FORECAST_STAGES; s++)
        assert_non_null(strstr(text_string(&table), forecast_names[s]));
    assert_non_null(strstr(table.data, "all, elapsed"));
    text_free(&table);
}

/* What describing took besides is the rest's; where parts of it ran side by side, the whole counts. */
static void describing_counts_once(void **state)
{
    struct forecast_rates rates;
    struct forecast plain = forecast_of(*state, TWO ALL FEW, one_thread, 0, &rates);
    described = 2;
    struct forecast longer = forecast_of(*state, TWO ALL FEW, one_thread, 0, &rates);
    described = 1;
    struct forecast shared = forecast_of(*state, TWO ALL FEW, one_thread, 0, &rates);
    described = 1.75;
    assert_near(longer.seconds[FORECAST_OTHER] - plain.seconds[FORECAST_OTHER], 2 * 0.25, 1e-6);
    assert_near(longer.total - plain.total, 2 * 0.25, 1e-6);
    assert_near(shared.seconds[FORECAST_OTHER], plain.seconds[FORECAST_OTHER], 1e-6);
    assert_near(plain.total - shared.total, 2 * 0.75, 1e-6);
    assert_near(shared.seconds[FORECAST_SPECTRA], 2, 1e-12);
}

static void more_work_takes_longer(void **state)
{
    struct forecast_rates rates;
    struct forecast one = forecast_of(*state, ONE ALL FEW, one_thread, 0, &rates),
                    two = forecast_of(*state, TWO ALL FEW, one_thread, 0, &rates),
                    many = forecast_of(*state, TWO ALL MANY, one_thread, 0, &rates),
                    half = forecast_of(*state, ONE ALL MANY, one_thread, 0, &rates);
    static const enum forecast_stage of_loads[] = {FORECAST_MODELS, FORECAST_COST, FORECAST_TABLES, FORECAST_CHART_DATA,
                                                   FORECAST_PAGE};
    for (size_t i = 0; i < sizeof of_loads / sizeof *of_loads; i++)
        assert_true(many.seconds[of_loads[i]] > two.seconds[of_loads[i]]);
    assert_near(two.seconds[FORECAST_MODELS], 2 * one.seconds[FORECAST_MODELS], 0.5);
    assert_true(two.seconds[FORECAST_TABLES] > one.seconds[FORECAST_TABLES] && two.total > one.total);

    double more_of_two = many.seconds[FORECAST_TABLES] - two.seconds[FORECAST_TABLES];
    assert_near(more_of_two, 2 * (half.seconds[FORECAST_TABLES] - one.seconds[FORECAST_TABLES]), 1e-9);

    struct run_options less = one_thread;
    less.no_cost = true;
    struct forecast plain = forecast_of(*state, TWO ALL FEW, less, 0, &rates);
    assert_near(plain.seconds[FORECAST_COST], 0, 0);
    assert_true(plain.seconds[FORECAST_GNUPLOT] < two.seconds[FORECAST_GNUPLOT]);
    less.brief = true;
    struct forecast brief = forecast_of(*state, TWO ALL FEW, less, 0, &rates);
    assert_true(brief.seconds[FORECAST_GNUPLOT] < 0.6 * plain.seconds[FORECAST_GNUPLOT]);
    struct run_options both = one_thread;
    both.jobs = 2;
    struct forecast shared = forecast_of(*state, TWO ALL FEW, both, 0, &rates); /* reading and models in turn */
    assert_true(shared.total < two.total);
    struct forecast area = forecast_of(*state, TWO FEW "material: tin\neffects: []\n", one_thread, 0, &rates);
    assert_near(area.seconds[FORECAST_CONVERGENCE], 0, 0);
    assert_true(area.seconds[FORECAST_MODELS] < two.seconds[FORECAST_MODELS]);
}

/* Heights that a model uses are sorted, by it and for its chart. */
static void heights_are_sorted(void **state)
{
    static const char scene[] = TWO FEW "material: tin\neffects: []\nmodels: [contacting-slopes]\n";
    struct forecast_rates rates;
    struct forecast likely = forecast_of(*state, scene, one_thread, 1e-6, &rates);
    sort_factor = 2;
    struct forecast slower = forecast_of(*state, scene, one_thread, 1e-6, &rates);
    sort_factor = 1;
    double once = rates.sort / 2 * 298 * log2(298); /* inner points of 300, far fewer than caches hold */
    assert_near(slower.seconds[FORECAST_MODELS] - likely.seconds[FORECAST_MODELS], 2 * once, 0.01);
    assert_near(slower.seconds[FORECAST_CHART_DATA] - likely.seconds[FORECAST_CHART_DATA], once, 0.01);
}

/* A forecast leaves no trace in what a run writes. */
static void the_report_does_not_tell(void **state)
{
    struct directory *place = *state;
    struct text page[2] = {{0}, {0}};
    directory_write(place, "in/scene.yaml", TWO ALL FEW);
    for (int k = 0; k < 2; k++) {
        struct run_outcome outcome;
        struct status status = {0};
        char target[4096];
        snprintf(target, sizeof target, "%s", directory_path(place, k ? "asked" : "not-asked"));
        struct run_options options = one_thread;
        options.output = target;
        options.no_cost = true;
        options.forecast = k;
        if (pipeline_try(&outcome, place, "in", options, &status) != STATUS_OK)
            fail_msg("%s", status.message);
        assert_int_equal(outcome.stages.length > 0, k);
        run_outcome_free(&outcome);
        page[k] = directory_read(place, k ? "asked/results.json" : "not-asked/results.json");
    }
    assert_string_equal(page[0].data, page[1].data);
    text_free(&page[0]);
    text_free(&page[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rates_come_from_the_clock), cmocka_unit_test(stages_add_up),
        cmocka_unit_test(describing_counts_once),    cmocka_unit_test(more_work_takes_longer),
        cmocka_unit_test(heights_are_sorted),        cmocka_unit_test(the_report_does_not_tell),
    };
    return cmocka_run_group_tests(tests, place_setup, place_teardown);
}
