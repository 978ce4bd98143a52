/* Results made up to order, without a run. */
#ifndef TEST_FAKE_RESULTS_H
#define TEST_FAKE_RESULTS_H

#include "report/claim.h"
#include "support.h"

enum { SURFACES = 3, SCALES = 2 };

/* Three surfaces made up to order, smoothest first, in all four models. */
struct fake {
    struct scene scene;
    struct plan plan;
    struct scene_surface names[SURFACES];
    struct surface_summary summaries[SURFACES];
    struct surface_store store;
    size_t order[SURFACES];
    struct results results;
    double sweeps[2 * CONVERGENCE_SWEEP_COUNT * CONVERGENCE_VALUES_MOST * SCALES];
    struct comparison study;
};

/* The areas of one curve of the convergence study: settled, or falling to the last. */
static inline void fake_sweep(struct fake *fake, enum convergence_sweep sweep, bool plastic, size_t value, bool settled)
{
    double *area = fake->sweeps + (results_sweep(&fake->results, sweep, plastic, value) - fake->sweeps);
    area[0] = 0.5;
    area[1] = settled ? 0.5 : 0.4;
}

static inline void make_fake(struct fake *fake)
{
    static char names[SURFACES][8] = {"one", "two", "three"};
    *fake = (struct fake){.scene = {.convergence = {.load = 1e-3, .scales = SCALES}},
                          .plan = {.running = (1u << EFFECT_COUNT) - 1}};
    fake->plan.families = SCENE_MODEL_MULTISCALE | SCENE_MODEL_STATISTICAL;
    for (size_t k = 0; k < SURFACES; k++) {
        fake->names[k].name = names[k];
        fake->order[k] = k;
        struct surface_summary *summary = &fake->summaries[k];
        summary->scene = &fake->names[k];
        summary->usable = true;
        summary->power_law.gamma = 1.6 - 0.2 * (double)k;
        summary->power_law.knee_m = NAN;
        for (int m = 0; m < MODEL_COUNT; m++)
            summary->models[m] = (struct curve_summary){.exists = true,
                                                        .full_load = 0.1,
                                                        .elbow_load = 0.05,
                                                        .beta = 6,
                                                        .area_slope = 0.95,
                                                        .gap_at_full = 0,
                                                        .sd_least = 0.001,
                                                        .sd_most = 0.01};
    }
    for (int m = 0; m < MODEL_COUNT; m++) {
        fake->study.rank[m] = (struct comparison_rank){100, 100, 40, 100, 100};
        fake->study.extremes[m][COMPARISON_AREA] =
            (struct comparison_extremes){.least = 0.1, .most = model_rows[m].plastic ? 0.2 : 0.3, .count = SURFACES};
    }
    for (int f = 0; f < 2; f++) {
        fake->study.plastic[f] = (struct comparison_plastic){100, 100, 1.1, 2, 3, 3};
        fake->study.gap[f] = (struct comparison_gap){.area = 0.5, .ecr = 0.2};
    }
    fake->study.proportional_error = 1e-15;
    fake->study.middle_load = 1e-3;
    fake->store = (struct surface_store){.summaries = fake->summaries, .count = SURFACES};
    static const double loads[] = {1e-3, 1};
    fake->results = (struct results){.scene = &fake->scene,
                                     .loads = loads,
                                     .load_count = 2,
                                     .convergence = fake->sweeps,
                                     .plan = &fake->plan,
                                     .store = &fake->store,
                                     .by_roughness = fake->order,
                                     .usable_count = SURFACES,
                                     .baseline = 1};
    for (int s = 0; s < CONVERGENCE_SWEEP_COUNT; s++)
        for (size_t v = 0; v < convergence_sweeps[s].count; v++)
            for (int plastic = 0; plastic < 2; plastic++)
                fake_sweep(fake, (enum convergence_sweep)s, plastic, v,
                           s == CONVERGENCE_ALPHA || convergence_sweeps[s].values[v] >= 1);
}

static inline void assert_verdict(const struct fake *fake, const char *claim, enum claim_verdict expected,
                                  const char *evidence)
{
    for (size_t i = 0; i < claim_count; i++)
        if (strstr(claim_rows[i].statement, claim)) {
            struct text text = {0};
            assert_int_equal(claim_rows[i].check(&text, &fake->results, &fake->study), expected);
            if (!strstr(text_string(&text), evidence))
                fail_msg("'%s' without '%s'", text_string(&text), evidence);
            assert_null(strpbrk(text_string(&text), "|\n")); /* it stands in a table's cell */
            text_free(&text);
            return;
        }
    fail_msg("no claim '%s'", claim);
}

#endif
