#include "results/results.h"

#include <math.h>

/** Models that stack scales and run, before `model`. */
static size_t stacking_before(const struct plan *plan, size_t model)
{
    size_t before = 0;
    for (size_t m = 0; m < model; m++)
        before += plan_runs_model(plan, m) && model_rows[m]->stacks_scales;
    return before;
}

static size_t curves_before(const struct plan *plan, int sweep)
{
    size_t curves = 0;
    for (int s = 0; s < sweep; s++)
        curves += convergence_sweeps[s].count * stacking_before(plan, model_count);
    return curves;
}

const double *results_sweep(const struct results *results, enum convergence_sweep sweep, size_t model, size_t value)
{
    const struct plan *plan = results->plan;
    size_t before = curves_before(plan, (int)sweep) + value * stacking_before(plan, model_count);
    return results->convergence + (before + stacking_before(plan, model)) * results->scene->convergence.scales;
}

size_t results_sweep_size(const struct results *results)
{
    return curves_before(results->plan, CONVERGENCE_SWEEP_COUNT) * results->scene->convergence.scales;
}

size_t results_sweep_scales(size_t *index, size_t most, size_t scales)
{
    size_t count = 0, next = 0; /* the first scale not yet taken */
    for (size_t k = 0; k < most; k++) {
        double n = pow((double)scales, (double)k / (double)(most - 1));
        size_t i = (size_t)lround(n) - 1;
        if (i >= next) {
            index[count++] = i;
            next = i + 1;
        }
    }
    return count;
}

bool results_intervals(const struct results *results)
{
    for (size_t i = 0; i < results->store->count; i++) {
        const struct surface_summary *summary = &results->store->summaries[i];
        if (summary->usable && (summary->repeats.count > 0 ||
                                (summary->single_points > 0 && plan_runs(results->plan, EFFECT_UNCERTAINTY))))
            return true;
    }
    return false;
}
