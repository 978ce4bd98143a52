/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a run says of its surfaces on stderr: what was passed over, refused and warned of. */
#ifndef RUN_MESSAGES_H
#define RUN_MESSAGES_H

#include "run/all_surfaces.h"

/** A line each; returns how many surfaces were refused. Where notes stand in a report too (`reported`), those that
 * differ in nothing but numbers and names in quotes are one line: the first surface's, with the number of the others.
 */
size_t messages_add(struct text *messages, const struct results *results, bool reported);

/** How many scans were refused of surfaces, and of the counterface, that go on with their others. */
size_t messages_left_out(const struct all_surfaces *prepared);

#endif
