/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far a surface of one scan may be off: what scans of the same length at other places would answer, by records
 * simulated from its spectrum that go through levelling, spectrum and models as the scan did; and of a map's direct
 * solution, by what tells its errors. */
#ifndef CERTAINTY_UNCERTAINTY_H
#define CERTAINTY_UNCERTAINTY_H

#include "members/surface.h"

/** SINGLE_SCAN_RECORDS simulated records, and from 64 points on the scan's quarters, each alone with its own spectrum,
 * strips and heights in order, through the running models at the first, middle and last of the task's loads; of two
 * rough bodies record with record and quarter with quarter. Fills the band and the estimates of models that have run;
 * none where the scan has too few points, or no power, to simulate records of. The same scan gives the same records.
 * Errors: STATUS_INTERRUPTED; STATUS_MEMORY. */
MUST_CHECK enum status_code uncertainty_run(struct surface_record *record, const struct surface_task *asked,
                                            const struct model_task *task, struct status *status);
/** What simulating a scan of `points` takes, roughly, of one core [s]: heights drawn, levelled and transformed, and a
 * model run on every record. */
double uncertainty_seconds(size_t points);

/** The interval of a map's direct solution, model `m`, by its standard errors, and of what the joint makes of it.
 * Error: STATUS_MEMORY. */
MUST_CHECK enum status_code uncertainty_of_map(struct surface_record *record, size_t m, const struct model_task *task,
                                               const struct joint_task *joint, struct status *status);

#endif
