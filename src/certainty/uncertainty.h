/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Uncertainty of a surface known from one scan: how scans of the same length at other places would differ, from records
 * simulated from its spectrum and treated as the scan was; and of a map's direct solution, from its standard errors. */
#ifndef CERTAINTY_UNCERTAINTY_H
#define CERTAINTY_UNCERTAINTY_H

#include "members/surface.h"

/** Runs the models on SINGLE_SCAN_RECORDS simulated records and, from 64 points on, on the four quarters of the scan,
 * each with its own spectrum, strips and bearing curve, at the first, operating and last load; with two rough bodies
 * record against record and quarter against quarter. Fills bands and estimates of the models, or none if the scan has
 * too few points or no power. The same scan gives the same records. Errors: STATUS_INTERRUPTED; STATUS_MEMORY. */
MUST_CHECK enum status_code uncertainty_run(struct surface_record *record, const struct surface_task *asked,
                                            const struct model_task *task, struct status *status);
/** Approximate time of one core [s] for the records of a scan of `points`, with one model. */
double uncertainty_seconds(size_t points);

/** Intervals of a map's direct solution, model `m`, and of the joint, from its standard errors. Error: STATUS_MEMORY.
 */
MUST_CHECK enum status_code uncertainty_of_map(struct surface_record *record, size_t m, const struct model_task *task,
                                               const struct joint_task *joint, struct status *status);

#endif
