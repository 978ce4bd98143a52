/* Everything that a report is about: the record of every surface, and what was computed beside them. */
#ifndef RESULTS_RESULTS_H
#define RESULTS_RESULTS_H

#include "analysis/benchmark.h"
#include "analysis/measured.h"
#include "analysis/work.h"
#include "results/surface_store.h"

/** Everything that the report is about, from here on read-only. */
struct results {
    const struct scene *scene;
    const struct plan *plan;
    const double *loads; /* P/(A_n E') */
    size_t load_count;
    struct surface_store *store;
    struct work predicted, done;
    const struct surface_record *counterface;     /* described; NULL: smooth */
    const struct measured *measured;              /* NULL: none */
    const struct measured_answers *answers;       /* the models' on the baseline surface; NULL: nothing measured */
    const struct benchmark *benchmark;            /* what accuracy costs; NULL: left out */
    const struct sensitivity_curves *sensitivity; /* of the baseline surface */
    const double *convergence; /* the sweeps' area ratios, see results_sweep(); NULL when the effect is off */
    size_t *shown;             /* indices of the surfaces the charts show: all usable ones up to 8, else spread by Rq */
    size_t shown_count;
    size_t *by_roughness; /* indices of all usable surfaces, smoothest first */
    size_t usable_count;
    size_t baseline; /* index of the surface of the one-surface comparison */
};

/** Area ratios of one curve of the sweeps by a model that stacks scales: `scene->convergence.scales` values, longest
 * wavelength first. */
const double *results_sweep(const struct results *results, enum convergence_sweep sweep, size_t model, size_t value);
/** Doubles that all curves of the sweeps take together. */
size_t results_sweep_size(const struct results *results);
/** Scales worth writing and drawing, spread evenly in log wavelength: fills `index` (at most `most`), returns how many.
 */
size_t results_sweep_scales(size_t *index, size_t most, size_t scales);

/** Is any surface's number known with an interval, by several scans, a map's rows or simulated records? */
bool results_intervals(const struct results *results);

#endif
