/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One scan of a surface: what scans of the same length at other places would answer, by records simulated from its
 * spectrum that go through levelling, spectrum and models as the scan did. */
#ifndef ANALYSIS_UNCERTAINTY_H
#define ANALYSIS_UNCERTAINTY_H

#include "analysis/curve_summary.h"
#include "analysis/ensemble.h"
#include "analysis/plan.h"

enum { UNCERTAINTY_LOADS = 3 /* first, middle and last: in between the deviation goes straight in ln load */ };

/** A scan to be simulated. */
struct uncertainty_scan {
    const double *height_m; /* levelled */
    size_t points;
    double spacing_m;
    struct record_conditioning how;
    const struct model_task *task; /* of the scan itself */
};

/** Deviations of one model's answers, all of ln answer: of the quantities of an ensemble_band, as they are there. NaN:
 * a record has no answer there. */
struct uncertainty {
    double ln_load[UNCERTAINTY_LOADS], s[QUANTITY_COUNT][UNCERTAINTY_LOADS];
    size_t loads;
    double longest_waves;                      /* model_task_longest_waves() of the scan */
    struct single_scan middle[QUANTITY_COUNT]; /* s NaN: not known */
};

/** Does it say anything of a model: unasked of the one that the summary speaks of, listed of all. */
bool uncertainty_holds(const struct plan *plan, size_t model);

/** SINGLE_SCAN_RECORDS simulated records through the running models at UNCERTAINTY_LOADS of the task's loads, and from
 * 64 points on their quarters, and the scan's own, at the middle load. out: model_count. The same scan, which must be
 * uncertainty_possible(), gives the same records. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code uncertainty_run(struct uncertainty *out, const struct uncertainty_scan *scan,
                                            const struct plan *plan, struct status *status);
/** Can records be simulated of this scan: is it long enough, with power in its spectrum? tapered: the multitaper
 * spectrum of these heights, as amplitudes; NULL: not known yet. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code uncertainty_possible(bool *out, const double *height_m, size_t points,
                                                 const struct spectrum *tapered, struct status *status);
/** What simulating a scan of `points` takes, roughly, of one core [s]: heights drawn, levelled and transformed, and a
 * model run on every record. */
double uncertainty_seconds(size_t points);
/** Would as many `surfaces` of one scan of `points` each take less than the ten seconds that `effects: auto` spends at
 * most? */
bool uncertainty_affordable(size_t points, size_t surfaces);

/** What follows for the answer at the middle load, and in a band: half-widths at every load of the curve of a scan of
 * rms height sigma_m. */
struct estimate uncertainty_estimate(const struct uncertainty *uncertainty, const struct model_row *model,
                                     enum quantity quantity, double value);
void uncertainty_band(struct ensemble_band *band, const struct uncertainty *uncertainty,
                      const struct model_curve *curve, const struct model_row *model, double sigma_m);

#endif
