/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What accuracy costs, physically: each model's error against the direct solution over its time. */
#include "analysis/benchmark.h"

#include "analysis/direct_study.h"
#include <math.h>
#include <stdio.h>

static const enum benchmark_chart charts[DIRECT_STUDY_QUANTITIES] = {BENCHMARK_DIRECT_AREA, BENCHMARK_DIRECT_GAP,
                                                                     BENCHMARK_DIRECT_ECR};
static const char *const studies[DIRECT_STUDY_QUANTITIES] = {"direct-area", "direct-gap", "direct-ecr"};

static enum status_code add_model(struct benchmark *cost, const struct benchmark_task *task, int q, size_t m,
                                  struct status *status)
{
    const struct direct_study *study = task->direct;
    struct direct_study_distance distance =
        direct_study_distance(study, &task->surface->summary.pair, m, direct_study_quantities[q]);
    if (distance.loads == 0)
        return STATUS_OK;
    struct benchmark_row row = {.model = model_rows[m],
                                .method = model_rows[m]->label,
                                .evaluations = study->models[m].evaluations / 3,
                                .seconds = study->model_seconds[m],
                                .error = fmax(distance.most - 1, 1 - distance.least),
                                .mean = distance.mean_factor - 1,
                                .chart = charts[q]};
    const double rounding = 1e-12;
    snprintf(row.study, sizeof row.study, "%s", studies[q]);
    snprintf(row.setting, sizeof row.setting, "%zu load%s", distance.loads, distance.loads == 1 ? "" : "s");
    if (row.error < rounding && model_rows[m]->plastic && direct_study_quantities[q] == QUANTITY_AREA) {
        row.error = row.mean = 0;
        snprintf(row.note, sizeof row.note, "A/Aₙ = P/H in both");
    }
    return benchmark_add(cost, &row, status);
}

static enum status_code add_efforts(struct benchmark *cost, const struct benchmark_task *task, int q,
                                    struct status *status)
{
    const struct direct_study *study = task->direct;
    for (size_t e = 0; e < study->efforts; e++) {
        const struct direct_study_effort *effort = &study->effort[e];
        struct benchmark_row row = {.method = "direct solution",
                                    .evaluations = effort->seeds * study->plan.loads,
                                    .seconds = effort->seconds,
                                    .error = effort->largest[direct_study_quantities[q]],
                                    .mean = effort->error[direct_study_quantities[q]],
                                    .chart = charts[q]};
        snprintf(row.study, sizeof row.study, "%s", studies[q]);
        snprintf(row.setting, sizeof row.setting, "%zu^2 x %zu", effort->grid, effort->seeds);
        if (effort->scaled)
            snprintf(row.note, sizeof row.note, "not run: scaled from all %zu", study->plan.seeds);
        if (isfinite(row.error) && benchmark_add(cost, &row, status) != STATUS_OK)
            return status->code;
    }
    return STATUS_OK;
}

enum status_code benchmark_direct(struct benchmark *cost, const struct benchmark_task *task, struct status *status)
{
    for (int q = 0; q < DIRECT_STUDY_QUANTITIES && task->direct; q++) {
        if (!(task->plan->wanted & QUANTITY_BIT(direct_study_quantities[q])))
            continue;
        for (size_t m = 0; m < model_count; m++)
            if (task->direct->models[m].exists && add_model(cost, task, q, m, status) != STATUS_OK)
                return status->code;
        if (add_efforts(cost, task, q, status) != STATUS_OK)
            return status->code;
    }
    return STATUS_OK;
}
