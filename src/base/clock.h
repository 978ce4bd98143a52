/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Monotonic time. */
#ifndef BASE_CLOCK_H
#define BASE_CLOCK_H

/** Seconds on a monotonic clock, from an arbitrary start. */
double clock_seconds(void);

#endif
