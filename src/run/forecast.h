/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How long a run is likely to take, stage by stage. What the scans took to be read is known by then; the rest is counts
 * times rates that are measured on the spot, with the program's own functions, in some milliseconds. A forecast never
 * goes into a report: the same input gives the same bytes. */
#ifndef RUN_FORECAST_H
#define RUN_FORECAST_H

#include "results/results.h"
#include "run/run.h"

enum forecast_stage {
    FORECAST_READ,
    FORECAST_LEVEL,
    FORECAST_SPECTRA,
    FORECAST_MODELS,
    FORECAST_CONVERGENCE,
    FORECAST_UNCERTAINTY,
    FORECAST_DIRECT,
    FORECAST_COST,
    FORECAST_TABLES,
    FORECAST_CHART_DATA,
    FORECAST_GNUPLOT,
    FORECAST_PAGE,
    FORECAST_OTHER,
    FORECAST_STAGES,
};
extern const char *const forecast_names[FORECAST_STAGES];

enum { FORECAST_MODELS_MOST = 64 };

/** Seconds on one core of what runs are made of. */
struct forecast_rates {
    double number;                      /* one number written */
    double sort;                        /* n log2 n of heights sorted and summed for a model that uses them */
    double speed;                       /* of this machine's time to that where the constants in forecast.c come from */
    double model[FORECAST_MODELS_MOST]; /* time of a model over what work_seconds() says it takes */
};

/** Measures them by `clock` (seconds): numbers, a sort, the system's printf(), and each running model on a synthetic
 * spectrum with the baseline's bodies and asperities. Takes about 10 ms. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code forecast_calibrate(struct forecast_rates *out, const struct results *results,
                                               double (*clock)(void), struct status *status);

struct forecast {
    double seconds[FORECAST_STAGES]; /* on one core, but gnuplot's: elapsed */
    double total;                    /* elapsed, with the threads of the run */
};

/** Forecasts a prepared run. */
struct forecast forecast_make(const struct results *results, const struct forecast_rates *rates,
                              const struct run_options *options);
/** What a run took, by the same stages. */
struct forecast forecast_of_times(const struct run_times *times);

/** Adds a table: stage, seconds likely, and, where `took` is not NULL, taken. */
void forecast_table(struct text *out, const struct forecast *likely, const struct forecast *took);

#endif
