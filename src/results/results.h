/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Everything that a report is about: the record of every surface, and what was computed beside them. */
#ifndef RESULTS_RESULTS_H
#define RESULTS_RESULTS_H

#include "answers/answers.h"
#include "answers/measured.h"
#include "base/threads.h"
#include "plan/benchmark.h"
#include "results/work.h"

struct direct_study; /* answers/direct_study.h */

/** Everything that the report is about, from here on read-only. */
struct results {
    const struct scene *scene;
    const struct plan *plan;
    const double *loads; /* P/(A_n E'): of each surface one after another where loads_apart, else of all */
    size_t load_count;
    bool loads_apart;                /* surfaces of different E' share pressures or forces */
    struct surface_record *surfaces; /* one a surface of the scene, in its order */
    size_t surface_count;
    struct work_studies studies;              /* what the studies below took */
    const struct surface_record *counterface; /* described; NULL: smooth */
    const struct measured *measured;          /* one a surface, see results_measured(); NULL: nothing measured */
    const struct measured_answers *answers;   /* the models' on each of those; NULL: the same */
    const struct benchmark *benchmark;        /* what accuracy costs; NULL: left out */
    const struct direct_study *direct;        /* the surfaces solved directly; NULL: none */
    size_t direct_count;
    struct threads threads;    /* that write what there is of each surface */
    const double *convergence; /* the sweeps' area ratios, see results_sweep(); NULL when the effect is off */
    size_t *shown;             /* indices of the surfaces the charts show: all usable ones up to 8, else the best, the
                                  worst, the baseline and others evenly between, by the criterion */
    size_t shown_count;
    size_t *by_roughness; /* indices of all usable surfaces, smoothest first */
    size_t usable_count;
    size_t baseline; /* index of the surface of the one-surface comparison */
};

/** The smoothest but one of the usable surfaces that are described; 0: there is none. */
size_t results_second_smoothest(const struct results *results);
/** Ranks the usable surfaces and chooses which the charts show and which is the baseline. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code results_rank(struct results *results, struct status *status);

/** The loads of a surface, P/(A_n E') of its own bodies; entry i of all surfaces is one pressure or force where loads
 * are given so. */
const double *results_loads(const struct results *results, size_t surface);
double results_operating_load(const struct results *results, size_t surface);
/** What was asked of a surface. */
struct surface_task results_task(const struct results *results, size_t surface);
/** The target that comes first, or where there is none and nothing is measured, the limit; NULL: neither. Those of a
 * scale with a zero of its own (degrees Celsius), on which no ratio tells, are passed over. */
const struct scene_asked *results_asked(const struct results *results, bool *is_target);
/** The first target's quantity; else what was measured; else the first limit's; else the joint's conductance where gaps
 * are filled or only heat flows; else ECR; else TCR; else the area. */
enum quantity results_asked_quantity(const struct results *results);
/** What surfaces are held against each other by: ECR where the run computes it and not heat is asked for, else TCR,
 * else the area. */
enum quantity results_criterion(const struct results *results);
/** The number of a surface in the leading model where the summary stands, less is better; INFINITY: it has none. */
double results_cost(const struct results *results, size_t surface, enum quantity criterion);
/** How far the leading model's quantity of a surface may be off, where the summary stands. */
const struct estimate *results_estimate(const struct results *results, size_t surface, enum quantity quantity);
/** The wavelength at which the power laws of all surfaces are held against each other: the middle of what their bands
 * share, or of what lies between them. NaN: no law holds. */
double results_law_wavelength_m(const struct results *results);
/** What the models need of a surface's bodies. */
const struct material_pair *results_pair(const struct results *results, size_t surface);
/** Is any surface's material known? */
bool results_has_material(const struct results *results);

/** What was measured on a surface; NULL: nothing. */
const struct measured *results_measured(const struct results *results, size_t surface);
/** The quantity of all that was measured; QUANTITY_COUNT: nothing. */
enum quantity results_measured_quantity(const struct results *results);

/** Is surface `index` to be solved directly? */
bool results_solves(const struct results *results, size_t index);
/** The direct solution of the baseline; NULL: none. */
const struct direct_study *results_direct_baseline(const struct results *results);

/** Area ratios of one curve of the sweeps by a model that stacks scales: `scene->convergence.scales` values, longest
 * wavelength first. */
const double *results_sweep(const struct results *results, enum convergence_sweep sweep, size_t model, size_t value);
/** P/(A_n E') of its sweeps: the scene's; where that says nothing, of a model that yields at most a hundredth of the
 * hardness, so that it does not touch all over before the first scale. */
double results_sweep_load(const struct results *results, size_t model);
/** Doubles that all curves of the sweeps take together. */
size_t results_sweep_size(const struct results *results);
/** Scales worth writing and drawing, spread evenly in log wavelength: fills `index` (at most `most`), returns how many.
 */
size_t results_sweep_scales(size_t *index, size_t most, size_t scales);

#endif
