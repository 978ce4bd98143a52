/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Messages on stderr about surfaces: what was passed over and refused, and warnings. */
#ifndef RUN_MESSAGES_H
#define RUN_MESSAGES_H

#include "run/all_surfaces.h"

/** Adds a line for each; returns the number of refused surfaces, and in *left_out that of refused scans of surfaces,
 * and of the counterface, that are used with their other scans. If a report has the notes too (`reported`), those that
 * differ only in numbers and quoted names become one line: that of the first surface, with the number of the others. */
size_t messages_add(struct text *messages, size_t *left_out, const struct results *results, bool reported);

#endif
