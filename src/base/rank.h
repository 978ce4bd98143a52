/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The order of many numbers. */
#ifndef BASE_RANK_H
#define BASE_RANK_H

#include <stddef.h>
#include <stdint.h>

/** order[k] = index of the k-th lowest of `count` finite values, equal ones by index. */
void rank_ascending(uint64_t *order, const double *value, size_t count);

#endif
