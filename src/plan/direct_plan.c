/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "plan/direct_plan.h"
#include "base/costs.h"

#include "direct/direct_ensemble.h"
#include <math.h>
#include <stdio.h>

enum {
    GRID_LEAST = 64,
    GRID_USUAL = 256,
    GRID_MOST = 1024,
    FINE_MOST = 2048,
    SIDE_MOST = 400,
    LOADS = 13,
    SEEDS = 12,
    FEWER = 4
};

/** Points for the shortest wave: then the gap is within 3e-4, constriction within 0.5 %, area within 1 %. */
static const double points_a_wave = 6;

/** m0, m1 and m2 of a spectrum, low-passed as the law is if `cut`. */
static void moments(double out[3], const struct spectrum *spectrum, double lambda_s_m, bool cut)
{
    out[0] = out[1] = out[2] = 0;
    for (size_t i = 0; i < spectrum->count; i++) {
        double frequency = spectrum_frequency(spectrum, i), above = lambda_s_m * frequency;
        double power = spectrum_power(spectrum, i) * (cut && above > 1 ? exp(-2 * M_LN2 * (above * above - 1)) : 1);
        for (int k = 0; k < 3; k++, power *= 2 * M_PI * frequency)
            out[k] += power;
    }
}

/** Loads from 100 points in contact (130, as surfaces scatter) to about 0.9 of the area, from A = 2 p/(E' g), g the rms
 * gradient. */
static void range_of_loads(struct direct_plan *plan, const struct direct_plan_task *task)
{
    double points = (double)plan->grid * (double)plan->grid, known[3] = {0, 0, task->slope * task->slope};
    if (plan->coarse)
        moments(known, task->spectrum, plan->lambda_s_m, true);
    double gradient = sqrt(2 * known[2]);
    plan->range[0] = 1.3 * DIRECT_ENSEMBLE_POINTS / (2 * points) * gradient;
    plan->range[1] = 0.8 * gradient;
}

/** The loads that the scene lists for the direct solution; else evenly chosen ones of its own within the range, with
 * the operating load if that is within. */
static void choose_loads(struct direct_plan *plan, const struct direct_plan_task *task)
{
    const struct scene_direct *direct = task->direct;
    double middle = task->loads[task->operating];
    size_t first = 0, end = task->load_count, wanted = direct->loads ? direct->loads : LOADS, nearest = 0;
    plan->loads = 0;
    if (direct->values) {
        for (size_t k = 0; k < direct->loads; k++)
            plan->load[k] = direct->values[k] / task->divisor;
        plan->loads = direct->loads;
    } else {
        range_of_loads(plan, task);
        while (first < end && task->loads[first] < plan->range[0])
            first++;
        while (end > first && task->loads[end - 1] > plan->range[1])
            end--;
        wanted = wanted < end - first ? wanted : end - first;
        for (size_t k = 0; k < wanted; k++) {
            size_t steps = wanted > 1 ? wanted - 1 : 1;
            plan->load[plan->loads++] = task->loads[first + (k * (end - first - 1) + steps / 2) / steps];
        }
    }
    for (size_t k = 0; k < plan->loads; k++)
        if (fabs(log(plan->load[k] / middle)) < fabs(log(plan->load[nearest] / middle)))
            nearest = k;
    bool inside = plan->loads > 0 && plan->load[0] <= middle && middle <= plan->load[plan->loads - 1];
    if (inside && !direct->values)
        plan->load[nearest] = middle;
    plan->hardness = task->hardness;
    plan->capped_loads = 0;
    while (plan->capped_loads < plan->loads && isfinite(plan->hardness) &&
           plan->load[plan->capped_loads] < plan->hardness)
        plan->capped_loads++;
}

/** Expected time of a map on one core, whose mirror images cost nothing; the parts that give its error have a quarter
 * of its points. */
static double likely_seconds_of_map(const struct direct_plan *plan)
{
    const double parts = (plan->mirrored ? 5 : 1) + (plan->lambda_s_m > 0);
    return costs.direct_map_point_s * (double)(plan->side * plan->side) * (1 + parts / 4) *
           (double)(plan->loads + plan->capped_loads);
}

/** Expected time on one core, from counts. Surfaces with a scan's heights must be made first; the finer grid has twice
 * the points a side. */
static double likely_seconds(const struct direct_plan *plan)
{
    if (plan->side > 0)
        return likely_seconds_of_map(plan);
    const double power = costs.direct_power, one = costs.direct_s * pow((double)plan->grid / 256, power);
    double making = plan->gaussian ? 0 : direct_ensemble_making, fine = plan->fine_times > 0, sum = 0;
    for (int capped = 0; capped < 2; capped++) {
        double loads = (double)(capped ? plan->capped_loads : plan->loads);
        double surfaces = (double)(capped ? plan->fewer : plan->seeds);
        sum += loads > 0 ? loads * (surfaces + fine * pow(2, power)) + making * (surfaces + fine) : 0;
    }
    return one * sum;
}

/** Fills the plan for one choice of size, surfaces (`seeds`, of a profile) and finer grid. */
static void try(struct direct_plan *plan, const struct direct_plan_task *task, size_t size, size_t seeds, bool fine)
{
    bool map = task->map.nx > 0;
    plan->side = map ? size : 0;
    plan->mirrored = map && direct_map_mirrored(&task->map, size);
    plan->grid = (plan->mirrored ? 2 : 1) * size;
    plan->seeds = map ? 1 : seeds;
    plan->fewer = map ? 1 : seeds < FEWER ? seeds : FEWER; /* enough to know their scatter */
    plan->fine_times = fine && !map && 2 * plan->grid <= FINE_MOST ? 2 : 0;
    plan->length_m = map ? task->map.dx_m * (double)plan->grid : task->length_m;
    double resolved_m = points_a_wave * plan->length_m / (double)plan->grid;
    plan->coarse = !map && resolved_m > task->lambda_s_m * (1 + 1e-9);
    plan->lambda_s_m = map ? task->map.cutoff * task->map.dx_m : plan->coarse ? resolved_m : task->lambda_s_m;
    plan->of_spacing = task->of_spacing && !plan->coarse && !map;
    plan->gaussian = task->gaussian && !map;
    plan->resistance = task->resistance;
    choose_loads(plan, task);
    plan->seconds = likely_seconds(plan);
}

/** The grid that resolves the scan, up to a limit. */
static size_t usual_size(const struct direct_plan_task *task)
{
    size_t grid = GRID_USUAL;
    if (task->map.nx > 0)
        return task->map.periodic ? task->map.nx
                                  : fft_quick(task->map.nx < SIDE_MOST ? task->map.nx : SIDE_MOST, DIRECT_MAP_FACTOR);
    while (grid < GRID_MOST && (double)grid < points_a_wave * task->length_m / task->lambda_s_m)
        grid *= 2;
    return grid;
}

/** Takes the first choice within the budget, from the best down: fewer surfaces go before a coarser grid. */
static void choose(struct direct_plan *plan, const struct direct_plan_task *task)
{
    static const struct {
        size_t seeds;
        bool fine;
    } ways[] = {{SEEDS, true}, {8, true}, {SEEDS, false}, {8, false}, {6, false}, {4, false}, {3, false}, {2, false}};
    const struct scene_direct *direct = task->direct;
    double budget_s = direct->budget_s > 0 ? direct->budget_s : INFINITY;
    bool map = task->map.nx > 0, free_size = map || direct->grid == 0;
    size_t size = free_size ? usual_size(task) : direct->grid, least = map ? GRID_LEAST / 2 : GRID_LEAST;
    for (;; size /= 2) {
        for (size_t w = 0; w < sizeof ways / sizeof *ways; w++) {
            try(plan, task, size, direct->seeds > 0 ? direct->seeds : ways[w].seeds, ways[w].fine);
            plan->over_budget = plan->seconds > budget_s;
            if (!plan->over_budget)
                return;
        }
        if (!free_size || size / 2 < least)
            return;
    }
}

void direct_plan_give_up(struct direct_plan *plan, const char *problem)
{
    plan->possible = false;
    plan->seconds = 0;
    snprintf(plan->problem, sizeof plan->problem, "%.*s", (int)sizeof plan->problem - 1, problem);
}

const char *direct_plan_problem(const struct direct_plan *plan, struct words *words)
{
    return plan->problem[0] ? plan->problem
                            : words_say(words, "direct.no_load\nleast %.2g\nmost %.2g\ngrid %zu", plan->range[0],
                                        plan->range[1], plan->grid);
}

void direct_plan_make(struct direct_plan *out, const struct direct_plan_task *task)
{
    double known[3];
    struct status problem = {0};
    *out = (struct direct_plan){.possible = true};
    choose(out, task);
    moments(known, task->spectrum, out->lambda_s_m, out->coarse);
    if ((out->side > 0 && direct_map_check(task->height_m, &task->map, out->side, &problem) != STATUS_OK) ||
        out->loads == 0 ||
        (out->side == 0 && direct_law_match(&out->law, known, out->length_m, out->lambda_s_m, &problem) != STATUS_OK))
        direct_plan_give_up(out, problem.message);
}
