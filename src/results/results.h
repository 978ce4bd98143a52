/* The files of OUT/data and results.json (contract "Output"). Every number SI, %.17g. */
#ifndef RESULTS_RESULTS_H
#define RESULTS_RESULTS_H

#include "analysis/work.h"
#include "results/surface_store.h"

struct benchmark;
struct measured;

/** Everything that the report is about, from here on read-only. */
struct results {
    const struct scene *scene;
    const struct plan *plan;
    const double *loads; /* P/(A_n E') */
    size_t load_count;
    struct surface_store *store;
    struct work predicted, done;
    const struct surface_record *counterface; /* described; NULL: smooth */
    const struct measured *measured;          /* NULL: none */
    const struct benchmark *cost;             /* what accuracy costs; NULL: left out */
    const double *convergence; /* the sweeps' area ratios, see results_sweep(); NULL when the effect is off */
    size_t *shown;             /* indices of the surfaces the charts show: all usable ones up to 8, else spread by Rq */
    size_t shown_count;
    size_t *by_roughness; /* indices of all usable surfaces, smoothest first */
    size_t usable_count;
    size_t baseline; /* index of the surface of the one-surface comparison */
};

/** Area ratios of one curve of the sweeps: `scene->convergence.scales` values, longest wavelength first. */
const double *results_sweep(const struct results *results, enum convergence_sweep sweep, bool plastic, size_t value);
/** Scales worth writing and drawing, spread evenly in log wavelength: fills `index` (at most `most`), returns how many.
 */
size_t results_sweep_scales(size_t *index, size_t most, size_t scales);

/** Writes data/surfaces.csv, spectrum.csv, contact.csv, convergence.csv below `directory` (data/ exists).
 * Columns and rows of effects that did not run are absent. Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code tables_write(const struct results *results, const char *directory, struct status *status);

/** Has any surface several scans (or a map's rows), so that there is a spread to show? */
bool results_repeated(const struct results *results);
/** Writes data/spread.csv and data/bands.csv when results_repeated(). Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code tables_write_spread(const struct results *results, const char *directory,
                                                struct status *status);

/** Writes results.json. Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code json_write(const struct results *results, const char *directory, struct status *status);

#endif
