/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One scan of a surface: what scans of the same length at other places would answer, by records simulated from its
 * spectrum that go through levelling, spectrum and models as the scan did. */
#ifndef CERTAINTY_UNCERTAINTY_H
#define CERTAINTY_UNCERTAINTY_H

#include "members/ensemble.h"
#include "members/scan_strips.h"
#include "scene/plan.h"

enum { UNCERTAINTY_LOADS = 3 /* first, middle and last: in between the deviation goes straight in ln load */ };

/** A body that has been scanned once. */
struct uncertainty_body {
    const double *height_m; /* levelled */
    size_t points;
    double spacing_m;
};

/** What is to be simulated and quartered. */
struct uncertainty_scan {
    struct uncertainty_body body[2]; /* the second: the rough counterface; points 0: it is smooth */
    struct record_conditioning how;
    const struct model_task *task; /* of the scan itself */
    const struct joint_task *joint;
    const atomic_bool *stop;
};

/** Standard errors of one model's answers, all of ln answer: of the quantities of an ensemble_band, as they are there.
 * NaN: not known. */
struct uncertainty {
    double ln_load[UNCERTAINTY_LOADS], s[QUANTITY_COUNT][UNCERTAINTY_LOADS];
    size_t loads;
};

/** Does it say anything of a model: unasked of the one that the summary speaks of, listed of all. */
bool uncertainty_holds(const struct plan *plan, size_t model);

/** SINGLE_SCAN_RECORDS simulated records, and from 64 points on the scan's quarters, each alone with its own spectrum,
 * strips and heights in order, through the running models at UNCERTAINTY_LOADS of the task's loads; of two rough bodies
 * record with record and quarter with quarter. out: model_count. The same scan gives the same records. Errors:
 * STATUS_SCAN where it has too few points, or no power, to simulate records of; STATUS_INTERRUPTED; STATUS_MEMORY. */
MUST_CHECK enum status_code uncertainty_run(struct uncertainty *out, const struct uncertainty_scan *scan,
                                            const struct plan *plan, struct status *status);
/** What simulating a scan of `points` takes, roughly, of one core [s]: heights drawn, levelled and transformed, and a
 * model run on every record. */
double uncertainty_seconds(size_t points);

/** How far another place may be off a point of the curve of a scan of rms height sigma_m: without the model's own error
 * (ensemble_settle()). */
struct estimate uncertainty_estimate(const struct uncertainty *uncertainty, const struct model_row *model,
                                     enum quantity quantity, const struct contact_point *point, double sigma_m);

#endif
